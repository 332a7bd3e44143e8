"""What the mobility services of a component share: the chassis, its frames, and who drives it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jauspy.errors import ConfigError
from jauspy.geometry.poses import Pose, jaus_pose
from jauspy.platform.chassis import Chassis
from jauspy.platform.contract import DriveBase
from jauspy.services.mobility.global_frame import GlobalFrame, GlobalPose
from jauspy.services.mobility.local_frame import LocalFrame
from jauspy.services.mobility.pilot import Pilot

if TYPE_CHECKING:
    from jauspy.services.mobility.waypoint import Waypoint


class Vehicle:
    """One platform, as one component sees it. `origin`: where its world lies on the globe, None for nowhere."""

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
        self.local = LocalFrame()
        self._globe = GlobalFrame(origin) if origin else None
        self.goal: Waypoint | None = None
        """The waypoint that the client in control has set for one of the waypoint drivers, in whichever frame."""
        self.waypoint: Waypoint | None = None
        """The waypoint that was last set, or that a list last went for."""

    @property
    def pose(self) -> Pose:
        """Where it is in the world, in JAUS axes."""
        return jaus_pose(self.drive.pose())

    @property
    def has_origin(self) -> bool:
        """True when it is known where the world lies on the globe."""
        return self._globe is not None

    def georeference(self) -> GlobalFrame:
        """Where the world lies on the globe; `ConfigError` when nobody has said so."""
        if self._globe is None:
            raise ConfigError("services on the globe need an origin: latitude, longitude, altitude and heading")
        return self._globe
