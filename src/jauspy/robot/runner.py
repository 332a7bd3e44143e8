"""A whole robot: a backend that runs in real time, and its capability modules as JAUS components."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import AsyncExitStack, suppress
from datetime import datetime
from functools import partial
from pathlib import Path
from types import TracebackType
from typing import Final, Self

from jauspy import backends
from jauspy.audio.device_processes import LoudspeakerProcess, MicrophoneProcess
from jauspy.audio.worker_messages import SoundPlayed
from jauspy.backends import check_robot
from jauspy.beats import next_beat
from jauspy.component.component import Component, ComponentOptions, Intercept, loop_time, until_signalled, wall_clock
from jauspy.errors import ConfigError, JausError, TransportError
from jauspy.ids import JausID
from jauspy.logs import get_logger
from jauspy.platform.backend import Backend, EnablesLast
from jauspy.platform.battery import Battery
from jauspy.platform.camera import CameraSource
from jauspy.platform.contract import Counting, Robot, Snapshot, Viewable
from jauspy.platform.description import RobotModel
from jauspy.platform.guarded_robot import GuardedRobot
from jauspy.platform.guards import ObstacleGuard
from jauspy.platform.ranging import RangeFinder
from jauspy.platform.sound_scene import MachineState, SoundScene
from jauspy.platform.stability import StabilityMonitor, stability_of
from jauspy.platform.video_settings import MAX_IMAGE_REPORT
from jauspy.protocol.delivery import Delivery
from jauspy.robot.audit import AuditLog
from jauspy.robot.audit_heads import HeadSender
from jauspy.robot.config import ModuleConfig, RobotConfig
from jauspy.robot.hosts import Announcement, check_parts, host_of
from jauspy.robot.hour_meter import HourMeterFile
from jauspy.robot.kinds import Shared
from jauspy.robot.monitors import (
    BatteryMonitor,
    FaultMonitor,
    LoadMonitor,
    guard_problems,
    overloads,
    reason,
    supply_problem,
    tilt_problem,
)
from jauspy.robot.operators import command_seals
from jauspy.robot.realtime import STEP, RealTime
from jauspy.robot.robot_files import robot_model, with_place
from jauspy.robot.sightings import follow_guard, sightings
from jauspy.robot.traffic_log import TrafficLog
from jauspy.services.core import Discovery, FailureRecovery
from jauspy.services.core.discovery import vehicle_identities
from jauspy.services.environment_sensing import DigitalResourceDiscovery
from jauspy.services.host import Host
from jauspy.services.iop import HoursInMemory
from jauspy.services.service import Service
from jauspy.transport import Transport
from jauspy.video.camera_process import CameraProcess

_LOG: Final = get_logger("jauspy.robot")

POWER_CHECK_PERIOD: Final = 0.05
"""Seconds between two checks of the modules' power."""

RETRY_DELAY: Final = 1.0
"""Seconds until a component that could not be opened is tried again."""


class RunningModules:
    """Opens the components of the modules that are present, and closes those of modules that are not.

    The Discovery of each reports the services of all that are open. `make` makes the component of a module;
    `is_present` says whether a module is there now.
    """

    def __init__(
        self,
        modules: Iterable[ModuleConfig],
        make: Callable[[ModuleConfig], Component],
        is_present: Callable[[ModuleConfig], bool],
    ) -> None:
        self._modules = tuple(modules)
        self._make = make
        self._is_present = is_present
        self._components: dict[int, Component] = {}
        self._tried: dict[int, float] = {}

    @property
    def open(self) -> tuple[tuple[Component, ModuleConfig], ...]:
        """The components that are open, with their modules, in the order of the configuration."""
        return tuple((self._components[index], self._modules[index]) for index in sorted(self._components))

    def hosts(self) -> list[Host]:
        """The hosts of the components that are open."""
        return [component.host for component, _ in self.open]

    async def start(self) -> None:
        """Open the components of the modules that are present. Raises `TransportError` if one cannot be opened."""
        for index, module in enumerate(self._modules):
            if self._is_present(module):
                await self._open(index)

    async def follow(self) -> None:
        """Open and close components as modules appear and disappear, until cancelled."""
        while True:
            await asyncio.sleep(POWER_CHECK_PERIOD)
            await self.update()

    async def update(self) -> None:
        """Open and close components once; one that cannot be opened is logged, and tried again later."""
        now = asyncio.get_running_loop().time()
        for index, module in enumerate(self._modules):
            present, component = self._is_present(module), self._components.get(index)
            if component is not None and not present:
                await self._close(index)
            elif component is None and present and now - self._tried.get(index, -RETRY_DELAY) >= RETRY_DELAY:
                await asyncio.sleep(0)  # making one takes 20 ms, and others may wait for the event loop
                try:
                    await self._open(index)
                except TransportError as error:
                    self._tried[index] = now
                    _LOG.warning("%s %s cannot be opened: %s", module.type, module.part or "", error)

    async def close(self) -> None:
        """Close all components, the last one first. May be called twice."""
        for index in sorted(self._components, reverse=True):
            await self._close(index)

    async def _open(self, index: int) -> None:
        component = self._make(self._modules[index])
        others = self.hosts()
        await component.open()
        self._components[index] = component
        self._tried.pop(index, None)
        _list_each_other(component.host, others)

    async def _close(self, index: int) -> None:
        component = self._components[index]
        for host in self.hosts():
            if host is not component.host and (discovery := host.service(Discovery)) is not None:
                discovery.remove_local(component.id)
        await component.close()
        del self._components[index]


def _list_each_other(new: Host, others: Iterable[Host]) -> None:
    """Have the Discovery of each report the services of the other."""
    others = list(others)
    if (discovery := new.service(Discovery)) is not None:
        discovery.add_local(others)
    for other in others:
        if (discovery := other.service(Discovery)) is not None:
            discovery.add_local([new])


HEARTBEAT_TIMEOUT: Final = 1.0
"""Seconds without a heartbeat of the event loop after which the robot is stopped."""


def in_real_time(robot: Robot, *, step: float = STEP) -> RealTime:
    """The robot's time on the clock, in steps of so many seconds; it stops when the program hangs."""
    return RealTime(robot, step=step, heartbeat_timeout=HEARTBEAT_TIMEOUT)


class RobotRunner:
    """Runs the robot that `config` describes: `async with RobotRunner(...)`, or `await runner.run()`.

    `transports` makes the transport of each component, by its id. `backend`, the name of an installed one or a
    `Backend`, and `world` override `config`; `realtime` makes the object that advances the robot's time; `view` opens
    the window of the backend's simulator. `audit_log` is a file of the user's choice in place of the configured one,
    and `audit_heads_to` the URL of a machine that gets its heads. `traffic_log` is what DataLogging switches. `utc_now`
    is the wall clock of its components.
    Opening raises `ConfigError` for an unknown backend, model or world, and `TransportError` for a transport that
    cannot be opened. Closing ends the components first, and then the robot, which then stands still.
    """

    def __init__(
        self,
        config: RobotConfig,
        transports: Callable[[JausID], Transport],
        *,
        backend: str | Backend | None = None,
        world: str | None = None,
        realtime: Callable[[Robot], RealTime] = in_real_time,
        view: bool = False,
        audit_log: Path | None = None,
        audit_heads_to: str | None = None,
        traffic_log: TrafficLog | None = None,
        utc_now: Callable[[], datetime] = wall_clock,
    ) -> None:
        self._utc_now = utc_now
        self._backend = None if isinstance(backend, str) else backend
        self._backend_file = config.file if backend is None else ""
        name = backend if isinstance(backend, str) or backend is None else backend.name
        self.config = config.model_copy(update={"backend": name or config.backend, "world": world or config.world})
        self._transports = transports
        self._make_realtime, self._view = realtime, view
        self._realtime: RealTime | None = None
        self._modules: RunningModules | None = None
        self._following: asyncio.Task[None] | None = None
        self._videos: Mapping[str, CameraProcess] = {}
        self._microphones: Sequence[MicrophoneProcess] = ()
        self._loudspeakers: Sequence[LoudspeakerProcess] = ()
        self._audit: AuditLog | None = None
        self._audit_log, self._audit_heads_to = audit_log, audit_heads_to
        self._heads: HeadSender | None = None
        self._traffic_log = traffic_log
        self._stability: StabilityMonitor | None = None
        self._counting: Counting | None = None
        self._stack = AsyncExitStack()
        self._is_closing = False

    @property
    def audit(self) -> AuditLog | None:
        """The audit log, if the robot has one and was opened."""
        return self._audit

    @property
    def running(self) -> tuple[tuple[Component, ModuleConfig], ...]:
        """The components and their modules, in the order of the configuration; empty when not open.

        A component of a factory cell's part exists while the part has power.
        """
        return self._modules.open if self._modules else ()

    @property
    def components(self) -> tuple[Component, ...]:
        """The components of `running`."""
        return tuple(component for component, _ in self.running)

    @property
    def lidars(self) -> Mapping[str, RangeFinder]:
        """Lidars of the robot; empty when not open."""
        return self._realtime.lidars if self._modules and self._realtime else {}

    @property
    def videos(self) -> Mapping[str, CameraProcess]:
        """Cameras that a module streams, by name; empty when not open."""
        return self._videos if self._modules else {}

    @property
    def cameras(self) -> Mapping[str, CameraSource]:
        """Cameras of the robot, for other processes; empty when not open."""
        return self._realtime.cameras if self._modules and self._realtime else {}

    @property
    def snapshot(self) -> Snapshot | None:
        """The robot's state after its last step; None before it was opened."""
        return self._realtime.snapshot if self._realtime else None

    @property
    def faults(self) -> Mapping[str, str]:
        """Descriptions of faults, by the id of the component that is in Failure because of it."""
        if (robot := self._realtime) is None:
            return {}
        found = {
            str(component.id): reason(module, robot.faults) or supply_problem(module, robot)
            for component, module in self.running
        }
        return {id: why for id, why in found.items() if why}

    @property
    def overloads(self) -> Mapping[str, str]:
        """Descriptions of loads that joints cannot carry, by the id of the component and the joint's name.

        Also of the tilt at which the robot was stopped, of a robot that is near to tipping over, of a low battery, and
        of contacts before which guards have stopped the robot.
        """
        if self._realtime is None:
            return {}
        joints = {name: group.joints for name, group in self._realtime.groups.items()}
        snapshot = self._realtime.snapshot
        loads = {
            f"{component.id} {name}": text
            for component, module in self.running
            for name, text in overloads(module, joints, snapshot).items()
        }
        tilts = {f"{component.id} tilt": tilt_problem(component.host) for component, _ in self.running}
        battery = Battery.of(self._realtime)
        supply = {"battery": battery.problem if battery is not None and not battery.cuts_motors else ""}
        stability = {"stability": self._stability.warning if self._stability is not None else ""}
        found = loads | {where: text for where, text in (tilts | supply | stability).items() if text}
        return found | guard_problems(snapshot)

    @property
    def counters(self) -> Mapping[str, int]:
        """Counters of `RealTime`, those of the backend's robot, and those of the components by id."""
        counts = {f"realtime.{name}": n for name, n in self._realtime.counters.items()} if self._realtime else {}
        if self._counting is not None:
            counts |= {f"robot.{name}": n for name, n in self._counting.counters.items()}
        for component in self.components:
            counts |= {f"{component.id}.{name}": n for name, n in component.counters.items()}
        for camera, video in self._videos.items():
            counts |= {f"camera.{camera}.{name}": n for name, n in video.counters.items()}
        sound = {item.setup.name: item.counters for item in self._microphones}
        sound |= {item.setup.name: item.counters for item in self._loudspeakers}
        for device, counters in sound.items():
            counts |= {f"sound.{device}.{name}": n for name, n in counters.items()}
        if self._traffic_log is not None:
            counts |= {f"traffic_log.{name}": n for name, n in self._traffic_log.counters.items()}
        if self._audit is not None:
            counts |= {f"audit.{name}": n for name, n in dict(self._audit.counters).items()}
        if self._heads is not None:
            counts |= {f"audit.{name}": n for name, n in dict(self._heads.counters).items()}
        return counts

    async def open(self) -> None:
        """Start everything; if a part cannot start, the others are stopped again."""
        if self._modules is not None:
            return
        self._is_closing = False
        async with AsyncExitStack() as stack:
            model = robot_model(self.config)
            realtime, enable = self._start_robot(stack, model)
            heartbeats = asyncio.create_task(self._send_heartbeats(realtime), name="heartbeats")
            self._supervise(stack, heartbeats, realtime)
            videos = await self._open_cameras(stack, realtime)
            await self._open_sound(stack, realtime, model)
            audit = self._open_audit_log(stack)
            if self._traffic_log is not None:
                await stack.enter_async_context(self._traffic_log)
            make = partial(
                self._make_component,
                model,
                realtime,
                videos,
                self._shared(stack, model, realtime),
                seals=command_seals(self.config, audit.record if audit else None),
            )
            for module in self.config.modules:
                if not module.kind.is_present(module, model.cell, realtime.snapshot):
                    check_parts(self.config, module, model, realtime)
            modules = RunningModules(
                self.config.modules, make, lambda module: module.kind.is_present(module, model.cell, realtime.snapshot)
            )
            stack.push_async_callback(modules.close)
            self._modules = modules
            stack.callback(self._forget_modules)
            await modules.start()
            self._realtime, self._videos, self._audit = realtime, videos, audit
            if model.cell is not None:
                self._following = asyncio.create_task(modules.follow(), name="modules of the cell")
                self._supervise(stack, self._following, realtime)
            if (guard := ObstacleGuard.of(realtime)) is not None and (processes := sightings(self.config, realtime)):
                seeing = asyncio.create_task(
                    follow_guard(guard, processes, self.config.subsystem), name="depth cameras of the guard"
                )
                self._supervise(stack, seeing, realtime)
            if enable is not None:
                await asyncio.wrap_future(realtime.enable(enable))
            self._stack = stack.pop_all()

    def _shared(self, stack: AsyncExitStack, model: RobotModel, realtime: RealTime) -> Shared:
        """Values that the modules share besides the robot's parts."""
        health, hours = self.config.health, None
        if health.hour_meter is not None:
            hours = HourMeterFile(Path(health.hour_meter))
            stack.callback(hours.close)
        self._stability = stability_of(model, realtime)
        return Shared(
            faults=lambda: realtime.faults,
            hours=hours or HoursInMemory(),
            reminders=health.reminders,
            stability=self._stability,
            traffic_logger=self._traffic_log,
            microphones=self._microphones,
            loudspeakers=self._loudspeakers,
        )

    def _open_audit_log(self, stack: AsyncExitStack) -> AuditLog | None:
        path = self._audit_log or (Path(self.config.audit_log) if self.config.audit_log is not None else None)
        if self._audit_log is not None and self.config.operators is None:
            raise ConfigError(
                "an audit log needs operators: name the file of those who may command in the robot's file"
            )
        if path is None and self._audit_heads_to is not None:
            raise ConfigError("the heads of an audit log are to be sent, and the robot has none: give one")
        if path is None:
            return None
        if self._audit_heads_to is not None:
            self._heads = stack.enter_context(HeadSender(self._audit_heads_to))
        is_chosen = self._audit_log is not None
        return stack.enter_context(AuditLog(path, self.config.name, follow_links=is_chosen, heads=self._heads))

    def _forget_modules(self) -> None:
        self._modules = None

    def _make_component(
        self,
        model: RobotModel,
        realtime: RealTime,
        videos: Mapping[str, CameraProcess],
        shared: Shared,
        module: ModuleConfig,
        *,
        seals: Callable[[], Sequence[Service]],
    ) -> Component:
        host = _host(
            self.config,
            module,
            model,
            realtime,
            videos,
            utc_now=self._utc_now,
            more=seals(),
            shared=shared,
        )
        if (video := host.service(DigitalResourceDiscovery)) is not None:  # whoever controls a module comes first
            video.operators = lambda: [host.controller for host in self._modules.hosts()] if self._modules else []
        delivery = Delivery(max_message=MAX_IMAGE_REPORT) if module.camera else None
        return Component.of_host(
            host,
            self._transports(host.id),
            intercept=announcement(host, module),
            options=ComponentOptions(delivery=delivery, max_message_age=self.config.max_message_age),
        )

    async def close(self) -> None:
        """Stop everything, in order. May be called twice."""
        self._is_closing = True
        await self._stack.aclose()

    async def run(self) -> None:
        """Open, run until Ctrl-C or SIGTERM, close (the robot stops). Raises the robot's exception if it fails."""
        await until_signalled(asyncio.ensure_future(self._run()))

    async def _run(self) -> None:
        async with self:
            await self.wait()

    async def wait(self) -> None:
        """Wait until cancelled. Raises the robot's exception if it fails."""
        if self._realtime is None:
            return
        ended = asyncio.wrap_future(self._realtime.ended)
        following = self._following
        try:
            await asyncio.wait([ended, following] if following else [ended], return_when=asyncio.FIRST_COMPLETED)
            if following is not None and following.done() and not following.cancelled():
                following.result()
            await ended
        finally:
            ended.cancel()

    async def __aenter__(self) -> Self:
        await self.open()
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        await self.close()

    async def _open_cameras(self, stack: AsyncExitStack, realtime: RealTime) -> dict[str, CameraProcess]:
        streamed = {module.camera for module in self.config.modules}
        videos = {}
        for camera in (camera for camera in self.config.cameras if camera.name in streamed):
            source = realtime.cameras.get(camera.name)
            if source is None:
                raise ConfigError(f"cameras: the backend {self.config.backend!r} has no camera {camera.name!r}")
            video = CameraProcess(source, camera.settings(), stamped=camera.stamped)
            videos[camera.name] = await stack.enter_async_context(video)
        return videos

    async def _open_sound(self, stack: AsyncExitStack, realtime: RealTime, model: RobotModel) -> None:
        """Microphones hear the robot, and what its loudspeakers play."""

        def state() -> MachineState:
            return MachineState.of(model, realtime.snapshot)

        def on_played(played: SoundPlayed) -> None:
            for microphone in microphones:
                microphone.hear(played)

        microphones = [MicrophoneProcess(SoundScene.of(model, setup), state) for setup in model.microphones]
        loudspeakers = [LoudspeakerProcess(setup, on_played) for setup in model.loudspeakers]
        for device in (*microphones, *loudspeakers):
            await stack.enter_async_context(device)
        self._microphones, self._loudspeakers = microphones, loudspeakers

    async def _send_heartbeats(self, realtime: RealTime) -> None:
        clock = asyncio.get_running_loop().time
        while True:
            sent_at = clock()
            realtime.alive(is_starting=self._realtime is None)
            await asyncio.sleep(next_beat(sent_at, HEARTBEAT_TIMEOUT / 5.0, self.config.subsystem) - sent_at)
            if self._realtime is not None and clock() - sent_at > HEARTBEAT_TIMEOUT:
                _LOG.warning("the event loop has not run for %.1f s: the robot was stopped", clock() - sent_at)

    def _supervise(self, stack: AsyncExitStack, task: asyncio.Task[None], realtime: RealTime) -> None:
        """Cancel the task when the stack is closed; if it ends before, the robot has failed."""

        def report(task: asyncio.Task[None]) -> None:
            if not self._is_closing:  # a second Ctrl-C cancels all tasks of a program that closes the robot
                error = None if task.cancelled() else task.exception()
                realtime.end_early(f"the task {task.get_name()!r} of its program", error)

        task.add_done_callback(report)
        stack.push_async_callback(_cancel, task, report)

    def _find_backend(self) -> Backend:
        try:
            return backends.find(self.config.backend)
        except ConfigError as error:
            raise with_place(ConfigError(f"backend: {error}"), self._backend_file) from error

    def _start_robot(self, stack: AsyncExitStack, model: RobotModel) -> tuple[RealTime, Callable[[], None] | None]:
        """Open the robot and start its thread; also returns what enables its motors later, if that is to be done."""
        backend = self._backend or self._find_backend()
        robot: Robot
        enable = None
        try:
            if isinstance(backend, EnablesLast):
                robot = disabled = backend.open_disabled(model, self.config.world)
                enable = disabled.enable
            else:
                robot = backend.open(model, self.config.world)
        except JausError:
            raise
        except Exception as error:
            problem = backends.missing_methods(error) or f"cannot open the robot: {type(error).__name__}: {error}"
            raise ConfigError(f"the backend {self.config.backend!r} {problem}") from error
        if hasattr(robot, "close"):
            stack.callback(_close, robot)
        try:
            check_robot(robot)
        except ConfigError as error:
            raise ConfigError(f"the backend {self.config.backend!r}: {error}") from error
        except Exception as error:
            raise ConfigError(
                f"the backend {self.config.backend!r} cannot read the robot: {type(error).__name__}: {error}"
            ) from error
        if self._view:
            if not isinstance(robot, Viewable):
                raise ConfigError(f"the backend {self.config.backend!r} has no window to view; 'sim' has one")
            robot.view()
        self._counting = robot if isinstance(robot, Counting) else None
        return stack.enter_context(self._make_realtime(GuardedRobot(robot, model))), enable


def _host(
    config: RobotConfig,
    module: ModuleConfig,
    model: RobotModel,
    robot: RealTime,
    videos: Mapping[str, CameraProcess],
    *,
    shared: Shared,
    utc_now: Callable[[], datetime],
    more: Sequence[Service],
) -> Host:
    node = f"{config.name} node {module.node or config.node}"
    identities = vehicle_identities(config.name, node, " ".join(filter(None, (module.type, module.part))))
    recovery = FailureRecovery()
    host = host_of(
        config,
        module,
        model,
        robot,
        identities,
        videos=videos,
        utc_now=utc_now,
        now=loop_time(),
        more=(*more, recovery),
        shared=shared,
    )
    FaultMonitor(host, recovery, module, robot)
    LoadMonitor(host, module, robot)
    if module is config.modules[0]:
        BatteryMonitor(host, robot)
    return host


def announcement(host: Host, module: ModuleConfig) -> Intercept | None:
    """Announce the component to the configured console; returns the intercept for its answer."""
    return Announcement(host, JausID.parse(module.announce_to)).intercept if module.announce_to else None


def _close(robot: Robot) -> None:
    try:
        robot.close()
    except Exception:  # noqa: BLE001 - whatever a backend raises
        _LOG.exception("the backend could not close the robot")


async def _cancel(task: asyncio.Task[None], report: Callable[[asyncio.Task[None]], None]) -> None:
    task.remove_done_callback(report)
    task.cancel()
    with suppress(asyncio.CancelledError):
        await task
