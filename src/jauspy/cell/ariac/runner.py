"""Runs one trial in a simulated cell, and measures it."""

from __future__ import annotations

import asyncio
import time
from functools import partial
from pathlib import Path
from typing import Final

from jauspy.cell.ariac import trial_file
from jauspy.cell.ariac.board import OrderBoard
from jauspy.cell.ariac.director import Director
from jauspy.cell.ariac.line import Line
from jauspy.cell.ariac.packer import Packer
from jauspy.cell.ariac.scoring import most_points
from jauspy.cell.ariac.trial_file import Trial
from jauspy.cell.ariac.workcell import changed
from jauspy.cell.measurements import Measured
from jauspy.cell.session import Disturbances, simulated
from jauspy.errors import JausError

TASK: Final = "ariac"
SPIN_UP: Final = 0.5
"""Seconds before the start in which the belt reaches its first speed."""


async def run_trial(
    trial: Trial,
    seed: int,
    disturbances: Disturbances | None = None,
    *,
    film: Path | None = None,
    view: bool = False,
) -> Measured:
    """Run a trial; it succeeds if every order was submitted in time with all its points, and in the order of priority.

    A trial that the cell cannot have raises `ConfigError`.
    """
    begun = time.process_time()
    cell_of_trial = partial(changed, trial=trial)
    async with simulated(seed, disturbances, film=film, view=view, configure=cell_of_trial) as session:
        await session.cell.observe()
        found = Measured(seed, TASK)
        async with Line(session) as line:
            for belt in trial.belt_speeds:
                if belt.when.time_condition == 0.0:
                    line.run(belt.speed)
                    await session.cell.sleep(SPIN_UP)
            async with Director(trial, session.true, session.layout, session.cell.now, line.run) as director:
                packer = Packer(session.cell, session.layout, director.board, seed=seed)
                packer.at = await session.cell.posture()
                try:
                    async with asyncio.timeout(trial.time_limit):
                        await packer.run()
                except TimeoutError:
                    found.failure = f"the time limit of {trial.time_limit:g} s is over"
                except JausError as error:
                    found.failure = str(error)
                found.duration = director.time()
        _measure(found, trial, director, packer)
    found.cpu = time.process_time() - begun
    if session.film is not None:
        found.film_problem = session.film.problem
    return found


async def run_seed(
    seed: int, disturbances: Disturbances | None = None, *, film: Path | None = None, view: bool = False
) -> Measured:
    """Run one of the trials that come with jauspy: seeds go through them one after the other."""
    names = trial_file.names()
    return await run_trial(trial_file.load(names[seed % len(names)]), seed, disturbances, film=film, view=view)


def _measure(found: Measured, trial: Trial, director: Director, packer: Packer) -> None:
    scores = {order.id: director.verdicts.get(order.id) for order in trial.orders}
    points = sum(verdict.score.total for verdict in scores.values() if verdict is not None)
    products = {order.id: len(order.products) for order in trial.orders}
    products |= {id: len(order.products) for id, order in director.board.orders.items()}
    most = sum(most_points(count) for count in products.values())
    if trial.attainable_points is not None:
        most = trial.attainable_points
    late = priority_violations(director.board)
    log = packer.log
    found.values = {
        "score": float(points),
        "most_points": float(most),
        "orders": float(len(trial.orders)),
        "submitted": float(len(director.verdicts)),
        "late_priority_orders": float(late),
        "dropped": float(len(director.dropped)),
        "turned_over": float(len(log.turned_over)),
        "rejected_by_test": float(len(log.rejected_by_test)),
        "removed": float(len(log.removed)),
        "clearance": packer.clearance.distance,
    }
    for id, verdict in scores.items():
        if verdict is not None:
            found.values[f"order_time {id}"] = verdict.order.duration
            found.values[f"score {id}"] = float(verdict.score.total)
    found.rows = [{"trial": trial.name, "challenges": list(trial.challenges)}]
    found.rows += [{"event": f"{event.time:6.1f} s: {event.what}"} for event in director.events]
    found.rows += [{"event": f"task: {line}"} for line in log.lines]
    if not found.failure:
        found.success = points >= most and not late
        if points < most:
            found.failure = f"{points} of {most} points"
        elif late:
            found.failure = f"{late} orders without priority were submitted before one with priority that was open"


def priority_violations(board: OrderBoard) -> int:
    """Orders without priority that were submitted while an order with priority was open."""
    orders = list(board.orders.values())
    return sum(
        1
        for order in orders
        if not order.priority
        and order.submitted is not None
        and any(
            urgent.announced < order.submitted and (urgent.submitted is None or urgent.submitted > order.submitted)
            for urgent in orders
            if urgent.priority
        )
    )
