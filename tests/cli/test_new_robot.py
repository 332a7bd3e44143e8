"""`jauspy new robot`: from a URDF to a robot that moves."""

from __future__ import annotations

import asyncio
import math
import tomllib
from pathlib import Path

import pytest
from tests.helpers.simulated import Simulation, simulated
from typer.testing import CliRunner

from jauspy.cli.main import app
from jauspy.platform.joints import ControlMode, Target
from jauspy.robot import robot_files
from jauspy.testing import VirtualNetwork

LINK = """<link name="{}"><inertial><mass value="{}"/>
<inertia ixx=".02" iyy=".02" izz=".02" ixy="0" ixz="0" iyz="0"/></inertial><collision>{}</collision></link>"""
BOX = '<geometry><box size=".2 .2 .1"/></geometry>'
WHEEL = '<origin rpy="1.5708 0 0"/><geometry><cylinder radius=".1" length=".05"/></geometry>'


def joint(name: str, kind: str, parent: str, child: str, more: str) -> str:
    return f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>{more}</joint>'


def rover() -> str:
    """A body on four wheels without limits, with an arm of three joints of zero effort, a gripper and sensors."""
    parts = [LINK.format("body", 20, BOX)]
    for x in (-0.2, 0.2):
        for side, y in (("left", 0.2), ("right", -0.2)):
            name = f"{side}_{'front' if x > 0 else 'rear'}"
            parts.append(LINK.format(name, 1, WHEEL))
            parts.append(
                joint(f"{name}_joint", "continuous", "body", name, f'<origin xyz="{x} {y} 0"/><axis xyz="0 1 0"/>')
            )
    above = "body"
    for number, axis in enumerate(("0 0 1", "0 1 0", "0 1 0"), 1):
        parts.append(LINK.format(f"arm_{number}", 1, BOX))
        limit = f'<origin xyz="0 0 .2"/><axis xyz="{axis}"/><limit lower="-2" upper="2" effort="0" velocity="1"/>'
        parts.append(joint(f"joint_{number}", "revolute", above, f"arm_{number}", limit))
        above = f"arm_{number}"
    limit = '<origin xyz="0 0 .1"/><axis xyz="1 0 0"/><limit lower="0" upper="0.04" effort="20" velocity="0.1"/>'
    parts += [LINK.format("finger", 0.1, BOX), joint("finger_joint", "prismatic", above, "finger", limit)]
    for name in ("laser_link", "front_camera_link"):
        parts += [f'<link name="{name}"/>', joint(f"{name}_joint", "fixed", "body", name, '<origin xyz=".3 0 .2"/>')]
    return f'<robot name="rover">{"".join(parts)}</robot>'


@pytest.fixture
def written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    Path("rover.urdf").write_text(rover().replace("</robot>", '<gazebo/><transmission name="t"/><gazebo/></robot>'))
    done = CliRunner().invoke(app, ["new", "robot", "rover.urdf", "--subsystem", "9"])
    assert done.exit_code == 0, done.output
    assert "passed over in the URDF: 2 <gazebo>, 1 <transmission>" in done.output
    assert "jauspy up rover.toml" in done.output
    return tmp_path / "rover.toml"


@pytest.mark.slow
def test_wheels_groups_limits_and_sensors_are_found(written: Path) -> None:
    data = tomllib.loads(written.read_text())
    assert (data["name"], data["urdf"], data["subsystem"]) == ("rover", "rover.urdf", 9)
    assert sorted(data["wheels"]["left"]) == ["left_front_joint", "left_rear_joint"]
    assert {name: len(group["joints"]) for name, group in data["groups"].items()} == {"arm": 3, "gripper": 1}
    assert [module["type"] for module in data["modules"]] == ["CM-MOB", "CM-MAN", "CM-EEF", "CM-SEN", "CM-VIS"]
    assert (data["lidars"][0]["link"], data["cameras"][0]["link"]) == ("laser_link", "front_camera_link")
    assert set(data["joint_limits"]) == {
        *(f"{side}_{end}_joint" for side in ("left", "right") for end in ("front", "rear")),
        *("joint_1", "joint_2", "joint_3"),
    }
    assert "# guesses" in written.read_text()


def test_joints_without_limits_belong_to_the_arm_and_casters_to_none(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    urdf = rover()
    for number in (1, 3):
        urdf = urdf.replace(f'name="joint_{number}" type="revolute"', f'name="joint_{number}" type="continuous"')
    swivel = '<origin xyz="-.3 0 0"/><axis xyz="0 0 1"/>'
    parts = [LINK.format("swivel", 0.1, ""), joint("swivel_joint", "continuous", "body", "swivel", swivel)]
    parts += [LINK.format("roll", 1, BOX), joint("roll_joint", "continuous", "finger", "roll", '<axis xyz="1 0 0"/>')]
    monkeypatch.chdir(tmp_path)
    Path("rover.urdf").write_text(urdf.replace("</robot>", "".join(parts) + "</robot>"))
    done = CliRunner().invoke(app, ["new", "robot", "rover.urdf"])
    assert done.exit_code == 0, done.output
    data = tomllib.loads(Path("rover.toml").read_text())
    arm = [each["name"] for each in data["groups"]["arm"]["joints"]]
    assert arm[:2] == ["joint_1", "joint_2"]
    assert "roll_joint" in {each["name"] for group in data["groups"].values() for each in group["joints"]}
    assert "swivel_joint" not in Path("rover.toml").read_text()
    assert robot_files.robot_model(robot_files.load(Path("rover.toml"))).wheels is not None


@pytest.mark.slow
def test_the_robot_moves(written: Path) -> None:
    pytest.importorskip("mujoco")
    from jauspy_sim.robot import SimulatedRobot

    robot = SimulatedRobot.open(robot_files.robot_model(robot_files.load(written)), "empty")
    try:
        assert 0.08 < robot.drive.pose().z < 0.12  # on its wheels, which are below the base
        robot.drive.set_effort(0.5, 0.0)
        robot.groups["arm"].command([Target(ControlMode.POSITION, 0.4)] * 3)
        robot.advance(3.0)
        assert robot.drive.pose().x > 0.3
        assert robot.groups["arm"].state().positions == pytest.approx((0.4, 0.4, 0.4), abs=0.03)
    finally:
        robot.close()


def skidding(x: float, more: str = "") -> str:
    """A body of 46 kg on four wheels of 2.6 kg without limits, whose axles are `x` before and behind its middle."""
    parts = [LINK.format("body", 46, '<origin xyz="0 0 .1"/><geometry><box size=".9 .5 .2"/></geometry>')]
    wheel = '<origin rpy="1.5708 0 0"/><geometry><cylinder radius=".165" length=".11"/></geometry>'
    for end, along in (("front", x), ("rear", -x)):
        for side, y in (("left", 0.285), ("right", -0.285)):
            parts.append(LINK.format(f"{end}_{side}", 2.6, wheel))
            place = f'<origin xyz="{along} {y} 0.03"/><axis xyz="0 1 0"/>{more}'
            parts.append(joint(f"{end}_{side}_wheel", "continuous", "body", f"{end}_{side}", place))
    return f'<robot name="skidding">{"".join(parts)}</robot>'


@pytest.mark.parametrize("x", [0.18, 0.256, 0.4])
def test_a_robot_of_wheels_without_limits_turns_in_the_simulation(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, x: float
) -> None:
    pytest.importorskip("mujoco")
    from jauspy_sim.robot import SimulatedRobot

    monkeypatch.chdir(tmp_path)
    Path("skidding.urdf").write_text(skidding(x))
    done = CliRunner().invoke(app, ["new", "robot", "skidding.urdf"])
    assert done.exit_code == 0, done.output
    assert "in a trial with full effort it drives at " in done.output
    model = robot_files.robot_model(robot_files.load(Path("skidding.toml")))
    robot = SimulatedRobot.open(model, "empty")
    try:
        robot.drive.set_effort(0.0, 0.6)
        robot.advance(2.0)
        w, _, _, z = robot.data.qpos[3:7]  # of the free joint: the chassis as MuJoCo has it
        assert 2.0 * math.atan2(z, w) > 0.5
    finally:
        robot.close()


@pytest.mark.slow
async def test_a_robot_of_wheels_without_limits_goes_to_a_point(tmp_path: Path) -> None:
    pytest.importorskip("mujoco")
    (tmp_path / "skidding.urdf").write_text(skidding(0.256))
    written = await asyncio.to_thread(new_robot, tmp_path / "skidding.urdf", tmp_path / "skidding.toml")
    async with VirtualNetwork() as network:
        simulation = Simulation()
        async with simulated(network, simulation, str(written)), network.ocu() as ocu:
            robot, chassis = await ocu.robot(101), simulation.robot.drive
            async with robot.control("drive"):
                await robot.go_to(x=1.5, y=1.0, timeout=40.0)
                assert math.dist((chassis.pose().x, chassis.pose().y), (1.5, 1.0)) < 0.4
                before = chassis.pose().yaw
                await robot.drive(angular=0.8, seconds=1.5)
                assert math.remainder(chassis.pose().yaw - before, math.tau) > 0.5


def new_robot(urdf: Path, path: Path) -> Path:
    done = CliRunner().invoke(app, ["new", "robot", str(urdf), "-o", str(path)])
    assert done.exit_code == 0, done.output
    return path


def test_a_robot_that_cannot_turn_is_told_with_what_to_change(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("mujoco")
    monkeypatch.chdir(tmp_path)
    Path("weak.urdf").write_text(skidding(0.256, '<limit effort="5" velocity="10"/>'))
    done = CliRunner().invoke(app, ["new", "robot", "weak.urdf"])
    said = " ".join(done.output.split())
    assert done.exit_code == 0, done.output
    assert "cannot turn" in said
    assert "[joint_limits.front_left_wheel]" in said
    assert "drives at" in said


@pytest.mark.slow
def test_mistakes_are_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, written: Path) -> None:
    for arguments, said in (
        (["rover.urdf"], "rover.toml exists; remove it"),
        (["no.urdf"], "no.urdf: there is no such file"),
        (["rover.urdf", "--arg", "a=b"], "'a=b' is not NAME:=VALUE"),
    ):
        done = CliRunner().invoke(app, ["new", "robot", *arguments])
        assert done.exit_code != 0
        assert said in " ".join((done.output + str(done.exception or "")).split())


@pytest.mark.slow
@pytest.mark.parametrize(
    ("limits", "said"),
    [
        (
            "[joint_limits.elbow]\neffort = 3",
            "joint_limits: the URDF has no joint 'elbow' that moves; it has: .*joint_1",
        ),
        ("[joint_limits.finger_joint]\nlower = 1", "joint_limits.finger_joint: lower 1 is above upper 0.04"),
    ],
)
def test_wrong_limits_are_named(written: Path, limits: str, said: str) -> None:
    from jauspy.errors import ConfigError

    written.write_text(f"{written.read_text()}\n{limits}\n")
    with pytest.raises(ConfigError, match=said):
        robot_files.robot_model(robot_files.load(written))


def lacking(name: str = "rover.urdf.xacro") -> None:
    """The rover with a mesh and a package that are missing."""
    head = '<robot name="rover" xmlns:xacro="http://www.ros.org/wiki/xacro">'
    include = '<xacro:include filename="$(find lidar)/lidar.xacro"/><xacro:lidar parent="body"/>'
    mesh = '<visual><geometry><mesh filename="package://looks/body.dae"/></geometry></visual>'
    text = rover().replace('<robot name="rover">', f"{head}{include}")
    Path(name).write_text(text.replace('<link name="body">', f'<link name="body">{mesh}'))


@pytest.mark.slow
def test_a_robot_with_missing_parts_runs_without_them(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    lacking()
    done = CliRunner().invoke(app, ["new", "robot", "rover.urdf.xacro"])
    said = done.output + str(done.exception)
    assert "rover.urdf.xacro: 2 parts are missing:" in said
    assert "rover.urdf.xacro:1: <xacro:include>: package://lidar/lidar.xacro" in said
    assert "<mesh>: package://looks/body.dae" in said
    assert not Path("rover.toml").exists()
    options = ["--skip-missing-packages", "--placeholder-meshes"]
    done = CliRunner().invoke(app, ["new", "robot", "rover.urdf.xacro", *options])
    assert done.exit_code == 0, done.output
    data = tomllib.loads(Path("rover.toml").read_text())
    assert (data["skip_missing_packages"], data["placeholder_meshes"]) == (True, True)
    model = robot_files.robot_model(robot_files.load(Path("rover.toml")))
    assert model.wheels is not None
    assert '<box size="0.1 0.1 0.1"' in model.description.urdf


@pytest.mark.slow
def test_what_is_left_out_is_told_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    monkeypatch.chdir(tmp_path)
    lacking()
    CliRunner().invoke(app, ["new", "robot", "rover.urdf.xacro", "--skip-missing-packages", "--placeholder-meshes"])
    packages, includes, macros, replaced = [text for text in caplog.messages if "rover.urdf.xacro" in text]
    assert "packages that are not found: lidar, looks" in packages
    assert "left out includes: package://lidar/lidar.xacro (rover.urdf.xacro:1)" in includes
    assert "left out macros: lidar (rover.urdf.xacro:1)" in macros
    assert "replaced by a box of 0.1 m (a texture by none): package://looks/body.dae" in replaced


def test_the_urdf_is_expanded_only(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    lacking()
    expanding = ["new", "robot", "rover.urdf.xacro", "--skip-missing-packages", "--expand-only"]
    done = CliRunner().invoke(app, expanding)
    assert done.exit_code == 0, done.output
    assert '  <link name="body">\n' in done.stdout
    assert '<mesh filename="package://looks/body.dae"/>' in done.stdout
    assert not Path("rover.toml").exists()
    done = CliRunner().invoke(app, [*expanding, "-o", "expanded.urdf"])
    assert done.exit_code == 0, done.output
    assert '<link name="body">' in Path("expanded.urdf").read_text()
    done = CliRunner().invoke(app, [*expanding, "-o", "expanded.urdf"])
    assert "expanded.urdf exists; remove it" in done.output + str(done.exception)


def test_the_text_of_an_expanded_urdf_is_data(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Control characters of 8 bits, directions, and tabs in a text."""
    monkeypatch.chdir(tmp_path)
    Path("it.urdf").write_text('<robot name="it"><link name="\u009b2J\u202e"/><gazebo>\t\u009b2J</gazebo></robot>')
    done = CliRunner().invoke(app, ["new", "robot", "it.urdf", "--expand-only"])
    assert done.exit_code == 0, done.output
    assert done.stdout.isascii()
    assert "&#155;2J&#8238;" in done.stdout
    assert done.stdout.replace("\n", "").isprintable()
