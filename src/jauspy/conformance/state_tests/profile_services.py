"""Services of IOP v3 and AEODRS whose inputs need particular values: a state to command, a thing that there is."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from jauspy.codec.message import Message
from jauspy.conformance.results import Silent
from jauspy.conformance.state_tests.explorer import Explorer, Stimulus
from jauspy.conformance.tester import OBSERVER
from jauspy.messages.exp import (
    QueryAimpointParameters,
    QueryDigitalVideoIlluminatorConfiguration,
    ReportAimpointParameters,
    ReportDigitalVideoIlluminatorConfiguration,
)
from jauspy.messages.iop import SetPlatformState

FIRST_NUMBERS: Final = (1, 0)
"""Numbers that the first camera or lamp may have: the definitions do not say where they begin."""


def _of_first(ask: Callable[[int], Message], report: type[Message]) -> Stimulus:
    """A query about one thing, sent for the first one that the component has."""
    name = ask(0).NAME

    def make(explorer: Explorer) -> Message:
        known: dict[str, int] = explorer.tester.memory.setdefault("first numbers", {})
        if name not in known:
            known[name] = next((number for number in FIRST_NUMBERS if _answers(explorer, ask(number), report)), 1)
        return ask(known[name])

    return Stimulus(name, make)


def _answers(explorer: Explorer, query: Message, report: type[Message]) -> bool:
    try:
        explorer.client(OBSERVER).ask(query, report, to=explorer.component)
    except Silent:
        return False
    return True


PROFILE_SERVICES: Final = (
    Stimulus(
        "SetPlatformState",
        lambda _: SetPlatformState(SetPlatformState.PlatformState.OPERATIONAL),
        "operational",
        {
            "setToOperational": True,
            "setToInitialize": False,
            "setToEmergency": False,
            "setToShutdown": False,
            "setToRenderUseless": False,
        },
        only_in="Available",  # in an emergency it ends that, by an action whose effect the definition does not tell
        may_send=("ConfirmPlatformStateRequest",),  # no action of the definition sends it (ADR 187)
    ),
    _of_first(QueryAimpointParameters, ReportAimpointParameters),
    _of_first(QueryDigitalVideoIlluminatorConfiguration, ReportDigitalVideoIlluminatorConfiguration),
)
"""Their stimuli."""
