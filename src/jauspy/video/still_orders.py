"""Still images that a camera's process was asked for and has not delivered."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Final, TypeAlias

from jauspy.errors import ConfigError
from jauspy.platform.video_settings import Still, StillSettings
from jauspy.video.orders import Take, Taken

MOST: Final = 8
"""Images that may be under way; one more is refused."""

Then: TypeAlias = Callable[[Still | None], None]


class StillOrders:
    """By number, which counts on over processes that die."""

    def __init__(self) -> None:
        self._waiting: dict[int, tuple[Take, Then]] = {}
        self._number = 0

    def __iter__(self) -> Iterator[Take]:
        return (order for order, _ in self._waiting.values())

    def __contains__(self, order: Take) -> bool:
        return order.number in self._waiting

    def check(self) -> None:
        """Raise `ConfigError` when there are too many."""
        if len(self._waiting) >= MOST:
            raise ConfigError(f"{MOST} still images of this camera are under way; ask again when one has come")

    def add(self, settings: StillSettings, then: Then) -> Take:
        """One more."""
        self._number += 1
        order = Take(self._number, settings)
        self._waiting[order.number] = (order, then)
        return order

    def deliver(self, taken: Taken, now: float) -> None:
        """It is there; `now`: seconds of the machine's monotonic clock."""
        _, then = self._waiting.pop(taken.number)
        then(Still(taken.content, now - taken.at))

    def lose(self) -> int:
        """Those that are under way will not come; how many they are."""
        lost, self._waiting = self._waiting, {}
        for _, then in lost.values():
            then(None)
        return len(lost)
