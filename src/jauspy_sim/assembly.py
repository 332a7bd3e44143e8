"""Combines a robot (URDF) and a world (MJCF) to one MuJoCo model."""

from __future__ import annotations

import logging
import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from itertools import chain
from typing import TYPE_CHECKING, Final, cast

import mujoco
import numpy as np
from numpy.typing import NDArray

from jauspy.errors import ConfigError
from jauspy.geometry.urdf import Joint, JointKind
from jauspy.platform.backend import PlacedRobot
from jauspy.platform.camera import CameraSetup
from jauspy.platform.description import RobotModel
from jauspy.platform.force_torque import ForceTorqueSetup
from jauspy.platform.joint_control import ROTOR_ACCELERATION
from jauspy.platform.wheels import Wheel, WheelKind, WheelSetup
from jauspy_sim.models.decals import add_decals
from jauspy_sim.models.groups import COLLISION, VISUAL
from jauspy_sim.models.look import polish, show_solids, without_visuals
from jauspy_sim.models.self_contacts import depth_below_base, exclude_touching
from jauspy_sim.models.shapes import same_shape
from jauspy_sim.models.track_visuals import SIDES
from jauspy_sim.models.urdf import body_name, urdf_spec
from jauspy_sim.worlds.lighting import draw_floors_as_meshes
from jauspy_sim.worlds.world_files import world_spec

if TYPE_CHECKING:
    Numbers = memoryview[float]

_LOG = logging.getLogger("jauspy_sim.mujoco")

SLEEP: Final = int(mujoco.mjtEnableBit.mjENBL_SLEEP) if hasattr(mujoco.mjtEnableBit, "mjENBL_SLEEP") else 0
"""Option of MuJoCo 3.4 and later: bodies at rest are not simulated until something touches them."""

SLEEP_TOLERANCE: Final = 0.002
"""Metres per second (radians times metres): slower bodies count as resting."""

TIMESTEP: Final = 0.002
"""Seconds of one physics step."""

STEP_TOLERANCE: Final = 1e-9
"""Tolerance for rounding errors of times, as a fraction of a step."""

ROTOR_INERTIA: Final = 1.0 / ROTOR_ACCELERATION
"""Armature of a joint as a fraction of its maximal effort: the reflected inertia of geared rotors."""

BELT_PRIORITY: Final = 1
"""Contact priority of belts, wheels and slippery links: their friction replaces that of a plain ground."""
PLAIN_FRICTION: Final = 1.0
"""Coefficient of shapes for which none is given, in MuJoCo and in Gazebo."""

STEERING_STIFFNESS: Final = 8.0
"""Torque of a steering motor per radian beside its target, as a multiple of its greatest torque."""
STEERING_DAMPING: Final = 0.6
"""Torque per rad/s, as a multiple of the greatest torque."""
ROLLER_DAMPING: Final = 2.0
"""N s/m, of the rollers of a mecanum wheel."""


def prefix(robot: str) -> str:
    """Prefix of the names of a robot's parts in the model, as in `inc1/base_link`."""
    return f"{robot}/"


@dataclass(frozen=True, slots=True)
class DrawnModel:
    """The model of a robot and its world for cameras; the process that draws builds it, in half a second.

    `robots` are all robots of the world, in the order of the model for physics; without them, `robot` is alone. Only
    its own cameras show the shadow and the marks of a robot.
    """

    robot: RobotModel
    world: str
    robots: tuple[PlacedRobot, ...] = ()

    def build(self) -> mujoco.MjModel:
        """Build the model, whose state has the layout of the model for physics."""
        spec = world_spec(self.world, self.robot.model_path)
        draw_floors_as_meshes(spec)
        add_decals(spec, self.robot)
        placed = self.robots or (PlacedRobot(self.robot),)
        return build_with(spec, placed, _what([row.robot for row in placed], self.world), drawn=True)


def build(robot: RobotModel, world: str, *, drawn: bool = True) -> mujoco.MjModel:
    """The compiled model of that robot at the origin of that world; `ConfigError` lists the worlds there are.

    A robot whose base is above the ground, such as a walking robot, is placed so that its lowest part touches the
    ground. Unless `drawn`, the model has no visual shapes: physics takes a tenth longer with them.
    """
    what = _what([robot], world)
    return build_with(world_spec(world, robot.model_path), [PlacedRobot(robot)], what, drawn=drawn)


def build_several(robots: Sequence[PlacedRobot], world: str) -> mujoco.MjModel:
    """The compiled model for physics of several robots in that world, in whose order they are in the state."""
    models = [row.robot for row in robots]
    return build_with(world_spec(world, models[0].model_path), robots, _what(models, world), drawn=False)


def _what(robots: Sequence[RobotModel], world: str) -> str:
    names = [robot.description.name for robot in robots]
    return f"robot{'s' * (len(names) > 1)} {', '.join(names)} in world {world}"


def build_in(spec: mujoco.MjSpec, robot: RobotModel, what: str = "the robot", drawn: bool = False) -> mujoco.MjModel:
    """The compiled model of that robot at the origin of a world that is not compiled yet, which is changed."""
    return build_with(spec, [PlacedRobot(robot)], what, drawn=drawn)


def build_with(spec: mujoco.MjSpec, robots: Sequence[PlacedRobot], what: str, *, drawn: bool) -> mujoco.MjModel:
    """The compiled model of robots in a world that is not compiled yet, which is changed."""
    if not drawn:
        _remove_scenery(spec)
    for placed, first_side in zip(robots, first_sides(row.robot for row in robots), strict=True):
        _attach(spec, placed, first_side, drawn=drawn)
    spec.nuserdata = SIDES * sum(row.robot.tracks is not None for row in robots)
    spec.option.timestep = TIMESTEP
    spec.option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    spec.option.cone = mujoco.mjtCone.mjCONE_ELLIPTIC
    spec.option.impratio = 10.0  # friction ten times stiffer than normal contact: a parked robot does not creep
    if not drawn:
        spec.option.enableflags |= SLEEP
        if SLEEP:
            spec.option.sleep_tolerance = SLEEP_TOLERANCE
    model = compiled(spec, what)
    _make_slippery(model)
    return model


def first_sides(robots: Iterable[RobotModel]) -> list[int]:
    """For each robot of a world, where in `userdata` the runs of its belts begin."""
    tracked = [robot.tracks is not None for robot in robots]
    return [SIDES * sum(tracked[:number]) for number in range(len(tracked))]


def _attach(spec: mujoco.MjSpec, placed: PlacedRobot, first_side: int, *, drawn: bool) -> None:
    """Add a robot to the world, where it starts."""
    robot, start = placed.robot, placed.start
    if drawn:
        added = robot_spec(robot)
        polish(added, robot, first_side)
    else:
        added = robot_spec(replace(robot, description=without_visuals(robot.description)))
    height = 0.0 if robot.tracks else depth_below_base(added, robot.description, _start(robot))
    turn = (math.cos(start.yaw / 2.0), 0.0, 0.0, math.sin(start.yaw / 2.0))
    frame = spec.worldbody.add_frame(pos=(start.x, start.y, start.z + height), quat=turn)
    if not drawn:
        show_solids(added, robot.description)
    spec.attach(added, prefix=prefix(robot.description.name), frame=frame)


def _make_slippery(model: mujoco.MjModel) -> None:
    """Give belts and wheels the friction of the ground where that is lower: ice, mud, a smooth wall."""
    belts = model.geom_priority == BELT_PRIORITY
    if belts.any():
        fixed = model.body_weldid[model.geom_bodyid] == 0
        slippery = model.geom_friction[:, 0] < model.geom_friction[belts, 0].max()
        model.geom_priority[fixed & slippery] = BELT_PRIORITY + 1


def compiled(spec: mujoco.MjSpec, what: str) -> mujoco.MjModel:
    """Compile the model; raises `ConfigError` for what MuJoCo does not accept."""
    try:
        return spec.compile()
    except ValueError as error:
        raise ConfigError(f"MuJoCo cannot simulate {what}: {' '.join(str(error).split())}") from error


def _remove_scenery(spec: mujoco.MjSpec) -> None:
    """Remove geometries of a world that are only drawn and have no mass."""
    for geom in spec.geoms:
        if geom.group == VISUAL and not (geom.contype or geom.conaffinity or geom.mass != 0.0):
            spec.delete(geom)
    used = {geom.meshname for geom in spec.geoms}
    for mesh in spec.meshes:
        if mesh.name not in used:
            spec.delete(mesh)


def robot_spec(robot: RobotModel) -> mujoco.MjSpec:
    """The robot alone, with a motor at each joint; free to move on tracks or wheels, or else fixed to the world."""
    spec = urdf_spec(robot.description)
    tracks = robot.tracks
    belts = tracks.left + tracks.right if tracks else ()
    unpowered = {*belts, *_rolling_freely(robot)}
    for joint in robot.description.joints.values():
        _dynamics(spec, joint, unpowered)
        if joint.is_independent and joint.effort and joint.name not in unpowered:
            _motor(spec, joint)
    if tracks is not None:
        spec.body(body_name(robot.description.root())).add_freejoint(name="base")
        for side in (tracks.left, tracks.right):
            _track(spec, [robot.description.joint(belt) for belt in side], tracks.inertia)
    if robot.wheels is not None:
        spec.body(body_name(robot.description.root())).add_freejoint(name="base")
        _wheels(spec, robot.wheels)
        rolling = {wheel.joint.name for wheel in robot.wheels.wheels} | _rolling_freely(robot)
        for name in rolling:
            for geom in spec.body(body_name(robot.description.joint(name).child)).geoms:
                geom.priority = BELT_PRIORITY
    for link, coefficient in robot.description.friction.items():
        _set_friction(spec, link, coefficient)
    for camera in robot.cameras:
        _camera(spec, camera)
    for sensor in robot.force_torque:
        add_force_torque(spec, sensor)
    for geom in spec.geoms:
        geom.group = VISUAL if not (geom.contype or geom.conaffinity) else COLLISION
    exclude_touching(spec, robot.description, _start(robot))
    return spec


def _start(robot: RobotModel) -> dict[str, float]:
    """The initial positions of joints."""
    rows = (zip(group.joints, group.start, strict=True) for group in robot.groups.values())
    return dict(chain.from_iterable(rows))


def _rolling_freely(robot: RobotModel) -> set[str]:
    """The continuous joints that nothing drives: casters, and the other wheels of a car."""
    driven = {wheel.joint.name for wheel in robot.wheels.wheels} if robot.wheels else set()
    driven |= {name for group in robot.groups.values() for name in group.joints}
    rolling = {joint.name for joint in robot.description.joints.values() if joint.kind is JointKind.CONTINUOUS}
    return rolling - driven


def _dynamics(spec: mujoco.MjSpec, joint: Joint, unpowered: set[str]) -> None:
    """Damping, friction and motor of a joint; those that roll freely have neither rotor nor motor."""
    if joint.kind is JointKind.FIXED:
        return
    found = spec.joint(joint.name)
    found.damping = same_shape(found.damping, joint.damping)
    found.frictionloss = joint.friction
    found.armature = 0.0 if joint.name in unpowered else ROTOR_INERTIA * joint.effort


def _motor(spec: mujoco.MjSpec, joint: Joint) -> None:
    motor = spec.add_actuator(name=joint.name, target=joint.name, trntype=mujoco.mjtTrn.mjTRN_JOINT)
    motor.ctrllimited = True
    motor.ctrlrange = (-joint.effort, joint.effort)


def _track(spec: mujoco.MjSpec, belts: Sequence[Joint], inertia: float) -> None:
    """Add the belts of one side: a motor drives the first, and the others run as fast as it."""
    for joint in belts:
        found = spec.joint(joint.name)
        found.damping = same_shape(found.damping, 0.0)
        found.armature = 0.0
        found.limited = mujoco.mjtLimited.mjLIMITED_FALSE
        found.solref_friction = (2.0 * TIMESTEP, 1.0)
        found.solimp_friction = (0.999, 0.999, 0.001, 0.5, 2.0)  # a brake that holds does not creep
        for geom in spec.body(body_name(joint.child)).geoms:
            geom.priority = BELT_PRIORITY
        spec.add_exclude(bodyname1=body_name(joint.parent), bodyname2=body_name(joint.child))
    first, *others = belts
    spec.joint(first.name).armature = inertia
    _belt_motor(spec, first)
    for joint in others:
        coupling = spec.add_equality(type=mujoco.mjtEq.mjEQ_JOINT, name1=joint.name, name2=first.name)
        coupling.objtype = mujoco.mjtObj.mjOBJ_JOINT
        coupling.data[:5] = (0.0, 1.0, 0.0, 0.0, 0.0)
        coupling.solref = (2.0 * TIMESTEP, 1.0)


def _belt_motor(spec: mujoco.MjSpec, joint: Joint) -> None:
    """A motor with a voltage, whose control is its speed without load; its current, and so its force, is limited."""
    lost = joint.damping or joint.effort / joint.velocity
    motor = spec.add_actuator(name=joint.name, target=joint.name, trntype=mujoco.mjtTrn.mjTRN_JOINT)
    motor.ctrllimited = motor.forcelimited = True
    motor.ctrlrange = (-joint.velocity, joint.velocity)
    motor.forcerange = (-joint.effort, joint.effort)
    motor.gainprm[0] = lost
    motor.biastype = mujoco.mjtBias.mjBIAS_AFFINE
    motor.biasprm[:3] = (0.0, 0.0, -lost)


def _wheels(spec: mujoco.MjSpec, setup: WheelSetup) -> None:
    """Give the joints of driven wheels the inertia, back EMF and brakes of their motors; free the rollers."""
    for wheel in setup.wheels:
        found = spec.joint(wheel.joint.name)
        found.armature = setup.inertia
        found.solref_friction = (2.0 * TIMESTEP, 1.0)
        back_emf = max(wheel.joint.damping, wheel.joint.effort / wheel.joint.velocity)
        found.damping = same_shape(found.damping, back_emf)
        if setup.kind is WheelKind.MECANUM:
            _add_rollers(spec, wheel)
    for steered in setup.steering:
        motor = spec.actuator(steered.joint.name)
        stiffness, damping = (factor * steered.joint.effort for factor in (STEERING_STIFFNESS, STEERING_DAMPING))
        motor.gainprm[0] = stiffness
        motor.biastype = mujoco.mjtBias.mjBIAS_AFFINE
        motor.biasprm[1], motor.biasprm[2] = -stiffness, -damping
        motor.ctrlrange = (steered.joint.lower, steered.joint.upper)
        motor.forcelimited, motor.forcerange = True, (-steered.joint.effort, steered.joint.effort)


def _add_rollers(spec: mujoco.MjSpec, wheel: Wheel) -> None:
    """Let the wheel slide where its rollers roll, by a joint whose position is reset after each step.

    The joint must come before that of the axle, so that it does not turn with the wheel.
    """
    body, axle = spec.body(wheel.joint.child), spec.joint(wheel.joint.name)
    kept = {name: np.copy(getattr(axle, name)) for name in ("axis", "damping", "solref_friction")}
    armature, loss = axle.armature, axle.frictionloss
    spec.delete(axle)
    slide = body.add_joint(name=f"{wheel.joint.name}/rollers", type=mujoco.mjtJoint.mjJNT_SLIDE)
    slide.axis = (1.0, wheel.rollers, 0.0)
    slide.damping = same_shape(slide.damping, ROLLER_DAMPING)
    again = body.add_joint(name=wheel.joint.name, type=mujoco.mjtJoint.mjJNT_HINGE)
    again.axis, again.solref_friction = kept["axis"], kept["solref_friction"]
    again.damping = kept["damping"] if np.size(kept["damping"]) > 1 else float(kept["damping"])
    again.armature, again.frictionloss = armature, loss


def _set_friction(spec: mujoco.MjSpec, link: str, coefficient: float) -> None:
    """Also of a sliding caster, which many descriptions give no friction."""
    for geom in spec.body(body_name(link)).geoms:
        geom.friction = (coefficient, *geom.friction[1:])
        if coefficient < PLAIN_FRICTION:
            geom.priority = BELT_PRIORITY


def _camera(spec: mujoco.MjSpec, camera: CameraSetup) -> None:
    """Add a camera. MuJoCo's look along -z with y up; the frame of a link along x with z up."""
    # one outside of the robot is placed for each picture
    carrier = spec.worldbody if camera.outside else spec.body(body_name(camera.link))
    added = carrier.add_camera(name=camera.name)
    added.quat = (0.5, 0.5, -0.5, -0.5)
    added.fovy = math.degrees(camera.fov)  # vertical; changed when the shape of the picture is known


def add_force_torque(spec: mujoco.MjSpec, setup: ForceTorqueSetup) -> None:
    """Add a sensor between a link and the link that carries it."""
    spec.body(body_name(setup.link)).add_site(name=setup.name)
    for kind, type_ in (("force", mujoco.mjtSensor.mjSENS_FORCE), ("torque", mujoco.mjtSensor.mjSENS_TORQUE)):
        spec.add_sensor(name=f"{setup.name}_{kind}", type=type_, objtype=mujoco.mjtObj.mjOBJ_SITE, objname=setup.name)


def redirect_warnings() -> None:
    """Log MuJoCo's warnings; by default it writes them to MUJOCO_LOG.TXT in the working directory."""
    mujoco.set_mju_user_warning(_warn)


def _warn(text: str) -> None:
    _LOG.warning("%s", text)


def view(array: NDArray[np.float64]) -> Numbers:
    """A memoryview of an array; access to single numbers is three times as fast."""
    return cast("Numbers", array.data)
