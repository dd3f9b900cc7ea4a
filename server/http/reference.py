"""The descriptions of the API as one page to read: made here, because a plant's network reaches no other address."""

from __future__ import annotations

import json
import re
from html import escape
from pathlib import Path
from typing import Any

from markupsafe import Markup

from server.http.openapi import Json, operations

FOLDER = Path(__file__).parent


def render_reference(openapi: Json, asyncapi: Json) -> str:
    """All operations, websockets and schemas, each with its fields, units and examples."""
    import jinja2  # noqa: PLC0415 - the service starts sooner without it

    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(FOLDER), autoescape=True, undefined=jinja2.ChainableUndefined, trim_blocks=True, lstrip_blocks=True
    )
    environment.filters |= {"prose": mark_code, "type": name_type, "example": show_example, "limits": list_limits}
    by_tag: dict[str, list[tuple[str, Json]]] = {}
    for endpoint, operation in operations(openapi):
        by_tag.setdefault(operation.get("tags", ["service"])[0], []).append((endpoint, operation))
    schemas = asyncapi["components"]["schemas"] | openapi["components"]["schemas"]
    return environment.get_template("reference.html").render(openapi=openapi, asyncapi=asyncapi, tags=by_tag, schemas=schemas)


def mark_code(text: str) -> Markup:
    """Prose with what stands between backticks as code."""
    return Markup(re.sub(r"`([^`]*)`", r"<code>\1</code>", escape(text or "", quote=False)))


def name_type(schema: Json) -> Markup:
    """A schema's type in short, with links to the schemas that it leads to."""
    return Markup(_name_type(schema))


def _name_type(schema: Json) -> str:
    if "$ref" in schema:
        name = escape(schema["$ref"].rpartition("/")[2])
        return f'<a href="#{name}">{name}</a>'
    if "const" in schema or "enum" in schema:
        return " | ".join(escape(json.dumps(each)) for each in schema.get("enum", [schema.get("const")]))
    several = schema.get("anyOf") or schema.get("oneOf") or schema.get("allOf")
    if several:
        return " | ".join(dict.fromkeys(_name_type(each) for each in several))
    if schema.get("type") == "array":
        items: Json = schema.get("items") or next(iter(schema.get("prefixItems", [])), {})
        return f"list of {_name_type(items)}"
    values = schema.get("additionalProperties") or next(iter(schema.get("patternProperties", {}).values()), None)
    if isinstance(values, dict):
        return f"map of {_name_type(values)}"
    return escape(str(schema.get("format") or schema.get("type", "any")))


def show_example(schema: Json) -> str:
    """The first example as JSON; empty where there is none."""
    examples = schema.get("examples") or schema.get("schema", {}).get("examples") or []
    return json.dumps(examples[0], ensure_ascii=False) if examples else ""


LIMITS = {
    "minimum": ">=", "exclusiveMinimum": ">", "maximum": "<=", "exclusiveMaximum": "<", "minLength": "length >=", "maxLength": "length <=",
    "minItems": "items >=", "maxItems": "items <=", "pattern": "pattern", "default": "default",
}  # fmt: skip


def list_limits(schema: Json) -> str:
    """What a value may be, beside its type."""
    parts: list[Any] = [schema, schema.get("schema", {}), *schema.get("anyOf", [])]
    told = [f"{sign} {json.dumps(part[key])}" for part in parts for key, sign in LIMITS.items() if part.get(key) is not None]
    return ", ".join(dict.fromkeys(told))
