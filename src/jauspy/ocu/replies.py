"""Hands what arrives to whoever waits for it: by sender and message class."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import TypeAlias

from jauspy.codec.message import Message
from jauspy.codec.registry import Registry
from jauspy.errors import CodecError, DecodeError
from jauspy.ids import JausID

Arrival: TypeAlias = tuple[Message, JausID]
Tap: TypeAlias = Callable[[Message, JausID], None]


@dataclass(slots=True, eq=False)
class Waiter:
    """One answer somebody waits for.

    `problem` says what was wrong with answers that could not be read, `instead` what else came that nobody wanted.
    """

    source: JausID
    kinds: tuple[type[Message], ...]
    accept: Callable[[Message], bool]
    arrival: asyncio.Future[Arrival]
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
class _Tapped:
    source: JausID
    kinds: tuple[type[Message], ...]
    tap: Tap


@dataclass(slots=True)
class Replies:
    """Taps see every message of their kinds; of the waiters, the one that has waited longest takes it."""

    registry: Registry
    malformed: Callable[[str], None]
    _waiters: list[Waiter] = field(default_factory=list)
    _taps: list[_Tapped] = field(default_factory=list)

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
    ) -> Iterator[Waiter]:
        """Wait for one message of these kinds from `source` (wildcards are understood) that `accept` likes."""
        waiter = Waiter(source, kinds, accept, asyncio.get_running_loop().create_future())
        self._waiters.append(waiter)
        try:
            yield waiter
        finally:
            self._waiters.remove(waiter)
            if not waiter.arrival.cancel() and not waiter.arrival.cancelled():
                waiter.arrival.exception()  # looked at, so that nobody complains when it came too late to be raised

    @contextmanager
    def tapped(self, source: JausID, tap: Tap, *kinds: type[Message]) -> Iterator[None]:
        """Call `tap` at once for every message of these kinds from `source`; wildcards are understood."""
        entry = _Tapped(source, kinds, tap)
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

    def _try_tap(self, entry: _Tapped, payload: bytes, source: JausID) -> bool:
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
