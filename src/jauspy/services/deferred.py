"""Deferred replies: an action returns a `Deferred` in place of its report and sets its result later."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from dataclasses import dataclass
from functools import partial
from typing import Final, Protocol, TypeAlias, TypeVar

from jauspy.codec.message import Message
from jauspy.ids import JausID
from jauspy.protocol.counters import Counters
from jauspy.services.state_machine import ActionErrors, Trigger

MAX_DEFERRED_REPLIES: Final = 32
"""Deferred replies that a component may have pending; one more gets its fallback immediately."""

REPLY_TIMEOUT: Final = 10.0
"""Seconds after which a deferred reply is given its fallback."""

R = TypeVar("R")
ReplyCallback: TypeAlias = Callable[[Message | None], None]


class Deferred:
    """A report that is not available yet; made by `self.host.defer`."""

    __slots__ = ("_callbacks", "_expected", "_is_done", "_on_result", "origin", "report", "trigger")

    def __init__(self, on_result: Callable[[Deferred], None]) -> None:
        self._on_result: Callable[[Deferred], None] | None = on_result
        self._callbacks: list[ReplyCallback] = []
        self._is_done = False
        self._expected = ""
        self.report: Message | None = None
        """The result, once it is set."""
        self.origin = "deferred reply"
        """The method that returned it, for the log."""
        self.trigger = Trigger("deferred")
        """The trigger that it answers, for the log."""

    def set_origin(self, method: str, trigger: Trigger, report: str = "") -> None:
        """Note the method that returned it, the trigger, and the name of the report that is expected; empty: any."""
        self.origin, self.trigger, self._expected = method, trigger, report

    def set_result(self, report: Message | None) -> None:
        """Answer with this report, None for no answer. Call it in the host's thread; only the first call counts."""
        on_result, self._on_result = self._on_result, None
        if on_result is not None:
            self.report = report
            on_result(self)

    def add_done_callback(self, callback: ReplyCallback) -> None:
        """Register `callback`, which the host calls with the report."""
        if self._is_done:
            callback(self.report)
        else:
            self._callbacks.append(callback)

    def check(self) -> None:
        """Raise `TypeError` when the result is not the report that is expected, and drop that result."""
        report: object = self.report
        if report is None or (isinstance(report, Message) and self._expected in ("", report.NAME)):
            return
        self.report = None
        what = report.NAME if isinstance(report, Message) else repr(report)
        raise TypeError(f"the result must be a {self._expected or 'message'} or None; it was {what}")

    def finish(self) -> list[ReplyCallback]:
        """The callbacks, which the host calls; from now on callbacks that are added are called at once."""
        self._is_done = True
        callbacks, self._callbacks = self._callbacks, []
        return callbacks


@dataclass(frozen=True, slots=True)
class PendingReply:
    """An encoded reply that is not available yet, to a query of `Host.ask` instead of a received one."""

    deferred: Deferred
    encode: Callable[[Message | None], bytes | None]

    def add_done_callback(self, callback: Callable[[bytes | None], None]) -> None:
        """Register `callback`, which the host calls with the reply."""
        self.deferred.add_done_callback(lambda report: callback(self.encode(report)))


class TimerHost(Protocol):
    """The part of a host that `DeferredReplies` uses."""

    now: float
    counters: Counters
    on_timer_change: Callable[[], None]

    def set_timer(self, key: Hashable, due: float, call: Callable[[], None]) -> None:
        """Call `call` at time `due` (seconds)."""
        ...


class DeferredReplies:
    """The deferred replies of one component.

    Results are set outside of the host's calls, so a timer that is due immediately passes them on.

    Counters: `deferred_overdue` had no result in time, `deferred_refused` were too many, `repeated_query` was not
    answered twice.
    """

    def __init__(self, host: TimerHost, errors: ActionErrors) -> None:
        self._host = host
        self._errors = errors
        self._pending: set[Deferred] = set()
        self._queries: set[Hashable] = set()

    def begin(self, fallback: Callable[[], Message | None]) -> Deferred:
        """A new one; when no result is set in time, `fallback` makes it."""
        deferred = Deferred(self._on_result)
        if len(self._pending) >= MAX_DEFERRED_REPLIES:
            self._host.counters["deferred_refused"] += 1
            deferred.set_result(fallback())
        else:
            self._pending.add(deferred)
            self._host.set_timer(deferred, self._host.now + REPLY_TIMEOUT, partial(self._time_out, deferred, fallback))
        return deferred

    def answer(self, deferred: Deferred, trigger: Trigger, send: ReplyCallback) -> None:
        """Call `send` with the result; a client that repeats its query meanwhile is answered once."""
        query = _query_key(trigger)
        if query in self._queries:
            self._host.counters["repeated_query"] += 1
            return
        self._queries.add(query)

        def answer(report: Message | None) -> None:
            self._queries.discard(query)
            send(report)

        deferred.add_done_callback(answer)

    def _on_result(self, deferred: Deferred) -> None:
        self._host.set_timer(deferred, self._host.now, partial(self._finish, deferred))
        self._host.on_timer_change()

    def _finish(self, deferred: Deferred) -> None:
        self._pending.discard(deferred)
        self._run(deferred, deferred.check)
        for callback in deferred.finish():
            self._run(deferred, partial(callback, deferred.report))

    def _time_out(self, deferred: Deferred, fallback: Callable[[], Message | None]) -> None:
        self._host.counters["deferred_overdue"] += 1
        deferred.set_result(self._run(deferred, fallback))

    def _run(self, deferred: Deferred, call: Callable[[], R]) -> R | None:
        """Call it; an exception is recorded, and concerns neither other callbacks nor other replies."""
        try:
            return call()
        except Exception as error:  # noqa: BLE001 - any bug of a service
            self._errors.record(deferred.origin, deferred.trigger, error)
            return None


def _query_key(trigger: Trigger) -> tuple[JausID | None, object]:
    query = trigger.msg
    return trigger.source, query.encode(strict=False) if isinstance(query, Message) else trigger.key
