"""Reports as one HTML file that needs nothing else: no script, no font, no network."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from datetime import UTC, datetime
from html import escape
from importlib.resources import files
from typing import Any, Final
from xml.etree import ElementTree as ET

from jauspy.capture import writer
from jauspy.conformance.results import Looked, Report, Result, Verdict, transitions_sum
from jauspy.conformance.trace import Direction, Entry
from jauspy.protocol import judp

_QUIET: Final = (Verdict.PASS, Verdict.SKIPPED)
"""Steps that nobody needs to open."""


def page(report: Report) -> str:
    """The file."""
    return "\n".join(_lines(report)) + "\n"


def _lines(report: Report) -> Iterator[str]:
    style = files(__package__).joinpath("report.css").read_text()
    yield '<!doctype html>\n<html lang="en"><head><meta charset="utf-8">'
    yield '<meta name="viewport" content="width=device-width, initial-scale=1">'
    yield f"<title>{escape(report.profile)}: {escape(report.target)}</title>"
    yield f"<style>\n{style}</style></head><body>"
    yield from _head(report)
    yield from _failures(report.failures)
    if report.results:
        yield '<input type="checkbox" id="less"><label for="less">Only what did not pass</label>'
        yield "<main>"
        for result in report.results:
            yield from _step(result)
        yield "</main>"
    yield "</body></html>"


def _head(report: Report) -> Iterator[str]:
    when = datetime.fromtimestamp(report.began, UTC).strftime("%Y-%m-%d %H:%M:%S UTC")
    yield f"<header><h1>{escape(report.title)}</h1>"
    run = f"profile {escape(report.profile)}, {when}, {report.seconds:.1f} s"
    yield f"<p>Target <strong>{escape(report.target)}</strong>, {run}</p>"
    yield f'<p class="sum s{report.status}">{escape(summary(report))}</p>'
    if report.results:
        yield f'<div class="bar" aria-hidden="true">{"".join(_bar(report))}</div>'
    if report.problem:
        yield f'<p class="problem">{escape(report.problem)}</p>'
    yield from (f"<p>{escape(note)}</p>" for note in report.notes)
    yield from _transitions(report)
    yield "</header>"


def _transitions(report: Report) -> Iterator[str]:
    if not (total := transitions_sum(report)):
        return
    left = [each for each in report.transitions if not each.step]
    items = "".join(f"<li>{escape(each.name)}: {escape(each.reason)}</li>" for each in left)
    yield (
        f"<details><summary>{escape(total)}</summary><ul>{items}</ul></details>" if left else f"<p>{escape(total)}</p>"
    )


def _bar(report: Report) -> Iterator[str]:
    for verdict in Verdict:
        if count := report.counts[verdict]:
            yield f'<span class="{verdict}" style="flex-grow:{count}" title="{count} {verdict}"></span>'


def _failures(failures: Iterable[Result]) -> Iterator[str]:
    """Where to look first."""
    items = [
        f'<li><a href="#{escape(each.id)}">{escape(each.id)}</a> {escape(each.title)}: {escape(each.reason)}</li>'
        for each in failures
    ]
    if items:
        yield f"<nav><h2>What did not pass</h2><ul>{''.join(items)}</ul></nav>"


def _step(result: Result) -> Iterator[str]:
    opened = "" if result.verdict in _QUIET else " open"
    points = f"{result.earned:g}/{result.points:g} points, " if result.points else ""
    yield (
        f'<details class="{result.verdict}" id="{escape(result.id)}"{opened}><summary>'
        f'<span class="v">{result.verdict}</span> <span class="id">{escape(result.id)}</span>'
        f' <span class="what">{escape(result.title)}</span>'
        f' <span class="t">{points}{result.elapsed * 1000:.0f} ms</span></summary><div class="in">'
    )
    if result.reason:
        yield f'<p class="reason">{escape(result.reason)}</p>'
    if result.expected:
        yield f"<p>Expected: {escape('; '.join(result.expected))}</p>"
    if result.why:
        yield f'<p class="from">From {escape(result.why)}</p>'
    if result.looked:
        yield f'<ul class="checks">{"".join(map(_check, result.looked))}</ul>'
    if result.entries:
        yield f'<div class="traffic">{"".join(map(_datagram, result.entries))}</div>'
    if result.rest:
        yield f"<p>{result.rest}</p>"
    yield "</div></details>"


def _check(looked: Looked) -> str:
    problem = f": {escape(looked.problem)}" if looked.problem else ""
    return f'<li class="{"no" if looked.problem else "yes"}">{escape(looked.name)}{problem}</li>'


def _datagram(entry: Entry) -> str:
    way = "sent" if entry.direction is Direction.SENT else "received"
    decoded = "<br>".join(map(escape, entry.lines))
    head = f"<time>{entry.at:.4f}</time> <strong>{way}</strong> <span>{decoded}</span>"
    return f'<div class="{way}">{head}<code>{entry.data.hex(" ", -4)}</code></div>\n'


def summary(report: Report) -> str:
    """`79 pass, 1 silent; 79 of 80 points`."""
    counts = ", ".join(f"{report.counts[verdict]} {verdict}" for verdict in Verdict if report.counts[verdict])
    earned, possible = report.points
    return (counts or "nothing was tried") + (f"; {earned:g} of {possible:g} points" if possible else "")


_FORBIDDEN: Final = re.compile(r"[^\t\n\r\x20-\uD7FF\uE000-\uFFFD]")
"""What XML 1.0 cannot say."""


def junit(report: Report) -> bytes:
    """The file: a suite with a case for each step; what could not run is an error."""
    suites = ET.Element("testsuites", name="jauspy conformance")
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
    said = [("transitions", transitions_sum(report)), *(("note", note) for note in report.notes)]
    if known := [(name, value) for name, value in said if value]:
        properties = ET.SubElement(suite, "properties")
        for name, value in known:
            ET.SubElement(properties, "property", name=name, value=_clean(value))
    for result in report.results:
        _case(suite, report, result)
    if report.problem:
        case = ET.SubElement(suite, "testcase", classname=f"jauspy.{report.profile}", name="the run", time="0")
        ET.SubElement(case, "error", type="could not run", message=_clean(report.problem))
    ET.indent(suites)
    written: bytes = ET.tostring(suites, encoding="utf-8", xml_declaration=True)
    return written


def _case(suite: ET.Element, report: Report, result: Result) -> None:
    name = _clean(f"{result.id} {result.title}")
    case = ET.SubElement(
        suite, "testcase", classname=f"jauspy.{report.profile}", name=name, time=f"{result.elapsed:.3f}"
    )
    if result.verdict is Verdict.SKIPPED:
        ET.SubElement(case, "skipped", message=_clean(result.reason))
    elif result.verdict is not Verdict.PASS:
        failure = ET.SubElement(case, "failure", type=str(result.verdict), message=_clean(result.reason))
        failure.text = _clean("\n".join((*(f"expected: {each}" for each in result.expected), f"from: {result.why}")))
    ET.SubElement(case, "system-out").text = _clean("\n".join(transcript(result)))


def transcript(result: Result) -> list[str]:
    """What was sent and received, with times, hex and fields."""
    lines = []
    for entry in result.entries:
        lines.append(f"{entry.at:10.4f} {entry.direction} {entry.data.hex()}")
        lines += [f"{'':13}{line}" for line in entry.lines]
    return [*lines, result.rest] if result.rest else lines


def _clean(text: str) -> str:
    return _FORBIDDEN.sub("\ufffd", text)


def result_json(result: Result) -> dict[str, Any]:
    """One step; times in seconds."""
    return {
        "step": result.id,
        "title": result.title,
        "verdict": str(result.verdict),
        "reason": result.reason,
        "why": result.why,
        "expected": list(result.expected),
        "checks": [{"check": each.name, "problem": each.problem} for each in result.looked],
        "began": round(result.began, 6),
        "elapsed": round(result.elapsed, 6),
        "points": result.points,
        "earned": result.earned,
        "taken": list(result.taken),
        "traffic": [entry_json(each) for each in result.entries],
        "left_out": result.left_out,
    }


def entry_json(entry: Entry) -> dict[str, Any]:
    """One datagram."""
    return {
        "at": round(entry.at, 6),
        "direction": "sent" if entry.direction == ">" else "received",
        "hex": entry.data.hex(),
        "decoded": list(entry.lines),
    }


def transitions_json(report: Report) -> dict[str, Any]:
    """Of the target's state machines: how many there are, how many were taken and judged, and why others were not."""
    found = report.transitions
    return {
        "declared": len(found),
        "taken": sum(1 for each in found if each.step),
        "left": [{"transition": each.name, "reason": each.reason} for each in found if not each.step],
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


TESTER: Final = ("192.0.2.42", judp.PORT)
STRANGE: Final = ("192.0.2.42", 49152)
TARGET: Final = ("192.0.2.1", judp.PORT)


def capture(report: Report) -> bytes:
    """The file."""
    blocks = [writer.preamble()]
    for entry in report.entries:
        tester = STRANGE if entry.strange_port else TESTER
        source, destination = (tester, TARGET) if entry.direction is Direction.SENT else (TARGET, tester)
        nanoseconds = int((report.began + entry.at) * 1e9)
        blocks.append(writer.packet(source, destination, entry.data, nanoseconds))
    return b"".join(blocks)
