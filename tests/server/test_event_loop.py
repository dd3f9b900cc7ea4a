"""What keeps the lease alive runs on the event loop: no coroutine of the service reads or writes the database there."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

SERVER = Path(__file__).parents[2] / "server"
TRANSACTIONS = {"read", "write", "begin", "session"}


def on_the_loop(coroutine: ast.AsyncFunctionDef) -> Iterator[ast.AST]:
    """What a coroutine does itself; functions in it are handed to threads."""
    waiting: list[ast.AST] = list(coroutine.body)
    while waiting:
        node = waiting.pop()
        yield node
        if not isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda):
            waiting += ast.iter_child_nodes(node)


def transactions(node: ast.AST) -> bool:
    if not (isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute)):
        return False
    return node.func.attr in TRANSACTIONS and ast.unparse(node.func.value).rpartition(".")[2].strip("_") == "store"


def test_no_coroutine_opens_a_transaction() -> None:
    found = [
        f"{file.relative_to(SERVER)}:{node.lineno} {coroutine.name}"
        for file in SERVER.rglob("*.py")
        for coroutine in ast.walk(ast.parse(file.read_text()))
        if isinstance(coroutine, ast.AsyncFunctionDef)
        for node in on_the_loop(coroutine)
        if transactions(node)
    ]
    assert found == []


def test_a_transaction_in_a_coroutine_would_be_seen_and_one_in_a_function_for_a_thread_would_not() -> None:
    text = "async def f():\n    with self._store.write():\n        pass\n    def g():\n        with store.read():\n            pass\n"
    coroutine = ast.parse(text).body[0]
    assert isinstance(coroutine, ast.AsyncFunctionDef)
    assert sum(map(transactions, on_the_loop(coroutine))) == 1
