"""Waypoints as they are commanded: local and global, with attitude and tolerances."""

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
"""Metres; a larger tolerance fits only the wide form of a waypoint."""


@dataclass(frozen=True, slots=True)
class WaypointAttitude:
    """Radians and metres; None for what was not commanded. Only the yaw and the tolerances have an effect."""

    roll: float | None = None
    pitch: float | None = None
    yaw: float | None = None
    tolerance: float | None = None
    path_tolerance: float | None = None

    @property
    def narrow_tolerance(self) -> float | None:
        """The tolerance for the narrow form; None if it does not fit."""
        return None if self.tolerance is None or self.tolerance > MAX_TOLERANCE else self.tolerance


@dataclass(frozen=True, slots=True)
class LocalWaypoint:
    """A point in the local frame, metres."""

    x: float
    y: float
    attitude: WaypointAttitude
    z: ZPosition | None = None

    def report(self) -> ReportLocalWaypoint | None:
        """The narrow form; None if the point does not fit."""
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
        """The wide form."""
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
    """A point on the globe, degrees; altitude (m) above the WGS-84 ellipsoid, or `z` above another datum."""

    latitude: float
    longitude: float
    attitude: WaypointAttitude
    altitude: float | None = None
    z: GlobalZPosition | None = None

    def report(self) -> ReportGlobalWaypoint:
        """The narrow form, without a height above another datum."""
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
        """The wide form, without a height above the ellipsoid."""
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
    """The waypoint of a message."""
    if isinstance(msg, SetLocalWaypointExt):
        return LocalWaypoint(msg.x, msg.y, _attitude(msg, msg.heading), msg.z_position)
    z = None if msg.z is None else ZPosition(ZPosition.Choice.Z_LOCAL, msg.z)
    return LocalWaypoint(msg.x, msg.y, _attitude(msg, msg.yaw), z)


def global_waypoint(msg: SetGlobalWaypoint | SetGlobalWaypointExt) -> GlobalWaypoint:
    """The waypoint of a message."""
    if isinstance(msg, SetGlobalWaypointExt):
        return GlobalWaypoint(msg.latitude, msg.longitude, _attitude(msg, msg.heading), z=msg.z_position)
    return GlobalWaypoint(msg.latitude, msg.longitude, _attitude(msg, msg.yaw), altitude=msg.altitude)


def _attitude(
    msg: SetLocalWaypoint | SetLocalWaypointExt | SetGlobalWaypoint | SetGlobalWaypointExt, yaw: float | None
) -> WaypointAttitude:
    return WaypointAttitude(msg.roll, msg.pitch, yaw, msg.waypoint_tolerance, msg.path_tolerance)
