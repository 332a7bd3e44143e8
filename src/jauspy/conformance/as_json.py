"""Reports as JSON."""

from __future__ import annotations

from typing import Any

from jauspy.conformance.results import Report, Result
from jauspy.conformance.trace import Entry


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
