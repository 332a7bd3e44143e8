"""The twenty checks of a new node manager, in their order, against `jauspy node-manager` as a process.

What must not arrive is found out by what is sent after it, and arrives.
"""

import time

import pytest
from tests.node.daemon import ACCEPT, CANCEL, CONNECT, TEN, Daemon, DaemonProcess, End, plain

from jauspy.transport.node_status import read_at_once

A, B = "100.1.1", "100.1.2"
TO_A, TO_B = "01016400 02016400", "02016400 01016400"
"""Destination and source, between the two."""
A_TO_ITSELF = "02001000 01 01016400 01016400 0000 0100"
MARK = f"0200180009 ffffffff 01016400 {TEN} ffff"
"""A broadcast of A."""


def marked(sender: End, *listeners: End) -> None:
    """Nothing has come to them before this."""
    sender.says(MARK)
    for each in listeners:
        each.hears(MARK)


def known_peer(daemon: Daemon, near: End) -> End:
    """101.1.1, which has written to 100.1.1."""
    peer = daemon.peer()
    peer.says("02000e0031 01016400 01016500 0100")
    near.hears("02000e0031 01016400 01016500 0100")
    return peer


def test_01_connect_twice_two_accepts(daemon: Daemon) -> None:
    component = daemon.component(A, connect=False)
    for _ in range(2):
        component.says(CONNECT.format("01016400"))
    for _ in range(2):
        component.hears(ACCEPT.format("01016400"))


def test_02_any_message_registers_its_sender(daemon: Daemon) -> None:
    a, b = daemon.component(A, connect=False), daemon.component(B)
    a.says(f"02001000 01 {TO_B} 0220 0100")
    b.hears(f"02001000 01 {TO_B} 0220 0100")
    b.says(f"02001000 01 {TO_A} 0240 0100")
    a.hears(f"02001000 01 {TO_A} 0240 0100")


def test_03_after_cancel_it_is_unknown(daemon: Daemon) -> None:
    group, a, b = daemon.group(), daemon.component(A), daemon.component(B)
    b.says(CANCEL.format("02016400"))
    b.says("02001000 01 01016400 03016400 0220 0000")  # of another id, to know that the Cancel has been read
    a.hears("02001000 01 01016400 03016400 0220 0000")
    a.says(f"02001000 01 {TO_B} 0220 0100")
    group.hears(f"02001000 11 {TO_B} 0220 0100")
    b.hears_nothing()


def test_04_unicast_to_the_own_id_is_delivered(daemon: Daemon) -> None:
    a = daemon.component(A)
    a.says(A_TO_ITSELF)
    a.hears(A_TO_ITSELF)


def test_05_a_broadcast_is_not_echoed(daemon: Daemon) -> None:
    a, b = daemon.component(A), daemon.component(B)
    marked(a, b)
    a.says(A_TO_ITSELF)
    a.hears(A_TO_ITSELF)


def test_06_unknown_destination_is_probed_once(daemon: Daemon) -> None:
    """And again each second, by the next of those that wait, should this take so long."""
    group, a = daemon.group(), daemon.component(A)
    began = time.monotonic()
    for number in range(1, 6):
        a.says(f"02001000 01 01016500 01016400 0220 0{number}00")
    a.says(MARK)
    heard = list(iter(group.next, plain(MARK)))
    assert heard[0] == plain("02001000 11 01016500 01016400 0220 0100")
    assert len(heard) <= 1 + int(time.monotonic() - began)


def test_07_after_its_ack_a_peer_gets_unicasts_at_its_port(daemon: Daemon) -> None:
    group, a, peer = daemon.group(), daemon.component(A), daemon.peer()
    a.says("02001000 01 01016500 01016400 0220 0100")
    group.hears("02001000 11 01016500 01016400 0220 0100")
    peer.says("02000e0031 01016400 01016500 0100")
    a.hears("02000e0031 01016400 01016500 0100")
    a.says("02001000 01 01016500 01016400 0220 0200")
    peer.hears("02001000 01 01016500 01016400 0220 0200")
    marked(a, group)


def test_08_local_broadcast_stays_local(daemon: Daemon) -> None:
    group, a, b = daemon.group(), daemon.component(A), daemon.component(B)
    a.says(f"0200180005 ffffffff 01016400 {TEN} 0100")
    b.hears(f"0200180005 ffffffff 01016400 {TEN} 0100")
    marked(a, group)


def test_09_all_packets_of_a_datagram_arrive(daemon: Daemon) -> None:
    a, peer = daemon.component(A), daemon.peer()
    first, second = ("001000 01 01016400 01016500 0220 0100", "001100 01 01016400 01016500 052000 0200")
    peer.says(f"02 {first} {second}")
    a.hears(f"02 {first}")
    a.hears(f"02 {second}")


def test_10_reserved_message_types_are_never_misread(daemon: Daemon) -> None:
    group, a, b = daemon.group(), daemon.component(A), daemon.component(B)
    peer = known_peer(daemon, a)
    for kind in range(1, 64):
        peer.says(f"02 {kind:02x}1000 01 01016400 01016500 0220 0100")
        b.says(f"02 {kind:02x}1000 01 {TO_A} 0220 0100")
    peer.says("02001000 01 01016400 01016500 0220 0200")
    a.hears("02001000 01 01016400 01016500 0220 0200")
    marked(a, b, group)


RUBBISH = (
    "",
    "02",
    "02000500 0102",
    "02000d00 01 01016400 01016500 00",
    "02003000 01 01016400",
    "03001000 01 01016400 01016500 0220 0100",
)


def test_11_malformed_packets_are_dropped_without_reply(daemon: Daemon) -> None:
    group, a, b = daemon.group(), daemon.component(A), daemon.component(B)
    peer = known_peer(daemon, a)
    for rubbish in RUBBISH:
        peer.says(rubbish)
        b.says(rubbish)
    peer.says("02001000 01 01016400 01016500 0220 0200")
    a.hears("02001000 01 01016400 01016500 0220 0200")
    marked(a, b, group)
    peer.hears_nothing()


def test_12_control_ff_passes(daemon: Daemon) -> None:
    a = daemon.component(A)
    peer = known_peer(daemon, a)
    a.says("02001200 ff 01016500 01016400 00010203 0100")
    peer.hears("02001200 ff 01016500 01016400 00010203 0100")
    peer.says("02001200 ff 01016400 01016500 00010203 0100")
    a.hears("02001200 ff 01016400 01016500 00010203 0100")


def test_13_the_largest_packet_both_ways(daemon: Daemon) -> None:
    a = daemon.component(A)
    peer = known_peer(daemon, a)
    for sender, ids, receiver in ((a, "01016500 01016400", peer), (peer, "01016400 01016500", a)):
        for payload in (4079, 4985, 20000):
            largest = f"02 00 {(payload + 14).to_bytes(2, 'little').hex()} 01 {ids} {'5a' * payload} 0100"
            sender.says(largest)
            receiver.hears(largest)


def test_14_component_that_does_not_read_delays_no_other(daemon: Daemon) -> None:
    a, b = daemon.component(A), daemon.component(B)
    daemon.component("100.1.3")
    for number in range(2000):
        a.says(f"02001000 01 03016400 01016400 0220 {number.to_bytes(2, 'little').hex()}")
    for number in range(200):
        text = f"02001000 01 {TO_B} 0220 {number.to_bytes(2, 'little').hex()}"
        a.says(text)
        b.hears(text)


@pytest.mark.parametrize("connects", [True, False])
def test_15_dead_component_is_removed_and_can_return(daemon: Daemon, connects: bool) -> None:
    group, a, b, other = daemon.group(), daemon.component(A), daemon.component(B), daemon.component("100.1.3")
    b.socket.close()
    a.says(f"02001000 01 {TO_B} 0220 0100")
    a.says(A_TO_ITSELF)
    a.hears(A_TO_ITSELF)
    a.says(f"02001000 01 {TO_B} 0220 0200")
    while (asked := group.next()) != plain(f"02001000 11 {TO_B} 0220 0200"):
        assert asked == plain(f"02001000 11 {TO_B} 0220 0100")  # its death was noticed before
    marked(a, other, group)
    again = daemon.component(B, connect=connects)
    if not connects:
        again.says(f"02001000 01 {TO_A} 0240 0100")
        a.hears(f"02001000 01 {TO_A} 0240 0100")
    a.says(f"02001000 01 {TO_B} 0220 0300")
    again.hears(f"02001000 01 {TO_B} 0220 0300")


@pytest.mark.slow
def test_16_components_that_send_are_registered_after_a_restart(daemon_process: DaemonProcess) -> None:
    a, b = daemon_process.component(A), daemon_process.component(B)
    daemon_process.die()
    daemon_process.start()
    a.says("02001000 05 ffffffff 01016400 0220 0100")
    b.hears("02001000 05 ffffffff 01016400 0220 0100")
    b.says(f"02001000 01 {TO_A} 0220 0200")
    a.hears(f"02001000 01 {TO_A} 0220 0200")
    a.says(f"02001000 01 {TO_B} 0240 0200")
    b.hears(f"02001000 01 {TO_B} 0240 0200")


@pytest.mark.slow
def test_silent_components_are_reachable_after_a_restart(daemon_process: DaemonProcess) -> None:
    """Of those whose sockets are there: live ones, and no other files."""
    a, b = daemon_process.component(A), daemon_process.component(B)
    dead = daemon_process.component("100.1.9")
    dead.socket.close()
    daemon_process.die()
    daemon_process.start()
    a.says(f"02001000 01 {TO_B} 0220 0100")
    b.hears(f"02001000 01 {TO_B} 0220 0100")
    a.says("02001000 01 09016400 01016400 0220 0200")  # is searched for on the network
    b.hears_nothing()
    found = {each["id"] for each in read_at_once(daemon_process.root)["components"]}
    assert found == {A, B}


def test_17_subsystems_100_and_356_are_distinguished(daemon: Daemon) -> None:
    """100.1.2 gets nothing that is for 356.1.2, 0xFF64.1.2 or 255.1.2."""
    group, a, b = daemon.group(), daemon.component(A), daemon.component(B)
    for destination in ("02016401", "020164ff", "0201ff00"):
        a.says(f"02001000 01 {destination} 01016400 0220 0100")
        group.hears(f"02001000 11 {destination} 01016400 0220 0100")
    marked(a, b)


@pytest.mark.parametrize("id", [101, 0x00640000, 0x0064FF65, 0xFFFFFF65], ids=hex)
def test_18_component_without_complete_id_gets_broadcasts(daemon: Daemon, id: int) -> None:
    a, newcomer, peer = daemon.component(A), daemon.component(id), daemon.peer()
    marked(a, newcomer)
    for destination in ("ffffffff", "ffff6400"):
        peer.says(f"0200180009 {destination} 01016500 {TEN} 0100")
        newcomer.hears(f"0200180009 {destination} 01016500 {TEN} 0100")


def test_19_a_component_may_connect_by_udp_and_gets_copies_of_broadcasts(daemon: Daemon) -> None:
    a, component, peer = daemon.component(A), daemon.peer(), daemon.peer()
    component.says(CONNECT.format("02016400"))
    component.hears(ACCEPT.format("02016400"))
    marked(a, component)
    peer.says(f"0200180009 ffffffff 01016500 {TEN} 0100")
    component.hears(f"0200180009 ffffffff 01016500 {TEN} 0100")


def test_20_version_1_with_a_command_code_is_forwarded(daemon: Daemon) -> None:
    a, b = daemon.component(A), daemon.component(B)
    old = f"01 0000 0012 06023412 {TO_B} 0200 0700 aabb"
    a.says(old)
    b.hears(old)
