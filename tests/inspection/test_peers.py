"""Implementations are recognised by bytes that they sent, and are not suspected for bytes of others."""

from __future__ import annotations

from pathlib import Path

import pytest

from jauspy.conformance.known_deviations import recognised, with_known_deviations
from jauspy.conformance.reports import explanation, result_json
from jauspy.conformance.results import Report, Result, Verdict
from jauspy.conformance.trace import Direction, TraceEntry
from jauspy.errors import ConfigError
from jauspy.ids import EVERYONE, JausID
from jauspy.inspection.peers import FKIE, JTS, KINDS, MAX_HOSTS, OPENJAUS, PeerRecogniser, find_kind
from jauspy.messages import registry
from jauspy.protocol.endpoint import Endpoint

TESTS = Path(__file__).parents[1]
GROUP, PEER, HERE = ("239.255.0.1", 3794), ("192.168.1.3", 3794), ("192.168.1.2", 3794)
# Captured from the implementations themselves (docs/peers.md).
PRIORITY_0 = "02001200ff0101650009016400000102030100"
EMPTY = "02000e000900000000000000000000"
PROBE_OF_JTS = "02001800190101650002016400000102030405060708090100"
PROBE_OF_FKIE = "02001800110101650002016400000102030405060708090100"
PROBE_OF_JAUSPY = "0200100019010165000201640002220100"
BROADCAST_OF_JTS = "0200180009ffffffff06016400000102030405060708090100"
BROADCAST_OF_FKIE = "0200180001ffffffff06016400000102030405060708090100"
CONNECT = "010000001006020100000000000100640000000000"
HEARTBEAT = "4a41555330312e30060202420101ffff01010182000075f4"


def names(payload: str, source: tuple[str, int] = PEER, destination: tuple[str, int] = GROUP) -> list[str]:
    recogniser = PeerRecogniser()
    recogniser.see(bytes.fromhex(payload), source, destination)
    return [kind.name for kinds in recogniser.found.values() for kind, _ in kinds]


@pytest.mark.parametrize(
    ("payload", "source", "destination", "expected"),
    [
        (PRIORITY_0, PEER, HERE, ["jts"]),
        (EMPTY, PEER, GROUP, ["jts"]),
        (PROBE_OF_JTS, PEER, GROUP, ["jts"]),
        (PROBE_OF_JTS, PEER, HERE, []),
        (PROBE_OF_JAUSPY, PEER, GROUP, []),
        (BROADCAST_OF_FKIE, ("127.101.1.2", 3794), GROUP, []),  # a component in a recording, before its node manager
        (PROBE_OF_FKIE, PEER, GROUP, []),  # jauspy sends the same
        (BROADCAST_OF_JTS, PEER, GROUP, []),  # everybody sends the same
        (BROADCAST_OF_FKIE, PEER, GROUP, ["fkie"]),
        (CONNECT, ("127.0.0.1", 42079), ("127.0.0.1", 3794), ["fkie"]),
        (CONNECT, ("0.0.0.0", 0), ("0.0.0.0", 0), []),  # a local socket in a recording
        (HEARTBEAT, PEER, HERE, ["openjaus"]),
        (BROADCAST_OF_JTS, PEER, ("224.1.0.1", 3794), ["openjaus"]),
        ("ff", PEER, GROUP, []),
        ("", PEER, GROUP, []),
    ],
)
def test_signs(payload: str, source: tuple[str, int], destination: tuple[str, int], expected: list[str]) -> None:
    assert names(payload, source, destination) == expected


def test_what_jauspy_sends_is_no_sign() -> None:
    endpoint = Endpoint(JausID(42, 1, 2), first_sequence=7)
    endpoint.send(EVERYONE, b"\x00\x2b\x04", now=0.0)
    endpoint.send(JausID(101, 1, 1), bytes(10_000), now=0.0)
    for datagram in endpoint.poll_output():
        assert names(datagram.hex()) == []


def test_capture_of_the_standard_s_own_example() -> None:
    """Two hosts with the JAUS Toolset; its first datagram, to an unknown id, went to the group."""
    first, *others = (TESTS / "golden/sae_management.hex").read_text().split()
    assert names(first, PEER, GROUP) == ["jts"]
    assert not [datagram for datagram in others if names(datagram, PEER, HERE)]


def test_notes() -> None:
    recogniser = PeerRecogniser()
    for _ in range(2):
        recogniser.see(bytes.fromhex(PRIORITY_0), PEER, HERE)
    (note,) = recogniser.notes()
    assert note.startswith("192.168.1.3 looks like JAUS Toolset (Junior), or a fork of it: a control byte of FF")
    assert "Known of JTS: priority 0 is sent with a control byte of FF (J7); " in note


def test_hosts_are_bounded() -> None:
    recogniser = PeerRecogniser()
    for number in range(MAX_HOSTS + 5):
        recogniser.see(bytes.fromhex(PRIORITY_0), (f"10.0.{number // 256}.{number % 256}", 3794), HERE)
    assert len(recogniser.found) == MAX_HOSTS
    assert "10.0.1.0" not in recogniser.found


def test_references_are_rows_of_the_documentation() -> None:
    text = (TESTS.parent / "docs/peers.md").read_text()
    references = {deviation.reference for kind in KINDS.values() for deviation in kind.deviations}
    assert all(f"| {reference} |" in text for reference in references - {"common to all"})
    assert "Common to all: large messages" in text


def test_steps_exist() -> None:
    from jauspy.conformance.profiles.transport import PROFILE

    steps = {step.id for step in PROFILE.steps}
    assert {step for kind in KINDS.values() for deviation in kind.deviations for step in deviation.steps} <= steps


def report(*steps: tuple[str, Verdict], data: str = "", profile: str = "transport") -> Report:
    entries = (TraceEntry(0.1, Direction.RECEIVED, bytes.fromhex(data), registry),) if data else ()
    results = tuple(Result(id, id, verdict) for id, verdict in steps)
    return Report(profile, profile, "101.1.1", 0.0, results=results, entries=entries)


def test_failed_steps_are_marked() -> None:
    steps = (("restart", Verdict.FAIL), ("query", Verdict.FAIL), ("other-subsystem", Verdict.PASS))
    seen = report(*steps, data=PRIORITY_0)
    assert recognised(seen) is JTS
    marked = with_known_deviations(seen, None)
    assert [bool(result.known) for result in marked.results] == [True, False, False]
    assert marked.results[0].known.startswith("known of JTS: the first messages of a restarted client")
    assert explanation(marked.results[0])[-1] == result_json(marked.results[0])["known"] == marked.results[0].known
    assert with_known_deviations(report(*steps), None).notes == ()
    named = with_known_deviations(report(("packed", Verdict.SILENT)), FKIE)
    assert named.results[0].known.startswith("known of FKIE: only the first of several packets")
    other = with_known_deviations(report(("restart", Verdict.FAIL), profile="igvc-2011"), JTS)
    assert other.results[0].known == ""


def test_names() -> None:
    assert find_kind("JTS") is JTS
    assert find_kind("openjaus") is OPENJAUS
    with pytest.raises(ConfigError, match="choose one of jts, fkie, openjaus"):
        find_kind("junior")
