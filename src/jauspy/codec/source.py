"""Message classes as Python source, for `jauspy.messages` and `jauspy schema generate`.

Only declarations are written: constants, nested classes, fields, layouts. Texts of a definition become string literals
and docstrings.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import MISSING, fields
from importlib import import_module
from types import NoneType, UnionType
from typing import Any, Final, get_args, get_origin

from jauspy.codec.build import MessageModule, Package, build
from jauspy.codec.codegen import indent, keywords_only
from jauspy.codec.items import Bit, Bits, Blob, Choice, Count, Formatted, Item, Number, Real, Text, Values
from jauspy.codec.layout import Composite, Grid, Repeat, Slot, Union
from jauspy.codec.message import Message, Struct
from jauspy.codec.names import module_alias, version_key
from jauspy.codec.registry import Registry
from jauspy.printable import printable
from jauspy.schema.model import Schema

MAX_WIDTH: Final = 108
"""Characters of a line that lists things, without its indentation."""

NOTE: Final = "Generated from schemas/; do not edit."

PARTS: Final = {"exp": "iop"}
"""Sets whose messages are also exported by the package of another set."""


def generate(schema: Schema, package: str = "jauspy.messages", base: str | None = None) -> dict[str, str]:
    """The source of all files of `package`, by path relative to it; its registry is layered over that of `base`.

    Raises `SchemaError` for what cannot be decoded in bounded time, and for lists that are nested too deeply.
    """
    below: Registry | None = import_module(base).registry if base else None
    built = build(schema, package, below)
    files = {f"{_path(module.name)}.py": _Writer(module, package).text() for module in built.modules}
    files |= _packages(built)
    files["__init__.py"] = _root(package, base)
    files["_table.py"] = _table(built, with_files=base is not None)
    return dict(sorted(files.items()))


def _path(name: str) -> str:
    return name.replace(".", "/")


def quote(text: str) -> str:
    """A string literal, in double quotes where it contains none."""
    return f'"{repr(text)[1:-1]}"' if "'" not in text and '"' not in text else repr(text)


def docstring(text: str) -> list[str]:
    """The lines of a docstring."""
    lines = [_escaped(line) for line in text.split("\n")]
    return [f'"""{lines[0]}"""'] if len(lines) == 1 else [f'"""{lines[0]}', *lines[1:-1], f'{lines[-1]}"""']


def type_source(kind: Any, ref: Callable[[type], str]) -> str:
    """The type of a field; `ref` returns the name of a class."""
    if isinstance(kind, UnionType):
        return " | ".join(type_source(part, ref) for part in get_args(kind))
    if get_origin(kind) is list:
        return f"list[{type_source(get_args(kind)[0], ref)}]"
    return "None" if kind is NoneType else ref(kind)


def filled(parts: Iterable[str]) -> list[str]:
    """Join parts to lines of at most `MAX_WIDTH` characters."""
    lines: list[str] = []
    for part in parts:
        if lines and len(lines[-1]) + 1 + len(part) <= MAX_WIDTH:
            lines[-1] += f" {part}"
        else:
            lines.append(part)
    return lines


def _escaped(line: str) -> str:
    """A line without line breaks and without the end of a docstring."""
    plain = printable(line.replace("\\", "\\\\"))
    return plain.replace('"', '\\"') if '"""' in plain or plain.endswith('"') else plain


class _Writer:
    """Writes one module."""

    def __init__(self, module: MessageModule, package: str) -> None:
        self._module = module
        self._package = package
        self._own = f"{package}.{module.name}"
        self._others: set[str] = set()
        self._refs = 0

    def text(self) -> str:
        body: list[str] = []
        for cls in _reports_first(self._module.classes):
            body += ["", *self._class(cls)] if cls.__mro__[1] not in (Struct, Message) else ["", "", *self._class(cls)]
        return "\n".join([*self._head("\n".join(body)), *body, ""])

    def _head(self, body: str) -> list[str]:
        lines = [*docstring(f"{self._module.doc} {NOTE}"), "", "from __future__ import annotations", ""]
        lines += ["from enum import IntEnum"] if "(IntEnum)" in body else []
        lines += ["from jauspy.codec import declare as jd"]
        lines += [f"from {self._package} import registry as _registry"] if re.search(r"\b_registry\b", body) else []
        for name in sorted(self._others):
            head, _, tail = name.rpartition(".")
            lines.append(f"from {head} import {tail} as {self._alias(name)}")
        service = (self._module.service, self._module.version)
        return [*lines, "", f"_SERVICE = jd.Service({', '.join(map(quote, service))})"] if all(service) else lines

    def _alias(self, module: str) -> str:
        return module_alias(module.removeprefix(f"{self._package}."))

    def _ref(self, cls: type) -> str:
        """The name of a class in this module."""
        if cls.__module__ == "builtins":
            return cls.__name__
        if cls is Message:
            return "jd.Message"
        self._refs += 1
        if cls.__module__ == self._own:
            return cls.__qualname__
        self._others.add(cls.__module__)
        return f"{self._alias(cls.__module__)}.{cls.__qualname__}"

    def _class(self, cls: type[Struct]) -> list[str]:
        """A class with its nested ones, from the decorator on."""
        names, base = cls.__dict__, cls.__mro__[1]
        doc = docstring(cls.__doc__ or "")
        report = [f"REPORT = {self._ref(names['REPORT'])}"] if "REPORT" in names else []
        if base not in (Struct, Message):
            body = [*(doc if cls.__doc__ != base.__doc__ else []), *report]
            head = f"class {cls.__name__}({self._ref(base)}):"
            return ["@jd.derived(_SERVICE)", *([head, *indent(body)] if body else [f"{head} ..."])]
        layout = cls.layout()
        nested = {name: part for name, part in names.items() if isinstance(part, type) and name != "REPORT"}
        lines = [
            *doc,
            *report,
            *(f"{name} = {self._ref(inner)}" for name, inner in nested.items() if not is_nested(inner, cls)),
        ]
        for part in nested.values():
            if is_nested(part, cls):
                lines += ["", *(self._class(part) if issubclass(part, Struct) else enum_class(part))]
        body = self._fields(cls, layout)
        lines += ["", *body] if any(is_nested(part, cls) for part in nested.values()) else body
        return [f"@jd.{self._decorator(cls, layout)}", f"class {cls.__name__}(jd.{base.__name__}):", *indent(lines)]

    def _decorator(self, cls: type[Struct], layout: Item) -> str:
        match layout:
            case Composite():
                arguments = [quote(layout.presence)] if layout.presence else []
                if issubclass(cls, Message):
                    names = [f"0x{cls.CODE:04X}", *([quote(cls.NAME)] if cls.__name__ != cls.NAME else [])]
                    arguments = ["_SERVICE", *names, *(f"presence={argument}" for argument in arguments)]
                    arguments += ["command=True"] * cls.IS_COMMAND + ["query=True"] * cls.IS_QUERY
                arguments += ["kw_only=True"] * keywords_only(layout.slots)
                return f"{'message' if issubclass(cls, Message) else 'record'}({', '.join(arguments)})"
            case Bits():
                return f"bit_field({quote(layout.code)})"
            case Choice():
                pairs = ", ".join(f"{index}: {self._item(number)}" for index, number in layout.items.items())
                return f"variable(lambda cls: jd.Choice(cls, {{{pairs}}}, {self._values(layout.index)}))"
            case Formatted():
                nested = f", _registry, frozenset({set(layout.nested_formats)})" if layout.nested else ""
                made = f"cls, {self._values(layout.formats)}, {_count(layout.count)}{nested}"
                return f"variable(lambda cls: jd.Formatted({made}))"
            case _:
                raise AssertionError(layout)

    def _fields(self, cls: type[Struct], layout: Item) -> list[str]:
        parts: dict[str, Slot | Bit] = {}
        if isinstance(layout, Composite):
            parts = {slot.name: slot for slot in layout.slots}
        elif isinstance(layout, Bits):
            parts = {bit.name: bit for bit in layout.bits}
        found: Any = fields(cls)  # type: ignore[arg-type]  # built classes are dataclasses
        return [
            f"{one.name}: {type_source(one.type, self._ref)}{self._value(one.default, parts.get(one.name))}"
            for one in found
        ]

    def _value(self, default: object, part: Slot | Bit | None) -> str:
        match part:
            case Slot():
                value = f"0x{default:X}" if isinstance(default, int) else repr(default)  # a presence vector, or None
                known = "" if default is MISSING else f", default={value}"
                return f" = jd.field({quote(part.jaus)}, {self._lazy(part.item)}{known})"
            case Bit():
                values = "" if part.values.anything else f", {self._lazy(part.values)}"
                return f" = jd.bits({part.shift}, 0x{part.mask:X}{values})"
            case None:
                return "" if default is MISSING else f" = {default!r}"

    def _lazy(self, part: Item | Values) -> str:
        """An expression; where it refers to classes, a function, as these may not be complete yet."""
        before = self._refs
        text = self._values(part) if isinstance(part, Values) else self._item(part)
        return text if self._refs == before else f"lambda: {text}"

    def _values(self, values: Values) -> str:
        if values.anything:
            return "jd.ANY"
        enum = self._ref(values.enum) if values.enum else "None"
        return f"jd.Values({enum}{f', {values.intervals!r}' if values.intervals else ''})"

    def _item(self, item: Item) -> str:
        match item:
            case Real():
                units = "" if item.units == "one" else f", {quote(item.units)}"
                scale = item.scaling
                function = "" if scale.function == "round" else f", function={quote(scale.function)}"
                return f"jd.real({quote(item.code)}, {scale.lower!r}, {scale.upper!r}{units}{function})"
            case Number():
                units = "" if item.units == "one" else f", {quote(item.units)}"
                values = "" if item.values.anything and not units else f", {self._values(item.values)}"
                return f"jd.Number({quote(item.code)}{values}{units})"
            case Text():
                return f"jd.Text(count={_count(item.count)})" if item.count else f"jd.Text({item.length})"
            case Blob():
                return f"jd.Blob({_count(item.count)}{', _registry' if item.nested else ''})"
            case Repeat():
                return f"jd.Repeat({_count(item.count)}, {self._item(item.item)})"
            case Union():
                arms = [f"{name}={self._ref(arm.cls)}" for name, arm in item.arms.items()]
                return f"jd.Union.of({', '.join([quote(item.code), *arms])})"
            case Grid():
                return f"jd.Grid({self._item(item.item)}, {item.sizes!r})"
            case Composite() | Bits() | Choice() | Formatted():
                return f"{self._ref(item.cls)}.layout()"
            case _:
                raise AssertionError(item)


def _count(count: Count) -> str:
    return f"jd.Count({quote(count.code)}, {count.minimum}, {count.maximum})"


def is_nested(part: type, cls: type) -> bool:
    """True for a class nested in another one, not only offered by it."""
    return part.__module__ == cls.__module__ and part.__qualname__ == f"{cls.__qualname__}.{part.__name__}"


def _reports_first(classes: Iterable[type[Struct]]) -> Iterable[type[Struct]]:
    """Each report before its query, which names it."""
    return dict.fromkeys(part for cls in classes for part in (cls.__dict__.get("REPORT", cls), cls))


def enum_class(cls: Any) -> list[str]:
    """An enumeration."""
    return [f"class {cls.__name__}(IntEnum):", *indent(f"{one.name} = {one.value}" for one in cls)]


def _root(package: str, base: str | None) -> str:
    """The package itself: its registry, layered over that of `base`."""
    layers = [f"from {base} import registry as _base"] if base else []
    names, arguments = ("FILES, TABLE", "TABLE, _base, FILES") if base else ("TABLE", "TABLE")
    return "\n".join(
        [
            f'"""Messages, one package per service set. {NOTE}"""',
            "",
            "from __future__ import annotations",
            "",
            "from typing import Final",
            "",
            "from jauspy.codec.registry import Registry",
            *layers,
            f"from {package}._table import {names}",
            "",
            f"registry: Final = Registry({arguments})",
            '"""All messages, by name and by code; modules are imported on use."""',
            "",
        ]
    )


def _table(built: Package, *, with_files: bool) -> str:
    """`_table.py`: code, name, service, version and module of every message; and the file of every service."""
    rows: list[str] = []
    digests = {(entry.module, entry.cls): entry.digest for entry in built.registry.entries}
    for module in sorted(built.modules, key=lambda module: module.name):
        place = ", ".join(map(quote, (f"{built.name}.{module.name}", module.service, module.version)))
        messages = [
            _row(cls, digests[cls.__module__, cls.__name__]) for cls in module.classes if issubclass(cls, Message)
        ]
        if messages:
            rows += ["*entries(", *indent([f"{place},", *filled(messages)]), "),"]
    places = sorted(built.registry.files.items())
    files = [f"({quote(urn)}, {quote(version)}): {quote(file)}," for (urn, version), file in places]
    return "\n".join(
        [
            f'"""Which messages there are, and where. {NOTE}"""',
            "",
            "from __future__ import annotations",
            "",
            "from typing import Final",
            "",
            "from jauspy.codec.registry import entries",
            "",
            "TABLE: Final = (",
            *indent(rows),
            ")",
            *(["FILES: Final = {", *indent(files), "}"] if with_files else []),
            "",
        ]
    )


def _row(cls: type[Message], digest: str) -> str:
    other = f", {quote(cls.__name__)}" if cls.__name__ != cls.NAME else ""
    return f"(0x{cls.CODE:04X}, {quote(cls.NAME)}, {quote(digest)}{other}),"


def _packages(built: Package) -> dict[str, str]:
    """The `__init__.py` of every set and version, by path."""
    groups: dict[str, list[MessageModule]] = {}
    for module in built.modules:
        family, version, _ = module.name.split(".")
        groups.setdefault(family, []).append(module)
        groups.setdefault(f"{family}.{version}", []).append(module)
    for part, whole in PARTS.items():
        groups.get(whole, []).extend(groups.get(part, []))
    return {f"{_path(name)}/__init__.py": _lazy(name, found, built.name) for name, found in groups.items()}


def _lazy(name: str, modules: Iterable[MessageModule], package: str) -> str:
    by_module: dict[str, list[str]] = {}
    for cls, module in _exports(modules).items():
        by_module.setdefault(module, []).append(cls)
    title = f"Messages of {name.split('.', maxsplit=1)[0]}" + (
        f", {name.split('.')[1]}" if "." in name else ", newest versions"
    )
    return "\n".join(
        [
            f'"""{title}; loaded on use. {NOTE}"""',
            "",
            "from __future__ import annotations",
            "",
            "from typing import TYPE_CHECKING",
            "",
            "from jauspy.codec.registry import lazy",
            "",
            "if TYPE_CHECKING:",
            *indent(_imports(by_module, package)),
            "",
            "__all__, __getattr__, __dir__ = lazy(__name__, {",
            *indent(
                f"{quote(f'{package}.{module}')}: {quote(' '.join(sorted(classes)))},"
                for module, classes in sorted(by_module.items())
            ),
            "})",
            "",
        ]
    )


def _imports(by_module: Mapping[str, list[str]], package: str) -> list[str]:
    lines = []
    for module, classes in sorted(by_module.items()):
        lines += [f"from {package}.{module} import ("]
        lines += [*indent(filled(f"{cls} as {cls}," for cls in sorted(classes))), ")"]
    return lines


def _exports(modules: Iterable[MessageModule]) -> dict[str, str]:
    """Class name to module: the newest version wins, services go before shared types, then by name."""
    found: dict[str, str] = {}
    ordered = sorted(modules, key=lambda module: (module.name.endswith(".types"), module.name))
    ordered.sort(key=lambda module: version_key(module.name.split(".")[1]), reverse=True)
    for module in sorted(ordered, key=lambda module: module.name.endswith(".types")):
        for cls in module.classes:
            found.setdefault(cls.__name__, module.name)
    return found
