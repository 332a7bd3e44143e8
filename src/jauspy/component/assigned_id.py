"""Asks for the id of a component that starts without subsystem or node, as `Component("0.0.101")`."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from jauspy.codec.message import Message
from jauspy.errors import ConfigError, DecodeError
from jauspy.ids import JausID, message_id
from jauspy.messages.exp import GrantSubsystemID, RequestSubsystemID
from jauspy.messages.iop import GrantNodeID, RequestNodeID
from jauspy.protocol.header import Broadcast, Packet
from jauspy.services.host import Host

REQUEST_PERIOD: Final = 1.0
"""Seconds between two requests."""
EVERYBODY: Final = JausID(0xFFFF, 0xFF, 0xFF)
VEHICLE: Final = RequestSubsystemID.SubsystemType.VEHICLE


class IDRequest:
    """Requests the parts that an id lacks, first the subsystem, until an allocator has granted them.

    `key` is six bytes that no other component has, as the MAC address of the machine. Grants for other keys, and of 0,
    change nothing.
    """

    def __init__(self, host: Host, key: bytes, subsystem_type: int = VEHICLE) -> None:
        if len(key) != 6:
            raise ConfigError(f"the key of a request for an id has 6 bytes, as a MAC address, not {len(key)}")
        self._host, self._key, self._type = host, list(key), subsystem_type
        self._request()

    def intercept(self, packet: Packet) -> bool:
        """Take the grant for this component; all other packets are passed to the services."""
        grant = _decoded(packet)
        id = self._host.id
        if isinstance(grant, GrantSubsystemID):
            if not id.subsystem and list(grant.ma_caddr) == self._key and 0 < grant.subsystem_id < 0xFFFF:
                self._take(replace(id, subsystem=grant.subsystem_id))
            return True
        if isinstance(grant, GrantNodeID):
            is_for_this = list(grant.requester_id) == [*self._key, id.component]
            if id.subsystem and not id.node and is_for_this and 0 < grant.node_id < 0xFF:
                if packet.source.subsystem == id.subsystem:
                    self._take(replace(id, node=grant.node_id))
                else:
                    self._host.count("foreign_id_grant", f"{packet.source}")
            return True
        return False

    def _take(self, id: JausID) -> None:
        self._host.ask_for_id(id)
        self._host.set_timer("id request", self._host.now, self._request)

    def _request(self) -> None:
        id = self._host.requested_id or self._host.id
        if id.subsystem and id.node:
            return
        self._host.set_timer("id request", self._host.now + REQUEST_PERIOD, self._request)
        if not id.subsystem:
            request: Message = RequestSubsystemID(self._key, self._type)
            self._host.send(EVERYBODY, request, broadcast=Broadcast.GLOBAL)
        elif self._host.requested_id is None:
            request = RequestNodeID([*self._key, id.component])
            self._host.send(JausID(id.subsystem, 0xFF, 0xFF), request, broadcast=Broadcast.GLOBAL)


def _decoded(packet: Packet) -> Message | None:
    """The grant in a packet; None for other messages, and for what is no grant."""
    code = message_id(packet.payload) if len(packet.payload) >= 2 else None
    for kind in (GrantSubsystemID, GrantNodeID):
        if code == kind.CODE:
            try:
                return kind.decode(packet.payload)
            except DecodeError:
                return None
    return None
