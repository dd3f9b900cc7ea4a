"""Each effect fitted to a recording by itself, in the shape that is most probable."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from core.array import Array
from core.effects.composition import Term
from core.effects.effect import Effect
from core.effects.library import wider_shapes
from core.effects.scene import Scene
from core.estimation.gears import SoundGears
from core.gap.attribution import choose_variants
from core.gap.effect_fit import EffectFit, fit_nominal
from core.gap.fit_all import FitAll, Task, on_all_cores
from core.gap.materiality import is_hidden
from core.gap.most_rows import DRAWN, PARTS, fit_most
from core.gap.partners import terms_of
from core.gap.problem import find_smaller
from core.gap.sound_gears import find_sound_gears, hold_gears
from core.gap.weighing import find_left_share
from core.gap.windows import Windows
from core.words.message import Message

BESIDE = 6
"""Single effects beside which their richer shapes are sought: of a clock that runs off a constant delay explains little."""
MUCH, AGAIN = 0.5, 3
"""Share of the excess left over up to which an effect is fitted again from the payload that was found with it, and how often."""
ONE_IS_CLEAR = 3e-4
"""Share of the excess left over by one effect below which neither richer shapes are sought nor any started from the rows that most agree
on: what spoils the first estimate leaves more to the others."""


@dataclass(frozen=True)
class Singles:
    """Each effect fitted by itself, before any are joined.

    Args:
        windows: of the recording, with what the twin always has on, and gears that turned out to swing.
        nominal, fits: the twin as it is, and with each effect.
        shown, wider, last: the effects that the recording can show, their richer shapes, and those that are sought last.
        stated: whether the twin says already how its gears swing.
        limits: which effects the recording cannot show, and why.
    """

    windows: Windows
    nominal: EffectFit
    fits: tuple[EffectFit, ...]
    shown: tuple[Effect, ...]
    wider: tuple[Effect, ...]
    last: tuple[Effect, ...]
    stated: bool
    limits: tuple[Message, ...]


def fit_singly(windows: Windows, effects: Sequence[Effect], fit_all: FitAll = on_all_cores) -> Singles:
    """All effects by themselves, in the shapes that are most probable."""
    nominal = fit_nominal(windows)
    scene = windows.basis.scene.with_phi(nominal.phi)
    if scene.links is not None:
        scene.links.find()  # here, or each of the processes that fit would
    absences = {effect: _explain_absence(effect, scene, at_rest=windows.basis.rows.at_rest) for effect in effects}
    shown = [effect for effect, reason in absences.items() if reason is None]
    in_twin = {term.effect.id for term in windows.held}  # in their plain shape
    richer = [effect for effect in wider_shapes() if effect.id in {each.id for each in shown} - in_twin]
    wider, last = [effect for effect in richer if not effect.last_resort], [effect for effect in richer if effect.last_resort]
    singles = _fit_singles(windows, nominal, shown, wider, fit_all)
    stated = SoundGears.id in in_twin
    limits = describe_limits(absences)
    found = Singles(windows, nominal, tuple(singles), tuple(shown), tuple(wider), tuple(last), stated, limits)
    gears = None if stated else find_sound_gears(windows, nominal, singles, fit_all)
    return found if gears is None else hold_again(found, gears, fit_all)


def _fit_singles(
    windows: Windows, nominal: EffectFit, effects: Sequence[Effect], wider: Sequence[Effect], fit_all: FitAll
) -> list[EffectFit]:
    """Each effect by itself, in the shape that is most probable; the richer ones where there is something to name."""
    scene, residual = windows.basis.scene.with_phi(nominal.phi), windows.on_grid(nominal.residual)
    known = {term.effect.id: [term.theta] for term in windows.held}
    plain = [Task((effect,), nominal, [*known.get(effect.id, []), *effect.starts(scene, residual)]) for effect in effects]
    singles = choose_variants(nominal, fit_shapes(windows, [task for task in plain if task.thetas], fit_all))
    if is_hidden(windows, nominal) or _one_is_clear(nominal, singles):
        return singles
    richer = [Task((effect,), nominal, effect.starts(scene, residual)) for effect in wider]
    singles = choose_variants(nominal, [*singles, *fit_shapes(windows, [task for task in richer if task.thetas], fit_all)])
    beside = [task for task in start_beside(windows, nominal, singles, wider) if task.thetas]
    singles = choose_variants(nominal, [*singles, *fit_all(windows, beside)]) if beside else singles
    if find_left_share(nominal, min(singles, key=lambda fit: fit.chi_square, default=nominal)) > ONE_IS_CLEAR:
        singles = choose_variants(nominal, [*singles, *_fit_from_most(windows, nominal, singles, [*effects, *wider], fit_all)])
    return singles


def fit_shapes(windows: Windows, tasks: list[Task], fit_all: FitAll) -> list[EffectFit]:
    """The tasks, each in its smaller shape, too, where there is one."""
    smaller = [task._replace(smaller=True) for task in tasks if any(find_smaller(windows, effect) for effect in task.effects)]
    return fit_all(windows, [*tasks, *smaller])


def _one_is_clear(nominal: EffectFit, fits: list[EffectFit]) -> bool:
    """Whether one fit explains a gap so large that whatever else does would show it by more than chance."""
    best = min(fits, key=lambda fit: fit.chi_square, default=nominal)
    return find_left_share(nominal, best) < ONE_IS_CLEAR and ONE_IS_CLEAR * (nominal.chi_square - nominal.rows) > 1.0


def start_beside(windows: Windows, nominal: EffectFit, fits: list[EffectFit], wider: Sequence[Effect]) -> Iterator[Task]:
    """Richer shapes that show only beside the plain one, or another, of the effects that explain most where none explains all."""
    promising = sorted(fits, key=lambda fit: fit.chi_square)[:BESIDE]
    if not promising or find_left_share(nominal, promising[0]) < ONE_IS_CLEAR:
        return
    for fit in promising:
        scene, residual, terms = windows.basis.scene.with_phi(fit.phi), windows.on_grid(fit.residual), terms_of(windows, fit)
        for k, (found, theta) in enumerate(terms):
            before, behind = ([t for _, t in some] for some in (terms[:k], terms[k + 1 :]))
            for effect in wider:
                if effect.id == found.id and _is_beside(effect, found):
                    effects = tuple(effect if each is found else each for each in fit.effects)
                    starts = effect.starts_beside(scene, residual, theta)
                    yield Task(effects, fit, [np.concatenate([*before, start, *behind]) for start in starts])


def _is_beside(effect: Effect, found: Effect) -> bool:
    """Whether it is the shape that the richer one starts from."""
    return not found.wider_shape if effect.beside is None else isinstance(found, effect.beside)


def hold_again(found: Singles, gears: Term, fit_all: FitAll) -> Singles:
    """The same with gears that are always on: each effect from where it was, and where the gap does not hide behind the noise then from the
    start, since starts and shapes were those that the swinging showed."""
    windows = hold_gears(found.windows, gears)
    nominal = fit_nominal(windows)
    fits = fit_all(windows, [fit_again(fit, nominal) for fit in found.fits])
    if not is_hidden(windows, nominal):
        fits = choose_variants(nominal, [*fits, *_fit_singles(windows, nominal, found.shown, found.wider, fit_all)])
    return replace(found, windows=windows, nominal=nominal, fits=tuple(fits))


def fit_again(fit: EffectFit, nominal: EffectFit) -> Task:
    """The same shape of an effect, from where it was."""
    return Task(fit.effects, nominal, [fit.theta], fit.kept_absent > 0)


def _fit_from_most(
    windows: Windows, nominal: EffectFit, singles: list[EffectFit], effects: Sequence[Effect], fit_all: FitAll
) -> list[EffectFit]:
    """Effects that spoil the first estimate, started from the payload that most rows agree on; the best fit of them again from the payload
    that was found with it, which shows better what is missing, and with what it has left over."""
    wanted = [effect for effect in effects if effect.starts_from_most]
    if not wanted or len(windows) < PARTS * DRAWN:
        return []

    def see(start: EffectFit) -> tuple[Scene, Array]:
        residual = windows.target - nominal.change - windows.X @ start.beta
        return windows.basis.scene.with_phi(start.phi), windows.on_grid(residual)

    start = replace(nominal, beta=fit_most(windows, windows.target - nominal.change))
    tasks = [Task((effect,), start, effect.starts(*see(start))) for effect in wanted]
    found = fit_all(windows, [task for task in tasks if task.thetas])
    for _ in range(AGAIN):
        best = min((*found, *(fit for fit in singles if fit.effects[0] in wanted)), key=lambda fit: fit.chi_square, default=nominal)
        if not ONE_IS_CLEAR < find_left_share(nominal, best) < MUCH:
            break
        (effect,), (scene, residual) = best.effects, see(best)
        thetas = [*effect.starts(scene, residual), *effect.starts_beside(scene, windows.on_grid(best.residual), best.theta)]
        again = fit_all(windows, [Task((effect,), best, [theta]) for theta in thetas])
        found += again
        if min((fit.chi_square for fit in again), default=np.inf) >= best.chi_square:
            break
    return found


def _explain_absence(effect: Effect, scene: Scene, *, at_rest: bool) -> Message | None:
    if effect.needs_motion and scene.apart:
        return Message.of("effect-poses-apart")
    if effect.needs_motion and not scene.moves:
        return Message.of("effect-nothing-moves")
    if effect.needs_motion and at_rest:
        return Message.of("effect-rest-alone")
    return effect.explain_absence(scene)


def describe_limits(reasons: Mapping[Effect, Message | None]) -> tuple[Message, ...]:
    """Which effects cannot be seen, with the reasons."""
    return tuple(
        Message.of("gap-not-shown", effect=effect.id, title=effect.title, reason=reason) for effect, reason in reasons.items() if reason
    )
