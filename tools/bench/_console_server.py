"""The operator's console in a process of its own, which remembers when it sent drive commands.

python tools/bench/_console_server.py ROOT

Prints its URL; then, for each line that it reads, the monotonic times of the commands so far that move a robot.
"""

from __future__ import annotations

import asyncio
import json
import sys
import time
from dataclasses import fields
from typing import Any

from jauspy.console.server import serving
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.mobility import SetVelocityCommand, SetWrenchEffort
from jauspy.ocu import OCU

DRIVING = {kind.CODE.to_bytes(2, "little"): kind for kind in (SetVelocityCommand, SetWrenchEffort)}
sent_at: list[float] = []


class WatchedOCU(OCU):
    """Remembers commands besides."""

    def trace(self, callback: Any) -> None:
        """As `OCU.trace`."""

        def both(source: JausID, destination: JausID, payload: bytes, *, sent: bool) -> None:
            kind = DRIVING.get(payload[:2]) if sent else None
            if kind is not None and _moves(registry.decode_as(kind, payload)):
                sent_at.append(time.monotonic())
            if callback is not None:
                callback(source, destination, payload, sent=sent)

        super().trace(both)


def _moves(command: Any) -> bool:
    numbers = (getattr(command, each.name) for each in fields(command))
    return any(isinstance(each, float) and each for each in numbers)


async def serve(root: str) -> None:
    """Serve until standard input closes."""
    async with (
        WatchedOCU("42.1.1", f"local:{root}") as ocu,
        OCU("42.1.2", f"local:{root}") as stopper,
        serving(ocu, stopper, "127.0.0.1", 0) as url,
    ):
        print(url, flush=True)
        while await asyncio.to_thread(sys.stdin.readline):
            print(json.dumps(sent_at), flush=True)


if __name__ == "__main__":
    asyncio.run(serve(sys.argv[1]))
