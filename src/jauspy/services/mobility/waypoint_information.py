"""What a client adds to waypoints of a list: which way round to drive there, and how long to wait."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable
from dataclasses import dataclass
from typing import Final

from jauspy.services.core.list_manager import MAX_ELEMENTS, RESERVED


@dataclass(frozen=True, slots=True)
class WaypointInformation:
    """What is added to one waypoint; None for what is not."""

    is_reverse: bool | None = None
    """True to drive there backward, False forward, None by the sign of the speed."""
    wait: float | None = None
    """Seconds to stand there; 0 is until the next execute command."""

    def directed(self, speed: float) -> float:
        """The speed (m/s, negative backward) on the way there."""
        return speed if self.is_reverse is None else math.copysign(speed, -1.0 if self.is_reverse else 1.0)


NOTHING: Final = WaypointInformation()


class AddedInformation:
    """The information for the elements of a list; elements may be added later, and deleted ones are forgotten."""

    def __init__(self, capacity: int = MAX_ELEMENTS) -> None:
        self._capacity = capacity
        self._found: dict[int, WaypointInformation] = {}

    def of(self, uid: int) -> WaypointInformation:
        """That of one element."""
        return self._found.get(uid, NOTHING)

    def listed(self, order: Iterable[int]) -> list[tuple[int, WaypointInformation]]:
        """Those that were given for these elements."""
        return [(uid, self._found[uid]) for uid in order if uid in self._found]

    def add(self, uid: int, information: WaypointInformation) -> bool:
        """Keep the information in place of the earlier one; false if there is no room, or no such number."""
        if uid in RESERVED or (uid not in self._found and len(self._found) >= self._capacity):
            return False
        self._found[uid] = information
        return True

    def forget(self, uids: Collection[int]) -> None:
        """Forget what was added to these elements."""
        for uid in uids:
            self._found.pop(uid, None)
