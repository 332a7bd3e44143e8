"""Steps as tests: these are real tests, and a broken component makes one fail."""

from __future__ import annotations

import pytest
from tests.conformance.simulated import robot

from jauspy.conformance import Part, offers_of, pytest_steps
from jauspy.errors import ConfigError


@pytest_steps("transport", robot, "105.1.255")
def test_transport(step):
    step()


@pytest_steps("core-1.1", lambda: robot(timeout=5), "105.1.1", offers=offers_of(robot()))
def test_core(step):
    step()


class Mute(Part):
    def hear(self, payload, source, now):
        pass


def test_failures_and_skips_are_those_of_pytest():
    marked = pytest_steps("transport", lambda: robot(part=Mute), "105.1.255")
    steps = {param.id: param.values[0] for param in marked.args[1]}
    with pytest.raises(pytest.fail.Exception, match="silent: none of QueryEvents"):
        steps["query"]()
    with pytest.raises(pytest.skip.Exception, match="the target answers no query"):
        steps["ack"]()


def test_what_a_target_offers_must_be_known():
    with pytest.raises(ConfigError, match="say it with offers="):
        pytest_steps("core-1.1", robot, "105.1.1")
