"""A component's endpoint: numbering, acknowledging, and what it does not hand up."""

import pytest

from jauspy.errors import ProtocolError
from jauspy.ids import EVERYONE, JausID
from jauspy.protocol import judp
from jauspy.protocol.endpoint import MAX_QUEUED, Endpoint
from jauspy.protocol.header import Ack, Broadcast, Packet, Priority

US = JausID.parse("101.1.1")
PEER = JausID.parse("100.1.2")


def sent(endpoint: Endpoint) -> list[Packet]:
    return [packet for datagram in endpoint.poll_output() for packet in judp.unpack(datagram)]


def test_numbers_wrap() -> None:
    endpoint = Endpoint(US, first_sequence=0xFFFF)
    for _ in range(2):
        endpoint.send(PEER, b"\x02\x20", now=0.0)
    assert [packet.sequence for packet in sent(endpoint)] == [0xFFFF, 0]


def test_a_wildcard_destination_is_a_global_broadcast_without_acknowledgement() -> None:
    endpoint = Endpoint(US, first_sequence=1)
    endpoint.send(EVERYONE, b"\x00\x2b\x04", ack=Ack.REQUIRED, now=0.0)
    endpoint.send(EVERYONE, b"\x00\x2b\x04", broadcast=Broadcast.LOCAL, now=0.0)
    assert [(p.broadcast, p.ack) for p in sent(endpoint)] == [
        (Broadcast.GLOBAL, Ack.NONE),
        (Broadcast.LOCAL, Ack.NONE),
    ]


def test_requested_acks_have_the_same_number_and_priority() -> None:
    endpoint = Endpoint(US, first_sequence=1)
    endpoint.receive(judp.pack(Packet(PEER, US, bytes(10), 1, Priority.HIGH, ack=Ack.REQUIRED)), 0.0)
    assert sent(endpoint) == [Packet(US, PEER, b"", 1, Priority.HIGH, ack=Ack.ACK)]
    event = endpoint.next_event()
    assert event is not None
    assert event.payload == bytes(10)


def test_broadcasts_are_not_acknowledged() -> None:
    endpoint = Endpoint(US, first_sequence=1)
    endpoint.receive(judp.pack(Packet(PEER, EVERYONE, b"\x02\x20", ack=Ack.REQUIRED)), 0.0)
    assert sent(endpoint) == []
    assert endpoint.next_event() is not None


@pytest.mark.parametrize(
    ("datagram", "counter"),
    [
        (judp.pack(Packet(PEER, JausID.parse("102.1.1"), b"\x02\x20")), "dropped.not_for_us"),
        (judp.pack(Packet(PEER, US, b"", ack=Ack.ACK)), "received.ack_unexpected"),
        (judp.pack(Packet(PEER, US, b"", ack=Ack.NAK)), "received.nak_unexpected"),
        (judp.pack(Packet(PEER, US, b"")), "received.empty"),
        (b"\x02\x00\x05\x00\x01", "dropped.malformed.truncated"),
        (b"\x07rubbish", "dropped.malformed.version"),
    ],
)
def test_unread_messages_are_counted(datagram: bytes, counter: str) -> None:
    endpoint = Endpoint(US, first_sequence=1)
    endpoint.receive(datagram, 0.0)
    assert endpoint.next_event() is None
    assert endpoint.counters[counter] == 1


def test_queues_are_bounded() -> None:
    endpoint = Endpoint(US, first_sequence=1)
    for number in range(MAX_QUEUED + 3):
        endpoint.receive(judp.pack(Packet(PEER, US, b"\x02\x20", number)), 0.0)
        endpoint.send(PEER, b"\x02\x20", now=0.0)
    assert endpoint.counters["dropped.input_full"] == 3
    assert endpoint.counters["dropped.output_full"] == 3
    event = endpoint.next_event()
    assert event is not None
    assert event.sequence == 3


def test_oversized_message_is_rejected() -> None:
    with pytest.raises(ProtocolError, match="1048576"):
        Endpoint(US, first_sequence=1).send(PEER, bytes(1048577), now=0.0)


def test_a_broadcast_must_fit_one_packet() -> None:
    with pytest.raises(ProtocolError, match="4079"):
        Endpoint(US, first_sequence=1).send(EVERYONE, bytes(4080), now=0.0)


def test_endpoint_without_id_receives_broadcasts() -> None:
    endpoint = Endpoint(JausID(0, 0, 101), first_sequence=1)
    endpoint.receive(judp.pack(Packet(PEER, JausID(100, 255, 255), b"\x02\x20")), 0.0)
    assert endpoint.next_event() is not None
