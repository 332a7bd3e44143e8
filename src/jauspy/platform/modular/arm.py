"""The modular arm: any number of servo modules that are commanded together. The contract, its state and commands."""

from __future__ import annotations

import itertools
import math
from abc import abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum

from jauspy.geometry.poses import ORIGIN, Pose
from jauspy.platform.contract import Command, OptionalPart, PartId, Robot, RobotLink, RobotParts


class ArmController(Enum):
    """Controllers by which the joints follow their trajectories."""

    PID = "pid"
    """An independent PID controller for each module (stage 1)."""
    MODEL = "model"
    """Inverse dynamics of the arm as it is assembled, and PID for what remains (stage 2)."""


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
    """Number of the last motion that was begun or refused; the state is that of an earlier one until it is reached."""
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

    @abstractmethod
    def move(self, positions: Sequence[float], duration: float) -> int:
        """Move the joints to `positions` (rad, base to tip; NaN leaves a joint's target) in `duration` seconds.

        Returns the number of the motion, by which `state().motion` tells when the state is that of this motion.

        With 0 seconds it takes as long as the limits demand. A vector of another length, infinite values or a duration
        that limits do not allow are refused: nothing moves, and `state().error` contains the reason.
        """

    @abstractmethod
    def move_as(self, number: int, positions: Sequence[float], duration: float) -> None:
        """Same as `move`, with the number that another thread has given to the motion."""

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


@dataclass(frozen=True, slots=True)
class ArmMotion(Command):
    """Move the joints of a modular arm; without positions it holds."""

    name: str
    positions: tuple[float, ...] | None
    duration: float = math.nan
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
        if self.positions is None:
            arm.hold()
        else:
            arm.move_as(self.number, self.positions, self.duration)


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
        self._numbers = itertools.count(1)

    def state(self) -> ModularArmState:
        state = self._link.snapshot.parts[self.id]
        assert isinstance(state, ModularArmState)
        return state

    def move(self, positions: Sequence[float], duration: float) -> int:
        number = next(self._numbers)
        self.move_as(number, positions, duration)
        return number

    def move_as(self, number: int, positions: Sequence[float], duration: float) -> None:
        self._link.submit(ArmMotion(self.name, tuple(positions), duration, number))

    def hold(self) -> None:
        self._link.submit(ArmMotion(self.name, None))

    def set_controller(self, controller: ArmController) -> None:
        self._link.submit(ArmSettings(self.name, controller=controller))

    def set_order(self, joints: Sequence[str]) -> None:
        self._link.submit(ArmSettings(self.name, order=tuple(joints)))
