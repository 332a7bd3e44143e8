"""A host, run as a program: a node manager, and a component that sends to others and tells what became of it.

python member.py '{"root": "/tmp/x", "id": "101.1.1", "others": ["102.1.1"], "count": 20, "settings": {}}'

It says `ready`, sends on the line `go`, says `sent`, and on the line `stop` what it sent and received, as JSON.
"""

import asyncio
import json
import random
import sys
import time
from pathlib import Path

from jauspy.ids import JausID
from jauspy.node import NodeConfig, NodeManager
from jauspy.protocol.delivery import Delivery
from jauspy.protocol.endpoint import Endpoint
from jauspy.protocol.header import Ack
from jauspy.transport import LocalTransport

WINDOW = 4
"""Messages to one other at once."""


class Member:
    def __init__(self, reported: dict) -> None:
        self.reported = reported
        self.id = JausID.parse(reported["id"])
        self.endpoint = Endpoint(self.id, first_sequence=random.randrange(65536), delivery=Delivery(resends=20))
        self.transport = LocalTransport(self.id, Path(reported["root"]))
        self.transport.received = self.take
        self.received: list[str] = []
        self.outcomes: dict[int, asyncio.Future[bool]] = {}

    def take(self, datagram: bytes) -> None:
        self.endpoint.receive(datagram, time.monotonic())
        self.pump()

    def pump(self) -> None:
        for datagram in self.endpoint.poll_output():
            self.transport.send(datagram)
        while (packet := self.endpoint.next_event()) is not None:
            self.received.append(packet.payload[2:].decode().strip())
        while (outcome := self.endpoint.next_outcome()) is not None:
            ticket, delivered, _ = outcome
            self.outcomes.pop(ticket).set_result(delivered)

    async def tick(self) -> None:
        while True:
            self.endpoint.handle_timeout(time.monotonic())
            self.pump()
            await asyncio.sleep(0.005)

    async def deliver(self, other: str, number: int) -> tuple[str, bool]:
        text = f"{self.id} {other} {number}"
        large = number % 5 == 4
        payload = b"\x02\x20" + text.encode().ljust(20000 if large else 0)
        ticket = self.endpoint.send(JausID.parse(other), payload, now=time.monotonic(), ack=Ack.REQUIRED)
        future = self.outcomes[ticket] = asyncio.get_running_loop().create_future()
        self.pump()
        return text, await future

    async def send_all(self) -> dict[str, bool]:
        async def to(other: str, first: int) -> list[tuple[str, bool]]:
            return [await self.deliver(other, number) for number in range(first, self.reported["count"], WINDOW)]

        parts = await asyncio.gather(
            *(to(other, first) for other in self.reported["others"] for first in range(WINDOW))
        )
        return dict(each for part in parts for each in part)


async def line() -> str:
    return (await asyncio.to_thread(sys.stdin.readline)).strip()


async def main() -> None:
    reported = json.loads(sys.argv[1])
    config = NodeConfig.make(local_root=reported["root"], **reported["settings"])
    member = Member(reported)
    async with NodeManager(config) as node:
        await member.transport.open()
        ticking = asyncio.create_task(member.tick())
        print("ready", flush=True)
        assert await line() == "go"
        sent = await member.send_all()
        print("sent", flush=True)
        assert await line() == "stop"
        ticking.cancel()
        await member.transport.close()
        print(
            json.dumps(
                {"sent": sent, "received": member.received, "counters": {**node.counters, **member.endpoint.counters}}
            ),
            flush=True,
        )


if __name__ == "__main__":
    asyncio.run(main())
