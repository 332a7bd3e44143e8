"""H264VideoEncoding: how the cameras' streams are coded (AS6060)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from jauspy.messages.environment_sensing.v1_0.types import H264VideoEncodingErrorRec, SensorIdRec
from jauspy.messages.environment_sensing.v2_0.h264_video_encoding import (
    ConfirmSensorConfiguration,
    QueryH264VideoEncodingCapabilities,
    QueryH264VideoEncodingConfiguration,
    ReportH264VideoEncodingCapabilities,
    ReportH264VideoEncodingConfiguration,
    SetH264VideoEncodingConfiguration,
)
from jauspy.platform.video_settings import LEVELS, VideoSettings
from jauspy.services.environment_sensing.h264_changes import PRESETS, PROFILES, Code, Wanted, changed, problems
from jauspy.services.environment_sensing.video_camera import Cameras
from jauspy.services.environment_sensing.wanted import chosen
from jauspy.services.service import Service

_Capabilities = ReportH264VideoEncodingCapabilities
_Report = ReportH264VideoEncodingConfiguration

PROFILE_OF: Final = {profile: number for number, profile in reversed(PROFILES.items())}
PRESET_OF: Final = {preset: number for number, preset in PRESETS.items()}


class H264VideoEncoding(Service, urn="urn:jaus:jss:environmentSensing:H264VideoEncoding"):
    """One encoder for each camera, which all who watch share: what is set counts for all, from the next picture on."""

    def __init__(self, cameras: Cameras) -> None:
        self._cameras = cameras

    def send_report_h264_video_encoding_capabilities(
        self, query: QueryH264VideoEncodingCapabilities
    ) -> ReportH264VideoEncodingCapabilities:
        """What each encoder can do."""
        wanted = chosen(query.query_h264_video_encoding_capabilities_list, self._cameras, known_only=True)
        return ReportH264VideoEncodingCapabilities([_capabilities(sensor) for sensor, _ in wanted])

    def send_report_h264_video_encoding_configuration(
        self, query: QueryH264VideoEncodingConfiguration
    ) -> ReportH264VideoEncodingConfiguration:
        """How each encoder is set; the level is the one that the stream has, whether it was set or not."""
        wanted = chosen(query.query_h264_video_encoding_configuration_list, self._cameras, known_only=True)
        return ReportH264VideoEncodingConfiguration(
            [_configuration(sensor, self._cameras[sensor].source.settings) for sensor, _ in wanted]
        )

    def set_h264_video_encoding_config(self, msg: SetH264VideoEncodingConfiguration) -> None:
        """Set what can be set; a setting that is left out stays."""
        for sensor, wanted in _wanted(msg, self._cameras).items():
            if sensor in self._cameras and self._refusal(sensor, wanted) is None:
                source = self._cameras[sensor].source
                source.settings = changed(wanted, source.settings)

    def send_confirm_sensor_configuration(self, msg: SetH264VideoEncodingConfiguration) -> ConfirmSensorConfiguration:
        """For each encoder that it is set, or why not; that can be told afterwards, too."""
        request = ConfirmSensorConfiguration.RequestIdRec(msg.request_id_rec.request_id)
        wanted = _wanted(msg, self._cameras).items()
        return ConfirmSensorConfiguration(request, [self._refusal(*each) or SensorIdRec(each[0]) for each in wanted])

    def _refusal(self, sensor: int, wanted: Wanted) -> H264VideoEncodingErrorRec | None:
        if sensor not in self._cameras:
            return H264VideoEncodingErrorRec(sensor, Code.UNKNOWN_SENSOR_ID, f"there is no sensor {sensor}")
        wrong = problems(wanted, self._cameras[sensor].source.settings)
        if not wrong:
            return None
        code = wrong[0][0] if len(wrong) == 1 else Code.UNKNOWN_ERROR
        return H264VideoEncodingErrorRec(sensor, code, "; ".join(text for _, text in wrong)[:255])


@dataclass(frozen=True, slots=True)
class _Entry:
    wanted: Wanted

    @property
    def sensor_id(self) -> int:
        return self.wanted.h264_configuration_rec.sensor_id


def _wanted(msg: SetH264VideoEncodingConfiguration, cameras: Cameras) -> dict[int, Wanted]:
    entries = chosen([_Entry(each) for each in msg.h264_configuration_list], cameras)
    return {sensor: entry.wanted for sensor, entry in entries}


def _configuration(sensor: int, settings: VideoSettings) -> _Report.H264ConfigurationSequence:
    coding = settings.coding
    record = _Report.H264ConfigurationRec(
        sensor,
        profile=PROFILE_OF[coding.profile],
        level=settings.level,
        preset=PRESET_OF[coding.preset],
        group_of_pictures=settings.gop,
        gradual_decoder_refresh_on_off=int(coding.gradual),
        region_of_interest_on_off=_Report.RegionOfInterestOnOff.OFF,
        intra_macro_refresh=0.0,
    )
    refresh = _Report.GradualDecoderRefreshParams(settings.refresh, settings.gop) if coding.gradual else None
    return _Report.H264ConfigurationSequence(record, gradual_decoder_refresh_params=refresh)


def _capabilities(sensor: int) -> _Capabilities.H264CapabilitiesRec:
    return _Capabilities.H264CapabilitiesRec(
        sensor,
        supported_profiles=_Capabilities.SupportedProfiles(*(int(number in PROFILES) for number in _Report.Profile)),
        supported_levels=_Capabilities.SupportedLevels(*(1 for _ in LEVELS)),
        supported_presets=_supported_presets(),
        group_of_pictures_supported=_Capabilities.GroupOfPicturesSupported.TRUE,
        gradual_decoder_refresh_supported=_Capabilities.GradualDecoderRefreshSupported.TRUE,
        region_of_interest_supported=_Capabilities.RegionOfInterestSupported.FALSE,
    )


def _supported_presets() -> _Capabilities.SupportedPresets:
    numbers = range(_Report.Preset.BEST_QUALITY + 1)
    low, slow, stare, drive, manipulate, best = (int(number in PRESETS) for number in numbers)
    return _Capabilities.SupportedPresets(low, slow, stare, drive, manipulate, best, reserved=0, program_specific=0)
