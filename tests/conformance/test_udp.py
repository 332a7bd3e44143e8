"""The judge's way: UDP and multicast, also beside a node manager, and with many files open."""

from __future__ import annotations

import contextlib
import os
import resource
import socket
import time
from collections.abc import Iterator

import pytest

from jauspy.conformance.link import UdpLink
from jauspy.errors import TransportError
from jauspy.ids import JausID
from jauspy.node import network as binding
from jauspy.protocol import judp
from jauspy.protocol.header import Packet
from jauspy.transport import multicast

GROUP = "239.255.77.1"
ROBOT, JUDGE = JausID(101, 1, 1), JausID(42, 1, 1)
QUESTION = judp.pack(Packet(ROBOT, JUDGE, b"\x00\x2b\x02", 7))
TIMEOUT = 20.0


def say(data: bytes, address: tuple[str, int]) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as robot:
        multicast.prepare_sender(robot, multicast.ANY, 1)
        robot.sendto(data, address)


def need_network(link: UdpLink) -> None:
    if any("cannot be joined" in each for each in link.notes):
        pytest.skip("needs a network with multicasts")


@pytest.fixture
def node_manager(free_port: int) -> Iterator[socket.socket]:
    """Its socket, as it is bound on all addresses."""
    sock = binding.bind_udp(multicast.ANY, free_port, 65536)
    multicast.share_group(sock)
    yield sock
    sock.close()


def test_multicasts_are_received_beside_a_node_manager(node_manager, free_port):
    link = UdpLink(group=(GROUP, free_port), port=free_port)
    try:
        need_network(link)
        assert link.port != free_port
        (note,) = link.notes
        assert f"UDP port {free_port} is taken" in note
        say(QUESTION, (GROUP, free_port))
        arrival = link.receive(time.monotonic() + TIMEOUT)
    finally:
        link.close()
    assert arrival is not None
    assert arrival.data == QUESTION


def test_datagrams_for_the_node_manager_are_not_received(node_manager, free_port):
    link = UdpLink(group=(GROUP, free_port), port=free_port)
    try:
        say(QUESTION, ("127.0.0.1", free_port))
        node_manager.settimeout(TIMEOUT)
        assert node_manager.recv(100) == QUESTION
        assert link.receive(time.monotonic()) is None
    finally:
        link.close()


def test_port_of_a_node_manager_is_not_shared(node_manager, free_port):
    with pytest.raises(TransportError, match=f"UDP port {free_port} is used by"):
        binding.bind_udp(multicast.ANY, free_port, 65536)


def test_multicasts_are_received_once_on_a_free_port(free_port):
    link = UdpLink(group=(GROUP, free_port), port=free_port)
    try:
        need_network(link)
        assert (link.port, link.notes) == (free_port, [])
        say(QUESTION, (GROUP, free_port))
        say(QUESTION[:-1] + b"\x01", ("127.0.0.1", free_port))
        heard = [link.receive(time.monotonic() + TIMEOUT) for _ in range(2)]
        assert link.receive(time.monotonic()) is None
    finally:
        link.close()
    assert len({each.data for each in heard if each}) == 2


def test_group_in_use_is_noted(free_port):
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as stranger:
        stranger.bind(("", free_port))
        link = UdpLink(peer=("127.0.0.1", free_port))
        link.close()
    assert f"no multicasts are received: port {free_port} is held by another" in link.notes[-1]


def test_many_open_files_do_not_break_receiving(free_port):
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    if hard < 1200:
        pytest.skip(f"this system allows {hard} open files")
    resource.setrlimit(resource.RLIMIT_NOFILE, (max(soft, 1200), hard))
    files = [os.open(os.devnull, os.O_RDONLY) for _ in range(1050)]
    try:
        link = UdpLink(group=(GROUP, free_port), port=free_port)
        say(QUESTION, ("127.0.0.1", free_port))
        arrival = link.receive(time.monotonic() + TIMEOUT)
        link.close()
    finally:
        for each in files:
            os.close(each)
        resource.setrlimit(resource.RLIMIT_NOFILE, (soft, hard))
    assert arrival is not None


def test_datagrams_that_arrive_during_a_busy_step_are_kept(free_port):
    """As much as in a socket that asked the kernel for a large buffer."""
    link = UdpLink(group=(GROUP, free_port), port=free_port)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as other:
        other.setblocking(False)
        other.bind(("127.0.0.1", 0))
        multicast.set_receive_buffer(other)
        held = arrived = 0
        try:
            for _ in range(1000):
                say(QUESTION, ("127.0.0.1", free_port))
                say(QUESTION, other.getsockname())
            with contextlib.suppress(BlockingIOError):
                while other.recv(5000):
                    held += 1
            while link.receive(time.monotonic() + 0.1) is not None:
                arrived += 1
        finally:
            link.close()
    assert arrived >= 0.9 * held
