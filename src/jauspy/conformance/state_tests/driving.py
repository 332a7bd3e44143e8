"""Drivers of mobility: waypoints, lists, loiters and velocities, whose guards depend on earlier commands."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from types import MappingProxyType
from typing import Any, Final

from jauspy.codec.message import Message
from jauspy.conformance.checks import Check, has, near
from jauspy.conformance.state_tests import lists, sample_messages
from jauspy.conformance.state_tests.effects import SLOW, effect, over_ground
from jauspy.conformance.state_tests.events import UNKNOWN_ID
from jauspy.conformance.state_tests.explorer import Explorer, Prepare, Stimulus, StimulusResult
from jauspy.conformance.tester import CONTROLLER, OBSERVER
from jauspy.messages.core import Standby
from jauspy.messages.mobility import (
    ExecuteList,
    ExecuteListExt,
    QueryActiveElement,
    QueryGlobalLoiter,
    QueryGlobalWaypoint,
    QueryGlobalWaypointExt,
    QueryLocalLoiter,
    QueryLocalWaypoint,
    QueryLocalWaypointExt,
    QueryTravelSpeed,
    QueryTravelSpeedExt,
    QueryVelocityCommand,
    QueryVelocityCommandExt,
    ReportActiveElement,
    ReportGlobalLoiter,
    ReportGlobalWaypoint,
    ReportGlobalWaypointExt,
    ReportLocalLoiter,
    ReportLocalWaypoint,
    ReportLocalWaypointExt,
    ReportTravelSpeed,
    ReportTravelSpeedExt,
    ReportVelocityCommand,
    ReportVelocityCommandExt,
    SetGlobalLoiter,
    SetGlobalPathSegment,
    SetGlobalWaypoint,
    SetGlobalWaypointExt,
    SetLocalLoiter,
    SetLocalPathSegment,
    SetLocalWaypoint,
    SetLocalWaypointExt,
    SetTravelSpeed,
    SetTravelSpeedExt,
    SetVelocityCommand,
    SetVelocityCommandExt,
)

MOBILITY: Final = "urn:jaus:jss:mobility:"
FAR: Final = 1000.0
"""m; too far to be reached during a step."""
LATITUDE, LONGITUDE = 1.0, 2.0
"""Degrees."""


def local_loiter(x: float) -> SetLocalLoiter:
    """A loiter command at a point."""
    return SetLocalLoiter(SetLocalLoiter.LocalLoiterRec(x, FAR), SetLocalLoiter.HoverRec(0, 0.0, 0.0))


def global_loiter(latitude: float) -> SetGlobalLoiter:
    """A loiter command at a point."""
    return SetGlobalLoiter(SetGlobalLoiter.GlobalLoiterRec(latitude, LONGITUDE), SetGlobalLoiter.HoverRec(0, 0.0, 0.0))


_WAYPOINTS: Final[Mapping[str, Message]] = MappingProxyType(
    {
        "LocalWaypoint": SetLocalWaypoint(x=FAR, y=FAR),
        "GlobalWaypoint": SetGlobalWaypoint(latitude=LATITUDE, longitude=LONGITUDE),
    }
)
_SEGMENTS: Final[Mapping[str, Message]] = MappingProxyType(
    {
        "LocalPathSegment": SetLocalPathSegment(p1_x=FAR, p1_y=FAR, p2_x=2 * FAR, p2_y=FAR, weighting_factor=0.0),
        "GlobalPathSegment": SetGlobalPathSegment(
            p1_latitude=LATITUDE,
            p1_longitude=LONGITUDE,
            p2_latitude=LATITUDE,
            p2_longitude=LONGITUDE + 1.0,
            weighting_factor=0.0,
        ),
    }
)
_LOITERS: Final[Mapping[str, Message]] = MappingProxyType(
    {"LocalLoiter": local_loiter(FAR), "GlobalLoiter": global_loiter(LATITUDE)}
)
"""Commands by the beginning of the names of the services that accept them."""


def element(explorer: Explorer) -> Message:
    """An element that the list drivers of the component accept."""
    return next(_taken(explorer, {**_WAYPOINTS, **_SEGMENTS}), _WAYPOINTS["LocalWaypoint"])


def _taken(explorer: Explorer, kinds: Mapping[str, Message]) -> Iterator[Message]:
    for name, made in kinds.items():
        if any(service.startswith(f"{MOBILITY}{name}") for service in explorer.services):
            yield made


def set_goal(explorer: Explorer, waypoint: Message) -> None:
    """Set a waypoint as the controller."""
    explorer.client(CONTROLLER).send(waypoint, to=explorer.component)


def set_all_goals(explorer: Explorer) -> None:
    """Set one waypoint and loiter of each kind that the component accepts without a list."""
    for kind in _taken(explorer, {**_WAYPOINTS, **_LOITERS}):
        set_goal(explorer, kind)


def stop(explorer: Explorer, role: str) -> None:  # noqa: ARG001 - a Prepare
    """End all driving: Standby, and an empty list."""
    explorer.client(CONTROLLER).send(Standby(), to=explorer.component)
    lists.clear(explorer, CONTROLLER)
    explorer.where = None


# --- waypoints ------------------------------------------------------------------------------------------------------


def _set_before_release(waypoint: Message) -> Prepare:
    """Prepare a waypoint of a client that has released control since."""

    def before(explorer: Explorer, role: str) -> None:  # noqa: ARG001 - a Prepare
        explorer.steer("RequestControl", CONTROLLER)
        set_goal(explorer, waypoint)
        explorer.steer("ReleaseControl", CONTROLLER)
        explorer.observe()

    return before


def _waypoint(waypoint: Message, kind: type[Message], report: type[Message], *right: Check) -> tuple[Stimulus, ...]:
    def with_waypoint(stimulus: Stimulus) -> Stimulus:
        return replace(
            stimulus,
            variant=f"{stimulus.variant} of one that was set",
            truths={"waypointExists": True},
            before=lambda explorer, _: set_goal(explorer, waypoint),
            after=stop,
            by_controller=True,
            only_in="Available",
            moves=True,
            once=False,
        )

    everything, nothing, some = sample_messages.variants(kind, report)
    return (
        everything,
        with_waypoint(replace(everything, checks={report.NAME: right})),
        with_waypoint(nothing),
        with_waypoint(some),
        replace(everything, variant="of one that was left", before=_set_before_release(waypoint), once=True),
    )


_LOCAL_GOAL: Final = near(0.01, x=FAR, y=FAR)
_GLOBAL_GOAL: Final = near(1e-6, latitude=LATITUDE, longitude=LONGITUDE)
WAYPOINTS: Final = (
    *_waypoint(SetLocalWaypoint(x=FAR, y=FAR), QueryLocalWaypoint, ReportLocalWaypoint, *_LOCAL_GOAL),
    *_waypoint(SetLocalWaypointExt(x=FAR, y=FAR), QueryLocalWaypointExt, ReportLocalWaypointExt, *_LOCAL_GOAL),
    *_waypoint(
        SetGlobalWaypoint(latitude=LATITUDE, longitude=LONGITUDE),
        QueryGlobalWaypoint,
        ReportGlobalWaypoint,
        *_GLOBAL_GOAL,
    ),
    *_waypoint(
        SetGlobalWaypointExt(latitude=LATITUDE, longitude=LONGITUDE),
        QueryGlobalWaypointExt,
        ReportGlobalWaypointExt,
        *_GLOBAL_GOAL,
    ),
)


# --- travel --------------------------------------------------------------------------------------------------


def _travel(command: Callable[[float], Message], query: Message, report: type[Message], field: str) -> Stimulus:
    return effect(
        command,
        query,
        report,
        field,
        SLOW,
        truths={"waypointExists": True, "loiterExists": True},
        prepare=lambda explorer, _: set_all_goals(explorer),
        cleanup=stop,
    )


def _hold(explorer: Explorer, role: str) -> None:  # noqa: ARG001 - a Prepare
    """Set a list of one waypoint, if a client is in control."""
    explorer.client(CONTROLLER).send(lists.upload(element(explorer)), to=explorer.component)
    explorer.observe()


def _is_active(then: StimulusResult) -> None:
    uid = lists.UID if then.outcome.acts else 0
    observer = then.explorer.client(OBSERVER)
    observer.ask(QueryActiveElement(), ReportActiveElement, has(element_uid=uid), to=then.explorer.component)


def _execution(make: Callable[..., Message], speed: Callable[[float], Any]) -> tuple[Stimulus, ...]:
    def under_way(explorer: Explorer, role: str) -> None:
        _hold(explorer, role)
        explorer.client(CONTROLLER).send(make(speed=speed(0.0), element_uid=lists.UID), to=explorer.component)

    def start(variant: str, uid: int, *, exists: bool) -> Stimulus:
        return Stimulus(
            make(speed=speed(SLOW)).NAME,
            lambda _: make(speed=speed(SLOW), element_uid=uid),
            variant,
            {"elementExists": exists, "elementSpecified": True},
            before=_hold,
            after=stop,
            verify=_is_active,
            of=MOBILITY,
        )

    return (
        start("from an existing one", lists.UID, exists=True),
        start("from an unknown one", UNKNOWN_ID, exists=False),
        effect(
            lambda value: make(speed=speed(value)),
            QueryTravelSpeed(),
            ReportTravelSpeed,
            "speed",
            SLOW,
            truths={"elementExists": False, "elementSpecified": False},
            variant="another speed",
            prepare=under_way,
            cleanup=stop,
            of=MOBILITY,
        ),
    )


LOITERING: Final = (
    effect(local_loiter, QueryLocalLoiter(0), ReportLocalLoiter, "local_loiter_rec__x", FAR, cleanup=stop),
    effect(
        global_loiter,
        QueryGlobalLoiter(0),
        ReportGlobalLoiter,
        "global_loiter_rec__latitude",
        LATITUDE,
        cleanup=stop,
    ),
)

# --- velocities -----------------------------------------------------------------------------------------------------

CURRENT, MAXIMUM = 0, 1
"""Kinds of velocity commands."""


def _velocity(make: Callable[..., Message], query: Callable[..., Message], report: type[Any]) -> tuple[Stimulus, ...]:
    def limit(explorer: Explorer) -> Message:
        asked = explorer.client(OBSERVER).ask(query(1, MAXIMUM), report, to=explorer.component)
        return make(command_type=MAXIMUM, velocity_x=asked.velocity_x)

    return (
        effect(
            lambda value: make(command_type=CURRENT, velocity_x=value),
            query(1, CURRENT),
            report,
            "velocity_x",
            SLOW,
            truths={"isCurrentVelocityCmd": True, "isCommandValueValid": True},
            variant="for now",
        ),
        Stimulus(make(command_type=MAXIMUM).NAME, limit, "the limit that it has", {"isCurrentVelocityCmd": False}),
    )


DRIVING: Final = (
    *WAYPOINTS,
    _travel(SetTravelSpeed, QueryTravelSpeed(), ReportTravelSpeed, "speed"),
    _travel(
        lambda speed: SetTravelSpeedExt(over_ground(speed)), QueryTravelSpeedExt(), ReportTravelSpeedExt, "speed__value"
    ),
    *LOITERING,
    *_execution(ExecuteList, float),
    *_execution(ExecuteListExt, over_ground),
    *_velocity(SetVelocityCommand, QueryVelocityCommand, ReportVelocityCommand),
    *_velocity(SetVelocityCommandExt, QueryVelocityCommandExt, ReportVelocityCommandExt),
)
