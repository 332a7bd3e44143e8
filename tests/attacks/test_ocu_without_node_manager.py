"""An operator's program without a node manager is told by others where its robot is."""

from __future__ import annotations

import asyncio
import socket
from collections.abc import Callable

from jauspy.ids import EVERYONE, JausID
from jauspy.protocol import judp
from jauspy.protocol.header import Packet
from jauspy.testing import until
from jauspy.transport import UdpTransport

OPERATOR, ROBOT = JausID.parse("42.1.1"), JausID.parse("101.1.102")


async def test_nobody_else_gets_what_is_for_the_robot(udp: Callable[..., socket.socket], free_port: int) -> None:
    loop = asyncio.get_running_loop()
    robot, attacker = udp("127.0.0.2"), udp("127.0.0.66")
    transport = UdpTransport(OPERATOR, peer=robot.getsockname(), bind=("0.0.0.0", free_port))
    await transport.open()
    where = ("127.0.0.1", free_port)
    heard: list[bytes] = []
    transport.received = heard.append
    try:
        for number in range(40):
            report = judp.pack(Packet(ROBOT, OPERATOR, b"\x02\x44", number))
            robot.sendto(report, where)
            await until(lambda report=report: heard[-1:] == [report])
            for to in (EVERYONE, OPERATOR):
                attacker.sendto(judp.pack(Packet(ROBOT, to, b"\x02\x40", number + 1)), where)
            await until(lambda number=number: transport.counters["dropped.address_mismatch"] == 2 * number + 2)
            command = judp.pack(Packet(OPERATOR, ROBOT, b"\x05\x04", number))
            transport.send(command)
            async with asyncio.timeout(20):
                assert await loop.sock_recv(robot, 5000) == command
        assert len(heard) == 40
    finally:
        await transport.close()
