"""Frames of every supported link type, padding, VLANs and fragments."""

import dpkt
import pytest

from jauspy.capture import reader
from jauspy.capture.reader import MAX_OPEN_PACKETS, DatagramAssembler

MESSAGE = bytes.fromhex("02001000010a017e0014017e0002200200")


def ip_packet(payload=MESSAGE, *, sport=3794, dport=3794, identifier=7):
    udp = dpkt.udp.UDP(sport=sport, dport=dport, data=payload)
    udp.ulen = 8 + len(payload)
    return bytes(dpkt.ip.IP(src=b"\x0a\0\0\1", dst=b"\x0a\0\0\2", p=17, id=identifier, data=udp))


def fragments(payload, size, identifier=9):
    """The IPv4 fragments (of `size` bytes each, a multiple of eight) of one UDP datagram."""
    whole = ip_packet(payload, identifier=identifier)[20:]
    pieces = []
    for offset in range(0, len(whole), size):
        header = dpkt.ip.IP(src=b"\x0a\0\0\1", dst=b"\x0a\0\0\2", p=17, id=identifier)
        header.data = whole[offset : offset + size]
        header.offset = offset // 8
        header.mf = int(offset + size < len(whole))
        header.len = 20 + len(header.data)
        pieces.append(bytes(header))
    return pieces


PACKET = ip_packet()
ETHERNET = b"\1" * 6 + b"\2" * 6


@pytest.mark.parametrize(
    ("link_type", "frame"),
    [
        (reader.ETHERNET, ETHERNET + b"\x08\x00" + PACKET),
        (reader.ETHERNET, ETHERNET + b"\x81\x00\x00\x05\x08\x00" + PACKET),
        (reader.ETHERNET, ETHERNET + b"\x88\xa8\x00\x05\x81\x00\x00\x06\x08\x00" + PACKET),
        (reader.LINUX_SLL, bytes(14) + b"\x08\x00" + PACKET),
        (reader.LINUX_SLL2, b"\x08\x00" + bytes(18) + PACKET),
        (reader.NULL, b"\2\0\0\0" + PACKET),
        (reader.LOOP, b"\0\0\0\2" + PACKET),
        (101, PACKET),
        (reader.IPV4, PACKET),
    ],
)
def test_all_link_types_give_the_same_datagram(link_type, frame):
    udp = DatagramAssembler().add(reader.ip_packet(link_type, frame))
    assert udp is not None
    assert udp.payload == MESSAGE
    assert (udp.source, udp.destination) == (("10.0.0.1", 3794), ("10.0.0.2", 3794))


@pytest.mark.parametrize(
    ("link_type", "frame"),
    [
        (reader.ETHERNET, ETHERNET + b"\x08\x06" + bytes(28)),
        (reader.ETHERNET, ETHERNET + b"\x81\x00\x00\x05"),
        (reader.ETHERNET, b""),
        (reader.LINUX_SLL2, b"\x86\xdd" + bytes(60)),
        (reader.NULL, b"\x1e\0\0\0" + bytes(60)),
    ],
)
def test_frames_without_ipv4_are_skipped(link_type, frame):
    assert reader.ip_packet(link_type, frame) is None


def test_ethernet_padding_is_removed():
    assert DatagramAssembler().add(PACKET + bytes(11)).payload == MESSAGE


def test_udp_length_is_used_if_the_ip_length_is_zero():
    """Captured before segmentation offload filled the IP length in."""
    packet = bytearray(PACKET)
    packet[2:4] = b"\0\0"
    assert DatagramAssembler().add(bytes(packet) + b"\xaa" * 5).payload == MESSAGE


@pytest.mark.parametrize("order", [(0, 1, 2), (2, 1, 0), (1, 0, 2), (0, 0, 1, 1, 2)])
def test_fragments_in_any_order_are_reassembled(order):
    payload = bytes(range(256)) * 4
    pieces = fragments(payload, 400)
    assert len(pieces) == 3
    assembler = DatagramAssembler()
    found = [udp for index in order if (udp := assembler.add(pieces[index]))]
    assert [udp.payload for udp in found] == [payload]
    assembler.finish()
    assert not assembler.skipped


def test_missing_fragment_is_counted():
    first, _, last = fragments(bytes(1000), 400)
    assembler = DatagramAssembler()
    assert assembler.add(first) is None
    assert assembler.add(last) is None
    assembler.finish()
    assert assembler.skipped == {"IP packet with missing fragments": 1}


def test_incomplete_packets_are_bounded():
    assembler = DatagramAssembler()
    for identifier in range(MAX_OPEN_PACKETS + 10):
        assembler.add(fragments(bytes(1000), 400, identifier)[0])
    assert assembler.skipped == {"IP packet with missing fragments": 10}


def test_overlapping_fragments_are_bounded():
    assembler = DatagramAssembler()
    for offset in range(100):
        header = dpkt.ip.IP(src=b"\x0a\0\0\1", dst=b"\x0a\0\0\2", p=17, id=1, data=bytes(1480))
        header.offset, header.mf, header.len = offset, 1, 1500
        assembler.add(bytes(header))
    assert assembler.skipped["malformed IP packet"] == 1


@pytest.mark.parametrize(
    ("packet", "reason"),
    [
        (b"", "not UDP over IPv4"),
        (b"\x60" + bytes(60), "not UDP over IPv4"),
        (b"\x45\x00", "malformed IP packet"),
        (PACKET[:24], "malformed UDP datagram"),
        (PACKET[:-3], "UDP datagram cut short by the capture"),
        (PACKET[:24] + b"\0\3" + PACKET[26:], "malformed UDP datagram"),
        (bytes(dpkt.ip.IP(p=6, data=bytes(20))), "not UDP over IPv4"),
    ],
)
def test_other_packets_are_counted(packet, reason):
    assembler = DatagramAssembler()
    assert assembler.add(packet) is None
    assert assembler.skipped == {reason: 1}
