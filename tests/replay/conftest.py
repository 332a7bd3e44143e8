"""A recorded session of an operator with a component."""

from __future__ import annotations

import asyncio
from pathlib import Path
from typing import Any

import pytest

from jauspy.capture.reader import Datagram
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.core import (
    CancelEvent,
    CreateEvent,
    QueryControl,
    QueryHeartbeatPulse,
    QueryIdentification,
    QueryStatus,
    QueryTime,
    RequestControl,
    Resume,
    Standby,
)
from jauspy.protocol import judp
from jauspy.protocol.header import Packet
from jauspy.recording.recorder import Recorder
from jauspy.services.core import AccessControl, Events, Liveness
from jauspy.testing import VirtualNetwork

CLIENT, ROBOT = JausID(42, 1, 1), JausID(101, 1, 1)
START = 1_700_000_000.0


def services() -> list[Any]:
    return [Events(), AccessControl(), Liveness()]


async def session(network: VirtualNetwork) -> None:
    """What an operator does; answers are waited for by time."""
    client = network.component(CLIENT, [])
    async with client:
        await asyncio.sleep(0.1)
        for message in (
            QueryIdentification(query_type=2),
            QueryStatus(),
            RequestControl(authority_code=127),
            QueryControl(),
            Resume(),
            QueryStatus(),
            CreateEvent(
                request_id=3,
                event_type=CreateEvent.EventType(0),
                requested_periodic_rate=2.0,
                query_message=QueryHeartbeatPulse(),
            ),
            CancelEvent(request_id=4, event_id=1),
            QueryTime(presence_vector=255),
            Standby(),
            QueryStatus(),
        ):
            client.send(ROBOT, message)
            await asyncio.sleep(0.25)


@pytest.fixture
async def recording(tmp_path: Path) -> Path:
    """A capture of the session."""
    path = tmp_path / "run.pcapng"
    recorder = Recorder(path, registry)
    async with VirtualNetwork() as network:
        times: list[tuple[float, Packet]] = []
        network.keeps = lambda packet: times.append((network.now(), packet)) or True  # type: ignore[func-returns-value]
        async with network.component(ROBOT, services()):
            await session(network)
    for number, (time, packet) in enumerate(times):
        addresses = [(f"10.0.0.{id.subsystem % 100 + 1}", 3794) for id in (packet.source, packet.destination)]
        recorder.add(Datagram(number, START + time, *addresses, judp.pack(packet)))
    recorder.close()
    return path
