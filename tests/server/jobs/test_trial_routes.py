"""Blind trials over the API: sealed before they begin, opened when all are done."""

from __future__ import annotations

import json
import time
from hashlib import sha256

import pytest

from core.trial.draw import draw
from core.trial.outcome import make_stopped_outcome
from core.words.message import Message
from server.people.roles import Role
from server.runner.trial_schemas import TrialsResult
from server.runner.trialling import _open_trials
from tests.server.made_people import As


@pytest.mark.thorough
def test_seals_are_told_and_written_down_before_the_answers_and_trials_can_be_cancelled(signed_in: As) -> None:
    client = signed_in(Role.engineer)
    answer = client.post("/api/trials", json={"count": 1, "seed": 7})
    assert answer.status_code == 202, answer.text
    place = answer.headers["location"]
    for _ in range(900):
        found = client.get(place).json()
        if found["seals"] or found["state"] == "failed":
            break
        time.sleep(0.1)
    assert found["state"] == "running", found
    assert [seal["seed"] for seal in found["seals"]] == [7]
    assert (found["opened"], found["sheet"]) == (None, None)
    said = next(entry for entry in signed_in(Role.admin).get("/api/audit").json() if entry["action"] == "trials.seal")
    told = json.dumps(found["seals"], separators=(",", ":"))
    assert said["detail"]["sha256"] == sha256(told.encode()).hexdigest()
    assert client.delete(place).json()["state"] == "cancelled"
    assert client.delete(place).status_code == 409
    assert client.get("/api/trials").json()[0]["state"] == "cancelled"
    assert found["seals"][0]["sha256"] == draw(7).sealed.hash


def test_what_is_opened_is_what_was_sealed() -> None:
    sealed = draw(7).sealed
    result = TrialsResult.model_validate_json(
        _open_trials([make_stopped_outcome(sealed, Message.of("text", text="the guard stopped the robot"))])
    )
    assert sha256(result.opened[0].sealed.encode()).hexdigest() == sealed.hash
    assert result.opened[0].planted == sealed.in_words
    assert result.sheet.startswith("# Blind trials")
    assert result.sheets["en"] == result.sheet
    assert result.sheets["de"].startswith("# Blindversuche")
