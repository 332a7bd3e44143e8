"""A link that delays and loses the packets of a video, on virtual time: real sockets, a clock that the caller moves."""

from __future__ import annotations

import heapq
import random
import socket
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass, field
from itertools import pairwise
from types import TracebackType
from typing import Final, Self, TypeAlias

from jauspy.video.h264_payload import Picture
from jauspy.video.receiver import RtpReceiver, socket_pair
from jauspy.video.sender import RtpSender

STEP: Final = 0.005
"""Seconds of virtual time between two looks at the sockets."""
MAX_DATAGRAM: Final = 65536

Losses: TypeAlias = Iterator[bool]
"""For each packet, whether it is lost."""


def random_losses(rate: float, seed: int) -> Losses:
    """Each packet is lost with the same probability, 0..1."""
    chance = random.Random(seed)  # noqa: S311 - no secret
    while True:
        yield chance.random() < rate


def burst_losses(rate: float, length: float, seed: int) -> Losses:
    """Packets are lost in bursts of this mean length, in packets, and `rate` of all (Gilbert's model)."""
    chance = random.Random(seed)  # noqa: S311 - no secret
    end = 1.0 / length
    begin = rate * end / (1.0 - rate)
    is_lost = False
    while True:
        is_lost = chance.random() >= end if is_lost else chance.random() < begin
        yield is_lost


@dataclass(slots=True)
class Direction:
    """One direction of the link, and what has passed it."""

    losses: Losses
    delay: float
    packets: int = 0
    lost: int = 0
    octets: int = 0
    """Bytes that were sent into the link, with the headers of UDP and IPv4."""
    _under_way: list[tuple[float, int, int, bytes]] = field(default_factory=list)

    def send(self, datagram: bytes, channel: int, now: float) -> None:
        """Put a datagram into the link."""
        self.packets += 1
        self.octets += len(datagram) + 28
        if next(self.losses):
            self.lost += 1
        else:
            heapq.heappush(self._under_way, (now + self.delay, self.packets, channel, datagram))

    def arrived(self, now: float) -> Iterator[tuple[int, bytes]]:
        """Take out what has passed it: the channel (0: RTP, 1: RTCP), and the datagram."""
        while self._under_way and self._under_way[0][0] <= now:
            _, _, channel, datagram = heapq.heappop(self._under_way)
            yield channel, datagram


class BadLink:
    """Stands between a sender, which sends to `address`, and a receiver on this machine, for RTP and RTCP."""

    def __init__(self, port: int, to: Direction, back: Direction) -> None:
        self.to, self.back = to, back
        self._sockets = socket_pair("127.0.0.1")
        self._receiver = (("127.0.0.1", port), ("127.0.0.1", port + 1))
        self._sender: tuple[str, int] | None = None

    @property
    def address(self) -> tuple[str, int]:
        """Where the sender sends to."""
        return "127.0.0.1", int(self._sockets[0].getsockname()[1])

    def pass_on(self, now: float) -> None:
        """Take what was sent until now, and deliver what has arrived; seconds."""
        for channel, opened in enumerate(self._sockets):
            for datagram, source in _received(opened):
                if source in self._receiver:
                    self.back.send(datagram, channel, now)
                else:
                    self._sender = source
                    self.to.send(datagram, channel, now)
        for channel, datagram in self.to.arrived(now):
            self._sockets[channel].sendto(datagram, self._receiver[channel])
        for channel, datagram in self.back.arrived(now):
            if self._sender is not None:
                self._sockets[channel].sendto(datagram, self._sender)

    def close(self) -> None:
        """Close the sockets; without effect when closed."""
        for opened in self._sockets:
            opened.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()


def _received(opened: socket.socket) -> Iterator[tuple[bytes, tuple[str, int]]]:
    with suppress(BlockingIOError):
        while True:
            yield opened.recvfrom(MAX_DATAGRAM)


@dataclass(slots=True)
class Watched:
    """What was seen at the far end of a link; seconds of virtual time."""

    shown: list[tuple[float, float]] = field(default_factory=list)
    """When a picture was shown, and when it had been taken."""
    damaged: int = 0
    """Pictures that were shown although a part of them, or of one before, was lost."""
    counters: dict[str, int] = field(default_factory=dict)
    bit_rate: float = 0.0
    """Bits a second on the link."""

    def ages(self, begin: float, end: float) -> list[float]:
        """The age of what is shown at each moment, sorted."""
        found = []
        for (at, taken), (until, _) in pairwise([*self.shown, (end, end)]):
            moment = max(at, begin)
            while moment < min(until, end):
                found.append(moment - taken)
                moment += STEP
        return sorted(found)

    def longest_freeze(self, begin: float, end: float) -> float:
        """The longest time without a new picture."""
        times = [begin, *(at for at, _ in self.shown if begin <= at < end), end]
        return max(later - earlier for earlier, later in pairwise(times))


def watch(
    encode: Callable[[int, bool, float], list[bytes]],
    to: Direction,
    back: Direction,
    *,
    rate: int = 15,
    seconds: float = 60.0,
    parity: bool = True,
    show_damaged: bool = False,
) -> Watched:
    """Send a video over a link. `encode` has the NAL units of a picture by number, whether an IDR, and parity's share.

    A picture is shown as in the console: not when a part of it or of one before is missing, unless `show_damaged`.
    """
    watched, now, sent, is_broken = Watched(), 0.0, 0, True
    with (
        RtpReceiver(parity=parity, clock=lambda: now) as receiver,
        RtpSender("bad link") as sender,
        BadLink(receiver.port, to, back) as link,
    ):
        sender.add(link.address)
        while now < seconds:
            if now >= sent / rate:
                sender.send(encode(sent, sender.needs_idr(now), sender.share), now, now)
                sent += 1
            link.pass_on(now)
            for picture in receiver.take():
                is_broken = not picture.whole or (is_broken and not picture.is_idr)
                if show_damaged or not is_broken:
                    watched.shown.append((now, _taken(receiver, picture)))
                    watched.damaged += is_broken
            now += STEP
        watched.counters, watched.bit_rate = dict(receiver.counters), 8.0 * to.octets / seconds
    return watched


def _taken(receiver: RtpReceiver, picture: Picture) -> float:
    taken = receiver.taken(picture)
    return float("-inf") if taken is None else taken
