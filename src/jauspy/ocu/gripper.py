"""The gripper: open and close, with a force in newtons or an effort in percent."""

# ruff: noqa: ASYNC109 - a timeout ends in an error that says where the fingers are

from __future__ import annotations

import asyncio
import math
from datetime import UTC, datetime
from typing import Final

from jauspy.arguments import check_number
from jauspy.errors import ConfigError, RequestError
from jauspy.messages.manipulator import QueryJointForceTorques, ReportJointForceTorques, SetEndEffectorEffort
from jauspy.ocu.connection import Connection
from jauspy.ocu.explain import check_ready
from jauspy.ocu.joints import FORCE_SENSOR, POSITION_SENSOR, JointTable, joint_table, reported
from jauspy.ocu.state import Joints
from jauspy.ocu.subsystems import ComponentInfo

DRIVER: Final = "PrimitiveEndEffector"
DEFAULT_EFFORT: Final = 50.0
"""Percent."""
START_TIME: Final = 0.4
"""Seconds until the fingers move."""
POLL_INTERVAL: Final = 0.05
STILL_REPORTS: Final = 5
"""Consecutive reports without motion after which the fingers count as stopped."""
MAX_STEP: Final = 3e-4
"""Metres or radians between two reports up to which a finger counts as stopped."""
WIDTH_TOLERANCE: Final = 1e-6
"""Metres by which a width may lie beyond a limit."""
BLIND_TIME: Final = 2.0
"""Seconds to wait for a gripper that does not report its fingers."""


class Gripper:
    """A gripper with the service PrimitiveEndEffector."""

    def __init__(self, connection: Connection, info: ComponentInfo) -> None:
        self.info: ComponentInfo = info
        """The component."""
        self._connection = connection
        self._table: JointTable | None = None

    def __repr__(self) -> str:
        return f"<gripper {self.info.id}>"

    async def close(self, *, force: float | None = None, effort: float | None = None, timeout: float = 10.0) -> Joints:
        """Close until the fingers stop, and hold the force; returns the positions of the fingers.

        `force` is the force of each finger in newtons, `effort` percent of the greatest force, by default 50. The force
        is kept after the block of `control()`: a gripper does not drop what it holds.
        """
        return await self._squeeze(await self._percent(force, effort), timeout)

    async def open(self, *, effort: float | None = None, timeout: float = 10.0) -> Joints:
        """Open until the fingers stop; returns the positions of the fingers."""
        return await self._squeeze(-await self._percent(None, effort), timeout)

    async def open_to(self, width: float, *, effort: float = 25.0, timeout: float = 10.0) -> float:
        """Open or close until there are `width` metres between the fingers, or they stop; then hold them there.

        JAUS has no command for this: the effort (percent) ends when a report contains the width, so the fingers may
        overshoot by some millimetres; with less effort they overshoot less. Returns the width that they reached.
        """
        check_number(width, "width")
        least, greatest = await self.width_limits()
        if not least - WIDTH_TOLERANCE <= width <= greatest + WIDTH_TOLERANCE:
            raise ConfigError(f"the fingers of {self.info.id} open {least:g}..{greatest:g} m, not {width:g}")
        start = await self.width()
        closes = width < start
        percent = await self._percent(None, effort)
        await check_ready(self._connection, self.info.id)
        try:
            await self._send(percent if closes else -percent)
            await self._until(width, start, timeout, closes=closes)
        finally:
            await self._send(0.0)
        return await self.width()

    async def has_width(self) -> bool:
        """True for a gripper that reports how wide its fingers are open."""
        return self.info.find(POSITION_SENSOR) is not None and (await self._joint_table()).has_width

    async def width(self) -> float:
        """Metres between the fingers. Raises `ConfigError` for a gripper that does not report it."""
        return (await self._width_table()).width((await self.joints()).positions)

    async def width_limits(self) -> tuple[float, float]:
        """The least and the greatest width in metres. Raises `ConfigError` for a gripper that does not report it."""
        table = await self._width_table()
        ends = [table.width({joint.name: getattr(joint, end) for joint in table.joints}) for end in ("lower", "upper")]
        return min(ends), max(ends)

    async def stop(self) -> None:
        """Hold the fingers where they are."""
        await self._send(0.0)

    async def force(self) -> float | None:
        """Newtons with which the motors press each finger inwards, negative outwards, as the gripper measures it.

        The mean of the fingers; of fingers that turn, their torque in newton metres. None for a gripper that reports
        no forces, or not how its fingers open.
        """
        if self.info.find(FORCE_SENSOR) is None or not await self.has_width():
            return None
        report = await self._connection.query(self.info.id, QueryJointForceTorques(), expects=ReportJointForceTorques)
        assert isinstance(report, ReportJointForceTorques)
        pressing = [
            -math.copysign(1.0, joint.width_rate) * record.joint_force_torque.value
            for joint, record in zip(
                (await self._joint_table()).joints, report.actuator_force_torque_list, strict=False
            )
            if joint.width_rate
        ]
        return sum(pressing) / len(pressing) if pressing else None

    async def max_force(self) -> float | None:
        """The greatest force of a finger in newtons; None if the gripper does not report it."""
        if self.info.find(POSITION_SENSOR) is None:
            return None
        return (await self._joint_table()).joints[0].max_effort or None

    async def limits(self) -> dict[str, tuple[float, float]]:
        """The least and the greatest position of each finger in metres or radians.

        Empty if the gripper does not report them.
        """
        if self.info.find(POSITION_SENSOR) is None:
            return {}
        return {joint.name: (joint.lower, joint.upper) for joint in (await self._joint_table()).joints}

    async def joints(self) -> Joints:
        """The positions of the fingers in metres or radians by the name of the joint.

        Empty if the gripper does not report them.
        """
        if self.info.find(POSITION_SENSOR) is None:
            return Joints({}, datetime.now(UTC))
        table = await self._joint_table()
        return Joints(table.from_reported(await reported(self._connection, self.info)), datetime.now(UTC))

    async def _squeeze(self, effort: float, timeout: float) -> Joints:
        check_number(timeout, "timeout")
        await check_ready(self._connection, self.info.id)
        await self._send(effort)
        if self.info.find(POSITION_SENSOR) is None:
            await asyncio.sleep(min(BLIND_TIME, timeout))
            return await self.joints()
        await asyncio.sleep(START_TIME)
        clock = asyncio.get_running_loop().time
        end, before, still = clock() + timeout, await reported(self._connection, self.info), 0
        while still < STILL_REPORTS:
            if clock() > end:
                raise RequestError(f"the fingers of {self.info.id} still move after {timeout:g} s")
            await asyncio.sleep(POLL_INTERVAL)
            now = await reported(self._connection, self.info)
            rests = all(abs(a - b) <= MAX_STEP for a, b in zip(now, before, strict=True))
            still, before = still + 1 if rests else 0, now
        return await self.joints()

    async def _send(self, effort: float) -> None:
        await self._connection.send_checked(self.info.id, SetEndEffectorEffort(effort), ack=True)

    async def _until(self, width: float, start: float, timeout: float, *, closes: bool) -> None:
        """Wait until the fingers have passed a width, or stop."""
        clock = asyncio.get_running_loop().time
        begun, before, still = clock(), start, 0
        while still < STILL_REPORTS:
            if clock() > begun + timeout:
                raise RequestError(f"the fingers of {self.info.id} are not {width:g} m apart after {timeout:g} s")
            await asyncio.sleep(POLL_INTERVAL / 2)
            now = await self.width()
            if (now <= width) if closes else (now >= width):
                return
            rests = abs(now - before) <= MAX_STEP and clock() > begun + START_TIME
            still, before = still + 1 if rests else 0, now

    async def _width_table(self) -> JointTable:
        """The joints of a gripper whose width is known."""
        if await self.has_width():
            return await self._joint_table()
        raise ConfigError(f"{self.info.id} does not report how wide its fingers are open; use open() and close()")

    async def _percent(self, force: float | None, effort: float | None) -> float:
        check_number(force, "force", optional=True)
        check_number(effort, "effort", optional=True)
        if force is not None and effort is not None:
            raise ConfigError("give `force` (newtons) or `effort` (percent), not both")
        if force is not None:
            return await self._share(force)
        percent = DEFAULT_EFFORT if effort is None else effort
        if not 0 < percent <= 100:
            raise ConfigError(f"effort {percent:g} is outside 0..100 percent")
        return percent

    async def _share(self, force: float) -> float:
        """The force as percent of the greatest."""
        greatest = (await self._joint_table()).joints[0].max_effort
        if not greatest:
            raise ConfigError(f"{self.info.id} does not report its greatest force in newtons; use `effort` (percent)")
        if not 0 < force <= greatest:
            raise ConfigError(f"force {force:g} is outside 0..{greatest:g} N")
        return 100.0 * force / greatest

    async def _joint_table(self) -> JointTable:
        if self._table is None:
            self._table = await joint_table(self._connection, self.info)
        return self._table
