"""The judge: what the simulation knows and the demo does not, read from what the robot's process prints."""

from __future__ import annotations

import asyncio
import json
import math
import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Final

from jauspy.demo import plan
from jauspy.demo.plan import Plan
from jauspy.demo.report import StageResult, time_limit
from jauspy.geometry.poses import PlanarPose

COUNTERS_TIMEOUT: Final = 5.0  # seconds from SIGUSR1 to the robot's counters


@dataclass(frozen=True, slots=True)
class Place:
    """The true pose of the robot, from the simulation."""

    pose: PlanarPose
    height: float
    """Metres above the world's origin."""
    pitch: float = 0.0
    """Radians, nose down."""


class RobotOutput:
    """Collects what the robot's process prints at SIGUSR1: counters, and what a simulation knows of the robot."""

    def __init__(self) -> None:
        self._counters: dict[str, int] = {}
        self.true_place: Place | None = None
        self.contacts: Mapping[str, Mapping[str, int]] | None = None
        """Samples of the physics with a contact, by joint group and body of the world; None without a simulation."""

    def line(self, text: str) -> None:
        """Read one line."""
        if found := re.fullmatch(r"\s+(realtime\.\w+)\s+(\d+)", text):
            self._counters[found[1]] = int(found[2])
        elif found := re.match(r"true pose of .*: x (\S+) m  y (\S+) m  z (\S+) m  yaw (\S+)°  pitch (\S+)°", text):
            x, y, z, yaw, pitch = map(float, found.groups())
            self.true_place = Place(PlanarPose(x, y, math.radians(yaw)), z, math.radians(pitch))
        elif found := re.fullmatch(r"contacts of \S+: (\{.*\})", text):
            contacts: Any = json.loads(found[1])
            self.contacts = contacts

    async def counters(self) -> dict[str, int]:
        """The real-time counters, once they are printed; counters of zero are missing."""
        async with time_limit(COUNTERS_TIMEOUT, lambda: "the robot's process does not print its counters"):
            while "realtime.steps" not in self._counters:  # noqa: ASYNC110 - lines come when they come
                await asyncio.sleep(0.05)
        return self._counters

    def results(self, goals: Plan) -> list[StageResult]:
        """The drive and the reach, judged by the simulation; empty without one."""
        found = [] if self.true_place is None else [true_place(self.true_place, goals)]
        return found if self.contacts is None else [*found, touched(self.contacts, goals)]


def true_place(place: Place, goals: Plan) -> StageResult:
    """Check with the simulation's pose, not the estimated one, whether the robot has reached its goal."""
    goal = goals.goal
    off = math.dist(place.pose[:2], (goal.x, goal.y))
    turn = math.remainder(place.pose.yaw - goal.heading, math.tau)
    rise = place.height - goals.ground
    level = f", {100 * place.height:.1f} cm above the start" if goals.ground else ""
    return StageResult(
        "truth",
        f"{100 * off:.1f} cm and {math.degrees(turn):+.1f}° off in the simulation{level}, by which the drive is judged",
        off <= plan.TRUE_TOLERANCE[0] and abs(turn) <= plan.TRUE_TOLERANCE[1] and abs(rise) <= plan.GROUND_TOLERANCE,
        {
            "true_distance_error": off,
            "true_heading_error": turn,
            "true_height": place.height,
            "true_pitch": place.pitch,
        },
    )


def touched(contacts: Mapping[str, Mapping[str, int]], goals: Plan) -> StageResult:
    """Check with the simulation's contacts that arm and gripper kept off what the thing stands on."""
    thing = goals.thing
    count, held = (contacts.get("arm", {}).get(body, 0) for body in (thing.stands_on, thing.body))
    where = "the ground" if thing.stands_on == "world" else f"the {thing.stands_on}"
    how = f"touched {where} in {count} samples of the physics" if count else f"never touched {where}"
    return StageResult(
        "contacts",
        f"arm and gripper {how}, and touched the {thing.name} in {held} samples",
        not count,
        {"support_contacts": count, "thing_contacts": held},
    )
