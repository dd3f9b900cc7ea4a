"""All effects at hand: the `Effect` classes of the modules in this folder."""

from __future__ import annotations

import importlib
import inspect
import pkgutil
from functools import cache

import core.effects
from core.effects.effect import Effect


@cache
def library() -> tuple[Effect, ...]:
    """One instance of every effect, in the order of their identifiers."""
    found: list[Effect] = []
    for module in pkgutil.iter_modules(core.effects.__path__):
        for _, kind in inspect.getmembers(importlib.import_module(f"core.effects.{module.name}"), inspect.isclass):
            if issubclass(kind, Effect) and not inspect.isabstract(kind) and kind.__module__ == f"core.effects.{module.name}":
                found.append(kind())
    return tuple(sorted(found, key=lambda effect: effect.id))
