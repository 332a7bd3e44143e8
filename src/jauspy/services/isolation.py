"""Contains the bugs of actions: logged with the message that met them, counted, and nothing else stops."""

from __future__ import annotations

import logging
from collections import Counter
from types import TracebackType
from typing import Final, Protocol

from jauspy.services.trigger import Trigger

_LOG: Final = logging.getLogger("jauspy.services")


class Attempt:
    """A `with` block around one call of an action; `failed` tells afterwards."""

    __slots__ = ("_counters", "_name", "_trigger", "failed")

    def __init__(self, name: str, trigger: Trigger, counters: Counter[str]) -> None:
        self._name = name
        self._trigger = trigger
        self._counters = counters
        self.failed = False

    def __enter__(self) -> Attempt:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> bool:
        if not isinstance(error, Exception):
            return False
        self.failed = True
        self._counters["action_failed"] += 1
        what, source = self._trigger.msg or self._trigger.key, self._trigger.source or "inside"
        _LOG.error("%s failed on %r from %s: %s", self._name, what, source, error, exc_info=error)
        return True


class Containment(Protocol):
    """Makes the `with` block for one action."""

    def __call__(self, name: str, trigger: Trigger) -> Attempt:
        """`name` says which action of which service and state."""
        ...
