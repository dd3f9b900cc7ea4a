"""The motion ahead, joined to the recording at hand."""

from __future__ import annotations

import numpy as np

from core.effects.scene import PER_ROW
from core.gap.basis import basis_of
from core.gap.prediction import append_scene
from tests.synthetic import payload, record, run_of


def test_whatever_is_known_of_each_row_is_known_of_both() -> None:
    scene = basis_of(record(run_of(repetitions=1), payload("steel_block"), np.random.default_rng(1))).scene
    both = append_scene(scene, scene)
    assert both.joint_inertia.shape == (2 * len(scene), 7, 7)
    for name in set(PER_ROW) - {"motion"}:
        assert getattr(scene, name) is None or len(getattr(both, name)) == 2 * len(scene), name
