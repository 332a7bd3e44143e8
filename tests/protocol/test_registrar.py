"""Whose id it is when somebody else speaks as a component that may be dead."""

from jauspy.ids import JausID
from jauspy.protocol import judp, junior
from jauspy.protocol.addressing import LocalPort, UdpPort
from jauspy.protocol.header import Packet
from jauspy.protocol.routing import Router
from jauspy.protocol.sources import MOVE_TIMEOUT, SourceLimits

A, B = JausID.parse("100.1.1"), JausID.parse("100.1.2")
PATH_A, PATH_B, ELSEWHERE = (LocalPort(f"/root/{name}") for name in (int(A), int(B), "elsewhere"))
REMOTE = UdpPort("10.77.0.2", 3794)
FROM_B = judp.pack(Packet(B, A, b"\x02\x20", 1))
TO_B = judp.pack(Packet(A, B, b"\x02\x20", 1))


def core(*dead: LocalPort) -> Router:
    """A node manager with the components A and B; it has not noticed yet who of them is dead."""
    core = Router("/root", is_dead=lambda path: LocalPort(path) in dead)
    for id, port in ((A, PATH_A), (B, PATH_B)):
        core.receive(junior.connect(id), port, 0.0)
    core.poll_output()
    return core


def test_a_dead_components_id_is_free_for_the_network() -> None:
    node = core(PATH_B)
    node.receive(FROM_B, REMOTE, 0.0)
    assert node.poll_output() == [(PATH_A, FROM_B)]
    assert (node.counters["dropped.hijack"], node.counters["components.lost"]) == (0, 1)
    node.receive(TO_B, PATH_A, 0.0)
    assert node.poll_output() == [(REMOTE, TO_B)]


def test_a_dead_components_id_is_free_for_another_socket() -> None:
    node = core(PATH_B)
    node.receive(FROM_B, ELSEWHERE, 0.0)
    assert node.poll_output() == [(PATH_A, FROM_B)]
    node.receive(TO_B, PATH_A, 0.0)
    assert node.poll_output() == [(ELSEWHERE, TO_B)]


def test_id_of_a_live_component_is_in_use() -> None:
    node = core(PATH_A)
    node.receive(FROM_B, REMOTE, 0.0)
    node.receive(FROM_B, ELSEWHERE, 0.0)
    assert [port for port, _ in node.poll_output()] == [REMOTE]  # a notice of the clash
    assert (node.counters["dropped.hijack"], node.counters["dropped.duplicate_id"]) == (1, 1)


def test_liveness_is_checked_only_for_conflicts() -> None:
    asked: list[str] = []

    def is_dead(path: str) -> bool:
        asked.append(path)
        return False

    node = Router("/root", is_dead=is_dead)
    node.receive(junior.connect(B), PATH_B, 0.0)
    node.receive(FROM_B, PATH_B, 0.0)
    node.receive(judp.pack(Packet(A, B, b"\x02\x20", 1)), REMOTE, 0.0)
    assert asked == []


def test_an_id_of_the_network_is_taken_until_it_is_silent() -> None:
    node = core()
    remote = JausID.parse("42.1.1")
    own = LocalPort(f"/root/{int(remote)}")
    node.receive(judp.pack(Packet(remote, A, b"\x02\x20", 1)), REMOTE, 100.0)
    node.poll_output()
    for first in (junior.connect(remote), judp.pack(Packet(remote, A, b"\x02\x20", 2))):
        node.receive(first, own, 100.0 + MOVE_TIMEOUT - 0.1)
        assert node.poll_output() == []
    assert node.counters["dropped.id_taken"] == 2
    node.receive(junior.connect(remote), own, 100.0 + MOVE_TIMEOUT)
    assert node.poll_output() == [(own, junior.accept(remote))]


def test_what_was_refused_takes_no_id() -> None:
    node = core()
    node.sources.set_limits(SourceLimits(rate=1.0, burst=1.0))
    remote = JausID.parse("42.1.1")
    node.sources.within_rate(int(remote), 1, 0.0)
    node.receive(judp.pack(Packet(remote, A, b"\x02\x20", 1)), REMOTE, 0.0)
    assert node.counters["dropped.rate"] == 1
    own = LocalPort(f"/root/{int(remote)}")
    node.receive(junior.connect(remote), own, 0.0)
    assert node.poll_output() == [(own, junior.accept(remote))]


def test_without_source_checks_no_id_is_taken() -> None:
    node = core()
    node.sources.set_limits(SourceLimits(check_address=False))
    remote = JausID.parse("42.1.1")
    node.receive(judp.pack(Packet(remote, A, b"\x02\x20", 1)), REMOTE, 0.0)
    node.poll_output()
    own = LocalPort(f"/root/{int(remote)}")
    node.receive(junior.connect(remote), own, 1.0)
    assert node.poll_output() == [(own, junior.accept(remote))]


def test_own_ids_are_never_those_of_a_network() -> None:
    node = Router("/root", own_ids=[JausID.parse("100.1.255")])
    node.receive(junior.connect(A), PATH_A, 0.0)
    node.receive(FROM_B, REMOTE, 0.0)
    assert node.counters["dropped.hijack"] == 1
    node.poll_output()
    node.receive(judp.pack(Packet(JausID.parse("0.0.7"), A, b"\x02\x20", 1)), REMOTE, 0.0)  # without an id yet
    assert [port for port, _ in node.poll_output()] == [PATH_A]
