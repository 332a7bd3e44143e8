"""Faults of other node managers that need a whole one to show: polling, losses, open ports, clocks, endless logs."""

import asyncio
import contextlib
import logging
import os
import socket
import subprocess
import sys
import time
from collections.abc import AsyncIterator, Callable
from pathlib import Path

import psutil
import pytest
from tests.node.daemon import DaemonProcess

from jauspy.ids import EVERYONE, JausID
from jauspy.node import NodeConfig, NodeManager
from jauspy.protocol import judp, junior, pending
from jauspy.protocol.header import Broadcast, Packet

HERE, THERE, FAR = (JausID.parse(text) for text in ("101.1.1", "101.1.2", "42.1.1"))
Introduce = Callable[..., socket.socket]


@pytest.fixture
async def node(root: Path) -> AsyncIterator[NodeManager]:
    async with NodeManager(NodeConfig(address="127.0.0.1", port=0, local_root=root)) as manager:
        yield manager


async def receive(sock: socket.socket) -> bytes:
    async with asyncio.timeout(20):
        return await asyncio.get_running_loop().sock_recv(sock, 70000)


async def introduced(introduce: Introduce, *ids: JausID) -> list[socket.socket]:
    socks = [introduce(id) for id in ids]
    assert [await receive(sock) for sock in socks] == [junior.accept(id) for id in ids]
    return socks


def numbered(source: JausID, destination: JausID, count: int) -> list[bytes]:
    return [judp.pack(Packet(source, destination, b"\x02\x20", number)) for number in range(count)]


@pytest.mark.slow
def test_idle_node_manager_sleeps(daemon_process: DaemonProcess) -> None:
    """It looks after its components once a second, and does not poll: others wake up a thousand times a second."""
    component = daemon_process.component("100.1.1")
    component.says("02001000 01 01016400 01016400 0000 0100")
    component.hears("02001000 01 01016400 01016400 0000 0100")
    process = psutil.Process(daemon_process.process.pid)
    before, began = process.num_ctx_switches().voluntary, time.monotonic()
    time.sleep(2)
    waked = process.num_ctx_switches().voluntary - before
    assert waked <= 10 * (time.monotonic() - began)


async def test_nothing_is_lost_with_256_in_flight(node: NodeManager, introduce: Introduce) -> None:
    a, b = await introduced(introduce, HERE, THERE)
    loop = asyncio.get_running_loop()
    for _ in range(8):
        sent = numbered(HERE, THERE, 256)
        for data in sent:
            while True:
                try:
                    a.sendto(data, str(node.path))
                    break
                except BlockingIOError:
                    await asyncio.sleep(0)
        async with asyncio.timeout(20):
            assert [await loop.sock_recv(b, 5000) for _ in sent] == sent


async def test_udp_burst_is_not_limited_to_ten_per_turn(
    node: NodeManager, introduce: Introduce, udp: Callable[[], socket.socket]
) -> None:
    """All is sent before the node manager gets its turn; 200 fit the smallest receive buffer of a kernel."""
    (here,) = await introduced(introduce, HERE)
    peer = udp()
    sent = numbered(FAR, HERE, 200)
    for data in sent:
        peer.sendto(data, ("127.0.0.1", node.port))
    assert [await receive(here) for _ in sent] == sent


async def test_step_of_the_wall_clock_has_no_effect(
    node: NodeManager, introduce: Introduce, udp: Callable[[], socket.socket], monkeypatch: pytest.MonkeyPatch
) -> None:
    """An hour forward, and back to 1970: addresses stay known, what waits for an unknown id waits on."""
    monkeypatch.setattr(pending, "PENDING_TIMEOUT", 60.0)
    (here,) = await introduced(introduce, HERE)
    peer, late = udp(), JausID.parse("43.1.1")
    peer.sendto(numbered(FAR, HERE, 1)[0], ("127.0.0.1", node.port))
    await receive(here)
    real = time.time()
    for clock in (real, real + 3600, 0.0):
        monkeypatch.setattr(time, "time", lambda clock=clock: clock)
        monkeypatch.setattr(time, "time_ns", lambda clock=clock: int(clock * 1e9))
        back = judp.pack(Packet(HERE, FAR, b"\x02\x40", 1))
        here.sendto(back, str(node.path))
        assert await receive(peer) == back
        here.sendto(judp.pack(Packet(HERE, late, b"\x02\x20", 1)), str(node.path))
    own = judp.pack(Packet(HERE, HERE, b"\0\0"))
    here.sendto(own, str(node.path))
    assert await receive(here) == own
    assert node.state.router.pending_messages == 2
    assert node.counters["dropped.unknown_destination"] == 0


def test_only_the_udp_port_is_open(root: Path, free_port: int) -> None:
    """No configuration, no status and no metrics by TCP, unless they were asked for."""

    async def look() -> set[tuple[int, str, int]]:
        mine = psutil.Process()
        before = {(each.type, *each.laddr) for each in mine.net_connections("inet")}
        async with NodeManager(NodeConfig(address="127.0.0.1", port=free_port, local_root=root)):
            return {(each.type, *each.laddr) for each in mine.net_connections("inet")} - before

    opened = asyncio.run(look())
    assert {kind for kind, _, _ in opened} == {socket.SOCK_DGRAM}
    assert {(host, port) for _, host, port in opened} == {("127.0.0.1", free_port), ("239.255.0.1", free_port)}


async def test_components_communicate_without_any_network(
    root: Path, introduce: Introduce, udp: Callable[[], socket.socket]
) -> None:
    """No multicast leaves, static addresses get their copies, and unicasts go on, before and after broadcasts."""
    peer = udp()
    book = {"42.255.255": "udp://{}:{}".format(*peer.getsockname())}
    config = NodeConfig.make(
        address="127.0.0.1", port=0, local_root=root, multicast_interfaces=["192.0.2.1"], addresses=book
    )
    async with NodeManager(config) as node:
        here, there = await introduced(introduce, HERE, THERE)
        for number in range(3):
            for destination in (EVERYONE, FAR, THERE):
                flag = Broadcast.GLOBAL if destination == EVERYONE else Broadcast.NONE
                data = judp.pack(Packet(HERE, destination, b"\x02\x20", number, broadcast=flag))
                here.sendto(data, str(node.path))
                for listener in (peer,) * (destination != THERE) + (there,) * (destination != FAR):
                    assert await receive(listener) == data


async def test_drops_are_counted_each_time_and_logged_once(
    node: NodeManager, introduce: Introduce, caplog: pytest.LogCaptureFixture
) -> None:
    caplog.set_level(logging.DEBUG)
    a, _ = await introduced(introduce, HERE, THERE)
    for data in numbered(HERE, THERE, 3000):
        while True:
            try:
                a.sendto(data, str(node.path))
                break
            except BlockingIOError:
                await asyncio.sleep(0)
    own = judp.pack(Packet(HERE, HERE, b"\0\0"))
    a.sendto(own, str(node.path))
    assert await receive(a) == own
    assert node.counters["dropped.queue_full"] > 1000
    assert len([line for line in caplog.messages if "queue_full" in line]) == 1


async def test_socket_may_register_several_ids(node: NodeManager, introduce: Introduce) -> None:
    """The table of components is no list that is searched and never shrinks."""
    (here,) = await introduced(introduce, HERE)
    others = [JausID(101, 2, number) for number in range(1, 255)]
    for id in others:
        data = judp.pack(Packet(id, HERE, b"\x02\x20"))
        with contextlib.suppress(BlockingIOError):
            here.sendto(data, str(node.path))
        assert await receive(here) == data
    assert len(node.components) == 255
    for id in others:
        here.sendto(junior.cancel(id), str(node.path))
        own = judp.pack(Packet(HERE, HERE, b"\0\0"))
        here.sendto(own, str(node.path))
        assert await receive(here) == own
    assert node.components == (HERE,)


ORDINARY = """
import asyncio, concurrent.futures.thread, os, sys
import psutil, jauspy.node.metrics, jauspy.node.mirror, jauspy.node.status
from jauspy.node import NodeConfig, NodeManager
from jauspy.protocol import junior
async def main(root):
    if os.geteuid() == 0:
        os.setgroups([])
        os.setgid(65534)
        os.setuid(65534)
    async with NodeManager(NodeConfig(local_root=root, port=int(sys.argv[2]), tcp=True, mirror=f"{root}/x.pcapng")):
        print("ready", os.geteuid(), flush=True)
        await asyncio.to_thread(sys.stdin.read)
asyncio.run(main(sys.argv[1]))
"""


@pytest.mark.slow
def test_root_is_not_required(root: Path, free_port: int) -> None:
    """All of it: the port, the group, local sockets, TCP, status and mirror."""
    if os.geteuid() == 0:
        os.chown(root, 65534, 65534)
    command = (sys.executable, "-c", ORDINARY, str(root), str(free_port))
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        said, user = process.stdout.readline().split()
        assert said == "ready"
        assert int(user) != 0
        with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as component:
            component.settimeout(20)
            component.bind(str(root / str(int(HERE))))
            (root / str(int(HERE))).chmod(0o777)
            component.sendto(junior.connect(HERE), str(root / junior.SOCKET_NAME))
            assert component.recv(100) == junior.accept(HERE)
        process.communicate(timeout=20)
    assert process.returncode == 0
