"""Clouds with anything in them, from a seed: a scene neither raises nor grows, and works afterwards as before."""

from __future__ import annotations

import math
import random
import struct
import tracemalloc

import numpy as np
import pytest
from tests.helpers.robot import described

from jauspy.cloud.stream import Cloud, decode
from jauspy.errors import DecodeError
from jauspy.geometry.poses import Transform
from jauspy.planning.scene import Scene, SceneSetup, Sweep, Unknown

CHOICES = (0.0, -0.0, 1.0, -1.0, 1e-45, 1e-30, 0.3, 999.9, 1e6, 3.4e38, -3.4e38, math.inf, -math.inf, math.nan)
SETUP = SceneSetup(voxel_size=0.05, size=(3.0, 3.0, 1.5), unknown=Unknown.FORBIDDEN)
MOUNT = Transform(position=(0.3, 0.0, 0.6))
MEMORY = 48 << 20
"""Bytes that one hostile cloud may need for a moment: those of 150,000 points, in a dozen arrays."""


def hostile_points(chance: random.Random) -> np.ndarray:
    """Points of one of many kinds, as they come out of a message."""
    kind = chance.randrange(7)
    count = chance.choice((0, 1, 2, 7, 1000, 20_000))
    numbers = np.random.default_rng(chance.randrange(1 << 30))
    if kind == 0:
        return numbers.choice(np.array(CHOICES, "<f4"), (count, 3))
    if kind == 1:
        return np.frombuffer(numbers.bytes(count * 24), "<f4").reshape(-1, 6)
    if kind == 2:
        return np.full((count, 3), chance.choice(CHOICES), "<f4")
    if kind == 3:
        return (numbers.normal(size=(count, 3)) * 10.0 ** chance.uniform(-40, 38)).astype("<f4")
    if kind == 4:
        return np.zeros((count, chance.choice((0, 1, 2))), "<f4")
    if kind == 5:
        return numbers.uniform(-2.0, 2.0, (count, 3)).astype("<f4")
    return np.zeros(count, "<f4")


def hostile_transform(chance: random.Random) -> Transform:
    position = tuple(chance.choice((*CHOICES, 0.1, 0.2)) for _ in range(3))
    rotation = Transform().rotation if chance.random() < 0.8 else ((chance.choice(CHOICES),) * 3,) * 3
    return Transform(rotation, position)  # type: ignore[arg-type]


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(3))
@pytest.mark.filterwarnings("error")
def test_hostile_clouds_neither_raise_nor_grow(seed: int) -> None:
    chance = random.Random(seed)
    _, model = described("inc1")
    scene = Scene(model.description, SETUP)
    memory = scene.summary().memory
    for number in range(30):
        odd = chance.random() < 0.3
        sweep = Sweep(
            sensor=f"sensor {chance.randrange(200)}",
            points=hostile_points(chance),
            mount=hostile_transform(chance) if odd else MOUNT,
            base=hostile_transform(chance) if odd else Transform(),
            time=chance.choice(CHOICES) if odd else 0.1 * number,
            postures=[
                {
                    joint: chance.choice((0.0, 1.0, -1e3, math.nan if odd else 2.0))
                    for joint in ("base_link_to_arm_link_1",)
                }
            ],
            empty=hostile_points(chance) if chance.random() < 0.3 else None,
            min_range=chance.choice((0.0, 0.2)),
        )
        scene.add(sweep)
        if number % 5 == 0:
            found = scene.obstacles()
            assert np.isfinite(found.voxels).all()
            assert len(found.voxels) <= np.prod(SETUP.shape)
    assert scene.summary().memory == memory
    assert len(scene.summary().sweeps) <= 64
    assert len(scene.counters) < 12
    # and afterwards it works as before
    scene.clear()
    wall = np.stack((np.full(1000, 1.0), np.linspace(-0.5, 0.5, 1000), np.zeros(1000)), axis=1)
    known = next(iter(scene.summary().sweeps))
    assert scene.add(Sweep(known, wall, MOUNT, Transform(), 0.0))
    assert len(scene.obstacles().voxels) >= 20


def test_a_cloud_of_a_million_points_costs_as_much_as_a_usual_one() -> None:
    scene = Scene(None, SETUP)
    points = np.random.default_rng(1).uniform(-3.0, 3.0, (1_000_000, 3)).astype("<f4")
    tracemalloc.start()
    try:
        assert scene.add(Sweep("big", points, MOUNT, Transform(), 0.0))
        _, peak = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert peak < MEMORY
    assert scene.counters["points beyond the most of a sweep"] == 850_000


@pytest.mark.parametrize("seed", range(3))
def test_damaged_messages_are_decoded_or_refused(seed: int) -> None:
    chance = random.Random(seed)
    scene = Scene(None, SETUP)
    valid = Cloud(struct.pack("<300f", *np.linspace(-1.0, 1.0, 300)), "chassis_camera_link", 1.0).encode()
    for _ in range(100):
        data = bytearray(valid)
        for _ in range(chance.randrange(1, 6)):
            data[chance.randrange(len(data))] = chance.randrange(256)
        try:
            cloud = decode(bytes(data[: chance.choice((len(data), len(data), chance.randrange(len(data))))]))
        except DecodeError:
            continue
        rows = np.frombuffer(cloud.points, "<f4").reshape(-1, cloud.values)
        scene.add(Sweep("camera", rows, MOUNT, Transform(), cloud.time))
    assert np.isfinite(scene.obstacles().voxels).all()
