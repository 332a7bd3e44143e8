"""The messages that the console has sent and received, the latest of each kind."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from datetime import datetime
from itertools import islice
from typing import Final

from jauspy.codec.message import Message
from jauspy.codec.registry import Registry
from jauspy.errors import CodecError
from jauspy.ids import JausID, message_id
from jauspy.messages.core import ConfirmControl, Event, RejectEventRequest
from jauspy.messages.operators import RejectCommand

MAX_OF_KIND: Final = 200
"""Messages of one id that are kept, so that frequent ones do not displace rare ones."""
MAX_KINDS: Final = 256
"""Message ids that are counted apart; all others count as one."""
MAX_PAYLOAD: Final = 4096
"""Bytes of a message that are kept; longer ones are listed without their fields."""
ROUTINE: Final = frozenset(
    f"{verb}{what}"
    for verb in ("Query", "Report")
    for what in ("Status", "Control", "LocalPose", "Identification", "Configuration", "Services", "HeartbeatPulse")
)
"""Periodic queries of the console."""
OTHER: Final = -1
EVENT: Final = -2
_ACCEPTED: Final = 0
_REPORT_AT: Final = 8
"""Offset of the report in an Event: after its id, the event's id, the sequence number and a length of 4 bytes."""


@dataclass(frozen=True, slots=True)
class Line:
    """A message, a refusal, or an event of the console."""

    number: int
    time: datetime
    kind: str
    """`sent`, `received`, `refused` or `event`."""
    source: str
    destination: str
    name: str
    """The message's name; the sentence of an event."""
    size: int = 0
    user: str = ""
    """Who has caused it, by the session; empty for what was received."""
    payload: bytes = b""
    """Empty for an event, and for messages above `MAX_PAYLOAD`."""

    @property
    def text(self) -> str:
        """The text that the filter searches."""
        return f"{self.time:%H:%M:%S} {self.kind} {self.source} {self.destination} {self.user} {self.name}"


class Traffic:
    """Keeps the latest messages. `note` has the signature of `OCU.trace`."""

    def __init__(self, registry: Registry, now: Callable[[], datetime] = lambda: datetime.now().astimezone()) -> None:
        self.total = 0
        """The number of lines so far, including dropped ones."""
        self._registry = registry
        self._now = now
        self._kept: dict[int, deque[Line]] = {}
        self._names: dict[int, str] = {}

    def note(self, source: JausID, destination: JausID, payload: bytes, *, sent: bool, user: str = "") -> None:
        """Keep a message."""
        code = message_id(payload) if len(payload) > 1 else OTHER
        kind = "sent" if sent else "refused" if self._is_refusal(code, payload) else "received"
        kept = payload if len(payload) <= MAX_PAYLOAD else b""
        name = self._name(code)
        if code == Event.CODE and len(payload) > _REPORT_AT + 1:
            name = f"{name} {self._name(message_id(payload, _REPORT_AT))}"
        size = len(payload)
        line = Line(
            self.total, self._now(), kind, str(source), str(destination), name=name, size=size, user=user, payload=kept
        )
        self._keep(code, line)

    def name(self, payload: bytes) -> str:
        """The name of a message; its id in hex if it is not known."""
        return self._name(message_id(payload) if len(payload) > 1 else OTHER)

    def event(self, text: str, user: str = "") -> None:
        """Keep a sentence of the console, or about what one of its users has done."""
        self._keep(EVENT, Line(self.total, self._now(), "event", "", "", name=text, user=user))

    def lines(
        self, words: str, kind: str = "", *, routine: bool = True, limit: int = 200, total: int | None = None
    ) -> list[Line]:
        """The newest lines that have all words, and none of those after a minus sign; the newest first.

        With `total`, only lines of the first `total` ones that are still kept.
        """
        wanted = [word for word in words.casefold().split() if not word.startswith("-")]
        unwanted = [word[1:] for word in words.casefold().split() if word.startswith("-") and len(word) > 1]

        def fits(line: Line) -> bool:
            if total is not None and line.number >= total:
                return False
            if (kind and line.kind not in kind.split()) or (not routine and line.name in ROUTINE):
                return False
            text = line.text.casefold()
            return all(word in text for word in wanted) and not any(word in text for word in unwanted)

        kept: Iterable[Line] = (line for lines in self._kept.values() for line in lines)
        newest = sorted(kept, key=lambda line: line.number, reverse=True)
        return list(islice(filter(fits, newest), limit))

    def find(self, number: int) -> Line | None:
        """The line of this number, if it is still kept."""
        return next((line for lines in self._kept.values() for line in lines if line.number == number), None)

    def decoded(self, line: Line) -> Message | str:
        """The message of a line, or why there is none."""
        if not line.payload:
            return f"{line.size} bytes, more than the {MAX_PAYLOAD} that are kept" if line.size else line.name
        problem = "its message id is not known here"
        for kind in self._registry.by_code(message_id(line.payload)):
            try:
                return self._registry.decode_as(kind, line.payload)
            except CodecError as error:
                problem = str(error)
        return problem

    def _keep(self, code: int, line: Line) -> None:
        self.total += 1
        key = code if code in self._kept or len(self._kept) < MAX_KINDS else OTHER
        self._kept.setdefault(key, deque(maxlen=MAX_OF_KIND)).append(line)

    def _name(self, code: int) -> str:
        if code not in self._names:
            if len(self._names) >= 1 << 12:
                self._names.clear()
            known = self._registry.entries_of(code) if code != OTHER else ()
            self._names[code] = known[0].name if known else f"{code:04X}h" if code != OTHER else "too short"
        return self._names[code]

    def _is_refusal(self, code: int, payload: bytes) -> bool:
        if code in (RejectCommand.CODE, RejectEventRequest.CODE):
            return True
        return code == ConfirmControl.CODE and len(payload) > 2 and payload[2] != _ACCEPTED
