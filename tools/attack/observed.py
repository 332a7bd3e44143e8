"""Runs a command of jauspy, says when asked how many tasks of asyncio it has, and records where its robot truly is.

python observed.py TRUTH MUTANT VERB ARGUMENTS... with one path a line on standard input: the number is written to this
path. Every 50 ms a line is appended to the file TRUTH, if the process has a robot of the backend `kinematic`: what the
backend has moved and who is in control, not what is reported to clients. MUTANT is a name of `mutants.py`, or empty.
"""

from __future__ import annotations

import asyncio
import json
import runpy
import sys
import threading
import time
import weakref
from collections.abc import Collection
from pathlib import Path
from typing import Any, Final, TextIO, TypeVar

from jauspy.backends.kinematic import KinematicRobot
from jauspy.cli.main import main
from jauspy.services.host import Host

_T = TypeVar("_T")

INTERVAL: Final = 0.05


def remembered(kind: type[_T]) -> Collection[_T]:
    """All objects of a kind that are made from now on.

    A search by `gc` in another thread breaks what it finds half built: a tuple with a second owner cannot grow.
    """
    found: weakref.WeakSet[_T] = weakref.WeakSet()
    make = kind.__init__

    def made(self: _T, *arguments: Any, **options: Any) -> None:
        make(self, *arguments, **options)
        found.add(self)

    kind.__init__ = made  # type: ignore[method-assign, assignment]
    return found


def tasks() -> int:
    """Tasks of all event loops of this process."""
    return sum(len(asyncio.all_tasks(loop)) for loop in list(LOOPS))


def answer(asked: threading.Event) -> None:
    """Answer until standard input is closed."""
    for line in sys.stdin:
        path = Path(line.strip())
        part = path.with_suffix(".part")
        part.write_text(str(tasks()))
        part.rename(path)
        asked.set()


def record(file: TextIO, asked: threading.Event) -> None:
    """Record the truth from the first question on, when the robot has started."""
    asked.wait()
    robots = list(ROBOTS)
    if not robots:
        return
    hosts = {str(host.id): host for host in list(HOSTS) if host.controller is not None}
    while True:
        file.write(json.dumps(truth(robots[0], hosts)) + "\n")
        time.sleep(INTERVAL)


def truth(robot: KinematicRobot, hosts: dict[str, Host]) -> dict[str, Any]:
    """Time, pose, positions of all joints, and the client in control and the innermost states of each component."""
    pose = robot.drive.pose()
    return {
        "time": time.monotonic(),
        "pose": (pose.x, pose.y, pose.yaw),
        "joints": [position for group in robot.groups.values() for position in group.state().positions],
        "controllers": {id: str(host.controller) for id, host in hosts.items()},
        "states": {id: list(host.path) for id, host in hosts.items()},
    }


LOOPS: Final = remembered(asyncio.BaseEventLoop)
ROBOTS: Final = remembered(KinematicRobot)
HOSTS: Final = remembered(Host)
if __name__ == "__main__":
    _, place, mutant, *sys.argv[1:] = sys.argv
    if mutant:
        runpy.run_path(str(Path(__file__).with_name("mutants.py")))["apply"](mutant)
    questioned = threading.Event()
    threading.Thread(target=answer, args=(questioned,), daemon=True).start()
    truths = Path(place).open("a", buffering=1)  # noqa: SIM115 - as long as the process runs
    threading.Thread(target=record, args=(truths, questioned), daemon=True).start()
    main()
