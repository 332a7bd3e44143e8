"""The thread that runs the cycles of a real bus: errors do not end it, and its end is not silent."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from types import SimpleNamespace
from typing import Any

import can
import pytest

pytest.importorskip("canopen", reason="canopen is not installed")

from tests.backends.can.conftest import setup_of

from jauspy.backends.can import bus as bus_module
from jauspy.backends.can.faults import DriveFault
from jauspy.backends.can.robot import _Clocked

Opened = Callable[..., tuple[_Clocked, list[str]]]


@pytest.fixture
def opened(monkeypatch: pytest.MonkeyPatch) -> Iterator[Opened]:
    """Opens a bus in memory with these functions of master and robot; returns also what failures of the bus it told."""
    monkeypatch.setattr(bus_module, "open_bus", lambda *_: can.Bus("cycles", interface="virtual"))
    buses: list[_Clocked] = []

    def open_one(**functions: Callable[..., Any]) -> tuple[_Clocked, list[str]]:
        failures: list[str] = []
        nothing: Callable[..., None] = lambda *_: None  # noqa: E731 - typed
        master: Any = SimpleNamespace(
            inbox=SimpleNamespace(receive=nothing),
            bus_failed=failures.append,
            cycle=functions.get("cycle", nothing),
            hold_all=functions.get("hold_all", nothing),
        )
        bus = _Clocked(setup_of(), "socketcan:can0")
        buses.append(bus)
        bus.start(master, functions.get("tick", nothing))
        return bus, failures

    yield open_one
    for bus in buses:
        bus.close()


class Failing:
    """A function that fails the first time."""

    def __init__(self) -> None:
        self.calls = 0
        self.again = threading.Event()

    def __call__(self, *_: object) -> None:
        self.calls += 1
        if self.calls == 1:
            raise ValueError("a defect")
        self.again.set()


@pytest.mark.parametrize("name", ["cycle", "tick", "hold_all"])
def test_an_error_in_a_cycle_is_a_failure_of_the_bus_and_the_cycles_go_on(
    opened: Opened, name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("jauspy.backends.can.robot.ROBOT_TIMEOUT", 0.0)
    failing = Failing()
    bus, failures = opened(**{name: failing})
    bus.advance(0.002)  # from now on the robot's thread counts as hanging
    assert failing.again.wait(20.0)
    assert failures == ["ValueError: a defect"]


@pytest.mark.filterwarnings("ignore::pytest.PytestUnhandledThreadExceptionWarning")
def test_a_thread_that_has_ended_is_a_failure_of_the_robot(opened: Opened) -> None:
    ended = threading.Event()

    def end(_now: float) -> None:
        ended.set()
        raise SystemExit

    bus, _ = opened(cycle=end)
    assert ended.wait(20.0)
    assert bus._thread is not None
    bus._thread.join(20.0)
    with pytest.raises(DriveFault, match="the thread of the CAN bus has ended, and drives get no commands"):
        bus.advance(0.002)
