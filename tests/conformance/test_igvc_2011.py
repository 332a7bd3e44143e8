"""Six tasks, sixty points."""

from __future__ import annotations

from itertools import groupby

import pytest
from tests.conformance.simulated import examined, robot

from jauspy.conformance import Profile, find


@pytest.mark.slow
def test_robot_gets_all_points():
    report = examined("igvc-2011", robot())
    assert [f"{each.id}: {each.reason}" for each in report.failures] == []
    assert report.points == (60, 60)
    assert report.status == 0


def test_each_task_has_ten_points():
    profile = find("igvc-2011")
    assert isinstance(profile, Profile)
    steps = sorted(profile.steps, key=lambda step: step.id[0])
    tasks = {task: sum(step.points for step in group) for task, group in groupby(steps, lambda step: step.id[0])}
    assert tasks == dict.fromkeys("123456", 10)
