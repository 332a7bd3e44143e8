"""The order of a list's elements: doubly linked in messages, changed as a whole or not at all (AS5710)."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from typing import Final, TypeAlias

from jauspy.messages.core import ElementRec, RejectElementRequest

ElementRejectCode: TypeAlias = RejectElementRequest.ResponseCode

RESERVED: Final = frozenset({0, 65535})
"""Numbers that no element has: 0 stands for none, 65535 for all."""


@dataclass(frozen=True, slots=True)
class ElementList:
    """Numbers of the elements, first to last; a list whose last element names the first as its next is a `loop`."""

    order: tuple[int, ...] = ()
    loop: bool = False

    def previous(self, uid: int) -> int:
        """The element before this one, 0 for none."""
        at = self.order.index(uid)
        return self.order[at - 1] if at or self.loop else 0

    def next(self, uid: int) -> int:
        """The element after this one, 0 for none."""
        at = self.order.index(uid) + 1
        if at < len(self.order):
            return self.order[at]
        return self.order[0] if self.loop else 0

    def without(self, uids: Collection[int]) -> ElementList:
        """The list without these elements; their neighbours are linked with each other."""
        order = tuple(uid for uid in self.order if uid not in uids)
        return ElementList(order, self.loop and bool(order))

    def linked(self, records: Sequence[ElementRec]) -> ElementList | ElementRejectCode:
        """The list with these elements inserted or replaced where their links say; a reject code if they do not fit."""
        if not records:
            return ElementRejectCode.UNSPECIFIED_ERROR
        uids = {record.element_uid for record in records}
        if len(uids) < len(records) or uids & RESERVED:
            return ElementRejectCode.INVALID_ELEMENT_ID
        order = _placed([uid for uid in self.order if uid not in uids], records)
        if order is None:
            return ElementRejectCode.INVALID_PREVIOUS_ELEMENT
        closing = {record.element_uid: record.next_uid == order[0] for record in records}
        loop = closing.get(order[-1], self.loop and order[-1] == self.order[-1])
        if loop and self.order and self.order[0] in order:
            start = order.index(self.order[0])
            order = order[start:] + order[:start]  # a ring has no first element of its own: it keeps the one it had
        changed = ElementList(tuple(order), loop)
        return _wrong_link(changed, records) or changed


def _placed(there: list[int], records: Sequence[ElementRec]) -> list[int] | None:
    """Each record behind its previous element; None when that is unknown or taken by another record."""
    waiting = {record.previous_uid: record.element_uid for record in records}
    if len(waiting) < len(records):
        return None
    if not there and 0 not in waiting:
        waiting[0] = waiting.pop(records[0].previous_uid)  # a ring: it starts with the first one that was sent
    order: list[int] = []
    for anchor in (0, *there):
        order += [anchor] if anchor else []
        behind = waiting.pop(anchor, 0)
        while behind:
            order.append(behind)
            behind = waiting.pop(behind, 0)
    return None if waiting else order


def _wrong_link(changed: ElementList, records: Sequence[ElementRec]) -> ElementRejectCode | None:
    for record in records:
        first = record.element_uid == changed.order[0]
        if record.previous_uid != changed.previous(record.element_uid) and not (first and record.previous_uid == 0):
            return ElementRejectCode.INVALID_PREVIOUS_ELEMENT
        if record.next_uid != changed.next(record.element_uid):
            return ElementRejectCode.INVALID_NEXT_ELEMENT
    return None
