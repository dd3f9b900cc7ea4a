"""A reader that answers, refuses, or is ended by what it reads, as it is told to."""

from __future__ import annotations

import os
import signal

import numpy as np

from core.errors import BadRobot
from core.files.confinement import Arrays, Order, answer_orders


def answer(order: Order) -> Arrays:
    match order["do"]:
        case "refuse":
            raise BadRobot(order["where"], "mesh-too-many-triangles", triangles=7, most=3)
        case "crash":
            os.kill(os.getpid(), signal.SIGSEGV)
        case "take memory":
            return [np.ones(10**12)]
    return [np.array([order["number"]]), np.eye(2)]


if __name__ == "__main__":
    answer_orders(answer)
