"""The part of the shipped definitions that some services need: reading all of them takes longer than it has to."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from pathlib import Path
from typing import Final, TypeAlias

from jauspy.schema.library import Key
from jauspy.schema.loader import builtin_paths, load_files
from jauspy.schema.model import Schema
from jauspy.schema.services import version_key

Wanted: TypeAlias = tuple[str, str | None]
"""The URN of a service and its version, None for the newest."""

# Shipped files are in one form, so their tags can be found without parsing: that is what makes this fast.
_HEAD: Final = 1024
"""Bytes within which the start tag of the root ends."""
_ROOT: Final = re.compile(rb"<(?:service_def|declared_type_set|declared_const_set)\s([^>]*)>")
_REFERENCE: Final = re.compile(rb"<(?:inherits_from|declared_type_set_ref|declared_const_set_ref)\s([^>]*)>")
_ID: Final = re.compile(rb'\bid="([^"]*)"')
_VERSION: Final = re.compile(rb'\bversion="([^"]*)"')


@cache
def load_needed(wanted: frozenset[Wanted]) -> Schema:
    """These shipped services with all they inherit from, the same as in `load_builtin()`.

    Of a service without the version that is wanted come all versions, of an unknown service none.
    """
    paths: set[Path] = set()
    waiting = [path for each in wanted for path in _files(*each)]
    while waiting:
        path = waiting.pop()
        if path not in paths:
            paths.add(path)
            waiting += [other for key in _keys(_REFERENCE, path.read_bytes()) for other in _files(*key)]
    return load_files(sorted(paths))


def versions_of(id: str) -> tuple[str, ...]:
    """The shipped versions of a service, newest first; none when it is not built in."""
    return tuple(sorted(_index().get(id, ()), key=version_key, reverse=True))


def _files(id: str, version: str | None) -> Iterable[Path]:
    versions = _index().get(id, {})
    if version is None:
        version = max(versions, key=version_key, default="")
    return [versions[version]] if version in versions else versions.values()


@cache
def _index() -> Mapping[str, Mapping[str, Path]]:
    """The shipped files by the id and version of what they define."""
    found: dict[str, dict[str, Path]] = {}
    for path in builtin_paths():
        with path.open("rb") as file:
            head = file.read(_HEAD)
        for id, version in _keys(_ROOT, head):
            found.setdefault(id, {})[version] = path
    return found


def _keys(tag: re.Pattern[bytes], text: bytes) -> Iterator[Key]:
    for attributes in tag.findall(text):
        id, version = _ID.search(attributes), _VERSION.search(attributes)
        if id and version:
            yield id[1].decode(), version[1].decode()
