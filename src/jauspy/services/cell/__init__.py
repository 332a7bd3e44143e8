"""Services of a modular factory cell (`urn:jauspy:cell:...`) over the contracts of `jauspy.platform.modular`."""

from jauspy.services.cell.equipment import ConveyorService, ModulePowerService, PartSensorService
from jauspy.services.cell.modular_arm import ArmMotionControl, ModularArmService, motion_command, trajectory_command
from jauspy.services.cell.servo_module import ServoControl, ServoModuleService
from jauspy.services.cell.vacuum_connector import VacuumConnectorService

__all__ = [
    "ArmMotionControl",
    "ConveyorService",
    "ModularArmService",
    "ModulePowerService",
    "PartSensorService",
    "ServoControl",
    "ServoModuleService",
    "VacuumConnectorService",
    "motion_command",
    "trajectory_command",
]
