"""A target that answers as it is told: payload in, answers with their delays out."""

from __future__ import annotations

import heapq
from collections.abc import Callable, Collection, Iterable
from itertools import count

from jauspy.conformance.link import PORTS, RAW, Arrival
from jauspy.ids import JausID
from jauspy.protocol import judp
from jauspy.protocol.header import Packet

Script = Callable[[bytes], Iterable[tuple[float, bytes]]]


class ScriptedLink:
    features: Collection[str] = (RAW, PORTS)
    first_sequence = 0

    def __init__(self, id: str, script: Script) -> None:
        self.id = JausID.parse(id)
        self.script = script
        self.time = 0.0
        self.sent: list[Packet] = []
        self._order = count()
        self._air: list[tuple[float, int, bytes]] = []

    def now(self) -> float:
        return self.time

    def join(self, id: JausID) -> None:
        pass

    def send(self, datagram: bytes, source: JausID, *, other_port: bool = False) -> None:
        for packet in judp.unpack(datagram):
            self.sent.append(packet)
            for delay, payload in self.script(packet.payload):
                number = next(self._order)
                answer = judp.pack(Packet(self.id, source, payload, number & 0xFFFF))
                heapq.heappush(self._air, (self.time + delay, number, answer))

    def receive(self, until: float) -> Arrival | None:
        due = self._air[0][0] if self._air else until
        self.time = max(self.time, min(due, until))
        return Arrival(heapq.heappop(self._air)[2]) if self._air and due <= until else None

    def close(self) -> None:
        pass
