"""Packets that steps make field by field, to test how a node manager and an endpoint handle them."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from functools import partial
from typing import Any, Final

from jauspy.conformance.profile import Action, Step
from jauspy.conformance.results import Late, Silent
from jauspy.conformance.tester import HARMLESS_QUERIES, Client, Tester, is_answer
from jauspy.ids import JausID, message_id
from jauspy.ocu.replies import REPORT_OFFSET
from jauspy.protocol import header
from jauspy.protocol.header import Ack, DataFlag, Packet

FIRST_NUMBER: Final = 0x8000
"""First sequence number of raw packets, above that of the wire; far from those of the clients' endpoints."""
MAX_ARRIVALS: Final = 1024
"""Packets from the component that are kept in one step; far more than any step needs."""
SETTLE_TIME: Final = 0.1
"""Timeouts to wait for packets that must not come."""


class RawSender:
    """Sends packets of one client to the component under test, and counts what comes back."""

    def __init__(self, tester: Tester, client: str) -> None:
        self.tester = tester
        self.client: Client = tester.client(client)
        self.component = tester.component
        self.ping: bytes = tester.recall("ping", "the target answers no query")
        self._arrivals: list[tuple[Packet, bool]] = []
        tester.listeners.append(self._on_packet)

    def number(self, count: int = 1) -> int:
        """Reserve `count` unused sequence numbers; returns the first."""
        memory = self.tester.memory
        first: int = memory.get("number", self.tester.link.first_sequence + FIRST_NUMBER & 0xFFFF)
        memory["number"] = first + count & 0xFFFF
        return first

    def packet(self, payload: bytes | None = None, **fields: Any) -> Packet:
        """A packet with a query to the component; `fields` replace parts of it."""
        usual = Packet(self.client.id, self.component, self.ping if payload is None else payload, self.number())
        return replace(usual, **fields)

    def send(self, *packets: Packet) -> None:
        """Send all packets in one datagram, after one version byte."""
        self.raw(b"\x02" + b"".join(header.pack(packet) for packet in packets))

    def raw(self, datagram: bytes) -> None:
        """Send any bytes as a datagram."""
        self.client.raw(datagram)

    def received(self, ack: Ack = Ack.NONE) -> list[Packet]:
        """The packets with these ACK bits that the component sent to this client in this step, in order."""
        return [packet for packet, _ in self.arrivals() if packet.ack is ack]

    def arrivals(self) -> list[tuple[Packet, bool]]:
        """All packets from the component to this client, each with True if it arrived on the second UDP port."""
        return self._arrivals

    def _on_packet(self, packet: Packet, other_port: bool) -> None:
        expected = packet.source == self.component and packet.destination == self.client.id
        if expected and _is_reply(packet) and len(self._arrivals) < MAX_ARRIVALS:
            self._arrivals.append((packet, other_port))

    def answers(self) -> list[Packet]:
        """The answers to the ping."""
        code = (message_id(self.ping) + REPORT_OFFSET).to_bytes(2, "little")
        return [packet for packet in self.received() if packet.payload[:2] == code]

    def expect(self, count: int, what: str) -> None:
        """Expect exactly `count` answers to the ping. Raises `Late` if they arrive within twice the timeout."""
        self.tester.expected.append(what)
        deadline = self.tester.now + self.tester.timeout
        if not self.tester.pump(deadline, lambda: len(self.answers()) >= count):
            self._wait_for_late(count, what, deadline)
        self.tester.wait(SETTLE_TIME * self.tester.timeout)
        self._compare(what, count, len(self.answers()))

    def _wait_for_late(self, count: int, what: str, deadline: float) -> None:
        if self.tester.pump(deadline + self.tester.timeout, lambda: len(self.answers()) >= count):
            late = f"{self.tester.now - deadline:.2f} s after the deadline of {self.tester.timeout:g} s"
            self.tester.record_check(what, late)
            raise Late(f"{what}: it came {late}")

    def expect_none(self, what: str) -> None:
        """Expect no packet at all, and that the component still answers another client."""
        self.tester.expected.append(what)
        self.tester.wait(SETTLE_TIME * self.tester.timeout)
        check_others_are_answered(self.tester)
        self._compare(what, 0, len(self.arrivals()))

    def expect_acks(self, numbers: Iterable[int], what: str) -> None:
        """Expect an ACK for each of these sequence numbers."""
        wanted = list(numbers)
        self.tester.expected.append(what)
        self.tester.pump(self.tester.now + self.tester.timeout, lambda: len(self.received(Ack.ACK)) >= len(wanted))
        got = [packet.sequence for packet in self.received(Ack.ACK)]
        if wanted and not got:
            self.tester.record_check(what, "no ACK")
            raise Silent(f"no ACK came: {what}")
        self.tester.check(what, "" if got == wanted else f"ACKs came for {got}, not for {wanted}")

    def _compare(self, what: str, wanted: int, got: int) -> None:
        if wanted and not got:
            self.tester.record_check(what, "nothing came")
            raise Silent(f"nothing came: {what}")
        self.tester.check(what, "" if got == wanted else f"{got} came, not {wanted}: {what}")


def _is_reply(packet: Packet) -> bool:
    """True unless the packet is a query or event of the target itself."""
    return len(packet.payload) < 2 or is_answer(message_id(packet.payload))


def check_others_are_answered(tester: Tester) -> None:
    """Check that the component still answers a client that was not involved."""
    bystander = RawSender(tester, "42.9.9")
    bystander.send(bystander.packet())
    tester.pump(tester.now + tester.timeout, lambda: bool(bystander.answers()))
    problem = "" if bystander.answers() else f"{bystander.component} answers no other client any more"
    tester.check("others are still answered", problem)


def find_ping(tester: Tester) -> None:
    """Find the first harmless query that the target answers; the other steps use it as `ping`."""
    client = tester.client("42.1.1")
    for ping in HARMLESS_QUERIES:
        client.send(ping)
        report = ping.CODE + REPORT_OFFSET
        if tester.pump(tester.now + tester.timeout, partial(_has, client, report)):
            tester.memory["ping"] = ping.encode()
            tester.record_check("a query is answered")
            return
    tester.record_check("a query is answered", "none is")
    raise Silent(f"none of {', '.join(query.NAME for query in HARMLESS_QUERIES)} was answered")


def _has(client: Client, code: int) -> bool:
    return any(packet.code == code for packet in client.pending)


def fragments(sender: RawSender, payload: bytes, *cuts: int, ack: Ack = Ack.NONE) -> list[Packet]:
    """The packets of a payload that is cut at these places, with consecutive numbers."""
    ends = [*cuts, len(payload)]
    first = sender.number(len(ends))
    flags = [DataFlag.FIRST, *[DataFlag.MIDDLE] * (len(ends) - 2), DataFlag.LAST]
    starts = [0, *cuts]
    return [
        sender.packet(payload[start:end], sequence=first + number & 0xFFFF, data_flag=flag, ack=ack)
        for number, (start, end, flag) in enumerate(zip(starts, ends, flags, strict=True))
    ]


def other_subsystem(id: JausID) -> JausID:
    """An id whose subsystem differs in the upper byte alone: for some node managers 100 and 356 are the same."""
    return JausID(id.subsystem ^ 0x0100, id.node, id.component)


A: Final = "42.1.1"
B: Final = "42.2.1"
"""Two clients."""
UNKNOWN_MESSAGE: Final = bytes.fromhex("ffee")
"""A message id that no standard defines."""

PacketTest = Callable[[RawSender], None]


def with_packets(test: PacketTest, client: str = A) -> Action:
    """Make a step from a function of a `RawSender`."""
    return lambda tester: test(RawSender(tester, client))


def answered(**fields: Any) -> Action:
    """Send a query with these header fields; it must be answered once."""

    def test(sender: RawSender) -> None:
        sender.send(sender.packet(**fields))
        sender.expect(1, "one answer")

    return with_packets(test)


def step(id: str, title: str, action: Action, *features: str) -> Step:
    """Make a step of this profile; `features` are those that it requires of the wire."""
    return Step(id, title, action, why="AS5669A", wants=frozenset(features))
