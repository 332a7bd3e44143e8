"""Rules about what a definition refers to: sets, types, constants, parents."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from jauspy.errors import SchemaError
from jauspy.schema.document import DECLARED, file_of, identity, line_of, location, suggestion
from jauspy.schema.lint.context import LintContext, Problem
from jauspy.schema.model import Location

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


def placed(error: SchemaError, advice: str = "") -> Problem:
    """A mistake the loader has found, with what to do."""
    where = Location(error.file or "", error.line or 0)
    return where, error.reason + (f"; {advice}" if advice else "")


def broken_grammar(context: LintContext) -> Iterator[Problem]:
    """Elements and attributes that JSIDL does not have, or that are missing or too many."""
    yield from map(placed, context.grammar)


def duplicate_definition(context: LintContext) -> Iterator[Problem]:
    """One id and version, or one name in a set, for two definitions."""
    yield from (placed(error, "rename or delete one") for error in context.duplicates)


def dangling_set(context: LintContext) -> Iterator[Problem]:
    """References to type sets and constant sets that are in no file."""
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
            yield placed(error, f"name its file, too{used}")


def dangling_type(context: LintContext) -> Iterator[Problem]:
    """References to declared types that are not there, or of another kind."""
    for element, scope in context.elements(*DECLARED):
        local, dot, _ = element.get("declared_type_ref", "").partition(".")
        if dot and local in scope.type_sets and local not in scope.linked_types:
            continue  # the missing set is reported, once
        try:
            scope.find(element)
        except SchemaError as error:
            if error not in context.grammar:
                yield placed(error)


def dangling_constant(context: LintContext) -> Iterator[Problem]:
    """Numbers that are neither numbers nor expressions of known constants."""
    for element, scope in context.elements(*_NUMBERS):
        for attribute in _NUMBERS[str(element.tag)]:
            if attribute in element.attrib:
                try:
                    scope.number(element, attribute)
                except SchemaError as error:
                    yield placed(error)


def missing_parent(context: LintContext) -> Iterator[Problem]:
    """Services that inherit from one that is in no file, or from themselves."""
    known = {root: f"{root.get('id', '').strip()} {root.get('version', '')}" for root in context.all_services()}
    for service in context.services():
        for reference in service.iterfind("references/inherits_from"):
            if reference.get("id") is None or reference.get("version") is None:
                continue
            wanted = " ".join(identity(reference))
            if context.parent(service) is None:
                reason = f"inherits_from: no service {wanted} is loaded{suggestion(wanted, known.values())}"
                yield location(reference), f"{reason}; name its file, too"
            elif context.parent(context.lineage(service)[-1]) is not None:
                yield location(reference), f"inherits_from: {known[service]} inherits from itself; cut the circle"
