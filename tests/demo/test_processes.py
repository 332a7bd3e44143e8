"""Checks before the demo starts processes, and the output of the robot's process."""

import math
from dataclasses import replace
from pathlib import Path

import pytest
from tests.helpers.robot import described
from typer.testing import CliRunner

from jauspy.backends.kinematic import KinematicRobot
from jauspy.cli import demo as processes
from jauspy.cli.demo import _whole_tour
from jauspy.cli.main import app
from jauspy.cli.up import print_truth
from jauspy.demo import judge, plan
from jauspy.demo.judge import Place, RobotOutput, touched, true_place
from jauspy.errors import ConfigError, RequestError
from jauspy.geometry.poses import PlanarPose
from jauspy.platform.contract import Snapshot
from jauspy.platform.localization import LocalizationSetup

SIZE = (640, 480)


def test_missing_package_is_named(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(processes, "find_spec", lambda name: None if name in ("av", "matplotlib") else object())
    with pytest.raises(ConfigError, match=r"needs PyAV, matplotlib: pip install 'jauspy\[all\]'; --backend kinematic"):
        _whole_tour(tmp_path, SIZE)


def test_file_in_place_of_the_output_folder_is_an_error(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(processes, "find_spec", lambda _: object())
    (tmp_path / "out").touch()
    with pytest.raises(ConfigError, match=r"out: cannot be created: File exists; choose another"):
        _whole_tour(tmp_path / "out", SIZE)


def test_unsupported_size_error_lists_the_sizes() -> None:
    done = CliRunner().invoke(app, ["demo", "--size", "641x480"])
    assert done.exit_code == 2
    assert "640x480" in done.stderr


@pytest.mark.parametrize(
    ("options", "says"),
    [
        (("--world", "house"), "'house' is not one of yard, street"),
        (("--world", "street", "--backend", "kinematic"), "needs physics"),
    ],
)
def test_world_without_a_plan_or_physics_is_an_error(options: tuple[str, ...], says: str, tmp_path: Path) -> None:
    done = CliRunner().invoke(app, ["demo", *options, "--output", str(tmp_path)])
    assert done.exit_code != 0
    assert says in " ".join((done.stderr + str(done.exception)).replace("│", " ").split())


async def test_robot_process_counters_are_read() -> None:
    output = RobotOutput()
    for line in ("counters of inc1:", "  101.1.102.endpoint.sent  7", "  realtime.late    3", "  realtime.steps  120"):
        output.line(line)
    assert await output.counters() == {"realtime.late": 3, "realtime.steps": 120}


def test_drive_is_judged_by_the_true_pose() -> None:
    output = RobotOutput()
    output.line("true pose of inc1: x +2.100 m  y -0.050 m  z +0.001 m  yaw +91.00°  pitch -0.50°  roll +0.10°")
    place, goals = output.true_place, plan.PLANS["yard"]
    assert place is not None
    assert place.pose == pytest.approx((2.1, -0.05, math.radians(91.0)))
    assert place.pitch == pytest.approx(math.radians(-0.5))
    assert true_place(place, goals).reached
    assert not true_place(replace(place, pose=place.pose._replace(x=2.4)), goals).reached
    assert not true_place(replace(place, pose=place.pose._replace(yaw=1.3)), goals).reached


def test_arm_that_touches_the_table_fails() -> None:
    output, goals = RobotOutput(), plan.PLANS["yard"]
    output.line('contacts of inc1: {"arm": {"can": 900, "table": 3}, "flippers": {"world": 20}}')
    assert output.contacts is not None
    found = touched(output.contacts, goals)
    assert not found.reached
    assert found.figures == {"support_contacts": 3, "thing_contacts": 900}
    assert "touched the table in 3 samples" in found.measured
    clear = touched({"arm": {"can": 900}}, goals)
    assert clear.reached
    assert clear.measured == "arm and gripper never touched the table, and touched the can in 900 samples"
    assert [each.stage for each in output.results(goals)] == ["contacts"]
    assert RobotOutput().results(goals) == []


def test_robot_that_did_not_get_over_the_kerb_fails() -> None:
    goals = plan.PLANS["street"]
    there = PlanarPose(goals.goal.x, goals.goal.y, goals.goal.heading)
    assert true_place(Place(there, 0.101), goals).reached
    assert not true_place(Place(there, 0.0), goals).reached


def test_true_pose_is_printed_where_the_robot_does_not_know_it(capsys: pytest.CaptureFixture[str]) -> None:
    model = described("inc1")[1]
    for exact, printed in ((True, 0), (False, 1)):
        robot = KinematicRobot(replace(model, localization=LocalizationSetup(source="exact" if exact else "sensors")))
        print_truth("inc1", Snapshot.of(robot))
        output = RobotOutput()
        lines = capsys.readouterr().err.splitlines()
        assert len(lines) == printed
        for line in lines:
            output.line(line)
        assert (output.true_place is not None) == (not exact)


async def test_missing_counters_raise_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(judge, "COUNTERS_TIMEOUT", 0.1)
    with pytest.raises(RequestError, match="does not print its counters"):
        await RobotOutput().counters()
