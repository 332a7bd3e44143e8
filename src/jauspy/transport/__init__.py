"""Transports of a component: its node manager's local socket, UDP, TCP, a serial line, or memory."""

from __future__ import annotations

from jauspy.transport.base import Transport
from jauspy.transport.local import LocalTransport
from jauspy.transport.loopback import LoopbackHub, LoopbackTransport
from jauspy.transport.serial import SerialLine, SerialTransport
from jauspy.transport.tcp import TcpTransport
from jauspy.transport.udp import UdpTransport

__all__ = [
    "LocalTransport",
    "LoopbackHub",
    "LoopbackTransport",
    "SerialLine",
    "SerialTransport",
    "TcpTransport",
    "Transport",
    "UdpTransport",
]
