"""Reads URDF and xacro files of robots: with the paths of their meshes on this machine, or as they are."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from os.path import relpath
from pathlib import Path
from typing import Final

from lxml import etree

from jauspy.errors import ConfigError
from jauspy.geometry.urdf import PLACE, Element, RobotDescription, parse_tree, parse_urdf
from jauspy.logs import get_logger
from jauspy.robot.missing_parts import SCHEME, MissingParts, MissingPolicy
from jauspy.robot.urdf_paths import PackagePaths
from jauspy.robot.xacro_files import expand

_LOG: Final = get_logger("jauspy.urdf")

STRICT: Final = MissingPolicy()
"""Whatever is missing is an error."""


def _warn(sentence: str) -> None:
    _LOG.warning("%s", sentence)


def read_urdf(
    path: str,
    packages: PackagePaths,
    arguments: Mapping[str, str] | None = None,
    policy: MissingPolicy = STRICT,
    *,
    tell: Callable[[str], None] = _warn,
) -> RobotDescription:
    """The robot of a URDF or xacro file, with the paths of its meshes on this machine.

    Raises `ConfigError` with file and line. `tell` is called with each sentence about what is left out or replaced.
    """
    missing, find = MissingParts(path, policy), partial(packages.file, near=Path(path))
    try:
        root = _tree(path, packages, arguments, missing)
        for element in root.iter("mesh", "texture"):
            found = missing.find_mesh(element, find) if element.get("filename") else None
            if found is not None:
                element.set("filename", str(found.absolute()))
        _settle(root, missing, tell)
        return parse_urdf(etree.tostring(root, encoding="unicode"))
    except ConfigError as error:
        raise _placed(error, path) from error


def expand_urdf(
    path: str,
    packages: PackagePaths,
    arguments: Mapping[str, str] | None,
    policy: MissingPolicy,
    folder: Path,
    *,
    tell: Callable[[str], None] = _warn,
) -> bytes:
    """The URDF of a xacro file, in ASCII, with the names of files as it has them; relative ones start at `folder`.

    Raises `ConfigError`. Meshes are searched only if boxes take their places.
    """
    missing, find = MissingParts(path, policy), partial(packages.file, near=Path(path))
    try:
        root = _tree(path, packages, arguments, missing)
        for element in root.iter("mesh", "texture"):
            name = element.get("filename")
            if name and policy.placeholder_meshes:
                missing.find_mesh(element, find)
            if name and "://" not in name and not Path(name).is_absolute():
                element.set("filename", relpath(Path(path).parent / name, folder))
        _settle(root, missing, tell)
    except ConfigError as error:
        raise _placed(error, path) from error
    for element in root.iter("*"):
        element.attrib.pop(PLACE, "")
    etree.indent(root)
    return etree.tostring(root, encoding="ascii", xml_declaration=True) + b"\n"


def _tree(path: str, packages: PackagePaths, arguments: Mapping[str, str] | None, missing: MissingParts) -> Element:
    """The expanded file. Raises `ConfigError`, which lists what is missing if that may be why it cannot be expanded."""
    try:
        text = expand(path, packages, arguments, with_places=True, missing=missing)
    except ConfigError as error:
        reason = str(error).partition("xacro cannot expand it: ")[2] or str(error)
        listed = missing.error(reason) or ConfigError("\n  ".join([str(error), *missing.sentences()]))
        raise listed from error
    root = parse_tree(text)
    for element in root.iter("mesh", "texture"):
        if (name := element.get("filename", "")).startswith(f"file://{SCHEME}"):  # as of file://$(find NAME)
            element.set("filename", name.removeprefix("file://"))
    missing.note_names(root)
    return root


def _settle(root: Element, missing: MissingParts, tell: Callable[[str], None]) -> None:
    missing.settle(root)
    for sentence in missing.sentences():
        tell(sentence)


def _placed(error: ConfigError, path: str) -> ConfigError:
    """The error with the path of the file in front, once."""
    text, own_prefix = str(error), f"{Path(path).name}:"
    if text.startswith("urdf: "):
        return error
    return ConfigError(f"urdf: {path}" + (text[len(own_prefix) - 1 :] if text.startswith(own_prefix) else f": {text}"))
