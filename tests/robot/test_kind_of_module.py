"""A further kind of module: what its one class says reaches the file's checks, the component and its services."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

import pytest

from jauspy.errors import ConfigError
from jauspy.messages.ugv import QueryOdometry, ReportOdometry
from jauspy.platform.contract import DriveBase, RobotParts, Snapshot
from jauspy.platform.modular.parts import CellSetup
from jauspy.robot import robot_files
from jauspy.robot.kinds import KINDS, Kind, Module, ModuleBuild, ServiceEntry
from jauspy.robot.runner import RobotRunner
from jauspy.services.service import Service
from jauspy.testing import VirtualNetwork
from jauspy.virtual.environment import VirtualTime


class Odometer(Service, urn="urn:jaus:jss:ugv:OdometryService"):
    def __init__(self, drive: DriveBase) -> None:
        self.drive = drive

    def send_report_odometry(self, query: QueryOdometry) -> ReportOdometry:
        return ReportOdometry(query.odom, 1000 + round(self.drive.pose().x))

    def reset_trip_odometer(self) -> None:
        pass


@dataclass(frozen=True, slots=True)
class OdometerContext:
    module: ClassVar[str] = "CM-ODO"
    moving: ClassVar[None] = None
    robot: RobotParts


class Odometers(Kind[OdometerContext]):
    type: ClassVar[str] = "CM-ODO"
    services: ClassVar[Mapping[str, ServiceEntry[Any]]] = {
        "Odometer": ServiceEntry(OdometerContext, lambda context: Odometer(context.robot.drive))
    }
    present: bool = True

    def context(self, build: ModuleBuild) -> OdometerContext:
        return OdometerContext(build.robot)

    def is_present(self, module: Module, cell: CellSetup | None, snapshot: Snapshot) -> bool:
        return self.present


@pytest.fixture
def kind(monkeypatch: pytest.MonkeyPatch) -> Odometers:
    kind = Odometers()
    monkeypatch.setitem(KINDS, kind.type, kind)
    return kind


@pytest.fixture
def write(tmp_path: Path):
    def write(keys: str = "") -> Path:
        path = tmp_path / "mine.toml"
        path.write_text(
            'extends = "inc1"\nbackend = "kinematic"\nworld = "empty"\n'
            f'[[modules]]\ntype = "CM-MOB"\ncomponent = 102\n[[modules]]\ntype = "CM-ODO"\ncomponent = 110\n{keys}'
        )
        return path

    return write


@pytest.mark.usefixtures("kind")
async def test_its_services_answer(write) -> None:
    async with VirtualNetwork() as network:
        runner = RobotRunner(robot_files.load(write()), network.transport, realtime=VirtualTime)
        async with runner, network.ocu() as ocu:
            report = await ocu.query("101.1.110", QueryOdometry(QueryOdometry.Odom.PLATFORM))
    assert report.odometry == 1000


async def test_it_has_no_component_while_it_is_absent(write, kind: Odometers) -> None:
    kind.present = False
    async with VirtualNetwork() as network:
        runner = RobotRunner(robot_files.load(write()), network.transport, realtime=VirtualTime)
        async with runner, network.ocu() as ocu:
            robot = await ocu.discover(101)
    assert [str(component.id) for component in robot.components] == ["101.1.102"]


@pytest.mark.usefixtures("kind")
@pytest.mark.parametrize(
    ("keys", "sentence"),
    [
        ('group = "arm"', "group: a CM-ODO moves no group of joints; leave it out"),
        ('camera = "front"', "camera: a CM-VIS needs the name"),
        ('services = ["Siren"]', "a CM-ODO has no service 'Siren'; it can have: Discovery, Time, Liveness, Odometer"),
    ],
)
def test_keys_of_other_kinds_are_refused(write, keys: str, sentence: str) -> None:
    with pytest.raises(ConfigError, match=sentence):
        robot_files.load(write(keys))


@pytest.mark.usefixtures("kind")
def test_it_moves_nothing_and_so_two_may_stand_beside_each_other(write) -> None:
    config = robot_files.load(write('[[modules]]\ntype = "CM-ODO"\ncomponent = 111\n'))
    assert [module.kind.moved(module) for module in config.modules if module.type == "CM-ODO"] == [None, None]


def test_without_the_kind_its_name_is_refused(write) -> None:
    with pytest.raises(ConfigError, match="no such kind of module"):
        robot_files.load(write())
