"""Antennas that swing in pictures: how far, how often, and that they come to rest."""

from __future__ import annotations

import math

import pytest

pytest.importorskip("mujoco", reason="MuJoCo is not installed")

import mujoco
import numpy as np
from lxml import etree

from jauspy.errors import ConfigError
from jauspy.robot.robot_files import load, robot_model
from jauspy_sim.assembly import build
from jauspy_sim.models.whips import DAMPING, MAX_SWING, WHIP, Whips, mark_whip

FREQUENCY, LENGTH = 2.0, 0.5
PERIOD = 0.02


def whip() -> mujoco.MjModel:
    """A body that moves freely, with an antenna on it."""
    spec = mujoco.MjSpec()
    body = spec.worldbody.add_body()
    body.add_freejoint()
    geom = body.add_geom(
        type=mujoco.mjtGeom.mjGEOM_CAPSULE, fromto=(0.1, 0.0, 0.2, 0.1, 0.0, 0.2 + LENGTH), size=(0.003, 0.0, 0.0)
    )
    mark_whip(
        geom,
        etree.fromstring(
            f'<visual whip_frequency="{FREQUENCY}" whip_length="{LENGTH}"><origin xyz="0.1 0 0.2"/></visual>'
        ),
    )
    return spec.compile()


class Driven:
    """The antenna on a body that drives along x, seen in pictures."""

    def __init__(self) -> None:
        self.model = whip()
        self.data, self.whips = mujoco.MjData(self.model), Whips(self.model)
        self.now = 50.0

    def look(self, x: float) -> float:
        """Metres by which the antenna's middle is ahead of its foot, in a picture with the body at x."""
        self.now += PERIOD
        self.data.qpos[0] = x
        mujoco.mj_kinematics(self.model, self.data)
        self.whips.place(self.data, self.now)
        return float(self.data.geom_xpos[0, 0] - x - 0.1)


def test_is_at_rest_while_the_robot_stands_or_drives_steadily() -> None:
    driven = Driven()
    assert [driven.look(1.0) for _ in range(10)] == pytest.approx([0.0] * 10, abs=1e-9)
    steady = [driven.look(1.0 + 0.5 * PERIOD * step) for step in range(1, 400)]
    assert steady[-1] == pytest.approx(0.0, abs=1e-5)


def test_a_stop_makes_it_swing_ahead_with_its_frequency_until_it_rests() -> None:
    driven, speed = Driven(), 0.4
    for step in range(400):
        driven.look(speed * PERIOD * step)
    swings = np.array([driven.look(speed * PERIOD * 399) for _ in range(200)])
    first = int(swings.argmax())
    assert swings[: first + 1].min() >= -1e-6, "ahead first"
    # its end keeps its speed v: the amplitude is v/w, less what a quarter of an oscillation damps
    amplitude = speed / (math.tau * FREQUENCY) * math.exp(-DAMPING * math.pi / 2.0)
    assert 2.0 * swings[first] == pytest.approx(amplitude, rel=0.05)
    crossings = np.flatnonzero(np.diff(np.sign(swings[first:60]))) * PERIOD
    assert np.diff(crossings)[0] == pytest.approx(0.5 / FREQUENCY, abs=PERIOD)
    assert np.abs(swings[-20:]).max() < 0.02 * swings[first]


def test_keeps_its_length_and_foot_however_hard_it_is_shaken() -> None:
    driven = Driven()
    for step in range(100):
        driven.look(2.0 * (step % 2))
        axis = driven.data.geom_xmat[0].reshape(3, 3)[:, 2].copy()
        axis *= np.sign(axis[2])
        foot = driven.data.geom_xpos[0] - 0.5 * LENGTH * axis
        assert foot == pytest.approx([driven.data.qpos[0] + 0.1, 0.0, 0.2], abs=1e-6)
        assert axis[2] > math.cos(math.atan(MAX_SWING)) - 1e-6


def test_a_pause_of_the_camera_leaves_it_at_rest() -> None:
    driven = Driven()
    for step in range(20):
        driven.look(0.5 * PERIOD * step)
    driven.now += 30.0
    assert driven.look(20.0) == pytest.approx(0.0, abs=1e-9)
    assert driven.look(20.0) == pytest.approx(0.0, abs=1e-9)


def test_both_antennas_of_inc1_swing_and_nothing_else() -> None:
    model = build(robot_model(load("inc1")), "empty")
    marked = np.flatnonzero(model.geom_user[:, 0] == WHIP)
    assert len(marked) == 4, "whip and spring of each"
    assert {model.body(int(body)).name for body in model.geom_bodyid[marked]} == {"inc1/base_link"}
    data, whips = mujoco.MjData(model), Whips(model)
    mujoco.mj_kinematics(model, data)
    for step in range(3):
        data.qpos[0] = 0.02 * step
        mujoco.mj_kinematics(model, data)
        whips.place(data, 0.05 * step)
    mujoco.mj_kinematics(model, data)
    still = data.geom_xpos.copy()
    whips.place(data, 0.15)
    changed = np.flatnonzero(np.abs(data.geom_xpos - still).max(axis=1) > 1e-4)
    assert set(changed.tolist()) <= set(marked.tolist())
    assert len(changed) >= 2


@pytest.mark.parametrize(
    "attributes", ['whip_length="0.3"', 'whip_frequency="3"', 'whip_frequency="99" whip_length="1"']
)
def test_attributes_without_sense_are_refused(attributes: str) -> None:
    spec = mujoco.MjSpec()
    geom = spec.worldbody.add_geom(size=(0.1, 0.1, 0.1))
    with pytest.raises(ConfigError, match=r"whip_frequency and whip_length: must be 0\.1\.\.20 Hz"):
        mark_whip(geom, etree.fromstring(f"<visual {attributes}/>"))
