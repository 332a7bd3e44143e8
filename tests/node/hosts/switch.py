"""Hosts that are network namespaces, and what lies between them. Needs root."""

import contextlib
import json
import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

PROGRAMS = Path(__file__).parent
LOSS, TWICE, DELAY = 0.1, 0.05, 0.02
RELAY = json.dumps({"loss": LOSS, "twice": TWICE, "delay": DELAY, "seed": 1})
NETEM = ("netem", "delay", "10ms", "8ms", "loss", "10%", "duplicate", "5%", "reorder", "5%")

# The checksum of what a virtual port sends is usually left to hardware; frames that pass a program need it written.
CHECKSUMS = """
import ctypes, fcntl, socket, struct, sys
value = ctypes.create_string_buffer(struct.pack("=II", 0x17, 0))
request = struct.pack("16sP", sys.argv[1].encode(), ctypes.addressof(value))
with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sock:
    fcntl.ioctl(sock, 0x8946, request)
"""


def run(*command: str) -> None:
    subprocess.run(command, check=True, capture_output=True, timeout=20)


@contextlib.contextmanager
def started(namespace: str, *command: str) -> Iterator[subprocess.Popen[str]]:
    with subprocess.Popen(
        ("ip", "netns", "exec", namespace, sys.executable, *command),
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    ) as process:
        try:
            assert process.stdout is not None
            assert process.stdout.readline() == "ready\n"
            yield process
        finally:
            process.kill()


class Switch:
    """A namespace with one port for each of `count` hosts, which are 10.77.0.1, 10.77.0.2 and so on."""

    def __init__(self, stack: contextlib.ExitStack, count: int) -> None:
        self._stack = stack
        self.name = f"js{os.getpid()}"
        self.hosts = [f"{self.name}h{number}" for number in range(1, count + 1)]
        self.ports = [f"p{number}" for number in range(1, count + 1)]
        for name in (self.name, *self.hosts):
            self._add(name)
        for number, (host, port) in enumerate(zip(self.hosts, self.ports, strict=True), 1):
            run("ip", "link", "add", port, "netns", self.name, "type", "veth", "peer", "eth0", "netns", host)
            run("ip", "-n", self.name, "link", "set", port, "up")
            run("ip", "-n", host, "addr", "add", f"10.77.0.{number}/24", "dev", "eth0")
            run("ip", "-n", host, "link", "set", "eth0", "up")
            run("ip", "-n", host, "route", "add", "default", "dev", "eth0")
            run("ip", "netns", "exec", host, sys.executable, "-c", CHECKSUMS, "eth0")

    def relay(self, **settings: float) -> subprocess.Popen[str]:
        """Frames pass through a program, which takes these settings and the words on its input of relay.py."""
        reported = json.dumps(json.loads(RELAY) | settings | {"ports": self.ports})
        return self._stack.enter_context(started(self.name, str(PROGRAMS / "relay.py"), reported))

    def bridge(self) -> None:
        """Nothing is lost."""
        run("ip", "-n", self.name, "link", "add", "br0", "type", "bridge", "mcast_snooping", "0")
        run("ip", "-n", self.name, "link", "set", "br0", "up")
        for port in self.ports:
            run("ip", "-n", self.name, "link", "set", port, "master", "br0")

    def behind(self, host: str) -> str:
        """Another host, on a cable of its own to this one: 10.88.0.2, and 10.88.0.1 there."""
        name = f"{host}b"
        self._add(name)
        run("ip", "link", "add", "eth1", "netns", host, "type", "veth", "peer", "eth1", "netns", name)
        for number, end in enumerate((host, name), 1):
            run("ip", "-n", end, "addr", "add", f"10.88.0.{number}/24", "dev", "eth1")
            run("ip", "-n", end, "link", "set", "eth1", "up")
        return name

    def _add(self, name: str) -> None:
        run("ip", "netns", "add", name)
        self._stack.callback(run, "ip", "netns", "del", name)
        run("ip", "-n", name, "link", "set", "lo", "up")

    def netem(self) -> None:
        """As `bridge`, and each port is made bad by the kernel."""
        self.bridge()
        for port in self.ports:
            try:
                run("tc", "-n", self.name, "qdisc", "add", "dev", port, "root", *NETEM)
            except (FileNotFoundError, subprocess.CalledProcessError) as error:
                reported = getattr(error, "stderr", None) or str(error).encode()
                pytest.skip(f"needs tc and the kernel's sch_netem: {reported.decode().strip()}")
