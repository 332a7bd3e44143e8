"""Reports as JUnit XML, which CI servers show."""

from __future__ import annotations

import re
from datetime import UTC, datetime
from typing import Final
from xml.etree import ElementTree as ET

from jauspy.conformance.results import Report, Result, Verdict, transitions_sum

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
