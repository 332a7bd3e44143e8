"""The contract of cameras, each opened in a separate process, and viewpoints of cameras outside of a robot."""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import Enum
from typing import TYPE_CHECKING, Annotated, Final, Protocol, TypeAlias

from annotated_types import Interval

from jauspy.geometry.poses import Transform
from jauspy.geometry.vectors import Vector, add, cross, difference, dot, scaled
from jauspy.platform.imaging_settings import IDEAL, ImagingSetup
from jauspy.platform.tables import Converted, Prepared, Table, UrdfName

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Image: TypeAlias = NDArray[np.uint8]
    """Rows of pixels from top to bottom: red, green, blue; shape (height, width, 3)."""
    Distances: TypeAlias = NDArray[np.float32]
    """Depth of each pixel along the camera's x axis, in metres; inf where nothing is; shape (height, width)."""


class Quality(Enum):
    """Quality of rendered pictures: without shadows, with shadows, or with finer shadows and smooth edges."""

    LOW = "low"
    MEDIUM = "medium"
    HIGH = "high"


class Viewpoint(Enum):
    """The motion of an outside camera: fixed in the world, behind the robot, or on a circle around it."""

    FIXED = "fixed"
    CHASE = "chase"
    ORBIT = "orbit"


def _table_of_view(given: object) -> object:
    """The table of which `outside = "chase"` is a short form."""
    return {"view": given} if isinstance(given, str) else given


_Length: TypeAlias = Annotated[float, Interval(ge=-1000.0, le=1000.0)]


@dataclass(frozen=True, slots=True)
class OutsideSetup(Table):
    """The viewpoint of a camera outside of the robot: the table `outside`."""

    view: Viewpoint
    position: tuple[_Length, _Length, _Length] = (-3.0, -3.0, 2.0)
    """Position of a fixed camera in the world, in metres."""
    target: tuple[_Length, _Length, _Length] | None = None
    """Point of the world at which a fixed camera looks, in metres; None: the robot."""
    distance: Annotated[float, Interval(ge=0.5, le=100.0)] = 2.6
    """Metres from the robot, over the ground, of a camera that moves with it."""
    height: Annotated[float, Interval(ge=0.0, le=100.0)] = 1.5
    """Metres above the robot's base, of a camera that moves with it."""
    aim: Annotated[float, Interval(ge=-10.0, le=10.0)] = 0.35
    """Height above the robot's base at which the camera looks, in metres."""
    angle: Annotated[float, Interval(ge=-360.0, le=360.0), Converted(math.radians)] = 0.0
    """Radians (degrees in the file) from straight behind the robot, counterclockwise; at the start of an orbit."""
    period: Annotated[float, Interval(ge=1.0, le=3600.0)] = 24.0
    """Seconds of one turn around the robot."""


@dataclass(frozen=True, slots=True)
class CameraSetup(Table):
    """A camera of a robot: it looks along its link's x axis, z is up; or one outside of it."""

    name: UrdfName
    link: UrdfName = ""
    """Empty for a camera outside of the robot."""
    fov: Annotated[float, Interval(ge=5.0, le=150.0), Converted(math.radians)] = math.radians(80.0)
    """Horizontal field of view, in radians (degrees in the file); the widest of a camera that zooms."""
    imaging: ImagingSetup = IDEAL
    """Limits and faults of its lens and sensor."""
    outside: Annotated[OutsideSetup | None, Prepared(_table_of_view)] = None
    """The viewpoint of a camera outside of the robot, in place of a link."""

    def __post_init__(self) -> None:
        if bool(self.link) == (self.outside is not None):
            raise ValueError("link: a camera needs the link that carries it, or else `outside`, and not both")


@dataclass(frozen=True, slots=True)
class CameraFrame:
    """A picture, and its time in seconds of the machine's monotonic clock."""

    image: Image
    taken: float
    light: NDArray[np.float32] | float = 1.0
    """The light on each pixel, shape (height, width), or one number for all. 1 is the light in which the picture was
    rendered; the picture is darkened where it is less."""
    distances: Distances | None = None
    """Depths of the pixels, if requested."""


@dataclass(frozen=True, slots=True)
class DepthFrame:
    """A picture and the depths of its pixels, each along the ray through the pixel's centre."""

    image: Image
    distances: Distances
    taken: float
    """Time of the picture, in seconds of the machine's monotonic clock."""


class CameraSession(Protocol):
    """An open camera. It belongs to one thread at a time."""

    @property
    def description(self) -> str:
        """Description of the source of images, for the log."""
        ...

    @property
    def reduced(self) -> bool:
        """True if pictures are of lower quality than on other machines; the description says why."""
        ...

    @property
    def simplifications(self) -> int:
        """The number of qualities below that of the robot, each of which takes less time."""
        ...

    def simplify(self, steps: int) -> None:
        """Render at a quality that many steps below that of the robot, because pictures take too long; 0 ends this."""
        ...

    def release(self) -> None:
        """Leave the thread: the next one that calls has the camera."""
        ...

    def look(
        self,
        width: int,
        height: int,
        *,
        thoroughly: bool = False,
        fov: float | None = None,
        distances: bool = False,
    ) -> CameraFrame:
        """Render the robot's newest state; with `thoroughly` at better quality, in up to half a second.

        `fov` is the horizontal field of view in radians, that of the setup by default; `distances` requests depths.
        """
        ...

    def measure(self, width: int, height: int) -> DepthFrame:
        """Render with depths, possibly in fewer pixels of the same field of view if this size would take too long."""
        ...

    def close(self) -> None:
        """Release all resources. May be called twice."""
        ...


class CameraSource(Protocol):
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


LAG: Final = 0.8
"""Time constant, in seconds, with which a chasing camera follows a turn of the robot."""
FOLLOWING: Final = 0.35
"""Seconds that a camera is behind a robot at constant speed. What is shorter, such as a bump, does not move it."""
AIMING: Final = 0.15
"""Seconds that the point at which it looks is behind the robot."""
MAX_AIM_ERROR: Final = 0.2
"""Greatest distance of that point from the robot, as a fraction of the camera's distance: the robot stays in view."""
MIN_HEIGHT: Final = 0.15
"""Least height of a camera above the world's zero, in metres."""
_UP: Final = (0.0, 0.0, 1.0)


class _Smoothed:
    """A point that follows another one as a critically damped spring does: it starts and stops without a jerk."""

    def __init__(self, delay: float) -> None:
        """`delay`: seconds that it is behind a point that moves at constant speed."""
        self._rate = 2.0 / delay
        self._offset: Vector | None = None
        self._velocity = (0.0, 0.0, 0.0)
        self._last = (0.0, 0.0, 0.0)

    def follow(self, point: Vector, elapsed: float) -> Vector:
        """The place after `elapsed` seconds in which the other point was at `point`; at first, that point itself."""
        before = (0.0, 0.0, 0.0) if self._offset is None else add(self._offset, difference(self._last, point))
        # x'' = -w^2 x - 2 w x' has the solution x(t) = (x + (v + w x) t) exp(-w t)
        rate, decay = self._rate, math.exp(-self._rate * elapsed)
        slope = add(self._velocity, scaled(before, rate))
        self._offset = scaled(add(before, scaled(slope, elapsed)), decay)
        self._velocity = scaled(difference(self._velocity, scaled(slope, rate * elapsed)), decay)
        self._last = point
        return add(point, self._offset)


class OutsideView:
    """Follows a robot; the same poses at the same times give the same views."""

    def __init__(self, setup: OutsideSetup) -> None:
        self._setup = setup
        self._began = self._last = math.nan
        self._heading = 0.0
        self._centre, self._aim = _Smoothed(FOLLOWING), _Smoothed(AIMING)

    @property
    def follows(self) -> bool:
        """True if the camera moves with the robot."""
        return self._setup.view is not Viewpoint.FIXED

    def ends(self, time: float, base: Transform) -> tuple[Vector, Vector]:
        """The positions of the camera and of the point at which it looks, in the world.

        `base` is the robot's, `time` in seconds.
        """
        setup, (x, y, z) = self._setup, base.position
        elapsed = 0.0 if math.isnan(self._last) else max(time - self._last, 0.0)
        centre = self._centre.follow(base.position, elapsed)
        aim = self._aim.follow((x, y, z + setup.aim), elapsed)
        heading = math.atan2(base.rotation[1][0], base.rotation[0][0])
        if math.isnan(self._last):
            self._began, self._heading = time, heading
        self._last = time
        turn = math.remainder(heading - self._heading, math.tau)
        self._heading += turn * -math.expm1(-elapsed / LAG)
        position = self._position(centre, time)
        target = _near(aim, (x, y, z + setup.aim), MAX_AIM_ERROR * _length(difference(aim, position)))
        return position, setup.target if setup.view is Viewpoint.FIXED and setup.target is not None else target

    def _position(self, centre: Vector, time: float) -> Vector:
        setup, (x, y, z) = self._setup, centre
        if setup.view is Viewpoint.FIXED:
            return setup.position
        around = self._heading + setup.angle + math.pi
        if setup.view is Viewpoint.ORBIT:
            around = setup.angle + math.pi + math.tau * (time - self._began) / setup.period
        away = setup.distance
        return x + away * math.cos(around), y + away * math.sin(around), max(z + setup.height, MIN_HEIGHT)


def looking(position: Vector, target: Vector) -> Transform:
    """The frame of a camera (x ahead, y left, z up) that looks from one point at another."""
    ahead = _unit(difference(target, position))
    side = cross(_UP, ahead)
    left = _unit(side) if max(map(abs, side)) > 1e-6 else (0.0, 1.0, 0.0)
    up = cross(ahead, left)
    rows = tuple(zip(ahead, left, up, strict=True))
    return Transform((rows[0], rows[1], rows[2]), position)


def _near(point: Vector, other: Vector, most: float) -> Vector:
    """The point, or the nearest one to it that is at most so far from the other."""
    away = difference(point, other)
    far = _length(away)
    return point if far <= most else add(other, scaled(away, most / far))


def _length(a: Vector) -> float:
    return math.sqrt(dot(a, a))


def _unit(a: Vector) -> Vector:
    return scaled(a, 1.0 / _length(a))
