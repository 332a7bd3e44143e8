"""AEODRSVideoIlluminator: lamps that light the scene for the cameras of a component (AEODRS)."""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from typing import Any, Final

from jauspy.messages.exp import (
    QueryDigitalVideoIlluminator,
    QueryDigitalVideoIlluminatorCapabilities,
    QueryDigitalVideoIlluminatorConfiguration,
    ReportDigitalVideoIlluminator,
    ReportDigitalVideoIlluminatorCapabilities,
    ReportDigitalVideoIlluminatorConfiguration,
    SetDigitalVideoIlluminator,
    SetDigitalVideoIlluminatorConfiguration,
)
from jauspy.platform.lights import Lamp
from jauspy.services.service import Service

ALL_LAMPS: Final = 0
_Mode: Final = ReportDigitalVideoIlluminatorConfiguration.IlluminationMode
_Capability = ReportDigitalVideoIlluminatorCapabilities.DigitalVideoIlluminatorCapabilityRec
_Modes = ReportDigitalVideoIlluminatorCapabilities.IlluminationModes
_Sensor = ReportDigitalVideoIlluminatorConfiguration.SensorRec


class VideoIlluminator(Service, urn="urn:jaus:jss:exp:aeodrs:AEODRSVideoIlluminator"):
    """Lamps of visible light with a fixed cone, numbered from 1: their brightness changes, mode and beam width do not.

    `sensors` are the numbers of the cameras that may be assigned to a lamp.
    """

    def __init__(self, lamps: Sequence[Lamp], sensors: Collection[int]) -> None:
        self._lamps = dict(enumerate(lamps, start=1))
        self._sensors = frozenset(sensors)
        self._assigned = dict.fromkeys(self._lamps, self._sensors)

    def send_report_digital_video_illuminator(
        self, query: QueryDigitalVideoIlluminator
    ) -> ReportDigitalVideoIlluminator:
        """Brightness and cone of the lamps asked about; unknown ones are left out."""
        records = [
            ReportDigitalVideoIlluminator.IlluminationRecordRec(number, 100.0 * lamp.level, _width(lamp))
            for number, lamp in self._named(record.illuminator_id for record in query.sensor_id_list)
        ]
        return ReportDigitalVideoIlluminator(records)

    def send_report_digital_video_illuminator_capabilities(
        self, query: QueryDigitalVideoIlluminatorCapabilities
    ) -> ReportDigitalVideoIlluminatorCapabilities:
        """Names, modes and cones."""
        modes = _Modes(color=1, greyscale=0, infrared=0, lowlight=0)
        asked = query.query_digital_video_illuminator_capabilities_list
        return ReportDigitalVideoIlluminatorCapabilities(
            [
                _Capability(number, lamp.setup.name[:255], modes, _width(lamp))
                for number, lamp in self._named(record.illuminator_id for record in asked)
            ]
        )

    def send_report_digital_video_illuminator_configuration(
        self, query: QueryDigitalVideoIlluminatorConfiguration
    ) -> ReportDigitalVideoIlluminatorConfiguration | None:
        """Mode and cameras of one lamp; None, and counted, if there is no such lamp."""
        number = query.illuminator_id
        if number not in self._lamps:
            self.host.count("unknown_illuminator", str(number))
            return None
        record = ReportDigitalVideoIlluminatorConfiguration.IlluminatorConfigRecord(number, _Mode.COLOR)
        sensors = [_Sensor(sensor) for sensor in sorted(self._assigned[number])]
        return ReportDigitalVideoIlluminatorConfiguration(record, sensors)

    def set_digital_video_illuminator_action(self, msg: SetDigitalVideoIlluminator) -> None:
        """Set the brightness; another beam width than the lamp's is counted, and changes nothing else."""
        lamp = self._lamps.get(msg.illuminator_id)
        if lamp is None:
            self.host.count("unknown_illuminator", str(msg.illuminator_id))
            return
        if abs(msg.beamwidth - _width(lamp)) > 1.0:
            self.host.count("unsupported_beamwidth", f"{msg.beamwidth} degrees of {lamp.setup.name}")
        lamp.set(msg.level / 100.0)

    def set_digital_video_illuminator_configuration_action(self, msg: SetDigitalVideoIlluminatorConfiguration) -> None:
        """Assign cameras; a message with a mode that the lamp lacks, or with unknown cameras, changes nothing."""
        record, sensors = msg.illuminator_config_record, {entry.sensor_id for entry in msg.sensor_list}
        if record.illuminator_id not in self._lamps:
            self.host.count("unknown_illuminator", str(record.illuminator_id))
        elif record.illumination_mode != _Mode.COLOR or not sensors <= self._sensors:
            self.host.count("unsupported_illumination", f"mode {record.illumination_mode}, cameras {sensors}")
        else:
            self._assigned[record.illuminator_id] = frozenset(sensors)

    def _named(self, numbers: Any) -> list[tuple[int, Lamp]]:
        """The lamps with these numbers, each once."""
        wanted = set(numbers)
        return [entry for entry in self._lamps.items() if entry[0] in wanted or ALL_LAMPS in wanted]


def _width(lamp: Lamp) -> float:
    """The cone of a lamp, in degrees as in the messages."""
    return math.degrees(lamp.setup.cone)
