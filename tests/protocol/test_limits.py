"""Rates, and addresses of known ids, on virtual time."""

import pytest

from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.logs import MAX_LINES_AT_ONCE
from jauspy.node import NodeConfig
from jauspy.protocol import (
    address_book,
    judp,
    junior,
    sources,
    sources as buckets,
)
from jauspy.protocol.address_book import IdBounds, LearnedAddresses
from jauspy.protocol.addressing import LocalPort, UdpPort
from jauspy.protocol.header import Packet, Priority
from jauspy.protocol.routing import Router
from jauspy.protocol.sources import SourceChecks, SourceLimits, TokenBuckets

HERE, FAR = JausID.parse("101.1.1"), JausID.parse("42.1.1")
PORT = LocalPort(f"/root/{int(HERE)}")
KEY = b"sixteen bytes or more"


def core(**limits: object) -> Router:
    node = Router("/root", sources=SourceChecks(SourceLimits(**limits)))  # type: ignore[arg-type]
    node.receive(junior.connect(HERE), PORT, 0.0)
    node.poll_output()
    return node


def received(node: Router, data: bytes, host: str = "10.0.0.1", now: float = 0.0) -> int:
    node.receive(data, UdpPort(host, 3794), now)
    return len(node.poll_output())


def query(number: int, priority: Priority = Priority.STANDARD) -> bytes:
    return judp.pack(Packet(FAR, HERE, b"\x02\x20", number, priority))


def test_token_bucket_allows_a_burst_and_then_its_rate() -> None:
    bucket = TokenBuckets(10.0, 5.0)
    assert sum(bucket.take("a", 0.0) for _ in range(20)) == 5
    assert sum(bucket.take("a", 1.0 + n / 100) for n in range(200)) in (24, 25)
    assert bucket.take("b", 3.0)


def test_the_number_of_buckets_is_bounded() -> None:
    bucket = TokenBuckets(1.0, 1.0)
    for key in range(buckets.MAX_TOKEN_BUCKETS + 10):
        bucket.take(key, 0.0)
    assert len(bucket) == buckets.MAX_TOKEN_BUCKETS


def test_rate_limit_spares_safety_critical_messages_and_other_sources() -> None:
    node = core(rate=100.0, burst=10.0)
    assert sum(received(node, query(n)) for n in range(1000)) == 10
    assert node.counters["dropped.rate"] == 990
    assert received(node, query(1000, Priority.SAFETY_CRITICAL)) == 1
    assert received(node, judp.pack(Packet(JausID(43, 1, 1), HERE, b"\x02\x20"))) == 1


def test_rate_limit_applies_to_components() -> None:
    node = core(rate=100.0, burst=10.0)
    for n in range(50):
        node.receive(judp.pack(Packet(HERE, HERE, b"\0\0", n)), PORT, 0.0)
    assert len(node.poll_output()) == 10


def test_id_keeps_its_host_until_it_is_silent() -> None:
    node = core()
    assert received(node, query(1)) == 1
    assert received(node, query(2), "10.0.0.66", 5.0) == 0
    assert node.counters["dropped.address_mismatch"] == 1
    assert received(node, query(3), now=10.0) == 1
    assert received(node, query(4), "10.0.0.66", 10.0 + sources.MOVE_TIMEOUT) == 1


def test_forged_ids_of_a_host_displace_only_its_own() -> None:
    """Neither where they are to be heard, nor where they are reached."""
    node = core()
    node.receive(query(1), UdpPort("10.0.0.1", 3794), 0.0)
    for number in range(2 * address_book.MAX_IDS):
        made_up = JausID.from_int(0x02000101 + (number << 8 & 0xFF0000) + (number & 0x7F))
        other = judp.pack(Packet(made_up, FAR, b"", number & 0xFFFF))
        node.receive(other, UdpPort("10.0.0.66", 3794), number * 1e-4)
    node.poll_output()
    assert len(node.address_book) <= address_book.MAX_IDS_PER_HOST + 1
    assert received(node, query(2), "10.0.0.66", 2.0) == 0
    answer = judp.pack(Packet(HERE, FAR, b"\x02\x40", 3))
    node.receive(answer, PORT, 2.0)
    assert node.poll_output() == [(UdpPort("10.0.0.1", 3794), answer)]


def test_bounds_of_ids_are_configured() -> None:
    """In the node manager's file, for addresses and for checks of sources."""
    config = NodeConfig.make(max_ids=64, max_ids_per_host=64)
    checks = SourceChecks(SourceLimits(rate=1.0), bounds=config.id_bounds)
    node = Router("/root", sources=checks, bounds=config.id_bounds)
    for number in range(200):
        made_up = JausID(1 + number, 1, 1)
        node.receive(judp.pack(Packet(made_up, HERE, b"", 1)), UdpPort(f"10.0.0.{number}", 3794), 0.0)
    assert len(node.address_book) == 64
    assert not checks.check_address(int(JausID(200, 1, 1)), UdpPort("10.0.1.1", 3794), 0.1)
    assert checks.check_address(int(JausID(1, 1, 1)), UdpPort("10.0.1.1", 3794), 0.1), "forgotten"
    for name in ("max_ids", "max_ids_per_host"):
        with pytest.raises(ConfigError, match=f"{name}.*64"):
            NodeConfig.make(**{name: 0})


def test_ids_of_a_host_are_bounded_and_the_oldest_is_dropped() -> None:
    places, port, other = LearnedAddresses(IdBounds(4, 2)), UdpPort("10.0.0.1", 3794), UdpPort("10.0.0.2", 3794)
    for now, id in enumerate((1, 2, 1, 3)):
        places.set(id, port, float(now))
    places.set(4, other, 9.0)
    assert [id for id, _, _ in places] == [1, 3, 4]
    places.remove_older(3.0)
    assert [id for id, _, _ in places] == [4]
    for number, id in enumerate((5, 6, 7, 8)):
        places.set(id, UdpPort(f"10.0.1.{number}", 1), 10.0)
    assert len(places) == 4
    assert places.get(4) is None


def test_duplicate_ids_are_logged_once_and_counted(
    caplog: pytest.LogCaptureFixture,
) -> None:
    node = core()
    stolen = judp.pack(Packet(HERE, FAR, b"", 1))
    for port in range(1000):
        node.receive(stolen, UdpPort("10.0.0.66", port), 0.0)
    assert len(caplog.records) == 1
    for number in range(1000):
        node.receive(stolen, UdpPort(f"10.0.{number >> 8}.{number & 255}", 3794), 1.0)
    assert len(caplog.records) <= MAX_LINES_AT_ONCE + 1
    assert node.counters["dropped.hijack"] == 2000


def test_udp_components_leave_room_for_local_ones() -> None:
    node = Router("/root")
    for number in range(address_book.MAX_UDP_COMPONENTS + 10):
        id = JausID(7, 1 + number // 200, 1 + number % 200)
        node.receive(junior.connect(id), UdpPort("127.0.0.1", 5000 + number), 0.0)
    assert len(node.components) == address_book.MAX_UDP_COMPONENTS
    assert node.counters["dropped.component_refused"] == 10
    node.receive(junior.connect(HERE), PORT, 0.0)
    assert int(HERE) in node.components
    node.receive(junior.cancel(JausID(7, 1, 1)), UdpPort("127.0.0.1", 5000), 0.0)
    node.receive(junior.connect(JausID(9, 1, 1)), UdpPort("127.0.0.1", 4999), 0.0)
    assert int(JausID(9, 1, 1)) in node.components


def test_address_check_can_be_disabled() -> None:
    node = core(check_address=False)
    assert [received(node, query(n), f"10.0.0.{n}") for n in (1, 2)] == [1, 1]


@pytest.mark.parametrize("priority", list(Priority))
def test_priority_is_read_from_unchecked_packets(priority: Priority) -> None:
    assert judp.peek_priority(query(1, priority)) == priority
    assert judp.peek_priority(b"12" + query(1, priority), 2) == priority


def test_garbage_has_the_lowest_priority() -> None:
    assert [judp.peek_priority(data) for data in (b"", b"\x02", b"\x02\x00\xff\xff\xff", bytes(100))] == [0] * 4
