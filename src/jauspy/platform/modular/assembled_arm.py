"""The controller of a modular arm: it follows changes of attachments, plans motions, and commands the modules."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence

import numpy as np

from jauspy.geometry.poses import Pose
from jauspy.platform.modular.arm import ArmController, ModularArm, ModularArmState
from jauspy.platform.modular.arm_setpoints import ArmSetpoints
from jauspy.platform.modular.assembly import ArmAssembly, carried_over
from jauspy.platform.modular.connector import VacuumConnector
from jauspy.platform.modular.control_laws import JointMeasurements
from jauspy.platform.modular.graph import ArmChain, attachments, find_chain
from jauspy.platform.modular.parts import CellSetup
from jauspy.platform.modular.servo import ServoDrive, ServoReading
from jauspy.platform.modular.torque_controller import TorqueController


class AssembledArm(ModularArm):
    """Moves the longest chain of servo modules that a base carries.

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
    ) -> None:
        self.name = name
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
            error=self._setpoints.error,
        )

    def move(self, positions: Sequence[float], duration: float) -> int:
        """Move the joints; see `ModularArm.move`. With NaN as duration it takes as long as the limits demand."""
        self.move_as(self._motion + 1, positions, duration)
        return self._motion

    def move_as(self, number: int, positions: Sequence[float], duration: float) -> None:
        """Same as `move`, with the number that another thread has given to the motion."""
        self._motion = number
        error = self._refusal(positions, duration)
        if error:
            self._setpoints.error = error
            return
        targets = list(self._setpoints.targets)
        for joint, position in zip(self._index, positions, strict=True):
            if not math.isnan(position):
                targets[joint] = float(position)
        shaped = self._torques.selected is ArmController.MODEL
        self._setpoints.begin(targets, 0.0 if math.isnan(duration) else duration, shaped=shaped)

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
        setpoint = self._setpoints.advance(self._measured, self._powered, dt)
        if all(self._powered):
            self._assembly.update_load(self._measured, dt)
        torques = self._torques.update(setpoint, self._measured, dt)
        for drive, reading, torque in zip(self._assembly.drives, self._readings, torques.tolist(), strict=True):
            if reading.powered:
                drive.set_torque(torque)

    def _follow_attachments(self) -> None:
        """Adopt the arm that is assembled now."""
        connected = attachments((connector.name, connector.state()) for connector in self._connectors)
        chain = find_chain(self._cell, connected, self.chain.base)
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
            self._setpoints.error = f"the motion ended early: no report of {', '.join(silent)}"
            self._setpoints.brake()
        elif returned:
            self._setpoints.come_to_rest()
        self._torques.restart(np.where(powered, self._torques.last_torques, self._measured.spring))

    def _refusal(self, positions: Sequence[float], duration: float) -> str:
        """Reason to refuse a motion; empty if it can begin."""
        names = [self.chain.joints[joint] for joint in self._index]
        if not names:
            return "motion refused: no servo module is attached to a base"
        if len(positions) != len(names):
            return f"motion refused: {len(positions)} positions for {len(names)} joints ({', '.join(names)})"
        if any(map(math.isinf, positions)):
            return "motion refused: a position is infinite"
        if math.isinf(duration) or duration < 0.0:
            return f"motion refused: a duration of {duration} s"
        if self.chain.held_by:
            return f"motion refused: the arm is also held by {', '.join(self.chain.held_by)}"
        silent = [
            name
            for name, joint, position in zip(names, self._index, positions, strict=True)
            if not (self._powered[joint] or math.isnan(position))
        ]
        return f"motion refused: no report of {', '.join(silent)}" if silent else ""
