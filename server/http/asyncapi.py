"""The AsyncAPI 3 description: what the websockets say and hear, made of the same models that they send and read."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from fastapi import FastAPI
from pydantic import BaseModel
from pydantic.json_schema import models_json_schema

from server.http.openapi import SECURITY, Authority, Json

REF = "#/components/schemas/"
MESSAGE = "#/components/messages/"
BINDING = "0.1.0"


@dataclass(frozen=True)
class SocketDescription:
    """A websocket.

    Args:
        address: as its route has it, `/api/runs/{run}/live`.
        summary: what it is for, and how it ends.
        sends, receives: the models of the messages that the service sends and reads.
        parameters: meaning and example of what stands in braces.
        query: JSON schemas of what may stand behind the question mark.
    """

    address: str
    summary: str
    sends: tuple[type[BaseModel], ...]
    receives: tuple[type[BaseModel], ...] = ()
    parameters: Mapping[str, tuple[str, str]] | None = None
    query: Mapping[str, Json] | None = None

    @property
    def name(self) -> str:
        """In camel case, `runsLive`."""
        words = [word for word in self.address.removeprefix("/api/").split("/") if not word.startswith("{")]
        return words[0] + "".join(word.title() for word in words[1:])

    @property
    def endpoint(self) -> str:
        """As the table of authority names it."""
        return f"WS {self.address}"


def describe_sockets(app: FastAPI, authority: Authority, sockets: Sequence[SocketDescription]) -> Json:
    """The description of all websockets that are for others than the console's own viewer.

    Args:
        authority: who may open what, see `server.people.authority`.
    """
    models = list(dict.fromkeys(model for socket in sockets for model in (*socket.sends, *socket.receives)))
    _, schemas = models_json_schema([(model, "serialization") for model in models], ref_template=f"{REF}{{model}}")
    return {
        "asyncapi": "3.0.0",
        "info": {"title": app.title, "version": app.version, "description": app.description},
        "defaultContentType": "application/json",
        "channels": {socket.name: _describe_channel(socket) for socket in sockets},
        "operations": {name: each for socket in sockets for name, each in _describe_operations(socket, authority)},
        "components": {
            "messages": {model.__name__: _describe_message(model) for model in models},
            "schemas": {name: _name_discriminators(schema) for name, schema in schemas["$defs"].items()},
            "securitySchemes": SECURITY_SCHEMES,
        },
    }


SECURITY_SCHEMES: Json = {
    "browser": {"type": "httpApiKey", "in": "cookie", "name": SECURITY["browser"]["name"], "description": "From POST /api/session."},
    "machine": {"type": "http", "scheme": "bearer", "description": SECURITY["machine"]["description"]},
}


def _describe_channel(socket: SocketDescription) -> Json:
    query = {"type": "object", "properties": dict(socket.query or {})}
    found: Json = {
        "address": socket.address,
        "description": socket.summary,
        "messages": {model.__name__: {"$ref": f"{MESSAGE}{model.__name__}"} for model in (*socket.sends, *socket.receives)},
        "bindings": {"ws": {"method": "GET", "bindingVersion": BINDING, **({"query": query} if socket.query else {})}},
    }
    if socket.parameters:
        found["parameters"] = {name: {"description": words, "examples": [example]} for name, (words, example) in socket.parameters.items()}
    return found


def _describe_operations(socket: SocketDescription, authority: Authority) -> list[tuple[str, Json]]:
    allowed = authority.get(socket.endpoint, frozenset())
    common: Json = {"channel": {"$ref": f"#/channels/{socket.name}"}, "x-roles": ["anybody"] if allowed is None else sorted(allowed)}
    if allowed is not None:
        common["security"] = [{"$ref": f"#/components/securitySchemes/{name}"} for name in SECURITY_SCHEMES]
    ways = (("send", socket.sends), ("receive", socket.receives))
    return [
        (
            f"{action}{socket.name[0].upper()}{socket.name[1:]}",
            {"action": action, **common, "messages": [{"$ref": f"#/channels/{socket.name}/messages/{model.__name__}"} for model in models]},
        )
        for action, models in ways
        if models
    ]


def _name_discriminators(schema: Any) -> Any:
    """As AsyncAPI has them: the name of the property alone, where OpenAPI has a mapping as well."""
    if isinstance(schema, dict):
        return {
            key: value["propertyName"] if key == "discriminator" and isinstance(value, dict) else _name_discriminators(value)
            for key, value in schema.items()
        }
    return [_name_discriminators(each) for each in schema] if isinstance(schema, list) else schema


def _describe_message(model: type[BaseModel]) -> Json:
    words = (model.__doc__ or "").strip().partition("\n")[0]
    return {"name": model.__name__, "summary": words, "payload": {"$ref": f"{REF}{model.__name__}"}}
