"""Declared types: what the sets in `schemas/` have already, and what is written once."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass, field
from pathlib import Path

from lxml import etree

from .xml_text import Xml

SCHEMAS = Path(__file__).parents[2] / "schemas"
SETS = ("core", "mobility", "environmentSensing", "manipulator", "ugv", "iop", "exp")
"""Sets whose types are used, those that are needed by others first."""

SHARED = frozenset({"record", "bit_field", "variable_field", "array", "fixed_field"})


def is_shared_kind(xml: Xml) -> bool:
    """True for what is written once: not a record of one part, not a number without named values."""
    match xml.tag:
        case "fixed_field":
            return any(
                part.tag == "value_set" and any(v.tag == "value_enum" for v in part.children) for part in xml.children
            )
        case "record":
            inside = [part for part in xml.children if part.tag != "presence_vector"]
            return len(inside) > 1
        case "bit_field" | "variable_field" | "array":
            return True
    return False


class KnownTypes:
    """The declared types of the sets in `schemas/`, by what they are on the wire."""

    def __init__(self) -> None:
        self.names: dict[str, set[str]] = {}
        self._found: dict[tuple[str, str], list[tuple[str, str]]] = defaultdict(list)
        self._elements: dict[tuple[str, str], etree._Element] = {}
        for name in SETS:
            path = SCHEMAS / name / "types.xml"
            self.names[name] = set()
            if not path.exists():
                continue
            for element in etree.parse(path).getroot():
                if isinstance(element.tag, str) and (declared := element.get("name")):
                    self.names[name].add(declared)
                    self._elements[name, declared] = element
        for (set_name, declared), element in self._elements.items():
            xml = self._read(element, set_name)
            if xml.tag in SHARED:
                self._found[xml.tag, xml.unnamed()].append((set_name, declared))

    def find(self, xml: Xml) -> tuple[str, str] | None:
        """Set and name of the same type, which may have the name of a service in front of its own there."""
        found = self._found.get((xml.tag, xml.unnamed()), [])
        return next((place for place in found if place[1].endswith(xml.attributes["name"])), None)

    def _read(self, element: etree._Element, set_name: str) -> Xml:
        """An element without references to other types."""
        tag = etree.QName(element).localname
        attributes = {str(k): str(v) for k, v in element.attrib.items()}
        reference = attributes.pop("declared_type_ref", "")
        if reference:
            owner, _, name = reference.rpartition(".")
            target = self._elements.get((owner or set_name, name))
            if target is not None:
                expanded = self._read(target, owner or set_name)
                return Xml(expanded.tag, {**expanded.attributes, **attributes}, expanded.children)
        children = [self._read(child, set_name) for child in element.iterchildren(tag=etree.Element)]
        return Xml(tag, attributes, children)


@dataclass
class Use:
    """A type that occurs in tables: where, and the first way that it is written."""

    xml: Xml
    services: list[str] = field(default_factory=list)
    owners: list[str] = field(default_factory=list)
