"""Authentication between node managers: challenges, replays and restarts, on a network in memory."""

from __future__ import annotations

from collections import deque

import pytest

from jauspy.errors import ProtocolError
from jauspy.ids import JausID
from jauspy.protocol import authentication, judp
from jauspy.protocol.address_book import Address
from jauspy.protocol.authentication import ANSWER, CHALLENGE, MAGIC, OVERHEAD, Authenticator
from jauspy.protocol.duplicates import REPLAY_WINDOW
from jauspy.protocol.header import Packet

KEY = b"0123456789abcdef"
A, B, C, ATTACKER = (("10.0.0.1", 3794), ("10.0.0.2", 3794), ("10.0.0.3", 3794), ("10.0.0.66", 3794))


def query(number: int) -> bytes:
    return judp.pack(Packet(JausID(42, 1, 1), JausID(101, 1, 1), b"\x02\x20", number))


class Lan:
    """Node managers by address; what was on the wire, and what was dropped why."""

    def __init__(self) -> None:
        self.nodes: dict[Address, Authenticator] = {}
        self.heard: dict[Address, list[bytes]] = {}
        self.wire: list[tuple[bytes, Address, Address]] = []
        self.dropped: list[str] = []
        self.utc = 1000.0
        self._sessions = 0
        for address in (A, B, C):
            self.start(address)

    def start(self, address: Address) -> None:
        """Start, or start again."""
        self._sessions += 1
        self.nodes[address] = Authenticator(KEY, self._sessions, lambda host, _: host == address[0])
        self.heard[address] = []

    def send(self, source: Address, to: Address, datagram: bytes) -> None:
        self.carry(self.nodes[source].sign(datagram, self.utc, to), source, to)

    def multicast(self, source: Address, datagram: bytes) -> None:
        signed = self.nodes[source].sign(datagram, self.utc, None)
        for to in self.nodes:
            if to != source:
                self.carry(signed, source, to)

    def carry(self, data: bytes, source: Address, to: Address) -> None:
        """Carry it, and everything that is sent because of it."""
        waiting = deque([(data, source, to)])
        while waiting:
            data, source, to = waiting.popleft()
            self.wire.append((data, source, to))
            node = self.nodes.get(to)
            if node is None:
                continue
            try:
                datagram = node.verify(data, self.utc, source)
                self.heard[to] += [] if datagram is None else [datagram]
            except ProtocolError as error:
                self.dropped.append(error.reason)
            waiting.extend((answer, to, back) for back, answer in node.poll_output())


@pytest.fixture
def lan() -> Lan:
    return Lan()


def test_the_signed_form_is_as_documented() -> None:
    signed = Authenticator(KEY, 0x0102030405060708).sign(query(1), 1.5, B)
    assert signed[:33].hex() == "a501020304050607080000000000000000000000000000000100000000000005dc"
    assert signed[OVERHEAD:] == query(1)
    assert len(signed) == len(query(1)) + 49


def test_nothing_is_lost_at_the_first_contact_nor_after_a_restart(lan: Lan) -> None:
    lan.send(A, B, query(1))
    lan.send(B, A, query(2))
    lan.multicast(C, query(3))
    assert lan.heard == {A: [query(2), query(3)], B: [query(1), query(3)], C: []}
    challenges = sum(data[0] == CHALLENGE for data, *_ in lan.wire)
    assert challenges <= 6
    lan.start(B)
    lan.utc += 1.0
    for number in range(10):
        lan.send(A, B, query(number))
        lan.send(B, A, query(number))
        lan.utc += 0.25
    assert lan.heard[B] == [query(number) for number in range(10)]
    assert lan.heard[A][-10:] == [query(number) for number in range(10)]
    assert sum(data[0] == CHALLENGE for data, *_ in lan.wire) <= challenges + 3


def test_after_the_first_contact_each_datagram_is_one(lan: Lan) -> None:
    lan.send(A, B, query(1))
    lan.send(B, A, query(1))
    before = len(lan.wire)
    for number in range(100):
        lan.send(A, B, query(number))
        lan.multicast(A, query(number))
    assert len(lan.wire) - before <= 300 + 6  # the first multicast is the first contact with C


def test_what_was_recorded_is_accepted_by_nobody_after_restarts(lan: Lan) -> None:
    for number in range(10):
        lan.send(A, B, query(number))
        lan.send(B, A, query(number))
        lan.multicast(A, query(number))
    recorded = list(lan.wire)
    for restarted in ((), (B,), (A, B), (A,), (C,)):
        lan.utc += 1.0  # what was sent within `RESEND_TIME` before would be sent again
        for node in restarted:
            lan.start(node)
        for address in (A, B, C):
            lan.heard[address].clear()
        for data, source, _ in recorded:
            for to in (A, B, C):
                for pretended in (source, ATTACKER):
                    if to != pretended:
                        lan.carry(data, pretended, to)
            lan.utc += 0.01
        assert not any(lan.heard.values()), restarted
        lan.send(A, B, query(77))
        lan.utc += 1.0
        lan.send(A, B, query(78))
        assert lan.heard[B][-1] == query(78)


def test_an_attacker_who_relays_does_not_become_the_address_of_a_peer(lan: Lan) -> None:
    """It passes on everything in both directions, from its own address."""
    for number in range(20):
        signed = lan.nodes[A].sign(query(number), lan.utc, B)
        before = len(lan.wire)
        lan.carry(signed, ATTACKER, B)
        for data, source, to in lan.wire[before:]:
            if to == ATTACKER:
                lan.carry(data, ATTACKER, A if source == B else B)
        lan.utc += 0.3
    assert lan.heard[B] == []
    assert "not_our_address" in lan.dropped
    answers = [(data, to) for data, _, to in lan.wire if data[0] == ANSWER]
    for data, to in answers:
        lan.carry(data, ATTACKER, to)
    assert lan.heard[B] == []


def test_a_datagram_for_another_node_manager_is_not_accepted(lan: Lan) -> None:
    lan.multicast(A, query(0))
    lan.send(A, B, query(1))
    data = next(data for data, _, to in reversed(lan.wire) if to == B and data[0] == MAGIC)
    lan.carry(data, A, C)
    assert query(1) not in lan.heard[C]


def test_a_datagram_is_accepted_once_and_may_be_overtaken_within_the_window(lan: Lan) -> None:
    lan.send(A, B, query(99))
    lan.heard[B].clear()
    sent = [lan.nodes[A].sign(query(number), lan.utc, B) for number in range(REPLAY_WINDOW + 2)]
    for number in (5, 3, len(sent) - 1, 0, 1, 2, 3, 4, 5):
        lan.carry(sent[number], A, B)
    assert lan.heard[B] == [query(number) for number in (5, 3, len(sent) - 1, 2, 4)]
    assert lan.dropped[-4:] == ["replayed"] * 4


def test_whatever_is_changed_is_noticed() -> None:
    data = Authenticator(KEY, 1).sign(query(1), 1000.0, B)
    for at in range(len(data)):
        changed = data[:at] + bytes([data[at] ^ 1]) + data[at + 1 :]
        assert refused(Authenticator(KEY, 2), changed) in ("forged", "unauthenticated")


def test_other_keys_plain_packets_old_ones_and_our_own_are_refused() -> None:
    sender, receiver = Authenticator(KEY, 1), Authenticator(KEY, 2)
    assert refused(receiver, Authenticator(KEY + b"!", 1).sign(query(1), 1000.0, B)) == "forged"
    assert refused(receiver, query(1)) == "unauthenticated"
    assert refused(receiver, b"") == "unauthenticated"
    assert refused(receiver, sender.sign(query(1), 1000.0 - authentication.MAX_AGE - 1, B)) == "stale"
    assert refused(sender, sender.sign(query(1), 1000.0, B)) == "own"
    assert receiver.poll_output() == []


def make_up_sender(lan: Lan, number: int) -> None:
    lan.nodes[ATTACKER] = Authenticator(KEY, 1000 + number)
    lan.heard[ATTACKER] = []
    lan.send(ATTACKER, B, query(number))


def test_a_peer_that_sends_is_not_displaced_by_senders_that_are_made_up(lan: Lan, monkeypatch) -> None:
    monkeypatch.setattr(authentication, "MAX_SENDERS", 16)
    lan.send(A, B, query(0))
    for number in range(1, 100):
        make_up_sender(lan, number)
        if number % 8 == 0:
            lan.send(A, B, query(number))
    assert len(lan.heard[B]) == 1 + 99 + 99 // 8


def test_a_peer_whose_counters_were_forgotten_has_to_prove_itself(lan: Lan, monkeypatch) -> None:
    monkeypatch.setattr(authentication, "MAX_SENDERS", 16)
    recorded = lan.nodes[A].sign(query(1), lan.utc, B)
    lan.carry(recorded, A, B)
    for number in range(100):
        make_up_sender(lan, number)
    before = len(lan.heard[B])
    lan.carry(recorded, A, B)
    assert len(lan.heard[B]) == before


def test_memory_and_challenges_are_bounded() -> None:
    receiver, sender = Authenticator(KEY, 1), Authenticator(KEY, 2)
    for number in range(3 * authentication.MAX_SENDERS):
        source = (f"10.1.{number >> 8}.{number & 255}", 3794)
        assert refused(receiver, sender.sign(query(1), 1000.0, B), source=source) == "unproven"
        receiver.poll_output()
        receiver.sign(query(number), 1000.0, source)
    for _ in range(1000):
        refused(receiver, sender.sign(query(1), 1000.0, B), source=A)
    assert len(receiver.poll_output()) == 1
    tables = (getattr(receiver, name) for name in ("_sessions", "_confirmed", "_proven", "_windows", "_recent"))
    assert max(map(len, tables)) <= authentication.MAX_SENDERS


def refused(receiver: Authenticator, data: bytes, source: Address = A) -> str:
    with pytest.raises(ProtocolError) as error:
        receiver.verify(data, 1000.0, source)
    return error.value.reason
