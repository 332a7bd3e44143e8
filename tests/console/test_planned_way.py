"""The way and the costs of a navigator, as browsers get them."""

from __future__ import annotations

import asyncio
import base64
import json
from types import SimpleNamespace

import numpy as np
import pytest

pytest.importorskip("scipy", reason="planning needs scipy")

from jauspy.console.planned_way import PlannedWay, drawn_costs
from jauspy.geometry.poses import PlanarPose
from jauspy.messages.iop import ReportCostMap2D
from jauspy.planning.legs import PathPoint
from jauspy.planning.mobility import Mobility
from jauspy.planning.path_search import Path
from jauspy.planning.path_services import navigation_services
from jauspy.planning.terrain_cost import TerrainCost
from jauspy.testing import VirtualNetwork


def costs(rows: int, columns: int, count: int, width: float = 3.0) -> ReportCostMap2D:
    report = ReportCostMap2D
    cells = [report.CostDataRec(number % 256) for number in range(count)]
    return report(
        report.CostMap2DRec(rows, columns, width, 2.0),
        report.CostMap2DLocalPoseRec(1.0, 4.0, -0.5),
        report.CostDataList(cells),
    )


def test_a_cost_map_is_drawn_in_the_frame_of_the_map() -> None:
    drawn = drawn_costs(costs(2, 3, 6))
    assert drawn is not None
    assert (drawn["rows"], drawn["columns"], drawn["x"], drawn["y"], drawn["yaw"]) == (2, 3, 1.0, -4.0, 0.5)
    assert base64.b64decode(drawn["cells"]) == bytes(range(6))


@pytest.mark.parametrize("numbers", [(2, 3, 5), (65535, 65535, 6), (0, 0, 0), (2, 3, 6, 0.0)])
def test_a_map_whose_numbers_do_not_fit_together_is_not_drawn(numbers: tuple[int, int, int]) -> None:
    assert drawn_costs(costs(*numbers)) is None


def navigator() -> SimpleNamespace:
    """What reports of a navigator are made of: a way of 2 m on level ground."""
    cells = np.zeros((20, 30), bool)
    mobility = Mobility(0.4, 0.4, 0.3, step=0.08, flipper_step=0.2, up=0.5, down=0.5, side=0.3)
    terrain = TerrainCost(mobility, cells, ~cells, (-1.0, -1.0), 0.1)
    way = Path((PathPoint(0.0, 0.0), PathPoint(1.0, 2.0)), 2.0, 1, 0.0)
    return SimpleNamespace(path=way, terrain=terrain, correction=PlanarPose(), set_zones=lambda zones: None)


@pytest.mark.slow
async def test_the_navigator_of_a_robot_is_followed_and_forgotten(virtual_network: VirtualNetwork) -> None:
    async with virtual_network.robot("inc1"), virtual_network.ocu() as ocu:
        async with virtual_network.component("101.1.131", navigation_services(navigator())):
            robot = await ocu.discover(101)
            way = PlannedWay(lambda: robot)
            following = asyncio.create_task(way.run())
            await asyncio.sleep(3.0)
            message = json.loads(json.dumps(way.message()))
            assert message["path"] == [[0.0, 0.0], [1.0, 2.0]]
            assert message["costs"]["columns"] == 30
            version = way.version
            await asyncio.sleep(3.0)
            assert way.version == version, "browsers get changes only"
        await asyncio.sleep(60.0)
        assert way.message() == {"path": [], "costs": None}
        following.cancel()
