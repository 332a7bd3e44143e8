"""The motion that a robot's planner has planned or has the arm carry out, for the ghost in the tab World."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Final

from jauspy.console.languages import joined, sentence
from jauspy.console.robot_geometry import RobotGeometry, positions_of
from jauspy.errors import JausError
from jauspy.geometry.urdf import RobotDescription
from jauspy.ocu.planner import PLANNER, MotionPlan, PlannerState
from jauspy.ocu.robot import Robot

INTERVAL: Final = 0.4
"""Seconds between two queries for the state of the planner."""
FRAMES: Final = 60
"""Postures of the ghost that browsers get, at most."""
SHOWN: Final = ("planned", "executing", "planning")
"""Phases in which there may be a plan."""
PHASES: Final = {
    "planning": sentence("planning"),
    "planned": sentence("planned"),
    "executing": sentence("executing"),
    "reached": sentence("reached"),
    "failed": sentence("failed"),
}
"""What pages call the phases of a planner."""


class PlannedMotion:
    """The plan of the robot's first planner; `robot` returns the robot's last discovery, or None."""

    def __init__(self, robot: Callable[[], Robot | None]) -> None:
        self.plan: MotionPlan | None = None
        self.state: PlannerState | None = None
        """None without a planner that answers."""
        self.version = 0
        """Changes with the plan."""
        self._robot = robot

    async def run(self) -> None:
        """Follow the planner until cancelled."""
        while True:
            await self._look()
            await asyncio.sleep(INTERVAL)

    async def _look(self) -> None:
        robot = self._robot()
        offering = [] if robot is None else list(robot.info.offering(PLANNER))
        state, plan = None, None
        if robot is not None and offering:
            planner = robot.planner_of(offering[0].id)
            try:
                state = await planner.state()
                if state.phase in SHOWN:
                    plan = self.plan if self._is_known(state) else await planner.preview()
            except JausError:
                state = None
        if plan != self.plan:
            self.plan, self.version = plan, self.version + 1
        self.state = state

    def _is_known(self, state: PlannerState) -> bool:
        before = self.state
        return before is not None and (before.number, before.phase, before.replans) == (
            state.number,
            state.phase,
            state.replans,
        )

    def message(
        self,
        geometry: RobotGeometry,
        description: RobotDescription | None,
        positions: Mapping[str, float],
        poses: Mapping[str, Sequence[float]],
    ) -> dict[str, Any] | None:
        """Postures of the ghost, as positions of the moving joints, and the duration in seconds; or None."""
        plan = self.plan
        if plan is None or description is None:
            return None
        count = min(FRAMES, max(2, len(plan.times)))
        times = [plan.duration * number / (count - 1) for number in range(count)]
        frames = [positions_of(geometry, description, {**positions, **plan.at(time)}, poses) for time in times]
        return {"frames": frames, "duration": round(plan.duration, 3)}

    @property
    def text(self) -> str:
        """Plan and state in words; empty without both."""
        state, plan = self.state, self.plan
        if state is None or state.phase == "idle":
            return ""
        words: list[str] = [PHASES.get(state.phase, state.phase)]
        if state.phase == "executing":
            words.append(f"{100.0 * state.progress:.0f} %")
        parts: list[str] = [joined(words, " ")]
        if plan is not None:
            parts.append(f"{plan.duration:.1f} s")
            if plan.clearance == plan.clearance:  # no NaN
                near = sentence("clearance {distance:.1f} cm", distance=100.0 * plan.clearance)
                parts[-1] = joined([parts[-1], near], ", ")
        return joined([*parts, *([state.text] if state.text else [])], ": ")
