"""No check that is made from JSIDL is there in vain: in each step some kind of mistake trips it."""

from __future__ import annotations

import logging
import re

import pytest
from tests.conformance.families import FAMILIES, armed
from tests.conformance.injectors import Injector
from tests.conformance.simulated import examined, robot
from tests.conformance.test_faults import checks

from jauspy.conformance import Report
from jauspy.ids import JausID


@pytest.fixture(autouse=True)
def _quiet_logs(caplog: pytest.LogCaptureFixture) -> None:
    """Some mistakes are bugs of actions, which the robot logs."""
    caplog.set_level(logging.CRITICAL, logger="jauspy")


def broken(profile: str, name: str, target: str, inject: Injector, only: tuple[str, ...]) -> Report:
    from contextlib import ExitStack

    part, bench, patches = inject()
    with ExitStack() as stack:
        for each in (armed(), *patches):
            stack.enter_context(each)
        return examined(profile, robot(part, bench, name=name, timeout=5, tick=None), JausID.parse(target), only=only)


@pytest.mark.parametrize(
    ("profile", "module"),
    [
        ("core-1.1", "igvc 105.1.1"),
        ("mobility-1.1", "igvc 105.1.1"),
        ("ugv-1.0", "igvc 105.1.1"),
        ("manipulator-2.0", "inc1 101.1.104"),
        ("sensing-2.0", "inc1 101.1.106"),
    ],
)
def test_every_check_of_every_step_is_tripped(profile, module):
    name, target = module.split()
    unseen = checks(examined(profile, robot(name=name, timeout=5, tick=None), JausID.parse(target)))
    assert len(unseen) > 60
    for family in FAMILIES:
        left = tuple(sorted({step for step, check in unseen if re.search(family.trips, check)}))
        if left:
            only = () if family.whole else left
            unseen -= checks(broken(profile, name, target, family.inject, only), failed=True)
    assert sorted(unseen) == [], "no mistake trips these checks"
