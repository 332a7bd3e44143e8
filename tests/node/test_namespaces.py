"""Two hosts on one cable: node managers in two network namespaces find each other by multicast."""

import contextlib
import json
import os
import socket
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from jauspy.ids import EVERYONE, JausID
from jauspy.protocol import judp, junior
from jauspy.protocol.header import Broadcast, Packet

NEAR, FAR = JausID.parse("101.1.1"), JausID.parse("102.1.1")

DAEMON = """
import asyncio, json, sys
from jauspy.node import NodeConfig, NodeManager
from jauspy.transport import multicast
multicast.WATCH_INTERVAL = 0.1
async def main(settings):
    async with NodeManager(NodeConfig.make(**json.loads(settings))) as manager:
        print("ready", flush=True)
        await asyncio.to_thread(sys.stdin.read)
asyncio.run(main(sys.argv[1]))
"""


@contextlib.contextmanager
def node_manager(namespace: str, root: Path, **settings: object) -> Iterator[None]:
    root.mkdir()
    reported = json.dumps(settings | {"local_root": str(root)})
    command = ("ip", "netns", "exec", namespace, sys.executable, "-c", DAEMON, reported)
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == b"ready\n"
        yield
        process.communicate(timeout=20)
        assert process.returncode == 0


@contextlib.contextmanager
def component(root: Path, id: JausID) -> Iterator[socket.socket]:
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as sock:
        sock.settimeout(20)
        sock.bind(str(root / str(int(id))))
        sock.sendto(junior.connect(id), str(root / junior.SOCKET_NAME))
        assert sock.recv(100) == junior.accept(id)
        yield sock


@pytest.mark.slow
def test_two_hosts_communicate(cable: tuple[str, str], root: Path) -> None:
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


def run(*command: str) -> None:
    subprocess.run(command, check=True, capture_output=True, timeout=20)


def until_heard(speaker: socket.socket, folder: Path, listener: socket.socket) -> None:
    """Broadcast until the other one hears it."""
    until_arrived(Packet(NEAR, EVERYONE, b"\x00\x2b\x04", broadcast=Broadcast.GLOBAL), speaker, folder, listener)


def until_arrived(packet: Packet, speaker: socket.socket, folder: Path, listener: socket.socket) -> None:
    """Send until it arrives: an interface that has just come up may not be ready in both directions."""
    listener.settimeout(0.2)
    for _ in range(100):
        speaker.sendto(judp.pack(packet), str(folder / junior.SOCKET_NAME))
        with contextlib.suppress(TimeoutError):
            while judp.unpack(listener.recv(5000)) != [packet]:
                continue
            return
    raise AssertionError("it did not arrive in 20 s")


@pytest.mark.slow
def test_late_network_is_joined(cable: tuple[str, str], root: Path) -> None:
    near, far = root / "a", root / "b"
    end = f"jv{os.getpid()}b"
    late = ("ip", "-n", cable[1])
    run(*late, "addr", "flush", "dev", end)
    run(*late, "link", "set", end, "down")
    with contextlib.ExitStack() as stack:
        for namespace, folder in zip(cable, (near, far), strict=True):
            stack.enter_context(node_manager(namespace, folder))
        a = stack.enter_context(component(near, NEAR))
        b = stack.enter_context(component(far, FAR))
        for change in (("link", "set", end, "up"), ("addr", "add", "10.77.0.2/24", "dev", end)):
            run(*late, *change)
        run(*late, "route", "add", "default", "dev", end)
        until_heard(a, near, b)


@pytest.mark.slow
@pytest.mark.parametrize("chosen", ["all", "10.77.0.2"])
def test_returning_interface_is_joined_again(cable: tuple[str, str], root: Path, chosen: str) -> None:
    """The whole interface is deleted, as when an adapter is pulled out, and made anew: another one to the kernel."""
    near, far = root / "a", root / "b"
    ends = [f"jv{os.getpid()}{letter}" for letter in "ab"]
    with contextlib.ExitStack() as stack:
        for number, (namespace, folder) in enumerate(zip(cable, (near, far), strict=True), 1):
            interface = "all" if chosen == "all" else f"10.77.0.{number}"
            stack.enter_context(node_manager(namespace, folder, multicast_interfaces=[interface]))
        a = stack.enter_context(component(near, NEAR))
        b = stack.enter_context(component(far, FAR))
        until_heard(a, near, b)
        run("ip", "-n", cable[0], "link", "del", ends[0])
        run("ip", "link", "add", ends[0], "netns", cable[0], "type", "veth", "peer", ends[1], "netns", cable[1])
        for number, (namespace, end) in enumerate(zip(cable, ends, strict=True), 1):
            run("ip", "-n", namespace, "addr", "add", f"10.77.0.{number}/24", "dev", end)
            run("ip", "-n", namespace, "link", "set", end, "up")
        until_heard(a, near, b)


@pytest.mark.slow
@pytest.mark.parametrize(
    "own",
    [{}, {"multicast_interfaces": ["all"]}, {"address6": "fd77::{}", "multicast_interfaces": ["fd77::{}"]}],
    ids=["by route", "all", "one address"],
)
def test_two_hosts_communicate_by_ipv6_only(cable: tuple[str, str], root: Path, own: dict[str, object]) -> None:
    """On all addresses by multicasts from a link-local one, which is answered on the interface it came by."""
    near, far = root / "a", root / "b"
    settings = json.dumps({"address6": "::", "multicast_group6": "ff15::6a61:7573", **own})
    with contextlib.ExitStack() as stack:
        if not Path("/proc/sys/net/ipv6").exists():
            pytest.skip("this system has no IPv6")
        for number, (namespace, letter) in enumerate(zip(cable, "ab", strict=True), 1):
            end = f"jv{os.getpid()}{letter}"
            run("ip", "-n", namespace, "-4", "addr", "flush", "dev", end)
            run("ip", "-n", namespace, "addr", "add", f"fd77::{number}/64", "dev", end, "nodad")
        for number, (namespace, folder) in enumerate(zip(cable, (near, far), strict=True), 1):
            reported = json.loads(settings.replace("{}", str(number)))
            stack.enter_context(node_manager(namespace, folder, **reported))
        a = stack.enter_context(component(near, NEAR))
        b = stack.enter_context(component(far, FAR))
        until_heard(a, near, b)
        until_arrived(Packet(FAR, NEAR, b"\x00\x4b", 1), b, far, a)
        until_arrived(Packet(NEAR, FAR, b"\x02\x20", 2), a, near, b)
