"""Messages of operators, newest versions; loaded on use. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jauspy.codec.registry import lazy

if TYPE_CHECKING:
    from jauspy.messages.operators.v1_0.command_seal import (
        QuerySealChallenge as QuerySealChallenge, RejectCommand as RejectCommand,
        ReportSealChallenge as ReportSealChallenge, SealedCommand as SealedCommand,
    )

__all__, __getattr__, __dir__ = lazy(__name__, {
    "jauspy.messages.operators.v1_0.command_seal": "QuerySealChallenge RejectCommand ReportSealChallenge SealedCommand",
})
