"""Noise on a serial line: damaged frames, endless ones, and bytes at random, between frames of an honest component."""

from __future__ import annotations

import contextlib
import os
import select
import time

from jauspy.ids import JausID
from jauspy.messages.mobility import QueryLocalPose
from jauspy.protocol import jserial, judp
from jauspy.protocol.header import Packet

from ..arena import ROBOT, Arena
from ..attack import Attack, Attacker
from .malformed import damaged, random_packet

RATE = 400
HONEST = JausID.parse("45.1.1")
TIMEOUT = 2.0
_BETWEEN = 20
"""Attacks between two honest queries."""


def is_answered(line: int, number: int) -> bool:
    """True when a query by the line is answered."""
    write(line, jserial.frame(judp.pack(Packet(HONEST, ROBOT, QueryLocalPose(1).encode(), number & 0xFFFF))))
    decoder, deadline = jserial.FrameDecoder(), time.monotonic() + TIMEOUT
    while (left := deadline - time.monotonic()) > 0:
        if select.select([line], [], [], left)[0]:
            found, _ = decoder.feed(os.read(line, 4096))
            if any(int(each.source) == int(ROBOT) for data in found for each in judp.unpack(data)):
                return True
    return False


def noise(arena: Arena, number: int) -> bytes:
    """One attack on the line."""
    chance = arena.chance
    frame = jserial.frame(judp.pack(random_packet(chance)))
    if number % 4 == 0:
        return frame[: chance.randrange(len(frame))]
    if number % 4 == 1:
        return damaged(chance, frame)
    if number % 4 == 2:
        return b"\x10\x01" + chance.randbytes(chance.randrange(2000))
    return chance.randbytes(chance.randrange(200))


def write(line: int, data: bytes) -> None:
    """Write; what has no room is lost."""
    with contextlib.suppress(BlockingIOError):
        os.write(line, data)


def run(arena: Arena) -> None:
    """Noise, and at times an honest query."""
    for number in arena.paced(RATE):
        write(arena.stage.line, noise(arena, number))
        arena.sent += 1
        if number % _BETWEEN == 0:
            write(arena.stage.line, b"\x10\x03")  # a mark: what came before it does not belong to the next frame
            arena.asked += 1
            arena.lost += not is_answered(arena.stage.line, number)


ATTACK = Attack("serial-noise", Attacker.REMOTE, "writes", run)
