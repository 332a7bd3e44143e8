"""Every verb has the same options for its results: `--json` to print them, `-o` and `--output` to write them."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any

import pytest
from typer.testing import CliRunner

from jauspy.cli.main import GROUPS, app, load_verb

PRINT_NOTHING_TO_READ = {
    "export": "writes files",
    "record": "writes files",
    "live": "runs until Ctrl-C",
    "up": "runs until Ctrl-C",
    "flight-recorder": "writes files",
    "send": "has no answer",
    "teleop": "is operated with keys",
    "monitor": "is a full screen",
    "console": "runs until Ctrl-C",
    "console certificate": "writes files",
    "console user add": "changes a file",
    "console user remove": "changes a file",
    "map": "writes files",
    "planner": "runs until Ctrl-C",
    "still": "writes a file",
    "video": "prints commands to paste, or writes a file",
    "demo": "writes its results as files, summary.json among them",
    "new component": "writes files",
    "new definition": "writes a file",
    "new robot": "writes a file",
    "schema generate": "writes files",
    "dissector": "writes a file",
    "keys new": "prints lines of a TOML file",
    "keys show": "prints lines of a TOML file",
    "cell all": "writes its results as files",
    "can simulate": "runs until Ctrl-C",
    "can home": "moves drives",
    "can fault": "changes a simulated drive",
}
"""Verbs without `--json`, and why."""
WRITE_FILES = {
    "export",
    "graph",
    "dissector",
    "flight-recorder",
    "cell design",
    "demo",
    "map",
    "scene",
    "still",
    "listen",
    "video",
    "console certificate",
    "new example",
    "new definition",
    "new robot",
    "schema generate",
    "keys new",
    "cell kpi",
    "cell iso9283",
    "cell kitting",
    "cell all",
    "cell trials",
    "navigate-trials",
    "fuzz codec",
    "fuzz target",
    "fuzz python",
}
ALIASES = {
    "still": "--save",
    "video": "--save",
    "cell kpi": "--out",
    "cell iso9283": "--out",
    "cell kitting": "--out",
    "cell all": "--out",
    "cell trials": "--out",
    "fuzz codec": "--out",
}
"""What was the name of the option before; it still works."""
OTHER_FORMATS = {"conformance": {"--junit", "--html", "--pcapng"}, "node-manager": {"--log"}}
OLD_NAMES = {"--save", "--out", "--file", "--dir", "--to-file"}


def leaves(name: str, command: Any) -> Iterator[tuple[str, Any]]:
    if getattr(command, "commands", None):
        for child, below in command.commands.items():
            yield from leaves(f"{name} {child}", below)
        if not command.invoke_without_command:
            return
    yield name, command


def verbs() -> dict[str, set[str]]:
    """The options of every verb."""
    found = {}
    for group, members in GROUPS.items():
        for name, (target, _) in members.items():
            whole = name if group == "jauspy" else f"{group} {name}"
            for leaf, command in leaves(whole, load_verb(name, target)):
                found[leaf] = {option for parameter in command.params for option in parameter.opts}
    return found


VERBS = verbs()


@pytest.mark.parametrize("verb", VERBS)
def test_a_verb_that_prints_a_result_has_json(verb: str) -> None:
    assert ("--json" in VERBS[verb]) is (verb not in PRINT_NOTHING_TO_READ)


@pytest.mark.parametrize("verb", VERBS)
def test_a_verb_that_writes_files_has_output(verb: str) -> None:
    options = VERBS[verb]
    assert {"-o", "--output"} & options == ({"-o", "--output"} if verb in WRITE_FILES else set())
    assert options & OLD_NAMES == ({ALIASES[verb]} if verb in ALIASES else set())
    assert OTHER_FORMATS.get(verb, set()) <= options


def test_the_tables_name_verbs_that_exist() -> None:
    for table in (PRINT_NOTHING_TO_READ, WRITE_FILES, ALIASES, OTHER_FORMATS):
        assert set(table) <= set(VERBS)


def test_examples_are_listed_as_json() -> None:
    rows = [json.loads(line) for line in CliRunner().invoke(app, ["new", "example", "--json"]).output.splitlines()]
    assert {"scans", "verbs"} <= {row["name"] for row in rows}
    assert all(row["title"] for row in rows)


def test_the_place_of_a_map_is_given_once(tmp_path) -> None:
    for arguments in ([], [str(tmp_path / "a"), "-o", str(tmp_path / "b")]):
        found = CliRunner().invoke(app, ["map", *arguments])
        assert found.exit_code == 2
        assert "give OUT once" in found.output
