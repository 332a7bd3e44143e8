"""The linter: finds what breaks other tools, also in files that the loader refuses, and all of it in one run."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

from jauspy.schema.lint.finding import LintFinding, LintRule, Problem, Severity
from jauspy.schema.lint.rules import LAST, REFUSED, RULES, UNREADABLE
from jauspy.schema.lint.world import LintContext

__all__ = ["REFUSED", "RULES", "UNREADABLE", "Finding", "Problem", "Rule", "Severity", "World", "lint"]


def lint(paths: Iterable[Path], rules: Sequence[LintRule] = RULES) -> list[LintFinding]:
    """All findings in these files, by place; what they refer to may also be built in.

    A file that cannot be read at all is one finding with the code `unreadable`.
    """
    world = LintContext(paths)
    found = {
        LintFinding(error.file or "", error.line or 0, UNREADABLE, "error", error.reason) for error in world.unreadable
    }
    for rule in rules:
        found.update(_findings(rule, world))
    found.update(_elsewhere(_findings(REFUSED, world), found))
    if not any(finding.severity == "error" for finding in found):
        found.update(_findings(LAST, world))
    own = {str(path) for path in world.paths}
    return sorted(finding for finding in found if finding.file in own)


def _elsewhere(more: Iterable[LintFinding], found: Iterable[LintFinding]) -> list[LintFinding]:
    """Those in lines where no mistake is known yet."""
    known = {(finding.file, finding.line) for finding in found if finding.severity == "error"}
    return [finding for finding in more if (finding.file, finding.line) not in known]


def _findings(rule: LintRule, world: LintContext) -> Iterable[LintFinding]:
    for where, message in rule.check(world):
        yield LintFinding(where.file, where.line, rule.code, rule.severity, message)
