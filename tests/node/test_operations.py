"""A running node manager is looked at, reloaded, mirrored and watched over."""

import asyncio
import contextlib
import http.client
import io
import json
import logging
import os
import socket
import stat
import threading
from collections.abc import Callable
from pathlib import Path

import dpkt
import pytest

from jauspy.capture import writer
from jauspy.capture.reader import CaptureReader
from jauspy.cli.node_manager import JsonLines, SystemdNotifier
from jauspy.errors import ConfigError, TransportError
from jauspy.ids import JausID
from jauspy.node import NodeConfig, NodeManager, metrics, mirror, mirror_server, status
from jauspy.protocol import judp, junior
from jauspy.protocol.counters import Counters
from jauspy.protocol.header import Packet
from jauspy.transport import node_status

HERE, FAR = JausID.parse("101.1.1"), JausID.parse("42.1.1")
QUERY_BACK = judp.pack(Packet(HERE, FAR, b"\x02\x20", 1))
QUERY = judp.pack(Packet(FAR, HERE, b"\x02\x20", 1))


async def receive(sock: socket.socket) -> bytes:
    async with asyncio.timeout(20):
        return await asyncio.get_running_loop().sock_recv(sock, 70000)


def config(root: Path, **settings: object) -> NodeConfig:
    return NodeConfig.make(address="127.0.0.1", port=0, local_root=root, **settings)


async def traffic(node: NodeManager, introduce, udp) -> tuple[socket.socket, socket.socket]:
    """One component, one peer, one query from there to here, and something malformed."""
    component, peer = introduce(HERE), udp()
    assert await receive(component) == junior.accept(HERE)
    peer.sendto(b"\x07garbage of no known version", ("127.0.0.1", node.port))
    peer.sendto(QUERY, ("127.0.0.1", node.port))
    assert await receive(component) == QUERY
    return component, peer


async def test_status_has_components_peers_queues_and_drops(root: Path, introduce, udp) -> None:
    async with NodeManager(config(root)) as node:
        before = await status.read(root)
        _, peer = await traffic(node, introduce, udp)
        reported = status.with_rates(before, await status.read(root))
        here = {"id": "101.1.1", "path": str(root / str(int(HERE))), "waiting": 0, "waiting_bytes": 0}
        assert reported["components"] == [here]
        host, port = peer.getsockname()
        assert [(each["id"], each["address"]) for each in reported["peers"]] == [("42.1.1", f"{host}:{port}")]
        sent = reported["peers"][0]["sent_bytes"]
        assert isinstance(sent, int)
        peer_address = reported["peers"][0]["address"].rpartition(":")
        node._networks[reported["peers"][0]["network"]].send(b"x" * 100, peer_address[0], int(peer_address[2]))
        assert (await status.read(root))["peers"][0]["sent_bytes"] == sent + 100
        assert reported["networks"][0]["send_queue"] >= 0
        assert reported["counters"]["dropped.malformed.version"] == 1
        assert reported["rates"]["dropped.malformed.version"] > 0
        assert reported["queues"] == {"ingress": 0, "unknown_destinations": 0}
        assert reported["networks"][0]["address"] == f"127.0.0.1:{node.port}"
        assert stat.S_IMODE((root / status.SOCKET_NAME).stat().st_mode) == 0o660
    assert list(root.iterdir()) == [root / str(int(HERE))]


async def test_status_without_node_manager_is_an_error(root: Path) -> None:
    with pytest.raises(TransportError, match=r"no node manager serves its status at .*is this its --local-root"):
        await status.read(root)


async def test_status_reader_that_never_reads_has_no_effect(root: Path, introduce, udp) -> None:
    async with NodeManager(config(root)) as node:
        _, writer = await asyncio.open_unix_connection(root / status.SOCKET_NAME)
        writer.write(b"x" * 100000)
        await traffic(node, introduce, udp)
        assert (await status.read(root))["pid"]
        writer.close()


async def exchange(port: int, request: bytes) -> bytes:
    reader, writer = await asyncio.open_connection("127.0.0.1", port)
    writer.write(request)
    answer = await reader.read()
    writer.close()
    await writer.wait_closed()
    return answer


async def test_metrics_for_prometheus(root: Path, introduce, udp, free_port: int) -> None:
    async with NodeManager(config(root, metrics=f"127.0.0.1:{free_port}")) as node:
        await traffic(node, introduce, udp)
        head, _, body = (await exchange(free_port, b"GET /metrics HTTP/1.1\r\n\r\n")).partition(b"\r\n\r\n")
        assert b"200 OK" in head
        assert b'jauspy_node_dropped_total{reason="malformed.version"} 1.0' in body
        assert b'jauspy_node_queue{component="101.1.1"} 0.0' in body
        assert b"jauspy_node_peers 1.0" in body
        assert b"405" in await exchange(free_port, b"POST / HTTP/1.1\r\n\r\n")


async def test_idle_metrics_readers_are_bounded(root: Path, free_port: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(metrics, "REQUEST_TIMEOUT", 60.0)
    async with NodeManager(config(root, metrics=f"127.0.0.1:{free_port}")):
        with contextlib.ExitStack() as stack:
            for _ in range(metrics.MAX_READERS + 1):
                last = stack.enter_context(socket.create_connection(("127.0.0.1", free_port)))
            last.setblocking(False)
            async with asyncio.timeout(20):
                assert await end_of(last)
        assert await asyncio.to_thread(scrape, free_port)


async def end_of(sock: socket.socket) -> bool:
    try:
        return await asyncio.get_running_loop().sock_recv(sock, 1) == b""
    except ConnectionError:
        return True


def scrape(port: int) -> bytes:
    with contextlib.closing(http.client.HTTPConnection("127.0.0.1", port, timeout=20)) as connection:
        connection.request("GET", "/metrics")
        return connection.getresponse().read()


async def test_folder_in_place_of_the_status_socket_is_an_error(root: Path) -> None:
    (root / status.SOCKET_NAME).mkdir()
    with pytest.raises(TransportError, match=r"cannot open the socket .*JuniorRTE\.status: Is a directory"):
        await NodeManager(config(root)).open()
    assert [each.name for each in root.iterdir()] == [status.SOCKET_NAME]


async def test_metrics_port_in_use_is_an_error_and_nothing_stays_open(root: Path) -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1]
        with pytest.raises(TransportError, match=f"metrics on 127.0.0.1:{port}: Address already in use; .*--metrics"):
            await NodeManager(config(root, metrics=f"127.0.0.1:{port}")).open()
    assert list(root.iterdir()) == []


def packets(data) -> list[tuple[str, str, bytes]]:
    """What a reader of pcapng sees."""
    reader = dpkt.pcapng.Reader(data)
    found = []
    for _, frame in reader:
        ip = dpkt.ip.IP(frame)
        bare = dpkt.ip.IP(frame)
        bare.sum = 0
        assert dpkt.ip.IP(bytes(bare)).sum == ip.sum, "the header's checksum is right"
        name = socket.inet_ntoa
        found.append((f"{name(ip.src)}:{ip.data.sport}", f"{name(ip.dst)}:{ip.data.dport}", ip.data.data))
    return found


async def test_the_mirror_writes_all_that_is_routed(root: Path, tmp_path: Path, introduce, udp) -> None:
    file = tmp_path / "all.pcapng"
    async with NodeManager(config(root, mirror=str(file))) as node:
        component, peer = await traffic(node, introduce, udp)
        answer = judp.pack(Packet(HERE, FAR, b"\x02\x40", 1))
        component.sendto(answer, str(node.path))
        assert await receive(peer) == answer
        where = ":".join(map(str, peer.getsockname()))
    with file.open("rb") as data:
        local = "127.101.1.1:3794"
        assert packets(data) == [(local, local, junior.accept(HERE)), (where, local, QUERY), (local, where, answer)]


async def test_the_mirror_ends_at_its_limit(root: Path, tmp_path: Path, introduce, udp) -> None:
    file = tmp_path / "all.pcapng"
    async with NodeManager(config(root, mirror=str(file), mirror_limit=4096)) as node:
        component, peer = await traffic(node, introduce, udp)
        for _ in range(200):
            peer.sendto(QUERY, ("127.0.0.1", node.port))
            await receive(component)
    assert file.stat().st_size <= 4096


async def test_each_mirror_datagram_is_a_pcapng_file(root: Path, tmp_path: Path, introduce, udp) -> None:
    viewer = udp()
    target = "udp:{}:{}".format(*viewer.getsockname())
    async with NodeManager(config(root, mirror=target)) as node:
        await traffic(node, introduce, udp)
        (tmp_path / "one").write_bytes(await receive(viewer))
    with (tmp_path / "one").open("rb") as data:
        assert packets(data)[-1][2] in (QUERY, junior.accept(HERE))


async def test_mirror_without_receiver_has_no_effect(root: Path, introduce, udp, free_port: int) -> None:
    """Its packets come back as refused; those of the network are not touched."""
    async with NodeManager(config(root, mirror=f"udp:127.0.0.1:{free_port}")) as node:
        component, peer = await traffic(node, introduce, udp)
        for _ in range(300):
            peer.sendto(QUERY, ("127.0.0.1", node.port))
            assert await receive(component) == QUERY
        assert node.counters["dropped.udp_unreachable"] == 0


async def test_packet_too_long_for_the_mirror_is_counted(root: Path, introduce, udp) -> None:
    viewer = udp()
    async with NodeManager(config(root, mirror="udp:{}:{}".format(*viewer.getsockname()))) as node:
        component, peer = await traffic(node, introduce, udp)
        await receive(viewer)
        longest = judp.pack(Packet(FAR, HERE, bytes(65507 - 15), 2))
        peer.sendto(longest, ("127.0.0.1", node.port))
        assert await receive(component) == longest
        peer.sendto(QUERY, ("127.0.0.1", node.port))
        assert QUERY in await receive(viewer)
        assert node.counters["mirror.lost"] == 1


async def test_mirror_pipe_needs_a_reader_and_never_blocks(
    root: Path, tmp_path: Path, introduce, udp, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(mirror, "STOP_TIMEOUT", 0.05)
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    with pytest.raises(TransportError, match="a pipe without a reader"):
        await NodeManager(config(root, mirror=str(pipe))).open()
    reader = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
    try:
        async with NodeManager(config(root, mirror=str(pipe))) as node:
            component, peer = await traffic(node, introduce, udp)
            large = judp.pack(Packet(FAR, HERE, bytes(30_000), 2))
            while not node.counters["mirror.lost"]:
                peer.sendto(large, ("127.0.0.1", node.port))
                assert await receive(component) == large
    finally:
        os.close(reader)
    writers = [thread for thread in threading.enumerate() if thread.name == "mirror"]
    for thread in writers:  # writing to the closed pipe fails: the thread closes its file and ends
        await asyncio.to_thread(thread.join, 20)
    assert not any(thread.is_alive() for thread in writers)
    assert str(pipe) not in {os.path.realpath(each) for each in Path("/proc/self/fd").iterdir()}


async def test_the_mirror_closes_a_pipe_whose_reader_ends_while_it_writes(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(mirror, "STOP_TIMEOUT", 0.05)
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    reader = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
    counters = Counters(logging.getLogger(__name__))
    block = writer.packet(("10.0.0.2", judp.PORT), ("10.0.0.1", judp.PORT), bytes(30_000), 0)
    with mirror.Mirror(str(pipe), 1 << 30, counters) as writing:
        (thread,) = (thread for thread in threading.enumerate() if thread.name == "mirror")
        for _ in range(6):  # more than the pipe holds, and fewer than the queue
            writing.add(block)
            writing.flush()
    os.close(reader)
    await asyncio.to_thread(thread.join, 20)
    assert not thread.is_alive()


async def test_unwritable_mirror_is_an_error_and_nothing_stays_open(root: Path, tmp_path: Path) -> None:
    file = tmp_path / "nowhere" / "all.pcapng"
    with pytest.raises(TransportError, match=f"cannot write the mirror {file}: No such file or directory"):
        await NodeManager(config(root, mirror=str(file))).open()
    with pytest.raises(TransportError, match="cannot write the mirror /dev/full: No space left"):
        await NodeManager(config(root, mirror="/dev/full")).open()
    assert list(root.iterdir()) == []


async def test_reload_applies_rules_or_keeps_the_old_ones(root: Path, introduce, udp) -> None:
    def gateway(**rule: object) -> NodeConfig:
        return config(root, gateway={"subsystem": 101, "rules": [rule]})

    async with NodeManager(config(root)) as node:
        component, peer = await traffic(node, introduce, udp)
        refused = judp.pack(Packet(FAR, HERE, b"\x05\x04", 2))
        assert node.reload(gateway(messages=["QueryStatus"])) == []
        for data in (refused, QUERY):
            peer.sendto(data, ("127.0.0.1", node.port))
        assert await receive(component) == QUERY
        with pytest.raises(ConfigError, match="QueryStatsu"):
            node.reload(gateway(messages=["QueryStatsu"]))
        for data in (refused, QUERY):
            peer.sendto(data, ("127.0.0.1", node.port))
        assert await receive(component) == QUERY
        assert node.counters["dropped.gateway.rule"] == 2
        assert node.reload(config(root, multicast_ttl=3)) == ["multicast_ttl"]
        peer.sendto(refused, ("127.0.0.1", node.port))
        assert await receive(component) == refused


async def test_a_reload_reads_the_address_books_again(root: Path, tmp_path: Path, introduce, udp) -> None:
    book = tmp_path / "book.toml"
    book.write_text("[addresses]\n")
    settings = config(root, address_books=[book])
    async with NodeManager(settings) as node:
        component, peer = introduce(HERE), udp()
        assert await receive(component) == junior.accept(HERE)
        book.write_text('[addresses]\n"42.1.1" = "udp://{}:{}"\n'.format(*peer.getsockname()))
        assert node.reload(settings) == []
        component.sendto(QUERY_BACK, str(node.path))
        assert await receive(peer) == QUERY_BACK
        book.write_text('[addresses]\n"42.1" = 1\n')
        with pytest.raises(ConfigError, match=r"book\.toml"):
            node.reload(settings)
        component.sendto(QUERY_BACK, str(node.path))
        assert await receive(peer) == QUERY_BACK


async def test_readiness_and_watchdog_are_notified(root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as manager:
        manager.setblocking(False)
        manager.bind(str(root / "notify"))
        monkeypatch.setenv("NOTIFY_SOCKET", str(root / "notify"))
        monkeypatch.setenv("WATCHDOG_USEC", "20000")
        async with SystemdNotifier() as services:
            reported = [await receive(manager) for _ in range(3)]
            assert reported == [b"READY=1", b"WATCHDOG=1", b"WATCHDOG=1"]
            services.ready("running")
        rest = {await receive(manager), await receive(manager)}
        assert rest & {b"READY=1\nSTATUS=running", b"STOPPING=1"}


async def test_nothing_is_notified_without_systemd(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("NOTIFY_SOCKET", raising=False)
    async with SystemdNotifier() as services:
        services.reloading()


def test_the_json_log_is_one_object_per_line() -> None:
    record = logging.makeLogRecord({"name": "jauspy.node", "levelno": 30, "levelname": "WARNING", "msg": "a\nb"})
    line = JsonLines().format(record)
    assert "\n" not in line
    assert json.loads(line) | {"time": ""} == {
        "time": "",
        "level": "warning",
        "logger": "jauspy.node",
        "message": "a\nb",
    }


# --- the mirror's socket --------------------------------------------------------------------------------------------


def mirrored(root: Path) -> socket.socket:
    reader = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
    reader.settimeout(20.0)
    reader.connect(str(root / node_status.MIRROR_NAME))
    return reader


async def until(condition: Callable[[], bool]) -> None:
    async with asyncio.timeout(20.0):
        while not condition():
            await asyncio.sleep(0.005)


async def test_readers_of_the_mirrors_socket_get_all_that_is_routed(root: Path, introduce, udp) -> None:
    async with NodeManager(config(root)) as node:
        component, peer = await traffic(node, introduce, udp)
        with mirrored(root) as first, mirrored(root) as second:
            for reader in (first, second):
                assert await asyncio.to_thread(reader.recv, len(writer.preamble())) == writer.preamble()
            peer.sendto(QUERY, ("127.0.0.1", node.port))
            await receive(component)
            for reader in (first, second):
                data = io.BytesIO(writer.preamble() + await asyncio.to_thread(reader.recv, 4096))
                where = ":".join(map(str, peer.getsockname()))
                assert packets(data) == [(where, "127.101.1.1:3794", QUERY)]
        peer.sendto(QUERY, ("127.0.0.1", node.port))
        assert await receive(component) == QUERY
    assert not (root / node_status.MIRROR_NAME).exists()


async def test_without_readers_known_routes_bypass_the_router(root: Path, introduce, udp) -> None:
    async with NodeManager(config(root)) as node:
        component, peer = await traffic(node, introduce, udp)

        async def route() -> int:
            for _ in range(5):
                peer.sendto(QUERY, ("127.0.0.1", node.port))
                await receive(component)
            return len(node._cache)

        assert await route() > 0
        with mirrored(root):
            await until(lambda: not len(node._cache))
            assert await route() == 0
        await until(lambda: not node._mirrors)
        assert await route() > 0


async def test_a_reader_that_does_not_read_loses_packets_and_is_told(
    root: Path, introduce, udp, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(mirror_server, "MAX_WAITING", 100_000)
    large = judp.pack(Packet(FAR, HERE, bytes(30_000), 2))
    async with NodeManager(config(root)) as node:
        component, peer = await traffic(node, introduce, udp)
        with mirrored(root) as reader:
            await until(lambda: bool(node._mirrors))
            while not node.counters["mirror.lost"]:
                peer.sendto(large, ("127.0.0.1", node.port))
                assert await receive(component) == large
            capture = asyncio.create_task(asyncio.to_thread(read_until, reader, QUERY))
            while not capture.done():
                peer.sendto(QUERY, ("127.0.0.1", node.port))
                assert await receive(component) == QUERY
            assert await capture == node.counters["mirror.lost"]


def read_until(reader: socket.socket, payload: bytes) -> int:
    """The packets that the reader has lost, as the mirror told it before this datagram."""
    with reader.makefile("rb") as stream:  # which keeps the socket open
        capture = CaptureReader(stream, name="mirror")
        assert any(datagram.payload == payload and capture.lost for datagram in capture)
        return capture.lost


async def test_the_mirrors_socket_may_be_switched_off(root: Path) -> None:
    async with NodeManager(config(root, mirror_socket=False)):
        assert not (root / node_status.MIRROR_NAME).exists()
