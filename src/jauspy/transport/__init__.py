"""How a component reaches others: through its node manager's socket, by UDP itself, or in memory."""

from __future__ import annotations

from jauspy.transport.base import Transport
from jauspy.transport.local import LocalTransport
from jauspy.transport.loopback import LoopbackHub, LoopbackTransport
from jauspy.transport.udp import UdpTransport

__all__ = ["LocalTransport", "LoopbackHub", "LoopbackTransport", "Transport", "UdpTransport"]
