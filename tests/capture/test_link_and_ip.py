"""Frames of every supported link type, padding, VLANs and fragments."""

import dpkt
import pytest

from jauspy.capture import ip as reader, writer
from jauspy.capture.ip import MAX_OPEN_PACKETS, DatagramAssembler

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
    (udp,) = DatagramAssembler().add(reader.ip_packet(link_type, frame))
    assert udp.payload == MESSAGE
    assert (udp.source, udp.destination) == (("10.0.0.1", 3794), ("10.0.0.2", 3794))


@pytest.mark.parametrize(
    ("link_type", "frame"),
    [
        (reader.ETHERNET, ETHERNET + b"\x08\x06" + bytes(28)),
        (reader.ETHERNET, ETHERNET + b"\x81\x00\x00\x05"),
        (reader.ETHERNET, b""),
        (reader.LINUX_SLL2, b"\x86\xde" + bytes(60)),
        (reader.NULL, b"\x1f\0\0\0" + bytes(60)),
    ],
)
def test_frames_without_ip_are_skipped(link_type, frame):
    assert reader.ip_packet(link_type, frame) is None


def test_ethernet_padding_is_removed():
    assert DatagramAssembler().add(PACKET + bytes(11))[0].payload == MESSAGE


def test_udp_length_is_used_if_the_ip_length_is_zero():
    """Captured before segmentation offload filled the IP length in."""
    packet = bytearray(PACKET)
    packet[2:4] = b"\0\0"
    assert DatagramAssembler().add(bytes(packet) + b"\xaa" * 5)[0].payload == MESSAGE


@pytest.mark.parametrize("order", [(0, 1, 2), (2, 1, 0), (1, 0, 2), (0, 0, 1, 1, 2)])
def test_fragments_in_any_order_are_reassembled(order):
    payload = bytes(range(256)) * 4
    pieces = fragments(payload, 400)
    assert len(pieces) == 3
    assembler = DatagramAssembler()
    found = [udp for index in order for udp in assembler.add(pieces[index])]
    assert [udp.payload for udp in found] == [payload]
    assembler.finish()
    assert not assembler.skipped


def test_missing_fragment_is_counted():
    first, _, last = fragments(bytes(1000), 400)
    assembler = DatagramAssembler()
    assert not assembler.add(first)
    assert not assembler.add(last)
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
        (b"", "neither UDP nor TCP over IP"),
        (b"\x60" + bytes(60), "neither UDP nor TCP over IP"),
        (b"\x60" + bytes(20), "malformed IP packet"),
        (b"\x45\x00", "malformed IP packet"),
        (PACKET[:24], "malformed UDP datagram"),
        (PACKET[:-3], "UDP datagram cut short by the capture"),
        (PACKET[:24] + b"\0\3" + PACKET[26:], "malformed UDP datagram"),
        (bytes(dpkt.ip.IP(p=1, data=bytes(20))), "neither UDP nor TCP over IP"),
        (bytes(dpkt.ip.IP(p=6, data=bytes(19))), "malformed TCP segment"),
        (bytes(dpkt.ip.IP(p=6, data=bytes(12) + b"\x50" + bytes(7))), "other TCP port than 3794"),
    ],
)
def test_other_packets_are_counted(packet, reason):
    assembler = DatagramAssembler()
    assert not assembler.add(packet)
    assert assembler.skipped == {reason: 1}


V6 = bytes.fromhex("fd00000000000000000000000000000a"), bytes.fromhex("fd00000000000000000000000000000b")


def ipv6_packet(data, *, protocol=17, extensions=b""):
    return (
        b"\x60\0\0\0"
        + (len(extensions) + len(data)).to_bytes(2, "big")
        + bytes([protocol, 64])
        + b"".join((*V6, extensions, data))
    )


UDP_BYTES = PACKET[20:]


@pytest.mark.parametrize(
    ("link_type", "frame"),
    [
        (reader.ETHERNET, ETHERNET + b"\x86\xdd" + ipv6_packet(UDP_BYTES)),
        (reader.LINUX_SLL2, b"\x86\xdd" + bytes(18) + ipv6_packet(UDP_BYTES)),
        (reader.NULL, b"\x1e\0\0\0" + ipv6_packet(UDP_BYTES)),
        (reader.IPV6, ipv6_packet(UDP_BYTES, protocol=0, extensions=b"\x3c\0" + bytes(6) + b"\x11\1" + bytes(14))),
    ],
)
def test_ipv6_gives_the_datagram(link_type, frame):
    (udp,) = DatagramAssembler().add(reader.ip_packet(link_type, frame))
    assert udp == (("fd00::a", 3794), ("fd00::b", 3794), MESSAGE)


@pytest.mark.parametrize("order", [(0, 1, 2), (2, 0, 1)])
def test_fragments_of_ipv6_are_reassembled(order):
    payload = bytes(range(256)) * 4
    whole = ip_packet(payload)[20:]
    pieces = [
        ipv6_packet(
            whole[offset : offset + 400],
            protocol=44,
            extensions=b"\x11\0" + (offset | (offset + 400 < len(whole))).to_bytes(2, "big") + b"\0\0\0\7",
        )
        for offset in range(0, len(whole), 400)
    ]
    assembler = DatagramAssembler()
    found = [udp.payload for index in order for udp in assembler.add(pieces[index])]
    assert found == [payload]


def test_written_ipv6_packets_are_read_again():
    for payload in (MESSAGE, MESSAGE + b"\1"):
        packet = writer.ip_packet(("fd00::a", 3794), ("fd00::b", 5000), payload)
        assert DatagramAssembler().add(packet) == ((("fd00::a", 3794), ("fd00::b", 5000), payload),)
        assert dpkt.ip6.IP6(packet).data.sum == _checksum(packet)


def _checksum(packet):
    """The checksum that dpkt computes."""
    ip6 = dpkt.ip6.IP6(packet)
    ip6.data.sum = 0
    return dpkt.ip6.IP6(bytes(ip6)).data.sum
