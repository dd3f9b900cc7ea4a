"""A run's certificate over the API: as data and as a page that names them, whoever is signed in."""

from __future__ import annotations

import hashlib
import io
import re

import pypdf
import pytest
from fastapi.testclient import TestClient

from core.certificate.certificate import Certificate
from core.estimation.result import Result
from server.people.roles import Role
from server.service import Service
from tests.core.export.cloud import cloud
from tests.core.export.known_result import answer
from tests.server.made_people import As
from tests.server.runs.test_result_routes import CELL, ended_run


def partly_determined() -> Result:
    """One that is not judged, so that nobody waits for the robot's model."""
    whole = answer(cloud(0), CELL)
    assert whole.estimate is not None
    return whole.model_copy(update={"estimate": whole.estimate.model_copy(update={"determined": [True] * 4 + [False] * 6})})


@pytest.fixture
def run(service: Service) -> str:
    return ended_run(service, partly_determined(), payload="gripper")


@pytest.fixture
def viewer(signed_in: As) -> TestClient:
    return signed_in(Role.viewer)


def test_the_page_names_the_data_and_both_say_who_has_accepted(run: str, signed_in: As, viewer: TestClient) -> None:
    before = viewer.get(f"/api/runs/{run}/certificate")
    assert before.status_code == 200, before.text
    assert Certificate.model_validate_json(before.content).accepted_by is None
    assert signed_in(Role.operator).post(f"/api/runs/{run}/acceptance").status_code == 200
    sent = viewer.get(f"/api/runs/{run}/certificate")
    found = Certificate.model_validate_json(sent.content)
    assert (found.run, found.cell, found.accepted_by, found.format) == (run, CELL, "account:operator", "certificate/1")
    assert found.conformity.statement.code == "requirement-not-determined"
    page = viewer.get(f"/api/runs/{run}/certificate.pdf", params={"language": "de"})
    assert page.headers["content-type"] == "application/pdf"
    text = pypdf.PdfReader(io.BytesIO(page.content)).pages[0].extract_text()
    assert hashlib.sha256(sent.content).hexdigest() in text
    assert "Angenommen von" in text and run in text
    for answered, ending in ((sent, "json"), (page, "pdf")):
        assert re.search(rf'filename="run-{run}-gripper-\d{{4}}-\d\d-\d\d-certificate.{ending}"', answered.headers["content-disposition"])


def test_values_are_judged_by_the_cell_that_the_service_has(service: Service, viewer: TestClient) -> None:
    found = viewer.get(f"/api/runs/{ended_run(service, answer(cloud(0), CELL))}/certificate").json()["conformity"]
    assert (found["conforms"], found["assumed"]) == (True, True)
    gone = viewer.get(f"/api/runs/{ended_run(service, answer(cloud(0), CELL), cell='scrapped')}/certificate").json()["conformity"]
    assert (gone["conforms"], gone["statement"]["code"]) == (None, "certificate-no-cell")


@pytest.mark.parametrize("path", ["certificate", "certificate.pdf"])
def test_there_is_none_without_a_run_without_a_result_or_for_nobody(
    path: str, run: str, service: Service, viewer: TestClient, nobody: TestClient
) -> None:
    assert viewer.get(f"/api/runs/none/{path}").status_code == 404
    refused = viewer.get(f"/api/runs/{ended_run(service, None)}/{path}")
    assert refused.status_code == 409 and "no result" in refused.json()["detail"]
    assert nobody.get(f"/api/runs/{run}/{path}").status_code == 401
