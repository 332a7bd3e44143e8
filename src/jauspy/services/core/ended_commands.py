"""Commands that have ended, while their client may not know yet that they were taken: it may ask once more."""

from __future__ import annotations

from typing import Final

from jauspy.ids import JausID
from jauspy.services.core.subscriptions import PendingCommand

COMPLETED_COMMAND_LIFETIME: Final = 3.0
"""Seconds; as long as our own OCU asks again, and longer than any known link takes."""
MAX_COMPLETED_COMMANDS: Final = 64


class CompletedCommands:
    """By their requests, each for a while; the oldest goes first."""

    def __init__(self) -> None:
        self._until: dict[PendingCommand, float] = {}

    def __len__(self) -> int:
        return len(self._until)

    def add(self, watch: PendingCommand, now: float) -> None:
        """It has ended just now; with one more than `MAX_COMPLETED_COMMANDS`, the oldest is forgotten."""
        self.forget(watch)
        self._until[watch] = now + COMPLETED_COMMAND_LIFETIME
        if len(self._until) > MAX_COMPLETED_COMMANDS:
            self.forget(next(iter(self._until)))

    def find(self, client: JausID, request: bytes, now: float) -> PendingCommand | None:
        """That of this very request."""
        for watch, until in self._until.items():
            if now < until and watch.client == client and watch.request == request:
                return watch
        return None

    def holds(self, watch: PendingCommand) -> bool:
        """True while it is remembered."""
        return watch in self._until

    def forget(self, watch: PendingCommand) -> None:
        """Its client knows; fine when it is gone."""
        self._until.pop(watch, None)

    def forget_of(self, client: JausID) -> None:
        """Those of a client that is gone."""
        for watch in [each for each in self._until if each.client == client]:
            self.forget(watch)

    def clear(self) -> None:
        """Forget all."""
        self._until.clear()
