"""Answers that come later: an action returns one in place of its report, and fulfils it when the report is there."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Hashable
from dataclasses import dataclass
from functools import partial
from typing import Final, Protocol, TypeAlias, TypeVar

from jauspy.codec.base import Message
from jauspy.ids import JausID
from jauspy.services.state_machine import ActionErrors, Trigger

MAX_DEFERRED_REPLIES: Final = 32
"""Answers of a component that may be under way; one more is given at once, as if it had stayed out."""

REPLY_TIMEOUT: Final = 10.0
"""Seconds that an answer may stay out."""

R = TypeVar("R")
ReplyCallback: TypeAlias = Callable[[Message | None], None]


class Deferred:
    """A report that is not there yet; `Host.later` makes it."""

    __slots__ = ("_expects", "_ready", "_told", "_waiting", "maker", "report", "trigger")

    def __init__(self, ready: Callable[[Deferred], None]) -> None:
        self._ready: Callable[[Deferred], None] | None = ready
        self._waiting: list[ReplyCallback] = []
        self._told = False
        self._expects = ""
        self.report: Message | None = None
        """What it was fulfilled with."""
        self.maker = "a promise"
        """The method that returned it, for the log."""
        self.trigger = Trigger("later")
        """What it answers, for the log."""

    def comes_from(self, maker: str, trigger: Trigger, report: str = "") -> None:
        """Note who returned it, on what, and the name of the message that the definition sends; empty takes any."""
        self.maker, self.trigger, self._expects = maker, trigger, report

    def fulfil(self, report: Message | None) -> None:
        """Answer with it; None: not at all. May be called at any time, in the host's thread; only the first counts."""
        ready, self._ready = self._ready, None
        if ready is not None:
            self.report = report
            ready(self)

    def then(self, tell: ReplyCallback) -> None:
        """Have `tell` called with the report, from within the host."""
        if self._told:
            tell(self.report)
        else:
            self._waiting.append(tell)

    def check(self) -> None:
        """Raises `TypeError` when it was fulfilled with something else than the report; then there is none."""
        report: object = self.report
        if report is None or (isinstance(report, Message) and self._expects in ("", report.NAME)):
            return
        self.report = None
        what = report.NAME if isinstance(report, Message) else repr(report)
        raise TypeError(f"it is to be fulfilled with a {self._expects or 'message'} or None, and was with {what}")

    def close(self) -> list[ReplyCallback]:
        """Who waits, for the host to tell; from now on nobody has to."""
        self._told = True
        waiting, self._waiting = self._waiting, []
        return waiting


@dataclass(frozen=True, slots=True)
class PendingReply:
    """An answer that somebody only asked for, on its way."""

    later: Deferred
    encode: Callable[[Message | None], bytes | None]

    def then(self, tell: Callable[[bytes | None], None]) -> None:
        """Have `tell` called with it, from within the host."""
        self.later.then(lambda report: tell(self.encode(report)))


class TimerHost(Protocol):
    """What is needed of a host."""

    now: float
    counters: Counter[str]
    prompt: Callable[[], None]

    def set_timer(self, key: Hashable, at: float, call: Callable[[], None]) -> None:
        """Call `call` at time `at`."""
        ...


class DeferredReplies:
    """Those of one component. Whoever fulfils one is not within the host, so a timer that is due tells of it.

    Counters: `later_overdue` stayed out, `later_refused` were too many, `asked_again` need no second answer.
    """

    def __init__(self, host: TimerHost, bugs: ActionErrors) -> None:
        self._host = host
        self._bugs = bugs
        self._open: set[Deferred] = set()
        self._asked: set[Hashable] = set()

    def begin(self, otherwise: Callable[[], Message | None]) -> Deferred:
        """A new one; when it stays out, the answer is what `otherwise` makes."""
        later = Deferred(self._ready)
        if len(self._open) >= MAX_DEFERRED_REPLIES:
            self._host.counters["later_refused"] += 1
            later.fulfil(otherwise())
        else:
            self._open.add(later)
            self._host.set_timer(later, self._host.now + REPLY_TIMEOUT, partial(self._overdue, later, otherwise))
        return later

    def answer(self, later: Deferred, trigger: Trigger, tell: ReplyCallback) -> None:
        """Have a question answered by `tell`; a client that asks it once more meanwhile is answered once."""
        question = _question(trigger)
        if question in self._asked:
            self._host.counters["asked_again"] += 1
            return
        self._asked.add(question)

        def answer(report: Message | None) -> None:
            self._asked.discard(question)
            tell(report)

        later.then(answer)

    def _ready(self, later: Deferred) -> None:
        self._host.set_timer(later, self._host.now, partial(self._tell, later))
        self._host.prompt()

    def _tell(self, later: Deferred) -> None:
        self._open.discard(later)
        self._contained(later, later.check)
        for tell in later.close():
            self._contained(later, partial(tell, later.report))

    def _overdue(self, later: Deferred, otherwise: Callable[[], Message | None]) -> None:
        self._host.counters["later_overdue"] += 1
        later.fulfil(self._contained(later, otherwise))

    def _contained(self, later: Deferred, call: Callable[[], R]) -> R | None:
        """A bug for one who waits is none for the others, and leaves no promise open."""
        try:
            return call()
        except Exception as error:  # noqa: BLE001 - any bug of a service
            self._bugs.met(later.maker, later.trigger, error)
            return None


def _question(trigger: Trigger) -> tuple[JausID | None, object]:
    asked = trigger.msg
    return trigger.source, asked.encode(strict=False) if isinstance(asked, Message) else trigger.key
