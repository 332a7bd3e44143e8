"""The linter: finds what breaks other tools, also in files that the loader refuses, and all of it in one run."""

from jauspy.schema.lint.context import LintContext, LintFinding, LintRule, Problem, Severity
from jauspy.schema.lint.linter import REFUSED, RULES, UNREADABLE, lint

__all__ = ["REFUSED", "RULES", "UNREADABLE", "LintContext", "LintFinding", "LintRule", "Problem", "Severity", "lint"]
