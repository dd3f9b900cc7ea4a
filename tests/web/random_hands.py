"""Hands of several people that tap, drag, turn, reload and type on screens whose links come and go, in an order that nobody has thought of,
always the same for one seed."""

from __future__ import annotations

import random
import time
from collections import Counter
from collections.abc import Callable

from playwright.sync_api import BrowserContext, Error, Page

from tests.server.real_service import Console
from tests.web.tablet import LANDSCAPE, PORTRAIT, Tablet

MOST_TABS = 3
TAPS_TO_START = 4
"""To where the run is, take control, release, START."""
REACHABLE = "button:enabled, a[href]:not([target]):not([download]), input:enabled, select, summary, .option"
TO_PRESS = ".press:enabled"
LEADS_ON = ".command-bar .actions :is(.press-primary, .press-start):enabled"
TO_THE_RUN = ".navigation a[href='#/'], a[href^='#/runs/']"
MIDDLES = """selector => [...document.querySelectorAll(selector)].filter(each => each.checkVisibility())
    .map(each => each.getBoundingClientRect()).map(({x, y, width, height}) => [x + width / 2, y + height / 2])"""
PLACE = "[location.hash, document.querySelector('main > *')?.className, document.querySelector('h1')?.textContent]"
"""Which page is shown."""
TOLD_WITHIN_S = 2.0
"""Within it a screen whose link is up says of its run what the service says."""
LINK_LOST_MS = (100, 5_000)
STATE = """() => {
    const doing = document.querySelector('.header .doing[data-run]');
    const state = doing?.querySelector('[data-state]')?.dataset.state;
    return document.querySelector('.line-lost, .lost-layer') || !state ? null : [doing.dataset.run, state];
}"""
"""Which run a page speaks of, and what it says of it; null where it speaks of none or says that it does not know."""
TEXTS = ("1,5", "-3", "0", "abc", "", "1e9", "2.783", "  ", "0.2", "0.3", "0,25", "1.2")

WATCH = """(() => {
    const taps = [];
    document.addEventListener('click', event => {
        const at = event.isTrusted && event.target.closest('button');
        if (at) taps.push({name: at.className, inBar: at.closest('.command-bar .actions') !== null});
    }, true);
    const fetched = window.fetch;
    window.fetch = (address, request) => {
        if (String(address).endsWith('/release')) {
            const inBar = taps.filter(tap => tap.inBar).slice(-2);
            window.releaseAsked((inBar.at(-1) === taps.at(-1) ? inBar : taps.slice(-1)).map(({name}) => name));
        }
        return fetched(address, request);
    };
    window.print = () => undefined;
})()"""
"""Notes which two buttons of the command bar were tapped last whenever the page asks for a release, or the one elsewhere that was tapped
after them; prints nothing."""
RELEASE_THEN_START = ["press press-primary", "press press-start"]


class RandomHands:
    """Does one thing after the other with the console, in the browsers of several people.

    Args:
        people: name and password of each tablet's person; the tablets are opened nowhere yet, their complaints are those of all their tabs.
        witness: asks the service what is.

    Attributes:
        acts: how often each kind of thing was done.
        blank: what was done last where a page was blank then.
        contradictions: what a screen said of its run that the service did not say for longer than `TOLD_WITHIN_S`.
        releases: the last two buttons of the command bar that were tapped before each release that a page asked for, or one elsewhere.
    """

    def __init__(self, people: list[tuple[Tablet, str, str]], witness: Console, seed: int) -> None:
        self.chance, self.witness = random.Random(seed), witness
        self.tablets = {at.page.context: at for at, _, _ in people}
        self.names = {at.page.context: (name, password) for at, name, password in people}
        self.acts: Counter[str] = Counter()
        self.blank: list[str] = []
        self.contradictions: list[str] = []
        self.releases: list[list[str]] = []
        for context, at in self.tablets.items():
            context.expose_function("releaseAsked", self._note)
            context.add_init_script(WATCH)
            at.hurry()
            at.without_viewer()
            at.open()
            self._sign_in(at.page)
        first = people[0][0]
        first.page.locator(".command-bar .press-primary").tap()
        first.wait(".preview table")

    def _note(self, taps: list[str]) -> None:
        self.releases.append(taps)

    @property
    def complaints(self) -> list[str]:
        """Of all browsers."""
        return [said for at in self.tablets.values() for said in at.complaints]

    @property
    def pages(self) -> list[Page]:
        """All tabs of all people."""
        return [page for context in self.tablets for page in context.pages]

    @property
    def releases_without_start(self) -> list[list[str]]:
        """Releases that were asked for by anything but a tap on START after one on the button that asks whether to release."""
        return [taps for taps in self.releases if taps != RELEASE_THEN_START]

    def act(self) -> None:
        """Does one thing, in any of the tabs, and looks whether all of them still show something, and what is."""
        page = self.chance.choice(self.pages)
        page.bring_to_front()
        kinds: dict[Callable[[Page], None], int] = {
            self.go_on: 20, self.press: 15, self.tap: 25, self.type: 6, self.poke: 10,
            self.drag: 8, self.turn: 6, self.reload: 5, self.second_tab: 5, self.lose_link: 3,
        }  # fmt: skip
        (kind,) = self.chance.choices(list(kinds), weights=list(kinds.values()))
        self.acts[kind.__name__] += 1
        try:
            kind(page)
        except Error as error:
            self.blank.append(f"{kind.__name__}: {error}")
        self.look_around(kind.__name__)

    def look_around(self, did: str) -> None:
        """A page that was signed out of is signed in to again; another tab may sign it out in that moment, then the next look does it."""
        for page in self.pages:
            page.wait_for_selector("h1, .page", timeout=15_000)
            if not page.inner_text("body").strip():
                self.blank.append(did)
            if page.locator("form.sign-in").is_visible():
                self._sign_in(page)
            self._compare(page, did)

    def _sign_in(self, page: Page) -> None:
        name, password = self.names[page.context]
        page.locator("input[name=username]").fill(name)
        page.locator("input[name=password]").fill(password)
        with page.expect_response("**/api/session"):
            page.locator("form button").tap()

    def _compare(self, page: Page, did: str) -> None:
        """What a page says of a run's state with what the service says, until they agree or it has taken too long."""
        until = time.monotonic() + TOLD_WITHIN_S
        while shown := page.evaluate(STATE):
            run, says = shown
            is_now = self.witness.run(run)["state"]
            if says == is_now:
                return
            if time.monotonic() > until:
                self.contradictions.append(f"{did}: {run} is {is_now}, the screen says {says}")
                return
            page.wait_for_timeout(100)

    def go_on(self, page: Page) -> None:
        """The button that leads on, as often as it takes from a plan to START: without it hardly any run would ever be released."""
        for _ in range(TAPS_TO_START):
            if not self._tap_one_of(page, LEADS_ON):
                self._tap_one_of(page, TO_THE_RUN)
            page.wait_for_timeout(200)

    def press(self, page: Page) -> None:
        """One of the buttons."""
        self._tap_one_of(page, TO_PRESS)

    def tap(self, page: Page) -> None:
        """Anything that can be tapped."""
        self._tap_one_of(page, REACHABLE)

    def _tap_one_of(self, page: Page, selector: str) -> bool:
        """Whether there was one. It may be gone, or covered, before the finger is there: then the finger hits whatever is there."""
        places = page.evaluate(MIDDLES, selector)
        if places:
            self._touch(page, *self.chance.choice(places))
        return bool(places)

    def type(self, page: Page) -> None:
        """Something, readable or not, into a field. The page may have gone on before it is typed, as when another tab has begun a run."""
        fields = page.locator("main input:not([type]):visible").all()
        if not fields:
            return
        field, place = self.chance.choice(fields), page.evaluate(PLACE)
        try:
            field.fill(self.chance.choice(TEXTS), timeout=2_000)
        except Error:
            if page.evaluate(PLACE) == place:
                raise

    def poke(self, page: Page) -> None:
        """Anywhere."""
        self._touch(page, *self._place(page))

    def _touch(self, page: Page, x: float, y: float) -> None:
        size = page.viewport_size or LANDSCAPE
        if 0 <= x < size["width"] and 0 <= y < size["height"]:
            page.touchscreen.tap(x, y)

    def drag(self, page: Page) -> None:
        """From anywhere to anywhere."""
        page.mouse.move(*self._place(page))
        page.mouse.down()
        page.mouse.move(*self._place(page), steps=4)
        page.mouse.up()

    def _place(self, page: Page) -> tuple[int, int]:
        size = page.viewport_size or LANDSCAPE
        return self.chance.randrange(size["width"]), self.chance.randrange(size["height"])

    def turn(self, page: Page) -> None:
        """The tablet, or what is in its place."""
        page.set_viewport_size(self.chance.choice((LANDSCAPE, PORTRAIT)))

    def reload(self, page: Page) -> None:
        page.reload()

    def second_tab(self, page: Page) -> None:
        """One more at the same place, or one less where there are enough."""
        context = page.context
        if len(context.pages) >= MOST_TABS:
            self.chance.choice(context.pages[1:]).close()
            return
        other = context.new_page()
        self.tablets[context].listen(other)
        other.goto(page.url)

    def lose_link(self, page: Page) -> None:
        """All tabs of one person, for a while."""
        context: BrowserContext = page.context
        context.set_offline(True)
        page.wait_for_timeout(self.chance.uniform(*LINK_LOST_MS))
        context.set_offline(False)
