"""The service serves the console that was built, with headers that let it do nothing else; without one it says how to build it."""

from __future__ import annotations

from pathlib import Path

import pytest
from fastapi.testclient import TestClient

from server.http.console import Console
from server.service import Service


@pytest.fixture
def built(service: Service, tmp_path: Path) -> Path:
    """A folder as Vite leaves it."""
    folder = tmp_path / "dist"
    (folder / "assets").mkdir(parents=True)
    (folder / "index.html").write_text('<script type="module" src="/assets/index-4f1c.js"></script>')
    (folder / "assets" / "index-4f1c.js").write_text("start()")
    (folder / "secret.txt").write_text("not an asset")
    object.__setattr__(service, "console", Console((tmp_path / "none", folder)))
    return folder


def test_the_page_is_asked_for_anew_and_its_files_are_kept_for_good(built: Path, nobody: TestClient) -> None:
    page = nobody.get("/")
    assert page.status_code == 200
    assert page.headers["content-type"].startswith("text/html")
    assert page.headers["cache-control"] == "no-cache"
    script = nobody.get("/assets/index-4f1c.js")
    assert script.text == "start()"
    assert "javascript" in script.headers["content-type"]
    assert "immutable" in script.headers["cache-control"]


def test_the_page_may_only_use_what_is_ours_and_nobody_may_frame_it(built: Path, nobody: TestClient) -> None:
    policy = nobody.get("/").headers["content-security-policy"]
    rules = dict(rule.split(" ", 1) for rule in policy.split("; "))
    assert rules["default-src"] == "'self'"
    assert rules["frame-ancestors"] == "'none'"
    assert "unsafe" not in policy
    assert nobody.get("/").headers["x-frame-options"] == "DENY"


@pytest.mark.parametrize("path", ["none.js", "../secret.txt", "%2e%2e/secret.txt", "..%2fsecret.txt", "/etc/passwd", ""])
def test_nothing_but_the_files_of_the_page_is_sent(path: str, built: Path, nobody: TestClient) -> None:
    answer = nobody.get(f"/assets/{path}")
    assert answer.status_code == 404
    assert answer.headers["content-type"] == "application/problem+json"


def test_a_link_that_leads_outside_is_not_followed(built: Path, nobody: TestClient) -> None:
    (built / "assets" / "link.txt").symlink_to(built / "secret.txt")
    assert nobody.get("/assets/link.txt").status_code == 404


def test_without_a_console_the_page_says_how_to_build_it(service: Service, nobody: TestClient, tmp_path: Path) -> None:
    object.__setattr__(service, "console", Console((tmp_path,)))
    answer = nobody.get("/")
    assert answer.status_code == 503
    assert "make run" in answer.text
    assert "Node 20" in answer.text
    assert nobody.get("/health").status_code == 200
