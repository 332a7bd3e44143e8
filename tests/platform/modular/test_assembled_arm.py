"""The contract of modular arms, with any number of joints: motions, refusals, silence, attachments and steps."""

import math

import numpy as np
import pytest
from tests.helpers.sampling import sampled

pytest.importorskip("pinocchio", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)
pytest.importorskip("ruckig", reason="the extra 'cell' is not installed")

from tests.helpers.servo_plant import FIVE, ServoPlant, many

from jauspy.geometry.poses import IDENTITY, Transform
from jauspy.geometry.vectors import rotation_about
from jauspy.platform.modular.arm import ArmController, MotionResult
from jauspy.platform.modular.assembled_arm import AssembledArm

NAN = math.nan
START = (0.3, 0.4, 0.5, 0.4, 0.2)


@pytest.fixture
def plant() -> ServoPlant:
    plant = ServoPlant()
    plant.settle(START)
    return plant


@pytest.fixture
def arm(plant: ServoPlant) -> AssembledArm:
    arm = plant.arm()
    plant.run(arm, 0.1)
    return arm


def largest_jump(torques: list[list[float]]) -> float:
    """The largest change of a motor's torque from one control cycle to the next, as a fraction of its limit."""
    limits = np.array([13.0, 38.0, 20.0, 7.0, 7.0])
    changes = np.abs(np.diff(np.array(torques), axis=0))
    return float((changes / limits[: changes.shape[1]]).max())


class TestAnyNumberOfJoints:
    @pytest.mark.slow
    @pytest.mark.parametrize("controller", ArmController)
    @pytest.mark.parametrize("count", sampled(range(10), 3))
    def test_moves_all_joints(self, count: int, controller: ArmController) -> None:
        plant = ServoPlant(many(count))
        arm = plant.arm()
        arm.set_controller(controller)
        plant.run(arm, 0.1)
        targets = [0.2 - 0.05 * at for at in range(count)]
        arm.move(targets, 1.0)
        assert bool(arm.state().error) == (count == 0)
        plant.run(arm, 3.0)
        state = arm.state()
        assert len(state.joints) == len(state.velocities) == len(state.efforts) == count
        loose = 0.02 if count < 6 else 0.2  # PID controllers that know nothing of each other
        assert state.positions == pytest.approx(targets, abs=loose if controller is ArmController.PID else 0.002)
        assert state.targets == pytest.approx(targets)

    @pytest.mark.parametrize("count", sampled(range(10), 3))
    @pytest.mark.parametrize("more", [-1, 1, 5])
    def test_refuses_other_lengths(self, count: int, more: int) -> None:
        plant = ServoPlant(many(count))
        arm = plant.arm()
        plant.run(arm, 0.1)
        arm.move([0.1] * max(0, count + more), 1.0)
        plant.run(arm, 0.1)
        assert f"{max(0, count + more)} positions for {count}" in arm.state().error or count == 0
        assert arm.state().error.startswith("motion refused") or count + more <= 0
        assert not arm.state().moving

    def test_an_arm_of_nothing_does_nothing(self) -> None:
        plant = ServoPlant(())
        arm = plant.arm()
        plant.run(arm, 0.1)
        arm.move((), 1.0)
        arm.hold()
        arm.set_controller(ArmController.PID)
        plant.run(arm, 0.1)
        assert arm.state().joints == ()
        assert arm.state().error == "motion refused: no servo module is attached to a base"


class TestMotions:
    def test_reports_what_it_is(self, arm: AssembledArm) -> None:
        state = arm.state()
        assert (state.base, state.tip) == ("platform_1/top", "servo_5/output")
        assert state.parts == tuple(name for name, _ in FIVE)
        assert state.positions == pytest.approx(START, abs=1e-3)
        assert state.controller is ArmController.MODEL

    def test_takes_the_given_duration(self, plant: ServoPlant, arm: AssembledArm) -> None:
        arm.move((0.0,) * 5, 2.0)
        plant.run(arm, 1.9)
        assert max(map(abs, arm.state().positions)) > 1e-4
        assert arm.state().moving
        plant.run(arm, 0.3)
        assert arm.state().positions == pytest.approx((0.0,) * 5, abs=3e-3)
        plant.run(arm, 0.3)
        assert not arm.state().moving

    @pytest.mark.parametrize("duration", [0.0, NAN])
    def test_is_as_fast_as_limits_allow(self, plant: ServoPlant, arm: AssembledArm, duration: float) -> None:
        arm.move((1.5, *START[1:]), duration)
        speeds = []
        for _ in range(80):
            plant.run(arm, 0.01)
            speeds.append(plant.velocities[0])
        assert max(speeds) == pytest.approx(0.8 * 1.503, rel=0.08)

    def test_nan_leaves_a_target(self, plant: ServoPlant, arm: AssembledArm) -> None:
        arm.move((NAN, NAN, NAN, 0.1, NAN), 1.0)
        plant.run(arm, 0.3)
        arm.move((NAN, NAN, NAN, NAN, 0.9), 1.0)
        assert arm.state().targets == pytest.approx((*START[:3], 0.1, 0.9), abs=1e-9)
        plant.run(arm, 1.5)
        assert arm.state().positions == pytest.approx((*START[:3], 0.1, 0.9), abs=3e-3)

    @pytest.mark.slow
    def test_turns_without_limit(self, plant: ServoPlant, arm: AssembledArm) -> None:
        turns = 3.0 * math.tau
        arm.move((NAN, NAN, NAN, NAN, turns), 0.0)
        plant.run(arm, 7.5)
        assert arm.state().positions[4] == pytest.approx(turns, abs=3e-3)

    def test_torques_stay_within_limits(self, plant: ServoPlant, arm: AssembledArm) -> None:
        arm.move((1.0, -0.8, 1.2, -0.5, 2.0), 0.0)
        torques = np.abs(np.array(plant.run(arm, 1.5)))
        assert np.all(torques <= np.array([13.0, 38.0, 20.0, 7.0, 7.0]))
        assert torques.max() > 10.0

    def test_follows_closely(self, plant: ServoPlant, arm: AssembledArm) -> None:
        arm.move((1.0, -0.5, 1.0, -0.5, 1.0), 1.5)
        errors = []
        for _ in range(150):
            plant.run(arm, 0.01)
            errors.append(np.abs(np.array(plant.positions) - arm._setpoints.setpoint.q).max())
        assert max(errors) < 0.015

    def test_hold_brakes_along_the_path_within_200_ms(self, plant: ServoPlant, arm: AssembledArm) -> None:
        target = (1.3, -0.6, 1.5, 1.4, 1.2)
        arm.move(target, 0.0)
        plant.run(arm, 0.4)
        arm.hold()
        plant.run(arm, 0.2)
        assert max(map(abs, plant.velocities)) < 0.1
        plant.run(arm, 0.5)
        assert max(map(abs, plant.velocities)) < 0.01
        assert not arm.state().moving
        # all joints have gone the same part of their ways
        parts = [(now - a) / (b - a) for now, a, b in zip(plant.positions, START, target, strict=True)]
        assert 0.05 < parts[0] < 0.95
        assert parts == pytest.approx([parts[0]] * 5, abs=0.01)
        assert arm.state().targets == pytest.approx(plant.positions, abs=3e-3)

    def test_a_new_motion_begins_from_the_present_one(self, plant: ServoPlant, arm: AssembledArm) -> None:
        arm.move((1.0, *START[1:]), 0.0)
        torques = plant.run(arm, 0.3)
        arm.move(START, 0.0)
        torques += plant.run(arm, 2.0)
        assert largest_jump(torques) < 0.1
        assert plant.positions == pytest.approx(START, abs=3e-3)

    def test_the_tip_is_where_the_model_says(self, plant: ServoPlant, arm: AssembledArm) -> None:
        arm.move((0.0,) * 5, 1.5)
        plant.run(arm, 2.5)
        height = 0.12 + 0.03 + 0.155 + 0.25 + 0.155 + 0.25 + 0.155 + 0.12
        pose = arm.state().tip_pose
        assert (pose.x, pose.y, pose.z) == pytest.approx((0.0, 0.0, height), abs=2e-3)


class TestRefusals:
    @pytest.mark.parametrize(
        ("positions", "duration", "text"),
        [
            ((0.0,) * 4, 1.0, "4 positions for 5 joints (servo_1, servo_2, servo_3, servo_4, servo_5)"),
            ((0.0, 0.0, math.inf, 0.0, 0.0), 1.0, "a position is infinite"),
            ((0.0,) * 5, math.inf, "a duration of inf s"),
            ((0.0,) * 5, -1.0, "a duration of -1.0 s"),
            ((3.0, *START[1:]), 0.2, "a duration of 0.2 s is too short: within the limits it takes"),
            ((0.0, 1e300, 0.0, 0.0, 0.0), 0.0, "no trajectory"),
        ],
    )
    def test_refuses_motions(
        self, plant: ServoPlant, arm: AssembledArm, positions: tuple[float, ...], duration: float, text: str
    ) -> None:
        arm.move(positions, duration)
        assert arm.state().error.startswith("motion refused: ")
        assert text in arm.state().error
        plant.run(arm, 0.2)
        assert not arm.state().moving
        assert plant.positions == pytest.approx(START, abs=1e-3)

    def test_refuses_what_a_module_is_too_weak_for(self) -> None:
        plant = ServoPlant((("servo_1", "wrist"), *FIVE[3:7], ("bracket_1", "bracket"), ("servo_5", "roll")))
        arm = plant.arm()
        plant.run(arm, 0.05)
        arm.move((1.5, 0.0, 0.0, 0.0), 0.0)
        assert "times the torque that a servo module has" in arm.state().error

    def test_a_success_clears_the_error(self, plant: ServoPlant, arm: AssembledArm) -> None:
        arm.move((1.0,), 1.0)
        arm.move(START, 1.0)
        assert arm.state().error == ""

    def test_a_refusal_ends_the_present_motion(self, plant: ServoPlant, arm: AssembledArm) -> None:
        arm.move((1.0, *START[1:]), 1.5)
        plant.run(arm, 0.5)
        arm.move((math.inf,) * 5, 1.0)
        plant.run(arm, 1.0)
        stopped = plant.positions[0]
        assert START[0] + 0.02 < stopped < 0.8
        assert not arm.state().moving
        assert arm.state().result is MotionResult.REFUSED
        plant.run(arm, 0.5)
        assert plant.positions[0] == pytest.approx(stopped, abs=1e-3)


class TestOrder:
    def test_by_names(self, plant: ServoPlant, arm: AssembledArm) -> None:
        arm.set_order(("servo_5", "servo_3", "servo_1"))
        state = arm.state()
        assert state.joints == ("servo_5", "servo_3", "servo_1", "servo_2", "servo_4")
        assert state.positions == pytest.approx((0.2, 0.5, 0.3, 0.4, 0.4), abs=1e-3)
        arm.move((NAN, NAN, 0.6, NAN, NAN), 1.0)
        plant.run(arm, 1.5)
        assert plant.positions == pytest.approx((0.6, *START[1:]), abs=3e-3)

    def test_found_again_by_attachments(self, arm: AssembledArm) -> None:
        arm.set_order(("servo_5",))
        arm.set_order(())
        assert arm.state().joints == ("servo_1", "servo_2", "servo_3", "servo_4", "servo_5")

    @pytest.mark.parametrize(
        ("order", "text"),
        [(("servo_1", "servo_9"), "no servo module 'servo_9'"), (("servo_1", "servo_1"), "named twice")],
    )
    def test_refuses_names(self, arm: AssembledArm, order: tuple[str, ...], text: str) -> None:
        arm.set_order(order)
        assert text in arm.state().error
        assert arm.state().joints == ("servo_1", "servo_2", "servo_3", "servo_4", "servo_5")


class TestSilence:
    def test_the_others_brake(self, plant: ServoPlant, arm: AssembledArm) -> None:
        arm.move((1.3, -0.6, 1.5, 1.4, 1.2), 0.0)
        plant.run(arm, 0.4)
        plant.servos["servo_4"].powered = False
        plant.run(arm, 0.2)
        others = [plant.velocities[at] for at in (0, 1, 2, 4)]
        assert max(map(abs, others)) < 0.15
        assert arm.state().error == "the motion ended early: no report of servo_4"
        plant.run(arm, 1.0)
        others = [plant.velocities[at] for at in (0, 1, 2, 4)]
        assert max(map(abs, others)) < 0.01
        assert not arm.state().moving

    def test_refuses_to_move_a_silent_module_but_moves_the_others(self, plant: ServoPlant, arm: AssembledArm) -> None:
        plant.servos["servo_5"].powered = False
        plant.run(arm, 0.1)
        arm.move((0.6, NAN, NAN, NAN, 1.0), 1.0)
        assert arm.state().error == "motion refused: no report of servo_5"
        arm.move((0.6, NAN, NAN, NAN, NAN), 1.0)
        assert arm.state().error == ""
        plant.run(arm, 1.5)
        assert plant.positions[0] == pytest.approx(0.6, abs=3e-3)

    def test_a_module_that_reports_again_holds_where_it_is(self, plant: ServoPlant, arm: AssembledArm) -> None:
        plant.servos["servo_4"].powered = False
        plant.run(arm, 0.2)
        sagged = plant.positions[3]
        assert sagged > START[3] + 0.02
        plant.servos["servo_4"].powered = True
        torques = plant.run(arm, 1.0)
        assert plant.positions[3] == pytest.approx(sagged, abs=0.2)
        assert plant.positions[3] == pytest.approx(arm.state().targets[3], abs=4e-3)
        assert abs(plant.velocities[3]) < 0.01
        assert largest_jump(torques) < 0.1


class TestAttachments:
    @pytest.mark.slow
    @pytest.mark.parametrize("controller", ArmController)
    def test_no_jump_of_torque_when_modules_come_and_go(self, controller: ArmController) -> None:
        plant = ServoPlant()
        plant.settle(START)
        arm = plant.arm()
        arm.set_controller(controller)
        torques = plant.run(arm, 3.0)[-1:]
        plant.connectors["tube_2/end"].release()
        torques = [torque[:3] for torque in torques] + plant.run(arm, 1.0)
        assert arm.state().joints == ("servo_1", "servo_2", "servo_3")
        assert largest_jump(torques[:3]) < 0.03
        assert largest_jump(torques) < 0.5  # what the springs let go is damped at once
        last = [torques[-1]]
        plant.connectors["tube_2/end"].attach("servo_4")
        torques = plant.run(arm, 1.0)
        assert arm.state().joints == ("servo_1", "servo_2", "servo_3", "servo_4", "servo_5")
        assert largest_jump(last + [torque[:3] for torque in torques[:3]]) < 0.03
        assert largest_jump(torques) < 0.5

    @pytest.mark.slow
    def test_no_jump_of_torque_when_the_controller_changes(self, plant: ServoPlant, arm: AssembledArm) -> None:
        torques = plant.run(arm, 0.2)
        arm.set_controller(ArmController.PID)
        torques += plant.run(arm, 1.0)
        arm.set_controller(ArmController.MODEL)
        torques += plant.run(arm, 1.0)
        assert largest_jump(torques) < 0.05

    @pytest.mark.slow
    def test_no_jump_of_torque_when_a_box_is_released_in_a_motion(self, plant: ServoPlant, arm: AssembledArm) -> None:
        plant.connectors["servo_5/output"].attach("box_1")
        plant.run(arm, 1.5)
        arm.move((NAN, -0.5, -0.4, -0.4, NAN), 0.0)
        torques = plant.run(arm, 0.4)
        plant.connectors["servo_5/output"].release()
        torques += plant.run(arm, 0.6)
        assert arm.state().payload == 0.0
        assert largest_jump(torques) < 0.2

    def test_a_motion_ends_when_the_arm_becomes_another_one(self, plant: ServoPlant, arm: AssembledArm) -> None:
        arm.move((1.3, *START[1:]), 0.0)
        plant.run(arm, 0.3)
        plant.connectors["tube_2/end"].release()
        plant.run(arm, 0.1)
        assert arm.state().error == "the motion ended early: modules were attached or released"
        plant.run(arm, 1.0)
        assert max(map(abs, plant.velocities)) < 0.02
        assert not arm.state().moving

    def test_modules_are_claimed_while_they_are_in_the_arm(self, plant: ServoPlant, arm: AssembledArm) -> None:
        assert plant.servos["servo_5"].claimed_by == "arm"
        plant.connectors["tube_2/end"].release()
        plant.run(arm, 0.01)
        assert plant.servos["servo_3"].claimed_by == "arm"
        assert plant.servos["servo_5"].claimed_by == ""
        assert plant.servos["servo_5"].held == 1

    def test_measured_offsets_are_in_the_model(self) -> None:
        offset = Transform(rotation_about((1.0, 0.0, 0.0), 0.02), (0.003, 0.0, 0.0))
        plant = ServoPlant()
        plant.assemble([name for name, _ in FIVE], {"tube_1/end": offset})
        plant.settle((0.0,) * 5)
        arm = plant.arm()
        plant.run(arm, 0.3)
        above = 0.155 + 0.25 + 0.155 + 0.12
        pose = arm.state().tip_pose
        assert (pose.x, pose.y) == pytest.approx((0.003, -above * math.sin(0.02)), abs=1e-3)

    def test_gravity_of_a_tilted_base(self) -> None:
        plant = ServoPlant()
        plant.settle((0.0,) * 5)
        arm = plant.arm()
        plant.run(arm, 0.05)
        upright = max(map(abs, plant.model.gravity(np.zeros(5))))
        arm._assembly.model.set_base(Transform(rotation_about((1.0, 0.0, 0.0), 1.0)))
        assert max(map(abs, arm._assembly.model.gravity(np.array([math.pi / 2, 0.0, 0.0, 0.0, 0.0])))) > upright + 1.0


class TestPayload:
    @pytest.mark.parametrize("mass", sampled([0.1, 0.5, 1.0], 1))
    def test_is_estimated_at_rest(self, mass: float) -> None:
        plant = ServoPlant(box_mass=mass)
        plant.settle(START)
        arm = plant.arm()
        plant.run(arm, 0.1)
        plant.connectors["servo_5/output"].attach("box_1")
        plant.run(arm, 1.5)
        assert arm.state().payload == pytest.approx(mass, rel=0.03, abs=0.02)
        plant.connectors["servo_5/output"].release()
        plant.run(arm, 0.01)
        assert arm.state().payload == 0.0

    def test_is_estimated_in_motion(self, plant: ServoPlant, arm: AssembledArm) -> None:
        plant.connectors["servo_5/output"].attach("box_1")
        plant.run(arm, 1.0)
        arm.move((1.0, -0.2, 1.0, 0.2, 0.0), 0.0)
        found = []
        for _ in range(20):
            plant.run(arm, 0.05)
            found.append(arm.state().payload)
        assert found == pytest.approx([0.5] * 20, rel=0.03, abs=0.02)

    @pytest.mark.slow
    def test_the_arm_does_not_sag_under_it(self, plant: ServoPlant, arm: AssembledArm) -> None:
        plant.connectors["servo_5/output"].attach("box_1")
        plant.run(arm, 2.0)
        assert plant.positions == pytest.approx(START, abs=2e-3)


class TestSteps:
    """With a strong module at both ends: from the tip on, servo_4 carries all others."""

    @pytest.fixture
    def plant(self) -> ServoPlant:
        plant = ServoPlant(tuple((name, "shoulder" if name == "servo_4" else kind) for name, kind in FIVE))
        plant.settle((0.3, 0.3, 0.9, 0.9, 0.2))
        return plant

    def step_over(self, plant: ServoPlant, arm: AssembledArm) -> list[list[float]]:
        """Grip platform_2 where the tip is now, then let platform_1 go."""
        tip = arm._assembly.model.tip_pose(np.array(plant.positions))
        plant.connectors["servo_5/output"].attach("platform_2", tip.inverse() @ Transform(position=(0.6, 0.0, 0.0)))
        torques = plant.run(arm, 0.5)
        plant.connectors["platform_1/top"].release()
        return torques[-1:]

    def test_closed_loop_refuses_motions(self, plant: ServoPlant, arm: AssembledArm) -> None:
        plant.connectors["servo_5/output"].attach("platform_2", IDENTITY)
        plant.run(arm, 0.2)
        arm.move((0.0,) * 5, 2.0)
        assert arm.state().error == "motion refused: the arm is also held by servo_5/output"

    def test_reversed_arm_holds_and_moves(self, plant: ServoPlant, arm: AssembledArm) -> None:
        before = self.step_over(plant, arm)
        turned = [torques[::-1] for torques in before]
        after = plant.run(arm, 0.5)
        state = arm.state()
        assert (state.base, state.tip) == ("servo_5/output", "")
        assert state.joints == ("servo_5", "servo_4", "servo_3", "servo_2", "servo_1")
        jumps = np.abs(np.diff(np.array(turned + after[:2]), axis=0)) / np.array([7.0, 38.0, 20.0, 38.0, 13.0])
        assert jumps.max() < 0.03
        assert plant.positions == pytest.approx((0.2, 0.9, 0.9, 0.3, 0.3), abs=0.03)
        assert plant.positions == pytest.approx(state.targets, abs=15e-3)

    def test_the_tip_of_a_reversed_arm_is_the_first_input_flange(self, plant: ServoPlant, arm: AssembledArm) -> None:
        self.step_over(plant, arm)
        plant.run(arm, 0.004)
        pose = arm.state().tip_pose
        assert (pose.x, pose.y, pose.z) == pytest.approx((0.0, 0.0, 0.0), abs=0.01)

    def test_names_keep_their_order_over_a_step(self, plant: ServoPlant, arm: AssembledArm) -> None:
        arm.set_order(("servo_1", "servo_2", "servo_3", "servo_4", "servo_5"))
        self.step_over(plant, arm)
        plant.run(arm, 0.01)
        assert arm.state().joints == ("servo_1", "servo_2", "servo_3", "servo_4", "servo_5")


def test_states_do_not_change_afterwards(plant: ServoPlant, arm: AssembledArm) -> None:
    before = arm.state()
    copy = tuple(before.positions)
    arm.move((0.0,) * 5, 1.0)
    plant.run(arm, 0.5)
    assert before.positions == copy


def test_same_commands_same_torques() -> None:
    def run() -> list[list[float]]:
        plant = ServoPlant()
        plant.settle(START)
        arm = plant.arm()
        plant.run(arm, 0.1)
        arm.move((0.5, 0.1, 0.8, 0.1, 1.0), 0.0)
        return plant.run(arm, 0.5)

    assert run() == run()
