"""Where robots are on the globe and on each other's maps."""

from __future__ import annotations

import asyncio
import math
from dataclasses import replace

import pytest

pytest.importorskip("fastapi", reason="needs the extra 'console'")

from jauspy.console.fleet_positions import FleetPositions, blended
from jauspy.console.geographic_frame import GeographicFrame, find_frame
from jauspy.geometry.geodesy import Geodetic, from_ned
from jauspy.testing import VirtualNetwork


async def test_a_robot_tells_where_its_frame_is(virtual_network: VirtualNetwork) -> None:
    async with virtual_network.robot() as _, virtual_network.ocu() as ocu:
        robot = await ocu.discover(101)
        frame, pose = await find_frame(ocu, robot)
        assert frame is not None
        assert pose is not None
        assert frame.to_globe(0.0, 0.0) == pytest.approx((38.593, -77.179), abs=1e-5)  # of inc1.toml
        assert frame.heading == pytest.approx(0.0, abs=0.01)
        positions = FleetPositions(ocu, lambda: {101: robot})
        positions.start()
        await asyncio.sleep(2.0)
        assert positions.frame(101) is not None
        assert positions.for_browser(101)["others"] == []
        assert positions.for_browser(102) == {}
        await positions.close()
        await positions.close()
        assert positions.frame(101) is None


def test_measurements_are_averaged_unless_the_frame_is_another_one() -> None:
    origin = Geodetic(math.radians(48.0), math.radians(11.0))
    known = GeographicFrame(origin, 0.1)
    near, far = (from_ned(origin, metres, 0.0, 0.0) for metres in (1.0, 500.0))
    latitude, longitude = blended(known, replace(known, origin=near)).to_globe(0.0, 0.0)
    assert math.hypot(*known.to_local(latitude, longitude)) == pytest.approx(0.05, abs=1e-3)
    assert blended(known, GeographicFrame(far, 1.0)).heading == 1.0
    assert blended(GeographicFrame(origin, 3.1), GeographicFrame(origin, -3.1)).heading == pytest.approx(
        3.104, abs=1e-3
    )
