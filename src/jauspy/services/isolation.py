"""Contains the bugs of actions: logged with the message that met them, counted, and nothing else stops."""

from __future__ import annotations

import logging
from collections import Counter
from collections.abc import Callable
from typing import Final

from jauspy.services.trigger import Trigger

_LOG: Final = logging.getLogger("jauspy.services")


class ActionErrors:
    """Everything that failed in one component; `failed` is called after each.

    Who calls the code of a service catches every `Exception` and hands it in here, with a name that says which action
    of which service and state it was.
    """

    def __init__(self, counters: Counter[str], failed: Callable[[], None] = lambda: None) -> None:
        self._counters = counters
        self._failed = failed
        self._times: Counter[str] = Counter()

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
