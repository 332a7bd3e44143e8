"""Robots that are broken on purpose: each with one small fault, and the steps that must catch it.

A fault mangles what a component hears or says, what its node manager gets or sends, or a method of a service.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from contextlib import ExitStack
from dataclasses import dataclass, replace
from typing import Any, Final
from unittest.mock import patch

from tests.conformance.simulated import examined, robot

from jauspy.codec.base import Message
from jauspy.conformance import Bench, Part, Report, drive
from jauspy.conformance.bench import STRANGE, USUAL
from jauspy.conformance.packets import FIRST_NUMBER
from jauspy.conformance.profiles import transport
from jauspy.conformance.wire import Arrival
from jauspy.ids import JausID
from jauspy.messages import core, mobility
from jauspy.modules import announcement
from jauspy.protocol import endpoint, judp
from jauspy.protocol.header import Ack, Broadcast, DataFlag, Packet
from jauspy.services import host
from jauspy.services.core import AccessControl, Events, Management
from jauspy.services.core.subscriptions import Subscriptions
from jauspy.services.mobility import LocalPoseSensor

Injector = Callable[[], tuple[type[Part], type[Bench], list[Any]]]
"""What to build the robot of, and what to patch while it lives."""


@dataclass(frozen=True)
class Fault:
    """`trips`: steps that must not pass because of it."""

    name: str
    profile: str
    trips: tuple[str, ...]
    inject: Injector
    timeout: int | None = None
    motion: bool = False
    """Let the robot drive; others stand still, which is faster."""
    only: tuple[str, ...] = ()

    def __str__(self) -> str:
        return f"{self.profile}: {self.name}"

    def run(self) -> Report:
        """The profile against the broken robot."""
        part, bench, patches = self.inject()
        with ExitStack() as stack:
            for each in patches:
                stack.enter_context(each)
            still: dict[str, Any] = {} if self.motion else {"tick": None}
            target = robot(part, bench, timeout=self.timeout, **still)
            return examined(self.profile, target, motion=self.motion, only=self.only)


# --- injectors ------------------------------------------------------------------------------------------------------


def hears(change: Callable[[bytes, JausID], bytes | None]) -> Injector:
    """Messages that come in are changed, or lost."""

    class Deaf(Part):
        def hear(self, payload: bytes, source: JausID, now: float) -> None:
            heard = change(payload, source)
            if heard is not None:
                super().hear(heard, source, now)

    return lambda: (Deaf, Bench, [])


def says(change: Callable[[bytes, JausID], Iterable[bytes]]) -> Injector:
    """Messages that go out are changed, lost or doubled."""

    class Liar(Part):
        def say(self, outgoing: Any, now: float) -> None:
            for payload in change(outgoing.payload, outgoing.destination):
                super().say(replace(outgoing, payload=payload), now)

    return lambda: (Liar, Bench, [])


def patched(owner: object, **methods: object) -> Injector:
    """Methods of a class, or names of a module, are other ones."""
    return lambda: (Part, Bench, [patch.object(owner, name, new) for name, new in methods.items()])


def handles(change: Callable[[Part, bytes], Iterable[bytes]]) -> Injector:
    """Datagrams reach the component changed."""

    class Odd(Part):
        def handle(self, datagram: bytes, now: float) -> None:
            for each in change(self, datagram):
                super().handle(each, now)

    return lambda: (Odd, Bench, [])


def works(change: Callable[[list[bytes]], list[bytes]]) -> Injector:
    """Datagrams leave the component changed."""

    class Odd(Part):
        def work(self, now: float) -> list[bytes]:
            return change(super().work(now))

    return lambda: (Odd, Bench, [])


def gets(change: Callable[[bytes], Iterable[bytes]]) -> Injector:
    """Datagrams reach the node manager changed."""

    class Odd(Bench):
        def inbound(self, datagram: bytes) -> Iterable[bytes]:
            return change(datagram)

    return lambda: (Part, Odd, [])


def code(kind: type[Message]) -> bytes:
    return kind.CODE.to_bytes(2, "little")


def without(*kinds: type[Message]) -> Injector:
    """These are never sent."""
    codes = {code(each) for each in kinds}
    return says(lambda payload, _: [] if payload[:2] in codes else [payload])


def deaf_to(*kinds: type[Message]) -> Injector:
    """These are not understood."""
    codes = {code(each) for each in kinds}
    return hears(lambda payload, _: None if payload[:2] in codes else payload)


def instead(kind: type[Message], make: Callable[[Any], Message | None]) -> Injector:
    """Another message is sent for each of this kind; the same, changed, when `make` returns nothing."""

    def change(payload: bytes, _: JausID) -> list[bytes]:
        if payload[:2] != code(kind):
            return [payload]
        message = kind.decode(payload)
        return [(make(message) or message).encode(strict=False)]

    return says(change)


def field(kind: type[Message], **values: object) -> Injector:
    """Fields of a report have these values."""

    def change(message: Any) -> None:
        for name, value in values.items():
            setattr(message, name, value)

    return instead(kind, change)


def short(kind: type[Message]) -> Injector:
    """The last byte is missing; a message without a body has one too many."""
    return says(lambda payload, _: [_spoilt(payload)] if payload[:2] == code(kind) else [payload])


def _spoilt(payload: bytes) -> bytes:
    return payload[:-1] if len(payload) > 2 else payload + b"\0"


def slow(*kinds: type[Message], seconds: float = 2.0, where: Callable[[Any], bool] = lambda _: True) -> Injector:
    """These are said late; everything, when none is named."""
    by_code = {code(each): each for each in kinds}

    def is_late(payload: bytes) -> bool:
        kind = by_code.get(payload[:2])
        return not kinds or (kind is not None and where(kind.decode(payload)))

    class Slow(Part):
        late: tuple[tuple[float, Any], ...] = ()

        def say(self, outgoing: Any, now: float) -> None:
            if is_late(outgoing.payload):
                self.late += ((now + seconds, outgoing),)
            else:
                super().say(outgoing, now)

        def work(self, now: float) -> list[bytes]:
            out = super().work(now)
            due = [each for at, each in self.late if at <= now]
            self.late = tuple(each for each in self.late if each[0] > now)
            for each in due:
                super().say(each, now)
            return out + self.endpoint.poll_output()

        def next_timeout(self) -> float | None:
            times = [super().next_timeout(), *(at for at, _ in self.late)]
            return min((at for at in times if at is not None), default=None)

    return lambda: (Slow, Bench, [])


def later(kind: type[Message], count: int, inner: Injector) -> Injector:
    """A fault that begins when a message was heard for the so-manieth time."""

    def inject() -> tuple[type[Part], type[Bench], list[Any]]:
        broken, bench, patches = inner()

        class Later(broken):  # type: ignore[misc, valid-type]
            heard = 0

            def hear(self, payload: bytes, source: JausID, now: float) -> None:
                self.heard += payload[:2] == code(kind)
                (super().hear if self.heard >= count else lambda *args: Part.hear(self, *args))(payload, source, now)

            def say(self, outgoing: Any, now: float) -> None:
                (super().say if self.heard >= count else lambda *args: Part.say(self, *args))(outgoing, now)

        return Later, bench, patches

    return inject


def packets(datagram: bytes) -> list[Packet]:
    return judp.unpack_all(datagram)[0]


def repacked(change: Callable[[Packet], Packet | None]) -> Callable[[list[bytes]], list[bytes]]:
    """Each packet that leaves is another one, or none."""

    def all_of(out: list[bytes]) -> list[bytes]:
        changed = (change(each) for datagram in out for each in packets(datagram))
        return [judp.pack(each) for each in changed if each is not None]

    return all_of


# --- igvc-2015: what robots were seen to do, and what they might ----------------------------------------------------


def sixty_hertz(self: Events, subscription: Any, asked: float) -> None:
    """The raw value of the rate is taken for hertz."""
    subscription.confirmed = asked
    subscription.period = 1.0 / (asked * 65535 / 1092)


def anybody(self: object, source: object) -> bool:
    return True


def unmasked(report: Message, query: Message) -> Message:
    return report


def idle(self: object) -> None:
    return None


def clears_all(self: Any, source: object) -> None:
    self._emergency_clients.clear()


def ignored(self: object, *_: object) -> None:
    return None


def not_for_255(part: Part, datagram: bytes) -> Iterable[bytes]:
    return [] if any(each.destination.component == 255 for each in packets(datagram)) else [datagram]


def not_told(payload: bytes, to: JausID) -> list[bytes]:
    return [] if payload[:2] == code(core.RejectControl) and str(to) == "42.2.1" else [payload]


def chatty(*kinds: type[Message]) -> Injector:
    """Answers commands that have no answer, with a status that nobody asked for."""
    codes = {code(each) for each in kinds}

    class Chatty(Part):
        def hear(self, payload: bytes, source: JausID, now: float) -> None:
            super().hear(payload, source, now)
            if payload[:2] in codes:
                self.host.send(source, core.ReportStatus(core.ReportStatus.Status.READY, 0))

    return lambda: (Chatty, Bench, [])


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


class Still(Bench):
    """A robot without motors: no time passes for it."""

    def __init__(self, *args: Any, **options: Any) -> None:
        super().__init__(*args, **(options | {"tick": None}))


def freezes(number: int) -> Injector:
    """The pose stands still once the robot is at a corner of the square."""

    def inject() -> tuple[type[Part], type[Bench], list[Any]]:
        seen: list[Any] = []

        def change(pose: Any) -> None:
            if pose.x is None:
                return
            if not seen:
                seen.append((pose.x, pose.y))
            corner = (drive.corners(*seen[0])[number - 1]) if number else seen[0]
            if len(seen) > 1 or math.dist((pose.x, pose.y), corner) < 0.4:
                seen.append(corner)
                pose.x, pose.y = corner

        return instead(mobility.ReportLocalPose, change)()

    return inject


def obeys_everybody() -> Injector:
    """A pose is taken from whoever sends it."""

    class Obedient(Part):
        def hear(self, payload: bytes, source: JausID, now: float) -> None:
            sensor = self.host.service(LocalPoseSensor)
            if payload[:2] == code(mobility.SetLocalPose) and sensor is not None:
                sensor.update_local_pose(mobility.SetLocalPose.decode(payload))
            super().hear(payload, source, now)

    return lambda: (Obedient, Bench, [])


def goes_on() -> Injector:
    """Who has cancelled an event gets it all the same."""
    return lambda: (
        Part,
        Bench,
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


def reports_pass() -> Injector:
    """An event on a report is confirmed."""
    return instead(core.RejectEventRequest, lambda message: core.ConfirmEventRequest(message.request_id, 77, 0.5))


def igvc(name: str, trips: str, inject: Injector) -> Fault:
    return Fault(name, "igvc-2015", tuple(trips.split()), inject)


def _numbered(request: int) -> Callable[[Any], bool]:
    return lambda message: message.request_id == request


def driven(name: str, inject: Injector) -> Fault:
    return Fault(f"driving: {name}", "igvc-2015", ("80",), inject, motion=True, only=("01", "75", "80"))


DRIVE_REPORTS: Final[tuple[type[Message], ...]] = (
    core.ConfirmControl,
    core.ConfirmElementRequest,
    core.RejectControl,
    mobility.ReportActiveElement,
    mobility.ReportLocalPose,
    core.ReportStatus,
)
ENDING: Final = core.CancelEvent
"""What step 80 begins with."""

DRIVES: Final = (
    driven("the robot does not move", lambda: (Part, Still, [])),
    driven("the active element is always 3", field(mobility.ReportActiveElement, element_uid=3)),
    *(driven(f"the robot stops at waypoint {number}", freezes(number)) for number in (1, 2, 3)),
    *(driven(f"{kind.NAME} is late", slow(kind)) for kind in DRIVE_REPORTS),
    *(driven(f"{kind.NAME} is never sent", without(kind)) for kind in DRIVE_REPORTS),
    driven("the end is confirmed late", later(ENDING, 1, slow(core.ConfirmEventRequest))),
    driven("the end is confirmed in short", later(ENDING, 1, short(core.ConfirmEventRequest))),
    driven("the end is confirmed for event 99", later(ENDING, 1, field(core.ConfirmEventRequest, event_id=99))),
    driven("the end is confirmed as request 99", later(ENDING, 1, field(core.ConfirmEventRequest, request_id=99))),
    driven("the end is not confirmed", later(ENDING, 1, without(core.ConfirmEventRequest))),
    driven("poses lose their x", later(ENDING, 1, field(mobility.ReportLocalPose, x=None))),
    driven("poses lose their y", later(ENDING, 1, field(mobility.ReportLocalPose, y=None))),
    driven("lists are confirmed as request 99", field(core.ConfirmElementRequest, request_id=99)),
    driven("release is refused", field(core.RejectControl, response_code=1)),
    driven("control is never available", field(core.ConfirmControl, response_code=UNAVAILABLE)),
    driven("the status is always Standby", field(core.ReportStatus, status=Status.STANDBY)),
    driven("cancelled events go on", goes_on()),
    *(driven(f"{kind.NAME} is short", later(ENDING, 1, short(kind))) for kind in DRIVE_REPORTS),
)


IGVC_QUERIES: Final[tuple[type[Message], ...]] = (
    core.QueryIdentification,
    core.QueryConfiguration,
    core.QuerySubsystemList,
    core.QueryServices,
    core.QueryEvents,
    core.CreateEvent,
    core.UpdateEvent,
    core.CancelEvent,
    core.QueryHeartbeatPulse,
    core.QueryTimeout,
    core.QueryControl,
    core.QueryAuthority,
    core.QueryStatus,
    core.RequestControl,
    core.ReleaseControl,
    core.SetElement,
    core.QueryElementCount,
    core.QueryElementList,
    mobility.QueryTravelSpeed,
    mobility.QueryLocalWaypoint,
    mobility.QueryActiveElement,
    mobility.QueryVelocityState,
    mobility.QueryLocalPose,
)
IGVC_REPORTS: Final[tuple[type[Message], ...]] = (
    core.ReportIdentification,
    core.ReportConfiguration,
    core.ReportSubsystemList,
    core.ReportServices,
    core.ReportEvents,
    core.ConfirmEventRequest,
    core.RejectEventRequest,
    core.ReportHeartbeatPulse,
    core.ReportTimeout,
    core.ReportControl,
    core.ReportAuthority,
    core.ReportStatus,
    core.ConfirmControl,
    core.RejectControl,
    core.ConfirmElementRequest,
    core.ReportElementCount,
    core.ReportElementList,
    mobility.ReportTravelSpeed,
    mobility.ReportLocalWaypoint,
    mobility.ReportActiveElement,
    mobility.ReportVelocityState,
    mobility.ReportLocalPose,
)
LATE: Final = (
    igvc("ReportEvents is late", "05 10", slow(core.ReportEvents)),
    *(
        igvc(
            f"the confirmation of request {number} is late",
            step,
            slow(core.ConfirmEventRequest, where=_numbered(number)),
        )
        for number, step in ((4, "08"), (7, "09"))
    ),
    *(
        igvc(f"the confirmation of request {number} is short", step, later(kind, 1, short(core.ConfirmEventRequest)))
        for number, step, kind in ((4, "08", core.UpdateEvent), (7, "09", core.CancelEvent))
    ),
    igvc("RejectControl is late", "29", slow(core.RejectControl)),
    *(
        igvc(f"{name} from its {count}. on", step, later(mobility.QueryLocalPose, count, inner))
        for count, step in ((2, "66"), (3, "68"))
        for name, inner in (
            ("QueryLocalPose is not understood", deaf_to(mobility.QueryLocalPose)),
            ("ReportLocalPose is short", short(mobility.ReportLocalPose)),
            ("ReportLocalPose is late", slow(mobility.ReportLocalPose)),
        )
    ),
)
IGVC_2015: Final = (
    igvc("60 Hz instead of 1 Hz", "04 75 76 77 78 79", patched(Events, _set_rate=sixty_hertz)),
    igvc("a ReportStatus of three bytes", "33 37 39 45", short(core.ReportStatus)),
    igvc("a short ReportConfiguration", "17 18", short(core.ReportConfiguration)),
    igvc("component 255 ignored", "02 04 23", handles(not_for_255)),
    igvc("control not checked", "66", obeys_everybody()),
    igvc("the loser is not told", "29", says(not_told)),
    igvc("reports ignore the presence vector", "63 71", patched(host, mask=unmasked)),
    igvc("one component of the answer is missing", "02 12", instead(core.ReportServices, no_components)),
    igvc("no node is listed", "02 12", instead(core.ReportServices, no_nodes)),
    igvc("no service is listed", "02 12", instead(core.ReportServices, no_services)),
    igvc("no node in the configuration", "17 18", instead(core.ReportConfiguration, no_nodes)),
    igvc("no subsystem is listed", "19", field(core.ReportSubsystemList, subsystem_list=[])),
    igvc(
        "events of somebody else are listed",
        "03 10",
        field(core.ReportEvents, event_list=[core.ReportEventRec(0, 9, b"")]),
    ),
    igvc("an event is forgotten at once", "05 08 09", patched(Subscriptions, add=ignored)),
    igvc("a cancelled event is still listed", "10", patched(Subscriptions, remove=ignored)),
    igvc("cancelled events go on", "09", goes_on()),
    igvc("the sequence number stands still", "04 75", instead(core.Event, stuck)),
    igvc("events carry another report", "04 75", instead(core.Event, wrong_report)),
    igvc("new events are confirmed at 10 Hz", "04 75", confirmed(1, confirmed_periodic_rate=10.0)),
    igvc("changed events are confirmed at 10 Hz", "08", confirmed(4, confirmed_periodic_rate=10.0)),
    igvc("confirmations of new events have request id 99", "04 75", confirmed(1, request_id=99)),
    *(
        igvc(f"confirmations of streams have request id 99 instead of {n}", f"{n + 74}", confirmed(n, request_id=99))
        for n in (2, 3, 4, 5)
    ),
    *(
        igvc(f"streams are confirmed at 10 Hz, request {n}", f"{n + 74}", confirmed(n, confirmed_periodic_rate=10.0))
        for n in (2, 3, 5)
    ),
    igvc("confirmations of changes have request id 99", "08", confirmed(4, request_id=99)),
    igvc("confirmations of the end have request id 99", "09", confirmed(7, request_id=99)),
    igvc("events carry short reports", "04 76 77 78 79", instead(core.Event, short_inside)),
    igvc("changes are confirmed for event 99", "08", confirmed(4, event_id=99)),
    igvc("ends are confirmed for event 99", "09", confirmed(7, event_id=99)),
    igvc(
        "updates keep the old rate",
        "08",
        patched(Events, update_event=lambda self, msg, source: setattr(self, "_current", self._find(msg, source))),
    ),
    igvc("a report passes as a query", "07", reports_pass()),
    igvc("rejections have request id 99", "07", field(core.RejectEventRequest, request_id=99)),
    igvc("any event is refused as code 1", "07", field(core.RejectEventRequest, response_code=1)),
    igvc("identification is always of the subsystem", "13 15 16", field(core.ReportIdentification, query_type=2)),
    igvc("identification is always of type 9", "01 14 73 74", field(core.ReportIdentification, query_type=3)),
    igvc("it has no name", "13 14 15 16", field(core.ReportIdentification, identification="")),
    igvc(
        "ReportControl is always zero",
        "24 28 30",
        field(core.ReportControl, subsystem_id=0, node_id=0, component_id=0, authority_code=0),
    ),
    igvc(
        "ReportControl is never zero",
        "21",
        field(core.ReportControl, subsystem_id=9, node_id=9, component_id=9, authority_code=9),
    ),
    igvc("control is confirmed to everybody", "27 34", field(core.ConfirmControl, response_code=ACCEPTED)),
    igvc("control is never available", "22 23 29 36 50 55 67", field(core.ConfirmControl, response_code=UNAVAILABLE)),
    igvc("release is refused", "29 31 46 53 61 72", field(core.RejectControl, response_code=1)),
    igvc("SetAuthority is ignored", "26 28", patched(AccessControl, is_authority_valid=lambda self, msg: False)),
    igvc("any authority takes over", "27 28", patched(AccessControl, is_current_authority_less=anybody)),
    igvc("the status is always Ready", "33 37 41 48", field(core.ReportStatus, status=Status.READY)),
    igvc("the status is always Standby", "33 39 45", field(core.ReportStatus, status=Status.STANDBY)),
    igvc("the status is always Failure", "43", field(core.ReportStatus, status=Status.FAILURE)),
    igvc("emergency is ignored", "33 34 45", deaf_to(core.SetEmergency)),
    igvc("emergency is for ever", "36 37 48", deaf_to(core.ClearEmergency)),
    igvc("Resume is ignored", "39", deaf_to(core.Resume)),
    igvc("Standby is ignored", "41", deaf_to(core.Standby)),
    igvc(
        "commands are answered",
        "25 32 35 38 40 44 47 51 65 69",
        chatty(
            core.SetAuthority,
            core.SetEmergency,
            core.ClearEmergency,
            core.Resume,
            core.Standby,
            mobility.SetLocalWaypoint,
            mobility.SetLocalPose,
        ),
    ),
    igvc("Reset is answered", "42", chatty(core.Reset)),
    igvc("the waypoint is another one", "52", field(mobility.ReportLocalWaypoint, x=7.0, y=7.0)),
    igvc("waypoints come with a heading", "52 60", field(mobility.ReportLocalWaypoint, yaw=0.0)),
    igvc("element requests have id 99", "56", field(core.ConfirmElementRequest, request_id=99)),
    igvc("the list is always empty", "57", field(core.ReportElementCount, element_count=0)),
    igvc("no element is listed", "58", instead(core.ReportElementList, half_listed)),
    igvc("velocity has undefined fields", "62", instead(mobility.ReportVelocityState, undefined_fields)),
    igvc("velocity is empty", "62", instead(mobility.ReportVelocityState, nothing_in_it)),
    igvc("pose has undefined fields", "64", instead(mobility.ReportLocalPose, undefined_fields)),
    igvc("pose is empty", "64 70", instead(mobility.ReportLocalPose, nothing_in_it)),
    igvc("SetLocalPose is ignored", "70", deaf_to(mobility.SetLocalPose)),
    igvc(
        "half of SetLocalPose is ignored",
        "70",
        patched(LocalPoseSensor, _set=lambda self, x, y, z, yaw: _SET(self, x, None, z, yaw)),
    ),
    *DRIVES,
    *LATE,
    *(igvc(f"{kind.NAME} is not understood", "", deaf_to(kind)) for kind in IGVC_QUERIES),
    *(igvc(f"{kind.NAME} is spoilt", "", short(kind)) for kind in IGVC_REPORTS),
    igvc("every answer comes after two seconds", "02 06 24 49 62", slow()),
)
_SET: Final = LocalPoseSensor._set


# --- igvc-2011 ------------------------------------------------------------------------------------------------------


def rules(name: str, trips: str, inject: Injector, *, motion: bool = False, only: str = "") -> Fault:
    return Fault(name, "igvc-2011", tuple(trips.split()), inject, motion=motion, only=tuple(only.split()))


def waypoints(name: str, trips: str, inject: Injector) -> Fault:
    return rules(name, trips, inject, motion=True, only="1.4 3.2 6")


def announces_every(seconds: float) -> Injector:
    return patched(announcement, PERIOD=seconds)


def never_content() -> Injector:
    return patched(announcement.Announcement, intercept=lambda self, packet: False)


def strange_stamp(report: Any) -> None:
    if report.time_stamp is not None:
        report.time_stamp = core.ReportTime(time_stamp=report.time_stamp).time_stamp
        report.time_stamp.milliseconds = report.time_stamp.seconds = report.time_stamp.minutes = 0


def jumps() -> Injector:
    state = [0.0]

    def change(report: Any) -> None:
        if report.x is not None and report.time_stamp is not None:
            state[0] += 50.0
            report.x += state[0] - 50.0

    def inject() -> tuple[type[Part], type[Bench], list[Any]]:
        state[0] = 0.0
        return instead(mobility.ReportLocalPose, change)()

    return inject


def later_said(kind: type[Message], count: int, make: Callable[[type[Message]], Injector]) -> Injector:
    """A fault of what is said, from the so-manieth time on."""

    def inject() -> tuple[type[Part], type[Bench], list[Any]]:
        broken, bench, patches = make(kind)()

        class Later(broken):  # type: ignore[misc, valid-type]
            said = 0

            def say(self, outgoing: Any, now: float) -> None:
                self.said += outgoing.payload[:2] == code(kind)
                (super().say if self.said >= count else lambda *args: Part.say(self, *args))(outgoing, now)

        return Later, bench, patches

    return inject


TASKS: Final[tuple[type[Message], ...]] = (
    core.ReportIdentification,
    core.ReportServices,
    core.ReportControl,
    core.ConfirmControl,
    core.ReportStatus,
    mobility.ReportVelocityState,
    mobility.ReportLocalPose,
    core.ConfirmElementRequest,
    core.ReportElementCount,
    core.ReportElementList,
)
FOLLOWING: Final[tuple[type[Message], ...]] = (
    core.ConfirmControl,
    core.ReportStatus,
    mobility.ReportActiveElement,
    mobility.ReportTravelSpeed,
    mobility.ReportLocalWaypoint,
    mobility.ReportLocalPose,
)

IGVC_2011: Final = (
    rules("it never asks", "1.1 1.2", without(core.QueryIdentification)),
    rules("its question is short", "1.1 1.2", short(core.QueryIdentification)),
    rules("it asks late", "1.1", slow(core.QueryIdentification, seconds=8.0)),
    rules("it asks every second", "1.2", announces_every(1.0)),
    rules("it asks every seven seconds", "1.2", announces_every(7.0)),
    rules("it asks only once", "1.2", announces_every(1000.0)),
    rules("its second question is short", "1.2", later_said(core.QueryIdentification, 3, short)),
    rules(
        "its second question is late",
        "1.2",
        later_said(core.QueryIdentification, 3, lambda kind: slow(kind, seconds=3.0)),
    ),
    rules("it asks for ever", "1.3", never_content()),
    *(rules(f"{kind.NAME} is never sent", "", without(kind)) for kind in TASKS),
    *(rules(f"{kind.NAME} is short", "", short(kind)) for kind in TASKS),
    *(rules(f"{kind.NAME} is late", "", slow(kind)) for kind in TASKS),
    rules("identification of another level", "1.4", field(core.ReportIdentification, query_type=4)),
    rules("no service is listed", "2", instead(core.ReportServices, no_services)),
    rules("somebody else is in control", "3.1 3.5", field(core.ReportControl, subsystem_id=9)),
    rules("control is never available", "3.2", field(core.ConfirmControl, response_code=UNAVAILABLE)),
    rules("the status is always Ready", "3.3 3.6", field(core.ReportStatus, status=Status.READY)),
    rules("the status is always Standby", "3.4 3.6", field(core.ReportStatus, status=Status.STANDBY)),
    rules("Shutdown is ignored", "3.6", deaf_to(core.Shutdown)),
    rules(
        "commands are answered",
        "3.3 3.4 3.6 5.1",
        chatty(core.Standby, core.Resume, core.Shutdown, mobility.SetLocalPose),
    ),
    rules("reports ignore the presence vector", "4.1 4.2 5.2", patched(host, mask=unmasked)),
    rules("velocity is empty", "4.1 4.2", instead(mobility.ReportVelocityState, nothing_in_it)),
    rules("SetLocalPose is ignored", "5.2", deaf_to(mobility.SetLocalPose)),
    rules("poses have no time", "5.3", field(mobility.ReportLocalPose, time_stamp=None)),
    rules("the clock stands still", "5.3", instead(mobility.ReportLocalPose, strange_stamp)),
    rules("the pose jumps", "5.3", jumps()),
    rules("poses are empty", "5.2 5.3 6.1", instead(mobility.ReportLocalPose, nothing_in_it)),
    *(
        rules(f"the {count}. pose is {name}", step, later(mobility.QueryLocalPose, count, inner))
        for count, step in ((2, "5.3"), (3, "5.3"))
        for name, inner in (
            ("short", short(mobility.ReportLocalPose)),
            ("late", slow(mobility.ReportLocalPose)),
            ("missing", without(mobility.ReportLocalPose)),
            ("empty", instead(mobility.ReportLocalPose, nothing_in_it)),
        )
    ),
    rules("lists are confirmed as request 99", "6.1", field(core.ConfirmElementRequest, request_id=99)),
    rules("the list is empty", "6.2", field(core.ReportElementCount, element_count=0)),
    rules("no element is listed", "6.3", instead(core.ReportElementList, half_listed)),
    *(waypoints(f"driving: {kind.NAME} is never sent", "", later(core.Resume, 1, without(kind))) for kind in FOLLOWING),
    *(waypoints(f"driving: {kind.NAME} is short", "", later(core.Resume, 1, short(kind))) for kind in FOLLOWING),
    *(waypoints(f"driving: {kind.NAME} is late", "", later(core.Resume, 1, slow(kind))) for kind in FOLLOWING),
    waypoints("Resume is ignored", "6.4", deaf_to(core.Resume)),
    waypoints("ExecuteList is answered", "6.4", chatty(mobility.ExecuteList)),
    waypoints("the active element is always 3", "6.4", field(mobility.ReportActiveElement, element_uid=3)),
    waypoints("the speed is another one", "6.4", field(mobility.ReportTravelSpeed, speed=0.1)),
    waypoints("the waypoint is another one", "6.4", field(mobility.ReportLocalWaypoint, x=99.0, y=99.0)),
    waypoints(
        "control is not renewed",
        "6.5",
        later(mobility.ExecuteList, 1, field(core.ConfirmControl, response_code=UNAVAILABLE)),
    ),
    waypoints("the robot does not move", "6.5", lambda: (Part, Still, [])),
    waypoints("poses lose their x", "6.5", later(mobility.ExecuteList, 1, field(mobility.ReportLocalPose, x=None))),
    waypoints("poses lose their y", "6.5", later(mobility.ExecuteList, 1, field(mobility.ReportLocalPose, y=None))),
    *(waypoints(f"the robot stops at waypoint {number}", "6.5", freezes(number)) for number in (1, 2, 3)),
)


# --- transport ------------------------------------------------------------------------------------------------------


def wire(name: str, trips: str, inject: Injector) -> Fault:
    return Fault(name, "transport", tuple(trips.split()), inject)


def answers_first_port() -> Injector:
    """Whoever was heard from one port is answered there for ever."""

    class Stale(Bench):
        def way_back(self, port: Any) -> Any:
            return USUAL

    return lambda: (Part, Stale, [])


def answers_last_port() -> Injector:
    """All clients of a host are answered at the port that one of them used last."""

    class Mixed(Bench):
        last: Any = USUAL

        def send(self, datagram: bytes, source: JausID, *, strange_port: bool = False) -> None:
            if strange_port:
                self.last = STRANGE
            super().send(datagram, source, strange_port=strange_port)

        def way_back(self, port: Any) -> Any:
            return self.last

    return lambda: (Part, Mixed, [])


def drops(condition: Callable[[Packet], bool]) -> Injector:
    """The component never gets packets of a kind."""
    return handles(lambda _, datagram: [] if any(condition(each) for each in packets(datagram)) else [datagram])


def rewritten(change: Callable[[Part, Packet], Packet]) -> Injector:
    """The component gets packets with another header."""
    return handles(lambda part, datagram: [judp.pack(change(part, each)) for each in packets(datagram)])


def hangs_on(condition: Callable[[bytes], bool]) -> Injector:
    """Some datagram ends the node manager."""

    class Fragile(Bench):
        hung = False

        def inbound(self, datagram: bytes) -> Iterable[bytes]:
            self.hung = self.hung or condition(datagram)
            return () if self.hung else (datagram,)

    return lambda: (Part, Fragile, [])


def echoes_on(condition: Callable[[bytes], bool]) -> Injector:
    """The node manager answers some datagram with a NAK, to whoever seems to have sent it."""

    class Chatty(Bench):
        def inbound(self, datagram: bytes) -> Iterable[bytes]:
            if condition(datagram):
                me = next(iter(self.parts))
                nak = Packet(me, JausID(42, 1, 1), b"", 0, ack=Ack.NAK)
                self._arrived.append(Arrival(judp.pack(nak)))
            return (datagram,)

    return lambda: (Part, Chatty, [])


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
    class Eager(Part):
        def hear(self, payload: bytes, source: JausID, now: float) -> None:
            self.extra = judp.pack(Packet(self.host.id, source, b"", 1, ack=Ack.ACK))
            super().hear(payload, source, now)

        def work(self, now: float) -> list[bytes]:
            out = super().work(now)
            extra, self.extra = getattr(self, "extra", b""), b""
            return [*out, extra] if extra else out

    return lambda: (Eager, Bench, [])


def _only_acknowledge(part: Part, datagram: bytes) -> Iterable[bytes]:
    """What wants to be acknowledged is, and is then forgotten."""
    (packet,) = packets(datagram)
    return [judp.pack(replace(packet, payload=b""))] if packet.ack is Ack.REQUIRED else [datagram]


def _once(
    condition: Callable[[Packet], bool], *, by_payload: bool = False, by_source: bool = True, spoils: bool = False
) -> Callable[[Part, bytes], Iterable[bytes]]:
    """Packets with a key that was there before are lost; or everything of their source, when they spoil it."""
    seen: set[object] = set()

    def change(part: Part, datagram: bytes) -> Iterable[bytes]:
        (packet,) = packets(datagram)
        key = (packet.payload if by_payload else packet.sequence, packet.source if by_source else None, id(part))
        known = condition(packet) and key in seen
        seen.add(key)
        if known and spoils:
            seen.add((packet.sequence + 1, packet.source, id(part)))
        return [] if known else [datagram]

    return change


def in_order() -> Callable[[Part, bytes], Iterable[bytes]]:
    """A piece that does not continue the one before is lost."""
    last: dict[JausID, int] = {}

    def change(_: Part, datagram: bytes) -> Iterable[bytes]:
        (packet,) = packets(datagram)
        if packet.data_flag in (DataFlag.MIDDLE, DataFlag.LAST) and last.get(packet.source) != packet.sequence - 1:
            return []
        last[packet.source] = packet.sequence
        return [datagram]

    return change


def first_is_all() -> Injector:
    """The first piece counts as the whole query; the others are lost."""

    def change(part: Part, datagram: bytes) -> Iterable[bytes]:
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


def impatient() -> Callable[[Part, bytes], Iterable[bytes]]:
    """A middle piece that comes after the last one is lost."""
    ended: set[tuple[JausID, int]] = set()

    def change(_: Part, datagram: bytes) -> Iterable[bytes]:
        (packet,) = packets(datagram)
        if packet.data_flag is DataFlag.LAST:
            ended.add((packet.source, packet.sequence))
        late = packet.data_flag is DataFlag.MIDDLE and (packet.source, packet.sequence + 1) in ended
        return [] if late else [datagram]

    return change


class _Anybody:
    """Stands for the hand that makes garbage, to know it again."""

    ping = core.QueryEvents(core.AllEventsRec(0)).encode()

    def packet(self, payload: bytes | None = None) -> Packet:
        return Packet(JausID(42, 1, 1), JausID(105, 1, 1), self.ping if payload is None else payload, 0)


def _like(step: str) -> Callable[[bytes], bool]:
    """True for the garbage of this step, whatever its sequence number."""
    sample = dict(zip(GARBAGE, (make for _, make in transport.GARBAGE), strict=True))[step](_Anybody())  # type: ignore[arg-type]
    cut = -2 if len(sample) > 12 and step != "garbage-15" else len(sample)

    def same(datagram: bytes) -> bool:
        return len(datagram) == len(sample) and datagram[:cut] == sample[:cut]

    return same


GARBAGE: Final = {f"garbage-{number:02}": name for number, (name, _) in enumerate(transport.GARBAGE, 1)}

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
        "pieces-3 pieces-order pieces-missing",
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
    *(wire(f"{name} ends it", step, hangs_on(_like(step))) for step, name in GARBAGE.items()),
    *(wire(f"{name} is answered", step, echoes_on(_like(step))) for step, name in GARBAGE.items()),
    wire("bytes too many end it", "long", hangs_on(payload_is(transport.WHO + bytes(3)))),
    wire("bytes too few end it", "short alive", hangs_on(payload_is(transport.WHO[:-1]))),
    wire("everybody is answered at port 3794", "port-other port-back port-neighbour", answers_first_port()),
    wire("a host is answered at one port", "port-back", answers_last_port()),
)


# --- made from JSIDL ------------------------------------------------------------------------------------------------

READY, STANDBY = "Controlled.Available.Ready", "Controlled.Available.Standby"
EMERGENCY, FREE = "Controlled.NotAvailable.Emergency", "NotControlled.Available.Standby"


def core_fault(name: str, trips: str, inject: Injector, only: str = "", profile: str = "core-1.1") -> Fault:
    """`only`: beginnings of the steps that are run; by default those that are to be tripped."""
    steps = tuple(trips.split())
    return Fault(name, profile, steps, inject, timeout=5, only=tuple(only.split()) or steps)


GENERATED: Final = (
    core_fault(
        "control not checked",
        f"{READY}/Standby/rival {STANDBY}/Resume/rival {READY}/ReleaseControl/rival",
        patched(AccessControl, is_controlling_client=anybody),
    ),
    core_fault(
        "lists are taken from anybody",
        f"{STANDBY}/DeleteElement/rival/an-unknown-one",
        patched(AccessControl, is_controlling_client=anybody),
    ),
    core_fault("the loser is not told", f"{READY}/RequestControl/rival/more-authority", says(not_told)),
    core_fault(
        "any authority takes over",
        f"{READY}/RequestControl/rival/less-authority",
        patched(AccessControl, is_current_authority_less=anybody),
    ),
    core_fault(
        "the default authority does not count",
        f"{FREE}/RequestControl/rival/authority-below-the-default",
        patched(AccessControl, is_default_authority_greater=lambda self, msg: False),
    ),
    core_fault(
        "control never ends by itself",
        f"{READY}/Timedout/pilot/the-client-is-silent",
        patched(AccessControl, reset_timer=idle),
    ),
    core_fault(
        "authority may be raised",
        f"{READY}/SetAuthority/pilot/more-authority",
        patched(AccessControl, is_authority_valid=anybody),
    ),
    core_fault("authority cannot be lowered", f"{READY}/SetAuthority/pilot/less-authority", deaf_to(core.SetAuthority)),
    core_fault(
        "control is given during an emergency",
        f"{EMERGENCY}/RequestControl/rival/more-authority",
        field(core.ConfirmControl, response_code=ACCEPTED),
    ),
    core_fault(
        "anybody clears an emergency",
        f"{EMERGENCY}/ClearEmergency/pilot",
        patched(Management, is_id_stored=anybody, delete_id=clears_all),
    ),
    core_fault("emergency is ignored", f"{READY}/SetEmergency/rival", deaf_to(core.SetEmergency)),
    core_fault("Reset is ignored", f"{READY}/Reset/pilot", deaf_to(core.Reset)),
    core_fault("Standby is ignored", f"{READY}/Standby/pilot", deaf_to(core.Standby)),
    core_fault("Shutdown is ignored", f"{READY}/Shutdown/pilot", deaf_to(core.Shutdown)),
    core_fault("unknown events are cancelled", f"{FREE}/CancelEvent/rival/an-unknown-one", reports_pass()),
    core_fault("a report passes as a query", f"{FREE}/CreateEvent/rival/a-report-instead-of-a-query", reports_pass()),
    core_fault("events are not updated", f"{FREE}/UpdateEvent/rival/one-that-is-there", deaf_to(core.UpdateEvent)),
    core_fault(
        "events never end", f"{FREE}/Timeout/rival/an-event-is-not-renewed", patched(Events, reset_event_timer=idle)
    ),
    core_fault("events never come", f"{FREE}/EventOccurred/rival/an-event-is-due", without(core.Event)),
    core_fault(
        "identification is always of the system",
        f"{FREE}/QueryIdentification/rival/level-2",
        field(core.ReportIdentification, query_type=1),
    ),
    core_fault("ReportTime is short", f"{FREE}/QueryTime/rival/all-fields", short(core.ReportTime)),
    core_fault("ReportControl is short", f"{FREE}/QueryControl/rival", short(core.ReportControl)),
    core_fault("commands are answered", f"{READY}/Standby/pilot {READY}/Standby/rival", chatty(core.Standby)),
    core_fault(
        "wrong elements are confirmed",
        f"{STANDBY}/SetElement/pilot/after-an-unknown-one",
        instead(core.RejectElementRequest, lambda message: core.ConfirmElementRequest(message.request_id)),
    ),
    core_fault("time ignores the presence vector", f"{FREE}/QueryTime/rival/no-fields", patched(host, mask=unmasked)),
    core_fault(
        "poses ignore the presence vector",
        f"{FREE}/QueryLocalPose/rival/no-fields",
        patched(host, mask=unmasked),
        profile="mobility-1.1",
    ),
    core_fault(
        "poses are short",
        f"{FREE}/QueryLocalPose/rival/all-fields",
        short(mobility.ReportLocalPose),
        profile="mobility-1.1",
    ),
    core_fault(
        "speed is not reported",
        f"{FREE}/QueryTravelSpeed/rival",
        deaf_to(mobility.QueryTravelSpeed),
        profile="mobility-1.1",
    ),
    core_fault(
        "waypoints are answered",
        f"{STANDBY}/SetLocalWaypoint/pilot",
        chatty(mobility.SetLocalWaypoint),
        profile="mobility-1.1",
    ),
)

ALL: Final = (*IGVC_2015, *IGVC_2011, *TRANSPORT, *GENERATED)
