"""Tablets of whoever it is, on whatever page."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from playwright.sync_api import Browser, Page

from tests.server.real_service import RealService
from tests.web.tablet import Tablet, tablet


@contextmanager
def signed_in(
    service: RealService, browser: Browser, name: str = "operator", password: str = "", *, drawn: bool = False
) -> Iterator[Tablet]:
    """A tablet of somebody's; with `drawn` the cell is drawn in three dimensions, as slowly as that is without a graphics card."""
    with tablet(browser, service) as at:
        if not drawn:
            at.without_viewer()
        at.open()
        at.page.get_by_label("Name").fill(name)
        at.page.get_by_label("Password").fill(password or service.password)
        at.press("Sign in")
        at.wait(".setup .cell-facts")
        yield at


@contextmanager
def on_page(service: RealService, browser: Browser, link: str, shows: str) -> Iterator[Tablet]:
    """The first operator's tablet on a page of the navigation, once that shows something; nothing is drawn in three dimensions."""
    with tablet(browser, service) as at:
        at.without_viewer()
        at.open()
        at.sign_in()
        at.tap(at.page.get_by_role("link", name=link))
        at.wait(shows)
        yield at


def show(at: Tablet, *place: str) -> Page:
    """Goes to a page of the console."""
    at.page.goto(f"http://{at.service.address}/#/{'/'.join(place)}")
    return at.page
