"""Every kind of component of a factory cell passes the tests made from the definitions of its services."""

from __future__ import annotations

from datetime import UTC, datetime, timedelta

import pytest
from tests.conformance.simulated import examined
from tests.helpers.memory_cell import MemoryCell
from tests.helpers.robot import described
from tests.helpers.sampling import sampled

from jauspy.conformance import Report, TargetComponent, Verdict, VirtualTarget
from jauspy.geometry.poses import Pose
from jauspy.ids import JausID
from jauspy.platform.modular.cell import CarState
from jauspy.robot.hosts import host_of
from jauspy.services.cell import (
    ConveyorService,
    ModularArmService,
    PartSensorService,
    ServoModuleService,
    VacuumConnectorService,
)

START = datetime(2026, 3, 14, tzinfo=UTC)
CONFIG, MODEL = described("cell")
IDS = {module.part or module.type: CONFIG.id_of(module) for module in CONFIG.modules if module.type != "CM-MOB"}
KINDS = {
    "UR10": JausID(201, 1, 10),
    "gripper": JausID(201, 1, 11),
    "conveyor": JausID(201, 1, 12),
    "parts and power": JausID(201, 1, 13),
    "car": JausID(201, 1, 20),
    "modular arm": JausID(201, 3, 1),
    "base": IDS["platform_2"],
    "servo module of an arm": IDS["servo_1"],
    "servo module": IDS["servo_2"],
    "tube": IDS["tube_1"],
}


def cell(id: JausID) -> VirtualTarget:
    """One component of a cell in memory, in which all parts have power; an arm has servo_1."""
    robot = MemoryCell(MODEL)
    robot.assemble("servo_1", "tube_1")
    robot.car.current = CarState(assembled=True, pose=Pose(1.0, 2.0))
    robot.bases += ["servo_2"]  # with power, and in no chain
    robot.advance(0.01)
    (module,) = (each for each in CONFIG.modules if CONFIG.id_of(each) == id)
    made: list[VirtualTarget] = []
    host = host_of(
        CONFIG,
        module,
        MODEL,
        robot,
        {},
        utc_now=lambda: START + timedelta(seconds=made[0].now() if made else 0.0),
        now=0.0,
    )
    made.append(VirtualTarget([TargetComponent(host)], tick=robot.advance))
    return made[0]


def problems(report: Report) -> list[str]:
    return [
        f"{each.id}: {each.reason}" for each in report.results if each.verdict not in (Verdict.PASS, Verdict.SKIPPED)
    ]


@pytest.mark.slow
@pytest.mark.parametrize("kind", sampled([name for name in KINDS if name not in ("UR10", "car")], 4))
def test_own_services(kind):
    report = examined("cell-1.0", cell(KINDS[kind]), KINDS[kind])
    assert problems(report) == []
    assert report.status == 0
    assert report.counts[Verdict.PASS] >= 10


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["UR10", "conveyor"])
def test_core_services(kind):
    report = examined("core-1.1", cell(KINDS[kind]), KINDS[kind])
    assert problems(report) == []
    assert report.status == 0
    assert report.counts[Verdict.PASS] > 100


@pytest.mark.slow
@pytest.mark.parametrize(("kind", "profile"), [("UR10", "manipulator-2.0"), ("car", "mobility-1.1")])
def test_public_services(kind, profile):
    report = examined(profile, cell(KINDS[kind]), KINDS[kind])
    assert problems(report) == []
    assert report.counts[Verdict.PASS] > 20


MISTAKES = {
    "conveyor": (ConveyorService, "set_conveyor_speed", "SetConveyorSpeed"),
    "servo module": (ServoModuleService, "set_servo_target", "SetServoTarget"),
    "parts and power": (PartSensorService, "report_part_observations", "QueryPartObservations"),
    "modular arm": (ModularArmService, "report_modular_arm_state", "QueryModularArmState"),
    "tube": (VacuumConnectorService, "set_connector", "SetConnector"),
}


@pytest.mark.slow
@pytest.mark.parametrize("kind", MISTAKES)
def test_a_service_that_does_nothing_fails(kind, monkeypatch):
    service, action, message = MISTAKES[kind]
    monkeypatch.setattr(service, action, lambda self: None)
    report = examined("cell-1.0", cell(KINDS[kind]), KINDS[kind])
    assert report.status == 1
    assert any(message in each for each in problems(report)), problems(report)
