"""The contract of cameras, which are opened in processes of their own."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import TYPE_CHECKING, Protocol, TypeAlias

from jauspy.platform.imaging import IDEAL, ImagingSetup
from jauspy.platform.outside_view import OutsideSetup

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Image: TypeAlias = NDArray[np.uint8]
    """Rows of pixels from top to bottom: red, green, blue; shape (height, width, 3)."""
    Distances: TypeAlias = NDArray[np.float32]
    """Depth of each pixel along the camera's x axis, in metres; inf where nothing is; shape (height, width)."""


class Quality(Enum):
    """How pictures are rendered: without shadows, with shadows, or with finer shadows and smooth edges."""

    LOW = "low"
    MEDIUM = "medium"
    HIGH = "high"


@dataclass(frozen=True, slots=True)
class CameraSetup:
    """A camera of a robot: it looks along its link's x axis, z is up; or one outside of it."""

    name: str
    link: str
    """Empty for a camera outside of the robot."""
    fov: float
    """Horizontal field of view, in radians; the widest of a camera that zooms."""
    imaging: ImagingSetup = IDEAL
    """Limits and faults of its lens and sensor."""
    outside: OutsideSetup | None = None
    """Where a camera outside of the robot is."""


@dataclass(frozen=True, slots=True)
class Frame:
    """A picture, and its time in seconds of the machine's monotonic clock."""

    image: Image
    taken: float
    light: NDArray[np.float32] | float = 1.0
    """The light on what each pixel shows, of shape (height, width), or on everything: 1 is that in which it was
    rendered, so that the picture is to be darker where it is less."""
    distances: Distances | None = None
    """Depths of the pixels, if they were asked for."""


@dataclass(frozen=True, slots=True)
class DepthFrame:
    """A picture and the depths of its pixels, each along the ray through the pixel's centre."""

    image: Image
    distances: Distances
    taken: float
    """Time of the picture, in seconds of the machine's monotonic clock."""


class CameraSession(Protocol):
    """An open camera. It belongs to one thread."""

    @property
    def description(self) -> str:
        """How images are made, for the log."""
        ...

    @property
    def reduced(self) -> bool:
        """True if pictures are of lower quality than on other machines; the description says why."""
        ...

    def simplify(self) -> bool:
        """Render at the next lower quality, because pictures take too long; False if there is none."""
        ...

    def look(
        self,
        width: int,
        height: int,
        *,
        thoroughly: bool = False,
        fov: float | None = None,
        distances: bool = False,
    ) -> Frame:
        """Render the robot's newest state; with `thoroughly` at better quality, in up to half a second.

        `fov` is the horizontal field of view in radians, that of the setup by default; `distances` asks for depths.
        """
        ...

    def measure(self, width: int, height: int) -> DepthFrame:
        """Render with depths, possibly in fewer pixels of the same field of view if this size would take too long."""
        ...

    def close(self) -> None:
        """Release all resources. May be called twice."""
        ...


class Camera(Protocol):
    """Describes how to open a camera; can be pickled and sent to the process that opens it."""

    @property
    def setup(self) -> CameraSetup:
        """Name, link and field of view."""
        ...

    @property
    def descriptors(self) -> tuple[int, ...]:
        """Open files that the other process must inherit under the same numbers."""
        ...

    def open(self) -> CameraSession:
        """Open the camera in the other process; raises `ConfigError` if a package is missing."""
        ...
