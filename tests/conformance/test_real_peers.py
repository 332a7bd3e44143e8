"""What components of other vendors do that is right: no false alarms, and no endless runs."""

from __future__ import annotations

import contextlib
import socket
import threading
import time
from collections.abc import Iterable
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import pytest
from tests.conformance.injectors import code, deaf_to
from tests.conformance.simulated import examined, robot

from jauspy.conformance import TargetComponent, Verdict, VirtualTarget, find, run
from jauspy.conformance.known_deviations import with_known_deviations
from jauspy.conformance.link import NodeManagerLink, UdpLink, random_sequence
from jauspy.conformance.profile import Offers
from jauspy.ids import JausID
from jauspy.inspection.peers import FKIE, JTS, PeerKind
from jauspy.messages.core import QueryControl, ReportStatus
from jauspy.protocol import judp, junior
from jauspy.protocol.header import Packet
from jauspy.services.core import AccessControl, Events, Liveness, Management, Time
from jauspy.services.host import Host

COMPONENT = JausID(105, 1, 1)


class Remembering(VirtualTarget):
    """Drops packets whose source and number it has seen, for long."""

    seen: set[tuple[JausID, int]]

    def inbound(self, datagram: bytes) -> Iterable[bytes]:
        packets, _ = judp.unpack_all(datagram)
        if any((each.source, each.sequence) in self.seen for each in packets):
            return ()
        self.seen |= {(each.source, each.sequence) for each in packets}
        return (datagram,)


def test_second_run_is_heard_by_a_peer_that_remembers_sequence_numbers():
    seen: set[tuple[JausID, int]] = set()
    for number in range(2):
        target = robot(virtual_target=type("_", (Remembering,), {"seen": seen, "first_sequence": 1000 * number}))
        report = examined("transport", target, COMPONENT, only=("query", "unicast", "repeat"))
        assert report.counts[Verdict.PASS] == 3


def test_sequence_numbers_begin_at_random_on_networks(free_port):
    wires = [make() for make in 3 * [lambda: UdpLink(port=free_port), lambda: NodeManagerLink("local:/nowhere")]]
    for each in wires:
        each.close()
    assert len({each.first_sequence for each in wires}) > 1
    assert len({random_sequence() for _ in range(20)}) > 10


def test_datagrams_wait_for_a_node_manager_that_does_not_read(root: Path) -> None:
    sender, payloads = JausID(42, 2, 1), [number.to_bytes(2, "little") for number in range(40)]
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as node:
        node.bind(str(root / junior.SOCKET_NAME))
        accepting = threading.Thread(target=lambda: node.sendto(junior.accept(sender), node.recvfrom(100)[1]))
        accepting.start()
        link = NodeManagerLink(f"local:{root}")
        link.join(sender)
        accepting.join()
        for payload in payloads:
            link.send(judp.pack(Packet(sender, COMPONENT, payload)), sender)
        node.setblocking(False)
        arrived: list[bytes] = []
        deadline = time.monotonic() + 10.0
        while len(arrived) < len(payloads) and time.monotonic() < deadline:
            link.receive(time.monotonic() + 0.01)
            with contextlib.suppress(BlockingIOError):
                while datagram := node.recv(100):
                    arrived += [each.payload for each in judp.unpack_all(datagram)[0] if not junior.parse(datagram)]
        link.close()
    assert arrived == payloads


class Lagging(TargetComponent):
    """Its status is right 50 ms after it has changed: another service reports it, which is notified later."""

    shown = b""
    changed_at: float | None = None

    def send(self, outgoing: Any, now: float) -> None:
        if outgoing.payload[:2] == code(ReportStatus):
            if not self.shown or outgoing.payload == self.shown:
                self.changed_at = None
            elif self.changed_at is None:
                self.changed_at = now
            if self.changed_at is None or now - self.changed_at >= 0.05:
                self.shown, self.changed_at = outgoing.payload, None
            outgoing = outgoing._replace(payload=self.shown)
        super().send(outgoing, now)


@pytest.mark.parametrize(
    "step", ["Controlled.Available.Ready/Standby/controller", "table/Management/Controlled.Ready/Standby"]
)
def test_state_that_is_reported_a_little_later_is_right(step):
    report = examined("core-1.1", robot(Lagging, timeout=5), COMPONENT, only=(step,))
    assert {each.verdict for each in report.results} == {Verdict.PASS}, report.failures


@pytest.mark.slow
def test_component_without_an_answer_to_query_control_is_tested_otherwise_within_a_minute():
    part, target, _ = deaf_to(QueryControl)()
    healthy = examined("core-1.1", robot(timeout=5), COMPONENT)
    report = examined("core-1.1", robot(part, target, timeout=5), COMPONENT)
    assert report.seconds < healthy.seconds + 60.0
    assert report.counts[Verdict.PASS] > 0.9 * healthy.counts[Verdict.PASS]
    assert len([each for each in report.results if each.verdict is Verdict.SILENT]) < 6
    assert any("does not answer QueryControl 200Dh" in each for each in report.notes)


class Management10(Management, version="1.0"):
    pass


class Time10(Time, version="1.0"):
    pass


class Liveness10(Liveness, version="1.0"):
    pass


@pytest.mark.slow
def test_services_of_version_1_0_are_tested_as_such_without_discovery():
    services = Management10(), Time10(), Liveness10(), AccessControl(default_authority=10, timeout=5), Events()
    host = Host(COMPONENT, services, utc_now=lambda: datetime(2026, 1, 1, tzinfo=UTC))
    offers = Offers({COMPONENT: frozenset(each.key for each in host.definitions.values())})
    assert {version for _, version in offers.components[COMPONENT]} == {"1.0"}
    target = VirtualTarget([TargetComponent(host)])
    report = run(find("core-1.1"), target, COMPONENT, began=0.0, offers=offers)
    assert (report.problem, report.failures) == ("", ())
    assert report.counts[Verdict.PASS] > 250
    taken = {each.name for each in report.transitions if each.step}
    assert {each for each in taken if "Controlled.StateB: Reset" in each}
    assert {each for each in taken if "Controlled: Timeout [isControlAvailable()]" in each}


def test_target_without_discovery_is_asked_to_name_its_services():
    host = Host(COMPONENT, [Management()], utc_now=lambda: datetime(2026, 1, 1, tzinfo=UTC))
    report = examined("core-1.1", VirtualTarget([TargetComponent(host)]), COMPONENT)
    assert "does not report its services" in report.problem
    assert "--services Management@1.0" in report.problem


class FirstPacketOnly(VirtualTarget):
    """Reads one packet of a datagram, as FKIE's node manager does."""

    def inbound(self, datagram: bytes) -> Iterable[bytes]:
        packets, _ = judp.unpack_all(datagram)
        return [judp.pack(packet) for packet in packets[:1]]


class BytewiseIds(VirtualTarget):
    """Takes 356.1.2 for 100.1.2, as the JAUS Toolset does."""

    def inbound(self, datagram: bytes) -> Iterable[bytes]:
        packets, _ = judp.unpack_all(datagram)
        for packet in packets:
            there = packet.destination
            if there.subsystem != COMPONENT.subsystem and there.subsystem % 256 == COMPONENT.subsystem % 256:
                packet = replace(packet, destination=replace(there, subsystem=COMPONENT.subsystem))  # noqa: PLW2901
            yield judp.pack(packet)


@pytest.mark.parametrize(
    ("virtual_target", "kind", "step"),
    [
        (FirstPacketOnly, FKIE, "packed"),
        (BytewiseIds, JTS, "other-subsystem"),
        (type("_", (Remembering,), {"seen": set()}), JTS, "restart"),
    ],
)
def test_deviations_of_peers_are_known(virtual_target: type[VirtualTarget], kind: PeerKind, step: str) -> None:
    report = examined("transport", robot(virtual_target=virtual_target), COMPONENT, only=("query", step))
    failures = with_known_deviations(report, kind).failures
    assert failures
    assert all(result.known.startswith(f"known of {kind.name.upper()}: ") for result in failures)
