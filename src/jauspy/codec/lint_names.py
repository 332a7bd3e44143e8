"""Lint rules about the Python names and code that message classes get from a definition."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Final

from lxml.etree import _Element as Element

from jauspy.codec.build import build
from jauspy.codec.names import attribute, constant, snake
from jauspy.errors import SchemaError
from jauspy.schema.document import location
from jauspy.schema.lint import LintContext, LintRule, Problem
from jauspy.schema.lint.fields import unbounded_list
from jauspy.schema.lint.messages import problem_of
from jauspy.schema.loader import load_own

_CONTAINERS: Final = ("record", "sequence", "variant", "bit_field")
_NO_MEMBERS: Final = frozenset(("presence_vector", "vtag_field"))


def colliding_names(context: LintContext) -> Iterator[Problem]:
    """JAUS names that become the same Python name."""
    for element, _ in context.elements(*_CONTAINERS):
        members = (part for part in element if part.tag not in _NO_MEMBERS)
        yield from _collisions(members, "name", attribute, f"in '{element.get('name')}'")
    for element, _ in context.elements("value_set"):
        holder = next((each.get("name") for each in (element, *element.iterancestors()) if each.get("name")), "")
        yield from _collisions(element.iterchildren("value_enum"), "enum_const", constant, f"in '{holder}'")
    for service in context.services():
        seen: dict[str, Element] = {}
        messages = (seen.setdefault(part.get("name", ""), part) for part in context.messages(service))
        yield from _collisions(messages, "name", snake, f"in service '{service.get('name')}'")


def _collisions(elements: Iterable[Element], key: str, made: Callable[[str], str], where: str) -> Iterator[Problem]:
    seen: dict[str, str] = {}
    for element in elements:
        name = element.get(key, "")
        first = seen.setdefault(made(name), name)
        if first != name:
            reason = f"'{name}' and '{first}' {where} are both {made(name)} in Python"
            yield location(element), f"{reason}; one gets a number, rename it"


def without_code(context: LintContext) -> Iterator[Problem]:
    """Definitions that load, but for which no code can be generated; another rule finds lists without bounds."""
    if any(unbounded_list(context)):
        return
    try:
        schema = load_own(context.paths)
    except SchemaError:
        return  # other rules report it
    try:
        build(schema, "checked")
    except SchemaError as error:
        yield problem_of(error)


RULES: Final = (
    LintRule("python-name", "warning", "names that collide in Python", colliding_names),
    LintRule("no-code", "error", "what no message class can be made of", without_code),
)
