"""urn:jaus:jss:environmentSensing:H264VideoEncoding 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd
from jauspy.messages.environment_sensing.v2_0 import digital_audio_output as environment_sensing_v2_0_digital_audio_output

_SERVICE = jd.Service("urn:jaus:jss:environmentSensing:H264VideoEncoding", "2.0")


@jd.message(_SERVICE, 0x080D, command=True)
class SetH264VideoEncodingConfiguration(jd.Message):
    """SetH264VideoEncodingConfiguration (0x080D): Sets the configuration of H.264 encoders.

    h264_configuration_list: 0..65535 items. The encoders
    """

    @jd.record()
    class RequestIdRec(jd.Struct):
        """request_id: Repeated in the answer, to match it with its request"""
        request_id: int = jd.field("RequestID", jd.Number("B"))

    class Profile(IntEnum):
        BASELINE = 0
        CONSTRAINED_BASELINE = 1
        MAIN = 2
        EXTENDED = 3
        HIGH = 4
        PROGRESSIVE_HIGH = 5
        CONSTRAINED_HIGH = 6
        HIGH_10 = 7
        HIGH_422 = 8
        HIGH_444_PREDICTIVE = 9
        HIGH_10_INTRA = 10
        HIGH_422_INTRA = 11
        HIGH_444_INTRA = 12
        CAVLC444 = 13
        SCALABLE_BASELINE = 14
        SCALABLE_CONSTRAINED_BASELINE = 15
        SCALABLE_HIGH = 16
        SCALABLE_CONSTRAINED_HIGH = 17
        SCALABLE_HIGH_INTRA = 18
        STEREO_HIGH = 19
        MULTIVIEW_HIGH = 20

    class Level(IntEnum):
        LEVEL_1 = 0
        LEVEL_1_B = 1
        LEVEL_11 = 2
        LEVEL_12 = 3
        LEVEL_13 = 4
        LEVEL_2 = 5
        LEVEL_21 = 6
        LEVEL_22 = 7
        LEVEL_3 = 8
        LEVEL_31 = 9
        LEVEL_32 = 10
        LEVEL_4 = 11
        LEVEL_41 = 12
        LEVEL_42 = 13
        LEVEL_5 = 14
        LEVEL_51 = 15
        LEVEL_52 = 16
        LEVEL_6 = 17
        LEVEL_61 = 18
        LEVEL_62 = 19

    class Preset(IntEnum):
        LOW_LATENCY = 0
        SLOW_COMMS = 1
        PERSISTENT_STARE = 2
        DRIVE_VISION = 3
        MANIPULATION = 4
        BEST_QUALITY = 5
        PROGRAMSPECIFIC_1 = 12
        PROGRAMSPECIFIC_2 = 13
        PROGRAMSPECIFIC_3 = 14
        PROGRAMSPECIFIC_4 = 15

    class GradualDecoderRefreshOnOff(IntEnum):
        OFF = 0
        ON = 1

    class RegionOfInterestOnOff(IntEnum):
        OFF = 0
        ON = 1

    @jd.record("B")
    class H264ConfigurationRec(jd.Struct):
        """Settings of one encoder.

        sensor_id: Identifies the sensor
        profile: Profile, optional. Set of coding tools
        level: Level, optional. Level of size and rate
        preset: Preset, optional. Purpose that the encoder is tuned for
        group_of_pictures: optional. Number of frames from one complete frame to the next
        gradual_decoder_refresh_on_off: GradualDecoderRefreshOnOff, optional. Whether frames are refreshed part by part instead of by complete frames
        region_of_interest_on_off: RegionOfInterestOnOff, optional. Whether part of the image is coded better than the rest
        intra_macro_refresh: 0..100, optional. Blocks that are refreshed in each frame, in percent
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H"))
        profile: SetH264VideoEncodingConfiguration.Profile | int | None = jd.field("Profile", lambda: jd.Number("B", jd.Values(SetH264VideoEncodingConfiguration.Profile)), default=None)
        level: SetH264VideoEncodingConfiguration.Level | int | None = jd.field("Level", lambda: jd.Number("I", jd.Values(SetH264VideoEncodingConfiguration.Level)), default=None)
        preset: SetH264VideoEncodingConfiguration.Preset | int | None = jd.field("Preset", lambda: jd.Number("B", jd.Values(SetH264VideoEncodingConfiguration.Preset)), default=None)
        group_of_pictures: int | None = jd.field("GroupOfPictures", jd.Number("B"), default=None)
        gradual_decoder_refresh_on_off: SetH264VideoEncodingConfiguration.GradualDecoderRefreshOnOff | int | None = jd.field("GradualDecoderRefreshOnOff", lambda: jd.Number("B", jd.Values(SetH264VideoEncodingConfiguration.GradualDecoderRefreshOnOff)), default=None)
        region_of_interest_on_off: SetH264VideoEncodingConfiguration.RegionOfInterestOnOff | int | None = jd.field("RegionOfInterestOnOff", lambda: jd.Number("B", jd.Values(SetH264VideoEncodingConfiguration.RegionOfInterestOnOff)), default=None)
        intra_macro_refresh: float | None = jd.field("IntraMacroRefresh", jd.real("H", 0.0, 100.0), default=None)
        reserved_presence: int = 0

    @jd.record()
    class RegionOfInterestParams(jd.Struct):
        """Part of the image that is coded better.

        x_start: 0..100 percent. Left edge of the part, in percent of the image
        y_start: 0..100 percent. Upper edge of the part, in percent of the image
        width: 0..100 percent. Width of the part, in percent of the image
        height: 0..100 percent. Height of the part, in percent of the image
        high_bit_rate: Bit rate for the part, in kilobits per second
        low_bit_rate: Bit rate for the rest of the image, in kilobits per second
        """
        x_start: float = jd.field("X_Start", jd.real("H", 0.0, 100.0, "percent"))
        y_start: float = jd.field("Y_Start", jd.real("H", 0.0, 100.0, "percent"))
        width: float = jd.field("Width", jd.real("H", 0.0, 100.0, "percent"))
        height: float = jd.field("Height", jd.real("H", 0.0, 100.0, "percent"))
        high_bit_rate: int = jd.field("HighBitRate", jd.Number("H"))
        low_bit_rate: int = jd.field("LowBitRate", jd.Number("H"))

    @jd.record()
    class GradualDecoderRefreshParams(jd.Struct):
        """How frames are refreshed part by part.

        gdr_duration: Frames that one refresh takes
        gdr_interval: Frames from one refresh to the next
        """
        gdr_duration: int = jd.field("GDR_Duration", jd.Number("H"))
        gdr_interval: int = jd.field("GDR_Interval", jd.Number("H"))

    @jd.record("B")
    class H264ConfigurationSequence(jd.Struct):
        """h264_configuration_rec: Settings of one encoder
        region_of_interest_params: optional. Part of the image that is coded better
        gradual_decoder_refresh_params: optional. How frames are refreshed part by part
        """
        h264_configuration_rec: SetH264VideoEncodingConfiguration.H264ConfigurationRec = jd.field("H264ConfigurationRec", lambda: SetH264VideoEncodingConfiguration.H264ConfigurationRec.layout())
        region_of_interest_params: SetH264VideoEncodingConfiguration.RegionOfInterestParams | None = jd.field("RegionOfInterestParams", lambda: SetH264VideoEncodingConfiguration.RegionOfInterestParams.layout(), default=None)
        gradual_decoder_refresh_params: SetH264VideoEncodingConfiguration.GradualDecoderRefreshParams | None = jd.field("GradualDecoderRefreshParams", lambda: SetH264VideoEncodingConfiguration.GradualDecoderRefreshParams.layout(), default=None)
        reserved_presence: int = 0

    request_id_rec: SetH264VideoEncodingConfiguration.RequestIdRec = jd.field("RequestIdRec", lambda: SetH264VideoEncodingConfiguration.RequestIdRec.layout())
    h264_configuration_list: list[SetH264VideoEncodingConfiguration.H264ConfigurationSequence] = jd.field("H264ConfigurationList", lambda: jd.Repeat(jd.Count("H", 0, 65535), SetH264VideoEncodingConfiguration.H264ConfigurationSequence.layout()))


@jd.message(_SERVICE, 0x480E)
class ReportH264VideoEncodingCapabilities(jd.Message):
    """ReportH264VideoEncodingCapabilities (0x480E): Tells what H.264 encoders can do.

    h264_capabilities_list: 0..65535 items. The encoders
    """

    class Baseline(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class ConstrainedBaseline(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Main(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Extended(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class High(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class ProgressiveHigh(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class ConstrainedHigh(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class High10(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class High422(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class High444Predictive(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class High10Intra(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class High422Intra(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class High444Intra(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class CAVLC444(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class ScalableBaseline(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class ScalableConstrainedBaseline(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class ScalableHigh(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class ScalableConstrainedHigh(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class ScalableHighIntra(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class StereoHigh(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class MultiviewHigh(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    @jd.bit_field("I")
    class SupportedProfiles(jd.Struct):
        """Sets of coding tools that the encoder offers.

        baseline: bit 0. Profile Baseline.
        constrained_baseline: bit 1. Profile Constrained Baseline.
        main: bit 2. Profile Main.
        extended: bit 3. Profile Extended.
        high: bit 4. Profile High.
        progressive_high: bit 5. Profile Progressive High.
        constrained_high: bit 6. Profile Constrained High.
        high10: bit 7. Profile High 10.
        high422: bit 8. Profile High 4:2:2.
        high444_predictive: bit 9. Profile High 4:4:4 Predictive.
        high10_intra: bit 10. Profile High 10 Intra.
        high422_intra: bit 11. Profile High 4:2:2 Intra.
        high444_intra: bit 12. Profile High 4:4:4 Intra.
        cavlc444: bit 13. Profile CAVLC 4:4:4 Intra.
        scalable_baseline: bit 14. Profile Scalable Baseline.
        scalable_constrained_baseline: bit 15. Profile Scalable Constrained Baseline.
        scalable_high: bit 16. Profile Scalable High.
        scalable_constrained_high: bit 17. Profile Scalable Constrained High.
        scalable_high_intra: bit 18. Profile Scalable High Intra.
        stereo_high: bit 19. Profile Stereo High.
        multiview_high: bit 20. Profile Multiview High.
        """
        baseline: ReportH264VideoEncodingCapabilities.Baseline | int = jd.bits(0, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.Baseline))
        constrained_baseline: ReportH264VideoEncodingCapabilities.ConstrainedBaseline | int = jd.bits(1, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.ConstrainedBaseline))
        main: ReportH264VideoEncodingCapabilities.Main | int = jd.bits(2, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.Main))
        extended: ReportH264VideoEncodingCapabilities.Extended | int = jd.bits(3, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.Extended))
        high: ReportH264VideoEncodingCapabilities.High | int = jd.bits(4, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.High))
        progressive_high: ReportH264VideoEncodingCapabilities.ProgressiveHigh | int = jd.bits(5, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.ProgressiveHigh))
        constrained_high: ReportH264VideoEncodingCapabilities.ConstrainedHigh | int = jd.bits(6, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.ConstrainedHigh))
        high10: ReportH264VideoEncodingCapabilities.High10 | int = jd.bits(7, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.High10))
        high422: ReportH264VideoEncodingCapabilities.High422 | int = jd.bits(8, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.High422))
        high444_predictive: ReportH264VideoEncodingCapabilities.High444Predictive | int = jd.bits(9, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.High444Predictive))
        high10_intra: ReportH264VideoEncodingCapabilities.High10Intra | int = jd.bits(10, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.High10Intra))
        high422_intra: ReportH264VideoEncodingCapabilities.High422Intra | int = jd.bits(11, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.High422Intra))
        high444_intra: ReportH264VideoEncodingCapabilities.High444Intra | int = jd.bits(12, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.High444Intra))
        cavlc444: ReportH264VideoEncodingCapabilities.CAVLC444 | int = jd.bits(13, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.CAVLC444))
        scalable_baseline: ReportH264VideoEncodingCapabilities.ScalableBaseline | int = jd.bits(14, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.ScalableBaseline))
        scalable_constrained_baseline: ReportH264VideoEncodingCapabilities.ScalableConstrainedBaseline | int = jd.bits(15, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.ScalableConstrainedBaseline))
        scalable_high: ReportH264VideoEncodingCapabilities.ScalableHigh | int = jd.bits(16, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.ScalableHigh))
        scalable_constrained_high: ReportH264VideoEncodingCapabilities.ScalableConstrainedHigh | int = jd.bits(17, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.ScalableConstrainedHigh))
        scalable_high_intra: ReportH264VideoEncodingCapabilities.ScalableHighIntra | int = jd.bits(18, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.ScalableHighIntra))
        stereo_high: ReportH264VideoEncodingCapabilities.StereoHigh | int = jd.bits(19, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.StereoHigh))
        multiview_high: ReportH264VideoEncodingCapabilities.MultiviewHigh | int = jd.bits(20, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.MultiviewHigh))
        reserved_bits: int = 0

    class Level_1(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Level_1B(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Level_11(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Level_12(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Level_13(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Level_2(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Level_21(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Level_22(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Level_3(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Level_31(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Level_32(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Level_4(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Level_41(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Level_42(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Level_5(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Level_51(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Level_52(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Level_6(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Level_61(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Level_62(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    @jd.bit_field("I")
    class SupportedLevels(jd.Struct):
        """Levels of size and rate that the encoder offers.

        level_1: bit 0. Level 1.
        level_1_b: bit 1. Level 1B.
        level_11: bit 2. Level 1.1.
        level_12: bit 3. Level 1.2.
        level_13: bit 4. Level 1.3.
        level_2: bit 5. Level 2.
        level_21: bit 6. Level 2.1.
        level_22: bit 7. Level 2.2.
        level_3: bit 8. Level 3.
        level_31: bit 9. Level 3.1.
        level_32: bit 10. Level 3.2.
        level_4: bit 11. Level 4.
        level_41: bit 12. Level 4.1.
        level_42: bit 13. Level 4.2.
        level_5: bit 14. Level 5.
        level_51: bit 15. Level 5.1.
        level_52: bit 16. Level 5.2.
        level_6: bit 17. Level 6.
        level_61: bit 18. Level 6.1.
        level_62: bit 19. Level 6.2.
        """
        level_1: ReportH264VideoEncodingCapabilities.Level_1 | int = jd.bits(0, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.Level_1))
        level_1_b: ReportH264VideoEncodingCapabilities.Level_1B | int = jd.bits(1, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.Level_1B))
        level_11: ReportH264VideoEncodingCapabilities.Level_11 | int = jd.bits(2, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.Level_11))
        level_12: ReportH264VideoEncodingCapabilities.Level_12 | int = jd.bits(3, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.Level_12))
        level_13: ReportH264VideoEncodingCapabilities.Level_13 | int = jd.bits(4, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.Level_13))
        level_2: ReportH264VideoEncodingCapabilities.Level_2 | int = jd.bits(5, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.Level_2))
        level_21: ReportH264VideoEncodingCapabilities.Level_21 | int = jd.bits(6, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.Level_21))
        level_22: ReportH264VideoEncodingCapabilities.Level_22 | int = jd.bits(7, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.Level_22))
        level_3: ReportH264VideoEncodingCapabilities.Level_3 | int = jd.bits(8, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.Level_3))
        level_31: ReportH264VideoEncodingCapabilities.Level_31 | int = jd.bits(9, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.Level_31))
        level_32: ReportH264VideoEncodingCapabilities.Level_32 | int = jd.bits(10, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.Level_32))
        level_4: ReportH264VideoEncodingCapabilities.Level_4 | int = jd.bits(11, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.Level_4))
        level_41: ReportH264VideoEncodingCapabilities.Level_41 | int = jd.bits(12, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.Level_41))
        level_42: ReportH264VideoEncodingCapabilities.Level_42 | int = jd.bits(13, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.Level_42))
        level_5: ReportH264VideoEncodingCapabilities.Level_5 | int = jd.bits(14, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.Level_5))
        level_51: ReportH264VideoEncodingCapabilities.Level_51 | int = jd.bits(15, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.Level_51))
        level_52: ReportH264VideoEncodingCapabilities.Level_52 | int = jd.bits(16, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.Level_52))
        level_6: ReportH264VideoEncodingCapabilities.Level_6 | int = jd.bits(17, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.Level_6))
        level_61: ReportH264VideoEncodingCapabilities.Level_61 | int = jd.bits(18, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.Level_61))
        level_62: ReportH264VideoEncodingCapabilities.Level_62 | int = jd.bits(19, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.Level_62))
        reserved_bits: int = 0

    class LowLatency(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class SlowComms(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class PersistentStare(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class DriveVision(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Manipulation(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class BestQuality(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    @jd.bit_field("H")
    class SupportedPresets(jd.Struct):
        """Purposes that the encoder can be tuned for.

        low_latency: bit 0. Least delay.
        slow_comms: bit 1. Slow links.
        persistent_stare: bit 2. Watching a place for long.
        drive_vision: bit 3. Driving.
        manipulation: bit 4. Manipulating.
        best_quality: bit 5. Best image.
        reserved: bits 6..11. Sent as 0, ignored when received.
        program_specific: bits 12..15. Of meaning to the maker alone.
        """
        low_latency: ReportH264VideoEncodingCapabilities.LowLatency | int = jd.bits(0, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.LowLatency))
        slow_comms: ReportH264VideoEncodingCapabilities.SlowComms | int = jd.bits(1, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.SlowComms))
        persistent_stare: ReportH264VideoEncodingCapabilities.PersistentStare | int = jd.bits(2, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.PersistentStare))
        drive_vision: ReportH264VideoEncodingCapabilities.DriveVision | int = jd.bits(3, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.DriveVision))
        manipulation: ReportH264VideoEncodingCapabilities.Manipulation | int = jd.bits(4, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.Manipulation))
        best_quality: ReportH264VideoEncodingCapabilities.BestQuality | int = jd.bits(5, 0x1, lambda: jd.Values(ReportH264VideoEncodingCapabilities.BestQuality))
        reserved: int = jd.bits(6, 0x3F, jd.Values(None, ((0, 63),)))
        program_specific: int = jd.bits(12, 0xF, jd.Values(None, ((0, 15),)))

    class GroupOfPicturesSupported(IntEnum):
        FALSE = 0
        TRUE = 1

    class GradualDecoderRefreshSupported(IntEnum):
        FALSE = 0
        TRUE = 1

    class RegionOfInterestSupported(IntEnum):
        FALSE = 0
        TRUE = 1

    @jd.record("B")
    class H264CapabilitiesRec(jd.Struct):
        """sensor_id: Identifies the sensor
        supported_profiles: optional. Sets of coding tools that the encoder offers
        supported_levels: optional. Levels of size and rate that the encoder offers
        supported_presets: optional. Purposes that the encoder can be tuned for
        group_of_pictures_supported: GroupOfPicturesSupported, optional. Whether the distance of complete frames can be set
        gradual_decoder_refresh_supported: GradualDecoderRefreshSupported, optional. Whether frames can be refreshed part by part
        region_of_interest_supported: RegionOfInterestSupported, optional. Whether part of the image can be coded better than the rest
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H"))
        supported_profiles: ReportH264VideoEncodingCapabilities.SupportedProfiles | None = jd.field("SupportedProfiles", lambda: ReportH264VideoEncodingCapabilities.SupportedProfiles.layout(), default=None)
        supported_levels: ReportH264VideoEncodingCapabilities.SupportedLevels | None = jd.field("SupportedLevels", lambda: ReportH264VideoEncodingCapabilities.SupportedLevels.layout(), default=None)
        supported_presets: ReportH264VideoEncodingCapabilities.SupportedPresets | None = jd.field("SupportedPresets", lambda: ReportH264VideoEncodingCapabilities.SupportedPresets.layout(), default=None)
        group_of_pictures_supported: ReportH264VideoEncodingCapabilities.GroupOfPicturesSupported | int | None = jd.field("GroupOfPicturesSupported", lambda: jd.Number("B", jd.Values(ReportH264VideoEncodingCapabilities.GroupOfPicturesSupported)), default=None)
        gradual_decoder_refresh_supported: ReportH264VideoEncodingCapabilities.GradualDecoderRefreshSupported | int | None = jd.field("GradualDecoderRefreshSupported", lambda: jd.Number("B", jd.Values(ReportH264VideoEncodingCapabilities.GradualDecoderRefreshSupported)), default=None)
        region_of_interest_supported: ReportH264VideoEncodingCapabilities.RegionOfInterestSupported | int | None = jd.field("RegionOfInterestSupported", lambda: jd.Number("B", jd.Values(ReportH264VideoEncodingCapabilities.RegionOfInterestSupported)), default=None)
        reserved_presence: int = 0

    h264_capabilities_list: list[ReportH264VideoEncodingCapabilities.H264CapabilitiesRec] = jd.field("H264CapabilitiesList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportH264VideoEncodingCapabilities.H264CapabilitiesRec.layout()))


@jd.message(_SERVICE, 0x280E, query=True)
class QueryH264VideoEncodingCapabilities(jd.Message):
    """QueryH264VideoEncodingCapabilities (0x280E): Asks what H.264 encoders can do.

    query_h264_video_encoding_capabilities_list: 0..65535 items. The encoders
    """
    REPORT = ReportH264VideoEncodingCapabilities

    @jd.record()
    class QueryH264VideoEncodingRec(jd.Struct):
        """sensor_id: Which sensor is meant; 0 is all"""
        sensor_id: int = jd.field("SensorID", jd.Number("H"))

    query_h264_video_encoding_capabilities_list: list[QueryH264VideoEncodingCapabilities.QueryH264VideoEncodingRec] = jd.field("QueryH264VideoEncodingCapabilitiesList", lambda: jd.Repeat(jd.Count("H", 0, 65535), QueryH264VideoEncodingCapabilities.QueryH264VideoEncodingRec.layout()))


@jd.message(_SERVICE, 0x480D)
class ReportH264VideoEncodingConfiguration(jd.Message):
    """ReportH264VideoEncodingConfiguration (0x480D): Tells the configuration of H.264 encoders.

    h264_configuration_list: 0..65535 items. The encoders
    """

    class Profile(IntEnum):
        BASELINE = 0
        CONSTRAINED_BASELINE = 1
        MAIN = 2
        EXTENDED = 3
        HIGH = 4
        PROGRESSIVE_HIGH = 5
        CONSTRAINED_HIGH = 6
        HIGH_10 = 7
        HIGH_422 = 8
        HIGH_444_PREDICTIVE = 9
        HIGH_10_INTRA = 10
        HIGH_422_INTRA = 11
        HIGH_444_INTRA = 12
        CAVLC444 = 13
        SCALABLE_BASELINE = 14
        SCALABLE_CONSTRAINED_BASELINE = 15
        SCALABLE_HIGH = 16
        SCALABLE_CONSTRAINED_HIGH = 17
        SCALABLE_HIGH_INTRA = 18
        STEREO_HIGH = 19
        MULTIVIEW_HIGH = 20

    class Level(IntEnum):
        LEVEL_1 = 0
        LEVEL_1_B = 1
        LEVEL_11 = 2
        LEVEL_12 = 3
        LEVEL_13 = 4
        LEVEL_2 = 5
        LEVEL_21 = 6
        LEVEL_22 = 7
        LEVEL_3 = 8
        LEVEL_31 = 9
        LEVEL_32 = 10
        LEVEL_4 = 11
        LEVEL_41 = 12
        LEVEL_42 = 13
        LEVEL_5 = 14
        LEVEL_51 = 15
        LEVEL_52 = 16
        LEVEL_6 = 17
        LEVEL_61 = 18
        LEVEL_62 = 19

    class Preset(IntEnum):
        LOW_LATENCY = 0
        SLOW_COMMS = 1
        PERSISTENT_STARE = 2
        DRIVE_VISION = 3
        MANIPULATION = 4
        BEST_QUALITY = 5
        PROGRAMSPECIFIC_1 = 12
        PROGRAMSPECIFIC_2 = 13
        PROGRAMSPECIFIC_3 = 14
        PROGRAMSPECIFIC_4 = 15

    class GradualDecoderRefreshOnOff(IntEnum):
        OFF = 0
        ON = 1

    class RegionOfInterestOnOff(IntEnum):
        OFF = 0
        ON = 1

    @jd.record("B")
    class H264ConfigurationRec(jd.Struct):
        """Settings of one encoder.

        sensor_id: Identifies the sensor
        profile: Profile, optional. Set of coding tools
        level: Level, optional. Level of size and rate
        preset: Preset, optional. Purpose that the encoder is tuned for
        group_of_pictures: optional. Number of frames from one complete frame to the next
        gradual_decoder_refresh_on_off: GradualDecoderRefreshOnOff, optional. Whether frames are refreshed part by part instead of by complete frames
        region_of_interest_on_off: RegionOfInterestOnOff, optional. Whether part of the image is coded better than the rest
        intra_macro_refresh: 0..100, optional. Blocks that are refreshed in each frame, in percent
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H"))
        profile: ReportH264VideoEncodingConfiguration.Profile | int | None = jd.field("Profile", lambda: jd.Number("B", jd.Values(ReportH264VideoEncodingConfiguration.Profile)), default=None)
        level: ReportH264VideoEncodingConfiguration.Level | int | None = jd.field("Level", lambda: jd.Number("I", jd.Values(ReportH264VideoEncodingConfiguration.Level)), default=None)
        preset: ReportH264VideoEncodingConfiguration.Preset | int | None = jd.field("Preset", lambda: jd.Number("B", jd.Values(ReportH264VideoEncodingConfiguration.Preset)), default=None)
        group_of_pictures: int | None = jd.field("GroupOfPictures", jd.Number("B"), default=None)
        gradual_decoder_refresh_on_off: ReportH264VideoEncodingConfiguration.GradualDecoderRefreshOnOff | int | None = jd.field("GradualDecoderRefreshOnOff", lambda: jd.Number("B", jd.Values(ReportH264VideoEncodingConfiguration.GradualDecoderRefreshOnOff)), default=None)
        region_of_interest_on_off: ReportH264VideoEncodingConfiguration.RegionOfInterestOnOff | int | None = jd.field("RegionOfInterestOnOff", lambda: jd.Number("B", jd.Values(ReportH264VideoEncodingConfiguration.RegionOfInterestOnOff)), default=None)
        intra_macro_refresh: float | None = jd.field("IntraMacroRefresh", jd.real("H", 0.0, 100.0), default=None)
        reserved_presence: int = 0

    @jd.record()
    class RegionOfInterestParams(jd.Struct):
        """Part of the image that is coded better.

        x_start: 0..100 percent. Left edge of the part, in percent of the image
        y_start: 0..100 percent. Upper edge of the part, in percent of the image
        width: 0..100 percent. Width of the part, in percent of the image
        height: 0..100 percent. Height of the part, in percent of the image
        high_bit_rate: Bit rate for the part, in kilobits per second
        low_bit_rate: Bit rate for the rest of the image, in kilobits per second
        """
        x_start: float = jd.field("X_Start", jd.real("H", 0.0, 100.0, "percent"))
        y_start: float = jd.field("Y_Start", jd.real("H", 0.0, 100.0, "percent"))
        width: float = jd.field("Width", jd.real("H", 0.0, 100.0, "percent"))
        height: float = jd.field("Height", jd.real("H", 0.0, 100.0, "percent"))
        high_bit_rate: int = jd.field("HighBitRate", jd.Number("H"))
        low_bit_rate: int = jd.field("LowBitRate", jd.Number("H"))

    @jd.record()
    class GradualDecoderRefreshParams(jd.Struct):
        """How frames are refreshed part by part.

        gdr_duration: Frames that one refresh takes
        gdr_interval: Frames from one refresh to the next
        """
        gdr_duration: int = jd.field("GDR_Duration", jd.Number("H"))
        gdr_interval: int = jd.field("GDR_Interval", jd.Number("H"))

    @jd.record("B")
    class H264ConfigurationSequence(jd.Struct):
        """h264_configuration_rec: Settings of one encoder
        region_of_interest_params: optional. Part of the image that is coded better
        gradual_decoder_refresh_params: optional. How frames are refreshed part by part
        """
        h264_configuration_rec: ReportH264VideoEncodingConfiguration.H264ConfigurationRec = jd.field("H264ConfigurationRec", lambda: ReportH264VideoEncodingConfiguration.H264ConfigurationRec.layout())
        region_of_interest_params: ReportH264VideoEncodingConfiguration.RegionOfInterestParams | None = jd.field("RegionOfInterestParams", lambda: ReportH264VideoEncodingConfiguration.RegionOfInterestParams.layout(), default=None)
        gradual_decoder_refresh_params: ReportH264VideoEncodingConfiguration.GradualDecoderRefreshParams | None = jd.field("GradualDecoderRefreshParams", lambda: ReportH264VideoEncodingConfiguration.GradualDecoderRefreshParams.layout(), default=None)
        reserved_presence: int = 0

    h264_configuration_list: list[ReportH264VideoEncodingConfiguration.H264ConfigurationSequence] = jd.field("H264ConfigurationList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportH264VideoEncodingConfiguration.H264ConfigurationSequence.layout()))


@jd.message(_SERVICE, 0x280D, query=True)
class QueryH264VideoEncodingConfiguration(jd.Message):
    """QueryH264VideoEncodingConfiguration (0x280D): Asks for the configuration of H.264 encoders.

    query_h264_video_encoding_configuration_list: 0..65535 items. The encoders
    """
    REPORT = ReportH264VideoEncodingConfiguration

    @jd.record()
    class QueryH264VideoEncodingRec(jd.Struct):
        """sensor_id: Which sensor is meant; 0 is all"""
        sensor_id: int = jd.field("SensorID", jd.Number("H"))

    query_h264_video_encoding_configuration_list: list[QueryH264VideoEncodingConfiguration.QueryH264VideoEncodingRec] = jd.field("QueryH264VideoEncodingConfigurationList", lambda: jd.Repeat(jd.Count("H", 0, 65535), QueryH264VideoEncodingConfiguration.QueryH264VideoEncodingRec.layout()))

@jd.derived(_SERVICE)
class ConfirmSensorConfiguration(environment_sensing_v2_0_digital_audio_output.ConfirmSensorConfiguration): ...
