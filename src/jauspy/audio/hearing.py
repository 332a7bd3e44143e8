"""Sound that a simulated microphone hears: a synthesis of tracks, motors, loudspeakers and tones. Needs NumPy.

Each source has a sound pressure level at a distance of 1 m, which falls by 6 dB for each doubling of the distance (a
free field: no walls, no echo, no delay). Levels are estimates of the kind of thing, not measurements of one robot:

- a track or side of wheels at v m/s: noise below 1 kHz, and a tone with the rate of its plates (5 cm) and its
  harmonics. 78 dB at 1 m/s, and 30 log10(v) as rolling noise of vehicles (ISO 3095 has this law for trains);
- a motor of a joint at w rad/s: a tone of its gear with the third harmonic. 52 dB at 1 rad/s without load, 20 log10(w),
  and 10 log10(1 + torque / 10 N m) for the load; a joint that stands is silent;
- noise all around, without a place, of the microphone's `ambient` level.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Iterator
from typing import Final, TypeAlias

import numpy as np
from numpy.typing import NDArray

from jauspy.audio.coding import FRAME, Sound
from jauspy.geometry.frames import FrameTree
from jauspy.geometry.poses import Transform
from jauspy.geometry.urdf import JointKind
from jauspy.geometry.vectors import Vector
from jauspy.platform.sound import SAMPLE_RATE
from jauspy.platform.sound_scene import MachineState, SoundScene

ROLLING_LEVEL, ROLLING_EXPONENT = 78.0, 30.0
"""dB at 1 m/s, and for each factor of ten in speed."""
PLATE: Final = 0.05
"""Metres from one plate of a track to the next."""
PLATE_LEVEL: Final = -6.0
"""dB of the plates' tone, against the noise of rolling."""
HARMONICS: Final = 4
LEAST_SPEED: Final = 0.005
"""m/s, and rad/s of a joint, below which it stands."""
MOTOR_LEVEL, LOAD = 52.0, 10.0
"""dB at 1 rad/s, and the load in N m that makes it 3 dB louder."""
GEAR_TONE: Final = 64.0
"""Hz at 1 rad/s: a gear of 100:1, and four pairs of poles."""
SLIDE: Final = 0.01
"""Metres of a joint that slides, for one radian of its motor's gear."""
LEAST_DISTANCE: Final = 0.1
"""Metres below which nothing becomes louder."""
MAX_PLAYED: Final = 25
"""Frames of a loudspeaker that wait to be heard; the oldest go first."""
NOISE_CUTOFF: Final = 1000.0
"""Hz, of the noise of tracks and of what is all around (first order)."""

_Samples: TypeAlias = NDArray[np.float64]


class Hearing:
    """Mixes what one microphone hears, frame by frame."""

    def __init__(self, scene: SoundScene) -> None:
        self._scene = scene
        self._tree = FrameTree(scene.description)
        self._state = MachineState()
        self._tracks = [_Track(scene.microphone.seed + side) for side in (1, 2)]
        self._motors = {name: _Tones(1, 3) for name in scene.joints}
        self._world = [_Tones(1) for _ in scene.tones]
        self._ambient = _Noise(scene.microphone.seed)
        self._played = {speaker.name: deque[Sound](maxlen=MAX_PLAYED) for speaker in scene.loudspeakers}
        self._place()

    def update(self, state: MachineState) -> None:
        """The robot has moved."""
        self._state = state
        self._place()

    def play(self, loudspeaker: str, frame: Sound) -> None:
        """A loudspeaker of the robot plays this frame, of 20 ms."""
        self._played[loudspeaker].append(frame)

    def frame(self) -> Sound:
        """The next 20 ms, full scale -1..1; louder sound is clipped."""
        mixed = sum(self._parts(), np.zeros(FRAME))
        return np.clip(mixed, -1.0, 1.0).astype(np.float32)

    def _parts(self) -> Iterator[_Samples]:
        yield self._ambient.samples(self._amplitude(self._scene.microphone.ambient, 1.0))
        if self._scene.half_track > 0.0:
            for side, track, speed in zip(
                (1.0, -1.0), self._tracks, (self._state.left, self._state.right), strict=True
            ):
                level = rolling_level(speed)
                distance = self._distance(self._state.base.apply((0.0, side * self._scene.half_track, 0.0)))
                yield track.samples(abs(speed) / PLATE, self._amplitude(level, distance))
        for name, tones in self._motors.items():
            speed, level = self._motor(name)
            yield tones.samples(GEAR_TONE * speed, self._amplitude(level, self._distance(self._links[name])))
        for tone, tones in zip(self._scene.tones, self._world, strict=True):
            yield tones.samples(tone.frequency, self._amplitude(tone.level, self._distance(tone.position)))
        for speaker in self._scene.loudspeakers:
            if waiting := self._played[speaker.name]:
                gain = math.sqrt(2.0) * self._amplitude(speaker.level, self._distance(self._links[speaker.name]))
                yield waiting.popleft().astype(float) * gain

    def _motor(self, name: str) -> tuple[float, float]:
        """Speed of a joint in rad/s, and its level."""
        state = self._state.joints.get(name)
        if state is None:
            return 0.0, -math.inf
        slides = self._scene.description.joints[name].kind is JointKind.PRISMATIC
        speed = abs(state.velocity) / (SLIDE if slides else 1.0)
        return speed, motor_level(speed, abs(state.effort) * (SLIDE if slides else 1.0))

    def _place(self) -> None:
        """Where everything is, in the world's frame."""
        base = self._state.base
        positions = {name: joint.position for name, joint in self._state.joints.items()}
        poses = self._tree.poses(positions)

        def place(link: str) -> Vector:
            return (base @ poses.get(link, Transform())).position

        joints = self._scene.description.joints
        self._ear = place(self._scene.microphone.link)
        self._links = {name: place(joints[name].child) for name in self._scene.joints}
        self._links |= {speaker.name: place(speaker.link) for speaker in self._scene.loudspeakers}

    def _distance(self, position: Vector) -> float:
        return max(LEAST_DISTANCE, math.dist(self._ear, position))

    def _amplitude(self, level: float, distance: float) -> float:
        """Root mean square of a source, in parts of full scale."""
        full_scale = self._scene.microphone.full_scale
        return float(10.0 ** ((level - full_scale) / 20.0) / math.sqrt(2.0) / distance)


def rolling_level(speed: float) -> float:
    """Level of a track at a speed in m/s, dB at 1 m."""
    speed = abs(speed)
    return -math.inf if speed < LEAST_SPEED else ROLLING_LEVEL + ROLLING_EXPONENT * math.log10(speed)


def motor_level(speed: float, effort: float) -> float:
    """Level of a joint's motor at a speed (rad/s) and torque (N m), dB at 1 m."""
    if speed < LEAST_SPEED:
        return -math.inf
    return MOTOR_LEVEL + 20.0 * math.log10(speed) + 10.0 * math.log10(1.0 + effort / LOAD)


class _Noise:
    """Noise below `NOISE_CUTOFF`; amplitudes change linearly within a frame."""

    def __init__(self, seed: int) -> None:
        self._random = np.random.default_rng(seed)
        self._kernel = _lowpass()
        self._rest = self._random.standard_normal(len(self._kernel) - 1)
        self._amplitude = 0.0

    def samples(self, amplitude: float) -> _Samples:
        """A frame with this root mean square at its end."""
        start, self._amplitude = self._amplitude, amplitude
        if start == amplitude == 0.0:
            return np.zeros(FRAME)
        white = np.concatenate([self._rest, self._random.standard_normal(FRAME)])
        self._rest = white[FRAME:]
        return np.convolve(white, self._kernel, "valid") * np.linspace(start, amplitude, FRAME)


def _lowpass() -> _Samples:
    """The impulse response of a first-order low-pass, cut off where it is below 1 %; noise keeps a mean square of 1."""
    decay = math.exp(-math.tau * NOISE_CUTOFF / SAMPLE_RATE)
    kernel = decay ** np.arange(math.ceil(math.log(0.01) / math.log(decay)))
    return np.asarray(kernel / np.sqrt(np.sum(kernel**2)))


class _Tones:
    """A tone with harmonics, of continuous phase; amplitude and frequency change linearly within a frame."""

    def __init__(self, *harmonics: int) -> None:
        self._harmonics = harmonics
        self._phase = self._frequency = self._amplitude = 0.0

    def samples(self, frequency: float, amplitude: float) -> _Samples:
        """A frame with this frequency and root mean square at its end."""
        before, start = self._frequency, self._amplitude
        self._frequency, self._amplitude = frequency, amplitude
        if start == amplitude == 0.0:
            return np.zeros(FRAME)
        phases = self._phase + np.cumsum(np.linspace(before, frequency, FRAME)) * (math.tau / SAMPLE_RATE)
        self._phase = float(phases[-1] % math.tau)
        audible = [number for number in self._harmonics if number * frequency < SAMPLE_RATE / 2.0]
        weight = math.sqrt(sum(1.0 / number for number in self._harmonics) / 2.0)
        wave = sum((np.sin(number * phases) / math.sqrt(number) for number in audible), np.zeros(FRAME))
        return np.asarray(wave / weight * np.linspace(start, amplitude, FRAME))


class _Track:
    """The noise of rolling, and the tone of the plates."""

    def __init__(self, seed: int) -> None:
        self._noise, self._tones = _Noise(seed), _Tones(*range(1, HARMONICS + 1))

    def samples(self, frequency: float, amplitude: float) -> _Samples:
        """A frame with this rate of the plates (Hz) and root mean square of the noise."""
        tones = self._tones.samples(frequency, amplitude * 10.0 ** (PLATE_LEVEL / 20.0))
        return self._noise.samples(amplitude) + tones
