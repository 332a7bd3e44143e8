"""The file of the console's users."""

from __future__ import annotations

import os
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


def costing(memory: int, iterations: int, lanes: int = 4, salt: int = 22, key: int = 43) -> str:
    return f"$argon2id$v=19$m={memory},t={iterations},p={lanes}${'A' * salt}${'A' * key}"


@pytest.mark.parametrize(
    "hash",
    [
        costing(64 << 20, 3),
        costing(1 << 20, 3),
        costing((1 << 18) + 1, 1),
        costing(1 << 18, 5),
        costing(65536, 99),
        costing(65536, 0),
        costing(65536, 3, 0),
        costing(65536, 3, 99),
        costing(65536, 3, key=100_000),
        costing(65536, 3, salt=100_000),
        costing(65536, 3).replace("65536", "\u0666\u0665\u0665\u0663\u0666"),
        costing(65536, 3).replace("argon2id", "argon2i"),
        "$2b$12$" + "a" * 53,
        "plain",
    ],
)
def test_hashes_that_cost_gigabytes_or_minutes_are_refused(path: Path, hash: str) -> None:
    path.write_text(f"[users.anna]\nrole = 'operator'\npassword = '{hash}'\n")
    with pytest.raises(ConfigError, match="not a hash"):
        Users(path)


@pytest.mark.parametrize("hash", [costing(65536, 3), costing(1 << 18, 4), costing(1 << 16, 16, 16)])
def test_hashes_of_other_programs_are_taken(path: Path, hash: str) -> None:
    path.write_text(f"[users.anna]\nrole = 'operator'\npassword = '{hash}'\n")
    assert len(Users(path)) == 1


USER = f"role = 'operator'\npassword = '{costing(65536, 3)}'\n"
HOSTILE = {
    "nested lists": b"a = " + b"[" * 100_000,
    "dotted keys": b"users" + b".a" * 20_000 + b" = 1",
    "not UTF-8": b"[users.\xff]",
    "a user twice": f"[users.anna]\n{USER}[users.anna]\n{USER}".encode(),
    "a huge number": b"[roles]\noperator = " + b"9" * 5000,
    "a name with escapes": f'[users."\\u001b]0;x"]\n{USER}'.encode(),
    "a name of HTML": f'[users."<img src=x onerror=alert(1)>"]\n{USER}'.encode(),
    "the name of the console": f'[users."(console)"]\n{USER}'.encode(),
    "a name that ends a bracket": f'[users."anna] forged"]\n{USER}'.encode(),
    "a long name": f"[users.{'x' * 100_000}]\n{USER}".encode(),
    "a role of HTML": b'[roles]\n"<b>x</b>" = 5\n',
    "a role that is not a number": b"[roles]\noperator = nan\n",
    "an authority of 1e999": b"[roles]\noperator = 1e999\n",
    "many mistakes": b"".join(b"[users.u%d]\nx = 1\n" % n for n in range(10_000)),
    "many users": "".join(f"[users.u{n}]\n{USER}" for n in range(2000)).encode(),
    "huge": b"#" * (module.MAX_FILE + 1),
}


@pytest.mark.parametrize("data", HOSTILE.values(), ids=HOSTILE)
def test_a_file_made_to_do_harm_is_a_short_error(path: Path, data: bytes) -> None:
    path.write_bytes(data)
    with pytest.raises(ConfigError) as found:
        Users(path)
    assert all(line.isprintable() for line in str(found.value).split("\n"))
    assert len(str(found.value)) < 2000


def test_a_file_that_is_no_file_is_refused(path: Path) -> None:
    os.mkfifo(path, 0o600)
    with pytest.raises(ConfigError, match="is not a regular file"):
        Users(path)
    path.unlink()
    path.symlink_to("/dev/zero")
    with pytest.raises(ConfigError):
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
