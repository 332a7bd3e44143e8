"""The element list of a component, such as waypoints, as a Python sequence (List Manager service, AS5710)."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncGenerator, Callable, Iterable, Sequence
from contextlib import aclosing
from itertools import pairwise
from typing import TYPE_CHECKING, Any, Final, TypeAlias, overload

from jauspy.arguments import async_only, check_number, described
from jauspy.codec.message import Message
from jauspy.errors import (
    ConfigError,
    DecodeError,
    ElementRejected,
    EventRejected,
    JausError,
    RequestError,
    ResponseTimeout,
)
from jauspy.ids import JausID
from jauspy.messages.core import (
    ConfirmElementRequest,
    DeleteElement,
    ElementRec,
    QueryElement,
    QueryElementList,
    QueryStatus,
    RejectElementRequest,
    ReportElement,
    ReportElementList,
    ReportStatus,
    SetElement,
)
from jauspy.ocu.connection import Connection
from jauspy.ocu.replies import check_message, report_of
from jauspy.ocu.subscription import Subscription, subscribe
from jauspy.ocu.subsystems import ServiceInfo

Element: TypeAlias = Message | bytes
"""A message, or bytes of a user-defined format."""

RESERVED_UIDS: Final = (0, 65535)
"""Element UIDs that no element has: 0 stands for none, 65535 for all."""
MAX_ELEMENTS_PER_REQUEST: Final = 255
"""Elements that fit one request."""
ACTIVE_ELEMENT_INTERVAL: Final = 0.2
"""Seconds between two queries to a component that rejects events on its active element."""
ELEMENT_TIMEOUT: Final = 300.0
"""Seconds that an element may be active while a program follows the progress of a list."""
RECHECK_INTERVAL: Final = 1.0
"""Seconds without an event after which the active element is queried: the last event may have been lost."""
EXAMPLE_ELEMENT: Final = "SetLocalWaypoint(x=1.0, y=2.0)"

_Code: TypeAlias = RejectElementRequest.ResponseCode
_REJECTION_REASONS: Final[dict[int, str]] = {
    _Code.INVALID_ELEMENT_ID: "it takes no element of this number",
    _Code.INVALID_PREVIOUS_ELEMENT: "the list has changed meanwhile; call `read()` and try again",
    _Code.INVALID_NEXT_ELEMENT: "the list has changed meanwhile; call `read()` and try again",
    _Code.UNSUPPORTED_ELEMENT_TYPE: "none of its drivers carries out such an element",
    _Code.ELEMENT_NOT_FOUND: "the list has changed meanwhile; call `read()` and try again",
    _Code.OUT_OF_MEMORY: "it has no room for more elements, and a new list needs room beside the old one: "
    "`clear()` the list first, or upload less",
    _Code.UNSPECIFIED_ERROR: "it does not say why",
}


class Elements(Sequence[Element]):
    """A copy of the list as it was last read or changed by this client; `len`, `[]`, `in` and loops use the copy.

    A change is sent first, and made in the copy when the component has confirmed it. Changes need control; they raise
    `ElementRejected` with the reason, or `ResponseTimeout`. More than 255 elements are changed in several requests.
    """

    def __init__(self, connection: Connection, id: JausID, info: ServiceInfo) -> None:
        self._connection = connection
        self._id = id
        self._info = info
        self._client = ListClient(connection, id)
        self._items: dict[int, Element] | None = None
        """Elements by UID, in the list's order; None before the component's list was read."""

    def __repr__(self) -> str:
        return f"<{'?' if self._items is None else len(self)} elements of {self._info} at {self._id}>"

    def __len__(self) -> int:
        return len(self._read_before())

    @overload
    def __getitem__(self, index: int) -> Element: ...

    @overload
    def __getitem__(self, index: slice) -> list[Element]: ...

    def __getitem__(self, index: int | slice) -> Element | list[Element]:
        return list(self._read_before().values())[index]

    # --- reading and changing -------------------------------------------------------------------------------------

    async def read(self) -> list[Element]:
        """Read the list from the component."""
        items: dict[int, Element] = {}
        for uid in await self._client.uids():
            items[uid] = self._content((await self._client.element(uid)).element_data)
        self._items = items
        return self[:]

    async def upload(self, elements: Iterable[Element]) -> None:
        """Replace the whole list and end its execution.

        The new elements are inserted before the old ones, which are deleted when all new ones are confirmed. If an
        error occurs before that, the old list remains.
        """
        records, old = _checked(elements), await self._client.uids()
        self._items = dict.fromkeys(old, b"")  # their contents are not needed
        try:
            await self._break_loop(old)
            await self._insert(0, records)
            await self._compare()
        except BaseException as error:
            await self._remove_new(old, error)
            raise
        try:
            await self._delete(old)
        except BaseException as error:
            self._items = None
            error.add_note("the new list is there, and behind it what is left of the old one; `upload()` cleans up")
            raise

    async def append(self, element: Element) -> None:
        """Add an element at the end."""
        await self.extend([element])

    async def extend(self, elements: Iterable[Element]) -> None:
        """Add elements at the end."""
        new = _checked(elements)
        await self._known()
        await self._insert(len(self), new)

    async def insert(self, index: int, element: Element) -> None:
        """Insert an element before the one at `index`, as `list.insert` does."""
        check_number(index, "index", whole=True)
        new = _checked([element])
        await self._known()
        await self._insert(slice(index, None).indices(len(self))[0], new)

    async def replace(self, index: int | slice, elements: Element | Iterable[Element]) -> None:
        """The same as `list[index] = elements`. The component restarts an active element that is replaced."""
        new = _checked(elements if isinstance(index, slice) else [elements])
        uids = await self._at(index)
        if len(new) == len(uids):
            await self._set(dict(zip(uids, new, strict=True)), list(await self._known()))
            return
        assert isinstance(index, slice)
        if index.step not in (None, 1):
            raise ConfigError(f"{len(new)} elements cannot replace {len(uids)} that do not follow each other")
        await self._insert(index.indices(len(self))[0], new)
        await self._delete(uids)

    async def delete(self, index: int | slice) -> None:
        """The same as `del list[index]`. Deleting the active element ends the execution."""
        await self._delete(await self._at(index))

    async def clear(self) -> None:
        """Delete all elements of the component's list, read or not."""
        await self.upload(())

    if not TYPE_CHECKING:
        __setitem__ = async_only("`await elements.replace(index, ...)`")
        __delitem__ = async_only("`await elements.delete(index)`")
        __iadd__ = async_only("`await elements.extend(...)`")

    # --- executing ------------------------------------------------------------------------------------------------

    async def execute(self, speed: float | None = None, *, start: int = 0) -> None:
        """Execute the list from the element at `start`; `speed` in m/s, for drivers that take one.

        Raises `RequestError` when the component is not Ready, since it then ignores the command. The command is sent
        again, as often as queries are, while no element is active; a short list may end before the first query, so it
        is no error that no element is active.
        """
        (uid,) = await self._at(start)
        command = self._message("ExecuteList")
        for _ in range(self._connection.retry.retries + 1):
            message = command(element_uid=uid, **_speed(command, speed))
            await self._connection.send_checked(self._id, message, ack=False)
            await self._check_ready(command.NAME)
            if (await self._report_active()).element_uid:
                return

    async def set_speed(self, speed: float) -> None:
        """Change the speed of the execution, in m/s.

        Raises `ResponseTimeout` when the component does not acknowledge it.
        """
        command = self._message("ExecuteList")
        await self._connection.send_checked(self._id, command(**_speed(command, speed)), ack=True)

    async def active(self) -> int | None:
        """The index of the active element, or None."""
        return await self._index((await self._report_active()).element_uid)

    async def progress(
        self,
        *,
        rate: float | None = None,
        grace: float = 2.0,
        timeout: float = ELEMENT_TIMEOUT,  # noqa: ASYNC109 - it ends in an error that says which element is active
    ) -> AsyncGenerator[int, None]:
        """The index of each element as it becomes active, until no element is active any more.

        The component reports changes, or, with `rate` (Hz), its state periodically. `grace` is the time in seconds
        until the first element must be active. Raises `RequestError` if an element is still active after `timeout`
        seconds; the component continues until it is told otherwise, as by the end of a block of `control()`.
        """
        check_number(timeout, "timeout")
        active: int | None = None
        async with aclosing(self._active_uids(rate, grace)) as uids:
            while True:
                try:
                    async with asyncio.timeout(timeout) as limit:
                        uid = await anext(uids)
                except StopAsyncIteration:
                    return
                except TimeoutError:
                    if not limit.expired():
                        raise
                    raise RequestError(f"{self._id} is still at element {active} after {timeout:g} s") from None
                active = await self._index(uid)
                if active is not None:
                    yield active

    # --- inside ---------------------------------------------------------------------------------------------------

    def _message(self, name: str) -> type[Any]:
        return self._connection.message_class(self._info.urn, self._info.version, name)

    def _read_before(self) -> dict[int, Element]:
        if self._items is None:
            raise ConfigError(f"the list of {self._id} was not read yet; call `read()` or `upload()` first")
        return self._items

    async def _known(self) -> dict[int, Element]:
        if self._items is None:
            await self.read()
        return self._read_before()

    async def _at(self, index: int | slice) -> list[int]:
        """The UIDs of the elements at this index."""
        if not isinstance(index, slice):
            check_number(index, "index", whole=True)
        uids = list(await self._known())
        if isinstance(index, slice):
            return uids[index]
        if not -len(uids) <= index < len(uids):
            raise IndexError(f"there is no element {index}; the list has {len(uids)}")
        return [uids[index]]

    async def _index(self, uid: int) -> int | None:
        if not uid:
            return None
        if uid not in await self._known():
            await self.read()
        order = list(await self._known())
        return order.index(uid) if uid in order else None

    async def _insert(self, at: int, elements: list[Element]) -> None:
        order = list(taken := await self._known())
        free = (uid for uid in range(1, RESERVED_UIDS[1]) if uid not in taken)
        new = dict(zip(free, elements, strict=False))
        if len(new) < len(elements):
            most = RESERVED_UIDS[1] - 1
            raise ConfigError(f"{len(order) + len(elements)} elements are more than the {most} of a list")
        await self._set(new, [*order[:at], *new, *order[at:]])

    async def _set(self, new: dict[int, Element], order: list[int]) -> None:
        """Set these elements; `order` is the list's afterwards. After each request the list is well linked."""
        uids = [uid for uid in order if uid in new]
        for start in range(0, len(uids), MAX_ELEMENTS_PER_REQUEST):
            end = start + MAX_ELEMENTS_PER_REQUEST
            batch, later = uids[start:end], set(uids[end:])
            items = await self._known()
            then = [uid for uid in order if uid in items or uid not in later]
            links = {uid: (before, after) for (before, uid), (_, after) in pairwise(pairwise([0, *then, 0]))}
            records = [ElementRec(uid, *links[uid], _data(new[uid])) for uid in batch]
            await self._client.set(records)
            changed = items | {uid: new[uid] for uid in batch}
            self._items = {uid: changed[uid] for uid in then}

    async def _delete(self, uids: list[int]) -> None:
        for start in range(0, len(uids), MAX_ELEMENTS_PER_REQUEST):
            batch = uids[start : start + MAX_ELEMENTS_PER_REQUEST]
            await self._client.delete(batch)
            self._items = {uid: item for uid, item in (self._items or {}).items() if uid not in batch}

    async def _break_loop(self, order: list[int]) -> None:
        """Unlink the last element of a looping list from the first one; nothing fits in front of a loop."""
        if not order:
            return
        last = await self._client.element(order[-1])
        if last.next_uid:
            data = ElementRec.ElementData(last.element_data.format, last.element_data.data)
            await self._client.set([ElementRec(order[-1], order[-2] if len(order) > 1 else 0, 0, data)])

    async def _compare(self) -> None:
        expected = list(await self._known())
        if not await self._client.becomes(lambda uids: uids == expected):
            raise ElementRejected(
                f"{self._id} confirmed a new list in front of its old one, and now reports another one: "
                "another client changes it, too, or its links differ from the standard; the old list was kept"
            )

    async def _remove_new(self, old: list[int], error: BaseException) -> None:
        """Delete the elements of a new list that the component took before an error occurred."""
        try:
            await self._delete([uid for uid in await self._client.uids() if uid not in old])
        except JausError:
            error.add_note("what was taken of the new list is still in front of the old one; `upload()` cleans up")
        finally:
            self._items = None

    async def _check_ready(self, command: str) -> None:
        report = await self._connection.query(self._id, QueryStatus(), expects=ReportStatus)
        assert isinstance(report, ReportStatus)
        if report.status != ReportStatus.Status.READY:
            name = getattr(report.status, "name", report.status)
            raise RequestError(f"{self._id} ignores {command} while it is {name}; call `resume()` first")

    def _content(self, data: ReportElement.ElementData) -> Element:
        if data.format != ReportElement.ElementDataFormat.JAUS_MESSAGE or isinstance(data.data, Message):
            return data.data
        try:
            return self._connection.registry.decode(data.data)
        except DecodeError:
            return data.data

    # --- the active element ---------------------------------------------------------------------------------------

    async def _report_active(self) -> Any:
        return await self._connection.query(self._id, self._message("QueryActiveElement")())

    async def _active_uids(self, rate: float | None, grace: float) -> AsyncGenerator[int, None]:
        """The UID of each element that becomes active, until none is; none at first is allowed for `grace` seconds.

        While no report arrives, the list may well be executed: silence does not end this.
        """
        clock = asyncio.get_running_loop().time
        last, give_up_at = 0, clock() + grace
        async with aclosing(self._active_reports(rate)) as reports:
            async for report in reports:
                uid = report.element_uid
                if not uid and (last or clock() >= give_up_at):
                    return
                if uid != last:
                    last = uid
                    yield uid

    async def _active_reports(self, rate: float | None) -> AsyncGenerator[Any, None]:
        yield await self._report_active()  # an event needs three messages and their answers before its first report
        query = self._message("QueryActiveElement")()
        kind = report_of(self._connection.registry, query)
        subscription = subscribe(self._connection, self._id, query, kind, rate=rate)
        try:
            await subscription.__aenter__()
        except EventRejected:
            while True:
                yield await self._report_active()
                await asyncio.sleep(ACTIVE_ELEMENT_INTERVAL)
        try:
            while True:
                yield await self._next_active(subscription)
        finally:
            await subscription.__aexit__(None, None, None)

    async def _next_active(self, subscription: Subscription[Any]) -> Any:
        try:
            async with asyncio.timeout(RECHECK_INTERVAL) as limit:
                return await subscription.get()
        except TimeoutError:
            if not limit.expired():
                raise
            return await self._report_active()


class ListClient:
    """Reads and changes the list of one component; changes raise `ElementRejected` with the reason."""

    def __init__(self, connection: Connection, id: JausID) -> None:
        self._connection = connection
        self._id = id

    async def uids(self) -> list[int]:
        """The UIDs of the elements, first to last."""
        report = await self._connection.query(self._id, QueryElementList())
        assert isinstance(report, ReportElementList)
        return [element.element_uid for element in report.element_list]

    async def becomes(self, condition: Callable[[list[int]], bool]) -> bool:
        """True when the UIDs fulfil `condition`; queried again if not, as a report may answer an earlier query late."""
        for _ in range(self._connection.retry.retries + 1):
            if condition(await self.uids()):
                return True
        return False

    async def element(self, uid: int) -> ReportElement:
        """One element with its links."""

        def has_uid(report: Message) -> bool:
            return isinstance(report, ReportElement) and report.element_uid == uid

        report = await self._connection.query(self._id, QueryElement(element_uid=uid), accept=has_uid)
        assert isinstance(report, ReportElement)
        return report

    async def set(self, records: Sequence[ElementRec]) -> None:
        """Insert or replace up to 255 elements; the component takes all of them, or none."""
        await self._request(lambda number: SetElement(SetElement.RequestIDRec(number), [*records]))

    async def delete(self, uids: Sequence[int]) -> None:
        """Delete up to 255 elements."""
        records = [DeleteElement.DeleteElementRec(uid) for uid in uids]
        try:
            await self._request(lambda number: DeleteElement(DeleteElement.RequestIDRec(number), records))
        except ElementRejected:
            # When the confirmation was lost, the request that was sent again finds nothing to delete.
            if not await self.becomes(lambda present: not {*uids} & {*present}):
                raise

    async def _request(self, make: Callable[[int], Message]) -> None:
        number = self._connection.next_request_id(self._id)
        try:
            answer = await self._connection.request(
                self._id,
                make(number),
                ConfirmElementRequest,
                RejectElementRequest,
                accept=lambda answer: getattr(answer, "request_id", None) == number,
            )
        except ResponseTimeout as error:
            raise ResponseTimeout(
                f"{error}; a list accepts commands only from the client in control: see `control()`"
            ) from None
        if isinstance(answer, RejectElementRequest):
            code = answer.response_code
            name = getattr(code, "name", f"code {code}")
            why = _REJECTION_REASONS.get(code, "a reason not in the standard")
            raise ElementRejected(f"{self._id} refused to change its list ({name}): {why}")


def _checked(elements: Any) -> list[Element]:
    if isinstance(elements, Message | bytes | type) or not isinstance(elements, Iterable):
        raise TypeError(f"a list is made of several elements, as in [{EXAMPLE_ELEMENT}], not {described(elements)}")
    found = list(elements)
    for element in found:
        if not isinstance(element, bytes):
            check_message(element, "a list", EXAMPLE_ELEMENT)
    return found


def _data(element: Element) -> ElementRec.ElementData:
    kinds = ElementRec.ElementDataFormat
    return ElementRec.ElementData(kinds.JAUS_MESSAGE if isinstance(element, Message) else kinds.USER_DEFINED, element)


def _speed(command: type[Message], speed: float | None) -> dict[str, float]:
    check_number(speed, "speed", optional=True)
    has_speed = "speed" in {slot for kind in command.__mro__ for slot in getattr(kind, "__slots__", ())}
    if has_speed and speed is None:
        raise ConfigError(f"{command.NAME} of {command.SERVICE} needs a speed in m/s, as in execute(speed=1.0)")
    if not has_speed and speed is not None:
        raise ConfigError(f"{command.NAME} of {command.SERVICE} has no speed; leave it out")
    return {} if speed is None else {"speed": speed}
