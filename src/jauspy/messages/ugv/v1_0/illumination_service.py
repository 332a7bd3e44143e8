"""urn:jaus:jss:ugv:IlluminationService 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:ugv:IlluminationService", "1.0")


@jd.message(_SERVICE, 0x4513)
class ReportIlluminationState(jd.Message):
    """ReportIlluminationState (0x4513): Tells which lights are on.

    illumination: Which lights are on
    """

    class Headlights(IntEnum):
        OFF = 0
        ON = 1

    class LeftTurnSignal(IntEnum):
        OFF = 0
        ON = 1

    class RightTurnSignal(IntEnum):
        OFF = 0
        ON = 1

    class RunningLights(IntEnum):
        OFF = 0
        ON = 1

    class BrakeLights(IntEnum):
        OFF = 0
        ON = 1

    class BackupLights(IntEnum):
        OFF = 0
        ON = 1

    class VisibleLightSource(IntEnum):
        OFF = 0
        ON = 1

    class IRLightSource(IntEnum):
        OFF = 0
        ON = 1

    class HighBeams(IntEnum):
        OFF = 0
        ON = 1

    class ParkingLights(IntEnum):
        OFF = 0
        ON = 1

    class FogLights(IntEnum):
        OFF = 0
        ON = 1

    class HazardLights(IntEnum):
        OFF = 0
        ON = 1

    @jd.bit_field("I")
    class Illumination(jd.Struct):
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
        headlights: ReportIlluminationState.Headlights | int = jd.bits(0, 0x1, lambda: jd.Values(ReportIlluminationState.Headlights))
        left_turn_signal: ReportIlluminationState.LeftTurnSignal | int = jd.bits(1, 0x1, lambda: jd.Values(ReportIlluminationState.LeftTurnSignal))
        right_turn_signal: ReportIlluminationState.RightTurnSignal | int = jd.bits(2, 0x1, lambda: jd.Values(ReportIlluminationState.RightTurnSignal))
        running_lights: ReportIlluminationState.RunningLights | int = jd.bits(3, 0x1, lambda: jd.Values(ReportIlluminationState.RunningLights))
        brake_lights: ReportIlluminationState.BrakeLights | int = jd.bits(4, 0x1, lambda: jd.Values(ReportIlluminationState.BrakeLights))
        backup_lights: ReportIlluminationState.BackupLights | int = jd.bits(5, 0x1, lambda: jd.Values(ReportIlluminationState.BackupLights))
        visible_light_source: ReportIlluminationState.VisibleLightSource | int = jd.bits(6, 0x1, lambda: jd.Values(ReportIlluminationState.VisibleLightSource))
        ir_light_source: ReportIlluminationState.IRLightSource | int = jd.bits(7, 0x1, lambda: jd.Values(ReportIlluminationState.IRLightSource))
        variable_light1: int = jd.bits(8, 0xF, jd.Values(None, ((0, 15),)))
        variable_light2: int = jd.bits(12, 0xF, jd.Values(None, ((0, 15),)))
        variable_light3: int = jd.bits(16, 0xF, jd.Values(None, ((0, 15),)))
        variable_light4: int = jd.bits(20, 0xF, jd.Values(None, ((0, 15),)))
        high_beams: ReportIlluminationState.HighBeams | int = jd.bits(24, 0x1, lambda: jd.Values(ReportIlluminationState.HighBeams))
        parking_lights: ReportIlluminationState.ParkingLights | int = jd.bits(25, 0x1, lambda: jd.Values(ReportIlluminationState.ParkingLights))
        fog_lights: ReportIlluminationState.FogLights | int = jd.bits(26, 0x1, lambda: jd.Values(ReportIlluminationState.FogLights))
        hazard_lights: ReportIlluminationState.HazardLights | int = jd.bits(27, 0x1, lambda: jd.Values(ReportIlluminationState.HazardLights))
        reserved_bits: int = 0

    illumination: ReportIlluminationState.Illumination = jd.field("illumination", lambda: ReportIlluminationState.Illumination.layout())


@jd.message(_SERVICE, 0x2513, query=True)
class QueryIlluminationState(jd.Message):
    """QueryIlluminationState (0x2513): Asks which lights are on."""
    REPORT = ReportIlluminationState


@jd.message(_SERVICE, 0x4514)
class ReportIlluminationConfiguration(jd.Message):
    """ReportIlluminationConfiguration (0x4514): Tells which lights there are.

    types: Lights that the platform has
    """

    class Headlights(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class LeftTurnSignal(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class RightTurnSignal(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class RunningLights(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class BrakeLights(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class BackupLights(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class VisibleLightSource(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class IRLightSource(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class VariableLight1(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class VariableLight2(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class VariableLight3(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class VariableLight4(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class HighBeams(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class ParkingLights(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class FogLights(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class HazardLights(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    @jd.bit_field("I")
    class Types(jd.Struct):
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
        headlights: ReportIlluminationConfiguration.Headlights | int = jd.bits(0, 0x1, lambda: jd.Values(ReportIlluminationConfiguration.Headlights))
        left_turn_signal: ReportIlluminationConfiguration.LeftTurnSignal | int = jd.bits(1, 0x1, lambda: jd.Values(ReportIlluminationConfiguration.LeftTurnSignal))
        right_turn_signal: ReportIlluminationConfiguration.RightTurnSignal | int = jd.bits(2, 0x1, lambda: jd.Values(ReportIlluminationConfiguration.RightTurnSignal))
        running_lights: ReportIlluminationConfiguration.RunningLights | int = jd.bits(3, 0x1, lambda: jd.Values(ReportIlluminationConfiguration.RunningLights))
        brake_lights: ReportIlluminationConfiguration.BrakeLights | int = jd.bits(4, 0x1, lambda: jd.Values(ReportIlluminationConfiguration.BrakeLights))
        backup_lights: ReportIlluminationConfiguration.BackupLights | int = jd.bits(5, 0x1, lambda: jd.Values(ReportIlluminationConfiguration.BackupLights))
        visible_light_source: ReportIlluminationConfiguration.VisibleLightSource | int = jd.bits(6, 0x1, lambda: jd.Values(ReportIlluminationConfiguration.VisibleLightSource))
        ir_light_source: ReportIlluminationConfiguration.IRLightSource | int = jd.bits(7, 0x1, lambda: jd.Values(ReportIlluminationConfiguration.IRLightSource))
        variable_light1: ReportIlluminationConfiguration.VariableLight1 | int = jd.bits(8, 0x1, lambda: jd.Values(ReportIlluminationConfiguration.VariableLight1))
        variable_light2: ReportIlluminationConfiguration.VariableLight2 | int = jd.bits(9, 0x1, lambda: jd.Values(ReportIlluminationConfiguration.VariableLight2))
        variable_light3: ReportIlluminationConfiguration.VariableLight3 | int = jd.bits(10, 0x1, lambda: jd.Values(ReportIlluminationConfiguration.VariableLight3))
        variable_light4: ReportIlluminationConfiguration.VariableLight4 | int = jd.bits(11, 0x1, lambda: jd.Values(ReportIlluminationConfiguration.VariableLight4))
        high_beams: ReportIlluminationConfiguration.HighBeams | int = jd.bits(12, 0x1, lambda: jd.Values(ReportIlluminationConfiguration.HighBeams))
        parking_lights: ReportIlluminationConfiguration.ParkingLights | int = jd.bits(13, 0x1, lambda: jd.Values(ReportIlluminationConfiguration.ParkingLights))
        fog_lights: ReportIlluminationConfiguration.FogLights | int = jd.bits(14, 0x1, lambda: jd.Values(ReportIlluminationConfiguration.FogLights))
        hazard_lights: ReportIlluminationConfiguration.HazardLights | int = jd.bits(15, 0x1, lambda: jd.Values(ReportIlluminationConfiguration.HazardLights))
        reserved_bits: int = 0

    types: ReportIlluminationConfiguration.Types = jd.field("types", lambda: ReportIlluminationConfiguration.Types.layout())


@jd.message(_SERVICE, 0x2514, query=True)
class QueryIlluminationConfiguration(jd.Message):
    """QueryIlluminationConfiguration (0x2514): Asks which lights there are."""
    REPORT = ReportIlluminationConfiguration


@jd.message(_SERVICE, 0x0513, command=True)
class SetIlluminationState(jd.Message):
    """SetIlluminationState (0x0513): Switches lights.

    illumination: Which lights are on
    """

    class Headlights(IntEnum):
        OFF = 0
        ON = 1

    class LeftTurnSignal(IntEnum):
        OFF = 0
        ON = 1

    class RightTurnSignal(IntEnum):
        OFF = 0
        ON = 1

    class RunningLights(IntEnum):
        OFF = 0
        ON = 1

    class BrakeLights(IntEnum):
        OFF = 0
        ON = 1

    class BackupLights(IntEnum):
        OFF = 0
        ON = 1

    class VisibleLightSource(IntEnum):
        OFF = 0
        ON = 1

    class IRLightSource(IntEnum):
        OFF = 0
        ON = 1

    class HighBeams(IntEnum):
        OFF = 0
        ON = 1

    class ParkingLights(IntEnum):
        OFF = 0
        ON = 1

    class FogLights(IntEnum):
        OFF = 0
        ON = 1

    class HazardLights(IntEnum):
        OFF = 0
        ON = 1

    @jd.bit_field("I")
    class Illumination(jd.Struct):
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
        headlights: SetIlluminationState.Headlights | int = jd.bits(0, 0x1, lambda: jd.Values(SetIlluminationState.Headlights))
        left_turn_signal: SetIlluminationState.LeftTurnSignal | int = jd.bits(1, 0x1, lambda: jd.Values(SetIlluminationState.LeftTurnSignal))
        right_turn_signal: SetIlluminationState.RightTurnSignal | int = jd.bits(2, 0x1, lambda: jd.Values(SetIlluminationState.RightTurnSignal))
        running_lights: SetIlluminationState.RunningLights | int = jd.bits(3, 0x1, lambda: jd.Values(SetIlluminationState.RunningLights))
        brake_lights: SetIlluminationState.BrakeLights | int = jd.bits(4, 0x1, lambda: jd.Values(SetIlluminationState.BrakeLights))
        backup_lights: SetIlluminationState.BackupLights | int = jd.bits(5, 0x1, lambda: jd.Values(SetIlluminationState.BackupLights))
        visible_light_source: SetIlluminationState.VisibleLightSource | int = jd.bits(6, 0x1, lambda: jd.Values(SetIlluminationState.VisibleLightSource))
        ir_light_source: SetIlluminationState.IRLightSource | int = jd.bits(7, 0x1, lambda: jd.Values(SetIlluminationState.IRLightSource))
        variable_light1: int = jd.bits(8, 0xF, jd.Values(None, ((0, 15),)))
        variable_light2: int = jd.bits(12, 0xF, jd.Values(None, ((0, 15),)))
        variable_light3: int = jd.bits(16, 0xF, jd.Values(None, ((0, 15),)))
        variable_light4: int = jd.bits(20, 0xF, jd.Values(None, ((0, 15),)))
        high_beams: SetIlluminationState.HighBeams | int = jd.bits(24, 0x1, lambda: jd.Values(SetIlluminationState.HighBeams))
        parking_lights: SetIlluminationState.ParkingLights | int = jd.bits(25, 0x1, lambda: jd.Values(SetIlluminationState.ParkingLights))
        fog_lights: SetIlluminationState.FogLights | int = jd.bits(26, 0x1, lambda: jd.Values(SetIlluminationState.FogLights))
        hazard_lights: SetIlluminationState.HazardLights | int = jd.bits(27, 0x1, lambda: jd.Values(SetIlluminationState.HazardLights))
        reserved_bits: int = 0

    illumination: SetIlluminationState.Illumination = jd.field("illumination", lambda: SetIlluminationState.Illumination.layout())
