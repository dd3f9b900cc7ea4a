"""What is left of the procedure where a sensor axis has no room."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace

from core.errors import Refused
from core.events import Event
from core.planning.settings import Scope


def axes_with_room(scope: Scope, refusal: Refused, plan: Callable[[Scope], Iterable[Event]]) -> str:
    """The axes that can be planned without those that are refused; empty where there is no plan for any.

    Args:
        scope: what was refused.
        refusal: of it; who is refused for something else than an axis is not helped by leaving one out.
        plan: plans a part of the procedure.
    """
    axes, refused = scope.axes, refusal.axis
    while refused:
        axes = axes.replace(refused[0], "")
        if not axes:
            break
        try:
            for _ in plan(replace(scope, axes=axes)):
                pass
        except Refused as further:
            refused = further.axis
        else:
            return axes
    return ""
