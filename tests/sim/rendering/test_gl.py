"""Shapes that a picture does not show are not drawn; those that it shows are."""

from __future__ import annotations

import pytest

pytest.importorskip("mujoco", reason="MuJoCo is not installed")

import mujoco
import numpy as np

from jauspy_sim.rendering.gl import HIDDEN, Culling
from jauspy_sim.worlds.lighting import FLOOR_MESH, draw_floors_as_meshes

WORLD = """
<mujoco>
  <asset><material name="stone" rgba="0.5 0.5 0.5 1"/><material name="pane" rgba="0.5 0.5 0.5 0.5"/></asset>
  <worldbody>
    <geom name="floor" type="plane" size="0 0 1" material="stone"/>
    <geom name="ahead" type="sphere" size="0.1" pos="3 0 0"/>
    <geom name="behind" type="sphere" size="0.1" pos="-3 0 0"/>
    <geom name="beside" type="sphere" size="0.1" pos="3 4 0"/>
    <geom name="half" type="sphere" size="0.3" pos="3 3.2 0"/>
    <geom name="window" type="box" size="0.1 0.1 0.1" pos="2 0 0" material="pane"/>
    <geom name="slab" type="box" size="2 2 0.01" pos="4 0 0"/>
    <geom name="roof" type="box" size="2 2 0.01" pos="4 0 2"/>
  </worldbody>
</mujoco>
"""


@pytest.fixture
def world() -> tuple[mujoco.MjModel, mujoco.MjData]:
    model = mujoco.MjModel.from_xml_string(WORLD)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    return model, data


def shown(model: mujoco.MjModel) -> set[str]:
    return {model.geom(number).name for number in np.flatnonzero(model.geom_group != HIDDEN)}


def test_hides_what_is_behind_and_beside(world: tuple[mujoco.MjModel, mujoco.MjData]) -> None:
    model, data = world
    culling = Culling(model)
    culling.hide_unseen(data, np.zeros(3), np.eye(3), (1.0, 0.5))
    assert shown(model) >= {"floor", "ahead", "half", "window", "slab"}
    assert not shown(model) & {"behind", "beside"}
    culling.show_all()
    assert len(shown(model)) == model.ngeom


def test_what_casts_no_shadow_is_hidden_from_the_sun(world: tuple[mujoco.MjModel, mujoco.MjData]) -> None:
    model, data = world
    culling = Culling(model)
    down = np.array([[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]])
    culling.hide_unseen(data, np.array([3.0, 0.0, 10.0]), down, (2.0, 2.0), parallel=True)
    culling.hide_shadowless()
    assert shown(model) == {"ahead", "roof"}


def test_an_endless_floor_is_drawn_as_a_mesh_at_its_height() -> None:
    spec = mujoco.MjSpec.from_string(WORLD)
    draw_floors_as_meshes(spec)
    model = spec.compile()
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    assert model.geom("floor").group[0] == HIDDEN
    mesh = model.mesh(FLOOR_MESH).id
    (drawn,) = np.flatnonzero((model.geom_type == mujoco.mjtGeom.mjGEOM_MESH) & (model.geom_dataid == mesh))
    begin, count = model.mesh_vertadr[mesh], model.mesh_vertnum[mesh]
    corners = model.mesh_vert[begin : begin + count] @ data.geom_xmat[drawn].reshape(3, 3).T + data.geom_xpos[drawn]
    assert np.abs(corners[:, 2]).max() < 1e-3
    assert corners[:, :2].min() < -300.0
    assert corners[:, :2].max() > 300.0
    assert model.geom_contype[drawn] == 0
