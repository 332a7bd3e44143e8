"""Broken robots are caught by name, and no check of a sender-written profile is there in vain."""

from __future__ import annotations

import logging
import re
from collections import Counter
from collections.abc import Iterable

import pytest
from tests.conformance import faults
from tests.conformance.faults import HAND_WRITTEN
from tests.conformance.injectors import Fault
from tests.conformance.simulated import examined, robot

from jauspy.conformance import Report, TargetComponent, VirtualTarget

MEASURED = re.compile(r"has (x|y|event_id|propulsive_linear_effort_x|left_side_propulsive_effort) \S+")
"""Names of checks that have what the robot said in them."""
SAMPLE = 8
"""One fault in so many is tried in the fast run; the slow one tries all."""


@pytest.fixture(autouse=True)
def _quiet_logs(caplog: pytest.LogCaptureFixture) -> None:
    """Some faults are bugs of actions, which the robot logs; the level is put back after the test."""
    caplog.set_level(logging.CRITICAL, logger="jauspy")


def checks(report: Report, *, failed: bool = False) -> set[tuple[str, str]]:
    """What the steps looked at, or what of it did not hold."""
    return {
        (result.id, MEASURED.sub(r"has \1", looked.name))
        for result in report.results
        for looked in result.checks
        if looked.problem or not failed
    }


def missed(fault: Fault, report: Report) -> str:
    """What a fault should have tripped, and has not."""
    caught = {result.id for result in report.failures}
    missing = sorted(set(fault.trips) - caught)
    nothing = not caught and not report.problem
    return f"{fault}: not caught by {missing or 'anything'}, but by {sorted(caught)}" if missing or nothing else ""


def named(profile: str) -> list[Fault]:
    """The faults of a profile that say which steps they trip, without those for which the robot has to drive."""
    return [fault for fault in HAND_WRITTEN[profile] if fault.trips and not fault.motion]


@pytest.mark.slow
@pytest.mark.parametrize("profile", HAND_WRITTEN)
def test_sampled_faults_are_detected(profile):
    assert list(filter(None, (missed(fault, fault.run()) for fault in named(profile)[::SAMPLE]))) == []


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.timeout(300)
@pytest.mark.parametrize("profile", HAND_WRITTEN)
def test_every_fault_is_detected_and_every_check_detects_one(profile):
    unseen = checks(examined(profile, robot()))
    assert len(unseen) > 50
    problems = []
    for fault in HAND_WRITTEN[profile]:
        report = fault.run()
        problems += filter(None, [missed(fault, report)])
        unseen -= checks(report, failed=True)
    assert problems == []
    assert sorted(unseen) == [], "no fault trips these checks"


@pytest.mark.slow
@pytest.mark.parametrize(
    "fault",
    [
        pytest.param(fault, id=str(fault), marks=() if number % SAMPLE == 0 else pytest.mark.slow)
        for number, fault in enumerate(faults.GENERATED)
    ],
)
def test_faults_in_state_machines_are_detected(fault):
    assert missed(fault, fault.run()) == ""


def test_fault_names_are_unique():
    names = Counter(map(str, faults.ALL))
    assert [name for name, count in names.items() if count > 1] == []
    named: Iterable[Fault] = (fault for fault in faults.ALL if fault.trips)
    assert len({fault.name for fault in named}) >= 25


@pytest.mark.slow
def test_robot_without_fault_passes():
    healthy = Fault("none", "igvc-2015", (), lambda: (TargetComponent, VirtualTarget, []), motion=True)
    report = healthy.run()
    assert report.failures == ()
    assert "not caught by anything" in missed(healthy, report)
