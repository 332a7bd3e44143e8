"""What is planned and measured in trials of navigation, as plain values, and their file."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Annotated, Any, ClassVar, Final

from pydantic import ConfigDict, Field, TypeAdapter

from jauspy.campaigns import read_results, write_whole
from jauspy.errors import ConfigError

MAX_GOALS: Final = 100_000
"""Goals in one world."""
MAX_TEXT: Final = 4096
"""Characters of a text in a file of results."""
VERB: Final = "jauspy navigate-trials"

_Text = Annotated[str, Field(max_length=MAX_TEXT)]
_Count = Annotated[int, Field(ge=0, le=1 << 53)]
_Length = Annotated[float, Field(ge=0.0, le=1e9)]
_Number = Annotated[float, Field(ge=-1e9, le=1e9)]
_STRICT: Final = ConfigDict(extra="forbid", allow_inf_nan=False, strict=True)


@dataclass(frozen=True)
class TrialPlan:
    """The trials: `goals` in each world, in groups of `group` that do not depend on each other."""

    __pydantic_config__: ClassVar[ConfigDict] = _STRICT

    worlds: Annotated[tuple[_Text, ...], Field(min_length=1, max_length=1000)]
    goals: Annotated[int, Field(ge=1, le=MAX_GOALS)]
    seed: _Count
    moved: bool = False
    """True to put a thing into the way of each drive."""
    blind: bool = False
    """True for a robot without its depth camera."""
    group: Annotated[int, Field(ge=1, le=MAX_GOALS)] = 5
    """Goals that the robot drives to one after the other, unless it fails, before it begins anew."""
    again: bool = False
    """True to drive to all goals of a group once more, by a robot that begins anew with the map of the first drives."""

    def groups(self) -> Iterator[GoalGroup]:
        """The groups, in order."""
        for world in self.worlds:
            for number, first in enumerate(range(0, self.goals, self.group)):
                yield GoalGroup(world, number, min(self.group, self.goals - first))

    def drives(self, group: GoalGroup) -> int:
        """The number of drives of a group."""
        return (1 + self.again) * group.goals


@dataclass(frozen=True)
class GoalGroup:
    """Goals that one robot drives to: those of one number are the same in each campaign with the same seed."""

    world: str
    number: int
    goals: int


@dataclass(frozen=True)
class Drive:
    """One drive: metres, radians and seconds, in the frame of the world."""

    __pydantic_config__: ClassVar[ConfigDict] = _STRICT

    world: _Text
    group: _Count
    number: _Count
    """The number of the drive in its group."""
    start: tuple[_Number, _Number, _Number]
    """x, y and yaw."""
    goal: tuple[_Number, _Number]
    end: tuple[_Number, _Number, _Number, _Number, _Number, _Number]
    """x, y, z, roll, pitch and yaw."""
    error: _Text
    """Why the goal was not reached; empty if it was."""
    way: _Length
    """Length of the way that was driven."""
    shortest: Annotated[float, Field(gt=0.0, le=1e9)]
    """Length of the shortest way of a grid search on the true map, which turns nowhere."""
    contacts: Annotated[Mapping[_Text, _Count], Field(max_length=1000)]
    """Samples of the physics with a contact that is not with the ground, by body of the world."""
    plans: _Count
    """Ways that were taken."""
    thing: _Text
    """What was put into the way; empty without."""
    new_way: _Length | None
    """Seconds of the robot's time from then until the robot was sent along another way; None if it was not."""
    new_way_planning: _Length | None
    """Processor time of the search for that way, in which virtual time stands still."""
    seconds: _Length
    """Duration in the robot's time."""
    planning: _Length
    """Processor time of the longest search, with the costs of the map."""
    cpu: _Length
    """Processor time of the drive, with the physics."""
    known: bool = False
    """True for a robot that began with the map of earlier drives."""
    blocked: bool = False
    """True if what was put into the way left none on the true map: the robot is right to say so."""
    planned: Annotated[float, Field(gt=0.0, le=1e9)] | None = None
    """Length of the way that the navigator's search finds on the true map; None without one, and in older results."""

    @property
    def reached(self) -> bool:
        """True if the robot ended at the goal."""
        return not self.error

    @property
    def counts(self) -> bool:
        """False if the goal could not be reached."""
        return self.reached or not self.blocked


@dataclass(frozen=True)
class TrialResults:
    """A plan and its drives so far: of whole groups, in order."""

    __pydantic_config__: ClassVar[ConfigDict] = ConfigDict(extra="ignore", allow_inf_nan=False, strict=True)

    plan: TrialPlan
    drives: tuple[Drive, ...]

    def missing(self) -> list[GoalGroup]:
        """The groups that are still to be driven."""
        done = {(drive.world, drive.group) for drive in self.drives}
        return [group for group in self.plan.groups() if (group.world, group.number) not in done]

    def with_drives(self, drives: Sequence[Drive]) -> TrialResults:
        """The results with those of a further group."""
        order = {world: number for number, world in enumerate(self.plan.worlds)}
        found = (*self.drives, *drives)
        return replace(self, drives=tuple(sorted(found, key=lambda drive: (order[drive.world], *_place(drive)[1:]))))


_RESULTS: Final = TypeAdapter(TrialResults)


def write_trials(path: Path, results: TrialResults, report: Mapping[str, Any] | None = None) -> None:
    """Write the file that `resumed` reads, and the report in it; when that is interrupted, the file stays as it was."""
    found = {"plan": asdict(results.plan), "report": report, "drives": [asdict(drive) for drive in results.drives]}
    write_whole(path, json.dumps(found, indent=1))


def resumed(path: Path, plan: TrialPlan) -> TrialResults:
    """The results of whole groups of a plan in a file, which may have been written for fewer goals and worlds.

    Raises `ConfigError` for a file that is damaged, or has results of other options.
    """
    found = read_results(path, _RESULTS, VERB)
    before = found.plan
    for name in ("seed", "moved", "blind", "group", "again"):
        if (theirs := getattr(before, name)) != (ours := getattr(plan, name)):
            raise ConfigError(f"{path}: has results of {name} {theirs}, not {ours}; {_OTHER}")
    if before.goals > plan.goals or not set(before.worlds) <= set(plan.worlds):
        raise ConfigError(
            f"{path}: has results of {before.goals} goals in {', '.join(before.worlds)}; ask for at least these, or "
            "give another --output"
        )
    drives = {_place(drive): drive for drive in found.drives}
    if len(drives) != len(found.drives):
        raise ConfigError(f"{path}: is no file of results of `{VERB}`: it has two drives of one number")
    results = TrialResults(plan, ())
    for group in plan.groups():
        places = [(group.world, group.number, number) for number in range(plan.drives(group))]
        if all(place in drives for place in places):
            results = results.with_drives([drives[place] for place in places])
    return results


_OTHER: Final = "leave out --resume, or give another --output"


def _place(drive: Drive) -> tuple[str, int, int]:
    return drive.world, drive.group, drive.number
