"""Groups of goals: one that inc1 really drives to, and groups on a Dask cluster that loses a worker."""

from __future__ import annotations

import os
import signal
import sys
from functools import partial
from pathlib import Path

import pytest
from tests.helpers.trial_drives import driven

from jauspy.campaigns import run_parts
from jauspy.errors import ConfigError
from jauspy.geometry.poses import Pose
from jauspy.navigation_trials.results import Drive, GoalGroup, TrialPlan, TrialResults

ROOM = """<mujoco><worldbody>
  <geom type="plane" size="0 0 1"/>
  <geom type="box" pos="3.2 0 0.5" size="0.1 3.3 0.5"/><geom type="box" pos="-3.2 0 0.5" size="0.1 3.3 0.5"/>
  <geom type="box" pos="0 3.2 0.5" size="3.3 0.1 0.5"/><geom type="box" pos="0 -3.2 0.5" size="3.3 0.1 0.5"/>
  WALLS
</worldbody></mujoco>"""
CELL = '<geom type="box" pos="1 0 0.5" size="0.1 1 0.5"/><geom type="box" pos="-1 0 0.5" size="0.1 1 0.5"/>'
CELL += '<geom type="box" pos="0 1 0.5" size="1 0.1 0.5"/><geom type="box" pos="0 -1 0.5" size="1 0.1 0.5"/>'


def world(folder: Path, walls: str = "") -> str:
    path = folder / "room.xml"
    path.write_text(ROOM.replace("WALLS", walls))
    return str(path)


@pytest.mark.slow
def test_a_goal_in_a_room_is_reached(tmp_path: Path) -> None:
    pytest.importorskip("mujoco", reason="MuJoCo is not installed")
    pytest.importorskip("scipy", reason="needs the extra `planning`")
    from jauspy.navigation_trials.groups import drive_group

    plan = TrialPlan((world(tmp_path),), 1, 2, again=True)
    drive, again = drive_group(plan, next(plan.groups()))
    assert again.reached, again.error
    assert (drive.known, again.known) == (False, True)
    assert (again.start, again.goal, again.shortest) == (drive.start, drive.goal, drive.shortest)
    assert drive.reached, drive.error
    assert drive.contacts == {}
    assert 2.0 < drive.shortest < 9.0
    assert 0.8 < drive.way / drive.shortest < 1.5
    assert drive.plans >= 1
    assert drive.planning > 0.0
    assert drive.seconds > 2.0
    assert (drive.thing, drive.new_way, drive.new_way_planning) == ("", None, None)


@pytest.mark.slow
@pytest.mark.timeout(300)
def test_the_end_of_a_kerb_is_found_without_going_to_and_fro(monkeypatch: pytest.MonkeyPatch) -> None:
    """On a pavement, the goal on the road below: what was seen of the edge on one side stays known on the other."""
    pytest.importorskip("mujoco", reason="MuJoCo is not installed")
    pytest.importorskip("scipy", reason="needs the extra `planning`")
    from jauspy.navigation_trials import groups
    from jauspy.navigation_trials.goals import TrueMap

    monkeypatch.setitem(groups.STARTS, "street", Pose(3.93, -10.49, 0.1, yaw=-1.2))
    monkeypatch.setattr(TrueMap, "draw_goal", lambda self, here, _: self.goal_at(here, -1.65, -8.85))
    (drive,) = groups.drive_group(TrialPlan(("street",), 1, 2), GoalGroup("street", 0, 1))
    assert drive.reached, drive.error
    assert drive.contacts == {}
    assert drive.plans < 60


@pytest.mark.slow
def test_a_robot_that_is_shut_in_has_no_goal(tmp_path: Path) -> None:
    pytest.importorskip("mujoco", reason="MuJoCo is not installed")
    pytest.importorskip("scipy", reason="needs the extra `planning`")
    from jauspy.navigation_trials.groups import drive_group

    plan = TrialPlan((world(tmp_path, CELL),), 1, 2, blind=True)
    with pytest.raises(ConfigError, match=r"room\.xml has no goal that inc1 can reach from its start"):
        drive_group(plan, next(plan.groups()))


def killed_once(plan: TrialPlan, folder: str, group: GoalGroup) -> list[Drive]:
    """The drives of a group; the first attempt at one of them kills its worker."""
    mark = Path(folder) / "killed"
    if group.number == 3 and not mark.exists():
        mark.touch()
        os.kill(os.getpid(), signal.SIGKILL)
    return driven(plan, group)


@pytest.mark.slow
@pytest.mark.filterwarnings("default")  # of Dask, about its own processes
def test_the_groups_of_a_lost_worker_are_driven_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    distributed = pytest.importorskip("distributed", reason="needs jauspy[cell-cluster]")
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join([str(Path(__file__).parents[2]), *sys.path]))
    plan = TrialPlan(("yard", "house"), 40, 1)
    there = here = TrialResults(plan, ())
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
        work = partial(killed_once, plan, str(tmp_path))
        for drives in run_parts(work, there.missing(), cluster=cluster.scheduler_address):
            there = there.with_drives(drives)
    for group in here.missing():
        here = here.with_drives(driven(plan, group))
    assert (tmp_path / "killed").exists()
    assert there == here
