"""`core.effects.parameter_title`: every parameter has a name for people, in both languages."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from core.effects.library import library, symptoms, wider_shapes
from core.effects.parameter_title import find_title
from core.words.message import Message
from tests.core.effects.planted_mechanics import scene
from tests.core.effects.test_joint_friction import friction, recording


@pytest.mark.parametrize(
    ("name", "english", "german"),
    [
        ("joint_3_gear_ratio", "joint 3 gear ratio", "Gelenk 3 Übersetzung"),
        ("mode_2_frequency_hz", "mode 2 frequency", "Mode 2 Frequenz"),
        ("jump_2_fx_n", "jump 2 fx", "Sprung 2 fx"),
        ("delay_s", "delay", "Verzögerung"),
        ("joint_1_coulomb_nm", "joint 1 Coulomb friction", "Gelenk 1 Coulombsche Reibung"),
        ("joint_2_rad_per_nm", "joint 2", "Gelenk 2"),
        ("place_x_m", "place x", "Ort x"),
        ("fx_from_ty_n_per_nm", "fx from ty", "fx aus ty"),
        ("mc_x_difference_kgm", "mc x difference", "mc x Differenz"),
        ("m_difference_kg", "m difference", "m Differenz"),
        ("mass_kg", "mass", "Masse"),
        ("nobody_knows_it_n", "nobody knows it", "nobody knows it"),
    ],
)
def test_a_title_is_put_together_from_what_it_is_of_what_and_along_which_axis(name: str, english: str, german: str) -> None:
    assert (find_title(name).text, find_title(name).say("de")) == (english, german)


def test_every_piece_of_a_parameters_name_has_words() -> None:
    named = {p.name for effect in (*library(), *wider_shapes()) for p in effect.parameters(scene())}
    named |= {p.name for symptom in symptoms() for p in symptom.parameters(recording(friction()))}
    unworded = {name for name in named for each in leaves(find_title(name)) if each.code == "text" and each.text not in SYMBOLS}
    assert unworded == set()


SYMBOLS = {
    *(str(k) for k in range(1, 41)), *"xyz", "xx", "xy", "xz", "yy", "yz", "zz", "fx", "fy", "fz", "tx", "ty", "tz",
    "m", "mc x", "mc y", "mc z", "ixx", "ixy", "ixz", "iyy", "iyz", "izz",
}  # fmt: skip


def leaves(title: Message) -> Iterator[Message]:
    inner = [each for each in title.parameters.values() if isinstance(each, Message)]
    for each in inner:
        yield from leaves(each)
    if not inner:
        yield title
