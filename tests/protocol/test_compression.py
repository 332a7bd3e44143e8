"""Header compression between two node managers: agreed on, used, lost and found again, in bounds."""

import heapq
import logging
import random
from collections.abc import Callable

import pytest
from hypothesis import given, strategies as st

from jauspy.errors import ProtocolError
from jauspy.ids import JausID
from jauspy.protocol import compression, compression as templates, judp, junior
from jauspy.protocol.addressing import LocalPort, Port, UdpPort
from jauspy.protocol.compression import Compression
from jauspy.protocol.counters import Counters
from jauspy.protocol.header import Ack, Packet, Priority
from jauspy.protocol.routing import CompressionUse, Router

HERE, FAR = JausID.parse("100.1.2"), JausID.parse("101.1.1")
OURS, PEER = LocalPort("/root/here"), UdpPort("10.77.0.2", 3794)
PLAIN = "02 001000 01 01016500 02016400 0220 0700"


def plain(text: str) -> str:
    return bytes.fromhex(text).hex()


def node(use: CompressionUse = "accept", id: JausID = HERE, port: LocalPort = OURS) -> Router:
    core = Router("/root", compression=use)
    core.receive(junior.connect(id), port, 0.0)
    core.poll_output()
    return core


def receive(core: Router, data: str | bytes, source: Port, now: float = 0.0) -> list[tuple[Port, str]]:
    core.receive(bytes.fromhex(data) if isinstance(data, str) else data, source, now)
    return [(port, out.hex()) for port, out in core.poll_output()]


def known(core: Router) -> Router:
    """The same node manager, which has heard FAR at PEER."""
    receive(core, judp.pack(Packet(FAR, HERE, b"\x02\x40", 1)), PEER)
    return core


def test_proposal_is_accepted_and_compressed_packets_are_expanded() -> None:
    core = node()
    proposal = "02 401200 0509 01 02016400 01016500 0220 0700"
    accepted = plain("02 801000 0509 01 01016500 02016400 0000")
    assert receive(core, proposal, PEER) == [
        (PEER, accepted),
        (OURS, plain("02 001000 01 02016400 01016500 0220 0700")),
    ]
    compressed = "02 c00900 0509 0520 0800"
    assert receive(core, compressed, PEER) == [(OURS, plain("02 001000 01 02016400 01016500 0520 0800"))]
    longer = "02 401200 060b 01 02016400 01016500 0220 0900"
    assert receive(core, longer, PEER)[0] == (PEER, plain("02 801000 060b 01 01016500 02016400 0000"))
    assert receive(core, "02 c00700 060b 0a00", PEER) == [(OURS, plain("02 001000 01 02016400 01016500 0220 0a00"))]


def test_packets_to_unknown_peers_are_not_compressed() -> None:
    core = known(node())
    for number in range(20):
        assert receive(core, PLAIN, OURS, float(number)) == [(PEER, plain(PLAIN))]


def test_peers_that_propose_get_proposals_and_compressed_packets() -> None:
    core = known(node())
    receive(core, "02 401200 0509 01 02016400 01016500 0220 0700", PEER)
    proposed = plain("02 401200 0109 01 01016500 02016400 0220 0700")
    assert receive(core, PLAIN, OURS) == [(PEER, proposed)]
    assert receive(core, PLAIN, OURS, 0.5) == [(PEER, plain(PLAIN))]
    assert receive(core, PLAIN, OURS, 1.0) == [(PEER, proposed)]
    assert receive(core, "02 801000 0109 01 02016400 01016500 0000", PEER, 1.1) == []
    assert receive(core, PLAIN, OURS, 1.2) == [(PEER, plain("02 c00900 0109 0220 0700"))]
    assert core.counters["compression.sent"] == 1


def agreed(*, use: CompressionUse = "accept") -> Router:
    core = known(node(use))
    receive(core, "02 401200 0509 01 02016400 01016500 0220 0700", PEER)
    receive(core, PLAIN, OURS)
    receive(core, "02 801000 0109 01 02016400 01016500 0000", PEER)
    return core


def test_templates_are_proposed_again_and_expire() -> None:
    core = agreed()
    kinds = [receive(core, PLAIN, OURS, now)[0][1][2:4] for now in (4.9, 5.0, 5.5, 6.0, 9.9, 10.0, 10.5, 20.0)]
    assert kinds == ["c0", "40", "c0", "40", "40", "00", "00", "40"]


def test_rejected_template_is_proposed_again() -> None:
    core = agreed()
    assert receive(core, PLAIN, OURS, 1.0)[0][1].startswith("02c0")
    assert receive(core, "02 801000 0100 00 00000000 00000000 0000", PEER, 1.1) == []
    assert receive(core, PLAIN, OURS, 1.2)[0][1].startswith("0240")
    fresh = node()
    assert receive(fresh, "02 c00900 0109 0220 0700", PEER) == [
        (PEER, plain("02 801000 0100 00 00000000 00000000 0000"))
    ]
    assert fresh.counters["dropped.malformed.no_template"] == 1


def test_an_answer_for_another_template_is_ignored() -> None:
    core = known(node())
    receive(core, "02 401200 0509 01 02016400 01016500 0220 0700", PEER)
    receive(core, PLAIN, OURS)
    for old in (
        "0109 01 03016400 01016500",
        "0109 01 02016400 01016600",
        "0209 01 02016400 01016500",
        "0108 01 02016400 01016500",
    ):
        receive(core, f"02 801000 {old} 0000", PEER)
        assert receive(core, PLAIN, OURS, 0.1) == [(PEER, plain(PLAIN))]


def test_an_acknowledgement_may_carry_the_answer() -> None:
    core = agreed()
    carried = "02 801000 0109 31 02016400 01016500 0700"
    assert receive(core, carried, PEER) == [(OURS, plain("02 000e00 31 02016400 01016500 0700"))]


def test_safety_critical_packets_are_not_compressed() -> None:
    urgent = judp.pack(Packet(HERE, FAR, b"\x06\x00\x00", 1, Priority.SAFETY_CRITICAL))
    for now in (0.1, 1.0, 6.0):
        assert receive(agreed(), urgent, OURS, now) == [(PEER, urgent.hex())]
    assert judp.peek_priority(bytes.fromhex("02 c00900 0109 ff20 0700")) == Priority.STANDARD


def test_the_largest_packets_stay_within_4096_bytes() -> None:
    core = agreed()
    for payload in (4079, 4080, 4985):
        data = judp.pack(Packet(HERE, FAR, bytes(payload), 1, Priority.HIGH))
        ((_, sent),) = receive(core, data, OURS)
        assert len(sent) // 2 == (4096 if payload == 4079 else len(data))


def test_probes_are_empty_bounded_and_optional() -> None:
    core = known(node("propose"))
    asked = (PEER, plain("02 401000 0009 01 01016500 02016400 0000"))
    sent = [receive(core, PLAIN, OURS, now / 2) for now in range(40)]
    assert [len(each) for each in sent].count(2) == compression.MAX_PROBES
    assert sent[0] == [asked, (PEER, plain(PLAIN))]
    receive(core, "02 801000 0009 01 02016400 01016500 0000", PEER)
    assert receive(core, PLAIN, OURS)[0][1].startswith("0240")


def test_compression_off_accepts_proposals_as_plain_packets() -> None:
    core = node("off")
    assert receive(core, "02 401200 0509 01 02016400 01016500 0220 0700", PEER) == [
        (OURS, plain("02 001000 01 02016400 01016500 0220 0700"))
    ]
    for flags in ("80", "c0"):
        assert receive(core, f"02 {flags}1200 0509 01 02016400 01016500 0520 0800", PEER) == []
    assert core.counters["dropped.malformed.compressed"] == 2


def test_a_template_in_use_is_not_redefined() -> None:
    """Otherwise whoever forges the address of a peer gives its packets other destinations."""
    core = node()
    proposal = "02 401200 0509 01 02016400 01016500 0220 0700"
    receive(core, proposal, PEER)
    poisoned = "02 401200 0509 01 03016400 01016500 0220 0700"
    compressed, meant = "02 c00900 0509 0520 0800", plain("02 001000 01 02016400 01016500 0520 0800")
    for now in (1.0, 20.0, 40.0, 69.0):
        assert not any(out.startswith("0280") for _, out in receive(core, poisoned, PEER, now))
        assert receive(core, compressed, PEER, now) == [(OURS, meant)]
        assert receive(core, proposal, PEER, now)[0][1].startswith("0280"), "the same one is confirmed"
    assert core.counters["compression.not_accepted"] == 4
    assert receive(core, poisoned, PEER, 100.0)[0][1].startswith("0280"), (
        "of a peer that was restarted, after a silence"
    )


def test_broadcast_and_oversized_templates_are_rejected() -> None:
    core = node()
    broadcast = "02 401200 0509 09 ffffffff 01016500 0220 0700"
    assert receive(core, broadcast, PEER) == [(OURS, plain("02 001000 09 ffffffff 01016500 0220 0700"))]
    for length in (0, templates.MAX_TEMPLATE_LENGTH + 1, 255):
        data = bytes.fromhex("02 403900") + bytes([7, length]) + bytes.fromhex("01 02016400 01016500") + bytes(43)
        assert [port for port, _ in receive(core, data, PEER)] == [OURS]
    assert core.counters["compression.not_accepted"] == 4


def test_templates_and_peers_are_bounded() -> None:
    core = node()
    chance = random.Random(1)
    for number in range(3 * templates.MAX_TEMPLATES):
        peer = UdpPort(f"10.1.{number % 100}.1", 3794)
        head = bytes.fromhex("02 401200") + bytes([number & 0xFF, 9, 1]) + bytes.fromhex("02016400")
        receive(core, head + chance.randbytes(4) + b"\x02\x20\x07\x00", peer, number / 1000)
    used = core._egress.compression
    assert used is not None
    assert len(used._templates._known) == templates.MAX_TEMPLATES
    assert len(used._partners) == compression.MAX_PARTNERS


def test_numbers_are_reused_only_after_a_delay() -> None:
    offers = templates.OfferedTemplates()
    first = [offers.offer_for(bytes([n]) * 9, 0.0) for n in range(templates.MAX_OFFERS)]
    assert {each.number for each in first if each} == set(range(1, templates.MAX_OFFERS + 1))
    assert offers.offer_for(b"x" * 9, templates.REUSE_DELAY - 1) is None
    again = offers.offer_for(b"x" * 9, templates.REUSE_DELAY)
    assert again is not None
    assert (again.number, again.is_accepted(templates.REUSE_DELAY)) == (1, False)


@given(st.lists(st.binary(max_size=40), max_size=8), st.sampled_from([b"\x40", b"\x80", b"\xc0"]))
def test_arbitrary_bytes_raise_protocol_errors_only(datagrams: list[bytes], flags: bytes) -> None:
    made = Compression(Counters(logging.getLogger()), lambda port, data: None)
    for rest in datagrams:
        for data in (b"\x02" + flags + rest, b"\x02" + flags + bytes([len(rest) + 1, 0]) + rest[2:]):
            try:
                plain = made.expand(data, PEER, 0.0)
            except ProtocolError:
                continue
            judp.unpack_all(plain)


class Cable:
    """Two node managers, each with a component, and datagrams that are late, lost, doubled and out of order."""

    def __init__(self, seed: int, *, loss: float) -> None:
        self.chance = random.Random(seed)
        self.loss = loss
        self.now = 0.0
        self.nodes: list[Router] = []
        self.arrived: list[list[bytes]] = [[], []]
        self._air: list[tuple[float, int, int, bytes]] = []
        for _ in range(2):
            self.nodes.append(node())
        self.restart(0, "propose")
        self.restart(1)
        self.bytes_sent = 0

    def restart(self, side: int, use: CompressionUse = "accept") -> None:
        id, other = ((HERE, FAR), (FAR, HERE))[side]
        static = {other: (UdpPort(f"10.0.0.{2 - side}", 3794),)}
        self.nodes[side] = Router("/root", compression=use, addresses=static)
        self.nodes[side].receive(junior.connect(id), OURS, self.now)
        self.nodes[side].poll_output()

    def send(self, side: int, data: bytes) -> None:
        self.nodes[side].receive(data, OURS, self.now)
        self._collect()

    def run(self, seconds: float) -> None:
        end = self.now + seconds
        while self._air and self._air[0][0] <= end:
            self.now, _, side, data = heapq.heappop(self._air)
            self.nodes[side].receive(data, UdpPort(f"10.0.0.{2 - side}", 3794), self.now)
            self._collect()
        self.now = end

    def _collect(self) -> None:
        for side, core in enumerate(self.nodes):
            for port, data in core.poll_output():
                if isinstance(port, LocalPort):
                    self.arrived[side].append(data)
                    continue
                self.bytes_sent += len(data)
                for _ in range(1 + (self.chance.random() < 0.1)):
                    if self.chance.random() >= self.loss:
                        late = self.now + 0.02 * self.chance.random()
                        heapq.heappush(self._air, (late, self.chance.getrandbits(60), 1 - side, data))


def conversation(cable: Cable, disturb: Callable[[int], None]) -> tuple[list[bytes], list[bytes]]:
    """Packets of all kinds both ways; what was sent to each side."""
    sent: tuple[list[bytes], list[bytes]] = ([], [])
    for number in range(3000):
        source, destination, side = ((HERE, FAR, 0), (FAR, HERE, 1))[number % 2]
        chance = cable.chance
        packet = Packet(
            source,
            destination,
            b"\x02\x20" + chance.randbytes(chance.randrange(40)),
            number,
            chance.choice(tuple(Priority)),
            ack=chance.choice((Ack.NONE, Ack.REQUIRED, Ack.ACK)),
        )
        sent[1 - side].append(judp.pack(packet))
        cable.send(side, sent[1 - side][-1])
        cable.run(0.01)
        disturb(number)
    cable.run(1.0)
    return sent


@pytest.mark.parametrize("loss", [0.0, 0.2])
def test_bad_network_delivers_only_sent_packets(loss: float) -> None:
    cable = Cable(7, loss=loss)
    sent = conversation(cable, lambda _: None)
    for side in range(2):
        assert set(cable.arrived[side]) <= set(sent[side])
        assert cable.nodes[side].counters["compression.received"] > 500
        if not loss:
            assert set(cable.arrived[side]) == set(sent[side])


def test_restart_loses_few_packets_and_corrupts_none() -> None:
    cable = Cable(3, loss=0.0)

    def restart(number: int) -> None:
        if number in (1000, 2000):
            cable.restart(number // 1000 - 1)

    sent = conversation(cable, restart)
    for side in range(2):
        assert set(cable.arrived[side]) <= set(sent[side])
        assert len(set(sent[side]) - set(cable.arrived[side])) < 20
    assert cable.nodes[0].counters["compression.refused"] > 0, "the other one compressed until it was told"
