"""The task to assemble an arm, in a cell that fails when it is told to."""

from __future__ import annotations

from collections import Counter
from typing import Any

import pytest
from tests.helpers.fake_cell import FakeCell

from jauspy.cell.assembly import GRASPS, Assembler
from jauspy.cell.interface import GRIPPER
from jauspy.cell.motion import Path
from jauspy.cell.scene import Layout
from jauspy.cell.session import Session
from jauspy.cell.slots import FIVE_JOINTS, AssemblyResult, Slot
from jauspy.cell.tasks import assemble
from jauspy.errors import RequestError

TWO = FIVE_JOINTS[:2]


@pytest.fixture
def cell(layout: Layout) -> FakeCell:
    return FakeCell(layout)


async def build(cell: FakeCell, slots: tuple[Slot, ...] = TWO) -> AssemblyResult:
    return await Assembler(cell, cell.layout).build(slots=slots)


def parts(result: AssemblyResult) -> list[str]:
    return [each.part for each in result.parts]


@pytest.mark.slow
async def test_the_first_joints_are_built(cell: FakeCell) -> None:
    result = await build(cell)
    assert result.failure == ""
    assert parts(result) == ["servo_1", "bracket_1"]
    assert result.retries == 0
    assert result.clearance.distance > 0.005
    assert {name: held for name, (held, _) in cell.attached.items()} == {
        "platform_1/top": "servo_1",
        "servo_1/output": "bracket_1",
    }
    assert "check joint 1" in [each.action for each in result.timeline.entries]
    assert cell.log, "the new joint was moved"


@pytest.mark.slow
async def test_a_grasp_that_fails_is_tried_again(cell: FakeCell) -> None:
    cell.fails = lambda connector, part: "no vacuum" if connector == GRIPPER and cell.starts[GRIPPER] == 1 else ""
    result = await build(cell, TWO[:1])
    assert result.failure == ""
    assert result.parts[0].attempts == ["servo_1: no vacuum"]


@pytest.mark.slow
async def test_a_part_that_cannot_be_grasped_is_replaced(cell: FakeCell) -> None:
    cell.fails = lambda connector, part: "no vacuum" if (connector, part) == (GRIPPER, "bracket_1") else ""
    result = await build(cell)
    assert result.failure == ""
    assert parts(result) == ["servo_1", "bracket_2"]
    assert len(result.parts[1].attempts) == GRASPS


@pytest.mark.slow
async def test_a_dropped_part_is_replaced(cell: FakeCell) -> None:
    count = Counter[str]()

    def drops(part: str) -> bool:
        count[part] += 1
        return part == "bracket_1" and count[part] == 3  # it was touched and lifted, and is carried

    cell.drops = drops
    result = await build(cell)
    assert result.failure == ""
    assert "dropped on the way" in " ".join(result.parts[1].attempts)
    assert parts(result)[1] == "bracket_2"


@pytest.mark.slow
async def test_a_connector_that_does_not_attach_is_tried_beside_and_then_with_another_part(cell: FakeCell) -> None:
    cell.fails = lambda connector, part: "not aligned" if (connector, part) == ("servo_1/output", "bracket_1") else ""
    result = await build(cell)
    assert result.failure == ""
    assert parts(result)[1] == "bracket_2"
    assert sum("not aligned" in each for each in result.parts[1].attempts) >= 2


@pytest.mark.slow
async def test_a_hidden_part_is_not_looked_for(cell: FakeCell) -> None:
    cell.hidden.add("bracket_1")
    result = await build(cell)
    assert parts(result)[1] == "bracket_2"


@pytest.mark.slow
async def test_without_any_part_it_ends_with_the_reason_and_at_rest(cell: FakeCell, layout: Layout) -> None:
    cell.hidden |= set(layout.of_types(("bracket_straight",)))
    result = await build(cell)
    assert result.failure == "no bracket_straight could be grasped for bracket: none is left"
    assert GRIPPER not in cell.attached
    assert cell.attached["platform_1/top"][0] == "servo_1", "what was built stays"


@pytest.mark.slow
async def test_equal_seeds_give_equal_results(layout: Layout) -> None:
    one, other = await build(FakeCell(layout)), await build(FakeCell(layout))
    assert repr(one) == repr(other)


@pytest.mark.slow
async def test_parts_that_were_joined_are_counted_without_true_poses(layout: Layout) -> None:
    found = await assemble(Session(FakeCell(layout), layout), 0)
    assert found.success, found.failure
    assert found.values["parts"] == 8.0


@pytest.mark.parametrize("why", ["Blocked: wrist_1, 6 N m, 0.05 rad short; 201.1.10 holds where it is", ""])
async def test_a_gripper_that_is_stopped_as_it_withdraws_goes_on_once(
    cell: FakeCell, monkeypatch: pytest.MonkeyPatch, why: str
) -> None:
    ur10, follow, starts = Assembler(cell, cell.layout), cell.follow, []

    async def stopped(path: Path, **options: Any) -> None:
        starts.append(path.points[0])
        if len(starts) == 1:
            raise RequestError(why or "no reply")
        await follow(path, **options)

    async def blocked() -> str:
        return why

    monkeypatch.setattr(cell, "follow", stopped)
    monkeypatch.setattr(cell, "blocked", blocked)
    if why:
        await ur10._withdraw()
        assert len(starts) == 2
    else:
        with pytest.raises(RequestError, match="no reply"):
            await ur10._withdraw()
