"""The cell over JAUS: control of the modules that it uses, motions of the UR10, and observations of parts."""

from __future__ import annotations

import asyncio
import math
from collections import defaultdict, deque
from collections.abc import Callable, Mapping, Sequence
from contextlib import AsyncExitStack
from itertools import pairwise
from typing import Final, Self

import numpy as np
import pinocchio as pin

from jauspy.cell.frames import Array, averaged, offset_between, se3
from jauspy.cell.interface import GRIPPER, SeenPart, T
from jauspy.cell.motion import GENTLE, Path, profile
from jauspy.cell.scene import Layout
from jauspy.errors import ConfigError, JausError, RequestError
from jauspy.ids import JausID
from jauspy.messages.cell.v1_0 import ReportServoState
from jauspy.ocu import OCU, Arm, ComponentClient, MotionLimits, Robot
from jauspy.ocu.cell import PartObservation
from jauspy.platform.modular.arm import ArmController, ModularArmState, TrajectoryPoint
from jauspy.platform.modular.cell import ConveyorState
from jauspy.platform.modular.connector import ConnectorError, ConnectorState
from jauspy.robot.config import RobotConfig

AUTHORITY: Final = 100
POLL: Final = 0.02
"""Seconds between two queries of the joints at the end of a motion."""
ARRIVED: Final = 0.0015
"""Radians from the goal within which a joint has arrived, and radians between two queries within which it stands."""
REPEATED: Final = 0.1
"""Seconds from one command of a velocity to its repetition."""
LATE: Final = 0.8
"""Seconds after which a motion that is not quite there counts as ended."""
BLOCKED: Final = 0.03
"""Radians off the goal, that late, which count as blocked."""
SETTLING: Final = 0.5
"""Seconds in which what is held comes to rest after a motion."""
LIP: Final = 0.001
"""Metres before contact from which on the lip of a cup may seal: one that leaks all the way to contact is pressed on
only a little."""
STEADY: Final = 0.5
"""Newtons between two queries, below which a force is steady."""
SAMPLES: Final = 6
"""Observations of a part that are averaged."""
SILENT: Final = 1.0
"""Seconds without an observation from which on the sensor counts as silent."""
FIRST_TIME: Final = 5.0
"""Seconds in which the first observation must arrive."""
WATCH_PERIOD: Final = 0.1
"""Seconds between two queries for a new observation."""
PAUSED: Final = 0.15
"""Seconds by which observations come later than the fastest one when the robot's time has paused; by the period of
watching and the network they do by less."""
MOVED: Final = 0.008
"""Metres, or a tenth of a radian, between two observations, from which on the part has moved."""
APPEAR_TIME: Final = 5.0
"""Seconds in which a module that has got power must answer discovery."""


class CellClient:
    """`async with CellClient(ocu, config, layout) as cell:`. Takes control of what it commands, and releases it.

    With `threads` it computes in another thread, so that planning never delays the renewal of control.
    """

    def __init__(self, ocu: OCU, config: RobotConfig, layout: Layout, *, threads: bool = False) -> None:
        self.layout = layout
        self._threads = threads
        self._ocu = ocu
        self._config = config
        self._stack = AsyncExitStack()
        self._robot: Robot | None = None
        self._arm: Arm | None = None
        self._components: dict[JausID, ComponentClient] = {}
        self._controlled: dict[JausID, AsyncExitStack] = {}
        self._left: set[JausID] = set()
        """Components of parts that have lost their power since they were discovered."""
        self._locks: defaultdict[JausID, asyncio.Lock] = defaultdict(asyncio.Lock)
        self._seen: dict[str, deque[pin.SE3]] = {}
        self._observed = asyncio.Event()
        self._last_seen: dict[str, str] = {}
        """Types of all parts that were ever seen, by name."""
        self._in_view: frozenset[str] = frozenset()
        self._moving: set[str] = set()
        """Parts that were elsewhere in the observation before the last one of them."""
        self._observation_time = 0.0
        self._latest: dict[str, tuple[float, pin.SE3]] = {}
        self._robot_clock = RobotClock()
        self.counts: dict[str, int] = defaultdict(int)

    async def __aenter__(self) -> Self:
        self._robot = await self._ocu.discover(self._config.subsystem)
        watching = asyncio.create_task(self._watch(), name="part sensor")
        self._stack.push_async_callback(_cancel, watching)
        try:
            await self._control(self._module("CM-MAN"))
        except BaseException:
            await self._stack.aclose()
            raise
        return self

    async def __aexit__(self, *_: object) -> None:
        await self._stack.aclose()

    @property
    def subsystem(self) -> int:
        """The robot's subsystem id."""
        return self._config.subsystem

    # --- time -----------------------------------------------------------------------------------------------------

    def now(self) -> float:
        """Seconds of the event loop's clock."""
        return asyncio.get_running_loop().time()

    async def sleep(self, seconds: float) -> None:
        """Wait for a number of seconds."""
        await asyncio.sleep(seconds)

    async def compute(self, function: Callable[[], T]) -> T:
        """The value of a function that may take seconds; on virtual time no time passes meanwhile."""
        if not self._threads:
            return function()
        computing = asyncio.ensure_future(asyncio.to_thread(function))
        try:
            return await asyncio.shield(computing)
        finally:
            await asyncio.wait({computing})

    # --- the UR10 -------------------------------------------------------------------------------------------------

    async def posture(self) -> Array:
        """Positions of the UR10's joints as its URDF counts them, in radians."""
        found = await (await self._ur10()).joints()
        return np.array([found[name] for name in self.layout.group.joints])

    async def follow(
        self, path: Path, *, speed: float = 1.0, tool_speed: float = math.inf, gentle: bool = False
    ) -> None:
        """Move the UR10 along a path; each straight piece is one command, in which all joints arrive together.

        `tool_speed` limits the speed of the tool, in m/s; `gentle` motions speed up slowly. Raises `RequestError` when
        it is blocked.
        """
        for start, goal in pairwise(path.points):
            await self._move(start, goal, speed, tool_speed, GENTLE if gentle else 1.0)

    async def slide(self, velocity: Array, duration: float) -> None:
        """Move the UR10's tool straight at a velocity (m/s, in the world) for `duration` seconds, and let it stop."""
        arm = await self._ur10()
        rows = zip(
            self.layout.group.joints, self.layout.speeds.tolist(), self.layout.accelerations.tolist(), strict=True
        )
        await arm.set_motion_limits({name: MotionLimits(speed, rate, rate) for name, speed, rate in rows})
        until = self.now() + duration
        try:
            while (left := until - self.now()) > 0.0:
                await arm.move_tool_at(velocity.tolist())
                await asyncio.sleep(min(left, REPEATED))
        finally:
            await arm.move_tool_at()

    async def touch(
        self, path: Path, connector: str, *, tool_speed: float, contact: float = math.inf
    ) -> ConnectorState:
        """Same as `follow`, but stop as soon as a connector that holds nothing has attached something.

        One that holds something already stops the motion when its force has changed by `contact`, in newtons. The arm
        then holds where it is: pressing on would load the joint. What the UR10 itself finds in its way ends the motion,
        too, as `blocked` tells: it is what was to be touched. So does a cup that leaks until it is in contact. Returns
        the connector's state.
        """
        before = await self._settled(connector)
        sealed = self.now()
        for start, goal in pairwise(path.points):
            motion = asyncio.create_task(self._move(start, goal, 1.0, tool_speed, GENTLE))
            try:
                while not motion.done():
                    state = await self.connector(connector)
                    met = abs(state.force - before.force) > contact
                    if state.error is not ConnectorError.FAILED:
                        sealed = self.now()
                    leaks = self.now() - sealed > LIP / tool_speed
                    if state.attached_to != before.attached_to or (before.attached_to and met) or leaks:
                        await (await self._ur10()).stop()
                        return state
                    await asyncio.sleep(POLL)
                motion.result()
            except RequestError:
                if not await self.blocked():
                    raise
                break
            finally:
                await _cancel(motion)
        return await self.connector(connector)

    async def blocked(self) -> str:
        """What was in the way of the UR10's last motion, as a sentence; empty if nothing was."""
        return await (await self._ur10()).blocked()

    async def full_speed(self) -> None:
        """Permit the UR10's joints their full speed, for `aim`."""
        names = self.layout.group.joints
        rows = zip(names, self.layout.speeds.tolist(), self.layout.accelerations.tolist(), strict=True)
        await (await self._ur10()).set_motion_limits(
            {name: MotionLimits(speed, rate, rate) for name, speed, rate in rows}
        )

    async def aim(self, posture: Array) -> None:
        """Have the UR10 move towards a posture (rad) at once, from whatever motion it is in; returns before it arrives.

        Repeated with postures close to each other, it follows them.
        """
        await (await self._ur10()).begin(dict(zip(self.layout.group.joints, posture.tolist(), strict=True)))

    async def hold(self) -> None:
        """Stop the UR10 where it is."""
        await (await self._ur10()).stop()

    async def _settled(self, connector: str) -> ConnectorState:
        """The state of a connector, when the force on what it holds no longer changes, or after `SETTLING` seconds."""
        state, until = await self.connector(connector), self.now() + SETTLING
        while state.attached_to and self.now() < until:
            await asyncio.sleep(POLL)
            last, state = state, await self.connector(connector)
            if abs(state.force - last.force) < STEADY:
                break
        return state

    async def _move(
        self, start: Array, goal: Array, speed: float, tool_speed: float, acceleration: float = 1.0
    ) -> None:
        forward = self.layout.kinematics.forward
        found = profile(
            start,
            goal,
            self.layout.speeds * speed,
            self.layout.accelerations * acceleration,
            length=float(np.linalg.norm(forward(goal).translation - forward(start).translation)),
            tool_speed=tool_speed,
        )
        if not found.duration:
            return
        arm, names = await self._ur10(), self.layout.group.joints
        rows = zip(names, found.speeds.tolist(), found.accelerations.tolist(), strict=True)
        await arm.set_motion_limits({name: MotionLimits(speed, rate, rate) for name, speed, rate in rows})
        await arm.begin(dict(zip(names, goal.tolist(), strict=True)))
        await asyncio.sleep(max(0.0, found.duration - POLL))
        before, until = await self.posture(), self.now() + LATE
        least = float(np.max(np.abs(before - goal)))
        while True:
            await asyncio.sleep(POLL)
            at = await self.posture()
            off, moved = float(np.max(np.abs(at - goal))), float(np.max(np.abs(at - before)))
            if moved < ARRIVED / 3.0 and off < ARRIVED:
                return
            if self.now() > until:
                if off <= BLOCKED:
                    return
                if off > least - BLOCKED:
                    joint = names[int(np.argmax(np.abs(at - goal)))]
                    late = f"{joint} of the UR10 is {off:.3f} rad off after {LATE:g} s; is it blocked?"
                    raise RequestError(await arm.blocked() or late)
                least, until = off, self.now() + LATE  # it comes nearer: the robot's time is slower than this clock
            before = at

    async def _ur10(self) -> Arm:
        id = self._module("CM-MAN")
        await self._control(id)
        if self._arm is None:
            assert self._robot is not None
            self._arm = self._robot.manipulator(str(id))
        return self._arm

    # --- parts and connectors -------------------------------------------------------------------------------------

    async def observe(self, *, fresh: bool = False) -> Mapping[str, SeenPart]:
        """The parts that the sensor has seen, each averaged since it last moved; with `fresh` over new observations.

        A part that is hidden now is where it was seen last; its `age` says how long ago. While the sensor is silent,
        all parts are where they were seen last. Raises `RequestError` if it has never reported any.
        """
        if fresh:
            self._seen.clear()
        while True:
            at_rest = self._in_view - self._moving
            seen_well = all(len(self._seen.get(name, ())) >= SAMPLES - 2 for name in at_rest)
            if self._in_view and (seen_well or self.silence() > SILENT):
                return {name: self._known(name, type) for name, type in self._last_seen.items()}
            self._observed.clear()
            try:
                async with asyncio.timeout(SILENT if self._in_view else FIRST_TIME):
                    await self._observed.wait()
            except TimeoutError:
                if not self._in_view:
                    raise RequestError(f"the part sensor has reported no part for {FIRST_TIME:g} s") from None

    def silence(self) -> float:
        """Seconds since the last observation, by this client's clock; infinite before the first."""
        return self.now() - self._robot_clock.here(self._observation_time) if self._in_view else math.inf

    def _known(self, name: str, type: str) -> SeenPart:
        seen = self._seen.get(name)
        time, last = self._latest[name]
        return SeenPart(type, averaged(list(seen)) if seen else last, self._observation_time - time)

    def latest(self, part: str) -> tuple[float, pin.SE3]:
        """The last single observation of a part: when, on this client's clock, and where. Raises `RequestError`."""
        if part not in self._latest:
            raise RequestError(f"the part sensor does not see {part}")
        time, pose = self._latest[part]
        return self._robot_clock.here(time), pose

    async def connector(self, name: str) -> ConnectorState:
        """Measurements of a connector or the gripper. One whose module has no power reports nothing."""
        id, number = self._connector(name)
        return await (await self._component(id)).connector(number).state()

    async def enable(self, name: str, enabled: bool, *, after: float = 0.0) -> None:
        """Start or stop the pump of a connector or of the gripper, after so many seconds of the robot's time."""
        id, number = self._connector(name)
        connector = (await self._control(id)).connector(number)
        await (connector.enable(after=after) if enabled else connector.disable(after=after))

    async def switch(self, names: Sequence[str], on: bool) -> None:
        """Switch modules on or off."""
        await (await self._control(self._module("CM-PRT"))).part_station.switch(names, on=on)

    async def leave(self, part: str) -> None:
        """Release control of a part, which is about to lose its power; it is discovered anew when it is used again."""
        for id in [self._config.id_of(module) for module in self._config.modules if module.part == part]:
            await self._release(id)
            self._components.pop(id, None)
            self._left.add(id)

    async def servo(self, name: str) -> ReportServoState:
        """Measurements of a servo module."""
        return await (await self._component(self._module("CM-SRV", name))).servo.state()

    # --- conveyor -------------------------------------------------------------------------------------------------

    async def run_conveyor(self, speed: float) -> None:
        """Run the belt at a speed, in m/s."""
        await (await self._control(self._module("CM-CNV"))).conveyor.run(speed)

    async def belt(self) -> ConveyorState:
        """Speed and travel of the belt."""
        return await (await self._component(self._module("CM-CNV"))).conveyor.state()

    # --- the modular arms -----------------------------------------------------------------------------------------
    # `name` is that of an arm in the cell's file: `layout.arms` has them, the first one is the default

    async def arm(self, name: str = "") -> ModularArmState:
        """The modular arm's joints and motion."""
        return await (await self._component(self._arm_id(name))).modular_arm.state()

    async def command_arm(self, positions: Sequence[float], duration: float = 0.0, *, name: str = "") -> None:
        """Have the modular arm begin a motion; NaN leaves a joint as it is, 0 seconds is as fast as limits allow."""
        await (await self._control(self._arm_id(name))).modular_arm.begin(positions, duration)

    async def move_arm(self, positions: Sequence[float], duration: float = 0.0, *, name: str = "") -> None:
        """Move the modular arm, and wait until it is there; raises `RequestError` if it does not arrive."""
        await (await self._control(self._arm_id(name))).modular_arm.move(positions, duration)

    async def follow_arm(self, joints: Sequence[str], points: Sequence[TrajectoryPoint], *, name: str = "") -> None:
        """Move joints of the modular arm through points, and wait; raises `RequestError` as `move_arm` does."""
        await (await self._control(self._arm_id(name))).modular_arm.follow(joints, points)

    async def choose_controller(self, controller: ArmController) -> None:
        """Choose how the joints of the modular arm follow."""
        await (await self._control(self._arm_id(""))).modular_arm.set_controller(controller)

    def _arm_id(self, name: str) -> JausID:
        return self._module("CM-ARM", name or next(iter(self.layout.arms), None))

    # --- the car --------------------------------------------------------------------------------------------------

    async def car(self) -> Robot:
        """The robot, whose car is under control, so that it drives; waits until the car has its wheels."""
        await self._control(self._module("CM-MOB", "car"))
        assert self._robot is not None
        return self._robot

    # --- components -----------------------------------------------------------------------------------------------

    def _module(self, type: str, part: str | None = None) -> JausID:
        for module in self._config.modules:
            if module.type == type and module.part in (part, module.part if part is None else part):
                return self._config.id_of(module)
        raise ConfigError(f"{self._config.name} has no {type}{f' of {part}' if part else ''}")

    def _connector(self, name: str) -> tuple[JausID, int]:
        """Component and number of a connector."""
        if name == GRIPPER:
            return self._module("CM-CON", GRIPPER), 1
        part, _, connector = name.partition("/")
        type = self.layout.type_of(part)
        if connector not in type.connectors:
            raise ConfigError(f"{part} has no connector {connector!r}; it has: {', '.join(type.connectors) or 'none'}")
        kind = "CM-SRV" if type.servo is not None else "CM-CON"
        return self._module(kind, part), 1 + list(type.connectors).index(connector)

    async def _component(self, id: JausID) -> ComponentClient:
        """A component of the cell; waits until it has appeared."""
        until = self.now() + APPEAR_TIME
        while id not in self._components:
            assert self._robot is not None
            if id not in self._left and any(component.id == id for component in self._robot.components):
                self._components[id] = self._robot.component(str(id))
            elif self.now() > until:
                raise RequestError(f"component {id} has not appeared within {APPEAR_TIME:g} s; has it power?")
            else:
                self._left.discard(id)
                self._robot = await self._ocu.discover(self._config.subsystem)
        return self._components[id]

    async def _control(self, id: JausID) -> ComponentClient:
        """Same as `_component`; it is under control of this client, and Ready."""
        component = await self._component(id)
        async with self._locks[id]:
            if id not in self._controlled:
                assert self._robot is not None
                control = AsyncExitStack()
                await control.enter_async_context(self._robot.control(str(id), authority=AUTHORITY))
                self._controlled[id] = control
                self._stack.push_async_callback(self._release, id)
        return component

    async def _release(self, id: JausID) -> None:
        """Release control of a component; without effect if this client has none."""
        async with self._locks[id]:
            if (control := self._controlled.pop(id, None)) is not None:
                await control.aclose()

    # --- watching -------------------------------------------------------------------------------------------------

    async def _watch(self) -> None:
        """Keep the last observations of each part since it last moved."""
        sensor = (await self._component(self._module("CM-PRT"))).part_station
        last = -math.inf
        while True:
            try:
                seen = await sensor.observe()
            except JausError:
                self.counts["observations_lost"] += 1
            else:
                if seen.time > last:
                    last = seen.time
                    self._robot_clock.compare(seen.time, self.now())
                    self._add(seen)
            await asyncio.sleep(WATCH_PERIOD)

    def _add(self, observation: PartObservation) -> None:
        for name, frame in observation.poses.items():
            pose = se3(frame)
            self._latest[name] = observation.time, pose
            seen = self._seen.setdefault(name, deque(maxlen=SAMPLES))
            if seen:
                distance, angle = offset_between(seen[-1], pose)
                if distance > MOVED or angle > 10.0 * MOVED:
                    seen.clear()
                    self._moving.add(name)
                else:
                    self._moving.discard(name)
            seen.append(pose)
        self._last_seen.update(observation.types)
        self._in_view = frozenset(observation.poses)
        self._observation_time = observation.time
        self._observed.set()


class RobotClock:
    """How far the robot's clock is behind this client's, by the observation that came fastest.

    The time of a robot that cannot keep up pauses, and stays behind.
    """

    def __init__(self) -> None:
        self._offset = math.inf
        self._delays: deque[float] = deque(maxlen=5)
        """Seconds from the last observations, by the robot's clock, until they came, by this one."""

    def compare(self, observed: float, now: float) -> None:
        """Take in an observation of a time of the robot's clock that comes now, by this one."""
        self._delays.append(now - observed)
        least = min(self._delays)
        if least < self._offset or (len(self._delays) == self._delays.maxlen and least > self._offset + PAUSED):
            self._offset = least

    def here(self, time: float) -> float:
        """A time of the robot's clock on this one; infinite before the first observation."""
        return time + self._offset


async def _cancel(task: asyncio.Task[None]) -> None:
    task.cancel()
    await asyncio.wait({task})
