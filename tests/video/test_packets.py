from __future__ import annotations

import pytest
from hypothesis import given, strategies as st

from jauspy.errors import ProtocolError
from jauspy.video import h264_payload
from jauspy.video.h264_payload import FU_A, MAX_PACKET, MAX_PICTURE_SIZE, STAP_A, Depacketiser, packetise
from jauspy.video.rtp import RtpPacket
from jauspy.video.sender import RtpStream

SPS, PPS = b"\x67\x42\xc0\x1e", b"\x68\xce\x38\x80"
IDR = b"\x65" + bytes(range(1, 251)) * 40
SLICE = b"\x41" + b"\x9a" * 300

units = st.lists(
    st.builds(
        lambda head, body: bytes([head]) + body + b"\x80", st.sampled_from([0x41, 0x65, 0x67, 0x68]), st.binary()
    ),
    min_size=1,
    max_size=12,
)


def packets(stream: RtpStream, nals: list[bytes], now: float) -> list[RtpPacket]:
    return [RtpPacket.decode(data) for data in stream.packets(packetise(nals), idr=True, now=now)]


def feed(receiver: Depacketiser, arrived: list[RtpPacket]) -> list:
    return [picture for packet in arrived for picture in receiver.feed(packet)]


def test_parameter_sets_are_aggregated_and_large_units_fragmented():
    made = packetise([SPS, PPS, IDR], 1000)
    assert made[0] == bytes([0x60 | STAP_A]) + b"\x00\x04" + SPS + b"\x00\x04" + PPS
    assert [part[0] & 0x1F for part in made[1:]] == [FU_A] * 11
    assert [part[1] >> 6 for part in made[1:]] == [2] + [0] * 9 + [1]
    assert {part[1] & 0x1F for part in made[1:]} == {h264_payload.IDR}
    assert max(map(len, made)) == 1000


@pytest.mark.slow
@given(units, st.integers(16, 200))
def test_packetised_pictures_are_reassembled(nals, limit):
    made = packetise(nals, limit)
    assert max(map(len, made)) <= limit
    receiver = Depacketiser()
    last = len(made) - 1
    found = feed(receiver, [RtpPacket(n, 9, 1, payload, marker=n == last) for n, payload in enumerate(made)])
    assert [(list(picture.nals), picture.whole) for picture in found] == [(nals, True)]


@pytest.mark.slow
@given(units)
def test_byte_stream_is_split_at_start_codes(nals):
    plain = [unit.replace(b"\x00", b"\x03") for unit in nals]  # an encoder never leaves start codes inside
    assert h264_payload.split_nals(h264_payload.join_nals(plain)) == plain


def test_packets_are_short_and_end_with_the_marker():
    made = list(RtpStream("test").packets(packetise([SPS, PPS, IDR]), idr=True, now=1.0))
    assert max(map(len, made)) <= MAX_PACKET
    assert [RtpPacket.decode(data).marker for data in made] == [False] * (len(made) - 1) + [True]


def test_time_stamps_tick_90_000_times_a_second():
    stream = RtpStream("test")
    first, second = (packets(stream, [SLICE], now)[0].timestamp for now in (10.0, 10.5))
    assert (second - first) & 0xFFFFFFFF == 45_000


def test_sequence_numbers_wrap():
    receiver = Depacketiser()
    for number in (0xFFFE, 0xFFFF, 0, 1):
        (picture,) = receiver.feed(RtpPacket(number, number, 1, SLICE, marker=True))
        assert picture.whole
    assert not receiver.counters["lost"]


@pytest.mark.parametrize("gone", range(9))
def test_lost_packet_damages_one_picture_only(gone):
    stream, receiver = RtpStream("test"), Depacketiser()
    packed = [packets(stream, [SPS, PPS, IDR], now) for now in (0.0, 1.0, 2.0)]
    del packed[1][gone]
    found = {picture.timestamp: picture.whole for picture in feed(receiver, [p for group in packed for p in group])}
    damaged = packed[1][0].timestamp
    assert found[packed[0][0].timestamp]
    assert found[damaged] is False
    assert receiver.counters["lost"] == 1
    after = found[packed[2][0].timestamp]
    assert after is (gone != len(packed[1]))  # without the marker one cannot know whose packet it was


def test_late_and_repeated_packets_are_counted_and_skipped():
    receiver = Depacketiser()
    one, two, three = (RtpPacket(n, 5, 1, SLICE, marker=n == 2) for n in range(3))
    assert feed(receiver, [one, one, three, two]) != []
    assert receiver.counters["late"] == 2
    assert receiver.counters["lost"] == 1


def test_long_gap_does_not_count_as_late():
    receiver = Depacketiser()
    feed(receiver, [RtpPacket(0, 1, 1, SLICE, marker=True)])
    (picture,) = receiver.feed(RtpPacket(0x9000, 2, 1, SLICE, marker=True))
    assert not picture.whole


def test_new_source_resets_the_state():
    receiver = Depacketiser()
    assert len(feed(receiver, [RtpPacket(n, 1, n, SLICE, marker=True) for n in (7, 3)])) == 2
    assert receiver.counters["sources"] == 2


@pytest.mark.parametrize(
    "payload",
    [
        b"\x00",
        b"\x1d\x00\x00\x00",
        bytes([STAP_A]) + b"\x00\x09\x41",
        bytes([STAP_A]) + b"\x00\x00",
        bytes([FU_A, 0x80]),
    ],
    ids=["reserved", "FU-B", "too short", "empty unit", "no fragment"],
)
def test_malformed_payloads_are_counted(payload):
    receiver = Depacketiser()
    assert [picture.nals for picture in receiver.feed(RtpPacket(0, 1, 1, payload, marker=True))] == []
    assert receiver.counters["malformed"] == 1


def test_oversized_picture_is_dropped():
    receiver = Depacketiser()
    part = bytes([FU_A, 0x05]) + bytes(60_000)
    receiver.feed(RtpPacket(0, 1, 1, bytes([FU_A, 0x85, 1])))
    for number in range(1, MAX_PICTURE_SIZE // 60_000 + 100):
        assert receiver.feed(RtpPacket(number & 0xFFFF, 1, 1, part)) == []
    assert receiver.counters["oversize"] > 0
    assert receiver._fragment is None


@given(st.binary(max_size=60))
def test_arbitrary_datagrams_do_not_break_the_receiver(data):
    receiver = Depacketiser()
    try:
        packet = RtpPacket.decode(data)
    except ProtocolError:
        return
    receiver.feed(packet)


def test_header_extensions_and_padding_are_skipped():
    head = bytes([0x80 | 0x20 | 0x10 | 1, 96]) + bytes(10)
    data = head + bytes(4) + b"\xbe\xde\x00\x01" + bytes(4) + SLICE + b"\x00\x00\x03"
    assert RtpPacket.decode(data).payload == SLICE
