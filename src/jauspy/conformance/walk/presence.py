"""Queries with presence vectors: what a report carries is what was asked for, as far as the component has it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Final

from jauspy.codec.base import Message, Struct
from jauspy.codec.layout import Composite, Slot
from jauspy.conformance.checks import Check
from jauspy.conformance.walk.explorer import OBSERVER, Aftermath, Stimulus
from jauspy.conformance.walk.neutral import PRESENCE, neutral, presence_fields

EVERYTHING: Final = -1

Bit = tuple[str, int]
"""A vector of a query, and the number of a bit in it."""


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
        for asked in _halves(max((place for (_, place), _, _ in _fields(full, vectors)), default=0) + 1):
            query = neutral(self._kind, asks_for=asked)
            right = _carries(vectors, asked, has)
            observer.ask(query, self._report, right, to=walker.component)


def _halves(count: int) -> Iterator[int]:
    """Presence vectors with the bits whose number has a one in the first place, in the second place, and so on."""
    for place in range((count - 1).bit_length()):
        yield sum(1 << bit for bit in range(count) if bit >> place & 1)


def _carries(vectors: Iterable[str], asked: int, has: frozenset[Bit]) -> Check:
    """Of the optional fields that were asked for those that the component has, and no others."""

    def problem(report: Message) -> str:
        wrong = [name for bit, name, value in _fields(report, vectors) if (value is not None) != _right(bit)]
        wrong += [] if asked else _inside(report, vectors)
        return f"asked for {asked:X}h it is wrong about {', '.join(dict.fromkeys(wrong))}" if wrong else ""

    def _right(bit: Bit) -> bool:
        return bit in has and bool(asked >> bit[1] & 1)

    return Check("carries what was asked for and nothing else", problem)


def _fields(report: Message, vectors: Iterable[str]) -> Iterator[tuple[Bit, str, object]]:
    """Bit, name and value of each optional field in the parts of a report that the vectors of its query are about."""
    for vector in vectors:
        name = vector.removesuffix(PRESENCE).rstrip("_")
        part = report if not name and _optional(report) else _part(report, name)
        if part is not None:
            yield from (((vector, place), each, getattr(part, each)) for place, each in enumerate(_optional(part)))


def _inside(report: Message, vectors: Iterable[str]) -> list[str]:
    """All optional fields in parts of several records. Not each has a bit, but without any bit none is asked for."""
    names = [each for vector in vectors if (each := vector.removesuffix(PRESENCE).rstrip("_"))]
    parts = (getattr(report, slot.name) for slot in _slots(report) if any(name in slot.name for name in names))
    several = (part for part in parts if isinstance(part, Struct) and not _optional(part))
    records = (getattr(part, slot.name) for part in several for slot in _slots(part))
    structs = (each for each in records if isinstance(each, Struct))
    return [each for record in structs for each in _optional(record) if getattr(record, each) is not None]


def _part(whole: Struct, name: str) -> Struct | None:
    """The first record in `whole` that has optional fields and lies in what is called `name`."""
    members = (getattr(whole, slot.name) for slot in _slots(whole) if name in slot.name)
    records = (each for each in members if isinstance(each, Struct))
    found = (each if _optional(each) else _part(each, name) for each in records)
    return next((each for each in found if each is not None), None)


def _optional(record: Struct) -> list[str]:
    """The optional fields in the order of their bits."""
    return [slot.name for slot in _slots(record) if slot.optional]


def _slots(record: Struct) -> tuple[Slot, ...]:
    layout = record.layout()
    return layout.slots if isinstance(layout, Composite) else ()
