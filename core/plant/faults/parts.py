"""A payload taken to pieces."""

from __future__ import annotations

import math

import mujoco
import numpy as np

from core.errors import BadPayload
from core.payload.inertia import InertialParameters
from core.plant.mechanics import get_parameters, set_parameters
from core.words.message import Message


def scale_mass(parameters: InertialParameters, share: float) -> InertialParameters:
    """The same shape with a share of the mass."""
    return InertialParameters(share * parameters.phi)


def size_of(payload: InertialParameters) -> float:
    """Radius of gyration about the centre of mass, m.

    Raises:
        BadPayload: an empty hand, of which no part can be loose, slip or come off.
    """
    if not payload.mass > 0:
        raise BadPayload(Message.of("plant-payload-with-fault"), "plant-no-mass")
    return math.sqrt(0.5 * float(np.trace(payload.inertia_com)) / payload.mass)


def split_off(spec: mujoco.MjSpec, name: str, share: float, *, compactness: float = 0.5) -> mujoco.MjsBody:
    """Takes a part with a share of the mass out of the middle of the payload, and makes it a body of its own that hangs at the payload's
    centre of mass, without a joint. Together they are what the payload was.

    Args:
        compactness: share of the part's inertia about its centre that it takes along; the payload's shape gives the rest of the axes.

    Returns:
        The part, its frame at the centre of mass with the payload's axes.

    Raises:
        BadPayload: an empty hand.
    """
    body = spec.body("payload")
    whole = get_parameters(body)
    size_of(whole)
    inertia = share * compactness * whole.inertia_com
    part = body.add_body(name=name, pos=whole.com)
    set_parameters(part, InertialParameters.from_com(share * whole.mass, np.zeros(3), inertia))
    set_parameters(body, InertialParameters.from_com((1 - share) * whole.mass, whole.com, whole.inertia_com - inertia))
    return part
