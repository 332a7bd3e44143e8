"""urn:jaus:jss:exp:aeodrs:SubsystemIDAllocator 1.4. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:exp:aeodrs:SubsystemIDAllocator", "1.4")


@jd.message(_SERVICE, 0xFB02)
class ReportSubsystemIDs(jd.Message):
    """ReportSubsystemIDs (0xFB02): Tells the numbers given out and their holders.

    subsystem_ids_list: 0..255 items. One element a number given out; empty if none fits
    """

    class SubsystemIDType(IntEnum):
        ALL = 0
        OCU = 1
        UGV = 2
        MAC = 3

    @jd.record()
    class SubsystemIDTypeRec(jd.Struct):
        """subsystem_id_type: SubsystemIDType. Which entries the list holds"""
        subsystem_id_type: ReportSubsystemIDs.SubsystemIDType | int = jd.field("SubsystemIDType", lambda: jd.Number("B", jd.Values(ReportSubsystemIDs.SubsystemIDType)))

    class SubsystemType(IntEnum):
        VEHICLE = 10001
        OCU = 20001
        OTHER_SUBSYSTEM = 30001

    @jd.record()
    class SubsystemIDsRec(jd.Struct):
        """subsystem_id: Number given out
        subsystem_type: SubsystemType. Kind of subsystem
        ma_caddr: 6. MAC address of the holder
        """
        subsystem_id: int = jd.field("SubsystemID", jd.Number("H"))
        subsystem_type: ReportSubsystemIDs.SubsystemType | int = jd.field("SubsystemType", lambda: jd.Number("H", jd.Values(ReportSubsystemIDs.SubsystemType)))
        ma_caddr: list[int] = jd.field("MACaddr", jd.Grid(jd.Number("B"), (6,)))

    subsystem_id_type_rec: ReportSubsystemIDs.SubsystemIDTypeRec = jd.field("SubsystemIDTypeRec", lambda: ReportSubsystemIDs.SubsystemIDTypeRec.layout())
    subsystem_ids_list: list[ReportSubsystemIDs.SubsystemIDsRec] = jd.field("SubsystemIDsList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportSubsystemIDs.SubsystemIDsRec.layout()))


@jd.message(_SERVICE, 0xEB02, query=True)
class QuerySubsystemIDs(jd.Message):
    """QuerySubsystemIDs (0xEB02): Asks for the numbers given out, all or a part of them.

    subsystem_id_type: SubsystemIDType. Which entries to report
    ma_caddr: 6. MAC address to look up; counts only if SubsystemIDType is 3
    """
    REPORT = ReportSubsystemIDs

    class SubsystemIDType(IntEnum):
        ALL = 0
        OCU = 1
        UGV = 2
        MAC = 3

    subsystem_id_type: QuerySubsystemIDs.SubsystemIDType | int = jd.field("SubsystemIDType", lambda: jd.Number("B", jd.Values(QuerySubsystemIDs.SubsystemIDType)))
    ma_caddr: list[int] = jd.field("MACaddr", jd.Grid(jd.Number("B"), (6,)))


@jd.message(_SERVICE, 0xDB01, query=True)
class RequestSubsystemID(jd.Message):
    """RequestSubsystemID (0xDB01): Asks for a subsystem number of one's own.

    ma_caddr: 6. MAC address of the asker
    subsystem_type: SubsystemType. Kind of subsystem, same codes as the type in ReportIdentification
    """

    class SubsystemType(IntEnum):
        VEHICLE = 10001
        OCU = 20001
        OTHER_SUBSYSTEM = 30001

    ma_caddr: list[int] = jd.field("MACaddr", jd.Grid(jd.Number("B"), (6,)))
    subsystem_type: RequestSubsystemID.SubsystemType | int = jd.field("SubsystemType", lambda: jd.Number("H", jd.Values(RequestSubsystemID.SubsystemType)))


@jd.message(_SERVICE, 0xFB01)
class GrantSubsystemID(jd.Message):
    """GrantSubsystemID (0xFB01): Answers a request with the number given out; sent as broadcast as the asker has no address yet.

    subsystem_id: Number given out; 0 if that failed
    subsystem_type: SubsystemType. Kind of subsystem, same codes as the type in ReportIdentification
    ma_caddr: 6. MAC address of the asker, sent back so that it knows the answer is its own
    """

    class SubsystemType(IntEnum):
        VEHICLE = 10001
        OCU = 20001
        OTHER_SUBSYSTEM = 30001

    subsystem_id: int = jd.field("SubsystemID", jd.Number("H"))
    subsystem_type: GrantSubsystemID.SubsystemType | int = jd.field("SubsystemType", lambda: jd.Number("H", jd.Values(GrantSubsystemID.SubsystemType)))
    ma_caddr: list[int] = jd.field("MACaddr", jd.Grid(jd.Number("B"), (6,)))
