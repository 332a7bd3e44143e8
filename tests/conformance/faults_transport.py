"""Endpoints and node managers that the transport profile must catch."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from typing import Any, Final

from tests.conformance.injectors import (
    Fault,
    Injector,
    gets,
    handles,
    hears,
    packets,
    patched,
    repacked,
    works,
)
from tests.conformance.simulated import TARGET

from jauspy.conformance import TargetComponent, VirtualTarget
from jauspy.conformance.link import Arrival
from jauspy.conformance.profiles import transport as transport_steps
from jauspy.conformance.profiles.raw_packets import FIRST_NUMBER
from jauspy.conformance.virtual_target import OTHER_PORT, USUAL_PORT
from jauspy.ids import JausID
from jauspy.messages import core
from jauspy.protocol import endpoint, judp
from jauspy.protocol.header import Ack, Broadcast, DataFlag, Packet


def wire(name: str, trips: str, inject: Injector) -> Fault:
    return Fault(name, "transport", tuple(trips.split()), inject)


def answers_first_port() -> Injector:
    """Whoever was heard from one port is answered there for ever."""

    class Stale(VirtualTarget):
        def reply_port(self, port: Any) -> Any:
            return USUAL_PORT

    return lambda: (TargetComponent, Stale, [])


def answers_last_port() -> Injector:
    """All clients of a host are answered at the port that one of them used last."""

    class Mixed(VirtualTarget):
        last: Any = USUAL_PORT

        def send(self, datagram: bytes, source: JausID, *, other_port: bool = False) -> None:
            if other_port:
                self.last = OTHER_PORT
            super().send(datagram, source, other_port=other_port)

        def reply_port(self, port: Any) -> Any:
            return self.last

    return lambda: (TargetComponent, Mixed, [])


def drops(condition: Callable[[Packet], bool]) -> Injector:
    """The component never gets packets of a kind."""
    return handles(lambda _, datagram: [] if any(condition(each) for each in packets(datagram)) else [datagram])


def rewritten(change: Callable[[TargetComponent, Packet], Packet]) -> Injector:
    """The component gets packets with another header."""
    return handles(lambda part, datagram: [judp.pack(change(part, each)) for each in packets(datagram)])


def hangs_on(condition: Callable[[bytes], bool]) -> Injector:
    """Some datagram ends the node manager."""

    class Fragile(VirtualTarget):
        hung = False

        def inbound(self, datagram: bytes) -> Iterable[bytes]:
            self.hung = self.hung or condition(datagram)
            return () if self.hung else (datagram,)

    return lambda: (TargetComponent, Fragile, [])


def echoes_on(condition: Callable[[bytes], bool]) -> Injector:
    """The node manager answers some datagram with a NAK, to whoever seems to have sent it."""

    class Chatty(VirtualTarget):
        def inbound(self, datagram: bytes) -> Iterable[bytes]:
            if condition(datagram):
                me = next(iter(self.components))
                nak = Packet(me, JausID(42, 1, 1), b"", 0, ack=Ack.NAK)
                self._arrived.append(Arrival(judp.pack(nak)))
            return (datagram,)

    return lambda: (TargetComponent, Chatty, [])


def leaves_flagged(flag: Broadcast) -> Injector:
    """The node manager sends each packet once, to its destination, but with this flag."""

    class Flagged(VirtualTarget):
        def outbound(self, datagram: bytes) -> Iterable[bytes]:
            return [judp.pack(replace(each, broadcast=flag)) for each in packets(datagram)]

    return lambda: (TargetComponent, Flagged, [])


def is_broken(datagram: bytes) -> bool:
    """Not one whole packet with a message that is known."""
    found, errors = judp.unpack_all(datagram)
    return bool(errors) or not found


def ack_changed(**fields: Any) -> Injector:
    odd = repacked(lambda packet: replace(packet, **fields) if packet.ack is Ack.ACK else packet)
    return works(odd)


def has_code(packet: Packet, *codes: bytes) -> bool:
    return packet.payload[:2] in codes


def payload_is(*wanted: bytes) -> Callable[[bytes], bool]:
    return lambda datagram: any(
        each.payload in wanted and each.data_flag is DataFlag.SINGLE and each.ack is Ack.NONE
        for each in packets(datagram)
    )


def _again(datagram: bytes) -> bytes:
    """The same packet under another number, so that it is not known."""
    (packet,) = packets(datagram)
    return judp.pack(replace(packet, sequence=packet.sequence ^ 0x4000))


def _readdressed(datagram: bytes, change: Callable[[JausID], JausID]) -> bytes:
    found = packets(datagram)
    if len(found) != 1 or judp.unpack_all(datagram)[1]:
        return datagram
    return judp.pack(replace(found[0], destination=change(found[0].destination)))


def _from_first(datagram: bytes) -> bytes:
    found = packets(datagram)
    if len(found) != 1 or not found[0].source.is_wildcard:
        return datagram
    return judp.pack(replace(found[0], source=JausID(42, 1, 1)))


def every_second() -> Injector:
    state = [0]

    def change(payload: bytes, source: JausID) -> bytes | None:
        state[0] += 1
        return payload if state[0] % 2 else None

    return hears(change)


def acknowledges_all() -> Injector:
    class Eager(TargetComponent):
        def receive(self, payload: bytes, source: JausID, now: float) -> None:
            self.extra = judp.pack(Packet(self.host.id, source, b"", 1, ack=Ack.ACK))
            super().receive(payload, source, now)

        def work(self, now: float) -> list[bytes]:
            out = super().work(now)
            extra, self.extra = getattr(self, "extra", b""), b""
            return [*out, extra] if extra else out

    return lambda: (Eager, VirtualTarget, [])


def _only_acknowledge(part: TargetComponent, datagram: bytes) -> Iterable[bytes]:
    """What wants to be acknowledged is, and is then forgotten."""
    (packet,) = packets(datagram)
    return [judp.pack(replace(packet, payload=b""))] if packet.ack is Ack.REQUIRED else [datagram]


def _once(
    condition: Callable[[Packet], bool], *, by_payload: bool = False, by_source: bool = True, spoils: bool = False
) -> Callable[[TargetComponent, bytes], Iterable[bytes]]:
    """Packets with a key that was there before are lost; or everything of their source, when they spoil it."""
    seen: set[object] = set()

    def change(part: TargetComponent, datagram: bytes) -> Iterable[bytes]:
        (packet,) = packets(datagram)
        key = (packet.payload if by_payload else packet.sequence, packet.source if by_source else None, id(part))
        known = condition(packet) and key in seen
        seen.add(key)
        if known and spoils:
            seen.add((packet.sequence + 1, packet.source, id(part)))
        return [] if known else [datagram]

    return change


def in_order() -> Callable[[TargetComponent, bytes], Iterable[bytes]]:
    """A piece that does not continue the one before is lost."""
    last: dict[JausID, int] = {}

    def change(_: TargetComponent, datagram: bytes) -> Iterable[bytes]:
        (packet,) = packets(datagram)
        if packet.data_flag in (DataFlag.MIDDLE, DataFlag.LAST) and last.get(packet.source) != packet.sequence - 1:
            return []
        last[packet.source] = packet.sequence
        return [datagram]

    return change


def first_is_all() -> Injector:
    """The first piece counts as the whole query; the others are lost."""

    def change(part: TargetComponent, datagram: bytes) -> Iterable[bytes]:
        (packet,) = packets(datagram)
        if packet.data_flag is DataFlag.SINGLE:
            return [datagram]
        if packet.data_flag is not DataFlag.FIRST:
            return []
        return [
            judp.pack(
                replace(packet, payload=core.QueryEvents(core.AllEventsRec(0)).encode(), data_flag=DataFlag.SINGLE)
            )
        ]

    return handles(change)


def impatient() -> Callable[[TargetComponent, bytes], Iterable[bytes]]:
    """A middle piece that comes after the last one is lost."""
    ended: set[tuple[JausID, int]] = set()

    def change(_: TargetComponent, datagram: bytes) -> Iterable[bytes]:
        (packet,) = packets(datagram)
        if packet.data_flag is DataFlag.LAST:
            ended.add((packet.source, packet.sequence))
        late = packet.data_flag is DataFlag.MIDDLE and (packet.source, packet.sequence + 1) in ended
        return [] if late else [datagram]

    return change


class _Anybody:
    """Stands for the sender that makes garbage, to know it again."""

    ping = core.QueryEvents(core.AllEventsRec(0)).encode()

    def packet(self, payload: bytes | None = None) -> Packet:
        return Packet(JausID(42, 1, 1), JausID(105, 1, 1), self.ping if payload is None else payload, 0)


def _like(step: str) -> Callable[[bytes], bool]:
    """True for the garbage of this step, whatever its sequence number."""
    sample = dict(zip(GARBAGE, (make for _, make in transport_steps.GARBAGE), strict=True))[step](_Anybody())  # type: ignore[arg-type]
    cut = -2 if len(sample) > 12 and step != "garbage-15" else len(sample)

    def same(datagram: bytes) -> bool:
        return len(datagram) == len(sample) and datagram[:cut] == sample[:cut]

    return same


GARBAGE: Final = {f"garbage-{number:02}": name for number, (name, _) in enumerate(transport_steps.GARBAGE, 1)}

FIRST: Final = {"garbage-12": "restart"}
"""Steps that send the same garbage before."""

TRANSPORT: Final = (
    wire("no query is answered", "query", hears(lambda payload, source: None)),
    wire(
        "unicasts are ignored",
        "unicast priority-1 sequence repeat",
        drops(lambda packet: not packet.destination.is_wildcard),
    ),
    *(
        wire(f"priority {n} is ignored", f"priority-{n}", drops(lambda packet, n=n: packet.priority == n))
        for n in (0, 2, 3)
    ),
    wire(
        "priority 1 is ignored, but for broadcasts",
        "priority-1",
        drops(lambda packet: packet.priority == 1 and not packet.destination.is_wildcard),
    ),
    wire("component 255 is ignored", "query", drops(lambda p: p.destination.component == 255)),
    wire(
        "component 255 is ignored later",
        "wildcard-component wildcard-node-component wildcard-all broadcast-none",
        drops(lambda p: p.destination.component == 255 and p.sequence >= FIRST_NUMBER),
    ),
    wire(
        "node 255 is ignored",
        "wildcard-node wildcard-node-component wildcard-all",
        drops(lambda p: p.destination.node == 255),
    ),
    wire(
        "subsystem 65535 is ignored",
        "wildcard-subsystem wildcard-all",
        drops(lambda p: p.destination.subsystem == 65535),
    ),
    wire(
        "wildcards are answered twice",
        "wildcard-component wildcard-all",
        handles(lambda _, data: [data, _again(data)] if packets(data)[0].destination.is_wildcard else [data]),
    ),
    wire(
        "any node is its own",
        "other-node",
        gets(lambda data: [_readdressed(data, lambda to: replace(to, node=1) if to.subsystem == 105 else to)]),
    ),
    wire(
        "100 and 356 are the same",
        "other-subsystem other-subsystem-wildcard",
        gets(
            lambda data: [
                _readdressed(data, lambda to: replace(to, subsystem=105) if to.subsystem & 0xFF == 105 else to)
            ]
        ),
    ),
    wire("local broadcasts are ignored", "broadcast-local", drops(lambda packet: packet.broadcast is Broadcast.LOCAL)),
    wire(
        "wildcards need a broadcast flag",
        "broadcast-none",
        drops(lambda p: p.destination.is_wildcard and p.broadcast is Broadcast.NONE),
    ),
    wire(
        "answers are broadcasts",
        "answer-unicast",
        works(repacked(lambda packet: replace(packet, broadcast=Broadcast.GLOBAL))),
    ),
    wire("answers have the flag of broadcasts", "answer-unicast", leaves_flagged(Broadcast.GLOBAL)),
    wire(
        "broadcasts are not answered later",
        "answer-unicast",
        drops(lambda p: p.broadcast is Broadcast.GLOBAL and p.sequence >= FIRST_NUMBER),
    ),
    wire("a source that is a wildcard is answered", "source-wildcard", gets(lambda data: [_from_first(data)])),
    wire(
        "a source that is a wildcard ends it",
        "source-wildcard",
        hangs_on(lambda data: any(each.source.is_wildcard for each in packets(data))),
    ),
    wire(
        "only the first packet of a datagram is read",
        "packed packed-clients",
        gets(lambda data: [judp.pack(packets(data)[0])] if len(packets(data)) > 1 else [data]),
    ),
    wire(
        "only the last packet of a datagram is read",
        "packed packed-clients",
        gets(lambda data: [judp.pack(packets(data)[-1])] if len(packets(data)) > 1 else [data]),
    ),
    wire(
        "garbage behind a packet spoils it",
        "packed-garbage",
        gets(lambda data: [] if judp.unpack_all(data)[1] else [data]),
    ),
    wire(
        "sequence numbers stand still",
        "sequence",
        works(repacked(lambda packet: packet if packet.ack is Ack.ACK else replace(packet, sequence=5))),
    ),
    wire("only every second query is answered", "sequence repeat", every_second()),
    wire(
        "nothing is acknowledged",
        "ack ack-resend pieces-ack",
        works(repacked(lambda packet: None if packet.ack is Ack.ACK else packet)),
    ),
    wire("ACKs have number 0", "ack ack-resend pieces-ack", ack_changed(sequence=0)),
    wire("ACKs carry something", "ack", ack_changed(payload=b"\x00")),
    wire("everything is acknowledged", "ack-unasked", acknowledges_all()),
    wire("what is acknowledged is not answered", "ack ack-resend pieces-ack", handles(_only_acknowledge)),
    wire("resends are not acknowledged", "ack-resend", handles(_once(lambda packet: packet.ack is Ack.REQUIRED))),
    wire(
        "resends are answered again",
        "ack-resend duplicate",
        patched(endpoint.Duplicates, seen=lambda *args, **options: False),
    ),
    wire(
        "stray ACKs are answered",
        "ack-stray",
        echoes_on(lambda data: any(each.ack is Ack.ACK for each in packets(data))),
    ),
    wire(
        "stray NAKs are answered",
        "nak-stray",
        echoes_on(lambda data: any(each.ack is Ack.NAK for each in packets(data))),
    ),
    wire(
        "packets for other nodes end it",
        "other-node",
        hangs_on(lambda data: any(each.destination.node not in (TARGET.node, 255) for each in packets(data))),
    ),
    wire("stray ACKs end it", "ack-stray", hangs_on(lambda data: any(each.ack is Ack.ACK for each in packets(data)))),
    wire("stray NAKs end it", "nak-stray", hangs_on(lambda data: any(each.ack is Ack.NAK for each in packets(data)))),
    wire("equal queries are taken for duplicates", "repeat", handles(_once(lambda packet: True, by_payload=True))),
    wire(
        "a known number is a duplicate, whatever it carries",
        "restart",
        handles(_once(lambda packet: packet.data_flag is DataFlag.SINGLE)),
    ),
    wire(
        "a number is a duplicate, whoever sends it",
        "same-number",
        handles(_once(lambda packet: packet.data_flag is DataFlag.SINGLE, by_source=False)),
    ),
    wire(
        "pieces are ignored",
        "pieces-2 pieces-3 pieces-order pieces-twice pieces-ack",
        drops(lambda packet: packet.data_flag is not DataFlag.SINGLE),
    ),
    wire("pieces must come in order", "pieces-order", handles(in_order())),
    wire(
        "a repeated piece spoils the message",
        "pieces-twice",
        handles(_once(lambda packet: packet.data_flag is not DataFlag.SINGLE, spoils=True)),
    ),
    wire("the first piece is taken for all", "pieces-missing pieces-crossed", first_is_all()),
    wire("pieces that come late are lost", "pieces-missing", handles(impatient())),
    wire(
        "pieces of all sources are one",
        "pieces-crossed",
        rewritten(
            lambda part, packet: (
                replace(packet, source=JausID(42, 1, 1)) if packet.data_flag is not DataFlag.SINGLE else packet
            )
        ),
    ),
    wire(
        "middle pieces end it",
        "pieces-3 pieces-order",
        hangs_on(lambda data: any(each.data_flag is DataFlag.MIDDLE for each in packets(data))),
    ),
    wire(
        "pieces of all sources are the second client's",
        "pieces-crossed",
        rewritten(
            lambda part, packet: (
                replace(packet, source=JausID(42, 2, 1)) if packet.data_flag is not DataFlag.SINGLE else packet
            )
        ),
    ),
    *(wire(f"{name} ends it", FIRST.get(step, step), hangs_on(_like(step))) for step, name in GARBAGE.items()),
    *(wire(f"{name} is answered", step, echoes_on(_like(step))) for step, name in GARBAGE.items()),
    wire("bytes too many end it", "long", hangs_on(payload_is(transport_steps.IDENTIFICATION_QUERY + bytes(3)))),
    wire("bytes too few end it", "short", hangs_on(payload_is(transport_steps.IDENTIFICATION_QUERY[:-1]))),
    wire("everybody is answered at port 3794", "port-other port-back port-neighbour", answers_first_port()),
    wire("a host is answered at one port", "port-back", answers_last_port()),
)
