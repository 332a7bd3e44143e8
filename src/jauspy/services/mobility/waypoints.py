"""Waypoints as they are commanded: where, which way round, and how exactly."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, TypeAlias

from jauspy.messages.mobility import (
    GlobalZPosition,
    ReportGlobalWaypoint,
    ReportGlobalWaypointExt,
    ReportLocalWaypoint,
    ReportLocalWaypointExt,
    SetGlobalWaypoint,
    SetGlobalWaypointExt,
    SetLocalWaypoint,
    SetLocalWaypointExt,
    ZPosition,
)
from jauspy.services.mobility.field_ranges import MAX_XYZ, encodable_z, local_z

MAX_TOLERANCE: Final = 100.0
"""Metres; a larger tolerance fits only the wider form of a waypoint."""


@dataclass(frozen=True, slots=True)
class WaypointAttitude:
    """Radians and metres; what a client leaves out is None. A platform on the ground minds only the yaw."""

    roll: float | None = None
    pitch: float | None = None
    yaw: float | None = None
    tolerance: float | None = None
    path_tolerance: float | None = None

    @property
    def narrow_tolerance(self) -> float | None:
        """The tolerance where only 100 m fit; left out when it does not."""
        return None if self.tolerance is None or self.tolerance > MAX_TOLERANCE else self.tolerance


@dataclass(frozen=True, slots=True)
class LocalWaypoint:
    """A place in the local frame, metres."""

    x: float
    y: float
    attitude: WaypointAttitude
    z: ZPosition | None = None

    def report(self) -> ReportLocalWaypoint | None:
        """As it was set; None when it is too far away for that."""
        attitude = self.attitude
        if max(abs(self.x), abs(self.y)) > MAX_XYZ:
            return None
        return ReportLocalWaypoint(
            x=self.x,
            y=self.y,
            z=local_z(self.z),
            roll=attitude.roll,
            pitch=attitude.pitch,
            yaw=attitude.yaw,
            waypoint_tolerance=attitude.narrow_tolerance,
            path_tolerance=attitude.path_tolerance,
        )

    def report_ext(self) -> ReportLocalWaypointExt:
        """As it was set."""
        attitude = self.attitude
        return ReportLocalWaypointExt(
            x=self.x,
            y=self.y,
            z_position=encodable_z(self.z),
            roll=attitude.roll,
            pitch=attitude.pitch,
            heading=attitude.yaw,
            waypoint_tolerance=attitude.tolerance,
            path_tolerance=attitude.path_tolerance,
        )


@dataclass(frozen=True, slots=True)
class GlobalWaypoint:
    """A place on the globe, degrees; altitude (metres) above the WGS-84 ellipsoid, or `z` above another datum."""

    latitude: float
    longitude: float
    attitude: WaypointAttitude
    altitude: float | None = None
    z: GlobalZPosition | None = None

    def report(self) -> ReportGlobalWaypoint:
        """As it was set; a height above another datum is left out."""
        attitude = self.attitude
        return ReportGlobalWaypoint(
            latitude=self.latitude,
            longitude=self.longitude,
            altitude=self.altitude,
            roll=attitude.roll,
            pitch=attitude.pitch,
            yaw=attitude.yaw,
            waypoint_tolerance=attitude.narrow_tolerance,
            path_tolerance=attitude.path_tolerance,
        )

    def report_ext(self) -> ReportGlobalWaypointExt:
        """As it was set; a height above the ellipsoid is left out."""
        attitude = self.attitude
        return ReportGlobalWaypointExt(
            latitude=self.latitude,
            longitude=self.longitude,
            z_position=self.z,
            roll=attitude.roll,
            pitch=attitude.pitch,
            heading=attitude.yaw,
            waypoint_tolerance=attitude.tolerance,
            path_tolerance=attitude.path_tolerance,
        )


Waypoint: TypeAlias = LocalWaypoint | GlobalWaypoint


def local_waypoint(msg: SetLocalWaypoint | SetLocalWaypointExt) -> LocalWaypoint:
    """What a message says."""
    if isinstance(msg, SetLocalWaypointExt):
        return LocalWaypoint(msg.x, msg.y, _attitude(msg, msg.heading), msg.z_position)
    z = None if msg.z is None else ZPosition(ZPosition.Choice.Z_LOCAL, msg.z)
    return LocalWaypoint(msg.x, msg.y, _attitude(msg, msg.yaw), z)


def global_waypoint(msg: SetGlobalWaypoint | SetGlobalWaypointExt) -> GlobalWaypoint:
    """What a message says."""
    if isinstance(msg, SetGlobalWaypointExt):
        return GlobalWaypoint(msg.latitude, msg.longitude, _attitude(msg, msg.heading), z=msg.z_position)
    return GlobalWaypoint(msg.latitude, msg.longitude, _attitude(msg, msg.yaw), altitude=msg.altitude)


def _attitude(
    msg: SetLocalWaypoint | SetLocalWaypointExt | SetGlobalWaypoint | SetGlobalWaypointExt, yaw: float | None
) -> WaypointAttitude:
    return WaypointAttitude(msg.roll, msg.pitch, yaw, msg.waypoint_tolerance, msg.path_tolerance)
