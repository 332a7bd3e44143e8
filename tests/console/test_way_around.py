"""Ways around obstacles in the tab World: from the map of the console to waypoints."""

from __future__ import annotations

from dataclasses import dataclass, field
from types import SimpleNamespace

import pytest
from tests.helpers.robot import described

pytest.importorskip("scipy", reason="planning needs scipy")

from jauspy.console.route import Waypoint
from jauspy.console.way_around import way_around
from jauspy.errors import ConfigError, RequestError
from jauspy.geometry.poses import PlanarPose
from jauspy.mapping.grid import OccupancyGrid
from jauspy.mapping.mapper import Mapper
from jauspy.ocu.state import RobotPose


@dataclass
class Shown:
    """What `way_around` reads of a world: a robot at the origin, and a wall at x = 2 m up to y = 1 m."""

    model: object = described("inc1")[1]
    pose: RobotPose | None = field(default_factory=RobotPose)
    mapping: SimpleNamespace | None = None

    def __post_init__(self) -> None:
        mapper = Mapper(OccupancyGrid(12.0, 0.1))
        mapper.grid.log_odds[:] = -2.0
        mapper.grid.log_odds[:70, 80] = 2.0
        mapper.path.append(PlanarPose())
        self.mapping = SimpleNamespace(mapper=mapper)


async def test_points_are_joined_around_what_the_map_shows() -> None:
    found = await way_around(Shown(), [Waypoint(4.0, 0.0), Waypoint(4.0, -3.0)])
    assert max(point.y for point in found) > 1.3, "past the end of the wall"
    assert (found[-1].x, found[-1].y) == (pytest.approx(4.0, abs=0.2), pytest.approx(-3.0, abs=0.2))
    assert any(abs(point.x - 4.0) < 0.2 and abs(point.y) < 0.2 for point in found)


async def test_waypoints_are_in_the_local_frame_which_may_have_drifted() -> None:
    shown = Shown()
    shown.mapping.mapper._correction = PlanarPose(0.5, 0.0, 0.0)
    found = await way_around(shown, [Waypoint(3.0, 0.0)])
    assert found[-1].x == pytest.approx(3.0, abs=0.2)


async def test_without_a_way_there_is_a_sentence() -> None:
    with pytest.raises(RequestError, match="choose a goal"):
        await way_around(Shown(), [Waypoint(2.05, 0.0)])


@pytest.mark.parametrize(("name", "text"), [("pose", "first scan"), ("mapping", "first scan"), ("model", "shape")])
async def test_what_is_not_known_is_named(name: str, text: str) -> None:
    shown = Shown()
    setattr(shown, name, None)
    with pytest.raises(ConfigError, match=text):
        await way_around(shown, [Waypoint(4.0, 0.0)])
