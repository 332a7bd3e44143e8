"""Vacuum connectors of the simulated cell: what attaches, what does not, and what breaks off."""

from __future__ import annotations

import itertools
import math
from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

pytest.importorskip("mujoco")
pytest.importorskip("pinocchio", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)

from tests.helpers.cells import GAP, cell_model, put, put_on, small_cell

from jauspy.geometry.poses import Pose, Transform
from jauspy.platform.modular.connector import ConnectorError, ConnectorState
from jauspy.platform.modular.holding import LATCH, Cup
from jauspy.platform.modular.parts import ConnectorLimits, PartType
from jauspy_sim.assembly import TIMESTEP
from jauspy_sim.cell.connectors import Attachments
from jauspy_sim.cell.robot import CONTROL_EVERY, SHORT_STEPS, SimulatedCell

Array = NDArray[np.float64]

TOP = "platform_1/top"
DOWN = Transform.from_pose(Pose(roll=math.pi))


def two_parts(**changes: object) -> SimulatedCell:
    return small_cell(["platform_1", "tube_1"], **changes)


EVACUATED = 0.04
"""Seconds after which a cup holds."""
SETTLED = 0.4
"""Seconds after which its vacuum is constant, and its latch has locked."""


def attempt(error: Pose, time: float = EVACUATED, **changes: object) -> ConnectorState:
    """The state of a connector after a tube was put on it with an error; it does not fall meanwhile."""
    cell = two_parts(**changes)
    cell.model.opt.gravity[:] = 0.0
    put_on(cell, TOP, "tube_1", Transform.from_pose(error))
    cell.advance(time)
    return cell.connectors[TOP].state()


def test_a_part_in_contact_attaches_and_stays() -> None:
    cell = two_parts()
    put_on(cell, TOP, "tube_1")
    cell.advance(EVACUATED)
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
    state = attempt(error, 0.004)
    assert state.attached_to == ""
    assert reason in state.last_error
    assert state.error is error_code
    assert "tube_1" in state.last_error


@pytest.mark.slow
def test_limits_are_those_of_the_cell() -> None:
    wide = ConnectorLimits(max_distance=0.01, max_angle=math.radians(10.0), cup=Cup(0.03, stroke=0.004))
    assert attempt(Pose(x=0.007), limits=wide).attached_to == "tube_1"
    assert attempt(Pose(roll=math.radians(6.0)), limits=wide).attached_to == "tube_1"


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
    cell.advance(EVACUATED)
    assert cell.connectors[TOP].state().attached_to == "tube_1"
    cell.connectors[TOP].set(False)
    cell.advance(0.02)
    assert cell.connectors[TOP].state().attached_to == ""


@pytest.mark.parametrize("delay", [0.1, 0.1 + TIMESTEP, 0.5])
def test_a_scheduled_release_comes_in_its_control_cycle(delay: float) -> None:
    cell = two_parts()
    put_on(cell, TOP, "tube_1")
    cell.advance(0.2)
    begun, connector = cell.time, cell.connectors[TOP]
    connector.schedule(False, delay)
    while connector.state().attached_to:
        assert cell.time - begun < delay + 0.01, "it is late"
        cell.advance(TIMESTEP)
    assert cell.time - begun == pytest.approx(delay, abs=CONTROL_EVERY * TIMESTEP)


def test_a_scheduled_release_is_replaced_or_cancelled() -> None:
    cell = two_parts()
    put_on(cell, TOP, "tube_1")
    cell.advance(0.2)
    connector = cell.connectors[TOP]
    for replace_it in (connector.cancel, lambda: connector.set(True), lambda: connector.schedule(False, 5.0)):
        connector.schedule(False, 0.05)
        replace_it()
        cell.advance(0.2)
        assert connector.state().attached_to == "tube_1"


@pytest.mark.slow
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


def test_the_gripper_holds_a_box_anywhere_on_its_face() -> None:
    cell = small_cell(["platform_1", "box_1"])
    gripper = cell.truth.connector("gripper")
    held = gripper @ DOWN @ Transform(position=(0.03, -0.02, -0.1 - GAP))
    put(cell, "box_1", held)
    cell.connectors["gripper"].set(True)
    cell.advance(EVACUATED)
    assert cell.connectors["gripper"].state().attached_to == "box_1"
    beside = gripper @ DOWN @ Transform(position=(0.07, 0.0, -0.1 - GAP))
    cell.connectors["gripper"].set(False)
    cell.advance(0.004)
    put(cell, "box_1", beside)
    cell.connectors["gripper"].set(True)
    cell.advance(EVACUATED)
    assert cell.connectors["gripper"].state().attached_to == ""  # the plate sticks out over the edge


def test_attempts_of_the_gripper_fail_by_themselves() -> None:
    cell = small_cell(["platform_1", "box_1"], attach_failure=0.5, seed=1)
    gripper = cell.connectors["gripper"]
    failed = 0
    for _ in range(12):
        put(cell, "box_1", cell.truth.connector("gripper") @ DOWN @ Transform(position=(0.0, 0.0, -0.1 - GAP)))
        gripper.set(True)
        cell.advance(EVACUATED)
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
    cell.advance(EVACUATED)
    state = cell.connectors["platform_2/top"].state()
    assert state.attached_to == "tube_1"
    assert state.offset.position == pytest.approx((0.0, 0.0, 0.2 + GAP), abs=1e-4)
    assert state.offset.rotation[2][2] == pytest.approx(-1.0, abs=1e-3)


def test_parts_that_are_attached_do_not_collide() -> None:
    """A tube that was attached with a tilt overlaps the plate; contact would push it off."""
    cell = two_parts()
    put_on(cell, TOP, "tube_1", Transform.from_pose(Pose(roll=math.radians(2.0))))
    cell.advance(1.0)
    assert cell.truth.contacts(["tube_1"]) == []
    roll = cell.connectors[TOP].state().offset.to_pose().roll
    measured = (cell.truth.connector(TOP).inverse() @ cell.truth.frame("tube_1")).to_pose().roll
    assert measured == pytest.approx(roll, abs=1e-4)


# --- strength -----------------------------------------------------------------------------------------------------

RAMP = 1.0
"""Seconds in which a load grows from nothing to half more than the strength."""


def held_tube(*, latched: bool) -> SimulatedCell:
    """A tube on a platform, held by the cup alone or by the latch; without gravity, so that it is the only load."""
    cell = small_cell(["platform_1", "tube_1"], types=types(latched))
    cell.model.opt.gravity[:] = 0.0
    put_on(cell, TOP, "tube_1")
    cell.advance(SETTLED)
    assert cell.connectors[TOP].state().latched is latched
    return cell


def types(latched: bool) -> dict[str, PartType]:
    return {name: replace(kind, latch=latched) for name, kind in cell_model().cell.types.items()}


def load(cell: SimulatedCell, wrench: Array) -> None:
    """Apply a force and a moment to the tube, about the middle of its plate."""
    body = cell.model.body("tube_1").id
    middle = cell.data.xipos[body] - np.array(cell.truth.connector(TOP).position)
    cell.data.xfrc_applied[body][:3] = wrench[:3]
    cell.data.xfrc_applied[body][3:] = wrench[3:] - np.cross(middle, wrench[:3])


def broken_at(cell: SimulatedCell, most: Array) -> float:
    """The fraction of a load at which the tube breaks off while that grows slowly; NaN if it does not."""
    steps = round(RAMP / TIMESTEP)
    for step in range(1, steps + 1):
        load(cell, most * step / steps)
        cell.advance(TIMESTEP)
        if cell.connectors[TOP].state().broken_off:
            return step / steps
    return math.nan


LOADS = {
    "pull": ((0, 0, 1), (0, 0, 0), 1.0),
    "shear": ((1, 0, 0), (0, 0, 0), 0.5),
    "peel": ((0, 0, 0), (0, 1, 0), 1.0),
    "torsion": ((0, 0, 0), (0, 0, 1), 0.5),
    "pull and peel": ((0, 0, 1), (0, 1, 0), 0.5),
    "shear and torsion": ((0, 1, 0), (0, 0, 1), 0.5 / math.sqrt(2.0)),
    "pull, shear, peel and torsion": ((0, 1, 1), (1, 0, 1), 1.0 / (1.0 + 2.0 * math.sqrt(2.0))),
}
"""Direction of the force in multiples of the strength, of the moment in those of strength times radius; and the
fraction of both that breaks it, computed by hand."""


@pytest.mark.slow
@pytest.mark.parametrize("latched", [False, True], ids=["cup", "latch"])
@pytest.mark.parametrize("name", LOADS)
def test_a_growing_load_breaks_it_off_at_its_strength(name: str, latched: bool) -> None:
    force, radius = (1100.0, 0.025) if latched else (254.5, 0.030)
    forces, moments, fraction = LOADS[name]
    strength = fraction * np.array([*forces, *(radius * moment for moment in moments)]) * force
    cell = held_tube(latched=latched)
    assert broken_at(cell, 1.5 * strength) * 1.5 == pytest.approx(1.0, rel=0.03)
    state = cell.connectors[TOP].state()
    assert state.error is ConnectorError.OVERLOADED
    assert not state.enabled
    assert state.attached_to == ""
    assert state.last_error.startswith("tube_1 broke off:")
    assert f"({force:.0f} N, " in state.last_error


@pytest.mark.slow
def test_pressing_it_on_does_not_break_it_off() -> None:
    cell = held_tube(latched=False)
    assert math.isnan(broken_at(cell, np.array([0.0, 0.0, -3000.0, 0.0, 0.0, 0.0])))
    assert cell.connectors[TOP].state().utilisation < 0.05


def overload_of_one_step(cell: SimulatedCell) -> int:
    """How often a pull breaks the tube off that is too much for one physics step."""
    cell.advance(TIMESTEP)
    load(cell, np.array([0.0, 0.0, 1.3 * 254.5, 0.0, 0.0, 0.0]))
    cell.advance(TIMESTEP)
    load(cell, np.zeros(6))
    cell.advance(0.1)
    return cell.connectors[TOP].state().broken_off


def test_one_overloaded_step_breaks_it_off() -> None:
    assert overload_of_one_step(held_tube(latched=False)) == 1


def test_a_check_of_every_eighth_step_would_miss_that(monkeypatch: pytest.MonkeyPatch) -> None:
    """The test above can fail: with such a check the tube stays on."""
    calls = itertools.count(1)
    check = Attachments.check

    def seldom(self: Attachments) -> None:
        if not next(calls) % 8:
            check(self)

    cell = held_tube(latched=False)
    monkeypatch.setattr(Attachments, "check", seldom)
    assert overload_of_one_step(cell) == 0


def test_the_latch_of_a_box_thrown_by_short_steps_is_checked_in_each_of_them(monkeypatch: pytest.MonkeyPatch) -> None:
    cell = small_cell(["platform_1", "tube_1", "box_1"])
    calls = []
    monkeypatch.setattr(Attachments, "check", lambda self: calls.append(cell.model.opt.timestep))
    cell.advance(TIMESTEP)
    cell.data.qvel[int(cell.model.joint("box_1").dofadr[0])] = 3.0
    cell.advance(TIMESTEP)
    assert calls == [TIMESTEP, *[TIMESTEP / SHORT_STEPS] * SHORT_STEPS]


@pytest.mark.slow
def test_the_probe_measures_the_same_load_from_outside() -> None:
    cell = held_tube(latched=True)
    probe = cell.probe()
    wrench = np.array([20.0, -30.0, 200.0, 2.0, 3.0, 1.0])
    load(cell, wrench)
    cell.advance(0.5)
    state, peak = cell.connectors[TOP].state(), probe.largest_loads()["latch"]
    assert [*peak.force, *peak.moment] == pytest.approx(-wrench, abs=0.15 * np.abs(wrench).max())
    used = LATCH.utilisation(tuple(-wrench[:3]), tuple(-wrench[3:]))
    assert state.utilisation == pytest.approx(used, rel=0.02)
    assert used <= peak.utilisation < 1.3 * used  # with what the sudden load overshoots


# --- vacuum and latch ---------------------------------------------------------------------------------------------


def test_the_cup_is_evacuated_in_the_time_that_pump_and_volume_give() -> None:
    """From 0 to 60 % of the vacuum: volume / suction * ln(1 / 0.4), in control cycles of 4 ms."""
    cell = two_parts()
    put_on(cell, TOP, "tube_1")
    begun = cell.time
    while not cell.connectors[TOP].state().attached_to:
        assert cell.connectors[TOP].state().vacuum < 0.6 * 90e3
        assert not cell.connectors[TOP].secured
        cell.advance(TIMESTEP)
    assert cell.time - begun == pytest.approx(30e-6 / 1.2e-3 * math.log(1.0 / 0.4), abs=0.006)


def test_a_part_that_is_pulled_before_the_vacuum_is_full_comes_off_sooner() -> None:
    cell = small_cell(["platform_1", "tube_1"], types=types(False))
    put_on(cell, TOP, "tube_1")
    while not cell.connectors[TOP].state().attached_to:
        cell.advance(TIMESTEP)
    vacuum = cell.connectors[TOP].state().vacuum
    assert vacuum < 0.7 * 90e3
    load(cell, np.array([0.0, 0.0, 1.2 * 254.5 * vacuum / 90e3, 0.0, 0.0, 0.0]))
    cell.advance(2.0 * TIMESTEP)
    assert cell.connectors[TOP].state().broken_off == 1


def test_plates_that_slide_while_the_vacuum_is_low_go_on_being_evacuated() -> None:
    cell = small_cell(["platform_1", "tube_1"], types=types(False))
    put_on(cell, TOP, "tube_1")
    cell.advance(0.01)
    load(cell, np.array([60.0, 0.0, -20.0, 0.0, 0.0, 0.0]))
    cell.advance(TIMESTEP)
    assert cell.connectors[TOP].held is None
    load(cell, np.zeros(6))
    cell.advance(EVACUATED)
    state = cell.connectors[TOP].state()
    assert (state.attached_to, state.broken_off) == ("tube_1", 0)


@pytest.mark.parametrize(
    ("tilt", "least", "most"), [(0.0, 0.99, 1.0), (math.radians(2.0), 0.99, 1.0), (math.radians(3.35), 0.6, 0.95)]
)
def test_the_vacuum_of_a_tilted_plate_settles_at_what_the_leak_leaves(tilt: float, least: float, most: float) -> None:
    state = attempt(Pose(roll=tilt), SETTLED, types=types(False))
    assert state.attached_to == "tube_1"
    assert least <= state.vacuum / 90e3 <= most


def test_a_plate_that_leaks_too_much_does_not_hold() -> None:
    state = attempt(Pose(roll=math.radians(3.9)), 0.004)
    assert (state.attached_to, state.error) == ("", ConnectorError.FAILED)
    assert state.last_error.startswith("the cup leaks on tube_1:")


@pytest.mark.slow
def test_a_latch_locks_after_the_vacuum_and_only_what_is_in_line() -> None:
    cell = two_parts()
    put_on(cell, TOP, "tube_1")
    cell.advance(EVACUATED)
    assert cell.connectors[TOP].state().attached_to == "tube_1"
    cell.advance(0.15)
    assert not cell.connectors[TOP].state().latched
    cell.advance(0.08)
    assert cell.connectors[TOP].state().latched
    state = attempt(Pose(x=0.0015), SETTLED)
    assert (state.attached_to, state.latched) == ("tube_1", False)
    assert state.last_error == "not locked on tube_1: 1.5 mm and 0.0 degrees off, at most 1.0 mm and 2.0 degrees lock"


def test_the_gripper_locks_on_a_flange_and_not_where_a_part_has_none() -> None:
    cell = small_cell(["tube_1", "platform_1"])
    beside = Transform(position=(0.0, 0.0, GAP)) @ cell.setup.type_of("tube_1").grasp.inverse()
    for held, latched in ((DOWN @ Transform(position=(0.0, 0.0, -0.2)), True), (beside, False)):
        put_on(cell, "gripper", "tube_1", held)
        cell.advance(SETTLED)
        state = cell.connectors["gripper"].state()
        assert (state.attached_to, state.latched) == ("tube_1", latched)
        cell.connectors["gripper"].set(False)
        cell.advance(0.01)
