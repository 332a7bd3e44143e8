"""Files that a user names: devices, pipes, sizes and nesting that would never end."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from jauspy import user_files
from jauspy.errors import ConfigError
from jauspy.node.address_books import load_address_book
from jauspy.node.config import load_config, load_key
from jauspy.robot import robot_files
from jauspy.user_files import parse_toml

NESTED = "networks = " + "[" * 20_000 + "]" * 20_000


@pytest.fixture
def pipe(tmp_path: Path) -> Path:
    path = tmp_path / "pipe.toml"
    os.mkfifo(path)
    return path


def test_what_never_ends_is_refused(pipe: Path, tmp_path: Path) -> None:
    zero = Path("/dev/zero")
    for read in (robot_files.load, load_config, load_address_book):
        with pytest.raises(ConfigError, match=r"pipe\.toml: is not a regular file"):
            read(pipe)
    with pytest.raises(ConfigError, match="key_file /dev/zero: is not a regular file"):
        load_key(zero)
    robot = tmp_path / "robot.toml"
    robot.write_text('extends = "/dev/zero"')
    with pytest.raises(ConfigError, match="/dev/zero: is not a regular file"):
        robot_files.load(robot)


def test_a_file_that_is_too_large_is_not_read(tmp_path: Path) -> None:
    path = tmp_path / "large.toml"
    with path.open("wb") as file:
        file.truncate(1 << 40)
    with pytest.raises(ConfigError, match=r"large\.toml: has more than 16 MiB"):
        user_files.read_file(path)


@pytest.mark.slow
def test_deep_nesting_is_one_sentence(tmp_path: Path) -> None:
    path = tmp_path / "deep.toml"
    path.write_text(NESTED)
    for read in (robot_files.load, load_config, load_address_book):
        with pytest.raises(ConfigError, match=r"deep\.toml: (is )?(nested too deeply|.*too deep)"):
            read(path)
    for name, text in (("deep.yaml", "[" * 20_000), ("deep.cfg", "<a>" * 20_000)):
        (tmp_path / name).write_text(text)
        with pytest.raises(ConfigError, match=f"address book .*{name}"):
            load_address_book(tmp_path / name)


@pytest.mark.slow
def test_many_addresses_of_one_id_take_no_time_to_speak_of(tmp_path: Path) -> None:
    path = tmp_path / "many.cfg"
    entries = "".join(f'<AddressBook J1="10.0.{port % 200}.5:{port}"/>' for port in range(1, 60_000))
    path.write_text(f"<c>{entries}</c>")
    ((ports,)) = load_address_book(path).values()
    assert len(ports) == 59_999


def test_aliases_that_grow_are_refused(tmp_path: Path) -> None:
    """The text of this list of lists would have gigabytes."""
    lists = "".join(f"a{n}: &a{n} [{', '.join([f'*a{n - 1}'] * 10)}]\n" for n in range(1, 10))
    path = tmp_path / "book.yaml"
    path.write_text(f'a0: &a0 [101.1.1]\n{lists}addrbook: {{udp: {{"10.0.0.5:3794": *a9}}}}\n')
    with pytest.raises(ConfigError, match="aliases are not read"):
        load_address_book(path)


@pytest.mark.parametrize(
    "text", ["a" + ".a" * 20_000 + " = 1", "[a" + " . 'b='" * 20_000 + "]", 'x.y = {"a"' + '."\\"]"' * 20_000 + " = 1}"]
)
def test_keys_of_thousands_of_parts_are_refused_at_once(text: str) -> None:
    with pytest.raises(ConfigError, match=r"x\.toml: is nested too deeply"):
        parse_toml(text.encode(), "x.toml")


def test_a_number_of_thousands_of_digits_is_one_sentence() -> None:
    with pytest.raises(ConfigError, match=r"x\.toml: is not TOML: Exceeds the limit"):
        parse_toml(b"a = " + b"9" * 5000, "x.toml")


def test_long_arrays_of_numbers_are_not_deep() -> None:
    assert len(parse_toml(b"a = [" + b"0.5," * 50_000 + b"]", "x.toml")["a"]) == 50_000
