"""Lets any robot live in real time: one thread owns it, everybody else talks to that thread."""

from __future__ import annotations

import math
import threading
import time
from collections import Counter
from collections.abc import Callable, Mapping
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass
from types import TracebackType
from typing import Final, Self

from jauspy.modules.pace import Pace
from jauspy.platform.contract import Acceleration, Pose, Robot, Twist

STEP: Final = 0.01
"""Seconds between two looks at commands and two snapshots of the state."""

PATIENCE: Final = 0.1
"""Seconds that the robot may be late before time is left out."""


@dataclass(frozen=True, slots=True)
class Snapshot:
    """The robot's state at one moment; `time` is the robot's own, in seconds."""

    time: float
    pose: Pose
    twist: Twist
    acceleration: Acceleration


@dataclass(frozen=True, slots=True)
class _Effort:
    linear_x: float
    rotational_z: float


class RealTime:
    """Advances `robot` in real time, in a thread of its own, between `open` and `close`.

    Between the two only that thread touches the robot. Others command `drive` and read `snapshot` at any time: both
    go through a lock that is never held while the robot moves, so an event loop is not held up by physics.

    `lapse`: seconds after which the drive is stopped unless somebody calls `alive`, so that a program that hangs does
    not leave a robot driving; endless when not given.
    """

    def __init__(
        self,
        robot: Robot,
        *,
        step: float = STEP,
        patience: float = PATIENCE,
        lapse: float = math.inf,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self._robot = robot
        self._step = step
        self._patience = patience
        self._lapse = lapse
        self._clock = clock
        self._alive = clock()
        self._lock = threading.Lock()
        self._command: _Effort | None = None
        self._snapshot = self._look()
        self._ending = threading.Event()
        self._executor: ThreadPoolExecutor | None = None
        self._ended: Future[None] = Future()
        self._pace = Pace(step, patience, start=clock())
        self._drive = SharedDrive(self)

    @property
    def drive(self) -> SharedDrive:
        """The robot's chassis, for any thread."""
        return self._drive

    @property
    def snapshot(self) -> Snapshot:
        """The state after the last step."""
        with self._lock:
            return self._snapshot

    @property
    def counters(self) -> Mapping[str, int]:
        """`steps` made; those `late`; those `skipped` as too late; those `abandoned`, made after a `lapse`."""
        return Counter(self._pace.counters)

    @property
    def ended(self) -> Future[None]:
        """Done when the thread is: with None after `close`, with the error when the robot raised one."""
        return self._ended

    def command(self, linear_x: float, rotational_z: float) -> None:
        """Efforts (-1..1) that the next step starts with; a later command replaces an earlier one."""
        with self._lock:
            self._command = _Effort(linear_x, rotational_z)

    def alive(self) -> None:
        """Who commands the robot is still there."""
        self._alive = self._clock()

    def open(self) -> None:
        """Start the thread; twice is fine."""
        if self._executor is None:
            self.alive()
            self._pace = Pace(self._step, self._patience, start=self._clock())
            self._executor = ThreadPoolExecutor(1, thread_name_prefix="robot")
            self._ended = self._executor.submit(self._live)

    def close(self) -> None:
        """Stop the robot and end the thread; the robot itself stays open. Twice is fine."""
        self._ending.set()
        if self._executor is not None:
            self._executor.shutdown()

    def __enter__(self) -> Self:
        self.open()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    # --- in the thread --------------------------------------------------------------------------------------------

    def _live(self) -> None:
        try:
            while not self._ending.wait(self._pace.wait(self._clock())):
                self._pace.begin(self._clock())
                self._make_step()
        finally:
            self._robot.drive.stop()

    def _make_step(self) -> None:
        with self._lock:
            command, self._command = self._command, None
        if command is not None:
            self._robot.drive.set_effort(command.linear_x, command.rotational_z)
        if self._clock() - self._alive > self._lapse:
            self._robot.drive.stop()
            self._pace.counters["abandoned"] += 1
        self._robot.advance(self._step)
        snapshot = self._look()
        with self._lock:
            self._snapshot = snapshot

    def _look(self) -> Snapshot:
        drive = self._robot.drive
        return Snapshot(self._robot.time, drive.pose(), drive.twist(), drive.acceleration())


class SharedDrive:
    """A `DriveBase` for all threads: commands act with the next step, states are those after the last one."""

    def __init__(self, runner: RealTime) -> None:
        self._runner = runner

    def set_effort(self, linear_x: float, rotational_z: float) -> None:
        """Drive with fractions of the full effort, -1..1; positive z turns left."""
        self._runner.command(linear_x, rotational_z)

    def stop(self) -> None:
        """Brake to a standstill."""
        self._runner.command(0.0, 0.0)

    def pose(self) -> Pose:
        """Pose of the base in the world."""
        return self._runner.snapshot.pose

    def twist(self) -> Twist:
        """Velocity of the base in its own frame."""
        return self._runner.snapshot.twist

    def acceleration(self) -> Acceleration:
        """Acceleration of the base in its own frame."""
        return self._runner.snapshot.acceleration
