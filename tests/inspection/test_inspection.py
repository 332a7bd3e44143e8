"""Messages one by one, their rates, and who talks to whom."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Iterator

import pytest

from jauspy.capture.reader import Datagram
from jauspy.ids import JausID
from jauspy.inspection.graph import Graph
from jauspy.inspection.rates import BEYOND, MAX_ROWS, Rates
from jauspy.inspection.traffic import COPY_TIME, MAX_REMEMBERED, seen_messages
from jauspy.messages import registry
from jauspy.messages.core import QueryStatus, ReportStatus
from jauspy.protocol import judp, junior
from jauspy.protocol.header import Ack, DataFlag, Packet

OCU, ROBOT = JausID(42, 1, 1), JausID(101, 1, 102)
REPORT = ReportStatus.from_dict({"status": "READY", "reserved": 0}).encode()


def datagram(time: float, payload: bytes = REPORT, sequence: int = 1, **header) -> Datagram:
    packet = Packet(ROBOT, OCU, payload, sequence, **header)
    return Datagram(1, time, ("10.0.0.1", 3794), ("10.0.0.2", 3794), judp.pack(packet))


def seen(*datagrams: Datagram, **options: bool) -> list[tuple[float, str]]:
    return [(message.time, message.name) for message in seen_messages(datagrams, registry, **options)]


def test_copies_for_several_receivers_are_one_message() -> None:
    copies = [datagram(1.0), datagram(1.001), datagram(1.002, sequence=2)]
    assert seen(*copies) == [(1.0, "ReportStatus"), (1.002, "ReportStatus")]
    assert len(seen(*copies, copies=True)) == 3
    assert len(seen(datagram(1.0), datagram(1.0 + 2.0 * COPY_TIME))) == 2


def test_what_is_remembered_of_copies_is_bounded() -> None:
    many = [datagram(1.0 + number * 1e-6, sequence=number) for number in range(MAX_REMEMBERED + 1)]
    assert len(seen(*many, datagram(1.01, sequence=0))) == MAX_REMEMBERED + 2


def test_names_of_what_is_no_whole_message() -> None:
    assert [name for _, name in seen(
        datagram(1.0, b"", ack=Ack.ACK),
        datagram(1.0, b"abc", data_flag=DataFlag.FIRST),
        datagram(1.0, b"\xee\xee"),
        datagram(2.0, b""),
    )] == ["(acknowledgement)", "(fragment)", "(EEEEh)", "(empty)"]  # fmt: skip


def test_registrations_are_left_out() -> None:
    local = ("127.101.1.102", 3794)
    assert seen(Datagram(1, 1.0, local, local, junior.accept(ROBOT))) == []


def rates_of(datagrams: Iterator[Datagram]) -> Rates:
    rates = Rates()
    for message in seen_messages(datagrams, registry):
        rates.add(message)
    return rates


def test_rates() -> None:
    times = [10.0, 10.1, 10.3, 10.4]
    rates = rates_of(datagram(time, sequence=number) for number, time in enumerate(times))
    ((route, rate),) = rates.routes.items()
    assert route == ("101.1.102", "42.1.1", "ReportStatus")
    assert rate.frequency == pytest.approx(7.5)
    assert (rate.shortest, rate.longest) == pytest.approx((0.1, 0.2))
    assert rate.jitter == pytest.approx(0.0471, abs=1e-4)
    assert (rate.count, rate.bytes, rates.seconds) == (4, 4 * (14 + len(REPORT)), pytest.approx(0.4))


def test_a_single_message_has_no_rate() -> None:
    ((_, rate),) = rates_of(iter([datagram(1.0)])).routes.items()
    assert (rate.frequency, rate.jitter) == (None, None)


@pytest.mark.slow
def test_the_number_of_routes_is_bounded() -> None:
    rates = Rates()
    for number in range(MAX_ROWS + 5):
        packet = Packet(JausID.from_int(number), OCU, REPORT, 1)
        row = Datagram(1, float(number), ("1.1.1.1", 1), ("1.1.1.2", 1), judp.pack(packet))
        for message in seen_messages([row], registry):
            rates.add(message)
    assert len(rates.routes) == MAX_ROWS + 1
    assert rates.routes[BEYOND, BEYOND, BEYOND].count == 5


def talk() -> Graph:
    query = Packet(OCU, ROBOT, QueryStatus().encode(), 1)
    rows = [Datagram(1, 0.0, ("1.1.1.1", 1), ("1.1.1.2", 1), judp.pack(query)), datagram(1.0), datagram(2.0)]
    return Graph(rates_of(iter(rows)))


def test_who_talks_to_whom() -> None:
    graph = talk()
    assert graph.components == ["42.1.1", "101.1.102"]
    first, second = graph.lines()
    assert first.split() == ["101.1.102", "→", "42.1.1", "1.0/s", "ReportStatus", "1/s"]
    assert "QueryStatus" in second
    assert '"42.1.1" -> "101.1.102" [label="QueryStatus 0.5/s"];' in graph.dot()


def test_the_drawing_is_xml_with_each_component() -> None:
    tree = ET.fromstring(talk().svg())
    texts = [element.text for element in tree.iter("{http://www.w3.org/2000/svg}text")]
    assert {"42.1.1", "101.1.102", "1/s", "ReportStatus"} <= set(texts)
