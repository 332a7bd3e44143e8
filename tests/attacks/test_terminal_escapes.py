"""A peer sends texts that would control a terminal, forge lines or turn them around: they are shown as escapes."""

from __future__ import annotations

import io
import json
import logging
import re
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Final

import pytest
from hypothesis import given, strategies as st
from typer.testing import CliRunner

import jauspy
from jauspy.cli import console, up_table
from jauspy.cli.conformance import show
from jauspy.cli.main import app
from jauspy.conformance import reports
from jauspy.conformance.results import Report, Result, Verdict
from jauspy.errors import RequestError
from jauspy.messages.core import ReportIdentification
from jauspy.printable import printable, printable_lines
from jauspy.testing import LocalNode

FORGED: Final = "Error: all is well"
TEXT: Final = f"\x1b]0;title\x07\x1b[2J\x9b31mred\x08\x7f\x85\x1bPq\x9c\r\n{FORGED}"
"""A title, an empty screen, a colour in eight bits, and a line of its own; all that Latin-1 has."""
TURNED: Final = f"{TEXT}\u202egnirts\u2066\u200f\u2028"
STYLE: Final = re.compile(r"\x1b\[[\d;]*m|\x1b\[\?25[lh]")


@pytest.fixture(params=["pipe", "terminal"])
def terminal(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> Iterator[bool]:
    if request.param == "terminal":
        monkeypatch.setenv("FORCE_COLOR", "1")
        monkeypatch.setenv("TERM", "xterm-256color")
    console._console.cache_clear()
    yield bool(request.param == "terminal")
    console._console.cache_clear()


def assert_harmless(output: str, *, forged: bool = False) -> None:
    """Only colours, and no line that begins as the peer would have it."""
    lines = STYLE.sub("", output).split("\n")
    assert all(line.isprintable() for line in lines), lines
    assert "\\x1b" in output or "\\u001b" in output, "the text is shown"
    assert forged or not any(line.strip(" │└─├").startswith(FORGED) for line in lines)


@pytest.mark.usefixtures("terminal")
def test_what_clients_print_of_components() -> None:
    with LocalNode() as node, evil_component(node):
        for verb in (["ls", "--timeout", "0.5"], ["query", "7.1.1", "QueryIdentification", "query_type=4"]):
            done = CliRunner().invoke(app, [*verb, "--connect", node.local])
            assert done.exit_code == 0, done.output
            assert_harmless(done.output)


@contextmanager
def evil_component(node: LocalNode) -> Iterator[None]:
    """A component with this name, in the node manager's thread."""
    component = node.component("7.1.1", [], name=TEXT)
    node._portal.run(component.open())
    try:
        yield
    finally:
        node._portal.leave(component.close())


@pytest.mark.parametrize("options", [[], ["--explain"], ["--json"]])
def test_decoded_messages(terminal: bool, options: list[str]) -> None:
    message = ReportIdentification(ReportIdentification.QueryType.COMPONENT, 60001, TEXT)
    done = CliRunner().invoke(app, ["decode", *options, message.encode().hex()])
    assert done.exit_code == 0
    assert_harmless(done.output)
    if "--json" in options:
        assert json.loads(done.output)["messages"][0]["fields"]["identification"] == TEXT


@pytest.mark.usefixtures("terminal")
def test_everything_that_verbs_print(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    """Tables, lines, objects, errors, notes and counters."""
    for fitted in (False, True):
        monkeypatch.setattr(console, "is_terminal", lambda fitted=fitted: fitted)
        console.print_table(["name", "count"], [[TURNED, "1"]])
        assert_harmless(capsys.readouterr().out)
    console.print_lines(TURNED, TURNED)
    console.print_json({"name": TURNED})
    console.print_counters({TURNED: 1})
    out, err = capsys.readouterr()
    assert_harmless(out)
    assert_harmless(err)
    console.error(TURNED)
    console.note(TURNED)
    assert_harmless(capsys.readouterr().err, forged=True)  # errors have several lines
    assert printable(TURNED).isprintable()


def test_the_live_table() -> None:
    node = up_table.NodeStatus((TURNED,), 1, 1, 1.0, {TURNED: 1})
    page = console._console.__wrapped__(stderr=False)
    page.file = io.StringIO()
    page.print(up_table._node(node))
    assert_harmless(page.file.getvalue(), forged=True)


def test_reports(capsys: pytest.CaptureFixture[str]) -> None:
    result = Result("1", TURNED, Verdict.FAIL, reason=TURNED, why=TURNED, expected=(TURNED,))
    report = Report("p", "t", "1.1.1", 0.0, results=(result,), problem=TURNED, notes=(TURNED,))
    assert_harmless(reports.junit(report).decode(), forged=True)
    assert_harmless(reports.page(report), forged=True)

    show(report)
    assert_harmless(capsys.readouterr().out, forged=True)


def test_log_lines() -> None:
    out = io.StringIO()
    handler = logging.StreamHandler(out)
    handler.setFormatter(console.LogFormatter())
    logger = logging.Logger("jauspy")
    logger.addHandler(handler)
    logger.warning("%s said %s", "7.1.1", TURNED)
    assert_harmless(out.getvalue())
    logger.error("failed", exc_info=ValueError(TEXT))
    assert_harmless(out.getvalue(), forged=True)


def test_errors() -> None:
    assert_harmless(str(RequestError(f"refused: {TURNED}")), forged=True)
    assert_harmless(str(jauspy.ConfigError(TURNED)), forged=True)


@pytest.mark.slow
@given(st.text())
def test_any_text(text: str) -> None:
    assert printable(text).isprintable()
    assert all(line.isprintable() for line in printable_lines(text).split("\n"))
    if text.isprintable():
        assert printable(text) == text
