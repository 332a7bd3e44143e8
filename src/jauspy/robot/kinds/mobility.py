"""CM-MOB: the chassis of the robot, or the car of its factory cell."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, ClassVar, Final

from jauspy.platform.chassis import Chassis, chassis_of
from jauspy.platform.commands import CHASSIS
from jauspy.platform.contract import DriveBase, PartId, RobotParts, Snapshot
from jauspy.platform.description import RobotModel
from jauspy.platform.drives import ParkingBrake
from jauspy.platform.guards import ObstacleGuard
from jauspy.platform.lights import lamps_of
from jauspy.platform.localization import Localization, LocalizedDrive
from jauspy.platform.modular.cell import Car, CarState
from jauspy.platform.modular.parts import CellSetup, PartKind, Shape
from jauspy.platform.stability import StabilityMonitor
from jauspy.services import iop, mobility, ugv
from jauspy.services.iop.comms_lost import CommsLostPolicy
from jauspy.services.iop.retrotraverse import RetraceRequest
from jauspy.services.mobility import GlobalPose, Vehicle
from jauspy.services.mobility.retraced_joints import OwnMotion, RetracedJoints, joints_with_tracks
from jauspy.services.service import Service
from jauspy.services.ugv.parking_brake import ParkingBrakeDriver

from .kind import Kind, Module, ModuleBuild, ServiceEntry, Stoppable, not_in_backend

CAR: Final = "car"
"""The `part` of the module that drives the car of the cell."""

ORIGIN: Final = "an origin: latitude, longitude, altitude and heading"


@dataclass(frozen=True, slots=True)
class MobilityContext:
    """Parts from which the services of a CM-MOB are made."""

    module: ClassVar[str] = "CM-MOB"
    robot: RobotParts
    vehicle: Vehicle
    stability: StabilityMonitor | None = None
    """Monitor that keeps the robot from tipping over."""
    part: str = "chassis"
    """Name in `OwnMotion` of what the module drives."""
    flippers: RetracedJoints | None = None
    """Joints that carry tracks."""
    own_motion: OwnMotion = field(default_factory=OwnMotion)
    comms_lost: CommsLostPolicy = field(default_factory=CommsLostPolicy)
    """Reaction of the robot to a lost link, until a client says otherwise."""

    @property
    def moving(self) -> Stoppable:
        """The chassis."""
        return self.vehicle.pilot


def _vehicle(make: Callable[[Vehicle], Service]) -> ServiceEntry[MobilityContext]:
    return ServiceEntry(MobilityContext, lambda context: make(context.vehicle))


def _global(make: Callable[[Vehicle], Service]) -> ServiceEntry[MobilityContext]:
    return ServiceEntry(
        MobilityContext, lambda context: make(context.vehicle) if context.vehicle.has_origin else None, needs=ORIGIN
    )


SERVICES: Final[Mapping[str, ServiceEntry[Any]]] = {
    "EnhancedAccessControl": ServiceEntry(MobilityContext, lambda _: iop.EnhancedAccessControl(), by_default=False),
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
    "EnhancedLocalWaypointListDriver": _vehicle(lambda _: iop.EnhancedLocalWaypointListDriver()),
    "EnhancedGlobalWaypointListDriver": _global(lambda _: iop.EnhancedGlobalWaypointListDriver()),
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
    "StabilityControl": ServiceEntry(
        MobilityContext,
        lambda context: iop.StabilityControl(context.stability) if context.stability else None,
        needs="the table [stability], and tracks or wheels",
    ),
    "Retrotraverse": ServiceEntry(
        MobilityContext,
        lambda context: iop.Retrotraverse(context.vehicle, joints=context.flippers, own_motion=context.own_motion),
    ),
    "CommsLostPolicyManager": ServiceEntry(
        MobilityContext,
        lambda context: iop.CommsLostPolicyManager(
            context.vehicle, default=context.comms_lost, part=context.part, own_motion=context.own_motion
        ),
    ),
    "PlatformSpecifications": _vehicle(ugv.PlatformSpecifications),
    "IlluminationService": ServiceEntry(
        MobilityContext,
        lambda context: ugv.IlluminationService(lamps) if (lamps := lamps_of(context.robot)) else None,
        needs="lamps ([[lights]])",
    ),
    "Convoy": ServiceEntry(MobilityContext, lambda _: iop.Convoy()),
    "LeaderManagement": _vehicle(iop.LeaderManagement),
    "LeaderFollowerDriver": _global(iop.LeaderFollowerDriver),
    "ParkingBrakeDriver": ServiceEntry(
        MobilityContext,
        lambda context: ParkingBrakeDriver(brake) if (brake := ParkingBrake.of(context.robot)) else None,
        needs="a parking brake",
        by_default=False,  # leaving Ready engages it: a client that does not know it could drive only once
    ),
}


class Mobility(Kind[MobilityContext]):
    """The kind CM-MOB."""

    type: ClassVar[str] = "CM-MOB"
    services: ClassVar[Mapping[str, ServiceEntry[Any]]] = SERVICES
    own_keys: ClassVar[frozenset[str]] = frozenset({"part", "comms_lost"})

    def context(self, build: ModuleBuild) -> MobilityContext:
        """The chassis, or the car, with the frames and the pilot that its services share."""
        cell = build.model.cell
        policy = build.module.comms_lost or CommsLostPolicy()
        if build.module.part == CAR and cell is not None:
            car = Vehicle(_car_of(build.robot), name=cell.car, chassis=_car_chassis(cell))
            return MobilityContext(
                build.robot, car, part=self.moved(build.module), own_motion=build.shared.own_motion, comms_lost=policy
            )
        stability = build.shared.stability
        return MobilityContext(
            build.robot,
            vehicle_of(build.name, build.origin, build.model, build.robot, stability=stability),
            stability,
            flippers=joints_with_tracks(build.model, build.robot.groups),
            own_motion=build.shared.own_motion,
            comms_lost=policy,
        )

    def check(self, module: Module, needs: Mapping[str, Sequence[str]]) -> None:
        """Check that it offers the services that react to a lost link as its table says."""
        super().check(module, needs)
        if module.services is None or module.comms_lost is None:
            return
        needed = ["CommsLostPolicyManager"]
        if isinstance(module.comms_lost.reaction, RetraceRequest):
            needed.append("Retrotraverse")
        if missing := [name for name in needed if name not in module.services]:
            raise ValueError(f"comms_lost: needs {' and '.join(missing)}; list what is missing in `services`")

    def parts_in(self, cell: CellSetup) -> Sequence[str]:
        """The car."""
        return [CAR] * bool(cell.car)

    def moved(self, module: Module) -> str:
        """The chassis or the car."""
        return "chassis" if module.part is None else f"car {module.part!r}"

    def uses(self, module: Module, part: PartId) -> bool:
        """True for the chassis and its brake, or for the car."""
        if module.part is not None:
            return super().uses(module, part)
        return part in (CHASSIS, PartId(ParkingBrake))

    def is_present(self, module: Module, cell: CellSetup | None, snapshot: Snapshot) -> bool:
        """True, except for a car that is not assembled."""
        if cell is None or module.part is None:
            return True
        car = snapshot.parts.get(PartId(Car))
        return isinstance(car, CarState) and car.assembled


def vehicle_of(
    name: str,
    origin: GlobalPose | None,
    model: RobotModel,
    robot: RobotParts,
    *,
    stability: StabilityMonitor | None = None,
) -> Vehicle:
    """The chassis and reference frames that the services of a CM-MOB share.

    They use the pose that the robot estimates, unless it is exact. `name`: of the robot; `origin`: of its world;
    `stability`: what keeps it from tipping over.
    """
    localization = Localization.of(robot)
    drive: DriveBase = robot.drive if localization is None else LocalizedDrive(robot.drive, localization)
    return Vehicle(
        drive,
        name=name,
        chassis=chassis_of(model),
        origin=origin,
        localization=localization,
        stability=stability,
        obstacle_guard=ObstacleGuard.of(robot),
    )


def _car_of(robot: RobotParts) -> Car:
    """The car. Raises `ConfigError` if the backend has none."""
    if (car := Car.of(robot)) is None:
        raise not_in_backend("car")
    return car


def _car_chassis(cell: CellSetup) -> Chassis:
    """The car's chassis for guidance: its size, and the limits of its wheels and fastest servo modules."""
    base = cell.type_of(cell.car)
    wheels = [part.solids[0] for part in cell.types.values() if part.kind is PartKind.WHEEL]
    radius = max((wheel.size[0] for wheel in wheels if wheel.shape is Shape.CYLINDER), default=0.0)
    fastest = max((part.servo.max_speed for part in cell.types.values() if part.servo), default=0.0)
    sides = [frame.position for frame in base.connectors.values()]
    length, width = (max((abs(side[axis]) for side in sides), default=0.0) for axis in (0, 1))
    speed, track = radius * fastest, 2.0 * width
    return Chassis(
        max_speed=speed,
        max_turn_rate=speed / track if track else 0.0,
        acceleration=speed / 2.0,
        deceleration=speed,
        track_separation=track,
        front=length + radius,
        back=length + radius,
        left=width,
        right=width,
        mass=sum(solid.mass for solid in base.solids),
    )
