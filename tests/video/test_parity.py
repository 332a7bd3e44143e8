"""Parity packets: what is lost is restored, in order and byte for byte; who does not ask gets none."""

from __future__ import annotations

import random
from itertools import islice

import pytest

from jauspy.video.h264_payload import IDR, MAX_PACKET, MAX_PAYLOAD, PPS, SPS
from jauspy.video.parity import (
    HOLD,
    KEPT,
    MAX_AHEAD,
    MAX_ROWS,
    STEPS,
    PacketRepair,
    ParityEncoder,
    ShareControl,
    parity_source,
)
from jauspy.video.rtp import PARITY_TYPE, RtpPacket, parity_request, requested_parity, requests_picture
from jauspy.virtual.bad_link import Direction, Watched, burst_losses, random_losses, watch

SOURCE, RATE, SLICES = 7, 15, 12


def stream(pictures: int, seed: int = 1) -> list[RtpPacket]:
    chance = random.Random(seed)
    return [
        RtpPacket(
            (65_000 + SLICES * picture + number) & 0xFFFF,
            picture * 6000,
            SOURCE,
            chance.randbytes(chance.randint(40, MAX_PAYLOAD)),
            marker=number == SLICES - 1,
        )
        for picture in range(pictures)
        for number in range(SLICES)
    ]


def sent(packets: list[RtpPacket], share: float) -> list[tuple[float, RtpPacket]]:
    encoder = ParityEncoder(SOURCE)
    found = []
    for number, packet in enumerate(packets):
        now = number // SLICES / RATE
        found.append((now, packet))
        found += [(now, RtpPacket.decode(data)) for data in encoder.add(packet, share, now)]
    return found


def received(repair: PacketRepair, packets: list[tuple[float, RtpPacket]]) -> list[RtpPacket]:
    found: list[RtpPacket] = []
    for now, packet in packets:
        found += (repair.feed_parity if packet.payload_type == PARITY_TYPE else repair.feed)(packet, now)
    return found


@pytest.mark.parametrize("losses", [random_losses(0.05, 3), burst_losses(0.05, 4.0, 3)], ids=["random", "bursts"])
def test_what_is_lost_is_restored_in_order_over_the_end_of_the_numbers(losses):
    packets = stream(60)
    through = [each for n, each in enumerate(sent(packets, 0.5)) if n < 20 or not next(losses)]
    repair = PacketRepair()
    assert received(repair, through) == packets
    assert repair.counters["missing"] >= repair.counters["repaired"] > 20


def test_parity_packets_are_no_longer_than_others_and_name_their_stream():
    parity = [packet for _, packet in sent(stream(20), 1.0) if packet.payload_type == PARITY_TYPE]
    assert len(parity) == 20 * SLICES
    assert max(len(packet.encode()) for packet in parity) <= MAX_PACKET
    assert {parity_source(packet) for packet in parity} == {SOURCE}


def test_without_parity_nothing_is_held_back():
    repair, packets = PacketRepair(), stream(3)
    for number, packet in enumerate(packets):
        if number != 5:
            assert repair.feed(packet, 0.0) == [packet]


def test_a_packet_that_nothing_restores_is_waited_for_only_so_long():
    repair, packets = PacketRepair(), sent(stream(20), 0.25)
    assert len(received(repair, packets[:40])) >= 30
    noticed = packets[75][0]  # so many were lost that parity cannot restore them
    handed_out = next(now for now, packet in packets[75:] if received(repair, [(now, packet)]))
    assert HOLD <= handed_out - noticed <= HOLD + 1.5 / RATE


def test_parity_of_an_attacker_is_bounded_and_never_raises():
    repair, chance = PacketRepair(), random.Random(5)
    for packet in stream(2):
        repair.feed(packet, 0.0)
    for number in range(3000):
        size = chance.choice((0, 9, 10, 18, 400, 1400, 1510, 60_000))
        first = (65_024 + chance.randint(-70, 600)) & 0xFFFF
        payload = SOURCE.to_bytes(4, "big") + first.to_bytes(2, "big") + chance.randbytes(size)
        packet = RtpPacket(number, 0, 9, payload, payload_type=PARITY_TYPE)
        repair.feed_parity(packet, 0.001 * number)
    assert len(repair._rows) <= MAX_ROWS
    assert len(repair._known) <= KEPT + MAX_AHEAD + MAX_ROWS
    assert repair.counters["malformed"]
    assert repair.feed(RtpPacket(30_000, 0, SOURCE, bytes(60_000)), 10.0)


def test_large_packets_do_not_wait_for_a_missing_one():
    repair = PacketRepair()
    repair.feed(RtpPacket(0, 0, SOURCE, bytes(100)), 0.0)
    repair.feed_parity(RtpPacket(0, 0, 9, SOURCE.to_bytes(4, "big") + bytes(20), payload_type=PARITY_TYPE), 0.0)
    large = [RtpPacket(number, 0, SOURCE, bytes(60_000)) for number in range(2, 40)]
    assert [packet for each in large for packet in repair.feed(each, 0.0)] == large


def test_a_request_names_the_stream_and_is_no_request_for_a_picture():
    data = parity_request(3, SOURCE, 0.5)
    assert requested_parity(data) == (SOURCE, 0.5)
    assert not requests_picture(data)
    assert requested_parity(parity_request(3, SOURCE, 90.0)) == (SOURCE, 1.0)
    assert all(requested_parity(data[:end]) is None for end in range(len(data)))


def test_more_losses_ask_for_more_and_what_was_not_restored_for_still_more():
    control = ShareControl()
    assert control.share(0.0, 0, 0, 0) == 0.0
    assert control.share(1.0, 1000, 10, 0) == STEPS[1][1]
    assert control.share(2.0, 2000, 100, 0) == STEPS[2][1]
    assert control.share(3.0, 3000, 150, 2) == STEPS[3][1]
    assert control.share(90.0, 90_000, 150, 2) == 0.0


def picture(number: int, idr: bool, share: float) -> list[bytes]:
    """NAL units as those of 2 Mbit/s, less with parity; an IDR takes more packets."""
    count = round((30 if idr or number % 30 == 0 else SLICES) / (1.0 + share))
    kind, sets = (IDR, [bytes([SPS, 0x42, 0xC0, 0x1E]), bytes([PPS, 1])]) if idr or number % 30 == 0 else (1, [])
    return [*sets, *(bytes([0x60 | kind]) + bytes([number & 0xFF or 1]) * (MAX_PAYLOAD - 40) for _ in range(count))]


def over(losses, **options) -> Watched:
    return watch(picture, Direction(losses, 0.3), Direction(random_losses(0.05, 9), 0.3), seconds=40.0, **options)


@pytest.mark.slow
@pytest.mark.parametrize("seed", [1, 2])
@pytest.mark.parametrize("length", [None, 4.0], ids=["random", "bursts of 4"])
def test_over_a_bad_link_the_picture_is_younger_than_a_second_and_does_not_freeze(length, seed):
    losses = random_losses(0.05, seed) if length is None else burst_losses(0.05, length, seed)
    seen = over(losses)
    assert seen.ages(8.0, 40.0)[-1] < 1.0
    assert seen.longest_freeze(8.0, 40.0) < 0.5


def test_a_receiver_that_does_not_ask_gets_no_parity():
    seen = watch(
        picture,
        Direction(random_losses(0.05, 1), 0.0),
        Direction(random_losses(0.0, 9), 0.0),
        seconds=3.0,
        parity=False,
    )
    assert not seen.counters.get("parity")


def test_without_losses_no_parity_is_sent():
    seen = watch(picture, Direction(random_losses(0.0, 1), 0.1), Direction(random_losses(0.0, 9), 0.1), seconds=3.0)
    assert not seen.counters.get("parity")
    assert len(seen.shown) >= 3 * RATE - 4


def test_losses_have_their_rate():
    for losses in (random_losses(0.05, 1), burst_losses(0.05, 4.0, 1)):
        assert sum(islice(losses, 100_000)) == pytest.approx(5000, rel=0.1)
