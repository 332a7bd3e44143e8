"""Rules about messages and references: ids, descriptions, type sets, constants, parents."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from lxml.etree import _Element as Element

from jauspy.errors import SchemaError
from jauspy.schema.digest import same_wire
from jauspy.schema.document import DECLARED, file_of, give_its_file, identity, line_of, location, suggestion
from jauspy.schema.lint.context import LintContext, Problem
from jauspy.schema.model import MessageDefinition, SourceLocation

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


def shown(message: MessageDefinition) -> str:
    """A message and the location of its definition."""
    where = f" ({message.where.file}:{message.where.line})" if message.where else ""
    return f"{message.name}{where}"


def duplicate_message(context: LintContext) -> Iterator[Problem]:
    """Two messages with the same id or name in a service and its ancestors."""
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
    known: dict[int, MessageDefinition] = {}
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
            yield location(element), f"{reason}; a receiver cannot distinguish them, change one id"


def _same_set(context: LintContext, service: Element, one: MessageDefinition, other: MessageDefinition) -> bool:
    sets = [
        {message.name for element in context.messages(service, direction) if (message := context.message(element))}
        for direction in ("input_set", "output_set")
    ]
    return any({one.name, other.name} <= names for names in sets)


def conflicting_message(context: LintContext) -> Iterator[Problem]:
    """One id with different content in different services."""
    checked = list(context.services())
    codes = {context.code(element) for service in checked for element in context.messages(service)}
    users = [_User(context, service, codes) for service in context.all_services()]
    by_code: dict[int, list[tuple[_User, MessageDefinition]]] = {}
    for user in users:
        for message, _ in user.messages:
            by_code.setdefault(message.code, []).append((user, message))
    for user in users[: len(checked)]:
        for message, element in user.messages:
            yield from _conflicts(user, message, location(element), by_code[message.code])


class _User:
    """A service, its messages with one of the `codes`, and the services from which it need not differ."""

    def __init__(self, context: LintContext, service: Element, codes: set[str]) -> None:
        self.urn, self.version = (service.get(name, "").strip() for name in ("id", "version"))
        self.lineage = {ancestor.get("id", "").strip() for ancestor in context.lineage(service)}
        wanted = (element for element in context.messages(service) if context.code(element) in codes)
        found = ((context.message(element), element) for element in wanted)
        self.messages = [(message, element) for message, element in found if message is not None]

    def may_differ(self, other: _User) -> bool:
        """True for services of one lineage, where it is a duplicate, and for versions of a service or its set."""
        if self.urn in other.lineage or other.urn in self.lineage:
            return True
        return self.urn.rpartition(":")[0] == other.urn.rpartition(":")[0] and self.version != other.version


def _conflicts(
    user: _User, message: MessageDefinition, where: SourceLocation, others: list[tuple[_User, MessageDefinition]]
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
        yield where, f"{reason} with other content; decoders need the service as an argument, or change one id"


def no_description(context: LintContext) -> Iterator[Problem]:
    """Services, messages and events without a description, and fields without an interpretation."""
    for element, _ in context.elements("service_def", "message_def", "event_def"):
        if not (element.findtext("description") or "").strip():
            yield (
                location(element),
                f"{_kind(element)} '{element.get('name')}' has no description; describe its purpose",
            )
    undocumented: dict[Element, list[str]] = {}
    for element, _ in context.elements(*_FIELDS):
        if not element.get("interpretation", "").strip():
            holder = next(element.iterancestors(*_HOLDERS), element)
            undocumented.setdefault(holder, []).append(element.get("name", ""))
    for holder, names in undocumented.items():
        few = ", ".join(names[:5]) + (f" and {len(names) - 5} more" if len(names) > 5 else "")
        yield (
            location(holder),
            f"no interpretation of {few} in {_kind(holder)} '{holder.get('name')}'; describe their meaning",
        )


def _kind(element: Element) -> str:
    kinds = {"service_def": "service", "message_def": "message", "event_def": "event", "declared_type_set": "type set"}
    return kinds[str(element.tag)]


_NUMBERS = {
    "const_def": ("const_value",),
    "count_field": ("min_count", "max_count"),
    "vtag_field": ("min_count", "max_count"),
    "scale_range": ("real_lower_limit", "real_upper_limit"),
    "value_range": ("lower_limit", "upper_limit"),
    "fixed_length_string": ("string_length",),
    "dimension": ("size",),
}
"""The attributes that may name constants."""


def problem_of(error: SchemaError, advice: str = "") -> Problem:
    """The problem for an error of the loader, with advice."""
    where = SourceLocation(error.file or "", error.line or 0)
    return where, error.reason + (f"; {advice}" if advice else "")


def broken_grammar(context: LintContext) -> Iterator[Problem]:
    """Unknown, missing or surplus elements and attributes."""
    yield from map(problem_of, context.grammar)


def duplicate_definition(context: LintContext) -> Iterator[Problem]:
    """Two definitions with one id and version, or with one name in a set."""
    yield from (problem_of(error, "rename or delete one") for error in context.duplicates)


def dangling_set(context: LintContext) -> Iterator[Problem]:
    """References to unknown type sets and constant sets."""
    uses: Counter[tuple[str, str]] = Counter()
    for element, _ in context.elements(*DECLARED):
        local, dot, _ = element.get("declared_type_ref", "").partition(".")
        uses[file_of(element), local if dot else ""] += 1
    local_names = {
        (file_of(element), line_of(element)): element.get("name", "")
        for element, _ in context.elements("declared_type_set_ref", "declared_const_set_ref")
    }
    for error in context.unlinked:
        key = (error.file or "", error.line or 0)
        if key in local_names:
            count = uses[key[0], local_names[key]]
            used = f" ({count} references go through '{local_names[key]}')" if count else ""
            where, reason = problem_of(error)
            yield where, f"{reason}{used}"


def dangling_type(context: LintContext) -> Iterator[Problem]:
    """References to declared types that do not exist or are of another kind."""
    for element, scope in context.elements(*DECLARED):
        local, dot, _ = element.get("declared_type_ref", "").partition(".")
        if dot and local in scope.type_sets and local not in scope.linked_types:
            continue  # the missing set is reported, once
        try:
            scope.find(element)
        except SchemaError as error:
            if error not in context.grammar:
                yield problem_of(error)


def dangling_constant(context: LintContext) -> Iterator[Problem]:
    """Numbers that are neither numbers nor expressions of known constants."""
    for element, scope in context.elements(*_NUMBERS):
        for attribute in _NUMBERS[str(element.tag)]:
            if attribute in element.attrib:
                try:
                    scope.number(element, attribute)
                except SchemaError as error:
                    yield problem_of(error)


def missing_parent(context: LintContext) -> Iterator[Problem]:
    """Services that inherit from an unknown service, or from themselves."""
    known = {root: f"{root.get('id', '').strip()} {root.get('version', '')}" for root in context.all_services()}
    for service in context.services():
        for reference in service.iterfind("references/inherits_from"):
            if reference.get("id") is None or reference.get("version") is None:
                continue
            wanted = " ".join(identity(reference))
            if context.parent(service) is None:
                reason = f"inherits_from: no service {wanted} is loaded{suggestion(wanted, known.values())}"
                yield location(reference), f"{reason}; {give_its_file(identity(reference)[0])}"
            elif context.parent(context.lineage(service)[-1]) is not None:
                yield location(reference), f"inherits_from: {known[service]} inherits from itself; cut the circle"
