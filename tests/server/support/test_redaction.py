"""Whatever opens a door is taken out of a text; what an engineer needs stays."""

from __future__ import annotations

import json
import secrets

import pytest
from hypothesis import given
from hypothesis import strategies as st

from server.people import accounts
from server.support.redaction import GONE, redact


@pytest.mark.parametrize(
    ("text", "left"),
    [
        ("at https://hooks.plant/services/T0/B0/x9 again", f"at https://hooks.plant/{GONE} again"),
        ("https://anna:secret@plant:8443/", f"https://plant:8443/{GONE}"),
        ('"postgresql+pg8000://heft:secret@db/heft"', f'"postgresql+pg8000://db/{GONE}"'),
        ("https://console.plant", "https://console.plant"),
        ("http://plant?token=secret", f"http://plant/{GONE}"),
        ("Authorization: Bearer abc.def", f"Authorization: {GONE}"),
    ],
)
def test_of_addresses_scheme_and_host_are_left(text: str, left: str) -> None:
    assert redact(text, []) == left


@given(st.text(min_size=1, max_size=40).filter(lambda each: each.strip() and each not in GONE), st.text(max_size=20), st.text(max_size=20))
def test_a_known_secret_is_nowhere_left_as_json_writes_it(secret: str, before: str, after: str) -> None:
    written = json.dumps(secret)[1:-1]
    assert written not in redact(f"{before}{written}{after}", [written]).replace(GONE, "")


@pytest.mark.parametrize("size", [24, 32])
def test_what_the_service_draws_is_known_by_its_form(size: int) -> None:
    for _ in range(50):
        drawn = secrets.token_urlsafe(size)
        assert drawn not in redact(f'{{"token": "{drawn}", "bearer": "Bearer heft_{drawn}"}}', [])


def test_a_hash_of_a_password_goes() -> None:
    made = accounts.hasher.hash("correct horse battery")
    assert redact(json.dumps({"password_hash": made, "n": 1}), []) == json.dumps({"password_hash": GONE, "n": 1})


def test_digests_codes_and_figures_stay() -> None:
    text = f'heft_requests_total{{route="/api/cells/{{cell}}"}} 1.0 {"0f" * 32} runs-control-process-not-started 2026-03-01T08:00:00+00:00'
    assert redact(text, []) == text
