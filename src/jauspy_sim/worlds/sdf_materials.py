"""Materials of SDF: colours, albedo textures, and the scripts of Gazebo classic."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import lru_cache
from pathlib import Path
from typing import Final

from jauspy.errors import ConfigError
from jauspy.geometry.urdf import Element
from jauspy.user_files import read_file
from jauspy_sim.models.shapes import RGBA, Look
from jauspy_sim.worlds.model_paths import ModelPaths
from jauspy_sim.worlds.sdf_poses import words

GAZEBO: Final[dict[str, tuple[float, float, float]]] = {
    "Black": (0.05, 0.05, 0.05),
    "Blue": (0.0, 0.0, 0.9),
    "Brown": (0.45, 0.3, 0.18),
    "DarkGray": (0.18, 0.18, 0.18),
    "DarkGrey": (0.18, 0.18, 0.18),
    "FlatBlack": (0.1, 0.1, 0.1),
    "Gold": (0.8, 0.65, 0.1),
    "Grass": (0.3, 0.45, 0.2),
    "Gray": (0.6, 0.6, 0.6),
    "Green": (0.0, 0.8, 0.0),
    "Grey": (0.6, 0.6, 0.6),
    "Indigo": (0.3, 0.0, 0.5),
    "LightWood": (0.72, 0.56, 0.36),
    "Motorway": (0.3, 0.3, 0.31),
    "Orange": (1.0, 0.5, 0.05),
    "Purple": (0.7, 0.0, 0.7),
    "Red": (0.9, 0.0, 0.0),
    "Residential": (0.42, 0.42, 0.42),
    "Road": (0.3, 0.3, 0.31),
    "SkyBlue": (0.13, 0.44, 0.7),
    "Turquoise": (0.0, 0.8, 0.7),
    "White": (1.0, 1.0, 1.0),
    "WhiteGlow": (1.0, 1.0, 1.0),
    "Wood": (0.5, 0.35, 0.2),
    "WoodFloor": (0.5, 0.35, 0.2),
    "WoodPallet": (0.6, 0.45, 0.28),
    "Yellow": (0.9, 0.85, 0.0),
}
"""Colours like those of the scripts `Gazebo/NAME`, whose files are part of Gazebo."""


def look_of(visual: Element, paths: ModelPaths, near: Path) -> Look:
    """The material of a visual; a file that is missing raises `ConfigError`."""
    material = visual.find("material")
    transparency = words(visual.find("transparency"))
    alpha = 1.0 - min(1.0, max(0.0, float(transparency[0]))) if transparency else 1.0
    if material is None:
        return Look()
    found = _scripted(material, paths, near) or Look()
    colour = found.colour
    for tag in ("ambient", "diffuse"):
        if colour is None or tag == "diffuse":
            colour = _colour(material.find(tag)) or colour
    albedo = words(material.find("pbr/metal/albedo_map")) or words(material.find("pbr/specular/albedo_map"))
    texture = paths.file(" ".join(albedo), near) if albedo else found.texture
    emissive = _colour(material.find("emissive"))
    emission = max(emissive[:3]) if emissive else 0.0
    if colour is None and emissive is not None and emission > 0.0:
        colour = emissive
    if texture is not None and colour is not None and not any(colour[:3]):
        colour = None
    if colour is not None and alpha < 1.0:
        colour = (*colour[:3], alpha)
    return Look(colour, texture, found.repeat, emission=min(1.0, emission))


def _colour(element: Element | None) -> RGBA | None:
    try:
        values = [min(1.0, max(0.0, float(word))) for word in words(element)]
    except ValueError:
        values = []
    if len(values) not in (3, 4):
        return None
    red, green, blue, alpha = (*values, 1.0)[:4]
    return red, green, blue, alpha


def _scripted(material: Element, paths: ModelPaths, near: Path) -> Look | None:
    name = " ".join(words(material.find("script/name")))
    if not name:
        return None
    if name.startswith("Gazebo/") and (colour := GAZEBO.get(name.removeprefix("Gazebo/"))) is not None:
        return Look((*colour, 1.0))
    places = []
    for uri in material.findall("script/uri"):
        try:
            places.append(paths.file(" ".join(words(uri)), near))
        except ConfigError:  # of Gazebo itself, as file://media/materials/scripts/gazebo.material
            continue
    return _of_script(name, tuple(places))


@lru_cache(maxsize=256)
def _of_script(name: str, places: tuple[Path, ...]) -> Look | None:
    """The look of a material in Ogre's scripts: its diffuse colour, and its first texture."""
    for script in _files(places, ".material"):
        text = read_file(script).decode(errors="replace")
        match = re.search(rf"material\s+{re.escape(name)}\s*(?::[^{{]*)?\{{(.*?)(?=\nmaterial\s|\Z)", text, re.DOTALL)
        if match is None:
            continue
        body = match.group(1)
        texture = re.search(r"^\s*texture\s+(\S+)", body, re.MULTILINE)
        diffuse = re.search(r"^\s*diffuse((?:\s+[\d.eE+-]+){3,4})", body, re.MULTILINE)
        colour: RGBA | None = None
        if diffuse is not None and texture is None:
            red, green, blue = map(float, diffuse.group(1).split()[:3])
            colour = red, green, blue, 1.0
        file = None
        if texture is not None:
            folders = (*places, script.parent, script.parent.parent / "textures", script.parent)
            file = next((path for path in _files(folders, "") if path.name == texture.group(1)), None)
        return Look(colour, file)
    return None


def _files(places: Iterable[Path], suffix: str) -> list[Path]:
    found: list[Path] = []
    for place in places:
        folder = [place] if place.is_file() else sorted(place.iterdir()) if place.is_dir() else []
        found += [path for path in folder if path.is_file() and path.name.endswith(suffix)]
    return found
