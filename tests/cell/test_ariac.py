"""Trials in the simulated cell: faults are real in its physics, tasks recover, and the director judges true poses."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from pathlib import Path

import pytest

pytest.importorskip("mujoco", reason="needs the extra `sim`")

from jauspy.cell.ariac.packer import Packer
from jauspy.cell.ariac.runner import run_trial
from jauspy.cell.ariac.trial_file import Trial, load
from jauspy.cell.ariac.workcell import changed, is_flipped
from jauspy.cell.frames import se3
from jauspy.cell.interface import GRIPPER
from jauspy.cell.measurements import Measured
from jauspy.cell.scene import Layout
from jauspy.cell.session import UNDISTURBED, Session, simulated
from jauspy.platform.modular.connector import ConnectorError
from jauspy_sim.cell.robot import SimulatedCell

UPRIGHT = Packer._upright
TUBE = """
name = "one tube"
{more}
[[orders]]
id = "A"
tray = 1
products = [{{ type = "{type}", quadrant = 1 }}]
"""


@pytest.fixture
def trial(tmp_path: Path) -> Callable[[str, str], Trial]:
    def make(type: str, more: str = "") -> Trial:
        file = tmp_path / "trial.toml"
        file.write_text(TUBE.format(type=type, more=more))
        return load(str(file))

    return make


def run(trial: Trial, seed: int = 1) -> Measured:
    return asyncio.run(run_trial(trial, seed, UNDISTURBED))


def inside(trial: Trial, look: Callable[[Session], object]) -> None:
    """Call a coroutine function in the cell of a trial."""

    async def session() -> None:
        async with simulated(1, UNDISTURBED, configure=lambda config: changed(config, trial)) as found:
            await look(found)  # type: ignore[misc]  # a coroutine

    asyncio.run(session())


def robot_of(session: Session) -> SimulatedCell:
    robot = session.true._robot
    assert isinstance(robot, SimulatedCell)
    return robot


# --- faults are real ----------------------------------------------------------------------------------------------


@pytest.mark.slow
def test_a_flipped_part_lies_upside_down_in_the_physics_and_the_sensor_sees_it(trial: Callable[..., Trial]) -> None:
    async def look(session: Session) -> None:
        grasp = session.layout.type_of("tube_1").grasp
        seen = await session.cell.observe()
        for part, flipped in (("tube_1", True), ("tube_3", False)):
            assert is_flipped(session.true.pose(part), grasp) is flipped
            assert is_flipped(seen[part].pose, grasp) is flipped

    inside(trial("tube_long", 'flipped_parts = ["tube_1"]'), look)


@pytest.mark.slow
def test_a_blind_sensor_reports_nothing_new_and_the_client_knows_what_it_saw(trial: Callable[..., Trial]) -> None:
    async def look(session: Session) -> None:
        before = await session.cell.observe()
        session.true.faults.blind(3.0)
        await session.cell.sleep(0.5)
        time, _ = session.cell.latest("tube_1")
        robot_of(session).place("tube_1", session.layout.setup.parts[0].pose)
        await session.cell.sleep(2.0)
        assert session.cell.latest("tube_1")[0] == time, "no observation has come"
        assert session.cell.silence() > 2.0
        known = await session.cell.observe(fresh=True)
        assert known["tube_1"].pose.translation == pytest.approx(before["tube_1"].pose.translation, abs=1e-3)
        await session.cell.sleep(1.5)
        assert session.cell.silence() < 0.5
        await session.cell.observe(fresh=True)
        assert session.cell.latest("tube_1")[0] > time

    inside(trial("tube_long"), look)


@pytest.mark.slow
def test_a_gripper_that_vents_lets_its_part_fall_and_reports_why(trial: Callable[..., Trial]) -> None:
    async def look(session: Session) -> None:
        robot = robot_of(session)
        connector = robot.connectors[GRIPPER]
        above = robot.truth.connector(GRIPPER)
        robot.place("box_1", (above @ session.layout.type_of("box_1").grasp.inverse()).to_pose())
        await session.cell.enable(GRIPPER, True)
        await session.cell.sleep(0.5)
        assert (await session.cell.connector(GRIPPER)).attached_to == "box_1"
        height = session.true.pose("box_1").translation[2]
        session.true.faults.vent(GRIPPER)
        await session.cell.sleep(0.5)
        state = await session.cell.connector(GRIPPER)
        assert (state.attached_to, state.enabled) == ("", False)
        assert "the line leaks" in state.last_error
        assert session.true.pose("box_1").translation[2] < height - 0.1
        assert (connector.held, connector.state().error) == (None, ConnectorError.FAILED)
        session.true.faults.vent(GRIPPER)  # it holds nothing: no effect

    inside(trial("box"), look)


# --- the task recovers --------------------------------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.timeout(900)
@pytest.mark.parametrize(
    "name",
    [
        pytest.param("02_flipped_parts", marks=pytest.mark.long),
        pytest.param("05_sensor_blackout", marks=pytest.mark.long),
        "09_moving_belt",
    ],
)
def test_each_trial_reaches_all_points_that_can_be_had(name: str) -> None:
    found = run(load(name))
    assert found.success, found.failure
    values, has = found.values, load(name)
    assert values["score"] == values["most_points"]
    assert values["dropped"] == len(has.dropped_parts), "each drop took place"
    assert bool(has.flipped_parts) == bool(values["turned_over"])
    assert values["rejected_by_test"] == len(has.faulty_parts)


@pytest.mark.slow
@pytest.mark.timeout(300)
def test_equal_seeds_give_equal_trials(trial: Callable[..., Trial]) -> None:
    one = trial("tube_long", 'flipped_parts = ["tube_1", "tube_3", "tube_5"]')
    assert run(one, 4).comparable() == run(one, 4).comparable()


# --- and the judge sees it if it does not -------------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.timeout(300)
def test_a_part_that_nobody_turns_over_costs_its_point_and_the_bonus(
    trial: Callable[..., Trial], monkeypatch: pytest.MonkeyPatch
) -> None:
    flipped = trial("tube_long", 'flipped_parts = ["tube_1", "tube_3", "tube_5"]')
    assert run(flipped).values["score"] == 7.0

    monkeypatch.setattr(Packer, "_upright", lambda self, part: abs(UPRIGHT(self, part)))
    monkeypatch.setattr(Layout, "grasp", lambda self, part: se3(self.type_of(part).grasps[1]))
    found = run(flipped)
    assert (found.values["score"], found.values["turned_over"]) == (5.0, 0.0), "the director still sees its true pose"


@pytest.mark.slow
@pytest.mark.timeout(300)
def test_a_module_that_nobody_tests_costs_its_points(
    trial: Callable[..., Trial], monkeypatch: pytest.MonkeyPatch
) -> None:
    faulty = trial("x5_1_inline", 'faulty_parts = ["servo_6"]')
    assert run(faulty).values["score"] == 7.0

    async def passes(self: Packer, part: str) -> bool:
        return True

    monkeypatch.setattr(Packer, "_passes", passes)
    found = run(faulty)
    assert (found.values["score"], found.success) == (3.0, False), "only the tray is right"


@pytest.mark.slow
@pytest.mark.timeout(300)
def test_a_drop_that_nobody_notices_costs_its_points(
    trial: Callable[..., Trial], monkeypatch: pytest.MonkeyPatch
) -> None:
    drops = trial("wheel", '[[dropped_parts]]\ntype = "wheel"\ndelay = 1.0')
    assert run(drops).values["score"] == 7.0

    async def trust(self: Packer, part: str) -> None:
        return

    monkeypatch.setattr(Packer, "_check_held", trust)
    found = run(drops)
    assert (found.values["score"], found.values["dropped"], found.success) == (3.0, 1.0, False)
