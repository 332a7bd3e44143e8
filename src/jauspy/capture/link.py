"""From a captured frame to the IP packet in it, for the link types that JAUS networks are recorded with."""

from __future__ import annotations

import struct
from typing import Final

# Link types as the pcap formats number them (https://www.tcpdump.org/linktypes.html). Raw IP has three numbers:
# the registered one, and two that some systems write instead.
NULL: Final = 0
ETHERNET: Final = 1
RAW: Final = (12, 14, 101)
LOOP: Final = 108
LINUX_SLL: Final = 113
IPV4: Final = 228
LINUX_SLL2: Final = 276

NAMES: Final = {
    NULL: "null/loopback",
    ETHERNET: "Ethernet",
    LOOP: "OpenBSD loopback",
    LINUX_SLL: "Linux cooked",
    IPV4: "raw IPv4",
    LINUX_SLL2: "Linux cooked v2",
    **dict.fromkeys(RAW, "raw IP"),
}

_IPV4_TYPE: Final = 0x0800
_VLAN_TYPES: Final = (0x8100, 0x88A8, 0x9100)
_AF_INET: Final = (2).to_bytes(4, "big"), (2).to_bytes(4, "little")


def ip_packet(link_type: int, frame: bytes) -> bytes | None:
    """The IPv4 packet in a frame, with whatever padding follows it; None when the frame carries something else."""
    if link_type == ETHERNET:
        return _after_ethertype(frame, 12)
    if link_type == LINUX_SLL:
        return _after_ethertype(frame, 14)
    if link_type == LINUX_SLL2:
        return frame[20:] if frame[:2] == _IPV4_TYPE.to_bytes(2, "big") else None
    if link_type in (NULL, LOOP):
        return frame[4:] if frame[:4] in _AF_INET else None
    return frame


def _after_ethertype(frame: bytes, offset: int) -> bytes | None:
    while len(frame) >= offset + 2:
        (kind,) = struct.unpack_from(">H", frame, offset)
        if kind == _IPV4_TYPE:
            return frame[offset + 2 :]
        if kind not in _VLAN_TYPES:
            return None
        offset += 4
    return None
