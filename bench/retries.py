"""Runs queued over a line that loses answers: each request is repeated until it is answered, and makes one run all the same.

`python -m bench.retries --count 1000`.
"""

from __future__ import annotations

import argparse
import tempfile
from pathlib import Path

import httpx2
import numpy as np

from tests.server.real_service import Console, real_service

PATIENCE_S = (0.002, 0.03)
"""Shortest and longest time after which an answer counts as lost; a usual one takes some 10 ms."""


def queued(console: Console, key: str, rng: np.random.Generator) -> tuple[str, int]:
    """The run of one key, and how often it had to be asked for."""
    order = {"cell": console.cell, "payload": "steel_block"}
    tries, patience_s = 0, 0.0
    while True:
        tries += 1
        patience_s = float(rng.uniform(*PATIENCE_S)) * (1.0 + tries / 10)
        try:
            answer = console.http.post("/api/runs", json=order, headers={"Idempotency-Key": key}, timeout=patience_s)
        except httpx2.TimeoutException:
            continue
        if answer.status_code == 202:
            return str(answer.json()["run"]), tries


def all_runs(console: Console) -> list[str]:
    """Every run of the service, page by page."""
    found: list[str] = []
    wanted: dict[str, str] = {"limit": "500"}
    while page := console.http.get("/api/runs", params=wanted).json():
        found += [each["run"] for each in page]
        wanted["before"] = found[-1]
    return found


def main() -> None:
    """Prints how many requests were sent and what came of them."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=1000)
    count = parser.parse_args().count
    rng = np.random.default_rng(0)
    with tempfile.TemporaryDirectory() as folder, real_service(Path(folder)) as service:
        console = Console(service)
        answered = [queued(console, f"order-{k}", rng) for k in range(count)]
        made = all_runs(console)
        console.leave()
    tries = sum(tried for _, tried in answered)
    told = {run for run, _ in answered}
    print(f"{count} keys in {tries} requests, {tries - count} of them repeated: {len(made)} runs, {len(told)} of them told")
    print(f"one run each: {len(made) == len(told) == count and set(made) == told}")


if __name__ == "__main__":
    main()
