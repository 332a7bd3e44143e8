"""Capture files: formats, ports, damage."""

import io
import struct
import tracemalloc

import dpkt
import pytest

from jauspy.capture.reader import CaptureReader, from_hex, from_lines, is_capture
from jauspy.errors import ConfigError

MESSAGE = bytes.fromhex("02001000010a017e0014017e0002200200")


def frame(payload=MESSAGE, sport=3794, dport=3794):
    udp = dpkt.udp.UDP(sport=sport, dport=dport, data=payload)
    udp.ulen = 8 + len(payload)
    packet = dpkt.ip.IP(src=b"\x0a\0\0\1", dst=b"\x0a\0\0\2", p=17, data=udp)
    return (bytes(dpkt.ethernet.Ethernet(data=packet, type=0x0800))).ljust(60, b"\0")


def capture_file(frames, writer=dpkt.pcap.Writer, **options):
    file = io.BytesIO()
    recorder = writer(file, **options)
    for number, data in enumerate(frames):
        recorder.writepkt(data, ts=1000.0 + number / 4)
    return file.getvalue()


def read(data, **options):
    reader = CaptureReader(io.BufferedReader(io.BytesIO(data)), name="x.pcap", **options)
    return list(reader), reader.skipped


@pytest.mark.parametrize("writer", [dpkt.pcap.Writer, dpkt.pcapng.Writer])
def test_pcap_and_pcapng_are_read(writer):
    data = capture_file([frame(), frame(dport=4000)], writer)
    assert is_capture(data)
    found, skipped = read(data)
    assert [(d.number, d.time, d.payload) for d in found] == [(1, 1000.0, MESSAGE), (2, 1000.25, MESSAGE)]
    assert found[1].destination == ("10.0.0.2", 4000)
    assert not skipped


def test_nanosecond_timestamps_are_read():
    found, _ = read(capture_file([frame()], nano=True))
    assert found[0].time == 1000.0


def test_port_filter():
    data = capture_file([frame(sport=5000, dport=5001), frame()])
    found, skipped = read(data)
    assert [d.number for d in found] == [2]
    assert skipped == {"other UDP port than 3794": 1}
    assert [d.number for d in read(data, port=5001)[0]] == [1]
    assert [d.number for d in read(data, port=None)[0]] == [1, 2]


def pcapng_block(order, kind, body):
    length = 12 + len(body)
    return struct.pack(order + "II", kind, length) + body + struct.pack(order + "I", length)


def pcapng(order="<", options=b"", packets=()):
    """A file of blocks that are packed here; `packets` are pairs of a block type and ticks."""
    section = pcapng_block(order, 0x0A0D0D0A, struct.pack(order + "IHHq", 0x1A2B3C4D, 1, 0, -1))
    interface = pcapng_block(order, 1, struct.pack(order + "HHI", 1, 0, 0) + options)
    data = frame()
    head = {kind: struct.pack(order + ("I" if kind == 6 else "HH"), *(0,) * (1 if kind == 6 else 2)) for kind in (2, 6)}
    blocks = [
        pcapng_block(
            order,
            kind,
            head[kind] + struct.pack(order + "IIII", ticks >> 32, ticks & 0xFFFFFFFF, len(data), len(data)) + data,
        )
        for kind, ticks in packets
    ]
    return section + interface + b"".join(blocks)


@pytest.mark.parametrize("order", ["<", ">"])
@pytest.mark.parametrize(
    ("code", "value", "ticks"),
    [(9, b"\x09", 1e9), (9, b"\x8a", 1024.0), (9, b"\x06", 1e6), (14, 100, 1e6)],
    ids=["nanoseconds", "1/1024 s", "microseconds", "offset"],
)
def test_times_of_pcapng_are_those_that_dpkt_finds(order, code, value, ticks):
    value = struct.pack(order + "q", value) if code == 14 else value
    options = struct.pack(order + "HH", code, len(value)) + value + bytes(-len(value) % 4) + bytes(4)
    data = pcapng(order, options, [(6, 5_000_000_123), (2, 7)])
    found, _ = read(data)
    offset = 100 if code == 14 else 0
    assert [datagram.time for datagram in found] == [offset + 5_000_000_123 / ticks, offset + 7 / ticks]
    assert [datagram.time for datagram in found] == [time for time, _ in dpkt.pcapng.Reader(io.BytesIO(data))]
    assert [datagram.payload for datagram in found] == [MESSAGE] * 2


def test_blocks_without_packets_are_passed_over():
    found, _ = read(pcapng() + pcapng_block("<", 5, bytes(8)) + pcapng(packets=[(6, 1)]).removeprefix(pcapng()))
    assert [datagram.payload for datagram in found] == [MESSAGE]


@pytest.mark.parametrize(
    "damaged",
    [
        struct.pack("<II", 6, 8),
        struct.pack("<II", 6, 30) + bytes(22),
        struct.pack("<II", 6, 0xFFFFFFF0) + bytes(64),
        struct.pack("<II", 5, 16) + bytes(4) + struct.pack("<I", 20),
        pcapng_block("<", 6, struct.pack("<IIIII", 0, 0, 0, 1000, 1000) + bytes(16)),
        pcapng_block("<", 6, bytes(8)),
    ],
    ids=["too short", "not aligned", "huge", "another length at the end", "packet longer than its block", "no header"],
)
def test_a_damaged_block_of_pcapng_is_an_error(damaged):
    with pytest.raises(ConfigError, match=r"x\.pcap is damaged or cut off after frame 1"):
        read(pcapng(packets=[(6, 1)]) + damaged)


def interface(link_type, resolution, order="<"):
    options = struct.pack(order + "HHB3xHH", 9, 1, resolution, 0, 0)
    return pcapng_block(order, 1, struct.pack(order + "HHI", link_type, 0, 0) + options)


def packet_of(number, ticks, data, order="<"):
    head = struct.pack(order + "IIIII", number, ticks >> 32, ticks & 0xFFFFFFFF, len(data), len(data))
    return pcapng_block(order, 6, head + data + bytes(-len(data) % 4))


def test_each_packet_has_the_link_type_and_the_times_of_its_interface():
    """As Wireshark writes when it captures from several interfaces, and `mergecap` for several files."""
    ip = frame()[14:]
    whole = pcapng() + interface(101, 9) + interface(195, 6)
    whole += packet_of(1, 3_000_000_000, ip) + packet_of(0, 4_000_000, frame()) + packet_of(2, 1, b"of ZigBee")
    found, skipped = read(whole)
    assert [(datagram.number, datagram.time, datagram.payload) for datagram in found] == [
        (1, 3.0, MESSAGE),
        (2, 4.0, MESSAGE),
    ]
    assert skipped == {"link type 195, which is not supported": 1}


def test_sections_follow_each_other_in_any_byte_order():
    """As `cat` makes of two captures."""
    whole = pcapng(packets=[(6, 1_000_000)]) + pcapng(">", packets=[(2, 2_000_000)]) + pcapng(packets=[(6, 3_000_000)])
    assert [datagram.time for datagram in read(whole)[0]] == [1.0, 2.0, 3.0]


@pytest.mark.parametrize(
    "hostile",
    [
        packet_of(1, 1, frame()),
        packet_of(0xFFFFFFFF, 1, frame()),
        packet_of(0, 0xFFFFFFFF_FFFFFFFF, frame()),
        pcapng_block("<", 1, struct.pack("<HHIHHq", 1, 0, 0, 14, 8, -(1 << 62))) + packet_of(1, 1, frame()),
        pcapng_block("<", 1, struct.pack("<HHIHHq", 1, 0, 0, 14, 8, 1 << 62)) + packet_of(1, 1, frame()),
        interface(1, 6) * 2000,
        pcapng_block("<", 0x0A0D0D0A, bytes(16)),
        pcapng_block("<", 0x0A0D0D0A, struct.pack("<IHHq", 0x1A2B3C4D, 1, 0, -1)) + packet_of(0, 1, frame()),
    ],
    ids=["no such interface", "far interface", "late", "before 1970", "far future", "many", "no order", "no interface"],
)
def test_what_a_hostile_pcapng_claims_is_damage(hostile):
    with pytest.raises(ConfigError, match=r"x\.pcap is damaged or cut off after frame 1"):
        read(pcapng(packets=[(6, 1)]) + hostile)


def test_sizes_that_a_hostile_pcap_claims_take_no_memory():
    whole = bytearray(capture_file([frame(), frame()]))
    whole[24 + 16 + 60 + 8 : 24 + 16 + 60 + 12] = b"\xf0\xff\xff\xff"
    tracemalloc.start()
    try:
        with pytest.raises(ConfigError, match=r"x\.pcap is damaged or cut off after frame 1"):
            read(bytes(whole))
        assert tracemalloc.get_traced_memory()[1] < 10 << 20
    finally:
        tracemalloc.stop()


def test_bits_for_checksums_are_no_link_type():
    data = bytearray(capture_file([frame()]))
    data[20:24] = struct.pack(">I" if data[0] == 0xA1 else "<I", 0x54000001)
    assert [datagram.payload for datagram in read(bytes(data))[0]] == [MESSAGE]


@pytest.mark.parametrize("writer", [dpkt.pcap.Writer, dpkt.pcapng.Writer])
def test_truncated_file_raises_an_error(writer):
    whole = capture_file([frame(), frame()], writer)
    ends = [len(capture_file([frame()] * count, writer)) for count in range(3)]
    for length in range(4, len(whole) + 1):
        found = []
        try:
            reader = CaptureReader(io.BufferedReader(io.BytesIO(whole[:length])), name="x.pcap")
            found.extend(reader)
            assert length in ends
            assert len(found) == ends.index(length)
        except ConfigError as error:
            assert str(error).startswith("x.pcap is ")  # noqa: PT017 - most lengths are an error, not all
            assert length not in ends
        assert all(datagram.payload == MESSAGE for datagram in found)


def test_truncated_record_header_error_names_the_offset():
    reader = CaptureReader(io.BufferedReader(io.BytesIO(capture_file([frame(), frame()])[:-70])), name="x.pcap")
    found = []
    with pytest.raises(ConfigError, match=r"x\.pcap is damaged or cut off after frame 1"):
        found.extend(reader)
    assert [datagram.number for datagram in found] == [1]


def test_garbage_is_not_recognised_as_capture():
    assert not is_capture(b"")
    assert not is_capture(b"020011")
    with pytest.raises(ConfigError, match=r"x\.pcap is not a readable"):
        read(b"\xa1\xb2\xc3\xd4\x00")


def test_unknown_link_type_error_lists_the_known_ones():
    data = bytearray(capture_file([frame()]))
    data[20:24] = struct.pack(">I" if data[0] == 0xA1 else "<I", 105)
    with pytest.raises(ConfigError, match=r"link type 105 is not supported.*Ethernet"):
        read(bytes(data))


@pytest.mark.parametrize("text", ["02001f", "02 00 1F", "02:00:1f", "0x02001f", "0x02, 0x00, 0x1f", "02-00-1f\n"])
def test_all_forms_of_hex_are_parsed(text):
    assert from_hex(text) == b"\x02\x00\x1f"


def test_zero_before_x_inside_a_number_is_a_digit():
    with pytest.raises(ConfigError, match="'x'"):
        from_hex("020x1f")


@pytest.mark.parametrize(("text", "what"), [("020", "odd number"), ("0g", "'g'"), (" ", "no hexadecimal digits")])
def test_invalid_hex_raises_a_config_error(text, what):
    with pytest.raises(ConfigError, match=what):
        from_hex(text)


def test_line_numbers_are_kept():
    assert from_lines("# capture\n\n02 00\n  # x\n0003 # y\n") == [(3, b"\2\0"), (5, b"\0\3")]


def test_invalid_line_is_named():
    with pytest.raises(ConfigError, match="line 2"):
        from_lines("02\n0z\n")
