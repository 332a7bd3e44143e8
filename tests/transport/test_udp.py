"""A component that speaks JUDP itself: learned addresses and multicasts."""

import asyncio
import contextlib
import errno
import socket
from collections.abc import Iterator

import pytest

from jauspy.errors import TransportError
from jauspy.ids import EVERYONE, JausID
from jauspy.protocol import judp
from jauspy.protocol.header import Broadcast, Packet
from jauspy.transport import UdpTransport, multicast

US, PEER, OTHER = (JausID.parse(text) for text in ("42.1.1", "101.1.1", "102.1.1"))
GROUP = "239.255.0.7"


def packet(source: JausID, destination: JausID) -> bytes:
    return judp.pack(Packet(source, destination, b"\x02\x20", 1))


async def receive(sock: socket.socket) -> tuple[bytes, tuple[str, int]]:
    async with asyncio.timeout(20):
        data, sender = await asyncio.get_running_loop().sock_recvfrom(sock, 5000)
        return data, sender


@pytest.fixture
def sockets() -> Iterator[list[socket.socket]]:
    """Two peers on the loopback interface."""
    made = [socket.socket(socket.AF_INET, socket.SOCK_DGRAM) for _ in range(2)]
    for sock in made:
        sock.setblocking(False)
        sock.bind(("127.0.0.1", 0))
    yield made
    for sock in made:
        sock.close()


async def test_answers_use_learned_addresses_and_others_the_node_manager(
    sockets: list[socket.socket],
) -> None:
    near, far = sockets
    transport = UdpTransport(US, peer=near.getsockname())
    arrived: asyncio.Queue[bytes] = asyncio.Queue()
    transport.received = arrived.put_nowait
    await transport.open()
    transport.send(packet(US, PEER))
    data, address = await receive(near)
    assert data == packet(US, PEER)
    far.sendto(packet(PEER, US), address)
    assert await arrived.get() == packet(PEER, US)
    transport.send(packet(US, PEER))
    assert (await receive(far))[0] == packet(US, PEER)
    transport.send(packet(US, OTHER))
    assert (await receive(near))[0] == packet(US, OTHER)
    await transport.close()


async def test_group_is_received_without_own_datagrams(free_port: int) -> None:
    group = (GROUP, free_port)
    ours, theirs = (UdpTransport(id, group=group, bind=("127.0.0.1", 0), interface="127.0.0.1") for id in (US, PEER))
    arrived: asyncio.Queue[bytes] = asyncio.Queue()
    ours.received = theirs.received = arrived.put_nowait
    await ours.open()
    await theirs.open()
    if ours.counters["multicast.not_joined"]:
        pytest.skip("this kernel does not multicast on its loopback interface")
    everybody = judp.pack(Packet(US, EVERYONE, b"\x00\x2b\x04", 1, broadcast=Broadcast.GLOBAL))
    ours.send(everybody)
    async with asyncio.timeout(20):
        assert await arrived.get() == everybody
    theirs.send(packet(PEER, US))
    async with asyncio.timeout(20):
        assert await arrived.get() == packet(PEER, US)
    assert ours.counters["echoes"] == 1
    await ours.close()
    await theirs.close()


@pytest.mark.parametrize(("port", "clashes"), [(0, False), (1, True)], ids=["the own port", "another port"])
async def test_echo_without_an_address_is_no_clash(sockets: list[socket.socket], port: int, clashes: bool) -> None:
    """A host that has only the loopback interface, with a route for multicasts, sends them from 0.0.0.0."""
    transport = UdpTransport(US, peer=sockets[0].getsockname())
    await transport.open()
    transport.send(packet(US, PEER))
    _, (_, own) = await receive(sockets[0])
    transport._take(packet(US, EVERYONE), ("0.0.0.0", own + port))
    assert (await transport.id_clash() is not None) == clashes
    assert transport.counters["echoes"] == (not clashes)
    await transport.close()


async def test_late_network_is_joined(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(multicast, "WATCH_INTERVAL", 0.01)
    attempts: list[OSError | None] = []

    def join(self: multicast.Memberships, interface: str) -> OSError | None:
        attempts.append(None if len(attempts) > 2 else OSError(errno.ENODEV, "no such device"))
        return attempts[-1]

    monkeypatch.setattr(multicast.Memberships, "_join", join)
    transport = UdpTransport(US, group=(GROUP, 0))
    await transport.open()
    assert transport.counters["multicast.not_joined"] == 1
    joining = transport._memberships
    assert joining is not None
    async with asyncio.timeout(20):
        while not joining.joined:
            await asyncio.sleep(0.01)
    await transport.close()
    count = len(attempts)
    await asyncio.sleep(0.05)
    assert len(attempts) == count


async def test_port_in_use_disables_multicast_only(free_port: int) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as greedy:
        greedy.bind(("", free_port))
        transport = UdpTransport(US, group=(GROUP, free_port))
        await transport.open()
        assert transport.counters["multicast.not_joined"] == 1
        await transport.close()


async def test_transport_without_peer_and_group_is_an_error() -> None:
    with pytest.raises(TransportError, match="node manager or a multicast group"):
        await UdpTransport(US).open()


async def test_foreign_address_is_an_error() -> None:
    with pytest.raises(TransportError, match=r"cannot use UDP 192\.0\.2\.77:0"):
        await UdpTransport(US, peer=("127.0.0.1", 3794), bind=("192.0.2.77", 0)).open()


async def test_burst_is_buffered_while_the_reader_is_busy(sockets: list[socket.socket]) -> None:
    """As much as in a socket that asked the kernel for a large buffer; the usual one holds some 270 messages."""
    sender, other = sockets
    other.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, multicast.RECEIVE_BUFFER)
    transport = UdpTransport(US, peer=other.getsockname())
    await transport.open()
    try:
        assert transport._socket is not None
        for address in (("127.0.0.1", transport._socket.getsockname()[1]), other.getsockname()):
            for number in range(1000):
                sender.sendto(judp.pack(Packet(PEER, US, b"\x02\x20", number)), address)
        held = 0
        with contextlib.suppress(BlockingIOError):
            while other.recv(5000):
                held += 1
        async with asyncio.timeout(20):
            while transport.counters["received"] < 0.9 * held:
                await asyncio.sleep(0.001)
    finally:
        await transport.close()
