"""What a simulated microphone hears: levels by speed, load and distance."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

pytest.importorskip("numpy", reason="the extra 'video' is not installed")
pytest.importorskip("av", reason="the extra 'video' is not installed")

import numpy as np
from tests.audio.signals import frames, joined, level, strongest, tone
from tests.helpers.robot import described

from jauspy.audio.coding import FRAME
from jauspy.audio.hearing import GEAR_TONE, MAX_PLAYED, PLATE, Hearing
from jauspy.geometry.poses import Pose, Transform
from jauspy.platform.sound import ToneSetup
from jauspy.platform.sound_scene import MachineState, MotorState, SoundScene


@pytest.fixture(scope="module")
def scene():
    _, model = described("inc1")
    (microphone,) = model.microphones
    return SoundScene.of(model, replace(microphone, ambient=0.0))


def heard(hearing, state, count=50):
    hearing.update(state)
    return joined(hearing.frame() for _ in range(count))[10 * FRAME :]


def test_standing_robot_is_as_loud_as_what_is_around(scene):
    loud = replace(scene, microphone=replace(scene.microphone, ambient=50.0))
    assert level(heard(Hearing(scene), MachineState())) < -100.0
    assert level(heard(Hearing(loud), MachineState())) == pytest.approx(50.0 - 110.0 - 3.0, abs=0.5)


def test_level_rises_with_the_speed_of_the_tracks(scene):
    levels = [level(heard(Hearing(scene), MachineState(left=speed, right=speed))) for speed in (0.1, 0.3, 1.0)]
    assert levels[1] - levels[0] == pytest.approx(30.0 * math.log10(3.0), abs=1.0)
    assert levels[2] - levels[1] == pytest.approx(30.0 * math.log10(1.0 / 0.3), abs=1.0)
    backwards = level(heard(Hearing(scene), MachineState(left=-1.0, right=-1.0)))
    assert backwards == pytest.approx(levels[2], abs=1.0)


def test_turning_on_the_spot_is_heard(scene):
    assert level(heard(Hearing(scene), MachineState(left=-0.4, right=0.4))) > -50.0


def test_plates_of_the_tracks_are_a_tone(scene):
    sound = heard(Hearing(scene), MachineState(left=2.0, right=2.0), 200)
    spectrum = np.abs(np.fft.rfft(sound * np.hanning(len(sound))))
    frequencies = np.fft.rfftfreq(len(sound), 1.0 / 48000.0)
    near = spectrum[np.abs(frequencies - 2.0 / PLATE) < 1.0].max()
    assert near > 5.0 * np.median(spectrum[np.abs(frequencies - 2.0 / PLATE) < 20.0])


def test_motor_of_a_joint_has_a_tone_of_its_speed_and_is_louder_under_load(scene):
    name = "base_link_to_arm_link_1"
    free = heard(Hearing(scene), MachineState(joints={name: MotorState(0.0, 10.0, 0.0)}))
    loaded = heard(Hearing(scene), MachineState(joints={name: MotorState(0.0, 10.0, 30.0)}))
    holding = heard(Hearing(scene), MachineState(joints={name: MotorState(0.0, 0.0, 30.0)}))
    assert strongest(free) == pytest.approx(10.0 * GEAR_TONE, abs=3.0)
    assert level(loaded) - level(free) == pytest.approx(10.0 * math.log10(4.0), abs=0.3)
    assert level(holding) < -100.0, "a joint that holds is silent"


def test_level_falls_by_6_db_for_twice_the_distance(scene):
    whistle = replace(scene, tones=(ToneSetup((0.0, 0.0, 0.0), 1000.0, 80.0),))
    levels = [
        level(heard(Hearing(whistle), MachineState(Transform.from_pose(Pose(x=distance)))))
        for distance in (2.0, 4.0, 8.0)
    ]
    assert levels[0] - levels[1] == pytest.approx(6.02, abs=0.2)
    assert levels[1] - levels[2] == pytest.approx(6.02, abs=0.2)


def test_loudspeaker_is_heard_and_what_waits_is_bounded(scene):
    hearing = Hearing(scene)
    for frame in frames(tone(700.0, 2.0)):
        hearing.play("announcer", frame)
    sound = joined(hearing.frame() for _ in range(2 * MAX_PLAYED))
    assert strongest(sound[: MAX_PLAYED * FRAME]) == pytest.approx(700.0, abs=5.0)
    assert level(sound[MAX_PLAYED * FRAME :]) < -100.0, "the rest was left out"


def test_everything_at_once_is_clipped_at_full_scale(scene):
    loud = replace(scene, tones=(ToneSetup((0.0, 0.0, 0.0), 500.0, 130.0),))
    sound = heard(Hearing(loud), MachineState(left=3.0, right=3.0))
    assert np.abs(sound).max() == 1.0


def test_phase_is_continuous_between_frames(scene):
    hearing = Hearing(replace(scene, tones=(ToneSetup((1.0, 0.0, 0.0), 997.0, 90.0),)))
    sound = heard(hearing, MachineState())
    steps = np.abs(np.diff(sound))
    assert steps.max() < 1.1 * np.abs(sound).max() * math.tau * 997.0 / 48000.0


def test_wild_states_of_the_machine_are_sound(scene):
    name = "base_link_to_arm_link_1"
    state = MachineState(left=1e9, right=-1e9, joints={name: MotorState(1e9, -1e9, 1e9)})
    assert np.isfinite(heard(Hearing(scene), state)).all()
