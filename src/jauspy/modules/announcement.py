"""Makes a component known to a console that waits to be asked, as those of the IGVC judges did until 2013."""

from __future__ import annotations

from typing import Final

from jauspy.ids import JausID
from jauspy.messages.core import QueryIdentification, ReportIdentification
from jauspy.protocol.header import Packet
from jauspy.services.host import Host

PERIOD: Final = 5.0
"""Seconds between two questions."""
_SUBSYSTEM: Final = QueryIdentification.QueryType.SUBSYSTEM


class Announcement:
    """Asks `console` who it is, every `PERIOD`, until it answers."""

    def __init__(self, host: Host, console: JausID) -> None:
        self._host = host
        self._console = console
        self._ask()

    def intercept(self, packet: Packet) -> bool:
        """Take the answer; all else is for the services."""
        code = int.from_bytes(packet.payload[:2], "little")
        if packet.source != self._console or code != ReportIdentification.CODE:
            return False
        self._host.cancel_timer("announcement")
        return True

    def _ask(self) -> None:
        self._host.set_timer("announcement", self._host.now + PERIOD, self._ask)
        self._host.send(self._console, QueryIdentification(_SUBSYSTEM))
