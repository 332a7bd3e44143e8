"""Left and right: what people read has the axes of REP-103; fields of messages have those of JAUS, and say so."""

from __future__ import annotations

import json

import pytest
from tests.helpers.command_line import jauspy

from jauspy.cli import console
from jauspy.cli.query import has_axes
from jauspy.cli.up_table import _motion
from jauspy.geometry.poses import UNACCELERATED, Pose, Twist
from jauspy.messages.core import ReportStatus
from jauspy.messages.mobility import ReportLocalPose, ReportTravelSpeed, ReportVelocityState
from jauspy.platform.contract import Snapshot
from jauspy.sync import OCU
from jauspy.sync.portal import Portal


def test_fields_with_sides_are_labelled():
    assert has_axes(ReportLocalPose(x=1.0))
    assert has_axes(ReportVelocityState())
    assert not has_axes(ReportTravelSpeed(1.0))
    assert not has_axes(ReportStatus(ReportStatus.Status.READY, 0))


@pytest.fixture
def running(node_manager):
    """A robot beside the test."""
    with Portal("robot") as portal:
        robot = node_manager.robot()
        yield portal.run(robot.__aenter__())
        portal.run(robot.__aexit__(None, None, None))


@pytest.mark.slow
def test_tf_has_y_to_the_left_and_query_says_that_it_has_not(node_manager, running, monkeypatch):
    with OCU("42.1.1", node_manager.local) as ocu:
        robot = ocu.robot(101)
        with robot.control("drive"):
            robot.drive(linear=0.4, angular=0.6, seconds=1.5)
        pose = robot.pose()
    where = ("--connect", node_manager.local)
    frame = json.loads(jauspy("tf", "local", "base_link", "--json", *where).stdout)
    report = json.loads(jauspy("query", "101.1.102", "QueryLocalPose", *where).stdout)
    monkeypatch.setattr(console, "is_terminal", lambda: True)
    text = jauspy("query", "101.1.102", "QueryLocalPose", *where).stdout
    assert pose.y > 0.02
    assert frame["axes"] == "REP-103"
    assert frame["position"][1] == pytest.approx(pose.y, abs=0.02)
    assert report["axes"] == "JAUS"
    assert report["fields"]["y"] == pytest.approx(-pose.y, abs=0.02)
    assert "axes of JAUS: x forward, y right, z down" in text


def test_table_of_up_has_y_to_the_left():
    snapshot = Snapshot(0.0, Pose(1.0, 0.5, 0.0, 0.0, 0.0, 0.5), Twist(0.2, wz=0.1), UNACCELERATED, {}, {}, {}, {})
    assert _motion(snapshot) == "x +1.00 m  y +0.50 m  yaw +28.6°,  +0.20 m/s  +5.7°/s  (y, yaw: left)"
