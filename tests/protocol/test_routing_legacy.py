"""Old headers, old ways and unusual ids through the node manager's core."""

import logging

import pytest

from jauspy.ids import EVERYONE, JausID
from jauspy.protocol import judp, junior, registrar
from jauspy.protocol.address_book import ADDRESS_LIFETIME
from jauspy.protocol.addressing import GROUP, LocalPort, Port, SerialPort, TcpPort, UdpPort
from jauspy.protocol.header import Ack, Broadcast, Packet
from jauspy.protocol.routing import Router

OURS, THEIRS = JausID.parse("100.1.1"), JausID.parse("200.1.1")
OUR_PORT, PEER = LocalPort("/root/ours"), UdpPort("10.0.0.9", 3794)
OPC_FROM_PEER = "4a41555330312e30 06023412 01016400 0101c800 0200 2300 0102"
V1_HERE = "010000 0012 06023412 01016400 0101c800 0200 2300 0102"
V1_REPLY = "010000 0012 06023412 0101c800 01016400 0200 2300 0102"


def node(**settings: object) -> Router:
    core = Router("/root", **settings)  # type: ignore[arg-type]
    core.receive(junior.connect(OURS), OUR_PORT, 0.0)
    core.poll_output()
    return core


def receive(core: Router, data: str | bytes, source: Port, now: float = 0.0) -> list[tuple[Port, str]]:
    core.receive(bytes.fromhex(data) if isinstance(data, str) else data, source, now)
    return [(port, out.hex()) for port, out in core.poll_output()]


def plain(text: str) -> str:
    return bytes.fromhex(text).hex()


def test_opc_peer_is_answered_in_opc() -> None:
    core = node()
    assert receive(core, OPC_FROM_PEER, PEER) == [(OUR_PORT, plain(V1_HERE))]
    reply = plain("4a41555330312e30 06023412 0101c800 01016400 0200 2300 0102")
    assert receive(core, V1_REPLY, OUR_PORT) == [(PEER, reply)]


def test_version_1_peer_is_answered_in_version_1() -> None:
    core = node()
    assert receive(core, V1_HERE, PEER) == [(OUR_PORT, plain(V1_HERE))]
    assert receive(core, V1_REPLY, OUR_PORT) == [(PEER, plain(V1_REPLY))]
    current = judp.pack(Packet(OURS, THEIRS, b"\x02\x20", 1))
    assert receive(core, current, OUR_PORT) == [(PEER, current.hex())]


@pytest.mark.parametrize("start", ["010000 0012", "4a41555330312e30"])
def test_packet_without_command_code_reaches_components_as_as5669a(start: str) -> None:
    core = node()
    old = start + "06020000 01016400 0101c800 0200 2300 0220"
    assert receive(core, old, PEER) == [(OUR_PORT, "02001000010101640001" + "01c8000220" + "2300")]


def test_version_1_probe_requests_an_ack() -> None:
    assert receive(node(), V1_REPLY, OUR_PORT) == [(GROUP, plain(V1_REPLY.replace("0602", "1602")))]


def test_version_1_unicast_and_broadcast_between_local_components() -> None:
    core = node()
    other = LocalPort("/root/other")
    receive(core, junior.connect(THEIRS), other)
    assert receive(core, V1_REPLY, OUR_PORT) == [(other, plain(V1_REPLY))]
    everybody = "010000 0012 06023412 ffffffff 01016400 0200 2300 0102"
    assert receive(core, everybody, OUR_PORT) == [(other, plain(everybody)), (GROUP, plain(everybody))]


def test_proposal_of_compression_is_not_forwarded() -> None:
    packed = "02 401200 070c 01 01016400 0101c800 0220 0100 001000 01 01016400 0101c800 0520 0200"
    assert [out for _, out in receive(node(), packed, PEER)] == [
        plain("02 001000 01 01016400 0101c800 0220 0100"),
        plain("02 001000 01 01016400 0101c800 0520 0200"),
    ]


def test_connects_from_the_network_are_ignored() -> None:
    core = node()
    assert receive(core, junior.connect(THEIRS), PEER) == []
    assert core.counters["dropped.connect_from_network"] == 1


def test_component_without_id_gets_matching_broadcasts() -> None:
    core = node()
    newcomer = LocalPort("/root/101")
    receive(core, junior.connect(JausID(0, 0, 101)), newcomer)
    data = judp.pack(Packet(THEIRS, JausID(100, 1, 101), b"\x02\x20", 1))
    assert receive(core, data, PEER) == [(newcomer, data.hex())]
    wild = LocalPort("/root/102")
    receive(core, junior.connect(JausID(65535, 255, 102)), wild)
    everybody = judp.pack(Packet(THEIRS, JausID(100, 255, 255), b"\x02\x20", 1))
    assert [port for port, _ in receive(core, everybody, PEER)] == [OUR_PORT, newcomer, wild]


def test_duplicate_ids_are_reported_once_each(caplog: pytest.LogCaptureFixture) -> None:
    core = node()
    for port in (LocalPort("/root/thief"), LocalPort("/root/thief"), PEER, PEER):
        sent = receive(core, judp.pack(Packet(OURS, THEIRS, b"\x02\x20")), port)
        assert {to for to, _ in sent} <= {PEER}  # a notice of the clash
    reported = [record.getMessage() for record in caplog.records if record.levelno == logging.WARNING]
    assert ["/root/thief" in reported[0], "10.0.0.9:3794" in reported[1], len(reported)] == [True, True, 2]
    assert (core.counters["dropped.duplicate_id"], core.counters["dropped.hijack"]) == (2, 2)
    for number in range(registrar.MAX_LOGGED_CASES + 5):
        stolen = judp.pack(Packet(OURS, THEIRS, b"\x02\x20"))
        core.receive(stolen, UdpPort(f"10.0.{number >> 8}.{number & 255}", 3794), 100.0 * number)
    assert len(core._duplicate_ids._logged) == registrar.MAX_LOGGED_CASES


def test_tcp_and_serial_addresses_are_learned_and_forgotten_with_their_connection() -> None:
    core = node()
    for now, port in ((0.0, TcpPort("10.0.0.9", 3794)), (60.0, SerialPort("/dev/ttyS0"))):
        receive(core, judp.pack(Packet(THEIRS, OURS, b"\x02\x20")), port, now)
        there = judp.pack(Packet(OURS, THEIRS, b"\x02\x40"))
        assert receive(core, there, OUR_PORT) == [(port, there.hex())]
    core.disconnected(SerialPort("/dev/ttyS0"))
    assert [port for port, _ in receive(core, there, OUR_PORT)] == [GROUP]


def test_static_addresses_get_unicasts_and_copies_of_broadcasts() -> None:
    fleet, robot = UdpPort("10.0.0.1", 3794), TcpPort("10.0.0.2", 3794)
    core = node(addresses={JausID(200, 255, 255): (fleet,), JausID(201, 1, 1): (robot,)})
    cases = {
        JausID(200, 1, 7): [fleet],
        JausID(201, 1, 1): [robot],
        EVERYONE: [GROUP, fleet, robot],
        JausID(200, 1, 255): [GROUP, fleet],
        JausID(201, 255, 1): [GROUP, robot],
    }
    for destination, ports in cases.items():
        flag = Broadcast.GLOBAL if destination.is_wildcard else Broadcast.NONE
        data = judp.pack(Packet(OURS, destination, b"\x02\x20", broadcast=flag))
        assert receive(core, data, OUR_PORT) == [(port, data.hex()) for port in ports]
    local = judp.pack(Packet(OURS, EVERYONE, b"\x02\x20", broadcast=Broadcast.LOCAL))
    assert receive(core, local, OUR_PORT) == []


def test_expired_address_is_probed_again() -> None:
    core = node()
    receive(core, judp.pack(Packet(THEIRS, OURS, b"\x02\x20")), PEER)
    data = judp.pack(Packet(OURS, THEIRS, b"\x02\x20"))
    assert receive(core, data, OUR_PORT, ADDRESS_LIFETIME - 1) == [(PEER, data.hex())]
    asking = judp.pack(Packet(OURS, THEIRS, b"\x02\x20", ack=Ack.REQUIRED))
    assert receive(core, data, OUR_PORT, ADDRESS_LIFETIME) == [(GROUP, asking.hex())]


def test_udp_connect_cannot_take_the_id_of_a_local_socket() -> None:
    core = node()
    assert receive(core, junior.connect(OURS), UdpPort("127.0.0.1", 4000)) == []
    assert core.counters["dropped.duplicate_id"] == 1
    own = judp.pack(Packet(OURS, OURS, b"\x00\x00"))
    assert receive(core, own, OUR_PORT) == [(OUR_PORT, own.hex())]


def test_new_address_after_a_closed_connection_is_learned_at_once() -> None:
    core, port = node(), TcpPort("10.0.0.9", 3794)
    there, here = judp.pack(Packet(OURS, THEIRS, b"\x02\x40")), judp.pack(Packet(THEIRS, OURS, b"\x02\x20"))
    receive(core, here, port, 0.0)
    core.disconnected(port)
    receive(core, here, port, 0.1)
    assert receive(core, there, OUR_PORT, 0.1) == [(port, there.hex())]
