"""Arms that have met something by their own detection: the services end the command, and report each contact once."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from types import SimpleNamespace

import pytest
from tests.services.manipulator.arms import arm_of

from jauspy.platform.joints import JointContact
from jauspy.services.manipulator.arm import Arm, ArmDriver


class Driver(ArmDriver):
    """A service that moves joints; its commands end when another one begins, or the arm stops."""

    def __init__(self, arm: Arm) -> None:
        super().__init__(arm)
        self.counted: Counter[str] = Counter()
        self.host = SimpleNamespace(id="101.1.10", count=self._count, now=0.0)
        self.ended = 0

    def _count(self, name: str, text: str) -> None:
        self.counted[name] += 1
        self.text = text

    def on_preempted(self) -> None:
        self.ended += 1


@pytest.fixture
def arm(monkeypatch: pytest.MonkeyPatch) -> Arm:
    made = arm_of("inc1")
    state = type(made.joints).state
    made.met = None
    monkeypatch.setattr(type(made.joints), "state", lambda self: replace(state(self), contact=made.met))
    return made


def meet(arm: Arm, number: int, *, gives_way: bool = False) -> None:
    name = arm.joints.joints[1].name
    arm.met = JointContact(number, {name: -41.4}, gives_way=gives_way)


def test_a_command_to_positions_ends_with_effort_and_way(arm: Arm, caplog: pytest.LogCaptureFixture) -> None:
    driver, goal = Driver(arm), [position + 0.07 for position in arm.state().positions]
    arm.to_positions(driver, goal)
    assert not driver.stops_if_blocked(arm.watch(), goal)
    meet(arm, 1)
    assert driver.stops_if_blocked(arm.watch(), goal)
    name = arm.joints.joints[1].name
    assert [str(found) for found in arm.blocked] == [f"{name}, 41 N m, 0.07 rad short"]
    assert (driver.ended, driver.is_moving, driver.counted) == (1, False, {"blocked": 1})
    assert f"101.1.10: blocked: {name}, 41 N m, 0.07 rad short; the arm holds" in caplog.text
    assert not driver.stops_if_touched(), "it is reported once"


def test_a_velocity_has_no_way_left(arm: Arm, caplog: pytest.LogCaptureFixture) -> None:
    driver = Driver(arm)
    arm.at_velocities(driver, [0.1] * len(arm.joints.joints))
    meet(arm, 1, gives_way=True)
    assert driver.stops_if_touched()
    assert driver.text == f"{arm.joints.joints[1].name}, 41 N m"
    assert "; the arm gives way" in caplog.text


def test_a_contact_before_the_next_command_is_not_lost_and_does_not_end_that(arm: Arm) -> None:
    driver = Driver(arm)
    for number in (1, 2, 3):
        arm.at_velocities(driver, [0.1] * len(arm.joints.joints))
        meet(arm, number)
    arm.at_velocities(driver, [0.1] * len(arm.joints.joints))
    assert driver.counted == {"blocked": 3}
    assert driver.is_moving
    assert arm.blocked == ()
    assert not driver.stops_if_touched()


def test_a_contact_after_the_last_look_is_noticed_when_it_is_asked_for(arm: Arm) -> None:
    """A joint may meet something at the very end of its motion, when the service has done its command."""
    driver = Driver(arm)
    arm.notice_contact()
    arm.to_positions(driver, arm.state().positions)
    arm.notice_contact()
    assert arm.blocked == ()
    meet(arm, 1)
    arm.notice_contact()
    assert [str(found) for found in arm.blocked] == [f"{arm.joints.joints[1].name}, 41 N m"]
    arm.notice_contact()
    assert driver.counted == {"blocked": 1}


def test_a_contact_that_nobody_commanded_is_none_of_the_next_command(arm: Arm) -> None:
    driver = Driver(arm)
    meet(arm, 1)
    arm.at_velocities(driver, [0.1] * len(arm.joints.joints))
    assert not driver.stops_if_touched()
    assert driver.is_moving
