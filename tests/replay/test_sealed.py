"""Commands that an operator sealed: not sent again without a key, and sealed anew with one."""

from __future__ import annotations

import asyncio
from collections.abc import Sequence
from pathlib import Path

import pytest

pytest.importorskip("cryptography", reason="keys of operators need the extra 'operators'")

from jauspy.capture.reader import Datagram
from jauspy.codec.message import Message
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.core import ConfirmControl, QueryStatus, ReportStatus, RequestControl, Resume
from jauspy.messages.operators import RejectCommand, SealedCommand
from jauspy.protocol import judp
from jauspy.protocol.header import Packet
from jauspy.protocol.seal import Operator, OperatorKey
from jauspy.recording.recorder import Recorder
from jauspy.replay.comparison import Comparison
from jauspy.replay.player import Playback, Result, replay
from jauspy.replay.recorded import load
from jauspy.services.core import AccessControl, CommandSeal, Liveness, Management
from jauspy.services.service import Service
from jauspy.testing import VirtualNetwork
from jauspy.transport import Transport

CLIENT, ROBOT = JausID(42, 1, 1), JausID(101, 1, 1)
ALICE = OperatorKey.generate()
START = 1_700_000_000.0


def sealed(command: Message | bytes) -> SealedCommand:
    """As it was recorded: its seal is valid no more."""
    return SealedCommand(1, int(ROBOT), int(CLIENT), 1, 1, 1, 1, command, bytes(64))


SESSION = (
    (CLIENT, sealed(RequestControl(authority_code=127))),
    (ROBOT, ConfirmControl(response_code=ConfirmControl.ResponseCode(0))),
    (CLIENT, sealed(Resume())),
    (CLIENT, QueryStatus()),
    (ROBOT, ReportStatus(ReportStatus.Status.READY, 0)),
)


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return recorded(tmp_path / "sealed.pcapng", SESSION)


def recorded(path: Path, session: Sequence[tuple[JausID, Message]]) -> Path:
    recorder = Recorder(path, registry)
    for number, (source, message) in enumerate(session):
        to = ROBOT if source == CLIENT else CLIENT
        data = judp.pack(Packet(source, to, message.encode(), number))
        addresses = [(f"10.0.0.{id.subsystem % 100 + 1}", 3794) for id in (source, to)]
        recorder.add(Datagram(number, START + number * 0.1, *addresses, data))
    recorder.close()
    return path


async def play(path: Path, network: VirtualNetwork, key: OperatorKey | None, *, strict: bool = False) -> Result:
    async def transport(id: JausID) -> Transport:
        return network.transport(id)

    playback = Playback(speed=None, operator=key, comparison=Comparison(strict=strict))
    return await replay(load(path, registry), registry, transport, playback, utc_now=network.utc_now)


def services() -> list[Service]:
    seal = CommandSeal([Operator("alice", "operator", 127, ALICE.public)], secret=bytes(32))
    return [AccessControl(), Liveness(), Management(), seal]


@pytest.mark.parametrize("strict", [False, True])
async def test_without_a_key_they_are_not_sent(path: Path, strict: bool) -> None:
    async with VirtualNetwork() as network, network.component(ROBOT, services()):
        result = await play(path, network, None, strict=strict)
        assert network.sent(SealedCommand) == []
    assert (result.sent, result.sealed) == (1, 2)
    assert [row.request for row in result.differences if row.live == "(not sent)"] == [
        "RequestControl",
        "Resume",
    ] * strict


async def test_with_a_key_they_are_sealed_anew(path: Path) -> None:
    async with VirtualNetwork() as network, network.component(ROBOT, services()) as component:
        result = await play(path, network, ALICE, strict=True)
        await asyncio.sleep(0.1)
        assert len(network.sent(SealedCommand)) == 3, "the last one releases control"
        assert network.sent(RejectCommand) == []
        assert component.controller is None
    assert (result.sent, result.sealed, result.answers, result.differences) == (3, 0, 2, [])


async def test_a_key_that_the_robot_does_not_know_is_a_difference(path: Path) -> None:
    async with VirtualNetwork() as network, network.component(ROBOT, services()):
        result = await play(path, network, OperatorKey.generate())
    assert ("RequestControl", "RejectCommand") in [(row.request, row.live) for row in result.differences]
    assert ("QueryStatus", "STANDBY") in [(row.request, row.live) for row in result.differences]


async def test_a_component_without_seals_gets_none(path: Path) -> None:
    async with VirtualNetwork() as network, network.component(ROBOT, services()[:-1]):
        result = await play(path, network, ALICE)
        assert network.sent(SealedCommand) == []
    assert result.sealed == 2


async def test_bytes_in_a_seal_that_are_no_message_are_not_sent(tmp_path: Path) -> None:
    path = recorded(tmp_path / "broken.pcapng", [(CLIENT, sealed(b"\x01")), (CLIENT, QueryStatus())])
    async with VirtualNetwork() as network, network.component(ROBOT, services()):
        result = await play(path, network, ALICE)
    assert (result.sent, result.sealed) == (1, 1)
