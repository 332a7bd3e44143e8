"""A socket filter (classic BPF) with which the kernel drops packets of low priority before they are read."""

from __future__ import annotations

import ctypes
import socket
import struct
import sys
from typing import Final

from jauspy.protocol import header
from jauspy.protocol.header import Priority

_SO_ATTACH_FILTER: Final = 26
_SO_DETACH_FILTER: Final = 27
"""From asm-generic/socket.h."""
_UDP_HEADER: Final = 8
_LOAD_BYTE, _AND, _EQUALS, _ANY_OF, _ABOVE, _RETURN = 0x30, 0x54, 0x15, 0x45, 0x25, 0x06
_INSTRUCTION: Final = struct.Struct("HBBI")
_PROGRAM: Final = struct.Struct("HP")
_ACCEPT_ALL: Final = 0xFFFF


def attach(sock: socket.socket, up_to: Priority, skip: int) -> bool:
    """Drop plain packets of AS5669A up to this priority; false where the system has no such filter.

    `skip` bytes precede the packet's version byte. Dropped packets count with those that overflow the receive buffer.
    """
    at = _UDP_HEADER + skip
    code = (
        (_LOAD_BYTE, 0, 0, at),
        (_EQUALS, 0, 5, header.VERSION),
        (_LOAD_BYTE, 0, 0, at + 1),
        (_ANY_OF, 3, 0, 0xFF),  # compressed, or not AS5669A: the control byte is elsewhere
        (_LOAD_BYTE, 0, 0, at + 4),
        (_AND, 0, 0, 3),
        (_ABOVE, 0, 1, up_to),
        (_RETURN, 0, 0, _ACCEPT_ALL),
        (_RETURN, 0, 0, 0),
    )
    program = ctypes.create_string_buffer(b"".join(_INSTRUCTION.pack(*each) for each in code))
    return _set_option(sock, _SO_ATTACH_FILTER, _PROGRAM.pack(len(code), ctypes.addressof(program)))


def detach(sock: socket.socket) -> None:
    """Receive all packets again."""
    _set_option(sock, _SO_DETACH_FILTER, bytes(4))


def _set_option(sock: socket.socket, option: int, value: bytes) -> bool:
    if sys.platform != "linux":
        return False
    try:
        sock.setsockopt(socket.SOL_SOCKET, option, value)
    except OSError:
        return False
    return True
