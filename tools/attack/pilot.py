"""The operator in control: drives the robot to and fro on a short course, and says when, by the clock of the machine.

python pilot.py '{"id": "42.1.2", "connect": "local:DIRECTORY", "subsystem": 101, "operator": null}'

It prints `ready` when it controls all that moves. The line `begin` on its standard input starts a new record; `end`
prints `{"legs": [[BEGIN, END, DIRECTION], ...], "refused": COUNT}`: END is when the robot had acknowledged its stop,
null while it drives. `push` lets it drive forward on and on, `rest` stand still, `course` drive the course again.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
import logging
import sys
import time
from typing import Any, Final

import jauspy

SPEED: Final = 0.4
"""m/s"""
LEG: Final = 0.4
"""Seconds of each leg."""
STAND: Final = 0.9
"""Seconds between two legs."""
AUTHORITY: Final = 255
"""With the highest one, no other client is entitled to take control."""
STOP_TIME: Final = 2.0
"""Seconds after the last command in which the robot stops by itself."""
START_TIMEOUT: Final = 20.0
_PAUSE: Final = 0.05


class Pilot:
    """Drives, and remembers its legs."""

    def __init__(self) -> None:
        self._mode = "course"
        self._is_changed = asyncio.Event()
        self.refused = 0
        self._direction = 1.0
        self._legs: list[tuple[float, float | None, float]] = []

    def begin(self) -> None:
        """Forget the legs that have ended."""
        self._legs = [leg for leg in self._legs if leg[1] is None]
        self.refused = 0

    def report(self) -> str:
        """What was driven since then."""
        return json.dumps({"legs": self._legs, "refused": self.refused})

    def set_mode(self, mode: str) -> None:
        """Drive the course, rest, or push, from now on."""
        self._mode = mode
        self._is_changed.set()

    async def drive(self, robot: jauspy.Robot) -> None:
        """Stand, drive a leg, stand; the next time in the other direction."""
        if self._mode != "push":
            await self._pass(STAND)
        if self._mode == "rest":
            return
        forward = self._direction if self._mode == "course" else 1.0
        self._legs.append((time.monotonic(), None, forward))
        try:
            await robot.drive(linear=SPEED * forward)
            await self._pass(LEG)
            while self._mode == "push":
                await self._pass(1.0)
        finally:
            end = time.monotonic() + STOP_TIME  # by itself, if it does not acknowledge the stop
            try:
                await robot.stop()
                end = time.monotonic()
            finally:
                begin, _, _ = self._legs.pop()
                self._legs.append((begin, end, forward))
        self._direction = -forward

    async def _pass(self, seconds: float) -> None:
        """Wait so long, or until the mode changes."""
        self._is_changed.clear()
        with contextlib.suppress(TimeoutError):
            async with asyncio.timeout(seconds):
                await self._is_changed.wait()


async def main(settings: dict[str, Any]) -> None:
    """Drive until standard input is closed."""
    pilot = Pilot()
    async with jauspy.OCU(settings["id"], settings["connect"], operator=settings["operator"]) as ocu:
        robot = await ocu.discover(settings["subsystem"], timeout=START_TIMEOUT)
        async with asyncio.TaskGroup() as tasks:
            driving = tasks.create_task(drive_on(pilot, robot))
            while word := (await asyncio.to_thread(sys.stdin.readline)).strip():
                if word == "begin":
                    pilot.begin()
                elif word == "end":
                    print(pilot.report(), flush=True)
                else:
                    pilot.set_mode(word)
            driving.cancel()


async def drive_on(pilot: Pilot, robot: jauspy.Robot) -> None:
    """Drive until cancelled; who loses control takes it again, and what an emergency has stopped is resumed."""
    is_ready = False
    while True:
        try:
            async with robot.control(authority=AUTHORITY) as control:
                if not is_ready:
                    is_ready = True
                    print("ready", flush=True)
                while control.held:
                    await pilot.drive(robot)
        except* jauspy.JausError as errors:
            pilot.refused += 1
            logging.getLogger("pilot").warning("%s", errors.exceptions[0])
            await asyncio.sleep(_PAUSE)


if __name__ == "__main__":
    logging.basicConfig(level=logging.INFO)
    asyncio.run(main(json.loads(sys.argv[1])))
