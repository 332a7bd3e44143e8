"""The parking brake: on each backend it holds the chassis, whoever drives, and its service reports it."""

from __future__ import annotations

from datetime import UTC, datetime, timedelta

import pytest
from tests.helpers.robot import FakeRobot
from tests.robot.workcell import BACKENDS

from jauspy.backends import find
from jauspy.codec.message import Message
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.core import RequestControl, Resume, SetEmergency, Standby
from jauspy.messages.mobility import SetWrenchEffort
from jauspy.messages.ugv import QueryParkingBrake, ReportParkingBrake, SetParkingBrake
from jauspy.platform.contract import RobotParts
from jauspy.platform.drives import ParkingBrake
from jauspy.robot import robot_files
from jauspy.robot.config import ModuleConfig
from jauspy.robot.hosts import host_of
from jauspy.robot.realtime import RealTime

CLIENT = JausID(42, 1, 1)
FORWARD = SetWrenchEffort(propulsive_linear_effort_x=60.0)
MODEL = robot_files.robot_model(robot_files.load("inc1"))
SERVICES = ("Discovery", "PrimitiveDriver", "ParkingBrakeDriver")


class Braked:
    """The CM-MOB of an inc1 that offers its parking brake, in real time that passes when the test says so."""

    def __init__(self, robot: RealTime, seen: RobotParts | None = None, services: tuple[str, ...] = SERVICES) -> None:
        self.robot, self.now = robot, 0.0
        module = ModuleConfig(type="CM-MOB", component=102, services=services, access_control={"timeout": 0})
        self.host = host_of(
            robot_files.load("inc1"),
            module,
            MODEL,
            seen or robot,
            {},
            utc_now=lambda: datetime(2026, 1, 1, tzinfo=UTC) + timedelta(seconds=self.now),
            now=0.0,
        )

    def tell(self, *messages: Message) -> list[Message]:
        for message in messages:
            self.host.receive(message.encode(), CLIENT, self.now)
        return [registry.decode(each.payload) for each in self.host.poll_output(self.now)]

    def run(self, seconds: float) -> None:
        for _ in range(round(seconds / 0.01)):
            self.robot._make_step()
            self.now += 0.01
            while (due := self.host.next_timeout()) is not None and due <= self.now:
                self.host.handle_timeout(self.now)

    def drive(self, seconds: float = 0.5) -> float:
        """How far it came."""
        before = self.robot.drive.pose().x
        self.tell(FORWARD)
        self.run(seconds)
        return self.robot.drive.pose().x - before

    @property
    def reported(self) -> tuple[int, int]:
        (report,) = self.tell(QueryParkingBrake())
        assert isinstance(report, ReportParkingBrake)
        return round(report.commanded_parking_brake), round(report.actual_parking_brake)


@pytest.fixture(params=BACKENDS)
def braked(request: pytest.FixtureRequest):
    robot = find(request.param).open(MODEL, "empty")
    braked = Braked(RealTime(robot, step=0.01))
    braked.tell(RequestControl(200), Resume())
    yield braked
    robot.close()


@pytest.mark.slow
def test_engaged_brake_holds_the_chassis_and_released_brake_does_not(braked: Braked) -> None:
    assert braked.drive() > 0.1
    braked.tell(SetParkingBrake(100.0))
    braked.run(0.7)
    assert braked.reported == (100, 100)
    assert abs(braked.drive()) < 0.005
    braked.tell(SetParkingBrake(0.0))
    braked.run(0.1)
    assert braked.reported == (0, 0)
    assert abs(braked.drive(0.0)) < 0.005, "efforts from before the release are forgotten"
    assert braked.drive() > 0.1


def test_any_level_above_zero_engages_fully(braked: Braked) -> None:
    braked.tell(SetParkingBrake(30.0))
    braked.run(0.1)
    assert braked.reported == (30, 100)
    assert abs(braked.drive()) < 0.005


@pytest.mark.parametrize("end", [Standby(), SetEmergency(1)], ids=["standby", "emergency"])
def test_brake_engages_on_leaving_ready_and_releases_only_in_ready(braked: Braked, end: Message) -> None:
    assert braked.drive() > 0.1
    braked.tell(end)
    braked.run(0.7)
    assert braked.reported == (100, 100)
    braked.tell(SetParkingBrake(0.0))
    braked.run(0.1)
    assert braked.reported == (100, 100)
    assert abs(braked.drive()) < 0.005


def test_brake_can_be_engaged_in_standby() -> None:
    braked = Braked(RealTime(find("kinematic").open(MODEL, "empty"), step=0.01))
    braked.tell(RequestControl(200), SetParkingBrake(100.0))
    braked.run(0.1)
    assert braked.reported == (100, 100)


def test_brake_is_offered_only_if_listed() -> None:
    assert not ModuleConfig(type="CM-MOB", component=102).offers("ParkingBrakeDriver")


def test_robot_without_brake_cannot_offer_the_service() -> None:
    fake = FakeRobot()
    assert ParkingBrake.of(fake) is None
    with pytest.raises(ConfigError, match=r"101\.1\.102: ParkingBrakeDriver needs a parking brake"):
        Braked(RealTime(fake))
