"""CM-VIS: how the stream is coded."""

from __future__ import annotations

import pytest
from tests.robot.cameras import OTHER, Module

from jauspy.messages import environment_sensing as m
from jauspy.messages.environment_sensing.v1_0.types import (
    DigitalVideoSensorErrorRec,
    H264VideoEncodingErrorRec,
    SensorIdRec,
)
from jauspy.platform.video_settings import LEVELS, H264Profile, H264Settings, Preset, VideoSettings

Wanted = m.SetH264VideoEncodingConfiguration
Code = H264VideoEncodingErrorRec.H264VideoEncodingErrorCode
Refresh, Region = Wanted.GradualDecoderRefreshParams, Wanted.RegionOfInterestParams


@pytest.fixture
def module():
    made = Module()
    made.control()
    yield made
    made.robot.close()


def setting(sensor=1, refresh=None, region=None, **values):
    record = Wanted.H264ConfigurationRec(sensor, **values)
    return Wanted(Wanted.RequestIdRec(5), [Wanted.H264ConfigurationSequence(record, region, refresh)])


def confirmed(answer):
    assert answer.request_id_rec.request_id == 5
    (record,) = answer.confirm_sensor_list
    return record


def configuration(module):
    query = m.QueryH264VideoEncodingConfiguration
    (found,) = module.ask(query([query.QueryH264VideoEncodingRec(1)])).h264_configuration_list
    return found


def test_initial_encoding_is_reported(module):
    found = configuration(module)
    record = found.h264_configuration_rec
    assert (record.profile, record.preset) == (Wanted.Profile.CONSTRAINED_BASELINE, Wanted.Preset.LOW_LATENCY)
    assert (record.level, record.group_of_pictures) == (Wanted.Level.LEVEL_22, 30)
    assert (record.gradual_decoder_refresh_on_off, record.region_of_interest_on_off) == (0, 0)
    assert found.gradual_decoder_refresh_params is None


def test_settings_take_effect_and_are_reported(module):
    values = {"profile": Wanted.Profile.HIGH, "level": Wanted.Level.LEVEL_31, "preset": Wanted.Preset.BEST_QUALITY}
    assert confirmed(module.ask(setting(**values, group_of_pictures=60))) == SensorIdRec(1)
    level = next(number for number, each in enumerate(LEVELS) if each.name == "3.1")
    coding = H264Settings(H264Profile.HIGH, level, Preset.BEST_QUALITY)
    assert module.video.settings == VideoSettings(gop=60, coding=coding)
    record = configuration(module).h264_configuration_rec
    assert {name: getattr(record, name) for name in values} == values
    assert record.group_of_pictures == 60
    assert confirmed(module.ask(setting(preset=Wanted.Preset.SLOW_COMMS))) == SensorIdRec(1)
    assert module.video.settings.coding.profile is H264Profile.HIGH


def test_gradual_refresh(module):
    assert confirmed(module.ask(setting(refresh=Refresh(40, 80), gradual_decoder_refresh_on_off=1))) == SensorIdRec(1)
    assert module.video.settings == VideoSettings(gop=80, coding=H264Settings(gradual=True))
    found = configuration(module)
    assert found.h264_configuration_rec.gradual_decoder_refresh_on_off == 1
    assert found.gradual_decoder_refresh_params == type(found.gradual_decoder_refresh_params)(40, 80)
    confirmed(module.ask(setting(gradual_decoder_refresh_on_off=0)))
    assert configuration(module).gradual_decoder_refresh_params is None


@pytest.mark.parametrize(
    ("values", "code"),
    [
        ({"sensor": 4}, Code.UNKNOWN_SENSOR_ID),
        ({"profile": Wanted.Profile.HIGH_10}, Code.INVALID_PROFILE),
        ({"preset": Wanted.Preset.PERSISTENT_STARE}, Code.INVALID_PRESET),
        ({"group_of_pictures": 0}, Code.INVALID_GROUP_OF_PICTURES),
        ({"refresh": Refresh(30, 0)}, Code.INVALID_GDR),
        ({"refresh": Refresh(5, 60)}, Code.INVALID_GDR),
        ({"region_of_interest_on_off": 1}, Code.INVALID_REGION_OF_INTEREST),
        ({"region": Region(0.0, 0.0, 50.0, 50.0, 1000, 500)}, Code.INVALID_REGION_OF_INTEREST),
        ({"intra_macro_refresh": 5.0}, Code.INVALID_INTRA_MACRO_REFRESH),
        ({"level": Wanted.Level.LEVEL_2}, Code.UNKNOWN_ERROR),
        ({"group_of_pictures": 0, "profile": Wanted.Profile.EXTENDED}, Code.UNKNOWN_ERROR),
    ],
)
def test_invalid_settings_are_refused_with_the_reason(module, values, code):
    refused = confirmed(module.ask(setting(**values)))
    assert refused.h264_video_encoding_error_code == code
    assert refused.error_message
    assert module.video.settings == VideoSettings()


def test_size_above_the_level_is_refused(module):
    confirmed(module.ask(setting(level=Wanted.Level.LEVEL_3)))
    video = m.SetDigitalVideoSensorConfiguration
    record = video.DigitalVideoSensorConfigurationRec(1, frame_size=video.FrameSize.HD720_1280_X720)
    refused = confirmed(module.ask(video(video.RequestIdRec(5), [record])))
    assert refused.digital_video_error_code == DigitalVideoSensorErrorRec.DigitalVideoErrorCode.INVALID_FRAME_SIZE
    assert "level 3 has no 1280x720" in refused.error_message
    assert module.video.settings.width == 640


def test_settings_require_control(module):
    assert module.tell(setting(group_of_pictures=5), client=OTHER) == []
    assert module.video.settings == VideoSettings()


def test_capabilities(module):
    query = m.QueryH264VideoEncodingCapabilities
    (found,) = module.ask(query([query.QueryH264VideoEncodingRec(0)])).h264_capabilities_list
    profiles, presets = found.supported_profiles, found.supported_presets
    assert (profiles.baseline, profiles.constrained_baseline, profiles.main, profiles.high) == (1, 1, 1, 1)
    assert (profiles.extended, profiles.high10) == (0, 0)
    assert (presets.low_latency, presets.slow_comms, presets.best_quality, presets.drive_vision) == (1, 1, 1, 0)
    assert found.supported_levels.level_62 == 1
    flags = (found.group_of_pictures_supported, found.gradual_decoder_refresh_supported)
    assert (*flags, found.region_of_interest_supported) == (1, 1, 0)
