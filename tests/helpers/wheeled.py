"""URDF and TOML of small robots on wheels, for tests."""

from __future__ import annotations

from pathlib import Path

BOX = '<inertia ixx="{0}" iyy="{0}" izz="{0}" ixy="0" ixz="0" iyz="0"/>'
CORNERS = {"fl": (0.2, 0.22), "fr": (0.2, -0.22), "rl": (-0.2, 0.22), "rr": (-0.2, -0.22)}


def wheel(name: str, x: float, y: float, parent: str = "base") -> str:
    """A wheel; one that is steered is not driven."""
    motor = '<limit effort="20" velocity="15"/><dynamics damping="1.3" friction="0.1"/>' if parent == "base" else ""
    return f"""
  <link name="{name}">
    <inertial><mass value="1"/>{BOX.format(0.006)}</inertial>
    <collision><origin rpy="1.5708 0 0"/><geometry><cylinder radius="0.1" length="0.05"/></geometry></collision>
  </link>
  <joint name="{name}_axle" type="continuous">
    <parent link="{parent}"/><child link="{name}"/><origin xyz="{x} {y} 0.1"/><axis xyz="0 1 0"/>
    {motor}
  </joint>
  <gazebo reference="{name}"><mu1>0.9</mu1></gazebo>"""


def knuckle(name: str, x: float, y: float) -> str:
    return f"""
  <link name="{name}_knuckle"><inertial><mass value="0.5"/>{BOX.format(0.002)}</inertial></link>
  <joint name="{name}_steering" type="revolute">
    <parent link="base"/><child link="{name}_knuckle"/><origin xyz="{x} {y} 0"/><axis xyz="0 0 1"/>
    <limit lower="-0.6" upper="0.6" effort="30" velocity="2"/><dynamics damping="0.5"/>
  </joint>""" + wheel(name, 0.0, 0.0, f"{name}_knuckle")


def urdf(kind: str) -> str:
    steered = ("fl", "fr") if kind == "ackermann" else ()
    parts = [(knuckle if name in steered else wheel)(name, *at) for name, at in CORNERS.items()]
    return f"""<robot name="{kind}">
  <link name="base">
    <inertial><origin xyz="0 0 0.15"/><mass value="15"/>{BOX.format(0.4)}</inertial>
    <collision><origin xyz="0 0 0.18"/><geometry><box size="0.5 0.2 0.12"/></geometry></collision>
  </link>{"".join(parts)}
</robot>"""


def toml(kind: str) -> str:
    driven = (["rl_axle"], ["rr_axle"]) if kind == "ackermann" else (["fl_axle", "rl_axle"], ["fr_axle", "rr_axle"])
    steered = ["fl_steering", "fr_steering"] if kind == "ackermann" else []
    return f"""
name = "{kind}"
urdf = "{kind}.urdf"
subsystem = 106
node = 1

[wheels]
type = "{kind}"
left = {driven[0]}
right = {driven[1]}
steered = {steered}

[[modules]]
type = "CM-MOB"
component = 102
"""


def write(folder: Path, kind: str) -> Path:
    """Write both files; the path of the TOML file."""
    (folder / f"{kind}.urdf").write_text(urdf(kind))
    (folder / f"{kind}.toml").write_text(toml(kind))
    return folder / f"{kind}.toml"
