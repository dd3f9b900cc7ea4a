"""Several diagnoses of one cell as the command line prints them: which effect is there in which recording, and how large."""

from __future__ import annotations

from rich.table import Table

from core.cli.tables import VERDICTS
from core.cli.terminal import find_wording
from core.effects.parameter_title import find_title
from core.gap.answer import Value
from core.gap.timeline import EffectTimeline, Sighting, State, Timeline
from core.report.parameter_words import value_text

MARKS: dict[State, str] = {"present": "✓", "possible": "?", "minor": "○", "absent": "–", "unclear": "·"}


def timeline_table(timeline: Timeline) -> Table:
    """A row for each effect with its most certain parameter, a column for each recording."""
    words = find_wording()
    table = Table(title=words.say("result-timeline-title"), caption=words.say("result-timeline-caption"))
    table.add_column(words.say("result-effect"))
    for k in range(len(timeline.recordings)):
        table.add_column(f"{k + 1}", no_wrap=True)
    for effect in timeline.effects:
        name = find_leading_parameter(effect)
        title = effect.id if name is None else f"{effect.id}: {words.quote(find_title(name))}"
        table.add_row(title, *(_mark(sighting, name) for sighting in effect.sightings))
    return table


def timeline_lines(timeline: Timeline) -> list[str]:
    """Which recording has which number and verdict, then what came and went."""
    words = find_wording()
    numbered = [
        words.say("result-timeline-recording", number=k + 1, name=recording.name, verdict=VERDICTS[recording.verdict])
        for k, recording in enumerate(timeline.recordings)
    ]
    return [*numbered, *(words.quote(message) for message in timeline.summary)]


def find_leading_parameter(effect: EffectTimeline) -> str | None:
    """That which stands out most from its uncertainty in any recording that shows the effect; None where nothing was fitted."""
    shown = [item for sighting in effect.sightings if sighting.state != "absent" for item in sighting.parameters.items()]
    return max(shown, key=lambda item: _certainty(item[1]), default=(None, None))[0]


def _certainty(value: Value) -> float:
    return abs(value.value) / value.std if value.std else 0.0


def _mark(sighting: Sighting, name: str | None) -> str:
    value = None if name is None or sighting.state == "absent" else sighting.parameters.get(name)
    mark = MARKS[sighting.state]
    return mark if name is None or value is None else f"{mark} {value_text(name, value, find_wording())}"
