"""Finds the files that an SDF world refers to: relative paths, `file://`, and `model://` in search paths."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import islice
from pathlib import Path
from typing import Final
from urllib.parse import unquote

from lxml import etree

from jauspy.errors import ConfigError
from jauspy.user_files import below, confined, own_folder, read_file

VARIABLES: Final = (
    "GZ_SIM_RESOURCE_PATH",
    "IGN_GAZEBO_RESOURCE_PATH",
    "GAZEBO_MODEL_PATH",
    "GAZEBO_RESOURCE_PATH",
    "SDF_PATH",
)
"""Environment variables with directories of models, in their order."""

FOLDERS: Final = ("", "models", "Media/models", "media/models")
"""Folders with models and meshes, beside or above a world's file, and in packages of ROS."""

EXPORTS: Final = ("gazebo_media_path", "gazebo_model_path")
"""Attributes of `<gazebo_ros>` in the manifest of a package of ROS, with a directory of it for Gazebo."""

MAX_ENTRIES: Final = 1000
"""Entries of a directory that are looked at for packages."""

MANIFEST: Final = "package.xml"

MAX_PARENTS: Final = 4
"""How many directories above a world's file are searched."""


@dataclass(frozen=True, slots=True)
class ModelPaths:
    """Directories with models: those given, then those of the environment, then those around the file."""

    given: tuple[Path, ...] = ()
    environment: Mapping[str, str] | None = None
    """`os.environ` when left out."""

    def permitted(self, path: Path, near: Path) -> Path:
        """`path`, if the file `near` may name it: it is below its folder or the environment's, or in a model.

        Raises `ConfigError`.
        """
        return confined(path, (own_folder(near), *self._of_environment()))

    def file(self, uri: str, near: Path) -> Path:
        """The file or directory that a URI in the file `near` means; raises `ConfigError` if there is none."""
        return self.permitted(self._file(uri, near), near)

    def _file(self, uri: str, near: Path) -> Path:
        scheme, found, rest = uri.partition("://")
        if not found:
            return _existing(near.parent / uri, uri) if not Path(uri).is_absolute() else _existing(Path(uri), uri)
        if scheme in ("model", "package"):
            return self._model(unquote(rest).lstrip("/"), uri, near)
        if scheme == "file":
            path = Path(unquote(rest))
            return _existing(path, uri) if path.is_absolute() else self._model(str(path), uri, near)
        if scheme in ("http", "https", "fuel"):
            raise ConfigError(f"{uri}: nothing is downloaded; download it, and name its directory by --model-path")
        raise ConfigError(f"{uri}: {scheme}:// is not read; known are model://, file:// and paths")

    def _model(self, text: str, uri: str, near: Path) -> Path:
        name, _, rest = text.partition("/")
        for place in self._places(near):
            folder = place / name
            if not folder.exists():
                continue
            target = below(folder, rest)
            if target is None:
                raise ConfigError(f"{uri}: leads out of the model {name!r}")
            if target.exists():
                return target
        first = [str(place) for place in (*self.given, *self._of_environment(), near.absolute().parent)]
        raise ConfigError(
            f"{uri}: is not found; --model-path, model_path and GZ_SIM_RESOURCE_PATH add to: "
            f"{', '.join(dict.fromkeys(first))}, the directories above it and the packages there, with the folders "
            f"{', '.join(filter(None, FOLDERS))} of each"
        )

    def _places(self, near: Path) -> Iterator[Path]:
        yield from self.given
        yield from self._of_environment()
        parents = list(near.absolute().parents)[:MAX_PARENTS]
        for parent in parents:
            for folder in FOLDERS:
                yield parent / folder
        for parent in parents:
            for exported in _exported(parent):
                for folder in FOLDERS:
                    yield exported / folder

    def _of_environment(self) -> Iterator[Path]:
        environment = os.environ if self.environment is None else self.environment
        for variable in VARIABLES:
            for part in environment.get(variable, "").split(os.pathsep):
                if part:
                    yield Path(part)


def _exported(parent: Path) -> Iterator[Path]:
    """The directories for Gazebo of the ROS packages in a directory, as their manifests name them."""
    try:
        folders = [entry for entry in islice(parent.iterdir(), MAX_ENTRIES) if (entry / MANIFEST).is_file()]
    except OSError:
        return
    for folder in sorted(folders):
        try:
            root = etree.fromstring(
                read_file(folder / MANIFEST), etree.XMLParser(resolve_entities=False, no_network=True)
            )
        except (etree.XMLSyntaxError, ConfigError):
            continue
        for element in root.iterfind("export/gazebo_ros"):
            for text in filter(None, map(element.get, EXPORTS)):
                found = below(folder, text.replace("${prefix}", "."))
                if found is not None:
                    yield found


def _existing(path: Path, uri: str) -> Path:
    if not path.exists():
        raise ConfigError(f"{uri}: there is no such file ({path.absolute()})")
    return path


def sdf_of_model(folder: Path) -> Path:
    """The SDF file of a model: of the newest version that its `model.config` names. Raises `ConfigError`."""
    if folder.is_file():
        return folder
    config = folder / "model.config"
    if config.is_file():
        try:
            root = etree.fromstring(read_file(config), etree.XMLParser(resolve_entities=False, no_network=True))
        except etree.XMLSyntaxError as error:
            raise ConfigError(f"{config}:{error.lineno}: is not XML: {error.msg}") from error
        named = [(element.get("version", "0"), (element.text or "").strip()) for element in root.findall("sdf")]
        files = [(version, folder / name) for version, name in named if name and "/" not in name]
        found = [path for _, path in sorted(files, key=lambda file: _version(file[0])) if path.is_file()]
        if found:
            return found[-1]
    if not (folder / "model.sdf").is_file():
        raise ConfigError(f"{folder}: has no model.sdf")
    return folder / "model.sdf"


def _version(text: str) -> tuple[int, ...]:
    return tuple(int(part) if part.isdigit() else 0 for part in text.split("."))
