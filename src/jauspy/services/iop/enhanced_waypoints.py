"""EnhancedLocalWaypointListDriver and its global twin: direction and waits at waypoints, and status of the list (IOP).

The waypoint list drivers carry the information out; see docs/adr/0189-services-of-iop-on-inc1.md.
"""

from __future__ import annotations

from typing import Any, ClassVar, Final

from jauspy.errors import ConfigError
from jauspy.messages.iop import (
    ReportEnhancedGlobalWaypointInformation,
    ReportEnhancedLocalWaypointInformation,
    ReportGlobalWaypointStatus,
    ReportLocalWaypointStatus,
    SetEnhancedGlobalWaypointInformation,
    SetEnhancedLocalWaypointInformation,
)
from jauspy.services.mobility.waypoint_drivers import (
    GlobalWaypointListDriver,
    ListProgress,
    LocalWaypointListDriver,
    WaypointListDriver,
)
from jauspy.services.mobility.waypoint_information import WaypointInformation
from jauspy.services.service import Service

_Record: Final = SetEnhancedLocalWaypointInformation.WaypointInformationRec
_Direction: Final = _Record.DirectionOfTravel
MAX_REPORTED: Final = 255
MAX_SECONDS: Final = 0xFFFF


class EnhancedWaypointListDriver(Service):
    """The base of both: one list, whose waypoints the driver of this kind carries out."""

    driver_type: ClassVar[type[WaypointListDriver]]

    def attached(self) -> None:
        """Find the driver. Raises `ConfigError` without it."""
        found = self.host.service(self.driver_type)
        if found is None:
            raise ConfigError(f"{type(self).__name__} needs a {self.driver_type.__name__} in its component")
        self._driver = found

    def _set(self, records: list[Any]) -> None:
        for record in records:
            direction = record.direction_of_travel
            if direction not in (None, _Direction.FORWARD, _Direction.REVERSE):
                self.host.count("undefined_value", f"direction of travel {direction}")
                continue
            is_reverse = None if direction is None else direction == _Direction.REVERSE
            if not self._driver.information.add(record.element_uid, WaypointInformation(is_reverse, record.wait_time)):
                self.host.count("waypoint_information_refused", f"element {record.element_uid}")

    def _records(self) -> list[Any]:
        """The information that was given."""
        found = self._driver.information.listed(self._driver.elements.list.order)
        return [
            _Record(element_uid=uid, direction_of_travel=_direction(information), wait_time=information.wait)
            for uid, information in found[:MAX_REPORTED]
        ]

    def _status(self) -> tuple[int, int]:
        """Seconds at the present waypoint, and the status."""
        driver = self._driver
        return min(MAX_SECONDS, int(driver.waited)), _STATUS[driver.progress].value


def _direction(information: WaypointInformation) -> Any:
    if information.is_reverse is None:
        return None
    return _Direction.REVERSE if information.is_reverse else _Direction.FORWARD


_Status: Final = ReportLocalWaypointStatus.WaypointStatus
_STATUS: Final = {
    ListProgress.EMPTY: _Status.NO_PLAN,
    ListProgress.LOADED: _Status.PLAN_LOADED,
    ListProgress.EXECUTING: _Status.EXECUTING,
    ListProgress.PAUSED: _Status.PAUSED,
    ListProgress.TIMED_WAIT: _Status.TIMED_WAIT,
    ListProgress.COMPLETE: _Status.COMPLETE,
    ListProgress.FAULT: _Status.NON_SPECIFIC_FAULT,
}


class EnhancedLocalWaypointListDriver(
    EnhancedWaypointListDriver, urn="urn:jaus:jss:iop:EnhancedLocalWaypointListDriver"
):
    """For lists of local waypoints."""

    driver_type = LocalWaypointListDriver

    def set_enhanced_local_waypoint_information(self, msg: SetEnhancedLocalWaypointInformation) -> None:
        """Keep the information; of several entries for an element the last one counts."""
        self._set(msg.waypoint_information_list)

    def send_report_enhanced_local_waypoint_information(self) -> ReportEnhancedLocalWaypointInformation:
        """What was added to elements of the list, in its order."""
        return ReportEnhancedLocalWaypointInformation(self._records())

    def send_report_local_waypoint_status(self) -> ReportLocalWaypointStatus:
        """Status of the list, as far as it has local waypoints."""
        return ReportLocalWaypointStatus(*self._status())


class EnhancedGlobalWaypointListDriver(
    EnhancedWaypointListDriver, urn="urn:jaus:jss:iop:EnhancedGlobalWaypointListDriver"
):
    """For lists of global waypoints."""

    driver_type = GlobalWaypointListDriver

    def set_enhanced_global_waypoint_information(self, msg: SetEnhancedGlobalWaypointInformation) -> None:
        """Same as for local waypoints."""
        self._set(msg.waypoint_information_list)

    def send_report_enhanced_global_waypoint_information(self) -> ReportEnhancedGlobalWaypointInformation:
        """What was added to elements of the list, in its order."""
        return ReportEnhancedGlobalWaypointInformation(self._records())

    def send_report_global_waypoint_status(self) -> ReportGlobalWaypointStatus:
        """Status of the list, as far as it has global waypoints."""
        return ReportGlobalWaypointStatus(*self._status())
