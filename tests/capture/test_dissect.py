"""Messages in a capture whose id means several things, or nothing."""

from __future__ import annotations

from random import Random

import pytest

from jauspy.capture.dissect import dissect, read_message
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.protocol import judp
from jauspy.protocol.header import Ack, Broadcast, DataFlag, Packet, Priority

STATUS = bytes.fromhex("02400100000000")
SOURCE, DESTINATION = JausID(101, 1, 102), JausID(42, 1, 1)


def test_ambiguous_id_is_not_decoded() -> None:
    content = read_message(bytes.fromhex("2af900"), registry)
    assert content.message is None
    assert content.problem == (
        "message F92Ah is CBRNScanWindowConfigurationCommand of iop:CBRNSensor 1.1 or "
        "QueryMeasurement of iop:MeasurementSensor 1.1; specify the service"
    )


def test_an_unknown_id() -> None:
    assert read_message(bytes.fromhex("eeee00"), registry).problem == "unknown message EEEEh"


@pytest.mark.slow
def test_reencodes_is_what_encoding_gives() -> None:
    random, counts = Random(2), {True: 0, False: 0}
    for entry in registry.entries:
        for size in (0, 1, 4, 30):
            data = bytes(random.choice((0, 1, 2, random.randrange(256))) for _ in range(size))
            content = read_message(entry.code.to_bytes(2, "little") + data, registry)
            assert content.reencodes is (content.reencoded() == content.payload)
            counts[content.reencodes] += 1
    assert min(counts.values()) > 100


@pytest.mark.parametrize("control", range(256))
def test_headers_of_every_control_byte_reencode(control: int) -> None:
    fields = Priority(control & 3), Broadcast(control >> 2 & 3), Ack(control >> 4 & 3), DataFlag(control >> 6)
    datagram = judp.pack(Packet(SOURCE, DESTINATION, STATUS, 7, *fields))
    found = dissect(datagram, registry)
    assert found.reencodes
    is_single = fields[2] != Ack.ACK and fields[3] == DataFlag.SINGLE
    is_faulty = fields[1:] == (Broadcast.RESERVED, Ack.ACK, DataFlag.LAST)
    assert (found.parts[0].content.message is not None) is (is_single or is_faulty)


def test_datagrams_whose_headers_encode_otherwise() -> None:
    datagram = judp.pack(Packet(SOURCE, DESTINATION, STATUS, 7))
    size = (len(datagram) + 1).to_bytes(2, "little")
    proposed = datagram[:1] + b"\x40" + size + b"\x00\x00" + datagram[4:]
    assert dissect(datagram + datagram[1:], registry).reencodes
    found = dissect(proposed, registry)
    assert found.parts[0].content.reencodes
    assert not found.reencodes
    assert not dissect(datagram + b"\x00", registry).reencodes
    assert not dissect(b"", registry).reencodes
