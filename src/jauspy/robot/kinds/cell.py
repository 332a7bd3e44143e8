"""The kinds of modules of a factory cell: servo modules, connectors, the conveyor, sensors of parts, modular arms."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar, Final

from jauspy.errors import ConfigError
from jauspy.platform.contract import PartId, RobotParts, Snapshot
from jauspy.platform.modular import arm, servo
from jauspy.platform.modular.cell import Conveyor, ModulePower, PartSensor
from jauspy.platform.modular.connector import ConnectorState, VacuumConnector
from jauspy.platform.modular.parts import CellSetup
from jauspy.platform.modular.servo import ServoModule, ServoState
from jauspy.services import cell
from jauspy.services.cell import ArmMotionControl, ServoControl

from .kind import Kind, Module, ModuleBuild, ServiceEntry, Stoppable, not_in_backend

GRIPPER: Final = "gripper"
"""The `part` of the CM-CON that is the robot's vacuum gripper."""

_CONNECTORS: Final = "vacuum connectors"


@dataclass(frozen=True, slots=True)
class ServoContext:
    """Parts from which the services of a CM-SRV are made."""

    module: ClassVar[str] = "CM-SRV"
    robot: RobotParts
    control: ServoControl
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
    control: ArmMotionControl
    setup: CellSetup

    @property
    def moving(self) -> Stoppable:
        """The arm."""
        return self.control


def _connectors(
    part: str, type: str, connectors: Sequence[VacuumConnector], setup: CellSetup
) -> cell.VacuumConnectorService | None:
    if not connectors:
        return None
    limits = setup.limits
    strength = limits.strength(latched=setup.types[type].latch) if type else limits.gripper.holding
    return cell.VacuumConnectorService(part, type, connectors, limits, strength)


def _cell(build: ModuleBuild) -> CellSetup:
    if build.model.cell is None:
        raise ConfigError(f"{build.id} is a {build.module.type}, and the robot has no factory cell")
    return build.model.cell


def _connector_names(part: str, cell: CellSetup) -> list[str]:
    """The full names of the connectors of a part, in the order of its type; the gripper is one."""
    return [GRIPPER] if part == GRIPPER else [f"{part}/{name}" for name in cell.type_of(part).connectors]


def _connectors_of(part: str, cell: CellSetup, robot: RobotParts) -> tuple[VacuumConnector, ...]:
    """The connectors of a part, in the order of its type; the gripper is one. Raises `ConfigError` without one."""
    names = _connector_names(part, cell)
    connectors = {found.name: found for found in robot.optional_parts if isinstance(found, VacuumConnector)}
    for name in names:
        if name not in connectors:
            raise not_in_backend(f"vacuum connector {name!r}")
    return tuple(connectors[name] for name in names)


class Servo(Kind[ServoContext]):
    """The kind CM-SRV: a servo module, with the connectors of its output."""

    type: ClassVar[str] = "CM-SRV"
    services: ClassVar[Mapping[str, ServiceEntry[Any]]] = {
        "ServoModule": ServiceEntry(ServoContext, lambda context: cell.ServoModuleService(context.control)),
        "VacuumConnector": ServiceEntry(
            ServoContext,
            lambda context: _connectors(
                context.control.servo.name, context.control.type.name, context.connectors, context.setup
            ),
            needs=_CONNECTORS,
        ),
    }
    own_keys: ClassVar[frozenset[str]] = frozenset({"part"})
    needs_part: ClassVar[bool] = True
    in_cell: ClassVar[bool] = True

    def context(self, build: ModuleBuild) -> ServoContext:
        """The servo module and its connectors."""
        cell, part = _cell(build), build.module.part or ""
        if (found := servo.find(build.robot, part)) is None:
            raise not_in_backend(f"servo module {part!r}")
        control = ServoControl(found, cell.type_of(part))
        return ServoContext(build.robot, control, _connectors_of(part, cell, build.robot), cell)

    def parts_in(self, cell: CellSetup) -> Sequence[str]:
        """The parts with a servo."""
        return [part.name for part in cell.parts if cell.types[part.type].servo]

    def moved(self, module: Module) -> str:
        """The servo."""
        return f"servo {module.part!r}"

    def is_present(self, module: Module, cell: CellSetup | None, snapshot: Snapshot) -> bool:
        """True while the part has power."""
        if cell is None or module.part is None:
            return True
        state = snapshot.parts.get(PartId(ServoModule, module.part))
        return isinstance(state, ServoState) and state.powered


class Connector(Kind[ConnectorContext]):
    """The kind CM-CON: the vacuum connectors of one part."""

    type: ClassVar[str] = "CM-CON"
    services: ClassVar[Mapping[str, ServiceEntry[Any]]] = {
        "VacuumConnector": ServiceEntry(
            ConnectorContext,
            lambda context: _connectors(context.part, context.type, context.connectors, context.setup),
            needs=_CONNECTORS,
        ),
    }
    own_keys: ClassVar[frozenset[str]] = frozenset({"part"})
    needs_part: ClassVar[bool] = True
    in_cell: ClassVar[bool] = True

    def context(self, build: ModuleBuild) -> ConnectorContext:
        """The connectors."""
        cell, part = _cell(build), build.module.part or ""
        type = "" if part == GRIPPER else cell.type_of(part).name
        return ConnectorContext(build.robot, part, type, _connectors_of(part, cell, build.robot), cell)

    def parts_in(self, cell: CellSetup) -> Sequence[str]:
        """The parts with connectors, and the gripper."""
        parts = [part.name for part in cell.parts if cell.types[part.type].connectors]
        return parts + [GRIPPER] * bool(cell.gripper)

    def moved(self, module: Module) -> str:
        """The connectors."""
        return f"connectors of {module.part!r}"

    def is_present(self, module: Module, cell: CellSetup | None, snapshot: Snapshot) -> bool:
        """True while one of the connectors has power; the gripper always has."""
        if cell is None or module.part is None or module.part == GRIPPER:
            return True
        states = (snapshot.parts.get(PartId(VacuumConnector, name)) for name in _connector_names(module.part, cell))
        return any(isinstance(state, ConnectorState) and state.powered for state in states)


class ConveyorBelt(Kind[ConveyorContext]):
    """The kind CM-CNV: the conveyor."""

    type: ClassVar[str] = "CM-CNV"
    services: ClassVar[Mapping[str, ServiceEntry[Any]]] = {
        "Conveyor": ServiceEntry(
            ConveyorContext, lambda context: cell.ConveyorService(context.conveyor, context.max_speed)
        ),
    }
    in_cell: ClassVar[bool] = True

    def context(self, build: ModuleBuild) -> ConveyorContext:
        """The belt."""
        belt, setup = Conveyor.of(build.robot), _cell(build).conveyor
        if belt is None or setup is None:
            raise not_in_backend("conveyor")
        return ConveyorContext(build.robot, belt, setup.max_speed)

    def check_cell(self, module: Module, cell: CellSetup) -> None:
        """Check that the cell has a conveyor."""
        if cell.conveyor is None:
            raise ValueError(f"cell.conveyor: is missing; {module.component} is a {self.type}")

    def moved(self, module: Module) -> str:
        """The conveyor."""
        return "conveyor"


class PartSensors(Kind[PartSensorContext]):
    """The kind CM-PRT: the sensor of parts, and the switches of the modules' power."""

    type: ClassVar[str] = "CM-PRT"
    services: ClassVar[Mapping[str, ServiceEntry[Any]]] = {
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
    }
    in_cell: ClassVar[bool] = True

    def context(self, build: ModuleBuild) -> PartSensorContext:
        """The robot, of which the sensor and the switches are optional parts."""
        return PartSensorContext(build.robot)


class ModularArmKind(Kind[ModularArmContext]):
    """The kind CM-ARM: an arm of any number of servo modules."""

    type: ClassVar[str] = "CM-ARM"
    services: ClassVar[Mapping[str, ServiceEntry[Any]]] = {
        "ModularArm": ServiceEntry(
            ModularArmContext, lambda context: cell.ModularArmService(context.control, context.setup)
        ),
    }
    own_keys: ClassVar[frozenset[str]] = frozenset({"part"})
    needs_part: ClassVar[bool] = True
    in_cell: ClassVar[bool] = True

    def context(self, build: ModuleBuild) -> ModularArmContext:
        """The arm."""
        if (found := arm.find(build.robot, build.module.part or "")) is None:
            raise not_in_backend(f"modular arm {build.module.part!r}")
        return ModularArmContext(build.robot, ArmMotionControl(found), _cell(build))

    def parts_in(self, cell: CellSetup) -> Sequence[str]:
        """The arms."""
        return [name for name in (cell.arm, cell.second_arm) if name]

    def moved(self, module: Module) -> str:
        """The arm."""
        return f"modular arm {module.part!r}"
