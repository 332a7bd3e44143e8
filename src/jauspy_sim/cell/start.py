"""The initial poses of a cell's parts: the poses of the file, with random errors from a seed.

Also assembles arms before a task begins, by placing parts directly.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Final

import mujoco
import numpy as np

from jauspy.errors import ConfigError
from jauspy.geometry.poses import IDENTITY, Transform
from jauspy.geometry.vectors import Vector, Z, add, difference, dot, quaternion, rotation_about, scaled
from jauspy.platform.modular.parts import BinSetup, CellSetup, PlacedPart

if TYPE_CHECKING:
    from jauspy_sim.cell.robot import SimulatedCell

MAX_DRAWS: Final = 200
"""Random draws for one part until it does not overlap another."""

MAX_OVERLAP: Final = 0.002
"""Metres by which shapes may overlap at the start; contacts push them apart."""

MAX_FILLINGS: Final = 20
"""Attempts to fill a bin at random."""
BIN_HEIGHT: Final = 0.3
"""Metres above the floor of a bin within which a part is in it."""
DROP: Final = 0.003
"""Metres above the floor from which parts that are scattered fall."""
ASIDE: Final = 10.0
"""Metres above the ground where parts wait until their bin is filled."""

STEEP: Final = 0.1
"""Sine of a slope from which on parts slide down; they then start above the edge on which they come to rest."""

GAP: Final = 0.0003
"""Metres between plates that are put on each other: contact, without overlap."""
ATTACH_TIME: Final = 0.5
"""Seconds in which a cup must be evacuated, and a latch locked."""
POLL: Final = 0.004
"""Seconds from one look at a connector to the next."""


def disturb(model: mujoco.MjModel, data: mujoco.MjData, cell: CellSetup, random: np.random.Generator) -> None:
    """Move each part that is not fixed along its support by up to `cell.pose_error`, and turn it about the normal."""
    distance, angle = cell.pose_error
    scattered = cell.bins if cell.scatter else ()
    if not (distance or angle):
        return
    for part in cell.parts:
        if part.fixed or part.name == cell.car:
            continue
        if any(_is_in(bin, part) for bin in scattered):
            continue
        for _ in range(MAX_DRAWS):
            along, across, turn = random.uniform(-1.0, 1.0, 3).tolist()
            length = math.hypot(along, across)
            if length > 1.0:
                continue
            pose = _disturbed(cell, part, distance * along, distance * across, angle * turn)
            _write(model, data, part.name, pose)
            mujoco.mj_fwdPosition(model, data)
            if not _overlaps(model, data, part.name, MAX_OVERLAP):
                break


def scatter(model: mujoco.MjModel, data: mujoco.MjData, cell: CellSetup, random: np.random.Generator) -> None:
    """Put the parts of each bin anywhere in it, turned at will about the normal of its floor; they then slide down.

    Raises `ConfigError` if they find no room.
    """
    for bin in cell.bins:
        parts = [part for part in cell.parts if _is_in(bin, part)]
        for _ in range(MAX_FILLINGS):
            for number, part in enumerate(parts):
                _write(model, data, part.name, Transform(position=(0.0, 0.0, ASIDE + number)))
            if all(_throw_in(model, data, part.name, _anywhere(bin, part, cell, random)) for part in parts):
                break
        else:
            raise ConfigError(f"{bin.name}: its {len(parts)} parts find no room in random poses")


def _is_in(bin: BinSetup, part: PlacedPart) -> bool:
    x, y, z = (Transform.from_pose(bin.pose).inverse() @ Transform.from_pose(part.pose)).position
    return abs(x) < bin.length / 2.0 and abs(y) < bin.width / 2.0 and abs(z) < BIN_HEIGHT


def _anywhere(bin: BinSetup, part: PlacedPart, cell: CellSetup, random: np.random.Generator) -> Iterator[Transform]:
    """Random poses in the world of a part in a bin, whose middle is where it is grasped."""
    frame = Transform.from_pose(bin.pose)
    local = frame.inverse() @ Transform.from_pose(part.pose)
    kind = cell.types[part.type]
    height = (local @ kind.grasp).position[2]
    upper = kind.grasp
    if kind.further_grasps and random.random() < cell.turned_over:
        upper = kind.further_grasps[int(random.integers(len(kind.further_grasps)))]
        local = Transform(local.rotation) @ Transform(kind.grasp.rotation) @ Transform(upper.rotation).inverse()
    x, y, z = (local @ upper).position
    for _ in range(MAX_DRAWS):
        along, across = random.uniform(-0.5, 0.5, 2).tolist()
        turn = rotation_about(Z, random.uniform(-math.pi, math.pi))
        place = Transform(turn, (along * bin.length, across * bin.width, height + DROP))
        yield frame @ place @ Transform(position=(-x, -y, -z)) @ local


def _throw_in(model: mujoco.MjModel, data: mujoco.MjData, name: str, poses: Iterator[Transform]) -> bool:
    """Place a part in the first of the poses in which it touches nothing; False if there is none."""
    for pose in poses:
        _write(model, data, name, pose)
        mujoco.mj_fwdPosition(model, data)
        if not _overlaps(model, data, name, 0.0):
            return True
    return False


def _write(model: mujoco.MjModel, data: mujoco.MjData, name: str, pose: Transform) -> None:
    address = int(model.joint(name).qposadr[0])
    data.qpos[address : address + 7] = (*pose.position, *quaternion(pose.rotation))


def _disturbed(cell: CellSetup, part: PlacedPart, along: float, across: float, turn: float) -> Transform:
    pose = Transform.from_pose(part.pose)
    kind = cell.types[part.type]
    grasp = pose @ kind.grasp
    normal = scaled(grasp.rotate(Z), -1.0)
    rise = difference(Z, scaled(normal, dot(Z, normal)))
    steep = math.hypot(*rise)
    if steep > STEEP:
        upward = scaled(rise, 1.0 / steep)
        along = abs(along) + 0.05 * abs(math.sin(turn))
    else:
        upward = (1.0, 0.0, 0.0)
    sideways: Vector = (
        normal[1] * upward[2] - normal[2] * upward[1],
        normal[2] * upward[0] - normal[0] * upward[2],
        normal[0] * upward[1] - normal[1] * upward[0],
    )
    middle = grasp.position
    rotation = Transform(rotation_about(normal, turn))
    arm = rotation.rotate(difference(pose.position, middle))
    moved = add(add(middle, arm), add(scaled(upward, along), scaled(sideways, across)))
    return Transform((rotation @ Transform(pose.rotation)).rotation, moved)


def _overlaps(model: mujoco.MjModel, data: mujoco.MjData, name: str, depth: float) -> bool:
    """True if a part's shapes overlap others by more than `depth` metres."""
    tree = model.body_treeid[model.body(name).id]
    for contact in data.contact[: data.ncon]:
        if contact.dist < -depth and tree in model.body_treeid[model.geom_bodyid[contact.geom]]:
            return True
    return False


def put(cell: SimulatedCell, name: str, pose: Transform) -> None:
    """Place a part in the world, at rest."""
    dof = int(cell.model.joint(name).dofadr[0])
    _write(cell.model, cell.data, name, pose)
    cell.data.qvel[dof : dof + 6] = 0.0
    mujoco.mj_kinematics(cell.model, cell.data)


def put_fixture(cell: SimulatedCell, name: str, pose: Transform) -> None:
    """Place a fixture in the world. MuJoCo computes where static bodies are only while nothing may sleep."""
    model, body = cell.model, cell.model.body(name)
    body.pos, body.quat = pose.position, quaternion(pose.rotation)
    flags = model.opt.enableflags
    model.opt.enableflags = flags & ~int(mujoco.mjtEnableBit.mjENBL_SLEEP)
    mujoco.mj_kinematics(model, cell.data)
    model.opt.enableflags = flags


def put_on(cell: SimulatedCell, connector: str, name: str, error: Transform = IDENTITY) -> None:
    """Put a part in front of a connector, with its plate in contact, and enable the connector."""
    offset = Transform(position=(0.0, 0.0, GAP)) @ error
    put(cell, name, cell.truth.connector(connector) @ offset)
    cell.connectors[connector].set(True)


def put_on_each_other(
    cell: SimulatedCell, connector: str, parts: Sequence[str], errors: Mapping[str, Transform] | None = None
) -> None:
    """Put parts on a connector, each on the last one's first connector, and have them attached.

    `errors` are poses of parts on their connectors, by part. Raises `ConfigError` for a part that does not attach.
    """
    for name in parts:
        put_on(cell, connector, name, (errors or {}).get(name, IDENTITY))
        wait_attached(cell, connector, name)
        connector = f"{name}/{next(iter(cell.setup.type_of(name).connectors), '')}"


def wait_attached(cell: SimulatedCell, connector: str, name: str) -> None:
    """Advance until a connector holds a part, and has locked it if both can; raises `ConfigError` if it does not."""
    holder = cell.connectors[connector]
    until = cell.time + ATTACH_TIME
    while not holder.secured:
        if cell.time > until:
            why = holder.state().last_error
            raise ConfigError(f"{name} was put on {connector} and is not attached, or not locked: {why}")
        cell.advance(POLL)
    if (held := holder.state().attached_to) != name:
        raise ConfigError(f"{name} was put on {connector}, which holds {held}")
