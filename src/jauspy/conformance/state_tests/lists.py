"""The inputs of ListManager, and what its list must hold afterwards."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from jauspy.codec.message import Message
from jauspy.conformance.checks import has, that
from jauspy.conformance.results import Failed, Skipped
from jauspy.conformance.state_tests.events import CREATE, UNKNOWN_ID
from jauspy.conformance.state_tests.explorer import Explorer, Stimulus, StimulusResult
from jauspy.conformance.state_tests.sample_messages import neutral
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
"""Of the element that the test keeps in the list."""
ALL: Final = 65535
"""Deletes the whole list (AS5710)."""
UNKNOWN: Final = bytes.fromhex("ffee")
"""A message that no list takes: nobody has defined it."""
CANDIDATES: Final = (
    "SetLocalWaypoint",
    "SetGlobalWaypoint",
    "SetLocalPathSegment",
    "SetGlobalPathSegment",
    "SetJointPositions",
    "SetEndEffectorPose",
    "Standby",
)
"""Commands that lists are made of; which ones a component takes only it knows."""
COUNT: Final = "elements before"


WAYPOINT_LIST: Final = "WaypointListDriver"
"""How the URNs end of the drivers whose lists must take a waypoint, whatever it says."""


def upload(content: Message | bytes, uid: int = UID, previous: int = 0) -> SetElement:
    """One element, alone or behind another one."""
    data = ElementRec.ElementData(0, content)
    return SetElement(SetElement.RequestIDRec(CREATE), [ElementRec(uid, previous, 0, data)])


def delete(uid: int) -> DeleteElement:
    """Without one element, or without all."""
    return DeleteElement(DeleteElement.RequestIDRec(CREATE), [DeleteElement.DeleteElementRec(uid)])


def _content_of(explorer: Explorer) -> str:
    return f"content of the list of {explorer.component}"


def content(explorer: Explorer) -> Message:
    """What this component's list takes, once that is known."""
    found: Message = explorer.tester.memory.get(_content_of(explorer), Standby())
    return found


def clear(explorer: Explorer, role: str) -> None:
    """An empty list, as far as the sender may do that."""
    if role == CONTROLLER:
        for uid in (UID, ALL):
            explorer.client(role).send(delete(uid), to=explorer.component)
        explorer.observe()


def find(explorer: Explorer, role: str) -> None:
    """An empty list, and content that it takes; those who are not in control send anything."""
    clear(explorer, role)
    if role == CONTROLLER and _content_of(explorer) not in explorer.tester.memory:
        taken = (each for each in map(_harmless, CANDIDATES) if _is_taken(explorer, each))
        found = next(taken, None)
        if found is None:
            must = any(each.endswith(WAYPOINT_LIST) for each in explorer.services)
            raise (Failed if must else Skipped)(f"the list takes none of {', '.join(CANDIDATES)}")
        explorer.tester.memory[_content_of(explorer)] = found
        clear(explorer, role)
    _count(explorer, role)


def _harmless(name: str) -> Message:
    return neutral(registry.by_name(name))


def _is_taken(explorer: Explorer, candidate: Message) -> bool:
    client, answers = explorer.client(CONTROLLER), (ConfirmElementRequest.CODE, RejectElementRequest.CODE)
    client.pending.clear()
    client.send(upload(candidate), to=explorer.component)
    end = explorer.tester.now + explorer.tester.timeout
    explorer.tester.pump(end, lambda: any(each.code in answers for each in client.pending))
    return any(each.code == ConfirmElementRequest.CODE for each in client.pending)


def hold(explorer: Explorer, role: str) -> None:
    """The list has one element."""
    find(explorer, role)
    client = explorer.client(role)
    client.ask(upload(content(explorer)), ConfirmElementRequest, has(request_id=CREATE), to=explorer.component)


def _left_behind(explorer: Explorer, role: str) -> None:  # noqa: ARG001 - a Prepare
    """By a client that has gone since; whether it stays, the component decides."""
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


def _leaves(*uids: int) -> Callable[[StimulusResult], None]:
    """What the list holds when the one in control has sent this; others change nothing."""

    def verify(then: StimulusResult) -> None:
        explorer = then.explorer
        observer, mine = explorer.client(OBSERVER), then.role == CONTROLLER
        if not mine:
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
        verify=_leaves(UID),
    ),
    Stimulus(
        "SetElement",
        lambda explorer: upload(content(explorer), previous=UNKNOWN_ID),
        "after an unknown one",
        {"isValidElementRequest": False},
        before=find,
        checks=_REJECTED,
        verify=_leaves(),
    ),
    Stimulus(
        "SetElement",
        lambda _: upload(UNKNOWN),
        "an unknown message",
        {"isValidElementRequest": True, "isElementSupported": False},
        before=find,
        checks=_REJECTED,
        verify=_leaves(),
    ),
    Stimulus(
        "DeleteElement",
        lambda _: delete(UID),
        "one that is there",
        {"elementExists": True},
        before=hold,
        after=clear,
        checks=_CONFIRMED,
        verify=_leaves(),
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
        "QueryElement", lambda _: QueryElement(UID), "one that was left", before=_left_behind, after=_removed, once=True
    ),
    Stimulus("QueryElement", lambda _: QueryElement(UNKNOWN_ID), "an unknown one", {"elementExists": False}),
)
