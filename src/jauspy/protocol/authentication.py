"""Authentication of JUDP between node managers that share a key. It is not part of AS5669A.

A signed datagram: 0xA5 | sender u64 | counter u64 | milliseconds since 1970 u64 | tag 16 bytes | the JUDP datagram,
big endian. The tag is the first half of the HMAC-SHA256 of everything else. `sender` is a random number,
new with every start.
"""

from __future__ import annotations

import hmac
import struct
from collections import OrderedDict
from typing import Final

from jauspy.errors import ProtocolError
from jauspy.protocol.duplicates import ReplayWindow

MAGIC: Final = 0xA5
"""In place of the version byte; node managers without authentication drop it as an unknown version."""
MAX_AGE: Final = 30.0
"""Seconds that the clocks of two machines may differ; a replay from an unknown sender is accepted for as long."""
MAX_SENDERS: Final = 1024
MIN_KEY_LENGTH: Final = 16
_TAG: Final = 16
_HEAD: Final = struct.Struct(">BQQQ")
OVERHEAD: Final = _HEAD.size + _TAG


class Authenticator:
    """Signs and verifies datagrams. `sender` is a random number of 64 bits; `utc` is in seconds since 1970."""

    def __init__(self, key: bytes, sender: int) -> None:
        self._hmac = hmac.new(key, digestmod="sha256")
        self._sender = sender
        self._sent = 0
        self._heard: OrderedDict[int, ReplayWindow] = OrderedDict()

    def sign(self, datagram: bytes, utc: float) -> bytes:
        """The signed datagram."""
        self._sent += 1
        head = _HEAD.pack(MAGIC, self._sender, self._sent, int(utc * 1000))
        return head + self._tag(head, datagram) + datagram

    def verify(self, data: bytes, utc: float) -> bytes:
        """The datagram that was signed; raises `ProtocolError`: unsigned, forged, stale, replayed, or our own."""
        if len(data) <= OVERHEAD or data[0] != MAGIC:
            raise ProtocolError("unauthenticated", "the datagram is not signed")
        head, tag, datagram = data[: _HEAD.size], data[_HEAD.size : OVERHEAD], data[OVERHEAD:]
        if not hmac.compare_digest(tag, self._tag(head, datagram)):
            raise ProtocolError("forged", "the datagram was signed with another key")
        _, sender, counter, milliseconds = _HEAD.unpack(head)
        if sender == self._sender:
            raise ProtocolError("own", "the datagram is our own")
        if abs(utc - milliseconds / 1000) > MAX_AGE:
            raise ProtocolError("stale", f"signed {utc - milliseconds / 1000:.0f} s ago; are the clocks right?")
        if not self._is_new(sender, counter):
            raise ProtocolError("replayed", f"number {counter} of {sender:016x} came again")
        return datagram

    def _tag(self, head: bytes, datagram: bytes) -> bytes:
        mac = self._hmac.copy()
        mac.update(head)
        mac.update(datagram)
        return mac.digest()[:_TAG]

    def _is_new(self, sender: int, counter: int) -> bool:
        """Record a counter; false when it is known or too old."""
        window = self._heard.get(sender) or ReplayWindow()
        if not window.is_new(counter):
            return False
        window.add(counter)
        self._heard[sender] = window
        self._heard.move_to_end(sender)
        if len(self._heard) > MAX_SENDERS:
            self._heard.popitem(last=False)
        return True
