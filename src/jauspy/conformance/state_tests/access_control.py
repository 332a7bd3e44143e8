"""The inputs of AccessControl, with every authority that its guards distinguish."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from jauspy.conformance.checks import has
from jauspy.conformance.results import Skipped
from jauspy.conformance.state_tests.explorer import (
    MAX_TIMER_WAIT,
    MIN_TIMER_FRACTION,
    Explorer,
    Stimulus,
    StimulusResult,
)
from jauspy.conformance.tester import OBSERVER
from jauspy.messages.core import QueryAuthority, ReportAuthority, RequestControl, SetAuthority


def below_default(explorer: Explorer) -> int:
    """An authority that is below the default authority."""
    if explorer.default_authority == 0:
        raise Skipped("the default authority of the component is 0: nothing is below it")
    return explorer.default_authority - 1


_LEVELS: Final[tuple[tuple[str, Callable[[Explorer], int], bool, bool, bool], ...]] = (
    ("authority below the default", below_default, True, False, False),
    ("less authority", lambda explorer: explorer.authority - 1, False, False, True),
    ("the same authority", lambda explorer: explorer.authority, False, False, True),
    ("more authority", lambda explorer: explorer.authority + 1, False, True, False),
)
"""Name, value, below the default, above the current one, valid for SetAuthority."""


def _requests() -> tuple[Stimulus, ...]:
    return tuple(
        Stimulus(
            "RequestControl",
            lambda explorer, level=level: RequestControl(level(explorer)),  # type: ignore[misc]  # a bound loop variable
            name,
            {"isDefaultAuthorityGreater": below, "isCurrentAuthorityLess": above},
        )
        for name, level, below, above, _ in _LEVELS
    )


def _authorities() -> tuple[Stimulus, ...]:
    return tuple(
        Stimulus(
            "SetAuthority",
            lambda explorer, level=level: SetAuthority(level(explorer)),  # type: ignore[misc]  # a bound loop variable
            name,
            {"isAuthorityValid": valid},
            verify=_authority_is(level),
        )
        for name, level, _, _, valid in _LEVELS
    )


def _authority_is(level: Callable[[Explorer], int]) -> Callable[[StimulusResult], None]:
    def verify(then: StimulusResult) -> None:
        explorer, controller = then.explorer, then.before.controller
        if not controller or then.outcome.after.controller != controller:
            return
        wanted = level(explorer) if then.outcome.acts else explorer.authority
        explorer.client(OBSERVER).ask_until_right(
            QueryAuthority(), ReportAuthority, has(authority_code=wanted), to=explorer.component
        )

    return verify


def control_time(explorer: Explorer) -> float:
    """Seconds until the control of a silent client ends."""
    if not 0 < explorer.timeout <= MAX_TIMER_WAIT:
        raise Skipped(
            f"control times out after {explorer.timeout} s" if explorer.timeout else "control never times out"
        )
    return float(explorer.timeout)


ACCESS: Final = (*_requests(), *_authorities())
SILENT_CLIENT: Final = Stimulus(
    "Timedout", None, "the client is silent", seconds=control_time, earliest=MIN_TIMER_FRACTION, by_controller=True
)
