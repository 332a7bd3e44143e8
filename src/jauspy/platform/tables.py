"""Bounds and conversions of values in a robot's TOML file: annotations of the dataclasses of its tables.

A table of the file is validated by pydantic against the dataclass itself; bounds are not checked for
objects made in Python.
This module needs no pydantic, so that clients and components run without it.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, fields
from typing import Annotated, Any, ClassVar, TypeAlias, cast

from annotated_types import Interval, Len

from jauspy.geometry.poses import Pose, Transform


class Table:
    """Base of dataclasses that are tables of the file; unknown keys are errors."""

    __slots__ = ()
    __pydantic_config__: ClassVar[Mapping[str, Any]] = {"extra": "forbid"}

    @classmethod
    def __get_pydantic_core_schema__(cls, source: Any, handler: Any) -> Any:
        schema = handler(source)
        reject_conversions(handler.resolve_ref_schema(schema))
        return schema


def reject_conversions(schema: Any) -> None:
    """Have a schema of pydantic take numbers for numbers only, not `true` or "5", and true and false for flags only.

    A whole number is a float, too. The schema is changed; parts that it only refers to are left as they are.
    """
    if isinstance(schema, dict):
        if schema.get("type") in ("int", "float", "bool"):
            schema["strict"] = True
        for part in schema.values():
            reject_conversions(part)
    elif isinstance(schema, list | tuple):
        for part in schema:
            reject_conversions(part)


@dataclass(frozen=True, slots=True)
class Converted:
    """Annotation of a value that `convert` makes from the one in the file, after the bounds left of it are checked."""

    convert: Callable[[Any], Any]
    """Raises `ValueError` for what is not permitted."""

    def __get_pydantic_core_schema__(self, source: Any, handler: Callable[[Any], Any]) -> Any:
        from pydantic_core import core_schema  # noqa: PLC0415 - only where files are read

        return core_schema.no_info_after_validator_function(self.convert, handler(source))


@dataclass(frozen=True, slots=True)
class Prepared:
    """Annotation of a value that `prepare` changes before it is checked, such as a short form of a table."""

    prepare: Callable[[Any], Any]
    """Returns what it does not know as it is."""

    def __get_pydantic_core_schema__(self, source: Any, handler: Callable[[Any], Any]) -> Any:
        from pydantic_core import core_schema  # noqa: PLC0415 - only where files are read

        return core_schema.no_info_before_validator_function(self.prepare, handler(source))


@dataclass(frozen=True, slots=True)
class Written:
    """Annotation of a value that has another form in the file: that of the dataclass `form`."""

    form: type[Table]
    convert: Callable[[Any], Any]

    def __get_pydantic_core_schema__(self, source: Any, handler: Any) -> Any:
        from pydantic_core import core_schema  # noqa: PLC0415 - only where files are read

        return core_schema.no_info_after_validator_function(self.convert, handler.generate_schema(self.form))


@dataclass(frozen=True, slots=True)
class FormOf:
    """Annotation of a value that another validator makes from a table: the class that declares the table's keys."""

    form: type


def _finite(value: float) -> float:
    if not math.isfinite(value):
        raise ValueError("it must be a finite number")
    return value


def _identifier(name: str) -> str:
    if not re.fullmatch(r"[A-Za-z0-9_.+-]+", name):
        raise ValueError("a name has letters, digits and the characters _ . + -")
    return name


def check_order(key: str, values: tuple[float, float], what: str) -> None:
    """Raise `ValueError` unless the first of two values of `key` is below the second; `what` they are."""
    if values[0] >= values[1]:
        raise ValueError(f"{key}: {list(values)} is empty; give {what}")


def values_of(table: Table, kind: type[Table]) -> dict[str, Any]:
    """The values of a table's fields that `kind`, its class or a base of it, has too."""
    return {field.name: getattr(table, field.name) for field in fields(cast("Any", kind))}


def check_unique(key: str, names: Sequence[str]) -> None:
    """Raise `ValueError` if a name is there twice."""
    if twice := sorted({name for name in names if names.count(name) > 1}):
        raise ValueError(f"{key}: {', '.join(twice)} is there twice")


Name: TypeAlias = Annotated[str, Len(1, 64)]
Identifier: TypeAlias = Annotated[str, Len(1, 60), Converted(_identifier)]
"""Name of a part, type, connector or drive."""
UrdfName: TypeAlias = Annotated[str, Len(1, 80)]
"""Name of a link or joint."""
Finite: TypeAlias = Annotated[float, Converted(_finite)]
Positive: TypeAlias = Annotated[float, Interval(gt=0.0), Converted(_finite)]
NotNegative: TypeAlias = Annotated[float, Interval(ge=0.0), Converted(_finite)]
Fraction: TypeAlias = Annotated[float, Interval(ge=0.0, le=0.5)]
Deviation: TypeAlias = Annotated[float, Interval(ge=0.0, le=100.0)]
"""A standard deviation."""
Seed: TypeAlias = Annotated[int, Interval(ge=0)]

Position: TypeAlias = tuple[Finite, Finite, Finite]


@dataclass(frozen=True, slots=True)
class PoseTable(Table):
    """A pose in the file: `{ xyz = [1.0, 0.0, 0.2], rpy = [0.0, 0.0, 1.57] }`; metres and radians about fixed axes."""

    xyz: Position = (0.0, 0.0, 0.0)
    rpy: Position = (0.0, 0.0, 0.0)

    def pose(self) -> Pose:
        """Return the pose."""
        return Pose(*self.xyz, *self.rpy)

    def transform(self) -> Transform:
        """Return the frame of the pose."""
        return Transform.from_pose(self.pose())


PoseOfTable: TypeAlias = Annotated[Pose, Written(PoseTable, PoseTable.pose)]
FrameOfTable: TypeAlias = Annotated[Transform, Written(PoseTable, PoseTable.transform)]
