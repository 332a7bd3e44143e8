"""Finds the thing with a camera, reaches for it, grasps and lifts it."""

from __future__ import annotations

import asyncio
import math
from contextlib import AsyncExitStack
from pathlib import Path
from typing import TYPE_CHECKING, Final, NamedTuple

import cv2
import numpy as np
from numpy.typing import NDArray

from jauspy.demo import plan
from jauspy.demo.arm import Arm, ArmKinematics
from jauspy.demo.plan import Plan
from jauspy.demo.report import StageResult
from jauspy.errors import RequestError
from jauspy.geometry.poses import Pose, Transform
from jauspy.geometry.vectors import Vector, difference
from jauspy.ocu.camera import Camera
from jauspy.ocu.frames import LOCAL, RobotFrames
from jauspy.ocu.robot import Robot
from jauspy.planning.colours import HUES, MIN_SATURATION, MIN_VALUE
from jauspy.platform.description import RobotModel

if TYPE_CHECKING:
    from jauspy.platform.camera import Image

ARM_CAMERA: Final = "arm"
STILL_FILE: Final = "still.jpg"
WIDTH_TOLERANCE: Final = 0.006
"""Metres; tolerance of the finger distance against the can's width."""
WEIGHT_TOLERANCE: Final = 0.2
"""Kilograms; tolerance of the measured weight."""
MAX_SINK: Final = 0.005
"""Metres that the tool may sink while it holds the can."""


class Grasp:
    """Finds the thing of the plan with the arm's camera, grasps it and lifts it."""

    def __init__(
        self,
        arm: Arm,
        frames: RobotFrames,
        model: RobotModel,
        camera: Camera,
        *,
        size: tuple[int, int],
        goals: Plan,
    ) -> None:
        """`camera` is that of the arm, `size` that of its stills: width and height in pixels."""
        self._arm, self._frames, self._plan = arm, frames, goals
        self._camera, self._size = camera, size
        self._setup = next(camera for camera in model.cameras if camera.name == ARM_CAMERA)
        self._target: Vector = (0.0, 0.0, 0.0)
        self._empty = 0.0
        self._tilt = Transform()
        self._grasped = 0.0

    async def look(self, folder: Path) -> StageResult:
        """Find the thing in a still of the arm's camera, and compute its position from the camera's pose."""
        thing = self._plan.thing
        await self._arm.go(0.0, *self._plan.view)
        await asyncio.sleep(plan.SETTLING_TIME)
        photo = await self._camera.still(size=self._size, format="jpeg", timeout=plan.CAMERA_TIMEOUT)
        (folder / STILL_FILE).write_bytes(photo.content)
        frames = await self._frames.read()
        image = decode_image(photo.content)
        base = frames.pose("base_link", LOCAL)
        tilt = level(base)
        # From below the base, which stands on the floor: a drift of the pose, its height too, does not matter here.
        camera = tilt @ base.inverse() @ frames.pose(self._setup.link, LOCAL)
        region = red_region(image)
        support = thing.support if thing.band is None else self._support(image, camera)
        near = region and at_height(camera, ray(region, self._setup.fov), support + thing.size / 2.0)
        if near is None:
            raise RequestError(
                f"no red {thing.name} is in the picture of the camera {ARM_CAMERA!r}; see {folder / STILL_FILE}"
            )
        x, y, _ = near
        self._target = x, y, support + thing.grip_height
        seen = base.apply(tilt.inverse().apply(near))
        off = math.dist(seen[:2], (thing.x + self._plan.goal.slip, thing.y))
        return StageResult(
            "look",
            f"the {thing.name} is seen {math.hypot(x, y):.2f} m away, {_bearing(math.atan2(y, x))}, "
            f"{100 * off:.1f} cm from its nominal position, {100 * support:.1f} cm above the ground",
            off <= plan.MAX_OFFSET and abs(support - thing.support) <= plan.MAX_SUPPORT_ERROR,
            {"x": seen[0], "y": seen[1], "from_plan": off, "support": support},
        )

    def _support(self, image: Image, camera: Transform) -> float:
        """Height of what the thing stands on, by the height of what is red of it."""
        band, thing = red_band(image), self._plan.thing
        assert thing.band is not None
        if band is None:
            return thing.support
        low, high = (ray(end, self._setup.fov) for end in (band.bottom, band.top))
        return lower_end(camera, low, high, thing.band) - (thing.size - thing.band) / 2.0

    async def reach(self) -> StageResult:
        """Weigh the empty gripper above the thing, then move the open gripper around it."""
        opened = await self._arm.open_gripper()
        errors = [await self._go(*self._plan.high), await self._go(*self._plan.over)]
        self._empty = await self._arm.weight()
        errors += [await self._go(*step, duration=plan.APPROACH_TIME) for step in self._plan.approach]
        attitude, (x, y, z) = self._tilt.to_pose(), self._target
        return StageResult(
            "reach",
            f"{len(errors)} poses of five joints, each at most {math.degrees(max(errors)):.2f}° off; "
            f"the fingers are {100 * opened:.1f} cm apart, the chassis pitches by {math.degrees(attitude.pitch):+.2f}°",
            opened > self._plan.thing.width,
            {
                "joint_error": max(errors),
                "opened": opened,
                "base_pitch": attitude.pitch,
                "base_roll": attitude.roll,
                "target_x": x,
                "target_y": y,
                "target_z": z,
            },
        )

    async def close(self) -> StageResult:
        """Close the gripper around it."""
        thing, width = self._plan.thing, await self._arm.close_gripper()
        self._grasped = await self._arm.tool_height()
        return StageResult(
            "grasp",
            f"the fingers stop {100 * width:.2f} cm apart, at a {thing.name} of {100 * thing.width:g} cm",
            abs(width - thing.width) <= WIDTH_TOLERANCE,
            {"width": width},
        )

    async def lift(self) -> StageResult:
        """Lift and hold it; check its weight at the wrist and the distance of the fingers."""
        await self._go(*self._plan.over)
        weight = await self._arm.weight() - self._empty
        top = await self._arm.tool_height()
        await asyncio.sleep(plan.HOLD_TIME)
        end, width = await self._arm.tool_height(), await self._arm.width()
        lifted = min(top, end) - self._grasped
        thing = self._plan.thing
        held = abs(width - thing.width) <= WIDTH_TOLERANCE and abs(weight - thing.weight) <= WEIGHT_TOLERANCE
        return StageResult(
            "lift",
            f"{100 * lifted:.1f} cm by the arm's pose, held {plan.HOLD_TIME:g} s; the wrist measures {weight:.2f} kg, "
            f"the fingers are {100 * width:.2f} cm apart",
            lifted >= plan.MIN_LIFT and held and top - end <= MAX_SINK,
            {"lifted": lifted, "weight": weight, "width": width, "sunk": top - end},
        )

    async def _go(self, farther: float, higher: float, *, duration: float | None = None) -> float:
        """Move the gripper to an offset from the target, with the attitude that the chassis has now."""
        self._tilt = level((await self._frames.read()).pose("base_link", LOCAL))
        pose = gripper_pose(self._arm.kinematics, self._tilt, self._target, (farther, higher), self._plan.pitch)
        return await self._arm.go(*pose, duration=duration)


def level(base: Transform) -> Transform:
    """The pose of the base in a level frame with its place and heading: pitch and roll only."""
    pose = base.to_pose()
    return Transform.from_pose(Pose(roll=pose.roll, pitch=pose.pitch))


def gripper_pose(
    kinematics: ArmKinematics, tilt: Transform, target: Vector, offset: tuple[float, float], pitch: float
) -> tuple[float, float, float, float]:
    """Turn, distance, height and pitch for the arm that hold the gripper at a target in the level frame.

    `tilt` is the pose of the base in the level frame, `offset` metres farther out from the arm's axis and higher than
    the target, `pitch` that of the gripper against the horizon.
    """
    x, y, z = target
    foot = tilt.apply((kinematics.axis, 0.0, 0.0))
    heading = math.atan2(y - foot[1], x - foot[0])
    out = math.cos(heading), math.sin(heading)
    point = x + offset[0] * out[0], y + offset[0] * out[1], z + offset[1]
    ahead = math.cos(pitch) * out[0], math.cos(pitch) * out[1], math.sin(pitch)
    to_base = tilt.inverse()
    return *kinematics.around(to_base.apply(point)), math.asin(to_base.rotate(ahead)[2])


def _bearing(bearing: float) -> str:
    return f"{math.degrees(abs(bearing)):.1f}° to the {'left' if bearing > 0.0 else 'right'}"


REDS: Final = tuple(((low, MIN_SATURATION, MIN_VALUE), (high, 255, 255)) for low, high in HUES["red"])
"""Lower and upper hue (0..180), saturation and value of red, at both ends of the hues; bricks are less saturated."""
MIN_RED_SHARE: Final = 2e-4
"""Minimal share of the picture."""
GAP: Final = 25
"""Pixels between parts of one region."""


def decode_image(file: bytes) -> Image:
    """Decode a JPEG or PNG to RGB, shape (height, width, 3)."""
    read = cv2.imdecode(np.frombuffer(file, np.uint8), cv2.IMREAD_COLOR)
    if read is None:
        raise RequestError(f"the {len(file)} bytes of the still are not an image")
    return cv2.cvtColor(read, cv2.COLOR_BGR2RGB).astype(np.uint8)


def red_region(image: Image) -> tuple[float, float] | None:
    """Centre of the largest red region from the image centre, as fractions of the width; None if there is none."""
    pixels = _red_pixels(image)
    return None if pixels is None else _fractions(image, float(pixels[1].mean()), float(pixels[0].mean()))


class Band(NamedTuple):
    """The middles of the upper and the lower edge, from the image centre as fractions of the width."""

    top: tuple[float, float]
    bottom: tuple[float, float]


def red_band(image: Image) -> Band | None:
    """The ends of the largest red region along its axis, which may lean; None if there is none."""
    pixels = _red_pixels(image)
    if pixels is None:
        return None
    rows, columns = pixels
    lines = np.unique(rows)
    middles = [(columns[rows == line].min() + columns[rows == line].max()) / 2.0 for line in lines]
    lean, start = map(float, np.polyfit(lines, middles, 1) if len(lines) > 1 else (0.0, middles[0]))
    on_axis = rows[np.abs(columns - (start + lean * rows)) <= 0.5]
    edges = float(on_axis.min()) - 0.5, float(on_axis.max()) + 0.5
    top, bottom = (_fractions(image, start + lean * edge, edge) for edge in edges)
    return Band(top, bottom)


def _red_pixels(image: Image) -> tuple[NDArray[np.intp], NDArray[np.intp]] | None:
    """Rows and columns of the largest red region."""
    colours = cv2.cvtColor(image, cv2.COLOR_RGB2HSV)
    red = np.zeros(image.shape[:2], np.uint8)
    for low, high in REDS:
        red |= cv2.inRange(colours, np.array(low), np.array(high)).astype(np.uint8)
    near = cv2.dilate(red, np.ones((GAP, GAP), np.uint8))  # what covers parts of the thing divides it
    _, labels = cv2.connectedComponents(near)
    sizes = np.bincount(labels[red > 0], minlength=2)
    largest = 1 + int(np.argmax(sizes[1:]))
    if sizes[largest] < MIN_RED_SHARE * red.size:
        return None
    rows, columns = np.nonzero((labels == largest) & (red > 0))
    return rows, columns


def _fractions(image: Image, column: float, row: float) -> tuple[float, float]:
    height, width = image.shape[:2]
    return (column + 0.5 - width / 2.0) / width, (row + 0.5 - height / 2.0) / width


def ray(region: tuple[float, float], fov: float) -> Vector:
    """Direction of a point in the camera's frame: x forward, y left, z up. `fov` is horizontal, rad."""
    width = 2.0 * math.tan(fov / 2.0)
    return 1.0, -width * region[0], -width * region[1]


def at_height(camera: Transform, direction: Vector, height: float) -> Vector | None:
    """Intersection of a ray from the camera with a horizontal plane; None without one."""
    far = difference(camera.apply(direction), camera.position)
    if far[2] >= 0.0 or camera.position[2] <= height:
        return None
    times = (height - camera.position[2]) / far[2]
    return camera.position[0] + times * far[0], camera.position[1] + times * far[1], height


def lower_end(camera: Transform, low: Vector, high: Vector, length: float) -> float:
    """Height of the lower end of an upright line of this length, m; its ends are seen along two rays of the camera.

    Both ends are equally far away, so that the difference of the rays' slopes gives the distance.
    """
    below, above = camera.rotate(low), camera.rotate(high)
    slopes = below[2] / math.hypot(*below[:2]), above[2] / math.hypot(*above[:2])
    distance = length / max(slopes[1] - slopes[0], MIN_SLOPE)
    return camera.position[2] + distance * slopes[0]


MIN_SLOPE: Final = 1e-3
AIM_TOLERANCE: Final = 0.01
"""Radians."""


async def aim(stack: AsyncExitStack, robot: Robot, mount: int, at: tuple[float, float]) -> StageResult:
    """Move pan and tilt to these angles, rad right and up; the mount stays controlled until `stack` closes."""
    await stack.enter_async_context(robot.control(mount, authority=plan.AUTHORITY))
    unit = robot.manipulator(mount)
    joints = await unit.description()
    reached = await unit.move(joints.from_reported(at), tolerance=AIM_TOLERANCE, timeout=plan.MOVE_TIMEOUT)
    pan, tilt = joints.to_reported(reached.positions)
    off, up = max(abs(pan - at[0]), abs(tilt - at[1])), math.degrees(tilt)
    return StageResult(
        "aim", f"the chassis' camera looks {abs(up):.1f}° {'up' if up > 0.0 else 'down'}", True, {"off": off}
    )
