"""Sound that is encoded and decoded again, and payloads that are none."""

from __future__ import annotations

from contextlib import suppress

import pytest

pytest.importorskip("numpy", reason="the extra 'video' is not installed")
pytest.importorskip("av", reason="the extra 'video' is not installed")

import numpy as np
from hypothesis import given, settings, strategies as st
from tests.audio.signals import frames, joined, level, strongest, tone

from jauspy.audio.coding import MAX_PACKET_TIME, MAX_PAYLOAD, AudioDecoder, AudioEncoder
from jauspy.errors import ProtocolError
from jauspy.platform.sound import MAX_BIT_RATE, MIN_BIT_RATE, SAMPLE_RATE, Coding


@pytest.mark.parametrize("coding", Coding)
def test_tone_comes_back_with_its_frequency_and_level(coding):
    sound, encoder, decoder = tone(1000.0, 1.0), AudioEncoder(coding), AudioDecoder(coding)
    found = joined(decoder.decode(payload) for frame in frames(sound) for payload in encoder.encode(frame))
    assert len(found) == pytest.approx(len(sound), abs=0.03 * SAMPLE_RATE)
    settled = found[SAMPLE_RATE // 5 :]
    assert strongest(settled) == pytest.approx(1000.0, abs=3.0)
    assert level(settled) == pytest.approx(level(sound), abs=1.0)


@pytest.mark.parametrize("bit_rate", [MIN_BIT_RATE, 48, MAX_BIT_RATE])
def test_bit_rate_of_opus_is_what_was_asked_for(bit_rate):
    noise = (0.2 * np.random.default_rng(1).standard_normal(2 * SAMPLE_RATE)).astype(np.float32)
    encoder = AudioEncoder(Coding.OPUS, bit_rate)
    payloads = [payload for frame in frames(noise) for payload in encoder.encode(frame)]
    assert sum(map(len, payloads)) * 8 / 2.0 / 1000.0 == pytest.approx(bit_rate, rel=0.3)
    assert max(map(len, payloads)) <= MAX_PAYLOAD


def test_sound_above_full_scale_is_clipped():
    encoder, decoder = AudioEncoder(Coding.PCMU), AudioDecoder(Coding.PCMU)
    loud = frames(tone(500.0, 0.2, amplitude=40.0))
    found = joined(decoder.decode(payload) for frame in loud for payload in encoder.encode(frame))
    assert 0.9 < np.abs(found).max() <= 1.0


@settings(deadline=None)
@given(st.sampled_from(Coding), st.binary(max_size=1500))
def test_any_payload_is_sound_of_limited_length_or_is_refused(coding, payload):
    decoder = AudioDecoder(coding)
    sound = np.zeros(0)
    with suppress(ProtocolError):
        sound = decoder.decode(payload)
    assert len(sound) <= MAX_PACKET_TIME * SAMPLE_RATE
    assert np.isfinite(sound).all()
    (frame, *_) = frames(tone(700.0, 0.1))
    for whole in AudioEncoder(coding).encode(frame):
        assert len(decoder.decode(whole)), "it still decodes afterwards"
