"""Routing decisions of the node manager, in memory and on virtual time."""

import pytest
from hypothesis import given, strategies as st

from jauspy.ids import EVERYONE, JausID
from jauspy.protocol import address_book, judp, junior, pending
from jauspy.protocol.addressing import GROUP, LocalPort, Port, UdpPort
from jauspy.protocol.duplicates import ECHO_LIFETIME, MulticastEchoes
from jauspy.protocol.header import Ack, Broadcast, Packet
from jauspy.protocol.routing import Router

A, B, C = (JausID.parse(text) for text in ("100.1.1", "100.1.2", "100.2.1"))
FAR = JausID.parse("101.1.1")
FAR_PORT = UdpPort("10.77.0.2", 4001)


def port(id: JausID) -> LocalPort:
    return LocalPort(f"/root/{int(id)}")


def message(source: JausID, destination: JausID, sequence: int = 1, **fields: object) -> bytes:
    return judp.pack(Packet(source, destination, b"\x02\x20", sequence, **fields))  # type: ignore[arg-type]


@pytest.fixture
def node() -> Router:
    """A node manager with components A, B and C."""
    core = Router("/root")
    for id in (A, B, C):
        core.receive(junior.connect(id), port(id), 0.0)
    core.poll_output()
    return core


def after(core: Router, data: bytes, source: Port, now: float = 0.0) -> list[tuple[Port, bytes]]:
    core.receive(data, source, now)
    return core.poll_output()


def test_every_connect_is_accepted(node: Router) -> None:
    for _ in range(2):
        assert after(node, junior.connect(A), port(A)) == [(port(A), junior.accept(A))]


def test_any_message_registers_its_sender() -> None:
    core = Router("/root")
    after(core, message(A, A), port(A))
    assert after(core, message(B, A), port(B)) == [(port(A), message(B, A))]


def test_sender_without_socket_name_is_answered_at_its_path() -> None:
    core = Router("/root/")
    assert after(core, junior.connect(A), LocalPort("")) == [(port(A), junior.accept(A))]


def test_second_socket_with_the_same_id_is_ignored_until_it_connects(node: Router) -> None:
    other = LocalPort("/root/other")
    assert after(node, message(B, A), other) == []
    assert node.counters["dropped.duplicate_id"] == 1
    assert after(node, message(A, B), port(A)) == [(port(B), message(A, B))]
    after(node, junior.connect(B), other)
    assert after(node, message(A, B), port(A)) == [(other, message(A, B))]


def test_unicast_to_the_own_id_is_delivered(node: Router) -> None:
    assert after(node, message(A, A), port(A)) == [(port(A), message(A, A))]


def test_after_cancel_a_component_is_unknown(node: Router) -> None:
    assert after(node, junior.cancel(B), port(B)) == []
    assert [to for to, _ in after(node, message(A, B), port(A))] == [GROUP]


def test_cancel_by_another_socket_is_ignored(node: Router) -> None:
    after(node, junior.cancel(B), port(A))
    assert after(node, message(A, B), port(A)) == [(port(B), message(A, B))]


def test_broadcast_reaches_all_but_its_source_unchanged(node: Router) -> None:
    data = message(A, EVERYONE, broadcast=Broadcast.GLOBAL)
    assert after(node, data, port(A)) == [(port(B), data), (port(C), data), (GROUP, data)]


def test_local_broadcast_is_not_sent_to_networks(node: Router) -> None:
    data = message(A, EVERYONE, broadcast=Broadcast.LOCAL)
    assert after(node, data, port(A)) == [(port(B), data), (port(C), data)]


def test_wildcards_match_field_by_field(node: Router) -> None:
    data = message(A, JausID(100, 255, 1))
    assert after(node, data, port(A)) == [(port(C), data), (GROUP, data)]
    data = message(FAR, JausID(100, 1, 255))
    assert after(node, data, FAR_PORT) == [(port(A), data), (port(B), data)]


def test_subsystems_100_and_356_are_distinct(node: Router) -> None:
    other = JausID(356, 1, 2)
    after(node, junior.connect(other), port(other))
    assert after(node, message(A, B), port(A)) == [(port(B), message(A, B))]
    assert [to for to, _ in after(node, message(A, JausID(0xFF64, 1, 2)), port(A))] == [GROUP]
    data = message(FAR, JausID(356, 255, 255))
    assert after(node, data, FAR_PORT) == [(port(other), data)]


def test_component_without_id_receives_broadcasts(node: Router) -> None:
    newcomer = JausID(0, 0, 101)
    after(node, junior.connect(newcomer), port(newcomer))
    data = message(FAR, JausID(100, 255, 255))
    assert (port(newcomer), data) in after(node, data, FAR_PORT)


def test_unknown_destination_is_probed_once_and_messages_wait(node: Router) -> None:
    probe = message(A, FAR, ack=Ack.REQUIRED)
    assert after(node, message(A, FAR), port(A), 0.0) == [(GROUP, probe)]
    assert after(node, message(A, FAR, 2), port(A), 0.1) == []
    assert after(node, message(A, FAR, 3), port(A), 0.2) == []
    waited = [message(A, FAR, n) for n in (2, 3)]
    answer = judp.pack(Packet(FAR, A, b"", 1, ack=Ack.ACK))
    assert after(node, answer, FAR_PORT, 0.3) == [(FAR_PORT, waited[0]), (FAR_PORT, waited[1]), (port(A), answer)]
    assert after(node, message(A, FAR, 4), port(A), 0.4) == [(FAR_PORT, message(A, FAR, 4))]
    assert node.next_timeout() is None


def test_probes_are_rate_limited(node: Router) -> None:
    multicasts = 0
    for step in range(1000):
        now = step / 100
        multicasts += len(after(node, message(A, FAR, step), port(A), now))
        deadline = node.next_timeout()
        if deadline is not None and deadline <= now:
            node.handle_timeout(now)
            multicasts += len(node.poll_output())
    assert 9 <= multicasts <= 11
    assert node.counters["dropped.unknown_destination"] + multicasts + pending.MAX_PENDING_PER_DESTINATION >= 1000


def test_pending_messages_probe_again_and_expire(node: Router) -> None:
    for sequence in range(1, 6):
        after(node, message(A, FAR, sequence), port(A), 0.0)
    asked = []
    for now in (1.0, 2.0, 3.0, 4.0):
        node.handle_timeout(now)
        asked += node.poll_output()
    assert asked == [(GROUP, message(A, FAR, sequence, ack=Ack.REQUIRED)) for sequence in (2, 3)]
    assert node.counters["dropped.unknown_destination"] == 2
    assert node.next_timeout() is None


def test_unknown_destinations_are_bounded(node: Router) -> None:
    for number in range(pending.MAX_PENDING_DESTINATIONS + 5):
        after(node, message(A, JausID(200, 1 + number // 200, 1 + number % 200)), port(A))
    assert node.counters["dropped.too_many_unknown_destinations"] == 5


def test_answer_uses_the_learned_port(node: Router) -> None:
    after(node, message(FAR, A), FAR_PORT)
    assert after(node, message(A, FAR), port(A)) == [(FAR_PORT, message(A, FAR))]
    moved = UdpPort(FAR_PORT.host, 4002)
    after(node, message(FAR, A), moved)
    assert after(node, message(A, FAR), port(A)) == [(moved, message(A, FAR))]


def test_network_messages_are_not_sent_back(node: Router) -> None:
    assert after(node, message(FAR, JausID(102, 1, 1)), FAR_PORT) == []
    assert node.counters["dropped.not_here"] == 1
    data = message(FAR, EVERYONE, broadcast=Broadcast.GLOBAL)
    assert {type(to) for to, _ in after(node, data, FAR_PORT)} == {LocalPort}


def test_remote_packet_cannot_use_a_local_id(node: Router) -> None:
    ((to, notice),) = after(node, message(B, A), FAR_PORT)
    assert to == FAR_PORT
    assert judp.first_header(notice).destination == int(B)
    assert node.counters["dropped.hijack"] == 1
    assert after(node, message(A, B), port(A)) == [(port(B), message(A, B))]


def test_own_multicast_echoes_are_ignored(node: Router) -> None:
    data = message(A, EVERYONE, broadcast=Broadcast.GLOBAL)
    after(node, data, port(A))
    assert after(node, data, FAR_PORT) == []
    assert node.counters["echoes"] == 1
    assert node.counters["dropped.hijack"] == 0


def test_wildcard_sources_are_not_learned(node: Router) -> None:
    after(node, message(JausID(101, 255, 1), A), FAR_PORT)
    after(node, message(JausID(0, 0, 7), A), FAR_PORT)
    assert len(node.address_book) == 0


def test_packed_datagrams_are_unpacked(node: Router) -> None:
    both = message(FAR, A) + message(FAR, B)[1:]
    assert after(node, both, FAR_PORT) == [(port(A), message(FAR, A)), (port(B), message(FAR, B))]


def test_removal_of_a_dead_component_does_not_affect_others(node: Router) -> None:
    node.remove_dead(port(A))
    data = message(FAR, JausID(100, 255, 255))
    assert after(node, data, FAR_PORT) == [(port(B), data), (port(C), data)]
    after(node, message(A, B), port(A))
    assert after(node, message(B, A), port(B)) == [(port(A), message(B, A))]


def test_unreachable_peer_is_probed_again(node: Router) -> None:
    after(node, message(FAR, A), FAR_PORT)
    assert after(node, message(A, FAR), port(A)) == [(FAR_PORT, message(A, FAR))]
    node.remove_dead(FAR_PORT)
    assert [where for where, _ in after(node, message(A, FAR, 2), port(A))] == [GROUP]


@pytest.mark.parametrize("data", [b"", b"\x02", b"\x02\x00\x05\x00\x01\x02", b"x" * 100, bytes(65507)])
@pytest.mark.parametrize("source", [port(A), FAR_PORT], ids=["local", "udp"])
def test_malformed_datagrams_are_counted_and_nothing_is_sent(node: Router, data: bytes, source: Port) -> None:
    assert after(node, data, source) == []
    assert sum(count for name, count in node.counters.items() if name.startswith("dropped.malformed")) == 1


def test_the_number_of_components_is_bounded() -> None:
    core = Router("/root")
    for number in range(address_book.MAX_COMPONENTS + 2):
        id = JausID(1 + number, 1, 1)
        core.receive(junior.connect(id), port(id), 0.0)
    assert len(core.components) == address_book.MAX_COMPONENTS
    assert core.counters["dropped.component_refused"] == 2


@given(st.lists(st.tuples(st.binary(max_size=60), st.booleans()), max_size=20))
def test_arbitrary_input_never_raises(datagrams: list[tuple[bytes, bool]]) -> None:
    core = Router("/root")
    for data, local in datagrams:
        core.receive(b"\x02\x00" + data if len(data) % 2 else data, port(A) if local else FAR_PORT, 0.0)
    core.handle_timeout(10.0)


def test_pending_messages_are_delivered_to_a_late_component(node: Router) -> None:
    late = JausID.parse("100.1.9")
    after(node, message(A, late, 1), port(A))
    after(node, message(A, late, 2), port(A))
    assert after(node, junior.connect(late), port(late)) == [
        (port(late), junior.accept(late)),
        (port(late), message(A, late, 2)),
    ]


def test_pending_bytes_are_bounded(node: Router) -> None:
    big = judp.pack(Packet(A, FAR, bytes(60000), 1))
    for number in range(40):
        after(node, judp.pack(Packet(A, JausID(200, 1, 1 + number // 4), bytes(60000), number)), port(A))
    assert node.counters["dropped.unknown_destination"] == 30 - pending.MAX_PENDING_BYTES // len(big)


def test_remembered_multicasts_are_bounded() -> None:
    echoes = MulticastEchoes(limit=2)
    for data in (b"a", b"b", b"a", b"c"):
        echoes.add(data, "lan", 0.0)
    assert [echoes.seen(data, "lan", 0.1) for data in (b"a", b"b", b"c", b"d")] == [True, False, True, False]


def test_multicast_memory_is_per_network_and_expires() -> None:
    echoes = MulticastEchoes()
    echoes.add(b"a", "lan", 5.0)
    assert echoes.seen(b"a", "lan", 5.0 + ECHO_LIFETIME / 2)
    assert not echoes.seen(b"a", "vehicle", 5.0 + ECHO_LIFETIME / 2)
    assert not echoes.seen(b"a", "lan", 5.0 + ECHO_LIFETIME)
