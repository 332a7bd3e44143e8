"""A robot with drives on a CAN bus, which drives all the time: `python can_robot.py ROBOT BUS`.

After each failure it makes a Reset and drives again. For each line of its input it prints its state as JSON.
"""

from __future__ import annotations

import json
import logging
import sys
import threading
import time
from collections import Counter
from collections.abc import Iterator
from typing import Final

from jauspy.backends import find
from jauspy.backends.can.faults import DriveFault
from jauspy.backends.can.robot import CanRobot
from jauspy.cli.options import on_bus
from jauspy.logs import LIMIT
from jauspy.robot.robot_files import load, robot_model

STEP: Final = 0.01
"""Seconds."""
RESET_AFTER: Final = 0.3
"""Seconds from a failure to Reset."""
EFFORT: Final = 0.2


class Lines(logging.Handler):
    """Counts the lines that are logged."""

    def __init__(self) -> None:
        super().__init__()
        self.count = 0
        self.addFilter(LIMIT)

    def emit(self, record: logging.LogRecord) -> None:
        """One more."""
        del record
        self.count += 1


class Driver:
    """Drives the robot, and counts what happens to it."""

    def __init__(self, robot: CanRobot, lines: Lines) -> None:
        self._robot = robot
        self._lines = lines
        self._reasons: Counter[str] = Counter()
        self._longest = 0.0
        """Seconds that one step took, a Reset included."""

    def run(self) -> None:
        """Drive until the process ends."""
        while True:
            began = time.monotonic()
            try:
                self._robot.advance(STEP)
                self._robot.drive.set_effort(EFFORT, 0.0)
            except DriveFault as error:
                self._reasons[str(error)] += 1
                time.sleep(RESET_AFTER)
                began += RESET_AFTER
            self._longest = max(self._longest, time.monotonic() - began)
            time.sleep(STEP)

    def states(self) -> Iterator[dict[str, object]]:
        """What has happened, now and at each further call."""
        while True:
            yield {
                "running": self._robot.master.running and self._robot.drive.twist().vx > 0.0,
                "reasons": dict(self._reasons),
                "longest": self._longest,
                "lines": self._lines.count,
                "counters": dict(self._robot.counters),
            }


def main() -> None:
    """Run until the input ends; an exception other than `DriveFault` ends it with the status 1."""
    lines = Lines()
    logging.basicConfig(level=logging.INFO, handlers=[lines])
    robot = find("can").open(robot_model(on_bus(load(sys.argv[1]), sys.argv[2])), "empty")
    assert isinstance(robot, CanRobot)
    driver = Driver(robot, lines)
    thread = threading.Thread(target=driver.run, daemon=True)
    thread.start()
    print("ready", flush=True)
    for _, state in zip(sys.stdin, driver.states(), strict=False):
        print(json.dumps(state | {"alive": thread.is_alive()}), flush=True)
    robot.close()


if __name__ == "__main__":
    main()
