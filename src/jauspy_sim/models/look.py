"""Materials of a robot's visual shapes, and the robot without visual shapes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Final

import mujoco
from lxml import etree

from jauspy.geometry.urdf import Element, RobotDescription, parse_tree
from jauspy.platform.description import RobotModel
from jauspy_sim.models.groups import VISUAL
from jauspy_sim.models.track_visuals import belted_links, mark
from jauspy_sim.models.urdf import material_colour
from jauspy_sim.models.whips import mark_whip

GLOSS: Final[Mapping[str, tuple[float, float]]] = {
    "olive": (0.25, 0.3),
    "black": (0.3, 0.35),
    "rubber": (0.12, 0.15),
    "steel": (0.75, 0.55),
    "alloy": (0.75, 0.55),
    "dark": (0.4, 0.4),
    "brass": (0.7, 0.6),
    "amber": (0.4, 0.45),
    "red": (0.6, 0.6),
    "lens": (1.0, 0.95),
    "lamp": (0.9, 0.9),
    "marking": (0.15, 0.2),
}
"""Specular reflection and shininess of materials by their name in the URDF, which cannot express them."""

SHADOWLESS: Final = frozenset({"amber", "black", "brass", "lamp", "lens", "marking", "red", "steel"})
"""Materials of small parts, which are in the shadows of larger ones anyway; theirs would cost a fifth of a picture."""

NO_SHADOW_ALPHA: Final = 0.999
"""Alpha slightly below 1: MuJoCo draws no shadows of transparent shapes."""


def without_visuals(description: RobotDescription) -> RobotDescription:
    """The robot without its visual shapes. Lines keep their numbers, which errors name."""
    root = parse_tree(description.urdf)
    for link in root.findall("link"):
        for visual in link.findall("visual"):
            lines = "\n" * etree.tostring(visual, with_tail=False).count(b"\n")
            before, tail = visual.getprevious(), lines + (visual.tail or "")
            if before is None:
                link.text = (link.text or "") + tail
            else:
                before.tail = (before.tail or "") + tail
            link.remove(visual)
    return replace(description, urdf=etree.tostring(root, encoding="unicode"))


def polish(spec: mujoco.MjSpec, robot: RobotModel, first_side: int = 0) -> None:
    """Give the visual shapes of a robot the gloss of their materials, and mark treads and antennas to move.

    `first_side` is where in `userdata` the runs of its belts begin.
    """
    description = robot.description
    belts = belted_links(description, robot.tracks) if robot.tracks else {}
    root = parse_tree(description.urdf)
    for name in GLOSS:
        _add_material(spec, name)
    for link in root.findall("link"):
        visuals = link.findall("visual")
        body = spec.body(str(link.get("name")))
        drawn = [] if body is None else [geom for geom in body.geoms if not (geom.contype or geom.conaffinity)]
        if len(drawn) != len(visuals):
            continue  # a mesh with several colours of its own
        for geom, visual in zip(drawn, visuals, strict=True):
            material = _material(visual)
            if (side := belts.get(str(link.get("name")))) is not None:
                mark(geom, visual, first_side + side)
            mark_whip(geom, visual)
            if material in GLOSS and not geom.material:
                geom.material = material
                if material in SHADOWLESS:
                    geom.rgba = (*geom.rgba[:3], NO_SHADOW_ALPHA)


def show_solids(spec: mujoco.MjSpec, description: RobotDescription) -> None:
    """Show collision shapes, in the colour of the first visual shape of their link: to cameras that cast rays."""
    for geom in spec.geoms:
        geom.group = VISUAL
    root = parse_tree(description.urdf)
    known = {
        str(material.get("name")): colour
        for material in root.findall("material")
        if (colour := material_colour(material))
    }
    for link in root.findall("link"):
        body, visual = spec.body(str(link.get("name"))), link.find("visual")
        if body is None or visual is None:
            continue
        material = visual.find("material")
        colour = None if material is None else material_colour(material) or known.get(str(material.get("name")))
        for geom in body.geoms if colour else ():
            if geom.contype or geom.conaffinity:
                geom.rgba = colour


def _add_material(spec: mujoco.MjSpec, name: str) -> None:
    specular, shininess = GLOSS[name]
    spec.add_material(name=name, specular=specular, shininess=shininess)


def _material(visual: Element) -> str:
    found = visual.find("material")
    return "" if found is None else str(found.get("name"))
