"""Senders that never wait: their socket fills while a receiver reads, and not for one that does not read."""

import asyncio
import socket
from pathlib import Path

import pytest

from jauspy.ids import JausID
from jauspy.node import NodeConfig, NodeManager, back_pressure
from jauspy.protocol import judp, junior
from jauspy.protocol.header import Packet

FLOODER, READER, OTHER, PEER = (JausID(126, 1, number) for number in (11, 20, 30, 40))


async def receive(sock: socket.socket) -> bytes:
    async with asyncio.timeout(20):
        return await asyncio.get_running_loop().sock_recv(sock, 70000)


async def connect(introduce, *ids: JausID) -> list[socket.socket]:
    socks = [introduce(id) for id in ids]
    for sock, id in zip(socks, ids, strict=True):
        assert await receive(sock) == junior.accept(id)
    return socks


def manager(root: Path) -> NodeManager:
    return NodeManager(NodeConfig.make(address="127.0.0.1", port=0, local_root=root, max_message_age=0))


class Flood:
    """Sends numbered messages as fast as the kernel takes them."""

    def __init__(self, sock: socket.socket, node: NodeManager, destination: JausID) -> None:
        self._sock, self._node, self._destination = sock, str(node.path), destination
        self.sent = self.refused = 0

    def push(self, count: int) -> None:
        """Try to send so many."""
        for _ in range(count):
            try:
                self._sock.sendto(self.message(self.sent), self._node)
            except BlockingIOError:
                self.refused += 1
                return
            self.sent += 1

    def message(self, number: int) -> bytes:
        return judp.pack(Packet(FLOODER, self._destination, number.to_bytes(4, "little"), number & 0xFFFF))


def read(sock: socket.socket, most: int) -> list[bytes]:
    found = []
    for _ in range(most):
        try:
            found.append(sock.recv(70000))
        except BlockingIOError:
            break
    return found


async def test_sender_that_never_waits_loses_nothing_when_its_receiver_is_slower(
    root: Path, introduce, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(back_pressure, "MAX_CREDIT", 20.0)
    async with manager(root) as node:
        flooder, reader = await connect(introduce, FLOODER, READER)
        flood = Flood(flooder, node, READER)
        arrived: list[bytes] = []
        async with asyncio.timeout(20):
            while len(arrived) < 5000:
                flood.push(min(64, 5000 - flood.sent))
                await asyncio.sleep(0)
                arrived += read(reader, 2)  # less than the node manager reads in a turn
        assert arrived == [flood.message(number) for number in range(5000)]
        assert flood.refused
        assert node.counters["local.paused"]
        assert not any(name.startswith("dropped") for name in node.counters)


async def test_nobody_waits_long_nor_often_for_a_receiver_that_does_not_read(
    root: Path, introduce, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(back_pressure, "MAX_CREDIT", 0.002)
    async with manager(root) as node:
        flooder, stalled, other, peer = await connect(introduce, FLOODER, READER, OTHER, PEER)
        flood = Flood(flooder, node, READER)
        while flood.sent < 3000:
            flood.push(64)
            await asyncio.sleep(0)
        for number in range(200):
            ping = judp.pack(Packet(OTHER, PEER, b"\x02\x20", number))
            flood.push(16)
            async with asyncio.timeout(20):
                await asyncio.get_running_loop().sock_sendto(other, ping, str(node.path))
            assert await receive(peer) == ping
        assert node.counters["local.paused"] == node.counters["local.paused_in_vain"] >= 1
        assert node.counters["dropped.queue_full"] > 1000
        assert node.state.queued[str(root / str(int(READER)))] == 512
        assert len(read(stalled, 20)) > 1


class Waits:
    """Records pauses, on a clock that the test turns."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.now = 0.0
        self.is_paused = False
        self.counters: dict[str, int] = {}
        loop = asyncio.get_running_loop()
        monkeypatch.setattr(loop, "time", lambda: self.now)
        self.timers: list[asyncio.TimerHandle] = []

        def call_later(delay: float, callback) -> asyncio.TimerHandle:
            self.timers.append(asyncio.TimerHandle(self.now + delay, callback, (), loop))
            return self.timers[-1]

        monkeypatch.setattr(loop, "call_later", call_later)

    def pause(self) -> None:
        assert not self.is_paused
        self.is_paused = True

    def resume(self) -> None:
        assert self.is_paused
        self.is_paused = False

    def pass_time(self, seconds: float, *, late: float = 0.0) -> None:
        """Run what is due in this time, so many seconds late."""
        end = self.now + seconds
        while due := [timer for timer in self.timers if timer.when() <= end and not timer.cancelled()]:
            timer = min(due, key=lambda timer: timer.when())
            self.timers.remove(timer)
            self.now, late = timer.when() + late, 0.0
            timer._run()
        self.now = max(self.now, end)


async def test_waiting_for_receivers_that_do_not_read_takes_little_time(monkeypatch: pytest.MonkeyPatch) -> None:
    """Ten of them, each with a full queue all the time: about an eighth of the first seconds, then less."""
    with monkeypatch.context() as patch:
        waits = Waits(patch)
        pressure = back_pressure.BackPressure(waits.pause, waits.resume, Counted())
        paused = [0.0] * 20
        for millisecond in range(20_000):
            for number in range(10):
                pressure.congested(f"/{number}")
            paused[millisecond // 1000] += 0.001 * waits.is_paused
            waits.pass_time(0.001)
        assert max(paused) <= 0.16
        assert sum(paused[10:]) < 0.5
        pressure.close()


async def test_late_timer_gives_the_receiver_another_chance(monkeypatch: pytest.MonkeyPatch) -> None:
    """The node manager itself did not run: nobody could be seen to read."""
    with monkeypatch.context() as patch:
        waits = Waits(patch)
        counters = Counted()
        pressure = back_pressure.BackPressure(waits.pause, waits.resume, counters)
        pressure.congested("/1")
        waits.pass_time(0.031, late=1.0)
        assert waits.is_paused
        pressure.relieved("/1")
        assert not waits.is_paused
        assert counters["local.paused_in_vain"] == 0
        pressure.congested("/1")
        pressure.congested("/2")
        pressure.forget("/1")
        assert waits.is_paused
        pressure.forget("/2")
        assert not waits.is_paused


@pytest.mark.parametrize(("seconds", "in_vain"), [(0.004, 0), (0.01, 1)])
async def test_nobody_waits_for_a_receiver_that_reads_slowly(
    monkeypatch: pytest.MonkeyPatch, seconds: float, in_vain: int
) -> None:
    """One that takes so long for each 32 datagrams, that is 8000 or 3200 a second."""
    with monkeypatch.context() as patch:
        waits = Waits(patch)
        counters = Counted()
        pressure = back_pressure.BackPressure(waits.pause, waits.resume, counters)
        for _ in range(20):
            pressure.congested("/1")
            waits.pass_time(seconds)
            if waits.is_paused:
                pressure.relieved("/1")
        assert counters["local.paused_in_vain"] == in_vain
        assert not waits.is_paused


class Counted(dict[str, int]):
    def __missing__(self, name: str) -> int:
        return 0
