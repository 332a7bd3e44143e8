"""All loaded files, the resolution of names between them, and constant expressions (`-10 * basicConsts.PI`).

A `NameScope` is one file's names: its constants and declared types, and the other sets it refers to by a local
name. A dotted path walks through those: `core.time.TimeStamp` is the type `TimeStamp` of the set that the
set `core` calls `time`.
"""

from __future__ import annotations

import ast
import math
import operator
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field, replace
from typing import Final, TypeVar, cast

from lxml.etree import _Element as Element

from jauspy.errors import SchemaError
from jauspy.schema.document import (
    DECLARED,
    MAX_DEPTH,
    file_of,
    flag,
    give_its_file,
    identity,
    line_of,
    prose,
    required,
    suggestion,
    wrong,
)
from jauspy.schema.model import DeclaredType, List, Node, Record, Sequence, Variant

Number = int | float
Lookup = Callable[[str], Number]
"""The value of a (dotted) constant name; raises `ConstantExpressionError` when there is none."""

MAX_LENGTH = 200
"""Characters of an expression; bounds the depth of its syntax tree."""

_BINARY: dict[type[ast.operator], Callable[[Number, Number], Number]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
}


class ConstantExpressionError(ValueError):
    """Raised with the reason why a text is not a constant expression."""


def evaluate(text: str, lookup: Lookup) -> Number:
    """The value of numbers and constant names joined by + - * / and parentheses; an int stays an int."""
    plain = _literal(text)
    if plain is not None:
        return plain
    if len(text) > MAX_LENGTH:
        raise ConstantExpressionError(f"expression longer than {MAX_LENGTH} characters")
    try:
        tree = ast.parse(text.strip(), mode="eval")
    except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
        raise ConstantExpressionError(f"expected a number or a constant expression, got {text!r}") from error
    try:
        result = _value(tree.body, lookup)
        finite = math.isfinite(result)
    except (ZeroDivisionError, OverflowError) as error:
        raise ConstantExpressionError(f"{text!r}: {error}") from error
    if not finite:
        raise ConstantExpressionError(f"{text!r} is not finite")
    return result


def _literal(text: str) -> Number | None:
    """The value of a text that is a plain number, as most limits are; None for any other."""
    for kind in (int, float):
        try:
            number: Number = kind(text)
            return number if math.isfinite(number) else None
        except (ValueError, OverflowError):  # no such number, or an integer that is above all floats
            continue
    return None


def _value(node: ast.expr, lookup: Lookup) -> Number:
    match node:
        case ast.Constant(value=int() | float() as number) if not isinstance(number, bool):
            return number
        case ast.UnaryOp(op=ast.USub()):
            return -_value(node.operand, lookup)
        case ast.UnaryOp(op=ast.UAdd()):
            return _value(node.operand, lookup)
        case ast.BinOp() if type(node.op) in _BINARY:
            return _BINARY[type(node.op)](_value(node.left, lookup), _value(node.right, lookup))
        case ast.Name() | ast.Attribute():
            return lookup(ast.unparse(node))
    raise ConstantExpressionError(f"expected numbers, constants, + - * / and parentheses, got {ast.unparse(node)!r}")


AnyNode = TypeVar("AnyNode", bound=Node)
Thing = TypeVar("Thing")
Key = tuple[str, str]
"""Id (URN) and version of a set or service."""
Report = Callable[[SchemaError], None]
"""Called with a mistake; loading continues if it returns."""


@dataclass(slots=True, eq=False)
class NameScope:
    """The names of one file. `set_id` and `version` are those of the type set or service around it."""

    set_id: str
    version: str
    consts: dict[str, Element] = field(default_factory=dict)
    types: dict[str, Element] = field(default_factory=dict)
    const_sets: dict[str, Element] = field(default_factory=dict)
    type_sets: dict[str, Element] = field(default_factory=dict)
    linked_consts: dict[str, NameScope] = field(default_factory=dict)
    linked_types: dict[str, NameScope] = field(default_factory=dict)
    cache: dict[str, object] = field(default_factory=dict)
    open: list[str] = field(default_factory=list)
    unsound: dict[str, SchemaError] = field(default_factory=dict)
    """Types that violate the grammar and cannot be read; used by the linter only."""

    def number(self, element: Element, attribute: str) -> Number:
        """A mandatory attribute that is a number or a constant expression."""
        text = required(element, attribute)
        try:
            return evaluate(text, lambda path: self._constant(path, element))
        except ConstantExpressionError as error:
            raise wrong(element, f"{attribute}: {error}") from error

    def integer(self, element: Element, attribute: str) -> int:
        """A mandatory attribute that is a whole number or a constant expression of that value."""
        number = self.number(element, attribute)
        if number != int(number):
            raise wrong(element, f"{attribute}: expected a whole number, got {required(element, attribute)!r}")
        return int(number)

    def _constant(self, path: str, element: Element) -> Number:
        home, name = self._walk(path, element, "linked_consts", "constant set")
        definition = home.consts.get(name)
        if definition is None:
            raise wrong(element, f"no constant '{path}'{suggestion(name, home.consts)}")
        return home.once(f"const {name}", definition, lambda: home.number(definition, "const_value"))

    def find(self, element: Element) -> tuple[NameScope, Element]:
        """The definition a `declared_*` element refers to, and the scope it was written in."""
        path = required(element, "declared_type_ref")
        home, name = self._walk(path, element, "linked_types", "type set")
        found = home.types.get(name)
        if found is None:
            raise wrong(element, f"no declared type '{path}'{suggestion(name, home.types)}")
        kind = DECLARED.get(found.tag, found.tag)
        if kind != DECLARED[element.tag]:
            raise wrong(element, f"'{path}' is a {kind}, but <{element.tag}> needs a {DECLARED[element.tag]}")
        if name in home.unsound:
            raise home.unsound[name]
        return home, found

    def declared(self, element: Element, read: Callable[[Element, NameScope], AnyNode]) -> AnyNode:
        """The node a `declared_*` element stands for: the definition under the element's own name."""
        home, found = self.find(element)
        node = home.once(required(found, "name"), element, lambda: read(found, home))
        return replace(
            node,
            name=required(element, "name"),
            optional=flag(element, "optional"),
            doc=prose(element) or node.doc,
            declared=node.declared or DeclaredType(home.set_id, home.version, required(found, "name")),
        )

    def once(self, name: str, element: Element, make: Callable[[], Thing]) -> Thing:
        """Read a definition once; a definition that contains itself is an error at `element`."""
        if name not in self.cache:
            if name in self.open:
                raise wrong(element, f"'{name}' contains itself")
            self.open.append(name)
            try:
                made = make()
                self.cache[name] = bounded_node(made, element) if isinstance(made, Node) else made
            finally:
                self.open.pop()
        return cast("Thing", self.cache[name])  # one name is one definition of one kind

    def _walk(self, path: str, element: Element, links: str, what: str) -> tuple[NameScope, str]:
        *sets, name = path.split(".")
        scope = self
        for local in sets:
            found = _linked(scope, local, links)
            if found is None:
                known: dict[str, NameScope] = getattr(scope, links)
                raise wrong(element, f"'{path}': no {what} is called '{local}' here{suggestion(local, known)}")
            scope = found
        return scope, name


MAX_PARTS: Final = 20_000
"""Fields and composites of a message; the largest public one has 2020."""


def bounded_node(node: AnyNode, element: Element) -> AnyNode:
    """The node, if it is not too deep or too large to be handled: declared types that use each other multiply."""
    waiting: list[tuple[Node, int]] = [(node, 1)]
    for member, depth in waiting:
        inner: tuple[Node, ...] = ()
        match member:
            case Record(fields=inner) | Sequence(items=inner) | Variant(arms=inner):
                pass
            case List(element=only):
                inner = (only,)
        if inner and depth == MAX_DEPTH:
            raise wrong(element, f"'{node.name}' has more than {MAX_DEPTH} nested levels; flatten it")
        if len(waiting) + len(inner) > MAX_PARTS:
            raise wrong(element, f"'{node.name}' has more than {MAX_PARTS} fields; divide it into several messages")
        waiting += [(part, depth + 1) for part in inner]
    return node


def _linked(scope: NameScope, local: str, links: str) -> NameScope | None:
    """The set with this local name, or else one with this name in a referenced set, which public files rely on."""
    waiting, seen = [scope], {id(scope)}
    for current in waiting:
        known: dict[str, NameScope] = getattr(current, links)
        if local in known:
            return known[local]
        fresh = [other for other in known.values() if id(other) not in seen]
        seen.update(map(id, fresh))
        waiting += fresh
    return None


def refuse(error: SchemaError) -> None:
    """Raises the error: the default for mistakes found while files are linked."""
    raise error


def scope_of(root: Element, report: Report = refuse) -> NameScope:
    """The scope of a `declared_const_set`, a `declared_type_set` or a `service_def`."""
    scope = NameScope(*identity(root))
    for part in (root, *root.iterchildren("declared_const_set", "declared_type_set")):
        _collect(part, scope, report)
    return scope


def _collect(part: Element, scope: NameScope, report: Report) -> None:
    if part.tag == "service_def":
        return
    for element in part:
        match element.tag:
            case "const_def":
                names = scope.consts
            case "declared_const_set_ref":
                names = scope.const_sets
            case "declared_type_set_ref":
                names = scope.type_sets
            case _:
                names = scope.types
        add_once(names, element, report)


def add_once(names: dict[str, Element], element: Element, report: Report = refuse) -> None:
    """Add a named element; a duplicate name is an error."""
    name = element.get("name")
    if name is None:
        return  # violates the grammar, which has been reported
    first = names.setdefault(name, element)
    if first is not element:
        report(wrong(element, f"duplicate name '{name}'; the first is at {file_of(first)}:{line_of(first)}"))


def _signature(root: Element) -> list[tuple[object, ...]]:
    """The content of a definition without prose and line breaks, to compare definitions."""
    return [
        (element.tag, *sorted((key, " ".join(str(text).split())) for key, text in element.items() if key not in _PROSE))
        for element in root.iter()
    ]


_PROSE = frozenset(("interpretation", "{http://www.w3.org/XML/1998/namespace}space"))


class Library:
    """The sets of all files by id and version."""

    def __init__(self, report: Report = refuse) -> None:
        self.roots: dict[tuple[str, Key], Element] = {}
        self.scopes: dict[tuple[str, Key], NameScope] = {}
        self._report = report

    def add(self, root: Element) -> bool:
        """Add a root element; False if the same content is known already, since sets may be in several folders."""
        key = (str(root.tag), identity(root))
        first = self.roots.get(key)
        if first is not None:
            if _signature(first) != _signature(root):
                where = f"{file_of(first)}:{line_of(first)}"
                self._report(wrong(root, f"{key[1][0]} {key[1][1]} is defined differently at {where}"))
            return False
        self.roots[key] = root
        self.scopes[key] = scope_of(root, self._report)
        return True

    def link(self, report: Report = refuse) -> None:
        """Resolve the references between sets."""
        for scope in self.scopes.values():
            self._link(scope.const_sets.values(), "declared_const_set", scope.linked_consts, report)
            self._link(scope.type_sets.values(), "declared_type_set", scope.linked_types, report)

    def _link(self, references: Iterable[Element], tag: str, links: dict[str, NameScope], report: Report) -> None:
        for reference in references:
            if "id" not in reference.attrib or "version" not in reference.attrib:
                continue  # violates the grammar
            key = identity(reference)
            found = self.scopes.get((tag, key))
            if found is None:
                known = [" ".join(other) for kind, other in self.scopes if kind == tag]
                reason = (
                    f"no {tag} {key[0]} {key[1]} is loaded{suggestion(' '.join(key), known)}; {give_its_file(key[0])}"
                )
                report(wrong(reference, reason))
            else:
                links[required(reference, "name")] = found
