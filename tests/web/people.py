"""More people than the first operator: another operator with a tablet of their own, and the plant's job system."""

from __future__ import annotations

from typing import Any

import httpx2 as httpx

from tests.server.real_service import QUICK, Console

BEN, PASSWORD = "ben", "correct horse battery"


def add_operator(admin: Console, name: str = BEN) -> None:
    """An account of theirs, made once."""
    answer = admin.http.post("/api/accounts", json={"name": name, "password": PASSWORD, "roles": ["operator"]})
    assert answer.status_code in (201, 409), answer.text


class JobSystem:
    """The plant's: queues orders with a key of its own."""

    def __init__(self, admin: Console, name: str) -> None:
        answer = admin.http.post("/api/keys", json={"name": name, "role": "mes"})
        assert answer.status_code == 201, answer.text
        headers = {"Authorization": f"Bearer {answer.json()['key']}"}
        self.name, self.http = name, httpx.Client(base_url=str(admin.http.base_url), headers=headers, timeout=30)

    def leave(self) -> None:
        """Closes its line."""
        self.http.close()

    def order(self, **order: Any) -> str:
        """The run that it makes."""
        answer = self.http.post("/api/runs", json={"cell": "lwr4_bench", "payload": "steel_block", **QUICK, **order})
        assert answer.status_code == 202, answer.text
        return str(answer.json()["run"])
