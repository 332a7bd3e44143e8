"""A setting of each kind of sensor that can be looked at: one that disturbs nobody much for a moment."""

from __future__ import annotations

from typing import Final

from jauspy.conformance.walk.events import CREATE
from jauspy.conformance.walk.settings import Setting
from jauspy.messages.environment_sensing.v2_0.digital_video import (
    QueryDigitalVideoSensorConfiguration as QueryVideo,
    ReportDigitalVideoSensorConfiguration as ReportVideo,
    SetDigitalVideoSensorConfiguration as SetVideo,
)
from jauspy.messages.environment_sensing.v2_0.h264_video_encoding import (
    QueryH264VideoEncodingConfiguration as QueryEncoding,
    ReportH264VideoEncodingConfiguration as ReportEncoding,
    SetH264VideoEncodingConfiguration as SetEncoding,
)
from jauspy.messages.environment_sensing.v2_0.range_sensor import (
    QueryRangeSensorConfiguration as QueryRange,
    ReportRangeSensorConfiguration as ReportRange,
    SetRangeSensorConfiguration as SetRange,
)
from jauspy.messages.environment_sensing.v2_0.still_image import (
    QueryStillImageSensorConfiguration as QueryStill,
    ReportStillImageSensorConfiguration as ReportStill,
    SetStillImageSensorConfiguration as SetStill,
)
from jauspy.messages.environment_sensing.v2_0.visual_sensor import (
    QueryVisualSensorConfiguration as QueryVisual,
    ReportVisualSensorConfiguration as ReportVisual,
    SetVisualSensorConfiguration as SetVisual,
)

ALL: Final = 0
"""Stands for every sensor."""
JPEG, PNG = SetStill.StillImageFormat.JPEG, SetStill.StillImageFormat.PNG

SETTINGS: Final = (
    Setting(
        "update_rate",
        lambda sensor, rate: SetRange(
            SetRange.RequestIdRec(CREATE), [SetRange.RangeSensorConfigurationRec(sensor, update_rate=rate)]
        ),
        QueryRange([QueryRange.QueryRangeSensorConfigurationRec(ALL, 0xFFFF)]),
        ReportRange,
        lambda report: report.range_sensor_configuration_list,
        lambda rate: rate / 2,
    ),
    Setting(
        "horizontal_field_of_view",
        lambda sensor, angle: SetVisual(
            SetVisual.RequestIdRec(CREATE),
            [SetVisual.VisualSensorConfigurationRec(sensor, horizontal_field_of_view=angle)],
        ),
        QueryVisual([QueryVisual.QueryVisualSensorConfigurationRec(ALL, 0xFFFF)]),
        ReportVisual,
        lambda report: report.visual_sensor_configuration_list,
        lambda angle: angle / 2,
    ),
    Setting(
        "frame_rate",
        lambda sensor, rate: SetVideo(
            SetVideo.RequestIdRec(CREATE), [SetVideo.DigitalVideoSensorConfigurationRec(sensor, frame_rate=rate)]
        ),
        QueryVideo([QueryVideo.QueryDigitalVideoConfigurationRec(ALL, 0xFF)]),
        ReportVideo,
        lambda report: report.digital_video_sensor_configuration_list,
        lambda rate: max(1, rate // 2) if rate != 1 else 2,
    ),
    Setting(
        "still_image_format",
        lambda sensor, coding: SetStill(
            SetStill.RequestIdRec(CREATE),
            [SetStill.StillImageSensorConfigurationRec(sensor, still_image_format=coding)],
        ),
        QueryStill([QueryStill.QueryStillImageSensorConfigurationRec(ALL, 0xFF)]),
        ReportStill,
        lambda report: report.still_image_sensor_configuration_list,
        lambda coding: PNG if coding == JPEG else JPEG,
    ),
    Setting(
        "group_of_pictures",
        lambda sensor, pictures: SetEncoding(
            SetEncoding.RequestIdRec(CREATE),
            [
                SetEncoding.H264ConfigurationSequence(
                    SetEncoding.H264ConfigurationRec(sensor, group_of_pictures=pictures)
                )
            ],
        ),
        QueryEncoding([QueryEncoding.QueryH264VideoEncodingRec(ALL)]),
        ReportEncoding,
        lambda report: [each.h264_configuration_rec for each in report.h264_configuration_list],
        lambda pictures: max(1, pictures // 2) if pictures != 1 else 2,
    ),
)
SENSORS: Final = tuple(each.stimulus() for each in SETTINGS)
