"""Accuracy and repeatability by ISO 9283, of the UR10 and of the modular arm, and how calibration improves the latter.

Five poses in the inclined plane of a cube are approached thirty times, P5 to P1; a laser tracker measures the tool.
AP is the distance of the mean attained pose from the commanded one, RP the mean distance of the attained poses from
their mean plus three standard deviations (clauses 7.2.1 and 7.2.2). Angles likewise, about the axes of the tool: the
largest of the three counts. The stabilisation time begins when the tool first comes into a band around the pose where
it ends up, and ends when it stays there; the overshoot is how far it leaves the band in between (clauses 7.4 and 7.5).
"""

from __future__ import annotations

import asyncio
import math
from collections.abc import Awaitable, Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path as FilePath
from typing import Final

import numpy as np
import pinocchio as pin

from jauspy.cell.assembly import Assembler
from jauspy.cell.calibration import ArmGeometry, Parameters
from jauspy.cell.frames import Array, averaged, offset_between, se3_of_pose
from jauspy.cell.measurements import Measured
from jauspy.cell.modular_arm import smooth_duration
from jauspy.cell.motion import Path
from jauspy.cell.report import figure
from jauspy.cell.session import UNDISTURBED, Session, simulated
from jauspy.cell.swing import ARM, BASE, TIP
from jauspy.errors import ConfigError
from jauspy.geometry.poses import IDENTITY, Transform
from jauspy.geometry.vectors import rotation_about
from jauspy.platform.modular.graph import Attachment, find_chain

POSES: Final = 5
CYCLES: Final = 30
"""Approaches of each pose, as the standard requires."""
ALONG_DIAGONAL: Final = 0.1
"""P2 to P5 are that far from the ends of the plane's diagonals, as a fraction of their length."""
UR10_CUBE, ARM_CUBE = 0.3, 0.2
"""Metres: sides of the cubes."""
ARM_CENTER: Final = (0.98, 0.22, 0.75)
"""Middle of the modular arm's cube in the world, in metres: in front of platform_1, above the conveyor."""
ARM_START: Final = (0.0, 0.5, 0.9, 0.7, 0.0)
"""Posture (rad) near which the modular arm reaches its cube."""
REST: Final = 1.0
"""Seconds at each pose before it is measured."""
SPEEDS: Final = (1.0, 0.5, 0.1)
"""Fractions of the rated speed."""
UR10_BAND, ARM_BAND = 0.1e-3, 1e-3
"""Metres: half-widths of the bands of the stabilisation time; a UR10's published repeatability, and ten times it."""
NEGLIGIBLE: Final = 1e-4
"""Radians by which an attitude may be out of reach without a word."""
WATCH_PERIOD: Final = 0.004
"""Seconds between two measurements of a tool that comes to rest."""
SETTLE: Final = 0.1
"""Seconds until a prepared arm is known to all."""
SAMPLES: Final = 40
"""Poses that calibration measures."""
COLOURS: Final = ("#3b6ea5", "#b3423a", "#2f7d4f", "#8a5aa8", "#c58a1c")
"""One for each pose, in plots."""

MISASSEMBLED: Final[Mapping[str, Transform]] = {
    "bracket_1": Transform(rotation_about((1.0, 0.0, 0.0), math.radians(1.5)), (0.002, 0.0, 0.0)),
    "tube_1": Transform(rotation_about((0.0, 1.0, 0.0), math.radians(-1.5)), (0.0, -0.002, 0.0)),
    "servo_4": Transform(rotation_about((0.0, 0.0, 1.0), math.pi / 2.0), (0.001, 0.001, 0.0)),
}
"""Modules that sit 2 mm and 1.5 degrees off, and one that is turned by 90 degrees."""


@dataclass(slots=True)
class LaserTracker:
    """Measures true poses with noise; its standard deviations are those of a tracker with a six-axis probe."""

    random: np.random.Generator
    position: float = 15e-6
    """Standard deviation of the position, metres."""
    angle: float = 1e-4
    """Standard deviation of the angles, radians."""

    def measure(self, pose: pin.SE3) -> pin.SE3:
        """Measure a pose once."""
        turn = pin.exp3(self.random.normal(0.0, self.angle, 3))
        return pin.SE3(pose.rotation @ turn, pose.translation + self.random.normal(0.0, self.position, 3))


@dataclass(frozen=True, slots=True)
class Accuracy:
    """Accuracy and repeatability of one pose, metres and radians."""

    accuracy: float
    """AP of the position."""
    repeatability: float
    """RP of the position."""
    angle_accuracy: float
    """AP about the worst axis."""
    angle_repeatability: float
    """RP about the worst axis."""


def accuracy(commanded: pin.SE3, attained: Sequence[pin.SE3]) -> Accuracy:
    """AP and RP of a pose; a single measurement has no spread."""
    mean = averaged(list(attained))
    distances = np.array([float(np.linalg.norm(pose.translation - mean.translation)) for pose in attained])
    spread = float(np.std(distances, ddof=1)) if len(attained) > 1 else 0.0
    angles = np.array([pin.log3(mean.rotation.T @ pose.rotation) for pose in attained])
    deviations = np.std(angles, axis=0, ddof=1) if len(attained) > 1 else np.zeros(3)
    return Accuracy(
        float(np.linalg.norm(mean.translation - commanded.translation)),
        float(np.mean(distances)) + 3.0 * spread,
        float(np.max(np.abs(pin.log3(commanded.rotation.T @ mean.rotation)))),
        3.0 * float(np.max(deviations)),
    )


def cube_points(center: Sequence[float], side: float) -> list[Array]:
    """P1 to P5: the middle of the plane through two opposite edges of the cube, and four points on its diagonals."""
    half = side / 2.0 * (1.0 - 2.0 * ALONG_DIAGONAL)
    corners = ((0.0, 0.0, 0.0), (half, half, half), (half, -half, half), (-half, -half, -half), (-half, half, -half))
    return [np.array(center) + np.array(corner) for corner in corners]


@dataclass(frozen=True, slots=True)
class Arrival:
    """How the tool came to rest at a pose."""

    stabilisation: float
    """Seconds from the first time in the band until it stays there."""
    overshoot: float
    """Largest distance, in metres, from where it ended up, once it had been in the band; zero if it stayed there."""


def arrival(times: Sequence[float], distances: Sequence[float], band: float) -> Arrival:
    """The arrival at a pose, by the distances (m) at these times (s) from where the tool ends up."""
    outside = np.asarray(distances) > band
    first = int(np.argmin(outside))
    later = np.flatnonzero(outside[first:])
    if outside[first] or not len(later):
        return Arrival(0.0, 0.0)
    last = first + int(later[-1]) + 1
    end = times[min(last, len(times) - 1)]
    return Arrival(end - times[first], float(np.max(np.asarray(distances)[first:])))


@dataclass(frozen=True, slots=True)
class Run:
    """One arm that was measured at one speed: its five poses."""

    name: str
    poses: tuple[Accuracy, ...]
    speed: float = 1.0
    """Fraction of the rated speed."""
    arrivals: tuple[Arrival, ...] = ()
    """All approaches of all poses."""
    deviations: tuple[Array, ...] = ()
    """For each pose, shape (cycles, 3): attained places less the commanded one, in the world, metres."""
    out_of_reach: float = 0.0
    """Largest angle between the attitudes of a goal and of the commanded pose, radians: five joints leave some over."""

    @property
    def worst(self) -> Accuracy:
        """The largest figures of all poses."""
        return Accuracy(
            max(pose.accuracy for pose in self.poses),
            max(pose.repeatability for pose in self.poses),
            max(pose.angle_accuracy for pose in self.poses),
            max(pose.angle_repeatability for pose in self.poses),
        )


def deviations(commanded: Sequence[pin.SE3], attained: Sequence[Sequence[pin.SE3]]) -> tuple[Array, ...]:
    """For each pose, shape (cycles, 3): attained places less the commanded one, in the world, metres."""
    return tuple(
        np.array([found.translation - pose.translation for found in rows])
        for pose, rows in zip(commanded, attained, strict=True)
    )


@dataclass(slots=True)
class Approaches:
    """Cycles through the five poses, with the tool watched until it is at rest."""

    session: Session
    tracker: LaserTracker
    tool: str
    """The connector whose pose is measured."""
    band: float

    async def run(
        self, move: Callable[[int], Awaitable[None]], cycles: int
    ) -> tuple[list[list[pin.SE3]], list[Arrival]]:
        """Approach each pose by `move`; returns the attained poses, by number of the pose, and all arrivals."""
        attained: list[list[pin.SE3]] = [[] for _ in range(POSES)]
        arrivals = []
        for _ in range(cycles):
            for number in reversed(range(POSES)):
                watched: list[tuple[float, Array]] = []
                watch = asyncio.create_task(self._watch(watched))
                try:
                    await move(number)
                    await self.session.cell.sleep(REST)
                finally:
                    watch.cancel()
                    with suppress(asyncio.CancelledError):
                        await watch
                rest = self.session.true.connector(self.tool)
                attained[number].append(self.tracker.measure(rest))
                distances = [float(np.linalg.norm(place - rest.translation)) for _, place in watched]
                arrivals.append(arrival([time for time, _ in watched], distances, self.band))
        return attained, arrivals

    async def _watch(self, watched: list[tuple[float, Array]]) -> None:
        while True:
            watched.append((self.session.cell.now(), self.session.true.connector(self.tool).translation))
            await self.session.cell.sleep(WATCH_PERIOD)


async def measure_ur10(
    session: Session, tracker: LaserTracker, cycles: int = CYCLES, speeds: Sequence[float] = SPEEDS
) -> list[Run]:
    """The UR10 and its gripper, about the pose in which the cell's file has it at the start, a run for each speed."""
    arm = session.layout.kinematics
    home = arm.forward(session.layout.home)
    poses = [pin.SE3(home.rotation, point) for point in cube_points(home.translation, UR10_CUBE)]
    postures = []
    for pose in poses:
        found = arm.solve(pose, session.layout.home)
        if not found:
            raise ConfigError(f"the UR10 does not reach {np.round(pose.translation, 3)}")
        postures.append(found[0].positions)
    approaches = Approaches(session, tracker, "gripper", UR10_BAND)
    runs = []
    for speed in speeds:

        async def move(number: int, speed: float = speed) -> None:
            at = await session.cell.posture()
            await session.cell.follow(Path((at, postures[number])), speed=speed)

        attained, arrivals = await approaches.run(move, cycles)
        rows = tuple(accuracy(pose, found) for pose, found in zip(poses, attained, strict=True))
        runs.append(Run("UR10", rows, speed, tuple(arrivals), deviations(poses, attained)))
    return runs


class ModularArmTest:
    """The modular arm on its platform: what it is believed to be, and what it is found to be."""

    def __init__(self, session: Session, tracker: LaserTracker, seed: int) -> None:
        self._session, self._tracker = session, tracker
        self._random = np.random.default_rng(seed)
        setup = session.layout.setup
        self._connectors = (BASE, *(f"{part}/{next(iter(setup.type_of(part).connectors))}" for part in ARM[:-1]))
        self.geometry = self._geometry([IDENTITY] * len(ARM))
        servos = [data for part in ARM if (data := setup.type_of(part).servo) is not None]
        self._rated = np.array([data.max_speed for data in servos])
        self._goals = [self._pose(point) for point in cube_points(ARM_CENTER, ARM_CUBE)]

    def _geometry(self, offsets: Sequence[Transform]) -> ArmGeometry:
        setup = self._session.layout.setup
        rows = zip(self._connectors, ARM, offsets, strict=True)
        chain = find_chain(setup, [Attachment(*row) for row in rows])
        base = next(part.pose for part in setup.parts if part.name == chain.ground)
        return ArmGeometry(setup, chain, se3_of_pose(base))

    async def reported(self) -> ArmGeometry:
        """The arm with its parts where the connectors report that they sit."""
        return self._geometry([(await self._session.cell.connector(name)).offset for name in self._connectors])

    def _pose(self, point: Array) -> pin.SE3:
        """The goal at a point: with the attitude that the arm has there if it is what the library of parts says."""
        nominal = self.geometry.nominal
        near = self.geometry.tip(np.array(ARM_START), nominal)
        q = self.geometry.solve(pin.SE3(near.rotation, point), np.array(ARM_START), nominal)
        found = self.geometry.tip(q, nominal)
        if float(np.linalg.norm(found.translation - point)) > 1e-4:
            raise ConfigError(f"the modular arm does not reach {np.round(point, 3)}")
        return pin.SE3(found.rotation, point)

    async def measure(
        self, name: str, geometry: ArmGeometry, parameters: Parameters, cycles: int = CYCLES, speed: float = 1.0
    ) -> Run:
        """Accuracy when positions are computed with this geometry and these parameters of it.

        The commanded pose is the one that this geometry has with the commanded positions: at the place of the goal, and
        with the attitude that is closest to the goal's among those that five joints leave.
        """
        cell = self._session.cell
        start = np.array(ARM_START)
        postures = [geometry.solve(pose, start, parameters) for pose in self._goals]
        commanded = [geometry.tip(posture, parameters) for posture in postures]

        async def move(number: int) -> None:
            await cell.move_arm(postures[number].tolist(), await self._duration(postures[number], speed))

        attained, arrivals = await Approaches(self._session, self._tracker, TIP, ARM_BAND).run(move, cycles)
        rows = tuple(accuracy(pose, found) for pose, found in zip(commanded, attained, strict=True))
        turned = max(offset_between(goal, pose)[1] for goal, pose in zip(self._goals, commanded, strict=True))
        return Run(name, rows, speed, tuple(arrivals), deviations(commanded, attained), turned)

    async def _duration(self, goal: Array, speed: float) -> float:
        """Seconds of a motion at a fraction of the rated speed; at all of it zero, as short as limits allow."""
        if speed >= 1.0:
            return 0.0
        state = await self._session.cell.arm()
        return smooth_duration(np.array(state.positions), goal, self._rated * speed)

    async def calibrate(self, samples: int = SAMPLES) -> Parameters:
        """Measure the tip in many postures about the start, and find the parameters."""
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
        return self.geometry.calibrate(positions, poses)


@dataclass(frozen=True, slots=True)
class Report:
    """All that was measured."""

    ur10: tuple[Run, ...]
    """The UR10, a run for each speed, the fastest first."""
    assembled: Run
    """The modular arm with modules that sit badly, by the library of parts."""
    reported: Run
    """The same arm, with the offsets that its connectors report."""
    calibrated: tuple[Run, ...]
    """The same arm after calibration, a run for each speed, the fastest first."""
    parameters: Parameters

    @property
    def improvement(self) -> float:
        """The factor by which calibration improves the accuracy of the position."""
        return self.assembled.worst.accuracy / self.calibrated[0].worst.accuracy

    @property
    def improvement_on_reports(self) -> float:
        """The same factor, against positions that are computed with the offsets that connectors report."""
        return self.reported.worst.accuracy / self.calibrated[0].worst.accuracy

    def measured(self, seed: int) -> Measured:
        """The figures, for tables and files."""
        found = Measured(seed, "iso9283", success=self.improvement >= 5.0)
        for run in (*self.ur10, self.assembled, self.reported, *self.calibrated):
            arm = run.name if run.speed >= 1.0 else f"{run.name}, at {run.speed:.0%} of its speed"
            worst = run.worst
            found.values |= {
                f"ap {arm}": worst.accuracy,
                f"rp {arm}": worst.repeatability,
                f"ap angle {arm}": worst.angle_accuracy,
                f"rp angle {arm}": worst.angle_repeatability,
                f"stabilisation {arm}": max((rest.stabilisation for rest in run.arrivals), default=0.0),
                f"overshoot of {arm}": max((rest.overshoot for rest in run.arrivals), default=0.0),
            }
            if run.out_of_reach > NEGLIGIBLE:
                found.values[f"attitude out of reach {arm}"] = run.out_of_reach
            for number, pose in enumerate(run.poses, 1):
                found.rows.append(
                    {
                        "arm": run.name,
                        "speed": run.speed,
                        "pose": f"P{number}",
                        "ap": pose.accuracy,
                        "rp": pose.repeatability,
                        "ap angle": pose.angle_accuracy,
                        "rp angle": pose.angle_repeatability,
                    }
                )
        found.values["improvement"] = self.improvement
        found.values["improvement on reports"] = self.improvement_on_reports
        if not found.success:
            found.failure = f"calibration improves accuracy {self.improvement:.1f} times; at least 5 are wanted"
        return found


def plot_accuracy(report: Report, path: FilePath) -> None:
    """Plot the attained places of the UR10 and of the calibrated arm, less the commanded ones, from above and aside."""
    views = ((0, 1, "x, mm", "y, mm"), (0, 2, "x, mm", "z, mm"))
    runs = (report.ur10[0], report.calibrated[0])
    with figure(path, columns=4, size=(14.0, 4.4)) as axes:
        for column, axis in enumerate(axes):
            run, (across, up, x_name, y_name) = runs[column // 2], views[column % 2]
            most = 1.2e3 * max(float(np.max(np.abs(rows))) for rows in run.deviations)
            for number, (rows, colour) in enumerate(zip(run.deviations, COLOURS, strict=True), 1):
                places = 1e3 * rows
                axis.scatter(places[:, across], places[:, up], s=10.0, color=colour, alpha=0.6, label=f"P{number}")
                mean = places.mean(axis=0)
                axis.plot(mean[across], mean[up], "+", color=colour, ms=11.0, mew=1.8)
            axis.axhline(0.0, color="0.75", lw=0.8, zorder=0)
            axis.axvline(0.0, color="0.75", lw=0.8, zorder=0)
            axis.set(xlim=(-most, most), ylim=(-most, most), xlabel=x_name, ylabel=y_name, aspect="equal")
            axis.set_title(run.name, fontsize=10)
        axes[0].legend(loc="best", fontsize=8)


async def measure(
    seed: int,
    cycles: int = CYCLES,
    samples: int = SAMPLES,
    report: Callable[[str], None] = lambda _: None,
    *,
    speeds: Sequence[float] = SPEEDS,
) -> Report:
    """Measure both arms, each in a separate simulated cell; `speeds` are fractions, the whole first."""
    tracker = LaserTracker(np.random.default_rng(seed))
    report("UR10")
    async with simulated(seed, UNDISTURBED) as session:
        ur10 = await measure_ur10(session, tracker, cycles, speeds)
    async with simulated(seed, UNDISTURBED) as session:
        session.true.prepare(BASE, ARM, MISASSEMBLED)
        await session.cell.sleep(SETTLE)
        ur10_arm = Assembler(session.cell, session.layout)
        ur10_arm.at = await session.cell.posture()
        await ur10_arm.park()
        test = ModularArmTest(session, tracker, seed)
        report("modular arm, as it is assembled")
        before = await test.measure("modular arm", test.geometry, test.geometry.nominal, cycles)
        report("modular arm, by the reports of its connectors")
        known = await test.reported()
        reported = await test.measure("modular arm, reported", known, known.nominal, cycles)
        report("calibration")
        parameters = await test.calibrate(samples)
        report("modular arm, calibrated")
        after = [
            await test.measure("modular arm, calibrated", test.geometry, parameters, cycles, speed) for speed in speeds
        ]
    return Report(tuple(ur10), before, reported, tuple(after), parameters)
