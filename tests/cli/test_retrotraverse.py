"""`jauspy retrotraverse` on a robot that has driven before."""

import json
import re

import pytest
from tests.helpers.command_line import jauspy, robot_in_thread

from jauspy import sync


@pytest.fixture(scope="module")
def robot():
    with robot_in_thread() as running:
        yield running


@pytest.mark.slow
def test_robot_comes_back_and_says_where_it_is(robot):
    with sync.OCU("42.1.1", robot.local) as ocu:
        found = ocu.robot(101)
        with found.control("drive"):
            found.drive(linear=0.8, seconds=3.0)
        out = found.pose().x
    assert out > 1.5
    result = jauspy("retrotraverse", "101", "1", "--speed", "0.6", "--connect", robot.local, "--json", status=0)
    row = json.loads(result.stdout)
    assert row["x"] == pytest.approx(out - 1.0, abs=0.25)
    assert (row["driven"], row["asked"], row["ended_by"]) == (pytest.approx(1.0, abs=0.01), 1.0, "distance")
    result = jauspy("retrotraverse", "101", "100", "--connect", robot.local, status=1)
    said = (
        r"the robot drove (\d\.\d\d) m back, not 100 m: the path that it keeps begins there, at x -?0\.\d\d m, y .* m\n"
    )
    found = re.fullmatch(said, result.stdout)
    assert found
    assert float(found[1]) == pytest.approx(out - 1.0, abs=0.3)
