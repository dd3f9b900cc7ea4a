"""xacro is expanded, and a hostile file gets nothing that it was not given."""

from __future__ import annotations

from pathlib import Path

import pytest

from core.errors import BadRobot
from core.new_cell import expansion
from core.new_cell.expansion import description_text
from core.new_cell.packages import Packages

HEAD = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'


def expanded(folder: Path, body: str, arguments: dict[str, str] | None = None, given: tuple[Path, ...] = ()) -> str:
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "r.urdf.xacro").write_text(f"{HEAD}{body}</robot>")
    return description_text(Packages(folder / "r.urdf.xacro", given), arguments or {})


def test_macros_arguments_includes_and_packages_are_expanded(tmp_path):
    other = tmp_path / "ws/parts"
    other.mkdir(parents=True)
    (other / "package.xml").write_text("<package/>")
    (other / "size.yaml").write_text("length: 0.25")
    (other / "part.xacro").write_text(f'{HEAD}<xacro:macro name="part" params="n"><link name="${{n}}_${{2 * 3}}"/></xacro:macro></robot>')
    body = (
        '<xacro:arg name="prefix" default="a"/><xacro:include filename="$(find parts)/part.xacro"/>'
        """<xacro:property name="sizes" value="${xacro.load_yaml('$(find parts)/size.yaml')}"/>"""
        '<xacro:part n="$(arg prefix)"/><link name="${sizes.length}"/>'
    )
    text = expanded(tmp_path / "ws/main/urdf", body, {"prefix": "left"})
    assert '<link name="left_6"/>' in text
    assert '<link name="0.25"/>' in text


def test_a_plain_urdf_is_left_as_it_is(tmp_path):
    file = tmp_path / "plain.urdf"
    file.write_text('<robot name="${1 + 1}"/>')
    assert description_text(Packages(file), {}) == file.read_text()
    with pytest.raises(BadRobot, match="plain URDF with --xacro-arg"):
        description_text(Packages(file), {"prefix": "a"})


@pytest.mark.parametrize(
    "body",
    [
        """<link name="$(eval open('/etc/passwd').read())"/>""",
        """<link name="${[x.__class__.__base__.__subclasses__() for x in [1]]}"/>""",
        """<link name="${(lambda: ().__class__)()}"/>""",
        """<link name="${(x for x in [1]).gi_frame.f_back.f_globals}"/>""",
        """<link name="${'{0.__class__}'.format(1)}"/>""",
        """<link name="${xacro.load_yaml('/etc/passwd')}"/>""",
        '<xacro:include filename="/etc/passwd"/>',
        '<xacro:include filename="../outside.xacro"/>',
        '<xacro:include filename="$(find etc)/passwd"/>',
        '<link name="$(env HOME)"/>',
        '<xacro:macro name="m"><xacro:m/></xacro:macro><xacro:m/>',
        "<xacro:unknown/>",
        """<link name="${'a' * 10 ** 10}"/>""",
        "<link",
    ],
)
def test_what_a_xacro_file_may_not_do_is_refused_in_a_sentence(tmp_path, body):
    (tmp_path / "outside.xacro").write_text(f'{HEAD}<link name="secret"/></robot>')
    with pytest.raises(BadRobot) as refused:
        expanded(tmp_path / "main", body)
    assert "xacro" in str(refused.value)
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize(
    ("body", "code"),
    [
        ("""<link name="$(eval 1)"/>""", "xacro-wants-eval"),
        ("""<link name="${[1].__class__}"/>""", "xacro-wants-attribute"),
        ("""<link name="${__name__}"/>""", "xacro-wants-name"),
        ('<link name="$(find nowhere)"/>', "xacro-wants-package"),
        ('<xacro:include filename="../outside.xacro"/>', "xacro-wants-file"),
        (f'<link name="${{{"1 + " * 1000}1}}"/>', "xacro-long-expression"),
    ],
)
def test_what_it_wants_is_a_message(tmp_path, body, code):
    (tmp_path / "outside.xacro").write_text(f'{HEAD}<link name="secret"/></robot>')
    with pytest.raises(BadRobot) as refused:
        expanded(tmp_path / "main", body)
    assert refused.value.message.code == "xacro-unwanted"
    assert refused.value.message.parameters["wanted"].code == code
    assert refused.value.message.parameters["wanted"].text in refused.value.found


def test_one_that_does_not_end_is_ended(tmp_path, monkeypatch):
    monkeypatch.setattr(expansion, "SECONDS", 1.5)
    with pytest.raises(BadRobot, match="not expanded after"):
        expanded(tmp_path, '<link name="${python.sum(x for x in python.range(10 ** 12))}"/>')


@pytest.mark.parametrize("declaration", ['<!DOCTYPE robot [<!ENTITY a "b">]>', '<!ENTITY a SYSTEM "file:///etc/passwd">'])
def test_document_types_and_entities_are_refused(tmp_path, declaration):
    file = tmp_path / "r.urdf"
    file.write_text(f'{declaration}<robot name="r"/>')
    with pytest.raises(BadRobot, match="document type or an entity"):
        description_text(Packages(file), {})
