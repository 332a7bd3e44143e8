"""The linter: finds all mistakes that break other tools in one run, also in files that the loader rejects."""

from jauspy.schema.lint.context import LintContext, LintFinding, LintRule, Problem, Severity
from jauspy.schema.lint.linter import REFUSED, RULES, UNREADABLE, lint

__all__ = ["REFUSED", "RULES", "UNREADABLE", "LintContext", "LintFinding", "LintRule", "Problem", "Severity", "lint"]
