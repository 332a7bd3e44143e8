"""What modules draw, against mechanics, and what batteries have left."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import pytest

pytest.importorskip("mujoco")
pytest.importorskip("pinocchio", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)

from tests.helpers.cells import cell_model, put_on, small_cell

from jauspy.cell.judge import Judge
from jauspy.cell.measurements import figure_text
from jauspy.geometry.poses import Pose
from jauspy.geometry.vectors import GRAVITY
from jauspy.platform.battery import BatteryCharge, BatteryData
from jauspy.platform.joints import ControlMode, Target
from jauspy.platform.modular.cell import ModulePower, PowerState
from jauspy.platform.modular.parts import PlacedPart
from jauspy_sim.cell.robot import SimulatedCell
from jauspy_sim.cell.servos import SimulatedServo
from jauspy_sim.cell.start import wait_attached

ELBOW = "servo_2"
TUBE = "tube_1"
WHEELS = ("servo_6", "servo_7", "servo_8", "servo_9")


def power_of(cell: SimulatedCell) -> PowerState:
    found = ModulePower.of(cell)
    assert found is not None
    return found.state()


def check_constant_torque() -> None:
    """A torque that friction holds: nothing moves, and all goes into the windings and the electronics."""
    cell = small_cell(["platform_1", ELBOW], arm="")
    put_on(cell, "platform_1/top", ELBOW)
    wait_attached(cell, "platform_1/top", ELBOW)
    cell.advance(0.1)
    servo = cell.servos[ELBOW]
    torque = 0.8 * servo.setup.friction
    servo.command(Target(ControlMode.EFFORT, torque))
    before, begun = power_of(cell).consumption[ELBOW].energy, cell.time
    cell.advance(2.0)
    assert abs(servo.true_velocity) < 5e-3
    current = torque / servo.setup.torque_constant
    power = servo.setup.idle_power + servo.setup.resistance * current**2
    drawn = power_of(cell).consumption[ELBOW]
    assert drawn.energy - before == pytest.approx(power * (cell.time - begun), rel=0.02)
    assert drawn.power == pytest.approx(power, rel=1e-3)


def check_lift() -> None:
    """An elbow that raises a tube: beside heat it draws the gain of potential energy, and the work of friction."""
    cell, servo = raised_elbow()
    height, angle, before = potential(cell), servo.true_position, servo.energy
    servo.command(Target(ControlMode.VELOCITY, -0.4))
    heat = idle = 0.0
    for _ in range(1850):
        cell.advance(0.002)
        heat += servo.setup.resistance * servo.state().current ** 2 * 0.002
        idle += servo.setup.idle_power * 0.002
    turned = angle - servo.true_position
    assert turned > 1.4
    gain, friction = potential(cell) - height, servo.setup.friction * turned
    damping = servo.setup.damping * 0.4 * turned
    drawn = servo.energy - before - heat - idle
    assert gain > 0.5
    assert 0.99 * (gain + friction) <= drawn <= 1.1 * (gain + friction + damping)


def check_lowering() -> None:
    """What gravity does on the way down is not given back to others: nothing is drawn but never less."""
    cell, servo = raised_elbow(angle=0.3)
    before, begun = servo.energy, cell.time
    servo.command(Target(ControlMode.POSITION, 1.4))
    for _ in range(40):
        last = servo.energy
        cell.advance(0.05)
        assert servo.energy >= last + 0.99 * servo.setup.idle_power * 0.05
    assert servo.energy - before > servo.setup.idle_power * (cell.time - begun)


def raised_elbow(angle: float = 1.5) -> tuple[SimulatedCell, SimulatedServo]:
    """An elbow with a tube on a platform, turned to the side."""
    cell = small_cell(["platform_1", ELBOW, TUBE], arm="")
    cell.prepare("platform_1/top", [ELBOW, TUBE])
    servo = cell.servos[ELBOW]
    servo.command(Target(ControlMode.POSITION, angle))
    cell.advance(4.0)
    return cell, servo


def potential(cell: SimulatedCell) -> float:
    """Joules of the elbow's output and the tube in the field of gravity, of the simulation's own masses."""
    bodies = [cell.model.body(name).id for name in (f"{ELBOW}.output", TUBE)]
    cell.truth.pose(TUBE)
    return float(sum(cell.model.body_mass[body] * GRAVITY * cell.data.xipos[body][2] for body in bodies))


CHECKS: tuple[Callable[[], None], ...] = (check_constant_torque, check_lift, check_lowering)


@pytest.mark.slow
@pytest.mark.parametrize("check", CHECKS)
def test_energy_agrees_with_mechanics(check: Callable[[], None]) -> None:
    check()


def _without_heat(servo: SimulatedServo) -> None:
    setup, angle = servo.setup, servo._qpos[servo._motor]
    servo.energy += setup.idle_power * 0.002 + max(0.0, servo._command * (angle - servo._worked_at))
    servo._worked_at = angle


def _without_work(servo: SimulatedServo) -> None:
    current = servo._command / servo.setup.torque_constant
    servo.energy += servo.setup.idle_power * 0.002 + servo.setup.resistance * current**2 * 0.002


def _with_recovery(servo: SimulatedServo) -> None:
    current = servo._command / servo.setup.torque_constant
    angle = servo._qpos[servo._motor]
    work = servo._command * (angle - servo._worked_at)
    servo.energy += servo.setup.idle_power * 0.002 + servo.setup.resistance * current**2 * 0.002 + work
    servo._worked_at = angle


@pytest.mark.slow
@pytest.mark.parametrize(
    ("mutant", "check"),
    [(_without_heat, check_constant_torque), (_without_work, check_lift), (_with_recovery, check_lowering)],
)
def test_a_wrong_integral_is_found(
    mutant: Callable[[SimulatedServo], None], check: Callable[[], None], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(SimulatedServo, "_measure_energy", mutant)
    with pytest.raises(AssertionError):
        check()


def test_a_battery_loses_what_it_delivers_and_what_its_resistance_takes() -> None:
    battery = BatteryCharge(BatteryData(capacity=1.0, full_voltage=40.0, empty_voltage=30.0, resistance=0.2))
    assert battery.state().voltage == 40.0
    battery.drain(80.0, 1.0)
    assert battery.energy == pytest.approx(3600.0 - 80.0 - 0.2 * 2.0**2)
    state = battery.state()
    assert state.current == pytest.approx(2.0, rel=0.01)
    assert state.voltage == pytest.approx(40.0 - 10.0 * (1.0 - state.charge) - 0.2 * state.current)
    battery.drain(1e6, 1.0)
    assert battery.empty
    assert battery.state().voltage == 0.0


def car_cell(charge: float) -> SimulatedCell:
    """The car on its stand with four wheel modules that turn freely."""
    setup = cell_model().cell
    assert setup is not None
    chassis = setup.types["chassis"]
    assert chassis.battery is not None
    types = {**setup.types, "chassis": replace(chassis, battery=replace(chassis.battery, charge=charge))}
    cell = small_cell(["car", *WHEELS], car="car", types=types, fixtures=setup.fixtures, arm="")
    for side, name in zip(("front_left", "rear_left", "front_right", "rear_right"), WHEELS, strict=True):
        put_on(cell, f"car/{side}", name)
        wait_attached(cell, f"car/{side}", name)
    return cell


@pytest.mark.slow
def test_the_car_runs_on_its_battery() -> None:
    cell = car_cell(0.5)
    for name in WHEELS:
        cell.servos[name].command(Target(ControlMode.VELOCITY, 3.0))
    cell.advance(0.1)
    before = power_of(cell)
    cell.advance(2.0)
    after = power_of(cell)
    drawn = after.energy - before.energy
    lost = before.batteries["car"].energy - after.batteries["car"].energy
    assert drawn > 4 * 2.4 * 2.0, "the electronics alone draw 2.4 W each"
    assert drawn < lost < 1.05 * drawn, "and the battery's resistance takes a part"
    assert cell.servos[WHEELS[0]].state().voltage == pytest.approx(after.batteries["car"].voltage, abs=0.2)
    assert 30.0 < after.batteries["car"].voltage < 36.0


@pytest.mark.slow
def test_an_empty_battery_ends_the_power_as_if_detached() -> None:
    joules = 40.0  # attaching takes a part of it
    cell = car_cell(joules / (241.2 * 3600.0))
    assert all(cell.servos[name].powered for name in WHEELS)
    cell.advance(joules / (4 * 2.4))
    assert power_of(cell).batteries["car"].charge == 0.0
    assert not any(cell.servos[name].powered for name in WHEELS)
    drawn = power_of(cell).energy
    cell.advance(0.5)
    assert power_of(cell).energy == drawn
    assert all(cell.connectors[f"car/{side}"].state().attached_to for side in ("front_left", "rear_right"))
    cell.connectors["car/top"].set(True)
    assert not cell.connectors["car/top"].enabled, "its own connectors have no power either"


@pytest.mark.slow
def test_a_battery_module_powers_what_is_on_it_unless_the_mains_do() -> None:
    setup = cell_model().cell
    assert setup is not None
    battery = PlacedPart("battery_1", "battery_36v", Pose(x=-1.5, z=0.0))
    parts = tuple(part for part in setup.parts if part.name in ("platform_1", "servo_5"))
    cell = small_cell([], parts=(*parts, battery), arm="")
    full = power_of(cell).batteries["battery_1"].energy
    put_on(cell, "battery_1/output", "servo_5")
    wait_attached(cell, "battery_1/output", "servo_5")
    full = power_of(cell).batteries["battery_1"].energy
    cell.advance(1.0)
    assert cell.servos["servo_5"].powered
    left = power_of(cell).batteries["battery_1"].energy
    assert full - left == pytest.approx(2.4, rel=0.05), "the electronics; the latch holds without a pump"
    cell.connectors["battery_1/output"].set(False)
    cell.advance(0.1)
    assert not cell.servos["servo_5"].powered
    cell.prepare("platform_1/top", ["battery_1", "servo_5"])
    cell.advance(0.1)
    left = power_of(cell).batteries["battery_1"].energy
    cell.advance(1.0)
    assert cell.servos["servo_5"].powered
    assert power_of(cell).batteries["battery_1"].energy == left
    assert math.isclose(power_of(cell).consumption["servo_5"].power, 2.4, rel_tol=0.01)


@pytest.mark.slow
def test_the_judge_tells_what_modules_and_their_battery_gave() -> None:
    cell = small_cell(["platform_1", "car", "servo_6"], car="car")
    put_on(cell, "car/front_left", "servo_6")
    wait_attached(cell, "car/front_left", "servo_6")
    judge = Judge(cell)
    before, left, begun = judge.power(), cell._power.batteries["car"].energy, cell.time
    cell.advance(10.0)
    found = judge.drawn_since(before)
    power = cell.servos["servo_6"].setup.idle_power
    assert found["energy"] == pytest.approx(power * (cell.time - begun), rel=0.1)
    assert found["battery energy of car"] == pytest.approx(left - cell._power.batteries["car"].energy)
    assert found["battery energy of car"] >= found["energy"] * 0.999, "its own resistance takes some, too"
    assert 0.99 < found["battery charge of car"] < 1.0
    assert 41.0 < found["battery voltage of car"] < 42.0
    assert figure_text("battery energy of car", 7200.0) == "2 Wh"
    assert figure_text("battery charge of car", 0.5) == "50 %"
    assert figure_text("drift time", 1129.6) == "1130 s"
    assert figure_text("improvement", 1663.2) == "1663"
