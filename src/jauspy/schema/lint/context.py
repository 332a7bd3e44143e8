"""Context, rules and findings of the linter. Mistakes are collected where the loader would stop."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Literal, TypeAlias, TypeVar

from lxml.etree import _Element as Element

from jauspy.errors import SchemaError
from jauspy.schema.behavior import read_behavior
from jauspy.schema.document import identity, is_unexpected, problems
from jauspy.schema.inheritance import lineage
from jauspy.schema.library import Key, Library, NameScope
from jauspy.schema.loader import Identity, builtin_roots, parse_file
from jauspy.schema.model import Behavior, MessageDefinition, ServiceDefinition, SourceLocation
from jauspy.schema.services import matches_version, read_message, version_key

Thing = TypeVar("Thing")
MESSAGES = ("message_def", "declared_message_def")


class LintContext:
    """The files to be checked, and the built-in definitions that they may refer to."""

    def __init__(self, paths: Iterable[Path]) -> None:
        self.paths = tuple(paths)
        self.unreadable: list[SchemaError] = []
        self.grammar: list[SchemaError] = []
        self.duplicates: list[SchemaError] = []
        self.unlinked: list[SchemaError] = []
        self.too_deep = False
        self._broken: list[Element] = []
        self._unexpected: set[Element] = set()
        self._library = Library(self.duplicates.append)
        self._own = [root for root in map(self._read, self.paths) if root is not None]
        self._context = self._add_builtin()
        self._link()
        self._versions: dict[str, list[tuple[Key, Element]]] = {}
        for (tag, key), root in self._library.roots.items():
            if tag == "service_def":
                self._versions.setdefault(key[0], []).append((key, root))
        self._behaviors: dict[Element, Behavior | None] = {}
        self._messages: dict[Element, MessageDefinition | None] = {}

    def _read(self, path: Path) -> Element | None:
        """Read a file and add its root to the library; None if that is not possible, or if it is known already."""
        try:
            root = parse_file(path)
        except SchemaError as error:
            self.unreadable.append(error)
            return None
        broken = list(problems(root))
        self.grammar += (problem for _, problem in broken)
        self._broken += (element for element, _ in broken)
        self._unexpected.update(element for element, _ in broken if is_unexpected(element))
        try:
            if not self._library.add(root):
                return None
        except SchemaError as error:  # its id or version is missing
            self.grammar.append(error)
            return None
        for element, problem in broken:
            self._mark_unsound(element, problem, self.scope(root))
        return root

    def _mark_unsound(self, element: Element, problem: SchemaError, scope: NameScope) -> None:
        """Note that the declared type around a mistake cannot be read."""
        for inside in (element, *element.iterancestors()):
            name = inside.get("name")
            if name is not None and scope.types.get(name) is inside:
                scope.unsound[name] = problem

    def _add_builtin(self) -> list[Element]:
        """Add the built-in definitions, except those that the files define themselves."""
        self.identities: set[Identity] = {(tag, *key) for tag, key in self._library.roots}
        roots = (root for key, (_, root) in builtin_roots().items() if key not in self.identities)
        return [root for root in roots if self._library.add(root)]

    def _link(self) -> None:
        self._library.link(self.unlinked.append)

    # --- elements ----------------------------------------------------------------------------------------------

    def elements(self, *tags: str) -> Iterator[tuple[Element, NameScope]]:
        """The elements of the checked files with these tags, each with the scope of its names."""
        for root in self._own:
            scope = self.scope(root)
            for element in root.iter(*tags):
                yield element, scope

    def scope(self, root: Element) -> NameScope:
        """The names known in a file."""
        return self._library.scopes[str(root.tag), identity(root)]

    def services(self) -> Iterator[Element]:
        """The services of the checked files."""
        return (root for root in self._own if root.tag == "service_def")

    def all_services(self) -> Iterator[Element]:
        """The services of the checked files, then the built-in ones."""
        yield from self.services()
        yield from (root for root in self._context if root.tag == "service_def")

    def messages(self, service: Element, *directions: str) -> Iterator[Element]:
        """The message elements of a service: of its `input_set`, its `output_set`, or both."""
        for direction in directions or ("input_set", "output_set"):
            for part in service.iterfind(f"message_set/{direction}"):
                yield from part.iterchildren(*MESSAGES)

    def code(self, element: Element) -> str:
        """The message id of a message, as written in its definition; empty if that is missing."""
        if element.tag == "message_def":
            return element.get("message_id", "").strip().upper()
        scope = self.scope(element.getroottree().getroot())
        found = self.attempt(lambda: scope.find(element))
        return found[1].get("message_id", "").strip().upper() if found else ""

    def parent(self, service: Element) -> Element | None:
        """The service it inherits from, if that is loaded."""
        reference = service.find("references/inherits_from")
        if reference is None or self.attempt(lambda: identity(reference)) is None:
            return None
        urn, wanted = identity(reference)
        found = [(key, root) for key, root in self._versions.get(urn, ()) if matches_version(key[1], wanted)]
        return max(found, key=lambda item: _order(item[0]))[1] if found else None

    def replaced(self, service: Element) -> Element | None:
        """The built-in definition that a checked service replaces, if there is one."""
        key: Identity = ("service_def", *identity(service))
        return builtin_roots()[key][1] if key in self.identities and key in builtin_roots() else None

    def lineage(self, service: Element) -> tuple[Element, ...]:
        """A service and its ancestors, nearest first."""
        return lineage(service, self.parent)

    # --- the loader --------------------------------------------------------------------------------

    def is_sound(self, element: Element) -> bool:
        """True if an element and its content follow the grammar, so that the loader can read it."""
        inside = not any(element is broken or element in broken.iterancestors() for broken in self._broken)
        return inside and not any(around in self._unexpected for around in element.iterancestors())

    def attempt(self, read: Callable[[], Thing]) -> Thing | None:
        """The result of the loader, or None if it raises `SchemaError`; always None after types nested too deeply."""
        if self.too_deep:
            return None
        try:
            return read()
        except SchemaError:
            return None
        except RecursionError:
            self.too_deep = True  # every other type could take as long
            return None

    def behavior(self, service: Element) -> Behavior | None:
        """The behaviour of a service, as far as it can be read."""
        if service not in self._behaviors:
            element = service.find("protocol_behavior")
            readable = element is not None and self.is_sound(element)
            inputs = {message.get("name", "") for message in self.messages(service, "input_set")}
            self._behaviors[service] = self.attempt(lambda: read_behavior(element, inputs)) if readable else None
        return self._behaviors[service]

    def definition(self, service: Element) -> ServiceDefinition:
        """A service for merging state machines: its identity, and its behaviour as far as it can be read."""
        name, id, version = (service.get(key, "") for key in ("name", "id", "version"))
        return ServiceDefinition(name=name, id=id, version=version, jsidl="", behavior=self.behavior(service))

    def message(self, element: Element) -> MessageDefinition | None:
        """A message, as far as it can be read."""
        if element not in self._messages:
            scope = self.scope(element.getroottree().getroot())
            readable = self.is_sound(element)
            self._messages[element] = self.attempt(lambda: read_message(element, scope)) if readable else None
        return self._messages[element]


def _order(key: Key) -> tuple[int, ...]:
    try:
        return version_key(key[1])
    except ValueError:
        return ()


Severity: TypeAlias = Literal["error", "warning", "hint"]
"""An error breaks a tool or the encoding, a warning may do so, a hint makes the definition harder to use."""

Problem: TypeAlias = tuple[SourceLocation, str]
"""The location, and a sentence with the problem and its solution."""


@dataclass(frozen=True, slots=True, order=True)
class LintFinding:
    """One finding; sorted by location."""

    file: str
    line: int
    code: str
    severity: Severity
    message: str

    def __str__(self) -> str:
        return f"{self.file}:{self.line}: {self.severity}: {self.code}: {self.message}"


@dataclass(frozen=True, slots=True)
class LintRule:
    """A lint rule: its code, its meaning, and the function that checks all files."""

    code: str
    severity: Severity
    summary: str
    check: Callable[[LintContext], Iterator[Problem]]
