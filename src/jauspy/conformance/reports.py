"""Report formats of a run: HTML, JUnit XML, JSON and pcapng."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from datetime import UTC, datetime
from importlib.resources import files
from operator import itemgetter
from typing import TYPE_CHECKING, Any, Final
from xml.etree import ElementTree as ET

from jauspy.capture import writer
from jauspy.conformance.results import Report, Result, Verdict, transitions_summary, worst
from jauspy.conformance.trace import Direction, TraceEntry
from jauspy.errors import ConfigError
from jauspy.printable import printable_lines
from jauspy.protocol import judp

if TYPE_CHECKING:
    from jinja2 import Template


def summary(report: Report) -> str:
    """`79 pass, 1 silent; 79 of 80 points`."""
    counts = ", ".join(f"{report.counts[verdict]} {verdict}" for verdict in Verdict if report.counts[verdict])
    earned, possible = report.points
    return (counts or "nothing was tried") + (f"; {earned:g} of {possible:g} points" if possible else "")


# --- HTML -------------------------------------------------------------------------------------------------------------


def html_template() -> Template:
    """The template of HTML reports. Raises `ConfigError` if Jinja2 is not installed."""
    try:
        from jinja2 import Environment, StrictUndefined  # noqa: PLC0415 - an extra
    except ImportError as error:
        raise ConfigError("HTML reports need Jinja2: pip install 'jauspy[conformance]'") from error
    environment = Environment(
        autoescape=True,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        undefined=StrictUndefined,
        finalize=lambda value: printable_lines(value) if type(value) is str else value,
    )
    return environment.from_string(files(__package__).joinpath("report.html.j2").read_text())


def page(*reports: Report) -> str:
    """One HTML file that needs nothing else: no script, no font, no network. Raises `ConfigError` without Jinja2.

    Several reports follow each other; a table before them has the result of each target.
    """
    runs = [
        {
            "report": report,
            "mark": f"{number}/" if len(reports) > 1 else "",
            "began": datetime.fromtimestamp(report.began, UTC).strftime("%Y-%m-%d %H:%M:%S UTC"),
            "summary": summary(report),
            "counts": [(verdict, report.counts[verdict]) for verdict in Verdict if report.counts[verdict]],
            "transitions": transitions_summary(report),
            "not_taken": [transition for transition in report.transitions if not transition.step],
        }
        for number, report in enumerate(reports, start=1)
    ]
    return html_template().render(runs=runs, style=files(__package__).joinpath("report.css").read_text())


# --- JUnit ------------------------------------------------------------------------------------------------------------


def junit(*reports: Report) -> bytes:
    """JUnit XML, which CI servers show: a suite for each report, with a case for each step.

    A run that was not possible is an error.
    """
    suites = ET.Element("testsuites", name="jauspy conformance")
    for report in reports:
        _suite(suites, report)
    ET.indent(suites)
    written: bytes = ET.tostring(suites, encoding="utf-8", xml_declaration=True)
    return written


def _suite(suites: ET.Element, report: Report) -> None:
    suite = ET.SubElement(
        suites,
        "testsuite",
        name=report.profile,
        tests=str(len(report.results) + bool(report.problem)),
        failures=str(len(report.failures)),
        errors=str(int(bool(report.problem))),
        skipped=str(report.counts[Verdict.SKIPPED]),
        time=f"{report.seconds:.3f}",
        timestamp=datetime.fromtimestamp(report.began, UTC).strftime("%Y-%m-%dT%H:%M:%S"),
        hostname=report.target,
    )
    facts = [("transitions", transitions_summary(report)), *(("note", note) for note in report.notes)]
    if known := [(name, value) for name, value in facts if value]:
        properties = ET.SubElement(suite, "properties")
        for name, value in known:
            ET.SubElement(properties, "property", name=name, value=printable_lines(value))
    for result in report.results:
        _case(suite, report, result)
    if report.problem:
        case = ET.SubElement(suite, "testcase", classname=f"jauspy.{report.profile}", name="the run", time="0")
        ET.SubElement(case, "error", type="could not run", message=printable_lines(report.problem))


def _case(suite: ET.Element, report: Report, result: Result) -> None:
    name = printable_lines(f"{result.id} {result.title}")
    case = ET.SubElement(
        suite, "testcase", classname=f"jauspy.{report.profile}", name=name, time=f"{result.elapsed:.3f}"
    )
    if result.verdict is Verdict.SKIPPED:
        ET.SubElement(case, "skipped", message=printable_lines(result.reason))
    elif result.verdict is not Verdict.PASS:
        failure = ET.SubElement(case, "failure", type=str(result.verdict), message=printable_lines(result.reason))
        lines = (*explanation(result), f"from: {result.why}")
        failure.text = printable_lines("\n".join(lines))
    ET.SubElement(case, "system-out").text = printable_lines("\n".join(transcript(result)))


def explanation(result: Result) -> list[str]:
    """The expectation of a failed step, the check that does not hold, and the messages that came."""
    return [
        *(f"expected: {line}" for line in result.expected),
        *(f"failed check: {check.name}: {check.problem}" for check in result.failed_checks),
        *(f"came: {line}" for line in result.came),
        *([result.known] if result.known else []),
    ]


def transcript(result: Result) -> list[str]:
    """The datagrams that were sent and received, with times, hex and fields."""
    lines = []
    for entry in result.entries:
        lines.append(f"{entry.at:10.4f} {entry.direction} {entry.data.hex()}")
        lines += [f"{'':13}{line}" for line in entry.lines]
    return [*lines, result.rest] if result.rest else lines


# --- JSON -------------------------------------------------------------------------------------------------------------


def result_json(result: Result) -> dict[str, Any]:
    """One step; times in seconds."""
    return {
        "step": result.id,
        "title": result.title,
        "verdict": str(result.verdict),
        "reason": result.reason,
        "why": result.why,
        "expected": list(result.expected),
        "checks": [{"check": check.name, "problem": check.problem} for check in result.checks],
        "failed": [check.name for check in result.failed_checks],
        "came": list(result.came),
        "known": result.known,
        "began": round(result.began, 6),
        "elapsed": round(result.elapsed, 6),
        "points": result.points,
        "earned": result.earned,
        "taken": list(result.taken),
        "traffic": [entry_json(entry) for entry in result.entries],
        "left_out": result.omitted,
    }


def entry_json(entry: TraceEntry) -> dict[str, Any]:
    """One datagram."""
    return {
        "at": round(entry.at, 6),
        "direction": "sent" if entry.direction == ">" else "received",
        "hex": entry.data.hex(),
        "decoded": list(entry.lines),
    }


def transitions_json(report: Report) -> dict[str, Any]:
    """Count transitions of the target's state machines: all, taken and judged ones, and why others were not."""
    found = report.transitions
    return {
        "declared": len(found),
        "taken": sum(1 for transition in found if transition.step),
        "left": [
            {"transition": transition.name, "reason": transition.reason} for transition in found if not transition.step
        ],
    }


def summary_json(report: Report) -> dict[str, Any]:
    """The run without its steps."""
    earned, possible = report.points
    return {
        "profile": report.profile,
        "target": report.target,
        "began": report.began,
        "seconds": round(report.seconds, 3),
        "verdicts": {str(verdict): count for verdict, count in sorted(report.counts.items())},
        "points": earned,
        "of": possible,
        "problem": report.problem,
        "transitions": transitions_json(report),
        "notes": list(report.notes),
        "status": report.status,
    }


def totals_json(reports: Sequence[Report]) -> dict[str, Any]:
    """Several runs together: how many targets have which exit status, and the verdicts of all steps."""
    verdicts = sum((report.counts for report in reports), Counter[Verdict]())
    return {
        "targets": len(reports),
        "passed": [report.target for report in reports if report.status == 0],
        "failed": [report.target for report in reports if report.status == 1],
        "not_tested": [report.target for report in reports if report.status > 1],
        "verdicts": {str(verdict): count for verdict, count in sorted(verdicts.items())},
        "status": worst(reports),
    }


# --- pcapng -----------------------------------------------------------------------------------------------------------

TESTER: Final = ("192.0.2.42", judp.PORT)
OTHER_PORT: Final = ("192.0.2.42", 49152)
TARGET: Final = ("192.0.2.1", judp.PORT)
"""Addresses for documentation (RFC 5737): a run records bytes and times, not addresses."""


def capture(*reports: Report) -> bytes:
    """The datagrams of runs in the order of their times as a pcapng file, for Wireshark and `jauspy decode`."""
    blocks = [writer.preamble()]
    entries = [(report.began + entry.at, entry) for report in reports for entry in report.entries]
    for time, entry in sorted(entries, key=itemgetter(0)) if len(reports) > 1 else entries:
        tester = OTHER_PORT if entry.other_port else TESTER
        source, destination = (tester, TARGET) if entry.direction is Direction.SENT else (TARGET, tester)
        blocks.append(writer.packet(source, destination, entry.data, int(time * 1e9)))
    return b"".join(blocks)
