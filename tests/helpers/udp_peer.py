"""A component with a UDP socket of its own, on loopback, that answers the doctor's questions, with chosen faults."""

from __future__ import annotations

import contextlib
import select
import socket
import threading
from collections.abc import Iterator
from dataclasses import dataclass, field
from datetime import UTC, datetime, timedelta
from typing import Any, Self

from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.core import ReportAuthority, ReportControl, ReportIdentification, ReportServices, ReportStatus
from jauspy.messages.operators import RejectCommand, ReportSealChallenge
from jauspy.protocol import judp
from jauspy.protocol.header import DataFlag, Packet
from jauspy.transport import multicast

PEER = JausID(101, 1, 1)
GROUP = "239.255.77.1"


@dataclass
class Faults:
    """What is wrong with a peer; by default nothing."""

    ignores_multicast: bool = False
    ignores_unicast: bool = False
    ignores_wildcard: bool = False
    drops_large: bool = False
    other_port: bool = False
    holder: tuple[int, int, int] = (0, 0, 0)
    authority: int = 0
    clock: timedelta = timedelta()
    services: tuple[tuple[str, int, int], ...] = (
        ("urn:jaus:jss:core:Time", 1, 0),
        ("urn:jaus:jss:core:AccessControl", 1, 0),
    )
    presence: int | None = None
    truncated: bool = False
    incomplete: bool = False
    status: ReportStatus.Status = ReportStatus.Status.READY
    seal: RejectCommand.Reason | str | None = None
    """A reason to refuse sealed commands, `taken` to take them, None to know none."""
    silent_to: frozenset[str] = field(default_factory=frozenset)
    ttl: int = 64


class UdpPeer:
    """The peer, in a thread of its own while it is entered."""

    def __init__(self, port: int, faults: Faults | None = None, *, host: str = "127.0.0.1", id: JausID = PEER) -> None:
        self.id = id
        self.address = (host, port)
        self.faults = faults or Faults()
        self.received: list[Packet] = []
        self._unicast = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._unicast.bind(self.address)
        self._unicast.setsockopt(socket.IPPROTO_IP, socket.IP_TTL, self.faults.ttl)
        self._sender = self._unicast
        if self.faults.other_port:
            self._sender = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
            self._sender.bind((host, 0))
        self._group = multicast.receiver((GROUP, port))
        interface = "127.0.0.1" if host.startswith("127.") else host
        membership = socket.inet_aton(GROUP) + socket.inet_aton(interface)
        self._group.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, membership)
        self._stop, self._stopped = socket.socketpair()
        self._thread = threading.Thread(target=self._run)
        self._sequence = 0

    def __enter__(self) -> Self:
        self._thread.start()
        return self

    def __exit__(self, *error: object) -> None:
        self._stop.send(b"x")
        self._thread.join()
        for sock in {self._unicast, self._sender, self._group, self._stop, self._stopped}:
            sock.close()

    def _run(self) -> None:
        while True:
            readable = select.select([self._unicast, self._group, self._stopped], [], [])[0]
            if self._stopped in readable:
                return
            for sock in readable:
                datagram, sender = sock.recvfrom(1 << 16)
                is_multicast = sock is self._group
                if sender[1] == self.address[1] or (
                    self.faults.ignores_multicast if is_multicast else self.faults.ignores_unicast
                ):
                    continue
                if self.faults.drops_large and len(datagram) > 1500:
                    continue
                packet = judp.unpack(datagram)[0]
                self.received.append(packet)
                if (
                    self.faults.ignores_wildcard
                    and packet.destination.component == 255
                    and packet.destination.subsystem != 65535
                ):
                    continue
                for payload, flag in self._answers(packet.payload):
                    self._sequence += 1
                    answer = Packet(self.id, packet.source, payload, self._sequence, data_flag=flag)
                    self._sender.sendto(judp.pack(answer), sender)

    def _is_lost(self, datagram: bytes, *, is_multicast: bool) -> bool:
        if self.faults.drops_large and len(datagram) > 1500:
            return True
        return self.faults.ignores_multicast if is_multicast else self.faults.ignores_unicast

    def _answers(self, payload: bytes) -> Iterator[tuple[bytes, DataFlag]]:
        name = registry.decode(payload).NAME
        if name in self.faults.silent_to:
            return
        made = getattr(self, f"_{name}", None)
        answer = None if made is None else made()
        if answer is None:
            return
        if name == "QueryIdentification" and self.faults.incomplete:
            yield answer[:4], DataFlag.FIRST
        if name == "QueryStatus" and self.faults.truncated:
            answer = answer[:-4]
        yield answer, DataFlag.SINGLE

    def _QueryIdentification(self) -> bytes:  # noqa: N802 - named after its message
        return ReportIdentification(4, 60001, "peer").encode()

    def _QueryServices(self) -> bytes:  # noqa: N802
        services = [
            {"uri": u, "major_version_number": a, "minor_version_number": b} for u, a, b in self.faults.services
        ]
        component = {"component_rec": {"component_id": self.id.component, "instance_id": 0}, "service_list": services}
        node = {"node_rec": {"node_id": self.id.node}, "component_list": [component]}
        return ReportServices.from_dict({"node_list": [node]}).encode()

    def _QueryControl(self) -> bytes:  # noqa: N802
        return ReportControl(*self.faults.holder, self.faults.authority if any(self.faults.holder) else 0).encode()

    def _QueryAuthority(self) -> bytes:  # noqa: N802
        return ReportAuthority(self.faults.authority).encode()

    def _QueryStatus(self) -> bytes:  # noqa: N802
        return ReportStatus(self.faults.status, 0).encode()

    def _QueryTime(self) -> bytes:  # noqa: N802
        now = datetime.now(UTC) + self.faults.clock
        stamp = now.microsecond // 1000 | now.second << 10 | now.minute << 16 | now.hour << 22 | now.day << 27
        date = now.day | now.month << 5 | (now.year - 2000) << 9
        vector = self.faults.presence if self.faults.presence is not None else 1
        fields = stamp.to_bytes(4, "little") if vector & 1 else b""
        fields += date.to_bytes(2, "little") if vector & 2 else b""
        return b"\x11\x40" + bytes([vector]) + fields

    def _QuerySealChallenge(self) -> bytes | None:  # noqa: N802
        return None if self.faults.seal is None else ReportSealChallenge(1_000_000, 77).encode()

    def _SealedCommand(self) -> bytes:  # noqa: N802
        if isinstance(self.faults.seal, RejectCommand.Reason):
            return RejectCommand(0x200D, 1, self.faults.seal).encode()
        return self._QueryControl()


@contextlib.contextmanager
def udp_peer(port: int, **faults: Any) -> Iterator[UdpPeer]:
    """A peer on 127.0.0.1 with these faults."""
    with UdpPeer(port, Faults(**faults)) as peer:
        yield peer
