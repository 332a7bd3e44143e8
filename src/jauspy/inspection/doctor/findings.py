"""What a check has found: how bad it is, what was seen, and how to mend it."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import asdict, dataclass
from enum import StrEnum


class Severity(StrEnum):
    """How bad a finding is."""

    OK = "ok"
    WARN = "warn"
    """It works, but not for everybody or not for long; or it could not be found out."""
    FAIL = "fail"
    """The two parties do not talk because of this."""


@dataclass(frozen=True, slots=True)
class Finding:
    """The result of one check. Texts may contain what peers sent."""

    check: str
    """Short name of the check, the same in every run, as in `port` and `duplicate id`."""
    severity: Severity
    what: str
    evidence: str = ""
    """What was seen: addresses, counts, ids."""
    fix: str = ""
    """A sentence with what to do; empty if all is well."""

    def as_json(self) -> dict[str, str]:
        """The finding as a JSON object."""
        return {name: str(value) for name, value in asdict(self).items()}


def ok(check: str, what: str, evidence: str = "") -> Finding:
    """A check that found nothing wrong."""
    return Finding(check, Severity.OK, what, evidence)


def warn(check: str, what: str, evidence: str, fix: str) -> Finding:
    """Something that may become a fault, or that could not be found out."""
    return Finding(check, Severity.WARN, what, evidence, fix)


def fail(check: str, what: str, evidence: str, fix: str) -> Finding:
    """A fault."""
    return Finding(check, Severity.FAIL, what, evidence, fix)


def has_failed(findings: Iterable[Finding]) -> bool:
    """True if one of the findings is a fault."""
    return any(finding.severity is Severity.FAIL for finding in findings)
