"""The services of a factory cell over a cell in memory: what they report, take and refuse, and when they stop."""

from __future__ import annotations

import math
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from typing import Any

import pytest
from tests.helpers.memory_cell import MemoryCell
from tests.helpers.robot import described

from jauspy.codec.message import Message
from jauspy.geometry.poses import Pose, Transform
from jauspy.geometry.vectors import quaternion
from jauspy.ids import JausID
from jauspy.messages import cell as m, registry
from jauspy.messages.core import (
    ClearEmergency,
    CommandEvent,
    CreateCommandEvent,
    ReleaseControl,
    RequestControl,
    Reset,
    Resume,
    SetEmergency,
    Shutdown,
    Standby,
)
from jauspy.platform.joints import ControlMode, Gains, Target
from jauspy.platform.modular.arm import ArmController
from jauspy.robot.config import AccessControlConfig
from jauspy.robot.hosts import host_of
from jauspy.services.cell import motion_command

CLIENT, OTHER = JausID(42, 1, 1), JausID(42, 2, 1)
STEP = 0.01
START = datetime(2026, 1, 1, tzinfo=UTC)
ALL_FIELDS = 0xFFFFFFFF
EVENT = CommandEvent.CODE.to_bytes(2, "little")


class Bench:
    """A cell, and the component of one of its modules."""

    def __init__(self, part: str, *, timeout: int = 0, robot: MemoryCell | None = None) -> None:
        config, model = described("cell")
        self.robot = robot or MemoryCell(model)
        if robot is None:
            self.robot.assemble("servo_1", "tube_1", "servo_2")
        self.now = 0.0
        (module,) = (each for each in config.modules if part in (each.part, each.type) and each.type != "CM-MOB")
        module = module.model_copy(update={"access_control": AccessControlConfig(timeout=timeout)})
        self.host = host_of(
            config,
            module,
            model,
            self.robot,
            {},
            utc_now=lambda: START + timedelta(seconds=self.now),
            now=0.0,
        )

    def tell(self, *messages: Message, client: JausID = CLIENT) -> list[Message]:
        for message in messages:
            self.host.receive(message.encode(strict=False), client, self.now)
        sent = self.host.poll_output(self.now)
        for each in sent:
            if each.on_acknowledged is not None:
                each.on_acknowledged(True)
        return [registry.decode(each.payload) for each in sent if each.payload[1] >= 0xD0 or each.payload[:2] == EVENT]

    def ask(self, query: Message) -> Any:
        (answer,) = self.tell(query)
        return answer

    def control(self, client: JausID = CLIENT) -> None:
        self.tell(RequestControl(200), Resume(), client=client)

    def run(self, seconds: float) -> list[Message]:
        heard: list[Message] = []
        for _ in range(round(seconds / STEP)):
            self.robot.advance(STEP)
            self.now += STEP
            while (due := self.host.next_timeout()) is not None and due <= self.now:
                self.host.handle_timeout(self.now)
            heard += self.tell()
        return heard

    def count(self, reason: str) -> int:
        return dict(self.host.counters).get(reason, 0)


@pytest.fixture
def servo() -> Bench:
    bench = Bench("servo_1")
    bench.robot.arm._joints = list  # no arm claims it
    bench.run(0.05)
    return bench


@pytest.fixture
def arm() -> Bench:
    return Bench("arm")


def servo_state(bench: Bench, fields: int = ALL_FIELDS) -> m.ReportServoState:
    return bench.ask(m.QueryServoState(fields))


def target(mode: str, value: float, feed_forward: float | None = None) -> m.SetServoTarget:
    return m.SetServoTarget(m.SetServoTarget.Mode[f"{mode}_MODE"], value, feed_forward)


# --- servo modules ------------------------------------------------------------------------------------------------


def test_a_servo_module_turns_any_number_of_turns(servo):
    servo.control()
    servo.tell(target("POSITION", -123.456))
    servo.robot.servos["servo_1"].current = replace(servo.robot.servos["servo_1"].current, position=-123.0)
    servo.run(0.5)
    assert servo_state(servo).position == pytest.approx(-123.456, abs=1e-9)


@pytest.mark.parametrize("mode", ["VELOCITY", "EFFORT"])
def test_a_servo_module_follows_velocities_and_torques(servo, mode):
    servo.control()
    servo.tell(target(mode, 0.5, 0.25))
    servo.run(0.1)
    module = servo.robot.servos["servo_1"]
    assert module.target == Target(ControlMode[mode], 0.5)
    assert module.feed_forward == 0.25
    state = servo_state(servo)
    assert (state.velocity, state.torque) == ((0.5, 0.25) if mode == "VELOCITY" else (0.0, 0.75))


def test_the_state_of_a_servo_module(servo):
    module = servo.robot.servos["servo_1"]
    module.current = replace(
        module.current,
        position=7.5,
        velocity=-0.5,
        torque=1.5,
        current=0.75,
        temperature=41.0,
        voltage=35.5,
        orientation=(0.5, -0.5, 0.5, -0.5),
        angular_velocity=(0.25, 0.5, 0.75),
        acceleration=(0.0, -9.75, 1.0),
        claimed_by="arm",
    )
    assert servo_state(servo) == m.ReportServoState(
        7.5, -0.5, 1.5, 0.75, 41.0, 35.5, 0.5, -0.5, 0.5, -0.5, 0.25, 0.5, 0.75, 0.0, -9.75, 1.0, "arm"
    )
    assert servo_state(servo, 0b101) == m.ReportServoState(position=7.5, torque=1.5)


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf])
def test_targets_that_are_no_numbers_are_ignored(servo, value):
    servo.control()
    servo.tell(target("POSITION", 1.0))
    servo.tell(target("POSITION", value), target("VELOCITY", value), target("EFFORT", 0.0, value))
    assert servo.robot.servos["servo_1"].target == Target(ControlMode.POSITION, 1.0)
    assert servo.count("invalid_target") == 3


def test_gains_are_set_and_reported(servo):
    position, _ = servo.robot.servos["servo_1"].gains()
    assert servo.ask(m.QueryServoGains()).position_p == position.p
    servo.control()
    servo.tell(gains(50.0))
    assert servo.robot.servos["servo_1"].gains() == (Gains(50.0, 5.0, 0.5), Gains(2.0, 20.0, 0.0, 3.0))
    report = servo.ask(m.QueryServoGains())
    assert (report.position_i_limit, report.velocity_i_limit) == (None, 3.0)
    for invalid in (-1.0, math.nan, math.inf):
        servo.tell(gains(invalid))
    assert servo.count("invalid_gains") == 3
    assert servo.robot.servos["servo_1"].gains()[0].p == 50.0


def gains(position_p: float) -> m.SetServoGains:
    return m.SetServoGains(
        position_p=position_p,
        position_i=5.0,
        position_d=0.5,
        velocity_p=2.0,
        velocity_i=20.0,
        velocity_d=0.0,
        velocity_i_limit=3.0,
    )


def test_the_data_sheet_of_a_servo_module(servo):
    data = servo.robot.servos["servo_1"].type.servo
    report = servo.ask(m.QueryServoSpecification())
    assert (report.name, report.type) == ("servo_1", servo.robot.servos["servo_1"].type.name)
    limits = report.max_torque, report.max_speed, report.stiffness, report.torque_constant
    assert limits == pytest.approx((data.max_torque, data.max_speed, data.stiffness, data.torque_constant))


def test_targets_are_ignored_while_a_modular_arm_moves_the_module():
    bench = Bench("servo_1")
    bench.run(0.05)
    bench.control()
    bench.tell(target("VELOCITY", 0.5))
    assert bench.robot.servos["servo_1"].target is None
    assert bench.count("claimed") == 1
    assert servo_state(bench).claimed_by == "arm"
    bench.robot.connectors["platform_1/top"].set(False)
    bench.run(0.05)
    assert servo_state(bench).claimed_by == ""
    bench.tell(target("VELOCITY", 0.5))
    assert bench.robot.servos["servo_1"].target == Target(ControlMode.VELOCITY, 0.5)


def test_other_clients_do_not_move_a_servo_module(servo):
    servo.tell(target("VELOCITY", 0.5))
    servo.control()
    servo.tell(target("VELOCITY", 0.5), client=OTHER)
    servo.tell(Standby(), target("VELOCITY", 0.5))
    assert servo.robot.servos["servo_1"].target is None


@pytest.mark.slow
def test_velocities_and_torques_end_without_a_further_target(servo):
    servo.control()
    module = servo.robot.servos["servo_1"]
    for _ in range(3):
        servo.tell(target("VELOCITY", 0.5))
        servo.run(1.5)
        assert module.current.velocity == 0.5
    servo.run(1.0)
    assert module.current.velocity == 0.0
    assert servo.count("command_timeout") == 1
    servo.tell(target("EFFORT", 0.5), target("POSITION", 1.0))
    servo.run(5.0)
    assert module.target == Target(ControlMode.POSITION, 1.0)


# --- how everything stops -----------------------------------------------------------------------------------------

ENDS = {
    "release": [ReleaseControl()],
    "standby": [Standby()],
    "emergency": [SetEmergency(SetEmergency.EmergencyCode.STOP)],
    "reset": [Reset()],
    "shutdown": [Shutdown()],
}


@pytest.fixture(params=[*ENDS, "timeout", "another client"])
def end(request) -> str:
    return request.param


def finish(bench: Bench, end: str) -> None:
    """Have control end this way, and give it 0.2 s to take effect."""
    if end == "timeout":
        bench.run(1.1)
    elif end == "another client":
        bench.tell(RequestControl(250), client=OTHER)
    else:
        bench.tell(*ENDS[end])
    bench.run(0.2)


def commanded(part: str, command: Message) -> Bench:
    bench = Bench(part, timeout=1)
    if part == "servo_1":
        bench.robot.arm._joints = list
    bench.run(0.05)
    bench.control()
    bench.tell(command)
    bench.run(0.1)
    return bench


def test_a_servo_module_holds_when_control_ends(end):
    bench = commanded("servo_1", target("VELOCITY", 0.5))
    module = bench.robot.servos["servo_1"]
    assert module.current.velocity == 0.5
    finish(bench, end)
    assert module.current.velocity == 0.0
    holds = module.holds
    bench.run(1.0)
    assert module.holds == holds, "repeated holds would follow a joint that sags"


def test_the_conveyor_stops_when_control_ends(end):
    bench = commanded("CM-CNV", m.SetConveyorSpeed(0.25))
    assert bench.ask(m.QueryConveyorState(0xFF)).speed == 0.25
    finish(bench, end)
    report = bench.ask(m.QueryConveyorState(0xFF))
    assert (report.commanded_speed, report.speed) == (0.0, 0.0)


def test_the_modular_arm_holds_when_control_ends(end):
    bench = commanded("arm", move(1.0, 1.0, duration=5.0))
    assert bench.robot.arm.state().moving
    finish(bench, end)
    assert not bench.robot.arm.state().moving
    assert bench.robot.arm.holds >= 1


def test_connectors_hold_what_they_have_when_control_ends(end):
    bench = commanded("gripper", m.QueryConnectorSpecification())
    bench.robot.connectors["gripper"].touches = "box_1"
    bench.tell(m.SetConnector(1, m.SetConnector.Enabled.ENABLED))
    bench.run(0.05)
    finish(bench, end)
    report = bench.ask(m.QueryConnectorState(ALL_FIELDS, 1))
    assert (report.enabled, report.attached_to) == (1, "box_1")


def test_nothing_moves_in_an_emergency_and_after_it_until_the_next_command():
    bench = commanded("CM-CNV", m.SetConveyorSpeed(0.25))
    bench.tell(SetEmergency(SetEmergency.EmergencyCode.STOP), m.SetConveyorSpeed(0.25))
    assert bench.robot.conveyor.current.speed == 0.0
    bench.tell(ClearEmergency(ClearEmergency.EmergencyCode.STOP))
    bench.run(0.2)
    assert bench.robot.conveyor.current.speed == 0.0
    bench.tell(m.SetConveyorSpeed(0.25))
    assert bench.robot.conveyor.current.speed == 0.25


# --- connectors ---------------------------------------------------------------------------------------------------


def test_a_connector_attaches_and_releases():
    bench = Bench("servo_2")
    bench.control()
    connector = bench.robot.connectors["servo_2/output"]
    assert bench.ask(m.QueryConnectorState(ALL_FIELDS, 1)).enabled == 0
    connector.touches = "box_1"
    bench.tell(m.SetConnector(1, m.SetConnector.Enabled.ENABLED))
    offset = Transform.from_pose(Pose(0.001, -0.002, 0.003, 0.01, -0.02, 0.03))
    connector.current = replace(
        connector.current, offset=offset, force=12.5, moment=0.5, utilisation=0.25, vacuum=9e4, latched=True
    )
    report = bench.ask(m.QueryConnectorState(ALL_FIELDS, 1))
    assert (report.connector, report.enabled, report.attached_to, report.error, report.error_text) == (
        1,
        1,
        "box_1",
        0,
        "",
    )
    pose = [
        report.offset_x,
        report.offset_y,
        report.offset_z,
        report.offset_roll,
        report.offset_pitch,
        report.offset_yaw,
    ]
    assert pose == pytest.approx([0.001, -0.002, 0.003, 0.01, -0.02, 0.03])
    assert (report.force, report.moment) == (12.5, 0.5)
    assert (report.utilisation, report.vacuum, report.latched) == (0.25, 9e4, m.ReportConnectorState.Latched.LATCHED)
    bench.tell(m.SetConnector(1, m.SetConnector.Enabled.DISABLED))
    assert bench.ask(m.QueryConnectorState(0b10, 1)).attached_to == ""


def test_a_connector_says_why_it_holds_nothing():
    bench = Bench("servo_2")
    bench.control()
    bench.tell(m.SetConnector(1, m.SetConnector.Enabled.ENABLED))
    report = bench.ask(m.QueryConnectorState(ALL_FIELDS, 1))
    assert (report.error, report.error_text) == (m.ReportConnectorState.Error.NO_CONTACT, "nothing touches the plate")
    bench.robot.connectors["servo_2/output"].break_off()
    report = bench.ask(m.QueryConnectorState(ALL_FIELDS, 1))
    assert (report.error, report.broken_off) == (m.ReportConnectorState.Error.OVERLOADED, 1)
    assert report.error_text == "26 N m, and it holds 25"


def test_a_base_has_a_connector_for_each_side():
    bench = Bench("car")
    specification = bench.ask(m.QueryConnectorSpecification())
    names = [each.connector_name for each in specification.connector_list]
    assert names == ["top", "front_left", "rear_left", "front_right", "rear_right"]
    limits = specification.connector_limits_rec
    assert (limits.name, limits.type) == ("car", "chassis")
    assert (limits.max_force, limits.max_moment) == pytest.approx((1100.0, 27.5))  # its latches
    bench.control()
    bench.robot.connectors["car/rear_left"].touches = "wheel_1"
    bench.tell(m.SetConnector(3, m.SetConnector.Enabled.ENABLED))
    assert bench.ask(m.QueryConnectorState(0b10, 3)).attached_to == "wheel_1"
    assert bench.ask(m.QueryConnectorState(0b10, 2)).attached_to == ""


def test_connectors_that_a_part_does_not_have():
    bench = Bench("servo_2")
    bench.control()
    bench.tell(m.SetConnector(2, m.SetConnector.Enabled.ENABLED))
    assert bench.tell(m.QueryConnectorState(ALL_FIELDS, 200)) == []
    assert bench.count("unknown_connector") == 2


# --- conveyor, parts, power ---------------------------------------------------------------------------------------


def test_the_conveyor_runs_within_its_limit():
    bench = Bench("CM-CNV")
    bench.control()
    fastest = bench.robot.cell.conveyor.max_speed
    bench.tell(m.SetConveyorSpeed(-9.0))
    bench.run(2.0)
    report = bench.ask(m.QueryConveyorState(0xFF))
    assert (report.commanded_speed, report.speed, report.max_speed) == pytest.approx((-fastest, -fastest, fastest))
    assert report.position == pytest.approx(-2.0 * fastest)
    bench.tell(m.SetConveyorSpeed(math.nan), m.SetConveyorSpeed(math.inf))
    assert bench.count("invalid_speed") == 2
    assert bench.robot.conveyor.current.speed == -fastest


def test_parts_are_observed_with_their_poses():
    bench = Bench("CM-PRT")
    bench.run(1.0)
    report = bench.ask(m.QueryPartObservations())
    assert report.observation_time_rec.time == pytest.approx(1.0)
    placed = bench.robot.cell.parts
    assert [(each.name, each.type) for each in report.part_list] == [(part.name, part.type) for part in placed]
    for each, part in zip(report.part_list, placed, strict=True):
        assert (each.x, each.y, each.z) == (part.pose.x, part.pose.y, part.pose.z)
        found = each.orientation_w, each.orientation_x, each.orientation_y, each.orientation_z
        assert found == pytest.approx(quaternion(Transform.from_pose(part.pose).rotation), abs=1e-6)


def test_energy_of_modules_and_batteries_is_reported():
    bench = Bench("CM-PRT")
    report = bench.ask(m.QueryModuleEnergy())
    assert {row.name for row in report.module_list} == set(bench.robot.power.switches)
    assert (report.module_list[0].power, report.module_list[0].energy) == (2.5, 10.0)
    (battery,) = report.battery_list
    assert (battery.name, battery.charge, battery.energy, battery.voltage) == ("car", 50.0, 1000.0, 36.0)


def test_modules_are_switched_on_and_off():
    bench = Bench("CM-PRT")
    record, power = m.SetModulePower.ModulePowerRec, m.SetModulePower.Power
    off = m.SetModulePower([record("servo_1", power.SWITCHED_OFF), record("nobody", power.SWITCHED_ON)])
    bench.tell(off)
    assert bench.robot.power.switches["servo_1"], "nobody is in control"
    bench.control()
    bench.tell(off)
    report = {each.name: each.power for each in bench.ask(m.QueryModulePower()).module_list}
    assert report["servo_1"] == power.SWITCHED_OFF
    assert report["servo_2"] == power.SWITCHED_ON
    assert "nobody" not in report
    assert bench.count("unknown_module") == 1
    bench.run(0.05)
    assert not bench.robot.servos["servo_1"].current.powered
    assert bench.robot.servos["servo_2"].current.powered, "supplies pass through modules that are switched off"


# --- the modular arm ----------------------------------------------------------------------------------------------


def move(*positions: float, duration: float = 0.0) -> m.MoveModularArm:
    return motion_command(positions, duration)


def arm_state(bench: Bench) -> m.ReportModularArmState:
    return bench.ask(m.QueryModularArmState())


def positions(bench: Bench) -> list[float]:
    return [each.position for each in arm_state(bench).joint_list]


@pytest.mark.slow
def test_the_arm_moves_and_leaves_joints_as_they_are(arm):
    arm.control()
    arm.tell(move(1.0, -40.0, duration=2.0))
    arm.run(1.0)
    state = arm_state(arm)
    assert state.modular_arm_motion_rec.moving == 1
    assert [each.target for each in state.joint_list] == [1.0, -40.0]
    arm.run(1.5)
    assert positions(arm) == pytest.approx([1.0, -40.0])
    arm.tell(move(math.nan, 3.0))
    arm.run(1.5)
    assert positions(arm) == pytest.approx([1.0, 3.0])
    assert arm_state(arm).modular_arm_motion_rec.moving == 0


@pytest.mark.parametrize("command", [move(1.0), move(1.0, 2.0, 3.0), move(), move(math.inf, 0.0)])
def test_motions_that_do_not_fit_the_arm_are_refused_with_the_reason(arm, command):
    arm.control()
    arm.tell(command)
    arm.run(0.3)
    assert "motion refused" in arm_state(arm).modular_arm_motion_rec.error
    assert positions(arm) == [0.0, 0.0]


def test_the_order_and_the_controller_of_the_arm(arm):
    assert [each.name for each in arm_state(arm).joint_list] == ["servo_1", "servo_2"]
    arm.control()
    record = m.SetModularArmOrder.JointNameRec
    arm.tell(m.SetModularArmOrder([record("servo_2"), record("servo_1")]))
    assert [each.name for each in arm_state(arm).joint_list] == ["servo_2", "servo_1"]
    arm.tell(m.SetModularArmOrder([record("servo_77")]))
    assert "no servo module 'servo_77'" in arm_state(arm).modular_arm_motion_rec.error
    controllers = m.SetModularArmController.Controller
    arm.tell(m.SetModularArmController(controllers.INDEPENDENT_PID))
    assert arm.robot.arm.state().controller is ArmController.PID
    assert arm_state(arm).modular_arm_motion_rec.controller == controllers.INDEPENDENT_PID


def test_what_the_arm_is_made_of(arm):
    report = arm.ask(m.QueryModularArmSpecification())
    assert report.modular_arm_ends_rec == m.ReportModularArmSpecification.ModularArmEndsRec(
        "platform_1/top", "servo_2/output"
    )
    assert [each.part_name for each in report.part_list] == ["servo_1", "tube_1", "servo_2"]
    for each in report.joint_list:
        type = arm.robot.servos[each.name].type
        assert each.type == type.name
        assert (each.max_torque, each.max_speed) == pytest.approx((type.servo.max_torque, type.servo.max_speed))


def test_the_client_hears_when_a_motion_has_ended(arm):
    arm.control()
    results = CommandEvent.CommandResult
    assert command_results(arm, 1, move(0.5, 0.5, duration=0.5)) == [results.SUCCESSFUL]
    assert command_results(arm, 2, move(1.0)) == [results.UNSUCCESSFUL]


def test_the_state_of_an_earlier_motion_ends_no_command(arm, monkeypatch):
    """The robot's thread takes a motion only later than its service looks at the arm."""
    arm.control()
    begin, late = arm.robot.arm.begin, []
    monkeypatch.setattr(arm.robot.arm, "begin", late.append)
    assert command_results(arm, 1, move(0.5, 0.5, duration=0.5)) == []
    begin(late[0])
    heard = arm.run(1.0)
    results = [each.command_result for each in heard if isinstance(each, CommandEvent)]
    assert results == [CommandEvent.CommandResult.SUCCESSFUL]


def command_results(bench: Bench, request: int, command: Message) -> list[int]:
    """What the events of a command say of its end, within a second."""
    heard = [*bench.tell(CreateCommandEvent(request, 10, command)), *bench.run(1.0)]
    return [each.command_result for each in heard if isinstance(each, CommandEvent)]


def test_a_blocked_motion_is_reported_and_counted(arm):
    arm.control()
    words = "Blocked: servo_1, 6 N m, 0.31 rad short; the arm holds where it is"
    sent = m.SetModularArmTrajectory
    point = sent.TrajectoryPointSeq(sent.PointTimeRec(5.0), [sent.JointValuesRec(1.0)])
    command = sent(sent.ModularArmTrajectoryRec(7), [sent.JointNameRec("servo_1")], [point])
    heard = [*arm.tell(CreateCommandEvent(1, 10, command)), *arm.run(0.5)]
    assert not [each for each in heard if isinstance(each, CommandEvent)]
    arm.robot.arm.block(words)
    heard = arm.run(0.2)
    results = [each.command_result for each in heard if isinstance(each, CommandEvent)]
    assert results == [CommandEvent.CommandResult.UNSUCCESSFUL]
    report = m.ReportModularArmMotionResult
    assert arm.ask(m.QueryModularArmMotionResult(7)) == report(7, report.Result.BLOCKED, words)
    assert arm_state(arm).modular_arm_motion_rec.error == words
    assert arm.count("blocked") == 1


def test_holding_ends_a_motion(arm):
    arm.control()
    arm.tell(move(5.0, 5.0, duration=10.0))
    arm.run(1.0)
    arm.tell(m.HoldModularArm())
    arm.run(0.1)
    assert arm_state(arm).modular_arm_motion_rec.moving == 0
    assert positions(arm)[0] < 1.0
