"""The datagrams of a run as pcapng, for Wireshark and `jauspy decode`.

A run knows bytes and times, not addresses: the tester is 192.0.2.42 and the target 192.0.2.1, which are addresses for
documentation (RFC 5737).
"""

from __future__ import annotations

from typing import Final

from jauspy.conformance.results import Report
from jauspy.conformance.trace import Direction
from jauspy.node import pcapng
from jauspy.protocol import judp

TESTER: Final = ("192.0.2.42", judp.PORT)
STRANGE: Final = ("192.0.2.42", 49152)
TARGET: Final = ("192.0.2.1", judp.PORT)


def capture(report: Report) -> bytes:
    """The file."""
    blocks = [pcapng.preamble()]
    for entry in report.entries:
        tester = STRANGE if entry.strange_port else TESTER
        source, destination = (tester, TARGET) if entry.direction is Direction.SENT else (TARGET, tester)
        nanoseconds = int((report.began + entry.at) * 1e9)
        blocks.append(pcapng.packet(source, destination, entry.data, nanoseconds))
    return b"".join(blocks)
