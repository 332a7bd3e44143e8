"""urn:jaus:jss:ugv:AnnunciatorService 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:ugv:AnnunciatorService", "1.0")


@jd.message(_SERVICE, 0x0516, command=True)
class SetAnnunciatorState(jd.Message):
    """SetAnnunciatorState (0x0516): Switches annunciators.

    annunciator: Which annunciators are on
    """

    @jd.bit_field("I")
    class Annunciator(jd.Struct):
        """Which annunciators are on.

        horn: bits 0..3. Horn.
        siren: bits 4..7. Siren.
        backup: bits 8..11. Warning when driving backward.
        variable1: bits 12..15. First annunciator that the maker chooses.
        variable2: bits 16..19. Second annunciator that the maker chooses.
        reserved: bits 20..31. Sent as 0, ignored when received.
        """
        horn: int = jd.bits(0, 0xF, jd.Values(None, ((0, 15),)))
        siren: int = jd.bits(4, 0xF, jd.Values(None, ((0, 15),)))
        backup: int = jd.bits(8, 0xF, jd.Values(None, ((0, 15),)))
        variable1: int = jd.bits(12, 0xF, jd.Values(None, ((0, 15),)))
        variable2: int = jd.bits(16, 0xF, jd.Values(None, ((0, 15),)))
        reserved: int = jd.bits(20, 0xFFF, jd.Values(None, ((0, 2047),)))

    annunciator: SetAnnunciatorState.Annunciator = jd.field("annunciator", lambda: SetAnnunciatorState.Annunciator.layout())


@jd.message(_SERVICE, 0x4516)
class ReportAnnunciatorState(jd.Message):
    """ReportAnnunciatorState (0x4516): Tells which annunciators are on.

    annunciator: Which annunciators are on
    """

    @jd.bit_field("I")
    class Annunciator(jd.Struct):
        """Which annunciators are on.

        horn: bits 0..3. Horn.
        siren: bits 4..7. Siren.
        backup: bits 8..11. Warning when driving backward.
        variable1: bits 12..15. First annunciator that the maker chooses.
        variable2: bits 16..19. Second annunciator that the maker chooses.
        reserved: bits 20..31. Sent as 0, ignored when received.
        """
        horn: int = jd.bits(0, 0xF, jd.Values(None, ((0, 15),)))
        siren: int = jd.bits(4, 0xF, jd.Values(None, ((0, 15),)))
        backup: int = jd.bits(8, 0xF, jd.Values(None, ((0, 15),)))
        variable1: int = jd.bits(12, 0xF, jd.Values(None, ((0, 15),)))
        variable2: int = jd.bits(16, 0xF, jd.Values(None, ((0, 15),)))
        reserved: int = jd.bits(20, 0xFFF, jd.Values(None, ((0, 2047),)))

    annunciator: ReportAnnunciatorState.Annunciator = jd.field("annunciator", lambda: ReportAnnunciatorState.Annunciator.layout())


@jd.message(_SERVICE, 0x2516, query=True)
class QueryAnnunciatorState(jd.Message):
    """QueryAnnunciatorState (0x2516): Asks which annunciators are on."""
    REPORT = ReportAnnunciatorState


@jd.message(_SERVICE, 0x4517)
class ReportAnnunciatorConfiguration(jd.Message):
    """ReportAnnunciatorConfiguration (0x4517): Tells which annunciators there are.

    types: Annunciators that the platform has
    """

    class Horn(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Siren(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Backup(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Variable1(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Variable2(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    @jd.bit_field("B")
    class Types(jd.Struct):
        """Annunciators that the platform has.

        horn: bit 0. Horn.
        siren: bit 1. Siren.
        backup: bit 2. Warning when driving backward.
        variable1: bit 3. First annunciator that the maker chooses.
        variable2: bit 4. Second annunciator that the maker chooses.
        reserved: bits 5..7. Sent as 0, ignored when received.
        """
        horn: ReportAnnunciatorConfiguration.Horn | int = jd.bits(0, 0x1, lambda: jd.Values(ReportAnnunciatorConfiguration.Horn))
        siren: ReportAnnunciatorConfiguration.Siren | int = jd.bits(1, 0x1, lambda: jd.Values(ReportAnnunciatorConfiguration.Siren))
        backup: ReportAnnunciatorConfiguration.Backup | int = jd.bits(2, 0x1, lambda: jd.Values(ReportAnnunciatorConfiguration.Backup))
        variable1: ReportAnnunciatorConfiguration.Variable1 | int = jd.bits(3, 0x1, lambda: jd.Values(ReportAnnunciatorConfiguration.Variable1))
        variable2: ReportAnnunciatorConfiguration.Variable2 | int = jd.bits(4, 0x1, lambda: jd.Values(ReportAnnunciatorConfiguration.Variable2))
        reserved: int = jd.bits(5, 0x7, jd.Values(None, ((0, 7),)))

    types: ReportAnnunciatorConfiguration.Types = jd.field("types", lambda: ReportAnnunciatorConfiguration.Types.layout())


@jd.message(_SERVICE, 0x2517, query=True)
class QueryAnnunciatorConfiguration(jd.Message):
    """QueryAnnunciatorConfiguration (0x2517): Asks which annunciators there are."""
    REPORT = ReportAnnunciatorConfiguration
