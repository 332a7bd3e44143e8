"""A wire between two ends in this process, in place of a CAN bus: the robot's, and that of simulated drives."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from typing import cast

import can
import canopen


class PeriodicTask:
    """What python-can's `send_periodic` returns, for a `Port`."""

    def __init__(self, port: Port, message: can.Message, period: float, start: float) -> None:
        self.message = message
        self.period = period
        self.due = start
        self._port = port

    def stop(self) -> None:
        """End it."""
        self._port.periodic.discard(self)

    def modify_data(self, message: can.Message) -> None:
        """Send other bytes from now on."""
        self.message = message


class Port:
    """A bus as `canopen.Network` uses it, whose periodic messages are sent by `step`, without a thread."""

    def network(self) -> canopen.Network:
        """The network on it. canopen asks for a bus of python-can, and uses no more of it than a port has."""
        return canopen.Network(cast("can.BusABC", self))

    channel_info = "port"

    def __init__(self, send: Callable[[can.Message], None]) -> None:
        self._send = send
        self._now = 0.0
        self.periodic: set[PeriodicTask] = set()

    def send(self, message: can.Message, timeout: float | None = None) -> None:  # noqa: ARG002 - never blocks
        """Send a frame."""
        self._send(message)

    def send_periodic(self, message: can.Message, period: float) -> PeriodicTask:
        """Send a frame each `period` seconds, from the next `step` on."""
        task = PeriodicTask(self, message, period, self._now)
        self.periodic.add(task)
        return task

    def step(self, now: float) -> None:
        """Send what is due."""
        self._now = now
        for task in sorted(self.periodic, key=lambda task: task.message.arbitration_id):
            if now >= task.due:
                task.due = max(task.due + task.period, now)
                self._send(task.message)

    def shutdown(self) -> None:
        """End periodic messages."""
        self.periodic.clear()


class Wire:
    """Two ends in one process: what one sends, the other has received when `send` returns.

    Frames that are sent meanwhile wait for their turn, as on a bus. `loses` may drop frames, for tests.
    """

    def __init__(self) -> None:
        self.near = Port(lambda message: self._transmit(message, near=True))
        self.far = Port(lambda message: self._transmit(message, near=False))
        self.near_receives: Callable[[can.Message], None] = lambda _message: None
        self.far_receives: Callable[[can.Message], None] = lambda _message: None
        self.loses: Callable[[can.Message], bool] = lambda _message: False
        self.watch: Callable[[can.Message, bool], None] | None = None
        self._waiting: deque[tuple[can.Message, bool]] = deque()
        self._busy = False

    def _transmit(self, message: can.Message, *, near: bool) -> None:
        self._waiting.append((message, near))
        if self._busy:
            return
        self._busy = True
        try:
            while self._waiting:
                each, from_near = self._waiting.popleft()
                if self.watch is not None:
                    self.watch(each, from_near)
                if not self.loses(each):
                    (self.far_receives if from_near else self.near_receives)(each)
        finally:
            self._busy = False
