"""Carrying out a mission, against a list of waypoints that a test moves, on virtual time."""

from __future__ import annotations

import asyncio
from collections.abc import Coroutine
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

pytest.importorskip("nicegui", reason="needs the extra 'console'")

from jauspy.console.mission import Look, Mission, Step, Still, Wait, check_speed
from jauspy.console.mission_run import MissionRun, needs_run
from jauspy.console.panels.world import run_progress
from jauspy.console.route import Waypoint
from jauspy.errors import ConfigError
from jauspy.ocu.state import RobotPose
from jauspy.virtual.clock import VirtualClock

POINTS = (Waypoint(1.0, 0.0), Waypoint(2.0, 0.0), Waypoint(3.0, 0.0))


class FakeRoute:
    """A robot that takes `seconds` for each waypoint; `log` has what it was told, with the time."""

    def __init__(self, seconds: float = 2.0, stops_at: int = 99) -> None:
        self.log: list[tuple[float, object]] = []
        self.problem = ""
        self.is_paused = False
        self._seconds, self._stops_at = seconds, stops_at
        self._points: tuple[Waypoint, ...] = ()
        self._began = 0.0

    def _reached(self) -> int:
        return min(
            int((asyncio.get_running_loop().time() - self._began) / self._seconds), self._stops_at, len(self._points)
        )

    @property
    def active(self) -> int | None:
        reached = self._reached()
        return None if reached >= min(len(self._points), self._stops_at) else reached

    @property
    def pose(self) -> RobotPose:
        at = self._points[self._reached() - 1] if self._reached() else Waypoint(0.0, 0.0)
        return RobotPose(x=at.x, y=at.y, z=0.0, roll=0.0, pitch=0.0, yaw=0.0, time=None)

    async def look(self) -> None:
        pass

    async def start(self, points: tuple[Waypoint, ...], speed: float) -> None:
        self._points, self._began = points, asyncio.get_running_loop().time()
        self.log.append((self._began, ([point.x for point in points], speed)))

    async def set_speed(self, speed: float) -> None:
        self.log.append((asyncio.get_running_loop().time(), speed))


def run_of(route: FakeRoute, *steps: Step, folder: Path = Path("/nowhere"), robot: Any = None) -> MissionRun:
    mission = Mission(POINTS[: len(steps)], steps)
    assert needs_run(mission)
    return MissionRun(mission, route, robot, 0.5, folder=folder, note=lambda _: None)  # type: ignore[arg-type]


def on_virtual_time(work: Coroutine[Any, Any, None]) -> None:
    async def inside() -> None:
        with VirtualClock():
            await work

    asyncio.run(inside())


def test_the_list_is_divided_where_something_is_done() -> None:
    route = FakeRoute()
    run = run_of(route, Step(0.3), Step(1.0, Wait(seconds=4.0)), Step())

    async def work() -> None:
        began = asyncio.get_running_loop().time()
        await run.run()
        assert [(round(time - began), what) for time, what in route.log] == [
            (0, ([1.0, 2.0], 0.3)),
            (2, 1.0),
            (8, ([3.0], 0.5)),
        ]
        assert run.is_done

    on_virtual_time(work())


def test_a_robot_that_stops_on_the_way_ends_the_mission_and_waits() -> None:
    route = FakeRoute(stops_at=1)
    run = run_of(route, Step(0.3), Step(None, Wait(seconds=1.0)))

    async def work() -> None:
        with pytest.raises(ConfigError, match="the robot stopped on the way to waypoint"):
            await run.run()
        assert route.log[-1][1] == 0.0
        assert not run.is_done

    on_virtual_time(work())


def test_cancelling_lets_the_robot_wait() -> None:
    route = FakeRoute(seconds=100.0)
    run = run_of(route, Step(0.3))

    async def work() -> None:
        task = asyncio.create_task(run.run())
        await asyncio.sleep(5.0)
        task.cancel()
        await asyncio.wait({task})
        assert route.log[-1][1] == 0.0

    on_virtual_time(work())


def test_a_still_is_saved_under_a_name_of_letters_only(tmp_path: Path) -> None:
    class Camera:
        async def still(self) -> SimpleNamespace:
            return SimpleNamespace(content=b"\xff\xd8\xff", format="JPEG")

    robot = SimpleNamespace(id=7, name="../../etc/<b>", camera=lambda name: Camera())
    run = run_of(FakeRoute(seconds=0.01), Step(None, Still()), folder=tmp_path / "new", robot=robot)
    asyncio.run(run.run())
    (path,) = tmp_path.rglob("*.jpg")
    assert path.parent == tmp_path / "new"
    assert path.name.startswith("_etc_b_-")
    assert path.read_bytes() == b"\xff\xd8\xff"


def stopped(run: MissionRun) -> str:
    return run_progress(run, is_running=False, is_paused=False)[0]


def test_a_mission_that_is_stopped_where_the_robot_acts_says_so() -> None:
    run = run_of(FakeRoute(), Step(), Step(None, Wait(seconds=60.0)))

    async def work() -> None:
        task = asyncio.create_task(run.run())
        await asyncio.sleep(1.0)
        assert stopped(run) == "the mission was stopped before waypoint 1 of 2"
        await asyncio.sleep(9.0)
        task.cancel()
        await asyncio.wait({task})
        assert stopped(run) == "the mission was stopped at waypoint 2 of 2"

    on_virtual_time(work())


def test_a_mission_whose_action_fails_was_stopped_at_its_waypoint() -> None:
    robot = SimpleNamespace(components=())
    run = run_of(FakeRoute(), Step(None, Look(pan=0.5)), robot=robot)

    async def work() -> None:
        with pytest.raises(ConfigError, match="no camera that turns"):
            await run.run()
        assert stopped(run) == "the mission was stopped at waypoint 1 of 1"

    on_virtual_time(work())


def test_what_the_robot_does_not_have_is_told_before_it_drives() -> None:
    class Camera:
        def __init__(self, name: str | None) -> None:
            self.name = name

        async def check_still(self) -> None:
            if self.name not in (None, "front"):
                raise ConfigError(f"no camera is called {self.name}")

    robot = SimpleNamespace(components=(), camera=Camera)
    for step, problem in (
        (Step(None, Still(camera="rear")), "waypoint 2: no camera is called rear"),
        (Step(None, Look(pan=0.5)), "waypoint 2: this robot has no camera that turns, and the mission asks for a look"),
    ):
        run = run_of(FakeRoute(), Step(None, Still(camera="front")), step, robot=robot)
        with pytest.raises(ConfigError) as raised:
            asyncio.run(run.check())
        assert str(raised.value) == problem
    asyncio.run(run_of(FakeRoute(), Step(None, Still()), Step(0.3), robot=robot).check())


@pytest.mark.parametrize("speed", [1e-9, 0.0, -1.0, 5.1, float("nan")])
def test_a_speed_without_use_is_refused_in_a_sentence(speed: float) -> None:
    with pytest.raises(ConfigError, match=r"a speed is at least 0\.01 m/s and at most 5 m/s"):
        check_speed(speed)
