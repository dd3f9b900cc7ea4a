"""What cannot be used, as answers tell it, and on its way from the processes that look."""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from typing import Any

from pydantic import BaseModel, Field, TypeAdapter

from core import errors
from core.errors import BadInput
from core.files.schema_flaw import schema_flaw
from core.words.message import Message

MESSAGES = TypeAdapter(list[Message])
SECRET = "password"
REFUSED = "refused"
"""In the answer of another process: the kind of the error that it refused with."""


class Flaw(BaseModel):
    """One thing that cannot be used: in the request, or in a cell."""

    where: str = Field(description="The file, with the key in it; or the part of the request.", examples=["cell.toml: zones"])
    found: str = Field(description="What was found, in English.", examples=["operator contains the robot's base"])
    expected: str = Field(description="What was expected, in English.", examples=["a zone beside the robot"])
    code: str = Field(description="The same for every language; `GET /problems/{code}` describes it.", examples=["cell-base-inside"])
    parameters: dict[str, Any] = Field(
        default_factory=dict,
        description="What the code's words name: numbers in SI with the unit in their name.",
        examples=[{"zone": "operator"}],
    )


def list_flaws(errors: Iterable[BadInput]) -> list[Flaw]:
    """What is wrong, as an answer tells it."""
    return [flaw_of(each.message) for each in errors]


def list_request_messages(found: Sequence[Any]) -> list[Message]:
    """What pydantic finds wrong with a request; secrets are not repeated."""
    return [_request_message(each) for each in found]


def dump_flaws(error: BadInput | None, most: int | None = None) -> str:
    """An error and its others as JSON, for another process; in codes alone, since whoever looks at cells words nothing."""
    flaws = [] if error is None else [each.message for each in (error, *error.others)]
    return MESSAGES.dump_json(flaws[:most], exclude={"__all__": {"text"}}).decode()


def dump_refusal(error: BadInput, most: int | None = None) -> str:
    """The same with the error's kind, for a process that may refuse in several kinds."""
    return json.dumps({REFUSED: type(error).__name__, "flaws": dump_flaws(error, most)})


def raise_refused(answer: dict[str, Any]) -> None:
    """Raises what `dump_refusal` has made of an error; nothing happens where the answer is another one."""
    if REFUSED in answer:
        kind: type[BadInput] = getattr(errors, answer[REFUSED])
        raise errors.together(load_flaws(kind, answer["flaws"]))


def load_flaws(kind: type[BadInput], text: str) -> list[BadInput]:
    """What another process has dumped, as errors of one kind."""
    return [restore_flaw(kind, message) for message in MESSAGES.validate_json(text)]


def restore_flaw(kind: type[BadInput], message: Message) -> BadInput:
    """The error whose message this was."""
    parameters = dict(message.parameters)
    return kind(parameters.pop("where"), message.code, **parameters)


def flaw_of(message: Message) -> Flaw:
    """A flaw's message as an answer tells it."""
    return Flaw(
        where=str(message.parameters["where"]),
        found=message.say_part("found"),
        expected=message.say_part("expected"),
        code=message.code,
        parameters=message.model_dump(mode="json", include={"parameters"})["parameters"],
    )


def _request_message(error: Any) -> Message:
    flaw = schema_flaw(error)
    shown = flaw.hide() if SECRET in flaw.key else flaw
    return Message.of(shown.code, where=shown.key, **shown.parameters)
