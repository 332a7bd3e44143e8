"""Sessions without a simulation: their configuration, their judge, and films that cannot be made."""

from __future__ import annotations

import asyncio
import errno
import math
import os
from importlib import import_module
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from jauspy.cell import session, tasks
from jauspy.cell.measurements import Measured
from jauspy.cell.schedule import TaskFailed
from jauspy.cell.session import UNDISTURBED, Disturbances, Film, Session, configured
from jauspy.cell.tasks import FILMED_BY, TASKS, run_one
from jauspy.errors import ConfigError
from jauspy.testing import until


def test_the_seed_and_the_disturbances_are_those_of_the_run() -> None:
    cell = configured(7, Disturbances(0.004, 0.1, 0.25)).cell
    assert cell is not None
    assert (cell.seed, cell.sensor.seed) == (7, 7)
    assert cell.pose_error == (0.004, 0.1)
    assert cell.attach_failure == 0.25


def test_without_disturbances_nothing_is_off() -> None:
    cell = configured(0, UNDISTURBED).cell
    assert cell is not None
    assert cell.pose_error == (0.0, 0.0)
    assert cell.attach_failure == 0.0
    assert Disturbances().angle == pytest.approx(math.radians(5.0))


def test_a_robot_without_a_cell_is_named() -> None:
    with pytest.raises(ConfigError, match=r"the robot 'inc1' has no \[cell\]"):
        configured(0, UNDISTURBED, "inc1")


def test_true_poses_need_a_simulation_of_this_process() -> None:
    nothing: Any = None
    with pytest.raises(ConfigError, match="in a simulation of this process only; leave out --connect"):
        _ = Session(nothing, nothing).true
    judge: Any = object()
    assert Session(nothing, nothing, judge).true is judge


class TestFilm:
    def test_without_a_camera(self, tmp_path: Path) -> None:
        with pytest.raises(ConfigError, match="the cell has no camera to film with"):
            Film(tmp_path / "film.mp4", None)

    async def test_without_the_package(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        def missing(name: str) -> object:
            raise ImportError(name)

        monkeypatch.setattr(session, "import_module", missing)
        camera: Any = object()
        with pytest.raises(ConfigError, match="films need PyAV; install the extra 'video'"):
            await Film(tmp_path / "film.mp4", camera).__aenter__()

    async def test_a_file_that_cannot_be_written_is_named(self, tmp_path: Path) -> None:
        pytest.importorskip("av", reason="the extra 'video' is not installed")
        (tmp_path / "film.mp4").mkdir()
        (tmp_path / "file").touch()
        camera: Any = object()
        for path in (tmp_path / "film.mp4", tmp_path / "file" / "film.mp4"):
            with pytest.raises(ConfigError, match=r"film\.mp4 cannot be written: "):
                await Film(path, camera).__aenter__()

    async def test_a_complete_one_has_no_problem(self, tmp_path: Path) -> None:
        film = filming(tmp_path / "film.mp4", pictures=1000)
        async with film:
            await asyncio.sleep(0.2)
        assert film.problem == ""
        assert film.pictures == pictures_of(film.path) > 0

    async def test_one_whose_camera_fails_says_so_and_keeps_what_there_is(self, tmp_path: Path) -> None:
        film = filming(tmp_path / "film.mp4", pictures=2)
        async with film:
            await until(lambda: film.pictures == 2)
            await asyncio.sleep(0.1)
        assert film.problem == f"the film {film.path} is incomplete: it ends after 0.1 s: the GL context is lost"
        assert pictures_of(film.path) == 2

    async def test_a_full_disk_is_named_once(self, tmp_path: Path) -> None:
        film = filming(tmp_path / "film.mp4", pictures=1000)
        async with film:
            film._container = FullDisk(film._container)
            await asyncio.sleep(0.1)
        assert film.problem.endswith("[Errno 28] No space left on device")
        assert film.problem.count("incomplete") == 1

    async def test_an_error_of_the_program_says_it_too(self, tmp_path: Path) -> None:
        film = filming(tmp_path / "film.mp4", pictures=0)

        async def run() -> None:
            async with film:
                await asyncio.sleep(0.1)
                raise ZeroDivisionError

        with pytest.raises(ZeroDivisionError) as raised:
            await run()
        assert raised.value.__notes__ == [film.problem]


class Camera:
    """Gives so many pictures, and then fails."""

    def __init__(self, pictures: int) -> None:
        self.left = pictures

    def open(self) -> Any:
        return self

    def look(self, width: int, height: int, *, thoroughly: bool) -> Any:
        if not self.left:
            raise RuntimeError("the GL context is lost")
        self.left -= 1
        return SimpleNamespace(image=np.zeros((height, width, 3), np.uint8))

    def close(self) -> None:
        """Nothing is open."""


class FullDisk:
    """A film's file on a disk that is full."""

    def __init__(self, container: Any) -> None:
        self._container = container

    def mux(self, packet: object) -> None:
        raise import_module("av").error.OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    def close(self) -> None:
        self._container.close()
        self.mux(None)


def filming(path: Path, pictures: int) -> Film:
    pytest.importorskip("av", reason="the extra 'video' is not installed")
    camera: Any = Camera(pictures)
    return Film(path, camera, size=(64, 48))


def pictures_of(path: Path) -> int:
    with import_module("av").open(str(path)) as film:
        return sum(1 for _ in film.decode(video=0))


class Clock:
    """A cell that only has a clock."""

    def __init__(self) -> None:
        self.time = 5.0

    def now(self) -> float:
        return self.time


class Simulated:
    """Stands in for the simulated cell, and notes which camera was to film."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.cell, self.cameras = Clock(), list[str]()
        self.film: Any = None
        monkeypatch.setattr(tasks, "simulated", self)

    def __call__(self, seed: int, disturbances: object, *, film: object, camera: str, view: bool) -> Simulated:
        self.cameras.append(camera)
        return self

    async def __aenter__(self) -> Any:
        return Session(self.cell, None, film=self.film)

    async def __aexit__(self, *_: object) -> None:
        """Nothing is open."""


async def test_a_task_that_raises_is_a_failure_with_that_reason(monkeypatch: pytest.MonkeyPatch) -> None:
    simulated = Simulated(monkeypatch)

    async def fails(session: Session, seed: int) -> Measured:
        simulated.cell.time += 12.0
        raise TaskFailed("the part is lost")

    monkeypatch.setitem(TASKS, "lift", fails)
    found = await run_one("lift", 3)
    assert (found.seed, found.task, found.success, found.failure) == (3, "lift", False, "the part is lost")
    assert found.duration == 12.0
    assert found.cpu > 0.0


async def test_an_error_of_the_program_is_no_result(monkeypatch: pytest.MonkeyPatch) -> None:
    Simulated(monkeypatch)

    async def breaks(session: Session, seed: int) -> Measured:
        raise ZeroDivisionError

    monkeypatch.setitem(TASKS, "lift", breaks)
    with pytest.raises(ZeroDivisionError):
        await run_one("lift", 3)


@pytest.mark.parametrize("task", sorted(TASKS))
async def test_each_task_is_filmed_by_a_camera_that_the_cell_has(monkeypatch: pytest.MonkeyPatch, task: str) -> None:
    simulated = Simulated(monkeypatch)

    async def done(session: Session, seed: int) -> Measured:
        return Measured(seed, task, success=True)

    monkeypatch.setitem(TASKS, task, done)
    assert (await run_one(task, 1)).success
    assert simulated.cameras == [FILMED_BY.get(task, "overview")]


async def test_a_result_says_that_its_film_is_incomplete(monkeypatch: pytest.MonkeyPatch) -> None:
    simulated = Simulated(monkeypatch)
    simulated.film = SimpleNamespace(problem="the film lift.mp4 is incomplete")

    async def done(session: Session, seed: int) -> Measured:
        return Measured(seed, "lift", success=True)

    monkeypatch.setitem(TASKS, "lift", done)
    found = await run_one("lift", 1)
    assert found.success
    assert found.film_problem == "the film lift.mp4 is incomplete"
