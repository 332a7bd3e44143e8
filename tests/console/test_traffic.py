"""What the console keeps of messages, and how it finds them."""

from __future__ import annotations

import pytest

from jauspy.console.traffic import MAX_KINDS, MAX_OF_KIND, MAX_PAYLOAD, Traffic
from jauspy.errors import ControlRejected
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.core import QueryStatus, ReportStatus
from jauspy.testing import VirtualNetwork

HERE, THERE = JausID(42, 1, 2), JausID(101, 1, 102)


async def test_messages_are_kept_with_their_fields(virtual_network: VirtualNetwork) -> None:
    traffic = Traffic(registry)
    async with virtual_network.robot(), virtual_network.ocu() as ocu, virtual_network.ocu("42.1.9") as other:
        ocu.trace(traffic.note)
        await ocu.query("101.1.102", QueryStatus())
        report, query = traffic.lines("")
        assert (query.kind, query.destination, query.name) == ("sent", "101.1.102", "QueryStatus")
        assert (report.kind, report.source, report.name) == ("received", "101.1.102", "ReportStatus")
        assert isinstance(traffic.decoded(report), ReportStatus)

        async with other.service("101.1.102", "AccessControl").control(200):
            with pytest.raises(ControlRejected):
                async with ocu.service("101.1.102", "AccessControl").control(100):
                    pass
        assert traffic.lines("", "refused")[0].name == "ConfirmControl"
        ocu.trace(None)
        total = traffic.total
        await ocu.query("101.1.102", QueryStatus())
        assert traffic.total == total


def test_the_filter_takes_words_and_words_to_leave_out() -> None:
    traffic = Traffic(registry)
    traffic.note(HERE, THERE, QueryStatus().encode(), sent=True)
    traffic.event("robot 101 has appeared")
    traffic.note(THERE, HERE, b"\xff\xff", sent=False)
    assert [each.name for each in traffic.lines("101")] == ["FFFFh", "robot 101 has appeared", "QueryStatus"]
    assert [each.name for each in traffic.lines("101 -appeared -ffff")] == ["QueryStatus"]
    assert [each.name for each in traffic.lines("101 -ffff", routine=False)] == ["robot 101 has appeared"]
    assert [each.name for each in traffic.lines("", "event")] == ["robot 101 has appeared"]
    assert traffic.decoded(traffic.lines("ffffh")[0]) == "its message id is not known here"


def test_frequent_messages_do_not_displace_rare_ones_and_all_is_bounded() -> None:
    traffic = Traffic(registry)
    traffic.event("rare")
    for _ in range(1000):
        traffic.note(HERE, THERE, QueryStatus().encode(), sent=True)
    for code in range(2 * MAX_KINDS):
        traffic.note(THERE, HERE, code.to_bytes(2, "little") * MAX_PAYLOAD, sent=False)
    lines = traffic.lines("", limit=10**6)
    assert lines[-1].name == "rare"
    assert sum(each.name == "QueryStatus" for each in lines) <= MAX_OF_KIND + 1
    assert len(lines) < MAX_KINDS + 2 * MAX_OF_KIND
    assert str(traffic.decoded(lines[0])).endswith("that are kept")
    traffic.note(HERE, THERE, b"", sent=False)
    assert traffic.lines("")[0].name == "too short"
