"""Large messages are put together, whatever the order of their fragments."""

from __future__ import annotations

import random

import pytest

from jauspy.capture.dissector import Dissector
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.core import Event
from jauspy.protocol import judp
from jauspy.protocol.delivery import fragment_at, fragment_count
from jauspy.protocol.header import Packet


def fragments(payload: bytes, sequence: int = 65534) -> list[bytes]:
    found = []
    for index in range(fragment_count(len(payload))):
        part, flag = fragment_at(payload, index)
        packet = Packet(JausID(1, 1, 1), JausID(2, 1, 1), part, (sequence + index) & 0xFFFF, data_flag=flag)
        found.append(judp.pack(packet))
    return found


def event() -> bytes:
    return Event(event_id=1, sequence_number=2, report_message=b"\xee\xee" + bytes(15000)).encode()


@pytest.mark.parametrize("seed", range(6))
def test_the_last_fragment_that_arrives_has_the_message(seed: int) -> None:
    whole = event()
    datagrams = fragments(whole)
    assert len(datagrams) >= 3
    random.Random(seed).shuffle(datagrams)
    dissector = Dissector(registry)
    *before, last = [dissector.dissect(data, 100.0 + number).parts[0] for number, data in enumerate(datagrams)]
    assert all(part.content.message is None for part in before)
    assert isinstance(last.content.message, Event)
    assert last.content.payload == whole


def test_a_message_with_a_missing_fragment_is_none() -> None:
    dissector = Dissector(registry)
    datagrams = fragments(event())
    parts = [dissector.dissect(data, 1.0).parts[0] for data in (datagrams[0], *datagrams[2:])]
    assert all(part.content.message is None and "fragment" in part.content.problem for part in parts)


def test_damaged_datagrams_between_fragments() -> None:
    dissector = Dissector(registry)
    rng = random.Random(4)
    found = []
    for data in fragments(event()):
        for _ in range(200):
            damaged = bytearray(data[:200])
            damaged[rng.randrange(len(damaged))] = rng.randrange(256)
            damaged[11:15] = rng.randbytes(4)  # from others
            dissector.dissect(bytes(damaged), rng.uniform(0.0, 100.0))
        found += dissector.dissect(data, 50.0).parts
    assert isinstance(found[-1].content.message, Event)


def test_fragments_keep_their_own_bytes() -> None:
    dissector = Dissector(registry)
    assert all(dissector.dissect(data, 0.0).reencodes for data in fragments(event()))
