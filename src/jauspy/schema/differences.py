"""Differences between two definitions: on the wire, in units, in names, in behaviour.

Services are matched by URN and version, messages by id, then by name, fields by name, then by position.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal, TypeAlias

from jauspy.schema import model as m
from jauspy.schema.digest import shape, value_shape
from jauspy.schema.model import ActionCall, Behavior, MessageDefinition, Schema, ServiceDefinition, State, Transition
from jauspy.schema.services import version_key
from jauspy.schema.state_tree import short_name


@dataclass(frozen=True, slots=True)
class Change:
    """A difference and the field path where it is; the path is empty for a whole message or machine.

    `wire`: bytes, numbers or allowed values differ. `units`: the same numbers in other units. `name`: the same bytes
    have another name. `behavior`: the behaviour of a service differs.
    """

    kind: Literal["wire", "units", "name", "behavior"]
    path: str
    text: str

    def __str__(self) -> str:
        return f"{self.path}: {self.text}" if self.path else self.text


Changes = Iterator[Change]


def compare_bodies(one: m.Composite | None, other: m.Composite | None) -> Changes:
    """Compare two bodies; the name of the outermost composite is ignored."""
    if one is None or other is None:
        if one is not other:
            yield Change("wire", "", "has fields now" if one is None else "has no fields any more")
        return
    yield from _compare(one, other, "")


def _compare(one: m.Node, other: m.Node, path: str) -> Changes:
    """Compare a field or composite with all its parts; on the wire a record equals a sequence."""
    form, its_form = (m.Record if isinstance(node, m.Sequence) else type(node) for node in (one, other))
    if form is not its_form:
        yield Change("wire", path, f"{_kind(one)} -> {_kind(other)}")
        return
    for (what, old), new in zip(_facts(one).items(), _facts(other).values(), strict=True):
        yield from _differ(old, new, what, path)
    yield from _COMPARE_INSIDE.get(form, _compare_whole)(one, other, path)


def _facts(node: m.Node) -> dict[str, object]:
    """The properties of a composite or bit field, besides its parts, that matter on the wire."""
    match node:
        case m.Record() | m.Sequence():
            return {"presence vector": node.presence}
        case m.BitField():
            return {"type": node.type}
        case m.List():
            return {"count": _count(node.count)}
        case m.Variant():
            return {"tag": node.tag.type}
        case m.Array():
            return {"dimensions": _sizes(node)}
    return {}


def _element(one: m.List | m.Array, other: m.List | m.Array, path: str) -> Changes:
    yield from _compare(one.element, other.element, _join(path, one.element.name) if isinstance(one, m.List) else path)


def _compare_whole(one: m.Node, other: m.Node, path: str) -> Changes:
    if shape(one) != shape(other):
        yield Change("wire", path, f"{_brief(one)} -> {_brief(other)}")


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


def _members(one: m.Record | m.Sequence, other: m.Record | m.Sequence, path: str) -> Changes:
    """Match members by name, then by position if the content is the same under another name."""
    old, new = {node.name: node for node in _inside(one)}, {node.name: node for node in _inside(other)}
    renamed = {
        a.name: b.name
        for a, b in zip(_inside(one), _inside(other), strict=False)
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
    """Match arms by their tags, which are on the wire."""
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


_COMPARE_INSIDE: Mapping[type[m.Node], Callable[[Any, Any, str], Changes]] = {
    m.Record: _members,
    m.FixedField: _number,
    m.BitField: _bits,
    m.VariableField: _choices,
    m.List: _element,
    m.Array: _element,
    m.Variant: _arms,
}
"""Functions that compare two nodes, by kind; other nodes are compared as a whole."""


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


_BLANKS = re.compile(r"(?<=[(!])\s+|\s+(?=[(),])")
"""Insignificant blanks in a guard."""

TransitionKey: TypeAlias = tuple[str, str]
"""Trigger and guard of a transition."""


@dataclass(slots=True)
class _StateEffects:
    """The effects of a state, without the local names of services that it is inherited from."""

    initial: str | None
    entry: tuple[str, ...]
    exit: tuple[str, ...]
    rules: dict[TransitionKey, list[str]] = field(default_factory=dict)


def compare_behavior(one: Behavior | None, other: Behavior | None) -> Iterator[Change]:
    """Added, removed and changed states and transitions."""
    old, new = _states(one), _states(other)
    removed, added = old.keys() - new.keys(), new.keys() - old.keys()
    for path in sorted(removed):
        if path.rpartition(".")[0] not in removed:
            yield Change("behavior", path, f"{_what(path)} removed")
    for path in sorted(added):
        if path.rpartition(".")[0] not in added:
            yield Change("behavior", path, f"{_what(path)} added")
        for rule, effects in new[path].rules.items():
            yield from (Change("behavior", path, f"{_named(rule)}: {effect} added") for effect in effects)
    for path in (path for path in old if path in new):
        yield from _compare_states(old[path], new[path], path)
    starts = [
        {(short_name(start.machine), start.state) for start in (service.start if service else ())}
        for service in (one, other)
    ]
    for machine, state in sorted(starts[0] ^ starts[1]):
        done = "does not start" if (machine, state) in starts[0] else "starts"
        yield Change("behavior", machine, f"{done} in {state}" + (" any more" if "not" in done else ""))


def _what(path: str) -> str:
    return "state" if "." in path else "state machine"


def _compare_states(one: _StateEffects, other: _StateEffects, path: str) -> Iterator[Change]:
    for what, before, after in (
        ("initial state", (one.initial or "none",), (other.initial or "none",)),
        ("on entry", one.entry, other.entry),
        ("on exit", one.exit, other.exit),
    ):
        if before != after:
            yield Change(
                "behavior", path, f"{what} {', '.join(before) or 'nothing'} -> {', '.join(after) or 'nothing'}"
            )
    for rule in dict.fromkeys((*one.rules, *other.rules)):
        old, new = one.rules.get(rule, []), other.rules.get(rule, [])
        removed = [effect for effect in old if effect not in new]
        added = [effect for effect in new if effect not in old]
        if len(removed) == len(added):
            pairs = zip(removed, added, strict=True)
            yield from (Change("behavior", path, f"{_named(rule)}: {a} -> {b}") for a, b in pairs)
        else:
            yield from (Change("behavior", path, f"{_named(rule)}: {effect} removed") for effect in removed)
            yield from (Change("behavior", path, f"{_named(rule)}: {effect} added") for effect in added)


def _named(rule: TransitionKey) -> str:
    return f"{rule[0]} [{rule[1]}]" if rule[1] else rule[0]


def _states(behavior: Behavior | None) -> dict[str, _StateEffects]:
    found: dict[str, _StateEffects] = {}
    for machine in behavior.machines if behavior else ():
        whole = _StateEffects(None, (), ())
        _add_rules(whole, machine.default_transitions, "by default ")
        found[short_name(machine.name)] = whole
        for state in machine.states:
            _add(found, state, f"{short_name(machine.name)}.{state.name}")
    return found


def _add(found: dict[str, _StateEffects], state: State, path: str) -> None:
    made = _StateEffects(state.initial, _texts(state.entry), _texts(state.exit))
    _add_rules(made, state.transitions, "")
    _add_rules(made, state.default_transitions, "by default ")
    found[path] = made
    for child in state.states:
        _add(found, child, f"{path}.{child.name}")


def _add_rules(state: _StateEffects, transitions: Sequence[Transition], prefix: str) -> None:
    for transition in transitions:
        rule = (prefix + trigger(transition), _BLANKS.sub("", transition.guard))
        state.rules.setdefault(rule, []).append(_effect(transition))


def _effect(transition: Transition) -> str:
    goes = f"go to {transition.end_state}" if transition.end_state else ""
    if transition.kind in ("push", "pop"):
        goes = f"{transition.kind} {transition.end_state or ''}".strip()
    return ", ".join((*_texts(transition.actions), *([goes] if goes else []))) or "nothing"


def _texts(actions: Sequence[ActionCall]) -> tuple[str, ...]:
    return tuple(f"{short_name(action.name)}({', '.join(action.arguments)})" for action in actions)


def trigger(transition: Transition) -> str:
    """The message or internal event that triggers a transition."""
    event = short_name(transition.trigger)
    if event == "Receive" and transition.parameters:
        return short_name(transition.parameters[0].type)
    return event or "anything else"


@dataclass(frozen=True, slots=True)
class MessageDiff:
    """A message of both services, and its changes."""

    one: MessageDefinition
    other: MessageDefinition
    changes: tuple[Change, ...]

    @property
    def same_wire(self) -> bool:
        """True if equal bytes are equal numbers; units and names may differ."""
        return all(change.kind != "wire" for change in self.changes)


@dataclass(frozen=True, slots=True)
class ServiceDiff:
    """A service of both definitions, or of one; the other is then None."""

    one: ServiceDefinition | None
    other: ServiceDefinition | None
    removed: tuple[MessageDefinition, ...] = ()
    added: tuple[MessageDefinition, ...] = ()
    messages: tuple[MessageDiff, ...] = ()
    behavior: tuple[Change, ...] = ()

    @property
    def same(self) -> bool:
        """True if only prose and version numbers differ."""
        changed = any(message.changes for message in self.messages)
        return None not in (self.one, self.other) and not (self.removed or self.added or self.behavior or changed)


def compare(one: Schema, other: Schema) -> list[ServiceDiff]:
    """Compare all services of two schemas."""
    return [compare_services(a, b) if a and b else ServiceDiff(a, b) for a, b in pairs(one, other)]


def pairs(one: Schema, other: Schema) -> Iterator[tuple[ServiceDefinition | None, ServiceDefinition | None]]:
    """Pairs of services with one URN, equal versions first, then the newest; two single services are a pair."""
    left, right = list(one.services), list(other.services)
    if len(left) == len(right) == 1:
        yield left[0], right[0]
        return
    found = []
    for service in list(left):
        same = next((other for other in right if other.key == service.key), None)
        if same is not None:
            found.append((service, same))
            left.remove(service)
            right.remove(same)
    for service in sorted(left, key=lambda candidate: version_key(candidate.version), reverse=True):
        versions = [other for other in right if other.id == service.id]
        if versions:
            newest = max(versions, key=lambda candidate: version_key(candidate.version))
            found.append((service, newest))
            left.remove(service)
            right.remove(newest)
    yield from sorted(found, key=lambda pair: pair[0].key)
    yield from ((service, None) for service in left)
    yield from ((None, service) for service in right)


def compare_services(one: ServiceDefinition, other: ServiceDefinition) -> ServiceDiff:
    """Compare two services; messages are matched by id, then by name."""
    old, new = list(_once(one.messages)), list(_once(other.messages))
    matched = []
    for message in list(old):
        found = next((candidate for candidate in new if candidate.code == message.code), None)
        found = found or next((candidate for candidate in new if candidate.name == message.name), None)
        if found is not None:
            matched.append(MessageDiff(message, found, tuple(_changes(message, found, one, other))))
            old.remove(message)
            new.remove(found)
    behavior = (*_inheritance(one, other), *compare_behavior(one.behavior, other.behavior))
    return ServiceDiff(
        one=one, other=other, removed=tuple(old), added=tuple(new), messages=tuple(matched), behavior=behavior
    )


def _once(messages: Sequence[MessageDefinition]) -> Iterator[MessageDefinition]:
    """A message that is both input and output counts once."""
    found: dict[int, MessageDefinition] = {}
    for message in messages:
        found.setdefault(message.code, message)
    return iter(found.values())


def _changes(
    one: MessageDefinition, other: MessageDefinition, before: ServiceDefinition, after: ServiceDefinition
) -> Iterator[Change]:
    if one.code != other.code:
        yield Change("wire", "", f"message_id {one.code:04X} -> {other.code:04X}")
    if one.name != other.name:
        yield Change("name", "", f"{one.name} is called {other.name} now")
    if one.is_command != other.is_command:
        yield Change("name", "", "is a command now" if other.is_command else "is no longer a command")
    ways = _ways(one, before), _ways(other, after)
    if ways[0] != ways[1]:
        yield Change("wire", "", f"{ways[0]} -> {ways[1]}")
    yield from compare_bodies(one.body, other.body)


def _ways(message: MessageDefinition, service: ServiceDefinition) -> str:
    ways = (("input", service.inputs), ("output", service.outputs))
    return " and ".join(way for way, messages in ways if any(other.code == message.code for other in messages))


def _inheritance(one: ServiceDefinition, other: ServiceDefinition) -> Iterator[Change]:
    parents = [f"{service.inherits_from.id} {service.inherits_from.version}" if service.inherits_from else "nothing"
               for service in (one, other)]  # fmt: skip
    if parents[0] != parents[1]:
        yield Change("behavior", "", f"inherits from {parents[0]} -> {parents[1]}")
