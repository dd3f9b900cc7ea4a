"""All effects at hand: the classes of the modules in this folder."""

from __future__ import annotations

import importlib
import inspect
import pkgutil
from collections.abc import Iterator
from functools import cache

import core.effects
from core.effects.effect import Effect, Symptom


@cache
def library() -> tuple[Effect, ...]:
    """One instance of every effect that changes the wrench, in the order of their identifiers."""
    return tuple(sorted((kind() for kind in _classes() if issubclass(kind, Effect) and not kind.wider_shape), key=lambda effect: effect.id))


@cache
def find_effect(identifier: str) -> Effect:
    """The library's effect of this identifier, which is the name of its module: no other is loaded.

    Raises:
        KeyError: there is none.
    """
    if identifier not in _modules():
        raise KeyError(identifier)
    kinds = (kind for kind in _classes_of(identifier) if issubclass(kind, Effect) and not kind.wider_shape)
    return {effect.id: effect for effect in (kind() for kind in kinds)}[identifier]


@cache
def wider_shapes() -> tuple[Effect, ...]:
    """One instance of every richer shape of an effect of the library, which has its identifier."""
    return tuple(sorted((kind() for kind in _classes() if issubclass(kind, Effect) and kind.wider_shape), key=lambda effect: effect.id))


@cache
def symptoms() -> tuple[Symptom, ...]:
    """One instance of every effect that is read off a recording directly, in the order of their identifiers."""
    return tuple(sorted((kind() for kind in _classes() if issubclass(kind, Symptom)), key=lambda symptom: symptom.id))


@cache
def _modules() -> tuple[str, ...]:
    return tuple(module.name for module in pkgutil.iter_modules(core.effects.__path__))


def _classes() -> Iterator[type]:
    """Concrete classes, each from the module that defines it."""
    return (kind for module in _modules() for kind in _classes_of(module))


def _classes_of(module: str) -> Iterator[type]:
    name = f"core.effects.{module}"
    for _, kind in inspect.getmembers(importlib.import_module(name), inspect.isclass):
        if kind.__module__ == name and not inspect.isabstract(kind):
            yield kind
