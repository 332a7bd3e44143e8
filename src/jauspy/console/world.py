"""Data of the tab World for one robot: pose, joints, track, scans and map, followed while a browser watches."""

from __future__ import annotations

import asyncio
import contextlib
import math
import struct
import zlib
from collections import Counter, deque
from collections.abc import AsyncGenerator, Awaitable, Callable, Iterable, Mapping, Sequence
from contextlib import aclosing
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from functools import partial
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any, Final

from jauspy.codec.message import Message
from jauspy.console.held_parts import HeldParts
from jauspy.console.languages import sentence
from jauspy.console.manipulators import MODULAR_ARM
from jauspy.console.planned_motion import PlannedMotion
from jauspy.console.planned_way import PlannedWay
from jauspy.console.reports import reports_of
from jauspy.console.robot_geometry import (
    RobotGeometry,
    add_part,
    add_surroundings,
    described,
    joint_name,
    output_joint,
    part_joint,
    positions_of,
    reported,
)
from jauspy.console.route import Route
from jauspy.errors import ConfigError, JausError
from jauspy.geometry.poses import PlanarPose
from jauspy.geometry.urdf import RobotDescription
from jauspy.ids import JausID
from jauspy.messages.cell import (
    QueryModularArmState,
    QueryPartObservations,
    ReportModularArmState,
    ReportPartObservations,
)
from jauspy.messages.description import QueryJointDescription, ReportJointDescription
from jauspy.messages.manipulator import (
    QueryJointPositions,
    QueryManipulatorSpecifications,
    QueryPanTiltJointPositions,
    ReportJointPositions,
    ReportManipulatorSpecifications,
    ReportPanTiltJointPositions,
)
from jauspy.messages.mobility import QueryLocalPose, ReportLocalPose
from jauspy.ocu import OCU
from jauspy.ocu.joints import DESCRIPTION, PAN_TILT_SENSOR, POSITION_SENSOR, SPECIFICATION, JointTable, table_of
from jauspy.ocu.robot import Robot
from jauspy.ocu.state import RobotPose, pose_of
from jauspy.ocu.subsystems import ComponentInfo
from jauspy.platform.description import RobotModel
from jauspy.platform.modular.parts import CellSetup, PartType
from jauspy.printable import printable

if TYPE_CHECKING:
    from jauspy.mapping.live import LiveMapping

RATE: Final = 10.0
"""Hz of poses, joint positions, and of the messages to browsers."""
SCAN_RATE: Final = 4.0
"""Hz of scans: the map needs one each 0.1 m."""
PART_SENSOR: Final = "cell:PartSensor"
PART_STEP: Final = (0.003, 0.01)
"""Metres and radians; a smaller motion of a part counts as noise of the sensor and is not drawn."""
TRACK_STEP: Final = 0.05
"""Metres between points of the track."""
MAX_TRACK: Final = 5000
"""Points of the track; older ones are dropped."""
MAX_RAYS: Final = 1500
"""Rays of a scan that browsers get, evenly spread."""
MAX_CLOUD: Final = 20_000
"""Points of a cloud that browsers get, evenly spread."""
RETRY_INTERVAL: Final = 2.0
"""Seconds until a service that did not answer is queried again."""
UNKNOWN: Final = 255
"""An unknown cell; others are 0..100, the probability in percent that it is occupied."""
MAP, SCAN, CLOUD = 1, 2, 3
"""The first byte of binary messages to browsers."""
_MAP_HEADER: Final = struct.Struct("<BxHHxxfff")
"""Kind, columns, rows, x and y of the lower left corner, side of a cell: then the cells, rows along y, deflated."""
_SCAN_HEADER: Final = struct.Struct("<Bxxxf")
"""Kind, height in metres: then x and y of each echo in centimetres (int16), in the robot's frame."""
CLOUD_HEADER: Final = struct.Struct("<BBHI")
"""Kind, values of a point, bytes of the link's name, padding after it, and the number of points: then float32."""


def is_cell(robot: Robot) -> bool:
    """True for a robot in a cell with a sensor of parts; a robot there that reports a pose is a car made of parts."""
    return any(component.find(PART_SENSOR) for component in robot.components)


class World:
    """One robot; `robot` returns its last discovery, or None. `sources` are addresses of its point clouds."""

    def __init__(
        self,
        ocu: OCU,
        robot: Callable[[], Robot | None],
        files: Iterable[str] = (),
        clouds: Iterable[str] = (),
    ) -> None:
        self.pose: RobotPose | None = None
        self.pose_time = -math.inf
        """When the pose was received: seconds of the event loop's clock."""
        self.positions: dict[str, float] = {}
        """The reported positions of joints, radians or metres."""
        self.part_poses: dict[str, list[float]] = {}
        """The poses of observed parts, by their joint: x, y, z and quaternion x, y, z, w in the robot's frame."""
        self.track: deque[tuple[float, float]] = deque(maxlen=MAX_TRACK)
        self.track_total = 0
        """The number of points of the track so far, including dropped ones."""
        self.scan = b""
        self.scans = 0
        self.clouds: dict[str, bytes] = {}
        """The latest cloud of each address, encoded for browsers."""
        self.clouds_total = 0
        self.mapping: LiveMapping | None = None
        self.model: RobotModel | None = None
        """The robot's model, if its file is on this machine."""
        self.route = Route(ocu, robot, lambda: self.pose)
        """The robot's waypoints."""
        self.planned = PlannedMotion(robot)
        """The motion that the robot's planner has planned."""
        self.way = PlannedWay(robot)
        """The way that the robot's navigator drives, and the costs that it sees."""
        self.problems: dict[str, str] = {}
        """Why data are missing, by their name."""
        self._ocu = ocu
        self._robot = robot
        self._files = tuple(files)
        self._cloud_addresses = list(clouds)
        self._geometry: RobotGeometry | None = None
        self._description: RobotDescription | None = None
        self._part_types: Mapping[str, PartType] = {}
        self._held: HeldParts | None = None
        """What connectors hold; None for a robot in no cell that is known."""
        self._tables: dict[JausID, JointTable] = {}
        self._loading = asyncio.Lock()
        self._watchers: set[object] = set()
        self._following: list[asyncio.Task[None]] = []
        self._reading_joints: list[asyncio.Task[None]] = []
        self._map = (0, b"")

    # --- who watches ------------------------------------------------------------------------------------------------

    async def watched_by(self, watcher: object) -> RobotGeometry:
        """Follow the robot: its joints until `unwatched_by`, pose and map until `close`. Returns its geometry."""
        geometry = await self.geometry()
        self._watchers.add(watcher)
        if not self._following:
            if not is_cell(self._found()):
                self._following = [self._start("pose", self._follow_pose), self._start("map", self._follow_map)]
            self._following += [
                self._start(f"cloud {cloud_address}", partial(self._follow_cloud, cloud_address))
                for cloud_address in self._cloud_addresses
            ]
        if not self._reading_joints:
            self._reading_joints.append(self._start("planner", self.planned.run))
            self._reading_joints.append(self._start("navigator", self.way.run))
            if self._held is not None:
                self._reading_joints.append(self._start("connectors", self._held.run))
            for component in self._found().components:
                if component.find(POSITION_SENSOR) or component.find(PAN_TILT_SENSOR):
                    following = self._start(f"joints of {component.id}", partial(self._follow_joints, component))
                    self._reading_joints.append(following)
                for service, query, take in (
                    (PART_SENSOR, QueryPartObservations(), self._take_parts),
                    (MODULAR_ARM, QueryModularArmState(), self._take_modular_arm),
                ):
                    if component.find(service):
                        what = f"{service.partition(':')[2]} {component.id}"
                        self._reading_joints.append(
                            self._start(what, partial(self._follow, what, component, query, take))
                        )
        return geometry

    def unwatched_by(self, watcher: object) -> None:
        """Note that a browser no longer shows the tab."""
        self._watchers.discard(watcher)
        if not self._watchers:
            for task in self._reading_joints:
                task.cancel()
            self._reading_joints = []

    async def close(self) -> None:
        """End everything. May be called twice."""
        tasks = self._following + self._reading_joints
        self._following, self._reading_joints = [], []
        for task in tasks:
            task.cancel()
        if tasks:
            await asyncio.wait(tasks)

    def _start(self, what: str, follow: Callable[[], Awaitable[None]]) -> asyncio.Task[None]:
        async def following() -> None:
            try:
                await follow()
            except JausError as error:
                self.problems[what] = str(error)

        return asyncio.create_task(following(), name=f"console: {what}")

    @property
    def subsystem(self) -> int:
        """The number of the robot; 0 while it has gone."""
        robot = self._robot()
        return 0 if robot is None else robot.id

    def _found(self) -> Robot:
        robot = self._robot()
        if robot is None:
            raise ConfigError(sentence("the robot has gone"))
        return robot

    # --- what it looks like -----------------------------------------------------------------------------------------

    async def geometry(self) -> RobotGeometry:
        """The geometry from the description of a robot of this name, if its joints match the reported ones.

        Else from reports.
        """
        async with self._loading:
            if self._geometry is None:
                robot = self._found()
                self._tables = await self._read_tables(robot)
                names = {joint.name for table in self._tables.values() for joint in table.joints}
                found = await asyncio.to_thread(_known, robot.name, self._files, names)
                if found is not None:
                    self._description, self.model = found.description, found.model
                    self._geometry = described(found.description, found.source)
                    self.positions = found.start | self.positions
                    self._cloud_addresses += [cloud for cloud in found.clouds if cloud not in self._cloud_addresses]
                    if found.cell is not None:
                        self._part_types = found.cell.types
                        self._held = HeldParts(self._ocu, self._robot, found.cell, found.description)
                else:
                    self._geometry = reported(await self._read_specifications(robot))
                await self._read_parts(robot)
                if found is not None and found.cell is not None:
                    add_surroundings(self._geometry, found.cell)
            return self._geometry

    async def _read_parts(self, robot: Robot) -> None:
        """Query the observed parts once, so that the browser builds them together."""
        for component in robot.components:
            if component.find(PART_SENSOR):
                with contextlib.suppress(JausError):  # it is followed later
                    self._take_parts(await self._ocu.query(component.id, QueryPartObservations()))

    async def _read_tables(self, robot: Robot) -> dict[JausID, JointTable]:
        found = {}
        for component in robot.components:
            with contextlib.suppress(JausError):  # its joints are read later, or not shown
                if (table := await self._read_table(component)) is not None:
                    found[component.id] = table
        return found

    async def _read_table(self, component: ComponentInfo) -> JointTable | None:
        """The names and signs of the component's joints; None if it does not report them."""
        if not component.find(DESCRIPTION):
            return None
        report = await self._ocu.query(component.id, QueryJointDescription(), expects=ReportJointDescription)
        return table_of(report)

    async def _read_specifications(self, robot: Robot) -> dict[JausID, ReportManipulatorSpecifications]:
        found = {}
        for component in robot.components:
            if component.find(SPECIFICATION):
                with contextlib.suppress(JausError):
                    query = QueryManipulatorSpecifications()
                    found[component.id] = await self._ocu.query(
                        component.id, query, expects=ReportManipulatorSpecifications
                    )
        return found

    # --- following --------------------------------------------------------------------------------------------------

    async def _follow(
        self, what: str, component: ComponentInfo, query: Message, take: Callable[[Message], None]
    ) -> None:
        while True:
            try:
                async with aclosing(self._reports(component, query)) as reports:
                    async for report in reports:
                        self.problems.pop(what, None)
                        take(report)
            except JausError as error:
                self.problems[what] = str(error)
            await asyncio.sleep(RETRY_INTERVAL)

    def _reports(self, component: ComponentInfo, query: Message) -> AsyncGenerator[Message, None]:
        return reports_of(self._ocu, component.id, query, RATE, events=component.find("Events") is not None)

    async def _follow_pose(self) -> None:
        sensor = "mobility:LocalPoseSensor"
        component = next((component for component in self._found().components if component.find(sensor)), None)
        if component is None:
            self.problems["pose"] = sentence(
                "this robot does not report its pose: it offers no {sensor}", sensor=sensor
            )
            return
        await self._follow("pose", component, QueryLocalPose(), self._take_pose)

    def _take_pose(self, report: Message) -> None:
        assert isinstance(report, ReportLocalPose)
        self.pose, self.pose_time = pose_of(report, datetime.now(UTC)), asyncio.get_running_loop().time()
        place = (self.pose.x, self.pose.y)
        if not self.track or math.dist(place, self.track[-1]) >= TRACK_STEP:
            self.track.append(place)
            self.track_total += 1

    async def _follow_joints(self, component: ComponentInfo) -> None:
        query = QueryJointPositions() if component.find(POSITION_SENSOR) else QueryPanTiltJointPositions()

        def take(report: Message) -> None:
            self._take_joints(component.id, report)

        what = f"joints of {component.id}"
        while component.id not in self._tables and component.find(DESCRIPTION):
            try:
                if (table := await self._read_table(component)) is not None:
                    self._tables[component.id] = table
            except JausError as error:
                self.problems[what] = str(error)
                await asyncio.sleep(RETRY_INTERVAL)
        await self._follow(what, component, query, take)

    def _take_joints(self, id: JausID, report: Message) -> None:
        if isinstance(report, ReportJointPositions):
            values = [float(joint.joint_position.value) for joint in report.joint_position_list]
        else:
            assert isinstance(report, ReportPanTiltJointPositions)
            values = [report.joint1_position, report.joint2_position]
        if self._description is None:
            self.positions.update({joint_name(id, number): value for number, value in enumerate(values, 1)})
        elif (table := self._tables.get(id)) is not None and len(table.joints) == len(values):
            self.positions.update(table.from_reported(values))

    def _take_parts(self, report: Message) -> None:
        """Take observations of parts; new parts change the geometry."""
        assert isinstance(report, ReportPartObservations)
        assert self._geometry is not None
        known = {joint["name"] for joint in self._geometry.joints}
        if new := [part for part in report.part_list if part_joint(part.name) not in known]:
            geometry = self._geometry
            self._geometry = replace(geometry, joints=[*geometry.joints], shapes=[*geometry.shapes])
            for part in new:
                add_part(self._geometry, part.name, part.type, self._part_types.get(part.type))
        before, self.part_poses = self.part_poses, {}
        for part in report.part_list:
            quaternion = (part.orientation_x, part.orientation_y, part.orientation_z, part.orientation_w)
            pose = [round(value, 4) + 0.0 for value in (part.x, part.y, part.z, *quaternion)]
            old = before.get(part_joint(part.name))
            self.part_poses[part_joint(part.name)] = old if old is not None and _is_near(old, pose) else pose

    def _take_modular_arm(self, report: Message) -> None:
        assert isinstance(report, ReportModularArmState)
        self.positions.update({output_joint(joint.name): joint.position for joint in report.joint_list})

    async def _follow_map(self) -> None:
        """Map while the robot is known; one robot without a lidar has no map."""
        if not any(component.find("environmentSensing:RangeSensor") for component in self._found().components):
            self.problems["map"] = sentence("this robot has no range sensor, so there is no map")
            return
        if find_spec("numpy") is None:
            self.problems["map"] = sentence("the map needs numpy: pip install 'jauspy[map]'")
            return
        from jauspy.mapping.live import LiveMapping  # noqa: PLC0415 - needs numpy
        from jauspy.mapping.mapper import Mapper  # noqa: PLC0415 - needs numpy

        mapper = Mapper()
        while True:
            try:
                self.mapping = LiveMapping(
                    self._found(), mapper, threaded=True, rate=SCAN_RATE, on_scan=self._take_scan
                )
                self.problems.pop("map", None)
                await self.mapping.run()
            except JausError as error:
                self.problems["map"] = str(error)
            await asyncio.sleep(RETRY_INTERVAL)

    def _take_scan(self, lidar: PlanarPose, angles: Sequence[float], ranges: Sequence[float]) -> None:
        step = max(1, math.ceil(len(ranges) / MAX_RAYS))
        values: list[int] = []
        for angle, far in list(zip(angles, ranges, strict=True))[::step]:
            if math.isfinite(far) and far > 0.0:
                turned = lidar.yaw + angle
                x, y = lidar.x + far * math.cos(turned), lidar.y + far * math.sin(turned)
                values += (_centimetres(x), _centimetres(y))
        height = self.mapping.lidar_height if self.mapping is not None else 0.0
        self.scan = _SCAN_HEADER.pack(SCAN, height) + struct.pack(f"<{len(values)}h", *values)
        self.scans += 1

    async def _follow_cloud(self, address: str) -> None:
        if find_spec("pynng") is None:
            self.problems["cloud"] = sentence("point clouds need pynng: pip install 'jauspy[cloud]'")
            return
        from jauspy.cloud.stream import CloudSubscriber  # noqa: PLC0415 - needs pynng

        with CloudSubscriber(address) as subscriber:
            while True:
                if not self._watchers:
                    await asyncio.sleep(0.5)
                    continue
                cloud = await asyncio.to_thread(subscriber.receive, 0.5)
                if cloud is not None:
                    self.clouds[address] = _cloud_bytes(cloud.points, cloud.values, cloud.frame)
                    self.clouds_total += 1

    def echoes(self) -> list[tuple[float, float]]:
        """The echoes of the last scan: x and y in metres, in the robot's frame."""
        if not self.scan:
            return []
        values = struct.unpack(f"<{(len(self.scan) - _SCAN_HEADER.size) // 2}h", self.scan[_SCAN_HEADER.size :])
        return [(x / 100.0, y / 100.0) for x, y in zip(values[::2], values[1::2], strict=True)]

    @property
    def description(self) -> RobotDescription | None:
        """Links and joints, if the robot's file is on this machine."""
        return self._description

    # --- for browsers -----------------------------------------------------------------------------------------------

    def state(self, sent_track: int) -> dict[str, Any]:
        """The values that change continuously; of the track, the points after the first `sent_track`."""
        assert self._geometry is not None
        new = min(len(self.track), self.track_total - sent_track)
        pose, parts = self.pose, self.part_poses
        poses = parts if self._held is None else self._held.poses(parts, self.positions)
        state: dict[str, Any] = {
            "joints": positions_of(self._geometry, self._description, self.positions, poses),
            "track": [[round(coordinate, 2) for coordinate in point] for point in list(self.track)[-new:]]
            if new
            else [],
        }
        if pose is not None:
            state["pose"] = [round(number, 4) for number in (pose.x, pose.y, pose.z, pose.roll, pose.pitch, pose.yaw)]
            age = asyncio.get_running_loop().time() - self.pose_time
            if age > 1.0:
                state["age"] = round(age)
        if self.mapping is not None and self.mapping.mapper.path:
            drift = self.mapping.mapper.correction.inverse()
            state["map"] = [round(number, 4) for number in drift]
        return state

    def ghost(self) -> dict[str, Any] | None:
        """The planned motion as postures for browsers; None without one."""
        assert self._geometry is not None
        return self.planned.message(self._geometry, self._description, self.positions, self.part_poses)

    def notes(self) -> list[str]:
        """Texts about missing data, and about scans that are not in the map."""
        counted = Counter(self.mapping.counters) if self.mapping is not None else Counter[str]()
        counted.pop("scans", None)
        left_out = ", ".join(f"{count} {reason}" for reason, count in counted.items())
        held = {} if self._held is None else self._held.problems
        return [
            *self.problems.values(),
            *held.values(),
            *([sentence("not in the map: {left_out}", left_out=left_out)] if left_out else []),
        ]

    @property
    def map_version(self) -> int:
        """Changes with the map; 0 without one."""
        return len(self.mapping.mapper.path) if self.mapping is not None else 0

    async def map_message(self) -> bytes:
        """The known part of the map, encoded once for all browsers."""
        version = self.map_version
        if self.mapping is not None and self._map[0] != version:
            data = await asyncio.to_thread(_map_bytes, self.mapping)
            self._map = (version, data)
        return self._map[1]


@dataclass(frozen=True, slots=True)
class _Known:
    """A robot whose file is on this machine."""

    model: RobotModel
    source: str
    start: dict[str, float]
    """Positions of joints that no service reports."""
    clouds: list[str]
    """Addresses."""

    @property
    def description(self) -> RobotDescription:
        """Links and joints."""
        return self.model.description

    @property
    def cell(self) -> CellSetup | None:
        """The equipment around it, and the types of parts."""
        return self.model.cell


def _known(name: str, files: Sequence[str], joints: set[str]) -> _Known | None:
    """The robot of this name, if it has these joints; None for an unknown robot."""
    from jauspy.robot import robot_files  # noqa: PLC0415 - it takes a second

    for file in (*files, *(known for known in robot_files.known() if known == name)):
        try:
            config = robot_files.load(file)
            if config.name != name:
                continue
            model = robot_files.robot_model(config)
        except ConfigError:
            continue  # what the robot reports is shown
        if joints <= set(model.description.joints):
            groups = model.groups.values()
            start = {
                joint: position for group in groups for joint, position in zip(group.joints, group.start, strict=True)
            }
            addresses = [cloud.address for cloud in config.clouds]
            return _Known(model, sentence("description of {file}", file=printable(file)), start, addresses)
    return None


def known_cell(name: str, files: Sequence[str]) -> CellSetup | None:
    """The cell around a robot of this name whose file is on this machine."""
    found = _known(name, files, set())
    return None if found is None else found.cell


def _is_near(one: Sequence[float], other: Sequence[float]) -> bool:
    """True for two poses that differ by less than `PART_STEP`."""
    far, turned = PART_STEP
    alike = abs(sum(a * b for a, b in zip(one[3:], other[3:], strict=True)))
    return math.dist(one[:3], other[:3]) < far and 2.0 * math.acos(min(1.0, alike)) < turned


def _centimetres(value: float) -> int:
    return max(-32768, min(32767, round(100.0 * value)))


def _map_bytes(mapping: LiveMapping) -> bytes:
    import numpy as np  # noqa: PLC0415 - comes with the extra `map`

    grid = mapping.mapper.grid
    odds = grid.log_odds.copy()
    known = odds != 0.0
    rows, columns = np.flatnonzero(known.any(axis=1)), np.flatnonzero(known.any(axis=0))
    if not len(rows):
        return b""
    top, left = int(rows[0]), int(columns[0])
    window = np.s_[top : rows[-1] + 1, left : columns[-1] + 1]
    cells = np.where(known[window], np.rint(100.0 / (1.0 + np.exp(-odds[window]))), UNKNOWN).astype(np.uint8)
    low = [grid.low + first * grid.resolution for first in (left, top)]
    header = _MAP_HEADER.pack(MAP, cells.shape[1], cells.shape[0], *low, grid.resolution)
    return header + zlib.compress(cells.tobytes(), 1)


def _cloud_bytes(points: bytes, values: int, frame: str) -> bytes:
    size = 4 * values
    count = len(points) // size
    step = max(1, math.ceil(count / MAX_CLOUD))
    kept = (
        b"".join(points[offset : offset + size] for offset in range(0, count * size, step * size))
        if step > 1
        else points
    )
    name = frame.encode()[:1000]
    name += b" " * (-len(name) % 4)
    return CLOUD_HEADER.pack(CLOUD, values, len(name), len(kept) // size) + name + kept
