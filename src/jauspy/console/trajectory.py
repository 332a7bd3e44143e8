"""A joint trajectory: rows of positions with durations in seconds; saved as JSON, exported as a Python program."""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Annotated, Final, TypeVar

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from jauspy.console.languages import sentence
from jauspy.console.manipulators import JointInfo, ModularArm, Row
from jauspy.errors import ConfigError
from jauspy.printable import printable

MAX_ROWS: Final = 200
MAX_JOINTS: Final = 64
MAX_SECONDS: Final = 3600.0
"""Greatest duration of one row."""
MAX_FILE: Final = 1 << 20
"""Bytes of a file that is loaded."""
MAX_PLACE: Final = 200
"""Characters of the place of a mistake."""
DEFAULT_SECONDS: Final = 2.0
Model = TypeVar("Model", bound=BaseModel)
_Name = Annotated[str, Field(min_length=1, max_length=255)]
_Finite = Annotated[float, Field(allow_inf_nan=False, strict=True)]


class _RowModel(BaseModel):
    model_config = ConfigDict(extra="forbid")
    seconds: Annotated[float, Field(ge=0.0, le=MAX_SECONDS, strict=True)]
    positions: Annotated[list[_Finite], Field(max_length=MAX_JOINTS)]


class Author(BaseModel):
    """Who has saved something, and when (ISO 8601, UTC); both are empty if it is not known."""

    model_config = ConfigDict(extra="forbid", frozen=True)
    by: Annotated[str, Field(max_length=64)] = ""
    at: Annotated[str, Field(max_length=32)] = ""

    def __str__(self) -> str:
        return (
            sentence("saved by {by}, {at}", by=printable(self.by), at=printable(self.at))
            if self.by
            else sentence("saved by an unknown user")
        )


UNKNOWN: Final = Author()
"""The author of what an earlier version has saved, or another program."""


class _FileModel(BaseModel):
    model_config = ConfigDict(extra="forbid")
    author: Author = UNKNOWN
    robot: Annotated[str, Field(max_length=255)] = ""
    joints: Annotated[list[_Name], Field(min_length=1, max_length=MAX_JOINTS)]
    rows: Annotated[list[_RowModel], Field(max_length=MAX_ROWS)]


@dataclass
class TrajectoryRow:
    """Duration in seconds of the motion to these positions; 0 is as fast as the limits allow."""

    seconds: float
    positions: list[float]


@dataclass
class Trajectory:
    """The trajectory in the editor; positions are in the order of `joints`, radians or metres."""

    joints: tuple[str, ...] = ()
    rows: list[TrajectoryRow] = field(default_factory=list)
    author: Author = field(default=UNKNOWN, compare=False)

    def add(self, positions: Sequence[float], seconds: float = DEFAULT_SECONDS) -> None:
        """Add a row at the end; raises `ConfigError` when there are too many."""
        if len(self.rows) >= MAX_ROWS:
            raise ConfigError(sentence("a trajectory has at most {most} rows", most=MAX_ROWS))
        self.rows.append(TrajectoryRow(seconds, [round(value, 4) + 0.0 for value in positions]))

    def move(self, index: int, by: int) -> None:
        """Move a row up or down, if it can go there."""
        if 0 <= index < len(self.rows) and 0 <= index + by < len(self.rows):
            self.rows.insert(index + by, self.rows.pop(index))

    def named(self) -> list[Row]:
        """The rows with positions by joint, for `Manipulator.follow`."""
        return [(row.seconds, dict(zip(self.joints, row.positions, strict=True))) for row in self.rows]

    def problem(self, joints: Sequence[JointInfo], now: dict[str, float], first: int = 1) -> str:
        """Why an arm with these joints cannot follow the rows, the first of which has this number; empty if it can."""
        known = {joint.name: joint for joint in joints}
        if not self.rows:
            return sentence("there are no rows: add the present positions first")
        if missing := [name for name in self.joints if name not in known]:
            return sentence("this arm has no joint {joint}, which the trajectory moves", joint=printable(missing[0]))
        before = now
        for number, (seconds, positions) in enumerate(self.named(), first):
            for name, value in positions.items():
                joint = known[name]
                if not joint.lower <= value <= joint.upper:
                    return sentence(
                        "row {number}: {name} can be {lower:.4g}..{upper:.4g} {unit}, not {value:g}",
                        number=number,
                        name=name,
                        lower=joint.lower,
                        upper=joint.upper,
                        unit=joint.unit,
                        value=value,
                    )
                least = joint.motion.least_duration(value - before[name])
                if seconds and seconds < least:
                    return sentence(
                        "row {number}: {name} needs at least {least:.2f} s, not {seconds:g} s",
                        number=number,
                        name=name,
                        least=math.ceil(100 * least) / 100,
                        seconds=seconds,
                    )
            before = {**before, **positions}
        return ""

    def to_json(self, robot: str, author: Author | None = None) -> str:
        """The content of a file."""
        author_line = "" if author is None else f'  "author": {author.model_dump_json()},\n'
        rows = [{"seconds": row.seconds, "positions": row.positions} for row in self.rows]
        head = (
            f'{{\n{author_line}  "robot": {json.dumps(robot)},\n  "joints": {json.dumps(self.joints)},\n  "rows": [\n'
        )
        return head + ",\n".join(f"    {json.dumps(row)}" for row in rows) + "\n  ]\n}\n"

    @classmethod
    def from_json(cls, text: str | bytes, name: str = "the file") -> Trajectory:
        """Read a file; raises `ConfigError` with place and reason."""
        data = read_model(_FileModel, text, name, guide="docs/console.md")
        if len(set(data.joints)) < len(data.joints):
            raise ConfigError(sentence("{name}: joints: a name is there twice", name=name))
        for number, row in enumerate(data.rows, 1):
            if len(row.positions) != len(data.joints):
                raise ConfigError(
                    sentence(
                        "{name}: row {number} has {positions} positions for {joints} joints",
                        name=name,
                        number=number,
                        positions=len(row.positions),
                        joints=len(data.joints),
                    )
                )
        rows = [TrajectoryRow(row.seconds, list(row.positions)) for row in data.rows]
        return cls(tuple(data.joints), rows, data.author)

    def program(self, subsystem: int, component: str, *, modular: bool) -> str:
        """A Python program that moves the arm through the rows."""
        rows = "\n".join(f"    ({row.seconds!r}, {tuple(row.positions)!r})," for row in self.rows)
        joints = "\n".join(f"    {name!r}," for name in self.joints)
        return _PROGRAM.format(
            subsystem=subsystem,
            component=component,
            joints=joints,
            rows=rows,
            imports="\nfrom itertools import accumulate" if modular else "",
            more="\nfrom jauspy.platform.modular.arm import TrajectoryPoint" if modular else "",
            play=_PLAY_MODULAR if modular else _PLAY,
        )


def not_taken(suffix: str) -> str:
    """Why a browser has not sent a file that was chosen."""
    return sentence(
        "the file was not taken: it has more than {most} MiB, or its name does not end with {suffix}",
        most=MAX_FILE >> 20,
        suffix=suffix,
    )


def read_model(model: type[Model], text: str | bytes, name: str, *, guide: str) -> Model:
    """The content of a JSON file; raises `ConfigError` with place, reason, and the guide that has the form."""
    if len(text) > MAX_FILE:
        raise ConfigError(sentence("{name}: has more than {most} MiB", name=name, most=MAX_FILE >> 20))
    try:
        return model.model_validate_json(text)
    except ValidationError as error:
        first = error.errors()[0]
        raise ConfigError(
            sentence(
                "{name}: {place}: {problem}; see {guide} for the form",
                name=name,
                place=place(first["loc"]),
                problem=first["msg"],
                guide=guide,
            )
        ) from None


def place(location: Sequence[int | str]) -> str:
    """The place of a mistake in a file as text; its keys may be of any length and kind."""
    return printable(".".join(map(str, location)))[:MAX_PLACE] or "the whole"


def is_modular(arm: object) -> bool:
    """True for the modular arm of a cell."""
    return isinstance(arm, ModularArm)


_PLAY: Final = '''
async def play(robot):
    """Move the arm through all rows."""
    arm = robot.manipulator(ARM)
    rows = [(seconds, dict(zip(JOINTS, positions, strict=True))) for seconds, positions in ROWS]
    async with robot.control(ARM):
        await arm.follow(rows, progress=lambda row: print(f"row {row + 1} of {len(rows)}"))
'''
_PLAY_MODULAR: Final = '''
async def play(robot):
    """Move the arm through all rows: without stops if each has a time."""
    arm = robot.component(ARM).modular_arm
    async with robot.control(ARM):
        if all(seconds > 0.0 for seconds, _ in ROWS):
            times = accumulate(seconds for seconds, _ in ROWS)
            points = [TrajectoryPoint(time, positions) for time, (_, positions) in zip(times, ROWS, strict=True)]
            await arm.follow(JOINTS, points)
            return
        for number, (seconds, positions) in enumerate(ROWS, 1):
            print(f"row {number} of {len(ROWS)}")
            await arm.follow(JOINTS, [TrajectoryPoint(seconds, positions)])
'''
_PROGRAM: Final = '''"""Moves an arm through a trajectory that was made with the console of jauspy.

    python this_file.py [NODE_MANAGER]        # as `--connect` of `jauspy ls`; by default the one of this machine
"""

import asyncio
import sys{imports}

from jauspy import OCU{more}

SUBSYSTEM, ARM = {subsystem}, "{component}"
JOINTS = (
{joints}
)
ROWS = (  # seconds of the way (0: as fast as possible), and where it ends: radians or metres
{rows}
)

{play}

async def main(connect=None):
    """Find the robot and play."""
    async with OCU("42.9.2", connect) as ocu:
        await play(await ocu.discover(SUBSYSTEM))


if __name__ == "__main__":
    asyncio.run(main(*sys.argv[1:2]))
'''
