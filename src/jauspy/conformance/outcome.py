"""How a step says that it did not pass."""

from __future__ import annotations

from jauspy.conformance.results import Verdict
from jauspy.errors import JausError


class Outcome(JausError):
    """Ends a step with a verdict; the text is the reason."""

    verdict = Verdict.FAIL


class Failed(Outcome):
    """What came is wrong."""


class Silent(Outcome):
    """Nothing came."""

    verdict = Verdict.SILENT


class Late(Outcome):
    """It came after the deadline."""

    verdict = Verdict.LATE


class Malformed(Outcome):
    """Its bytes are not those of the message."""

    verdict = Verdict.MALFORMED


class Skipped(Outcome):
    """The step cannot be tried."""

    verdict = Verdict.SKIPPED
