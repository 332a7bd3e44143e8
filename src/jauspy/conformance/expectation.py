"""Waiting for one message: in time, readable, and right."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Generic, TypeVar

from jauspy.codec.base import Message
from jauspy.conformance.checks import Check
from jauspy.conformance.results import Failed, Late, Looked, Malformed, Outcome, Silent
from jauspy.conformance.trace import Heard, named
from jauspy.errors import DecodeError
from jauspy.ids import JausID
from jauspy.messages.core import ConfirmControl, RejectControl

if TYPE_CHECKING:
    from jauspy.conformance.client import Client

M = TypeVar("M", bound=Message)


class Expectation(Generic[M]):
    """One message of a kind that passes all checks.

    With a wildcard as source one component that answers right is enough; else the first answer decides. `source` is
    the target, unless one component of it was asked.
    """

    def __init__(
        self,
        client: Client,
        kind: type[M],
        checks: Sequence[Check],
        where: Callable[[M], bool],
        source: JausID | None = None,
    ) -> None:
        self._client = client
        self._tester = client.tester
        self._kind = kind
        self._checks = checks
        self._where = where
        self._source = source or client.tester.target
        self._seconds = 0.0
        self._outcome: Outcome | None = None
        self._looked: list[Looked] = []
        self._found: tuple[Heard, M] | None = None

    def wait(self, seconds: float) -> M:
        """The message; raises how it ended otherwise. One that comes in twice the time is late."""
        self._seconds = seconds
        tester, deadline = self._tester, self._tester.now + seconds
        tester.expected.append(" and ".join((named(self._kind), *(each.name for each in self._checks))))
        tester.pump(deadline, self._look)
        if self._found is None and (self._outcome is None or self._source.is_wildcard):
            tester.pump(deadline + seconds, self._look)
        comes = f"{named(self._kind)} comes"
        if self._found is None and self._outcome is None:
            self._outcome = self._absence()
            tester.look(comes, str(self._outcome))
            raise self._outcome
        tester.look(comes)
        tester.looked += self._looked
        if self._found is None:
            assert self._outcome is not None
            raise self._outcome
        heard, message = self._found
        late = heard.at - deadline
        tester.look(f"{comes} in time", f"{late:.2f} s late" if late > 0 else "")
        if late > 0:
            raise Late(f"{named(self._kind)} came {late:.2f} s after the deadline of {seconds:g} s")
        return message

    def readable(self, heard: Heard) -> M | None:
        """The message, when it is one of this kind, from the target, strictly as defined."""
        if heard.code != self._kind.CODE or not self._source.matches(heard.source):
            return None
        try:
            message = self._tester.registry.decode_as(self._kind, heard.payload)
        except DecodeError:
            return None
        return message if self._where(message) else None

    def _look(self) -> bool:
        """Take the messages of this kind that wait; true when one of them settles it."""
        for heard in list(self._client.pending):
            if heard.code == self._kind.CODE and self._source.matches(heard.source):
                self._judge(heard)
                if self._found is not None:
                    return True
        return self._outcome is not None and not self._source.is_wildcard

    def _judge(self, heard: Heard) -> None:
        reads = f"{named(self._kind)} is as its definition says"
        try:
            message = self._tester.registry.decode_as(self._kind, heard.payload)
        except DecodeError as error:
            self._client.pending.remove(heard)
            problem = f"{named(self._kind)} from {heard.source} is malformed: {error}"
            self._settle(Malformed(problem), [Looked(reads, problem)])
            return
        if not self._where(message):
            return
        self._client.pending.remove(heard)
        looked = [Looked(f"{named(self._kind)} {each.name}", each.problem(message)) for each in self._checks]
        problems = [each.problem for each in looked if each.problem]
        outcome = Failed(f"{named(self._kind)} from {heard.source}: {'; '.join(problems)}") if problems else None
        self._settle(outcome, [Looked(reads), *looked])
        if outcome is None:
            self._found = heard, message

    def _settle(self, outcome: Outcome | None, looked: list[Looked]) -> None:
        """The first wrong answer is kept, a right one counts more."""
        if outcome is None or self._outcome is None:
            self._outcome, self._looked = outcome, looked

    def _absence(self) -> Outcome:
        wanted = named(self._kind)
        if astray := self._astray():
            return Silent(f"no {wanted} came from {self._source} to {self._client.id}, but {astray}")
        # Control that ends by itself is told to the client at any time.
        others = self._client.unasked(() if self._kind is ConfirmControl else (RejectControl.CODE,))
        if others:
            return Failed(f"no {wanted} came, but {', '.join(others[:4])}")
        return Silent(f"no {wanted} came in {2 * self._seconds:g} s")

    def _astray(self) -> str:
        """Where the message came from or went to instead."""
        for client in self._tester.clients:
            for heard in client.pending:
                ours = self._source.matches(heard.source)
                if heard.code == self._kind.CODE and (not ours or client is not self._client):
                    return f"one from {heard.source} to {client.id}"
        return ""
