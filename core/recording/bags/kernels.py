"""What is done with every message, compiled."""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

MESSAGE = 0x05
RECORD_HEAD, MESSAGE_HEAD = 9, 22
"""Bytes: opcode and length; channel, sequence, log time and publish time (MCAP specification, Records)."""

Bytes = NDArray[np.uint8]
Integers = NDArray[np.int64]


@njit(cache=True)
def _read(data, at, size):  # type: ignore[no-untyped-def]  # numba infers types
    value = np.int64(0)
    for k in range(size):
        value |= np.int64(data[at + k]) << np.int64(8 * k)
    return value


@njit(cache=True)
def _scan(data, found, write):  # type: ignore[no-untyped-def]  # numba infers types
    at, count = np.int64(0), 0
    while at < len(data):
        if at + RECORD_HEAD > len(data):
            return -1
        size = _read(data, at + 1, 8)
        if size < 0 or size > len(data) - at - RECORD_HEAD:
            return -1
        begin = at + RECORD_HEAD
        if data[at] == MESSAGE and size < MESSAGE_HEAD:
            return -1
        if write and data[at] == MESSAGE:
            found[count, 0] = _read(data, begin, 2)
            found[count, 1] = _read(data, begin + 6, 8)
            found[count, 2] = begin + MESSAGE_HEAD
            found[count, 3] = size - MESSAGE_HEAD
        elif write:
            found[count, 0] = -1
            found[count, 2] = at
            found[count, 3] = RECORD_HEAD + size
        count += 1
        at = begin + size
    return count


def find_records(data: Bytes) -> Integers:
    """The records of a chunk, (M, 4): channel, log time in ns, where the content begins, and its length.

    Of a record that is no message the channel is -1, and it begins with its opcode.

    Raises:
        ValueError: a record is longer than the chunk.
    """
    count = _scan(data, np.empty((0, 4), dtype=np.int64), False)
    if count < 0:
        raise ValueError("a record that is longer than its chunk")
    found = np.zeros((count, 4), dtype=np.int64)
    _scan(data, found, True)
    return found


@njit(cache=True)
def find_alike(data, begins, sizes, content, fixed):  # type: ignore[no-untyped-def]  # numba infers types
    """Which of the messages (M,) have the bytes of `content` (L,) wherever `fixed` (L,) says so."""
    alike = np.zeros(len(begins), dtype=np.bool_)
    for m in range(len(begins)):
        if sizes[m] != len(content):
            continue
        same = True
        for k in range(len(content)):
            if fixed[k] and data[begins[m] + k] != content[k]:
                same = False
                break
        alike[m] = same
    return alike


@njit(cache=True)
def copy_bytes(data, begins, offset, size):  # type: ignore[no-untyped-def]  # numba infers types
    """(M, size) bytes from `offset` on in each of the messages."""
    out = np.empty((len(begins), size), dtype=np.uint8)
    for m in range(len(begins)):
        for k in range(size):
            out[m, k] = data[begins[m] + offset + k]
    return out
