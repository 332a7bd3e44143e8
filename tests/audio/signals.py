"""Sounds for tests, and what is found in them."""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np

from jauspy.audio.coding import FRAME, AudioEncoder
from jauspy.platform.sound import SAMPLE_RATE, Coding
from jauspy.video.rtp import RtpPacket

SSRC = 0x1234


def tone(frequency: float, seconds: float, amplitude: float = 0.5):
    return (amplitude * np.sin(math.tau * frequency * np.arange(round(SAMPLE_RATE * seconds)) / SAMPLE_RATE)).astype(
        np.float32
    )


def frames(sound):
    return [sound[begin : begin + FRAME] for begin in range(0, len(sound) - FRAME + 1, FRAME)]


def packets(sound, coding: Coding = Coding.OPUS, sequence: int = 100, ssrc: int = SSRC) -> list[RtpPacket]:
    """The RTP packets of a sound; their time stamps are those of a clock at 48 kHz."""
    encoder = AudioEncoder(coding)
    payloads = [payload for frame in frames(sound) for payload in encoder.encode(frame)]
    return [
        RtpPacket((sequence + number) & 0xFFFF, number * FRAME, ssrc, payload, payload_type=coding.value)
        for number, payload in enumerate(payloads)
    ]


def joined(sounds: Iterable[object]):
    parts = list(sounds)
    return np.concatenate(parts) if parts else np.zeros(0, np.float32)


def strongest(sound) -> float:
    """The strongest frequency, Hz."""
    window = np.hanning(len(sound))
    spectrum = np.abs(np.fft.rfft(sound * window))
    return float(spectrum.argmax() * SAMPLE_RATE / len(sound))


def level(sound) -> float:
    """Root mean square, dB of full scale."""
    return 20.0 * math.log10(float(np.sqrt(np.mean(np.asarray(sound, float) ** 2))) + 1e-9)
