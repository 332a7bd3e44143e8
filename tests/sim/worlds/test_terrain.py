"""Height fields for rays: the twin has the same surface."""

import math

import pytest

pytest.importorskip("mujoco", reason="MuJoCo is not installed")

import mujoco
import numpy as np

from jauspy.robot.robot_files import load, robot_model
from jauspy_sim.assembly import build
from jauspy_sim.models.groups import HEIGHT_FIELDS, RAY_MESHES
from jauspy_sim.physics.sensors import cast_rays


def test_ray_mesh_and_height_field_give_equal_distances() -> None:
    model = build(robot_model(load("inc1")), "rough")
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    random = np.random.default_rng(3)
    field = np.array([group == HEIGHT_FIELDS for group in range(mujoco.mjNGROUP)], np.uint8)
    found, met = np.zeros(1, np.int32), 0
    for _ in range(50):
        start = np.array([*random.uniform(-8.0, 8.0, 2), 0.6])
        angles = random.uniform(-math.pi, math.pi, 20)
        rays = np.stack([np.cos(angles), np.sin(angles), random.uniform(-0.5, 0.1, 20)], axis=1)
        rays /= np.linalg.norm(rays, axis=1, keepdims=True)
        for ray, distance in zip(rays, cast_rays(model, data, start, rays), strict=True):
            true = mujoco.mj_ray(model, data, start, ray, field, 1, -1, found)
            if 0.0 <= true < 10.0:
                assert distance == pytest.approx(true, abs=1e-4)
                met += 1
    assert met > 300


def test_ray_mesh_neither_collides_nor_is_drawn() -> None:
    model = build(robot_model(load("inc1")), "rough")
    (twin,) = np.flatnonzero(model.geom_group == RAY_MESHES)
    (field,) = np.flatnonzero(model.geom_type == mujoco.mjtGeom.mjGEOM_HFIELD)
    assert model.geom_contype[twin] == model.geom_conaffinity[twin] == 0
    assert model.geom_group[field] == HEIGHT_FIELDS
    assert model.geom_contype[field]
    assert (model.geom_rgba[twin] == model.geom_rgba[field]).all()
    assert model.geom_matid[twin] == model.geom_matid[field]
