"""Subscribes to clouds and saves them: `python subscriber.py ADDRESS`, until one comes in the frame `end`.

It prints `ready`, and at the end as JSON how many clouds came in the frame `honest`, by how many seconds `receive` was
late at most, and how many saved files have a header with more than was to be written.
"""

from __future__ import annotations

import json
import sys
import time
from pathlib import Path
from typing import Final

from jauspy.cloud.stream import CloudSubscriber, save

TIMEOUT: Final = 0.5
_ELEMENT: Final = b"\nelement "


def main(address: str) -> None:
    """Receive until the end."""
    path = Path("cloud.ply")
    honest = spoiled = 0
    late = 0.0
    with CloudSubscriber(address) as subscriber:
        print("ready", flush=True)
        while True:
            begin = time.monotonic()
            cloud = subscriber.receive(TIMEOUT)
            late = max(late, time.monotonic() - begin - TIMEOUT)
            if cloud is None:
                continue
            if cloud.frame == "end":
                break
            honest += cloud.frame == "honest"
            save(cloud, path)
            spoiled += path.read_bytes().partition(b"end_header")[0].count(_ELEMENT) != 1
    print(json.dumps({"honest": honest, "late": late, "spoiled": spoiled}))


if __name__ == "__main__":
    main(sys.argv[1])
