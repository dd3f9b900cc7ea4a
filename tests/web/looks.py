"""What a screen is like, measured in the browser: what axe finds, how large its targets are, what colours it has."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

from playwright.sync_api import Page, ViewportSize

from tests.web.tablet import DESKTOP, LANDSCAPE, PHONE, PORTRAIT

AXE = Path(__file__).parents[2] / "web" / "node_modules" / "axe-core" / "axe.min.js"
ASKED = {"rules": {"color-contrast-enhanced": {"enabled": True}}, "iframes": False}
"""Contrast 7:1 everywhere, not for states and values alone; the viewer's page is its own."""


@dataclass(frozen=True)
class Screen:
    """Where the console is looked at.

    Args:
        least_page_px: height that is left for the page between header and bar.
    """

    name: str
    size: ViewportSize
    theme: Literal["dark", "light"]
    least_page_px: float = 250

    @property
    def is_tablet(self) -> bool:
        return self.size in (LANDSCAPE, PORTRAIT)


SCREENS = (
    Screen("desktop", DESKTOP, "dark"), Screen("phone", PHONE, "light", 300),
    Screen("tablet, portrait", PORTRAIT, "dark"), Screen("tablet, landscape", LANDSCAPE, "light"),
)  # fmt: skip
"""Each size once and each theme twice: contrast does not depend on the size, nor what is cut off on the theme."""

DRAWN = "() => new Promise(drawn => requestAnimationFrame(() => requestAnimationFrame(drawn)))"
"""Charts are made anew in a new size, a frame after it has come."""

PUSHED = ", .navigation a, :is(.scrolls, table), :is(.scrolls, table) *"
"""On a phone: the links of the navigation and tables of many columns."""

NOT_ASKED: dict[str, Any] = {"violations": []}

TARGETS = """() => [...document.querySelectorAll('button, a[href], input, select, summary, .option')]
    .filter(each => each.checkVisibility() && !(each.matches('input') && each.closest('.option')))
    .map(each => { const {x, y, width, height} = each.getBoundingClientRect();
        const moves = each.matches('.press-start, .press-stop, .press-move');
        const page = (each.closest('main') ?? document.documentElement).getBoundingClientRect();
        const top = Math.max(y, page.top), seen = Math.min(y + height, page.bottom) - top;
        return {name: each.textContent.trim() || each.name, width, height, moves, place: {x, y: top, width, height: seen}} })"""
"""The place of one is what the page shows of it: of negative height where it is scrolled out of it, and nobody can tap it."""

ABNORMAL = (
    ".abnormal, .state-abnormal, .state-aborted, .line-lost, .notice, .warnings, .in-the-way, .flaw, [aria-invalid=true], "
    ".bell-marked, .severity-high, .severity-medium, .not-good-enough"
)
"""Where something is said to be abnormal."""

COLOURS = """abnormal => [...document.querySelectorAll('body, body *')].filter(each => each.checkVisibility()).flatMap(each => {
    const style = getComputedStyle(each);
    return ['color', 'backgroundColor', 'borderTopColor', 'outlineColor']
        .filter(kind => kind !== 'borderTopColor' || style.borderTopStyle !== 'none')
        .filter(kind => kind !== 'outlineColor' || style.outlineStyle !== 'none')
        .map(kind => ({of: each.className || each.tagName, kind, colour: style[kind], abnormal: each.closest(abnormal) !== null})) })"""

CUT = """([least, pushed]) => {
    const own = each => [...each.childNodes].some(node => node.nodeType === 3 && node.data.trim());
    const said = [...document.querySelectorAll('header *, nav *, main *, footer *, dialog *')]
        .filter(each => each.checkVisibility() && !each.closest(`.out-of-sight, option, svg${pushed}`));
    const out = said.filter(each => each.clientWidth && each.scrollWidth > each.clientWidth + 1
        && (own(each) || getComputedStyle(each).overflowX !== 'visible'));
    const beside = said.filter(each => { const {left, right} = each.getBoundingClientRect(); return left < -1 || right > innerWidth + 1 });
    const [main, bar] = ['main', 'footer'].map(part => document.querySelector(part).getBoundingClientRect());
    const tiles = [...document.querySelectorAll('main .tile, main .viewer')].filter(each => each.checkVisibility());
    const stays = each => getComputedStyle(each.closest('.view, .zone-pictures') ?? each).position === 'sticky';
    const over = tiles.filter(one => tiles.some(other => { const [a, b] = [one, other].map(each => each.getBoundingClientRect());
        return one !== other && stays(one) === stays(other) && !one.contains(other) && !other.contains(one) && a.width && b.width
            && Math.min(a.right, b.right) - Math.max(a.left, b.left) > 1 && Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 1 }));
    const frame = [['bar below the screen', bar.bottom > innerHeight + 1], ['bar over the page', main.bottom > bar.top + 1],
        [`no room for the page: ${main.height} px`, main.height < least]].filter(([_, wrong]) => wrong).map(([what]) => what);
    const named = each => `${each.className || each.tagName}: ${each.textContent.trim().slice(0, 40)}`;
    return [...new Set([...out, ...beside, ...over])].map(named).concat(frame) }"""
"""Texts and boxes wider than their place, beside the screen or over each other (what stays while the page is scrolled
lies over the page), and what is wrong with page and bar; a page has a height of
`least` px, and what a finger pushes into sight may be wider than the screen."""


@dataclass(frozen=True)
class Look:
    """A page on one screen.

    Args:
        targets: what can be tapped: name, width, height and place (px), and whether it moves the robot or stops it.
        colours: of everything to be seen: whose, which, as CSS says it, and whether it is where something is said to be abnormal.
        cut: what sticks out of its place or of the screen.
    """

    page: str
    screen: str
    violations: list[dict[str, Any]]
    targets: list[dict[str, Any]]
    colours: list[dict[str, Any]]
    cut: list[str]

    @property
    def name(self) -> str:
        return f"{self.page}, {self.screen}"


def look(page: Page, name: str) -> list[Look]:
    """A page on every screen, with what axe finds once in each theme."""
    page.evaluate(AXE.read_text())
    return [glance(page, name, screen, page.evaluate("asked => axe.run(document, asked)", ASKED) if screen.is_tablet else NOT_ASKED)
            for screen in turned(page)]  # fmt: skip


def glimpse(page: Page, name: str) -> list[Look]:
    """The same without axe, which would hold up a page for longer than one that is in control of a robot may be."""
    return [glance(page, name, screen, NOT_ASKED) for screen in turned(page)]


def turned(page: Page) -> Iterator[Screen]:
    """Shows the page on one screen after the other; on a tablet in landscape in the end."""
    for screen in SCREENS:
        page.set_viewport_size(screen.size)
        page.emulate_media(color_scheme=screen.theme)
        page.evaluate(DRAWN)
        yield screen


def glance(page: Page, name: str, screen: Screen, axe: dict[str, Any]) -> Look:
    """A page as it stands."""
    cut = page.evaluate(CUT, [screen.least_page_px, PUSHED if screen.size == PHONE else ""])
    return Look(name, screen.name, axe["violations"], page.evaluate(TARGETS), page.evaluate(COLOURS, ABNORMAL), cut)
