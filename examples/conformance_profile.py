"""Acceptance steps of your own: a parked robot is in Standby and does not move.

Run them in this folder: `jauspy conformance conformance_profile:PROFILE --target 101.1.102 --connect local:/tmp`.
"""

from jauspy.conformance import Profile, Step, Tester, ask, has
from jauspy.messages.core import QueryStatus, ReportStatus
from jauspy.messages.mobility import QueryLocalPose, ReportLocalPose


def stands_still(tester: Tester) -> None:
    """Two poses, one second apart, differ by less than a centimetre."""
    client = tester.client("42.1.1")
    first = client.ask(QueryLocalPose(), ReportLocalPose)
    tester.wait(1.0)
    second = client.ask(QueryLocalPose(), ReportLocalPose)
    moved = abs(second.x - first.x) + abs(second.y - first.y)
    tester.check("the robot stands still without control", "" if moved < 0.01 else f"it moved {moved:.3f} m")


PROFILE = Profile(
    "acme-parked",
    "Acceptance test of a parked robot",
    (
        Step("1", "in standby", ask("42.1.1", QueryStatus(), ReportStatus, has(status=ReportStatus.Status.STANDBY))),
        Step("2", "stands still", stands_still, points=5),
    ),
)
