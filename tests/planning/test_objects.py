"""Things in clouds that are computed: surfaces, clusters, sizes, colours."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

pytest.importorskip("scipy", reason="scipy is not installed")

from jauspy.errors import ConfigError
from jauspy.planning.colours import HUES, is_coloured, main_colour
from jauspy.planning.objects import KNOWN, Wanted, choose, find_objects

GREEN, RED, GREY = (0.1, 0.6, 0.15), (0.8, 0.05, 0.05), (0.5, 0.5, 0.5)
NOISE = 0.0015


def surface(rng: Any, height: float, x: tuple[float, float], y: tuple[float, float]) -> Any:
    count = int(6000 * (x[1] - x[0]) * (y[1] - y[0]))
    return np.column_stack((rng.uniform(*x, count), rng.uniform(*y, count), rng.normal(height, NOISE, count)))


def seen_box(rng: Any, centre: Any, size: Any, yaw: float) -> Any:
    """The top and two sides of a box."""
    inner = rng.uniform(-0.5, 0.5, (6000, 3)) * size
    side = rng.integers(0, 3, len(inner))
    inner[side == 0, 2] = size[2] / 2.0
    inner[side == 1, 0] = -size[0] / 2.0
    inner[side == 2, 1] = -size[1] / 2.0
    c, s = math.cos(yaw), math.sin(yaw)
    turned = inner @ np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])
    return turned + centre + rng.normal(0.0, NOISE, inner.shape)


def scene(seed: int, colour: Any = GREEN, yaw: float = 0.4) -> tuple[Any, Any]:
    """A floor, a table 0.3 m high, and a box of 8 x 6 x 10 cm on it."""
    rng = np.random.default_rng(seed)
    parts = [surface(rng, 0.0, (0.4, 1.8), (-0.8, 0.8)), surface(rng, 0.3, (0.7, 1.2), (-0.4, 0.4))]
    box = seen_box(rng, np.array((0.9, 0.1, 0.35)), np.array((0.08, 0.06, 0.1)), yaw)
    points = np.concatenate((*parts, box))
    colours = np.tile(GREY, (len(points), 1))
    colours[-len(box) :] = colour
    return points, colours


@pytest.mark.parametrize("seed", range(4))
def test_a_box_on_a_table_is_found_with_its_size_direction_and_surface(seed: int) -> None:
    (thing,) = find_objects(*scene(seed))
    assert math.dist(thing.centre, (0.9, 0.1, 0.35)) < 0.01
    assert thing.size == pytest.approx((0.08, 0.06, 0.1), abs=0.01)
    assert math.remainder(thing.yaw - 0.4, math.pi) == pytest.approx(0.0, abs=math.radians(6.0))
    assert thing.support.at(0.9, 0.1) == pytest.approx(0.3, abs=0.004)
    assert thing.has_seen_support
    assert thing.colour == "green"


@pytest.mark.parametrize("yaw", [0.1, math.pi / 4.0])
@pytest.mark.parametrize("height", [0.04, 0.02])
def test_the_top_of_a_thing_at_the_height_of_a_surface_beside_it_is_a_part_of_the_thing(
    yaw: float, height: float
) -> None:
    rng = np.random.default_rng(5)
    bar = seen_box(rng, np.array((0.8, -0.3, height / 2.0)), np.array((0.22, 0.04, height)), yaw)
    shelf = surface(rng, height, (0.7, 1.2), (0.1, 0.7))
    points = np.concatenate((surface(rng, 0.0, (0.4, 1.8), (-0.8, 0.1)), shelf, bar))
    colours = np.tile(GREY, (len(points), 1))
    colours[-len(bar) :] = GREEN
    for hue in ("", "green"):
        (thing,) = find_objects(points, colours, hue)
        assert thing.size == pytest.approx((0.22, 0.04, height), abs=0.012)
        assert math.dist(thing.centre[:2], (0.8, -0.3)) < 0.01
        assert thing.support.at(0.8, -0.3) == pytest.approx(0.0, abs=0.004)


def test_only_things_of_the_colour_are_found() -> None:
    points, colours = scene(1)
    assert find_objects(points, colours, "red") == []
    (thing,) = find_objects(points, colours, "green")
    assert thing.colour == "green"


def test_the_thing_that_is_wanted_is_chosen_by_name_colour_or_place() -> None:
    things = find_objects(*scene(2))
    assert choose(things, Wanted("box")) is things[0]
    assert choose(things, Wanted(colour="green")) is things[0]
    assert choose(things, Wanted(near=(0.92, 0.08, 0.3))) is things[0]
    assert choose(things, Wanted("can")) is None
    assert choose(things, Wanted("bar", colour="green")) is None  # green, but no bar
    assert choose(things, Wanted(near=(1.3, 0.1, 0.3))) is None
    assert choose([], Wanted("box")) is None


def test_numbers_that_are_none_and_empty_clouds_give_no_things() -> None:
    points, colours = scene(3)
    points[:50] = np.nan
    points[50:60] = np.inf
    points[60:70] = 1e15
    assert len(find_objects(points, colours)) == 1
    assert find_objects(np.empty((0, 3))) == []
    assert find_objects(np.full((100, 3), np.nan)) == []


@pytest.mark.parametrize(
    ("wanted", "text"),
    [
        ({"name": "spoon"}, "no known thing; there are: can, box"),
        ({"colour": "beige"}, "no known colour; there are: red"),
        ({}, "name what is to be grasped"),
    ],
)
def test_what_cannot_be_wanted_is_told(wanted: dict[str, str], text: str) -> None:
    with pytest.raises(ConfigError, match=text):
        Wanted(**wanted)


def test_colours_have_one_name_in_bright_and_dim_light() -> None:
    tints = {"red": RED, "green": GREEN, "blue": (0.08, 0.2, 0.8), "yellow": (0.85, 0.75, 0.05)}
    tints |= {"orange": (0.9, 0.4, 0.03), "purple": (0.45, 0.08, 0.6)}
    assert set(tints) == set(HUES)
    for name, tint in tints.items():
        for light in (1.0, 0.6, 0.35):
            row = light * np.array([tint])
            assert [other for other in HUES if is_coloured(row, other)[0]] == [name]
    assert main_colour(np.array([GREY, (1.0, 1.0, 1.0), (0.0, 0.0, 0.0)])) == ""
    assert all(known.colour in HUES for known in KNOWN.values())
