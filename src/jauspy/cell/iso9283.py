"""Accuracy and repeatability by ISO 9283, of the UR10 and of the modular arm, and how calibration improves the latter.

Five poses in the inclined plane of a cube are approached thirty times, P5 to P1; a laser tracker measures the tool.
AP is the distance of the mean attained pose from the commanded one, RP the mean distance of the attained poses from
their mean plus three standard deviations (clauses 7.2.1 and 7.2.2). Angles likewise, about the axes of the tool: the
largest of the three counts.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
import pinocchio as pin

from jauspy.cell.assembly import Assembler
from jauspy.cell.calibration import ArmGeometry, Parameters
from jauspy.cell.frames import Array, averaged, se3_of_pose
from jauspy.cell.measurements import Measured
from jauspy.cell.motion import Path
from jauspy.cell.session import UNDISTURBED, Session, simulated
from jauspy.cell.swing import ARM, BASE, TIP
from jauspy.errors import ConfigError
from jauspy.geometry.poses import IDENTITY, Transform
from jauspy.geometry.vectors import rotation_about
from jauspy.platform.modular.graph import Attachment, find_chain

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
SETTLE: Final = 0.1
"""Seconds until a prepared arm is known to all."""
SAMPLES: Final = 40
"""Poses that calibration measures."""

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
class Run:
    """One arm that was measured: its five poses."""

    name: str
    poses: tuple[Accuracy, ...]

    @property
    def worst(self) -> Accuracy:
        """The largest figures of all poses."""
        return Accuracy(
            max(pose.accuracy for pose in self.poses),
            max(pose.repeatability for pose in self.poses),
            max(pose.angle_accuracy for pose in self.poses),
            max(pose.angle_repeatability for pose in self.poses),
        )


async def measure_ur10(session: Session, tracker: LaserTracker, cycles: int = CYCLES) -> Run:
    """The UR10 and its gripper, about the pose in which the cell's file has it at the start."""
    arm = session.layout.kinematics
    home = arm.forward(session.layout.home)
    poses = [pin.SE3(home.rotation, point) for point in cube_points(home.translation, UR10_CUBE)]
    postures = []
    for pose in poses:
        found = arm.solve(pose, session.layout.home)
        if not found:
            raise ConfigError(f"the UR10 does not reach {np.round(pose.translation, 3)}")
        postures.append(found[0].positions)
    at = await session.cell.posture()
    attained: list[list[pin.SE3]] = [[] for _ in poses]
    for _ in range(cycles):
        for number in (4, 3, 2, 1, 0):
            await session.cell.follow(Path((at, postures[number])))
            at = postures[number]
            await session.cell.sleep(REST)
            attained[number].append(tracker.measure(session.true.connector("gripper")))
    return Run("UR10", tuple(accuracy(pose, rows) for pose, rows in zip(poses, attained, strict=True)))


class ModularArmTest:
    """The modular arm on its platform: what it is believed to be, and what it is found to be."""

    def __init__(self, session: Session, tracker: LaserTracker, seed: int) -> None:
        self._session, self._tracker = session, tracker
        self._random = np.random.default_rng(seed)
        setup = session.layout.setup
        self._connectors = (BASE, *(f"{part}/{next(iter(setup.type_of(part).connectors))}" for part in ARM[:-1]))
        self.geometry = self._geometry([IDENTITY] * len(ARM))
        self._commanded = [self._pose(point) for point in cube_points(ARM_CENTER, ARM_CUBE)]

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
        """The commanded pose at a point: with the attitude that the arm as it is believed to be has there."""
        nominal = self.geometry.nominal
        near = self.geometry.tip(np.array(ARM_START), nominal)
        q = self.geometry.solve(pin.SE3(near.rotation, point), np.array(ARM_START), nominal)
        found = self.geometry.tip(q, nominal)
        if float(np.linalg.norm(found.translation - point)) > 1e-4:
            raise ConfigError(f"the modular arm does not reach {np.round(point, 3)}")
        return pin.SE3(found.rotation, point)

    async def measure(self, name: str, geometry: ArmGeometry, parameters: Parameters, cycles: int = CYCLES) -> Run:
        """Accuracy when positions are computed with this geometry and these parameters of it."""
        cell = self._session.cell
        start = np.array(ARM_START)
        postures = [geometry.solve(pose, start, parameters) for pose in self._commanded]
        attained: list[list[pin.SE3]] = [[] for _ in postures]
        for _ in range(cycles):
            for number in (4, 3, 2, 1, 0):
                await cell.move_arm(postures[number].tolist())
                await cell.sleep(REST)
                attained[number].append(self._tracker.measure(self._session.true.connector(TIP)))
        rows = zip(self._commanded, attained, strict=True)
        return Run(name, tuple(accuracy(pose, found) for pose, found in rows))

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

    ur10: Run
    assembled: Run
    """The modular arm with modules that sit badly, by the library of parts."""
    reported: Run
    """The same arm, with the offsets that its connectors report."""
    calibrated: Run
    parameters: Parameters

    @property
    def improvement(self) -> float:
        """The factor by which calibration improves the accuracy of the position."""
        return self.assembled.worst.accuracy / self.calibrated.worst.accuracy

    @property
    def improvement_on_reports(self) -> float:
        """The same factor, against positions that are computed with the offsets that connectors report."""
        return self.reported.worst.accuracy / self.calibrated.worst.accuracy

    def measured(self, seed: int) -> Measured:
        """The figures, for tables and files."""
        found = Measured(seed, "iso9283", success=self.improvement >= 5.0)
        for run in (self.ur10, self.assembled, self.reported, self.calibrated):
            worst = run.worst
            found.values |= {
                f"ap {run.name}": worst.accuracy,
                f"rp {run.name}": worst.repeatability,
                f"ap angle {run.name}": worst.angle_accuracy,
                f"rp angle {run.name}": worst.angle_repeatability,
            }
            for number, pose in enumerate(run.poses, 1):
                found.rows.append(
                    {"arm": run.name, "pose": f"P{number}", "ap": pose.accuracy, "rp": pose.repeatability}
                )
        found.values["improvement"] = self.improvement
        found.values["improvement on reports"] = self.improvement_on_reports
        if not found.success:
            found.failure = f"calibration improves accuracy {self.improvement:.1f} times; at least 5 are wanted"
        return found


async def measure(
    seed: int, cycles: int = CYCLES, samples: int = SAMPLES, report: Callable[[str], None] = lambda _: None
) -> Report:
    """Measure both arms, each in a separate simulated cell."""
    tracker = LaserTracker(np.random.default_rng(seed))
    report("UR10")
    async with simulated(seed, UNDISTURBED) as session:
        ur10 = await measure_ur10(session, tracker, cycles)
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
        after = await test.measure("modular arm, calibrated", test.geometry, parameters, cycles)
    return Report(ur10, before, reported, after, parameters)
