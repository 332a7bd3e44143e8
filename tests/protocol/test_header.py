"""Bytes of the transport header, against packets seen on real networks."""

import pytest
from hypothesis import given, strategies as st

from jauspy.errors import ProtocolError
from jauspy.ids import JausID, message_id
from jauspy.protocol import header, judp
from jauspy.protocol.header import Ack, Broadcast, DataFlag, Packet, Priority

A = JausID.parse("126.1.11")
B = JausID.parse("126.1.20")
EVERYONE = JausID.parse("65535.255.255")

SEEN = [
    # request control, authority C8, from an OCU to a component, through a node manager
    ("02001100010b017e0014017e000d00c80100", Packet(B, A, bytes.fromhex("0d00c8"), 1)),
    ("02001000010b017e0014017e0004000200", Packet(B, A, bytes.fromhex("0400"), 2)),
    ("020015000114017e000b017e00024002000000000200", Packet(A, B, bytes.fromhex("02400200000000"), 2)),
    # unknown destination: multicast, broadcast flag 2, acknowledgement wanted
    (
        "02001800190101650002016400000102030405060708090100",
        Packet(
            JausID.parse("100.1.2"),
            JausID.parse("101.1.1"),
            bytes(range(10)),
            1,
            broadcast=Broadcast.GLOBAL,
            ack=Ack.REQUIRED,
        ),
    ),
    # its acknowledgement
    ("02000e003102016400010165000100", Packet(JausID.parse("101.1.1"), JausID.parse("100.1.2"), b"", 1, ack=Ack.ACK)),
    (
        "0200180009ffffffff06016400000102030405060708090100",
        Packet(JausID.parse("100.1.6"), EVERYONE, bytes(range(10)), 1, broadcast=Broadcast.GLOBAL),
    ),
]


@pytest.mark.parametrize(("text", "packet"), SEEN)
def test_captured_packets_are_parsed(text: str, packet: Packet) -> None:
    assert judp.unpack(bytes.fromhex(text)) == [packet]
    assert judp.pack(packet).hex() == text


def test_packed_datagram_gives_all_packets() -> None:
    data = bytes.fromhex("0200100001020164000101c8000a0b060000110001010164000101c8000c0d0e0700")
    assert [(str(p.destination), p.payload.hex(), p.sequence) for p in judp.unpack(data)] == [
        ("100.1.2", "0a0b", 6),
        ("100.1.1", "0c0d0e", 7),
    ]


def test_garbage_after_a_packet_does_not_hide_it() -> None:
    packets, errors = judp.unpack_all(bytes.fromhex(SEEN[0][0]) + b"\0\1\2")
    assert packets == [SEEN[0][1]]
    assert [error.reason for error in errors] == ["truncated"]


def test_control_byte_ff_is_accepted() -> None:
    (packet,) = judp.unpack(bytes.fromhex("02001200ff0101650009016400000102030100"))
    assert (packet.priority, packet.broadcast, packet.ack, packet.data_flag) == (
        Priority.SAFETY_CRITICAL,
        Broadcast.RESERVED,
        Ack.ACK,
        DataFlag.LAST,
    )
    assert packet.payload.hex() == "00010203"


def test_proposal_of_compression_is_skipped() -> None:
    plain = bytes.fromhex(SEEN[1][0])
    size = (int.from_bytes(plain[2:4], "little") + 2).to_bytes(2, "little")
    proposed = plain[:1] + b"\x40" + size + b"\x07\x0c" + plain[4:]
    assert judp.unpack(proposed) == [SEEN[1][1]]


@pytest.mark.parametrize(
    ("data", "reason"),
    [
        ("", "empty"),
        ("02", "empty"),
        ("03" + SEEN[1][0][2:], "version"),
        ("01" + SEEN[1][0][2:], "version"),
        ("02000500010203", "truncated"),
        (SEEN[1][0][:-2], "truncated"),
        ("02000d0001" + "00" * 20, "size"),
        ("0201100001" + "00" * 20, "message_type"),
        ("0280100001" + "00" * 20, "compressed"),
        ("02c0100001" + "00" * 20, "compressed"),
        ("02400f0001" + "00" * 20, "size"),
    ],
)
def test_malformed_datagrams_have_a_reason(data: str, reason: str) -> None:
    with pytest.raises(ProtocolError) as caught:
        judp.unpack(bytes.fromhex(data))
    assert caught.value.reason == reason


ids = st.integers(0, 0xFFFFFFFF).map(JausID.from_int)
packets = st.builds(
    Packet,
    ids,
    ids,
    st.binary(max_size=200),
    st.integers(0, 0xFFFF),
    st.sampled_from(Priority),
    st.sampled_from(Broadcast),
    st.sampled_from(Ack),
    st.sampled_from(DataFlag),
)


@given(packets)
def test_round_trip(packet: Packet) -> None:
    assert judp.unpack(judp.pack(packet)) == [packet]


@given(st.binary(max_size=100))
def test_arbitrary_bytes_raise_protocol_errors_only(data: bytes) -> None:
    found, errors = judp.unpack_all(data)
    assert found or errors


@given(packets, st.integers(0, 100))
def test_all_truncations_are_detected(packet: Packet, cut: int) -> None:
    data = judp.pack(packet)
    found, errors = judp.unpack_all(data[: max(0, len(data) - 1 - cut)])
    assert not found
    assert errors


def test_oversized_payload_is_rejected() -> None:
    with pytest.raises(ProtocolError, match="65530 bytes"):
        header.pack(Packet(A, B, bytes(65530)))


@given(packets, st.integers(0, 300))
def test_code_of_a_broadcast_is_that_of_its_packet(packet: Packet, cut: int) -> None:
    is_plain = packet.ack is Ack.NONE and packet.data_flag is DataFlag.SINGLE and len(packet.payload) >= 2
    expected = message_id(packet.payload) if is_plain and packet.broadcast is not Broadcast.NONE else None
    datagram = judp.pack(packet)
    assert header.broadcast_code(datagram) == expected
    assert header.broadcast_code(datagram * 2) is None
    assert header.broadcast_code(datagram + datagram[1:]) is None
    assert header.broadcast_code(datagram[: cut % len(datagram)]) is None


@given(st.binary(max_size=40))
def test_code_of_a_broadcast_is_found_in_any_bytes(data: bytes) -> None:
    header.broadcast_code(data)
