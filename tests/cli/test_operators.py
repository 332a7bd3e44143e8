"""Operators from the command line: keys, a robot that requires them, and what is said to those who have none."""

import contextlib
import re
import stat
import subprocess
from pathlib import Path

import psutil
import pytest
from tests.helpers.command_line import JAUSPY

from jauspy.cli import operators
from jauspy.errors import ConfigError
from jauspy.robot import robot_files
from jauspy.robot.operators import load

pytest.importorskip("cryptography", reason="keys of operators need the extra 'operators'")

DRIVE = ("send", "101.1.102", "SetWrenchEffort", "propulsive_linear_effort_x=40", "--control", "200")


@pytest.fixture
def folder(tmp_path, capsys):
    """A folder with the key of alice, and the operators file that names her."""
    operators.new(name="alice", output=tmp_path / "alice.key")
    (tmp_path / "operators.toml").write_text(capsys.readouterr().out)
    return tmp_path


def test_keys(folder, capsys):
    key, file = folder / "alice.key", folder / "operators.toml"
    assert stat.S_IMODE(key.stat().st_mode) == 0o600
    operators.show(file=key)
    assert capsys.readouterr().out in file.read_text()
    (alice,) = load(file)
    assert (alice.name, alice.role, alice.authority) == ("alice", "operator", 127)
    with pytest.raises(ConfigError, match="operator /dev/zero: is not a regular file"):
        operators.show(file=Path("/dev/zero"))
    with pytest.raises(ConfigError, match="exists"):
        operators.new(name="alice", output=key)
    with pytest.raises(ConfigError, match="letters"):
        operators.new(name='a"b', output=folder / "b.key")
    with pytest.raises(ConfigError, match="cannot write"):
        operators.new(name="b", output=folder / "none" / "b.key")


@pytest.mark.parametrize("before", ["", "[operators]\n", "[roles]\nking = 255\n"])
def test_what_is_printed_may_follow_anything(folder, capsys, before):
    bob = folder / "bob.key"
    operators.new(name="bob", output=bob)
    file = folder / "operators.toml"
    file.write_text(f"{before}{file.read_text()}{capsys.readouterr().out}")
    assert [each.name for each in load(file)] == ["alice", "bob"]


@pytest.mark.parametrize(
    ("text", "reported"),
    [
        ("", "operators: is missing"),
        ("?", "is not TOML"),
        ("[operators]\na = 1", "operators.a = 1"),
        ('[operators]\na = { role = "king", key = "KEY" }', "the roles are: observer, operator, supervisor"),
        ('[operators]\na = { role = "operator", key = "ed25519:AAAA" }', "operators.a.key: a public key has 32 bytes"),
        (
            '[operators]\na = { role = "operator", key = "KEY" }\nb = { role = "operator", key = "KEY" }',
            "is also that of",
        ),
        ("[operators]\n[roles]\nking = 256", "roles.king = 256"),
    ],
)
def test_an_operators_file_that_is_wrong(folder, text, reported):
    file = folder / "operators.toml"
    key = file.read_text().partition('key = "')[2].partition('"')[0]
    file.write_text(text.replace("KEY", key))
    with pytest.raises(ConfigError, match=re.escape(reported)):
        load(file)


def test_roles_are_set_by_the_file(folder):
    file = folder / "operators.toml"
    file.write_text(file.read_text().replace('"operator"', '"driver"') + "[roles]\ndriver = 90\n")
    assert [each.authority for each in load(file)] == [90]
    file.chmod(0o666)
    with pytest.raises(ConfigError, match="chmod o-w"):
        load(file)


@pytest.mark.parametrize("key", ["require_operator = true", 'audit_log = "log"'])
def test_keys_of_a_robot_that_need_operators(folder, key):
    (folder / "robot.toml").write_text(f'extends = "inc1"\n{key}\n')
    with pytest.raises(ConfigError, match="needs operators"):
        robot_files.load(folder / "robot.toml")


@pytest.fixture
def robot(folder, free_port, local_root):
    keys = ['extends = "inc1"', 'backend = "kinematic"', 'operators = "operators.toml"', 'audit_log = "robot.audit"']
    (folder / "robot.toml").write_text("\n".join(keys))
    command = ["up", str(folder / "robot.toml"), "--port", str(free_port), "--interface", "127.0.0.1"]
    process = subprocess.Popen(
        [*JAUSPY, *command, "--local-root", str(local_root)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    assert any("stop it" in line for line in process.stdout), process.stderr.read()
    family = psutil.Process(process.pid).children(recursive=True)
    yield process
    with contextlib.suppress(ProcessLookupError):
        process.terminate()
    process.communicate(timeout=30)
    assert not psutil.wait_procs(family, timeout=30)[1]


@pytest.mark.slow
def test_a_robot_that_requires_operators(robot, folder, local_root, capsys):
    def drive(*more):
        command = [*JAUSPY, *DRIVE, "--connect", f"local:{local_root}", *more]
        return subprocess.run(command, capture_output=True, text=True, check=False, timeout=60)

    refused, driven = drive(), drive("--operator-key", str(folder / "alice.key"))
    assert (refused.returncode, driven.returncode, driven.stderr) == (1, 0, "")
    assert "refused RequestControl: it has no seal" in refused.stderr
    operators.audit(path=folder / "robot.audit", operators=folder / "operators.toml")
    assert re.search(r"commands: \d+ of alice, 1 of -; 1 refused", capsys.readouterr().out)
