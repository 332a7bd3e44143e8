"""Vacuum connectors of the simulated cell: what attaches, what does not, and what breaks off."""

from __future__ import annotations

import math

import pytest

pytest.importorskip("mujoco")
pytest.importorskip("pinocchio", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)

from tests.helpers.cells import GAP, put, put_on, small_cell

from jauspy.geometry.poses import Pose, Transform
from jauspy.platform.modular.connector import ConnectorError, ConnectorState
from jauspy.platform.modular.parts import ConnectorLimits
from jauspy_sim.cell.robot import SimulatedCell

TOP = "platform_1/top"
DOWN = Transform.from_pose(Pose(roll=math.pi))


def two_parts(**changes: object) -> SimulatedCell:
    return small_cell(["platform_1", "tube_1"], **changes)


def attempt(error: Pose, **changes: object) -> ConnectorState:
    """The state of a connector after a tube was put on it with an error."""
    cell = two_parts(**changes)
    put_on(cell, TOP, "tube_1", Transform.from_pose(error))
    cell.advance(0.004)
    return cell.connectors[TOP].state()


def test_a_part_in_contact_attaches_and_stays() -> None:
    cell = two_parts()
    put_on(cell, TOP, "tube_1")
    cell.advance(0.02)
    state = cell.connectors[TOP].state()
    assert state.attached_to == "tube_1"
    assert state.last_error == ""
    assert state.offset.position == pytest.approx((0.0, 0.0, GAP), abs=1e-4)
    before = cell.truth.pose("tube_1")
    cell.advance(1.0)
    assert cell.truth.pose("tube_1").z == pytest.approx(before.z, abs=2e-5)
    assert cell.connectors[TOP].state().force == pytest.approx(0.27 * 9.81, rel=0.02)


@pytest.mark.parametrize(
    ("error", "reason", "error_code"),
    [
        (Pose(x=0.007), "7 mm off", ConnectorError.TOO_FAR),
        (Pose(roll=math.radians(7.0)), "7 degrees off", ConnectorError.NOT_ALIGNED),
        (Pose(z=0.0025), "not in contact", ConnectorError.NO_CONTACT),
    ],
)
def test_a_part_out_of_line_does_not_attach(error: Pose, reason: str, error_code: ConnectorError) -> None:
    state = attempt(error)
    assert state.attached_to == ""
    assert reason in state.last_error
    assert state.error is error_code
    assert "tube_1" in state.last_error


def test_limits_are_those_of_the_cell() -> None:
    wide = ConnectorLimits(max_distance=0.01, max_angle=math.radians(10.0))
    assert attempt(Pose(x=0.007), limits=wide).attached_to == "tube_1"
    assert attempt(Pose(roll=math.radians(3.0))).attached_to == "tube_1"


def test_the_angle_about_the_normal_is_free() -> None:
    state = attempt(Pose(yaw=1.0))
    assert state.attached_to == "tube_1"
    assert state.offset.to_pose().yaw == pytest.approx(1.0, abs=0.01)


def test_a_disabled_connector_holds_nothing() -> None:
    cell = two_parts()
    put_on(cell, TOP, "tube_1")
    cell.connectors[TOP].set(False)
    cell.advance(0.05)
    assert cell.connectors[TOP].state().attached_to == ""
    cell.connectors[TOP].set(True)
    cell.advance(0.02)
    assert cell.connectors[TOP].state().attached_to == "tube_1"
    cell.connectors[TOP].set(False)
    cell.advance(0.02)
    assert cell.connectors[TOP].state().attached_to == ""


def test_what_hangs_falls_when_it_is_released() -> None:
    """Also after it has come to rest and sleeps."""
    cell = small_cell(["tube_1", "platform_1"])
    put_on(cell, "gripper", "tube_1", DOWN @ Transform(position=(0.0, 0.0, -0.2)))
    cell.advance(3.0)
    hanging = cell.truth.pose("tube_1").z
    assert cell.connectors["gripper"].state().attached_to == "tube_1"
    cell.connectors["gripper"].set(False)
    cell.advance(0.1)
    assert cell.truth.pose("tube_1").z < hanging - 0.03


@pytest.mark.parametrize("weight", [50.0, 400.0])
def test_overload_breaks_off(weight: float) -> None:
    """Pulled from above with a force below and above the rated one."""
    cell = two_parts(limits=ConnectorLimits(max_force=200.0, max_moment=20.0))
    put_on(cell, TOP, "tube_1")
    cell.advance(0.05)
    body = cell.model.body("tube_1").id
    cell.data.xfrc_applied[body][2] = weight
    cell.advance(0.1)
    state = cell.connectors[TOP].state()
    if weight < 200.0:
        assert state.attached_to == "tube_1"
        assert state.force == pytest.approx(weight - 0.27 * 9.81, rel=0.02)
        return
    assert state.attached_to == ""
    assert state.broken_off == 1
    assert not state.enabled
    assert state.error is ConnectorError.OVERLOADED
    assert state.last_error.startswith("tube_1 broke off:")
    assert "rated 200 N" in state.last_error


def test_a_moment_is_measured_and_breaks_off() -> None:
    cell = two_parts(limits=ConnectorLimits(max_force=200.0, max_moment=5.0))
    put_on(cell, TOP, "tube_1")
    cell.advance(0.05)
    body = cell.model.body("tube_1").id
    cell.data.xfrc_applied[body][3] = 3.0
    cell.advance(0.2)
    assert cell.connectors[TOP].state().moment == pytest.approx(3.0, rel=0.03)
    cell.data.xfrc_applied[body][3] = 7.0
    cell.advance(0.2)
    state = cell.connectors[TOP].state()
    assert state.broken_off == 1
    assert "rated 5.0 N m" in state.last_error


def test_the_gripper_holds_a_box_anywhere_on_its_face() -> None:
    cell = small_cell(["platform_1", "box_1"])
    gripper = cell.truth.connector("gripper")
    held = gripper @ DOWN @ Transform(position=(0.03, -0.02, -0.1 - GAP))
    put(cell, "box_1", held)
    cell.connectors["gripper"].set(True)
    cell.advance(0.02)
    assert cell.connectors["gripper"].state().attached_to == "box_1"
    beside = gripper @ DOWN @ Transform(position=(0.07, 0.0, -0.1 - GAP))
    cell.connectors["gripper"].set(False)
    cell.advance(0.004)
    put(cell, "box_1", beside)
    cell.connectors["gripper"].set(True)
    cell.advance(0.004)
    assert cell.connectors["gripper"].state().attached_to == ""  # the plate sticks out over the edge


def test_attempts_of_the_gripper_fail_by_themselves() -> None:
    cell = small_cell(["platform_1", "box_1"], attach_failure=0.5, seed=1)
    gripper = cell.connectors["gripper"]
    failed = 0
    for _ in range(12):
        put(cell, "box_1", cell.truth.connector("gripper") @ DOWN @ Transform(position=(0.0, 0.0, -0.1 - GAP)))
        gripper.set(True)
        cell.advance(0.012)
        state = gripper.state()
        if not state.attached_to:
            failed += 1
            assert state.last_error == "no vacuum on box_1: the plate leaks"
        gripper.set(False)
        cell.advance(0.012)
    assert 2 <= failed <= 10


def test_two_connectors_can_face_each_other() -> None:
    """As when an arm steps: the connector of a platform takes the end of the arm."""
    cell = small_cell(["platform_1", "platform_2", "tube_1"])
    put(cell, "tube_1", cell.truth.connector("platform_2/top") @ DOWN @ Transform(position=(0.0, 0.0, -0.2 - GAP)))
    cell.connectors["platform_2/top"].set(True)
    cell.advance(0.02)
    state = cell.connectors["platform_2/top"].state()
    assert state.attached_to == "tube_1"
    assert state.offset.position == pytest.approx((0.0, 0.0, 0.2 + GAP), abs=1e-4)
    assert state.offset.rotation[2][2] == pytest.approx(-1.0, abs=1e-3)


def test_parts_that_are_attached_do_not_collide() -> None:
    """A tube that was attached with a tilt overlaps the plate; contact would push it off."""
    cell = two_parts()
    put_on(cell, TOP, "tube_1", Transform.from_pose(Pose(roll=math.radians(3.0))))
    cell.advance(1.0)
    assert cell.truth.contacts(["tube_1"]) == []
    roll = cell.connectors[TOP].state().offset.to_pose().roll
    measured = (cell.truth.connector(TOP).inverse() @ cell.truth.frame("tube_1")).to_pose().roll
    assert measured == pytest.approx(roll, abs=1e-4)
