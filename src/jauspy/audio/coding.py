"""Sound to the payloads of RTP packets and back, by FFmpeg. Import it after `need_audio`.

Sound is an array of float32 at 48 kHz, one channel, full scale -1..1; a frame has 20 ms.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Final, TypeAlias

import av
import numpy as np
from av.audio.codeccontext import AudioCodecContext
from av.audio.frame import AudioFrame
from av.audio.resampler import AudioResampler
from av.error import FFmpegError
from numpy.typing import NDArray

from jauspy.errors import ProtocolError
from jauspy.platform.sound import SAMPLE_RATE, Coding

Sound: TypeAlias = NDArray[np.float32]

FRAME_TIME: Final = 0.02
"""Seconds of a frame: one packet."""
FRAME: Final = round(SAMPLE_RATE * FRAME_TIME)
"""Samples of a frame."""
MAX_PACKET_TIME: Final = 0.12
"""Seconds that a packet may have (RFC 6716, 3.2.5)."""
PCMU_RATE: Final = 8000
CLOCK_RATES: Final = {Coding.OPUS: SAMPLE_RATE, Coding.PCMU: PCMU_RATE}
"""Ticks per second of time stamps."""
MAX_PAYLOAD: Final = 1400
"""Bytes of a payload that is decoded; a frame of Opus has up to 1275 (RFC 6716, 3.2.1)."""

_CODECS: Final = {Coding.OPUS: "libopus", Coding.PCMU: "pcm_mulaw"}


class AudioEncoder:
    """Encodes frames; `bit_rate` in kilobits per second is for Opus only."""

    def __init__(self, coding: Coding, bit_rate: int = 48) -> None:
        self.coding, self.bit_rate = coding, bit_rate
        codec = AudioCodecContext.create(_CODECS[coding], "w")
        assert isinstance(codec, AudioCodecContext)
        codec.sample_rate, codec.layout, codec.format = CLOCK_RATES[coding], "mono", "s16"
        codec.time_base = Fraction(1, CLOCK_RATES[coding])
        if coding is Coding.OPUS:
            codec.bit_rate = 1000 * bit_rate
            codec.options = {"frame_duration": "20", "application": "audio", "packet_loss": "5"}
        self._codec = codec
        self._resampler = _resampler(coding, CLOCK_RATES[coding])
        self._samples = 0
        self._rest = np.zeros(0, np.int16)

    def encode(self, frame: Sound) -> list[bytes]:
        """The payloads of a frame of `FRAME` samples: one, or none while a filter fills."""
        samples = _to_integers(frame)
        if self._resampler is not None:
            samples = _resampled(self._resampler, samples, SAMPLE_RATE)
        self._rest = np.concatenate([self._rest, samples])
        length = round(CLOCK_RATES[self.coding] * FRAME_TIME)
        payloads = list[bytes]()
        while len(self._rest) >= length:
            packed = _packed(self._rest[:length], CLOCK_RATES[self.coding])
            packed.pts = self._samples
            self._samples += length
            self._rest = self._rest[length:]
            payloads += [bytes(packet) for packet in self._codec.encode(packed)]
        return payloads


class AudioDecoder:
    """Decodes payloads."""

    def __init__(self, coding: Coding) -> None:
        self.coding = coding
        codec = AudioCodecContext.create(_CODECS[coding], "r")
        assert isinstance(codec, AudioCodecContext)
        codec.sample_rate, codec.layout = CLOCK_RATES[coding], "mono"
        if coding is Coding.OPUS:
            codec.extradata = _opus_head()
        self._codec = codec
        self._resampler: AudioResampler | None = None

    def decode(self, payload: bytes) -> Sound:
        """The sound of a payload, of 120 ms at most; raises `ProtocolError` for what is none."""
        if not 0 < len(payload) <= MAX_PAYLOAD:
            raise ProtocolError("not_audio", f"a payload of {len(payload)} bytes")
        try:
            frames = self._codec.decode(av.Packet(payload))
        except (FFmpegError, ValueError) as error:
            raise ProtocolError("not_audio", str(error)) from error
        parts = [_from_frame(frame) for frame in frames]
        sound = np.concatenate(parts) if parts else np.zeros(0, np.float32)
        if self.coding is not Coding.OPUS:
            self._resampler = self._resampler or _resampler(self.coding, SAMPLE_RATE)
            assert self._resampler is not None
            sound = _to_floats(_resampled(self._resampler, _to_integers(sound), CLOCK_RATES[self.coding]))
        return sound[: round(SAMPLE_RATE * MAX_PACKET_TIME)]


def _opus_head() -> bytes:
    """The identification header of one channel at 48 kHz, without gain or samples to skip (RFC 7845, 5.1)."""
    return b"OpusHead" + bytes([1, 1]) + (0).to_bytes(2, "little") + SAMPLE_RATE.to_bytes(4, "little") + bytes(3)


def _resampler(coding: Coding, rate: int) -> AudioResampler | None:
    return None if coding is Coding.OPUS else AudioResampler("s16", "mono", rate)


def _resampled(resampler: AudioResampler, samples: NDArray[np.int16], rate: int) -> NDArray[np.int16]:
    if not len(samples):
        return samples
    parts = [frame.to_ndarray()[0] for frame in resampler.resample(_packed(samples, rate))]
    return np.concatenate(parts).astype(np.int16) if parts else np.zeros(0, np.int16)


def _packed(samples: NDArray[np.int16], rate: int) -> AudioFrame:
    frame = AudioFrame.from_ndarray(np.ascontiguousarray(samples)[np.newaxis], format="s16", layout="mono")
    frame.sample_rate = rate
    return frame


def _from_frame(frame: AudioFrame) -> Sound:
    """The first channel of a decoded frame."""
    samples = frame.to_ndarray()
    first = samples[0] if frame.format.is_planar else samples[0, :: len(frame.layout.channels)]
    if first.dtype == np.int16:
        return _to_floats(first.astype(np.int16))
    return np.nan_to_num(first).astype(np.float32)


def _to_integers(sound: Sound) -> NDArray[np.int16]:
    """Samples of 16 bits; what is louder than full scale is clipped."""
    return np.asarray(np.clip(np.rint(sound * 32767.0), -32768, 32767), np.int16)


def _to_floats(samples: NDArray[np.int16]) -> Sound:
    return samples.astype(np.float32) / np.float32(32768.0)
