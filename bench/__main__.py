"""Every figure of docs/figures.md, one bench after the other; each is also `python -m bench.<name>`."""

from __future__ import annotations

import subprocess
import sys

BENCHES = (
    ("online",),
    ("clocks",),
    ("sensor_faults",),
    ("sns_step",),
    ("plant_speed",),
    ("start_search",),
    ("second_opinion",),
    ("diagnosis",),
    ("procedure", "--seeds", "20"),
    ("coverage", "--count", "1000", "--seeds", "20"),
    ("conditions", "--count", "200"),
    ("swinging_arms", "--count", "40"),
    ("eight_plans", "--count", "20"),
    ("long_recording",),
    ("long_recording", "--seconds", "60", "--rate", "500"),
    ("time_to_target",),
    ("random_cells", "--count", "200", "--first", "1000"),
    ("planning_time",),
    ("real_robots", "--count", "300"),
    ("store", "--times", "20", "--at-once", "3"),
    ("wifi", "--runs", "100", "--at-once", "2"),
    ("busy", "--runs", "20"),
)

for name, *options in BENCHES:
    print(f"\n== {name} {' '.join(options)}", flush=True)
    subprocess.run([sys.executable, "-m", f"bench.{name}", *options], check=True)
