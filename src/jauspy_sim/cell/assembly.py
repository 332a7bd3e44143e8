"""The MuJoCo model of a factory cell: the robot of the URDF, parts as free bodies, bins, conveyor, connectors.

A part is a body of the same name whose frame is the part's. A servo module has two more: `NAME.rotor`, which the motor
turns against the housing (joint `NAME.motor`), and `NAME.output`, which a spring holds on the rotor (`NAME.spring`).
Each vacuum connector is a weld between its body and the world that is not active; attaching writes the second body.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Final

import mujoco

from jauspy.errors import ConfigError
from jauspy.geometry.poses import Pose, Transform
from jauspy.geometry.vectors import quaternion
from jauspy.platform.description import RobotModel
from jauspy.platform.modular.parts import (
    CellSetup,
    ConveyorSetup,
    Fixture,
    Inertia,
    PartKind,
    PartSolid,
    PartType,
    PlacedPart,
    ServoData,
    Shape,
    body_inertia,
    output_inertia,
)
from jauspy_sim.assembly import TIMESTEP, prefix, robot_spec
from jauspy_sim.cell.looks import Dresser
from jauspy_sim.models.groups import COLLISION
from jauspy_sim.models.shapes import same_shape
from jauspy_sim.worlds.world_files import world_spec

GRIPPER: Final = "gripper"
"""Name of the connector of the robot's own gripper."""

SPRING_INERTIA: Final = 0.002
"""kg m^2 of bearing and encoder, at the spring of a servo; without it a free output would be too fast to step."""

SPRING_LOSS: Final = 0.0005
"""Seconds: damping of the spring as a fraction of its stiffness."""

BIN_FRICTION: Final = 0.2
"""Friction of the floors of bins, on which parts slide to the lower edge."""

PART_FRICTION: Final = 0.6
RUBBER_FRICTION: Final = 1.0
"""Friction of wheels and of the belt."""

BELT_MASS: Final = 60.0
"""Kilograms of belt and rollers, as they resist acceleration."""
BELT_GAIN: Final = 6000.0
"""Newtons per m/s with which the drive of the belt holds its speed."""
BELT_THICKNESS: Final = 0.02

WELD_TIME: Final = 2.0 * TIMESTEP
"""Time constant of a weld: the shortest that is stable."""
WELD_IMPEDANCE: Final = (0.9999, 0.9999, 0.001, 0.5, 2.0)
"""The most rigid that MuJoCo has: the arm of five joints gives way by 1 mm at its tip under its own weight."""

CONTACT_TIME: Final = 2.5 * TIMESTEP

RUBBER_CONTACT_TIME: Final = 0.01
"""Time constant of the contacts of wheels with the floor: a rubber tyre gives way by 0.3 mm under its share of the car.
As hard as other shapes it would chatter when the car turns on the spot, and shake its latches loose; assumption."""

BOX_CONTACT_TIME: Final = 0.0006
"""Time constant of a box's contacts while steps are short: a thrown box of cardboard stops within a millimetre or two.
In whole steps MuJoCo takes the shortest that is stable instead."""

SOFT: Final = {PartKind.BOX: BOX_CONTACT_TIME, PartKind.WHEEL: RUBBER_CONTACT_TIME}

UNUSED: Final = "unused"
"""Prefix of bodies without shapes that reserve exclusions of contacts, one for each connector."""


@dataclass(frozen=True, slots=True)
class CellModel:
    """The compiled models, with the names of their elements."""

    model: mujoco.MjModel
    """For physics, without the meshes and paint that are only drawn."""
    drawn: mujoco.MjModel
    """For cameras; the layout of its state is the same."""
    setup: CellSetup
    prefix: str
    """Prefix of the names of the robot's links, joints and motors."""
    connectors: tuple[str, ...]
    """Names of all connectors, each that of a weld."""


def build_cell(robot: RobotModel, world: str) -> CellModel:
    """The cell of that robot in that world. Raises `ConfigError` for inconsistent settings."""
    setup = robot.cell
    if setup is None:
        raise ConfigError(f"robot {robot.description.name} has no cell")
    name_prefix = prefix(robot.description.name)
    spec = world_spec(world, robot.model_path)
    floor = spec.geom("floor")
    if floor is not None:  # as hard as other shapes; MuJoCo's own is soft
        floor.solref, floor.friction = (CONTACT_TIME, 1.0), (PART_FRICTION, 0.005, 0.0001)
    spec.attach(robot_spec(robot), prefix=name_prefix, frame=spec.worldbody.add_frame())
    _check(robot, setup)
    for bin_ in setup.bins:
        add_static(spec, bin_.name, bin_.pose, bin_.solids(), friction=BIN_FRICTION)
    for fixture in setup.fixtures:
        _fixture(spec, fixture)
    if setup.conveyor is not None:
        _conveyor(spec, setup.conveyor)
        static = (
            "conveyor",
            *(bin_setup.name for bin_setup in setup.bins),
            *(fixture.name for fixture in setup.fixtures),
        )
        for name in static:
            spec.add_exclude(bodyname1="belt", bodyname2=name)  # a ramp that ends at the belt does not hold it
    for part in setup.parts:
        _part(spec, part, setup.types[part.type])
    connectors = tuple(_connectors(spec, setup, name_prefix))
    _reserve_exclusions(spec, len(connectors))
    _options(spec)
    model = spec.compile()
    Dresser(spec, setup, name_prefix).dress()
    return CellModel(model, spec.compile(), setup, name_prefix, connectors)


def carrier(part: str, kind: PartType) -> str:
    """The body that has the connectors of a part."""
    return part if kind.servo is None else f"{part}.output"


def _check(robot: RobotModel, setup: CellSetup) -> None:
    for part in setup.parts:
        if part.type not in setup.types:
            known = ", ".join(sorted(setup.types))
            raise ConfigError(f"part {part.name!r} is of the unknown type {part.type!r}; there are: {known}")
        if not part.fixed and body_inertia(setup.types[part.type]).mass <= 0.0:
            raise ConfigError(f"type {part.type!r} has no mass; give its solids one")
    if setup.gripper and setup.gripper not in robot.description.links():
        raise ConfigError(f"cell.gripper: the URDF has no link {setup.gripper!r}")


def _options(spec: mujoco.MjSpec) -> None:
    option = spec.option
    option.timestep = TIMESTEP
    option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    option.cone = mujoco.mjtCone.mjCONE_ELLIPTIC
    option.impratio = 5.0
    option.enableflags |= int(mujoco.mjtEnableBit.mjENBL_SLEEP)
    option.sleep_tolerance = 1e-3


def set_pose(element: mujoco.MjsBody | mujoco.MjsGeom, pose: Transform) -> None:
    """Place an element of a model."""
    element.pos, element.quat = pose.position, quaternion(pose.rotation)


def add_static(
    spec: mujoco.MjSpec, name: str, pose: Pose, solids: Sequence[PartSolid], *, friction: float = PART_FRICTION
) -> mujoco.MjsBody:
    """Add a body that is fixed to the world."""
    body = spec.worldbody.add_body(name=name)
    set_pose(body, Transform.from_pose(pose))
    for number, solid in enumerate(solids):
        geom = add_solid(body, solid, f"{name}.{number}", friction)
        geom.priority = 1  # its friction has priority over that of parts
    return body


def _fixture(spec: mujoco.MjSpec, fixture: Fixture) -> None:
    add_static(spec, fixture.name, fixture.pose, fixture.solids)


def add_solid(body: mujoco.MjsBody, solid: PartSolid, name: str, friction: float) -> mujoco.MjsGeom:
    """Add the collision shape of a solid, without mass."""
    x, y, z = solid.size
    cuboid = solid.shape is Shape.CUBOID
    geom = body.add_geom(
        name=name,
        type=mujoco.mjtGeom.mjGEOM_BOX if cuboid else mujoco.mjtGeom.mjGEOM_CYLINDER,
        size=(x / 2.0, y / 2.0, z / 2.0) if cuboid else (x, z / 2.0, 0.0),
        mass=0.0,
        group=COLLISION,
        friction=(friction, 0.005, 0.0001),
        solref=(CONTACT_TIME, 1.0),
    )
    set_pose(geom, solid.pose)
    return geom


def set_inertia(body: mujoco.MjsBody, found: Inertia) -> None:
    """Give a body its mass and moments of inertia."""
    (xx, xy, xz), (_, yy, yz), (_, _, zz) = found.moments
    body.explicitinertial = True
    body.mass, body.ipos = found.mass, found.center
    body.fullinertia = (xx, yy, zz, xy, xz, yz)


def _part(spec: mujoco.MjSpec, part: PlacedPart, kind: PartType) -> None:
    friction = RUBBER_FRICTION if kind.kind is PartKind.WHEEL else PART_FRICTION
    body = spec.worldbody.add_body(name=part.name)
    set_pose(body, Transform.from_pose(part.pose))
    if not part.fixed:
        body.add_freejoint(name=part.name)
        body.sleep = mujoco.mjtSleepPolicy.mjSLEEP_ALLOWED
        set_inertia(body, body_inertia(kind))
    for number, solid in enumerate(kind.solids):
        geom = add_solid(body, solid, f"{part.name}.{number}", friction)
        if kind.kind in SOFT:
            geom.solref[0] = SOFT[kind.kind]
            geom.solmix = 1e3  # it gives way, not what it falls on
    if kind.servo is not None:
        _servo(spec, body, part.name, kind, kind.servo)


def _servo(spec: mujoco.MjSpec, housing: mujoco.MjsBody, name: str, kind: PartType, data: ServoData) -> None:
    """Add rotor and output link. The inertia of the rotor is that of its joint: it acts at the output's speed."""
    axis = data.joint.inverse().rotate(data.axis)  # in the frame of the output link
    rotor = housing.add_body(name=f"{name}.rotor")
    set_pose(rotor, data.joint)
    set_inertia(rotor, Inertia(1e-4, (0.0, 0.0, 0.0), ((1e-8, 0.0, 0.0), (0.0, 1e-8, 0.0), (0.0, 0.0, 1e-8))))
    hinge = mujoco.mjtJoint.mjJNT_HINGE
    motor = rotor.add_joint(name=f"{name}.motor", type=hinge, axis=axis, limited=mujoco.mjtLimited.mjLIMITED_FALSE)
    motor.armature = data.rotor_inertia
    motor.frictionloss = data.friction
    motor.damping = same_shape(motor.damping, data.damping)
    output = rotor.add_body(name=f"{name}.output")
    set_inertia(output, output_inertia(kind))
    spring = output.add_joint(name=f"{name}.spring", type=hinge, axis=axis, limited=mujoco.mjtLimited.mjLIMITED_FALSE)
    spring.armature = SPRING_INERTIA
    spring.stiffness = same_shape(spring.stiffness, data.stiffness)
    spring.damping = same_shape(spring.damping, SPRING_LOSS * data.stiffness)
    for number, solid in enumerate(data.output):
        add_solid(output, solid, f"{name}.output.{number}", PART_FRICTION)
    spec.add_exclude(bodyname1=name, bodyname2=f"{name}.output")


def _conveyor(spec: mujoco.MjSpec, setup: ConveyorSetup) -> None:
    """Add a belt on a slide joint whose position is set back to zero, so that only its surface speed acts."""
    pose = Transform.from_pose(setup.pose)
    length, width, height = setup.length, setup.width, setup.pose.z
    frame_height = max(0.0, height - BELT_THICKNESS - 0.04)
    bed = PartSolid(
        Shape.CUBOID,
        (length, width, frame_height - 0.005),
        0.0,
        Transform(position=(0.0, 0.0, frame_height / 2.0 + 0.0175 - height)),
    )
    add_static(spec, "conveyor", setup.pose, (bed,))
    belt = spec.worldbody.add_body(name="belt")
    set_pose(belt, pose)
    belt.add_joint(name="belt", type=mujoco.mjtJoint.mjJNT_SLIDE, axis=(1.0, 0.0, 0.0))
    belt.sleep = mujoco.mjtSleepPolicy.mjSLEEP_NEVER
    solid = PartSolid(
        Shape.CUBOID, (length, width, BELT_THICKNESS), 0.0, Transform(position=(0.0, 0.0, -BELT_THICKNESS / 2.0))
    )
    geom = add_solid(belt, solid, "belt", RUBBER_FRICTION)
    geom.priority = 1
    moment = BELT_MASS * length**2 / 12.0
    set_inertia(belt, Inertia(BELT_MASS, (0.0, 0.0, 0.0), ((moment, 0.0, 0.0), (0.0, moment, 0.0), (0.0, 0.0, moment))))
    drive = spec.add_actuator(name="belt", target="belt", trntype=mujoco.mjtTrn.mjTRN_JOINT)
    drive.set_to_velocity(kv=BELT_GAIN)
    drive.ctrllimited = True
    drive.ctrlrange = (-setup.max_speed, setup.max_speed)


def _connectors(spec: mujoco.MjSpec, setup: CellSetup, name_prefix: str) -> Iterator[str]:
    if setup.gripper:
        yield _weld(spec, GRIPPER, f"{name_prefix}{setup.gripper}")
    for part in setup.parts:
        kind = setup.types[part.type]
        for connector in kind.connectors:
            yield _weld(spec, f"{part.name}/{connector}", carrier(part.name, kind))


def _weld(spec: mujoco.MjSpec, name: str, body: str) -> str:
    weld = spec.add_equality(name=name, type=mujoco.mjtEq.mjEQ_WELD, objtype=mujoco.mjtObj.mjOBJ_BODY)
    weld.name1, weld.name2 = body, "world"
    weld.active = False
    weld.solref = (WELD_TIME, 1.0)
    weld.solimp = WELD_IMPEDANCE
    return name


def _reserve_exclusions(spec: mujoco.MjSpec, count: int) -> None:
    """Reserve exclusions of contacts: what a connector holds does not collide with the body that holds it."""
    for number in range(count + 1):
        spec.worldbody.add_body(name=f"{UNUSED}.{number}")
        if number:
            spec.add_exclude(bodyname1=f"{UNUSED}.{number - 1}", bodyname2=f"{UNUSED}.{number}")


def angle_between(cosine: float) -> float:
    """The angle of a cosine that rounding may have put beyond 1."""
    return math.acos(min(1.0, max(-1.0, cosine)))
