"""What the mobility profile says of a component that has one service of a test."""

from __future__ import annotations

from datetime import UTC, datetime

from jauspy import Service
from jauspy.conformance import Report, TargetComponent, VirtualTarget, find, run
from jauspy.ids import JausID
from jauspy.services.core import Discovery
from jauspy.services.host import Host

ID = JausID(101, 1, 1)


def judged(service: Service) -> Report:
    component = Host(ID, [service, Discovery()], utc_now=lambda: datetime(2026, 1, 1, tzinfo=UTC))
    return run(find("mobility-1.1"), VirtualTarget([TargetComponent(component)]), ID, began=0.0)


def failed(report: Report) -> set[str]:
    assert report.problem == ""
    return {each.id for each in report.failures}
