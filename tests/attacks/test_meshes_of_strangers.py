"""A file author sends meshes that mean more than they say, or name files of his victim."""

from __future__ import annotations

import base64
import json
import struct
from pathlib import Path
from typing import Any, Final

import pytest

from jauspy.errors import ConfigError

pytest.importorskip("mujoco", reason="meshes need the extra 'sim'")
pytest.importorskip("trimesh", reason="meshes need the extra 'sim'")
pytest.importorskip("collada", reason="meshes need the extra 'sim'")

from jauspy_sim.models.mesh_files import read_mesh

HUGE: Final = 2_000_000_000
TRIANGLE: Final = b"v 0 0 0\nv 1 0 0\nv 0 1 0\n"


def _gltf(**changed: object) -> bytes:
    data = base64.b64encode(struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0)).decode()
    content: dict[str, Any] = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "buffers": [{"byteLength": 36, "uri": f"data:application/octet-stream;base64,{data}"}],
    }
    return json.dumps(content | changed).encode()


def _collada(nodes: str, scene: str) -> bytes:
    shape = (
        '<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="pa" count="9">0 0 0 1 0 0 0 1 0'
        '</float_array><technique_common><accessor source="#pa" count="3" stride="3"><param name="X" type="float"/>'
        '<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>'
        '<vertices id="v"><input semantic="POSITION" source="#p"/></vertices><triangles count="1">'
        '<input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles></mesh></geometry>'
        "</library_geometries>"
    )
    return (
        '<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">'
        f'{shape}<library_nodes>{nodes}</library_nodes><library_visual_scenes><visual_scene id="s">{scene}'
        '</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>'
    ).encode()


LEAF: Final = '<node id="n0"><instance_geometry url="#g"/></node>'
USE: Final = '<node><instance_node url="#n31"/></node>'
DOUBLED: Final = "".join(f'<node id="n{n}">{f"""<instance_node url="#n{n - 1}"/>""" * 2}</node>' for n in range(1, 32))
PLY: Final = "element face {}\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"
VERTICES: Final = "element vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
HOSTILE: Final = {
    "count.stl": bytes(80) + struct.pack("<I", 0xFFFFFFFF) + bytes(50),
    "lines.obj": TRIANGLE + b"f 1 2 3\n" * 2_000_000,
    "corners.obj": TRIANGLE + b"f " + b"1 2 3 " * 1_000_000,
    "count.ply": f"ply\nformat ascii 1.0\n{VERTICES.format(HUGE)}{PLY.format(1)}".encode(),
    "binary.ply": f"ply\nformat binary_little_endian 1.0\n{VERTICES.format(HUGE)}{PLY.format(HUGE)}".encode(),
    "count.gltf": _gltf(accessors=[{"bufferView": 0, "componentType": 5126, "count": HUGE, "type": "VEC3"}]),
    "zeros.gltf": _gltf(accessors=[{"componentType": 5126, "count": HUGE, "type": "VEC3"}]),
    "nodes.gltf": _gltf(nodes=[{"mesh": 0}] * 50_000, scenes=[{"nodes": list(range(50_000))}]),
    "nested.gltf": b'{"a":' + b"[" * 100_000 + b"]" * 100_000 + b"}",
    "list.gltf": b"[]",
    "others.gltf": _gltf(buffers=[{"byteLength": 36, "uri": "/etc/passwd"}]),
    "length.glb": b"glTF" + struct.pack("<IIII", 2, 0xFFFFFFFF, 0xFFFFFFF0, 0x4E4F534A) + b"{}",
    "doubled.dae": _collada(LEAF + DOUBLED, USE),
    "itself.dae": _collada('<node id="n31"><instance_node url="#n31"/></node>', USE),
    "many.dae": _collada("", '<node><instance_geometry url="#g"/></node>' * 30_000),
    "entities.dae": b"<!DOCTYPE c [<!ENTITY a 'aaaa'>]>" + _collada("", ""),
}


@pytest.mark.parametrize("name", HOSTILE)
def test_meshes_that_take_too_much_are_refused(tmp_path: Path, name: str) -> None:
    path = tmp_path / name
    path.write_bytes(HOSTILE[name])
    with pytest.raises(ConfigError) as caught:
        read_mesh(path)
    assert str(caught.value).startswith(str(path))
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("uri", ["../../secret.bin", "link.bin", ".hidden.bin"])
def test_what_a_mesh_names_is_below_its_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, uri: str) -> None:
    folder = tmp_path / "home" / "robot"
    folder.mkdir(parents=True)
    monkeypatch.setenv("HOME", str(folder.parent))
    secret = struct.pack("<9f", *range(9))
    for path in (tmp_path / "secret.bin", folder / ".hidden.bin", folder / "own.bin"):
        path.write_bytes(secret)
    (folder / "link.bin").symlink_to("../../secret.bin")
    for name, file in (("it", uri), ("right", "own.bin")):
        (folder / f"{name}.gltf").write_bytes(_gltf(buffers=[{"byteLength": 36, "uri": file}]))
    with pytest.raises(ConfigError, match="is not read"):
        read_mesh(folder / "it.gltf")


def test_honest_ones_are_read(tmp_path: Path) -> None:
    for name, content in (
        ("it.gltf", _gltf(meshes=[{"primitives": [{"attributes": {"POSITION": 0}, "mode": 4}]}])),
        ("it.dae", _collada(LEAF, '<node><instance_node url="#n0"/></node>')),
        ("it.obj", TRIANGLE + b"f 1 2 3\n"),
    ):
        (tmp_path / name).write_bytes(content)
        assert sum(len(part.faces) for part in read_mesh(tmp_path / name)) == 1, name
