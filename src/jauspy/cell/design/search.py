"""Search for the cheapest chain of modules that reaches the goals of a task, with what a cell has.

Chains are drawn at random, half of them as changes of the best one so far. Bounds that no posture escapes are tested
first; then goals are solved one after the other, and the first thing that fails is counted as the reason.
"""

from __future__ import annotations

import itertools
import math
import time
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Final

import numpy as np

from jauspy.cell.design.chains import ChainPosture, Element, placed, posture, servos, total_mass
from jauspy.cell.design.kinematics import ChainKinematics
from jauspy.cell.design.loads import LoadedChain, TimedMotion
from jauspy.cell.design.tasks import DesignTask
from jauspy.cell.frames import Array
from jauspy.cell.motion import NoPath
from jauspy.errors import ConfigError
from jauspy.geometry.poses import Transform
from jauspy.geometry.vectors import GRAVITY
from jauspy.platform.modular.holding import SAFETY, Holding
from jauspy.platform.modular.parts import CellSetup, PartKind, PartType
from jauspy.platform.modular.trajectory import MotionError

STARTS: Final = 6
LINE_STEPS: Final = 12
MAX_JOINTS: Final = 7
COSTS: Final = ("cyc", "qDist", "mass", "numJ", "effort", "mechEnergy")
"""CoBRA's abbreviations: s, rad, kg, joints, N m s, and J."""


@dataclass(frozen=True, slots=True)
class Design:
    """A chain that reaches all goals, with the positions of its joints at each, and its margins."""

    elements: tuple[Element, ...]
    positions: tuple[tuple[float, ...], ...]
    durations: tuple[float, ...]
    """Seconds of the motion to each goal: the shortest that modules and connectors bear."""
    costs: Mapping[str, float]
    cost: float
    torque: float
    """Largest torque, at rest and in motion, as a fraction of the module's."""
    moment: float
    """Largest load of a connector, at rest and in motion, as a fraction of its strength."""
    clearance: float
    """Metres."""


@dataclass(slots=True)
class Found:
    """What a search has found: designs, and why the other chains lost."""

    designs: list[Design] = field(default_factory=list)
    """Each cheaper than the one before."""
    tried: int = 0
    reasons: Counter[str] = field(default_factory=Counter)

    @property
    def best(self) -> Design | None:
        """The cheapest design."""
        return self.designs[-1] if self.designs else None


@dataclass(frozen=True, slots=True)
class Neighbour:
    """Another arm on the same base: the parts that it uses, and all places that it passes."""

    used: Counter[str] = field(default_factory=Counter)
    """How many parts of each type."""
    middle_lines: Array = field(default_factory=lambda: np.empty((0, 3)))
    """Points of its middle lines in all postures on its way; shape (points, 3), metres."""

    @classmethod
    def of(cls, cell: CellSetup, base: str, design: Design, load: float = 0.0) -> Neighbour:
        """The arm of a design, with a load in kilograms, on its way from upright to all goals, and back."""
        upright = np.zeros(len(servos(design.elements, cell.types)))
        rows = [upright, *(np.array(row) for row in design.positions), upright]
        passed = middle_lines(mount_of(cell, base), design.elements, cell, postures_between(rows), load)
        return cls(Counter(element.type for element in design.elements), passed)


def postures_between(rows: Iterable[Array]) -> Iterator[Array]:
    """Postures on the straight joint motions between these ones, radians."""
    for start, goal in itertools.pairwise(rows):
        for share in np.linspace(0.0, 1.0, LINE_STEPS).tolist():
            yield start + share * (goal - start)


def middle_lines(
    mount: Transform, elements: Sequence[Element], cell: CellSetup, rows: Iterable[Array], load: float = 0.0
) -> Array:
    """Points of the middle lines of a chain and its load, in all these postures; shape (points, 3), metres."""
    postures = (posture(mount, elements, cell.types, q.tolist(), load) for q in rows)
    return np.array([point for found in postures for point, _ in found.points])


ALONE: Final = Neighbour()
"""None."""


def parse_costs(text: str) -> dict[str, float]:
    """Weights of CoBRA's costs, as in `mass,numJ_0.2`. Raises `ConfigError`."""
    weights: dict[str, float] = {}
    for term in text.split(","):
        name, _, weight = term.strip().partition("_")
        try:
            value = float(weight or 1.0)
        except ValueError:
            value = math.nan
        if name not in COSTS or not 0.0 <= value < math.inf:
            raise ConfigError(f"cost {term!r}: must be a name of {', '.join(COSTS)}, and _ with a weight, as in mass_2")
        weights[name] = weights.get(name, 0.0) + value
    return weights


def costs_of(
    elements: Sequence[Element],
    types: Mapping[str, PartType],
    positions: Sequence[Sequence[float]],
    motions: Sequence[TimedMotion] = (),
) -> dict[str, float]:
    """CoBRA's costs, with the goals reached in straight lines of the joints from zero.

    `motions` are the motions to them; without these, lower bounds: each at the limits of speed all the way.
    """
    modules = servos(elements, types)
    fastest, way = [], 0.0
    before: Sequence[float] = [0.0] * len(modules)
    for row in positions:
        turns = [abs(b - a) for a, b in zip(before, row, strict=True)]
        fastest.append(max(turn / servo.max_speed for turn, servo in zip(turns, modules, strict=True)))
        way += sum(turns)
        before = row
    return {
        "cyc": sum(motion.duration for motion in motions) if motions else sum(fastest),
        "qDist": way,
        "mass": total_mass(elements, types),
        "numJ": float(len(modules)),
        "effort": sum(motion.effort for motion in motions),
        "mechEnergy": sum(motion.energy for motion in motions),
    }


class Search:
    """An anytime search: equal seeds give equal results, unless `seconds` end it before `candidates` do."""

    def __init__(
        self,
        cell: CellSetup,
        task: DesignTask,
        base: str,
        *,
        load: float,
        weights: Mapping[str, float],
        seed: int,
        beside: Neighbour = ALONE,
    ) -> None:
        """`base` is the connector that carries the chain, as in `platform_1/top`; `load` in kilograms at the tip."""
        self._cell, self._base, self._types, self._task = cell, base, cell.types, task
        self._load, self._weights = load, weights
        self.mount = mount_of(cell, base)
        self._beside = beside
        self.stock = stock_of(cell) - beside.used
        self._random = np.random.default_rng(seed)
        self._inline = [name for name in self.stock if self._axis(name) == 2]
        self._elbows = [name for name in self.stock if self._axis(name) == 1]
        self._passive = [name for name in self.stock if self._types[name].servo is None]
        self.found = Found()

    def run(self, candidates: int, seconds: float, note: Callable[[str], None] = lambda _: None) -> Found:
        """Try chains, for `seconds` of CPU time at most; `note` is told of each improvement."""
        end = time.process_time() + seconds
        while self.found.tried < candidates and time.process_time() < end:
            self.found.tried += 1
            elements = self._draw()
            result = self._evaluate(elements)
            if isinstance(result, str):
                self.found.reasons[result] += 1
            else:
                self.found.designs.append(result)
                note(f"chain {self.found.tried}: cost {result.cost:.3f}, {len(elements)} parts")
        return self.found

    def _axis(self, name: str) -> int:
        servo = self._types[name].servo
        return -1 if servo is None else int(np.argmax(np.abs(servo.axis)))

    def _draw(self) -> tuple[Element, ...]:
        best = self.found.best
        if best is not None and self._random.random() < 0.5:
            elements = list(best.elements)
            place = int(self._random.integers(len(elements)))
            change = int(self._random.integers(3))
            if change == 0 and len(elements) > 1:
                del elements[place]
            elif change == 1:
                elements[place] = self._element(list(self.stock))
            else:
                elements.insert(place, self._element(self._passive or list(self.stock)))
            return tuple(elements)
        elements = []
        for joint in range(int(self._random.integers(2, MAX_JOINTS))):
            pool = self._inline if joint == 0 or self._random.random() < 0.3 else self._elbows
            elements.append(self._element(pool or self._inline or self._elbows))
            if self._passive and self._random.random() < 0.35:
                elements.append(self._element(self._passive))
        return tuple(elements)

    def _element(self, names: Sequence[str]) -> Element:
        name = names[int(self._random.integers(len(names)))]
        return Element(name, float(self._random.choice([0.0, math.pi / 2.0])))

    def _evaluate(self, elements: tuple[Element, ...]) -> Design | str:
        used = Counter(element.type for element in elements)
        if any(count > self.stock[name] for name, count in used.items()):
            return "not in the bins"
        if not servos(elements, self._types):
            return "no joint"
        known = self._weights.get("mass", 0.0) * total_mass(elements, self._types)
        known += self._weights.get("numJ", 0.0) * len(servos(elements, self._types))
        if self._reaches_best(known):
            return "costs more than the best"
        bound = self._bound(elements)
        if bound:
            return bound
        return self._solve(elements)

    def _bound(self, elements: tuple[Element, ...]) -> str:
        """What makes a chain impossible in any posture; empty if nothing does."""
        straight = posture(self.mount, elements, self._types, [0.0] * len(servos(elements, self._types)))
        middles = [self.mount.position, *(origin for origin, _ in straight.axes), straight.tip.position]
        reach = sum(math.dist(a, b) for a, b in itertools.pairwise(middles))
        for goal in self._task.goals:
            slack = sum(max(map(abs, limits)) for limits in goal.tolerances.values())
            if math.dist(goal.pose.position, self.mount.position) > reach + slack:
                return "too short"
        weight = (total_mass(elements, self._types) + self._load) * GRAVITY
        foot = strengths_of(self._cell, self._base, elements)[0]
        held = foot.utilisation(self.mount.inverse().rotate((0.0, 0.0, weight)), (0.0, 0.0, 0.0))
        return "too heavy for the base's connector" if held > 1.0 / SAFETY else ""

    def _solve(self, elements: tuple[Element, ...]) -> Design | str:
        kinematics = ChainKinematics(self.mount, placed(elements, self._types))
        rows: list[tuple[float, ...]] = []
        before = np.zeros(len(kinematics.bounds))
        worst = (0.0, 0.0, math.inf)
        for goal in self._task.goals:
            reason = "a goal cannot be reached"
            for start in range(STARTS):
                q = kinematics.solve(goal, before if start == 0 else self._random.uniform(-1.5, 1.5, len(before)))
                if q is None:
                    continue
                line = [tuple(before + (q - before) * step / LINE_STEPS) for step in range(1, LINE_STEPS + 1)]
                margins = [self._margins(elements, row) for row in line]
                torques, moments, clearances = zip(*margins, strict=True)
                torque, moment, clearance = max(torques), max(moments), min(clearances)
                if torque > 1.0 / SAFETY:
                    reason = "torque of a module"
                elif moment > 1.0 / SAFETY:
                    reason = "moment or force of a connector"
                elif clearance <= 0.0:
                    reason = "collision"
                else:
                    worst = (max(worst[0], torque), max(worst[1], moment), min(worst[2], clearance))
                    rows.append(line[-1])
                    before = q
                    break
            else:
                return reason
        if self._reaches_best(self._cost(costs_of(elements, self._types, rows))):
            return "costs more than the best"
        try:
            motions = self._motions(elements, rows)
        except NoPath:
            return "loads in motion"
        durations = tuple(motion.duration for motion in motions)
        costs = costs_of(elements, self._types, rows, motions)
        if self._reaches_best(cost := self._cost(costs)):
            return "costs more than the best"
        torque = max(worst[0], *(motion.torque for motion in motions))
        moment = max(worst[1], *(motion.connector for motion in motions))
        return Design(elements, tuple(rows), durations, costs, cost, torque, moment, worst[2])

    def _motions(self, elements: Sequence[Element], rows: Sequence[Sequence[float]]) -> list[TimedMotion]:
        """The shortest bearable motions from upright to each posture in turn; raises `NoPath` when there is none."""
        chain = loaded_chain(self._cell, self._base, elements, self._load)
        return [chain.shortest(start, goal) for start, goal in _pairs(rows)]

    def _cost(self, costs: Mapping[str, float]) -> float:
        return sum(weight * costs[name] for name, weight in self._weights.items())

    def _reaches_best(self, cost: float) -> bool:
        return self.found.best is not None and cost >= self.found.best.cost

    def _margins(self, elements: Sequence[Element], positions: Sequence[float]) -> tuple[float, float, float]:
        found = posture(self.mount, elements, self._types, positions, self._load)
        clearance = min(found.clearance(self._task.obstacles), found.clearance_from(self._beside.middle_lines))
        return (*utilisation(found, elements, self._cell, self._base), clearance)


def utilisation(chain: ChainPosture, elements: Sequence[Element], cell: CellSetup, base: str) -> tuple[float, float]:
    """Largest torque and largest connector load at rest, as fractions of the limits; `base` carries the chain."""
    modules = servos(elements, cell.types)
    torque = max(abs(t) / servo.max_torque for t, servo in zip(chain.torques(), modules, strict=True))
    holding = strengths_of(cell, base, elements)
    return torque, max(held.utilisation(*load) for held, load in zip(holding, chain.loads(), strict=True))


def strengths_of(cell: CellSetup, base: str, elements: Sequence[Element]) -> list[Holding]:
    """Strengths of the connectors, base to tip: latches where both sides have one. The tip holds by suction alone."""
    latches = [cell.type_of(base.partition("/")[0]).latch, *(cell.types[element.type].latch for element in elements)]
    pairs = itertools.pairwise([*latches, False])
    return [cell.limits.strength(latched=own and other) for own, other in pairs]


def loaded_chain(cell: CellSetup, base: str, elements: Sequence[Element], load: float) -> LoadedChain:
    """The dynamics of a design on a base's connector, with a load in kilograms."""
    latch = cell.type_of(base.partition("/")[0]).latch
    return LoadedChain.of(mount_of(cell, base), placed(elements, cell.types), load, cell.limits, base_latch=latch)


def mount_of(cell: CellSetup, connector: str) -> Transform:
    """Pose of a base's connector in the world. Raises `ConfigError`."""
    base, _, name = connector.partition("/")
    kind = cell.type_of(base)
    if kind.kind is not PartKind.BASE or name not in kind.connectors:
        raise ConfigError(f"base {connector!r}: must be a connector of a base, as in platform_1/top")
    placed = next(part for part in cell.parts if part.name == base)
    return Transform.from_pose(placed.pose) @ kind.connectors[name]


def stock_of(cell: CellSetup) -> Counter[str]:
    """How many servo modules, brackets and tubes of each type the cell has."""
    kinds = (PartKind.SERVO, PartKind.BRACKET, PartKind.TUBE)
    return Counter(part.type for part in cell.parts if cell.types[part.type].kind in kinds)


def check(
    cell: CellSetup,
    task: DesignTask,
    base: str,
    design: Design,
    *,
    load: float,
    beside: Neighbour = ALONE,
) -> list[str]:
    """What is wrong with a solution, recomputed at its goals and on the way; empty for a valid one."""
    elements, positions, durations = design.elements, design.positions, design.durations
    wrong = []
    used, stock = Counter(element.type for element in elements), stock_of(cell) - beside.used
    wrong += [f"{name}: {count} used, {stock[name]} in the cell" for name, count in used.items() if count > stock[name]]
    if wrong:
        return wrong
    if not len(positions) == len(durations) == len(task.goals):
        return [f"{len(positions)} postures and {len(durations)} durations for {len(task.goals)} goals"]
    for goal, row in zip(task.goals, positions, strict=True):
        if len(row) != len(servos(elements, cell.types)) or not all(map(math.isfinite, row)):
            return [f"goal {goal.name}: its positions do not match the joints"]
        chain = posture(mount_of(cell, base), elements, cell.types, row, load)
        torque, moment = utilisation(chain, elements, cell, base)
        if not goal.met(chain.tip):
            wrong.append(f"goal {goal.name}: missed")
        if max(torque, moment) > 1.0 / SAFETY:
            wrong.append(f"goal {goal.name}: torque {torque:.2f}, connector {moment:.2f} of the limits")
        if min(chain.clearance(task.obstacles), chain.clearance_from(beside.middle_lines)) <= 0.0:
            wrong.append(f"goal {goal.name}: collision")
    moving = loaded_chain(cell, base, elements, load)
    for goal, (start, end), duration in zip(task.goals, _pairs(positions), durations, strict=True):
        try:
            loads = moving.timed(start, end, duration)
        except MotionError as error:
            wrong.append(f"goal {goal.name}: {error}")
            continue
        if not loads.bearable:
            far = f"torque {loads.torque:.2f}, connector {loads.connector:.2f} of the limits"
            wrong.append(f"goal {goal.name}: in motion {far}")
    return wrong


def _pairs(positions: Sequence[Sequence[float]]) -> list[tuple[Any, Any]]:
    """Start and end of the motion to each posture, the first one from upright."""
    rows = [np.zeros(len(positions[0])), *(np.array(row) for row in positions)]
    return list(itertools.pairwise(rows))
