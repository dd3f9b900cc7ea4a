"""The websockets are described by AsyncAPI 3, from the models that they send and read, and the page shows both descriptions.

`asyncapi_schema` is that of the standard (@asyncapi/specs 6.11.1, Apache-2.0), without its examples.
"""

from __future__ import annotations

import copy
import gzip
import json
import re
from pathlib import Path
from typing import Any

import jsonschema_rs
import pytest
from fastapi import FastAPI
from fastapi.testclient import TestClient

from server.http.asyncapi import SocketDescription
from server.people.authority import AUTHORITY
from server.people.roles import Role
from server.runs.lease_routes import Stamp
from tests.server.made_people import As

Json = dict[str, Any]

SCHEMA = json.loads(gzip.decompress((Path(__file__).parent / "asyncapi_schema" / "3.0.0.json.gz").read_bytes()))


@pytest.fixture(scope="module")
def description(described_app: FastAPI) -> Json:
    found: Json = described_app.state.asyncapi()
    return found


def test_it_fits_the_schema_of_the_standard(description: Json) -> None:
    standard = jsonschema_rs.Draft7Validator(SCHEMA)
    assert [error.message for error in standard.iter_errors(description)] == []
    for spoil in (
        lambda d: d.pop("channels") and d.update(asyncapi="2.6.0"),
        lambda d: d["operations"]["sendNowLive"].update(action="shout"),
    ):
        broken = copy.deepcopy(description)
        spoil(broken)
        assert not standard.is_valid(broken)


def test_every_websocket_but_the_viewers_own_is_described(description: Json) -> None:
    addresses = {channel["address"] for channel in description["channels"].values()}
    viewers = {"WS /viewer/{cell}", "WS /viewer/{cell}/{view}"}
    assert {f"WS {address}" for address in addresses} == {name for name in AUTHORITY if name.startswith("WS ")} - viewers


def test_every_reference_leads_somewhere(description: Json) -> None:
    references = set(re.findall(r"'\$ref': '#/([^']+)'", str(description)))
    assert len(references) > 20
    for reference in references:
        found: Any = description
        for part in reference.split("/"):
            found = found[part]


def test_operations_say_who_may_open_them_and_which_way_messages_go(description: Json) -> None:
    lease = {name: each["x-roles"] for name, each in description["operations"].items() if "Lease" in name}
    assert lease == {"sendControlLease": ["operator"], "receiveControlLease": ["operator"]}
    assert description["operations"]["sendNowLive"]["x-roles"] == ["anybody"]
    [heard] = description["operations"]["receiveControlLease"]["messages"]
    assert heard["$ref"].endswith("/StampReply")


def test_every_field_of_a_message_is_described(description: Json) -> None:
    schemas = description["components"]["schemas"]
    lacking = [
        f"{name}.{field}"
        for name, schema in schemas.items()
        for field, each in schema.get("properties", {}).items()
        if "description" not in each
    ]
    assert lacking == []
    assert {"RunPublic", "ControlPublic", "LiveBatch", "EventMessage", "StampReply"} <= set(schemas)


def test_what_a_socket_sends_fits_its_schema(description: Json, nobody: TestClient) -> None:
    with nobody.websocket_connect("/api/now/live") as socket:
        said = socket.receive_json()
    components = {"components": {"schemas": description["components"]["schemas"]}}
    assert jsonschema_rs.Draft202012Validator({"$ref": "#/components/schemas/RobotsNow", **components}).is_valid(said)
    assert not jsonschema_rs.Draft202012Validator({"$ref": "#/components/schemas/CellLive", **components}).is_valid(said)


def test_a_channel_is_named_after_its_address() -> None:
    assert SocketDescription("/api/runs/{run}/live", "", sends=(Stamp,)).name == "runsLive"


@pytest.mark.parametrize("address", ["/openapi.json", "/asyncapi.json", "/docs"])
def test_descriptions_are_for_whoever_is_signed_in(address: str, nobody: TestClient, signed_in: As) -> None:
    refused = nobody.get(address)
    assert (refused.status_code, refused.json()["kind"]) == (401, "not-signed-in")
    assert signed_in(Role.mes).get(address).status_code == 200


def test_the_page_shows_every_operation_socket_and_schema_and_loads_nothing(signed_in: As, app: FastAPI) -> None:
    answer = signed_in(Role.mes).get("/docs")
    assert "default-src 'none'" in answer.headers["content-security-policy"]
    page = answer.text
    for path in app.openapi()["paths"]:
        assert path in page
    for channel in app.state.asyncapi()["channels"].values():
        assert channel["address"] in page
    links = set(re.findall(r'href="#([^"]+)"', page))
    assert links <= set(re.findall(r'id="([^"]+)"', page))
    assert re.findall(r'(?:src|href)="(?:https?:)?//', page) == []
