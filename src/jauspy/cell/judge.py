"""The judge: true poses, for measurements only. No task uses it, and a cell elsewhere has none."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Protocol, runtime_checkable

import pinocchio as pin

from jauspy.cell.frames import offset_between, se3, se3_of_pose, tilt_between
from jauspy.cell.measurements import BATTERY_CHARGE, BATTERY_ENERGY, BATTERY_VOLTAGE
from jauspy.cell.physics import Probe
from jauspy.errors import ConfigError
from jauspy.geometry.poses import Pose, Transform
from jauspy.geometry.vectors import Vector
from jauspy.platform.backend import Backend
from jauspy.platform.camera import CameraSource
from jauspy.platform.contract import Robot
from jauspy.platform.description import RobotModel
from jauspy.platform.modular.cell import ModulePower, PowerState
from jauspy.platform.modular.connector import VacuumConnector


class Watched(Protocol):
    """What a simulation has measured of some parts at each physics step since a moment."""

    clearance: float
    """Metres: their smallest distance from the robot, the bins, the fixtures and the conveyor."""
    contacts: int
    """Steps in which they touched one of these."""
    penetration: float
    """Metres of their deepest overlap with anything."""
    speed: float
    torque: float
    """Largest speed and torque of their servo modules, as fractions of the limits."""


class Truth(Protocol):
    """The true state of a simulation."""

    @property
    def written(self) -> Sequence[str]:
        """What was put in place by writing positions since the start, in order."""
        ...

    def pose(self, part: str) -> Pose:
        """The pose of a part's frame in the world."""
        ...

    def connector(self, name: str) -> Transform:
        """The frame of a connector in the world, or of the gripper."""
        ...

    def velocity(self, body: str) -> tuple[Vector, Vector]:
        """Linear and angular velocity of a part, in its own frame: m/s and rad/s."""
        ...

    def penetration(self) -> float:
        """Metres of the deepest overlap of shapes in the last step."""
        ...

    def watch(self, parts: Iterable[str]) -> Watched:
        """Measure these parts at each step from now on."""
        ...

    def watch_groups(self, groups: Sequence[Sequence[str]]) -> Sequence[Watched]:
        """Same as `watch`, for several groups of parts, each also against the others."""
        ...


class Faults(Protocol):
    """Breaks parts of a simulated cell."""

    def vent(self, connector: str) -> None:
        """Have a connector, or the gripper, lose what it holds."""
        ...

    def blind(self, seconds: float) -> None:
        """Have the part sensor observe nothing for a while."""
        ...

    def seize(self, servo: str) -> None:
        """Block the gear of a servo module."""
        ...


@runtime_checkable
class KnowsTruth(Protocol):
    """A robot of a simulation."""

    @property
    def truth(self) -> Truth:
        """The true state."""
        ...

    @property
    def faults(self) -> Faults:
        """Breaks parts of the cell."""
        ...

    def prepare(self, connector: str, parts: Sequence[str], errors: Mapping[str, Transform] | None = None) -> None:
        """Assemble an arm before a task starts: put parts on a connector and on each other, attached.

        `errors` are poses of parts on their connectors, by part.
        """
        ...

    def place(self, part: str, pose: Pose) -> None:
        """Put a free part somewhere, at rest, by writing its position."""
        ...

    def probe(self) -> Probe:
        """Measure contacts, attachments and the robot's joints at each step from now on."""
        ...


@dataclass(frozen=True, slots=True)
class Placement:
    """How far a part is off the connector that holds it, as measured in the simulation."""

    part: str
    distance: float
    """Metres between the middles of the plates."""
    tilt: float
    """Radians between their normals."""
    turn: float
    """Radians about the normal, from the nearest quarter of a turn."""


class Judge:
    """Reads the simulation's true state."""

    def __init__(self, robot: Robot) -> None:
        if not isinstance(robot, KnowsTruth):
            raise ConfigError("this backend does not report the true poses of parts; use the backend `sim`")
        self._truth = robot.truth
        self._robot: Robot = robot
        self.faults = robot.faults
        """Breaks parts, for trials."""
        self.prepare = robot.prepare
        """Assembles an arm before a task starts, for tasks that do not include the assembly."""
        self.probe = robot.probe
        """Measures contacts, attachments and the UR10's joints at each step from then on."""
        self.place = robot.place
        """Puts a part somewhere by writing its position; `written` names it."""

    @property
    def time(self) -> float:
        """Seconds of the robot's own time."""
        return self._robot.time

    @property
    def written(self) -> tuple[str, ...]:
        """What was put in place by writing positions since the start, in order: the simulation compares all steps."""
        return tuple(self._truth.written)

    def pose(self, part: str) -> pin.SE3:
        """The true frame of a part in the world."""
        return se3_of_pose(self._truth.pose(part))

    def connector(self, name: str) -> pin.SE3:
        """The true frame of a connector in the world."""
        return se3(self._truth.connector(name))

    def velocity(self, part: str) -> tuple[Vector, Vector]:
        """Linear and angular velocity of a part, in its own frame: m/s and rad/s."""
        return self._truth.velocity(part)

    def watch(self, parts: Iterable[str]) -> Watched:
        """Measure these parts at each step from now on; the result is kept up to date."""
        return self._truth.watch(parts)

    def watch_groups(self, groups: Sequence[Sequence[str]]) -> Sequence[Watched]:
        """Same as `watch`, for several groups of parts, each also against the others. Earlier watches end."""
        return self._truth.watch_groups(groups)

    def drawn_since(self, before: PowerState) -> dict[str, float]:
        """Figures of what modules and batteries gave since then, by name: joules, fractions, volts.

        Batteries that gave nothing are left out.
        """
        now = self.power()
        found = {"energy": now.energy - before.energy}
        for name, battery in now.batteries.items():
            given = before.batteries[name].energy - battery.energy
            if given > 0.0:
                found |= {BATTERY_ENERGY + name: given, BATTERY_CHARGE + name: battery.charge}
                found[BATTERY_VOLTAGE + name] = battery.voltage
        return found

    def power(self) -> PowerState:
        """What modules have drawn, and what batteries have left."""
        meter = ModulePower.of(self._robot)
        if meter is None:
            raise ConfigError("this cell does not measure the power of its modules")
        return meter.state()

    def attached(self) -> dict[str, str]:
        """Parts that connectors hold, by connector."""
        found = {}
        for part in self._robot.optional_parts:
            if isinstance(part, VacuumConnector) and (held := part.state().attached_to):
                found[part.name] = held
        return found

    def placement(self, connector: str, part: str) -> Placement:
        """How far a part is off a connector, as in `servo_1/output`."""
        plate, frame = self.connector(connector), self.pose(part)
        distance, _ = offset_between(plate, frame)
        # the rotation is a turn about the normal, and then a tilt: the former's half angle is that of z and w
        rotation = pin.Quaternion(plate.rotation.T @ frame.rotation)
        turn = 2.0 * math.atan2(rotation.z, rotation.w)
        return Placement(part, distance, tilt_between(plate, frame), abs(math.remainder(turn, math.pi / 2.0)))

    def camera(self, name: str) -> CameraSource | None:
        """Camera of the cell by name, for films; the first one if there is none with this name."""
        cameras = self._robot.cameras
        return cameras.get(name) or next(iter(cameras.values()), None)


class WatchedBackend:
    """Opens robots with another backend, changed by `change`, and remembers the last one for the judge."""

    def __init__(self, backend: Backend, change: Callable[[RobotModel], RobotModel] = lambda model: model) -> None:
        self._backend = backend
        self._change = change
        self.robot: Robot | None = None

    @property
    def name(self) -> str:
        """Name of the other backend."""
        return self._backend.name

    def open(self, robot: RobotModel, world: str) -> Robot:
        """Open a robot."""
        self.robot = self._backend.open(self._change(robot), world)
        return self.robot
