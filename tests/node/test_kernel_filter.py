"""The kernel drops what is least urgent, and nothing else."""

import socket
import sys
from collections.abc import Callable
from contextlib import ExitStack

import pytest

from jauspy.ids import JausID
from jauspy.node import kernel_filter
from jauspy.protocol import judp
from jauspy.protocol.header import Packet, Priority

HERE = JausID.parse("101.1.1")
OTHERS = (
    b"\x02\x40" + bytes(20),  # compressed
    b"\x01" + bytes(20),
    b"J" + bytes(30),
)

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="socket filters in BPF are Linux's")


def packet(priority: Priority, payload: bytes = b"\x02\x20") -> bytes:
    return judp.pack(Packet(HERE, HERE, payload, 1, priority))


def arrived(sock: socket.socket) -> list[bytes]:
    """On the loopback interface a datagram is there, or dropped, when it has been sent."""
    found = []
    while True:
        try:
            found.append(sock.recv(65536))
        except BlockingIOError:
            return found


@pytest.mark.parametrize("up_to", [Priority.LOW, Priority.STANDARD, Priority.HIGH])
@pytest.mark.parametrize("skip", [0, 7])
def test_urgent_and_unknown_packets_pass_the_filter(
    udp: Callable[[], socket.socket], up_to: Priority, skip: int
) -> None:
    receiver, sender = udp(), udp()
    prefix = bytes(range(skip))
    sent = [prefix + data for data in (*map(packet, Priority), *OTHERS, packet(Priority.SAFETY_CRITICAL, bytes(60000)))]
    assert kernel_filter.attach(receiver, up_to, skip)
    for data in sent:
        sender.sendto(data, receiver.getsockname())
    assert arrived(receiver) == sent[up_to + 1 :]
    kernel_filter.detach(receiver)
    for data in sent:
        sender.sendto(data, receiver.getsockname())
    assert arrived(receiver) == sent


@pytest.mark.parametrize(
    ("hosts", "others"),
    [
        (["127.0.0.2"], ["127.0.0.3"]),
        ([f"127.0.0.{n}" for n in range(2, 10)], ["127.0.0.10", "127.1.0.2"]),
        (["::1"], []),
    ],
)
def test_only_the_flooding_hosts_are_filtered(hosts: list[str], others: list[str]) -> None:
    def bound(host: str) -> socket.socket:
        family = socket.AF_INET6 if ":" in host else socket.AF_INET
        sock = stack.enter_context(socket.socket(family, socket.SOCK_DGRAM))
        sock.setblocking(False)
        try:
            sock.bind((host, 0))
        except OSError:
            pytest.skip(f"this machine has no {host}")
        return sock

    with ExitStack() as stack:
        receiver = bound("::1" if ":" in hosts[0] else "127.0.0.1")
        senders = [bound(host) for host in (*hosts, *others)]
        unused = ["10.0.0.1", "fd00::1"]
        for filtered, passed in ((hosts, others), ([*hosts[:6], *unused], others + hosts[6:]), (unused, senders)):
            assert kernel_filter.attach(receiver, Priority.STANDARD, 0, filtered)
            for sock in senders:
                sock.sendto(packet(Priority.STANDARD), receiver.getsockname())
                sock.sendto(packet(Priority.HIGH), receiver.getsockname())
            assert len(arrived(receiver)) == len(senders) + len(passed)


def test_missing_filter_support_is_reported(monkeypatch: pytest.MonkeyPatch, udp: Callable[[], socket.socket]) -> None:
    monkeypatch.setattr(kernel_filter, "_SO_ATTACH_FILTER", 9999)
    assert not kernel_filter.attach(udp(), Priority.LOW, 0)
