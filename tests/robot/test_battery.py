"""The battery of a whole robot: what empties it, who is told, and that motors stop when it is empty."""

from __future__ import annotations

import asyncio
import logging

import pytest
from tests.helpers.robot import described
from tests.robot.workcell import BACKENDS, Workcell

from jauspy.backends import find
from jauspy.errors import ControlRejected, RequestError
from jauspy.messages.ugv import (
    QueryPowerPlantCapabilities,
    QueryPowerPlantConfiguration,
    QueryPowerPlantStatus,
    ReportPowerPlantConfiguration,
    SetPowerPlantConfiguration,
)
from jauspy.platform.battery import Battery
from jauspy.platform.lights import lamps_of
from jauspy.robot import robot_files


@pytest.fixture(params=BACKENDS)
def robot(request):
    _, model = described("inc1")
    made = find(request.param).open(model, "empty")
    yield made
    made.close()


def power(robot, seconds: float) -> float:
    """Mean power in watts of some seconds."""
    battery = Battery.of(robot)
    before, begun = battery.state().energy, robot.time
    for _ in range(round(seconds / 0.01)):
        robot.advance(0.01)
    return (before - battery.state().energy) / (robot.time - begun)


@pytest.mark.slow
def test_driving_lamps_and_arms_take_power(robot):
    battery = Battery.of(robot)
    if battery is None:
        pytest.skip("a real robot has a battery of its own")
    setup = battery.setup
    robot.advance(0.1)
    rest = power(robot, 1.0)
    assert setup.base_load + 2 * setup.camera_load <= rest < setup.base_load + 2 * setup.camera_load + 5.0
    for lamp in lamps_of(robot):
        lamp.set(1.0)
    lit = power(robot, 1.0)
    assert lit - rest == pytest.approx(2600.0 / setup.lamp_efficacy, abs=2.0)
    robot.drive.set_effort(1.0, 0.0)
    power(robot, 2.0)
    assert power(robot, 2.0) - lit > 15.0  # the kinematic robot has no friction of tracks
    robot.drive.stop()


def test_a_robot_without_that_table_has_no_battery():
    config = robot_files.load("inc1").model_copy(update={"battery": None})
    robot = find("kinematic").open(robot_files.robot_model(config), "empty")
    assert Battery.of(robot) is None
    robot.close()


@pytest.fixture
def master():
    made = Workcell("kinematic", "inc1", 110)
    yield made
    made.robot.close()


def test_the_power_plant_is_reported(master):
    master.run(1.0)
    (row,) = master.ask(QueryPowerPlantStatus([])).power_plant_status_list
    (battery,) = row.power_plant_status_var.battery_status
    assert row.power_plant_desc_rec.power_plant_id == 1
    assert battery.percent_charge_remaining == pytest.approx(100.0, abs=0.1)
    assert battery.voltage == pytest.approx(33.5, abs=0.2)
    assert battery.current_draw == pytest.approx(2.07, abs=0.1)
    assert battery.battery_temp is None, "nothing measures it"
    (row,) = master.ask(QueryPowerPlantCapabilities([])).power_plant_capabilities_list
    (limits,) = row.power_plant_capabilities_var.battery_capabilities_list
    assert limits.nominal_voltage == pytest.approx(28.8, abs=0.1)
    assert limits.max_charge == pytest.approx(1140.0 * 3600.0 / 28.8, rel=1e-3)


@pytest.mark.parametrize("query", [QueryPowerPlantStatus, QueryPowerPlantCapabilities, QueryPowerPlantConfiguration])
def test_queries_name_power_plants_that_may_not_exist(master, query):
    """Lists of all lengths with any identifiers: one report, with at most the one battery that there is."""
    for ids, rows in (([1], 1), ([2, 255], 0), ([0] * 255, 0), ([1] * 255, 1), ([], 1)):
        report = master.ask(query([query.PowerPlantID(id) for id in ids]))
        (found,) = [value for value in vars_of(report) if isinstance(value, list)]
        assert len(found) == rows


def vars_of(message):
    return [getattr(message, name) for name in message.__dataclass_fields__]


def test_the_battery_cannot_be_switched_off(master):
    master.take_control()
    kind = SetPowerPlantConfiguration
    for id, settings in (
        (1, kind.BatteryConfigurationRec(kind.PowerState.POWER_OFF)),
        (7, kind.BatteryConfigurationRec(kind.PowerState.POWER_ON)),
        (1, kind.HydraulicConfigurationRec(kind.PowerState.POWER_ON)),
        (1, kind.BatteryConfigurationRec(kind.PowerState.POWER_ON)),
    ):
        master.tell(kind([kind.PowerPlantConfigurationSeq(kind.PowerPlantID(id), settings)]))
        (row,) = master.ask(QueryPowerPlantConfiguration([])).power_plant_configuration_list
        assert row.power_plant_configuration_var.power_state == ReportPowerPlantConfiguration.PowerState.POWER_ON


NEARLY_EMPTY = """extends = "inc1"
[battery]
capacity = 2.0
full_voltage = 33.6
empty_voltage = 24.0
base_load = 60.0
camera_load = 4.0
charge = 0.22
"""


@pytest.mark.slow
async def test_an_operator_is_told_and_the_motors_stop(virtual_network, tmp_path, caplog):
    """The robot drives until its battery keeps only the reserve; its computer goes on, and says why it stands."""
    caplog.set_level(logging.INFO, logger="jauspy.robot")
    file = tmp_path / "robot.toml"
    file.write_text(NEARLY_EMPTY)
    async with virtual_network.robot(str(file)) as runner, virtual_network.ocu() as ocu:
        robot = await ocu.robot(101)
        async with robot.control("drive"):
            await robot.drive(0.5)
            await asyncio.sleep(4.0)
            assert "of its charge left" in runner.overloads["battery"]
            assert not runner.faults
            assert "the motors stop: bring the robot back" in caplog.text
            assert runner.snapshot.twist.vx > 0.3
            before = await robot.battery()
            while not runner.faults:  # the time limit of a test ends it otherwise
                await asyncio.sleep(0.5)
            await asyncio.sleep(1.0)
            assert runner.snapshot.twist.vx == 0.0
            assert "the motors get no power" in runner.faults["101.1.102"]
            assert "101.1.108" not in runner.faults, "what moves nothing works on"
            after = await robot.battery()
            assert before.charge > 0.05 > after.charge > 0.0
            assert before.power > 60.0
            with pytest.raises(RequestError, match="Failure"):
                await robot.drive(0.5, seconds=0.5)
    assert caplog.text.count("the motors get no power") >= 1
    logged = [record.levelno for record in caplog.records if record.getMessage().startswith("the battery ")]
    assert logged == [logging.WARNING, logging.ERROR], "each is said once"


@pytest.mark.slow
async def test_a_battery_that_ends_stops_the_arm_on_its_way_to_a_pose(virtual_network, tmp_path):
    file = tmp_path / "robot.toml"
    file.write_text(NEARLY_EMPTY.replace("charge = 0.22", "charge = 0.065"))
    async with virtual_network.robot(str(file)) as runner, virtual_network.ocu() as ocu:
        robot = await ocu.robot(101)

        async def move_to_and_fro() -> None:
            while True:  # the time limit of a test ends it otherwise
                await robot.arm.move_to("inspect")
                await robot.arm.move_to("stow")

        with pytest.raises(ControlRejected, match="took it back"):
            async with robot.control("arm"):
                await move_to_and_fro()
        assert "the motors get no power" in runner.faults["101.1.104"]
        stopped = (await robot.arm.joints()).positions
        await asyncio.sleep(2.0)
        assert (await robot.arm.joints()).positions == pytest.approx(stopped, abs=1e-3)
        with pytest.raises(RequestError, match=r"FAILURE|Failure"):
            async with robot.control("arm"):
                await robot.arm.move_to("stow")
        assert (await robot.arm.joints()).positions == pytest.approx(stopped, abs=1e-3)
