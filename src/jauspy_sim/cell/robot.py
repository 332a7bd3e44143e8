"""A factory cell in MuJoCo's physics: a `Robot` whose optional parts are the modules and the equipment."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING, Final

import mujoco
import numpy as np

from jauspy.geometry.poses import Pose, Transform
from jauspy.platform.contract import OptionalPart
from jauspy.platform.description import RobotModel
from jauspy.platform.drives import FixedBase
from jauspy.platform.force_torque import SampledForceTorque
from jauspy.platform.modular import check_libraries
from jauspy.platform.modular.parts import CellSetup, PartKind
from jauspy.platform.ranging import Scanner
from jauspy_sim.assembly import STEP_TOLERANCE, TIMESTEP, redirect_warnings, view
from jauspy_sim.cell.assembly import GRIPPER, CellModel, build_cell
from jauspy_sim.cell.car import SimulatedCar
from jauspy_sim.cell.connectors import Attachments, SimulatedConnector
from jauspy_sim.cell.equipment import SimulatedConveyor, SimulatedPartSensor
from jauspy_sim.cell.faults import Faults
from jauspy_sim.cell.payload import HeldPayload
from jauspy_sim.cell.power import SimulatedPower
from jauspy_sim.cell.probe import Probe
from jauspy_sim.cell.servos import SimulatedServo, servos_of
from jauspy_sim.cell.start import disturb, put, put_fixture, put_on_each_other, scatter
from jauspy_sim.cell.truth import Truth
from jauspy_sim.cell.writes import Writes
from jauspy_sim.physics.dynamics import dynamics_of
from jauspy_sim.physics.joints import SimulatedJoints
from jauspy_sim.rendering.cameras import SimulatedCamera, SimulatedCameras
from jauspy_sim.rendering.viewer import Viewer

if TYPE_CHECKING:
    from jauspy.platform.modular.assembled_arm import AssembledArm

ARM_LIBRARIES: Final = ("pinocchio", "ruckig")

SETTLING_STEPS: Final = 500
"""Steps before time starts, in which parts slide to the lower edges of their bins and come to rest."""

SCATTERED_TIMES: Final = 4
"""How many times that long parts take that start anywhere in their bins."""

CONTROL_EVERY: Final = 2
"""Physics steps from one control of connectors and modular arm to the next."""

FAST: Final = 0.8
"""m/s of a box from which on steps are short: less than belt and arms carry boxes with, outside of a throw."""
SHORT_STEPS: Final = 8
"""Number into which a step is divided then: at 4 m/s a box moves by 1 mm in each."""

SHOW_EVERY: Final = 5
"""Physics steps from one state for the cameras to the next: 10 ms."""


class SimulatedCell:
    """A cell and its world. The same commands at the same times give the same trajectory, bit for bit."""

    def __init__(self, cell: CellModel, robot: RobotModel) -> None:
        self._cell = cell
        self._model = cell.model
        self._setup = setup = cell.setup
        self._data = data = mujoco.MjData(cell.model)
        random = np.random.default_rng(setup.seed)
        boxes = [part.name for part in setup.parts if setup.types[part.type].kind is PartKind.BOX and not part.fixed]
        self._qvel = view(data.qvel)
        self._box_dofs = tuple([int(cell.model.joint(name).dofadr[0]) for name in boxes])
        """The first of the linear degrees of freedom of each box."""
        dynamics = {
            name: dynamics_of(cell.model, data, cell.prefix, robot, group) for name, group in robot.groups.items()
        }
        self._groups = {
            name: SimulatedJoints(
                cell.model, data, cell.prefix, robot.description, group, dynamics=dynamics[name], seed=setup.seed
            )
            for name, group in robot.groups.items()
        }
        if setup.scatter:
            scatter(cell.model, data, setup, np.random.default_rng((setup.seed, len(setup.parts))))
        disturb(cell.model, data, setup, random)
        mujoco.mj_forward(cell.model, data)
        self._drive = FixedBase()
        setups = {part.name: kind for part in setup.parts if (kind := setup.types[part.type].servo) is not None}
        self._servos = servos_of(cell.model, data, setups, setup.seed)
        self._powered: tuple[SimulatedServo, ...] = ()
        self._attachments = Attachments(cell, data, random)
        self._power = SimulatedPower(setup, self._pairs, self._set_powered, self._servos, self._attachments.connectors)
        self._conveyor = SimulatedConveyor(cell.model, data, setup.conveyor) if setup.conveyor else None
        self._sensor = SimulatedPartSensor(cell.model, data, setup, setup.sensor)
        connectors = self._attachments.connectors
        self._car = SimulatedCar(cell.model, data, setup, connectors, self._servos) if setup.car else None
        for name, group in robot.groups.items():
            if (model := dynamics[name]) is not None and group.tip == setup.gripper:
                joints = self._groups[name]
                joints.held = HeldPayload(model, joints.joints, group.sensors, 1.0 / group.rate, connectors[GRIPPER])
        self._arms = self._make_arms(setup)
        self._truth = Truth(cell, data, self._servos)
        self._faults = Faults(self._attachments, self._sensor, self._servos, lambda: self.time)
        self._probes: list[Probe] = []
        self._revision = -1
        self._owed = 0.0
        self._next_show = 0
        self._viewer: Viewer | None = None
        settling = SETTLING_STEPS * (SCATTERED_TIMES if setup.scatter else 1)
        self._steps = -settling
        self._run(settling)
        self._truth.writes = Writes(cell.model, data)
        self._sensor.step(0.0)
        self._parts = tuple(self._list_parts())
        self._cameras = SimulatedCameras(cell.drawn, data, cell.prefix, robot)

    @classmethod
    def open(cls, robot: RobotModel, world: str) -> SimulatedCell:
        """Build a cell in a world, and let it settle. Raises `ConfigError` with the known worlds."""
        redirect_warnings()
        return cls(build_cell(robot, world), robot)

    @property
    def model(self) -> mujoco.MjModel:
        """MuJoCo's model."""
        return self._model

    @property
    def data(self) -> mujoco.MjData:
        """MuJoCo's state; writing to it moves the world."""
        return self._data

    @property
    def setup(self) -> CellSetup:
        """The setup of the cell."""
        return self._setup

    @property
    def truth(self) -> Truth:
        """The true state; for tests and measurements only."""
        return self._truth

    @property
    def faults(self) -> Faults:
        """Breaks parts of the cell, for trials."""
        return self._faults

    @property
    def drive(self) -> FixedBase:
        """The base, which does not move."""
        return self._drive

    @property
    def groups(self) -> Mapping[str, SimulatedJoints]:
        """The joints of the robot, by the names that its file gives them."""
        return self._groups

    @property
    def lidars(self) -> Mapping[str, Scanner]:
        """Always empty: the cell has no lidars."""
        return {}

    @property
    def force_torque(self) -> Mapping[str, SampledForceTorque]:
        """None: connectors measure what they hold."""
        return {}

    @property
    def cameras(self) -> Mapping[str, SimulatedCamera]:
        """Cameras by name."""
        return self._cameras.cameras

    @property
    def servos(self) -> Mapping[str, SimulatedServo]:
        """The servo modules, by name."""
        return self._servos

    @property
    def connectors(self) -> Mapping[str, SimulatedConnector]:
        """The vacuum connectors, by name."""
        return self._attachments.connectors

    @property
    def optional_parts(self) -> Sequence[OptionalPart]:
        """Modules, connectors and equipment."""
        return self._parts

    @property
    def time(self) -> float:
        """Seconds simulated, a whole number of steps."""
        return self._steps * TIMESTEP

    def advance(self, dt: float) -> None:
        """Simulate `dt` seconds in whole steps of `TIMESTEP`; the remainder is carried over to the next call."""
        if not 0.0 <= dt < math.inf:
            raise ValueError(f"cannot advance by {dt} s; time only goes forward")
        self._owed += dt / TIMESTEP
        steps = math.floor(self._owed + STEP_TOLERANCE)
        if steps:
            self._owed -= steps
            self._run(steps)
            if self._steps >= self._next_show:
                self._cameras.show()
                self._next_show = self._steps + SHOW_EVERY
                if self._viewer is not None:
                    self._viewer.show()

    def prepare(self, connector: str, parts: Sequence[str], errors: Mapping[str, Transform] | None = None) -> None:
        """Assemble an arm before a task starts: put parts on a connector and on each other, attached.

        `errors` are poses of parts on their connectors, by part.
        """
        put_on_each_other(self, connector, parts, errors)

    def place(self, part: str, pose: Pose) -> None:
        """Put a free part somewhere, at rest, by writing its position: for what a task does not do itself.

        A fixture may be moved, too.
        """
        if any(fixture.name == part for fixture in self._setup.fixtures):
            put_fixture(self, part, Transform.from_pose(pose))
            return
        put(self, part, Transform.from_pose(pose))
        self._attachments.wake(int(self._model.body(part).id))

    def probe(self) -> Probe:
        """A new probe, which measures each step from now on."""
        probe = Probe(self._cell, self._data, self._attachments, self._groups)
        self._probes.append(probe)
        return probe

    def view(self) -> None:
        """Open a window that shows the cell while it is advanced. Raises `ConfigError` without a display."""
        if self._viewer is None:
            self._viewer = Viewer(self._cell.drawn, self._data)

    def close(self) -> None:
        """Stop; connectors keep what they hold. May be called twice."""
        for group in self._groups.values():
            group.hold()
        for servo in self._powered:
            servo.hold()
        if self._conveyor is not None:
            self._conveyor.set_speed(0.0)
        self._cameras.close()
        if self._viewer is not None:
            self._viewer.close()
            self._viewer = None

    def _run(self, steps: int) -> None:
        model, data = self._model, self._data
        writes = self._truth.writes
        for _ in range(steps):
            if writes is not None:
                writes.check()
            self._control()
            if self._box_flies():
                self._short_steps()
            else:
                mujoco.mj_step(model, data)
                self._check_loads()
            self._steps += 1
            for watch in self._truth.watching:
                watch.step()
            for probe in self._probes:
                probe.step(self.time)
            if self._conveyor is not None:
                self._conveyor.control()
            self._power.step(self.time)
            if writes is not None:
                writes.keep()
            self._sensor.step(self.time)

    def _box_flies(self) -> bool:
        """True while a box is so fast that it would sink into what it hits within one step."""
        qvel = self._qvel
        for dof in self._box_dofs:
            x, y, z = qvel[dof], qvel[dof + 1], qvel[dof + 2]
            if x * x + y * y + z * z > FAST * FAST:
                return True
        return False

    def _short_steps(self) -> None:
        model, data = self._model, self._data
        model.opt.timestep = TIMESTEP / SHORT_STEPS
        for _ in range(SHORT_STEPS):
            mujoco.mj_step(model, data)
            self._check_loads()
        model.opt.timestep = TIMESTEP

    def _check_loads(self) -> None:
        """Break off what the step that was just made has overloaded."""
        for probe in self._probes:
            probe.measure_loads(self.time)
        self._attachments.check()

    def _control(self) -> None:
        for servo in self._powered:
            servo.sample()
        if not self._steps % CONTROL_EVERY:
            self._attachments.control(CONTROL_EVERY * TIMESTEP)
            if self._attachments.revision != self._revision:
                self._follow_attachments()
            if self._car is not None:
                self._car.control(CONTROL_EVERY * TIMESTEP)
            for arm in self._arms:
                arm.control(self.time, CONTROL_EVERY * TIMESTEP)
        for group in self._groups.values():
            if not self._steps % group.every:
                group.control()
        for servo in self._powered:
            servo.control()

    def _follow_attachments(self) -> None:
        self._revision = self._attachments.revision
        self._let_sleep()
        self._power.update()
        if self._car is not None:
            self._car.update()

    def _let_sleep(self) -> None:
        """Let parts sleep unless a connector holds them, since forces of held parts are measured."""
        model, policy = self._model, mujoco.mjtSleepPolicy
        for part in self._setup.parts:
            if not part.fixed:
                model.tree_sleep_policy[model.body_treeid[model.body(part.name).id]] = int(policy.mjSLEEP_ALLOWED)
        for connector, face in self._attachments.attached():
            for body in (connector.body, face.body):
                if (tree := model.body_treeid[body]) >= 0:
                    model.tree_sleep_policy[tree] = int(policy.mjSLEEP_NEVER)

    def _make_arms(self, setup: CellSetup) -> tuple[AssembledArm, ...]:
        """The controllers of modular arms, which need the libraries of the extra `cell`."""
        names = [name for name in (setup.arm, setup.second_arm) if name]
        if not names:
            return ()
        check_libraries(f"the modular arm {names[0]!r}", *ARM_LIBRARIES)
        from jauspy.platform.modular.assembled_arm import AssembledArm  # noqa: PLC0415 - needs these libraries

        arms: list[AssembledArm] = []

        def base_of_other(name: str) -> str:
            return next((arm.chain.base for arm in arms if arm.name != name), "")

        arms += [
            AssembledArm(
                name,
                setup,
                self._servos,
                tuple(self._attachments.connectors.values()),
                revision=lambda: self._attachments.revision,
                base_pose=lambda base: self._attachments.frame_of(self._model.body(base).id).to_pose(),
                other_base=partial(base_of_other, name),
            )
            for name in names
        ]
        return tuple(arms)

    def _pairs(self) -> Iterator[tuple[str, str]]:
        """Pairs of parts that are attached to each other; the gripper does not pass on power."""
        for connector, face in self._attachments.attached():
            if connector.part:
                yield connector.part, face.part

    def _set_powered(self, powered: Mapping[str, bool]) -> None:
        """Set the modules that have power."""
        for name, servo in self._servos.items():
            servo.set_powered(powered.get(name, False))
        self._powered = tuple(servo for servo in self._servos.values() if servo.powered)
        self._attachments.set_powered(powered)

    def _list_parts(self) -> Iterator[OptionalPart]:
        yield from self._servos.values()
        yield from self._attachments.connectors.values()
        if self._conveyor is not None:
            yield self._conveyor
        yield self._sensor
        yield self._power
        if self._car is not None:
            yield self._car
        yield from self._arms
