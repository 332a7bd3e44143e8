"""Acceptance steps of your own.

In this folder: `jauspy conformance conformance_profile:PROFILE --target 101.1.102`.
"""

from jauspy.conformance import Profile, Step, ask, has
from jauspy.messages.core import QueryStatus, ReportStatus
from jauspy.messages.mobility import QueryLocalPose, ReportLocalPose


def stands_still(tester) -> None:
    """Two poses, one second apart, are the same to a centimetre."""
    client = tester.client("42.1.1")
    first = client.ask(QueryLocalPose(0x1FF), ReportLocalPose)
    tester.wait(1.0)
    second = client.ask(QueryLocalPose(0x1FF), ReportLocalPose)
    moved = abs(second.x - first.x) + abs(second.y - first.y)
    tester.check("it stands still without control", "" if moved < 0.01 else f"it moved {moved:.3f} m")


PROFILE = Profile(
    "acme-parked",
    "Acceptance test of a parked robot",
    (
        Step("1", "in standby", ask("42.1.1", QueryStatus(), ReportStatus, has(status=ReportStatus.Status.STANDBY))),
        Step("2", "stands still", stands_still, points=5),
    ),
)
