"""Reads golden rows: JAUS names and raw values of an independent implementation, to and from ours."""

from __future__ import annotations

import json
import struct
import sys
from collections import defaultdict
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from itertools import groupby
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from jauspy.codec import declare as rt
from jauspy.codec.message import Message
from jauspy.codec.names import attribute
from jauspy.codec.registry import MessageEntry, Registry
from jauspy.messages import registry
from jauspy.schema import load_builtin, model as m

SHARED = Path(__file__).parents[2].parent / "shared" / "vectors"
COMMITTED = Path(__file__).parent


@dataclass(frozen=True)
class Row:
    """One golden row. `right` is the encoding of the real values, `theirs` what the other implementation sent."""

    set: str
    message: str
    code: int
    version: str
    case: str
    theirs: bytes
    right: bytes
    why: str
    values: Any

    def __str__(self) -> str:
        return f"{self.set} {self.message} {self.case}"

    @contextmanager
    def named(self) -> Iterator[None]:
        """Adds the row to what fails inside."""
        try:
            yield
        except Exception as error:
            error.add_note(f"row: {self}")
            raise


def rows(folder: Path) -> Iterator[Row]:
    """The rows of all files of a folder, scaling probes left out."""
    for file in sorted(folder.glob("*.jsonl")):
        if file.name != "scaling.jsonl":
            for line in file.read_text().splitlines():
                yield parse(json.loads(line))


def parse(row: dict[str, Any]) -> Row:
    """A row of its JSON form."""
    theirs = bytes.fromhex(row["hex"])
    # Fields that no presence bit speaks of cannot be decoded again, and the values of these rows do not have them.
    overflow = row.get("why") == "presence-vector-overflow"
    right = bytes.fromhex(row["hex"] if overflow else row.get("std_hex", row["hex"]))
    code = int(row["code"], 16)
    return Row(
        row["set"], row["message"], code, row["version"], row["case"], theirs, right, row.get("why", ""), row["values"]
    )


def find(registry: Registry, row: Row) -> type[Message] | None:
    """The message class of a row: its code, name and version, in its own service set if several have it."""
    family = row.set.split("-")[0].lower()
    same = _by_key(registry).get((row.code, row.message, row.version), [])
    own = [entry for entry in same if entry.module.split(".")[-3].replace("_", "") == family]
    return next((entry.load() for entry in own or same), None)


@cache
def _by_key(registry: Registry) -> dict[tuple[int, str, str], list[MessageEntry]]:
    found: dict[tuple[int, str, str], list[MessageEntry]] = defaultdict(list)
    for entry in registry.entries:
        found[entry.code, entry.name, entry.version].append(entry)
    return found


def to_ours(item: rt.Item, value: Any) -> Any:
    """A golden value as ours."""
    match item:
        case rt.Composite():
            return _composite(item, value)
        case rt.Number() | rt.Real():
            return _number(item, value)
        case rt.Bits():
            return item.cls(**{attribute(name): part for name, part in value.items()})
        case rt.Choice():
            number = _number(item.items[value["index"]], value["value"])
            return item.cls(choice=value["index"], value=number)  # type: ignore[call-arg]
        case rt.Formatted():
            return item.cls(format=value["format"], data=bytes.fromhex(value["hex"]))  # type: ignore[call-arg]
        case rt.Text():
            return value
        case rt.Blob():
            return bytes.fromhex(value["hex"])
        case rt.Repeat():
            return [to_ours(item.item, part) for part in value]
        case rt.Union():
            return to_ours(list(item.arms.values())[value["tag"]], value["value"])
        case rt.Grid():
            return [to_ours(item.item, part) for part in value]
        case _:
            raise TypeError(item)


def _number(item: rt.Item, value: Any) -> Any:
    return value["set"] if isinstance(value, dict) else value


def _composite(item: rt.Composite, value: Any) -> Any:
    if not item.slots:
        return item.cls()
    if isinstance(value, list) or (isinstance(value, dict) and {"tag", "arm"} <= set(value)):
        (slot,) = item.slots
        if not slot.jaus:  # an empty variant is a tag and nothing else
            return item.cls(tag=value["tag"])  # type: ignore[call-arg]
        return item.cls(**{slot.name: to_ours(slot.item, value)})
    slots = {slot.jaus: slot for slot in item.slots}
    return item.cls(**{slots[name].name: to_ours(slots[name].item, part) for name, part in value.items()})


def raw_of(item: rt.Item, ours: Any) -> Any:
    """Our value in a form that is equal for equal bytes: raw numbers, plain containers."""
    match item:
        case rt.Composite():
            parts = {slot.jaus: (slot.item, getattr(ours, slot.name)) for slot in item.slots}
            return {name: raw_of(inner, part) for name, (inner, part) in parts.items() if part is not None}
        case rt.Real():
            return round((ours - item.scaling.lower) * item.scaling.factor)
        case rt.Number(code="f"):
            return struct.pack("<f", ours)
        case rt.Bits():
            return {bit.name: int(getattr(ours, bit.name)) for bit in item.bits}
        case rt.Choice():
            return (int(ours.choice), raw_of(item.items[ours.choice], ours.value))
        case rt.Formatted():
            return (int(ours.format), ours.data.encode() if isinstance(ours.data, Message) else ours.data)
        case rt.Blob():
            return ours.encode() if isinstance(ours, Message) else ours
        case rt.Repeat() | rt.Grid():
            return [raw_of(item.item, part) for part in ours]
        case rt.Union():
            return (type(ours).__name__, raw_of(type(ours).layout(), ours))
        case _:
            return ours


def existing_rows(folder: Path) -> list[Row]:
    """The rows of messages that exist."""
    return [row for row in rows(folder) if find(registry, row) is not None]


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    if "rows" in metafunc.fixturenames:  # those of a set
        sets = groupby(existing_rows(COMMITTED), lambda row: row.set)
        metafunc.parametrize("rows", [pytest.param(list(found), id=name) for name, found in sets])


@pytest.fixture(scope="session")
def vectors() -> ModuleType:
    """The functions of this file."""
    return sys.modules[__name__]


@pytest.fixture(scope="session")
def models() -> dict[tuple[str, str, str], m.MessageDefinition]:
    """The model of every message by service, version and name."""
    services = load_builtin().services
    return {
        (service.id, service.version, message.name): message for service in services for message in service.messages
    }
