"""What Heft has to say: a code and what it names. Words are made of it where somebody reads it, in their language."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Self, TypeAlias

from pydantic import BaseModel, ConfigDict, Field, computed_field, field_serializer, field_validator, model_validator

from core.words.catalogue import Language, format_message, format_part

Parameter: TypeAlias = "bool | int | float | str | Message | Sequence[Any]"


class Message(BaseModel):
    """A code of the catalogue and what its words name."""

    model_config = ConfigDict(frozen=True)

    code: str = Field(description="Which message of the catalogue; `GET /problems/{code}` describes it.", examples=["runs-cancelled"])
    parameters: dict[str, Any] = Field(
        default_factory=dict,
        description="What its words name: numbers in SI with the unit in their name, texts, lists, other messages.",
        examples=[{"who": "key:line-3"}],
    )

    @classmethod
    def of(cls, code: str, /, **parameters: Parameter) -> Self:
        """The message of this code that names these."""
        return cls(code=code, parameters={name: _plain(value) for name, value in parameters.items()})

    @computed_field(examples=["cancelled by key:line-3."])  # type: ignore[prop-decorator]  # mypy knows no decorator above a property
    @property
    def text(self) -> str:
        """It in English, for those who read no codes."""
        return self.say("en")

    def say(self, language: Language) -> str:
        """It in a language."""
        return format_message(self.code, self._said(language), language)

    def say_part(self, part: str, language: Language = "en") -> str:
        """One part of what it says, such as `found` of a flaw; the whole where it has no parts."""
        return format_part(self.code, part, self._said(language), language)

    def __str__(self) -> str:
        return self.text

    @model_validator(mode="before")
    @classmethod
    def _take_sentence(cls, given: Any) -> Any:
        """A sentence in the place of a message, or one with its name: files and databases of earlier versions have them."""
        match given:
            case str(sentence) | {"sentence": str(sentence)}:
                return {"code": "text", "parameters": {"text": sentence}}
        return given

    @field_validator("parameters")
    @classmethod
    def _restore(cls, parameters: dict[str, Any]) -> dict[str, Any]:
        return {name: _from_json(value) for name, value in parameters.items()}

    @field_serializer("parameters")
    def _to_json(self, parameters: dict[str, Any]) -> dict[str, Any]:
        return {name: _to_json(value) for name, value in parameters.items()}

    def __hash__(self) -> int:
        return hash(self.code)

    def _said(self, language: Language) -> Mapping[str, bool | float | str]:
        return {name: _say_value(value, language) for name, value in self.parameters.items()}


def _plain(value: Any) -> Any:
    """Numbers of NumPy as Python's, sequences as lists, so that JSON takes them."""
    if isinstance(value, Message | str):
        return value
    if hasattr(value, "tolist"):
        return value.tolist()
    return [_plain(each) for each in value] if isinstance(value, Sequence) else value


def _from_json(value: Any) -> Any:
    match value:
        case {"code": str(code)}:
            return Message(code=code, parameters=value.get("parameters", {}))
        case [*values]:
            return [_from_json(each) for each in values]
    return value


def _to_json(value: Any) -> Any:
    match value:
        case Message():
            return {"code": value.code, "parameters": {name: _to_json(each) for name, each in value.parameters.items()}}
        case [*values]:
            return [_to_json(each) for each in values]
    return value


def _say_value(value: Any, language: Language) -> bool | float | str:
    match value:
        case Message():
            return value.say(language)
        case [*values]:
            return ", ".join(str(_say_value(each, language)) for each in values)
        case bool() | int() | float():
            return value
    return _printable(str(value))


def _printable(text: str) -> str:
    """A text with control characters written out: a name in a foreign file must not command a terminal."""
    if text.isprintable():
        return text
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode() for c in text)
