"""What is easily written without `async` or `await`, and a sentence for each in place of Python's own words."""

from __future__ import annotations

from collections.abc import Callable
from typing import NoReturn


def async_only(instead: str) -> Callable[..., NoReturn]:
    """A method that only says what to write instead; hide it from type checkers, who know without it."""

    def refuse(self: object, *_: object) -> NoReturn:
        raise TypeError(
            f"use {instead} with this {type(self).__name__}, inside `async def`; code without `async` and `await` has "
            "jauspy.sync.OCU"
        )

    return refuse
