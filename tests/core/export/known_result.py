"""The answer of a run whose payload is known."""

from __future__ import annotations

from core.estimation.result import EstimatePart, PaperPart, Result, SecondsPart
from core.words.message import Message
from tests.core.export.cloud import Cloud, covariance

FOUND = Message.of("text", text="found")


def answer(body: Cloud, cell: str | None) -> Result:
    """As `heft run` leaves it, of a body in the sensor's frame."""
    known = body.parameters(covariance(0))
    estimate = EstimatePart(
        phi=known.phi.tolist(), std=known.std.tolist(), covariance=known.covariance.tolist(), determined=[True] * 10, reasons={},
        offset=[0.0] * 6, offset_std=[0.1] * 6, com_m=known.com_m.tolist(), com_std_m=known.com_std.tolist(),
        inertia_com_kg_m2=known.inertia_com.tolist(), inertia_com_std_kg_m2=known.inertia_com_std.tolist(), consistent=True,
        base_tilt_rad=None, base_tilt_std_rad=None, delay_s=None, delay_std_s=None,
    )  # fmt: skip
    return Result(
        cell=cell, payload=None, verdict=FOUND, warnings=[], reference=None, paper=PaperPart(phi=[], std=[]), estimate=estimate,
        residual=None, safety=None, seconds=SecondsPart(estimate=1.0), recording=None,
    )  # fmt: skip
