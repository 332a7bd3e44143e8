"""What a client may set of a range sensor, and why not."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, Final

from jauspy.messages.environment_sensing.v1_0.types import RangeSensorErrorRec
from jauspy.messages.environment_sensing.v2_0.range_sensor import SetRangeSensorConfiguration
from jauspy.platform.ranging import LidarSetup, ScanSettings

Wanted = SetRangeSensorConfiguration.RangeSensorConfigurationRec
State = SetRangeSensorConfiguration.SensorState
Code = RangeSensorErrorRec.RangeSensorErrorCode

RATE_STEP: Final = 1000.0 / 65535.0
"""Of a rate on the wire, in hertz: what a client sets to the limit may arrive just beyond it."""
RANGE_STEP: Final = 1e6 / (2**32 - 1)
"""Of a distance on the wire, in metres."""
FLAT: Final = 1e-6
"""Radians that count as zero, which lies between two steps on the wire."""


def settings(wanted: Wanted, present: ScanSettings) -> ScanSettings:
    """The settings with what is wanted; angles counted as in REP-103, so left and right change places."""
    start, stop = wanted.horizontal_field_of_view_start_angle, wanted.horizontal_field_of_view_stop_angle
    given: dict[str, Any] = {
        "start": None if stop is None else -stop,
        "stop": None if start is None else -start,
        "rate": wanted.update_rate,
        "least": wanted.minimum_range,
        "most": wanted.maximum_range,
        "active": None if wanted.sensor_state is None else wanted.sensor_state == State.ACTIVE,
    }
    return replace(present, **{name: value for name, value in given.items() if value is not None})


def refusal(wanted: Wanted, present: ScanSettings, setup: LidarSetup) -> RangeSensorErrorRec | None:
    """Why the sensor cannot be set so; None when it can."""
    wrong = _problems(wanted, settings(wanted, present), setup)
    if not wrong:
        return None
    code = wrong[0][0] if len(wrong) == 1 else Code.MULTIPLE_INVALID_PARAMETERS
    return RangeSensorErrorRec(wanted.sensor_id, code, "; ".join(text for _, text in wrong)[:255])


def _problems(wanted: Wanted, new: ScanSettings, setup: LidarSetup) -> list[tuple[Code, str]]:
    wrong = []
    if new.start >= new.stop:
        wrong.append((Code.INVALID_HORIZONTAL_FOV, "the first angle must be less than the last"))
    vertical = (wanted.vertical_field_of_view_start_angle, wanted.vertical_field_of_view_stop_angle)
    if any(angle is not None and abs(angle) > FLAT for angle in vertical):
        wrong.append((Code.INVALID_VERTICAL_FOV, "it scans in one plane; vertical angles are 0"))
    if not 0.0 < new.rate <= setup.rate + RATE_STEP:
        wrong.append((Code.INVALID_UPDATE_RATE, f"rates are more than 0 and at most {setup.rate:g} Hz"))
    if new.least < setup.least - RANGE_STEP or new.most > setup.most + RANGE_STEP or new.least >= new.most:
        wrong.append((Code.INVALID_SENSOR_RANGE, f"distances are within {setup.least:g}..{setup.most:g} m"))
    return wrong
