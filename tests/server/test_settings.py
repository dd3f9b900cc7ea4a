"""Every setting is an environment variable, stands in the guide, and is checked before anything starts."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from core.errors import BadInput
from server.serve import read_settings
from server.settings import Settings

GUIDE = Path(__file__).parents[2] / "docs" / "service.md"
ROW = re.compile(r"^\| `HEFT_([A-Z_]+)` \| (?:`([^`]*)`)? *\| (.+) \|$", re.MULTILINE)


@pytest.fixture(autouse=True)
def _no_environment(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.chdir(tmp_path)
    for name in Settings.model_fields:
        monkeypatch.delenv(f"HEFT_{name.upper()}", raising=False)


def _shown(value: object) -> str:
    return "" if value is None or value == () else str(value).lower() if isinstance(value, bool) else str(value)


def test_the_guide_lists_every_setting_with_its_default_and_meaning() -> None:
    told = {name.lower(): (default, meaning) for name, default, meaning in ROW.findall(GUIDE.read_text(encoding="utf-8"))}
    assert told == {name: (_shown(field.default), field.description) for name, field in Settings.model_fields.items()}


def test_options_go_before_the_environment_and_that_before_defaults(monkeypatch: pytest.MonkeyPatch) -> None:
    assert read_settings().port == 8000
    monkeypatch.setenv("HEFT_PORT", "9000")
    assert read_settings(port=None).port == 9000
    assert read_settings(port=9100).port == 9100


@pytest.mark.parametrize(
    ("name", "value"), [("PORT", "70000"), ("SESSION_HOURS", "0"), ("LOG_LEVEL", "loud"), ("SECURE_COOKIES", "perhaps")]
)
def test_a_setting_that_cannot_be_used_is_named(name: str, value: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(f"HEFT_{name}", value)
    with pytest.raises(BadInput, match=f"HEFT_{name}"):
        read_settings()


def test_lists_are_written_with_commas(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("HEFT_ORIGINS", "https://a.plant, https://b.plant")
    assert read_settings().origins == ("https://a.plant", "https://b.plant")


@pytest.mark.parametrize("scheme", ["postgresql", "postgres"])
def test_a_plain_postgresql_address_is_enough(scheme: str) -> None:
    assert Settings(database_url=f"{scheme}://heft@db/heft").store_url == "postgresql+pg8000://heft@db/heft"


def test_cells_are_in_the_data_folder_unless_set() -> None:
    assert Settings(data=Path("d")).cells_folder == Path("d/cells")
    assert Settings(data=Path("d"), cells=Path("c")).cells_folder == Path("c")
