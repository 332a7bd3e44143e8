"""Authentication of JUDP between node managers that share a key (ADR 86). It is not part of AS5669A.

An authenticated datagram: kind u8 | sender u64 | recipient u64 | counter u64 | milliseconds since 1970 u64 | tag 16
bytes | content, big endian. The tag is the first half of the HMAC-SHA256 of everything else. `sender` is a random
number, new with every start; `recipient` is that of the receiver, 0 in multicasts and while it is not known. The
content of kind 0xA5 is a JUDP datagram.

Nothing is accepted from an address until the sender has answered a challenge there: 0xA6, whose content is the counter
of the datagram that was not accepted and the sender's address as its receiver sees it. The answer, 0xA7, returns both;
who has another address does not answer. What was not accepted is then sent again. Both contents begin like a
safety-critical packet, so that they are read first.
"""

from __future__ import annotations

import hmac
import struct
from collections import OrderedDict, deque
from collections.abc import Callable
from typing import Final, NamedTuple, TypeVar

from jauspy.errors import ProtocolError
from jauspy.protocol import header
from jauspy.protocol.address_book import Address
from jauspy.protocol.duplicates import ReplayWindow
from jauspy.protocol.header import Priority
from jauspy.protocol.sources import TokenBuckets

MAGIC: Final = 0xA5
"""First byte, in place of the version byte; node managers without authentication drop it as an unknown version."""
CHALLENGE: Final = 0xA6
ANSWER: Final = 0xA7
MAX_AGE: Final = 30.0
"""Seconds that the clocks of two machines may differ, and for which a datagram can be held back."""
MAX_SENDERS: Final = 1024
MIN_KEY_LENGTH: Final = 16
CHALLENGE_RATE: Final = 5.0
"""Challenges per second to one address."""
MAX_RECENT: Final = 64
"""Datagrams that are remembered, because their receiver may challenge them; the oldest is forgotten first."""
RESEND_TIME: Final = 0.5
"""Seconds after which a datagram that was not accepted is not sent again."""
_TAG: Final = 16
_HEAD: Final = struct.Struct(">BQQQQ")
_CONTENT: Final = struct.Struct(">5sQ")
_PRIORITY: Final = bytes((header.VERSION, 0, 0, 0, Priority.SAFETY_CRITICAL))
OVERHEAD: Final = _HEAD.size + _TAG


_K = TypeVar("_K")
_V = TypeVar("_V")


class _Sent(NamedTuple):
    """A datagram that was sent; `to` None is the multicast group."""

    counter: int
    utc: float
    to: Address | None
    datagram: bytes


class Authenticator:
    """Signs and verifies datagrams; `poll_output` returns what is to be sent in addition, signed.

    `session` is a random number of 64 bits, new with every start. `utc` is in seconds since 1970. `is_own(host, peer)`
    is true for an address of this machine, by which `peer` has reached it.
    """

    def __init__(self, key: bytes, session: int, is_own: Callable[[str, Address], bool] = lambda *_: True) -> None:
        self.is_own = is_own
        self._hmac = hmac.new(key, digestmod="sha256")
        self._session = session
        self._sent = 0
        self._sessions: OrderedDict[Address, int] = OrderedDict()
        """The session of each peer, for `recipient`."""
        self._confirmed: OrderedDict[tuple[Address, int], None] = OrderedDict()
        """Peers that have had an answer of this one."""
        self._proven: OrderedDict[tuple[Address, int], None] = OrderedDict()
        """Peers that have answered."""
        self._windows: OrderedDict[int, ReplayWindow] = OrderedDict()
        self._recent: deque[_Sent] = deque(maxlen=MAX_RECENT)
        self._challenges = TokenBuckets(CHALLENGE_RATE, 1.0, limit=MAX_SENDERS)
        self._output: list[tuple[Address, bytes]] = []

    def sign(self, datagram: bytes, utc: float, destination: Address | None) -> bytes:
        """The signed datagram for one address, or with None for the multicast group."""
        recipient = 0 if destination is None else self._sessions.get(destination, 0)
        signed = self._sign(MAGIC, datagram, utc, recipient)
        self._recent.append(_Sent(self._sent, utc, destination, datagram))
        return signed

    def verify(self, data: bytes, utc: float, source: Address) -> bytes | None:
        """The datagram that was signed, or None for a challenge or answer.

        Raises `ProtocolError` for one that is unsigned, forged, stale, replayed, our own, or from an address where the
        sender has not answered a challenge.
        """
        if len(data) <= OVERHEAD or not MAGIC <= data[0] <= ANSWER:
            raise ProtocolError("unauthenticated", "the datagram is not signed")
        head, tag, content = data[: _HEAD.size], data[_HEAD.size : OVERHEAD], data[OVERHEAD:]
        if not hmac.compare_digest(tag, self._tag(head, content)):
            raise ProtocolError("forged", "the datagram was signed with another key")
        kind, sender, recipient, counter, milliseconds = _HEAD.unpack(head)
        if sender == self._session:
            raise ProtocolError("own", "the datagram is our own")
        if abs(utc - milliseconds / 1000) > MAX_AGE:
            raise ProtocolError("stale", f"signed {utc - milliseconds / 1000:.0f} s ago; are the clocks right?")
        peer = (source, sender)
        if kind == MAGIC:
            if recipient not in (0, self._session) or peer not in self._proven or sender not in self._windows:
                self._challenge(source, sender, counter, utc)
                raise ProtocolError("unproven", f"{sender:016x} has to prove that it is at {source[0]}:{source[1]}")
            self._check_replay(sender, counter)
            self._proven.move_to_end(peer)  # whoever makes up senders displaces those, and nobody who sends
            return content
        if recipient != self._session:
            raise ProtocolError("replayed", f"a challenge or answer for {recipient:016x}, which is not this one")
        self._check_replay(sender, counter)
        if kind == CHALLENGE:
            self._answer(content, peer, counter, utc)
        elif content[_CONTENT.size :] == _text(source):
            _put(self._proven, peer, None)
            _put(self._sessions, source, sender)
        else:
            raise ProtocolError("moved", f"an answer of {content!r} came from {source[0]}:{source[1]}")
        return None

    def poll_output(self) -> list[tuple[Address, bytes]]:
        """The challenges, answers and repeated datagrams to send now, by address."""
        output, self._output = self._output, []
        return output

    def _challenge(self, source: Address, sender: int, counter: int, utc: float) -> None:
        if self._challenges.take((source, sender), utc):
            self._output.append(
                (source, self._sign(CHALLENGE, _CONTENT.pack(_PRIORITY, counter) + _text(source), utc, sender))
            )

    def _answer(self, content: bytes, peer: tuple[Address, int], counter: int, utc: float) -> None:
        """Answer a challenge, send again what was not accepted, and challenge in turn."""
        source, sender = peer
        host = content[_CONTENT.size :].rpartition(b" ")[0].decode("ascii", "replace")
        if len(content) <= _CONTENT.size or not self.is_own(host, source):
            raise ProtocolError("not_our_address", f"{source[0]}:{source[1]} receives from {host}, which is not ours")
        is_first = peer not in self._confirmed  # later, it is a replay that the peer has challenged
        _put(self._sessions, source, sender)
        _put(self._confirmed, peer, None)
        self._output.append((source, self._sign(ANSWER, content, utc, sender)))
        _, first = _CONTENT.unpack_from(content)
        for sent in self._recent:
            if is_first and sent.counter >= first and utc - sent.utc < RESEND_TIME and sent.to in (None, source):
                self._output.append((source, self._sign(MAGIC, sent.datagram, utc, sender)))
        if peer not in self._proven:
            self._challenge(source, sender, counter + 1, utc)

    def _sign(self, kind: int, content: bytes, utc: float, recipient: int) -> bytes:
        self._sent += 1
        head = _HEAD.pack(kind, self._session, recipient, self._sent, int(utc * 1000))
        return head + self._tag(head, content) + content

    def _tag(self, head: bytes, content: bytes) -> bytes:
        mac = self._hmac.copy()
        mac.update(head)
        mac.update(content)
        return mac.digest()[:_TAG]

    def _check_replay(self, sender: int, counter: int) -> None:
        """Record a counter; `ProtocolError` when it is known or too old. None before the first one is accepted."""
        window = self._windows.get(sender)
        if window is None:
            window = ReplayWindow(counter - 1)
        if not window.is_new(counter):
            raise ProtocolError("replayed", f"number {counter} of {sender:016x} came again")
        window.add(counter)
        _put(self._windows, sender, window)


def _text(address: Address) -> bytes:
    return f"{address[0]} {address[1]}".encode()


def _put(table: OrderedDict[_K, _V], key: _K, value: _V) -> None:
    table[key] = value
    table.move_to_end(key)
    if len(table) > MAX_SENDERS:
        table.popitem(last=False)
