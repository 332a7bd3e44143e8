"""Tables of the dissector: literals of Lua, names of filters, and the verb that writes the file."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from typer.testing import CliRunner

from jauspy.cli.main import app
from jauspy.codec.registry import Hints
from jauspy.inspection.dissector import make_dissector
from jauspy.inspection.dissector.tables import ARRAY, Tables, quoted, source
from jauspy.messages import registry
from jauspy.messages.core.v1_1.access_control import RequestControl
from jauspy.messages.mobility.v1_1.local_pose_sensor import ReportLocalPose


@pytest.mark.parametrize(
    ("text", "literal"),
    [
        ("plain", '"plain"'),
        ('a"b', r'"a\034b"'),
        ("a\\b", r'"a\092b"'),
        ("m/s²", r'"m/s\194\178"'),
        ("line\nbreak", r'"line\092nbreak"'),
    ],
)
def test_texts_are_quoted(text: str, literal: str) -> None:
    assert quoted(text) == literal


def test_values_become_expressions() -> None:
    made = source({"name": "x", 3: True, "ends": [1.5, float("-inf")], ARRAY: [{"a": -1}]})
    assert made == '{name="x",[3]=true,ends={1.5,-math.huge},{a=-1}}'


def test_fields_have_the_names_of_our_decoder() -> None:
    tables = Tables()
    assert tables.message(RequestControl)["body"][ARRAY][0]["path"] == "jaus.core.request_control.authority_code"
    parts = tables.message(ReportLocalPose)["body"][ARRAY]
    assert [part["path"].rpartition(".")[2] for part in parts] == [s.name for s in ReportLocalPose.layout().slots]


@pytest.mark.slow
def test_names_of_filters_are_valid_and_unique() -> None:
    text = make_dissector(registry).text
    paths = re.findall(r'path="([^"]*)"', text)
    assert len(paths) == len(set(paths)) == make_dissector(registry).fields
    assert all(re.fullmatch(r"jaus(\.[a-z0-9_]+){3,}", path) for path in paths)


@pytest.mark.slow
def test_ambiguous_ids_are_named_and_hints_choose() -> None:
    collision = registry.collisions[0]
    assert f"[{collision.code}]=" in make_dissector(registry).text.partition("local AMBIGUOUS")[2].partition("\n}")[0]
    first = collision.entries[0]
    chosen = make_dissector(registry, Hints(service=first.service, message=first.name)).text
    assert f"[{collision.code}]=" not in chosen.partition("local AMBIGUOUS")[2].partition("\n}")[0]


@pytest.mark.slow
def test_the_verb_writes_the_file(tmp_path: Path) -> None:
    file = tmp_path / "jaus.lua"
    done = CliRunner().invoke(app, ["dissector", "-o", str(file), "--version", "1.0"])
    assert done.exit_code == 0, done.output
    assert file.read_text("utf-8") == make_dissector(registry, Hints(version="1.0")).text


def test_the_verb_says_why_the_file_cannot_be_written(tmp_path: Path) -> None:
    done = CliRunner().invoke(app, ["dissector", "-o", str(tmp_path)])
    assert (done.exit_code, done.stderr.count("\n")) == (1, 1)
    assert "cannot be written: Is a directory" in done.stderr
