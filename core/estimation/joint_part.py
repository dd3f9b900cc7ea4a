"""What was found of one joint, as it leaves the engine."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pydantic import Field

from core.estimation.result_part import ResultPart

if TYPE_CHECKING:  # who only reads answers waits for no estimator
    from core.estimation.estimate import JointTorque


class JointPart(ResultPart):
    """A joint whose torque the payload was identified from."""

    joint: str = Field(description="Name of the joint.", examples=["joint2"])
    coulomb_n_m: float = Field(description="Coulomb friction, N m.", examples=[3.5])
    viscous_n_m_s: float = Field(description="Viscous friction, N m s/rad.", examples=[8.8])
    gain: float = Field(description="By what share its torque reads too much.", examples=[0.03])
    gain_std: float = Field(description="Standard uncertainty of that share.", examples=[0.05])
    residual_n_m: float = Field(description="Root mean square of what nothing explains, N m.", examples=[0.04])
    windows: int = Field(description="Short averages in which it turned one way and could be used.", examples=[310])


def joint_part(found: JointTorque) -> JointPart:
    """The same for JSON."""
    return JointPart(
        joint=found.joint,
        coulomb_n_m=found.coulomb_n_m,
        viscous_n_m_s=found.viscous_n_m_s,
        gain=found.gain,
        gain_std=found.gain_std,
        residual_n_m=found.residual_n_m,
        windows=found.windows,
    )
