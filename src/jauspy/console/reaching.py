"""Reaching for a thing that was clicked: a pose of the tool before it, planned, shown, and carried out when agreed.

The robot's own planner (service MotionPlanner) plans and moves the arm. The operator's page controls the planner, and
lends it the arm for the motion, see `Operation.lent`.
"""

from __future__ import annotations

import asyncio
import math
from typing import TYPE_CHECKING, Final

from jauspy.console.languages import sentence
from jauspy.errors import ConfigError
from jauspy.geometry.vectors import Vector
from jauspy.ocu.planner import PLANNER, MotionPlan, Planner, PlanningFailed
from jauspy.ocu.robot import Robot

if TYPE_CHECKING:
    from jauspy.console.operation import Operation

STANDOFF: Final = 0.1
"""Metres between the tool and the thing."""
SIZE: Final = (0.03, 0.03, 0.03)
"""Metres of the box around the wanted place in which the tool may end."""
ANGLE: Final = math.radians(30.0)
"""By which the tool may point beside the thing, before any attitude will do."""
MAX_DISTANCE: Final = 10.0
"""Metres from the robot within which a browser may point at something."""
DECISION_TIME: Final = 60.0
"""Seconds in which the operator may agree with a plan; then it is forgotten."""


class Reaching:
    """One plan of one page, from the click to the end of its motion."""

    def __init__(self) -> None:
        self._agreed: asyncio.Future[None] | None = None

    @property
    def asks(self) -> bool:
        """True while a plan waits for the operator."""
        return self._agreed is not None and not self._agreed.done()

    def agree(self) -> None:
        """Carry out the plan that is shown; without effect if there is none."""
        if self._agreed is not None and not self._agreed.done():
            self._agreed.set_result(None)

    async def reach(self, robot: Robot, operation: Operation, thing: Vector) -> None:
        """Plan, wait until the operator agrees, and move; `thing` in metres in the robot's frame.

        Cancelling ends planning, or stops the arm. Raises `ConfigError` and `PlanningFailed` with the reason if nothing
        moves.
        """
        found = next(iter(robot.info.offering(PLANNER)), None)
        if found is None:
            raise ConfigError(sentence("this robot has no planner for its arm"))
        planner = robot.planner_of(found.id)
        async with robot.control(str(found.id), authority=operation.authority):
            arm = await planner.arm()
            tool = await robot.manipulator(arm).tool()
            plan = await _plan(planner, (tool.x, tool.y, tool.z), thing)
            self._agreed = asyncio.get_running_loop().create_future()
            try:
                async with asyncio.timeout(DECISION_TIME):
                    await self._agreed
            except TimeoutError:
                raise ConfigError(sentence("the plan was forgotten: nobody has agreed with it")) from None
            finally:
                self._agreed = None
            async with operation.lent(arm):
                await planner.execute(plan)


def pointed_at(asked: object) -> Vector | None:
    """The place of a thing that a browser sends, as {"x": 0.9, "y": 0.1, "z": 0.4}; None for all else."""
    if not isinstance(asked, dict):
        return None
    values = [asked.get(axis) for axis in ("x", "y", "z")]
    numbers = [value for value in values if isinstance(value, int | float) and not isinstance(value, bool)]
    if len(numbers) != len(values):
        return None
    try:
        x, y, z = (float(number) for number in numbers)
    except OverflowError:
        return None
    return (x, y, z) if math.hypot(x, y, z) < MAX_DISTANCE else None  # not for NaN


def pose_before(tool: Vector, thing: Vector) -> tuple[Vector, Vector]:
    """Position and attitude (roll, pitch, yaw) of a tool that comes from where it is, and points at the thing.

    The x axis of the tool is ahead. Raises `ConfigError` for a thing that is nearer than `STANDOFF`.
    """
    x, y, z = (there - here for there, here in zip(thing, tool, strict=True))
    distance = math.hypot(x, y, z)
    if distance <= STANDOFF:
        raise ConfigError(
            sentence("the tool is already there: {distance:.0f} cm before the thing", distance=100.0 * distance)
        )
    share = 1.0 - STANDOFF / distance
    position = (tool[0] + share * x, tool[1] + share * y, tool[2] + share * z)
    return position, (0.0, -math.asin(z / distance), math.atan2(y, x))


async def _plan(planner: Planner, tool: Vector, thing: Vector) -> MotionPlan:
    """A plan with the tool pointing at the thing; if there is none, with any attitude."""
    position, rpy = pose_before(tool, thing)
    try:
        return await planner.plan_region(position, rpy, size=SIZE, angle=ANGLE)
    except PlanningFailed:
        return await planner.plan_pose(position)
