"""The operator is cut off in the middle of a drive; and a robot that did not run gets what he had sent before."""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from typing import Final

from ..arena import ROBOT, Arena
from ..attack import Attack, Attacker, Bounds
from ..processes import Honest
from ..truth import Sample

COMMAND_TIMEOUT: Final = 2.0
CONTROL_TIMEOUT: Final = 5.0
"""Of the robot inc1."""
MARGIN: Final = 1.5
STALL: Final = 0.9
"""Seconds in which the robot does not run; after a longer time it stops everything by itself."""
QUEUED: Final = 0.2
"""Seconds of these in which commands arrive."""
BRAKING: Final = 0.3
MOVED: Final = 0.05
"""Metres."""


def _pilot(arena: Arena) -> Honest:
    assert arena.stage.pilot is not None
    arena.stage.pilot.tell("push")
    _wait(arena, 1.5)
    return arena.stage.pilot


def _wait(arena: Arena, seconds: float) -> None:
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        arena.command_robot()
        time.sleep(0.05)


def _moved(samples: list[Sample], since: float) -> float:
    after = [each for each in samples if each.time >= since]
    return max((after[0].distance(each) for each in after), default=math.inf)


def _cut_off(arena: Arena) -> None:
    """The robot stops when commands do not come any more, and takes control back; nobody else gets it to move."""
    pilot = _pilot(arena)
    with pilot.stopped():
        begin = time.monotonic()
        arena.sent += 1
        _wait(arena, COMMAND_TIMEOUT + MARGIN)
        stopped = time.monotonic()
        time.sleep(max(0.0, begin + CONTROL_TIMEOUT + MARGIN - stopped))
        samples = arena.stage.samples()
        controllers = samples[-1].controllers[str(ROBOT)]
        arena.require(
            _moved([each for each in samples if each.time < stopped + 1.0], stopped) <= MOVED,
            f"the robot moves {COMMAND_TIMEOUT + MARGIN:g} s after the last command",
        )
        arena.require(controllers == "None", f"{controllers} is still in control")
    pilot.tell("rest")


def _stalled(arena: Arena) -> None:
    """The robot does not run for a moment while it drives; commands that waited do not prolong the drive."""
    robot = next(each for each in arena.stage.victims if each.name == "robot")
    pilot = _pilot(arena)
    with robot.stopped():
        begin = time.monotonic()
        time.sleep(QUEUED)
        pilot.pause()
        arena.sent += 1
        time.sleep(STALL - QUEUED)
    stopped = begin + COMMAND_TIMEOUT + BRAKING
    _wait(arena, begin + COMMAND_TIMEOUT + STALL + BRAKING - time.monotonic())
    moved = _moved(arena.stage.samples(), stopped)
    pilot.resume()
    pilot.tell("rest")
    arena.require(moved <= MOVED, f"the robot drove {moved:.2f} m by commands that had waited for {STALL - QUEUED:g} s")


BOUNDS = Bounds(lost=1.0, silence=math.inf, moved=math.inf, driven=0.0, control=0.0)


def _attack(name: str, unit: str, run: Callable[[Arena], None]) -> Attack:
    return Attack(name, Attacker.REMOTE, unit, run, BOUNDS, restarts=True)


CUT_OFF = _attack("cut-off", "cuts", _cut_off)
STALLED = _attack("stalled-robot", "stalls", _stalled)
