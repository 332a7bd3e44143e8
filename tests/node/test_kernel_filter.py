"""The kernel drops what is least urgent, and nothing else."""

import socket
import sys
from collections.abc import Callable

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


def test_missing_filter_support_is_reported(monkeypatch: pytest.MonkeyPatch, udp: Callable[[], socket.socket]) -> None:
    monkeypatch.setattr(kernel_filter, "_SO_ATTACH_FILTER", 9999)
    assert not kernel_filter.attach(udp(), Priority.LOW, 0)
