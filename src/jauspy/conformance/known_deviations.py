"""Failures that are known of the target's implementation: JTS, FKIE, OpenJAUS."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from jauspy.conformance.results import Report, Result, Verdict
from jauspy.conformance.trace import Direction
from jauspy.inspection.peers import KINDS, PeerKind, signs

TRANSPORT: Final = "transport"
"""The profile whose steps the deviations name."""
_UNKNOWN_ADDRESS: Final = ("", 0)


def recognised(report: Report) -> PeerKind | None:
    """The implementation of the target, by what it sent in the run; None if no sign of one was seen."""
    for entry in report.entries:
        if entry.direction is Direction.RECEIVED:
            for name, _ in signs(entry.data, _UNKNOWN_ADDRESS, _UNKNOWN_ADDRESS):
                return KINDS[name]
    return None


def with_known_deviations(report: Report, kind: PeerKind | None) -> Report:
    """The report, with what is known of the implementation beside the steps that failed.

    `kind` is what the user named; None for what is recognised.
    """
    kind = kind or recognised(report)
    if kind is None:
        return report
    note = f"the target looks like {kind.title}; failures that are known of {kind.name.upper()} are marked"
    results = tuple(marked(result, report.profile, kind) for result in report.results)
    return replace(report, results=results, notes=(*report.notes, note))


def marked(result: Result, profile: str, kind: PeerKind) -> Result:
    """The result of a step of a profile, with what is known of the implementation if the step failed because of it."""
    deviation = kind.known_of(result.id) if profile == TRANSPORT else None
    if deviation is None or result.verdict in (Verdict.PASS, Verdict.SKIPPED):
        return result
    known = f"known of {kind.name.upper()}: {deviation.what} (docs/peers.md, {deviation.reference})"
    return replace(result, known=known)
