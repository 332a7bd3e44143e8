"""Services and backends of installed packages, which robots' files name."""

from __future__ import annotations

from pathlib import Path

import pytest
from typer.testing import CliRunner

from jauspy.cli.main import app
from jauspy.errors import ConfigError
from jauspy.messages.ugv import QueryOdometry
from jauspy.robot import catalogue, robot_files
from jauspy.robot.kinds import MobilityContext
from jauspy.robot.runner import RobotRunner
from jauspy.testing import VirtualNetwork
from jauspy.virtual.environment import VirtualTime

MODULE = """
import jauspy
from jauspy.messages.ugv import ReportOdometry
from jauspy.robot.kinds import MobilityContext, ServiceEntry
from jauspy.backends.kinematic import KinematicBackend


class Odometer(jauspy.Service, urn="urn:jaus:jss:ugv:OdometryService"):
    def __init__(self, drive):
        self.drive = drive

    def send_report_odometry(self, query):
        return ReportOdometry(query.odom, 1000 + round(self.drive.pose().x))

    def reset_trip_odometer(self):
        pass


ODOMETER = ServiceEntry(MobilityContext, lambda context: Odometer(context.robot.drive))
HORN = ServiceEntry(MobilityContext, lambda context: None, needs="a horn")


class Backend(KinematicBackend):
    name = "acme"
"""
ENTRY_POINTS = """
[jauspy.services]
Odometer = acme_robot:ODOMETER
Horn = acme_robot:HORN
Broken = acme_robot:MISSING
NoEntry = acme_robot:Backend

[jauspy.backends]
acme = acme_robot:Backend
"""


@pytest.fixture
def installed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    info = tmp_path / "acme_robot-1.0.dist-info"
    info.mkdir()
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: acme-robot\nVersion: 1.0\n")
    (info / "entry_points.txt").write_text(ENTRY_POINTS)
    (tmp_path / "acme_robot.py").write_text(MODULE)
    monkeypatch.syspath_prepend(str(tmp_path))


@pytest.fixture
def write(tmp_path: Path):
    def write(services: str, backend: str = "kinematic") -> Path:
        path = tmp_path / "mine.toml"
        path.write_text(
            f'extends = "inc1"\nbackend = "{backend}"\nworld = "empty"\n'
            f'[[modules]]\ntype = "CM-MOB"\ncomponent = 102\nservices = ["Discovery", {services}]\n'
        )
        return path

    return write


@pytest.mark.usefixtures("installed")
@pytest.mark.parametrize("backend", ["kinematic", "acme"])
async def test_installed_packages_add_services_and_backends(write, backend: str) -> None:
    async with VirtualNetwork() as network:
        runner = RobotRunner(robot_files.load(write('"Odometer"', backend)), network.transport, realtime=VirtualTime)
        async with runner, network.ocu() as ocu:
            report = await ocu.query("101.1.102", QueryOdometry(QueryOdometry.Odom.PLATFORM))
    assert report.odometry == 1000


@pytest.mark.usefixtures("installed")
def test_services_of_other_packages_are_not_offered_by_default() -> None:
    assert "Odometer" not in catalogue.defaults("CM-MOB")
    assert catalogue.find("CM-MOB", "Odometer").context is MobilityContext


@pytest.mark.usefixtures("installed")
@pytest.mark.parametrize(
    ("services", "said"),
    [
        ('"Siren"', r"a CM-MOB has no service 'Siren'; .*from other packages: Broken, Horn, NoEntry, Odometer"),
        ('"Broken"', r"service 'Broken' \(acme_robot:MISSING\) cannot be loaded: .*MISSING"),
        ('"NoEntry"', r"service 'NoEntry' \(acme_robot:Backend\) is not a ServiceEntry"),
    ],
)
def test_broken_service_entry_is_an_error(write, services: str, said: str) -> None:
    with pytest.raises(ConfigError, match=said):
        robot_files.load(write(services))


@pytest.mark.usefixtures("installed")
def test_service_of_another_module_type_is_rejected(write) -> None:
    with pytest.raises(ConfigError, match="a CM-SEN has no service 'Odometer'"):
        catalogue.find("CM-SEN", "Odometer")


@pytest.mark.usefixtures("installed")
async def test_service_error_names_the_missing_part(write) -> None:
    async with VirtualNetwork() as network:
        runner = RobotRunner(robot_files.load(write('"Horn"')), network.transport, realtime=VirtualTime)
        with pytest.raises(ConfigError, match=r"101\.1\.102: Horn needs a horn"):
            await runner.open()


@pytest.mark.usefixtures("installed")
def test_option_backend_accepts_installed_backends() -> None:
    result = CliRunner().invoke(app, ["up", "inc1", "--backend", "nothing", "--no-node-manager"])
    assert result.exit_code
    assert "no backend 'nothing'; installed are: acme, " in str(result.exception) + result.output
