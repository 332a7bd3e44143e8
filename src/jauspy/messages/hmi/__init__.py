"""Messages of hmi, newest versions; loaded on use. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jauspy.codec.registry import lazy

if TYPE_CHECKING:
    from jauspy.messages.hmi.v1_0.analog_control import (
        QueryAnalogAction as QueryAnalogAction, QueryAnalogDevices as QueryAnalogDevices,
        ReportAnalogAction as ReportAnalogAction, ReportAnalogDevices as ReportAnalogDevices,
    )
    from jauspy.messages.hmi.v1_0.digital_control import (
        QueryDCM as QueryDCM, ReportDCM as ReportDCM, SetDCM as SetDCM,
    )
    from jauspy.messages.hmi.v1_0.drawing import (
        QueryData as QueryData, QueryDataDefinition as QueryDataDefinition,
        QueryDrawingDefinition as QueryDrawingDefinition, ReportData as ReportData,
        ReportDataDefinition as ReportDataDefinition, ReportDrawingDefinition as ReportDrawingDefinition,
    )
    from jauspy.messages.hmi.v1_0.keyboard import (
        QueryKeyboardAction as QueryKeyboardAction, ReportKeyboardAction as ReportKeyboardAction,
    )
    from jauspy.messages.hmi.v1_0.pointing_device import (
        QueryPointingDeviceAction as QueryPointingDeviceAction,
        QueryPointingDeviceMovement as QueryPointingDeviceMovement,
        ReportPointingDeviceAction as ReportPointingDeviceAction,
        ReportPointingDeviceMovement as ReportPointingDeviceMovement,
    )

__all__, __getattr__, __dir__ = lazy(__name__, {
    "jauspy.messages.hmi.v1_0.analog_control": "QueryAnalogAction QueryAnalogDevices ReportAnalogAction ReportAnalogDevices",
    "jauspy.messages.hmi.v1_0.digital_control": "QueryDCM ReportDCM SetDCM",
    "jauspy.messages.hmi.v1_0.drawing": "QueryData QueryDataDefinition QueryDrawingDefinition ReportData ReportDataDefinition ReportDrawingDefinition",
    "jauspy.messages.hmi.v1_0.keyboard": "QueryKeyboardAction ReportKeyboardAction",
    "jauspy.messages.hmi.v1_0.pointing_device": "QueryPointingDeviceAction QueryPointingDeviceMovement ReportPointingDeviceAction ReportPointingDeviceMovement",
})
