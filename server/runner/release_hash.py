"""What a release is bound to."""

from __future__ import annotations

from hashlib import sha256

from core.cell.cell import Box, Cell


def release_sha256(digest: str, cell: Cell, payload_box: Box) -> str:
    """SHA-256 of a plan's digest with the cell as it is now (URDF, zones and limits included) and the payload box, hexadecimal.

    In which order the zones stand does not count: one that was removed and put back is where it was for nobody who asks twice.
    """
    cell_now = cell.model_copy(update={"zones": tuple(sorted(cell.zones, key=lambda zone: zone.name))})
    parts = (digest, cell_now.model_dump_json(), sha256(cell.urdf.encode()).hexdigest(), payload_box.model_dump_json())
    return sha256("\n".join(parts).encode()).hexdigest()
