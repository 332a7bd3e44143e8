"""The inputs of ListManager, and what its list must hold afterwards."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from jauspy.codec.message import Message
from jauspy.conformance.checks import has, that
from jauspy.conformance.results import Failed, Skipped
from jauspy.conformance.state_tests.events import CREATE, UNKNOWN_ID
from jauspy.conformance.state_tests.explorer import Explorer, Stimulus, StimulusResult
from jauspy.conformance.state_tests.neutral_messages import neutral
from jauspy.conformance.tester import CONTROLLER, OBSERVER
from jauspy.messages import registry
from jauspy.messages.core import (
    ConfirmElementRequest,
    DeleteElement,
    ElementRec,
    QueryElement,
    QueryElementCount,
    QueryElementList,
    RejectElementRequest,
    ReportElementCount,
    ReportElementList,
    SetElement,
    Standby,
)

LIST_MANAGER: Final = "urn:jaus:jss:core:ListManager"
UID: Final = 7
"""UID of the element that the test sets."""
ALL: Final = 65535
"""UID that deletes the whole list (AS5710)."""
UNKNOWN: Final = bytes.fromhex("ffee")
"""A message that no service defines, so no list accepts it."""
CANDIDATES: Final = (
    "SetLocalWaypoint",
    "SetGlobalWaypoint",
    "SetLocalPathSegment",
    "SetGlobalPathSegment",
    "SetJointPositions",
    "SetEndEffectorPose",
    "Standby",
)
"""Commands that elements may contain; the test tries which ones the component accepts."""
COUNT: Final = "elements before"


WAYPOINT_LIST: Final = "WaypointListDriver"
"""Ends of the URNs of drivers whose lists must accept any waypoint."""


def upload(content: Message | bytes, uid: int = UID, previous: int = 0) -> SetElement:
    """A command that sets one element, alone or after another one."""
    data = ElementRec.ElementData(0, content)
    return SetElement(SetElement.RequestIDRec(CREATE), [ElementRec(uid, previous, 0, data)])


def delete(uid: int) -> DeleteElement:
    """A command that deletes one element, or all."""
    return DeleteElement(DeleteElement.RequestIDRec(CREATE), [DeleteElement.DeleteElementRec(uid)])


def _content_of(explorer: Explorer) -> str:
    return f"content of the list of {explorer.component}"


def content(explorer: Explorer) -> Message:
    """A command that this component's list accepts, once it is known."""
    found: Message = explorer.tester.memory.get(_content_of(explorer), Standby())
    return found


def clear(explorer: Explorer, role: str) -> None:
    """Delete the list, if the sender is in control."""
    if role == CONTROLLER:
        for uid in (UID, ALL):
            explorer.client(role).send(delete(uid), to=explorer.component)
        explorer.observe()


def find(explorer: Explorer, role: str) -> None:
    """Delete the list, and find a command that it accepts if the sender is in control."""
    clear(explorer, role)
    if role == CONTROLLER and _content_of(explorer) not in explorer.tester.memory:
        accepted = (message for message in map(_harmless, CANDIDATES) if _is_accepted(explorer, message))
        found = next(accepted, None)
        if found is None:
            must = any(service.endswith(WAYPOINT_LIST) for service in explorer.services)
            raise (Failed if must else Skipped)(f"the list takes none of {', '.join(CANDIDATES)}")
        explorer.tester.memory[_content_of(explorer)] = found
        clear(explorer, role)
    _count(explorer, role)


def _harmless(name: str) -> Message:
    return neutral(registry.by_name(name))


def _is_accepted(explorer: Explorer, candidate: Message) -> bool:
    client, answers = explorer.client(CONTROLLER), (ConfirmElementRequest.CODE, RejectElementRequest.CODE)
    client.pending.clear()
    client.send(upload(candidate), to=explorer.component)
    end = explorer.tester.now + explorer.tester.timeout
    explorer.tester.pump(end, lambda: any(packet.code in answers for packet in client.pending))
    return any(packet.code == ConfirmElementRequest.CODE for packet in client.pending)


def hold(explorer: Explorer, role: str) -> None:
    """Set a list of one element."""
    find(explorer, role)
    client = explorer.client(role)
    client.ask(upload(content(explorer)), ConfirmElementRequest, has(request_id=CREATE), to=explorer.component)


def _set_before_release(explorer: Explorer, role: str) -> None:  # noqa: ARG001 - a Prepare
    """Set a list as a client that then releases control; the component may keep or delete it."""
    explorer.steer("RequestControl", CONTROLLER)
    hold(explorer, CONTROLLER)
    explorer.steer("ReleaseControl", CONTROLLER)
    explorer.observe()


def _removed(explorer: Explorer, role: str) -> None:  # noqa: ARG001 - a Prepare
    explorer.steer("RequestControl", CONTROLLER)
    clear(explorer, CONTROLLER)
    explorer.steer("ReleaseControl", CONTROLLER)
    explorer.observe()


def _count(explorer: Explorer, role: str) -> None:  # noqa: ARG001 - a Prepare
    observer = explorer.client(OBSERVER)
    report = observer.ask(QueryElementCount(), ReportElementCount, to=explorer.component)
    explorer.tester.memory[COUNT] = report.element_count


def _check_elements(*uids: int) -> Callable[[StimulusResult], None]:
    """Check that the list contains these elements if the controller sent the command, and is unchanged otherwise."""

    def verify(then: StimulusResult) -> None:
        explorer = then.explorer
        observer, is_controller = explorer.client(OBSERVER), then.role == CONTROLLER
        if not is_controller:
            unchanged = has(element_count=explorer.tester.memory[COUNT])
            observer.ask(QueryElementCount(), ReportElementCount, unchanged, to=explorer.component)
        else:
            right = that("lists what was set", lambda report: [e.element_uid for e in report.element_list] == [*uids])
            observer.ask(QueryElementList(), ReportElementList, right, to=explorer.component)

    return verify


_REJECTED: Final = {"RejectElementRequest": has(request_id=CREATE)}
_CONFIRMED: Final = {"ConfirmElementRequest": has(request_id=CREATE)}

LISTS: Final = (
    Stimulus(
        "SetElement",
        lambda explorer: upload(content(explorer)),
        "a new one",
        {"isValidElementRequest": True, "isElementSupported": True},
        before=find,
        after=clear,
        checks=_CONFIRMED,
        verify=_check_elements(UID),
    ),
    Stimulus(
        "SetElement",
        lambda explorer: upload(content(explorer), previous=UNKNOWN_ID),
        "after an unknown one",
        {"isValidElementRequest": False},
        before=find,
        checks=_REJECTED,
        verify=_check_elements(),
    ),
    Stimulus(
        "SetElement",
        lambda _: upload(UNKNOWN),
        "an unknown message",
        {"isValidElementRequest": True, "isElementSupported": False},
        before=find,
        checks=_REJECTED,
        verify=_check_elements(),
    ),
    Stimulus(
        "DeleteElement",
        lambda _: delete(UID),
        "one that is there",
        {"elementExists": True},
        before=hold,
        after=clear,
        checks=_CONFIRMED,
        verify=_check_elements(),
        by_controller=True,
    ),
    Stimulus(
        "DeleteElement",
        lambda _: delete(UNKNOWN_ID),
        "an unknown one",
        {"elementExists": False},
        checks=_REJECTED,
    ),
    Stimulus(
        "QueryElement",
        lambda _: QueryElement(UID),
        "one that is there",
        {"elementExists": True},
        before=hold,
        after=clear,
        checks={"ReportElement": has(element_uid=UID, previous_uid=0, next_uid=0)},
        by_controller=True,
    ),
    Stimulus(
        "QueryElement",
        lambda _: QueryElement(UID),
        "one that was left",
        before=_set_before_release,
        after=_removed,
        once=True,
    ),
    Stimulus("QueryElement", lambda _: QueryElement(UNKNOWN_ID), "an unknown one", {"elementExists": False}),
)
