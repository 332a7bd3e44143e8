"""A robot that takes sealed commands only, on a network that anybody can hear, and where anybody can forge addresses.

What the operator's program sends is recorded, and sent again as if from it: as it was, without the seal, under other
ids, to another component, cut off, with flipped bits, with another command inside, and in another order. To the program
itself come refusals and challenges as if from the robot.
"""

from __future__ import annotations

import math
import socket
from dataclasses import replace
from typing import Final

from jauspy.errors import JausError
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.mobility import SetWrenchEffort
from jauspy.messages.operators import QuerySealChallenge, RejectCommand, ReportSealChallenge, SealedCommand
from jauspy.protocol import judp
from jauspy.protocol.header import Ack, DataFlag, Packet, Priority
from jauspy.services.core.command_events import encoded

from ..arena import PILOT, STRANGER, Arena
from ..attack import Attack, Attacker, Bounds, Layout
from ..commander import ARM, DRIVER
from ..stage import PORT
from .replay import heard, recorder

RATE = 400
FORGERIES_EACH: Final = 8
"""One datagram in so many goes to the operator's program."""
MAX_RECORDED: Final = 500
_COMPONENTS: Final = (DRIVER, ARM)
_WRENCH: Final = SetWrenchEffort(propulsive_linear_effort_x=90.0, propulsive_rotational_effort_z=60.0).encode()
_MOTION: Final = frozenset({"SetWrenchEffort", "SetVelocityCommand", "SetJointEffort", "Resume", "RequestControl"})
"""Commands that the program must not send without a seal."""


class Recorder:
    """The sealed commands of the program, as packets."""

    def __init__(self, arena: Arena) -> None:
        self._arena = arena
        self._socket: socket.socket = arena.open(recorder(arena))
        self._operator = socket.inet_aton(arena.hosts["operator"].address)
        self.sealed: list[Packet] = []
        self.plain: list[str] = []

    def listen(self) -> None:
        """Record what was sent since the last time."""
        for data in heard(self._socket, self._operator):
            try:
                packets = judp.unpack(data)
            except JausError:
                continue
            for packet in packets:
                self._record(packet)
        del self.sealed[:-MAX_RECORDED]

    def _record(self, packet: Packet) -> None:
        if packet.source != PILOT or packet.ack is Ack.ACK or packet.data_flag is not DataFlag.SINGLE:
            return
        code = int.from_bytes(packet.payload[:2], "little")
        if code == SealedCommand.CODE:
            self.sealed.append(packet)
            return
        name = next((kind.NAME for kind in registry.by_code(code)), "")
        if name in _MOTION:
            self.plain.append(name)


def attacked(arena: Arena, packet: Packet, number: int) -> Packet:
    """A recorded command, changed in one of several ways."""
    chance = arena.chance
    sealed = registry.decode(packet.payload)
    assert isinstance(sealed, SealedCommand)
    payload = bytearray(packet.payload)
    fresh = replace(packet, sequence=chance.randrange(1 << 16), ack=Ack.NONE)
    kind = number % 9
    if kind == 0:
        return fresh
    if kind == 1:
        return replace(fresh, payload=encoded(sealed.command))
    if kind == 2:
        return replace(fresh, source=chance.choice((STRANGER, JausID(42, 1, 9))))
    if kind == 3:
        return replace(fresh, destination=chance.choice(_COMPONENTS))
    if kind == 4:
        return replace(fresh, payload=bytes(payload[: chance.randrange(2, len(payload))]))
    if kind == 5:
        payload[chance.randrange(2, len(payload))] ^= 1 << chance.randrange(8)
        return replace(fresh, payload=bytes(payload))
    if kind == 6:
        other = replace(sealed, source=int(STRANGER), command=_WRENCH)
        return replace(fresh, source=STRANGER, payload=other.encode())
    command = chance.choice((_WRENCH, sealed.command))
    later = replace(sealed, command=command, counter=sealed.counter + chance.randrange(1, 60))
    return replace(fresh, payload=later.encode())


def forged_answer(arena: Arena, number: int) -> Packet:
    """A refusal of any reason, or a challenge, as if from the robot."""
    chance = arena.chance
    reason = chance.choice(list(RejectCommand.Reason))
    answer = (
        RejectCommand(SetWrenchEffort.CODE, chance.randrange(200), reason)
        if number % 2
        else ReportSealChallenge(chance.randrange(1 << 40), chance.randrange(1 << 64))
    )
    return Packet(chance.choice(_COMPONENTS), PILOT, answer.encode(), chance.randrange(1 << 16), Priority.HIGH)


def run(arena: Arena, *, forge_answers: bool = False) -> None:
    """Motion is only what the operator commands, and no command of his program is ever without a seal."""
    sock, forger = arena.open(arena.attacker.udp()), arena.open(arena.attacker.forger())
    operator, record = (arena.hosts["operator"].address, PORT), Recorder(arena)
    for number in arena.paced(RATE):
        record.listen()
        arena.sent += 1
        if number % 10 == 9:
            query = Packet(STRANGER, DRIVER, QuerySealChallenge().encode(), number & 0xFFFF)
            arena.send(sock, judp.pack(query))
        elif forge_answers and number % FORGERIES_EACH == 0:
            forger.send(judp.pack(forged_answer(arena, number // FORGERIES_EACH)), arena.where, operator)
        elif record.sealed:
            packet = attacked(arena, arena.chance.choice(record.sealed[-100:]), number)
            forger.send(judp.pack(packet), operator, arena.where)
    arena.require(bool(record.sealed), "nothing could be recorded")
    arena.require(not record.plain, f"the operator's program sent {record.plain[:1]} without a seal")


def _with_answers(arena: Arena) -> None:
    run(arena, forge_answers=True)


LAYOUT = Layout(sealed=True)
ATTACK = Attack("seals", Attacker.REMOTE, "datagrams", run, layout=LAYOUT)
ANSWERS = Attack(
    "forged-refusals",
    Attacker.REMOTE,
    "datagrams",
    _with_answers,
    Bounds(driven=0.0, control=0.0, lost=1.0, silence=math.inf),
    layout=LAYOUT,
    restarts=True,
)
"""Who forges the robot's address can have the operator's program give up, which stops the robot, and nothing else."""
