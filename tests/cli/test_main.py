"""The command as a whole: help, wrong use, errors."""

import os
import subprocess
import sys
from importlib import import_module

import pytest
from typer.testing import CliRunner

from jauspy import __version__
from jauspy.cli.main import GROUPS, PANEL_OF, VERBS, app, load_verb
from jauspy.errors import ConfigError


def run(*arguments, status=0):
    result = CliRunner().invoke(app, list(arguments))
    assert result.exit_code == status, result.output
    return result


@pytest.mark.parametrize("verb", sorted(VERBS))
def test_every_verb_has_help_with_an_example(verb):
    text = run(verb, "--help").output
    assert f"jauspy {verb} " in text.partition("Example")[2]


def leaves(name, command):
    """Every verb below a command, with its help."""
    if getattr(command, "commands", None):
        for child, below in command.commands.items():
            yield from leaves(f"{name} {child}", below)
    else:
        yield name, command.help or ""


@pytest.mark.parametrize(("group", "verb"), [(group, verb) for group, verbs in GROUPS.items() for verb in verbs])
def test_every_verb_of_a_group_has_help_with_an_example(group, verb):
    name = verb if group == "jauspy" else f"{group} {verb}"
    for leaf, text in leaves(name, load_verb(verb, GROUPS[group][verb][0])):
        assert f"jauspy {leaf}" in text.partition("Example")[2], leaf


def test_every_verb_has_a_heading_in_the_help():
    assert set(PANEL_OF) >= {*VERBS, *GROUPS} - {"jauspy"}
    text = run("--help").output
    assert "Run robots" in text
    assert "Commands" not in text.replace("COMMAND", "")


@pytest.mark.slow
@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_there_is_completion(shell):
    variable = "_JAUSPY_COMPLETE"

    def complete(instruction, **environment):
        done = subprocess.run(
            [sys.executable, "-c", "import sys; sys.argv[0] = 'jauspy'; from jauspy.cli import main; main()"],
            env={**os.environ, variable: f"{instruction}_{shell}", "_TYPER_COMPLETE_ARGS": "", **environment},
            capture_output=True,
            text=True,
            check=False,
        )
        return done.stdout

    assert variable in complete("source")
    words = "jauspy fuzz target --rest"
    cursor = {"COMP_WORDS": words, "COMP_CWORD": "3"}  # bash
    found = complete("complete", **cursor, _TYPER_COMPLETE_ARGS=words, _TYPER_COMPLETE_FISH_ACTION="get-args")
    assert "--restart" in found


def test_help_lists_the_verbs():
    text = run("--help").output
    assert all(verb in text for verb in VERBS)


def test_help_imports_no_heavy_modules():
    code = (
        "import sys\nfrom jauspy.cli.main import app\napp(['--help'], standalone_mode=False)\n"
        "print([m for m in ('asyncio', 'construct', 'dpkt', 'lxml', 'mujoco', 'pydantic', 'yaml') if m in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.splitlines()[-1] == "[]"


def test_version():
    assert run("--version").output == f"jauspy {__version__}\n"


@pytest.mark.parametrize(
    "arguments", [["fly"], ["query"], ["decode", "--nonsense", "00"], ["up", "inc1", "--port", "0"]]
)
def test_wrong_usage_ends_with_status_2(arguments):
    run(*arguments, status=2)


def test_errors_are_one_sentence_without_debug_option():
    assert run("query", "101.1", "QueryStatus", status=1).stderr.startswith("Error: '101.1' is not a JAUS id")
    result = CliRunner().invoke(app, ["--debug", "query", "101.1", "QueryStatus"])
    assert isinstance(result.exception, ConfigError)


def test_query_rejects_commands():
    assert "use `jauspy send`" in run("query", "101.1.1", "Resume", status=1).stderr


def test_send_rejects_queries():
    assert "use `jauspy query`" in run("send", "101.1.1", "QueryStatus", status=1).stderr


@pytest.mark.parametrize("verb", ["query", "send"])
def test_ids_with_zeros_are_rejected(verb):
    assert "101.1.0 is not the id of a component" in run(verb, "101.1.0", "QueryStatus", status=1).stderr


def test_option_within_requires_control():
    assert "it requires --control" in run("send", "101.1.1", "Resume", "--within", "1", status=2).stderr


def test_control_of_a_wildcard_is_rejected():
    assert "control of one component" in run("send", "101.1.255", "Resume", "--control", "9", status=1).stderr


@pytest.mark.parametrize(("group", "name"), [(group, name) for group, verbs in GROUPS.items() for name in verbs])
def test_help_line_is_the_first_line_of_the_verbs_help(group, name):
    target, line = GROUPS[group][name]
    module, _, function = target.partition(":")
    assert (getattr(import_module(module), function).__doc__ or "").partition("\n")[0] == line


def test_verb_module_is_imported_when_the_verb_runs():
    script = "import sys; import jauspy.cli.main as main; print([m for m in sys.modules if m.startswith('jauspy.ocu')])"
    assert subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True).stdout == "[]\n"
