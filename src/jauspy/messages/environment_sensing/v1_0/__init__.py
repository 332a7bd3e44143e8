"""Messages of environment_sensing, v1_0; loaded on use. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jauspy.codec.registry import lazy

if TYPE_CHECKING:
    from jauspy.messages.environment_sensing.v1_0.analog_video import (
        QueryAnalogVideoSensorCapabilities as QueryAnalogVideoSensorCapabilities,
        QueryAnalogVideoSensorConfiguration as QueryAnalogVideoSensorConfiguration,
        ReportAnalogVideoSensorCapabilities as ReportAnalogVideoSensorCapabilities,
        ReportAnalogVideoSensorConfiguration as ReportAnalogVideoSensorConfiguration,
        SetAnalogVideoSensorConfiguration as SetAnalogVideoSensorConfiguration,
    )
    from jauspy.messages.environment_sensing.v1_0.digital_video import (
        ControlDigitalVideoSensorStream as ControlDigitalVideoSensorStream,
        QueryDigitalVideoSensorCapabilities as QueryDigitalVideoSensorCapabilities,
        QueryDigitalVideoSensorConfiguration as QueryDigitalVideoSensorConfiguration,
        ReportDigitalVideoSensorCapabilities as ReportDigitalVideoSensorCapabilities,
        ReportDigitalVideoSensorConfiguration as ReportDigitalVideoSensorConfiguration,
        SetDigitalVideoSensorConfiguration as SetDigitalVideoSensorConfiguration,
    )
    from jauspy.messages.environment_sensing.v1_0.range_sensor import (
        ConfirmSensorConfiguration as ConfirmSensorConfiguration,
        QueryRangeSensorCapabilities as QueryRangeSensorCapabilities,
        QueryRangeSensorCompressedData as QueryRangeSensorCompressedData,
        QueryRangeSensorConfiguration as QueryRangeSensorConfiguration,
        QueryRangeSensorData as QueryRangeSensorData,
        QuerySensorGeometricProperties as QuerySensorGeometricProperties,
        ReportRangeSensorCapabilities as ReportRangeSensorCapabilities,
        ReportRangeSensorCompressedData as ReportRangeSensorCompressedData,
        ReportRangeSensorConfiguration as ReportRangeSensorConfiguration,
        ReportRangeSensorData as ReportRangeSensorData,
        ReportSensorGeometricProperties as ReportSensorGeometricProperties,
        SetRangeSensorConfiguration as SetRangeSensorConfiguration,
    )
    from jauspy.messages.environment_sensing.v1_0.still_image import (
        QueryStillImageData as QueryStillImageData,
        QueryStillImageSensorCapabilities as QueryStillImageSensorCapabilities,
        QueryStillImageSensorConfiguration as QueryStillImageSensorConfiguration,
        ReportStillImageData as ReportStillImageData,
        ReportStillImageSensorCapabilities as ReportStillImageSensorCapabilities,
        ReportStillImageSensorConfiguration as ReportStillImageSensorConfiguration,
        SetStillImageSensorConfiguration as SetStillImageSensorConfiguration,
    )
    from jauspy.messages.environment_sensing.v1_0.types import (
        AnalogVideoSensorErrorRec as AnalogVideoSensorErrorRec,
        AnalogVideoSensorErrorRecV1 as AnalogVideoSensorErrorRecV1,
        DigitalAudioOutputErrorRec as DigitalAudioOutputErrorRec,
        DigitalAudioSensorErrorRec as DigitalAudioSensorErrorRec,
        DigitalVideoSensorErrorRec as DigitalVideoSensorErrorRec,
        DigitalVideoSensorErrorRecV1 as DigitalVideoSensorErrorRecV1, ExposureModes as ExposureModes,
        FocusModes as FocusModes, H264VideoEncodingErrorRec as H264VideoEncodingErrorRec, JAUS_ID as JAUS_ID,
        LightSensitivityLevels as LightSensitivityLevels,
        ManipulatorGeometricPropertiesRec as ManipulatorGeometricPropertiesRec, MeteringModes as MeteringModes,
        RangeSensorErrorRec as RangeSensorErrorRec, RangeSensorErrorRecV1 as RangeSensorErrorRecV1,
        SensorIDQueryRec as SensorIDQueryRec, SensorIdRec as SensorIdRec,
        StaticGeometricPropertiesRec as StaticGeometricPropertiesRec,
        StillImageSensorErrorRec as StillImageSensorErrorRec,
        StillImageSensorErrorRecV1 as StillImageSensorErrorRecV1, SupportedAnalogFormats as SupportedAnalogFormats,
        SupportedAudioFormats as SupportedAudioFormats, SupportedBitDepths as SupportedBitDepths,
        SupportedCompression as SupportedCompression, SupportedDigitalFormats as SupportedDigitalFormats,
        SupportedFrameSizes as SupportedFrameSizes, SupportedImageFormats as SupportedImageFormats,
        SupportedStates as SupportedStates, SupportedWhiteBalance as SupportedWhiteBalance,
        VideoIlluminatorErrorRec as VideoIlluminatorErrorRec, VisualSensorErrorRec as VisualSensorErrorRec,
        VisualSensorErrorRecV1 as VisualSensorErrorRecV1, ZoomModes as ZoomModes,
    )
    from jauspy.messages.environment_sensing.v1_0.visual_sensor import (
        QueryVisualSensorCapabilities as QueryVisualSensorCapabilities,
        QueryVisualSensorConfiguration as QueryVisualSensorConfiguration,
        ReportVisualSensorCapabilities as ReportVisualSensorCapabilities,
        ReportVisualSensorConfiguration as ReportVisualSensorConfiguration,
        SetVisualSensorConfiguration as SetVisualSensorConfiguration,
    )

__all__, __getattr__, __dir__ = lazy(__name__, {
    "jauspy.messages.environment_sensing.v1_0.analog_video": "QueryAnalogVideoSensorCapabilities QueryAnalogVideoSensorConfiguration ReportAnalogVideoSensorCapabilities ReportAnalogVideoSensorConfiguration SetAnalogVideoSensorConfiguration",
    "jauspy.messages.environment_sensing.v1_0.digital_video": "ControlDigitalVideoSensorStream QueryDigitalVideoSensorCapabilities QueryDigitalVideoSensorConfiguration ReportDigitalVideoSensorCapabilities ReportDigitalVideoSensorConfiguration SetDigitalVideoSensorConfiguration",
    "jauspy.messages.environment_sensing.v1_0.range_sensor": "ConfirmSensorConfiguration QueryRangeSensorCapabilities QueryRangeSensorCompressedData QueryRangeSensorConfiguration QueryRangeSensorData QuerySensorGeometricProperties ReportRangeSensorCapabilities ReportRangeSensorCompressedData ReportRangeSensorConfiguration ReportRangeSensorData ReportSensorGeometricProperties SetRangeSensorConfiguration",
    "jauspy.messages.environment_sensing.v1_0.still_image": "QueryStillImageData QueryStillImageSensorCapabilities QueryStillImageSensorConfiguration ReportStillImageData ReportStillImageSensorCapabilities ReportStillImageSensorConfiguration SetStillImageSensorConfiguration",
    "jauspy.messages.environment_sensing.v1_0.types": "AnalogVideoSensorErrorRec AnalogVideoSensorErrorRecV1 DigitalAudioOutputErrorRec DigitalAudioSensorErrorRec DigitalVideoSensorErrorRec DigitalVideoSensorErrorRecV1 ExposureModes FocusModes H264VideoEncodingErrorRec JAUS_ID LightSensitivityLevels ManipulatorGeometricPropertiesRec MeteringModes RangeSensorErrorRec RangeSensorErrorRecV1 SensorIDQueryRec SensorIdRec StaticGeometricPropertiesRec StillImageSensorErrorRec StillImageSensorErrorRecV1 SupportedAnalogFormats SupportedAudioFormats SupportedBitDepths SupportedCompression SupportedDigitalFormats SupportedFrameSizes SupportedImageFormats SupportedStates SupportedWhiteBalance VideoIlluminatorErrorRec VisualSensorErrorRec VisualSensorErrorRecV1 ZoomModes",
    "jauspy.messages.environment_sensing.v1_0.visual_sensor": "QueryVisualSensorCapabilities QueryVisualSensorConfiguration ReportVisualSensorCapabilities ReportVisualSensorConfiguration SetVisualSensorConfiguration",
})
