"""Many robots behind several node managers, in virtual time: a short run of the benchmark."""

from __future__ import annotations

import pytest
from tools.bench import fleet


@pytest.mark.slow
async def test_fleet_is_discovered_controlled_handed_over_and_reports() -> None:
    few, many = [await fleet.run(robots, operators=2, gateways=2, seconds=1.0) for robots in (2, 4)]
    for row in (few, many):
        assert row.discovered_after < fleet.LIMIT
        assert row.controlled_after < 1.0
        assert row.handed_over_after < 1.0
        assert row.events >= row.events_expected
        ids = row.robots * fleet.COMPONENTS + 2
        assert row.tables["node manager: addresses"] < ids
        assert row.tables["node manager: components"] == row.robots // 2 * fleet.COMPONENTS
        assert row.tables["node manager: waiting messages"] == 0
    assert many.datagrams <= (1.0 + fleet.FLAT) * 2 * few.datagrams, "a robot more costs no more traffic"
    assert {phase: sizes[2] for phase, sizes in fleet.ratios([few, many]).items()} == dict.fromkeys(few.cpu, 1.0)
