"""The conformance test: profiles of steps, run against a robot or component of any vendor."""

from jauspy.conformance.checks import Check, carries, carries_only, has, near, that
from jauspy.conformance.link import TesterLink
from jauspy.conformance.profile import Profile, Step, ask, find, known, tell
from jauspy.conformance.pytest_steps import offers_of, pytest_steps
from jauspy.conformance.results import Failed, Late, Malformed, Report, Result, Silent, Skipped, StepOutcome, Verdict
from jauspy.conformance.runner import Settings, run
from jauspy.conformance.tester import Client, Tester
from jauspy.conformance.virtual_target import TargetComponent, VirtualTarget

__all__ = [
    "Check",
    "Client",
    "Failed",
    "Late",
    "Malformed",
    "Profile",
    "Report",
    "Result",
    "Settings",
    "Silent",
    "Skipped",
    "Step",
    "StepOutcome",
    "TargetComponent",
    "Tester",
    "TesterLink",
    "Verdict",
    "VirtualTarget",
    "ask",
    "carries",
    "carries_only",
    "find",
    "has",
    "known",
    "near",
    "offers_of",
    "pytest_steps",
    "run",
    "tell",
    "that",
]
