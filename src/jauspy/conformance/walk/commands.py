"""Command events: whether it is told how a command has ended, and one that does not end in time."""

from __future__ import annotations

from typing import Final

from jauspy.conformance.checks import has
from jauspy.conformance.results import Outcome, Skipped
from jauspy.conformance.walk.events import CREATE, HELD, QUERY, confirmed, drop_events, held
from jauspy.conformance.walk.explorer import Aftermath, Stimulus, Walker
from jauspy.messages.core import (
    CommandEvent,
    ConfirmEventRequest,
    CreateCommandEvent,
    SetAuthority,
    Standby,
)
from jauspy.messages.mobility import SetLocalWaypoint, SetTravelSpeed

DURATION: Final = 1
"""Seconds that a command may take."""
WAYPOINTS: Final = "urn:jaus:jss:mobility:LocalWaypointDriver"
FAR: Final = 1000.0
"""m; of a waypoint that nobody drives to: the speed is zero."""
LASTING: Final = SetTravelSpeed(0.0)
"""The way to a waypoint, at no speed: carried out when the waypoint is reached."""
AT_ONCE: Final = 0.1
"""Timeouts in which a command ends that takes no time."""
Result = CommandEvent.CommandResult


def start_lasting(walker: Walker, role: str) -> None:
    """A command with an event is under way, and will not end by itself."""
    if WAYPOINTS not in walker.services:
        raise Skipped("no command is known that takes its time on a component without LocalWaypointDriver")
    client = walker.client(role)
    client.send(SetLocalWaypoint(x=FAR, y=FAR), to=walker.component)
    try:
        event = client.ask(CreateCommandEvent(HELD, DURATION, LASTING), ConfirmEventRequest, to=walker.component)
    except Outcome as outcome:
        raise Skipped(f"the way to a waypoint has no command event: {outcome}") from outcome
    walker.tester.memory["held"] = event.event_id
    walker.tester.wait(AT_ONCE * walker.tester.timeout)
    if any(each.code == CommandEvent.CODE for each in client.pending):
        raise Skipped("the component says at once that it has carried out the way to a waypoint: no command lasts")


def end_lasting(walker: Walker, role: str) -> None:
    """Nobody drives to the waypoint any more."""
    drop_events(walker, role)
    walker.client(role).send(Standby(), to=walker.component)
    walker.where = None


def _end_is_told(then: Aftermath) -> None:
    """A command event that was confirmed ends in time, one way or the other, and its client is told."""
    if any(output.message == "ConfirmEventRequest" for output in then.outcome.outputs):
        events = confirmed(then.walker, then.role)
        within = 1.0 + DURATION / then.walker.tester.timeout
        taken = then.before.controller == then.role and "Available" in then.before.state
        right = has(command_result=Result.SUCCESSFUL if taken else Result.UNSUCCESSFUL)
        client = then.walker.client(then.role)
        client.expect(CommandEvent, right, where=lambda end: end.event_id in events, within=within)
        then.took("CommandCompleted")


def _is_the_same(then: Aftermath) -> None:
    walker = then.walker
    before, after = held(walker), confirmed(walker, then.role)[-1]
    walker.tester.check("the event keeps its id", "" if before == after else f"{before} has become {after}")


COMMANDS: Final = (
    Stimulus(
        "CreateCommandEvent",
        lambda _: CreateCommandEvent(CREATE, DURATION, Standby()),
        "a new one",
        {"eventExists": False},
        after=drop_events,
        verify=_end_is_told,
        also=("CommandCompleted",),
    ),
    Stimulus(
        "CreateCommandEvent",
        lambda walker: CreateCommandEvent(CREATE, DURATION, SetAuthority(walker.authority)),
        "of a command that ends at once",
        {"eventExists": False},
        after=drop_events,
        verify=_end_is_told,
        by_controller=True,
        also=("CommandCompleted",),
    ),
    Stimulus(
        "CreateCommandEvent",
        lambda _: CreateCommandEvent(CREATE, DURATION, QUERY),
        "of a query",
        {"isCommandSupported": False},
        checks={"RejectEventRequest": has(request_id=CREATE)},
    ),
    Stimulus(
        "CreateCommandEvent",
        lambda _: CreateCommandEvent(CREATE, DURATION, LASTING),
        "one that is there",
        {"isCommandSupported": True, "eventExists": True},
        before=start_lasting,
        after=end_lasting,
        checks={"ConfirmEventRequest": has(request_id=CREATE)},
        verify=_is_the_same,
        by_controller=True,
        only_in="Ready",
        moves=True,
    ),
)
EXPIRED: Final = Stimulus(
    "CommandExpired",
    None,
    "a command does not end",
    before=start_lasting,
    after=end_lasting,
    checks={"CommandEvent": has(command_result=Result.UNSUCCESSFUL)},
    by_controller=True,
    only_in="Ready",
    moves=True,
    seconds=lambda _: DURATION,
    earliest=0.5,
)
