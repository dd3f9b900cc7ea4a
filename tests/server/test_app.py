"""The service starts on an empty folder and lets people in."""

from __future__ import annotations

from fastapi.testclient import TestClient

from server.people.roles import Role
from tests.server.made_people import PASSWORD, As


def test_an_empty_folder_is_enough_to_start(nobody: TestClient) -> None:
    assert nobody.get("/health").json() == {"status": "ok", "version": "0.1.0", "safety_rated": False}


def test_somebody_signs_in_asks_and_signs_out(nobody: TestClient, signed_in: As) -> None:
    signed_in(Role.viewer)
    answer = nobody.post("/api/session", json={"name": "viewer", "password": PASSWORD})
    assert answer.status_code == 200, answer.text
    csrf = answer.json()["csrf_token"]
    assert nobody.get("/api/session").json() == {"name": "viewer", "roles": ["viewer"], "csrf_token": csrf}
    assert nobody.delete("/api/session").status_code == 403
    assert nobody.delete("/api/session", headers={"X-CSRF-Token": csrf}).status_code == 204
    assert nobody.get("/api/session").status_code == 401
