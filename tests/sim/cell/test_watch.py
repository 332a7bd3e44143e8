"""What a watch measures in a cell, against all distances of all steps."""

from __future__ import annotations

import mujoco
import numpy as np
import pytest
from tests.helpers.cells import small_cell, weightless

from jauspy.geometry.poses import Pose
from jauspy_sim.assembly import TIMESTEP
from jauspy_sim.cell.watch import FAR
from jauspy_sim.models.groups import COLLISION

SPIN = {"straight": 0.0, "turning": 12.0}


@pytest.mark.parametrize("spin", SPIN.values(), ids=SPIN)
def test_the_clearance_is_the_smallest_of_all_steps(spin: float) -> None:
    cell = small_cell(["box_1", "box_2"])
    model, data = cell.model, cell.data
    names = [str(model.body(number).name) for number in range(model.nbody)]
    own = shapes(model, ["box_1"])
    around = shapes(model, ["box_2", *(name for name in names if name.startswith("cell/"))])
    start = int(model.joint("box_1").dofadr[0])
    reached = []
    with weightless(cell):
        for angle in np.linspace(0.0, 2.0 * np.pi, 8, endpoint=False).tolist():
            ahead = np.array([np.cos(angle), np.sin(angle), 0.0])
            cell.place("box_1", Pose(*(0.9 * ahead + (0.0, 0.0, 0.7)).tolist()))
            first, _ = cell.truth.watch_groups([["box_1"], ["box_2"]])
            data.qvel[start : start + 6] = [*(-0.7 * ahead), 0.0, spin, 0.0]
            nearest = FAR
            for _ in range(300):
                cell.advance(TIMESTEP)
                distances = [mujoco.mj_geomDistance(model, data, a, b, FAR, None) for a in own for b in around]
                nearest = min(nearest, *distances)
                assert first.clearance == pytest.approx(nearest, abs=1e-6)
            reached.append(nearest)
    assert min(reached) < 0.2, "it came near"


def shapes(model: mujoco.MjModel, bodies: list[str]) -> list[int]:
    """The numbers of the shapes of bodies that collide."""
    numbers = {int(model.body(name).id) for name in bodies}
    found = range(model.ngeom)
    return [geom for geom in found if int(model.geom_bodyid[geom]) in numbers and model.geom_group[geom] == COLLISION]
