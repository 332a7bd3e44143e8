"""Profiles made from JSIDL: our robots pass them, take the transitions, and no check is there in vain.

In each kind of step some kind of mistake trips each check. A kind of step is an input from a role in one variant; the
states in which it is tried are not told apart.
"""

from __future__ import annotations

import logging
import re
from contextlib import ExitStack

import pytest
from tests.conformance.families import FAMILIES, armed
from tests.conformance.injectors import Injector
from tests.conformance.simulated import examined, robot
from tests.conformance.test_faults import checks
from tests.helpers.sampling import sampled

from jauspy.conformance import Report, Verdict
from jauspy.ids import JausID

IGVC = "igvc 105.1.1"
MODULES = {
    "core-1.1": (IGVC,),
    "mobility-1.1": (IGVC,),
    "ugv-1.0": (IGVC,),
    "manipulator-2.0": ("inc1 101.1.104", "inc1 101.1.105", "inc1 101.1.103", "inc1 101.1.107", "inc1_pprm 102.1.107"),
    "sensing-2.0": ("inc1 101.1.106", "inc1 101.1.107", "inc1 101.1.108"),
}
INSIDE = "is raised by the component itself"
SHADOWED = "an inner state handles it first"
UNKNOWN = "of which this holds"
OTHERWISE = "it depends on internal state of the target"
READY = "Receiving.Ready"
FREE, HELD = f"{READY}.NotControlled", f"{READY}.Controlled"
CAMERA = {
    f"DigitalVideo, {HELD}: ControlDigitalVideoSensorRecording "
    "[isControllingClient(transportData) && isSupported(msg)]": OTHERWISE,
    f"StillImage, {HELD}: QueryStillImageDataExt [isCoordinateTransformSupported(msg)]": UNKNOWN,
    f"StillImage, {FREE}: QueryStillImageDataExt [isCoordinateTransformSupported(msg)]": UNKNOWN,
}
LEFT = {
    ("core-1.1", IGVC): {
        f"Management, {HELD}: Failure": INSIDE,
        f"Management, {HELD}.NotAvailable.Emergency: Failure": INSIDE,
        f"Management, {FREE}: Failure": INSIDE,
        f"Management, {FREE}.NotAvailable.Emergency: Failure": INSIDE,
        f"Management, {FREE}.NotAvailable.Emergency: Timedout": INSIDE,
        f"Events, {READY}: EventError [eventExists()]": INSIDE,
        f"AccessControl, {HELD}.NotAvailable: RequestControl": SHADOWED,
        f"AccessControl, {HELD}.NotAvailable: ReleaseControl": SHADOWED,
        f"AccessControl, {HELD}.NotAvailable: Timedout": SHADOWED,
    },
    ("manipulator-2.0", "inc1 101.1.104"): {
        f"ManipulatorJointPositionListDriver, {FREE}: QueryCommandedJointPositions [targetExists()]": UNKNOWN,
    },
    ("ugv-1.0", IGVC): {
        f"IlluminationService, {HELD}: SetIlluminationState "
        "[isControllingClient(transportData) && isSupported(msg)]": OTHERWISE,
    },
    ("sensing-2.0", "inc1 101.1.106"): CAMERA,
    ("sensing-2.0", "inc1 101.1.107"): CAMERA,
    ("sensing-2.0", "inc1 101.1.108"): {
        f"RangeSensor, {state}: QueryRangeSensor{data} [{guard}isCoordinateTranformSupported({argument})]": OTHERWISE
        for state in (FREE, HELD)
        for data in ("Data", "CompressedData")
        for guard, argument in (("", "" if (state, data) == (HELD, "Data") else "msg"), ("!", "msg"))
    },
}
"""Transitions of our robots that no run takes, and why. In an emergency nobody is in control who could time out.
Whether a range sensor transforms coordinates makes no difference to what it sends."""


@pytest.fixture(autouse=True)
def _quiet_logs(caplog: pytest.LogCaptureFixture) -> None:
    """Some mistakes are bugs of actions, which the robot logs."""
    caplog.set_level(logging.CRITICAL, logger="jauspy")


def run_of(profile: str, module: str, only: tuple[str, ...] = (), inject: Injector | None = None) -> Report:
    """A run against a robot, whole or broken, whose body stands still."""
    name, id = module.split()
    target = JausID.parse(id)
    with ExitStack() as stack:
        parts = ()
        if inject is not None:
            *parts, patches = inject()
            for each in (armed(), *patches):
                stack.enter_context(each)
        body = robot(*parts, name=name, timeout=5, component=target.component, tick=None)
        return examined(profile, body, target, only=only)


def kind(step: str, check: str) -> tuple[str, str]:
    """The step without its state, and the check without one."""
    return step.partition("/")[2], re.sub("^the state is .*", "the state is", check)


def kinds(report: Report) -> dict[tuple[str, str], str]:
    """Each kind of check, and the first step that has it."""
    order = {result.id: number for number, result in enumerate(report.results)}
    found: dict[tuple[str, str], str] = {}
    for step, check in sorted(checks(report), key=lambda pair: (order[pair[0]], pair[1])):
        found.setdefault(kind(step, check), step)
    return found


@pytest.mark.slow
@pytest.mark.parametrize(
    ("profile", "module"),
    sampled([(profile, each) for profile in MODULES for each in MODULES[profile]], fast=4, several=True),
)
def test_our_robots_pass(profile, module):
    passes(profile, module, run_of(profile, module))


@pytest.mark.slow
@pytest.mark.timeout(300)
@pytest.mark.parametrize(
    "profile",
    [pytest.param(profile, marks=pytest.mark.long if number % 3 else []) for number, profile in enumerate(MODULES)],
)
def test_every_kind_of_check_can_fail(profile):
    known: set[tuple[str, str]] = set()
    for module in MODULES[profile]:
        wanted = {check: step for check, step in kinds(run_of(profile, module)).items() if check not in known}
        known |= wanted.keys()
        for family in FAMILIES:
            only = tuple(sorted({step for (_, check), step in wanted.items() if re.search(family.trips, check)}))
            if only:
                for step, check in checks(run_of(profile, module, only, family.inject), failed=True):
                    wanted.pop(kind(step, check), None)
        assert sorted(wanted) == [], f"no mistake trips these checks of {module}"
    assert len(known) > 20


def passes(profile: str, module: str, report: Report) -> None:
    """Nothing fails, and what is not tried has a reason."""
    assert [f"{each.id}: {each.reason}" for each in report.failures] == []
    assert report.status == 0
    assert report.counts[Verdict.PASS] > 10
    target = module.split()[1]
    left = {each.name.removeprefix(f"{target} "): each.reason for each in report.transitions if not each.step}
    known = LEFT.get((profile, module), {})
    assert left.keys() == known.keys()
    assert [each for each, reason in left.items() if known[each] not in reason] == []
    reasons = {each.reason for each in report.results if each.verdict is Verdict.SKIPPED}
    fine = (INSIDE, SHADOWED, UNKNOWN, "would end the component")
    assert [each for each in reasons if not any(part in each for part in fine)] == []
