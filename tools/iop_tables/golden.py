"""Golden rows of the messages of all tables: values and bytes, made by `struct` and exact fractions alone.

Nothing of jauspy's codec or of the definitions takes part, so that a row which the codec does not read shows a mistake
of one of them. Rows have the form of the others in `tests/golden/`.
"""

from __future__ import annotations

import json
import random
import string
import struct
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path
from typing import Any, Final

from .table import Bits, Message, NamedRange, Node, Table

FOLDER: Final = Path(__file__).parents[2] / "tests" / "golden"
FILES: Final = {"iop": ("iop_v3.jsonl", "iop-v3"), "exp": ("aeodrs.jsonl", "exp-aeodrs")}
"""File and name of the set of rows, by the set in a service's URN."""
FORMATS: Final = {"i8": "b", "u8": "B", "i16": "h", "u16": "H", "i32": "i", "u32": "I", "i64": "q", "u64": "Q",
                  "f32": "f", "f64": "d"}  # fmt: skip
BITS: Final = {kind: 8 * struct.calcsize(f"<{code}") for kind, code in FORMATS.items()}
FLOATS: Final = {"min": -1.5, "mid": 0.0, "max": 1024.25}
"""Values of floats without limits; all are exact in four bytes."""
LENGTHS: Final = {"min": 0, "mid": 5, "max": 12}
"""Characters or bytes of what has a length of its own."""
RANDOM_ROWS: Final = 3
SEED: Final = 30

Made = tuple[Any, bytes]
"""A value in the form of rows, and its bytes."""
Forced = Mapping[str, Any]
"""What is chosen at a path: presence, number of elements, arm, choice, length or sub-field."""


def pack(kind: str, value: float) -> bytes:
    """A number, little-endian."""
    return struct.pack(f"<{FORMATS[kind]}", value)


def largest(kind: str) -> int:
    """The greatest value of an integer."""
    return int(2 ** (BITS[kind] - kind.startswith("i")) - 1)


def smallest(kind: str) -> int:
    """The least value of an integer."""
    return -largest(kind) - 1 if kind.startswith("i") else 0


def rounded(value: Fraction) -> int:
    """The nearest integer, halves upwards."""
    return int((value * 2 + 1) // 2)


@dataclass
class Maker:
    """Makes values of one kind: all least, middle, greatest or random ones."""

    mode: str
    optional: str = "none"
    """Which optional parts there are: all, none or random ones."""
    forced: Forced = field(default_factory=dict)
    chance: random.Random = field(default_factory=lambda: random.Random(SEED))  # noqa: S311 - values of rows

    def make(self, node: Node, path: str) -> Made:
        """A composite or field."""
        match node.kind:
            case "record" | "sequence":
                return self._composite(node, path)
            case "list":
                return self._list(node, path)
            case "variant":
                return self._variant(node, path)
            case "bits":
                return self._bits(node, path)
            case "string":
                text = "".join(self.chance.choices(string.ascii_letters + string.digits, k=self._length(path)))
                return text, pack(node.type, len(text)) + text.encode("ascii")
            case "blob":
                return self._blob(node, path)
            case "array":
                made = [self._number(node) for _ in range(node.length)]
                return [value for value, _ in made], b"".join(data for _, data in made)
            case "variable":
                choice = node.choices[self._which(path, len(node.choices))]
                value, data = self._number(choice)
                return {"index": choice.index, "value": value}, pack("u8", choice.index) + data
            case "number":
                return self._number(node)
        raise TypeError(f"{path}: no rows are made of {node.kind}")

    def _composite(self, node: Node, path: str) -> Made:
        values, parts, mask, bit = {}, [], 0, 0
        for child in node.children:
            inner = f"{path}/{child.name}"
            if child.optional:
                here = self._is_present(inner)
                mask |= here << bit
                bit += 1
                if not here:
                    continue
            values[child.name], data = self.make(child, inner)
            parts.append(data)
        vector = pack(node.presence, mask) if node.presence else b""
        return values, vector + b"".join(parts)

    def _list(self, node: Node, path: str) -> Made:
        count = {"max": 2, "random": self.chance.randint(0, 2)}.get(self.mode, int(self.optional == "all"))
        count = self.forced.get(path, count)
        (element,) = node.children
        made = [self.make(element, f"{path}[]") for _ in range(count)]
        return [value for value, _ in made], pack(node.type, count) + b"".join(data for _, data in made)

    def _variant(self, node: Node, path: str) -> Made:
        if not node.children:  # a tag and nothing else
            return {"tag": 0, "arm": "", "value": {}}, pack(node.type, 0)
        arm = node.children[self._which(path, len(node.children))]
        value, data = self.make(arm, f"{path}/{arm.name}")
        return {"tag": arm.index, "arm": arm.name, "value": value}, pack(node.type, arm.index) + data

    def _bits(self, node: Node, path: str) -> Made:
        values, raw = {}, 0
        for bits in node.subfields:
            value = self._subfield(bits, self.forced.get(path))
            values[bits.name] = value
            raw |= value << bits.first
        return values, pack(node.type, raw)

    def _subfield(self, bits: Bits, hot: str | None) -> int:
        most = int(2 ** (bits.last - bits.first + 1) - 1)
        ranges = [NamedRange(r.low, min(r.high, most)) for r in bits.values] or [NamedRange(0, most)]
        return self._one_of(ranges, mode=None if hot is None else "max" if hot == bits.name else "min")

    def _blob(self, node: Node, path: str) -> Made:
        data = self.chance.randbytes(self._length(path))
        counted = pack(node.type, len(data)) + data
        if not node.formats:
            return {"hex": data.hex()}, counted
        form = node.formats[self._which(path, len(node.formats))].low
        return {"format": form, "hex": data.hex()}, pack("u8", form) + counted

    def _number(self, node: Node) -> Made:
        if node.scale is not None:
            return self._scaled(node.type, node.scale)
        if node.type.startswith("f"):
            value = FLOATS[self.mode] if self.mode in FLOATS else self.chance.randint(-4000, 4000) / 16
            return value, pack(node.type, value)
        ranges = node.values or [NamedRange(smallest(node.type), largest(node.type))]
        number = self._one_of(ranges)
        return number, pack(node.type, number)

    def _scaled(self, kind: str, scale: tuple[float, float]) -> Made:
        """A raw value from 0 to the greatest one, for `LOW + raw * (HIGH - LOW) / greatest`."""
        low, high, top = Fraction(scale[0]), Fraction(scale[1]), largest(kind)
        raw = self._one_of([NamedRange(0, top)])
        real = float(low + raw * (high - low) / top)
        raw = rounded((Fraction(real) - low) * top / (high - low))  # eight bytes have more raw values than a float
        return {"raw": raw, "real": real, "set": real}, pack(kind, raw)

    def _one_of(self, ranges: list[NamedRange], mode: str | None = None) -> int:
        match mode or self.mode:
            case "min":
                return min(r.low for r in ranges)
            case "max":
                return max(r.high for r in ranges)
            case "mid":
                middle = ranges[len(ranges) // 2]
                return (middle.low + middle.high) // 2
        chosen = self.chance.choice(ranges)
        return self.chance.randint(chosen.low, chosen.high)

    def _is_present(self, path: str) -> bool:
        if path in self.forced:
            return True
        return self.optional == "all" or (self.optional == "random" and self.chance.random() < 0.5)

    def _which(self, path: str, count: int) -> int:
        if path in self.forced:
            return int(self.forced[path])
        return {"max": count - 1, "random": self.chance.randrange(count)}.get(self.mode, 0)

    def _length(self, path: str) -> int:
        if path in self.forced and isinstance(self.forced[path], int):
            return int(self.forced[path])
        return LENGTHS.get(self.mode) if self.mode in LENGTHS else self.chance.randint(0, 16)  # type: ignore[return-value]


def special_cases(node: Node, path: str, forced: Forced) -> Iterator[tuple[str, Forced, str]]:
    """Name, choices and kind of values of a row for each optional part, length, arm, choice and sub-field."""
    name = path.removeprefix("/")
    match node.kind:
        case "list":
            for count in (0, 1, 2):
                yield f"{name} len={count}", {**forced, path: count}, "mid"
            yield from special_cases(node.children[0], f"{path}[]", {**forced, path: 1})
        case "variant":
            for number, arm in enumerate(node.children):
                chosen = {**forced, path: number}
                yield f"{name} tag={arm.index}", chosen, "mid"
                yield from special_cases(arm, f"{path}/{arm.name}", chosen)
        case "record" | "sequence":
            for child in node.children:
                inner = f"{path}/{child.name}"
                chosen = {**forced, inner: True} if child.optional else dict(forced)
                if child.optional:
                    yield f"{name} only={child.name}", chosen, "mid"
                yield from special_cases(child, inner, chosen)
        case "bits":
            for bits in node.subfields:
                yield f"{name} hot={bits.name}", {**forced, path: bits.name}, "min"
        case "variable":
            for number, choice in enumerate(node.choices):
                yield f"{name} index={choice.index}", {**forced, path: number}, "mid"
        case "string" | "blob":
            for length in (0, 2):
                yield f"{name} len={length}", {**forced, path: length}, "mid"


def rows_of(table: Table, message: Message) -> Iterator[dict[str, Any]]:
    """The rows of a message, without those that have the bytes of an earlier one."""
    common = {
        "set": FILES[set_of(table)][1],
        "message": message.name,
        "code": message.code,
        "version": table.version,
    }
    code = pack("u16", int(message.code, 16))
    if message.body is None:
        yield {**common, "case": "empty", "hex": code.hex(), "values": None}
        return
    seen = set()
    for case, maker in _makers(f"{table.name} {message.name}", message.body):
        values, data = maker.make(message.body, f"/{message.body.name}")
        if data not in seen:
            seen.add(data)
            yield {**common, "case": case, "hex": (code + data).hex(), "values": values}


def _makers(name: str, body: Node) -> Iterator[tuple[str, Maker]]:
    chance = random.Random(f"{SEED} {name}")  # noqa: S311 - values of rows
    for mode, optional in (("min", "none"), ("max", "all"), ("mid", "all"), ("mid", "none")):
        yield f"{mode}-{'absent' if optional == 'none' else optional}", Maker(mode, optional, chance=chance)
    for number in range(RANDOM_ROWS):
        yield f"rand{number}", Maker("random", "random", chance=chance)
    for case, forced, mode in special_cases(body, f"/{body.name}", {}):
        yield case, Maker(mode, "none", forced, chance)


def set_of(table: Table) -> str:
    """The set in the URN of a service."""
    return table.id.split(":")[3]


def text_of(tables: list[Table], set_name: str) -> str:
    """The file of a set."""
    found = [
        row
        for table in tables
        if set_of(table) == set_name
        for message in table.messages
        for row in rows_of(table, message)
    ]
    return "".join(json.dumps(row, separators=(",", ":")) + "\n" for row in found)


def write(tables: list[Table]) -> list[Path]:
    """Write the rows; the files that changed."""
    changed = []
    for set_name, (file, _) in FILES.items():
        path, text = FOLDER / file, text_of(tables, set_name)
        if not path.exists() or path.read_text("utf-8") != text:
            path.write_text(text, "utf-8")
            changed.append(path)
    return changed
