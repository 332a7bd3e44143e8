"""urn:jaus:jss:ugv:PowerPlantManager 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt


@dataclass(slots=True, repr=False)
class SetPowerPlantConfiguration(rt.Message):
    """SetPowerPlantConfiguration (0x0506): Switches power plants and sets what they are to do.

    power_plant_configuration_list: 0..255 items. The power plants
    """

    CODE = 0x0506
    NAME = "SetPowerPlantConfiguration"
    SERVICE = "urn:jaus:jss:ugv:PowerPlantManager"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    @dataclass(slots=True, repr=False)
    class PowerPlantID(rt.Struct):
        """Identifies the power plant.

        power_plant_id: 0..255. Identifies the power plant
        """

        power_plant_id: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("powerPlantID", rt.Number("B", rt.Values(None, ((0, 255),)))),
            )

    class PowerState(IntEnum):
        """Values of PowerState."""

        POWER_ON = 1
        POWER_OFF = 2
        POWER_STANDBY = 3

    @dataclass(slots=True, repr=False)
    class GasEngineConfigurationRec(rt.Struct):
        """Settings of a petrol engine.

        power_state: PowerState. Whether it is on
        rpm: optional. Wanted revolutions per minute
        throttle: 0..100, optional. Throttle, in percent of the maximum
        """

        power_state: SetPowerPlantConfiguration.PowerState | int
        rpm: int | None = None
        throttle: float | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("powerState", rt.Number("B", rt.Values(SetPowerPlantConfiguration.PowerState))),
                ("rpm", rt.Number("H"), True),
                ("throttle", rt.real("H", 0.0, 100.0), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_SetPowerPlantConfiguration_GasEngineConfigurationRec_0[mask & 0x3]
            raw = iter(packer.unpack_from(data, at + 1)).__next__
            at = at + 1 + packer.size
            power_state_ = raw()
            self.power_state = _E_SetPowerPlantConfiguration_PowerState[power_state_]
            self.rpm = raw() if mask & 1 else None
            self.throttle = raw() * 0.0015259021896696422 if mask & 2 else None
            self.reserved_presence = mask & 0xFC
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x3: raise rt.Reject
            raw: list[int | float | bytes] = []
            power_state_ = self.power_state
            if power_state_ not in _E_SetPowerPlantConfiguration_PowerState: raise rt.Reject
            raw.append(power_state_)
            rpm_ = self.rpm
            if rpm_ is not None:
                mask |= 1
                raw.append(rpm_)
            throttle_ = self.throttle
            if throttle_ is not None:
                mask |= 2
                if not 0.0 <= throttle_ <= 100.0: raise rt.Reject
                near = throttle_ * 655.35 + 0.5
                throttle_raw_ = int(near)
                if not 1.52587890625e-05 < near - throttle_raw_ < 0.9999847412109375: throttle_raw_ = rt.exact_raw(throttle_, _R_2)
                raw.append(throttle_raw_)
            out += _M_SetPowerPlantConfiguration_GasEngineConfigurationRec_0[mask & 0x3].pack(*raw)
            _S_B.pack_into(out, start, mask)

    class PlugState(IntEnum):
        """Values of PlugState."""

        GLOWPLUG_ON = 1
        GLOWPLUG_OFF = 2

    @dataclass(slots=True, repr=False)
    class DieselEngineConfigurationRec(rt.Struct):
        """Settings of a diesel engine.

        power_state: PowerState. Whether it is on
        rpm: optional. Wanted revolutions per minute
        throttle: 0..100, optional. Throttle, in percent of the maximum
        plug_state: PlugState, optional. Whether the glow plugs are on
        """

        power_state: SetPowerPlantConfiguration.PowerState | int
        rpm: int | None = None
        throttle: float | None = None
        plug_state: SetPowerPlantConfiguration.PlugState | int | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("powerState", rt.Number("B", rt.Values(SetPowerPlantConfiguration.PowerState))),
                ("rpm", rt.Number("H"), True),
                ("throttle", rt.real("H", 0.0, 100.0), True),
                ("plugState", rt.Number("B", rt.Values(SetPowerPlantConfiguration.PlugState)), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_SetPowerPlantConfiguration_DieselEngineConfigurationRec_0[mask & 0x7]
            raw = iter(packer.unpack_from(data, at + 1)).__next__
            at = at + 1 + packer.size
            power_state_ = raw()
            self.power_state = _E_SetPowerPlantConfiguration_PowerState[power_state_]
            self.rpm = raw() if mask & 1 else None
            self.throttle = raw() * 0.0015259021896696422 if mask & 2 else None
            if mask & 4:
                plug_state_ = raw()
                self.plug_state = _E_SetPowerPlantConfiguration_PlugState[plug_state_]
            else: self.plug_state = None
            self.reserved_presence = mask & 0xF8
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x7: raise rt.Reject
            raw: list[int | float | bytes] = []
            power_state_ = self.power_state
            if power_state_ not in _E_SetPowerPlantConfiguration_PowerState: raise rt.Reject
            raw.append(power_state_)
            rpm_ = self.rpm
            if rpm_ is not None:
                mask |= 1
                raw.append(rpm_)
            throttle_ = self.throttle
            if throttle_ is not None:
                mask |= 2
                if not 0.0 <= throttle_ <= 100.0: raise rt.Reject
                near = throttle_ * 655.35 + 0.5
                throttle_raw_ = int(near)
                if not 1.52587890625e-05 < near - throttle_raw_ < 0.9999847412109375: throttle_raw_ = rt.exact_raw(throttle_, _R_2)
                raw.append(throttle_raw_)
            plug_state_ = self.plug_state
            if plug_state_ is not None:
                mask |= 4
                if plug_state_ not in _E_SetPowerPlantConfiguration_PlugState: raise rt.Reject
                raw.append(plug_state_)
            out += _M_SetPowerPlantConfiguration_DieselEngineConfigurationRec_0[mask & 0x7].pack(*raw)
            _S_B.pack_into(out, start, mask)

    @dataclass(slots=True, repr=False)
    class BatteryConfigurationRec(rt.Struct):
        """Settings of a battery.

        power_state: PowerState. Whether it is on
        """

        power_state: SetPowerPlantConfiguration.PowerState | int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("powerState", rt.Number("B", rt.Values(SetPowerPlantConfiguration.PowerState))),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            power_state_ = data[at]
            self.power_state = _E_SetPowerPlantConfiguration_PowerState[power_state_]
            return self, at + 1

        def _write(self, out: bytearray) -> None:
            power_state_ = self.power_state
            if power_state_ not in _E_SetPowerPlantConfiguration_PowerState: raise rt.Reject
            out.append(power_state_)

    @dataclass(slots=True, repr=False)
    class HydraulicConfigurationRec(rt.Struct):
        """Settings of a hydraulic pump.

        power_state: PowerState. Whether it is on
        """

        power_state: SetPowerPlantConfiguration.PowerState | int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("powerState", rt.Number("B", rt.Values(SetPowerPlantConfiguration.PowerState))),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            power_state_ = data[at]
            self.power_state = _E_SetPowerPlantConfiguration_PowerState[power_state_]
            return self, at + 1

        def _write(self, out: bytearray) -> None:
            power_state_ = self.power_state
            if power_state_ not in _E_SetPowerPlantConfiguration_PowerState: raise rt.Reject
            out.append(power_state_)

    @dataclass(slots=True, repr=False)
    class FuelCellConfigurationRecs(rt.Struct):
        """Settings of a fuel cell.

        power_state: PowerState. Whether it is on
        """

        power_state: SetPowerPlantConfiguration.PowerState | int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("powerState", rt.Number("B", rt.Values(SetPowerPlantConfiguration.PowerState))),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            power_state_ = data[at]
            self.power_state = _E_SetPowerPlantConfiguration_PowerState[power_state_]
            return self, at + 1

        def _write(self, out: bytearray) -> None:
            power_state_ = self.power_state
            if power_state_ not in _E_SetPowerPlantConfiguration_PowerState: raise rt.Reject
            out.append(power_state_)

    @dataclass(slots=True, repr=False)
    class PowerPlantConfigurationSeq(rt.Struct):
        """PowerPlantConfigurationSeq.

        power_plant_id: Identifies the power plant
        power_plant_configuration_var: Settings, by kind of power plant
        """

        power_plant_id: SetPowerPlantConfiguration.PowerPlantID
        power_plant_configuration_var: SetPowerPlantConfiguration.GasEngineConfigurationRec | SetPowerPlantConfiguration.DieselEngineConfigurationRec | SetPowerPlantConfiguration.BatteryConfigurationRec | SetPowerPlantConfiguration.HydraulicConfigurationRec | SetPowerPlantConfiguration.FuelCellConfigurationRecs

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("powerPlantID", SetPowerPlantConfiguration.PowerPlantID.layout()),
                ("powerPlantConfigurationVar", rt.Union.of("B", gas_engine_configuration_rec=SetPowerPlantConfiguration.GasEngineConfigurationRec, diesel_engine_configuration_rec=SetPowerPlantConfiguration.DieselEngineConfigurationRec, battery_configuration_rec=SetPowerPlantConfiguration.BatteryConfigurationRec, hydraulic_configuration_rec=SetPowerPlantConfiguration.HydraulicConfigurationRec, fuel_cell_configuration_recs=SetPowerPlantConfiguration.FuelCellConfigurationRecs)),
            )

    power_plant_configuration_list: list[SetPowerPlantConfiguration.PowerPlantConfigurationSeq]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("powerPlantConfigurationList", rt.Repeat(rt.Count("B", 0, 255), SetPowerPlantConfiguration.PowerPlantConfigurationSeq.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x06 or data[1] != 0x05: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        power_plant_configuration_list_count_ = data[2]
        if power_plant_configuration_list_count_ * 3 > size - 3: raise rt.Reject
        at = 3
        power_plant_configuration_list_ = []
        for _ in range(power_plant_configuration_list_count_):
            item_ = rt.new(SetPowerPlantConfiguration.PowerPlantConfigurationSeq)
            power_plant_id_ = data[at]
            item_.power_plant_id = SetPowerPlantConfiguration.PowerPlantID(power_plant_id_)
            tag = data[at + 1]
            at += 2
            item_.power_plant_configuration_var, at = _U_6[tag]._read(data, at, nesting)
            power_plant_configuration_list_.append(item_)
        self.power_plant_configuration_list = power_plant_configuration_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x06\x05")
        power_plant_configuration_list_ = self.power_plant_configuration_list
        if type(power_plant_configuration_list_) is not list: raise rt.Reject
        out.append(len(power_plant_configuration_list_))
        for item_ in power_plant_configuration_list_:
            if type(item_) is not SetPowerPlantConfiguration.PowerPlantConfigurationSeq: raise rt.Reject
            power_plant_id_ = item_.power_plant_id
            if type(power_plant_id_) is not SetPowerPlantConfiguration.PowerPlantID: raise rt.Reject
            out.append(power_plant_id_.power_plant_id)
            power_plant_configuration_var_ = item_.power_plant_configuration_var
            out.append(_T_7[type(power_plant_configuration_var_)])
            power_plant_configuration_var_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class QueryPowerPlantConfiguration(rt.Message):
    """QueryPowerPlantConfiguration (0x2506): Asks what power plants are to do.

    id_list: 0..255 items. The power plants
    """

    CODE = 0x2506
    NAME = "QueryPowerPlantConfiguration"
    SERVICE = "urn:jaus:jss:ugv:PowerPlantManager"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportPowerPlantConfiguration]]

    @dataclass(slots=True, repr=False)
    class PowerPlantID(rt.Struct):
        """Identifies the power plant.

        power_plant_id: 0..255. Identifies the power plant
        """

        power_plant_id: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("powerPlantID", rt.Number("B", rt.Values(None, ((0, 255),)))),
            )

    id_list: list[QueryPowerPlantConfiguration.PowerPlantID]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("idList", rt.Repeat(rt.Count("B", 0, 255), QueryPowerPlantConfiguration.PowerPlantID.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x06 or data[1] != 0x25: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        id_list_count_ = data[2]
        id_list_end_ = 3 + id_list_count_ * 1
        self.id_list = [QueryPowerPlantConfiguration.PowerPlantID(power_plant_id_) for power_plant_id_ in _L_B[id_list_count_].unpack_from(data, 3)]
        if id_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x06\x25")
        id_list_ = self.id_list
        if type(id_list_) is not list: raise rt.Reject
        out.append(len(id_list_))
        raw_: list[int | float] = []
        for item_ in id_list_:
            if type(item_) is not QueryPowerPlantConfiguration.PowerPlantID: raise rt.Reject
            raw_.append(item_.power_plant_id)
        out += _L_B[len(raw_)].pack(*raw_)
        return bytes(out)


@dataclass(slots=True, repr=False)
class QueryPowerPlantCapabilities(rt.Message):
    """QueryPowerPlantCapabilities (0x2507): Asks for limits of power plants.

    id_list: 0..255 items. The power plants
    """

    CODE = 0x2507
    NAME = "QueryPowerPlantCapabilities"
    SERVICE = "urn:jaus:jss:ugv:PowerPlantManager"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportPowerPlantCapabilities]]

    @dataclass(slots=True, repr=False)
    class PowerPlantID(rt.Struct):
        """Identifies the power plant.

        power_plant_id: 0..255. Identifies the power plant
        """

        power_plant_id: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("powerPlantID", rt.Number("B", rt.Values(None, ((0, 255),)))),
            )

    id_list: list[QueryPowerPlantCapabilities.PowerPlantID]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("idList", rt.Repeat(rt.Count("B", 0, 255), QueryPowerPlantCapabilities.PowerPlantID.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x07 or data[1] != 0x25: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        id_list_count_ = data[2]
        id_list_end_ = 3 + id_list_count_ * 1
        self.id_list = [QueryPowerPlantCapabilities.PowerPlantID(power_plant_id_) for power_plant_id_ in _L_B[id_list_count_].unpack_from(data, 3)]
        if id_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x07\x25")
        id_list_ = self.id_list
        if type(id_list_) is not list: raise rt.Reject
        out.append(len(id_list_))
        raw_: list[int | float] = []
        for item_ in id_list_:
            if type(item_) is not QueryPowerPlantCapabilities.PowerPlantID: raise rt.Reject
            raw_.append(item_.power_plant_id)
        out += _L_B[len(raw_)].pack(*raw_)
        return bytes(out)


@dataclass(slots=True, repr=False)
class QueryPowerPlantStatus(rt.Message):
    """QueryPowerPlantStatus (0x2508): Asks for the state of power plants.

    id_list: 0..255 items. The power plants
    """

    CODE = 0x2508
    NAME = "QueryPowerPlantStatus"
    SERVICE = "urn:jaus:jss:ugv:PowerPlantManager"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportPowerPlantStatus]]

    @dataclass(slots=True, repr=False)
    class PowerPlantID(rt.Struct):
        """Identifies the power plant.

        power_plant_id: 0..255. Identifies the power plant
        """

        power_plant_id: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("powerPlantID", rt.Number("B", rt.Values(None, ((0, 255),)))),
            )

    id_list: list[QueryPowerPlantStatus.PowerPlantID]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("idList", rt.Repeat(rt.Count("B", 0, 255), QueryPowerPlantStatus.PowerPlantID.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x08 or data[1] != 0x25: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        id_list_count_ = data[2]
        id_list_end_ = 3 + id_list_count_ * 1
        self.id_list = [QueryPowerPlantStatus.PowerPlantID(power_plant_id_) for power_plant_id_ in _L_B[id_list_count_].unpack_from(data, 3)]
        if id_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x08\x25")
        id_list_ = self.id_list
        if type(id_list_) is not list: raise rt.Reject
        out.append(len(id_list_))
        raw_: list[int | float] = []
        for item_ in id_list_:
            if type(item_) is not QueryPowerPlantStatus.PowerPlantID: raise rt.Reject
            raw_.append(item_.power_plant_id)
        out += _L_B[len(raw_)].pack(*raw_)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportPowerPlantConfiguration(rt.Message):
    """ReportPowerPlantConfiguration (0x4506): Tells what power plants are to do.

    power_plant_configuration_list: 0..255 items. The power plants
    """

    CODE = 0x4506
    NAME = "ReportPowerPlantConfiguration"
    SERVICE = "urn:jaus:jss:ugv:PowerPlantManager"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    @dataclass(slots=True, repr=False)
    class PowerPlantID(rt.Struct):
        """Identifies the power plant.

        power_plant_id: 0..255. Identifies the power plant
        """

        power_plant_id: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("powerPlantID", rt.Number("B", rt.Values(None, ((0, 255),)))),
            )

    class PowerState(IntEnum):
        """Values of PowerState."""

        POWER_ON = 1
        POWER_OFF = 2
        POWER_STANDBY = 3

    @dataclass(slots=True, repr=False)
    class GasEngineConfigurationRec(rt.Struct):
        """Settings of a petrol engine.

        power_state: PowerState. Whether it is on
        rpm: optional. Wanted revolutions per minute
        throttle: 0..100, optional. Throttle, in percent of the maximum
        """

        power_state: ReportPowerPlantConfiguration.PowerState | int
        rpm: int | None = None
        throttle: float | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("powerState", rt.Number("B", rt.Values(ReportPowerPlantConfiguration.PowerState))),
                ("rpm", rt.Number("H"), True),
                ("throttle", rt.real("H", 0.0, 100.0), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_SetPowerPlantConfiguration_GasEngineConfigurationRec_0[mask & 0x3]
            raw = iter(packer.unpack_from(data, at + 1)).__next__
            at = at + 1 + packer.size
            power_state_ = raw()
            self.power_state = _E_ReportPowerPlantConfiguration_PowerState[power_state_]
            self.rpm = raw() if mask & 1 else None
            self.throttle = raw() * 0.0015259021896696422 if mask & 2 else None
            self.reserved_presence = mask & 0xFC
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x3: raise rt.Reject
            raw: list[int | float | bytes] = []
            power_state_ = self.power_state
            if power_state_ not in _E_ReportPowerPlantConfiguration_PowerState: raise rt.Reject
            raw.append(power_state_)
            rpm_ = self.rpm
            if rpm_ is not None:
                mask |= 1
                raw.append(rpm_)
            throttle_ = self.throttle
            if throttle_ is not None:
                mask |= 2
                if not 0.0 <= throttle_ <= 100.0: raise rt.Reject
                near = throttle_ * 655.35 + 0.5
                throttle_raw_ = int(near)
                if not 1.52587890625e-05 < near - throttle_raw_ < 0.9999847412109375: throttle_raw_ = rt.exact_raw(throttle_, _R_2)
                raw.append(throttle_raw_)
            out += _M_SetPowerPlantConfiguration_GasEngineConfigurationRec_0[mask & 0x3].pack(*raw)
            _S_B.pack_into(out, start, mask)

    class PlugState(IntEnum):
        """Values of PlugState."""

        GLOWPLUG_ON = 1
        GLOWPLUG_OFF = 2

    @dataclass(slots=True, repr=False)
    class DieselEngineConfigurationRec(rt.Struct):
        """Settings of a diesel engine.

        power_state: PowerState. Whether it is on
        rpm: optional. Wanted revolutions per minute
        throttle: 0..100, optional. Throttle, in percent of the maximum
        plug_state: PlugState, optional. Whether the glow plugs are on
        """

        power_state: ReportPowerPlantConfiguration.PowerState | int
        rpm: int | None = None
        throttle: float | None = None
        plug_state: ReportPowerPlantConfiguration.PlugState | int | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("powerState", rt.Number("B", rt.Values(ReportPowerPlantConfiguration.PowerState))),
                ("rpm", rt.Number("H"), True),
                ("throttle", rt.real("H", 0.0, 100.0), True),
                ("plugState", rt.Number("B", rt.Values(ReportPowerPlantConfiguration.PlugState)), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_SetPowerPlantConfiguration_DieselEngineConfigurationRec_0[mask & 0x7]
            raw = iter(packer.unpack_from(data, at + 1)).__next__
            at = at + 1 + packer.size
            power_state_ = raw()
            self.power_state = _E_ReportPowerPlantConfiguration_PowerState[power_state_]
            self.rpm = raw() if mask & 1 else None
            self.throttle = raw() * 0.0015259021896696422 if mask & 2 else None
            if mask & 4:
                plug_state_ = raw()
                self.plug_state = _E_ReportPowerPlantConfiguration_PlugState[plug_state_]
            else: self.plug_state = None
            self.reserved_presence = mask & 0xF8
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x7: raise rt.Reject
            raw: list[int | float | bytes] = []
            power_state_ = self.power_state
            if power_state_ not in _E_ReportPowerPlantConfiguration_PowerState: raise rt.Reject
            raw.append(power_state_)
            rpm_ = self.rpm
            if rpm_ is not None:
                mask |= 1
                raw.append(rpm_)
            throttle_ = self.throttle
            if throttle_ is not None:
                mask |= 2
                if not 0.0 <= throttle_ <= 100.0: raise rt.Reject
                near = throttle_ * 655.35 + 0.5
                throttle_raw_ = int(near)
                if not 1.52587890625e-05 < near - throttle_raw_ < 0.9999847412109375: throttle_raw_ = rt.exact_raw(throttle_, _R_2)
                raw.append(throttle_raw_)
            plug_state_ = self.plug_state
            if plug_state_ is not None:
                mask |= 4
                if plug_state_ not in _E_ReportPowerPlantConfiguration_PlugState: raise rt.Reject
                raw.append(plug_state_)
            out += _M_SetPowerPlantConfiguration_DieselEngineConfigurationRec_0[mask & 0x7].pack(*raw)
            _S_B.pack_into(out, start, mask)

    @dataclass(slots=True, repr=False)
    class BatteryConfigurationRec(rt.Struct):
        """Settings of a battery.

        power_state: PowerState. Whether it is on
        """

        power_state: ReportPowerPlantConfiguration.PowerState | int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("powerState", rt.Number("B", rt.Values(ReportPowerPlantConfiguration.PowerState))),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            power_state_ = data[at]
            self.power_state = _E_ReportPowerPlantConfiguration_PowerState[power_state_]
            return self, at + 1

        def _write(self, out: bytearray) -> None:
            power_state_ = self.power_state
            if power_state_ not in _E_ReportPowerPlantConfiguration_PowerState: raise rt.Reject
            out.append(power_state_)

    @dataclass(slots=True, repr=False)
    class HydraulicConfigurationRec(rt.Struct):
        """Settings of a hydraulic pump.

        power_state: PowerState. Whether it is on
        """

        power_state: ReportPowerPlantConfiguration.PowerState | int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("powerState", rt.Number("B", rt.Values(ReportPowerPlantConfiguration.PowerState))),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            power_state_ = data[at]
            self.power_state = _E_ReportPowerPlantConfiguration_PowerState[power_state_]
            return self, at + 1

        def _write(self, out: bytearray) -> None:
            power_state_ = self.power_state
            if power_state_ not in _E_ReportPowerPlantConfiguration_PowerState: raise rt.Reject
            out.append(power_state_)

    @dataclass(slots=True, repr=False)
    class FuelCellConfigurationRecs(rt.Struct):
        """Settings of a fuel cell.

        power_state: PowerState. Whether it is on
        """

        power_state: ReportPowerPlantConfiguration.PowerState | int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("powerState", rt.Number("B", rt.Values(ReportPowerPlantConfiguration.PowerState))),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            power_state_ = data[at]
            self.power_state = _E_ReportPowerPlantConfiguration_PowerState[power_state_]
            return self, at + 1

        def _write(self, out: bytearray) -> None:
            power_state_ = self.power_state
            if power_state_ not in _E_ReportPowerPlantConfiguration_PowerState: raise rt.Reject
            out.append(power_state_)

    @dataclass(slots=True, repr=False)
    class PowerPlantConfigurationSeq(rt.Struct):
        """PowerPlantConfigurationSeq.

        power_plant_id: Identifies the power plant
        power_plant_configuration_var: Settings, by kind of power plant
        """

        power_plant_id: ReportPowerPlantConfiguration.PowerPlantID
        power_plant_configuration_var: ReportPowerPlantConfiguration.GasEngineConfigurationRec | ReportPowerPlantConfiguration.DieselEngineConfigurationRec | ReportPowerPlantConfiguration.BatteryConfigurationRec | ReportPowerPlantConfiguration.HydraulicConfigurationRec | ReportPowerPlantConfiguration.FuelCellConfigurationRecs

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("powerPlantID", ReportPowerPlantConfiguration.PowerPlantID.layout()),
                ("powerPlantConfigurationVar", rt.Union.of("B", gas_engine_configuration_rec=ReportPowerPlantConfiguration.GasEngineConfigurationRec, diesel_engine_configuration_rec=ReportPowerPlantConfiguration.DieselEngineConfigurationRec, battery_configuration_rec=ReportPowerPlantConfiguration.BatteryConfigurationRec, hydraulic_configuration_rec=ReportPowerPlantConfiguration.HydraulicConfigurationRec, fuel_cell_configuration_recs=ReportPowerPlantConfiguration.FuelCellConfigurationRecs)),
            )

    power_plant_configuration_list: list[ReportPowerPlantConfiguration.PowerPlantConfigurationSeq]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("powerPlantConfigurationList", rt.Repeat(rt.Count("B", 0, 255), ReportPowerPlantConfiguration.PowerPlantConfigurationSeq.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x06 or data[1] != 0x45: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        power_plant_configuration_list_count_ = data[2]
        if power_plant_configuration_list_count_ * 3 > size - 3: raise rt.Reject
        at = 3
        power_plant_configuration_list_ = []
        for _ in range(power_plant_configuration_list_count_):
            item_ = rt.new(ReportPowerPlantConfiguration.PowerPlantConfigurationSeq)
            power_plant_id_ = data[at]
            item_.power_plant_id = ReportPowerPlantConfiguration.PowerPlantID(power_plant_id_)
            tag = data[at + 1]
            at += 2
            item_.power_plant_configuration_var, at = _U_11[tag]._read(data, at, nesting)
            power_plant_configuration_list_.append(item_)
        self.power_plant_configuration_list = power_plant_configuration_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x06\x45")
        power_plant_configuration_list_ = self.power_plant_configuration_list
        if type(power_plant_configuration_list_) is not list: raise rt.Reject
        out.append(len(power_plant_configuration_list_))
        for item_ in power_plant_configuration_list_:
            if type(item_) is not ReportPowerPlantConfiguration.PowerPlantConfigurationSeq: raise rt.Reject
            power_plant_id_ = item_.power_plant_id
            if type(power_plant_id_) is not ReportPowerPlantConfiguration.PowerPlantID: raise rt.Reject
            out.append(power_plant_id_.power_plant_id)
            power_plant_configuration_var_ = item_.power_plant_configuration_var
            out.append(_T_12[type(power_plant_configuration_var_)])
            power_plant_configuration_var_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportPowerPlantCapabilities(rt.Message):
    """ReportPowerPlantCapabilities (0x4507): Tells limits of power plants.

    power_plant_capabilities_list: 0..255 items. The power plants
    """

    CODE = 0x4507
    NAME = "ReportPowerPlantCapabilities"
    SERVICE = "urn:jaus:jss:ugv:PowerPlantManager"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    @dataclass(slots=True, repr=False)
    class PowerPlantDescRec(rt.Struct):
        """One power plant and its description.

        power_plant_id: Identifies the power plant
        description: up to 255 characters. Description, for people
        """

        power_plant_id: int
        description: str

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("powerPlantID", rt.Number("B")),
                ("description", rt.Text(count=rt.Count("B", 0, 255))),
            )

    @dataclass(slots=True, repr=False)
    class GasEngineCapabilitiesRec(rt.Struct):
        """GasEngineCapabilitiesRec.

        fuel_capacity: 0..256 liter, optional. Amount of fuel when full, in litres
        oil_capacity: 0..256 liter, optional. Amount of oil when full, in litres
        max_oil_pressure: 0..512 bar, optional. Largest pressure of the oil, in bar
        max_oil_temp: -75..180 degree Celsius, optional. Largest temperature of the oil, in degrees Celsius
        max_engine_temp: 0..256 degree Celsius, optional. Largest temperature of the engine, in degrees Celsius
        max_coolant_level: 0..256 liter, optional. Amount of coolant when full, in litres
        max_coolant_temp: -75..180 degree Celsius, optional. Largest temperature of the coolant, in degrees Celsius
        """

        fuel_capacity: float | None = None
        oil_capacity: float | None = None
        max_oil_pressure: float | None = None
        max_oil_temp: float | None = None
        max_engine_temp: float | None = None
        max_coolant_level: float | None = None
        max_coolant_temp: float | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("fuelCapacity", rt.real("H", 0.0, 256.0, "liter"), True),
                ("oilCapacity", rt.real("H", 0.0, 256.0, "liter"), True),
                ("maxOilPressure", rt.real("H", 0.0, 512.0, "bar"), True),
                ("maxOilTemp", rt.real("H", -75.0, 180.0, "degree Celsius"), True),
                ("maxEngineTemp", rt.real("H", 0.0, 256.0, "degree Celsius"), True),
                ("maxCoolantLevel", rt.real("H", 0.0, 256.0, "liter"), True),
                ("maxCoolantTemp", rt.real("H", -75.0, 180.0, "degree Celsius"), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_ReportPowerPlantCapabilities_GasEngineCapabilitiesRec_0[mask & 0x7F]
            raw = iter(packer.unpack_from(data, at + 1)).__next__
            at = at + 1 + packer.size
            self.fuel_capacity = raw() * 0.003906309605554284 if mask & 1 else None
            self.oil_capacity = raw() * 0.003906309605554284 if mask & 2 else None
            self.max_oil_pressure = raw() * 0.007812619211108568 if mask & 4 else None
            self.max_oil_temp = -75.0 + raw() * 0.0038910505836575876 if mask & 8 else None
            self.max_engine_temp = raw() * 0.003906309605554284 if mask & 16 else None
            self.max_coolant_level = raw() * 0.003906309605554284 if mask & 32 else None
            self.max_coolant_temp = -75.0 + raw() * 0.0038910505836575876 if mask & 64 else None
            self.reserved_presence = mask & 0x80
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x7F: raise rt.Reject
            raw: list[int | float | bytes] = []
            fuel_capacity_ = self.fuel_capacity
            if fuel_capacity_ is not None:
                mask |= 1
                if not 0.0 <= fuel_capacity_ <= 256.0: raise rt.Reject
                near = fuel_capacity_ * 255.99609375 + 0.5
                fuel_capacity_raw_ = int(near)
                if not 1.52587890625e-05 < near - fuel_capacity_raw_ < 0.9999847412109375: fuel_capacity_raw_ = rt.exact_raw(fuel_capacity_, _R_14)
                raw.append(fuel_capacity_raw_)
            oil_capacity_ = self.oil_capacity
            if oil_capacity_ is not None:
                mask |= 2
                if not 0.0 <= oil_capacity_ <= 256.0: raise rt.Reject
                near = oil_capacity_ * 255.99609375 + 0.5
                oil_capacity_raw_ = int(near)
                if not 1.52587890625e-05 < near - oil_capacity_raw_ < 0.9999847412109375: oil_capacity_raw_ = rt.exact_raw(oil_capacity_, _R_14)
                raw.append(oil_capacity_raw_)
            max_oil_pressure_ = self.max_oil_pressure
            if max_oil_pressure_ is not None:
                mask |= 4
                if not 0.0 <= max_oil_pressure_ <= 512.0: raise rt.Reject
                near = max_oil_pressure_ * 127.998046875 + 0.5
                max_oil_pressure_raw_ = int(near)
                if not 1.52587890625e-05 < near - max_oil_pressure_raw_ < 0.9999847412109375: max_oil_pressure_raw_ = rt.exact_raw(max_oil_pressure_, _R_15)
                raw.append(max_oil_pressure_raw_)
            max_oil_temp_ = self.max_oil_temp
            if max_oil_temp_ is not None:
                mask |= 8
                if not -75.0 <= max_oil_temp_ <= 180.0: raise rt.Reject
                near = max_oil_temp_ * 257.0 + 19275.5
                max_oil_temp_raw_ = int(near)
                if not 1.52587890625e-05 < near - max_oil_temp_raw_ < 0.9999847412109375: max_oil_temp_raw_ = rt.exact_raw(max_oil_temp_, _R_16)
                raw.append(max_oil_temp_raw_)
            max_engine_temp_ = self.max_engine_temp
            if max_engine_temp_ is not None:
                mask |= 16
                if not 0.0 <= max_engine_temp_ <= 256.0: raise rt.Reject
                near = max_engine_temp_ * 255.99609375 + 0.5
                max_engine_temp_raw_ = int(near)
                if not 1.52587890625e-05 < near - max_engine_temp_raw_ < 0.9999847412109375: max_engine_temp_raw_ = rt.exact_raw(max_engine_temp_, _R_14)
                raw.append(max_engine_temp_raw_)
            max_coolant_level_ = self.max_coolant_level
            if max_coolant_level_ is not None:
                mask |= 32
                if not 0.0 <= max_coolant_level_ <= 256.0: raise rt.Reject
                near = max_coolant_level_ * 255.99609375 + 0.5
                max_coolant_level_raw_ = int(near)
                if not 1.52587890625e-05 < near - max_coolant_level_raw_ < 0.9999847412109375: max_coolant_level_raw_ = rt.exact_raw(max_coolant_level_, _R_14)
                raw.append(max_coolant_level_raw_)
            max_coolant_temp_ = self.max_coolant_temp
            if max_coolant_temp_ is not None:
                mask |= 64
                if not -75.0 <= max_coolant_temp_ <= 180.0: raise rt.Reject
                near = max_coolant_temp_ * 257.0 + 19275.5
                max_coolant_temp_raw_ = int(near)
                if not 1.52587890625e-05 < near - max_coolant_temp_raw_ < 0.9999847412109375: max_coolant_temp_raw_ = rt.exact_raw(max_coolant_temp_, _R_16)
                raw.append(max_coolant_temp_raw_)
            out += _M_ReportPowerPlantCapabilities_GasEngineCapabilitiesRec_0[mask & 0x7F].pack(*raw)
            _S_B.pack_into(out, start, mask)

    @dataclass(slots=True, repr=False)
    class DieselEngineCapabilitiesRec(rt.Struct):
        """DieselEngineCapabilitiesRec.

        fuel_capacity: 0..256 liter, optional. Amount of fuel when full, in litres
        oil_capacity: 0..256 liter, optional. Amount of oil when full, in litres
        max_oil_pressure: 0..512 bar, optional. Largest pressure of the oil, in bar
        max_oil_temp: -75..180 degree Celsius, optional. Largest temperature of the oil, in degrees Celsius
        max_engine_temp: 0..256 degree Celsius, optional. Largest temperature of the engine, in degrees Celsius
        max_coolant_level: 0..256 liter, optional. Amount of coolant when full, in litres
        max_coolant_temp: -75..180 degree Celsius, optional. Largest temperature of the coolant, in degrees Celsius
        max_glow_plug_temp: 0..256 degree Celsius, optional. Largest temperature of the glow plugs, in degrees Celsius
        glow_plug_time: 0..256 second, optional. Time that the glow plugs need, in seconds
        """

        fuel_capacity: float | None = None
        oil_capacity: float | None = None
        max_oil_pressure: float | None = None
        max_oil_temp: float | None = None
        max_engine_temp: float | None = None
        max_coolant_level: float | None = None
        max_coolant_temp: float | None = None
        max_glow_plug_temp: float | None = None
        glow_plug_time: float | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "H",
                ("fuelCapacity", rt.real("H", 0.0, 256.0, "liter"), True),
                ("oilCapacity", rt.real("H", 0.0, 256.0, "liter"), True),
                ("maxOilPressure", rt.real("H", 0.0, 512.0, "bar"), True),
                ("maxOilTemp", rt.real("H", -75.0, 180.0, "degree Celsius"), True),
                ("maxEngineTemp", rt.real("H", 0.0, 256.0, "degree Celsius"), True),
                ("maxCoolantLevel", rt.real("H", 0.0, 256.0, "liter"), True),
                ("maxCoolantTemp", rt.real("H", -75.0, 180.0, "degree Celsius"), True),
                ("maxGlowPlugTemp", rt.real("H", 0.0, 256.0, "degree Celsius"), True),
                ("glowPlugTime", rt.real("H", 0.0, 256.0, "second"), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            (mask,) = _S_H.unpack_from(data, at)
            packer = _M_ReportPowerPlantCapabilities_DieselEngineCapabilitiesRec_0[mask & 0x1FF]
            raw = iter(packer.unpack_from(data, at + 2)).__next__
            at = at + 2 + packer.size
            self.fuel_capacity = raw() * 0.003906309605554284 if mask & 1 else None
            self.oil_capacity = raw() * 0.003906309605554284 if mask & 2 else None
            self.max_oil_pressure = raw() * 0.007812619211108568 if mask & 4 else None
            self.max_oil_temp = -75.0 + raw() * 0.0038910505836575876 if mask & 8 else None
            self.max_engine_temp = raw() * 0.003906309605554284 if mask & 16 else None
            self.max_coolant_level = raw() * 0.003906309605554284 if mask & 32 else None
            self.max_coolant_temp = -75.0 + raw() * 0.0038910505836575876 if mask & 64 else None
            self.max_glow_plug_temp = raw() * 0.003906309605554284 if mask & 128 else None
            self.glow_plug_time = raw() * 0.003906309605554284 if mask & 256 else None
            self.reserved_presence = mask & 0xFE00
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0\0"
            mask = self.reserved_presence
            if mask & 0x1FF: raise rt.Reject
            raw: list[int | float | bytes] = []
            fuel_capacity_ = self.fuel_capacity
            if fuel_capacity_ is not None:
                mask |= 1
                if not 0.0 <= fuel_capacity_ <= 256.0: raise rt.Reject
                near = fuel_capacity_ * 255.99609375 + 0.5
                fuel_capacity_raw_ = int(near)
                if not 1.52587890625e-05 < near - fuel_capacity_raw_ < 0.9999847412109375: fuel_capacity_raw_ = rt.exact_raw(fuel_capacity_, _R_14)
                raw.append(fuel_capacity_raw_)
            oil_capacity_ = self.oil_capacity
            if oil_capacity_ is not None:
                mask |= 2
                if not 0.0 <= oil_capacity_ <= 256.0: raise rt.Reject
                near = oil_capacity_ * 255.99609375 + 0.5
                oil_capacity_raw_ = int(near)
                if not 1.52587890625e-05 < near - oil_capacity_raw_ < 0.9999847412109375: oil_capacity_raw_ = rt.exact_raw(oil_capacity_, _R_14)
                raw.append(oil_capacity_raw_)
            max_oil_pressure_ = self.max_oil_pressure
            if max_oil_pressure_ is not None:
                mask |= 4
                if not 0.0 <= max_oil_pressure_ <= 512.0: raise rt.Reject
                near = max_oil_pressure_ * 127.998046875 + 0.5
                max_oil_pressure_raw_ = int(near)
                if not 1.52587890625e-05 < near - max_oil_pressure_raw_ < 0.9999847412109375: max_oil_pressure_raw_ = rt.exact_raw(max_oil_pressure_, _R_15)
                raw.append(max_oil_pressure_raw_)
            max_oil_temp_ = self.max_oil_temp
            if max_oil_temp_ is not None:
                mask |= 8
                if not -75.0 <= max_oil_temp_ <= 180.0: raise rt.Reject
                near = max_oil_temp_ * 257.0 + 19275.5
                max_oil_temp_raw_ = int(near)
                if not 1.52587890625e-05 < near - max_oil_temp_raw_ < 0.9999847412109375: max_oil_temp_raw_ = rt.exact_raw(max_oil_temp_, _R_16)
                raw.append(max_oil_temp_raw_)
            max_engine_temp_ = self.max_engine_temp
            if max_engine_temp_ is not None:
                mask |= 16
                if not 0.0 <= max_engine_temp_ <= 256.0: raise rt.Reject
                near = max_engine_temp_ * 255.99609375 + 0.5
                max_engine_temp_raw_ = int(near)
                if not 1.52587890625e-05 < near - max_engine_temp_raw_ < 0.9999847412109375: max_engine_temp_raw_ = rt.exact_raw(max_engine_temp_, _R_14)
                raw.append(max_engine_temp_raw_)
            max_coolant_level_ = self.max_coolant_level
            if max_coolant_level_ is not None:
                mask |= 32
                if not 0.0 <= max_coolant_level_ <= 256.0: raise rt.Reject
                near = max_coolant_level_ * 255.99609375 + 0.5
                max_coolant_level_raw_ = int(near)
                if not 1.52587890625e-05 < near - max_coolant_level_raw_ < 0.9999847412109375: max_coolant_level_raw_ = rt.exact_raw(max_coolant_level_, _R_14)
                raw.append(max_coolant_level_raw_)
            max_coolant_temp_ = self.max_coolant_temp
            if max_coolant_temp_ is not None:
                mask |= 64
                if not -75.0 <= max_coolant_temp_ <= 180.0: raise rt.Reject
                near = max_coolant_temp_ * 257.0 + 19275.5
                max_coolant_temp_raw_ = int(near)
                if not 1.52587890625e-05 < near - max_coolant_temp_raw_ < 0.9999847412109375: max_coolant_temp_raw_ = rt.exact_raw(max_coolant_temp_, _R_16)
                raw.append(max_coolant_temp_raw_)
            max_glow_plug_temp_ = self.max_glow_plug_temp
            if max_glow_plug_temp_ is not None:
                mask |= 128
                if not 0.0 <= max_glow_plug_temp_ <= 256.0: raise rt.Reject
                near = max_glow_plug_temp_ * 255.99609375 + 0.5
                max_glow_plug_temp_raw_ = int(near)
                if not 1.52587890625e-05 < near - max_glow_plug_temp_raw_ < 0.9999847412109375: max_glow_plug_temp_raw_ = rt.exact_raw(max_glow_plug_temp_, _R_14)
                raw.append(max_glow_plug_temp_raw_)
            glow_plug_time_ = self.glow_plug_time
            if glow_plug_time_ is not None:
                mask |= 256
                if not 0.0 <= glow_plug_time_ <= 256.0: raise rt.Reject
                near = glow_plug_time_ * 255.99609375 + 0.5
                glow_plug_time_raw_ = int(near)
                if not 1.52587890625e-05 < near - glow_plug_time_raw_ < 0.9999847412109375: glow_plug_time_raw_ = rt.exact_raw(glow_plug_time_, _R_14)
                raw.append(glow_plug_time_raw_)
            out += _M_ReportPowerPlantCapabilities_DieselEngineCapabilitiesRec_0[mask & 0x1FF].pack(*raw)
            _S_H.pack_into(out, start, mask)

    @dataclass(slots=True, repr=False)
    class BatteryCapabilitiesRec(rt.Struct):
        """BatteryCapabilitiesRec.

        nominal_voltage: 0..1000 volt, optional. Voltage that the battery is made for, in volts
        max_charge: 0..3600000 coulomb, optional. Charge when full, in coulombs
        max_cranking_amps: 0..5000 ampere, optional. Largest current for starting, in amperes
        """

        nominal_voltage: float | None = None
        max_charge: float | None = None
        max_cranking_amps: float | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("nominalVoltage", rt.real("H", 0.0, 1000.0, "volt"), True),
                ("maxCharge", rt.real("I", 0.0, 3600000.0, "coulomb"), True),
                ("maxCrankingAmps", rt.real("H", 0.0, 5000.0, "ampere"), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_ReportPowerPlantCapabilities_BatteryCapabilitiesRec_0[mask & 0x7]
            raw = iter(packer.unpack_from(data, at + 1)).__next__
            at = at + 1 + packer.size
            self.nominal_voltage = raw() * 0.015259021896696421 if mask & 1 else None
            self.max_charge = raw() * 0.0008381903173490871 if mask & 2 else None
            self.max_cranking_amps = raw() * 0.07629510948348212 if mask & 4 else None
            self.reserved_presence = mask & 0xF8
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x7: raise rt.Reject
            raw: list[int | float | bytes] = []
            nominal_voltage_ = self.nominal_voltage
            if nominal_voltage_ is not None:
                mask |= 1
                if not 0.0 <= nominal_voltage_ <= 1000.0: raise rt.Reject
                near = nominal_voltage_ * 65.535 + 0.5
                nominal_voltage_raw_ = int(near)
                if not 1.52587890625e-05 < near - nominal_voltage_raw_ < 0.9999847412109375: nominal_voltage_raw_ = rt.exact_raw(nominal_voltage_, _R_20)
                raw.append(nominal_voltage_raw_)
            max_charge_ = self.max_charge
            if max_charge_ is not None:
                mask |= 2
                if not 0.0 <= max_charge_ <= 3600000.0: raise rt.Reject
                near = max_charge_ * 1193.0464708333334 + 0.5
                max_charge_raw_ = int(near)
                if not 1.52587890625e-05 < near - max_charge_raw_ < 0.9999847412109375: max_charge_raw_ = rt.exact_raw(max_charge_, _R_21)
                raw.append(max_charge_raw_)
            max_cranking_amps_ = self.max_cranking_amps
            if max_cranking_amps_ is not None:
                mask |= 4
                if not 0.0 <= max_cranking_amps_ <= 5000.0: raise rt.Reject
                near = max_cranking_amps_ * 13.107 + 0.5
                max_cranking_amps_raw_ = int(near)
                if not 1.52587890625e-05 < near - max_cranking_amps_raw_ < 0.9999847412109375: max_cranking_amps_raw_ = rt.exact_raw(max_cranking_amps_, _R_22)
                raw.append(max_cranking_amps_raw_)
            out += _M_ReportPowerPlantCapabilities_BatteryCapabilitiesRec_0[mask & 0x7].pack(*raw)
            _S_B.pack_into(out, start, mask)

    @dataclass(slots=True, repr=False)
    class BatteryCapabilitiesList(rt.Struct):
        """The batteries.

        battery_capabilities_list: 0..255 items. The batteries
        """

        battery_capabilities_list: list[ReportPowerPlantCapabilities.BatteryCapabilitiesRec]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("batteryCapabilitiesList", rt.Repeat(rt.Count("B", 0, 255), ReportPowerPlantCapabilities.BatteryCapabilitiesRec.layout())),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            size = len(data)
            self = rt.new(cls)
            battery_capabilities_list_count_ = data[at]
            if battery_capabilities_list_count_ * 1 > size - (at + 1): raise rt.Reject
            at += 1
            battery_capabilities_list_ = []
            for _ in range(battery_capabilities_list_count_):
                item_, at = ReportPowerPlantCapabilities.BatteryCapabilitiesRec._read(data, at, nesting)
                battery_capabilities_list_.append(item_)
            self.battery_capabilities_list = battery_capabilities_list_
            return self, at

        def _write(self, out: bytearray) -> None:
            battery_capabilities_list_ = self.battery_capabilities_list
            if type(battery_capabilities_list_) is not list: raise rt.Reject
            out.append(len(battery_capabilities_list_))
            for item_ in battery_capabilities_list_:
                if type(item_) is not ReportPowerPlantCapabilities.BatteryCapabilitiesRec: raise rt.Reject
                item_._write(out)

    @dataclass(slots=True, repr=False)
    class HydraulicCapabilitiesRec(rt.Struct):
        """HydraulicCapabilitiesRec.

        fluid_capacity: 0..256 liter, optional. Amount of fluid when full, in litres
        max_pressure: 0..512 bar, optional. Largest pressure of the fluid, in bar
        max_temp: -75..180 degree Celsius, optional. Largest temperature of the fluid, in degrees Celsius
        """

        fluid_capacity: float | None = None
        max_pressure: float | None = None
        max_temp: float | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("fluidCapacity", rt.real("H", 0.0, 256.0, "liter"), True),
                ("maxPressure", rt.real("H", 0.0, 512.0, "bar"), True),
                ("maxTemp", rt.real("H", -75.0, 180.0, "degree Celsius"), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_ReportPowerPlantCapabilities_HydraulicCapabilitiesRec_0[mask & 0x7]
            raw = iter(packer.unpack_from(data, at + 1)).__next__
            at = at + 1 + packer.size
            self.fluid_capacity = raw() * 0.003906309605554284 if mask & 1 else None
            self.max_pressure = raw() * 0.007812619211108568 if mask & 2 else None
            self.max_temp = -75.0 + raw() * 0.0038910505836575876 if mask & 4 else None
            self.reserved_presence = mask & 0xF8
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x7: raise rt.Reject
            raw: list[int | float | bytes] = []
            fluid_capacity_ = self.fluid_capacity
            if fluid_capacity_ is not None:
                mask |= 1
                if not 0.0 <= fluid_capacity_ <= 256.0: raise rt.Reject
                near = fluid_capacity_ * 255.99609375 + 0.5
                fluid_capacity_raw_ = int(near)
                if not 1.52587890625e-05 < near - fluid_capacity_raw_ < 0.9999847412109375: fluid_capacity_raw_ = rt.exact_raw(fluid_capacity_, _R_14)
                raw.append(fluid_capacity_raw_)
            max_pressure_ = self.max_pressure
            if max_pressure_ is not None:
                mask |= 2
                if not 0.0 <= max_pressure_ <= 512.0: raise rt.Reject
                near = max_pressure_ * 127.998046875 + 0.5
                max_pressure_raw_ = int(near)
                if not 1.52587890625e-05 < near - max_pressure_raw_ < 0.9999847412109375: max_pressure_raw_ = rt.exact_raw(max_pressure_, _R_15)
                raw.append(max_pressure_raw_)
            max_temp_ = self.max_temp
            if max_temp_ is not None:
                mask |= 4
                if not -75.0 <= max_temp_ <= 180.0: raise rt.Reject
                near = max_temp_ * 257.0 + 19275.5
                max_temp_raw_ = int(near)
                if not 1.52587890625e-05 < near - max_temp_raw_ < 0.9999847412109375: max_temp_raw_ = rt.exact_raw(max_temp_, _R_16)
                raw.append(max_temp_raw_)
            out += _M_ReportPowerPlantCapabilities_HydraulicCapabilitiesRec_0[mask & 0x7].pack(*raw)
            _S_B.pack_into(out, start, mask)

    @dataclass(slots=True, repr=False)
    class FuelCellCapabilitiesRec(rt.Struct):
        """FuelCellCapabilitiesRec.

        fuel_capacity: 0..256 kilogram, optional. Amount of fuel when full, in kilograms
        """

        fuel_capacity: float | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("fuelCapacity", rt.real("H", 0.0, 256.0, "kilogram"), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_ReportPowerPlantCapabilities_FuelCellCapabilitiesRec_0[mask & 0x1]
            raw = iter(packer.unpack_from(data, at + 1)).__next__
            at = at + 1 + packer.size
            self.fuel_capacity = raw() * 0.003906309605554284 if mask & 1 else None
            self.reserved_presence = mask & 0xFE
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x1: raise rt.Reject
            raw: list[int | float | bytes] = []
            fuel_capacity_ = self.fuel_capacity
            if fuel_capacity_ is not None:
                mask |= 1
                if not 0.0 <= fuel_capacity_ <= 256.0: raise rt.Reject
                near = fuel_capacity_ * 255.99609375 + 0.5
                fuel_capacity_raw_ = int(near)
                if not 1.52587890625e-05 < near - fuel_capacity_raw_ < 0.9999847412109375: fuel_capacity_raw_ = rt.exact_raw(fuel_capacity_, _R_14)
                raw.append(fuel_capacity_raw_)
            out += _M_ReportPowerPlantCapabilities_FuelCellCapabilitiesRec_0[mask & 0x1].pack(*raw)
            _S_B.pack_into(out, start, mask)

    @dataclass(slots=True, repr=False)
    class PowerPlantCapabilitiesSeq(rt.Struct):
        """PowerPlantCapabilitiesSeq.

        power_plant_desc_rec: One power plant and its description
        power_plant_capabilities_var: Limits, by kind of power plant
        """

        power_plant_desc_rec: ReportPowerPlantCapabilities.PowerPlantDescRec
        power_plant_capabilities_var: ReportPowerPlantCapabilities.GasEngineCapabilitiesRec | ReportPowerPlantCapabilities.DieselEngineCapabilitiesRec | ReportPowerPlantCapabilities.BatteryCapabilitiesList | ReportPowerPlantCapabilities.HydraulicCapabilitiesRec | ReportPowerPlantCapabilities.FuelCellCapabilitiesRec

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("PowerPlantDescRec", ReportPowerPlantCapabilities.PowerPlantDescRec.layout()),
                ("powerPlantCapabilitiesVar", rt.Union.of("B", gas_engine_capabilities_rec=ReportPowerPlantCapabilities.GasEngineCapabilitiesRec, diesel_engine_capabilities_rec=ReportPowerPlantCapabilities.DieselEngineCapabilitiesRec, battery_capabilities_list=ReportPowerPlantCapabilities.BatteryCapabilitiesList, hydraulic_capabilities_rec=ReportPowerPlantCapabilities.HydraulicCapabilitiesRec, fuel_cell_capabilities_rec=ReportPowerPlantCapabilities.FuelCellCapabilitiesRec)),
            )

    power_plant_capabilities_list: list[ReportPowerPlantCapabilities.PowerPlantCapabilitiesSeq]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("powerPlantCapabilitiesList", rt.Repeat(rt.Count("B", 0, 255), ReportPowerPlantCapabilities.PowerPlantCapabilitiesSeq.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x07 or data[1] != 0x45: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        power_plant_capabilities_list_count_ = data[2]
        if power_plant_capabilities_list_count_ * 4 > size - 3: raise rt.Reject
        at = 3
        power_plant_capabilities_list_ = []
        for _ in range(power_plant_capabilities_list_count_):
            item_ = rt.new(ReportPowerPlantCapabilities.PowerPlantCapabilitiesSeq)
            item_.power_plant_desc_rec = power_plant_desc_rec_ = rt.new(ReportPowerPlantCapabilities.PowerPlantDescRec)
            power_plant_desc_rec_.power_plant_id = data[at]
            description_end_ = at + 2 + data[at + 1]
            power_plant_desc_rec_.description = data[at + 2:description_end_].decode("latin-1")
            tag = data[description_end_]
            at = description_end_ + 1
            item_.power_plant_capabilities_var, at = _U_25[tag]._read(data, at, nesting)
            power_plant_capabilities_list_.append(item_)
        self.power_plant_capabilities_list = power_plant_capabilities_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x07\x45")
        power_plant_capabilities_list_ = self.power_plant_capabilities_list
        if type(power_plant_capabilities_list_) is not list: raise rt.Reject
        out.append(len(power_plant_capabilities_list_))
        for item_ in power_plant_capabilities_list_:
            if type(item_) is not ReportPowerPlantCapabilities.PowerPlantCapabilitiesSeq: raise rt.Reject
            power_plant_desc_rec_ = item_.power_plant_desc_rec
            if type(power_plant_desc_rec_) is not ReportPowerPlantCapabilities.PowerPlantDescRec: raise rt.Reject
            out.append(power_plant_desc_rec_.power_plant_id)
            description_raw_ = power_plant_desc_rec_.description.encode("latin-1")
            out.append(len(description_raw_))
            out += description_raw_
            power_plant_capabilities_var_ = item_.power_plant_capabilities_var
            out.append(_T_26[type(power_plant_capabilities_var_)])
            power_plant_capabilities_var_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportPowerPlantStatus(rt.Message):
    """ReportPowerPlantStatus (0x4508): Tells the state of power plants.

    power_plant_status_list: 0..255 items. The power plants
    """

    CODE = 0x4508
    NAME = "ReportPowerPlantStatus"
    SERVICE = "urn:jaus:jss:ugv:PowerPlantManager"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    @dataclass(slots=True, repr=False)
    class PowerPlantDescRec(rt.Struct):
        """One power plant and its description.

        power_plant_id: Identifies the power plant
        description: up to 255 characters. Description, for people
        """

        power_plant_id: int
        description: str

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("powerPlantID", rt.Number("B")),
                ("description", rt.Text(count=rt.Count("B", 0, 255))),
            )

    @dataclass(slots=True, repr=False)
    class GasEngineStatus(rt.Struct):
        """GasEngineStatus.

        percent_remaining_fuel: 0..100, optional. Amount of fuel, in percent of full
        percent_oil_pressure: 0..200, optional. Pressure of the oil, in percent of the usual
        percent_oil_level: 0..100, optional. Amount of oil, in percent of full
        oil_temp: -75..180 degree Celsius, optional. Temperature of the oil, in degrees Celsius
        engine_temp: -75..180 degree Celsius, optional. Temperature of the engine, in degrees Celsius
        engine_hours: in hour, optional. Hours that the engine has worked
        tachometer: optional. Revolutions per minute
        coolant_level: 0..256 liter, optional. Amount of coolant, in litres
        coolant_temp: -75..180 degree Celsius, optional. Temperature of the coolant, in degrees Celsius
        air_intake_pressure: 0..512 bar, optional. Pressure of the intake air, in bar
        air_intake_temp: -75..180 degree Celsius, optional. Temperature of the intake air, in degrees Celsius
        exhaust_temp: -75..180 degree Celsius, optional. Temperature of the exhaust, in degrees Celsius
        """

        percent_remaining_fuel: float | None = None
        percent_oil_pressure: float | None = None
        percent_oil_level: float | None = None
        oil_temp: float | None = None
        engine_temp: float | None = None
        engine_hours: int | None = None
        tachometer: int | None = None
        coolant_level: float | None = None
        coolant_temp: float | None = None
        air_intake_pressure: float | None = None
        air_intake_temp: float | None = None
        exhaust_temp: float | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "H",
                ("percentRemainingFuel", rt.real("H", 0.0, 100.0), True),
                ("percentOilPressure", rt.real("H", 0.0, 200.0), True),
                ("percentOilLevel", rt.real("H", 0.0, 100.0), True),
                ("oilTemp", rt.real("H", -75.0, 180.0, "degree Celsius"), True),
                ("engineTemp", rt.real("H", -75.0, 180.0, "degree Celsius"), True),
                ("engineHours", rt.Number("I", rt.ANY, "hour"), True),
                ("tachometer", rt.Number("H"), True),
                ("coolantLevel", rt.real("H", 0.0, 256.0, "liter"), True),
                ("coolantTemp", rt.real("H", -75.0, 180.0, "degree Celsius"), True),
                ("airIntakePressure", rt.real("H", 0.0, 512.0, "bar"), True),
                ("airIntakeTemp", rt.real("H", -75.0, 180.0, "degree Celsius"), True),
                ("exhaustTemp", rt.real("H", -75.0, 180.0, "degree Celsius"), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            (mask,) = _S_H.unpack_from(data, at)
            packer = _M_ReportPowerPlantStatus_GasEngineStatus_0[mask & 0xFFF]
            raw = iter(packer.unpack_from(data, at + 2)).__next__
            at = at + 2 + packer.size
            self.percent_remaining_fuel = raw() * 0.0015259021896696422 if mask & 1 else None
            self.percent_oil_pressure = raw() * 0.0030518043793392844 if mask & 2 else None
            self.percent_oil_level = raw() * 0.0015259021896696422 if mask & 4 else None
            self.oil_temp = -75.0 + raw() * 0.0038910505836575876 if mask & 8 else None
            self.engine_temp = -75.0 + raw() * 0.0038910505836575876 if mask & 16 else None
            self.engine_hours = raw() if mask & 32 else None
            self.tachometer = raw() if mask & 64 else None
            self.coolant_level = raw() * 0.003906309605554284 if mask & 128 else None
            self.coolant_temp = -75.0 + raw() * 0.0038910505836575876 if mask & 256 else None
            self.air_intake_pressure = raw() * 0.007812619211108568 if mask & 512 else None
            self.air_intake_temp = -75.0 + raw() * 0.0038910505836575876 if mask & 1024 else None
            self.exhaust_temp = -75.0 + raw() * 0.0038910505836575876 if mask & 2048 else None
            self.reserved_presence = mask & 0xF000
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0\0"
            mask = self.reserved_presence
            if mask & 0xFFF: raise rt.Reject
            raw: list[int | float | bytes] = []
            percent_remaining_fuel_ = self.percent_remaining_fuel
            if percent_remaining_fuel_ is not None:
                mask |= 1
                if not 0.0 <= percent_remaining_fuel_ <= 100.0: raise rt.Reject
                near = percent_remaining_fuel_ * 655.35 + 0.5
                percent_remaining_fuel_raw_ = int(near)
                if not 1.52587890625e-05 < near - percent_remaining_fuel_raw_ < 0.9999847412109375: percent_remaining_fuel_raw_ = rt.exact_raw(percent_remaining_fuel_, _R_2)
                raw.append(percent_remaining_fuel_raw_)
            percent_oil_pressure_ = self.percent_oil_pressure
            if percent_oil_pressure_ is not None:
                mask |= 2
                if not 0.0 <= percent_oil_pressure_ <= 200.0: raise rt.Reject
                near = percent_oil_pressure_ * 327.675 + 0.5
                percent_oil_pressure_raw_ = int(near)
                if not 1.52587890625e-05 < near - percent_oil_pressure_raw_ < 0.9999847412109375: percent_oil_pressure_raw_ = rt.exact_raw(percent_oil_pressure_, _R_28)
                raw.append(percent_oil_pressure_raw_)
            percent_oil_level_ = self.percent_oil_level
            if percent_oil_level_ is not None:
                mask |= 4
                if not 0.0 <= percent_oil_level_ <= 100.0: raise rt.Reject
                near = percent_oil_level_ * 655.35 + 0.5
                percent_oil_level_raw_ = int(near)
                if not 1.52587890625e-05 < near - percent_oil_level_raw_ < 0.9999847412109375: percent_oil_level_raw_ = rt.exact_raw(percent_oil_level_, _R_2)
                raw.append(percent_oil_level_raw_)
            oil_temp_ = self.oil_temp
            if oil_temp_ is not None:
                mask |= 8
                if not -75.0 <= oil_temp_ <= 180.0: raise rt.Reject
                near = oil_temp_ * 257.0 + 19275.5
                oil_temp_raw_ = int(near)
                if not 1.52587890625e-05 < near - oil_temp_raw_ < 0.9999847412109375: oil_temp_raw_ = rt.exact_raw(oil_temp_, _R_16)
                raw.append(oil_temp_raw_)
            engine_temp_ = self.engine_temp
            if engine_temp_ is not None:
                mask |= 16
                if not -75.0 <= engine_temp_ <= 180.0: raise rt.Reject
                near = engine_temp_ * 257.0 + 19275.5
                engine_temp_raw_ = int(near)
                if not 1.52587890625e-05 < near - engine_temp_raw_ < 0.9999847412109375: engine_temp_raw_ = rt.exact_raw(engine_temp_, _R_16)
                raw.append(engine_temp_raw_)
            engine_hours_ = self.engine_hours
            if engine_hours_ is not None:
                mask |= 32
                raw.append(engine_hours_)
            tachometer_ = self.tachometer
            if tachometer_ is not None:
                mask |= 64
                raw.append(tachometer_)
            coolant_level_ = self.coolant_level
            if coolant_level_ is not None:
                mask |= 128
                if not 0.0 <= coolant_level_ <= 256.0: raise rt.Reject
                near = coolant_level_ * 255.99609375 + 0.5
                coolant_level_raw_ = int(near)
                if not 1.52587890625e-05 < near - coolant_level_raw_ < 0.9999847412109375: coolant_level_raw_ = rt.exact_raw(coolant_level_, _R_14)
                raw.append(coolant_level_raw_)
            coolant_temp_ = self.coolant_temp
            if coolant_temp_ is not None:
                mask |= 256
                if not -75.0 <= coolant_temp_ <= 180.0: raise rt.Reject
                near = coolant_temp_ * 257.0 + 19275.5
                coolant_temp_raw_ = int(near)
                if not 1.52587890625e-05 < near - coolant_temp_raw_ < 0.9999847412109375: coolant_temp_raw_ = rt.exact_raw(coolant_temp_, _R_16)
                raw.append(coolant_temp_raw_)
            air_intake_pressure_ = self.air_intake_pressure
            if air_intake_pressure_ is not None:
                mask |= 512
                if not 0.0 <= air_intake_pressure_ <= 512.0: raise rt.Reject
                near = air_intake_pressure_ * 127.998046875 + 0.5
                air_intake_pressure_raw_ = int(near)
                if not 1.52587890625e-05 < near - air_intake_pressure_raw_ < 0.9999847412109375: air_intake_pressure_raw_ = rt.exact_raw(air_intake_pressure_, _R_15)
                raw.append(air_intake_pressure_raw_)
            air_intake_temp_ = self.air_intake_temp
            if air_intake_temp_ is not None:
                mask |= 1024
                if not -75.0 <= air_intake_temp_ <= 180.0: raise rt.Reject
                near = air_intake_temp_ * 257.0 + 19275.5
                air_intake_temp_raw_ = int(near)
                if not 1.52587890625e-05 < near - air_intake_temp_raw_ < 0.9999847412109375: air_intake_temp_raw_ = rt.exact_raw(air_intake_temp_, _R_16)
                raw.append(air_intake_temp_raw_)
            exhaust_temp_ = self.exhaust_temp
            if exhaust_temp_ is not None:
                mask |= 2048
                if not -75.0 <= exhaust_temp_ <= 180.0: raise rt.Reject
                near = exhaust_temp_ * 257.0 + 19275.5
                exhaust_temp_raw_ = int(near)
                if not 1.52587890625e-05 < near - exhaust_temp_raw_ < 0.9999847412109375: exhaust_temp_raw_ = rt.exact_raw(exhaust_temp_, _R_16)
                raw.append(exhaust_temp_raw_)
            out += _M_ReportPowerPlantStatus_GasEngineStatus_0[mask & 0xFFF].pack(*raw)
            _S_H.pack_into(out, start, mask)

    @dataclass(slots=True, repr=False)
    class DieselEngineStatus(rt.Struct):
        """DieselEngineStatus.

        percent_remaining_fuel: 0..100, optional. Amount of fuel, in percent of full
        percent_oil_pressure: 0..200, optional. Pressure of the oil, in percent of the usual
        percent_oil_level: 0..100, optional. Amount of oil, in percent of full
        oil_temp: -75..180 degree Celsius, optional. Temperature of the oil, in degrees Celsius
        engine_temp: -75..180 degree Celsius, optional. Temperature of the engine, in degrees Celsius
        engine_hours: in hour, optional. Hours that the engine has worked
        tachometer: optional. Revolutions per minute
        coolant_level: 0..256 liter, optional. Amount of coolant, in litres
        coolant_temp: -75..180 degree Celsius, optional. Temperature of the coolant, in degrees Celsius
        air_intake_pressure: 0..512 bar, optional. Pressure of the intake air, in bar
        air_intake_temp: -75..180 degree Celsius, optional. Temperature of the intake air, in degrees Celsius
        exhaust_temp: -75..180 degree Celsius, optional. Temperature of the exhaust, in degrees Celsius
        glow_plug_temp: -75..180 degree Celsius, optional. Temperature of the glow plugs, in degrees Celsius
        """

        percent_remaining_fuel: float | None = None
        percent_oil_pressure: float | None = None
        percent_oil_level: float | None = None
        oil_temp: float | None = None
        engine_temp: float | None = None
        engine_hours: int | None = None
        tachometer: int | None = None
        coolant_level: float | None = None
        coolant_temp: float | None = None
        air_intake_pressure: float | None = None
        air_intake_temp: float | None = None
        exhaust_temp: float | None = None
        glow_plug_temp: float | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "H",
                ("percentRemainingFuel", rt.real("B", 0.0, 100.0), True),
                ("percentOilPressure", rt.real("B", 0.0, 200.0), True),
                ("percentOilLevel", rt.real("H", 0.0, 100.0), True),
                ("oilTemp", rt.real("H", -75.0, 180.0, "degree Celsius"), True),
                ("engineTemp", rt.real("H", -75.0, 180.0, "degree Celsius"), True),
                ("engineHours", rt.Number("I", rt.ANY, "hour"), True),
                ("tachometer", rt.Number("H"), True),
                ("coolantLevel", rt.real("H", 0.0, 256.0, "liter"), True),
                ("coolantTemp", rt.real("H", -75.0, 180.0, "degree Celsius"), True),
                ("airIntakePressure", rt.real("H", 0.0, 512.0, "bar"), True),
                ("airIntakeTemp", rt.real("H", -75.0, 180.0, "degree Celsius"), True),
                ("exhaustTemp", rt.real("H", -75.0, 180.0, "degree Celsius"), True),
                ("glowPlugTemp", rt.real("H", -75.0, 180.0, "degree Celsius"), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            (mask,) = _S_H.unpack_from(data, at)
            packer = _M_ReportPowerPlantStatus_DieselEngineStatus_0[mask & 0x1FFF]
            raw = iter(packer.unpack_from(data, at + 2)).__next__
            at = at + 2 + packer.size
            self.percent_remaining_fuel = raw() * 0.39215686274509803 if mask & 1 else None
            self.percent_oil_pressure = raw() * 0.7843137254901961 if mask & 2 else None
            self.percent_oil_level = raw() * 0.0015259021896696422 if mask & 4 else None
            self.oil_temp = -75.0 + raw() * 0.0038910505836575876 if mask & 8 else None
            self.engine_temp = -75.0 + raw() * 0.0038910505836575876 if mask & 16 else None
            self.engine_hours = raw() if mask & 32 else None
            self.tachometer = raw() if mask & 64 else None
            self.coolant_level = raw() * 0.003906309605554284 if mask & 128 else None
            self.coolant_temp = -75.0 + raw() * 0.0038910505836575876 if mask & 256 else None
            self.air_intake_pressure = raw() * 0.007812619211108568 if mask & 512 else None
            self.air_intake_temp = -75.0 + raw() * 0.0038910505836575876 if mask & 1024 else None
            self.exhaust_temp = -75.0 + raw() * 0.0038910505836575876 if mask & 2048 else None
            self.glow_plug_temp = -75.0 + raw() * 0.0038910505836575876 if mask & 4096 else None
            self.reserved_presence = mask & 0xE000
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0\0"
            mask = self.reserved_presence
            if mask & 0x1FFF: raise rt.Reject
            raw: list[int | float | bytes] = []
            percent_remaining_fuel_ = self.percent_remaining_fuel
            if percent_remaining_fuel_ is not None:
                mask |= 1
                if not 0.0 <= percent_remaining_fuel_ <= 100.0: raise rt.Reject
                near = percent_remaining_fuel_ * 2.55 + 0.5
                percent_remaining_fuel_raw_ = int(near)
                if not 1.52587890625e-05 < near - percent_remaining_fuel_raw_ < 0.9999847412109375: percent_remaining_fuel_raw_ = rt.exact_raw(percent_remaining_fuel_, _R_30)
                raw.append(percent_remaining_fuel_raw_)
            percent_oil_pressure_ = self.percent_oil_pressure
            if percent_oil_pressure_ is not None:
                mask |= 2
                if not 0.0 <= percent_oil_pressure_ <= 200.0: raise rt.Reject
                near = percent_oil_pressure_ * 1.275 + 0.5
                percent_oil_pressure_raw_ = int(near)
                if not 1.52587890625e-05 < near - percent_oil_pressure_raw_ < 0.9999847412109375: percent_oil_pressure_raw_ = rt.exact_raw(percent_oil_pressure_, _R_31)
                raw.append(percent_oil_pressure_raw_)
            percent_oil_level_ = self.percent_oil_level
            if percent_oil_level_ is not None:
                mask |= 4
                if not 0.0 <= percent_oil_level_ <= 100.0: raise rt.Reject
                near = percent_oil_level_ * 655.35 + 0.5
                percent_oil_level_raw_ = int(near)
                if not 1.52587890625e-05 < near - percent_oil_level_raw_ < 0.9999847412109375: percent_oil_level_raw_ = rt.exact_raw(percent_oil_level_, _R_2)
                raw.append(percent_oil_level_raw_)
            oil_temp_ = self.oil_temp
            if oil_temp_ is not None:
                mask |= 8
                if not -75.0 <= oil_temp_ <= 180.0: raise rt.Reject
                near = oil_temp_ * 257.0 + 19275.5
                oil_temp_raw_ = int(near)
                if not 1.52587890625e-05 < near - oil_temp_raw_ < 0.9999847412109375: oil_temp_raw_ = rt.exact_raw(oil_temp_, _R_16)
                raw.append(oil_temp_raw_)
            engine_temp_ = self.engine_temp
            if engine_temp_ is not None:
                mask |= 16
                if not -75.0 <= engine_temp_ <= 180.0: raise rt.Reject
                near = engine_temp_ * 257.0 + 19275.5
                engine_temp_raw_ = int(near)
                if not 1.52587890625e-05 < near - engine_temp_raw_ < 0.9999847412109375: engine_temp_raw_ = rt.exact_raw(engine_temp_, _R_16)
                raw.append(engine_temp_raw_)
            engine_hours_ = self.engine_hours
            if engine_hours_ is not None:
                mask |= 32
                raw.append(engine_hours_)
            tachometer_ = self.tachometer
            if tachometer_ is not None:
                mask |= 64
                raw.append(tachometer_)
            coolant_level_ = self.coolant_level
            if coolant_level_ is not None:
                mask |= 128
                if not 0.0 <= coolant_level_ <= 256.0: raise rt.Reject
                near = coolant_level_ * 255.99609375 + 0.5
                coolant_level_raw_ = int(near)
                if not 1.52587890625e-05 < near - coolant_level_raw_ < 0.9999847412109375: coolant_level_raw_ = rt.exact_raw(coolant_level_, _R_14)
                raw.append(coolant_level_raw_)
            coolant_temp_ = self.coolant_temp
            if coolant_temp_ is not None:
                mask |= 256
                if not -75.0 <= coolant_temp_ <= 180.0: raise rt.Reject
                near = coolant_temp_ * 257.0 + 19275.5
                coolant_temp_raw_ = int(near)
                if not 1.52587890625e-05 < near - coolant_temp_raw_ < 0.9999847412109375: coolant_temp_raw_ = rt.exact_raw(coolant_temp_, _R_16)
                raw.append(coolant_temp_raw_)
            air_intake_pressure_ = self.air_intake_pressure
            if air_intake_pressure_ is not None:
                mask |= 512
                if not 0.0 <= air_intake_pressure_ <= 512.0: raise rt.Reject
                near = air_intake_pressure_ * 127.998046875 + 0.5
                air_intake_pressure_raw_ = int(near)
                if not 1.52587890625e-05 < near - air_intake_pressure_raw_ < 0.9999847412109375: air_intake_pressure_raw_ = rt.exact_raw(air_intake_pressure_, _R_15)
                raw.append(air_intake_pressure_raw_)
            air_intake_temp_ = self.air_intake_temp
            if air_intake_temp_ is not None:
                mask |= 1024
                if not -75.0 <= air_intake_temp_ <= 180.0: raise rt.Reject
                near = air_intake_temp_ * 257.0 + 19275.5
                air_intake_temp_raw_ = int(near)
                if not 1.52587890625e-05 < near - air_intake_temp_raw_ < 0.9999847412109375: air_intake_temp_raw_ = rt.exact_raw(air_intake_temp_, _R_16)
                raw.append(air_intake_temp_raw_)
            exhaust_temp_ = self.exhaust_temp
            if exhaust_temp_ is not None:
                mask |= 2048
                if not -75.0 <= exhaust_temp_ <= 180.0: raise rt.Reject
                near = exhaust_temp_ * 257.0 + 19275.5
                exhaust_temp_raw_ = int(near)
                if not 1.52587890625e-05 < near - exhaust_temp_raw_ < 0.9999847412109375: exhaust_temp_raw_ = rt.exact_raw(exhaust_temp_, _R_16)
                raw.append(exhaust_temp_raw_)
            glow_plug_temp_ = self.glow_plug_temp
            if glow_plug_temp_ is not None:
                mask |= 4096
                if not -75.0 <= glow_plug_temp_ <= 180.0: raise rt.Reject
                near = glow_plug_temp_ * 257.0 + 19275.5
                glow_plug_temp_raw_ = int(near)
                if not 1.52587890625e-05 < near - glow_plug_temp_raw_ < 0.9999847412109375: glow_plug_temp_raw_ = rt.exact_raw(glow_plug_temp_, _R_16)
                raw.append(glow_plug_temp_raw_)
            out += _M_ReportPowerPlantStatus_DieselEngineStatus_0[mask & 0x1FFF].pack(*raw)
            _S_H.pack_into(out, start, mask)

    @dataclass(slots=True, repr=False)
    class BatteryStatusRec(rt.Struct):
        """BatteryStatusRec.

        percent_charge_remaining: 0..100, optional. Charge, in percent of full
        voltage: 0..1000 volt, optional. Voltage, in volts
        current_draw: 0..1000 ampere, optional. Current taken from the battery, in amperes
        battery_temp: -75..180 degree Celsius, optional. Temperature of the battery, in degrees Celsius
        battery_hours: in hour, optional. Hours that the battery has worked
        """

        percent_charge_remaining: float | None = None
        voltage: float | None = None
        current_draw: float | None = None
        battery_temp: float | None = None
        battery_hours: int | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("percentChargeRemaining", rt.real("H", 0.0, 100.0), True),
                ("voltage", rt.real("H", 0.0, 1000.0, "volt"), True),
                ("currentDraw", rt.real("H", 0.0, 1000.0, "ampere"), True),
                ("batteryTemp", rt.real("H", -75.0, 180.0, "degree Celsius"), True),
                ("batteryHours", rt.Number("I", rt.ANY, "hour"), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_ReportPowerPlantStatus_BatteryStatusRec_0[mask & 0x1F]
            raw = iter(packer.unpack_from(data, at + 1)).__next__
            at = at + 1 + packer.size
            self.percent_charge_remaining = raw() * 0.0015259021896696422 if mask & 1 else None
            self.voltage = raw() * 0.015259021896696421 if mask & 2 else None
            self.current_draw = raw() * 0.015259021896696421 if mask & 4 else None
            self.battery_temp = -75.0 + raw() * 0.0038910505836575876 if mask & 8 else None
            self.battery_hours = raw() if mask & 16 else None
            self.reserved_presence = mask & 0xE0
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x1F: raise rt.Reject
            raw: list[int | float | bytes] = []
            percent_charge_remaining_ = self.percent_charge_remaining
            if percent_charge_remaining_ is not None:
                mask |= 1
                if not 0.0 <= percent_charge_remaining_ <= 100.0: raise rt.Reject
                near = percent_charge_remaining_ * 655.35 + 0.5
                percent_charge_remaining_raw_ = int(near)
                if not 1.52587890625e-05 < near - percent_charge_remaining_raw_ < 0.9999847412109375: percent_charge_remaining_raw_ = rt.exact_raw(percent_charge_remaining_, _R_2)
                raw.append(percent_charge_remaining_raw_)
            voltage_ = self.voltage
            if voltage_ is not None:
                mask |= 2
                if not 0.0 <= voltage_ <= 1000.0: raise rt.Reject
                near = voltage_ * 65.535 + 0.5
                voltage_raw_ = int(near)
                if not 1.52587890625e-05 < near - voltage_raw_ < 0.9999847412109375: voltage_raw_ = rt.exact_raw(voltage_, _R_20)
                raw.append(voltage_raw_)
            current_draw_ = self.current_draw
            if current_draw_ is not None:
                mask |= 4
                if not 0.0 <= current_draw_ <= 1000.0: raise rt.Reject
                near = current_draw_ * 65.535 + 0.5
                current_draw_raw_ = int(near)
                if not 1.52587890625e-05 < near - current_draw_raw_ < 0.9999847412109375: current_draw_raw_ = rt.exact_raw(current_draw_, _R_20)
                raw.append(current_draw_raw_)
            battery_temp_ = self.battery_temp
            if battery_temp_ is not None:
                mask |= 8
                if not -75.0 <= battery_temp_ <= 180.0: raise rt.Reject
                near = battery_temp_ * 257.0 + 19275.5
                battery_temp_raw_ = int(near)
                if not 1.52587890625e-05 < near - battery_temp_raw_ < 0.9999847412109375: battery_temp_raw_ = rt.exact_raw(battery_temp_, _R_16)
                raw.append(battery_temp_raw_)
            battery_hours_ = self.battery_hours
            if battery_hours_ is not None:
                mask |= 16
                raw.append(battery_hours_)
            out += _M_ReportPowerPlantStatus_BatteryStatusRec_0[mask & 0x1F].pack(*raw)
            _S_B.pack_into(out, start, mask)

    @dataclass(slots=True, repr=False)
    class BatteryStatus(rt.Struct):
        """The batteries.

        battery_status: 0..255 items. The batteries
        """

        battery_status: list[ReportPowerPlantStatus.BatteryStatusRec]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("batteryStatus", rt.Repeat(rt.Count("B", 0, 255), ReportPowerPlantStatus.BatteryStatusRec.layout())),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            size = len(data)
            self = rt.new(cls)
            battery_status_count_ = data[at]
            if battery_status_count_ * 1 > size - (at + 1): raise rt.Reject
            at += 1
            battery_status_ = []
            for _ in range(battery_status_count_):
                item_, at = ReportPowerPlantStatus.BatteryStatusRec._read(data, at, nesting)
                battery_status_.append(item_)
            self.battery_status = battery_status_
            return self, at

        def _write(self, out: bytearray) -> None:
            battery_status_ = self.battery_status
            if type(battery_status_) is not list: raise rt.Reject
            out.append(len(battery_status_))
            for item_ in battery_status_:
                if type(item_) is not ReportPowerPlantStatus.BatteryStatusRec: raise rt.Reject
                item_._write(out)

    @dataclass(slots=True, repr=False)
    class HydraulicStatus(rt.Struct):
        """HydraulicStatus.

        fluid_level: 0..256 liter, optional. Amount of fluid, in litres
        percent_fluid_pressure: 0..200, optional. Pressure of the fluid, in percent of the usual
        fluid_temp: -75..180 degree Celsius, optional. Temperature of the fluid, in degrees Celsius
        total_hours: in hour, optional. Hours that it has worked
        """

        fluid_level: float | None = None
        percent_fluid_pressure: float | None = None
        fluid_temp: float | None = None
        total_hours: int | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("fluidLevel", rt.real("H", 0.0, 256.0, "liter"), True),
                ("percentFluidPressure", rt.real("H", 0.0, 200.0), True),
                ("fluidTemp", rt.real("H", -75.0, 180.0, "degree Celsius"), True),
                ("totalHours", rt.Number("I", rt.ANY, "hour"), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_ReportPowerPlantStatus_HydraulicStatus_0[mask & 0xF]
            raw = iter(packer.unpack_from(data, at + 1)).__next__
            at = at + 1 + packer.size
            self.fluid_level = raw() * 0.003906309605554284 if mask & 1 else None
            self.percent_fluid_pressure = raw() * 0.0030518043793392844 if mask & 2 else None
            self.fluid_temp = -75.0 + raw() * 0.0038910505836575876 if mask & 4 else None
            self.total_hours = raw() if mask & 8 else None
            self.reserved_presence = mask & 0xF0
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0xF: raise rt.Reject
            raw: list[int | float | bytes] = []
            fluid_level_ = self.fluid_level
            if fluid_level_ is not None:
                mask |= 1
                if not 0.0 <= fluid_level_ <= 256.0: raise rt.Reject
                near = fluid_level_ * 255.99609375 + 0.5
                fluid_level_raw_ = int(near)
                if not 1.52587890625e-05 < near - fluid_level_raw_ < 0.9999847412109375: fluid_level_raw_ = rt.exact_raw(fluid_level_, _R_14)
                raw.append(fluid_level_raw_)
            percent_fluid_pressure_ = self.percent_fluid_pressure
            if percent_fluid_pressure_ is not None:
                mask |= 2
                if not 0.0 <= percent_fluid_pressure_ <= 200.0: raise rt.Reject
                near = percent_fluid_pressure_ * 327.675 + 0.5
                percent_fluid_pressure_raw_ = int(near)
                if not 1.52587890625e-05 < near - percent_fluid_pressure_raw_ < 0.9999847412109375: percent_fluid_pressure_raw_ = rt.exact_raw(percent_fluid_pressure_, _R_28)
                raw.append(percent_fluid_pressure_raw_)
            fluid_temp_ = self.fluid_temp
            if fluid_temp_ is not None:
                mask |= 4
                if not -75.0 <= fluid_temp_ <= 180.0: raise rt.Reject
                near = fluid_temp_ * 257.0 + 19275.5
                fluid_temp_raw_ = int(near)
                if not 1.52587890625e-05 < near - fluid_temp_raw_ < 0.9999847412109375: fluid_temp_raw_ = rt.exact_raw(fluid_temp_, _R_16)
                raw.append(fluid_temp_raw_)
            total_hours_ = self.total_hours
            if total_hours_ is not None:
                mask |= 8
                raw.append(total_hours_)
            out += _M_ReportPowerPlantStatus_HydraulicStatus_0[mask & 0xF].pack(*raw)
            _S_B.pack_into(out, start, mask)

    @dataclass(slots=True, repr=False)
    class FuelCellStatus(rt.Struct):
        """FuelCellStatus.

        percent_remaining_fuel: 0..100, optional. Amount of fuel, in percent of full
        total_hours: in hour, optional. Hours that it has worked
        """

        percent_remaining_fuel: float | None = None
        total_hours: int | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("percentRemainingFuel", rt.real("H", 0.0, 100.0), True),
                ("totalHours", rt.Number("I", rt.ANY, "hour"), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_ReportPowerPlantStatus_FuelCellStatus_0[mask & 0x3]
            raw = iter(packer.unpack_from(data, at + 1)).__next__
            at = at + 1 + packer.size
            self.percent_remaining_fuel = raw() * 0.0015259021896696422 if mask & 1 else None
            self.total_hours = raw() if mask & 2 else None
            self.reserved_presence = mask & 0xFC
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x3: raise rt.Reject
            raw: list[int | float | bytes] = []
            percent_remaining_fuel_ = self.percent_remaining_fuel
            if percent_remaining_fuel_ is not None:
                mask |= 1
                if not 0.0 <= percent_remaining_fuel_ <= 100.0: raise rt.Reject
                near = percent_remaining_fuel_ * 655.35 + 0.5
                percent_remaining_fuel_raw_ = int(near)
                if not 1.52587890625e-05 < near - percent_remaining_fuel_raw_ < 0.9999847412109375: percent_remaining_fuel_raw_ = rt.exact_raw(percent_remaining_fuel_, _R_2)
                raw.append(percent_remaining_fuel_raw_)
            total_hours_ = self.total_hours
            if total_hours_ is not None:
                mask |= 2
                raw.append(total_hours_)
            out += _M_ReportPowerPlantStatus_FuelCellStatus_0[mask & 0x3].pack(*raw)
            _S_B.pack_into(out, start, mask)

    @dataclass(slots=True, repr=False)
    class PowerPlantStatus(rt.Struct):
        """PowerPlantStatus.

        power_plant_desc_rec: One power plant and its description
        power_plant_status_var: State, by kind of power plant
        """

        power_plant_desc_rec: ReportPowerPlantStatus.PowerPlantDescRec
        power_plant_status_var: ReportPowerPlantStatus.GasEngineStatus | ReportPowerPlantStatus.DieselEngineStatus | ReportPowerPlantStatus.BatteryStatus | ReportPowerPlantStatus.HydraulicStatus | ReportPowerPlantStatus.FuelCellStatus

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("PowerPlantDescRec", ReportPowerPlantStatus.PowerPlantDescRec.layout()),
                ("powerPlantStatusVar", rt.Union.of("B", gas_engine_status=ReportPowerPlantStatus.GasEngineStatus, diesel_engine_status=ReportPowerPlantStatus.DieselEngineStatus, battery_status=ReportPowerPlantStatus.BatteryStatus, hydraulic_status=ReportPowerPlantStatus.HydraulicStatus, fuel_cell_status=ReportPowerPlantStatus.FuelCellStatus)),
            )

    power_plant_status_list: list[ReportPowerPlantStatus.PowerPlantStatus]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("powerPlantStatusList", rt.Repeat(rt.Count("B", 0, 255), ReportPowerPlantStatus.PowerPlantStatus.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x08 or data[1] != 0x45: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        power_plant_status_list_count_ = data[2]
        if power_plant_status_list_count_ * 4 > size - 3: raise rt.Reject
        at = 3
        power_plant_status_list_ = []
        for _ in range(power_plant_status_list_count_):
            item_ = rt.new(ReportPowerPlantStatus.PowerPlantStatus)
            item_.power_plant_desc_rec = power_plant_desc_rec_ = rt.new(ReportPowerPlantStatus.PowerPlantDescRec)
            power_plant_desc_rec_.power_plant_id = data[at]
            description_end_ = at + 2 + data[at + 1]
            power_plant_desc_rec_.description = data[at + 2:description_end_].decode("latin-1")
            tag = data[description_end_]
            at = description_end_ + 1
            item_.power_plant_status_var, at = _U_35[tag]._read(data, at, nesting)
            power_plant_status_list_.append(item_)
        self.power_plant_status_list = power_plant_status_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x08\x45")
        power_plant_status_list_ = self.power_plant_status_list
        if type(power_plant_status_list_) is not list: raise rt.Reject
        out.append(len(power_plant_status_list_))
        for item_ in power_plant_status_list_:
            if type(item_) is not ReportPowerPlantStatus.PowerPlantStatus: raise rt.Reject
            power_plant_desc_rec_ = item_.power_plant_desc_rec
            if type(power_plant_desc_rec_) is not ReportPowerPlantStatus.PowerPlantDescRec: raise rt.Reject
            out.append(power_plant_desc_rec_.power_plant_id)
            description_raw_ = power_plant_desc_rec_.description.encode("latin-1")
            out.append(len(description_raw_))
            out += description_raw_
            power_plant_status_var_ = item_.power_plant_status_var
            out.append(_T_36[type(power_plant_status_var_)])
            power_plant_status_var_._write(out)
        return bytes(out)


_M_SetPowerPlantConfiguration_GasEngineConfigurationRec_0 = rt.Masks("", ((0, "B"), (1, "H"), (2, "H")))
_E_SetPowerPlantConfiguration_PowerState = rt.members(SetPowerPlantConfiguration.PowerState)
_R_2 = rt.Scaling(0.0, 100.0, 65535)
_S_B = rt.Packer("<B")
_M_SetPowerPlantConfiguration_DieselEngineConfigurationRec_0 = rt.Masks("", ((0, "B"), (1, "H"), (2, "H"), (4, "B")))
_E_SetPowerPlantConfiguration_PlugState = rt.members(SetPowerPlantConfiguration.PlugState)
_U_6: tuple[type[SetPowerPlantConfiguration.GasEngineConfigurationRec] | type[SetPowerPlantConfiguration.DieselEngineConfigurationRec] | type[SetPowerPlantConfiguration.BatteryConfigurationRec] | type[SetPowerPlantConfiguration.HydraulicConfigurationRec] | type[SetPowerPlantConfiguration.FuelCellConfigurationRecs], ...] = (SetPowerPlantConfiguration.GasEngineConfigurationRec, SetPowerPlantConfiguration.DieselEngineConfigurationRec, SetPowerPlantConfiguration.BatteryConfigurationRec, SetPowerPlantConfiguration.HydraulicConfigurationRec, SetPowerPlantConfiguration.FuelCellConfigurationRecs)
_T_7: dict[type[rt.Struct], int] = {SetPowerPlantConfiguration.GasEngineConfigurationRec: 0, SetPowerPlantConfiguration.DieselEngineConfigurationRec: 1, SetPowerPlantConfiguration.BatteryConfigurationRec: 2, SetPowerPlantConfiguration.HydraulicConfigurationRec: 3, SetPowerPlantConfiguration.FuelCellConfigurationRecs: 4}
_L_B = rt.Rows("B")
_E_ReportPowerPlantConfiguration_PowerState = rt.members(ReportPowerPlantConfiguration.PowerState)
_E_ReportPowerPlantConfiguration_PlugState = rt.members(ReportPowerPlantConfiguration.PlugState)
_U_11: tuple[type[ReportPowerPlantConfiguration.GasEngineConfigurationRec] | type[ReportPowerPlantConfiguration.DieselEngineConfigurationRec] | type[ReportPowerPlantConfiguration.BatteryConfigurationRec] | type[ReportPowerPlantConfiguration.HydraulicConfigurationRec] | type[ReportPowerPlantConfiguration.FuelCellConfigurationRecs], ...] = (ReportPowerPlantConfiguration.GasEngineConfigurationRec, ReportPowerPlantConfiguration.DieselEngineConfigurationRec, ReportPowerPlantConfiguration.BatteryConfigurationRec, ReportPowerPlantConfiguration.HydraulicConfigurationRec, ReportPowerPlantConfiguration.FuelCellConfigurationRecs)
_T_12: dict[type[rt.Struct], int] = {ReportPowerPlantConfiguration.GasEngineConfigurationRec: 0, ReportPowerPlantConfiguration.DieselEngineConfigurationRec: 1, ReportPowerPlantConfiguration.BatteryConfigurationRec: 2, ReportPowerPlantConfiguration.HydraulicConfigurationRec: 3, ReportPowerPlantConfiguration.FuelCellConfigurationRecs: 4}
_M_ReportPowerPlantCapabilities_GasEngineCapabilitiesRec_0 = rt.Masks("", ((1, "H"), (2, "H"), (4, "H"), (8, "H"), (16, "H"), (32, "H"), (64, "H")))
_R_14 = rt.Scaling(0.0, 256.0, 65535)
_R_15 = rt.Scaling(0.0, 512.0, 65535)
_R_16 = rt.Scaling(-75.0, 180.0, 65535)
_S_H = rt.Packer("<H")
_M_ReportPowerPlantCapabilities_DieselEngineCapabilitiesRec_0 = rt.Masks("", ((1, "H"), (2, "H"), (4, "H"), (8, "H"), (16, "H"), (32, "H"), (64, "H"), (128, "H"), (256, "H")))
_M_ReportPowerPlantCapabilities_BatteryCapabilitiesRec_0 = rt.Masks("", ((1, "H"), (2, "I"), (4, "H")))
_R_20 = rt.Scaling(0.0, 1000.0, 65535)
_R_21 = rt.Scaling(0.0, 3600000.0, 4294967295)
_R_22 = rt.Scaling(0.0, 5000.0, 65535)
_M_ReportPowerPlantCapabilities_HydraulicCapabilitiesRec_0 = rt.Masks("", ((1, "H"), (2, "H"), (4, "H")))
_M_ReportPowerPlantCapabilities_FuelCellCapabilitiesRec_0 = rt.Masks("", ((1, "H"),))
_U_25: tuple[type[ReportPowerPlantCapabilities.GasEngineCapabilitiesRec] | type[ReportPowerPlantCapabilities.DieselEngineCapabilitiesRec] | type[ReportPowerPlantCapabilities.BatteryCapabilitiesList] | type[ReportPowerPlantCapabilities.HydraulicCapabilitiesRec] | type[ReportPowerPlantCapabilities.FuelCellCapabilitiesRec], ...] = (ReportPowerPlantCapabilities.GasEngineCapabilitiesRec, ReportPowerPlantCapabilities.DieselEngineCapabilitiesRec, ReportPowerPlantCapabilities.BatteryCapabilitiesList, ReportPowerPlantCapabilities.HydraulicCapabilitiesRec, ReportPowerPlantCapabilities.FuelCellCapabilitiesRec)
_T_26: dict[type[rt.Struct], int] = {ReportPowerPlantCapabilities.GasEngineCapabilitiesRec: 0, ReportPowerPlantCapabilities.DieselEngineCapabilitiesRec: 1, ReportPowerPlantCapabilities.BatteryCapabilitiesList: 2, ReportPowerPlantCapabilities.HydraulicCapabilitiesRec: 3, ReportPowerPlantCapabilities.FuelCellCapabilitiesRec: 4}
_M_ReportPowerPlantStatus_GasEngineStatus_0 = rt.Masks("", ((1, "H"), (2, "H"), (4, "H"), (8, "H"), (16, "H"), (32, "I"), (64, "H"), (128, "H"), (256, "H"), (512, "H"), (1024, "H"), (2048, "H")))
_R_28 = rt.Scaling(0.0, 200.0, 65535)
_M_ReportPowerPlantStatus_DieselEngineStatus_0 = rt.Masks("", ((1, "B"), (2, "B"), (4, "H"), (8, "H"), (16, "H"), (32, "I"), (64, "H"), (128, "H"), (256, "H"), (512, "H"), (1024, "H"), (2048, "H"), (4096, "H")))
_R_30 = rt.Scaling(0.0, 100.0, 255)
_R_31 = rt.Scaling(0.0, 200.0, 255)
_M_ReportPowerPlantStatus_BatteryStatusRec_0 = rt.Masks("", ((1, "H"), (2, "H"), (4, "H"), (8, "H"), (16, "I")))
_M_ReportPowerPlantStatus_HydraulicStatus_0 = rt.Masks("", ((1, "H"), (2, "H"), (4, "H"), (8, "I")))
_M_ReportPowerPlantStatus_FuelCellStatus_0 = rt.Masks("", ((1, "H"), (2, "I")))
_U_35: tuple[type[ReportPowerPlantStatus.GasEngineStatus] | type[ReportPowerPlantStatus.DieselEngineStatus] | type[ReportPowerPlantStatus.BatteryStatus] | type[ReportPowerPlantStatus.HydraulicStatus] | type[ReportPowerPlantStatus.FuelCellStatus], ...] = (ReportPowerPlantStatus.GasEngineStatus, ReportPowerPlantStatus.DieselEngineStatus, ReportPowerPlantStatus.BatteryStatus, ReportPowerPlantStatus.HydraulicStatus, ReportPowerPlantStatus.FuelCellStatus)
_T_36: dict[type[rt.Struct], int] = {ReportPowerPlantStatus.GasEngineStatus: 0, ReportPowerPlantStatus.DieselEngineStatus: 1, ReportPowerPlantStatus.BatteryStatus: 2, ReportPowerPlantStatus.HydraulicStatus: 3, ReportPowerPlantStatus.FuelCellStatus: 4}
QueryPowerPlantConfiguration.REPORT = ReportPowerPlantConfiguration
QueryPowerPlantCapabilities.REPORT = ReportPowerPlantCapabilities
QueryPowerPlantStatus.REPORT = ReportPowerPlantStatus
