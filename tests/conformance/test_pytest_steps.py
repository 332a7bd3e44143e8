"""Steps as tests: these are real tests, and a broken component makes one fail."""

from __future__ import annotations

from datetime import UTC, datetime

import pytest
from tests.conformance.scripted import ScriptedLink
from tests.conformance.simulated import robot
from tests.conformance.test_endings import is_free

from jauspy.conformance import Profile, Step, TargetComponent, VirtualTarget, ask, offers_of, pytest_steps, tell
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages.core import (
    ConfirmControl,
    QueryStatus,
    ReportStatus,
    RequestControl,
    Standby,
)
from jauspy.services.core import Liveness
from jauspy.services.host import Host


@pytest_steps("transport", robot, "105.1.255")
def test_transport(step):
    step()


def small():
    """A component with few services, and so with few steps."""
    return VirtualTarget(
        [TargetComponent(Host(JausID(105, 1, 1), [Liveness()], utc_now=lambda: datetime(2026, 1, 1, tzinfo=UTC)))]
    )


@pytest_steps("core-1.1", small, "105.1.1", offers=offers_of(small()))
def test_core(step):
    step()


class Mute(TargetComponent):
    def receive(self, payload, source, now):
        pass


def test_failures_and_skips_are_pytest_outcomes():
    marked = pytest_steps("transport", lambda: robot(part=Mute), "105.1.255")
    steps = {param.id: param.values[0] for param in marked.args[1]}
    with pytest.raises(pytest.fail.Exception, match="silent: none of QueryEvents"):
        steps["query"]()
    with pytest.raises(pytest.skip.Exception, match="the target answers no query"):
        steps["ack"]()


def test_offers_are_required_for_generated_steps():
    with pytest.raises(ConfigError, match="pass them as offers="):
        pytest_steps("core-1.1", robot, "105.1.1")


COP = "42.1.1"
STATUS = ask(COP, QueryStatus(), ReportStatus)
QUIET = tell(COP, Standby())


def calls_of(profile, link, target="105.1.1"):
    marked = pytest_steps(profile, lambda: link, target)
    return [param.values[0] for param in marked.args[1]]


def test_steps_that_expect_silence_fail_if_the_target_is_dead():
    alive = [[(0.01, bytes.fromhex("02400100000000"))]]
    link = ScriptedLink("105.1.1", lambda _: alive.pop() if alive else [])
    profile = Profile("p", "t", tuple(Step(str(n), "s", run) for n, run in enumerate((STATUS, STATUS, QUIET))))
    first, second, third = calls_of(profile, link)
    first()
    for test in (second, third):
        with pytest.raises(pytest.fail.Exception, match="silent: "):
            test()


def test_robot_is_restored_after_the_last_step(monkeypatch):
    virtual_target = robot(tick=None)
    closed = []
    monkeypatch.setattr(virtual_target, "close", lambda: closed.append(True))
    steps = (Step("1", "s", ask(COP, RequestControl(200), ConfirmControl)), Step("2", "s", STATUS))
    for test in calls_of(Profile("p", "t", steps), virtual_target):
        test()
    assert closed == [True]
    assert is_free(virtual_target, JausID(105, 1, 1))


def test_steps_can_be_called_in_any_order_and_repeatedly():
    first, second = calls_of(Profile("p", "t", (Step("1", "s", STATUS), Step("2", "s", STATUS))), robot(tick=None))
    second()
    first()
    second()
