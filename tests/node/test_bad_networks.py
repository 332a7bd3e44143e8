"""Two to five hosts, each a network namespace with a node manager, on a switch that loses, delays and doubles."""

import contextlib
import itertools
import json
import os
import shutil
import subprocess
import sys
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

PROGRAMS = Path(__file__).parent / "hosts"
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
        self.name = f"js{os.getpid()}"
        self.hosts = [f"{self.name}h{number}" for number in range(1, count + 1)]
        self.ports = [f"p{number}" for number in range(1, count + 1)]
        for name in (self.name, *self.hosts):
            run("ip", "netns", "add", name)
            stack.callback(run, "ip", "netns", "del", name)
        for number, (host, port) in enumerate(zip(self.hosts, self.ports, strict=True), 1):
            run("ip", "link", "add", port, "netns", self.name, "type", "veth", "peer", "eth0", "netns", host)
            run("ip", "-n", self.name, "link", "set", port, "up")
            run("ip", "-n", host, "addr", "add", f"10.77.0.{number}/24", "dev", "eth0")
            run("ip", "-n", host, "link", "set", "eth0", "up")
            run("ip", "-n", host, "link", "set", "lo", "up")
            run("ip", "-n", host, "route", "add", "default", "dev", "eth0")
            run("ip", "netns", "exec", host, sys.executable, "-c", CHECKSUMS, "eth0")
        self._stack = stack

    def relay(self) -> None:
        """Frames pass through a program."""
        told = json.dumps(json.loads(RELAY) | {"ports": self.ports})
        self._stack.enter_context(started(self.name, str(PROGRAMS / "relay.py"), told))

    def netem(self) -> None:
        """Frames pass through a bridge, and each port is made bad by the kernel."""
        run("ip", "-n", self.name, "link", "add", "br0", "type", "bridge", "mcast_snooping", "0")
        run("ip", "-n", self.name, "link", "set", "br0", "up")
        for port in self.ports:
            run("ip", "-n", self.name, "link", "set", port, "master", "br0")
            try:
                run("tc", "-n", self.name, "qdisc", "add", "dev", port, "root", *NETEM)
            except (FileNotFoundError, subprocess.CalledProcessError) as error:
                told = getattr(error, "stderr", None) or str(error).encode()
                pytest.skip(f"needs tc and the kernel's sch_netem: {told.decode().strip()}")


@pytest.fixture
def switch() -> Iterator[Callable[[int], Switch]]:
    if os.geteuid() or not shutil.which("ip"):
        pytest.skip("needs root and the program ip to make network namespaces")
    with contextlib.ExitStack() as stack:

        def make(count: int) -> Switch:
            try:
                return Switch(stack, count)
            except subprocess.CalledProcessError as error:
                pytest.skip(f"this system makes no network namespaces: {error.stderr.decode().strip()}")

        yield make


def converse(hosts: list[str], root: Path, count: int, **settings: Any) -> list[dict[str, Any]]:
    """Each host sends to each other; what each tells of it."""
    ids = [f"{101 + number}.1.1" for number in range(len(hosts))]
    with contextlib.ExitStack() as stack:
        members = []
        for host, id in zip(hosts, ids, strict=True):
            others = [each for each in ids if each != id]
            told = {"root": str(root / id), "id": id, "others": others, "count": count, "settings": settings}
            member = stack.enter_context(started(host, str(PROGRAMS / "member.py"), json.dumps(told)))
            members.append((member.stdin, member.stdout))
        for word, answer in (("go", "sent"), ("stop", None)):
            for writer, _ in members:
                assert writer is not None
                writer.write(f"{word}\n")
                writer.flush()
            lines = [reader.readline().strip() for _, reader in members if reader is not None]
            assert answer is None or lines == [answer] * len(members)
        return [json.loads(each) for each in lines]


@pytest.mark.parametrize("how", ["netem", "relay"])
@pytest.mark.parametrize("count", [2, 5])
def test_acknowledged_messages_arrive_once_each(
    switch: Callable[[int], Switch], root: Path, how: str, count: int
) -> None:
    """One tenth of the packets is lost; a fifth of the messages is large, in five packets of three frames each."""
    made = switch(count)
    getattr(made, how)()
    told = converse(made.hosts, root, 40 // count)
    delivered = {text for each in told for text, arrived in each["sent"].items() if arrived}
    received = Counter(itertools.chain.from_iterable(each["received"] for each in told))
    assert max(received.values()) == 1
    assert delivered <= set(received)
    assert len(delivered) == count * (count - 1) * (40 // count)
    counted = sum((Counter(each["counters"]) for each in told), Counter())
    assert min(counted["resent"], counted["dropped.duplicate"]) > 0


def test_compressed_headers_survive_a_bad_network(switch: Callable[[int], Switch], root: Path) -> None:
    made = switch(2)
    made.relay()
    told = converse(made.hosts, root, 60, header_compression="propose")
    received = Counter(itertools.chain.from_iterable(each["received"] for each in told))
    assert received == Counter(text for each in told for text in each["sent"])
    assert sum(each["counters"].get("compression.received", 0) for each in told) > 10
