"""The live table of a robot that runs: what it shows, and how it ends."""

from __future__ import annotations

import asyncio
import io
import os
import pty
import signal
import subprocess
import sys
import time

import psutil
import pytest
from rich.console import Console

from jauspy.cli.up_table import StatusSampler, _is_loss, table
from jauspy.ids import JausID
from jauspy.messages.core import CreateEvent, RequestControl, Resume
from jauspy.messages.mobility import QueryLocalPose, SetWrenchEffort
from jauspy.protocol.endpoint import Endpoint
from jauspy.robot.robot_files import load
from jauspy.robot.runner import RobotRunner
from jauspy.transport import LoopbackHub, LoopbackTransport
from jauspy.video.camera_protocol import StreamReduced

ROBOT, CLIENT = JausID(101, 1, 102), JausID(42, 1, 1)
STATUS = {
    "networks": [{"address": "0.0.0.0:3794", "receive_buffer": {"dropped": 3}}],
    "components": [{}, {}],
    "peers": [{}],
    "counters": {"routed.local": 40, "routed.udp": 2, "dropped.not_here": 7},
}


def drawn(runner, look):
    page = Console(file=io.StringIO(), width=120)
    page.print(table(runner.config, look, 3725.0))
    return page.file.getvalue()


@pytest.mark.parametrize(
    ("counter", "lost"),
    [
        ("host.received", False),
        ("host.report_cut", False),
        ("host.ignored", True),
        ("component.failed", True),
        ("endpoint.received", False),
        ("transport.dropped.full", True),
    ],
)
def test_deliveries_and_truncated_answers_are_no_losses(counter, lost):
    assert _is_loss(counter) == lost


@pytest.mark.slow
async def test_table_shows_controllers_and_losses() -> None:
    hub = LoopbackHub()
    endpoint, wire = Endpoint(CLIENT, first_sequence=0), LoopbackTransport(CLIENT, hub)
    await wire.open()
    async with RobotRunner(load("inc1"), lambda me: LoopbackTransport(me, hub), backend="kinematic") as runner:
        sampler = StatusSampler(runner)
        first = sampler.sample(10.0, {**STATUS, "counters": {}})
        assert (first.modules[0].status, first.modules[0].controller) == ("standby", "")
        event = CreateEvent(
            request_id=1,
            event_type=CreateEvent.EventType.PERIODIC,
            requested_periodic_rate=20.0,
            query_message=QueryLocalPose(0x1FF),
        )
        for message in (SetWrenchEffort(propulsive_linear_effort_x=1.0), RequestControl(200), Resume(), event):
            endpoint.send(ROBOT, message.encode(), now=0.0)
        for datagram in endpoint.poll_output():
            wire.send(datagram)
        async with asyncio.timeout(20):
            while runner.components[0].counters.get("endpoint.received", 0) < 4:
                await asyncio.sleep(0.01)
        look = sampler.sample(12.0, STATUS)
        driver, *others = look.modules
        who = (driver.id, driver.type, driver.status, driver.controller)
        assert who == ("101.1.102", "CM-MOB", "ready", "42.1.1 (200)")
        assert (driver.events, driver.hertz, driver.received) == (1, pytest.approx(20.0, abs=0.1), 2.0)
        assert driver.dropped == {"host.ignored": 1}
        assert all((each.status, each.dropped) == ("standby", {}) for each in others)
        seen = [(each.name, each.module, each.size) for each in look.cameras]
        assert seen == [
            ("arm", "101.1.106", (640, 480)),
            ("chassis", "101.1.107", (640, 480)),
            ("outside", "101.1.109", (640, 480)),
        ]
        assert look.node is not None
        assert (look.node.packets, look.node.dropped) == (21.0, {"dropped.not_here": 7, "by the kernel": 3})
        text = drawn(runner, look)
        runner.videos["arm"]._on_message(StreamReduced("the robot's machine is too slow for camera arm"))
        assert "too slow" not in text
        assert "the robot's machine is too slow for camera arm" in drawn(runner, sampler.sample(13.0, STATUS))
    await wire.close()
    assert "up 1:02:05" in text
    assert "1 101.1.102: host.ignored" in text
    assert "7 node manager: dropped.not_here" in text
    assert "1 (20 Hz)" in text


@pytest.mark.slow
def test_table_is_drawn_on_a_terminal_and_ends_in_order(free_port, local_root) -> None:
    ours, theirs = pty.openpty()
    options = ("--backend", "kinematic", "--port", str(free_port), "--local-root", str(local_root))
    process = subprocess.Popen(
        [sys.executable, "-m", "jauspy.cli.main", "up", "inc1", *options],
        **dict.fromkeys(("stdin", "stdout", "stderr"), theirs),
        env={**os.environ, "TERM": "xterm", "COLUMNS": "120", "LINES": "50"},
    )
    os.close(theirs)
    said = read_until(ours, "101.1.107", "CM-VIS", "Ctrl-C stops the robot")
    family = psutil.Process(process.pid).children(recursive=True)
    assert "of real time" in said
    process.send_signal(signal.SIGINT)
    ended = read_until(ours, "everything has stopped")
    assert process.wait(20) == 130
    os.close(ours)
    order = [ended.index(f"stopping the {what}") for what in ("modules", "node manager")]
    assert order == sorted(order)
    assert not psutil.wait_procs(family, timeout=30)[1]


def read_until(terminal: int, *texts: str) -> str:
    """What appears there, until all of that has."""
    said, until = "", time.monotonic() + 60
    while not all(text in said for text in texts):
        if time.monotonic() > until:
            pytest.fail(f"{texts} did not appear in: {said}")
        said += os.read(terminal, 4096).decode(errors="replace")
    return said
