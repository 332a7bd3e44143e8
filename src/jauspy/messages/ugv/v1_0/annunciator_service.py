"""urn:jaus:jss:ugv:AnnunciatorService 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt


@dataclass(slots=True, repr=False)
class SetAnnunciatorState(rt.Message):
    """SetAnnunciatorState (0x0516): Switches annunciators.

    annunciator: Which annunciators are on
    """

    CODE = 0x0516
    NAME = "SetAnnunciatorState"
    SERVICE = "urn:jaus:jss:ugv:AnnunciatorService"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    @dataclass(slots=True, repr=False)
    class Annunciator(rt.Struct):
        """Which annunciators are on.

        horn: bits 0..3. Horn.
        siren: bits 4..7. Siren.
        backup: bits 8..11. Warning when driving backward.
        variable1: bits 12..15. First annunciator that the maker chooses.
        variable2: bits 16..19. Second annunciator that the maker chooses.
        reserved: bits 20..31. Sent as 0, ignored when received.
        """

        horn: int
        siren: int
        backup: int
        variable1: int
        variable2: int
        reserved: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Bits(
                cls,
                "I",
                (
                    rt.Bit("horn", 0, 0xF, rt.Values(None, ((0, 15),))),
                    rt.Bit("siren", 4, 0xF, rt.Values(None, ((0, 15),))),
                    rt.Bit("backup", 8, 0xF, rt.Values(None, ((0, 15),))),
                    rt.Bit("variable1", 12, 0xF, rt.Values(None, ((0, 15),))),
                    rt.Bit("variable2", 16, 0xF, rt.Values(None, ((0, 15),))),
                    rt.Bit("reserved", 20, 0xFFF, rt.Values(None, ((0, 2047),))),
                ),
            )

    annunciator: SetAnnunciatorState.Annunciator

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("annunciator", SetAnnunciatorState.Annunciator.layout()),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, annunciator_ = _S_HI.unpack(data)
        if code != 0x0516: raise rt.Reject
        reserved_ = annunciator_ >> 20 & 0xFFF
        if reserved_ > 2047: raise rt.Reject
        self.annunciator = SetAnnunciatorState.Annunciator(annunciator_ & 0xF, annunciator_ >> 4 & 0xF, annunciator_ >> 8 & 0xF, annunciator_ >> 12 & 0xF, annunciator_ >> 16 & 0xF, reserved_)
        return self

    def _pack(self) -> bytes:
        annunciator_ = self.annunciator
        if type(annunciator_) is not SetAnnunciatorState.Annunciator: raise rt.Reject
        horn_ = annunciator_.horn
        if not 0 <= horn_ <= 15: raise rt.Reject
        siren_ = annunciator_.siren
        if not 0 <= siren_ <= 15: raise rt.Reject
        backup_ = annunciator_.backup
        if not 0 <= backup_ <= 15: raise rt.Reject
        variable1_ = annunciator_.variable1
        if not 0 <= variable1_ <= 15: raise rt.Reject
        variable2_ = annunciator_.variable2
        if not 0 <= variable2_ <= 15: raise rt.Reject
        reserved_ = annunciator_.reserved
        if not 0 <= reserved_ <= 2047: raise rt.Reject
        return _S_HI.pack(0x0516, horn_ | siren_ << 4 | backup_ << 8 | variable1_ << 12 | variable2_ << 16 | reserved_ << 20)


@dataclass(slots=True, repr=False)
class QueryAnnunciatorState(rt.Message):
    """QueryAnnunciatorState (0x2516): Asks which annunciators are on."""

    CODE = 0x2516
    NAME = "QueryAnnunciatorState"
    SERVICE = "urn:jaus:jss:ugv:AnnunciatorService"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportAnnunciatorState]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x16%': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2516)


@dataclass(slots=True, repr=False)
class QueryAnnunciatorConfiguration(rt.Message):
    """QueryAnnunciatorConfiguration (0x2517): Asks which annunciators there are."""

    CODE = 0x2517
    NAME = "QueryAnnunciatorConfiguration"
    SERVICE = "urn:jaus:jss:ugv:AnnunciatorService"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportAnnunciatorConfiguration]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x17%': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2517)


@dataclass(slots=True, repr=False)
class ReportAnnunciatorState(rt.Message):
    """ReportAnnunciatorState (0x4516): Tells which annunciators are on.

    annunciator: Which annunciators are on
    """

    CODE = 0x4516
    NAME = "ReportAnnunciatorState"
    SERVICE = "urn:jaus:jss:ugv:AnnunciatorService"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    @dataclass(slots=True, repr=False)
    class Annunciator(rt.Struct):
        """Which annunciators are on.

        horn: bits 0..3. Horn.
        siren: bits 4..7. Siren.
        backup: bits 8..11. Warning when driving backward.
        variable1: bits 12..15. First annunciator that the maker chooses.
        variable2: bits 16..19. Second annunciator that the maker chooses.
        reserved: bits 20..31. Sent as 0, ignored when received.
        """

        horn: int
        siren: int
        backup: int
        variable1: int
        variable2: int
        reserved: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Bits(
                cls,
                "I",
                (
                    rt.Bit("horn", 0, 0xF, rt.Values(None, ((0, 15),))),
                    rt.Bit("siren", 4, 0xF, rt.Values(None, ((0, 15),))),
                    rt.Bit("backup", 8, 0xF, rt.Values(None, ((0, 15),))),
                    rt.Bit("variable1", 12, 0xF, rt.Values(None, ((0, 15),))),
                    rt.Bit("variable2", 16, 0xF, rt.Values(None, ((0, 15),))),
                    rt.Bit("reserved", 20, 0xFFF, rt.Values(None, ((0, 2047),))),
                ),
            )

    annunciator: ReportAnnunciatorState.Annunciator

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("annunciator", ReportAnnunciatorState.Annunciator.layout()),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, annunciator_ = _S_HI.unpack(data)
        if code != 0x4516: raise rt.Reject
        reserved_ = annunciator_ >> 20 & 0xFFF
        if reserved_ > 2047: raise rt.Reject
        self.annunciator = ReportAnnunciatorState.Annunciator(annunciator_ & 0xF, annunciator_ >> 4 & 0xF, annunciator_ >> 8 & 0xF, annunciator_ >> 12 & 0xF, annunciator_ >> 16 & 0xF, reserved_)
        return self

    def _pack(self) -> bytes:
        annunciator_ = self.annunciator
        if type(annunciator_) is not ReportAnnunciatorState.Annunciator: raise rt.Reject
        horn_ = annunciator_.horn
        if not 0 <= horn_ <= 15: raise rt.Reject
        siren_ = annunciator_.siren
        if not 0 <= siren_ <= 15: raise rt.Reject
        backup_ = annunciator_.backup
        if not 0 <= backup_ <= 15: raise rt.Reject
        variable1_ = annunciator_.variable1
        if not 0 <= variable1_ <= 15: raise rt.Reject
        variable2_ = annunciator_.variable2
        if not 0 <= variable2_ <= 15: raise rt.Reject
        reserved_ = annunciator_.reserved
        if not 0 <= reserved_ <= 2047: raise rt.Reject
        return _S_HI.pack(0x4516, horn_ | siren_ << 4 | backup_ << 8 | variable1_ << 12 | variable2_ << 16 | reserved_ << 20)


@dataclass(slots=True, repr=False)
class ReportAnnunciatorConfiguration(rt.Message):
    """ReportAnnunciatorConfiguration (0x4517): Tells which annunciators there are.

    types: Annunciators that the platform has
    """

    CODE = 0x4517
    NAME = "ReportAnnunciatorConfiguration"
    SERVICE = "urn:jaus:jss:ugv:AnnunciatorService"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    class Horn(IntEnum):
        """Values of Horn."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Siren(IntEnum):
        """Values of Siren."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Backup(IntEnum):
        """Values of Backup."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Variable1(IntEnum):
        """Values of Variable1."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Variable2(IntEnum):
        """Values of Variable2."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    @dataclass(slots=True, repr=False)
    class Types(rt.Struct):
        """Annunciators that the platform has.

        horn: bit 0. Horn.
        siren: bit 1. Siren.
        backup: bit 2. Warning when driving backward.
        variable1: bit 3. First annunciator that the maker chooses.
        variable2: bit 4. Second annunciator that the maker chooses.
        reserved: bits 5..7. Sent as 0, ignored when received.
        """

        horn: ReportAnnunciatorConfiguration.Horn | int
        siren: ReportAnnunciatorConfiguration.Siren | int
        backup: ReportAnnunciatorConfiguration.Backup | int
        variable1: ReportAnnunciatorConfiguration.Variable1 | int
        variable2: ReportAnnunciatorConfiguration.Variable2 | int
        reserved: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Bits(
                cls,
                "B",
                (
                    rt.Bit("horn", 0, 0x1, rt.Values(ReportAnnunciatorConfiguration.Horn)),
                    rt.Bit("siren", 1, 0x1, rt.Values(ReportAnnunciatorConfiguration.Siren)),
                    rt.Bit("backup", 2, 0x1, rt.Values(ReportAnnunciatorConfiguration.Backup)),
                    rt.Bit("variable1", 3, 0x1, rt.Values(ReportAnnunciatorConfiguration.Variable1)),
                    rt.Bit("variable2", 4, 0x1, rt.Values(ReportAnnunciatorConfiguration.Variable2)),
                    rt.Bit("reserved", 5, 0x7, rt.Values(None, ((0, 7),))),
                ),
            )

    types: ReportAnnunciatorConfiguration.Types

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("types", ReportAnnunciatorConfiguration.Types.layout()),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, types_ = _S_HB.unpack(data)
        if code != 0x4517: raise rt.Reject
        self.types = ReportAnnunciatorConfiguration.Types(_E_ReportAnnunciatorConfiguration_Horn.get(types_ & 0x1, types_ & 0x1), _E_ReportAnnunciatorConfiguration_Siren.get(types_ >> 1 & 0x1, types_ >> 1 & 0x1), _E_ReportAnnunciatorConfiguration_Backup.get(types_ >> 2 & 0x1, types_ >> 2 & 0x1), _E_ReportAnnunciatorConfiguration_Variable1.get(types_ >> 3 & 0x1, types_ >> 3 & 0x1), _E_ReportAnnunciatorConfiguration_Variable2.get(types_ >> 4 & 0x1, types_ >> 4 & 0x1), types_ >> 5 & 0x7)
        return self

    def _pack(self) -> bytes:
        types_ = self.types
        if type(types_) is not ReportAnnunciatorConfiguration.Types: raise rt.Reject
        horn_ = types_.horn
        if not 0 <= horn_ <= 1: raise rt.Reject
        siren_ = types_.siren
        if not 0 <= siren_ <= 1: raise rt.Reject
        backup_ = types_.backup
        if not 0 <= backup_ <= 1: raise rt.Reject
        variable1_ = types_.variable1
        if not 0 <= variable1_ <= 1: raise rt.Reject
        variable2_ = types_.variable2
        if not 0 <= variable2_ <= 1: raise rt.Reject
        reserved_ = types_.reserved
        if not 0 <= reserved_ <= 7: raise rt.Reject
        return _S_HB.pack(0x4517, horn_ | siren_ << 1 | backup_ << 2 | variable1_ << 3 | variable2_ << 4 | reserved_ << 5)


_S_HI = rt.Packer("<HI")
_S_H = rt.Packer("<H")
_E_ReportAnnunciatorConfiguration_Horn = rt.members(ReportAnnunciatorConfiguration.Horn)
_E_ReportAnnunciatorConfiguration_Siren = rt.members(ReportAnnunciatorConfiguration.Siren)
_E_ReportAnnunciatorConfiguration_Backup = rt.members(ReportAnnunciatorConfiguration.Backup)
_E_ReportAnnunciatorConfiguration_Variable1 = rt.members(ReportAnnunciatorConfiguration.Variable1)
_E_ReportAnnunciatorConfiguration_Variable2 = rt.members(ReportAnnunciatorConfiguration.Variable2)
_S_HB = rt.Packer("<HB")
QueryAnnunciatorState.REPORT = ReportAnnunciatorState
QueryAnnunciatorConfiguration.REPORT = ReportAnnunciatorConfiguration
