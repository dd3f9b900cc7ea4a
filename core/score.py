"""The score sheet of blind trials: what was right, what was confused with what, and every failure with its seed."""

from __future__ import annotations

from collections import Counter

import numpy as np

from core.trial import Outcome

BINS = 5


def score_sheet(outcomes: list[Outcome], command: str) -> str:
    """Markdown."""
    return "\n".join([
        "# Blind trials",
        "",
        f"`{command}`: {len(outcomes)} trials. Faults are planted by code that shares nothing with the effects; the answer was sealed",
        "(its hash printed) before each diagnosis. A trial that the guard stopped counts as not answered.",
        "",
        *_figures(outcomes),
        "",
        "## First name against the truth (single faults)",
        "",
        *_confusion(outcomes),
        "",
        "## Calibration",
        "",
        *_reliability(outcomes),
        "",
        "## Not right",
        "",
        *_failures(outcomes),
        "",
    ])  # fmt: skip


def _share(part: list[Outcome]) -> str:
    return f"{sum(outcome.right for outcome in part)} of {len(part)}" if part else "none drawn"


def _figures(outcomes: list[Outcome]) -> list[str]:
    answered = [outcome for outcome in outcomes if outcome.stopped is None]
    kinds = {kind: [o for o in answered if o.sealed.kind == kind] for kind in ("none", "single", "double", "unknown")}
    seen = [o for o in kinds["single"] if o.verdict != "no_gap"]
    closures = [o.closure / o.true_closure for o in seen if o.true_closure and o.true_closure > 0.05]
    closure = f"{np.median(closures):.3f} (median of {len(closures)})" if closures else "none"
    exact = [o for o in kinds["double"] if o.verdict != "no_gap"]
    return [
        "| what | here |",
        "| --- | --- |",
        f"| runs without effect that were called so | {_share(kinds['none'])} |",
        f"| single fault, a gap was called: first name right, declared ties count | {_share(seen)} |",
        f"| single fault, called no material gap | {len(kinds['single']) - len(seen)} of {len(kinds['single'])} |",
        f"| two at once, a gap was called: first name is one of them | {_share(exact)} |",
        f"| faults that the library does not have, called unknown or immaterial | {_share(kinds['unknown'])} |",
        f"| closure over the true effect's closure | {closure} |",
        f"| stopped by the guard | {len(outcomes) - len(answered)} |",
    ]


def _confusion(outcomes: list[Outcome]) -> list[str]:
    pairs = Counter((o.sealed.ids[0], o.first or o.verdict) for o in outcomes if o.sealed.kind == "single")
    return ["| planted | answered | times |", "| --- | --- | --- |", *(f"| {a} | {b} | {n} |" for (a, b), n in sorted(pairs.items()))]


def _reliability(outcomes: list[Outcome]) -> list[str]:
    named = [o for o in outcomes if o.first is not None and o.sealed.kind == "single"]
    rows = []
    for low in np.arange(BINS) / BINS:
        inside = [o for o in named if min(int(o.first_probability * BINS), BINS - 1) == round(low * BINS)]
        if inside:
            hit = np.mean([o.first in o.sealed.ids for o in inside])
            rows.append(
                f"| {low:.1f}-{low + 1 / BINS:.1f} | {len(inside)} | {np.mean([o.first_probability for o in inside]):.2f} | {hit:.2f} |"
            )
    return ["| probability | answers | mean | right |", "| --- | --- | --- | --- |", *rows]


def _failures(outcomes: list[Outcome]) -> list[str]:
    wrong = [o for o in outcomes if not o.right]
    return [
        f"- seed {o.sealed.seed}: {o.sealed.kind} {', '.join(f'{i} ({v})' for i, v in zip(o.sealed.ids, o.sealed.variants, strict=True))}, "
        f"size {o.sealed.size:.2f}, {o.sealed.cell}, {o.sealed.payload}: answered {o.first or o.verdict}"
        f" (gap {o.gap_before:.2f} to {o.gap_after:.2f}){'; ' + o.stopped if o.stopped else ''}"
        for o in wrong
    ] or ["None."]
