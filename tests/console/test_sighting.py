"""Where a camera looks and how far away is what is seen: angles, clouds, echoes and the floor."""

from __future__ import annotations

import math
import struct

import pytest

pytest.importorskip("nicegui", reason="the console needs the extra `console`")

from jauspy.console.conventions import Conventions
from jauspy.console.sighting import Lens, Sight, depth_along, echo_along, floor_along, shown
from jauspy.console.world import CLOUD_HEADER

LENS = Lens(math.radians(80.0), 2.0 * math.atan(math.tan(math.radians(40.0)) * 0.75))


def test_a_place_in_the_picture_is_a_direction() -> None:
    assert LENS.angles(0.5, 0.5) == (0.0, 0.0)
    assert LENS.angles(1.0, 0.5)[0] == pytest.approx(math.radians(40.0))
    assert LENS.angles(0.5, 0.0)[1] > 0.0, "upwards"
    assert LENS.ray(0.5, 0.5) == (1.0, 0.0, 0.0)
    x, y, z = LENS.ray(0.0, 1.0)
    assert x > 0.0 < y, "to the left is along y"
    assert z < 0.0
    assert math.hypot(x, y, z) == pytest.approx(1.0)


def test_a_width_has_the_share_of_the_picture_that_perspective_gives_it() -> None:
    whole = 2.0 * math.tan(math.radians(40.0))
    assert LENS.width_share(whole, 1.0) == pytest.approx(1.0)
    assert LENS.width_share(0.06, 2.0) == pytest.approx(0.06 / (2.0 * whole))


def cloud(link: str, *points: tuple[float, float, float]) -> bytes:
    name = link.encode()
    name += b" " * (-len(name) % 4)
    data = b"".join(struct.pack("<3f", *point) for point in points)
    return CLOUD_HEADER.pack(3, 3, len(name), len(points)) + name + data


def test_a_depth_camera_tells_the_median_of_what_is_near_the_ray() -> None:
    seen = cloud("arm_camera_link", (1.0, 0.0, 0.0), (1.1, 0.0, 0.0), (5.0, 0.0, 0.0), (1.0, 1.0, 0.0), (0.0, 0.0, 0.0))
    assert depth_along(seen, "arm_camera_link", (1.0, 0.0, 0.0)) == pytest.approx(1.1)
    assert depth_along(seen, "arm_camera_link", (0.0, 0.0, 1.0)) is None
    assert depth_along(seen, "other_link", (1.0, 0.0, 0.0)) is None


def test_the_nearest_echo_of_that_bearing_counts() -> None:
    echoes = [(4.0, 0.0), (3.0, 0.02), (1.0, 1.0), (-2.0, 0.0)]
    found = echo_along(echoes, (0.0, 0.0, 0.5), (1.0, 0.0, 0.0))
    assert found is not None
    assert found.distance == pytest.approx(3.0, abs=0.01)
    down = echo_along(echoes, (0.0, 0.0, 0.5), (0.6, 0.0, -0.8))
    assert down is not None
    assert down.distance == pytest.approx(5.0, abs=0.01), "along the ray, not along the floor"
    assert echo_along(echoes, (0.0, 0.0, 0.5), (0.0, -1.0, 0.0)) is None
    assert echo_along(echoes, (0.0, 0.0, 0.5), (0.0, 0.0, -1.0)) is None
    assert echo_along([], (0.0, 0.0, 0.5), (1.0, 0.0, 0.0)) is None


def test_the_floor_is_below() -> None:
    found = floor_along(0.0, (0.0, 0.0, 1.0), (0.6, 0.0, -0.8))
    assert found is not None
    assert found.distance == pytest.approx(1.25)
    assert floor_along(0.0, (0.0, 0.0, 1.0), (1.0, 0.0, 0.0)) is None
    assert floor_along(2.0, (0.0, 0.0, 1.0), (0.6, 0.0, -0.8)) is None
    page = Conventions()
    assert shown(Sight(1.25, "lidar"), 0.06, page) == "1.25 m (lidar), gripper 60 mm"
    page.set({"length": "ft"})
    assert shown(Sight(1.25, "lidar"), None, page) == "4.10 ft (lidar)"
