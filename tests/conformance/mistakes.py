"""Mistakes that robots make, shared by several tables of faults."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import replace
from typing import Any
from unittest.mock import patch

from tests.conformance.injectors import Injector, _spoilt, code, hears, instead, packets, says

from jauspy.codec.message import Message
from jauspy.conformance import TargetComponent, VirtualTarget, waypoint_drive
from jauspy.ids import JausID
from jauspy.messages import core, mobility
from jauspy.protocol.header import Packet
from jauspy.services import host
from jauspy.services.core import Events
from jauspy.services.core.subscriptions import Subscriptions
from jauspy.services.mobility import LocalPoseSensor


def sixty_hertz(self: Events, subscription: Any, asked: float) -> None:
    """The raw value of the rate is taken for hertz."""
    subscription.confirmed = asked
    subscription.period = 1.0 / (asked * 65535 / 1092)


def anybody(self: object, source: object) -> bool:
    return True


def anything(*_: object) -> bool:
    return True


def unmasked(report: Message, query: Message) -> Message:
    return report


def idle(self: object) -> None:
    return None


def clears_all(self: Any, source: object) -> None:
    self._emergency_clients.clear()


def ignored(self: object, *_: object) -> None:
    return None


def not_for_255(part: TargetComponent, datagram: bytes) -> Iterable[bytes]:
    return [] if any(each.destination.component == 255 for each in packets(datagram)) else [datagram]


def not_notified(payload: bytes, to: JausID) -> list[bytes]:
    return [] if payload[:2] == code(core.RejectControl) and str(to) == "42.2.1" else [payload]


def chatty(*kinds: type[Message]) -> Injector:
    """Answers commands that have no answer, with a status that nobody asked for."""
    codes = {code(each) for each in kinds}

    class Chatty(TargetComponent):
        def receive(self, payload: bytes, source: JausID, now: float) -> None:
            super().receive(payload, source, now)
            if payload[:2] in codes:
                self.host.send(source, core.ReportStatus(core.ReportStatus.Status.READY, 0))

    return lambda: (Chatty, VirtualTarget, [])


def stuck(event: Any) -> None:
    event.sequence_number = 7


def no_nodes(report: Any) -> None:
    report.node_list = []


def no_components(report: Any) -> None:
    for node in report.node_list:
        node.component_list = []


def no_services(report: Any) -> None:
    for node in report.node_list:
        for component in node.component_list:
            component.service_list = []


def wrong_report(event: Any) -> None:
    event.report_message = core.ReportTimeout(5)


def half_listed(report: Any) -> None:
    report.element_list = []


def undefined_fields(report: Any) -> None:
    report.reserved_presence = 1 << 15


def nothing_in_it(report: Any) -> Message:
    return type(report)()


Status = core.ReportStatus.Status
ACCEPTED, UNAVAILABLE, INSUFFICIENT = core.ConfirmControl.ResponseCode


class Still(VirtualTarget):
    """A robot without motors: no time passes for it."""

    def __init__(self, *args: Any, **options: Any) -> None:
        super().__init__(*args, **(options | {"tick": None}))


def freezes(number: int) -> Injector:
    """The pose stands still once the robot is at a corner of the square."""

    def inject() -> tuple[type[TargetComponent], type[VirtualTarget], list[Any]]:
        seen: list[Any] = []

        def change(pose: Any) -> None:
            if pose.x is None:
                return
            if not seen:
                seen.append((pose.x, pose.y))
            corner = (waypoint_drive.corners(*seen[0])[number - 1]) if number else seen[0]
            if len(seen) > 1 or math.dist((pose.x, pose.y), corner) < 0.4:
                seen.append(corner)
                pose.x, pose.y = corner

        return instead(mobility.ReportLocalPose, change)()

    return inject


def obeys_everybody() -> Injector:
    """A pose is taken from whoever sends it."""

    class Obedient(TargetComponent):
        def receive(self, payload: bytes, source: JausID, now: float) -> None:
            sensor = self.host.service(LocalPoseSensor)
            if payload[:2] == code(mobility.SetLocalPose) and sensor is not None:
                sensor.update_local_pose(mobility.SetLocalPose.decode(payload))
            super().receive(payload, source, now)

    return lambda: (Obedient, VirtualTarget, [])


def goes_on() -> Injector:
    """Who has cancelled an event gets it all the same."""
    return lambda: (
        TargetComponent,
        VirtualTarget,
        [
            patch.object(host.Host, "cancel_timer", ignored),
            patch.object(Subscriptions, "holds", lambda self, subscription: True),
        ],
    )


def confirmed(request: int, **values: object) -> Injector:
    """The confirmation of one request says something else."""

    def change(message: Any) -> None:
        if message.request_id == request:
            for name, value in values.items():
                setattr(message, name, value)

    return instead(core.ConfirmEventRequest, change)


def short_inside(event: Any) -> None:
    report = event.report_message
    event.report_message = _spoilt(report.encode() if isinstance(report, Message) else report)


def skipping() -> Injector:
    """Events are numbered by twos."""

    def change(event: Any) -> None:
        event.sequence_number = event.sequence_number * 2 & 0xFF

    return instead(core.Event, change)


def to_winner() -> Injector:
    """The new controller is notified of the loss instead of the former one."""

    class Confused(TargetComponent):
        winner: Any = None

        def receive(self, payload: bytes, source: JausID, now: float) -> None:
            self.winner = source if payload[:2] == code(core.RequestControl) else self.winner
            super().receive(payload, source, now)

        def send(self, outgoing: Any, now: float) -> None:
            astray = self.winner is not None and outgoing.payload[:2] == code(core.RejectControl)
            super().send(outgoing._replace(destination=self.winner) if astray else outgoing, now)

    return lambda: (Confused, VirtualTarget, [])


def elsewhere(number: int, kind: type[Message]) -> Callable[[Packet], Packet]:
    """Messages of this kind come from another component."""
    return lambda packet: (
        replace(packet, source=replace(packet.source, component=number)) if packet.payload[:2] == code(kind) else packet
    )


def swapped_bits(kind: type[Message]) -> Injector:
    """The first two bits of a presence vector are mixed up."""

    def change(payload: bytes, source: JausID) -> bytes:
        if payload[:2] != code(kind):
            return payload
        asked = payload[2]
        return payload[:2] + bytes([asked & ~3 | (asked & 1) << 1 | (asked & 2) >> 1]) + payload[3:]

    return hears(change)


def big_endian(kind: type[Message], at: int) -> Injector:
    """Two bytes of a report are in the order of another processor."""
    return says(
        lambda payload, _: (
            [payload[:at] + payload[at : at + 2][::-1] + payload[at + 2 :]] if payload[:2] == code(kind) else [payload]
        )
    )


def reports_pass() -> Injector:
    """An event on a report is confirmed."""
    return instead(core.RejectEventRequest, lambda message: core.ConfirmEventRequest(message.request_id, 77, 0.5))
