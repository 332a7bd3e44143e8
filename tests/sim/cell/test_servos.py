"""Servo modules of the simulated cell against their data."""

from __future__ import annotations

import math

import pytest

pytest.importorskip("mujoco")
pytest.importorskip("pinocchio", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)

from tests.helpers.cells import build_arm, put_on, small_cell

from jauspy.platform.joints import ControlMode, Gains, Target
from jauspy.platform.modular.cell import ModulePower
from jauspy.platform.modular.parts import ServoData
from jauspy_sim.cell.robot import SimulatedCell
from jauspy_sim.cell.servos import SimulatedServo

NO_GAINS = Gains(0.0)


def one_servo(name: str = "servo_5") -> tuple[SimulatedCell, SimulatedServo]:
    """An inline servo module upright on a platform; nothing on its output, and no modular arm that commands it."""
    cell = small_cell(["platform_1", name], arm="")
    put_on(cell, "platform_1/top", name)
    cell.advance(0.5)
    assert cell.servos[name].powered
    assert cell.connectors["platform_1/top"].state().latched
    return cell, cell.servos[name]


def data(cell: SimulatedCell, name: str = "servo_5") -> ServoData:
    found = cell.setup.type_of(name).servo
    assert found is not None
    return found


def test_speed_without_load_is_that_of_the_data_sheet() -> None:
    cell, servo = one_servo()
    servo.command(Target(ControlMode.EFFORT, 100.0))
    cell.advance(1.0)
    speed = servo.state().velocity
    assert 0.8 * data(cell).max_speed < speed < data(cell).max_speed


@pytest.mark.parametrize(("load", "direction"), [(-6.3, 1.0), (-7.7, -1.0)])
def test_torque_is_limited(load: float, direction: float) -> None:
    """It turns against a load below its 7 N m, and a load above turns it."""
    cell, servo = one_servo()
    servo.command(Target(ControlMode.EFFORT, 100.0))
    cell.data.xfrc_applied[cell.model.body("servo_5.output").id][5] = load
    cell.advance(0.3)
    state = servo.state()
    assert state.velocity * direction > 0.05
    assert state.current == pytest.approx(data(cell).max_torque / data(cell).torque_constant, rel=1e-6)


def test_gear_friction_holds_a_small_torque() -> None:
    cell, servo = one_servo()
    friction = data(cell).friction
    servo.command(Target(ControlMode.EFFORT, 0.8 * friction))
    cell.advance(0.5)
    assert abs(servo.state().position) < 0.01
    servo.command(Target(ControlMode.EFFORT, 1.5 * friction))
    cell.advance(0.5)
    assert servo.state().position > 0.05


@pytest.mark.slow
def test_the_spring_is_as_stiff_as_its_data() -> None:
    """The motor holds its position; a torque at the output winds up the spring."""
    cell, servo = one_servo()
    servo.set_gains(Gains(40.0, 30.0, 1.6, 7.0), NO_GAINS)
    body = cell.model.body("servo_5.output").id
    cell.data.xfrc_applied[body][5] = 3.0
    cell.advance(2.0)
    spring = float(cell.data.joint("servo_5.spring").qpos[0])
    assert spring == pytest.approx(3.0 / data(cell).stiffness, rel=0.01)
    assert servo.state().torque == pytest.approx(-3.0, rel=0.01)


@pytest.mark.slow
def test_it_follows_positions_beyond_a_turn() -> None:
    cell, servo = one_servo("servo_6")
    servo.command(Target(ControlMode.POSITION, 20.0))
    cell.advance(6.0)
    assert servo.state().position == pytest.approx(20.0, abs=0.02)
    assert abs(servo.state().velocity) < 0.02


@pytest.mark.slow
def test_it_follows_velocities() -> None:
    cell, servo = one_servo()
    servo.command(Target(ControlMode.VELOCITY, -1.5))
    cell.advance(2.0)
    assert servo.state().velocity == pytest.approx(-1.5, abs=0.05)
    servo.hold()
    cell.advance(0.2)
    assert abs(servo.state().velocity) < 0.05


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf])
def test_values_that_are_no_numbers_are_ignored(value: float) -> None:
    cell, servo = one_servo()
    for mode in ControlMode:
        servo.command(Target(mode, value), value)
    servo.set_torque(value)
    cell.advance(0.2)
    assert abs(servo.state().position) < 0.01


def test_windings_warm_up_under_load() -> None:
    cell, servo = one_servo()
    servo.command(Target(ControlMode.EFFORT, 7.0))
    cell.data.xfrc_applied[cell.model.body("servo_5.output").id][5] = -7.0
    cell.advance(2.0)
    state = servo.state()
    assert 25.02 < state.temperature < 30.0
    assert state.voltage < 48.0


@pytest.mark.slow
def test_the_imu_measures_gravity_and_attitude() -> None:
    cell = small_cell(["platform_1", "servo_5", "bracket_1", "bracket_3"], arm="")
    build_arm(cell, ["bracket_1", "bracket_3", "servo_5"])
    cell.advance(0.5)
    state = cell.servos["servo_5"].state()
    assert state.powered
    frame = cell.truth.frame("servo_5")
    assert state.acceleration == pytest.approx(frame.inverse().rotate((0.0, 0.0, 9.81)), abs=0.3)  # its bias
    w, x, y, z = state.orientation
    matrix = frame.rotation
    assert 1.0 - 2.0 * (x * x + y * y) == pytest.approx(matrix[2][2], abs=1e-3)
    assert 2.0 * (w * z + x * y) == pytest.approx(matrix[1][0], abs=1e-3)
    assert state.angular_velocity == pytest.approx((0.0, 0.0, 0.0), abs=0.015)


def test_power_comes_through_attachments_and_switches() -> None:
    cell = small_cell(["platform_1", "platform_2", "servo_1", "servo_5", "bracket_1"], arm="")
    assert not cell.servos["servo_1"].state().powered
    cell.connectors["servo_1/output"].set(True)
    assert not cell.connectors["servo_1/output"].state().enabled  # no power, no pump
    build_arm(cell, ["servo_1", "bracket_1", "servo_5"])
    assert all(cell.servos[name].state().powered for name in ("servo_1", "servo_5"))
    power = ModulePower.of(cell)
    assert power is not None
    power.switch("servo_5", False)
    power.switch("nothing", False)
    cell.advance(0.02)
    assert not cell.servos["servo_5"].state().powered
    assert cell.servos["servo_1"].state().powered
    assert cell.connectors["bracket_1/output"].state().attached_to == "servo_5"
    power.switch("servo_5", True)
    power.switch("servo_1", False)
    cell.advance(0.02)
    assert cell.servos["servo_5"].state().powered  # through the housing of the silent one
    assert not cell.servos["servo_1"].state().powered
    power.switch("servo_1", True)
    cell.connectors["platform_1/top"].set(False)
    cell.advance(0.02)
    assert not any(cell.servos[name].state().powered for name in ("servo_1", "servo_5"))
    assert cell.connectors["bracket_1/output"].state().attached_to == "servo_5"  # what is held stays held


@pytest.mark.slow
def test_a_module_that_falls_silent_reports_its_last_state() -> None:
    cell, servo = one_servo()
    servo.command(Target(ControlMode.VELOCITY, 2.0))
    cell.advance(1.0)
    last = servo.state()
    power = ModulePower.of(cell)
    assert power is not None
    power.switch("servo_5", False)
    cell.advance(0.5)
    state = servo.state()
    assert not state.powered
    assert state.position == last.position
    assert cell.truth.servo("servo_5")[0] > last.position  # it went on by its inertia
    assert abs(cell.truth.servo("servo_5")[1]) < 0.1  # until friction stopped it


@pytest.mark.slow
def test_an_elbow_bears_its_load() -> None:
    """Horizontal, against gravity: the spring's torque is the moment of what the output carries."""
    cell = small_cell(["platform_1", "servo_2", "tube_1"], arm="")
    build_arm(cell, ["servo_2", "tube_1"])
    servo = cell.servos["servo_2"]
    servo.command(Target(ControlMode.POSITION, math.pi / 2.0))
    cell.advance(4.0)
    state = servo.state()
    assert state.position == pytest.approx(math.pi / 2.0, abs=0.02)
    moment = 9.81 * (0.12 * 0.065 + 0.27 * (0.075 + 0.1))
    assert state.torque == pytest.approx(-moment, rel=0.03)
    assert cell.truth.pose("tube_1").z == pytest.approx(0.2 + 0.085, abs=0.005)
