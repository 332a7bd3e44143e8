"""urn:jaus:jss:iop:CBRNSensor 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import Self

from jauspy.codec import runtime as rt


@dataclass(slots=True, repr=False)
class QueryCBRN4(rt.Message):
    """QueryCBRN4 (0xF920): Asks for a CBRN 4 report.

    cbrn4_report_id: Number of the report
    station_number: Number of the station
    """

    CODE = 0xF920
    NAME = "QueryCBRN4"
    SERVICE = "urn:jaus:jss:iop:CBRNSensor"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True

    cbrn4_report_id: int
    station_number: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("CBRN4ReportID", rt.Number("I")),
            ("StationNumber", rt.Number("I")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.cbrn4_report_id, self.station_number = _S_H2I.unpack(data)
        if code != 0xF920: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_H2I.pack(0xF920, self.cbrn4_report_id, self.station_number)


@dataclass(slots=True, repr=False)
class QueryCBRNDetection(rt.Message):
    """QueryCBRNDetection (0xF921): Asks for the last detection.

    station_number: Number of the station
    """

    CODE = 0xF921
    NAME = "QueryCBRNDetection"
    SERVICE = "urn:jaus:jss:iop:CBRNSensor"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True

    station_number: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("StationNumber", rt.Number("I")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.station_number = _S_HI.unpack(data)
        if code != 0xF921: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_HI.pack(0xF921, self.station_number)


@dataclass(slots=True, repr=False)
class QueryRNDetailedMeasurement(rt.Message):
    """QueryRNDetailedMeasurement (0xF922): Asks for details of a radiological or nuclear detection.

    station_number: Number of the station
    """

    CODE = 0xF922
    NAME = "QueryRNDetailedMeasurement"
    SERVICE = "urn:jaus:jss:iop:CBRNSensor"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True

    station_number: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("StationNumber", rt.Number("I")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.station_number = _S_HI.unpack(data)
        if code != 0xF922: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_HI.pack(0xF922, self.station_number)


@dataclass(slots=True, repr=False)
class QueryCBDetailedMeasurement(rt.Message):
    """QueryCBDetailedMeasurement (0xF923): Asks for details of a chemical or biological detection.

    station_number: Number of the station
    """

    CODE = 0xF923
    NAME = "QueryCBDetailedMeasurement"
    SERVICE = "urn:jaus:jss:iop:CBRNSensor"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True

    station_number: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("StationNumber", rt.Number("I")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.station_number = _S_HI.unpack(data)
        if code != 0xF923: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_HI.pack(0xF923, self.station_number)


@dataclass(slots=True, repr=False)
class QueryCBRNOperatingState(rt.Message):
    """QueryCBRNOperatingState (0xF924): Asks for the state of a station.

    station_number: Number of the station
    """

    CODE = 0xF924
    NAME = "QueryCBRNOperatingState"
    SERVICE = "urn:jaus:jss:iop:CBRNSensor"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True

    station_number: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("StationNumber", rt.Number("I")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.station_number = _S_HI.unpack(data)
        if code != 0xF924: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_HI.pack(0xF924, self.station_number)


@dataclass(slots=True, repr=False)
class QueryCBRNConfiguration(rt.Message):
    """QueryCBRNConfiguration (0xF925): Asks for the settings of a station.

    station_number: Number of the station
    """

    CODE = 0xF925
    NAME = "QueryCBRNConfiguration"
    SERVICE = "urn:jaus:jss:iop:CBRNSensor"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True

    station_number: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("StationNumber", rt.Number("I")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.station_number = _S_HI.unpack(data)
        if code != 0xF925: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_HI.pack(0xF925, self.station_number)


@dataclass(slots=True, repr=False)
class QueryCBRNScanWindowOperatingState(rt.Message):
    """QueryCBRNScanWindowOperatingState (0xF926): Asks where a station scans.

    station_number: Number of the station
    """

    CODE = 0xF926
    NAME = "QueryCBRNScanWindowOperatingState"
    SERVICE = "urn:jaus:jss:iop:CBRNSensor"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True

    station_number: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("StationNumber", rt.Number("I")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.station_number = _S_HI.unpack(data)
        if code != 0xF926: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_HI.pack(0xF926, self.station_number)


@dataclass(slots=True, repr=False, kw_only=True)
class CBRNCommand(rt.Message):
    """CBRNCommand (0xF927): Switches a station and starts tests and samples.

    timestamp: in second, optional. Time of the message, in seconds
    station_number: Number of the station
    set_power_mode: SetPowerMode or 2..85 or 86..255, optional. Whether the station is to be on
    set_operating_mode: SetOperatingMode or 3..85 or 86..255, optional. Whether the station is to work
    reboot: Reboot or 2..85 or 86..255, optional. Whether to start anew
    operating_reset_type: 0..255, optional. Which part of the operation to reset
    operating_reset_state: OperatingResetState or 2..85 or 86..255, optional. Whether to reset the operation
    reset_configuration_state: ResetConfigurationState or 2..85 or 86..255, optional. Whether to reset the settings
    set_sampling_mode: SetSamplingMode or 6..85 or 86..255, optional. What to start or stop
    test_type: TestType or 8..85 or 86..255, optional. What to test
    set_test_mode: SetTestMode or 2..85 or 86..255, optional. Whether to start or stop the test
    set_local_alarm_enunciation: SetLocalAlarmEnunciation or 2..85 or 86..255, optional. Whether the alarm is to sound
    set_keyguard: SetKeyguard or 2..85 or 86..255, optional. Whether keys are to be locked
    set_clock: in second, optional. Time to set the clock to, in seconds
    """

    CODE = 0xF927
    NAME = "CBRNCommand"
    SERVICE = "urn:jaus:jss:iop:CBRNSensor"
    VERSION = "1.1"
    IS_COMMAND = True
    IS_QUERY = False

    class SetPowerMode(IntEnum):
        """Values of SetPowerMode."""

        OFF = 0
        ON = 1

    class SetOperatingMode(IntEnum):
        """Values of SetOperatingMode."""

        OPERATE = 0
        STANDBY = 1
        TRAINING = 2

    class Reboot(IntEnum):
        """Values of Reboot."""

        NORMAL_OPERATION = 0
        REBOOT = 1

    class OperatingResetState(IntEnum):
        """Values of OperatingResetState."""

        NORMAL_OPERATION = 0
        RESET = 1

    class ResetConfigurationState(IntEnum):
        """Values of ResetConfigurationState."""

        NORMAL_OPERATION = 0
        RESET = 1

    class SetSamplingMode(IntEnum):
        """Values of SetSamplingMode."""

        STOP_SAMPLING = 0
        START_SAMPLING = 1
        STOP_SCANNING = 2
        START_SCANNING = 3
        STOP_TRACKING = 4
        START_TRACKING = 5

    class TestType(IntEnum):
        """Values of TestType."""

        SELF_TEST = 0
        AUDIO_TEST = 1
        CONTROL_TEST = 2
        POWER_DISTRIBUTION_TEST = 3
        SENSING_TEST = 4
        WIRELESS_TEST = 5
        DISMOUNTED_POWER_TEST = 6
        DISPLAY_TEST = 7

    class SetTestMode(IntEnum):
        """Values of SetTestMode."""

        STOP_TEST = 0
        START_TEST = 1

    class SetLocalAlarmEnunciation(IntEnum):
        """Values of SetLocalAlarmEnunciation."""

        SILENCE_ALARM = 0
        ACTIVATE_ALARM = 1

    class SetKeyguard(IntEnum):
        """Values of SetKeyguard."""

        UNLOCKED = 0
        LOCKED = 1

    timestamp: float | None = None
    station_number: int
    set_power_mode: CBRNCommand.SetPowerMode | int | None = None
    set_operating_mode: CBRNCommand.SetOperatingMode | int | None = None
    reboot: CBRNCommand.Reboot | int | None = None
    operating_reset_type: int | None = None
    operating_reset_state: CBRNCommand.OperatingResetState | int | None = None
    reset_configuration_state: CBRNCommand.ResetConfigurationState | int | None = None
    set_sampling_mode: CBRNCommand.SetSamplingMode | int | None = None
    test_type: CBRNCommand.TestType | int | None = None
    set_test_mode: CBRNCommand.SetTestMode | int | None = None
    set_local_alarm_enunciation: CBRNCommand.SetLocalAlarmEnunciation | int | None = None
    set_keyguard: CBRNCommand.SetKeyguard | int | None = None
    set_clock: float | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "I",
            ("Timestamp", rt.Number("d", rt.ANY, "second"), True),
            ("StationNumber", rt.Number("I")),
            ("SetPowerMode", rt.Number("B", rt.Values(CBRNCommand.SetPowerMode, ((2, 85), (86, 255)))), True),
            ("SetOperatingMode", rt.Number("B", rt.Values(CBRNCommand.SetOperatingMode, ((3, 85), (86, 255)))), True),
            ("Reboot", rt.Number("B", rt.Values(CBRNCommand.Reboot, ((2, 85), (86, 255)))), True),
            ("OperatingResetType", rt.Number("B", rt.Values(None, ((0, 255),))), True),
            ("OperatingResetState", rt.Number("B", rt.Values(CBRNCommand.OperatingResetState, ((2, 85), (86, 255)))), True),
            ("ResetConfigurationState", rt.Number("B", rt.Values(CBRNCommand.ResetConfigurationState, ((2, 85), (86, 255)))), True),
            ("SetSamplingMode", rt.Number("B", rt.Values(CBRNCommand.SetSamplingMode, ((6, 85), (86, 255)))), True),
            ("TestType", rt.Number("B", rt.Values(CBRNCommand.TestType, ((8, 85), (86, 255)))), True),
            ("SetTestMode", rt.Number("B", rt.Values(CBRNCommand.SetTestMode, ((2, 85), (86, 255)))), True),
            ("SetLocalAlarmEnunciation", rt.Number("B", rt.Values(CBRNCommand.SetLocalAlarmEnunciation, ((2, 85), (86, 255)))), True),
            ("SetKeyguard", rt.Number("B", rt.Values(CBRNCommand.SetKeyguard, ((2, 85), (86, 255)))), True),
            ("SetClock", rt.Number("d", rt.ANY, "second"), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_HI.unpack_from(data)
        if code != 0xF927: raise rt.Reject
        raw = iter(_M_CBRNCommand[mask & 0x1FFF].unpack(data)).__next__
        self = rt.new(cls)
        if mask & 1:
            timestamp_ = raw()
            if timestamp_ - timestamp_ != 0.0: raise rt.Reject
            self.timestamp = timestamp_
        else: self.timestamp = None
        self.station_number = raw()
        if mask & 2:
            set_power_mode_ = raw()
            self.set_power_mode = _E_CBRNCommand_SetPowerMode.get(set_power_mode_, set_power_mode_)
        else: self.set_power_mode = None
        if mask & 4:
            set_operating_mode_ = raw()
            self.set_operating_mode = _E_CBRNCommand_SetOperatingMode.get(set_operating_mode_, set_operating_mode_)
        else: self.set_operating_mode = None
        if mask & 8:
            reboot_ = raw()
            self.reboot = _E_CBRNCommand_Reboot.get(reboot_, reboot_)
        else: self.reboot = None
        self.operating_reset_type = raw() if mask & 16 else None
        if mask & 32:
            operating_reset_state_ = raw()
            self.operating_reset_state = _E_CBRNCommand_OperatingResetState.get(operating_reset_state_, operating_reset_state_)
        else: self.operating_reset_state = None
        if mask & 64:
            reset_configuration_state_ = raw()
            self.reset_configuration_state = _E_CBRNCommand_ResetConfigurationState.get(reset_configuration_state_, reset_configuration_state_)
        else: self.reset_configuration_state = None
        if mask & 128:
            set_sampling_mode_ = raw()
            self.set_sampling_mode = _E_CBRNCommand_SetSamplingMode.get(set_sampling_mode_, set_sampling_mode_)
        else: self.set_sampling_mode = None
        if mask & 256:
            test_type_ = raw()
            self.test_type = _E_CBRNCommand_TestType.get(test_type_, test_type_)
        else: self.test_type = None
        if mask & 512:
            set_test_mode_ = raw()
            self.set_test_mode = _E_CBRNCommand_SetTestMode.get(set_test_mode_, set_test_mode_)
        else: self.set_test_mode = None
        if mask & 1024:
            set_local_alarm_enunciation_ = raw()
            self.set_local_alarm_enunciation = _E_CBRNCommand_SetLocalAlarmEnunciation.get(set_local_alarm_enunciation_, set_local_alarm_enunciation_)
        else: self.set_local_alarm_enunciation = None
        if mask & 2048:
            set_keyguard_ = raw()
            self.set_keyguard = _E_CBRNCommand_SetKeyguard.get(set_keyguard_, set_keyguard_)
        else: self.set_keyguard = None
        if mask & 4096:
            set_clock_ = raw()
            if set_clock_ - set_clock_ != 0.0: raise rt.Reject
            self.set_clock = set_clock_
        else: self.set_clock = None
        self.reserved_presence = mask & 0xFFFFE000
        return self

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0x1FFF: raise rt.Reject
        raw: list[int | float | bytes] = []
        timestamp_ = self.timestamp
        if timestamp_ is not None:
            mask |= 1
            if timestamp_ - timestamp_ != 0.0: raise rt.Reject
            raw.append(timestamp_)
        raw.append(self.station_number)
        set_power_mode_ = self.set_power_mode
        if set_power_mode_ is not None:
            mask |= 2
            raw.append(set_power_mode_)
        set_operating_mode_ = self.set_operating_mode
        if set_operating_mode_ is not None:
            mask |= 4
            raw.append(set_operating_mode_)
        reboot_ = self.reboot
        if reboot_ is not None:
            mask |= 8
            raw.append(reboot_)
        operating_reset_type_ = self.operating_reset_type
        if operating_reset_type_ is not None:
            mask |= 16
            raw.append(operating_reset_type_)
        operating_reset_state_ = self.operating_reset_state
        if operating_reset_state_ is not None:
            mask |= 32
            raw.append(operating_reset_state_)
        reset_configuration_state_ = self.reset_configuration_state
        if reset_configuration_state_ is not None:
            mask |= 64
            raw.append(reset_configuration_state_)
        set_sampling_mode_ = self.set_sampling_mode
        if set_sampling_mode_ is not None:
            mask |= 128
            raw.append(set_sampling_mode_)
        test_type_ = self.test_type
        if test_type_ is not None:
            mask |= 256
            raw.append(test_type_)
        set_test_mode_ = self.set_test_mode
        if set_test_mode_ is not None:
            mask |= 512
            raw.append(set_test_mode_)
        set_local_alarm_enunciation_ = self.set_local_alarm_enunciation
        if set_local_alarm_enunciation_ is not None:
            mask |= 1024
            raw.append(set_local_alarm_enunciation_)
        set_keyguard_ = self.set_keyguard
        if set_keyguard_ is not None:
            mask |= 2048
            raw.append(set_keyguard_)
        set_clock_ = self.set_clock
        if set_clock_ is not None:
            mask |= 4096
            if set_clock_ - set_clock_ != 0.0: raise rt.Reject
            raw.append(set_clock_)
        return _M_CBRNCommand_pack[mask & 0x1FFF].pack(0xF927, mask, *raw)


@dataclass(slots=True, repr=False, kw_only=True)
class CBRNConfigurationCommand(rt.Message):
    """CBRNConfigurationCommand (0xF928): Sets how a station detects and reports.

    timestamp: in second, optional. Time of the message, in seconds
    station_number: Number of the station
    set_exer_oper_name: up to 57 characters, optional. Name of the exercise or operation
    set_exer_oper_flag: SetExerOperFlag or 2..85 or 86..255, optional. Whether this is an exercise
    set_call_sign: up to 31 characters, optional. Call sign of the station
    set_positioning_mode: SetPositioningMode or 2..85 or 86..255, optional. Whether the position is measured or set
    set_payload_latitude: -1.57079632679..1.57079632679 in radian, optional. Latitude of the station (WGS 84), in radians
    set_payload_longitude: -3.14159265359..3.14159265359 in radian, optional. Longitude of the station (WGS 84), in radians
    set_payload_altitude: -10000..100000 in meter, optional. Altitude of the station, in metres
    set_payload_sensitivity: SetPayloadSensitivity or 2..85 or 86..255, optional. Sensitivity of the station
    set_background_level_subtract_mode: SetBackgroundLevelSubtractMode or 2..85 or 86..255, optional. Whether the background is taken off the measurement
    set_background_level_mode: SetBackgroundLevelMode or 2..85 or 86..255, optional. Whether the background is measured or set
    set_background_level: optional. Level that is there without a hazard
    set_detection_mode: SetDetectionMode or 3..85 or 86..255, optional. Whether the station detects by itself
    set_detection_level: SetDetectionLevel or 6..85 or 86..255, optional. Level that counts as a detection
    set_detection_operational_threshold_level: optional. Threshold in operation
    set_detection_low_threshold_level: optional. Lower threshold
    set_detection_threshold_delay: in second, optional. Time above the threshold before an alarm, in seconds
    set_sampling_interval: in minute, optional. Time from one sample to the next, in minutes
    set_sampling_duration: in minute, optional. Time that a sample takes, in minutes
    set_sampling_volume: in cubic meter, optional. Volume of a sample, in cubic metres
    set_audio_level: SetAudioLevel or 4..85 or 86..255, optional. Loudness of the alarm
    set_detection_above_threshold_update_frequency: 0..100 in hertz, optional. Rate of reports above the threshold, in hertz
    set_location_label: up to 16 characters, optional. Name of the place
    set_group_location_label: up to 16 characters, optional. Name of the place of the group
    set_cbrn4_delivery_mode: SetCBRN4DeliveryMode or 2..85 or 86..255. Whether CBRN 4 reports are sent all the time
    set_language: SetLanguage or 2..85 or 86..255, optional. Language of the display
    """

    CODE = 0xF928
    NAME = "CBRNConfigurationCommand"
    SERVICE = "urn:jaus:jss:iop:CBRNSensor"
    VERSION = "1.1"
    IS_COMMAND = True
    IS_QUERY = False

    class SetExerOperFlag(IntEnum):
        """Values of SetExerOperFlag."""

        EXERCISE = 0
        OPERATION = 1

    class SetPositioningMode(IntEnum):
        """Values of SetPositioningMode."""

        MANUAL = 0
        GPS = 1

    class SetPayloadSensitivity(IntEnum):
        """Values of SetPayloadSensitivity."""

        NORMAL = 0
        HIGH = 1

    class SetBackgroundLevelSubtractMode(IntEnum):
        """Values of SetBackgroundLevelSubtractMode."""

        DO_NOT_SUBTRACT = 0
        SUBTRACT = 1

    class SetBackgroundLevelMode(IntEnum):
        """Values of SetBackgroundLevelMode."""

        AUTOMATIC = 0
        MANUAL = 1

    class SetDetectionMode(IntEnum):
        """Values of SetDetectionMode."""

        AUTOMATIC = 0
        MANUAL = 1
        STANDBY = 2

    class SetDetectionLevel(IntEnum):
        """Values of SetDetectionLevel."""

        STANDARD = 0
        MIOSIS = 1
        ICT5 = 2
        ICT50 = 3
        OPERATIONAL = 4
        LOW = 5

    class SetAudioLevel(IntEnum):
        """Values of SetAudioLevel."""

        HIGH = 0
        MEDIUM = 1
        LOW = 2
        OFF = 3

    class SetCBRN4DeliveryMode(IntEnum):
        """Values of SetCBRN4DeliveryMode."""

        THREAT_RELATED = 0
        CONTINUOUS = 1

    class SetLanguage(IntEnum):
        """Values of SetLanguage."""

        ENGLISH = 0
        FRENCH = 1

    timestamp: float | None = None
    station_number: int
    set_exer_oper_name: str | None = None
    set_exer_oper_flag: CBRNConfigurationCommand.SetExerOperFlag | int | None = None
    set_call_sign: str | None = None
    set_positioning_mode: CBRNConfigurationCommand.SetPositioningMode | int | None = None
    set_payload_latitude: float | None = None
    set_payload_longitude: float | None = None
    set_payload_altitude: float | None = None
    set_payload_sensitivity: CBRNConfigurationCommand.SetPayloadSensitivity | int | None = None
    set_background_level_subtract_mode: CBRNConfigurationCommand.SetBackgroundLevelSubtractMode | int | None = None
    set_background_level_mode: CBRNConfigurationCommand.SetBackgroundLevelMode | int | None = None
    set_background_level: float | None = None
    set_detection_mode: CBRNConfigurationCommand.SetDetectionMode | int | None = None
    set_detection_level: CBRNConfigurationCommand.SetDetectionLevel | int | None = None
    set_detection_operational_threshold_level: float | None = None
    set_detection_low_threshold_level: float | None = None
    set_detection_threshold_delay: float | None = None
    set_sampling_interval: int | None = None
    set_sampling_duration: int | None = None
    set_sampling_volume: float | None = None
    set_audio_level: CBRNConfigurationCommand.SetAudioLevel | int | None = None
    set_detection_above_threshold_update_frequency: float | None = None
    set_location_label: str | None = None
    set_group_location_label: str | None = None
    set_cbrn4_delivery_mode: CBRNConfigurationCommand.SetCBRN4DeliveryMode | int
    set_language: CBRNConfigurationCommand.SetLanguage | int | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "I",
            ("Timestamp", rt.Number("d", rt.ANY, "second"), True),
            ("StationNumber", rt.Number("I")),
            ("SetExerOperName", rt.Text(count=rt.Count("B", 0, 57)), True),
            ("SetExerOperFlag", rt.Number("B", rt.Values(CBRNConfigurationCommand.SetExerOperFlag, ((2, 85), (86, 255)))), True),
            ("SetCallSign", rt.Text(count=rt.Count("B", 0, 31)), True),
            ("SetPositioningMode", rt.Number("B", rt.Values(CBRNConfigurationCommand.SetPositioningMode, ((2, 85), (86, 255)))), True),
            ("SetPayloadLatitude", rt.Number("d", rt.Values(None, ((-1.57079632679, 1.57079632679),)), "radian"), True),
            ("SetPayloadLongitude", rt.Number("d", rt.Values(None, ((-3.141592653589793, 3.141592653589793),)), "radian"), True),
            ("SetPayloadAltitude", rt.Number("f", rt.Values(None, ((-10000.0, 100000.0),)), "meter"), True),
            ("SetPayloadSensitivity", rt.Number("B", rt.Values(CBRNConfigurationCommand.SetPayloadSensitivity, ((2, 85), (86, 255)))), True),
            ("SetBackgroundLevelSubtractMode", rt.Number("B", rt.Values(CBRNConfigurationCommand.SetBackgroundLevelSubtractMode, ((2, 85), (86, 255)))), True),
            ("SetBackgroundLevelMode", rt.Number("B", rt.Values(CBRNConfigurationCommand.SetBackgroundLevelMode, ((2, 85), (86, 255)))), True),
            ("SetBackgroundLevel", rt.Number("f"), True),
            ("SetDetectionMode", rt.Number("B", rt.Values(CBRNConfigurationCommand.SetDetectionMode, ((3, 85), (86, 255)))), True),
            ("SetDetectionLevel", rt.Number("B", rt.Values(CBRNConfigurationCommand.SetDetectionLevel, ((6, 85), (86, 255)))), True),
            ("SetDetectionOperationalThresholdLevel", rt.Number("d"), True),
            ("SetDetectionLowThresholdLevel", rt.Number("d"), True),
            ("SetDetectionThresholdDelay", rt.Number("f", rt.ANY, "second"), True),
            ("SetSamplingInterval", rt.Number("I", rt.ANY, "minute"), True),
            ("SetSamplingDuration", rt.Number("I", rt.ANY, "minute"), True),
            ("SetSamplingVolume", rt.Number("d", rt.ANY, "cubic meter"), True),
            ("SetAudioLevel", rt.Number("B", rt.Values(CBRNConfigurationCommand.SetAudioLevel, ((4, 85), (86, 255)))), True),
            ("SetDetectionAboveThresholdUpdateFrequency", rt.Number("f", rt.Values(None, ((0.0, 100.0),)), "hertz"), True),
            ("SetLocationLabel", rt.Text(count=rt.Count("B", 0, 16)), True),
            ("SetGroupLocationLabel", rt.Text(count=rt.Count("B", 0, 16)), True),
            ("SetCBRN4DeliveryMode", rt.Number("B", rt.Values(CBRNConfigurationCommand.SetCBRN4DeliveryMode, ((2, 85), (86, 255))))),
            ("SetLanguage", rt.Number("B", rt.Values(CBRNConfigurationCommand.SetLanguage, ((2, 85), (86, 255)))), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x28 or data[1] != 0xF9: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (mask,) = _S_I.unpack_from(data, 2)
        packer = _M_CBRNConfigurationCommand_0[mask & 0x1]
        raw = iter(packer.unpack_from(data, 6)).__next__
        at = 6 + packer.size
        if mask & 1:
            timestamp_ = raw()
            if timestamp_ - timestamp_ != 0.0: raise rt.Reject
            self.timestamp = timestamp_
        else: self.timestamp = None
        self.station_number = raw()
        if mask & 2:
            set_exer_oper_name_end_ = data[at]
            if set_exer_oper_name_end_ > 57: raise rt.Reject
            set_exer_oper_name_end_ += at + 1
            self.set_exer_oper_name = data[at + 1:set_exer_oper_name_end_].decode("latin-1")
            at = set_exer_oper_name_end_
        else: self.set_exer_oper_name = None
        packer = _M_CBRNConfigurationCommand_2[mask & 0x4]
        raw = iter(packer.unpack_from(data, at)).__next__
        at += packer.size
        if mask & 4:
            set_exer_oper_flag_ = raw()
            self.set_exer_oper_flag = _E_CBRNConfigurationCommand_SetExerOperFlag.get(set_exer_oper_flag_, set_exer_oper_flag_)
        else: self.set_exer_oper_flag = None
        if mask & 8:
            set_call_sign_end_ = data[at]
            if set_call_sign_end_ > 31: raise rt.Reject
            set_call_sign_end_ += at + 1
            self.set_call_sign = data[at + 1:set_call_sign_end_].decode("latin-1")
            at = set_call_sign_end_
        else: self.set_call_sign = None
        packer = _M_CBRNConfigurationCommand_4[mask & 0x3FFFF0]
        raw = iter(packer.unpack_from(data, at)).__next__
        at += packer.size
        if mask & 16:
            set_positioning_mode_ = raw()
            self.set_positioning_mode = _E_CBRNConfigurationCommand_SetPositioningMode.get(set_positioning_mode_, set_positioning_mode_)
        else: self.set_positioning_mode = None
        if mask & 32:
            set_payload_latitude_ = raw()
            if set_payload_latitude_ - set_payload_latitude_ != 0.0: raise rt.Reject
            if not -1.57079632679 <= set_payload_latitude_ <= 1.57079632679: raise rt.Reject
            self.set_payload_latitude = set_payload_latitude_
        else: self.set_payload_latitude = None
        if mask & 64:
            set_payload_longitude_ = raw()
            if set_payload_longitude_ - set_payload_longitude_ != 0.0: raise rt.Reject
            if not -3.141592653589793 <= set_payload_longitude_ <= 3.141592653589793: raise rt.Reject
            self.set_payload_longitude = set_payload_longitude_
        else: self.set_payload_longitude = None
        if mask & 128:
            set_payload_altitude_ = raw()
            if set_payload_altitude_ - set_payload_altitude_ != 0.0: raise rt.Reject
            if not -10000.0 <= set_payload_altitude_ <= 100000.0: raise rt.Reject
            self.set_payload_altitude = set_payload_altitude_
        else: self.set_payload_altitude = None
        if mask & 256:
            set_payload_sensitivity_ = raw()
            self.set_payload_sensitivity = _E_CBRNConfigurationCommand_SetPayloadSensitivity.get(set_payload_sensitivity_, set_payload_sensitivity_)
        else: self.set_payload_sensitivity = None
        if mask & 512:
            set_background_level_subtract_mode_ = raw()
            self.set_background_level_subtract_mode = _E_CBRNConfigurationCommand_SetBackgroundLevelSubtractMode.get(set_background_level_subtract_mode_, set_background_level_subtract_mode_)
        else: self.set_background_level_subtract_mode = None
        if mask & 1024:
            set_background_level_mode_ = raw()
            self.set_background_level_mode = _E_CBRNConfigurationCommand_SetBackgroundLevelMode.get(set_background_level_mode_, set_background_level_mode_)
        else: self.set_background_level_mode = None
        if mask & 2048:
            set_background_level_ = raw()
            if set_background_level_ - set_background_level_ != 0.0: raise rt.Reject
            self.set_background_level = set_background_level_
        else: self.set_background_level = None
        if mask & 4096:
            set_detection_mode_ = raw()
            self.set_detection_mode = _E_CBRNConfigurationCommand_SetDetectionMode.get(set_detection_mode_, set_detection_mode_)
        else: self.set_detection_mode = None
        if mask & 8192:
            set_detection_level_ = raw()
            self.set_detection_level = _E_CBRNConfigurationCommand_SetDetectionLevel.get(set_detection_level_, set_detection_level_)
        else: self.set_detection_level = None
        if mask & 16384:
            set_detection_operational_threshold_level_ = raw()
            if set_detection_operational_threshold_level_ - set_detection_operational_threshold_level_ != 0.0: raise rt.Reject
            self.set_detection_operational_threshold_level = set_detection_operational_threshold_level_
        else: self.set_detection_operational_threshold_level = None
        if mask & 32768:
            set_detection_low_threshold_level_ = raw()
            if set_detection_low_threshold_level_ - set_detection_low_threshold_level_ != 0.0: raise rt.Reject
            self.set_detection_low_threshold_level = set_detection_low_threshold_level_
        else: self.set_detection_low_threshold_level = None
        if mask & 65536:
            set_detection_threshold_delay_ = raw()
            if set_detection_threshold_delay_ - set_detection_threshold_delay_ != 0.0: raise rt.Reject
            self.set_detection_threshold_delay = set_detection_threshold_delay_
        else: self.set_detection_threshold_delay = None
        self.set_sampling_interval = raw() if mask & 131072 else None
        self.set_sampling_duration = raw() if mask & 262144 else None
        if mask & 524288:
            set_sampling_volume_ = raw()
            if set_sampling_volume_ - set_sampling_volume_ != 0.0: raise rt.Reject
            self.set_sampling_volume = set_sampling_volume_
        else: self.set_sampling_volume = None
        if mask & 1048576:
            set_audio_level_ = raw()
            self.set_audio_level = _E_CBRNConfigurationCommand_SetAudioLevel.get(set_audio_level_, set_audio_level_)
        else: self.set_audio_level = None
        if mask & 2097152:
            set_detection_above_threshold_update_frequency_ = raw()
            if set_detection_above_threshold_update_frequency_ - set_detection_above_threshold_update_frequency_ != 0.0: raise rt.Reject
            if not 0.0 <= set_detection_above_threshold_update_frequency_ <= 100.0: raise rt.Reject
            self.set_detection_above_threshold_update_frequency = set_detection_above_threshold_update_frequency_
        else: self.set_detection_above_threshold_update_frequency = None
        if mask & 4194304:
            set_location_label_end_ = data[at]
            if set_location_label_end_ > 16: raise rt.Reject
            set_location_label_end_ += at + 1
            self.set_location_label = data[at + 1:set_location_label_end_].decode("latin-1")
            at = set_location_label_end_
        else: self.set_location_label = None
        if mask & 8388608:
            set_group_location_label_end_ = data[at]
            if set_group_location_label_end_ > 16: raise rt.Reject
            set_group_location_label_end_ += at + 1
            self.set_group_location_label = data[at + 1:set_group_location_label_end_].decode("latin-1")
            at = set_group_location_label_end_
        else: self.set_group_location_label = None
        packer = _M_CBRNConfigurationCommand_7[mask & 0x1000000]
        raw = iter(packer.unpack_from(data, at)).__next__
        at += packer.size
        set_cbrn4_delivery_mode_ = raw()
        self.set_cbrn4_delivery_mode = _E_CBRNConfigurationCommand_SetCBRN4DeliveryMode.get(set_cbrn4_delivery_mode_, set_cbrn4_delivery_mode_)
        if mask & 16777216:
            set_language_ = raw()
            self.set_language = _E_CBRNConfigurationCommand_SetLanguage.get(set_language_, set_language_)
        else: self.set_language = None
        self.reserved_presence = mask & 0xFE000000
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x28\xf9")
        start = len(out)
        out += b"\0\0\0\0"
        mask = self.reserved_presence
        if mask & 0x1FFFFFF: raise rt.Reject
        raw: list[int | float | bytes] = []
        timestamp_ = self.timestamp
        if timestamp_ is not None:
            mask |= 1
            if timestamp_ - timestamp_ != 0.0: raise rt.Reject
            raw.append(timestamp_)
        raw.append(self.station_number)
        out += _M_CBRNConfigurationCommand_0[mask & 0x1].pack(*raw)
        set_exer_oper_name_ = self.set_exer_oper_name
        if set_exer_oper_name_ is not None:
            mask |= 2
            set_exer_oper_name_raw_ = set_exer_oper_name_.encode("latin-1")
            if len(set_exer_oper_name_raw_) > 57: raise rt.Reject
            out.append(len(set_exer_oper_name_raw_))
            out += set_exer_oper_name_raw_
        raw = []
        set_exer_oper_flag_ = self.set_exer_oper_flag
        if set_exer_oper_flag_ is not None:
            mask |= 4
            raw.append(set_exer_oper_flag_)
        out += _M_CBRNConfigurationCommand_2[mask & 0x4].pack(*raw)
        set_call_sign_ = self.set_call_sign
        if set_call_sign_ is not None:
            mask |= 8
            set_call_sign_raw_ = set_call_sign_.encode("latin-1")
            if len(set_call_sign_raw_) > 31: raise rt.Reject
            out.append(len(set_call_sign_raw_))
            out += set_call_sign_raw_
        raw = []
        set_positioning_mode_ = self.set_positioning_mode
        if set_positioning_mode_ is not None:
            mask |= 16
            raw.append(set_positioning_mode_)
        set_payload_latitude_ = self.set_payload_latitude
        if set_payload_latitude_ is not None:
            mask |= 32
            if set_payload_latitude_ - set_payload_latitude_ != 0.0: raise rt.Reject
            if not -1.57079632679 <= set_payload_latitude_ <= 1.57079632679: raise rt.Reject
            raw.append(set_payload_latitude_)
        set_payload_longitude_ = self.set_payload_longitude
        if set_payload_longitude_ is not None:
            mask |= 64
            if set_payload_longitude_ - set_payload_longitude_ != 0.0: raise rt.Reject
            if not -3.141592653589793 <= set_payload_longitude_ <= 3.141592653589793: raise rt.Reject
            raw.append(set_payload_longitude_)
        set_payload_altitude_ = self.set_payload_altitude
        if set_payload_altitude_ is not None:
            mask |= 128
            if set_payload_altitude_ - set_payload_altitude_ != 0.0: raise rt.Reject
            if not -10000.0 <= set_payload_altitude_ <= 100000.0: raise rt.Reject
            raw.append(set_payload_altitude_)
        set_payload_sensitivity_ = self.set_payload_sensitivity
        if set_payload_sensitivity_ is not None:
            mask |= 256
            raw.append(set_payload_sensitivity_)
        set_background_level_subtract_mode_ = self.set_background_level_subtract_mode
        if set_background_level_subtract_mode_ is not None:
            mask |= 512
            raw.append(set_background_level_subtract_mode_)
        set_background_level_mode_ = self.set_background_level_mode
        if set_background_level_mode_ is not None:
            mask |= 1024
            raw.append(set_background_level_mode_)
        set_background_level_ = self.set_background_level
        if set_background_level_ is not None:
            mask |= 2048
            if set_background_level_ - set_background_level_ != 0.0: raise rt.Reject
            raw.append(set_background_level_)
        set_detection_mode_ = self.set_detection_mode
        if set_detection_mode_ is not None:
            mask |= 4096
            raw.append(set_detection_mode_)
        set_detection_level_ = self.set_detection_level
        if set_detection_level_ is not None:
            mask |= 8192
            raw.append(set_detection_level_)
        set_detection_operational_threshold_level_ = self.set_detection_operational_threshold_level
        if set_detection_operational_threshold_level_ is not None:
            mask |= 16384
            if set_detection_operational_threshold_level_ - set_detection_operational_threshold_level_ != 0.0: raise rt.Reject
            raw.append(set_detection_operational_threshold_level_)
        set_detection_low_threshold_level_ = self.set_detection_low_threshold_level
        if set_detection_low_threshold_level_ is not None:
            mask |= 32768
            if set_detection_low_threshold_level_ - set_detection_low_threshold_level_ != 0.0: raise rt.Reject
            raw.append(set_detection_low_threshold_level_)
        set_detection_threshold_delay_ = self.set_detection_threshold_delay
        if set_detection_threshold_delay_ is not None:
            mask |= 65536
            if set_detection_threshold_delay_ - set_detection_threshold_delay_ != 0.0: raise rt.Reject
            raw.append(set_detection_threshold_delay_)
        set_sampling_interval_ = self.set_sampling_interval
        if set_sampling_interval_ is not None:
            mask |= 131072
            raw.append(set_sampling_interval_)
        set_sampling_duration_ = self.set_sampling_duration
        if set_sampling_duration_ is not None:
            mask |= 262144
            raw.append(set_sampling_duration_)
        set_sampling_volume_ = self.set_sampling_volume
        if set_sampling_volume_ is not None:
            mask |= 524288
            if set_sampling_volume_ - set_sampling_volume_ != 0.0: raise rt.Reject
            raw.append(set_sampling_volume_)
        set_audio_level_ = self.set_audio_level
        if set_audio_level_ is not None:
            mask |= 1048576
            raw.append(set_audio_level_)
        set_detection_above_threshold_update_frequency_ = self.set_detection_above_threshold_update_frequency
        if set_detection_above_threshold_update_frequency_ is not None:
            mask |= 2097152
            if set_detection_above_threshold_update_frequency_ - set_detection_above_threshold_update_frequency_ != 0.0: raise rt.Reject
            if not 0.0 <= set_detection_above_threshold_update_frequency_ <= 100.0: raise rt.Reject
            raw.append(set_detection_above_threshold_update_frequency_)
        out += _M_CBRNConfigurationCommand_4[mask & 0x3FFFF0].pack(*raw)
        set_location_label_ = self.set_location_label
        if set_location_label_ is not None:
            mask |= 4194304
            set_location_label_raw_ = set_location_label_.encode("latin-1")
            if len(set_location_label_raw_) > 16: raise rt.Reject
            out.append(len(set_location_label_raw_))
            out += set_location_label_raw_
        set_group_location_label_ = self.set_group_location_label
        if set_group_location_label_ is not None:
            mask |= 8388608
            set_group_location_label_raw_ = set_group_location_label_.encode("latin-1")
            if len(set_group_location_label_raw_) > 16: raise rt.Reject
            out.append(len(set_group_location_label_raw_))
            out += set_group_location_label_raw_
        raw = []
        raw.append(self.set_cbrn4_delivery_mode)
        set_language_ = self.set_language
        if set_language_ is not None:
            mask |= 16777216
            raw.append(set_language_)
        out += _M_CBRNConfigurationCommand_7[mask & 0x1000000].pack(*raw)
        _S_I.pack_into(out, start, mask)
        return bytes(out)


@dataclass(slots=True, repr=False, kw_only=True)
class CBRNDisplayConfigurationCommand(rt.Message):
    """CBRNDisplayConfigurationCommand (0xF929): Sets the display of a station.

    timestamp: in second, optional. Time of the message, in seconds
    station_number: Number of the station
    set_display_brightness_level: SetDisplayBrightnessLevel or 5..85 or 86..255, optional. Brightness of the display
    set_display_mode: SetDisplayMode or 2..85 or 86..255, optional. Whether the display stays on
    set_display_contrast: 0..100, optional. Contrast of the display, in percent
    set_other_visual_indicators_brightness_level: SetOtherVisualIndicatorsBrightnessLevel or 5..85 or 86..255, optional. Brightness of lamps
    """

    CODE = 0xF929
    NAME = "CBRNDisplayConfigurationCommand"
    SERVICE = "urn:jaus:jss:iop:CBRNSensor"
    VERSION = "1.1"
    IS_COMMAND = True
    IS_QUERY = False

    class SetDisplayBrightnessLevel(IntEnum):
        """Values of SetDisplayBrightnessLevel."""

        OFF = 0
        LOW = 1
        MEDIUM = 2
        HIGH = 3
        NIGHT_VISION = 4

    class SetDisplayMode(IntEnum):
        """Values of SetDisplayMode."""

        POWER_SAVE = 0
        CONTINUOUS = 1

    class SetOtherVisualIndicatorsBrightnessLevel(IntEnum):
        """Values of SetOtherVisualIndicatorsBrightnessLevel."""

        OFF = 0
        LOW = 1
        MEDIUM = 2
        HIGH = 3
        NIGHT_VISION = 4

    timestamp: float | None = None
    station_number: int
    set_display_brightness_level: CBRNDisplayConfigurationCommand.SetDisplayBrightnessLevel | int | None = None
    set_display_mode: CBRNDisplayConfigurationCommand.SetDisplayMode | int | None = None
    set_display_contrast: float | None = None
    set_other_visual_indicators_brightness_level: CBRNDisplayConfigurationCommand.SetOtherVisualIndicatorsBrightnessLevel | int | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "I",
            ("Timestamp", rt.Number("d", rt.ANY, "second"), True),
            ("StationNumber", rt.Number("I")),
            ("SetDisplayBrightnessLevel", rt.Number("B", rt.Values(CBRNDisplayConfigurationCommand.SetDisplayBrightnessLevel, ((5, 85), (86, 255)))), True),
            ("SetDisplayMode", rt.Number("B", rt.Values(CBRNDisplayConfigurationCommand.SetDisplayMode, ((2, 85), (86, 255)))), True),
            ("SetDisplayContrast", rt.Number("f", rt.Values(None, ((0.0, 100.0),))), True),
            ("SetOtherVisualIndicatorsBrightnessLevel", rt.Number("B", rt.Values(CBRNDisplayConfigurationCommand.SetOtherVisualIndicatorsBrightnessLevel, ((5, 85), (86, 255)))), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_HI.unpack_from(data)
        if code != 0xF929: raise rt.Reject
        raw = iter(_M_CBRNDisplayConfigurationCommand[mask & 0x1F].unpack(data)).__next__
        self = rt.new(cls)
        if mask & 1:
            timestamp_ = raw()
            if timestamp_ - timestamp_ != 0.0: raise rt.Reject
            self.timestamp = timestamp_
        else: self.timestamp = None
        self.station_number = raw()
        if mask & 2:
            set_display_brightness_level_ = raw()
            self.set_display_brightness_level = _E_CBRNDisplayConfigurationCommand_SetDisplayBrightnessLevel.get(set_display_brightness_level_, set_display_brightness_level_)
        else: self.set_display_brightness_level = None
        if mask & 4:
            set_display_mode_ = raw()
            self.set_display_mode = _E_CBRNDisplayConfigurationCommand_SetDisplayMode.get(set_display_mode_, set_display_mode_)
        else: self.set_display_mode = None
        if mask & 8:
            set_display_contrast_ = raw()
            if set_display_contrast_ - set_display_contrast_ != 0.0: raise rt.Reject
            if not 0.0 <= set_display_contrast_ <= 100.0: raise rt.Reject
            self.set_display_contrast = set_display_contrast_
        else: self.set_display_contrast = None
        if mask & 16:
            set_other_visual_indicators_brightness_level_ = raw()
            self.set_other_visual_indicators_brightness_level = _E_CBRNDisplayConfigurationCommand_SetOtherVisualIndicatorsBrightnessLevel.get(set_other_visual_indicators_brightness_level_, set_other_visual_indicators_brightness_level_)
        else: self.set_other_visual_indicators_brightness_level = None
        self.reserved_presence = mask & 0xFFFFFFE0
        return self

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0x1F: raise rt.Reject
        raw: list[int | float | bytes] = []
        timestamp_ = self.timestamp
        if timestamp_ is not None:
            mask |= 1
            if timestamp_ - timestamp_ != 0.0: raise rt.Reject
            raw.append(timestamp_)
        raw.append(self.station_number)
        set_display_brightness_level_ = self.set_display_brightness_level
        if set_display_brightness_level_ is not None:
            mask |= 2
            raw.append(set_display_brightness_level_)
        set_display_mode_ = self.set_display_mode
        if set_display_mode_ is not None:
            mask |= 4
            raw.append(set_display_mode_)
        set_display_contrast_ = self.set_display_contrast
        if set_display_contrast_ is not None:
            mask |= 8
            if set_display_contrast_ - set_display_contrast_ != 0.0: raise rt.Reject
            if not 0.0 <= set_display_contrast_ <= 100.0: raise rt.Reject
            raw.append(set_display_contrast_)
        set_other_visual_indicators_brightness_level_ = self.set_other_visual_indicators_brightness_level
        if set_other_visual_indicators_brightness_level_ is not None:
            mask |= 16
            raw.append(set_other_visual_indicators_brightness_level_)
        return _M_CBRNDisplayConfigurationCommand_pack[mask & 0x1F].pack(0xF929, mask, *raw)


@dataclass(slots=True, repr=False, kw_only=True)
class CBRNScanWindowConfigurationCommand(rt.Message):
    """CBRNScanWindowConfigurationCommand (0xF92A): Sets where a station scans.

    timestamp: in second, optional. Time of the message, in seconds
    station_number: Number of the station
    set_start_scan_window_azimuth: 0..6.28318548203 in radian, optional. First direction of the scan, in radians
    set_end_scan_window_azimuth: 0..6.28318548203 in radian, optional. Last direction of the scan, in radians
    set_scan_window_min_elevation: -3.14159274101..3.14159274101 in radian, optional. Lowest elevation of the scan, in radians
    set_scan_window_max_elevation: -3.14159274101..3.14159274101 in radian, optional. Highest elevation of the scan, in radians
    set_azimuth_scan_rate: in radian per second, optional. Rate of turning, in radians per second
    set_elevation_scan_rate: in radian per second, optional. Rate of tilting, in radians per second
    set_scan_mode: SetScanMode or 1..85 or 86..255, optional. Pattern of the scan
    """

    CODE = 0xF92A
    NAME = "CBRNScanWindowConfigurationCommand"
    SERVICE = "urn:jaus:jss:iop:CBRNSensor"
    VERSION = "1.1"
    IS_COMMAND = True
    IS_QUERY = False

    class SetScanMode(IntEnum):
        """Values of SetScanMode."""

        HORIZONTAL = 0

    timestamp: float | None = None
    station_number: int
    set_start_scan_window_azimuth: float | None = None
    set_end_scan_window_azimuth: float | None = None
    set_scan_window_min_elevation: float | None = None
    set_scan_window_max_elevation: float | None = None
    set_azimuth_scan_rate: float | None = None
    set_elevation_scan_rate: float | None = None
    set_scan_mode: CBRNScanWindowConfigurationCommand.SetScanMode | int | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "I",
            ("Timestamp", rt.Number("d", rt.ANY, "second"), True),
            ("StationNumber", rt.Number("I")),
            ("SetStartScanWindowAzimuth", rt.Number("f", rt.Values(None, ((0.0, 6.2831854820251465),)), "radian"), True),
            ("SetEndScanWindowAzimuth", rt.Number("f", rt.Values(None, ((0.0, 6.2831854820251465),)), "radian"), True),
            ("SetScanWindowMinElevation", rt.Number("f", rt.Values(None, ((-3.1415927410125732, 3.1415927410125732),)), "radian"), True),
            ("SetScanWindowMaxElevation", rt.Number("f", rt.Values(None, ((-3.1415927410125732, 3.1415927410125732),)), "radian"), True),
            ("SetAzimuthScanRate", rt.Number("f", rt.ANY, "radian per second"), True),
            ("SetElevationScanRate", rt.Number("f", rt.ANY, "radian per second"), True),
            ("SetScanMode", rt.Number("B", rt.Values(CBRNScanWindowConfigurationCommand.SetScanMode, ((1, 85), (86, 255)))), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_HI.unpack_from(data)
        if code != 0xF92A: raise rt.Reject
        raw = iter(_M_CBRNScanWindowConfigurationCommand[mask & 0xFF].unpack(data)).__next__
        self = rt.new(cls)
        if mask & 1:
            timestamp_ = raw()
            if timestamp_ - timestamp_ != 0.0: raise rt.Reject
            self.timestamp = timestamp_
        else: self.timestamp = None
        self.station_number = raw()
        if mask & 2:
            set_start_scan_window_azimuth_ = raw()
            if set_start_scan_window_azimuth_ - set_start_scan_window_azimuth_ != 0.0: raise rt.Reject
            if not 0.0 <= set_start_scan_window_azimuth_ <= 6.2831854820251465: raise rt.Reject
            self.set_start_scan_window_azimuth = set_start_scan_window_azimuth_
        else: self.set_start_scan_window_azimuth = None
        if mask & 4:
            set_end_scan_window_azimuth_ = raw()
            if set_end_scan_window_azimuth_ - set_end_scan_window_azimuth_ != 0.0: raise rt.Reject
            if not 0.0 <= set_end_scan_window_azimuth_ <= 6.2831854820251465: raise rt.Reject
            self.set_end_scan_window_azimuth = set_end_scan_window_azimuth_
        else: self.set_end_scan_window_azimuth = None
        if mask & 8:
            set_scan_window_min_elevation_ = raw()
            if set_scan_window_min_elevation_ - set_scan_window_min_elevation_ != 0.0: raise rt.Reject
            if not -3.1415927410125732 <= set_scan_window_min_elevation_ <= 3.1415927410125732: raise rt.Reject
            self.set_scan_window_min_elevation = set_scan_window_min_elevation_
        else: self.set_scan_window_min_elevation = None
        if mask & 16:
            set_scan_window_max_elevation_ = raw()
            if set_scan_window_max_elevation_ - set_scan_window_max_elevation_ != 0.0: raise rt.Reject
            if not -3.1415927410125732 <= set_scan_window_max_elevation_ <= 3.1415927410125732: raise rt.Reject
            self.set_scan_window_max_elevation = set_scan_window_max_elevation_
        else: self.set_scan_window_max_elevation = None
        if mask & 32:
            set_azimuth_scan_rate_ = raw()
            if set_azimuth_scan_rate_ - set_azimuth_scan_rate_ != 0.0: raise rt.Reject
            self.set_azimuth_scan_rate = set_azimuth_scan_rate_
        else: self.set_azimuth_scan_rate = None
        if mask & 64:
            set_elevation_scan_rate_ = raw()
            if set_elevation_scan_rate_ - set_elevation_scan_rate_ != 0.0: raise rt.Reject
            self.set_elevation_scan_rate = set_elevation_scan_rate_
        else: self.set_elevation_scan_rate = None
        if mask & 128:
            set_scan_mode_ = raw()
            self.set_scan_mode = _E_CBRNScanWindowConfigurationCommand_SetScanMode.get(set_scan_mode_, set_scan_mode_)
        else: self.set_scan_mode = None
        self.reserved_presence = mask & 0xFFFFFF00
        return self

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0xFF: raise rt.Reject
        raw: list[int | float | bytes] = []
        timestamp_ = self.timestamp
        if timestamp_ is not None:
            mask |= 1
            if timestamp_ - timestamp_ != 0.0: raise rt.Reject
            raw.append(timestamp_)
        raw.append(self.station_number)
        set_start_scan_window_azimuth_ = self.set_start_scan_window_azimuth
        if set_start_scan_window_azimuth_ is not None:
            mask |= 2
            if set_start_scan_window_azimuth_ - set_start_scan_window_azimuth_ != 0.0: raise rt.Reject
            if not 0.0 <= set_start_scan_window_azimuth_ <= 6.2831854820251465: raise rt.Reject
            raw.append(set_start_scan_window_azimuth_)
        set_end_scan_window_azimuth_ = self.set_end_scan_window_azimuth
        if set_end_scan_window_azimuth_ is not None:
            mask |= 4
            if set_end_scan_window_azimuth_ - set_end_scan_window_azimuth_ != 0.0: raise rt.Reject
            if not 0.0 <= set_end_scan_window_azimuth_ <= 6.2831854820251465: raise rt.Reject
            raw.append(set_end_scan_window_azimuth_)
        set_scan_window_min_elevation_ = self.set_scan_window_min_elevation
        if set_scan_window_min_elevation_ is not None:
            mask |= 8
            if set_scan_window_min_elevation_ - set_scan_window_min_elevation_ != 0.0: raise rt.Reject
            if not -3.1415927410125732 <= set_scan_window_min_elevation_ <= 3.1415927410125732: raise rt.Reject
            raw.append(set_scan_window_min_elevation_)
        set_scan_window_max_elevation_ = self.set_scan_window_max_elevation
        if set_scan_window_max_elevation_ is not None:
            mask |= 16
            if set_scan_window_max_elevation_ - set_scan_window_max_elevation_ != 0.0: raise rt.Reject
            if not -3.1415927410125732 <= set_scan_window_max_elevation_ <= 3.1415927410125732: raise rt.Reject
            raw.append(set_scan_window_max_elevation_)
        set_azimuth_scan_rate_ = self.set_azimuth_scan_rate
        if set_azimuth_scan_rate_ is not None:
            mask |= 32
            if set_azimuth_scan_rate_ - set_azimuth_scan_rate_ != 0.0: raise rt.Reject
            raw.append(set_azimuth_scan_rate_)
        set_elevation_scan_rate_ = self.set_elevation_scan_rate
        if set_elevation_scan_rate_ is not None:
            mask |= 64
            if set_elevation_scan_rate_ - set_elevation_scan_rate_ != 0.0: raise rt.Reject
            raw.append(set_elevation_scan_rate_)
        set_scan_mode_ = self.set_scan_mode
        if set_scan_mode_ is not None:
            mask |= 128
            raw.append(set_scan_mode_)
        return _M_CBRNScanWindowConfigurationCommand_pack[mask & 0xFF].pack(0xF92A, mask, *raw)


@dataclass(slots=True, repr=False, kw_only=True)
class CBRN4(rt.Message):
    """CBRN4 (0xF930): Carries a CBRN 4 report.

    timestamp: in second, optional. Time of the message, in seconds
    station_number: Number of the station
    detection_type: DetectionType or 4..85 or 86..255, optional. Relation of the level to the threshold
    cbrn4_report_id: optional. Number of the report
    cbrn4: up to 65535 characters. The report, as text of its own format
    """

    CODE = 0xF930
    NAME = "CBRN4"
    SERVICE = "urn:jaus:jss:iop:CBRNSensor"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    class DetectionType(IntEnum):
        """Values of DetectionType."""

        BELOW_THRESHOLD = 0
        ABOVE_THRESHOLD = 1
        ABOVE_THRESHOLD_UPDATE = 2
        NIL = 3

    timestamp: float | None = None
    station_number: int
    detection_type: CBRN4.DetectionType | int | None = None
    cbrn4_report_id: int | None = None
    cbrn4: str
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("Timestamp", rt.Number("d", rt.ANY, "second"), True),
            ("StationNumber", rt.Number("I")),
            ("DetectionType", rt.Number("B", rt.Values(CBRN4.DetectionType, ((4, 85), (86, 255)))), True),
            ("CBRN4ReportID", rt.Number("I"), True),
            ("CBRN4", rt.Text(count=rt.Count("H", 0, 65535))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x30 or data[1] != 0xF9: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        mask = data[2]
        packer = _M_CBRN4_0[mask & 0x7]
        raw = iter(packer.unpack_from(data, 3)).__next__
        at = 3 + packer.size
        if mask & 1:
            timestamp_ = raw()
            if timestamp_ - timestamp_ != 0.0: raise rt.Reject
            self.timestamp = timestamp_
        else: self.timestamp = None
        self.station_number = raw()
        if mask & 2:
            detection_type_ = raw()
            self.detection_type = _E_CBRN4_DetectionType.get(detection_type_, detection_type_)
        else: self.detection_type = None
        self.cbrn4_report_id = raw() if mask & 4 else None
        (cbrn4_end_,) = _S_H.unpack_from(data, at)
        cbrn4_end_ += at + 2
        self.cbrn4 = data[at + 2:cbrn4_end_].decode("latin-1")
        self.reserved_presence = mask & 0xF8
        if cbrn4_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x30\xf9")
        start = len(out)
        out += b"\0"
        mask = self.reserved_presence
        if mask & 0x7: raise rt.Reject
        raw: list[int | float | bytes] = []
        timestamp_ = self.timestamp
        if timestamp_ is not None:
            mask |= 1
            if timestamp_ - timestamp_ != 0.0: raise rt.Reject
            raw.append(timestamp_)
        raw.append(self.station_number)
        detection_type_ = self.detection_type
        if detection_type_ is not None:
            mask |= 2
            raw.append(detection_type_)
        cbrn4_report_id_ = self.cbrn4_report_id
        if cbrn4_report_id_ is not None:
            mask |= 4
            raw.append(cbrn4_report_id_)
        out += _M_CBRN4_0[mask & 0x7].pack(*raw)
        cbrn4_raw_ = self.cbrn4.encode("latin-1")
        out += _S_H.pack(len(cbrn4_raw_))
        out += cbrn4_raw_
        _S_B.pack_into(out, start, mask)
        return bytes(out)


@dataclass(slots=True, repr=False, kw_only=True)
class CBRNDetection(rt.Message):
    """CBRNDetection (0xF931): Tells a detection.

    timestamp: in second, optional. Time of the message, in seconds
    station_number: Number of the station
    detection_type: DetectionType or 4..85 or 86..255. Relation of the level to the threshold
    substance_detected: up to 9 characters, optional. Name of the substance
    contamination_level: in second, optional. Measured level, in the unit that is told beside it
    contamination_level_uo_m: ContaminationLevelUoM or 24..85 or 86..255, optional. Unit of the measured level
    detection_timestamp: in second, optional. Time of the detection, in seconds
    cbrn4_report_reference: optional. Number of the CBRN 4 report about this detection
    distance_to_cloud: in meter, optional. Distance to the cloud, in metres
    left_radial_line: -3.14159274101..3.14159274101 in radian, optional. Direction of the left edge of the cloud, in radians
    right_radial_line: -3.14159274101..3.14159274101 in radian, optional. Direction of the right edge of the cloud, in radians
    cloud_top_angle: -3.14159274101..3.14159274101 in radian, optional. Elevation of the upper edge of the cloud, in radians
    cloud_bottom_angle: -3.14159274101..3.14159274101 in radian, optional. Elevation of the lower edge of the cloud, in radians
    detection_latitude: -1.57079632679..1.57079632679 in radian, optional. Latitude of the detection (WGS 84), in radians
    detection_longitude: -3.14159265359..3.14159265359 in radian, optional. Longitude of the detection (WGS 84), in radians
    detection_altitude: -1000..100000 in meter, optional. Altitude of the detection, in metres
    """

    CODE = 0xF931
    NAME = "CBRNDetection"
    SERVICE = "urn:jaus:jss:iop:CBRNSensor"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    class DetectionType(IntEnum):
        """Values of DetectionType."""

        BELOW_THRESHOLD = 0
        ABOVE_THRESHOLD = 1
        ABOVE_THRESHOLD_UPDATE = 2
        NIL = 3

    class ContaminationLevelUoM(IntEnum):
        """Values of ContaminationLevelUoM."""

        UNSPECIFIED = 0
        ACPL = 1
        BQM2 = 2
        BQM3 = 3
        RESERVED_4 = 4
        RESERVED_5 = 5
        RESERVED_6 = 6
        RESERVED_7 = 7
        RESERVED_8 = 8
        RESERVED_9 = 9
        RESERVED_10 = 10
        RESERVED_11 = 11
        RESERVED_12 = 12
        RESERVED_13 = 13
        RESERVED_14 = 14
        RESERVED_15 = 15
        RESERVED_16 = 16
        RESERVED_17 = 17
        RESERVED_18 = 18
        RESERVED_19 = 19
        RESERVED_20 = 20
        RESERVED_21 = 21
        RESERVED_22 = 22
        RESERVED_23 = 23

    timestamp: float | None = None
    station_number: int
    detection_type: CBRNDetection.DetectionType | int
    substance_detected: str | None = None
    contamination_level: float | None = None
    contamination_level_uo_m: CBRNDetection.ContaminationLevelUoM | int | None = None
    detection_timestamp: float | None = None
    cbrn4_report_reference: int | None = None
    distance_to_cloud: int | None = None
    left_radial_line: float | None = None
    right_radial_line: float | None = None
    cloud_top_angle: float | None = None
    cloud_bottom_angle: float | None = None
    detection_latitude: float | None = None
    detection_longitude: float | None = None
    detection_altitude: float | None = None

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("Timestamp", rt.Number("d", rt.ANY, "second"), True),
            ("StationNumber", rt.Number("I")),
            ("DetectionType", rt.Number("B", rt.Values(CBRNDetection.DetectionType, ((4, 85), (86, 255))))),
            ("SubstanceDetected", rt.Text(count=rt.Count("B", 0, 9)), True),
            ("ContaminationLevel", rt.Number("d", rt.ANY, "second"), True),
            ("ContaminationLevelUoM", rt.Number("B", rt.Values(CBRNDetection.ContaminationLevelUoM, ((24, 85), (86, 255)))), True),
            ("DetectionTimestamp", rt.Number("d", rt.ANY, "second"), True),
            ("CBRN4ReportReference", rt.Number("I"), True),
            ("DistanceToCloud", rt.Number("I", rt.ANY, "meter"), True),
            ("LeftRadialLine", rt.Number("f", rt.Values(None, ((-3.1415927410125732, 3.1415927410125732),)), "radian"), True),
            ("RightRadialLine", rt.Number("f", rt.Values(None, ((-3.1415927410125732, 3.1415927410125732),)), "radian"), True),
            ("CloudTopAngle", rt.Number("f", rt.Values(None, ((-3.1415927410125732, 3.1415927410125732),)), "radian"), True),
            ("CloudBottomAngle", rt.Number("f", rt.Values(None, ((-3.1415927410125732, 3.1415927410125732),)), "radian"), True),
            ("DetectionLatitude", rt.Number("d", rt.Values(None, ((-1.57079632679, 1.57079632679),)), "radian"), True),
            ("DetectionLongitude", rt.Number("d", rt.Values(None, ((-3.141592653589793, 3.141592653589793),)), "radian"), True),
            ("DetectionAltitude", rt.Number("f", rt.Values(None, ((-1000.0, 100000.0),)), "meter"), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x31 or data[1] != 0xF9: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        mask = data[2]
        packer = _M_CBRNDetection_0[mask & 0x1]
        raw = iter(packer.unpack_from(data, 3)).__next__
        at = 3 + packer.size
        if mask & 1:
            timestamp_ = raw()
            if timestamp_ - timestamp_ != 0.0: raise rt.Reject
            self.timestamp = timestamp_
        else: self.timestamp = None
        self.station_number = raw()
        detection_type_ = raw()
        self.detection_type = _E_CBRNDetection_DetectionType.get(detection_type_, detection_type_)
        if mask & 2:
            substance_detected_end_ = data[at]
            if substance_detected_end_ > 9: raise rt.Reject
            substance_detected_end_ += at + 1
            self.substance_detected = data[at + 1:substance_detected_end_].decode("latin-1")
            at = substance_detected_end_
        else: self.substance_detected = None
        packer = _M_CBRNDetection_2[mask & 0xFC]
        raw = iter(packer.unpack_from(data, at)).__next__
        at += packer.size
        if mask & 4:
            contamination_level_ = raw()
            if contamination_level_ - contamination_level_ != 0.0: raise rt.Reject
            self.contamination_level = contamination_level_
        else: self.contamination_level = None
        if mask & 8:
            contamination_level_uo_m_ = raw()
            self.contamination_level_uo_m = _E_CBRNDetection_ContaminationLevelUoM.get(contamination_level_uo_m_, contamination_level_uo_m_)
        else: self.contamination_level_uo_m = None
        if mask & 16:
            detection_timestamp_ = raw()
            if detection_timestamp_ - detection_timestamp_ != 0.0: raise rt.Reject
            self.detection_timestamp = detection_timestamp_
        else: self.detection_timestamp = None
        self.cbrn4_report_reference = raw() if mask & 32 else None
        self.distance_to_cloud = raw() if mask & 64 else None
        if mask & 128:
            left_radial_line_ = raw()
            if left_radial_line_ - left_radial_line_ != 0.0: raise rt.Reject
            if not -3.1415927410125732 <= left_radial_line_ <= 3.1415927410125732: raise rt.Reject
            self.left_radial_line = left_radial_line_
        else: self.left_radial_line = None
        self.right_radial_line = None
        self.cloud_top_angle = None
        self.cloud_bottom_angle = None
        self.detection_latitude = None
        self.detection_longitude = None
        self.detection_altitude = None
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x31\xf9")
        start = len(out)
        out += b"\0"
        mask = 0
        raw: list[int | float | bytes] = []
        timestamp_ = self.timestamp
        if timestamp_ is not None:
            mask |= 1
            if timestamp_ - timestamp_ != 0.0: raise rt.Reject
            raw.append(timestamp_)
        raw.append(self.station_number)
        raw.append(self.detection_type)
        out += _M_CBRNDetection_0[mask & 0x1].pack(*raw)
        substance_detected_ = self.substance_detected
        if substance_detected_ is not None:
            mask |= 2
            substance_detected_raw_ = substance_detected_.encode("latin-1")
            if len(substance_detected_raw_) > 9: raise rt.Reject
            out.append(len(substance_detected_raw_))
            out += substance_detected_raw_
        raw = []
        contamination_level_ = self.contamination_level
        if contamination_level_ is not None:
            mask |= 4
            if contamination_level_ - contamination_level_ != 0.0: raise rt.Reject
            raw.append(contamination_level_)
        contamination_level_uo_m_ = self.contamination_level_uo_m
        if contamination_level_uo_m_ is not None:
            mask |= 8
            raw.append(contamination_level_uo_m_)
        detection_timestamp_ = self.detection_timestamp
        if detection_timestamp_ is not None:
            mask |= 16
            if detection_timestamp_ - detection_timestamp_ != 0.0: raise rt.Reject
            raw.append(detection_timestamp_)
        cbrn4_report_reference_ = self.cbrn4_report_reference
        if cbrn4_report_reference_ is not None:
            mask |= 32
            raw.append(cbrn4_report_reference_)
        distance_to_cloud_ = self.distance_to_cloud
        if distance_to_cloud_ is not None:
            mask |= 64
            raw.append(distance_to_cloud_)
        left_radial_line_ = self.left_radial_line
        if left_radial_line_ is not None:
            mask |= 128
            if left_radial_line_ - left_radial_line_ != 0.0: raise rt.Reject
            if not -3.1415927410125732 <= left_radial_line_ <= 3.1415927410125732: raise rt.Reject
            raw.append(left_radial_line_)
        right_radial_line_ = self.right_radial_line
        if right_radial_line_ is not None: raise rt.Reject
        cloud_top_angle_ = self.cloud_top_angle
        if cloud_top_angle_ is not None: raise rt.Reject
        cloud_bottom_angle_ = self.cloud_bottom_angle
        if cloud_bottom_angle_ is not None: raise rt.Reject
        detection_latitude_ = self.detection_latitude
        if detection_latitude_ is not None: raise rt.Reject
        detection_longitude_ = self.detection_longitude
        if detection_longitude_ is not None: raise rt.Reject
        detection_altitude_ = self.detection_altitude
        if detection_altitude_ is not None: raise rt.Reject
        out += _M_CBRNDetection_2[mask & 0xFC].pack(*raw)
        _S_B.pack_into(out, start, mask)
        return bytes(out)


@dataclass(slots=True, repr=False, kw_only=True)
class RNDetailedMeasurement(rt.Message):
    """RNDetailedMeasurement (0xF932): Tells details of a radiological or nuclear detection.

    timestamp: in second, optional. Time of the message, in seconds
    station_number: Number of the station
    detection_type: DetectionType or 4..85 or 86..255, optional. Relation of the level to the threshold
    measurement: up to 65535 characters. The measurement, as text of its own format
    """

    CODE = 0xF932
    NAME = "RNDetailedMeasurement"
    SERVICE = "urn:jaus:jss:iop:CBRNSensor"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    class DetectionType(IntEnum):
        """Values of DetectionType."""

        BELOW_THRESHOLD = 0
        ABOVE_THRESHOLD = 1
        ABOVE_THRESHOLD_UPDATE = 2
        NIL = 3

    timestamp: float | None = None
    station_number: int
    detection_type: RNDetailedMeasurement.DetectionType | int | None = None
    measurement: str
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("Timestamp", rt.Number("d", rt.ANY, "second"), True),
            ("StationNumber", rt.Number("I")),
            ("DetectionType", rt.Number("B", rt.Values(RNDetailedMeasurement.DetectionType, ((4, 85), (86, 255)))), True),
            ("Measurement", rt.Text(count=rt.Count("H", 0, 65535))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x32 or data[1] != 0xF9: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        mask = data[2]
        packer = _M_RNDetailedMeasurement_0[mask & 0x3]
        raw = iter(packer.unpack_from(data, 3)).__next__
        at = 3 + packer.size
        if mask & 1:
            timestamp_ = raw()
            if timestamp_ - timestamp_ != 0.0: raise rt.Reject
            self.timestamp = timestamp_
        else: self.timestamp = None
        self.station_number = raw()
        if mask & 2:
            detection_type_ = raw()
            self.detection_type = _E_RNDetailedMeasurement_DetectionType.get(detection_type_, detection_type_)
        else: self.detection_type = None
        (measurement_end_,) = _S_H.unpack_from(data, at)
        measurement_end_ += at + 2
        self.measurement = data[at + 2:measurement_end_].decode("latin-1")
        self.reserved_presence = mask & 0xFC
        if measurement_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x32\xf9")
        start = len(out)
        out += b"\0"
        mask = self.reserved_presence
        if mask & 0x3: raise rt.Reject
        raw: list[int | float | bytes] = []
        timestamp_ = self.timestamp
        if timestamp_ is not None:
            mask |= 1
            if timestamp_ - timestamp_ != 0.0: raise rt.Reject
            raw.append(timestamp_)
        raw.append(self.station_number)
        detection_type_ = self.detection_type
        if detection_type_ is not None:
            mask |= 2
            raw.append(detection_type_)
        out += _M_RNDetailedMeasurement_0[mask & 0x3].pack(*raw)
        measurement_raw_ = self.measurement.encode("latin-1")
        out += _S_H.pack(len(measurement_raw_))
        out += measurement_raw_
        _S_B.pack_into(out, start, mask)
        return bytes(out)


@dataclass(slots=True, repr=False, kw_only=True)
class CBDetailedMeasurement(rt.Message):
    """CBDetailedMeasurement (0xF932): Tells details of a chemical or biological detection.

    timestamp: in second, optional. Time of the message, in seconds
    station_number: Number of the station
    detection_type: DetectionType or 4..85 or 86..255, optional. Relation of the level to the threshold
    measurement: up to 65535 characters. The measurement, as text of its own format
    """

    CODE = 0xF932
    NAME = "CBDetailedMeasurement"
    SERVICE = "urn:jaus:jss:iop:CBRNSensor"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    class DetectionType(IntEnum):
        """Values of DetectionType."""

        BELOW_THRESHOLD = 0
        ABOVE_THRESHOLD = 1
        ABOVE_THRESHOLD_UPDATE = 2
        NIL = 3

    timestamp: float | None = None
    station_number: int
    detection_type: CBDetailedMeasurement.DetectionType | int | None = None
    measurement: str
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("Timestamp", rt.Number("d", rt.ANY, "second"), True),
            ("StationNumber", rt.Number("I")),
            ("DetectionType", rt.Number("B", rt.Values(CBDetailedMeasurement.DetectionType, ((4, 85), (86, 255)))), True),
            ("Measurement", rt.Text(count=rt.Count("H", 0, 65535))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x32 or data[1] != 0xF9: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        mask = data[2]
        packer = _M_RNDetailedMeasurement_0[mask & 0x3]
        raw = iter(packer.unpack_from(data, 3)).__next__
        at = 3 + packer.size
        if mask & 1:
            timestamp_ = raw()
            if timestamp_ - timestamp_ != 0.0: raise rt.Reject
            self.timestamp = timestamp_
        else: self.timestamp = None
        self.station_number = raw()
        if mask & 2:
            detection_type_ = raw()
            self.detection_type = _E_CBDetailedMeasurement_DetectionType.get(detection_type_, detection_type_)
        else: self.detection_type = None
        (measurement_end_,) = _S_H.unpack_from(data, at)
        measurement_end_ += at + 2
        self.measurement = data[at + 2:measurement_end_].decode("latin-1")
        self.reserved_presence = mask & 0xFC
        if measurement_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x32\xf9")
        start = len(out)
        out += b"\0"
        mask = self.reserved_presence
        if mask & 0x3: raise rt.Reject
        raw: list[int | float | bytes] = []
        timestamp_ = self.timestamp
        if timestamp_ is not None:
            mask |= 1
            if timestamp_ - timestamp_ != 0.0: raise rt.Reject
            raw.append(timestamp_)
        raw.append(self.station_number)
        detection_type_ = self.detection_type
        if detection_type_ is not None:
            mask |= 2
            raw.append(detection_type_)
        out += _M_RNDetailedMeasurement_0[mask & 0x3].pack(*raw)
        measurement_raw_ = self.measurement.encode("latin-1")
        out += _S_H.pack(len(measurement_raw_))
        out += measurement_raw_
        _S_B.pack_into(out, start, mask)
        return bytes(out)


@dataclass(slots=True, repr=False, kw_only=True)
class CBRNOperatingState(rt.Message):
    """CBRNOperatingState (0xF934): Tells the state of a station.

    timestamp: in second, optional. Time of the message, in seconds
    station_number: Number of the station
    gps_fix: GPSFix or 2..85 or 86..255, optional. Whether satellite navigation works
    power_source: PowerSource or 2..85 or 86..255, optional. Where power comes from
    battery_remaining: 0..100, optional. Charge of the battery, in percent
    battery_voltage: in volt, optional. Voltage of the battery, in volts
    uptime: in minute, optional. Time since the start, in minutes
    payload_state: PayloadState or 8..85 or 86..255, optional. State of the station
    payload_latitude: -1.57079632679..1.57079632679 in radian, optional. Latitude of the station (WGS 84), in radians
    payload_longitude: -3.14159265359..3.14159265359 in radian, optional. Longitude of the station (WGS 84), in radians
    payload_altitude: -1000..100000 in meter, optional. Altitude of the station, in metres
    background_level: 0..1000000000, optional. Level that is there without a hazard
    communication_method: CommunicationMethod or 2..85 or 86..255, optional. How the station is connected
    communication_signal_strength: 0..100, optional. Strength of the radio signal, in percent
    temperature_state: TemperatureState or 3..85 or 86..255, optional. Whether the station is at its working temperature
    local_alarm_enunciation_state: LocalAlarmEnunciationState or 2..85 or 86..255, optional. Whether the alarm sounds
    internal_time: in second, optional. Clock of the station, in seconds
    operating_mode: OperatingMode or 3..85 or 86..255, optional. Whether the station works
    sampling_state: SamplingState or 5..85 or 86..255, optional. What the sampler does
    testing_state: TestingState or 9..85 or 86..255, optional. What is being tested
    """

    CODE = 0xF934
    NAME = "CBRNOperatingState"
    SERVICE = "urn:jaus:jss:iop:CBRNSensor"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    class GPSFix(IntEnum):
        """Values of GPSFix."""

        NOT_LOCKED = 0
        LOCKED = 1

    class PowerSource(IntEnum):
        """Values of PowerSource."""

        AC_DC = 0
        BATTERY = 1

    class PayloadState(IntEnum):
        """Values of PayloadState."""

        HAS_FAULTS = 0
        HAS_WARNINGS = 1
        ABOVE_THRESHOLD = 2
        OPERATING = 3
        POWERED_OFF = 4
        STARTING_UP = 5
        CALIBRATING = 6
        TESTING = 7

    class CommunicationMethod(IntEnum):
        """Values of CommunicationMethod."""

        WIRELESS = 0
        WIRED = 1

    class TemperatureState(IntEnum):
        """Values of TemperatureState."""

        NORMAL = 0
        WARMING_UP = 1
        COOLING_DOWN = 2

    class LocalAlarmEnunciationState(IntEnum):
        """Values of LocalAlarmEnunciationState."""

        ALARM_SILENCED = 0
        ALARM_ACTIVATED = 1

    class OperatingMode(IntEnum):
        """Values of OperatingMode."""

        OPERATING = 0
        STANDBY = 1
        TRAINING = 2

    class SamplingState(IntEnum):
        """Values of SamplingState."""

        IDLE = 0
        SAMPLING = 1
        SENSING_TEST = 2
        SCANNING = 3
        TRACKING = 4

    class TestingState(IntEnum):
        """Values of TestingState."""

        NOT_TESTING = 0
        SELF_TESTING = 1
        AUDIO_TESTING = 2
        CONTROL_TESTING = 3
        POWER_DISTRIBUTION_TESTING = 4
        SENSING_TEST = 5
        WIRELESS_TESTING = 6
        DISMOUNTED_POWER_TESTING = 7
        DISPLAY_TESTING = 8

    timestamp: float | None = None
    station_number: int
    gps_fix: CBRNOperatingState.GPSFix | int | None = None
    power_source: CBRNOperatingState.PowerSource | int | None = None
    battery_remaining: float | None = None
    battery_voltage: float | None = None
    uptime: int | None = None
    payload_state: CBRNOperatingState.PayloadState | int | None = None
    payload_latitude: float | None = None
    payload_longitude: float | None = None
    payload_altitude: float | None = None
    background_level: float | None = None
    communication_method: CBRNOperatingState.CommunicationMethod | int | None = None
    communication_signal_strength: int | None = None
    temperature_state: CBRNOperatingState.TemperatureState | int | None = None
    local_alarm_enunciation_state: CBRNOperatingState.LocalAlarmEnunciationState | int | None = None
    internal_time: float | None = None
    operating_mode: CBRNOperatingState.OperatingMode | int | None = None
    sampling_state: CBRNOperatingState.SamplingState | int | None = None
    testing_state: CBRNOperatingState.TestingState | int | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "I",
            ("Timestamp", rt.Number("d", rt.ANY, "second"), True),
            ("StationNumber", rt.Number("I")),
            ("GPSFix", rt.Number("B", rt.Values(CBRNOperatingState.GPSFix, ((2, 85), (86, 255)))), True),
            ("PowerSource", rt.Number("B", rt.Values(CBRNOperatingState.PowerSource, ((2, 85), (86, 255)))), True),
            ("BatteryRemaining", rt.Number("f", rt.Values(None, ((0.0, 100.0),))), True),
            ("BatteryVoltage", rt.Number("f", rt.ANY, "volt"), True),
            ("Uptime", rt.Number("I", rt.ANY, "minute"), True),
            ("PayloadState", rt.Number("B", rt.Values(CBRNOperatingState.PayloadState, ((8, 85), (86, 255)))), True),
            ("PayloadLatitude", rt.Number("d", rt.Values(None, ((-1.57079632679, 1.57079632679),)), "radian"), True),
            ("PayloadLongitude", rt.Number("d", rt.Values(None, ((-3.141592653589793, 3.141592653589793),)), "radian"), True),
            ("PayloadAltitude", rt.Number("f", rt.Values(None, ((-1000.0, 100000.0),)), "meter"), True),
            ("BackgroundLevel", rt.Number("d", rt.Values(None, ((0.0, 1000000000.0),))), True),
            ("CommunicationMethod", rt.Number("B", rt.Values(CBRNOperatingState.CommunicationMethod, ((2, 85), (86, 255)))), True),
            ("CommunicationSignalStrength", rt.Number("B", rt.Values(None, ((0, 100),))), True),
            ("TemperatureState", rt.Number("B", rt.Values(CBRNOperatingState.TemperatureState, ((3, 85), (86, 255)))), True),
            ("LocalAlarmEnunciationState", rt.Number("B", rt.Values(CBRNOperatingState.LocalAlarmEnunciationState, ((2, 85), (86, 255)))), True),
            ("InternalTime", rt.Number("d", rt.ANY, "second"), True),
            ("OperatingMode", rt.Number("B", rt.Values(CBRNOperatingState.OperatingMode, ((3, 85), (86, 255)))), True),
            ("SamplingState", rt.Number("B", rt.Values(CBRNOperatingState.SamplingState, ((5, 85), (86, 255)))), True),
            ("TestingState", rt.Number("B", rt.Values(CBRNOperatingState.TestingState, ((9, 85), (86, 255)))), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_HI.unpack_from(data)
        if code != 0xF934: raise rt.Reject
        raw = iter(_M_CBRNOperatingState[mask & 0x7FFFF].unpack(data)).__next__
        self = rt.new(cls)
        if mask & 1:
            timestamp_ = raw()
            if timestamp_ - timestamp_ != 0.0: raise rt.Reject
            self.timestamp = timestamp_
        else: self.timestamp = None
        self.station_number = raw()
        if mask & 2:
            gps_fix_ = raw()
            self.gps_fix = _E_CBRNOperatingState_GPSFix.get(gps_fix_, gps_fix_)
        else: self.gps_fix = None
        if mask & 4:
            power_source_ = raw()
            self.power_source = _E_CBRNOperatingState_PowerSource.get(power_source_, power_source_)
        else: self.power_source = None
        if mask & 8:
            battery_remaining_ = raw()
            if battery_remaining_ - battery_remaining_ != 0.0: raise rt.Reject
            if not 0.0 <= battery_remaining_ <= 100.0: raise rt.Reject
            self.battery_remaining = battery_remaining_
        else: self.battery_remaining = None
        if mask & 16:
            battery_voltage_ = raw()
            if battery_voltage_ - battery_voltage_ != 0.0: raise rt.Reject
            self.battery_voltage = battery_voltage_
        else: self.battery_voltage = None
        self.uptime = raw() if mask & 32 else None
        if mask & 64:
            payload_state_ = raw()
            self.payload_state = _E_CBRNOperatingState_PayloadState.get(payload_state_, payload_state_)
        else: self.payload_state = None
        if mask & 128:
            payload_latitude_ = raw()
            if payload_latitude_ - payload_latitude_ != 0.0: raise rt.Reject
            if not -1.57079632679 <= payload_latitude_ <= 1.57079632679: raise rt.Reject
            self.payload_latitude = payload_latitude_
        else: self.payload_latitude = None
        if mask & 256:
            payload_longitude_ = raw()
            if payload_longitude_ - payload_longitude_ != 0.0: raise rt.Reject
            if not -3.141592653589793 <= payload_longitude_ <= 3.141592653589793: raise rt.Reject
            self.payload_longitude = payload_longitude_
        else: self.payload_longitude = None
        if mask & 512:
            payload_altitude_ = raw()
            if payload_altitude_ - payload_altitude_ != 0.0: raise rt.Reject
            if not -1000.0 <= payload_altitude_ <= 100000.0: raise rt.Reject
            self.payload_altitude = payload_altitude_
        else: self.payload_altitude = None
        if mask & 1024:
            background_level_ = raw()
            if background_level_ - background_level_ != 0.0: raise rt.Reject
            if not 0.0 <= background_level_ <= 1000000000.0: raise rt.Reject
            self.background_level = background_level_
        else: self.background_level = None
        if mask & 2048:
            communication_method_ = raw()
            self.communication_method = _E_CBRNOperatingState_CommunicationMethod.get(communication_method_, communication_method_)
        else: self.communication_method = None
        if mask & 4096:
            communication_signal_strength_ = raw()
            if communication_signal_strength_ > 100: raise rt.Reject
            self.communication_signal_strength = communication_signal_strength_
        else: self.communication_signal_strength = None
        if mask & 8192:
            temperature_state_ = raw()
            self.temperature_state = _E_CBRNOperatingState_TemperatureState.get(temperature_state_, temperature_state_)
        else: self.temperature_state = None
        if mask & 16384:
            local_alarm_enunciation_state_ = raw()
            self.local_alarm_enunciation_state = _E_CBRNOperatingState_LocalAlarmEnunciationState.get(local_alarm_enunciation_state_, local_alarm_enunciation_state_)
        else: self.local_alarm_enunciation_state = None
        if mask & 32768:
            internal_time_ = raw()
            if internal_time_ - internal_time_ != 0.0: raise rt.Reject
            self.internal_time = internal_time_
        else: self.internal_time = None
        if mask & 65536:
            operating_mode_ = raw()
            self.operating_mode = _E_CBRNOperatingState_OperatingMode.get(operating_mode_, operating_mode_)
        else: self.operating_mode = None
        if mask & 131072:
            sampling_state_ = raw()
            self.sampling_state = _E_CBRNOperatingState_SamplingState.get(sampling_state_, sampling_state_)
        else: self.sampling_state = None
        if mask & 262144:
            testing_state_ = raw()
            self.testing_state = _E_CBRNOperatingState_TestingState.get(testing_state_, testing_state_)
        else: self.testing_state = None
        self.reserved_presence = mask & 0xFFF80000
        return self

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0x7FFFF: raise rt.Reject
        raw: list[int | float | bytes] = []
        timestamp_ = self.timestamp
        if timestamp_ is not None:
            mask |= 1
            if timestamp_ - timestamp_ != 0.0: raise rt.Reject
            raw.append(timestamp_)
        raw.append(self.station_number)
        gps_fix_ = self.gps_fix
        if gps_fix_ is not None:
            mask |= 2
            raw.append(gps_fix_)
        power_source_ = self.power_source
        if power_source_ is not None:
            mask |= 4
            raw.append(power_source_)
        battery_remaining_ = self.battery_remaining
        if battery_remaining_ is not None:
            mask |= 8
            if battery_remaining_ - battery_remaining_ != 0.0: raise rt.Reject
            if not 0.0 <= battery_remaining_ <= 100.0: raise rt.Reject
            raw.append(battery_remaining_)
        battery_voltage_ = self.battery_voltage
        if battery_voltage_ is not None:
            mask |= 16
            if battery_voltage_ - battery_voltage_ != 0.0: raise rt.Reject
            raw.append(battery_voltage_)
        uptime_ = self.uptime
        if uptime_ is not None:
            mask |= 32
            raw.append(uptime_)
        payload_state_ = self.payload_state
        if payload_state_ is not None:
            mask |= 64
            raw.append(payload_state_)
        payload_latitude_ = self.payload_latitude
        if payload_latitude_ is not None:
            mask |= 128
            if payload_latitude_ - payload_latitude_ != 0.0: raise rt.Reject
            if not -1.57079632679 <= payload_latitude_ <= 1.57079632679: raise rt.Reject
            raw.append(payload_latitude_)
        payload_longitude_ = self.payload_longitude
        if payload_longitude_ is not None:
            mask |= 256
            if payload_longitude_ - payload_longitude_ != 0.0: raise rt.Reject
            if not -3.141592653589793 <= payload_longitude_ <= 3.141592653589793: raise rt.Reject
            raw.append(payload_longitude_)
        payload_altitude_ = self.payload_altitude
        if payload_altitude_ is not None:
            mask |= 512
            if payload_altitude_ - payload_altitude_ != 0.0: raise rt.Reject
            if not -1000.0 <= payload_altitude_ <= 100000.0: raise rt.Reject
            raw.append(payload_altitude_)
        background_level_ = self.background_level
        if background_level_ is not None:
            mask |= 1024
            if background_level_ - background_level_ != 0.0: raise rt.Reject
            if not 0.0 <= background_level_ <= 1000000000.0: raise rt.Reject
            raw.append(background_level_)
        communication_method_ = self.communication_method
        if communication_method_ is not None:
            mask |= 2048
            raw.append(communication_method_)
        communication_signal_strength_ = self.communication_signal_strength
        if communication_signal_strength_ is not None:
            mask |= 4096
            if not 0 <= communication_signal_strength_ <= 100: raise rt.Reject
            raw.append(communication_signal_strength_)
        temperature_state_ = self.temperature_state
        if temperature_state_ is not None:
            mask |= 8192
            raw.append(temperature_state_)
        local_alarm_enunciation_state_ = self.local_alarm_enunciation_state
        if local_alarm_enunciation_state_ is not None:
            mask |= 16384
            raw.append(local_alarm_enunciation_state_)
        internal_time_ = self.internal_time
        if internal_time_ is not None:
            mask |= 32768
            if internal_time_ - internal_time_ != 0.0: raise rt.Reject
            raw.append(internal_time_)
        operating_mode_ = self.operating_mode
        if operating_mode_ is not None:
            mask |= 65536
            raw.append(operating_mode_)
        sampling_state_ = self.sampling_state
        if sampling_state_ is not None:
            mask |= 131072
            raw.append(sampling_state_)
        testing_state_ = self.testing_state
        if testing_state_ is not None:
            mask |= 262144
            raw.append(testing_state_)
        return _M_CBRNOperatingState_pack[mask & 0x7FFFF].pack(0xF934, mask, *raw)


@dataclass(slots=True, repr=False, kw_only=True)
class CBRNConfigurationState(rt.Message):
    """CBRNConfigurationState (0xF935): Tells the settings of a station.

    timestamp: in second, optional. Time of the message, in seconds
    station_number: Number of the station
    exer_oper_name: up to 57 characters, optional. Name of the exercise or operation
    exer_oper_flag: ExerOperFlag or 2..85 or 86..255, optional. Whether this is an exercise
    call_sign: up to 31 characters, optional. Call sign of the station
    positioning_mode: PositioningMode or 2..85 or 86..255, optional. Whether the position is measured or set
    payload_sensitivity: PayloadSensitivity or 2..85 or 86..255, optional. Sensitivity of the station
    background_level_subtract_mode: BackgroundLevelSubtractMode or 2..85 or 86..255, optional. Whether the background is taken off the measurement
    background_level_mode: BackgroundLevelMode or 2..85 or 86..255, optional. Whether the background is measured or set
    detection_mode: DetectionMode or 3..85 or 86..255, optional. Whether the station detects by itself
    detection_level: DetectionLevel or 6..85 or 86..255, optional. Level that counts as a detection
    detection_operational_threshold_level: optional. Threshold in operation
    detection_low_threshold_level: optional. Lower threshold
    detection_threshold_delay: in second, optional. Time above the threshold before an alarm, in seconds
    sampling_interval: in minute, optional. Time from one sample to the next, in minutes
    sampling_duration: in minute, optional. Time that a sample takes, in minutes
    sampling_volume: in cubic meter, optional. Volume of a sample, in cubic metres
    audio_level: AudioLevel or 4..85 or 86..255, optional. Loudness of the alarm
    display_brightness_level: DisplayBrightnessLevel or 5..85 or 86..255, optional. Brightness of the display
    product_name: up to 30 characters. Name of the product
    identifier: up to 30 characters. Serial number or other name of the device
    sw_firmware_version: up to 30 characters. Version of the software
    payload_cbrn_type: PayloadCBRNType or 8..85 or 86..255. Kind of hazard that the station detects
    power_mode: PowerMode or 2..85 or 86..255. Whether the station is on
    detection_above_threshold_update_frequency: 0..100 in hertz, optional. Rate of reports above the threshold, in hertz
    storage_utilisation: 0..100, optional. Used storage, in percent
    display_mode: DisplayMode or 2..85 or 86..255, optional. Whether the display stays on
    display_contrast: 0..100, optional. Contrast of the display, in percent
    language: Language or 2..85 or 86..255, optional. Language of the display
    keyguard: Keyguard or 2..85 or 86..255, optional. Whether keys are locked
    location_label: up to 16 characters, optional. Name of the place
    group_location_label: up to 16 characters, optional. Name of the place of the group
    contamination_threshold_field: ContaminationThresholdField or 2..85 or 86..255, optional. Whether the threshold is about contamination or severity
    other_visual_indicators_brightness_level: OtherVisualIndicatorsBrightnessLevel or 5..85 or 86..255, optional. Brightness of lamps
    cbrn4_delivery_mode: CBRN4DeliveryMode or 2..85 or 86..255, optional. Whether CBRN 4 reports are sent all the time
    """

    CODE = 0xF935
    NAME = "CBRNConfigurationState"
    SERVICE = "urn:jaus:jss:iop:CBRNSensor"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    class ExerOperFlag(IntEnum):
        """Values of ExerOperFlag."""

        EXERCISE = 0
        OPERATION = 1

    class PositioningMode(IntEnum):
        """Values of PositioningMode."""

        MANUAL = 0
        GPS = 1

    class PayloadSensitivity(IntEnum):
        """Values of PayloadSensitivity."""

        NORMAL = 0
        HIGH = 1

    class BackgroundLevelSubtractMode(IntEnum):
        """Values of BackgroundLevelSubtractMode."""

        DO_NOT_SUBTRACT = 0
        SUBTRACT = 1

    class BackgroundLevelMode(IntEnum):
        """Values of BackgroundLevelMode."""

        AUTOMATIC = 0
        MANUAL = 1

    class DetectionMode(IntEnum):
        """Values of DetectionMode."""

        AUTOMATIC = 0
        MANUAL = 1
        STANDBY = 2

    class DetectionLevel(IntEnum):
        """Values of DetectionLevel."""

        STANDARD = 0
        MIOSIS = 1
        ICT5 = 2
        ICT50 = 3
        OPERATIONAL = 4
        LOW = 5

    class AudioLevel(IntEnum):
        """Values of AudioLevel."""

        HIGH = 0
        MEDIUM = 1
        LOW = 2
        OFF = 3

    class DisplayBrightnessLevel(IntEnum):
        """Values of DisplayBrightnessLevel."""

        OFF = 0
        LOW = 1
        MEDIUM = 2
        HIGH = 3
        NIGHT_VISION = 4

    class PayloadCBRNType(IntEnum):
        """Values of PayloadCBRNType."""

        CHEMICAL = 0
        BIOLOGICAL = 1
        RADIOLOGICAL = 2
        NUCLEAR = 3
        CHEMICAL_STANDOFF = 4
        BIOLOGICAL_STANDOFF = 5
        RADIOLOGICAL_STANDOFF = 6
        NUCLEAR_STANDOFF = 7

    class PowerMode(IntEnum):
        """Values of PowerMode."""

        OFF = 0
        ON = 1

    class DisplayMode(IntEnum):
        """Values of DisplayMode."""

        POWER_SAVE = 0
        CONTINUOUS = 1

    class Language(IntEnum):
        """Values of Language."""

        ENGLISH = 0
        FRENCH = 1

    class Keyguard(IntEnum):
        """Values of Keyguard."""

        UNLOCKED = 0
        LOCKED = 1

    class ContaminationThresholdField(IntEnum):
        """Values of ContaminationThresholdField."""

        CONTAMINATION = 0
        SEVERITY = 1

    class OtherVisualIndicatorsBrightnessLevel(IntEnum):
        """Values of OtherVisualIndicatorsBrightnessLevel."""

        OFF = 0
        LOW = 1
        MEDIUM = 2
        HIGH = 3
        NIGHT_VISION = 4

    class CBRN4DeliveryMode(IntEnum):
        """Values of CBRN4DeliveryMode."""

        THREAT_RELATED = 0
        CONTINUOUS = 1

    timestamp: float | None = None
    station_number: int
    exer_oper_name: str | None = None
    exer_oper_flag: CBRNConfigurationState.ExerOperFlag | int | None = None
    call_sign: str | None = None
    positioning_mode: CBRNConfigurationState.PositioningMode | int | None = None
    payload_sensitivity: CBRNConfigurationState.PayloadSensitivity | int | None = None
    background_level_subtract_mode: CBRNConfigurationState.BackgroundLevelSubtractMode | int | None = None
    background_level_mode: CBRNConfigurationState.BackgroundLevelMode | int | None = None
    detection_mode: CBRNConfigurationState.DetectionMode | int | None = None
    detection_level: CBRNConfigurationState.DetectionLevel | int | None = None
    detection_operational_threshold_level: float | None = None
    detection_low_threshold_level: float | None = None
    detection_threshold_delay: int | None = None
    sampling_interval: int | None = None
    sampling_duration: int | None = None
    sampling_volume: float | None = None
    audio_level: CBRNConfigurationState.AudioLevel | int | None = None
    display_brightness_level: CBRNConfigurationState.DisplayBrightnessLevel | int | None = None
    product_name: str
    identifier: str
    sw_firmware_version: str
    payload_cbrn_type: CBRNConfigurationState.PayloadCBRNType | int
    power_mode: CBRNConfigurationState.PowerMode | int
    detection_above_threshold_update_frequency: float | None = None
    storage_utilisation: int | None = None
    display_mode: CBRNConfigurationState.DisplayMode | int | None = None
    display_contrast: int | None = None
    language: CBRNConfigurationState.Language | int | None = None
    keyguard: CBRNConfigurationState.Keyguard | int | None = None
    location_label: str | None = None
    group_location_label: str | None = None
    contamination_threshold_field: CBRNConfigurationState.ContaminationThresholdField | int | None = None
    other_visual_indicators_brightness_level: CBRNConfigurationState.OtherVisualIndicatorsBrightnessLevel | int | None = None
    cbrn4_delivery_mode: CBRNConfigurationState.CBRN4DeliveryMode | int | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "I",
            ("Timestamp", rt.Number("d", rt.ANY, "second"), True),
            ("StationNumber", rt.Number("I")),
            ("ExerOperName", rt.Text(count=rt.Count("B", 0, 57)), True),
            ("ExerOperFlag", rt.Number("B", rt.Values(CBRNConfigurationState.ExerOperFlag, ((2, 85), (86, 255)))), True),
            ("CallSign", rt.Text(count=rt.Count("B", 0, 31)), True),
            ("PositioningMode", rt.Number("B", rt.Values(CBRNConfigurationState.PositioningMode, ((2, 85), (86, 255)))), True),
            ("PayloadSensitivity", rt.Number("B", rt.Values(CBRNConfigurationState.PayloadSensitivity, ((2, 85), (86, 255)))), True),
            ("BackgroundLevelSubtractMode", rt.Number("B", rt.Values(CBRNConfigurationState.BackgroundLevelSubtractMode, ((2, 85), (86, 255)))), True),
            ("BackgroundLevelMode", rt.Number("B", rt.Values(CBRNConfigurationState.BackgroundLevelMode, ((2, 85), (86, 255)))), True),
            ("DetectionMode", rt.Number("B", rt.Values(CBRNConfigurationState.DetectionMode, ((3, 85), (86, 255)))), True),
            ("DetectionLevel", rt.Number("B", rt.Values(CBRNConfigurationState.DetectionLevel, ((6, 85), (86, 255)))), True),
            ("DetectionOperationalThresholdLevel", rt.Number("d"), True),
            ("DetectionLowThresholdLevel", rt.Number("d"), True),
            ("DetectionThresholdDelay", rt.Number("H", rt.ANY, "second"), True),
            ("SamplingInterval", rt.Number("I", rt.ANY, "minute"), True),
            ("SamplingDuration", rt.Number("I", rt.ANY, "minute"), True),
            ("SamplingVolume", rt.Number("d", rt.ANY, "cubic meter"), True),
            ("AudioLevel", rt.Number("B", rt.Values(CBRNConfigurationState.AudioLevel, ((4, 85), (86, 255)))), True),
            ("DisplayBrightnessLevel", rt.Number("B", rt.Values(CBRNConfigurationState.DisplayBrightnessLevel, ((5, 85), (86, 255)))), True),
            ("ProductName", rt.Text(count=rt.Count("B", 0, 30))),
            ("Identifier", rt.Text(count=rt.Count("B", 0, 30))),
            ("SWFirmwareVersion", rt.Text(count=rt.Count("B", 0, 30))),
            ("PayloadCBRNType", rt.Number("B", rt.Values(CBRNConfigurationState.PayloadCBRNType, ((8, 85), (86, 255))))),
            ("PowerMode", rt.Number("B", rt.Values(CBRNConfigurationState.PowerMode, ((2, 85), (86, 255))))),
            ("DetectionAboveThresholdUpdateFrequency", rt.Number("f", rt.Values(None, ((0.0, 100.0),)), "hertz"), True),
            ("StorageUtilisation", rt.Number("B", rt.Values(None, ((0, 100),))), True),
            ("DisplayMode", rt.Number("B", rt.Values(CBRNConfigurationState.DisplayMode, ((2, 85), (86, 255)))), True),
            ("DisplayContrast", rt.Number("B", rt.Values(None, ((0, 100),))), True),
            ("Language", rt.Number("B", rt.Values(CBRNConfigurationState.Language, ((2, 85), (86, 255)))), True),
            ("Keyguard", rt.Number("B", rt.Values(CBRNConfigurationState.Keyguard, ((2, 85), (86, 255)))), True),
            ("LocationLabel", rt.Text(count=rt.Count("B", 0, 16)), True),
            ("GroupLocationLabel", rt.Text(count=rt.Count("B", 0, 16)), True),
            ("ContaminationThresholdField", rt.Number("B", rt.Values(CBRNConfigurationState.ContaminationThresholdField, ((2, 85), (86, 255)))), True),
            ("OtherVisualIndicatorsBrightnessLevel", rt.Number("B", rt.Values(CBRNConfigurationState.OtherVisualIndicatorsBrightnessLevel, ((5, 85), (86, 255)))), True),
            ("CBRN4DeliveryMode", rt.Number("B", rt.Values(CBRNConfigurationState.CBRN4DeliveryMode, ((2, 85), (86, 255)))), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x35 or data[1] != 0xF9: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (mask,) = _S_I.unpack_from(data, 2)
        packer = _M_CBRNConfigurationCommand_0[mask & 0x1]
        raw = iter(packer.unpack_from(data, 6)).__next__
        at = 6 + packer.size
        if mask & 1:
            timestamp_ = raw()
            if timestamp_ - timestamp_ != 0.0: raise rt.Reject
            self.timestamp = timestamp_
        else: self.timestamp = None
        self.station_number = raw()
        if mask & 2:
            exer_oper_name_end_ = data[at]
            if exer_oper_name_end_ > 57: raise rt.Reject
            exer_oper_name_end_ += at + 1
            self.exer_oper_name = data[at + 1:exer_oper_name_end_].decode("latin-1")
            at = exer_oper_name_end_
        else: self.exer_oper_name = None
        packer = _M_CBRNConfigurationCommand_2[mask & 0x4]
        raw = iter(packer.unpack_from(data, at)).__next__
        at += packer.size
        if mask & 4:
            exer_oper_flag_ = raw()
            self.exer_oper_flag = _E_CBRNConfigurationState_ExerOperFlag.get(exer_oper_flag_, exer_oper_flag_)
        else: self.exer_oper_flag = None
        if mask & 8:
            call_sign_end_ = data[at]
            if call_sign_end_ > 31: raise rt.Reject
            call_sign_end_ += at + 1
            self.call_sign = data[at + 1:call_sign_end_].decode("latin-1")
            at = call_sign_end_
        else: self.call_sign = None
        packer = _M_CBRNConfigurationState_4[mask & 0x3FFF0]
        raw = iter(packer.unpack_from(data, at)).__next__
        at += packer.size
        if mask & 16:
            positioning_mode_ = raw()
            self.positioning_mode = _E_CBRNConfigurationState_PositioningMode.get(positioning_mode_, positioning_mode_)
        else: self.positioning_mode = None
        if mask & 32:
            payload_sensitivity_ = raw()
            self.payload_sensitivity = _E_CBRNConfigurationState_PayloadSensitivity.get(payload_sensitivity_, payload_sensitivity_)
        else: self.payload_sensitivity = None
        if mask & 64:
            background_level_subtract_mode_ = raw()
            self.background_level_subtract_mode = _E_CBRNConfigurationState_BackgroundLevelSubtractMode.get(background_level_subtract_mode_, background_level_subtract_mode_)
        else: self.background_level_subtract_mode = None
        if mask & 128:
            background_level_mode_ = raw()
            self.background_level_mode = _E_CBRNConfigurationState_BackgroundLevelMode.get(background_level_mode_, background_level_mode_)
        else: self.background_level_mode = None
        if mask & 256:
            detection_mode_ = raw()
            self.detection_mode = _E_CBRNConfigurationState_DetectionMode.get(detection_mode_, detection_mode_)
        else: self.detection_mode = None
        if mask & 512:
            detection_level_ = raw()
            self.detection_level = _E_CBRNConfigurationState_DetectionLevel.get(detection_level_, detection_level_)
        else: self.detection_level = None
        if mask & 1024:
            detection_operational_threshold_level_ = raw()
            if detection_operational_threshold_level_ - detection_operational_threshold_level_ != 0.0: raise rt.Reject
            self.detection_operational_threshold_level = detection_operational_threshold_level_
        else: self.detection_operational_threshold_level = None
        if mask & 2048:
            detection_low_threshold_level_ = raw()
            if detection_low_threshold_level_ - detection_low_threshold_level_ != 0.0: raise rt.Reject
            self.detection_low_threshold_level = detection_low_threshold_level_
        else: self.detection_low_threshold_level = None
        self.detection_threshold_delay = raw() if mask & 4096 else None
        self.sampling_interval = raw() if mask & 8192 else None
        self.sampling_duration = raw() if mask & 16384 else None
        if mask & 32768:
            sampling_volume_ = raw()
            if sampling_volume_ - sampling_volume_ != 0.0: raise rt.Reject
            self.sampling_volume = sampling_volume_
        else: self.sampling_volume = None
        if mask & 65536:
            audio_level_ = raw()
            self.audio_level = _E_CBRNConfigurationState_AudioLevel.get(audio_level_, audio_level_)
        else: self.audio_level = None
        if mask & 131072:
            display_brightness_level_ = raw()
            self.display_brightness_level = _E_CBRNConfigurationState_DisplayBrightnessLevel.get(display_brightness_level_, display_brightness_level_)
        else: self.display_brightness_level = None
        product_name_end_ = data[at]
        if product_name_end_ > 30: raise rt.Reject
        product_name_end_ += at + 1
        self.product_name = data[at + 1:product_name_end_].decode("latin-1")
        identifier_end_ = data[product_name_end_]
        if identifier_end_ > 30: raise rt.Reject
        identifier_end_ += product_name_end_ + 1
        self.identifier = data[product_name_end_ + 1:identifier_end_].decode("latin-1")
        sw_firmware_version_end_ = data[identifier_end_]
        if sw_firmware_version_end_ > 30: raise rt.Reject
        sw_firmware_version_end_ += identifier_end_ + 1
        self.sw_firmware_version = data[identifier_end_ + 1:sw_firmware_version_end_].decode("latin-1")
        packer = _M_CBRNConfigurationState_8[mask & 0xFC0000]
        raw = iter(packer.unpack_from(data, sw_firmware_version_end_)).__next__
        at = sw_firmware_version_end_ + packer.size
        payload_cbrn_type_ = raw()
        self.payload_cbrn_type = _E_CBRNConfigurationState_PayloadCBRNType.get(payload_cbrn_type_, payload_cbrn_type_)
        power_mode_ = raw()
        self.power_mode = _E_CBRNConfigurationState_PowerMode.get(power_mode_, power_mode_)
        if mask & 262144:
            detection_above_threshold_update_frequency_ = raw()
            if detection_above_threshold_update_frequency_ - detection_above_threshold_update_frequency_ != 0.0: raise rt.Reject
            if not 0.0 <= detection_above_threshold_update_frequency_ <= 100.0: raise rt.Reject
            self.detection_above_threshold_update_frequency = detection_above_threshold_update_frequency_
        else: self.detection_above_threshold_update_frequency = None
        if mask & 524288:
            storage_utilisation_ = raw()
            if storage_utilisation_ > 100: raise rt.Reject
            self.storage_utilisation = storage_utilisation_
        else: self.storage_utilisation = None
        if mask & 1048576:
            display_mode_ = raw()
            self.display_mode = _E_CBRNConfigurationState_DisplayMode.get(display_mode_, display_mode_)
        else: self.display_mode = None
        if mask & 2097152:
            display_contrast_ = raw()
            if display_contrast_ > 100: raise rt.Reject
            self.display_contrast = display_contrast_
        else: self.display_contrast = None
        if mask & 4194304:
            language_ = raw()
            self.language = _E_CBRNConfigurationState_Language.get(language_, language_)
        else: self.language = None
        if mask & 8388608:
            keyguard_ = raw()
            self.keyguard = _E_CBRNConfigurationState_Keyguard.get(keyguard_, keyguard_)
        else: self.keyguard = None
        if mask & 16777216:
            location_label_end_ = data[at]
            if location_label_end_ > 16: raise rt.Reject
            location_label_end_ += at + 1
            self.location_label = data[at + 1:location_label_end_].decode("latin-1")
            at = location_label_end_
        else: self.location_label = None
        if mask & 33554432:
            group_location_label_end_ = data[at]
            if group_location_label_end_ > 16: raise rt.Reject
            group_location_label_end_ += at + 1
            self.group_location_label = data[at + 1:group_location_label_end_].decode("latin-1")
            at = group_location_label_end_
        else: self.group_location_label = None
        packer = _M_CBRNConfigurationState_11[mask & 0x1C000000]
        raw = iter(packer.unpack_from(data, at)).__next__
        at += packer.size
        if mask & 67108864:
            contamination_threshold_field_ = raw()
            self.contamination_threshold_field = _E_CBRNConfigurationState_ContaminationThresholdField.get(contamination_threshold_field_, contamination_threshold_field_)
        else: self.contamination_threshold_field = None
        if mask & 134217728:
            other_visual_indicators_brightness_level_ = raw()
            self.other_visual_indicators_brightness_level = _E_CBRNConfigurationState_OtherVisualIndicatorsBrightnessLevel.get(other_visual_indicators_brightness_level_, other_visual_indicators_brightness_level_)
        else: self.other_visual_indicators_brightness_level = None
        if mask & 268435456:
            cbrn4_delivery_mode_ = raw()
            self.cbrn4_delivery_mode = _E_CBRNConfigurationState_CBRN4DeliveryMode.get(cbrn4_delivery_mode_, cbrn4_delivery_mode_)
        else: self.cbrn4_delivery_mode = None
        self.reserved_presence = mask & 0xE0000000
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x35\xf9")
        start = len(out)
        out += b"\0\0\0\0"
        mask = self.reserved_presence
        if mask & 0x1FFFFFFF: raise rt.Reject
        raw: list[int | float | bytes] = []
        timestamp_ = self.timestamp
        if timestamp_ is not None:
            mask |= 1
            if timestamp_ - timestamp_ != 0.0: raise rt.Reject
            raw.append(timestamp_)
        raw.append(self.station_number)
        out += _M_CBRNConfigurationCommand_0[mask & 0x1].pack(*raw)
        exer_oper_name_ = self.exer_oper_name
        if exer_oper_name_ is not None:
            mask |= 2
            exer_oper_name_raw_ = exer_oper_name_.encode("latin-1")
            if len(exer_oper_name_raw_) > 57: raise rt.Reject
            out.append(len(exer_oper_name_raw_))
            out += exer_oper_name_raw_
        raw = []
        exer_oper_flag_ = self.exer_oper_flag
        if exer_oper_flag_ is not None:
            mask |= 4
            raw.append(exer_oper_flag_)
        out += _M_CBRNConfigurationCommand_2[mask & 0x4].pack(*raw)
        call_sign_ = self.call_sign
        if call_sign_ is not None:
            mask |= 8
            call_sign_raw_ = call_sign_.encode("latin-1")
            if len(call_sign_raw_) > 31: raise rt.Reject
            out.append(len(call_sign_raw_))
            out += call_sign_raw_
        raw = []
        positioning_mode_ = self.positioning_mode
        if positioning_mode_ is not None:
            mask |= 16
            raw.append(positioning_mode_)
        payload_sensitivity_ = self.payload_sensitivity
        if payload_sensitivity_ is not None:
            mask |= 32
            raw.append(payload_sensitivity_)
        background_level_subtract_mode_ = self.background_level_subtract_mode
        if background_level_subtract_mode_ is not None:
            mask |= 64
            raw.append(background_level_subtract_mode_)
        background_level_mode_ = self.background_level_mode
        if background_level_mode_ is not None:
            mask |= 128
            raw.append(background_level_mode_)
        detection_mode_ = self.detection_mode
        if detection_mode_ is not None:
            mask |= 256
            raw.append(detection_mode_)
        detection_level_ = self.detection_level
        if detection_level_ is not None:
            mask |= 512
            raw.append(detection_level_)
        detection_operational_threshold_level_ = self.detection_operational_threshold_level
        if detection_operational_threshold_level_ is not None:
            mask |= 1024
            if detection_operational_threshold_level_ - detection_operational_threshold_level_ != 0.0: raise rt.Reject
            raw.append(detection_operational_threshold_level_)
        detection_low_threshold_level_ = self.detection_low_threshold_level
        if detection_low_threshold_level_ is not None:
            mask |= 2048
            if detection_low_threshold_level_ - detection_low_threshold_level_ != 0.0: raise rt.Reject
            raw.append(detection_low_threshold_level_)
        detection_threshold_delay_ = self.detection_threshold_delay
        if detection_threshold_delay_ is not None:
            mask |= 4096
            raw.append(detection_threshold_delay_)
        sampling_interval_ = self.sampling_interval
        if sampling_interval_ is not None:
            mask |= 8192
            raw.append(sampling_interval_)
        sampling_duration_ = self.sampling_duration
        if sampling_duration_ is not None:
            mask |= 16384
            raw.append(sampling_duration_)
        sampling_volume_ = self.sampling_volume
        if sampling_volume_ is not None:
            mask |= 32768
            if sampling_volume_ - sampling_volume_ != 0.0: raise rt.Reject
            raw.append(sampling_volume_)
        audio_level_ = self.audio_level
        if audio_level_ is not None:
            mask |= 65536
            raw.append(audio_level_)
        display_brightness_level_ = self.display_brightness_level
        if display_brightness_level_ is not None:
            mask |= 131072
            raw.append(display_brightness_level_)
        out += _M_CBRNConfigurationState_4[mask & 0x3FFF0].pack(*raw)
        product_name_raw_ = self.product_name.encode("latin-1")
        if len(product_name_raw_) > 30: raise rt.Reject
        out.append(len(product_name_raw_))
        out += product_name_raw_
        identifier_raw_ = self.identifier.encode("latin-1")
        if len(identifier_raw_) > 30: raise rt.Reject
        out.append(len(identifier_raw_))
        out += identifier_raw_
        sw_firmware_version_raw_ = self.sw_firmware_version.encode("latin-1")
        if len(sw_firmware_version_raw_) > 30: raise rt.Reject
        out.append(len(sw_firmware_version_raw_))
        out += sw_firmware_version_raw_
        raw = []
        raw.append(self.payload_cbrn_type)
        raw.append(self.power_mode)
        detection_above_threshold_update_frequency_ = self.detection_above_threshold_update_frequency
        if detection_above_threshold_update_frequency_ is not None:
            mask |= 262144
            if detection_above_threshold_update_frequency_ - detection_above_threshold_update_frequency_ != 0.0: raise rt.Reject
            if not 0.0 <= detection_above_threshold_update_frequency_ <= 100.0: raise rt.Reject
            raw.append(detection_above_threshold_update_frequency_)
        storage_utilisation_ = self.storage_utilisation
        if storage_utilisation_ is not None:
            mask |= 524288
            if not 0 <= storage_utilisation_ <= 100: raise rt.Reject
            raw.append(storage_utilisation_)
        display_mode_ = self.display_mode
        if display_mode_ is not None:
            mask |= 1048576
            raw.append(display_mode_)
        display_contrast_ = self.display_contrast
        if display_contrast_ is not None:
            mask |= 2097152
            if not 0 <= display_contrast_ <= 100: raise rt.Reject
            raw.append(display_contrast_)
        language_ = self.language
        if language_ is not None:
            mask |= 4194304
            raw.append(language_)
        keyguard_ = self.keyguard
        if keyguard_ is not None:
            mask |= 8388608
            raw.append(keyguard_)
        out += _M_CBRNConfigurationState_8[mask & 0xFC0000].pack(*raw)
        location_label_ = self.location_label
        if location_label_ is not None:
            mask |= 16777216
            location_label_raw_ = location_label_.encode("latin-1")
            if len(location_label_raw_) > 16: raise rt.Reject
            out.append(len(location_label_raw_))
            out += location_label_raw_
        group_location_label_ = self.group_location_label
        if group_location_label_ is not None:
            mask |= 33554432
            group_location_label_raw_ = group_location_label_.encode("latin-1")
            if len(group_location_label_raw_) > 16: raise rt.Reject
            out.append(len(group_location_label_raw_))
            out += group_location_label_raw_
        raw = []
        contamination_threshold_field_ = self.contamination_threshold_field
        if contamination_threshold_field_ is not None:
            mask |= 67108864
            raw.append(contamination_threshold_field_)
        other_visual_indicators_brightness_level_ = self.other_visual_indicators_brightness_level
        if other_visual_indicators_brightness_level_ is not None:
            mask |= 134217728
            raw.append(other_visual_indicators_brightness_level_)
        cbrn4_delivery_mode_ = self.cbrn4_delivery_mode
        if cbrn4_delivery_mode_ is not None:
            mask |= 268435456
            raw.append(cbrn4_delivery_mode_)
        out += _M_CBRNConfigurationState_11[mask & 0x1C000000].pack(*raw)
        _S_I.pack_into(out, start, mask)
        return bytes(out)


@dataclass(slots=True, repr=False, kw_only=True)
class CBRNScanWindowOperatingState(rt.Message):
    """CBRNScanWindowOperatingState (0xF936): Tells where a station scans.

    timestamp: in second, optional. Time of the message, in seconds
    station_number: Number of the station
    start_scan_window_azimuth: 0..6.28318548203 in radian, optional. First direction of the scan, in radians
    end_scan_window_azimuth: 0..6.28318548203 in radian, optional. Last direction of the scan, in radians
    scan_window_min_elevation: -3.14159274101..3.14159274101 in radian, optional. Lowest elevation of the scan, in radians
    scan_window_max_elevation: -3.14159274101..3.14159274101 in radian, optional. Highest elevation of the scan, in radians
    azimuth_scan_rate: in radian per second, optional. Rate of turning, in radians per second
    elevation_scan_rate: in radian per second, optional. Rate of tilting, in radians per second
    scan_mode: ScanMode or 1..85 or 86..255, optional. Pattern of the scan
    actual_azimuth: 0..6.28318548203 in radian, optional. Present direction, in radians
    actual_elevation: -3.14159274101..3.14159274101 in radian, optional. Present elevation, in radians
    scan_radius: in meter, optional. Reach of the scan, in metres
    """

    CODE = 0xF936
    NAME = "CBRNScanWindowOperatingState"
    SERVICE = "urn:jaus:jss:iop:CBRNSensor"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    class ScanMode(IntEnum):
        """Values of ScanMode."""

        HORIZONTAL = 0

    timestamp: float | None = None
    station_number: int
    start_scan_window_azimuth: float | None = None
    end_scan_window_azimuth: float | None = None
    scan_window_min_elevation: float | None = None
    scan_window_max_elevation: float | None = None
    azimuth_scan_rate: float | None = None
    elevation_scan_rate: float | None = None
    scan_mode: CBRNScanWindowOperatingState.ScanMode | int | None = None
    actual_azimuth: float | None = None
    actual_elevation: float | None = None
    scan_radius: float | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "H",
            ("Timestamp", rt.Number("d", rt.ANY, "second"), True),
            ("StationNumber", rt.Number("I")),
            ("StartScanWindowAzimuth", rt.Number("f", rt.Values(None, ((0.0, 6.2831854820251465),)), "radian"), True),
            ("EndScanWindowAzimuth", rt.Number("f", rt.Values(None, ((0.0, 6.2831854820251465),)), "radian"), True),
            ("ScanWindowMinElevation", rt.Number("f", rt.Values(None, ((-3.1415927410125732, 3.1415927410125732),)), "radian"), True),
            ("ScanWindowMaxElevation", rt.Number("f", rt.Values(None, ((-3.1415927410125732, 3.1415927410125732),)), "radian"), True),
            ("AzimuthScanRate", rt.Number("f", rt.ANY, "radian per second"), True),
            ("ElevationScanRate", rt.Number("f", rt.ANY, "radian per second"), True),
            ("ScanMode", rt.Number("B", rt.Values(CBRNScanWindowOperatingState.ScanMode, ((1, 85), (86, 255)))), True),
            ("ActualAzimuth", rt.Number("f", rt.Values(None, ((0.0, 6.2831854820251465),)), "radian"), True),
            ("ActualElevation", rt.Number("f", rt.Values(None, ((-3.1415927410125732, 3.1415927410125732),)), "radian"), True),
            ("ScanRadius", rt.Number("f", rt.ANY, "meter"), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_2H.unpack_from(data)
        if code != 0xF936: raise rt.Reject
        raw = iter(_M_CBRNScanWindowOperatingState[mask & 0x7FF].unpack(data)).__next__
        self = rt.new(cls)
        if mask & 1:
            timestamp_ = raw()
            if timestamp_ - timestamp_ != 0.0: raise rt.Reject
            self.timestamp = timestamp_
        else: self.timestamp = None
        self.station_number = raw()
        if mask & 2:
            start_scan_window_azimuth_ = raw()
            if start_scan_window_azimuth_ - start_scan_window_azimuth_ != 0.0: raise rt.Reject
            if not 0.0 <= start_scan_window_azimuth_ <= 6.2831854820251465: raise rt.Reject
            self.start_scan_window_azimuth = start_scan_window_azimuth_
        else: self.start_scan_window_azimuth = None
        if mask & 4:
            end_scan_window_azimuth_ = raw()
            if end_scan_window_azimuth_ - end_scan_window_azimuth_ != 0.0: raise rt.Reject
            if not 0.0 <= end_scan_window_azimuth_ <= 6.2831854820251465: raise rt.Reject
            self.end_scan_window_azimuth = end_scan_window_azimuth_
        else: self.end_scan_window_azimuth = None
        if mask & 8:
            scan_window_min_elevation_ = raw()
            if scan_window_min_elevation_ - scan_window_min_elevation_ != 0.0: raise rt.Reject
            if not -3.1415927410125732 <= scan_window_min_elevation_ <= 3.1415927410125732: raise rt.Reject
            self.scan_window_min_elevation = scan_window_min_elevation_
        else: self.scan_window_min_elevation = None
        if mask & 16:
            scan_window_max_elevation_ = raw()
            if scan_window_max_elevation_ - scan_window_max_elevation_ != 0.0: raise rt.Reject
            if not -3.1415927410125732 <= scan_window_max_elevation_ <= 3.1415927410125732: raise rt.Reject
            self.scan_window_max_elevation = scan_window_max_elevation_
        else: self.scan_window_max_elevation = None
        if mask & 32:
            azimuth_scan_rate_ = raw()
            if azimuth_scan_rate_ - azimuth_scan_rate_ != 0.0: raise rt.Reject
            self.azimuth_scan_rate = azimuth_scan_rate_
        else: self.azimuth_scan_rate = None
        if mask & 64:
            elevation_scan_rate_ = raw()
            if elevation_scan_rate_ - elevation_scan_rate_ != 0.0: raise rt.Reject
            self.elevation_scan_rate = elevation_scan_rate_
        else: self.elevation_scan_rate = None
        if mask & 128:
            scan_mode_ = raw()
            self.scan_mode = _E_CBRNScanWindowOperatingState_ScanMode.get(scan_mode_, scan_mode_)
        else: self.scan_mode = None
        if mask & 256:
            actual_azimuth_ = raw()
            if actual_azimuth_ - actual_azimuth_ != 0.0: raise rt.Reject
            if not 0.0 <= actual_azimuth_ <= 6.2831854820251465: raise rt.Reject
            self.actual_azimuth = actual_azimuth_
        else: self.actual_azimuth = None
        if mask & 512:
            actual_elevation_ = raw()
            if actual_elevation_ - actual_elevation_ != 0.0: raise rt.Reject
            if not -3.1415927410125732 <= actual_elevation_ <= 3.1415927410125732: raise rt.Reject
            self.actual_elevation = actual_elevation_
        else: self.actual_elevation = None
        if mask & 1024:
            scan_radius_ = raw()
            if scan_radius_ - scan_radius_ != 0.0: raise rt.Reject
            self.scan_radius = scan_radius_
        else: self.scan_radius = None
        self.reserved_presence = mask & 0xF800
        return self

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0x7FF: raise rt.Reject
        raw: list[int | float | bytes] = []
        timestamp_ = self.timestamp
        if timestamp_ is not None:
            mask |= 1
            if timestamp_ - timestamp_ != 0.0: raise rt.Reject
            raw.append(timestamp_)
        raw.append(self.station_number)
        start_scan_window_azimuth_ = self.start_scan_window_azimuth
        if start_scan_window_azimuth_ is not None:
            mask |= 2
            if start_scan_window_azimuth_ - start_scan_window_azimuth_ != 0.0: raise rt.Reject
            if not 0.0 <= start_scan_window_azimuth_ <= 6.2831854820251465: raise rt.Reject
            raw.append(start_scan_window_azimuth_)
        end_scan_window_azimuth_ = self.end_scan_window_azimuth
        if end_scan_window_azimuth_ is not None:
            mask |= 4
            if end_scan_window_azimuth_ - end_scan_window_azimuth_ != 0.0: raise rt.Reject
            if not 0.0 <= end_scan_window_azimuth_ <= 6.2831854820251465: raise rt.Reject
            raw.append(end_scan_window_azimuth_)
        scan_window_min_elevation_ = self.scan_window_min_elevation
        if scan_window_min_elevation_ is not None:
            mask |= 8
            if scan_window_min_elevation_ - scan_window_min_elevation_ != 0.0: raise rt.Reject
            if not -3.1415927410125732 <= scan_window_min_elevation_ <= 3.1415927410125732: raise rt.Reject
            raw.append(scan_window_min_elevation_)
        scan_window_max_elevation_ = self.scan_window_max_elevation
        if scan_window_max_elevation_ is not None:
            mask |= 16
            if scan_window_max_elevation_ - scan_window_max_elevation_ != 0.0: raise rt.Reject
            if not -3.1415927410125732 <= scan_window_max_elevation_ <= 3.1415927410125732: raise rt.Reject
            raw.append(scan_window_max_elevation_)
        azimuth_scan_rate_ = self.azimuth_scan_rate
        if azimuth_scan_rate_ is not None:
            mask |= 32
            if azimuth_scan_rate_ - azimuth_scan_rate_ != 0.0: raise rt.Reject
            raw.append(azimuth_scan_rate_)
        elevation_scan_rate_ = self.elevation_scan_rate
        if elevation_scan_rate_ is not None:
            mask |= 64
            if elevation_scan_rate_ - elevation_scan_rate_ != 0.0: raise rt.Reject
            raw.append(elevation_scan_rate_)
        scan_mode_ = self.scan_mode
        if scan_mode_ is not None:
            mask |= 128
            raw.append(scan_mode_)
        actual_azimuth_ = self.actual_azimuth
        if actual_azimuth_ is not None:
            mask |= 256
            if actual_azimuth_ - actual_azimuth_ != 0.0: raise rt.Reject
            if not 0.0 <= actual_azimuth_ <= 6.2831854820251465: raise rt.Reject
            raw.append(actual_azimuth_)
        actual_elevation_ = self.actual_elevation
        if actual_elevation_ is not None:
            mask |= 512
            if actual_elevation_ - actual_elevation_ != 0.0: raise rt.Reject
            if not -3.1415927410125732 <= actual_elevation_ <= 3.1415927410125732: raise rt.Reject
            raw.append(actual_elevation_)
        scan_radius_ = self.scan_radius
        if scan_radius_ is not None:
            mask |= 1024
            if scan_radius_ - scan_radius_ != 0.0: raise rt.Reject
            raw.append(scan_radius_)
        return _M_CBRNScanWindowOperatingState_pack[mask & 0x7FF].pack(0xF936, mask, *raw)


_S_H2I = rt.Packer("<H2I")
_S_HI = rt.Packer("<HI")
_M_CBRNCommand = rt.Masks("6x", ((1, "d"), (0, "I"), (2, "B"), (4, "B"), (8, "B"), (16, "B"), (32, "B"), (64, "B"), (128, "B"), (256, "B"), (512, "B"), (1024, "B"), (2048, "B"), (4096, "d")))
_E_CBRNCommand_SetPowerMode = rt.members(CBRNCommand.SetPowerMode)
_E_CBRNCommand_SetOperatingMode = rt.members(CBRNCommand.SetOperatingMode)
_E_CBRNCommand_Reboot = rt.members(CBRNCommand.Reboot)
_E_CBRNCommand_OperatingResetState = rt.members(CBRNCommand.OperatingResetState)
_E_CBRNCommand_ResetConfigurationState = rt.members(CBRNCommand.ResetConfigurationState)
_E_CBRNCommand_SetSamplingMode = rt.members(CBRNCommand.SetSamplingMode)
_E_CBRNCommand_TestType = rt.members(CBRNCommand.TestType)
_E_CBRNCommand_SetTestMode = rt.members(CBRNCommand.SetTestMode)
_E_CBRNCommand_SetLocalAlarmEnunciation = rt.members(CBRNCommand.SetLocalAlarmEnunciation)
_E_CBRNCommand_SetKeyguard = rt.members(CBRNCommand.SetKeyguard)
_M_CBRNCommand_pack = rt.Masks("HI", ((1, "d"), (0, "I"), (2, "B"), (4, "B"), (8, "B"), (16, "B"), (32, "B"), (64, "B"), (128, "B"), (256, "B"), (512, "B"), (1024, "B"), (2048, "B"), (4096, "d")))
_S_I = rt.Packer("<I")
_M_CBRNConfigurationCommand_0 = rt.Masks("", ((1, "d"), (0, "I")))
_M_CBRNConfigurationCommand_2 = rt.Masks("", ((4, "B"),))
_E_CBRNConfigurationCommand_SetExerOperFlag = rt.members(CBRNConfigurationCommand.SetExerOperFlag)
_M_CBRNConfigurationCommand_4 = rt.Masks("", ((16, "B"), (32, "d"), (64, "d"), (128, "f"), (256, "B"), (512, "B"), (1024, "B"), (2048, "f"), (4096, "B"), (8192, "B"), (16384, "d"), (32768, "d"), (65536, "f"), (131072, "I"), (262144, "I"), (524288, "d"), (1048576, "B"), (2097152, "f")))
_E_CBRNConfigurationCommand_SetPositioningMode = rt.members(CBRNConfigurationCommand.SetPositioningMode)
_E_CBRNConfigurationCommand_SetPayloadSensitivity = rt.members(CBRNConfigurationCommand.SetPayloadSensitivity)
_E_CBRNConfigurationCommand_SetBackgroundLevelSubtractMode = rt.members(CBRNConfigurationCommand.SetBackgroundLevelSubtractMode)
_E_CBRNConfigurationCommand_SetBackgroundLevelMode = rt.members(CBRNConfigurationCommand.SetBackgroundLevelMode)
_E_CBRNConfigurationCommand_SetDetectionMode = rt.members(CBRNConfigurationCommand.SetDetectionMode)
_E_CBRNConfigurationCommand_SetDetectionLevel = rt.members(CBRNConfigurationCommand.SetDetectionLevel)
_E_CBRNConfigurationCommand_SetAudioLevel = rt.members(CBRNConfigurationCommand.SetAudioLevel)
_M_CBRNConfigurationCommand_7 = rt.Masks("", ((0, "B"), (16777216, "B")))
_E_CBRNConfigurationCommand_SetCBRN4DeliveryMode = rt.members(CBRNConfigurationCommand.SetCBRN4DeliveryMode)
_E_CBRNConfigurationCommand_SetLanguage = rt.members(CBRNConfigurationCommand.SetLanguage)
_M_CBRNDisplayConfigurationCommand = rt.Masks("6x", ((1, "d"), (0, "I"), (2, "B"), (4, "B"), (8, "f"), (16, "B")))
_E_CBRNDisplayConfigurationCommand_SetDisplayBrightnessLevel = rt.members(CBRNDisplayConfigurationCommand.SetDisplayBrightnessLevel)
_E_CBRNDisplayConfigurationCommand_SetDisplayMode = rt.members(CBRNDisplayConfigurationCommand.SetDisplayMode)
_E_CBRNDisplayConfigurationCommand_SetOtherVisualIndicatorsBrightnessLevel = rt.members(CBRNDisplayConfigurationCommand.SetOtherVisualIndicatorsBrightnessLevel)
_M_CBRNDisplayConfigurationCommand_pack = rt.Masks("HI", ((1, "d"), (0, "I"), (2, "B"), (4, "B"), (8, "f"), (16, "B")))
_M_CBRNScanWindowConfigurationCommand = rt.Masks("6x", ((1, "d"), (0, "I"), (2, "f"), (4, "f"), (8, "f"), (16, "f"), (32, "f"), (64, "f"), (128, "B")))
_E_CBRNScanWindowConfigurationCommand_SetScanMode = rt.members(CBRNScanWindowConfigurationCommand.SetScanMode)
_M_CBRNScanWindowConfigurationCommand_pack = rt.Masks("HI", ((1, "d"), (0, "I"), (2, "f"), (4, "f"), (8, "f"), (16, "f"), (32, "f"), (64, "f"), (128, "B")))
_M_CBRN4_0 = rt.Masks("", ((1, "d"), (0, "I"), (2, "B"), (4, "I")))
_E_CBRN4_DetectionType = rt.members(CBRN4.DetectionType)
_S_H = rt.Packer("<H")
_S_B = rt.Packer("<B")
_M_CBRNDetection_0 = rt.Masks("", ((1, "d"), (0, "I"), (0, "B")))
_E_CBRNDetection_DetectionType = rt.members(CBRNDetection.DetectionType)
_M_CBRNDetection_2 = rt.Masks("", ((4, "d"), (8, "B"), (16, "d"), (32, "I"), (64, "I"), (128, "f")))
_E_CBRNDetection_ContaminationLevelUoM = rt.members(CBRNDetection.ContaminationLevelUoM)
_M_RNDetailedMeasurement_0 = rt.Masks("", ((1, "d"), (0, "I"), (2, "B")))
_E_RNDetailedMeasurement_DetectionType = rt.members(RNDetailedMeasurement.DetectionType)
_E_CBDetailedMeasurement_DetectionType = rt.members(CBDetailedMeasurement.DetectionType)
_M_CBRNOperatingState = rt.Masks("6x", ((1, "d"), (0, "I"), (2, "B"), (4, "B"), (8, "f"), (16, "f"), (32, "I"), (64, "B"), (128, "d"), (256, "d"), (512, "f"), (1024, "d"), (2048, "B"), (4096, "B"), (8192, "B"), (16384, "B"), (32768, "d"), (65536, "B"), (131072, "B"), (262144, "B")))
_E_CBRNOperatingState_GPSFix = rt.members(CBRNOperatingState.GPSFix)
_E_CBRNOperatingState_PowerSource = rt.members(CBRNOperatingState.PowerSource)
_E_CBRNOperatingState_PayloadState = rt.members(CBRNOperatingState.PayloadState)
_E_CBRNOperatingState_CommunicationMethod = rt.members(CBRNOperatingState.CommunicationMethod)
_E_CBRNOperatingState_TemperatureState = rt.members(CBRNOperatingState.TemperatureState)
_E_CBRNOperatingState_LocalAlarmEnunciationState = rt.members(CBRNOperatingState.LocalAlarmEnunciationState)
_E_CBRNOperatingState_OperatingMode = rt.members(CBRNOperatingState.OperatingMode)
_E_CBRNOperatingState_SamplingState = rt.members(CBRNOperatingState.SamplingState)
_E_CBRNOperatingState_TestingState = rt.members(CBRNOperatingState.TestingState)
_M_CBRNOperatingState_pack = rt.Masks("HI", ((1, "d"), (0, "I"), (2, "B"), (4, "B"), (8, "f"), (16, "f"), (32, "I"), (64, "B"), (128, "d"), (256, "d"), (512, "f"), (1024, "d"), (2048, "B"), (4096, "B"), (8192, "B"), (16384, "B"), (32768, "d"), (65536, "B"), (131072, "B"), (262144, "B")))
_E_CBRNConfigurationState_ExerOperFlag = rt.members(CBRNConfigurationState.ExerOperFlag)
_M_CBRNConfigurationState_4 = rt.Masks("", ((16, "B"), (32, "B"), (64, "B"), (128, "B"), (256, "B"), (512, "B"), (1024, "d"), (2048, "d"), (4096, "H"), (8192, "I"), (16384, "I"), (32768, "d"), (65536, "B"), (131072, "B")))
_E_CBRNConfigurationState_PositioningMode = rt.members(CBRNConfigurationState.PositioningMode)
_E_CBRNConfigurationState_PayloadSensitivity = rt.members(CBRNConfigurationState.PayloadSensitivity)
_E_CBRNConfigurationState_BackgroundLevelSubtractMode = rt.members(CBRNConfigurationState.BackgroundLevelSubtractMode)
_E_CBRNConfigurationState_BackgroundLevelMode = rt.members(CBRNConfigurationState.BackgroundLevelMode)
_E_CBRNConfigurationState_DetectionMode = rt.members(CBRNConfigurationState.DetectionMode)
_E_CBRNConfigurationState_DetectionLevel = rt.members(CBRNConfigurationState.DetectionLevel)
_E_CBRNConfigurationState_AudioLevel = rt.members(CBRNConfigurationState.AudioLevel)
_E_CBRNConfigurationState_DisplayBrightnessLevel = rt.members(CBRNConfigurationState.DisplayBrightnessLevel)
_M_CBRNConfigurationState_8 = rt.Masks("", ((0, "B"), (0, "B"), (262144, "f"), (524288, "B"), (1048576, "B"), (2097152, "B"), (4194304, "B"), (8388608, "B")))
_E_CBRNConfigurationState_PayloadCBRNType = rt.members(CBRNConfigurationState.PayloadCBRNType)
_E_CBRNConfigurationState_PowerMode = rt.members(CBRNConfigurationState.PowerMode)
_E_CBRNConfigurationState_DisplayMode = rt.members(CBRNConfigurationState.DisplayMode)
_E_CBRNConfigurationState_Language = rt.members(CBRNConfigurationState.Language)
_E_CBRNConfigurationState_Keyguard = rt.members(CBRNConfigurationState.Keyguard)
_M_CBRNConfigurationState_11 = rt.Masks("", ((67108864, "B"), (134217728, "B"), (268435456, "B")))
_E_CBRNConfigurationState_ContaminationThresholdField = rt.members(CBRNConfigurationState.ContaminationThresholdField)
_E_CBRNConfigurationState_OtherVisualIndicatorsBrightnessLevel = rt.members(CBRNConfigurationState.OtherVisualIndicatorsBrightnessLevel)
_E_CBRNConfigurationState_CBRN4DeliveryMode = rt.members(CBRNConfigurationState.CBRN4DeliveryMode)
_S_2H = rt.Packer("<2H")
_M_CBRNScanWindowOperatingState = rt.Masks("4x", ((1, "d"), (0, "I"), (2, "f"), (4, "f"), (8, "f"), (16, "f"), (32, "f"), (64, "f"), (128, "B"), (256, "f"), (512, "f"), (1024, "f")))
_E_CBRNScanWindowOperatingState_ScanMode = rt.members(CBRNScanWindowOperatingState.ScanMode)
_M_CBRNScanWindowOperatingState_pack = rt.Masks("HH", ((1, "d"), (0, "I"), (2, "f"), (4, "f"), (8, "f"), (16, "f"), (32, "f"), (64, "f"), (128, "B"), (256, "f"), (512, "f"), (1024, "f")))
