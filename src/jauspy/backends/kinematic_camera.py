"""Cameras of the kinematic robot, which draw a sky and a floor of one-metre squares."""

from __future__ import annotations

import math
import struct
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import chain
from types import ModuleType
from typing import TYPE_CHECKING, Final

from jauspy.errors import ConfigError
from jauspy.geometry.frames import FrameTree
from jauspy.geometry.poses import Pose, Transform
from jauspy.platform.camera import CameraFrame, CameraSetup, DepthFrame, OutsideView, looking
from jauspy.platform.contract import DriveBase
from jauspy.platform.description import RobotModel
from jauspy.platform.joints import JointGroup, JointState, joint_positions
from jauspy.platform.shared_state import StateReader, StateWriter

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from jauspy.platform.camera import Distances, Image

STATE_LENGTH: Final = 12
"""Doubles of a camera's frame in the world: the rows of its rotation, then its origin."""

HAZE_DISTANCE: Final = 30.0
"""Metres at which the floor has the colour of the sky."""

SHADE_COUNT: Final = 64
SKY_INDEX: Final = 2 * SHADE_COUNT
"""Index of the sky in the palette, the last one."""

_SKY_COLOUR: Final = (150, 190, 230)
_LIGHT_COLOUR: Final = (170, 165, 150)
_DARK_COLOUR: Final = (95, 100, 90)


@dataclass(frozen=True, slots=True)
class FloorCamera:
    """A `Camera` whose shared state is its frame in the world."""

    setup: CameraSetup
    descriptor: int

    @property
    def descriptors(self) -> tuple[int, ...]:
        """The file descriptor of the shared state."""
        return (self.descriptor,)

    def open(self) -> FloorCameraSession:
        """Open the camera; raises `ConfigError` without NumPy."""
        try:
            return FloorCameraSession(self)
        except ImportError as error:
            raise ConfigError(f"cameras need NumPy: pip install 'jauspy[video]' ({error})") from error


class FloorCameraSession:
    """A `CameraSession`."""

    description: str = "draws sky and floor; the kinematic backend has nothing else to see"
    reduced: bool = False
    simplifications: int = 0

    def __init__(self, camera: FloorCamera) -> None:
        import numpy  # noqa: PLC0415 - an extra

        self._np = numpy
        self._fov = camera.setup.fov
        self._outside = OutsideView(camera.setup.outside) if camera.setup.outside else None
        self._palette = numpy.array(_palette(), numpy.uint8)
        self._state = StateReader(camera.descriptor)

    def simplify(self, steps: int) -> None:
        """Change nothing: there is one quality."""

    def release(self) -> None:
        """Change nothing: any thread may call."""

    def look(
        self,
        width: int,
        height: int,
        *,
        thoroughly: bool = False,  # noqa: ARG002 - it always does
        fov: float | None = None,
        distances: bool = False,
    ) -> CameraFrame:
        """Return an image of shape (height, width, 3)."""
        taken, image, far = self._see(width, height, fov)
        return CameraFrame(image, taken, distances=far if distances else None)

    def measure(self, width: int, height: int) -> DepthFrame:
        """Return an image of shape (height, width, 3) and distances of shape (height, width), in metres."""
        taken, image, distances = self._see(width, height)
        return DepthFrame(image, distances, taken)

    def close(self) -> None:
        """Release the shared state."""
        self._state.close()

    def _see(self, width: int, height: int, fov: float | None = None) -> tuple[float, Image, Distances]:
        taken, data = self._state.read()
        numbers = struct.unpack(f"={STATE_LENGTH}d", data)
        spread = math.tan((self._fov if fov is None else fov) / 2.0)
        rotation, origin = numbers[:9], numbers[9:]
        if self._outside is not None:
            base = Transform((rotation[:3], rotation[3:6], rotation[6:]), origin)
            frame = looking(*self._outside.ends(taken, base))
            rotation, origin = tuple(chain(*frame.rotation)), frame.position
        return taken, *self._picture(rotation, origin, spread, width, height)

    def _picture(
        self, rotation: Sequence[float], origin: Sequence[float], spread: float, width: int, height: int
    ) -> tuple[Image, Distances]:
        np = self._np
        pixel = np.float32(2.0 * spread / width)
        left = -pixel * (np.arange(width, dtype=np.float32) - np.float32((width - 1) / 2.0))[None, :]
        up = -pixel * (np.arange(height, dtype=np.float32) - np.float32((height - 1) / 2.0))[:, None]
        rows = np.array(rotation, np.float32).reshape(3, 3)
        x, y, z = (row[0] + row[1] * left + row[2] * up for row in rows)
        far = np.float32(-origin[2]) / np.minimum(z, np.float32(-1e-3))
        squares = (_whole(np, origin[0] + far * x) + _whole(np, origin[1] + far * y)) & 1
        shades = np.minimum(far, np.float32(HAZE_DISTANCE)) * np.float32((SHADE_COUNT - 1) / HAZE_DISTANCE)
        image: Image = self._palette[np.where(z < 0.0, squares * SHADE_COUNT + shades.astype(np.int32), SKY_INDEX)]
        return image, np.where(z < 0.0, far, np.float32(math.inf))


def _whole(numpy: ModuleType, values: NDArray[np.float32]) -> NDArray[np.int32]:
    whole: NDArray[np.int32] = numpy.floor(numpy.clip(values, -1e6, 1e6)).astype(numpy.int32)
    return whole


def _palette() -> list[tuple[int, ...]]:
    """Return the shades of light and of dark squares, from near to far, and the sky (red, green, blue)."""
    mixed = [
        tuple(
            round(near + (sky - near) * shade / (SHADE_COUNT - 1))
            for near, sky in zip(colour, _SKY_COLOUR, strict=True)
        )
        for colour in (_LIGHT_COLOUR, _DARK_COLOUR)
        for shade in range(SHADE_COUNT)
    ]
    return [*mixed, _SKY_COLOUR]


class KinematicCameras:
    """The cameras, and a shared state with the frame in the world for each link that carries cameras.

    Cameras outside of the robot share one with the frame of its base.
    """

    def __init__(self, robot: RobotModel, drive: DriveBase, groups: Mapping[str, JointGroup]) -> None:
        self._drive, self._groups = drive, groups
        self._tree = FrameTree(robot.description)
        self._states = {camera.link: StateWriter(STATE_LENGTH) for camera in robot.cameras}
        self._joints: tuple[JointState, ...] | None = None
        self._base: Pose | None = None
        self._frames: Mapping[str, Transform] = {}
        """The links' frames in the root link's frame at `_joints`; kept because joints rarely move."""
        self._numbers: Mapping[str, bytes] = {}
        """What is written for each link at `_joints` and `_base`."""
        self.cameras: Mapping[str, FloorCamera] = {
            setup.name: FloorCamera(setup, self._states[setup.link].descriptor) for setup in robot.cameras
        }
        self.update()

    def update(self) -> None:
        """Write the present frames to the shared states."""
        if not self._states:
            return
        joints, base = tuple(group.state() for group in self._groups.values()), self._drive.pose()
        if has_moved := joints != self._joints:
            self._joints = joints
            positions = joint_positions(self._groups.values())
            self._frames = {link: self._tree.pose(link, positions) if link else Transform() for link in self._states}
        if has_moved or base != self._base:
            self._base = base
            self._numbers = {link: _numbers(Transform.from_pose(base) @ frame) for link, frame in self._frames.items()}
        for link, state in self._states.items():
            state.write(self._numbers[link])  # also when nothing has moved: the time of writing is that of the picture

    def close(self) -> None:
        """Release the shared states. May be called twice."""
        for state in self._states.values():
            state.close()
        self._states = {}


def _numbers(frame: Transform) -> bytes:
    return struct.pack(f"={STATE_LENGTH}d", *chain(*frame.rotation), *frame.position)
