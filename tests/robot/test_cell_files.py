"""The table [cell] of robots' files."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from pydantic import ValidationError

from jauspy.backends.kinematic import KinematicBackend
from jauspy.errors import ConfigError
from jauspy.platform.joints import ContactReaction
from jauspy.platform.modular.parts import POSITION_GAINS, PartKind
from jauspy.robot import robot_files
from jauspy.robot.config import GroupConfig, RobotConfig

CELL = robot_files.load("cell")

TYPES = """
[types.servo]
kind = "servo"
solids = [{ shape = "cuboid", size = [0.06, 0.05, 0.09], mass = 0.3 }]
connectors.output = { xyz = [0, 0, 0.03] }
[types.servo.servo]
max_torque = 2.5
max_speed = 9.0
friction = 0.1
damping = 0.05
stiffness = 70.0
rotor_inertia = 0.009
torque_constant = 1.6
axis = [0, 2, 0]
output = [{ shape = "cylinder", size = [0.03, 0.03, 0.02], mass = 0.12, pose = { rpy = [0, 0, 1.5] } }]
[types.base]
kind = "base"
solids = [{ shape = "cuboid", size = [0.3, 0.3, 0.2], mass = 30.0 }]
connectors = { top = { xyz = [0, 0, 0.2] }, side = { xyz = [0.15, 0, 0.1] } }
[types.box]
kind = "box"
solids = [{ shape = "cuboid", size = [0.2, 0.2, 0.2], mass = 0.5 }]
"""
ROBOT = f"""
name = "tiny"
urdf = "{Path(robot_files.__file__).parents[1]}/robots/urdf/ur10.urdf.xacro"
subsystem = 9
node = 1
[[modules]]
type = "CM-PRT"
component = 13
"""
PARTS = """
[cell]
types = "parts.toml"
parts = [
  { name = "base_1", type = "base", pose = {}, fixed = true },
  { name = "base_2", type = "base", pose = { xyz = [1, 0, 0] } },
  { name = "box_1", type = "box", pose = { xyz = [0, 1, 0] } },
  { name = "servo_1", type = "servo", pose = { xyz = [0, 2, 0] } },
]
"""


def write(folder: Path, *, robot: str = ROBOT, cell: str = PARTS, types: str = TYPES) -> RobotConfig:
    (folder / "parts.toml").write_text(types)
    (folder / "cell.toml").write_text(robot + cell)
    return robot_files.load(folder / "cell.toml")


def test_the_modules_of_the_cell_that_comes_with_jauspy():
    modules = {str(CELL.id_of(module)): (module.type, module.part) for module in CELL.modules}
    assert modules["201.1.10"] == ("CM-MAN", None)
    assert modules["201.1.11"] == ("CM-CON", "gripper")
    assert modules["201.1.12"] == ("CM-CNV", None)
    assert modules["201.1.13"] == ("CM-PRT", None)
    assert modules["201.1.20"] == ("CM-MOB", "car")
    assert modules["201.3.1"] == ("CM-ARM", "arm")
    parts = {part for id, (_, part) in modules.items() if id.startswith("201.2.")}
    assert parts == {part.name for part in CELL.cell.parts if part.type not in ("box", "wheel")}
    assert CELL.nodes == (1, 2, 3)


def test_types_of_parts_are_no_robots():
    assert "cell" in robot_files.known()
    assert not any("parts" in name for name in robot_files.known())


def test_the_model_has_what_the_file_says():
    model = robot_files.robot_model(CELL)
    assert model.tracks is None
    cell = model.cell
    assert (cell.car, cell.gripper, cell.arm) == ("car", "gripper", "arm")
    assert cell.type_of("servo_2").servo.axis == (0.0, 1.0, 0.0)
    assert cell.type_of("platform_1").kind is PartKind.BASE
    assert {part.name for part in cell.parts if part.fixed} == {"platform_1", "platform_2"}
    assert math.isfinite(cell.type_of("servo_1").servo.velocity_gains.i_limit)


def test_poses_axes_and_gains_of_a_file(tmp_path):
    cell = robot_files.robot_model(write(tmp_path)).cell
    servo = cell.type_of("servo_1").servo
    assert servo.axis == (0.0, 1.0, 0.0)
    assert servo.position_gains is POSITION_GAINS
    assert servo.output[0].pose.to_pose().yaw == pytest.approx(1.5)
    assert cell.parts[1].pose.x == 1.0


def test_parts_without_a_module_get_one_in_order(tmp_path):
    own = '[[modules]]\ntype = "CM-CON"\nnode = 2\ncomponent = 1\npart = "base_2"\n'
    config = write(tmp_path, robot=ROBOT + own)
    found = [(module.component, module.part) for module in config.modules if module.node == 2]
    assert found == [(1, "base_2"), (2, "base_1"), (3, "servo_1")]


@pytest.mark.parametrize(
    ("cell", "complaint"),
    [
        ("", "cell: is missing; 13 is a CM-PRT of a factory cell"),
        (PARTS.replace('"box"', '"crate"'), "cell.parts[2].type = 'crate': no such type; there are: base, box, servo"),
        (PARTS.replace("base_2", "base_1"), "cell.parts: base_1 is there twice"),
        (PARTS + 'car = "base_1"', "cell.car = 'base_1': must be a base that is not fixed; there are: base_2"),
        (PARTS.replace("[0, 1, 0]", "[0, nan, 0]"), "cell.parts[2].pose.xyz[1] = nan: it must be a finite number"),
        (PARTS.replace("[0, 1, 0]", "[0, 1]"), "cell.parts[2].pose.xyz[2]: is missing"),
        (PARTS + 'gripper = "hand"', "cell.gripper: the URDF has no link 'hand'"),
        (PARTS + "sensor = { rat = 5 }", "known here are: angle_noise, cameras, position_noise, rate, seed"),
        (PARTS + "attach_failure = 1.5", "attach_failure = 1.5: input should be less than or equal to 1"),
        (PARTS.replace("0, 2, 0] }", "0, 2, 0] }, fixed = true"), "'servo_1' is no base; only those are bolted down"),
        (PARTS.replace("servo_1", "servo 1"), "cell.parts[3].name = 'servo 1': a name has letters, digits and"),
        ('[cell]\nparts = []\ntypes = "lost.toml"', "lost.toml"),
    ],
)
def test_mistakes_in_a_cell_are_explained(tmp_path, cell, complaint):
    with pytest.raises(ConfigError) as error:
        robot_files.robot_model(write(tmp_path, cell=cell))
    assert complaint in str(error.value)


@pytest.mark.parametrize(
    ("before", "after", "complaint"),
    [
        ("axis = [0, 2, 0]", "axis = [0, 0, 0]", "axis = [0, 0, 0]: it must not be zero"),
        ("[0.03, 0.03, 0.02]", "[0.03, 0.04, 0.02]", "a cylinder has its radius twice"),
        ('kind = "servo"', 'kind = "tube"', "servo: parts of the kind servo need this table"),
        ('kind = "base"', 'kind = "box"', "connectors: a box has none"),
        ("mass = 0.5", "mass = 0", "they need a mass"),
        ("stiffness = 70.0", "stiffness = 0", "stiffness = 0: input should be greater than 0"),
    ],
)
def test_mistakes_in_types_of_parts_are_explained(tmp_path, before, after, complaint):
    with pytest.raises(ConfigError) as error:
        write(tmp_path, types=TYPES.replace(before, after))
    assert complaint in str(error.value)


@pytest.mark.parametrize(
    ("module", "complaint"),
    [
        ('type = "CM-SRV"', "part: is missing; a CM-SRV needs the name of its part"),
        ('type = "CM-SRV"\npart = "base_1"', "names the part 'base_1', which it cannot have; it can have: servo_1"),
        ('type = "CM-CON"\npart = "gripper"', "it can have: base_1, base_2, servo_1"),
        ('type = "CM-MOB"\npart = "car"', "it can have: none"),
        ('type = "CM-MOB"', "tracks: is missing, and so is wheels; the CM-MOB 7 drives on one"),
        ('type = "CM-CNV"', "cell.conveyor: is missing; 7 is a CM-CNV"),
        ('type = "CM-SEN"\npart = "base_1"', "part: a CM-SEN has none; leave it out"),
        ('type = "CM-ARM"\npart = "leg"', "it can have: arm"),
    ],
)
def test_modules_that_do_not_fit_the_cell_are_explained(tmp_path, module, complaint):
    with pytest.raises(ConfigError) as error:
        write(tmp_path, robot=f"{ROBOT}[[modules]]\ncomponent = 7\n{module}\n")
    assert complaint in str(error.value)


def test_the_kinematic_backend_has_no_cells():
    with pytest.raises(ConfigError, match="the kinematic backend has no factory cells"):
        KinematicBackend().open(robot_files.robot_model(CELL), "empty")


def test_contact_needs_the_model_of_the_arm() -> None:
    group = CELL.groups["ur10"]
    assert group.setup().contact is ContactReaction.STOP
    with pytest.raises(ValidationError, match=r'contact = "stop": needs feed_forward = true'):
        GroupConfig.model_validate({**group.model_dump(), "feed_forward": False})
