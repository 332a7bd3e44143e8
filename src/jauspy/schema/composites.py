"""Records, lists, sequences and variants."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping

from lxml.etree import _Element as Element

from jauspy.schema.document import DECLARED, child, flag, prose, required, wrong
from jauspy.schema.fields import read_field
from jauspy.schema.library import Scope
from jauspy.schema.model import Composite, List, Node, Record, Sequence, Unsigned, Variant
from jauspy.schema.values import BITS, read_count, unsigned

_AUXILIARY = frozenset(("presence_vector", "count_field", "vtag_field"))
_MAX_EMPTY_ARMS = 256


def read_composite(element: Element, scope: Scope) -> Composite:
    """A composite, written out or declared."""
    reader = _READERS.get(element.tag)
    return scope.declared(element, read_composite) if reader is None else reader(element, scope)


def read_content(part: Element, scope: Scope) -> Composite | None:
    """What a header, body or footer contains, itself written out or declared; None when it is empty."""
    if part.tag in DECLARED:
        home, found = scope.find(part)
        return read_content(found, home)
    for element in part:
        return read_composite(element, scope)
    return None


def _members(element: Element) -> list[Element]:
    return [part for part in element if part.tag not in _AUXILIARY]


def _record(element: Element, scope: Scope) -> Record:
    fields = tuple(read_field(member, scope) for member in _members(element))
    return Record(
        name=required(element, "name"),
        optional=flag(element, "optional"),
        doc=prose(element),
        fields=fields,
        presence=_presence(element, fields),
    )


def _sequence(element: Element, scope: Scope) -> Sequence:
    items = tuple(read_composite(member, scope) for member in _members(element))
    return Sequence(
        name=required(element, "name"),
        optional=flag(element, "optional"),
        doc=prose(element),
        items=items,
        presence=_presence(element, items),
    )


def _presence(element: Element, members: Iterable[Node]) -> Unsigned | None:
    """The presence vector of a container. One that is too small loads: public definitions have that."""
    _check_names(element, members)
    vector = element.find("presence_vector")
    if vector is not None:
        return unsigned(vector)
    for member, part in zip(members, _members(element), strict=True):
        if member.optional:
            raise wrong(part, f"'{member.name}' is optional, but '{element.get('name')}' has no <presence_vector>")
    return None


def _check_names(element: Element, members: Iterable[Node]) -> None:
    seen: set[str] = set()
    for member, part in zip(members, _members(element), strict=True):
        if member.name in seen:
            raise wrong(part, f"duplicate name '{member.name}' in '{element.get('name')}'")
        seen.add(member.name)


def _list(element: Element, scope: Scope) -> List:
    return List(
        name=required(element, "name"),
        optional=flag(element, "optional"),
        doc=prose(element),
        count=read_count(child(element, "count_field"), scope),
        element=read_composite(_members(element)[0], scope),
    )


def _variant(element: Element, scope: Scope) -> Variant:
    tag = read_count(child(element, "vtag_field"), scope)
    arms = tuple(read_composite(member, scope) for member in _members(element))
    _check_names(element, arms)
    if len(arms) > 2 ** BITS[tag.type]:
        raise wrong(element, f"{len(arms)} arms, but its tag knows only {2 ** BITS[tag.type]}; take a larger type")
    if not arms:  # a public definition has a variant that is a tag and nothing else
        arms = tuple(Record(name=f"Empty{index}", fields=()) for index in range(min(tag.maximum + 1, _MAX_EMPTY_ARMS)))
    return Variant(
        name=required(element, "name"), optional=flag(element, "optional"), doc=prose(element), tag=tag, arms=arms
    )


_READERS: Mapping[str, Callable[[Element, Scope], Composite]] = {
    "record": _record,
    "sequence": _sequence,
    "list": _list,
    "variant": _variant,
}
