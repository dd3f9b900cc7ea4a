"""The arm and its payload as a MuJoCo model, built in memory; no file is read."""

from __future__ import annotations

from dataclasses import dataclass

import mujoco
import numpy as np
from scipy.spatial.transform import Rotation

from core.array import Array
from core.payload.inertia import InertialParameters
from core.plant.arm import Arm
from core.plant.principal import principal_inertia

PERIOD = 0.001
"""Step of the simulation and period of the joint controller, s."""

NOTHING = InertialParameters(np.zeros(10))

SPRING = ":spring"
"""A second hinge of an arm's body on the axis of its joint: the joint's name and this. The joint is then the motor's."""

SOFT = 0.2
"""Share of a joint's acceleration that dry friction takes away before it breaks loose (MuJoCo's impedance). Low, as in
drives that dither or compensate their friction: with a stiff value the arm creeps for seconds on arrival."""


@dataclass(frozen=True)
class Drives:
    """Mechanical properties of geared drives, in proportion to each joint's torque limit.

    The defaults are of the size that published identifications of collaborative arms (LWR 4+, UR5e, Panda) find: for a
    joint of 176 N m, 2.6 kg m2 of rotor inertia behind the gear, 8.8 N m s/rad of viscous and 3.5 N m of dry friction.

    Args:
        armature_s2: rotor inertia seen through the gear, kg m2 per N m.
        damping_s: viscous friction, N m s/rad per N m.
        friction: dry friction, N m per N m.
    """

    armature_s2: float = 0.015
    damping_s: float = 0.05
    friction: float = 0.02


def build_model(arm: Arm, payload: InertialParameters, gravity: Array, drives: Drives) -> mujoco.MjModel:
    """The compiled `build_spec`; arguments and errors as there."""
    return build_spec(arm, payload, gravity, drives).compile()


def build_spec(arm: Arm, payload: InertialParameters, gravity: Array, drives: Drives) -> mujoco.MjSpec:
    """A model with hinges, drives, the payload as a jointless body at the sensor frame, and a force/torque sensor at
    its origin.

    The site of the sensor lies in the payload's body: a site on the arm's side would read the wrench of the next joint
    instead. So read, the wrench is what the arm exerts on the payload, in sensor axes about the sensor origin: Eq. (1)
    with its sign.

    Args:
        payload: sensor frame; all zero for a bare flange.
        gravity: (3,), world frame, m/s2.

    Raises:
        BadPayload: no body has the inertial parameters.
    """
    spec = mujoco.MjSpec()
    spec.option.gravity = gravity
    spec.option.timestep = PERIOD
    spec.option.integrator = mujoco.mjtIntegrator.mjINT_EULER
    # explicit damping: then the velocity gained in a step is exactly qacc times the period, and the wrench fits the
    # positions
    spec.option.disableflags = int(mujoco.mjtDisableBit.mjDSBL_EULERDAMP | mujoco.mjtDisableBit.mjDSBL_CONTACT)
    body = spec.worldbody
    for joint in arm.joints:
        body = _add_body(body, joint.name, joint.placement, joint.body)
        body.add_joint(
            name=joint.name,
            type=mujoco.mjtJoint.mjJNT_HINGE,
            axis=joint.axis,
            armature=drives.armature_s2 * joint.effort,
            damping=drives.damping_s * joint.effort,
            frictionloss=drives.friction * joint.effort,
            solimp_friction=[SOFT, SOFT, 0.001, 0.5, 2],
        )
    load = _add_body(body, "payload", arm.sensor, payload)
    load.add_site(name="ft")
    for name, kind in (("force", mujoco.mjtSensor.mjSENS_FORCE), ("torque", mujoco.mjtSensor.mjSENS_TORQUE)):
        spec.add_sensor(name=name, type=kind, objtype=mujoco.mjtObj.mjOBJ_SITE, objname="ft")
    return spec


def _add_body(parent: mujoco.MjsBody, name: str, placement: Array, parameters: InertialParameters) -> mujoco.MjsBody:
    body = parent.add_body(name=name, pos=placement[:3, 3], quat=to_mujoco_quaternion(placement[:3, :3]))
    set_parameters(body, parameters)
    return body


def set_parameters(body: mujoco.MjsBody, parameters: InertialParameters) -> None:
    """Gives a body principal moments and axes about its centre of mass; no mass where all parameters are zero.

    Raises:
        BadPayload: no body has the inertial parameters.
    """
    body.explicitinertial = True
    if parameters.phi.any():
        principal = principal_inertia(parameters)
        body.mass = parameters.mass
        body.ipos = parameters.com
        body.inertia = principal.moments
        body.iquat = to_mujoco_quaternion(principal.axes)
    else:
        body.mass, body.inertia = 0.0, np.zeros(3)


def get_parameters(body: mujoco.MjsBody) -> InertialParameters:
    """What `set_parameters` has given to a body, in the body's frame."""
    axes = Rotation.from_quat(np.array(body.iquat), scalar_first=True).as_matrix()
    inertia_com = axes @ np.diag(np.array(body.inertia)) @ axes.T
    return InertialParameters.from_com(float(body.mass), np.array(body.ipos), inertia_com) if body.mass > 0 else NOTHING


def arm_joints(spec: mujoco.MjSpec) -> list[mujoco.MjsJoint]:
    """The joints that `build_spec` has made, from the base on, whatever was added since."""
    body, joints = spec.worldbody.first_body(), []
    while body.name != "payload":
        joints.append(body.first_joint())
        body = body.first_body()
    return joints


def to_mujoco_quaternion(rotation: Array) -> Array:
    """(4,) in MuJoCo's order w, x, y, z."""
    return np.asarray(Rotation.from_matrix(rotation).as_quat(scalar_first=True))
