"""What requests name in their path, query and headers, as types: each said once, for every route that asks for it."""

from __future__ import annotations

from typing import Annotated

from fastapi import Path, Query
from pydantic import AfterValidator

from core.words.catalogue import LANGUAGES, Language
from server.http.schemas import Name

CellPath = Annotated[Name, Path(description="Name of the cell.", examples=["lwr4_bench"])]
ZonePath = Annotated[Name, Path(description="Name of the protected zone.", examples=["operator"])]
DraftPath = Annotated[str, Path(description="Identifier of the draft.", examples=["9f86d081884c7d659a2feaa0"])]
ImportPath = Annotated[str, Path(description="Identifier of the import of a log.", examples=["9f86d081884c7d659a2feaa0"])]
LogFilePath = Annotated[str, Path(description="Name of a file of the log.", examples=["wrench.csv"])]
EffectPath = Annotated[Name, Path(description="Name of the effect.", examples=["time_delay"])]
AccountPath = Annotated[Name, Path(description="Name of the account.", examples=["anna"])]
KeyPath = Annotated[Name, Path(description="Name of the machine whose key it is.", examples=["line-3"])]
SavedPath = Annotated[str, Path(description="Identifier of the saved payload.", examples=["019ab1c2d3e44f1c2a9be7"])]
RunPath = Annotated[str, Path(description="Identifier of the run.", examples=["019ab1c2d3e44f1c2a9be7"])]
OtherRunPath = Annotated[str, Path(description="Identifier of the run to compare with.", examples=["019ab1c9aa210f6be35d08"])]
DiagnosisPath = Annotated[str, Path(description="Identifier of the diagnosis.", examples=["019ab1c2e0a17d34a06c11"])]
TrialsPath = Annotated[str, Path(description="Identifier of the trials.", examples=["019ab1c2f7b2a6e01d5c33"])]
SessionPath = Annotated[str, Path(description="Identifier of the browser's session.", examples=["019ab1c2d3e44f1c2a9be7"])]
AlarmPath = Annotated[str, Path(description="Identifier of the alarm.", examples=["019a0f3c52b1c4f0a1b2c3"])]
WebhookPath = Annotated[str, Path(description="Identifier of the webhook.", examples=["019ab1b0c0d1e2f3a4b5c6"])]
ViewPath = Annotated[Name, Path(description="Name that the page gave its view of the cell.", examples=["a1b2c3"])]
ProblemPath = Annotated[str, Path(description="Code of the situation, or a kind of problems.", examples=["runs-offer-old"])]

LimitQuery = Annotated[int, Query(ge=1, le=200, description="How many items are answered at most.", examples=[50])]


def _choose_language(asked: str) -> Language:
    return asked if asked in LANGUAGES else "en"


LanguageQuery = Annotated[
    str,
    AfterValidator(_choose_language),
    Query(description="Language of the answer, by its code; in English where Heft has no words in it.", examples=["de"]),
]
