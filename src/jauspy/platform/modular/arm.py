"""The modular arm: any number of servo modules that are commanded together. The contract, its state and commands."""

from __future__ import annotations

import itertools
import math
from abc import abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum
from typing import Final

from jauspy.geometry.poses import ORIGIN, Pose
from jauspy.platform.contract import Command, OptionalPart, PartId, Robot, RobotLink, RobotParts

CHANGED: Final = "the joints have changed since they were reported to this client"
"""Reason to refuse a motion that was made for other joints."""


class ArmController(Enum):
    """Controllers by which the joints follow their trajectories."""

    PID = "pid"
    """An independent PID controller for each module (stage 1)."""
    MODEL = "model"
    """Inverse dynamics of the arm as it is assembled, and PID for what remains (stage 2)."""


class MotionResult(Enum):
    """How a motion ended, if it has."""

    UNKNOWN = "unknown"
    """There is no such motion, or no more knowledge of it."""
    IN_PROGRESS = "in progress"
    REACHED = "reached"
    """The joints have come to rest at its end."""
    REFUSED = "refused"
    """It was not begun."""
    STOPPED = "stopped"
    """The arm was told to hold."""
    REPLACED = "replaced"
    """Another motion took its place."""
    BLOCKED = "blocked"
    """Something was in the way."""
    FAILED = "failed"
    """It ended early for another reason, or did not come to rest at its end."""


@dataclass(frozen=True, slots=True)
class TrajectoryPoint:
    """Where joints are at a time. Velocities and accelerations that are left out, or NaN, are those of a smooth path.

    A trajectory of one point without velocities and accelerations is a motion straight in the space of the joints, and
    takes with 0 as its time as long as limits demand.
    """

    time: float
    """Seconds from the start of the motion."""
    positions: tuple[float, ...]
    """Radians; in a trajectory of one point NaN leaves a joint's target as it is."""
    velocities: tuple[float, ...] = ()
    """rad/s; zero at the last point."""
    accelerations: tuple[float, ...] = ()
    """rad/s^2; zero at the last point."""

    @property
    def is_plain(self) -> bool:
        """True without velocities and accelerations."""
        return not any(map(math.isfinite, (*self.velocities, *self.accelerations)))


@dataclass(frozen=True, slots=True)
class ModularArmState:
    """A modular arm at one moment. All sequences are in the order of its joints, base to tip."""

    base: str = ""
    """Connector that carries it, as in `platform_1/top`; empty while nothing is attached to it."""
    tip: str = ""
    """Connector at its end; empty without one."""
    joints: tuple[str, ...] = ()
    """Names of its servo modules."""
    parts: tuple[str, ...] = ()
    """Names of all its parts."""
    positions: tuple[float, ...] = ()
    """Radians, any number of turns."""
    velocities: tuple[float, ...] = ()
    efforts: tuple[float, ...] = ()
    targets: tuple[float, ...] = ()
    """Positions at the end of the present motion."""
    moving: bool = False
    """True until the present motion has ended and the joints follow within tolerance."""
    controller: ArmController = ArmController.MODEL
    payload: float = 0.0
    """Estimated mass at the tip, in kilograms."""
    tip_pose: Pose = ORIGIN
    """Pose of the tip's frame in the world, by the model."""
    motion: int = 0
    """Number of the last motion that was begun or refused; until the arm has taken a motion it is another one's."""
    result: MotionResult = MotionResult.UNKNOWN
    """Result of that motion."""
    error: str = ""
    """Reason why the last motion ended early or was not begun; empty after a success."""


class ModularArm(OptionalPart):
    """Moves the servo modules of a chain, whatever their number; it derives the chain from the attachments."""

    name: str

    @property
    def id(self) -> PartId:
        """Kind and name."""
        return PartId(ModularArm, self.name)

    @abstractmethod
    def state(self) -> ModularArmState:
        """State of the joints, and of the motion."""

    def move(self, positions: Sequence[float], duration: float, *, known: Sequence[str] | None = None) -> int:
        """Move the joints to `positions` (rad, base to tip; NaN leaves a joint's target) in `duration` seconds.

        Returns the number of the motion, by which `state().motion` tells when the state is that of this motion.

        With 0 seconds it takes as long as the limits demand. A vector of another length, infinite values, a duration
        that limits do not allow, or an arm that has other joints than those `known` are refused: the arm holds, and
        `state().error` contains the reason.
        """
        return self._begin([TrajectoryPoint(duration, tuple(positions))], None, known)

    def follow(
        self, joints: Sequence[str] | None, points: Sequence[TrajectoryPoint], *, known: Sequence[str] | None = None
    ) -> int:
        """Move these joints through points, and to rest at the last one; the others stay. Returns as `move` does.

        None means all joints; the arm then must have those `known`.
        """
        return self._begin(points, joints, known)

    def _begin(
        self, points: Sequence[TrajectoryPoint], joints: Sequence[str] | None, known: Sequence[str] | None
    ) -> int:
        names, expected = (None if given is None else tuple(given) for given in (joints, known))
        motion = ArmMotion(self.name, tuple(points), joints=names, known=expected, number=next(_NUMBERS))
        self.begin(motion)
        return motion.number

    @abstractmethod
    def begin(self, motion: ArmMotion) -> None:
        """Begin a motion that has a number; `move` and `follow` make one."""

    @abstractmethod
    def hold(self) -> None:
        """Brake along the present path, and hold all joints."""

    @abstractmethod
    def set_controller(self, controller: ArmController) -> None:
        """Select the controller of the joints, from the next control cycle on, without a jump of torque."""

    @abstractmethod
    def set_order(self, joints: Sequence[str]) -> None:
        """Fix the order of the joints by names; empty finds it by attachments. Unknown names are refused."""

    def stop(self) -> None:
        """Hold."""
        self.hold()

    def proxy(self, link: RobotLink) -> ModularArm:
        """The arm for other threads."""
        return _ModularArmProxy(self.name, link)


_NUMBERS: Final = itertools.count(1)
"""Numbers of motions: no two of a process are equal, whichever proxy they come from."""


@dataclass(frozen=True, slots=True)
class ArmMotion(Command):
    """Move the joints of a modular arm; without points it holds."""

    name: str
    points: tuple[TrajectoryPoint, ...] | None
    joints: tuple[str, ...] | None = None
    """Names of the joints to which the values of points belong; None for all of the arm, in the order of its state."""
    known: tuple[str, ...] | None = None
    """Joints that the arm must have, in this order; None for any."""
    number: int = 0
    """Number that the arm's state reports from then on."""

    @property
    def part(self) -> PartId:
        """The arm."""
        return PartId(ModularArm, self.name)

    def apply(self, robot: Robot) -> None:
        """Move or hold."""
        arm = find(robot, self.name)
        if arm is None:
            return
        if self.points is None:
            arm.hold()
        else:
            arm.begin(self)


@dataclass(frozen=True, slots=True)
class ArmSettings(Command):
    """Choose the controller or the order of the joints of a modular arm; None keeps what is set."""

    name: str
    controller: ArmController | None = None
    order: tuple[str, ...] | None = None

    @property
    def part(self) -> PartId:
        """The settings of the arm: a pending motion is not replaced."""
        return PartId(ArmSettings, self.name)

    def apply(self, robot: Robot) -> None:
        """Set what is given."""
        arm = find(robot, self.name)
        if arm is None:
            return
        if self.controller is not None:
            arm.set_controller(self.controller)
        if self.order is not None:
            arm.set_order(self.order)

    def merged(self, pending: Command) -> ArmSettings:
        """Merge with pending settings; the later ones count."""
        if not isinstance(pending, ArmSettings):
            return self
        order = pending.order if self.order is None else self.order
        return ArmSettings(self.name, self.controller or pending.controller, order)


def find(robot: RobotParts, name: str) -> ModularArm | None:
    """The modular arm of that name."""
    arms = (part for part in robot.optional_parts if isinstance(part, ModularArm))
    return next((arm for arm in arms if arm.name == name), None)


class _ModularArmProxy(ModularArm):
    def __init__(self, name: str, link: RobotLink) -> None:
        self.name = name
        self._link = link

    def state(self) -> ModularArmState:
        state = self._link.snapshot.parts[self.id]
        assert isinstance(state, ModularArmState)
        return state

    def begin(self, motion: ArmMotion) -> None:
        self._link.submit(motion)

    def hold(self) -> None:
        self._link.submit(ArmMotion(self.name, None))

    def set_controller(self, controller: ArmController) -> None:
        self._link.submit(ArmSettings(self.name, controller=controller))

    def set_order(self, joints: Sequence[str]) -> None:
        self._link.submit(ArmSettings(self.name, order=tuple(joints)))
