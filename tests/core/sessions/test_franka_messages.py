"""States of Franka's controllers as bytes, packed here by the published order of their numbers."""

import struct

import numpy as np
import pytest

from core.sessions.franka_messages import FrankaError, read_state


def pack(code: str, accelerometers: int) -> bytes:
    numbers = np.arange(284) / 8.0
    tail = bytes([1, 0, *[k == 25 for k in range(41)], *[0] * 41, 4])
    return (
        struct.pack(f"<Q284{code}", 2**40 + 5, *numbers)
        + struct.pack(f"<{accelerometers}{code}", *[9.0] * accelerometers)
        + tail
        + (struct.pack(f"<{code}", 0.5))
    )


@pytest.mark.parametrize(("code", "accelerometers", "length"), [("d", 0, 2373), ("f", 36, 1377), ("d", 36, 2661), ("f", 0, 1233)])
def test_the_length_of_a_state_tells_its_precision(code, accelerometers, length):
    data = pack(code, accelerometers)
    assert len(data) == length
    found = read_state(data)
    assert (found.number, found.mode, found.motion, found.controller) == (2**40 + 5, 4, 1, 0)
    assert found.error_names() == ["communication_constraints_violation"]
    np.testing.assert_array_equal(found.q, np.arange(147, 154) / 8.0)
    np.testing.assert_array_equal(found.ddq_d, np.arange(175, 182) / 8.0)
    np.testing.assert_array_equal(found.pose[:, 3], np.arange(12, 16) / 8.0)
    np.testing.assert_array_equal(found.load, np.arange(109, 122) / 8.0)
    assert found.end_effector_kg == 96 / 8.0


@pytest.mark.parametrize("data", [b"", bytes(1377)[:-1], struct.pack("<Q284d", 1, *[np.nan] * 284) + bytes(93)])
def test_what_is_no_state_is_refused(data):
    with pytest.raises(FrankaError):
        read_state(data)
