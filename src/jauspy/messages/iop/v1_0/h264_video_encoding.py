"""urn:jaus:jss:iop:H264VideoEncoding 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:iop:H264VideoEncoding", "1.0")


@jd.message(_SERVICE, 0xEB93)
class ReportH264VideoEncodingCapabilities(jd.Message):
    """ReportH264VideoEncodingCapabilities (0xEB93): Tells which H.264 options the sensors offer.

    h264_capabilities_list: 0..65535 items. One element a video sensor
    """

    @jd.bit_field("I")
    class SupportedProfiles(jd.Struct):
        """A set bit marks an H.264 profile that is offered.

        baseline: bit 0. Baseline.
        constrained_baseline: bit 1. Constrained baseline.
        main: bit 2. Main.
        extended: bit 3. Extended.
        high: bit 4. High.
        progressive_high: bit 5. Progressive high.
        constrained_high: bit 6. Constrained high.
        high10: bit 7. High 10.
        high422: bit 8. High 422.
        high444_predictive: bit 9. High 444 predictive.
        high10_intra: bit 10. High 10 intra.
        high422_intra: bit 11. High 422 intra.
        high444_intra: bit 12. High 444 intra.
        cavlc444: bit 13. CAVLC 444.
        scalable_baseline: bit 14. Scalable baseline.
        scalable_constrained_baseline: bit 15. Scalable constrained baseline.
        scalable_high: bit 16. Scalable high.
        scalable_constrained_high: bit 17. Scalable constrained high.
        scalable_high_intra: bit 18. Scalable high intra.
        stereo_high: bit 19. Stereo high.
        multiview_high: bit 20. Multiview high.
        """
        baseline: int = jd.bits(0, 0x1)
        constrained_baseline: int = jd.bits(1, 0x1)
        main: int = jd.bits(2, 0x1)
        extended: int = jd.bits(3, 0x1)
        high: int = jd.bits(4, 0x1)
        progressive_high: int = jd.bits(5, 0x1)
        constrained_high: int = jd.bits(6, 0x1)
        high10: int = jd.bits(7, 0x1)
        high422: int = jd.bits(8, 0x1)
        high444_predictive: int = jd.bits(9, 0x1)
        high10_intra: int = jd.bits(10, 0x1)
        high422_intra: int = jd.bits(11, 0x1)
        high444_intra: int = jd.bits(12, 0x1)
        cavlc444: int = jd.bits(13, 0x1)
        scalable_baseline: int = jd.bits(14, 0x1)
        scalable_constrained_baseline: int = jd.bits(15, 0x1)
        scalable_high: int = jd.bits(16, 0x1)
        scalable_constrained_high: int = jd.bits(17, 0x1)
        scalable_high_intra: int = jd.bits(18, 0x1)
        stereo_high: int = jd.bits(19, 0x1)
        multiview_high: int = jd.bits(20, 0x1)
        reserved_bits: int = 0

    @jd.bit_field("I")
    class SupportedLevels(jd.Struct):
        """A set bit marks an H.264 level that is offered.

        level1: bit 0. Level 1.
        level1_b: bit 1. Level 1 b.
        level11: bit 2. Level 11.
        level12: bit 3. Level 12.
        level13: bit 4. Level 13.
        level2: bit 5. Level 2.
        level21: bit 6. Level 21.
        level22: bit 7. Level 22.
        level3: bit 8. Level 3.
        level31: bit 9. Level 31.
        level32: bit 10. Level 32.
        level4: bit 11. Level 4.
        level41: bit 12. Level 41.
        level42: bit 13. Level 42.
        level5: bit 14. Level 5.
        level51: bit 15. Level 51.
        level52: bit 16. Level 52.
        """
        level1: int = jd.bits(0, 0x1)
        level1_b: int = jd.bits(1, 0x1)
        level11: int = jd.bits(2, 0x1)
        level12: int = jd.bits(3, 0x1)
        level13: int = jd.bits(4, 0x1)
        level2: int = jd.bits(5, 0x1)
        level21: int = jd.bits(6, 0x1)
        level22: int = jd.bits(7, 0x1)
        level3: int = jd.bits(8, 0x1)
        level31: int = jd.bits(9, 0x1)
        level32: int = jd.bits(10, 0x1)
        level4: int = jd.bits(11, 0x1)
        level41: int = jd.bits(12, 0x1)
        level42: int = jd.bits(13, 0x1)
        level5: int = jd.bits(14, 0x1)
        level51: int = jd.bits(15, 0x1)
        level52: int = jd.bits(16, 0x1)
        reserved_bits: int = 0

    @jd.bit_field("H")
    class SupportedPresets(jd.Struct):
        """A set bit marks a named bundle of settings that is offered.

        low_latency: bit 0. Low latency.
        slow_comms: bit 1. Slow comms.
        persistent_stare: bit 2. Persistent stare.
        drive_vision: bit 3. Drive vision.
        manipulation: bit 4. Manipulation.
        best_quality: bit 5. Best quality.
        reserved: bits 6..11. Sent as 0, ignored when received.
        program_specific: bits 12..15. Bundles defined by the programme.
        """
        low_latency: int = jd.bits(0, 0x1)
        slow_comms: int = jd.bits(1, 0x1)
        persistent_stare: int = jd.bits(2, 0x1)
        drive_vision: int = jd.bits(3, 0x1)
        manipulation: int = jd.bits(4, 0x1)
        best_quality: int = jd.bits(5, 0x1)
        reserved: int = jd.bits(6, 0x3F, jd.Values(None, ((0, 63),)))
        program_specific: int = jd.bits(12, 0xF, jd.Values(None, ((0, 15),)))

    class GroupOfPicturesSupported(IntEnum):
        GROUP_OF_PICTURES_SUPPORTED_FALSE = 0
        GROUP_OF_PICTURES_SUPPORTED_TRUE = 1

    class GradualDecoderRefreshSupported(IntEnum):
        GRADUAL_DECODER_REFRESH_SUPPORTED_FALSE = 0
        GRADUAL_DECODER_REFRESH_SUPPORTED_TRUE = 1

    class RegionOfInterestSupported(IntEnum):
        REGION_OF_INTEREST_SUPPORTED_FALSE = 0
        REGION_OF_INTEREST_SUPPORTED_TRUE = 1

    @jd.record("B")
    class H264CapabilityRec(jd.Struct):
        """sensor_id: Number of the video sensor; 0 is not allowed
        supported_profiles: optional. A set bit marks an H.264 profile that is offered
        supported_levels: optional. A set bit marks an H.264 level that is offered
        supported_presets: optional. A set bit marks a named bundle of settings that is offered
        group_of_pictures_supported: GroupOfPicturesSupported, optional. Whether the key frame distance can be set
        gradual_decoder_refresh_supported: GradualDecoderRefreshSupported, optional. Whether intra blocks can be spread over the frames
        region_of_interest_supported: RegionOfInterestSupported, optional. Whether one window of the picture can be coded better than the rest
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H"))
        supported_profiles: ReportH264VideoEncodingCapabilities.SupportedProfiles | None = jd.field("SupportedProfiles", lambda: ReportH264VideoEncodingCapabilities.SupportedProfiles.layout(), default=None)
        supported_levels: ReportH264VideoEncodingCapabilities.SupportedLevels | None = jd.field("SupportedLevels", lambda: ReportH264VideoEncodingCapabilities.SupportedLevels.layout(), default=None)
        supported_presets: ReportH264VideoEncodingCapabilities.SupportedPresets | None = jd.field("SupportedPresets", lambda: ReportH264VideoEncodingCapabilities.SupportedPresets.layout(), default=None)
        group_of_pictures_supported: ReportH264VideoEncodingCapabilities.GroupOfPicturesSupported | int | None = jd.field("GroupOfPicturesSupported", lambda: jd.Number("B", jd.Values(ReportH264VideoEncodingCapabilities.GroupOfPicturesSupported)), default=None)
        gradual_decoder_refresh_supported: ReportH264VideoEncodingCapabilities.GradualDecoderRefreshSupported | int | None = jd.field("GradualDecoderRefreshSupported", lambda: jd.Number("B", jd.Values(ReportH264VideoEncodingCapabilities.GradualDecoderRefreshSupported)), default=None)
        region_of_interest_supported: ReportH264VideoEncodingCapabilities.RegionOfInterestSupported | int | None = jd.field("RegionOfInterestSupported", lambda: jd.Number("B", jd.Values(ReportH264VideoEncodingCapabilities.RegionOfInterestSupported)), default=None)
        reserved_presence: int = 0

    h264_capabilities_list: list[ReportH264VideoEncodingCapabilities.H264CapabilityRec] = jd.field("H264CapabilitiesList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportH264VideoEncodingCapabilities.H264CapabilityRec.layout()))


@jd.message(_SERVICE, 0xEB91, query=True)
class QueryH264VideoEncodingCapabilities(jd.Message):
    """QueryH264VideoEncodingCapabilities (0xEB91): Asks which H.264 options the listed sensors offer.

    query_h264_video_encoding_capabilities_list: 0..65535 items. Sensors asked about
    """
    REPORT = ReportH264VideoEncodingCapabilities

    @jd.record()
    class QueryH264VideoEncodingCapabilityRec(jd.Struct):
        """sensor_id: Number of the video sensor; 0 stands for every sensor"""
        sensor_id: int = jd.field("SensorID", jd.Number("H"))

    query_h264_video_encoding_capabilities_list: list[QueryH264VideoEncodingCapabilities.QueryH264VideoEncodingCapabilityRec] = jd.field("QueryH264VideoEncodingCapabilitiesList", lambda: jd.Repeat(jd.Count("H", 0, 65535), QueryH264VideoEncodingCapabilities.QueryH264VideoEncodingCapabilityRec.layout()))


@jd.message(_SERVICE, 0xEB94)
class ReportH264VideoEncodingConfiguration(jd.Message):
    """ReportH264VideoEncodingConfiguration (0xEB94): Tells the H.264 settings in force.

    h264_configuration_list: 0..65535 items. One element a video sensor
    """

    class Profile(IntEnum):
        BASELINE = 0
        CONSTRAINED_BASELINE = 1
        MAIN = 2
        EXTENDED = 3
        HIGH = 4
        PROGRESSIVE_HIGH = 5
        CONSTRAINED_HIGH = 6
        HIGH10 = 7
        HIGH422 = 8
        HIGH444_PREDICTIVE = 9
        HIGH10_INTRA = 10
        HIGH422_INTRA = 11
        HIGH444_INTRA = 12
        CAVLC444 = 13
        SCALABLE_BASELINE = 14
        SCALABLE_CONSTRAINED_BASELINE = 15
        SCALABLE_HIGH = 16
        SCALABLE_CONSTRAINED_HIGH = 17
        SCALABLE_HIGH_INTRA = 18
        STEREO_HIGH = 19
        MULTIVIEW_HIGH = 20

    class Preset(IntEnum):
        LOW_LATENCY = 0
        SLOW_COMMS = 1
        PERSISTENT_STARE = 2
        DRIVE_VISION = 3
        MANIPULATION = 4
        BEST_QUALITY = 5
        PROGRAM_SPECIFIC_1 = 12
        PROGRAM_SPECIFIC_2 = 13
        PROGRAM_SPECIFIC_3 = 14
        PROGRAM_SPECIFIC_4 = 15

    class GradualDecoderRefreshOnOff(IntEnum):
        OFF = 0
        ON = 1

    class RegionOfInterestOnOff(IntEnum):
        OFF = 0
        ON = 1

    @jd.record("B", kw_only=True)
    class H264ConfigurationRec(jd.Struct):
        """H 264 configuration.

        sensor_id: Number of the video sensor; 0 is not allowed
        profile: Profile, optional. H.264 profile
        preset: Preset, optional. Named bundle of encoder settings; what each one contains is up to the maker
        group_of_pictures: optional. Count of frames in between two key frames
        gradual_decoder_refresh_on_off: GradualDecoderRefreshOnOff, optional. Whether intra blocks are spread over the frames instead of whole key frames
        region_of_interest_on_off: RegionOfInterestOnOff, optional. Whether one window of the picture is coded better than the rest
        roi_parameters: 6 of 0..100. Six values in order: x, y, width, height (percent of the whole picture), bit rate in the window, bit rate outside (Mbit/s)
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H"))
        profile: ReportH264VideoEncodingConfiguration.Profile | int | None = jd.field("Profile", lambda: jd.Number("B", jd.Values(ReportH264VideoEncodingConfiguration.Profile)), default=None)
        preset: ReportH264VideoEncodingConfiguration.Preset | int | None = jd.field("Preset", lambda: jd.Number("B", jd.Values(ReportH264VideoEncodingConfiguration.Preset)), default=None)
        group_of_pictures: int | None = jd.field("GroupOfPictures", jd.Number("B"), default=None)
        gradual_decoder_refresh_on_off: ReportH264VideoEncodingConfiguration.GradualDecoderRefreshOnOff | int | None = jd.field("GradualDecoderRefreshOnOff", lambda: jd.Number("B", jd.Values(ReportH264VideoEncodingConfiguration.GradualDecoderRefreshOnOff)), default=None)
        region_of_interest_on_off: ReportH264VideoEncodingConfiguration.RegionOfInterestOnOff | int | None = jd.field("RegionOfInterestOnOff", lambda: jd.Number("B", jd.Values(ReportH264VideoEncodingConfiguration.RegionOfInterestOnOff)), default=None)
        roi_parameters: list[float] = jd.field("ROI_Parameters", jd.Grid(jd.real("H", 0.0, 100.0), (6,)))
        reserved_presence: int = 0

    h264_configuration_list: list[ReportH264VideoEncodingConfiguration.H264ConfigurationRec] = jd.field("H264ConfigurationList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportH264VideoEncodingConfiguration.H264ConfigurationRec.layout()))


@jd.message(_SERVICE, 0xEB92, query=True)
class QueryH264VideoEncodingConfiguration(jd.Message):
    """QueryH264VideoEncodingConfiguration (0xEB92): Asks for the H.264 settings in force for the listed sensors.

    query_h264_video_encoding_configuration_list: 0..65535 items. Sensors asked about
    """
    REPORT = ReportH264VideoEncodingConfiguration

    @jd.record()
    class QueryH264VideoEncodingConfigurationRec(jd.Struct):
        """sensor_id: Number of the video sensor; 0 stands for every sensor"""
        sensor_id: int = jd.field("SensorID", jd.Number("H"))

    query_h264_video_encoding_configuration_list: list[QueryH264VideoEncodingConfiguration.QueryH264VideoEncodingConfigurationRec] = jd.field("QueryH264VideoEncodingConfigurationList", lambda: jd.Repeat(jd.Count("H", 0, 65535), QueryH264VideoEncodingConfiguration.QueryH264VideoEncodingConfigurationRec.layout()))


@jd.message(_SERVICE, 0xEB90, command=True)
class SetH264VideoEncodingConfiguration(jd.Message):
    """SetH264VideoEncodingConfiguration (0xEB90): Sets the H.264 settings of one or more sensors.

    h264_configuration_list: 0..65535 items. One element a video sensor
    """

    class Profile(IntEnum):
        BASELINE = 0
        CONSTRAINED_BASELINE = 1
        MAIN = 2
        EXTENDED = 3
        HIGH = 4
        PROGRESSIVE_HIGH = 5
        CONSTRAINED_HIGH = 6
        HIGH10 = 7
        HIGH422 = 8
        HIGH444_PREDICTIVE = 9
        HIGH10_INTRA = 10
        HIGH422_INTRA = 11
        HIGH444_INTRA = 12
        CAVLC444 = 13
        SCALABLE_BASELINE = 14
        SCALABLE_CONSTRAINED_BASELINE = 15
        SCALABLE_HIGH = 16
        SCALABLE_CONSTRAINED_HIGH = 17
        SCALABLE_HIGH_INTRA = 18
        STEREO_HIGH = 19
        MULTIVIEW_HIGH = 20

    class Preset(IntEnum):
        LOW_LATENCY = 0
        SLOW_COMMS = 1
        PERSISTENT_STARE = 2
        DRIVE_VISION = 3
        MANIPULATION = 4
        BEST_QUALITY = 5
        PROGRAM_SPECIFIC_1 = 12
        PROGRAM_SPECIFIC_2 = 13
        PROGRAM_SPECIFIC_3 = 14
        PROGRAM_SPECIFIC_4 = 15

    class GradualDecoderRefreshOnOff(IntEnum):
        OFF = 0
        ON = 1

    class RegionOfInterestOnOff(IntEnum):
        OFF = 0
        ON = 1

    @jd.record("B", kw_only=True)
    class H264ConfigurationRec(jd.Struct):
        """H 264 configuration.

        sensor_id: Number of the video sensor; 0 is not allowed
        profile: Profile, optional. H.264 profile
        preset: Preset, optional. Named bundle of encoder settings; what each one contains is up to the maker
        group_of_pictures: optional. Count of frames in between two key frames
        gradual_decoder_refresh_on_off: GradualDecoderRefreshOnOff, optional. Whether intra blocks are spread over the frames instead of whole key frames
        region_of_interest_on_off: RegionOfInterestOnOff, optional. Whether one window of the picture is coded better than the rest
        roi_parameters: 6 of 0..100. Six values in order: x, y, width, height (percent of the whole picture), bit rate in the window, bit rate outside (Mbit/s)
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H"))
        profile: SetH264VideoEncodingConfiguration.Profile | int | None = jd.field("Profile", lambda: jd.Number("B", jd.Values(SetH264VideoEncodingConfiguration.Profile)), default=None)
        preset: SetH264VideoEncodingConfiguration.Preset | int | None = jd.field("Preset", lambda: jd.Number("B", jd.Values(SetH264VideoEncodingConfiguration.Preset)), default=None)
        group_of_pictures: int | None = jd.field("GroupOfPictures", jd.Number("B"), default=None)
        gradual_decoder_refresh_on_off: SetH264VideoEncodingConfiguration.GradualDecoderRefreshOnOff | int | None = jd.field("GradualDecoderRefreshOnOff", lambda: jd.Number("B", jd.Values(SetH264VideoEncodingConfiguration.GradualDecoderRefreshOnOff)), default=None)
        region_of_interest_on_off: SetH264VideoEncodingConfiguration.RegionOfInterestOnOff | int | None = jd.field("RegionOfInterestOnOff", lambda: jd.Number("B", jd.Values(SetH264VideoEncodingConfiguration.RegionOfInterestOnOff)), default=None)
        roi_parameters: list[float] = jd.field("ROI_Parameters", jd.Grid(jd.real("H", 0.0, 100.0), (6,)))
        reserved_presence: int = 0

    h264_configuration_list: list[SetH264VideoEncodingConfiguration.H264ConfigurationRec] = jd.field("H264ConfigurationList", lambda: jd.Repeat(jd.Count("H", 0, 65535), SetH264VideoEncodingConfiguration.H264ConfigurationRec.layout()))
