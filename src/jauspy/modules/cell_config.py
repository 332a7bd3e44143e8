"""The table `[cell]` of a robot's TOML file: the factory cell around the robot, and the types of its parts.

The keys are the fields of the dataclasses in `jauspy.platform.modular.parts`; units are metres, kilograms, seconds and
radians. A pose is written `{ xyz = [1.0, 0.0, 0.2], rpy = [0.0, 0.0, 1.57] }`; what is left out is zero.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Annotated, Final, Literal, Self, TypeAlias

from pydantic import Field, model_validator

from jauspy.geometry.poses import Pose, Transform
from jauspy.geometry.vectors import Vector
from jauspy.modules.config_base import GainsConfig, StrictConfig
from jauspy.platform.modular.parts import (
    POSITION_GAINS,
    VELOCITY_GAINS,
    BinSetup,
    CellSetup,
    ConnectorLimits,
    ConveyorSetup,
    Fixture,
    PartKind,
    PartSensorSetup,
    PartType,
    PlacedPart,
    ServoData,
    Shape,
    Solid,
    TargetArea,
)

Name: TypeAlias = Annotated[str, Field(min_length=1, max_length=60, pattern=r"^[A-Za-z0-9_.+-]+$")]
"""Of a part, type or connector; names of connectors are joined with a slash, as in `servo_1/output`."""

Number: TypeAlias = Annotated[float, Field(allow_inf_nan=False)]
Position: TypeAlias = tuple[Number, Number, Number]
Positive: TypeAlias = Annotated[float, Field(gt=0.0, allow_inf_nan=False)]
NotNegative: TypeAlias = Annotated[float, Field(ge=0.0, allow_inf_nan=False)]
Seed: TypeAlias = Annotated[int, Field(ge=0)]

MAX_PARTS: Final = 250
"""Every part with a connector is a component of one node, which has 254 at most."""


class PoseConfig(StrictConfig):
    """A position in metres, and fixed-axis roll, pitch and yaw in radians."""

    xyz: Position = (0.0, 0.0, 0.0)
    rpy: Position = (0.0, 0.0, 0.0)

    def pose(self) -> Pose:
        """Return the pose."""
        return Pose(*self.xyz, *self.rpy)

    def transform(self) -> Transform:
        """Return the frame of the pose."""
        return Transform.from_pose(self.pose())


class SolidConfig(StrictConfig):
    """A primitive of a part; see `Solid`."""

    shape: Shape
    size: tuple[Positive, Positive, Positive]
    mass: NotNegative = 0.0
    pose: PoseConfig = PoseConfig()

    @model_validator(mode="after")
    def _check_size(self) -> Self:
        if self.shape is Shape.CYLINDER and self.size[0] != self.size[1]:
            raise ValueError(f"size: {list(self.size)}: a cylinder has its radius twice, and then its length")
        return self

    def solid(self) -> Solid:
        """Return the primitive."""
        return Solid(self.shape, self.size, self.mass, self.pose.transform())


class ServoConfig(StrictConfig):
    """Motor, gear and limits of a servo module; see `ServoData`."""

    max_torque: Positive
    max_speed: Positive
    friction: NotNegative
    damping: NotNegative
    stiffness: Positive
    rotor_inertia: Positive
    torque_constant: Positive
    axis: Position = (0.0, 0.0, 1.0)
    joint: PoseConfig = PoseConfig()
    output: tuple[SolidConfig, ...] = ()
    position_gains: GainsConfig | None = None
    velocity_gains: GainsConfig | None = None

    @model_validator(mode="after")
    def _check_axis(self) -> Self:
        if not math.hypot(*self.axis):
            raise ValueError("axis: it must not be zero")
        return self

    def data(self) -> ServoData:
        """Return the data sheet; the axis is of length 1."""
        length = math.hypot(*self.axis)
        axis: Vector = (self.axis[0] / length, self.axis[1] / length, self.axis[2] / length)
        return ServoData(
            self.max_torque,
            self.max_speed,
            self.friction,
            self.damping,
            self.stiffness,
            self.rotor_inertia,
            self.torque_constant,
            axis,
            self.joint.transform(),
            tuple(each.solid() for each in self.output),
            POSITION_GAINS if self.position_gains is None else self.position_gains.gains(),
            VELOCITY_GAINS if self.velocity_gains is None else self.velocity_gains.gains(),
        )


class PartTypeConfig(StrictConfig):
    """One type of part; see `PartType`."""

    kind: PartKind
    solids: Annotated[tuple[SolidConfig, ...], Field(min_length=1)]
    connectors: Mapping[Name, PoseConfig] = {}
    servo: ServoConfig | None = None
    grasp: PoseConfig = PoseConfig()

    @model_validator(mode="after")
    def _check_kind(self) -> Self:
        if (self.kind is PartKind.SERVO) != (self.servo is not None):
            raise ValueError("servo: parts of the kind servo need this table, and no others have it")
        if self.kind is PartKind.BOX and self.connectors:
            raise ValueError("connectors: a box has none")
        if not sum(each.mass for each in self.solids):
            raise ValueError("solids: they need a mass; only what is fixed to the world has none")
        return self

    @property
    def is_module(self) -> bool:
        """True if it has a servo or a connector, which can be commanded."""
        return self.servo is not None or bool(self.connectors)

    def part_type(self, name: str) -> PartType:
        """Return the type of that name."""
        connectors = {key: pose.transform() for key, pose in self.connectors.items()}
        servo = self.servo.data() if self.servo else None
        solids = tuple(each.solid() for each in self.solids)
        return PartType(name, self.kind, solids, connectors, servo, self.grasp.transform())


class PlacedPartConfig(StrictConfig):
    """One part and its initial pose."""

    name: Name
    type: Name
    pose: PoseConfig
    fixed: bool = False
    """True for a base that is bolted to the world."""


class ConveyorConfig(StrictConfig):
    """A straight conveyor; see `ConveyorSetup`."""

    pose: PoseConfig
    length: Positive
    width: Positive
    max_speed: Positive

    def setup(self) -> ConveyorSetup:
        """Return the setup for the backend."""
        return ConveyorSetup(self.pose.pose(), self.length, self.width, self.max_speed)


class BinConfig(StrictConfig):
    """A bin with a slanted floor; see `BinSetup`."""

    name: Name
    pose: PoseConfig
    length: Positive
    width: Positive
    wall: Positive = 0.05
    thickness: Positive = 0.008

    def setup(self) -> BinSetup:
        """Return the setup for the backend."""
        return BinSetup(self.name, self.pose.pose(), self.length, self.width, self.wall, self.thickness)


class FixtureConfig(StrictConfig):
    """A fixed object in the cell; see `Fixture`."""

    name: Name
    solids: Annotated[tuple[SolidConfig, ...], Field(min_length=1)]
    pose: PoseConfig = PoseConfig()

    def setup(self) -> Fixture:
        """Return the setup for the backend."""
        return Fixture(self.name, tuple(each.solid() for each in self.solids), self.pose.pose())


class TargetConfig(StrictConfig):
    """A rectangle on the ground into which boxes are thrown."""

    pose: PoseConfig
    length: Positive
    width: Positive

    def setup(self) -> TargetArea:
        """Return the area."""
        return TargetArea(self.pose.pose(), self.length, self.width)


class PartSensorConfig(StrictConfig):
    """The sensor of part poses."""

    rate: Annotated[float, Field(gt=0.0, le=500.0)] = 5.0
    position_noise: NotNegative = 0.0
    angle_noise: NotNegative = 0.0
    seed: Seed = 0

    def setup(self) -> PartSensorSetup:
        """Return the setup for the backend."""
        return PartSensorSetup(self.rate, self.position_noise, self.angle_noise, self.seed)


class ConnectorLimitsConfig(StrictConfig):
    """Tolerances for the attachment of vacuum connectors, and the loads that they hold."""

    max_distance: Positive = ConnectorLimits().max_distance
    max_angle: Annotated[float, Field(gt=0.0, le=math.pi)] = ConnectorLimits().max_angle
    max_force: Positive = ConnectorLimits().max_force
    max_moment: Positive = ConnectorLimits().max_moment

    def limits(self) -> ConnectorLimits:
        """Return the limits for the backend."""
        return ConnectorLimits(self.max_distance, self.max_angle, self.max_force, self.max_moment)


class CellConfig(StrictConfig):
    """A factory cell around the robot that the URDF describes; see `CellSetup`."""

    types: Mapping[Name, PartTypeConfig]
    """The types of parts, by name: tables, or the path of a TOML file that has them."""
    parts: Annotated[tuple[PlacedPartConfig, ...], Field(max_length=MAX_PARTS)]
    node: Annotated[int, Field(ge=1, le=254)] = 2
    """The JAUS node of the modules, one for each part with a servo or connectors."""
    conveyor: ConveyorConfig | None = None
    bins: tuple[BinConfig, ...] = ()
    fixtures: tuple[FixtureConfig, ...] = ()
    target: TargetConfig | None = None
    sensor: PartSensorConfig = PartSensorConfig()
    limits: ConnectorLimitsConfig = ConnectorLimitsConfig()
    gripper: Annotated[str, Field(max_length=80)] = ""
    pose_error: tuple[NotNegative, NotNegative] = (0.0, 0.0)
    attach_failure: Annotated[float, Field(ge=0.0, le=1.0)] = 0.0
    seed: Seed = 0
    arm: Literal[""] | Name = "arm"
    car: Literal[""] | Name = ""

    @model_validator(mode="after")
    def _check_parts(self) -> Self:
        names = [part.name for part in self.parts]
        if len(set(names)) < len(names):
            twice = sorted({name for name in names if names.count(name) > 1})
            raise ValueError(f"cell.parts: {', '.join(twice)} is there twice")
        for number, part in enumerate(self.parts):
            if part.type not in self.types:
                known = ", ".join(sorted(self.types))
                raise ValueError(f"cell.parts[{number}].type = {part.type!r}: no such type; there are: {known}")
            if part.fixed and self.types[part.type].kind is not PartKind.BASE:
                raise ValueError(f"cell.parts[{number}].fixed: {part.name!r} is no base; only those are bolted down")
        if self.car:
            bases = [each.name for each in self.parts if self.types[each.type].kind is PartKind.BASE and not each.fixed]
            if self.car not in bases:
                known = ", ".join(bases) or "none"
                raise ValueError(f"cell.car = {self.car!r}: must be a base that is not fixed; there are: {known}")
        return self

    def setup(self) -> CellSetup:
        """Return the setup for the backend."""
        return CellSetup(
            types={name: each.part_type(name) for name, each in self.types.items()},
            parts=tuple(PlacedPart(each.name, each.type, each.pose.pose(), each.fixed) for each in self.parts),
            conveyor=self.conveyor.setup() if self.conveyor else None,
            bins=tuple(each.setup() for each in self.bins),
            fixtures=tuple(each.setup() for each in self.fixtures),
            target=self.target.setup() if self.target else None,
            sensor=self.sensor.setup(),
            limits=self.limits.limits(),
            gripper=self.gripper,
            pose_error=self.pose_error,
            attach_failure=self.attach_failure,
            seed=self.seed,
            arm=self.arm,
            car=self.car,
        )
