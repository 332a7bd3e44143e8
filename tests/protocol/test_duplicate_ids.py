"""Whose id it is when somebody else speaks as a component that may be dead."""

from jauspy.ids import JausID
from jauspy.protocol import judp, junior
from jauspy.protocol.addressing import LocalPort, UdpPort
from jauspy.protocol.header import Packet
from jauspy.protocol.routing import Router

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


def test_a_living_components_id_is_not_free() -> None:
    node = core(PATH_A)
    node.receive(FROM_B, REMOTE, 0.0)
    node.receive(FROM_B, ELSEWHERE, 0.0)
    assert node.poll_output() == []
    assert (node.counters["dropped.hijack"], node.counters["dropped.duplicate_id"]) == (1, 1)


def test_nobody_is_looked_after_while_everybody_speaks_for_himself() -> None:
    asked: list[str] = []

    def is_dead(path: str) -> bool:
        asked.append(path)
        return False

    node = Router("/root", is_dead=is_dead)
    node.receive(junior.connect(B), PATH_B, 0.0)
    node.receive(FROM_B, PATH_B, 0.0)
    node.receive(judp.pack(Packet(A, B, b"\x02\x20", 1)), REMOTE, 0.0)
    assert asked == []
