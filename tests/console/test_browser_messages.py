"""The console's own sockets: what does not have their form is refused and counted, and the robot stops."""

from __future__ import annotations

import asyncio
import json
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from dataclasses import dataclass
from typing import Any

import pytest

pytest.importorskip("nicegui", reason="needs the extra 'console'")

from hypothesis import example, given, strategies as st
from tests.helpers.browser_sockets import BrowserSocket

from jauspy.console.browser_messages import (
    MAX_AT_ONCE,
    MAX_INVALID,
    MAX_MESSAGE,
    drive_message,
    jog_message,
    stop_request,
    video_request,
)
from jauspy.console.console import Console
from jauspy.console.operation import MAX_SPEED, MAX_TURN_RATE
from jauspy.console.server import MAX_REQUESTS, make_app
from jauspy.console.users import Session, User, current
from jauspy.ocu.robot import Robot
from jauspy.testing import VirtualNetwork

ANNA = User("anna", "operator", 127)
HOSTILE = (
    "[" * 500,
    "NaN",
    "[NaN,1]",
    "[1e999,0]",
    "[-1e999,0]",
    "[Infinity,0]",
    '["1",0]',
    "[true,0]",
    "[1.5,0]",
    "{}",
    "",
)
"""Messages that are no deflections of a stick."""


@dataclass
class Desk:
    console: Console
    app: Any
    robot: Robot
    token: str
    sent: list[tuple[float, float]]
    """Velocities that were commanded: m/s and rad/s."""

    def socket(self, path: str, user: User = ANNA) -> BrowserSocket:
        return BrowserSocket(self.app, f"{path}/{self.token}", user)


@asynccontextmanager
async def desk(network: VirtualNetwork, monkeypatch: pytest.MonkeyPatch) -> AsyncIterator[Desk]:
    """A console whose operator is anna, with a robot in memory."""
    async with network.robot(), network.ocu() as ocu, network.ocu("42.1.3") as stopper:
        robot, sent = await ocu.discover(101), list[tuple[float, float]]()
        console = Console(ocu, stopper)
        console.fleet.robots = {101: robot}
        current.set(Session(ANNA, "127.0.0.1"))
        browser = console.new_browser(lambda: None)
        assert browser is not None
        operation = console.operation(101)
        assert operation is not None
        assert await operation.take(browser[0], 127, ANNA) == ""
        drive = operation._drive

        async def recorded(linear: float, angular: float) -> None:
            sent.append((linear, angular))
            await drive(linear, angular)

        monkeypatch.setattr(operation, "_drive", recorded)
        try:
            yield Desk(console, make_app(console), robot, browser[0], sent)
        finally:
            await console.close()


@pytest.mark.slow
async def test_a_stick_that_sends_anything_else_stops_the_robot(
    virtual_network: VirtualNetwork, monkeypatch: pytest.MonkeyPatch
) -> None:
    async with desk(virtual_network, monkeypatch) as at, at.socket("/ws/drive/101") as drive:
        for text in HOSTILE:
            drive.send("[0.5, 0]")
            await drive.settled()
            operation = at.console.operation(101)
            assert operation is not None
            assert operation._wanted == (0.25, 0.0) or at.sent
            drive.send(text)
            await drive.settled()
            assert operation._dead_man._timer is None, text
        assert drive.code is None
        await asyncio.sleep(0.1)
        assert at.sent
        assert all(linear == 0.25 and angular == 0.0 for linear, angular in at.sent)
        assert at.console.counters["/ws/drive, not valid"] == len(HOSTILE)
        assert "messages on /ws/drive that were refused: 8, not valid; the last one of anna" in {
            each.text for each in at.console.events
        }


@pytest.mark.slow
@pytest.mark.parametrize("path", ["/ws/drive/101", "/ws/jog/101.1.104", "/ws/video/101.1.106", "/ws/world/101"])
async def test_bytes_and_long_messages_are_refused_on_every_socket(
    virtual_network: VirtualNetwork, monkeypatch: pytest.MonkeyPatch, path: str
) -> None:
    async with desk(virtual_network, monkeypatch) as at, at.socket(path) as page:
        page.send(b"\x00\xff")
        page.send("9" * (MAX_MESSAGE + 1))
        await page.settled()
        assert page.code is None
        for _ in range(MAX_INVALID):
            page.send("[" * 500)
        await page.settled()
        assert page.code == 1008
        assert sum(at.console.counters.values()) == MAX_INVALID


@pytest.mark.slow
async def test_a_flood_closes_the_socket_and_stops_the_robot(
    virtual_network: VirtualNetwork, monkeypatch: pytest.MonkeyPatch
) -> None:
    async with desk(virtual_network, monkeypatch) as at, at.socket("/ws/drive/101") as drive:
        for _ in range(2 * MAX_AT_ONCE):
            drive.send("[1.0, 1.0]")
        await drive.settled()
        assert drive.code == 1008
        operation = at.console.operation(101)
        assert operation is not None
        assert operation._dead_man._timer is None
        assert at.console.counters["/ws/drive, too many"] == 1


@pytest.mark.slow
async def test_the_socket_for_stops_is_never_closed(
    virtual_network: VirtualNetwork, monkeypatch: pytest.MonkeyPatch
) -> None:
    async with desk(virtual_network, monkeypatch) as at, at.socket("/ws/stop") as stop:
        for text in ("stop \u0661\u0660\u0661", "stop 0", "stop 70000", "stop", "leave 1", "release -1", b"\xff"):
            stop.send(text)
        for _ in range(2 * MAX_AT_ONCE):
            stop.send("[" * 500)
        stop.send("stop 101")
        await stop.settled()
        async with asyncio.timeout(10.0):
            while not str(stop.said[-1]).endswith("stopped"):
                await asyncio.sleep(0.01)
        assert stop.code is None
        assert at.console.events[-1].user == "anna"
        assert at.console.events[-1].text.startswith("emergency stop of 101: ")


def noting_emergencies(console: Console, monkeypatch: pytest.MonkeyPatch) -> list[tuple[float, str]]:
    """Messages that set or clear emergencies, as they are sent, with times in seconds."""
    ocu, sent = console._emergency_ocu, list[tuple[float, str]]()
    send = ocu.send

    async def noted(to: Any, message: Any, **options: Any) -> None:
        sent.append((asyncio.get_running_loop().time(), message.NAME))
        await send(to, message, **options)

    monkeypatch.setattr(ocu, "send", noted)
    return sent


@pytest.mark.slow
@pytest.mark.parametrize("by_another", [False, True])
async def test_a_stop_waits_for_no_release_and_is_not_undone_by_one(
    virtual_network: VirtualNetwork, monkeypatch: pytest.MonkeyPatch, by_another: bool
) -> None:
    async with desk(virtual_network, monkeypatch) as at, at.socket("/ws/stop") as stop, at.socket("/ws/stop") as other:
        sent = noting_emergencies(at.console, monkeypatch)
        stop.send("stop all")
        stop.send("release all")
        await asyncio.sleep(1.2)
        assert {name for _, name in sent} == {"SetEmergency", "ClearEmergency"}, "the release has begun"
        (other if by_another else stop).send("stop all")
        begun = asyncio.get_running_loop().time()
        await asyncio.sleep(3.0)
        times = [time for time, name in sent if name == "SetEmergency" and time >= begun]
        assert times[0] - begun < 0.01
        assert not [name for time, name in sent if name == "ClearEmergency" and time > begun]
        assert stop.said[1] == "not released: a stop came meanwhile"
        assert str((other if by_another else stop).said[-1]).endswith("components stopped")


@pytest.mark.slow
async def test_a_key_that_is_held_sends_one_stop_and_a_release_follows_it(
    virtual_network: VirtualNetwork, monkeypatch: pytest.MonkeyPatch
) -> None:
    async with desk(virtual_network, monkeypatch) as at, at.socket("/ws/stop") as stop:
        sent = noting_emergencies(at.console, monkeypatch)
        for _ in range(90):
            stop.send("stop all")
        stop.send("release all")
        await asyncio.sleep(3.0)
        assert [str(text).rpartition(" components ")[2] for text in stop.said] == [
            "stopped",
            "released from the emergency",
        ]
        names = [name for _, name in sent]
        assert names == sorted(names, reverse=True), "no release before the end of the stop"


@pytest.mark.slow
async def test_stops_of_many_targets_wait_their_turn(
    virtual_network: VirtualNetwork, monkeypatch: pytest.MonkeyPatch
) -> None:
    async with desk(virtual_network, monkeypatch) as at, at.socket("/ws/stop") as stop:
        for number in range(1, 4 * MAX_REQUESTS):
            stop.send(f"stop {number}")
        stop.send("leave")
        await asyncio.sleep(0.1)
        running = [task for task in asyncio.all_tasks() if task.get_name() == "console: emergency"]
        assert len(running) == MAX_REQUESTS
        await asyncio.sleep(10.0)
        assert len(stop.said) == 4 * MAX_REQUESTS - 1


async def test_numbers_out_of_range_stop_whoever_sends_them(
    virtual_network: VirtualNetwork, monkeypatch: pytest.MonkeyPatch
) -> None:
    async with desk(virtual_network, monkeypatch) as at:
        operation = at.console.operation(101)
        assert operation is not None
        for forward in (float("nan"), float("inf"), -1.5, 1e300):
            assert "a number from -1 to 1" in operation.drive(at.token, forward, 0.0)
        for limit in (float("nan"), float("inf"), -1.0, 1e9, MAX_SPEED + 0.1):
            operation.set_limit(at.token, limit)
        operation.set_limit("another", 0.1)
        assert operation.speed_limit == 0.5
        await asyncio.sleep(0.1)
        assert at.sent == []


JSON = st.recursive(
    st.none() | st.booleans() | st.floats() | st.integers() | st.text(max_size=8),
    lambda inner: st.lists(inner, max_size=8) | st.dictionaries(st.text(max_size=8), inner, max_size=4),
    max_leaves=12,
)


@pytest.mark.slow
@given(st.text(max_size=60) | JSON.map(json.dumps))
@example("[" * MAX_MESSAGE)
@example('{"a":' * 150)
@example("\ud800")
def test_no_text_raises_or_passes_as_more_than_it_is(text: str) -> None:
    if (stick := drive_message(text)) is not None:
        assert all(-1.0 <= each <= 1.0 for each in stick)
        assert MAX_TURN_RATE * abs(stick[1]) <= MAX_TURN_RATE
    if (velocity := jog_message(text)) is not None:
        assert all(abs(each) <= 100.0 for each in velocity[:6])
        assert velocity[6] in ("robot", "tool")
    if (asked := video_request(text)) is not None:
        assert asked.want in (None, "all", "keys", "nothing")
    if (request := stop_request(text)) is not None:
        assert request.verb in ("stop", "release", "leave")
