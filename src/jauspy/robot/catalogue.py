"""The catalogue of services that the modules of a robot may offer, by the names that its TOML file uses.

Installed packages add services in the entry-point group `jauspy.services`: the entry's name is the service's, and its
object is a `ServiceEntry`. See docs/adding-a-service.md.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from importlib.metadata import EntryPoint, entry_points
from typing import Any, ClassVar, Final, Generic, Protocol, TypeVar

from jauspy.errors import ConfigError
from jauspy.geometry.fingers import FingerWidth
from jauspy.platform.chassis import ParkingBrake
from jauspy.platform.contract import RobotParts
from jauspy.platform.lights import lamps_of
from jauspy.platform.modular.cell import Conveyor, ModulePower, PartSensor
from jauspy.platform.modular.connector import VacuumConnector
from jauspy.platform.modular.parts import CellSetup
from jauspy.services import cell, manipulator, mobility, ugv
from jauspy.services.environment_sensing import (
    DigitalResourceDiscovery,
    DigitalVideo,
    ForceTorqueSensor,
    H264VideoEncoding,
    MountedForceTorqueSensor,
    MountedLidar,
    RangeSensor,
    StillImage,
    VideoStreams,
    VisualSensor,
)
from jauspy.services.service import Service
from jauspy.services.ugv.parking_brake import ParkingBrakeDriver

GROUP: Final = "jauspy.services"

CORE: Final = ("Discovery", "Time", "Liveness")
"""Optional core services; Transport, Events, AccessControl and Management are in every module."""


class Stoppable(Protocol):
    """A part of the robot that can be stopped."""

    def stop(self) -> None:
        """Stop immediately. May be called twice."""
        ...


@dataclass(frozen=True, slots=True)
class MobilityContext:
    """Parts from which the services of a CM-MOB are made."""

    module: ClassVar[str] = "CM-MOB"
    robot: RobotParts
    vehicle: mobility.Vehicle

    @property
    def moving(self) -> Stoppable:
        """The chassis."""
        return self.vehicle.pilot


@dataclass(frozen=True, slots=True)
class ManipulatorContext:
    """Parts from which the services of a CM-MAN are made."""

    module: ClassVar[str] = "CM-MAN"
    robot: RobotParts
    arm: manipulator.Arm

    @property
    def moving(self) -> Stoppable:
        """The arm."""
        return self.arm


@dataclass(frozen=True, slots=True)
class EndEffectorContext:
    """Parts from which the services of a CM-EEF are made."""

    module: ClassVar[str] = "CM-EEF"
    robot: RobotParts
    arm: manipulator.Arm
    """The joints of the gripper."""
    driver: manipulator.PrimitiveEndEffector
    width: FingerWidth | None = None
    """How wide its fingers are open; None if that is not known."""

    @property
    def moving(self) -> Stoppable:
        """The gripper."""
        return self.driver


@dataclass(frozen=True, slots=True)
class SensorContext:
    """Parts from which the services of a CM-SEN are made."""

    module: ClassVar[str] = "CM-SEN"
    moving: ClassVar[None] = None
    robot: RobotParts
    lidars: tuple[MountedLidar, ...]
    force_torque: tuple[MountedForceTorqueSensor, ...]
    """The sensors of force and torque."""


@dataclass(frozen=True, slots=True)
class VisionContext:
    """Parts from which the services of a CM-VIS are made."""

    module: ClassVar[str] = "CM-VIS"
    robot: RobotParts
    streams: VideoStreams
    """The streams of its cameras, by sensor id, with their receivers."""
    pan_tilt: manipulator.PanTilt | None
    """The unit that turns the camera."""

    @property
    def moving(self) -> Stoppable | None:
        """The pan-tilt unit."""
        return self.pan_tilt


@dataclass(frozen=True, slots=True)
class ServoContext:
    """Parts from which the services of a CM-SRV are made."""

    module: ClassVar[str] = "CM-SRV"
    robot: RobotParts
    control: cell.ServoControl
    connectors: tuple[VacuumConnector, ...]
    """The connectors of its output."""
    setup: CellSetup

    @property
    def moving(self) -> Stoppable:
        """The servo module."""
        return self.control


@dataclass(frozen=True, slots=True)
class ConnectorContext:
    """Parts from which the services of a CM-CON are made."""

    module: ClassVar[str] = "CM-CON"
    moving: ClassVar[None] = None
    robot: RobotParts
    part: str
    type: str
    connectors: tuple[VacuumConnector, ...]
    setup: CellSetup


@dataclass(frozen=True, slots=True)
class ConveyorContext:
    """Parts from which the services of a CM-CNV are made."""

    module: ClassVar[str] = "CM-CNV"
    robot: RobotParts
    conveyor: Conveyor
    max_speed: float
    """m/s."""

    @property
    def moving(self) -> Stoppable:
        """The belt."""
        return self.conveyor


@dataclass(frozen=True, slots=True)
class PartSensorContext:
    """Parts from which the services of a CM-PRT are made."""

    module: ClassVar[str] = "CM-PRT"
    moving: ClassVar[None] = None
    robot: RobotParts


@dataclass(frozen=True, slots=True)
class ModularArmContext:
    """Parts from which the services of a CM-ARM are made."""

    module: ClassVar[str] = "CM-ARM"
    robot: RobotParts
    control: cell.ArmMotionControl
    setup: CellSetup

    @property
    def moving(self) -> Stoppable:
        """The arm."""
        return self.control


class Context(Protocol):
    """Parts from which the services of a module are made."""

    @property
    def robot(self) -> RobotParts:
        """The robot's parts, for optional ones such as `ParkingBrake.of(robot)`."""
        ...

    @property
    def moving(self) -> Stoppable | None:
        """What the module moves; a watchdog stops it unless a client is in control and has resumed the module."""
        ...


C = TypeVar("C")
ORIGIN: Final = "an origin: latitude, longitude, altitude and heading"
PAN_TILT: Final = "the group of joints that pan and tilt the camera"
LIDARS: Final = "lidars"
FORCE_TORQUE: Final = "sensors of force and torque"
CONNECTORS: Final = "vacuum connectors"
INDEPENDENT: Final = "joints from base to tip that do not mimic others"


@dataclass(frozen=True, slots=True)
class ServiceEntry(Generic[C]):
    """A service of one type of module."""

    context: type[C]
    """The context of a type of module: `MobilityContext` for a CM-MOB."""
    make: Callable[[C], Service | None]
    """Makes the service of one module; returns None if the robot lacks a part that the service needs."""
    needs: str = ""
    """The part that the robot must have, as the error text names it."""
    by_default: bool = True
    """True if modules offer it that list no services. Services of other packages are offered only when listed."""


def _vehicle(make: Callable[[mobility.Vehicle], Service]) -> ServiceEntry[MobilityContext]:
    return ServiceEntry(MobilityContext, lambda context: make(context.vehicle))


def _global(make: Callable[[mobility.Vehicle], Service]) -> ServiceEntry[MobilityContext]:
    return ServiceEntry(
        MobilityContext, lambda context: make(context.vehicle) if context.vehicle.has_origin else None, needs=ORIGIN
    )


def _arm(make: Callable[[manipulator.Arm], Service]) -> ServiceEntry[ManipulatorContext]:
    return ServiceEntry(ManipulatorContext, lambda context: make(context.arm))


def _geometry(make: Callable[[manipulator.Arm], Service]) -> ServiceEntry[ManipulatorContext]:
    """A service that needs the geometry of the arm, which the standard describes by independent joints only."""
    return ServiceEntry(
        ManipulatorContext, lambda context: None if context.arm.is_coupled else make(context.arm), needs=INDEPENDENT
    )


def _camera(make: Callable[[VideoStreams], Service]) -> ServiceEntry[VisionContext]:
    return ServiceEntry(VisionContext, lambda context: make(context.streams))


def _pan_tilt(make: Callable[[manipulator.PanTilt], Service]) -> ServiceEntry[VisionContext]:
    return ServiceEntry(
        VisionContext, lambda context: make(context.pan_tilt) if context.pan_tilt else None, needs=PAN_TILT
    )


def _described(context: ManipulatorContext | EndEffectorContext | VisionContext) -> Service | None:
    arm = context.pan_tilt if isinstance(context, VisionContext) else context.arm
    if arm is not None:
        for name, group in context.robot.groups.items():
            if group.joints[0].name == arm.joints.joints[0].name:
                width = context.width if isinstance(context, EndEffectorContext) else None
                return manipulator.JointDescription(name, group, arm, width)
    return None


def _connectors(
    part: str, type: str, connectors: Sequence[VacuumConnector], setup: CellSetup
) -> cell.VacuumConnectorService | None:
    return cell.VacuumConnectorService(part, type, connectors, setup.limits) if connectors else None


BUILT_IN: Final[Mapping[str, Mapping[str, ServiceEntry[Any]]]] = {
    "CM-MOB": {
        "PrimitiveDriver": _vehicle(mobility.PrimitiveDriver),
        "VelocityStateSensor": _vehicle(mobility.VelocityStateSensor),
        "VelocityStateDriver": _vehicle(mobility.VelocityStateDriver),
        "AccelerationStateSensor": _vehicle(mobility.AccelerationStateSensor),
        "LocalPoseSensor": _vehicle(mobility.LocalPoseSensor),
        "LocalVectorDriver": _vehicle(mobility.LocalVectorDriver),
        "LocalWaypointDriver": _vehicle(mobility.LocalWaypointDriver),
        "LocalWaypointListDriver": _vehicle(mobility.LocalWaypointListDriver),
        "GlobalPoseSensor": _global(mobility.GlobalPoseSensor),
        "GlobalVectorDriver": _global(mobility.GlobalVectorDriver),
        "GlobalWaypointDriver": _global(mobility.GlobalWaypointDriver),
        "GlobalWaypointListDriver": _global(mobility.GlobalWaypointListDriver),
        "SkidSteerDriver": ServiceEntry(
            MobilityContext,
            lambda context: None if context.vehicle.chassis.min_turn_radius else ugv.SkidSteerDriver(context.vehicle),
            needs="a chassis that does not steer",
        ),
        "AckermannDriver": ServiceEntry(
            MobilityContext,
            lambda context: ugv.AckermannDriver(context.vehicle) if context.vehicle.chassis.min_turn_radius else None,
            needs="a chassis that steers",
        ),
        "PlatformSpecifications": _vehicle(ugv.PlatformSpecifications),
        "IlluminationService": ServiceEntry(
            MobilityContext,
            lambda context: ugv.IlluminationService(lamps) if (lamps := lamps_of(context.robot)) else None,
            needs="lamps ([[lights]])",
        ),
        "ParkingBrakeDriver": ServiceEntry(
            MobilityContext,
            lambda context: ParkingBrakeDriver(brake) if (brake := ParkingBrake.of(context.robot)) else None,
            needs="a parking brake",
            by_default=False,  # leaving Ready engages it: a client that does not know it could drive only once
        ),
    },
    "CM-MAN": {
        "ManipulatorSpecificationService": _geometry(manipulator.ManipulatorSpecification),
        "PrimitiveManipulator": _arm(manipulator.PrimitiveManipulator),
        "ManipulatorJointPositionSensor": _arm(manipulator.JointPositionSensor),
        "ManipulatorJointVelocitySensor": _arm(manipulator.JointVelocitySensor),
        "ManipulatorJointForceTorqueSensor": _arm(manipulator.JointForceTorqueSensor),
        "ManipulatorJointPositionDriver": _arm(manipulator.JointPositionDriver),
        "ManipulatorJointVelocityDriver": _arm(manipulator.JointVelocityDriver),
        "ManipulatorActuatorForceTorqueDriver": _arm(manipulator.ActuatorForceTorqueDriver),
        "ManipulatorJointMotionProfile": _arm(manipulator.JointMotionProfile),
        "ManipulatorJointPositionListDriver": _arm(manipulator.JointPositionListDriver),
        "ManipulatorEndEffectorPoseSensor": _geometry(manipulator.EndEffectorPoseSensor),
        "ManipulatorEndEffectorPoseDriver": _geometry(manipulator.EndEffectorPoseDriver),
        "ManipulatorEndEffectorPoseListDriver": _geometry(manipulator.EndEffectorPoseListDriver),
        "ManipulatorEndEffectorVelocityStateSensor": _geometry(manipulator.EndEffectorVelocityStateSensor),
        "ManipulatorEndEffectorVelocityStateDriver": _geometry(manipulator.EndEffectorVelocityStateDriver),
        "ManipulatorToolOffsetService": _geometry(manipulator.ToolOffset),
        "JointDescription": ServiceEntry(ManipulatorContext, _described),
    },
    "CM-EEF": {
        "PrimitiveEndEffector": ServiceEntry(EndEffectorContext, lambda context: context.driver),
        "ManipulatorJointPositionSensor": ServiceEntry(
            EndEffectorContext, lambda context: manipulator.JointPositionSensor(context.arm)
        ),
        "JointDescription": ServiceEntry(EndEffectorContext, _described),
    },
    "CM-SEN": {
        "RangeSensor": ServiceEntry(
            SensorContext, lambda context: RangeSensor(context.lidars) if context.lidars else None, needs=LIDARS
        ),
        "ForceTorqueSensor": ServiceEntry(
            SensorContext,
            lambda context: ForceTorqueSensor(context.force_torque) if context.force_torque else None,
            needs=FORCE_TORQUE,
        ),
    },
    "CM-VIS": {
        "VisualSensor": _camera(lambda streams: VisualSensor(streams.cameras)),
        "DigitalVideo": _camera(DigitalVideo),
        "H264VideoEncoding": _camera(lambda streams: H264VideoEncoding(streams.cameras)),
        "StillImage": _camera(lambda streams: StillImage(streams.cameras)),
        "DigitalResourceDiscovery": _camera(DigitalResourceDiscovery),
        "PrimitivePanTilt": _pan_tilt(manipulator.PrimitivePanTilt),
        "PanTiltJointPositionSensor": _pan_tilt(manipulator.PanTiltJointPositionSensor),
        "PanTiltJointPositionDriver": _pan_tilt(manipulator.PanTiltJointPositionDriver),
        "PanTiltJointVelocitySensor": _pan_tilt(manipulator.PanTiltJointVelocitySensor),
        "PanTiltJointVelocityDriver": _pan_tilt(manipulator.PanTiltJointVelocityDriver),
        "PanTiltMotionProfileService": _pan_tilt(manipulator.PanTiltMotionProfile),
        "PanTiltSpecificationService": _pan_tilt(manipulator.PanTiltSpecification),
        "JointDescription": ServiceEntry(VisionContext, _described, needs=PAN_TILT),
    },
    "CM-SRV": {
        "ServoModule": ServiceEntry(ServoContext, lambda context: cell.ServoModuleService(context.control)),
        "VacuumConnector": ServiceEntry(
            ServoContext,
            lambda context: _connectors(
                context.control.servo.name, context.control.type.name, context.connectors, context.setup
            ),
            needs=CONNECTORS,
        ),
    },
    "CM-CON": {
        "VacuumConnector": ServiceEntry(
            ConnectorContext,
            lambda context: _connectors(context.part, context.type, context.connectors, context.setup),
            needs=CONNECTORS,
        ),
    },
    "CM-CNV": {
        "Conveyor": ServiceEntry(
            ConveyorContext, lambda context: cell.ConveyorService(context.conveyor, context.max_speed)
        ),
    },
    "CM-PRT": {
        "PartSensor": ServiceEntry(
            PartSensorContext,
            lambda context: cell.PartSensorService(sensor) if (sensor := PartSensor.of(context.robot)) else None,
            needs="a sensor of parts",
        ),
        "ModulePower": ServiceEntry(
            PartSensorContext,
            lambda context: cell.ModulePowerService(power) if (power := ModulePower.of(context.robot)) else None,
            needs="switches of the modules' power",
        ),
    },
    "CM-ARM": {
        "ModularArm": ServiceEntry(
            ModularArmContext, lambda context: cell.ModularArmService(context.control, context.setup)
        ),
    },
}
"""By type of module, in the order in which hosts have them."""


def defaults(module: str) -> tuple[str, ...]:
    """The services of a module of that type that lists none."""
    return (*CORE, *(name for name, entry in BUILT_IN[module].items() if entry.by_default))


def find(module: str, name: str) -> ServiceEntry[Any]:
    """The service of that name for that type of module, beside the core services.

    Raises `ConfigError` if there is none, or if the package that provides it cannot be loaded.
    """
    if (built_in := BUILT_IN[module].get(name)) is not None:
        return built_in
    found = [_load(entry) for entry in entry_points(group=GROUP, name=name)]
    for entry in found:
        if entry.context.module == module:
            return entry
    installed = sorted({entry.name for entry in entry_points(group=GROUP)})
    known = ", ".join((*CORE, *BUILT_IN[module])) + (f"; from other packages: {', '.join(installed)}" * bool(installed))
    raise ConfigError(f"a {module} has no service {name!r}; it can have: {known}")


def _load(entry: EntryPoint) -> ServiceEntry[Any]:
    try:
        found = entry.load()
    except (ImportError, AttributeError) as error:
        raise ConfigError(f"service {entry.name!r} ({entry.value}) cannot be loaded: {error}") from error
    if not isinstance(found, ServiceEntry) or getattr(found.context, "module", None) not in BUILT_IN:
        raise ConfigError(f"service {entry.name!r} ({entry.value}) is not a ServiceEntry for a known module type")
    return found


def make(module: str, names: Iterable[str] | None, context: Context) -> list[Service]:
    """The services of a module that have these names (None: the defaults that the robot has the parts for).

    Raises `ConfigError` for a service that is named and needs what the robot lacks.
    """
    chosen = list(defaults(module) if names is None else names)
    order = list(BUILT_IN[module])
    made: list[Service] = []
    for name in sorted(set(chosen) - set(CORE), key=lambda name: order.index(name) if name in order else len(order)):
        entry = find(module, name)
        service = entry.make(context)
        if service is not None:
            made.append(service)
        elif names is not None:
            raise ConfigError(f"{name} needs {entry.needs or 'a part that this robot does not have'}")
    return made
