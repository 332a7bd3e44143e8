"""The dimensions that the meshes follow: those of the URDF of inc1."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TypeAlias

from lxml import etree

from jauspy.geometry.urdf import RobotDescription, parse_urdf
from jauspy.robot.xacro_files import expand
from mesh_shapes import Mesh, Vector

Look: TypeAlias = dict[str, Mesh]
"""Meshes by material."""

URDF = Path(__file__).parents[2] / "src" / "jauspy" / "robots" / "urdf"


@dataclass(frozen=True)
class Dimensions:
    """Metres, in the frame of base_link."""

    idler_radius: float
    """Outside of the treads."""
    track_x: float
    """The middle of the tracks and of the hull."""
    idler_x: float
    """From there."""
    idler_z: float
    half_hull: float
    """Half the length of the hull."""
    belt_width: float
    gauge: float
    """From the middle of one belt to that of the other."""
    flipper_length: float
    flipper_radius: float
    flipper_width: float
    flipper_y: float
    deck: float
    """Height of the deck on which the arm stands."""
    camera: Vector
    """The frame of the pan axis."""
    lidar: Vector


def read() -> Dimensions:
    """Those of the robot as it is: its belts run around the cylinders that collide."""
    robot = parse_urdf(expand(str(URDF / "inc1.urdf.xacro")))
    idler, flipper = _cylinder(robot, "left_track"), _cylinder(robot, "left_flipper")
    return Dimensions(
        idler_radius=idler[0],
        track_x=_origin(robot, "left_track")[0],
        idler_x=idler[2],
        idler_z=idler[3],
        half_hull=_length(robot, "base_link") / 2.0,
        belt_width=idler[1],
        gauge=2.0 * _origin(robot, "left_track")[1],
        flipper_length=flipper[2],
        flipper_radius=flipper[0],
        flipper_width=flipper[1],
        flipper_y=_origin(robot, "left_flipper")[1],
        deck=_origin(robot, "arm_link_1")[2],
        camera=_origin(robot, "pan_link"),
        lidar=_origin(robot, "lidar_link"),
    )


def _origin(robot: RobotDescription, link: str) -> Vector:
    """Where a link is in its parent."""
    (joint,) = (joint for joint in robot.joints.values() if joint.child == link)
    return joint.origin.x, joint.origin.y, joint.origin.z


def _length(robot: RobotDescription, link: str) -> float:
    """Of the box that collides."""
    box = etree.fromstring(robot.urdf.encode()).find(f"link[@name='{link}']/collision/geometry/box")
    return 0.0 if box is None else float(box.get("size", "0").split()[0])


def _cylinder(robot: RobotDescription, link: str) -> tuple[float, float, float, float]:
    """Radius, length, x and z of the foremost cylinder that collides."""
    found = []
    for shape in etree.fromstring(robot.urdf.encode()).findall(f"link[@name='{link}']/collision"):
        cylinder, origin = shape.find("geometry/cylinder"), shape.find("origin")
        if cylinder is not None:
            x, _, z = (float(each) for each in ("0 0 0" if origin is None else origin.get("xyz", "0 0 0")).split())
            found.append((float(cylinder.get("radius", "0")), float(cylinder.get("length", "0")), x, z))
    return max(found, key=lambda each: each[2])
