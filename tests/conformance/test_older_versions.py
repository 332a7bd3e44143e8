"""A robot that offers version 1.0 of its services beside the newer ones passes the conformance test of both."""

from __future__ import annotations

import pytest
from tests.conformance import simulated

from jauspy.conformance import Report, Verdict
from jauspy.ids import JausID
from jauspy.robot import robot_files
from jauspy.schema.loader import load_builtin

MODULES = [
    ("core-1.1", "101.1.102"),
    ("mobility-1.1", "101.1.102"),
    ("manipulator-2.0", "101.1.103"),
    ("manipulator-2.0", "101.1.104"),
    ("manipulator-2.0", "101.1.105"),
    ("manipulator-2.0", "101.1.107"),
    ("sensing-2.0", "101.1.106"),
    ("sensing-2.0", "101.1.107"),
    ("sensing-2.0", "101.1.109"),
]
QUICK = [("manipulator-2.0", "101.1.105"), ("sensing-2.0", "101.1.106")]
CAMERA = ("VisualSensor", "DigitalVideo", "StillImage")


def run_of(profile: str, id: str, monkeypatch: pytest.MonkeyPatch) -> Report:
    config = robot_files.load("inc1")
    modules = tuple(each.model_copy(update={"older_versions": True}) for each in config.modules)
    config = config.model_copy(update={"modules": modules})
    monkeypatch.setattr(robot_files, "load", lambda _: config)
    target = JausID.parse(id)
    body = simulated.robot(name="inc1", timeout=5, component=target.component, tick=None)
    return simulated.examined(profile, body, target)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("profile", "id"),
    [pytest.param(*each, marks=() if each in QUICK else pytest.mark.slow) for each in MODULES],
)
def test_both_versions_pass(profile: str, id: str, monkeypatch: pytest.MonkeyPatch) -> None:
    report = run_of(profile, id, monkeypatch)
    failed = [each.id for each in report.results if each.verdict not in (Verdict.PASS, Verdict.SKIPPED)]
    assert failed == []
    passed = [each.id for each in report.results if each.verdict is Verdict.PASS]
    older = [id for id in passed if id.startswith("1.0/")]
    assert len(older) > 20
    if profile == "sensing-2.0":
        services = [load_builtin().service(f"urn:jaus:jss:environmentSensing:{name}", "1.0") for name in CAMERA]
        inputs = {message.name for service in services for message in service.inputs}
        assert {id.split("/")[2] for id in older} == inputs
    assert len(passed) - len(older) > 20
