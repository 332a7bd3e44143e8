"""`jauspy new component`: a package with a component, ready to run, and its tests."""

from __future__ import annotations

import keyword
import sys
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from importlib.machinery import PathFinder
from itertools import starmap
from pathlib import Path
from typing import Annotated, Final

import typer

from jauspy.cli import console
from jauspy.cli.new import write_new_folder
from jauspy.codec.codegen import indent
from jauspy.codec.layout import Composite, Repeat
from jauspy.codec.names import class_name, unique
from jauspy.codec.registry import MessageEntry
from jauspy.codec.source import docstring, quote
from jauspy.codec.stubs import MessageKey, make_stubs
from jauspy.errors import ConfigError
from jauspy.ids import JausID, component_id
from jauspy.messages import registry
from jauspy.schema import load_builtin
from jauspy.schema.inheritance import lineage, parents_among
from jauspy.schema.loader import find_files, load_beside_builtin, load_own
from jauspy.schema.model import Schema, ServiceDefinition as Definition
from jauspy.services.binding import RequiredMethod, required_methods
from jauspy.services.core import INHERITED_DEFAULTS, with_core_services
from jauspy.services.service import Service


def component(
    *,
    name: Annotated[str, typer.Argument(metavar="NAME", help="The package and its folder, as in winch.")],
    service: Annotated[
        str | None,
        typer.Option(
            "--service",
            metavar="URN",
            help="The service: its URN or the end of it, as in ugv:ParkingBrakeDriver. Default: that of --schemas.",
        ),
    ] = None,
    version: Annotated[str | None, typer.Option("--version", metavar="X.Y", help="Default: the newest.")] = None,
    source: Annotated[
        Path | None,
        typer.Option(
            "--schemas",
            metavar="FILE|DIR",
            help="Your own JSIDL file, or a folder with it and the types that it refers to; copied into the package.",
        ),
    ] = None,
    id: Annotated[str, typer.Option("--id", metavar="ID", help="The component's id.")] = "101.1.120",
) -> None:
    """Write a package with a component that offers a service: methods, a program, tests and a README.

    The program runs and the tests pass without changes; complete the methods. Reports that may be empty are; any other
    method is marked TODO, and each call of it is counted as host.to_do.

    Examples:
      jauspy new component brake --service ugv:ParkingBrakeDriver
      jauspy new component battery --schemas battery.xml
      jauspy new component winch --service Winch --schemas vendor/
    """
    _check(name)
    me = component_id(id)
    schema = _schema(source)
    definition = _find(schema, _only_service(source) if service is None else service, version, source)
    write_new_folder(Path(name), package(name, definition, schema, source, me))
    console.print_lines(f"run it with `python -m {name}`, test it with `pytest {name}` (pip install pytest-asyncio)")


def _check(name: str) -> None:
    """Raise `ConfigError` unless the name is that of a package and of no installed module."""
    if not name.isidentifier() or name != name.lower() or keyword.iskeyword(name):
        raise ConfigError(f"{name!r} is not the name of a Python package; use lower-case letters, digits and _")
    if _is_installed(name):
        raise ConfigError(f"{name} is the name of an installed module; choose another name, as in my_{name}")


def _is_installed(name: str) -> bool:
    """True if a module of this name is found outside of the current directory."""
    elsewhere = [folder for folder in sys.path if Path(folder).resolve() != Path.cwd()]
    known = {*sys.stdlib_module_names, "pytest", "pytest_asyncio", "conftest"}  # the tests need these, installed or not
    return name in known or PathFinder.find_spec(name, elsewhere) is not None


def _schema(source: Path | None) -> Schema:

    return load_builtin() if source is None else load_beside_builtin(_files(source))


def _files(source: Path) -> list[Path]:
    """The JSIDL files of a file or folder."""
    return find_files([source]) if source.is_dir() else [source]


def _find(schema: Schema, name: str, version: str | None, source: Path | None) -> Definition:
    """The definition with this name or end of a name; raises `ConfigError` with similar names."""
    wanted = name.casefold()
    urns = {
        service.id
        for service in schema.services
        if service.id.casefold() == wanted or service.id.casefold().endswith(f":{wanted}")
    }
    if len(urns) > 1:
        raise ConfigError(f"several services are called {name}: {', '.join(sorted(urns))}; give the whole URN")
    if not urns:
        known = sorted({service.id for service in schema.services})
        close = get_close_matches(name.rpartition(":")[2], [urn.rpartition(":")[2] for urn in known], 3)
        more = "--schemas reads your own" if source is None else f"{source} does not define it"
        hint = f"did you mean {' or '.join(close)}?" if close else f"`jauspy schema ls` lists them; {more}"
        raise ConfigError(f"no service {name!r} is known; {hint}")
    (urn,) = urns
    versions = [service.version for service in schema.services if service.id == urn]
    if version is not None and version not in versions:
        raise ConfigError(f"{urn} has no version {version}; it has {', '.join(versions)}")
    return schema.service(urn, version)


def _only_service(source: Path | None) -> str:
    """The URN of the one service that the user's files define; raises `ConfigError`, which lists several."""
    if source is None:
        raise ConfigError("name the service with --service; `jauspy schema ls` lists those that are built in")
    (first, *more) = sorted({service.id for service in load_own([source]).services}) or [""]
    if more or not first:
        listed = f"{source} defines {', '.join((first, *more))}" if first else f"{source} defines no service"
        raise ConfigError(f"{listed}; name one with --service")
    return first


FOLDER: Final = "definitions"
"""The folder of the package with the definitions of a user's folder."""
MESSAGES: Final = "messages"
"""The module of the package with the messages of a user's definitions."""
_ENDS: Final = {"action": "", "predicate": "", "report": "; None sends nothing"}
_RESULTS: Final[dict[str, list[str]]] = {"action": [], "predicate": ["return True"], "report": ["return None"]}
TO_DO: Final = "to_do"
"""Counter of calls of a method that is not written yet."""


def package(
    name: str, definition: Definition, schema: Schema, source: Path | None, me: JausID
) -> dict[str, str | bytes]:
    """The files of the package, by name."""
    line = lineage(definition, parents_among(schema.services))
    core = core_services()
    if definition.id in core:
        kind = core[definition.id]
        theirs = f"{kind.__module__}.{kind.__name__}"
        raise ConfigError(
            f"jauspy provides {definition.id} in every component; to change its behaviour, subclass {theirs}"
        )
    mine = [service for service in line if service.id not in core]
    beside = "" if source is None else FOLDER if source.is_dir() else source.name
    definitions = Schema(services=()) if source is None else load_own([source])
    stubs = make_stubs(definitions, [beside])
    own_definitions = _OwnDefinitions(
        f"{name}.{MESSAGES}", {service.key for service in definitions.services}, stubs.names
    )
    writer = _Writer(mine, line, core, own_definitions)
    whole = JausID(me.subsystem or 101, me.node or 1, me.component)  # the tests need an id even if it is assigned later
    urns = "".join(f"            {quote(service.id)},\n" for service in mine)
    files: dict[str, str | bytes] = {
        "__init__.py": "\n".join([*docstring(f"A JAUS component that offers {definition.id}."), ""]),
        "__main__.py": _MAIN.format(name=name, id=me),
        "services.py": writer.module(),
        f"test_{name}.py": _TEST.format(name=name, id=whole, number=whole.subsystem, last=whole.component, urns=urns),
        "README.md": _README.format(name=name, urn=definition.id, version=definition.version),
    }
    if source is not None:
        files |= {f"{MESSAGES}.py": stubs.module, f"{MESSAGES}.pyi": stubs.stub}
        if source.name in files:
            raise ConfigError(f"{source} has the name of a file of the package; rename it, as in {name}.xml")
        for file in _files(source):
            files[f"{FOLDER}/{file.relative_to(source)}" if source.is_dir() else source.name] = file.read_bytes()
    return files


def core_services() -> dict[str, type[Service]]:
    """The classes of the core services, which are added to every component, and of base services."""
    given = {service.urn: type(service) for service in with_core_services([], "")}
    return given | {urn: type(make()) for urn, make in INHERITED_DEFAULTS.items()}


@dataclass(frozen=True, slots=True)
class _OwnDefinitions:
    """The user's services, and the module with their messages."""

    module: str
    services: Collection[tuple[str, str]]
    """URN and version of each."""
    messages: Mapping[MessageKey, str]
    """The names in the module."""


class _Writer:
    """Writes the module with the classes, and collects the messages to import."""

    def __init__(
        self, mine: list[Definition], line: Sequence[Definition], core: dict[str, type[Service]], own: _OwnDefinitions
    ) -> None:
        self._mine, self._line, self._core, self._own = mine, line, core, own
        self._imports: dict[str, set[str]] = {}
        taken = {
            "registry",
            *own.messages.values(),
            *(message.name for service in line for message in service.messages),
        }
        self._names: dict[str, str] = {}
        for service in mine:
            taken.add(self._names.setdefault(service.id, unique(class_name(service.name), taken.__contains__)))

    def module(self) -> str:
        """The source of the module."""
        classes = "\n\n".join(self._class(service) for service in reversed(self._mine))
        names = ", ".join(f"{self._names[service.id]}()" for service in self._mine)
        own_names = self._imports.pop(self._own.module, None)
        imports = "import jauspy\n" + "".join(starmap(_import, sorted(self._imports.items())))
        if own_names is not None:
            imports += "\n" + _import(self._own.module, own_names)
        head = '"""Services of the component: fill in the methods."""\n\nfrom __future__ import annotations'
        return f"{head}\n\n{imports}\n\n{classes}{_SERVICES.format(names=names)}"

    def _class(self, definition: Definition) -> str:
        more = f"version={quote(definition.version)}"
        if definition.key in self._own.services:
            more = "definitions=registry"
            self._imports.setdefault(self._own.module, set()).add("registry")
        needs = {method.method: method for method in reversed(required_methods(definition))}  # the first of each name
        methods = [
            self._method(definition, need) for need in reversed(needs.values()) if not self._inherits(definition, need)
        ]
        lines = [
            *_class_statement(self._names[definition.id], f"jauspy.Service, urn={quote(definition.id)}, {more}"),
            *indent(docstring(f"{definition.name} {definition.version}.")),
        ]
        return "\n".join([*lines, *methods, ""])

    def _inherits(self, definition: Definition, need: RequiredMethod) -> bool:
        """True if a parent class has this method."""
        for parent in self._line[self._line.index(definition) + 1 :]:
            kind = self._core.get(parent.id)
            if kind is None:
                if any(method.method == need.method for method in required_methods(parent)):
                    return True
            elif not kind.private and callable(getattr(kind, need.method, None)):
                return True
        return False

    def _method(self, definition: Definition, need: RequiredMethod) -> str:
        parameters = ["self"]
        if need.takes_message:
            word = "query" if all(message.startswith("Query") for message in need.messages) else "msg"
            parameters.append(
                f"{word}: {' | '.join(dict.fromkeys(self._type(definition, message) for message in need.messages))}"
            )
        if need.literals:
            parameters.append("code: str")
        reports = need.kind == "report" or bool(need.reports)
        kind = "report" if reports else need.kind
        result = {"action": "None", "predicate": "bool"}.get(kind) or self._optional(definition, need.reports)
        when = ", ".join([*need.messages, *need.events, *(f"state {state}" for state in need.in_states)])
        purpose = {"action": "Action on", "predicate": "Guard of", "report": "The answer to"}[kind]
        empty = self._empty_report(definition, need.reports) if kind == "report" else ""
        body = docstring(f"{purpose} {_short(when)}{_ENDS[kind]}.")
        if empty:
            body += ["# TODO: what it reports", *_returned(empty)]
        else:
            body += [f'self.host.count("{TO_DO}", "{need.method}")  # TODO', *_RESULTS[kind]]
        return "\n".join(["", _signature(need.method, ", ".join(parameters), result), *indent(body, 2)])

    def _empty_report(self, definition: Definition, name: str) -> str:
        """An expression that makes a report without any value; empty if its fields need values."""
        line = self._line[self._line.index(definition) :]
        owner = next((service for service in line if any(m.name == name for m in service.messages)), None)
        if owner is None or MessageKey(owner.id, owner.version, name) in self._own.messages:
            return ""
        layout = _built_in(owner, name).load().layout()
        if not isinstance(layout, Composite):
            return ""
        required = [slot for slot in layout.slots if not slot.optional]
        if not all(isinstance(slot.item, Repeat) and slot.item.count.minimum == 0 for slot in required):
            return ""
        return f"{self._type(definition, name)}({', '.join(f'{slot.name}=[]' for slot in required)})"

    def _optional(self, definition: Definition, name: str) -> str:
        return f"{self._type(definition, name) if name else 'jauspy.Message'} | None"

    def _type(self, definition: Definition, name: str) -> str:
        line = self._line[self._line.index(definition) :]
        owner = next((service for service in line if any(m.name == name for m in service.messages)), definition)
        own_name = self._own.messages.get(MessageKey(owner.id, owner.version, name))
        if own_name is not None:
            self._imports.setdefault(self._own.module, set()).add(own_name)
            return own_name
        entry = _built_in(owner, name)
        self._imports.setdefault(entry.module, set()).add(entry.cls)
        return entry.cls


def _built_in(owner: Definition, name: str) -> MessageEntry:
    """The message of a service that is built in."""
    code = next(message.code for message in owner.messages if message.name == name)
    return next(
        entry
        for entry in registry.entries_of(code)
        if (entry.service, entry.version, entry.name) == (owner.id, owner.version, name)
    )


def _import(module: str, names: set[str]) -> str:
    return f"from {module} import (\n{''.join(f'    {name},{chr(10)}' for name in sorted(names, key=_order))})\n"


def _order(name: str) -> tuple[bool, str]:
    """The order of ruff's import sorting: constants first."""
    return not name.isupper(), name


def _signature(name: str, parameters: str, result: str) -> str:
    line = f"    def {name}({parameters}) -> {result}:"
    return line if len(line) <= 120 else f"    def {name}(\n        {parameters}\n    ) -> {result}:"


def _class_statement(name: str, arguments: str) -> list[str]:
    line = f"class {name}({arguments}):"
    return [line] if len(line) <= 120 else [f"class {name}(", f"    {arguments}", "):"]


def _returned(call: str) -> list[str]:
    """A return of a call, as ruff formats it in a method."""
    line = f"return {call}"
    if len(line) <= 112:
        return [line]
    name, _, arguments = call.partition("(")
    return [f"return {name}(", f"    {arguments.removesuffix(')')}", ")"]


def _short(text: str) -> str:
    return text if len(text) <= 70 else f"{text[:66]} ..."


_SERVICES: Final = '''

def services() -> list[jauspy.Service]:
    """Everything that the component offers."""
    return [{names}]
'''

_MAIN: Final = '''"""`python -m {name}`: runs until Ctrl-C, beside a node manager."""

import jauspy

from {name}.services import services

if __name__ == "__main__":
    jauspy.run(jauspy.Component("{id}", services(), name="{name}"))
'''

_TEST: Final = '''"""Tests of the component, in memory and on virtual time."""

from __future__ import annotations

import jauspy
import pytest
from jauspy.messages.core import QueryStatus
from jauspy.testing import VirtualNetwork

from {name}.services import services


@pytest.mark.asyncio
async def test_it_is_found_with_its_services(virtual_network: VirtualNetwork, ocu: jauspy.OCU) -> None:
    """Discovery finds the services, and the component answers."""
    async with virtual_network.component("{id}", services(), name="{name}") as component:
        robot = await ocu.discover({number})
        found = robot.component({last}).info
        assert found.name == "{name}"
        assert {{service.urn for service in found.services}} >= {{
{urns}        }}
        assert (await ocu.query("{id}", QueryStatus())).status is not None
        assert "host.action_failed" not in component.counters
'''

_README: Final = """# {name}

A JAUS component that offers {urn} {version}.

    python -m {name}        # beside a node manager: jauspy node-manager
    pytest {name}           # with pytest-asyncio: pip install pytest-asyncio

The services are in `services.py`; jauspy's `docs/components.md` describes how to write them. Methods that are not
written yet are marked TODO: each call of one is counted as `host.to_do` in the component's counters, and a query that
needs one is not answered.
"""
