"""Message ids that a new definition may have: two in a row that no public definition uses."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import typer

if TYPE_CHECKING:
    from jauspy.codec.registry import MessageEntry

OWN: Final = range(0xD000, 0xFFFF)
"""Of users, as the standard has it; some public definitions are users, too."""


def first_of_two(text: str) -> int:
    """The id that is written like this; it and the next one must be free."""
    try:
        code = int(text, 16)
    except ValueError:
        code = 0
    if not 0 < code < OWN.stop:
        raise typer.BadParameter(f"{text!r} is no message id; use D000 to FFFE", param_hint="--first-id")
    if (user := _user(code) or _user(code + 1)) is not None:
        raise typer.BadParameter(
            f"{user.code:04X} is {user.name} of {user.service} already; {_free_from(code)}", param_hint="--first-id"
        )
    return code


def _user(code: int) -> MessageEntry | None:
    from jauspy.messages import registry

    return next(iter(registry.entries_of(code)), None)


def _free_from(code: int) -> str:
    """The free ids next to this one, at least two; from the start when there are no higher ones."""
    free = [each for each in OWN if not _user(each)]
    pairs = [each for each in free if not _user(each + 1)]
    first = next((each for each in pairs if each > code), pairs[0])
    last = next(each for each in free if each >= first and each + 1 not in free)
    return f"{first:04X} to {last:04X} are free"
