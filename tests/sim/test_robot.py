"""The MuJoCo robot in its worlds."""

import contextlib
import logging
import math
from pathlib import Path

import pytest
from tests.helpers.sampling import sampled

from jauspy.errors import ConfigError
from jauspy_sim.backend import MujocoBackend

pytest.importorskip("mujoco", reason="MuJoCo is not installed")

from jauspy.robot.robot_files import known, load, robot_model
from jauspy_sim.assembly import TIMESTEP, build, prefix
from jauspy_sim.physics.joints import roll_pitch_yaw
from jauspy_sim.robot import SimulatedRobot
from jauspy_sim.worlds.world_files import known_worlds

INC1 = robot_model(load("inc1"))

GROUND = '<mujoco><worldbody><geom type="plane" size="50 50 1" friction="{} .005 .0001"/></worldbody></mujoco>'
CARRIED = """<link name="{}"><inertial><mass value="{}"/><inertia ixx=".1" iyy=".1" izz=".1" ixy="0" ixz="0" iyz="0"/>
</inertial><collision><geometry>{}</geometry></collision></link>"""
AT = "<origin xyz='{} {} 0'/><parent link='body'/><child link='{}'/>"


@pytest.fixture
def yard() -> SimulatedRobot:
    return SimulatedRobot.open(INC1, "yard")


@pytest.mark.slow
@pytest.mark.parametrize(
    ("robot", "world"), sampled([(robot, world) for robot in known() for world in known_worlds()], 9, several=True)
)
def test_all_robots_stand_in_all_worlds(robot: str, world: str) -> None:
    pose = SimulatedRobot.open(robot_model(load(robot)), world).drive.pose()
    assert max(map(abs, (pose.x, pose.y, pose.z, pose.yaw))) < 1e-3
    assert max(abs(pose.roll), abs(pose.pitch)) < (0.01 if world == "rough" else 1e-3)


def test_masses_are_plausible() -> None:
    model = build(INC1, "empty")
    base = model.body(f"{prefix('inc1')}base_link").id
    assert 40.0 < model.body_subtreemass[base] < 60.0
    for body in range(base, model.nbody):
        a, b, c = sorted(model.body_inertia[body])
        assert a > 0.0
        assert a + b >= c


@pytest.mark.slow
def test_climbs_the_ramp_onto_the_deck(yard: SimulatedRobot) -> None:
    yard.drive.set_effort(0.3, 0.0)
    yard.advance(9.0)
    on_ramp = yard.drive.pose()
    assert on_ramp.z > 0.15
    assert on_ramp.pitch == pytest.approx(-math.radians(12), abs=0.02)
    yard.advance(4.0)
    on_deck = yard.drive.pose()
    assert on_deck.z == pytest.approx(0.4, abs=0.005)
    assert on_deck.pitch == pytest.approx(0.0, abs=0.01)


@pytest.mark.slow
def test_the_brake_holds_it_on_the_ramp(yard: SimulatedRobot) -> None:
    yard.drive.set_effort(0.3, 0.0)
    yard.advance(9.0)
    yard.drive.stop()
    yard.advance(1.0)
    before = yard.drive.pose()
    yard.advance(5.0)
    assert math.dist((before.x, before.z), (yard.drive.pose().x, yard.drive.pose().z)) < 0.005


@pytest.mark.slow
def test_pushes_a_carton(yard: SimulatedRobot) -> None:
    data, model = yard._data, yard._model
    carton = data.body("carton_1").xpos
    start = carton.copy()
    address = model.joint(f"{prefix('inc1')}base").qposadr[0]
    data.qpos[address : address + 2] = (2.6, 2.2)
    yard.drive.set_effort(0.4, 0.0)
    yard.advance(1.5)
    assert carton[0] - start[0] > 0.2
    assert abs(yard.drive.pose().yaw) < 0.2


@pytest.mark.slow
def test_belts_are_reset(yard: SimulatedRobot) -> None:
    yard.drive.set_effort(1.0, 0.3)
    yard.advance(1.0)
    for track in ("base_link_to_left_track", "base_link_to_right_track"):
        joint = yard._data.joint(f"{prefix('inc1')}{track}")
        assert joint.qpos[0] == 0.0
        assert joint.qvel[0] < -0.3


def test_remaining_time_is_carried_over(yard: SimulatedRobot) -> None:
    yard.advance(0.75 * TIMESTEP)
    assert yard.time == 0.0
    yard.advance(0.75 * TIMESTEP)
    assert yard.time == TIMESTEP
    yard.advance(0.5 * TIMESTEP)
    assert yard.time == 2 * TIMESTEP


@pytest.mark.slow
def test_tenths_of_seconds_lose_no_step(yard: SimulatedRobot) -> None:
    for _ in range(20):
        yard.advance(0.1)
    assert yard.time == pytest.approx(2.0, abs=1e-12)


@pytest.mark.parametrize("angles", [(0.1, -0.2, 0.3), (-1.0, 1.2, -3.0), (0.0, 0.0, 2.5)])
def test_roll_pitch_yaw_of_a_quaternion(angles: tuple[float, float, float]) -> None:
    (cr, sr), (cp, sp), (cy, sy) = ((math.cos(a / 2), math.sin(a / 2)) for a in angles)
    quaternion = (
        cr * cp * cy + sr * sp * sy,
        sr * cp * cy - cr * sp * sy,
        cr * sp * cy + sr * cp * sy,
        cr * cp * sy - sr * sp * cy,
    )
    assert roll_pitch_yaw(*quaternion) == pytest.approx(angles)


def test_unknown_world_lists_the_known_ones() -> None:
    with pytest.raises(ConfigError, match=r"'mars'.*empty.*rough"):
        MujocoBackend().open(INC1, "mars")


def test_warnings_are_logged_and_no_file_is_left(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    monkeypatch.chdir(tmp_path)
    robot = SimulatedRobot.open(INC1, "empty")
    robot._data.qpos[:] = math.nan
    with caplog.at_level(logging.WARNING, logger="jauspy_sim.mujoco"):
        robot.advance(TIMESTEP)
    assert "QPOS" in caplog.text.upper()
    assert list(tmp_path.iterdir()) == []


@pytest.mark.slow
@pytest.mark.parametrize("friction", [1.0, 0.05])
def test_wheels_slip_on_ice(tmp_path: Path, friction: float) -> None:
    (tmp_path / "ground.xml").write_text(GROUND.format(friction))
    with contextlib.closing(SimulatedRobot.open(robot_model(load("rover")), str(tmp_path / "ground.xml"))) as robot:
        robot.drive.set_effort(1.0, 0.0)
        robot.advance(1.0)
        assert (robot.drive.twist().vx < 0.05 * 9.81 * 1.2) is (friction < 0.1)


@pytest.mark.parametrize("given", ["", '<gazebo reference="ball"><mu1>0</mu1></gazebo>'])
def test_a_caster_without_friction_slides(tmp_path: Path, given: str) -> None:
    parts = [CARRIED.format("body", 20, "<box size='.4 .3 .1'/>"), CARRIED.format("ball", 1, "<sphere radius='.1'/>")]
    parts.append(f"<joint name='b' type='fixed'>{AT.format(-0.2, 0, 'ball')}</joint>")
    for side, y in (("left", 0.2), ("right", -0.2)):
        parts.append(CARRIED.format(side, 1, "<sphere radius='.1'/>"))
        limit = "<axis xyz='0 1 0'/><limit effort='4' velocity='10'/>"
        parts.append(f"<joint name='{side}' type='continuous'>{AT.format(0.02, y, side)}{limit}</joint>")
    (tmp_path / "it.urdf").write_text(f"<robot name='it'>{''.join(parts)}{given}</robot>")
    (tmp_path / "it.toml").write_text(
        'name = "it"\nurdf = "it.urdf"\nsubsystem = 9\nnode = 1\n[[modules]]\ntype = "CM-MOB"\ncomponent = 102\n'
        '[wheels]\ntype = "skid_steer"\nleft = ["left"]\nright = ["right"]\n'
    )
    with contextlib.closing(SimulatedRobot.open(robot_model(load(tmp_path / "it.toml")), "empty")) as robot:
        robot.drive.set_effort(0.5, 0.0)
        robot.advance(1.5)
        assert (robot.drive.pose().x > 0.3) is bool(given)
