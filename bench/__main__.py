"""The benches of docs/figures.md, one after the other; each is also `python -m bench.<name>`.

Those that fill a FOLDER (blind trials, recordings of strangers, what probabilities are learnt from) take hours to days, go on where they
were cut short, and are run by themselves.
"""

from __future__ import annotations

import subprocess
import sys

BENCHES = (
    "online",
    "clocks",
    "sensor_faults",
    "sns_step",
    "plant_speed",
    "start_search",
    "second_opinion",
    "diagnosis",
    "diagnosis --long 600",
    "diagnosis_elsewhere",
    "diagnosis_of_conditions --count 3",
    "procedure --seeds 20",
    "procedure --seeds 20 --cell ur5e_line",
    "coverage --count 1000 --seeds 20",
    "conditions --count 200",
    "swinging_arms --count 40",
    "eight_plans --count 20",
    "long_recording",
    "long_recording --seconds 60 --rate 500",
    "torque_coverage",
    "setup_slips",
    "time_to_target",
    "random_cells --count 200 --first 1000",
    "planning_time",
    "real_robots --count 300",
    "drivers --faults 0 --minutes 0.1 --patience 20",
    "drivers --faults 20 --minutes 0",
    "stops --times 20 --at-once 3",
    "breakdowns --times 20",
    "store --times 20 --at-once 3",
    "wifi --runs 100 --at-once 2",
    "busy --runs 20",
    "retries",
    "kills --count 200 --seed 2",
    "lateness",
    "watchers",
    "mcap_import",
    "screen_latency",
    "console",
    "console_traffic",
    "report_page",
)


def main() -> None:
    """All of them, and at the end which have failed."""
    failed = []
    for bench in BENCHES:
        print(f"\n== {bench}", flush=True)
        name, *options = bench.split()
        if subprocess.run([sys.executable, "-m", f"bench.{name}", *options], check=False).returncode:
            failed.append(bench)
    if failed:
        sys.exit(f"failed: {', '.join(failed)}")


if __name__ == "__main__":
    main()
