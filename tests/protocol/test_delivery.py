"""Reliable delivery between endpoints, on a virtual clock and a network with faults."""

from collections.abc import Callable
from typing import Any

import pytest
from hypothesis import given, settings, strategies as st

from jauspy.errors import ConfigError, ProtocolError
from jauspy.ids import EVERYONE, JausID
from jauspy.protocol import delivery as transfers, judp
from jauspy.protocol.delivery import MAX_MESSAGE_SIZE, Delivery
from jauspy.protocol.endpoint import MAX_QUEUED, Endpoint
from jauspy.protocol.header import MAX_PAYLOAD, Ack, DataFlag, Packet

A, B = JausID.parse("100.1.2"), JausID.parse("101.1.1")
FAR = JausID.parse("102.1.1")
QUERY = b"\x02\x20"


def pair(network: Any, delivery: Delivery | None = None) -> Any:
    network.add(A, 65500, delivery)
    network.add(B, 7, delivery)
    return network


def test_lost_packet_is_resent_with_its_number_after_100_ms(network: Any) -> None:
    pair(network)
    network.lose = lambda _: network.now < 0.15
    ticket = network.send(A, B, QUERY, Ack.REQUIRED)
    network.run(until=0.099)
    assert len(network.sent) == 1
    network.run(until=1.0)
    tries = [data for data in network.sent if judp.unpack(data)[0].source == A]
    assert tries == [tries[0]] * 3
    assert network.outcomes == [(ticket, True)]
    assert [packet.payload for packet in network.received[B]] == [QUERY]


def test_failure_is_reported_after_three_resends(network: Any) -> None:
    pair(network)
    network.lose = lambda _: True
    ticket = network.send(A, B, QUERY, Ack.REQUIRED)
    network.run(until=0.399)
    assert network.outcomes == []
    network.run(until=0.5)
    assert network.outcomes == [(ticket, False)]
    assert len(network.sent) == 4
    assert network.endpoints[A].counters["undelivered"] == 1
    assert network.endpoints[A].next_timeout() is None


def test_lost_ack_causes_no_second_message(network: Any) -> None:
    pair(network)
    network.lose = lambda data: judp.unpack(data)[0].ack is Ack.ACK and network.now < 0.25
    ticket = network.send(A, B, QUERY, Ack.REQUIRED)
    network.run(until=1.0)
    assert network.outcomes == [(ticket, True)]
    assert len(network.received[B]) == 1
    assert network.endpoints[B].counters["dropped.duplicate"] == 3
    assert network.endpoints[B].counters["sent.ack"] == 4


def test_nak_causes_an_immediate_resend() -> None:
    endpoint = Endpoint(A, first_sequence=9)
    endpoint.send(B, QUERY, ack=Ack.REQUIRED, now=0.0)
    (first,) = endpoint.poll_output()
    nak = judp.pack(Packet(B, A, b"", 9, ack=Ack.NAK))
    for _ in range(3):
        endpoint.receive(nak, 0.01)
        assert endpoint.poll_output() == [first]
    endpoint.receive(nak, 0.02)
    assert endpoint.poll_output() == []
    assert endpoint.next_outcome() == (1, False, B)


def test_ack_with_other_source_or_number_is_ignored() -> None:
    endpoint = Endpoint(A, first_sequence=9)
    endpoint.send(B, QUERY, ack=Ack.REQUIRED, now=0.0)
    for packet in (Packet(FAR, A, b"", 9, ack=Ack.ACK), Packet(B, A, b"", 10, ack=Ack.ACK)):
        endpoint.receive(judp.pack(packet), 0.01)
    assert endpoint.next_outcome() is None
    endpoint.receive(judp.pack(Packet(B, A, b"", 9, ack=Ack.ACK)), 0.01)
    assert endpoint.next_outcome() == (1, True, None)


def test_broadcasts_request_no_ack_and_have_no_ticket() -> None:
    endpoint = Endpoint(A, first_sequence=9)
    assert endpoint.send(EVERYONE, QUERY, ack=Ack.REQUIRED, now=0.0) is None
    assert endpoint.next_timeout() is None


def test_pending_messages_are_bounded() -> None:
    endpoint = Endpoint(A, first_sequence=9)
    for _ in range(transfers.MAX_TRANSFERS):
        endpoint.send(B, QUERY, ack=Ack.REQUIRED, now=0.0)
    with pytest.raises(ProtocolError, match="too_much_under_way"):
        endpoint.send(B, QUERY, ack=Ack.REQUIRED, now=0.0)
    endpoint.send(B, QUERY, now=0.0)


def test_full_component_does_not_acknowledge() -> None:
    endpoint = Endpoint(B, first_sequence=9)
    for number in range(MAX_QUEUED):
        endpoint.receive(judp.pack(Packet(A, B, QUERY, number)), 0.0)
    wanted = judp.pack(Packet(A, B, b"\x05\x20", MAX_QUEUED, ack=Ack.REQUIRED))
    endpoint.receive(wanted, 0.0)
    assert endpoint.poll_output() == []
    assert endpoint.counters["dropped.input_full_not_acknowledged"] == 1
    endpoint.next_event()
    endpoint.receive(wanted, 0.1)
    assert len(endpoint.poll_output()) == 1


@pytest.mark.parametrize("ack", [Ack.NONE, Ack.REQUIRED])
def test_restarted_peer_is_received_from_its_first_message(network: Any, ack: Ack) -> None:
    """The widespread node manager's library drops these as duplicates, and acknowledges them."""
    pair(network)
    conversation = [bytes([0x0D, 0, number]) for number in range(20)]
    for life in range(3):
        network.add(A, first_sequence=1)
        for message in conversation[life:]:
            network.send(A, B, message, ack)
            network.run(until=network.now + 0.02)
    assert [each.payload for each in network.received[B]] == conversation + conversation[1:] + conversation[2:]


def test_equal_messages_with_different_numbers_are_all_received(network: Any) -> None:
    pair(network)
    for _ in range(100):
        network.send(A, B, QUERY)
    network.run(until=1.0)
    assert len(network.received[B]) == 100


def test_network_duplicates_arrive_once(bad_network: Callable[..., Any]) -> None:
    network = pair(bad_network(twice=1.0))
    network.send(A, B, QUERY)
    network.send(A, B, bytes(MAX_PAYLOAD + 1))
    network.run(until=1.0)
    assert sorted(len(each.payload) for each in network.received[B]) == [2, MAX_PAYLOAD + 1]


def test_small_messages_that_overtake_a_large_one_arrive_once(network: Any) -> None:
    pair(network)
    network.lose = lambda data: judp.unpack(data)[0].ack is Ack.ACK and 0.02 < network.now < 0.2
    network.send(A, B, bytes(600 * MAX_PAYLOAD >> 3))
    network.send(A, B, bytes(600 * MAX_PAYLOAD >> 3))
    for number in range(20):
        network.send(A, B, bytes([0x0D, 0, number]), Ack.REQUIRED)
        network.run(until=network.now + 0.003)
    network.run(until=5.0)
    small = [packet.payload for packet in network.received[B] if len(packet.payload) == 3]
    assert sorted(small) == [bytes([0x0D, 0, number]) for number in range(20)]
    assert len(network.received[B]) == 22
    assert network.endpoints[B].counters["dropped.duplicate"] > 0


def test_equal_packets_of_subsystems_100_and_356_are_distinct() -> None:
    """Their ids differ in one byte only, which is not looked at everywhere."""
    endpoint = Endpoint(B, first_sequence=1)
    for subsystem in (100, 356):
        packet = Packet(JausID(subsystem, 1, 2), B, b"\x02\x20", 7, ack=Ack.REQUIRED)
        endpoint.receive(judp.pack(packet), 0.0)
        assert endpoint.next_event() == packet


def test_peer_without_sequence_numbers_is_received() -> None:
    endpoint = Endpoint(B, first_sequence=9)
    for step in range(10):
        endpoint.receive(judp.pack(Packet(A, B, QUERY, 0)), step / 10)
        assert endpoint.next_event() is not None


@settings(max_examples=40, deadline=None)
@given(
    seed=st.integers(0, 1 << 32),
    loss=st.floats(0, 0.4),
    twice=st.floats(0, 0.5),
    delay=st.floats(0.0005, 0.15),
    sizes=st.lists(st.integers(2, 5 * MAX_PAYLOAD), min_size=1, max_size=12),
)
def test_messages_arrive_at_most_once_and_outcomes_are_right(
    bad_network: Callable[..., Any], *, seed: int, loss: float, twice: float, delay: float, sizes: list[int]
) -> None:
    network = pair(bad_network(seed, loss=loss, twice=twice, delay=delay))
    messages = [bytes([0, 0x40, number]) + network.chance.randbytes(size) for number, size in enumerate(sizes)]
    tickets = [network.send(A, B, message, Ack.REQUIRED) for message in messages]
    network.run(until=60.0)
    received = [packet.payload for packet in network.received[B]]
    assert len(set(received)) == len(received)
    assert set(received) <= set(messages)
    assert {ticket for ticket, _ in network.outcomes} == set(tickets)
    for ticket, delivered in network.outcomes:
        if delivered:
            assert messages[tickets.index(ticket)] in received
    for endpoint in network.endpoints.values():
        assert endpoint.next_timeout() is None


@settings(max_examples=20, deadline=None)
@given(st.integers(0, 1 << 32), st.lists(st.integers(2, 3 * MAX_PAYLOAD), min_size=1, max_size=10))
def test_all_messages_arrive_in_any_order_without_loss(
    bad_network: Callable[..., Any], seed: int, sizes: list[int]
) -> None:
    network = pair(bad_network(seed, twice=0.3, delay=0.004))
    messages = [bytes([0, 0x40, number]) + network.chance.randbytes(size) for number, size in enumerate(sizes)]
    for message in messages:
        network.send(A, B, message)
    network.run(until=30.0)
    assert sorted(packet.payload for packet in network.received[B]) == sorted(messages)
    assert all(packet.data_flag is DataFlag.SINGLE for packet in network.received[B])


@pytest.mark.parametrize(
    "wrong",
    [
        {"ack_timeout": 0},
        {"resends": -1},
        {"window": 0},
        {"max_message": MAX_MESSAGE_SIZE + 1},
        {"fragment_timeout": -1},
    ],
)
def test_invalid_settings_are_rejected(wrong: dict[str, Any]) -> None:
    with pytest.raises(ConfigError, match="delivery"):
        Delivery(**wrong)
