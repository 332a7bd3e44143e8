"""What a client may set of an H.264 encoder, and why not."""

from __future__ import annotations

from dataclasses import replace
from typing import Final, TypeAlias

from jauspy.errors import ConfigError
from jauspy.messages.environment_sensing.v1_0.types import H264VideoEncodingErrorRec
from jauspy.messages.environment_sensing.v2_0.h264_video_encoding import (
    ReportH264VideoEncodingConfiguration,
    SetH264VideoEncodingConfiguration,
)
from jauspy.platform.video_settings import LEVELS, Preset, Profile, VideoSettings

Wanted: TypeAlias = SetH264VideoEncodingConfiguration.H264ConfigurationSequence
Code: TypeAlias = H264VideoEncodingErrorRec.H264VideoEncodingErrorCode
Problem: TypeAlias = tuple[Code, str]

_Profile = ReportH264VideoEncodingConfiguration.Profile
_Preset = ReportH264VideoEncodingConfiguration.Preset

PROFILES: Final = {
    _Profile.CONSTRAINED_BASELINE: Profile.BASELINE,
    _Profile.BASELINE: Profile.BASELINE,
    _Profile.MAIN: Profile.MAIN,
    _Profile.HIGH: Profile.HIGH,
}
"""By JAUS's numbers; the first of two names is the one that is reported."""
PRESETS: Final = {
    _Preset.LOW_LATENCY: Preset.LOW_LATENCY,
    _Preset.SLOW_COMMS: Preset.SLOW_COMMS,
    _Preset.BEST_QUALITY: Preset.BEST_QUALITY,
}
MAX_GOP: Final = 255


def changed(wanted: Wanted, present: VideoSettings) -> VideoSettings:
    """The settings with what is wanted; what is left out stays. `ConfigError` when the level is too low for them."""
    record, refresh, coding = wanted.h264_configuration_rec, wanted.gradual_decoder_refresh_params, present.coding
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


def problems(wanted: Wanted, present: VideoSettings) -> list[Problem]:
    """Why not; empty when it can be set."""
    record = wanted.h264_configuration_rec
    wrong: list[Problem] = []
    if record.profile is not None and record.profile not in PROFILES:
        wrong.append((Code.INVALID_PROFILE, "profiles are baseline, constrained baseline, main and high"))
    if record.preset is not None and record.preset not in PRESETS:
        wrong.append((Code.INVALID_PRESET, "presets are low latency, slow comms and best quality"))
    if record.level is not None and record.level >= len(LEVELS):
        wrong.append((Code.UNKNOWN_ERROR, "there is no such level"))
    if record.group_of_pictures == 0:
        wrong.append((Code.INVALID_GROUP_OF_PICTURES, f"there are 1..{MAX_GOP} pictures in a group"))
    if record.region_of_interest_on_off or wanted.region_of_interest_params is not None:
        wrong.append((Code.INVALID_REGION_OF_INTEREST, "the encoder treats all of the picture alike"))
    if record.intra_macro_refresh:
        wrong.append((Code.INVALID_INTRA_MACRO_REFRESH, "blocks are refreshed by columns only: set gradual refresh"))
    return wrong or _refresh_problems(wanted, present) or _level_problems(wanted, present)


def _refresh_problems(wanted: Wanted, present: VideoSettings) -> list[Problem]:
    refresh = wanted.gradual_decoder_refresh_params
    if refresh is None:
        return []
    if not 1 <= refresh.gdr_interval <= MAX_GOP:
        return [(Code.INVALID_GDR, f"a refresh begins every 1..{MAX_GOP} pictures")]
    takes = replace(present, gop=refresh.gdr_interval).refresh
    if refresh.gdr_duration != takes:
        return [(Code.INVALID_GDR, f"at this width and interval a refresh takes {takes} pictures")]
    return []


def _level_problems(wanted: Wanted, present: VideoSettings) -> list[Problem]:
    try:
        changed(wanted, present)
    except ConfigError as error:
        return [(Code.UNKNOWN_ERROR, str(error))]
    return []
