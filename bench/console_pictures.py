"""Takes the pictures of docs/console.md: walks through the built console and keeps each screen, a palette of 256 colours each."""

from __future__ import annotations

import argparse
import tempfile
from contextlib import ExitStack
from io import BytesIO
from pathlib import Path

from PIL import Image
from playwright.sync_api import Browser

from tests.server.finished_diagnosis import SWINGS, diagnosed_run
from tests.server.finished_trial import finished_trial
from tests.server.real_service import ROOT, Console, RealService, real_service
from tests.server.zone_at import AT_THE_ROBOT, zone_at
from tests.web.patient_cells import patient_cells
from tests.web.screens import show, signed_in
from tests.web.tablet import LANDSCAPE, PORTRAIT, Tablet, chromium, tablet
from tests.web.tilted import tilted_recording

FOLDER = ROOT / "docs" / "pictures" / "console"
COLOURS = 256
DRAWN_MS = 4000
"""For the cell in three dimensions, which is drawn without a graphics card here."""
RUN_MS = 180_000
"""For a whole run, its holds as long as they are for the pictures."""
SEEN_S = 8.0
"""How long a pose is held, for there to be an estimate while the pictures are taken."""


def main() -> None:
    """Takes all of them."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--folder", type=Path, default=FOLDER)
    folder: Path = parser.parse_args().folder
    folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as data, ExitStack() as stack:
        patient_cells(Path(data) / "data")
        service, browser = stack.enter_context(real_service(Path(data))), stack.enter_context(chromium())
        first = _run_without_pictures(service)
        run = _run_with_pictures(service, browser, folder)
        _running(service, browser, folder)
        _lost_link(service, browser, folder)
        _pages(service, browser, folder, first, run)
        diagnosis = _gap(service, browser, folder)
        _open_questions(service, browser, folder, diagnosis)
        _refused(service, browser, folder)
        _german(service, browser, folder, run, diagnosis)


def picture(at: Tablet, folder: Path, name: str, wait_ms: int = 600) -> None:
    """A screen in both orientations."""
    for orientation, size in (("portrait", PORTRAIT), ("landscape", LANDSCAPE)):
        at.page.set_viewport_size(size)
        at.page.wait_for_timeout(wait_ms)
        image = Image.open(BytesIO(at.page.screenshot())).convert("RGB").quantize(COLOURS, dither=Image.Dither.NONE)
        image.save(folder / f"{name}-{orientation}.png", optimize=True)
        print(f"{name}-{orientation}.png", flush=True)


def _run_without_pictures(service: RealService) -> str:
    """One to compare with."""
    console = Console(service)
    console.take_control()
    run = console.queue(seed=1, pace="real_time")
    console.wait(run, "Idle")
    console.release(run).raise_for_status()
    console.wait(run, "Complete")
    console.leave()
    return run


def _run_with_pictures(service: RealService, browser: Browser, folder: Path) -> str:
    """From signing in to the result; the cell in three dimensions is shown where nothing moves, for it takes the processor."""
    with tablet(browser, service) as at:
        at.hurry(hold_s=4.0)
        at.open()
        picture(at, folder, "sign-in")
        at.sign_in()
        at.tap(at.page.get_by_text("Asymmetric steel block"))
        picture(at, folder, "cell-and-tool")
        at.press("Take control and plan")
        at.wait(".preview table")
        at.until_drawn()
        picture(at, folder, "plan", DRAWN_MS)
        again = at.page.get_by_role("button", name="Review the plan again")
        if again.is_visible():
            again.tap()
        at.without_viewer()
        at.press("Release")
        at.press("START")
        at.page.wait_for_selector(".result table", timeout=RUN_MS)
        at.wait(".result aside .download")
        picture(at, folder, "result", 1500)
        return at.page.url.rsplit("/", 1)[1]


def _running(service: RealService, browser: Browser, folder: Path) -> None:
    """A run as a tablet sees it that looks on: drawing in three dimensions takes the processor, and who is in control has to answer."""
    person = Console(service)
    person.take_control()
    run = person.queue(seed=2, pace="real_time", hold_s=SEEN_S)
    person.wait(run, "Idle")
    with signed_in(service, browser, drawn=True) as at:
        person.release(run).raise_for_status()
        show(at, "runs", run)
        at.until_drawn()
        at.wait(".running .estimate-so-far dl")
        picture(at, folder, "running", DRAWN_MS)
    person.command(run, "stop").raise_for_status()
    person.wait(run, "Stopped")
    person.leave()


def _pages(service: RealService, browser: Browser, folder: Path, first: str, run: str) -> None:
    with signed_in(service, browser, drawn=True) as at:
        for name, shows, place in (
            ("history", ".run-list tbody tr", ["history"]),
            ("comparison", ".comparison-table", ["history", first, run]),
            ("cells", ".zone-places .tile", ["cells"]),
            ("settings", ".settings h1", ["settings"]),
        ):
            show(at, *place)
            at.wait(shows)
            if name == "cells":
                at.until_drawn()
            picture(at, folder, name, DRAWN_MS if name == "cells" else 600)


def _lost_link(service: RealService, browser: Browser, folder: Path) -> None:
    """A run whose console loses its link, and what somebody sees of it who is not signed in."""
    with tablet(browser, service) as at, tablet(browser, service) as nobody:
        at.hurry(hold_s=SEEN_S)
        at.without_viewer()
        at.open()
        at.sign_in()
        at.press("Take control and plan")
        at.wait(".preview table")
        at.press("Release")
        at.press("START")
        at.wait(".running .estimate-so-far dl")
        nobody.open()
        nobody.wait(".active-robots")
        picture(nobody, folder, "sign-in-beside-a-run")
        at.page.context.set_offline(True)
        at.wait(".lost-layer")
        picture(at, folder, "no-connection")
        nobody.wait(".active-robots [data-state=Held]")
        with signed_in(service, browser, drawn=True) as watching:
            show(watching, "runs", at.page.url.rsplit("/", 1)[1])
            watching.until_drawn()
            watching.wait(".held-notice")
            picture(watching, folder, "held", DRAWN_MS)
            watching.press("STOP")
            watching.wait(".ended")


def _gap(service: RealService, browser: Browser, folder: Path) -> str:
    """A base that is not level, from its recording into the twin; the diagnosis."""
    with tempfile.TemporaryDirectory() as recordings, signed_in(service, browser, drawn=True) as at:
        page = show(at, "gap")
        page.get_by_label("Recording (zip)").set_input_files(tilted_recording(Path(recordings)))
        at.tap(page.locator(".recording-upload button"))
        at.wait(".gap-verdict")
        diagnosis = page.url.rsplit("/", 1)[1]
        picture(at, folder, "diagnosis")
        _unfold_evidence(at)
        page.locator(".how-far").scroll_into_view_if_needed()
        picture(at, folder, "diagnosis-how-far")
        at.press("Add to the twin")
        at.wait(".actions :text('is in the twin')")
        at.press("All diagnoses")
        at.wait(".twin li")
        picture(at, folder, "gap")
        at.press("Remove")
        at.press("Remove permanently")
        page.locator(".twin li").wait_for(state="detached")
        show(at, "trials", finished_trial(service))
        at.press("Open the seal")
        page.get_by_role("link", name="Score sheet").wait_for()
        picture(at, folder, "trial")
        return diagnosis


def _unfold_evidence(at: Tablet) -> None:
    at.tap(at.page.locator(".evidence:not([open]) > summary"))
    at.wait(".overlay canvas")


def _open_questions(service: RealService, browser: Browser, folder: Path, diagnosis: str) -> None:
    """That diagnosis, were its effect tied with another one and the motion proposed that tells them apart."""
    with signed_in(service, browser, drawn=True) as at:
        found = at.page.request.get(f"http://{service.address}/api/diagnoses/{diagnosis}").json()["result"]
        tie = {"ids": ["base_tilt", "joint_offset"], "distance_sigma": 2.0, "why": "", "splits": SWINGS["motion"]}
        motion = SWINGS | {"splits": [tie["ids"]]}
        first = at.page.request.get(f"http://{service.address}/api/runs").json()[-1]["run"]
        changed = found | {"verdict": "ambiguous", "indistinguishable": [tie], "next_experiment": motion}
        page = show(at, "gap", diagnosed_run(service, first, **changed))
        at.wait(".next-motion")
        page.locator(".next-motion").scroll_into_view_if_needed()
        picture(at, folder, "not-settled")


def _refused(service: RealService, browser: Browser, folder: Path) -> None:
    """A zone on the robot leaves no plan."""
    person = Console(service)
    with signed_in(service, browser, drawn=True) as at, zone_at(person, AT_THE_ROBOT):
        at.press("plan")
        at.wait(".ended .in-the-way")
        at.until_drawn()
        picture(at, folder, "refused", DRAWN_MS)
    person.leave()


def _german(service: RealService, browser: Browser, folder: Path, run: str, diagnosis: str) -> None:
    """In German, dark, in grams and millimetres."""
    with signed_in(service, browser, drawn=True) as at:
        at.page.emulate_media(color_scheme="dark")
        at.page.evaluate("localStorage.setItem('heft.language', 'de'); localStorage.setItem('heft.units', 'mm_g')")
        at.page.reload()
        show(at, "runs", run)
        at.wait(".result table")
        picture(at, folder, "result-german", 1500)
        show(at, "gap", diagnosis)
        _unfold_evidence(at)
        picture(at, folder, "diagnosis-german")


if __name__ == "__main__":
    main()
