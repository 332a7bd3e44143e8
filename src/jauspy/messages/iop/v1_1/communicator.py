"""urn:jaus:jss:iop:Communicator 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:iop:Communicator", "1.1")


@jd.message(_SERVICE, 0x4900)
class ReportCommunicatorCapability(jd.Message):
    """ReportCommunicatorCapability (0x4900): Tells what the link device can do.

    frequency_band_list: 0..255 items. Bands of the radio
    channel_list: 0..255 items. Channels of the radio
    """

    @jd.bit_field("B")
    class SupportedTransmitterStatus(jd.Struct):
        """States into which the transmitter can be put.

        transmit_on: bit 0. Transmit ON.
        transmit_off: bit 1. Transmit OFF.
        standby: bit 2. Standby.
        """
        transmit_on: int = jd.bits(0, 0x1)
        transmit_off: int = jd.bits(1, 0x1)
        standby: int = jd.bits(2, 0x1)
        reserved_bits: int = 0

    @jd.bit_field("B")
    class SupportedModesOfOperation(jd.Struct):
        """Link topologies offered.

        point_to_point: bit 0. Point to point.
        multipoint: bit 1. Multipoint.
        """
        point_to_point: int = jd.bits(0, 0x1)
        multipoint: int = jd.bits(1, 0x1)
        reserved_bits: int = 0

    @jd.bit_field("B")
    class SupportedEncryptionModes(jd.Struct):
        """Whether the device can encrypt.

        transmitter_supports_encryption: bit 0. Transmitter supports encryption.
        """
        transmitter_supports_encryption: int = jd.bits(0, 0x1)
        reserved_bits: int = 0

    @jd.bit_field("B")
    class SupportedTransmitPowerLevels(jd.Struct):
        """Ways in which the power can be adjusted.

        continuous_scale_adjustable: bit 0. Continuous scale adjustable.
        low_power: bit 1. Low power.
        high_power: bit 2. High power.
        automatic_transmit_power_control: bit 3. Automatic transmit power control.
        """
        continuous_scale_adjustable: int = jd.bits(0, 0x1)
        low_power: int = jd.bits(1, 0x1)
        high_power: int = jd.bits(2, 0x1)
        automatic_transmit_power_control: int = jd.bits(3, 0x1)
        reserved_bits: int = 0

    @jd.bit_field("I")
    class SupportedModulationSchemes(jd.Struct):
        """Modulations offered.

        adaptive_modulation: bit 0. Adaptive modulation.
        mod2_qam: bit 1. Mod 2 QAM.
        mod2_psk: bit 2. Mod 2 PSK.
        mod2_fsk: bit 3. Mod 2 FSK.
        mod4_qam: bit 4. Mod 4 QAM.
        mod4_psk: bit 5. Mod 4 PSK.
        mod4_fsk: bit 6. Mod 4 FSK.
        mod8_qam: bit 7. Mod 8 QAM.
        mod8_psk: bit 8. Mod 8 PSK.
        mod8_fsk: bit 9. Mod 8 FSK.
        mod16_qam: bit 10. Mod 16 QAM.
        mod16_psk: bit 11. Mod 16 PSK.
        mod16_fsk: bit 12. Mod 16 FSK.
        mod32_qam: bit 13. Mod 32 QAM.
        mod32_psk: bit 14. Mod 32 PSK.
        mod32_fsk: bit 15. Mod 32 FSK.
        mod64_qam: bit 16. Mod 64 QAM.
        mod64_psk: bit 17. Mod 64 PSK.
        mod64_fsk: bit 18. Mod 64 FSK.
        """
        adaptive_modulation: int = jd.bits(0, 0x1)
        mod2_qam: int = jd.bits(1, 0x1)
        mod2_psk: int = jd.bits(2, 0x1)
        mod2_fsk: int = jd.bits(3, 0x1)
        mod4_qam: int = jd.bits(4, 0x1)
        mod4_psk: int = jd.bits(5, 0x1)
        mod4_fsk: int = jd.bits(6, 0x1)
        mod8_qam: int = jd.bits(7, 0x1)
        mod8_psk: int = jd.bits(8, 0x1)
        mod8_fsk: int = jd.bits(9, 0x1)
        mod16_qam: int = jd.bits(10, 0x1)
        mod16_psk: int = jd.bits(11, 0x1)
        mod16_fsk: int = jd.bits(12, 0x1)
        mod32_qam: int = jd.bits(13, 0x1)
        mod32_psk: int = jd.bits(14, 0x1)
        mod32_fsk: int = jd.bits(15, 0x1)
        mod64_qam: int = jd.bits(16, 0x1)
        mod64_psk: int = jd.bits(17, 0x1)
        mod64_fsk: int = jd.bits(18, 0x1)
        reserved_bits: int = 0

    @jd.record("H")
    class ReportCommunicatorCapabilityRec(jd.Struct):
        """supported_transmitter_status: optional. States into which the transmitter can be put
        supported_modes_of_operation: optional. Link topologies offered
        supported_encryption_modes: optional. Whether the device can encrypt
        min_transmit_power: 0..10 watt, optional. Smallest power that can be sent
        max_transmit_power: 0..10 watt, optional. Largest power that can be sent
        supported_transmit_power_levels: optional. Ways in which the power can be adjusted
        supported_modulation_schemes: optional. Modulations offered
        minimum_occupied_bandwidth: 0..100000000 hertz, optional. Narrowest bandwidth that can be set
        maximum_occupied_bandwidth: 0..100000000 hertz, optional. Widest bandwidth that can be set
        """
        supported_transmitter_status: ReportCommunicatorCapability.SupportedTransmitterStatus | None = jd.field("SupportedTransmitterStatus", lambda: ReportCommunicatorCapability.SupportedTransmitterStatus.layout(), default=None)
        supported_modes_of_operation: ReportCommunicatorCapability.SupportedModesOfOperation | None = jd.field("SupportedModesOfOperation", lambda: ReportCommunicatorCapability.SupportedModesOfOperation.layout(), default=None)
        supported_encryption_modes: ReportCommunicatorCapability.SupportedEncryptionModes | None = jd.field("SupportedEncryptionModes", lambda: ReportCommunicatorCapability.SupportedEncryptionModes.layout(), default=None)
        min_transmit_power: float | None = jd.field("MinTransmitPower", jd.real("H", 0.0, 10.0, "watt"), default=None)
        max_transmit_power: float | None = jd.field("MaxTransmitPower", jd.real("H", 0.0, 10.0, "watt"), default=None)
        supported_transmit_power_levels: ReportCommunicatorCapability.SupportedTransmitPowerLevels | None = jd.field("SupportedTransmitPowerLevels", lambda: ReportCommunicatorCapability.SupportedTransmitPowerLevels.layout(), default=None)
        supported_modulation_schemes: ReportCommunicatorCapability.SupportedModulationSchemes | None = jd.field("SupportedModulationSchemes", lambda: ReportCommunicatorCapability.SupportedModulationSchemes.layout(), default=None)
        minimum_occupied_bandwidth: float | None = jd.field("MinimumOccupiedBandwidth", jd.real("I", 0.0, 100000000.0, "hertz"), default=None)
        maximum_occupied_bandwidth: float | None = jd.field("MaximumOccupiedBandwidth", jd.real("I", 0.0, 100000000.0, "hertz"), default=None)
        reserved_presence: int = 0

    @jd.record()
    class FrequencyBandRec(jd.Struct):
        """band_index: Number by which this band is known
        min_frequency: 100000..10000000000 hertz. Lower edge of the band
        max_frequency: 100000..10000000000 hertz. Upper edge of the band
        """
        band_index: int = jd.field("BandIndex", jd.Number("B"))
        min_frequency: float = jd.field("MinFrequency", jd.real("Q", 100000.0, 10000000000.0, "hertz"))
        max_frequency: float = jd.field("MaxFrequency", jd.real("Q", 100000.0, 10000000000.0, "hertz"))

    @jd.record()
    class ChannelRec(jd.Struct):
        """channel_number: Number of the channel; unique together with its band
        center_frequency: 100000..10000000000 hertz. Middle frequency of the channel
        frequency_band: BandIndex of the band that holds the channel
        """
        channel_number: int = jd.field("ChannelNumber", jd.Number("B"))
        center_frequency: float = jd.field("CenterFrequency", jd.real("Q", 100000.0, 10000000000.0, "hertz"))
        frequency_band: int = jd.field("FrequencyBand", jd.Number("B"))

    report_communicator_capability_rec: ReportCommunicatorCapability.ReportCommunicatorCapabilityRec = jd.field("ReportCommunicatorCapabilityRec", lambda: ReportCommunicatorCapability.ReportCommunicatorCapabilityRec.layout())
    frequency_band_list: list[ReportCommunicatorCapability.FrequencyBandRec] = jd.field("FrequencyBandList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportCommunicatorCapability.FrequencyBandRec.layout()))
    channel_list: list[ReportCommunicatorCapability.ChannelRec] = jd.field("ChannelList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportCommunicatorCapability.ChannelRec.layout()))


@jd.message(_SERVICE, 0x2900, query=True)
class QueryCommunicatorCapability(jd.Message):
    """QueryCommunicatorCapability (0x2900): Asks what the link device can do."""
    REPORT = ReportCommunicatorCapability


@jd.message(_SERVICE, 0x4901)
class ReportCommunicatorConfiguration(jd.Message):
    """ReportCommunicatorConfiguration (0x4901): Tells the settings now in use.

    transmit_power_variant: How the power is set
    """

    class TransmitterStatus(IntEnum):
        TRANSMIT_OFF = 0
        TRANSMIT_ON = 1
        STANDBY = 2

    class ModeOfOperation(IntEnum):
        POINT_TO_POINT = 0
        MULTIPOINT = 1
        MESH_OR_MANET = 2
        CLOUD_NETWORK = 3

    @jd.bit_field("B")
    class EncryptionMode(jd.Struct):
        """Encryption flag.

        transmitter_supports_encryption: bit 0. Transmitter supports encryption.
        """
        transmitter_supports_encryption: int = jd.bits(0, 0x1)
        reserved_bits: int = 0

    class CurrentModulation(IntEnum):
        MOD_2_QAM = 1
        MOD_2_PSK = 2
        MOD_2_FSK = 3
        MOD_4_QAM = 4
        MOD_4_PSK = 5
        MOD_4_FSK = 6
        MOD_8_QAM = 7
        MOD_8_PSK = 8
        MOD_8_FSK = 9
        MOD_16_QAM = 10
        MOD_16_PSK = 11
        MOD_16_FSK = 12
        MOD_32_QAM = 13
        MOD_32_PSK = 14
        MOD_32_FSK = 15
        MOD_64_QAM = 16
        MOD_64_PSK = 17
        MOD_64_FSK = 18

    @jd.bit_field("B")
    class ActiveModulationScheme(jd.Struct):
        """Modulation in use.

        adaptive_modulation: bit 0. Adaptive modulation.
        current_modulation: bits 1..7. Current modulation.
        """
        adaptive_modulation: int = jd.bits(0, 0x1)
        current_modulation: ReportCommunicatorConfiguration.CurrentModulation | int = jd.bits(1, 0x7F, lambda: jd.Values(ReportCommunicatorConfiguration.CurrentModulation))

    @jd.record("B")
    class ReportCommunicatorConfigurationRec(jd.Struct):
        """transmitter_status: TransmitterStatus, optional. State of the transmitter
        mode_of_operation: ModeOfOperation, optional. Link topology in use
        encryption_mode: optional. Encryption flag
        channel: optional. Number of the channel in use
        frequency_band: optional. BandIndex (see 4900) of the band in use
        active_modulation_scheme: optional. Modulation in use
        occupied_bandwidth: 0..100000000 hertz, optional. Bandwidth in use
        """
        transmitter_status: ReportCommunicatorConfiguration.TransmitterStatus | int | None = jd.field("TransmitterStatus", lambda: jd.Number("B", jd.Values(ReportCommunicatorConfiguration.TransmitterStatus)), default=None)
        mode_of_operation: ReportCommunicatorConfiguration.ModeOfOperation | int | None = jd.field("ModeOfOperation", lambda: jd.Number("B", jd.Values(ReportCommunicatorConfiguration.ModeOfOperation)), default=None)
        encryption_mode: ReportCommunicatorConfiguration.EncryptionMode | None = jd.field("EncryptionMode", lambda: ReportCommunicatorConfiguration.EncryptionMode.layout(), default=None)
        channel: int | None = jd.field("Channel", jd.Number("B"), default=None)
        frequency_band: int | None = jd.field("FrequencyBand", jd.Number("B"), default=None)
        active_modulation_scheme: ReportCommunicatorConfiguration.ActiveModulationScheme | None = jd.field("ActiveModulationScheme", lambda: ReportCommunicatorConfiguration.ActiveModulationScheme.layout(), default=None)
        occupied_bandwidth: float | None = jd.field("OccupiedBandwidth", jd.real("I", 0.0, 100000000.0, "hertz"), default=None)
        reserved_presence: int = 0

    @jd.record()
    class ContinuousAdjustableRec(jd.Struct):
        """transmit_power: 0..10 watt. Power on a stepless scale"""
        transmit_power: float = jd.field("TransmitPower", jd.real("H", 0.0, 10.0, "watt"))

    class TransmitPower(IntEnum):
        LOW_POWER = 0
        HIGH_POWER = 1

    @jd.record()
    class HighLowPowerRec(jd.Struct):
        """transmit_power: TransmitPower. One of two power steps"""
        transmit_power: ReportCommunicatorConfiguration.TransmitPower | int = jd.field("TransmitPower", lambda: jd.Number("B", jd.Values(ReportCommunicatorConfiguration.TransmitPower)))

    @jd.record()
    class AutomaticPowerControlRec(jd.Struct):
        """Automatic power control.

        min_transmit_power: 0..10 watt. Lower bound for the automatic control
        max_transmit_power: 0..10 watt. Upper bound for the automatic control
        current_transmit_power: 0..10 watt. Power at this time; in a command only a wish
        """
        min_transmit_power: float = jd.field("MinTransmitPower", jd.real("H", 0.0, 10.0, "watt"))
        max_transmit_power: float = jd.field("MaxTransmitPower", jd.real("H", 0.0, 10.0, "watt"))
        current_transmit_power: float = jd.field("CurrentTransmitPower", jd.real("H", 0.0, 10.0, "watt"))

    class TransmitPowerNoChange(IntEnum):
        NO_CHANGE = 0

    @jd.record()
    class NoChangeRec(jd.Struct):
        """transmit_power_no_change: TransmitPowerNoChange. Keeps the power as it is"""
        transmit_power_no_change: ReportCommunicatorConfiguration.TransmitPowerNoChange | int = jd.field("TransmitPowerNoChange", lambda: jd.Number("B", jd.Values(ReportCommunicatorConfiguration.TransmitPowerNoChange)))

    report_communicator_configuration_rec: ReportCommunicatorConfiguration.ReportCommunicatorConfigurationRec = jd.field("ReportCommunicatorConfigurationRec", lambda: ReportCommunicatorConfiguration.ReportCommunicatorConfigurationRec.layout())
    transmit_power_variant: ReportCommunicatorConfiguration.ContinuousAdjustableRec | ReportCommunicatorConfiguration.HighLowPowerRec | ReportCommunicatorConfiguration.AutomaticPowerControlRec | ReportCommunicatorConfiguration.NoChangeRec = jd.field("TransmitPowerVariant", lambda: jd.Union.of("B", continuous_adjustable_rec=ReportCommunicatorConfiguration.ContinuousAdjustableRec, high_low_power_rec=ReportCommunicatorConfiguration.HighLowPowerRec, automatic_power_control_rec=ReportCommunicatorConfiguration.AutomaticPowerControlRec, no_change_rec=ReportCommunicatorConfiguration.NoChangeRec))


@jd.message(_SERVICE, 0x2901, query=True)
class QueryCommunicatorConfiguration(jd.Message):
    """QueryCommunicatorConfiguration (0x2901): Asks for the settings now in use.

    presence_vector: Mask of the fields wanted in the report
    """
    REPORT = ReportCommunicatorConfiguration
    presence_vector: int = jd.field("PresenceVector", jd.Number("H"))


@jd.message(_SERVICE, 0x4902)
class ReportCommunicatorHealth(jd.Message):
    """ReportCommunicatorHealth (0x4902): Tells the condition of the link.

    error_variant: Errors, as a count or a rate
    snr_per_channel_list: 0..255 items. Signal to noise of each channel
    """

    class BIT_Results(IntEnum):
        PASSED = 0
        FAILED = 1

    @jd.record("B")
    class ReportCommunicatorHealthRec(jd.Struct):
        """bit_results: BIT_Results, optional. Outcome of the built-in test
        latency: 0..1 second, optional. Delay over the link
        data_rate: 0..1000, optional. Throughput in megabits per second
        received_signal_power: -120..-20, optional. Strength of the received signal in dBm
        error_vector_magnitude: 0..100, optional. Error vector magnitude in percent
        """
        bit_results: ReportCommunicatorHealth.BIT_Results | int | None = jd.field("BIT_Results", lambda: jd.Number("B", jd.Values(ReportCommunicatorHealth.BIT_Results)), default=None)
        latency: float | None = jd.field("Latency", jd.real("H", 0.0, 1.0, "second"), default=None)
        data_rate: float | None = jd.field("DataRate", jd.real("H", 0.0, 1000.0), default=None)
        received_signal_power: float | None = jd.field("ReceivedSignalPower", jd.real("H", -120.0, -20.0), default=None)
        error_vector_magnitude: float | None = jd.field("ErrorVectorMagnitude", jd.real("H", 0.0, 100.0), default=None)
        reserved_presence: int = 0

    @jd.record()
    class PacketErrorCountRec(jd.Struct):
        """packet_error_count: Bad packets during the past second"""
        packet_error_count: int = jd.field("PacketErrorCount", jd.Number("I"))

    @jd.record()
    class PacketErrorRateRec(jd.Struct):
        """packet_error_rate: 0..100. Share of bad packets in percent"""
        packet_error_rate: float = jd.field("PacketErrorRate", jd.real("I", 0.0, 100.0))

    @jd.record()
    class BitErrorCountRec(jd.Struct):
        """bit_error_count: Bad bits during the past second"""
        bit_error_count: int = jd.field("BitErrorCount", jd.Number("I"))

    @jd.record()
    class BitErrorRateRec(jd.Struct):
        """bit_error_rate: 0..100. Share of bad bits in percent"""
        bit_error_rate: float = jd.field("BitErrorRate", jd.real("I", 0.0, 100.0))

    @jd.record()
    class SNR_Per_ChannelRec(jd.Struct):
        """channel: Number of the channel
        snr: 0..100. Signal to noise ratio
        """
        channel: int = jd.field("Channel", jd.Number("B"))
        snr: float = jd.field("SNR", jd.real("H", 0.0, 100.0))

    report_communicator_health_rec: ReportCommunicatorHealth.ReportCommunicatorHealthRec = jd.field("ReportCommunicatorHealthRec", lambda: ReportCommunicatorHealth.ReportCommunicatorHealthRec.layout())
    error_variant: ReportCommunicatorHealth.PacketErrorCountRec | ReportCommunicatorHealth.PacketErrorRateRec | ReportCommunicatorHealth.BitErrorCountRec | ReportCommunicatorHealth.BitErrorRateRec = jd.field("ErrorVariant", lambda: jd.Union.of("B", packet_error_count_rec=ReportCommunicatorHealth.PacketErrorCountRec, packet_error_rate_rec=ReportCommunicatorHealth.PacketErrorRateRec, bit_error_count_rec=ReportCommunicatorHealth.BitErrorCountRec, bit_error_rate_rec=ReportCommunicatorHealth.BitErrorRateRec))
    snr_per_channel_list: list[ReportCommunicatorHealth.SNR_Per_ChannelRec] = jd.field("SNR_Per_ChannelList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportCommunicatorHealth.SNR_Per_ChannelRec.layout()))


@jd.message(_SERVICE, 0x2902, query=True)
class QueryCommunicatorHealth(jd.Message):
    """QueryCommunicatorHealth (0x2902): Asks for the condition of the link.

    presence_vector: Mask of the fields wanted in the report
    """
    REPORT = ReportCommunicatorHealth
    presence_vector: int = jd.field("PresenceVector", jd.Number("H"))


@jd.message(_SERVICE, 0x0901, command=True)
class SetCommunicatorConfiguration(jd.Message):
    """SetCommunicatorConfiguration (0x0901): Changes settings of the link device.

    transmit_power_variant: How the power is to be set
    """

    class TransmitterStatus(IntEnum):
        TRANSMIT_OFF = 0
        TRANSMIT_ON = 1
        STANDBY = 2

    class ModeOfOperation(IntEnum):
        POINT_TO_POINT = 0
        MULTIPOINT = 1

    @jd.bit_field("B")
    class EncryptionMode(jd.Struct):
        """Encryption flag.

        transmitter_mode: bit 0. Transmitter mode.
        """
        transmitter_mode: int = jd.bits(0, 0x1)
        reserved_bits: int = 0

    class ModulationScheme(IntEnum):
        ADAPTIVE_MODULATION = 0
        MOD_2_QAM = 1
        MOD_2_PSK = 2
        MOD_2_FSK = 3
        MOD_4_QAM = 4
        MOD_4_PSK = 5
        MOD_4_FSK = 6
        MOD_8_QAM = 7
        MOD_8_PSK = 8
        MOD_8_FSK = 9
        MOD_16_QAM = 10
        MOD_16_PSK = 11
        MOD_16_FSK = 12
        MOD_32_QAM = 13
        MOD_32_PSK = 14
        MOD_32_FSK = 15
        MOD_64_QAM = 16
        MOD_64_PSK = 17
        MOD_64_FSK = 18

    @jd.record("B")
    class SetCommunicatorConfigurationRec(jd.Struct):
        """transmitter_status: TransmitterStatus, optional. State wanted for the transmitter
        mode_of_operation: ModeOfOperation, optional. Link topology wanted
        encryption_mode: optional. Encryption flag
        channel: optional. Number of a channel out of report 4900
        frequency_band: optional. BandIndex of a band out of report 4900
        modulation_scheme: ModulationScheme, optional. Modulation wanted
        occupied_bandwidth: 0..100000000 hertz, optional. Bandwidth wanted
        """
        transmitter_status: SetCommunicatorConfiguration.TransmitterStatus | int | None = jd.field("TransmitterStatus", lambda: jd.Number("B", jd.Values(SetCommunicatorConfiguration.TransmitterStatus)), default=None)
        mode_of_operation: SetCommunicatorConfiguration.ModeOfOperation | int | None = jd.field("ModeOfOperation", lambda: jd.Number("B", jd.Values(SetCommunicatorConfiguration.ModeOfOperation)), default=None)
        encryption_mode: SetCommunicatorConfiguration.EncryptionMode | None = jd.field("EncryptionMode", lambda: SetCommunicatorConfiguration.EncryptionMode.layout(), default=None)
        channel: int | None = jd.field("Channel", jd.Number("B"), default=None)
        frequency_band: int | None = jd.field("FrequencyBand", jd.Number("B"), default=None)
        modulation_scheme: SetCommunicatorConfiguration.ModulationScheme | int | None = jd.field("ModulationScheme", lambda: jd.Number("B", jd.Values(SetCommunicatorConfiguration.ModulationScheme)), default=None)
        occupied_bandwidth: float | None = jd.field("OccupiedBandwidth", jd.real("I", 0.0, 100000000.0, "hertz"), default=None)
        reserved_presence: int = 0

    @jd.record()
    class ContinuousAdjustableRec(jd.Struct):
        """transmit_power: 0..10 watt. Power on a stepless scale"""
        transmit_power: float = jd.field("TransmitPower", jd.real("H", 0.0, 10.0, "watt"))

    class TransmitPower(IntEnum):
        LOW_POWER = 0
        HIGH_POWER = 1

    @jd.record()
    class HighLowPowerRec(jd.Struct):
        """transmit_power: TransmitPower. One of two power steps"""
        transmit_power: SetCommunicatorConfiguration.TransmitPower | int = jd.field("TransmitPower", lambda: jd.Number("B", jd.Values(SetCommunicatorConfiguration.TransmitPower)))

    @jd.record()
    class AutomaticPowerControlRec(jd.Struct):
        """Automatic power control.

        min_transmit_power: 0..10 watt. Lower bound for the automatic control
        max_transmit_power: 0..10 watt. Upper bound for the automatic control
        current_transmit_power: 0..10 watt. Power at this time; in a command only a wish
        """
        min_transmit_power: float = jd.field("MinTransmitPower", jd.real("H", 0.0, 10.0, "watt"))
        max_transmit_power: float = jd.field("MaxTransmitPower", jd.real("H", 0.0, 10.0, "watt"))
        current_transmit_power: float = jd.field("CurrentTransmitPower", jd.real("H", 0.0, 10.0, "watt"))

    class TransmitPowerNoChange(IntEnum):
        NO_CHANGE = 0

    @jd.record()
    class NoChangeRec(jd.Struct):
        """transmit_power_no_change: TransmitPowerNoChange. Keeps the power as it is"""
        transmit_power_no_change: SetCommunicatorConfiguration.TransmitPowerNoChange | int = jd.field("TransmitPowerNoChange", lambda: jd.Number("B", jd.Values(SetCommunicatorConfiguration.TransmitPowerNoChange)))

    set_communicator_configuration_rec: SetCommunicatorConfiguration.SetCommunicatorConfigurationRec = jd.field("SetCommunicatorConfigurationRec", lambda: SetCommunicatorConfiguration.SetCommunicatorConfigurationRec.layout())
    transmit_power_variant: SetCommunicatorConfiguration.ContinuousAdjustableRec | SetCommunicatorConfiguration.HighLowPowerRec | SetCommunicatorConfiguration.AutomaticPowerControlRec | SetCommunicatorConfiguration.NoChangeRec = jd.field("TransmitPowerVariant", lambda: jd.Union.of("B", continuous_adjustable_rec=SetCommunicatorConfiguration.ContinuousAdjustableRec, high_low_power_rec=SetCommunicatorConfiguration.HighLowPowerRec, automatic_power_control_rec=SetCommunicatorConfiguration.AutomaticPowerControlRec, no_change_rec=SetCommunicatorConfiguration.NoChangeRec))


@jd.message(_SERVICE, 0x0902)
class SetCommunicatorConfigurationResponse(jd.Message):
    """SetCommunicatorConfigurationResponse (0x0902): Answers a change of settings; no bit set means that all was accepted.

    result: Reasons for refusing
    """

    @jd.bit_field("B")
    class Result(jd.Struct):
        """Reasons for refusing.

        transmitted_status_invalid: bit 0. Transmitted status invalid.
        mode_invalid: bit 1. Mode invalid.
        channel_invalid: bit 2. Channel invalid.
        power_level_invalid: bit 3. Power level invalid.
        modulation_invalid: bit 4. Modulation invalid.
        bandwidth_invalid: bit 5. Bandwidth invalid.
        encryption_mode_invalid: bit 6. Encryption mode invalid.
        other_failure: bit 7. Other failure.
        """
        transmitted_status_invalid: int = jd.bits(0, 0x1)
        mode_invalid: int = jd.bits(1, 0x1)
        channel_invalid: int = jd.bits(2, 0x1)
        power_level_invalid: int = jd.bits(3, 0x1)
        modulation_invalid: int = jd.bits(4, 0x1)
        bandwidth_invalid: int = jd.bits(5, 0x1)
        encryption_mode_invalid: int = jd.bits(6, 0x1)
        other_failure: int = jd.bits(7, 0x1)

    result: SetCommunicatorConfigurationResponse.Result = jd.field("Result", lambda: SetCommunicatorConfigurationResponse.Result.layout())
