"""`jauspy fuzz`: exit status, progress and findings."""

import json
import re
from pathlib import Path

import pytest
from typer.testing import CliRunner

from jauspy.cli.main import app
from jauspy.codec.items import Number
from jauspy.messages import registry
from jauspy.messages.core import ConfirmControl

LAMP = Path(__file__).parents[1] / "vendor" / "Lamp.xml"
VERSIONS = len(registry.by_code(ConfirmControl.CODE))


def run(*arguments):
    return CliRunner().invoke(app, ["fuzz", *map(str, arguments)])


def test_campaign_without_findings_succeeds(tmp_path):
    result = run("codec", "--cases", 300, "--message", "ConfirmControl", "--out", tmp_path / "out")
    assert result.exit_code == 0
    assert re.fullmatch(rf"300 cases from \d+ seeds of {VERSIONS} messages: nothing found\n", result.stdout)
    assert result.stderr.splitlines()[-1].startswith("300 of 300 cases, ")
    assert not (tmp_path / "out").exists()


def test_hex_files_are_used_as_seeds(tmp_path):
    (tmp_path / "seeds.hex").write_text("0f0009\n02001000010a017e0014017e0002200200\n")
    result = run("codec", tmp_path / "seeds.hex", "--cases", 10, "--message", "confirmcontrol")
    with_files = int(result.stdout.split()[3])
    result = run("codec", "--cases", 10, "--message", "confirmcontrol")
    assert with_files == int(result.stdout.split()[3]) + VERSIONS


def test_file_without_messages_is_skipped(tmp_path):
    (tmp_path / "empty.hex").write_text("")
    (tmp_path / "seeds.hex").write_text("0f0009\n")
    with_both = run(
        "codec", tmp_path / "empty.hex", tmp_path / "seeds.hex", "--cases", 10, "--message", "ConfirmControl"
    )
    assert with_both.exit_code == 0
    assert f"{tmp_path / 'empty.hex'} has no JAUS messages and is ignored" in with_both.stderr
    assert with_both.stdout == run("codec", tmp_path / "seeds.hex", "--cases", 10, "--message", "ConfirmControl").stdout


@pytest.mark.slow
def test_equal_campaigns_print_the_same():
    one, other = (run("codec", "--cases", 1700, "--message", "ConfirmControl") for _ in range(2))
    assert (one.stdout, one.stderr) == (other.stdout, other.stderr)
    assert [line.split(",")[0] for line in one.stderr.splitlines()] == [
        f"{done} of 1700 cases" for done in (0, 500, 1000, 1500, 1700)
    ]


def test_findings_are_saved(tmp_path, monkeypatch):
    def broken(data, nesting):
        raise ZeroDivisionError(nesting)

    monkeypatch.setattr(ConfirmControl, "_unpack", broken)
    result = run("codec", "--cases", 20, "--message", "ConfirmControl", "--out", tmp_path)
    assert result.exit_code == 1
    (file,) = tmp_path.iterdir()
    assert file.name == "decode-ConfirmControl-1.1-ZeroDivisionError.json"
    assert json.loads(file.read_text())["hex"] == "0f00"
    assert f"jauspy fuzz replay {file}" in result.stdout
    assert run("replay", file).exit_code == 1


def test_user_defined_messages_are_fuzzed(tmp_path):
    result = run("codec", "--schemas", LAMP, "--cases", 30, "--out", tmp_path)
    assert result.exit_code == 0, result.output
    assert re.fullmatch(r"30 cases from \d+ seeds of 3 messages: nothing found\n", result.stdout)


def test_findings_in_user_defined_messages_are_replayed(tmp_path, monkeypatch):
    write = Number.write
    monkeypatch.setattr(Number, "write", lambda self, writer, value, path: write(self, writer, value ^ 1, path))
    result = run("codec", "--schemas", LAMP, "--cases", 20, "--message", "SetLamp", "--out", tmp_path)
    (file,) = tmp_path.iterdir()
    assert f"jauspy fuzz replay {file} --schemas {LAMP}\n" in result.stdout
    assert result.stdout.endswith(": 1 finding\n")
    assert run("replay", file, "--schemas", LAMP).exit_code == 1
    monkeypatch.undo()
    assert run("replay", file, "--schemas", LAMP).exit_code == 0
    assert run("replay", file).exit_code == 2


@pytest.mark.parametrize(
    "arguments",
    [
        ("codec", "no-such-file"),
        ("codec", "--schemas", "no-such-file"),
        ("codec", "--schemas", __file__),
        ("codec", "--message", "NoSuchMessage"),
        ("codec", "--cases", "0"),
        ("codec", __file__),
        ("replay", "no-such-file"),
        ("replay", __file__),
    ],
)
def test_wrong_usage_ends_with_status_2(arguments):
    assert run(*arguments).exit_code == 2
