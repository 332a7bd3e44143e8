"""Loads of the connections of an arm along motions: by hand, as simulated, and refused above 1/1.5 of the strength."""

from __future__ import annotations

import copy

import numpy as np
import pinocchio as pin
import pytest

from jauspy.cell.arm_loads import NOTHING, largest_load, smooth_states
from jauspy.cell.held_load import MOST
from jauspy.cell.modular_arm import FIVE_JOINTS, ArmOperator, Chain, HangingChain, Member
from jauspy.cell.motion import NoPath
from jauspy.cell.scene import Layout
from jauspy.geometry.vectors import GRAVITY
from jauspy.platform.modular.arm import ModularArm
from jauspy.platform.modular.holding import LATCH, Holding
from jauspy.platform.modular.parts import body_inertia, output_inertia

STRAIGHT = np.zeros(5)
LEVEL = np.array([0.0, np.pi / 2.0, 0.0, 0.0, 0.0])


def chain(layout: Layout, kind: type[Chain] = Chain) -> Chain:
    members = [Member(name, layout.type_of(name), pin.SE3.Identity(), "output") for name in FIVE_JOINTS]
    return kind(pin.SE3.Identity(), members)


def resting(chain: Chain, posture: np.ndarray, held: pin.Inertia | None = None) -> tuple[float, str]:
    rest = np.zeros(5)
    used = largest_load(chain, [(posture, rest, rest)], LATCH, held)
    return used.fraction, used.connector


def test_an_upright_arm_presses_its_plates_together(layout: Layout) -> None:
    fraction, _ = resting(chain(layout), STRAIGHT)
    assert fraction == pytest.approx(0.0, abs=1e-9)


def test_a_hanging_arm_pulls_with_its_weight(layout: Layout) -> None:
    """Upside down, its base at the top."""
    made = chain(layout)
    kinds = [layout.type_of(name) for name in FIVE_JOINTS]
    weight = GRAVITY * sum(body_inertia(kind).mass + output_inertia(kind).mass for kind in kinds)
    rest = np.zeros(5)
    turned = Chain(pin.SE3(pin.exp3(np.array([np.pi, 0.0, 0.0])), np.zeros(3)), made.members)
    used = largest_load(turned, [(rest, rest, rest)], Holding(weight, 0.03))
    assert (used.connector, used.fraction) == ("base", pytest.approx(1.0))


def test_a_level_arm_bends_its_lowest_connections_by_what_the_joint_carries(layout: Layout) -> None:
    made = chain(layout)
    torque = abs(float(pin.computeGeneralizedGravity(made.model, made.data, LEVEL)[1]))
    fraction, connector = resting(made, LEVEL)
    assert connector in {"base", "servo_1/output", "bracket_1/output"}
    assert fraction == pytest.approx(torque / LATCH.moment, rel=0.01)
    heavier, _ = resting(made, LEVEL, pin.Inertia.FromSphere(0.3, 0.05))
    reach = float(made.forward(LEVEL).translation[0])
    assert heavier - fraction == pytest.approx(0.3 * GRAVITY * reach / LATCH.moment, rel=0.01)


def test_on_its_other_end_the_same_arm_is_loaded_where_it_stands(layout: Layout) -> None:
    made = chain(layout, HangingChain)
    mass = sum(inertia.mass for _, inertia in made.bodies)
    assert mass == pytest.approx(sum(inertia.mass for _, inertia in chain(layout).bodies))
    fraction, connector = resting(made, np.array([0.0, 0.0, 0.0, 0.6, 0.0]))
    assert fraction > 0.05
    assert connector.startswith(("servo_5", "servo_11"))


def test_faster_motions_load_more(layout: Layout) -> None:
    made = chain(layout)
    slow, fast = (largest_load(made, smooth_states(STRAIGHT, LEVEL, time), LATCH) for time in (10.0, 0.6))
    assert fast.fraction > 1.3 * slow.fraction
    assert largest_load(made, [], LATCH) == NOTHING


def test_the_simulation_measures_the_same_at_rest(layout: Layout) -> None:
    pytest.importorskip("mujoco")
    cells = pytest.importorskip("tests.helpers.cells")
    cell = cells.small_cell([*FIVE_JOINTS, "platform_1"])
    cells.build_arm(cell, FIVE_JOINTS)
    posture = (0.4, 0.7, 0.5, 0.4, 0.2)
    arm = next(part for part in cell.optional_parts if isinstance(part, ModularArm))
    arm.move(posture, 2.0)
    cell.advance(4.0)
    probe = cell.probe()
    cell.advance(0.2)
    made = chain(layout)
    rest = np.zeros(5)
    at = np.array(arm.state().positions)
    for connection, peak in probe.peaks.items():
        name = "base" if connection[0] == "platform_1/top" else connection[0]
        planned = largest_load(only(made, name), [(at, rest, rest)], LATCH)
        assert planned.connector == name
        assert peak.utilisation == pytest.approx(planned.fraction, abs=0.004)


def only(made: Chain, name: str) -> Chain:
    """The same arm, of which only one connection counts."""
    found = copy.copy(made)
    found.connections = [connection for connection in made.connections if connection[0] == name]
    return found


class TestOperator:
    @pytest.fixture
    def arm(self, layout: Layout) -> ArmOperator:
        made = ArmOperator.__new__(ArmOperator)
        made.layout, made.chain = layout, chain(layout)
        return made

    def test_a_motion_within_the_strength_keeps_its_duration(self, arm: ArmOperator) -> None:
        assert arm.held_duration(STRAIGHT, LEVEL, 3.0) == 3.0

    def test_a_motion_that_loads_too_much_is_slowed_down(
        self, arm: ArmOperator, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        slow = arm.used(smooth_states(STRAIGHT, LEVEL, 3.0)).fraction
        weaker = Holding(LATCH.force * slow / (0.97 * MOST), LATCH.radius)
        monkeypatch.setattr(ArmOperator, "used", lambda self, states: largest_load(self.chain, states, weaker))
        duration = arm.held_duration(STRAIGHT, LEVEL, 1.0)
        assert 1.0 < duration <= 3.0
        assert arm.used(smooth_states(STRAIGHT, LEVEL, duration)).fraction <= MOST

    def test_a_posture_that_loads_too_much_is_refused(self, arm: ArmOperator, monkeypatch: pytest.MonkeyPatch) -> None:
        weak = Holding(200.0, LATCH.radius)
        monkeypatch.setattr(ArmOperator, "used", lambda self, states: largest_load(self.chain, states, weak))
        with pytest.raises(NoPath, match=r"even at rest .* would use \d+% of its strength, at most 67% is safe"):
            arm.held_duration(STRAIGHT, LEVEL, 3.0)
