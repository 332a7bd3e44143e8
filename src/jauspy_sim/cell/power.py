"""Power of modules in a simulated cell: which modules have it, what they draw, and what batteries have left."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Final

from jauspy.platform.battery import BatteryCharge
from jauspy.platform.modular.cell import Consumption, ModulePower, PowerState
from jauspy.platform.modular.parts import CellSetup, PartKind
from jauspy_sim.cell.connectors import SimulatedConnector
from jauspy_sim.cell.servos import SUPPLY_VOLTAGE, SimulatedServo

PERIOD: Final = 0.02
"""Seconds over which power is averaged, and after which batteries are drained."""
PUMP_POWER: Final = 6.0
"""Watts of a connector whose pump runs: assumption, of small diaphragm pumps for 0.9 bar."""


class SimulatedPower(ModulePower):
    """Finds the modules with power after each change, measures what each draws, and drains batteries.

    Parts that are attached to each other share their sources. With a base on the mains among them batteries are not
    drained, nor charged; otherwise batteries that are not empty share the load in proportion to what they have left.
    """

    def __init__(
        self,
        cell: CellSetup,
        attachments: Callable[[], Iterable[tuple[str, str]]],
        follow: Callable[[Mapping[str, bool]], None],
        servos: Mapping[str, SimulatedServo],
        connectors: Mapping[str, SimulatedConnector],
    ) -> None:
        types = {part.name: cell.types[part.type] for part in cell.parts}
        self._mains = {name for name, type in types.items() if type.kind is PartKind.BASE and type.battery is None}
        self.batteries = {name: BatteryCharge(type.battery) for name, type in types.items() if type.battery is not None}
        self._switches = {name: True for name, type in types.items() if type.is_module}
        self._attachments = attachments
        self._follow = follow
        self._servos = servos
        self._pumps: dict[str, list[SimulatedConnector]] = {}
        for connector in connectors.values():
            self._pumps.setdefault(connector.part, []).append(connector)
        self._pumped = dict.fromkeys(self._switches, 0.0)
        self._drawn = dict.fromkeys(self._switches, 0.0)
        self._groups: list[tuple[tuple[str, ...], tuple[str, ...]]] = []
        """Parts with power that share their sources, and the batteries that supply them; none on the mains."""
        self._measured_at = 0.0
        self._power = dict.fromkeys(self._switches, 0.0)
        """Watts of each part in the last period."""
        self._state: PowerState | None = None
        """None after a change, until it is asked for."""

    def state(self) -> PowerState:
        """Switches, consumption and batteries, as last measured."""
        if self._state is None:
            self._state = PowerState(
                dict(self._switches),
                {name: Consumption(power, self._drawn[name]) for name, power in self._power.items()},
                {name: battery.state() for name, battery in self.batteries.items()},
            )
        return self._state

    def switch(self, name: str, on: bool) -> None:
        """Switch a module on or off; an unknown name has no effect."""
        if self._switches.get(name, on) is not on:
            self._switches[name] = on
            self._state = None
            self.update()

    def step(self, now: float) -> None:
        """Measure when the next measurement is due; `now` in seconds."""
        if now - self._measured_at >= PERIOD:
            self._measure(now - self._measured_at)
            self._measured_at = now

    def update(self) -> None:
        """Find the modules with power, after a switch, an attachment or a battery has changed."""
        neighbours: dict[str, list[str]] = {}
        for first, second in self._attachments():
            neighbours.setdefault(first, []).append(second)
            neighbours.setdefault(second, []).append(first)
        self._groups.clear()
        powered: set[str] = set()
        sources = [*self._mains, *(name for name, battery in self.batteries.items() if not battery.empty)]
        for source in sources:
            if source in powered:
                continue
            group = _reached(source, neighbours)
            powered |= group
            drained = () if group & self._mains else tuple(name for name in sources if name in group)
            self._groups.append((tuple(name for name in self._switches if name in group), drained))
        self._tell_voltage()
        self._follow({name: on and name in powered for name, on in self._switches.items()})

    def _measure(self, dt: float) -> None:
        before = self._drawn
        self._drawn = {name: self._energy(name, dt) for name in self._switches}
        drawn = {name: energy - before[name] for name, energy in self._drawn.items()}
        cut_off = False
        for names, batteries in self._groups:
            left = sum(self.batteries[name].energy for name in batteries)
            power = sum(drawn[name] for name in names) / dt
            for name in batteries:
                battery = self.batteries[name]
                battery.drain(power * battery.energy / left if left else 0.0, dt)
                cut_off = cut_off or battery.empty
        for name in self.batteries.keys() - {name for _, batteries in self._groups for name in batteries}:
            self.batteries[name].drain(0.0, dt)
        self._tell_voltage()
        self._power = {name: energy / dt for name, energy in drawn.items()}
        self._state = None
        if cut_off:
            self.update()

    def _tell_voltage(self) -> None:
        """Give each servo module the voltage of what supplies it, which it reports."""
        for names, batteries in self._groups:
            voltage = self.batteries[batteries[0]].state().voltage if batteries else SUPPLY_VOLTAGE
            for name in names:
                if name in self._servos and voltage:
                    self._servos[name].supply = voltage

    def _energy(self, name: str, dt: float) -> float:
        """Joules that a part has drawn: its servo, and the pumps of its connectors."""
        for connector in self._pumps.get(name, ()):
            if _pumps(connector):
                self._pumped[name] += PUMP_POWER * dt
        servo = self._servos.get(name)
        return self._pumped[name] + (servo.energy if servo is not None else 0.0)


def _pumps(connector: SimulatedConnector) -> bool:
    """True while the pump of a connector runs: what a latch has locked needs no vacuum."""
    if not connector.enabled:
        return False
    state = connector.state()
    return state.powered and not state.latched


def _reached(source: str, neighbours: Mapping[str, list[str]]) -> set[str]:
    found, waiting = {source}, [source]
    while waiting:
        for name in neighbours.get(waiting.pop(), ()):
            if name not in found:
                found.add(name)
                waiting.append(name)
    return found
