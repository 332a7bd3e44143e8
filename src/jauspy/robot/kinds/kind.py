"""A kind of capability module: the keys of its table, the parts that it needs, its services, and when it exists."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, ClassVar, Final, Generic, Protocol, TypeVar

from jauspy.errors import ConfigError
from jauspy.geometry.poses import Transform
from jauspy.geometry.urdf import Joint
from jauspy.ids import JausID
from jauspy.platform.contract import PartId, RobotParts, Snapshot
from jauspy.platform.description import RobotModel
from jauspy.platform.joints import JointGroup
from jauspy.platform.modular.parts import CellSetup
from jauspy.platform.sound import Loudspeaker, Microphone
from jauspy.platform.stability import StabilityMonitor
from jauspy.services.environment_sensing import VideoSource
from jauspy.services.environment_sensing.digital_resource_discovery import Network
from jauspy.services.iop import HourMeter, HoursInMemory, Reminder, TrafficLogger
from jauspy.services.iop.comms_lost import CommsLostPolicy
from jauspy.services.mobility import GlobalPose
from jauspy.services.mobility.retraced_joints import OwnMotion
from jauspy.services.service import Service


class Stoppable(Protocol):
    """A part of the robot that can be stopped."""

    def stop(self) -> None:
        """Stop immediately. May be called twice."""
        ...


class Context(Protocol):
    """Parts from which the services of a module are made."""

    @property
    def robot(self) -> RobotParts:
        """The robot's parts, for optional ones such as `ParkingBrake.of(robot)`."""
        ...

    @property
    def moving(self) -> Stoppable | None:
        """Parts that the module moves; a watchdog stops them unless a client controls and has resumed it."""
        ...


@dataclass(frozen=True, slots=True, kw_only=True)
class Shared:
    """Values that the modules of one robot share besides its parts."""

    faults: Callable[[], Mapping[PartId, str]] = dict
    """The parts that have failed, and why."""
    hours: HourMeter = field(default_factory=HoursInMemory)
    """How long the robot has been on."""
    reminders: tuple[Reminder, ...] = ()
    """Reminders of its maintenance."""
    stability: StabilityMonitor | None = None
    """Monitor that keeps the robot from tipping over."""
    own_motion: OwnMotion = field(default_factory=OwnMotion)
    """Parts that the robot moves without a client in control."""
    traffic_logger: TrafficLogger | None = None
    """Recorder of the robot's traffic; None without one."""
    microphones: Sequence[Microphone] = ()
    loudspeakers: Sequence[Loudspeaker] = ()


class Module(Protocol):
    """The keys of a table `[[modules]]` that kinds read."""

    @property
    def type(self) -> str:
        """The kind, as in CM-MOB."""
        ...

    @property
    def kind(self) -> Kind[Any]:
        """The item of `KINDS` of this type."""
        ...

    @property
    def component(self) -> int:
        """The number of its component."""
        ...

    @property
    def part(self) -> str | None:
        """The part of the factory cell."""
        ...

    @property
    def group(self) -> str | None:
        """The joints that it moves, as its table names them."""
        ...

    @property
    def moves(self) -> str | None:
        """The joints that it moves: its `group`, or that of its kind."""
        ...

    @property
    def services(self) -> Sequence[str] | None:
        """The services that its table lists, None if it lists none."""
        ...

    @property
    def camera(self) -> str | None:
        """The camera that it streams."""
        ...

    @property
    def comms_lost(self) -> CommsLostPolicy | None:
        """Reaction of the robot to a lost link."""
        ...


@dataclass(frozen=True, slots=True, kw_only=True)
class ModuleBuild:
    """A module whose services are to be made, and the robot that it belongs to."""

    id: JausID
    module: Module
    modules: Mapping[JausID, Module]
    """All modules of the robot."""
    name: str
    """Name of the robot."""
    origin: GlobalPose | None
    """Position of the world's origin on the globe; None if it is not known."""
    model: RobotModel
    robot: RobotParts
    videos: Mapping[str, VideoSource]
    """Cameras, by name."""
    video_targets: tuple[Network, ...]
    """Networks into which any client may have video and sound sent."""
    shared: Shared = field(default_factory=Shared)
    """The parts that the modules of the robot have in common."""

    @property
    def joints(self) -> JointGroup:
        """The joints that the module moves. Raises `ConfigError` if the backend does not have them."""
        found = self.robot.groups.get(self.module.moves or "")
        if found is None:
            raise ConfigError(f"{self.id} moves the group {self.module.moves!r}, and the backend has no such joints")
        return found


def not_in_backend(part: str) -> ConfigError:
    """The error for a part that the robot's file names and the backend lacks."""
    return ConfigError(f"the backend has no {part}, which the file of the robot names")


C = TypeVar("C")


@dataclass(frozen=True, slots=True)
class ServiceEntry(Generic[C]):
    """A service of one kind of module."""

    context: type[C]
    """The context of a kind of module: `MobilityContext` for a CM-MOB."""
    make: Callable[[C], Service | None]
    """Makes the service of one module; returns None if the robot lacks a part that the service needs."""
    needs: str = ""
    """The part that the robot must have, as the error text names it."""
    by_default: bool = True
    """True if modules offer it that list no services. Services of other packages are offered only when listed."""


_REFUSALS: Final = {
    "group": "group: a {type} moves no group of joints; leave it out",
    "part": "part: a {type} has none; leave it out",
    "comms_lost": "comms_lost: a {type} does not drive the robot; give it to the CM-MOB",
    "camera": "camera: a CM-VIS needs the name of one of [[cameras]], and no other type has one",
}
"""Errors for a key of a table that is only for other kinds."""


class Kind(ABC, Generic[C]):
    """One kind of capability module: an item of `KINDS`."""

    type: ClassVar[str]
    """Name of the kind in robots' files, as in CM-MOB."""
    services: ClassVar[Mapping[str, ServiceEntry[Any]]]
    """Services by the names that robots' files use, in the order in which hosts have them."""
    own_keys: ClassVar[frozenset[str]] = frozenset()
    """Keys of `ModuleConfig` that its table has, of `group`, `part`, `camera` and `comms_lost`."""
    group: ClassVar[str | None] = None
    """The joints that it moves unless its table names others."""
    needs_part: ClassVar[bool] = False
    """True if its table must name a `part`."""
    in_cell: ClassVar[bool] = False
    """True if only a robot with a `[cell]` has it."""

    @abstractmethod
    def context(self, build: ModuleBuild) -> C:
        """The parts from which its services are made. Raises `ConfigError` if the backend does not have them."""

    def check(self, module: Module, needs: Mapping[str, Sequence[str]]) -> None:
        """Check its table. Raises `ValueError` that begins with the key.

        `needs`: the parts that the listed services need, each with those services.
        """
        for key, text in _REFUSALS.items():
            if key not in self.own_keys and getattr(module, key) is not None:
                raise ValueError(text.format(type=self.type))
        if self.needs_part and module.part is None:
            raise ValueError(f"part: is missing; a {self.type} needs the name of its part")

    def check_cell(self, module: Module, cell: CellSetup) -> None:
        """Check that the cell has what the table names. Raises `ValueError`."""
        if module.part is not None and module.part not in (known := self.parts_in(cell)):
            raise ValueError(
                f"modules: {module.component}, a {self.type}, names the part {module.part!r}, which it cannot "
                f"have; it can have: {', '.join(known) or 'none'}"
            )

    def parts_in(self, cell: CellSetup) -> Sequence[str]:
        """The parts of a cell that a module of this kind can have."""
        return ()

    def moved(self, module: Module) -> str | None:
        """Name in error texts of what the module moves, which only one module may; None if it moves nothing."""
        return None if module.moves is None else f"group {module.moves!r}"

    def uses(self, module: Module, part: PartId) -> bool:
        """True if commands to this part of the robot are those of the module, and its faults, too."""
        if module.moves is not None:
            return part == PartId(JointGroup, module.moves)
        return module.part is not None and module.part in (part.name, part.kind.__name__.lower())

    def joint_frame(self, chain: Sequence[Joint], number: int) -> Transform | None:
        """Frame of a joint that sensors are mounted on, in the base link of its chain, with all joints at zero.

        It is that of the specification which the module reports; `number` counts joints that move, from 1. None for
        a kind whose joints carry no sensors.
        """
        return None

    def is_present(self, module: Module, cell: CellSetup | None, snapshot: Snapshot) -> bool:
        """True if the module has a component now."""
        return True

    def companions(self, context: C, services: Sequence[Service]) -> Iterable[Service]:
        """Services that those of a module need beside them."""
        return ()

    def older_versions(self, context: C, services: Sequence[Service]) -> Iterable[Service]:
        """Services for the messages of version 1.0 that the newer versions of these services lack."""
        return ()
