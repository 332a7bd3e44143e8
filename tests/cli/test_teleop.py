"""Teleop: what keys and sticks mean, and driving a robot through a pseudo-terminal."""

from __future__ import annotations

import asyncio
import os
import pty
import re
import subprocess
import time
from contextlib import suppress
from types import SimpleNamespace

import pytest
from tests.helpers.command_line import JAUSPY, jauspy

from jauspy.cli.teleop import ABS_RX, ABS_X, ABS_Y, BTN_TL, EV_ABS, EV_KEY, HOLD, Gamepad, Keys, Speeds
from jauspy.testing.assertions import until


@pytest.fixture
def clock():
    return SimpleNamespace(now=0.0)


@pytest.fixture
def keys(clock):
    return Keys(lambda: clock.now)


def test_key_drives_until_it_is_no_longer_repeated(keys, clock):
    assert keys.motion is None
    keys.take("w")
    assert keys.motion == (1.0, 0.0)
    clock.now += HOLD - 0.1
    keys.take("w")
    clock.now += HOLD - 0.1
    assert keys.motion == (1.0, 0.0)
    clock.now += 0.2
    assert keys.motion is None


@pytest.mark.parametrize(
    ("text", "motion"),
    [
        ("\x1b[D", (0.0, 1.0)),
        ("\x1b[A\x1b[C", (0.0, -1.0)),
        ("Q", (1.0, 0.5)),
        ("w ", None),
        ("wp", None),
        ("\x1b", None),
    ],
)
def test_last_key_counts_and_unknown_keys_stop(keys, text, motion):
    keys.take(text)
    assert keys.motion == motion


@pytest.mark.parametrize("text", ["x", "wwx", "\x04", ""])
def test_x_and_the_end_of_the_input_end(keys, text):
    keys.take(text)
    assert keys.ended


def test_speeds_stay_within_the_limits_of_the_robot(keys):
    keys.take("+++-")
    assert keys.speed_steps == 2
    speeds = Speeds(0.4, 0.6)
    speeds.scale(100.0, (1.5, 2.0))
    assert (speeds.linear, speeds.angular) == (1.5, 2.0)
    speeds.scale(1e-6, (1.5, 2.0))
    assert speeds.linear > 0


class FakeDevice:
    """A gamepad as evdev has it; `events` are read next, None is an unplugged device."""

    name = "pad"

    def __init__(self) -> None:
        self.fd, self._other = os.pipe()
        self.events: list | None = []

    def capabilities(self):
        info = SimpleNamespace(min=-100, max=100)
        return {EV_ABS: [(ABS_X, info), (ABS_Y, info), (ABS_RX, info)]}

    def read(self):
        if self.events is None:
            raise OSError(19, "No such device")
        return [SimpleNamespace(type=type, code=code, value=value) for type, code, value in self.events]

    def signal(self) -> None:
        os.write(self._other, b".")

    def close(self) -> None:
        os.close(self.fd)
        os.close(self._other)


async def test_gamepad_drives_only_while_a_shoulder_is_held():
    device, notes = FakeDevice(), []
    pad = Gamepad(device, notes.append)
    pad.open()
    device.events = [(EV_ABS, ABS_Y, -50), (EV_ABS, ABS_X, 5), (EV_ABS, ABS_RX, 100)]
    device.signal()
    await asyncio.sleep(0.01)
    assert pad.motion is None
    device.events = [(EV_KEY, BTN_TL, 1)]
    await until(lambda: pad.motion == (0.5, -1.0))
    device.events = [(EV_KEY, BTN_TL, 0)]
    await until(lambda: pad.motion is None)
    device.events = [(EV_KEY, BTN_TL, 1)]
    await until(lambda: pad.motion is not None)
    device.events = None
    await until(lambda: notes)
    assert notes == ["the gamepad pad is gone: No such device"]
    assert pad.motion is None
    pad.close()


def test_teleop_needs_a_terminal(monkeypatch):
    assert "reads keys from a terminal" in jauspy("teleop", "101", status=1).stderr


class Terminal:
    """`jauspy teleop` on a pseudo-terminal."""

    def __init__(self, *arguments: str) -> None:
        self._end, other = pty.openpty()
        os.set_blocking(self._end, False)
        self.process = subprocess.Popen([*JAUSPY, "teleop", *arguments], stdin=other, stdout=other, stderr=other)
        os.close(other)
        self.text = ""

    def press(self, text: str) -> None:
        os.write(self._end, text.encode())

    def read(self) -> str:
        with suppress(OSError):  # nothing to read, or the process has ended
            self.text += os.read(self._end, 65536).decode(errors="replace")
        return self.text

    def close(self) -> None:
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        os.close(self._end)


@pytest.mark.slow
async def test_keys_drive_the_robot_and_it_stops_without_them(node_manager, robot):
    terminal = Terminal("101", "--connect", node_manager.local, "--speed", "0.3")
    try:
        await until(lambda: "READY" in terminal.read(), within=30)
        assert "gamepad" not in terminal.text
        end = time.monotonic() + 1.5
        while time.monotonic() < end:
            terminal.press("w")
            await asyncio.sleep(0.1)
        assert robot.snapshot.twist.vx == pytest.approx(0.3, abs=0.1)
        await until(lambda: abs(robot.snapshot.twist.vx) < 0.01, within=HOLD + 2.0)
        await until(lambda: re.search(r"x \+0\.[1-9]\d y [+-]0\.00 m yaw [+-]0°  READY", terminal.read()))
        terminal.press("+")
        await until(lambda: "speed 0.38 m/s 0.75 rad/s" in terminal.read())
        terminal.press("x")
        assert await asyncio.to_thread(terminal.process.wait, 10) == 0
        assert "the robot is in Standby, and control is released" in terminal.read()
    finally:
        terminal.close()


@pytest.mark.slow
async def test_lost_control_ends_teleop_with_the_reason(node_manager, robot, ocu):
    terminal = Terminal("101", "--connect", node_manager.local)
    try:
        await until(lambda: "READY" in terminal.read(), within=30)
        async with (await ocu.robot(101)).control("drive", authority=200):
            assert await asyncio.to_thread(terminal.process.wait, 10) == 1
        assert "42.1.1" in terminal.read()
    finally:
        terminal.close()
