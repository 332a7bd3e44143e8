"""Contacts of a robot at its initial pose: links that touch each other, and the depth below the ground.

Convex hulls of meshes overlap where the links do not.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

import mujoco
import numpy as np

from jauspy.errors import ConfigError
from jauspy.geometry.urdf import RobotDescription
from jauspy_sim.models.urdf import body_name

CORNERS: Final = np.array([(x, y, z) for x in (-1.0, 1.0) for y in (-1.0, 1.0) for z in (-1.0, 1.0)])

TOLERANCE: Final = 0.01
"""Metres that a robot may be in the ground where it starts."""

MARGIN: Final = 0.002
"""Metres: hulls that are nearer count as touching."""


def depth_below_base(spec: mujoco.MjSpec, description: RobotDescription, start: Mapping[str, float]) -> float:
    """How far the lowest shape that collides is below the base, in metres; 0 for a robot that stands on its base."""
    model, data = _posed(spec, description, start)
    lowest = 0.0
    for geom in np.flatnonzero(model.geom_contype).tolist():
        turn, place = data.geom_xmat[geom].reshape(3, 3), data.geom_xpos[geom]
        mesh = model.geom_dataid[geom]
        if model.geom_type[geom] == mujoco.mjtGeom.mjGEOM_MESH:
            begin = model.mesh_vertadr[mesh]
            points = model.mesh_vert[begin : begin + model.mesh_vertnum[mesh]]
        else:
            middle, half = model.geom_aabb[geom][:3], model.geom_aabb[geom][3:]
            points = middle + half * CORNERS
        lowest = min(lowest, float((points @ turn.T + place)[:, 2].min()))
    return -lowest if lowest < -TOLERANCE else 0.0


def _posed(
    spec: mujoco.MjSpec, description: RobotDescription, start: Mapping[str, float]
) -> tuple[mujoco.MjModel, mujoco.MjData]:
    try:
        model = spec.copy().compile()
    except ValueError as error:
        raise ConfigError(f"MuJoCo cannot simulate {description.name}: {' '.join(str(error).split())}") from error
    data = mujoco.MjData(model)
    for joint in description.joints.values():
        if (joint.mimics or joint.name) in start:
            data.qpos[model.joint(joint.name).qposadr[0]] = joint.position(start)
    mujoco.mj_kinematics(model, data)
    mujoco.mj_comPos(model, data)
    return model, data


def exclude_touching(spec: mujoco.MjSpec, description: RobotDescription, start: Mapping[str, float]) -> None:
    """Exclude contacts between neighbours, and between links that touch where the robot starts.

    Only of robots with meshes that collide: others have shapes that were chosen for that. MuJoCo itself excludes
    neighbours except those of a base that is fixed to the world.
    """
    if not any(geom.type == mujoco.mjtGeom.mjGEOM_MESH and geom.contype for geom in spec.geoms):
        return
    model, data = _posed(spec, description, start)
    model.geom_margin[:] = MARGIN
    mujoco.mj_collision(model, data)
    pairs = {tuple(sorted(model.geom_bodyid[list(contact.geom)].tolist())) for contact in data.contact}
    moving = np.flatnonzero(model.body_jntnum)
    for body in moving.tolist():
        above = model.body_weldid[model.body_parentid[body]]
        group = np.flatnonzero(model.body_weldid == body)
        for one in np.flatnonzero(model.body_weldid == above).tolist():
            pairs |= {tuple(sorted((one, other))) for other in group.tolist()}
    names = [model.body(number).name for number in range(model.nbody)]
    solid = {body_name(link) for link in description.links()}
    for one, other in sorted(pairs):
        if names[one] in solid and names[other] in solid:
            spec.add_exclude(bodyname1=names[one], bodyname2=names[other])
