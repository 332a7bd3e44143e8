"""Components whose services notify each other with delay pass; what is wrong with them is still found."""

from __future__ import annotations

import pytest
from tests.conformance.asynchronous import asynchronous
from tests.conformance.simulated import examined, robot

from jauspy.conformance import TargetComponent
from jauspy.ids import JausID
from jauspy.messages.core import RequestControl, Standby

COMPONENT = JausID(105, 1, 1)


@pytest.mark.slow
@pytest.mark.parametrize("seed", [pytest.param(seed, marks=[pytest.mark.slow] if seed else []) for seed in range(4)])
def test_component_that_answers_late_in_any_order_causes_no_alarm(seed: int) -> None:
    report = examined("core-1.1", robot(asynchronous(seed), timeout=5, component=1, tick=None), COMPONENT)
    assert [(each.id, each.reason) for each in report.failures] == []
    assert report.status == 0
    assert not [each.id for each in report.results if "cannot be brought" in each.reason]
    assert any("notify each other with delay" in note for note in report.notes)


@pytest.mark.slow
def test_what_is_wrong_with_such_a_component_is_found() -> None:
    class Wrong(asynchronous(1)):
        """Standby does not end Ready."""

        def receive(self, payload: bytes, source: JausID, now: float) -> None:
            if payload != Standby().encode():
                super().receive(payload, source, now)

    only = ("table/Management/", "Controlled.Available.Ready/Standby/controller")
    report = examined("core-1.1", robot(Wrong, timeout=5, component=1, tick=None), COMPONENT, only=only)
    assert {each.id for each in report.failures} == {
        "table/Management/Controlled.Ready/Standby/controller",
        "Controlled.Available.Ready/Standby/controller",
    }


@pytest.mark.slow
def test_message_that_is_unanswered_in_one_state_is_still_sent_in_others() -> None:
    """RequestControl is not answered in an emergency."""

    class Silent(TargetComponent):
        def receive(self, payload: bytes, source: JausID, now: float) -> None:
            in_emergency = "Emergency" in self.host.path
            if not (in_emergency and payload[:2] == RequestControl.CODE.to_bytes(2, "little")):
                super().receive(payload, source, now)

    report = examined("core-1.1", robot(Silent, timeout=5, component=1, tick=None), COMPONENT)
    asked = [each for each in report.results if "/RequestControl/" in each.id]
    skipped = {each.id for each in asked if "not sent again" in each.reason}
    assert skipped
    assert all("Emergency" in each for each in skipped)
    assert {each.id for each in report.failures if "Emergency" not in each.id} == set()
