"""Steps 49 to 72: waypoints, velocity and pose."""

from __future__ import annotations

from typing import Final

from jauspy.conformance.checks import carries, near, that
from jauspy.conformance.profiles.igvc_2015.judge import COP, EVERYTHING
from jauspy.conformance.tester import Tester
from jauspy.messages.core import (
    ElementRec,
    SetElement,
)
from jauspy.messages.mobility import (
    QueryLocalPose,
    ReportLocalPose,
    SetLocalPose,
    SetLocalWaypoint,
)

POSE: Final = "pose of step 64"
ELEMENT: Final = bytes.fromhex("0d0400ffffff0fffffff0f")
"""SetLocalWaypoint, far away; nobody drives there in this test."""
SOMEWHERE: Final = -1000.0
"""m; x and y of where the judge says that the robot is."""
CLOSE: Final = 0.05
"""m; how exactly a robot that stands still must say where it is."""
WHERE: Final = (*carries("x", "y"), that("has no undefined fields", lambda report: not report.reserved_presence))


def remember_pose(tester: Tester) -> None:
    """Step 64."""
    pose = tester.client(COP).ask(QueryLocalPose(EVERYTHING), ReportLocalPose, WHERE)
    tester.memory[POSE] = (pose.x, pose.y)


def pose_unchanged(tester: Tester) -> None:
    """Steps 66 and 68."""
    x, y = tester.recall(POSE, "step 64 got no pose")
    tester.client(COP).ask(QueryLocalPose(EVERYTHING), ReportLocalPose, near(CLOSE, x=x, y=y))


VELOCITIES: Final = ("velocity_x", "velocity_y", "velocity_z", "roll_rate", "pitch_rate", "yaw_rate", "time_stamp")
SUPPORTED: Final = (
    that("carries something", lambda report: any(getattr(report, name) is not None for name in VELOCITIES)),
    that("has no undefined fields", lambda report: not report.reserved_presence),
)

ONE_ELEMENT: Final = SetElement(
    request_id_rec=SetElement.RequestIDRec(0x2C),
    element_list=[ElementRec(1, 0, 0, ElementRec.ElementData(0, ELEMENT))],
)
AT_ONE_METRE: Final = SetLocalWaypoint(x=1.0, y=1.0)
ELSEWHERE: Final = SetLocalPose(x=SOMEWHERE, y=SOMEWHERE)
THERE: Final = near(CLOSE, x=SOMEWHERE, y=SOMEWHERE)
