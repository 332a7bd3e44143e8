"""The panel Conveyor: its texts, what lies on a belt, and the belt that stops when its operator has gone."""

from __future__ import annotations

import asyncio

import pytest
from hypothesis import given, strategies as st
from tests.robot.test_cell_modules import world

from jauspy.console.manipulators import CONVEYOR, operated
from jauspy.console.operation import Operation
from jauspy.console.panels.conveyor import MAX_ITEMS, belt_state, belt_text, items, items_text
from jauspy.console.world import known_cell
from jauspy.geometry.poses import Pose, Transform
from jauspy.messages.cell import ReportConveyorState, SetConveyorSpeed
from jauspy.platform.modular.parts import ConveyorSetup

BELT = ConveyorSetup(Pose(1.0, 0.0, 0.2, 0.0, 0.0, 1.5707963), 2.0, 0.6, 0.5)
"""It goes along y of the world, from -1 to 1 m."""


def at(x: float, y: float, z: float) -> Transform:
    return Transform(position=(x, y, z))


def test_what_lies_on_a_belt_is_named_in_the_order_in_which_it_leaves() -> None:
    poses = {
        "first": at(1.0, 0.9, 0.2),
        "last": at(1.2, -0.9, 0.22),
        "beside": at(1.4, 0.0, 0.2),
        "past": at(1.0, 1.1, 0.2),
        "below": at(1.0, 0.0, 0.1),
        "held": at(1.0, 0.0, 0.9),
    }
    found = items(BELT, poses)
    assert [name for name, _ in found] == ["first", "last"]
    assert [place for _, place in found] == pytest.approx([1.9, 0.1])
    assert items_text(found) == "on it: first at 1.90 m, last at 0.10 m"
    assert items_text([]) == "nothing on it"
    assert items_text([(f"box_{number}", 1.0) for number in range(MAX_ITEMS + 3)]).endswith(" and 3 more")


@given(st.floats(-1.0, 1.0), st.floats(-0.3, 0.3))
def test_a_part_on_the_belt_is_between_its_ends(along: float, across: float) -> None:
    ((_, place),) = items(BELT, {"box": at(1.0 + 0.999 * across, 0.999 * along, 0.2)})
    assert 0.0 <= place <= BELT.length


def test_names_from_the_network_are_printable() -> None:
    assert items_text([("box\x1b[31m", 1.0)]) == items_text([("box\x1b[31m", 1.0)]).replace("\x1b", "")


@pytest.mark.parametrize(
    ("report", "text"),
    [
        (ReportConveyorState(0.0, 0.0, -0.0, 0.5), "stands, moved 0.00 m"),
        (ReportConveyorState(0.1, 0.1, 1.234, 0.5), "0.10 m/s forward, moved 1.23 m"),
        (ReportConveyorState(-0.1, -0.1, 1.0, 0.5), "0.10 m/s backward, moved 1.00 m"),
        (ReportConveyorState(0.3, 0.1, 1.0, 0.5), "0.10 m/s forward, to be 0.30 m/s, moved 1.00 m"),
        (ReportConveyorState(), "stands, moved 0.00 m"),
    ],
)
def test_the_motion_of_a_belt_as_text(report: ReportConveyorState, text: str) -> None:
    assert belt_text(report) == text


def test_the_belt_of_a_robot_whose_file_is_here_is_known() -> None:
    cell = known_cell("cell", ())
    assert cell is not None
    assert cell.conveyor is not None
    assert known_cell("nobody", ()) is None


async def test_the_operator_runs_the_belt_and_it_stops_when_he_has_gone() -> None:
    async with world() as cell:
        robot = await cell.ocu.discover(201)
        (id,) = (str(component.id) for component in robot.components if component.find(CONVEYOR))
        assert id in operated(robot)
        belt = robot.component(id).service(CONVEYOR)
        operation = Operation(robot, lambda _: None)
        await belt.send(SetConveyorSpeed(0.2), ack=True)
        await asyncio.sleep(0.2)
        assert (await belt_state(belt)).commanded_speed == 0.0, "nobody operates it"
        assert await operation.take("page", 127) == ""
        await belt.send(SetConveyorSpeed(0.2), ack=True)
        await asyncio.sleep(0.2)
        report = await belt_state(belt)
        assert (report.commanded_speed, report.max_speed) == pytest.approx((0.2, 0.5))
        assert cell.robot.conveyor.state().speed == pytest.approx(0.2)
        await operation.release("page")
        await asyncio.sleep(0.5)
        assert cell.robot.conveyor.state().speed == 0.0
