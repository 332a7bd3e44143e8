"""Checks the file of a mesh before it is read: what it takes can be much more than its bytes."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Final

from lxml import etree

from jauspy.errors import ConfigError

MAX_LINES: Final = 2_000_000
"""Most lines of a mesh in text."""
MAX_LINE: Final = 10_000
"""Characters; a face may have some hundred corners."""
MAX_INSTANCES: Final = 5_000
"""Nodes with meshes, with those that nodes stand for."""
MAX_NUMBERS: Final = 50_000_000
"""Most elements of all arrays in a glTF file, which may be left out where they are zero."""
_COMPONENTS: Final = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9, "MAT4": 16}


def check_mesh(path: Path, kind: str, data: bytes) -> None:
    """Raise `ConfigError` for a mesh that takes too much time or memory."""
    try:
        match kind:
            case "obj":
                reason = _of_lines(data)
            case "gltf":
                reason = _of_gltf(data)
            case "glb":
                reason = _of_gltf(data[20 : 20 + int.from_bytes(data[12:16], "little")])
            case "dae":
                reason = _of_collada(data)
            case _:
                reason = ""
    except etree.XMLSyntaxError as error:
        reason = f"it is not XML: {error.msg}"
    except (ValueError, TypeError, AttributeError, KeyError, RecursionError) as error:
        reason = " ".join(str(error).split())[:200] or type(error).__name__
    if reason:
        raise ConfigError(f"{path}: is not read as a mesh: {reason}")


def _of_lines(data: bytes) -> str:
    if data.count(b"\n") > MAX_LINES:
        return f"it has more than {MAX_LINES} lines"
    return f"a line is longer than {MAX_LINE}" if max(map(len, data.split(b"\n"))) > MAX_LINE else ""


def _of_gltf(text: bytes) -> str:
    content = json.loads(text)
    numbers = sum(
        int(accessor["count"]) * _COMPONENTS.get(accessor.get("type"), 16) for accessor in content.get("accessors", ())
    )
    if numbers > MAX_NUMBERS or any(accessor["count"] < 0 for accessor in content.get("accessors", ())):
        return f"its arrays have more than {MAX_NUMBERS} numbers"
    nodes = len(content.get("nodes", ()))
    return f"it has more than {MAX_INSTANCES} nodes" if nodes > MAX_INSTANCES else ""


def _of_collada(data: bytes) -> str:
    root = etree.fromstring(data, etree.XMLParser(resolve_entities=False, no_network=True, huge_tree=True))
    nodes = {element.get("id"): element for element in root.iter("{*}node") if element.get("id")}
    sizes: dict[str, int] = {}

    def size(name: str, around: tuple[str, ...] = ()) -> int:
        """The nodes that a node stands for; nodes that contain themselves count as too many."""
        if name in around:
            return MAX_INSTANCES + 1
        if name not in sizes and name in nodes:
            inner = nodes[name].iter("{*}instance_node")
            sizes[name] = 1 + sum(size(str(instance.get("url")).lstrip("#"), (*around, name)) for instance in inner)
        return sizes.get(name, 1)

    number = 0
    for element in root.iter("{*}instance_geometry", "{*}instance_controller", "{*}instance_node"):
        name = str(element.get("url")).lstrip("#")
        number += size(name) if str(element.tag).endswith("instance_node") else 1
    return f"it has more than {MAX_INSTANCES} nodes, or nodes in themselves" if number > MAX_INSTANCES else ""
