"""Queries with presence vectors: what a report carries is what was asked for, as far as the component has it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Final

from jauspy.codec.base import Message, Struct
from jauspy.conformance.checks import Check
from jauspy.conformance.walk.neutral import neutral, presence_fields
from jauspy.conformance.walk.stimulus import Aftermath, Stimulus
from jauspy.conformance.walk.walker import OBSERVER

EVERYTHING: Final = -1


def variants(kind: type[Message], report: type[Message]) -> tuple[Stimulus, ...]:
    """The query for all, for nothing, and for parts; empty when it has no presence vector."""
    vectors = presence_fields(kind)
    if not vectors:
        return ()
    everything = neutral(kind, asks_for=EVERYTHING)
    nothing = neutral(kind)
    return (
        Stimulus(kind.NAME, lambda _: everything, "all fields"),
        Stimulus(kind.NAME, lambda _: nothing, "no fields", checks={report.NAME: (_carries(vectors, 0, frozenset()),)}),
        Stimulus(kind.NAME, lambda _: everything, "some fields", verify=_Parts(kind, report), once=True),
    )


class _Parts:
    """Asks for half of the fields after the other: any two fields are told apart by one of the questions."""

    def __init__(self, kind: type[Message], report: type[Message]) -> None:
        self._kind = kind
        self._report = report

    def __call__(self, then: Aftermath) -> None:
        if not then.outcome.outputs:
            return
        vectors, walker = presence_fields(self._kind), then.walker
        observer = walker.client(OBSERVER)
        full = observer.ask(neutral(self._kind, asks_for=EVERYTHING), self._report, to=walker.component)
        has = frozenset(bit for bit, _, value in _fields(full, vectors) if value is not None)
        for asked in _halves(max((bit for bit, _, _ in _fields(full, vectors)), default=0) + 1):
            query = neutral(self._kind, asks_for=asked)
            right = _carries(vectors, asked, has)
            observer.ask(query, self._report, right, to=walker.component)


def _halves(count: int) -> Iterator[int]:
    """Presence vectors with the bits whose number has a one in the first place, in the second place, and so on."""
    for place in range((count - 1).bit_length()):
        yield sum(1 << bit for bit in range(count) if bit >> place & 1)


def _carries(vectors: Iterable[str], asked: int, has: frozenset[int]) -> Check:
    """Of the optional fields that were asked for those that the component has, and no others."""

    def problem(report: Message) -> str:
        wrong = [name for bit, name, value in _fields(report, vectors) if (value is not None) != _right(bit)]
        return f"asked for {asked:X}h it is wrong about {', '.join(wrong)}" if wrong else ""

    def _right(bit: int) -> bool:
        return bit in has and bool(asked >> bit & 1)

    return Check("carries what was asked for and nothing else", problem)


def _fields(report: Message, vectors: Iterable[str]) -> Iterator[tuple[int, str, object]]:
    """Bit, name and value of each optional field in the parts of a report that the vectors of its query are about."""
    for vector in vectors:
        name = vector.removesuffix("presence_vector").rstrip("_")
        part = getattr(report, name, None) if name else report
        if isinstance(part, Struct):
            optional = [slot for slot in getattr(part.layout(), "slots", ()) if slot.optional]
            yield from ((bit, slot.name, getattr(part, slot.name)) for bit, slot in enumerate(optional))
