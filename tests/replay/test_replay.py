"""A recorded session has no difference when it is replayed to the same robot; a fault of the robot is one."""

from __future__ import annotations

import asyncio
import json
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

import pytest
from tests.helpers.command_line import JAUSPY
from typer.testing import CliRunner

import jauspy.testing
from jauspy.capture.reader import Datagram
from jauspy.cli.main import app
from jauspy.codec.message import Message
from jauspy.component import Component
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.core import (
    CancelEvent,
    ConfirmEventRequest,
    CreateEvent,
    Event,
    QueryHeartbeatPulse,
    ReportStatus,
    RequestControl,
    Resume,
)
from jauspy.protocol.endpoint import Endpoint
from jauspy.recording.recorder import Recorder
from jauspy.replay.comparison import Comparison
from jauspy.replay.player import Playback, Result, replay
from jauspy.replay.recorded import Recording, load
from jauspy.services.core import AccessControl, Events, Liveness
from jauspy.testing import VirtualNetwork
from jauspy.transport import Transport

CAPTURES = Path(__file__).parents[2].parent / "shared" / "captures"
START = 1_700_000_000.0
CLIENT, ROBOT = JausID(42, 1, 1), JausID(101, 1, 1)


def services() -> list[Any]:
    return [Events(), AccessControl(), Liveness()]


@asynccontextmanager
async def target(**options: Any) -> AsyncIterator[tuple[VirtualNetwork, Component]]:
    async with VirtualNetwork() as network, network.component(options.pop("id", ROBOT), services()) as component:
        yield network, component


async def play(network: VirtualNetwork, found: Recording, **settings: Any) -> Result:
    async def transport(id: JausID) -> Transport:
        return network.transport(id)

    return await replay(found, registry, transport, Playback(**settings), utc_now=network.utc_now)


async def test_the_same_robot_answers_as_recorded(recording: Path) -> None:
    found = load(recording, registry)
    assert (found.clients, found.subsystem) == ((CLIENT,), 101)
    async with target() as (network, component):
        result = await play(network, found)
        await asyncio.sleep(0.1)
        assert component.controller is None  # control was released
        sent = [packet for packet in network.log if packet.source == JausID(42, 1, 2)]
    assert result.differences == []
    assert result.answers >= 8
    assert result.sent == len(found.requests) >= 10
    assert {packet.destination for packet in sent} == {ROBOT}


async def test_a_recording_of_a_killed_recorder_is_replayed_up_to_its_end(recording: Path, tmp_path: Path) -> None:
    cut, told = tmp_path / "cut.pcapng", list[str]()
    cut.write_bytes(recording.read_bytes()[:-5])
    with pytest.raises(ConfigError, match="cut off"):
        load(cut, registry)
    found = load(cut, registry, on_damage=told.append)
    assert len(told) == 1
    assert "cut off" in told[0]
    async with target() as (network, _):
        assert (await play(network, found)).differences == []


async def test_numbers_are_the_same_too_but_for_the_time(recording: Path) -> None:
    """Among them the id of who is in control, which is another one now."""
    time = ("milliseconds", "seconds", "minutes", "hour", "day", "time", "date")
    async with target() as (network, _):
        result = await play(network, load(recording, registry), comparison=Comparison(strict=True, ignored=time))
    assert result.differences == []


async def test_original_timing_speed_and_as_fast_as_answers_come(recording: Path) -> None:
    found = load(recording, registry)
    elapsed = {}
    for speed in (1.0, 10.0, None):
        async with target() as (network, _):
            before = network.now()
            assert (await play(network, found, speed=speed)).differences == []
            elapsed[speed] = network.now() - before
    last = found.requests[-1].time
    assert elapsed[1.0] == pytest.approx(last, abs=0.1)
    assert elapsed[10.0] == pytest.approx(last / 10, abs=0.1)
    assert elapsed[None] < last / 10


async def test_another_subsystem(recording: Path) -> None:
    async with target(id="7.1.1") as (network, _):
        result = await play(network, load(recording, registry, subsystem=101), subsystem=7)
    assert (result.differences, result.answers > 0) == ([], True)


def lose_status(network: VirtualNetwork) -> None:
    network.lose(ReportStatus, 1)


@pytest.mark.parametrize("asap", [False, True])
async def test_a_lost_answer_is_a_difference(recording: Path, asap: bool) -> None:
    async with target() as (network, _):
        lose_status(network)
        found = await play(network, load(recording, registry), speed=None if asap else 1.0)
    assert any((row.request, row.live) == ("QueryStatus", "(no answer)") for row in found.differences)


def stuck(network: VirtualNetwork, component: Component) -> None:
    """Commands to resume are lost."""
    network.lose(Resume)


def taken(network: VirtualNetwork, component: Component) -> None:
    """Requests for control are lost, so that nobody answers them, and Resume is ignored."""
    network.lose(RequestControl)


@pytest.mark.parametrize(
    ("mutate", "request_name", "live"), [(stuck, "QueryStatus", "STANDBY"), (taken, "RequestControl", "(no answer)")]
)
async def test_a_fault_of_the_target_is_found(
    recording: Path, mutate: Callable[[VirtualNetwork, Component], None], request_name: str, live: str
) -> None:
    async with target() as (network, component):
        mutate(network, component)
        result = await play(network, load(recording, registry))
    first = result.differences[0]
    assert (first.request, first.live, first.source) == (request_name, live, str(ROBOT))
    assert 0.0 < first.time < 3.0


async def test_ids_of_events_are_those_of_now(recording: Path) -> None:
    """Another client has an event already, which takes the id that was recorded."""
    event = CreateEvent(
        request_id=1,
        event_type=CreateEvent.EventType.PERIODIC,
        requested_periodic_rate=1.0,
        query_message=QueryHeartbeatPulse(),
    )
    async with target() as (network, _), network.component("50.1.1", []) as other:
        other.send(ROBOT, event)
        await asyncio.sleep(0.1)
        result = await play(network, load(recording, registry))
        (cancelled,) = network.sent(CancelEvent)
        ids = [ConfirmEventRequest.decode(row.payload).event_id for row in network.sent(ConfirmEventRequest)]
    assert result.differences == []
    assert ids[0] != ids[1] == ids[2] == CancelEvent.decode(cancelled.payload).event_id


async def test_refused_control_is_a_difference(recording: Path) -> None:
    async with target() as (network, _), network.component("50.1.1", []) as other:
        other.send(ROBOT, RequestControl(authority_code=255))
        await asyncio.sleep(0.1)
        result = await play(network, load(recording, registry))
    assert ("RequestControl", "response_code") in {(row.request, row.field) for row in result.differences} or (
        "ConfirmControl",
        "RejectControl",
    ) in {(row.recorded, row.live) for row in result.differences}


def compare(old: Message, new: Message, **settings: Any) -> list[tuple[str, str, str]]:
    return list(Comparison(**settings).differences(old, new))


def test_what_is_compared() -> None:
    from jauspy.messages.mobility import ReportLocalPose

    one, two, bare = ReportLocalPose(x=1.0, y=2.0), ReportLocalPose(x=1.5, y=2.0), ReportLocalPose(x=1.0)
    assert compare(one, two) == []
    assert compare(one, two, strict=True) == [("x", "1.0", "1.5")]
    assert compare(one, two, strict=True, tolerance=0.5) == []
    assert compare(one, two, strict=True, ignored=("x",)) == []
    assert compare(one, bare) == [("y", "2.0", "(absent)")]
    ready, standby = (ReportStatus.from_dict({"status": name, "reserved": 0}) for name in ("READY", "STANDBY"))
    assert compare(ready, standby) == [("status", "READY", "STANDBY")]
    assert compare(ready, standby, ignored=("stat*",)) == []
    assert compare(ready, one) == [("", "ReportStatus", "ReportLocalPose")]


@pytest.mark.parametrize("name", ["sae_management", "cop_waypoint_run_2013"])
@pytest.mark.parametrize("loss", [0.0, 0.3])
async def test_captures_of_others_are_replayed(name: str, loss: float) -> None:
    path = CAPTURES / f"{name}.pcap"
    if not path.is_file():
        pytest.skip(f"{path} is not there")
    found = load(path, registry)
    robot = next(row.packet.destination for row in found.requests if not row.packet.destination.is_wildcard)
    async with target(id=robot) as (network, _):
        network.loss = loss
        result = await play(network, found, speed=None, timeout=0.1)
    assert result.sent + result.unsendable == len(found.requests) > 0


def test_large_messages_are_joined(tmp_path: Path) -> None:
    """The client's endpoint of now divides them again."""
    recorder, endpoint = Recorder(tmp_path / "run.pcapng", registry), Endpoint(CLIENT, first_sequence=65_534)
    payload = b"\xff\x3f" + bytes(range(256)) * 60
    endpoint.send(ROBOT, payload, now=0.0)
    datagrams = endpoint.poll_output()
    assert len(datagrams) > 2
    for number, data in enumerate(datagrams):
        recorder.add(Datagram(number, START, ("10.0.0.2", 3794), ("10.0.0.1", 3794), data))
    recorder.close()
    assert [row.packet.payload for row in load(tmp_path / "run.pcapng", registry).requests] == [payload]


def run(*arguments: object) -> Any:
    return CliRunner().invoke(app, ["replay", *map(str, arguments)])


def test_the_verb(recording: Path, node_manager: jauspy.testing.LocalNode) -> None:
    """Over UDP to a node manager on loopback, with nobody behind it."""
    address = node_manager.udp.removeprefix("udp://")
    found = run(recording, "--to", address, "--as", "42.1.77", "--asap", "--timeout", 0.05, "--json")
    assert found.exit_code == 1
    rows = [json.loads(line) for line in found.stdout.splitlines()]
    assert {row["live"] for row in rows} == {"(no answer)", "(no report)"}
    assert "messages sent" in found.stderr
    assert (
        "QueryStatus to 101.1.1"
        in run(recording, "--to", address, "--as", "42.1.77", "--asap", "--timeout", 0.05).stdout
    )


@pytest.mark.slow
async def test_the_verb_finds_no_difference(recording: Path, node_manager: jauspy.testing.LocalNode) -> None:
    async with node_manager.component(ROBOT, services()):
        process = await asyncio.create_subprocess_exec(
            *JAUSPY, "replay", str(recording), "--to", node_manager.udp, "--as", "42.1.77", "--asap",
            stdout=asyncio.subprocess.PIPE, stderr=asyncio.subprocess.PIPE,
        )  # fmt: skip
        output, errors = await process.communicate()
    assert (process.returncode, output) == (0, b"no difference\n"), errors


def test_errors_are_one_sentence(recording: Path, tmp_path: Path) -> None:
    (tmp_path / "empty.pcap").write_bytes(b"")
    for arguments, problem in (
        ([tmp_path / "none.pcap"], "cannot be read"),
        ([tmp_path / "empty.pcap"], "not a readable pcap"),
        ([recording, "--target", "here"], "write the number of a subsystem"),
        ([recording, "--target", 55], "no command or query of any client to subsystem 55"),
        ([recording, "--as", "42.1.255"], "cannot be a component's id"),
        ([recording, "--from", "9.9.9"], "no command or query of 9.9.9"),
        ([recording, "--filter", "msg == Event"], "that fits the filter"),
    ):
        result = run(*arguments)
        assert (result.exit_code, problem in result.stderr) == (1, True), result.stderr


def test_too_many_clients_for_the_ids(recording: Path) -> None:
    from jauspy.replay.player import _ids_for

    assert [str(id) for id in _ids_for((CLIENT, CLIENT), JausID(42, 1, 7))] == ["42.1.7", "42.1.8"]
    with pytest.raises(ConfigError, match="254 is the last one"):
        _ids_for((CLIENT, CLIENT), JausID(42, 1, 254))


async def test_reports_of_events_are_compared(recording: Path) -> None:
    found = load(recording, registry)
    assert [(key[0], key[1]) for key in found.events.by_event] == [(CLIENT, ROBOT)]
    async with target() as (network, _):
        assert (await play(network, found)).events == 1
    async with target() as (network, _):
        network.lose(Event)
        result = await play(network, found)
    assert [(row.request, row.recorded, row.live) for row in result.differences] == [
        ("Event 1", "ReportHeartbeatPulse", "(no report)")
    ]
