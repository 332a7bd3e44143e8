"""Checks a world in MJCF before it is loaded: which files it names, and what compiling it takes.

One attribute of MJCF can mean 10^9 bodies, and MuJoCo has no limits. So another process, with limits, compiles first.
"""

from __future__ import annotations

import math
import subprocess
import sys
from collections.abc import Iterator
from itertools import product
from pathlib import Path
from typing import Any, Final

from lxml import etree

from jauspy.errors import ConfigError
from jauspy.geometry.urdf import Element
from jauspy.printable import printable
from jauspy.user_files import read_file
from jauspy_sim.models.mesh_files import MAX_BYTES
from jauspy_sim.worlds.model_paths import ModelPaths

MAX_FILES: Final = 256
"""XML files of a world."""
MAX_FOLDERS: Final = 16
"""Directories that its compiler elements name."""
MAX_ELEMENTS: Final = 50_000
"""XML elements of a world, with those that `<replicate>` and `<flexcomp>` make."""
MAX_MEMORY: Final = 4 << 30
"""Bytes of address space of the process that compiles; 0.7 GiB of them are Python's libraries."""
MAX_SECONDS: Final = 20
"""Seconds of its CPU time."""
TIMEOUT: Final = 300.0
"""Seconds after which it is ended, whatever it waits for."""

_ENCODINGS: Final = (None, "UTF-8", "ASCII", "US-ASCII", "ISO-8859-1")
_FOLDERS: Final = ("assetdir", "meshdir", "texturedir")
_XML: Final = ("include", "model")
"""Elements that name another file of MJCF."""


def check_files(path: Path, paths: ModelPaths) -> None:
    """Raise `ConfigError` if a world or a file that it includes names a file of others, or a plugin."""
    texts = [path]
    named: list[tuple[Path, str, Element]] = []
    folders = {""}
    elements = 0
    for text in texts:
        for element in _elements(text):
            if element.tag in ("extension", "plugin"):
                raise ConfigError(f"{text}:{element.sourceline}: <{element.tag}>: plugins of MuJoCo are not loaded")
            elements += _times(element)
            if elements > MAX_ELEMENTS:
                raise ConfigError(f"{path}: has more than {MAX_ELEMENTS} elements, with those that others stand for")
            folders.update(folder for key in _FOLDERS if (folder := element.get(key)))
            files = [str(value) for key, value in element.items() if str(key).startswith("file") and value]
            named += [(text, file, element) for file in files]
            if element.tag in _XML:
                texts += [found for file in files for found in _found(path, text, file, {""}) if found not in texts]
        if len(texts) > MAX_FILES:
            raise ConfigError(f"{path}: includes more than {MAX_FILES} files")
        if len(folders) > MAX_FOLDERS:
            raise ConfigError(f"{path}: names more than {MAX_FOLDERS} directories")
    for text, file, element in named:
        try:
            for found in _found(path, text, file, folders):
                paths.permitted(found, path)
                read_file(found, 0) if not found.is_file() else _check_size(found)
        except ConfigError as error:
            raise ConfigError(f"{text}:{element.sourceline}: <{element.tag}>: {error}") from error


def _times(element: Element) -> int:
    """How often an element is in the world: it may be within `<replicate>`, or be points of a `<flexcomp>`."""
    times = 1.0
    for around in (element, *element.iterancestors("replicate", "flexcomp")):
        for key in ("count", "cellcount"):
            if around.tag in ("replicate", "flexcomp") and (text := around.get(key)):
                try:
                    times *= math.prod(abs(float(number)) for number in text.split())
                except ValueError:
                    raise ConfigError(f"<{around.tag}> {key}={text!r}: is not a number") from None
    return math.ceil(min(times, MAX_ELEMENTS + 1.0)) if math.isfinite(times) else MAX_ELEMENTS + 1


def _elements(path: Path) -> Iterator[Element]:
    try:
        root = etree.fromstring(read_file(path), etree.XMLParser(resolve_entities=False, no_network=True))
    except etree.XMLSyntaxError as error:
        raise ConfigError(f"{path}:{error.lineno}: is not XML: {error.msg}") from error
    about: Any = root.getroottree().docinfo
    if about.doctype or (about.encoding and about.encoding.upper() not in _ENCODINGS):
        raise ConfigError(f"{path}: has a <!DOCTYPE ...>, or another encoding than UTF-8")
    yield from (element for element in root.iter() if isinstance(element.tag, str))


def _found(top: Path, text: Path, file: str, folders: set[str]) -> list[Path]:
    """The existing files that MuJoCo may read for a name: relative to either file, with each directory or none."""
    names = {file, Path(file).name}
    places = {base / folder / name for base, folder, name in product((top.parent, text.parent), folders, names)}
    return sorted(place for place in places if place.exists())


def _check_size(path: Path) -> None:
    if path.stat().st_size > MAX_BYTES:
        raise ConfigError(f"{path}: has more than {MAX_BYTES >> 20} MiB")


def check_costs(path: Path) -> None:
    """Compile a world in a process with limits; raises `ConfigError` if that fails."""
    command = [sys.executable, "-P", "-m", "jauspy_sim.worlds.mjcf_trial", str(path), str(MAX_MEMORY), str(MAX_SECONDS)]
    try:
        done = subprocess.run(command, capture_output=True, text=True, errors="replace", check=False, timeout=TIMEOUT)  # noqa: S603
    except subprocess.TimeoutExpired:
        raise ConfigError(f"{path}: MuJoCo needs more than {TIMEOUT:g} s to compile it") from None
    if done.returncode:
        reason = printable(" ".join(done.stdout.split()))[:500]
        raise ConfigError(
            f"{path}: MuJoCo cannot read it: {reason}"
            if done.returncode == 1 and reason
            else f"{path}: MuJoCo needs more than {MAX_MEMORY >> 30} GiB or {MAX_SECONDS} s to compile it"
        )
