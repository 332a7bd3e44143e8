"""Large messages and acknowledged ones between components of one node manager."""

import asyncio
import socket
import time
from datetime import UTC, datetime
from pathlib import Path

import pytest

from jauspy.component import Component, ComponentOptions
from jauspy.ids import JausID
from jauspy.messages.core import ReportHeartbeatPulse
from jauspy.node import NodeConfig, NodeManager, status
from jauspy.protocol.delivery import Delivery
from jauspy.protocol.header import Ack, Packet
from jauspy.services.core import Liveness
from jauspy.services.host import Host
from jauspy.transport import LocalTransport, TcpTransport, Transport

A, B = JausID.parse("101.1.1"), JausID.parse("101.1.2")


def component(transport: Transport, arrived: "asyncio.Queue[Packet]") -> Component:
    def take(packet: Packet) -> bool:
        arrived.put_nowait(packet)
        return True

    host = Host(transport.id, [Liveness()], utc_now=lambda: datetime.now(UTC), now=time.monotonic())
    return Component.of_host(
        host, transport, intercept=take, options=ComponentOptions(delivery=Delivery(max_message=16 << 20))
    )


@pytest.mark.slow
@pytest.mark.parametrize(
    ("way", "ack"),
    [
        ("local", Ack.REQUIRED),
        ("tcp", Ack.NONE),
        pytest.param("local", Ack.NONE, marks=pytest.mark.slow),
        pytest.param("tcp", Ack.REQUIRED, marks=pytest.mark.slow),
    ],
)
async def test_16_mb_message_passes_a_node_manager(root: Path, way: str, ack: Ack) -> None:
    arrived: asyncio.Queue[Packet] = asyncio.Queue()
    config = NodeConfig(address="127.0.0.1", port=0, local_root=root, tcp=True, tcp_port=0)
    async with NodeManager(config) as node:
        assert node.tcp_port is not None
        transport = LocalTransport(A, root) if way == "local" else TcpTransport(A, ("127.0.0.1", node.tcp_port))
        async with component(transport, arrived) as a, component(LocalTransport(B, root), arrived):
            payload = b"\x01\x40" + bytes(range(256)) * (1 << 16)
            a._endpoint.send(B, payload[: 16 << 20], now=time.monotonic(), ack=ack)
            a.wake()
            async with asyncio.timeout(200):
                packet = await arrived.get()
            assert packet.payload == payload[: 16 << 20]
            if ack is Ack.REQUIRED:
                await a.deliver(B, ReportHeartbeatPulse())
                assert a.counters["endpoint.delivered"] == 2


async def test_ipv6(root: Path) -> None:
    try:
        with socket.socket(socket.AF_INET6, socket.SOCK_DGRAM) as probe:
            probe.bind(("::1", 0))
    except OSError:
        pytest.skip("this system has no IPv6")
    near = NodeConfig(address="127.0.0.1", port=0, local_root=root / "a", address6="::1")
    arrived: asyncio.Queue[Packet] = asyncio.Queue()
    async with NodeManager(near) as first:
        book = {str(A): f"udp://[::1]:{first.port}"}
        far = NodeConfig(address="127.0.0.1", port=0, local_root=root / "b", address6="::1", addresses=book)
        async with (
            NodeManager(far),
            component(LocalTransport(A, root / "a"), arrived),
            component(LocalTransport(B, root / "b"), arrived) as b,
        ):
            await b.deliver(A, ReportHeartbeatPulse())
            assert (await arrived.get()).source == B
            (network,) = (await status.read(root / "a"))["networks"]
            assert network["address6"] == f"[::1]:{first.port}"
