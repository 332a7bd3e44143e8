"""`jauspy teleop`: drive a robot with the keys of a terminal, or with a gamepad."""

from __future__ import annotations

import asyncio
import importlib
import math
import os
import sys
import termios
import tty
from collections.abc import AsyncIterator, Callable, Iterator
from contextlib import asynccontextmanager, contextmanager, suppress
from dataclasses import dataclass
from importlib.util import find_spec
from typing import Annotated, Any, Final

import typer

from jauspy.cli import client, console
from jauspy.cli.options import Connect, OperatorKey, OwnId, Timeout
from jauspy.cli.processes import run
from jauspy.errors import ConfigError, ResponseTimeout
from jauspy.ocu import OCU, Robot, RobotControl, RobotPose

DEAD_ZONE: Final = 0.1
"""Deflection of a stick, as a share of the full one, below which it counts as centred."""
EV_KEY, EV_ABS = 0x01, 0x03
BTN_GAMEPAD, BTN_TL, BTN_TR = 0x130, 0x136, 0x137
"""Linux' numbers (input-event-codes.h): the first button of gamepads, and the shoulder buttons, which are the
dead-man's switch."""
ABS_X, ABS_Y, ABS_RX = 0x00, 0x01, 0x03
HOLD: Final = 0.7
"""Seconds of motion for one key: terminals do not report its release, and repeat it only after half a second."""
PERIOD: Final = 0.05
"""Seconds between two commands."""
LOOK_PERIOD: Final = 0.2
"""Seconds between two queries for pose and state."""
STEP: Final = 1.25
"""Factor between two speeds."""
MIN_SPEED: Final = 0.02
"""m/s and rad/s."""

MOTIONS: Final = {
    "w": (1.0, 0.0),
    "s": (-1.0, 0.0),
    "a": (0.0, 1.0),
    "d": (0.0, -1.0),
    "q": (1.0, 0.5),
    "e": (1.0, -0.5),
    "\x1b[A": (1.0, 0.0),
    "\x1b[B": (-1.0, 0.0),
    "\x1b[D": (0.0, 1.0),
    "\x1b[C": (0.0, -1.0),
}
"""Keys, and the shares of the speeds forward and to the left. The last four are the arrows."""
HELP: Final = (
    "w/s or up/down: forward, back    a/d or left/right: turn    q/e: forward and turn    space: stop",
    "+/-: speed    x or Ctrl-C: end    The robot drives while a key is held.",
)


def teleop(
    *,
    robot: Annotated[int, typer.Argument(metavar="ROBOT", min=1, max=65534, help="The robot's subsystem id.")],
    speed: Annotated[float, typer.Option("--speed", min=MIN_SPEED, metavar="M/S", help="Speed at first.")] = 0.4,
    turn_rate: Annotated[
        float, typer.Option("--turn-rate", min=MIN_SPEED, metavar="RAD/S", help="Angular velocity at first.")
    ] = 0.6,
    pad: Annotated[
        str | None,
        typer.Option("--gamepad", metavar="DEVICE", help="As in /dev/input/event5. Default: the first one, if any."),
    ] = None,
    retrotraverse: Annotated[
        float | None,
        typer.Option(
            "--retrotraverse", min=0.01, max=1e6, metavar="METRES", help="Drive so far back when the link is lost."
        ),
    ] = None,
    authority: Annotated[
        int, typer.Option("--authority", min=0, max=255, help="Authority with which control is taken.")
    ] = 127,
    connect: Connect = None,
    own_id: OwnId = None,
    operator_key: OperatorKey = None,
    timeout: Timeout = 5.0,
) -> None:
    """Drive a robot with the keys of the terminal, or with a gamepad.

    Keys: w, a, s, d or the arrows drive while they are held, q and e drive curves, space stops, + and - change the
    speed, x ends. The robot stops 0.7 s after the last key (dead-man), and when this program, its machine or the
    network fails. With a gamepad (extra 'teleop') the robot drives while a shoulder button is held; the sticks give the
    direction. With --retrotraverse, a robot whose link is lost stops, and then drives back by the way it came until the
    link works again. A line shows pose and state: x forward, y left, yaw to the left.

    Examples:
      jauspy teleop 101
      jauspy teleop 101 --speed 0.2 --connect udp://192.168.1.20
    """
    if not sys.stdin.isatty():
        raise ConfigError("teleop reads keys from a terminal, but standard input is not a terminal")
    device = find_gamepad(pad)
    ocu = client.make_ocu(own_id, connect, timeout, operator=operator_key)
    run(_drive(ocu, robot, Speeds(speed, turn_rate), device, authority=authority, retrotraverse=retrotraverse))


@dataclass(slots=True)
class Speeds:
    """The speeds of full deflection, m/s and rad/s."""

    linear: float
    angular: float

    def scale(self, factor: float, most: tuple[float, float]) -> None:
        """Change both, within the limits of the robot."""
        self.linear = min(most[0], max(MIN_SPEED, self.linear * factor))
        self.angular = min(most[1], max(MIN_SPEED, self.angular * factor))


class Keys:
    """Keys that are pressed; `motion` is the motion of the last one, for `HOLD` seconds. `clock` returns seconds."""

    def __init__(self, clock: Callable[[], float]) -> None:
        self.ended = False
        self.speed_steps = 0
        """Presses of + less those of -, since they were last handled."""
        self._clock = clock
        self._motion = (0.0, 0.0)
        self._until = -math.inf

    @property
    def motion(self) -> tuple[float, float] | None:
        """Shares of the speeds; None when no key is held."""
        return self._motion if self._clock() < self._until else None

    def take(self, text: str) -> None:
        """Handle what the terminal sent."""
        for key in split(text):
            if key in MOTIONS:
                self._motion, self._until = MOTIONS[key], self._clock() + HOLD
            elif key in {"+", "="}:
                self.speed_steps += 1
            elif key in {"-", "_"}:
                self.speed_steps -= 1
            elif key in {"x", "\x04", ""}:
                self.ended = True
            else:  # space, and any other key
                self._until = -math.inf


def split(text: str) -> Iterator[str]:
    """Single keys; those that send several characters begin with an escape. An empty text is the end of the input."""
    if not text:
        yield ""
    offset = 0
    while offset < len(text):
        size = 3 if text.startswith("\x1b[", offset) else 1
        yield text[offset : offset + size].lower() if size == 1 else text[offset : offset + size]
        offset += size


@contextmanager
def raw_keys(take: Callable[[str], None]) -> Iterator[None]:
    """Call `take` with each key, without Enter and without showing it; the terminal is as before afterwards."""
    descriptor, loop = sys.stdin.fileno(), asyncio.get_running_loop()
    before = termios.tcgetattr(descriptor)

    def read() -> None:
        try:
            text = os.read(descriptor, 256).decode(errors="replace")
        except OSError:  # the terminal is gone
            text = ""
        if not text:
            loop.remove_reader(descriptor)
        take(text)

    tty.setcbreak(descriptor)
    loop.add_reader(descriptor, read)
    try:
        yield
    finally:
        loop.remove_reader(descriptor)
        with suppress(termios.error):
            termios.tcsetattr(descriptor, termios.TCSADRAIN, before)


async def _drive(
    ocu: OCU, number: int, speeds: Speeds, device: object, *, authority: int, retrotraverse: float | None
) -> None:
    async with ocu:
        robot = await ocu.robot(number)
        most = await robot.speed_limits()
        speeds.scale(1.0, most)
        async with robot.control("drive", authority=authority) as control:
            if retrotraverse is not None:
                await robot.comms_lost.set("retrotraverse", distance=retrotraverse)
            await _Session(robot, control, speeds, most).run(device)
    console.print_lines("", "the robot is in Standby, and control is released")


class _Session:
    """One run of teleop: control, commands and the status line."""

    def __init__(self, robot: Robot, control: RobotControl, speeds: Speeds, most: tuple[float, float]) -> None:
        self._robot, self._control, self._speeds, self._most = robot, control, speeds, most
        self._keys = Keys(asyncio.get_running_loop().time)
        self._state = ""
        self._pose: RobotPose | None = None

    async def run(self, device: object) -> None:
        """Drive until the end is asked for; raises `ControlRejected` when control is lost."""
        console.print_lines(f"driving {self._robot.name or 'robot'} {self._robot.id}", *HELP)
        pad = Gamepad(device, console.note) if device is not None else None
        if pad is not None:
            console.print_lines(f"gamepad {pad.name}: hold a shoulder button and move the sticks")
        with raw_keys(self._keys.take):
            async with _opened(pad), self._observed():
                await self._follow(pad)

    async def _follow(self, pad: Gamepad | None) -> None:
        moving = False
        while not self._keys.ended:
            self._control.check()
            steps, self._keys.speed_steps = self._keys.speed_steps, 0
            if steps:
                self._speeds.scale(STEP**steps, self._most)
            motion = self._keys.motion or (pad.motion if pad is not None else None)
            if motion is not None:
                await self._robot.drive(motion[0] * self._speeds.linear, motion[1] * self._speeds.angular)
            elif moving:
                await self._robot.stop()
            moving = motion is not None
            self._show()
            await asyncio.sleep(PERIOD)

    @asynccontextmanager
    async def _observed(self) -> AsyncIterator[None]:
        task = asyncio.create_task(self._observe(), name="teleop")
        try:
            yield
        finally:
            task.cancel()
            await asyncio.wait({task})

    async def _observe(self) -> None:
        """Query pose and state five times a second."""
        management = self._robot.component(self._control.ids[0]).service("Management")
        while True:
            try:
                status = await management.status()
                self._state = getattr(status, "name", str(status))
                with suppress(ConfigError):  # a robot without a pose sensor
                    self._pose = await self._robot.pose()
            except ResponseTimeout:
                self._state = "no answer"
            await asyncio.sleep(LOOK_PERIOD)

    def _show(self) -> None:
        pose = self._pose
        where = "" if pose is None else f"x {pose.x:+.2f} y {pose.y:+.2f} m yaw {math.degrees(pose.yaw):+.0f}°  "
        speeds = f"{self._speeds.linear:.2f} m/s {self._speeds.angular:.2f} rad/s"
        drives = " driving" if self._keys.motion else ""
        sys.stdout.write(f"\r\x1b[K{where}{self._state}{drives}  speed {speeds}")
        sys.stdout.flush()


@asynccontextmanager
async def _opened(pad: Gamepad | None) -> AsyncIterator[None]:
    if pad is None:
        yield
        return
    pad.open()
    try:
        yield
    finally:
        pad.close()


def find_gamepad(path: str | None) -> Any | None:
    """The gamepad at `path`, or the first one; None if there is none.

    Raises `ConfigError` when `path` is not a gamepad.
    """
    if find_spec("evdev") is None:
        if path is not None:
            raise ConfigError("a gamepad needs evdev: pip install 'jauspy[teleop]'")
        return None
    evdev: Any = importlib.import_module("evdev")
    for device_path in [path] if path is not None else evdev.list_devices():
        try:
            device = evdev.InputDevice(device_path)
        except OSError as error:
            if path is not None:
                raise ConfigError(f"the gamepad {path} cannot be opened: {error.strerror}") from error
            continue
        if BTN_GAMEPAD in device.capabilities().get(EV_KEY, ()):
            return device
        device.close()
    if path is not None:
        raise ConfigError(f"{path} is not a gamepad")
    return None


class Gamepad:
    """Sticks and shoulders of a device. While a shoulder is held, `motion` is the left stick forward and to the left.

    The right stick turns, too. `ended` is called when the device is unplugged; then nothing is held.
    """

    def __init__(self, device: Any, ended: Callable[[str], None]) -> None:
        self.name: str = device.name
        self._device = device
        self._ended = ended
        self._ranges = {code: (info.min, info.max) for code, info in device.capabilities().get(EV_ABS, ())}
        self._axes: dict[int, float] = {}
        self._held: set[int] = set()

    @property
    def motion(self) -> tuple[float, float] | None:
        """Shares of the speeds forward and to the left, -1..1; None when no shoulder is held."""
        if not self._held:
            return None
        turn = max((self._axes.get(ABS_X, 0.0), self._axes.get(ABS_RX, 0.0)), key=abs)
        return -self._axes.get(ABS_Y, 0.0), -turn

    def open(self) -> None:
        """Start reading the device."""
        asyncio.get_running_loop().add_reader(self._device.fd, self._read)

    def close(self) -> None:
        """Stop reading; may be called again."""
        device, self._device = self._device, None
        self._held.clear()
        if device is not None:
            asyncio.get_running_loop().remove_reader(device.fd)
            device.close()

    def _read(self) -> None:
        try:
            for event in self._device.read():
                self._take(event.type, event.code, event.value)
        except BlockingIOError:
            return
        except OSError as error:
            self.close()
            self._ended(f"the gamepad {self.name} is gone: {error.strerror}")

    def _take(self, type: int, code: int, value: int) -> None:
        if type == EV_KEY and code in (BTN_TL, BTN_TR):
            (self._held.add if value else self._held.discard)(code)
        elif type == EV_ABS and code in self._ranges:
            low, high = self._ranges[code]
            share = (2.0 * value - low - high) / ((high - low) or 1)
            self._axes[code] = 0.0 if abs(share) < DEAD_ZONE else max(-1.0, min(1.0, share))
