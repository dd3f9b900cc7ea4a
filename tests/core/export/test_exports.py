"""What is exported is the body that was identified: read back with the rules of each target, and by MuJoCo and Pinocchio themselves."""

from __future__ import annotations

import json
import re
from collections.abc import Callable

import mujoco
import numpy as np
import pinocchio as pin
import pytest
from scipy.spatial.transform import Rotation

from core.array import Array
from core.errors import BadInput, BadPayload
from core.export.exports import TARGETS, target_of
from core.payload.uncertain_parameters import UncertainParameters
from tests.core.export.cloud import cloud, covariance

Body = tuple[float, Array, Array]
"""Mass (kg), centre of mass (m), inertia about it (kg m2)."""

NUMBER = r"[-+]?[\d.]+(?:e[-+]?\d+)?"


def numbers(text: str) -> list[float]:
    return [float(word) for word in re.findall(rf"(?<![\w.]){NUMBER}", text)]


def full(xx: float, yy: float, zz: float, xy: float, xz: float, yz: float) -> Array:
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


def read_ur(text: str) -> Body:
    m, x, y, z, *inertia = numbers(text.splitlines()[1])
    return m, np.array([x, y, z]), full(*inertia)


def read_krl(text: str) -> Body:
    values = numbers(text.partition("=")[2])
    m, com, abc, moments = values[0], np.array(values[1:4]) / 1000, values[4:7], values[7:]
    turn = Rotation.from_euler("ZYX", abc, degrees=True).as_matrix()
    return m, com, turn @ np.diag(moments) @ turn.T


def read_sunrise(text: str) -> Body:
    m, x, y, z, xx, yy, zz = [float(line.split()[-1]) for line in text.splitlines()]
    return m, np.array([x, y, z]) / 1000, np.diag([xx, yy, zz])


def read_abb(text: str) -> Body:
    values = numbers(text.partition("=")[2])
    w, x, y, z = values[4:8]
    turn = Rotation.from_quat([x, y, z, w]).as_matrix()
    return values[0], np.array(values[1:4]) / 1000, turn @ np.diag(values[8:]) @ turn.T


def read_franka(text: str) -> Body:
    load = json.loads(text)
    return load["load_mass"], np.array(load["F_x_Cload"]), np.array(load["load_inertia"]).reshape(3, 3).T


def read_flexiv(text: str) -> Body:
    tool = json.loads(text)
    return tool["mass"], np.array(tool["CoM"]), full(*tool["inertia"])


def read_opc_ua(text: str) -> Body:
    load = json.loads(text)
    place, turn = load["CenterOfMass"]["CartesianCoordinates"], load["CenterOfMass"]["Orientation"]
    m, com = load["Mass"]["Value"], np.array([place[name] for name in "XYZ"]) / 1000
    axes = Rotation.from_euler("ZYX", [turn[name] for name in "ABC"], degrees=True).as_matrix()
    about_mount = axes @ np.diag([load["Inertia"][name] for name in "XYZ"]) @ axes.T
    return m, com, about_mount - m * (com @ com * np.eye(3) - np.outer(com, com))


def read_mujoco(text: str) -> Body:
    model = mujoco.MjModel.from_xml_string(f"<mujoco><worldbody><body><freejoint/>{text}</body></worldbody></mujoco>")
    w, x, y, z = model.body_iquat[1]
    turn = Rotation.from_quat([x, y, z, w]).as_matrix()
    return float(model.body_mass[1]), model.body_ipos[1].copy(), turn @ np.diag(model.body_inertia[1]) @ turn.T


def read_urdf(text: str) -> Body:
    joint = '<joint name="j" type="continuous"><parent link="a"/><child link="b"/></joint>'
    model = pin.buildModelFromXML(f'<robot name="r"><link name="a"/>{joint}<link name="b">{text}</link></robot>')
    body = model.inertias[1]
    return float(body.mass), np.array(body.lever), np.array(body.inertia)


READERS: dict[str, Callable[[str], Body]] = {
    "ur": read_ur, "kuka_krl": read_krl, "abb": read_abb, "franka": read_franka, "flexiv": read_flexiv, "opc_ua": read_opc_ua,
    "mujoco": read_mujoco, "urdf": read_urdf,
}  # fmt: skip


def test_every_target_that_holds_a_whole_body_is_read_back_here():
    assert {target.name for target in TARGETS} - set(READERS) == {"kuka_sunrise", "xarm"}


@pytest.mark.parametrize("name", READERS)
@pytest.mark.parametrize("seed", range(6))
def test_what_is_read_back_is_the_body(name: str, seed: int):
    body = cloud(seed)
    target = target_of(name)
    m, com, inertia = READERS[name](target.render_file(body.parameters(covariance(seed))))
    truth = body.inertia(body.com)
    assert m == pytest.approx(body.masses.sum(), rel=1e-7)
    np.testing.assert_allclose(com, body.com, atol=1e-8)
    np.testing.assert_allclose(inertia, truth, atol=1e-6 * np.trace(truth))
    assert list(target.lacks(body.parameters(covariance(seed)))) == []


def test_sunrise_drops_the_products_and_says_how_large_they_are_against_their_uncertainty():
    body = cloud(1)
    parameters = body.parameters(covariance(1))
    target = target_of("kuka_sunrise")
    m, com, inertia = read_sunrise(target.render_file(parameters))
    truth = body.inertia(body.com)
    assert m == pytest.approx(body.masses.sum())
    np.testing.assert_allclose(com, body.com, atol=1e-8)
    np.testing.assert_allclose(np.diag(inertia), np.diag(truth), rtol=1e-6)
    lacks = {lack.name: lack for lack in target.lacks(parameters)}
    assert {name: lack.value for name, lack in lacks.items()} == pytest.approx({"Ixy": truth[0, 1], "Ixz": truth[0, 2], "Iyz": truth[1, 2]})
    assert all(lack.times_std == pytest.approx(abs(lack.value) / lack.std) for lack in lacks.values())


def test_xarm_takes_no_inertia_and_needs_none():
    body = cloud(2)
    known = body.parameters(covariance(2))
    phi, S = known.phi.copy(), known.covariance.copy()
    phi[4:], S[4:, :], S[:, 4:] = np.nan, np.nan, np.nan
    static = UncertainParameters(phi, S)
    target = target_of("xarm")
    m, *com = numbers(target.render_file(static).partition("(")[2])
    np.testing.assert_allclose([m, *com], [body.masses.sum(), *(1000 * body.com)], rtol=1e-8)
    assert list(target.lacks(static)) == []
    assert len(list(target.lacks(known))) == 6
    with pytest.raises(BadPayload, match="Ixx: found not determined"):
        target_of("mujoco").render_file(static)


def test_universal_robots_takes_no_inertia_beyond_its_limit():
    heavy = cloud(3)
    masses = heavy.masses * 2e4
    with pytest.raises(BadPayload, match="133 kg m2"):
        target_of("ur").render_file(type(heavy)(masses, heavy.points).parameters(covariance(3)))


def test_an_unknown_target_is_refused_with_those_that_there_are():
    with pytest.raises(BadInput, match="one of ur, kuka_krl"):
        target_of("fanuc")


def test_opc_ua_names_its_units_by_their_common_codes():
    load = json.loads(target_of("opc_ua").render_file(cloud(0).parameters(covariance(0))))
    assert load["Mass"]["EngineeringUnits"]["UnitId"] == 4933453
    assert load["CenterOfMass"]["CartesianCoordinates"]["LengthUnit"]["UnitId"] == 5066068
