"""urn:jaus:jss:environmentSensing:AnalogVideo 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.environment_sensing.v1_0 import types as environment_sensing_v1_0_types


@dataclass(slots=True, repr=False)
class SetAnalogVideoSensorConfiguration(rt.Message):
    """SetAnalogVideoSensorConfiguration (0x0806): Sets the configuration of analog cameras.

    analog_video_sensor_list: 0..65535 items. The cameras
    """

    CODE = 0x0806
    NAME = "SetAnalogVideoSensorConfiguration"
    SERVICE = "urn:jaus:jss:environmentSensing:AnalogVideo"
    VERSION = "2.0"
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

    class AnalogFormat(IntEnum):
        """Values of AnalogFormat."""

        NTSC_M = 0
        NTSC_J = 1
        PAL_N = 2
        PAL_M = 3
        SECAM_L = 4
        SECAM_B_G = 5

    @dataclass(slots=True, repr=False)
    class AnalogVideoSensorConfigurationRec(rt.Struct):
        """Settings of one camera.

        sensor_id: 1..65535. Identifies the sensor
        analog_format: AnalogFormat. Signal format
        """

        sensor_id: int
        analog_format: SetAnalogVideoSensorConfiguration.AnalogFormat | int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("SensorID", rt.Number("H", rt.Values(None, ((1, 65535),)))),
                ("AnalogFormat", rt.Number("B", rt.Values(SetAnalogVideoSensorConfiguration.AnalogFormat))),
            )

    request_id_rec: SetAnalogVideoSensorConfiguration.RequestIdRec
    analog_video_sensor_list: list[SetAnalogVideoSensorConfiguration.AnalogVideoSensorConfigurationRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("RequestIdRec", SetAnalogVideoSensorConfiguration.RequestIdRec.layout()),
            ("AnalogVideoSensorList", rt.Repeat(rt.Count("H", 0, 65535), SetAnalogVideoSensorConfiguration.AnalogVideoSensorConfigurationRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x06 or data[1] != 0x08: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        request_id_ = data[2]
        self.request_id_rec = SetAnalogVideoSensorConfiguration.RequestIdRec(request_id_)
        (analog_video_sensor_list_count_,) = _S_H.unpack_from(data, 3)
        analog_video_sensor_list_end_ = 5 + analog_video_sensor_list_count_ * 3
        analog_video_sensor_list_ = []
        for sensor_id_, analog_format_ in _S_HB.iter_unpack(data[5:analog_video_sensor_list_end_]):
            if sensor_id_ < 1: raise rt.Reject
            analog_video_sensor_list_.append(SetAnalogVideoSensorConfiguration.AnalogVideoSensorConfigurationRec(sensor_id_, _E_SetAnalogVideoSensorConfiguration_AnalogFormat[analog_format_]))
        self.analog_video_sensor_list = analog_video_sensor_list_
        if analog_video_sensor_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x06\x08")
        request_id_rec_ = self.request_id_rec
        if type(request_id_rec_) is not SetAnalogVideoSensorConfiguration.RequestIdRec: raise rt.Reject
        out.append(request_id_rec_.request_id)
        analog_video_sensor_list_ = self.analog_video_sensor_list
        if type(analog_video_sensor_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(analog_video_sensor_list_))
        for item_ in analog_video_sensor_list_:
            if type(item_) is not SetAnalogVideoSensorConfiguration.AnalogVideoSensorConfigurationRec: raise rt.Reject
            sensor_id_ = item_.sensor_id
            if not 1 <= sensor_id_ <= 65535: raise rt.Reject
            analog_format_ = item_.analog_format
            if analog_format_ not in _E_SetAnalogVideoSensorConfiguration_AnalogFormat: raise rt.Reject
            out += _S_HB.pack(sensor_id_, analog_format_)
        return bytes(out)


@dataclass(slots=True, repr=False)
class QueryAnalogVideoSensorConfiguration(rt.Message):
    """QueryAnalogVideoSensorConfiguration (0x2811): Asks for the configuration of analog cameras.

    sensor_id_list: 0..65535 items. The sensors
    """

    CODE = 0x2811
    NAME = "QueryAnalogVideoSensorConfiguration"
    SERVICE = "urn:jaus:jss:environmentSensing:AnalogVideo"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportAnalogVideoSensorConfiguration]]

    SensorIDQueryRec = environment_sensing_v1_0_types.SensorIDQueryRec

    sensor_id_list: list[environment_sensing_v1_0_types.SensorIDQueryRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("SensorIdList", rt.Repeat(rt.Count("H", 0, 65535), environment_sensing_v1_0_types.SensorIDQueryRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x11 or data[1] != 0x28: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (sensor_id_list_count_,) = _S_H.unpack_from(data, 2)
        sensor_id_list_end_ = 4 + sensor_id_list_count_ * 2
        self.sensor_id_list = [environment_sensing_v1_0_types.SensorIDQueryRec(_E_SensorIDQueryRec_SensorID.get(sensor_id_, sensor_id_)) for sensor_id_ in _L_H[sensor_id_list_count_].unpack_from(data, 4)]
        if sensor_id_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x11\x28")
        sensor_id_list_ = self.sensor_id_list
        if type(sensor_id_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(sensor_id_list_))
        raw_: list[int | float] = []
        for item_ in sensor_id_list_:
            if type(item_) is not environment_sensing_v1_0_types.SensorIDQueryRec: raise rt.Reject
            raw_.append(item_.sensor_id)
        out += _L_H[len(raw_)].pack(*raw_)
        return bytes(out)


@dataclass(slots=True, repr=False)
class QueryAnalogVideoSensorCapabilities(rt.Message):
    """QueryAnalogVideoSensorCapabilities (0x2810): Asks what analog cameras can do.

    sensor_id_list: 0..65535 items. The sensors
    """

    CODE = 0x2810
    NAME = "QueryAnalogVideoSensorCapabilities"
    SERVICE = "urn:jaus:jss:environmentSensing:AnalogVideo"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportAnalogVideoSensorCapabilities]]

    SensorIDQueryRec = environment_sensing_v1_0_types.SensorIDQueryRec

    sensor_id_list: list[environment_sensing_v1_0_types.SensorIDQueryRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("SensorIdList", rt.Repeat(rt.Count("H", 0, 65535), environment_sensing_v1_0_types.SensorIDQueryRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x10 or data[1] != 0x28: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (sensor_id_list_count_,) = _S_H.unpack_from(data, 2)
        sensor_id_list_end_ = 4 + sensor_id_list_count_ * 2
        self.sensor_id_list = [environment_sensing_v1_0_types.SensorIDQueryRec(_E_SensorIDQueryRec_SensorID.get(sensor_id_, sensor_id_)) for sensor_id_ in _L_H[sensor_id_list_count_].unpack_from(data, 4)]
        if sensor_id_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x10\x28")
        sensor_id_list_ = self.sensor_id_list
        if type(sensor_id_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(sensor_id_list_))
        raw_: list[int | float] = []
        for item_ in sensor_id_list_:
            if type(item_) is not environment_sensing_v1_0_types.SensorIDQueryRec: raise rt.Reject
            raw_.append(item_.sensor_id)
        out += _L_H[len(raw_)].pack(*raw_)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportAnalogVideoSensorConfiguration(rt.Message):
    """ReportAnalogVideoSensorConfiguration (0x4811): Tells the configuration of analog cameras.

    analog_video_sensor_configuration_list: 0..65535 items. The cameras
    """

    CODE = 0x4811
    NAME = "ReportAnalogVideoSensorConfiguration"
    SERVICE = "urn:jaus:jss:environmentSensing:AnalogVideo"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = False

    class AnalogFormat(IntEnum):
        """Values of AnalogFormat."""

        NTSC_M = 0
        NTSC_J = 1
        PAL_N = 2
        PAL_M = 3
        SECAM_L = 4
        SECAM_B_G = 5

    @dataclass(slots=True, repr=False)
    class AnalogVideoSensorConfigurationRec(rt.Struct):
        """Settings of one camera.

        sensor_id: 1..65535. Identifies the sensor
        analog_format: AnalogFormat. Signal format
        """

        sensor_id: int
        analog_format: ReportAnalogVideoSensorConfiguration.AnalogFormat | int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("SensorID", rt.Number("H", rt.Values(None, ((1, 65535),)))),
                ("AnalogFormat", rt.Number("B", rt.Values(ReportAnalogVideoSensorConfiguration.AnalogFormat))),
            )

    analog_video_sensor_configuration_list: list[ReportAnalogVideoSensorConfiguration.AnalogVideoSensorConfigurationRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("AnalogVideoSensorConfigurationList", rt.Repeat(rt.Count("H", 0, 65535), ReportAnalogVideoSensorConfiguration.AnalogVideoSensorConfigurationRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x11 or data[1] != 0x48: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (analog_video_sensor_configuration_list_count_,) = _S_H.unpack_from(data, 2)
        analog_video_sensor_configuration_list_end_ = 4 + analog_video_sensor_configuration_list_count_ * 3
        analog_video_sensor_configuration_list_ = []
        for sensor_id_, analog_format_ in _S_HB.iter_unpack(data[4:analog_video_sensor_configuration_list_end_]):
            if sensor_id_ < 1: raise rt.Reject
            analog_video_sensor_configuration_list_.append(ReportAnalogVideoSensorConfiguration.AnalogVideoSensorConfigurationRec(sensor_id_, _E_ReportAnalogVideoSensorConfiguration_AnalogFormat[analog_format_]))
        self.analog_video_sensor_configuration_list = analog_video_sensor_configuration_list_
        if analog_video_sensor_configuration_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x11\x48")
        analog_video_sensor_configuration_list_ = self.analog_video_sensor_configuration_list
        if type(analog_video_sensor_configuration_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(analog_video_sensor_configuration_list_))
        for item_ in analog_video_sensor_configuration_list_:
            if type(item_) is not ReportAnalogVideoSensorConfiguration.AnalogVideoSensorConfigurationRec: raise rt.Reject
            sensor_id_ = item_.sensor_id
            if not 1 <= sensor_id_ <= 65535: raise rt.Reject
            analog_format_ = item_.analog_format
            if analog_format_ not in _E_ReportAnalogVideoSensorConfiguration_AnalogFormat: raise rt.Reject
            out += _S_HB.pack(sensor_id_, analog_format_)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportAnalogVideoSensorCapabilities(rt.Message):
    """ReportAnalogVideoSensorCapabilities (0x4810): Tells what analog cameras can do.

    analog_video_sensor_capabilities_list: 0..65535 items. The cameras
    """

    CODE = 0x4810
    NAME = "ReportAnalogVideoSensorCapabilities"
    SERVICE = "urn:jaus:jss:environmentSensing:AnalogVideo"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = False

    SupportedAnalogFormats = environment_sensing_v1_0_types.SupportedAnalogFormats

    @dataclass(slots=True, repr=False)
    class AnalogVideoSensorCapabilitiesRec(rt.Struct):
        """AnalogVideoSensorCapabilitiesRec.

        sensor_id: 1..65535. Identifies the sensor
        supported_analog_formats: Signal formats that the camera offers
        """

        sensor_id: int
        supported_analog_formats: environment_sensing_v1_0_types.SupportedAnalogFormats

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("SensorID", rt.Number("H", rt.Values(None, ((1, 65535),)))),
                ("SupportedAnalogFormats", environment_sensing_v1_0_types.SupportedAnalogFormats.layout()),
            )

    analog_video_sensor_capabilities_list: list[ReportAnalogVideoSensorCapabilities.AnalogVideoSensorCapabilitiesRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("AnalogVideoSensorCapabilitiesList", rt.Repeat(rt.Count("H", 0, 65535), ReportAnalogVideoSensorCapabilities.AnalogVideoSensorCapabilitiesRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x10 or data[1] != 0x48: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (analog_video_sensor_capabilities_list_count_,) = _S_H.unpack_from(data, 2)
        analog_video_sensor_capabilities_list_end_ = 4 + analog_video_sensor_capabilities_list_count_ * 3
        analog_video_sensor_capabilities_list_ = []
        for sensor_id_, supported_analog_formats_ in _S_HB.iter_unpack(data[4:analog_video_sensor_capabilities_list_end_]):
            if sensor_id_ < 1: raise rt.Reject
            analog_video_sensor_capabilities_list_.append(ReportAnalogVideoSensorCapabilities.AnalogVideoSensorCapabilitiesRec(sensor_id_, environment_sensing_v1_0_types.SupportedAnalogFormats(_E_SupportedAnalogFormats_NTSCM.get(supported_analog_formats_ & 0x1, supported_analog_formats_ & 0x1), _E_SupportedAnalogFormats_NTSCJ.get(supported_analog_formats_ >> 1 & 0x1, supported_analog_formats_ >> 1 & 0x1), _E_SupportedAnalogFormats_PALN.get(supported_analog_formats_ >> 2 & 0x1, supported_analog_formats_ >> 2 & 0x1), _E_SupportedAnalogFormats_PALM.get(supported_analog_formats_ >> 3 & 0x1, supported_analog_formats_ >> 3 & 0x1), _E_SupportedAnalogFormats_SECAML.get(supported_analog_formats_ >> 4 & 0x1, supported_analog_formats_ >> 4 & 0x1), _E_SupportedAnalogFormats_SECAMBG.get(supported_analog_formats_ >> 5 & 0x1, supported_analog_formats_ >> 5 & 0x1), supported_analog_formats_ & 0xC0)))
        self.analog_video_sensor_capabilities_list = analog_video_sensor_capabilities_list_
        if analog_video_sensor_capabilities_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x10\x48")
        analog_video_sensor_capabilities_list_ = self.analog_video_sensor_capabilities_list
        if type(analog_video_sensor_capabilities_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(analog_video_sensor_capabilities_list_))
        for item_ in analog_video_sensor_capabilities_list_:
            if type(item_) is not ReportAnalogVideoSensorCapabilities.AnalogVideoSensorCapabilitiesRec: raise rt.Reject
            sensor_id_ = item_.sensor_id
            if not 1 <= sensor_id_ <= 65535: raise rt.Reject
            supported_analog_formats_ = item_.supported_analog_formats
            if type(supported_analog_formats_) is not environment_sensing_v1_0_types.SupportedAnalogFormats: raise rt.Reject
            ntscm_ = supported_analog_formats_.ntscm
            if not 0 <= ntscm_ <= 1: raise rt.Reject
            ntscj_ = supported_analog_formats_.ntscj
            if not 0 <= ntscj_ <= 1: raise rt.Reject
            paln_ = supported_analog_formats_.paln
            if not 0 <= paln_ <= 1: raise rt.Reject
            palm_ = supported_analog_formats_.palm
            if not 0 <= palm_ <= 1: raise rt.Reject
            secaml_ = supported_analog_formats_.secaml
            if not 0 <= secaml_ <= 1: raise rt.Reject
            secambg_ = supported_analog_formats_.secambg
            if not 0 <= secambg_ <= 1: raise rt.Reject
            reserved_bits_ = supported_analog_formats_.reserved_bits
            if reserved_bits_ & 0x3F: raise rt.Reject
            out += _S_HB.pack(sensor_id_, ntscm_ | ntscj_ << 1 | paln_ << 2 | palm_ << 3 | secaml_ << 4 | secambg_ << 5 | reserved_bits_)
        return bytes(out)


_S_H = rt.Packer("<H")
_E_SetAnalogVideoSensorConfiguration_AnalogFormat = rt.members(SetAnalogVideoSensorConfiguration.AnalogFormat)
_S_HB = rt.Packer("<HB")
_E_SensorIDQueryRec_SensorID = rt.members(environment_sensing_v1_0_types.SensorIDQueryRec.SensorID)
_L_H = rt.Rows("H")
_E_ReportAnalogVideoSensorConfiguration_AnalogFormat = rt.members(ReportAnalogVideoSensorConfiguration.AnalogFormat)
_E_SupportedAnalogFormats_NTSCM = rt.members(environment_sensing_v1_0_types.SupportedAnalogFormats.NTSCM)
_E_SupportedAnalogFormats_NTSCJ = rt.members(environment_sensing_v1_0_types.SupportedAnalogFormats.NTSCJ)
_E_SupportedAnalogFormats_PALN = rt.members(environment_sensing_v1_0_types.SupportedAnalogFormats.PALN)
_E_SupportedAnalogFormats_PALM = rt.members(environment_sensing_v1_0_types.SupportedAnalogFormats.PALM)
_E_SupportedAnalogFormats_SECAML = rt.members(environment_sensing_v1_0_types.SupportedAnalogFormats.SECAML)
_E_SupportedAnalogFormats_SECAMBG = rt.members(environment_sensing_v1_0_types.SupportedAnalogFormats.SECAMBG)
QueryAnalogVideoSensorConfiguration.REPORT = ReportAnalogVideoSensorConfiguration
QueryAnalogVideoSensorCapabilities.REPORT = ReportAnalogVideoSensorCapabilities
