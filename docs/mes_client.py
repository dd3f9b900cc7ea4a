"""Orders a run, waits for its end, saves the payload for a UR controller. Needs Python alone: mes_client.py ADDRESS KEY < order.json"""

import json
import sys
import time
from pathlib import Path
from urllib.request import HTTPError, Request, urlopen

address, key = sys.argv[1:]
order = json.load(sys.stdin)  # {"cell": "lwr4_bench", "payload": "steel_block", "order_id": "JO-2026-004711"}
headers = {"Authorization": f"Bearer {key}", "Content-Type": "application/json", "Idempotency-Key": order["order_id"]}


def ask(path: str, body: bytes | None = None) -> bytes:
    try:
        with urlopen(Request(address + path, body, headers), timeout=30) as answer:
            return answer.read()
    except HTTPError as error:
        sys.exit(json.loads(error.read())["detail"])


run = json.loads(ask("/api/runs", json.dumps(order).encode()))
while run["outcome"] is None:  # an operator at the cell looks at the plan and releases it meanwhile
    print(run["state"], run["job_state"], flush=True)
    time.sleep(2)
    run = json.loads(ask(f"/api/runs/{run['run']}"))
if run["outcome"] != "completed":
    sys.exit(f"{run['outcome']}: {run['reason']['text']}")
Path(f"{order['order_id']}.script").write_bytes(ask(f"/api/runs/{run['run']}/exports/ur"))
print(f"{run['result']['mass_kg']:.3f} kg")
