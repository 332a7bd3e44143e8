"""Robots that igvc-2011 must catch."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Final

from tests.conformance.injectors import (
    Fault,
    Injector,
    code,
    deaf_to,
    field,
    instead,
    later,
    patched,
    short,
    slow,
    without,
)
from tests.conformance.mistakes import (
    UNAVAILABLE,
    Status,
    Still,
    chatty,
    freezes,
    half_listed,
    no_services,
    nothing_in_it,
    unmasked,
)

from jauspy.codec.message import Message
from jauspy.conformance import TargetComponent, VirtualTarget
from jauspy.messages import core, mobility
from jauspy.robot import hosts
from jauspy.services import presence_vectors


def rules(name: str, trips: str, inject: Injector, *, motion: bool = False, only: str = "") -> Fault:
    return Fault(name, "igvc-2011", tuple(trips.split()), inject, motion=motion, only=tuple(only.split()))


def waypoints(name: str, trips: str, inject: Injector) -> Fault:
    """Nobody needs to drive when that does not even begin."""
    return rules(name, trips, inject, motion=True, only="1.4 3.2 6.1 6.4" if trips == "6.4" else "1.4 3.2 6")


def announces_every(seconds: float) -> Injector:
    return patched(hosts, ANNOUNCEMENT_PERIOD=seconds)


def never_content() -> Injector:
    return patched(hosts.Announcement, intercept=lambda self, packet: False)


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

    def inject() -> tuple[type[TargetComponent], type[VirtualTarget], list[Any]]:
        state[0] = 0.0
        return instead(mobility.ReportLocalPose, change)()

    return inject


def later_said(kind: type[Message], count: int, make: Callable[[type[Message]], Injector]) -> Injector:
    """A fault of what is said, from the so-manieth time on."""

    def inject() -> tuple[type[TargetComponent], type[VirtualTarget], list[Any]]:
        broken, virtual_target, patches = make(kind)()

        class Later(broken):  # type: ignore[misc, valid-type]
            said = 0

            def send(self, outgoing: Any, now: float) -> None:
                self.said += outgoing.payload[:2] == code(kind)
                (super().send if self.said >= count else lambda *args: TargetComponent.send(self, *args))(outgoing, now)

        return Later, virtual_target, patches

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
FOLLOWING: Final[tuple[tuple[str, type[Message]], ...]] = (
    ("6.5", core.ConfirmControl),
    ("6.4", core.ReportStatus),
    ("6.4", mobility.ReportActiveElement),
    ("6.4", mobility.ReportTravelSpeed),
    ("6.4", mobility.ReportLocalWaypoint),
    ("6.5", mobility.ReportLocalPose),
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
    rules("another node is in control", "3.5", field(core.ReportControl, node_id=2)),
    rules("another component is in control", "3.5", field(core.ReportControl, component_id=2)),
    rules("ReportControl tells no authority", "3.5", field(core.ReportControl, authority_code=0)),
    rules("control is never available", "3.2", field(core.ConfirmControl, response_code=UNAVAILABLE)),
    rules("the status is always Ready", "3.3 3.6", field(core.ReportStatus, status=Status.READY)),
    rules("the status is always Standby", "3.4 3.6", field(core.ReportStatus, status=Status.STANDBY)),
    rules("Shutdown is ignored", "3.6", deaf_to(core.Shutdown)),
    rules(
        "commands are answered",
        "3.3 3.4 3.6 5.1",
        chatty(core.Standby, core.Resume, core.Shutdown, mobility.SetLocalPose),
    ),
    rules(
        "reports ignore the presence vector", "4.1 4.2 5.2", patched(presence_vectors, apply_presence_vectors=unmasked)
    ),
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
    *(
        waypoints(f"driving: {kind.NAME} {name}", step, later(core.Resume, 1, make(kind)))
        for name, make in (("is never sent", without), ("is short", short), ("is late", slow))
        for step, kind in FOLLOWING
    ),
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
    waypoints("the robot does not move", "6.5", lambda: (TargetComponent, Still, [])),
    waypoints("poses lose their x", "6.5", later(mobility.ExecuteList, 1, field(mobility.ReportLocalPose, x=None))),
    waypoints("poses lose their y", "6.5", later(mobility.ExecuteList, 1, field(mobility.ReportLocalPose, y=None))),
    *(waypoints(f"the robot stops at waypoint {number}", "6.5", freezes(number)) for number in (1, 2, 3)),
)
