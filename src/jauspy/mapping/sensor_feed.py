"""What a robot's sensors measure, with the robot's place and posture then: clouds over nanomsg, the rest over JAUS.

Sensors and poses carry the robot's time (UTC). Joint positions have none: they get the time at which they arrive,
shifted to the robot's clock as the poses tell it. What a sensor saw is placed by pose and joints of that moment. Who
uses the measurements, a scene or an elevation grid, derives from `SensorFeed`.
"""

from __future__ import annotations

import abc
import asyncio
import math
import time
from collections import Counter, deque
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from types import MappingProxyType
from typing import Any, Final, Generic, TypeAlias, TypeVar

import numpy as np
from numpy.typing import NDArray

from jauspy.cloud.stream import Cloud, CloudSubscriber
from jauspy.geometry.frames import FrameTree
from jauspy.geometry.poses import Pose, Transform, rotation_vector
from jauspy.geometry.vectors import rotation_about, scaled
from jauspy.messages.mobility import QueryLocalPose, ReportLocalPose
from jauspy.ocu.frames import JointReader, joint_readers
from jauspy.ocu.joints import DESCRIPTION, PAN_TILT_SENSOR, POSITION_SENSOR
from jauspy.ocu.lidar import RANGE_SENSOR, Lidar, Scan
from jauspy.ocu.robot import Robot
from jauspy.ocu.state import pose_of
from jauspy.ocu.subsystems import ComponentInfo
from jauspy.platform.description import RobotModel

Array: TypeAlias = NDArray[np.float64]
Positions: TypeAlias = Mapping[str, float]
T = TypeVar("T")

POSE_SENSOR: Final = "mobility:LocalPoseSensor"
RATE: Final = 25.0
"""Hz of reports of the pose and of the joints."""
HISTORY: Final = 128
"""Reports that are kept for interpolation, and latencies of a sensor."""
WAIT: Final = 0.5
"""Seconds to wait for a pose and joints that are later than a measurement."""
MAX_AGE: Final = 1.5
"""Seconds by which a measurement may be older than the robot's clock, or a third of it newer."""
SILENCE: Final = 5.0
"""Seconds without reports of the pose, the joints or a lidar after which `ResponseTimeout` is raised."""
RECEIVE: Final = 0.2
"""Seconds that a thread waits for a cloud before it looks whether it is to end."""
STILL: Final = 2e-3
"""Radians or metres between two reports above which the body is filtered out in both postures."""


class History(Generic[T]):
    """The last values of something, with the times of their measurement, seconds."""

    def __init__(self) -> None:
        self._values: deque[tuple[float, T]] = deque(maxlen=HISTORY)

    @property
    def moves(self) -> bool:
        """False for what has one value for ever."""
        return not (len(self._values) == 1 and self._values[0][0] == -math.inf)

    @property
    def newest(self) -> float:
        """Time of the last value; minus infinity without one."""
        return self._values[-1][0] if self._values else -math.inf

    def note(self, moment: float, value: T) -> None:
        """Add a value; one that is older than the last was measured by a clock that was set, and begins anew."""
        if moment < self.newest:
            self._values.clear()
        self._values.append((moment, value))

    def around(self, moment: float) -> tuple[T, T, float] | None:
        """The values before and after a time, and its place between them, 0..1; None if there are none.

        After the last value, this one.
        """
        earlier = [entry for entry in self._values if entry[0] <= moment]
        if not earlier:
            return None
        before = earlier[-1]
        if len(earlier) == len(self._values):
            return before[1], before[1], 0.0
        after = self._values[len(earlier)]
        return before[1], after[1], (moment - before[0]) / (after[0] - before[0])


@dataclass(frozen=True, slots=True)
class SensorState:
    """What came from one sensor; times in seconds."""

    frame: str
    """The link, or the name of a lidar."""
    used: int
    age: float
    """Since the last measurement that was used."""
    latency: float
    """From a measurement until it was used, median."""


@dataclass(frozen=True, slots=True)
class Measurement:
    """One cloud, or the scan of a lidar, with the place and the postures of the robot at its time."""

    sensor: str
    """The address of a cloud, the name of a lidar."""
    frame: str
    """The link that the points are in, or the name of a lidar."""
    points: Array
    """Metres in the sensor's frame, shape (n, 3 or more), of which x, y and z are used; anything, from the network."""
    empty: Array | None
    """Directions of the rays of a scan that met nothing, shape (m, 3); None for a cloud."""
    mount: Transform
    """The sensor's frame in that of the base."""
    base: Transform
    """The frame of the base in the local one."""
    time: float
    """Seconds since 1970 by the robot's clock."""
    postures: Sequence[Positions]
    """Positions of the joints before, after and at the measurement; one of them while nothing moves."""


class _Sensor:
    def __init__(self) -> None:
        self.frame = ""
        self.used = 0
        self.time = -math.inf
        self.latencies: deque[float] = deque(maxlen=HISTORY)


class SensorFeed(abc.ABC):
    """Places what a robot's sensors measure; `model` is its description, whose links clouds are in.

    `clouds` are addresses of point clouds, as in `tcp://127.0.0.1:5565`; lidars are those that the robot reports.
    `movers` maps components to joint groups, as for `RobotFrames`. What is done with a measurement takes up to 0.1 s:
    with `threaded`, in a thread, while the event loop runs on.
    """

    def __init__(
        self,
        robot: Robot,
        model: RobotModel,
        *,
        clouds: Iterable[str] = (),
        lidars: bool = True,
        movers: Mapping[int, str] = MappingProxyType({}),
        threaded: bool = True,
    ) -> None:
        self.counters: Counter[str] = Counter()
        """What was not used, by reason."""
        self._robot, self._model, self._movers = robot, model, movers
        self._clouds = tuple(dict.fromkeys(clouds))
        self._lidars, self._threaded = lidars, threaded
        self._tree = FrameTree(model.description)
        self._links = model.description.links()
        groups = model.groups.values()
        self._start = {joint: at for group in groups for joint, at in zip(group.joints, group.start, strict=True)}
        self._poses: History[Transform] = History()
        self._joints: dict[str, History[Positions]] = {}
        self._updated = asyncio.Condition()
        self._offsets: deque[float] = deque(maxlen=HISTORY)
        self._pending: dict[str, Cloud | tuple[Scan, Transform]] = {}
        self._arrived = asyncio.Event()
        self._sensors: dict[str, _Sensor] = {}
        self._clock = asyncio.get_running_loop().time

    @abc.abstractmethod
    def use(self, measured: Measurement) -> bool:
        """Use a measurement, in a thread if the feed is `threaded`; false if nothing of it could be used."""

    def moved(self, base: Transform, moment: float, positions: Positions) -> None:  # noqa: B027 - of no use to all
        """Note a new pose of the base in the local frame, and the newest positions of the joints."""

    @property
    def now(self) -> float:
        """Seconds since 1970 by the robot's clock, as far as it is known."""
        return self._clock() + (max(self._offsets) if self._offsets else time.time() - self._clock())

    @property
    def sensors(self) -> Mapping[str, SensorState]:
        """The sensors from which something was used: lidars by name, clouds by address."""
        return {
            name: SensorState(
                frame=sensor.frame,
                used=sensor.used,
                age=self.now - sensor.time,
                latency=float(np.median(sensor.latencies)),
            )
            for name, sensor in self._sensors.items()
        }

    async def run(self) -> None:
        """Read and use measurements until cancelled.

        Raises `ConfigError` for an address or a robot that cannot be used, `ResponseTimeout` when reports end.
        """
        components = self._robot.components
        jointed = [each for each in components if each.find(POSITION_SENSOR) or each.find(PAN_TILT_SENSOR)]
        described = [component for component in jointed if component.find(DESCRIPTION)]
        readers = await self._undescribed(described) if len(described) < len(jointed) else []
        work = [self._work(), *map(self._follow_joints, described), *map(self._poll_joints, readers)]
        work += map(self._receive, self._clouds)
        if any(self._robot.info.offering(POSE_SENSOR)):
            work.append(self._follow_pose())
        else:  # an arm whose base does not move
            self._poses.note(-math.inf, Transform())
        if self._lidars and any(self._robot.info.offering(RANGE_SENSOR)):
            names: list[str | None] = [lidar.name for lidar in self._model.lidars]
            work += [self._scan(self._robot.lidar(name)) for name in names or [None]]
        try:
            async with asyncio.TaskGroup() as tasks:
                for task in work:
                    tasks.create_task(task)
        except ExceptionGroup as group:
            raise group.exceptions[0] from group

    def offer(self, name: str, measured: Cloud | tuple[Scan, Transform]) -> None:
        """Take the newest measurement of a sensor; one that still waits for its turn is dropped and counted.

        With a scan, the pose of the lidar in the frame of the base.
        """
        if name in self._pending:
            self.counters["skipped, as a newer one came"] += 1
        self._pending[name] = measured
        self._arrived.set()

    # --- pose and joints ------------------------------------------------------------------------------------------

    async def _follow_pose(self) -> None:
        sensor = self._robot.service(POSE_SENSOR)
        query = QueryLocalPose(0x1FF)
        async with sensor.subscribe(query, rate=RATE, silence=SILENCE, expects=ReportLocalPose) as reports:
            async for report in reports:
                pose = pose_of(report, datetime.now(UTC))
                if pose.time is None:
                    self.counters["pose without a time"] += 1
                    continue
                moment = pose.time.timestamp()
                if self._offsets and abs(moment - self.now) > MAX_AGE:
                    self.counters["the robot's clock was set"] += 1
                    self._offsets.clear()
                self._offsets.append(moment - self._clock())
                values = (pose.x, pose.y, pose.z, pose.roll, pose.pitch, pose.yaw)
                if not all(map(math.isfinite, values)):
                    self.counters["pose that is no number"] += 1
                    continue
                base = Transform.from_pose(Pose(*values))
                await self._note(self._poses, moment, base)
                self.moved(base, moment, self._newest_positions())

    async def _follow_joints(self, component: ComponentInfo) -> None:
        history = self._joints[str(component.id)] = History[Positions]()
        async for joints in self._robot.manipulator(component.id).watch(RATE, silence=SILENCE):
            await self._note_joints(history, joints.positions)

    async def _poll_joints(self, reader: JointReader) -> None:
        history = self._joints[" ".join(reader.joints)] = History[Positions]()
        while True:
            await self._note_joints(history, await reader.read())
            await asyncio.sleep(1.0 / RATE)

    async def _undescribed(self, described: Sequence[ComponentInfo]) -> list[JointReader]:
        """Readers of those components that do not describe their joints."""
        tables = [await self._robot.manipulator(component.id).description() for component in described]
        known = {joint.name for table in tables for joint in table.joints}
        readers = await joint_readers(self._robot, self._model, self._movers)
        return [reader for reader in readers if not known.issuperset(reader.joints)]

    async def _note_joints(self, history: History[Positions], positions: Positions) -> None:
        if all(map(math.isfinite, positions.values())):
            await self._note(history, self.now, positions)
        else:
            self.counters["joint position that is no number"] += 1

    async def _note(self, history: History[T], moment: float, value: T) -> None:
        async with self._updated:
            history.note(moment, value)
            self._updated.notify_all()

    def _newest_positions(self) -> Positions:
        found = dict(self._start)
        for history in self._joints.values():
            if around := history.around(math.inf):
                found |= around[1]
        return found

    async def _placed(self, moment: float) -> tuple[Transform, list[Positions]] | None:
        """The base and the postures at a time, the last of which is that of this moment; None if nothing tells."""
        histories: list[History[Any]] = [self._poses, *self._joints.values()]
        try:
            async with asyncio.timeout(WAIT), self._updated:
                await self._updated.wait_for(lambda: all(one.newest >= moment for one in histories if one.moves))
        except TimeoutError:
            return None
        base = self._poses.around(moment)
        if base is None:
            return None
        before, after, now = dict(self._start), dict(self._start), dict(self._start)
        for joints in self._joints.values():
            found = joints.around(moment)
            if found is None:
                return None
            one, other, part = found
            before, after = {**before, **one}, {**after, **other}
            now |= {name: at + part * (other.get(name, at) - at) for name, at in one.items()}
        moving = any(abs(after[name] - at) > STILL for name, at in before.items())
        return interpolated(*base), [before, after, now] if moving else [now]

    # --- sensors --------------------------------------------------------------------------------------------------

    async def _scan(self, lidar: Lidar) -> None:
        at = await lidar.pose()
        mount = Transform.from_pose(Pose(at.x, at.y, at.z, at.roll, at.pitch, at.yaw))
        async for scan in lidar.scans(silence=SILENCE):
            self.offer(lidar.name or "lidar", (scan, mount))

    async def _receive(self, address: str) -> None:
        with CloudSubscriber(address) as subscriber:
            while True:
                receiving = asyncio.create_task(asyncio.to_thread(subscriber.receive, RECEIVE))
                try:
                    cloud = await asyncio.shield(receiving)
                except asyncio.CancelledError:
                    await receiving  # before the socket is closed
                    raise
                for reason in ("lost", "malformed"):
                    self.counters[f"{reason} cloud"] += subscriber.counters.pop(reason, 0)
                if cloud is not None:
                    self.offer(address, cloud)

    async def _work(self) -> None:
        while True:
            await self._arrived.wait()
            self._arrived.clear()
            for name in list(self._pending):
                await self._place(name, self._pending.pop(name))

    async def _place(self, name: str, measured: Cloud | tuple[Scan, Transform]) -> None:
        moment = measured.time if isinstance(measured, Cloud) else _seconds(measured[0])
        age = self.now - moment
        if not -MAX_AGE / 3.0 <= age <= MAX_AGE:  # also for a time that is no number
            self.counters["measured at another time"] += 1
            return
        if isinstance(measured, Cloud) and measured.frame not in self._links:
            self.counters["cloud in an unknown frame"] += 1
            return
        placed = await self._placed(moment)
        if placed is None:
            self.counters["no pose or joints in time"] += 1
            return
        base, postures = placed
        if isinstance(measured, Cloud):
            frame, mount, empty = measured.frame, self._tree.pose(measured.frame, postures[-1]), None
            points: Array = np.frombuffer(measured.points, "<f4").reshape(-1, measured.values)
        else:
            frame, mount = name, measured[1]
            points, empty = rays(measured[0])
        if await self._used(Measurement(name, frame, points, empty, mount, base, moment, postures)):
            sensor = self._sensors.setdefault(name, _Sensor())
            sensor.frame, sensor.time, sensor.used = frame, moment, sensor.used + 1
            sensor.latencies.append(self.now - moment)

    async def _used(self, measured: Measurement) -> bool:
        """Use a measurement; when cancelled, wait until this is done."""
        if not self._threaded:
            return self.use(measured)
        using = asyncio.create_task(asyncio.to_thread(self.use, measured))
        try:
            return await asyncio.shield(using)
        except asyncio.CancelledError:
            await using
            raise


def interpolated(before: Transform, after: Transform, part: float) -> Transform:
    """The frame between two others; the attitude turns about one axis."""
    turn = rotation_vector(before.rotation, after.rotation)
    angle = math.hypot(*turn)
    rotation = before.rotation
    if angle > 1e-9:
        rotation = (Transform(rotation_about(scaled(turn, 1.0 / angle), part * angle)) @ before).rotation
    x, y, z = (one + part * (other - one) for one, other in zip(before.position, after.position, strict=True))
    return Transform(rotation, (x, y, z))


def rays(scan: Scan) -> tuple[Array, Array]:
    """The points of a scan, shape (n, 3), and directions of the other rays, which met nothing, shape (m, 3)."""
    angles, ranges, up = (np.array(values, np.float64) for values in (scan.angles, scan.ranges, scan.inclinations))
    directions = np.stack((np.cos(angles) * np.cos(up), np.sin(angles) * np.cos(up), np.sin(up)), axis=-1)
    echo = np.isfinite(ranges)
    return directions[echo] * ranges[echo, None], directions[~echo]


def _seconds(scan: Scan) -> float:
    return math.nan if scan.time is None else scan.time.timestamp()
