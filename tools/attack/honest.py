"""The honest operator: a node manager and a component of its own, which queries a robot and counts the answers.

python honest.py '{"settings": {...}, "id": "42.1.1", "robot": "101.1.102", "rate": 50}'

It prints `ready` at the first answer. The line `begin` on its standard input starts to count; after `end` it prints
`[QUERIES, ANSWERED, SILENCE]` (the longest one, in seconds). Each query asks for another set of fields of the pose: the
answer shows which query it belongs to.
"""

from __future__ import annotations

import asyncio
import json
import sys
import time
from collections import deque
from pathlib import Path
from typing import Any, Final

from jauspy.ids import JausID
from jauspy.messages.mobility import QueryLocalPose, ReportLocalPose
from jauspy.node import NodeConfig, NodeManager
from jauspy.protocol.endpoint import Endpoint
from jauspy.transport import LocalTransport

ALL_FIELDS: Final = 0x1FF
TIMEOUT: Final = 2.0
"""Seconds in which an answer has to come."""
START_TIMEOUT: Final = 20.0
_PAUSE: Final = 0.02


class Operator:
    """Queries, and what became of them."""

    def __init__(self, id: JausID, robot: JausID, root: Path) -> None:
        self._robot = robot
        self._endpoint = Endpoint(id, first_sequence=1)
        self.transport = LocalTransport(id, root)
        self.transport.received = self._take
        self._waiting: dict[int, float] = {}
        """When each query was sent that has no answer, by its fields."""
        self._given_up = 0
        self._fields: deque[int] = deque([ALL_FIELDS])
        self.first_answer = asyncio.Event()
        self.asked = self._given_up = 0
        self.silence = 0.0
        self._heard_at = 0.0

    def ask(self) -> None:
        """Send the next query."""
        fields = self._fields[0]
        self._fields.rotate(-1)
        self._given_up += fields in self._waiting
        self._waiting[fields] = time.monotonic()
        self.asked += 1
        self._endpoint.send(self._robot, QueryLocalPose(fields).encode(), now=time.monotonic())
        for datagram in self._endpoint.poll_output():
            self.transport.send(datagram)

    def begin(self) -> None:
        """Count from now on."""
        self.asked = self._given_up = 0
        self.silence = 0.0
        self._waiting.clear()
        self._heard_at = time.monotonic()

    async def end(self) -> tuple[int, int, float]:
        """Queries since `begin`, those answered in time, and the longest silence in seconds."""
        now, asked, waiting = time.monotonic(), self.asked, list(self._waiting.items())
        silence = max(self.silence, now - self._heard_at)
        lost = self._given_up
        for _ in range(round(TIMEOUT / _PAUSE)):
            if not self._unanswered(waiting):
                break
            await asyncio.sleep(_PAUSE)
        return asked, asked - lost - self._unanswered(waiting), round(silence, 3)

    def _unanswered(self, queries: list[tuple[int, float]]) -> int:
        """How many of these queries wait for an answer."""
        return sum(self._waiting.get(fields) == at for fields, at in queries)

    def _take(self, datagram: bytes) -> None:
        self._endpoint.receive(datagram, time.monotonic())
        while (packet := self._endpoint.next_event()) is not None:
            if packet.source == self._robot and packet.payload[:2] == ReportLocalPose.CODE.to_bytes(2, "little"):
                self._count(int.from_bytes(packet.payload[2:4], "little"))

    def _count(self, fields: int) -> None:
        now = time.monotonic()
        if not self.first_answer.is_set():
            self._fields = deque(each for each in range(1, ALL_FIELDS + 1) if each & ~fields == 0)
            self.first_answer.set()
        elif fields in self._waiting and now - self._waiting[fields] < TIMEOUT:
            del self._waiting[fields]
            self.silence = max(self.silence, now - self._heard_at)
            self._heard_at = now


async def main(reported: dict[str, Any]) -> None:
    """Ask until standard input is closed."""
    config = NodeConfig.make(**reported["settings"])
    operator = Operator(JausID.parse(reported["id"]), JausID.parse(reported["robot"]), config.local_root)
    async with NodeManager(config):
        await operator.transport.open()
        async with asyncio.timeout(START_TIMEOUT):
            while not operator.first_answer.is_set():
                operator.ask()
                await asyncio.sleep(0.1)
        operator.begin()
        print("ready", flush=True)
        async with asyncio.TaskGroup() as tasks:
            asking = tasks.create_task(ask_on(operator, reported["rate"]))
            while word := (await asyncio.to_thread(sys.stdin.readline)).strip():
                if word == "begin":
                    operator.begin()
                else:
                    print(json.dumps(await operator.end()), flush=True)
            asking.cancel()
        await operator.transport.close()


async def ask_on(operator: Operator, rate: float) -> None:
    """Ask at this rate, until cancelled."""
    due = time.monotonic()
    while True:
        operator.ask()
        due = max(due + 1.0 / rate, time.monotonic() - 1.0)
        await asyncio.sleep(max(0.0, due - time.monotonic()))


if __name__ == "__main__":
    asyncio.run(main(json.loads(sys.argv[1])))
