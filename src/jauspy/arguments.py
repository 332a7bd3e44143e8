"""Checks arguments of public functions; errors name what is expected."""

from __future__ import annotations

from collections.abc import Callable
from numbers import Integral, Real
from typing import NoReturn


def check_number(value: object, use: str, *, whole: bool = False, optional: bool = False) -> None:
    """Raise `TypeError` unless `value` is a number, of NumPy too, or, with `optional`, None."""
    if not isinstance(value, Integral if whole else Real) and not (optional and value is None):
        raise TypeError(f"{use} is {'a whole number' if whole else 'a number'}, not {described(value)}")


def check_text(value: object, use: str) -> None:
    """Raise `TypeError` unless `value` is a string."""
    if not isinstance(value, str):
        raise TypeError(f"{use} is text, not {described(value)}")


def described(value: object) -> str:
    """A value and its type, for an error message."""
    return "None" if value is None else f"the {type(value).__name__} {value!r}"


def async_only(instead: str) -> Callable[..., NoReturn]:
    """Make a method that raises `TypeError` with the `async` form to use; to be hidden from type checkers."""

    def refuse(self: object, *_: object) -> NoReturn:
        raise TypeError(
            f"use {instead} with this {type(self).__name__}, inside `async def`; code without `async` and `await` has "
            "jauspy.sync.OCU"
        )

    return refuse
