"""How a running robot looks on a terminal."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import Final

from rich.console import Group, RenderableType
from rich.padding import Padding
from rich.rule import Rule
from rich.table import Table
from rich.text import Text

from jauspy.cli.up_look import CameraLook, Look, ModuleLook, NodeLook
from jauspy.modules.config import RobotConfig
from jauspy.platform.contract import Snapshot

COLOURS: Final[Mapping[str, str]] = {
    "ready": "green",
    "standby": "cyan",
    "initialize": "cyan",
    "emergency": "bold white on red",
    "failure": "bold red",
    "shutdown": "dim",
}
REASONS: Final = 6
"""Reasons for a loss that are listed."""


def table(config: RobotConfig, look: Look, seconds: float) -> RenderableType:
    """Everything; `seconds` since it is up."""
    title = f"{config.name}, subsystem {config.subsystem}, up {_duration(seconds)}"
    parts: list[RenderableType] = [Rule(title, style="cyan", align="left"), _head(look), Text(), _modules(look.modules)]
    if look.cameras:
        parts += [Text(), _cameras(look.cameras)]
    if losses := _losses(look):
        parts += [Text(), *losses]
    return Padding(Group(*parts, Text("Ctrl-C stops all of it", style="dim")), (1, 0, 0, 0))


def _head(look: Look) -> Table:
    grid = Table.grid(padding=(0, 2))
    grid.add_column(style="dim")
    grid.add_column()
    grid.add_row("robot", _motion(look.snapshot))
    late, skipped, steps = (look.timing[name] for name in ("late", "skipped", "steps"))
    grid.add_row("time", f"{look.factor:.2f} of real time, of {steps} steps {late} were late, {skipped} left out")
    grid.add_row("node manager", _node(look.node))
    return grid


def _motion(snapshot: Snapshot) -> str:
    """In JAUS axes, as a LocalPoseSensor tells it: y and yaw grow to the right."""
    pose, twist = snapshot.pose, snapshot.twist
    where = f"x {_signed(pose.x, 2)} m  y {_signed(-pose.y, 2)} m  yaw {_signed(-math.degrees(pose.yaw), 1)}°"
    return f"{where},  {_signed(twist.vx, 2)} m/s  {_signed(-math.degrees(twist.wz), 1)}°/s"


def _signed(value: float, digits: int) -> str:
    """With its sign, and zero without a minus."""
    return f"{round(value, digits) + 0.0:+.{digits}f}"


def _node(node: NodeLook | None) -> Text:
    if node is None:
        return Text("does not tell its status", style="yellow")
    peers = f"{node.peers} peer{'s' * (node.peers != 1)}"
    where = ", ".join(node.networks)
    return Text(f"UDP {where}, {node.components} components, {peers}, {node.packets:.0f} packets/s")


def _modules(modules: Iterable[ModuleLook]) -> Table:
    made = _columns(("module", "type", "state", "controller"), ("events", "in/s", "out/s", "lost"))
    for each in modules:
        events = f"{each.events} ({each.hertz:.3g} Hz)" if each.hertz else _count(each.events)
        state = Text(each.status or "-", style=COLOURS.get(each.status, ""))
        rates = (f"{each.received:.1f}", f"{each.sent:.1f}", _count(sum(each.dropped.values())))
        made.add_row(each.id, each.type, state, each.controller or "-", events, *rates)
    return made


def _cameras(cameras: Iterable[CameraLook]) -> Table:
    made = _columns(("camera", "module", "size", "set to", "sent to"), ("pictures/s", "packets/s", "lost"))
    for each in cameras:
        size, rate = f"{each.size[0]}x{each.size[1]}", f"{each.rate} Hz, {each.bit_rate / 1e6:.3g} Mbit/s"
        paused = f", {each.receivers - each.playing} paused" if each.receivers > each.playing else ""
        rates = (f"{each.pictures:.1f}", f"{each.packets:.0f}", _count(each.dropped))
        made.add_row(each.name, each.module, size, rate, f"{_count(each.receivers)}{paused}", *rates)
    return made


def _losses(look: Look) -> list[Text]:
    """Why something was lost, most often first."""
    found = [(count, each.id, name) for each in look.modules for name, count in each.dropped.items()]
    if look.node is not None:
        found += [(count, "node manager", name) for name, count in look.node.dropped.items()]
    found.sort(reverse=True)
    lines = [Text(f"{count} {where}: {name}", style="yellow") for count, where, name in found[:REASONS]]
    more = len(found) - len(lines)
    return [*lines, Text(f"and {more} reasons more; SIGUSR1 prints all", style="yellow")] if more else lines


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
