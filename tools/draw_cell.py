"""Draw the factory cell from above, with the ids of its components, to docs/assets/cell.svg.

python tools/draw_cell.py [-o FILE]
"""

from __future__ import annotations

import argparse
import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final
from xml.sax.saxutils import escape

from jauspy.geometry.frames import FrameTree
from jauspy.geometry.poses import Pose, Transform
from jauspy.platform.description import RobotModel
from jauspy.platform.modular.parts import CellSetup, PartKind, PartSolid, PartType, Shape
from jauspy.robot import robot_files
from jauspy.robot.config import RobotConfig

TARGET: Final = Path(__file__).parents[1] / "docs" / "assets" / "cell.svg"

SCALE: Final = 250.0
"""Pixels for a metre."""
MARGIN: Final = 0.28
"""Metres around the outermost things."""
PANEL: Final = 400
"""Pixels of the table on the right."""

FILLS: Final = {
    PartKind.BASE: "#5d6d7e",
    PartKind.SERVO: "#d35400",
    PartKind.BRACKET: "#7f8c8d",
    PartKind.TUBE: "#95a5a6",
    PartKind.WHEEL: "#2c3e50",
    PartKind.BOX: "#b9936c",
}
LEGEND: Final = (
    (PartKind.SERVO, "servo module"),
    (PartKind.BRACKET, "bracket"),
    (PartKind.TUBE, "tube"),
    (PartKind.WHEEL, "wheel"),
    (PartKind.BASE, "base"),
    (PartKind.BOX, "box"),
)


@dataclass
class Drawing:
    """Shapes in the order in which they are drawn; x to the right, y up, in metres of the world."""

    lines: list[str] = field(default_factory=list)
    points: list[tuple[float, float]] = field(default_factory=list)

    def polygon(
        self, corners: Iterable[tuple[float, float]], fill: str, stroke: str = "#34495e", more: str = ""
    ) -> None:
        """A polygon, whose corners count for the size of the picture."""
        corners = list(corners)
        self.points += corners
        at = " ".join(f"{x * SCALE:.1f},{-y * SCALE:.1f}" for x, y in corners)
        self.lines.append(f'<polygon points="{at}" fill="{fill}" stroke="{stroke}" stroke-width="1.2" {more}/>')

    def circle(self, x: float, y: float, radius: float, fill: str) -> None:
        """A circle."""
        at = f'cx="{x * SCALE:.1f}" cy="{-y * SCALE:.1f}" r="{radius * SCALE:.1f}"'
        self.lines.append(f'<circle {at} fill="{fill}" stroke="#34495e" stroke-width="1.2"/>')

    def path(self, points: Iterable[tuple[float, float]], width: float, colour: str) -> None:
        """A line with round ends; `width` in metres."""
        at = " ".join(f"{x * SCALE:.1f},{-y * SCALE:.1f}" for x, y in points)
        style = 'fill="none" stroke-linecap="round" stroke-linejoin="round"'
        self.lines.append(f'<polyline points="{at}" {style} stroke="{colour}" stroke-width="{width * SCALE:.1f}"/>')

    def label(self, x: float, y: float, text: str, *, kind: str = "id", anchor: str = "middle") -> None:
        """A text with its middle at a point."""
        at = f'x="{x * SCALE:.1f}" y="{-y * SCALE + 4:.1f}"'
        self.lines.append(f'<text {at} class="{kind}" text-anchor="{anchor}">{escape(text)}</text>')


def rectangle(pose: Pose, length: float, width: float) -> list[tuple[float, float]]:
    """The corners of a rectangle around a pose, seen from above."""
    frame = Transform.from_pose(pose)
    corners = ((-1, -1), (1, -1), (1, 1), (-1, 1))
    return [frame.apply((x * length / 2, y * width / 2, 0.0))[:2] for x, y in corners]


def outline(solid: PartSolid, frame: Transform) -> list[tuple[float, float]]:
    """The convex outline of a primitive from above."""
    placed = frame @ solid.pose
    if solid.shape is Shape.CUBOID:
        signs = [(x, y, z) for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)]
        points = [(x * solid.size[0], y * solid.size[1], z * solid.size[2]) for x, y, z in signs]
    else:
        turns = [math.tau * step / 24 for step in range(24)]
        radius, _, length = solid.size
        points = [(radius * math.cos(a), radius * math.sin(a), z) for a in turns for z in (-length / 2, length / 2)]
    return hull([placed.apply(point)[:2] for point in points])


def hull(points: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """The convex hull, counterclockwise."""

    def half(rows: Iterable[tuple[float, float]]) -> list[tuple[float, float]]:
        kept: list[tuple[float, float]] = []
        for x, y in rows:
            while len(kept) > 1 and _turn(kept[-2], kept[-1], (x, y)) <= 0.0:
                kept.pop()
            kept.append((x, y))
        return kept[:-1]

    ordered = sorted(set(points))
    return half(ordered) + half(reversed(ordered))


def _turn(a: tuple[float, float], b: tuple[float, float], c: tuple[float, float]) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def bodies(type: PartType, frame: Transform) -> Iterator[list[tuple[float, float]]]:
    """The outlines of a part, with the link that turns at position zero."""
    for solid in type.solids:
        yield outline(solid, frame)
    if type.servo is not None:
        for solid in type.servo.output:
            yield outline(solid, frame @ type.servo.joint)


def draw(config: RobotConfig, model: RobotModel, cell: CellSetup) -> Drawing:
    """The cell from above."""
    made = Drawing()
    ids = {
        module.part or module.type: str(config.id_of(module)) for module in config.modules if module.type != "CM-MOB"
    }
    draw_surroundings(made, cell, ids)
    labels: list[tuple[tuple[float, float], str, str]] = []
    for part in sorted(cell.parts, key=lambda part: part.pose.z):
        type = cell.types[part.type]
        frame = Transform.from_pose(part.pose)
        for corners in bodies(type, frame):
            made.polygon(corners, FILLS[type.kind])
        x, y, _ = frame.position
        if type.kind is PartKind.BASE:
            labels.append(((x, y - 0.14), f"{part.name}  {short(ids[part.name])}", "over"))
        elif part.name in ids:
            labels.append((frame.apply((0.0, 0.0, -0.05))[:2], f".{ids[part.name].rpartition('.')[2]}", "small"))
    draw_robot(made, model)
    for (x, y), text, kind in labels:
        made.label(x, y, text, kind=kind)
    base = config.id_of(next(module for module in config.modules if module.type == "CM-MAN"))
    made.label(0.0, -0.16, f"UR10  {short(str(base))}", kind="over")
    return made


def draw_surroundings(made: Drawing, cell: CellSetup, ids: dict[str, str]) -> None:
    """Conveyor, target, bins and fixtures."""
    if (target := cell.target) is not None:
        made.polygon(
            rectangle(target.pose, target.length, target.width), "#fdf2e9", "#ca6f1e", 'stroke-dasharray="6 4"'
        )
        made.label(target.pose.x, target.pose.y, "target area")
    for fixture in cell.fixtures:
        frame = Transform.from_pose(fixture.pose)
        for solid in fixture.solids:
            corners = outline(solid, frame)
            made.polygon(corners, "#e5e8e8")
            middle = frame.apply(solid.pose.position)
            if solid.size[0] > 0.5:
                made.label(middle[0], middle[1], fixture.name)
    if (belt := cell.conveyor) is not None:
        made.polygon(rectangle(belt.pose, belt.length, belt.width), "#aeb6bf")
        frame = Transform.from_pose(belt.pose)
        for step in range(5):
            x = belt.length * (step - 2) / 5
            arrow = ((x - 0.04, -0.06, 0.0), (x + 0.04, 0.0, 0.0), (x - 0.04, 0.06, 0.0))
            made.path((frame.apply(point)[:2] for point in arrow), 0.012, "#566573")
        x, y, _ = frame.apply((belt.length * 0.36, 0.0, 0.0))
        made.label(x, y, f"conveyor  {short(ids['CM-CNV'])}", kind="over")
    for bin in cell.bins:
        made.polygon(rectangle(bin.pose, bin.length + 0.02, bin.width + 0.02), "#f4f6f7")


def draw_robot(made: Drawing, model: RobotModel) -> None:
    """The robot at its start."""
    starts = {
        joint: start for group in model.groups.values() for joint, start in zip(group.joints, group.start, strict=True)
    }
    frames = FrameTree(model.description).poses(starts)
    (group,) = model.groups.values()
    chain = [group.base, *(joint.child for joint in model.description.chain(group.base, group.tip))]
    points = [frames[link].position[:2] for link in chain]
    made.circle(*points[0], 0.1, "#85929e")
    made.path(points, 0.085, "#2e86c1")
    made.path(points, 0.02, "#d6eaf8")
    made.circle(*points[-1], 0.045, "#1b4f72")


def short(id: str) -> str:
    """The id without its subsystem."""
    return id.partition(".")[2]


def table(config: RobotConfig, left: float) -> Iterator[str]:
    """The nodes and their components."""
    titles = {
        1: "node 1: the robot and the cell",
        2: "node 2: one component for each module",
        3: "node 3: what is assembled",
    }
    names = {
        "CM-MAN": "UR10",
        "CM-CNV": "conveyor",
        "CM-PRT": "part sensor, module power",
        "CM-MOB": "car, with its wheels",
    }
    y = 44.0
    yield f'<text x="{left}" y="{y}" class="title">subsystem {config.subsystem}  {escape(config.name)}</text>'
    for node in config.nodes:
        y += 34
        yield f'<text x="{left}" y="{y}" class="head">{titles[node]}</text>'
        modules = [module for module in config.modules if (module.node or config.node) == node]
        columns = 2 if len(modules) > 10 else 1
        rows = math.ceil(len(modules) / columns)
        for number, module in enumerate(modules):
            at = left + (number // rows) * PANEL / 2
            name = names.get(module.type) or module.part or ""
            text = f"{short(str(config.id_of(module)))}  {name}"
            yield f'<text x="{at}" y="{y + 20 * (number % rows + 1)}" class="row">{escape(text)}</text>'
        y += 20 * rows
    for kind, name in LEGEND:
        y += 24 if kind is not PartKind.SERVO else 44
        yield f'<rect x="{left}" y="{y - 11}" width="13" height="13" rx="2" fill="{FILLS[kind]}"/>'
        yield f'<text x="{left + 22}" y="{y}" class="row">{name}</text>'


def svg(config: RobotConfig, made: Drawing) -> str:
    """The whole picture."""
    xs, ys = zip(*made.points, strict=True)
    left, top = (min(xs) - MARGIN) * SCALE, (-max(ys) - MARGIN) * SCALE
    width, height = (max(xs) - min(xs) + 2 * MARGIN) * SCALE, (max(ys) - min(ys) + 2 * MARGIN) * SCALE
    style = (
        "text{font-family:'DejaVu Sans',Verdana,sans-serif;fill:#1c2833}.id{font-size:13px}.small{font-size:11px}"
        ".over{font-size:13px;font-weight:bold;paint-order:stroke;stroke:#fff;stroke-width:4px;stroke-linejoin:round}"
        ".title{font-size:19px;font-weight:bold}.head{font-size:14px;font-weight:bold}.row{font-size:13px}"
    )
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width + PANEL:.0f} {height:.0f}">',
        f"<style>{style}</style>",
        f'<rect width="{width + PANEL:.0f}" height="{height:.0f}" fill="#ffffff"/>',
        f'<g transform="translate({-left:.1f} {-top:.1f})">',
        *made.lines,
        "</g>",
        *table(config, width + 10),
        "</svg>",
    ]
    return "\n".join(lines) + "\n"


def main() -> None:
    """Write the picture."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("-o", "--output", type=Path, default=TARGET, help="the file (%(default)s)")
    options = parser.parse_args()
    config = robot_files.load("cell")
    model = robot_files.robot_model(config)
    assert model.cell is not None
    options.output.write_text(svg(config, draw(config, model, model.cell)), "utf-8")


if __name__ == "__main__":
    main()
