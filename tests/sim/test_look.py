"""Light, materials and textures that the worlds share."""

from importlib.resources import files
from pathlib import Path

import mujoco
import numpy as np
import pytest

from jauspy_sim import rays

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
    faces = rays._faces(model, model.texture("sky").id).astype(float).sum(axis=-1)
    to_sun = -model.light("sun").dir
    face, row, column = np.unravel_index(faces.argmax(), faces.shape)
    size = faces.shape[1]
    u, v = (2.0 * (column + 0.5) / size - 1.0, 2.0 * (row + 0.5) / size - 1.0)
    assert face == 2
    seen = np.array([u, v, 1.0]) / np.linalg.norm([u, v, 1.0])
    assert float(seen @ to_sun) > 0.99


def test_all_textures_are_used(model: mujoco.MjModel) -> None:
    text = (ASSETS / "look.xml").read_text()
    unused = [
        Path(entry.name).stem for entry in ASSETS.iterdir() if entry.name.endswith(".png") and entry.name not in text
    ]
    assert unused == []
    used = {int(each) for each in model.mat_texid.ravel() if each >= 0}
    assert [model.texture(number).name for number in range(model.ntex) if number not in used] == ["sky"]
