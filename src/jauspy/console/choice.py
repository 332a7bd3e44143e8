"""The robot that the operator of a page has chosen. The console never chooses one: robots of strangers are in its list.

A robot is known by its number and its name. One that falls silent is shown again when both are the same; a robot that
answers under the number with another name is shown only after a click. Neither number nor name is a proof: a robot that
must not be imitated is on a network with keys, see docs/security.md.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Final

from jauspy.console.languages import sentence
from jauspy.ocu.robot import Robot
from jauspy.printable import printable

NOBODY_CHOSEN: Final = sentence("Click the name of a robot in the list Fleet. The console chooses none by itself.")
MAX_TEXT: Final = 2000
"""Characters of a choice that a browser has kept."""


class Choice:
    """A number of a robot and its name, which is learnt from the first robot that answers if it is not given."""

    def __init__(self, id: int | None = None, name: str = "") -> None:
        self._id = id
        self._name = name
        self._shown = False

    @classmethod
    def from_text(cls, text: object) -> Choice | None:
        """The choice that a browser has kept, see `for_browser`; None for any other text."""
        try:
            id, name = json.loads(text) if isinstance(text, str) and len(text) <= MAX_TEXT else (None, None)
        except (ValueError, TypeError, RecursionError):
            return None
        is_id = type(id) is int and 0 < id < 65536
        return cls(id, name) if is_id and isinstance(name, str) else None

    def for_browser(self) -> list[int | str] | None:
        """The choice that a browser keeps; None when nothing was chosen."""
        return None if self._id is None else [self._id, self._name]

    def robot(self, robots: Mapping[int, Robot]) -> Robot | None:
        """The chosen one of these robots; None if it does not answer, or if another one answers in its place."""
        found = robots.get(self._id) if self._id is not None else None
        if found is not None and self._is_other(found):
            found = None
        self._shown = found is not None
        if found is not None:
            self._name = self._name or found.name
        return found

    def _is_other(self, robot: Robot) -> bool:
        """True for a robot of another name. One that is shown may leave its name out, since answers are lost."""
        return self._name not in ("", robot.name) and not (self._shown and robot.name == "")

    def hint(self, robots: Mapping[int, Robot]) -> str:
        """Text for the operator while no robot is shown; empty if there is none to choose from."""
        if not robots:
            return ""
        if self._id is None:
            return NOBODY_CHOSEN
        chosen = f"{self._id} {printable(self._name)}".rstrip()
        if (found := robots.get(self._id)) is None:
            return sentence(
                "Robot {chosen} does not answer. It is shown when it does; or click the name of another one.",
                chosen=chosen,
            )
        other = printable(found.name) or sentence("a robot without a name")
        return sentence(
            "You chose robot {chosen}; now {other} answers with this number. "
            "Click its name in the list Fleet if that is right.",
            chosen=chosen,
            other=other,
        )
