"""Two hosts on one cable: node managers in two network namespaces find each other by multicast."""

import contextlib
import os
import socket
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

from jauspy.ids import EVERYONE, JausID
from jauspy.protocol import judp, junior
from jauspy.protocol.header import Broadcast, Packet

NEAR, FAR = JausID.parse("101.1.1"), JausID.parse("102.1.1")

DAEMON = """
import asyncio, pathlib, sys
from jauspy.node import NodeConfig, NodeManager
from jauspy.transport import memberships
memberships.WATCH_INTERVAL = 0.1
async def main(root):
    async with NodeManager(NodeConfig(local_root=pathlib.Path(root))) as manager:
        print("ready", flush=True)
        await asyncio.to_thread(sys.stdin.read)
asyncio.run(main(sys.argv[1]))
"""


@contextlib.contextmanager
def node_manager(namespace: str, root: Path) -> Iterator[None]:
    root.mkdir()
    command = ("ip", "netns", "exec", namespace, sys.executable, "-c", DAEMON, str(root))
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == b"ready\n"
        yield
        process.communicate(timeout=20)
        assert process.returncode == 0


@contextlib.contextmanager
def component(root: Path, id: JausID) -> Iterator[socket.socket]:
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as sock:
        sock.settimeout(10)
        sock.bind(str(root / str(int(id))))
        sock.sendto(junior.connect(id), str(root / junior.SOCKET_NAME))
        assert sock.recv(100) == junior.accept(id)
        yield sock


def test_two_hosts_find_each_other_and_talk(cable: tuple[str, str], root: Path) -> None:
    near, far = root / "a", root / "b"
    with contextlib.ExitStack() as stack:
        for namespace, folder in zip(cable, (near, far), strict=True):
            stack.enter_context(node_manager(namespace, folder))
        a = stack.enter_context(component(near, NEAR))
        b = stack.enter_context(component(far, FAR))
        everybody = judp.pack(Packet(NEAR, EVERYONE, b"\x00\x2b\x04", 1, broadcast=Broadcast.GLOBAL))
        a.sendto(everybody, str(near / junior.SOCKET_NAME))
        assert b.recv(100) == everybody
        for sock, folder, packet, receiver in (
            (b, far, Packet(FAR, NEAR, b"\x00\x4b", 1), a),
            (a, near, Packet(NEAR, FAR, b"\x02\x20", 2), b),
            (a, near, Packet(NEAR, FAR, bytes(4079), 3), b),
        ):
            sock.sendto(judp.pack(packet), str(folder / junior.SOCKET_NAME))
            assert judp.unpack(receiver.recv(5000)) == [packet]


def test_a_network_that_comes_up_late_is_joined(cable: tuple[str, str], root: Path) -> None:
    near, far = root / "a", root / "b"
    end = f"jv{os.getpid()}b"
    late = ("ip", "-n", cable[1])
    subprocess.run((*late, "addr", "flush", "dev", end), check=True)
    subprocess.run((*late, "link", "set", end, "down"), check=True)
    with contextlib.ExitStack() as stack:
        for namespace, folder in zip(cable, (near, far), strict=True):
            stack.enter_context(node_manager(namespace, folder))
        a = stack.enter_context(component(near, NEAR))
        b = stack.enter_context(component(far, FAR))
        for change in (("link", "set", end, "up"), ("addr", "add", "10.77.0.2/24", "dev", end)):
            subprocess.run((*late, *change), check=True)
        subprocess.run((*late, "route", "add", "default", "dev", end), check=True)
        b.settimeout(0.2)
        for number in range(100):
            everybody = judp.pack(Packet(NEAR, EVERYONE, b"\x00\x2b\x04", number, broadcast=Broadcast.GLOBAL))
            a.sendto(everybody, str(near / junior.SOCKET_NAME))
            with contextlib.suppress(TimeoutError):
                assert judp.unpack(b.recv(100))[0].source == NEAR
                return
        raise AssertionError("no multicast arrived in 20 s")
