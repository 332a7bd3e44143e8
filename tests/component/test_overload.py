"""Floods of requests for events, and more events than can be sent: commands are handled at once all the same."""

from __future__ import annotations

import asyncio
from collections import Counter
from datetime import UTC, datetime

import pytest

from jauspy.component.component import MAX_WAITING_PER_TURN, Component, loop_time
from jauspy.component.inbox import MAX_WAITING, ClientInbox, may_wait
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.core import (
    ConfirmEventRequest,
    CreateEvent,
    QueryStatus,
    QueryTime,
    ReportStatus,
    RequestControl,
    Resume,
    Standby,
)
from jauspy.protocol.counters import Counters
from jauspy.protocol.header import Packet
from jauspy.protocol.judp import pack, unpack
from jauspy.services.core import AccessControl, Events, Management, Time
from jauspy.services.host import BACKGROUND_BURST, BACKGROUND_RATE, MAX_BACKGROUND_TIMERS, Host
from jauspy.testing import VirtualNetwork, until

ME, OPERATOR = JausID(101, 1, 1), JausID(42, 1, 1)
STRANGERS = [JausID(66, 1, each) for each in range(1, 5)]
FLOOD = 10_000
TURNS = 6
"""Of the event loop, until a query is answered; one answers as many queries as `MAX_WAITING_PER_TURN`."""


def create(request: int, rate: float) -> CreateEvent:
    return CreateEvent(request & 0xFF, CreateEvent.EventType.PERIODIC, rate, QueryTime(request & 0xFF).encode())


def host(now: float = 0.0) -> Host:
    services = [AccessControl(timeout=0), Management(), Events(timeout=0), Time()]
    return Host(ME, services, utc_now=lambda: datetime(2026, 1, 1, tzinfo=UTC), now=now)


class Client:
    """Sends as whoever it likes, and counts what it is answered."""

    def __init__(self, network: VirtualNetwork, id: JausID) -> None:
        self.id, self.transport = id, network.transport(id)
        self.transport.received = self._take
        self.answers: list[object] = []
        self.sent = 0

    def _take(self, datagram: bytes) -> None:
        self.answers += (registry.decode(packet.payload) for packet in unpack(datagram))

    def datagram(self, message: object) -> bytes:
        self.sent += 1
        return pack(Packet(self.id, ME, message.encode(), self.sent & 0xFFFF))


@pytest.mark.slow
@pytest.mark.parametrize("flooders", [STRANGERS, [OPERATOR]], ids=["strangers", "the operator itself"])
async def test_a_command_does_not_wait_for_a_flood(virtual_network: VirtualNetwork, flooders: list[JausID]) -> None:
    me = Component.of_host(host(loop_time()), virtual_network.transport(ME))
    clients = {id: Client(virtual_network, id) for id in [OPERATOR, *STRANGERS]}
    operator = clients[OPERATOR]
    async with me:
        for each in clients.values():
            await each.transport.open()
        receive = me._transport.received
        for message in (RequestControl(200), Resume()):
            receive(operator.datagram(message))
        assert me.state.endswith("Ready")
        for number in range(FLOOD):  # all in one turn of the event loop
            flooder = clients[flooders[number % len(flooders)]]
            receive(flooder.datagram(create(number, 1.0)))
        receive(operator.datagram(QueryStatus()))
        receive(operator.datagram(Standby()))
        assert me.state.endswith("Standby")
        assert me.counters["host.received"] <= 3 + MAX_WAITING_PER_TURN
        for _ in range(TURNS):
            if any(isinstance(each, ReportStatus) for each in operator.answers):
                break
            await asyncio.sleep(0)
        else:
            pytest.fail(f"the status was not reported within {TURNS} turns of the event loop")
        assert me.counters["host.received"] <= 3 + TURNS * MAX_WAITING_PER_TURN
        assert me.counters["endpoint.dropped.inbox_full"] >= FLOOD - MAX_WAITING - MAX_WAITING_PER_TURN
        await until(lambda: me.counters["host.received"] >= 3 + MAX_WAITING)
        for each in clients.values():
            await each.transport.close()


def test_everybody_has_a_turn_and_the_longest_queue_loses_its_oldest() -> None:
    counters = Counters(None)  # type: ignore[arg-type]  # nothing is logged here
    counters.drop = lambda reason, detail="": counters.__setitem__(reason, counters[reason] + 1)
    inbox = ClientInbox(counters)
    query, request = QueryStatus().encode(), create(1, 1.0).encode()
    for number in range(MAX_WAITING + 10):
        inbox.put(Packet(STRANGERS[0], ME, request, number & 0xFFFF))
    inbox.put(Packet(STRANGERS[0], ME, query, 1))
    inbox.put(Packet(OPERATOR, ME, request, 2))
    assert (len(inbox), counters["inbox_full"]) == (MAX_WAITING, 12)
    taken = [inbox.take() for _ in range(4)]
    assert [(each.source, each.sequence) for each in taken] == [
        (STRANGERS[0], 12),
        (STRANGERS[0], 1),
        (OPERATOR, 2),
        (STRANGERS[0], 13),
    ]


@pytest.mark.parametrize(
    ("message", "expected"),
    [(QueryStatus(), True), (create(1, 1.0), True), (Standby(), False), (ReportStatus(1, 0), False), (Resume(), False)],
)
def test_what_may_wait(message, expected: bool) -> None:
    assert may_wait(Packet(OPERATOR, ME, message.encode(), 1)) is expected


# --- events


class Clock:
    """A host on a clock that the test sets, and the events that it sends."""

    def __init__(self) -> None:
        self.host, self.now = host(), 0.0
        self.events: Counter[JausID] = Counter()
        self.most = 0
        self.host.receive(RequestControl(200).encode(), OPERATOR, 0.0)

    def subscribe(self, client: JausID, count: int, rate: float) -> int:
        for number in range(count):
            self.host.receive(create(number, rate).encode(), client, self.now)
        answers = [registry.decode(each.payload) for each in self.host.poll_output(self.now)]
        return sum(isinstance(each, ConfirmEventRequest) for each in answers)

    def turn(self) -> int:
        """One turn of an event loop; the events that are sent in it to clients without control."""
        self.host.handle_timeout(self.now)
        sent = Counter(each.destination for each in self.host.poll_output(self.now))
        self.events += sent
        return sum(count for client, count in sent.items() if client != OPERATOR)

    def run(self, seconds: float) -> None:
        end = self.now + seconds
        while (due := self.host.next_timeout()) is not None and due <= end:
            self.now = max(self.now, due)
            self.most = max(self.most, self.turn())
        self.now = end


def test_events_are_sent_in_small_parts_at_a_bounded_rate() -> None:
    clock = Clock()
    assert sum(clock.subscribe(each, 32, 100.0) for each in STRANGERS) == 96, "a quarter is kept for who is in control"
    clock.run(1.0)
    clock.events.clear()
    clock.run(4.0)
    assert clock.most <= MAX_BACKGROUND_TIMERS
    assert 0.95 * 4 * BACKGROUND_RATE <= clock.events.total() <= 4 * BACKGROUND_RATE + BACKGROUND_BURST
    assert min(clock.events.values()) > 0.9 * max(clock.events.values()), "everybody gets a share"


def test_events_of_the_client_in_control_come_in_time() -> None:
    clock = Clock()
    for each in STRANGERS:
        clock.subscribe(each, 32, 100.0)
    assert clock.subscribe(OPERATOR, 32, 25.0) == 32
    clock.run(2.0)
    assert clock.events[OPERATOR] == pytest.approx(32 * 25 * 2, rel=0.05)


def test_after_a_stall_a_command_does_not_wait_for_events() -> None:
    clock = Clock()
    for each in STRANGERS:
        clock.subscribe(each, 32, 100.0)
    clock.now = 5.0
    clock.host.receive(Resume().encode(), OPERATOR, clock.now)
    assert clock.host.state.endswith("Ready")
    assert clock.host.poll_output(clock.now) == []


def test_without_room_in_the_transport_events_wait() -> None:
    clock = Clock()
    clock.subscribe(STRANGERS[0], 10, 100.0)
    clock.run(0.1)
    clock.now += 1.0
    clock.host.handle_timeout(clock.now, room=False)
    assert clock.host.poll_output(clock.now) == []
    assert clock.host.next_timeout() > clock.now
    clock.run(0.1)
    assert clock.most > 0


def test_usual_loads_are_as_fast_as_before() -> None:
    """All that is due at once is sent at once, and none is left out."""
    clock = Clock()
    for each in STRANGERS[:3]:
        clock.subscribe(each, 32, 10.0)
    clock.run(1.0)
    clock.events.clear()
    clock.run(2.0)
    assert clock.events.total() == 3 * 32 * 10 * 2


def test_events_of_all_modules_of_a_robot_delay_a_command_by_few_events() -> None:
    """Seven modules in one process, each with all the events it takes, send at most sixteen in a turn."""
    modules = [Clock() for _ in range(7)]
    for each in modules:
        for client in STRANGERS[:3]:
            each.subscribe(client, 32, 100.0)
        each.host.handle_timeout(1.0)
    assert 7 <= sum(len(each.host.poll_output(1.0)) for each in modules) <= 16
