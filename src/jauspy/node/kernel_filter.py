"""A socket filter (classic BPF) with which the kernel drops packets of low priority before they are read."""

from __future__ import annotations

import ctypes
import socket
import struct
import sys
from collections.abc import Sequence
from typing import Final

from jauspy.protocol import header
from jauspy.protocol.header import Priority

_SO_ATTACH_FILTER: Final = 26
_SO_DETACH_FILTER: Final = 27
"""From asm-generic/socket.h."""
_UDP_HEADER: Final = 8
_LOAD_BYTE, _LOAD_WORD, _AND, _EQUALS, _ANY_OF, _ABOVE, _RETURN = 0x30, 0x20, 0x54, 0x15, 0x45, 0x25, 0x06
_RANDOM: Final = 0xFFFFF000 + 56
"""SKF_AD_OFF and SKF_AD_RANDOM, from linux/filter.h."""
_INSTRUCTION: Final = struct.Struct("HBBI")
_PROGRAM: Final = struct.Struct("HP")
_ACCEPT_ALL: Final = 0xFFFF


def attach(sock: socket.socket, up_to: Priority, skip: int) -> bool:
    """Drop plain packets of AS5669A up to this priority; false where the system has no such filter.

    `skip` bytes precede the packet's version byte. Dropped packets count with those that overflow the receive buffer.
    """
    return _attach(sock, skip, ((_ABOVE, 0, 1, up_to),))


def attach_sampling(sock: socket.socket, priority: Priority, share: float, skip: int) -> bool:
    """Drop plain packets of this priority at random, except for a share of them; like `attach`."""
    chance = (_LOAD_WORD, 0, 0, _RANDOM), (_ABOVE, 1, 0, int(share * 0xFFFFFFFF))
    return _attach(sock, skip, ((_EQUALS, 0, 2, priority), *chance))


def _attach(sock: socket.socket, skip: int, decision: Sequence[tuple[int, int, int, int]]) -> bool:
    """`decision` has the priority, goes on to accept the packet, and one further to drop it."""
    at, end = _UDP_HEADER + skip, len(decision)
    code = (
        (_LOAD_BYTE, 0, 0, at),
        (_EQUALS, 0, 4 + end, header.VERSION),
        (_LOAD_BYTE, 0, 0, at + 1),
        (_ANY_OF, 2 + end, 0, 0xFF),  # compressed, or not AS5669A: the control byte is elsewhere
        (_LOAD_BYTE, 0, 0, at + 4),
        (_AND, 0, 0, 3),
        *decision,
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
