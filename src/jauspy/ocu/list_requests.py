"""The list of a component on the wire: what is asked about it, and changes that it confirms or refuses."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Final, TypeAlias

from jauspy.codec.message import Message
from jauspy.errors import ElementRejected, ResponseTimeout
from jauspy.ids import JausID
from jauspy.messages.core import (
    ConfirmElementRequest,
    DeleteElement,
    ElementRec,
    QueryElement,
    QueryElementList,
    RejectElementRequest,
    ReportElement,
    ReportElementList,
    SetElement,
)
from jauspy.ocu.link import Link

BATCH: Final = 255
"""Elements that fit one request."""
_Code: TypeAlias = RejectElementRequest.ResponseCode
_MEANINGS: Final[dict[int, str]] = {
    _Code.INVALID_ELEMENT_ID: "it takes no element of this number",
    _Code.INVALID_PREVIOUS_ELEMENT: "the list has changed meanwhile; call `read()` and try again",
    _Code.INVALID_NEXT_ELEMENT: "the list has changed meanwhile; call `read()` and try again",
    _Code.UNSUPPORTED_ELEMENT_TYPE: "none of its drivers carries out such an element",
    _Code.ELEMENT_NOT_FOUND: "the list has changed meanwhile; call `read()` and try again",
    _Code.OUT_OF_MEMORY: "it has no room for more elements, and a new list needs room beside the old one: "
    "`clear()` the list first, or upload less",
    _Code.UNSPECIFIED_ERROR: "it does not say why",
}


class ListRequests:
    """Asks one component. Changes raise `ElementRejected` with the reason, or `ResponseTimeout`."""

    def __init__(self, link: Link, id: JausID) -> None:
        self._link = link
        self._id = id

    async def order(self) -> list[int]:
        """The numbers of the elements, first to last."""
        report = await self._link.query(self._id, QueryElementList())
        assert isinstance(report, ReportElementList)
        return [each.element_uid for each in report.element_list]

    async def comes_to(self, fits: Callable[[list[int]], bool]) -> bool:
        """True when `order` fits; asked again when not, for a report may answer an earlier question late."""
        for _ in range(self._link.patience.retries + 1):
            if fits(await self.order()):
                return True
        return False

    async def element(self, uid: int) -> ReportElement:
        """One of them, with its links."""

        def is_meant(report: Message) -> bool:
            return isinstance(report, ReportElement) and report.element_uid == uid

        report = await self._link.query(self._id, QueryElement(element_uid=uid), accept=is_meant)
        assert isinstance(report, ReportElement)
        return report

    async def put(self, records: Sequence[ElementRec]) -> None:
        """Insert or replace up to `BATCH` elements; all are taken, or none."""
        await self._request(lambda number: SetElement(SetElement.RequestIDRec(number), list(records)))

    async def remove(self, uids: Iterable[int]) -> None:
        """Delete up to `BATCH` elements."""
        gone = list(uids)
        records = [DeleteElement.DeleteElementRec(uid) for uid in gone]
        try:
            await self._request(lambda number: DeleteElement(DeleteElement.RequestIDRec(number), records))
        except ElementRejected:
            # A request that was sent again, because its confirmation was lost, finds nothing to delete any more.
            if not await self.comes_to(lambda order: not set(gone) & set(order)):
                raise

    async def _request(self, make: Callable[[int], Message]) -> None:
        number = self._link.next_request_id(self._id)
        try:
            answer = await self._link.request(
                self._id,
                make(number),
                ConfirmElementRequest,
                RejectElementRequest,
                accept=lambda each: getattr(each, "request_id", None) == number,
            )
        except ResponseTimeout as error:
            raise ResponseTimeout(f"{error}; a list obeys only the client in control: see `control()`") from None
        if isinstance(answer, RejectElementRequest):
            code = answer.response_code
            name, why = getattr(code, "name", f"code {code}"), _MEANINGS.get(code, "a reason not in the standard")
            raise ElementRejected(f"{self._id} refused to change its list ({name}): {why}")
