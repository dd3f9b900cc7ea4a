"""The report: one file that needs nothing else, and says what was found, what was not, and why."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest

from core.cell.folder import load_cell
from core.estimation.budget import Budget, Source
from core.estimation.estimate import DriftEstimate, Estimate, Identification, JointTorque, PaperEstimate, TimeSeries
from core.estimation.segments import segments_of_phase
from core.payload.inertia import Motion
from core.payload.rigid_wrench import wrench
from core.planning.start_configuration import StartConfiguration
from core.planning.throw import Throw
from core.procedure.summary import RunSummary
from core.recording.recording import Recording, SensorDescription
from core.report import page
from core.report.charts import POINTS, decimate
from core.report.page import write_report
from core.report.rows import facts, parameter_rows, round_to_uncertainty
from core.words.message import Message

CELL = load_cell(Path(__file__).parents[3] / "cells" / "lwr4_bench")
PHI = CELL.payloads["steel_block"].parameters.phi
N = 1200


def motion() -> tuple[np.ndarray, Motion, np.ndarray]:
    """A hold, a rotation about x and one about z."""
    t = np.linspace(0, 12, N)
    phase = np.full(N, "hold:x+")
    phase[400:600], phase[800:1000] = "rotate:x", "rotate:z"
    omega = np.zeros((N, 3))
    omega[400:600, 0] = omega[800:1000, 2] = np.sin(np.linspace(0, 2 * np.pi, 200))
    alpha = np.gradient(omega, t, axis=0)
    return t, Motion(np.tile([9.81, 0, 0], (N, 1)), np.zeros((N, 3)), omega, alpha), phase


@cache
def case() -> tuple[Recording, Identification, RunSummary]:
    t, kinematics, phase = motion()
    noise = np.array(CELL.sensor.noise_std)
    reconstructed = wrench(kinematics, PHI)
    measured = reconstructed + np.random.default_rng(0).normal(size=(N, 6)) * noise
    std = np.array([1e-3, 1e-5, 1e-5, 1e-5, *[2e-5] * 6])
    budget = Budget(np.diag((0.6 * std) ** 2), (Source("sensor_gain", stated=False, directions=np.diag(0.8 * std)),))
    estimate = Estimate(
        phi=PHI + 1.1 * std,
        covariance=np.diag(std**2),
        determined=np.full(10, True),
        reasons={},
        offset=np.arange(6.0),
        offset_std=np.full(6, 0.01),
        consistent=True,
        residual_rms=noise * [1, 1, 1, 1, 2.5, 1],
        noise_std=noise,
        drift=DriftEstimate(t[[0, -1]], np.zeros((2, 6)), np.full(6, 0.1)),
        budget=budget,
        base_tilt_rad=np.radians([0.5, -0.25]),
        base_tilt_std=np.radians([0.01, 0.01]),
        delay_s=0.004,
        delay_std=0.0001,
    )
    products = np.isin(np.arange(10), [5, 6, 8])
    paper = PaperEstimate(np.where(products, np.nan, PHI * 1.01), np.where(products, np.nan, 1e-4), np.zeros(6))
    identification = Identification(
        paper,
        estimate,
        Message.of("text", text="The payload weighs 2.784 kg."),
        (Message.of("text", text="Channel ty is louder than its noise."),),
        segments_of_phase(phase),
        drawn=lambda: TimeSeries(t, kinematics, measured, reconstructed),
    )
    q = np.zeros((N, 7))
    recording = Recording(
        t=t,
        gravity=CELL.gravity,
        wrench=measured,
        q=q,
        phase=phase,
        sensor=SensorDescription(noise_std=noise),
        reference=CELL.payloads["steel_block"].parameters,
        reference_source="CAD",
        cell="lwr4_bench",
        payload="steel_block",
    )
    home = np.array(CELL.robot.home_rad)
    throw = Throw("operator", 0.42, 0.2, 0.31)
    starts = tuple(
        StartConfiguration(axis, home, 0.5, 0.123, 0.077, "bench", 0.04, throw if axis[1] == "+" else None, 99)
        for axis in ("x-", "x+", "y-", "y+", "z-", "z+")
    )
    box = CELL.payloads["steel_block"].box
    distance = 0.1 + 0.05 * np.sin(t)
    run = RunSummary(CELL, "steel_block", box, starts, t, distance, 0.05, "bench", 0.21, 0, 5.5, 12.0, 1.25, 7)
    return recording, identification, run


def written(tmp_path: Path, recording: Recording, identification: Identification, run: RunSummary | None) -> str:
    write_report(tmp_path / "report.html", recording=recording, identification=identification, run=run)
    return (tmp_path / "report.html").read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> str:
    """The page of a whole run."""
    folder = tmp_path_factory.mktemp("whole")
    text = written(folder, *case())
    assert [file.name for file in folder.iterdir()] == ["report.html"]
    return text


def words(text: str) -> str:
    """What a person reads."""
    text = re.sub(r"<style>.*?</style>", "", text, flags=re.DOTALL)
    return " ".join(re.sub(r"<[^>]*>", " ", text).split())


class Balanced(HTMLParser):
    """Fails on a tag that is closed twice, or never."""

    VOID = ("meta", "br", "link")

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.attributes: list[tuple[str, str, str]] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.attributes += [(tag, name, value or "") for name, value in attrs]
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.attributes += [(tag, name, value or "") for name, value in attrs]

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


def test_the_page_is_one_well_formed_file_that_loads_nothing(whole: str) -> None:
    text = whole
    parser = Balanced()
    parser.feed(text)
    parser.close()
    assert parser.open == []
    assert "<script" not in text and "@import" not in text
    targets = [value for _, name, value in parser.attributes if name in ("src", "href", "xlink:href")]
    assert all(target.startswith("#") for target in targets)
    assert not [value for _, _, value in parser.attributes if re.search(r"url\((?!#)", value)]
    assert len(text.encode()) < 3_000_000


def test_the_page_says_what_was_found_and_how_safe_it_was(whole: str) -> None:
    text = words(whole)
    for said in (
        "The payload weighs 2.784 kg.",
        "Channel ty is louder than its noise.",
        "2.7841 kg",
        "± 0.0020 kg (95 %)",
        "Reference: CAD",
        "+0.500°, -0.250°",
        "+4.00 ms",
        "Smallest distance 0.050 m to bench; limit 0.030 m",
        "Largest speed 0.210 m/s",
        "a load that comes off passes operator at 0.42 m",
        "0.123 m clear, 0.077 m in the rotation (nearest: bench)",
        "Planning 5.5 s",
        "Seed 7",
        "safety_rated: false",
        "is not a safety function",
    ):
        assert said in text


def test_colour_is_only_where_something_is_abnormal(whole: str, tmp_path: Path) -> None:
    recording, identification, run = case()
    alarms = re.findall(r'<(?:td|dd) class="alarm">(.*?)</', whole)
    assert alarms == ["2.50"]  # the loud channel's ratio, nothing else
    slow = replace(run, max_speed_m_s=0.3, restarts=2, min_distance_m=0.01)
    alarms = re.findall(r'<dd class="alarm">(.*?)<', written(tmp_path, recording, identification, slow))
    assert alarms == ["0.010 m", "0.300 m/s", "2"]


def test_what_is_not_determined_is_no_number_and_has_its_reason(tmp_path: Path) -> None:
    recording, identification, _ = case()
    estimate = identification.estimate
    assert estimate is not None
    lacking = np.arange(10) >= 4
    names = ("Ixx", "Ixy", "Ixz", "Iyy", "Iyz", "Izz")
    still = replace(
        estimate,
        phi=np.where(lacking, np.nan, estimate.phi),
        covariance=np.where(lacking | lacking[:, None], np.nan, estimate.covariance),
        determined=~lacking,
        reasons=dict.fromkeys(names, Message.of("estimation-standing")),
    )
    text = words(written(tmp_path, recording, replace(identification, estimate=still), None))
    assert text.count("not determined") == 6
    assert text.count("static poses only: the inertia is not excited") == 6
    assert "Principal moments" not in text
    assert "nan" not in text.lower()


def test_a_recording_without_a_wrench_is_answered_in_words(tmp_path: Path) -> None:
    recording, _, _ = case()
    nothing = PaperEstimate(np.full(10, np.nan), np.full(10, np.nan), np.full(6, np.nan))
    bare = Identification(
        nothing,
        None,
        Message.of("text", text="No wrench was recorded."),
        joints=(JointTorque("elbow", 3.25, 1.5, 0.031, 0.04, 0.027, 120),),
    )
    recording = replace(recording, wrench=None, tau=np.zeros((N, 7)), reference=None)
    text = words(written(tmp_path, recording, bare, None))
    assert "elbow" in text and "3.25" in text and "3.1 ± 7.8" in text
    assert "joint torques with joint positions" in text
    assert "nan" not in text.lower()


def test_single_poses_are_drawn_as_points(tmp_path: Path) -> None:
    recording, identification, _ = case()
    series = identification.series
    assert series is not None and series.measured is not None and series.reconstructed is not None
    rows = np.arange(0, N, 50)
    few = TimeSeries(series.t[rows], series.motion[rows], series.measured[rows], series.reconstructed[rows])
    recording = replace(recording, t=few.t, wrench=few.measured, q=None, phase=None)
    text = written(tmp_path, recording, replace(identification, drawn=lambda: few, segments=()), None)
    assert "<use" in text
    assert "Rotations" not in words(text)


def test_words_from_outside_stay_words(tmp_path: Path) -> None:
    recording, identification, run = case()
    attack = "<script>alert(1)</script>"
    cell = CELL.model_copy(update={"title": attack})
    text = written(
        tmp_path,
        replace(recording, source=attack, reference_source=attack),
        replace(identification, verdict=Message.of("text", text=attack), warnings=(Message.of("text", text=attack),)),
        replace(run, cell=cell, payload=attack, nearest=attack),
    )
    assert "<script" not in text
    assert text.count("&lt;script&gt;alert(1)") >= 6


def test_a_report_that_fails_leaves_the_older_one(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "report.html").write_text("the older one")

    def fail(*_: object) -> Iterator[str]:
        raise RuntimeError("no charts today")

    monkeypatch.setattr(page, "wrench_chart", fail)
    recording, identification, run = case()
    with pytest.raises(RuntimeError):
        write_report(tmp_path / "report.html", recording=recording, identification=identification, run=run)
    assert (tmp_path / "report.html").read_text() == "the older one"
    assert len(list(tmp_path.iterdir())) == 1


def test_the_same_answer_gives_the_same_page(whole: str, tmp_path: Path) -> None:
    assert written(tmp_path, *case()) == whole


def test_a_long_line_keeps_its_extremes() -> None:
    random = np.random.default_rng(1)
    t = np.arange(123_457.0)
    values = random.normal(size=len(t))
    values[77_777], values[5] = 50.0, -40.0
    x, y = decimate(t, values)
    assert len(x) <= POINTS
    assert (np.diff(x) > 0).all()
    assert (y.max(), y.min()) == (50.0, -40.0)
    np.testing.assert_array_equal(y, values[x.astype(int)])


@pytest.mark.parametrize(
    ("value", "uncertainty", "text"),
    [
        (2.78314159, 0.0021, "2.7831"),
        (-0.046821, 1.4e-6, "-0.0468210"),
        (1234.5, 20, "1234"),
        (0.0, 0.1, "0.00"),
        (3.14159265, None, "3.1416"),
        (float("nan"), 0.1, ""),
        (1.0, float("nan"), "1"),
    ],
)
def test_a_value_has_the_digits_that_its_uncertainty_leaves(value: float, uncertainty: float | None, text: str) -> None:
    assert round_to_uncertainty(value, uncertainty) == text


def test_a_reference_outside_the_interval_is_marked_and_one_inside_is_not() -> None:
    recording, identification, _ = case()
    assert not any(row.outside for row in parameter_rows(identification, recording.reference))
    estimate = identification.estimate
    assert estimate is not None
    wrong = replace(identification, estimate=replace(estimate, phi=PHI + 2.1 * estimate.std))
    assert all(row.outside for row in parameter_rows(wrong, recording.reference))
    assert not any(row.outside for row in parameter_rows(wrong, None))


def test_a_cell_with_nothing_to_keep_away_from_has_no_distance(tmp_path: Path) -> None:
    recording, identification, run = case()
    empty = CELL.model_copy(update={"obstacles": (), "zones": ()})
    alone = replace(run, cell=empty, distance_m=np.full(N, np.inf), min_distance_m=None, nearest=None, starts=())
    assert "distance" not in words(written(tmp_path, recording, identification, alone)).partition("How this came about")[0].lower()


def test_facts_need_no_run() -> None:
    _, identification, run = case()
    names = [fact.name for fact in facts(identification, None)]
    assert names == ["Mass", "Centre of mass", "Principal moments", "Tilt of the base", "Delay of the wrench"]
    assert [fact.name for fact in facts(identification, run)][5:] == ["Smallest distance", "Largest speed", "Restarts"]


def fine_mesh(file: Path, count: int) -> None:
    """A binary STL of a capsule-like body with about so many triangles."""
    around, along = 200, count // 400
    angle, height = np.meshgrid(np.linspace(0, 2 * np.pi, around), np.linspace(-1, 1, along))
    radius = 0.06 * np.sqrt(1.0 - 0.9 * height**2)
    p = np.stack([radius * np.cos(angle), radius * np.sin(angle), 0.12 * height], axis=-1).astype("<f4")
    quads = [np.stack([p[:-1, :-1], p[:-1, 1:], p[1:, 1:]], axis=2), np.stack([p[:-1, :-1], p[1:, 1:], p[1:, :-1]], axis=2)]
    triangles = np.concatenate([each.reshape(-1, 3, 3) for each in quads])
    rows = np.zeros(len(triangles), dtype=[("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("more", "<u2")])
    rows["corners"] = triangles
    file.write_bytes(bytes(80) + np.uint32(len(rows)).tobytes() + rows.tobytes())


def test_a_robot_of_fine_meshes_makes_a_page_that_is_hardly_larger(whole: str, tmp_path: Path) -> None:
    """Each mesh is read once: the page has six scenes."""
    fine_mesh(tmp_path / "body.stl", 40_000)
    urdf = (CELL.folder / "robot.urdf").read_text()
    shape = re.compile(r"<geometry>.*?</geometry>", re.DOTALL)
    (tmp_path / "robot.urdf").write_text(shape.sub('<geometry><mesh filename="body.stl"/></geometry>', urdf))
    recording, identification, run = case()
    assert run is not None
    meshed = CELL.model_copy(update={"folder": tmp_path})
    meshed.__dict__.pop("urdf", None)
    text = written(tmp_path, recording, identification, replace(run, cell=meshed))
    assert text.count('class="arm"') <= 2 * whole.count('class="arm"')
    assert len(text.encode()) <= 2 * len(whole.encode())
    assert len(text.encode()) <= 2_000_000
    assert text.count('class="arm"') > 100
