"""A socket filter (classic BPF) with which the kernel drops packets of a flood, by host and priority."""

from __future__ import annotations

import ctypes
import ipaddress
import socket
import struct
import sys
from collections.abc import Collection, Sequence
from typing import Final

from jauspy.protocol import header
from jauspy.protocol.header import Priority

_SO_ATTACH_FILTER: Final = 26
_SO_DETACH_FILTER: Final = 27
"""Socket option of asm-generic/socket.h, which Python does not name."""
_UDP_HEADER: Final = 8
_LOAD_BYTE, _LOAD_WORD, _AND, _EQUALS, _ANY_OF, _ABOVE, _RETURN = 0x30, 0x20, 0x54, 0x15, 0x45, 0x25, 0x06
_RANDOM: Final = 0xFFFFF000 + 56
"""SKF_AD_OFF and SKF_AD_RANDOM, from linux/filter.h."""
_IP_HEADER: Final = 0xFFF00000
"""SKF_NET_OFF, from linux/filter.h."""
_SOURCE_IN: Final = {4: 12, 6: 8}
"""Offset of the source address in the IP header, by version."""
MAX_HOSTS: Final = 8
_INSTRUCTION: Final = struct.Struct("HBBI")
_PROGRAM: Final = struct.Struct("HP")
_ACCEPT_ALL: Final = 0xFFFF


def attach(sock: socket.socket, up_to: Priority, skip: int, hosts: Collection[str] = ()) -> bool:
    """Drop plain packets of AS5669A up to this priority; false where the system has no such filter.

    With `hosts`, at most `MAX_HOSTS` addresses, those of others pass. `skip` bytes precede the packet's version byte.
    Dropped packets count with those that overflow the receive buffer.
    """
    return _attach(sock, skip, hosts, ((_ABOVE, 0, 1, up_to),))


def attach_sampling(
    sock: socket.socket, priority: Priority, share: float, skip: int, hosts: Collection[str] = ()
) -> bool:
    """Drop plain packets of this priority at random, except for a share of them; like `attach`."""
    chance = (_LOAD_WORD, 0, 0, _RANDOM), (_ABOVE, 1, 0, int(share * 0xFFFFFFFF))
    return _attach(sock, skip, hosts, ((_EQUALS, 0, 2, priority), *chance))


def _attach(
    sock: socket.socket, skip: int, hosts: Collection[str], decision: Sequence[tuple[int, int, int, int]]
) -> bool:
    """`decision` compares the priority; it falls through to accept the packet, and jumps one further to drop it."""
    index, end = _UDP_HEADER + skip, len(decision)
    code = (
        *_only_from(hosts, 6 if sock.family == socket.AF_INET6 else 4),
        (_LOAD_BYTE, 0, 0, index),
        (_EQUALS, 0, 4 + end, header.VERSION),
        (_LOAD_BYTE, 0, 0, index + 1),
        (_ANY_OF, 2 + end, 0, 0xFF),  # compressed, or not AS5669A: the control byte is elsewhere
        (_LOAD_BYTE, 0, 0, index + 4),
        (_AND, 0, 0, 3),
        *decision,
        (_RETURN, 0, 0, _ACCEPT_ALL),
        (_RETURN, 0, 0, 0),
    )
    program = ctypes.create_string_buffer(b"".join(_INSTRUCTION.pack(*instruction) for instruction in code))
    return _set_option(sock, _SO_ATTACH_FILTER, _PROGRAM.pack(len(code), ctypes.addressof(program)))


def _only_from(hosts: Collection[str], version: int) -> list[tuple[int, int, int, int]]:
    """Accepts packets of other hosts, and falls through for those of these hosts; for all if there are none."""
    if not hosts:
        return []
    addresses = [ipaddress.ip_address(host.partition("%")[0]) for host in hosts]
    known = [address.packed for address in addresses if address.version == version]
    tests: list[tuple[int, int, int, int]] = []
    for others, packed in zip(reversed(range(len(known))), known, strict=True):
        for offset in range(0, len(packed), 4):
            left = (len(packed) - offset - 4) // 2
            to_end = 0 if left else others * len(packed) // 2 + 1
            tests.append((_LOAD_WORD, 0, 0, _IP_HEADER + _SOURCE_IN[version] + offset))
            tests.append((_EQUALS, to_end, left, int.from_bytes(packed[offset : offset + 4])))
    return [*tests, (_RETURN, 0, 0, _ACCEPT_ALL)]


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
