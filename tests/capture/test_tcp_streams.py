"""Packets of JTCP streams: segments in any order, repeated, missing, from the middle, and bytes at random."""

import random
from collections import Counter
from itertools import pairwise

import dpkt
import pytest

from jauspy.capture.ip import DatagramAssembler
from jauspy.capture.tcp_streams import MAX_PENDING, MAX_SEGMENTS, MAX_STREAMS, TcpStreams
from jauspy.ids import JausID
from jauspy.protocol import judp
from jauspy.protocol.header import Packet

DIRECTION = (("10.0.0.1", 40000), ("10.0.0.2", 3794))
SYN, ACK, FIN = 2, 16, 1
START = (1 << 32) - 20
"""A sequence number that soon wraps around."""
DATAGRAMS = [
    judp.pack(Packet(JausID(1, 1, 1), JausID(2, 1, 1), b"\x02\x20" + bytes(number), sequence=number))
    for number in range(1, 8)
]
STREAM = b"\x02" + b"".join(datagram[1:] for datagram in DATAGRAMS)


def segments(cuts):
    """(sequence, bytes) of the stream, cut at these offsets."""
    return [((START + 1 + start) % (1 << 32), STREAM[start:end]) for start, end in pairwise([0, *cuts, len(STREAM)])]


def read(streams, parts):
    return [datagram for sequence, data in parts for datagram in streams.add(DIRECTION, sequence, ACK, data)]


def opened():
    streams = TcpStreams(Counter())
    streams.add(DIRECTION, START, SYN, b"")
    return streams


@pytest.mark.parametrize("seed", range(20))
def test_segments_in_any_order_and_repeated(seed):
    rng = random.Random(seed)
    parts = segments(sorted(rng.sample(range(1, len(STREAM)), 9)))
    parts += rng.choices(parts, k=5)
    parts.append(((START + 1 + 10) % (1 << 32), STREAM[10:60]))  # sent again with other bounds
    rng.shuffle(parts)
    assert read(opened(), parts) == DATAGRAMS


def test_a_capture_that_begins_at_a_packet():
    streams = TcpStreams(Counter())
    start = 1 + len(DATAGRAMS[0]) - 1
    assert read(streams, segments([start, start + 9])[1:]) == DATAGRAMS[1:]


def test_after_a_missing_segment_reading_goes_on():
    skipped = Counter()
    streams = TcpStreams(skipped)
    streams.add(DIRECTION, 0, SYN, b"")
    found = streams.add(DIRECTION, 1, ACK, STREAM)
    assert found == DATAGRAMS
    sequence = 1 + len(STREAM) + 100  # a hundred bytes were not captured
    packets = STREAM[1:]
    for _ in range(MAX_SEGMENTS + 2):
        found += streams.add(DIRECTION, sequence, ACK, packets)
        sequence += len(packets)
    assert skipped == {"TCP stream with a missing segment": 1}
    assert len(found) == len(DATAGRAMS) * (MAX_SEGMENTS + 3)


def test_what_is_no_stream_of_jaus_is_counted_and_bounded():
    rng, skipped = random.Random(3), Counter()
    streams = TcpStreams(skipped)
    for _ in range(3000):
        direction = ((f"10.0.0.{rng.randrange(200)}", 5), ("10.0.0.2", 3794))
        streams.add(direction, rng.getrandbits(32), rng.choice((SYN, ACK, FIN)), rng.randbytes(rng.randrange(2000)))
        assert len(streams._streams) <= MAX_STREAMS
        assert all(sum(map(len, each.pending.values())) <= MAX_PENDING + 2000 for each in streams._streams.values())
    assert skipped


def test_segments_within_ip_packets():
    tcp = dpkt.tcp.TCP(sport=40000, dport=3794, seq=5, flags=ACK, data=STREAM)
    packet = bytes(dpkt.ip.IP(src=b"\x0a\0\0\1", dst=b"\x0a\0\0\2", p=6, data=tcp))
    found = DatagramAssembler().add(packet)
    assert [udp.payload for udp in found] == DATAGRAMS
    assert found[0][:2] == DIRECTION
