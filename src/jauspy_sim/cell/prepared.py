"""Arms that are there before a task starts: their parts are put on each other, and the connectors attach them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Final

import mujoco

from jauspy.errors import ConfigError
from jauspy.geometry.poses import IDENTITY, Transform
from jauspy.geometry.vectors import quaternion

if TYPE_CHECKING:
    from jauspy_sim.cell.robot import SimulatedCell

GAP: Final = 0.0003
"""Metres between plates that are put on each other: contact, without overlap."""
ATTACH_TIME: Final = 0.008
"""Seconds: two control cycles."""


def put_on_each_other(
    cell: SimulatedCell, connector: str, parts: Sequence[str], errors: Mapping[str, Transform] | None = None
) -> None:
    """Put parts on a connector, each on the last one's first connector, and have them attached.

    `errors` are poses of parts on their connectors, by part. Raises `ConfigError` for a part that does not attach.
    """
    for name in parts:
        joint = cell.model.joint(name)
        position, dof = int(joint.qposadr[0]), int(joint.dofadr[0])
        pose = (
            cell.truth.connector(connector) @ Transform(position=(0.0, 0.0, GAP)) @ (errors or {}).get(name, IDENTITY)
        )
        cell.data.qpos[position : position + 7] = (*pose.position, *quaternion(pose.rotation))
        cell.data.qvel[dof : dof + 6] = 0.0
        mujoco.mj_kinematics(cell.model, cell.data)
        cell.connectors[connector].set(True)
        cell.advance(ATTACH_TIME)
        state = cell.connectors[connector].state()
        if state.attached_to != name:
            raise ConfigError(f"{name} was put on {connector} and is not attached: {state.last_error}")
        connector = f"{name}/{next(iter(cell.setup.type_of(name).connectors), '')}"
