"""What a component says about who controls it, and words for that."""

from __future__ import annotations

from typing import Final

from jauspy.codec.message import Message
from jauspy.errors import ControlRejected, ResponseTimeout, TransportError
from jauspy.ids import JausID
from jauspy.messages.core import (
    ConfirmControl,
    QueryAuthority,
    QueryControl,
    QueryStatus,
    QueryTimeout,
    ReportAuthority,
    ReportControl,
    ReportStatus,
    ReportTimeout,
)
from jauspy.ocu.link import Link
from jauspy.ocu.patience import Patience

ASSUMED_TIMEOUT: Final = 3.0
"""Seconds, of a component that does not say after how long it takes control back."""
ASK_TIMEOUT: Final = Patience(timeout=0.3, retries=3)
"""For asking it that, and who is in control: the time is running already."""
NOBODY: Final = JausID(0, 0, 0)


class Standing:
    """Asks one component, and remembers which other client was last said to have control."""

    def __init__(self, link: Link, id: JausID, patience: Patience) -> None:
        self._link = link
        self._id = id
        self._patience = patience
        self._other: tuple[JausID | None, int | None] = (None, None)

    async def ask(self, query: Message, patience: Patience | None = None) -> Message | None:
        """The report; None when there is none."""
        try:
            return await self._link.query(self._id, query, patience=patience or self._patience)
        except (ResponseTimeout, TransportError):
            return None

    async def timeout(self) -> float:
        """Seconds after which it takes control back from a silent client; 0 when it never does."""
        report = await self.ask(QueryTimeout(), ASK_TIMEOUT)
        return float(report.timeout) if isinstance(report, ReportTimeout) else ASSUMED_TIMEOUT

    async def explain(self, code: int, authority: int) -> str:
        """Why it refused control to a client with this authority."""
        asked = f"you asked with {authority}"
        if code == ConfirmControl.ResponseCode.NOT_AVAILABLE:
            status = await self.ask(QueryStatus())
            now = f" (its status is {status_name(status)})" if isinstance(status, ReportStatus) else ""
            return f"{self._id} is not available for control{now}; clear an emergency, or wait until it is ready"
        if isinstance(control := await self.ask(QueryControl()), ReportControl) and self.is_elsewhere(control):
            return f"{self._id} {self.held_by()}; {asked}"
        least = await self.ask(QueryAuthority())
        if isinstance(least, ReportAuthority):
            return f"{self._id} gives control to authority {least.authority_code} and above; {asked}"
        return f"{self._id} refused control (code {code}); {asked}"

    async def is_open_to(self, authority: int) -> bool:
        """True when it says that this client has control, or that nobody has who is not outranked."""
        control = await self.ask(QueryControl())
        if not isinstance(control, ReportControl):
            return False
        return not self.is_elsewhere(control) or control.authority_code < authority

    def is_elsewhere(self, control: ReportControl) -> bool:
        """True when another client has control; remembers which."""
        found = holder(control)
        if found in (NOBODY, self._link.id):
            return False
        self._other = (found, control.authority_code)
        return True

    def held_by(self) -> str:
        """Who it was, in words."""
        return "is held by {} with authority {}".format(*self._other)

    def rejected(self, why: str) -> ControlRejected:
        """The error, with who has control instead."""
        found, authority = self._other
        return ControlRejected(why, holder=found, authority=authority)


def holder(control: ReportControl) -> JausID:
    """The client in control."""
    return JausID(control.subsystem_id, control.node_id, control.component_id)


def status_name(report: ReportStatus) -> str:
    """The status, as in READY."""
    return getattr(report.status, "name", str(report.status))
