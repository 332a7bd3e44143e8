"""A file author sends a world in MJCF or SDF that names files of his victim, or means much more than it says."""

from __future__ import annotations

from pathlib import Path
from typing import Final

import pytest

from jauspy.errors import ConfigError

pytest.importorskip("mujoco", reason="worlds need the extra 'sim'")

from jauspy_sim.worlds import mjcf_files
from jauspy_sim.worlds.world_files import MAX_ITERATIONS, world_spec

BODY: Final = '<worldbody><body><joint name="j"/><geom size="1"/></body></worldbody>'
GEOM: Final = '<geom size="1"/>'
LARGE: Final = "2000000000"
COSTLY: Final = {
    "a replicate": f'<worldbody><replicate count="1000000000" offset="0 0 1">{GEOM}</replicate></worldbody>',
    "replicates in each other": "<worldbody>"
    + '<replicate count="1000">' * 4
    + GEOM
    + "</replicate>" * 4
    + "</worldbody>",
    "a replicate of no number": f'<worldbody><replicate count="0x7fffffff">{GEOM}</replicate></worldbody>',
    "a grid": '<worldbody><flexcomp name="f" type="grid" count="10000 10000 1" spacing="1 1 1" dim="2"/></worldbody>',
    "many elements": f"<worldbody>{GEOM * 60_000}</worldbody>",
    "a texture": '<asset><texture name="t" type="2d" builtin="flat" width="1000000" height="1000000"/></asset>',
    "a height field": '<asset><hfield name="h" nrow="100000" ncol="100000" size="1 1 1 1"/></asset>',
    "an arena": '<size memory="1T"/>',
    "data of geometries": f'<size nuser_geom="{LARGE}"/><worldbody>{GEOM}</worldbody>',
    "data of a user": f'<size nuserdata="{LARGE}"/>',
    "an activation": f'{BODY}<actuator><general joint="j" actdim="{LARGE}" dyntype="user"/></actuator>',
    "a sensor": f'<sensor><user dim="{LARGE}"/></sensor>',
    "a shape": '<asset><mesh name="m" builtin="supersphere" params="100000 1 1"/></asset>'
    '<worldbody><geom type="mesh" mesh="m"/></worldbody>',
}
"""Each takes terabytes or days."""


def _refusal(path: Path) -> str:
    with pytest.raises(ConfigError) as caught:
        world_spec(str(path))
    text = str(caught.value)
    assert text.isprintable()
    assert len(text) < 1000
    return text


@pytest.fixture
def world(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The path of a world, beside files of its victim."""
    folder = tmp_path / "home" / "world"
    (folder / "textures").mkdir(parents=True)
    for secret in (tmp_path / "home" / "secret.png", tmp_path / "home" / "secret.obj", folder / ".secret.png"):
        secret.write_text("v 0 0 0\n")
    (folder / "link.png").symlink_to("../secret.png")
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    return folder / "it.xml"


@pytest.mark.slow
@pytest.mark.parametrize("content", COSTLY.values(), ids=COSTLY.keys())
def test_worlds_that_take_too_much(world: Path, monkeypatch: pytest.MonkeyPatch, content: str) -> None:
    monkeypatch.setattr(mjcf_files, "MAX_MEMORY", 2 << 30)
    world.write_text(f"<mujoco>{content}</mujoco>")
    assert any(said in _refusal(world) for said in ("more than", "is not a number"))


NAMES: Final = {
    "absolute": '<texture name="t" type="2d" file="{home}/secret.png"/>',
    "above": '<texture name="t" type="2d" file="../secret.png"/>',
    "link": '<texture name="t" type="2d" file="link.png"/>',
    "hidden": '<texture name="t" type="2d" file=".secret.png"/>',
    "a side of a cube": '<texture name="t" type="cube" fileup="../secret.png"/>',
    "mesh": '<mesh name="m" file="../secret.obj"/>',
    "mesh of another kind": '<mesh name="m" file="{home}/secret.png" content_type="model/obj"/>',
    "device": '<mesh name="m" file="/dev/zero" content_type="model/obj"/>',
    "height field": '<hfield name="h" file="../secret.png" size="1 1 1 1"/>',
    "another model": '<model name="m" file="../secret.obj"/>',
}


@pytest.mark.parametrize("element", NAMES.values(), ids=NAMES.keys())
def test_worlds_that_name_files_of_others(world: Path, element: str) -> None:
    world.write_text(f"<mujoco><asset>{element.format(home=Path.home())}</asset></mujoco>")
    assert "is not read, because" in _refusal(world) or "is not XML" in _refusal(world)


@pytest.mark.parametrize("folder", ["{home}", "..", "textures/../.."])
@pytest.mark.parametrize("key", ["texturedir", "assetdir"])
def test_worlds_whose_directories_are_those_of_others(world: Path, key: str, folder: str) -> None:
    (world.parent / "more.xml").write_text(
        '<mujoco><asset><texture name="t" type="2d" file="secret.png"/></asset></mujoco>'
    )
    compiler = f'<compiler {key}="{folder.format(home=Path.home())}"/>'
    world.write_text(f'<mujoco>{compiler}<include file="more.xml"/></mujoco>')
    assert "is not read, because" in _refusal(world)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ('<mujoco><extension><plugin plugin="mujoco.sdf.torus"/></extension></mujoco>', "plugins of MuJoCo"),
        ('<!DOCTYPE m [<!ENTITY e "x">]><mujoco>&e;</mujoco>', "has a <!DOCTYPE"),
        ('<?xml version="1.0" encoding="utf-7"?><mujoco/>', "encoding|is not XML"),
        ('<mujoco><include file="it.xml"/></mujoco>', "cannot read it"),
        ("<mujoco>" + "<worldbody>" * 5000 + "</worldbody>" * 5000 + "</mujoco>", "is not XML|cannot read it"),
    ],
)
def test_worlds_that_are_more_than_data(world: Path, text: str, said: str) -> None:
    world.write_text(text)
    assert any(part in _refusal(world) for part in said.split("|"))


@pytest.mark.slow
def test_a_world_cannot_make_each_step_last_for_ever(world: Path) -> None:
    world.write_text(
        f'<mujoco><option iterations="{LARGE}" noslip_iterations="{LARGE}"/><visual><global offwidth="1000000"/>'
        f'<quality numslices="1000000"/></visual>{BODY}</mujoco>'
    )
    spec = world_spec(str(world))
    assert spec.option.iterations == spec.option.noslip_iterations == MAX_ITERATIONS
    assert spec.visual.global_.offwidth < 10_000
    assert spec.visual.quality.numslices < 1000


SDF: Final = """<sdf version="1.9"><world name="w">{}</world></sdf>"""
VISUAL: Final = '<model name="m"><static>1</static><link name="l"><visual name="v">{}</visual></link></model>'


@pytest.mark.parametrize(
    "uri",
    [
        "../secret.obj",
        "{home}/secret.obj",
        "file://{home}/secret.obj",
        "file://../secret.obj",
        "file://link.png",
        "model://home/secret.obj",
    ],
)
def test_sdf_that_names_files_of_others(world: Path, uri: str) -> None:
    mesh = f"<geometry><mesh><uri>{uri.format(home=Path.home())}</uri></mesh></geometry>"
    path = world.with_suffix(".sdf")
    path.write_text(SDF.format(VISUAL.format(mesh)))
    assert "is not read, because" in _refusal(path)
    with pytest.raises(ConfigError, match="is not read, because"):
        world_spec(str(path), [str(Path.home()), str(Path.home().parent)])


@pytest.mark.parametrize("name", ["../secret.png", "link.png", ".secret.png"])
def test_lists_of_objects_that_name_files_of_others(world: Path, name: str) -> None:
    path = world.with_suffix(".toml")
    for text in (f'[ground]\nheight_map = "{name}"\n', f'[ground]\ntexture = "{name}"\n'):
        path.write_text(text)
        assert "is not read, because" in _refusal(path)
