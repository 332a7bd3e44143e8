"""Bytes of the messages of the factory cell, written by hand from the definitions in schemas/cell."""

from __future__ import annotations

import math
import struct

import pytest

from jauspy.codec.message import Message
from jauspy.messages import cell as m, registry
from jauspy.platform.modular.arm import TrajectoryPoint
from jauspy.services.cell import motion_command, trajectory_command

STATE = m.ReportServoState(position=-1000.25, torque=1.5, claimed_by="arm")
POWER = m.SetModulePower.ModulePowerRec

ROWS = [
    pytest.param(
        m.SetServoTarget(m.SetServoTarget.Mode.VELOCITY_MODE, 0.5),
        "60da0001000000000000e03f",
        id="a target without a torque that is fed forward",
    ),
    pytest.param(
        m.SetServoTarget(m.SetServoTarget.Mode.POSITION_MODE, -1.0, 0.25),
        "60da0100000000000000f0bf0000803e",
        id="a target with one",
    ),
    pytest.param(m.QueryServoState(0x10005), "60ea05000100", id="a query for three fields"),
    pytest.param(
        STATE,
        "60fa05000100" + struct.pack("<d", -1000.25).hex() + "0000c03f03" + b"arm".hex(),
        id="a state of three fields",
    ),
    pytest.param(
        m.SetConnector(3, m.SetConnector.Enabled.ENABLED),
        "62da0301",
        id="a connector",
    ),
    pytest.param(
        m.ScheduleConnector(3, m.ScheduleConnector.Enabled.DISABLED, 0.25),
        "6ada0300000000000000d03f",
        id="a connector that is vented after a quarter of a second",
    ),
    pytest.param(m.SetConveyorSpeed(-0.25), "63da000080be", id="a conveyor that runs backward"),
    pytest.param(
        m.SetModulePower([POWER("servo_1", m.SetModulePower.Power.SWITCHED_OFF)]),
        "64da0107" + b"servo_1".hex() + "00",
        id="a supply",
    ),
    pytest.param(m.QueryModuleEnergy(), "6bea", id="a query for energy"),
    pytest.param(
        m.ReportModuleEnergy(
            [m.ReportModuleEnergy.ModuleEnergyRec("s", 2.5, 100.0)],
            [m.ReportModuleEnergy.BatteryRec("b", 50.0, 1000.0, 36.0, 1.25)],
        ),
        "6bfa"
        "0101"
        + b"s".hex()
        + struct.pack("<fd", 2.5, 100.0).hex()
        + "0101"
        + b"b".hex()
        + struct.pack("<fdff", 50.0, 1000.0, 36.0, 1.25).hex(),
        id="what a module draws and a battery has left",
    ),
    pytest.param(
        motion_command([0.5, math.nan, -2.0], 1.5),
        "65da000000000000f83f0301000000000000e03f000100000000000000c0",
        id="a motion that leaves the second joint",
    ),
    pytest.param(m.HoldModularArm(), "66da", id="a hold"),
    pytest.param(
        trajectory_command(
            ["a", "bc"],
            [
                TrajectoryPoint(0.5, (1.0, -2.0), (0.25, math.nan), (math.nan, -4.0)),
                TrajectoryPoint(1.5, (0.0, 3.0)),
            ],
            0x01020304,
        ),
        "69da"
        + struct.pack("<IBB1sB2s", 0x01020304, 2, 1, b"a", 2, b"bc").hex()
        + struct.pack("<B", 2).hex()
        + struct.pack("<dB", 0.5, 2).hex()
        + struct.pack("<Bdf", 0b01, 1.0, 0.25).hex()
        + struct.pack("<Bdf", 0b10, -2.0, -4.0).hex()
        + struct.pack("<dB", 1.5, 2).hex()
        + struct.pack("<BdBd", 0, 0.0, 0, 3.0).hex(),
        id="a trajectory with a velocity and an acceleration",
    ),
    pytest.param(m.QueryModularArmMotionResult(258), "6aea02010000", id="a query for how a motion ended"),
    pytest.param(
        m.ReportModularArmMotionResult(7, m.ReportModularArmMotionResult.Result.BLOCKED, "servo_1"),
        "6afa" + struct.pack("<IBB7s", 7, 6, 7, b"servo_1").hex(),
        id="a motion that was blocked",
    ),
    pytest.param(m.SetModularArmOrder([]), "68da00", id="an order that is to be found"),
    pytest.param(
        m.ReportPartObservations(
            m.ReportPartObservations.ObservationTimeRec(2.0),
            [m.ReportPartObservations.ObservedPartRec("a", "bc", 1.0, 0.0, -1.0, 1.0, 0.0, 0.0, 0.0)],
        ),
        "66fa"
        "0000000000000040"
        "0100"
        "0161"
        "026263"
        "000000000000f03f"
        "0000000000000000"
        "000000000000f0bf"
        "0000803f"
        "00000000"
        "00000000"
        "00000000",
        id="an observation of one part",
    ),
]


@pytest.mark.parametrize(("message", "data"), ROWS)
def test_bytes_of_the_cell(message: Message, data: str) -> None:
    assert message.encode().hex() == data
    assert registry.decode(bytes.fromhex(data)) == message


def test_every_command_of_the_cell_is_here_or_much_like_one() -> None:
    kinds = {type(row.values[0]) for row in ROWS}
    commands = {kind for kind in registry if kind.SERVICE.startswith("urn:jauspy:cell:") and kind.IS_COMMAND}
    assert commands - kinds == {m.SetServoGains, m.SetModularArmController}
