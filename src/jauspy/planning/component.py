"""A planner as a component beside a robot: the service MotionPlanner, and the client that moves the arm."""

from __future__ import annotations

from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from typing import Final

from jauspy.component import Component
from jauspy.ids import JausID
from jauspy.planning.execution import PlannedArm
from jauspy.planning.service import MotionPlannerService
from jauspy.services.core import Discovery
from jauspy.services.core.discovery import vehicle_identities
from jauspy.transport import Transport

NAME: Final = "motion planner"


@asynccontextmanager
async def planner_component(
    id: str | JausID,
    planned: PlannedArm,
    *,
    connect: str | None = None,
    transport: Transport | None = None,
) -> AsyncIterator[Component]:
    """The component that offers MotionPlanner for this arm while the block runs; it belongs to the robot's subsystem.

    `connect` and `transport` as for `Component`. The arm stops, if it is moved, when the block is left.
    """
    _, group = await planned.group()
    service = MotionPlannerService(planned, group.joints, planned.tree.root, group.tip)
    robot = planned.robot.name  # whichever component of the robot is asked, the name of the robot is the same
    identities = vehicle_identities(robot, f"{robot} node {JausID.of(id).node}", NAME)
    async with Component(
        id, [service, Discovery(identities)], name=NAME, connect=connect, transport=transport
    ) as component:
        try:
            yield component
        finally:
            service.end_motion()
            await service.wait_idle()
