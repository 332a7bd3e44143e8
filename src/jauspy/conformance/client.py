"""A client of the target: it sends, and expects what comes back."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Collection, Iterable
from typing import TYPE_CHECKING, Final, TypeVar

from jauspy.codec.base import Message
from jauspy.conformance.checks import Check
from jauspy.conformance.expectation import Expectation
from jauspy.conformance.trace import Heard, named
from jauspy.ids import EVERYONE, JausID
from jauspy.messages.core import CommandEvent, ConfirmEventRequest, Event
from jauspy.messages.environment_sensing.v2_0.range_sensor import ConfirmSensorConfiguration
from jauspy.protocol.endpoint import Endpoint
from jauspy.protocol.header import Ack

if TYPE_CHECKING:
    from jauspy.conformance.tester import Tester

M = TypeVar("M", bound=Message)

EVENTS: Final = frozenset({Event.CODE, CommandEvent.CODE})
"""These come whenever they like."""
MAX_PENDING: Final = 1024
"""Messages of one client that nobody has looked at; the oldest go first."""
CONFIRMATIONS: Final = frozenset({ConfirmEventRequest.CODE, ConfirmSensorConfiguration.CODE})
MAX_CONFIRMED: Final = 64
"""Confirmations of one client in one step."""


class Client:
    """One client of the target: a JAUS id that sends and expects."""

    def __init__(self, tester: Tester, id: JausID) -> None:
        self.tester = tester
        self.id = id
        self.pending: deque[Heard] = deque(maxlen=MAX_PENDING)
        self.confirmed: deque[Heard] = deque(maxlen=MAX_CONFIRMED)
        """Every confirmation in this step, also those that were looked at."""
        self.strange_port = False
        """Speak from another UDP port from now on."""
        self.sent: set[int] = set()
        """The ids of all messages that it has sent."""
        self._endpoint = Endpoint(id, first_sequence=int(id) % 251)

    def begin(self) -> None:
        """A new step."""
        self.pending.clear()
        self.confirmed.clear()

    def send(self, message: Message | bytes, *, to: JausID | None = None, ack: Ack = Ack.NONE) -> None:
        """Send a message, to the target unless told otherwise."""
        payload = message if isinstance(message, bytes) else message.encode()
        self.sent.add(int.from_bytes(payload[:2], "little"))
        if isinstance(message, Message):
            self.tester.why.append(f"{message.SERVICE} {message.VERSION}: {named(type(message))}")
        self._endpoint.send(to or self.tester.target, payload, now=self.tester.now, ack=ack)
        self._flush()

    def broadcast(self, message: Message) -> None:
        """Send a message to all components of all subsystems."""
        self.send(message, to=EVERYONE)

    def raw(self, datagram: bytes) -> None:
        """Send a datagram as it is."""
        self.tester.transmit(datagram, self.id, strange_port=self.strange_port)

    def ask(
        self,
        message: Message | bytes,
        answer: type[M],
        *checks: Check | Iterable[Check],
        to: JausID | None = None,
        within: float = 1.0,
    ) -> M:
        """Send, and expect this answer; earlier ones of the same kind do not count."""
        self.forget(answer)
        self.send(message, to=to)
        asked = None if to is None or to.is_wildcard else to
        return self.expect(answer, *checks, within=within, source=asked)

    def expect(
        self,
        answer: type[M],
        *checks: Check | Iterable[Check],
        where: Callable[[M], bool] = lambda _: True,
        within: float = 1.0,
        source: JausID | None = None,
    ) -> M:
        """A message of this kind that passes all checks, within so many timeouts; ends the step if there is none.

        Messages for which `where` is false are others, and stay. `source` is the target, or one component of it.
        """
        flat = [one for each in checks for one in ((each,) if isinstance(each, Check) else each)]
        return Expectation(self, answer, flat, where, source).wait(within * self.tester.timeout)

    def collect(
        self, kind: type[M], seconds: float, where: Callable[[M], bool] = lambda _: True
    ) -> list[tuple[float, M]]:
        """All messages of this kind within a time, with when they came."""
        expectation = Expectation(self, kind, [], where)
        return [(heard.at, message) for heard, message in self._collected(expectation, seconds)]

    def answers(
        self, message: Message, answer: type[M], seconds: float, *, of: JausID | None = None
    ) -> list[tuple[JausID, M]]:
        """Send, and take all answers within a time, with who has sent them; `of` others than the target if need be."""
        self.forget(answer)
        self.send(message, to=of)
        expectation = Expectation(self, answer, [], lambda _: True, of)
        return [(heard.source, found) for heard, found in self._collected(expectation, seconds)]

    def _collected(self, expectation: Expectation[M], seconds: float) -> list[tuple[Heard, M]]:
        self.tester.wait(seconds)
        read = [(heard, expectation.readable(heard)) for heard in list(self.pending)]
        taken = [(heard, message) for heard, message in read if message is not None]
        for heard, _ in taken:
            self.pending.remove(heard)
        return taken

    def silence(self, within: float = 0.1, *, besides: tuple[type[Message], ...] = ()) -> None:
        """Nothing comes to this client from the target for this part of the timeout, besides these and events."""
        allowed = {kind.CODE for kind in besides}
        end = self.tester.now + within * self.tester.timeout
        self.tester.pump(end, lambda: bool(self.unasked(allowed)))
        came = ", ".join(self.unasked(allowed))
        self.tester.expected.append("no answer")
        self.tester.check("there is no answer", f"{came} came, where nothing should" if came else "")

    def unasked(self, besides: Collection[int] = ()) -> list[str]:
        """The names of what waits to be looked at; events, queries of the target and these ids left aside."""
        waiting = [each for each in self.pending if self.tester.target.matches(each.source)]
        return [self.name_of(each) for each in waiting if is_answer(each.code) and each.code not in besides]

    def name_of(self, heard: Heard) -> str:
        """`ReportStatus 4002h`."""
        kinds = self.tester.registry.by_code(heard.code)
        return named(kinds[0]) if kinds else f"{heard.code:04X}h"

    def forget(self, kind: type[Message]) -> None:
        """Do not look at messages of this kind that have come already."""
        self.pending = deque((each for each in self.pending if each.code != kind.CODE), maxlen=MAX_PENDING)

    def take(self, datagram: bytes) -> None:
        """A datagram for this client; acknowledges what wants to be."""
        self._endpoint.receive(datagram, self.tester.now)
        while (packet := self._endpoint.next_event()) is not None:
            self._keep(Heard(self.tester.now, self.id, packet.source, packet.payload))
        self._flush()

    def _keep(self, heard: Heard) -> None:
        self.tester.unread += len(self.pending) == MAX_PENDING
        self.pending.append(heard)
        if heard.code in CONFIRMATIONS:
            self.confirmed.append(heard)

    def _flush(self) -> None:
        for datagram in self._endpoint.poll_output():
            self.raw(datagram)


def is_answer(code: int) -> bool:
    """True for what comes because something was sent: no event, and no query (2000h to 3FFFh)."""
    return code not in EVENTS and not 0x2000 <= code < 0x4000
