"""Generated packages: their messages have the ids, names and versions of the definitions, and no others."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path
from typing import Final

from jauspy.codec.registry import MessageEntry, Registry
from jauspy.errors import ConfigError
from jauspy.fuzz.findings import FuzzFinding

CHECK: Final = "identity"
"""The check of findings about ids, names and versions."""


def load_package(name: str) -> Registry:
    """The registry of a package of `jauspy schema generate`, also in this folder; raises `ConfigError`."""
    here = str(Path.cwd())
    if here not in sys.path:
        sys.path.insert(0, here)
    try:
        found = getattr(import_module(name), "registry", None)
    except ImportError as error:
        raise ConfigError(f"the package {name} cannot be imported from here: {error}") from None
    except Exception as error:  # the code is not ours
        raise ConfigError(f"the package {name} cannot be imported: {type(error).__name__}: {error}") from error
    if not isinstance(found, Registry):
        raise ConfigError(
            f"{name} has no `registry` of messages; `jauspy schema generate` writes packages that have one"
        )
    return found


def identity_findings(package: Registry, defined: Registry) -> Iterator[FuzzFinding]:
    """What a package says otherwise than the definitions: messages that are missing or others, ids, versions."""
    right = {_key(entry): entry for entry in defined.own}
    made = {_key(entry): entry for entry in package.own}
    for key, entry in right.items():
        if key not in made:
            yield _finding(entry, "missing", "the package does not have it: generate it again")
    for key, entry in made.items():
        if key not in right:
            yield _finding(
                entry, "undefined", f"the package has it, and the definitions do not{_instead(entry, defined)}"
            )
        elif entry.code != right[key].code:
            yield _finding(
                entry, "id", f"the package has the id {entry.code:04X}h, the definition {right[key].code:04X}h"
            )
        elif entry.wire != right[key].wire:
            yield _finding(entry, "fields", "the package was generated from other fields: generate it again")
        yield from _class_findings(entry)


def _key(entry: MessageEntry) -> tuple[str, str, str]:
    return entry.service, entry.version, entry.name


def _instead(entry: MessageEntry, defined: Registry) -> str:
    versions = [each.version for each in defined.own if (each.service, each.name) == (entry.service, entry.name)]
    return f", but in version {' and '.join(versions)}" if versions else ""


def _class_findings(entry: MessageEntry) -> Iterator[FuzzFinding]:
    """What the class of an entry says otherwise than the table of the package."""
    try:
        cls = entry.load()
    except (ImportError, AttributeError, AssertionError) as error:
        yield _finding(entry, "class", f"{entry.module} has no such class: {error}")
        return
    for what, has, should in (
        ("id", f"{cls.CODE:04X}h", f"{entry.code:04X}h"),
        ("name", cls.NAME, entry.name),
        ("service", cls.SERVICE, entry.service),
        ("version", cls.VERSION, entry.version),
    ):
        if has != should:
            yield _finding(entry, f"class {what}", f"its class has the {what} {has}, the package's table {should}")


def _finding(entry: MessageEntry, what: str, seen: str) -> FuzzFinding:
    data = entry.code.to_bytes(2, "little")
    return FuzzFinding(CHECK, entry.name, entry.service, entry.version, what, seen, data.hex(), 0, 0)
