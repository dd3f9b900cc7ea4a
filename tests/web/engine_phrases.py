"""What the engine and the service can say of a flaw, a refusal or a stop, read off their source: phrases, `{}` for what they name."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import product
from pathlib import Path

import core.errors
import server.http.errors
from core.errors import BadInput, HeftError
from tests.server.real_service import ROOT

ERRORS = {name: error for module in (core.errors, server.http.errors) for name, error in vars(module).items() if isinstance(error, type)}
FLAWS = {name: slice(1, 3) for name, error in ERRORS.items() if issubclass(error, BadInput)}
FLAWS |= {"Contradiction": slice(1, 3), "refusal": slice(1, 3), "kind": slice(1, 3), "_refusal": slice(0, 2), "SchemaFlaw": slice(1, 3)}
FLAWS |= {"_replace": slice(1, 3), "open_zip": slice(2, 3)}
"""Which arguments say what was found and what was expected."""
SENTENCES = {name: slice(0, 1) for name, error in ERRORS.items() if issubclass(error, HeftError) and name not in FLAWS}
SENTENCES |= {"kind": slice(0, 1), "Reason": slice(1, 2), "Failed": slice(1, 2), "__init__": slice(0, 1)}
SENTENCES |= {"Hold": slice(1, 2), "_end": slice(0, 1), "problem": slice(2, 3), "send_zip": slice(2, 3), "page": slice(2, 3)}
"""Which argument is the sentence of an error or a reason."""
NOT_HEARD = (
    "core/cli/", "command_line.py", "trial/", "serve.py", "gap/experiment_file.py", "planning/stops.py", "cells/check.py",
    "planning/options.py", "starting_point.py", "set_points.py", "new_cell/",
)  # fmt: skip
"""Speaks to a terminal or to a program alone; what checks cells says flaws, which are read."""
METHODS = {"_replace", "__init__", "_end", "send_zip", "page"}
UNITS = {"kg", "m", "s", "ms", "rad", "N"}
HOLE = "{}"
FEW = 2
"""So many words that a sentence may have at one place are said in as many sentences."""


@dataclass(frozen=True)
class Place:
    """Where an expression stands: in a function or outside of all, and what functions the module has."""

    inside: ast.AST
    functions: dict[str, ast.AST]


def of_flaws() -> set[str]:
    """Every phrase that a flaw may have."""
    return _said(FLAWS, tuple(each for each in NOT_HEARD if each != "cells/check.py"))


def of_refusals() -> set[str]:
    """Every sentence of a refusal, a stop or a reason, and the phrases that it may be made of."""
    return _said(SENTENCES, NOT_HEARD)


def _said(makers: dict[str, slice], left_out: tuple[str, ...]) -> set[str]:
    files = [path for part in ("core", "server") for path in (ROOT / part).rglob("*.py")]
    heard = [path for path in files if not any(each in path.as_posix() for each in left_out)]
    return {phrase for path in heard for phrase in _phrases(path, makers) if has_letters(phrase)}


def has_letters(phrase: str) -> bool:
    """Whether it says something beside a value with its unit."""
    return bool(set(re.findall("[A-Za-z]+", phrase)) - UNITS)


def _phrases(path: Path, makers: dict[str, slice]) -> Iterator[str]:
    module = ast.parse(path.read_text())
    found = [each for each in ast.walk(module) if isinstance(each, ast.FunctionDef | ast.AsyncFunctionDef)]
    functions: dict[str, ast.AST] = {each.name: each for each in found}
    outside = ast.Module([each for each in module.body if isinstance(each, ast.Assign | ast.AnnAssign)], [])
    for inside in (outside, *found):
        place = Place(inside, functions)
        for call in ast.walk(inside):
            if isinstance(call, ast.Call):
                for argument in _arguments(call, makers):
                    yield from _read(argument, place)
                    yield from _parts(argument, place)


def _arguments(call: ast.Call, makers: dict[str, slice]) -> list[ast.expr]:
    name = call.func.id if isinstance(call.func, ast.Name) else call.func.attr if isinstance(call.func, ast.Attribute) else ""
    if isinstance(call.func, ast.Attribute) and name not in METHODS:
        return []
    named = [each.value for each in call.keywords] if name == "_replace" else []
    return [*call.args[makers[name]], *named] if name in makers else []


def _read(said: ast.expr, place: Place) -> set[str]:
    """The phrases that an expression can be; where it comes from elsewhere, a value."""
    match said:
        case ast.Constant(str(text)):
            return {text}
        case ast.JoinedStr(values=parts):
            return {"".join(each) for each in product(*(_inserted(part, place) for part in parts))}
        case ast.BinOp(left=left, op=ast.Add(), right=right):
            return {"".join(each) for each in product(_read(left, place), _read(right, place))}
    choices = _choices(said, place)
    return set().union(*(_read(each, there) for each, there in choices)) if choices else {HOLE}


def _inserted(part: ast.expr, place: Place) -> set[str]:
    """Of a sentence: its own words, a few words that may stand there, or a hole."""
    if not isinstance(part, ast.FormattedValue):
        return _read(part, place)
    few = [each.value for each, _ in _choices(part.value, place) if isinstance(each, ast.Constant)]
    known = len(few) == len(_choices(part.value, place)) <= FEW
    return set(map(str, few)) if few and known else {HOLE}


def _parts(said: ast.expr, place: Place) -> Iterator[str]:
    """The phrases that stand in a sentence's holes."""
    for part in ast.walk(said):
        if isinstance(part, ast.FormattedValue) and _inserted(part, place) == {HOLE}:
            yield from _read(part.value, place)


def _choices(said: ast.expr, place: Place) -> list[tuple[ast.expr, Place]]:
    """What an expression is one of, each with where it stands."""
    match said:
        case ast.IfExp(body=one, orelse=other):
            return [*_alone(one, place), *_alone(other, place)]
        case ast.BoolOp(values=parts):
            return [(part, place) for part in parts]
        case ast.Name(name):
            given = [_given(node, name) for node in ast.walk(place.inside) if isinstance(node, ast.Assign)]
            return [found for each in given if each is not None for found in _alone(each, place)]
        case ast.Call(func=ast.Name(name)) if name in place.functions:
            told = place.functions[name]
            return [(node.value, Place(told, place.functions)) for node in ast.walk(told) if isinstance(node, ast.Return) and node.value]
    return []


def _alone(said: ast.expr, place: Place) -> list[tuple[ast.expr, Place]]:
    """An expression, or what it is one of."""
    return _choices(said, place) if isinstance(said, ast.IfExp) else [(said, place)]


def _given(assignment: ast.Assign, name: str) -> ast.expr | None:
    """What a name gets, alone or beside others."""
    for target in assignment.targets:
        match target, assignment.value:
            case ast.Name(found), value if found == name:
                return value
            case ast.Tuple(elts=names), ast.Tuple(elts=values):
                for each, value in zip(names, values, strict=True):
                    if isinstance(each, ast.Name) and each.id == name:
                        return value
    return None
