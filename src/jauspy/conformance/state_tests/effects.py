"""Commands whose effect a report shows: accepted commands must have it, ignored commands must not."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any, Final

from jauspy.codec.message import Message
from jauspy.conformance.checks import near, value_of
from jauspy.conformance.results import Skipped
from jauspy.conformance.state_tests.behaviour import TruthValue
from jauspy.conformance.state_tests.explorer import Explorer, Prepare, Stimulus, StimulusResult, no_preparation
from jauspy.conformance.tester import OBSERVER
from jauspy.messages.manipulator import (
    QueryEndEffectorEffort,
    QueryToolOffset,
    ReportEndEffectorEffort,
    ReportToolOffset,
    SetEndEffectorEffort,
    SetToolOffset,
)
from jauspy.messages.mobility import (
    QueryGeomagneticProperty,
    QueryGlobalPose,
    QueryGlobalPoseExt,
    QueryGlobalVector,
    QueryGlobalVectorExt,
    QueryLocalPose,
    QueryLocalPoseExt,
    QueryLocalVector,
    QueryLocalVectorExt,
    QueryWrenchEffort,
    ReportGeomagneticProperty,
    ReportGlobalPose,
    ReportGlobalPoseExt,
    ReportGlobalVector,
    ReportGlobalVectorExt,
    ReportLocalPose,
    ReportLocalPoseExt,
    ReportLocalVector,
    ReportLocalVectorExt,
    ReportWrenchEffort,
    SetGeomagneticProperty,
    SetGlobalPose,
    SetGlobalPoseExt,
    SetGlobalVector,
    SetGlobalVectorExt,
    SetLocalPose,
    SetLocalPoseExt,
    SetLocalVector,
    SetLocalVectorExt,
    SetTravelSpeedExt,
    SetWrenchEffort,
)
from jauspy.messages.ugv import QuerySkidSteerEffort, ReportSkidSteerEffort, SetSkidSteerEffort

SLOW: Final = 0.05
"""m/s; too slow for a visible motion during a step."""
Speed = SetTravelSpeedExt.Speed
BEFORE: Final = "before the command"


def over_ground(speed: float) -> Any:
    """The speed as the messages with more fields encode it."""
    return Speed(Speed.Choice.SPEED_OVER_GROUND, speed)


def effect(
    command: Callable[[float], Message],
    query: Message,
    report: type[Message],
    field: str,
    change: float,
    *,
    truths: Mapping[str, TruthValue] = MappingProxyType({}),
    variant: str = "",
    prepare: Prepare = no_preparation,
    cleanup: Prepare = no_preparation,
    of: str = "",
) -> Stimulus:
    """A command that changes one number slightly; afterwards the client restores it."""

    def reported(explorer: Explorer) -> float:
        found = value_of(explorer.client(OBSERVER).ask(query, report, to=explorer.component), field)
        if found is None:
            raise Skipped(f"{report.NAME} has no {field}, which would show what the command does")
        return float(found)

    def before(explorer: Explorer, role: str) -> None:
        explorer.tester.memory.pop(BEFORE, None)
        prepare(explorer, role)
        explorer.tester.memory[BEFORE] = reported(explorer)

    def verify(then: StimulusResult) -> None:
        explorer = then.explorer
        wanted = explorer.tester.memory[BEFORE] + (change if then.outcome.acts else 0.0)
        right = near(abs(change) / 4, **{field: wanted})
        explorer.client(OBSERVER).ask_until_right(query, report, right, to=explorer.component)

    def after(explorer: Explorer, role: str) -> None:
        if BEFORE in explorer.tester.memory:
            explorer.client(role).send(command(explorer.tester.memory[BEFORE]), to=explorer.component)
            explorer.observe()
        cleanup(explorer, role)

    return Stimulus(
        command(0.0).NAME,
        lambda explorer: command(explorer.tester.memory[BEFORE] + change),
        variant,
        truths,
        before=before,
        after=after,
        verify=verify,
        of=of,
    )


EFFECTS: Final = (
    effect(
        lambda percent: SetWrenchEffort(propulsive_linear_effort_x=percent),
        QueryWrenchEffort(1),
        ReportWrenchEffort,
        "propulsive_linear_effort_x",
        1.0,
    ),
    effect(
        lambda percent: SetSkidSteerEffort(percent, percent),
        QuerySkidSteerEffort(),
        ReportSkidSteerEffort,
        "left_side_propulsive_effort",
        1.0,
    ),
    effect(SetEndEffectorEffort, QueryEndEffectorEffort(), ReportEndEffectorEffort, "end_effector_effort", 1.0),
    effect(lambda x: SetLocalPose(x=x), QueryLocalPose(1), ReportLocalPose, "x", 2.0),
    effect(lambda degrees: SetGlobalPose(latitude=degrees), QueryGlobalPose(1), ReportGlobalPose, "latitude", 0.001),
    effect(SetLocalVector, QueryLocalVector(0), ReportLocalVector, "speed", SLOW),
    effect(SetGlobalVector, QueryGlobalVector(1), ReportGlobalVector, "speed", SLOW),
    effect(lambda x: SetLocalPoseExt(x=x), QueryLocalPoseExt(1), ReportLocalPoseExt, "x", 2.0),
    effect(
        lambda degrees: SetGlobalPoseExt(latitude=degrees),
        QueryGlobalPoseExt(1),
        ReportGlobalPoseExt,
        "latitude",
        0.001,
    ),
    effect(SetGeomagneticProperty, QueryGeomagneticProperty(), ReportGeomagneticProperty, "magnetic_variation", 0.1),
    effect(
        lambda speed: SetLocalVectorExt(speed=over_ground(speed)),
        QueryLocalVectorExt(0),
        ReportLocalVectorExt,
        "speed__value",
        SLOW,
    ),
    effect(
        lambda speed: SetGlobalVectorExt(speed=over_ground(speed)),
        QueryGlobalVectorExt(0),
        ReportGlobalVectorExt,
        "speed__value",
        SLOW,
    ),
    effect(lambda x: SetToolOffset(x, 0.0, 0.0), QueryToolOffset(), ReportToolOffset, "tool_point_coordinate_x", 0.1),
)
"""Percent; too little to move a robot."""
