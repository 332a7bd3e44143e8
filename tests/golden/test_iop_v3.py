"""The services of IOP v3 and AEODRS: definitions are what the tables give, and a second transcription agrees."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from copy import deepcopy
from pathlib import Path

import pytest
from tools.iop_tables import golden
from tools.iop_tables.fields import xml_of
from tools.iop_tables.jsidl import SCHEMAS, Definitions
from tools.iop_tables.table import Message, Node, Table, TableError, read, read_all

from jauspy.ids import service_set
from jauspy.messages import registry
from jauspy.schema import load_builtin

HERE = Path(__file__).parent
SECOND = HERE / "iop_v3_second"
"""60 messages, transcribed again from the pages by a reader who had not seen the first tables."""

SAME_BYTES = {
    "ReportSeismicSensorStatus": "Intensity is shown as a variant amid plain fields: read as variable field or variant",
    "ReportMountSite": "a presence vector of a sequence covers plain fields, which belong to a record",
}
"""Messages that the pages leave open, read in two ways with the same bytes."""


@pytest.fixture(scope="module")
def tables() -> list[Table]:
    return read_all()


@pytest.fixture(scope="module")
def definitions(tables: list[Table]) -> Definitions:
    return Definitions(tables)


def content(message: Message) -> str:
    """All of a message that matters on the wire, units in the spelling of the definitions."""
    body = "" if message.body is None else xml_of(message.body).content()
    text = f"{message.code} {message.name} {message.is_input} {body}"
    return re.sub("degree [cC]elsius", "degree Celsius", text)


def second() -> list[tuple[str, Message]]:
    return [(path.name, message) for path in sorted(SECOND.glob("*.txt")) for message in read(path).messages]


def test_definitions_are_what_the_tables_give(tables: list[Table], definitions: Definitions) -> None:
    assert len(tables) == 47
    for table in tables:
        path = SCHEMAS / service_set(table.id) / table.version / f"{table.id.rpartition(':')[2]}.xml"
        assert definitions.service(table) == path.read_text("utf-8"), path


def test_types_of_the_sets_are_complete(definitions: Definitions) -> None:
    assert [name for name in ("core", "iop", "exp") if definitions.types_of(name)] == []


def test_rows_are_what_the_tables_give(tables: list[Table]) -> None:
    for set_name, (file, _) in golden.FILES.items():
        assert golden.text_of(tables, set_name) == (HERE / file).read_text("utf-8")


def test_second_transcription_agrees() -> None:
    found, other = 0, []
    for name, message in second():
        found += 1
        first = {known.name: known for known in read(golden_table(name)).messages}[message.name]
        other += [message.name] if content(first) != content(message) else []
    assert found == 60
    assert set(other) == set(SAME_BYTES)


def golden_table(name: str) -> Path:
    return Path(golden.__file__).parent / "services" / name


def test_what_is_read_in_two_ways_has_the_same_bytes() -> None:
    checked = set()
    for name, message in second():
        if message.name in SAME_BYTES:
            first = {known.name: known for known in read(golden_table(name)).messages}[message.name]
            assert extremes(first.body) == extremes(message.body)
            checked.add(message.name)
    assert checked == set(SAME_BYTES)


def extremes(body: Node | None) -> list[bytes]:
    assert body is not None
    kinds = (("min", "none"), ("mid", "all"), ("mid", "none"), ("max", "all"))
    return [golden.Maker(*kind).make(body, "")[1] for kind in kinds]


def test_every_service_of_the_tables_is_loaded(tables: list[Table]) -> None:
    loaded = {(service.id, service.version) for service in load_builtin().services}
    assert {(table.id, table.version) for table in tables} <= loaded


# --- mistakes in a table are found ----------------------------------------------------------------------------------


def all_nodes(node: Node) -> list[Node]:
    return [node, *(inner for child in node.children for inner in all_nodes(child))]


def mutable(tables: list[Table], wanted: Callable[[Node], bool]) -> list[tuple[Table, Message, Node]]:
    return [
        (table, message, node)
        for table in tables
        for message in table.messages
        if message.body is not None
        for node in all_nodes(message.body)
        if wanted(node)
    ]


def swap_children(node: Node) -> None:
    node.children[0], node.children[1] = node.children[1], node.children[0]


def widen(node: Node) -> None:
    assert node.scale is not None
    node.scale = node.scale[0], node.scale[1] * 2 + 1


def retype(node: Node) -> None:
    node.type = {"u8": "u16", "u16": "u32", "u32": "u16"}[node.type]


def swap_bits(node: Node) -> None:
    first, last = node.subfields[0], node.subfields[-1]
    first.first, first.last, last.first, last.last = last.first, last.last, first.first, first.last


def swappable_bits(node: Node) -> bool:
    """The first and last sub-field have the same width."""
    widths = [bits.last - bits.first for bits in node.subfields]
    return len(widths) > 1 and widths[0] == widths[-1]


def unlike(node: Node) -> bool:
    """Two elements whose order shows in the bytes."""
    if node.kind not in ("record", "sequence") or len(node.children) < 2:
        return False
    first, other = node.children[:2]
    return (first.type, first.scale, first.optional) != (other.type, other.scale, other.optional)


MUTANTS: dict[str, tuple[Callable[[Node], bool], Callable[[Node], None]]] = {
    "order": (unlike, swap_children),
    "limit": (lambda node: node.scale is not None, widen),
    "type": (lambda node: node.kind == "number" and node.type in ("u8", "u16", "u32"), retype),
    "bit": (swappable_bits, swap_bits),
}


@pytest.mark.parametrize("kind", MUTANTS)
def test_mutants_differ_from_the_definitions_and_from_the_rows(kind: str, tables: list[Table]) -> None:
    wanted, change = MUTANTS[kind]
    originals = {
        (table.name, message.name, message.code): content(message) for table in tables for message in table.messages
    }
    found = mutable(tables, wanted)[:: 1 if kind == "bit" else 10]
    assert len(found) > 10
    for table, message, node in found:
        bytes_before = {row["hex"] for row in golden.rows_of(table, message)}
        before = deepcopy(node)
        change(node)
        try:
            assert content(message) != originals[table.name, message.name, message.code], (message.name, node.name)
            rows = list(golden.rows_of(table, message))
            told = {row["hex"] for row in rows} != bytes_before or any(wrong(row) for row in rows)
            assert told, (message.name, node.name)
        finally:
            node.__dict__.update(before.__dict__)


def wrong(row: dict[str, object]) -> bool:
    """True if the codec gives other bytes for the values of a row."""
    from tests.golden import conftest as vectors

    parsed = vectors.parse(json.loads(json.dumps(row)))
    cls = vectors.find(registry, parsed)
    assert cls is not None
    try:
        return bool(vectors.to_ours(cls.layout(), parsed.values).encode() != parsed.right)
    except Exception:  # noqa: BLE001 - a value that the definition does not know is a difference, too
        return True


def test_swapped_ids_differ(tables: list[Table]) -> None:
    codes = {(table.name, message.name): int(message.code, 16) for table in tables for message in table.messages}
    ids = {(entry.service, entry.name): entry.code for entry in registry.entries}
    urns = {table.name: table.id for table in tables}
    assert all(ids[urns[service], name] == code for (service, name), code in codes.items())


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("input D701 A command\n  u9 X one\n", "u9"),
        ("input D701 A command\n  bits X u8\n    zero Y\n", "zero Y"),
        ("input D701 A command\n      u8 X one\n", "indented too far"),
        ("input D701 A command\n  u8 X one values\n    red\n", "red"),
        ("something else\n", "something else"),
        ("transitions\n  loop L\n    -> nowhere\n", "nowhere"),
        ("input\n", "IndexError"),
        ("input D701 A command\n  list X\n", "ValueError"),
    ],
)
def test_what_is_not_of_the_notation_is_named(text: str, problem: str, tmp_path: Path) -> None:
    path = tmp_path / "A.txt"
    path.write_text(text, "utf-8")
    with pytest.raises(TableError, match=re.escape(str(path))) as caught:
        read(path)
    assert problem in str(caught.value)
