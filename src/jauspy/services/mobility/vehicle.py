"""The vehicle: chassis, pilot, reference frames and waypoint, which the mobility services of a component share."""

from __future__ import annotations

from jauspy.errors import ConfigError
from jauspy.geometry.poses import Pose, jaus_pose
from jauspy.platform.chassis import Chassis
from jauspy.platform.contract import DriveBase
from jauspy.services.mobility.pilot import Pilot
from jauspy.services.mobility.reference_frames import GlobalFrame, GlobalPose, LocalFrame
from jauspy.services.mobility.waypoints import Waypoint


class Vehicle:
    """One platform. `origin`: global pose of the world's origin; services on the globe need it."""

    def __init__(
        self,
        drive: DriveBase,
        *,
        name: str = "",
        chassis: Chassis | None = None,
        origin: GlobalPose | None = None,
    ) -> None:
        self.drive = drive
        self.name = name
        self.chassis = chassis or Chassis()
        self.pilot = Pilot(drive, self.chassis)
        self.local_frame = LocalFrame()
        self._global_frame = GlobalFrame(origin) if origin else None
        self.goal: Waypoint | None = None
        """The waypoint that the controlling client has set, local or global."""
        self.waypoint: Waypoint | None = None
        """The waypoint that was last set, or that a list last drove to."""

    @property
    def pose(self) -> Pose:
        """The pose in the world, in JAUS axes."""
        return jaus_pose(self.drive.pose())

    @property
    def has_origin(self) -> bool:
        """True if the pose of the world on the globe is known."""
        return self._global_frame is not None

    def global_frame(self) -> GlobalFrame:
        """The global frame. Raises `ConfigError` without an origin."""
        if self._global_frame is None:
            raise ConfigError("services on the globe need an origin: latitude, longitude, altitude and heading")
        return self._global_frame
