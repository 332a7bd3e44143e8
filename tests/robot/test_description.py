"""Robots out of TOML and URDF."""

from pathlib import Path

import pytest

from jauspy.errors import ConfigError
from jauspy.robot.robot_files import known, load, robot_model
from jauspy.robot.xacro_files import expand


@pytest.mark.parametrize("name", known())
def test_all_robots_match_their_urdf(name: str) -> None:
    model = robot_model(load(name))
    for setup in model.groups.values():
        for joint, start in zip(map(model.description.joint, setup.joints), setup.start, strict=True):
            assert joint.lower <= start <= joint.upper
            assert joint.effort > 0.0
            assert joint.velocity > 0.0


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("urdf = 'none.urdf'", "none.urdf: there is no such file"),
        ("urdf = '.'", "is a directory; name the URDF or xacro file in it"),
        ("urdf = 'other.xml'", r"urdf: .*other.xml:1: the URDF begins with <html>, not with <robot>"),
        ("urdf = 'bad.xacro'", r"bad.xacro: xacro cannot expand it: .*nobody"),
        (
            "[tracks]\nleft = ['no']\nright = ['no']",
            "tracks.left: 'no' is not a prismatic joint.*base_link_to_left_track",
        ),
        (
            "[groups.arm]\nbase = 'b'\ntip = 'tool_link'\nJOINT",
            "groups.arm: the URDF has no link 'b'; it has: .*base_link",
        ),
        (
            "[[force_torque]]\nname = 'w'\nlink = 'base_link'",
            r"force_torque\[0\].link: nothing carries 'base_link'",
        ),
        (
            "[groups.arm]\nbase = 'base_link'\ntip = 'tool_link'\nJOINT",
            r"groups.arm.joints\[0\].name: inc1 has no joint 'elbow'; those that move are",
        ),
        (
            "[groups.arm]\nbase = 'base_link'\ntip = 'tool_link'\nBEYOND",
            r"groups.arm.joints\[0\].start = 22.2: 'base_link_to_flippers' moves from -\d.* to \d",
        ),
        (
            "[groups.arm]\nbase = 'base_link'\ntip = 'tool_link'\nFLIPPERS",
            "groups.arm.joints: the joints from base_link to tool_link that move are, in order: base_link_to_arm_link",
        ),
        ("[groups.arm]\nbase = 'base_link'\ntip = 'tool_link'\nFIXED", "'gripper_link_to_tool_link' does not move"),
    ],
)
def test_mistakes_in_a_description_are_named(tmp_path: Path, text: str, said: str) -> None:
    (tmp_path / "bad.xacro").write_text('<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:nobody/></robot>')
    (tmp_path / "other.xml").write_text("<html/>")
    gains = "position = { p = 1 }, velocity = { p = 1 }"
    text = text.replace("BEYOND", f"joints = [{{ name = 'base_link_to_flippers', start = 22.2, {gains} }}]")
    for word, joint in (
        ("JOINT", "elbow"),
        ("FLIPPERS", "base_link_to_flippers"),
        ("FIXED", "gripper_link_to_tool_link"),
    ):
        text = text.replace(word, f"joints = [{{ name = '{joint}', {gains} }}]")
    path = tmp_path / "mine.toml"
    path.write_text(f"modules = [{{ type = 'CM-MOB', component = 102 }}]\nextends = 'inc1'\n{text}")
    with pytest.raises(ConfigError, match=said):
        robot_model(load(path))


def test_consequential_errors_are_not_reported(tmp_path: Path) -> None:
    path = tmp_path / "mine.toml"
    joint = "{ name = 'base_link_to_flippers', position = { p = -1 }, velocity = { p = 1 } }"
    path.write_text(f"extends = 'inc1'\n[groups.flippers]\nbase = 'base_link'\ntip = 'flippers'\njoints = [{joint}]")
    with pytest.raises(ConfigError) as caught:
        load(path)
    assert "groups.flippers.joints[0].position.p = -1" in str(caught.value)
    assert "at least 1 item" not in str(caught.value)


@pytest.mark.parametrize(
    ("lines", "said"),
    [
        ("<xacro:nobody/>", r"a\.xacro:2: unknown macro name: xacro:nobody"),
        ('<link name="${1 +}"/>', r"a\.xacro:2: '1 \+' is not an expression"),
        (
            '<xacro:macro name="m" params="n">\n<link name="${n + gone}"/></xacro:macro>\n<xacro:m n="1"/>',
            r"a\.xacro:3: ",
        ),
        ('<xacro:include filename="gone.xacro"/>', r"a\.xacro:2: .*gone\.xacro: there is no such file"),
        ('<xacro:include filename="a.xacro"/>', r"a\.xacro:2: includes or macros contain themselves"),
        ('<xacro:include filename="b.xacro"/>', r"a\.xacro:2: .*b\.xacro:3: not XML: mismatched tag"),
        ("<link>", r"a\.xacro:3: not XML: mismatched tag"),
    ],
)
def test_mistakes_in_xacro_name_file_and_line(tmp_path: Path, lines: str, said: str) -> None:
    text = f'<robot name="a" xmlns:xacro="http://www.ros.org/wiki/xacro">\n{lines}\n</robot>'
    (tmp_path / "a.xacro").write_text(text)
    (tmp_path / "b.xacro").write_text("<robot>\n<link>\n</robot>")
    with pytest.raises(ConfigError, match=said) as caught:
        expand(str(tmp_path / "a.xacro"), with_places=True)
    assert "\n" not in str(caught.value)
