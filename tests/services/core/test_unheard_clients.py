"""Events end when their client is on another machine and shows no sign of life: a forged request buys few reports."""

import pytest

from jauspy.ids import JausID
from jauspy.messages.core import CreateEvent, Event, QueryHeartbeatPulse, QueryStatus
from jauspy.protocol.addressing import UNKNOWN_LOCATION
from jauspy.services.core import AccessControl, Events, Liveness, Management

CLIENT, OTHER = JausID.parse("42.1.1"), JausID.parse("43.1.1")
RATE = 100.0
RESENDS = 3


class Network:
    """A component at 100 Hz, and clients that acknowledge or do not; counts the datagrams of its reports."""

    def __init__(self, make, *, local: bool = False) -> None:
        self.host = make(Management(), AccessControl(), Liveness(), Events(timeout=0)).host
        if not local:
            self.host.locate = lambda _, found: found(UNKNOWN_LOCATION)
        self.now = 0.0
        self.acknowledges = {CLIENT: False, OTHER: False}
        self.reports: dict[JausID, int] = {CLIENT: 0, OTHER: 0}
        self.datagrams = 0
        self._pending = []

    def receive(self, client: JausID, message) -> None:
        self.host.receive(message.encode(), client, self.now)
        self.send()

    def send(self) -> None:
        for outgoing in self.host.poll_output(self.now):
            if outgoing.payload[:2] != Event.CODE.to_bytes(2, "little"):
                continue
            client = outgoing.destination
            self.reports[client] += 1
            self.datagrams += 1
            if outgoing.on_acknowledged is not None:
                delay = 0.03 if self.acknowledges[client] else 0.4
                self.datagrams += 0 if self.acknowledges[client] else RESENDS
                self._pending.append((self.now + delay, self.acknowledges[client], outgoing.on_acknowledged))

    def run(self, seconds: float) -> None:
        end = self.now + seconds
        while self.now < end:
            self.now = round(self.now + 0.005, 3)
            for entry in [each for each in self._pending if each[0] <= self.now]:
                self._pending.remove(entry)
                self.host.now = self.now
                entry[2](entry[1])
            self.host.handle_timeout(self.now)
            self.send()

    def forget_pending(self) -> None:
        self._pending.clear()

    def events(self) -> int:
        return len(self.host.service(Events).subscriptions)


@pytest.fixture
def network(make) -> Network:
    return Network(make)


def create(rate: float = RATE, kind: int = 0) -> CreateEvent:
    return CreateEvent(1, kind, rate, QueryStatus())


def test_a_forged_request_buys_ten_datagrams_and_two_seconds(network) -> None:
    network.receive(CLIENT, create())
    network.run(10.0)
    assert 1 <= network.datagrams <= 10
    assert network.events() == 0
    assert network.host.counters["events.unheard_ended"] == 1


def test_slow_events_end_as_well(network) -> None:
    network.receive(CLIENT, create(0.5))
    network.run(20.0)
    assert network.events() == 0
    assert network.datagrams <= 10


def test_a_client_that_acknowledges_is_served_at_full_rate(network) -> None:
    network.acknowledges[CLIENT] = True
    network.receive(CLIENT, create())
    network.run(30.0)
    assert network.reports[CLIENT] >= 30 * RATE * 0.99
    assert network.host.counters["events.unheard_ended"] == 0


def test_few_reports_request_an_acknowledgement(network) -> None:
    network.acknowledges[CLIENT] = True
    requested = []
    send = network.host.poll_output
    network.host.poll_output = lambda now: [
        requested.append(each.on_acknowledged) or each for each in send(now) if each.payload[:2] == b"\xf1\x41"
    ]
    network.receive(CLIENT, create())
    network.run(10.0)
    assert sum(each is not None for each in requested) <= 12


def test_a_client_that_leaves_is_not_sent_to_for_long(network) -> None:
    network.acknowledges[CLIENT] = True
    network.receive(CLIENT, create())
    network.run(5.0)
    network.acknowledges[CLIENT] = False
    network.run(9.0)
    assert network.events() == 1, "a link may be down for a while"
    network.run(3.0)
    assert network.events() == 0


def test_a_client_that_does_not_acknowledge_but_is_heard_has_its_events(network) -> None:
    network.receive(CLIENT, create(5.0))
    for _ in range(20):
        network.run(1.0)
        network.receive(CLIENT, QueryHeartbeatPulse())
    assert network.events() == 1
    assert network.reports[CLIENT] >= 60


def test_events_on_change_end_when_their_report_was_not_acknowledged(network) -> None:
    network.receive(CLIENT, create(25.0, kind=1))
    network.run(6.0)
    assert network.events() == 0
    assert network.reports[CLIENT] == 1


def test_outcomes_that_never_come_do_not_stop_events(network) -> None:
    """As when the component has too many acknowledgements pending, and sends a report without one."""
    network.acknowledges[OTHER] = True
    network.receive(CLIENT, create())
    network.run(0.1)
    network.forget_pending()
    network.run(10.0)
    assert network.events() == 0
    network.receive(OTHER, create())
    network.run(10.0)
    assert network.events() == 1


def test_clients_on_this_machine_are_not_checked(make) -> None:
    network = Network(make, local=True)
    network.receive(CLIENT, create())
    network.run(20.0)
    assert network.events() == 1
    assert network.reports[CLIENT] >= 20 * RATE * 0.99


def test_events_of_others_are_not_affected(network) -> None:
    network.acknowledges[OTHER] = True
    network.receive(CLIENT, create())
    network.receive(OTHER, create())
    network.run(10.0)
    assert network.events() == 1
    assert network.reports[OTHER] >= 10 * RATE * 0.98


def test_a_client_whose_events_ended_may_create_them_again(network) -> None:
    network.receive(CLIENT, create())
    network.run(10.0)
    network.acknowledges[CLIENT] = True
    network.receive(CLIENT, create())
    network.run(10.0)
    assert network.events() == 1
