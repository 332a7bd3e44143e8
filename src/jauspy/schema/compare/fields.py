"""Differences of two message bodies, field by field."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from jauspy.schema import model as m
from jauspy.schema.compare.change import Change
from jauspy.schema.wire import shape, value_shape

Changes = Iterator[Change]


def compare_bodies(one: m.Composite | None, other: m.Composite | None) -> Changes:
    """From `one` to `other`; the name of a body's outermost composite says nothing and is ignored."""
    if one is None or other is None:
        if one is not other:
            yield Change("wire", "", "has fields now" if one is None else "has no fields any more")
        return
    yield from _compare(one, other, "")


def _compare(one: m.Node, other: m.Node, path: str) -> Changes:
    match one, other:
        case m.Record() | m.Sequence(), m.Record() | m.Sequence():
            yield from _differ(one.presence, other.presence, "presence vector", path)
            yield from _members(_inside(one), _inside(other), path)
        case m.FixedField(), m.FixedField():
            yield from _number(one, other, path)
        case m.BitField(), m.BitField():
            yield from _differ(one.type, other.type, "type", path)
            yield from _bits(one, other, path)
        case m.VariableField(), m.VariableField():
            yield from _choices(one, other, path)
        case m.List(), m.List():
            yield from _differ(_count(one.count), _count(other.count), "count", path)
            yield from _compare(one.element, other.element, _join(path, one.element.name))
        case m.Variant(), m.Variant():
            yield from _differ(one.tag.type, other.tag.type, "tag", path)
            yield from _arms(one, other, path)
        case m.Array(), m.Array():
            yield from _differ(_sizes(one), _sizes(other), "dimensions", path)
            yield from _compare(one.element, other.element, path)
        case _ if type(one) is type(other):
            if shape(one) != shape(other):
                yield Change("wire", path, f"{_brief(one)} -> {_brief(other)}")
        case _:
            yield Change("wire", path, f"{_kind(one)} -> {_kind(other)}")


def _inside(node: m.Record | m.Sequence) -> Sequence[m.Node]:
    return node.fields if isinstance(node, m.Record) else node.items


def _join(path: str, name: str) -> str:
    return f"{path}.{name}" if path else name


def _differ(one: object, other: object, what: str, path: str) -> Changes:
    if one != other:
        yield Change("wire", path, f"{what} {_or_none(one)} -> {_or_none(other)}")


def _or_none(value: object) -> object:
    return "none" if value is None or value == "" else value


# --- members of a container -----------------------------------------------------------------------------------------


def _members(one: Sequence[m.Node], other: Sequence[m.Node], path: str) -> Changes:
    """Members are matched by name, then by place when what is there is the same under another name."""
    old, new = {node.name: node for node in one}, {node.name: node for node in other}
    renamed = {
        a.name: b.name
        for a, b in zip(one, other, strict=False)
        if a.name not in new and b.name not in old and shape(a) == shape(b)
    }
    for name, node in old.items():
        if name in renamed:
            yield Change("name", _join(path, name), f"is called {renamed[name]} now")
        elif name not in new:
            yield Change("wire", _join(path, name), f"removed ({_kind(node)})")
    for name, node in new.items():
        if name not in old and name not in renamed.values():
            yield Change("wire", _join(path, name), f"added ({_kind(node)})")
    before = [renamed.get(name, name) for name in old if name in new or name in renamed]
    after = [name for name in new if name in before]
    if before != after:
        yield Change("wire", path, f"order {', '.join(before)} -> {', '.join(after)}")
    for name, node in old.items():
        match_ = new.get(renamed.get(name, name))
        if match_ is not None:
            if node.optional != match_.optional:
                yield Change("wire", _join(path, name), "is optional now" if match_.optional else "is mandatory now")
            yield from _compare(node, match_, _join(path, name))


def _arms(one: m.Variant, other: m.Variant, path: str) -> Changes:
    """Arms are matched by their tag, which is all the wire knows."""
    for number, (a, b) in enumerate(zip(one.arms, other.arms, strict=False)):
        if a.name != b.name:
            same = shape(a) == shape(b)
            text = f"arm {number} is called {b.name} now" if same else f"arm {number} {a.name} -> {b.name}"
            yield Change("name" if same else "wire", path, text)
        if a.name == b.name or shape(a) != shape(b):
            yield from _compare(a, b, _join(path, a.name))
    for number, arm in list(enumerate(one.arms))[len(other.arms) :]:
        yield Change("wire", path, f"arm {number} {arm.name} removed")
    for number, arm in list(enumerate(other.arms))[len(one.arms) :]:
        yield Change("wire", path, f"arm {number} {arm.name} added")


# --- numbers --------------------------------------------------------------------------------------------------------


def _number(one: m.FixedField | m.TypeChoice, other: m.FixedField | m.TypeChoice, path: str) -> Changes:
    yield from _differ(one.type, other.type, "type", path)
    if one.units != other.units:
        yield Change("units", path, f"units {one.units} -> {other.units}")
    yield from _differ(_scale(one.scale), _scale(other.scale), "range", path)
    yield from _values(one.values, other.values, path)


def _scale(scale: m.Scale | None) -> str | None:
    if scale is None:
        return None
    return f"{scale.lower:.9g}..{scale.upper:.9g}" + ("" if scale.function == "round" else f" {scale.function}")


def _values(one: m.ValueSet | None, other: m.ValueSet | None, path: str) -> Changes:
    old = {enum.value: enum.name for enum in one.enums} if one else {}
    new = {enum.value: enum.name for enum in other.enums} if other else {}
    same_set = value_shape(one) == value_shape(other)
    for value in sorted(old.keys() | new.keys()):
        if value not in new:
            yield Change("name" if same_set else "wire", path, f"value {value} {old[value]} removed")
        elif value not in old:
            yield Change("name" if same_set else "wire", path, f"value {value} {new[value]} added")
        elif old[value] != new[value]:
            yield Change("name", path, f"value {value} {old[value]} is called {new[value]} now")
    if not same_set:
        yield from _differ(_ranges(one), _ranges(other), "allowed", path)


def _ranges(values: m.ValueSet | None) -> str:
    if values is None:
        return "any"
    parts = (
        f"{'' if r.lower_inclusive else '>'}{r.lower:.9g}..{'' if r.upper_inclusive else '<'}{r.upper:.9g}"
        for r in values.ranges
    )
    return " or ".join(parts) or "names alone"


def _bits(one: m.BitField, other: m.BitField, path: str) -> Changes:
    old, new = {part.name: part for part in one.subfields}, {part.name: part for part in other.subfields}
    by_bits = {(part.first, part.last): part for part in other.subfields if part.name not in old}
    for name, part in old.items():
        inside = _join(path, name)
        found = new.get(name)
        if found is None and (part.first, part.last) in by_bits:
            found = by_bits.pop((part.first, part.last))
            yield Change("name", inside, f"is called {found.name} now")
        if found is None:
            yield Change("wire", inside, f"removed (bits {part.first}..{part.last})")
            continue
        yield from _differ(f"{part.first}..{part.last}", f"{found.first}..{found.last}", "bits", inside)
        yield from _values(part.values, found.values, inside)
    for part in by_bits.values():
        yield Change("wire", _join(path, part.name), f"added (bits {part.first}..{part.last})")


def _choices(one: m.VariableField, other: m.VariableField, path: str) -> Changes:
    old, new = {part.index: part for part in one.choices}, {part.index: part for part in other.choices}
    for index in sorted(old.keys() | new.keys()):
        if index not in new or index not in old:
            yield Change("wire", path, f"index {index} {'removed' if index in old else 'added'}")
            continue
        if old[index].name != new[index].name:
            yield Change("name", path, f"index {index} {old[index].name} is called {new[index].name} now")
        yield from _number(old[index], new[index], f"{path}[{index}]")


# --- words ----------------------------------------------------------------------------------------------------------


def _count(count: m.Count) -> str:
    return f"{count.type} {count.minimum}..{count.maximum}"


def _sizes(node: m.Array) -> str:
    return " x ".join(str(dimension.size) for dimension in node.dimensions)


def _kind(node: m.Node) -> str:
    words = {
        m.BitField: "bit field",
        m.VariableField: "variable field",
        m.FixedString: "fixed string",
        m.VariableString: "string",
        m.VariableLengthField: "bytes",
        m.VariableFormatField: "bytes with a format",
    }
    kind = node.type if isinstance(node, m.FixedField) else words.get(type(node), type(node).__name__.lower())
    return f"optional {kind}" if node.optional else kind


def _brief(node: m.Node) -> str:
    match node:
        case m.FixedString():
            return f"{node.length} bytes"
        case m.VariableString():
            return _count(node.count)
        case m.VariableLengthField():
            return f"{node.format} {_count(node.count)}"
        case m.VariableFormatField():
            return f"{', '.join(f'{part.index} {part.name}' for part in node.formats)} {_count(node.count)}"
    return _kind(node)
