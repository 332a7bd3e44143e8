"""Colours and textures of SDF visuals."""

from __future__ import annotations

from pathlib import Path

import pytest
from lxml import etree

pytest.importorskip("mujoco", reason="MuJoCo is not installed")

from jauspy.errors import ConfigError
from jauspy_sim.models.shapes import Look
from jauspy_sim.worlds.model_paths import ModelPaths
from jauspy_sim.worlds.sdf_materials import GAZEBO, look_of

SCRIPT = """
material Acme/Grass : Acme/Base
{
  technique
  {
    pass
    {
      diffuse 0.1 0.2 0.3 1
      texture_unit
      {
        texture grass.png
      }
    }
  }
}

material Acme/Paint
{
  technique
  {
    pass
    {
      ambient 1 1 1 1
      diffuse 0.1 0.2 0.3 1
    }
  }
}

material Acme/Bare
{
}
"""


@pytest.fixture
def world(tmp_path: Path) -> Path:
    """A world's file beside a model with scripts and textures, as in Gazebo classic."""
    materials = tmp_path / "hall" / "materials"
    for name in ("scripts", "textures"):
        (materials / name).mkdir(parents=True)
    (materials / "scripts" / "hall.material").write_text(SCRIPT)
    (materials / "textures" / "grass.png").write_bytes(b"")
    return tmp_path / "hall.sdf"


def look(world: Path, material: str, more: str = "") -> Look:
    visual = etree.fromstring(f"<visual><material>{material}</material>{more}</visual>")
    return look_of(visual, ModelPaths(environment={}), world)


def script(name: str, *uris: str) -> str:
    return f"<script>{''.join(f'<uri>{uri}</uri>' for uri in uris)}<name>{name}</name></script>"


@pytest.mark.parametrize(
    ("material", "colour"),
    [
        ("", None),
        ("<ambient>0.2 0.4 0.6 1</ambient>", (0.2, 0.4, 0.6, 1.0)),
        ("<ambient>0.2 0.4 0.6 1</ambient><diffuse>1 0 0</diffuse>", (1.0, 0.0, 0.0, 1.0)),
        ("<diffuse>2 -1 0.5 0.5</diffuse>", (1.0, 0.0, 0.5, 0.5)),
        ("<diffuse>red</diffuse>", None),
        ("<diffuse>0.1 0.2</diffuse>", None),
        (script("Gazebo/Blue"), (*GAZEBO["Blue"], 1.0)),
        (script("Gazebo/Blue") + "<diffuse>1 1 0 1</diffuse>", (1.0, 1.0, 0.0, 1.0)),
        (script("Gazebo/NotThere", "file://media/materials/scripts/gazebo.material"), None),
    ],
)
def test_colours(world: Path, material: str, colour: tuple[float, ...] | None) -> None:
    assert look(world, material) == Look(colour)


def test_transparency_is_that_of_the_visual(world: Path) -> None:
    found = look(world, "<diffuse>1 0 0 1</diffuse>", "<transparency>0.75</transparency>")
    assert found.colour == (1.0, 0.0, 0.0, 0.25)


def test_what_gives_light_has_its_colour(world: Path) -> None:
    glowing = look(world, "<emissive>0.2 0.8 0 1</emissive>")
    assert (glowing.colour, glowing.emission) == ((0.2, 0.8, 0.0, 1.0), 0.8)
    assert look(world, "<diffuse>1 1 1 1</diffuse><emissive>0 0 0 1</emissive>").emission == 0.0


def test_scripts_give_a_texture_or_a_colour(world: Path) -> None:
    uris = ("model://hall/materials/scripts", "model://hall/materials/textures")
    grass = look(world, script("Acme/Grass", *uris))
    assert (grass.colour, grass.texture) == (None, world.parent / "hall/materials/textures/grass.png")
    alone = look(world, script("Acme/Grass", "model://hall/materials/scripts/hall.material"))
    assert alone.texture == grass.texture, "textures are beside the folder of the script"
    assert look(world, script("Acme/Paint", *uris)) == Look((0.1, 0.2, 0.3, 1.0))
    assert look(world, script("Acme/Bare", *uris)) == look(world, script("Acme/Unknown", *uris)) == Look()


def test_an_albedo_texture_is_not_painted_black(world: Path) -> None:
    albedo = "<pbr><metal><albedo_map>model://hall/materials/textures/grass.png</albedo_map></metal></pbr>"
    found = look(world, f"<diffuse>0 0 0 1</diffuse>{albedo}")
    assert (found.colour, found.texture) == (None, world.parent / "hall/materials/textures/grass.png")
    with pytest.raises(ConfigError, match=r"model://hall/none\.png: is not found"):
        look(world, "<pbr><metal><albedo_map>model://hall/none.png</albedo_map></metal></pbr>")
