"""Types of parts that modular robots are made of, with their geometry, mass and inertia.

The frame of a part is its input flange: the origin is in the middle of the plate, z points into the part, away from
what it is mounted on. A vacuum connector's frame has z pointing out of it. A part that is attached without error has
its frame where the connector's frame is. Metres, kilograms, radians, newton metres.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from enum import Enum
from typing import Annotated, Any, Final, Literal

from annotated_types import Interval, MaxLen, MinLen

from jauspy.errors import ConfigError
from jauspy.geometry.poses import IDENTITY, ORIGIN, Transform
from jauspy.geometry.vectors import GRAVITY, Vector, add, difference, dot, product, scaled, transposed
from jauspy.platform.battery import BatteryData
from jauspy.platform.joints import ContactReaction, EncoderSetup, Gains
from jauspy.platform.modular.holding import GRIPPER_PLATE, LATCH, PLATE, Cup, Holding, Latch
from jauspy.platform.tables import (
    Converted,
    FrameOfTable,
    Identifier,
    NotNegative,
    PoseOfTable,
    Position,
    Positive,
    Prepared,
    Seed,
    Table,
    check_unique,
)


class PartKind(Enum):
    """The purpose of a part."""

    BASE = "base"
    """Stands on the ground, a platform or wheels; has connectors, and a battery or else a supply from the mains."""
    SERVO = "servo"
    BRACKET = "bracket"
    TUBE = "tube"
    WHEEL = "wheel"
    BATTERY = "battery"
    """Powers what it is attached to."""
    BOX = "box"
    """A load without a connector."""


class Shape(Enum):
    """A primitive whose frame is in its middle."""

    CUBOID = "cuboid"
    CYLINDER = "cylinder"


@dataclass(frozen=True, slots=True)
class PartSolid(Table):
    """A homogeneous primitive of a part: for collisions, and for inertia.

    `size`: x, y, z of a cuboid; radius, radius, length along z of a cylinder.
    """

    shape: Shape
    size: tuple[Positive, Positive, Positive]
    mass: NotNegative = 0.0
    """Zero for what is fixed to the world."""
    pose: FrameOfTable = IDENTITY
    """Frame of its middle in the frame of the part, of the servo's output link, of the bin or of the fixture."""

    def __post_init__(self) -> None:
        if self.shape is Shape.CYLINDER and self.size[0] != self.size[1]:
            raise ValueError(f"size: {list(self.size)}: a cylinder has its radius twice, and then its length")


@dataclass(frozen=True, slots=True)
class Inertia:
    """Mass, centre of mass, and moments of inertia about it along the axes of the frame (kg, m, kg m^2)."""

    mass: float
    center: Vector
    moments: tuple[Vector, Vector, Vector]
    """The rows of the matrix."""


HALF_TURN: Final = Transform(((1.0, 0.0, 0.0), (0.0, -1.0, 0.0), (0.0, 0.0, -1.0)))
"""Half a turn about x: two plates that face each other."""
POSITION_GAINS: Final = Gains(40.0, 30.0, 2.0, 5.0)
VELOCITY_GAINS: Final = Gains(4.0, 30.0, 0.0, 5.0)


def _unit(axis: Vector) -> Vector:
    length = math.hypot(*axis)
    if not length:
        raise ValueError("it must not be zero")
    return axis[0] / length, axis[1] / length, axis[2] / length


@dataclass(frozen=True, slots=True)
class ServoSensors(EncoderSetup):
    """Errors of the sensors in a servo module, as standard deviations of each measurement where not said otherwise.

    The spring's torque is its stiffness times the difference of two encoders like this, one on each side of it, so its
    noise is sqrt(2) times `encoder_noise` (and the rounding) times the stiffness. Sources: docs/cell.md.
    """

    gyro_density: NotNegative = math.radians(0.014)
    """rad/s per square root of a hertz."""
    gyro_bias: NotNegative = math.radians(0.1)
    """rad/s; the same in all measurements of one module: what is left after zeroing at rest."""
    accelerometer_density: NotNegative = 150e-6 * GRAVITY
    """m/s^2 per square root of a hertz."""
    accelerometer_bias: NotNegative = 0.02 * GRAVITY
    """m/s^2; the same in all measurements of one module, in each axis at most this much."""
    imu_bandwidth: Positive = 47.0
    """Hertz of the first-order low-pass of both."""

    def imu_noise(self, density: float) -> float:
        """Standard deviation of one measurement, of a noise density in the unit of the measurement / sqrt(Hz)."""
        return density * math.sqrt(self.imu_bandwidth * math.pi / 2.0)

    def torque_noise(self, stiffness: float) -> float:
        """Standard deviation of a measured torque, N m, with the rounding; `stiffness` of the spring in N m/rad."""
        return stiffness * math.sqrt(2.0 * (self.encoder_noise**2 + self.encoder_step**2 / 12.0))


EXACT: Final = ServoSensors(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
"""Sensors without errors."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ServoData(Table):
    """The motor, gear and limits of a servo module, as in a data sheet."""

    max_torque: Positive
    """Newton metres."""
    max_speed: Positive
    """rad/s."""
    friction: NotNegative
    """Coulomb friction of the gear at the output, newton metres."""
    damping: NotNegative
    """Newton metres per rad/s at the output."""
    stiffness: Positive
    """Stiffness of the spring between gear and output, newton metres per radian."""
    rotor_inertia: Positive
    """Inertia of motor and gear, at the output, kg m^2."""
    torque_constant: Positive
    """Newton metres at the output per ampere."""
    resistance: Positive = 6.0
    """Ohms of the windings; assumption, since data sheets of the series do not state it."""
    idle_power: NotNegative = 2.4
    """Watts of the electronics while the module has power; assumption."""
    axis: Annotated[Position, Converted(_unit)] = (0.0, 0.0, 1.0)
    """Unit vector of the joint's axis in the frame of the part, through `joint`; in the file of any length."""
    joint: FrameOfTable = IDENTITY
    """Frame of the output link at position zero, in the frame of the part; solids and connectors of the output link are
    given in it."""
    output: tuple[PartSolid, ...] = ()
    """The link that turns."""
    position_gains: Gains = POSITION_GAINS
    """Gains of its own position loop, which acts at 500 Hz: newton metres per radian."""
    velocity_gains: Gains = VELOCITY_GAINS
    """Newton metres per rad/s."""
    sensors: ServoSensors = ServoSensors()


@dataclass(frozen=True, slots=True)
class PartType(Table):
    """One type of part. A servo's connectors are on its output link; those of other parts on the part itself."""

    name: str
    kind: PartKind
    solids: Annotated[tuple[PartSolid, ...], MinLen(1)]
    connectors: Mapping[Identifier, FrameOfTable] = field(default_factory=dict)
    """Frames of the vacuum connectors, by name; of a servo in the frame of its output link. Elsewhere they are named
    with the part and a slash, as in `servo_1/output`."""
    servo: ServoData | None = None
    battery: BatteryData | None = None
    """Of a battery, or of a base that is not supplied from the mains."""
    grasp: FrameOfTable = IDENTITY
    """Frame of the gripper when it holds the part, in the frame of the part; its z points into the part."""
    further_grasps: tuple[FrameOfTable, ...] = ()
    """The same for other faces by which it can be held, when it does not lie with the first one up."""
    latch: bool = False
    """True if its input flange and its connectors have mechanical latches; two that meet lock."""
    grasp_latch: bool = False
    """True if the faces by which the gripper holds it have latch plates, on which a gripper with a latch locks."""

    def __post_init__(self) -> None:
        if (self.kind is PartKind.SERVO) != (self.servo is not None):
            raise ValueError("servo: parts of the kind servo need this table, and no others have it")
        if self.kind is PartKind.BATTERY and self.battery is None:
            raise ValueError("battery: parts of the kind battery need this table")
        if self.battery is not None and self.kind not in (PartKind.BATTERY, PartKind.BASE):
            raise ValueError("battery: only parts of the kinds battery and base have this table")
        if self.kind is PartKind.BOX and self.connectors:
            raise ValueError("connectors: a box has none")
        if not sum(solid.mass for solid in self.solids):
            raise ValueError("solids: they need a mass; only what is fixed to the world has none")

    @property
    def grasps(self) -> tuple[Transform, ...]:
        """The frames of the gripper on all faces by which it can hold the part, the usual one first."""
        return self.grasp, *self.further_grasps

    @property
    def is_module(self) -> bool:
        """True if it has a servo or a connector, which can be commanded."""
        return self.servo is not None or bool(self.connectors)


@dataclass(frozen=True, slots=True)
class ConnectorLimits(Table):
    """Limits within which a vacuum connector attaches and holds."""

    max_distance: Positive = 0.004
    """Metres between the middles of the plates; on a box, which may be held anywhere, along its face's normal."""
    max_angle: Annotated[float, Interval(gt=0.0, le=math.pi)] = math.radians(4.0)
    """Angle between the plates' normals, in radians; the angle about the normal is free."""
    cup: Cup = PLATE
    """The suction cup of each connector of a part."""
    gripper: Cup = GRIPPER_PLATE
    """The suction cup of the robot's gripper."""
    latch: Latch = LATCH
    """The latch of parts that have one."""

    def strength(self, *, latched: bool) -> Holding:
        """Strength of a part's connector, with or without its latch."""
        return self.latch if latched else self.cup.holding


@dataclass(frozen=True, slots=True)
class PlacedPart(Table):
    """One part of a cell, and where it is at the start."""

    name: Identifier
    type: Identifier
    pose: PoseOfTable
    """Pose of its frame in the world."""
    fixed: bool = False
    """True for a base that is bolted to the world."""


@dataclass(frozen=True, slots=True)
class ConveyorSetup(Table):
    """A straight conveyor: the middle of its upper surface, whose x axis is the direction of travel."""

    pose: PoseOfTable
    length: Positive
    width: Positive
    max_speed: Positive
    """m/s."""


@dataclass(frozen=True, slots=True)
class BinSetup(Table):
    """A bin with a slanted floor, whose parts slide to its lower edge and rest there.

    Its frame: the origin is in the middle of the floor's surface, x points along the lower edge, y up the slope, z away
    from the floor.
    """

    name: Identifier
    pose: PoseOfTable
    length: Positive
    """Inside, along x."""
    width: Positive
    """Inside, along y."""
    wall: Positive = 0.05
    """Height of the walls above the floor."""
    thickness: Positive = 0.008

    def solids(self) -> tuple[PartSolid, ...]:
        """The floor and the walls: lower, upper, left, right; in the frame of the bin."""
        x, y, t = self.length, self.width, self.thickness
        height = self.wall + t
        middle = self.wall / 2.0 - t / 2.0
        sides, ends = (x + 2.0 * t, t, height), (t, y, height)
        return (
            _cuboid((x, y, t), (0.0, 0.0, -t / 2.0)),
            _cuboid(sides, (0.0, -(y + t) / 2.0, middle)),
            _cuboid(sides, (0.0, (y + t) / 2.0, middle)),
            _cuboid(ends, (-(x + t) / 2.0, 0.0, middle)),
            _cuboid(ends, ((x + t) / 2.0, 0.0, middle)),
        )


def _cuboid(size: Vector, position: Vector) -> PartSolid:
    return PartSolid(Shape.CUBOID, size, 0.0, Transform(position=position))


@dataclass(frozen=True, slots=True)
class Fixture(Table):
    """Something that stands in the cell: a table, a ramp. Solids are given in its frame."""

    name: Identifier
    solids: Annotated[tuple[PartSolid, ...], MinLen(1)]
    pose: PoseOfTable = ORIGIN


@dataclass(frozen=True, slots=True)
class TargetArea(Table):
    """A rectangle marked on the ground, into which boxes are thrown: its middle, and its size along x and y."""

    pose: PoseOfTable
    length: Positive
    width: Positive


@dataclass(frozen=True, slots=True)
class PartCamera(Table):
    """A 3D camera that sees parts. Its frame: x is the direction of view, y to the left of the picture, z up.

    Errors of what it measures, as standard deviations, with z the distance in metres: across the view
    `z * pixel_error / focal`; along it `z^2 * disparity_error / (focal * baseline)`, as of any triangulation; of the
    orientation `z^2 * angle_error`. The figures are those of a structured-light camera; sources: docs/cell.md.
    """

    name: Identifier
    pose: PoseOfTable
    size: tuple[Positive, Positive] = (2448.0, 2048.0)
    """Width and height of the picture, pixels."""
    focal: Positive = 4062.0
    """Focal length, pixels."""
    reach: Positive = 4.0
    """Metres within which it measures."""
    baseline: Positive = 0.11
    """Metres from projector to camera."""
    pixel_error: NotNegative = 1.0
    """Pixels by which a fitted part is off."""
    disparity_error: NotNegative = 0.08
    """Pixels by which matched points are off, of a fitted part."""
    angle_error: NotNegative = 0.0008
    """Radians at one metre."""

    def errors(self, distance: float) -> tuple[float, float, float]:
        """Standard deviations at a distance: along the view and across it (m), and of the orientation (rad)."""
        square = distance * distance
        along = square * self.disparity_error / (self.focal * self.baseline)
        return along, distance * self.pixel_error / self.focal, square * self.angle_error


@dataclass(frozen=True, slots=True)
class PartSensorSetup(Table):
    """A sensor of part poses. Noise: standard deviations in metres and radians; `rate` in hertz.

    With `cameras` it sees what is in the view of one of them and not hidden, with the errors of the nearest one beside
    the noise given here. Without, it sees all parts wherever they are.
    """

    rate: Annotated[float, Interval(gt=0.0, le=500.0)] = 5.0
    position_noise: NotNegative = 0.0
    angle_noise: NotNegative = 0.0
    seed: Seed = 0
    cameras: tuple[PartCamera, ...] = ()


MAX_PARTS: Final = 250
"""Every part with a connector is a component of one node, which has 254 at most."""


def _with_names(types: object) -> object:
    """The tables of the types with their names in them."""
    if not isinstance(types, Mapping):
        return types
    return {key: _with_name(key, given) for key, given in types.items()}


def _with_name(name: str, given: Any) -> Any:
    if not isinstance(given, Mapping):
        return given
    if "name" in given:
        raise ValueError(f"{name}.name: there is no such key; the name of the table is the type's")
    return {"name": name, **given}


@dataclass(frozen=True, slots=True)
class CellSetup(Table):
    """Contents of a factory cell beside the robot that the URDF describes: the table `[cell]`.

    Units are metres, kilograms, seconds and radians.
    """

    types: Annotated[Mapping[Identifier, PartType], Prepared(_with_names)]
    """The types of parts, by name: tables, or the path of a TOML file that has them."""
    parts: Annotated[tuple[PlacedPart, ...], MaxLen(MAX_PARTS)]
    node: Annotated[int, Interval(ge=1, le=254)] = 2
    """The JAUS node of the modules, one for each part with a servo or connectors."""
    conveyor: ConveyorSetup | None = None
    bins: tuple[BinSetup, ...] = ()
    fixtures: tuple[Fixture, ...] = ()
    target: TargetArea | None = None
    sensor: PartSensorSetup = PartSensorSetup()
    limits: ConnectorLimits = ConnectorLimits()
    gripper: Annotated[str, MaxLen(80)] = ""
    """Link of the URDF with the vacuum gripper, whose z axis points out of it; empty without one."""
    gripper_latch: bool = False
    """True if the gripper has a latch as parts do: it locks on their flanges, and on other faces with `grasp_latch`."""
    pose_error: tuple[NotNegative, NotNegative] = (0.0, 0.0)
    """Largest error of the parts' poses at the start, metres and radians, drawn with `seed`."""
    scatter: bool = False
    """True to have the parts in bins lie anywhere in them, turned at will about their upper face's normal."""
    turned_over: Annotated[float, Interval(ge=0.0, le=1.0)] = 0.0
    """Fraction of the scattered parts that lie on another side, so that one of their further grasps is up."""
    attach_failure: Annotated[float, Interval(ge=0.0, le=1.0)] = 0.0
    """Fraction of the attempts of the gripper to attach that fail by themselves, drawn with `seed`."""
    seed: Seed = 0
    arm: Literal[""] | Identifier = "arm"
    """Name of the modular arm; empty without one."""
    second_arm: Literal[""] | Identifier = ""
    """Name of a second modular arm, which is a chain on a connection of its own; empty without one."""
    contact: ContactReaction = ContactReaction.STOP
    """What the modular arm does when it meets something in its way."""
    car: Literal[""] | Identifier = ""
    """Name of the base that is a car once wheels are attached to it; empty without one."""

    def __post_init__(self) -> None:
        check_unique("parts", tuple(part.name for part in self.parts))
        if self.second_arm and self.second_arm in ("", self.arm):
            raise ValueError(f"second_arm = {self.second_arm!r}: must have another name than arm")
        for number, part in enumerate(self.parts):
            if part.type not in self.types:
                known = ", ".join(sorted(self.types))
                raise ValueError(f"parts[{number}].type = {part.type!r}: no such type; there are: {known}")
            if part.fixed and self.types[part.type].kind is not PartKind.BASE:
                raise ValueError(f"parts[{number}].fixed: {part.name!r} is no base; only those are bolted down")
        if self.car:
            bases = [part.name for part in self.parts if self.types[part.type].kind is PartKind.BASE and not part.fixed]
            if self.car not in bases:
                known = ", ".join(bases) or "none"
                raise ValueError(f"car = {self.car!r}: must be a base that is not fixed; there are: {known}")

    def type_of(self, part: str) -> PartType:
        """The type of a part. Raises `ConfigError` for an unknown name."""
        for placed in self.parts:
            if placed.name == part:
                return self.types[placed.type]
        raise ConfigError(f"no part {part!r}; there are: {', '.join(sorted(placed.name for placed in self.parts))}")


Moments = tuple[Vector, Vector, Vector]

_NONE: Moments = ((0.0, 0.0, 0.0),) * 3


def inertia(solids: Iterable[PartSolid]) -> Inertia:
    """The inertia of solids together, in the frame that their poses are given in; zero mass without solids."""
    return combined((_of_solid(solid), solid.pose) for solid in solids)


def combined(bodies: Iterable[tuple[Inertia, Transform]]) -> Inertia:
    """The inertia of rigidly connected bodies; with each, the pose of its frame in the common one."""
    rows = [(body, pose.apply(body.center), pose) for body, pose in bodies]
    mass = sum(body.mass for body, _, _ in rows)
    if mass <= 0.0:
        return Inertia(0.0, (0.0, 0.0, 0.0), _NONE)
    center: Vector = (0.0, 0.0, 0.0)
    for body, middle, _ in rows:
        center = add(center, scaled(middle, body.mass / mass))
    moments = _NONE
    for body, middle, pose in rows:
        turned = product(product(pose.rotation, body.moments), transposed(pose.rotation))
        moments = _sum(_sum(moments, turned), _of_point(body.mass, difference(middle, center)))
    return Inertia(mass, center, moments)


def body_inertia(part: PartType) -> Inertia:
    """Mass and inertia of a part; of a servo, those of its housing without the output link."""
    return inertia(part.solids)


def output_inertia(part: PartType) -> Inertia:
    """Mass and inertia of a servo's output link, in its frame, without the rotor; zero for other parts."""
    return inertia(part.servo.output if part.servo is not None else ())


def _of_solid(solid: PartSolid) -> Inertia:
    x, y, z = solid.size
    if solid.shape is Shape.CUBOID:
        squares = (y * y + z * z) / 12.0, (x * x + z * z) / 12.0, (x * x + y * y) / 12.0
    else:
        transverse = (3.0 * x * x + z * z) / 12.0
        squares = transverse, transverse, x * x / 2.0
    a, b, c = scaled(squares, solid.mass)
    return Inertia(solid.mass, IDENTITY.position, ((a, 0.0, 0.0), (0.0, b, 0.0), (0.0, 0.0, c)))


def _of_point(mass: float, position: Vector) -> Moments:
    """Moments of inertia of a point mass: m (r.r I - r r^T)."""
    square = dot(position, position)
    x, y, z = position
    return (
        (mass * (square - x * x), -mass * x * y, -mass * x * z),
        (-mass * x * y, mass * (square - y * y), -mass * y * z),
        (-mass * x * z, -mass * y * z, mass * (square - z * z)),
    )


def _sum(a: Moments, b: Moments) -> Moments:
    return add(a[0], b[0]), add(a[1], b[1]), add(a[2], b[2])


def mass_of(part: PartType) -> float:
    """Kilograms of a whole part."""
    return body_inertia(part).mass + output_inertia(part).mass
