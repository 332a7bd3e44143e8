"""Shared parts of the generated encoders and decoders: names, offsets, items of fixed size, value sets.

Source is made of fixed text, numbers and identifiers only. Whatever else the code needs (classes, packers, registries,
constants that are not finite) goes into its namespace as an object, so no text of a definition is ever executed.
"""

from __future__ import annotations

import math
import unicodedata
from collections.abc import Callable, Iterable
from enum import IntEnum
from functools import lru_cache
from itertools import accumulate
from keyword import iskeyword
from struct import Struct as Packer
from typing import Final

from jauspy.codec.items import Bits, Item, Number, Real, Text, Values
from jauspy.codec.layout import Composite, Grid, Slot
from jauspy.codec.message import Message, Reject
from jauspy.codec.names import unique
from jauspy.codec.scalars import FLOATS, SIZES, Scaling, compact, exact_raw, limits

MAX_CACHED_PACKERS: Final = 1024
"""Packers in one cache: a peer that sends all of 2**15 presence vectors must not fill the memory."""


class Masks(dict[int, Packer]):
    """The packers of a run of fields behind a presence vector, each made when its vector first occurs.

    Each code comes with its presence bit, 0 for fields that are always there; `head` are codes before the run.
    """

    def __init__(self, head: str, codes: tuple[tuple[int, str], ...]) -> None:
        super().__init__()
        self._head = head
        self._codes = codes

    def __missing__(self, mask: int) -> Packer:
        if len(self) >= MAX_CACHED_PACKERS:
            self.clear()
        present = "".join(code for bit, code in self._codes if not bit or mask & bit)
        made = self[mask] = packer(f"{self._head}{compact(present)}")
        return made


class Rows(dict[int, Packer]):
    """The packers of any count of one number, each made when its count first occurs."""

    def __init__(self, code: str) -> None:
        super().__init__()
        self._code = code

    def __missing__(self, count: int) -> Packer:
        if len(self) >= MAX_CACHED_PACKERS:
            self.clear()
        made = self[count] = Packer(f"<{count}{self._code}")
        return made


packer: Final = lru_cache(MAX_CACHED_PACKERS)(lambda codes: Packer(f"<{codes}"))
"""The little-endian packer of some codes, shared by all messages."""

rows: Final = lru_cache(len(SIZES))(Rows)
"""The packers of any count of one number, shared by all messages."""


def plain_bytes(value: object) -> bytes:
    """The bytes of a field that accepts bytes only."""
    if isinstance(value, (bytes, bytearray, memoryview)):
        return bytes(value)
    raise Reject


def message_bytes(value: object) -> bytes:
    """The bytes of a message, or bytes as they are."""
    return value._pack() if isinstance(value, Message) else plain_bytes(value)  # noqa: SLF001 - the fast path


class Namespace:
    """The globals of one generated function: every object that its source refers to, under a unique name."""

    def __init__(self) -> None:
        self.values: dict[str, object] = {
            "Reject": Reject,
            "exact_raw": exact_raw,
            "isfinite": math.isfinite,
            "message_bytes": message_bytes,
            "new": object.__new__,
            "plain_bytes": plain_bytes,
        }
        self._names: dict[object, str] = {}

    def _add(self, hint: str, key: object, make: Callable[[], object]) -> str:
        if key not in self._names:
            name = self._names[key] = identifier(unique(hint, self.values.__contains__))
            self.values[name] = make()
        return self._names[key]

    def packer(self, codes: Iterable[str]) -> str:
        """The name of a `struct.Struct`."""
        short = compact("".join(codes))
        return self._add(f"S_{short}", ("S", short), lambda: packer(short))

    def rows(self, code: str) -> str:
        """The packers of any count of one number."""
        return self._add(f"L_{code}", ("L", code), lambda: rows(code))

    def masks(self, head: str, codes: Iterable[tuple[int, str]]) -> str:
        """The packers of a run of optional fields."""
        key = tuple(codes)
        return self._add("M", ("M", head, key), lambda: Masks(head, key))

    def members(self, enum: type[IntEnum]) -> str:
        """The members of an enumeration by value; looking them up costs less than a call of the class."""
        return self._add(f"E_{enum.__name__}", enum, lambda: enum._value2member_map_)

    def cls(self, cls: type) -> str:
        """The name of a class."""
        return self._add(f"C_{cls.__name__}", ("C", cls), lambda: cls)

    def arms(self, classes: Iterable[type]) -> str:
        """The classes of a variant in the order of their tags."""
        listed = tuple(classes)
        return self._add("U", ("U", listed), lambda: listed)

    def tags(self, classes: Iterable[type]) -> str:
        """The inverse of `arms`."""
        listed = tuple(classes)
        return self._add("T", ("T", listed), lambda: {cls: tag for tag, cls in enumerate(listed)})

    def scaling(self, scaling: Scaling) -> str:
        """The name of a scale range."""
        return self._add("R", scaling, lambda: scaling)

    def indices(self, numbers: frozenset[int]) -> str:
        """The name of a set of numbers."""
        return self._add("F", numbers, lambda: numbers)

    def source(self, source: object) -> str:
        """The source that decodes the messages inside a field."""
        return self._add("K", ("K", id(source)), lambda: source)

    def number(self, value: float) -> str:
        """A number as a literal; infinity and NaN by reference."""
        if type(value) in (int, float) and math.isfinite(value):
            return repr(value)
        return self._add("V", ("V", repr(value)), lambda: value)


def identifier(name: str) -> str:
    """Return a name that is safe in source. Raises `ValueError` unless it is an identifier in normal form."""
    if not name.isidentifier() or iskeyword(name) or unicodedata.normalize("NFKC", name) != name:
        raise ValueError(f"{name!r} is not an identifier")
    return name


def member(owner: str, name: str) -> str:
    """An attribute of a variable, as source."""
    return f"{owner}.{identifier(name)}"


class Locals:
    """Names of local variables, each given once; they end in an underscore."""

    def __init__(self) -> None:
        self._taken: set[str] = set()

    def name(self, hint: str) -> str:
        """A new name similar to `hint`."""
        found = unique(hint, self._taken.__contains__)
        self._taken.add(found)
        return identifier(f"{found}_")


class Position:
    """A variable plus a number of bytes that is known when the code is generated."""

    def __init__(self, base: str, offset: int) -> None:
        self._base = base
        self._offset = offset

    def here(self, more: int = 0) -> str:
        """The position as an expression, or that of `more` bytes later."""
        offset = self._offset + more
        if not self._base:
            return str(offset)
        return f"{self._base} + {offset}" if offset else self._base

    def parenthesized(self) -> str:
        """Expression of `here` in parentheses, for use after a minus sign."""
        return f"({self.here()})" if self._base and self._offset else self.here()

    def skip(self, size: int) -> None:
        """Advance by a known number of bytes."""
        self._offset += size

    def move(self, base: str) -> None:
        """Continue at the offset in a variable."""
        self._base, self._offset = base, 0

    def settled(self) -> None:
        """Note that the variable `at` has the position."""
        self.move("at")

    def settle(self) -> list[str]:
        """Lines that bring the position into the variable `at`, as loops, branches and calls need it."""
        position, moved = self.here(), self._base != "at"
        lines = [f"at = {position}"] if moved else [f"at += {self._offset}"] if self._offset else []
        self.settled()
        return lines


def indent(lines: Iterable[str], levels: int = 1) -> list[str]:
    """The lines, moved right; empty ones stay empty."""
    return ["    " * levels + line if line else line for line in lines]


def reject_if(condition: str) -> list[str]:
    """The line that raises `Reject` on a condition."""
    return [f"if {condition}: raise Reject"]


def count_checks(number: str, low: int, high: int, code: str) -> list[str]:
    """The line that raises `Reject` unless a count is within its limits; none if every value is."""
    parts = [f"{number} < {int(low)}"] if low else []
    parts += [f"{number} > {int(high)}"] if high < limits(code)[1] else []
    return reject_if(" or ".join(parts)) if parts else []


def fixed_codes(item: Item) -> list[str] | None:
    """The `struct` codes of an item of fixed size, `None` for others."""
    match item:
        case Number() | Real() | Bits():
            return [item.code]
        case Text(count=None):
            return [f"{item.length}s"] if item.length else None
        case Composite(presence=None):
            codes: list[str] = []
            for slot in item.slots:
                found = fixed_codes(slot.item)
                if found is None:
                    return None
                codes += found
            return codes
        case _:
            return None


def size_of(codes: Iterable[str]) -> int:
    """Bytes of some codes."""
    return sum(int(code[:-1]) if code[0].isdigit() else SIZES[code] for code in codes)


Run = list[Slot]
"""Consecutive slots of a composite."""


def runs(slots: Iterable[Slot]) -> list[tuple[Run, bool]]:
    """Groups of consecutive slots of fixed size (with True), and every other slot alone, as optional composites."""
    made: list[tuple[Run, bool]] = []
    for slot in slots:
        codes = fixed_codes(slot.item)
        fixed = codes is not None and (not slot.optional or len(codes) == 1)
        if fixed and made and made[-1][1]:
            made[-1][0].append(slot)
        else:
            made.append(([slot], fixed))
    return made


def presence_bits(composite: Composite) -> dict[str, int]:
    """The presence bit of each optional slot; 0 if the vector has too few bits."""
    highest = limits(composite.presence)[1] if composite.presence else 0
    optional = [slot.name for slot in composite.slots if slot.optional]
    return {name: 1 << number if 1 << number <= highest else 0 for number, name in enumerate(optional)}


def run_masks(namespace: Namespace, head: str, run: Iterable[Slot], bits: dict[str, int]) -> str:
    """The packers of a run of optional fields; those without a presence bit are never there."""
    present = [slot for slot in run if bits.get(slot.name) != 0]
    codes = [(bits.get(slot.name, 0), code) for slot in present for code in fixed_codes(slot.item) or []]
    return namespace.masks(head, codes)


def is_one_run(composite: Composite) -> bool:
    """True for numbers behind a presence vector, with nothing between them."""
    found = runs(composite.slots)
    return composite.presence is not None and len(found) == 1 and found[0][1]


def covers(values: Values, low: float, high: float) -> bool:
    """True if every value from `low` to `high` is allowed."""
    if values.anything:
        return True
    named = [(int(one), int(one)) for one in values.enum] if values.enum else []
    reached = low - 1
    for start, end in sorted([*named, *values.intervals]):
        if start > reached + 1:
            return False
        reached = max(reached, end)
    return reached >= high


def outside(values: Values, name: str, namespace: Namespace, low: float = -math.inf, high: float = math.inf) -> str:
    """A condition that is true when `name`, known to be within `low`..`high`, is not allowed."""
    parts = [f"{name} not in {namespace.members(values.enum)}"] if values.enum else []
    for start, end in values.intervals:
        first, last = namespace.number(start), namespace.number(end)
        if start <= low or end >= high:
            parts.append(f"{name} > {last}" if start <= low else f"{name} < {first}")
        else:
            parts.append(f"not {first} <= {name} <= {last}")
    return " and ".join(parts)


def free(number: Number | Real) -> bool:
    """True if any raw value is allowed."""
    if isinstance(number, Real):
        return number.code.isupper()
    return number.code not in FLOATS and covers(number.values, *limits(number.code))


def is_plain(grid: Grid) -> bool:
    """True for arrays of any floats, or of integers without restrictions."""
    number = grid.item
    return isinstance(number, Number) and number.values.anything and (number.code in FLOATS or free(number))


def grid_codes(grid: Grid) -> list[str]:
    """The `struct` codes of all elements of a plain array."""
    return (fixed_codes(grid.item) or []) * math.prod(grid.sizes)


def finite(grid: Grid, raw: str) -> list[str]:
    """Lines that reject infinities and NaN; a sum of values preserves them."""
    return reject_if(f"not isfinite(sum({raw}))") if (fixed_codes(grid.item) or [""])[0] in FLOATS else []


def grid_values(grid: Grid, raw: str, target: str) -> list[str]:
    """Lines that make lists in lists of the tuple `raw`."""
    widths = list(accumulate(reversed(grid.sizes[1:]), lambda width, size: width * size))
    value = f"list({raw})"
    if widths:
        value = f"list({raw}[n0:n0 + {widths[0]}])"
        whole = [*widths[1:], math.prod(grid.sizes)]
        for depth, (width, total) in enumerate(zip(widths, whole, strict=True)):
            last = depth == len(widths) - 1
            start, end = ("0", str(total)) if last else (f"n{depth + 1}", f"n{depth + 1} + {total}")
            value = f"[{value} for n{depth} in range({start}, {end}, {width})]"
    return [*finite(grid, raw), f"{target} = {value}"]


def inner_grid(grid: Grid) -> Item:
    """The item that the first dimension of an array repeats."""
    return Grid(grid.item, grid.sizes[1:]) if len(grid.sizes) > 1 else grid.item


def scaled(scaling: Scaling, raw: str, namespace: Namespace) -> str:
    """The real of a raw value that is not the highest one, or of any where the top of the range comes out exactly."""
    if scaling.is_finer_than_floats:
        return f"{namespace.scaling(scaling)}.real({raw})"
    step = f"{raw} * {namespace.number(scaling.step)}"
    return f"{namespace.number(scaling.lower)} + {step}" if scaling.lower else step


def keywords_only(slots: Iterable[Slot]) -> bool:
    """True if a required attribute follows an optional one, so that arguments must be given by keyword."""
    seen = False
    for slot in slots:
        if seen and not slot.optional:
            return True
        seen = seen or slot.optional
    return False
