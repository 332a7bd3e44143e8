"""Messages that a component leaves unanswered: found in the first steps, so that a run does not wait in all others."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Final, TypeVar

from jauspy.codec.message import Message
from jauspy.conformance.results import Silent, Skipped
from jauspy.conformance.tester import CLIENTS, OBSERVER, Tester
from jauspy.conformance.trace import message_name
from jauspy.ids import JausID

M = TypeVar("M", bound=Message)

MAX_SILENCES: Final = 2
"""Silences in a row after which a message is not sent any more; one may be a lost datagram."""


class Silences:
    """The queries of the tester that one component leaves unanswered, and the inputs of steps without an answer."""

    def __init__(self, tester: Tester, component: JausID) -> None:
        self._tester = tester
        self._component = component
        self._queries: Counter[type[Message]] = Counter()
        self._inputs: defaultdict[str, dict[str, list[str]]] = defaultdict(dict)
        """The reasons of silent steps by the message that was sent, and the state."""
        self._passed: set[str] = set()
        """The messages of steps that were not silent."""

    def ask(self, query: Message, report: type[M]) -> M | None:
        """The answer to the observer; None if the query was given up.

        Raises `Silent` at the first silence; from the second in a row on, steps continue without the answer.
        """
        kind = type(query)
        if self._queries[kind] >= MAX_SILENCES:
            return None
        try:
            answer = self._tester.client(CLIENTS[OBSERVER]).ask(query, report, to=self._component)
        except Silent:
            self._queries[kind] += 1
            if self._queries[kind] < MAX_SILENCES:
                raise
            self._tester.notes.append(
                f"{self._component} does not answer {message_name(kind)}: what it would report is not checked"
            )
            return None
        self._queries[kind] = 0
        return answer

    @contextmanager
    def of_input(self, message: str, state: str) -> Iterator[None]:
        """A step that sends this message in a state.

        Raises `Skipped` if the last ones there were silent, or if those in several states were and it never passed.
        """
        inputs = self._inputs[message].setdefault(state, [])
        if len(inputs) >= MAX_SILENCES:
            raise Skipped(f"{message} is not sent again in {state}: {inputs[-1]} in {len(inputs)} steps before")
        everywhere = [reason for reasons in self._inputs[message].values() for reason in reasons]
        if message not in self._passed and len(everywhere) > MAX_SILENCES:
            raise Skipped(f"{message} is not sent again: {everywhere[-1]} in {len(everywhere)} steps before")
        try:
            yield
        except Silent as silent:
            inputs.append(str(silent))
            raise
        inputs.clear()
        self._passed.add(message)


def silences_of(component: JausID, tester: Tester) -> Silences:
    """The one record of this component in this run."""
    known: dict[JausID, Silences] = tester.memory.setdefault("silences", {})
    if component not in known:
        known[component] = Silences(tester, component)
    return known[component]
