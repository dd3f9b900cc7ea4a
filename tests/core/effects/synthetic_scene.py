"""A run of a six-joint arm for the effects' tests, made without the product's kinematics: derivatives by differences."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.spatial.transform import Rotation

from core.effects.link_loads import LazyLinkLoads, LinkLoads
from core.effects.scene import Scene
from core.payload.inertia import InertialParameters, Motion

AXES = np.array([[0, 0, 1], [0, 1, 0], [0, 1, 0], [0, 0, 1], [0, 1, 0], [0, 0, 1]], dtype=float)
LINKS = np.array([[0, 0, 0.3], [0, 0, 0.4], [0, 0, 0.35], [0, 0, 0.1], [0, 0, 0.1], [0, 0, 0.05]])
GRAVITY = np.array([0, 0, -9.81])
PAYLOAD = InertialParameters.from_com(2.5, [0.01, -0.02, 0.06], np.diag([0.006, 0.005, 0.004])).phi
RANGE = np.array([145.0, 145, 290, 5, 5, 5])
RESOLUTION = np.array([0.0625, 0.0625, 0.0625, 0.00133, 0.00133, 0.00133])
NOISE = np.array([0.05, 0.05, 0.07, 0.003, 0.003, 0.003])


def scene(*, rate: float = 100.0, seconds: float = 16.0, seed: int = 1) -> Scene:
    """Postures held for 1 s, moves of 2 s between them, everything known that a scene can know."""
    rng = np.random.default_rng(seed)
    t = np.arange(round(rate * seconds)) / rate
    postures = rng.uniform(-1.2, 1.2, (round(seconds / 3) + 2, 6))
    leg = np.minimum((t // 3).astype(int), len(postures) - 2)
    s = np.clip((t - 3 * leg - 1) / 2, 0, 1)
    blend = (s**4 * (35 - 84 * s + 70 * s**2 - 20 * s**3))[:, None]
    q = postures[leg] + blend * (postures[leg + 1] - postures[leg])
    dq = np.gradient(q, t, axis=0)
    rotation, position, axes, origins = forward(q)
    jacobian = np.concatenate([np.cross(axes, position[:, None] - origins), axes], axis=2)
    jacobian = np.concatenate(
        [np.einsum("nij,nki->njk", rotation, jacobian[:, :, :3]), np.einsum("nij,nki->njk", rotation, jacobian[:, :, 3:])], axis=1
    )
    omega = np.einsum("nij,nj->ni", jacobian[:, 3:], dq)
    a_base = np.gradient(np.gradient(position, t, axis=0), t, axis=0)
    in_sensor = np.einsum("nij,ni->nj", rotation, a_base)
    motion = Motion(np.einsum("nij,i->nj", rotation, GRAVITY), in_sensor, omega, np.gradient(omega, t, axis=0))
    run = Scene(
        t=t,
        phase=np.where(s == 0, "hold:free", "transfer"),
        motion=motion,
        rotation=rotation,
        position=position,
        gravity=GRAVITY,
        phi=PAYLOAD,
        q=q,
        dq=dq,
        jacobian=jacobian,
        temperature=22.0 + 3.0 * (1 - np.exp(-t / 8.0)),
        range=RANGE,
        resolution=RESOLUTION,
    )
    arm = 20.0 * np.sin(q)
    links = LinkLoads(np.zeros((len(t), 6, 6)), arm, 8.0 * (0.5 * position + [0.0, 0.0, 0.2]))
    return replace(run, torque=np.einsum("nij,ni->nj", jacobian, run.nominal) + arm, links=LazyLinkLoads(lambda: links))


def forward(q: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Rotation (N, 3, 3) and position (N, 3) of the sensor, joint axes and origins (N, 6, 3), base frame."""
    rotation = Rotation.identity(len(q))
    position = np.zeros((len(q), 3))
    axes, origins = [], []
    for j in range(6):
        axes.append(rotation.apply(AXES[j]))
        origins.append(position)
        rotation = rotation * Rotation.from_rotvec(q[:, j : j + 1] * AXES[j])
        position = position + rotation.apply(LINKS[j])
    return rotation.as_matrix(), position, np.stack(axes, axis=1), np.stack(origins, axis=1)


def poses_only(run: Scene) -> Scene:
    """The same run known from poses alone: no joints, no temperature, nothing stated of the sensor."""
    return replace(run, position=None, q=None, dq=None, jacobian=None, torque=None, temperature=None, range=None, resolution=None)


def first_rows(run: Scene, rows: int) -> Scene:
    """The beginning of a run."""
    return run[:rows]
