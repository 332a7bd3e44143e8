"""The body of a robot in MuJoCo, from its URDF."""

from __future__ import annotations

from pathlib import Path

import mujoco
from lxml import etree

from jauspy.errors import ConfigError
from jauspy.geometry.urdf import RobotDescription


def urdf_spec(description: RobotDescription) -> mujoco.MjSpec:
    """Parse the URDF without merging fixed links and without dropping visual shapes, which frames and pictures need."""
    root = etree.fromstring(description.urdf.encode())
    options = etree.SubElement(etree.SubElement(root, "mujoco"), "compiler")
    options.set("discardvisual", "false")
    options.set("fusestatic", "false")
    options.set("strippath", "false")
    assets = _name_meshes(root)
    try:
        return mujoco.MjSpec.from_string(etree.tostring(root, encoding="unicode"), assets=assets)
    except ValueError as error:
        raise ConfigError(f"MuJoCo cannot read the URDF of {description.name}: {error}") from error


def _name_meshes(root: etree._Element) -> dict[str, bytes]:
    """The files of a URDF's meshes by new names: MuJoCo takes two of one name in different directories for the same."""
    names: dict[str, str] = {}
    for mesh in root.iter("mesh"):
        path = Path(mesh.get("filename", ""))
        mesh.set("filename", names.setdefault(str(path), f"{len(names)}_{path.name}"))
    return {name: Path(path).read_bytes() for path, name in names.items()}
