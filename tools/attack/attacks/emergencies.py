"""An operator has stopped the robot; others try to end that emergency, under many ids, and to drive."""

from __future__ import annotations

import math
import time

from jauspy.ids import JausID
from jauspy.messages.core import ClearEmergency, Reset, Resume, SetEmergency
from jauspy.protocol import judp
from jauspy.protocol.header import Packet, Priority

from ..arena import OPERATOR, PILOT, ROBOT, STRANGER, Arena
from ..attack import Attack, Attacker, Bounds

RATE = 500
STOPPER = JausID.parse("42.1.3")
"""Another program of the operator, such as `jauspy estop`."""
REACTION = 0.5
"""Seconds until the robot has stopped."""


def run(arena: Arena) -> None:
    """It is in the state Emergency from the first to the last sample."""
    chance, sock, own = arena.chance, arena.open(arena.attacker.udp()), arena.open(arena.hosts["operator"].udp())
    stop = judp.pack(Packet(STOPPER, ROBOT, SetEmergency(1).encode(), 1, Priority.SAFETY_CRITICAL))
    arena.send(own, stop)
    begin = time.monotonic() + REACTION
    messages = tuple(each.encode() for each in (ClearEmergency(1), Resume(), Reset()))
    for number in arena.paced(RATE):
        made_up = JausID(chance.randrange(200, 65000), 1, 1)
        source = chance.choice((STRANGER, STOPPER, OPERATOR, PILOT, made_up))
        arena.send(sock, judp.pack(Packet(source, ROBOT, chance.choice(messages), number & 0xFFFF)))
    states = [each.states[str(ROBOT)] for each in arena.stage.samples() if each.time > begin]
    left = sum("Emergency" not in state for state in states)
    arena.require(bool(states), "the time was too short to see the emergency")
    arena.require(not left, f"the emergency was over in {left} of {len(states)} samples")


BOUNDS = Bounds(driven=0.0, control=0.0, moved=math.inf)
"""The operator has stopped the robot himself, in the middle of a drive."""
ATTACK = Attack("emergencies", Attacker.REMOTE, "messages", run, BOUNDS, restarts=True)
