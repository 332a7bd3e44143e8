"""Drives of trials of navigation, as they would have been measured, without physics."""

from __future__ import annotations

from typing import Any

from jauspy.navigation_trials.results import Drive, GoalGroup, TrialPlan


def drive(world: str = "yard", group: int = 0, number: int = 0, **changes: Any) -> Drive:
    """A drive of 4.4 m where 4 m would have been the shortest way."""
    values: dict[str, Any] = {
        "start": (0.0, 0.0, 0.0),
        "goal": (3.0, -2.0),
        "end": (2.9, -2.0, 0.02, 0.0, 0.0, 0.5),
        "error": "",
        "way": 4.4,
        "shortest": 4.0,
        "contacts": {},
        "plans": 1,
        "thing": "",
        "new_way": None,
        "new_way_planning": None,
        "seconds": 11.0,
        "planning": 0.12,
        "cpu": 20.0,
    }
    return Drive(world, group, number, **{**values, **changes})


def driven(plan: TrialPlan, group: GoalGroup) -> list[Drive]:
    """In place of `drive_group`: each goal is reached, with figures that depend on its place alone."""
    return [
        drive(
            *(group.world, group.number, number),
            way=4.0 + 0.1 * group.number + 0.01 * number,
            known=number >= group.goals,
        )
        for number in range(plan.drives(group))
    ]
