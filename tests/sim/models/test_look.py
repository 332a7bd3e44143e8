"""Light, materials and textures that the worlds share."""

from dataclasses import replace
from importlib.resources import files
from pathlib import Path

import mujoco
import numpy as np
import pytest

from jauspy.robot.robot_files import load, robot_model
from jauspy_sim.assembly import build
from jauspy_sim.models.groups import VISUAL
from jauspy_sim.models.track_visuals import Treads
from jauspy_sim.rendering import rays
from jauspy_sim.robot import SimulatedRobot

ASSETS = files("jauspy_sim") / "worlds" / "assets"


WORLD = """<mujoco><include file="assets/look.xml"/><worldbody>
  <geom name="ground" type="plane" size="0 0 0.1" material="paving"/></worldbody></mujoco>"""


@pytest.fixture(scope="module")
def model(tmp_path_factory: pytest.TempPathFactory) -> mujoco.MjModel:
    folder = tmp_path_factory.mktemp("worlds")
    (folder / "assets").symlink_to(str(ASSETS))
    (folder / "world.xml").write_text(WORLD)
    return mujoco.MjModel.from_xml_path(str(folder / "world.xml"))


def test_one_light_is_the_sun_and_it_alone_casts_shadows(model: mujoco.MjModel) -> None:
    casting = np.flatnonzero(model.light_castshadow)
    assert [model.light(int(number)).name for number in casting] == ["sun"]
    assert model.light_type[casting[0]] == mujoco.mjtLightType.mjLIGHT_DIRECTIONAL


def test_the_sky_is_brightest_at_the_sun(model: mujoco.MjModel) -> None:
    """Shadows fall away from the sun that one sees."""
    directions = np.random.default_rng(1).normal(size=(20_000, 3))
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    brightest = directions[rays.SkyBox(model).colours(directions).sum(axis=1).argmax()]
    assert float(brightest @ -model.light("sun").dir) > 0.98


def test_all_textures_are_used(model: mujoco.MjModel) -> None:
    text = (ASSETS / "look.xml").read_text()
    unused = [
        Path(entry.name).stem for entry in ASSETS.iterdir() if entry.name.endswith(".png") and entry.name not in text
    ]
    assert unused == []
    used = {int(each) for each in model.mat_texid.ravel() if each >= 0}
    assert [model.texture(number).name for number in range(model.ntex) if number not in used] == ["sky"]


# --- robots


@pytest.mark.slow
@pytest.mark.parametrize("name", ["inc1", "inc1_pprm"])
def test_every_moving_link_of_the_robots_has_a_mesh(name: str) -> None:
    model = build(robot_model(load(name)), "empty")
    drawn = {int(model.geom_bodyid[geom]) for geom in np.flatnonzero(model.geom_type == mujoco.mjtGeom.mjGEOM_MESH)}
    assert {model.body(int(body)).name for body in set(model.jnt_bodyid) - drawn} == set()
    assert set(model.geom_group[model.geom_type == mujoco.mjtGeom.mjGEOM_MESH]) == {VISUAL}
    assert 20_000 < model.nmeshface < 80_000  # what pictures cost


def test_physics_has_no_shapes_that_are_only_seen() -> None:
    robot = robot_model(load("inc1"))
    drawn, physics = build(robot, "empty"), build(robot, "empty", drawn=False)
    assert physics.nmesh == 0
    assert physics.ngeom < drawn.ngeom
    assert set(physics.geom_group[physics.geom_bodyid > 0]) == {VISUAL}
    assert (drawn.nq, drawn.nv, drawn.ncam, drawn.nbody) == (physics.nq, physics.nv, physics.ncam, physics.nbody)
    np.testing.assert_array_equal(drawn.body_mass, physics.body_mass)
    olive = physics.geom_rgba[physics.body("inc1/base_link").geomadr[0]]
    assert tuple(np.round(olive, 2)) == (0.39, 0.42, 0.32, 1.0)  # rays show collision shapes in the colour of the link


def test_meshes_have_the_dimensions_of_what_collides() -> None:
    """After a change of the tracks' dimensions, run tools/make_robot_meshes.py."""
    model = build(robot_model(load("inc1")), "empty")
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    for link in ("inc1/left_track", "inc1/right_track", "inc1/left_flipper", "inc1/right_flipper"):
        body = model.body(link)
        geoms = range(body.geomadr[0], body.geomadr[0] + body.geomnum[0])
        seen = [geom for geom in geoms if model.geom_group[geom] == VISUAL]
        collides = [geom for geom in geoms if model.geom_group[geom] != VISUAL]
        (low, high), (least, most) = bounds(model, data, seen), bounds(model, data, collides)
        np.testing.assert_allclose(high[[0, 2]], most[[0, 2]], atol=0.004)
        if "track" in link:  # a flipper's belt goes around its joint, too
            np.testing.assert_allclose(low[[0, 2]], least[[0, 2]], atol=0.004)


def bounds(model: mujoco.MjModel, data: mujoco.MjData, geoms: list[int]) -> tuple[np.ndarray, np.ndarray]:
    """The box around shapes, in the world."""
    points = []
    for geom in geoms:
        turn, at = data.geom_xmat[geom].reshape(3, 3), data.geom_xpos[geom]
        if model.geom_type[geom] == mujoco.mjtGeom.mjGEOM_MESH:
            mesh = int(model.geom_dataid[geom])
            begin = model.mesh_vertadr[mesh]
            corners = model.mesh_vert[begin : begin + model.mesh_vertnum[mesh]]
        elif model.geom_type[geom] == mujoco.mjtGeom.mjGEOM_CYLINDER:
            radius, half = model.geom_size[geom][:2]
            turns = np.linspace(0.0, 2.0 * np.pi, 73)
            rim = np.stack([radius * np.cos(turns), radius * np.sin(turns), half + 0.0 * turns], axis=1)
            corners = np.concatenate([rim, rim * (1.0, 1.0, -1.0)])
        else:
            corners = model.geom_size[geom] * np.array(np.meshgrid(*[[-1.0, 1.0]] * 3)).reshape(3, -1).T
        points.append(corners @ turn.T + at)
    every = np.concatenate(points)
    return every.min(axis=0), every.max(axis=0)


@pytest.mark.slow
def test_treads_run_as_far_as_the_robot_drives() -> None:
    """What cameras draw: treads below stand on the ground, those above run ahead, and the sprocket turns."""
    robot = replace(robot_model(load("inc1")), lidars=(), cameras=())
    simulated = SimulatedRobot.open(robot, "empty")
    simulated.drive.set_effort(0.3, 0.0)
    simulated.advance(0.5)
    run = float(simulated.data.userdata[0])
    assert run == pytest.approx(simulated.drive.pose().x, abs=0.01)
    assert run > 0.1
    drawn = build(robot, "empty")
    assert drawn.nq == simulated.model.nq
    data = mujoco.MjData(drawn)
    data.qpos[:] = simulated.data.qpos
    mujoco.mj_kinematics(drawn, data)
    rest, attitudes = data.geom_xpos.copy(), data.geom_xmat.copy()
    data.userdata[:] = 0.009
    Treads(drawn).place(data)
    moved = data.geom_xpos - rest
    user = drawn.geom_user
    straight = (user[:, 0] > 0.0) & (user[:, 3] == 0.0)
    assert np.linalg.norm(moved[straight], axis=1) == pytest.approx([0.009] * 8)
    left = straight & (drawn.geom_bodyid == drawn.body("inc1/left_track").id)
    assert sorted(moved[left, 0]) == pytest.approx([-0.009, 0.009], abs=1e-4)
    wheels = (user[:, 0] > 0.0) & (user[:, 2] == 0.0)
    turned = [
        np.arccos((np.trace(b.reshape(3, 3) @ a.reshape(3, 3).T) - 1.0) / 2.0)
        for a, b in zip(attitudes[wheels], data.geom_xmat[wheels], strict=True)
    ]
    radii = user[wheels, 3]
    assert turned == pytest.approx(0.009 / radii, rel=1e-3)
    assert sorted(set(radii)) == pytest.approx([0.03, 0.093])  # road wheels; sprockets and idlers
    again = data.geom_xpos.copy()
    data.userdata[:] += drawn.geom_user[np.flatnonzero(straight)[0], 2]  # treads look alike
    mujoco.mj_kinematics(drawn, data)
    Treads(drawn).place(data)
    assert np.allclose(data.geom_xpos, again, atol=1e-4)
    simulated.close()
