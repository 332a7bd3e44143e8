"""Messages of more than one packet: bytes of the pieces, any order, bounds, 16 MB."""

from typing import Any

import pytest
from hypothesis import given, settings, strategies as st

from jauspy.errors import ProtocolError
from jauspy.ids import JausID
from jauspy.protocol import delivery, judp, reassembly
from jauspy.protocol.delivery import BURST_INTERVAL, FRAGMENTS_PER_BURST, Delivery
from jauspy.protocol.endpoint import Endpoint
from jauspy.protocol.header import MAX_PAYLOAD, Ack, DataFlag, Packet

A, B = JausID.parse("100.1.4"), JausID.parse("101.1.1")


def pieces(payload: bytes, first: int = 1, source: JausID = A, ack: Ack = Ack.NONE) -> list[bytes]:
    made = []
    for index in range(delivery.fragment_count(len(payload))):
        part, flag = delivery.fragment_at(payload, index)
        made.append(judp.pack(Packet(source, B, part, (first + index) & 0xFFFF, ack=ack, data_flag=flag)))
    return made


def message(endpoint: Endpoint) -> bytes | None:
    packet = endpoint.next_event()
    return packet.payload if packet else None


@pytest.mark.parametrize(("ack", "controls"), [(Ack.NONE, "4181c1"), (Ack.REQUIRED, "5191d1")])
def test_fragments_match_the_capture(ack: Ack, controls: str) -> None:
    endpoint = Endpoint(A, first_sequence=0xFFFF)
    endpoint.send(B, bytes(number & 0xFF for number in range(10000)), ack=ack, now=0.0)
    out = endpoint.poll_output()
    assert [int.from_bytes(data[2:4], "little") for data in out] == [4093, 4093, 1856]
    assert bytes(data[4] for data in out).hex() == controls
    assert [int.from_bytes(data[-2:], "little") for data in out] == [0xFFFF, 0, 1]
    assert out[1].hex().startswith(f"0200fd0f{controls[2:4]}0101650004016400eff0f1")


def test_fragments_wait_while_the_transport_is_congested() -> None:
    endpoint = Endpoint(A, first_sequence=1)
    endpoint.send(B, bytes(40 * MAX_PAYLOAD), now=0.0)
    assert len(endpoint.poll_output()) == FRAGMENTS_PER_BURST
    now = 0.0
    for room, count in ((False, 0), (False, 0), (True, FRAGMENTS_PER_BURST)):
        assert endpoint.next_timeout() == pytest.approx(now + BURST_INTERVAL)
        now = endpoint.next_timeout() or 0.0
        endpoint.handle_timeout(now, room=room)
        assert len(endpoint.poll_output()) == count


def test_congestion_drops_the_oldest_unreliable_messages() -> None:
    endpoint = Endpoint(A, first_sequence=1, delivery=Delivery(total_memory=100_000))
    endpoint.send(B, bytes(80_000), now=0.0)
    with pytest.raises(ProtocolError, match="too_much_under_way"):
        endpoint.send(B, bytes(80_000), now=0.0)
    endpoint.handle_timeout(BURST_INTERVAL, room=False)
    endpoint.poll_output()
    for number in range(50):
        endpoint.send(B, bytes([number]) * 80_000, now=BURST_INTERVAL)
    endpoint.send(B, b"stop", now=BURST_INTERVAL, ack=Ack.REQUIRED)
    assert endpoint.counters["dropped.large_message.stuck"] == 50
    assert len(endpoint.poll_output()) == 1


@settings(max_examples=60, deadline=None)
@given(st.data())
def test_fragments_in_any_order_with_duplicates_give_one_message(data: st.DataObject) -> None:
    payload = bytes(range(256)) * data.draw(st.integers(17, 120))
    parts = pieces(payload, data.draw(st.integers(0, 0xFFFF)), ack=data.draw(st.sampled_from([Ack.NONE, Ack.REQUIRED])))
    order = data.draw(st.permutations(parts + parts[: data.draw(st.integers(0, 3))]))
    endpoint = Endpoint(B, first_sequence=1)
    for part in order:
        endpoint.receive(part, 0.0)
    assert message(endpoint) == payload
    assert message(endpoint) is None
    assert endpoint.next_timeout() is None or not endpoint.handle_timeout(10.0)
    assert endpoint._reassembly.memory == 0


def test_messages_of_several_sources_are_separate() -> None:
    endpoint = Endpoint(B, first_sequence=1)
    sources = [JausID(100, 1, number) for number in range(1, 6)]
    payloads = [bytes([number]) * 9000 for number in range(5)]
    for each in zip(*(pieces(p, source=s) for s, p in zip(sources, payloads, strict=True)), strict=True):
        for part in each:
            endpoint.receive(part, 0.0)
    assert [message(endpoint) for _ in sources] == payloads


def test_consecutive_messages_are_separate() -> None:
    endpoint = Endpoint(B, first_sequence=1)
    first, second = b"a" * 9000, b"b" * 9000
    for part in reversed(pieces(first, 10) + pieces(second, 13)):
        endpoint.receive(part, 0.0)
    assert [message(endpoint), message(endpoint)] == [second, first]


def test_missing_fragments_expire_after_three_seconds() -> None:
    endpoint = Endpoint(B, first_sequence=1)
    first, middle, last = pieces(bytes(10000))
    endpoint.receive(first, 0.0)
    endpoint.receive(last, 2.0)
    assert endpoint.next_timeout() == 3.0
    endpoint.handle_timeout(3.0)
    endpoint.receive(middle, 3.1)
    assert message(endpoint) is None
    assert endpoint.counters["dropped.large_message.incomplete"] == 1
    for _ in range(12):
        at = endpoint.next_timeout()
        if at is not None:
            endpoint.handle_timeout(at)
    assert endpoint.next_timeout() is None
    assert endpoint._reassembly.memory == 0


def test_restarted_sender_with_the_same_numbers_is_received() -> None:
    endpoint = Endpoint(B, first_sequence=1)
    for part in pieces(b"\x01" * 10000, 0)[:2]:
        endpoint.receive(part, 0.0)
    for payload, now in ((b"\x02" * 10000, 0.2), (b"\x02" * 10000, 0.4)):
        for part in pieces(payload, 0):
            endpoint.receive(part, now)
        assert message(endpoint) == payload
    endpoint.receive(pieces(b"\x03" * 10000, 0)[0], 0.5)
    for part in pieces(b"\x03" * 10000, 0):
        endpoint.receive(part, 0.7)
    assert message(endpoint) == b"\x03" * 10000


def test_memory_is_bounded_per_source_and_the_newest_message_wins() -> None:
    endpoint = Endpoint(B, first_sequence=1, delivery=Delivery(max_message=40_000))
    for number in range(30):
        for part in pieces(bytes([number]) * 20_000, number * 10)[1:]:
            endpoint.receive(part, 0.0)
        assert endpoint._reassembly.memory <= 80_000
    for part in pieces(b"x" * 40_000, 1000):
        endpoint.receive(part, 0.0)
    assert message(endpoint) == b"x" * 40_000
    assert endpoint.counters["dropped.large_message.no_memory"] > 20


def test_memory_is_bounded_in_total_and_the_largest_source_loses() -> None:
    endpoint = Endpoint(B, first_sequence=1, delivery=Delivery(max_message=40_000, total_memory=100_000))
    start, *rest = pieces(b"m" * 10_000, 5, source=JausID(1, 1, 1))
    endpoint.receive(start, 0.0)
    for number in range(200):
        endpoint.receive(pieces(bytes(40_000), number * 3, source=JausID(2, 1, 1 + number % 3))[1], 0.0)
        assert endpoint._reassembly.memory <= 100_000
    for part in rest:
        endpoint.receive(part, 0.0)
    assert message(endpoint) == b"m" * 10_000


def test_the_number_of_sources_is_bounded() -> None:
    endpoint = Endpoint(B, first_sequence=1)
    for number in range(reassembly.MAX_SOURCES + 20):
        endpoint.receive(judp.pack(Packet(JausID(number + 1, 1, 1), B, b"", 1, data_flag=DataFlag.MIDDLE)), 0.0)
    assert endpoint.counters["dropped.large_message.no_memory"] == 20


def test_oversized_message_is_not_acknowledged(network: Any) -> None:
    network.add(A, 1, Delivery(max_message=100_000))
    network.add(B, 1, Delivery(max_message=50_000))
    ticket = network.send(A, B, bytes(60_000), Ack.REQUIRED)
    network.run(until=10.0)
    assert network.outcomes == [(ticket, False)]
    assert network.received[B] == []
    assert network.endpoints[B].counters["dropped.large_message.too_large"] == 4


def test_memory_of_acknowledged_fragments_is_not_reused() -> None:
    endpoint = Endpoint(B, first_sequence=1, delivery=Delivery(max_message=12_000, source_memory=14_000))
    first, *_ = pieces(b"a" * 10_000, 1, ack=Ack.REQUIRED)
    endpoint.receive(first, 0.0)
    for part in pieces(b"b" * 12_000, 50, ack=Ack.REQUIRED):
        endpoint.receive(part, 0.0)
    acknowledged = len(endpoint.poll_output())
    assert acknowledged < 4
    assert endpoint.counters["dropped.large_message.no_memory"] == 4 - acknowledged


@pytest.mark.slow
def test_16_mb_arrive_reliably_over_a_network_that_loses(bad_network: Any) -> None:
    allowed = Delivery(max_message=16 << 20, resends=8)
    network = bad_network(3, loss=0.02, twice=0.02, delay=0.001)
    network.add(A, 60000, allowed)
    network.add(B, 1, allowed)
    payload = network.chance.randbytes(16 << 20)
    ticket = network.send(A, B, payload, Ack.REQUIRED)
    network.run(until=100.0)
    assert network.outcomes == [(ticket, True)]
    assert network.received[B][0].payload == payload


def test_unacknowledged_large_messages_are_paced() -> None:
    endpoint = Endpoint(A, first_sequence=1)
    for _ in range(3):
        endpoint.send(B, bytes(20 * MAX_PAYLOAD), now=0.0)
    assert len(endpoint.poll_output()) == FRAGMENTS_PER_BURST
    sent = FRAGMENTS_PER_BURST
    while (at := endpoint.next_timeout()) is not None:
        endpoint.handle_timeout(at)
        burst = len(endpoint.poll_output())
        assert burst <= FRAGMENTS_PER_BURST
        sent += burst
    assert sent == 60
    assert endpoint.next_outcome() is None


def test_a_small_message_does_not_wait_for_a_large_one() -> None:
    endpoint = Endpoint(A, first_sequence=1)
    endpoint.send(B, bytes(200 * MAX_PAYLOAD), ack=Ack.REQUIRED, now=0.0)
    endpoint.poll_output()
    endpoint.send(B, b"\x06\x00\x00", now=0.0)
    assert len(endpoint.poll_output()) == 1
