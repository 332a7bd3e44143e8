"""Messages of environment_sensing, v2_0; loaded on use. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jauspy.codec.registry import lazy

if TYPE_CHECKING:
    from jauspy.messages.environment_sensing.v2_0.analog_video import (
        QueryAnalogVideoSensorCapabilities as QueryAnalogVideoSensorCapabilities,
        QueryAnalogVideoSensorConfiguration as QueryAnalogVideoSensorConfiguration,
        ReportAnalogVideoSensorCapabilities as ReportAnalogVideoSensorCapabilities,
        ReportAnalogVideoSensorConfiguration as ReportAnalogVideoSensorConfiguration,
        SetAnalogVideoSensorConfiguration as SetAnalogVideoSensorConfiguration,
    )
    from jauspy.messages.environment_sensing.v2_0.digital_audio_output import (
        ConfirmSensorConfiguration as ConfirmSensorConfiguration,
        QueryDigitalAudioOutputCapabilities as QueryDigitalAudioOutputCapabilities,
        QueryDigitalAudioOutputSource as QueryDigitalAudioOutputSource,
        ReportDigitalAudioOutputCapabilities as ReportDigitalAudioOutputCapabilities,
        ReportDigitalAudioOutputSource as ReportDigitalAudioOutputSource,
        SetDigitalAudioOutputSource as SetDigitalAudioOutputSource,
    )
    from jauspy.messages.environment_sensing.v2_0.digital_audio_sensor import (
        QueryDigitalAudioSensorCapabilities as QueryDigitalAudioSensorCapabilities,
        QueryDigitalAudioSensorConfiguration as QueryDigitalAudioSensorConfiguration,
        ReportDigitalAudioSensorCapabilities as ReportDigitalAudioSensorCapabilities,
        ReportDigitalAudioSensorConfiguration as ReportDigitalAudioSensorConfiguration,
        SetDigitalAudioSensorConfiguration as SetDigitalAudioSensorConfiguration,
    )
    from jauspy.messages.environment_sensing.v2_0.digital_resource_discovery import (
        ConfirmDigitalResourceEndpoint as ConfirmDigitalResourceEndpoint,
        QueryDigitalResourceEndpoint as QueryDigitalResourceEndpoint,
        RegisterDigitalResourceEndpoint as RegisterDigitalResourceEndpoint,
        RemoveDigitalResourceEndpoint as RemoveDigitalResourceEndpoint,
        ReportDigitalResourceEndpoint as ReportDigitalResourceEndpoint,
    )
    from jauspy.messages.environment_sensing.v2_0.digital_video import (
        ControlDigitalVideoSensorRecording as ControlDigitalVideoSensorRecording,
        ControlDigitalVideoSensorStream as ControlDigitalVideoSensorStream,
        QueryDigitalVideoSensorCapabilitiesExt as QueryDigitalVideoSensorCapabilitiesExt,
        QueryDigitalVideoSensorConfiguration as QueryDigitalVideoSensorConfiguration,
        QueryDigitalVideoSensorStatus as QueryDigitalVideoSensorStatus,
        ReportDigitalVideoSensorCapabilitiesExt as ReportDigitalVideoSensorCapabilitiesExt,
        ReportDigitalVideoSensorConfiguration as ReportDigitalVideoSensorConfiguration,
        ReportDigitalVideoSensorStatus as ReportDigitalVideoSensorStatus,
        SetDigitalVideoSensorConfiguration as SetDigitalVideoSensorConfiguration,
    )
    from jauspy.messages.environment_sensing.v2_0.force_torque_sensor import (
        QueryForceTorque as QueryForceTorque, QueryForceTorqueCapabilities as QueryForceTorqueCapabilities,
        ReportForceTorque as ReportForceTorque, ReportForceTorqueCapabilities as ReportForceTorqueCapabilities,
    )
    from jauspy.messages.environment_sensing.v2_0.h264_video_encoding import (
        QueryH264VideoEncodingCapabilities as QueryH264VideoEncodingCapabilities,
        QueryH264VideoEncodingConfiguration as QueryH264VideoEncodingConfiguration,
        ReportH264VideoEncodingCapabilities as ReportH264VideoEncodingCapabilities,
        ReportH264VideoEncodingConfiguration as ReportH264VideoEncodingConfiguration,
        SetH264VideoEncodingConfiguration as SetH264VideoEncodingConfiguration,
    )
    from jauspy.messages.environment_sensing.v2_0.port_mapper import (
        CancelPortMapping as CancelPortMapping, GrantPortMapping as GrantPortMapping,
        QueryPortMappings as QueryPortMappings, ReportPortMappings as ReportPortMappings,
        RequestPortMapping as RequestPortMapping,
    )
    from jauspy.messages.environment_sensing.v2_0.range_sensor import (
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
    from jauspy.messages.environment_sensing.v2_0.still_image import (
        QueryStillImageDataExt as QueryStillImageDataExt,
        QueryStillImageSensorCapabilities as QueryStillImageSensorCapabilities,
        QueryStillImageSensorConfiguration as QueryStillImageSensorConfiguration,
        ReportStillImageDataExt as ReportStillImageDataExt,
        ReportStillImageSensorCapabilities as ReportStillImageSensorCapabilities,
        ReportStillImageSensorConfiguration as ReportStillImageSensorConfiguration,
        SetStillImageSensorConfiguration as SetStillImageSensorConfiguration,
    )
    from jauspy.messages.environment_sensing.v2_0.video_illuminator import (
        QueryVideoIlluminatorCapabilities as QueryVideoIlluminatorCapabilities,
        QueryVideoIlluminatorConfiguration as QueryVideoIlluminatorConfiguration,
        ReportVideoIlluminatorCapabilities as ReportVideoIlluminatorCapabilities,
        ReportVideoIlluminatorConfiguration as ReportVideoIlluminatorConfiguration,
        SetVideoIlluminatorConfiguration as SetVideoIlluminatorConfiguration,
    )
    from jauspy.messages.environment_sensing.v2_0.visual_sensor import (
        QueryVisualSensorCapabilities as QueryVisualSensorCapabilities,
        QueryVisualSensorCapabilitiesExt as QueryVisualSensorCapabilitiesExt,
        QueryVisualSensorConfiguration as QueryVisualSensorConfiguration,
        ReportVisualSensorCapabilities as ReportVisualSensorCapabilities,
        ReportVisualSensorCapabilitiesExt as ReportVisualSensorCapabilitiesExt,
        ReportVisualSensorConfiguration as ReportVisualSensorConfiguration,
        SetVisualSensorConfiguration as SetVisualSensorConfiguration,
    )

__all__, __getattr__, __dir__ = lazy(__name__, {
    "jauspy.messages.environment_sensing.v2_0.analog_video": "QueryAnalogVideoSensorCapabilities QueryAnalogVideoSensorConfiguration ReportAnalogVideoSensorCapabilities ReportAnalogVideoSensorConfiguration SetAnalogVideoSensorConfiguration",
    "jauspy.messages.environment_sensing.v2_0.digital_audio_output": "ConfirmSensorConfiguration QueryDigitalAudioOutputCapabilities QueryDigitalAudioOutputSource ReportDigitalAudioOutputCapabilities ReportDigitalAudioOutputSource SetDigitalAudioOutputSource",
    "jauspy.messages.environment_sensing.v2_0.digital_audio_sensor": "QueryDigitalAudioSensorCapabilities QueryDigitalAudioSensorConfiguration ReportDigitalAudioSensorCapabilities ReportDigitalAudioSensorConfiguration SetDigitalAudioSensorConfiguration",
    "jauspy.messages.environment_sensing.v2_0.digital_resource_discovery": "ConfirmDigitalResourceEndpoint QueryDigitalResourceEndpoint RegisterDigitalResourceEndpoint RemoveDigitalResourceEndpoint ReportDigitalResourceEndpoint",
    "jauspy.messages.environment_sensing.v2_0.digital_video": "ControlDigitalVideoSensorRecording ControlDigitalVideoSensorStream QueryDigitalVideoSensorCapabilitiesExt QueryDigitalVideoSensorConfiguration QueryDigitalVideoSensorStatus ReportDigitalVideoSensorCapabilitiesExt ReportDigitalVideoSensorConfiguration ReportDigitalVideoSensorStatus SetDigitalVideoSensorConfiguration",
    "jauspy.messages.environment_sensing.v2_0.force_torque_sensor": "QueryForceTorque QueryForceTorqueCapabilities ReportForceTorque ReportForceTorqueCapabilities",
    "jauspy.messages.environment_sensing.v2_0.h264_video_encoding": "QueryH264VideoEncodingCapabilities QueryH264VideoEncodingConfiguration ReportH264VideoEncodingCapabilities ReportH264VideoEncodingConfiguration SetH264VideoEncodingConfiguration",
    "jauspy.messages.environment_sensing.v2_0.port_mapper": "CancelPortMapping GrantPortMapping QueryPortMappings ReportPortMappings RequestPortMapping",
    "jauspy.messages.environment_sensing.v2_0.range_sensor": "QueryRangeSensorCapabilities QueryRangeSensorCompressedData QueryRangeSensorConfiguration QueryRangeSensorData QuerySensorGeometricProperties ReportRangeSensorCapabilities ReportRangeSensorCompressedData ReportRangeSensorConfiguration ReportRangeSensorData ReportSensorGeometricProperties SetRangeSensorConfiguration",
    "jauspy.messages.environment_sensing.v2_0.still_image": "QueryStillImageDataExt QueryStillImageSensorCapabilities QueryStillImageSensorConfiguration ReportStillImageDataExt ReportStillImageSensorCapabilities ReportStillImageSensorConfiguration SetStillImageSensorConfiguration",
    "jauspy.messages.environment_sensing.v2_0.video_illuminator": "QueryVideoIlluminatorCapabilities QueryVideoIlluminatorConfiguration ReportVideoIlluminatorCapabilities ReportVideoIlluminatorConfiguration SetVideoIlluminatorConfiguration",
    "jauspy.messages.environment_sensing.v2_0.visual_sensor": "QueryVisualSensorCapabilities QueryVisualSensorCapabilitiesExt QueryVisualSensorConfiguration ReportVisualSensorCapabilities ReportVisualSensorCapabilitiesExt ReportVisualSensorConfiguration SetVisualSensorConfiguration",
})
