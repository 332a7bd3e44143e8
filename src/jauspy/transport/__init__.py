"""How a component reaches others: through its node manager's socket, by UDP, TCP or a serial line, or in memory."""

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
