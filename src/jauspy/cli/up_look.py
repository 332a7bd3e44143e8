"""What a running robot and its node manager show at one moment, as plain figures."""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Final

from jauspy.component import Component
from jauspy.modules.config import ModuleConfig
from jauspy.modules.robot import RobotRunner
from jauspy.platform.contract import Snapshot
from jauspy.services.core import AccessControl, Events
from jauspy.services.core.subscriptions import Subscription
from jauspy.video.camera_process import CameraProcess

WINDOW: Final = 9
"""Looks that a rate is made from."""


@dataclass(frozen=True, slots=True)
class ModuleLook:
    """A component; `hertz` are the reports a second that its `events` promise; messages `received`, `sent` a second."""

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
class CameraLook:
    """A camera; `receivers` are those that watch, of them `playing`; pictures and packets are those of a second."""

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


@dataclass(frozen=True, slots=True)
class NodeLook:
    """A node manager; packets that it routed in a second."""

    networks: tuple[str, ...]
    components: int
    peers: int
    packets: float
    dropped: Mapping[str, int]


@dataclass(frozen=True, slots=True)
class Look:
    """Everything at once; `factor` is the robot's time over ours, `node` None when it does not tell."""

    snapshot: Snapshot
    factor: float
    timing: Mapping[str, int]
    modules: tuple[ModuleLook, ...]
    cameras: tuple[CameraLook, ...]
    node: NodeLook | None


@dataclass(slots=True)
class Lookout:
    """Looks at a robot again and again; the rates are those between its last looks."""

    runner: RobotRunner
    _before: deque[tuple[float, Mapping[str, float]]] = field(default_factory=lambda: deque(maxlen=WINDOW))

    def look(self, now: float, status: Mapping[str, Any] | None) -> Look:
        """What there is to see at `now`, in seconds; `status` is what the node manager tells of itself."""
        snapshot = self.runner.snapshot
        assert snapshot is not None, "the robot is open"
        counters = self.runner.counters
        routed = 0 if status is None else sum(n for name, n in status["counters"].items() if name.startswith("routed."))
        counted = {**counters, "time": snapshot.time, "routed": routed}
        self._before.append((now, counted))
        pairs = list(zip(self.runner.components, self.runner.config.modules, strict=True))
        shown = {module.camera: str(each.id) for each, module in pairs}
        return Look(
            snapshot,
            self._rate("time"),
            {name: counters.get(f"realtime.{name}", 0) for name in ("steps", "late", "skipped")},
            tuple(self._module(each, module) for each, module in pairs),
            tuple(self._camera(name, shown[name], camera) for name, camera in self.runner.videos.items()),
            None if status is None else _node(status, self._rate("routed")),
        )

    def _rate(self, name: str) -> float:
        """How much it grows in a second."""
        (began, before), (ends, after) = self._before[0], self._before[-1]
        return (after.get(name, 0.0) - before.get(name, 0.0)) / (ends - began) if ends > began else 0.0

    def _module(self, component: Component, module: ModuleConfig) -> ModuleLook:
        host, access, events = component.host, component.host.service(AccessControl), component.host.service(Events)
        subscriptions = events.subscriptions.all() if events else []
        return ModuleLook(
            str(component.id),
            module.type,
            host.status.name.lower() if host.status is not None else "",
            f"{access.controller} ({access.authority})" if access and access.controller else "",
            len(subscriptions),
            sum(each.confirmed for each in subscriptions if isinstance(each, Subscription)),
            self._rate(f"{component.id}.endpoint.received"),
            self._rate(f"{component.id}.endpoint.sent"),
            {name: count for name, count in component.counters.items() if count and _tells_of_loss(name)},
        )

    def _camera(self, name: str, module: str, camera: CameraProcess) -> CameraLook:
        settings = camera.settings
        return CameraLook(
            name,
            module,
            (settings.width, settings.height),
            settings.rate,
            settings.bit_rate,
            len(camera.receivers),
            sum(camera.receivers.values()),
            self._rate(f"camera.{name}.pictures"),
            self._rate(f"camera.{name}.packets"),
            camera.counters.get("dropped", 0),
        )


def _tells_of_loss(name: str) -> bool:
    """A component counts what went well, too, and answers about the whole robot that were kept to a packet."""
    floor, _, what = name.partition(".")
    fine = what in ("received", "report_cut")
    return what.startswith(("dropped.", "undelivered")) or (floor in ("host", "component") and not fine)


def _node(status: Mapping[str, Any], packets: float) -> NodeLook:
    kernel = sum(each["receive_buffer"]["dropped"] for each in status["networks"])
    dropped = {name: n for name, n in status["counters"].items() if name.startswith("dropped.") and n}
    return NodeLook(
        tuple(each["address"] for each in status["networks"]),
        len(status["components"]),
        len(status["peers"]),
        packets,
        dropped | ({"by the kernel": kernel} if kernel else {}),
    )
