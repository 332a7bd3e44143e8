"""Contains the bugs of actions: logged with the message that met them, counted, and nothing else stops."""

from __future__ import annotations

import logging
from collections import Counter
from collections.abc import Callable
from types import TracebackType
from typing import Final, Protocol

from jauspy.services.trigger import Trigger

_LOG: Final = logging.getLogger("jauspy.services")


class Bugs:
    """Everything that failed in one component; `failed` is called after each."""

    def __init__(self, counters: Counter[str], failed: Callable[[], None] = lambda: None) -> None:
        self._counters = counters
        self._failed = failed
        self._times: Counter[str] = Counter()

    def attempt(self, name: str, trigger: Trigger) -> Attempt:
        """A `with` block around one action; `name` says which action of which service and state."""
        return Attempt(name, trigger, self)

    def met(self, name: str, trigger: Trigger, error: Exception) -> None:
        """Count it. It is logged the 1st, 2nd, 4th, 8th ... time, so that a client cannot fill the disk with it."""
        self._counters["action_failed"] += 1
        self._times[name] += 1
        times = self._times[name]
        if times & (times - 1) == 0:
            what, source = trigger.msg or trigger.key, trigger.source or "inside"
            again = f" ({times} times)" if times > 1 else ""
            _LOG.error("%s failed%s on %r from %s: %s", name, again, what, source, error, exc_info=error)
        self._failed()


class Attempt:
    """A `with` block around one call of an action; `failed` tells afterwards."""

    __slots__ = ("_bugs", "_name", "_trigger", "failed")

    def __init__(self, name: str, trigger: Trigger, bugs: Bugs) -> None:
        self._name = name
        self._trigger = trigger
        self._bugs = bugs
        self.failed = False

    def __enter__(self) -> Attempt:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> bool:
        if not isinstance(error, Exception):
            return False
        self.failed = True
        self._bugs.met(self._name, self._trigger, error)
        return True


class Containment(Protocol):
    """Makes the `with` block for one action."""

    def __call__(self, name: str, trigger: Trigger) -> Attempt:
        """`name` says which action of which service and state."""
        ...
