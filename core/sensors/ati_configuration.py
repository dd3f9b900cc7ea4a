"""How an ATI box is set up, from the pages that it serves (`netftapi2.xml`, `netftcalapi.xml`)."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from dataclasses import dataclass
from http.client import HTTPConnection, HTTPException

import numpy as np

from core.array import Array
from core.errors import NotConnected, UnusableSensor

MOST_BYTES = 1 << 18
POUND_N, KILOGRAM_N, INCH_M, FOOT_M = 4.4482216152605, 9.80665, 0.0254, 0.3048
FORCE_N = {"n": 1.0, "kn": 1e3, "lbf": POUND_N, "klbf": 1e3 * POUND_N, "kgf": KILOGRAM_N, "kg": KILOGRAM_N, "gf": 1e-3 * KILOGRAM_N}
TORQUE_N_M = {
    "nm": 1.0, "nmm": 1e-3, "knm": 1e3, "lbfin": POUND_N * INCH_M, "lbfft": POUND_N * FOOT_M, "kgfcm": 1e-2 * KILOGRAM_N,
    "kgcm": 1e-2 * KILOGRAM_N,
}  # fmt: skip
"""Units by the names that the box shows, in small letters without hyphens; `lbf` and `lb` are one."""


@dataclass(frozen=True)
class NetFtConfiguration:
    """The active configuration.

    Args:
        product: what it calls itself. calibration: serial number of the calibration in use.
        newtons: (6,), N and N m of one count.
        range: (6,), N and N m, of the calibration in use; None where it does not say.
        rate_hz: of the records that it sends. inner_hz: of the samples that `ft_sequence` counts; None where it does not say.
        filtered: whether its low-pass is on. biased: whether somebody has set a bias, which is kept as part of the offset.
    """

    product: str
    calibration: str
    newtons: Array
    range: Array | None
    rate_hz: float
    inner_hz: float | None
    filtered: bool
    biased: bool

    @property
    def axia(self) -> bool:
        """Whether the electronics are in the sensor; its status bits are others."""
        return "axia" in self.product.casefold()


def read_configuration(host: str, port: int, timeout_s: float = 2.0) -> tuple[NetFtConfiguration, int]:
    """What the box says of itself, with its status word.

    Raises:
        NotConnected: it does not answer. UnusableSensor: it answers something else, or is set up so that its wrench cannot be used.
    """
    page = _Page(host, port, "netftapi2.xml", timeout_s)
    if page.text("comrdte").casefold() in ("disabled", "0"):
        raise UnusableSensor("sensors-ati-no-rdt", host=host)
    _refuse_transform(page)
    force, torque = page.unit("scfgfu", FORCE_N), page.unit("scfgtu", TORQUE_N_M)
    per_force, per_torque = page.positive("cfgcpf"), page.positive("cfgcpt")
    calibration = page.find("cfgcalsn")
    if calibration is None:
        index = page.text("cfgcalsel")
        calibration = _Page(host, port, f"netftcalapi.xml?index={index}", timeout_s).text("calsn")
    ranges = page.numbers("cfgmr")
    status = page.find("runstat") or "0"
    configuration = NetFtConfiguration(
        product=page.find("prodname") or "Net F/T",
        calibration=calibration,
        newtons=np.array([force / per_force] * 3 + [torque / per_torque] * 3),
        range=np.array(ranges) * np.array([force] * 3 + [torque] * 3) if len(ranges) == 6 else None,
        rate_hz=page.positive("comrdtrate"),
        inner_hz=page.positive("runrate") if page.find("runrate") else None,
        filtered=page.find("setuserfilter") not in (None, "0"),
        biased=any(page.numbers("setbias")),
    )
    return configuration, int(status, 16) if status.lower().startswith("0x") else page.whole("runstat")


def _refuse_transform(page: _Page) -> None:
    """The cell says where the sensor is; a box that turns or moves its wrench would do it a second time."""
    moved = page.numbers("cfgtfx")
    if any(moved):
        raise UnusableSensor("sensors-ati-transform", host=page.host, found="; ".join(f"{value:g}" for value in moved))


class _Page:
    """One page of the box, by its tags."""

    def __init__(self, host: str, port: int, name: str, timeout_s: float) -> None:
        self.host, self._name = host, name
        connection = HTTPConnection(host, port, timeout=timeout_s)
        try:
            connection.request("GET", f"/{name}")
            answer = connection.getresponse()
            with answer:
                content = answer.read(MOST_BYTES + 1)
        except (OSError, HTTPException) as error:
            raise NotConnected(
                "sensors-no-page", host=host, port=port, page=name, reason=str(error)[:80] or type(error).__name__
            ) from error
        finally:
            connection.close()
        if answer.status != 200:
            raise NotConnected("sensors-no-page", host=host, port=port, page=name, reason=f"{answer.status} {answer.reason}"[:80])
        self._texts = self._read(content)

    def _read(self, content: bytes) -> dict[str, str]:
        """First text of every tag."""
        if len(content) > MOST_BYTES or b"<!" in content.replace(b"<!--", b""):
            raise self._refusal("-")
        try:
            root = ET.fromstring(content)
        except (ET.ParseError, ValueError) as error:
            raise self._refusal("-") from error
        found: dict[str, str] = {}
        for element in root.iter():
            found.setdefault(element.tag.casefold(), (element.text or "").strip())
        return found

    def _refusal(self, tag: str) -> UnusableSensor:
        return UnusableSensor("sensors-bad-page", host=self.host, page=self._name, tag=tag, found=self._quote(tag))

    def _quote(self, tag: str) -> str:
        return self._texts.get(tag, "-")[:40] if hasattr(self, "_texts") else "-"

    def find(self, tag: str) -> str | None:
        """Its text; None where it is not there or empty."""
        return self._texts.get(tag) or None

    def text(self, tag: str) -> str:
        """Its text, which has to be there."""
        text = self.find(tag)
        if text is None:
            raise self._refusal(tag)
        return text

    def numbers(self, tag: str) -> list[float]:
        """Numbers with `;` between them; none where the tag is not there."""
        try:
            found = [float(part) for part in (self.find(tag) or "").split(";") if part.strip()]
        except ValueError as error:
            raise self._refusal(tag) from error
        if not np.isfinite(found).all():
            raise self._refusal(tag)
        return found

    def positive(self, tag: str) -> float:
        """A number above 0."""
        self.text(tag)
        found = self.numbers(tag)
        if len(found) != 1 or found[0] <= 0.0:
            raise self._refusal(tag)
        return found[0]

    def whole(self, tag: str) -> int:
        """A whole number."""
        try:
            return int(self.text(tag))
        except ValueError as error:
            raise self._refusal(tag) from error

    def unit(self, tag: str, units: dict[str, float]) -> float:
        """In SI."""
        name = self.text(tag).casefold().replace("-", "").replace(" ", "").replace("lbin", "lbfin").replace("lbft", "lbfft")
        if name == "lb":
            name = "lbf"
        if name not in units:
            raise self._refusal(tag)
        return units[name]
