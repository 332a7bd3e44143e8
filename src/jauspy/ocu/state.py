"""Reports of a robot as plain values: poses and joints with the axes of REP-103 and `datetime`."""

from __future__ import annotations

from collections.abc import ItemsView, Iterator, Mapping
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta
from typing import Final

from jauspy.geometry.poses import Pose, jaus_pose
from jauspy.geometry.vectors import Vector
from jauspy.messages.core import TimeStamp
from jauspy.messages.mobility import ReportLocalPose

DAY: Final = timedelta(days=1)


@dataclass(frozen=True, slots=True)
class RobotPose:
    """Metres and radians with the axes of REP-103: x forward, y left, z up, yaw counterclockwise from above."""

    x: float = 0.0
    y: float = 0.0
    z: float = 0.0
    roll: float = 0.0
    pitch: float = 0.0
    yaw: float = 0.0
    time: datetime | None = None
    """Time of the measurement; None when the robot does not report it."""


@dataclass(frozen=True, slots=True)
class ForceTorque:
    """Force and torque of a tool and its load on a sensor, with the robot's axes (REP-103: z is up)."""

    force: Vector
    """Newtons; the weight of a tool is a negative force along z."""
    torque: Vector
    """Newton metres, about the sensor."""
    time: datetime
    """When the report arrived: it has no time stamp."""


@dataclass(frozen=True, slots=True)
class Joints:
    """Positions by the name of the joint, in radians or metres: `joints["elbow"]`, `joints.items()`."""

    positions: Mapping[str, float]
    time: datetime
    """When the reports arrived: they have no time stamps."""

    def __getitem__(self, name: str) -> float:
        return self.positions[name]

    def __iter__(self) -> Iterator[str]:
        """The names."""
        return iter(self.positions)

    def __len__(self) -> int:
        return len(self.positions)

    def items(self) -> ItemsView[str, float]:
        """Names and positions, as of a mapping."""
        return self.positions.items()


def pose_of(report: ReportLocalPose, now: datetime) -> RobotPose:
    """The pose in a report, whose axes are those of JAUS; what it leaves out is zero."""
    values = (report.x, report.y, report.z, report.roll, report.pitch, report.yaw)
    pose = jaus_pose(Pose(*(value or 0.0 for value in values)))
    time = None if report.time_stamp is None else datetime_of(report.time_stamp, now)
    # Adding zero removes the sign of a negative zero.
    return RobotPose(
        x=pose.x, y=pose.y + 0.0, z=pose.z + 0.0, roll=pose.roll, pitch=pose.pitch + 0.0, yaw=pose.yaw + 0.0, time=time
    )


def datetime_of(stamp: TimeStamp, now: datetime) -> datetime | None:
    """The UTC time closest to `now` of a day of a month and a time of day; None when there is no such time."""
    found: list[datetime] = []
    for month in (now.replace(day=1) - DAY, now, now.replace(day=28) + 4 * DAY):
        try:
            found.append(
                datetime(
                    month.year,
                    month.month,
                    stamp.day,
                    stamp.hour,
                    stamp.minutes,
                    stamp.seconds,
                    stamp.milliseconds * 1000,
                    tzinfo=UTC,
                )
            )
        except ValueError:
            continue
    return min(found, key=lambda time: abs(time - now), default=None)
