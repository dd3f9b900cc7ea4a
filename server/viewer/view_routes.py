"""What one page wants to see of a cell in a way of its own: nobody else's picture changes, and nothing that the robot does."""

from __future__ import annotations

from typing import Annotated

from fastapi import APIRouter, status
from pydantic import Field

from core.payload.shapes import Angle, Box
from server.http.parameters import CellPath, ViewPath
from server.http.schemas import AnyShape, RequestBody
from server.viewer.gallery import GalleryDep
from server.viewer.wish import Look, Wish

router = APIRouter(prefix="/api/cells/{cell}/views", tags=["viewer"])


class ViewWish(RequestBody):
    """What a page wants to see besides the cell as it is."""

    payload_box: Annotated[Box | None, Field(description="Box drawn in the place of the run's, sensor frame; null shows the run's.")] = None
    q_rad: Annotated[
        tuple[Angle, ...] | None,
        Field(
            min_length=1,
            max_length=32,
            description="Joint positions at which the planned robot is drawn, rad; null draws none. A robot that moves takes it away.",
            examples=[[0.0, 0.52, 0.0, -1.57, 0.0, 1.05, 0.0]],
        ),
    ] = None
    zone: Annotated[
        AnyShape | None,
        Field(description="A protected zone as it would be, drawn beside those there are, world frame; null draws none."),
    ] = None
    look: Annotated[
        Look | None,
        Field(
            description="Turns the camera once: `operator` from where people stand, `fit` so that all is seen, `reset` as at first; "
            "null leaves it."
        ),
    ] = None


@router.put("/{view}", status_code=status.HTTP_204_NO_CONTENT)
async def show_in_view(cell: CellPath, view: ViewPath, wish: ViewWish, gallery: GalleryDep) -> None:
    """Draws what the page that called its view so wants to see: the page at `/viewer/{cell}/{view}/`."""
    await gallery.show(cell, view, Wish(wish.payload_box, wish.q_rad, wish.zone), wish.look)
