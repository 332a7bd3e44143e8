"""ListManager: keeps a list of elements for the services that carry them out (AS5710)."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar, Final, TypeAlias

from jauspy.codec.message import Message
from jauspy.errors import ConfigError, DecodeError
from jauspy.ids import message_id
from jauspy.messages.core import (
    ConfirmElementRequest,
    DeleteElement,
    ElementRec,
    QueryElement,
    RejectElementRequest,
    ReportElement,
    ReportElementCount,
    ReportElementList,
    SetElement,
)
from jauspy.services.service import Service
from jauspy.services.state_machine import CommandCompletion

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
        index = self.order.index(uid)
        return self.order[index - 1] if index or self.loop else 0

    def next(self, uid: int) -> int:
        """The element after this one, 0 for none."""
        index = self.order.index(uid) + 1
        if index < len(self.order):
            return self.order[index]
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


def _placed(existing: list[int], records: Sequence[ElementRec]) -> list[int] | None:
    """Each record behind its previous element; None when that is unknown or taken by another record."""
    waiting = {record.previous_uid: record.element_uid for record in records}
    if len(waiting) < len(records):
        return None
    if not existing and 0 not in waiting:
        waiting[0] = waiting.pop(records[0].previous_uid)  # a ring: it starts with the first one that was sent
    order: list[int] = []
    for anchor in (0, *existing):
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


ALL_ELEMENTS: Final = 65535
"""Deleting this element empties the list."""
MAX_ELEMENTS: Final = 1024
MAX_BYTES: Final = 1 << 20
"""Bytes that all elements of a list may hold together."""
LAP_PAUSE: Final = 0.1
"""Seconds before a loop restarts, so that one whose elements are all reached does not spin."""
_TIMER: Final = "next element"


@dataclass(frozen=True, slots=True)
class Element:
    """An element of the list, and its message as the driver decoded it."""

    data: ElementRec.ElementData
    size: int
    message: Message
    driver: ListDriver | None = None


class ListManager(Service, urn="urn:jaus:jss:core:ListManager"):
    """A list for all drivers of a component. An invalid request is rejected as a whole.

    Without any driver the list accepts every message that the component accepts. `active` is the element that is being
    carried out, 0 for none. Deleting it, losing control and `stop` end the execution; replacing it begins it anew.
    The command that started the list has been carried out when the last element is done.
    """

    def __init__(self, *, max_elements: int = MAX_ELEMENTS, max_bytes: int = MAX_BYTES) -> None:
        self._max_elements = max_elements
        self._max_bytes = max_bytes
        self._drivers: list[ListDriver] = []
        self._elements: dict[int, Element] = {}
        self._command = CommandCompletion()
        self.list = ElementList()
        self.active = 0
        self.is_complete = False
        """True after the last element is done, until the list is executed again or changed."""

    # --- what drivers call

    def add_driver(self, driver: ListDriver) -> None:
        """Accept elements for this driver, too."""
        self._drivers.append(driver)

    def message(self, uid: int) -> Message | None:
        """The message of an element; None when there is no such element."""
        element = self._elements.get(uid)
        return element.message if element else None

    def execute(self, uid: int) -> None:
        """Start with this element, or with the first one for 0; does nothing for an empty list."""
        uid = uid or next(iter(self.list.order), 0)
        if uid in self._elements:
            self._command(False)
            self._command = self.host.begin_command()
            self._begin(uid)

    def done(self) -> None:
        """The active element was reached: the next one becomes active, or the list has ended."""
        if not self.active:
            return
        pause = LAP_PAUSE if self.list.next(self.active) == self.list.order[0] else 0.0
        self.host.set_timer(_TIMER, self.host.now + pause, self._begin_next)

    def stop(self) -> None:
        """Stop the execution; the list is kept. May be called twice."""
        self._end(success=False)

    def _end(self, *, success: bool) -> None:
        self.host.cancel_timer(_TIMER)
        driver = self._driver(self.active)
        self.is_complete = success if self.active else self.is_complete
        self.active = 0
        if driver is not None:
            driver.end_elements()
        self._command(success)

    def control_lost(self) -> None:
        """Stop the execution: a motion started by one client must not continue under another."""
        self.stop()

    def _begin_next(self) -> None:
        following = self.list.next(self.active)
        if following:
            self._begin(following)
        else:
            self._end(success=True)

    def _begin(self, uid: int) -> None:
        self.host.cancel_timer(_TIMER)
        before, element = self._driver(self.active), self._elements[uid]
        if before is not None and before is not element.driver:
            before.end_elements()
        self.active, self.is_complete = uid, False
        if element.driver is not None:
            element.driver.begin_element(uid, element.message)

    def _driver(self, uid: int) -> ListDriver | None:
        element = self._elements.get(uid)
        return element.driver if element else None

    # --- predicates

    def element_exists(self, msg: Any) -> bool:
        """True if all named elements exist. To execute, 0 means the first element; to delete, 65535 means all."""
        if isinstance(msg, DeleteElement):
            return all(uid in self._elements or uid == ALL_ELEMENTS for uid in _deleted(msg))
        uid: int | None = msg.element_uid
        return uid in self._elements or (uid == 0 and bool(self._elements) and not isinstance(msg, QueryElement))

    def is_valid_element_request(self, msg: SetElement) -> bool:
        """The links of the elements are consistent with each other and the list, and there is room."""
        return self._reason_to_reject(msg) is None

    def is_element_supported(self, msg: SetElement) -> bool:
        """Each element can be carried out by some driver."""
        return all(self._read(record) is not None for record in msg.element_list)

    def is_list_valid(self) -> bool:
        """True: requests that would break the list are refused."""
        return True

    # --- actions

    def set_element(self, msg: SetElement) -> None:
        """Insert or replace the elements, which the predicates have checked."""
        changed = self.list.linked(msg.element_list)
        read = {record.element_uid: self._read(record) for record in msg.element_list}
        assert isinstance(changed, ElementList)
        driver = self._driver(self.active)
        self.list, self.is_complete = changed, False
        self._elements |= {uid: element for uid, element in read.items() if element is not None}
        if self.active in read:
            if driver is not None and driver is not self._driver(self.active):
                driver.end_elements()
            self._begin(self.active)

    def delete_element(self, msg: DeleteElement) -> None:
        """Delete these elements."""
        named = set(_deleted(msg))
        uids = set(self._elements) if ALL_ELEMENTS in named else named
        if self.active in uids:
            self.stop()
        self.list, self.is_complete = self.list.without(uids), False
        for driver in self._drivers:
            driver.on_deleted(uids)
        self._elements = {uid: element for uid, element in self._elements.items() if uid not in uids}

    def _read(self, record: ElementRec) -> Element | None:
        data, size = record.element_data, len(_content(record))
        if data.format != ElementRec.ElementDataFormat.JAUS_MESSAGE:
            return None
        for driver in self._drivers:
            message = driver.read_element(data.data)
            if message is not None:
                return Element(data, size, message, driver)
        known = None if self._drivers else self.host.read(data.data)
        return Element(data, size, known) if known is not None else None

    def _reason_to_reject(self, msg: SetElement) -> ElementRejectCode | None:
        changed = self.list.linked(msg.element_list)
        if not isinstance(changed, ElementList):
            return changed
        return ElementRejectCode.OUT_OF_MEMORY if not self._has_room(changed, msg.element_list) else None

    def _has_room(self, changed: ElementList, records: Sequence[ElementRec]) -> bool:
        sizes = {uid: element.size for uid, element in self._elements.items()}
        sizes |= {record.element_uid: len(_content(record)) for record in records}
        return len(changed.order) <= self._max_elements and sum(sizes.values()) <= self._max_bytes

    # --- reports

    def confirm_element_request(self, msg: SetElement | DeleteElement) -> ConfirmElementRequest:
        """The request was carried out."""
        return ConfirmElementRequest(request_id=msg.request_id_rec.request_id)

    def reject_element_request(self, msg: SetElement | DeleteElement) -> RejectElementRequest:
        """Nothing was changed, with the reason."""
        code = ElementRejectCode.ELEMENT_NOT_FOUND
        if isinstance(msg, SetElement):
            code = self._reason_to_reject(msg) or ElementRejectCode.UNSUPPORTED_ELEMENT_TYPE
        self.host.count("list_request_rejected", f"{code.name}: {msg}")
        return RejectElementRequest(request_id=msg.request_id_rec.request_id, response_code=code)

    def report_element(self, query: QueryElement) -> ReportElement:
        """One element with its current links."""
        uid = query.element_uid
        data = self._elements[uid].data
        return ReportElement(
            element_uid=uid,
            previous_uid=self.list.previous(uid),
            next_uid=self.list.next(uid),
            element_data=ReportElement.ElementData(format=data.format, data=data.data),
        )

    def report_element_list(self) -> ReportElementList:
        """All elements, first to last."""
        return ReportElementList([ReportElementList.ElementListRec(uid) for uid in self.list.order])

    def report_element_count(self) -> ReportElementCount:
        """The number of elements."""
        return ReportElementCount(len(self.list.order))


class MobilityListManager(ListManager, urn="urn:jaus:jss:mobility:ListManager"):
    """The list manager of mobility 1.0, from before it became a core service."""


class ManipulatorListManager(ListManager, urn="urn:jaus:jss:manipulator:ListManager"):
    """The list manager of manipulator 1.0, from before it became a core service."""


def _deleted(msg: DeleteElement) -> list[int]:
    return [record.element_uid for record in msg.delete_element_list]


def _content(record: ElementRec) -> bytes:
    content = record.element_data.data
    return content.encode(strict=False) if isinstance(content, Message) else content


class ListDriver(Service):
    """Carries out elements one by one; the component's `ListManager` keeps them and knows which one is active.

    A subclass sets the message classes of its elements (`element_types`), starts one in `begin_element`, calls
    `self.elements.done()` when it has been reached, and stops in `end_elements`. Of several drivers in a component the
    first that takes an element carries it out.
    """

    element_types: ClassVar[tuple[type[Message], ...]] = ()

    elements: ListManager
    """The list manager of the component; there since `attached`."""

    def attached(self) -> None:
        """Offer this driver to the list manager."""
        found = self.host.service(ListManager)
        if found is None:
            raise ConfigError(f"{type(self).__name__} carries out a list, and its definition inherits no ListManager")
        self.elements = found
        found.add_driver(self)

    # --- to be overridden

    def begin_element(self, uid: int, message: Message) -> None:
        """Start carrying out this element; it replaces the one before, of this driver or another one."""
        raise NotImplementedError(f"{type(self).__name__}.begin_element")

    def on_deleted(self, uids: Collection[int]) -> None:
        """Called after these elements of the list, of this driver or others, were deleted."""

    def end_elements(self) -> None:
        """Stop: the list has ended, was stopped, or continues with another driver."""

    def read_element(self, content: Message | bytes) -> Message | None:
        """Decode the message of an element as one of `element_types`; None when this driver cannot carry it out."""
        data = content.encode(strict=False) if isinstance(content, Message) else content
        code = message_id(data)
        for kind in self.element_types:
            if code == kind.CODE:
                try:
                    return kind.decode(data)
                except DecodeError:
                    return None
        return None

    # --- given

    def element_specified(self, msg: Any) -> bool:
        """The request to execute the list names an element; otherwise it changes the speed."""
        return msg.element_uid is not None
