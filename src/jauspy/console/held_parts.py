"""Parts that connectors hold, drawn where the parts and the gripper that hold them are.

A sensor sees a part a few times a second, and not while something hides it. What a connector holds moves with it: its
pose follows from the pose of what carries the connector, the connector's frame, and the offset that it reports.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Mapping, Sequence
from contextlib import aclosing
from typing import Final, NamedTuple

from jauspy.console.languages import sentence
from jauspy.console.reports import reports_of
from jauspy.console.robot_geometry import output_joint, part_joint
from jauspy.errors import JausError
from jauspy.geometry.frames import FrameTree
from jauspy.geometry.poses import Pose, Transform
from jauspy.geometry.urdf import RobotDescription
from jauspy.geometry.vectors import quaternion, rotation_about, rotation_from_quaternion
from jauspy.ids import JausID
from jauspy.messages.cell import (
    QueryConnectorSpecification,
    QueryConnectorState,
    ReportConnectorSpecification,
    ReportConnectorState,
)
from jauspy.ocu import OCU
from jauspy.ocu.robot import Robot
from jauspy.platform.modular.parts import CellSetup

CONNECTOR: Final = "cell:VacuumConnector"
GRIPPER: Final = "gripper"
"""Name that the connector on the robot's own gripper reports as its part."""
RATE: Final = 4.0
"""Hz of the reports of each connector."""
LOOK_INTERVAL: Final = 1.0
"""Seconds between two looks for components that have appeared or gone."""
RETRY_INTERVAL: Final = 2.0
FIELDS: Final = 0xFE
"""The part that is held, and its offset."""
MAX_CONNECTORS: Final = 16
"""Connectors of one component that are followed."""


class Holding(NamedTuple):
    """A part on a connector."""

    carrier: str
    """The part that has the connector, or `GRIPPER`."""
    connector: str
    offset: Transform
    """Frame of the part in that of the connector."""


class HeldParts:
    """Follows the connectors of a robot. `cell` and `description` say where they are on their parts."""

    def __init__(
        self, ocu: OCU, robot: Callable[[], Robot | None], cell: CellSetup, description: RobotDescription
    ) -> None:
        self.problems: dict[str, str] = {}
        """Why connectors are not followed, by their component."""
        self._ocu, self._robot, self._cell = ocu, robot, cell
        self._tree = FrameTree(description)
        self._types = {part.name: cell.types[part.type] for part in cell.parts}
        self._fixed = {part.name: Transform.from_pose(part.pose) for part in cell.parts if part.fixed}
        self._held: dict[tuple[JausID, int], tuple[str, Holding]] = {}
        """Held part and how, by component and number of the connector."""

    async def run(self) -> None:
        """Follow the connectors of all components, those that appear later included, until it is cancelled."""
        following: dict[JausID, asyncio.Task[None]] = {}
        try:
            while True:
                robot = self._robot()
                found = () if robot is None else [item for item in robot.components if item.find(CONNECTOR)]
                present = {component.id: component.find("Events") is not None for component in found}
                for id in [id for id in following if id not in present]:
                    following.pop(id).cancel()
                    self._forget(id)
                for id, events in present.items():
                    if id not in following:
                        following[id] = asyncio.create_task(self._follow(id, events), name=f"connectors of {id}")
                await asyncio.sleep(LOOK_INTERVAL)
        finally:
            for task in following.values():
                task.cancel()
            self._held.clear()

    def _forget(self, id: JausID) -> None:
        self.problems.pop(str(id), None)
        self._held = {key: held for key, held in self._held.items() if key[0] != id}

    async def _follow(self, id: JausID, events: bool) -> None:
        while True:
            try:
                query = QueryConnectorSpecification()
                names = await self._ocu.query(id, query, expects=ReportConnectorSpecification)
                carrier = names.connector_limits_rec.name
                async with asyncio.TaskGroup() as group:
                    for number, row in enumerate(names.connector_list[:MAX_CONNECTORS], 1):
                        group.create_task(self._follow_connector(id, events, number, carrier, row.connector_name))
            except* JausError as errors:
                self._forget(id)
                self.problems[str(id)] = sentence(
                    "{id}: what its connectors hold is not known: {error}", id=id, error=errors.exceptions[0]
                )
            await asyncio.sleep(RETRY_INTERVAL)

    async def _follow_connector(self, id: JausID, events: bool, number: int, carrier: str, connector: str) -> None:
        query = QueryConnectorState(FIELDS, number)
        async with aclosing(reports_of(self._ocu, id, query, RATE, events=events)) as reports:
            async for report in reports:
                self.problems.pop(str(id), None)
                assert isinstance(report, ReportConnectorState)
                self.take(id, number, carrier, connector, report)

    def take(self, id: JausID, number: int, carrier: str, connector: str, report: ReportConnectorState) -> None:
        """Take the report of a connector of a part."""
        if not report.attached_to:
            self._held.pop((id, number), None)
            return
        position = (report.offset_x or 0.0, report.offset_y or 0.0, report.offset_z or 0.0)
        turn = (report.offset_roll or 0.0, report.offset_pitch or 0.0, report.offset_yaw or 0.0)
        offset = Transform.from_pose(Pose(*position, *turn))
        self._held[id, number] = report.attached_to, Holding(carrier, connector, offset)

    def poses(self, seen: Mapping[str, Sequence[float]], positions: Mapping[str, float]) -> dict[str, Sequence[float]]:
        """Poses of parts by their joint: those that were seen, and in their place those of parts that are held.

        `positions` are those of all joints. A part whose carrier is not known stays where it was seen.
        """
        found = dict(seen)
        holdings = dict(self._held.values())
        frames: dict[str, Transform | None] = {}
        for part in holdings:
            if (frame := self._frame(part, holdings, seen, positions, frames)) is not None:
                d, a, b, c = quaternion(frame.rotation)
                found[part_joint(part)] = [round(value, 4) + 0.0 for value in (*frame.position, a, b, c, d)]
        return found

    def _frame(
        self,
        part: str,
        holdings: Mapping[str, Holding],
        seen: Mapping[str, Sequence[float]],
        positions: Mapping[str, float],
        frames: dict[str, Transform | None],
    ) -> Transform | None:
        """The frame of a part: on its carrier, or where it was seen; `frames` has those that are known already."""
        if part in frames:
            return frames[part]
        frames[part] = None  # a ring of parts that hold each other has no frame
        holding = holdings.get(part)
        frame = None
        if holding is not None and (connector := self._connector(holding, holdings, seen, positions, frames)):
            frame = connector @ holding.offset
        elif part in self._fixed:
            frame = self._fixed[part]
        elif (pose := seen.get(part_joint(part))) is not None:
            x, y, z, a, b, c, d = pose
            frame = Transform(rotation_from_quaternion(d, a, b, c), (x, y, z))
        frames[part] = frame
        return frame

    def _connector(
        self,
        holding: Holding,
        holdings: Mapping[str, Holding],
        seen: Mapping[str, Sequence[float]],
        positions: Mapping[str, float],
        frames: dict[str, Transform | None],
    ) -> Transform | None:
        """The frame of a connector; None if that of its carrier is not known."""
        if holding.carrier == GRIPPER:
            return self._tree.pose(self._cell.gripper, positions) if self._cell.gripper else None
        kind = self._types.get(holding.carrier)
        if kind is None or holding.connector not in kind.connectors:
            return None
        carrier = self._frame(holding.carrier, holdings, seen, positions, frames)
        if carrier is None:
            return None
        if (servo := kind.servo) is not None:
            turn = rotation_about(servo.axis, positions.get(output_joint(holding.carrier), 0.0))
            carrier = carrier @ servo.joint @ Transform(turn)
        return carrier @ kind.connectors[holding.connector]
