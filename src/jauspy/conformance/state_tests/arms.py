"""The commands of arms and pan-tilt units, which are accepted only if a motion profile is set."""

from __future__ import annotations

from typing import Final

from jauspy.codec.message import Message
from jauspy.conformance.results import Skipped, StepOutcome
from jauspy.conformance.state_tests import lists
from jauspy.conformance.state_tests.events import UNKNOWN_ID
from jauspy.conformance.state_tests.explorer import Explorer, Prepare, Stimulus
from jauspy.conformance.state_tests.neutral_messages import neutral
from jauspy.conformance.tester import CONTROLLER, OBSERVER
from jauspy.messages.manipulator import (
    ExecuteList,
    QueryCommandedJointPositions,
    QueryJointMotionProfile,
    QueryPanTiltMotionProfile,
    ReportJointMotionProfile,
    ReportPanTiltMotionProfile,
    SetEndEffectorPose,
    SetEndEffectorVelocityState,
    SetJointPositions,
    SetJointVelocity,
    SetPanTiltJointPositions,
    SetPanTiltJointVelocity,
)

MANIPULATOR: Final = "urn:jaus:jss:manipulator:"


def _with_profile(query: Message, report: type[Message], predicate: str, *kinds: type[Message]) -> tuple[Stimulus, ...]:
    def there_is(explorer: Explorer, role: str) -> None:  # noqa: ARG001 - a Prepare
        try:
            explorer.client(OBSERVER).ask(query, report, to=explorer.component)
        except StepOutcome as outcome:
            raise Skipped(f"there is no motion profile: {outcome}") from outcome

    return tuple(_harmless(kind, {predicate: True}, there_is) for kind in kinds)


def _harmless(kind: type[Message], truths: dict[str, bool], before: Prepare) -> Stimulus:
    return Stimulus(kind.NAME, lambda _: neutral(kind), "with a motion profile", truths, before=before, of=MANIPULATOR)


def _hold(explorer: Explorer, role: str) -> None:
    """Set a list of one element, if the sender is in control."""
    if role == CONTROLLER and lists.LIST_MANAGER in explorer.services:
        lists.hold(explorer, role)


def _empty(explorer: Explorer, role: str) -> None:
    """Delete the list, if the sender is in control."""
    if lists.LIST_MANAGER in explorer.services:
        lists.clear(explorer, role)


ARMS: Final = (
    *_with_profile(
        QueryJointMotionProfile(),
        ReportJointMotionProfile,
        "motionProfileExists",
        SetJointPositions,
        SetJointVelocity,
        SetEndEffectorPose,
        SetEndEffectorVelocityState,
    ),
    *_with_profile(
        QueryPanTiltMotionProfile(),
        ReportPanTiltMotionProfile,
        "panTiltMotionProfileExists",
        SetPanTiltJointPositions,
        SetPanTiltJointVelocity,
    ),
    Stimulus(
        "ExecuteList",
        lambda _: ExecuteList(lists.UID),
        "from one that is there",
        {"elementExists": True, "isListValid": True, "motionProfileExists": True},
        before=_hold,
        after=lists.clear,
        of=MANIPULATOR,
    ),
    Stimulus(
        "ExecuteList",
        lambda _: ExecuteList(UNKNOWN_ID),
        "from an unknown one",
        {"elementExists": False},
        of=MANIPULATOR,
    ),
    Stimulus(
        "QueryCommandedJointPositions",
        lambda _: QueryCommandedJointPositions(),
        "with a list",
        {"targetExists": True},
        before=_hold,
        after=lists.clear,
        by_controller=True,
    ),
    Stimulus(
        "QueryCommandedJointPositions",
        lambda _: QueryCommandedJointPositions(),
        "without a list",
        {"targetExists": False},
        before=_empty,
    ),
)
