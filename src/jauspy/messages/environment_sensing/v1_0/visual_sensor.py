"""urn:jaus:jss:environmentSensing:VisualSensor 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.environment_sensing.v1_0 import range_sensor as environment_sensing_v1_0_range_sensor
from jauspy.messages.environment_sensing.v1_0 import types as environment_sensing_v1_0_types


class QuerySensorGeometricProperties(environment_sensing_v1_0_range_sensor.QuerySensorGeometricProperties):
    """QuerySensorGeometricProperties (0x2805): Asks where sensors are mounted."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:environmentSensing:VisualSensor"
    VERSION = "1.0"
    REPORT: ClassVar[type[ReportSensorGeometricProperties]]


@dataclass(slots=True, repr=False)
class QueryVisualSensorConfiguration(rt.Message):
    """QueryVisualSensorConfiguration (0x2807): Asks for the configuration of cameras.

    query_visual_sensor_configuration_list: 0..65535 items. The cameras
    """

    CODE = 0x2807
    NAME = "QueryVisualSensorConfiguration"
    SERVICE = "urn:jaus:jss:environmentSensing:VisualSensor"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportVisualSensorConfiguration]]

    @dataclass(slots=True, repr=False)
    class QueryVisualSensorConfigurationRec(rt.Struct):
        """QueryVisualSensorConfigurationRec.

        sensor_id: Which sensor is meant; 0 is all
        query_presence_vector: Optional fields wanted of this sensor: bit i asks for the i-th of them, from 0
        """

        sensor_id: int
        query_presence_vector: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("SensorID", rt.Number("H")),
                ("QueryPresenceVector", rt.Number("H")),
            )

    query_visual_sensor_configuration_list: list[QueryVisualSensorConfiguration.QueryVisualSensorConfigurationRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("QueryVisualSensorConfigurationList", rt.Repeat(rt.Count("H", 0, 65535), QueryVisualSensorConfiguration.QueryVisualSensorConfigurationRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x07 or data[1] != 0x28: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (query_visual_sensor_configuration_list_count_,) = _S_H.unpack_from(data, 2)
        query_visual_sensor_configuration_list_end_ = 4 + query_visual_sensor_configuration_list_count_ * 4
        self.query_visual_sensor_configuration_list = [QueryVisualSensorConfiguration.QueryVisualSensorConfigurationRec(sensor_id_, query_presence_vector_) for sensor_id_, query_presence_vector_ in _S_2H.iter_unpack(data[4:query_visual_sensor_configuration_list_end_])]
        if query_visual_sensor_configuration_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x07\x28")
        query_visual_sensor_configuration_list_ = self.query_visual_sensor_configuration_list
        if type(query_visual_sensor_configuration_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(query_visual_sensor_configuration_list_))
        raw_: list[int | float] = []
        for item_ in query_visual_sensor_configuration_list_:
            if type(item_) is not QueryVisualSensorConfiguration.QueryVisualSensorConfigurationRec: raise rt.Reject
            raw_ += (item_.sensor_id, item_.query_presence_vector)
        out += _L_H[len(raw_)].pack(*raw_)
        return bytes(out)


@dataclass(slots=True, repr=False)
class QueryVisualSensorCapabilities(rt.Message):
    """QueryVisualSensorCapabilities (0x2806): Asks what cameras can do.

    query_visual_sensor_capabilities_list: 0..65535 items. The cameras
    """

    CODE = 0x2806
    NAME = "QueryVisualSensorCapabilities"
    SERVICE = "urn:jaus:jss:environmentSensing:VisualSensor"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportVisualSensorCapabilities]]

    @dataclass(slots=True, repr=False)
    class QueryVisualSensorCapabilitiesRec(rt.Struct):
        """QueryVisualSensorCapabilitiesRec.

        sensor_id: Which sensor is meant; 0 is all
        query_presence_vector: Optional fields wanted of this sensor: bit i asks for the i-th of them, from 0
        """

        sensor_id: int
        query_presence_vector: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("SensorID", rt.Number("H")),
                ("QueryPresenceVector", rt.Number("H")),
            )

    query_visual_sensor_capabilities_list: list[QueryVisualSensorCapabilities.QueryVisualSensorCapabilitiesRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("QueryVisualSensorCapabilitiesList", rt.Repeat(rt.Count("H", 0, 65535), QueryVisualSensorCapabilities.QueryVisualSensorCapabilitiesRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x06 or data[1] != 0x28: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (query_visual_sensor_capabilities_list_count_,) = _S_H.unpack_from(data, 2)
        query_visual_sensor_capabilities_list_end_ = 4 + query_visual_sensor_capabilities_list_count_ * 4
        self.query_visual_sensor_capabilities_list = [QueryVisualSensorCapabilities.QueryVisualSensorCapabilitiesRec(sensor_id_, query_presence_vector_) for sensor_id_, query_presence_vector_ in _S_2H.iter_unpack(data[4:query_visual_sensor_capabilities_list_end_])]
        if query_visual_sensor_capabilities_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x06\x28")
        query_visual_sensor_capabilities_list_ = self.query_visual_sensor_capabilities_list
        if type(query_visual_sensor_capabilities_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(query_visual_sensor_capabilities_list_))
        raw_: list[int | float] = []
        for item_ in query_visual_sensor_capabilities_list_:
            if type(item_) is not QueryVisualSensorCapabilities.QueryVisualSensorCapabilitiesRec: raise rt.Reject
            raw_ += (item_.sensor_id, item_.query_presence_vector)
        out += _L_H[len(raw_)].pack(*raw_)
        return bytes(out)


@dataclass(slots=True, repr=False)
class SetVisualSensorConfiguration(rt.Message):
    """SetVisualSensorConfiguration (0x0803): Sets the configuration of cameras.

    visual_sensor_configuration_list: 0..65535 items. The cameras
    """

    CODE = 0x0803
    NAME = "SetVisualSensorConfiguration"
    SERVICE = "urn:jaus:jss:environmentSensing:VisualSensor"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    @dataclass(slots=True, repr=False)
    class RequestIdRec(rt.Struct):
        """RequestIdRec.

        request_id: Repeated in the answer, to match it with its request
        """

        request_id: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("RequestID", rt.Number("B")),
            )

    class SensorState(IntEnum):
        """Values of SensorState."""

        ACTIVE = 0
        STANDBY = 1
        OFF = 2

    class ZoomMode(IntEnum):
        """Values of ZoomMode."""

        MIXED = 0
        ANALOG_ONLY = 1
        DIGITAL_ONLY = 2
        OFF = 3

    class FocusMode(IntEnum):
        """Values of FocusMode."""

        AUTO_FOCUS = 0
        MANUAL_FOCUS = 1

    class WhiteBalance(IntEnum):
        """Values of WhiteBalance."""

        AUTO = 0
        DAYLIGHT = 1
        CLOUDY = 2
        SHADE = 3
        TUNGSTEN = 4
        FLUORESCENT = 5
        FLASH = 6

    class ImagingMode(IntEnum):
        """Values of ImagingMode."""

        COLOR = 0
        GREYSCALE = 1
        INFRARED = 2
        LOW_LIGHT = 3

    class ExposureMode(IntEnum):
        """Values of ExposureMode."""

        AUTO = 0
        MANUAL = 1
        SHUTTER_PRIORITY = 2
        APERTURE_PRIORITY = 3

    class MeteringMode(IntEnum):
        """Values of MeteringMode."""

        AUTO = 0
        CENTER_WEIGHTED = 1
        SPOT = 2

    class LightSensitivity(IntEnum):
        """Values of LightSensitivity."""

        AUTO = 0
        ISO_100 = 1
        ISO_200 = 2
        ISO_400 = 3
        ISO_800 = 4
        ISO_1600 = 5
        ISO_3200 = 6

    class ImageStablization(IntEnum):
        """Values of ImageStablization."""

        OFF = 0
        ON = 1

    @dataclass(slots=True, repr=False)
    class VisualSensorConfigurationRec(rt.Struct):
        """Settings of one camera.

        sensor_id: Identifies the sensor
        sensor_state: SensorState, optional. Whether the sensor works
        zoom_mode: ZoomMode, optional. Whether lens, computation or both zoom
        zoom_level: 0..100, optional. Zoom, in percent from widest to narrowest
        focal_length: 0..2 meter, optional. Focal length, in metres
        horizontal_field_of_view: -3.14159265359..3.14159265359 radian, optional. Field of view from left to right, in radians
        vertical_field_of_view: -3.14159265359..3.14159265359 radian, optional. Field of view from top to bottom, in radians
        focus_mode: FocusMode, optional. Who focuses
        focus_value: 0..100, optional. Focus, in percent from nearest to farthest
        white_balance: WhiteBalance, optional. Kind of light that is taken for white
        imaging_mode: ImagingMode, optional. Kind of image
        exposure_mode: ExposureMode, optional. What of the exposure is automatic
        metering_mode: MeteringMode, optional. Part of the image that the exposure is measured in
        shutter_speed: 0..60 second, optional. Exposure time, in seconds
        aperture: 0.1..128, optional. Aperture as an f-number
        light_sensitivity: LightSensitivity, optional. Sensitivity as on the ISO scale
        image_stablization: ImageStablization, optional. Whether the image is steadied
        """

        sensor_id: int
        sensor_state: SetVisualSensorConfiguration.SensorState | int | None = None
        zoom_mode: SetVisualSensorConfiguration.ZoomMode | int | None = None
        zoom_level: float | None = None
        focal_length: float | None = None
        horizontal_field_of_view: float | None = None
        vertical_field_of_view: float | None = None
        focus_mode: SetVisualSensorConfiguration.FocusMode | int | None = None
        focus_value: float | None = None
        white_balance: SetVisualSensorConfiguration.WhiteBalance | int | None = None
        imaging_mode: SetVisualSensorConfiguration.ImagingMode | int | None = None
        exposure_mode: SetVisualSensorConfiguration.ExposureMode | int | None = None
        metering_mode: SetVisualSensorConfiguration.MeteringMode | int | None = None
        shutter_speed: float | None = None
        aperture: float | None = None
        light_sensitivity: SetVisualSensorConfiguration.LightSensitivity | int | None = None
        image_stablization: SetVisualSensorConfiguration.ImageStablization | int | None = None

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "H",
                ("SensorID", rt.Number("H")),
                ("SensorState", rt.Number("B", rt.Values(SetVisualSensorConfiguration.SensorState)), True),
                ("ZoomMode", rt.Number("B", rt.Values(SetVisualSensorConfiguration.ZoomMode)), True),
                ("ZoomLevel", rt.real("H", 0.0, 100.0), True),
                ("FocalLength", rt.real("I", 0.0, 2.0, "meter"), True),
                ("HorizontalFieldOfView", rt.real("I", -3.141592653589793, 3.141592653589793, "radian"), True),
                ("VerticalFieldOfView", rt.real("I", -3.141592653589793, 3.141592653589793, "radian"), True),
                ("FocusMode", rt.Number("B", rt.Values(SetVisualSensorConfiguration.FocusMode)), True),
                ("FocusValue", rt.real("H", 0.0, 100.0), True),
                ("WhiteBalance", rt.Number("B", rt.Values(SetVisualSensorConfiguration.WhiteBalance)), True),
                ("ImagingMode", rt.Number("B", rt.Values(SetVisualSensorConfiguration.ImagingMode)), True),
                ("ExposureMode", rt.Number("B", rt.Values(SetVisualSensorConfiguration.ExposureMode)), True),
                ("MeteringMode", rt.Number("B", rt.Values(SetVisualSensorConfiguration.MeteringMode)), True),
                ("ShutterSpeed", rt.real("H", 0.0, 60.0, "second"), True),
                ("Aperture", rt.real("H", 0.1, 128.0), True),
                ("LightSensitivity", rt.Number("B", rt.Values(SetVisualSensorConfiguration.LightSensitivity)), True),
                ("ImageStablization", rt.Number("B", rt.Values(SetVisualSensorConfiguration.ImageStablization)), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            (mask,) = _S_H.unpack_from(data, at)
            packer = _M_SetVisualSensorConfiguration_VisualSensorConfigurationRec_0[mask & 0xFFFF]
            raw = iter(packer.unpack_from(data, at + 2)).__next__
            at = at + 2 + packer.size
            self.sensor_id = raw()
            if mask & 1:
                sensor_state_ = raw()
                self.sensor_state = _E_SetVisualSensorConfiguration_SensorState[sensor_state_]
            else: self.sensor_state = None
            if mask & 2:
                zoom_mode_ = raw()
                self.zoom_mode = _E_SetVisualSensorConfiguration_ZoomMode[zoom_mode_]
            else: self.zoom_mode = None
            self.zoom_level = raw() * 0.0015259021896696422 if mask & 4 else None
            self.focal_length = raw() * 4.656612874161595e-10 if mask & 8 else None
            self.horizontal_field_of_view = -3.141592653589793 + raw() * 1.4629180796077717e-09 if mask & 16 else None
            self.vertical_field_of_view = -3.141592653589793 + raw() * 1.4629180796077717e-09 if mask & 32 else None
            if mask & 64:
                focus_mode_ = raw()
                self.focus_mode = _E_SetVisualSensorConfiguration_FocusMode[focus_mode_]
            else: self.focus_mode = None
            self.focus_value = raw() * 0.0015259021896696422 if mask & 128 else None
            if mask & 256:
                white_balance_ = raw()
                self.white_balance = _E_SetVisualSensorConfiguration_WhiteBalance[white_balance_]
            else: self.white_balance = None
            if mask & 512:
                imaging_mode_ = raw()
                self.imaging_mode = _E_SetVisualSensorConfiguration_ImagingMode[imaging_mode_]
            else: self.imaging_mode = None
            if mask & 1024:
                exposure_mode_ = raw()
                self.exposure_mode = _E_SetVisualSensorConfiguration_ExposureMode[exposure_mode_]
            else: self.exposure_mode = None
            if mask & 2048:
                metering_mode_ = raw()
                self.metering_mode = _E_SetVisualSensorConfiguration_MeteringMode[metering_mode_]
            else: self.metering_mode = None
            self.shutter_speed = raw() * 0.0009155413138017853 if mask & 4096 else None
            self.aperture = 0.1 + raw() * 0.0019516289005874724 if mask & 8192 else None
            if mask & 16384:
                light_sensitivity_ = raw()
                self.light_sensitivity = _E_SetVisualSensorConfiguration_LightSensitivity[light_sensitivity_]
            else: self.light_sensitivity = None
            if mask & 32768:
                image_stablization_ = raw()
                self.image_stablization = _E_SetVisualSensorConfiguration_ImageStablization[image_stablization_]
            else: self.image_stablization = None
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0\0"
            mask = 0
            raw: list[int | float | bytes] = []
            raw.append(self.sensor_id)
            sensor_state_ = self.sensor_state
            if sensor_state_ is not None:
                mask |= 1
                if sensor_state_ not in _E_SetVisualSensorConfiguration_SensorState: raise rt.Reject
                raw.append(sensor_state_)
            zoom_mode_ = self.zoom_mode
            if zoom_mode_ is not None:
                mask |= 2
                if zoom_mode_ not in _E_SetVisualSensorConfiguration_ZoomMode: raise rt.Reject
                raw.append(zoom_mode_)
            zoom_level_ = self.zoom_level
            if zoom_level_ is not None:
                mask |= 4
                if not 0.0 <= zoom_level_ <= 100.0: raise rt.Reject
                near = zoom_level_ * 655.35 + 0.5
                zoom_level_raw_ = int(near)
                if not 1.52587890625e-05 < near - zoom_level_raw_ < 0.9999847412109375: zoom_level_raw_ = rt.exact_raw(zoom_level_, _R_13)
                raw.append(zoom_level_raw_)
            focal_length_ = self.focal_length
            if focal_length_ is not None:
                mask |= 8
                if not 0.0 <= focal_length_ <= 2.0: raise rt.Reject
                near = focal_length_ * 2147483647.5 + 0.5
                focal_length_raw_ = int(near)
                if not 1.52587890625e-05 < near - focal_length_raw_ < 0.9999847412109375: focal_length_raw_ = rt.exact_raw(focal_length_, _R_14)
                raw.append(focal_length_raw_)
            horizontal_field_of_view_ = self.horizontal_field_of_view
            if horizontal_field_of_view_ is not None:
                mask |= 16
                if not -3.141592653589793 <= horizontal_field_of_view_ <= 3.141592653589793: raise rt.Reject
                near = horizontal_field_of_view_ * 683565275.4172766 + 2147483647.9999998
                horizontal_field_of_view_raw_ = int(near)
                if not 1.52587890625e-05 < near - horizontal_field_of_view_raw_ < 0.9999847412109375: horizontal_field_of_view_raw_ = rt.exact_raw(horizontal_field_of_view_, _R_15)
                raw.append(horizontal_field_of_view_raw_)
            vertical_field_of_view_ = self.vertical_field_of_view
            if vertical_field_of_view_ is not None:
                mask |= 32
                if not -3.141592653589793 <= vertical_field_of_view_ <= 3.141592653589793: raise rt.Reject
                near = vertical_field_of_view_ * 683565275.4172766 + 2147483647.9999998
                vertical_field_of_view_raw_ = int(near)
                if not 1.52587890625e-05 < near - vertical_field_of_view_raw_ < 0.9999847412109375: vertical_field_of_view_raw_ = rt.exact_raw(vertical_field_of_view_, _R_15)
                raw.append(vertical_field_of_view_raw_)
            focus_mode_ = self.focus_mode
            if focus_mode_ is not None:
                mask |= 64
                if focus_mode_ not in _E_SetVisualSensorConfiguration_FocusMode: raise rt.Reject
                raw.append(focus_mode_)
            focus_value_ = self.focus_value
            if focus_value_ is not None:
                mask |= 128
                if not 0.0 <= focus_value_ <= 100.0: raise rt.Reject
                near = focus_value_ * 655.35 + 0.5
                focus_value_raw_ = int(near)
                if not 1.52587890625e-05 < near - focus_value_raw_ < 0.9999847412109375: focus_value_raw_ = rt.exact_raw(focus_value_, _R_13)
                raw.append(focus_value_raw_)
            white_balance_ = self.white_balance
            if white_balance_ is not None:
                mask |= 256
                if white_balance_ not in _E_SetVisualSensorConfiguration_WhiteBalance: raise rt.Reject
                raw.append(white_balance_)
            imaging_mode_ = self.imaging_mode
            if imaging_mode_ is not None:
                mask |= 512
                if imaging_mode_ not in _E_SetVisualSensorConfiguration_ImagingMode: raise rt.Reject
                raw.append(imaging_mode_)
            exposure_mode_ = self.exposure_mode
            if exposure_mode_ is not None:
                mask |= 1024
                if exposure_mode_ not in _E_SetVisualSensorConfiguration_ExposureMode: raise rt.Reject
                raw.append(exposure_mode_)
            metering_mode_ = self.metering_mode
            if metering_mode_ is not None:
                mask |= 2048
                if metering_mode_ not in _E_SetVisualSensorConfiguration_MeteringMode: raise rt.Reject
                raw.append(metering_mode_)
            shutter_speed_ = self.shutter_speed
            if shutter_speed_ is not None:
                mask |= 4096
                if not 0.0 <= shutter_speed_ <= 60.0: raise rt.Reject
                near = shutter_speed_ * 1092.25 + 0.5
                shutter_speed_raw_ = int(near)
                if not 1.52587890625e-05 < near - shutter_speed_raw_ < 0.9999847412109375: shutter_speed_raw_ = rt.exact_raw(shutter_speed_, _R_16)
                raw.append(shutter_speed_raw_)
            aperture_ = self.aperture
            if aperture_ is not None:
                mask |= 8192
                if not 0.1 <= aperture_ <= 128.0: raise rt.Reject
                near = aperture_ * 512.3924941360438 + -50.73924941360438
                aperture_raw_ = int(near)
                if not 1.52587890625e-05 < near - aperture_raw_ < 0.9999847412109375: aperture_raw_ = rt.exact_raw(aperture_, _R_17)
                raw.append(aperture_raw_)
            light_sensitivity_ = self.light_sensitivity
            if light_sensitivity_ is not None:
                mask |= 16384
                if light_sensitivity_ not in _E_SetVisualSensorConfiguration_LightSensitivity: raise rt.Reject
                raw.append(light_sensitivity_)
            image_stablization_ = self.image_stablization
            if image_stablization_ is not None:
                mask |= 32768
                if image_stablization_ not in _E_SetVisualSensorConfiguration_ImageStablization: raise rt.Reject
                raw.append(image_stablization_)
            out += _M_SetVisualSensorConfiguration_VisualSensorConfigurationRec_0[mask & 0xFFFF].pack(*raw)
            _S_H.pack_into(out, start, mask)

    request_id_rec: SetVisualSensorConfiguration.RequestIdRec
    visual_sensor_configuration_list: list[SetVisualSensorConfiguration.VisualSensorConfigurationRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("RequestIdRec", SetVisualSensorConfiguration.RequestIdRec.layout()),
            ("VisualSensorConfigurationList", rt.Repeat(rt.Count("H", 0, 65535), SetVisualSensorConfiguration.VisualSensorConfigurationRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x03 or data[1] != 0x08: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        request_id_ = data[2]
        self.request_id_rec = SetVisualSensorConfiguration.RequestIdRec(request_id_)
        (visual_sensor_configuration_list_count_,) = _S_H.unpack_from(data, 3)
        if visual_sensor_configuration_list_count_ * 4 > size - 5: raise rt.Reject
        at = 5
        visual_sensor_configuration_list_ = []
        for _ in range(visual_sensor_configuration_list_count_):
            item_, at = SetVisualSensorConfiguration.VisualSensorConfigurationRec._read(data, at, nesting)
            visual_sensor_configuration_list_.append(item_)
        self.visual_sensor_configuration_list = visual_sensor_configuration_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x03\x08")
        request_id_rec_ = self.request_id_rec
        if type(request_id_rec_) is not SetVisualSensorConfiguration.RequestIdRec: raise rt.Reject
        out.append(request_id_rec_.request_id)
        visual_sensor_configuration_list_ = self.visual_sensor_configuration_list
        if type(visual_sensor_configuration_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(visual_sensor_configuration_list_))
        for item_ in visual_sensor_configuration_list_:
            if type(item_) is not SetVisualSensorConfiguration.VisualSensorConfigurationRec: raise rt.Reject
            item_._write(out)
        return bytes(out)


class ConfirmSensorConfiguration(environment_sensing_v1_0_range_sensor.ConfirmSensorConfiguration):
    """ConfirmSensorConfiguration (0x0801): Tells for each sensor whether its new configuration was taken over, and
    if not, why.
    """

    __slots__ = ()
    SERVICE = "urn:jaus:jss:environmentSensing:VisualSensor"
    VERSION = "1.0"


class ReportSensorGeometricProperties(environment_sensing_v1_0_range_sensor.ReportSensorGeometricProperties):
    """ReportSensorGeometricProperties (0x4805): Tells where sensors are mounted."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:environmentSensing:VisualSensor"
    VERSION = "1.0"


@dataclass(slots=True, repr=False)
class ReportVisualSensorConfiguration(rt.Message):
    """ReportVisualSensorConfiguration (0x4807): Tells the configuration of cameras.

    visual_sensor_configuration_list: 0..65535 items. The cameras
    """

    CODE = 0x4807
    NAME = "ReportVisualSensorConfiguration"
    SERVICE = "urn:jaus:jss:environmentSensing:VisualSensor"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    class SensorState(IntEnum):
        """Values of SensorState."""

        ACTIVE = 0
        STANDBY = 1
        OFF = 2

    class ZoomMode(IntEnum):
        """Values of ZoomMode."""

        MIXED = 0
        ANALOG_ONLY = 1
        DIGITAL_ONLY = 2
        OFF = 3

    class FocusMode(IntEnum):
        """Values of FocusMode."""

        AUTO_FOCUS = 0
        MANUAL_FOCUS = 1

    class WhiteBalance(IntEnum):
        """Values of WhiteBalance."""

        AUTO = 0
        DAYLIGHT = 1
        CLOUDY = 2
        SHADE = 3
        TUNGSTEN = 4
        FLUORESCENT = 5
        FLASH = 6

    class ImagingMode(IntEnum):
        """Values of ImagingMode."""

        COLOR = 0
        GREYSCALE = 1
        INFRARED = 2
        LOW_LIGHT = 3

    class ExposureMode(IntEnum):
        """Values of ExposureMode."""

        AUTO = 0
        MANUAL = 1
        SHUTTER_PRIORITY = 2
        APERTURE_PRIORITY = 3

    class MeteringMode(IntEnum):
        """Values of MeteringMode."""

        AUTO = 0
        CENTER_WEIGHTED = 1
        SPOT = 2

    class LightSensitivity(IntEnum):
        """Values of LightSensitivity."""

        AUTO = 0
        ISO_100 = 1
        ISO_200 = 2
        ISO_400 = 3
        ISO_800 = 4
        ISO_1600 = 5
        ISO_3200 = 6

    class ImageStablization(IntEnum):
        """Values of ImageStablization."""

        OFF = 0
        ON = 1

    @dataclass(slots=True, repr=False)
    class VisualSensorConfigurationRec(rt.Struct):
        """Settings of one camera.

        sensor_id: Identifies the sensor
        sensor_state: SensorState, optional. Whether the sensor works
        zoom_mode: ZoomMode, optional. Whether lens, computation or both zoom
        zoom_level: 0..100, optional. Zoom, in percent from widest to narrowest
        focal_length: 0..2 meter, optional. Focal length, in metres
        horizontal_field_of_view: -3.14159265359..3.14159265359 radian, optional. Field of view from left to right, in radians
        vertical_field_of_view: -3.14159265359..3.14159265359 radian, optional. Field of view from top to bottom, in radians
        focus_mode: FocusMode, optional. Who focuses
        focus_value: 0..100, optional. Focus, in percent from nearest to farthest
        white_balance: WhiteBalance, optional. Kind of light that is taken for white
        imaging_mode: ImagingMode, optional. Kind of image
        exposure_mode: ExposureMode, optional. What of the exposure is automatic
        metering_mode: MeteringMode, optional. Part of the image that the exposure is measured in
        shutter_speed: 0..60 second, optional. Exposure time, in seconds
        aperture: 0.1..128, optional. Aperture as an f-number
        light_sensitivity: LightSensitivity, optional. Sensitivity as on the ISO scale
        image_stablization: ImageStablization, optional. Whether the image is steadied
        """

        sensor_id: int
        sensor_state: ReportVisualSensorConfiguration.SensorState | int | None = None
        zoom_mode: ReportVisualSensorConfiguration.ZoomMode | int | None = None
        zoom_level: float | None = None
        focal_length: float | None = None
        horizontal_field_of_view: float | None = None
        vertical_field_of_view: float | None = None
        focus_mode: ReportVisualSensorConfiguration.FocusMode | int | None = None
        focus_value: float | None = None
        white_balance: ReportVisualSensorConfiguration.WhiteBalance | int | None = None
        imaging_mode: ReportVisualSensorConfiguration.ImagingMode | int | None = None
        exposure_mode: ReportVisualSensorConfiguration.ExposureMode | int | None = None
        metering_mode: ReportVisualSensorConfiguration.MeteringMode | int | None = None
        shutter_speed: float | None = None
        aperture: float | None = None
        light_sensitivity: ReportVisualSensorConfiguration.LightSensitivity | int | None = None
        image_stablization: ReportVisualSensorConfiguration.ImageStablization | int | None = None

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "H",
                ("SensorID", rt.Number("H")),
                ("SensorState", rt.Number("B", rt.Values(ReportVisualSensorConfiguration.SensorState)), True),
                ("ZoomMode", rt.Number("B", rt.Values(ReportVisualSensorConfiguration.ZoomMode)), True),
                ("ZoomLevel", rt.real("H", 0.0, 100.0), True),
                ("FocalLength", rt.real("I", 0.0, 2.0, "meter"), True),
                ("HorizontalFieldOfView", rt.real("I", -3.141592653589793, 3.141592653589793, "radian"), True),
                ("VerticalFieldOfView", rt.real("I", -3.141592653589793, 3.141592653589793, "radian"), True),
                ("FocusMode", rt.Number("B", rt.Values(ReportVisualSensorConfiguration.FocusMode)), True),
                ("FocusValue", rt.real("H", 0.0, 100.0), True),
                ("WhiteBalance", rt.Number("B", rt.Values(ReportVisualSensorConfiguration.WhiteBalance)), True),
                ("ImagingMode", rt.Number("B", rt.Values(ReportVisualSensorConfiguration.ImagingMode)), True),
                ("ExposureMode", rt.Number("B", rt.Values(ReportVisualSensorConfiguration.ExposureMode)), True),
                ("MeteringMode", rt.Number("B", rt.Values(ReportVisualSensorConfiguration.MeteringMode)), True),
                ("ShutterSpeed", rt.real("H", 0.0, 60.0, "second"), True),
                ("Aperture", rt.real("H", 0.1, 128.0), True),
                ("LightSensitivity", rt.Number("B", rt.Values(ReportVisualSensorConfiguration.LightSensitivity)), True),
                ("ImageStablization", rt.Number("B", rt.Values(ReportVisualSensorConfiguration.ImageStablization)), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            (mask,) = _S_H.unpack_from(data, at)
            packer = _M_SetVisualSensorConfiguration_VisualSensorConfigurationRec_0[mask & 0xFFFF]
            raw = iter(packer.unpack_from(data, at + 2)).__next__
            at = at + 2 + packer.size
            self.sensor_id = raw()
            if mask & 1:
                sensor_state_ = raw()
                self.sensor_state = _E_ReportVisualSensorConfiguration_SensorState[sensor_state_]
            else: self.sensor_state = None
            if mask & 2:
                zoom_mode_ = raw()
                self.zoom_mode = _E_ReportVisualSensorConfiguration_ZoomMode[zoom_mode_]
            else: self.zoom_mode = None
            self.zoom_level = raw() * 0.0015259021896696422 if mask & 4 else None
            self.focal_length = raw() * 4.656612874161595e-10 if mask & 8 else None
            self.horizontal_field_of_view = -3.141592653589793 + raw() * 1.4629180796077717e-09 if mask & 16 else None
            self.vertical_field_of_view = -3.141592653589793 + raw() * 1.4629180796077717e-09 if mask & 32 else None
            if mask & 64:
                focus_mode_ = raw()
                self.focus_mode = _E_ReportVisualSensorConfiguration_FocusMode[focus_mode_]
            else: self.focus_mode = None
            self.focus_value = raw() * 0.0015259021896696422 if mask & 128 else None
            if mask & 256:
                white_balance_ = raw()
                self.white_balance = _E_ReportVisualSensorConfiguration_WhiteBalance[white_balance_]
            else: self.white_balance = None
            if mask & 512:
                imaging_mode_ = raw()
                self.imaging_mode = _E_ReportVisualSensorConfiguration_ImagingMode[imaging_mode_]
            else: self.imaging_mode = None
            if mask & 1024:
                exposure_mode_ = raw()
                self.exposure_mode = _E_ReportVisualSensorConfiguration_ExposureMode[exposure_mode_]
            else: self.exposure_mode = None
            if mask & 2048:
                metering_mode_ = raw()
                self.metering_mode = _E_ReportVisualSensorConfiguration_MeteringMode[metering_mode_]
            else: self.metering_mode = None
            self.shutter_speed = raw() * 0.0009155413138017853 if mask & 4096 else None
            self.aperture = 0.1 + raw() * 0.0019516289005874724 if mask & 8192 else None
            if mask & 16384:
                light_sensitivity_ = raw()
                self.light_sensitivity = _E_ReportVisualSensorConfiguration_LightSensitivity[light_sensitivity_]
            else: self.light_sensitivity = None
            if mask & 32768:
                image_stablization_ = raw()
                self.image_stablization = _E_ReportVisualSensorConfiguration_ImageStablization[image_stablization_]
            else: self.image_stablization = None
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0\0"
            mask = 0
            raw: list[int | float | bytes] = []
            raw.append(self.sensor_id)
            sensor_state_ = self.sensor_state
            if sensor_state_ is not None:
                mask |= 1
                if sensor_state_ not in _E_ReportVisualSensorConfiguration_SensorState: raise rt.Reject
                raw.append(sensor_state_)
            zoom_mode_ = self.zoom_mode
            if zoom_mode_ is not None:
                mask |= 2
                if zoom_mode_ not in _E_ReportVisualSensorConfiguration_ZoomMode: raise rt.Reject
                raw.append(zoom_mode_)
            zoom_level_ = self.zoom_level
            if zoom_level_ is not None:
                mask |= 4
                if not 0.0 <= zoom_level_ <= 100.0: raise rt.Reject
                near = zoom_level_ * 655.35 + 0.5
                zoom_level_raw_ = int(near)
                if not 1.52587890625e-05 < near - zoom_level_raw_ < 0.9999847412109375: zoom_level_raw_ = rt.exact_raw(zoom_level_, _R_13)
                raw.append(zoom_level_raw_)
            focal_length_ = self.focal_length
            if focal_length_ is not None:
                mask |= 8
                if not 0.0 <= focal_length_ <= 2.0: raise rt.Reject
                near = focal_length_ * 2147483647.5 + 0.5
                focal_length_raw_ = int(near)
                if not 1.52587890625e-05 < near - focal_length_raw_ < 0.9999847412109375: focal_length_raw_ = rt.exact_raw(focal_length_, _R_14)
                raw.append(focal_length_raw_)
            horizontal_field_of_view_ = self.horizontal_field_of_view
            if horizontal_field_of_view_ is not None:
                mask |= 16
                if not -3.141592653589793 <= horizontal_field_of_view_ <= 3.141592653589793: raise rt.Reject
                near = horizontal_field_of_view_ * 683565275.4172766 + 2147483647.9999998
                horizontal_field_of_view_raw_ = int(near)
                if not 1.52587890625e-05 < near - horizontal_field_of_view_raw_ < 0.9999847412109375: horizontal_field_of_view_raw_ = rt.exact_raw(horizontal_field_of_view_, _R_15)
                raw.append(horizontal_field_of_view_raw_)
            vertical_field_of_view_ = self.vertical_field_of_view
            if vertical_field_of_view_ is not None:
                mask |= 32
                if not -3.141592653589793 <= vertical_field_of_view_ <= 3.141592653589793: raise rt.Reject
                near = vertical_field_of_view_ * 683565275.4172766 + 2147483647.9999998
                vertical_field_of_view_raw_ = int(near)
                if not 1.52587890625e-05 < near - vertical_field_of_view_raw_ < 0.9999847412109375: vertical_field_of_view_raw_ = rt.exact_raw(vertical_field_of_view_, _R_15)
                raw.append(vertical_field_of_view_raw_)
            focus_mode_ = self.focus_mode
            if focus_mode_ is not None:
                mask |= 64
                if focus_mode_ not in _E_ReportVisualSensorConfiguration_FocusMode: raise rt.Reject
                raw.append(focus_mode_)
            focus_value_ = self.focus_value
            if focus_value_ is not None:
                mask |= 128
                if not 0.0 <= focus_value_ <= 100.0: raise rt.Reject
                near = focus_value_ * 655.35 + 0.5
                focus_value_raw_ = int(near)
                if not 1.52587890625e-05 < near - focus_value_raw_ < 0.9999847412109375: focus_value_raw_ = rt.exact_raw(focus_value_, _R_13)
                raw.append(focus_value_raw_)
            white_balance_ = self.white_balance
            if white_balance_ is not None:
                mask |= 256
                if white_balance_ not in _E_ReportVisualSensorConfiguration_WhiteBalance: raise rt.Reject
                raw.append(white_balance_)
            imaging_mode_ = self.imaging_mode
            if imaging_mode_ is not None:
                mask |= 512
                if imaging_mode_ not in _E_ReportVisualSensorConfiguration_ImagingMode: raise rt.Reject
                raw.append(imaging_mode_)
            exposure_mode_ = self.exposure_mode
            if exposure_mode_ is not None:
                mask |= 1024
                if exposure_mode_ not in _E_ReportVisualSensorConfiguration_ExposureMode: raise rt.Reject
                raw.append(exposure_mode_)
            metering_mode_ = self.metering_mode
            if metering_mode_ is not None:
                mask |= 2048
                if metering_mode_ not in _E_ReportVisualSensorConfiguration_MeteringMode: raise rt.Reject
                raw.append(metering_mode_)
            shutter_speed_ = self.shutter_speed
            if shutter_speed_ is not None:
                mask |= 4096
                if not 0.0 <= shutter_speed_ <= 60.0: raise rt.Reject
                near = shutter_speed_ * 1092.25 + 0.5
                shutter_speed_raw_ = int(near)
                if not 1.52587890625e-05 < near - shutter_speed_raw_ < 0.9999847412109375: shutter_speed_raw_ = rt.exact_raw(shutter_speed_, _R_16)
                raw.append(shutter_speed_raw_)
            aperture_ = self.aperture
            if aperture_ is not None:
                mask |= 8192
                if not 0.1 <= aperture_ <= 128.0: raise rt.Reject
                near = aperture_ * 512.3924941360438 + -50.73924941360438
                aperture_raw_ = int(near)
                if not 1.52587890625e-05 < near - aperture_raw_ < 0.9999847412109375: aperture_raw_ = rt.exact_raw(aperture_, _R_17)
                raw.append(aperture_raw_)
            light_sensitivity_ = self.light_sensitivity
            if light_sensitivity_ is not None:
                mask |= 16384
                if light_sensitivity_ not in _E_ReportVisualSensorConfiguration_LightSensitivity: raise rt.Reject
                raw.append(light_sensitivity_)
            image_stablization_ = self.image_stablization
            if image_stablization_ is not None:
                mask |= 32768
                if image_stablization_ not in _E_ReportVisualSensorConfiguration_ImageStablization: raise rt.Reject
                raw.append(image_stablization_)
            out += _M_SetVisualSensorConfiguration_VisualSensorConfigurationRec_0[mask & 0xFFFF].pack(*raw)
            _S_H.pack_into(out, start, mask)

    visual_sensor_configuration_list: list[ReportVisualSensorConfiguration.VisualSensorConfigurationRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("VisualSensorConfigurationList", rt.Repeat(rt.Count("H", 0, 65535), ReportVisualSensorConfiguration.VisualSensorConfigurationRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x07 or data[1] != 0x48: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (visual_sensor_configuration_list_count_,) = _S_H.unpack_from(data, 2)
        if visual_sensor_configuration_list_count_ * 4 > size - 4: raise rt.Reject
        at = 4
        visual_sensor_configuration_list_ = []
        for _ in range(visual_sensor_configuration_list_count_):
            item_, at = ReportVisualSensorConfiguration.VisualSensorConfigurationRec._read(data, at, nesting)
            visual_sensor_configuration_list_.append(item_)
        self.visual_sensor_configuration_list = visual_sensor_configuration_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x07\x48")
        visual_sensor_configuration_list_ = self.visual_sensor_configuration_list
        if type(visual_sensor_configuration_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(visual_sensor_configuration_list_))
        for item_ in visual_sensor_configuration_list_:
            if type(item_) is not ReportVisualSensorConfiguration.VisualSensorConfigurationRec: raise rt.Reject
            item_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportVisualSensorCapabilities(rt.Message):
    """ReportVisualSensorCapabilities (0x4806): Tells what cameras can do.

    visual_sensor_capabilities_list: 0..65535 items. The cameras
    """

    CODE = 0x4806
    NAME = "ReportVisualSensorCapabilities"
    SERVICE = "urn:jaus:jss:environmentSensing:VisualSensor"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    SupportedStates = environment_sensing_v1_0_types.SupportedStates
    ZoomModes = environment_sensing_v1_0_types.ZoomModes
    FocusModes = environment_sensing_v1_0_types.FocusModes
    SupportedWhiteBalance = environment_sensing_v1_0_types.SupportedWhiteBalance
    ExposureModes = environment_sensing_v1_0_types.ExposureModes
    MeteringModes = environment_sensing_v1_0_types.MeteringModes
    LightSensitivityLevels = environment_sensing_v1_0_types.LightSensitivityLevels

    class Color(IntEnum):
        """Values of Color."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Greyscale(IntEnum):
        """Values of Greyscale."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Infrared(IntEnum):
        """Values of Infrared."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Lowlight(IntEnum):
        """Values of Lowlight."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    @dataclass(slots=True, repr=False)
    class ImagingModes(rt.Struct):
        """Kinds of image that the camera offers.

        color: bit 0. Colour.
        greyscale: bit 1. Greyscale.
        infrared: bit 2. Infrared.
        lowlight: bit 3. Weak light.
        """

        color: ReportVisualSensorCapabilities.Color | int
        greyscale: ReportVisualSensorCapabilities.Greyscale | int
        infrared: ReportVisualSensorCapabilities.Infrared | int
        lowlight: ReportVisualSensorCapabilities.Lowlight | int
        reserved_bits: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Bits(
                cls,
                "B",
                (
                    rt.Bit("color", 0, 0x1, rt.Values(ReportVisualSensorCapabilities.Color)),
                    rt.Bit("greyscale", 1, 0x1, rt.Values(ReportVisualSensorCapabilities.Greyscale)),
                    rt.Bit("infrared", 2, 0x1, rt.Values(ReportVisualSensorCapabilities.Infrared)),
                    rt.Bit("lowlight", 3, 0x1, rt.Values(ReportVisualSensorCapabilities.Lowlight)),
                ),
            )

    class ImageStabilization(IntEnum):
        """Values of ImageStabilization."""

        FALSE = 0
        TRUE = 1

    @dataclass(slots=True, repr=False)
    class VisualSensorCapabilitiesRec(rt.Struct):
        """VisualSensorCapabilitiesRec.

        sensor_id: Identifies the sensor
        sensor_name: up to 255 characters. Name of the sensor, for people
        supported_states: optional. States that the sensor offers
        zoom_modes: optional. Ways of zooming that the camera offers
        focus_modes: optional. Ways of focusing that the camera offers
        white_balance: optional. Kinds of light that can be taken for white
        imaging_modes: optional. Kinds of image that the camera offers
        exposure_modes: optional. Ways of exposing that the camera offers
        metering_modes: optional. Ways of metering that the camera offers
        minimum_shutter_speed: 0..60 second, optional. Shortest exposure time, in seconds
        maximum_shutter_speed: 0..60 second, optional. Longest exposure time, in seconds
        minimum_aperture: 0.1..128, optional. Smallest f-number
        maximum_aperture: 0.1..128, optional. Largest f-number
        minimum_focal_length: 0..2 meter, optional. Smallest focal length, in metres
        maximum_focal_length: 0..2 meter, optional. Largest focal length, in metres
        light_sensitivity_levels: optional. Sensitivities that the camera offers
        image_stabilization: ImageStabilization, optional. Whether the camera can steady its image
        """

        sensor_id: int
        sensor_name: str
        supported_states: environment_sensing_v1_0_types.SupportedStates | None = None
        zoom_modes: environment_sensing_v1_0_types.ZoomModes | None = None
        focus_modes: environment_sensing_v1_0_types.FocusModes | None = None
        white_balance: environment_sensing_v1_0_types.SupportedWhiteBalance | None = None
        imaging_modes: ReportVisualSensorCapabilities.ImagingModes | None = None
        exposure_modes: environment_sensing_v1_0_types.ExposureModes | None = None
        metering_modes: environment_sensing_v1_0_types.MeteringModes | None = None
        minimum_shutter_speed: float | None = None
        maximum_shutter_speed: float | None = None
        minimum_aperture: float | None = None
        maximum_aperture: float | None = None
        minimum_focal_length: float | None = None
        maximum_focal_length: float | None = None
        light_sensitivity_levels: environment_sensing_v1_0_types.LightSensitivityLevels | None = None
        image_stabilization: ReportVisualSensorCapabilities.ImageStabilization | int | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "H",
                ("SensorID", rt.Number("H")),
                ("SensorName", rt.Text(count=rt.Count("B", 0, 255))),
                ("SupportedStates", environment_sensing_v1_0_types.SupportedStates.layout(), True),
                ("ZoomModes", environment_sensing_v1_0_types.ZoomModes.layout(), True),
                ("FocusModes", environment_sensing_v1_0_types.FocusModes.layout(), True),
                ("WhiteBalance", environment_sensing_v1_0_types.SupportedWhiteBalance.layout(), True),
                ("ImagingModes", ReportVisualSensorCapabilities.ImagingModes.layout(), True),
                ("ExposureModes", environment_sensing_v1_0_types.ExposureModes.layout(), True),
                ("MeteringModes", environment_sensing_v1_0_types.MeteringModes.layout(), True),
                ("MinimumShutterSpeed", rt.real("H", 0.0, 60.0, "second"), True),
                ("MaximumShutterSpeed", rt.real("H", 0.0, 60.0, "second"), True),
                ("MinimumAperture", rt.real("H", 0.1, 128.0), True),
                ("MaximumAperture", rt.real("H", 0.1, 128.0), True),
                ("MinimumFocalLength", rt.real("I", 0.0, 2.0, "meter"), True),
                ("MaximumFocalLength", rt.real("I", 0.0, 2.0, "meter"), True),
                ("LightSensitivityLevels", environment_sensing_v1_0_types.LightSensitivityLevels.layout(), True),
                ("ImageStabilization", rt.Number("B", rt.Values(ReportVisualSensorCapabilities.ImageStabilization)), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            (mask,) = _S_H.unpack_from(data, at)
            (self.sensor_id,) = _S_H.unpack_from(data, at + 2)
            sensor_name_end_ = at + 5 + data[at + 4]
            self.sensor_name = data[at + 5:sensor_name_end_].decode("latin-1")
            packer = _M_ReportVisualSensorCapabilities_VisualSensorCapabilitiesRec_2[mask & 0x7FFF]
            raw = iter(packer.unpack_from(data, sensor_name_end_)).__next__
            at = sensor_name_end_ + packer.size
            if mask & 1:
                supported_states_ = raw()
                self.supported_states = environment_sensing_v1_0_types.SupportedStates(_E_SupportedStates_Active.get(supported_states_ & 0x1, supported_states_ & 0x1), _E_SupportedStates_Standby.get(supported_states_ >> 1 & 0x1, supported_states_ >> 1 & 0x1), _E_SupportedStates_Off.get(supported_states_ >> 2 & 0x1, supported_states_ >> 2 & 0x1), supported_states_ & 0xF8)
            else: self.supported_states = None
            if mask & 2:
                zoom_modes_ = raw()
                self.zoom_modes = environment_sensing_v1_0_types.ZoomModes(_E_ZoomModes_Mixed.get(zoom_modes_ & 0x1, zoom_modes_ & 0x1), _E_ZoomModes_AnalogOnly.get(zoom_modes_ >> 1 & 0x1, zoom_modes_ >> 1 & 0x1), _E_ZoomModes_DigitalOnly.get(zoom_modes_ >> 2 & 0x1, zoom_modes_ >> 2 & 0x1), _E_ZoomModes_None_.get(zoom_modes_ >> 3 & 0x1, zoom_modes_ >> 3 & 0x1), zoom_modes_ & 0xF0)
            else: self.zoom_modes = None
            if mask & 4:
                focus_modes_ = raw()
                self.focus_modes = environment_sensing_v1_0_types.FocusModes(_E_FocusModes_AutoFocus.get(focus_modes_ & 0x1, focus_modes_ & 0x1), _E_FocusModes_ManualFocus.get(focus_modes_ >> 1 & 0x1, focus_modes_ >> 1 & 0x1), focus_modes_ & 0xFC)
            else: self.focus_modes = None
            if mask & 8:
                white_balance_ = raw()
                self.white_balance = environment_sensing_v1_0_types.SupportedWhiteBalance(_E_SupportedWhiteBalance_Auto.get(white_balance_ & 0x1, white_balance_ & 0x1), _E_SupportedWhiteBalance_Daylight.get(white_balance_ >> 1 & 0x1, white_balance_ >> 1 & 0x1), _E_SupportedWhiteBalance_Cloudy.get(white_balance_ >> 2 & 0x1, white_balance_ >> 2 & 0x1), _E_SupportedWhiteBalance_Shade.get(white_balance_ >> 3 & 0x1, white_balance_ >> 3 & 0x1), _E_SupportedWhiteBalance_Tungsten.get(white_balance_ >> 4 & 0x1, white_balance_ >> 4 & 0x1), _E_SupportedWhiteBalance_Flurescent.get(white_balance_ >> 5 & 0x1, white_balance_ >> 5 & 0x1), _E_SupportedWhiteBalance_Flash.get(white_balance_ >> 6 & 0x1, white_balance_ >> 6 & 0x1), white_balance_ & 0x80)
            else: self.white_balance = None
            if mask & 16:
                imaging_modes_ = raw()
                self.imaging_modes = ReportVisualSensorCapabilities.ImagingModes(_E_ReportVisualSensorCapabilities_Color.get(imaging_modes_ & 0x1, imaging_modes_ & 0x1), _E_ReportVisualSensorCapabilities_Greyscale.get(imaging_modes_ >> 1 & 0x1, imaging_modes_ >> 1 & 0x1), _E_ReportVisualSensorCapabilities_Infrared.get(imaging_modes_ >> 2 & 0x1, imaging_modes_ >> 2 & 0x1), _E_ReportVisualSensorCapabilities_Lowlight.get(imaging_modes_ >> 3 & 0x1, imaging_modes_ >> 3 & 0x1), imaging_modes_ & 0xF0)
            else: self.imaging_modes = None
            if mask & 32:
                exposure_modes_ = raw()
                self.exposure_modes = environment_sensing_v1_0_types.ExposureModes(_E_ExposureModes_Auto.get(exposure_modes_ & 0x1, exposure_modes_ & 0x1), _E_ExposureModes_Manual.get(exposure_modes_ >> 1 & 0x1, exposure_modes_ >> 1 & 0x1), _E_ExposureModes_ShutterPriority.get(exposure_modes_ >> 2 & 0x1, exposure_modes_ >> 2 & 0x1), _E_ExposureModes_AperturePriority.get(exposure_modes_ >> 3 & 0x1, exposure_modes_ >> 3 & 0x1), exposure_modes_ & 0xF0)
            else: self.exposure_modes = None
            if mask & 64:
                metering_modes_ = raw()
                self.metering_modes = environment_sensing_v1_0_types.MeteringModes(_E_MeteringModes_MatrixOrAuto.get(metering_modes_ & 0x1, metering_modes_ & 0x1), _E_MeteringModes_CenterWeighted.get(metering_modes_ >> 1 & 0x1, metering_modes_ >> 1 & 0x1), _E_MeteringModes_Spot.get(metering_modes_ >> 2 & 0x1, metering_modes_ >> 2 & 0x1), metering_modes_ & 0xF8)
            else: self.metering_modes = None
            self.minimum_shutter_speed = raw() * 0.0009155413138017853 if mask & 128 else None
            self.maximum_shutter_speed = raw() * 0.0009155413138017853 if mask & 256 else None
            self.minimum_aperture = 0.1 + raw() * 0.0019516289005874724 if mask & 512 else None
            self.maximum_aperture = 0.1 + raw() * 0.0019516289005874724 if mask & 1024 else None
            self.minimum_focal_length = raw() * 4.656612874161595e-10 if mask & 2048 else None
            self.maximum_focal_length = raw() * 4.656612874161595e-10 if mask & 4096 else None
            if mask & 8192:
                light_sensitivity_levels_ = raw()
                self.light_sensitivity_levels = environment_sensing_v1_0_types.LightSensitivityLevels(_E_LightSensitivityLevels_Auto.get(light_sensitivity_levels_ & 0x1, light_sensitivity_levels_ & 0x1), _E_LightSensitivityLevels_ISO100.get(light_sensitivity_levels_ >> 1 & 0x1, light_sensitivity_levels_ >> 1 & 0x1), _E_LightSensitivityLevels_ISO200.get(light_sensitivity_levels_ >> 2 & 0x1, light_sensitivity_levels_ >> 2 & 0x1), _E_LightSensitivityLevels_ISO400.get(light_sensitivity_levels_ >> 3 & 0x1, light_sensitivity_levels_ >> 3 & 0x1), _E_LightSensitivityLevels_ISO800.get(light_sensitivity_levels_ >> 4 & 0x1, light_sensitivity_levels_ >> 4 & 0x1), _E_LightSensitivityLevels_ISO1600.get(light_sensitivity_levels_ >> 5 & 0x1, light_sensitivity_levels_ >> 5 & 0x1), _E_LightSensitivityLevels_ISO3200.get(light_sensitivity_levels_ >> 6 & 0x1, light_sensitivity_levels_ >> 6 & 0x1), light_sensitivity_levels_ & 0x80)
            else: self.light_sensitivity_levels = None
            if mask & 16384:
                image_stabilization_ = raw()
                self.image_stabilization = _E_ReportVisualSensorCapabilities_ImageStabilization[image_stabilization_]
            else: self.image_stabilization = None
            self.reserved_presence = mask & 0x8000
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0\0"
            mask = self.reserved_presence
            if mask & 0x7FFF: raise rt.Reject
            out += _S_H.pack(self.sensor_id)
            sensor_name_raw_ = self.sensor_name.encode("latin-1")
            out.append(len(sensor_name_raw_))
            out += sensor_name_raw_
            raw: list[int | float | bytes] = []
            supported_states_ = self.supported_states
            if supported_states_ is not None:
                mask |= 1
                if type(supported_states_) is not environment_sensing_v1_0_types.SupportedStates: raise rt.Reject
                active_ = supported_states_.active
                if not 0 <= active_ <= 1: raise rt.Reject
                standby_ = supported_states_.standby
                if not 0 <= standby_ <= 1: raise rt.Reject
                off_ = supported_states_.off
                if not 0 <= off_ <= 1: raise rt.Reject
                reserved_bits_ = supported_states_.reserved_bits
                if reserved_bits_ & 0x7: raise rt.Reject
                raw.append(active_ | standby_ << 1 | off_ << 2 | reserved_bits_)
            zoom_modes_ = self.zoom_modes
            if zoom_modes_ is not None:
                mask |= 2
                if type(zoom_modes_) is not environment_sensing_v1_0_types.ZoomModes: raise rt.Reject
                mixed_ = zoom_modes_.mixed
                if not 0 <= mixed_ <= 1: raise rt.Reject
                analog_only_ = zoom_modes_.analog_only
                if not 0 <= analog_only_ <= 1: raise rt.Reject
                digital_only_ = zoom_modes_.digital_only
                if not 0 <= digital_only_ <= 1: raise rt.Reject
                none_ = zoom_modes_.none
                if not 0 <= none_ <= 1: raise rt.Reject
                reserved_bits_2_ = zoom_modes_.reserved_bits
                if reserved_bits_2_ & 0xF: raise rt.Reject
                raw.append(mixed_ | analog_only_ << 1 | digital_only_ << 2 | none_ << 3 | reserved_bits_2_)
            focus_modes_ = self.focus_modes
            if focus_modes_ is not None:
                mask |= 4
                if type(focus_modes_) is not environment_sensing_v1_0_types.FocusModes: raise rt.Reject
                auto_focus_ = focus_modes_.auto_focus
                if not 0 <= auto_focus_ <= 1: raise rt.Reject
                manual_focus_ = focus_modes_.manual_focus
                if not 0 <= manual_focus_ <= 1: raise rt.Reject
                reserved_bits_3_ = focus_modes_.reserved_bits
                if reserved_bits_3_ & 0x3: raise rt.Reject
                raw.append(auto_focus_ | manual_focus_ << 1 | reserved_bits_3_)
            white_balance_ = self.white_balance
            if white_balance_ is not None:
                mask |= 8
                if type(white_balance_) is not environment_sensing_v1_0_types.SupportedWhiteBalance: raise rt.Reject
                auto_ = white_balance_.auto
                if not 0 <= auto_ <= 1: raise rt.Reject
                daylight_ = white_balance_.daylight
                if not 0 <= daylight_ <= 1: raise rt.Reject
                cloudy_ = white_balance_.cloudy
                if not 0 <= cloudy_ <= 1: raise rt.Reject
                shade_ = white_balance_.shade
                if not 0 <= shade_ <= 1: raise rt.Reject
                tungsten_ = white_balance_.tungsten
                if not 0 <= tungsten_ <= 1: raise rt.Reject
                flurescent_ = white_balance_.flurescent
                if not 0 <= flurescent_ <= 1: raise rt.Reject
                flash_ = white_balance_.flash
                if not 0 <= flash_ <= 1: raise rt.Reject
                reserved_bits_4_ = white_balance_.reserved_bits
                if reserved_bits_4_ & 0x7F: raise rt.Reject
                raw.append(auto_ | daylight_ << 1 | cloudy_ << 2 | shade_ << 3 | tungsten_ << 4 | flurescent_ << 5 | flash_ << 6 | reserved_bits_4_)
            imaging_modes_ = self.imaging_modes
            if imaging_modes_ is not None:
                mask |= 16
                if type(imaging_modes_) is not ReportVisualSensorCapabilities.ImagingModes: raise rt.Reject
                color_ = imaging_modes_.color
                if not 0 <= color_ <= 1: raise rt.Reject
                greyscale_ = imaging_modes_.greyscale
                if not 0 <= greyscale_ <= 1: raise rt.Reject
                infrared_ = imaging_modes_.infrared
                if not 0 <= infrared_ <= 1: raise rt.Reject
                lowlight_ = imaging_modes_.lowlight
                if not 0 <= lowlight_ <= 1: raise rt.Reject
                reserved_bits_5_ = imaging_modes_.reserved_bits
                if reserved_bits_5_ & 0xF: raise rt.Reject
                raw.append(color_ | greyscale_ << 1 | infrared_ << 2 | lowlight_ << 3 | reserved_bits_5_)
            exposure_modes_ = self.exposure_modes
            if exposure_modes_ is not None:
                mask |= 32
                if type(exposure_modes_) is not environment_sensing_v1_0_types.ExposureModes: raise rt.Reject
                auto_2_ = exposure_modes_.auto
                if not 0 <= auto_2_ <= 1: raise rt.Reject
                manual_ = exposure_modes_.manual
                if not 0 <= manual_ <= 1: raise rt.Reject
                shutter_priority_ = exposure_modes_.shutter_priority
                if not 0 <= shutter_priority_ <= 1: raise rt.Reject
                aperture_priority_ = exposure_modes_.aperture_priority
                if not 0 <= aperture_priority_ <= 1: raise rt.Reject
                reserved_bits_6_ = exposure_modes_.reserved_bits
                if reserved_bits_6_ & 0xF: raise rt.Reject
                raw.append(auto_2_ | manual_ << 1 | shutter_priority_ << 2 | aperture_priority_ << 3 | reserved_bits_6_)
            metering_modes_ = self.metering_modes
            if metering_modes_ is not None:
                mask |= 64
                if type(metering_modes_) is not environment_sensing_v1_0_types.MeteringModes: raise rt.Reject
                matrix_or_auto_ = metering_modes_.matrix_or_auto
                if not 0 <= matrix_or_auto_ <= 1: raise rt.Reject
                center_weighted_ = metering_modes_.center_weighted
                if not 0 <= center_weighted_ <= 1: raise rt.Reject
                spot_ = metering_modes_.spot
                if not 0 <= spot_ <= 1: raise rt.Reject
                reserved_bits_7_ = metering_modes_.reserved_bits
                if reserved_bits_7_ & 0x7: raise rt.Reject
                raw.append(matrix_or_auto_ | center_weighted_ << 1 | spot_ << 2 | reserved_bits_7_)
            minimum_shutter_speed_ = self.minimum_shutter_speed
            if minimum_shutter_speed_ is not None:
                mask |= 128
                if not 0.0 <= minimum_shutter_speed_ <= 60.0: raise rt.Reject
                near = minimum_shutter_speed_ * 1092.25 + 0.5
                minimum_shutter_speed_raw_ = int(near)
                if not 1.52587890625e-05 < near - minimum_shutter_speed_raw_ < 0.9999847412109375: minimum_shutter_speed_raw_ = rt.exact_raw(minimum_shutter_speed_, _R_16)
                raw.append(minimum_shutter_speed_raw_)
            maximum_shutter_speed_ = self.maximum_shutter_speed
            if maximum_shutter_speed_ is not None:
                mask |= 256
                if not 0.0 <= maximum_shutter_speed_ <= 60.0: raise rt.Reject
                near = maximum_shutter_speed_ * 1092.25 + 0.5
                maximum_shutter_speed_raw_ = int(near)
                if not 1.52587890625e-05 < near - maximum_shutter_speed_raw_ < 0.9999847412109375: maximum_shutter_speed_raw_ = rt.exact_raw(maximum_shutter_speed_, _R_16)
                raw.append(maximum_shutter_speed_raw_)
            minimum_aperture_ = self.minimum_aperture
            if minimum_aperture_ is not None:
                mask |= 512
                if not 0.1 <= minimum_aperture_ <= 128.0: raise rt.Reject
                near = minimum_aperture_ * 512.3924941360438 + -50.73924941360438
                minimum_aperture_raw_ = int(near)
                if not 1.52587890625e-05 < near - minimum_aperture_raw_ < 0.9999847412109375: minimum_aperture_raw_ = rt.exact_raw(minimum_aperture_, _R_17)
                raw.append(minimum_aperture_raw_)
            maximum_aperture_ = self.maximum_aperture
            if maximum_aperture_ is not None:
                mask |= 1024
                if not 0.1 <= maximum_aperture_ <= 128.0: raise rt.Reject
                near = maximum_aperture_ * 512.3924941360438 + -50.73924941360438
                maximum_aperture_raw_ = int(near)
                if not 1.52587890625e-05 < near - maximum_aperture_raw_ < 0.9999847412109375: maximum_aperture_raw_ = rt.exact_raw(maximum_aperture_, _R_17)
                raw.append(maximum_aperture_raw_)
            minimum_focal_length_ = self.minimum_focal_length
            if minimum_focal_length_ is not None:
                mask |= 2048
                if not 0.0 <= minimum_focal_length_ <= 2.0: raise rt.Reject
                near = minimum_focal_length_ * 2147483647.5 + 0.5
                minimum_focal_length_raw_ = int(near)
                if not 1.52587890625e-05 < near - minimum_focal_length_raw_ < 0.9999847412109375: minimum_focal_length_raw_ = rt.exact_raw(minimum_focal_length_, _R_14)
                raw.append(minimum_focal_length_raw_)
            maximum_focal_length_ = self.maximum_focal_length
            if maximum_focal_length_ is not None:
                mask |= 4096
                if not 0.0 <= maximum_focal_length_ <= 2.0: raise rt.Reject
                near = maximum_focal_length_ * 2147483647.5 + 0.5
                maximum_focal_length_raw_ = int(near)
                if not 1.52587890625e-05 < near - maximum_focal_length_raw_ < 0.9999847412109375: maximum_focal_length_raw_ = rt.exact_raw(maximum_focal_length_, _R_14)
                raw.append(maximum_focal_length_raw_)
            light_sensitivity_levels_ = self.light_sensitivity_levels
            if light_sensitivity_levels_ is not None:
                mask |= 8192
                if type(light_sensitivity_levels_) is not environment_sensing_v1_0_types.LightSensitivityLevels: raise rt.Reject
                auto_3_ = light_sensitivity_levels_.auto
                if not 0 <= auto_3_ <= 1: raise rt.Reject
                iso100_ = light_sensitivity_levels_.iso100
                if not 0 <= iso100_ <= 1: raise rt.Reject
                iso200_ = light_sensitivity_levels_.iso200
                if not 0 <= iso200_ <= 1: raise rt.Reject
                iso400_ = light_sensitivity_levels_.iso400
                if not 0 <= iso400_ <= 1: raise rt.Reject
                iso800_ = light_sensitivity_levels_.iso800
                if not 0 <= iso800_ <= 1: raise rt.Reject
                iso1600_ = light_sensitivity_levels_.iso1600
                if not 0 <= iso1600_ <= 1: raise rt.Reject
                iso3200_ = light_sensitivity_levels_.iso3200
                if not 0 <= iso3200_ <= 1: raise rt.Reject
                reserved_bits_8_ = light_sensitivity_levels_.reserved_bits
                if reserved_bits_8_ & 0x7F: raise rt.Reject
                raw.append(auto_3_ | iso100_ << 1 | iso200_ << 2 | iso400_ << 3 | iso800_ << 4 | iso1600_ << 5 | iso3200_ << 6 | reserved_bits_8_)
            image_stabilization_ = self.image_stabilization
            if image_stabilization_ is not None:
                mask |= 16384
                if image_stabilization_ not in _E_ReportVisualSensorCapabilities_ImageStabilization: raise rt.Reject
                raw.append(image_stabilization_)
            out += _M_ReportVisualSensorCapabilities_VisualSensorCapabilitiesRec_2[mask & 0x7FFF].pack(*raw)
            _S_H.pack_into(out, start, mask)

    visual_sensor_capabilities_list: list[ReportVisualSensorCapabilities.VisualSensorCapabilitiesRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("VisualSensorCapabilitiesList", rt.Repeat(rt.Count("H", 0, 65535), ReportVisualSensorCapabilities.VisualSensorCapabilitiesRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x06 or data[1] != 0x48: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (visual_sensor_capabilities_list_count_,) = _S_H.unpack_from(data, 2)
        if visual_sensor_capabilities_list_count_ * 5 > size - 4: raise rt.Reject
        at = 4
        visual_sensor_capabilities_list_ = []
        for _ in range(visual_sensor_capabilities_list_count_):
            item_, at = ReportVisualSensorCapabilities.VisualSensorCapabilitiesRec._read(data, at, nesting)
            visual_sensor_capabilities_list_.append(item_)
        self.visual_sensor_capabilities_list = visual_sensor_capabilities_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x06\x48")
        visual_sensor_capabilities_list_ = self.visual_sensor_capabilities_list
        if type(visual_sensor_capabilities_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(visual_sensor_capabilities_list_))
        for item_ in visual_sensor_capabilities_list_:
            if type(item_) is not ReportVisualSensorCapabilities.VisualSensorCapabilitiesRec: raise rt.Reject
            item_._write(out)
        return bytes(out)


_S_H = rt.Packer("<H")
_S_2H = rt.Packer("<2H")
_L_H = rt.Rows("H")
_M_SetVisualSensorConfiguration_VisualSensorConfigurationRec_0 = rt.Masks("", ((0, "H"), (1, "B"), (2, "B"), (4, "H"), (8, "I"), (16, "I"), (32, "I"), (64, "B"), (128, "H"), (256, "B"), (512, "B"), (1024, "B"), (2048, "B"), (4096, "H"), (8192, "H"), (16384, "B"), (32768, "B")))
_E_SetVisualSensorConfiguration_SensorState = rt.members(SetVisualSensorConfiguration.SensorState)
_E_SetVisualSensorConfiguration_ZoomMode = rt.members(SetVisualSensorConfiguration.ZoomMode)
_E_SetVisualSensorConfiguration_FocusMode = rt.members(SetVisualSensorConfiguration.FocusMode)
_E_SetVisualSensorConfiguration_WhiteBalance = rt.members(SetVisualSensorConfiguration.WhiteBalance)
_E_SetVisualSensorConfiguration_ImagingMode = rt.members(SetVisualSensorConfiguration.ImagingMode)
_E_SetVisualSensorConfiguration_ExposureMode = rt.members(SetVisualSensorConfiguration.ExposureMode)
_E_SetVisualSensorConfiguration_MeteringMode = rt.members(SetVisualSensorConfiguration.MeteringMode)
_E_SetVisualSensorConfiguration_LightSensitivity = rt.members(SetVisualSensorConfiguration.LightSensitivity)
_E_SetVisualSensorConfiguration_ImageStablization = rt.members(SetVisualSensorConfiguration.ImageStablization)
_R_13 = rt.Scaling(0.0, 100.0, 65535)
_R_14 = rt.Scaling(0.0, 2.0, 4294967295)
_R_15 = rt.Scaling(-3.141592653589793, 3.141592653589793, 4294967295)
_R_16 = rt.Scaling(0.0, 60.0, 65535)
_R_17 = rt.Scaling(0.1, 128.0, 65535)
_E_ReportVisualSensorConfiguration_SensorState = rt.members(ReportVisualSensorConfiguration.SensorState)
_E_ReportVisualSensorConfiguration_ZoomMode = rt.members(ReportVisualSensorConfiguration.ZoomMode)
_E_ReportVisualSensorConfiguration_FocusMode = rt.members(ReportVisualSensorConfiguration.FocusMode)
_E_ReportVisualSensorConfiguration_WhiteBalance = rt.members(ReportVisualSensorConfiguration.WhiteBalance)
_E_ReportVisualSensorConfiguration_ImagingMode = rt.members(ReportVisualSensorConfiguration.ImagingMode)
_E_ReportVisualSensorConfiguration_ExposureMode = rt.members(ReportVisualSensorConfiguration.ExposureMode)
_E_ReportVisualSensorConfiguration_MeteringMode = rt.members(ReportVisualSensorConfiguration.MeteringMode)
_E_ReportVisualSensorConfiguration_LightSensitivity = rt.members(ReportVisualSensorConfiguration.LightSensitivity)
_E_ReportVisualSensorConfiguration_ImageStablization = rt.members(ReportVisualSensorConfiguration.ImageStablization)
_M_ReportVisualSensorCapabilities_VisualSensorCapabilitiesRec_2 = rt.Masks("", ((1, "B"), (2, "B"), (4, "B"), (8, "B"), (16, "B"), (32, "B"), (64, "B"), (128, "H"), (256, "H"), (512, "H"), (1024, "H"), (2048, "I"), (4096, "I"), (8192, "B"), (16384, "B")))
_E_SupportedStates_Active = rt.members(environment_sensing_v1_0_types.SupportedStates.Active)
_E_SupportedStates_Standby = rt.members(environment_sensing_v1_0_types.SupportedStates.Standby)
_E_SupportedStates_Off = rt.members(environment_sensing_v1_0_types.SupportedStates.Off)
_E_ZoomModes_Mixed = rt.members(environment_sensing_v1_0_types.ZoomModes.Mixed)
_E_ZoomModes_AnalogOnly = rt.members(environment_sensing_v1_0_types.ZoomModes.AnalogOnly)
_E_ZoomModes_DigitalOnly = rt.members(environment_sensing_v1_0_types.ZoomModes.DigitalOnly)
_E_ZoomModes_None_ = rt.members(environment_sensing_v1_0_types.ZoomModes.None_)
_E_FocusModes_AutoFocus = rt.members(environment_sensing_v1_0_types.FocusModes.AutoFocus)
_E_FocusModes_ManualFocus = rt.members(environment_sensing_v1_0_types.FocusModes.ManualFocus)
_E_SupportedWhiteBalance_Auto = rt.members(environment_sensing_v1_0_types.SupportedWhiteBalance.Auto)
_E_SupportedWhiteBalance_Daylight = rt.members(environment_sensing_v1_0_types.SupportedWhiteBalance.Daylight)
_E_SupportedWhiteBalance_Cloudy = rt.members(environment_sensing_v1_0_types.SupportedWhiteBalance.Cloudy)
_E_SupportedWhiteBalance_Shade = rt.members(environment_sensing_v1_0_types.SupportedWhiteBalance.Shade)
_E_SupportedWhiteBalance_Tungsten = rt.members(environment_sensing_v1_0_types.SupportedWhiteBalance.Tungsten)
_E_SupportedWhiteBalance_Flurescent = rt.members(environment_sensing_v1_0_types.SupportedWhiteBalance.Flurescent)
_E_SupportedWhiteBalance_Flash = rt.members(environment_sensing_v1_0_types.SupportedWhiteBalance.Flash)
_E_ReportVisualSensorCapabilities_Color = rt.members(ReportVisualSensorCapabilities.Color)
_E_ReportVisualSensorCapabilities_Greyscale = rt.members(ReportVisualSensorCapabilities.Greyscale)
_E_ReportVisualSensorCapabilities_Infrared = rt.members(ReportVisualSensorCapabilities.Infrared)
_E_ReportVisualSensorCapabilities_Lowlight = rt.members(ReportVisualSensorCapabilities.Lowlight)
_E_ExposureModes_Auto = rt.members(environment_sensing_v1_0_types.ExposureModes.Auto)
_E_ExposureModes_Manual = rt.members(environment_sensing_v1_0_types.ExposureModes.Manual)
_E_ExposureModes_ShutterPriority = rt.members(environment_sensing_v1_0_types.ExposureModes.ShutterPriority)
_E_ExposureModes_AperturePriority = rt.members(environment_sensing_v1_0_types.ExposureModes.AperturePriority)
_E_MeteringModes_MatrixOrAuto = rt.members(environment_sensing_v1_0_types.MeteringModes.MatrixOrAuto)
_E_MeteringModes_CenterWeighted = rt.members(environment_sensing_v1_0_types.MeteringModes.CenterWeighted)
_E_MeteringModes_Spot = rt.members(environment_sensing_v1_0_types.MeteringModes.Spot)
_E_LightSensitivityLevels_Auto = rt.members(environment_sensing_v1_0_types.LightSensitivityLevels.Auto)
_E_LightSensitivityLevels_ISO100 = rt.members(environment_sensing_v1_0_types.LightSensitivityLevels.ISO100)
_E_LightSensitivityLevels_ISO200 = rt.members(environment_sensing_v1_0_types.LightSensitivityLevels.ISO200)
_E_LightSensitivityLevels_ISO400 = rt.members(environment_sensing_v1_0_types.LightSensitivityLevels.ISO400)
_E_LightSensitivityLevels_ISO800 = rt.members(environment_sensing_v1_0_types.LightSensitivityLevels.ISO800)
_E_LightSensitivityLevels_ISO1600 = rt.members(environment_sensing_v1_0_types.LightSensitivityLevels.ISO1600)
_E_LightSensitivityLevels_ISO3200 = rt.members(environment_sensing_v1_0_types.LightSensitivityLevels.ISO3200)
_E_ReportVisualSensorCapabilities_ImageStabilization = rt.members(ReportVisualSensorCapabilities.ImageStabilization)
QuerySensorGeometricProperties.REPORT = ReportSensorGeometricProperties
QueryVisualSensorConfiguration.REPORT = ReportVisualSensorConfiguration
QueryVisualSensorCapabilities.REPORT = ReportVisualSensorCapabilities
