"""A client with less authority than the one that grasped a load takes control, and cannot release the load."""

from __future__ import annotations

import pytest
from tests.robot.test_cell_services import ALL_FIELDS, CLIENT, OTHER, Bench
from tests.robot.workcell import Workcell, outcomes

from jauspy.ids import JausID
from jauspy.messages import cell as m, manipulator
from jauspy.messages.core import (
    CreateCommandEvent,
    ReleaseControl,
    RequestControl,
    Reset,
    Resume,
    SetAuthority,
    SetEmergency,
    Standby,
)

ON, OFF = m.SetConnector.Enabled.ENABLED, m.SetConnector.Enabled.DISABLED
STRONGER = JausID(42, 3, 1)


@pytest.fixture
def bench() -> Bench:
    """A gripper with a box that a client with authority 200 has attached; the client has left."""
    bench = Bench("gripper")
    bench.robot.connectors["gripper"].touches = "box_1"
    bench.control()
    bench.tell(m.SetConnector(1, ON))
    bench.run(0.05)
    bench.tell(ReleaseControl())
    return bench


def vent(bench: Bench, client: JausID, authority: int) -> str:
    """What the connector holds after this client has taken control and let air in."""
    bench.tell(RequestControl(authority), Resume(), m.SetConnector(1, OFF), client=client)
    bench.run(0.05)
    return bench.robot.connectors["gripper"].current.attached_to


def test_less_authority_does_not_release_a_load(bench: Bench) -> None:
    assert vent(bench, OTHER, 1) == "box_1"
    assert bench.count("load_held") == 1
    report = bench.ask(m.QueryConnectorState(ALL_FIELDS, 1))
    assert report.error == m.ReportConnectorState.Error.OTHER_ERROR
    assert report.error_text == "not released: a client with authority 200 attached box_1, and this one has 1"


def test_less_authority_does_not_schedule_a_release(bench: Bench) -> None:
    bench.tell(
        RequestControl(1), Resume(), m.ScheduleConnector(1, m.ScheduleConnector.Enabled.DISABLED, 0.1), client=OTHER
    )
    assert bench.robot.connectors["gripper"].scheduled is None
    assert bench.count("load_held") == 1


@pytest.mark.parametrize("end", [Standby(), Reset(), SetEmergency(SetEmergency.EmergencyCode.STOP), ReleaseControl()])
def test_what_was_scheduled_does_not_happen_after_a_stop_or_without_its_client(bench: Bench, end: object) -> None:
    bench.tell(RequestControl(200), Resume(), m.ScheduleConnector(1, m.ScheduleConnector.Enabled.DISABLED, 10.0))
    bench.run(0.05)
    assert bench.robot.connectors["gripper"].scheduled == (False, 10.0)
    bench.tell(end)
    bench.run(0.05)
    assert bench.robot.connectors["gripper"].scheduled is None
    assert bench.robot.connectors["gripper"].current.attached_to == "box_1"


@pytest.mark.parametrize(("client", "authority"), [(CLIENT, 200), (OTHER, 200), (STRONGER, 255)])
def test_the_same_authority_or_more_releases_it(bench: Bench, client: JausID, authority: int) -> None:
    assert vent(bench, client, authority) == ""
    assert bench.count("load_held") == 0


def test_a_reason_is_reported_until_the_load_is_released(bench: Bench) -> None:
    vent(bench, OTHER, 1)
    vent(bench, STRONGER, 255)
    assert bench.ask(m.QueryConnectorState(ALL_FIELDS, 1)).error_text == ""


def test_a_refused_command_event_is_unsuccessful(bench: Bench) -> None:
    bench.tell(RequestControl(1), Resume(), client=OTHER)
    refused = CreateCommandEvent(1, 0, m.SetConnector(1, OFF).encode())
    sent = bench.tell(refused, client=OTHER)
    assert [int(each.command_result) for each in sent if hasattr(each, "command_result")] == [1]


def test_attaching_again_with_less_authority_changes_nothing(bench: Bench) -> None:
    bench.tell(RequestControl(1), Resume(), m.SetConnector(1, ON), client=OTHER)
    assert vent(bench, OTHER, 1) == "box_1"


def test_a_client_that_lowers_its_authority_cannot_release_it_until_it_raises_it(bench: Bench) -> None:
    bench.tell(RequestControl(200), Resume(), SetAuthority(1), m.SetConnector(1, OFF))
    assert bench.robot.connectors["gripper"].current.attached_to == "box_1"


@pytest.mark.parametrize("end", [Standby(), Reset(), SetEmergency(SetEmergency.EmergencyCode.STOP)])
def test_other_commands_of_the_new_client_hold_it_too(bench: Bench, end: object) -> None:
    bench.tell(RequestControl(1), Resume(), end, client=OTHER)
    assert vent(bench, OTHER, 1) == "box_1"


def test_the_memory_outlives_the_component(bench: Bench) -> None:
    """The component of a part ends when its power is switched off, and another one begins."""
    again = Bench("gripper", robot=bench.robot)
    assert vent(again, OTHER, 1) == "box_1"
    assert again.count("load_held") == 1


def test_a_connector_that_holds_nothing_is_free(bench: Bench) -> None:
    bench.robot.connectors["gripper"].break_off()
    vent(bench, OTHER, 1)
    assert bench.count("load_held") == 0
    bench.robot.connectors["gripper"].touches = "box_2"
    bench.tell(m.SetConnector(1, ON), client=OTHER)
    assert vent(bench, OTHER, 1) == "", "what this client attached, it releases"


class TestFingers:
    """The gripper of inc1: fingers that close by effort."""

    def test_less_authority_does_not_open_what_holds_a_load(self) -> None:
        cell = self.gripper_with_a_load()
        self.command(cell, 1, -100.0, 0.0, 10.0)
        assert dict(cell.host.counters)["load_held"] == 3
        assert cell.ask(manipulator.QueryEndEffectorEffort()).end_effector_effort == pytest.approx(60.0, abs=0.1)
        event = CreateCommandEvent(1, 0, manipulator.SetEndEffectorEffort(-100.0).encode())
        assert outcomes(cell, event) == [1]

    def test_the_same_authority_opens_it(self) -> None:
        cell = self.gripper_with_a_load()
        self.command(cell, 200, -100.0)
        assert "load_held" not in dict(cell.host.counters)
        assert cell.ask(manipulator.QueryEndEffectorEffort()).end_effector_effort == pytest.approx(-100.0, abs=0.1)

    def test_closed_fingers_hold_nothing(self) -> None:
        cell = Workcell("kinematic", "inc1", 105)
        cell.take_control()
        cell.tell(manipulator.SetEndEffectorEffort(60.0))
        cell.run(3.0)
        self.command(cell, 1, -100.0)
        assert "load_held" not in dict(cell.host.counters)

    def gripper_with_a_load(self) -> Workcell:
        """The fingers close on a thing that keeps them apart; then the client leaves."""
        cell = Workcell("kinematic", "inc1", 105)
        cell.take_control()
        cell.tell(manipulator.SetEndEffectorEffort(-100.0))
        cell.run(1.0)
        cell.tell(manipulator.SetEndEffectorEffort(60.0))
        joints = cell.robot.groups[next(name for name in cell.robot.groups if "gripper" in name)]
        assert joints.state().positions[0] > joints.joints[0].lower + 0.005
        return cell  # kinematic time does not pass any more: the fingers stand where the thing is

    def command(self, cell: Workcell, authority: int, *efforts: float) -> None:
        cell.tell(ReleaseControl())
        client = JausID(42, 2, 1)
        cell.tell(RequestControl(authority), Resume(), client=client)
        cell.tell(*[manipulator.SetEndEffectorEffort(effort) for effort in efforts], client=client)
