"""ExtendedPrimitiveManipulator and ExtendedPrimitivePanTilt: electrical data of joints, and what carries them."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Final

from jauspy.ids import JausID
from jauspy.messages.iop import (
    QueryJointOperationalParameters,
    QueryPanTiltOperationalParameters,
    ReportManipulatorHost,
    ReportOperationalParameters,
    ReportPanTiltManipulatorHost,
    ReportPanTiltOperationalParameters,
)
from jauspy.platform.motors import MotorReading
from jauspy.services.service import Service

MAX_JOINTS: Final = 255
MIN_TEMPERATURE: Final = -50.0
MAX_TEMPERATURE: Final = 150.0
MAX_VOLTAGE: Final = 150.0
MAX_CURRENT: Final = 200.0
"""Degrees Celsius, volts and amperes that the fields hold; values beyond them are reported as these."""
FIELDS: Final = 4
"""Values of a joint; bit n of a presence vector is that of value n."""

Readings = Callable[[], Mapping[str, MotorReading]]
Mount = tuple[JausID, int]
"""The component that moves a joint, and the number of the joint from 1."""


class ExtendedPrimitiveManipulator(Service, urn="urn:jaus:jss:iop:ExtendedPrimitiveManipulator"):
    """Reports what is measured of each joint; what is not measured, or was not asked for, is left out.

    `joints`: names, base to tip. `mount`: the joint of another manipulator that carries this one.
    """

    def __init__(self, joints: Sequence[str], readings: Readings, mount: Mount | None = None) -> None:
        self._joints = joints[:MAX_JOINTS]
        self._readings = readings
        self._mount = mount

    def report_operational_parameters(self, query: QueryJointOperationalParameters) -> ReportOperationalParameters:
        """Temperature, voltage and currents of each joint (F291)."""
        record, found, records = ReportOperationalParameters.JointOperationalParameterRec, self._readings(), []
        for number, name in enumerate(self._joints, 1):
            temperature, voltage, current, phase = _values(found.get(name), query.presence_vector)
            records.append(record(number, temperature, voltage, current, phase))
        return ReportOperationalParameters(records)

    def report_manipulator_host(self) -> ReportManipulatorHost:
        """What carries this manipulator (F293)."""
        id, joint = self._mount or _NOTHING
        return ReportManipulatorHost(
            ReportManipulatorHost.ParentID(component_id=id.component, node_id=id.node, subsystem_id=id.subsystem), joint
        )


class ExtendedPrimitivePanTilt(Service, urn="urn:jaus:jss:iop:ExtendedPrimitivePanTilt"):
    """The same of the two joints of a pan-tilt unit."""

    def __init__(self, joints: Sequence[str], readings: Readings, mount: Mount | None = None) -> None:
        self._pan, self._tilt = joints
        self._readings = readings
        self._mount = mount

    def send_report_pan_tilt_operational_parameters(
        self, msg: QueryPanTiltOperationalParameters
    ) -> ReportPanTiltOperationalParameters:
        """Temperature, voltage and currents of both joints (F299)."""
        found, wanted = self._readings(), msg.presence_vector
        return ReportPanTiltOperationalParameters(
            *_values(found.get(self._pan), wanted), *_values(found.get(self._tilt), wanted >> FIELDS)
        )

    def report_pan_tilt_manipulator_host(self) -> ReportPanTiltManipulatorHost:
        """What carries this unit (F29B)."""
        id, joint = self._mount or _NOTHING
        parent = ReportPanTiltManipulatorHost.ParentID(
            component_id=id.component, node_id=id.node, subsystem_id=id.subsystem
        )
        return ReportPanTiltManipulatorHost(parent, joint)


_NOTHING: Final[Mount] = (JausID(0, 0, 0), 0)


def _values(reading: MotorReading | None, wanted: int) -> list[float | None]:
    """Temperature, voltage, current and phase current, of those that the four lowest bits want."""
    if reading is None:
        return [None] * FIELDS
    limited = (
        _within(reading.temperature, MIN_TEMPERATURE, MAX_TEMPERATURE),
        _within(reading.voltage, 0.0, MAX_VOLTAGE),
        _within(reading.current, 0.0, MAX_CURRENT),
        _within(reading.phase_current, 0.0, MAX_CURRENT),
    )
    return [value if wanted >> bit & 1 else None for bit, value in enumerate(limited)]


def _within(value: float | None, low: float, high: float) -> float | None:
    """The value within the field; None for NaN, too."""
    return None if value is None or value != value else min(high, max(low, value))  # noqa: PLR0124 - NaN
