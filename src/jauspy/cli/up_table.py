"""The live table of `jauspy up`: status of modules, cameras and the node manager."""

from __future__ import annotations

import asyncio
import math
from collections import deque
from collections.abc import AsyncIterator, Iterable, Mapping
from contextlib import asynccontextmanager, suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Final

from rich.console import Group, RenderableType
from rich.live import Live
from rich.padding import Padding
from rich.rule import Rule
from rich.table import Table
from rich.text import Text

from jauspy.cli import console
from jauspy.component.component import Component
from jauspy.errors import TransportError
from jauspy.node import status
from jauspy.platform.contract import PartId, Snapshot
from jauspy.platform.localization import Localization, LocalizationState
from jauspy.printable import printable
from jauspy.robot.config import ModuleConfig, RobotConfig
from jauspy.robot.runner import RobotRunner
from jauspy.services.core import AccessControl, Events
from jauspy.services.core.subscriptions import EventSubscription
from jauspy.video.camera_process import CameraProcess

RATE_SAMPLES: Final = 9
"""Samples over which rates are computed."""


@dataclass(frozen=True, slots=True)
class ModuleStatus:
    """A component. `hertz` is the sum of its periodic events' rates; `received` and `sent` are messages per second."""

    id: str
    type: str
    status: str
    controller: str
    events: int
    hertz: float
    received: float
    sent: float
    dropped: Mapping[str, int]


@dataclass(frozen=True, slots=True)
class CameraStatus:
    """A camera. `playing` of the `receivers` are not paused; `pictures` and `packets` are per second."""

    name: str
    module: str
    size: tuple[int, int]
    rate: int
    bit_rate: int
    receivers: int
    playing: int
    pictures: float
    packets: float
    dropped: int
    reduced: str = ""
    """A sentence if the machine is too slow for what it is set to; empty otherwise."""


@dataclass(frozen=True, slots=True)
class NodeStatus:
    """A node manager; `packets` are those routed per second."""

    networks: tuple[str, ...]
    components: int
    peers: int
    packets: float
    dropped: Mapping[str, int]


@dataclass(frozen=True, slots=True)
class RobotStatus:
    """Everything the table shows; `factor` is simulated time over real time, `node` is None without an answer."""

    snapshot: Snapshot
    factor: float
    timing: Mapping[str, int]
    modules: tuple[ModuleStatus, ...]
    cameras: tuple[CameraStatus, ...]
    node: NodeStatus | None
    faults: Mapping[str, str] = field(default_factory=dict)
    """Failures by the id of the component that is in Failure for them."""
    overloads: Mapping[str, str] = field(default_factory=dict)
    """Overloads of joints, and a tilt that stopped the robot, by the ids of components and the names of joints."""


@dataclass(slots=True)
class StatusSampler:
    """Samples the status of a robot; rates are those over the last `RATE_SAMPLES`."""

    runner: RobotRunner
    _before: deque[tuple[float, Mapping[str, float]]] = field(default_factory=lambda: deque(maxlen=RATE_SAMPLES))

    def sample(self, now: float, status: Mapping[str, Any] | None) -> RobotStatus:
        """The status at `now`, in seconds; `status` is the node manager's."""
        snapshot = self.runner.snapshot
        assert snapshot is not None, "the robot is open"
        counters = self.runner.counters
        routed = 0 if status is None else sum(n for name, n in status["counters"].items() if name.startswith("routed."))
        counted = {**counters, "time": snapshot.time, "routed": routed}
        self._before.append((now, counted))
        pairs = self.runner.running
        shown = {module.camera: str(pair.id) for pair, module in pairs}
        return RobotStatus(
            snapshot=snapshot,
            factor=self._rate("time"),
            timing={name: counters.get(f"realtime.{name}", 0) for name in ("steps", "late", "skipped")},
            modules=tuple(self._module(pair, module) for pair, module in pairs),
            cameras=tuple(self._camera(name, shown[name], camera) for name, camera in self.runner.videos.items()),
            node=None if status is None else _node_status(status, self._rate("routed")),
            faults=self.runner.faults,
            overloads=self.runner.overloads,
        )

    def _rate(self, name: str) -> float:
        """The increase of a counter per second."""
        (began, before), (ends, after) = self._before[0], self._before[-1]
        return (after.get(name, 0.0) - before.get(name, 0.0)) / (ends - began) if ends > began else 0.0

    def _module(self, component: Component, module: ModuleConfig) -> ModuleStatus:
        host, access, events = component.host, component.host.service(AccessControl), component.host.service(Events)
        subscriptions = events.subscriptions.all() if events else []
        return ModuleStatus(
            str(component.id),
            type=f"{module.type} {module.part}" if module.part else module.type,
            status=host.status.name.lower() if host.status is not None else "",
            controller=f"{access.controller} ({access.authority})" if access and access.controller else "",
            events=len(subscriptions),
            hertz=sum(
                subscription.confirmed for subscription in subscriptions if isinstance(subscription, EventSubscription)
            ),
            received=self._rate(f"{component.id}.endpoint.received"),
            sent=self._rate(f"{component.id}.endpoint.sent"),
            dropped={name: count for name, count in component.counters.items() if count and _is_loss(name)},
        )

    def _camera(self, name: str, module: str, camera: CameraProcess) -> CameraStatus:
        settings = camera.settings
        return CameraStatus(
            name,
            module=module,
            size=(settings.width, settings.height),
            rate=settings.rate,
            bit_rate=settings.bit_rate,
            receivers=len(camera.receivers),
            playing=sum(camera.receivers.values()),
            pictures=self._rate(f"camera.{name}.pictures"),
            packets=self._rate(f"camera.{name}.packets"),
            dropped=camera.counters.get("dropped", 0),
            reduced=camera.reduced,
        )


def _is_loss(name: str) -> bool:
    """True for counters of losses, not for those of received messages and truncated reports."""
    floor, _, what = name.partition(".")
    is_normal = what in ("received", "report_cut")
    return what.startswith(("dropped.", "undelivered")) or (floor in ("host", "component") and not is_normal)


def _node_status(status: Mapping[str, Any], packets: float) -> NodeStatus:
    kernel = sum(network["receive_buffer"]["dropped"] for network in status["networks"])
    dropped = {name: n for name, n in status["counters"].items() if name.startswith("dropped.") and n}
    return NodeStatus(
        tuple(network[key] for network in status["networks"] for key in ("address", "address6") if network.get(key)),
        len(status["components"]),
        len(status["peers"]),
        packets,
        dropped | ({"by the kernel": kernel} if kernel else {}),
    )


COLOURS: Final[Mapping[str, str]] = {
    "ready": "green",
    "standby": "cyan",
    "initialize": "cyan",
    "emergency": "bold white on red",
    "failure": "bold red",
    "shutdown": "dim",
}
MAX_REASONS: Final = 6
"""Lines of reasons for losses."""


def table(config: RobotConfig, look: RobotStatus, seconds: float) -> RenderableType:
    """The whole table; `seconds` since the start."""
    title = f"{config.name}, subsystem {config.subsystem}, up {_duration(seconds)}"
    parts: list[RenderableType] = [Rule(title, style="cyan", align="left"), _head(look), Text(), _modules(look.modules)]
    if look.cameras:
        parts += [Text(), _cameras(look.cameras)]
        parts += [Text(printable(camera.reduced), "yellow") for camera in look.cameras if camera.reduced]
    if look.faults:
        parts += [
            Text(),
            *(
                Text(f"{ids} failed: {why}; `jauspy send ID Reset` tries again", "bold red")
                for ids, why in _grouped(look.faults)
            ),
        ]
    if look.overloads:
        parts += [
            Text(),
            *(Text(f"{where.split()[0]}: {printable(what)}", "yellow") for where, what in look.overloads.items()),
        ]
    if losses := _losses(look):
        parts += [Text(), *losses]
    return Padding(Group(*parts, Text("Ctrl-C stops the robot", style="dim")), (1, 0, 0, 0))


def _grouped(faults: Mapping[str, str]) -> list[tuple[str, str]]:
    """The ids that have failed for the same reason, and that reason."""
    reasons: dict[str, list[str]] = {}
    for id, why in faults.items():
        reasons.setdefault(printable(why), []).append(id)
    return [(", ".join(ids), why) for why, ids in reasons.items()]


def _head(look: RobotStatus) -> Table:
    grid = Table.grid(padding=(0, 2))
    grid.add_column(style="dim")
    grid.add_column()
    grid.add_row("robot", _motion(look.snapshot))
    late, skipped, steps = (look.timing[name] for name in ("late", "skipped", "steps"))
    grid.add_row("time", f"{look.factor:.2f} of real time, of {steps} steps {late} were late, {skipped} skipped")
    grid.add_row("node manager", _node(look.node))
    return grid


def _motion(snapshot: Snapshot) -> str:
    """Estimated pose and velocity, with the axes of REP-103 as in all commands: y and yaw grow to the left."""
    known = snapshot.parts.get(PartId(Localization))
    pose, twist = snapshot.pose, snapshot.twist
    if isinstance(known, LocalizationState):
        pose, twist = known.local.pose, known.twist
    where = f"x {_signed(pose.x, 2)} m  y {_signed(pose.y, 2)} m  yaw {_signed(math.degrees(pose.yaw), 1)}°"
    return f"{where},  {_signed(twist.vx, 2)} m/s  {_signed(math.degrees(twist.wz), 1)}°/s  (y, yaw: left)"


def _signed(value: float, digits: int) -> str:
    """A number with its sign; zero has no minus."""
    return f"{round(value, digits) + 0.0:+.{digits}f}"


def _node(node: NodeStatus | None) -> Text:
    if node is None:
        return Text("does not report its status", style="yellow")
    peers = f"{node.peers} peer{'s' * (node.peers != 1)}"
    where = ", ".join(node.networks)
    return Text(f"UDP {where}, {node.components} components, {peers}, {node.packets:.0f} packets/s")


def _modules(modules: Iterable[ModuleStatus]) -> Table:
    made = _columns(("module", "type", "state", "controller"), ("events", "in/s", "out/s", "lost"))
    for module in modules:
        events = f"{module.events} ({module.hertz:.3g} Hz)" if module.hertz else _count(module.events)
        state = Text(module.status or "-", style=COLOURS.get(module.status, ""))
        rates = (f"{module.received:.1f}", f"{module.sent:.1f}", _count(sum(module.dropped.values())))
        made.add_row(module.id, module.type, state, module.controller or "-", events, *rates)
    return made


def _cameras(cameras: Iterable[CameraStatus]) -> Table:
    made = _columns(("camera", "module", "size", "set to", "sent to"), ("pictures/s", "packets/s", "lost"))
    for camera in cameras:
        size, rate = f"{camera.size[0]}x{camera.size[1]}", f"{camera.rate} Hz, {camera.bit_rate / 1e6:.3g} Mbit/s"
        paused = f", {camera.receivers - camera.playing} paused" if camera.receivers > camera.playing else ""
        rates = (f"{camera.pictures:.1f}", f"{camera.packets:.0f}", _count(camera.dropped))
        made.add_row(camera.name, camera.module, size, rate, f"{_count(camera.receivers)}{paused}", *rates)
    return made


def _losses(look: RobotStatus) -> list[Text]:
    """The reasons for losses, most frequent first."""
    found = [(count, module.id, name) for module in look.modules for name, count in module.dropped.items()]
    if look.node is not None:
        found += [(count, "node manager", name) for name, count in look.node.dropped.items()]
    found.sort(reverse=True)
    lines = [Text(f"{count} {where}: {name}", style="yellow") for count, where, name in found[:MAX_REASONS]]
    more = len(found) - len(lines)
    return [*lines, Text(f"and {more} more reasons; SIGUSR1 prints all", style="yellow")] if more else lines


def _columns(left: Iterable[str], right: Iterable[str]) -> Table:
    made = Table(box=None, padding=(0, 2, 0, 0), header_style="dim")
    for name in left:
        made.add_column(name, no_wrap=True)
    for name in right:
        made.add_column(name, justify="right", no_wrap=True)
    return made


def _count(number: int) -> str:
    return str(number or "-")


def _duration(seconds: float) -> str:
    minutes, rest = divmod(int(seconds), 60)
    return f"{minutes // 60}:{minutes % 60:02}:{rest:02}"


REFRESH_INTERVAL: Final = 0.4
"""Seconds between two samples."""


@asynccontextmanager
async def live_table(runner: RobotRunner, root: Path) -> AsyncIterator[None]:
    """Show the table in the block; lines that are printed meanwhile, on either stream, are shown above it."""
    with Live(console=console.stderr(), auto_refresh=False, transient=True, vertical_overflow="crop") as live:
        drawing = asyncio.create_task(_draw(live, runner, root))
        try:
            yield
        finally:
            drawing.cancel()
            with suppress(asyncio.CancelledError):
                await drawing


async def _draw(live: Live, runner: RobotRunner, root: Path) -> None:
    """Sample and draw until cancelled. A thread draws, because drawing takes milliseconds that delay the robot."""
    sampler, clock = StatusSampler(runner), asyncio.get_running_loop().time
    began = clock()
    while True:
        node_status = await _node_manager_status(root)
        now = clock()
        drawn = table(runner.config, sampler.sample(now, node_status), now - began)
        await asyncio.to_thread(live.update, drawn, refresh=True)
        await asyncio.sleep(REFRESH_INTERVAL)


async def _node_manager_status(root: Path) -> dict[str, Any] | None:
    """The node manager's status; None if it does not answer, as while it restarts."""
    try:
        return await status.read(root)
    except TransportError:
        return None
