"""Declared types that several messages share. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd


@jd.bit_field("B")
class SupportedAnalogFormats(jd.Struct):
    """ntscm: bit 0. NTSC-M.
    ntscj: bit 1. NTSC-J.
    paln: bit 2. PAL-N.
    palm: bit 3. PAL-M.
    secaml: bit 4. SECAM-L.
    secambg: bit 5. SECAM-B/G.
    """

    class NTSCM(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class NTSCJ(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class PALN(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class PALM(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class SECAML(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class SECAMBG(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    ntscm: SupportedAnalogFormats.NTSCM | int = jd.bits(0, 0x1, lambda: jd.Values(SupportedAnalogFormats.NTSCM))
    ntscj: SupportedAnalogFormats.NTSCJ | int = jd.bits(1, 0x1, lambda: jd.Values(SupportedAnalogFormats.NTSCJ))
    paln: SupportedAnalogFormats.PALN | int = jd.bits(2, 0x1, lambda: jd.Values(SupportedAnalogFormats.PALN))
    palm: SupportedAnalogFormats.PALM | int = jd.bits(3, 0x1, lambda: jd.Values(SupportedAnalogFormats.PALM))
    secaml: SupportedAnalogFormats.SECAML | int = jd.bits(4, 0x1, lambda: jd.Values(SupportedAnalogFormats.SECAML))
    secambg: SupportedAnalogFormats.SECAMBG | int = jd.bits(5, 0x1, lambda: jd.Values(SupportedAnalogFormats.SECAMBG))
    reserved_bits: int = 0


@jd.bit_field("I")
class SupportedFrameSizes(jd.Struct):
    """sqcif_128_x96: bit 0. 128 x 96 pixels.
    qcif_176_x144: bit 1. 176 x 144 pixels.
    cif_352_x288: bit 2. 352 x 288 pixels.
    cif4_704_x576: bit 3. 704 x 576 pixels.
    cif16_1408_x1152: bit 4. 1408 x 1152 pixels.
    qqvga_160_x120: bit 5. 160 x 120 pixels.
    qvga_320_x240: bit 6. 320 x 240 pixels.
    vga_640_x480: bit 7. 640 x 480 pixels.
    svga_800_x600: bit 8. 800 x 600 pixels.
    xga_1024_x768: bit 9. 1024 x 768 pixels.
    uxga_1600_x1200: bit 10. 1600 x 1200 pixels.
    qxga_2048_x1536: bit 11. 2048 x 1536 pixels.
    sxga_1280_x1024: bit 12. 1280 x 1024 pixels.
    qsxga_2560_x2048: bit 13. 2560 x 2048 pixels.
    hsxga_5120_x4096: bit 14. 5120 x 4096 pixels.
    wvga_852_x480: bit 15. 852 x 480 pixels.
    wxga_1366_x768: bit 16. 1366 x 768 pixels.
    wsxga_1600_x1024: bit 17. 1600 x 1024 pixels.
    wuxga_1920_x1200: bit 18. 1920 x 1200 pixels.
    woxga_2560_x1600: bit 19. 2560 x 1600 pixels.
    wqsxga_3200_x2048: bit 20. 3200 x 2048 pixels.
    wquxga_3840_x2400: bit 21. 3840 x 2400 pixels.
    whsxga_6400_x4096: bit 22. 6400 x 4096 pixels.
    whuxga_7680_x4800: bit 23. 7680 x 4800 pixels.
    cga_320_x200: bit 24. 320 x 200 pixels.
    ega_640_x350: bit 25. 640 x 350 pixels.
    hd480_852_x480: bit 26. 852 x 480 pixels.
    hd720_1280_x720: bit 27. 1280 x 720 pixels.
    hd1080_1920_x1080: bit 28. 1920 x 1080 pixels.
    """

    class Sqcif_128x96(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Qcif_176x144(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Cif_352x288(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Cif4_704x576(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Cif16_1408x1152(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Qqvga_160x120(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Qvga_320x240(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Vga_640x480(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Svga_800x600(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Xga_1024x768(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Uxga_1600x1200(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Qxga_2048x1536(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Sxga_1280x1024(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Qsxga_2560x2048(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Hsxga_5120x4096(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Wvga_852x480(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Wxga_1366x768(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Wsxga_1600x1024(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Wuxga_1920x1200(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Woxga_2560x1600(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Wqsxga_3200x2048(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Wquxga_3840x2400(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Whsxga_6400x4096(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Whuxga_7680x4800(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Cga_320x200(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Ega_640x350(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Hd480_852x480(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Hd720_1280x720(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Hd1080_1920x1080(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    sqcif_128_x96: SupportedFrameSizes.Sqcif_128x96 | int = jd.bits(0, 0x1, lambda: jd.Values(SupportedFrameSizes.Sqcif_128x96))
    qcif_176_x144: SupportedFrameSizes.Qcif_176x144 | int = jd.bits(1, 0x1, lambda: jd.Values(SupportedFrameSizes.Qcif_176x144))
    cif_352_x288: SupportedFrameSizes.Cif_352x288 | int = jd.bits(2, 0x1, lambda: jd.Values(SupportedFrameSizes.Cif_352x288))
    cif4_704_x576: SupportedFrameSizes.Cif4_704x576 | int = jd.bits(3, 0x1, lambda: jd.Values(SupportedFrameSizes.Cif4_704x576))
    cif16_1408_x1152: SupportedFrameSizes.Cif16_1408x1152 | int = jd.bits(4, 0x1, lambda: jd.Values(SupportedFrameSizes.Cif16_1408x1152))
    qqvga_160_x120: SupportedFrameSizes.Qqvga_160x120 | int = jd.bits(5, 0x1, lambda: jd.Values(SupportedFrameSizes.Qqvga_160x120))
    qvga_320_x240: SupportedFrameSizes.Qvga_320x240 | int = jd.bits(6, 0x1, lambda: jd.Values(SupportedFrameSizes.Qvga_320x240))
    vga_640_x480: SupportedFrameSizes.Vga_640x480 | int = jd.bits(7, 0x1, lambda: jd.Values(SupportedFrameSizes.Vga_640x480))
    svga_800_x600: SupportedFrameSizes.Svga_800x600 | int = jd.bits(8, 0x1, lambda: jd.Values(SupportedFrameSizes.Svga_800x600))
    xga_1024_x768: SupportedFrameSizes.Xga_1024x768 | int = jd.bits(9, 0x1, lambda: jd.Values(SupportedFrameSizes.Xga_1024x768))
    uxga_1600_x1200: SupportedFrameSizes.Uxga_1600x1200 | int = jd.bits(10, 0x1, lambda: jd.Values(SupportedFrameSizes.Uxga_1600x1200))
    qxga_2048_x1536: SupportedFrameSizes.Qxga_2048x1536 | int = jd.bits(11, 0x1, lambda: jd.Values(SupportedFrameSizes.Qxga_2048x1536))
    sxga_1280_x1024: SupportedFrameSizes.Sxga_1280x1024 | int = jd.bits(12, 0x1, lambda: jd.Values(SupportedFrameSizes.Sxga_1280x1024))
    qsxga_2560_x2048: SupportedFrameSizes.Qsxga_2560x2048 | int = jd.bits(13, 0x1, lambda: jd.Values(SupportedFrameSizes.Qsxga_2560x2048))
    hsxga_5120_x4096: SupportedFrameSizes.Hsxga_5120x4096 | int = jd.bits(14, 0x1, lambda: jd.Values(SupportedFrameSizes.Hsxga_5120x4096))
    wvga_852_x480: SupportedFrameSizes.Wvga_852x480 | int = jd.bits(15, 0x1, lambda: jd.Values(SupportedFrameSizes.Wvga_852x480))
    wxga_1366_x768: SupportedFrameSizes.Wxga_1366x768 | int = jd.bits(16, 0x1, lambda: jd.Values(SupportedFrameSizes.Wxga_1366x768))
    wsxga_1600_x1024: SupportedFrameSizes.Wsxga_1600x1024 | int = jd.bits(17, 0x1, lambda: jd.Values(SupportedFrameSizes.Wsxga_1600x1024))
    wuxga_1920_x1200: SupportedFrameSizes.Wuxga_1920x1200 | int = jd.bits(18, 0x1, lambda: jd.Values(SupportedFrameSizes.Wuxga_1920x1200))
    woxga_2560_x1600: SupportedFrameSizes.Woxga_2560x1600 | int = jd.bits(19, 0x1, lambda: jd.Values(SupportedFrameSizes.Woxga_2560x1600))
    wqsxga_3200_x2048: SupportedFrameSizes.Wqsxga_3200x2048 | int = jd.bits(20, 0x1, lambda: jd.Values(SupportedFrameSizes.Wqsxga_3200x2048))
    wquxga_3840_x2400: SupportedFrameSizes.Wquxga_3840x2400 | int = jd.bits(21, 0x1, lambda: jd.Values(SupportedFrameSizes.Wquxga_3840x2400))
    whsxga_6400_x4096: SupportedFrameSizes.Whsxga_6400x4096 | int = jd.bits(22, 0x1, lambda: jd.Values(SupportedFrameSizes.Whsxga_6400x4096))
    whuxga_7680_x4800: SupportedFrameSizes.Whuxga_7680x4800 | int = jd.bits(23, 0x1, lambda: jd.Values(SupportedFrameSizes.Whuxga_7680x4800))
    cga_320_x200: SupportedFrameSizes.Cga_320x200 | int = jd.bits(24, 0x1, lambda: jd.Values(SupportedFrameSizes.Cga_320x200))
    ega_640_x350: SupportedFrameSizes.Ega_640x350 | int = jd.bits(25, 0x1, lambda: jd.Values(SupportedFrameSizes.Ega_640x350))
    hd480_852_x480: SupportedFrameSizes.Hd480_852x480 | int = jd.bits(26, 0x1, lambda: jd.Values(SupportedFrameSizes.Hd480_852x480))
    hd720_1280_x720: SupportedFrameSizes.Hd720_1280x720 | int = jd.bits(27, 0x1, lambda: jd.Values(SupportedFrameSizes.Hd720_1280x720))
    hd1080_1920_x1080: SupportedFrameSizes.Hd1080_1920x1080 | int = jd.bits(28, 0x1, lambda: jd.Values(SupportedFrameSizes.Hd1080_1920x1080))
    reserved_bits: int = 0


@jd.bit_field("B")
class SupportedDigitalFormats(jd.Struct):
    """avi: bit 0. AVI.
    mjpeg: bit 1. Motion JPEG.
    mpeg2: bit 2. MPEG-2.
    h263: bit 3. H.263.
    h26_3_plus: bit 4. H.263+.
    mpeg4_visual: bit 5. MPEG-4 part 2.
    mpeg4_avc_h264: bit 6. MPEG-4 part 10, which is H.264.
    """

    class AVI(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class MJPEG(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class MPEG2(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class H263(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class H263plus(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class MPEG4_Visual(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class MPEG4_AVC_h264(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    avi: SupportedDigitalFormats.AVI | int = jd.bits(0, 0x1, lambda: jd.Values(SupportedDigitalFormats.AVI))
    mjpeg: SupportedDigitalFormats.MJPEG | int = jd.bits(1, 0x1, lambda: jd.Values(SupportedDigitalFormats.MJPEG))
    mpeg2: SupportedDigitalFormats.MPEG2 | int = jd.bits(2, 0x1, lambda: jd.Values(SupportedDigitalFormats.MPEG2))
    h263: SupportedDigitalFormats.H263 | int = jd.bits(3, 0x1, lambda: jd.Values(SupportedDigitalFormats.H263))
    h26_3_plus: SupportedDigitalFormats.H263plus | int = jd.bits(4, 0x1, lambda: jd.Values(SupportedDigitalFormats.H263plus))
    mpeg4_visual: SupportedDigitalFormats.MPEG4_Visual | int = jd.bits(5, 0x1, lambda: jd.Values(SupportedDigitalFormats.MPEG4_Visual))
    mpeg4_avc_h264: SupportedDigitalFormats.MPEG4_AVC_h264 | int = jd.bits(6, 0x1, lambda: jd.Values(SupportedDigitalFormats.MPEG4_AVC_h264))
    reserved_bits: int = 0


@jd.record()
class RangeSensorErrorRecV1(jd.Struct):
    """sensor_id: Identifies the sensor
    range_sensor_error_code: RangeSensorErrorCode. What was wrong
    error_message: up to 255 characters. An explanation for people
    """

    class RangeSensorErrorCode(IntEnum):
        UNKNOWN_SENSOR_ID = 0
        INVALID_HORIZONTAL_FOV = 1
        INVALID_VERTICAL_FOV = 2
        INVALID_UPDATE_RATE = 3
        INVALID_SENSOR_RANGE = 4
        INVALID_SENSOR_STATE = 5
        MULTIPLE_INVALID_PARAMETERS = 6
        UNKNOWN_ERROR = 255

    sensor_id: int = jd.field("SensorID", jd.Number("H"))
    range_sensor_error_code: RangeSensorErrorRecV1.RangeSensorErrorCode | int = jd.field("RangeSensorErrorCode", lambda: jd.Number("B", jd.Values(RangeSensorErrorRecV1.RangeSensorErrorCode)))
    error_message: str = jd.field("ErrorMessage", jd.Text(count=jd.Count("B", 0, 255)))


@jd.record()
class VisualSensorErrorRecV1(jd.Struct):
    """sensor_id: Identifies the sensor
    visual_sensor_error_code: VisualSensorErrorCode. What was wrong
    error_message: up to 255 characters. An explanation for people
    """

    class VisualSensorErrorCode(IntEnum):
        UNKNOWN_SENSOR_ID = 0
        INVALID_SENSOR_STATE = 1
        INVALID_ZOOM_MODE = 2
        INVALID_ZOOM_VALUE = 3
        INVALID_FOCUS_MODE = 4
        INVALID_FOCUS_VALUE = 5
        INVALID_WHITE_BALANCE = 6
        INVALID_IMAGING_MODE = 7
        INVALID_EXPOSURE_MODE = 8
        INVALID_METERING_MODE = 9
        INVALID_SHUTTER_SPEED = 10
        INVALID_APERTURE_VALUE = 11
        INVALID_LIGHT_SENSITIVITY = 12
        INVALID_IMAGE_STABILIZATION = 13
        INVALID_HORIZONTAL_FOV = 14
        INVALID_VERTICAL_FOV = 15
        MULTIPLE_INVALID_PARAMETERS = 16
        UNKNOWN_ERROR = 255

    sensor_id: int = jd.field("SensorID", jd.Number("H"))
    visual_sensor_error_code: VisualSensorErrorRecV1.VisualSensorErrorCode | int = jd.field("VisualSensorErrorCode", lambda: jd.Number("B", jd.Values(VisualSensorErrorRecV1.VisualSensorErrorCode)))
    error_message: str = jd.field("ErrorMessage", jd.Text(count=jd.Count("B", 0, 255)))


@jd.record()
class DigitalVideoSensorErrorRecV1(jd.Struct):
    """sensor_id: Identifies the sensor
    digital_video_error_code: DigitalVideoErrorCode. What was wrong
    error_message: up to 255 characters. An explanation for people
    """

    class DigitalVideoErrorCode(IntEnum):
        UNKNOWN_SENSOR_ID = 0
        INVALID_MINIMUM_BIT_RATE = 1
        INVALID_MAXIMUM_BIT_RATE = 2
        INVALID_MINIMUM_FRAME_RATE = 3
        INVALID_MAXIMUM_FRAME_RATE = 4
        INVALID_FRAME_SIZE = 5
        INVALID_FORMAT = 6
        MULTIPLE_INVALID_PARAMETERS = 7
        UNKNOWN_ERROR = 255

    sensor_id: int = jd.field("SensorID", jd.Number("H"))
    digital_video_error_code: DigitalVideoSensorErrorRecV1.DigitalVideoErrorCode | int = jd.field("DigitalVideoErrorCode", lambda: jd.Number("B", jd.Values(DigitalVideoSensorErrorRecV1.DigitalVideoErrorCode)))
    error_message: str = jd.field("ErrorMessage", jd.Text(count=jd.Count("B", 0, 255)))


@jd.record()
class AnalogVideoSensorErrorRecV1(jd.Struct):
    """sensor_id: Identifies the sensor
    analog_video_error_code: AnalogVideoErrorCode. What was wrong
    error_message: up to 255 characters. An explanation for people
    """

    class AnalogVideoErrorCode(IntEnum):
        UNKNOWN_SENSOR_ID = 0
        INVALID_FORMAT = 1
        UNKNOWN_ERROR = 255

    sensor_id: int = jd.field("SensorID", jd.Number("H"))
    analog_video_error_code: AnalogVideoSensorErrorRecV1.AnalogVideoErrorCode | int = jd.field("AnalogVideoErrorCode", lambda: jd.Number("B", jd.Values(AnalogVideoSensorErrorRecV1.AnalogVideoErrorCode)))
    error_message: str = jd.field("ErrorMessage", jd.Text(count=jd.Count("B", 0, 255)))


@jd.record()
class StillImageSensorErrorRecV1(jd.Struct):
    """sensor_id: Identifies the sensor
    still_image_error_code: StillImageErrorCode. What was wrong
    error_message: up to 255 characters. An explanation for people
    """

    class StillImageErrorCode(IntEnum):
        UNKNOWN_SENSOR_ID = 0
        INVALID_FRAME_SIZE = 1
        INVALID_FORMAT = 2
        MULTIPLE_INVALID_PARAMETERS = 3
        UNKNOWN_ERROR = 255

    sensor_id: int = jd.field("SensorID", jd.Number("H"))
    still_image_error_code: StillImageSensorErrorRecV1.StillImageErrorCode | int = jd.field("StillImageErrorCode", lambda: jd.Number("B", jd.Values(StillImageSensorErrorRecV1.StillImageErrorCode)))
    error_message: str = jd.field("ErrorMessage", jd.Text(count=jd.Count("B", 0, 255)))


@jd.bit_field("B")
class SupportedStates(jd.Struct):
    """active: bit 0. Working.
    standby: bit 1. Ready to work.
    off: bit 2. Off.
    """

    class Active(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Standby(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Off(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    active: SupportedStates.Active | int = jd.bits(0, 0x1, lambda: jd.Values(SupportedStates.Active))
    standby: SupportedStates.Standby | int = jd.bits(1, 0x1, lambda: jd.Values(SupportedStates.Standby))
    off: SupportedStates.Off | int = jd.bits(2, 0x1, lambda: jd.Values(SupportedStates.Off))
    reserved_bits: int = 0


@jd.bit_field("B")
class SupportedCompression(jd.Struct):
    """no_compression: bit 0. None.
    deflate: bit 1. Deflate.
    bzip2: bit 2. bzip2.
    lzma: bit 3. LZMA.
    """

    class NoCompression(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class DEFLATE(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Bzip2(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class LZMA(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    no_compression: SupportedCompression.NoCompression | int = jd.bits(0, 0x1, lambda: jd.Values(SupportedCompression.NoCompression))
    deflate: SupportedCompression.DEFLATE | int = jd.bits(1, 0x1, lambda: jd.Values(SupportedCompression.DEFLATE))
    bzip2: SupportedCompression.Bzip2 | int = jd.bits(2, 0x1, lambda: jd.Values(SupportedCompression.Bzip2))
    lzma: SupportedCompression.LZMA | int = jd.bits(3, 0x1, lambda: jd.Values(SupportedCompression.LZMA))
    reserved_bits: int = 0


@jd.record()
class StaticGeometricPropertiesRec(jd.Struct):
    """sensor_position: 3 of -30..30 meter. Position of the sensor in the frame that it is mounted in: X, Y, Z
    unit_quaternion: 4 of -1..1. Attitude of the sensor in the frame that it is mounted in, as a unit quaternion
    """
    sensor_position: list[float] = jd.field("SensorPosition", jd.Grid(jd.real("I", -30.0, 30.0, "meter"), (3,)))
    unit_quaternion: list[float] = jd.field("UnitQuaternion", jd.Grid(jd.real("I", -1.0, 1.0), (4,)))


@jd.record()
class ManipulatorGeometricPropertiesRec(jd.Struct):
    """subsystem_id: Subsystem of the manipulator
    node_id: Node of the manipulator
    component_id: Component of the manipulator
    joint_number: Number of the joint that the sensor moves with
    sensor_position: 3 of -30..30 meter. Position of the sensor in the frame that it is mounted in: X, Y, Z
    unit_quaternion: 4 of -1..1. Attitude of the sensor in the frame that it is mounted in, as a unit quaternion
    """
    subsystem_id: int = jd.field("SubsystemID", jd.Number("H"))
    node_id: int = jd.field("NodeID", jd.Number("B"))
    component_id: int = jd.field("ComponentID", jd.Number("B"))
    joint_number: int = jd.field("JointNumber", jd.Number("B"))
    sensor_position: list[float] = jd.field("SensorPosition", jd.Grid(jd.real("I", -30.0, 30.0, "meter"), (3,)))
    unit_quaternion: list[float] = jd.field("UnitQuaternion", jd.Grid(jd.real("I", -1.0, 1.0), (4,)))


@jd.bit_field("H")
class SupportedImageFormats(jd.Struct):
    """jpeg: bit 0. JPEG.
    gif: bit 1. GIF.
    png: bit 2. PNG.
    bmp: bit 3. Windows bitmap.
    tiff: bit 4. TIFF.
    ppm: bit 5. Portable pixmap.
    pgm: bit 6. Portable graymap.
    pnm: bit 7. Portable anymap.
    nef_nikon_raw: bit 8. Nikon raw.
    cr2_canon_raw: bit 9. Canon raw.
    dng_adobe_raw: bit 10. Adobe digital negative.
    """

    class JPEG(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class GIF(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class PNG(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class BMP(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class TIFF(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class PPM(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class PGM(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class PNM(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class NEF_Nikon_RAW(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class CR2_Canon_RAW(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class DNG_Adobe_RAW(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    jpeg: SupportedImageFormats.JPEG | int = jd.bits(0, 0x1, lambda: jd.Values(SupportedImageFormats.JPEG))
    gif: SupportedImageFormats.GIF | int = jd.bits(1, 0x1, lambda: jd.Values(SupportedImageFormats.GIF))
    png: SupportedImageFormats.PNG | int = jd.bits(2, 0x1, lambda: jd.Values(SupportedImageFormats.PNG))
    bmp: SupportedImageFormats.BMP | int = jd.bits(3, 0x1, lambda: jd.Values(SupportedImageFormats.BMP))
    tiff: SupportedImageFormats.TIFF | int = jd.bits(4, 0x1, lambda: jd.Values(SupportedImageFormats.TIFF))
    ppm: SupportedImageFormats.PPM | int = jd.bits(5, 0x1, lambda: jd.Values(SupportedImageFormats.PPM))
    pgm: SupportedImageFormats.PGM | int = jd.bits(6, 0x1, lambda: jd.Values(SupportedImageFormats.PGM))
    pnm: SupportedImageFormats.PNM | int = jd.bits(7, 0x1, lambda: jd.Values(SupportedImageFormats.PNM))
    nef_nikon_raw: SupportedImageFormats.NEF_Nikon_RAW | int = jd.bits(8, 0x1, lambda: jd.Values(SupportedImageFormats.NEF_Nikon_RAW))
    cr2_canon_raw: SupportedImageFormats.CR2_Canon_RAW | int = jd.bits(9, 0x1, lambda: jd.Values(SupportedImageFormats.CR2_Canon_RAW))
    dng_adobe_raw: SupportedImageFormats.DNG_Adobe_RAW | int = jd.bits(10, 0x1, lambda: jd.Values(SupportedImageFormats.DNG_Adobe_RAW))
    reserved_bits: int = 0


@jd.bit_field("B")
class ZoomModes(jd.Struct):
    """mixed: bit 0. By the lens, then by computation.
    analog_only: bit 1. By the lens alone.
    digital_only: bit 2. By computation alone.
    none: bit 3. No zoom.
    """

    class Mixed(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class AnalogOnly(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class DigitalOnly(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class None_(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    mixed: ZoomModes.Mixed | int = jd.bits(0, 0x1, lambda: jd.Values(ZoomModes.Mixed))
    analog_only: ZoomModes.AnalogOnly | int = jd.bits(1, 0x1, lambda: jd.Values(ZoomModes.AnalogOnly))
    digital_only: ZoomModes.DigitalOnly | int = jd.bits(2, 0x1, lambda: jd.Values(ZoomModes.DigitalOnly))
    none: ZoomModes.None_ | int = jd.bits(3, 0x1, lambda: jd.Values(ZoomModes.None_))
    reserved_bits: int = 0


@jd.bit_field("B")
class FocusModes(jd.Struct):
    """auto_focus: bit 0. Automatic.
    manual_focus: bit 1. By setting.
    """

    class AutoFocus(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class ManualFocus(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    auto_focus: FocusModes.AutoFocus | int = jd.bits(0, 0x1, lambda: jd.Values(FocusModes.AutoFocus))
    manual_focus: FocusModes.ManualFocus | int = jd.bits(1, 0x1, lambda: jd.Values(FocusModes.ManualFocus))
    reserved_bits: int = 0


@jd.bit_field("B")
class SupportedWhiteBalance(jd.Struct):
    """auto: bit 0. Found automatically.
    daylight: bit 1. Daylight.
    cloudy: bit 2. Cloudy sky.
    shade: bit 3. Shade.
    tungsten: bit 4. Tungsten lamps.
    flurescent: bit 5. Fluorescent lamps.
    flash: bit 6. Flash.
    """

    class Auto(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Daylight(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Cloudy(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Shade(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Tungsten(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Flurescent(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Flash(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    auto: SupportedWhiteBalance.Auto | int = jd.bits(0, 0x1, lambda: jd.Values(SupportedWhiteBalance.Auto))
    daylight: SupportedWhiteBalance.Daylight | int = jd.bits(1, 0x1, lambda: jd.Values(SupportedWhiteBalance.Daylight))
    cloudy: SupportedWhiteBalance.Cloudy | int = jd.bits(2, 0x1, lambda: jd.Values(SupportedWhiteBalance.Cloudy))
    shade: SupportedWhiteBalance.Shade | int = jd.bits(3, 0x1, lambda: jd.Values(SupportedWhiteBalance.Shade))
    tungsten: SupportedWhiteBalance.Tungsten | int = jd.bits(4, 0x1, lambda: jd.Values(SupportedWhiteBalance.Tungsten))
    flurescent: SupportedWhiteBalance.Flurescent | int = jd.bits(5, 0x1, lambda: jd.Values(SupportedWhiteBalance.Flurescent))
    flash: SupportedWhiteBalance.Flash | int = jd.bits(6, 0x1, lambda: jd.Values(SupportedWhiteBalance.Flash))
    reserved_bits: int = 0


@jd.bit_field("B")
class ExposureModes(jd.Struct):
    """auto: bit 0. All automatic.
    manual: bit 1. Nothing automatic.
    shutter_priority: bit 2. Time set, aperture automatic.
    aperture_priority: bit 3. Aperture set, time automatic.
    """

    class Auto(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Manual(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class ShutterPriority(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class AperturePriority(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    auto: ExposureModes.Auto | int = jd.bits(0, 0x1, lambda: jd.Values(ExposureModes.Auto))
    manual: ExposureModes.Manual | int = jd.bits(1, 0x1, lambda: jd.Values(ExposureModes.Manual))
    shutter_priority: ExposureModes.ShutterPriority | int = jd.bits(2, 0x1, lambda: jd.Values(ExposureModes.ShutterPriority))
    aperture_priority: ExposureModes.AperturePriority | int = jd.bits(3, 0x1, lambda: jd.Values(ExposureModes.AperturePriority))
    reserved_bits: int = 0


@jd.bit_field("B")
class MeteringModes(jd.Struct):
    """matrix_or_auto: bit 0. Over all of the image.
    center_weighted: bit 1. Mostly in the middle.
    spot: bit 2. In one point.
    """

    class MatrixOrAuto(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class CenterWeighted(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Spot(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    matrix_or_auto: MeteringModes.MatrixOrAuto | int = jd.bits(0, 0x1, lambda: jd.Values(MeteringModes.MatrixOrAuto))
    center_weighted: MeteringModes.CenterWeighted | int = jd.bits(1, 0x1, lambda: jd.Values(MeteringModes.CenterWeighted))
    spot: MeteringModes.Spot | int = jd.bits(2, 0x1, lambda: jd.Values(MeteringModes.Spot))
    reserved_bits: int = 0


@jd.bit_field("B")
class LightSensitivityLevels(jd.Struct):
    """auto: bit 0. Found automatically.
    iso100: bit 1. ISO 100.
    iso200: bit 2. ISO 200.
    iso400: bit 3. ISO 400.
    iso800: bit 4. ISO 800.
    iso1600: bit 5. ISO 1600.
    iso3200: bit 6. ISO 3200.
    """

    class Auto(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class ISO100(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class ISO200(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class ISO400(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class ISO800(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class ISO1600(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class ISO3200(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    auto: LightSensitivityLevels.Auto | int = jd.bits(0, 0x1, lambda: jd.Values(LightSensitivityLevels.Auto))
    iso100: LightSensitivityLevels.ISO100 | int = jd.bits(1, 0x1, lambda: jd.Values(LightSensitivityLevels.ISO100))
    iso200: LightSensitivityLevels.ISO200 | int = jd.bits(2, 0x1, lambda: jd.Values(LightSensitivityLevels.ISO200))
    iso400: LightSensitivityLevels.ISO400 | int = jd.bits(3, 0x1, lambda: jd.Values(LightSensitivityLevels.ISO400))
    iso800: LightSensitivityLevels.ISO800 | int = jd.bits(4, 0x1, lambda: jd.Values(LightSensitivityLevels.ISO800))
    iso1600: LightSensitivityLevels.ISO1600 | int = jd.bits(5, 0x1, lambda: jd.Values(LightSensitivityLevels.ISO1600))
    iso3200: LightSensitivityLevels.ISO3200 | int = jd.bits(6, 0x1, lambda: jd.Values(LightSensitivityLevels.ISO3200))
    reserved_bits: int = 0


@jd.record()
class SensorIDQueryRec(jd.Struct):
    """sensor_id: SensorID or 1..65535. Which sensor is meant; 0 is all"""

    class SensorID(IntEnum):
        ALL_SENSORS = 0

    sensor_id: SensorIDQueryRec.SensorID | int = jd.field("SensorID", lambda: jd.Number("H", jd.Values(SensorIDQueryRec.SensorID, ((1, 65535),))))


@jd.record()
class SensorIdRec(jd.Struct):
    """sensor_id: 1..65535. Identifies the sensor"""
    sensor_id: int = jd.field("SensorID", jd.Number("H", jd.Values(None, ((1, 65535),))))


@jd.record()
class RangeSensorErrorRec(jd.Struct):
    """sensor_id: 1..65535. Identifies the sensor
    range_sensor_error_code: RangeSensorErrorCode. What was wrong
    error_message: up to 255 characters. An explanation for people
    """

    class RangeSensorErrorCode(IntEnum):
        UNKNOWN_SENSOR_ID = 0
        INVALID_HORIZONTAL_FOV = 1
        INVALID_VERTICAL_FOV = 2
        INVALID_UPDATE_RATE = 3
        INVALID_SENSOR_RANGE = 4
        INVALID_SENSOR_STATE = 5
        MULTIPLE_INVALID_PARAMETERS = 6
        UNKNOWN_ERROR = 255

    sensor_id: int = jd.field("SensorID", jd.Number("H", jd.Values(None, ((1, 65535),))))
    range_sensor_error_code: RangeSensorErrorRec.RangeSensorErrorCode | int = jd.field("RangeSensorErrorCode", lambda: jd.Number("B", jd.Values(RangeSensorErrorRec.RangeSensorErrorCode)))
    error_message: str = jd.field("ErrorMessage", jd.Text(count=jd.Count("B", 0, 255)))


@jd.record()
class VisualSensorErrorRec(jd.Struct):
    """sensor_id: 1..65535. Identifies the sensor
    visual_sensor_error_code: VisualSensorErrorCode. What was wrong
    error_message: up to 255 characters. An explanation for people
    """

    class VisualSensorErrorCode(IntEnum):
        UNKNOWN_SENSOR_ID = 0
        INVALID_SENSOR_STATE = 1
        INVALID_ZOOM_MODE = 2
        INVALID_ZOOM_VALUE = 3
        INVALID_FOCUS_MODE = 4
        INVALID_FOCUS_VALUE = 5
        INVALID_WHITE_BALANCE = 6
        INVALID_IMAGING_MODE = 7
        INVALID_EXPOSURE_MODE = 8
        INVALID_METERING_MODE = 9
        INVALID_SHUTTER_SPEED = 10
        INVALID_APERTURE_VALUE = 11
        INVALID_LIGHT_SENSITIVITY = 12
        INVALID_IMAGE_STABILIZATION = 13
        INVALID_HORIZONTAL_FOV = 14
        INVALID_VERTICAL_FOV = 15
        MULTIPLE_INVALID_PARAMETERS = 16
        UNKNOWN_ERROR = 255

    sensor_id: int = jd.field("SensorID", jd.Number("H", jd.Values(None, ((1, 65535),))))
    visual_sensor_error_code: VisualSensorErrorRec.VisualSensorErrorCode | int = jd.field("VisualSensorErrorCode", lambda: jd.Number("B", jd.Values(VisualSensorErrorRec.VisualSensorErrorCode)))
    error_message: str = jd.field("ErrorMessage", jd.Text(count=jd.Count("B", 0, 255)))


@jd.record()
class DigitalVideoSensorErrorRec(jd.Struct):
    """sensor_id: 1..65535. Identifies the sensor
    digital_video_error_code: DigitalVideoErrorCode. What was wrong
    error_message: up to 255 characters. An explanation for people
    """

    class DigitalVideoErrorCode(IntEnum):
        UNKNOWN_SENSOR_ID = 0
        INVALID_MINIMUM_BIT_RATE = 1
        INVALID_MAXIMUM_BIT_RATE = 2
        FRAME_RATE_TOO_LOW = 3
        FRAME_RATE_TOO_HIGH = 4
        INVALID_FRAME_SIZE = 5
        INVALID_FORMAT = 6
        MULTIPLE_INVALID_PARAMETERS = 7
        UNKNOWN_ERROR = 255

    sensor_id: int = jd.field("SensorID", jd.Number("H", jd.Values(None, ((1, 65535),))))
    digital_video_error_code: DigitalVideoSensorErrorRec.DigitalVideoErrorCode | int = jd.field("DigitalVideoErrorCode", lambda: jd.Number("B", jd.Values(DigitalVideoSensorErrorRec.DigitalVideoErrorCode)))
    error_message: str = jd.field("ErrorMessage", jd.Text(count=jd.Count("B", 0, 255)))


@jd.record()
class AnalogVideoSensorErrorRec(jd.Struct):
    """sensor_id: 1..65535. Identifies the sensor
    analog_video_error_code: AnalogVideoErrorCode. What was wrong
    error_message: up to 255 characters. An explanation for people
    """

    class AnalogVideoErrorCode(IntEnum):
        UNKNOWN_SENSOR_ID = 0
        INVALID_FORMAT = 1
        UNKNOWN_ERROR = 255

    sensor_id: int = jd.field("SensorID", jd.Number("H", jd.Values(None, ((1, 65535),))))
    analog_video_error_code: AnalogVideoSensorErrorRec.AnalogVideoErrorCode | int = jd.field("AnalogVideoErrorCode", lambda: jd.Number("B", jd.Values(AnalogVideoSensorErrorRec.AnalogVideoErrorCode)))
    error_message: str = jd.field("ErrorMessage", jd.Text(count=jd.Count("B", 0, 255)))


@jd.record()
class StillImageSensorErrorRec(jd.Struct):
    """sensor_id: 1..65535. Identifies the sensor
    still_image_error_code: StillImageErrorCode. What was wrong
    error_message: up to 255 characters. An explanation for people
    """

    class StillImageErrorCode(IntEnum):
        UNKNOWN_SENSOR_ID = 0
        INVALID_FRAME_SIZE = 1
        INVALID_FORMAT = 2
        MULTIPLE_INVALID_PARAMETERS = 3
        UNKNOWN_ERROR = 255

    sensor_id: int = jd.field("SensorID", jd.Number("H", jd.Values(None, ((1, 65535),))))
    still_image_error_code: StillImageSensorErrorRec.StillImageErrorCode | int = jd.field("StillImageErrorCode", lambda: jd.Number("B", jd.Values(StillImageSensorErrorRec.StillImageErrorCode)))
    error_message: str = jd.field("ErrorMessage", jd.Text(count=jd.Count("B", 0, 255)))


@jd.record()
class H264VideoEncodingErrorRec(jd.Struct):
    """sensor_id: 1..65535. Identifies the sensor
    h264_video_encoding_error_code: H264VideoEncodingErrorCode. What was wrong
    error_message: up to 255 characters. An explanation for people
    """

    class H264VideoEncodingErrorCode(IntEnum):
        UNKNOWN_SENSOR_ID = 0
        INVALID_PROFILE = 1
        INVALID_PRESET = 2
        INVALID_GROUP_OF_PICTURES = 3
        INVALID_GDR = 4
        INVALID_REGION_OF_INTEREST = 5
        INVALID_INTRA_MACRO_REFRESH = 6
        UNKNOWN_ERROR = 255

    sensor_id: int = jd.field("SensorID", jd.Number("H", jd.Values(None, ((1, 65535),))))
    h264_video_encoding_error_code: H264VideoEncodingErrorRec.H264VideoEncodingErrorCode | int = jd.field("H264VideoEncodingErrorCode", lambda: jd.Number("B", jd.Values(H264VideoEncodingErrorRec.H264VideoEncodingErrorCode)))
    error_message: str = jd.field("ErrorMessage", jd.Text(count=jd.Count("B", 0, 255)))


@jd.record()
class DigitalAudioSensorErrorRec(jd.Struct):
    """sensor_id: 1..65535. Identifies the sensor
    digital_audio_sensor_error_code: DigitalAudioSensorErrorCode. What was wrong
    error_message: up to 255 characters. An explanation for people
    """

    class DigitalAudioSensorErrorCode(IntEnum):
        UNKNOWN_SENSOR_ID = 0
        INVALID_BIT_RATE = 1
        INVALID_FORMAT = 2
        INVALID_SAMPLE_RATE = 3
        INVALID_BIT_DEPTH = 4
        INVALID_ENCODING_QUALITY = 5
        UNKNOWN_ERROR = 255

    sensor_id: int = jd.field("SensorID", jd.Number("H", jd.Values(None, ((1, 65535),))))
    digital_audio_sensor_error_code: DigitalAudioSensorErrorRec.DigitalAudioSensorErrorCode | int = jd.field("DigitalAudioSensorErrorCode", lambda: jd.Number("B", jd.Values(DigitalAudioSensorErrorRec.DigitalAudioSensorErrorCode)))
    error_message: str = jd.field("ErrorMessage", jd.Text(count=jd.Count("B", 0, 255)))


@jd.record()
class DigitalAudioOutputErrorRec(jd.Struct):
    """sensor_id: 1..65535. Identifies the sensor
    digital_audio_output_error_code: DigitalAudioOutputErrorCode. What was wrong
    error_message: up to 255 characters. An explanation for people
    """

    class DigitalAudioOutputErrorCode(IntEnum):
        UNKNOWN_SENSOR_ID = 0
        STREAM_NOT_FOUND = 1
        STREAM_NOT_SUPPORTED = 2
        UNKNOWN_ERROR = 255

    sensor_id: int = jd.field("SensorID", jd.Number("H", jd.Values(None, ((1, 65535),))))
    digital_audio_output_error_code: DigitalAudioOutputErrorRec.DigitalAudioOutputErrorCode | int = jd.field("DigitalAudioOutputErrorCode", lambda: jd.Number("B", jd.Values(DigitalAudioOutputErrorRec.DigitalAudioOutputErrorCode)))
    error_message: str = jd.field("ErrorMessage", jd.Text(count=jd.Count("B", 0, 255)))


@jd.record()
class VideoIlluminatorErrorRec(jd.Struct):
    """illuminator_id: Identifies the lamp
    video_illuminator_error_rec_code: VideoIlluminatorErrorRecCode. What was wrong
    error_message: up to 255 characters. An explanation for people
    """

    class VideoIlluminatorErrorRecCode(IntEnum):
        UNKNOWN_SENSOR_ID = 0
        UNSUPPORTED_MODE = 1
        UNSUPPORTED_BEAM_WIDTH = 2
        UNSUPPORTED_BEAM_HEIGHT = 3
        UNKNOWN_ERROR = 255

    illuminator_id: int = jd.field("IlluminatorID", jd.Number("H"))
    video_illuminator_error_rec_code: VideoIlluminatorErrorRec.VideoIlluminatorErrorRecCode | int = jd.field("VideoIlluminatorErrorRecCode", lambda: jd.Number("B", jd.Values(VideoIlluminatorErrorRec.VideoIlluminatorErrorRecCode)))
    error_message: str = jd.field("ErrorMessage", jd.Text(count=jd.Count("B", 0, 255)))


@jd.bit_field("I")
class SupportedAudioFormats(jd.Struct):
    """lpcm_pcm: bit 0. Linear PCM.
    aiff: bit 1. AIFF.
    wav: bit 2. WAV.
    alac: bit 3. Apple Lossless; 0 means that it is supported.
    flac: bit 4. FLAC.
    real_audio: bit 5. RealAudio.
    wma9_lossless: bit 6. Windows Media Audio 9 Lossless.
    true_audio: bit 7. True Audio.
    dolby_digital: bit 8. Dolby Digital.
    dts: bit 9. DTS.
    mp2: bit 10. MPEG audio layer II.
    mp3: bit 11. MPEG audio layer III.
    aac_mpeg2: bit 12. AAC as in MPEG-2.
    aac_mpeg4: bit 13. AAC as in MPEG-4.
    vorbis: bit 14. Vorbis.
    wma: bit 15. Windows Media Audio.
    speex: bit 16. Speex.
    """

    class LPCM_PCM(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class AIFF(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class WAV(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class ALAC(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class FLAC(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class RealAudio(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class WMA9_Lossless(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class TrueAudio(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class DolbyDigital(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class DTS(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class MP2(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class MP3(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class AAC_MPEG2(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class AAC_MPEG4(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class VORBIS(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class WMA(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Speex(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    lpcm_pcm: SupportedAudioFormats.LPCM_PCM | int = jd.bits(0, 0x1, lambda: jd.Values(SupportedAudioFormats.LPCM_PCM))
    aiff: SupportedAudioFormats.AIFF | int = jd.bits(1, 0x1, lambda: jd.Values(SupportedAudioFormats.AIFF))
    wav: SupportedAudioFormats.WAV | int = jd.bits(2, 0x1, lambda: jd.Values(SupportedAudioFormats.WAV))
    alac: SupportedAudioFormats.ALAC | int = jd.bits(3, 0x1, lambda: jd.Values(SupportedAudioFormats.ALAC))
    flac: SupportedAudioFormats.FLAC | int = jd.bits(4, 0x1, lambda: jd.Values(SupportedAudioFormats.FLAC))
    real_audio: SupportedAudioFormats.RealAudio | int = jd.bits(5, 0x1, lambda: jd.Values(SupportedAudioFormats.RealAudio))
    wma9_lossless: SupportedAudioFormats.WMA9_Lossless | int = jd.bits(6, 0x1, lambda: jd.Values(SupportedAudioFormats.WMA9_Lossless))
    true_audio: SupportedAudioFormats.TrueAudio | int = jd.bits(7, 0x1, lambda: jd.Values(SupportedAudioFormats.TrueAudio))
    dolby_digital: SupportedAudioFormats.DolbyDigital | int = jd.bits(8, 0x1, lambda: jd.Values(SupportedAudioFormats.DolbyDigital))
    dts: SupportedAudioFormats.DTS | int = jd.bits(9, 0x1, lambda: jd.Values(SupportedAudioFormats.DTS))
    mp2: SupportedAudioFormats.MP2 | int = jd.bits(10, 0x1, lambda: jd.Values(SupportedAudioFormats.MP2))
    mp3: SupportedAudioFormats.MP3 | int = jd.bits(11, 0x1, lambda: jd.Values(SupportedAudioFormats.MP3))
    aac_mpeg2: SupportedAudioFormats.AAC_MPEG2 | int = jd.bits(12, 0x1, lambda: jd.Values(SupportedAudioFormats.AAC_MPEG2))
    aac_mpeg4: SupportedAudioFormats.AAC_MPEG4 | int = jd.bits(13, 0x1, lambda: jd.Values(SupportedAudioFormats.AAC_MPEG4))
    vorbis: SupportedAudioFormats.VORBIS | int = jd.bits(14, 0x1, lambda: jd.Values(SupportedAudioFormats.VORBIS))
    wma: SupportedAudioFormats.WMA | int = jd.bits(15, 0x1, lambda: jd.Values(SupportedAudioFormats.WMA))
    speex: SupportedAudioFormats.Speex | int = jd.bits(16, 0x1, lambda: jd.Values(SupportedAudioFormats.Speex))
    reserved_bits: int = 0


@jd.bit_field("H")
class SupportedBitDepths(jd.Struct):
    """eight_bits: bit 0. 8 bits.
    ten_bits: bit 1. 10 bits.
    twelve_bits: bit 2. 12 bits.
    fourteen_bits: bit 3. 14 bits.
    sixteen_bits: bit 4. 16 bits.
    twenty_bits: bit 5. 20 bits.
    twenty_four_bits: bit 6. 24 bits.
    thirty_two_bits: bit 7. 32 bits.
    """

    class EIGHT_BITS(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class TEN_BITS(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class TWELVE_BITS(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class FOURTEEN_BITS(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class SIXTEEN_BITS(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class TWENTY_BITS(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class TWENTY_FOUR_BITS(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class THIRTY_TWO_BITS(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    eight_bits: SupportedBitDepths.EIGHT_BITS | int = jd.bits(0, 0x1, lambda: jd.Values(SupportedBitDepths.EIGHT_BITS))
    ten_bits: SupportedBitDepths.TEN_BITS | int = jd.bits(1, 0x1, lambda: jd.Values(SupportedBitDepths.TEN_BITS))
    twelve_bits: SupportedBitDepths.TWELVE_BITS | int = jd.bits(2, 0x1, lambda: jd.Values(SupportedBitDepths.TWELVE_BITS))
    fourteen_bits: SupportedBitDepths.FOURTEEN_BITS | int = jd.bits(3, 0x1, lambda: jd.Values(SupportedBitDepths.FOURTEEN_BITS))
    sixteen_bits: SupportedBitDepths.SIXTEEN_BITS | int = jd.bits(4, 0x1, lambda: jd.Values(SupportedBitDepths.SIXTEEN_BITS))
    twenty_bits: SupportedBitDepths.TWENTY_BITS | int = jd.bits(5, 0x1, lambda: jd.Values(SupportedBitDepths.TWENTY_BITS))
    twenty_four_bits: SupportedBitDepths.TWENTY_FOUR_BITS | int = jd.bits(6, 0x1, lambda: jd.Values(SupportedBitDepths.TWENTY_FOUR_BITS))
    thirty_two_bits: SupportedBitDepths.THIRTY_TWO_BITS | int = jd.bits(7, 0x1, lambda: jd.Values(SupportedBitDepths.THIRTY_TWO_BITS))
    reserved_bits: int = 0


@jd.bit_field("I")
class JAUS_ID(jd.Struct):
    """component_id: bits 0..7. Component number.
    node_id: bits 8..15. Node number.
    subsystem_id: bits 16..31. Subsystem number.
    """
    component_id: int = jd.bits(0, 0xFF, jd.Values(None, ((0, 255),)))
    node_id: int = jd.bits(8, 0xFF, jd.Values(None, ((0, 255),)))
    subsystem_id: int = jd.bits(16, 0xFFFF, jd.Values(None, ((0, 65535),)))
