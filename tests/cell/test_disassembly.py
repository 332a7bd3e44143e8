"""Taking arms apart, in a cell that fails when it is told to."""

from __future__ import annotations

import numpy as np
import pinocchio as pin
import pytest
from tests.helpers.fake_cell import FakeCell

from jauspy.cell.assembly import Assembler
from jauspy.cell.disassembly import ROOM, Disassembler
from jauspy.cell.frames import se3_of_pose, turned
from jauspy.cell.interface import GRIPPER
from jauspy.cell.scene import Layout, connector_frame
from jauspy.cell.schedule import TaskFailed
from jauspy.cell.standing import Joined

BASE = "platform_1/top"
PARTS = ("servo_1", "bracket_1", "servo_2")
FACING = turned("z", np.pi)
"""The parts face the UR10."""


@pytest.fixture
def cell(layout: Layout) -> FakeCell:
    """An arm of three parts stands on the platform."""
    made = FakeCell(layout)
    connector, frame = BASE, made.poses["platform_1"] * connector_frame(layout.type_of("platform_1"), "top")
    for part in PARTS:
        offset = FACING if part == PARTS[0] else pin.SE3.Identity()
        made.poses[part] = frame * offset
        made.attached[connector], made.enabled[connector] = (part, offset), 1
        connector, frame = f"{part}/output", made.poses[part] * connector_frame(layout.type_of(part), "output")
    return made


def disassembler(cell: FakeCell) -> Disassembler:
    return Disassembler(cell, cell.layout, Assembler(cell, cell.layout))


@pytest.mark.slow
async def test_an_arm_is_taken_apart_from_its_tip(cell: FakeCell) -> None:
    result = await disassembler(cell).run(BASE)
    assert [row.part for row in result.parts] == list(PARTS[::-1])
    assert [line for line in cell.log if line.startswith("leave")] == [f"leave {part}" for part in PARTS[::-1]]
    assert result.retries == 0
    assert result.put_down == []
    assert cell.attached == {}
    for part in cell.layout.setup.parts:
        if part.name in PARTS:
            off = cell.poses[part.name].translation - se3_of_pose(part.pose).translation
            assert float(np.linalg.norm(off)) < 0.01, f"{part.name} is back in its place"


async def test_a_branch_is_taken_off_before_what_carries_it(forked: Layout, monkeypatch: pytest.MonkeyPatch) -> None:
    order = []

    async def note(_self: Disassembler, item: Joined, _frame: pin.SE3) -> None:
        order.append((item.connector, item.part))

    monkeypatch.setattr(Disassembler, "_take_off", note)
    cell = FakeCell(forked)
    held = {BASE: "bracket_1", "bracket_1/output": "servo_1", "servo_1/output": "tube_1", "bracket_1/side": "servo_2"}
    cell.attached |= {name: (part, pin.SE3.Identity()) for name, part in held.items()}
    await disassembler(cell).run(BASE)
    assert order == [
        ("bracket_1/side", "servo_2"),
        ("servo_1/output", "tube_1"),
        ("bracket_1/output", "servo_1"),
        (BASE, "bracket_1"),
    ]


async def test_a_place_that_is_taken_is_avoided(cell: FakeCell) -> None:
    home = se3_of_pose(next(part.pose for part in cell.layout.setup.parts if part.name == "servo_2"))
    cell.poses["box_1"] = pin.SE3(np.eye(3), home.translation + np.array([0.0, 0.0, -0.05]))
    made = disassembler(cell)
    await made.ur10.look()
    made.ur10.scene.remove("servo_2")
    pieces = made.ur10.handling.pieces("servo_2")
    bins = [bin.name for bin in cell.layout.setup.bins]
    places = list(made.places("servo_2"))
    with made.ur10.scene.without(*bins):
        assert made.ur10.scene.clearance_of(pieces, home).distance < ROOM
        assert all(made.ur10.scene.clearance_of(pieces, place).distance >= ROOM for place in places)


@pytest.mark.slow
async def test_a_grasp_that_fails_is_tried_again_and_the_part_stays(cell: FakeCell) -> None:
    cell.fails = lambda connector, part: "no vacuum" if connector == GRIPPER and cell.starts[GRIPPER] == 1 else ""
    result = await disassembler(cell).run(BASE)
    assert result.parts[0].attempts == ["no vacuum"]
    assert cell.attached == {}


@pytest.mark.slow
async def test_a_gripper_that_never_holds_releases_nothing(cell: FakeCell) -> None:
    cell.fails = lambda connector, part: "no vacuum" if connector == GRIPPER else ""
    with pytest.raises(TaskFailed, match="servo_2 cannot be taken off bracket_1/output: no vacuum"):
        await disassembler(cell).run(BASE)
    assert [part for part, _ in cell.attached.values()] == list(PARTS)


async def test_without_an_arm_there_is_nothing_to_take_apart(layout: Layout) -> None:
    with pytest.raises(TaskFailed, match="nothing stands on platform_1/top"):
        await disassembler(FakeCell(layout)).run(BASE)
