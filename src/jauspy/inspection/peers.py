"""Implementations of JAUS that deviate in known ways: how their traffic looks, and what is known of each."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Final

from jauspy.capture.dissect import OPC_MARK
from jauspy.errors import ConfigError
from jauspy.ids import JausID, message_id
from jauspy.protocol import judp, junior
from jauspy.protocol.header import Ack, Broadcast, DataFlag, Packet
from jauspy.protocol.judp import MULTICAST_GROUP, PORT

MAX_HOSTS: Final = 256
"""Hosts whose signs are kept; the one that was heard longest ago is forgotten first."""
QUERY_CODES: Final = range(0x2000, 0x3000)
OPENJAUS_GROUP: Final = "224.1.0.1"


@dataclass(frozen=True, slots=True)
class Deviation:
    """One known deviation from the standard, or limit."""

    what: str
    reference: str
    """Row of docs/peers.md."""
    steps: frozenset[str] = frozenset()
    """Steps of the conformance profile `transport` that fail because of it."""


@dataclass(frozen=True, slots=True)
class PeerKind:
    """An implementation, by the name that `--peer` takes."""

    name: str
    title: str
    deviations: tuple[Deviation, ...]
    multicast_group: str | None = None
    """The group that its node manager uses, if it is not the registered one."""
    max_message: int | None = None
    """Bytes of the largest message that its components put together; larger ones are lost without a notice."""

    def known_of(self, step: str) -> Deviation | None:
        """The deviation because of which this step of the conformance profile `transport` fails; None without one."""
        return next((deviation for deviation in self.deviations if step in deviation.steps), None)


def _steps(*names: str) -> frozenset[str]:
    return frozenset(names)


_RESTARTED: Final = "the first messages of a restarted client are acknowledged and dropped as duplicates"
_SUBSYSTEMS: Final = "ids are compared byte by byte, so that 100.1.2 is taken for 356.1.2"
_LOWER_BITS: Final = "the lower two bits of the message type are taken for header compression"

JTS: Final = PeerKind(
    "jts",
    "JAUS Toolset (Junior), or a fork of it",
    (
        Deviation("priority 0 is sent with a control byte of FF", "J7"),
        Deviation(_RESTARTED, "J8", _steps("restart")),
        Deviation(_SUBSYSTEMS, "J4", _steps("other-subsystem", "other-subsystem-wildcard")),
        Deviation("local broadcasts reach the network, and each message to an unknown id floods it", "J9"),
        Deviation("malformed local datagrams are multicast as empty messages from 0.0.0", "J6"),
        Deviation("messages above 51 fragments (203,951 bytes) are lost without a notice", "common to all"),
    ),
    max_message=203_951,
)
FKIE: Final = PeerKind(
    "fkie",
    "FKIE's node manager or components",
    (
        Deviation("wildcards are sent without the flag of broadcasts, if the component sets none", "P12"),
        Deviation("only the first of several packets in a datagram is read", "P3", _steps("packed", "packed-clients")),
        Deviation(_LOWER_BITS, "P3"),
        Deviation("packets with a data size below 14 are forwarded", "P4"),
        Deviation("unicasts of components that connect by UDP arrive twice", "C1", _steps("unicast")),
        Deviation("components keep duplicates, and send nothing again", "C3", _steps("duplicate", "ack-resend")),
    ),
)
OPENJAUS: Final = PeerKind(
    "openjaus",
    "OpenJAUS 3",
    (
        Deviation("it sends headers before AS5669A, which begin with JAUS01.0", "O1", _steps("query", "unicast")),
        Deviation(f"its multicast group is {OPENJAUS_GROUP} instead of {MULTICAST_GROUP}", "O2"),
    ),
    multicast_group=OPENJAUS_GROUP,
)
KINDS: Final[Mapping[str, PeerKind]] = {kind.name: kind for kind in (JTS, FKIE, OPENJAUS)}
"""All kinds, by name."""


def find_kind(name: str) -> PeerKind:
    """The kind of this name; raises `ConfigError` that lists the names."""
    kind = KINDS.get(name.casefold())
    if kind is None:
        raise ConfigError(f"--peer {name!r} is not known; choose one of {', '.join(KINDS)}")
    return kind


MAX_SEEN: Final = 1000
"""Datagrams of a host that are looked at; looking takes as long as decoding."""


class PeerRecogniser:
    """Recognises implementations by what they send, host by host; a sign is enough, since no other stack sends it."""

    def __init__(self) -> None:
        self._signs: dict[str, dict[str, str]] = {}
        self._seen: Counter[str] = Counter()

    def looks_at(self, host: str) -> bool:
        """False once enough was seen of a host, or of as many hosts as it remembers."""
        seen = self._seen.get(host)
        return seen < MAX_SEEN if seen is not None else len(self._seen) < MAX_HOSTS

    def see(
        self,
        payload: bytes,
        source: tuple[str, int],
        destination: tuple[str, int],
        packets: Iterable[Packet] | None = None,
    ) -> None:
        """Take a datagram with its UDP addresses into account. Never raises.

        `packets` are those in it, for callers that have parsed it already. Only the first ones of a host are looked at.
        """
        if not self.looks_at(source[0]):
            return
        self._seen[source[0]] += 1
        for name, sign in signs(payload, source, destination, packets):
            self._signs.setdefault(source[0], {}).setdefault(name, sign)

    def kinds_of(self, host: str) -> list[tuple[PeerKind, str]]:
        """The kinds that were recognised at a host, each with its sign; may be called from another thread."""
        return [(KINDS[name], sign) for name, sign in tuple(self._signs.get(host, {}).items())]

    @property
    def found(self) -> dict[str, list[tuple[PeerKind, str]]]:
        """The recognised kinds by host, each with the sign by which it was recognised."""
        return {host: self.kinds_of(host) for host in tuple(self._signs)}

    def notes(self) -> list[str]:
        """A sentence for each host and kind."""
        return [
            f"{host} looks like {kind.title}: {sign}. Known of {kind.name.upper()}: "
            + "; ".join(f"{deviation.what} ({deviation.reference})" for deviation in kind.deviations)
            for host, kinds in self.found.items()
            for kind, sign in kinds
        ]


def signs(
    payload: bytes, source: tuple[str, int], destination: tuple[str, int], packets: Iterable[Packet] | None = None
) -> Iterable[tuple[str, str]]:
    """The signs in one datagram: name of the kind, and what was seen."""
    if payload.startswith(OPC_MARK):
        yield "openjaus", "a header that begins with JAUS01.0"
        return
    if destination[0] == OPENJAUS_GROUP:
        yield "openjaus", f"a datagram to {OPENJAUS_GROUP}"
    control = junior.parse(payload)
    if control is not None:
        if control.kind is junior.ControlKind.CONNECT and destination[1] == PORT and source[1] not in (0, PORT):
            yield "fkie", f"Connect of {control.id} by UDP from port {source[1]}, as components of iop_core do"
        return
    for packet in judp.unpack_all(payload)[0] if packets is None else packets:
        yield from _signs_of(
            packet, is_multicast=destination[0] == MULTICAST_GROUP and not source[0].startswith("127.")
        )


def _signs_of(packet: Packet, *, is_multicast: bool) -> Iterable[tuple[str, str]]:
    nobody = JausID(0, 0, 0)
    flags = packet.broadcast, packet.ack, packet.data_flag
    if packet.payload and flags == (Broadcast.RESERVED, Ack.ACK, DataFlag.LAST):
        yield "jts", "a control byte of FF, with which its library sends priority 0"
    elif packet.source == packet.destination == nobody and not packet.payload:
        yield "jts", "an empty message from 0.0.0 to 0.0.0, which its node manager makes of malformed ones"
    elif is_multicast and packet.broadcast is Broadcast.GLOBAL and packet.ack is Ack.REQUIRED:
        if not packet.destination.is_wildcard and not _is_query(packet.payload):  # jauspy searches with such queries
            yield "jts", f"a multicast to {packet.destination} with the flag of broadcasts and ACK required"
    elif is_multicast and packet.broadcast is Broadcast.NONE and packet.destination.is_wildcard:
        yield "fkie", f"a multicast to {packet.destination} without the flag of broadcasts"


def _is_query(payload: bytes) -> bool:
    """True for the ids that the standard has for queries."""
    return len(payload) >= 2 and message_id(payload) in QUERY_CODES
