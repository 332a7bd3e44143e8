"""A world as MJCF: what is seen is merged to one mesh for each body and material, what collides are simple shapes."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final

import numpy as np
from lxml import etree

from .shapes import Array, Mesh, Vector, box_map, joined

WORLDS: Final = Path(__file__).parents[2] / "src" / "jauspy_sim" / "worlds"

SEEN: Final = 1
"""Group of what is only drawn: `VISUAL` of `jauspy_sim.assembly`."""
SOLID: Final = 5
"""Group of what only collides; lidars see it, cameras do not."""


def numbers(values: Sequence[float] | Array) -> str:
    """Numbers as MJCF has them."""
    return " ".join(f"{value:.5g}" if abs(value) > 5e-6 else "0" for value in values)


@dataclass
class Part:
    """A body, or the world itself."""

    element: etree._Element
    name: str
    meshes: dict[str, list[Mesh]] = field(default_factory=lambda: defaultdict(list))
    parts: list[Part] = field(default_factory=list)

    def see(self, material: str, *meshes: Mesh) -> None:
        """Add what is seen, in the frame of the part."""
        self.meshes[material] += meshes

    def add(self, tag: str, **attributes: object) -> etree._Element:
        """An element of MJCF; numbers and lists of numbers become text, underscores at the end of names go."""
        element = etree.SubElement(self.element, tag)
        for key, value in attributes.items():
            text = value if isinstance(value, str) else numbers(np.atleast_1d(np.asarray(value, np.float64)))
            element.set(key.rstrip("_"), text)
        return element

    def box(self, size: Vector, at: Vector, **more: object) -> None:
        """A box that collides, of full length, width and height."""
        self.add("geom", class_="solid", type="box", size=np.array(size) / 2.0, pos=at, **more)

    def cylinder(self, radius: float, low: Vector, high: Vector, **more: object) -> None:
        """A cylinder that collides."""
        self.add("geom", class_="solid", type="cylinder", size=[radius], fromto=[*low, *high], **more)

    def capsule(self, radius: float, start: Vector, end: Vector, **more: object) -> None:
        """A capsule that collides."""
        self.add("geom", class_="solid", type="capsule", size=[radius], fromto=[*start, *end], **more)

    def region(self, name: str) -> Part:
        """A part of the same body with meshes of its own: cameras that see nothing of it do not draw it."""
        self.parts.append(Part(self.element, name))
        return self.parts[-1]

    def body(self, name: str, at: Vector, *, free: bool = True, euler: Vector = (0.0, 0.0, 0.0)) -> Part:
        """A body on this one; `euler` in degrees."""
        element = self.add("body", name=name, pos=at)
        if any(euler):
            element.set("euler", numbers(euler))
        if free:
            etree.SubElement(element, "freejoint")
        self.parts.append(Part(element, name))
        return self.parts[-1]


class Scene:
    """A world under construction."""

    def __init__(self, name: str, about: str, *, middle: Vector, extent: float) -> None:
        self.name = name
        self.root = etree.Element("mujoco", model=name)
        self.root.append(etree.Comment(about))
        etree.SubElement(self.root, "include", file="assets/look.xml")
        etree.SubElement(self.root, "statistic", center=numbers(middle), extent=numbers([extent]))
        kinds = etree.SubElement(self.root, "default")
        defaults = etree.SubElement(kinds, "default", {"class": "seen"})
        etree.SubElement(defaults, "geom", type="mesh", contype="0", conaffinity="0", group=str(SEEN), mass="0")
        solid = etree.SubElement(kinds, "default", {"class": "solid"})
        etree.SubElement(solid, "geom", group=str(SOLID), rgba="0.6 0.5 0.4 1")
        self.assets = etree.SubElement(self.root, "asset")
        self.files: dict[str, str] = {}
        """Further OBJ files by name, for `assets/NAME`."""
        self.world = Part(etree.SubElement(self.root, "worldbody"), "scenery")

    def asset(self, tag: str, **attributes: str) -> None:
        """An asset of its own."""
        etree.SubElement(self.assets, tag, {key.rstrip("_"): value for key, value in attributes.items()})

    def shape(self, name: str, mesh: Mesh) -> str:
        """Add a mesh that is seen in several places, as a `geom` of class `seen` each; returns what to call it."""
        self.files[f"{name}.obj"] = obj(mesh)
        self.asset("mesh", name=f"{self.name}/{name}", file=f"assets/{self.name}/{name}.obj", inertia="shell")
        return f"{self.name}/{name}"

    def section(self, tag: str) -> etree._Element:
        """A top-level element such as `equality`."""
        found = self.root.find(tag)
        return etree.SubElement(self.root, tag) if found is None else found

    def write(self, folder: Path = WORLDS) -> tuple[int, int]:
        """Write NAME.xml and assets/NAME/*.obj; returns the numbers of triangles and of bytes of meshes."""
        meshes = folder / "assets" / self.name
        meshes.mkdir(parents=True, exist_ok=True)
        for old in meshes.glob("*.obj"):
            old.unlink()
        for name, text in self.files.items():
            (meshes / name).write_text(text)
        counts = self._write(self.world, meshes)
        etree.indent(self.root)
        (folder / f"{self.name}.xml").write_bytes(etree.tostring(self.root) + b"\n")
        return counts

    def forget_meshes(self) -> None:
        """Remove what `write` added, to write again."""
        for mesh in self.assets.findall("mesh"):
            if mesh.get("inertia") == "shell":
                self.assets.remove(mesh)
        for geom in list(self.root.iter("geom")):
            owner = geom.getparent()
            if owner is not None and owner.tag != "default" and geom.get("class") == "seen":
                owner.remove(geom)

    def _write(self, part: Part, folder: Path) -> tuple[int, int]:
        triangles = size = 0
        for material, pieces in part.meshes.items():
            name = f"{part.name}.{material.removesuffix('_uv')}"
            mesh = joined(pieces)
            text = obj(mesh)
            (folder / f"{name}.obj").write_text(text)
            self.asset("mesh", name=f"{self.name}/{name}", file=f"assets/{self.name}/{name}.obj", inertia="shell")
            part.add("geom", class_="seen", mesh=f"{self.name}/{name}", material=material)
            triangles, size = triangles + len(mesh.triangles), size + len(text)
        for each in part.parts:
            more = self._write(each, folder)
            triangles, size = triangles + more[0], size + more[1]
        return triangles, size


def obj(mesh: Mesh) -> str:
    """A mesh as OBJ, to a tenth of a millimetre; texture coordinates to a millimetre."""
    uv = box_map(mesh) if mesh.uv is None else mesh.uv
    wide = np.abs(mesh.vertices).max() > 50.0
    points, which = np.unique(np.round(uv.reshape(-1, 2), 2 if wide else 3), axis=0, return_inverse=True)
    texture = which.reshape(-1, 3)
    lines = ["v " + " ".join(f"{value:.4f}".rstrip("0").rstrip(".") for value in row) for row in mesh.vertices]
    lines += ["vt " + " ".join(f"{value:.3f}".rstrip("0").rstrip(".") for value in row) for row in points]
    for corners, seen in zip(mesh.triangles + 1, texture + 1, strict=True):
        lines.append("f " + " ".join(f"{v}/{t}" for v, t in zip(corners, seen, strict=True)))
    return "\n".join(lines) + "\n"
