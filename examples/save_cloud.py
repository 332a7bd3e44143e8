"""Subscribe to the point clouds of a lidar or depth camera, and save each.

`python save_cloud.py tcp://127.0.0.1:5565 FOLDER [COUNT] [pcd|ply]`; `jauspy up inc1 --cloud tcp://127.0.0.1:5565`
publishes them.
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Final

from jauspy.cloud.stream import CloudSubscriber, save
from jauspy.errors import JausError

TIMEOUT: Final = 10.0
"""Seconds without a cloud after which it gives up."""


def main(address: str, folder: str, count: str = "10", kind: str = "ply") -> int:
    """Save so many clouds; 1 when none come any more."""
    Path(folder).mkdir(parents=True, exist_ok=True)
    with CloudSubscriber(address) as subscriber:
        for _ in range(int(count)):
            cloud = subscriber.receive(TIMEOUT)
            if cloud is None:
                print(f"nothing was published at {address} for {TIMEOUT:g} s", file=sys.stderr)
                return 1
            path = Path(folder) / f"cloud_{cloud.number:06}.{kind}"
            save(cloud, path)
            print(f"{path}: {len(cloud)} points in {cloud.frame}")
        print(", ".join(f"{number} {what}" for what, number in subscriber.counters.items()))
    return 0


if __name__ == "__main__":
    if not 3 <= len(sys.argv) <= 5:
        sys.exit(__doc__)
    try:
        sys.exit(main(*sys.argv[1:]))
    except JausError as error:
        sys.exit(str(error))
