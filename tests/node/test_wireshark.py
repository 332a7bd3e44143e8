"""The mirror is read by Wireshark's own reader, `tshark`: as a file, and as what its datagrams are in a row."""

import asyncio
import shutil
import socket
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from jauspy.ids import JausID
from jauspy.node import NodeConfig, NodeManager
from jauspy.protocol import judp, junior
from jauspy.protocol.header import Packet

HERE, FAR = JausID.parse("101.1.1"), JausID.parse("42.1.1")
FIELDS = ("ip.src", "udp.srcport", "ip.dst", "udp.dstport", "udp.payload")
COUNT = 200


async def receive(sock: socket.socket) -> bytes:
    async with asyncio.timeout(20):
        return await asyncio.get_running_loop().sock_recv(sock, 70000)


def tshark(file: Path, *arguments: str) -> list[str]:
    """What it prints, line by line; it must have nothing to complain about."""
    if shutil.which("tshark") is None:
        pytest.skip("needs tshark, which Debian has in a package of this name")
    done = subprocess.run(
        ("tshark", "-n", "-r", str(file), *arguments), capture_output=True, text=True, check=False, timeout=60
    )
    assert done.returncode == 0, done.stderr
    assert all("root" in line for line in done.stderr.splitlines()), done.stderr  # who runs it is all it may mention
    return done.stdout.splitlines()


def datagrams(file: Path) -> list[list[str]]:
    fields = [part for field in FIELDS for part in ("-e", field)]
    return [line.split("\t") for line in tshark(file, "-T", "fields", *fields)]


async def converse(node: NodeManager, introduce: Callable[..., socket.socket], peer: socket.socket) -> list[list[str]]:
    """Queries and reports of all sizes; what is to be seen of them."""
    component = introduce(HERE)
    assert await receive(component) == junior.accept(HERE)
    ours, (host, port) = ["127.101.1.1", "3794"], peer.getsockname()
    theirs = [host, str(port)]
    seen = [[*ours, *ours, junior.accept(HERE).hex()]]
    for number in range(COUNT):
        query = judp.pack(Packet(FAR, HERE, b"\x02\x20" + bytes(number * 20), number))
        peer.sendto(query, ("127.0.0.1", node.port))
        assert await receive(component) == query
        report = judp.pack(Packet(HERE, FAR, b"\x02\x40" + bytes(number % 7), number))
        component.sendto(report, str(node.path))
        assert await receive(peer) == report
        seen += [[*theirs, *ours, query.hex()], [*ours, *theirs, report.hex()]]
    return seen


@pytest.mark.slow
async def test_mirror_file_is_read_by_wireshark(root: Path, tmp_path: Path, introduce, udp) -> None:
    file = tmp_path / "all.pcapng"
    config = NodeConfig.make(address="127.0.0.1", port=0, local_root=root, mirror=str(file))
    async with NodeManager(config) as node:
        seen = await converse(node, introduce, udp())
    assert datagrams(file) == seen
    assert tshark(file, "-Y", "_ws.malformed || ip.checksum.status == 0", "-o", "ip.check_checksum:TRUE") == []
    times = [float(line) for line in tshark(file, "-T", "fields", "-e", "frame.time_epoch")]
    assert times == sorted(times)


@pytest.mark.slow
async def test_concatenated_mirror_datagrams_are_read_by_wireshark(root: Path, tmp_path: Path, introduce, udp) -> None:
    """As `nc -lu 5555 | wireshark -k -i -` reads them."""
    file, viewer = tmp_path / "row.pcapng", udp()
    viewer.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4 << 20)
    target = "udp:{}:{}".format(*viewer.getsockname())
    config = NodeConfig.make(address="127.0.0.1", port=0, local_root=root, mirror=target)
    async with NodeManager(config) as node:
        seen = await converse(node, introduce, udp())
    with file.open("wb") as row:
        while True:
            try:
                row.write(viewer.recv(70000))
            except BlockingIOError:
                break
    assert datagrams(file) == seen
