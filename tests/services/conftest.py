"""A component in memory on a virtual clock, and clients that talk to it."""

from __future__ import annotations

from collections.abc import Callable
from datetime import UTC, datetime, timedelta

import pytest
from tests.helpers.robot import FakeDrive

from jauspy.codec.message import Message
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.services.core import AccessControl, Discovery, Events, Liveness, Management, Time
from jauspy.services.host import Host
from jauspy.services.mobility import LocalPoseSensor, PrimitiveDriver, Vehicle, VelocityStateSensor
from jauspy.services.service import Service

START = datetime(2026, 3, 14, 15, 9, 26, 535000, tzinfo=UTC)


class Rig:
    """A host, its clock, and what it sent."""

    ID = JausID(101, 1, 1)

    def __init__(self, *services: Service, **options) -> None:
        self.now = 0.0
        self.host = Host(self.ID, services, utc_now=lambda: START + timedelta(seconds=self.now), **options)

    def tell(self, client: str, message: Message | bytes) -> list[tuple[str, Message]]:
        """Send a message; what the component sends in turn, as (to, message)."""
        payload = message if isinstance(message, bytes) else message.encode()
        self.host.receive(payload, JausID.parse(client), self.now)
        return self.sent()

    def ask(self, client: str, message: Message | bytes) -> Message:
        """Send a message; the one answer to it, which must go to the same client."""
        ((to, answer),) = self.tell(client, message)
        assert to == client
        return answer

    def sent(self) -> list[tuple[str, Message]]:
        """What waits to be sent, decoded from its bytes."""
        return [(str(each.destination), registry.decode(each.payload)) for each in self.host.poll_output(self.now)]

    def run(self, seconds: float) -> list[tuple[float, str, Message]]:
        """Let time pass; what was sent, as (when, to, message)."""
        end = self.now + seconds
        found: list[tuple[float, str, Message]] = []
        while (due := self.host.next_timeout()) is not None and due <= end:
            self.now = max(self.now, due)
            self.host.handle_timeout(self.now)
            found += ((self.now, to, message) for to, message in self.sent())
        self.now = end
        return found


@pytest.fixture
def drive() -> FakeDrive:
    return FakeDrive()


@pytest.fixture
def make() -> Callable[..., Rig]:
    """Makes a component with the given services."""
    return Rig


@pytest.fixture
def robot(drive: FakeDrive) -> Rig:
    """A component with everything there is."""
    vehicle = Vehicle(drive)
    return Rig(
        PrimitiveDriver(vehicle),
        VelocityStateSensor(vehicle),
        LocalPoseSensor(vehicle),
        Discovery(),
        Liveness(),
        Time(),
        Management(),
        AccessControl(default_authority=1, timeout=5),
        Events(),
    )
