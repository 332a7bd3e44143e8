"""Tasks one after the other: what stops a story, what it says, and that nothing in it is put in place by hand."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import pytest

pytest.importorskip("mujoco", reason="needs the extra `sim`")

from jauspy import backends
from jauspy.cell.assembly import Assembler
from jauspy.cell.client import CellClient
from jauspy.cell.disassembly import Disassembler
from jauspy.cell.judge import Judge, WatchedBackend
from jauspy.cell.measurements import Measured
from jauspy.cell.scene import Layout
from jauspy.cell.schedule import TaskFailed
from jauspy.cell.session import OCU_ID, UNDISTURBED, Session, configured, simulated
from jauspy.cell.slots import FIVE_JOINTS
from jauspy.cell.standing import standing_on
from jauspy.cell.story import Stage, tell
from jauspy.cell.tasks import BASE, STAGES, TASKS, run_one
from jauspy.robot import robot_files
from jauspy.robot.runner import RobotRunner
from jauspy.virtual.environment import VirtualTime
from jauspy.virtual.network import VirtualNetwork

Made = Callable[..., Session]


@pytest.fixture
def session() -> Made:
    """A session at a standstill; its judge, if any, has seen that these parts were written."""

    def made(*written: str, judged: bool = True) -> Session:
        cell: Any = SimpleNamespace(now=lambda: 4.0)
        judge: Any = SimpleNamespace(written=written) if judged else None
        layout: Any = None
        return Session(cell, layout, judge)

    return made


def stage(name: str, *, success: bool = True, error: str = "") -> Stage:
    async def run(_session: Session, seed: int) -> Measured:
        if error:
            raise TaskFailed(error)
        return Measured(seed, name, success, "" if success else "it missed", 2.0, values={"off": 0.5})

    return Stage(name, f"It does {name}", run)


class TestTelling:
    async def test_the_stages_are_told_as_they_go(self, session: Made) -> None:
        told = []
        found = await tell(
            session(), 3, [stage("a"), stage("b c")], lambda stage, found: told.append((stage.name, found))
        )
        assert [(name, found and found.success) for name, found in told] == [
            ("a", None),
            ("a", True),
            ("b c", None),
            ("b c", True),
        ]
        assert found.success
        assert found.failure == ""
        assert found.values == {"a.off": 0.5, "b_c.off": 0.5, "stages": 2.0}

    async def test_a_missed_goal_does_not_end_it_but_counts(self, session: Made) -> None:
        found = await tell(session(), 3, [stage("a", success=False), stage("b")])
        assert not found.success
        assert found.failure == "a: it missed"
        assert [row["success"] for row in found.rows] == [False, True]

    async def test_an_error_ends_it_and_names_what_was_not_begun(self, session: Made) -> None:
        found = await tell(session(), 3, [stage("a", error="no arm"), stage("b"), stage("c")])
        assert found.failure == "a: no arm; not begun: b, c"

    async def test_a_stage_that_does_not_end_ends_it_after_a_time(self, session: Made) -> None:
        async def run(_session: Session, _seed: int) -> Measured:
            await asyncio.Event().wait()
            raise AssertionError

        found = await tell(session(), 3, [stage("a"), Stage("b", "It waits", run), stage("c")], within=0.01)
        assert found.failure == "b: it has not ended within 0.01 s; not begun: c"

    async def test_a_timeout_within_a_stage_is_no_end_of_it(self, session: Made) -> None:
        async def run(_session: Session, _seed: int) -> Measured:
            raise TimeoutError("a fault of the task")

        with pytest.raises(TimeoutError, match="a fault of the task"):
            await tell(session(), 3, [Stage("a", "It fails", run)])

    async def test_what_was_put_in_place_is_a_failure(self, session: Made) -> None:
        found = await tell(session("servo_1", "box_2"), 3, [stage("a")])
        assert not found.success
        assert found.failure == "put in place by writing positions: servo_1, box_2"

    async def test_in_a_cell_elsewhere_nothing_is_known_of_that(self, session: Made) -> None:
        assert (await tell(session(judged=False), 3, [stage("a")])).success


def test_the_story_is_a_task_of_five_stages() -> None:
    assert [stage.name for stage in STAGES] == ["assemble", "lift", "step", "take apart", "car"]
    assert "demo" in TASKS


@pytest.mark.slow
@pytest.mark.parametrize("how", ["place", "qpos"])
def test_a_position_that_is_written_in_a_story_is_caught(how: str) -> None:
    """A fault that is put in: a stage moves a box by hand."""

    async def cheat(session: Session, seed: int) -> Measured:
        robot: Any = session.true._robot
        await session.cell.sleep(0.2)
        if how == "place":
            session.true.place("box_2", next(part.pose for part in session.layout.setup.parts if part.name == "box_1"))
        else:
            robot.data.qpos[int(robot.model.joint("box_2").qposadr[0]) + 1] += 0.01
        await session.cell.sleep(0.2)
        return Measured(seed, "cheat", success=True)

    async def honest(session: Session, seed: int) -> Measured:
        await session.cell.run_conveyor(0.2)
        await session.cell.sleep(0.5)
        return Measured(seed, "honest", success=True)

    async def told(*stages: Stage) -> Measured:
        async with simulated(0, UNDISTURBED) as session:
            return await tell(session, 0, stages)

    assert asyncio.run(told(Stage("honest", "", honest))).success
    found = asyncio.run(told(Stage("honest", "", honest), Stage("cheat", "", cheat)))
    assert not found.success
    assert found.failure == "put in place by writing positions: box_2"


@pytest.mark.slow
@pytest.mark.timeout(900)
def test_one_client_takes_apart_what_another_one_has_built() -> None:
    """Each client controls the cell in turn, as with --connect; the second one knows only what connectors report."""

    async def both() -> None:
        config = configured(2, UNDISTURBED)
        layout = Layout(robot_files.robot_model(config))
        backend = WatchedBackend(backends.find(config.backend))
        async with (
            VirtualNetwork(seed=2) as network,
            RobotRunner(config, network.transport, backend=backend, realtime=VirtualTime),
        ):
            assert backend.robot is not None
            judge = Judge(backend.robot)
            async with network.ocu(OCU_ID) as ocu, CellClient(ocu, config, layout) as cell:
                built = await Assembler(cell, layout).build(slots=FIVE_JOINTS[:2])
                assert built.failure == ""
            async with network.ocu("42.1.2") as ocu, CellClient(ocu, config, layout) as cell:
                assert [item.part for item in await standing_on(cell, layout, BASE)] == ["servo_1", "bracket_1"]
                ur10 = Assembler(cell, layout)
                ur10.at = await cell.posture()
                apart = await Disassembler(cell, layout, ur10).run(BASE)
                assert [row.part for row in apart.parts] == ["bracket_1", "servo_1"]
                again = await Assembler(cell, layout).build(slots=FIVE_JOINTS[:1])
                assert again.failure == "", "the module is found and controlled again"
            assert judge.attached() == {BASE: "servo_1"}
            assert judge.written == ()

    asyncio.run(both())


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.timeout(1800)
def test_the_whole_story_succeeds_and_nothing_is_written() -> None:
    found = asyncio.run(run_one("demo", 0))
    assert found.success, found.failure
    assert found.written == ()
    assert found.values["stages"] == len(STAGES)
