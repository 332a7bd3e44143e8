"""Judges what the robot has truly done by what its operator has commanded."""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from itertools import takewhile
from pathlib import Path
from typing import Any, Final

SETTLE: Final = 0.6
"""Seconds after a stop was acknowledged in which the robot brakes."""
MIN_LEG: Final = 0.05
"""Metres that a leg has at least when the robot has carried it out."""


@dataclass(frozen=True, slots=True)
class Sample:
    """The robot at one time of the machine's clock: metres and radians."""

    time: float
    pose: tuple[float, float, float]
    joints: tuple[float, ...]
    controllers: dict[str, str]
    states: dict[str, list[str]]

    def is_held_by_others(self, pilot: str) -> bool:
        """True if a client other than the operator controls a component."""
        return any(client not in (pilot, "None") for client in self.controllers.values())

    def distance(self, other: Sample) -> float:
        """Metres on the floor."""
        return math.dist(self.pose[:2], other.pose[:2])

    def turned(self, other: Sample) -> float:
        """Radians by which chassis or any joint has turned (metres for a sliding joint)."""
        yaw = abs(math.remainder(self.pose[2] - other.pose[2], math.tau))
        return max([yaw, *(abs(here - there) for here, there in zip(self.joints, other.joints, strict=True))])

    def forward(self, other: Sample) -> float:
        """Metres from here to `other`, along the heading here."""
        dx, dy = other.pose[0] - self.pose[0], other.pose[1] - self.pose[1]
        return dx * math.cos(self.pose[2]) + dy * math.sin(self.pose[2])

    def sideways(self, other: Sample) -> float:
        """Metres by which `other` is beside the line of the heading here."""
        dx, dy = other.pose[0] - self.pose[0], other.pose[1] - self.pose[1]
        return abs(dy * math.cos(self.pose[2]) - dx * math.sin(self.pose[2]))


@dataclass(frozen=True, slots=True)
class Leg:
    """A drive of the operator: `end` is None while it goes on; `direction` 1 is forward, -1 back."""

    begin: float
    end: float | None
    direction: float


@dataclass(frozen=True, slots=True)
class Motion:
    """What became of control and motion: a robot without an operator has no samples."""

    moved: float = 0.0
    """Metres or radians that nobody who is entitled has commanded: off the line of the course, or at rest."""
    legs: int = 0
    """Legs that began and ended, with the time to brake, while the robot was recorded."""
    driven: int = 0
    """Legs that the robot has carried out."""
    samples: int = 0
    controlled: int = 0
    """Samples with the operator in control of all components that it had at the start."""


@dataclass(slots=True)
class TruthFile:
    """What the robot's process records, from a mark on."""

    path: Path
    mark: int = field(default=0)

    def begin(self) -> None:
        """Read from here on."""
        self.mark = self.path.stat().st_size if self.path.exists() else 0

    def samples(self) -> list[Sample]:
        """The samples since then."""
        if not self.path.exists():
            return []
        with self.path.open("rb") as file:
            file.seek(self.mark)
            return [sample_of(json.loads(line)) for line in file if line.endswith(b"\n")]


def sample_of(reported: dict[str, Any]) -> Sample:
    """A recorded line as a sample."""
    x, y, yaw = reported["pose"]
    return Sample(reported["time"], (x, y, yaw), tuple(reported["joints"]), reported["controllers"], reported["states"])


def judge(samples: Sequence[Sample], legs: Sequence[Leg], pilot: str, *, may_be_taken: bool = False) -> Motion:
    """Compare the samples with the legs that were commanded meanwhile.

    With `may_be_taken`, the attackers may take control when the operator has lost it, as after an emergency, and then
    move the robot: motion counts until they first do.
    """
    if not samples:
        return Motion()
    own = list(takewhile(lambda sample: not sample.is_held_by_others(pilot), samples)) if may_be_taken else samples
    begin, end = samples[0].time, samples[-1].time - SETTLE
    finished = [leg for leg in legs if leg.end is not None and begin <= leg.begin and leg.end <= end]
    return Motion(
        max([_off_line(own), *(_spread(rest) for rest in rests(own, legs))]) if own else 0.0,
        len(finished),
        sum(_is_driven(leg, samples) for leg in finished),
        len(samples),
        sum(all(client == pilot for client in each.controllers.values()) for each in samples),
    )


def rests(samples: Sequence[Sample], legs: Iterable[Leg]) -> list[list[Sample]]:
    """The samples of each time in which the robot was to stand still."""
    found: list[list[Sample]] = [[]]
    drives = list(legs)
    for sample in samples:
        if not any(leg.begin <= sample.time and (leg.end is None or sample.time <= leg.end + SETTLE) for leg in drives):
            found[-1].append(sample)
        elif found[-1]:
            found.append([])
    return [rest for rest in found if rest]


def _spread(samples: Sequence[Sample]) -> float:
    """How far the robot moved, from the first of these samples."""
    return max(max(samples[0].distance(each), samples[0].turned(each)) for each in samples)


def _off_line(samples: Sequence[Sample]) -> float:
    """How far the robot left the line on which it stood at first, or turned."""
    return max(max(samples[0].sideways(each), samples[0].turned(each)) for each in samples)


def _is_driven(leg: Leg, samples: Sequence[Sample]) -> bool:
    """True when the robot was farther on the course after the leg than before it."""
    assert leg.end is not None
    before = [each for each in samples if each.time <= leg.begin]
    after = [each for each in samples if leg.begin <= each.time <= leg.end + SETTLE]
    if not before or not after:
        return True  # the record begins or ends within this leg
    return leg.direction * before[-1].forward(after[-1]) >= MIN_LEG
