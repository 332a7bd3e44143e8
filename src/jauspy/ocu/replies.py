"""Hands what arrives to whoever waits for it: by sender and message class."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable, Hashable, Iterator
from contextlib import asynccontextmanager, contextmanager
from dataclasses import dataclass, field
from typing import Final, TypeAlias

from jauspy.arguments import described
from jauspy.codec.base import Message
from jauspy.codec.registry import Registry
from jauspy.errors import CodecError, ConfigError, DecodeError
from jauspy.ids import JausID

Reply: TypeAlias = tuple[Message, JausID]
Callback: TypeAlias = Callable[[Message, JausID], None]


@dataclass(slots=True, eq=False)
class ReplyWaiter:
    """One answer somebody waits for.

    `problem` says what was wrong with answers that could not be read, `instead` what else came that nobody wanted.
    """

    source: JausID
    kinds: tuple[type[Message], ...]
    accept: Callable[[Message], bool]
    arrival: asyncio.Future[Reply]
    problem: str = ""
    instead: str = ""

    def take(self, payload: bytes, source: JausID, registry: Registry) -> bool:
        """Use it up when it is what is waited for; raises `DecodeError` for a malformed one."""
        code = int.from_bytes(payload[:2], "little")
        kind = next((each for each in self.kinds if code == each.CODE), None)
        if kind is None or self.arrival.done() or not self.source.matches(source):
            return False
        message = registry.decode_as(kind, payload)
        if not self.accept(message):
            return False
        self.arrival.set_result((message, source))
        return True


@dataclass(slots=True, eq=False)
class _Listener:
    source: JausID
    kinds: tuple[type[Message], ...]
    tap: Callback


@dataclass(slots=True)
class ReplyDispatcher:
    """Taps see every message of their kinds; of the waiters, the one that has waited longest takes it."""

    registry: Registry
    malformed: Callable[[str], None]
    _waiters: list[ReplyWaiter] = field(default_factory=list)
    _taps: list[_Listener] = field(default_factory=list)

    def deliver(self, payload: bytes, source: JausID) -> bool:
        """Hand out one message, or say that nobody waits. Malformed ones are reported, and who waits remembers."""
        used = [each for each in tuple(self._taps) if self._try_tap(each, payload, source)]
        for waiter in self._waiters:
            try:
                if waiter.take(payload, source, self.registry):
                    return True
            except DecodeError as error:
                waiter.problem = f"{waiter.kinds[0].NAME}: {error}"
                if not used:
                    self.malformed(waiter.problem)
                return True
        return bool(used)

    def unexpected(self, name: str, source: JausID) -> None:
        """A message came that nobody wanted; perhaps it is what somebody should have waited for."""
        for waiter in self._waiters:
            if waiter.source.matches(source):
                waiter.instead = name

    @contextmanager
    def waiting(
        self,
        source: JausID,
        *kinds: type[Message],
        accept: Callable[[Message], bool] = lambda _: True,
    ) -> Iterator[ReplyWaiter]:
        """Wait for one message of these kinds from `source` (wildcards are understood) that `accept` likes."""
        waiter = ReplyWaiter(source, kinds, accept, asyncio.get_running_loop().create_future())
        self._waiters.append(waiter)
        try:
            yield waiter
        finally:
            self._waiters.remove(waiter)
            if not waiter.arrival.cancel() and not waiter.arrival.cancelled():
                waiter.arrival.exception()  # looked at, so that nobody complains when it came too late to be raised

    @contextmanager
    def tapped(self, source: JausID, tap: Callback, *kinds: type[Message]) -> Iterator[None]:
        """Call `tap` at once for every message of these kinds from `source`; wildcards are understood."""
        entry = _Listener(source, kinds, tap)
        self._taps.append(entry)
        try:
            yield
        finally:
            self._taps.remove(entry)

    def fail(self, error: Exception) -> None:
        """End every wait with this error."""
        for waiter in self._waiters:
            if not waiter.arrival.done():
                waiter.arrival.set_exception(error)

    def _try_tap(self, entry: _Listener, payload: bytes, source: JausID) -> bool:
        code = int.from_bytes(payload[:2], "little")
        kind = next((each for each in entry.kinds if code == each.CODE), None)
        if kind is None or not entry.source.matches(source):
            return False
        try:
            message = self.registry.decode_as(kind, payload)
        except CodecError as error:
            self.malformed(f"{kind.NAME} from {source}: {error}")
            return True
        entry.tap(message, source)
        return True


@dataclass(slots=True)
class _Turns:
    content: bytes = b""
    active: int = 0
    waiting: int = 0
    turn: asyncio.Event = field(default_factory=asyncio.Event)


class QuerySerializer:
    """By key; a lane exists only while somebody is in it."""

    def __init__(self) -> None:
        self._lanes: dict[Hashable, _Turns] = {}

    def __len__(self) -> int:
        return len(self._lanes)

    @asynccontextmanager
    async def enter(self, key: Hashable, content: bytes) -> AsyncIterator[None]:
        """Share the lane with equal content, wait until other content has left it."""
        lane = self._lanes.setdefault(key, _Turns())
        try:
            await self._wait(lane, content)
            lane.content = content
            lane.active += 1
            try:
                yield
            finally:
                lane.active -= 1
        finally:
            if not lane.active:
                lane.turn.set()
                if not lane.waiting:
                    self._lanes.pop(key, None)

    async def _wait(self, lane: _Turns, content: bytes) -> None:
        """Who comes new goes behind all who wait, or these might wait for ever."""
        has_turn = not lane.waiting
        lane.waiting += 1
        try:
            while not has_turn or (lane.active and lane.content != content):
                lane.turn.clear()
                await lane.turn.wait()
                has_turn = True
        finally:
            lane.waiting -= 1


def check_message(value: object, use: str, example: str = "QueryStatus()") -> None:
    """Raise `TypeError` unless it is a message; `use` is what takes it, as in `query()`."""
    if isinstance(value, Message):
        return
    if isinstance(value, type) and issubclass(value, Message):
        raise TypeError(f"{use} takes a message, and {value.NAME} is only its class; write {value.NAME}(...)")
    raise TypeError(f"{use} takes a message, as in {example}, not {described(value)}")


def check_message_class(value: object, use: str) -> None:
    """Raise `TypeError` unless it is the class of a message, or None."""
    if value is None or (isinstance(value, type) and issubclass(value, Message)):
        return
    what = f"a message; write {value.NAME} without brackets" if isinstance(value, Message) else described(value)
    raise TypeError(f"{use} takes the class of a message, as in ReportStatus, not {what}")


REPORT_OFFSET: Final = 0x2000
"""From the code of a query (2000h to 3FFFh) to that of its report (AS5710)."""
REPORT_CODES: Final = range(0x4000, 0x6000)


def reply_class(
    registry: Registry, message: Message, expects: type[Message] | None, use: str = "query()"
) -> type[Message]:
    """What answers this message: `expects`, else the report of the query that it is; `use` is what it was given to."""
    check_message(message, use)
    check_message_class(expects, "expects")
    return expects or report_of(registry, message)


def report_of(registry: Registry, query: Message) -> type[Message]:
    """The class of the report that answers a query, of the same service and version."""
    if not query.IS_QUERY:
        raise ConfigError(f"{query.NAME} is no query; say with `expects` which message answers it, or send it")
    if (report := getattr(query, "REPORT", None)) is not None:
        return report  # type: ignore[no-any-return]  # queries whose report is of the same service have it
    code = query.CODE + REPORT_OFFSET
    found = registry.by_code(code) if code in REPORT_CODES else _named_report(registry, query)
    for each in found:
        if (each.SERVICE, each.VERSION) == (query.SERVICE, query.VERSION):
            return each
    if not found:
        what = f"with id {code:04X}" if code in REPORT_CODES else f"called {report_name(query)} of {query.SERVICE}"
        raise ConfigError(f"no message {what} is known to answer {query.NAME}; say with `expects` which one does")
    return found[0]


def _named_report(registry: Registry, query: Message) -> tuple[type[Message], ...]:
    """What answers a query whose id says nothing, as those of users do."""
    try:
        return (registry.by_name(report_name(query), service=query.SERVICE, version=query.VERSION),)
    except ConfigError:
        return ()


def report_name(query: Message) -> str:
    """`ReportLamp` of `QueryLamp`."""
    return f"Report{query.NAME.removeprefix('Query')}"
