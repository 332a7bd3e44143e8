"""JTCP and JSerial framing: bytes of other implementations, any cuts, damage and what follows it."""

import random

import pytest
from hypothesis import given, strategies as st

from jauspy.ids import JausID
from jauspy.protocol import jserial, judp
from jauspy.protocol.header import Packet
from jauspy.protocol.jserial import FrameDecoder, crc16
from jauspy.protocol.jtcp import StreamDecoder

SERIAL = {
    "doubled payload byte": (
        "10010212001002aa2a00120009ffffffff02016400010210100305001003a168",
        "0200120009ffffffff02016400010210030500",
    ),
    "doubled length": (
        "1001021010001002 1a19 0010100001 0101c800 02016400 3132 0600 1003 01d9",
        "020010000101 01c800 02016400 3132 0600",
    ),
    "version 1": (
        "10010116001002aea20000120006023412 0101c800 02016400 0200 0700 aabb 1003 f2a7",
        "010000001206023412 0101c800 02016400 0200 0700 aabb",
    ),
    "accepted elsewhere": (
        "10010211001002c20000110001020164000101c8000a10100b09001003a58c",
        "02 00110001020164000101c8000a100b0900",
    ),
}


def data(text: str) -> bytes:
    return bytes.fromhex(text)


@pytest.mark.parametrize(("wire", "datagram"), SERIAL.values(), ids=SERIAL)
def test_serial_frames_of_another_implementation_are_decoded(wire: str, datagram: str) -> None:
    assert jserial.frame(data(datagram)).hex() == data(wire).hex()
    assert FrameDecoder().feed(data(wire)) == ([data(datagram)], [])


def test_checksum_matches_known_values() -> None:
    assert crc16(b"123456789") == 0x6F91
    assert crc16(b"6789", crc16(b"12345")) == 0x6F91


def test_address_in_a_serial_frame_is_skipped() -> None:
    plain = data(SERIAL["accepted elsewhere"][0])
    assert FrameDecoder().feed(plain[:5] + b"\xaa\xbb" + plain[5:])[0] == [data(SERIAL["accepted elsewhere"][1])]


packets = st.builds(
    lambda source, payload, number: judp.pack(Packet(JausID.from_int(source), JausID(1, 1, 1), payload, number)),
    st.integers(0, 0xFFFFFFFF),
    st.lists(st.sampled_from([b"\x10", b"\x01", b"\x02", b"\x03", b"ab"]), max_size=30).map(b"".join),
    st.integers(0, 0xFFFF),
)


@pytest.mark.slow
@given(st.lists(packets, max_size=8), st.data())
def test_packets_do_not_depend_on_chunk_boundaries(datagrams: list[bytes], draw: st.DataObject) -> None:
    serial, stream_decoder = FrameDecoder(), StreamDecoder()
    for start, frame, decode in (
        (b"\x02", StreamDecoder().frame, lambda part: stream_decoder.feed(part)[0]),
        (b"noise\x10\x10\x10\x02", jserial.frame, lambda part: serial.feed(part)[0]),
    ):
        stream = start + b"".join(map(frame, datagrams))
        cuts = sorted(draw.draw(st.lists(st.integers(0, len(stream)), max_size=20)))
        parts = [stream[a:b] for a, b in zip([0, *cuts], [*cuts, len(stream)], strict=True)]
        assert [each for part in parts for each in decode(part)] == datagrams


@given(st.lists(packets, min_size=1, max_size=4), st.data())
def test_damaged_frame_affects_only_its_neighbour(datagrams: list[bytes], draw: st.DataObject) -> None:
    frames = [jserial.frame(each) for each in datagrams]
    damaged = bytearray(frames[0])
    damaged[draw.draw(st.integers(0, len(damaged) - 1))] ^= 1 << draw.draw(st.integers(0, 7))
    spare = judp.pack(Packet(JausID(9, 9, 9), JausID(1, 1, 1), b"\x10\x01", 1))
    found, _ = FrameDecoder().feed(bytes(damaged) + jserial.frame(spare) + b"".join(frames[1:]))
    assert found[-len(frames[1:]) :] == datagrams[1:] or not frames[1:]
    assert set(found) <= {spare, *datagrams}


def test_bad_checksum_is_reported_and_the_next_frame_is_valid() -> None:
    good = data(SERIAL["version 1"][0])
    bad = good[:-1] + b"\x00"
    datagrams, errors = FrameDecoder().feed(bad + good)
    assert (len(datagrams), [error.reason for error in errors]) == (1, ["serial_checksum"])


@pytest.mark.parametrize(
    ("start", "reason"),
    [
        (b"\x10\x01" + bytes(20), "serial_header"),
        (b"\x10\x01\x02\x00\x00\x10\x02" + bytes(70000), "serial_too_long"),
        (b"\x10\x01\x02\x10\x03", "serial_mark"),
        (b"\x10\x01\x02\x10\x01", "serial_unfinished"),
        (b"\x10\x01\x02\x00\x00\x10\x02\x00\x10\x03\x00\x00", "serial_header"),
    ],
)
def test_serial_garbage_is_bounded_and_reported(start: bytes, reason: str) -> None:
    decoder = FrameDecoder()
    found, errors = decoder.feed(start)
    assert (found, [error.reason for error in errors]) == ([], [reason])
    assert sum(map(len, decoder._parts)) <= jserial.MAX_BODY


def test_serial_noise_never_raises() -> None:
    chance = random.Random(1)
    decoder = FrameDecoder()
    for _ in range(200):
        decoder.feed(bytes(chance.choice(b"\x10\x01\x02\x03\x00\xff") for _ in range(50)))
    assert decoder.feed(b"\x00\x00" + data(SERIAL["version 1"][0]))[0] == [data(SERIAL["version 1"][1])]


def test_tcp_stream_of_another_implementation_is_decoded() -> None:
    stream = data("02 001000 01 02016400 0101c800 1112 0100 001100 01 02016400 0101c800 212223 0200")
    assert [datagram.hex() for datagram in StreamDecoder().feed(stream)[0]] == [
        "0200100001020164000101c80011120100",
        "0200110001020164000101c8002122230200",
    ]


RA = "06023412 02016400 0101c800 0200 0700 aabb"


@pytest.mark.parametrize("compression", ["", "0000"], ids=["as Junior sends it", "as FKIE's sends it"])
@given(st.data())
def test_version_1_streams_are_decoded_in_both_forms(compression: str, draw: st.DataObject) -> None:
    stream = data("01" + 3 * f"{compression} 0012 {RA}")
    cuts = sorted(draw.draw(st.lists(st.integers(0, len(stream)), max_size=10)))
    decoder = StreamDecoder()
    parts = [stream[a:b] for a, b in zip([0, *cuts], [*cuts, len(stream)], strict=True)]
    assert [each.hex() for part in parts for each in decoder.feed(part)[0]] == 3 * [data(f"010000 0012 {RA}").hex()]
    assert decoder.frame(data(f"010000 0012 {RA}")) == data(f"{compression} 0012 {RA}")


@pytest.mark.parametrize(
    ("stream", "reason"),
    [
        ("03000000", "stream_version"),
        ("4a415553", "stream_version"),
        ("01000f0602", "stream_lost"),
        ("01001006010000", "stream_lost"),
        ("0100000000", "stream_lost"),
        ("0105250010", "stream_lost"),
        ("02020010", "stream_lost"),
        ("02000d00", "stream_lost"),
        ("02801000", "stream_lost"),
        ("02001000010201640001 01c80011120100 02 001000", "stream_lost"),
    ],
)
def test_desynchronised_stream_is_an_error(stream: str, reason: str) -> None:
    _, error = StreamDecoder().feed(data(stream))
    assert error is not None
    assert error.reason == reason


def test_packets_before_a_desynchronisation_are_valid() -> None:
    packet = "001000 01 02016400 0101c800 1112 0100"
    datagrams, error = StreamDecoder().feed(data(f"02 {packet} {packet} 02 ffff"))
    assert (len(datagrams), error is None) == (2, False)
