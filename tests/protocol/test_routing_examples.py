"""Routing of packets as they were seen on real networks, byte for byte, and of what faulty peers send."""

import pytest

from jauspy.ids import JausID
from jauspy.protocol import junior
from jauspy.protocol.addressing import GROUP, LocalPort, Port, UdpPort
from jauspy.protocol.routing import Router

SENDER, FAR = JausID.parse("100.1.2"), JausID.parse("101.1.1")
SENDER_PORT, OTHER_PORT = LocalPort("/root/sender"), LocalPort("/root/other")
PEER = UdpPort("10.77.0.2", 3794)


def receive(core: Router, text: str, source: Port) -> list[tuple[Port, str]]:
    core.receive(bytes.fromhex(text), source, 0.0)
    return [(port, data.hex()) for port, data in core.poll_output()]


@pytest.fixture
def node() -> Router:
    core = Router("/root")
    core.receive(junior.connect(SENDER), SENDER_PORT, 0.0)
    core.poll_output()
    return core


def test_two_nodes_discover_addresses_by_an_ack(node: Router) -> None:
    plain = "02001800010101650002016400000102030405060708090100"
    asking = "02001800110101650002016400000102030405060708090100"
    ack = "02000e003102016400010165000100"
    second = "02001800010101650002016400000102030405060708090200"
    assert receive(node, plain, SENDER_PORT) == [(GROUP, asking)]
    assert receive(node, ack, PEER) == [(SENDER_PORT, ack)]
    assert receive(node, second, SENDER_PORT) == [(PEER, second)]


def test_proposal_of_compression_is_accepted_and_not_forwarded(node: Router) -> None:
    assert receive(node, "024012000700010101650002016400aabb0100", SENDER_PORT) == [
        (GROUP, "02001000110101650002016400aabb0100")
    ]


def test_packets_of_one_datagram_reach_their_components_one_by_one(node: Router) -> None:
    packed = "02 00100001020164000101c8000a0b0600 00110001020164000101c8000c0d0e0700"
    assert receive(node, packed, PEER) == [
        (SENDER_PORT, "0200100001020164000101c8000a0b0600"),
        (SENDER_PORT, "0200110001020164000101c8000c0d0e0700"),
    ]


def test_a_control_byte_of_ff_passes_to_every_side(node: Router) -> None:
    faulty = "02001200ff0101650009016400000102030100"
    other = JausID.parse("100.1.9")
    core = Router("/root")
    core.receive(junior.connect(other), OTHER_PORT, 0.0)
    core.poll_output()
    assert receive(core, faulty, OTHER_PORT) == [(GROUP, faulty)]
    core.receive(junior.connect(FAR), SENDER_PORT, 0.0)
    core.poll_output()
    assert receive(core, faulty, OTHER_PORT) == [(SENDER_PORT, faulty)]


@pytest.mark.parametrize("kind", range(1, 64))
def test_reserved_message_types_are_never_misread(node: Router, kind: int) -> None:
    assert receive(node, f"02{kind:02x}100001020164000101c8000a0b0600", PEER) == []
    assert node.counters["dropped.malformed.message_type"] == 1


def test_unknown_compression_is_dropped_and_rejected(node: Router) -> None:
    refusal = (PEER, "02" + "80100007" + "00" * 12)
    assert receive(node, "02c01200070001020164000101c8000a0b0600", PEER) == [refusal]
    assert node.counters["dropped.malformed.no_template"] == 1


def test_shutdown_to_the_own_id_is_delivered(node: Router) -> None:
    wakeup = "0200100001020164000201640000000600"
    assert receive(node, wakeup, SENDER_PORT) == [(SENDER_PORT, wakeup)]
