"""What `--also` says: robot, number and place, with errors of their own; and the place behind the robot before it."""

from __future__ import annotations

import math

import pytest

from jauspy.errors import ConfigError
from jauspy.geometry.poses import Pose
from jauspy.robot.robot_files import load
from jauspy.robot.several import further_robots, shared_backends

INC1 = load("inc1")


@pytest.mark.parametrize(
    ("text", "subsystem", "start"),
    [
        ("inc1", 102, None),
        ("inc1:150", 150, None),
        ("inc1:150@-3,0.5", 150, Pose(x=-3.0, y=0.5)),
        ("inc1@1,2,90", 102, Pose(x=1.0, y=2.0, yaw=math.pi / 2)),
        ("rover", load("rover").subsystem, None),
    ],
)
def test_further_robots(text: str, subsystem: int, start: Pose | None) -> None:
    (found,) = further_robots(INC1, [text])
    assert (found.config.subsystem, found.start) == (subsystem, start)


def test_numbers_are_counted_up_and_errors_of_sensors_differ() -> None:
    found = further_robots(INC1, ["inc1", "inc1", "inc1:110"])
    assert [other.config.subsystem for other in found] == [102, 103, 110]
    seeds = [INC1.localization.seed, *(other.config.localization.seed for other in found)]
    assert len(set(seeds)) == 4
    assert len({INC1.lidars[0].seed, *(other.config.lidars[0].seed for other in found)}) == 4


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("inc1:101", "subsystem 101 is that of another robot"),
        ("inc1:0", "'0' is no subsystem"),
        ("inc1:65535", "numbers are 1..65534"),
        ("inc1:", "'' is no subsystem"),
        ("inc1:x", "'x' is no subsystem"),
        (":102", "names no robot"),
        ("", "names no robot"),
        ("inc1@", "is no place"),
        ("inc1@1", "is no place"),
        ("inc1@1,2,3,4", "is no place"),
        ("inc1@nan,0", "is no place"),
        ("inc1@1e9,0", "starts within"),
        ("nobody:102", "nobody"),
    ],
)
def test_wrong_texts_are_refused_with_the_option(text: str, message: str) -> None:
    with pytest.raises(ConfigError, match=message):
        further_robots(INC1, [text])


def test_audit_logs_have_files_of_their_own(tmp_path) -> None:
    path = tmp_path / "logged.toml"
    path.write_text('extends = "inc1"\noperators = "operators.toml"\naudit_log = "log/audit.jsonl"\n')
    (found,) = further_robots(INC1, [f"{path}:102"])
    assert found.config.audit_log is not None
    assert found.config.audit_log.endswith("log/audit-102.jsonl")


def test_robots_start_behind_each_other_unless_they_are_placed() -> None:
    others = further_robots(INC1, ["inc1", "inc1@4,0,180", "inc1"])
    backends = shared_backends(INC1, others, "kinematic")
    poses = [backend.open(None, "empty").drive.pose() for backend in backends]  # type: ignore[arg-type]
    assert poses[0] == Pose()
    assert poses[1].x == pytest.approx(-2.35, abs=0.05)
    assert (poses[2].x, abs(poses[2].yaw)) == pytest.approx((4.0, math.pi))
    assert poses[3].x == pytest.approx(6.35, abs=0.05), "behind one that looks the other way"


def test_a_backend_with_one_robot_is_refused() -> None:
    with pytest.raises(ConfigError, match="the backend 'can' has one robot in a world"):
        shared_backends(INC1, further_robots(INC1, ["inc1"]), "can")
