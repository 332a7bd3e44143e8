"""CM-MOB on a virtual clock: what it offers, what it drives, and above all when it stops."""

from __future__ import annotations

from datetime import UTC, datetime

import pytest

from jauspy.codec.message import Message
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.core import (
    QueriedComponentRec,
    QueriedNodeRec,
    QueryIdentification,
    QueryServices,
    ReportIdentification,
    ReportServices,
    RequestControl,
    Resume,
    SetEmergency,
    Standby,
)
from jauspy.messages.mobility import SetWrenchEffort
from jauspy.robot.config import ModuleConfig
from jauspy.robot.hosts import WATCHDOG_PERIOD, module_host
from jauspy.robot.kinds import MobilityContext
from jauspy.services.core import Identity, may_move
from jauspy.services.mobility import GlobalPose, Vehicle

ME, CLIENT = JausID(101, 1, 102), JausID(42, 1, 1)
FORWARD = SetWrenchEffort(propulsive_linear_effort_x=40.0)


class Module:
    """A CM-MOB, its clock and its drive."""

    def __init__(self, robot, origin: GlobalPose | None = None, **config) -> None:
        self.drive = robot.drive
        self.now = 10.0
        self.host = module_host(
            ME,
            ModuleConfig(type="CM-MOB", component=102, **config),
            MobilityContext(robot, Vehicle(robot.drive, origin=origin)),
            identities={4: Identity("CM-MOB", 60001)},
            utc_now=lambda: datetime(2026, 1, 1, tzinfo=UTC),
            now=self.now,
        )

    def tell(self, *messages: Message) -> list[Message]:
        for message in messages:
            self.host.receive(message.encode(), CLIENT, self.now)
        return [registry.decode(each.payload) for each in self.host.poll_output(self.now)]

    def run(self, seconds: float) -> None:
        end = self.now + seconds
        while (due := self.host.next_timeout()) is not None and due <= end:
            self.now = max(self.now, due)
            self.host.handle_timeout(self.now)
        self.now = end

    def services(self) -> set[str]:
        everything = QueryServices([QueryServices.NodeSeq(QueriedNodeRec(255), [QueriedComponentRec(255)])])
        (report,) = self.tell(everything)
        assert isinstance(report, ReportServices)
        (component,) = report.node_list[0].component_list
        return {service.uri.rpartition(":")[2] for service in component.service_list}


@pytest.fixture
def module(fake_robot) -> Module:
    return Module(fake_robot)


@pytest.fixture
def driving(module) -> Module:
    module.tell(RequestControl(authority_code=100), Resume(), FORWARD)
    assert module.drive.effort == (pytest.approx(0.4, abs=1e-3), pytest.approx(0.0, abs=1e-3))
    return module


ALL = {"Transport", "Events", "AccessControl", "Management", "ListManager", "Time", "Liveness", "Discovery"} | {
    "PrimitiveDriver",
    "VelocityStateSensor",
    "VelocityStateDriver",
    "AccelerationStateSensor",
    "LocalPoseSensor",
    "LocalVectorDriver",
    "LocalWaypointDriver",
    "LocalWaypointListDriver",
    "EnhancedLocalWaypointListDriver",
    "SkidSteerDriver",
    "PlatformSpecifications",
    "Convoy",
    "LeaderManagement",
    "CommsLostPolicyManager",
    "Retrotraverse",
}
GLOBAL = {
    "GlobalPoseSensor",
    "GlobalVectorDriver",
    "GlobalWaypointDriver",
    "GlobalWaypointListDriver",
    "EnhancedGlobalWaypointListDriver",
    "LeaderFollowerDriver",
}


def test_offers_everything_by_default(module):
    assert module.services() == ALL


def test_origin_enables_global_services(fake_robot):
    assert Module(fake_robot, GlobalPose(38.6, -77.2)).services() == ALL | GLOBAL


@pytest.mark.parametrize("service", sorted(GLOBAL))
def test_global_service_without_origin_is_an_error(fake_robot, service):
    with pytest.raises(ConfigError, match="needs an origin"):
        Module(fake_robot, services=("Discovery", service)).tell(RequestControl(100))


def test_only_listed_services_are_offered(fake_robot):
    module = Module(fake_robot, services=("Discovery", "LocalPoseSensor"))
    assert module.services() == {"Transport", "Events", "AccessControl", "Management", "Discovery", "LocalPoseSensor"}


def test_identification_is_reported(module):
    (report,) = module.tell(QueryIdentification(query_type=4))
    assert isinstance(report, ReportIdentification)
    assert report.identification == "CM-MOB"


def test_access_control_is_as_configured(fake_robot):
    module = Module(fake_robot, access_control={"timeout": 2, "default_authority": 50})
    module.tell(RequestControl(authority_code=49))
    assert module.host.controller is None
    module.tell(RequestControl(authority_code=50))
    assert module.host.controller == CLIENT
    module.run(1.9)
    assert module.host.controller == CLIENT
    module.run(0.2)
    assert module.host.controller is None


def test_drive_continues_while_the_client_commands(driving):
    for _ in range(3):
        driving.run(1.5)
        assert driving.drive.effort != (0.0, 0.0)
        driving.tell(SetWrenchEffort(propulsive_linear_effort_x=40.0))
    assert may_move(driving.host)


def test_drive_stops_when_no_further_command_arrives(driving):
    driving.run(1.9)
    assert driving.drive.effort != (0.0, 0.0)
    driving.run(0.2)
    assert driving.drive.effort == (0.0, 0.0)
    assert may_move(driving.host)
    assert driving.host.counters["command_timeout"] == 1


@pytest.mark.parametrize("message", [Standby(), SetEmergency(1)])
def test_standby_stops_the_drive(driving, message):
    driving.tell(message)
    assert driving.drive.effort == (0.0, 0.0)
    assert not may_move(driving.host)


def test_control_timeout_stops_the_drive(driving):
    driving.run(5.1)
    assert driving.drive.effort == (0.0, 0.0)
    assert driving.host.controller is None


def test_watchdog_stops_motion_outside_ready(module):
    module.drive.set_effort(0.4, 0.0)  # as if a service had a mistake
    module.run(WATCHDOG_PERIOD)
    assert module.drive.effort == (0.0, 0.0)
    module.drive.set_effort(0.4, 0.0)
    module.run(WATCHDOG_PERIOD)
    assert module.drive.effort == (0.0, 0.0)


def test_watchdog_stops_motion_after_standby(driving):
    driving.tell(Standby())
    driving.drive.set_effort(0.4, 0.0)
    driving.run(WATCHDOG_PERIOD)
    assert driving.drive.effort == (0.0, 0.0)


def test_watchdog_continues_after_a_failed_stop(module, monkeypatch):
    def fail() -> None:
        raise OSError("no answer from the bus")

    with monkeypatch.context() as broken:
        broken.setattr(module.drive, "stop", fail)
        module.run(WATCHDOG_PERIOD)
    module.drive.set_effort(0.4, 0.0)
    module.run(WATCHDOG_PERIOD)
    assert module.drive.effort == (0.0, 0.0)


def test_an_effort_of_zero_brakes_although_16_bits_have_no_zero(fake_robot):
    module = Module(fake_robot)
    module.tell(RequestControl(200), Resume(), SetWrenchEffort(propulsive_linear_effort_x=0.0))
    assert fake_robot.drive.effort == (0.0, 0.0)
