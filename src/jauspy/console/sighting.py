"""Cameras that pan and tilt, and how far away is what an operator clicks in a picture.

Directions are radians to the right and upwards, as AS6057 counts them for pan-tilt units; points are metres in the
robot's frame (REP-103). A place in a picture is the share of its width from the left, and of its height from above.
"""

from __future__ import annotations

import math
import struct
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Final

from jauspy.console.camera_settings import LENS, sensor_name
from jauspy.console.conventions import Conventions
from jauspy.console.languages import sentence
from jauspy.console.world import CLOUD_HEADER, World
from jauspy.errors import ConfigError, JausError
from jauspy.geometry.frames import FrameTree
from jauspy.geometry.poses import Transform
from jauspy.geometry.vectors import Vector
from jauspy.messages.description import QueryJointDescription, ReportJointDescription
from jauspy.messages.environment_sensing.v2_0.visual_sensor import QueryVisualSensorConfiguration
from jauspy.messages.manipulator import (
    QueryPanTiltJointPositions,
    ReportPanTiltJointPositions,
    SetPanTiltJointPositions,
)
from jauspy.ocu.arm import PAN_TILT_DRIVER
from jauspy.ocu.joints import DESCRIPTION, PAN_TILT_SENSOR, table_of
from jauspy.ocu.robot import Robot
from jauspy.ocu.subsystems import ComponentInfo

NEAR_ANGLE: Final = math.radians(1.0)
"""Greatest angle between the ray through a place in the picture and a point of a depth camera."""
NEAR_BEARING: Final = math.radians(1.5)
"""The same for echoes of a lidar, about the vertical."""
DIRECTIONS: Final = {
    "ahead": (0.0, 0.0),
    "left": (-math.pi / 2.0, 0.0),
    "right": (math.pi / 2.0, 0.0),
    "back": (math.pi, 0.0),
    "down": (0.0, math.radians(-30.0)),
}
"""Directions of a camera that have names: how far to the right and up, in radians."""
DIRECTION_NAMES: Final = {
    "ahead": sentence("ahead"),
    "left": sentence("to the left"),
    "right": sentence("to the right"),
    "back": sentence("backwards"),
    "down": sentence("down"),
}
"""What pages call `DIRECTIONS`."""


class CameraHead:
    """The pan-tilt unit of a camera's component. Motions need control."""

    def __init__(self, robot: Robot, component: ComponentInfo) -> None:
        self._client = robot.component(str(component.id))
        self._limits: tuple[tuple[float, float], tuple[float, float]] | None = None

    async def direction(self) -> tuple[float, float]:
        """Where the camera looks now, relative to the robot."""
        report = await self._client.service(PAN_TILT_SENSOR).query(
            QueryPanTiltJointPositions(), expects=ReportPanTiltJointPositions
        )
        return report.joint1_position, report.joint2_position

    async def look(self, right: float, up: float) -> None:
        """Turn the camera there, or as near as its limits allow."""
        limits = await self._read_limits()
        wanted = [min(high, max(low, angle)) for angle, (low, high) in zip((right, up), limits, strict=True)]
        await self._client.service(PAN_TILT_DRIVER).send(SetPanTiltJointPositions(*wanted), ack=True)

    async def _read_limits(self) -> tuple[tuple[float, float], tuple[float, float]]:
        if self._limits is None:
            ends = [(-math.pi, math.pi)] * 2
            if self._client.info.find(DESCRIPTION):
                service = self._client.service(DESCRIPTION)
                table = table_of(await service.query(QueryJointDescription(), expects=ReportJointDescription))
                lower = table.to_reported({joint.name: joint.lower for joint in table.joints})
                upper = table.to_reported({joint.name: joint.upper for joint in table.joints})
                ends = [(max(-math.pi, min(pair)), min(math.pi, max(pair))) for pair in zip(lower, upper, strict=True)]
            self._limits = (ends[0], ends[1])
        return self._limits


def pans_and_tilts(component: ComponentInfo) -> bool:
    """True if the camera of a component can be turned."""
    return component.find(PAN_TILT_DRIVER) is not None and component.find(PAN_TILT_SENSOR) is not None


@dataclass(frozen=True, slots=True)
class Lens:
    """The present fields of view, radians."""

    horizontal: float
    vertical: float

    def angles(self, x: float, y: float) -> tuple[float, float]:
        """From the middle of the picture to a place: to the right and upwards."""
        return (
            math.atan((2.0 * x - 1.0) * math.tan(self.horizontal / 2.0)),
            math.atan((1.0 - 2.0 * y) * math.tan(self.vertical / 2.0)),
        )

    def ray(self, x: float, y: float) -> Vector:
        """The direction of a place in the frame of the camera's link, which looks along x; of length 1."""
        across = (1.0 - 2.0 * x) * math.tan(self.horizontal / 2.0)
        up = (1.0 - 2.0 * y) * math.tan(self.vertical / 2.0)
        length = math.hypot(1.0, across, up)
        return 1.0 / length, across / length, up / length

    def width_share(self, width: float, distance: float) -> float:
        """The share of the picture's width that `width` metres across have at a distance in metres."""
        return width / (2.0 * distance * math.tan(self.horizontal / 2.0))


async def lens_of(robot: Robot, component: ComponentInfo, aspect: float) -> Lens:
    """The present field of view of a camera; `aspect` is the width of its picture by the height.

    Raises `ConfigError` for a camera that does not report it.
    """
    if not component.find(LENS):
        raise ConfigError(
            sentence(
                "{component} does not report its field of view: it offers no {lens}", component=component.id, lens=LENS
            )
        )
    query = QueryVisualSensorConfiguration(
        [QueryVisualSensorConfiguration.QueryVisualSensorConfigurationRec(1, 0xFFFF)]
    )
    report = await robot.component(str(component.id)).service(LENS).query(query)
    for record in report.visual_sensor_configuration_list:
        across = record.horizontal_field_of_view
        if across is not None and 0.0 < across < math.pi:
            return Lens(across, 2.0 * math.atan(math.tan(across / 2.0) / aspect))
    raise ConfigError(sentence("{component} does not report its field of view", component=component.id))


@dataclass(frozen=True, slots=True)
class Sight:
    """What a ray meets first: the distance in metres along it, and how this is known."""

    distance: float
    source: str


async def sight(world: World, robot: Robot, component: ComponentInfo, ray: Vector) -> Sight:
    """How far away is what a camera sees along a ray in the frame of its link.

    By the cloud of a depth camera on that link if the console receives it, else by the nearer of the lidar's echo in
    that direction, as if it stood upright, and the floor, as if it were level. Raises `ConfigError` if none tells.
    """
    await world.geometry()
    name = await sensor_name(robot.component(str(component.id)))
    model, description = world.model, world.description
    setup = None if model is None else next((each for each in model.cameras if each.name == name), None)
    if setup is None or description is None or setup.link not in description.links():
        raise ConfigError(
            sentence(
                "where the camera {name} sits is not known here: the robot's file is not on this machine", name=name
            )
        )
    for cloud in list(world.clouds.values()):
        if (found := depth_along(cloud, setup.link, ray)) is not None:
            return Sight(found, sentence("depth camera"))
    frame = FrameTree(description).pose(setup.link, world.positions)
    direction = (frame @ Transform(position=ray)).position
    direction = (direction[0] - frame.position[0], direction[1] - frame.position[1], direction[2] - frame.position[2])
    floor = -world.pose.z if world.pose is not None else 0.0
    echo = echo_along(world.echoes(), frame.position, direction)
    ground = floor_along(floor, frame.position, direction)
    told = [each for each in (echo, ground) if each is not None]
    if not told:
        raise ConfigError(
            sentence("nothing tells how far away that is: no echo of a lidar in this direction, and no floor")
        )
    return min(told, key=lambda each: each.distance)


def depth_along(cloud: bytes, link: str, ray: Vector) -> float | None:
    """The distance of the points of a cloud near a ray; None if the cloud is of another link, or has none there."""
    _, values, length, count = CLOUD_HEADER.unpack_from(cloud)
    start = CLOUD_HEADER.size + length
    if cloud[CLOUD_HEADER.size : start].decode(errors="replace").strip() != link:
        return None
    distances = []
    for number in range(count):
        point = struct.unpack_from("<3f", cloud, start + 4 * values * number)
        far = math.hypot(*point)
        if far > 0.0 and sum(a * b for a, b in zip(point, ray, strict=True)) > far * math.cos(NEAR_ANGLE):
            distances.append(far)
    return sorted(distances)[len(distances) // 2] if distances else None


def echo_along(echoes: Iterable[tuple[float, float]], origin: Vector, direction: Vector) -> Sight | None:
    """The distance to the nearest echo with the bearing of a ray, if that goes on upright."""
    level = math.hypot(direction[0], direction[1])
    if level < 1e-3:
        return None
    bearing = math.atan2(direction[1], direction[0])
    nearest = math.inf
    for x, y in echoes:
        away = (x - origin[0], y - origin[1])
        off = math.remainder(math.atan2(away[1], away[0]) - bearing, math.tau)
        if abs(off) <= NEAR_BEARING:
            nearest = min(nearest, math.hypot(*away))
    return Sight(nearest / level, sentence("lidar, if upright")) if math.isfinite(nearest) else None


def floor_along(floor: float, origin: Sequence[float], direction: Sequence[float]) -> Sight | None:
    """The distance to a level floor at this height; None for a ray that does not go down."""
    if direction[2] > -1e-3 or origin[2] <= floor:
        return None
    return Sight((floor - origin[2]) / direction[2], sentence("floor, if level"))


def shown(found: Sight, width: float | None, conventions: Conventions) -> str:
    """The distance as text, with the width of the gripper in metres if it is drawn."""
    text = sentence("{distance} ({source})", distance=conventions.distance(found.distance), source=found.source)
    return text if width is None else sentence("{text}, gripper {width:.0f} mm", text=text, width=1000.0 * width)


async def gripper_width(robot: Robot) -> float | None:
    """Metres between the fingers of the robot's only gripper; None if it reports none."""
    try:
        return await robot.gripper.width()
    except JausError:
        return None
