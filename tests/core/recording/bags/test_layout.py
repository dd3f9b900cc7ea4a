"""Messages that `rosbags` serialises with all kinds of fields, taken apart here."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

from core.recording.bags.layout import NoLayoutError, find_layout

DEFINITION = f"""bool flag
string name
uint16 short
float64[] many
string[] words
float32[3] three
my_msgs/Inner[] inner
int64 last
{"=" * 80}
MSG: my_msgs/Inner
uint8 tag
float64 value
"""
TYPES = get_types_from_msg(DEFINITION, "my_msgs/msg/Outer")
STORE = get_typestore(Stores.EMPTY)
STORE.register(TYPES)
NUMBERS = st.floats(allow_nan=False, allow_infinity=False, width=32)


def serialise(name: str, many: list[float], words: list[str], inner: list[tuple[int, float]]) -> bytes:
    kinds = STORE.types
    parts = [kinds["my_msgs/msg/Inner"](tag, value) for tag, value in inner]
    three = np.array([1.5, 2.5, 3.5], dtype=np.float32)
    message = kinds["my_msgs/msg/Outer"](True, name, 7, np.array(many), words, three, parts, -5)
    return bytes(STORE.serialize_cdr(message, "my_msgs/msg/Outer"))


def read(content: bytes) -> dict[str, float]:
    layout = find_layout(content, "my_msgs/msg/Outer", TYPES)
    return {each.path: float(np.frombuffer(content, each.kind, 1, each.offset)[0]) for each in layout.numbers}


@settings(max_examples=60, deadline=None)
@given(
    name=st.text(st.characters(exclude_characters="\x00", exclude_categories=["Cs"]), max_size=9),
    many=st.lists(NUMBERS, max_size=5),
    words=st.lists(st.sampled_from(["", "a", "abc", "ünï"]), max_size=3),
    inner=st.lists(st.tuples(st.integers(0, 255), NUMBERS), max_size=3),
)
def test_every_field_is_found_where_it_stands(name: str, many: list[float], words: list[str], inner: list[tuple[int, float]]) -> None:
    content = serialise(name, many, words, inner)
    expected = {"flag": 1.0, "short": 7.0, "last": -5.0, "three[0]": 1.5, "three[1]": 2.5, "three[2]": 3.5}
    expected |= {f"many[{k}]": value for k, value in enumerate(many)}
    for k, (tag, value) in enumerate(inner):
        expected |= {f"inner[{k}].tag": float(tag), f"inner[{k}].value": value}
    assert read(content) == expected
    layout = find_layout(content, "my_msgs/msg/Outer", TYPES)
    assert layout.texts == {"name": name, **{f"words[{k}]": word for k, word in enumerate(words)}}
    assert int((~layout.fixed).sum()) == 1 + 2 + 8 * len(many) + 12 + 9 * len(inner) + 8


@settings(max_examples=100, deadline=None)
@given(end=st.integers(0, 80), at=st.integers(0, 80), value=st.integers(0, 255))
def test_a_message_that_is_cut_or_altered_has_another_layout_or_none(end: int, at: int, value: int) -> None:
    content = bytearray(serialise("name", [1.0, 2.0], ["a"], [(1, 2.0)]))
    content[min(at, len(content) - 1)] = value
    try:
        layout = find_layout(bytes(content[:end]), "my_msgs/msg/Outer", TYPES)
    except NoLayoutError:
        return
    assert all(each.offset + int(each.kind[2]) <= end for each in layout.numbers)


def test_a_picture_is_no_table() -> None:
    with pytest.raises(NoLayoutError):
        find_layout(serialise("", [0.0] * 3000, [], []), "my_msgs/msg/Outer", TYPES)
