"""What users hand in is looked at where they do: a value of a wrong type is one sentence, no surprise further down."""

from __future__ import annotations

from collections.abc import Callable
from numbers import Integral, Real
from typing import NoReturn


def check_number(value: object, use: str, *, whole: bool = False, optional: bool = False) -> None:
    """Raise `TypeError` unless it is a number, or, if it is `optional`, None; those of numpy are fine."""
    if not isinstance(value, Integral if whole else Real) and not (optional and value is None):
        raise TypeError(f"{use} is {'a whole number' if whole else 'a number'}, not {described(value)}")


def check_text(value: object, use: str) -> None:
    """Raise `TypeError` unless it is text."""
    if not isinstance(value, str):
        raise TypeError(f"{use} is text, not {described(value)}")


def described(value: object) -> str:
    """A value in a sentence."""
    return "None" if value is None else f"the {type(value).__name__} {value!r}"


def async_only(instead: str) -> Callable[..., NoReturn]:
    """A method that only says what to write instead; hide it from type checkers, who know without it."""

    def refuse(self: object, *_: object) -> NoReturn:
        raise TypeError(
            f"use {instead} with this {type(self).__name__}, inside `async def`; code without `async` and `await` has "
            "jauspy.sync.OCU"
        )

    return refuse
