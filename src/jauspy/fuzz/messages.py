"""The messages under test, and valid random ones made from their layouts."""

from __future__ import annotations

import math
import struct
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from enum import Enum
from random import Random
from typing import Final

from jauspy.codec.items import Bits, Blob, Choice, Count, Formatted, Item, Number, Real, Text, Values
from jauspy.codec.layout import Composite, Grid, Repeat, Union
from jauspy.codec.message import Message
from jauspy.codec.registry import Registry
from jauspy.codec.scalars import FLOATS, SIZES, limits
from jauspy.errors import ConfigError
from jauspy.schema import model as m


@dataclass(frozen=True, slots=True)
class FuzzTarget:
    """One message of one service version."""

    cls: type[Message]
    model: m.MessageDefinition
    layout: Composite

    @property
    def id(self) -> bytes:
        """The two bytes every message of this kind starts with."""
        return self.cls.CODE.to_bytes(2, "little")

    @property
    def title(self) -> str:
        """Service and name, as in `core:Discovery 1.1 ReportServices`."""
        return f"{self.cls.SERVICE.removeprefix('urn:jaus:jss:')} {self.cls.VERSION} {self.cls.NAME}"


def targets(registry: Registry, schema: m.Schema, names: Iterable[str] = ()) -> tuple[FuzzTarget, ...]:
    """All messages of a registry that the schema has, or those of these names; `ConfigError` for an unknown name."""
    wanted = {registry.by_name(name).NAME for name in names}
    found = []
    models = {(s.id, s.version, msg.name): msg for s in schema.services for msg in s.messages}
    for entry in registry.entries:
        model = models.get((entry.service, entry.version, entry.name))
        if model is not None and (not wanted or entry.name in wanted):
            cls = entry.load()
            layout = cls.layout()
            assert isinstance(layout, Composite)
            found.append(FuzzTarget(cls, model, layout))
    if not found:
        raise ConfigError("there is no message to test")
    return tuple(found)


MAX_NESTING: Final = 3
"""Levels of messages inside messages."""


class Style(Enum):
    """Size and completeness of messages."""

    SHORTEST = 0
    FULL = 1
    ANY = 2


class MessageMaker:
    """Makes bytes that decode strictly; `inner` are the messages to put into others."""

    def __init__(self, rng: Random, style: Style, inner: Sequence[FuzzTarget] = ()) -> None:
        self._rng = rng
        self._style = style
        self._inner = inner
        self._depth = 0
        self._items = 400
        self._out = bytearray()

    def message(self, target: FuzzTarget) -> bytes:
        """The bytes of one random message, with its id."""
        before, self._out = self._out, bytearray(target.id)
        self._item(target.layout)
        made, self._out = bytes(self._out), before
        return made

    def _item(self, item: Item) -> None:
        match item:
            case Composite():
                self._composite(item)
            case Real():
                self._pack(item.code, self._edge_or_any(0, item.scaling.top))
            case Number():
                self._pack(item.code, self._number(item))
            case Bits():
                self._pack(item.code, self._bits(item))
            case Choice():
                chosen = self._choose(item.items)
                self._out.append(chosen)
                self._item(item.items[chosen])
            case Formatted():
                self._formatted(item)
            case Text():
                self._text(item)
            case Blob():
                self._counted(item.count, self._blob(item.count, nested=item.nested is not None))
            case Repeat():
                self._repeat(item)
            case Union():
                arms = dict(enumerate(item.arms.values()))
                tag = self._choose(arms)
                self._pack(item.code, tag)
                self._composite(arms[tag])
            case Grid():
                for _ in range(math.prod(item.sizes)):
                    self._item(item.item)
            case _:
                raise TypeError(item)

    def _pack(self, code: str, value: float) -> None:
        self._out += struct.pack(f"<{code}", value)

    def _choose(self, options: Mapping[int, Item]) -> int:
        if self._style is Style.SHORTEST:
            return min(options, key=lambda number: options[number].minimum)
        return self._rng.choice(list(options))

    def _composite(self, item: Composite) -> None:
        present = self._presence(item)
        if item.presence:
            spare = item.undefined if self._style is Style.ANY and self._rng.random() < 0.1 else 0
            self._pack(item.presence, present | (self._rng.getrandbits(64) & spare))
        bit = 1
        for slot in item.slots:
            if not slot.optional or present & bit:
                self._item(slot.item)
            bit <<= slot.optional

    def _presence(self, item: Composite) -> int:
        if not item.presence or self._style is Style.SHORTEST:
            return 0
        defined = limits(item.presence)[1] & ~item.undefined
        return defined if self._style is Style.FULL else self._rng.getrandbits(64) & defined

    def _edge_or_any(self, low: int, high: int) -> int:
        if self._style is Style.SHORTEST:
            return low
        if self._rng.random() < 0.3:
            return self._rng.choice((low, high, min(low + 1, high), max(high - 1, low)))
        return self._rng.randint(low, high)

    def _number(self, item: Number) -> float:
        if item.code in FLOATS:
            return self._float(item)
        return self._integer(item.values, *limits(item.code))

    def _integer(self, values: Values, low: int, high: int) -> int:
        options: list[tuple[int, int]] = [(member.value, member.value) for member in values.enum or ()]
        options += [(math.ceil(lower), math.floor(upper)) for lower, upper in values.intervals]
        fitting = [(max(low, lower), min(high, upper)) for lower, upper in options]
        fitting = [option for option in fitting if option[0] <= option[1]] or [(low, high)]
        return self._edge_or_any(*(fitting[0] if self._style is Style.SHORTEST else self._rng.choice(fitting)))

    def _float(self, item: Number) -> float:
        if item.values.intervals:
            low, high = self._rng.choice(item.values.intervals)
            value = self._rng.uniform(low, high)
            (rounded,) = struct.unpack(f"<{item.code}", struct.pack(f"<{item.code}", value))
            return min(max(float(rounded), low), high)
        (value,) = struct.unpack(f"<{item.code}", self._rng.randbytes(SIZES[item.code]))
        return float(value) if math.isfinite(value) else 0.0

    def _bits(self, item: Bits) -> int:
        raw = item.reserved & self._rng.getrandbits(64) if self._style is Style.ANY else 0
        for bit in item.bits:
            raw |= self._integer(bit.values, 0, bit.mask) << bit.shift
        return raw

    def _size(self, count: Count, usual: int) -> int:
        """A random count: usually small, sometimes large."""
        low, high = count.minimum, min(count.maximum, limits(count.code)[1])
        if self._style is Style.SHORTEST:
            return low
        if self._style is Style.ANY and self._rng.random() < 0.02:
            usual *= 20
        return max(low, min(high, self._rng.randint(self._style is Style.FULL, usual)))

    def _text(self, item: Text) -> None:
        if item.count is None:
            text = b"" if self._style is Style.SHORTEST else self._rng.randbytes(self._rng.randint(0, item.length))
            self._out += text.ljust(item.length, b"\0")
        else:
            self._counted(item.count, self._rng.randbytes(self._size(item.count, 12)))

    def _blob(self, count: Count, *, nested: bool) -> bytes:
        if nested and self._inner and self._depth < MAX_NESTING and self._style is not Style.SHORTEST:
            self._depth += 1
            made = self.message(self._rng.choice(self._inner))
            self._depth -= 1
            if count.minimum <= len(made) <= min(count.maximum, limits(count.code)[1]):
                return made
        return self._rng.randbytes(self._size(count, 12))

    def _counted(self, count: Count, data: bytes) -> None:
        self._pack(count.code, len(data))
        self._out += data

    def _formatted(self, item: Formatted) -> None:
        chosen = self._integer(item.formats, 0, 255)
        self._out.append(chosen)
        self._counted(item.count, self._blob(item.count, nested=chosen in item.nested_formats))

    def _repeat(self, item: Repeat) -> None:
        size = self._size(item.count, 4)
        if self._items <= 0:  # nested lists must stay bounded
            size = item.count.minimum
        self._items -= size
        self._pack(item.count.code, size)
        for _ in range(size):
            self._item(item.item)
