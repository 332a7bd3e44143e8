"""The list of a component, of waypoints or whatever its drivers carry out, as a Python sequence."""

from __future__ import annotations

from collections.abc import AsyncGenerator, Iterable, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any, Final, TypeAlias, overload

from jauspy.arguments import check_number, described
from jauspy.codec.message import Message
from jauspy.errors import ConfigError, DecodeError, ElementRejected, JausError, RequestError
from jauspy.messages.core import ElementRec, ReportElement, ReportStatus
from jauspy.ocu.arguments import check_message
from jauspy.ocu.link import Link
from jauspy.ocu.list_requests import BATCH, ListRequests
from jauspy.ocu.only_async import use
from jauspy.ocu.progress import progress

if TYPE_CHECKING:
    from jauspy.ocu.service import ServiceClient

Element: TypeAlias = Message | bytes
"""A message, or bytes of a format of the user's own."""

RESERVED: Final = (0, 65535)
"""Numbers that no element has: 0 stands for none, 65535 for all."""

EXAMPLE: Final = "SetLocalWaypoint(x=1.0, y=2.0)"


class Elements(Sequence[Element]):
    """The elements as they were when they were last read or changed from here: `len`, `[]`, `in` and loops use those.

    What changes them is sent first and shows here when the component has confirmed it. Changing needs control; raises
    `ElementRejected` with the reason, or `ResponseTimeout`. Lists longer than 255 are changed in several requests.
    """

    def __init__(self, link: Link, service: ServiceClient) -> None:
        self._link = link
        self._service = service
        self._wire = ListRequests(link, service.id)
        self._items: dict[int, Element] | None = None
        """By number, in the list's order; None before the first look at the component's own."""

    def __repr__(self) -> str:
        return f"<{'?' if self._items is None else len(self)} elements of {self._service!r}>"

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
        """Fetch the list from the component."""
        items: dict[int, Element] = {}
        for uid in await self._wire.order():
            items[uid] = self._content((await self._wire.element(uid)).element_data)
        self._items = items
        return self[:]

    async def upload(self, elements: Iterable[Element]) -> None:
        """Replace the whole list, whatever it held, and end its execution.

        The old list is deleted when all of the new one is there, in front of it, where the robot does not come. When
        anything goes wrong the old one stays.
        """
        records, old = _checked(elements), await self._wire.order()
        self._items = dict.fromkeys(old, b"")  # whatever they hold
        try:
            await self._open(old)
            await self._insert(0, records)
            await self._compare()
        except BaseException as error:
            await self._take_back(old, error)
            raise
        try:
            await self._delete(old)
        except BaseException as error:
            self._items = None
            error.add_note("the new list is there, and behind it what is left of the old one; `upload()` cleans up")
            raise

    async def append(self, element: Element) -> None:
        """Put it at the end."""
        await self.extend([element])

    async def extend(self, elements: Iterable[Element]) -> None:
        """Put them at the end."""
        new = _checked(elements)
        await self._known()
        await self._insert(len(self), new)

    async def insert(self, index: int, element: Element) -> None:
        """Put it before the element at `index`, as `list.insert` does."""
        check_number(index, "index", whole=True)
        new = _checked([element])
        await self._known()
        await self._insert(slice(index, None).indices(len(self))[0], new)

    async def replace(self, index: int | slice, elements: Element | Iterable[Element]) -> None:
        """What `list[index] = elements` does. One that is being carried out is begun anew."""
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
        """What `del list[index]` does. Deleting the element that is being carried out ends the execution."""
        await self._delete(await self._at(index))

    async def clear(self) -> None:
        """Delete all, also what was not read yet."""
        await self.upload(())

    if not TYPE_CHECKING:
        __setitem__ = use("`await elements.replace(index, ...)`")
        __delitem__ = use("`await elements.delete(index)`")
        __iadd__ = use("`await elements.extend(...)`")

    # --- carrying out ---------------------------------------------------------------------------------------------

    async def execute(self, speed: float | None = None, *, start: int = 0) -> None:
        """Carry out the list from the element at `start`; `speed` in m/s, for drivers that have one.

        Raises `RequestError` when the component is not Ready, for then it ignores this. It is sent again while no
        element is active, as often as queries are; a list may be over at once, so none at all is no error.
        """
        (uid,) = await self._at(start)
        command = self._service.message("ExecuteList")
        for _ in range(self._link.patience.retries + 1):
            await self._service.send(command(element_uid=uid, **_speed(command, speed)))
            await self._check_ready(command.NAME)
            if (await self._report_active()).element_uid:
                return

    async def set_speed(self, speed: float) -> None:
        """Go on at another speed, in m/s; raises `ResponseTimeout` when the component does not acknowledge it."""
        command = self._service.message("ExecuteList")
        await self._service.send(command(**_speed(command, speed)), ack=True)

    async def active(self) -> int | None:
        """The index of the element that is being carried out, None when there is none."""
        return await self._index((await self._report_active()).element_uid)

    async def progress(self, *, rate: float | None = None, grace: float = 2.0) -> AsyncGenerator[int, None]:
        """The index of each element as it becomes the active one, until there is none any more.

        The component tells of changes, or, with `rate`, how it is so many times a second. `grace` is how long
        (seconds) it may take until the first is active.
        """
        query = self._service.message("QueryActiveElement")()
        async for uid in progress(self._service, query, rate, grace):
            index = await self._index(uid)
            if index is not None:
                yield index

    # --- inside ---------------------------------------------------------------------------------------------------

    def _read_before(self) -> dict[int, Element]:
        if self._items is None:
            raise ConfigError(f"the list of {self._service.id} was not read yet; call `read()` or `upload()` first")
        return self._items

    async def _known(self) -> dict[int, Element]:
        if self._items is None:
            await self.read()
        return self._read_before()

    async def _at(self, index: int | slice) -> list[int]:
        if not isinstance(index, slice):
            check_number(index, "index", whole=True)
        uids = list(await self._known())
        if isinstance(index, slice):
            return uids[index]
        if not -len(uids) <= index < len(uids):
            raise IndexError(f"there is no element {index}; the list has {len(uids)}")
        return [uids[index]]

    async def _report_active(self) -> Any:
        return await self._service.query(self._service.message("QueryActiveElement")())

    async def _index(self, uid: int) -> int | None:
        if not uid:
            return None
        if uid not in await self._known():
            await self.read()
        order = list(await self._known())
        return order.index(uid) if uid in order else None

    async def _insert(self, at: int, elements: list[Element]) -> None:
        order = list(taken := await self._known())
        free = (uid for uid in range(1, RESERVED[1]) if uid not in taken)
        new = dict(zip(free, elements, strict=False))
        if len(new) < len(elements):
            raise ConfigError(f"{len(order) + len(elements)} elements are more than the {RESERVED[1] - 1} of a list")
        await self._set(new, [*order[:at], *new, *order[at:]])

    async def _set(self, new: dict[int, Element], order: list[int]) -> None:
        """Make these elements; `order` is the list's afterwards. Each request alone leaves the list well linked."""
        uids = [uid for uid in order if uid in new]
        for start in range(0, len(uids), BATCH):
            batch, later = uids[start : start + BATCH], set(uids[start + BATCH :])
            items = await self._known()
            then = [uid for uid in order if uid in items or uid not in later]
            links = {uid: (before, after) for (before, uid), (_, after) in pairwise(pairwise([0, *then, 0]))}
            records = [ElementRec(uid, *links[uid], _data(new[uid])) for uid in batch]
            await self._wire.put(records)
            changed = items | {uid: new[uid] for uid in batch}
            self._items = {uid: changed[uid] for uid in then}

    async def _delete(self, uids: list[int]) -> None:
        for start in range(0, len(uids), BATCH):
            gone = uids[start : start + BATCH]
            await self._wire.remove(gone)
            self._items = {uid: item for uid, item in (self._items or {}).items() if uid not in gone}

    async def _open(self, order: list[int]) -> None:
        """A list that goes round leads from its last element to the first one; nothing fits in front of that."""
        if not order:
            return
        last = await self._wire.element(order[-1])
        if last.next_uid:
            data = ElementRec.ElementData(last.element_data.format, last.element_data.data)
            await self._wire.put([ElementRec(order[-1], order[-2] if len(order) > 1 else 0, 0, data)])

    async def _compare(self) -> None:
        wanted = list(await self._known())
        if not await self._wire.comes_to(lambda there: there == wanted):
            raise ElementRejected(
                f"{self._service.id} confirmed a new list in front of its old one, and now reports another one: "
                "somebody else changes it, too, or it does not link as the standard says; the old list was left there"
            )

    async def _take_back(self, old: list[int], error: BaseException) -> None:
        """Delete what the component took of a new list before something went wrong."""
        try:
            await self._delete([uid for uid in await self._wire.order() if uid not in old])
        except JausError:
            error.add_note("what was taken of the new list is still in front of the old one; `upload()` cleans up")
        finally:
            self._items = None

    async def _check_ready(self, command: str) -> None:
        status = await self._service.status()
        if status != ReportStatus.Status.READY:
            name = getattr(status, "name", status)
            raise RequestError(f"{self._service.id} ignores {command} while it is {name}; call `resume()` first")

    def _content(self, data: ReportElement.ElementData) -> Element:
        if data.format != ReportElement.ElementDataFormat.JAUS_MESSAGE or isinstance(data.data, Message):
            return data.data
        try:
            return self._link.registry.decode(data.data)
        except DecodeError:
            return data.data


def _checked(elements: Any) -> list[Element]:
    if isinstance(elements, Message | bytes | type) or not isinstance(elements, Iterable):
        raise TypeError(f"a list is made of several elements, as in [{EXAMPLE}], not {described(elements)}")
    found = list(elements)
    for each in found:
        if not isinstance(each, bytes):
            check_message(each, "a list", EXAMPLE)
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
