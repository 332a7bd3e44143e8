"""Plans of throws: limits and margins are kept, and a throw that breaks one is refused."""

from __future__ import annotations

import asyncio
from dataclasses import replace

import coal
import numpy as np
import pinocchio as pin
import pytest

pytest.importorskip("mujoco", reason="needs the extra `sim`")

from jauspy.cell import throw
from jauspy.cell.frames import Array, shifted
from jauspy.cell.modular_arm import FIVE_JOINTS, ArmOperator
from jauspy.cell.motion import NoPath
from jauspy.cell.scene import Piece, pieces_of_part
from jauspy.cell.session import UNDISTURBED, simulated
from jauspy.cell.tasks import prepared, run_one
from jauspy.cell.throw import MARGIN, Load, ThrowPlan, ThrowPlanner, flight
from jauspy.platform.modular.holding import SAFETY, Holding

AIM = np.array([2.3, 0.22, 0.0])


async def _arm() -> ArmOperator:
    async with simulated(0, UNDISTURBED) as session:
        arm = await prepared(session, FIVE_JOINTS)
        await arm.look("box_1", "box_2", "box_3")
        return arm


@pytest.fixture(scope="module")
def planner() -> ThrowPlanner:
    arm = asyncio.run(_arm())
    kind, in_tip, middle = arm.layout.type_of("box_1"), arm.layout.grasp("box_1").inverse(), shifted(z=0.05)
    arm.scene.hold("box_1", pieces_of_part(kind), in_tip)
    shapes = [Piece(piece.shape, middle.inverse() * piece.frame) for piece in pieces_of_part(kind)]
    return ThrowPlanner(arm.chain, arm.scene, Load(0.3, kind.solids[0].size, in_tip * middle), shapes)


@pytest.fixture(scope="module")
def plan(planner: ThrowPlanner) -> ThrowPlan:
    return planner.plan(AIM)


def test_the_plan_keeps_all_limits_and_lands_at_the_aim(plan: ThrowPlan) -> None:
    assert plan.speed_ratio <= 1.0
    assert plan.torque_ratio <= 0.9
    assert plan.utilisation <= 1.0 / SAFETY
    assert plan.clearance.distance >= MARGIN
    assert np.linalg.norm(plan.flight.end[:2] - AIM[:2]) < 0.05


def test_a_few_milliseconds_of_the_release_change_the_range_little(planner: ThrowPlanner, plan: ThrowPlan) -> None:
    moved = throw.motion(plan.windup, plan.follow_through, planner.limits, plan.duration)
    index = round(plan.release / throw.PERIOD) - 1
    ends: list[Array] = [planner._landing(moved.q[at], moved.v[at]) for at in (index - 2, index, index + 2)]
    assert float(np.ptp([end[0] for end in ends])) < 0.01


def test_it_refuses_what_breaks_a_limit(
    planner: ThrowPlanner, plan: ThrowPlan, monkeypatch: pytest.MonkeyPatch
) -> None:
    with pytest.raises(NoPath, match="short"):
        planner.aimed(plan.windup, plan.follow_through, AIM + np.array([3.0, 0.0, 0.0]))
    with monkeypatch.context() as patched:
        patched.setattr(throw, "LATCH", Holding(200.0, 0.025))
        with pytest.raises(NoPath, match="strengths"):
            planner.turned(plan, AIM)
    with monkeypatch.context() as patched:
        patched.setattr(planner, "servos", [replace(servo, max_torque=3.0) for servo in planner.servos])
        with pytest.raises(NoPath, match="of the torques"):
            planner.turned(plan, AIM)
    wall = [Piece(coal.Box(0.05, 1.0, 3.0), pin.SE3.Identity())]
    planner.scene.put("wall", wall, shifted(x=1.6, y=0.22))
    try:
        with pytest.raises(NoPath, match="mm from"):
            planner.turned(plan, AIM)
    finally:
        planner.scene.remove("wall")


def test_a_flight_is_that_of_a_point_mass(planner: ThrowPlanner, plan: ThrowPlan) -> None:
    moved = throw.motion(plan.windup, plan.follow_through, planner.limits, plan.duration)
    index = round(plan.release / throw.PERIOD) - 1
    found = flight(planner.chain, planner.load, moved.q[index], moved.v[index])
    # the box's velocity by difference, not by the Jacobian
    before, after = (
        (planner.chain.forward(moved.q[at]) * planner.load.frame).translation for at in (index - 1, index + 1)
    )
    assert found.velocity == pytest.approx((after - before) / (2.0 * throw.PERIOD), abs=0.01)


@pytest.mark.slow
@pytest.mark.parametrize("seed", [1, 2, 3])
def test_the_simulation_sees_the_planned_clearance_and_no_contact(seed: int) -> None:
    found = asyncio.run(run_one("lift", seed))
    assert found.success, found.failure
    assert found.values["contacts"] == 0.0
    assert found.values["clearance"] > 0.015
    assert found.values["penetration"] < 0.002
    assert found.values["servo_speed"] < 1.0
