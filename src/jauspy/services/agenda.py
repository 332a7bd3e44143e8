"""What a component handles one by one: a received message, and internal events and commands that it brings up."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from typing import Final

from jauspy.services.completion import CommandCompletion
from jauspy.services.machine import TriggerOutcome
from jauspy.services.trigger import Trigger

MAX_QUEUED_TRIGGERS: Final = 256
"""Internal events that may wait at once, and that may follow from one message; more is a bug of a service."""


class TriggerQueue:
    """First in, first out. What comes up while something is handled waits until that is done.

    Nothing is handled before `open`, which is when everything is bound.
    """

    def __init__(self, dispatch: Callable[[Trigger], TriggerOutcome], dropped: Callable[[Trigger], None]) -> None:
        self._dispatch = dispatch
        self._dropped = dropped
        self._waiting: deque[tuple[Trigger, CommandCompletion | None]] = deque()
        self._command: CommandCompletion | None = None
        self._busy = True

    def open(self) -> None:
        """Begin, with what came up so far."""
        self._settle()

    def run(self, trigger: Trigger) -> TriggerOutcome:
        """Handle this now, and then all that follows from it."""
        self._busy = True
        outcome = self._handle(trigger, None)
        self._settle()
        return outcome

    def put(self, trigger: Trigger, completion: CommandCompletion | None = None) -> None:
        """Handle this as soon as what happens now is done; when too much waits, it is dropped."""
        if not self._busy:
            self._busy = True
            self._handle(trigger, completion)
            self._settle()
        elif len(self._waiting) < MAX_QUEUED_TRIGGERS:
            self._waiting.append((trigger, completion))
        else:
            self._drop(trigger, completion)

    def begin_command(self) -> CommandCompletion:
        """What is being handled takes time, and ends when this is called; nobody may wait for that."""
        command = self._command or CommandCompletion()
        command.claimed = True
        return command

    def _settle(self) -> None:
        for _ in range(MAX_QUEUED_TRIGGERS):
            if not self._waiting:
                break
            self._handle(*self._waiting.popleft())
        while self._waiting:
            self._drop(*self._waiting.popleft())
        self._busy = False

    def _handle(self, trigger: Trigger, completion: CommandCompletion | None) -> TriggerOutcome:
        self._command = completion
        outcome = self._dispatch(trigger)
        self._command = None
        if completion is not None and not (completion.claimed and outcome is TriggerOutcome.TAKEN):
            completion(outcome is TriggerOutcome.TAKEN)
        return outcome

    def _drop(self, trigger: Trigger, completion: CommandCompletion | None) -> None:
        self._dropped(trigger)
        if completion is not None:
            completion(False)
