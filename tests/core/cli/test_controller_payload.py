"""`heft export --write`: who accepts, what is shown, and what is refused before anything is reached."""

import shutil
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from core.cell.folder import find_cell, load_cell
from core.cli.main import app
from core.errors import BadInput, BadPayload, NotConnected, Refused
from core.fakes.franka_arm import FrankaArm
from core.fakes.franka_server import FrankaServer
from core.fakes.ur_arm import UrArm
from core.fakes.ur_server import UrServer
from core.fakes.xarm_arm import XarmArm
from core.fakes.xarm_server import XarmServer
from tests.core.export.cloud import cloud
from tests.core.export.known_result import answer
from tests.loopback import HOST

XARM_PORT = 5020
SIMULATED = load_cell(find_cell("ur5e_line"))


@pytest.fixture
def cell(tmp_path: Path) -> Path:
    folder = tmp_path / "ur5e_line"
    shutil.copytree(SIMULATED.folder, folder)
    with (folder / "cell.toml").open("a") as file:
        file.write(f'\n[session]\ndriver = "ur_rtde"\nhost = "{HOST}"\nmodel = "UR5e"\n')
    return folder


@pytest.fixture
def server():
    with UrServer(UrArm(SIMULATED, seed=1), HOST) as server:
        yield server


def write(tmp_path: Path, cell: Path, *options: str, change=lambda result: result, typed: str | None = None, of: str | None = "ur5e_line"):
    file = tmp_path / "answer.json"
    file.write_text(change(answer(cloud(0), of)).model_dump_json())
    return CliRunner().invoke(app, ["export", str(file), "--target", "ur", "--write", str(cell), *options], input=typed)


def has(arm: UrArm) -> list[float]:
    return [arm.payload, *arm.payload_com, *arm.payload_inertia]


def expected() -> list[float]:
    """Summed from the points, in the flange's frame, in the maker's order."""
    mount = SIMULATED.sensor.mount
    body = cloud(0).moved(mount.rotation, mount.translation)
    about = body.inertia(body.com)
    return [body.masses.sum(), *body.com, *np.diag(about), about[0, 1], about[0, 2], about[1, 2]]


def test_whoever_is_named_has_accepted_it(server, cell, tmp_path):
    said = write(tmp_path, cell, "--accepted-by", "M. Curie")
    assert said.exit_code == 0, said.output
    np.testing.assert_allclose(has(server.arm), expected(), rtol=1e-7, atol=1e-9)
    assert "accepted by M. Curie" in said.stdout
    assert "zeroes its force/torque sensor" in said.stderr


@pytest.mark.parametrize(("typed", "taken"), [("yes\n", True), ("y\n", False), ("\n", False), ("no\n", False)])
def test_at_a_terminal_nothing_but_a_whole_yes_counts(server, cell, tmp_path, monkeypatch, typed, taken):
    monkeypatch.setattr("core.cli.controller_payload._can_ask", lambda: True)
    server.arm.payload = 0.75
    said = write(tmp_path, cell, typed=typed)
    assert "controller has" in said.stdout and "0.75" in said.stdout
    assert f"{expected()[0]:.5g}" in said.stdout
    assert server.arm.zeroed == taken
    assert isinstance(said.exception, Refused) is not taken


def test_in_a_pipe_nobody_can_accept_and_nothing_is_reached(cell, tmp_path):
    said = write(tmp_path, cell, typed="yes\n")
    assert isinstance(said.exception, BadInput)
    assert "--accepted-by with the name" in str(said.exception)


def test_who_is_not_there_is_told(cell, tmp_path):
    said = write(tmp_path, cell, "--accepted-by", "me")
    assert isinstance(said.exception, NotConnected)


def change_estimate(**changes):
    return lambda result: result.model_copy(update={"estimate": result.estimate.model_copy(update=changes)})


def without(*rows: int):
    """The answer without these parameters."""
    known = cloud(0).parameters(np.eye(10))
    phi = [None if k in rows else value for k, value in enumerate(known.phi.tolist())]
    covariance = [[None if {i, j} & set(rows) else 1e-8 * (i == j) for j in range(10)] for i in range(10)]
    return change_estimate(phi=phi, covariance=covariance)


def with_inertia(k: int, value: float):
    phi = cloud(0).parameters(np.eye(10)).phi.copy()
    phi[k] = value
    return change_estimate(phi=phi.tolist())


def with_mass(value: float):
    return with_inertia(0, value)


@pytest.mark.parametrize(
    ("change", "error", "says"),
    [
        (without(0), BadPayload, "m: found not determined"),
        (without(2), BadPayload, "mc_y: found not determined"),
        (with_inertia(9, -0.2), BadPayload, "Izz: found -0"),
        (with_inertia(9, 140.0), BadPayload, "at most"),
        (with_mass(-1.0), BadPayload, "m: found -1"),
    ],
)
def test_what_a_controller_must_not_be_set_to_is_refused_unreached(cell, tmp_path, change, error, says):
    said = write(tmp_path, cell, "--accepted-by", "me", change=change)
    assert isinstance(said.exception, error)
    assert says in str(said.exception)


def test_an_inertia_that_is_not_determined_is_zero_and_that_is_said(server, cell, tmp_path):
    said = write(tmp_path, cell, "--accepted-by", "me", change=without(5))
    assert said.exit_code == 0, said.output
    np.testing.assert_allclose(has(server.arm), [*expected()[:4], *[0.0] * 6], rtol=1e-7, atol=1e-9)
    assert "inertia is not determined" in said.stderr


@pytest.mark.parametrize("of", ["lwr4_bench", None])
def test_an_answer_of_another_cell_is_refused(cell, tmp_path, of):
    said = write(tmp_path, cell, "--accepted-by", "me", of=of)
    assert isinstance(said.exception, BadInput)
    assert "one of 'ur5e_line'" in str(said.exception)


def test_a_cell_without_a_mount_is_refused(cell, tmp_path):
    toml = cell / "cell.toml"
    toml.write_text("\n".join(line for line in toml.read_text().splitlines() if not line.startswith("mount.")))
    said = write(tmp_path, cell, "--accepted-by", "me")
    assert isinstance(said.exception, BadInput)
    assert "how the sensor sits on the flange" in str(said.exception)


@pytest.mark.parametrize(
    ("options", "says"),
    [
        (["--cell", "ur5e_line", "--accepted-by", "me"], "neither"),
        (["--target", "flexiv", "--accepted-by", "me"], "one of ur, xarm, franka"),
        (["--accepted-by", "  "], "no name"),
        (["--write", "ur5e_line", "--accepted-by", "me"], "driver 'simulated'"),
    ],
)
def test_options_that_contradict_are_refused(cell, tmp_path, options, says):
    said = write(tmp_path, cell, *options)
    assert isinstance(said.exception, BadInput)
    assert says in str(said.exception)


def test_a_name_without_anything_to_write_is_refused(tmp_path):
    file = tmp_path / "answer.json"
    file.write_text(answer(cloud(0), "ur5e_line").model_dump_json())
    said = CliRunner().invoke(app, ["export", str(file), "--target", "ur", "--accepted-by", "me"])
    assert isinstance(said.exception, BadInput)
    assert said.stdout == ""


@pytest.fixture
def xarm_cell(cell: Path) -> Path:
    toml = cell / "cell.toml"
    toml.write_text(toml.read_text().replace('driver = "ur_rtde"', f'driver = "xarm"\nport = {XARM_PORT}').replace('UR5e"\n', 'xArm6"\n'))
    return cell


def test_a_controller_of_ufactory_takes_mass_and_centre_and_the_lost_inertia_is_said(xarm_cell, tmp_path):
    with XarmServer(XarmArm(SIMULATED, seed=1), HOST, port=XARM_PORT) as server:
        said = write(tmp_path, xarm_cell, "--accepted-by", "M. Curie", "--target", "xarm")
        assert said.exit_code == 0, said.output
        np.testing.assert_allclose([server.arm.payload, *server.arm.payload_com], expected()[:4], rtol=1e-6, atol=1e-8)
    assert "accepted by M. Curie" in said.stdout and "Ixx" not in said.stdout
    assert "has no place for Ixx" in said.stderr
    assert "until it is switched off" in said.stderr


def test_a_controller_of_franka_takes_all_ten_and_its_end_effector_is_said_to_count_beside(tmp_path):
    simulated = load_cell(find_cell("lwr4_bench"))
    folder = tmp_path / "lwr4_bench"
    shutil.copytree(simulated.folder, folder)
    text = (folder / "cell.toml").read_text().replace("[15.0, 15.0, 15.0, 15.0, 20.0, 20.0, 20.0]", str([7.5] * 7))
    sensor = 'sensor = { driver = "ati_net_ft", host = "127.0.0.1" }'
    (folder / "cell.toml").write_text(f'{text}\n[session]\ndriver = "franka_fci"\nhost = "{HOST}"\nmodel = "fr3"\n{sensor}\n')
    mount = simulated.sensor.mount
    body = cloud(0).moved(mount.rotation, mount.translation)
    with FrankaServer(FrankaArm(simulated, seed=1), HOST) as server:
        said = write(tmp_path, folder, "--accepted-by", "M. Curie", "--target", "franka", of="lwr4_bench")
        assert said.exit_code == 0, said.output
        arm = server.arm
        np.testing.assert_allclose([arm.mass, *arm.com], [body.masses.sum(), *body.com], rtol=1e-7)
        np.testing.assert_allclose(arm.inertia.reshape(3, 3), body.inertia(body.com), rtol=1e-7, atol=1e-9)
    assert "accepted by M. Curie" in said.stdout
    assert "beside the end effector that is set up in Desk" in said.stderr
    assert "sits between flange and sensor" in said.stderr


def test_the_target_has_to_be_that_of_the_cells_robot(cell, tmp_path):
    said = write(tmp_path, cell, "--accepted-by", "me", "--target", "xarm")
    assert isinstance(said.exception, BadInput)
    assert "expected xarm: a cell whose robot this target is for" in str(said.exception)
