"""Steps 20 to 48: access control and management."""

from __future__ import annotations

from jauspy.conformance.checks import Check, has, that
from jauspy.conformance.profile import Action, ask
from jauspy.conformance.profiles.igvc_2015.judge import (
    ACCEPTED,
    C1,
    C3,
    RELEASED,
)
from jauspy.conformance.tester import Tester
from jauspy.messages.core import (
    ConfirmControl,
    QueryStatus,
    RejectControl,
    ReleaseControl,
    ReportStatus,
    RequestControl,
    Reset,
)


def in_control(client: str | None, authority: int = 0) -> tuple[Check, ...]:
    """The fields of ReportControl; nobody is all zero."""
    subsystem, node, component = map(int, client.split(".")) if client else (0, 0, 0)
    return has(subsystem_id=subsystem, node_id=node, component_id=component, authority_code=authority)


def control(client: str, authority: int, *codes: ConfirmControl.ResponseCode) -> Action:
    """A request for control, and the codes that are right."""
    names = " or ".join(code.name for code in codes)
    right = that(f"says {names}", lambda answer: answer.response_code in codes)
    return ask(client, RequestControl(authority), ConfirmControl, right)


def release(client: str) -> Action:
    """Control is given up."""
    return ask(client, ReleaseControl(), RejectControl, has(response_code=RELEASED))


def status(*right: ReportStatus.Status) -> Action:
    """One of these."""
    names = " or ".join(each.name for each in right)
    return ask(C1, QueryStatus(), ReportStatus, that(f"says {names}", lambda answer: answer.status in right))


def preempt(tester: Tester) -> None:
    """Step 29: a client with more authority takes over, and the loser is told."""
    loser = tester.client(C1)
    tester.client(C3).ask(RequestControl(0xE7), ConfirmControl, has(response_code=ACCEPTED))
    loser.expect(RejectControl, has(response_code=RELEASED))


def reset(tester: Tester) -> None:
    """Step 42: control ends with it (AS5710), and the client may be told."""
    tester.client(C1).send(Reset())
    tester.client(C1).silence(besides=(RejectControl,))
