"""The part of URScript that the stand-in of a controller runs."""

import pytest

from core.fakes.urscript import ScriptError, compile_script


def run(text, **functions):
    def wait():
        yield

    return compile_script(text, {"sync": wait, **functions})


def test_a_program_runs_until_it_waits_and_goes_on_in_the_next_period():
    seen = []
    program = run("def p():\n  k = 0\n  while k < 3:\n    note(k)\n    k = k + 1\n    sync()\n  end\n  note(-1)\nend\n", note=seen.append)
    for period in range(3):
        next(program)
        assert seen == list(range(period + 1))
    with pytest.raises(StopIteration):
        next(program)
    assert seen[-1] == -1


def test_branches_end_with_end():
    seen = []
    text = (
        "def p():\n  m = 2 # a remark\n  if m == 1:\n    note(1)\n  elif m == 2:\n    note(2)\n  else:\n    note(3)\n  end\n  sync()\nend\n"
    )
    next(run(text, note=seen.append))
    assert seen == [2]


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("def p():\n  movel()\n  sync()\nend\n", "no such function"),
        ("def p():\n  sync()\n", "without its end"),
        ("def p():\n  a = b.c\n  sync()\nend\n", "Attribute"),
        ("def p():\n  a = (1\n  sync()\nend\n", "line"),
        ("import os\n", "no program"),
        ("def p():\n  k = 1\nend\n", "never waits"),
        ("def p():\n  __import__()\n  sync()\nend\n", "no such function"),
    ],
)
def test_what_the_controller_could_not_run_is_refused(text, says):
    with pytest.raises(ScriptError, match=says):
        run(text)
