"""Checks of an answer. Each has a name, so that a report can name those that fail."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from enum import IntEnum
from typing import Any, TypeAlias

from jauspy.codec.message import Message

FindProblem: TypeAlias = Callable[[Any], str]
"""Takes a message; returns what is wrong with it, or an empty string."""


@dataclass(frozen=True, slots=True)
class Check:
    """Something that must hold for a message. `name` is a sentence without subject, as in `has status 5`."""

    name: str
    problem: FindProblem


def has(**fields: object) -> tuple[Check, ...]:
    """Each of these fields has exactly this value; a dotted path is written with two underscores."""
    return tuple(_equal(name.replace("__", "."), value) for name, value in fields.items())


def near(tolerance: float, **fields: float) -> tuple[Check, ...]:
    """Each of these numbers is present and within `tolerance`; paths are written as for `has`."""
    return tuple(_near(name.replace("__", "."), value, tolerance) for name, value in fields.items())


def value_of(message: Any, name: str) -> Any:
    """Return the value at a path of `has` and `near`."""
    return _field(message, name.replace("__", "."))


def carries(*fields: str) -> tuple[Check, ...]:
    """Each of these optional fields is present in the report."""
    return tuple(Check(f"carries {name}", _missing(name)) for name in fields)


def carries_only(*fields: str) -> Check:
    """No optional field but these is present in the report."""
    what = f"carries no optional field but {', '.join(fields)}" if fields else "carries no optional field"

    def problem(message: Message) -> str:
        extra = [name for name, value in _optional(message).items() if value is not None and name not in fields]
        return f"also carries {', '.join(extra)}, which was not requested" if extra else ""

    return Check(what, problem)


def that(name: str, holds: Callable[[Any], bool]) -> Check:
    """A check by a function; `name` is the condition that holds."""
    return Check(name, lambda message: "" if holds(message) else f"does not hold: {name}")


def _equal(path: str, value: object) -> Check:
    def problem(message: Message) -> str:
        got = _field(message, path)
        return "" if got == value else f"{path} is {_shown(got)}, not {_shown(value)}"

    return Check(f"has {path} {_shown(value)}", problem)


def _near(path: str, value: float, tolerance: float) -> Check:
    def problem(message: Message) -> str:
        got = _field(message, path)
        if got is None:
            return f"{path} is missing"
        return "" if abs(got - value) <= tolerance else f"{path} is {got:.6g}, not {value:g}"

    return Check(f"has {path} {value:g}", problem)


def _missing(name: str) -> FindProblem:
    return lambda message: "" if getattr(message, name) is not None else f"{name} is missing"


def _field(message: Any, path: str) -> Any:
    for name in path.split("."):
        message = getattr(message, name)
    return message


def _optional(message: Message) -> Mapping[str, object]:
    slots = getattr(message.layout(), "slots", ())
    return {slot.name: getattr(message, slot.name) for slot in slots if slot.optional}


def _shown(value: object) -> str:
    return f"{int(value)} {value.name}" if isinstance(value, IntEnum) else f"{value!r}"
