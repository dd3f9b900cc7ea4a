"""Runs a program in a small part of URScript: assignments, `if`, `while`, and calls, as its public manual has them.

The program is turned into a generator that yields wherever the controller's next period has to be waited for (`servoj`, `stopj`, `sync`).
Only names that the controller gives can be called; nothing else of Python can be reached from it.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Generator, Mapping

WAITING = frozenset({"servoj", "stopj", "sync"})
"""Functions that take until the next period, or longer: they are generators."""
NODES = (
    ast.Module, ast.FunctionDef, ast.arguments, ast.Assign, ast.Name, ast.Load, ast.Store, ast.Constant, ast.List, ast.Expr, ast.Call,
    ast.YieldFrom, ast.While, ast.If, ast.Compare, ast.Eq, ast.NotEq, ast.Lt, ast.LtE, ast.Gt, ast.GtE, ast.BoolOp, ast.And, ast.Or,
    ast.UnaryOp, ast.USub, ast.Not, ast.BinOp, ast.Add, ast.Sub, ast.Mult, ast.Div, ast.keyword,
)  # fmt: skip


class ScriptError(Exception):
    """The controller would not run it; says which line."""


def compile_script(text: str, functions: Mapping[str, Callable[..., object]]) -> Generator[None, None, None]:
    """The program, to be advanced once each period.

    Raises:
        ScriptError: it is not of this part of the language, or calls what there is not.
    """
    begun = _read(text, functions)()
    if not isinstance(begun, Generator):
        raise ScriptError("it never waits for the next period")
    return begun


def run_secondary(text: str, functions: Mapping[str, Callable[..., object]]) -> None:
    """Runs a secondary program (`sec`), which takes no time.

    Raises:
        ScriptError: it is not of this part of the language, calls what there is not, or waits; or a call refuses its arguments.
    """
    try:
        begun = _read(re.sub(r"^\s*sec ", "def ", text), functions)()
    except (TypeError, ValueError, ArithmeticError) as error:
        raise ScriptError(str(error)) from error
    if begun is not None:
        raise ScriptError("a secondary program does not wait")


def _read(text: str, functions: Mapping[str, Callable[..., object]]) -> Callable[[], object]:
    """The program as a function.

    Raises:
        ScriptError: it is not of this part of the language, or calls what there is not.
    """
    source, name = _indent(text)
    try:
        tree = ast.parse(source)
    except SyntaxError as error:
        raise ScriptError(f"line {error.lineno}: {error.msg}") from error
    for node in ast.walk(tree):
        line = getattr(node, "lineno", 0)
        if not isinstance(node, NODES):
            raise ScriptError(f"line {line}: {type(node).__name__}")
        if isinstance(node, ast.Call) and not (isinstance(node.func, ast.Name) and node.func.id in functions):
            raise ScriptError(f"line {line}: no such function")
        if isinstance(node, ast.Name) and node.id.startswith("_"):
            raise ScriptError(f"line {line}: {node.id}")
    space: dict[str, object] = {**functions, "__builtins__": {}}
    exec(compile(tree, "<urscript>", "exec"), space)  # the tree holds nothing but what is checked above
    program = space[name]
    assert callable(program)
    return program


def _indent(text: str) -> tuple[str, str]:
    """URScript's blocks end with `end`, Python's with their indent. Gives the source and the name of the program."""
    lines, depth, name = [], 0, ""
    for line in text.splitlines():
        code = line.split("#")[0].strip()
        if not code:
            lines.append("")
            continue
        if code == "end":
            depth -= 1
            continue
        if re.match(r"(else|elif)\b", code):
            depth -= 1
        code = re.sub(r"\bTrue\b|\bFalse\b", lambda found: found.group().title(), code)
        waits = re.match(r"(\w+)\(", code)
        if waits and waits.group(1) in WAITING:
            code = f"yield from {code}"
        lines.append("    " * depth + code)
        if code.endswith(":"):
            depth += 1
            found = re.match(r"def (\w+)\(\):", code)
            name = name or (found.group(1) if found else "")
    if depth or not name:
        raise ScriptError("a block without its end, or no program")
    return "\n".join(lines) + "\n", name
