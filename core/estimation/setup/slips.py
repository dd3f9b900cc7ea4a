"""What people slip on when they set up a recording, one after the other: what undoes it, and what it is called.

Each can be undone, and an undone slip fits if it was one. Only what one slip explains is named; the sign of the wrench comes with any of
them, because it needs no test of its own: the mass is negative.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import partial
from itertools import combinations, permutations, product

import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.estimation.setup.stances import FORCE, TORQUE, Stances
from core.payload.rotations import cross
from core.words.message import Message

AXES = "xyz"


@dataclass(frozen=True)
class SetupSlip:
    """One kind of slip.

    Args:
        name: what would be right instead, as part of a sentence.
        undo: turns the stances as recorded into those that were meant.
        rarity: how much rarer than the commonest it is, in steps; of two that explain the same, the commoner is named.
    """

    name: Message
    undo: Callable[[Stances], Stances]
    rarity: int = 0


def slips_of(stances: Stances) -> Iterator[SetupSlip]:
    """All that such a recording can have."""
    yield from _of_wrench(stances)
    yield from _of_gravity(stances)
    yield from _of_axes()
    if stances.q is None:
        yield from _of_orientation()
    else:
        yield from _of_joints(stances)


def _of_wrench(stances: Stances) -> Iterator[SetupSlip]:
    yield SetupSlip(Message.of("setup-wrench-in-base"), _wrench_from_base)
    yield SetupSlip(Message.of("setup-force-and-torque-exchanged"), lambda s: replace(s, wrench=s.wrench[:, [3, 4, 5, 0, 1, 2]]), 1)
    if stances.position is not None:
        yield SetupSlip(Message.of("setup-torque-about-base"), _torque_from_base, 1)
        yield SetupSlip(Message.of("setup-wrench-in-and-about-base"), lambda s: _torque_from_base(_wrench_from_base(s)), 1)


def _wrench_from_base(stances: Stances) -> Stances:
    turned = [np.einsum("kij,kj->ki", stances.base, stances.wrench[:, part]) for part in (FORCE, TORQUE)]
    return replace(stances, wrench=np.concatenate(turned, axis=1))


def _torque_from_base(stances: Stances) -> Stances:
    """From the base's origin to the sensor's, sensor axes."""
    assert stances.position is not None
    arm = np.einsum("kij,kj->ki", stances.base, stances.position[:, 1])
    f, tau = stances.wrench[:, FORCE], stances.wrench[:, TORQUE]
    return replace(stances, wrench=np.concatenate((f, tau - cross(arm, f)), axis=1))


def _of_gravity(stances: Stances) -> Iterator[SetupSlip]:
    size = float(np.linalg.norm(stances.gravity))
    for axis, sign in product(range(3), (-1.0, 1.0)):
        gravity = np.zeros(3)
        gravity[axis] = sign * size
        if gravity @ stances.gravity < 0.8 * size**2:
            name = Message.of("setup-gravity-along", gravity_m_s2=gravity.round(3).tolist())
            yield SetupSlip(name, partial(_in_gravity, gravity=gravity), 0 if axis == 2 else 1)


def _in_gravity(stances: Stances, gravity: Array) -> Stances:
    return replace(stances, gravity=gravity)


def _of_orientation() -> Iterator[SetupSlip]:
    yield SetupSlip(Message.of("setup-quaternions-wxyz"), lambda s: replace(s, rotation=_from_wxyz(s.rotation)))
    yield SetupSlip(Message.of("setup-rotation-inverted"), lambda s: replace(s, rotation=np.swapaxes(s.rotation, -1, -2)))
    inverted = Message.of("setup-both", first=Message.of("setup-quaternions-wxyz"), second=Message.of("setup-rotation-inverted"))
    yield SetupSlip(inverted, lambda s: replace(s, rotation=np.swapaxes(_from_wxyz(s.rotation), -1, -2)), 2)


def _from_wxyz(rotation: Array) -> Array:
    """What was read as x y z w was w x y z."""
    from scipy.spatial.transform import Rotation  # noqa: PLC0415 - half of SciPy, for what is asked when something is wrong

    read = Rotation.from_matrix(rotation.reshape(-1, 3, 3)).as_quat()
    return np.asarray(Rotation.from_quat(read[:, [1, 2, 3, 0]]).as_matrix()).reshape(rotation.shape)


def _of_axes() -> Iterator[SetupSlip]:
    """Columns in another order or with other signs: of force, of torque, or of both."""
    for order, signs in product(permutations(range(3)), product((1.0, -1.0), repeat=3)):
        turned = np.zeros((3, 3))
        turned[range(3), order] = signs
        if order == (0, 1, 2) and len(set(signs)) == 1:
            continue
        axes = [f"{'-' if sign < 0 else ''}{AXES[k]}" for k, sign in zip(order, signs, strict=True)]
        changes = sum(k != j for k, j in enumerate(order)) + sum(sign < 0 for sign in signs)
        yield SetupSlip(Message.of("setup-axes-of-both", axes=axes), partial(_turn, force=turned, torque=turned), 1 + changes)
        yield SetupSlip(Message.of("setup-axes-of-force", axes=axes), partial(_turn, force=turned, torque=np.eye(3)), 2 + changes)
        yield SetupSlip(Message.of("setup-axes-of-torque", axes=axes), partial(_turn, force=np.eye(3), torque=turned), 2 + changes)


def _turn(stances: Stances, force: Array, torque: Array) -> Stances:
    """Column k becomes what the matrices say of the columns that were read."""
    f, tau = stances.wrench[:, FORCE], stances.wrench[:, TORQUE]
    return replace(stances, wrench=np.concatenate((f @ force.T, tau @ torque.T), axis=1))


def _of_joints(stances: Stances) -> Iterator[SetupSlip]:
    assert stances.q is not None and stances.robot is not None
    n, names = stances.q.shape[-1], stances.robot.description.joints
    yield SetupSlip(Message.of("setup-joints-in-degrees"), partial(_scale, factors=np.radians(1.0)))
    yield SetupSlip(Message.of("setup-joints-converted-twice"), partial(_scale, factors=np.degrees(1.0)), 1)
    yield SetupSlip(Message.of("setup-joints-reversed"), partial(_reorder, order=np.arange(n)[::-1]), 1)
    yield SetupSlip(Message.of("setup-all-joints-negative"), partial(_scale, factors=-1.0), 1)
    for i in range(n):
        flip = np.where(np.arange(n) == i, -1.0, 1.0)
        yield SetupSlip(Message.of("setup-joint-negative", joint=names[i]), partial(_scale, factors=flip), 1)
    for i, j in combinations(range(n), 2):
        order = np.arange(n)
        order[[i, j]] = j, i
        exchanged = Message.of("setup-joints-exchanged", first=names[i], second=names[j])
        yield SetupSlip(exchanged, partial(_reorder, order=order), 1)
    for k in (1, n - 1):
        shifted = Message.of("setup-joints-shifted", places=k)
        yield SetupSlip(shifted, partial(_reorder, order=np.roll(np.arange(n), -k)), 2)


def _scale(stances: Stances, factors: Array | float) -> Stances:
    assert stances.q is not None
    return stances.at_joints(stances.q * factors)


def _reorder(stances: Stances, order: NDArray[np.intp]) -> Stances:
    assert stances.q is not None
    return stances.at_joints(stances.q[..., order])
