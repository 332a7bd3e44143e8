"""Search for the cheapest chain of modules that reaches the goals of a task, with what a cell has.

Chains are drawn at random, half of them as changes of the best one so far. Bounds that no posture escapes are tested
first; then goals are solved one after the other, and the first thing that fails is counted as the reason.
"""

from __future__ import annotations

import itertools
import math
import time
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Final

import numpy as np

from jauspy.cell.design.chains import ChainPosture, Element, mass_of, posture, servos
from jauspy.cell.design.tasks import DesignTask, Goal
from jauspy.errors import ConfigError
from jauspy.geometry.poses import Transform
from jauspy.geometry.vectors import GRAVITY, Z, rotation_about
from jauspy.platform.modular.holding import CUP, LATCH, SAFETY
from jauspy.platform.modular.parts import CellSetup, PartKind, PartType

MAX_BEND: Final = 2.0
"""Radians to which an elbow bends: further, what is mounted on it comes near the housing. Inline modules turn once."""
STARTS: Final = 6
ITERATIONS: Final = 60
LINE_STEPS: Final = 12
ORIENTATION_LENGTH: Final = 0.2
"""Metres that one radian counts in inverse kinematics."""
MAX_JOINTS: Final = 7
COSTS: Final = ("cyc", "qDist", "mass", "numJ")
"""CoBRA's abbreviations: s, rad, kg, and joints."""


@dataclass(frozen=True, slots=True)
class Design:
    """A chain that reaches all goals, with the positions of its joints at each, and its margins."""

    elements: tuple[Element, ...]
    positions: tuple[tuple[float, ...], ...]
    costs: Mapping[str, float]
    cost: float
    torque: float
    """Largest torque at rest, as a fraction of the module's."""
    moment: float
    """Largest load of a connector at rest, as a fraction of its strength."""
    clearance: float
    """Metres."""


@dataclass(slots=True)
class Found:
    """What a search has found: the best design, and why the other chains lost."""

    best: Design | None = None
    tried: int = 0
    reasons: Counter[str] = field(default_factory=Counter)


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
    elements: Sequence[Element], types: Mapping[str, PartType], positions: Sequence[Sequence[float]]
) -> dict[str, float]:
    """CoBRA's costs, with the goals reached in straight lines of the joints from zero, each at the limits of speed."""
    modules = servos(elements, types)
    time_, way = 0.0, 0.0
    before: Sequence[float] = [0.0] * len(modules)
    for row in positions:
        turns = [abs(b - a) for a, b in zip(before, row, strict=True)]
        time_ += max(turn / servo.max_speed for turn, servo in zip(turns, modules, strict=True))
        way += sum(turns)
        before = row
    return {"cyc": time_, "qDist": way, "mass": mass_of(elements, types), "numJ": float(len(modules))}


class Search:
    """An anytime search: equal seeds give equal results, unless `seconds` end it before `candidates` do."""

    def __init__(
        self, cell: CellSetup, task: DesignTask, base: str, *, load: float, weights: Mapping[str, float], seed: int
    ) -> None:
        """`base` is the connector that carries the chain, as in `platform_1/top`; `load` in kilograms at the tip."""
        self._types, self._task = cell.types, task
        self._load, self._weights = load, weights
        self.mount = mount_of(cell, base)
        self.stock = stock_of(cell)
        self._random = np.random.default_rng(seed)
        self._inline = [name for name in self.stock if self._axis(name) == 2]
        self._elbows = [name for name in self.stock if self._axis(name) == 1]
        self._passive = [name for name in self.stock if self._types[name].servo is None]
        self.found = Found()

    def run(self, candidates: int, seconds: float, note: Callable[[str], None] = lambda _: None) -> Found:
        """Try chains; `note` is told of each improvement."""
        end = time.monotonic() + seconds
        while self.found.tried < candidates and time.monotonic() < end:
            self.found.tried += 1
            elements = self._draw()
            result = self._evaluate(elements)
            if isinstance(result, str):
                self.found.reasons[result] += 1
            else:
                self.found.best = result
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
        best = self.found.best
        known = self._weights.get("mass", 0.0) * mass_of(elements, self._types)
        known += self._weights.get("numJ", 0.0) * len(servos(elements, self._types))
        if best is not None and known >= best.cost:
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
        weight = (mass_of(elements, self._types) + self._load) * GRAVITY
        held = LATCH.utilisation(self.mount.inverse().rotate((0.0, 0.0, weight)), (0.0, 0.0, 0.0))
        return "too heavy for the base's connector" if held > 1.0 / SAFETY else ""

    def _solve(self, elements: tuple[Element, ...]) -> Design | str:
        kinematics = _Kinematics(self.mount, elements, self._types)
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
        costs = costs_of(elements, self._types, rows)
        cost = sum(weight * costs[name] for name, weight in self._weights.items())
        if self.found.best is not None and cost >= self.found.best.cost:
            return "costs more than the best"
        return Design(elements, tuple(rows), costs, cost, *worst)

    def _margins(self, elements: Sequence[Element], positions: Sequence[float]) -> tuple[float, float, float]:
        found = posture(self.mount, elements, self._types, positions, self._load)
        return (*utilisation(found, elements, self._types), found.clearance(self._task.obstacles))


def utilisation(chain: ChainPosture, elements: Sequence[Element], types: Mapping[str, PartType]) -> tuple[float, float]:
    """Largest torque and largest connector load at rest, as fractions of the limits. The tip holds by suction alone."""
    torque = max(abs(t) / servo.max_torque for t, servo in zip(chain.torques(), servos(elements, types), strict=True))
    *latched, tip = chain.loads()
    return torque, max(CUP.utilisation(*tip), *(LATCH.utilisation(*load) for load in latched))


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
    elements: Sequence[Element],
    positions: Sequence[Sequence[float]],
    *,
    load: float,
) -> list[str]:
    """What is wrong with a solution, recomputed at its goals without the search; empty for a valid one."""
    wrong = []
    used, stock = Counter(element.type for element in elements), stock_of(cell)
    wrong += [f"{name}: {count} used, {stock[name]} in the cell" for name, count in used.items() if count > stock[name]]
    if wrong:
        return wrong
    if len(positions) != len(task.goals):
        return [f"{len(positions)} postures for {len(task.goals)} goals"]
    for goal, row in zip(task.goals, positions, strict=True):
        if len(row) != len(servos(elements, cell.types)) or not all(map(math.isfinite, row)):
            return [f"goal {goal.name}: its positions do not match the joints"]
        chain = posture(mount_of(cell, base), elements, cell.types, row, load)
        torque, moment = utilisation(chain, elements, cell.types)
        if not goal.met(chain.tip):
            wrong.append(f"goal {goal.name}: missed")
        if max(torque, moment) > 1.0 / SAFETY:
            wrong.append(f"goal {goal.name}: torque {torque:.2f}, connector {moment:.2f} of the limits")
        if chain.clearance(task.obstacles) <= 0.0:
            wrong.append(f"goal {goal.name}: collision")
    return wrong


class _Kinematics:
    """Forward and inverse kinematics of a chain, with matrices."""

    def __init__(self, mount: Transform, elements: Sequence[Element], types: Mapping[str, PartType]) -> None:
        self._fixed: list[Any] = []
        self._axes: list[Any] = []
        self.bounds: list[float] = []
        frame = mount
        for element in elements:
            part = types[element.type]
            frame = frame @ Transform(rotation_about(Z, element.turn))
            if part.servo is not None:
                self._fixed.append(_matrix(frame @ part.servo.joint))
                self._axes.append(np.array(part.servo.axis))
                self.bounds.append(math.pi if abs(part.servo.axis[2]) > 0.9 else MAX_BEND)
                frame = Transform()
            frame = frame @ next(iter(part.connectors.values()))
        self._tip = _matrix(frame)

    def solve(self, goal: Goal, start: Any) -> Any:
        """Joint positions that meet a goal, by damped least squares from `start`, or None."""
        target, q = _matrix(goal.pose), np.array(start, dtype=float)
        oriented = "Theta_R" in goal.tolerances
        for _ in range(ITERATIONS):
            tip, jacobian = self._forward(q)
            if goal.met(_transform(tip)):
                return q
            error = target[:3, 3] - tip[:3, 3]
            if oriented:
                turn = sum(np.cross(tip[:3, axis], target[:3, axis]) for axis in range(3)) / 2.0
                error = np.concatenate([error, ORIENTATION_LENGTH * turn])
            else:
                jacobian = jacobian[:3]
            square = jacobian @ jacobian.T + 1e-4 * np.eye(len(error))
            step = jacobian.T @ np.linalg.solve(square, error)
            q = np.clip(q + step * min(1.0, 0.5 / max(float(np.abs(step).max()), 1e-9)), *self._range())
        return None

    def _range(self) -> tuple[Any, Any]:
        high = np.array(self.bounds)
        return -high, high

    def _forward(self, q: Any) -> tuple[Any, Any]:
        frame, joints = np.eye(4), []
        for fixed, axis, angle in zip(self._fixed, self._axes, q, strict=True):
            frame = frame @ fixed
            joints.append((frame[:3, 3], frame[:3, :3] @ axis))
            frame = frame @ _rotation(axis, angle)
        tip = frame @ self._tip
        columns = [[*np.cross(axis, tip[:3, 3] - origin), *(ORIENTATION_LENGTH * axis)] for origin, axis in joints]
        return tip, np.array(columns).T


def _rotation(axis: Any, angle: float) -> Any:
    x, y, z = axis
    skew = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    matrix = np.eye(4)
    matrix[:3, :3] += math.sin(angle) * skew + (1.0 - math.cos(angle)) * skew @ skew
    return matrix


def _matrix(frame: Transform) -> Any:
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = frame.rotation, frame.position
    return matrix


def _transform(matrix: Any) -> Transform:
    a, b, c, _ = matrix.tolist()
    return Transform((tuple(a[:3]), tuple(b[:3]), tuple(c[:3])), (a[3], b[3], c[3]))
