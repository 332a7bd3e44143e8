"""How much of the search for joint positions client and arm do in one turn of their event loops, and when they end."""

from __future__ import annotations

from itertools import pairwise

import pytest

from jauspy.component.component import loop_time
from jauspy.geometry.kinematics import InverseKinematics, Solution
from jauspy.ocu import OCU
from jauspy.robot.runner import RobotRunner
from jauspy.services.manipulator.end_effector import SEARCH_PAUSE

MOST_STEPS = 10
"""Steps in one turn, by the table of bounds in ARCHITECTURE.md."""


@pytest.mark.slow
@pytest.mark.parametrize("rpy", [None, (0.0, 0.0, 0.0)])
async def test_a_search_leaves_the_event_loop_to_others(
    robot: RobotRunner, ocu: OCU, monkeypatch: pytest.MonkeyPatch, rpy: tuple[float, float, float] | None
) -> None:
    searches: dict[InverseKinematics, list[tuple[float, int]]] = {}
    advance = InverseKinematics.advance

    def noting(self: InverseKinematics, steps: int) -> Solution | None:
        searches.setdefault(self, []).append((loop_time(), steps))
        return advance(self, steps)

    monkeypatch.setattr(InverseKinematics, "advance", noting)
    inc1 = await ocu.robot(101)
    async with inc1.control("arm"):
        await inc1.arm.move_tool((0.6, 0.0, 0.6), rpy)
    client, arm = searches.values()
    assert all(steps <= MOST_STEPS for _, steps in (*client, *arm))
    assert all(later - sooner >= SEARCH_PAUSE - 1e-6 for (sooner, _), (later, _) in pairwise(arm))
    assert len(client) < len(arm), "that the pose can be reached is known before the shortest way to it"
