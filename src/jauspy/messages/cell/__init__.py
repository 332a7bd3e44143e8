"""Messages of cell, newest versions; loaded on use. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jauspy.codec.registry import lazy

if TYPE_CHECKING:
    from jauspy.messages.cell.v1_0.conveyor import (
        QueryConveyorState as QueryConveyorState, ReportConveyorState as ReportConveyorState,
        SetConveyorSpeed as SetConveyorSpeed,
    )
    from jauspy.messages.cell.v1_0.modular_arm import (
        HoldModularArm as HoldModularArm, MoveModularArm as MoveModularArm,
        QueryModularArmMotionResult as QueryModularArmMotionResult,
        QueryModularArmSpecification as QueryModularArmSpecification, QueryModularArmState as QueryModularArmState,
        ReportModularArmMotionResult as ReportModularArmMotionResult,
        ReportModularArmSpecification as ReportModularArmSpecification,
        ReportModularArmState as ReportModularArmState, SetModularArmController as SetModularArmController,
        SetModularArmOrder as SetModularArmOrder, SetModularArmTrajectory as SetModularArmTrajectory,
    )
    from jauspy.messages.cell.v1_0.module_power import (
        QueryModuleEnergy as QueryModuleEnergy, QueryModulePower as QueryModulePower,
        ReportModuleEnergy as ReportModuleEnergy, ReportModulePower as ReportModulePower,
        SetModulePower as SetModulePower,
    )
    from jauspy.messages.cell.v1_0.part_sensor import (
        QueryPartObservations as QueryPartObservations, ReportPartObservations as ReportPartObservations,
    )
    from jauspy.messages.cell.v1_0.servo_module import (
        QueryServoGains as QueryServoGains, QueryServoSpecification as QueryServoSpecification,
        QueryServoState as QueryServoState, ReportServoGains as ReportServoGains,
        ReportServoSpecification as ReportServoSpecification, ReportServoState as ReportServoState,
        SetServoGains as SetServoGains, SetServoTarget as SetServoTarget,
    )
    from jauspy.messages.cell.v1_0.vacuum_connector import (
        QueryConnectorSpecification as QueryConnectorSpecification, QueryConnectorState as QueryConnectorState,
        ReportConnectorSpecification as ReportConnectorSpecification, ReportConnectorState as ReportConnectorState,
        ScheduleConnector as ScheduleConnector, SetConnector as SetConnector,
    )

__all__, __getattr__, __dir__ = lazy(__name__, {
    "jauspy.messages.cell.v1_0.conveyor": "QueryConveyorState ReportConveyorState SetConveyorSpeed",
    "jauspy.messages.cell.v1_0.modular_arm": "HoldModularArm MoveModularArm QueryModularArmMotionResult QueryModularArmSpecification QueryModularArmState ReportModularArmMotionResult ReportModularArmSpecification ReportModularArmState SetModularArmController SetModularArmOrder SetModularArmTrajectory",
    "jauspy.messages.cell.v1_0.module_power": "QueryModuleEnergy QueryModulePower ReportModuleEnergy ReportModulePower SetModulePower",
    "jauspy.messages.cell.v1_0.part_sensor": "QueryPartObservations ReportPartObservations",
    "jauspy.messages.cell.v1_0.servo_module": "QueryServoGains QueryServoSpecification QueryServoState ReportServoGains ReportServoSpecification ReportServoState SetServoGains SetServoTarget",
    "jauspy.messages.cell.v1_0.vacuum_connector": "QueryConnectorSpecification QueryConnectorState ReportConnectorSpecification ReportConnectorState ScheduleConnector SetConnector",
})
