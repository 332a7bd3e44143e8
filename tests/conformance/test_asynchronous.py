"""Components whose services notify each other with delay pass; what is wrong with them is still found."""

from __future__ import annotations

import pytest
from tests.conformance.asynchronous import asynchronous
from tests.conformance.simulated import examined, robot

from jauspy.ids import JausID

COMPONENT = JausID(105, 1, 1)


@pytest.mark.parametrize("seed", [pytest.param(seed, marks=[pytest.mark.slow] if seed else []) for seed in range(20)])
def test_component_that_answers_late_in_any_order_causes_no_alarm(seed: int) -> None:
    report = examined("core-1.1", robot(asynchronous(seed), timeout=5, component=1, tick=None), COMPONENT)
    assert [(each.id, each.reason) for each in report.failures] == []
    assert report.status == 0
    skipped = [each.id for each in report.results if "cannot be brought" in each.reason]
    assert skipped == []
