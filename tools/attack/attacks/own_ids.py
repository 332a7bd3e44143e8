"""Ids of the robot's machine that no program has at the time, used from the network."""

from __future__ import annotations

from jauspy.ids import JausID
from jauspy.messages.mobility import QueryLocalPose
from jauspy.protocol import judp
from jauspy.protocol.header import Packet

from ..arena import ROBOT, Arena
from ..attack import Attack, Attacker, Layout

RATE = 200
OWN = "101.3.*"


def run(arena: Arena) -> None:
    """None of the queries is answered."""
    sock = arena.open(arena.attacker.udp())
    query = QueryLocalPose(0x1FF).encode()
    for number in arena.paced(RATE):
        arena.send(sock, judp.pack(Packet(JausID(101, 3, 1 + number % 200), ROBOT, query, number & 0xFFFF)))
        try:
            answer = sock.recv(70000)
        except BlockingIOError:
            continue
        arena.require(not answer, "an id of the robot's own machine was accepted from the network")


ATTACK = Attack("own-ids", Attacker.REMOTE, "queries", run, layout=Layout(settings={"own_ids": [OWN]}))
