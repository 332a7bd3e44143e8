"""What is known of a robot from its description: names and positions of joints, frames, meshes."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Final

from foxglove import messages as fox

from jauspy.geometry.denavit_hartenberg import manipulator_geometry, reversed_axes
from jauspy.geometry.frames import FrameTree, joint_frame
from jauspy.geometry.poses import Transform
from jauspy.geometry.urdf import Element, numbers, origin, parse_tree
from jauspy.geometry.vectors import X, quaternion, rotation_about
from jauspy.recording.described_robot import DescribedRobot

LOCAL: Final = "local"
"""Frame of LocalPoseSensor with the axes of REP-103."""
BASE: Final = "base"
"""Frame of the vehicle, whose pose LocalPoseSensor reports."""
MEDIA_TYPES: Final = {
    ".obj": "model/obj",
    ".stl": "model/stl",
    ".glb": "model/gltf-binary",
    ".dae": "model/vnd.collada+xml",
}
"""Formats of meshes that Foxglove shows."""
MAX_MESHES: Final = 16 << 20
"""Bytes of the meshes of a robot; those beyond are left out."""
PLAIN: Final = (0.6, 0.62, 0.65, 1.0)
"""Red, green, blue and opacity of a shape without a material."""


_Y_UP: Final = Transform(rotation_about(X, math.pi / 2.0))
"""How Foxglove turns meshes without an axis that is up."""


def frame_id(subsystem: int, name: str) -> str:
    """The name of a robot's frame."""
    return f"{subsystem}/{name}"


def vector3(values: Sequence[float]) -> fox.Vector3:
    """A vector of the SDK."""
    x, y, z = values
    return fox.Vector3(x=x, y=y, z=z)


def sdk_pose(pose: Transform) -> fox.Pose:
    """A pose of the SDK."""
    return fox.Pose(position=vector3(pose.position), orientation=_orientation(pose))


def frame_transform(time: fox.Timestamp, parent: str, child: str, pose: Transform) -> fox.FrameTransform:
    """The pose of a frame in its parent."""
    return fox.FrameTransform(
        timestamp=time,
        parent_frame_id=parent,
        child_frame_id=child,
        translation=vector3(pose.position),
        rotation=_orientation(pose),
    )


def _orientation(pose: Transform) -> fox.Quaternion:
    w, x, y, z = quaternion(pose.rotation)
    return fox.Quaternion(x=x, y=y, z=z, w=w)


class RobotScene:
    """Frames and meshes of a described robot. Joints that no report has told are at their start positions."""

    def __init__(self, robot: DescribedRobot) -> None:
        self.robot = robot
        model = robot.model
        self._tree = FrameTree(model.description)
        groups = model.groups.values()
        self._positions = {
            joint: start for group in groups for joint, start in zip(group.joints, group.start, strict=True)
        }

    def joints(self, component: int) -> tuple[str, ...]:
        """The joints that a component moves; empty if that is not known."""
        group = self.robot.model.groups.get(self.robot.movers.get(component, ""))
        return () if group is None else group.joints

    def take_manipulator(self, component: int, values: Sequence[float]) -> dict[str, float] | None:
        """Positions by joint, from those of a report by AS6057; None if the component's joints are not known."""
        group = self.robot.model.groups.get(self.robot.movers.get(component, ""))
        if group is None or len(values) != len(group.joints):
            return None
        geometry = manipulator_geometry(self.robot.model.description.chain(group.base, group.tip))
        return self._take(zip(group.joints, geometry.to_urdf(values), strict=True))

    def take_pan_tilt(self, component: int, values: Sequence[float]) -> dict[str, float] | None:
        """The same for a pan-tilt unit."""
        group = self.robot.model.groups.get(self.robot.movers.get(component, ""))
        if group is None or len(values) != len(group.joints):
            return None
        is_reversed = reversed_axes(self.robot.model.description.chain(group.base, group.tip))
        signed = (-value if back else value for value, back in zip(values, is_reversed, strict=True))
        return self._take(zip(group.joints, signed, strict=True))

    def _take(self, positions: Iterable[tuple[str, float]]) -> dict[str, float]:
        found = dict(positions)
        self._positions |= found
        return found

    def transforms(self, time: fox.Timestamp, moved: Iterable[str] | None = None) -> list[fox.FrameTransform]:
        """The frames of the joints that were moved, and of those that mimic them; None: of all."""
        names = None if moved is None else set(moved)
        found = []
        if names is None and self._tree.root != BASE:
            found.append(frame_transform(time, self._frame(BASE), self._frame(self._tree.root), Transform()))
        for joint in self._tree.joints:
            if names is None or joint.name in names or joint.mimics in names:
                pose = joint_frame(joint, joint.position(self._positions))
                found.append(frame_transform(time, self._frame(joint.parent), self._frame(joint.child), pose))
        return found

    def lidar_frame(self, number: int) -> str | None:
        """The frame of a lidar by its sensor id; lidars of a robot are counted from 1."""
        lidars = self.robot.model.lidars
        return self._frame(lidars[number - 1].link) if 1 <= number <= len(lidars) else None

    def meshes(self, time: fox.Timestamp) -> fox.SceneUpdate:
        """The visual shapes of all links, with the files of their meshes."""
        root = parse_tree(self.robot.model.description.urdf)
        colours = {str(each.get("name")): found for each in root.findall("material") if (found := _colour(each))}
        shapes = _Shapes(colours)
        entities = [
            self._entity(time, link, shapes) for link in root.findall("link") if link.find("visual") is not None
        ]
        return fox.SceneUpdate(entities=entities)

    def _entity(self, time: fox.Timestamp, link: Element, shapes: _Shapes) -> fox.SceneEntity:
        models, cubes, cylinders, spheres = [], [], [], []
        for visual in link.findall("visual"):
            match shapes.primitive(visual):
                case fox.ModelPrimitive() as model:
                    models.append(model)
                case fox.CubePrimitive() as cube:
                    cubes.append(cube)
                case fox.CylinderPrimitive() as cylinder:
                    cylinders.append(cylinder)
                case fox.SpherePrimitive() as sphere:
                    spheres.append(sphere)
        name = self._frame(str(link.get("name")))
        return fox.SceneEntity(
            timestamp=time,
            frame_id=name,
            id=name,
            frame_locked=True,
            models=models,
            cubes=cubes,
            cylinders=cylinders,
            spheres=spheres,
        )

    def _frame(self, link: str) -> str:
        return frame_id(self.robot.subsystem, link)


class _Shapes:
    """Makes primitives of visual shapes, within a bound of bytes."""

    def __init__(self, colours: Mapping[str, fox.Color]) -> None:
        self._colours = colours
        self._left = MAX_MESHES

    def primitive(
        self, visual: Element
    ) -> fox.ModelPrimitive | fox.CubePrimitive | fox.CylinderPrimitive | fox.SpherePrimitive | None:
        """The primitive of a shape; None for one that Foxglove does not show."""
        geometry, material = visual.find("geometry"), visual.find("material")
        if geometry is None or not len(geometry):
            return None
        colour = None if material is None else _colour(material) or self._colours.get(str(material.get("name")))
        pose, kind, painted = sdk_pose(Transform.from_pose(origin(visual))), geometry[0], colour or _color(PLAIN)
        match kind.tag:
            case "box":
                return fox.CubePrimitive(pose=pose, size=vector3(numbers(kind, "size", 3)), color=painted)
            case "cylinder":
                width, length = 2.0 * numbers(kind, "radius", 1)[0], numbers(kind, "length", 1)[0]
                size = vector3((width, width, length))
                return fox.CylinderPrimitive(pose=pose, size=size, bottom_scale=1.0, top_scale=1.0, color=painted)
            case "sphere":
                width = 2.0 * numbers(kind, "radius", 1)[0]
                return fox.SpherePrimitive(pose=pose, size=vector3((width, width, width)), color=painted)
            case "mesh":
                return self._mesh(kind, Transform.from_pose(origin(visual)), colour)
            case _:
                return None

    def _mesh(self, mesh: Element, pose: Transform, colour: fox.Color | None) -> fox.ModelPrimitive | None:
        path = Path(str(mesh.get("filename")))
        media_type = MEDIA_TYPES.get(path.suffix.lower())
        if media_type is None or not path.is_file() or path.stat().st_size > self._left:
            return None
        data = path.read_bytes()
        self._left -= len(data)
        has_own_colours = path.suffix.lower() in (".glb", ".dae")
        x, y, z = numbers(mesh, "scale", 3, "1 1 1")
        if not has_own_colours:  # nor an axis that is up: Foxglove takes it to be y, and turns the mesh
            pose, (y, z) = pose @ _Y_UP.inverse(), (z, y)
        return fox.ModelPrimitive(
            pose=sdk_pose(pose),
            scale=vector3((x, y, z)),
            color=colour or _color(PLAIN),
            override_color=colour is not None or not has_own_colours,
            media_type=media_type,
            data=data,
        )


def _colour(material: Element) -> fox.Color | None:
    element = material.find("color")
    return None if element is None else _color(numbers(element, "rgba", 4))


def _color(rgba: Sequence[float]) -> fox.Color:
    r, g, b, a = rgba
    return fox.Color(r=r, g=g, b=b, a=a)
