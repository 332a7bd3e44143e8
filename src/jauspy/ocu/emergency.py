"""Emergency stops: of one component, one robot or all robots, whoever controls them (Management service, AS5710)."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING, Final, TypeAlias

from jauspy.ids import JausID
from jauspy.messages.core import ClearEmergency, QueryStatus, ReportStatus, SetEmergency

if TYPE_CHECKING:
    from jauspy.ocu.client import OCU

ROUND: Final = 0.4
"""Seconds in which components answer QueryStatus before the message is sent again."""
SETTLED_ROUNDS: Final = 2
"""Rounds without a new component, in which all obey, after which the exchange ends; there are several because packets
get lost."""
STOP: Final = SetEmergency.EmergencyCode.STOP

Reports: TypeAlias = dict[JausID, ReportStatus]


async def set_emergency(ocu: OCU, to: JausID, *, release: bool = False, within: float = 2.0) -> Reports:
    """Set the emergency of all that `to` reaches, or clear it with `release`; the last status of each that answered.

    The message is sent immediately, without discovery, and repeated until all that answer have obeyed, at most for
    `within` seconds. Only the id that set an emergency can clear it.
    """
    message = ClearEmergency(emergency_code=STOP) if release else SetEmergency(emergency_code=STOP)
    found: Reports = {}
    end = asyncio.get_running_loop().time() + within
    settled = 0
    while settled < SETTLED_ROUNDS and (left := end - asyncio.get_running_loop().time()) > 0:
        await ocu.send(to, message)
        before = set(found)
        async for id, report in ocu.query_each(to, QueryStatus(), within=min(ROUND, left)):
            found[id] = report
        for id, report in found.items():
            if release and to.is_wildcard and not obeys(report, release=release):
                await ocu.send(id, message)  # a message to a wildcard cannot be sealed by an operator
        obey = all(obeys(report, release=release) for report in found.values())
        settled = settled + 1 if found and obey and found.keys() == before else 0
    return found


def obeys(report: ReportStatus, *, release: bool) -> bool:
    """True if this status is the requested one: in emergency, or with `release` not."""
    return (report.status == ReportStatus.Status.EMERGENCY) != release
