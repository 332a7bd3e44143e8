"""Places, choices and sentences of the assembly, without a motion."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pinocchio as pin
import pytest
from hypothesis import given, settings, strategies as st
from tests.helpers.fake_cell import FakeCell

from jauspy.cell.assembly import MAX_SHIFT, MAX_TILT, Assembler
from jauspy.cell.frames import offset_between, shifted, tilt_between, transform, turned
from jauspy.cell.handling import TURNS
from jauspy.cell.interface import SeenPart
from jauspy.cell.motion import NoPath
from jauspy.cell.scene import Layout
from jauspy.cell.schedule import TaskFailed
from jauspy.cell.slots import FIVE_JOINTS, WHEEL_TURNS, AssemblyResult, PartResult, Slot, Tip
from jauspy.platform.modular.connector import ConnectorState

TOP = "platform_1/top"


@pytest.fixture(scope="module")
def assembler(layout: Layout) -> Assembler:
    return Assembler(FakeCell(layout), layout)


def tip(frame: pin.SE3) -> Tip:
    return Tip("platform_1/top", "platform_1", frame)


class TestGoals:
    @pytest.mark.parametrize(
        ("slot", "count"),
        [(FIVE_JOINTS[0], 4), (FIVE_JOINTS[1], 4), (FIVE_JOINTS[2], 1), (Slot("wheel", ("wheel",), ""), WHEEL_TURNS)],
    )
    def test_each_kind_of_part_may_be_turned_as_it_is_symmetric(
        self, assembler: Assembler, slot: Slot, count: int
    ) -> None:
        frame = shifted(0.6, 0.2, 0.2) * turned("z", 0.3)
        found = assembler.goals(slot, tip(frame))
        assert len(found) == count
        for number, goal in enumerate(found):
            distance, _ = offset_between(goal, frame)
            assert distance < 1e-12
            assert tilt_between(goal, frame) < 1e-6
            assert all(offset_between(goal, other)[1] > 0.5 for other in found[:number])

    def test_the_first_goal_is_square_to_the_base(self, assembler: Assembler) -> None:
        end = tip(shifted(0.6, 0.2, 0.2))
        end.advance("servo_1", "output", end.frame * turned("z", math.pi / 2.0), shifted(z=0.12))
        goal = assembler.goals(FIVE_JOINTS[2], end)[0]
        assert goal.rotation == pytest.approx(np.eye(3), abs=1e-9)


@given(st.lists(st.tuples(st.floats(-3.1, 3.1), st.floats(0.05, 0.3)), min_size=1, max_size=8))
def test_the_tip_stays_square_to_the_base_however_parts_are_turned(parts: list[tuple[float, float]]) -> None:
    base = shifted(0.6, 0.2, 0.2) * turned("z", 0.4)
    end, height = tip(base), 0.0
    for number, (turn, length) in enumerate(parts):
        end.advance(f"part_{number}", "output", end.frame * turned("z", turn), shifted(z=length))
        height += length
    assert end.connector == f"part_{len(parts) - 1}/output"
    assert offset_between(end.frame * end.square, base * shifted(z=height)) == pytest.approx((0.0, 0.0), abs=1e-6)


class TestJoined:
    @staticmethod
    def state(part: str, offset: pin.SE3 | None = None, error: str = "") -> ConnectorState:
        frame = transform(offset or pin.SE3.Identity())
        return ConnectorState(True, True, part, frame, 20.0, latched=not error, last_error=error)

    @given(share=st.floats(0.0, 0.9), lean=st.floats(0.0, 0.9), turn=st.floats(-3.1, 3.1))
    @settings(max_examples=25)
    def test_what_sits_within_the_limits_is_joined(
        self, assembler: Assembler, share: float, lean: float, turn: float
    ) -> None:
        offset = shifted(share * MAX_SHIFT) * turned("x", lean * MAX_TILT) * turned("z", turn)
        assert assembler._joined_wrongly(TOP, "servo_1", self.state("servo_1", offset)) == ""

    def test_what_is_not_locked_is_not_joined(self, assembler: Assembler) -> None:
        state = replace(self.state("servo_1"), latched=False)
        assert assembler._joined_wrongly(TOP, "servo_1", state) == "platform_1/top does not lock it"
        assert assembler._joined_wrongly("gripper", "servo_1", state) == ""

    @pytest.mark.parametrize(
        ("offset", "text"),
        [
            (shifted(0.003), "it sits 3.0 mm and 0.0 degrees off"),
            (turned("y", math.radians(3.0)), "it sits 0.0 mm and 3.0 degrees off"),
        ],
    )
    def test_what_sits_badly_is_described(self, assembler: Assembler, offset: pin.SE3, text: str) -> None:
        assert assembler._joined_wrongly(TOP, "servo_1", self.state("servo_1", offset)) == text

    def test_another_part_or_none_is_named(self, assembler: Assembler) -> None:
        assert assembler._joined_wrongly(TOP, "servo_1", self.state("bracket_1")) == "the connector holds bracket_1"
        assert assembler._joined_wrongly(TOP, "servo_1", self.state("")) == "the connector holds nothing"
        assert assembler._joined_wrongly(TOP, "servo_1", self.state("", error="leaks")) == "leaks"


class TestChoice:
    @pytest.fixture
    def own(self, layout: Layout) -> Assembler:
        made = Assembler(FakeCell(layout), layout)
        names = layout.of_types(FIVE_JOINTS[0].types)
        made.seen = {name: SeenPart(layout.type_of(name).name, pin.SE3.Identity()) for name in names}
        return made

    def test_the_best_type_comes_first(self, own: Assembler, layout: Layout) -> None:
        slot = FIVE_JOINTS[0]
        first = own._choose(slot)
        assert first == layout.of_types(slot.types)[0]
        assert layout.type_of(first).name == slot.types[0]

    def test_rejected_used_and_unseen_parts_are_left(self, own: Assembler, layout: Layout) -> None:
        slot, names = FIVE_JOINTS[0], layout.of_types(FIVE_JOINTS[0].types)
        own.rejected.add(names[0])
        assert own._choose(slot) == names[1]
        own.used.add(names[1])
        expected = names[2] if len(names) > 2 else None
        assert own._choose(slot) == expected
        own.seen = {}
        assert own._choose(slot) is None

    async def test_without_a_part_the_reason_is_named(self, layout: Layout) -> None:
        cell = FakeCell(layout)
        cell.hidden |= set(layout.of_types(FIVE_JOINTS[0].types))
        made = Assembler(cell, layout)
        with pytest.raises(
            TaskFailed, match="no x5_9_inline or x5_4_inline could be grasped for joint 1: none is left"
        ):
            await made.fetch(FIVE_JOINTS[0], PartResult("joint 1"), [])


class TestChecks:
    async def test_a_joint_without_power_is_named_after_three_seconds(self, layout: Layout) -> None:
        cell = FakeCell(layout)
        with pytest.raises(
            TaskFailed, match=r"servo_1 was joined, but is not a joint of the arm 3 s later; has it power\?"
        ):
            await Assembler(cell, layout)._check_joint("servo_1")
        assert 3.0 < cell.time < 3.5

    async def test_a_joint_is_turned_to_and_fro_and_others_stay(self, layout: Layout) -> None:
        cell = FakeCell(layout)
        cell.attached = {
            "platform_1/top": ("servo_1", pin.SE3.Identity()),
            "servo_1/output": ("servo_2", pin.SE3.Identity()),
        }
        await Assembler(cell, layout)._check_joint("servo_2")
        assert cell.log == ["move [None, 0.06]", "move [None, 0.0]"]

    async def test_what_is_no_servo_is_not_turned(self, layout: Layout) -> None:
        cell = FakeCell(layout)
        await Assembler(cell, layout)._check_joint("bracket_1")
        assert cell.log == []
        assert cell.time == 0.0

    async def test_a_base_that_nobody_sees_is_named(self, layout: Layout) -> None:
        with pytest.raises(TaskFailed, match="the sensor does not see platform_9, on which the arm is to be built"):
            await Assembler(FakeCell(layout), layout)._base_pose("platform_9")


def test_retries_are_the_attempts_of_all_parts() -> None:
    result = AssemblyResult(
        "platform_1", [PartResult("a", attempts=["one", "two"]), PartResult("b", attempts=["three"])]
    )
    assert result.retries == 3
    assert result.clearance.distance == 1.0


class TestPartsThatLieTurnedOver:
    """Parts in the air over the floor, beside the UR10."""

    START = np.array([0.0, -1.9, 2.1, -1.77, -1.57, 0.0])

    @staticmethod
    def lying(layout: Layout, part: str, face: int) -> pin.SE3:
        """The part with one of the faces up by which the gripper can hold it."""
        up = pin.SE3(turned("x", math.pi).rotation, np.array([-0.1, 0.65, 0.6]))
        return up * pin.SE3(layout.grasps(part)[face].inverse().rotation, np.zeros(3))

    @pytest.mark.parametrize("part", ["servo_1", "servo_2", "tube_1", "bracket_1", "bracket_3"])
    def test_they_are_held_by_the_face_that_is_up(self, layout: Layout, part: str) -> None:
        handling = Assembler(FakeCell(layout), layout).handling
        for face, grasp in enumerate(layout.grasps(part)):
            pose = self.lying(layout, part, face)
            found = handling.upper_grasps(part, pose)
            assert all(turned.translation == pytest.approx(grasp.translation) for turned in found)
            assert all((pose * turned).rotation[2, 2] == pytest.approx(-1.0) for turned in found)
            assert len(found) == TURNS

    def test_one_on_its_side_is_picked(self, layout: Layout) -> None:
        ur10 = Assembler(FakeCell(layout), layout)
        pose = self.lying(layout, "servo_1", 2)
        ur10.scene.put("servo_1", ur10.handling.pieces("servo_1"), pose)
        plan = ur10.handling.pick("servo_1", pose, self.START)
        assert plan.grasp.translation == pytest.approx(layout.grasps("servo_1")[2].translation)

    def test_what_has_no_face_up_is_left_and_said_so(self, layout: Layout) -> None:
        ur10 = Assembler(FakeCell(layout), layout)
        pose = self.lying(layout, "wheel_1", 0) * turned("x", math.pi)
        with pytest.raises(NoPath, match="wheel_1 lies turned over: no face"):
            ur10.handling.pick("wheel_1", pose, self.START)
