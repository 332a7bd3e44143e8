"""The parts of a factory cell from which the services of its modules are made."""

from __future__ import annotations

from jauspy.errors import ConfigError
from jauspy.modules import catalogue
from jauspy.modules.catalogue import Context
from jauspy.modules.config import CONNECTOR, CONVEYOR, GRIPPER, MODULAR_ARM, SERVO, ModuleConfig
from jauspy.platform.chassis import Chassis
from jauspy.platform.contract import PartId, RobotParts, Snapshot
from jauspy.platform.modular import arm, servo
from jauspy.platform.modular.cell import CAR, Car, CarState, Conveyor
from jauspy.platform.modular.connector import ConnectorState, VacuumConnector
from jauspy.platform.modular.parts import CellSetup, PartKind, Shape
from jauspy.platform.modular.servo import ServoModule, ServoState
from jauspy.services.cell import ArmMotionControl, ServoControl


def cell_context(module: ModuleConfig, cell: CellSetup, robot: RobotParts) -> Context:
    """The parts of a module of a cell. Raises `ConfigError` if the backend does not have them."""
    part = module.part or ""
    match module.type:
        case _ if module.type == SERVO:
            if (found := servo.find(robot, part)) is None:
                raise _missing(f"servo module {part!r}")
            type = cell.type_of(part)
            return catalogue.ServoContext(robot, ServoControl(found, type), connectors_of(part, cell, robot), cell)
        case _ if module.type == CONNECTOR:
            name = "" if part == GRIPPER else cell.type_of(part).name
            return catalogue.ConnectorContext(robot, part, name, connectors_of(part, cell, robot), cell)
        case _ if module.type == CONVEYOR:
            belt = Conveyor.of(robot)
            if belt is None or cell.conveyor is None:
                raise _missing("conveyor")
            return catalogue.ConveyorContext(robot, belt, cell.conveyor.max_speed)
        case _ if module.type == MODULAR_ARM:
            if (chain := arm.find(robot, part)) is None:
                raise _missing(f"modular arm {part!r}")
            return catalogue.ModularArmContext(robot, ArmMotionControl(chain), cell)
        case _:
            return catalogue.PartSensorContext(robot)


def connectors_of(part: str, cell: CellSetup, robot: RobotParts) -> tuple[VacuumConnector, ...]:
    """The connectors of a part, in the order of its type; the gripper is one. Raises `ConfigError` without one."""
    names = connector_names(part, cell)
    there = {each.name: each for each in robot.optional_parts if isinstance(each, VacuumConnector)}
    for name in names:
        if name not in there:
            raise _missing(f"vacuum connector {name!r}")
    return tuple(there[name] for name in names)


def is_present(module: ModuleConfig, cell: CellSetup | None, snapshot: Snapshot) -> bool:
    """True if a module has a component now: those of parts while they have power, the car while it is assembled."""
    if cell is None or module.part is None:
        return True
    parts = snapshot.parts
    if module.type == SERVO:
        servo_state = parts.get(PartId(ServoModule, module.part))
        return isinstance(servo_state, ServoState) and servo_state.powered
    if module.type == CONNECTOR and module.part != GRIPPER:
        states = (parts.get(PartId(VacuumConnector, name)) for name in connector_names(module.part, cell))
        return any(isinstance(state, ConnectorState) and state.powered for state in states)
    if module.type == "CM-MOB":
        car = parts.get(CAR)
        return isinstance(car, CarState) and car.assembled
    return True


def connector_names(part: str, cell: CellSetup) -> list[str]:
    """The full names of the connectors of a part, in the order of its type; the gripper is one."""
    return [GRIPPER] if part == GRIPPER else [f"{part}/{name}" for name in cell.type_of(part).connectors]


def car_of(robot: RobotParts) -> Car:
    """The car. Raises `ConfigError` if the backend has none."""
    if (car := Car.of(robot)) is None:
        raise _missing("car")
    return car


def car_chassis(cell: CellSetup) -> Chassis:
    """The car as guidance sees it: its size, and what its wheels and the fastest servo modules can do."""
    base = cell.type_of(cell.car)
    wheels = [each.solids[0] for each in cell.types.values() if each.kind is PartKind.WHEEL]
    radius = max((each.size[0] for each in wheels if each.shape is Shape.CYLINDER), default=0.0)
    fastest = max((each.servo.max_speed for each in cell.types.values() if each.servo), default=0.0)
    sides = [frame.position for frame in base.connectors.values()]
    length, width = (max((abs(at[axis]) for at in sides), default=0.0) for axis in (0, 1))
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
        mass=sum(each.mass for each in base.solids),
    )


def _missing(what: str) -> ConfigError:
    return ConfigError(f"the backend has no {what}, which the file of the robot names")
