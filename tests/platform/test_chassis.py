"""Size, mass and limits of a chassis, and the efforts of its tracks."""

from __future__ import annotations

import math
from importlib.util import find_spec

import pytest

from jauspy.errors import ConfigError
from jauspy.geometry.urdf import RobotDescription, parse_urdf
from jauspy.platform.chassis import chassis_of, measure
from jauspy.platform.description import GroupSetup, RobotModel, TrackSetup
from jauspy.platform.drives import clamp, mix
from jauspy.robot.robot_files import load, robot_model

URDF = """
<robot name="cart">
  <link name="base">
    <inertial><origin xyz="0 0 0.1"/><mass value="3"/></inertial>
    <collision><origin xyz="0.1 0 0.1"/><geometry><box size="1 0.5 0.2"/></geometry></collision>
    <collision><geometry><mesh filename="nowhere.stl"/></geometry></collision>
  </link>
  <link name="mast">
    <inertial><origin xyz="0 0 0.5"/><mass value="1"/></inertial>
    <collision><origin xyz="0 0 0.5"/><geometry><cylinder radius="0.05" length="1"/></geometry></collision>
  </link>
  <joint name="lean" type="revolute">
    <parent link="base"/><child link="mast"/><origin xyz="0 0 0.2"/><axis xyz="0 1 0"/>
    <limit lower="-2" upper="2" effort="1" velocity="1"/>
  </joint>
</robot>
"""


def cart(lean: float) -> RobotModel:
    group = GroupSetup(("lean",), {}, "base", "mast", 100.0, (lean,))
    return RobotModel(parse_urdf(URDF), TrackSetup((), (), 0.0), {"mast": group})


def test_mass_centre_and_size_match_a_manual_calculation() -> None:
    upright = measure(cart(0.0))
    assert upright.mass == 4.0
    assert upright.centre_of_gravity == pytest.approx((0.0, 0.0, (3 * 0.1 + 0.7) / 4))
    assert upright.low == pytest.approx((-0.4, -0.25, 0.0))
    assert upright.high == pytest.approx((0.6, 0.25, 1.2))


def test_measures_use_start_positions() -> None:
    leaning = measure(cart(math.pi / 2))
    assert leaning.centre_of_gravity == pytest.approx((0.5 / 4, 0.0, (3 * 0.1 + 0.2) / 4))
    assert leaning.high == pytest.approx((1.0, 0.25, 0.25))


def test_invalid_mass_error_names_the_link() -> None:
    broken = RobotDescription("x", URDF.replace('value="3"', 'value="heavy"'), parse_urdf(URDF).joints)
    with pytest.raises(ConfigError, match="line 4: <mass value='heavy'>: 'heavy' is not 1 finite number"):
        measure(RobotModel(broken, TrackSetup((), (), 0.0)))


@pytest.mark.slow
@pytest.mark.skipif(find_spec("mujoco") is None, reason="MuJoCo is not installed")
@pytest.mark.parametrize("name", ["inc1", "inc1_pprm"])
def test_agrees_with_the_simulator(name: str) -> None:
    from jauspy_sim.assembly import build, prefix
    from jauspy_sim.robot import SimulatedRobot

    model = robot_model(load(name))
    base = build(model, "empty").body(f"{prefix(model.description.name)}base_link").id
    simulated = SimulatedRobot.open(model, "empty")
    found = measure(model)
    assert found.mass == pytest.approx(simulated._model.body_subtreemass[base])
    assert found.centre_of_gravity == pytest.approx(simulated._data.subtree_com[base].tolist(), abs=2e-3)


def test_chassis_of_inc1_matches_its_description() -> None:
    chassis = chassis_of(robot_model(load("inc1")))
    assert 40.0 < chassis.mass < 60.0
    assert chassis.track_separation == pytest.approx(0.46)
    assert chassis.max_speed == pytest.approx(0.95 * 1.9)
    assert (chassis.back, chassis.bottom) == (pytest.approx(0.45), pytest.approx(0.0, abs=1e-6))
    assert chassis.top > 0.4, "its arm is folded on top"


@pytest.mark.parametrize(
    ("efforts", "tracks"),
    [
        ((0.4, 0.0), (0.4, 0.4)),
        ((0.0, 0.3), (-0.3, 0.3)),
        ((0.5, 0.2), (0.3, 0.7)),
        ((1.0, 1.0), (0.0, 1.0)),
        ((-1.0, 0.5), (-1.0, -1 / 3)),
        ((5.0, 0.0), (1.0, 1.0)),
    ],
)
def test_efforts_are_mixed_for_both_tracks(efforts: tuple[float, float], tracks: tuple[float, float]) -> None:
    assert mix(*efforts) == pytest.approx(tracks)


def test_clamp_treats_nan_as_zero() -> None:
    assert clamp(math.nan) == 0.0
    assert clamp(-math.inf) == -1.0
