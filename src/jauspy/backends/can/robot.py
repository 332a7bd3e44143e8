"""A `Robot` whose joints and tracks are drives on a CAN bus."""

from __future__ import annotations

import math
import threading
import time
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Final

import canopen

from jauspy.backends.can import bus as buses
from jauspy.backends.can.bus import VirtualBus
from jauspy.backends.can.drive import Drive
from jauspy.backends.can.faults import DriveFault
from jauspy.backends.can.master import Master
from jauspy.backends.can.motion import TRACK_ACCELERATION, JointMotion, TrackMotion
from jauspy.backends.can.readings import CanMotors
from jauspy.backends.can.simulated.fleet import DriveFleet, plant_of
from jauspy.backends.kinematic_camera import KinematicCameras
from jauspy.errors import ConfigError
from jauspy.geometry.frames import HoldingEfforts
from jauspy.geometry.poses import Pose, Twist
from jauspy.geometry.urdf import Joint
from jauspy.logs import get_logger
from jauspy.platform.battery import Battery
from jauspy.platform.camera import CameraSource
from jauspy.platform.contacts import Contacts
from jauspy.platform.contract import DriveBase, OptionalPart, Robot, Viewable
from jauspy.platform.description import GroupSetup, RobotModel
from jauspy.platform.drives import SLIP_FACTOR, FixedBase, SkidSteerDrive
from jauspy.platform.force_torque import ForceTorqueSensor
from jauspy.platform.joints import JointState, Target
from jauspy.platform.localization import Localization
from jauspy.platform.ranging import RangeFinder, Scanner
from jauspy.platform.servo_drives import CanSetup

_LOG: Final = get_logger("jauspy.can")

ROBOT_TIMEOUT: Final = 0.25
"""Seconds without `advance` after which the drives stop: the robot's thread hangs."""

TIME_TOLERANCE: Final = 1e-9
"""Seconds of rounding errors in sums of times."""


class CanJoints:
    """A `JointGroup`: one drive for each joint."""

    def __init__(self, model: RobotModel, setup: GroupSetup, drives: Sequence[tuple[Drive, JointMotion]]) -> None:
        self._joints = tuple(model.description.joint(name) for name in setup.joints)
        self._chain = model.description.chain(setup.base, setup.tip)
        self._drives = drives

    @property
    def joints(self) -> tuple[Joint, ...]:
        """The joints that move, base to tip."""
        return self._joints

    @property
    def chain(self) -> tuple[Joint, ...]:
        """All joints from base to tip, fixed ones included."""
        return self._chain

    def command(self, targets: Sequence[Target | None]) -> None:
        """Set the targets of the joints, base to tip; None keeps a joint's target."""
        for (drive, motion), target in zip(self._drives, targets, strict=True):
            if target is not None:
                motion.follow(target, drive)

    def hold(self) -> None:
        """Quick stop; each drive then holds its position."""
        for _, motion in self._drives:
            motion.hold()

    def state(self) -> JointState:
        """The last reports of the drives: radians or metres, rad/s or m/s, N m or N."""
        drives = [drive for drive, _ in self._drives]
        return JointState(
            tuple([drive.position for drive in drives]),
            tuple([drive.velocity for drive in drives]),
            tuple([drive.effort for drive in drives]),
            {drive.joint.name: load for drive in drives if (load := drive.overload) is not None},
        )


class CanTracks(SkidSteerDrive):
    """A `DriveBase` of two drives; its pose is dead reckoning with the encoders of the tracks."""

    def __init__(self, left: tuple[Drive, TrackMotion], right: tuple[Drive, TrackMotion], gauge: float) -> None:
        super().__init__()
        self._left, self._right = left, right
        self._width = SLIP_FACTOR * gauge
        self._x = self._y = self._yaw = 0.0
        self._before: tuple[float, float] | None = None

    def set_track_efforts(self, left: float, right: float) -> None:
        """Fractions of the full speeds, -1..1; zero for both is a quick stop."""
        for (drive, motion), effort in ((self._left, left), (self._right, right)):
            if left or right:
                motion.drive(effort * drive.joint.velocity)
            else:
                motion.hold()

    def pose(self) -> Pose:
        """The pose by the encoders, in metres and radians; the yaw is within -pi..pi."""
        return Pose(x=self._x, y=self._y, yaw=math.remainder(self._yaw, math.tau))

    def twist(self) -> Twist:
        """Forward speed and yaw rate, by the encoders."""
        left, right = self._left[0].velocity, self._right[0].velocity
        return Twist(vx=(left + right) / 2.0, wz=(right - left) / self._width)

    def restart(self) -> None:
        """Continue from the present pose with new encoder counts; a drive that restarted may count from zero."""
        self._before = None

    def update(self) -> None:
        """Add the distances since the last call to the pose."""
        present = self._left[0].position, self._right[0].position
        if self._before is not None:
            left, right = (now - then for now, then in zip(present, self._before, strict=True))
            turn = (right - left) / self._width
            heading = self._yaw + turn / 2.0
            self._x += (left + right) / 2.0 * math.cos(heading)
            self._y += (left + right) / 2.0 * math.sin(heading)
            self._yaw += turn
        self._before = present


class LockedJoints(CanJoints):
    """A group that is commanded while a thread runs the cycles."""

    def __init__(
        self, model: RobotModel, setup: GroupSetup, drives: Sequence[tuple[Drive, JointMotion]], lock: Any
    ) -> None:
        super().__init__(model, setup, drives)
        self._lock = lock

    def command(self, targets: Sequence[Target | None]) -> None:
        """Set the targets between two cycles."""
        with self._lock:
            super().command(targets)

    def hold(self) -> None:
        """Stop between two cycles."""
        with self._lock:
            super().hold()


class CanRobot:
    """A `Robot`. With simulated drives in this process its time is that of `advance`; on a bus it is the clock's.

    `begin` starts the drives: by default they are configured and enabled.
    """

    def __init__(
        self,
        model: RobotModel,
        setup: CanSetup,
        bus: str,
        world: str,
        begin: Callable[[Master], None] = Master.start,
    ) -> None:
        self._model, self._setup = model, setup
        interface, channel, _ = buses.split(bus)
        self._holding = HoldingEfforts(model.description)
        self._weights: Mapping[str, float] | None = None
        self._motions: dict[str, JointMotion | TrackMotion] = {}
        self._drives = {name: self._drive(name) for name in setup.drives}
        self._time = 0.0
        self._failed = False
        self._closed = False
        self._ticker: _Simulated | _Clocked
        if interface == buses.VIRTUAL:
            self._ticker = _Simulated(model, setup, channel, world)
        else:
            self._ticker = _Clocked(setup, bus)
        self.master = Master(
            setup,
            self._drives,
            self._ticker.network,
            clock=self._ticker.clock,
            wait_cycle=self._ticker.wait_cycle,
            echoes=interface in buses.ECHOING,
        )
        self._motors = CanMotors(self.master.readings.readings)
        self._tracked = self._tracks()
        self._drive_base: CanTracks | FixedBase = self._tracked or FixedBase()
        self._groups = {
            name: LockedJoints(model, group, self._pairs(group), self.master.lock)
            for name, group in model.groups.items()
        }
        plant = self._ticker.plant_robot
        self._cameras = None if plant else KinematicCameras(model, self._drive_base, self._groups)
        self._lidars = {lidar.name: Scanner(lidar) for lidar in model.lidars}
        try:
            self._ticker.start(self.master, self._tick)
            begin(self.master)
        except BaseException:
            self.close()
            raise
        self._count_anew()

    def _drive(self, name: str) -> Drive:
        setup = self._setup.drives[name]
        joint = self._model.description.joint(setup.moves)
        motion: JointMotion | TrackMotion
        if setup.track is not None:
            motion = TrackMotion(setup.acceleration or TRACK_ACCELERATION)
        else:
            gains = next(group.gains[joint.name] for group in self._model.groups.values() if joint.name in group.gains)
            motion = JointMotion(joint, gains, self._weight)
        self._motions[name] = motion
        return Drive(setup, joint, motion, round(self._setup.status_timeout * self._setup.sync_rate))

    def _weight(self, joint: Joint) -> float:
        """The effort of a joint against gravity, at the joint positions of the last cycle."""
        if self._weights is None:
            drives = self._drives.values()
            self._weights = self._holding.at({drive.joint.name: drive.position for drive in drives})
        return self._weights.get(joint.name, 0.0)

    def _tracks(self) -> CanTracks | None:
        tracks = self._model.tracks
        if tracks is None:
            return None
        sides = {}
        for name, item in self._setup.drives.items():
            motion = self._motions[name]
            if item.track is not None and isinstance(motion, TrackMotion):
                sides[item.track] = self._drives[name], motion
        left, right = (self._model.description.joint(names[0]) for names in (tracks.left, tracks.right))
        return CanTracks(sides["left"], sides["right"], abs(left.origin.y - right.origin.y))

    def _pairs(self, group: GroupSetup) -> list[tuple[Drive, JointMotion]]:
        by_joint = {item.moves: name for name, item in self._setup.drives.items()}
        pairs = []
        for joint in group.joints:
            motion = self._motions[by_joint[joint]]
            if isinstance(motion, JointMotion):
                pairs.append((self._drives[by_joint[joint]], motion))
        return pairs

    @property
    def drive(self) -> DriveBase:
        """The chassis."""
        robot = self._ticker.plant_robot
        return self._drive_base if robot is None else _Located(self._drive_base, robot)

    @property
    def drives(self) -> Mapping[str, Drive]:
        """The drives, by name."""
        return self._drives

    @property
    def counters(self) -> Mapping[str, int]:
        """Frames sent, taken and ignored, by reason."""
        return {**self._ticker.received(), **self.master.counters, **self.master.inbox.counters}

    @property
    def fleet(self) -> DriveFleet | None:
        """The simulated drives in this process."""
        return self._ticker.fleet

    @property
    def virtual_bus(self) -> VirtualBus | None:
        """The bus to simulated drives in this process."""
        return self._ticker.virtual_bus

    @property
    def groups(self) -> Mapping[str, CanJoints]:
        """Joints besides the chassis, by the names of their groups in the description."""
        return self._groups

    @property
    def lidars(self) -> Mapping[str, RangeFinder]:
        """Lidars of the simulation; on a bus they never scan, for they are not on it."""
        robot = self._ticker.plant_robot
        return self._lidars if robot is None else robot.lidars

    @property
    def force_torque(self) -> Mapping[str, ForceTorqueSensor]:
        """Sensors of force and torque of the simulation."""
        robot = self._ticker.plant_robot
        return {} if robot is None else robot.force_torque

    @property
    def cameras(self) -> Mapping[str, CameraSource]:
        """Cameras of the simulation, or pictures of sky and floor from where the joints put them."""
        robot = self._ticker.plant_robot
        if robot is not None:
            return robot.cameras
        return {} if self._cameras is None else self._cameras.cameras

    def view(self) -> None:
        """Open the window of the simulation that the drives move. Raises `ConfigError` if there is none."""
        robot: object = self._ticker.plant_robot
        if not isinstance(robot, Viewable):
            raise ConfigError("these drives move no simulation that could be viewed; with --bus virtual:sim they do")
        robot.view()

    @property
    def optional_parts(self) -> Sequence[OptionalPart]:
        """The optional parts of the chassis, the motors, and localisation, contacts and battery of the simulation."""
        robot = self._ticker.plant_robot
        simulated = () if robot is None else (Localization.of(robot), Contacts.of(robot), Battery.of(robot))
        return (*self._drive_base.optional_parts, self._motors, *(part for part in simulated if part is not None))

    @property
    def time(self) -> float:
        """Seconds since it was opened; of another backend's robot its own time, which its scans have."""
        robot = self._ticker.plant_robot
        return self._time if robot is None else robot.time

    def enable(self) -> None:
        """Enable the drives, at the positions where they are. Raises `ConfigError` with the drive that prevents it.

        Raises `DriveFault` if it failed twice while this program was held up; the next `advance` tries again.
        """
        try:
            self.master.enable()
        except DriveFault as error:
            self._failed = True
            if self.master.held_up:
                raise
            raise ConfigError(f"can: {error}") from error
        self._count_anew()

    def _count_anew(self) -> None:
        if self._tracked is not None:
            self._tracked.restart()
            self._tracked.update()

    def advance(self, dt: float) -> None:
        """Let `dt` seconds pass. Raises `DriveFault` when a drive has failed; the next call tries to recover."""
        if not 0.0 <= dt < math.inf:
            raise ValueError(f"cannot advance by {dt} s; time only goes forward")
        if self._failed:
            self.master.recover()
            if self._tracked is not None:
                self._tracked.restart()
            self._failed = False
        before = self._drive_base.twist()
        self._time += dt
        self._ticker.advance(dt)
        if dt and self._tracked is not None:
            self._tracked.update_acceleration(before, dt)
        if self._cameras is not None:
            self._cameras.update()
        try:
            self.master.check(self._ticker.clock())
        except Exception:
            self._failed = True
            raise

    def measure_lateness(self) -> list[float]:
        """A list that gets the seconds by which each cycle from now on is late; it stays empty without a real bus."""
        late: list[float] = []
        if isinstance(self._ticker, _Clocked):
            self._ticker.late = late
        return late

    def _tick(self) -> None:
        """Take over what the drives have measured, after each cycle."""
        self._weights = None
        if self._tracked is not None:
            self._tracked.update()

    def close(self) -> None:
        """Stop all drives, take their power, and close the bus. May be called twice."""
        if self._closed:
            return
        self._closed = True
        self.master.close()
        self._ticker.close()
        if self._cameras is not None:
            self._cameras.close()


class _Located:
    """The chassis by CAN, and its true pose by the simulation."""

    def __init__(self, chassis: CanTracks | FixedBase, robot: Robot) -> None:
        self.set_effort = chassis.set_effort
        self.stop = chassis.stop
        self.pose = robot.drive.pose
        self.twist = robot.drive.twist
        self.acceleration = robot.drive.acceleration


class _Simulated:
    """Simulated drives in this process: cycles and drives follow the robot's time."""

    def __init__(self, model: RobotModel, setup: CanSetup, plant: str, world: str) -> None:
        self.virtual_bus: VirtualBus | None = (virtual_bus := VirtualBus())
        self.network = virtual_bus.near.network()
        moved = plant_of(plant, model, setup, world)
        self.fleet: DriveFleet | None = DriveFleet(model, setup, moved, virtual_bus.far, keeps_home=True)
        self.plant_robot = self.fleet.plant.robot
        self._fleet = self.fleet
        self._period = 1.0 / setup.sync_rate
        self._now = 0.0
        self._owed = 0.0
        self._cycle: Callable[[float], None] = lambda _now: None
        self._tick: Callable[[], None] = lambda: None
        self._virtual_bus = virtual_bus
        virtual_bus.far_receives = self._fleet.receive

    def received(self) -> Mapping[str, int]:
        """Nothing is lost on this bus."""
        return {}

    def clock(self) -> float:
        """Seconds of the simulated bus."""
        return self._now

    def start(self, master: Master, tick: Callable[[], None]) -> None:
        """Start the cycles."""
        self._virtual_bus.near_receives = master.inbox.receive
        self._cycle, self._tick = master.cycle, tick

    def wait_cycle(self) -> None:
        """One cycle, and the time to the next."""
        self._cycle(self._now)
        self._tick()
        self._now += self._period
        self._fleet.step(self._period)

    def advance(self, dt: float) -> None:
        """Cycles on a fixed grid, the first at the beginning."""
        self._owed += dt
        while self._owed > TIME_TOLERANCE:
            self._owed -= self._period
            self.wait_cycle()

    def close(self) -> None:
        """Release the plant."""
        self._fleet.close()


class _Clocked:
    """A bus: a thread runs the cycles, by the clock."""

    virtual_bus: VirtualBus | None = None
    fleet: DriveFleet | None = None
    plant_robot: Robot | None = None
    clock = staticmethod(time.monotonic)

    def __init__(self, setup: CanSetup, bus: str) -> None:
        self._bus = buses.open_bus(bus, setup.bit_rate)
        self._errors_forgeable = buses.split(bus)[0] in buses.OPEN
        self._period = 1.0 / setup.sync_rate
        self.network = canopen.Network(self._bus)
        self._closing = threading.Event()
        self._thread: threading.Thread | None = None
        self._receiver: buses.Receiver | None = None
        self._advanced: float | None = None
        self.late: list[float] | None = None
        """Seconds by which each cycle was late, for measurements."""

    def received(self) -> Mapping[str, int]:
        """Counters of the receiver."""
        return self._receiver.counters if self._receiver else {}

    def start(self, master: Master, tick: Callable[[], None]) -> None:
        """Start the threads that receive, and that run the cycles."""
        self._master, self._tick = master, tick
        self._receiver = buses.Receiver(
            self._bus, master.inbox.receive, master.bus_failed, errors_forgeable=self._errors_forgeable
        )
        self._thread = threading.Thread(target=self._run, name="CAN cycle", daemon=True)
        self._thread.start()

    def _run(self) -> None:
        clock, due = time.monotonic, time.monotonic()
        while not self._closing.is_set():
            due += self._period
            if (left := due - clock()) > 0:
                time.sleep(left)
            now = clock()
            if self.late is not None:
                self.late.append(now - due)
            if now - due > self._period:  # no burst of what was missed
                due = now
            try:
                if self._advanced is not None and now - self._advanced > ROBOT_TIMEOUT:
                    self._master.hold_all()
                self._master.cycle(now)
                self._tick()
            except Exception as error:  # noqa: BLE001 - the thread must go on, or nothing stops the drives
                _LOG.exception("a cycle failed")
                self._master.bus_failed(f"{type(error).__name__}: {error}")

    def wait_cycle(self) -> None:
        """One period; the thread runs the cycle."""
        time.sleep(self._period)
        if self._advanced is not None:
            self._advanced = time.monotonic()  # the robot's thread is alive: it waits here

    def advance(self, dt: float) -> None:  # noqa: ARG002 - the clock does
        """The robot's thread is alive. Raises `DriveFault` if that of the cycles is not."""
        self._advanced = time.monotonic()
        if self._thread is not None and not self._thread.is_alive():
            raise DriveFault("the thread of the CAN bus has ended, and drives get no commands: start the robot again")

    def close(self) -> None:
        """End the threads, and close the bus."""
        self._closing.set()
        if self._thread is not None:
            self._thread.join()
        if self._receiver is not None:
            self._receiver.close()
        self._bus.shutdown()
