"""Points the camera on the chassis at what the arm will do, by PanTiltJointPositionDriver."""

from __future__ import annotations

import asyncio
import math
from contextlib import AsyncExitStack
from typing import Final

from jauspy.cli.demo import plan
from jauspy.cli.demo.patience import within
from jauspy.cli.demo.report import Finding
from jauspy.messages.manipulator import QueryPanTiltJointPositions, SetPanTiltJointPositions
from jauspy.ocu.robot import ComponentClient

EXACT: Final = 0.01
"""Radians."""


async def look_up(stack: AsyncExitStack, mount: ComponentClient) -> Finding:
    """Pan and tilt as the plan says; the mount stays in our control as long as the stack lasts."""
    driver, sensor = mount.service("PanTiltJointPositionDriver"), mount.service("PanTiltJointPositionSensor")
    await stack.enter_async_context(driver.control(plan.AUTHORITY))
    await driver.resume()
    await driver.send(SetPanTiltJointPositions(*plan.AIM), ack=True)
    async with within(plan.MOVE_TIME, lambda: f"the mount of {mount.id} does not get to {plan.AIM} rad"):
        while True:
            told = await sensor.query(QueryPanTiltJointPositions())
            off = max(abs(told.joint1_position - plan.AIM[0]), abs(told.joint2_position - plan.AIM[1]))
            if off <= EXACT:
                break
            await asyncio.sleep(0.05)
    up = math.degrees(told.joint2_position)
    return Finding("aim", f"the chassis' camera looks {up:.1f}° up", True, {"off": off})
