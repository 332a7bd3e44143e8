"""The file of the console's users."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

pytest.importorskip("cryptography", reason="needs the extra 'console'")

from jauspy.console import users as module
from jauspy.console.users import User, Users, add_user, remove_user
from jauspy.errors import ConfigError

COSTLY = "$argon2id$v=19$m=9999999,t=3,p=4$AAAAAAAAAAAAAAAA$AAAAAAAAAAAAAAAAAAAAAAAA"
"""A hash that takes 10 GB to verify."""


@pytest.fixture(autouse=True)
def _cheap_hashes(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "MEMORY_COST", 64)
    monkeypatch.setattr(module, "ITERATIONS", 1)


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "users.toml"


def test_users_are_added_changed_and_removed(path: Path) -> None:
    assert not add_user(path, "anna", "operator", "a long password")
    assert not add_user(path, "ben", "observer", "another password")
    assert path.stat().st_mode & 0o777 == 0o600
    assert "a long password" not in path.read_text()
    users = Users(path)
    assert list(users) == [User("anna", "operator", 127), User("ben", "observer", 0)]
    assert users.verified("anna", "a long password") == User("anna", "operator", 127)
    for name, password in (("anna", "another password"), ("nobody", "nobody has this password"), ("anna", "")):
        assert users.verified(name, password) is None

    assert add_user(path, "anna", "supervisor", "a new password")
    remove_user(path, "ben")
    users = Users(path)
    assert list(users) == [User("anna", "supervisor", 255)]
    assert users.verified("anna", "a long password") is None
    with pytest.raises(ConfigError, match="no user 'ben'"):
        remove_user(path, "ben")


def test_roles_and_comments_of_the_file_are_kept(path: Path) -> None:
    path.write_text("# our site\n[roles]\ndriver = 90\n")
    add_user(path, "anna", "driver", "a long password")
    add_user(path, "ben", "driver", "a long password")
    remove_user(path, "anna")
    assert path.read_text().startswith("# our site\n[roles]\ndriver = 90\n")
    assert list(Users(path)) == [User("ben", "driver", 90)]


@pytest.mark.parametrize(
    ("name", "role", "password", "said"),
    [
        ("a b", "operator", "a long password", "not a name"),
        ("anna", "king", "a long password", "the roles are: observer, operator, supervisor"),
        ("anna", "operator", "short", "8 to 256 characters"),
    ],
)
def test_users_that_cannot_be(path: Path, name: str, role: str, password: str, said: str) -> None:
    with pytest.raises(ConfigError, match=said):
        add_user(path, name, role, password)
    assert not path.exists()


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("[users.anna]\nrole = 'operator'\npassword = 'secret'", "not a hash"),
        (f"[users.anna]\nrole = 'operator'\npassword = '{COSTLY}'", "not a hash"),
        ("[users.anna]\nrole = 'king'\npassword = ''", "the roles are"),
        ("[users.anna]\npassword = ''", "role"),
        ("[roles]\noperator = 900", "operator"),
        ("users = 3", "users"),
        ("[users", "not TOML"),
    ],
)
def test_files_that_are_refused(path: Path, text: str, said: str) -> None:
    path.write_text(text)
    with pytest.raises(ConfigError, match=said):
        Users(path)


def test_a_file_that_all_may_change_is_refused(path: Path) -> None:
    add_user(path, "anna", "operator", "a long password")
    path.chmod(0o646)
    with pytest.raises(ConfigError, match="chmod o-w"):
        Users(path)


@pytest.mark.slow
def test_the_commands(tmp_path: Path) -> None:
    def run(*words: str, stdin: str = "") -> subprocess.CompletedProcess[str]:
        command = [sys.executable, "-m", "jauspy.cli.main", "console", *words]
        return subprocess.run(command, cwd=tmp_path, input=stdin, text=True, capture_output=True, check=False)

    added = run("user", "add", "anna", "--role", "supervisor", stdin="a long password\n")
    assert added.returncode == 0, added.stderr
    assert "anna is added, supervisor" in added.stderr
    assert "supervisor" in run("user", "ls").stdout
    made = run("certificate", "localhost", "127.0.0.1")
    assert "SHA-256 fingerprint: " in made.stdout
    assert (tmp_path / "console-key.pem").stat().st_mode & 0o777 == 0o600
    assert "exists" in run("certificate", "localhost").stderr
