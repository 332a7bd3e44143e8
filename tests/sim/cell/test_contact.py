"""A modular arm that meets something in its way, in MuJoCo: contact forces and spring torques are the simulation's."""

import math
from dataclasses import dataclass

import mujoco
import numpy as np
import pytest

pytest.importorskip("pinocchio", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)
pytest.importorskip("ruckig", reason="the extra 'cell' is not installed")

from tests.helpers.cells import ARM, build_arm, small_cell

from jauspy.geometry.poses import Pose
from jauspy.platform.joints import ContactReaction
from jauspy.platform.modular import contact
from jauspy.platform.modular.arm import ModularArm, MotionResult
from jauspy.platform.modular.parts import Fixture, PartSolid, Shape
from jauspy_sim.assembly import TIMESTEP
from jauspy_sim.cell.robot import SimulatedCell

START, GOAL = (-0.7, 0.9, 0.9, 0.3, 0.0), (0.7, 0.9, 0.9, 0.3, 0.0)
POST = Fixture(
    "post",
    (PartSolid(Shape.CUBOID, (0.06, 0.06, 1.0), 1.0),),
    Pose(x=0.6 + 0.65 * math.cos(0.1), y=0.22 + 0.65 * math.sin(0.1), z=0.5),
)
"""It stands in the way of the arm, which turns about its vertical axis."""
TOUCHED = 1.0
"""Newtons from which on the arm touches the post."""
AFTER = 0.2
"""Seconds after the first touch at which forces must have fallen."""


@dataclass
class Meeting:
    """Seconds from the first touch to the arm's report, force in N, and torque of `servo_1` in N m."""

    delay: float = math.inf
    speed: float = 0.0
    later_force: float = math.nan
    peak_torque: float = 0.0
    later_torque: float = math.nan
    error: str = ""


def force_on_post(cell: SimulatedCell) -> float:
    data, total, row = cell.data, 0.0, np.zeros(6)
    post = cell.model.body(POST.name).id
    for number in range(data.ncon):
        if post in cell.model.geom_bodyid[data.contact[number].geom]:
            mujoco.mj_contactForce(cell.model, data, number, row)
            total += float(np.linalg.norm(row[:3]))
    return total


def meet(duration: float, reaction: ContactReaction = ContactReaction.STOP) -> Meeting:
    """Turn the arm against the post, and watch 0.5 s after the first touch."""
    cell = small_cell([*ARM, "platform_1"], contact=reaction, fixtures=(POST,))
    build_arm(cell)
    arm = ModularArm.of(cell)
    assert arm is not None
    arm.move(START, 2.0)
    cell.advance(3.0)
    assert arm.state().result is MotionResult.REACHED
    arm.move(GOAL, duration)
    servo, touched, found = cell.servos["servo_1"], None, Meeting()
    for step in range(round(8.0 / TIMESTEP)):
        speed = abs(servo.true_velocity)
        cell.advance(TIMESTEP)
        force, torque = force_on_post(cell), abs(servo.true_torque)
        if touched is None and force > TOUCHED:
            touched, found.speed = step, speed
        if touched is None:
            continue
        found.peak_torque = max(found.peak_torque, torque)
        since = (step - touched) * TIMESTEP
        if found.delay == math.inf and arm.state().result is MotionResult.BLOCKED:
            found.delay, found.error = since, arm.state().error
        if since <= AFTER:
            found.later_force, found.later_torque = force, torque
        if since > 0.5:
            break
    assert touched is not None, "the arm has not met the post"
    return found


@pytest.mark.slow
@pytest.mark.parametrize(("duration", "speed"), [(0.0, 0.6), (1.6, 0.4), (3.0, 0.1)])
def test_contact_is_found_within_50_ms_and_the_torque_falls(duration: float, speed: float) -> None:
    met = meet(duration)
    assert met.speed > speed
    assert met.delay <= 0.05, met
    assert met.peak_torque < 8.0
    assert met.later_torque < 0.5, "of 13 N m"
    assert met.later_force < 2.0
    assert met.error.startswith("Blocked: servo_1, ")
    assert met.error.endswith(" rad short; the arm holds where it is")


@pytest.mark.slow
def test_an_arm_that_gives_way_leaves_the_contact() -> None:
    met = meet(1.6, ContactReaction.YIELD)
    assert met.delay <= 0.05, met
    assert met.later_force < TOUCHED
    assert met.error.endswith("; the arm gives way")


@pytest.mark.slow
def test_without_an_observer_the_arm_presses_with_all_its_torque(monkeypatch: pytest.MonkeyPatch) -> None:
    """Until a connector gives way, which holds less than that."""
    monkeypatch.setattr(contact, "GAIN", 0.0)
    met = meet(1.6)
    assert met.delay == math.inf
    assert met.peak_torque > 10.0
