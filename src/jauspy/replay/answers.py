"""Which message answers which request: in a recording, and while it is replayed."""

from __future__ import annotations

import re
from collections import deque
from dataclasses import dataclass, field
from typing import Final

from jauspy.codec.message import Message
from jauspy.codec.registry import Registry
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.ocu.replies import report_of

MAX_OPEN: Final = 1000
"""Requests of a client that wait for an answer; the oldest is forgotten first."""
_FIRST_WORD: Final = re.compile(r"[A-Z][a-z0-9]*")


@dataclass(slots=True)
class _OpenRequest:
    number: int
    destination: JausID
    message: Message
    report: int | None
    """Message id of the report that answers a query."""
    time: float
    answered: set[JausID] = field(default_factory=set)


class AnswerMatcher:
    """Finds the request of one client that an answer belongs to.

    A query is answered by its report; a command by the message that confirms or rejects it, with the same `request_id`
    if both have one; either by RejectCommand. Equal requests are answered in their order. A request waits `patience`
    seconds; one to a wildcard id has an answer of each component.
    """

    def __init__(self, registry: Registry, patience: float) -> None:
        self._registry, self._patience = registry, patience
        self._open: deque[_OpenRequest] = deque(maxlen=MAX_OPEN)

    def sent(self, number: int, destination: JausID, message: Message, now: float) -> None:
        """Add a request; its number is what `answered` returns."""
        self._open.append(_OpenRequest(number, destination, message, self._report(message), now))

    def answered(self, source: JausID, message: Message, now: float) -> int | None:
        """The number of the request that this message answers; None for events, reports nobody asked for and others."""
        while self._open and now - self._open[0].time > self._patience:
            self._open.popleft()
        for request in self._open:
            if source in request.answered or not request.destination.matches(source) or not _fits(request, message):
                continue
            request.answered.add(source)
            if not request.destination.is_wildcard:
                self._open.remove(request)
            return request.number
        return None

    def _report(self, message: Message) -> int | None:
        if not message.IS_QUERY:
            return None
        try:
            return report_of(self._registry, message).CODE
        except ConfigError:
            return None


def _fits(request: _OpenRequest, answer: Message) -> bool:
    command = request.message
    if answer.NAME == "RejectCommand":
        return getattr(answer, "message_code", None) == command.CODE
    if request.report is not None:
        return request.report == answer.CODE
    if not answer.NAME.startswith(("Confirm", "Reject")):
        return False
    asked, given = getattr(command, "request_id", None), getattr(answer, "request_id", None)
    if asked is not None and given is not None:
        return bool(asked == given)
    return _FIRST_WORD.sub("", command.NAME, count=1) == _FIRST_WORD.sub("", answer.NAME, count=1)
