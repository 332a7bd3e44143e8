"""Somebody without the key on a network that has one: commands and stops, signed with another key or not at all."""

from __future__ import annotations

import contextlib
import hmac
import time
from typing import Final

from jauspy.errors import ProtocolError
from jauspy.messages.core import SetEmergency
from jauspy.protocol import judp
from jauspy.protocol.authentication import OVERHEAD, Authenticator
from jauspy.protocol.header import Packet, Priority

from ..arena import ROBOT, STRANGER, Arena
from ..attack import Attack, Attacker, Layout

RATE = 300
OTHER_KEY: Final = b"another key than that of this network"
_TAG: Final = 16


def signed_again(datagram: bytes) -> bytes:
    """The datagram with the tag of the other key: the attacker reads what it cannot verify."""
    head, content = datagram[: OVERHEAD - _TAG], datagram[OVERHEAD:]
    return head + hmac.digest(OTHER_KEY, head + content, "sha256")[:_TAG] + content


def run(arena: Arena) -> None:
    """Challenges are answered; even a stop, which anybody may send without a key, has no effect."""
    sock = arena.open(arena.attacker.udp())
    own = Authenticator(OTHER_KEY, arena.chance.randrange(1 << 64))
    for number in arena.paced(RATE):
        stop = judp.pack(Packet(STRANGER, ROBOT, SetEmergency(1).encode(), number & 0xFFFF, Priority.HIGH))
        arena.send(sock, stop if number % 5 == 0 else own.sign(stop, time.time(), arena.where))
        with contextlib.suppress(BlockingIOError):
            data, (host, port, *_) = sock.recvfrom(70000)
            with contextlib.suppress(ProtocolError):
                own.verify(signed_again(data), time.time(), (host, port))
        for _, answer in own.poll_output():
            arena.send(sock, answer)


ATTACK = Attack("wrong-key", Attacker.REMOTE, "datagrams", run, layout=Layout(keyed=True))
