"""urn:jaus:jss:ugv:IlluminationService 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt


@dataclass(slots=True, repr=False)
class QueryIlluminationState(rt.Message):
    """QueryIlluminationState (0x2513): Asks which lights are on."""

    CODE = 0x2513
    NAME = "QueryIlluminationState"
    SERVICE = "urn:jaus:jss:ugv:IlluminationService"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportIlluminationState]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x13%': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2513)


@dataclass(slots=True, repr=False)
class QueryIlluminationConfiguration(rt.Message):
    """QueryIlluminationConfiguration (0x2514): Asks which lights there are."""

    CODE = 0x2514
    NAME = "QueryIlluminationConfiguration"
    SERVICE = "urn:jaus:jss:ugv:IlluminationService"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportIlluminationConfiguration]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x14%': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2514)


@dataclass(slots=True, repr=False)
class SetIlluminationState(rt.Message):
    """SetIlluminationState (0x0513): Switches lights.

    illumination: Which lights are on
    """

    CODE = 0x0513
    NAME = "SetIlluminationState"
    SERVICE = "urn:jaus:jss:ugv:IlluminationService"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    class Headlights(IntEnum):
        """Values of Headlights."""

        OFF = 0
        ON = 1

    class LeftTurnSignal(IntEnum):
        """Values of LeftTurnSignal."""

        OFF = 0
        ON = 1

    class RightTurnSignal(IntEnum):
        """Values of RightTurnSignal."""

        OFF = 0
        ON = 1

    class RunningLights(IntEnum):
        """Values of RunningLights."""

        OFF = 0
        ON = 1

    class BrakeLights(IntEnum):
        """Values of BrakeLights."""

        OFF = 0
        ON = 1

    class BackupLights(IntEnum):
        """Values of BackupLights."""

        OFF = 0
        ON = 1

    class VisibleLightSource(IntEnum):
        """Values of VisibleLightSource."""

        OFF = 0
        ON = 1

    class IRLightSource(IntEnum):
        """Values of IRLightSource."""

        OFF = 0
        ON = 1

    class HighBeams(IntEnum):
        """Values of HighBeams."""

        OFF = 0
        ON = 1

    class ParkingLights(IntEnum):
        """Values of ParkingLights."""

        OFF = 0
        ON = 1

    class FogLights(IntEnum):
        """Values of FogLights."""

        OFF = 0
        ON = 1

    class HazardLights(IntEnum):
        """Values of HazardLights."""

        OFF = 0
        ON = 1

    @dataclass(slots=True, repr=False)
    class Illumination(rt.Struct):
        """Which lights are on.

        headlights: bit 0. Headlights.
        left_turn_signal: bit 1. Turn signal on the left.
        right_turn_signal: bit 2. Turn signal on the right.
        running_lights: bit 3. Running lights.
        brake_lights: bit 4. Brake lights.
        backup_lights: bit 5. Lights for driving backward.
        visible_light_source: bit 6. Visible light.
        ir_light_source: bit 7. Infrared light.
        variable_light1: bits 8..11. First light that the maker chooses.
        variable_light2: bits 12..15. Second light that the maker chooses.
        variable_light3: bits 16..19. Third light that the maker chooses.
        variable_light4: bits 20..23. Fourth light that the maker chooses.
        high_beams: bit 24. High beams.
        parking_lights: bit 25. Parking lights.
        fog_lights: bit 26. Fog lights.
        hazard_lights: bit 27. All turn signals together.
        """

        headlights: SetIlluminationState.Headlights | int
        left_turn_signal: SetIlluminationState.LeftTurnSignal | int
        right_turn_signal: SetIlluminationState.RightTurnSignal | int
        running_lights: SetIlluminationState.RunningLights | int
        brake_lights: SetIlluminationState.BrakeLights | int
        backup_lights: SetIlluminationState.BackupLights | int
        visible_light_source: SetIlluminationState.VisibleLightSource | int
        ir_light_source: SetIlluminationState.IRLightSource | int
        variable_light1: int
        variable_light2: int
        variable_light3: int
        variable_light4: int
        high_beams: SetIlluminationState.HighBeams | int
        parking_lights: SetIlluminationState.ParkingLights | int
        fog_lights: SetIlluminationState.FogLights | int
        hazard_lights: SetIlluminationState.HazardLights | int
        reserved_bits: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Bits(
                cls,
                "I",
                (
                    rt.Bit("headlights", 0, 0x1, rt.Values(SetIlluminationState.Headlights)),
                    rt.Bit("left_turn_signal", 1, 0x1, rt.Values(SetIlluminationState.LeftTurnSignal)),
                    rt.Bit("right_turn_signal", 2, 0x1, rt.Values(SetIlluminationState.RightTurnSignal)),
                    rt.Bit("running_lights", 3, 0x1, rt.Values(SetIlluminationState.RunningLights)),
                    rt.Bit("brake_lights", 4, 0x1, rt.Values(SetIlluminationState.BrakeLights)),
                    rt.Bit("backup_lights", 5, 0x1, rt.Values(SetIlluminationState.BackupLights)),
                    rt.Bit("visible_light_source", 6, 0x1, rt.Values(SetIlluminationState.VisibleLightSource)),
                    rt.Bit("ir_light_source", 7, 0x1, rt.Values(SetIlluminationState.IRLightSource)),
                    rt.Bit("variable_light1", 8, 0xF, rt.Values(None, ((0, 15),))),
                    rt.Bit("variable_light2", 12, 0xF, rt.Values(None, ((0, 15),))),
                    rt.Bit("variable_light3", 16, 0xF, rt.Values(None, ((0, 15),))),
                    rt.Bit("variable_light4", 20, 0xF, rt.Values(None, ((0, 15),))),
                    rt.Bit("high_beams", 24, 0x1, rt.Values(SetIlluminationState.HighBeams)),
                    rt.Bit("parking_lights", 25, 0x1, rt.Values(SetIlluminationState.ParkingLights)),
                    rt.Bit("fog_lights", 26, 0x1, rt.Values(SetIlluminationState.FogLights)),
                    rt.Bit("hazard_lights", 27, 0x1, rt.Values(SetIlluminationState.HazardLights)),
                ),
            )

    illumination: SetIlluminationState.Illumination

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("illumination", SetIlluminationState.Illumination.layout()),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, illumination_ = _S_HI.unpack(data)
        if code != 0x0513: raise rt.Reject
        self.illumination = SetIlluminationState.Illumination(_E_SetIlluminationState_Headlights.get(illumination_ & 0x1, illumination_ & 0x1), _E_SetIlluminationState_LeftTurnSignal.get(illumination_ >> 1 & 0x1, illumination_ >> 1 & 0x1), _E_SetIlluminationState_RightTurnSignal.get(illumination_ >> 2 & 0x1, illumination_ >> 2 & 0x1), _E_SetIlluminationState_RunningLights.get(illumination_ >> 3 & 0x1, illumination_ >> 3 & 0x1), _E_SetIlluminationState_BrakeLights.get(illumination_ >> 4 & 0x1, illumination_ >> 4 & 0x1), _E_SetIlluminationState_BackupLights.get(illumination_ >> 5 & 0x1, illumination_ >> 5 & 0x1), _E_SetIlluminationState_VisibleLightSource.get(illumination_ >> 6 & 0x1, illumination_ >> 6 & 0x1), _E_SetIlluminationState_IRLightSource.get(illumination_ >> 7 & 0x1, illumination_ >> 7 & 0x1), illumination_ >> 8 & 0xF, illumination_ >> 12 & 0xF, illumination_ >> 16 & 0xF, illumination_ >> 20 & 0xF, _E_SetIlluminationState_HighBeams.get(illumination_ >> 24 & 0x1, illumination_ >> 24 & 0x1), _E_SetIlluminationState_ParkingLights.get(illumination_ >> 25 & 0x1, illumination_ >> 25 & 0x1), _E_SetIlluminationState_FogLights.get(illumination_ >> 26 & 0x1, illumination_ >> 26 & 0x1), _E_SetIlluminationState_HazardLights.get(illumination_ >> 27 & 0x1, illumination_ >> 27 & 0x1), illumination_ & 0xF0000000)
        return self

    def _pack(self) -> bytes:
        illumination_ = self.illumination
        if type(illumination_) is not SetIlluminationState.Illumination: raise rt.Reject
        headlights_ = illumination_.headlights
        if not 0 <= headlights_ <= 1: raise rt.Reject
        left_turn_signal_ = illumination_.left_turn_signal
        if not 0 <= left_turn_signal_ <= 1: raise rt.Reject
        right_turn_signal_ = illumination_.right_turn_signal
        if not 0 <= right_turn_signal_ <= 1: raise rt.Reject
        running_lights_ = illumination_.running_lights
        if not 0 <= running_lights_ <= 1: raise rt.Reject
        brake_lights_ = illumination_.brake_lights
        if not 0 <= brake_lights_ <= 1: raise rt.Reject
        backup_lights_ = illumination_.backup_lights
        if not 0 <= backup_lights_ <= 1: raise rt.Reject
        visible_light_source_ = illumination_.visible_light_source
        if not 0 <= visible_light_source_ <= 1: raise rt.Reject
        ir_light_source_ = illumination_.ir_light_source
        if not 0 <= ir_light_source_ <= 1: raise rt.Reject
        variable_light1_ = illumination_.variable_light1
        if not 0 <= variable_light1_ <= 15: raise rt.Reject
        variable_light2_ = illumination_.variable_light2
        if not 0 <= variable_light2_ <= 15: raise rt.Reject
        variable_light3_ = illumination_.variable_light3
        if not 0 <= variable_light3_ <= 15: raise rt.Reject
        variable_light4_ = illumination_.variable_light4
        if not 0 <= variable_light4_ <= 15: raise rt.Reject
        high_beams_ = illumination_.high_beams
        if not 0 <= high_beams_ <= 1: raise rt.Reject
        parking_lights_ = illumination_.parking_lights
        if not 0 <= parking_lights_ <= 1: raise rt.Reject
        fog_lights_ = illumination_.fog_lights
        if not 0 <= fog_lights_ <= 1: raise rt.Reject
        hazard_lights_ = illumination_.hazard_lights
        if not 0 <= hazard_lights_ <= 1: raise rt.Reject
        reserved_bits_ = illumination_.reserved_bits
        if reserved_bits_ & 0xFFFFFFF: raise rt.Reject
        return _S_HI.pack(0x0513, headlights_ | left_turn_signal_ << 1 | right_turn_signal_ << 2 | running_lights_ << 3 | brake_lights_ << 4 | backup_lights_ << 5 | visible_light_source_ << 6 | ir_light_source_ << 7 | variable_light1_ << 8 | variable_light2_ << 12 | variable_light3_ << 16 | variable_light4_ << 20 | high_beams_ << 24 | parking_lights_ << 25 | fog_lights_ << 26 | hazard_lights_ << 27 | reserved_bits_)


@dataclass(slots=True, repr=False)
class ReportIlluminationState(rt.Message):
    """ReportIlluminationState (0x4513): Tells which lights are on.

    illumination: Which lights are on
    """

    CODE = 0x4513
    NAME = "ReportIlluminationState"
    SERVICE = "urn:jaus:jss:ugv:IlluminationService"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    class Headlights(IntEnum):
        """Values of Headlights."""

        OFF = 0
        ON = 1

    class LeftTurnSignal(IntEnum):
        """Values of LeftTurnSignal."""

        OFF = 0
        ON = 1

    class RightTurnSignal(IntEnum):
        """Values of RightTurnSignal."""

        OFF = 0
        ON = 1

    class RunningLights(IntEnum):
        """Values of RunningLights."""

        OFF = 0
        ON = 1

    class BrakeLights(IntEnum):
        """Values of BrakeLights."""

        OFF = 0
        ON = 1

    class BackupLights(IntEnum):
        """Values of BackupLights."""

        OFF = 0
        ON = 1

    class VisibleLightSource(IntEnum):
        """Values of VisibleLightSource."""

        OFF = 0
        ON = 1

    class IRLightSource(IntEnum):
        """Values of IRLightSource."""

        OFF = 0
        ON = 1

    class HighBeams(IntEnum):
        """Values of HighBeams."""

        OFF = 0
        ON = 1

    class ParkingLights(IntEnum):
        """Values of ParkingLights."""

        OFF = 0
        ON = 1

    class FogLights(IntEnum):
        """Values of FogLights."""

        OFF = 0
        ON = 1

    class HazardLights(IntEnum):
        """Values of HazardLights."""

        OFF = 0
        ON = 1

    @dataclass(slots=True, repr=False)
    class Illumination(rt.Struct):
        """Which lights are on.

        headlights: bit 0. Headlights.
        left_turn_signal: bit 1. Turn signal on the left.
        right_turn_signal: bit 2. Turn signal on the right.
        running_lights: bit 3. Running lights.
        brake_lights: bit 4. Brake lights.
        backup_lights: bit 5. Lights for driving backward.
        visible_light_source: bit 6. Visible light.
        ir_light_source: bit 7. Infrared light.
        variable_light1: bits 8..11. First light that the maker chooses.
        variable_light2: bits 12..15. Second light that the maker chooses.
        variable_light3: bits 16..19. Third light that the maker chooses.
        variable_light4: bits 20..23. Fourth light that the maker chooses.
        high_beams: bit 24. High beams.
        parking_lights: bit 25. Parking lights.
        fog_lights: bit 26. Fog lights.
        hazard_lights: bit 27. All turn signals together.
        """

        headlights: ReportIlluminationState.Headlights | int
        left_turn_signal: ReportIlluminationState.LeftTurnSignal | int
        right_turn_signal: ReportIlluminationState.RightTurnSignal | int
        running_lights: ReportIlluminationState.RunningLights | int
        brake_lights: ReportIlluminationState.BrakeLights | int
        backup_lights: ReportIlluminationState.BackupLights | int
        visible_light_source: ReportIlluminationState.VisibleLightSource | int
        ir_light_source: ReportIlluminationState.IRLightSource | int
        variable_light1: int
        variable_light2: int
        variable_light3: int
        variable_light4: int
        high_beams: ReportIlluminationState.HighBeams | int
        parking_lights: ReportIlluminationState.ParkingLights | int
        fog_lights: ReportIlluminationState.FogLights | int
        hazard_lights: ReportIlluminationState.HazardLights | int
        reserved_bits: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Bits(
                cls,
                "I",
                (
                    rt.Bit("headlights", 0, 0x1, rt.Values(ReportIlluminationState.Headlights)),
                    rt.Bit("left_turn_signal", 1, 0x1, rt.Values(ReportIlluminationState.LeftTurnSignal)),
                    rt.Bit("right_turn_signal", 2, 0x1, rt.Values(ReportIlluminationState.RightTurnSignal)),
                    rt.Bit("running_lights", 3, 0x1, rt.Values(ReportIlluminationState.RunningLights)),
                    rt.Bit("brake_lights", 4, 0x1, rt.Values(ReportIlluminationState.BrakeLights)),
                    rt.Bit("backup_lights", 5, 0x1, rt.Values(ReportIlluminationState.BackupLights)),
                    rt.Bit("visible_light_source", 6, 0x1, rt.Values(ReportIlluminationState.VisibleLightSource)),
                    rt.Bit("ir_light_source", 7, 0x1, rt.Values(ReportIlluminationState.IRLightSource)),
                    rt.Bit("variable_light1", 8, 0xF, rt.Values(None, ((0, 15),))),
                    rt.Bit("variable_light2", 12, 0xF, rt.Values(None, ((0, 15),))),
                    rt.Bit("variable_light3", 16, 0xF, rt.Values(None, ((0, 15),))),
                    rt.Bit("variable_light4", 20, 0xF, rt.Values(None, ((0, 15),))),
                    rt.Bit("high_beams", 24, 0x1, rt.Values(ReportIlluminationState.HighBeams)),
                    rt.Bit("parking_lights", 25, 0x1, rt.Values(ReportIlluminationState.ParkingLights)),
                    rt.Bit("fog_lights", 26, 0x1, rt.Values(ReportIlluminationState.FogLights)),
                    rt.Bit("hazard_lights", 27, 0x1, rt.Values(ReportIlluminationState.HazardLights)),
                ),
            )

    illumination: ReportIlluminationState.Illumination

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("illumination", ReportIlluminationState.Illumination.layout()),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, illumination_ = _S_HI.unpack(data)
        if code != 0x4513: raise rt.Reject
        self.illumination = ReportIlluminationState.Illumination(_E_ReportIlluminationState_Headlights.get(illumination_ & 0x1, illumination_ & 0x1), _E_ReportIlluminationState_LeftTurnSignal.get(illumination_ >> 1 & 0x1, illumination_ >> 1 & 0x1), _E_ReportIlluminationState_RightTurnSignal.get(illumination_ >> 2 & 0x1, illumination_ >> 2 & 0x1), _E_ReportIlluminationState_RunningLights.get(illumination_ >> 3 & 0x1, illumination_ >> 3 & 0x1), _E_ReportIlluminationState_BrakeLights.get(illumination_ >> 4 & 0x1, illumination_ >> 4 & 0x1), _E_ReportIlluminationState_BackupLights.get(illumination_ >> 5 & 0x1, illumination_ >> 5 & 0x1), _E_ReportIlluminationState_VisibleLightSource.get(illumination_ >> 6 & 0x1, illumination_ >> 6 & 0x1), _E_ReportIlluminationState_IRLightSource.get(illumination_ >> 7 & 0x1, illumination_ >> 7 & 0x1), illumination_ >> 8 & 0xF, illumination_ >> 12 & 0xF, illumination_ >> 16 & 0xF, illumination_ >> 20 & 0xF, _E_ReportIlluminationState_HighBeams.get(illumination_ >> 24 & 0x1, illumination_ >> 24 & 0x1), _E_ReportIlluminationState_ParkingLights.get(illumination_ >> 25 & 0x1, illumination_ >> 25 & 0x1), _E_ReportIlluminationState_FogLights.get(illumination_ >> 26 & 0x1, illumination_ >> 26 & 0x1), _E_ReportIlluminationState_HazardLights.get(illumination_ >> 27 & 0x1, illumination_ >> 27 & 0x1), illumination_ & 0xF0000000)
        return self

    def _pack(self) -> bytes:
        illumination_ = self.illumination
        if type(illumination_) is not ReportIlluminationState.Illumination: raise rt.Reject
        headlights_ = illumination_.headlights
        if not 0 <= headlights_ <= 1: raise rt.Reject
        left_turn_signal_ = illumination_.left_turn_signal
        if not 0 <= left_turn_signal_ <= 1: raise rt.Reject
        right_turn_signal_ = illumination_.right_turn_signal
        if not 0 <= right_turn_signal_ <= 1: raise rt.Reject
        running_lights_ = illumination_.running_lights
        if not 0 <= running_lights_ <= 1: raise rt.Reject
        brake_lights_ = illumination_.brake_lights
        if not 0 <= brake_lights_ <= 1: raise rt.Reject
        backup_lights_ = illumination_.backup_lights
        if not 0 <= backup_lights_ <= 1: raise rt.Reject
        visible_light_source_ = illumination_.visible_light_source
        if not 0 <= visible_light_source_ <= 1: raise rt.Reject
        ir_light_source_ = illumination_.ir_light_source
        if not 0 <= ir_light_source_ <= 1: raise rt.Reject
        variable_light1_ = illumination_.variable_light1
        if not 0 <= variable_light1_ <= 15: raise rt.Reject
        variable_light2_ = illumination_.variable_light2
        if not 0 <= variable_light2_ <= 15: raise rt.Reject
        variable_light3_ = illumination_.variable_light3
        if not 0 <= variable_light3_ <= 15: raise rt.Reject
        variable_light4_ = illumination_.variable_light4
        if not 0 <= variable_light4_ <= 15: raise rt.Reject
        high_beams_ = illumination_.high_beams
        if not 0 <= high_beams_ <= 1: raise rt.Reject
        parking_lights_ = illumination_.parking_lights
        if not 0 <= parking_lights_ <= 1: raise rt.Reject
        fog_lights_ = illumination_.fog_lights
        if not 0 <= fog_lights_ <= 1: raise rt.Reject
        hazard_lights_ = illumination_.hazard_lights
        if not 0 <= hazard_lights_ <= 1: raise rt.Reject
        reserved_bits_ = illumination_.reserved_bits
        if reserved_bits_ & 0xFFFFFFF: raise rt.Reject
        return _S_HI.pack(0x4513, headlights_ | left_turn_signal_ << 1 | right_turn_signal_ << 2 | running_lights_ << 3 | brake_lights_ << 4 | backup_lights_ << 5 | visible_light_source_ << 6 | ir_light_source_ << 7 | variable_light1_ << 8 | variable_light2_ << 12 | variable_light3_ << 16 | variable_light4_ << 20 | high_beams_ << 24 | parking_lights_ << 25 | fog_lights_ << 26 | hazard_lights_ << 27 | reserved_bits_)


@dataclass(slots=True, repr=False)
class ReportIlluminationConfiguration(rt.Message):
    """ReportIlluminationConfiguration (0x4514): Tells which lights there are.

    types: Lights that the platform has
    """

    CODE = 0x4514
    NAME = "ReportIlluminationConfiguration"
    SERVICE = "urn:jaus:jss:ugv:IlluminationService"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    class Headlights(IntEnum):
        """Values of Headlights."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class LeftTurnSignal(IntEnum):
        """Values of LeftTurnSignal."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class RightTurnSignal(IntEnum):
        """Values of RightTurnSignal."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class RunningLights(IntEnum):
        """Values of RunningLights."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class BrakeLights(IntEnum):
        """Values of BrakeLights."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class BackupLights(IntEnum):
        """Values of BackupLights."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class VisibleLightSource(IntEnum):
        """Values of VisibleLightSource."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class IRLightSource(IntEnum):
        """Values of IRLightSource."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class VariableLight1(IntEnum):
        """Values of VariableLight1."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class VariableLight2(IntEnum):
        """Values of VariableLight2."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class VariableLight3(IntEnum):
        """Values of VariableLight3."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class VariableLight4(IntEnum):
        """Values of VariableLight4."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class HighBeams(IntEnum):
        """Values of HighBeams."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class ParkingLights(IntEnum):
        """Values of ParkingLights."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class FogLights(IntEnum):
        """Values of FogLights."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class HazardLights(IntEnum):
        """Values of HazardLights."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    @dataclass(slots=True, repr=False)
    class Types(rt.Struct):
        """Lights that the platform has.

        headlights: bit 0. Headlights.
        left_turn_signal: bit 1. Turn signal on the left.
        right_turn_signal: bit 2. Turn signal on the right.
        running_lights: bit 3. Running lights.
        brake_lights: bit 4. Brake lights.
        backup_lights: bit 5. Lights for driving backward.
        visible_light_source: bit 6. Visible light.
        ir_light_source: bit 7. Infrared light.
        variable_light1: bit 8. First light that the maker chooses.
        variable_light2: bit 9. Second light that the maker chooses.
        variable_light3: bit 10. Third light that the maker chooses.
        variable_light4: bit 11. Fourth light that the maker chooses.
        high_beams: bit 12. High beams.
        parking_lights: bit 13. Parking lights.
        fog_lights: bit 14. Fog lights.
        hazard_lights: bit 15. All turn signals together.
        """

        headlights: ReportIlluminationConfiguration.Headlights | int
        left_turn_signal: ReportIlluminationConfiguration.LeftTurnSignal | int
        right_turn_signal: ReportIlluminationConfiguration.RightTurnSignal | int
        running_lights: ReportIlluminationConfiguration.RunningLights | int
        brake_lights: ReportIlluminationConfiguration.BrakeLights | int
        backup_lights: ReportIlluminationConfiguration.BackupLights | int
        visible_light_source: ReportIlluminationConfiguration.VisibleLightSource | int
        ir_light_source: ReportIlluminationConfiguration.IRLightSource | int
        variable_light1: ReportIlluminationConfiguration.VariableLight1 | int
        variable_light2: ReportIlluminationConfiguration.VariableLight2 | int
        variable_light3: ReportIlluminationConfiguration.VariableLight3 | int
        variable_light4: ReportIlluminationConfiguration.VariableLight4 | int
        high_beams: ReportIlluminationConfiguration.HighBeams | int
        parking_lights: ReportIlluminationConfiguration.ParkingLights | int
        fog_lights: ReportIlluminationConfiguration.FogLights | int
        hazard_lights: ReportIlluminationConfiguration.HazardLights | int
        reserved_bits: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Bits(
                cls,
                "I",
                (
                    rt.Bit("headlights", 0, 0x1, rt.Values(ReportIlluminationConfiguration.Headlights)),
                    rt.Bit("left_turn_signal", 1, 0x1, rt.Values(ReportIlluminationConfiguration.LeftTurnSignal)),
                    rt.Bit("right_turn_signal", 2, 0x1, rt.Values(ReportIlluminationConfiguration.RightTurnSignal)),
                    rt.Bit("running_lights", 3, 0x1, rt.Values(ReportIlluminationConfiguration.RunningLights)),
                    rt.Bit("brake_lights", 4, 0x1, rt.Values(ReportIlluminationConfiguration.BrakeLights)),
                    rt.Bit("backup_lights", 5, 0x1, rt.Values(ReportIlluminationConfiguration.BackupLights)),
                    rt.Bit("visible_light_source", 6, 0x1, rt.Values(ReportIlluminationConfiguration.VisibleLightSource)),
                    rt.Bit("ir_light_source", 7, 0x1, rt.Values(ReportIlluminationConfiguration.IRLightSource)),
                    rt.Bit("variable_light1", 8, 0x1, rt.Values(ReportIlluminationConfiguration.VariableLight1)),
                    rt.Bit("variable_light2", 9, 0x1, rt.Values(ReportIlluminationConfiguration.VariableLight2)),
                    rt.Bit("variable_light3", 10, 0x1, rt.Values(ReportIlluminationConfiguration.VariableLight3)),
                    rt.Bit("variable_light4", 11, 0x1, rt.Values(ReportIlluminationConfiguration.VariableLight4)),
                    rt.Bit("high_beams", 12, 0x1, rt.Values(ReportIlluminationConfiguration.HighBeams)),
                    rt.Bit("parking_lights", 13, 0x1, rt.Values(ReportIlluminationConfiguration.ParkingLights)),
                    rt.Bit("fog_lights", 14, 0x1, rt.Values(ReportIlluminationConfiguration.FogLights)),
                    rt.Bit("hazard_lights", 15, 0x1, rt.Values(ReportIlluminationConfiguration.HazardLights)),
                ),
            )

    types: ReportIlluminationConfiguration.Types

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("types", ReportIlluminationConfiguration.Types.layout()),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, types_ = _S_HI.unpack(data)
        if code != 0x4514: raise rt.Reject
        self.types = ReportIlluminationConfiguration.Types(_E_ReportIlluminationConfiguration_Headlights.get(types_ & 0x1, types_ & 0x1), _E_ReportIlluminationConfiguration_LeftTurnSignal.get(types_ >> 1 & 0x1, types_ >> 1 & 0x1), _E_ReportIlluminationConfiguration_RightTurnSignal.get(types_ >> 2 & 0x1, types_ >> 2 & 0x1), _E_ReportIlluminationConfiguration_RunningLights.get(types_ >> 3 & 0x1, types_ >> 3 & 0x1), _E_ReportIlluminationConfiguration_BrakeLights.get(types_ >> 4 & 0x1, types_ >> 4 & 0x1), _E_ReportIlluminationConfiguration_BackupLights.get(types_ >> 5 & 0x1, types_ >> 5 & 0x1), _E_ReportIlluminationConfiguration_VisibleLightSource.get(types_ >> 6 & 0x1, types_ >> 6 & 0x1), _E_ReportIlluminationConfiguration_IRLightSource.get(types_ >> 7 & 0x1, types_ >> 7 & 0x1), _E_ReportIlluminationConfiguration_VariableLight1.get(types_ >> 8 & 0x1, types_ >> 8 & 0x1), _E_ReportIlluminationConfiguration_VariableLight2.get(types_ >> 9 & 0x1, types_ >> 9 & 0x1), _E_ReportIlluminationConfiguration_VariableLight3.get(types_ >> 10 & 0x1, types_ >> 10 & 0x1), _E_ReportIlluminationConfiguration_VariableLight4.get(types_ >> 11 & 0x1, types_ >> 11 & 0x1), _E_ReportIlluminationConfiguration_HighBeams.get(types_ >> 12 & 0x1, types_ >> 12 & 0x1), _E_ReportIlluminationConfiguration_ParkingLights.get(types_ >> 13 & 0x1, types_ >> 13 & 0x1), _E_ReportIlluminationConfiguration_FogLights.get(types_ >> 14 & 0x1, types_ >> 14 & 0x1), _E_ReportIlluminationConfiguration_HazardLights.get(types_ >> 15 & 0x1, types_ >> 15 & 0x1), types_ & 0xFFFF0000)
        return self

    def _pack(self) -> bytes:
        types_ = self.types
        if type(types_) is not ReportIlluminationConfiguration.Types: raise rt.Reject
        headlights_ = types_.headlights
        if not 0 <= headlights_ <= 1: raise rt.Reject
        left_turn_signal_ = types_.left_turn_signal
        if not 0 <= left_turn_signal_ <= 1: raise rt.Reject
        right_turn_signal_ = types_.right_turn_signal
        if not 0 <= right_turn_signal_ <= 1: raise rt.Reject
        running_lights_ = types_.running_lights
        if not 0 <= running_lights_ <= 1: raise rt.Reject
        brake_lights_ = types_.brake_lights
        if not 0 <= brake_lights_ <= 1: raise rt.Reject
        backup_lights_ = types_.backup_lights
        if not 0 <= backup_lights_ <= 1: raise rt.Reject
        visible_light_source_ = types_.visible_light_source
        if not 0 <= visible_light_source_ <= 1: raise rt.Reject
        ir_light_source_ = types_.ir_light_source
        if not 0 <= ir_light_source_ <= 1: raise rt.Reject
        variable_light1_ = types_.variable_light1
        if not 0 <= variable_light1_ <= 1: raise rt.Reject
        variable_light2_ = types_.variable_light2
        if not 0 <= variable_light2_ <= 1: raise rt.Reject
        variable_light3_ = types_.variable_light3
        if not 0 <= variable_light3_ <= 1: raise rt.Reject
        variable_light4_ = types_.variable_light4
        if not 0 <= variable_light4_ <= 1: raise rt.Reject
        high_beams_ = types_.high_beams
        if not 0 <= high_beams_ <= 1: raise rt.Reject
        parking_lights_ = types_.parking_lights
        if not 0 <= parking_lights_ <= 1: raise rt.Reject
        fog_lights_ = types_.fog_lights
        if not 0 <= fog_lights_ <= 1: raise rt.Reject
        hazard_lights_ = types_.hazard_lights
        if not 0 <= hazard_lights_ <= 1: raise rt.Reject
        reserved_bits_ = types_.reserved_bits
        if reserved_bits_ & 0xFFFF: raise rt.Reject
        return _S_HI.pack(0x4514, headlights_ | left_turn_signal_ << 1 | right_turn_signal_ << 2 | running_lights_ << 3 | brake_lights_ << 4 | backup_lights_ << 5 | visible_light_source_ << 6 | ir_light_source_ << 7 | variable_light1_ << 8 | variable_light2_ << 9 | variable_light3_ << 10 | variable_light4_ << 11 | high_beams_ << 12 | parking_lights_ << 13 | fog_lights_ << 14 | hazard_lights_ << 15 | reserved_bits_)


_S_H = rt.Packer("<H")
_E_SetIlluminationState_Headlights = rt.members(SetIlluminationState.Headlights)
_E_SetIlluminationState_LeftTurnSignal = rt.members(SetIlluminationState.LeftTurnSignal)
_E_SetIlluminationState_RightTurnSignal = rt.members(SetIlluminationState.RightTurnSignal)
_E_SetIlluminationState_RunningLights = rt.members(SetIlluminationState.RunningLights)
_E_SetIlluminationState_BrakeLights = rt.members(SetIlluminationState.BrakeLights)
_E_SetIlluminationState_BackupLights = rt.members(SetIlluminationState.BackupLights)
_E_SetIlluminationState_VisibleLightSource = rt.members(SetIlluminationState.VisibleLightSource)
_E_SetIlluminationState_IRLightSource = rt.members(SetIlluminationState.IRLightSource)
_E_SetIlluminationState_HighBeams = rt.members(SetIlluminationState.HighBeams)
_E_SetIlluminationState_ParkingLights = rt.members(SetIlluminationState.ParkingLights)
_E_SetIlluminationState_FogLights = rt.members(SetIlluminationState.FogLights)
_E_SetIlluminationState_HazardLights = rt.members(SetIlluminationState.HazardLights)
_S_HI = rt.Packer("<HI")
_E_ReportIlluminationState_Headlights = rt.members(ReportIlluminationState.Headlights)
_E_ReportIlluminationState_LeftTurnSignal = rt.members(ReportIlluminationState.LeftTurnSignal)
_E_ReportIlluminationState_RightTurnSignal = rt.members(ReportIlluminationState.RightTurnSignal)
_E_ReportIlluminationState_RunningLights = rt.members(ReportIlluminationState.RunningLights)
_E_ReportIlluminationState_BrakeLights = rt.members(ReportIlluminationState.BrakeLights)
_E_ReportIlluminationState_BackupLights = rt.members(ReportIlluminationState.BackupLights)
_E_ReportIlluminationState_VisibleLightSource = rt.members(ReportIlluminationState.VisibleLightSource)
_E_ReportIlluminationState_IRLightSource = rt.members(ReportIlluminationState.IRLightSource)
_E_ReportIlluminationState_HighBeams = rt.members(ReportIlluminationState.HighBeams)
_E_ReportIlluminationState_ParkingLights = rt.members(ReportIlluminationState.ParkingLights)
_E_ReportIlluminationState_FogLights = rt.members(ReportIlluminationState.FogLights)
_E_ReportIlluminationState_HazardLights = rt.members(ReportIlluminationState.HazardLights)
_E_ReportIlluminationConfiguration_Headlights = rt.members(ReportIlluminationConfiguration.Headlights)
_E_ReportIlluminationConfiguration_LeftTurnSignal = rt.members(ReportIlluminationConfiguration.LeftTurnSignal)
_E_ReportIlluminationConfiguration_RightTurnSignal = rt.members(ReportIlluminationConfiguration.RightTurnSignal)
_E_ReportIlluminationConfiguration_RunningLights = rt.members(ReportIlluminationConfiguration.RunningLights)
_E_ReportIlluminationConfiguration_BrakeLights = rt.members(ReportIlluminationConfiguration.BrakeLights)
_E_ReportIlluminationConfiguration_BackupLights = rt.members(ReportIlluminationConfiguration.BackupLights)
_E_ReportIlluminationConfiguration_VisibleLightSource = rt.members(ReportIlluminationConfiguration.VisibleLightSource)
_E_ReportIlluminationConfiguration_IRLightSource = rt.members(ReportIlluminationConfiguration.IRLightSource)
_E_ReportIlluminationConfiguration_VariableLight1 = rt.members(ReportIlluminationConfiguration.VariableLight1)
_E_ReportIlluminationConfiguration_VariableLight2 = rt.members(ReportIlluminationConfiguration.VariableLight2)
_E_ReportIlluminationConfiguration_VariableLight3 = rt.members(ReportIlluminationConfiguration.VariableLight3)
_E_ReportIlluminationConfiguration_VariableLight4 = rt.members(ReportIlluminationConfiguration.VariableLight4)
_E_ReportIlluminationConfiguration_HighBeams = rt.members(ReportIlluminationConfiguration.HighBeams)
_E_ReportIlluminationConfiguration_ParkingLights = rt.members(ReportIlluminationConfiguration.ParkingLights)
_E_ReportIlluminationConfiguration_FogLights = rt.members(ReportIlluminationConfiguration.FogLights)
_E_ReportIlluminationConfiguration_HazardLights = rt.members(ReportIlluminationConfiguration.HazardLights)
QueryIlluminationState.REPORT = ReportIlluminationState
QueryIlluminationConfiguration.REPORT = ReportIlluminationConfiguration
