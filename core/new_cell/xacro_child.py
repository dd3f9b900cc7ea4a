"""Expands a xacro file. A program of its own, started by `expansion`: it reads an order from standard input and imports nothing of Heft.

A xacro file is a program, and it is untrusted. `${...}` is evaluated by the xacro package in Python without built-in names; here an
expression is looked at before, since that package sees names with underscores only where they stand outside of brackets. `$(eval ...)`
is refused: it is evaluated with all built-in names. `$(find ...)` finds the packages of the order only, `$(env ...)` an empty
environment. What is opened is watched: files inside the order's folders, to be read. Limits on time and memory, nothing written.
"""

from __future__ import annotations

import ast
import json
import os
import resource
import sys
from pathlib import Path
from typing import Any

import xacro
from xacro import substitution_args

MAX_CHARACTERS = 5_000_000
SECONDS = 20
MEMORY = 1_000_000_000
LONGEST_EXPRESSION = 2_000
MOST_LETTERS = 300
INNER = ("_", "gi_", "cr_", "ag_", "f_", "tb_", "co_", "func_", "mro", "format")
"""Beginnings of attributes that lead from a value to the interpreter."""
FORBIDDEN = ("socket.", "subprocess.", "os.", "shutil.", "ctypes.", "tempfile.", "pty.", "mmap.")
HARMLESS = ("os.listdir", "os.scandir")


class UnwantedError(Exception):
    """What a xacro file may not do.

    Args:
        code: of the message, for the person who gave the file. parameters: what it names.
    """

    def __init__(self, code: str, **parameters: str | int) -> None:
        super().__init__(code)
        shown = {name: _shorten(value) if isinstance(value, str) else value for name, value in parameters.items()}
        self.message = {"code": code, "parameters": shown}


def expand(order: dict[str, Any]) -> str:
    """The URDF that the order's file expands to."""
    packages: dict[str, str] = order["packages"]
    evaluate = xacro.safe_eval

    def find(name: str) -> str:
        if name not in packages:
            raise UnwantedError("xacro-wants-package", name=name)
        return packages[name]

    def refuse(*_arguments: Any) -> str:
        raise UnwantedError("xacro-wants-eval")

    def careful(expression: str, *arguments: Any) -> Any:
        _look_at(expression)
        return evaluate(expression, *arguments)

    substitution_args._eval_find, substitution_args._eval, xacro.safe_eval = find, refuse, careful
    xacro.init_stacks(order["file"])
    document = xacro.parse(None, order["file"])
    xacro.process_doc(document, mappings=order["arguments"], verbosity=0)
    return str(document.documentElement.toxml())


def _look_at(expression: str) -> None:
    if len(expression) > LONGEST_EXPRESSION:
        raise UnwantedError("xacro-long-expression", characters=len(expression))
    for node in ast.walk(ast.parse(expression.strip(), mode="eval")):
        if isinstance(node, ast.Attribute) and node.attr.startswith(INNER):
            raise UnwantedError("xacro-wants-attribute", name=node.attr)
        if isinstance(node, ast.Name) and node.id.startswith("__"):
            raise UnwantedError("xacro-wants-name", name=node.id)


def confine_xacro(folders: list[str]) -> None:
    """From here on: little time, little memory, no file outside the folders, nothing written, no network, no other program."""
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))
    resource.setrlimit(resource.RLIMIT_FSIZE, (0, 0))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    inside = [Path(folder) for folder in folders]
    library = [Path(path) for path in sys.path if path]

    def watch(event: str, arguments: tuple[Any, ...]) -> None:
        if event == "open" and isinstance(arguments[0], str | bytes | os.PathLike):
            path = Path(os.fsdecode(arguments[0])).resolve()
            reads = arguments[1] in (None, "r", "rb", "rt") or (arguments[1] is None and not arguments[2])
            is_library = path.suffix in (".py", ".pyc", ".so") and any(path.is_relative_to(each) for each in library)
            if not reads or not (is_library or any(path.is_relative_to(folder) for folder in inside)):
                raise UnwantedError("xacro-wants-file", file=str(path))
        elif event.startswith(FORBIDDEN) and event not in HARMLESS:
            raise UnwantedError("xacro-wants-system", event=event)

    sys.addaudithook(watch)


def main() -> int:
    """0 with the URDF on standard output; 3 with what it may not do, as JSON, 4 with what is wrong, on standard error."""
    order = json.load(sys.stdin)
    try:
        confine_xacro(order["folders"])
        text = expand(order)
        if len(text) > MAX_CHARACTERS:
            raise UnwantedError("xacro-long-urdf", characters=len(text))
    except Exception as error:  # noqa: BLE001 - whatever a stranger's program ends with is told
        cause = _find_unwanted(error)
        sys.stderr.write(json.dumps(cause.message) if cause else _shorten(str(error) or type(error).__name__))
        return 3 if cause else 4
    sys.stdout.write(text)
    return 0


def _shorten(text: str) -> str:
    """In one line that can be read."""
    return " ".join(text.split())[:MOST_LETTERS]


def _find_unwanted(error: BaseException | None) -> UnwantedError | None:
    """Xacro wraps what is raised, in a field of its own."""
    for _ in range(100):
        if error is None or isinstance(error, UnwantedError):
            return error
        error = getattr(error, "exc", None) or error.__cause__ or error.__context__
    return None


if __name__ == "__main__":
    sys.exit(main())
