"""How many runs come through over a good and a poor Wi-Fi, and over one that passes nothing for up to 2 s every minute.

Whole services, the simulated robot in real time, a person who resumes what was held once their line is back, with one tap:
`python -m bench.wifi --runs 100`.
"""

from __future__ import annotations

import argparse
import tempfile
import time
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from datetime import datetime
from functools import partial
from pathlib import Path
from typing import Any

import httpx2

from tests.server.real_service import Console, RealService, real_service, wait_for
from tests.server.wifi_line import PROFILES, Profile, WifiLine

SHARE = 0.99
"""Of the runs that are to come through."""
ENDED = ("Complete", "Stopped", "Aborted")
LOOK_S = 0.2
"""Between two looks of the person at the run."""
ANSWER_S = 3.0
"""Within which nobody taps again who sees the first tap under way."""
LINK = ("network", "page")
"""Causes of a hold that lie between the robot's computer and the person; the others are for a computer that is too busy."""
PLAN_S = 300.0
"""Within which there is a plan, however busy the machine."""
PRESSES = 10
"""Of a release that is refused, because what was shown came too late."""


@dataclass
class Carried:
    """A run as it went.

    Args:
        lost: why it did not come through; None where it did.
        taps: on resume.
        gaps: of the line, from its release to its end.
        causes: of each hold.
        longest_s: in which it was held.
    """

    lost: str | None = None
    taps: int = 0
    gaps: int = 0
    seconds: float = 0.0
    causes: list[str] = field(default_factory=list)
    longest_s: float = 0.0

    def __str__(self) -> str:
        held = f"held {len(self.causes)} times ({', '.join(self.causes)}), at most {self.longest_s:.1f} s" if self.causes else "never held"
        return f"{self.lost or 'complete'} after {self.seconds:.0f} s, {held}; taps {self.taps}, gaps {self.gaps}"


def series(profile: Profile, folder: Path, seeds: list[int]) -> list[Carried]:
    """One run for each seed, all to one service over one line."""
    with real_service(folder) as service, WifiLine(service.port, profile, seeds[0]) as line:
        found = []
        for seed in seeds:
            found.append(carried(service, line, seed))
            print(f"{time.strftime('%H:%M:%S')} {profile.name:5} seed {seed}: {found[-1]}", flush=True)
        return found


def carried(service: RealService, line: WifiLine, seed: int) -> Carried:
    """One run over the line; one that a person cannot see through is lost too."""
    person = Console(service, address=line.address)
    person.returning.set()
    run = person.order(seed=seed)
    found = Carried()
    try:
        see_through(person, line, run, found)
    except (AssertionError, httpx2.HTTPError) as error:
        found.lost = f"lost, the person gave up: {type(error).__name__}: {error}"[:300]
    person.leave()
    leave_free(service, run)
    return found


def see_through(person: Console, line: WifiLine, run: str, found: Carried) -> None:
    """Waits for the plan, takes control, releases and resumes until the run is over."""
    person.wait(run, "Idle", *ENDED, seconds=PLAN_S)
    person.take_control()
    begun_s = line.now_s
    release(person, run)
    again_s = 0.0
    while (now := person.run(run))["state"] not in ENDED:
        if now["state"] == "Held" and person.linked and time.monotonic() > again_s:
            found.taps += 1
            person.command(run, "resume")
            again_s = time.monotonic() + ANSWER_S
        if now["state"] != "Held":
            again_s = 0.0
        time.sleep(LOOK_S)
    found.seconds, found.gaps = line.now_s - begun_s, len(line.gaps.within(begun_s, line.now_s))
    found.causes, found.longest_s = holds(person.http.get(f"/api/runs/{run}/events?kind=event").json())
    why = now["reason"] and now["reason"]["text"]
    found.lost = None if now["state"] == "Complete" else f"lost, {now['state']}: {now['reason_kind']}: {why}"


def release(person: Console, run: str) -> None:
    """Pressed again where it is refused."""
    for _ in range(PRESSES):
        answer = person.release(run)
        if answer.status_code == 200:
            return
        time.sleep(LOOK_S)
    raise AssertionError(f"the release was refused {PRESSES} times, the last one with {answer.text}")


def holds(messages: list[dict[str, Any]]) -> tuple[list[str], float]:
    """The cause of each hold in the events of a run, and how long the longest was, s."""
    causes, longest_s, since = [], 0.0, None
    for message in messages:
        event, at = message["event"], datetime.fromisoformat(message["at"])
        if event["kind"] == "robot_stopped" and event["held"]:
            causes.append((event.get("lateness") or {}).get("cause", event["error"]))
        if event["kind"] == "state_changed":
            if since is not None:
                longest_s = max(longest_s, (at - since).total_seconds())
            since = at if event["state"] == "Held" else None
    return causes, longest_s


def leave_free(service: RealService, run: str) -> None:
    """Ends the run if it has not, without the line, so that the cell is free for the next."""
    person = Console(service)
    if person.run(run)["state"] not in ENDED:
        person.http.post(f"/api/runs/{run}/commands", json={"command": "stop"})
    if person.wait(run, *ENDED)["state"] == "Aborted":
        person.take_control()
        wait_for(lambda: person.command(run, "clear").status_code == 200, f"{run} to be cleared")
    person.leave()


def say(profile: Profile, found: list[Carried]) -> None:
    """What became of the runs over a line."""
    whole = [run for run in found if run.lost is None]
    taps, gaps = sum(run.taps for run in found), sum(run.gaps for run in found)
    share = len(whole) / len(found)
    print(f"\n{profile.name}: {len(whole)} of {len(found)} complete ({share:.1%}, wanted {SHARE:.0%}); ", end="")
    print(f"{sum(not run.taps for run in whole)} without a tap; robot and person {max(run.seconds for run in found):.0f} s at most")
    per_gap = f"{taps / gaps:.2f} a gap, " if gaps else ""
    more = sum(sum(cause in LINK for cause in run.causes) > run.gaps for run in found)
    print(f"  taps {taps}, gaps {gaps}: {per_gap}runs with more holds for their link than gaps: {more}")
    causes = Counter(cause for run in found for cause in run.causes)
    print(f"  holds: {dict(causes) or 'none'}; longest {max(run.longest_s for run in found):.1f} s")
    for run in found:
        if run.lost is not None:
            print(f"  {run.lost}")


def main() -> None:
    """Prints one line for each run, then what became of them."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("profiles", nargs="*", help=f"all, or some of {' '.join(PROFILES)}")
    parser.add_argument("--runs", type=int, default=100, help="over each line")
    parser.add_argument("--seed", type=int, default=0, help="of the first run, and of its line")
    parser.add_argument("--at-once", type=int, default=1, help="services at the same time; more than there are cores make each other late")
    given = parser.parse_args()
    seeds = [list(range(given.seed, given.seed + given.runs))[k :: given.at_once] for k in range(min(given.at_once, given.runs))]
    for name in given.profiles or PROFILES:
        with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(len(seeds)) as pool:
            folders = [Path(folder) / str(k) for k in range(len(seeds))]
            found = [run for part in pool.map(partial(series, PROFILES[name]), folders, seeds) for run in part]
        say(PROFILES[name], found)


if __name__ == "__main__":
    main()
