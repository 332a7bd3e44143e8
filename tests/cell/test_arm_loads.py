"""Loads of the connections of an arm along motions: by hand, as simulated, and refused above 1/1.5 of the strength."""

from __future__ import annotations

import copy
from dataclasses import replace

import numpy as np
import pinocchio as pin
import pytest

from jauspy.cell.arm_loads import NOTHING, largest_load, smooth_states
from jauspy.cell.design.chains import Element, posture
from jauspy.cell.design.loads import LoadedChain
from jauspy.cell.design.search import strengths_of
from jauspy.cell.held_load import MOST
from jauspy.cell.modular_arm import FIVE_JOINTS, ArmOperator, Chain, HangingChain, Member
from jauspy.cell.motion import NoPath
from jauspy.cell.scene import Layout, PlanningScene, cell_of
from jauspy.cell.throw import Load, SampledMotion, ThrowPlanner
from jauspy.geometry.poses import Transform
from jauspy.geometry.vectors import GRAVITY
from jauspy.platform.description import RobotModel
from jauspy.platform.modular.arm import ModularArm
from jauspy.platform.modular.holding import LATCH, Cup, Latch
from jauspy.platform.modular.parts import CellSetup, ConnectorLimits, body_inertia, output_inertia

STRAIGHT = np.zeros(5)
LEVEL = np.array([0.0, np.pi / 2.0, 0.0, 0.0, 0.0])


def chain(layout: Layout, kind: type[Chain] = Chain) -> Chain:
    members = [Member(name, layout.type_of(name), pin.SE3.Identity(), "output") for name in FIVE_JOINTS]
    return kind(pin.SE3.Identity(), members)


def resting(chain: Chain, posture: np.ndarray, held: pin.Inertia | None = None) -> tuple[float, str]:
    rest = np.zeros(5)
    used = largest_load(chain, [(posture, rest, rest)], ConnectorLimits(), held)
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
    used = largest_load(turned, [(rest, rest, rest)], ConnectorLimits(latch=Latch(weight, 0.03)))
    assert (used.connector, used.fraction) == ("base", pytest.approx(1.0))


def test_a_level_arm_bends_its_lowest_connections_by_what_the_joint_carries(layout: Layout) -> None:
    made = chain(layout)
    torque = abs(float(pin.computeGeneralizedGravity(made.model, made.data, LEVEL)[1]))
    fraction, connector = resting(made, LEVEL)
    assert connector in {"base", "servo_1/output", "bracket_1/output"}
    assert fraction == pytest.approx(torque / LATCH.moment, rel=0.04)  # the weight presses the plates together
    heavier, _ = resting(made, LEVEL, pin.Inertia.FromSphere(0.3, 0.05))
    reach = float(made.forward(LEVEL).translation[0])
    assert heavier - fraction == pytest.approx(0.3 * GRAVITY * reach / LATCH.moment, rel=0.05)


def test_on_its_other_end_the_same_arm_is_loaded_where_it_stands(layout: Layout) -> None:
    made = chain(layout, HangingChain)
    mass = sum(inertia.mass for _, inertia in made.bodies)
    assert mass == pytest.approx(sum(inertia.mass for _, inertia in chain(layout).bodies))
    fraction, connector = resting(made, np.array([0.0, 0.0, 0.0, 0.6, 0.0]))
    assert fraction > 0.05
    assert connector.startswith(("servo_5", "servo_11"))


def test_faster_motions_load_more(layout: Layout) -> None:
    made = chain(layout)
    slow, fast = (largest_load(made, smooth_states(STRAIGHT, LEVEL, time), ConnectorLimits()) for time in (10.0, 0.6))
    assert fast.fraction > 1.3 * slow.fraction
    assert largest_load(made, [], ConnectorLimits()) == NOTHING


LOAD = Load(0.3, (0.1, 0.1, 0.1), pin.SE3.Identity())
UNEQUAL = ConnectorLimits(cup=Cup(0.035), latch=Latch(600.0, 0.03))
"""Strengths of a cell's own file."""


def without_latch(setup: CellSetup, type: str) -> CellSetup:
    """A cell in which the parts of one type have no latches, with strengths of its own."""
    return replace(setup, types={**setup.types, type: replace(setup.types[type], latch=False)}, limits=UNEQUAL)


@pytest.mark.slow
def test_the_simulation_measures_what_all_planners_compute_for_parts_with_and_without_latches(
    model: RobotModel,
) -> None:
    pytest.importorskip("mujoco")
    cells = pytest.importorskip("tests.helpers.cells")
    setup = without_latch(cell_of(model), "tube_long")
    layout = Layout(replace(model, cell=setup))
    parts = ["servo_1", "bracket_1", "servo_2", "tube_1", "servo_3"]
    cell = cells.small_cell([*parts, "platform_1"], types=setup.types, limits=setup.limits)
    cells.build_arm(cell, parts)
    arm = next(part for part in cell.optional_parts if isinstance(part, ModularArm))
    arm.move((0.4, 1.2, 0.3), 2.0)
    cell.advance(4.0)
    probe = cell.probe()
    cell.advance(0.2)
    at, rest = np.array(arm.state().positions), np.zeros(3)
    members = [Member(name, layout.type_of(name), pin.SE3.Identity(), "output") for name in parts]
    chain = Chain(pin.SE3.Identity(), members)
    thrower = ThrowPlanner(chain, PlanningScene(chain, chain.links), LOAD, [], setup.limits)
    _, thrown = thrower.loads(SampledMotion(np.array([at]), np.zeros((1, 3)), np.zeros((1, 3)), 1.0), -1)
    elements = [Element(layout.type_of(name).name) for name in parts]
    standing = posture(Transform(), elements, setup.types, at.tolist())
    designed = [
        held.utilisation(*load)
        for held, load in zip(strengths_of(setup, "platform_1/top", elements), standing.loads(), strict=True)
    ]
    kinds = {}
    for number, connection in enumerate(chain.connections):
        name = "platform_1/top" if connection.name == "base" else connection.name
        (kind,) = [kind for at_name, kind in probe.peaks if at_name == name]
        kinds[name], measured = kind, probe.peaks[name, kind].utilisation
        planned = largest_load(only(chain, connection.name), [(at, rest, rest)], setup.limits)
        assert measured == pytest.approx(planned.fraction, rel=0.03, abs=0.004), name
        # it is taken to carry the part that it belongs to, too
        assert measured - 0.004 <= thrown[connection.name] <= measured + 0.03, name
        assert measured == pytest.approx(designed[number], rel=0.03, abs=0.004), name
    assert kinds == {
        "platform_1/top": "latch",
        "servo_1/output": "latch",
        "bracket_1/output": "latch",
        "servo_2/output": "cup",
        "tube_1/output": "cup",
    }
    moving = LoadedChain(pin.SE3.Identity(), chain, setup.limits)
    largest = max(peak.utilisation for peak in probe.peaks.values())
    assert moving.timed(at, at + 1e-3, 60.0).connector == pytest.approx(largest, abs=0.015)
    assert largest > 0.1


@pytest.mark.parametrize("kind", [Chain, HangingChain])
def test_a_base_without_a_latch_holds_by_its_cup(layout: Layout, kind: type[Chain]) -> None:
    made = chain(layout, kind)
    bare = kind(made.base, made.members, base_latch=False)
    assert [connection.latched for connection in made.connections] == [True] * 8
    assert [connection.latched for connection in bare.connections] == [False] + [True] * 7


def only(made: Chain, name: str) -> Chain:
    """The same arm, of which only one connection counts."""
    found = copy.copy(made)
    found.connections = [connection for connection in made.connections if connection.name == name]
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
        weaker = ConnectorLimits(latch=Latch(LATCH.force * slow / (0.97 * MOST), LATCH.radius))
        monkeypatch.setattr(ArmOperator, "used", lambda self, states: largest_load(self.chain, states, weaker))
        duration = arm.held_duration(STRAIGHT, LEVEL, 1.0)
        assert 1.0 < duration <= 3.0
        assert arm.used(smooth_states(STRAIGHT, LEVEL, duration)).fraction <= MOST

    def test_a_posture_that_loads_too_much_is_refused(self, arm: ArmOperator, monkeypatch: pytest.MonkeyPatch) -> None:
        weak = ConnectorLimits(latch=Latch(200.0, LATCH.radius))
        monkeypatch.setattr(ArmOperator, "used", lambda self, states: largest_load(self.chain, states, weak))
        with pytest.raises(NoPath, match=r"even at rest .* would use \d+% of its strength, at most 67% is safe"):
            arm.held_duration(STRAIGHT, LEVEL, 3.0)
