"""Declared types that several messages share. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd


@jd.record()
class AttachmentFrameRecord(jd.Struct):
    """host_node_id: Node to which the attachment point belongs
    attachment_id: Number of the attachment point
    """
    host_node_id: int = jd.field("HostNodeID", jd.Number("B"))
    attachment_id: int = jd.field("AttachmentID", jd.Number("B"))


@jd.record()
class EndpointRecord(jd.Struct):
    """ip_addr: IPv4 address of the receiver
    port: Port number of the receiver
    """
    ip_addr: int = jd.field("IpAddr", jd.Number("I"))
    port: int = jd.field("Port", jd.Number("H"))


@jd.bit_field("H")
class SampleWidths(jd.Struct):
    """eight_bits: bit 0. Eight bits.
    ten_bits: bit 1. Ten bits.
    twelve_bits: bit 2. Twelve bits.
    fourteen_bits: bit 3. Fourteen bits.
    sixteen_bits: bit 4. Sixteen bits.
    twenty_bits: bit 5. Twenty bits.
    twenty_four_bits: bit 6. Twenty four bits.
    thirty_two_bits: bit 7. Thirty two bits.
    fourty_bits: bit 8. Fourty bits.
    fourty_eight_bits: bit 9. Fourty eight bits.
    fifty_six_bits: bit 10. Fifty six bits.
    sixty_four_bits: bit 11. Sixty four bits.
    """
    eight_bits: int = jd.bits(0, 0x1)
    ten_bits: int = jd.bits(1, 0x1)
    twelve_bits: int = jd.bits(2, 0x1)
    fourteen_bits: int = jd.bits(3, 0x1)
    sixteen_bits: int = jd.bits(4, 0x1)
    twenty_bits: int = jd.bits(5, 0x1)
    twenty_four_bits: int = jd.bits(6, 0x1)
    thirty_two_bits: int = jd.bits(7, 0x1)
    fourty_bits: int = jd.bits(8, 0x1)
    fourty_eight_bits: int = jd.bits(9, 0x1)
    fifty_six_bits: int = jd.bits(10, 0x1)
    sixty_four_bits: int = jd.bits(11, 0x1)
    reserved_bits: int = 0


@jd.bit_field("H")
class Formats(jd.Struct):
    """u_law: bit 0. U law.
    aac: bit 1. AAC.
    mp3: bit 2. MP 3.
    """
    u_law: int = jd.bits(0, 0x1)
    aac: int = jd.bits(1, 0x1)
    mp3: int = jd.bits(2, 0x1)
    reserved_bits: int = 0


@jd.bit_field("B")
class EncodingQuality(jd.Struct):
    """highest: bit 0. HIGHEST.
    high: bit 1. HIGH.
    good: bit 2. GOOD.
    median: bit 3. MEDIAN.
    fair: bit 4. FAIR.
    poor: bit 5. POOR.
    lowest: bit 6. LOWEST.
    """
    highest: int = jd.bits(0, 0x1)
    high: int = jd.bits(1, 0x1)
    good: int = jd.bits(2, 0x1)
    median: int = jd.bits(3, 0x1)
    fair: int = jd.bits(4, 0x1)
    poor: int = jd.bits(5, 0x1)
    lowest: int = jd.bits(6, 0x1)
    reserved_bits: int = 0


@jd.record()
class UGVSeverityRec(jd.Struct):
    """severity: Severity. How serious it is"""

    class Severity(IntEnum):
        NONE = 0
        INFO = 1
        WARN = 2
        ERR = 3
        FAIL = 4

    severity: UGVSeverityRec.Severity | int = jd.field("severity", lambda: jd.Number("B", jd.Values(UGVSeverityRec.Severity)))


@jd.record()
class SeverityRec(jd.Struct):
    """severity: Severity. How serious it is"""

    class Severity(IntEnum):
        NONE = 0
        INFO = 1
        WARN = 2
        ERR = 3
        FAIL = 4

    severity: SeverityRec.Severity | int = jd.field("severity", lambda: jd.Number("B", jd.Values(SeverityRec.Severity)))
