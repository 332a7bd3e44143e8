"""Source of the packages around the message modules: lazy re-exports and the registry's table."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Final

from jauspy.codec.generator_text import indent, quote
from jauspy.codec.plan import ModulePlan
from jauspy.schema.model import Message

NOTE = "Generated from schemas/; do not edit."


PARTS: Final = {"exp": "iop"}
"""Sets whose messages are offered by the package of another one, too: the profiles' experiments by the profiles'."""


def version_key(version: str) -> tuple[int, ...]:
    """Orders versions."""
    return tuple(int(part) for part in version.replace("v", "").replace("_", ".").split(".") if part.isdigit())


def root(package: str, base: str | None) -> str:
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


def table(modules: Iterable[ModulePlan], package: str, files: Mapping[tuple[str, str], str] | None) -> str:
    """`_table.py`: code, name, service, version and module of every message; and the file of every service."""
    rows: list[str] = []
    for module in sorted(modules, key=lambda module: module.name):
        place = ", ".join(map(quote, (f"{package}.{module.name}", module.service, module.version)))
        messages = [_row(plan.message, plan.name) for plan in module.classes if plan.message]
        if messages:
            rows += ["*entries(", *indent([f"{place},", *messages]), "),"]
    return "\n".join(
        [
            f'"""Which messages there are, and where. {NOTE}"""',
            "",
            "from __future__ import annotations",
            "",
            "from typing import Final",
            "",
            "from jauspy.codec.entries import entries",
            "",
            "TABLE: Final = (",
            *indent(rows),
            ")",
            *([] if files is None else ["FILES: Final = {", *indent(map(_file, sorted(files.items()))), "}"]),
            "",
        ]
    )


def _file(item: tuple[tuple[str, str], str]) -> str:
    (service, version), file = item
    return f"({quote(service)}, {quote(version)}): {quote(file)},"


def _row(message: Message, cls: str) -> str:
    other = f", {quote(cls)}" if cls != message.name else ""
    return f"(0x{message.code:04X}, {quote(message.name)}{other}),"


def packages(modules: list[ModulePlan], package: str) -> dict[str, str]:
    """The `__init__.py` of every set and version, by path."""
    groups: dict[str, list[ModulePlan]] = {}
    for module in modules:
        family, version, _ = module.name.split(".")
        groups.setdefault(family, []).append(module)
        groups.setdefault(f"{family}.{version}", []).append(module)
    for part, whole in PARTS.items():
        groups.get(whole, []).extend(groups.get(part, []))
    return {f"{name.replace('.', '/')}/__init__.py": _lazy(name, found, package) for name, found in groups.items()}


def _lazy(name: str, modules: list[ModulePlan], package: str) -> str:
    exported = _exports(modules)
    by_module: dict[str, list[str]] = {}
    for cls, module in exported.items():
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
            "from jauspy.codec.lazy import exports, load",
            "",
            "if TYPE_CHECKING:",
            *indent(_imports(by_module, package)),
            "",
            "_MODULES = exports({",
            *indent(
                f"{quote(f'{package}.{module}')}: {quote(' '.join(sorted(classes)))},"
                for module, classes in sorted(by_module.items())
            ),
            "})",
            "",
            "__all__ = sorted(_MODULES)",
            "",
            "",
            "def __getattr__(name: str) -> object:",
            "    globals()[name] = value = load(name, _MODULES, __name__)",
            "    return value",
            "",
            "",
            "def __dir__() -> list[str]:",
            "    return sorted({*globals(), *_MODULES})",
            "",
        ]
    )


def _imports(by_module: dict[str, list[str]], package: str) -> list[str]:
    lines = []
    for module, classes in sorted(by_module.items()):
        lines += [f"from {package}.{module} import ("]
        lines += [f"    {cls} as {cls}," for cls in sorted(classes)]
        lines += [")"]
    return lines


def _exports(modules: list[ModulePlan]) -> dict[str, str]:
    """Class name to module: the newest version wins, services go before shared types, then by name."""
    found: dict[str, str] = {}
    ordered = sorted(modules, key=lambda module: (module.name.endswith(".types"), module.name))
    ordered.sort(key=lambda module: version_key(module.name.split(".")[1]), reverse=True)
    for module in sorted(ordered, key=lambda module: module.name.endswith(".types")):
        for plan in module.classes:
            found.setdefault(plan.name, module.name)
    return found
