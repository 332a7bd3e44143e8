"""Runs a robot in real time: one thread owns it; other threads send commands and read snapshots."""

from __future__ import annotations

import math
import threading
import time
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Future, ThreadPoolExecutor, wait
from contextlib import AbstractContextManager, nullcontext
from functools import partial
from types import TracebackType
from typing import Final, Self

from jauspy.backends import state_problem
from jauspy.errors import ConfigError
from jauspy.geometry.poses import Acceleration, Pose, Twist
from jauspy.logs import get_logger
from jauspy.platform.camera import CameraSource
from jauspy.platform.commands import CHASSIS, DriveEffort, DriveStop, JointTargets, LidarSettings
from jauspy.platform.contract import Command, OptionalPart, PartId, Robot, RobotLink, SharesWorld, Snapshot
from jauspy.platform.force_torque import ForceTorqueSensor, Wrench
from jauspy.platform.joints import JointGroup, JointState, Target
from jauspy.platform.ranging import RangeFinder, RangeScan, ScanSettings


class DriveProxy:
    """The `DriveBase` of a robot in another thread."""

    def __init__(self, link: RobotLink) -> None:
        self._link = link

    def set_effort(self, linear_x: float, rotational_z: float, linear_y: float = 0.0) -> None:
        """Drive with fractions of the full effort, -1..1; positive z turns left, positive y is left."""
        self._link.submit(DriveEffort(linear_x, rotational_z, linear_y))

    def stop(self) -> None:
        """Brake to a standstill."""
        self._link.submit(DriveStop())

    def pose(self) -> Pose:
        """Pose of the base in the world."""
        return self._link.snapshot.pose

    def twist(self) -> Twist:
        """Velocity of the base in its own frame."""
        return self._link.snapshot.twist

    def acceleration(self) -> Acceleration:
        """Acceleration of the base in its own frame."""
        return self._link.snapshot.acceleration


class JointGroupProxy:
    """A `JointGroup` of a robot in another thread."""

    def __init__(self, name: str, group: JointGroup, link: RobotLink) -> None:
        self._name = name
        self.joints = group.joints
        """The joints that move, base to tip."""
        self.chain = group.chain
        """All joints from base to tip, fixed ones included."""
        self._link = link

    def command(self, targets: Sequence[Target | None]) -> None:
        """Set the targets of the joints, base to tip; None keeps a joint's target."""
        if len(targets) != len(self.joints):
            raise ValueError(f"{len(targets)} targets for the {len(self.joints)} joints of {self._name!r}")
        self._link.submit(JointTargets(self._name, tuple(targets)))

    def hold(self) -> None:
        """Stop, and hold the present positions."""
        self._link.submit(JointTargets(self._name, (None,) * len(self.joints), hold=True))

    def state(self) -> JointState:
        """Positions, velocities and efforts after the last step."""
        return self._link.snapshot.joints[self._name]


class LidarProxy:
    """A `RangeFinder` of a robot in another thread."""

    def __init__(self, name: str, lidar: RangeFinder, link: RobotLink) -> None:
        self._name = name
        self.setup = lidar.setup
        """Link, rate and limits."""
        self._settings = lidar.settings
        self._link = link

    @property
    def settings(self) -> ScanSettings:
        """The settings that were last commanded."""
        return self._settings

    def configure(self, settings: ScanSettings) -> None:
        """Measure with these settings from the next scan on."""
        self._settings = settings
        self._link.submit(LidarSettings(self._name, settings))

    @property
    def scan(self) -> RangeScan | None:
        """The last scan; None while it is not active."""
        return self._link.snapshot.scans[self._name]

    @property
    def age(self) -> float:
        """Seconds since the last scan; 0 without one."""
        snapshot = self._link.snapshot
        scan = snapshot.scans[self._name]
        return snapshot.time - scan.time if scan else 0.0


class ForceTorqueProxy:
    """A `ForceTorqueSensor` of a robot in another thread."""

    def __init__(self, name: str, sensor: ForceTorqueSensor, link: RobotLink) -> None:
        self._name = name
        self.setup = sensor.setup
        """Link, rate and limits."""
        self._link = link

    @property
    def wrench(self) -> Wrench:
        """The last measurement."""
        return self._link.snapshot.wrenches[self._name]


_LOG: Final = get_logger("jauspy.robot")

STEP: Final = 0.002
"""Seconds of one step, and so the longest delay of a command; the same as MuJoCo's step."""

MAX_STEP: Final = 0.05
"""Seconds of the longest step: half of the time that a robot may fall behind the clock."""

MAX_DELAY: Final = 0.1
"""Seconds that the robot may fall behind the clock before missed steps are skipped."""

SLOW_STEP: Final = 0.15
"""Seconds; a step that takes longer causes a warning."""
WARNING_INTERVAL: Final = 10.0
"""Seconds between two warnings."""

STALL_TIME: Final = 3.0
"""Seconds without a step, while the program runs, after which a robot that does not advance is a fault."""
RECOVERY_TIME: Final = 30.0
"""The same for a step that enables the motors, or uses failed parts again: drives may have to be configured."""
LONGEST_BEAT: Final = 0.5
"""Seconds between two heartbeats that count at most: a program that was held up has not watched its robot meanwhile."""
CLOSING_TIME: Final = 5.0
"""Seconds after which the log says that the robot cannot be closed because its thread does not end."""

WHOLE_ROBOT: Final = PartId(Robot)
"""The key in `RealTime.faults` for a failure of the robot as a whole."""


class StepTimer:
    """Schedules steps of `step` seconds.

    A step that starts more than one `step` after its time is counted as `late`. When the delay exceeds `max_delay`
    seconds, the missed steps are counted as `skipped` and omitted: the robot's time pauses instead of catching up.
    """

    def __init__(self, step: float, max_delay: float, *, start: float) -> None:
        self.step = step
        self.max_delay = max_delay
        self.counters: Counter[str] = Counter(steps=0, late=0, slow=0, skipped=0, abandoned=0, faults=0)
        self.restart(start)

    def restart(self, now: float) -> None:
        """Let the next step be due one step from now; those in between are not counted."""
        self._due = now + self.step

    def wait(self, now: float) -> float:
        """Seconds until the next step is due, at most one step; 0 if it is due or late."""
        return min(self.step, max(0.0, self._due - now))

    def begin(self, now: float) -> None:
        """Count a step that starts now."""
        delay = now - self._due
        if delay < -self.step:  # the clock was set back
            self._due = now
        if delay > self.step:
            self.counters["late"] += 1
        if delay > self.max_delay:
            missed = int(delay / self.step)
            self.counters["skipped"] += missed
            self._due += missed * self.step
        self.counters["steps"] += 1
        self._due += self.step


class RealTime:
    """Advances `robot` in real time, in a thread of its own, between `open` and `close`; a `RobotLink` to it.

    Between the two only that thread uses the robot; one that shares its world with others is used under the lock of the
    world. Other threads use `drive`, `groups` and the other proxies, or `submit` and `snapshot`, at any time: they
    share a lock that is never held while the robot advances, so physics never blocks an event loop.

    `heartbeat_timeout`: seconds without a call of `alive` after which the robot is stopped, so that the robot does not
    go on driving when the program hangs; infinite by default.

    An exception of the robot never ends the thread: it is logged, everything is stopped, and `faults` names the part
    that the command was for, or `WHOLE_ROBOT` when the robot cannot advance. Failed parts get no commands, and a robot
    that cannot advance stands still, until `retry`.

    The thread and the program watch each other: `alive` notices when no step ends for `STALL_TIME` (`RECOVERY_TIME`
    after `enable` and `retry`), which is a fault of the robot as a whole, too. If the thread ends before `close`, that
    fault stays.
    """

    def __init__(
        self,
        robot: Robot,
        *,
        step: float = STEP,
        max_delay: float = MAX_DELAY,
        heartbeat_timeout: float = math.inf,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self._robot = robot
        self._world: AbstractContextManager[object] = (
            robot.world_lock if isinstance(robot, SharesWorld) else nullcontext()
        )
        self._step = step
        self._max_delay = max_delay
        self._heartbeat_timeout = heartbeat_timeout
        self._clock = clock
        self._alive = clock()
        self._lock = threading.Lock()
        self._pending: dict[PartId, Command] = {}
        self._faults: Mapping[PartId, str] = {}
        self._retried: set[PartId] = set()
        self._enabling: tuple[Callable[[], None], Future[None]] | None = None
        self._warned_at = -math.inf
        self._abandoned = False
        self._ended_early = self._is_starting = False
        self._steps_ended = self._steps_seen = 0
        self._stood, self._patience = 0.0, STALL_TIME
        self._is_to_stop = False
        with self._world:
            self._snapshot = Snapshot.of(robot)
        self._closing = threading.Event()
        self._executor: ThreadPoolExecutor | None = None
        self._ended: Future[None] = Future()
        self._timer = StepTimer(step, max_delay, start=clock())
        self.drive = DriveProxy(self)
        """The robot's chassis, for any thread, as are the parts that follow."""
        self.groups: Mapping[str, JointGroupProxy] = {
            name: JointGroupProxy(name, group, self) for name, group in robot.groups.items()
        }
        """The robot's other joints, by name."""
        self.lidars: Mapping[str, LidarProxy] = {
            name: LidarProxy(name, lidar, self) for name, lidar in robot.lidars.items()
        }
        """The robot's lidars, by name."""
        self.force_torque: Mapping[str, ForceTorqueProxy] = {
            name: ForceTorqueProxy(name, sensor, self) for name, sensor in robot.force_torque.items()
        }
        """The robot's sensors of force and torque, by name."""
        self.optional_parts: Sequence[OptionalPart] = tuple(part.proxy(self) for part in robot.optional_parts)
        """The robot's optional parts."""

    @property
    def cameras(self) -> Mapping[str, CameraSource]:
        """The robot's cameras, for other processes."""
        return self._robot.cameras

    @property
    def snapshot(self) -> Snapshot:
        """The state after the last step."""
        with self._lock:
            return self._snapshot

    @property
    def counters(self) -> Mapping[str, int]:
        """Numbers of `steps`, of `late`, `slow` and `skipped` ones, of `abandoned` ones, and of `faults`."""
        return Counter(self._timer.counters)

    @property
    def faults(self) -> Mapping[PartId, str]:
        """The parts that have failed, and why; a new mapping after each change."""
        return self._faults

    def retry(self, part: PartId) -> None:
        """Use a failed part again: it is stopped first, and fails again if that raises an exception.

        Without effect when the thread has ended early.
        """
        with self._lock:
            if self._ended_early:
                return
            self._faults = {fault: why for fault, why in self._faults.items() if fault != part}
            self._retried.add(part)

    @property
    def ended(self) -> Future[None]:
        """Done when the thread is: with None after `close`."""
        return self._ended

    def submit(self, command: Command) -> None:
        """Queue a command for the next step; it is merged with a pending one to the same part."""
        with self._lock:
            pending = self._pending.pop(command.part, None)  # the order of application is that of the last commands
            self._pending[command.part] = command if pending is None else command.merged(pending)

    def enable(self, enable: Callable[[], None]) -> Future[None]:
        """Have the thread call `enable`, which enables the robot's motors and may take seconds, before its next step.

        The result is done after that step. A `ConfigError` is that of the result; any other exception of `enable`
        is a failure of the robot as a whole.
        """
        done = Future[None]()
        with self._lock:
            self._enabling = enable, done
        return done

    def alive(self, *, is_starting: bool = False) -> None:
        """The heartbeat: to be called regularly by the program that commands the robot.

        Over several calls it notices a robot that does not advance; that is logged, and a fault. The pauses of a
        program that `is_starting`, and commands nothing yet, are not logged.
        """
        self._is_starting = is_starting
        now = self._clock()
        beat, self._alive = min(now - self._alive, LONGEST_BEAT), now
        if self._steps_ended != self._steps_seen:
            if self._stood >= STALL_TIME and WHOLE_ROBOT in self._faults:
                _LOG.warning("the robot's thread steps again, after more than %.1f s", self._stood)
            self._steps_seen, self._stood = self._steps_ended, 0.0
            return
        self._stood += beat
        if self._stood >= self._patience and self._is_open and WHOLE_ROBOT not in self._faults:
            self._fail(WHOLE_ROBOT, f"no step has ended for {self._patience:g} s: the backend or its thread hangs")
            self._is_to_stop = True

    def end_early(self, what: str, error: BaseException | None) -> None:
        """Report that nobody steps or watches the robot any more before it was closed: a fault that stays.

        `error` ended `what`; None if it was cancelled.
        """
        how = "it was cancelled" if error is None else _named(error)
        why = f"{what} has ended: {how}"
        with self._lock:
            self._ended_early = self._is_to_stop = True
            self._faults = {**self._faults, WHOLE_ROBOT: why}
        self._timer.counters["faults"] += 1
        _LOG.error("%s failed: %s", described(WHOLE_ROBOT), why, exc_info=error)

    @property
    def ended_early(self) -> bool:
        """True if nobody steps or watches the robot any more, so that `retry` has no effect."""
        return self._ended_early

    @property
    def _is_open(self) -> bool:
        """True between `open` and `close`."""
        return self._executor is not None and not self._closing.is_set()

    def open(self) -> None:
        """Start the thread. May be called twice."""
        if self._executor is None:
            self.alive(is_starting=True)
            self._timer = StepTimer(self._step, self._max_delay, start=self._clock())
            self._executor = ThreadPoolExecutor(1, thread_name_prefix="robot")
            self._ended = self._executor.submit(self._run)

    def close(self) -> None:
        """Stop the robot and end the thread; the robot itself stays open. May be called twice."""
        self._closing.set()
        if self._executor is not None:
            wait({self._ended}, CLOSING_TIME)
            if not self._ended.done():
                _LOG.error(
                    "the robot cannot be closed: its thread has not ended for %g s, and is waited for", CLOSING_TIME
                )
            self._executor.shutdown()

    def __enter__(self) -> Self:
        self.open()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    # --- in the thread --------------------------------------------------------------------------------------------

    def _run(self) -> None:
        try:
            while not self._closing.wait(self._timer.wait(self._clock())):
                self._timer.begin(self._clock())
                try:
                    self._make_step()
                except BaseException as error:  # noqa: BLE001 - SystemExit, or the panic of an extension
                    self._fail(WHOLE_ROBOT, error)
                    self._stop_all()
        except BaseException as error:
            self.end_early("its thread", error)
            raise
        finally:
            self._stop_all()
            if self._enabling is not None:
                self._enabling[1].cancel()

    def _make_step(self) -> None:
        with self._world:
            self._step_in_world()

    def _step_in_world(self) -> None:
        with self._lock:
            commands, self._pending = self._pending, {}
            retried, self._retried = self._retried, set()
            enabling, self._enabling = self._enabling, None
        self._patience = RECOVERY_TIME if retried or enabling is not None else STALL_TIME
        if enabling is not None and not enabling[1].set_running_or_notify_cancel():
            enabling = None
        refused = None if enabling is None else self._enable(*enabling)
        began = self._clock()
        for part in retried:
            self._try(part, partial(_stop_part, self._robot, part))
        for command in commands.values():
            if self._is_usable(command.part):
                self._try(command.part, partial(command.apply, self._robot))
        if self._is_to_stop:
            self._is_to_stop = False
            self._stop_all()
        self._stop_if_abandoned()
        if self._is_usable(WHOLE_ROBOT):
            self._try(WHOLE_ROBOT, self._advance)
        if (duration := self._clock() - began) > SLOW_STEP:
            self._timer.counters["slow"] += 1
            self._warn(f"a step of the robot took {duration:.2f} s; it should take less than {self._step:g} s")
        if enabling is not None and refused is not None:
            enabling[1].set_exception(refused)
        elif enabling is not None:
            enabling[1].set_result(None)
        self._steps_ended += 1

    def _is_usable(self, part: PartId) -> bool:
        """True unless it has failed, or waits since a `retry` during this step until the next one stops it first."""
        with self._lock:
            return part not in self._faults and part not in self._retried

    def _enable(self, enable: Callable[[], None], done: Future[None]) -> ConfigError | None:
        """Enable the motors; return the error of a robot that cannot be used."""
        try:
            enable()
        except ConfigError as error:
            with self._lock:
                self._faults = {WHOLE_ROBOT: str(error)}  # without power it is not advanced until it is closed
            return error
        except Exception as error:  # noqa: BLE001 - whatever a backend raises
            self._fail(WHOLE_ROBOT, error)
            self._stop_all()
        except BaseException as error:
            done.set_exception(error)
            raise
        self._timer.restart(self._clock())
        return None

    def _advance(self) -> None:
        self._robot.advance(self._step)
        snapshot = Snapshot.of(self._robot)
        if problem := state_problem(snapshot, self._robot):
            raise ValueError(problem)
        with self._lock:
            self._snapshot = snapshot

    def _try(self, part: PartId, action: Callable[[], None]) -> None:
        """Call the robot; an exception is a fault of the part, which stops all others, too."""
        try:
            action()
        except Exception as error:  # noqa: BLE001 - whatever a backend raises
            self._fail(part, error)
            self._stop_all()

    def _fail(self, part: PartId, error: BaseException | str) -> None:
        why = error if isinstance(error, str) else _named(error)
        if self._faults.get(part) != why:
            _LOG.error("%s failed: %s", described(part), why)
            if isinstance(error, BaseException):
                _LOG.debug("%s failed", described(part), exc_info=error)
        self._timer.counters["faults"] += 1
        with self._lock:
            self._faults = {**self._faults, part: why}

    def _stop_all(self) -> None:
        """Stop each part, whether or not others can be stopped."""
        joints = (PartId(JointGroup, name) for name in self.groups)
        for part in (CHASSIS, *joints, *(optional_part.id for optional_part in self.optional_parts)):
            try:
                with self._world:
                    _stop_part(self._robot, part)
            except Exception as error:  # noqa: BLE001 - whatever a backend raises
                self._fail(part, error)

    def _stop_if_abandoned(self) -> None:
        abandoned = self._clock() - self._alive > self._heartbeat_timeout
        if abandoned:
            self._timer.counters["abandoned"] += 1
            self._try(CHASSIS, self._robot.drive.stop)
            if not self._abandoned:  # repeated holds would follow joints that sag
                if not self._is_starting:
                    _LOG.error("the program has not run for %g s: the robot is stopped", self._heartbeat_timeout)
                self._stop_all()
        self._abandoned = abandoned

    def _warn(self, text: str) -> None:
        now = self._clock()
        if now - self._warned_at > WARNING_INTERVAL:
            self._warned_at = now
            _LOG.warning("%s", text)


def described(part: PartId) -> str:
    """A description of the part, as in `the chassis` or `the joints 'arm'`."""
    if part == WHOLE_ROBOT:
        return "the robot"
    kind = {CHASSIS.kind: "chassis", JointGroup: "joints"}.get(part.kind, part.kind.__name__)
    return f"the {kind} {part.name!r}" if part.name else f"the {kind}"


def _named(error: BaseException) -> str:
    return f"{type(error).__name__}: {error}"


def _stop_part(robot: Robot, part: PartId) -> None:
    if part == CHASSIS:
        robot.drive.stop()
    elif part.kind is JointGroup:
        robot.groups[part.name].hold()
    for optional_part in robot.optional_parts:
        if optional_part.id == part:
            optional_part.stop()
