"""What the part sensor reports, against the simulation's true state."""

from __future__ import annotations

import math
from collections.abc import Sequence
from statistics import pstdev

import pytest

pytest.importorskip("mujoco")
pytest.importorskip("pinocchio", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)

from tests.helpers.cells import cell_model, put, small_cell

from jauspy.geometry.poses import Pose, Transform
from jauspy.platform.modular.cell import ObservedPart, PartSensor
from jauspy.platform.modular.parts import PartCamera, PartSensorSetup
from jauspy_sim.cell.robot import SimulatedCell

DOWN = math.pi / 2.0


def camera(height: float, x: float = 2.0, y: float = 0.0) -> PartCamera:
    """One above a place, that looks down."""
    return PartCamera("above", Pose(x, y, height, 0.0, DOWN, 0.0))


def boxes(cameras: Sequence[PartCamera], seed: int = 0) -> SimulatedCell:
    sensor = PartSensorSetup(5.0, seed=seed, cameras=tuple(cameras))
    cell = small_cell(["platform_1", "box_1", "servo_2"], sensor=sensor)
    put(cell, "box_1", Transform(position=(2.0, 0.0, 0.02)))
    put(cell, "servo_2", Transform(position=(2.3, 0.3, 0.02)))
    cell.advance(1.0)
    return cell


def seen(cell: SimulatedCell) -> dict[str, ObservedPart]:
    cell.advance(0.2)
    sensor = PartSensor.of(cell)
    assert sensor is not None
    return {part.name: part for part in sensor.state().parts}


def test_the_included_cell_sees_all_parts_at_the_start() -> None:
    model = cell_model()
    assert model.cell is not None
    cell = SimulatedCell.open(model, "cell")
    assert set(seen(cell)) == {part.name for part in model.cell.parts if not part.fixed}


def test_what_is_hidden_is_not_seen() -> None:
    cell = boxes([camera(2.0)])
    assert "box_1" in seen(cell)
    put(cell, "servo_2", Transform(position=(2.0, 0.0, 1.8)))  # close to the camera, and falling
    cell.advance(0.01)
    sensor = PartSensor.of(cell)
    assert sensor is not None
    sensor.step(cell.time + 1.0)  # type: ignore[attr-defined]
    assert {part.name for part in sensor.state().parts} == {"servo_2"}


def test_a_second_camera_sees_behind() -> None:
    cell = boxes([camera(2.0), PartCamera("beside", Pose(0.5, 1.5, 1.0, 0.0, 0.43, -0.785))])
    put(cell, "servo_2", Transform(position=(2.0, 0.0, 1.8)))
    cell.advance(0.01)
    sensor = PartSensor.of(cell)
    assert sensor is not None
    sensor.step(cell.time + 1.0)  # type: ignore[attr-defined]
    assert "box_1" in {part.name for part in sensor.state().parts}


@pytest.mark.parametrize("place", [(3.0, 0.0), (2.0, 0.8), (-1.0, 0.0)])
def test_what_is_outside_the_view_is_not_seen(place: tuple[float, float]) -> None:
    assert "box_1" not in seen(boxes([camera(2.0, *place)]))


@pytest.mark.slow
def test_what_is_too_far_is_not_seen() -> None:
    assert "box_1" in seen(boxes([camera(3.9)]))
    assert "box_1" not in seen(boxes([camera(4.3)]))


def spreads(height: float) -> tuple[float, float]:
    """Standard deviations across and along the view of the errors of the box."""
    cell = boxes([camera(height)], seed=5)
    x, z = [], []
    for _ in range(80):
        found = seen(cell)["box_1"].pose
        x.append(found.x)
        z.append(found.z)
    return pstdev(x), pstdev(z)


@pytest.mark.slow
def test_errors_grow_with_the_distance() -> None:
    """Across the view with the distance, along it with its square."""
    near, far = spreads(1.0), spreads(3.0)
    along, across, _ = camera(1.0).errors(3.0 - 0.04)
    assert far[0] == pytest.approx(across, rel=0.25)
    assert far[1] == pytest.approx(along, rel=0.25)
    assert 2.0 < far[0] / near[0] < 4.5
    assert 6.0 < far[1] / near[1] < 14.0


@pytest.mark.slow
def test_equal_seeds_see_the_same() -> None:
    first, same, other = (seen(boxes([camera(2.0)], seed))["box_1"].pose for seed in (1, 1, 2))
    assert first == same
    assert first != other
