"""Standby, Emergency and the loss of control are quick stops on the CAN bus within 50 ms."""

from __future__ import annotations

from collections.abc import Callable

import can
import pytest
from tests.robot.test_stopping import ENDS, Cell, tell

pytest.importorskip("canopen", reason="canopen is not installed")

from jauspy.backends.can import pdo
from jauspy.backends.can.cia402 import Controlword
from jauspy.backends.can.robot import CanRobot
from jauspy.messages.core import Standby
from jauspy.messages.mobility import SetWrenchEffort

LIMIT = 0.05
COMMANDS = {each.cob_id for each in pdo.COMMANDS.values()}


@pytest.mark.parametrize(
    "end",
    [
        pytest.param(ENDS["emergency"], id="emergency"),
        pytest.param(ENDS["release"], id="release", marks=pytest.mark.slow),
        pytest.param(ENDS["silence"], id="silence", marks=pytest.mark.slow),
        pytest.param(tell(Standby()), id="standby"),
    ],
)
def test_tracks_get_a_quick_stop_within_50_ms(end: Callable[[Cell], None]) -> None:
    cell = Cell("can", "inc1", 102)
    robot = cell.robot
    assert isinstance(robot, CanRobot)
    assert robot.virtual_bus is not None
    cell.obey(SetWrenchEffort(propulsive_linear_effort_x=60.0), 0.5)
    stopped: set[int] = set()

    def watch(message: can.Message, from_robot: bool) -> None:
        node = message.arbitration_id & 0x7F
        if from_robot and message.arbitration_id - node in COMMANDS and message.data[0] == Controlword.QUICK_STOP:
            stopped.add(node)

    robot.virtual_bus.watch = watch
    end(cell)
    begin = cell.now
    while cell.now < begin + LIMIT:
        cell.step()
    in_time = set(stopped)
    robot.close()
    tracks = {drive.setup.node for drive in robot.drives.values() if drive.setup.track}
    assert tracks <= in_time
