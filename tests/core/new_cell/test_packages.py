"""Files that a description names are found where they may be, and nowhere else."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.errors import BadRobot
from core.new_cell.packages import Packages

MOST = 1000


@pytest.fixture
def place(tmp_path: Path) -> Path:
    """A workspace with the description's package, another package, a folder that is none, and a secret beside them."""
    (tmp_path / "far/src/arm/urdf").mkdir(parents=True)
    (tmp_path / "far/src/arm/meshes").mkdir()
    (tmp_path / "far/src/hand/meshes").mkdir(parents=True)
    (tmp_path / "far/src/plain").mkdir()
    (tmp_path / "far/src/hand/package.xml").write_text("<package/>")
    for file in ("arm/meshes/a.stl", "hand/meshes/b.stl", "plain/c.stl", "arm/urdf/d.stl"):
        (tmp_path / "far/src" / file).write_text("solid")
    (tmp_path / "secret.stl").write_text("secret")
    return tmp_path / "far/src"


def packages(place: Path, *given_paths: Path) -> Packages:
    return Packages(place / "arm/urdf/arm.urdf", given_paths)


@pytest.mark.parametrize(
    ("name", "file"),
    [("package://arm/meshes/a.stl", "arm/meshes/a.stl"), ("package://hand/meshes/b.stl", "hand/meshes/b.stl"), ("d.stl", "arm/urdf/d.stl")],
)
def test_a_package_is_found_above_the_description_and_beside_it(place, name, file):
    assert packages(place).file(name, "mesh", MOST) == place / file


def test_a_given_folder_opens_what_is_no_package_by_itself(place):
    with pytest.raises(BadRobot, match="no such package"):
        packages(place).file("package://plain/c.stl", "mesh", MOST)
    assert packages(place, place).file("package://plain/c.stl", "mesh", MOST) == place / "plain/c.stl"
    assert packages(place, place / "plain").file("package://plain/c.stl", "mesh", MOST) == place / "plain/c.stl"
    assert packages(place, place).file(f"file://{place}/plain/c.stl", "mesh", MOST) == place / "plain/c.stl"


@pytest.mark.parametrize(
    "name",
    [
        "package://arm/../../../secret.stl",
        "package://arm/%2e%2e/%2e%2e/%2e%2e/secret.stl",
        "../meshes/a.stl",
        "/etc/passwd",
        "file:///etc/passwd",
        "package:///etc/passwd",
        "package://etc/passwd",
        "package://../secret.stl",
        "package://./secret.stl",
        "http://example.org/a.stl",
        "..\\a.stl",
        "d.stl\0",
        "package://arm/meshes",
        "package://arm/meshes/no.stl",
        "link.stl",
    ],
)
def test_what_leads_elsewhere_or_is_no_file_is_refused(place, name):
    (place / "arm/urdf/link.stl").symlink_to(place.parent.parent / "secret.stl")
    with pytest.raises(BadRobot):
        packages(place).file(name, "mesh", MOST)


def test_a_file_that_is_too_large_is_refused(place):
    with pytest.raises(BadRobot, match="at most 3"):
        packages(place).file("d.stl", "mesh", 3)


@given(
    name=st.text(alphabet="./\\%2ea:pckg\0~$", max_size=30),
    scheme=st.sampled_from(["", "package://", "package://arm/", "file://", "file:///"]),
)
def test_whatever_the_name_nothing_outside_is_found(tmp_path_factory, name, scheme):
    folder = tmp_path_factory.getbasetemp() / "hostile/arm/urdf"
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "a").write_text("solid")
    looked = Packages(folder / "arm.urdf")
    try:
        found = looked.file(scheme + name, "mesh", MOST)
    except BadRobot:
        return
    assert found.is_relative_to(folder.parent)
