"""What the engine and the service can say of a flaw, read off their source: phrases, `{}` for what they name."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from itertools import product
from pathlib import Path

from tests.server.real_service import ROOT

FOUND_FIRST = {"_refusal"}
"""Takes no place before what was found."""
MAKERS = {"BadCell", "BadRobot", "BadPayload", "BadTwin", "BadRecording", "BadInput", "Contradiction", "refusal", "kind", "_refusal"}
TERMINAL_ALONE = ("command.py", "command_line.py", "twin_commands.py", "trial/", "serve.py", "experiment/file.py", "experiment/stops.py")
UNITS = {"kg", "m", "s", "rad", "N"}
HOLE = "{}"

Function = ast.FunctionDef
Place = tuple[Function, dict[str, Function]]


def said_by_the_service() -> set[str]:
    """Every phrase that a flaw may have; a value with nothing but its unit is none."""
    files = [path for part in ("core", "server") for path in (ROOT / part).rglob("*.py")]
    found = {phrase for path in files if not any(each in path.as_posix() for each in TERMINAL_ALONE) for phrase in _phrases(path)}
    return {phrase for phrase in found if set(re.findall("[A-Za-z]+", phrase)) - UNITS}


def _phrases(path: Path) -> Iterator[str]:
    tree = ast.parse(path.read_text())
    functions = {each.name: each for each in ast.walk(tree) if isinstance(each, Function)}
    for function in functions.values():
        for call in ast.walk(function):
            for argument in _said_in(call):
                yield from _read(argument, function, functions)


def _said_in(call: ast.AST) -> list[ast.expr]:
    """The arguments that say what was found and what was expected."""
    if not isinstance(call, ast.Call):
        return []
    name = call.func.id if isinstance(call.func, ast.Name) else call.func.attr if isinstance(call.func, ast.Attribute) else ""
    if name in MAKERS:
        first = 0 if name in FOUND_FIRST else 1
        return call.args[first : first + 2]
    if name in {"SchemaFlaw", "_replace"}:
        return [*call.args[1:], *(each.value for each in call.keywords)]
    if name == "opened_zip":
        return call.args[2:]
    return []


def _read(said: ast.expr, function: Function, functions: dict[str, Function]) -> set[str]:
    """The phrases that an expression can be; where it comes from elsewhere, a value."""
    match said:
        case ast.Constant(str(text)):
            return {text}
        case ast.JoinedStr(values=parts):
            read = [_read(part, function, functions) if isinstance(part, ast.Constant) else {HOLE} for part in parts]
            return {"".join(each) for each in product(*read)}
    choices = _choices(said, function, functions)
    return set().union(*(_read(each, *place) for each, place in choices)) if choices else {HOLE}


def _choices(said: ast.expr, function: Function, functions: dict[str, Function]) -> list[tuple[ast.expr, Place]]:
    """What an expression is one of, each with where it stands."""
    here = (function, functions)
    match said:
        case ast.IfExp(body=one, orelse=other):
            return [(one, here), (other, here)]
        case ast.BoolOp(values=parts):
            return [(part, here) for part in parts]
        case ast.Name(name):
            return [(node.value, here) for node in ast.walk(function) if isinstance(node, ast.Assign) and _is_of(node, name)]
        case ast.Call(func=ast.Name(name)) if name in functions:
            told = functions[name]
            return [(node.value, (told, functions)) for node in ast.walk(told) if isinstance(node, ast.Return) and node.value]
    return []


def _is_of(assignment: ast.Assign, name: str) -> bool:
    return any(isinstance(target, ast.Name) and target.id == name for target in assignment.targets)
