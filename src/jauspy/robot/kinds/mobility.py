"""CM-MOB: the chassis of the robot, or the car of its factory cell."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar, Final

from jauspy.platform.chassis import Chassis, chassis_of
from jauspy.platform.commands import CHASSIS
from jauspy.platform.contract import DriveBase, PartId, RobotParts, Snapshot
from jauspy.platform.description import RobotModel
from jauspy.platform.drives import ParkingBrake
from jauspy.platform.lights import lamps_of
from jauspy.platform.localization import Localization, LocalizedDrive
from jauspy.platform.modular.cell import Car, CarState
from jauspy.platform.modular.parts import CellSetup, PartKind, Shape
from jauspy.services import mobility, ugv
from jauspy.services.mobility import GlobalPose, Vehicle
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
}


class Mobility(Kind[MobilityContext]):
    """The kind CM-MOB."""

    type: ClassVar[str] = "CM-MOB"
    services: ClassVar[Mapping[str, ServiceEntry[Any]]] = SERVICES
    own_keys: ClassVar[frozenset[str]] = frozenset({"part"})

    def context(self, build: ModuleBuild) -> MobilityContext:
        """The chassis, or the car, with the frames and the pilot that its services share."""
        cell = build.model.cell
        if build.module.part == CAR and cell is not None:
            car = Vehicle(_car_of(build.robot), name=cell.car, chassis=_car_chassis(cell))
            return MobilityContext(build.robot, car)
        return MobilityContext(build.robot, vehicle_of(build.name, build.origin, build.model, build.robot))

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


def vehicle_of(name: str, origin: GlobalPose | None, model: RobotModel, robot: RobotParts) -> Vehicle:
    """The chassis and reference frames that the services of a CM-MOB share.

    They use the pose that the robot estimates, unless it is exact. `name`: of the robot; `origin`: of its world.
    """
    localization = Localization.of(robot)
    drive: DriveBase = robot.drive if localization is None else LocalizedDrive(robot.drive, localization)
    return Vehicle(drive, name=name, chassis=chassis_of(model), origin=origin, localization=localization)


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
