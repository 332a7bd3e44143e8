"""The contract of cameras, which are opened in processes of their own."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol, TypeAlias

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Image: TypeAlias = NDArray[np.uint8]
    """Rows of pixels from top to bottom: red, green, blue; shape (height, width, 3)."""
    Distances: TypeAlias = NDArray[np.float32]
    """Of each pixel, along the camera's x axis: metres, inf where nothing is; shape (height, width)."""


@dataclass(frozen=True, slots=True)
class CameraSetup:
    """A camera of a robot: it looks along its link's x axis, z is up."""

    name: str
    link: str
    fov: float
    """From the left edge of the picture to the right one, radians."""


@dataclass(frozen=True, slots=True)
class Frame:
    """A picture, and when the robot was as it shows: seconds of the machine's monotonic clock."""

    image: Image
    taken: float


@dataclass(frozen=True, slots=True)
class DepthFrame:
    """A picture, and how far away each of its pixels is. A pixel stands for the ray through its middle."""

    image: Image
    distances: Distances
    taken: float
    """When the robot was as it shows: seconds of the machine's monotonic clock."""


class CameraSession(Protocol):
    """An open camera. It belongs to one thread."""

    @property
    def description(self) -> str:
        """How images are made, for the log."""
        ...

    @property
    def reduced(self) -> bool:
        """Its pictures are worse than another machine would make them; the description says why."""
        ...

    def look(self, width: int, height: int, *, thoroughly: bool = False) -> Frame:
        """The robot's newest state as a picture of that size; `thoroughly` may take a small machine half a second."""
        ...

    def measure(self, width: int, height: int) -> DepthFrame:
        """The same with distances; in fewer pixels, of the same field of view, where so many would take too long."""
        ...

    def close(self) -> None:
        """Release what it holds; twice is fine."""
        ...


class Camera(Protocol):
    """How to open a camera: can be pickled, and sent to the process that will look through it."""

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
