"""Finds the files that a robot's URDF names: relative to it, by `file://`, or in ROS packages by `package://`."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Final
from urllib.parse import unquote

from lxml import etree

from jauspy.errors import ConfigError
from jauspy.user_files import below, confined, own_folder, read_file

MANIFEST: Final = "package.xml"

MAX_DEPTH: Final = 4
"""How deep a directory of `ROS_PACKAGE_PATH` or `package_path` is searched for packages."""

MAX_DIRECTORIES: Final = 20_000
"""How many directories are looked at for one package."""

MAX_SHOWN: Final = 200
"""Characters of a name that cannot be one."""

SKIPPED: Final = frozenset({".git", "build", "log", "node_modules", "__pycache__", "meshes", "textures"})


class MissingFile(ConfigError):
    """A file or a package is not there. `searched` says where a package was searched; it is empty for a file."""

    def __init__(self, text: str, searched: str = "") -> None:
        super().__init__(text + (f"; {searched}" if searched else ""))
        self.searched = searched


@dataclass(frozen=True, slots=True)
class PackagePaths:
    """Where packages are searched: the directories given, then those of ROS, then around the URDF file."""

    given: tuple[Path, ...] = ()
    """`package_path` of the robot's TOML file: packages, or directories with packages."""
    environment: Mapping[str, str] | None = None
    """`os.environ` when left out."""
    own: tuple[Path, ...] = ()
    """Folders of the robot's files, whose content they may name without a package."""

    def package(self, name: str, near: Path) -> Path:
        """The directory of a package that a file names; raises `MissingFile` with the places that were searched."""
        for place in (*self.given, *self._of_ros()):
            if (found := _below(place, name)) is not None:
                return found
        for place in near.resolve().parents:
            if _is_package(place, name):
                return place
            if _is_package(place / name, name):
                return place / name
        searched = ", ".join(map(str, (*self.given, *self._of_ros()))) or "none"
        raise MissingFile(
            f"the package {name!r} is not found",
            "package_path in the robot's TOML file (--package-path of jauspy new robot), ROS_PACKAGE_PATH and "
            f"AMENT_PREFIX_PATH name: {searched}; nor is it beside or above {near.parent}",
        )

    def permitted(self, path: Path, near: Path) -> Path:
        """`path`, if the file `near` may name it: it is below the robot's folders or ROS's, or in a package.

        Raises `ConfigError`.
        """
        return confined(path, (own_folder(near), *self.own, *self._of_ros()))

    def file(self, name: str, near: Path) -> Path:
        """The file that the text `name` means in the file `near`.

        Raises `MissingFile` if there is none, and `ConfigError` if `near` may not name it.
        """
        return self.permitted(self._file(name, near), near)

    def _file(self, name: str, near: Path) -> Path:
        scheme, found, rest = name.partition("://")
        if not found:
            return _existing(near.parent / name, name)
        if scheme == "file":
            return _existing(Path(unquote(rest.removeprefix("localhost"))), name)
        if scheme in ("package", "model"):
            package, _, path = unquote(rest).lstrip("/").partition("/")
            folder = self.package(package, near)
            target = below(folder, path)
            if target is None:
                raise ConfigError(f"{name}: leads out of the package {package!r}")
            return _existing(target, name)
        raise ConfigError(f"{name}: {scheme}:// is not read; known are package://, file:// and paths")

    def _of_ros(self) -> Iterator[Path]:
        environment = os.environ if self.environment is None else self.environment
        for entry in _entries(environment.get("ROS_PACKAGE_PATH", "")):
            yield entry
        for entry in _entries(environment.get("AMENT_PREFIX_PATH", "")):
            yield entry / "share"


def _entries(text: str) -> Iterable[Path]:
    return [Path(part) for part in text.split(os.pathsep) if part]


def _existing(path: Path, name: str) -> Path:
    try:
        is_file = path.is_file()
    except OSError as error:  # as for a name that is too long
        raise ConfigError(f"{name[:MAX_SHOWN]}: cannot be read: {error.strerror}") from error
    if not is_file:
        raise MissingFile(f"{name}: there is no such file" + ("" if str(path) == name else f" ({path})"))
    return path


def _below(place: Path, name: str) -> Path | None:
    """The package of that name at a directory or below it, as `rospack` finds it: not in other packages."""
    if _is_package(place, name):
        return place
    directories, looked_at = [(place, 0)], 0
    while directories and looked_at < MAX_DIRECTORIES:
        folder, depth = directories.pop(0)
        looked_at += 1
        if _is_package(folder / name, name):
            return folder / name
        if depth < MAX_DEPTH and not (depth and (folder / MANIFEST).is_file()):
            directories += [(subdirectory, depth + 1) for subdirectory in _subdirectories(folder)]
            match = next(
                (subdirectory for subdirectory in _subdirectories(folder) if _has_manifest(subdirectory, name)), None
            )
            if match is not None:
                return match
    return None


def _subdirectories(folder: Path) -> list[Path]:
    try:
        return sorted(child for child in folder.iterdir() if child.is_dir() and child.name not in SKIPPED)
    except OSError:
        return []


def _is_package(folder: Path, name: str) -> bool:
    """True for a directory of that name, with a manifest or without, and for one whose manifest has the name."""
    return folder.is_dir() and (folder.name == name or _has_manifest(folder, name))


def _has_manifest(folder: Path, name: str) -> bool:
    manifest = folder / MANIFEST
    if not manifest.is_file():
        return False
    try:
        root = etree.fromstring(read_file(manifest), etree.XMLParser(resolve_entities=False, no_network=True))
    except (etree.XMLSyntaxError, ConfigError):
        return False
    return (root.findtext("name") or "").strip() == name
