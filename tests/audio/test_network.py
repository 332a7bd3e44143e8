"""Sender and receiver over UDP, and what strangers send to the receiver."""

from __future__ import annotations

import secrets
import socket
from dataclasses import replace

import pytest

pytest.importorskip("numpy", reason="the extra 'video' is not installed")
pytest.importorskip("av", reason="the extra 'video' is not installed")

from tests.audio.signals import frames, joined, packets, strongest, tone

from jauspy.audio.receiver import MAX_CANDIDATES, SOURCE_TIMEOUT, AudioReceiver
from jauspy.audio.sender import MAX_RECEIVERS, AudioSender
from jauspy.errors import ConfigError
from jauspy.platform.sound import Coding

SOUND = tone(440.0, 1.0)


@pytest.fixture
def receiver():
    with AudioReceiver() as receiver:
        yield receiver


@pytest.fixture
def stranger():
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as opened:
        opened.bind(("127.0.0.1", 0))
        yield opened


def send_all(sender, receiver, sound=SOUND):
    found = []
    for number, frame in enumerate(frames(sound)):
        sender.send(frame, 0.02 * number, 1000.0)
        found += receiver.take()
    return joined([*found, *receiver.end()])


@pytest.mark.parametrize("coding", Coding)
def test_what_arrives_has_the_tone_that_was_sent(receiver, coding):
    with AudioSender() as sender:
        sender.add(("127.0.0.1", receiver.port), coding)
        found = send_all(sender, receiver)
    assert strongest(found[9600:]) == pytest.approx(440.0, abs=3.0)
    assert len(found) == pytest.approx(len(SOUND), abs=2000)
    assert receiver.counters["packets"] >= 49
    assert "lost" not in receiver.counters


def test_receivers_with_other_codings_get_the_same_sound():
    with AudioReceiver() as first, AudioReceiver() as second, AudioSender() as sender:
        sender.add(("127.0.0.1", first.port), Coding.OPUS)
        sender.add(("127.0.0.1", second.port), Coding.PCMU)
        found = {first: [], second: []}
        for number, frame in enumerate(frames(SOUND)):
            sender.send(frame, 0.02 * number, 1000.0)
            for receiver, sounds in found.items():
                sounds.extend(receiver.take())
        for sounds in found.values():
            assert strongest(joined(sounds)[9600:]) == pytest.approx(440.0, abs=3.0)


def test_paused_receiver_resumes_without_a_gap_in_the_sequence(receiver):
    address = ("127.0.0.1", receiver.port)
    with AudioSender() as sender:
        sender.add(address)
        found = []
        for number, frame in enumerate(frames(SOUND)):
            if number in (10, 30):
                sender.add(address, playing=number == 30)
            sender.send(frame, 0.02 * number, 1000.0)
            found += receiver.take()
        assert not sender.counters["dropped"]
    assert receiver.counters["packets"] == 30
    assert "lost" not in receiver.counters


def test_one_receiver_too_many_is_refused():
    with AudioSender() as sender:
        for number in range(MAX_RECEIVERS):
            sender.add(("127.0.0.1", 5000 + 2 * number))
        with pytest.raises(ConfigError, match="8 receivers hear jauspy already"):
            sender.add(("127.0.0.1", 6000))
        sender.remove(("127.0.0.1", 5000))
        with pytest.raises(ConfigError, match=r"sound: 'robot\.example' is not an IP address"):
            sender.add(("robot.example", 5004))


def test_garbage_is_counted_and_does_not_disturb(receiver, stranger):
    address = ("127.0.0.1", receiver.port)
    with AudioSender() as sender:
        sender.add(address)
        found = []
        for number, frame in enumerate(frames(SOUND)):
            for garbage in (b"", b"\x80", secrets.token_bytes(40), b"\xbf" + bytes(11), b"\x80\x61" + bytes(10)):
                stranger.sendto(garbage, address)
            sender.send(frame, 0.02 * number, 1000.0)
            found += receiver.take()
    assert receiver.counters["not_rtp"] >= 4 * 50
    assert strongest(joined(found)[9600:]) == pytest.approx(440.0, abs=3.0)


def test_another_source_is_dropped_while_the_first_one_sends(stranger):
    now = 0.0
    with AudioReceiver(clock=lambda: now) as receiver, AudioSender() as sender:
        address = ("127.0.0.1", receiver.port)
        sender.add(address)
        for number, (frame, packet) in enumerate(zip(frames(SOUND), packets(tone(3000.0, 1.0)), strict=False)):
            now = 0.02 * number
            sender.send(frame, now, 1000.0)
            if number >= 5:
                stranger.sendto(packet.encode(), address)
            sound = joined(receiver.take())
            if number > 15:
                assert strongest(sound) < 1500.0
        assert receiver.counters["foreign"] == 45
        now += SOURCE_TIMEOUT
        found = []
        for packet in packets(tone(3000.0, 0.4), sequence=9):
            stranger.sendto(packet.encode(), address)
            found += receiver.take()
        assert strongest(joined(found)[4800:]) == pytest.approx(3000.0, abs=10.0), "it takes over after a silence"


def test_wrong_ssrc_from_the_same_address_is_foreign(receiver, stranger):
    address = ("127.0.0.1", receiver.port)
    for number, packet in enumerate(packets(SOUND)):
        stranger.sendto((replace(packet, ssrc=7) if number % 5 == 4 else packet).encode(), address)
        receiver.take()
    assert receiver.counters["foreign"] == 10
    assert receiver.source is not None
    assert receiver.source.ssrc == packets(SOUND)[0].ssrc


def test_sources_that_are_followed_are_few(receiver, stranger):
    first = packets(SOUND)[0]
    for ssrc in range(200):
        stranger.sendto(replace(first, ssrc=ssrc).encode(), ("127.0.0.1", receiver.port))
        receiver.take()
        assert len(receiver._candidates) <= MAX_CANDIDATES
    assert receiver.source is None


def test_packets_of_other_machines_are_refused(stranger):
    with AudioReceiver(only=lambda host, port: (host, port) == ("127.0.0.1", 1)) as receiver:
        for packet in packets(SOUND):
            stranger.sendto(packet.encode(), ("127.0.0.1", receiver.port))
            assert not receiver.take()
        assert receiver.counters == {"refused": 50}
