"""A plant for the control of modular arms: servo modules with rotor, friction and spring, links by pinocchio.

It integrates rotors and links with steps of 0.25 ms. What is attached to what is set by its connectors.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
import pinocchio as pin

from jauspy.geometry.poses import IDENTITY, Pose, Transform
from jauspy.geometry.vectors import Vector
from jauspy.platform.joints import Gains
from jauspy.platform.modular.assembled_arm import AssembledArm
from jauspy.platform.modular.assembly import ArmAssembly
from jauspy.platform.modular.connector import ConnectorState, VacuumConnector
from jauspy.platform.modular.control_laws import JointMeasurements
from jauspy.platform.modular.dynamics import ArmModel
from jauspy.platform.modular.graph import attachments, find_chain
from jauspy.platform.modular.parts import CellSetup, PartKind, PartSolid, PartType, PlacedPart, ServoData, Shape
from jauspy.platform.modular.servo import ServoReading

STEP = 0.00025
PERIOD = 0.002


def cylinder(mass: float, radius: float, length: float, z: float) -> PartSolid:
    return PartSolid(Shape.CYLINDER, (radius, radius, length), mass, Transform(position=(0.0, 0.0, z)))


def cuboid(mass: float, size: Vector, z: float) -> PartSolid:
    return PartSolid(Shape.CUBOID, size, mass, Transform(position=(0.0, 0.0, z)))


def along_z(z: float) -> Transform:
    return Transform(position=(0.0, 0.0, z))


def servo_type(name: str, *figures: float, elbow: bool) -> PartType:
    """A module with the figures of a data sheet: torque, speed, friction, damping, stiffness, rotor, housing."""
    torque, speed, friction, damping, stiffness, rotor, mass = figures
    height = 0.055 if elbow else 0.045
    data = ServoData(
        max_torque=torque,
        max_speed=speed,
        friction=friction,
        damping=damping,
        stiffness=stiffness,
        rotor_inertia=rotor,
        torque_constant=8.0,
        axis=(0.0, 1.0, 0.0) if elbow else (0.0, 0.0, 1.0),
        joint=along_z(0.08 if elbow else 0.09),
        output=(cylinder(0.12, 0.03, 0.02, 0.065 if elbow else 0.016),),
        position_gains=Gains(5.0 * torque, 4.0 * torque, 0.25 * torque, 0.5 * torque),
    )
    housing = (cuboid(mass, (0.064, 0.05, 2.0 * height), height),)
    return PartType(name, PartKind.SERVO, housing, {"output": along_z(0.075 if elbow else 0.03)}, data)


TYPES = {
    each.name: each
    for each in (
        PartType("base", PartKind.BASE, (cuboid(5.0, (0.2, 0.2, 0.1), -0.05),), {"top": IDENTITY}),
        servo_type("inline", 13.0, 1.503, 0.45, 0.6, 170.0, 0.3, 0.36, elbow=False),
        servo_type("shoulder", 38.0, 1.79, 0.9, 1.2, 280.0, 0.53, 0.5, elbow=True),
        servo_type("elbow", 20.0, 3.435, 0.5, 0.5, 170.0, 0.145, 0.48, elbow=True),
        servo_type("wrist", 7.0, 3.435, 0.25, 0.2, 130.0, 0.07, 0.335, elbow=True),
        servo_type("roll", 7.0, 3.435, 0.25, 0.2, 130.0, 0.07, 0.335, elbow=False),
        PartType("bracket", PartKind.BRACKET, (cylinder(0.1, 0.03, 0.03, 0.015),), {"end": along_z(0.03)}),
        PartType("tube", PartKind.TUBE, (cylinder(0.15, 0.02, 0.25, 0.125),), {"end": along_z(0.25)}),
        PartType("wheel", PartKind.WHEEL, (cylinder(0.3, 0.08, 0.04, 0.02),)),
        PartType("box", PartKind.BOX, (cuboid(0.5, (0.12, 0.12, 0.1), 0.05),)),
    )
}

FIVE = (
    ("servo_1", "inline"),
    ("bracket_1", "bracket"),
    ("servo_2", "shoulder"),
    ("tube_1", "tube"),
    ("servo_3", "elbow"),
    ("tube_2", "tube"),
    ("servo_4", "wrist"),
    ("servo_5", "roll"),
)
"""The arm of five joints, from its base up: names and types."""


def many(count: int) -> tuple[tuple[str, str], ...]:
    """An arm of any number of joints: light modules that turn about alternating axes."""
    kinds = ("inline", "shoulder", "elbow", "wrist", "roll", "wrist", "roll", "wrist", "roll")
    return tuple((f"servo_{at + 1}", kinds[at]) for at in range(count))


def cell_of(parts: Sequence[tuple[str, str]]) -> CellSetup:
    """A cell with these parts, two platforms, and a box."""
    bases = (
        PlacedPart("platform_1", "base", Pose(), fixed=True),
        PlacedPart("platform_2", "base", Pose(x=0.6), fixed=True),
    )
    placed = tuple(PlacedPart(name, kind, Pose()) for name, kind in (*parts, ("box_1", "box")))
    return CellSetup(TYPES, (*bases, *placed))


@dataclass
class PlantConnector(VacuumConnector):
    """A connector whose state tests set."""

    name: str
    plant: "ServoPlant"
    current: ConnectorState = field(default_factory=lambda: ConnectorState(powered=True))

    def state(self) -> ConnectorState:
        return self.current

    def set(self, enabled: bool) -> None:
        self.current = replace(self.current, enabled=enabled)

    def schedule(self, enabled: bool, delay: float) -> None:
        raise NotImplementedError

    def cancel(self) -> None:
        raise NotImplementedError

    def attach(self, part: str, offset: Transform = IDENTITY) -> None:
        self.current = replace(self.current, attached_to=part, offset=offset)
        self.plant.rebuild()

    def release(self) -> None:
        self.attach("")


@dataclass
class PlantServo:
    """A servo module of the plant."""

    name: str
    data: ServoData
    plant: "ServoPlant"
    powered: bool = True
    q: float = 0.0
    v: float = 0.0
    theta: float = 0.0
    omega: float = 0.0
    motor: float = 0.0
    claimed_by: str = ""
    held: int = 0

    @property
    def spring(self) -> float:
        return self.data.stiffness * (self.theta - self.q)

    def read(self) -> ServoReading:
        return ServoReading(self.powered, self.q, self.v, self.spring)

    def set_torque(self, torque: float) -> None:
        self.motor = min(self.data.max_torque, max(-self.data.max_torque, torque))

    def hold(self) -> None:
        self.held += 1
        self.motor = 0.0

    def claim(self, arm: str) -> None:
        self.claimed_by = arm

    def gains(self) -> tuple[Gains, Gains]:
        return self.data.position_gains, self.data.velocity_gains


class ServoPlant:
    """An arm of servo modules on `platform_1`, with its connectors, integrated by `step`."""

    def __init__(self, parts: Sequence[tuple[str, str]] = FIVE, *, box_mass: float = 0.5) -> None:
        self.cell = cell_of(parts)
        self.box_mass = box_mass
        self.revision = 0
        self.now = 0.0
        kinds = dict(parts)
        self.servos = {
            name: PlantServo(name, data, self) for name, kind in parts if (data := TYPES[kind].servo) is not None
        }
        names = [(name, kind) for name, kind in (("platform_1", "base"), ("platform_2", "base"), *kinds.items())]
        self.connectors = {
            f"{name}/{own}": PlantConnector(f"{name}/{own}", self)
            for name, kind in names
            for own in TYPES[kind].connectors
        }
        self.connectors["gripper"] = PlantConnector("gripper", self)
        self.assemble([name for name, _ in parts])

    def assemble(self, names: Sequence[str], offsets: Mapping[str, Transform] | None = None) -> None:
        """Put these parts on each other, on `platform_1`; `offsets` by connector."""
        at = "platform_1"
        for name in names:
            connector = next(each for each in self.connectors if each.startswith(f"{at}/"))
            offset = (offsets or {}).get(connector, IDENTITY)
            state = ConnectorState(powered=True, attached_to=name, offset=offset)
            self.connectors[connector].current = state
            at = name
        self.rebuild()

    def rebuild(self) -> None:
        """Follow the connectors."""
        self.revision += 1
        held = attachments((each.name, each.current) for each in self.connectors.values())
        self.chain = find_chain(self.cell, held, getattr(self, "chain", None).base if hasattr(self, "chain") else "")
        self.model = ArmModel(self.cell, self.chain)
        self.model.set_load(self.box_mass)
        self.order = [self.servos[name] for name in self.chain.joints]

    def arm(self, **arguments: object) -> AssembledArm:
        """Its controller."""
        connectors = list(self.connectors.values())
        return AssembledArm("arm", self.cell, self.servos, connectors, revision=lambda: self.revision, **arguments)

    def assembly(self) -> ArmAssembly:
        """The arm as it is assembled now, for its controller."""
        connected = attachments((name, connector.current) for name, connector in self.connectors.items())
        poses = {part.name: part.pose for part in self.cell.parts}
        chain = find_chain(self.cell, connected, self.chain.base)
        return ArmAssembly(self.cell, chain, self.servos, poses.__getitem__, connected)

    def measured(self) -> JointMeasurements:
        """What its modules measure while it stands."""
        springs = np.array([servo.spring for servo in self.order])
        return JointMeasurements(np.array(self.positions), np.array(self.velocities), springs, np.zeros(len(springs)))

    def settle(self, positions: Sequence[float]) -> None:
        """Set the positions, at rest under gravity."""
        q = np.array(positions, dtype=float)
        gravity = self.model.gravity(q)
        for servo, position, torque in zip(self.order, q, gravity, strict=True):
            servo.q, servo.v, servo.omega = float(position), 0.0, 0.0
            servo.theta = servo.q + float(torque) / servo.data.stiffness
            servo.motor = float(torque)

    def run(self, arm: AssembledArm, seconds: float) -> list[list[float]]:
        """Control and integrate; the motor torques of each cycle."""
        torques = []
        for _ in range(round(seconds / PERIOD)):
            arm.control(self.now, PERIOD)
            torques.append([servo.motor for servo in self.order])
            for _ in range(round(PERIOD / STEP)):
                self.step()
        return torques

    def step(self) -> None:
        """Integrate by `STEP`; the links of a closed loop stand still."""
        self.now += STEP
        order = self.order
        if not order:
            return
        q = np.array([servo.q for servo in order])
        v = np.array([servo.v for servo in order])
        springs = np.array([servo.spring for servo in order])
        structural = np.array([0.0005 * servo.data.stiffness * (servo.omega - servo.v) for servo in order])
        # pinocchio's own forward dynamics, so that the controller's inverse dynamics is not tested by itself
        model, data = self.model._model, self.model._data
        acceleration = pin.aba(model, data, q, v, springs + structural)
        if self.chain.held_by:
            acceleration = -v / STEP
        for servo, a, spring, loss in zip(order, acceleration, springs, structural, strict=True):
            motor = servo.motor if servo.powered else 0.0
            free = motor - spring - loss - servo.data.damping * servo.omega
            rate = servo.omega + free / servo.data.rotor_inertia * STEP
            stop = servo.data.friction / servo.data.rotor_inertia * STEP
            servo.omega = math.copysign(max(0.0, abs(rate) - stop), rate)
            servo.theta += servo.omega * STEP
            servo.v += float(a) * STEP
            servo.q += servo.v * STEP

    @property
    def positions(self) -> list[float]:
        return [servo.q for servo in self.order]

    @property
    def velocities(self) -> list[float]:
        return [servo.v for servo in self.order]
