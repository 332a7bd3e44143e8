"""Captures of other implementations, replayed byte for byte against `jauspy node-manager` as a process.

Ids, sizes and sequence numbers are those that were on the wire. Where this node manager does better than the one that
was captured, the difference is said.
"""

import os
import select
import socket
import struct

import pytest
from tests.node.daemon import IP_RECVTTL, TEN, TIMEOUT, Daemon, End, plain

from jauspy.ids import JausID
from jauspy.protocol.endpoint import Endpoint
from jauspy.protocol.header import Ack


def test_two_components_of_the_jaus_toolset(daemon: Daemon) -> None:
    """Management 126.1.11 and its OCU 126.1.20, from their Connects to the Cancel."""
    a, b = daemon.component(8257803, connect=False), daemon.component(8257812, connect=False)
    a.says("010000001006020100000000000b017e0000000000")
    a.hears("0100000010060202000b017e000000000000000000")
    b.says("0100000010060201000000000014017e0000000000")
    b.hears("01000000100602020014017e000000000000000000")
    for sender, text, receiver in (
        (b, "02001100010b017e0014017e000d00c80100", a),
        (a, "020011000114017e000b017e000f00000100", b),
        (b, "02001000010b017e0014017e0004000200", a),
        (b, "02001000010b017e0014017e0003000300", a),
        (b, "02001000010b017e0014017e0002200400", a),
        (a, "020015000114017e000b017e00024002000000000200", b),
        (b, "02001200010b017e0014017e00060000000500", a),
        (b, "02001200010b017e0014017e00070000000600", a),
        (b, "02001000010b017e0014017e000e000800", a),
        (a, "020011000114017e000b017e001000000400", b),
        (a, "02001000010b017e000b017e0000000600", a),
    ):
        sender.says(text)
        receiver.hears(text)
    a.says("010000001006020300000000000b017e0000000000")
    b.says("02001000010b017e0014017e0004000900")
    b.says("020010000114017e0014017e0000000a00")
    b.hears("020010000114017e0014017e0000000a00")
    a.hears_nothing()


def test_two_nodes_find_each_other(daemon: Daemon) -> None:
    """The question has control 11; the one that was captured also sets the broadcast bits, 19."""
    group, peer = daemon.group(), daemon.peer()
    near = daemon.component("100.1.2")
    near.says(f"0200180001 01016500 02016400 {TEN} 0100")
    group.hears(f"0200180011 01016500 02016400 {TEN} 0100")
    peer.says("02000e003102016400010165000100")
    near.hears("02000e003102016400010165000100")
    near.says(f"0200180001 01016500 02016400 {TEN} 0200")
    peer.hears(f"0200180001 01016500 02016400 {TEN} 0200")


def test_multicasts_may_pass_16_routers(daemon: Daemon) -> None:
    group, near = daemon.group(), daemon.component("100.1.2")
    group.socket.setsockopt(socket.IPPROTO_IP, IP_RECVTTL, 1)
    near.says(f"0200180009 ffffffff 02016400 {TEN} 0100")
    assert group.hears_ttl() == 16


def known(daemon: Daemon) -> tuple[End, End]:
    """100.1.2, and 101.1.1 elsewhere, which has been heard."""
    near, peer = daemon.component("100.1.2"), daemon.peer()
    peer.says("02000e003102016400010165000100")
    near.hears("02000e003102016400010165000100")
    return near, peer


def test_guaranteed_delivery(daemon: Daemon) -> None:
    _, peer = known(daemon)
    sender = daemon.component("100.1.3")
    sender.says(f"02001a0011 01016500 03016400 {TEN}0a0b 0100")
    peer.hears(f"02001a0011 01016500 03016400 {TEN}0a0b 0100")
    peer.says("02000e003103016400010165000100")
    sender.hears("02000e003103016400010165000100")


@pytest.mark.parametrize(("ack", "controls"), [(Ack.NONE, "41 81 c1"), (Ack.REQUIRED, "51 91 d1")])
def test_a_message_of_10000_bytes(daemon: Daemon, ack: Ack, controls: str) -> None:
    """Cut up as other stacks do, and not changed on the way."""
    _, peer = known(daemon)
    sender = daemon.component("100.1.4")
    endpoint = Endpoint(JausID.parse("100.1.4"), first_sequence=7)
    payload = bytes(number & 0xFF for number in range(10000))
    endpoint.send(JausID.parse("101.1.1"), payload, now=0.0, ack=ack)
    pieces = [piece.hex() for piece in endpoint.poll_output()]
    heads = [struct.unpack_from("<xxHB", bytes.fromhex(piece)) for piece in pieces]
    assert heads == list(zip((4093, 4093, 1856), bytes.fromhex(controls), strict=True))
    assert [piece[-4:] for piece in pieces] == ["0700", "0800", "0900"]
    assert pieces[1].startswith(plain(f"0200fd0f {controls.split()[1]} 01016500 04016400 eff0f1"))
    for piece in pieces:
        sender.says(piece)
        peer.hears(piece)


@pytest.mark.parametrize("destination", ["ffffffff", "ffff6500"])
def test_broadcasts_of_a_component(daemon: Daemon, destination: str) -> None:
    group = daemon.group()
    sender, near, far = (daemon.component(id) for id in ("100.1.6", "100.1.2", "101.1.1"))
    text = f"0200180009 {destination} 06016400 {TEN} 0100"
    sender.says(text)
    group.hears(text)
    far.hears(text)
    if destination == "ffffffff":
        near.hears(text)
    near.hears_nothing()
    sender.hears_nothing()


def test_a_broadcast_of_another_node(daemon: Daemon) -> None:
    """The one that was captured puts the component's own id in place of the wildcards; here it stays as it was sent."""
    near, peer = daemon.component("100.1.2"), daemon.peer()
    peer.says("02001000 09 ffffffff 0101c800 0a0b 0200")
    near.hears("02001000 09 ffffffff 0101c800 0a0b 0200")


def test_version_1_of_a_component(daemon: Daemon) -> None:
    _, peer = known(daemon)
    old = f"01 0000 001a 06 02 3412 01016500 08016400 0a00 0100 {TEN}"
    daemon.component("100.1.8").says(old)
    peer.hears(old)


def test_version_1_without_command_code_is_converted_to_as5669a(daemon: Daemon) -> None:
    near, peer = daemon.component("100.1.2"), daemon.peer()
    peer.says("01 0000 0012 06 02 0000 02016400 01016500 0200 0100 0220")
    near.hears("02 001000 01 02016400 01016500 0220 0100")


def test_garbage_after_a_packet_does_not_hide_it(daemon: Daemon) -> None:
    near, peer = daemon.component("100.1.2"), daemon.peer()
    peer.says("02 001000 01 02016400 0101c800 0a0b 0600 ffff")
    near.hears("02 001000 01 02016400 0101c800 0a0b 0600")


def test_a_peer_that_speaks_opc_is_answered_in_opc(daemon: Daemon) -> None:
    near, peer = daemon.component("100.1.1"), daemon.peer()
    peer.says("4a41555330312e30 06 02 3412 01016400 0101c800 0200 2300 0102")
    near.hears("01 0000 0012 06 02 3412 01016400 0101c800 0200 2300 0102")
    near.says("01 0000 0012 06 02 3412 0101c800 01016400 0200 2300 0102")
    peer.hears("4a41555330312e30 06 02 3412 0101c800 01016400 0200 2300 0102")


def test_a_heartbeat_of_jaus_ra(daemon: Daemon) -> None:
    """To all subsystems' 1.1; it reaches the components that it addresses, with the header that they can be sent."""
    near, other, peer = daemon.component("100.1.1"), daemon.component("100.1.2"), daemon.peer()
    peer.says("4a41555330312e30 06 02 0242 0101ffff 01010182 0000 75f4")
    near.hears("01 0000 0010 06 02 0242 0101ffff 01010182 0000 75f4")
    other.hears_nothing()


def test_the_capture_of_two_hosts_of_the_standard_s_own_example(daemon: Daemon) -> None:
    group, peer = daemon.group(), daemon.peer()
    ocu = daemon.component("126.1.20")
    ocu.says("02001100 01 0a017e0014017e000d00c80100")
    group.hears("02001100 11 0a017e0014017e000d00c80100")
    for text in ("02000e003114017e000a017e000100", "020011000114017e000a017e000f00000100"):
        peer.says(text)
        ocu.hears(text)
    ocu.says("02001000010a017e0014017e0002200200")
    peer.hears("02001000010a017e0014017e0002200200")
    peer.says("020015000114017e000a017e00024002000000000200")
    ocu.hears("020015000114017e000a017e00024002000000000200")


def test_two_packets_in_one_datagram(daemon: Daemon) -> None:
    near, other, peer = daemon.component("100.1.2"), daemon.component("100.1.1"), daemon.peer()
    peer.says("02 001000 01 02016400 0101c800 0a0b 0600   001100 01 01016400 0101c800 0c0d0e 0700")
    near.hears("02 001000 01 02016400 0101c800 0a0b 0600")
    other.hears("02 001100 01 01016400 0101c800 0c0d0e 0700")


def test_tcp(daemon: Daemon) -> None:
    near, stream = daemon.component("100.1.2"), daemon.stream()
    stream.says("02 001000 01 02016400 0101c800 1112 0100")
    near.hears("02 001000 01 02016400 0101c800 1112 0100")
    stream.says("001100 01 02016400 0101c800 212223 0200")
    near.hears("02 001100 01 02016400 0101c800 212223 0200")
    near.says("02 000f00 01 0101c800 02016400 31 0500")
    stream.hears_stream("02 000f00 01 0101c800 02016400 31 0500")
    near.says("02 000f00 01 0101c800 02016400 32 0600")
    stream.hears_stream("000f00 01 0101c800 02016400 32 0600")


def test_a_serial_line(daemon: Daemon) -> None:
    near = daemon.component("100.1.2")

    def line_says(text: str) -> None:
        os.write(daemon.line, bytes.fromhex(text))

    def line_tells(text: str) -> None:
        arrived = b""
        while len(arrived) < len(plain(text)) // 2:
            assert select.select([daemon.line], [], [], TIMEOUT)[0]
            arrived += os.read(daemon.line, 1)
        assert arrived.hex() == plain(text)

    line_says("10010211001002c20000110001020164000101c8000a10100b09001003a58c")
    near.hears("02 001100 01 02016400 0101c800 0a100b 0900")
    near.says("02 001200 09 ffffffff 02016400 01021003 0500")
    line_tells("1001 02 1200 1002 aa2a 00120009ffffffff02016400010210100305001003 a168")
    near.says("02 001000 01 0101c800 02016400 3132 0600")
    line_tells("1001 02 101000 1002 1a19 0010100001 0101c800 02016400 3132 0600 1003 01d9")
    near.says("01 0000 0012 06 02 3412 0101c800 02016400 0200 0700 aabb")
    line_tells("1001 01 1600 1002 aea2 00001200 06 02 3412 0101c800 02016400 0200 0700 aabb 1003 f2a7")


def test_a_component_of_ros_iop_connects_by_udp(daemon: Daemon) -> None:
    """And gets a copy of each broadcast, since it does not listen to the group."""
    component, near = daemon.peer(), daemon.component("100.1.2")
    for _ in range(2):
        component.says("010000001006020100000000000100640000000000")
        component.hears("010000001006020200010064000000000000000000")
    near.says(f"0200180005 ffffffff 02016400 {TEN} 0100")
    component.hears(f"0200180005 ffffffff 02016400 {TEN} 0100")
    component.says("02001000 01 02016400 01006400 0220 0100")
    near.hears("02001000 01 02016400 01006400 0220 0100")
    near.says("02001000 01 01006400 02016400 0240 0200")
    component.hears("02001000 01 01006400 02016400 0240 0200")


def test_priority_0_of_the_jaus_toolset_passes(daemon: Daemon) -> None:
    """Its control byte is FF: an acknowledgement, a last piece and a broadcast at once."""
    receiver, sender = daemon.component("101.1.1"), daemon.component("100.1.9")
    sender.says("02001200 ff 01016500 09016400 00010203 0100")
    receiver.hears("02001200 ff 01016500 09016400 00010203 0100")


def test_packet_that_breaks_another_node_manager_is_handled(daemon: Daemon) -> None:
    group, near = daemon.group(), daemon.component("100.1.2")
    for rubbish in ("00", "02000500 0102", "ff" * 40, "02001800 01 01016500", "02 0010" + "ff" * 5998):
        near.says(rubbish)
    near.says("02001000 01 02016400 02016400 0000 0600")
    near.hears("02001000 01 02016400 02016400 0000 0600")
    near.says(f"0200180009 ffffffff 02016400 {TEN} 0100")
    group.hears(f"0200180009 ffffffff 02016400 {TEN} 0100")
