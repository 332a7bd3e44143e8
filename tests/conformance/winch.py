"""A service of a user, which no profile has: a winch with states and commands of its own."""

from __future__ import annotations

from datetime import UTC, datetime
from functools import cache
from pathlib import Path

import jauspy
from jauspy.codec.message import Message
from jauspy.codec.registry import Registry
from jauspy.conformance import TargetComponent, VirtualTarget
from jauspy.ids import JausID
from jauspy.services.core import AccessControl, Discovery, Management
from jauspy.services.host import Host
from jauspy.services.service import Service

SOURCE = Path(__file__).parents[1] / "vendor" / "Winch.xml"
ID = JausID(101, 1, 120)
URN = "urn:example:vendor:Winch"


@cache
def winch_messages() -> Registry:
    return jauspy.load(SOURCE)


def winch(part: type[TargetComponent] = TargetComponent, **methods: object) -> VirtualTarget:
    """A component with a winch; `methods` replace those of the service."""

    def report_winch(self: Service) -> Message:
        return winch_messages().by_name("ReportWinch")(load=12)

    members = {"report_winch": report_winch, "stop": lambda self: None, "pull": lambda self: None, **methods}
    kind = type("Winch", (Service,), members, urn=URN, definitions=winch_messages())
    host = Host(
        ID,
        [kind(), Management(), AccessControl(timeout=5), Discovery()],
        utc_now=lambda: datetime(2026, 1, 1, tzinfo=UTC),
    )
    return VirtualTarget([part(host)])
