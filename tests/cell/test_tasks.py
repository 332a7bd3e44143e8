"""Each task over JAUS in the simulated cell, once: what the physics saw of it, and what its film shows."""

from __future__ import annotations

import asyncio
from dataclasses import dataclass, field

import numpy as np
import pytest

pytest.importorskip("mujoco", reason="needs the extra `sim`")

from tests.helpers.films import camera_of, is_shown

from jauspy.cell.measurements import Measured
from jauspy.cell.physics import GENTLE_FORCE, GENTLE_SPEED, Physics
from jauspy.cell.session import Session
from jauspy.cell.tasks import FILMED_BY, TASKS, run_one
from jauspy.platform.camera import CameraSetup
from jauspy.platform.description import RobotModel

PERIOD = 0.2
"""Seconds between two looks at what moves."""
MOVED = 0.05
"""Metres from where something was at the start; less is no motion that a film shows."""
SEEDS = {"assemble": 1, "lift": 1, "step": 1, "kitting": 1, "kitting-arm": 0, "car": 0}


@dataclass
class Watched:
    """A run of a task, and where the bodies of the simulation were."""

    names: list[str] = field(default_factory=list)
    places: list[np.ndarray] = field(default_factory=list)
    """Of each body, metres, at each look."""
    found: Measured = field(init=False)


def watched(task: str) -> Watched:
    """Run a task."""
    made = Watched()

    async def run(session: Session, seed: int) -> Measured:
        robot = session.true._robot
        bodies = [number for number in range(1, robot.model.nbody) if robot.model.body_mass[number] > 0.01]
        made.names += [str(robot.model.body(number).name) for number in bodies]

        async def look() -> None:
            while True:
                made.places.append(robot.data.xipos[bodies].copy())
                await session.cell.sleep(PERIOD)

        looking = asyncio.create_task(look())
        found = await TASKS[task](session, seed)
        looking.cancel()
        return found

    made.found = asyncio.run(run_one(task, SEEDS[task], run=run))
    return made


def assert_gentle(task: str, physics: Physics) -> None:
    """Connectors hold, and meet what they attach gently; the UR10 takes nothing for something in its way."""
    assert max(load.utilisation for load in physics.loads) < 1.0
    assert len(physics.attaches) >= (18 if task == "car" else 1)
    meetings = [*physics.attaches, *(physics.landings if task == "car" else [])]
    assert [each for each in meetings if each.speed > GENTLE_SPEED or each.force > GENTLE_FORCE] == []
    assert physics.stops == 0
    if task != "car":
        assert physics.collisions == []


def assert_filmed(camera: CameraSetup, run: Watched) -> None:
    """All that moves is in the picture, from the beginning to the end."""
    places = np.array(run.places)
    moved = np.flatnonzero(np.linalg.norm(places - places[0], axis=2).max(axis=0) > MOVED)
    assert len(moved) > 5
    cut = {
        run.names[number]
        for number in moved
        for point in places[:, number]
        if run.names[number] != "belt" and not is_shown(camera, point)
    }
    assert cut == set()


@pytest.mark.slow
@pytest.mark.timeout(900)
@pytest.mark.parametrize("task", SEEDS)
def test_it_succeeds_gently_and_is_in_its_film(model: RobotModel, task: str) -> None:
    run = watched(task)
    assert run.found.success, run.found.failure
    assert run.found.physics is not None
    assert_gentle(task, run.found.physics)
    if task in FILMED_BY:
        assert_filmed(camera_of(model, FILMED_BY[task]), run)
