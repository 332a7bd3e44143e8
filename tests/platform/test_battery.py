"""Batteries and motors, against what physics says of them, and tables of files with silly numbers."""

from __future__ import annotations

import math

import pytest
from hypothesis import given, strategies as st

from jauspy.errors import ConfigError
from jauspy.geometry.urdf import Joint, JointKind
from jauspy.platform.battery import BatteryCharge, BatterySetup, SimulatedBattery
from jauspy.platform.motors import MotorModel
from jauspy.robot.robot_files import load

SETUP = BatterySetup(100.0, 33.6, 24.0, resistance=0.0, base_load=50.0, warning=0.2, reserve=0.05)
JOINT = Joint("elbow", JointKind.REVOLUTE, "a", "b", effort=100.0, velocity=2.0)


class Supply:
    """A battery whose motors take what the test says."""

    def __init__(self, setup: BatterySetup = SETUP) -> None:
        self.motors = 0.0
        self.cuts = 0
        self.battery = SimulatedBattery(setup, loads=lambda: 0.0, motors=lambda: self.motors, cut=self.cut, rate=1.0)
        self.now = 0.0
        self.battery.step(0.0)

    def cut(self) -> None:
        self.cuts += 1

    def run(self, seconds: int) -> None:
        for _ in range(seconds):
            self.now += 1.0
            self.battery.step(self.now)


def test_the_charge_falls_by_the_energy_that_was_taken():
    supply = Supply()
    supply.motors = 150.0
    supply.run(900)  # a quarter of an hour at 200 W
    assert supply.battery.state().charge == pytest.approx(0.5, abs=1e-6)
    assert supply.battery.state().power == pytest.approx(200.0)
    assert supply.battery.state().voltage == pytest.approx((33.6 + 24.0) / 2.0)
    assert supply.battery.time_left == pytest.approx(0.45 * 1800.0)
    assert supply.battery.problem == ""


def test_a_low_battery_is_said_and_the_reserve_is_kept_from_the_motors():
    supply = Supply()
    supply.motors = 150.0
    supply.run(1450)
    assert "19 % of its charge left" in supply.battery.problem
    assert "at 5 % the motors stop" in supply.battery.problem
    assert (supply.battery.cuts_motors, supply.cuts) == (False, 0)
    supply.run(290)
    assert (supply.battery.cuts_motors, supply.cuts) == (True, 1)
    assert "the motors get no power" in supply.battery.problem
    assert supply.battery.state().power == pytest.approx(50.0), "computers go on, motors do not"
    supply.run(400)
    assert supply.battery.state().energy == 0.0
    assert supply.battery.state().voltage == 0.0
    assert supply.cuts == 1


def test_a_resistance_takes_charge_and_voltage():
    charge = BatteryCharge(BatterySetup(100.0, 30.0, 30.0, resistance=0.1))
    charge.drain(300.0, 1.0)
    assert charge.state().voltage == pytest.approx(29.0)
    assert charge.energy == pytest.approx(360000.0 - 300.0 - 0.1 * 10.0**2)


@given(power=st.floats(0.0, 1e6), resistance=st.floats(0.0, 10.0), dt=st.floats(0.0, 1e4))
def test_a_load_beyond_what_a_battery_can_leaves_finite_values(power, resistance, dt):
    charge = BatteryCharge(BatterySetup(10.0, 30.0, 20.0, resistance=resistance))
    charge.drain(power, dt)
    state = charge.state()
    assert 0.0 <= state.charge <= 1.0
    assert 0.0 <= state.voltage <= 30.0
    assert math.isfinite(state.current)


def test_a_motor_has_its_efficiency_at_its_greatest_effort_and_speed():
    motor = MotorModel(JOINT, SETUP)
    assert 200.0 / motor.power(100.0, 2.0) == pytest.approx(SETUP.efficiency)
    assert motor.power(100.0, 0.0) == pytest.approx(200.0 * (1.0 / 0.7 - 1.0)), "holding heats its windings"
    assert motor.power(50.0, 0.0) == pytest.approx(motor.power(100.0, 0.0) / 4.0)
    assert motor.power(-100.0, 2.0) == 0.0, "a motor that brakes gives nothing back"
    assert motor.power(0.0, 2.0) == 0.0
    assert motor.phase_current(-100.0) == pytest.approx(200.0 / SETUP.nominal_voltage)


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("capacity = 0.0", "battery.capacity"),
        ("capacity = -100.0", "battery.capacity"),
        ("capacity = inf", "battery.capacity"),
        ("capacity = nan", "battery.capacity"),
        ("capacity = 1e300", "battery.capacity"),
        ('capacity = "a lot"', "battery.capacity"),
        ("capacity = 100.0\nempty_voltage = 40.0", "empty_voltage: must not be above full_voltage"),
        ("capacity = 100.0\nefficiency = 0.0", "battery.efficiency"),
        ("capacity = 100.0\nefficiency = 1.5", "battery.efficiency"),
        ("capacity = 100.0\ncharge = 90.0", "battery.charge"),
        ("capacity = 100.0\nbase_load = -5.0", "battery.base_load"),
        ("capacity = 100.0\nlamp_efficacy = 0.0", "battery.lamp_efficacy"),
        ("capacity = 100.0\nwarning = 0.1\nreserve = 0.2", "reserve: must not be above warning"),
        ("capacity = 100.0\nfuel = 3.0", "battery.fuel"),
    ],
)
def test_silly_batteries_are_refused_by_key(tmp_path, text, problem):
    defaults = "\n".join(
        line for line in ("full_voltage = 33.6", "empty_voltage = 24.0") if line.partition(" ")[0] not in text
    )
    file = tmp_path / "robot.toml"
    file.write_text(f'extends = "inc1"\n[battery]\n{text}\n{defaults}\n')
    with pytest.raises(ConfigError, match=problem):
        load(file)
