"""The machines of an attack: network namespaces on one switch, or addresses of the loopback interface."""

from __future__ import annotations

import contextlib
import ctypes
import os
import shutil
import socket
import struct
import subprocess
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from .attack import NotPossible

_CLONE_NEWNET: Final = 0x40000000
"""From linux/sched.h."""
HOSTS: Final = ("robot", "operator", "attacker", "gateway")
"""Their addresses end in 1, 2, 3 and 4. The robot and the gateway are also on a second network."""
_ON_SECOND: Final = ("robot", "gateway", "attacker")


@dataclass(frozen=True, slots=True)
class Host:
    """A machine; `namespace` is empty on the loopback interface."""

    name: str
    address: str
    address6: str
    second: str
    """The address on the second network; empty if it is not there."""
    namespace: str = ""

    def command(self, *command: str) -> tuple[str, ...]:
        """The command line that runs a program on this machine."""
        return ("ip", "netns", "exec", self.namespace, *command) if self.namespace else command

    @contextlib.contextmanager
    def entered(self) -> Iterator[None]:
        """Sockets that are made meanwhile belong to this machine."""
        if not self.namespace:
            yield
            return
        with Path("/proc/self/ns/net").open("rb") as own, Path("/run/netns", self.namespace).open("rb") as other:
            _enter(other.fileno())
            try:
                yield
            finally:
                _enter(own.fileno())

    def udp(self, address: str | None = None, port: int = 0) -> socket.socket:
        """A UDP socket of this machine that never blocks."""
        address = self.address if address is None else address
        with self.entered():
            sock = socket.socket(socket.AF_INET6 if ":" in address else socket.AF_INET, socket.SOCK_DGRAM)
            sock.setblocking(False)
            sock.bind((address, port))
        return sock

    def forger(self) -> Forger:
        """Sends IPv4 datagrams with any source address; raises `NotPossible`."""
        with self.entered():
            try:
                return Forger(socket.socket(socket.AF_INET, socket.SOCK_RAW, socket.IPPROTO_RAW))
            except PermissionError:
                raise NotPossible("needs root, to forge source addresses of IP") from None


class Forger:
    """A raw socket."""

    def __init__(self, sock: socket.socket) -> None:
        self._socket = sock

    def send(self, data: bytes, source: tuple[str, int], destination: tuple[str, int]) -> None:
        """Send as if from `source`. The checksum of UDP is left out, as IPv4 allows."""
        udp = struct.pack("!HHHH", source[1], destination[1], 8 + len(data), 0) + data
        head = struct.pack("!BBHHHBBH", 0x45, 0, 20 + len(udp), 0, 0, 64, socket.IPPROTO_UDP, 0)
        addresses = socket.inet_aton(source[0]) + socket.inet_aton(destination[0])
        with contextlib.suppress(BlockingIOError, OSError):
            self._socket.sendto(head + addresses + udp, (destination[0], 0))

    def close(self) -> None:
        """Close the socket."""
        self._socket.close()


@dataclass(frozen=True, slots=True)
class Lan:
    """All machines by name; `why_loopback` says why there are no namespaces, if so."""

    hosts: dict[str, Host]
    why_loopback: str = ""


@contextlib.contextmanager
def lan() -> Iterator[Lan]:
    """Machines in namespaces where that is permitted, else on the loopback interface."""
    with contextlib.ExitStack() as stack:
        try:
            made = _namespaces(stack)
        except NotPossible as error:
            stack.close()
            made = Lan({name: Host(name, f"127.0.0.{n}", "::1", "") for n, name in enumerate(HOSTS, 1)}, str(error))
        yield made


def _namespaces(stack: contextlib.ExitStack) -> Lan:
    if os.geteuid() or not shutil.which("ip"):
        raise NotPossible("network namespaces need root and the program ip")
    try:
        return _connected(stack)
    except subprocess.CalledProcessError as error:
        raise NotPossible(f"network namespaces are not permitted: {error.stderr.decode().strip()}") from None


def _connected(stack: contextlib.ExitStack) -> Lan:
    """Two switches in a namespace of their own, and a cable to each machine."""
    switch = f"ja{os.getpid()}"
    for name in (switch, *(f"{switch}{host}" for host in HOSTS)):
        _ip("netns", "add", name)
        stack.callback(_ip, "netns", "del", name)
        _ip("-n", name, "link", "set", "lo", "up")
    for bridge in ("first", "second"):
        _ip("-n", switch, "link", "add", bridge, "type", "bridge", "mcast_snooping", "0")
        _ip("-n", switch, "link", "set", bridge, "up")
    hosts = {}
    for number, host in enumerate(HOSTS, 1):
        namespace = f"{switch}{host}"
        _plug(switch, "first", f"a{number}", namespace, "eth0")
        _ip("-n", namespace, "addr", "add", f"10.77.0.{number}/24", "dev", "eth0")
        _ip("-n", namespace, "addr", "add", f"fd77::{number}/64", "dev", "eth0", "nodad")
        _ip("-n", namespace, "route", "add", "default", "dev", "eth0")
        second = f"10.78.0.{number}" if host in _ON_SECOND else ""
        if second:
            _plug(switch, "second", f"b{number}", namespace, "eth1")
            _ip("-n", namespace, "addr", "add", f"{second}/24", "dev", "eth1")
        hosts[host] = Host(host, f"10.77.0.{number}", f"fd77::{number}", second, namespace)
    return Lan(hosts)


def _plug(switch: str, bridge: str, port: str, namespace: str, interface: str) -> None:
    _ip("link", "add", port, "netns", switch, "type", "veth", "peer", interface, "netns", namespace)
    _ip("-n", switch, "link", "set", port, "master", bridge)
    _ip("-n", switch, "link", "set", port, "up")
    _ip("-n", namespace, "link", "set", interface, "up")


def _ip(*arguments: str) -> None:
    subprocess.run(("ip", *arguments), check=True, capture_output=True, timeout=20)


def _enter(namespace: int) -> None:
    libc = ctypes.CDLL(None, use_errno=True)
    if libc.setns(namespace, _CLONE_NEWNET):
        raise OSError(ctypes.get_errno(), "setns")
