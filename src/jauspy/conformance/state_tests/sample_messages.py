"""Variants of queries by presence vector, and the check that a report has the requested fields."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Final

from jauspy.codec.layout import Composite, Slot
from jauspy.codec.message import Message, Struct
from jauspy.conformance.checks import Check
from jauspy.conformance.state_tests.explorer import Stimulus, StimulusResult
from jauspy.conformance.state_tests.neutral_messages import PRESENCE, neutral, presence_fields
from jauspy.conformance.tester import OBSERVER

EVERYTHING: Final = -1

Bit = tuple[str, int]
"""A presence vector of a query, and the number of a bit in it."""


def variants(kind: type[Message], report: type[Message]) -> tuple[Stimulus, ...]:
    """The query with all, no and some presence bits; empty if it has no presence vector."""
    vectors = presence_fields(kind)
    if not vectors:
        return ()
    everything = neutral(kind, presence_bits=EVERYTHING)
    nothing = neutral(kind)
    return (
        Stimulus(kind.NAME, lambda _: everything, "all fields"),
        Stimulus(kind.NAME, lambda _: nothing, "no fields", checks={report.NAME: (_carries(vectors, 0, frozenset()),)}),
        Stimulus(kind.NAME, lambda _: everything, "some fields", verify=_Parts(kind, report), once=True),
    )


class _Parts:
    """Queries half of the fields at a time, so that one of the queries distinguishes any two fields."""

    def __init__(self, kind: type[Message], report: type[Message]) -> None:
        self._kind = kind
        self._report = report

    def __call__(self, then: StimulusResult) -> None:
        if not then.outcome.outputs:
            return
        vectors, explorer = presence_fields(self._kind), then.explorer
        observer = explorer.client(OBSERVER)
        full = observer.ask(neutral(self._kind, presence_bits=EVERYTHING), self._report, to=explorer.component)
        has = frozenset(bit for bit, _, value in _fields(full, vectors) if value is not None)
        for asked in _halves(max((place for (_, place), _, _ in _fields(full, vectors)), default=0) + 1):
            query = neutral(self._kind, presence_bits=asked)
            right = _carries(vectors, asked, has)
            observer.ask(query, self._report, right, to=explorer.component)


def _halves(count: int) -> Iterator[int]:
    """Presence vectors with the bits whose number has bit 0 set, bit 1 set, and so on."""
    for place in range((count - 1).bit_length()):
        yield sum(1 << bit for bit in range(count) if bit >> place & 1)


def _carries(vectors: Iterable[str], asked: int, has: frozenset[Bit]) -> Check:
    """Check that the report has the requested optional fields that the component supports, and no others."""

    def problem(report: Message) -> str:
        wrong = [name for bit, name, value in _fields(report, vectors) if (value is not None) != _right(bit)]
        wrong += [] if asked else _inside(report, vectors)
        return f"asked for {asked:X}h it is wrong about {', '.join(dict.fromkeys(wrong))}" if wrong else ""

    def _right(bit: Bit) -> bool:
        return bit in has and bool(asked >> bit[1] & 1)

    return Check("has the requested fields and no others", problem)


def _fields(report: Message, vectors: Iterable[str]) -> Iterator[tuple[Bit, str, object]]:
    """Bit, name and value of each optional field that the presence vectors of the query select."""
    for vector in vectors:
        name = vector.removesuffix(PRESENCE).rstrip("_")
        part = report if not name and _optional(report) else _part(report, name)
        if part is not None:
            yield from (((vector, place), name, getattr(part, name)) for place, name in enumerate(_optional(part)))


def _inside(report: Message, vectors: Iterable[str]) -> list[str]:
    """All optional fields in parts of several records. Not each has a bit; without any bit, none is requested."""
    names = [name for vector in vectors if (name := vector.removesuffix(PRESENCE).rstrip("_"))]
    parts = (getattr(report, slot.name) for slot in _slots(report) if any(name in slot.name for name in names))
    several = (part for part in parts if isinstance(part, Struct) and not _optional(part))
    records = (getattr(part, slot.name) for part in several for slot in _slots(part))
    structs = (record for record in records if isinstance(record, Struct))
    return [name for record in structs for name in _optional(record) if getattr(record, name) is not None]


def _part(whole: Struct, name: str) -> Struct | None:
    """The first record with optional fields inside the part of `whole` with this name."""
    members = (getattr(whole, slot.name) for slot in _slots(whole) if name in slot.name)
    records = (member for member in members if isinstance(member, Struct))
    found = (record if _optional(record) else _part(record, name) for record in records)
    return next((value for value in found if value is not None), None)


def _optional(record: Struct) -> list[str]:
    """The optional fields in the order of their bits."""
    return [slot.name for slot in _slots(record) if slot.optional]


def _slots(record: Struct) -> tuple[Slot, ...]:
    layout = record.layout()
    return layout.slots if isinstance(layout, Composite) else ()
