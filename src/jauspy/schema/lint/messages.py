"""Rules about messages: their ids, and what is said about them."""

from __future__ import annotations

from collections.abc import Iterator

from lxml.etree import _Element as Element

from jauspy.schema.document import line_of, location
from jauspy.schema.lint.context import LintContext, Problem
from jauspy.schema.model import Location, Message
from jauspy.schema.wire import same_wire

_HOLDERS = ("message_def", "event_def", "service_def", "declared_type_set")
_FIELDS = (
    "fixed_field",
    "bit_field",
    "variable_field",
    "fixed_length_string",
    "variable_length_string",
    "variable_length_field",
    "variable_format_field",
    "array",
    "list",
    "variant",
)


def shown(message: Message) -> str:
    """A message and where it is defined."""
    where = f" ({message.where.file}:{message.where.line})" if message.where else ""
    return f"{message.name}{where}"


def duplicate_message(context: LintContext) -> Iterator[Problem]:
    """Two messages of one service, or of it and its ancestors, under one id or name."""
    for service in context.services():
        for direction in ("input_set", "output_set"):
            yield from _duplicates(context, context.messages(service, direction))
        yield from _two_meanings(context, service)


def _duplicates(context: LintContext, messages: Iterator[Element]) -> Iterator[Problem]:
    codes: dict[str, Element] = {}
    names: dict[str, Element] = {}
    for element in messages:
        name = element.get("name", "")
        message = context.message(element)
        code = f"{message.code:04X}" if message else element.get("message_id", "").strip().upper()
        for key, seen, what in ((code, codes, "message_id"), (name, names, "name")):
            first = seen.setdefault(key, element)
            if key and first is not element:
                reason = f"{what} {key} of {name} is that of {first.get('name')} in line {line_of(first)}"
                yield location(element), f"{reason}; give it another or delete one"


def _two_meanings(context: LintContext, service: Element) -> Iterator[Problem]:
    """One id with different content in inputs and outputs, or in a service and an ancestor."""
    known: dict[int, Message] = {}
    line = context.lineage(service)
    for ancestor in reversed(line[1:]):
        for element in context.messages(ancestor):
            message = context.message(element)
            if message is not None:
                known[message.code] = message
    for element in context.messages(service):
        message = context.message(element)
        if message is None:
            continue
        first = known.setdefault(message.code, message)
        if not same_wire(first.body, message.body) or (first.name != message.name and first is not message):
            if first.name != message.name and _same_set(context, service, first, message):
                continue  # reported as a duplicate
            reason = f"message_id {message.code:04X} of {message.name} also means {shown(first)}, with other content"
            yield location(element), f"{reason}; a receiver cannot tell them apart, change one id"


def _same_set(context: LintContext, service: Element, one: Message, other: Message) -> bool:
    sets = [
        {message.name for element in context.messages(service, direction) if (message := context.message(element))}
        for direction in ("input_set", "output_set")
    ]
    return any({one.name, other.name} <= names for names in sets)


def conflicting_message(context: LintContext) -> Iterator[Problem]:
    """One id with different content in different services."""
    own = list(context.services())
    codes = {context.code(element) for service in own for element in context.messages(service)}
    users = [_User(context, service, codes) for service in context.all_services()]
    by_code: dict[int, list[tuple[_User, Message]]] = {}
    for user in users:
        for message, _ in user.messages:
            by_code.setdefault(message.code, []).append((user, message))
    for user in users[: len(own)]:
        for message, element in user.messages:
            yield from _conflicts(user, message, location(element), by_code[message.code])


class _User:
    """A service, those of its messages that have one of the `codes`, and whom it need not be told apart from."""

    def __init__(self, context: LintContext, service: Element, codes: set[str]) -> None:
        self.urn, self.version = (service.get(name, "").strip() for name in ("id", "version"))
        self.lineage = {each.get("id", "").strip() for each in context.lineage(service)}
        wanted = (element for element in context.messages(service) if context.code(element) in codes)
        found = ((context.message(element), element) for element in wanted)
        self.messages = [(message, element) for message, element in found if message is not None]

    def may_differ(self, other: _User) -> bool:
        """Within a lineage that is a duplicate; versions of a service, or of its set, replace each other."""
        if self.urn in other.lineage or other.urn in self.lineage:
            return True
        return self.urn.rpartition(":")[0] == other.urn.rpartition(":")[0] and self.version != other.version


def _conflicts(
    user: _User, message: Message, where: Location, others: list[tuple[_User, Message]]
) -> Iterator[Problem]:
    found = [
        (other, theirs)
        for other, theirs in others
        if not user.may_differ(other) and not same_wire(message.body, theirs.body)
    ]
    if found:
        other, theirs = found[0]
        more = f", and of {len(found) - 1} more," if len(found) > 1 else ""
        reason = f"message_id {message.code:04X} of {message.name} is also {shown(theirs)} of {other.urn}{more}"
        yield where, f"{reason} with other content; decoders have to know the service, or change one id"


def no_description(context: LintContext) -> Iterator[Problem]:
    """Services, messages and events nobody has described, and fields without an interpretation."""
    for element, _ in context.elements("service_def", "message_def", "event_def"):
        if not (element.findtext("description") or "").strip():
            yield location(element), f"{_kind(element)} '{element.get('name')}' has no description; say what it is for"
    undocumented: dict[Element, list[str]] = {}
    for element, _ in context.elements(*_FIELDS):
        if not element.get("interpretation", "").strip():
            holder = next(element.iterancestors(*_HOLDERS), element)
            undocumented.setdefault(holder, []).append(element.get("name", ""))
    for holder, names in undocumented.items():
        few = ", ".join(names[:5]) + (f" and {len(names) - 5} more" if len(names) > 5 else "")
        yield (
            location(holder),
            f"no interpretation of {few} in {_kind(holder)} '{holder.get('name')}'; say what they mean",
        )


def _kind(element: Element) -> str:
    kinds = {"service_def": "service", "message_def": "message", "event_def": "event", "declared_type_set": "type set"}
    return kinds[str(element.tag)]
