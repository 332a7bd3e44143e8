"""Small injectors of faults: in what a component hears or says, in datagrams, in a method of a service."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from contextlib import ExitStack
from dataclasses import dataclass
from typing import Any, Final
from unittest.mock import patch

from tests.conformance.simulated import examined, robot

from jauspy.codec.message import Message
from jauspy.conformance import Report, TargetComponent, VirtualTarget, waypoint_drive
from jauspy.ids import JausID
from jauspy.protocol import judp
from jauspy.protocol.header import Packet

Injector = Callable[[], tuple[type[TargetComponent], type[VirtualTarget], list[Any]]]
"""What to build the robot of, and what to patch while it lives."""


ENOUGH: Final = 15.0
"""Timeouts in which a simulated robot is at the next corner, or never gets there."""


@dataclass(frozen=True)
class Fault:
    """`trips`: steps that must not pass because of it."""

    name: str
    profile: str
    trips: tuple[str, ...]
    inject: Injector
    timeout: int | None = None
    motion: bool = False
    """Let the robot drive; others stand still, which is faster."""
    still: bool = False
    """It may be told to move, but no time passes for its body, which is faster."""
    only: tuple[str, ...] = ()

    def __str__(self) -> str:
        return f"{self.profile}: {self.name}"

    def run(self) -> Report:
        """The profile against the broken robot."""
        part, virtual_target, patches = self.inject()
        with ExitStack() as stack:
            for each in (patch.object(waypoint_drive, "SIDE_TIMEOUT", ENOUGH), *patches):
                stack.enter_context(each)
            still: dict[str, Any] = {} if self.motion and not self.still else {"tick": None}
            target = robot(part, virtual_target, timeout=self.timeout, **still)
            return examined(self.profile, target, motion=self.motion, only=self.only)


def hears(change: Callable[[bytes, JausID], bytes | None]) -> Injector:
    """Messages that come in are changed, or lost."""

    class Deaf(TargetComponent):
        def receive(self, payload: bytes, source: JausID, now: float) -> None:
            heard = change(payload, source)
            if heard is not None:
                super().receive(heard, source, now)

    return lambda: (Deaf, VirtualTarget, [])


def says(change: Callable[[bytes, JausID], Iterable[bytes]]) -> Injector:
    """Messages that go out are changed, lost or doubled."""

    class Liar(TargetComponent):
        def send(self, outgoing: Any, now: float) -> None:
            for payload in change(outgoing.payload, outgoing.destination):
                super().send(outgoing._replace(payload=payload), now)

    return lambda: (Liar, VirtualTarget, [])


def patched(owner: object, **methods: object) -> Injector:
    """Methods of a class, or names of a module, are other ones."""
    return lambda: (TargetComponent, VirtualTarget, [patch.object(owner, name, new) for name, new in methods.items()])


def handles(change: Callable[[TargetComponent, bytes], Iterable[bytes]]) -> Injector:
    """Datagrams reach the component changed."""

    class Odd(TargetComponent):
        def handle(self, datagram: bytes, now: float) -> None:
            for each in change(self, datagram):
                super().handle(each, now)

    return lambda: (Odd, VirtualTarget, [])


def works(change: Callable[[list[bytes]], list[bytes]]) -> Injector:
    """Datagrams leave the component changed."""

    class Odd(TargetComponent):
        def work(self, now: float) -> list[bytes]:
            return change(super().work(now))

    return lambda: (Odd, VirtualTarget, [])


def gets(change: Callable[[bytes], Iterable[bytes]]) -> Injector:
    """Datagrams reach the node manager changed."""

    class Odd(VirtualTarget):
        def inbound(self, datagram: bytes) -> Iterable[bytes]:
            return change(datagram)

    return lambda: (TargetComponent, Odd, [])


def code(kind: type[Message]) -> bytes:
    return kind.CODE.to_bytes(2, "little")


def without(*kinds: type[Message]) -> Injector:
    """These are never sent."""
    codes = {code(each) for each in kinds}
    return says(lambda payload, _: [] if payload[:2] in codes else [payload])


def deaf_to(*kinds: type[Message]) -> Injector:
    """These are not understood."""
    codes = {code(each) for each in kinds}
    return hears(lambda payload, _: None if payload[:2] in codes else payload)


def instead(kind: type[Message], make: Callable[[Any], Message | None]) -> Injector:
    """Another message is sent for each of this kind; the same, changed, when `make` returns nothing."""

    def change(payload: bytes, _: JausID) -> list[bytes]:
        if payload[:2] != code(kind):
            return [payload]
        message = kind.decode(payload)
        return [(make(message) or message).encode(strict=False)]

    return says(change)


def field(kind: type[Message], **values: object) -> Injector:
    """Fields of a report have these values."""

    def change(message: Any) -> None:
        for name, value in values.items():
            setattr(message, name, value)

    return instead(kind, change)


def short(kind: type[Message]) -> Injector:
    """The last byte is missing; a message without a body has one too many."""
    return says(lambda payload, _: [_spoilt(payload)] if payload[:2] == code(kind) else [payload])


def _spoilt(payload: bytes) -> bytes:
    return payload[:-1] if len(payload) > 2 else payload + b"\0"


def slow(*kinds: type[Message], seconds: float = 2.0, where: Callable[[Any], bool] = lambda _: True) -> Injector:
    """These are said late; everything, when none is named."""
    by_code = {code(each): each for each in kinds}

    def is_late(outgoing: Any) -> bool:
        kind = by_code.get(outgoing.payload[:2])
        return not kinds or (kind is not None and where(kind.decode(outgoing.payload)))

    return delayed(is_late, seconds)


def delayed(is_late: Callable[[Any], bool], seconds: float) -> Injector:
    """What is chosen among the outgoing messages is said late."""

    class Slow(TargetComponent):
        late: tuple[tuple[float, Any], ...] = ()

        def send(self, outgoing: Any, now: float) -> None:
            if is_late(outgoing):
                self.late += ((now + seconds, outgoing),)
            else:
                super().send(outgoing, now)

        def work(self, now: float) -> list[bytes]:
            out = super().work(now)
            due = [each for at, each in self.late if at <= now]
            self.late = tuple(each for each in self.late if each[0] > now)
            for each in due:
                super().send(each, now)
            return out + self.endpoint.poll_output()

        def next_timeout(self) -> float | None:
            times = [super().next_timeout(), *(at for at, _ in self.late)]
            return min((at for at in times if at is not None), default=None)

    return lambda: (Slow, VirtualTarget, [])


def later(kind: type[Message], count: int, inner: Injector) -> Injector:
    """A fault that begins when a message was heard for the so-manieth time."""

    def inject() -> tuple[type[TargetComponent], type[VirtualTarget], list[Any]]:
        broken, virtual_target, patches = inner()

        class Later(broken):  # type: ignore[misc, valid-type]
            heard = 0

            def receive(self, payload: bytes, source: JausID, now: float) -> None:
                self.heard += payload[:2] == code(kind)
                (super().receive if self.heard >= count else lambda *args: TargetComponent.receive(self, *args))(
                    payload, source, now
                )

            def send(self, outgoing: Any, now: float) -> None:
                forward = super().send if self.heard >= count else lambda *args: TargetComponent.send(self, *args)
                forward(outgoing, now)

        return Later, virtual_target, patches

    return inject


def packets(datagram: bytes) -> list[Packet]:
    return judp.unpack_all(datagram)[0]


def repacked(change: Callable[[Packet], Packet | None]) -> Callable[[list[bytes]], list[bytes]]:
    """Each packet that leaves is another one, or none."""

    def all_of(out: list[bytes]) -> list[bytes]:
        changed = (change(each) for datagram in out for each in packets(datagram))
        return [judp.pack(each) for each in changed if each is not None]

    return all_of
