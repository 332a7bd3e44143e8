"""Packets of one stream that are lost, late, doubled, or far away."""

from __future__ import annotations

from dataclasses import replace

import pytest

pytest.importorskip("numpy", reason="the extra 'video' is not installed")
pytest.importorskip("av", reason="the extra 'video' is not installed")

import numpy as np
from tests.audio.signals import joined, level, packets, strongest, tone

from jauspy.audio.coding import FRAME
from jauspy.audio.playout import MAX_GAP, REORDER, Playout
from jauspy.platform.sound import Coding

SOUND = tone(800.0, 1.0)


def played(sent):
    playout = Playout()
    sound = [part for packet in sent for part in playout.feed(packet)]
    return joined([*sound, *playout.end()]), playout


@pytest.mark.parametrize("coding", Coding)
def test_lost_packets_are_concealed_and_counted(coding):
    sent = packets(SOUND, coding)
    lost = {10, 20, 21, 33}
    whole, _ = played(sent)
    found, playout = played([packet for number, packet in enumerate(sent) if number not in lost])
    assert playout.counters["lost"] == playout.counters["concealed"] == len(lost)
    assert len(found) == pytest.approx(len(whole), abs=FRAME), "no time is missing"
    gap = found[10 * FRAME : 11 * FRAME]
    assert level(gap) > level(whole[10 * FRAME : 11 * FRAME]) - 8.0, "the gap is filled"
    assert strongest(gap) == pytest.approx(800.0, abs=60.0)


def test_concealment_fades_out():
    sent = packets(SOUND)
    found, playout = played(sent[:15] + sent[15 + MAX_GAP - 1 :])
    assert playout.counters["concealed"] == MAX_GAP - 1
    assert level(found[15 * FRAME : 16 * FRAME]) > -20.0
    assert level(found[25 * FRAME : 26 * FRAME]) < -50.0
    assert level(found[-2 * FRAME :]) > -15.0, "the sound is back"


def test_order_is_restored():
    sent = packets(SOUND)
    in_order, _ = played(sent)
    swapped = [*sent[:9], sent[11], sent[10], sent[9], *sent[12:]]
    found, playout = played(swapped)
    assert np.array_equal(found, in_order)
    assert not playout.counters["lost"]


def test_doubled_and_late_packets_are_dropped():
    sent = packets(SOUND)
    in_order, _ = played(sent)
    found, playout = played([*sent[:20], sent[19], sent[3], *sent[20:]])
    assert np.array_equal(found, in_order)
    assert playout.counters["late"] == 2


def test_one_packet_far_away_changes_nothing_and_two_begin_again():
    sent = packets(SOUND)
    far = [replace(packet, sequence=(packet.sequence + 20_000) & 0xFFFF) for packet in sent]
    found, playout = played([*sent[:20], far[3], *sent[20:]])
    assert playout.counters["late"] == 1
    assert len(found) == len(played(sent)[0])
    found, playout = played([*sent[:20], *far[20:]])
    assert playout.counters["restarted"] == 1
    assert not playout.counters["concealed"], "a step of 20,000 packets is not filled"


def test_huge_time_stamps_do_not_matter():
    sent = packets(SOUND)
    wild = [replace(packet, timestamp=0xFFFFFFFF - 7919 * number**3 % 2**32) for number, packet in enumerate(sent)]
    assert np.array_equal(played(wild)[0], played(sent)[0])


def test_packets_that_wait_are_few():
    playout = Playout()
    sent = packets(SOUND)
    playout.feed(sent[0])
    for packet in sent[2:]:
        playout.feed(packet)
        assert len(playout._held) <= REORDER
    assert playout.counters["lost"] == 1


def test_sequence_numbers_wrap_around():
    found, playout = played(packets(SOUND, sequence=0xFFF0))
    assert len(found) == len(played(packets(SOUND))[0])
    assert not playout.counters["lost"]


def test_payload_that_is_no_sound_is_concealed():
    sent = packets(SOUND)
    sent[7] = replace(sent[7], payload=bytes([0xFF]) * 700)
    found, playout = played(sent)
    assert playout.counters["not_audio"] == playout.counters["concealed"] == 1
    assert len(found) == len(played(packets(SOUND))[0])


def test_other_payload_types_are_counted():
    _, playout = played([replace(packet, payload_type=96) for packet in packets(SOUND)])
    assert playout.counters["other_coding"] == len(packets(SOUND))
