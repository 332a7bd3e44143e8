"""The modules of inc1 that have drives conform on simulated servo drives as they do without."""

from __future__ import annotations

import pytest
from tests.conformance.simulated import examined, robot

pytest.importorskip("canopen", reason="canopen is not installed")

from jauspy.conformance import Verdict
from jauspy.ids import JausID
from jauspy.robot import robot_files

DRIVEN = ("CM-MOB", "CM-MAN", "CM-EEF")
"""Types of modules that move drives; the others are the same on every backend."""
PROFILES = ("core-1.1", "mobility-1.1", "manipulator-2.0", "sensing-2.0", "ugv-1.0")


@pytest.mark.slow
@pytest.mark.timeout(900)
@pytest.mark.parametrize(
    "component",
    [
        pytest.param(module.component, marks=[] if module.type == "CM-EEF" else pytest.mark.long)
        for module in robot_files.load("inc1").modules
        if module.type in DRIVEN
    ],
)
def test_every_module_conforms(component: int) -> None:
    steps = 0
    for profile in PROFILES:
        target = robot(name="inc1", component=component, backend="can", timeout=5)
        report = examined(profile, target, JausID(101, 1, component))
        wrong = {step.id: step for step in report.results if step.verdict not in {Verdict.PASS, Verdict.SKIPPED}}
        assert not wrong, profile
        steps += len(report.results)
    assert steps > 100
