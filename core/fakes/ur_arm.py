"""The controller of a Universal Robots arm, and the virtual robot as its arm: registers, safety, the program that runs."""

from __future__ import annotations

import math
from collections.abc import Callable, Generator
from contextlib import suppress

import numpy as np
from scipy.spatial.transform import Rotation

from core.array import Array
from core.cell.cell import Cell
from core.fakes.moved_arm import MovedArm
from core.fakes.urscript import ScriptError, compile_script, run_secondary
from core.payload.inertia import InertialParameters

PERIOD = 0.002
NORMAL, PROTECTIVE, EMERGENCY, FAULT = 1, 3, 7, 9
STOPPED, PLAYING = 1, 2
LIMIT = 2 * math.pi
JOINT_SPEED = math.pi
LARGEST_INERTIA = 133.0
"""Of an entry, kg m2."""


class UrArm(MovedArm):
    """What the controller knows and does. Arguments as of any arm."""

    def __init__(self, cell: Cell, payload: InertialParameters | None = None, seed: int = 0) -> None:
        super().__init__(cell, payload, seed, PERIOD)
        self._mount = cell.sensor.mount
        self.model, self.serial, self.version = "UR5", "20245500123", (5, 17, 3, 0)
        self.remote, self.speed_fraction, self.safety_mode, self.robot_mode = True, 1.0, NORMAL, 7
        self.tcp_offset = np.array([0.0, 0.0, 0.1, 0.0, 0.3, 0.0])
        self.payload, self.payload_com, self.payload_inertia = 0.0, np.zeros(3), np.zeros(6)
        self.zeroed = 0
        """How often the force/torque sensor was zeroed; the raw wrench, which is all that is told of it here, does not show that."""
        self.inputs: dict[str, float] = {}
        self.outputs: dict[str, float] = {}
        self.input_age: dict[str, float] = {}
        self._program: Generator[None, None, None] | None = None
        self._watchdog: tuple[str, float] | None = None
        self._number = -1.0

    @property
    def playing(self) -> bool:
        """Whether a program runs."""
        return self._program is not None

    def run(self, text: str) -> None:
        """Ends what runs and begins this program; one that cannot be run does not begin. A secondary program runs beside what runs."""
        if text.lstrip().startswith("sec "):
            if self.remote:
                with suppress(ScriptError):
                    run_secondary(text, {"set_target_payload": self._set_payload})
            return
        self.end_program()
        functions: dict[str, Callable[..., object]] = {
            "read_input_integer_register": lambda k: int(self.inputs.get(f"input_int_register_{k}", 0)),
            "read_input_float_register": lambda k: float(self.inputs.get(f"input_double_register_{k}", 0.0)),
            "write_output_integer_register": lambda k, value: self._write(f"output_int_register_{k}", value),
            "rtde_set_watchdog": self._set_watchdog,
            "servoj": self._servo,
            "stopj": self._stop,
            "sync": self._sync,
        }
        if self.safety_mode != NORMAL or self.robot_mode != 7:
            return
        try:
            self._program = compile_script(text, functions)
        except ScriptError:
            self._program = None

    def end_program(self) -> None:
        """The program ends; the robot brakes."""
        self._program = self._watchdog = None
        self._brake()

    def stop_safely(self, mode: int) -> None:
        """A safety stop: the robot brakes, the program ends."""
        self.safety_mode = mode
        self.end_program()

    def take(self, name: str, value: float) -> None:
        """An input register is written."""
        self.inputs[name] = value
        self.input_age[name] = 0.0

    def step(self) -> None:
        """One period."""
        for name in self.input_age:
            self.input_age[name] += PERIOD
        if self._watchdog is not None and self.input_age.get(self._watchdog[0], 0.0) > self._watchdog[1]:
            self.end_program()
        before = self.target
        if self._program is not None:
            try:
                next(self._program)
            except StopIteration:
                self.end_program()
        if self._program is None and self._braking:
            self.target = self._braking.pop(0)
        self._move(before)

    def report(self) -> dict[str, object]:
        """Every output of RTDE that is had here, by name."""
        sample = self.samples[-1]
        position, rotation = self.flange(sample.q)
        tool = rotation @ Rotation.from_rotvec(self.tcp_offset[3:]).as_matrix()
        place = position + rotation @ self.tcp_offset[:3]
        order = self.order
        return {
            "timestamp": self.t,
            "actual_q": sample.q[order],
            "actual_qd": sample.dq[order],
            "target_q": self.target[order],
            "target_qd": (self.target - self.last)[order] / PERIOD,
            "actual_TCP_pose": np.concatenate([place, Rotation.from_matrix(tool).as_rotvec()]),
            "tcp_offset": self.tcp_offset,
            "ft_raw_wrench": self._wrench_on_flange(sample.wrench),
            "robot_mode": self.robot_mode,
            "safety_mode": self.safety_mode,
            "runtime_state": PLAYING if self.playing else STOPPED,
            "speed_scaling": self.speed_fraction,
            "payload": self.payload,
            "payload_cog": self.payload_com,
            "payload_inertia": self.payload_inertia,
            **self.outputs,
        }

    def _wrench_on_flange(self, wrench: Array) -> Array:
        """What the load exerts on the flange, from what the sensor exerts on the load in its own frame."""
        force, torque = wrench[:3], wrench[3:]
        if self._mount is not None:
            force, torque = self._mount.rotation @ force, self._mount.rotation @ torque
            torque = torque + np.cross(self._mount.translation, force)
        return -np.concatenate([force, torque])

    def _write(self, name: str, value: float) -> None:
        self.outputs[name] = value

    def _set_payload(self, m: float, cog: list[float], inertia: list[float] | None = None, transition_time: float = 0.0) -> None:
        """Refuses what the manual says raises an exception; zeroes the force/torque sensor again."""
        del transition_time
        given = [0.0] * 6 if inertia is None else inertia
        numbers = [m, *cog, *given]
        if len(cog) != 3 or len(given) != 6 or not all(math.isfinite(x) for x in numbers):
            raise ScriptError("not a payload")
        if m < 0.0 or min(given[:3]) < 0.0 or max(map(abs, given)) > LARGEST_INERTIA:
            raise ScriptError("a payload that no robot carries")
        self.payload, self.payload_com, self.payload_inertia = m, np.array(cog), np.array(given)
        self.zeroed += 1

    def _set_watchdog(self, name: str, min_frequency: float, action: str = "pause") -> None:
        self._watchdog = None if action == "ignore" else (name, 1.0 / min_frequency)
        self.input_age[name] = 0.0

    def _servo(self, q: list[float], a: float, v: float, t: float, lookahead_time: float, gain: float) -> Generator[None, None, None]:
        """Goes toward q, smoothed as far ahead and as stiffly as it is told, scaled by the speed slider; `a` and `v` count for nothing."""
        del a, v
        number = self.inputs.get("input_int_register_24", 0.0)
        self.periods_followed += 1
        self.missed += self.moves and number == self._number
        self._number = number
        wanted = np.empty_like(self.target)
        wanted[self.order] = q
        share = 1.0 - math.exp(-t * gain / (150.0 * lookahead_time))
        step = np.clip(share * (wanted - self.target), -JOINT_SPEED * t, JOINT_SPEED * t)
        close = np.abs(wanted - self.target) < 1e-9
        self.target = np.where(close, wanted, self.target + step * self.speed_fraction)
        self._braking = []
        yield

    def _stop(self, a: float) -> Generator[None, None, None]:
        """Brakes; goes on once the robot stands."""
        self._brake(a)
        while self._braking:
            self.target = self._braking.pop(0)
            yield

    def _sync(self) -> Generator[None, None, None]:
        yield
