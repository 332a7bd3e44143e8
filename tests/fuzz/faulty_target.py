"""A component on UDP that fails on a certain message: `faulty_target.py PORT [died|hangs|leaks|lost] [FILE]`."""

from __future__ import annotations

import os
import select
import signal
import socket
import sys
import time
from datetime import UTC, datetime
from pathlib import Path

from jauspy.conformance.virtual_target import TargetComponent
from jauspy.ids import JausID, message_id
from jauspy.messages.core import QueryEvents, QueryTimeout, ReportStatus, SetAuthority
from jauspy.protocol.header import Packet
from jauspy.services.core import Discovery, Liveness, Management
from jauspy.services.host import Host

HOST = Host(JausID(101, 1, 1), [Discovery(), Management(), Liveness()], utc_now=lambda: datetime.now(UTC))
LEAKED: list[bytes] = []


def died(packet: Packet) -> None:
    """End at SetAuthority in the state Ready."""
    if message_id(packet.payload) == SetAuthority.CODE and HOST.status == ReportStatus.Status.READY:
        sys.stderr.write("authority out of range\n")
        sys.stderr.flush()
        os._exit(3)


def lost(packet: Packet) -> None:
    """At the first such message, write ids to FILE and kill the worker that started this; later end as above."""
    path = Path(sys.argv[3])
    if message_id(packet.payload) == SetAuthority.CODE and HOST.status == ReportStatus.Status.READY:
        if path.exists():
            died(packet)
        path.write_text(f"{os.getpid()} {os.getppid()}")
        os.kill(os.getppid(), signal.SIGKILL)


def hangs(packet: Packet) -> None:
    """Stop working at QueryEvents with bytes that its definition does not have."""
    if message_id(packet.payload) == QueryEvents.CODE and len(packet.payload) > 6:
        time.sleep(3600)


def leaks(packet: Packet) -> None:
    """Keep half a megabyte for every QueryTimeout."""
    if message_id(packet.payload) == QueryTimeout.CODE:
        LEAKED.append(b"x" * (1 << 19))


def main(port: int, fault: str) -> None:
    """Serve until the process is ended."""
    fail = {"died": died, "hangs": hangs, "leaks": leaks, "lost": lost}.get(fault)

    def intercept(packet: Packet) -> bool:
        if fail is not None and len(packet.payload) >= 2:
            fail(packet)
        return False

    component = TargetComponent(HOST, intercept)
    sock = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    sock.bind(("127.0.0.1", port))
    sender = None
    while True:
        if select.select([sock], [], [], 0.02)[0]:
            data, sender = sock.recvfrom(65536)
            component.handle(data, time.monotonic())
        for datagram in component.work(time.monotonic()):
            if sender is not None:
                sock.sendto(datagram, sender)


if __name__ == "__main__":
    main(int(sys.argv[1]), sys.argv[2] if len(sys.argv) > 2 else "")
