"""A vendor's package: optional, and imported when its robot or sensor is to be reached."""

from __future__ import annotations

from importlib import import_module
from types import ModuleType

from core.errors import MissingPackage


def import_vendor(module: str, *, extra: str, where: str) -> ModuleType:
    """A module of a vendor's package.

    Args:
        extra: of Heft that brings it.
        where: the key that asks for it.

    Raises:
        MissingPackage: it is not installed, or cannot be loaded here.
    """
    try:
        return import_module(module)
    except ImportError as error:
        raise MissingPackage(where, "session-no-package", module=module, extra=extra, reason=str(error)[:120]) from error
