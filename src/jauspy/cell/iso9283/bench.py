"""The measurement: both arms approach five poses in the plane of a cube, and pass a line in it, at several speeds.

P5 to P1 are approached thirty times; the line leads from P2 to P4, along a diagonal of the plane, and is passed ten
times. A laser tracker measures the tool. P1 is approached ten times more after each speed, for the drift.
"""

from __future__ import annotations

import asyncio
import math
from abc import ABC, abstractmethod
from collections.abc import AsyncIterator, Iterator, Mapping, Sequence
from contextlib import asynccontextmanager, suppress
from dataclasses import dataclass
from typing import Final

import numpy as np
import pinocchio as pin

from jauspy.cell.calibration import ArmGeometry, Parameters
from jauspy.cell.frames import Array, offset_between, se3_of_pose
from jauspy.cell.iso9283.characteristics import (
    Arrival,
    DriftPoint,
    LaserTracker,
    PathAccuracy,
    Sample,
    accuracy,
    arrival,
    cube_points,
    line,
    path_accuracy,
)
from jauspy.cell.iso9283.results import Run
from jauspy.cell.modular_arm import smooth_duration
from jauspy.cell.motion import Path
from jauspy.cell.session import Session
from jauspy.cell.swing import ARM, BASE, TIP
from jauspy.errors import ConfigError
from jauspy.geometry.poses import IDENTITY, Transform
from jauspy.geometry.vectors import rotation_about
from jauspy.platform.modular.arm import TrajectoryPoint
from jauspy.platform.modular.graph import Attachment, find_chain

POSES: Final = 5
LINE: Final = (1, 3)
"""Numbers of the poses, from 0, between which the linear path leads: P2 and P4."""
UR10_CUBE, ARM_CUBE = 0.3, 0.2
"""Metres: sides of the cubes."""
UR10_TOOL_SPEED: Final = 1.0
"""m/s: the typical speed of the tool in the UR10's data sheet, the whole speed on a path."""
ARM_CENTER: Final = (0.98, 0.22, 0.75)
"""Middle of the modular arm's cube in the world, in metres: in front of platform_1, above the conveyor."""
ARM_START: Final = (0.0, 0.5, 0.9, 0.7, 0.0)
"""Posture (rad) near which the modular arm reaches its cube."""
REST: Final = 1.0
"""Seconds at each pose before it is measured."""
UR10_BAND, ARM_BAND = 0.1e-3, 1e-3
"""Metres: half-widths of the bands of the stabilisation time; a UR10's published repeatability, and ten times it."""
WATCH_PERIOD: Final = 0.004
"""Seconds between two measurements of a moving tool."""
RUN_OUT: Final = 0.05
"""Seconds that a tool goes on at its speed beyond the length of the path, since it starts slower."""
ARM_TOOL_SPEED: Final = 0.25
"""m/s: the whole speed of the modular arm on a path. An assumption: nobody states a speed of an arm just assembled."""
RAMP: Final = 0.1
"""Fraction of a line on which the modular arm speeds up, and on which it slows down."""
ROWS: Final = 12
"""Pieces of a line of the modular arm; it follows a spline through their ends."""

MISASSEMBLED: Final[Mapping[str, Transform]] = {
    "bracket_1": Transform(rotation_about((1.0, 0.0, 0.0), math.radians(1.5)), (0.0008, 0.0, 0.0)),
    "tube_1": Transform(rotation_about((0.0, 1.0, 0.0), math.radians(-1.5)), (0.0, -0.0008, 0.0)),
    "servo_4": Transform(rotation_about((0.0, 0.0, 1.0), math.pi / 2.0), (0.0005, 0.0005, 0.0)),
}
"""Modules that sit 0.8 mm and 1.5 degrees off, nearly as far as latches lock, and one that is turned by 90 degrees."""


@dataclass(frozen=True, slots=True)
class Plan:
    """The amount of measurement; ISO 9283 requires 30 cycles at poses and 10 on paths."""

    cycles: int = 30
    """Approaches of each pose."""
    path_cycles: int = 10
    """Passages of the line, and approaches of P1 for each point of the drift."""
    speeds: tuple[float, ...] = (1.0, 0.5, 0.1)
    """Fractions of the rated speed, the whole first."""
    samples: int = 60
    """Postures of the calibration."""


class Bench(ABC):
    """An arm under test, with the tracker that measures its tool."""

    def __init__(self, session: Session, tracker: LaserTracker, *, tool: str, band: float, load: float = 0.0) -> None:
        self._session, self._tracker, self._tool = session, tracker, tool
        self._band = band
        self.load = load
        """Kilograms at the tool."""
        self._begun = session.cell.now()
        self._drift: list[DriftPoint] = []

    async def runs(self, name: str, plan: Plan, *, drifts: bool = False) -> list[Run]:
        """A run for each speed; with `drifts` P1 is measured again before the first and after each of them."""
        found = []
        if drifts:
            await self._look_at_drift(plan.path_cycles)
        for speed in plan.speeds:
            found.append(await self.run(name, plan, speed))
            if drifts:
                await self._look_at_drift(plan.path_cycles)
        return found

    async def run(self, name: str, plan: Plan, speed: float = 1.0, *, on_path: bool = True) -> Run:
        """Poses and path at one speed."""
        commanded = self.commanded()
        attained: list[list[pin.SE3]] = [[] for _ in range(POSES)]
        arrivals = []
        for _ in range(plan.cycles):
            for number in reversed(range(POSES)):
                pose, found = await self._approach(number, speed)
                attained[number].append(pose)
                arrivals.append(found)
        return Run(
            name,
            tuple(accuracy(pose, found) for pose, found in zip(commanded, attained, strict=True)),
            speed,
            tuple(arrivals),
            tuple(
                np.array([found.translation - pose.translation for found in rows])
                for pose, rows in zip(commanded, attained, strict=True)
            ),
            self.out_of_reach(),
            self.load,
            await self._path(speed, plan.path_cycles) if on_path else None,
        )

    @property
    def drift(self) -> tuple[DriftPoint, ...]:
        """P1 over the time of all runs with `drifts`."""
        return tuple(self._drift)

    async def _look_at_drift(self, count: int) -> None:
        found, begun = [], self._session.cell.now()
        for _ in range(count):
            await self.move(1, 1.0)
            found.append((await self._approach(0, 1.0))[0])
        if not self._drift:
            self._begun = begun
        self._drift.append(DriftPoint(begun - self._begun, accuracy(self.commanded()[0], found)))

    async def _approach(self, number: int, speed: float) -> tuple[pin.SE3, Arrival]:
        async with self._watched() as watched:
            await self.move(number, speed)
            await self._session.cell.sleep(REST)
        rest = self._session.true.connector(self._tool)
        distances = [float(np.linalg.norm(sample.pose.translation - rest.translation)) for sample in watched]
        return self._tracker.measure(rest), arrival([sample.time for sample in watched], distances, self._band)

    async def _path(self, speed: float, count: int) -> PathAccuracy:
        passages = []
        for _ in range(count):
            await self.move(LINE[0], 1.0)
            await self._session.cell.sleep(REST)
            async with self._watched() as watched:
                await self.pass_line(speed)
            passages.append([Sample(sample.time, self._tracker.measure(sample.pose)) for sample in watched])
        return path_accuracy(self.commanded_line(), passages)

    @asynccontextmanager
    async def _watched(self) -> AsyncIterator[list[Sample]]:
        """True poses of the tool while the block runs."""
        samples: list[Sample] = []

        async def watch() -> None:
            while True:
                samples.append(Sample(self._session.cell.now(), self._session.true.connector(self._tool)))
                await self._session.cell.sleep(WATCH_PERIOD)

        watching = asyncio.create_task(watch())
        try:
            yield samples
        finally:
            watching.cancel()
            with suppress(asyncio.CancelledError):
                await watching

    @abstractmethod
    def commanded(self) -> Sequence[pin.SE3]:
        """Commanded poses of the tool, P1 to P5."""

    @abstractmethod
    def commanded_line(self) -> Sequence[pin.SE3]:
        """Commanded poses on the line, one in each plane across it."""

    @abstractmethod
    async def move(self, number: int, speed: float) -> None:
        """Move to a pose, counted from 0, at a fraction of the rated speed."""

    @abstractmethod
    async def pass_line(self, speed: float) -> None:
        """Move along the line at a fraction of the rated speed, from the pose at its start."""

    def out_of_reach(self) -> float:
        """Largest angle between the attitudes of goals and of the commanded poses, radians."""
        return 0.0


class UR10Bench(Bench):
    """The UR10 and its gripper, about the pose in which the cell's file has it at the start."""

    def __init__(self, session: Session, tracker: LaserTracker, load: float = 0.0) -> None:
        super().__init__(session, tracker, tool="gripper", band=UR10_BAND, load=load)
        kinematics = session.layout.kinematics
        home = kinematics.forward(session.layout.home)
        self._poses = [pin.SE3(home.rotation, point) for point in cube_points(home.translation, UR10_CUBE)]
        self._postures = []
        for pose in self._poses:
            found = kinematics.solve(pose, session.layout.home)
            if not found:
                raise ConfigError(f"the UR10 does not reach {np.round(pose.translation, 3)}")
            self._postures.append(found[0].positions)

    def commanded(self) -> Sequence[pin.SE3]:
        """Commanded poses of the gripper."""
        return self._poses

    def commanded_line(self) -> Sequence[pin.SE3]:
        """Commanded poses on the line."""
        return line(*(self._poses[number] for number in LINE))

    async def move(self, number: int, speed: float) -> None:
        """Move straight in joint space."""
        at = await self._session.cell.posture()
        await self._session.cell.follow(Path((at, self._postures[number])), speed=speed)

    async def pass_line(self, speed: float) -> None:
        """Move the tool at a velocity, which the robot keeps on a line."""
        start, end = (self._poses[number].translation for number in LINE)
        seconds = float(np.linalg.norm(end - start)) / (speed * UR10_TOOL_SPEED)
        await self._session.cell.slide((end - start) / seconds, seconds + RUN_OUT)
        await self._session.cell.sleep(REST)


class ModularArmBench(Bench):
    """The modular arm on its platform: what it is believed to be, and what it is found to be.

    Positions are computed with `geometry` and `parameters`, which may be changed. The commanded pose is the one that
    these have with the commanded positions: at the place of the goal, and with the attitude that is closest to the
    goal's among those that five joints leave.
    """

    def __init__(self, session: Session, tracker: LaserTracker, seed: int, load: float = 0.0) -> None:
        super().__init__(session, tracker, tool=TIP, band=ARM_BAND, load=load)
        self._random = np.random.default_rng(seed)
        setup = session.layout.setup
        self._connectors = (BASE, *(f"{part}/{next(iter(setup.type_of(part).connectors))}" for part in ARM[:-1]))
        self.library = self._geometry([IDENTITY] * len(ARM))
        """The arm by the library of parts."""
        servos = [data for part in ARM if (data := setup.type_of(part).servo) is not None]
        self._rated = np.array([data.max_speed for data in servos])
        self._goals = [self._goal(point) for point in cube_points(ARM_CENTER, ARM_CUBE)]
        self.believe(self.library, self.library.nominal)

    def _geometry(self, offsets: Sequence[Transform]) -> ArmGeometry:
        setup = self._session.layout.setup
        rows = zip(self._connectors, ARM, offsets, strict=True)
        chain = find_chain(setup, [Attachment(*row) for row in rows])
        base = next(part.pose for part in setup.parts if part.name == chain.ground)
        return ArmGeometry(setup, chain, se3_of_pose(base))

    def _goal(self, point: Array) -> pin.SE3:
        """The goal at a point: with the attitude that the arm has there if it is what the library of parts says."""
        nominal = self.library.nominal
        near = self.library.tip(np.array(ARM_START), nominal)
        q = self.library.solve(pin.SE3(near.rotation, point), np.array(ARM_START), nominal)
        found = self.library.tip(q, nominal)
        if float(np.linalg.norm(found.translation - point)) > 1e-4:
            raise ConfigError(f"the modular arm does not reach {np.round(point, 3)}")
        return pin.SE3(found.rotation, point)

    def believe(self, geometry: ArmGeometry, parameters: Parameters) -> None:
        """Compute positions with this geometry and these parameters of it from now on."""
        start = np.array(ARM_START)
        self._postures = [geometry.solve(pose, start, parameters) for pose in self._goals]
        self._commanded = [geometry.tip(posture, parameters) for posture in self._postures]
        first, last = (self._commanded[number] for number in LINE)
        self._planes = [
            pin.SE3(geometry.tip(posture, parameters).rotation, pose.translation)
            for pose, posture in self._along(line(first, last), geometry, parameters)
        ]
        rows = line(first, last, ROWS + 1, edge=0.0)
        self._rows = [posture for _, posture in self._along(rows, geometry, parameters)]
        self._length = float(np.linalg.norm(last.translation - first.translation))

    def _along(
        self, poses: Sequence[pin.SE3], geometry: ArmGeometry, parameters: Parameters
    ) -> Iterator[tuple[pin.SE3, Array]]:
        """Poses, each with the posture that has the tip there, from that at the start of the line on."""
        near = self._postures[LINE[0]]
        for pose in poses:
            near = geometry.solve(pose, near, parameters)
            yield pose, near

    async def believe_connectors(self) -> None:
        """Compute positions with the parts where the connectors report that they sit."""
        known = self._geometry([(await self._session.cell.connector(name)).offset for name in self._connectors])
        self.believe(known, known.nominal)

    def commanded(self) -> Sequence[pin.SE3]:
        """Commanded poses of the tip."""
        return self._commanded

    def commanded_line(self) -> Sequence[pin.SE3]:
        """Commanded poses on the line."""
        return self._planes

    def out_of_reach(self) -> float:
        """Largest angle between the attitudes of goals and of the commanded poses, radians."""
        return max(offset_between(goal, pose)[1] for goal, pose in zip(self._goals, self._commanded, strict=True))

    async def move(self, number: int, speed: float) -> None:
        """Move straight in joint space."""
        await self._move_to(self._postures[number], speed)

    async def pass_line(self, speed: float) -> None:
        """Follow a spline along the line, at an even speed between its ramps."""
        joints = (await self._session.cell.arm()).joints
        seconds = self._length / (speed * ARM_TOOL_SPEED)
        times = [seconds * ramped(part) for part in np.linspace(0.0, 1.0, ROWS + 1).tolist()]
        rows = zip(times[1:], self._rows[1:], strict=True)
        await self._session.cell.follow_arm(
            joints, [TrajectoryPoint(time, tuple(posture.tolist())) for time, posture in rows]
        )

    async def _move_to(self, goal: Array, speed: float) -> None:
        """Move at a fraction of the rated speed; at all of it as fast as limits allow."""
        cell, seconds = self._session.cell, 0.0
        if speed < 1.0:
            state = await cell.arm()
            seconds = smooth_duration(np.array(state.positions), goal, self._rated * speed)
        await cell.move_arm(goal.tolist(), seconds)

    async def calibrate(self, samples: int) -> Parameters:
        """Measure the tip in many postures about the start, find the parameters, and compute with them from now on."""
        cell = self._session.cell
        positions, poses = [], []
        spread = np.array([0.6, 0.35, 0.4, 0.7, 1.5])
        for _ in range(samples):
            target = np.array(ARM_START) + self._random.uniform(-spread, spread)
            await cell.move_arm(target.tolist())
            await cell.sleep(REST)
            state = await cell.arm()
            positions.append(np.array(state.positions))
            poses.append(self._tracker.measure(self._session.true.connector(TIP)))
        parameters = self.library.calibrate(positions, poses)
        self.believe(self.library, parameters)
        return parameters


def ramped(part: float) -> float:
    """When a part of a way is done that begins and ends at rest, in times of the way at its even speed."""
    if part < RAMP:
        return 2.0 * math.sqrt(RAMP * part)
    if part <= 1.0 - RAMP:
        return part + RAMP
    return 1.0 + 2.0 * RAMP - 2.0 * math.sqrt(RAMP * (1.0 - part))
