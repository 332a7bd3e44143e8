"""Parts of a robot's URDF that are missing on this machine: all are listed at once, or left out and replaced.

Packages of accessories that are not installed are what is missing most often.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from jauspy.errors import ConfigError
from jauspy.geometry.urdf import PLACE, Element, place
from jauspy.printable import printable
from jauspy.robot.urdf_paths import MissingFile

BOX: Final = 0.1
"""Metres of the sides of a box in place of a mesh."""

MAX_PACKAGES: Final = 32
"""Packages that are missing: each is searched for in thousands of directories."""

MAX_LISTED: Final = 50
"""Lines of an error; parts of one kind that are told."""

MAX_TEXT: Final = 500
"""Characters of a name or a reason that are shown."""

SCHEME: Final = "package://"
_NAME: Final = re.compile(r"[A-Za-z0-9_][\w.-]*", re.ASCII)


@dataclass(frozen=True, slots=True)
class MissingPolicy:
    """Treatment of parts that are missing; by default they are errors."""

    skip_packages: bool = False
    """True to leave out includes of missing packages and files, with the macros, joints and links that need them."""
    placeholder_meshes: bool = False
    """True to put a box in the place of each missing mesh."""


@dataclass(frozen=True, slots=True)
class _Part:
    """A missing part: an element, the place where it is, and what it names."""

    element: str
    place: str
    name: str
    reason: str

    def __str__(self) -> str:
        what = self.reason if self.name in self.reason else self.name
        return ": ".join(filter(None, (self.place, self.element, what)))


def _part(element: str, place: str, name: str, reason: str) -> _Part:
    """A part with texts that can be printed."""
    return _Part(_shown(element), _shown(place), _shown(name), _shown(reason))


def _shown(text: str) -> str:
    return printable(text)[:MAX_TEXT]


class MissingParts:
    """Collects the missing parts of one robot, whose file is `path`."""

    def __init__(self, path: str, policy: MissingPolicy = MissingPolicy()) -> None:
        self._path = path
        self._policy = policy
        self._packages: dict[str, MissingFile] = {}
        """Missing packages, by their names."""
        self._used: set[str] = set()
        """Packages of which it is known what names them."""
        self._includes: dict[_Part, None] = {}
        self._names: dict[_Part, None] = {}
        """Other elements that name missing packages."""
        self._meshes: dict[_Part, None] = {}
        self._elements: list[Element] = []
        """The elements of the latter."""
        self._left_out: dict[str, dict[str, None]] = {}
        """Names that depend on missing includes, by the kind of elements."""

    # --- while the file is expanded ---------------------------------------------------------------------------------

    def find(self, name: str, search: Callable[[str], Path]) -> str:
        """The directory of a package, for `$(find NAME)`; `package://NAME` for a missing one, which is noted.

        Raises `ConfigError` for what is no name of a package, and if too many are missing.
        """
        try:
            return str(self._search(name, lambda: search(name)))
        except MissingFile:
            if not _NAME.fullmatch(name):
                raise
            return f"{SCHEME}{name}"

    def _search(self, package: str, search: Callable[[], Path]) -> Path:
        """Result of `search`; it is not called again for a package that is missing."""
        if package in self._packages:
            raise self._packages[package]
        try:
            return search()
        except MissingFile as error:
            if error.searched:
                if len(self._packages) >= MAX_PACKAGES:
                    raise ConfigError(f"more than {MAX_PACKAGES} packages are missing: {error}") from error
                self._packages[package] = error
            raise

    def package_error(self, filename: str) -> MissingFile | None:
        """The error about the package that a file name begins with, as `find` returns it; None if it is not missing."""
        return self._packages.get(_package(filename))

    def add_include(self, filename: str, place: str, reason: str) -> None:
        """Note an `<xacro:include>` whose file is missing."""
        self._used.add(_package(filename))
        self._includes[_part("<xacro:include>", place, filename, reason)] = None

    @property
    def lacks_includes(self) -> bool:
        """True if an include is missing, so that macros may be unknown."""
        return bool(self._includes)

    def leave_out(self, kind: str, name: str) -> None:
        """Note something that is left out because it needs what is missing: one of `kind`, as in `macros`."""
        self._left_out.setdefault(kind, {})[_shown(name)] = None

    # --- in the expanded file ---------------------------------------------------------------------------------------

    def find_mesh(self, element: Element, find: Callable[[str], Path]) -> Path | None:
        """The file of a `<mesh>` or `<texture>`; None for a missing one, which is noted.

        Raises `ConfigError` with the place for one that must not be read.
        """
        filename = str(element.get("filename"))
        package = _package(filename)
        try:
            return self._search(package, lambda: find(filename)) if package else find(filename)
        except MissingFile as error:
            self._used.add(package)
            self._meshes[_part(f"<{element.tag}>", place(element), filename, str(error))] = None
            self._elements.append(element)
            return None
        except ConfigError as error:
            raise ConfigError(f"{place(element)}: <{element.tag}>: {error}") from error

    def note_names(self, root: Element) -> None:
        """Note the elements, other than meshes, that name missing packages."""
        for element in root.iter("*") if self._packages else ():
            is_mesh = element.tag in ("mesh", "texture")
            for text in (*map(str, element.attrib.values()), element.text or ""):
                for name in re.findall(rf"{SCHEME}({_NAME.pattern})", text, re.ASCII):
                    if name not in self._packages:
                        continue
                    self._used.add(name)
                    if not is_mesh:
                        reason = str(self._packages[name])
                        self._names[_part(f"<{element.tag}>", place(element), f"{SCHEME}{name}", reason)] = None

    def settle(self, root: Element) -> None:
        """Leave out and replace what the policy permits. Raises `ConfigError`, which lists all other missing parts."""
        if error := self.error():
            raise error
        if self._includes:
            self._remove_loose(root)
        for element in self._elements:
            _replace(element)

    def _remove_loose(self, root: Element) -> None:
        """Remove joints whose links are missing, and all links and joints but those of the largest tree."""
        links = {str(link.get("name")): link for link in root.iterchildren("link")}
        below: dict[str, list[tuple[Element, str]]] = {}
        children = set()
        for joint in root.findall("joint"):
            parent, child = (
                "" if end is None else str(end.get("link")) for end in (joint.find("parent"), joint.find("child"))
            )
            if parent in links and child in links:
                below.setdefault(parent, []).append((joint, child))
                children.add(child)
            elif parent and child:
                self.leave_out("joints", str(joint.get("name")))
                root.remove(joint)
        trees = [_tree(link, below) for link in links if link not in children]
        for tree in sorted(trees, key=len, reverse=True)[1:]:
            for link in tree:
                self.leave_out("links", link)
                root.remove(links[link])
                for joint, _ in below.get(link, ()):
                    self.leave_out("joints", str(joint.get("name")))
                    root.remove(joint)

    # --- what is said -----------------------------------------------------------------------------------------------

    def error(self, then: str = "") -> ConfigError | None:
        """The error that lists the missing parts that the policy does not permit; None if there are none.

        `then` is the reason why the file was not read to its end.
        """
        unused = [
            _part(f"$(find {name})", "", f"{SCHEME}{name}", str(error))
            for name, error in self._packages.items()
            if name not in self._used
        ]
        packages = [] if self._policy.skip_packages else [*self._includes, *self._names, *unused]
        meshes = [] if self._policy.placeholder_meshes else [*self._meshes]
        parts = [*packages, *meshes]
        if not parts:
            return None
        remedies = ["--skip-missing-packages (skip_missing_packages = true) leaves out what needs them"] * bool(
            packages
        )
        remedies += [
            f"--placeholder-meshes (placeholder_meshes = true) puts a box of {BOX:g} m in place of each mesh"
        ] * bool(meshes)
        hint = f"to do without, by an option of `jauspy new robot` or in the TOML file: {'; '.join(remedies)}"
        if len(parts) == 1 and not then:
            (part,) = parts
            where = [f"urdf: {self._path}", *["xacro cannot expand it"] * bool(packages), part.place, part.element]
            return ConfigError(f"{': '.join(filter(None, where))}: {part.reason}; {hint}")
        lines = [f"urdf: {self._path}: {len(parts)} parts are missing:", *map(str, parts[:MAX_LISTED])]
        lines += [f"and {len(parts) - MAX_LISTED} more"] * (len(parts) > MAX_LISTED)
        lines += [f"perhaps more, since it could be read to here only: {then}"] * bool(then)
        lost = {name: self._packages[name] for part in parts if (name := _package(part.name)) in self._packages}
        if lost:
            searched = next(iter(lost.values())).searched
            lines.append(f"packages that are not found: {', '.join(lost)}; {searched}")
        return ConfigError("\n  ".join([*lines, hint]))

    def sentences(self) -> Iterator[str]:
        """Sentences about what is missing, left out and replaced, none too long for a line of the log."""
        name = _shown(Path(self._path).name)
        for listed in _listed(map(_shown, self._packages)):
            yield f"{name}: packages that are not found: {listed}"
        includes = [f"{part.name} ({part.place})" for part in self._includes]
        for kind, names in {"includes": includes, **self._left_out}.items():
            for listed in _listed(names):
                yield f"{name}: left out {kind}: {listed}"
        for listed in _listed(f"{part.name} ({part.place})" for part in self._meshes):
            yield f"{name}: missing, and replaced by a box of {BOX:g} m (a texture by none): {listed}"


def _package(filename: str) -> str:
    """The package that a file name begins with; empty if it does not."""
    scheme, found, rest = filename.partition("://")
    return rest.lstrip("/").partition("/")[0] if found and scheme in ("package", "model") else ""


def _replace(element: Element) -> None:
    """Replace a mesh by a box; remove a texture."""
    parent = element.getparent()
    if parent is None:
        return
    if element.tag == "texture":
        parent.remove(element)
        return
    where = place(element)
    element.attrib.clear()
    element.tag = "box"
    element.set("size", " ".join([f"{BOX:g}"] * 3))
    element.set(PLACE, where)


def _tree(link: str, below: dict[str, list[tuple[Element, str]]]) -> dict[str, None]:
    """The link and all below it; each once, also in a loop."""
    found, pending = {link: None}, [link]
    while pending:
        for _, child in below.get(pending.pop(), ()):
            if child not in found:
                found[child] = None
                pending.append(child)
    return found


def _listed(names: Iterable[str]) -> Iterator[str]:
    """The names, with commas, as several texts if they are long."""
    text = ""
    for number, name in enumerate(names):
        if number == MAX_LISTED:
            text += ", and more"
            break
        if text and len(text) + len(name) > MAX_TEXT:
            yield text
            text = ""
        text += f"{', ' if text else ''}{name}"
    if text:
        yield text
