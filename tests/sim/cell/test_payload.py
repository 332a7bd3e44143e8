"""What the UR10 holds: found by its motors while it moves, and carried by the feed-forward of its joints."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest

pytest.importorskip("mujoco")
pytest.importorskip("pinocchio", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)

from tests.helpers.cells import cell_model, open_cell, put_on

from jauspy.platform.joints import ControlMode, Target
from jauspy.platform.modular.connector import ConnectorState
from jauspy.platform.payload import PayloadIdentifier
from jauspy_sim.assembly import TIMESTEP
from jauspy_sim.cell.assembly import GRIPPER
from jauspy_sim.cell.connectors import Attachments
from jauspy_sim.cell.probe import JointFigures
from jauspy_sim.cell.robot import SimulatedCell
from jauspy_sim.cell.start import wait_attached
from jauspy_sim.physics.contact_guard import ContactGuard
from jauspy_sim.physics.dynamics import Dynamics, dynamics_of

HOME = (0.0, -1.9, 2.1, -1.77, -1.57, 0.0)
ASIDE = (1.2, -0.9, 1.2, -1.87, -1.57, 0.0)
MILLIRADIAN = 1e-3


def holding(part: str, *, mass: float = 0.0, seed: int = 0) -> SimulatedCell:
    """A cell whose gripper holds a part, of another mass if one is given."""
    cell = open_cell(seed=seed)
    body = cell.model.body(part)
    if mass:
        body.mass[0] = mass
    put_on(cell, GRIPPER, part, cell.setup.type_of(part).grasp.inverse())
    wait_attached(cell, GRIPPER, part)
    return cell


def move(cell: SimulatedCell, goal: Sequence[float], *, speed: float = 1.0, seconds: float = 3.0) -> None:
    targets = [Target(ControlMode.POSITION, value, speed=speed, acceleration=3.0 * speed) for value in goal]
    cell.groups["ur10"].command(targets)
    for _ in range(round(seconds / 0.02)):
        cell.advance(0.02)


def largest_end_error(joints: dict[str, JointFigures]) -> float:
    assert all(joint.ends for name, joint in joints.items() if name not in ("wrist_2", "wrist_3"))
    return max(joint.end_error for joint in joints.values())


def gripper(cell: SimulatedCell) -> ConnectorState:
    return cell.connectors[GRIPPER].state()


def test_nothing_is_known_before_the_robot_moves() -> None:
    cell = holding("servo_1")
    assert (gripper(cell).mass, gripper(cell).mass_deviation) == (0.0, float("inf"))


@pytest.mark.slow
@pytest.mark.parametrize(("part", "mass"), [("bracket_1", 0.2), ("car", 3.5), ("car", 2.0)])
def test_the_mass_is_found_by_moving_and_not_read(part: str, mass: float) -> None:
    cell = holding(part, mass=mass)
    move(cell, ASIDE)
    move(cell, HOME)
    found = gripper(cell)
    assert found.mass_deviation < max(0.03, 0.02 * mass)
    assert found.mass == pytest.approx(mass, abs=3.0 * found.mass_deviation)


@pytest.mark.slow
def test_joints_with_a_payload_arrive_within_a_milliradian() -> None:
    cell = holding("car")
    move(cell, ASIDE, speed=0.5)
    probe = cell.probe()
    move(cell, HOME, speed=2.0)
    assert largest_end_error(probe.joints) < MILLIRADIAN


@pytest.mark.slow
def test_a_payload_that_is_not_fed_forward_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Dynamics, "carry", lambda *_: None)
    monkeypatch.setattr(ContactGuard, "step", lambda *_, **__: None)  # for which it is a contact
    cell = holding("car")
    move(cell, ASIDE, speed=0.5)
    probe = cell.probe()
    move(cell, HOME, speed=2.0)
    assert largest_end_error(probe.joints) > MILLIRADIAN


@pytest.mark.slow
def test_what_was_released_is_forgotten() -> None:
    cell = holding("servo_1")
    move(cell, ASIDE, seconds=2.0)
    assert gripper(cell).mass > 0.3
    cell.connectors[GRIPPER].set(False)
    cell.advance(0.02)
    move(cell, HOME)
    assert (gripper(cell).mass, gripper(cell).mass_deviation) == (0.0, float("inf"))


@pytest.mark.slow
def test_a_load_that_stands_counts_by_what_the_gripper_measures(monkeypatch: pytest.MonkeyPatch) -> None:
    carried: list[float] = []
    cell = holding("servo_1")
    move(cell, ASIDE, seconds=2.0)
    monkeypatch.setattr(Dynamics, "carry", lambda _self, mass, _center: carried.append(mass))
    monkeypatch.setattr(Attachments, "_measure", lambda _self: None)
    cell.connectors[GRIPPER].load = (0.981, 0.0, 0.0)
    cell.advance(TIMESTEP)
    assert carried[-1] == pytest.approx(0.1, abs=0.01)


@pytest.mark.slow
def test_nothing_is_learned_at_rest_and_in_touches(monkeypatch: pytest.MonkeyPatch) -> None:
    cell = holding("servo_1")
    move(cell, ASIDE, seconds=2.0)
    monkeypatch.setattr(PayloadIdentifier, "add", lambda *_: pytest.fail("it learned"))
    cell.advance(0.2)
    move(cell, (ASIDE[0], ASIDE[1] + 0.02, *ASIDE[2:]), speed=0.02, seconds=1.0)


@pytest.mark.slow
def test_rows_are_the_efforts_of_a_load() -> None:
    model = cell_model()
    cell = open_cell()
    group = model.groups["ur10"]
    dynamics = dynamics_of(cell.model, cell.data, "cell/", model, group)
    assert dynamics is not None
    setpoints = [(0.5, 1.0), (-0.3, 2.0), (0.8, -1.0), (0.1, 0.5), (0.4, 3.0), (-1.0, 0.0)]
    mass, center = 2.0, (0.1, -0.2, 0.3)
    dofs = [int(cell.model.joint(f"cell/{name}").dofadr[0]) for name in group.joints]
    without = np.array(dynamics.efforts(setpoints))[dofs]
    dynamics.carry(mass, center)
    held = np.array(dynamics.efforts(setpoints))[dofs]
    rows, carried = dynamics.load_rows()
    assert carried == pytest.approx(held - without)
    still = [(0.0, 0.0)] * 6
    gravity = np.array(dynamics.efforts(still))[dofs]
    rows, carried = dynamics.load_rows()
    assert rows @ [mass, *(mass * value for value in center)] == pytest.approx(carried)
    assert not np.allclose(gravity, held)


@pytest.mark.slow
def test_joints_are_measured_by_encoders_and_currents() -> None:
    cell = open_cell(seed=3)
    cell.advance(0.2)
    group, sensors = cell.groups["ur10"], cell_model().groups["ur10"].sensors
    assert sensors is not None
    efforts = []
    for _ in range(200):
        cell.advance(TIMESTEP)
        state, true = group.state(), group.true_state()
        efforts.append([measured - real for measured, real in zip(state.efforts, true.efforts, strict=True)])
        for measured, real in zip(state.positions, true.positions, strict=True):
            assert abs(measured - real) < 6.0 * sensors.encoder_step
            assert measured / sensors.encoder_step == pytest.approx(round(measured / sensors.encoder_step), abs=1e-6)
    limits = np.array([joint.effort for joint in group.joints])
    assert np.std(efforts, axis=0) == pytest.approx(sensors.effort_noise * limits, rel=0.2)
    assert group.state().positions != group.true_state().positions


@pytest.mark.slow
def test_equal_seeds_give_equal_measurements() -> None:
    first, again, other = (holding("bracket_1", seed=seed) for seed in (1, 1, 2))
    for cell in (first, again, other):
        move(cell, ASIDE, seconds=1.0)
    assert gripper(first) == gripper(again)
    assert gripper(first).mass != gripper(other).mass
