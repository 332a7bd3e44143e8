"""Differences of two services, and which services of two schemas belong together."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from jauspy.schema.compare.behavior import compare_behavior
from jauspy.schema.compare.change import Change
from jauspy.schema.compare.fields import compare_bodies
from jauspy.schema.model import Message, Schema, Service
from jauspy.schema.services import version_key


@dataclass(frozen=True, slots=True)
class MessageDiff:
    """A message that both have, and what changed."""

    one: Message
    other: Message
    changes: tuple[Change, ...]

    @property
    def same_wire(self) -> bool:
        """True when the same bytes are the same numbers; units and names may differ."""
        return all(change.kind != "wire" for change in self.changes)


@dataclass(frozen=True, slots=True)
class ServiceDiff:
    """A service that both have, or only one: the other is then None."""

    one: Service | None
    other: Service | None
    removed: tuple[Message, ...] = ()
    added: tuple[Message, ...] = ()
    messages: tuple[MessageDiff, ...] = ()
    behavior: tuple[Change, ...] = ()

    @property
    def same(self) -> bool:
        """True when nothing but prose and version numbers differs."""
        changed = any(message.changes for message in self.messages)
        return None not in (self.one, self.other) and not (self.removed or self.added or self.behavior or changed)


def compare(one: Schema, other: Schema) -> list[ServiceDiff]:
    """All services of both."""
    return [compare_services(a, b) if a and b else ServiceDiff(a, b) for a, b in pairs(one, other)]


def pairs(one: Schema, other: Schema) -> Iterator[tuple[Service | None, Service | None]]:
    """Services with one URN, in equal versions first, then the newest; two single services whatever they are called."""
    left, right = list(one.services), list(other.services)
    if len(left) == len(right) == 1:
        yield left[0], right[0]
        return
    found = []
    for service in list(left):
        same = next((each for each in right if each.key == service.key), None)
        if same is not None:
            found.append((service, same))
            left.remove(service)
            right.remove(same)
    for service in sorted(left, key=lambda each: version_key(each.version), reverse=True):
        versions = [each for each in right if each.id == service.id]
        if versions:
            newest = max(versions, key=lambda each: version_key(each.version))
            found.append((service, newest))
            left.remove(service)
            right.remove(newest)
    yield from sorted(found, key=lambda pair: pair[0].key)
    yield from ((service, None) for service in left)
    yield from ((None, service) for service in right)


def compare_services(one: Service, other: Service) -> ServiceDiff:
    """Two services, message by message; messages are matched by id, then by name."""
    old, new = list(_once(one.messages)), list(_once(other.messages))
    matched = []
    for message in list(old):
        found = next((each for each in new if each.code == message.code), None)
        found = found or next((each for each in new if each.name == message.name), None)
        if found is not None:
            matched.append(MessageDiff(message, found, tuple(_changes(message, found, one, other))))
            old.remove(message)
            new.remove(found)
    behavior = (*_inheritance(one, other), *compare_behavior(one.behavior, other.behavior))
    return ServiceDiff(one, other, tuple(old), tuple(new), tuple(matched), behavior)


def _once(messages: Sequence[Message]) -> Iterator[Message]:
    """A message that is both input and output counts once."""
    found: dict[int, Message] = {}
    for message in messages:
        found.setdefault(message.code, message)
    return iter(found.values())


def _changes(one: Message, other: Message, before: Service, after: Service) -> Iterator[Change]:
    if one.code != other.code:
        yield Change("wire", "", f"message_id {one.code:04X} -> {other.code:04X}")
    if one.name != other.name:
        yield Change("name", "", f"{one.name} is called {other.name} now")
    if one.is_command != other.is_command:
        yield Change("name", "", "is a command now" if other.is_command else "is no command any more")
    ways = _ways(one, before), _ways(other, after)
    if ways[0] != ways[1]:
        yield Change("wire", "", f"{ways[0]} -> {ways[1]}")
    yield from compare_bodies(one.body, other.body)


def _ways(message: Message, service: Service) -> str:
    ways = (("input", service.inputs), ("output", service.outputs))
    return " and ".join(way for way, messages in ways if any(each.code == message.code for each in messages))


def _inheritance(one: Service, other: Service) -> Iterator[Change]:
    parents = [f"{each.inherits_from.id} {each.inherits_from.version}" if each.inherits_from else "nothing"
               for each in (one, other)]  # fmt: skip
    if parents[0] != parents[1]:
        yield Change("behavior", "", f"inherits from {parents[0]} -> {parents[1]}")
