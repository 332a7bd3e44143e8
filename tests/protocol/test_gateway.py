"""Gateways in memory: what crosses, what does not, rules, and rings."""

import pytest

from jauspy.ids import EVERYONE, JausID
from jauspy.protocol import gateway as rules, judp, junior
from jauspy.protocol.addressing import GroupPort, LocalPort, Port, UdpPort
from jauspy.protocol.gateway import Gateway, GatewayRule, GatewayRules
from jauspy.protocol.header import Ack, Broadcast, DataFlag, Packet
from jauspy.protocol.routing import Router
from jauspy.protocol.sources import SourceLimits

OCU, MOB, MAN, LOCAL = (JausID.parse(text) for text in ("42.1.1", "101.1.102", "101.2.103", "101.3.1"))
OCU_PORT, MOB_PORT = UdpPort("10.0.0.42", 3794, "lan"), UdpPort("10.1.0.2", 3794, "vehicle")
LAN, VEHICLE = GroupPort("lan"), GroupPort("vehicle")
HERE = LocalPort(f"/root/{int(LOCAL)}")


def gateway(
    *rules: GatewayRule,
    networks: tuple[str, ...] = ("lan", "vehicle"),
    subsystem: int = 101,
    further: tuple[range, ...] = (),
) -> Router:
    inside = networks[1:]
    reported = Gateway(
        [range(subsystem, subsystem + 1), *further], networks, inside, GatewayRules(rules, inside=inside)
    )
    return Router("/root", networks=networks, gateway=reported)


def message(source: JausID, destination: JausID, sequence: int = 1, code: int = 0x2002, **fields: object) -> bytes:
    return judp.pack(Packet(source, destination, code.to_bytes(2, "little"), sequence, **fields))  # type: ignore[arg-type]


def after(core: Router, data: bytes, source: Port, now: float = 0.0) -> list[tuple[Port, bytes]]:
    core.receive(data, source, now)
    return core.poll_output()


@pytest.fixture
def core() -> Router:
    """A gateway of subsystem 101 that has heard an OCU outside and a module inside."""
    core = gateway()
    after(core, message(OCU, EVERYONE, 100), OCU_PORT)
    after(core, message(MOB, JausID(101, 255, 255), 100), MOB_PORT)
    return core


def test_unicast_crosses_both_ways_unchanged(core: Router) -> None:
    query, report = message(OCU, MOB), message(MOB, OCU)
    assert after(core, query, OCU_PORT) == [(MOB_PORT, query)]
    assert after(core, report, MOB_PORT) == [(OCU_PORT, report)]
    assert core.counters["relayed"] == 3


def test_broadcasts_cross_both_ways(core: Router) -> None:
    after(core, junior.connect(LOCAL), HERE)
    data = message(OCU, EVERYONE, broadcast=Broadcast.GLOBAL)
    assert after(core, data, OCU_PORT) == [(HERE, data), (VEHICLE, data)]
    data = message(MOB, EVERYONE, broadcast=Broadcast.GLOBAL)
    assert after(core, data, MOB_PORT) == [(HERE, data), (LAN, data)]


@pytest.mark.parametrize(
    ("source", "destination", "fields"),
    [
        (MOB, JausID(101, 255, 255), {}),
        (MOB, EVERYONE, {"broadcast": Broadcast.LOCAL}),
        (JausID(77, 1, 1), EVERYONE, {}),
    ],
    ids=["for the subsystem itself", "local broadcast", "of another subsystem"],
)
def test_packets_that_do_not_leave_the_subsystem(
    core: Router, source: JausID, destination: JausID, fields: dict[str, object]
) -> None:
    assert after(core, message(source, destination, **fields), MOB_PORT) == []


@pytest.mark.parametrize(
    ("source", "destination", "reason"),
    [
        (OCU, JausID(102, 1, 1), "not_addressed_here"),
        (OCU, JausID(102, 255, 255), "not_addressed_here"),
        (MAN, EVERYONE, "own_id_outside"),
    ],
)
def test_packets_that_do_not_enter(core: Router, source: JausID, destination: JausID, reason: str) -> None:
    assert after(core, message(source, destination), OCU_PORT) == []
    assert core.counters[f"dropped.gateway.{reason}"] == 1


def test_inside_id_cannot_be_used_from_outside(core: Router) -> None:
    assert after(core, message(MOB, EVERYONE, 2), OCU_PORT) == []
    assert after(core, message(OCU, MOB, 3), OCU_PORT) == [(MOB_PORT, message(OCU, MOB, 3))]
    assert core.counters["dropped.address_mismatch"] == 1


def test_unknown_module_is_probed_inside_only(core: Router) -> None:
    asking = message(OCU, MAN, ack=Ack.REQUIRED)
    assert after(core, message(OCU, MAN), OCU_PORT) == [(VEHICLE, asking)]
    assert after(core, message(OCU, MAN, 2), OCU_PORT) == []
    core.handle_timeout(1.0)
    assert core.poll_output() == [(VEHICLE, message(OCU, MAN, 2, ack=Ack.REQUIRED))]
    there = UdpPort("10.1.0.3", 3794, "vehicle")
    after(core, message(OCU, MAN, 3), OCU_PORT, 1.1)
    answer = judp.pack(Packet(MAN, OCU, b"", 1, ack=Ack.ACK))
    assert after(core, answer, there, 1.2) == [(there, message(OCU, MAN, 3)), (OCU_PORT, answer)]


def test_unknown_ocu_is_probed_outside_only(core: Router) -> None:
    far = JausID(43, 1, 1)
    asking = message(MOB, far, ack=Ack.REQUIRED)
    assert after(core, message(MOB, far), MOB_PORT) == [(LAN, asking)]


def test_resend_while_the_module_is_unknown_is_no_echo(core: Router) -> None:
    asking = message(OCU, MAN, ack=Ack.REQUIRED)
    assert after(core, asking, OCU_PORT) == [(VEHICLE, asking)]
    assert after(core, asking, OCU_PORT, 0.1) == []
    assert core.counters["echoes"] == 0
    assert core.pending_messages == 1


def test_module_gets_no_echo_from_its_own_network(core: Router) -> None:
    """The destination is on the same network and answers by itself."""
    assert after(core, message(MOB, MAN, ack=Ack.REQUIRED), MOB_PORT) == []


def test_without_a_gateway_nothing_crosses() -> None:
    core = Router("/root", networks=("lan", "vehicle"))
    after(core, message(MOB, EVERYONE), MOB_PORT)
    assert after(core, message(OCU, MOB), OCU_PORT) == []
    assert after(core, message(OCU, EVERYONE), OCU_PORT) == []


def test_local_components_reach_all_networks_of_their_node_manager(core: Router) -> None:
    data = message(LOCAL, EVERYONE)
    assert after(core, data, HERE) == [(LAN, data), (VEHICLE, data)]
    assert after(core, message(LOCAL, OCU), HERE) == [(OCU_PORT, message(LOCAL, OCU))]


# --- rules -----------------------------------------------------------------------------------------------------------


def test_first_matching_rule_decides_and_others_are_refused() -> None:
    core = gateway(
        GatewayRule(allow=False, source=JausID(42, 255, 255), messages=(range(0x0405, 0x0406),)),
        GatewayRule(allow=True, source=JausID(42, 255, 255), destination=JausID(101, 255, 255)),
    )
    after(core, message(MOB, OCU), MOB_PORT)
    assert len(after(core, message(OCU, MOB), OCU_PORT)) == 1
    assert after(core, message(OCU, MOB, code=0x0405), OCU_PORT) == []
    assert after(core, message(JausID(43, 1, 1), MOB), UdpPort("10.0.0.43", 3794, "lan")) == []
    assert core.counters["dropped.gateway.rule"] == 2
    assert len(after(core, message(MOB, OCU, code=0x0405), MOB_PORT)) == 1


def test_rules_protect_the_components_of_the_same_machine() -> None:
    core = gateway(GatewayRule(allow=True, source=OCU))
    after(core, junior.connect(LOCAL), HERE)
    assert after(core, message(JausID(43, 1, 1), LOCAL), UdpPort("10.0.0.43", 1)) == []
    assert after(core, message(OCU, LOCAL), OCU_PORT) == [(HERE, message(OCU, LOCAL))]


def test_rule_limits_the_rate_per_source() -> None:
    core = gateway(GatewayRule(allow=True, rate=10.0))
    after(core, message(MOB, OCU), MOB_PORT)
    passed = sum(len(after(core, message(OCU, MOB, n), OCU_PORT, n / 100)) for n in range(200))
    assert 28 <= passed <= 31
    assert core.counters["dropped.gateway.rule_rate"] == 200 - passed


def test_rule_for_an_inside_network_filters_leaving_packets() -> None:
    core = gateway(GatewayRule(allow=False, network="vehicle", messages=(range(0x2002, 0x2003),)))
    after(core, message(OCU, EVERYONE), OCU_PORT)
    assert after(core, message(MOB, OCU), MOB_PORT) == []
    assert len(after(core, message(MOB, OCU, code=0x4002), MOB_PORT)) == 1


def test_fragments_follow_the_decision_for_the_first() -> None:
    core = gateway(GatewayRule(allow=True, messages=(range(0x0405, 0x0406),)))
    after(core, message(MOB, OCU), MOB_PORT)
    for code, passes in ((0x0405, True), (0x2002, False)):
        for sequence, flag in enumerate((DataFlag.FIRST, DataFlag.MIDDLE, DataFlag.LAST)):
            first = code if flag is DataFlag.FIRST else 0xFFFF
            data = message(OCU, MOB, sequence, first, data_flag=flag)
            assert bool(after(core, data, OCU_PORT)) is passes


def test_decision_for_the_first_fragment_expires() -> None:
    core = gateway(GatewayRule(allow=True, source=OCU, messages=(range(0x0405, 0x0406),)))
    after(core, message(MOB, OCU), MOB_PORT)
    assert after(core, message(OCU, MOB, 1, 0x0405, data_flag=DataFlag.FIRST), OCU_PORT)
    late = rules.FRAGMENT_TIMEOUT - 1
    assert after(core, message(OCU, MOB, 2, data_flag=DataFlag.MIDDLE), OCU_PORT, late)
    assert after(core, message(OCU, MOB, 3, data_flag=DataFlag.MIDDLE), OCU_PORT, 2 * late)
    assert not after(core, message(OCU, MOB, 4, data_flag=DataFlag.LAST), OCU_PORT, 2 * late + rules.FRAGMENT_TIMEOUT)


@pytest.mark.parametrize("first", [b"", b"\x05"])
def test_a_first_fragment_without_a_message_id_passes_no_rule(first: bytes) -> None:
    core = gateway(GatewayRule(allow=True, messages=(range(0x2000, 0x6000),)))
    after(core, message(MOB, OCU), MOB_PORT)
    command = b"\x05\x04\x01\x00\x33\xb3"
    parts = ((first, DataFlag.FIRST), (command[len(first) :], DataFlag.LAST))
    for sequence, (part, flag) in enumerate(parts):
        assert not after(core, judp.pack(Packet(OCU, MOB, part, sequence, data_flag=flag)), OCU_PORT)


def test_acknowledgements_pass_where_messages_may() -> None:
    core = gateway(GatewayRule(allow=True, source=OCU, messages=(range(0x0405, 0x0406),)))
    after(core, message(MOB, OCU), MOB_PORT)
    assert len(after(core, judp.pack(Packet(OCU, MOB, b"", 1, ack=Ack.ACK)), OCU_PORT)) == 1


# --- rings -----------------------------------------------------------------------------------------------------------


class Ring:
    """Gateways on shared networks: what one sends to a group, all others on that network hear."""

    def __init__(self, *networks: tuple[str, ...]) -> None:
        self.gateways = {f"10.9.0.{number}": gateway(networks=each) for number, each in enumerate(networks, 1)}
        self.networks = dict(zip(self.gateways, networks, strict=True))
        self.crossings: list[tuple[str, str, bytes]] = []

    def hear(self, data: bytes, source: UdpPort, limit: int = 100) -> None:
        """Everybody on the network of `source` hears it, and what they send, until it is quiet."""
        queue = [(data, source)]
        while queue:
            data, source = queue.pop(0)
            for address, core in self.gateways.items():
                if address == source.host or source.network not in self.networks[address]:
                    continue
                for port, sent in after(core, data, source):
                    assert not isinstance(port, LocalPort)
                    self.crossings.append((address, port.network, sent))
                    queue.append((sent, UdpPort(address, 3794, port.network)))
            assert len(self.crossings) < limit, "the ring does not come to rest"


def test_two_gateways_between_the_same_networks_send_each_broadcast_once() -> None:
    ring = Ring(("lan", "vehicle"), ("lan", "vehicle"))
    data = message(OCU, EVERYONE, broadcast=Broadcast.GLOBAL)
    ring.hear(data, OCU_PORT)
    assert sorted(ring.crossings) == [("10.9.0.1", "vehicle", data), ("10.9.0.2", "vehicle", data)]
    ring.crossings.clear()
    answer = message(MOB, EVERYONE, broadcast=Broadcast.GLOBAL)
    ring.hear(answer, MOB_PORT)
    assert sorted(ring.crossings) == [("10.9.0.1", "lan", answer), ("10.9.0.2", "lan", answer)]


def test_broadcast_in_a_ring_of_networks_ends() -> None:
    """With the address check off, so that only the memory of what was relayed stops it."""
    ring = Ring(("lan", "a", "b"), ("lan", "b", "c"), ("lan", "c", "a"))
    for core in ring.gateways.values():
        core.sources.set_limits(SourceLimits(check_address=False))
    data = message(MOB, JausID(101, 255, 255), broadcast=Broadcast.GLOBAL)
    ring.hear(data, UdpPort("10.1.0.2", 3794, "a"))
    assert 2 <= len(ring.crossings) <= 4
    assert all(sent == data for _, _, sent in ring.crossings)


def test_unicast_in_a_ring_of_networks_ends() -> None:
    ring = Ring(("lan", "vehicle"), ("lan", "vehicle"))
    ring.hear(message(OCU, MAN), OCU_PORT)
    assert len(ring.crossings) <= 2
    ring.hear(message(MOB, JausID(43, 1, 1)), MOB_PORT)
    assert len(ring.crossings) <= 4


def test_refused_messages_are_counted_by_kind_and_bounded() -> None:
    core = gateway(GatewayRule(True, messages=(range(0x2000, 0x2100),)))
    for code in (0x2002, 0x0405, 0x0405):
        after(core, message(OCU, MOB, code=code), OCU_PORT)
    assert core.gateway is not None
    assert dict(core.gateway.refused) == {("rule", "lan", 0x0405): 2}
    for code in range(rules.MAX_REFUSED + 1):
        after(core, message(OCU, MOB, code=code), OCU_PORT)
    assert len(core.gateway.refused) == rules.MAX_REFUSED
    assert ("rule", "lan", 0x0405) not in core.gateway.refused


def test_a_site_with_several_subsystems_has_one_gateway() -> None:
    """Two robots and an operator of the site; what they say to each other stays inside."""
    core = gateway(further=(range(102, 120), range(43, 44)))
    other, own_operator = JausID.parse("119.1.1"), JausID.parse("43.1.1")
    inside = UdpPort("10.1.0.9", 3794, "vehicle"), UdpPort("10.1.0.8", 3794, "vehicle")
    after(core, message(OCU, EVERYONE, 100), OCU_PORT)
    for id, port in ((MOB, MOB_PORT), (other, inside[0]), (own_operator, inside[1])):
        after(core, message(id, JausID(101, 255, 255), 100), port)
    for id, port in ((MOB, MOB_PORT), (other, inside[0]), (own_operator, inside[1])):
        query, report = message(OCU, id), message(id, OCU)
        assert after(core, query, OCU_PORT) == [(port, query)]
        assert after(core, report, port) == [(OCU_PORT, report)]
    stays = [
        (message(own_operator, other), inside[1]),
        (message(other, JausID(102, 255, 255)), inside[0]),
        (message(own_operator, MOB), inside[1]),
    ]
    assert [after(core, data, port) for data, port in stays] == [[], [], []]
    assert after(core, message(OCU, JausID(120, 1, 1)), OCU_PORT) == []
    assert core.counters["dropped.gateway.not_addressed_here"] == 1
    assert after(core, message(other, MOB), OCU_PORT) == []
    assert core.counters["dropped.address_mismatch"] + core.counters["dropped.gateway.own_id_outside"] == 1
