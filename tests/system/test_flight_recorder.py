"""A robot with a flight recorder: what happens is in a file, with what came before and after."""

from __future__ import annotations

import asyncio
import signal
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from jauspy.inspection.traffic import seen_messages
from jauspy.messages import registry
from jauspy.messages.core import QueryStatus, SetEmergency
from jauspy.messages.mobility import QueryLocalPose, ReportLocalPose
from jauspy.ocu import OCU
from jauspy.recording.mcap_capture import open_capture_file

pytest.importorskip("foxglove", reason="foxglove-sdk is of the extra `recording`")
pytest.importorskip("mcap", reason="mcap is of the extra `recording`")

pytestmark = pytest.mark.alone


def up(root: Path, port: int, *options: str) -> tuple[str, ...]:
    where = ("--port", str(port), "--interface", "127.0.0.1", "--local-root", str(root), "--plain")
    return ("up", "inc1", "--backend", "kinematic", *where, "--record-to", str(root / "runs"), *options)


def messages(path: Path) -> list[tuple[str, float]]:
    with path.open("rb") as file:
        return [(seen.name, seen.time) for seen in seen_messages(open_capture_file(file, name=path.name), registry)]


async def said(process: subprocess.Popen[str], text: str) -> str:
    """The line on standard error with this text."""
    assert process.stderr is not None
    async with asyncio.timeout(60):
        while text not in (line := await asyncio.to_thread(process.stderr.readline)):
            assert line, f"{text!r} was never said"
    return line


@pytest.mark.slow
async def test_an_emergency_is_recorded_with_before_and_after(
    root: Path, free_port: int, start: Callable[..., subprocess.Popen[str]]
) -> None:
    options = ("--record-on", "emergency,control-lost,failure", "--before", "5", "--after", "1")
    robot = await asyncio.to_thread(start, *up(root, free_port, *options), ready="stop it")
    async with OCU(connect=f"local:{root}") as ocu:
        sensor = (await ocu.discover(101)).service("LocalPoseSensor")
        query = QueryLocalPose(presence_vector=1)
        async with sensor.subscribe(query, expects=ReportLocalPose, rate=20.0) as poses:
            for _ in range(10):
                await poses.get()
            await sensor.send(SetEmergency(SetEmergency.EmergencyCode(1)))
            await sensor.query(QueryStatus())
            line = await said(robot, "is complete")
    (path,) = (root / "runs").iterdir()
    assert str(path) in line
    assert path.name.startswith("101-")
    assert path.name.endswith("-emergency.mcap")
    found = messages(path)
    (emergency,) = [time for name, time in found if name == "SetEmergency"]
    times = [time for name, time in found if name == "Event"]
    assert len([time for time in times if time < emergency]) >= 5
    assert len([time for time in times if time > emergency]) >= 5
    assert max(times) <= emergency + 1.5


HOLD = """
import asyncio, sys
from jauspy.ocu import OCU

async def main():
    async with OCU("42.1.7", connect=f"local:{sys.argv[1]}") as ocu:
        driver = (await ocu.discover(101)).service("PrimitiveDriver")
        async with driver.control():
            print("in control", flush=True)
            await asyncio.sleep(60)

asyncio.run(main())
"""


@pytest.mark.slow
async def test_a_client_that_dies_in_control_is_recorded(
    root: Path, free_port: int, start: Callable[..., subprocess.Popen[str]]
) -> None:
    options = ("--record-on", "control-lost", "--after", "0.5")
    robot = await asyncio.to_thread(start, *up(root, free_port, *options), ready="stop it")
    command = [sys.executable, "-c", HOLD, str(root)]
    client = await asyncio.create_subprocess_exec(*command, stdout=subprocess.PIPE)
    assert client.stdout is not None
    assert b"in control" in await client.stdout.readline()
    client.kill()
    await client.wait()
    await said(robot, "is complete")
    (path,) = (root / "runs").iterdir()
    assert "-control-lost" in path.name
    assert "ConfirmControl" in {name for name, _ in messages(path)}


@pytest.mark.slow
async def test_it_goes_on_after_its_node_manager(
    root: Path, free_port: int, start: Callable[..., subprocess.Popen[str]]
) -> None:
    node = ("node-manager", "--address", "127.0.0.1", "--port", str(free_port), "--local-root", str(root))
    first = await asyncio.to_thread(start, *node, ready="ready")
    recorder = await asyncio.to_thread(
        start,
        "flight-recorder",
        "--local-root",
        str(root),
        "-o",
        str(root / "runs"),
        "--after",
        "0",
        ready="on emergency",
    )
    first.send_signal(signal.SIGTERM)
    await said(recorder, "has ended")
    await asyncio.to_thread(start, *node, ready="ready")
    async with OCU("42.1.8", connect=f"local:{root}") as ocu, OCU("101.1.9", connect=f"local:{root}") as robot:
        async with asyncio.timeout(60):
            while not any((root / "runs").iterdir()):
                await ocu.send(robot.id, SetEmergency(SetEmergency.EmergencyCode(1)))
                await asyncio.sleep(0.1)
    await said(recorder, "is complete")


@pytest.mark.slow
@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        (("--record-on", "fire"), "--record-on: 'fire' is nothing to record on; these are: emergency, control-lost"),
        (("--before", "3"), "--before needs --record-on"),
    ],
)
def test_wrong_options_are_said_in_a_sentence(root: Path, options: tuple[str, ...], sentence: str) -> None:
    command = [sys.executable, "-m", "jauspy.cli.main", "up", "inc1", "--local-root", str(root), *options]
    result = subprocess.run(command, capture_output=True, text=True, timeout=60, check=False)
    assert result.returncode == 1
    assert sentence in " ".join(result.stderr.split())
