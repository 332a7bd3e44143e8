"""Puts the packets of one RTP stream in order, and conceals those that are lost. Import it after `need_audio`.

A lost packet is replaced by the sound before it, which fades out (as G.711 Appendix I does, without its search for the
pitch); FFmpeg's decoder of Opus has no concealment of its own.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping
from typing import Final

import numpy as np

from jauspy.audio.coding import FRAME, AudioDecoder, Sound
from jauspy.errors import ProtocolError
from jauspy.platform.sound import Coding
from jauspy.video.rtp import RtpPacket

REORDER: Final = 3
"""Later packets that are kept while an earlier one is missing, until it counts as lost: 60 ms."""
MAX_GAP: Final = 25
"""Lost packets in a row that are concealed, 0.5 s; after a larger step the stream begins again."""
FADE: Final = 0.6
"""Amplitude of each concealed frame, as a factor of the one before."""

_CODINGS: Final = {coding.value: coding for coding in Coding}


def coding_of(payload_type: int) -> Coding | None:
    """The coding of a payload type; None for one that is not decoded."""
    return _CODINGS.get(payload_type)


class Playout:
    """The sound of one stream.

    Counters: `packets`, `lost` ones (each is `concealed`, but for steps of the sequence, `restarted`), `late` ones
    (duplicates, too), `not_audio`, `other_coding` (a payload type that is not decoded). Time stamps are not used.
    """

    def __init__(self) -> None:
        self._counters: Counter[str] = Counter()
        self._decoder: AudioDecoder | None = None
        self._expected: int | None = None
        self._stray: int | None = None
        """The sequence number after that of a packet far away: a second one in a row begins the stream again."""
        self._held: dict[int, RtpPacket] = {}
        self._last = np.zeros(FRAME, np.float32)
        self._gain = 0.0

    @property
    def counters(self) -> Mapping[str, int]:
        """The counters."""
        return self._counters

    def feed(self, packet: RtpPacket) -> list[Sound]:
        """The sound that is complete with this packet, in order."""
        self._counters["packets"] += 1
        if coding_of(packet.payload_type) is None:
            self._counters["other_coding"] += 1
            return []
        if self._expected is None:
            self._expected = packet.sequence
        ahead = _difference(packet.sequence, self._expected)
        if abs(ahead) > MAX_GAP + REORDER:
            if packet.sequence != self._stray:
                self._stray = (packet.sequence + 1) & 0xFFFF
                self._counters["late"] += 1
                return []
            self._counters["restarted"] += 1
            self._held.clear()
            self._expected, ahead = packet.sequence, 0
        self._stray = None
        if ahead < 0 or packet.sequence in self._held:
            self._counters["late"] += 1
            return []
        self._held[packet.sequence] = packet
        return list(self._released(REORDER))

    def end(self) -> list[Sound]:
        """The sound of the packets that wait for earlier ones."""
        return list(self._released(0))

    def _released(self, reorder: int) -> Iterator[Sound]:
        assert self._expected is not None or not self._held
        while self._held and self._expected is not None:
            packet = self._held.pop(self._expected, None)
            if packet is None and len(self._held) <= reorder:
                return
            self._expected = (self._expected + 1) & 0xFFFF
            if packet is None:
                self._counters["lost"] += 1
                yield self._conceal()
            else:
                yield self._decode(packet)

    def _decode(self, packet: RtpPacket) -> Sound:
        coding = coding_of(packet.payload_type)
        assert coding is not None
        if self._decoder is None or self._decoder.coding is not coding:
            self._decoder = AudioDecoder(coding)
        try:
            sound = self._decoder.decode(packet.payload)
        except ProtocolError as error:
            self._counters[error.reason] += 1
            return self._conceal()
        if len(sound):
            self._last, self._gain = sound, 1.0
        return sound

    def _conceal(self) -> Sound:
        self._counters["concealed"] += 1
        start, self._gain = self._gain, self._gain * FADE
        return np.asarray(self._last * np.linspace(start, self._gain, len(self._last)), np.float32)


def _difference(sequence: int, other: int) -> int:
    """Steps from one sequence number to another, -32768..32767."""
    return (sequence - other + 0x8000) % 0x10000 - 0x8000
