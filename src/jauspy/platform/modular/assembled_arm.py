"""The controller of a modular arm: it follows changes of attachments, plans motions, and commands the modules."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from jauspy.geometry.poses import Pose
from jauspy.platform.joints import ContactReaction
from jauspy.platform.modular.arm import (
    CHANGED,
    ArmController,
    ArmMotion,
    ModularArm,
    ModularArmState,
    TrajectoryPoint,
)
from jauspy.platform.modular.arm_setpoints import ArmSetpoints
from jauspy.platform.modular.assembly import ArmAssembly, carried_over
from jauspy.platform.modular.connector import VacuumConnector
from jauspy.platform.modular.contact import NEAR
from jauspy.platform.modular.control_laws import JointMeasurements
from jauspy.platform.modular.graph import ArmChain, attachments, find_chain
from jauspy.platform.modular.parts import CellSetup
from jauspy.platform.modular.servo import ServoDrive, ServoReading
from jauspy.platform.modular.splines import Knots
from jauspy.platform.modular.torque_controller import TorqueController

Array = NDArray[np.float64]


class AssembledArm(ModularArm):
    """Moves the longest chain of servo modules that a base carries, beside the one of another arm.

    In a cell with a second arm, each keeps the connection that carries it; `other_base` returns that of the other one.
    The backend calls `control` at a fixed rate (250 to 500 Hz), all in the robot's thread. It reads the states of
    connectors again only when `revision` has changed, which counts attachments and releases of the whole cell.
    `base_pose` returns the pose of a base in the world, given its name; without it, bases stand where `cell` says.
    """

    def __init__(
        self,
        name: str,
        cell: CellSetup,
        servos: Mapping[str, ServoDrive],
        connectors: Sequence[VacuumConnector],
        *,
        revision: Callable[[], int],
        base_pose: Callable[[str], Pose] | None = None,
        other_base: Callable[[], str] = str,
    ) -> None:
        self.name = name
        self._other_base = other_base
        self._cell = cell
        self._servos = servos
        self._connectors = connectors
        self._count_changes = revision
        self._revision: int | None = None
        placed = {part.name: part.pose for part in cell.parts}
        self._base_pose = base_pose or placed.__getitem__
        self._motion = 0
        self._order: tuple[str, ...] = ()
        self._index: tuple[int, ...] = ()
        self._assembly = ArmAssembly(cell, ArmChain(), servos, self._base_pose)
        self._setpoints = ArmSetpoints(self._assembly)
        self._torques = TorqueController(self._assembly)
        self._readings: list[ServoReading] = []
        self._powered: list[bool] = []
        none = np.zeros(0)
        self._measured = JointMeasurements(none, none, none, none)

    @property
    def chain(self) -> ArmChain:
        """The arm as it is assembled now."""
        return self._assembly.chain

    def state(self) -> ModularArmState:
        """State of the joints, and of the motion."""
        chain, index = self.chain, self._index
        readings, targets = self._readings, self._setpoints.targets
        return ModularArmState(
            base=chain.base,
            tip=chain.tip,
            joints=tuple(chain.joints[joint] for joint in index),
            parts=chain.parts,
            positions=tuple(readings[joint].position for joint in index),
            velocities=tuple(readings[joint].velocity for joint in index),
            efforts=tuple(readings[joint].torque for joint in index),
            targets=tuple(targets[joint] for joint in index),
            moving=self._setpoints.moving,
            controller=self._torques.selected,
            payload=self._assembly.model.load_mass,
            tip_pose=self._assembly.tip_pose(np.array([reading.position for reading in readings])),
            motion=self._motion,
            result=self._setpoints.result,
            error=self._setpoints.error,
        )

    def begin(self, motion: ArmMotion) -> None:
        """Begin a motion; see `ModularArm.move` and `ModularArm.follow`. NaN as time of one point is like 0."""
        self._motion = motion.number
        points = motion.points or ()
        if refusal := self._refusal(motion, points):
            self._setpoints.refuse(refusal)
            return
        columns = self._columns(motion.joints)
        shaped = self._torques.selected is ArmController.MODEL
        targets = np.array(self._setpoints.targets)
        if len(points) > 1 or not points[0].is_plain:
            self._setpoints.begin_spline(_knots(points, columns, targets), shaped=shaped)
            return
        given = np.array(points[0].positions, dtype=float)
        targets[columns] = np.where(np.isnan(given), targets[columns], given)
        duration = points[0].time
        self._setpoints.begin(targets.tolist(), 0.0 if math.isnan(duration) else duration, shaped=shaped)

    def hold(self) -> None:
        """Brake along the present path, and hold all joints."""
        self._setpoints.brake()

    def set_controller(self, controller: ArmController) -> None:
        """Select the controller of the joints; torques fade over from one controller to the other."""
        self._torques.select(controller)

    def set_order(self, joints: Sequence[str]) -> None:
        """Fix the order of the joints by names; those that are not named follow in the order of the chain."""
        unknown = [name for name in joints if name not in self._servos]
        if unknown or len(set(joints)) != len(joints):
            problem = f"no servo module {unknown[0]!r}" if unknown else "a servo module is named twice"
            available = ", ".join(sorted(self._servos))
            self._setpoints.error = f"order of joints refused: {problem}; there are: {available}"
            return
        self._order = tuple(joints)
        self._index = self._find_index()
        self._setpoints.error = ""

    def control(self, now: float, dt: float) -> None:  # noqa: ARG002 - backends pass their time to all controllers
        """Command the servo modules for the next `dt` seconds."""
        revision = self._count_changes()
        if revision != self._revision:
            self._revision = revision
            self._follow_attachments()
        if not self._assembly.drives:
            return
        self._read(dt)
        if all(self._powered):
            self._watch_contact(dt)
            self._assembly.update_load(self._measured, dt)
        setpoint = self._setpoints.advance(self._measured, self._powered, dt)
        torques = self._torques.update(setpoint, self._measured, dt)
        for drive, reading, torque in zip(self._assembly.drives, self._readings, torques.tolist(), strict=True):
            if reading.powered:
                drive.set_torque(torque)

    def _watch_contact(self, dt: float) -> None:
        """End the motion in progress if something is in the way. A closed loop has forces of its own."""
        contact, reaction = self._assembly.contact, self._cell.contact
        contact.update(self._measured, dt)
        if reaction is ContactReaction.IGNORE or not self._setpoints.moving or self.chain.held_by:
            return
        if touched := contact.touched(seeks=self._seeks):
            way = np.array(self._setpoints.targets) - self._measured.q
            rows = [
                f"{self.chain.joints[joint]}, {abs(contact.external[joint]):.0f} N m, {abs(way[joint]):.2f} rad short"
                for joint in touched
            ]
            gives_way = reaction is ContactReaction.YIELD
            end = "the arm gives way" if gives_way else "the arm holds where it is"
            self._setpoints.block(f"Blocked: {'; '.join(rows)}; {end}", self._measured, gives_way=gives_way)
            self._torques.restart(self._assembly.model.gravity(self._measured.q))

    def _seeks(self) -> bool:
        """True if the arm is to touch something.

        It is close to its target, or a connector of the arm or of a base that is bolted down seeks a part.
        """
        if float(np.abs(np.array(self._setpoints.targets) - self._measured.q).max(initial=0.0)) < NEAR:
            return True
        owners = {*self.chain.parts, *(part.name for part in self._cell.parts if part.fixed)}
        states = [connector.state() for connector in self._connectors if connector.name.partition("/")[0] in owners]
        return any(state.enabled and not state.attached_to for state in states)

    def _follow_attachments(self) -> None:
        """Adopt the arm that is assembled now."""
        connected = attachments((connector.name, connector.state()) for connector in self._connectors)
        keeps = bool(self._cell.second_arm)
        chain = find_chain(self._cell, connected, self.chain.base, self._other_base(), keeps=keeps)
        if chain == self.chain:
            return
        before = self.chain.joints
        for name in before:
            if name not in chain.joints:
                self._servos[name].claim("")
                self._servos[name].hold()
        self._adopt(ArmAssembly(self._cell, chain, self._servos, self._base_pose, connected))
        for drive in self._assembly.drives:
            drive.claim(self.name)

    def _adopt(self, assembly: ArmAssembly) -> None:
        """Go on with another assembly: joints that both have keep setpoints and torques."""
        before, after = self.chain.joints, assembly.chain.joints
        readings = assembly.read()
        springs = [reading.torque for reading in readings]
        self._setpoints.adopt(assembly, readings)
        self._torques.adopt(assembly, carried_over(before, after, self._torques.last_torques, springs))
        self._measured = JointMeasurements(
            np.array([reading.position for reading in readings]),
            np.array([reading.velocity for reading in readings]),
            carried_over(before, after, self._measured.spring, springs),
            np.zeros(len(readings)),
        )
        self._assembly = assembly
        self._readings = readings
        self._powered = [reading.powered for reading in readings]
        self._index = self._find_index()

    def _find_index(self) -> tuple[int, ...]:
        """The indices of the joints in the chain, in the order of commands and states."""
        joints = self.chain.joints
        named = [name for name in self._order if name in joints]
        return tuple(joints.index(name) for name in (*named, *(name for name in joints if name not in named)))

    def _read(self, dt: float) -> None:
        self._readings = self._assembly.read()
        table = np.array([reading[1:] for reading in self._readings])
        q, v, spring = table[:, 0], table[:, 1], table[:, 2]
        self._measured = JointMeasurements(q, v, spring, (spring - self._measured.spring) / dt)
        powered = [reading.powered for reading in self._readings]
        if powered != self._powered:
            self._follow_power(powered)

    def _follow_power(self, powered: list[bool]) -> None:
        """Brake if a module has fallen silent in a motion; one that reports again holds where it is."""
        changes = list(zip(self.chain.joints, self._powered, powered, strict=True))
        silent = [name for name, before, now in changes if before and not now]
        returned = [name for name, before, now in changes if now and not before]
        self._powered = powered
        if silent and self._setpoints.moving:
            self._setpoints.fail(f"the motion ended early: no report of {', '.join(silent)}")
            self._setpoints.brake()
        elif returned:
            self._setpoints.come_to_rest()
        self._torques.restart(np.where(powered, self._torques.last_torques, self._measured.spring))
        self._assembly.contact.restart()

    def _columns(self, joints: tuple[str, ...] | None) -> list[int]:
        """The indices in the chain of the joints that a motion names."""
        return list(self._index) if joints is None else [self.chain.joints.index(name) for name in joints]

    def _refusal(self, motion: ArmMotion, points: Sequence[TrajectoryPoint]) -> str:
        """Reason to refuse a motion; empty if it can begin, as far as limits allow."""
        present = tuple(self.chain.joints[joint] for joint in self._index)
        names = present if motion.joints is None else motion.joints
        if not present:
            return "no servo module is attached to a base"
        if motion.known is not None and motion.known != present:
            return CHANGED
        if unknown := [name for name in names if name not in present]:
            return f"the arm has no joint {unknown[0]!r}; it has {', '.join(present)}"
        if len(set(names)) != len(names):
            return "a joint is named twice"
        if problem := _values_problem(names, points):
            return problem
        if self.chain.held_by:
            return f"the arm is also held by {', '.join(self.chain.held_by)}"
        silent = [
            name
            for number, (name, joint) in enumerate(zip(names, self._columns(motion.joints), strict=True))
            if not (self._powered[joint] or math.isnan(points[-1].positions[number]))
        ]
        return f"no report of {', '.join(silent)}" if silent else ""


def _values_problem(names: Sequence[str], points: Sequence[TrajectoryPoint]) -> str:
    """Reason why values do not fit these joints; empty if they do."""
    if not points:
        return "it has no points"
    if not names and len(points) > 1:
        return "it names no joint"
    for number, point in enumerate(points, 1):
        where = f" at point {number}" if len(points) > 1 else ""
        if len(point.positions) != len(names):
            return f"{len(point.positions)} positions for {len(names)} joints ({', '.join(names)}){where}"
        if any(len(values) not in (0, len(names)) for values in (point.velocities, point.accelerations)):
            return f"velocities or accelerations for another number of joints than {len(names)}{where}"
        if any(map(math.isinf, (*point.positions, *point.velocities, *point.accelerations))):
            return f"a position is infinite{where}" if any(map(math.isinf, point.positions)) else f"infinite{where}"
        if math.isinf(point.time) or point.time < 0.0:
            return f"a duration of {point.time} s{where}"
        spline = len(points) > 1 or not point.is_plain
        if spline and any(map(math.isnan, (point.time, *point.positions))):
            return f"a time or a position is not a number{where}"
    return ""


def _knots(points: Sequence[TrajectoryPoint], columns: Sequence[int], targets: Array) -> Knots:
    """Points for all joints of the chain: those that a trajectory does not name are at their targets."""
    count, free = len(points), np.full((len(points), len(targets)), math.nan)
    knots = Knots(np.array([point.time for point in points]), np.tile(targets, (count, 1)), free, free.copy())
    for row, point in enumerate(points):
        knots.positions[row, columns] = point.positions
        for table, values in ((knots.velocities, point.velocities), (knots.accelerations, point.accelerations)):
            if values:
                table[row, columns] = values
    return knots
