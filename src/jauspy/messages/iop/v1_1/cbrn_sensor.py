"""urn:jaus:jss:iop:CBRNSensor 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:iop:CBRNSensor", "1.1")


@jd.message(_SERVICE, 0xF930, presence="B", kw_only=True)
class CBRN4(jd.Message):
    """CBRN4 (0xF930): Carries a CBRN 4 report.

    timestamp: in second, optional. Time of the message, in seconds
    station_number: Number of the station
    detection_type: DetectionType or 4..85 or 86..255, optional. Relation of the level to the threshold
    cbrn4_report_id: optional. Number of the report
    cbrn4: up to 65535 characters. The report, as text of its own format
    """

    class DetectionType(IntEnum):
        BELOW_THRESHOLD = 0
        ABOVE_THRESHOLD = 1
        ABOVE_THRESHOLD_UPDATE = 2
        NIL = 3

    timestamp: float | None = jd.field("Timestamp", jd.Number("d", jd.ANY, "second"), default=None)
    station_number: int = jd.field("StationNumber", jd.Number("I"))
    detection_type: CBRN4.DetectionType | int | None = jd.field("DetectionType", lambda: jd.Number("B", jd.Values(CBRN4.DetectionType, ((4, 85), (86, 255)))), default=None)
    cbrn4_report_id: int | None = jd.field("CBRN4ReportID", jd.Number("I"), default=None)
    cbrn4: str = jd.field("CBRN4", jd.Text(count=jd.Count("H", 0, 65535)))
    reserved_presence: int = 0


@jd.message(_SERVICE, 0xF920, query=True)
class QueryCBRN4(jd.Message):
    """QueryCBRN4 (0xF920): Asks for a CBRN 4 report.

    cbrn4_report_id: Number of the report
    station_number: Number of the station
    """
    REPORT = CBRN4
    cbrn4_report_id: int = jd.field("CBRN4ReportID", jd.Number("I"))
    station_number: int = jd.field("StationNumber", jd.Number("I"))


@jd.message(_SERVICE, 0xF931, presence="B", kw_only=True)
class CBRNDetection(jd.Message):
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

    class DetectionType(IntEnum):
        BELOW_THRESHOLD = 0
        ABOVE_THRESHOLD = 1
        ABOVE_THRESHOLD_UPDATE = 2
        NIL = 3

    class ContaminationLevelUoM(IntEnum):
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

    timestamp: float | None = jd.field("Timestamp", jd.Number("d", jd.ANY, "second"), default=None)
    station_number: int = jd.field("StationNumber", jd.Number("I"))
    detection_type: CBRNDetection.DetectionType | int = jd.field("DetectionType", lambda: jd.Number("B", jd.Values(CBRNDetection.DetectionType, ((4, 85), (86, 255)))))
    substance_detected: str | None = jd.field("SubstanceDetected", jd.Text(count=jd.Count("B", 0, 9)), default=None)
    contamination_level: float | None = jd.field("ContaminationLevel", jd.Number("d", jd.ANY, "second"), default=None)
    contamination_level_uo_m: CBRNDetection.ContaminationLevelUoM | int | None = jd.field("ContaminationLevelUoM", lambda: jd.Number("B", jd.Values(CBRNDetection.ContaminationLevelUoM, ((24, 85), (86, 255)))), default=None)
    detection_timestamp: float | None = jd.field("DetectionTimestamp", jd.Number("d", jd.ANY, "second"), default=None)
    cbrn4_report_reference: int | None = jd.field("CBRN4ReportReference", jd.Number("I"), default=None)
    distance_to_cloud: int | None = jd.field("DistanceToCloud", jd.Number("I", jd.ANY, "meter"), default=None)
    left_radial_line: float | None = jd.field("LeftRadialLine", jd.Number("f", jd.Values(None, ((-3.1415927410125732, 3.1415927410125732),)), "radian"), default=None)
    right_radial_line: float | None = jd.field("RightRadialLine", jd.Number("f", jd.Values(None, ((-3.1415927410125732, 3.1415927410125732),)), "radian"), default=None)
    cloud_top_angle: float | None = jd.field("CloudTopAngle", jd.Number("f", jd.Values(None, ((-3.1415927410125732, 3.1415927410125732),)), "radian"), default=None)
    cloud_bottom_angle: float | None = jd.field("CloudBottomAngle", jd.Number("f", jd.Values(None, ((-3.1415927410125732, 3.1415927410125732),)), "radian"), default=None)
    detection_latitude: float | None = jd.field("DetectionLatitude", jd.Number("d", jd.Values(None, ((-1.57079632679, 1.57079632679),)), "radian"), default=None)
    detection_longitude: float | None = jd.field("DetectionLongitude", jd.Number("d", jd.Values(None, ((-3.141592653589793, 3.141592653589793),)), "radian"), default=None)
    detection_altitude: float | None = jd.field("DetectionAltitude", jd.Number("f", jd.Values(None, ((-1000.0, 100000.0),)), "meter"), default=None)


@jd.message(_SERVICE, 0xF921, query=True)
class QueryCBRNDetection(jd.Message):
    """QueryCBRNDetection (0xF921): Asks for the last detection.

    station_number: Number of the station
    """
    REPORT = CBRNDetection
    station_number: int = jd.field("StationNumber", jd.Number("I"))


@jd.message(_SERVICE, 0xF932, presence="B", kw_only=True)
class RNDetailedMeasurement(jd.Message):
    """RNDetailedMeasurement (0xF932): Tells details of a radiological or nuclear detection.

    timestamp: in second, optional. Time of the message, in seconds
    station_number: Number of the station
    detection_type: DetectionType or 4..85 or 86..255, optional. Relation of the level to the threshold
    measurement: up to 65535 characters. The measurement, as text of its own format
    """

    class DetectionType(IntEnum):
        BELOW_THRESHOLD = 0
        ABOVE_THRESHOLD = 1
        ABOVE_THRESHOLD_UPDATE = 2
        NIL = 3

    timestamp: float | None = jd.field("Timestamp", jd.Number("d", jd.ANY, "second"), default=None)
    station_number: int = jd.field("StationNumber", jd.Number("I"))
    detection_type: RNDetailedMeasurement.DetectionType | int | None = jd.field("DetectionType", lambda: jd.Number("B", jd.Values(RNDetailedMeasurement.DetectionType, ((4, 85), (86, 255)))), default=None)
    measurement: str = jd.field("Measurement", jd.Text(count=jd.Count("H", 0, 65535)))
    reserved_presence: int = 0


@jd.message(_SERVICE, 0xF922, query=True)
class QueryRNDetailedMeasurement(jd.Message):
    """QueryRNDetailedMeasurement (0xF922): Asks for details of a radiological or nuclear detection.

    station_number: Number of the station
    """
    REPORT = RNDetailedMeasurement
    station_number: int = jd.field("StationNumber", jd.Number("I"))


@jd.message(_SERVICE, 0xF932, presence="B", kw_only=True)
class CBDetailedMeasurement(jd.Message):
    """CBDetailedMeasurement (0xF932): Tells details of a chemical or biological detection.

    timestamp: in second, optional. Time of the message, in seconds
    station_number: Number of the station
    detection_type: DetectionType or 4..85 or 86..255, optional. Relation of the level to the threshold
    measurement: up to 65535 characters. The measurement, as text of its own format
    """

    class DetectionType(IntEnum):
        BELOW_THRESHOLD = 0
        ABOVE_THRESHOLD = 1
        ABOVE_THRESHOLD_UPDATE = 2
        NIL = 3

    timestamp: float | None = jd.field("Timestamp", jd.Number("d", jd.ANY, "second"), default=None)
    station_number: int = jd.field("StationNumber", jd.Number("I"))
    detection_type: CBDetailedMeasurement.DetectionType | int | None = jd.field("DetectionType", lambda: jd.Number("B", jd.Values(CBDetailedMeasurement.DetectionType, ((4, 85), (86, 255)))), default=None)
    measurement: str = jd.field("Measurement", jd.Text(count=jd.Count("H", 0, 65535)))
    reserved_presence: int = 0


@jd.message(_SERVICE, 0xF923, query=True)
class QueryCBDetailedMeasurement(jd.Message):
    """QueryCBDetailedMeasurement (0xF923): Asks for details of a chemical or biological detection.

    station_number: Number of the station
    """
    REPORT = CBDetailedMeasurement
    station_number: int = jd.field("StationNumber", jd.Number("I"))


@jd.message(_SERVICE, 0xF934, presence="I", kw_only=True)
class CBRNOperatingState(jd.Message):
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

    class GPSFix(IntEnum):
        NOT_LOCKED = 0
        LOCKED = 1

    class PowerSource(IntEnum):
        AC_DC = 0
        BATTERY = 1

    class PayloadState(IntEnum):
        HAS_FAULTS = 0
        HAS_WARNINGS = 1
        ABOVE_THRESHOLD = 2
        OPERATING = 3
        POWERED_OFF = 4
        STARTING_UP = 5
        CALIBRATING = 6
        TESTING = 7

    class CommunicationMethod(IntEnum):
        WIRELESS = 0
        WIRED = 1

    class TemperatureState(IntEnum):
        NORMAL = 0
        WARMING_UP = 1
        COOLING_DOWN = 2

    class LocalAlarmEnunciationState(IntEnum):
        ALARM_SILENCED = 0
        ALARM_ACTIVATED = 1

    class OperatingMode(IntEnum):
        OPERATING = 0
        STANDBY = 1
        TRAINING = 2

    class SamplingState(IntEnum):
        IDLE = 0
        SAMPLING = 1
        SENSING_TEST = 2
        SCANNING = 3
        TRACKING = 4

    class TestingState(IntEnum):
        NOT_TESTING = 0
        SELF_TESTING = 1
        AUDIO_TESTING = 2
        CONTROL_TESTING = 3
        POWER_DISTRIBUTION_TESTING = 4
        SENSING_TEST = 5
        WIRELESS_TESTING = 6
        DISMOUNTED_POWER_TESTING = 7
        DISPLAY_TESTING = 8

    timestamp: float | None = jd.field("Timestamp", jd.Number("d", jd.ANY, "second"), default=None)
    station_number: int = jd.field("StationNumber", jd.Number("I"))
    gps_fix: CBRNOperatingState.GPSFix | int | None = jd.field("GPSFix", lambda: jd.Number("B", jd.Values(CBRNOperatingState.GPSFix, ((2, 85), (86, 255)))), default=None)
    power_source: CBRNOperatingState.PowerSource | int | None = jd.field("PowerSource", lambda: jd.Number("B", jd.Values(CBRNOperatingState.PowerSource, ((2, 85), (86, 255)))), default=None)
    battery_remaining: float | None = jd.field("BatteryRemaining", jd.Number("f", jd.Values(None, ((0.0, 100.0),))), default=None)
    battery_voltage: float | None = jd.field("BatteryVoltage", jd.Number("f", jd.ANY, "volt"), default=None)
    uptime: int | None = jd.field("Uptime", jd.Number("I", jd.ANY, "minute"), default=None)
    payload_state: CBRNOperatingState.PayloadState | int | None = jd.field("PayloadState", lambda: jd.Number("B", jd.Values(CBRNOperatingState.PayloadState, ((8, 85), (86, 255)))), default=None)
    payload_latitude: float | None = jd.field("PayloadLatitude", jd.Number("d", jd.Values(None, ((-1.57079632679, 1.57079632679),)), "radian"), default=None)
    payload_longitude: float | None = jd.field("PayloadLongitude", jd.Number("d", jd.Values(None, ((-3.141592653589793, 3.141592653589793),)), "radian"), default=None)
    payload_altitude: float | None = jd.field("PayloadAltitude", jd.Number("f", jd.Values(None, ((-1000.0, 100000.0),)), "meter"), default=None)
    background_level: float | None = jd.field("BackgroundLevel", jd.Number("d", jd.Values(None, ((0.0, 1000000000.0),))), default=None)
    communication_method: CBRNOperatingState.CommunicationMethod | int | None = jd.field("CommunicationMethod", lambda: jd.Number("B", jd.Values(CBRNOperatingState.CommunicationMethod, ((2, 85), (86, 255)))), default=None)
    communication_signal_strength: int | None = jd.field("CommunicationSignalStrength", jd.Number("B", jd.Values(None, ((0, 100),))), default=None)
    temperature_state: CBRNOperatingState.TemperatureState | int | None = jd.field("TemperatureState", lambda: jd.Number("B", jd.Values(CBRNOperatingState.TemperatureState, ((3, 85), (86, 255)))), default=None)
    local_alarm_enunciation_state: CBRNOperatingState.LocalAlarmEnunciationState | int | None = jd.field("LocalAlarmEnunciationState", lambda: jd.Number("B", jd.Values(CBRNOperatingState.LocalAlarmEnunciationState, ((2, 85), (86, 255)))), default=None)
    internal_time: float | None = jd.field("InternalTime", jd.Number("d", jd.ANY, "second"), default=None)
    operating_mode: CBRNOperatingState.OperatingMode | int | None = jd.field("OperatingMode", lambda: jd.Number("B", jd.Values(CBRNOperatingState.OperatingMode, ((3, 85), (86, 255)))), default=None)
    sampling_state: CBRNOperatingState.SamplingState | int | None = jd.field("SamplingState", lambda: jd.Number("B", jd.Values(CBRNOperatingState.SamplingState, ((5, 85), (86, 255)))), default=None)
    testing_state: CBRNOperatingState.TestingState | int | None = jd.field("TestingState", lambda: jd.Number("B", jd.Values(CBRNOperatingState.TestingState, ((9, 85), (86, 255)))), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0xF924, query=True)
class QueryCBRNOperatingState(jd.Message):
    """QueryCBRNOperatingState (0xF924): Asks for the state of a station.

    station_number: Number of the station
    """
    REPORT = CBRNOperatingState
    station_number: int = jd.field("StationNumber", jd.Number("I"))


@jd.message(_SERVICE, 0xF925, query=True)
class QueryCBRNConfiguration(jd.Message):
    """QueryCBRNConfiguration (0xF925): Asks for the settings of a station.

    station_number: Number of the station
    """
    station_number: int = jd.field("StationNumber", jd.Number("I"))


@jd.message(_SERVICE, 0xF936, presence="H", kw_only=True)
class CBRNScanWindowOperatingState(jd.Message):
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

    class ScanMode(IntEnum):
        HORIZONTAL = 0

    timestamp: float | None = jd.field("Timestamp", jd.Number("d", jd.ANY, "second"), default=None)
    station_number: int = jd.field("StationNumber", jd.Number("I"))
    start_scan_window_azimuth: float | None = jd.field("StartScanWindowAzimuth", jd.Number("f", jd.Values(None, ((0.0, 6.2831854820251465),)), "radian"), default=None)
    end_scan_window_azimuth: float | None = jd.field("EndScanWindowAzimuth", jd.Number("f", jd.Values(None, ((0.0, 6.2831854820251465),)), "radian"), default=None)
    scan_window_min_elevation: float | None = jd.field("ScanWindowMinElevation", jd.Number("f", jd.Values(None, ((-3.1415927410125732, 3.1415927410125732),)), "radian"), default=None)
    scan_window_max_elevation: float | None = jd.field("ScanWindowMaxElevation", jd.Number("f", jd.Values(None, ((-3.1415927410125732, 3.1415927410125732),)), "radian"), default=None)
    azimuth_scan_rate: float | None = jd.field("AzimuthScanRate", jd.Number("f", jd.ANY, "radian per second"), default=None)
    elevation_scan_rate: float | None = jd.field("ElevationScanRate", jd.Number("f", jd.ANY, "radian per second"), default=None)
    scan_mode: CBRNScanWindowOperatingState.ScanMode | int | None = jd.field("ScanMode", lambda: jd.Number("B", jd.Values(CBRNScanWindowOperatingState.ScanMode, ((1, 85), (86, 255)))), default=None)
    actual_azimuth: float | None = jd.field("ActualAzimuth", jd.Number("f", jd.Values(None, ((0.0, 6.2831854820251465),)), "radian"), default=None)
    actual_elevation: float | None = jd.field("ActualElevation", jd.Number("f", jd.Values(None, ((-3.1415927410125732, 3.1415927410125732),)), "radian"), default=None)
    scan_radius: float | None = jd.field("ScanRadius", jd.Number("f", jd.ANY, "meter"), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0xF926, query=True)
class QueryCBRNScanWindowOperatingState(jd.Message):
    """QueryCBRNScanWindowOperatingState (0xF926): Asks where a station scans.

    station_number: Number of the station
    """
    REPORT = CBRNScanWindowOperatingState
    station_number: int = jd.field("StationNumber", jd.Number("I"))


@jd.message(_SERVICE, 0xF927, presence="I", command=True, kw_only=True)
class CBRNCommand(jd.Message):
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

    class SetPowerMode(IntEnum):
        OFF = 0
        ON = 1

    class SetOperatingMode(IntEnum):
        OPERATE = 0
        STANDBY = 1
        TRAINING = 2

    class Reboot(IntEnum):
        NORMAL_OPERATION = 0
        REBOOT = 1

    class OperatingResetState(IntEnum):
        NORMAL_OPERATION = 0
        RESET = 1

    class ResetConfigurationState(IntEnum):
        NORMAL_OPERATION = 0
        RESET = 1

    class SetSamplingMode(IntEnum):
        STOP_SAMPLING = 0
        START_SAMPLING = 1
        STOP_SCANNING = 2
        START_SCANNING = 3
        STOP_TRACKING = 4
        START_TRACKING = 5

    class TestType(IntEnum):
        SELF_TEST = 0
        AUDIO_TEST = 1
        CONTROL_TEST = 2
        POWER_DISTRIBUTION_TEST = 3
        SENSING_TEST = 4
        WIRELESS_TEST = 5
        DISMOUNTED_POWER_TEST = 6
        DISPLAY_TEST = 7

    class SetTestMode(IntEnum):
        STOP_TEST = 0
        START_TEST = 1

    class SetLocalAlarmEnunciation(IntEnum):
        SILENCE_ALARM = 0
        ACTIVATE_ALARM = 1

    class SetKeyguard(IntEnum):
        UNLOCKED = 0
        LOCKED = 1

    timestamp: float | None = jd.field("Timestamp", jd.Number("d", jd.ANY, "second"), default=None)
    station_number: int = jd.field("StationNumber", jd.Number("I"))
    set_power_mode: CBRNCommand.SetPowerMode | int | None = jd.field("SetPowerMode", lambda: jd.Number("B", jd.Values(CBRNCommand.SetPowerMode, ((2, 85), (86, 255)))), default=None)
    set_operating_mode: CBRNCommand.SetOperatingMode | int | None = jd.field("SetOperatingMode", lambda: jd.Number("B", jd.Values(CBRNCommand.SetOperatingMode, ((3, 85), (86, 255)))), default=None)
    reboot: CBRNCommand.Reboot | int | None = jd.field("Reboot", lambda: jd.Number("B", jd.Values(CBRNCommand.Reboot, ((2, 85), (86, 255)))), default=None)
    operating_reset_type: int | None = jd.field("OperatingResetType", jd.Number("B", jd.Values(None, ((0, 255),))), default=None)
    operating_reset_state: CBRNCommand.OperatingResetState | int | None = jd.field("OperatingResetState", lambda: jd.Number("B", jd.Values(CBRNCommand.OperatingResetState, ((2, 85), (86, 255)))), default=None)
    reset_configuration_state: CBRNCommand.ResetConfigurationState | int | None = jd.field("ResetConfigurationState", lambda: jd.Number("B", jd.Values(CBRNCommand.ResetConfigurationState, ((2, 85), (86, 255)))), default=None)
    set_sampling_mode: CBRNCommand.SetSamplingMode | int | None = jd.field("SetSamplingMode", lambda: jd.Number("B", jd.Values(CBRNCommand.SetSamplingMode, ((6, 85), (86, 255)))), default=None)
    test_type: CBRNCommand.TestType | int | None = jd.field("TestType", lambda: jd.Number("B", jd.Values(CBRNCommand.TestType, ((8, 85), (86, 255)))), default=None)
    set_test_mode: CBRNCommand.SetTestMode | int | None = jd.field("SetTestMode", lambda: jd.Number("B", jd.Values(CBRNCommand.SetTestMode, ((2, 85), (86, 255)))), default=None)
    set_local_alarm_enunciation: CBRNCommand.SetLocalAlarmEnunciation | int | None = jd.field("SetLocalAlarmEnunciation", lambda: jd.Number("B", jd.Values(CBRNCommand.SetLocalAlarmEnunciation, ((2, 85), (86, 255)))), default=None)
    set_keyguard: CBRNCommand.SetKeyguard | int | None = jd.field("SetKeyguard", lambda: jd.Number("B", jd.Values(CBRNCommand.SetKeyguard, ((2, 85), (86, 255)))), default=None)
    set_clock: float | None = jd.field("SetClock", jd.Number("d", jd.ANY, "second"), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0xF928, presence="I", command=True, kw_only=True)
class CBRNConfigurationCommand(jd.Message):
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

    class SetExerOperFlag(IntEnum):
        EXERCISE = 0
        OPERATION = 1

    class SetPositioningMode(IntEnum):
        MANUAL = 0
        GPS = 1

    class SetPayloadSensitivity(IntEnum):
        NORMAL = 0
        HIGH = 1

    class SetBackgroundLevelSubtractMode(IntEnum):
        DO_NOT_SUBTRACT = 0
        SUBTRACT = 1

    class SetBackgroundLevelMode(IntEnum):
        AUTOMATIC = 0
        MANUAL = 1

    class SetDetectionMode(IntEnum):
        AUTOMATIC = 0
        MANUAL = 1
        STANDBY = 2

    class SetDetectionLevel(IntEnum):
        STANDARD = 0
        MIOSIS = 1
        ICT5 = 2
        ICT50 = 3
        OPERATIONAL = 4
        LOW = 5

    class SetAudioLevel(IntEnum):
        HIGH = 0
        MEDIUM = 1
        LOW = 2
        OFF = 3

    class SetCBRN4DeliveryMode(IntEnum):
        THREAT_RELATED = 0
        CONTINUOUS = 1

    class SetLanguage(IntEnum):
        ENGLISH = 0
        FRENCH = 1

    timestamp: float | None = jd.field("Timestamp", jd.Number("d", jd.ANY, "second"), default=None)
    station_number: int = jd.field("StationNumber", jd.Number("I"))
    set_exer_oper_name: str | None = jd.field("SetExerOperName", jd.Text(count=jd.Count("B", 0, 57)), default=None)
    set_exer_oper_flag: CBRNConfigurationCommand.SetExerOperFlag | int | None = jd.field("SetExerOperFlag", lambda: jd.Number("B", jd.Values(CBRNConfigurationCommand.SetExerOperFlag, ((2, 85), (86, 255)))), default=None)
    set_call_sign: str | None = jd.field("SetCallSign", jd.Text(count=jd.Count("B", 0, 31)), default=None)
    set_positioning_mode: CBRNConfigurationCommand.SetPositioningMode | int | None = jd.field("SetPositioningMode", lambda: jd.Number("B", jd.Values(CBRNConfigurationCommand.SetPositioningMode, ((2, 85), (86, 255)))), default=None)
    set_payload_latitude: float | None = jd.field("SetPayloadLatitude", jd.Number("d", jd.Values(None, ((-1.57079632679, 1.57079632679),)), "radian"), default=None)
    set_payload_longitude: float | None = jd.field("SetPayloadLongitude", jd.Number("d", jd.Values(None, ((-3.141592653589793, 3.141592653589793),)), "radian"), default=None)
    set_payload_altitude: float | None = jd.field("SetPayloadAltitude", jd.Number("f", jd.Values(None, ((-10000.0, 100000.0),)), "meter"), default=None)
    set_payload_sensitivity: CBRNConfigurationCommand.SetPayloadSensitivity | int | None = jd.field("SetPayloadSensitivity", lambda: jd.Number("B", jd.Values(CBRNConfigurationCommand.SetPayloadSensitivity, ((2, 85), (86, 255)))), default=None)
    set_background_level_subtract_mode: CBRNConfigurationCommand.SetBackgroundLevelSubtractMode | int | None = jd.field("SetBackgroundLevelSubtractMode", lambda: jd.Number("B", jd.Values(CBRNConfigurationCommand.SetBackgroundLevelSubtractMode, ((2, 85), (86, 255)))), default=None)
    set_background_level_mode: CBRNConfigurationCommand.SetBackgroundLevelMode | int | None = jd.field("SetBackgroundLevelMode", lambda: jd.Number("B", jd.Values(CBRNConfigurationCommand.SetBackgroundLevelMode, ((2, 85), (86, 255)))), default=None)
    set_background_level: float | None = jd.field("SetBackgroundLevel", jd.Number("f"), default=None)
    set_detection_mode: CBRNConfigurationCommand.SetDetectionMode | int | None = jd.field("SetDetectionMode", lambda: jd.Number("B", jd.Values(CBRNConfigurationCommand.SetDetectionMode, ((3, 85), (86, 255)))), default=None)
    set_detection_level: CBRNConfigurationCommand.SetDetectionLevel | int | None = jd.field("SetDetectionLevel", lambda: jd.Number("B", jd.Values(CBRNConfigurationCommand.SetDetectionLevel, ((6, 85), (86, 255)))), default=None)
    set_detection_operational_threshold_level: float | None = jd.field("SetDetectionOperationalThresholdLevel", jd.Number("d"), default=None)
    set_detection_low_threshold_level: float | None = jd.field("SetDetectionLowThresholdLevel", jd.Number("d"), default=None)
    set_detection_threshold_delay: float | None = jd.field("SetDetectionThresholdDelay", jd.Number("f", jd.ANY, "second"), default=None)
    set_sampling_interval: int | None = jd.field("SetSamplingInterval", jd.Number("I", jd.ANY, "minute"), default=None)
    set_sampling_duration: int | None = jd.field("SetSamplingDuration", jd.Number("I", jd.ANY, "minute"), default=None)
    set_sampling_volume: float | None = jd.field("SetSamplingVolume", jd.Number("d", jd.ANY, "cubic meter"), default=None)
    set_audio_level: CBRNConfigurationCommand.SetAudioLevel | int | None = jd.field("SetAudioLevel", lambda: jd.Number("B", jd.Values(CBRNConfigurationCommand.SetAudioLevel, ((4, 85), (86, 255)))), default=None)
    set_detection_above_threshold_update_frequency: float | None = jd.field("SetDetectionAboveThresholdUpdateFrequency", jd.Number("f", jd.Values(None, ((0.0, 100.0),)), "hertz"), default=None)
    set_location_label: str | None = jd.field("SetLocationLabel", jd.Text(count=jd.Count("B", 0, 16)), default=None)
    set_group_location_label: str | None = jd.field("SetGroupLocationLabel", jd.Text(count=jd.Count("B", 0, 16)), default=None)
    set_cbrn4_delivery_mode: CBRNConfigurationCommand.SetCBRN4DeliveryMode | int = jd.field("SetCBRN4DeliveryMode", lambda: jd.Number("B", jd.Values(CBRNConfigurationCommand.SetCBRN4DeliveryMode, ((2, 85), (86, 255)))))
    set_language: CBRNConfigurationCommand.SetLanguage | int | None = jd.field("SetLanguage", lambda: jd.Number("B", jd.Values(CBRNConfigurationCommand.SetLanguage, ((2, 85), (86, 255)))), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0xF929, presence="I", command=True, kw_only=True)
class CBRNDisplayConfigurationCommand(jd.Message):
    """CBRNDisplayConfigurationCommand (0xF929): Sets the display of a station.

    timestamp: in second, optional. Time of the message, in seconds
    station_number: Number of the station
    set_display_brightness_level: SetDisplayBrightnessLevel or 5..85 or 86..255, optional. Brightness of the display
    set_display_mode: SetDisplayMode or 2..85 or 86..255, optional. Whether the display stays on
    set_display_contrast: 0..100, optional. Contrast of the display, in percent
    set_other_visual_indicators_brightness_level: SetOtherVisualIndicatorsBrightnessLevel or 5..85 or 86..255, optional. Brightness of lamps
    """

    class SetDisplayBrightnessLevel(IntEnum):
        OFF = 0
        LOW = 1
        MEDIUM = 2
        HIGH = 3
        NIGHT_VISION = 4

    class SetDisplayMode(IntEnum):
        POWER_SAVE = 0
        CONTINUOUS = 1

    class SetOtherVisualIndicatorsBrightnessLevel(IntEnum):
        OFF = 0
        LOW = 1
        MEDIUM = 2
        HIGH = 3
        NIGHT_VISION = 4

    timestamp: float | None = jd.field("Timestamp", jd.Number("d", jd.ANY, "second"), default=None)
    station_number: int = jd.field("StationNumber", jd.Number("I"))
    set_display_brightness_level: CBRNDisplayConfigurationCommand.SetDisplayBrightnessLevel | int | None = jd.field("SetDisplayBrightnessLevel", lambda: jd.Number("B", jd.Values(CBRNDisplayConfigurationCommand.SetDisplayBrightnessLevel, ((5, 85), (86, 255)))), default=None)
    set_display_mode: CBRNDisplayConfigurationCommand.SetDisplayMode | int | None = jd.field("SetDisplayMode", lambda: jd.Number("B", jd.Values(CBRNDisplayConfigurationCommand.SetDisplayMode, ((2, 85), (86, 255)))), default=None)
    set_display_contrast: float | None = jd.field("SetDisplayContrast", jd.Number("f", jd.Values(None, ((0.0, 100.0),))), default=None)
    set_other_visual_indicators_brightness_level: CBRNDisplayConfigurationCommand.SetOtherVisualIndicatorsBrightnessLevel | int | None = jd.field("SetOtherVisualIndicatorsBrightnessLevel", lambda: jd.Number("B", jd.Values(CBRNDisplayConfigurationCommand.SetOtherVisualIndicatorsBrightnessLevel, ((5, 85), (86, 255)))), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0xF92A, presence="I", command=True, kw_only=True)
class CBRNScanWindowConfigurationCommand(jd.Message):
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

    class SetScanMode(IntEnum):
        HORIZONTAL = 0

    timestamp: float | None = jd.field("Timestamp", jd.Number("d", jd.ANY, "second"), default=None)
    station_number: int = jd.field("StationNumber", jd.Number("I"))
    set_start_scan_window_azimuth: float | None = jd.field("SetStartScanWindowAzimuth", jd.Number("f", jd.Values(None, ((0.0, 6.2831854820251465),)), "radian"), default=None)
    set_end_scan_window_azimuth: float | None = jd.field("SetEndScanWindowAzimuth", jd.Number("f", jd.Values(None, ((0.0, 6.2831854820251465),)), "radian"), default=None)
    set_scan_window_min_elevation: float | None = jd.field("SetScanWindowMinElevation", jd.Number("f", jd.Values(None, ((-3.1415927410125732, 3.1415927410125732),)), "radian"), default=None)
    set_scan_window_max_elevation: float | None = jd.field("SetScanWindowMaxElevation", jd.Number("f", jd.Values(None, ((-3.1415927410125732, 3.1415927410125732),)), "radian"), default=None)
    set_azimuth_scan_rate: float | None = jd.field("SetAzimuthScanRate", jd.Number("f", jd.ANY, "radian per second"), default=None)
    set_elevation_scan_rate: float | None = jd.field("SetElevationScanRate", jd.Number("f", jd.ANY, "radian per second"), default=None)
    set_scan_mode: CBRNScanWindowConfigurationCommand.SetScanMode | int | None = jd.field("SetScanMode", lambda: jd.Number("B", jd.Values(CBRNScanWindowConfigurationCommand.SetScanMode, ((1, 85), (86, 255)))), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0xF935, presence="I", kw_only=True)
class CBRNConfigurationState(jd.Message):
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

    class ExerOperFlag(IntEnum):
        EXERCISE = 0
        OPERATION = 1

    class PositioningMode(IntEnum):
        MANUAL = 0
        GPS = 1

    class PayloadSensitivity(IntEnum):
        NORMAL = 0
        HIGH = 1

    class BackgroundLevelSubtractMode(IntEnum):
        DO_NOT_SUBTRACT = 0
        SUBTRACT = 1

    class BackgroundLevelMode(IntEnum):
        AUTOMATIC = 0
        MANUAL = 1

    class DetectionMode(IntEnum):
        AUTOMATIC = 0
        MANUAL = 1
        STANDBY = 2

    class DetectionLevel(IntEnum):
        STANDARD = 0
        MIOSIS = 1
        ICT5 = 2
        ICT50 = 3
        OPERATIONAL = 4
        LOW = 5

    class AudioLevel(IntEnum):
        HIGH = 0
        MEDIUM = 1
        LOW = 2
        OFF = 3

    class DisplayBrightnessLevel(IntEnum):
        OFF = 0
        LOW = 1
        MEDIUM = 2
        HIGH = 3
        NIGHT_VISION = 4

    class PayloadCBRNType(IntEnum):
        CHEMICAL = 0
        BIOLOGICAL = 1
        RADIOLOGICAL = 2
        NUCLEAR = 3
        CHEMICAL_STANDOFF = 4
        BIOLOGICAL_STANDOFF = 5
        RADIOLOGICAL_STANDOFF = 6
        NUCLEAR_STANDOFF = 7

    class PowerMode(IntEnum):
        OFF = 0
        ON = 1

    class DisplayMode(IntEnum):
        POWER_SAVE = 0
        CONTINUOUS = 1

    class Language(IntEnum):
        ENGLISH = 0
        FRENCH = 1

    class Keyguard(IntEnum):
        UNLOCKED = 0
        LOCKED = 1

    class ContaminationThresholdField(IntEnum):
        CONTAMINATION = 0
        SEVERITY = 1

    class OtherVisualIndicatorsBrightnessLevel(IntEnum):
        OFF = 0
        LOW = 1
        MEDIUM = 2
        HIGH = 3
        NIGHT_VISION = 4

    class CBRN4DeliveryMode(IntEnum):
        THREAT_RELATED = 0
        CONTINUOUS = 1

    timestamp: float | None = jd.field("Timestamp", jd.Number("d", jd.ANY, "second"), default=None)
    station_number: int = jd.field("StationNumber", jd.Number("I"))
    exer_oper_name: str | None = jd.field("ExerOperName", jd.Text(count=jd.Count("B", 0, 57)), default=None)
    exer_oper_flag: CBRNConfigurationState.ExerOperFlag | int | None = jd.field("ExerOperFlag", lambda: jd.Number("B", jd.Values(CBRNConfigurationState.ExerOperFlag, ((2, 85), (86, 255)))), default=None)
    call_sign: str | None = jd.field("CallSign", jd.Text(count=jd.Count("B", 0, 31)), default=None)
    positioning_mode: CBRNConfigurationState.PositioningMode | int | None = jd.field("PositioningMode", lambda: jd.Number("B", jd.Values(CBRNConfigurationState.PositioningMode, ((2, 85), (86, 255)))), default=None)
    payload_sensitivity: CBRNConfigurationState.PayloadSensitivity | int | None = jd.field("PayloadSensitivity", lambda: jd.Number("B", jd.Values(CBRNConfigurationState.PayloadSensitivity, ((2, 85), (86, 255)))), default=None)
    background_level_subtract_mode: CBRNConfigurationState.BackgroundLevelSubtractMode | int | None = jd.field("BackgroundLevelSubtractMode", lambda: jd.Number("B", jd.Values(CBRNConfigurationState.BackgroundLevelSubtractMode, ((2, 85), (86, 255)))), default=None)
    background_level_mode: CBRNConfigurationState.BackgroundLevelMode | int | None = jd.field("BackgroundLevelMode", lambda: jd.Number("B", jd.Values(CBRNConfigurationState.BackgroundLevelMode, ((2, 85), (86, 255)))), default=None)
    detection_mode: CBRNConfigurationState.DetectionMode | int | None = jd.field("DetectionMode", lambda: jd.Number("B", jd.Values(CBRNConfigurationState.DetectionMode, ((3, 85), (86, 255)))), default=None)
    detection_level: CBRNConfigurationState.DetectionLevel | int | None = jd.field("DetectionLevel", lambda: jd.Number("B", jd.Values(CBRNConfigurationState.DetectionLevel, ((6, 85), (86, 255)))), default=None)
    detection_operational_threshold_level: float | None = jd.field("DetectionOperationalThresholdLevel", jd.Number("d"), default=None)
    detection_low_threshold_level: float | None = jd.field("DetectionLowThresholdLevel", jd.Number("d"), default=None)
    detection_threshold_delay: int | None = jd.field("DetectionThresholdDelay", jd.Number("H", jd.ANY, "second"), default=None)
    sampling_interval: int | None = jd.field("SamplingInterval", jd.Number("I", jd.ANY, "minute"), default=None)
    sampling_duration: int | None = jd.field("SamplingDuration", jd.Number("I", jd.ANY, "minute"), default=None)
    sampling_volume: float | None = jd.field("SamplingVolume", jd.Number("d", jd.ANY, "cubic meter"), default=None)
    audio_level: CBRNConfigurationState.AudioLevel | int | None = jd.field("AudioLevel", lambda: jd.Number("B", jd.Values(CBRNConfigurationState.AudioLevel, ((4, 85), (86, 255)))), default=None)
    display_brightness_level: CBRNConfigurationState.DisplayBrightnessLevel | int | None = jd.field("DisplayBrightnessLevel", lambda: jd.Number("B", jd.Values(CBRNConfigurationState.DisplayBrightnessLevel, ((5, 85), (86, 255)))), default=None)
    product_name: str = jd.field("ProductName", jd.Text(count=jd.Count("B", 0, 30)))
    identifier: str = jd.field("Identifier", jd.Text(count=jd.Count("B", 0, 30)))
    sw_firmware_version: str = jd.field("SWFirmwareVersion", jd.Text(count=jd.Count("B", 0, 30)))
    payload_cbrn_type: CBRNConfigurationState.PayloadCBRNType | int = jd.field("PayloadCBRNType", lambda: jd.Number("B", jd.Values(CBRNConfigurationState.PayloadCBRNType, ((8, 85), (86, 255)))))
    power_mode: CBRNConfigurationState.PowerMode | int = jd.field("PowerMode", lambda: jd.Number("B", jd.Values(CBRNConfigurationState.PowerMode, ((2, 85), (86, 255)))))
    detection_above_threshold_update_frequency: float | None = jd.field("DetectionAboveThresholdUpdateFrequency", jd.Number("f", jd.Values(None, ((0.0, 100.0),)), "hertz"), default=None)
    storage_utilisation: int | None = jd.field("StorageUtilisation", jd.Number("B", jd.Values(None, ((0, 100),))), default=None)
    display_mode: CBRNConfigurationState.DisplayMode | int | None = jd.field("DisplayMode", lambda: jd.Number("B", jd.Values(CBRNConfigurationState.DisplayMode, ((2, 85), (86, 255)))), default=None)
    display_contrast: int | None = jd.field("DisplayContrast", jd.Number("B", jd.Values(None, ((0, 100),))), default=None)
    language: CBRNConfigurationState.Language | int | None = jd.field("Language", lambda: jd.Number("B", jd.Values(CBRNConfigurationState.Language, ((2, 85), (86, 255)))), default=None)
    keyguard: CBRNConfigurationState.Keyguard | int | None = jd.field("Keyguard", lambda: jd.Number("B", jd.Values(CBRNConfigurationState.Keyguard, ((2, 85), (86, 255)))), default=None)
    location_label: str | None = jd.field("LocationLabel", jd.Text(count=jd.Count("B", 0, 16)), default=None)
    group_location_label: str | None = jd.field("GroupLocationLabel", jd.Text(count=jd.Count("B", 0, 16)), default=None)
    contamination_threshold_field: CBRNConfigurationState.ContaminationThresholdField | int | None = jd.field("ContaminationThresholdField", lambda: jd.Number("B", jd.Values(CBRNConfigurationState.ContaminationThresholdField, ((2, 85), (86, 255)))), default=None)
    other_visual_indicators_brightness_level: CBRNConfigurationState.OtherVisualIndicatorsBrightnessLevel | int | None = jd.field("OtherVisualIndicatorsBrightnessLevel", lambda: jd.Number("B", jd.Values(CBRNConfigurationState.OtherVisualIndicatorsBrightnessLevel, ((5, 85), (86, 255)))), default=None)
    cbrn4_delivery_mode: CBRNConfigurationState.CBRN4DeliveryMode | int | None = jd.field("CBRN4DeliveryMode", lambda: jd.Number("B", jd.Values(CBRNConfigurationState.CBRN4DeliveryMode, ((2, 85), (86, 255)))), default=None)
    reserved_presence: int = 0
