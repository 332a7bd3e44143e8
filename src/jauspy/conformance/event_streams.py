"""Steps with events: create one, and check the rate, sequence numbers and reports of its stream."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Final

from jauspy.codec.message import Message
from jauspy.conformance.checks import has, near
from jauspy.conformance.results import Silent
from jauspy.conformance.tester import Client, Tester
from jauspy.conformance.trace import message_name
from jauspy.errors import DecodeError
from jauspy.ids import JausID
from jauspy.messages.core import CancelEvent, ConfirmEventRequest, CreateEvent, Event

RATE_STEP: Final = 1092 / 65535
"""Resolution of a rate on the wire, in hertz (AS5710)."""
ONE_HERTZ: Final = 60 * RATE_STEP
HALF_HERTZ: Final = 30 * RATE_STEP
"""The rates that the IGVC judge requests: raw 003C and 001E."""
TOLERANCE: Final = 0.25
"""Allowed deviation of an interval, relative to the period."""
PERIODS: Final = 4
"""Number of periods of a stream that are checked."""
MAX_COUNTED: Final = 12
"""Events of a fast stream that are counted; its single intervals depend more on the network than on the robot."""
COUNT_TOLERANCE: Final = 0.4
"""Allowed deviation of the number of events, relative to it."""
MAX_WATCH_TIME: Final = 20.0
"""s; longest time for which a stream is watched."""

Arrivals = Sequence[tuple[float, Event]]


def subscribe(
    client: Client, request: int, query: Message | bytes, rate: float = ONE_HERTZ, to: JausID | None = None
) -> ConfirmEventRequest:
    """Create a periodic event; it must be confirmed with the requested rate."""
    wanted = CreateEvent(
        request_id=request,
        event_type=CreateEvent.EventType.PERIODIC,
        requested_periodic_rate=rate,
        query_message=query,
    )
    return client.ask(
        wanted, ConfirmEventRequest, has(request_id=request), near(0.02 * rate, confirmed_periodic_rate=rate), to=to
    )


def cancel(client: Client, request: int, event: int, to: JausID | None = None) -> None:
    """Cancel an event; it must be confirmed."""
    client.ask(CancelEvent(request, event), ConfirmEventRequest, has(request_id=request, event_id=event), to=to)


def watch(client: Client, event: int, rate: float, report: type[Message]) -> None:
    """Check the rate, sequence numbers and reports of an event's stream."""
    arrivals = client.collect(Event, PERIODS / rate, lambda message: message.event_id == event)
    judge(client.tester, arrivals, rate, report)


def judge(tester: Tester, arrivals: Arrivals, rate: float, report: type[Message]) -> None:
    """Check the received messages of one event."""
    name = f"{report.NAME} at {rate:.2g} Hz"
    tester.expected.append(f"Event 41F1h with {name}")
    _there_are_some(tester, arrivals)
    tester.check(f"the stream of {name} keeps its rate", pace(arrivals, rate))
    _events_are_right(tester, arrivals, name, report)


def check_stream(client: Client, event: int, rate: float, report: type[Message]) -> None:
    """Check that the mean rate is the confirmed one, and that all events of this client belong to the stream."""
    tester = client.tester
    tester.expected.append(f"Event 41F1h with {report.NAME} at {rate:.3g} Hz")
    tester.check("a rate is confirmed", "" if rate > 0 else f"it is {rate:g} Hz")
    seconds = min(MAX_COUNTED / rate, MAX_WATCH_TIME)
    tester.wait(0.0)
    client.forget(Event)  # of before: the tester may have been held up
    arrivals = client.collect(Event, seconds)
    _there_are_some(tester, arrivals)
    unexpected = {arrival.event_id for _, arrival in arrivals} - {event}
    tester.check(
        "the events have the id that was confirmed",
        f"they have {sorted(unexpected)}, not {event}" if unexpected else "",
    )
    wrong = abs(len(arrivals) - seconds * rate) > seconds * rate * COUNT_TOLERANCE
    tester.check("they come at the confirmed rate", f"{len(arrivals)} came in {seconds:.3g} s" if wrong else "")
    _events_are_right(tester, arrivals, report.NAME, report)


def _there_are_some(tester: Tester, arrivals: Arrivals) -> None:
    tester.record_check(f"{message_name(Event)} comes", "" if arrivals else "none came")
    if not arrivals:
        raise Silent(f"no {message_name(Event)} came")


def _events_are_right(tester: Tester, arrivals: Arrivals, name: str, report: type[Message]) -> None:
    """Check sequence numbers and reports."""
    numbers = [event.sequence_number for _, event in arrivals]
    steps = {after - before & 0xFF for before, after in pairwise(numbers)}
    tester.check(
        f"the sequence number of {name} grows by one", "" if steps == {1} else f"the sequence numbers are {numbers}"
    )
    wrong = next((problem for _, event in arrivals if (problem := _content(event, report))), "")
    tester.check(f"the events carry {report.NAME}, as its definition says", wrong)


def _content(event: Event, report: type[Message]) -> str:
    """Return what is wrong with the message in an event, or an empty string."""
    inside = event.report_message
    payload = inside.encode(strict=False) if isinstance(inside, Message) else inside
    try:
        report.decode(payload)
    except DecodeError as error:
        return f"an event carries {payload.hex()}: {error}"
    return ""


def pace(arrivals: Arrivals, rate: float) -> str:
    """Return what is wrong with the intervals, or an empty string; the first report may arrive at any time."""
    times = [time for time, _ in arrivals]
    if len(times) < PERIODS - 1:
        return f"{len(times)} events came in {PERIODS / rate:.3g} s, which is not {rate:.2g} Hz"
    intervals = [after - before for before, after in pairwise(times)]
    wrong = [interval for interval in intervals if abs(interval * rate - 1.0) > TOLERANCE]
    return f"{len(times)} events, {wrong[0]:.3f} s apart, which is not {rate:.2g} Hz" if wrong else ""


def check_stopped(client: Client, event: int, seconds: float) -> None:
    """Check that a cancelled event sends no more reports, apart from those already in flight."""
    client.tester.wait(0.05 * client.tester.timeout)
    client.forget(Event)
    arrivals = client.collect(Event, seconds, lambda message: message.event_id == event)
    client.tester.check("the events stop", f"{len(arrivals)} came after the end" if arrivals else "")
