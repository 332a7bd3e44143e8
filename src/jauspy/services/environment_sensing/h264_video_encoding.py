"""H264VideoEncoding: profile, level, preset and refreshes of the cameras' streams (AS6060)."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final, TypeAlias

from jauspy.errors import ConfigError
from jauspy.messages.environment_sensing.v1_0.types import H264VideoEncodingErrorRec, SensorIdRec
from jauspy.messages.environment_sensing.v2_0.h264_video_encoding import (
    ConfirmSensorConfiguration,
    QueryH264VideoEncodingCapabilities,
    QueryH264VideoEncodingConfiguration,
    ReportH264VideoEncodingCapabilities,
    ReportH264VideoEncodingConfiguration,
    SetH264VideoEncodingConfiguration,
)
from jauspy.platform.video_settings import LEVELS, H264Profile, Preset, VideoSettings
from jauspy.services.environment_sensing.sensors import requested_sensors
from jauspy.services.environment_sensing.visual_sensor import Cameras
from jauspy.services.service import Service

RequestedSettings: TypeAlias = SetH264VideoEncodingConfiguration.H264ConfigurationSequence

Code: TypeAlias = H264VideoEncodingErrorRec.H264VideoEncodingErrorCode

Problem: TypeAlias = tuple[Code, str]

_Profile = ReportH264VideoEncodingConfiguration.Profile

_Preset = ReportH264VideoEncodingConfiguration.Preset

_Capabilities = ReportH264VideoEncodingCapabilities

_Report = ReportH264VideoEncodingConfiguration

PROFILES: Final = {
    _Profile.CONSTRAINED_BASELINE: H264Profile.BASELINE,
    _Profile.BASELINE: H264Profile.BASELINE,
    _Profile.MAIN: H264Profile.MAIN,
    _Profile.HIGH: H264Profile.HIGH,
}
"""Profiles by JAUS's numbers. Of two numbers for one profile, the first is reported."""

PROFILE_OF: Final = {profile: number for number, profile in reversed(PROFILES.items())}

PRESETS: Final = {
    _Preset.LOW_LATENCY: Preset.LOW_LATENCY,
    _Preset.SLOW_COMMS: Preset.SLOW_COMMS,
    _Preset.BEST_QUALITY: Preset.BEST_QUALITY,
}

PRESET_OF: Final = {preset: number for number, preset in PRESETS.items()}

MAX_GOP: Final = 255


class H264VideoEncoding(Service, urn="urn:jaus:jss:environmentSensing:H264VideoEncoding"):
    """One encoder per camera, shared by all end points: settings take effect for all of them from the next frame on."""

    def __init__(self, cameras: Cameras) -> None:
        self._cameras = cameras

    def send_report_h264_video_encoding_capabilities(
        self, query: QueryH264VideoEncodingCapabilities
    ) -> ReportH264VideoEncodingCapabilities:
        """Return the profiles, levels and presets of each encoder."""
        requested = requested_sensors(query.query_h264_video_encoding_capabilities_list, self._cameras, known_only=True)
        return ReportH264VideoEncodingCapabilities([_capabilities(sensor) for sensor, _ in requested])

    def send_report_h264_video_encoding_configuration(
        self, query: QueryH264VideoEncodingConfiguration
    ) -> ReportH264VideoEncodingConfiguration:
        """Return the settings of each encoder; the level is that of the stream even if none was set."""
        requested = requested_sensors(
            query.query_h264_video_encoding_configuration_list, self._cameras, known_only=True
        )
        return ReportH264VideoEncodingConfiguration(
            [_configuration(sensor, self._cameras[sensor].source.settings) for sensor, _ in requested]
        )

    def set_h264_video_encoding_config(self, msg: SetH264VideoEncodingConfiguration) -> None:
        """Apply valid settings; omitted settings keep their values."""
        for sensor, requested in _requested_settings(msg, self._cameras).items():
            if sensor in self._cameras and self._refusal(sensor, requested) is None:
                source = self._cameras[sensor].source
                source.settings = apply_settings(requested, source.settings)

    def send_confirm_sensor_configuration(self, msg: SetH264VideoEncodingConfiguration) -> ConfirmSensorConfiguration:
        """Return for each encoder its sensor id, or an error record with the reason."""
        request = ConfirmSensorConfiguration.RequestIdRec(msg.request_id_rec.request_id)
        requested = _requested_settings(msg, self._cameras).items()
        return ConfirmSensorConfiguration(
            request, [self._refusal(*request) or SensorIdRec(request[0]) for request in requested]
        )

    def _refusal(self, sensor: int, requested: RequestedSettings) -> H264VideoEncodingErrorRec | None:
        if sensor not in self._cameras:
            return H264VideoEncodingErrorRec(sensor, Code.UNKNOWN_SENSOR_ID, f"there is no sensor {sensor}")
        problems = find_problems(requested, self._cameras[sensor].source.settings)
        if not problems:
            return None
        code = problems[0][0] if len(problems) == 1 else Code.UNKNOWN_ERROR
        return H264VideoEncodingErrorRec(sensor, code, "; ".join(text for _, text in problems)[:255])


@dataclass(frozen=True, slots=True)
class _ConfigurationRecord:
    settings: RequestedSettings

    @property
    def sensor_id(self) -> int:
        return self.settings.h264_configuration_rec.sensor_id


def _requested_settings(msg: SetH264VideoEncodingConfiguration, cameras: Cameras) -> dict[int, RequestedSettings]:
    records = [_ConfigurationRecord(record) for record in msg.h264_configuration_list]
    return {sensor: record.settings for sensor, record in requested_sensors(records, cameras)}


def apply_settings(requested: RequestedSettings, present: VideoSettings) -> VideoSettings:
    """Return the present settings with the requested changes; raises `ConfigError` if the level is too low for them."""
    record, refresh, coding = requested.h264_configuration_rec, requested.gradual_decoder_refresh_params, present.coding
    if record.profile is not None:
        coding = replace(coding, profile=PROFILES[_Profile(record.profile)])
    if record.level is not None:
        coding = replace(coding, level=int(record.level))
    if record.preset is not None:
        coding = replace(coding, preset=PRESETS[_Preset(record.preset)])
    if record.gradual_decoder_refresh_on_off is not None:
        coding = replace(coding, gradual=bool(record.gradual_decoder_refresh_on_off))
    gop = present.gop if record.group_of_pictures is None else record.group_of_pictures
    return replace(present, coding=coding, gop=gop if refresh is None else refresh.gdr_interval)


def find_problems(requested: RequestedSettings, present: VideoSettings) -> list[Problem]:
    """Return error codes and texts; empty if the settings are valid."""
    record = requested.h264_configuration_rec
    problems: list[Problem] = []
    if record.profile is not None and record.profile not in PROFILES:
        problems.append((Code.INVALID_PROFILE, "profiles are baseline, constrained baseline, main and high"))
    if record.preset is not None and record.preset not in PRESETS:
        problems.append((Code.INVALID_PRESET, "presets are low latency, slow comms and best quality"))
    if record.level is not None and record.level >= len(LEVELS):
        problems.append((Code.UNKNOWN_ERROR, "there is no such level"))
    if record.group_of_pictures == 0:
        problems.append((Code.INVALID_GROUP_OF_PICTURES, f"there are 1..{MAX_GOP} pictures in a group"))
    if record.region_of_interest_on_off or requested.region_of_interest_params is not None:
        problems.append((Code.INVALID_REGION_OF_INTEREST, "the encoder treats all of the picture alike"))
    if record.intra_macro_refresh:
        problems.append((Code.INVALID_INTRA_MACRO_REFRESH, "blocks are refreshed by columns only: set gradual refresh"))
    return problems or _refresh_problems(requested, present) or _level_problems(requested, present)


def _refresh_problems(requested: RequestedSettings, present: VideoSettings) -> list[Problem]:
    refresh = requested.gradual_decoder_refresh_params
    if refresh is None:
        return []
    if not 1 <= refresh.gdr_interval <= MAX_GOP:
        return [(Code.INVALID_GDR, f"a refresh begins every 1..{MAX_GOP} pictures")]
    takes = replace(present, gop=refresh.gdr_interval).refresh
    if refresh.gdr_duration != takes:
        return [(Code.INVALID_GDR, f"at this width and interval a refresh takes {takes} pictures")]
    return []


def _level_problems(requested: RequestedSettings, present: VideoSettings) -> list[Problem]:
    try:
        apply_settings(requested, present)
    except ConfigError as error:
        return [(Code.UNKNOWN_ERROR, str(error))]
    return []


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
        supported_presets=_Capabilities.SupportedPresets(**preset_flags()),
        group_of_pictures_supported=_Capabilities.GroupOfPicturesSupported.TRUE,
        gradual_decoder_refresh_supported=_Capabilities.GradualDecoderRefreshSupported.TRUE,
        region_of_interest_supported=_Capabilities.RegionOfInterestSupported.FALSE,
    )


def preset_flags() -> dict[str, int]:
    """1 for each preset that the encoders have, by the names of the bits that report them; 0 for the others."""
    names = ("low_latency", "slow_comms", "persistent_stare", "drive_vision", "manipulation", "best_quality")
    flags = {name: int(number in PRESETS) for number, name in enumerate(names)}
    return flags | {"reserved": 0, "program_specific": 0}
