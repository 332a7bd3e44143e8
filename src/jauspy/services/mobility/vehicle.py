"""The vehicle: chassis, pilot, reference frames and waypoint, which the mobility services of a component share."""

from __future__ import annotations

import math

from jauspy.errors import ConfigError
from jauspy.geometry.poses import PlanarPoint, Pose, jaus_pose, wrap_angle
from jauspy.platform.chassis import Chassis
from jauspy.platform.contract import DriveBase
from jauspy.platform.guards import ObstacleGuard
from jauspy.platform.localization import Localization
from jauspy.platform.stability import StabilityMonitor
from jauspy.services.mobility.pilot import Pilot
from jauspy.services.mobility.reference_frames import GlobalFrame, GlobalPose, LocalFrame
from jauspy.services.mobility.waypoints import Waypoint


class Vehicle:
    """One platform. `origin`: global pose of the world's origin; services on the globe need it.

    `localization`: the estimated pose on the globe, unless the pose is exact; `drive` then has the estimated local
    pose. `stability`: what keeps it from tipping over. `obstacle_guard`: the guard that its commands pass.
    """

    def __init__(
        self,
        drive: DriveBase,
        *,
        name: str = "",
        chassis: Chassis | None = None,
        origin: GlobalPose | None = None,
        localization: Localization | None = None,
        stability: StabilityMonitor | None = None,
        obstacle_guard: ObstacleGuard | None = None,
    ) -> None:
        self.drive = drive
        self.localization = localization
        self.name = name
        self.chassis = chassis or Chassis()
        self.pilot = Pilot(
            drive, self.chassis, localization=localization, stability=stability, obstacle_guard=obstacle_guard
        )
        self.local_frame = LocalFrame()
        self._global_frame = GlobalFrame(origin) if origin else None
        self.goal: Waypoint | None = None
        """The waypoint that the controlling client has set, local or global."""
        self.waypoint: Waypoint | None = None
        """The waypoint that was last set, or that a list last drove to."""

    @property
    def pose(self) -> Pose:
        """The pose in the world, in JAUS axes, by dead reckoning: it never jumps, and the pilot steers by it."""
        return jaus_pose(self.drive.pose())

    @property
    def pose_on_globe(self) -> Pose:
        """The pose in the world, in JAUS axes, from the estimated position on the globe: it may jump."""
        return self.pose if self.localization is None else jaus_pose(self.localization.state().globe.pose)

    @property
    def has_origin(self) -> bool:
        """True if the pose of the world on the globe is known."""
        return self._global_frame is not None

    def global_frame(self) -> GlobalFrame:
        """The global frame. Raises `ConfigError` without an origin."""
        if self._global_frame is None:
            raise ConfigError("services on the globe need an origin: latitude, longitude, altitude and heading")
        return self._global_frame

    def point_on_globe(self, latitude: float, longitude: float) -> PlanarPoint:
        """A point of the globe (degrees) in the frame of `pose`, by the present estimate."""
        point = self.global_frame().to_world(latitude, longitude)
        if self.localization is None:
            return point
        on_globe, local = self.pose_on_globe, self.pose
        distance, direction = PlanarPoint(on_globe.x, on_globe.y).to(point)
        direction += local.yaw - on_globe.yaw
        return PlanarPoint(local.x + distance * math.cos(direction), local.y + distance * math.sin(direction))

    def heading_on_globe(self, heading: float) -> float:
        """A true heading (rad) in the frame of `pose`, by the present estimate."""
        turn = self.pose.yaw - self.pose_on_globe.yaw
        return wrap_angle(self.global_frame().heading_to_world(heading) + turn)
