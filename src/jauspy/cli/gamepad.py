"""A gamepad as a source of driving commands, by evdev (Linux, extra `teleop`)."""

from __future__ import annotations

import asyncio
import importlib
from collections.abc import Callable
from importlib.util import find_spec
from typing import Any, Final

from jauspy.errors import ConfigError

DEAD_ZONE: Final = 0.1
"""Share of the way of a stick that counts as its middle."""
EV_KEY, EV_ABS = 0x01, 0x03
BTN_GAMEPAD, BTN_TL, BTN_TR = 0x130, 0x136, 0x137
"""Linux' numbers (input-event-codes.h): the first button of gamepads, and the shoulders, which are the dead-man."""
ABS_X, ABS_Y, ABS_RX = 0x00, 0x01, 0x03


def is_installed() -> bool:
    """True when the package evdev is."""
    return find_spec("evdev") is not None


def find(path: str | None) -> Any | None:
    """The gamepad at `path`, or the first one; None without one. Raises `ConfigError` when `path` is none."""
    if not is_installed():
        if path is not None:
            raise ConfigError("a gamepad needs evdev: pip install 'jauspy[teleop]'")
        return None
    evdev: Any = importlib.import_module("evdev")
    for each in [path] if path is not None else evdev.list_devices():
        try:
            device = evdev.InputDevice(each)
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
        """Read it from now on."""
        asyncio.get_running_loop().add_reader(self._device.fd, self._read)

    def close(self) -> None:
        """Read no more; twice is fine."""
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
