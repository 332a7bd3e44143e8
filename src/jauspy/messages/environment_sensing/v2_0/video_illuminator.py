"""urn:jaus:jss:environmentSensing:VideoIlluminator 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.environment_sensing.v2_0 import digital_audio_output as environment_sensing_v2_0_digital_audio_output


@dataclass(slots=True, repr=False)
class SetVideoIlluminatorConfiguration(rt.Message):
    """SetVideoIlluminatorConfiguration (0x081A): Sets the configuration of lamps.

    illuminator_list: 0..65535 items. The lamps
    """

    CODE = 0x081A
    NAME = "SetVideoIlluminatorConfiguration"
    SERVICE = "urn:jaus:jss:environmentSensing:VideoIlluminator"
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

    class Mode(IntEnum):
        """Values of Mode."""

        VISIBLE = 0
        INFRARED = 1
        GREYSCALE = 2
        LOWLIGHT = 3

    @dataclass(slots=True, repr=False)
    class IlluminatorRec(rt.Struct):
        """Settings of one lamp.

        illuminator_id: Identifies the lamp
        level: 0..100 percent. Brightness, in percent of the maximum
        mode: Mode or 4..20 or 21..31, optional. Kind of light
        beam_width: 0..360 degree, optional. Angle of the beam from left to right, in degrees
        beam_height: 0..360 degree, optional. Angle of the beam from top to bottom, in degrees
        """

        illuminator_id: int
        level: float
        mode: SetVideoIlluminatorConfiguration.Mode | int | None = None
        beam_width: float | None = None
        beam_height: float | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("IlluminatorID", rt.Number("H")),
                ("Level", rt.real("H", 0.0, 100.0, "percent")),
                ("Mode", rt.Number("B", rt.Values(SetVideoIlluminatorConfiguration.Mode, ((4, 20), (21, 31)))), True),
                ("BeamWidth", rt.real("H", 0.0, 360.0, "degree"), True),
                ("BeamHeight", rt.real("H", 0.0, 360.0, "degree"), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_SetVideoIlluminatorConfiguration_IlluminatorRec_0[mask & 0x7]
            raw = iter(packer.unpack_from(data, at + 1)).__next__
            at = at + 1 + packer.size
            self.illuminator_id = raw()
            level_ = raw()
            self.level = level_ * 0.0015259021896696422
            if mask & 1:
                mode_ = raw()
                if mode_ not in _E_SetVideoIlluminatorConfiguration_Mode and not 4 <= mode_ <= 20 and not 21 <= mode_ <= 31: raise rt.Reject
                self.mode = _E_SetVideoIlluminatorConfiguration_Mode.get(mode_, mode_)
            else: self.mode = None
            self.beam_width = raw() * 0.005493247882810712 if mask & 2 else None
            self.beam_height = raw() * 0.005493247882810712 if mask & 4 else None
            self.reserved_presence = mask & 0xF8
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x7: raise rt.Reject
            raw: list[int | float | bytes] = []
            raw.append(self.illuminator_id)
            level_ = self.level
            if not 0.0 <= level_ <= 100.0: raise rt.Reject
            near = level_ * 655.35 + 0.5
            level_raw_ = int(near)
            if not 1.52587890625e-05 < near - level_raw_ < 0.9999847412109375: level_raw_ = rt.exact_raw(level_, _R_2)
            raw.append(level_raw_)
            mode_ = self.mode
            if mode_ is not None:
                mask |= 1
                if mode_ not in _E_SetVideoIlluminatorConfiguration_Mode and not 4 <= mode_ <= 20 and not 21 <= mode_ <= 31: raise rt.Reject
                raw.append(mode_)
            beam_width_ = self.beam_width
            if beam_width_ is not None:
                mask |= 2
                if not 0.0 <= beam_width_ <= 360.0: raise rt.Reject
                near = beam_width_ * 182.04166666666666 + 0.5
                beam_width_raw_ = int(near)
                if not 1.52587890625e-05 < near - beam_width_raw_ < 0.9999847412109375: beam_width_raw_ = rt.exact_raw(beam_width_, _R_3)
                raw.append(beam_width_raw_)
            beam_height_ = self.beam_height
            if beam_height_ is not None:
                mask |= 4
                if not 0.0 <= beam_height_ <= 360.0: raise rt.Reject
                near = beam_height_ * 182.04166666666666 + 0.5
                beam_height_raw_ = int(near)
                if not 1.52587890625e-05 < near - beam_height_raw_ < 0.9999847412109375: beam_height_raw_ = rt.exact_raw(beam_height_, _R_3)
                raw.append(beam_height_raw_)
            out += _M_SetVideoIlluminatorConfiguration_IlluminatorRec_0[mask & 0x7].pack(*raw)
            _S_B.pack_into(out, start, mask)

    request_id_rec: SetVideoIlluminatorConfiguration.RequestIdRec
    illuminator_list: list[SetVideoIlluminatorConfiguration.IlluminatorRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("RequestIdRec", SetVideoIlluminatorConfiguration.RequestIdRec.layout()),
            ("IlluminatorList", rt.Repeat(rt.Count("H", 0, 65535), SetVideoIlluminatorConfiguration.IlluminatorRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x1A or data[1] != 0x08: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        request_id_ = data[2]
        self.request_id_rec = SetVideoIlluminatorConfiguration.RequestIdRec(request_id_)
        (illuminator_list_count_,) = _S_H.unpack_from(data, 3)
        if illuminator_list_count_ * 5 > size - 5: raise rt.Reject
        at = 5
        illuminator_list_ = []
        for _ in range(illuminator_list_count_):
            item_, at = SetVideoIlluminatorConfiguration.IlluminatorRec._read(data, at, nesting)
            illuminator_list_.append(item_)
        self.illuminator_list = illuminator_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x1a\x08")
        request_id_rec_ = self.request_id_rec
        if type(request_id_rec_) is not SetVideoIlluminatorConfiguration.RequestIdRec: raise rt.Reject
        out.append(request_id_rec_.request_id)
        illuminator_list_ = self.illuminator_list
        if type(illuminator_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(illuminator_list_))
        for item_ in illuminator_list_:
            if type(item_) is not SetVideoIlluminatorConfiguration.IlluminatorRec: raise rt.Reject
            item_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class QueryVideoIlluminatorConfiguration(rt.Message):
    """QueryVideoIlluminatorConfiguration (0x281A): Asks for the configuration of lamps.

    illuminator_id_list: 0..65535 items. The lamps
    """

    CODE = 0x281A
    NAME = "QueryVideoIlluminatorConfiguration"
    SERVICE = "urn:jaus:jss:environmentSensing:VideoIlluminator"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportVideoIlluminatorConfiguration]]

    @dataclass(slots=True, repr=False)
    class IlluminatorIDRec(rt.Struct):
        """IlluminatorIDRec.

        illuminator_id: Identifies the lamp
        """

        illuminator_id: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("IlluminatorID", rt.Number("H")),
            )

    illuminator_id_list: list[QueryVideoIlluminatorConfiguration.IlluminatorIDRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("IlluminatorIDList", rt.Repeat(rt.Count("H", 0, 65535), QueryVideoIlluminatorConfiguration.IlluminatorIDRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x1A or data[1] != 0x28: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (illuminator_id_list_count_,) = _S_H.unpack_from(data, 2)
        illuminator_id_list_end_ = 4 + illuminator_id_list_count_ * 2
        self.illuminator_id_list = [QueryVideoIlluminatorConfiguration.IlluminatorIDRec(illuminator_id_) for illuminator_id_ in _L_H[illuminator_id_list_count_].unpack_from(data, 4)]
        if illuminator_id_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x1a\x28")
        illuminator_id_list_ = self.illuminator_id_list
        if type(illuminator_id_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(illuminator_id_list_))
        raw_: list[int | float] = []
        for item_ in illuminator_id_list_:
            if type(item_) is not QueryVideoIlluminatorConfiguration.IlluminatorIDRec: raise rt.Reject
            raw_.append(item_.illuminator_id)
        out += _L_H[len(raw_)].pack(*raw_)
        return bytes(out)


@dataclass(slots=True, repr=False)
class QueryVideoIlluminatorCapabilities(rt.Message):
    """QueryVideoIlluminatorCapabilities (0x281B): Asks what lamps can do.

    illuminator_id_list: 0..65535 items. The lamps
    """

    CODE = 0x281B
    NAME = "QueryVideoIlluminatorCapabilities"
    SERVICE = "urn:jaus:jss:environmentSensing:VideoIlluminator"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportVideoIlluminatorCapabilities]]

    @dataclass(slots=True, repr=False)
    class IlluminatorIDRec(rt.Struct):
        """IlluminatorIDRec.

        illuminator_id: Identifies the lamp
        """

        illuminator_id: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("IlluminatorID", rt.Number("H")),
            )

    illuminator_id_list: list[QueryVideoIlluminatorCapabilities.IlluminatorIDRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("IlluminatorIDList", rt.Repeat(rt.Count("H", 0, 65535), QueryVideoIlluminatorCapabilities.IlluminatorIDRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x1B or data[1] != 0x28: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (illuminator_id_list_count_,) = _S_H.unpack_from(data, 2)
        illuminator_id_list_end_ = 4 + illuminator_id_list_count_ * 2
        self.illuminator_id_list = [QueryVideoIlluminatorCapabilities.IlluminatorIDRec(illuminator_id_) for illuminator_id_ in _L_H[illuminator_id_list_count_].unpack_from(data, 4)]
        if illuminator_id_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x1b\x28")
        illuminator_id_list_ = self.illuminator_id_list
        if type(illuminator_id_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(illuminator_id_list_))
        raw_: list[int | float] = []
        for item_ in illuminator_id_list_:
            if type(item_) is not QueryVideoIlluminatorCapabilities.IlluminatorIDRec: raise rt.Reject
            raw_.append(item_.illuminator_id)
        out += _L_H[len(raw_)].pack(*raw_)
        return bytes(out)


class ConfirmSensorConfiguration(environment_sensing_v2_0_digital_audio_output.ConfirmSensorConfiguration):
    """ConfirmSensorConfiguration (0x0801): Tells for each sensor whether its new configuration was taken over, and
    if not, why.
    """

    __slots__ = ()
    SERVICE = "urn:jaus:jss:environmentSensing:VideoIlluminator"
    VERSION = "2.0"


@dataclass(slots=True, repr=False)
class ReportVideoIlluminatorConfiguration(rt.Message):
    """ReportVideoIlluminatorConfiguration (0x481A): Tells the configuration of lamps.

    illumination_rec_list: 0..65535 items. The lamps
    """

    CODE = 0x481A
    NAME = "ReportVideoIlluminatorConfiguration"
    SERVICE = "urn:jaus:jss:environmentSensing:VideoIlluminator"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = False

    class Mode(IntEnum):
        """Values of Mode."""

        VISIBLE = 0
        INFRARED = 1
        GREYSCALE = 2
        LOWLIGHT = 3

    @dataclass(slots=True, repr=False)
    class IlluminatorRec(rt.Struct):
        """Settings of one lamp.

        illuminator_id: Identifies the lamp
        level: 0..100 percent. Brightness, in percent of the maximum
        mode: Mode or 4..20 or 21..31, optional. Kind of light
        beam_width: 0..360 degree, optional. Angle of the beam from left to right, in degrees
        beam_height: 0..360 degree, optional. Angle of the beam from top to bottom, in degrees
        """

        illuminator_id: int
        level: float
        mode: ReportVideoIlluminatorConfiguration.Mode | int | None = None
        beam_width: float | None = None
        beam_height: float | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("IlluminatorID", rt.Number("H")),
                ("Level", rt.real("H", 0.0, 100.0, "percent")),
                ("Mode", rt.Number("B", rt.Values(ReportVideoIlluminatorConfiguration.Mode, ((4, 20), (21, 31)))), True),
                ("BeamWidth", rt.real("H", 0.0, 360.0, "degree"), True),
                ("BeamHeight", rt.real("H", 0.0, 360.0, "degree"), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_SetVideoIlluminatorConfiguration_IlluminatorRec_0[mask & 0x7]
            raw = iter(packer.unpack_from(data, at + 1)).__next__
            at = at + 1 + packer.size
            self.illuminator_id = raw()
            level_ = raw()
            self.level = level_ * 0.0015259021896696422
            if mask & 1:
                mode_ = raw()
                if mode_ not in _E_ReportVideoIlluminatorConfiguration_Mode and not 4 <= mode_ <= 20 and not 21 <= mode_ <= 31: raise rt.Reject
                self.mode = _E_ReportVideoIlluminatorConfiguration_Mode.get(mode_, mode_)
            else: self.mode = None
            self.beam_width = raw() * 0.005493247882810712 if mask & 2 else None
            self.beam_height = raw() * 0.005493247882810712 if mask & 4 else None
            self.reserved_presence = mask & 0xF8
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x7: raise rt.Reject
            raw: list[int | float | bytes] = []
            raw.append(self.illuminator_id)
            level_ = self.level
            if not 0.0 <= level_ <= 100.0: raise rt.Reject
            near = level_ * 655.35 + 0.5
            level_raw_ = int(near)
            if not 1.52587890625e-05 < near - level_raw_ < 0.9999847412109375: level_raw_ = rt.exact_raw(level_, _R_2)
            raw.append(level_raw_)
            mode_ = self.mode
            if mode_ is not None:
                mask |= 1
                if mode_ not in _E_ReportVideoIlluminatorConfiguration_Mode and not 4 <= mode_ <= 20 and not 21 <= mode_ <= 31: raise rt.Reject
                raw.append(mode_)
            beam_width_ = self.beam_width
            if beam_width_ is not None:
                mask |= 2
                if not 0.0 <= beam_width_ <= 360.0: raise rt.Reject
                near = beam_width_ * 182.04166666666666 + 0.5
                beam_width_raw_ = int(near)
                if not 1.52587890625e-05 < near - beam_width_raw_ < 0.9999847412109375: beam_width_raw_ = rt.exact_raw(beam_width_, _R_3)
                raw.append(beam_width_raw_)
            beam_height_ = self.beam_height
            if beam_height_ is not None:
                mask |= 4
                if not 0.0 <= beam_height_ <= 360.0: raise rt.Reject
                near = beam_height_ * 182.04166666666666 + 0.5
                beam_height_raw_ = int(near)
                if not 1.52587890625e-05 < near - beam_height_raw_ < 0.9999847412109375: beam_height_raw_ = rt.exact_raw(beam_height_, _R_3)
                raw.append(beam_height_raw_)
            out += _M_SetVideoIlluminatorConfiguration_IlluminatorRec_0[mask & 0x7].pack(*raw)
            _S_B.pack_into(out, start, mask)

    illumination_rec_list: list[ReportVideoIlluminatorConfiguration.IlluminatorRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("IlluminationRecList", rt.Repeat(rt.Count("H", 0, 65535), ReportVideoIlluminatorConfiguration.IlluminatorRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x1A or data[1] != 0x48: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (illumination_rec_list_count_,) = _S_H.unpack_from(data, 2)
        if illumination_rec_list_count_ * 5 > size - 4: raise rt.Reject
        at = 4
        illumination_rec_list_ = []
        for _ in range(illumination_rec_list_count_):
            item_, at = ReportVideoIlluminatorConfiguration.IlluminatorRec._read(data, at, nesting)
            illumination_rec_list_.append(item_)
        self.illumination_rec_list = illumination_rec_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x1a\x48")
        illumination_rec_list_ = self.illumination_rec_list
        if type(illumination_rec_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(illumination_rec_list_))
        for item_ in illumination_rec_list_:
            if type(item_) is not ReportVideoIlluminatorConfiguration.IlluminatorRec: raise rt.Reject
            item_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportVideoIlluminatorCapabilities(rt.Message):
    """ReportVideoIlluminatorCapabilities (0x481B): Tells what lamps can do.

    illuminator_capabilities_list: 0..65535 items. The lamps
    """

    CODE = 0x481B
    NAME = "ReportVideoIlluminatorCapabilities"
    SERVICE = "urn:jaus:jss:environmentSensing:VideoIlluminator"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = False

    class Visible(IntEnum):
        """Values of Visible."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Infrared(IntEnum):
        """Values of Infrared."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class GreyScale(IntEnum):
        """Values of GreyScale."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class LowLight(IntEnum):
        """Values of LowLight."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    @dataclass(slots=True, repr=False)
    class SupportedIlluminationModes(rt.Struct):
        """Kinds of light that the lamp offers.

        visible: bit 0. Visible light.
        infrared: bit 1. Infrared light.
        grey_scale: bit 2. Light for greyscale images.
        low_light: bit 3. Weak light.
        reserved_for_future_use: bits 4..20. Sent as 0, ignored when received.
        reserved_for_program_or_implementation_specific_use: bits 21..31. Of meaning to the maker alone.
        """

        visible: ReportVideoIlluminatorCapabilities.Visible | int
        infrared: ReportVideoIlluminatorCapabilities.Infrared | int
        grey_scale: ReportVideoIlluminatorCapabilities.GreyScale | int
        low_light: ReportVideoIlluminatorCapabilities.LowLight | int
        reserved_for_future_use: int
        reserved_for_program_or_implementation_specific_use: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Bits(
                cls,
                "I",
                (
                    rt.Bit("visible", 0, 0x1, rt.Values(ReportVideoIlluminatorCapabilities.Visible)),
                    rt.Bit("infrared", 1, 0x1, rt.Values(ReportVideoIlluminatorCapabilities.Infrared)),
                    rt.Bit("grey_scale", 2, 0x1, rt.Values(ReportVideoIlluminatorCapabilities.GreyScale)),
                    rt.Bit("low_light", 3, 0x1, rt.Values(ReportVideoIlluminatorCapabilities.LowLight)),
                    rt.Bit("reserved_for_future_use", 4, 0x1FFFF, rt.Values(None, ((0, 1),))),
                    rt.Bit("reserved_for_program_or_implementation_specific_use", 21, 0x7FF, rt.Values(None, ((0, 1),))),
                ),
            )

    @dataclass(slots=True, repr=False)
    class IlluminatorCapabilitiesRec(rt.Struct):
        """IlluminatorCapabilitiesRec.

        illuminator_id: Identifies the lamp
        illuminator_name: up to 255 characters. Name of the lamp, for people
        supported_illumination_modes: Kinds of light that the lamp offers
        minimum_intensity: in lumen, optional. Smallest brightness, in lumens
        maximum_intensity: in lumen, optional. Largest brightness, in lumens
        minimum_supported_beam_width: 0..360 degree, optional. Smallest angle of the beam from left to right, in degrees
        maximum_supported_beam_width: 0..360 degree, optional. Largest angle of the beam from left to right, in degrees
        minimum_supported_beam_height: 0..360 degree, optional. Smallest angle of the beam from top to bottom, in degrees
        maximum_supported_beam_height: 0..360 degree, optional. Largest angle of the beam from top to bottom, in degrees
        """

        illuminator_id: int
        illuminator_name: str
        supported_illumination_modes: ReportVideoIlluminatorCapabilities.SupportedIlluminationModes
        minimum_intensity: int | None = None
        maximum_intensity: int | None = None
        minimum_supported_beam_width: float | None = None
        maximum_supported_beam_width: float | None = None
        minimum_supported_beam_height: float | None = None
        maximum_supported_beam_height: float | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("IlluminatorID", rt.Number("H")),
                ("IlluminatorName", rt.Text(count=rt.Count("B", 0, 255))),
                ("SupportedIlluminationModes", ReportVideoIlluminatorCapabilities.SupportedIlluminationModes.layout()),
                ("MinimumIntensity", rt.Number("H", rt.ANY, "lumen"), True),
                ("MaximumIntensity", rt.Number("H", rt.ANY, "lumen"), True),
                ("MinimumSupportedBeamWidth", rt.real("H", 0.0, 360.0, "degree"), True),
                ("MaximumSupportedBeamWidth", rt.real("H", 0.0, 360.0, "degree"), True),
                ("MinimumSupportedBeamHeight", rt.real("H", 0.0, 360.0, "degree"), True),
                ("MaximumSupportedBeamHeight", rt.real("H", 0.0, 360.0, "degree"), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            (self.illuminator_id,) = _S_H.unpack_from(data, at + 1)
            illuminator_name_end_ = at + 4 + data[at + 3]
            self.illuminator_name = data[at + 4:illuminator_name_end_].decode("latin-1")
            packer = _M_ReportVideoIlluminatorCapabilities_IlluminatorCapabilitiesRec_2[mask & 0x3F]
            raw = iter(packer.unpack_from(data, illuminator_name_end_)).__next__
            at = illuminator_name_end_ + packer.size
            supported_illumination_modes_ = raw()
            reserved_for_future_use_ = supported_illumination_modes_ >> 4 & 0x1FFFF
            if reserved_for_future_use_ > 1: raise rt.Reject
            reserved_for_program_or_implementation_specific_use_ = supported_illumination_modes_ >> 21 & 0x7FF
            if reserved_for_program_or_implementation_specific_use_ > 1: raise rt.Reject
            self.supported_illumination_modes = ReportVideoIlluminatorCapabilities.SupportedIlluminationModes(_E_ReportVideoIlluminatorCapabilities_Visible.get(supported_illumination_modes_ & 0x1, supported_illumination_modes_ & 0x1), _E_ReportVideoIlluminatorCapabilities_Infrared.get(supported_illumination_modes_ >> 1 & 0x1, supported_illumination_modes_ >> 1 & 0x1), _E_ReportVideoIlluminatorCapabilities_GreyScale.get(supported_illumination_modes_ >> 2 & 0x1, supported_illumination_modes_ >> 2 & 0x1), _E_ReportVideoIlluminatorCapabilities_LowLight.get(supported_illumination_modes_ >> 3 & 0x1, supported_illumination_modes_ >> 3 & 0x1), reserved_for_future_use_, reserved_for_program_or_implementation_specific_use_)
            self.minimum_intensity = raw() if mask & 1 else None
            self.maximum_intensity = raw() if mask & 2 else None
            self.minimum_supported_beam_width = raw() * 0.005493247882810712 if mask & 4 else None
            self.maximum_supported_beam_width = raw() * 0.005493247882810712 if mask & 8 else None
            self.minimum_supported_beam_height = raw() * 0.005493247882810712 if mask & 16 else None
            self.maximum_supported_beam_height = raw() * 0.005493247882810712 if mask & 32 else None
            self.reserved_presence = mask & 0xC0
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x3F: raise rt.Reject
            out += _S_H.pack(self.illuminator_id)
            illuminator_name_raw_ = self.illuminator_name.encode("latin-1")
            out.append(len(illuminator_name_raw_))
            out += illuminator_name_raw_
            raw: list[int | float | bytes] = []
            supported_illumination_modes_ = self.supported_illumination_modes
            if type(supported_illumination_modes_) is not ReportVideoIlluminatorCapabilities.SupportedIlluminationModes: raise rt.Reject
            visible_ = supported_illumination_modes_.visible
            if not 0 <= visible_ <= 1: raise rt.Reject
            infrared_ = supported_illumination_modes_.infrared
            if not 0 <= infrared_ <= 1: raise rt.Reject
            grey_scale_ = supported_illumination_modes_.grey_scale
            if not 0 <= grey_scale_ <= 1: raise rt.Reject
            low_light_ = supported_illumination_modes_.low_light
            if not 0 <= low_light_ <= 1: raise rt.Reject
            reserved_for_future_use_ = supported_illumination_modes_.reserved_for_future_use
            if not 0 <= reserved_for_future_use_ <= 1: raise rt.Reject
            reserved_for_program_or_implementation_specific_use_ = supported_illumination_modes_.reserved_for_program_or_implementation_specific_use
            if not 0 <= reserved_for_program_or_implementation_specific_use_ <= 1: raise rt.Reject
            raw.append(visible_ | infrared_ << 1 | grey_scale_ << 2 | low_light_ << 3 | reserved_for_future_use_ << 4 | reserved_for_program_or_implementation_specific_use_ << 21)
            minimum_intensity_ = self.minimum_intensity
            if minimum_intensity_ is not None:
                mask |= 1
                raw.append(minimum_intensity_)
            maximum_intensity_ = self.maximum_intensity
            if maximum_intensity_ is not None:
                mask |= 2
                raw.append(maximum_intensity_)
            minimum_supported_beam_width_ = self.minimum_supported_beam_width
            if minimum_supported_beam_width_ is not None:
                mask |= 4
                if not 0.0 <= minimum_supported_beam_width_ <= 360.0: raise rt.Reject
                near = minimum_supported_beam_width_ * 182.04166666666666 + 0.5
                minimum_supported_beam_width_raw_ = int(near)
                if not 1.52587890625e-05 < near - minimum_supported_beam_width_raw_ < 0.9999847412109375: minimum_supported_beam_width_raw_ = rt.exact_raw(minimum_supported_beam_width_, _R_3)
                raw.append(minimum_supported_beam_width_raw_)
            maximum_supported_beam_width_ = self.maximum_supported_beam_width
            if maximum_supported_beam_width_ is not None:
                mask |= 8
                if not 0.0 <= maximum_supported_beam_width_ <= 360.0: raise rt.Reject
                near = maximum_supported_beam_width_ * 182.04166666666666 + 0.5
                maximum_supported_beam_width_raw_ = int(near)
                if not 1.52587890625e-05 < near - maximum_supported_beam_width_raw_ < 0.9999847412109375: maximum_supported_beam_width_raw_ = rt.exact_raw(maximum_supported_beam_width_, _R_3)
                raw.append(maximum_supported_beam_width_raw_)
            minimum_supported_beam_height_ = self.minimum_supported_beam_height
            if minimum_supported_beam_height_ is not None:
                mask |= 16
                if not 0.0 <= minimum_supported_beam_height_ <= 360.0: raise rt.Reject
                near = minimum_supported_beam_height_ * 182.04166666666666 + 0.5
                minimum_supported_beam_height_raw_ = int(near)
                if not 1.52587890625e-05 < near - minimum_supported_beam_height_raw_ < 0.9999847412109375: minimum_supported_beam_height_raw_ = rt.exact_raw(minimum_supported_beam_height_, _R_3)
                raw.append(minimum_supported_beam_height_raw_)
            maximum_supported_beam_height_ = self.maximum_supported_beam_height
            if maximum_supported_beam_height_ is not None:
                mask |= 32
                if not 0.0 <= maximum_supported_beam_height_ <= 360.0: raise rt.Reject
                near = maximum_supported_beam_height_ * 182.04166666666666 + 0.5
                maximum_supported_beam_height_raw_ = int(near)
                if not 1.52587890625e-05 < near - maximum_supported_beam_height_raw_ < 0.9999847412109375: maximum_supported_beam_height_raw_ = rt.exact_raw(maximum_supported_beam_height_, _R_3)
                raw.append(maximum_supported_beam_height_raw_)
            out += _M_ReportVideoIlluminatorCapabilities_IlluminatorCapabilitiesRec_2[mask & 0x3F].pack(*raw)
            _S_B.pack_into(out, start, mask)

    @dataclass(slots=True, repr=False)
    class SensorIDRec(rt.Struct):
        """One sensor.

        sensor_id: Identifies the sensor
        """

        sensor_id: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("SensorID", rt.Number("H")),
            )

    @dataclass(slots=True, repr=False)
    class IlluminatorCapabilitiesSeq(rt.Struct):
        """IlluminatorCapabilitiesSeq.

        sensor_id_list: 0..255 items. The sensors that the lamp is for
        """

        illuminator_capabilities_rec: ReportVideoIlluminatorCapabilities.IlluminatorCapabilitiesRec
        sensor_id_list: list[ReportVideoIlluminatorCapabilities.SensorIDRec]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("IlluminatorCapabilitiesRec", ReportVideoIlluminatorCapabilities.IlluminatorCapabilitiesRec.layout()),
                ("SensorIDList", rt.Repeat(rt.Count("B", 0, 255), ReportVideoIlluminatorCapabilities.SensorIDRec.layout())),
            )

    illuminator_capabilities_list: list[ReportVideoIlluminatorCapabilities.IlluminatorCapabilitiesSeq]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("IlluminatorCapabilitiesList", rt.Repeat(rt.Count("H", 0, 65535), ReportVideoIlluminatorCapabilities.IlluminatorCapabilitiesSeq.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x1B or data[1] != 0x48: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (illuminator_capabilities_list_count_,) = _S_H.unpack_from(data, 2)
        if illuminator_capabilities_list_count_ * 9 > size - 4: raise rt.Reject
        at = 4
        illuminator_capabilities_list_ = []
        for _ in range(illuminator_capabilities_list_count_):
            item_ = rt.new(ReportVideoIlluminatorCapabilities.IlluminatorCapabilitiesSeq)
            item_.illuminator_capabilities_rec, at = ReportVideoIlluminatorCapabilities.IlluminatorCapabilitiesRec._read(data, at, nesting)
            sensor_id_list_count_ = data[at]
            sensor_id_list_end_ = at + 1 + sensor_id_list_count_ * 2
            item_.sensor_id_list = [ReportVideoIlluminatorCapabilities.SensorIDRec(sensor_id_) for sensor_id_ in _L_H[sensor_id_list_count_].unpack_from(data, at + 1)]
            at = sensor_id_list_end_
            illuminator_capabilities_list_.append(item_)
        self.illuminator_capabilities_list = illuminator_capabilities_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x1b\x48")
        illuminator_capabilities_list_ = self.illuminator_capabilities_list
        if type(illuminator_capabilities_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(illuminator_capabilities_list_))
        for item_ in illuminator_capabilities_list_:
            if type(item_) is not ReportVideoIlluminatorCapabilities.IlluminatorCapabilitiesSeq: raise rt.Reject
            illuminator_capabilities_rec_ = item_.illuminator_capabilities_rec
            if type(illuminator_capabilities_rec_) is not ReportVideoIlluminatorCapabilities.IlluminatorCapabilitiesRec: raise rt.Reject
            illuminator_capabilities_rec_._write(out)
            sensor_id_list_ = item_.sensor_id_list
            if type(sensor_id_list_) is not list: raise rt.Reject
            out.append(len(sensor_id_list_))
            raw_: list[int | float] = []
            for item_2_ in sensor_id_list_:
                if type(item_2_) is not ReportVideoIlluminatorCapabilities.SensorIDRec: raise rt.Reject
                raw_.append(item_2_.sensor_id)
            out += _L_H[len(raw_)].pack(*raw_)
        return bytes(out)


_M_SetVideoIlluminatorConfiguration_IlluminatorRec_0 = rt.Masks("", ((0, "H"), (0, "H"), (1, "B"), (2, "H"), (4, "H")))
_E_SetVideoIlluminatorConfiguration_Mode = rt.members(SetVideoIlluminatorConfiguration.Mode)
_R_2 = rt.Scaling(0.0, 100.0, 65535)
_R_3 = rt.Scaling(0.0, 360.0, 65535)
_S_B = rt.Packer("<B")
_S_H = rt.Packer("<H")
_L_H = rt.Rows("H")
_E_ReportVideoIlluminatorConfiguration_Mode = rt.members(ReportVideoIlluminatorConfiguration.Mode)
_M_ReportVideoIlluminatorCapabilities_IlluminatorCapabilitiesRec_2 = rt.Masks("", ((0, "I"), (1, "H"), (2, "H"), (4, "H"), (8, "H"), (16, "H"), (32, "H")))
_E_ReportVideoIlluminatorCapabilities_Visible = rt.members(ReportVideoIlluminatorCapabilities.Visible)
_E_ReportVideoIlluminatorCapabilities_Infrared = rt.members(ReportVideoIlluminatorCapabilities.Infrared)
_E_ReportVideoIlluminatorCapabilities_GreyScale = rt.members(ReportVideoIlluminatorCapabilities.GreyScale)
_E_ReportVideoIlluminatorCapabilities_LowLight = rt.members(ReportVideoIlluminatorCapabilities.LowLight)
QueryVideoIlluminatorConfiguration.REPORT = ReportVideoIlluminatorConfiguration
QueryVideoIlluminatorCapabilities.REPORT = ReportVideoIlluminatorCapabilities
