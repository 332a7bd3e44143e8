"""Each diagnosis of the network and of one component, by a peer on loopback with that fault."""

from __future__ import annotations

import errno
import os
import socket
import time
from collections.abc import Callable
from contextlib import ExitStack
from datetime import UTC, datetime, timedelta

import pytest
from tests.helpers.udp_peer import GROUP, PEER, Faults, UdpPeer, udp_peer

from jauspy.ids import EVERYONE, JausID
from jauspy.inspection.doctor.findings import Finding, Severity
from jauspy.inspection.doctor.network import check_duplicates, check_group, check_network, check_sending, check_ttl
from jauspy.inspection.doctor.peer import PeerExamination, check_peer_clock
from jauspy.inspection.doctor.probe import Probe
from jauspy.messages.core import ReportStatus, ReportTime
from jauspy.messages.operators import RejectCommand
from jauspy.protocol import judp
from jauspy.protocol.header import Packet
from jauspy.transport import multicast

DOCTOR = JausID(42, 1, 2)
SEALING = (("urn:jauspy:operators:CommandSeal", 1, 0), ("urn:jaus:jss:core:Time", 1, 0))
Examine = Callable[..., dict[str, Finding]]


def discovered(probe: Probe, peer: UdpPeer) -> None:
    """Discovery, until the peer has answered; multicasts that it ignores were sent when they came back here."""
    deadline = time.monotonic() + 20.0
    while not probe.own_multicast or not (probe.replies or peer.faults.ignores_multicast):
        assert time.monotonic() < deadline
        probe.discover(0.05)


@pytest.fixture
def examine(free_port: int) -> Examine:
    """Examine a peer with faults; the findings that are not well, by the name of the check."""

    def run(
        *, own_authority: int = 127, known: bool = False, key: object = None, **faults: object
    ) -> dict[str, Finding]:
        with udp_peer(free_port, **faults) as peer, Probe([DOCTOR], ["127.0.0.1"], GROUP, free_port) as probe:
            discovered(probe, peer)
            examination = PeerExamination(probe, PEER, peer.address if known else None, own_authority, key)
            found = [*check_network(probe), *examination.findings()]
        assert all(finding.fix for finding in found if finding.severity is not Severity.OK)
        return {finding.check: finding for finding in found if finding.severity is not Severity.OK}

    return run


def test_healthy_peer_has_no_findings(examine: Examine) -> None:
    assert examine() == {}


def test_nobody(free_port: int) -> None:
    with Probe([DOCTOR], ["127.0.0.1"], GROUP, free_port) as probe:
        probe.discover(0.1)
        found = [*check_network(probe), *PeerExamination(probe, PEER, None, 127).findings()]
    failed = [finding.check for finding in found if finding.severity is Severity.FAIL]
    assert failed == ["discovery", "peer"]


def test_another_id_of_its_subsystem(free_port: int) -> None:
    with udp_peer(free_port) as peer, Probe([DOCTOR], ["127.0.0.1"], GROUP, free_port) as probe:
        discovered(probe, peer)
        (finding,) = PeerExamination(probe, JausID(101, 1, 9), None, 127).findings()
    assert finding.what == "101.1.9 did not answer discovery, but others of subsystem 101 did"
    assert "101.1.1" in finding.evidence


def test_filtered_multicasts(examine: Examine) -> None:
    found = examine(ignores_multicast=True, known=True)
    assert found["multicast"].what == "101.1.1 answers unicasts, but no multicasts"


def test_filtered_unicasts(examine: Examine) -> None:
    assert "101.1.1 answers multicasts only" in examine(ignores_unicast=True)["peer"].what


def test_port_without_program(free_port: int) -> None:
    with Probe([DOCTOR], ["127.0.0.1"], GROUP, free_port) as probe:
        (finding,) = PeerExamination(probe, PEER, ("127.0.0.1", free_port), 127).findings()
    assert finding.what == f"no program has UDP port {free_port} on 127.0.0.1"


def test_source_port(examine: Examine) -> None:
    assert "answers come from other ports" in examine(other_port=True)["source port"].what


def test_routers_on_the_way(examine: Examine) -> None:
    near, far = examine(ttl=62)["TTL"], examine(ttl=40)["TTL"]
    assert (near.severity, near.evidence) == (Severity.WARN, "2 routers by the TTL of its answers")
    assert (far.severity, far.what) == (Severity.FAIL, "multicasts do not reach 127.0.0.1")


def test_multicasts_with_a_short_ttl(free_port: int) -> None:
    with Probe([DOCTOR], ["127.0.0.1"], GROUP, free_port) as probe:
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as other:
            multicast.prepare_sender(other, "127.0.0.1", 1)
            other.sendto(judp.pack(Packet(PEER, EVERYONE, b"\x00\x2b\x04")), (GROUP, free_port))
            probe.listen(20.0, until=lambda: bool(probe.group_heard))
        (finding,) = check_ttl(probe)
    assert finding.what == "multicasts of 127.0.0.1 have a TTL of 1"


def test_multicasts_that_a_firewall_of_this_machine_drops(free_port: int) -> None:
    with Probe([DOCTOR], ["127.0.0.1"], GROUP, free_port) as probe:
        membership = socket.inet_aton(GROUP) + socket.inet_aton("127.0.0.1")
        assert probe._group_socket is not None  # to it nothing arrives from now on, as behind a firewall
        probe._group_socket.setsockopt(socket.IPPROTO_IP, socket.IP_DROP_MEMBERSHIP, membership)
        probe.discover(0.1)
        (finding,) = check_group(probe)
    assert (finding.check, finding.severity) == ("firewall", Severity.FAIL)


def test_a_firewall_that_lets_nothing_out(free_port: int, monkeypatch: pytest.MonkeyPatch) -> None:
    def rejected(*_: object) -> int:
        raise PermissionError(errno.EPERM, os.strerror(errno.EPERM))  # as a rule of the chain output that drops

    with Probe([DOCTOR], ["127.0.0.1"], GROUP, free_port) as probe:
        monkeypatch.setattr(socket.socket, "sendto", rejected)
        probe.discover(0.1)
        (finding,) = check_sending(probe)
    assert (finding.check, finding.severity) == ("firewall", Severity.FAIL)
    assert finding.what == "nothing can be sent by 127.0.0.1: Operation not permitted"


def test_group_whose_port_is_taken(free_port: int) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as jts:
        jts.bind(("0.0.0.0", free_port))
        with Probe([DOCTOR], ["127.0.0.1"], GROUP, free_port) as probe:
            (finding,) = check_group(probe)
    assert finding.what == f"{GROUP}:{free_port} could not be listened to: Address already in use"


def test_packets_that_are_not_as5669a(free_port: int) -> None:
    with Probe([DOCTOR], ["127.0.0.1"], GROUP, free_port) as probe:
        (sock,) = probe._sockets
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as other:
            other.sendto(b"\x07 what is this", sock.getsockname())
            probe.listen(20.0, until=lambda: bool(probe.malformed))
        assert "header" in {finding.check for finding in check_network(probe)}


def test_component_255(examine: Examine) -> None:
    assert examine(ignores_wildcard=True)["component 255"].what == "101.1.1 ignores messages to 101.1.255"


def test_large_datagrams_that_are_lost(examine: Examine) -> None:
    assert examine(drops_large=True)["fragments"].what == "large datagrams do not reach 101.1.1"


def test_fragments_that_are_lost(examine: Examine) -> None:
    assert examine(incomplete=True)["fragments"].what == "large messages of 101.1.1 do not become complete"


def test_duplicate_id(free_port: int) -> None:
    with ExitStack() as stack:
        for host in ("127.0.0.1", "127.0.0.2"):
            stack.enter_context(UdpPeer(free_port, Faults(), host=host))
        probe = stack.enter_context(Probe([DOCTOR], ["127.0.0.1"], GROUP, free_port))
        while len({reply.address for reply in probe.replies}) < 2:
            probe.discover(0.2)
        (finding,) = check_duplicates(probe.replies)
    assert finding.what == "101.1.1 is used twice"
    assert finding.evidence == f"answers from 127.0.0.1:{free_port}, 127.0.0.2:{free_port}"


def test_held_by_another_client_with_more_authority(examine: Examine) -> None:
    found = examine(holder=(42, 1, 7), authority=200)
    assert found["authority"].severity is Severity.FAIL
    assert "held by 42.1.7 with authority 200, and an authority of 127 is too low" in found["authority"].what.replace(
        "control of 101.1.1 is ", ""
    )


def test_held_by_another_client_with_less_authority(examine: Examine) -> None:
    found = examine(holder=(42, 1, 7), authority=100)
    assert found["control"].severity is Severity.WARN
    assert found["control"].what == "control of 101.1.1 is held by 42.1.7 with authority 100"


def test_authority_too_low_for_the_component(examine: Examine) -> None:
    assert examine(authority=200, holder=(0, 0, 0))["authority"].what == (
        "an authority of 127 is too low for 101.1.1, which needs 200"
    )


def test_no_access_control(examine: Examine) -> None:
    assert examine(silent_to=frozenset({"QueryControl"}))["control"].what == "101.1.1 does not tell who controls it"


def test_versions(examine: Examine) -> None:
    found = examine(services=(("urn:jaus:jss:core:Time", 9, 3),))
    assert found["versions"].what == "101.1.1 has urn:jaus:jss:core:Time 9.3, and jauspy has 1.0 and 1.1"
    found = examine(services=(("urn:vendor:Lights", 1, 0),))
    assert found["versions"].what == "1 services of 101.1.1 are not known here"
    assert examine(services=())["versions"].what == "101.1.1 reports no services of its own"
    silent = examine(silent_to=frozenset({"QueryServices"}))
    assert silent["versions"].what == "101.1.1 does not report its services"


def test_presence_vector(examine: Examine) -> None:
    assert examine(presence=3)["presence vector"].evidence == "asked for 0x1, and the report has 0x3"
    assert "presence vector" in examine(silent_to=frozenset({"QueryTime"}))


def test_clock(examine: Examine) -> None:
    found = examine(clock=timedelta(seconds=-100))
    assert found["clock"].severity is Severity.FAIL
    assert found["clock"].what.startswith(("its clock differs from ours by -1", "its clock has another date"))


@pytest.mark.parametrize(("day", "hour", "minutes", "difference"), [(31, 23, 59, -60.0), (1, 0, 1, 60.0)])
def test_clocks_around_the_end_of_a_month(day: int, hour: int, minutes: int, difference: float) -> None:
    report = ReportTime(ReportTime.TimeStamp(0, 0, minutes, hour, day))
    finding = check_peer_clock(report, datetime(2026, 11, 1, tzinfo=UTC))
    assert finding.what == f"its clock differs from ours by {difference:+.1f} s"


def test_status(examine: Examine) -> None:
    found = examine(status=ReportStatus.Status.EMERGENCY)
    assert found["status"].what == "101.1.1 is in Emergency, where it does not move"


def test_truncated_answer(examine: Examine) -> None:
    found = examine(truncated=True)
    assert found["content"].what == "its ReportStatus differs from the definition"


def test_seals(examine: Examine) -> None:
    pytest.importorskip("cryptography")
    from jauspy.protocol.seal import OperatorKey

    key = OperatorKey.generate()
    refused = examine(seal=RejectCommand.Reason.UNKNOWN_OPERATOR, services=SEALING, key=key)["seal"]
    assert refused.what == "101.1.1 refuses what is sealed with this key: its key is not in the operators file"
    assert "seal" not in examine(seal="taken", services=SEALING, key=key)
    assert examine(seal="taken", services=SEALING)["seal"].severity is Severity.WARN
    assert examine(key=key)["seal"].what == "101.1.1 takes no sealed commands"


def test_nothing_but_queries_is_sent(free_port: int) -> None:
    with udp_peer(free_port) as peer, Probe([DOCTOR], ["127.0.0.1"], GROUP, free_port) as probe:
        probe.discover(0.2)
        list(PeerExamination(probe, PEER, None, 255).findings())
    codes = {int.from_bytes(packet.payload[:2], "little") for packet in peer.received}
    assert codes
    assert {f"{code:04X}" for code in codes} == {"2B00", "2B03", "200D", "2001", "2002", "2011"}
