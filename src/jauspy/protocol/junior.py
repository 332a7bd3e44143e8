"""The Junior local protocol: how a component registers with its node manager.

Connect, Accept and Cancel have 21 bytes: a header of AS5669 version 1 without payload. All other datagrams on the local
sockets are those of JUDP, one packet each.
"""

from __future__ import annotations

import struct
from dataclasses import dataclass
from enum import IntEnum
from typing import Final

from jauspy.ids import JausID

SOCKET_NAME: Final = "JuniorRTE"
"""The node manager's socket in its root folder (`/tmp` by default); a component's is its id in decimal."""

_VERSION: Final = 1

# version, header compression, length (big endian), priority, RA version, code, destination, source, size, sequence
_CONTROL: Final = struct.Struct("<B2s2sBBHIIHH")
_HEAD: Final = (_VERSION, b"\0\0", b"\0\x10", 6, 2)


class ControlKind(IntEnum):
    """The command code of a control message."""

    CONNECT = 1
    ACCEPT = 2
    CANCEL = 3


@dataclass(frozen=True, slots=True)
class ControlMessage:
    """A control message, and the component it is about."""

    kind: ControlKind
    id: JausID


def connect(id: JausID) -> bytes:
    """Message from component to node manager: register this id."""
    return _CONTROL.pack(*_HEAD, ControlKind.CONNECT, 0, int(id), 0, 0)


def accept(id: JausID) -> bytes:
    """Message from node manager to component: the answer to every Connect."""
    return _CONTROL.pack(*_HEAD, ControlKind.ACCEPT, int(id), 0, 0, 0)


def cancel(id: JausID) -> bytes:
    """Message from component to node manager: remove this id; it is not answered."""
    return _CONTROL.pack(*_HEAD, ControlKind.CANCEL, 0, int(id), 0, 0)


def parse(data: bytes | memoryview) -> ControlMessage | None:
    """The control message in `data`, or None for any other datagram."""
    if len(data) != _CONTROL.size or data[0] != _VERSION:
        return None
    _, _, length, _, version, code, destination, source, size, _ = _CONTROL.unpack(data)
    if length != _HEAD[2] or version != _HEAD[4] or size or code not in ControlKind._value2member_map_:
        return None
    kind = ControlKind(code)
    return ControlMessage(kind, JausID.from_int(destination if kind is ControlKind.ACCEPT else source))
