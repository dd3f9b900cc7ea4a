"""What a plant calls the order that a run serves: kept with its recording and its result, so that either finds its way back."""

from __future__ import annotations

from pydantic import BaseModel, ConfigDict, Field


class OrderReference(BaseModel):
    """An order as the plant names it; null is what nobody said."""

    model_config = ConfigDict(frozen=True)

    order_id: str | None = Field(
        default=None, max_length=100, description="Identifier of the job order (ISA-95).", examples=["JO-2026-004711"]
    )
    work_order: str | None = Field(default=None, max_length=100, description="The work order that it belongs to.", examples=["WO-88120"])
    serial_number: str | None = Field(default=None, max_length=100, description="Of what the robot carries.", examples=["SN-000482"])

    def __bool__(self) -> bool:
        return any((self.order_id, self.work_order, self.serial_number))


NO_ORDER = OrderReference()
