"""Answers that come later: an action returns one in place of its report, and fulfils it when the report is there."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Hashable
from dataclasses import dataclass
from functools import partial
from typing import Final, Protocol, TypeAlias

from jauspy.codec.base import Message
from jauspy.ids import JausID
from jauspy.services.trigger import Trigger

MOST: Final = 32
"""Answers of a component that may be under way; one more is given at once, as if it had stayed out."""

PATIENCE: Final = 10.0
"""Seconds that an answer may stay out."""

Tell: TypeAlias = Callable[[Message | None], None]


class Later:
    """A report that is not there yet; `Host.later` makes it."""

    __slots__ = ("_ready", "_told", "_waiting", "report")

    def __init__(self, ready: Callable[[Later], None]) -> None:
        self._ready: Callable[[Later], None] | None = ready
        self._waiting: list[Tell] = []
        self._told = False
        self.report: Message | None = None
        """What it was fulfilled with."""

    def fulfil(self, report: Message | None) -> None:
        """Answer with it; None: not at all. May be called at any time, in the host's thread; only the first counts."""
        ready, self._ready = self._ready, None
        if ready is not None:
            self.report = report
            ready(self)

    def then(self, tell: Tell) -> None:
        """Have `tell` called with the report, from within the host."""
        if self._told:
            tell(self.report)
        else:
            self._waiting.append(tell)

    def tell(self) -> None:
        """Call all who wait; the host does."""
        self._told = True
        waiting, self._waiting = self._waiting, []
        for each in waiting:
            each(self.report)


@dataclass(frozen=True, slots=True)
class Coming:
    """An answer that somebody only asked for, on its way."""

    later: Later
    encode: Callable[[Message | None], bytes | None]

    def then(self, tell: Callable[[bytes | None], None]) -> None:
        """Have `tell` called with it, from within the host."""
        self.later.then(lambda report: tell(self.encode(report)))


class Waking(Protocol):
    """What is needed of a host."""

    now: float
    counters: Counter[str]
    prompt: Callable[[], None]

    def set_timer(self, key: Hashable, at: float, call: Callable[[], None]) -> None:
        """Call `call` at time `at`."""
        ...


class Laters:
    """Those of one component. Whoever fulfils one is not within the host, so a timer that is due tells of it.

    Counters: `later_overdue` stayed out, `later_refused` were too many, `asked_again` need no second answer.
    """

    def __init__(self, host: Waking) -> None:
        self._host = host
        self._open: set[Later] = set()
        self._asked: set[Hashable] = set()

    def begin(self, otherwise: Callable[[], Message | None]) -> Later:
        """A new one; when it stays out, the answer is what `otherwise` makes."""
        later = Later(self._ready)
        if len(self._open) >= MOST:
            self._host.counters["later_refused"] += 1
            later.fulfil(otherwise())
        else:
            self._open.add(later)
            self._host.set_timer(later, self._host.now + PATIENCE, partial(self._overdue, later, otherwise))
        return later

    def answer(self, later: Later, trigger: Trigger, tell: Tell) -> None:
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

    def _ready(self, later: Later) -> None:
        self._host.set_timer(later, self._host.now, partial(self._tell, later))
        self._host.prompt()

    def _tell(self, later: Later) -> None:
        self._open.discard(later)
        later.tell()

    def _overdue(self, later: Later, otherwise: Callable[[], Message | None]) -> None:
        self._host.counters["later_overdue"] += 1
        later.fulfil(otherwise())


def _question(trigger: Trigger) -> tuple[JausID | None, object]:
    asked = trigger.msg
    return trigger.source, asked.encode(strict=False) if isinstance(asked, Message) else trigger.key
