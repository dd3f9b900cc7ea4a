"""A reader's end is a sentence about the file that it read, never the end of the program."""

from __future__ import annotations

import os

import pytest

from core.errors import BadRobot
from core.files.confinement import ask
from core.words.message import Message
from tests.core.files.ending_reader import answer


def orders(*wishes: str) -> list[dict[str, object]]:
    return [{"do": wish, "number": k, "where": f"mesh {k}"} for k, wish in enumerate(wishes)]


def test_answers_come_in_the_order_of_the_questions_from_another_process() -> None:
    found = ask(answer, orders("answer", "answer", "answer"))
    assert [arrays[0].tolist() for arrays in found] == [[0], [1], [2]]
    assert found[2][1].tolist() == [[1.0, 0.0], [0.0, 1.0]]
    assert ask(answer, []) == []


@pytest.mark.parametrize(
    ("wish", "words"), [("refuse", "found 7 triangles, expected at most 3"), ("crash", "its reader ended"), ("take memory", "1.5 GB")]
)
def test_the_file_that_cannot_be_read_is_named_whatever_happens_to_its_reader(wish: str, words: str) -> None:
    before = os.getpid()
    with pytest.raises(BadRobot, match=f"^mesh 1: .*{words}"):
        ask(answer, orders("answer", wish, "answer"))
    assert os.getpid() == before


def test_a_refusal_comes_back_as_the_code_with_parameters_that_it_was() -> None:
    with pytest.raises(BadRobot) as caught:
        ask(answer, orders("refuse"))
    assert caught.value.message == Message.of("mesh-too-many-triangles", where="mesh 0", triangles=7, most=3)
