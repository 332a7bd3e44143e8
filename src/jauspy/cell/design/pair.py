"""Two arms on one base: built out of the same bins, commanded at the same time, and measured in the simulation.

Each arm is a component of its own. The arms go to their goals in rounds: to the first of each, to the second of each.
They move at the same time where no posture on the way of one comes near any on the way of the other.
"""

from __future__ import annotations

import asyncio
import math
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import zip_longest
from pathlib import Path
from typing import Final

from jauspy.cell.assembly import Assembler
from jauspy.cell.design.build import CAMERA, DesignRun, Use, Way
from jauspy.cell.design.chains import Element, posture
from jauspy.cell.design.search import Design, middle_lines, postures_between
from jauspy.cell.design.surroundings import furnished, set_up
from jauspy.cell.design.tasks import DesignTask, Goal
from jauspy.cell.frames import transform
from jauspy.cell.measurements import Measured
from jauspy.cell.scene import cell_of, pieces_of_part
from jauspy.cell.session import ROBOT, Session, simulated
from jauspy.cell.standing import all_frames
from jauspy.errors import ConfigError, JausError
from jauspy.platform.description import RobotModel
from jauspy.robot.config import ModuleConfig, RobotConfig

PLATFORM: Final = "platform_pair"
"""The type of a base for two arms."""
SECOND_ARM: Final = "arm_2"
KIND: Final = "CM-ARM"
APART: Final = 0.03
"""Metres between all that two arms pass from which on they move at the same time."""


@dataclass(frozen=True, slots=True)
class Pair:
    """A task for two arms, and their designs by the connectors that carry them."""

    task: DesignTask
    designs: Mapping[str, Design]


def with_two_arms(config: RobotConfig, base: str) -> RobotConfig:
    """The cell with a second modular arm; a base with one connector is exchanged for a platform for two.

    Raises `ConfigError`.
    """
    cell = config.cell
    if cell is None or base not in [part.name for part in cell.parts]:
        raise ConfigError(f"base {base!r}: is not a part of the cell")
    if len(cell.type_of(base).connectors) < 2:
        if PLATFORM not in cell.types:
            raise ConfigError(f"base {base!r}: has one connector, and the cell has no type {PLATFORM}")
        parts = (replace(part, type=PLATFORM) if part.name == base else part for part in cell.parts)
        cell = replace(cell, parts=tuple(parts))
    modules = list(config.modules)
    if not cell.second_arm:
        arms = [module for module in modules if module.type == KIND]
        if not arms:
            raise ConfigError(f"the cell has no {KIND}")
        node = arms[0].node
        last = max(module.component for module in modules if module.node == node)
        cell = replace(cell, second_arm=SECOND_ARM)
        modules.append(ModuleConfig(type=KIND, node=node, component=last + 1, part=SECOND_ARM))
    return config.model_copy(update={"cell": cell, "modules": modules})


async def build_pairs(
    pairs: Sequence[Pair],
    base: str,
    robot: str = ROBOT,
    *,
    load: float = 0.0,
    seed: int,
    film: Path | None = None,
    view: bool = False,
) -> list[Measured]:
    """Build, use and take apart the arms of each task, one task after the other; the results are those of each arm.

    `load` in kilograms at the tip of each arm. It ends with the first task that fails, since its parts are then not in
    their bins.
    """
    tasks, results = [pair.task for pair in pairs], list[Measured]()

    def change(model: RobotModel) -> RobotModel:
        return replace(model, cell=furnished(cell_of(model), tasks, base, load))

    configure = partial(with_two_arms, base=base)
    async with simulated(
        seed, film=film, camera=CAMERA, view=view, robot=robot, change=change, configure=configure
    ) as session:
        for number, pair in enumerate(pairs):
            begun, start = time.process_time(), session.cell.now()
            if number:
                set_up(session, tasks, number)
            found = [Measured(seed, pair.task.of(arm).name) for arm in pair.designs]
            results += found
            failure = ""
            try:
                await PairRun(session, pair, base, found, load).run()
            except JausError as error:
                failure = str(error)
            for one in found:
                one.failure = one.failure or failure
                one.success = not one.failure
                one.duration, one.cpu = session.cell.now() - start, time.process_time() - begun
            if failure:
                break
    if session.film is not None:
        results[-1].film_problem = session.film.problem
    return results


class PairRun:
    """Two designs on one base: built, used and taken apart. Figures go to `found`, one for each arm."""

    def __init__(self, session: Session, pair: Pair, base: str, found: Sequence[Measured], load: float) -> None:
        self._session, self._cell = session, session.cell
        self._tasks = [pair.task.of(arm) for arm in pair.designs]
        self._found = found
        self._ur10 = Assembler(session.cell, session.layout, seed=found[0].seed)
        self._runs = [
            DesignRun(session, task, design, f"{base}/{arm}", load=load, found=one, ur10=self._ur10)
            for task, (arm, design), one in zip(self._tasks, pair.designs.items(), found, strict=True)
        ]

    async def run(self) -> None:
        """Build both, go to all goals, and take both apart. Raises `JausError` when it cannot be done."""
        self._ur10.at = await self._cell.posture()
        for run in self._runs:
            await run.build()
        await self._ur10.park()
        uses = [await run.use() for run in self._runs]
        for use, watched in zip(uses, self._session.true.watch_groups([use.parts for use in uses]), strict=True):
            await use.begin(watched)
        begun, together, nearest = self._cell.now(), 0, math.inf
        rounds = list(zip_longest(*(task.goals for task in self._tasks)))
        for goals in rounds:
            apart = await self._round([(use, goal) for use, goal in zip(uses, goals, strict=True) if goal is not None])
            together += apart >= APART
            nearest = min(nearest, apart)
        span = self._cell.now() - begun
        for one in self._found:
            one.values |= {"rounds": float(len(rounds)), "rounds_together": float(together)}
            one.values |= {"time_of_both": span, "planned_apart": nearest}
        problems = []
        for use, one in zip(uses, self._found, strict=True):
            await self._see(uses)
            try:
                await use.finish()
            except JausError as error:
                one.failure = str(error)
                problems.append(error)
        if problems:
            raise problems[0]
        for run in reversed(self._runs):
            await run.take_apart()

    async def _round(self, work: Sequence[tuple[Use, Goal]]) -> float:
        """Go to the next goal of each arm; returns the distance between their ways, metres."""
        uses = [use for use, _ in work]
        await self._see(uses)
        ways = [await use.plan(goal) for use, goal in work]
        apart = self._apart(uses, ways) if len(ways) > 1 else -math.inf
        if apart >= APART:
            for outcome in await asyncio.gather(
                *(use.go(way) for use, way in zip(uses, ways, strict=True)), return_exceptions=True
            ):
                if isinstance(outcome, BaseException):
                    raise outcome
            return apart
        for use, goal in work:
            await self._see(uses)
            await use.go(await use.plan(goal))
        return apart

    async def _see(self, uses: Sequence[Use]) -> None:
        """Have each arm plan around the others, which stand where their joints and connectors report them."""
        frames = await all_frames(self._cell, self._session.layout)
        for use in uses:
            for name, frame in frames.items():
                if name not in use.parts:
                    use.arm.scene.put(name, pieces_of_part(self._session.layout.type_of(name)), frame)

    def _apart(self, uses: Sequence[Use], ways: Sequence[Way]) -> float:
        """Smallest distance between any postures on two ways, metres."""
        cell = self._session.layout.setup
        (first, way), (second, other) = zip(uses, ways, strict=True)
        rows = postures_between(other.path.points)
        passed = middle_lines(transform(second.arm.base), _elements(second), cell, rows, second.load)
        mount, elements = transform(first.arm.base), _elements(first)
        rows = postures_between(way.path.points)
        return min(posture(mount, elements, cell.types, q.tolist(), first.load).clearance_from(passed) for q in rows)


def _elements(use: Use) -> list[Element]:
    """The parts of an arm as they are joined."""
    return [
        Element(member.type.name, math.atan2(member.offset.rotation[1, 0], member.offset.rotation[0, 0]))
        for member in use.arm.members
    ]
