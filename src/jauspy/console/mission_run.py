"""Carries out a mission: drives through the waypoints leg by leg, and does at each what it asks for.

The robot drives each leg by its own list of waypoints; the console acts between legs. So a mission ends with control
of the robot: the robot then stops by its own rules.
"""

from __future__ import annotations

import asyncio
import math
import re
from collections.abc import Callable, Iterator
from contextlib import suppress
from datetime import datetime
from pathlib import Path
from typing import Final

from jauspy.console.languages import sentence
from jauspy.console.mission import Action, Look, Mission, Still, Wait
from jauspy.console.route import LOOK_INTERVAL, NEAR, Route
from jauspy.errors import ConfigError, JausError
from jauspy.ocu.arm import PAN_TILT_DRIVER, Arm
from jauspy.ocu.robot import Robot

PATIENCE: Final = 5.0
"""Seconds in which a robot that got a leg begins it, its pose shows that it has arrived, or it answers again."""
SUFFIXES: Final = {"JPEG": ".jpg", "PNG": ".png"}


class MissionRun:
    """One mission of one robot. `run` raises `JausError` when it cannot go on."""

    def __init__(
        self,
        mission: Mission,
        route: Route,
        robot: Robot,
        speed: float,
        *,
        folder: Path,
        note: Callable[[str], None],
    ) -> None:
        self.mission = mission
        self.index = 0
        """The index of the waypoint to which the robot drives, or at which it acts."""
        self.doing = ""
        """What it does there, as text; empty while it drives."""
        self.is_done = False
        self._route, self._robot, self._speed, self._folder, self._note = route, robot, speed, folder, note

    async def check(self) -> None:
        """Raise `ConfigError` unless the robot has the cameras and the pan-tilt unit that the mission asks for."""
        asked = dict.fromkeys(step.action for step in self.mission.steps if isinstance(step.action, Look | Still))
        for action in asked:
            try:
                if isinstance(action, Still):
                    await self._robot.camera(action.camera or None).check_still()
                else:
                    self._pan_tilt_unit()
            except JausError as error:
                number = 1 + next(at for at, step in enumerate(self.mission.steps) if step.action == action)
                raise ConfigError(sentence("waypoint {number}: {error}", number=number, error=error)) from error

    async def run(self) -> None:
        """Carry out all; when cancelled, the robot waits on the way."""
        try:
            for first, last in _legs(self.mission):
                await self._drive(first, last)
                if (action := self.mission.steps[last].action) is not None:
                    self.doing = action.text
                    await self._act(last, action)
                    self.doing = ""
            self.index, self.is_done = len(self.mission.waypoints), True
        finally:
            if not self.is_done:
                with suppress(JausError):
                    await asyncio.shield(self._route.set_speed(0.0))

    async def _drive(self, first: int, last: int) -> None:
        route, self.index = self._route, first
        await route.start(self.mission.waypoints[first : last + 1], self._speed_at(first))
        clock = asyncio.get_running_loop().time
        known = moving = clock()  # when the list was read, and when it was being executed
        while True:
            await route.look()
            known = known if route.problem else clock()
            if clock() - known > PATIENCE:
                raise ConfigError(
                    sentence(
                        "the way to waypoint {number} is not known any more: {problem}",
                        number=self.index + 1,
                        problem=route.problem,
                    )
                )
            if route.active is not None:
                moving, before, self.index = clock(), self.index, first + route.active
                speed = self._speed_at(self.index)
                if self.index != before and not route.is_paused and speed != self._speed_at(before):
                    await route.set_speed(speed)
            elif self._is_at(last):
                return
            elif clock() - moving > PATIENCE:
                raise ConfigError(sentence("the robot stopped on the way to waypoint {number}", number=self.index + 1))
            await asyncio.sleep(LOOK_INTERVAL)

    def _is_at(self, index: int) -> bool:
        pose, goal = self._route.pose, self.mission.waypoints[index]
        return pose is not None and math.dist((pose.x, pose.y), (goal.x, goal.y)) <= NEAR

    def _speed_at(self, index: int) -> float:
        return self.mission.steps[index].speed or self._speed

    async def _act(self, index: int, action: Action) -> None:
        match action:
            case Wait():
                await asyncio.sleep(action.seconds)
            case Look():
                await self._look(action)
            case Still():
                await self._save_still(index, action)

    def _pan_tilt_unit(self) -> Arm:
        found = [component for component in self._robot.components if component.find(PAN_TILT_DRIVER)]
        if not found:
            raise ConfigError(sentence("this robot has no camera that turns, and the mission asks for a look"))
        return self._robot.manipulator(found[0].id)

    async def _look(self, action: Look) -> None:
        unit = self._pan_tilt_unit()
        pan, tilt = tuple(await unit.joints())[:2]
        await unit.move({pan: action.pan, tilt: action.tilt})

    async def _save_still(self, index: int, action: Still) -> None:
        photo = await self._robot.camera(action.camera or None).still()
        suffix = SUFFIXES.get(photo.format)
        if suffix is None:
            raise ConfigError(
                sentence("the camera sends a picture of the format {format!r}, which is not saved", format=photo.format)
            )
        name = re.sub(r"[^\w-]+", "_", self._robot.name)[:40]
        stamp = f"{datetime.now().astimezone():%Y%m%d-%H%M%S}"
        path = self._folder / f"{name or self._robot.id}-{stamp}-waypoint-{index + 1}{suffix}"
        try:
            await asyncio.to_thread(_write, path, photo.content)
        except OSError as error:
            raise ConfigError(
                sentence("{path}: cannot be written: {strerror}", path=path, strerror=error.strerror)
            ) from error
        self._note(sentence("robot {robot}: saved {path}", robot=self._robot.id, path=path.name))


def _write(path: Path, content: bytes) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("xb") as file:
        file.write(content)


def _legs(mission: Mission) -> Iterator[tuple[int, int]]:
    """First and last waypoint of each part of the way, which ends where something is done."""
    first = 0
    for index, step in enumerate(mission.steps):
        if step.action is not None or index == len(mission.steps) - 1:
            yield first, index
            first = index + 1


def needs_run(mission: Mission) -> bool:
    """True for a mission that the robot's list of waypoints cannot hold."""
    return any(step.action is not None or step.speed is not None for step in mission.steps)
