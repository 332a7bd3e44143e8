"""SubsystemIDAllocator (AEODRS) and NodeIDAllocator (IOP): hand out ids to components that start without one.

As with the allocator of the JAUS Toolset, whoever asks again with the same key gets the same id, the first subsystem is
100, and grants are broadcast, since the asker has no address yet. What is handed out is kept until the component ends.
Numbers of those whose heartbeats were heard are not handed out, also by an allocator that was started again.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from typing import Any, Final

from jauspy.ids import JausID
from jauspy.messages.core import ReportHeartbeatPulse
from jauspy.messages.exp import GrantSubsystemID, QuerySubsystemIDs, ReportSubsystemIDs, RequestSubsystemID
from jauspy.messages.iop import GrantNodeID, RequestNodeID
from jauspy.protocol.header import Broadcast
from jauspy.services.service import Service

FIRST_SUBSYSTEM, LAST_SUBSYSTEM = 100, 65534
LAST_NODE: Final = 254
MAX_SUBSYSTEMS: Final = 1024
"""Subsystems in the table; further ones get 0, which says that it failed."""
MAX_HEARD: Final = 1024
"""Numbers that are known to be in use; of more of them, those heard longest ago are forgotten."""
MAX_REPORTED: Final = 255
GRANTS: Final = 20.0
"""Broadcasts a second; who asks more often is not answered."""
NEW_BURST, NEW_RATE = 32.0, 1.0
"""New entries at once, and then a second: a stranger does not fill the table with invented keys in a moment."""
EVERYBODY: Final = JausID(0xFFFF, 0xFF, 0xFF)
_Type: Final = RequestSubsystemID.SubsystemType


class _Allowance:
    """A number of uses that grows with time, up to a burst."""

    def __init__(self, burst: float, rate: float) -> None:
        self._burst, self._rate, self._left, self._at = burst, rate, burst, 0.0

    def use(self, now: float) -> bool:
        """Use one; false if none is left."""
        self._left = min(self._burst, self._left + self._rate * max(0.0, now - self._at))
        self._at = now
        if self._left < 1.0:
            return False
        self._left -= 1.0
        return True


class IDTable:
    """Ids by the keys of those who asked."""

    def __init__(self, ids: Sequence[int], capacity: int, taken: Callable[[], Collection[int]]) -> None:
        self._ids, self._capacity, self._taken = ids, capacity, taken
        self._heard: dict[int, None] = {}
        """Numbers in use, those heard last at the end."""
        self._granted: dict[bytes, tuple[int, int]] = {}
        self._grants = _Allowance(GRANTS, GRANTS)
        self._new = _Allowance(NEW_BURST, NEW_RATE)

    @property
    def entries(self) -> list[tuple[bytes, int, int]]:
        """Key, id and kind of each."""
        return [(key, *entry) for key, entry in self._granted.items()]

    def grant(self, key: bytes, kind: int, now: float) -> int | None:
        """The id for a key, 0 if there is none left; None if nothing may be answered now."""
        if not self._grants.use(now):
            return None
        if key in self._granted:
            return self._granted[key][0]
        if len(self._granted) >= self._capacity:
            return 0
        if not self._new.use(now):
            return None
        taken = {*self._taken(), *self._heard, *(id for id, _ in self._granted.values())}
        id = next((id for id in self._ids if id not in taken), 0)
        if id:
            self._granted[key] = (id, kind)
        return id

    def note(self, id: int) -> None:
        """Note that somebody has this number."""
        self._heard.pop(id, None)
        self._heard[id] = None
        if len(self._heard) > MAX_HEARD:
            del self._heard[next(iter(self._heard))]


class SubsystemIDAllocator(Service, urn="urn:jaus:jss:exp:aeodrs:SubsystemIDAllocator"):
    """Hands out numbers from 100, but for those that `taken` returns. A system must have one only."""

    def __init__(self, taken: Callable[[], Collection[int]] = tuple) -> None:
        ids = range(FIRST_SUBSYSTEM, LAST_SUBSYSTEM + 1)
        self._table = IDTable(ids, MAX_SUBSYSTEMS, lambda: {self.host.id.subsystem, *taken()})

    def attached(self) -> None:
        """Listen to heartbeats."""
        self.host.expect(ReportHeartbeatPulse, lambda _, source: self._table.note(source.subsystem))

    def broadcast_grant_subsystem_i_dto_system(self, msg: RequestSubsystemID) -> None:
        """Tell everybody who has which number; 0 once there are none."""
        if msg.subsystem_type not in tuple(_Type):
            self.host.count("undefined_value", f"subsystem type {msg.subsystem_type}")
            return
        id = self._table.grant(bytes(msg.ma_caddr), int(msg.subsystem_type), self.host.now)
        if id is None:
            self.host.count("too_many_id_requests", bytes(msg.ma_caddr).hex())
            return
        grant = GrantSubsystemID(id, int(msg.subsystem_type), msg.ma_caddr)
        self.host.send(EVERYBODY, grant, broadcast=Broadcast.GLOBAL)

    def send_report_subsystem_ids(self, query: QuerySubsystemIDs) -> ReportSubsystemIDs:
        """Subsystems of a kind, or of a MAC address; none for an undefined kind."""
        wanted = query.subsystem_id_type
        kinds = {1: {_Type.OCU}, 2: {_Type.VEHICLE}}.get(int(wanted), set(_Type))
        found: list[Any] = [
            ReportSubsystemIDs.SubsystemIDsRec(id, kind, list(key))
            for key, id, kind in self._table.entries
            if kind in kinds and (wanted != 3 or key == bytes(query.ma_caddr)) and wanted in (0, 1, 2, 3)
        ]
        return ReportSubsystemIDs(ReportSubsystemIDs.SubsystemIDTypeRec(wanted), found[:MAX_REPORTED])


class NodeIDAllocator(Service, urn="urn:jaus:jss:iop:NodeIDAllocator"):
    """Hands out nodes of the component's subsystem, but for those that `taken` returns."""

    def __init__(self, taken: Callable[[], Collection[int]] = tuple) -> None:
        self._table = IDTable(range(1, LAST_NODE + 1), LAST_NODE, lambda: {self.host.id.node, *taken()})

    def attached(self) -> None:
        """Listen to heartbeats."""
        self.host.expect(ReportHeartbeatPulse, lambda _, source: self._on_heartbeat(source))

    def _on_heartbeat(self, source: JausID) -> None:
        if source.subsystem == self.host.id.subsystem:
            self._table.note(source.node)

    def broadcast_grant_node_i_dto_subsystem(self, msg: RequestNodeID, source: JausID) -> None:
        """Tell the subsystem who has which number; requests of other subsystems are refused."""
        own = self.host.id.subsystem
        if source.subsystem not in (0, 0xFFFF, own):
            self.host.count("foreign_id_request", f"{source}")
            return
        id = self._table.grant(bytes(msg.requester_id), 0, self.host.now)
        if id is None:
            self.host.count("too_many_id_requests", bytes(msg.requester_id).hex())
            return
        self.host.send(JausID(own, 0xFF, 0xFF), GrantNodeID(id, msg.requester_id), broadcast=Broadcast.GLOBAL)
