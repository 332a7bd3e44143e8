"""Geometry of a robot for the browser: links, joints and shapes of its description, or of its services' reports.

In a factory cell also the equipment, and the parts that its sensor observes.

Poses are `[x, y, z, qx, qy, qz, qw]`; metres, radians, axes of REP-103.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Final

from jauspy.console.languages import sentence
from jauspy.geometry.frames import FrameTree
from jauspy.geometry.poses import IDENTITY, JAUS_FROM_REP_103, Transform
from jauspy.geometry.urdf import Element, Joint, JointKind, RobotDescription, numbers, origin, parse_tree
from jauspy.geometry.vectors import X, Z, quaternion, rotation_about, rotation_from_quaternion
from jauspy.ids import JausID
from jauspy.messages.manipulator import ManipulatorCoordinateSystemRec, ReportManipulatorSpecifications
from jauspy.platform.modular.parts import CellSetup, PartKind, PartSolid, PartType, Shape
from jauspy.printable import printable

MESH_FORMATS: Final = (".obj", ".stl", ".glb", ".gltf")
"""Suffixes of mesh files that the page can read."""
PLAIN: Final = (0.6, 0.62, 0.65, 1.0)
"""Red, green, blue and opacity of a shape without a material."""
BASE: Final = "base"
"""The root link of a robot whose description is not known: the frame of its pose."""
FREE: Final = "free"
"""The kind of a joint without an axis: its position is a pose, None while it is not known."""
PART_SIZE: Final = 0.06
"""Metres: the side of a part whose geometry is not known."""
BELT_THICKNESS: Final = 0.06
METAL: Final = (0.66, 0.68, 0.70, 1.0)
PART_COLOURS: Final = {
    PartKind.BASE: (0.36, 0.42, 0.50, 1.0),
    PartKind.SERVO: (0.30, 0.33, 0.38, 1.0),
    PartKind.BRACKET: METAL,
    PartKind.TUBE: METAL,
    PartKind.WHEEL: (0.22, 0.23, 0.25, 1.0),
    PartKind.BOX: (0.74, 0.57, 0.37, 1.0),
}
BIN, BELT, TARGET, FIXTURE = (
    (0.24, 0.45, 0.70, 1.0),
    (0.24, 0.32, 0.30, 1.0),
    (0.45, 0.66, 0.53, 1.0),
    (0.42, 0.46, 0.52, 1.0),
)
_IDENTITY: Final = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]


@dataclass(slots=True)
class RobotGeometry:
    """One robot; `joints` are parents first."""

    source: str
    """The origin of the geometry, as text."""
    root: str
    joints: list[dict[str, Any]] = field(default_factory=list)
    shapes: list[dict[str, Any]] = field(default_factory=list)
    meshes: list[Path] = field(default_factory=list)
    """Files that shapes name by their place in this list."""
    left_out: list[str] = field(default_factory=list)
    """Meshes of formats that are not shown."""

    @property
    def links(self) -> set[str]:
        """The names of all links."""
        return {self.root, *(joint["child"] for joint in self.joints)}

    @property
    def moving(self) -> list[str]:
        """The joints whose positions the browser is sent, in this order."""
        return [joint["name"] for joint in self.joints if joint["kind"] != JointKind.FIXED.value]

    def for_browser(self, mesh_url: str) -> dict[str, Any]:
        """The geometry as JSON; the URL of a mesh is `mesh_url` and its number."""
        shapes = [
            shape | {"url": f"{mesh_url}{shape['mesh']}", "format": self.meshes[shape["mesh"]].suffix.lower()[1:]}
            if shape["kind"] == "mesh"
            else shape
            for shape in self.shapes
        ]
        return {"source": self.source, "root": self.root, "joints": self.joints, "shapes": shapes}


def described(description: RobotDescription, source: str) -> RobotGeometry:
    """The links, joints and visual shapes of a description; of a link without visual shapes, those that collide."""
    tree = FrameTree(description)
    found = RobotGeometry(source, tree.root, [_joint(joint) for joint in tree.joints])
    root = parse_tree(description.urdf)
    colours = {
        str(material.get("name")): colour for material in root.findall("material") if (colour := _colour(material))
    }
    for link in root.findall("link"):
        shapes = link.findall("visual") or link.findall("collision")
        for shape in shapes:
            _add_shape(found, str(link.get("name")), shape, colours)
    return found


def _joint(joint: Joint) -> dict[str, Any]:
    kind = JointKind.REVOLUTE if joint.kind is JointKind.CONTINUOUS else joint.kind
    return {
        "name": joint.name,
        "parent": joint.parent,
        "child": joint.child,
        "kind": kind.value,
        "origin": _pose(Transform.from_pose(joint.origin)),
        "axis": [round(axi, 6) for axi in joint.axis],
    }


def _add_shape(found: RobotGeometry, link: str, shape: Element, colours: Mapping[str, tuple[float, ...]]) -> None:
    geometry, material = shape.find("geometry"), shape.find("material")
    if geometry is None or not len(geometry):
        return
    colour = PLAIN if material is None else _colour(material) or colours.get(str(material.get("name")), PLAIN)
    base = {"link": link, "origin": _pose(Transform.from_pose(origin(shape))), "colour": list(colour)}
    kind = geometry[0]
    match kind.tag:
        case "box":
            found.shapes.append(base | {"kind": "box", "size": numbers(kind, "size", 3)})
        case "cylinder":
            radius, length = numbers(kind, "radius", 1)[0], numbers(kind, "length", 1)[0]
            found.shapes.append(base | {"kind": "cylinder", "radius": radius, "length": length})
        case "sphere":
            found.shapes.append(base | {"kind": "sphere", "radius": numbers(kind, "radius", 1)[0]})
        case "mesh":
            file = Path(str(kind.get("filename")))
            if file.suffix.lower() not in MESH_FORMATS:
                found.left_out.append(file.name)
                return
            if file not in found.meshes:
                found.meshes.append(file)
            scale = numbers(kind, "scale", 3, "1 1 1")
            found.shapes.append(base | {"kind": "mesh", "mesh": found.meshes.index(file), "scale": scale})


def _colour(material: Element) -> tuple[float, ...] | None:
    colour = material.find("color")
    return None if colour is None else numbers(colour, "rgba", 4)


def reported(manipulators: Mapping[JausID, ReportManipulatorSpecifications]) -> RobotGeometry:
    """The frames of the pose and of the arms, as their specifications (AS6057) tell them; a line along each link."""
    arms = ", ".join(map(str, manipulators))
    found = RobotGeometry(
        sentence("reported by {arms}", arms=arms) if arms else sentence("its services report no shape"), BASE
    )
    for id, report in manipulators.items():
        _add_arm(found, id, report)
    return found


def joint_name(component: JausID, number: int) -> str:
    """The name of a joint, counted from 1, of a robot whose description is not known."""
    return f"{component} joint {number}"


def _add_arm(found: RobotGeometry, id: JausID, report: ReportManipulatorSpecifications) -> None:
    first: Any = report.first_joint_parameters
    place = report.manipulator_coordinate_system_rec
    base = Transform() if place is None else JAUS_FROM_REP_103 @ _coordinate_system(place)
    turns = hasattr(first, "joint1_offset")
    rows: list[tuple[bool, float, float, float]] = [
        (turns, 0.0, 0.0, first.joint1_offset if turns else first.joint1_angle)
    ]
    for specification in report.joint_specification_list:
        turns = hasattr(specification, "joint_offset")
        fixed = getattr(specification, "joint_offset", None) if turns else getattr(specification, "joint_angle", None)
        rows.append((turns, specification.link_length, specification.twist_angle, float(fixed or 0.0)))
    parent = BASE
    for number, (turns, length, twist, fixed) in enumerate(rows, 1):
        link = Transform(rotation_about(X, twist), (length, 0.0, 0.0))
        rest = Transform(position=(0.0, 0.0, fixed)) if turns else Transform(rotation_about(Z, fixed))
        frame = (base if number == 1 else Transform()) @ link @ rest
        name = joint_name(id, number)
        kind = JointKind.REVOLUTE if turns else JointKind.PRISMATIC
        found.joints.append(
            {
                "name": name,
                "parent": parent,
                "child": name,
                "kind": kind.value,
                "origin": _pose(frame),
                "axis": [0, 0, 1],
            }
        )
        # the browser draws from the parent's origin to where this joint's frame is
        found.shapes.append({"link": parent, "kind": "line", "to": name, "origin": _IDENTITY, "colour": list(PLAIN)})
        parent = name


def add_surroundings(found: RobotGeometry, cell: CellSetup) -> None:
    """Add the equipment of a cell that no sensor observes, in the frame of its world, which is that of the root."""
    seen = {joint["name"] for joint in found.joints}
    for bin in cell.bins:
        _add_solids(found, found.root, bin.solids(), BIN, Transform.from_pose(bin.pose))
    for fixture in cell.fixtures:
        _add_solids(found, found.root, fixture.solids, FIXTURE, Transform.from_pose(fixture.pose))
    for part in cell.parts:
        if part.fixed and part_joint(part.name) not in seen:
            kind = cell.types[part.type]
            _add_solids(found, found.root, kind.solids, PART_COLOURS[kind.kind], Transform.from_pose(part.pose))
    flat = [(cell.conveyor, BELT_THICKNESS, BELT), (cell.target, 0.002, TARGET)]
    for area, height, colour in flat:
        if area is not None:
            middle = Transform(position=(0.0, 0.0, -height / 2.0 if area is cell.conveyor else height / 2.0))
            solid = PartSolid(Shape.CUBOID, (area.length, area.width, height), 0.0, middle)
            _add_solids(found, found.root, (solid,), colour, Transform.from_pose(area.pose))


def part_joint(name: str) -> str:
    """The joint whose position is the pose of this part."""
    return f"part {name}"


def output_joint(name: str) -> str:
    """The joint of the output of this servo module."""
    return f"output of {name}"


def add_part(found: RobotGeometry, name: str, type_name: str, kind: PartType | None) -> None:
    """Add a part that a sensor observes; one of unknown type is drawn as a box or a cylinder with its name."""
    shown = printable(name)
    link = shown if shown not in found.links else part_joint(shown)
    found.joints.append(
        {
            "name": part_joint(name),
            "parent": found.root,
            "child": link,
            "kind": FREE,
            "origin": _IDENTITY,
            "axis": [0, 0, 1],
        }
    )
    if kind is None:
        round_one = any(word in type_name for word in ("tube", "wheel"))
        half = PART_SIZE / 2.0
        solid = (
            PartSolid(Shape.CYLINDER, (half, half, PART_SIZE))
            if round_one
            else PartSolid(Shape.CUBOID, (PART_SIZE,) * 3)
        )
        _add_solids(found, link, (solid,), PLAIN)
        found.shapes[-1]["label"] = shown
        return
    _add_solids(found, link, kind.solids, PART_COLOURS[kind.kind])
    if (servo := kind.servo) is not None:
        joint = {
            "name": output_joint(name),
            "parent": link,
            "child": f"{link} output",
            "kind": JointKind.REVOLUTE.value,
        }
        found.joints.append(joint | {"origin": _pose(servo.joint), "axis": list(servo.axis)})
        _add_solids(found, f"{link} output", servo.output, METAL)


def _add_solids(
    found: RobotGeometry,
    link: str,
    solids: Sequence[PartSolid],
    colour: Sequence[float],
    place: Transform = IDENTITY,
) -> None:
    for solid in solids:
        shape: dict[str, Any] = {"link": link, "origin": _pose(place @ solid.pose), "colour": list(colour)}
        if solid.shape is Shape.CUBOID:
            shape |= {"kind": "box", "size": list(solid.size)}
        else:
            shape |= {"kind": "cylinder", "radius": solid.size[0], "length": solid.size[2]}
        found.shapes.append(shape)


def _coordinate_system(record: ManipulatorCoordinateSystemRec) -> Transform:
    parts = (
        record.d_component_of_unit_quaternion_q,
        record.a_component_of_unit_quaternion_q,
        record.b_component_of_unit_quaternion_q,
        record.c_component_of_unit_quaternion_q,
    )
    point = (
        record.manipulator_coordinate_sys_x,
        record.manipulator_coordinate_sys_y,
        record.manipulator_coordinate_sys_z,
    )
    return Transform(rotation_from_quaternion(*parts), point)


def _pose(frame: Transform) -> list[float]:
    d, a, b, c = quaternion(frame.rotation)
    return [round(number, 6) + 0.0 for number in (*frame.position, a, b, c, d)]


def positions_of(
    geometry: RobotGeometry,
    description: RobotDescription | None,
    known: Mapping[str, float],
    poses: Mapping[str, Sequence[float]],
) -> list[float | Sequence[float] | None]:
    """Positions of the joints in `moving`; those that follow others are computed, those not known are at zero."""
    described = {} if description is None else description.joints
    found: list[float | Sequence[float] | None] = []
    for joint in geometry.joints:
        name = joint["name"]
        if joint["kind"] == FREE:
            found.append(poses.get(name))
        elif joint["kind"] != JointKind.FIXED.value:
            found.append(round(described[name].position(known) if name in described else known.get(name, 0.0), 4))
    return found
