"""Replay recorded traffic against a component: its answers must be the recorded ones.

Run it with `pytest test_replay.py`. This capture is written by the test itself; those of Wireshark, tcpdump and
`jauspy conformance --pcapng` are read in the same way.
"""

import asyncio
from pathlib import Path

import pytest

from jauspy import JausID
from jauspy.capture import writer
from jauspy.capture.reader import CaptureReader
from jauspy.messages import registry
from jauspy.protocol import judp
from jauspy.protocol.header import Packet
from jauspy.services.core import AccessControl
from jauspy.testing import VirtualNetwork

COMPONENT, CLIENT = JausID.parse("101.1.120"), JausID.parse("42.1.1")
RECORDED = (  # seconds, and a datagram of JUDP
    (0.0, "02 00 10 00 01 78 01 65 00 01 01 2a 00 02 20 e3 f3"),  # QueryStatus
    (0.0, "02 00 15 00 01 01 01 2a 00 78 01 65 00 02 40 02 00 00 00 00 03 ad"),  # ReportStatus: Standby
    (0.1, "02 00 11 00 01 78 01 65 00 01 01 2a 00 0d 00 c8 e4 f3"),  # RequestControl
    (0.1, "02 00 11 00 01 01 01 2a 00 78 01 65 00 0f 00 00 04 ad"),  # ConfirmControl: accepted
    (0.2, "02 00 10 00 01 78 01 65 00 01 01 2a 00 04 00 e5 f3"),  # Resume
    (5.0, "02 00 10 00 01 78 01 65 00 01 01 2a 00 02 20 e6 f3"),  # QueryStatus
    (5.0, "02 00 15 00 01 01 01 2a 00 78 01 65 00 02 40 01 00 00 00 00 05 ad"),  # ReportStatus: Ready
    (5.1, "02 00 11 00 01 01 01 2a 00 78 01 65 00 10 00 00 06 ad"),  # RejectControl, 5 s after RequestControl
    (5.2, "02 00 10 00 01 78 01 65 00 01 01 2a 00 02 20 e7 f3"),  # QueryStatus
    (5.2, "02 00 15 00 01 01 01 2a 00 78 01 65 00 02 40 02 00 00 00 00 07 ad"),  # ReportStatus: Standby
)


@pytest.fixture
def capture(tmp_path: Path) -> Path:
    path, address = tmp_path / "recorded.pcapng", ("127.0.0.1", judp.PORT)
    blocks = [writer.packet(address, address, bytes.fromhex(data), round(time * 1e9)) for time, data in RECORDED]
    path.write_bytes(writer.preamble() + b"".join(blocks))
    return path


def read(path: Path) -> list[tuple[float, Packet]]:
    """The time of each packet in seconds, and the packet."""
    with path.open("rb") as file:
        datagrams = CaptureReader(file, name=path.name)
        return [(datagram.time, packet) for datagram in datagrams for packet in judp.unpack(datagram.payload)]


@pytest.mark.asyncio
async def test_component_answers_as_recorded(virtual_network: VirtualNetwork, capture: Path) -> None:
    traffic = read(capture)
    client, clock = virtual_network.transport(CLIENT), virtual_network.clock
    async with virtual_network.component(COMPONENT, [AccessControl(timeout=5)]):
        await client.open()
        for time, packet in traffic:
            if packet.destination == COMPONENT:
                await asyncio.sleep(time - traffic[0][0] - clock.elapsed)  # virtual time: the test does not wait
                client.send(judp.pack(packet))
        await asyncio.sleep(1.0)
        answers = [registry.decode(packet.payload) for packet in virtual_network.log if packet.source == COMPONENT]
        await client.close()
    assert answers == [registry.decode(packet.payload) for _, packet in traffic if packet.source == COMPONENT]
