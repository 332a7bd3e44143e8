"""Matches replies with queries, and passes incoming messages to their receivers."""

from __future__ import annotations

import asyncio
from collections import defaultdict
from collections.abc import AsyncIterator, Callable, Hashable, Iterator
from contextlib import asynccontextmanager, contextmanager
from dataclasses import dataclass, field
from typing import Final, TypeAlias

from jauspy.arguments import described
from jauspy.codec.message import Message
from jauspy.codec.registry import Registry
from jauspy.errors import CodecError, ConfigError, DecodeError
from jauspy.ids import EVERYONE, JausID, message_id

REPORT_OFFSET: Final = 0x2000
"""Difference of the message id of a query (2000h to 3FFFh) and that of its report (AS5710)."""
REPORT_CODES: Final = range(0x4000, 0x6000)

Reply: TypeAlias = tuple[Message, JausID]
"""A message and its sender."""


# --- which message answers a query ------------------------------------------------------------------------------------


def reply_class(
    registry: Registry, message: Message, expects: type[Message] | None, use: str = "query()"
) -> type[Message]:
    """The class of the answer: `expects`, else the report of the query; `use` names the caller in error messages."""
    check_message(message, use)
    check_message_class(expects, "expects")
    return expects or report_of(registry, message)


def report_of(registry: Registry, query: Message) -> type[Message]:
    """The class of the report that answers a query, of the same service and version."""
    if not query.IS_QUERY:
        raise ConfigError(f"{query.NAME} is not a query; name the class of its answer with `expects`, or use `send()`")
    if (report := getattr(query, "REPORT", None)) is not None:
        return report  # type: ignore[no-any-return]  # set on queries whose report is of the same service
    code = query.CODE + REPORT_OFFSET
    found = registry.by_code(code) if code in REPORT_CODES else _report_by_name(registry, query)
    for reply in found:
        if (reply.SERVICE, reply.VERSION) == (query.SERVICE, query.VERSION):
            return reply
    if not found:
        what = f"with id {code:04X}" if code in REPORT_CODES else f"called {report_name(query)} of {query.SERVICE}"
        raise ConfigError(f"no message {what} is known to answer {query.NAME}; name its class with `expects`")
    return found[0]


def _report_by_name(registry: Registry, query: Message) -> tuple[type[Message], ...]:
    """The report of a query whose message id is outside the standard's ranges, as in services of users."""
    try:
        return (registry.by_name(report_name(query), service=query.SERVICE, version=query.VERSION),)
    except ConfigError:
        return ()


def report_name(query: Message) -> str:
    """`ReportLamp` for `QueryLamp`."""
    return f"Report{query.NAME.removeprefix('Query')}"


def check_message(value: object, use: str, example: str = "QueryStatus()") -> None:
    """Raise `TypeError` unless `value` is a message; `use` names the caller, as in `query()`."""
    if isinstance(value, Message):
        return
    if isinstance(value, type) and issubclass(value, Message):
        raise TypeError(f"{use} takes a message, and {value.NAME} is only its class; write {value.NAME}(...)")
    raise TypeError(f"{use} takes a message, as in {example}, not {described(value)}")


def check_message_class(value: object, use: str) -> None:
    """Raise `TypeError` unless `value` is the class of a message, or None."""
    if value is None or (isinstance(value, type) and issubclass(value, Message)):
        return
    what = f"a message; write {value.NAME} without brackets" if isinstance(value, Message) else described(value)
    raise TypeError(f"{use} takes the class of a message, as in ReportStatus, not {what}")


# --- who receives a message -------------------------------------------------------------------------------------------


@dataclass(slots=True, eq=False)
class ReplyWaiter:
    """Waits for one message; `reply` is the future of it.

    For the error message of a timeout, `problem` is what was wrong with replies that could not be decoded, and
    `other` the name of a message that arrived from the same component and was not expected.
    """

    source: JausID
    kinds: tuple[type[Message], ...]
    accept: Callable[[Message], bool]
    reply: asyncio.Future[Reply]
    problem: str = ""
    other: str = ""

    def take(self, payload: bytes, source: JausID, registry: Registry) -> bool:
        """Accept a message that is waited for; raises `DecodeError` for a malformed one."""
        kind = _kind_of(payload, self.kinds)
        if kind is None or self.reply.done() or not self.source.matches(source):
            return False
        message = registry.decode_as(kind, payload)
        if not self.accept(message):
            return False
        self.reply.set_result((message, source))
        return True


@dataclass(slots=True, eq=False)
class _Listener:
    source: JausID
    kinds: tuple[type[Message], ...]
    callback: Callable[[Message, JausID], None]


@dataclass(slots=True)
class ReplyDispatcher:
    """Hands each message to all listeners of its class and sender, and to the waiter that has waited longest."""

    registry: Registry
    on_malformed: Callable[[str], None]
    _waiters: list[ReplyWaiter] = field(default_factory=list)
    _listeners: defaultdict[tuple[int, JausID], list[_Listener]] = field(default_factory=lambda: defaultdict(list))
    """By message id and source; those of sources that are wildcards are at `EVERYONE`."""

    def dispatch(self, payload: bytes, source: JausID) -> bool:
        """Hand out one message; false when nobody takes it. Malformed messages are reported and count as taken."""
        code = message_id(payload)
        keys = dict.fromkeys([(code, source), (code, EVERYONE)])
        listeners = [listener for key in keys for listener in self._listeners.get(key, ())]
        heard = [listener for listener in listeners if self._notify(listener, payload, source)]
        for waiter in self._waiters:
            try:
                if waiter.take(payload, source, self.registry):
                    return True
            except DecodeError as error:
                waiter.problem = f"{waiter.kinds[0].NAME}: {error}"
                if not heard:
                    self.on_malformed(waiter.problem)
                return True
        return bool(heard)

    def note_unexpected(self, name: str, source: JausID) -> None:
        """Note, for the error messages of waiters, that a message of this name arrived and nobody took it."""
        for waiter in self._waiters:
            if waiter.source.matches(source):
                waiter.other = name

    @contextmanager
    def waiting(
        self,
        source: JausID,
        *kinds: type[Message],
        accept: Callable[[Message], bool] = lambda _: True,
    ) -> Iterator[ReplyWaiter]:
        """Wait for one message of these classes from `source`, which may be a wildcard, that `accept` allows."""
        waiter = ReplyWaiter(source, kinds, accept, asyncio.get_running_loop().create_future())
        self._waiters.append(waiter)
        try:
            yield waiter
        finally:
            self._waiters.remove(waiter)
            if not waiter.reply.cancel() and not waiter.reply.cancelled():
                waiter.reply.exception()  # retrieved, so that asyncio does not log one that nobody awaits any more

    @contextmanager
    def listening(
        self, source: JausID, callback: Callable[[Message, JausID], None], *kinds: type[Message]
    ) -> Iterator[None]:
        """Call `callback` at once for every message of these classes from `source`, which may be a wildcard."""
        listener = _Listener(source, kinds, callback)
        keys = {(kind.CODE, EVERYONE if source.is_wildcard else source) for kind in kinds}
        for key in keys:
            self._listeners[key].append(listener)
        try:
            yield
        finally:
            for key in keys:
                self._listeners[key].remove(listener)
                if not self._listeners[key]:
                    del self._listeners[key]

    def fail(self, error: Exception) -> None:
        """End every wait with this error."""
        for waiter in self._waiters:
            if not waiter.reply.done():
                waiter.reply.set_exception(error)

    def _notify(self, listener: _Listener, payload: bytes, source: JausID) -> bool:
        kind = _kind_of(payload, listener.kinds)
        if kind is None or not listener.source.matches(source):
            return False
        try:
            message = self.registry.decode_as(kind, payload)
        except CodecError as error:
            self.on_malformed(f"{kind.NAME} from {source}: {error}")
            return True
        listener.callback(message, source)
        return True


def _kind_of(payload: bytes, kinds: tuple[type[Message], ...]) -> type[Message] | None:
    """The class of these that has the message id of this payload."""
    code = message_id(payload)
    return next((kind for kind in kinds if code == kind.CODE), None)


# --- queries whose answers look alike ---------------------------------------------------------------------------------


@dataclass(slots=True)
class _Queue:
    content: bytes = b""
    active: int = 0
    waiting: int = 0
    turn: asyncio.Event = field(default_factory=asyncio.Event)


class QuerySerializer:
    """Queries of one key: equal ones may be outstanding at the same time, different ones wait for each other.

    A key exists only while a query of it does.
    """

    def __init__(self) -> None:
        self._queues: dict[Hashable, _Queue] = {}

    def __len__(self) -> int:
        return len(self._queues)

    @asynccontextmanager
    async def enter(self, key: Hashable, content: bytes) -> AsyncIterator[None]:
        """Enter at once when only queries of equal content are inside, else wait until they have left."""
        queue = self._queues.setdefault(key, _Queue())
        try:
            await self._wait(queue, content)
            queue.content = content
            queue.active += 1
            try:
                yield
            finally:
                queue.active -= 1
        finally:
            if not queue.active:
                queue.turn.set()
                if not queue.waiting:
                    self._queues.pop(key, None)

    async def _wait(self, queue: _Queue, content: bytes) -> None:
        """A new query waits behind all that wait already, so that none of these waits for ever."""
        has_turn = not queue.waiting
        queue.waiting += 1
        try:
            while not has_turn or (queue.active and queue.content != content):
                queue.turn.clear()
                await queue.turn.wait()
                has_turn = True
        finally:
            queue.waiting -= 1
