"""Service definitions (JSIDL 1.1) from message tables, in the style of `schemas/README.md`.

Records, bit fields and named values that occur again become declared types: of the service if it alone has them, else
of the set. Types that a set of `schemas/` has already are used.
"""

from __future__ import annotations

from collections import defaultdict
from pathlib import Path

from lxml import etree

from jauspy.ids import service_set

from .behavior import behavior
from .fields import sentence_of, xml_of
from .shared_types import SCHEMAS, SETS, KnownTypes, Use, is_shared_kind
from .table import Message, Table
from .xml_text import Xml


class Definitions:
    """The definitions of all tables together."""

    def __init__(self, tables: list[Table]) -> None:
        self._tables = tables
        self._known = KnownTypes()
        self._bodies = {(t.name, m.name): xml_of(m.body) for t in tables for m in t.messages if m.body is not None}
        self._uses: dict[tuple[str, str], Use] = {}
        for (service, message), body in self._bodies.items():
            self._collect(body, service, message)
        self._names: dict[tuple[str, str], tuple[str, str]] = {}
        """Set (or `service Name`) and declared name of each shared type."""
        self._taken: dict[str, set[str]] = defaultdict(
            set, {name: set(names) for name, names in self._known.names.items()}
        )
        self._shared: dict[str, list[Xml]] = defaultdict(list)
        for key, use in self._uses.items():
            self._place(key, use)

    def _collect(self, xml: Xml, service: str, message: str) -> None:
        if is_shared_kind(xml):
            use = self._uses.setdefault((xml.tag, xml.content()), Use(xml))
            use.services.append(service)
            use.owners.append(message)
        for child in xml.children:
            self._collect(child, service, message)

    def _place(self, key: tuple[str, str], use: Use) -> None:
        known = self._known.find(use.xml)
        if known is not None:
            self._names[key] = known
            return
        if len(use.services) < 2:
            return
        sets = {service_set(table.id) for table in self._tables if table.name in use.services}
        several = len(set(use.services)) > 1
        place = min(sets, key=SETS.index) if several else f"service {use.services[0]}"
        name = use.xml.attributes["name"]
        if name in self._taken[place]:
            name = f"{use.services[0] if several else use.owners[0]}{name}"
        self._taken[place].add(name)
        self._names[key] = (place, name)
        self._shared[place].append(use.xml)

    def types_of(self, set_name: str) -> list[Xml]:
        """New types of a set, with references to others."""
        return self._declarations(set_name, set_name)

    def _declarations(self, place: str, set_name: str) -> list[Xml]:
        found = []
        for xml in self._shared[place]:
            name = self._names[xml.tag, xml.content()][1]
            doc = xml.attributes.get("interpretation") or sentence_of(xml.attributes["name"])
            attributes = {
                "name": name,
                **{k: v for k, v in xml.attributes.items() if k not in ("name", "optional", "interpretation")},
            }
            inner = [self._with_references(child, set_name, set()) for child in xml.children]
            found.append(Xml(xml.tag, {**attributes, "optional": "false", "interpretation": doc}, inner))
        return sorted(found, key=lambda xml: xml.attributes["name"])

    def _with_references(self, xml: Xml, set_name: str, used: set[str]) -> Xml:
        """The element, its shared parts by reference; `used` receives the sets that they are of."""
        declared = self._names.get((xml.tag, xml.content())) if is_shared_kind(xml) else None
        if declared is None:
            return Xml(
                xml.tag,
                xml.attributes,
                [self._with_references(child, set_name, used) for child in xml.children],
                xml.text,
            )
        place, name = declared
        local = place.startswith("service ") or place == set_name
        if not place.startswith("service "):
            used.add(place)
        attributes = {
            "name": xml.attributes["name"],
            "declared_type_ref": name if local else f"{place}.{name}",
            "optional": xml.attributes["optional"],
        }
        doc = xml.attributes.get("interpretation", "")
        if doc and doc != self._uses[xml.tag, xml.content()].xml.attributes.get("interpretation"):
            attributes["interpretation"] = doc
        return Xml(f"declared_{xml.tag}", attributes)

    def service(self, table: Table) -> str:
        """The definition of one service, as text."""
        used: set[str] = {"core"}
        inputs = [self._message(table, message, used) for message in table.messages if message.is_input]
        outputs = [self._message(table, message, used) for message in table.messages if not message.is_input]
        types = self._declarations_in_service(table, used)
        order = [name for name in SETS if name in used]
        references = [
            Xml("declared_type_set_ref", {"name": name, "id": f"urn:jauspy:{name}:Types", "version": "1.0"})
            for name in order
        ]
        name = table.id.rpartition(":")[2]
        parent, version = table.inherits
        reference, parent_id, parent_path = parent_of(parent, version)
        attributes = {"xmlns": "urn:jaus:jsidl:1.1", "name": name, "id": table.id, "version": table.version}
        root = Xml(
            "service_def",
            attributes,
            [
                Xml("description", text=table.doc),
                Xml("assumptions", text=table.assumptions or f"Those of {parent}."),
                Xml("references", {}, [Xml("inherits_from", {"name": reference, "id": parent_id, "version": version})]),
                Xml("declared_type_set", {"name": "types"}, [*references, *types]) if table.messages else Xml("skip"),
                Xml("message_set", {}, [Xml("input_set", {}, inputs), Xml("output_set", {}, outputs)]),
                Xml("internal_events_set", {}, [_event(*event) for event in table.events]),
                behavior(table, reference, parent_path),
            ],
        )
        root.children = [child for child in root.children if child.tag != "skip"]
        return "\n".join(['<?xml version="1.0" encoding="UTF-8"?>', *root.lines()]) + "\n"

    def _declarations_in_service(self, table: Table, used: set[str]) -> list[Xml]:
        found = self._declarations(f"service {table.name}", "")
        for xml in self._shared[f"service {table.name}"]:
            for child in xml.children:
                self._with_references(child, "", used)
        return found

    def _message(self, table: Table, message: Message, used: set[str]) -> Xml:
        body = Xml("body", {"name": "Body"})
        if message.body is not None:
            body.children.append(self._with_references(self._bodies[table.name, message.name], "", used))
        is_command = "true" if message.kind == "command" else "false"
        header = Xml("declared_header", {"name": "MsgHeader", "declared_type_ref": "core.MsgHeader"})
        return Xml(
            "message_def",
            {"name": message.name, "message_id": message.code, "is_command": is_command},
            [Xml("description", text=message.doc), header, body, Xml("footer", {"name": "Footer"})],
        )


def _event(name: str, doc: str) -> Xml:
    parts = [
        Xml("description", text=doc),
        Xml("header", {"name": "Header"}),
        Xml("body", {"name": "Body"}),
        Xml("footer", {"name": "Footer"}),
    ]
    return Xml("event_def", {"name": name}, parts)


def parent_of(name: str, version: str) -> tuple[str, str, Path]:
    """Name of the reference, id and file of an ancestor."""
    for path in sorted(SCHEMAS.glob(f"*/{version}/{name}.xml")):
        identifier = etree.parse(path).getroot().get("id")
        return name[:1].lower() + name[1:], str(identifier), path
    raise LookupError(f"{name} {version} is not in {SCHEMAS}")


def write(tables: list[Table]) -> list[Path]:
    """Write all definitions and the new types of their sets; the files that changed."""
    definitions = Definitions(tables)
    changed = []
    for set_name in SETS:
        types = definitions.types_of(set_name)
        if types:
            path = SCHEMAS / set_name / "types.xml"
            path.write_text(_with_types(path.read_text("utf-8"), types), "utf-8")
            changed.append(path)
    names = {table.id.rpartition(":")[2] for table in tables}
    for table in sorted(tables, key=lambda table: table.inherits[0] in names):  # ancestors first
        path = SCHEMAS / service_set(table.id) / table.version / f"{table.id.rpartition(':')[2]}.xml"
        path.parent.mkdir(parents=True, exist_ok=True)
        text = definitions.service(table)
        if not path.exists() or path.read_text("utf-8") != text:
            path.write_text(text, "utf-8")
            changed.append(path)
    return changed


def _with_types(text: str, types: list[Xml]) -> str:
    """The type set with more types, before its messages."""
    lines = [line for xml in types for line in xml.lines(1)]
    position = text.find("  <message_def ")
    end = position if position >= 0 else text.index("</declared_type_set>")
    return f"{text[:end]}{chr(10).join(lines)}\n{text[end:]}"
