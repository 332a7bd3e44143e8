"""Figures of a run as the simulation measures them at each physics step, not as a task reports them."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Final, Protocol


class MeetingLike(Protocol):
    """Two things that met, as a simulation's probe reports it: m/s and newtons."""

    time: float
    first: str
    second: str
    speed: float
    force: float


class JointLike(Protocol):
    """The largest values of a joint, as a simulation's probe reports them."""

    speed: float
    torque: float
    error: float
    end_error: float
    ends: int


class PeakLike(Protocol):
    """The largest load of a connector, as a simulation's probe reports it: N and N m in the connector's frame."""

    @property
    def utilisation(self) -> float: ...  # noqa: D102
    @property
    def time(self) -> float: ...  # noqa: D102
    @property
    def part(self) -> str: ...  # noqa: D102
    @property
    def force(self) -> tuple[float, float, float]: ...  # noqa: D102
    @property
    def moment(self) -> tuple[float, float, float]: ...  # noqa: D102


class Probe(Protocol):
    """What a simulation measures at each step since the probe was made."""

    attaches: Sequence[MeetingLike]
    landings: Sequence[MeetingLike]
    collisions: Sequence[MeetingLike]
    joints: Mapping[str, JointLike]

    @property
    def stops(self) -> int:
        """Motions of the UR10 that its own detection of contact has ended."""
        ...

    @property
    def peaks(self) -> Mapping[tuple[str, str], PeakLike]:
        """The largest loads, by connector and kind of connection."""
        ...


@dataclass(frozen=True, slots=True)
class Meeting:
    """Two things that met."""

    time: float
    """Seconds of the robot's time."""
    first: str
    """A connector, what the gripper carried, or a link of the robot."""
    second: str
    speed: float
    """m/s between them."""
    force: float
    """Newtons: the largest until they were at rest."""


@dataclass(frozen=True, slots=True)
class JointFigures:
    """The largest values of one joint of the UR10."""

    speed: float
    """rad/s."""
    torque: float
    """N m."""
    error: float
    """Radians from the setpoint in motion."""
    end_error: float
    """Radians from the setpoint at the ends of motions."""
    ends: int
    """Number of motions that ended."""


@dataclass(frozen=True, slots=True)
class Load:
    """The largest load of a connector of all steps, by its fraction of the strength that it had then."""

    connector: str
    kind: str
    """Kind of the connection: a gripper, the cup of a connector, or its latch."""
    part: str
    """Name of what it held."""
    utilisation: float
    """Fraction of the strength."""
    time: float
    """Seconds of the robot's time."""
    force: float
    """Newtons."""
    moment: float
    """Newton metres."""


@dataclass(slots=True)
class Physics:
    """What happened in one run."""

    attaches: list[Meeting] = field(default_factory=list)
    """Connectors that attached a part."""
    landings: list[Meeting] = field(default_factory=list)
    """First contacts of what the gripper carried with what it was put on."""
    collisions: list[Meeting] = field(default_factory=list)
    """Contacts of the UR10 that no grasp explains."""
    joints: dict[str, JointFigures] = field(default_factory=dict)
    """The UR10's, by name."""
    loads: list[Load] = field(default_factory=list)
    """The largest one of each connector and kind of connection."""
    stops: int = 0
    """Motions of the UR10 that its own detection of contact has ended: without a collision, a false alarm."""

    @classmethod
    def of(cls, probe: Probe) -> Physics:
        """What a probe has measured so far."""
        return cls(
            _meetings(probe.attaches),
            _meetings(probe.landings),
            _meetings(probe.collisions),
            {
                name: JointFigures(joint.speed, joint.torque, joint.error, joint.end_error, joint.ends)
                for name, joint in probe.joints.items()
            },
            [
                Load(
                    connector,
                    kind,
                    peak.part,
                    peak.utilisation,
                    peak.time,
                    math.hypot(*peak.force),
                    math.hypot(*peak.moment),
                )
                for (connector, kind), peak in probe.peaks.items()
            ],
            probe.stops,
        )

    def figures(self) -> dict[str, float]:
        """The largest values, by name; only of what happened."""
        found = {"attachments": float(len(self.attaches)), "collisions": float(len(self.collisions))}
        found["stops at contact"] = float(self.stops)
        for name, meetings in (("attach", self.attaches), ("landing", self.landings), ("collision", self.collisions)):
            if meetings:
                found[f"{name} speed"] = max(meeting.speed for meeting in meetings)
                found[f"{name} force"] = max(meeting.force for meeting in meetings)
        found |= {f"load of the {kind}": load.utilisation for kind, load in self.largest_loads().items()}
        if self.joints:
            found["tracking error"] = max(joint.error for joint in self.joints.values())
            found["end error"] = max(joint.end_error for joint in self.joints.values())
            found["joint speed"] = max(joint.speed for joint in self.joints.values())
        return found

    def largest_loads(self) -> dict[str, Load]:
        """The largest load of each kind of connection."""
        found: dict[str, Load] = {}
        for load in self.loads:
            if load.kind not in found or load.utilisation > found[load.kind].utilisation:
                found[load.kind] = load
        return found


GENTLE_SPEED: Final = 0.02
"""m/s that an attachment should not exceed."""
GENTLE_FORCE: Final = 50.0
"""Newtons that an attachment should not exceed."""


def _meetings(found: Sequence[MeetingLike]) -> list[Meeting]:
    return [Meeting(row.time, row.first, row.second, row.speed, row.force) for row in found]
