"""Tasks over JAUS in the simulated cell, on virtual time."""

from __future__ import annotations

import asyncio
import threading
import time
from functools import partial

import numpy as np
import pytest

pytest.importorskip("mujoco", reason="needs the extra `sim`")

from jauspy.cell import session as session_module
from jauspy.cell.assembly import Assembler
from jauspy.cell.client import CellClient
from jauspy.cell.scene import Layout
from jauspy.cell.session import Disturbances, simulated
from jauspy.cell.slots import FIVE_JOINTS, AssemblyResult
from jauspy.cell.tasks import run_one
from jauspy.errors import ConfigError
from jauspy.ocu import OCU
from jauspy.platform.contract import Robot
from jauspy.robot import robot_files
from jauspy.virtual.environment import VirtualTime
from jauspy_sim.cell.robot import SimulatedCell


@pytest.mark.slow
def test_a_client_sees_the_parts_and_moves_the_arm() -> None:
    async def look() -> None:
        async with simulated(3, Disturbances()) as session:
            seen = await session.cell.observe()
            pose, true = seen["servo_1"].pose, session.true.pose("servo_1")
            assert len(seen) >= 30
            assert 0.0 < float(np.linalg.norm(pose.translation - true.translation)) < 0.002, "it is measured with noise"
            ur10 = Assembler(session.cell, session.layout)
            await ur10.park()
            assert await session.cell.posture() == pytest.approx(ur10.at, abs=0.005)

    asyncio.run(look())


@pytest.mark.slow
def test_equal_seeds_build_equally_to_the_last_bit() -> None:
    async def build() -> AssemblyResult:
        async with simulated(5) as session:
            return await Assembler(session.cell, session.layout, seed=5).build(slots=FIVE_JOINTS[:2])

    one, other = asyncio.run(build()), asyncio.run(build())
    assert one.failure == ""
    assert repr(one) == repr(other)


@pytest.mark.slow
def test_a_cell_that_is_watched_is_no_faster_than_the_clock(monkeypatch: pytest.MonkeyPatch) -> None:
    shown = []
    monkeypatch.setattr(SimulatedCell, "view", lambda _: shown.append("a window"))

    async def watch() -> tuple[float, float]:
        async with simulated(3, view=True) as session:
            begun, start = session.true.time, time.monotonic()
            await session.cell.sleep(0.3)
            return session.true.time - begun, time.monotonic() - start

    simulated_time, taken = asyncio.run(watch())
    assert shown == ["a window"]
    assert taken > simulated_time - 0.03


@pytest.mark.slow
def test_motions_of_a_cell_that_is_slower_than_the_clock_arrive(monkeypatch: pytest.MonkeyPatch) -> None:
    class SlowTime(VirtualTime):
        def __init__(self, robot: Robot) -> None:
            super().__init__(robot)
            self._step /= 3.0

    monkeypatch.setattr(session_module, "VirtualTime", SlowTime)

    async def move() -> None:
        async with simulated(3) as session:
            ur10 = Assembler(session.cell, session.layout)
            ur10.at = await session.cell.posture()
            await ur10.park()
            assert await session.cell.posture() == pytest.approx(ur10.at, abs=0.005)

    asyncio.run(move())


async def test_a_running_cell_is_kept_under_control_while_motions_are_planned(layout: Layout) -> None:
    config = robot_files.load("cell")
    client = CellClient(OCU("42.1.1"), config, layout, threads=True)
    renewed = threading.Event()
    asyncio.get_running_loop().call_later(0.01, renewed.set)
    assert await client.compute(partial(renewed.wait, 5.0))


@pytest.mark.slow
async def test_a_window_needs_a_display(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("DISPLAY", raising=False)
    monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
    with pytest.raises(ConfigError, match="there is no display"):
        await run_one("lift", 0, view=True)
