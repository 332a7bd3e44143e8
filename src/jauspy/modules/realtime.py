"""Lets any robot live in real time: one thread owns it, everybody else talks to that thread."""

from __future__ import annotations

import math
import threading
import time
from collections import Counter
from collections.abc import Callable, Mapping
from concurrent.futures import Future, ThreadPoolExecutor
from types import TracebackType
from typing import Final, Self

from jauspy.modules.pace import Pace
from jauspy.modules.shared import Order, SharedDrive, SharedForceTorque, SharedJoints, SharedLidar
from jauspy.modules.snapshot import Snapshot, look
from jauspy.platform.camera import Camera
from jauspy.platform.contract import Robot

STEP: Final = 0.002
"""Seconds between two looks at commands and two snapshots of the state: a command waits this long at most. It is
MuJoCo's step here, too."""

PATIENCE: Final = 0.1
"""Seconds that the robot may be late before time is left out."""


class RealTime:
    """Advances `robot` in real time, in a thread of its own, between `open` and `close`.

    Between the two only that thread touches the robot. Others command `drive` and `groups` and read `snapshot` at any
    time: all go through a lock that is never held while the robot moves, so an event loop is not held up by physics.

    `lapse`: seconds after which the robot is stopped unless somebody calls `alive`, so that a program that hangs does
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
        self._orders: dict[str, Order] = {}
        self._abandoned = False
        self._snapshot = look(robot)
        self._ending = threading.Event()
        self._executor: ThreadPoolExecutor | None = None
        self._ended: Future[None] = Future()
        self._pace = Pace(step, patience, start=clock())
        self._drive = SharedDrive(self.order, self._sight)
        self._groups = {
            name: SharedJoints(name, group, self.order, self._sight) for name, group in robot.groups.items()
        }
        self._lidars = {name: SharedLidar(lidar, self.order, self._sight) for name, lidar in robot.lidars.items()}
        self._force_torque = {name: SharedForceTorque(each, self._sight) for name, each in robot.force_torque.items()}

    @property
    def drive(self) -> SharedDrive:
        """The robot's chassis, for any thread."""
        return self._drive

    @property
    def groups(self) -> Mapping[str, SharedJoints]:
        """The robot's other joints, for any thread."""
        return self._groups

    @property
    def lidars(self) -> Mapping[str, SharedLidar]:
        """The robot's lidars, for any thread."""
        return self._lidars

    @property
    def force_torque(self) -> Mapping[str, SharedForceTorque]:
        """The robot's sensors of force and torque, for any thread."""
        return self._force_torque

    @property
    def cameras(self) -> Mapping[str, Camera]:
        """The robot's cameras, for other processes."""
        return self._robot.cameras

    @property
    def snapshot(self) -> Snapshot:
        """The state after the last step."""
        return self._sight()

    @property
    def counters(self) -> Mapping[str, int]:
        """`steps` made; those `late`; those `skipped` as too late; those `abandoned`, made after a `lapse`."""
        return Counter(self._pace.counters)

    @property
    def ended(self) -> Future[None]:
        """Done when the thread is: with None after `close`, with the error when the robot raised one."""
        return self._ended

    def order(self, key: str, order: Order) -> None:
        """Something that the robot's thread does before its next step, instead of what was ordered as `key` before."""
        with self._lock:
            self._orders[key] = order

    def _sight(self) -> Snapshot:
        with self._lock:
            return self._snapshot

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
            stop(self._robot)

    def _make_step(self) -> None:
        with self._lock:
            orders, self._orders = self._orders, {}
        for order in orders.values():
            order(self._robot)
        self._look_after()
        self._robot.advance(self._step)
        snapshot = look(self._robot)
        with self._lock:
            self._snapshot = snapshot

    def _look_after(self) -> None:
        """Stop the robot when those who command it do not live any more."""
        abandoned = self._clock() - self._alive > self._lapse
        if abandoned:
            self._pace.counters["abandoned"] += 1
            self._robot.drive.stop()
            if not self._abandoned:  # holding again and again would follow joints that sag
                stop(self._robot)
        self._abandoned = abandoned


def stop(robot: Robot) -> None:
    """Brake the chassis, and hold all joints where they are."""
    robot.drive.stop()
    for group in robot.groups.values():
        group.hold()
