"""The inputs of AccessControl, with every authority that its guards distinguish."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from jauspy.conformance.checks import has
from jauspy.conformance.results import Skipped
from jauspy.conformance.state_tests.explorer import EARLIEST, LONGEST, Aftermath, Stimulus, Walker
from jauspy.conformance.tester import OBSERVER
from jauspy.messages.core import QueryAuthority, ReportAuthority, RequestControl, SetAuthority


def below_default(walker: Walker) -> int:
    """An authority that is too low for anybody."""
    if walker.default_authority == 0:
        raise Skipped("the default authority of the component is 0: nothing is below it")
    return walker.default_authority - 1


_LEVELS: Final[tuple[tuple[str, Callable[[Walker], int], bool, bool, bool], ...]] = (
    ("authority below the default", below_default, True, False, False),
    ("less authority", lambda walker: walker.authority - 1, False, False, True),
    ("the same authority", lambda walker: walker.authority, False, False, True),
    ("more authority", lambda walker: walker.authority + 1, False, True, False),
)
"""Name, value, below the default, above the current one, valid for SetAuthority."""


def _requests() -> tuple[Stimulus, ...]:
    return tuple(
        Stimulus(
            "RequestControl",
            lambda walker, level=level: RequestControl(level(walker)),  # type: ignore[misc]  # a bound loop variable
            name,
            {"isDefaultAuthorityGreater": below, "isCurrentAuthorityLess": above},
        )
        for name, level, below, above, _ in _LEVELS
    )


def _authorities() -> tuple[Stimulus, ...]:
    return tuple(
        Stimulus(
            "SetAuthority",
            lambda walker, level=level: SetAuthority(level(walker)),  # type: ignore[misc]  # a bound loop variable
            name,
            {"isAuthorityValid": valid},
            verify=_authority_is(level),
        )
        for name, level, _, _, valid in _LEVELS
    )


def _authority_is(level: Callable[[Walker], int]) -> Callable[[Aftermath], None]:
    def verify(then: Aftermath) -> None:
        walker, controller = then.walker, then.before.controller
        if not controller or then.outcome.after.controller != controller:
            return
        wanted = level(walker) if then.outcome.acts else walker.authority
        walker.client(OBSERVER).ask(QueryAuthority(), ReportAuthority, has(authority_code=wanted), to=walker.component)

    return verify


def control_time(walker: Walker) -> float:
    """Seconds until control ends."""
    if not 0 < walker.timeout <= LONGEST:
        raise Skipped(f"control times out after {walker.timeout} s" if walker.timeout else "control never times out")
    return float(walker.timeout)


ACCESS: Final = (*_requests(), *_authorities())
SILENT_CLIENT: Final = Stimulus(
    "Timedout", None, "the client is silent", seconds=control_time, earliest=EARLIEST, by_controller=True
)
