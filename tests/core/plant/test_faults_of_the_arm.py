"""What is never quite right of one arm and its sensor."""

import numpy as np

from core.plant.faults import Setting
from core.plant.faults.arm_imperfections import STIFFEST, SmallZeros, StiffJoints, draw_arm_imperfections
from core.plant.faults.joint_springs import ElasticJoints
from tests.core.plant.fault_oracle import CELL, EXACT, PAYLOAD, SETTING, path, rigid, run
from tests.core.plant.plant_oracle import CELLS

ALONG = path()[:300]


def test_an_arm_has_its_own_in_every_run_and_no_other_arm_has_them():
    cylinder = CELL.payloads["cylinder"].parameters
    assert draw_arm_imperfections(SETTING) == draw_arm_imperfections(Setting(CELL, cylinder, seconds=50.0))
    of_each = [draw_arm_imperfections(Setting(cell, PAYLOAD)) for cell in CELLS.values()]
    assert len(set(of_each)) == len(CELLS)


def test_sound_gears_give_way_by_a_milliradian_at_most():
    for cell in CELLS.values():
        setting = Setting(cell, PAYLOAD)
        stiffness = np.array(StiffJoints.draw(np.random.default_rng(0), 1.0, setting).stiffness_n_m_per_rad)
        assert (stiffness <= STIFFEST).all()
        assert (stiffness > 1e4).all()


def test_a_spring_that_is_planted_takes_the_place_of_the_arms_own():
    own = StiffJoints.draw(np.random.default_rng(1), 1.0, SETTING)
    soft = ElasticJoints.draw(np.random.default_rng(2), 1.0, SETTING)
    np.testing.assert_array_equal(run(own, soft, along=ALONG).wrench, run(soft, along=ALONG).wrench)
    assert np.abs(run(own, along=ALONG).true_q - run(soft, along=ALONG).true_q).max() > 1e-4


def test_small_zeros_turn_the_payload_by_a_hundredth_of_a_degree():
    zeros = SmallZeros.draw(np.random.default_rng(3), 1.0, SETTING)
    assert 0.003 < np.degrees(np.abs(zeros.offset_rad)).max() < 0.04
    made = run(zeros, along=ALONG)
    np.testing.assert_allclose(made.true_wrench[::9], rigid(made, offset=np.array(zeros.offset_rad)), atol=EXACT)
