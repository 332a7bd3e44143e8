"""A file author writes a robot's TOML: the table in docs/security.md of what it causes, row by row."""

from __future__ import annotations

import dataclasses
import re
from pathlib import Path
from typing import Final

import pytest

from jauspy import backends
from jauspy.errors import ConfigError
from jauspy.platform.servo_drives import CanTable
from jauspy.robot import config as tables, robot_files
from jauspy.robot.audit import AuditLog
from jauspy.robot.config import RobotConfig
from jauspy.robot.hour_meter import HourMeterFile
from jauspy.robot.operators import command_seals

DOCUMENT: Final = Path(__file__).parents[2] / "docs" / "security.md"
SECRET: Final = "s3cr3t"
JOINT: Final = next(iter(robot_files.load("inc1").groups.values())).joints[0].name
DRIVE: Final = "[can.drives.d]\nnode = 1\njoint = '{{joint}}'\nencoder_counts = 1\ntravel = 1.0\n"
CLOUD: Final = '[[clouds]]\nsource = "lidar"\naddress = "{}"\n'
REFUSED: Final = {
    "extends": ['extends = "{secret}"', 'extends = "/dev/zero"', 'extends = "it.toml"'],
    "urdf": ['urdf = "{secret}"', 'urdf = "/dev/zero"', 'urdf = "."'],
    "operators": ['operators = "{secret}"', 'operators = "/dev/zero"', 'operators = "."'],
    "audit_log": [
        f'operators = "operators.toml"\naudit_log = "{path}"' for path in ("{secret}", "../new", "link", ".new", ".")
    ],
    "record_to": [f'record_to = "{path}"' for path in ("{secret}", "../new", "link", "home", "home/new", ".new", ".")],
    "health.hour_meter": [
        f'[health]\nhour_meter = "{path}"'
        for path in ("{secret}", "../new", "link", "home/new", ".new", ".", "it.toml")
    ],
    "cell.types": ['[cell]\ntypes = "{secret}"', '[cell]\ntypes = "/dev/zero"'],
    "can.drives.NAME.eds": [DRIVE.replace("{{joint}}", "{joint}") + 'eds = "{secret}"\n'],
    "can.bus": [
        f'can.bus = "{bus}"\n{DRIVE}'
        for bus in (
            "slcan:spy:///dev/null?file={secret}",
            "slcan:socket://host:1",
            "slcan:{secret}",
            "slcan:/dev/../{secret}",
            "usb2can:1,dll=x.dll",
            "socketcan:can0,path=/x",
        )
    ],
    "clouds": [
        CLOUD.format(address)
        for address in ("ipc://{secret}", "abstract:x", "tls+tcp://a:1", "ws://a:1/x", "inproc://a", "tcp://a:1/x")
    ],
    "backend": ['backend = "os:system"', 'backend = "../evil"', 'backend = "json"'],
    "modules.services": ['[[modules]]\ntype = "CM-MOB"\ncomponent = 102\nservices = ["Discovery", "os:system"]'],
    "modules.announce_to": [
        '[[modules]]\ntype = "CM-MOB"\ncomponent = 102\nannounce_to = "255.255.255"',
        '[[modules]]\ntype = "CM-MOB"\ncomponent = 102\nannounce_to = "udp://10.0.0.1"',
    ],
    "video_targets": ['video_targets = ["224.0.0.0/4"]', 'video_targets = ["0.0.0.0"]'],
    "xacro_arguments": ['urdf = "args.xacro"\nxacro_arguments = {{ file = "{secret}" }}'],
    "package_path": ['urdf = "found.xacro"\npackage_path = ["{home}", "/"]'],
    "skip_missing_packages": ['urdf = "found.xacro"\npackage_path = ["/"]\nskip_missing_packages = true'],
    "placeholder_meshes": ['urdf = "mesh.urdf"\nplaceholder_meshes = true'],
}
"""By key: values that are refused in one sentence. Robots' files have no others that name something outside."""
SAID: Final = {
    "extends": r"/secret|/dev/zero|extends",
    "urdf": r"urdf: ",
    "operators": r"/secret|/dev/zero|is not a regular file",
    "cell.types": r"/secret|/dev/zero",
    "can.drives.NAME.eds": r"drives\.\w+\.eds",
    "clouds": "is not tcp://HOST:PORT",
    "can.bus": "give others by --bus",
    "modules.services": "os:system",
    "modules.announce_to": "announce_to",
    "xacro_arguments": "is not read, because",
    "package_path": "is not read, because",
    "skip_missing_packages": "is not read, because",
    "placeholder_meshes": "is not read, because",
}
"""What the refusal has; else the key."""
HARMLESS: Final = {"world", "model_path"}
"""Tested in `test_worlds_of_strangers`, since they need the simulator."""


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    folder = tmp_path / "home" / "robot"
    folder.mkdir(parents=True)
    (folder.parent / "secret").write_text(f"key: {SECRET}\n")
    (folder / "link").symlink_to("../secret")
    (folder / "home").symlink_to("..")
    (folder / "operators.toml").write_text("[operators]\n")
    reading = (
        '<robot name="it" xmlns:xacro="http://www.ros.org/wiki/xacro">{}<link name="${{xacro.load_yaml({})}}"/></robot>'
    )
    (folder / "args.xacro").write_text(reading.format('<xacro:arg name="file" default=""/>', "'$(arg file)'"))
    mesh = '<visual><geometry><mesh filename="../secret"/></geometry></visual>'
    (folder / "mesh.urdf").write_text(f'<robot name="it"><link name="l">{mesh}</link></robot>')
    (folder / "found.xacro").write_text(reading.format("", "'$(find home)/secret'"))
    monkeypatch.setenv("HOME", str(folder.parent))
    return folder


def _use(path: Path) -> None:
    """What happens with a file when the robot starts, without the robot."""
    config: RobotConfig = robot_files.load(path)
    command_seals(config, None)
    backends.find(config.backend)
    model = robot_files.robot_model(config)
    if isinstance(model.can, str):  # is an error when the backend is `can`
        raise ConfigError(model.can)
    if config.audit_log is not None:
        with AuditLog(Path(config.audit_log), config.name):
            pass
    if config.health.hour_meter is not None:
        HourMeterFile(Path(config.health.hour_meter))


@pytest.mark.parametrize(("key", "line"), [(key, line) for key, lines in REFUSED.items() for line in lines])
def test_a_robot_file_cannot(folder: Path, key: str, line: str) -> None:
    path = folder / "it.toml"
    text = line.format(secret=folder.parent / "secret", home=folder.parent, joint=JOINT)
    path.write_text(text if text.startswith("extends") else f'extends = "inc1"\nbackend = "kinematic"\n{text}\n')
    if "backend = " in text:
        path.write_text(f'extends = "inc1"\n{text}\n')
    before = sorted(folder.parent.rglob("*"))
    with pytest.raises(ConfigError) as caught:
        _use(path)
    assert re.search(SAID.get(key, key), str(caught.value))
    assert SECRET not in str(caught.value)
    assert sorted(folder.parent.rglob("*")) == before
    assert (folder.parent / "secret").read_text() == f"key: {SECRET}\n"


def test_the_table_in_the_documentation_has_these_rows() -> None:
    section = DOCUMENT.read_text().partition("| key of a robot's file |")[2].partition("\n\n")[0]
    rows = {
        name for cell in re.findall(r"^\| ([^|]+) \|", section, re.MULTILINE) for name in re.findall(r"`([^`]+)`", cell)
    }
    assert rows == {*REFUSED, *HARMLESS}


def test_no_other_key_is_a_free_text_that_names_something() -> None:
    """A new key with a text of any form needs a row here, or a place in this list."""
    named = {"name", "description", "xacro_arguments", "poses"}
    keys = {key for key, field in RobotConfig.model_fields.items() if "str" in str(field.annotation)}
    assert keys <= named | set(REFUSED) | HARMLESS | {"backend", "joint_limits", "groups"}
    assert "bus" in {field.name for field in dataclasses.fields(CanTable)}
    assert "address" in tables.CloudConfig.model_fields
    health = {key for key, field in tables.HealthConfig.model_fields.items() if "str" in str(field.annotation)}
    assert health == {"hour_meter"}, "reminders have texts for people"
