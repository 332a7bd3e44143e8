"""Commands to a factory cell, and what shows that they had an effect."""

from __future__ import annotations

from typing import Final

from jauspy.codec.message import Message
from jauspy.conformance.results import Skipped
from jauspy.conformance.state_tests.effects import Limit, effect
from jauspy.conformance.state_tests.explorer import Explorer, Stimulus
from jauspy.conformance.tester import OBSERVER
from jauspy.messages.cell import (
    MoveModularArm,
    QueryConnectorState,
    QueryConveyorState,
    QueryModularArmState,
    QueryModulePower,
    QueryServoGains,
    QueryServoState,
    ReportConnectorState,
    ReportConveyorState,
    ReportModularArmState,
    ReportModulePower,
    ReportServoGains,
    ReportServoState,
    SetConnector,
    SetConveyorSpeed,
    SetModularArmOrder,
    SetModularArmTrajectory,
    SetModulePower,
    SetServoGains,
    SetServoTarget,
)

POSITION: Final = QueryServoState(0x1)
CLAIMED_BY: Final = QueryServoState(0x10000)
ENABLED: Final = QueryConnectorState(0x1, 1)
ATTACHED_TO: Final = QueryConnectorState(0x2, 1)
NAMES: Final = "names of the cell"
PLACES: Final = "positions of the arm"


def _unless_claimed(explorer: Explorer, role: str) -> None:  # noqa: ARG001 - a Prepare
    """Skip the step if a modular arm moves the module, which then ignores targets."""
    state = explorer.client(OBSERVER).ask(CLAIMED_BY, ReportServoState, to=explorer.component)
    if state.claimed_by:
        raise Skipped(f"the modular arm {state.claimed_by!r} moves it; detach it from its base, and test again")


def _unless_attached(explorer: Explorer, role: str) -> None:  # noqa: ARG001 - a Prepare
    """Skip the step if the connector is enabled or holds something, which must not fall."""
    observer = explorer.client(OBSERVER)
    enabled = observer.ask(ENABLED, ReportConnectorState, to=explorer.component).enabled
    held = observer.ask(ATTACHED_TO, ReportConnectorState, to=explorer.component).attached_to
    if enabled or held:
        raise Skipped(f"connector 1 is enabled, and holds {held or 'nothing'}; release it, and test again")


def _remember_joints(explorer: Explorer, role: str) -> None:  # noqa: ARG001 - a Prepare
    report = explorer.client(OBSERVER).ask(QueryModularArmState(), ReportModularArmState, to=explorer.component)
    explorer.tester.memory[NAMES] = [joint.name for joint in report.joint_list]
    explorer.tester.memory[PLACES] = [joint.position for joint in report.joint_list]


def _stay(explorer: Explorer) -> Message:
    """A motion that leaves all joints as they are."""
    kind = MoveModularArm
    return kind(kind.MotionDurationRec(0.0), [kind.JointPositionRec() for _ in explorer.tester.memory[NAMES]])


def _stay_at_a_point(explorer: Explorer) -> Message:
    """A trajectory of one point, to where the joints are."""
    kind, places = SetModularArmTrajectory, explorer.tester.memory[PLACES]
    point = kind.TrajectoryPointSeq(kind.PointTimeRec(0.0), [kind.JointValuesRec(place) for place in places])
    return kind(kind.ModularArmTrajectoryRec(1), [], [point])


def _same_order(explorer: Explorer) -> Message:
    kind = SetModularArmOrder
    return kind([kind.JointNameRec(name) for name in explorer.tester.memory[NAMES]])


def _remember_power(explorer: Explorer, role: str) -> None:  # noqa: ARG001 - a Prepare
    report = explorer.client(OBSERVER).ask(QueryModulePower(), ReportModulePower, to=explorer.component)
    explorer.tester.memory[NAMES] = [(module.name, module.power) for module in report.module_list]


def _same_power(explorer: Explorer) -> Message:
    """Switches all modules to what they are."""
    kind = SetModulePower
    return kind([kind.ModulePowerRec(name, kind.Power(power)) for name, power in explorer.tester.memory[NAMES]])


CELL_COMMANDS: Final = (
    effect(
        lambda position: SetServoTarget(SetServoTarget.Mode.POSITION_MODE, position),
        POSITION,
        ReportServoState,
        "position",
        0.05,
        prepare=_unless_claimed,
    ),
    Limit(SetServoGains, QueryServoGains(), ReportServoGains, "position_p").stimulus(),
    effect(
        lambda enabled: SetConnector(1, SetConnector.Enabled(round(enabled))),
        ENABLED,
        ReportConnectorState,
        "enabled",
        1.0,
        prepare=_unless_attached,
    ),
    effect(SetConveyorSpeed, QueryConveyorState(0x1), ReportConveyorState, "commanded_speed", 0.02),
    Stimulus("MoveModularArm", _stay, before=_remember_joints),
    Stimulus("SetModularArmTrajectory", _stay_at_a_point, before=_remember_joints),
    Stimulus("SetModularArmOrder", _same_order, before=_remember_joints),
    Stimulus("SetModulePower", _same_power, before=_remember_power),
)
"""Servo modules turn by 0.05 rad, the conveyor runs at 0.02 m/s; arms and supplies are left as they are."""
