"""Reports of components at a rate, and the fields of a message as a flat list: path, text, unit, number."""

from __future__ import annotations

import asyncio
import math
from collections.abc import AsyncGenerator, Iterator
from contextlib import suppress
from dataclasses import dataclass
from enum import IntEnum
from functools import lru_cache
from typing import Any, Final

from jauspy.codec.items import Bits, Blob, Choice, Formatted, Item, Number, Real, join
from jauspy.codec.layout import Composite, Grid, Repeat, Union
from jauspy.codec.message import Message
from jauspy.codec.names import unit_symbol
from jauspy.codec.registry import Registry
from jauspy.errors import ConfigError, EventRejected
from jauspy.ids import JausID
from jauspy.ocu import OCU
from jauspy.ocu.replies import report_of
from jauspy.ocu.subsystems import ComponentInfo

MAX_FIELDS: Final = 200
"""Fields of one message that are shown; a map has thousands."""
MAX_BYTES: Final = 32
"""Bytes of binary data that are shown."""


@dataclass(frozen=True, slots=True)
class Field:
    """One value of a message."""

    path: str
    text: str
    unit: str = ""
    number: float | None = None
    """The value to plot; None for texts, binary data and what is not finite."""


def fields_of(message: Message) -> list[Field]:
    """The first `MAX_FIELDS` fields of a message; a last one tells if there are more."""
    found: list[Field] = []
    for field in _walk(message.layout(), message, ""):
        if len(found) == MAX_FIELDS:
            return [*found, Field("\u2026", f"only the first {MAX_FIELDS} fields are shown")]
        found.append(field)
    return found


def numbers_of(message: Message) -> dict[str, float]:
    """The numeric fields by their path."""
    return {field.path: field.number for field in fields_of(message) if field.number is not None}


def queries_of(component: ComponentInfo, registry: Registry) -> dict[str, Message]:
    """The queries that a component answers by its services, by name; by default each requests all fields."""
    found: dict[str, Message] = {}
    for service in sorted(component.services, key=lambda service: service.version, reverse=True):
        for query in _queries(registry, service.urn, service.version):
            found.setdefault(query.NAME, query)
    return dict(sorted(found.items()))


@lru_cache(maxsize=512)
def _queries(registry: Registry, urn: str, version: str) -> tuple[Message, ...]:
    found = []
    for entry in registry.entries:
        if (entry.service, entry.version) == (urn, version) and entry.name.startswith("Query"):
            try:
                query = entry.load()()
                report_of(registry, query)
            except (ConfigError, TypeError):  # it needs an argument, or no report is known
                continue
            found.append(query)
    return tuple(found)


def _walk(item: Item, value: Any, path: str) -> Iterator[Field]:
    if value is None:
        return
    if isinstance(item, Composite):
        for slot in item.slots:
            yield from _walk(slot.item, getattr(value, slot.name), join(path, slot.name))
    elif isinstance(item, Bits):
        for bit in item.bits:
            yield _number(getattr(value, bit.name), join(path, bit.name), "")
    elif isinstance(item, Union):
        for name, arm in item.arms.items():
            if arm.cls is type(value):
                yield from _walk(arm, value, join(path, name))
    elif isinstance(item, (Repeat, Grid)):
        inner = item.item if isinstance(item, Repeat) or len(item.sizes) < 2 else Grid(item.item, item.sizes[1:])
        for index, part in enumerate(value):
            yield from _walk(inner, part, f"{path}[{index}]")
    elif isinstance(item, Choice):
        yield _number(value.choice, join(path, "choice"), "")
        if (chosen := item.items.get(value.choice)) is not None:
            yield from _walk(chosen, value.value, join(path, "value"))
    elif isinstance(item, Formatted):
        yield _number(value.format, join(path, "format"), "")
        yield from _data(value.data, join(path, "data"))
    elif isinstance(item, Blob):
        yield from _data(value, path)
    elif isinstance(value, str):
        yield Field(path, value)
    elif isinstance(item, Real):
        decimals = min(12, max(0, math.floor(math.log10(item.scaling.factor))))  # as many as the encoding resolves
        yield _number(round(value, decimals) + 0.0, path, unit_symbol(item.units))
    else:
        yield _number(value, path, unit_symbol(item.units) if isinstance(item, Number) else "")


def _number(value: Any, path: str, unit: str) -> Field:
    if isinstance(value, IntEnum):
        return Field(path, f"{value.name} ({int(value)})", "", float(value))
    if isinstance(value, float):
        return Field(path, f"{value:.6g}", unit, value if math.isfinite(value) else None)
    return Field(path, str(value), unit, float(value))


def _data(value: Message | bytes, path: str) -> Iterator[Field]:
    if isinstance(value, Message):
        yield Field(path, value.NAME)
        yield from _walk(value.layout(), value, path)
    else:
        more = "" if len(value) <= MAX_BYTES else f" \u2026 {len(value)} bytes"
        yield Field(path, value[:MAX_BYTES].hex(" ") + more)


async def reports_of(
    ocu: OCU, component: JausID, query: Message, rate: float, *, events: bool
) -> AsyncGenerator[Message, None]:
    """Events of the component at `rate` Hz; queries at this rate if it has none of this report.

    Raises `JausError` when the component does not answer.
    """
    if events:
        with suppress(EventRejected):
            async with ocu.service(component, query.SERVICE).subscribe(query, rate=rate) as reports:
                async for report in reports:
                    yield report
    clock = asyncio.get_running_loop().time
    while True:
        began = clock()
        yield await ocu.query(component, query)
        await asyncio.sleep(max(0.0, began + 1.0 / rate - clock()))
