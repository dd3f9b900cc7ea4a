"""Every figure of the README, one bench after the other; each is also `python -m bench.<name>`."""

from __future__ import annotations

import subprocess
import sys

BENCHES = ("online", "sns_step", "plant_speed", "start_search", "procedure", "coverage", "random_cells")

for name in BENCHES:
    print(f"\n== {name}", flush=True)
    subprocess.run([sys.executable, "-m", f"bench.{name}"], check=True)
