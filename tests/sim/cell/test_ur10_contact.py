"""The UR10 meets something in its way, in MuJoCo: contact forces are the simulation's, not those of its controllers."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace

import mujoco
import numpy as np
import pytest

pytest.importorskip("pinocchio", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)

from tests.helpers.cells import cell_model, put_on, small_cell, weightless

from jauspy.cell.assembly import Assembler
from jauspy.cell.carrying import Carrier
from jauspy.cell.frames import shifted, turned
from jauspy.cell.iso9283.loads import with_bolted_load
from jauspy.cell.motion import Path
from jauspy.cell.session import UNDISTURBED, Disturbances, simulated
from jauspy.cell.slots import PartResult
from jauspy.errors import RequestError
from jauspy.geometry.poses import Pose
from jauspy.platform.description import RobotModel
from jauspy.platform.joints import ContactReaction, ControlMode, JointContact, Target
from jauspy.platform.modular.parts import Fixture, PartSolid, Shape
from jauspy_sim.assembly import TIMESTEP
from jauspy_sim.cell.assembly import GRIPPER
from jauspy_sim.cell.payload import HeldPayload
from jauspy_sim.cell.robot import SimulatedCell
from jauspy_sim.physics import contact_guard

START = (-0.9, -1.2, 1.6, -1.9, -1.57, 0.0)
GOAL = (0.9, *START[1:])
POST = Fixture("post", (PartSolid(Shape.CUBOID, (0.1, 0.1, 1.6), 1.0),), Pose(x=0.65, y=0.25, z=0.8))
TOUCHED = 1.0
"""Newtons from which on the arm touches the post."""
BY_ITSELF = Target(ControlMode.VELOCITY, 0.0)


@dataclass
class Met:
    """Seconds from the first touch to the report of the joints, N, rad/s, and what was reported."""

    delay: float = math.inf
    speed: float = 0.0
    forces: dict[float, float] = field(default_factory=dict)
    contact: JointContact | None = None


def force_on_post(model: mujoco.MjModel, data: mujoco.MjData) -> float:
    total, row, post = 0.0, np.zeros(6), model.body(POST.name).id
    for number in range(data.ncon):
        if post in model.geom_bodyid[data.contact[number].geom]:
            mujoco.mj_contactForce(model, data, number, row)
            total += float(np.linalg.norm(row[:3]))
    return total


def cell_with_post(reaction: ContactReaction) -> SimulatedCell:
    model = cell_model()
    groups = {name: replace(group, contact=reaction) for name, group in model.groups.items()}
    assert model.cell is not None
    parts = tuple(part for part in model.cell.parts if part.name == "platform_2")
    bare = replace(model.cell, parts=parts, bins=(), fixtures=(POST,), conveyor=None, car="")
    return SimulatedCell.open(replace(model, groups=groups, cell=bare), "cell")


def meet(target: Target, others: Target | None = None, reaction: ContactReaction = ContactReaction.STOP) -> Met:
    """Turn the arm against the post, and watch half a second from the first touch."""
    cell = cell_with_post(reaction)
    arm, touched, met = cell.groups["ur10"], None, Met()
    arm.command([Target(ControlMode.POSITION, value) for value in START])
    cell.advance(2.0)
    assert arm.state().contact is None
    arm.command([target, *[others] * 5])
    for step in range(round(5.0 / TIMESTEP)):
        speed = arm.true_state().velocities[0]
        cell.advance(TIMESTEP)
        force = force_on_post(cell.model, cell.data)
        if touched is None and force > TOUCHED:
            touched, met.speed = step, speed
        if touched is None:
            continue
        since = (step - touched) * TIMESTEP
        met.forces[round(since, 3)] = force
        if met.contact is None and (contact := arm.state().contact) is not None:
            met.delay, met.contact = since, contact
        if since > 0.5:
            return met
    raise AssertionError("the arm has not met the post")


@pytest.mark.slow
@pytest.mark.parametrize(
    ("target", "others"),
    [
        (Target(ControlMode.POSITION, 0.9), None),
        (Target(ControlMode.POSITION, 0.9, speed=0.3), None),
        (Target(ControlMode.VELOCITY, 0.5), BY_ITSELF),
    ],
)
def test_contact_is_found_within_50_ms_and_the_force_falls(target: Target, others: Target | None) -> None:
    met = meet(target, others)
    assert met.speed > 0.25
    assert met.delay <= 0.05
    assert met.contact is not None
    assert next(iter(met.contact.efforts)) == "shoulder_pan"
    assert met.contact.efforts["shoulder_pan"] < -33.0, "it is pushed back, with more than a tenth of 330 N m"
    assert max(force for since, force in met.forces.items() if since >= 0.2) < 5.0


@pytest.mark.slow
def test_an_arm_that_gives_way_leaves_the_post() -> None:
    met = meet(Target(ControlMode.POSITION, 0.9, speed=0.3), reaction=ContactReaction.YIELD)
    assert met.delay <= 0.05
    assert met.contact is not None
    assert met.contact.gives_way
    assert max(force for since, force in met.forces.items() if since >= 0.2) == 0.0


@pytest.mark.slow
def test_without_a_watch_it_presses_with_all_its_effort() -> None:
    met = meet(Target(ControlMode.POSITION, 0.9, speed=0.3), reaction=ContactReaction.IGNORE)
    assert met.contact is None
    assert met.forces[0.5] > 200.0


@pytest.mark.slow
def test_efforts_are_meant_to_push() -> None:
    met = meet(Target(ControlMode.EFFORT, 60.0, compensated=True), Target(ControlMode.EFFORT, 0.0, compensated=True))
    assert met.contact is None


@pytest.mark.slow
@pytest.mark.parametrize("known", [False, True])
def test_a_load_that_is_not_known_yet_is_no_contact(monkeypatch: pytest.MonkeyPatch, known: bool) -> None:
    """4 kg bend the elbow with more than a tenth of its effort, until the arm has found their mass out."""
    setup = cell_model().cell
    assert setup is not None
    heavy = replace(setup.types["box"], solids=(replace(setup.types["box"].solids[0], mass=4.0),))
    cell = small_cell(["platform_2", "box_1"], types={**setup.types, "box": heavy})
    arm = cell.groups["ur10"]
    with weightless(cell):
        put_on(cell, GRIPPER, "box_1", setup.types["box"].grasp.inverse())
        cell.advance(0.5)
    cell.advance(0.5)
    assert cell.connectors[GRIPPER].attached_to == "box_1"
    if known:
        monkeypatch.setattr(HeldPayload, "known", True)
    arm.command([Target(ControlMode.POSITION, value, speed=0.3, acceleration=0.5, deceleration=0.5) for value in START])
    cell.advance(4.0)
    assert cell.connectors[GRIPPER].attached_to == "box_1"
    assert (arm.state().contact is not None) == known


@pytest.mark.slow
@pytest.mark.parametrize("allowed", [contact_guard.BEHIND, 0.0])
def test_a_motor_that_is_too_weak_for_its_setpoint_is_no_contact(
    monkeypatch: pytest.MonkeyPatch, allowed: float
) -> None:
    """With 10 kg bolted to the gripper the elbow falls behind at full speed."""
    monkeypatch.setattr(contact_guard, "BEHIND", allowed)
    model = with_bolted_load(cell_model(), 10.0)
    assert model.cell is not None
    parts = tuple(part for part in model.cell.parts if part.name == "platform_2")
    cell = SimulatedCell.open(replace(model, cell=replace(model.cell, parts=parts, car="")), "cell")
    arm, efforts = cell.groups["ur10"], [0.0]
    for elbow in (1.0, 2.2, 1.0):
        arm.command([Target(ControlMode.POSITION, value) for value in (-0.9, -1.2, elbow, -1.9, -1.57, 0.0)])
        for _ in range(100):
            cell.advance(0.02)
            efforts.append(abs(arm.true_state().efforts[2]))
    assert max(efforts) == pytest.approx(150.0, abs=1.0)
    assert (arm.state().contact is None) == (allowed > 0.0)


@pytest.mark.slow
async def test_the_services_report_it_and_the_client_raises_with_their_words(caplog: pytest.LogCaptureFixture) -> None:
    def change(model: RobotModel) -> RobotModel:
        assert model.cell is not None
        return replace(model, cell=replace(model.cell, fixtures=(*model.cell.fixtures, POST)))

    async with simulated(0, UNDISTURBED, change=change) as session:
        cell, robot = session.cell, session.true._robot
        start, goal = np.array(START), np.array(GOAL)
        await cell.follow(Path((await cell.posture(), start)))
        words = r"^Blocked: shoulder_pan, \d+ N m, 0\.\d+ rad short(; .*)?; 201\.1\.10 holds where it is$"
        with pytest.raises(RequestError, match=words):
            await cell.follow(Path((start, goal)))
        assert force_on_post(robot.model, robot.data) < 5.0
        assert "201.1.10: blocked: shoulder_pan, " in caplog.text
        assert caplog.text.count("blocked: ") == 1
        assert robot.groups["ur10"].contact.number == 1
        await cell.follow(Path((await cell.posture(), start)))
        await cell.slide(np.array([0.0, 0.5, 0.0]), 2.0)
        assert caplog.text.count("blocked: ") >= 2
        assert force_on_post(robot.model, robot.data) < 5.0


TABLE = Fixture(POST.name, (PartSolid(Shape.CUBOID, (0.1, 0.1, 0.3), 1.0),), Pose(x=0.45, z=0.15))


@pytest.mark.slow
async def test_a_touch_ends_at_what_the_gripper_cannot_hold() -> None:
    """Nothing attaches on a bare table: the UR10 finds that it presses, and does not press harder."""

    def change(model: RobotModel) -> RobotModel:
        assert model.cell is not None
        return replace(model, cell=replace(model.cell, fixtures=(*model.cell.fixtures, TABLE)))

    async with simulated(0, UNDISTURBED, change=change) as session:
        robot, ur10 = session.true._robot, Carrier(session.cell, session.layout)
        down, kinematics = turned("x", math.pi), session.layout.kinematics
        ur10.at = await session.cell.posture()
        over = kinematics.solve(shifted(0.45, 0.0, 0.35) * down, ur10.at)[0].positions
        await session.cell.follow(Path((ur10.at, over)))
        ur10.at = await session.cell.posture()
        await session.cell.enable("gripper", True)
        forces = [0.0]
        step = robot.advance

        def watched(dt: float) -> None:
            step(dt)
            forces.append(force_on_post(robot.model, robot.data))

        robot.advance = watched
        path = ur10.planner.line(over, shifted(0.45, 0.0, 0.297) * down)
        state = await ur10.touch(path, "gripper", shifted() * turned("x", 0.0))
        assert not state.attached_to
        assert robot.groups["ur10"].contact.number == 1, "it does not press on"
        assert await session.cell.blocked()
        assert 20.0 < max(forces) < 150.0, "33 N m at the shoulder are 75 N at 0.45 m, and 108 N until the joints yield"
        await ur10.go(ur10.handling.retreat(ur10.at), contact=True)
        assert forces[-1] == 0.0


@pytest.mark.slow
async def test_a_part_that_does_not_seal_is_not_pressed_until_the_arm_is_blocked(
    caplog: pytest.LogCaptureFixture,
) -> None:
    """The gripper is in contact then: pressing on loads the part and the bin below it."""
    async with simulated(2, Disturbances(0.0, 0.0, attach_failure=1.0)) as session:
        ur10 = Assembler(session.cell, session.layout)
        ur10.at = await session.cell.posture()
        await ur10.look()
        for part in ("wheel_1", "servo_12"):
            plan = ur10.handling.pick(part, ur10.seen[part].pose, ur10.at)
            assert await ur10.try_grasp(plan, PartResult("", part)) == f"no vacuum on {part}: the plate leaks"
        assert session.true._robot.groups["ur10"].contact is None
    assert "blocked" not in caplog.text
