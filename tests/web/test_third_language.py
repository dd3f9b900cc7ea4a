"""A third language is a file: what is added beside the English files is found, checked, and said by terminal, report and console."""

from __future__ import annotations

import mimetypes
import os
import subprocess
import sys
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Route, expect

from tests.server.real_service import ROOT, RealService
from tests.web.third_language import CODE, MARK, OWN_NAME, copy_with_language

REPORT = """
from pathlib import Path
from dataclasses import replace
from pydantic import TypeAdapter
from core.report.page import write_report
from core.words.catalogue import LANGUAGES
from server.http.parameters import LanguageQuery
from tests.core.report.test_page import case
recording, identification, run = case()
write_report(Path("page.html"), recording=recording, identification=identification, run=run, language="eo")
print(LANGUAGES, TypeAdapter(LanguageQuery).validate_python("eo"), TypeAdapter(LanguageQuery).validate_python("xx"))
"""


@pytest.fixture(scope="module")
def copy(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return copy_with_language(tmp_path_factory.mktemp("copy"))


def words(copy: Path, *command: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(["node", *command], cwd=copy / "web", capture_output=True, text=True, check=False, timeout=300)


def python(copy: Path, *arguments: str, **environment: str) -> subprocess.CompletedProcess[str]:
    """With the engine of the copy."""
    return subprocess.run(
        [sys.executable, *arguments], cwd=copy, capture_output=True, text=True, check=False, timeout=300,
        env={**os.environ, "PYTHONPATH": f"{copy}:{ROOT}", "PYTHONUTF8": "1", "COLUMNS": "200", **environment},
    )  # fmt: skip


def test_a_whole_language_passes_the_check_and_one_that_lacks_something_is_refused_with_the_list(copy: Path) -> None:
    whole = words(copy, "words.mjs", "check")
    assert (whole.returncode, whole.stderr) == (0, "")
    taken = {
        copy / "core" / "words" / CODE / "zone.ftl": "zone-exists",
        copy / "web" / "src" / "words" / f"{CODE}-charts.ts": "  whole:",
    }
    before = {file: file.read_text(encoding="utf-8") for file in taken}
    history = copy / "web" / "src" / "words" / f"{CODE}-help.ts"
    try:
        for file, beginning in taken.items():
            lines = before[file].splitlines(keepends=True)
            file.write_text("".join(line for line in lines if not line.startswith(beginning)), encoding="utf-8")
        history.rename(history.with_suffix(".away"))
        refused = words(copy, "words.mjs", "check")
    finally:
        history.with_suffix(".away").rename(history)
        for file, text in before.items():
            file.write_text(text, encoding="utf-8")
    assert refused.returncode == 1
    assert {
        f"core/words/{CODE} lacks zone-exists",
        f"web/src/words/{CODE}-charts.ts lacks charts.whole",
        f"web/src/words lacks {CODE}-help.ts",
    } <= {*refused.stderr.splitlines()}


@pytest.mark.thorough
def test_terminal_and_report_speak_it(copy: Path) -> None:
    listed = python(copy, "-m", "core.cli", "cells", HEFT_LANGUAGE=CODE)
    assert MARK in listed.stdout, listed.stderr
    assert MARK not in python(copy, "-m", "core.cli", "cells", HEFT_LANGUAGE="en").stdout
    assert CODE in python(copy, "-m", "core.cli", "--help").stdout
    written = python(copy, "-c", REPORT)
    assert written.stdout.split("\n")[0] == "('en', 'de', 'eo') eo en", written.stderr
    page = (copy / "page.html").read_text(encoding="utf-8")
    assert f'<html lang="{CODE}">' in page
    assert page.count(MARK) > 50
    assert "2,78" in page, "decimals as the language writes them"


def test_the_console_offers_it_under_its_own_name_and_speaks_it_where_the_device_does(
    copy: Path, service: RealService, browser: Browser
) -> None:
    built = words(copy, "node_modules/vite/bin/vite.js", "build", "--logLevel", "error")
    assert built.returncode == 0, built.stderr

    def serve(route: Route) -> None:
        path = route.request.url.partition(service.address)[2].partition("?")[0].strip("/") or "index.html"
        file = copy / "web" / "dist" / path
        if file.is_file():
            route.fulfill(body=file.read_bytes(), content_type=mimetypes.guess_type(path)[0] or "text/plain")
        else:
            route.continue_()

    with browser.new_context(locale=CODE) as context:
        page = context.new_page()
        page.route("**/*", serve)
        page.goto(f"http://{service.address}/")
        expect(page.locator("h1")).to_have_text(f"Sign in{MARK}")
        assert page.evaluate("document.documentElement.lang") == CODE
        page.locator("input[name=username]").fill("operator")
        page.locator("input[name=password]").fill(service.password)
        page.locator("button[type=submit]").click()
        page.wait_for_selector(".setup .cell-facts")
        page.goto(f"http://{service.address}/#/settings")
        expect(page.get_by_role("radio", name=OWN_NAME)).to_be_checked()
        expect(page.get_by_role("radio", name="Deutsch")).to_have_count(1)
