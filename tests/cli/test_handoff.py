"""`jauspy handoff`: one client asks, the one in control answers."""

from __future__ import annotations

import json

import pytest
from tests.helpers.command_line import jauspy, robot_in_thread, start, stopped

from jauspy import sync
from jauspy.errors import ControlRejected
from jauspy.services.iop.handoff import Decision, HandoffRequest

MASTER = "101.1.110"


@pytest.fixture(scope="module")
def robot():
    with robot_in_thread() as running:
        yield running


@pytest.mark.slow
@pytest.mark.parametrize("grants", [True, False])
def test_the_client_in_control_decides(robot, grants: bool):
    seen: list[HandoffRequest] = []

    def decide(_: object, request: HandoffRequest) -> Decision:
        seen.append(request)
        return Decision.GRANTED if grants else Decision.DENIED

    with (
        sync.OCU("42.1.1", robot.local, decide_handoff=decide) as ocu,
        ocu.robot(101).component(MASTER).service("EnhancedAccessControl").control(),
    ):
        where = ("--connect", robot.local, "--within", "10", "--json")
        result = jauspy("handoff", MASTER, "I see the door", *where, status=0 if grants else 1)
    (request,) = seen
    assert request.explanation == "I see the door"
    row = json.loads(result.stdout)
    assert row["granted"] is grants
    assert grants or "the client in control refused" in row["problem"]


@pytest.mark.slow
def test_a_verb_answers_those_who_ask(robot):
    answering = start("handoff", MASTER, "--answer", "refuse", "--connect", robot.local)
    with stopped(answering), sync.OCU("42.1.1", robot.local) as ocu:
        assert answering.stderr is not None
        assert "in control of 101.1.110" in answering.stderr.readline()
        with pytest.raises(ControlRejected, match="the client in control refused"):
            ocu.request_handoff(MASTER, "let me", within=10.0)
        assert answering.stdout is not None
        assert answering.stdout.readline() == "42.1.1 asks with authority 127: let me; answered: refuse\n"


def test_wrong_use_is_explained():
    assert "give either a REASON" in jauspy("handoff", MASTER, status=1).stderr
    assert "wildcards" in jauspy("handoff", "101.1.255", "x", status=1).stderr
