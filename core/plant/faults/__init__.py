"""Faults that can be planted in the virtual robot: the other half of the blind check.

They are physics (real joints, forces and changes of the MuJoCo model where the fault is mechanical) and share no code and no
shape with the effects that are fitted to recordings. Each identifier of an effect has at least one fault, most have one that is
shaped differently from any textbook model, and some faults are `unknown`: no effect describes them.

`FAULTS` is the registry. A new fault is one class in the file of its family, named in that file's list.
"""

from __future__ import annotations

from core.plant.faults.background import Background
from core.plant.faults.base import BASE
from core.plant.faults.cable import CABLE
from core.plant.faults.contact import CONTACT
from core.plant.faults.dropout import DROPOUT
from core.plant.faults.encoders import ENCODERS
from core.plant.faults.fault import Fault, Setting
from core.plant.faults.joint_gears import JOINT_GEARS
from core.plant.faults.joint_play import JOINT_PLAY
from core.plant.faults.joint_springs import JOINT_SPRINGS
from core.plant.faults.loose import LOOSE
from core.plant.faults.lowpass import LOWPASS
from core.plant.faults.mounting import MOUNTING
from core.plant.faults.payload import PAYLOAD
from core.plant.faults.sensor_memory import SENSOR_MEMORY
from core.plant.faults.sensor_noise import SENSOR_NOISE
from core.plant.faults.sensor_offset import SENSOR_OFFSET
from core.plant.faults.sensor_response import SENSOR_RESPONSE
from core.plant.faults.sensor_saturation import SENSOR_SATURATION
from core.plant.faults.sensor_steps import SENSOR_STEPS
from core.plant.faults.timing import TIMING
from core.plant.faults.unknown_mechanism import UNKNOWN_MECHANISM
from core.plant.faults.unknown_signal import UNKNOWN_SIGNAL
from core.plant.faults.unknown_timing import UNKNOWN_TIMING

__all__ = ["FAULTS", "Background", "Fault", "Setting", "variants"]

FAULTS: tuple[type[Fault], ...] = (
    *SENSOR_OFFSET,
    *SENSOR_RESPONSE,
    *SENSOR_MEMORY,
    *SENSOR_SATURATION,
    *SENSOR_NOISE,
    *SENSOR_STEPS,
    *TIMING,
    *LOWPASS,
    *DROPOUT,
    *MOUNTING,
    *BASE,
    *ENCODERS,
    *JOINT_SPRINGS,
    *JOINT_PLAY,
    *JOINT_GEARS,
    *PAYLOAD,
    *LOOSE,
    *CABLE,
    *CONTACT,
    *UNKNOWN_SIGNAL,
    *UNKNOWN_TIMING,
    *UNKNOWN_MECHANISM,
)
"""All of them, but for `Background`, which goes with any of them."""


def variants(effect: str) -> tuple[type[Fault], ...]:
    """The faults of one effect's identifier, or of "unknown"; empty where there is none."""
    return tuple(fault for fault in FAULTS if fault.id == effect)
