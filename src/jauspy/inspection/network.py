"""The JAUS traffic that passes an interface of this machine, or that is sent to a multicast group."""

from __future__ import annotations

import ctypes
import errno
import select
import socket
import struct
import time
from collections.abc import Iterator, Sequence
from typing import Any, Final

from jauspy.capture.ip import ETHERNET, IPV4, DatagramAssembler, ip_packet
from jauspy.capture.reader import Datagram
from jauspy.errors import ConfigError, TransportError
from jauspy.transport import multicast

MAX_DATAGRAM: Final = 65535
_ETH_P_ALL: Final = 0x0003
_SOL_PACKET, _PACKET_ADD_MEMBERSHIP, _PACKET_STATISTICS = 263, 1, 6
"""From linux/socket.h and linux/if_packet.h."""
_PACKET_MR_PROMISC: Final = 1
_MEMBERSHIP: Final = struct.Struct("iHH8s")
_COUNTS: Final = struct.Struct("II")
"""Packets, and those that were dropped, since the last read."""
_SO_ATTACH_FILTER, _SO_RCVBUFFORCE, _SO_TIMESTAMPNS, _SO_RXQ_OVFL = 26, 33, 35, 40
"""From asm-generic/socket.h."""
_TIME: Final = struct.Struct("@qq")
_DROPS: Final = struct.Struct("I")
_INSTRUCTION: Final = struct.Struct("HBBI")
_PROGRAM: Final = struct.Struct("HP")
_LOAD_BYTE, _LOAD_HALF, _LOAD_INDEXED, _HEADER_LENGTH = 0x30, 0x28, 0x48, 0xB1
_LOAD_BYTE_INDEXED, _AND = 0x50, 0x54
_SET_INDEX, _EQUALS, _ANY_OF, _RETURN = 0x01, 0x15, 0x45, 0x06
"""Instructions of classic BPF (linux/filter.h)."""
_PROTOCOL: Final = 0xFFFFF000
"""SKF_AD_OFF and SKF_AD_PROTOCOL."""
_IP_HEADER: Final = 0xFFF00000
"""SKF_NET_OFF: where the kernel has found the IP header."""
_IPV6_HEADER_LENGTH: Final = 40
_UDP_HEADER_LENGTH: Final = 8
_RTP_VERSION_BITS, _RTP_VERSION = 0xC0, 0x80
"""In the first byte of a packet of RTP."""
_IPV6_EXTENSIONS: Final = (
    socket.IPPROTO_HOPOPTS,
    socket.IPPROTO_ROUTING,
    socket.IPPROTO_FRAGMENT,
    socket.IPPROTO_DSTOPTS,
)
"""Headers between those of IPv6 and UDP or TCP; rare, and left to `DatagramAssembler`."""
_ETHER, _LOOPBACK = 1, 772
"""ARPHRD_ETHER and ARPHRD_LOOPBACK of linux/if_arp.h; interfaces of other kinds, as of a VPN, have IP alone."""


class InterfaceCapture:
    """Iterates over the UDP datagrams from or to `port` that pass an interface, until `seconds` have passed.

    Packets of JTCP are datagrams, too, and so is what comes by IPv6. Fragments are put together, tags of VLANs are
    taken off. The interface is in promiscuous mode meanwhile, so a port of a switch to which others are mirrored shows
    those, too. `lost` counts packets that this reader was too slow for. `with_rtp` shows what may be RTP of other
    ports, too.

    Raises:
        TransportError: no such interface, or this process may not capture.
    """

    def __init__(self, interface: str, port: int, seconds: float | None = None, *, with_rtp: bool = False) -> None:
        self._assembler = DatagramAssembler(port)
        self._with_rtp = with_rtp
        self._port, self._lost = port, 0
        self._end = None if seconds is None else time.monotonic() + seconds
        try:
            index = socket.if_nametoindex(interface)
        except OSError:
            known = ", ".join(name for _, name in socket.if_nameindex())
            raise TransportError(f"there is no interface {interface}; there are: {known}") from None
        if not hasattr(socket, "AF_PACKET"):
            raise TransportError("only Linux lets jauspy capture; use tcpdump, and read its file with --capture")
        try:
            self._socket = socket.socket(socket.AF_PACKET, socket.SOCK_RAW, 0)
        except PermissionError:
            raise TransportError(
                f"capturing on {interface} needs the capability CAP_NET_RAW: run it as root, or let "
                "`tcpdump -w FILE` record, and read that with --capture"
            ) from None
        try:
            _attach_filter(self._socket, port, with_rtp=with_rtp)  # before `bind`: nothing else is received
            _enlarge_buffer(self._socket)
            self._socket.setsockopt(socket.SOL_SOCKET, _SO_TIMESTAMPNS, 1)
            self._socket.bind((interface, _ETH_P_ALL))
            member = _MEMBERSHIP.pack(index, _PACKET_MR_PROMISC, 0, bytes(8))
            self._socket.setsockopt(_SOL_PACKET, _PACKET_ADD_MEMBERSHIP, member)
        except OSError as error:
            self._socket.close()
            raise TransportError(f"cannot capture on {interface}: {error.strerror}") from None

    @property
    def lost(self) -> int:
        """Packets that the kernel has dropped, because they were not read in time."""
        if self._socket.fileno() >= 0:
            counts = self._socket.getsockopt(_SOL_PACKET, _PACKET_STATISTICS, _COUNTS.size)
            self._lost += _COUNTS.unpack(counts)[1]
        return self._lost

    def __iter__(self) -> Iterator[Datagram]:
        number = 0
        for frame, control, origin in _received(self._socket, self._end):
            number += 1
            _, _, direction, hardware, *_ = origin
            if hardware == _LOOPBACK and direction == socket.PACKET_OUTGOING:
                continue  # it is seen again as it comes in
            packet = ip_packet(ETHERNET if hardware in (_ETHER, _LOOPBACK) else IPV4, frame)
            for udp in self._assembler.add(packet) if packet is not None else ():
                if self._port in (udp.source[1], udp.destination[1]) or (self._with_rtp and _may_be_rtp(udp.payload)):
                    yield Datagram(number, _stamp(control), *udp)

    def close(self) -> None:
        """Stop."""
        self.lost  # noqa: B018 - reads the counters for the last time
        self._socket.close()


class GroupCapture:
    """Iterates over the datagrams that are sent to a multicast group, until `seconds` have passed.

    It joins on interfaces given by name or address; `ANY` is the kernel's choice. `lost` counts datagrams that this
    reader was too slow for.

    Raises:
        ConfigError: no address of a group.
        TransportError: no such interface, or the port is taken by a program that does not share it.
    """

    def __init__(
        self, group: str, port: int, interfaces: Sequence[str] = (multicast.ANY,), seconds: float | None = None
    ) -> None:
        try:
            is_group = 224 <= socket.inet_pton(socket.AF_INET, group)[0] < 240
        except OSError:
            is_group = False
        if not is_group:
            raise ConfigError(f"{group!r} is no IPv4 multicast group, as 239.255.0.1")
        self.lost = 0
        self._group = group, port
        self._end = None if seconds is None else time.monotonic() + seconds
        addresses = multicast.addresses(interfaces)
        if not addresses:
            raise TransportError(f"there is no interface {', '.join(interfaces)} with an IPv4 address")
        try:
            self._socket = multicast.receiver(self._group)
        except OSError as error:
            raise TransportError(f"cannot receive {group}:{port}: {error.strerror}") from None
        try:
            self._socket.setsockopt(socket.SOL_SOCKET, _SO_TIMESTAMPNS, 1)
            self._socket.setsockopt(socket.SOL_SOCKET, _SO_RXQ_OVFL, 1)
            for address in addresses:
                membership = socket.inet_aton(group) + socket.inet_aton(address)
                self._socket.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, membership)
        except OSError as error:
            self._socket.close()
            raise TransportError(f"cannot join {group} on {', '.join(interfaces)}: {error.strerror}") from None

    def __iter__(self) -> Iterator[Datagram]:
        for number, (payload, control, source) in enumerate(_received(self._socket, self._end), 1):
            for level, kind, data in control:
                if (level, kind) == (socket.SOL_SOCKET, _SO_RXQ_OVFL):
                    (self.lost,) = _DROPS.unpack_from(data)
            yield Datagram(number, _stamp(control), source, self._group, payload)

    def close(self) -> None:
        """Leave the group."""
        self._socket.close()


_Control = list[tuple[int, int, bytes]]


def _received(sock: socket.socket, end: float | None) -> Iterator[tuple[bytes, _Control, Any]]:
    """What a socket receives until a time, with its control messages and its origin."""
    sock.setblocking(False)
    poller = select.poll()
    poller.register(sock, select.POLLIN)
    while end is None or time.monotonic() < end:
        try:
            data, control, _, origin = sock.recvmsg(MAX_DATAGRAM, 128)
        except BlockingIOError:
            poller.poll(None if end is None else max(0.0, 1e3 * (end - time.monotonic())))
            continue
        except OSError as error:
            if error.errno == errno.ENETDOWN:  # it may come up again
                continue
            raise TransportError(f"the capture ends: {error.strerror}") from None
        yield data, control, origin


def _may_be_rtp(payload: bytes) -> bool:
    return payload[:1] != b"" and payload[0] & _RTP_VERSION_BITS == _RTP_VERSION


def _stamp(control: _Control) -> float:
    """When the kernel received it, in seconds since 1970."""
    for level, kind, data in control:
        if (level, kind) == (socket.SOL_SOCKET, _SO_TIMESTAMPNS):
            seconds, nanoseconds = _TIME.unpack_from(data)
            return float(seconds + nanoseconds / 1e9)
    return time.time()


def _enlarge_buffer(sock: socket.socket) -> None:
    """Enlarge the receive buffer: beyond the system's limit if this process may, else up to it."""
    try:
        sock.setsockopt(socket.SOL_SOCKET, _SO_RCVBUFFORCE, multicast.RECEIVE_BUFFER)
    except PermissionError:
        multicast.set_receive_buffer(sock)


def _attach_filter(sock: socket.socket, port: int, *, with_rtp: bool) -> None:
    """Let the kernel keep only UDP and TCP from or to a port, all fragments, and what has a further tag of a VLAN.

    So does IPv6, of which packets with extension headers are kept, too. The other traffic of an interface, such as
    video, then costs this process nothing. `with_rtp` keeps what has the version of RTP where UDP has its content.
    """
    rows: list[tuple[str, int, str, str, int]] = [  # label, instruction, where to go on if true and if not, operand
        ("", _LOAD_HALF, "", "", _PROTOCOL),
        ("", _EQUALS, "keep", "", 0x8100),
        ("", _EQUALS, "keep", "", 0x88A8),
        ("", _EQUALS, "v6", "", 0x86DD),
        ("", _EQUALS, "", "drop", 0x0800),
        ("", _LOAD_BYTE, "", "", _IP_HEADER + 9),
        ("", _EQUALS, "v4", "", socket.IPPROTO_UDP),
        ("", _EQUALS, "v4", "drop", socket.IPPROTO_TCP),
        ("v4", _LOAD_HALF, "", "", _IP_HEADER + 6),
        ("", _ANY_OF, "keep", "", 0x3FFF),  # a fragment: only the first has the ports
        ("", _HEADER_LENGTH, "", "", _IP_HEADER),
        ("", _EQUALS, "ports", "ports", 0),
        ("v6", _LOAD_BYTE, "", "", _IP_HEADER + 6),
        *(("", _EQUALS, "keep", "", kind) for kind in _IPV6_EXTENSIONS),
        ("", _EQUALS, "v6 ports", "", socket.IPPROTO_UDP),
        ("", _EQUALS, "v6 ports", "drop", socket.IPPROTO_TCP),
        ("v6 ports", _SET_INDEX, "", "", _IPV6_HEADER_LENGTH),
        ("ports", _LOAD_INDEXED, "", "", _IP_HEADER),
        ("", _EQUALS, "keep", "", port),
        ("", _LOAD_INDEXED, "", "", _IP_HEADER + 2),
        ("", _EQUALS, "keep", "rtp" if with_rtp else "drop", port),
        ("rtp", _LOAD_BYTE_INDEXED, "", "", _IP_HEADER + _UDP_HEADER_LENGTH),
        ("", _AND, "", "", _RTP_VERSION_BITS),
        ("", _EQUALS, "keep", "drop", _RTP_VERSION),
        ("keep", _RETURN, "", "", MAX_DATAGRAM),
        ("drop", _RETURN, "", "", 0),
    ]
    places = {label: place for place, (label, *_) in enumerate(rows) if label}
    code = [
        (instruction, *(places[label] - place - 1 if label else 0 for label in (if_true, if_false)), operand)
        for place, (_, instruction, if_true, if_false, operand) in enumerate(rows)
    ]
    program = ctypes.create_string_buffer(b"".join(_INSTRUCTION.pack(*instruction) for instruction in code))
    sock.setsockopt(socket.SOL_SOCKET, _SO_ATTACH_FILTER, _PROGRAM.pack(len(code), ctypes.addressof(program)))
