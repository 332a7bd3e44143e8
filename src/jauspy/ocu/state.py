"""Reports of a robot as plain values: poses and joints with the axes of REP-103 and `datetime`."""

from __future__ import annotations

from collections.abc import ItemsView, Iterator, Mapping
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta
from enum import IntEnum
from typing import Final

from jauspy.geometry.poses import Pose, jaus_pose
from jauspy.geometry.vectors import Vector
from jauspy.messages.core import TimeStamp
from jauspy.messages.exp import ReportHealthDetails
from jauspy.messages.mobility import ReportLocalPose
from jauspy.printable import printable

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
class LinkHealth:
    """The link between a robot and this program, as the robot measures it in the last ten seconds."""

    is_up: bool
    """False if the robot's last probes were not answered."""
    round_trip: float | None
    """Seconds there and back; None while it is not known."""
    loss: float
    """Fraction of the packets that were not answered, 0 to 1."""
    rate: float | None = None
    """Bits per second that the robot's node manager sends to this machine, video and sound left out; None while it is
    not known, and for a program on the robot's machine."""


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
class BatteryReport:
    """The state of a battery, as the robot reports it; None for what it leaves out."""

    charge: float | None
    """Fraction of its capacity, 0..1."""
    voltage: float | None
    """Volts."""
    current: float | None
    """Amperes that it delivers."""
    temperature: float | None
    """Degrees Celsius."""
    time: datetime
    """When the report arrived: it has no time stamp."""

    @property
    def power(self) -> float | None:
        """Watts that it delivers."""
        return None if self.voltage is None or self.current is None else self.voltage * self.current


@dataclass(frozen=True, slots=True)
class HealthReport:
    """The health of one part, as the robot reports it."""

    component: int
    """Number of the component, on the node of the one that reports."""
    service: str
    """URN of the service that the part belongs to."""
    severity: str
    """NONE, INFO, WARN, ERR or FAIL."""
    part: str
    """NONE, PROCESSOR, RAM, ROM, FILESYS, POWER, SENSOR, ACTUATOR or SOFTWARE."""
    text: str
    time: datetime | None
    """Since when; None for a time that does not exist."""

    @property
    def is_well(self) -> bool:
        """True if nothing needs to be done."""
        return self.severity in ("NONE", "INFO")


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


def health_of(report: ReportHealthDetails, now: datetime) -> list[HealthReport]:
    """The entries of a report, the worst first."""
    found = []
    for component in report.detailed_status_list:
        for entry in component.component_status_list:
            time = entry.logtime
            stamp = TimeStamp(
                milliseconds=time.milliseconds, seconds=time.seconds, minutes=time.minute, hour=time.hour, day=time.day
            )
            row = HealthReport(
                component=component.component_rec.component_id,
                service=printable(entry.service_urn),
                severity=_name(ReportHealthDetails.Severity, entry.severity),
                part=_name(ReportHealthDetails.Code, entry.code),
                text=printable(entry.descriptor),
                time=datetime_of(stamp, now),
            )
            found.append((-int(entry.severity), row))
    return [row for _, row in sorted(found, key=lambda item: item[0])]


def _name(kind: type[IntEnum], value: int) -> str:
    """The name of a value; its number for one that the standard does not define."""
    return next((item.name for item in kind if item == value), str(int(value)))


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
