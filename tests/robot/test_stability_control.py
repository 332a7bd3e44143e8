"""StabilityControl of a CM-MOB: switched by the client in control, and told when the robot is near to tipping over."""

from __future__ import annotations

from dataclasses import fields

import pytest
from tests.robot.workcell import CLIENT, OTHER, Workcell

from jauspy.geometry.vectors import GRAVITY
from jauspy.messages.iop import (
    QueryStabilityControlCapabilities,
    QueryStabilityControlStatus,
    SetStabilityControlStatus,
)
from jauspy.platform.force_torque import Wrench
from jauspy.robot.config import ModuleConfig
from jauspy.robot.kinds.health_checks import _check_stability
from jauspy.services.iop import StabilityControl

KIND = SetStabilityControlStatus.StabilityControlStatus
NAMES = tuple(field.name for field in fields(KIND))
AIDS = {"active_pitchover_control", "active_rollover_control"}


@pytest.fixture
def mobility():
    made = Workcell("kinematic", "inc1", 102)
    yield made
    made.robot.close()


def setting(**bits: int) -> SetStabilityControlStatus:
    return SetStabilityControlStatus(KIND(**(dict.fromkeys(NAMES, 0) | bits)))


def switched_on(cell: Workcell) -> set[str]:
    status = cell.ask(QueryStabilityControlStatus()).stability_control_status
    return {name for name in NAMES if getattr(status, name)}


def test_both_aids_exist_and_are_on(mobility):
    found = mobility.ask(QueryStabilityControlCapabilities()).stability_control_status
    assert {name for name in NAMES if getattr(found, name)} == AIDS
    assert switched_on(mobility) == AIDS


def test_only_the_client_in_control_switches_them(mobility):
    mobility.tell(setting())
    assert switched_on(mobility) == AIDS
    mobility.take_control()
    mobility.tell(setting(), client=OTHER)
    assert switched_on(mobility) == AIDS
    mobility.tell(setting(active_rollover_control=1))
    assert switched_on(mobility) == {"active_rollover_control"}
    mobility.tell(setting())
    assert switched_on(mobility) == set()
    mobility.tell(setting(active_rollover_control=1, active_pitchover_control=1))
    assert switched_on(mobility) == AIDS


@pytest.mark.parametrize("name", [name for name in NAMES if name not in AIDS and not name.startswith("reserved")])
def test_aids_that_are_missing_are_not_switched(mobility, name):
    mobility.take_control()
    mobility.tell(setting(**{name: 1}))
    assert switched_on(mobility) == AIDS
    assert mobility.host.counters["missing_aid"] == 1


@pytest.mark.parametrize("word", [0x0F00, 0x0FC0, 0xFFFF, 0x8000])
def test_any_word_is_taken_without_an_error(mobility, word):
    mobility.take_control()
    body = SetStabilityControlStatus(KIND(**dict.fromkeys(NAMES, 0))).encode()
    mobility.host.receive(body[:-2] + word.to_bytes(2, "little"), CLIENT, mobility.now)
    assert mobility.host.first_error is None
    assert switched_on(mobility) == (AIDS if word in (0x0FC0, 0xFFFF, 0x8000) else set())


def test_a_robot_that_is_near_to_tipping_is_told(mobility, monkeypatch):
    """The gripper holds 60 kg in front of it."""
    stability = mobility.host.service(StabilityControl)._stability
    module = ModuleConfig(type="CM-MOB", component=102)
    (entry,) = _check_stability(stability, module)
    assert entry.severity == 0
    sensor = mobility.robot.force_torque["wrist"]
    frames = stability._model.frames({"base_link_to_flippers": 2.2})
    down = frames["gripper_link"].inverse().rotate((0.0, 0.0, -GRAVITY * 90.0))
    monkeypatch.setattr(sensor, "wrench", Wrench(1.0, down))
    monkeypatch.setattr(stability._model, "frames", lambda _: frames)
    (entry,) = _check_stability(stability, module)
    assert entry.severity == 2
    assert "from tipping forward with" in entry.text
