"""Servo modules in MuJoCo: motor, gear, series elasticity, controller and sensors."""

from __future__ import annotations

import math
from collections.abc import Mapping
from functools import cached_property
from typing import Final

import mujoco

from jauspy.geometry.urdf import Joint, JointKind
from jauspy.geometry.vectors import GRAVITY, Quaternion, Vector
from jauspy.platform.contract import PartId
from jauspy.platform.joint_control import JointController
from jauspy.platform.joints import ControlMode, Gains, JointGains, Target
from jauspy.platform.modular.parts import ServoData
from jauspy.platform.modular.servo import ServoModule, ServoReading, ServoState
from jauspy_sim.assembly import TIMESTEP, view
from jauspy_sim.cell.servo_sensors import Imu
from jauspy_sim.physics.encoders import Encoder, Noise

UNLIMITED: Final = 1e9
"""Radians: servo modules turn without limits."""

FULL_TORQUE_SPEED: Final = 0.8
"""Fraction of the speed without load up to which the whole torque is available; beyond, the voltage limits it."""

SUPPLY_VOLTAGE: Final = 48.0
LINE_RESISTANCE: Final = 0.08
"""Ohms of the line to a module."""
THERMAL_RESISTANCE: Final = 3.5
"""Kelvin per watt from the windings to the room."""
THERMAL_TIME: Final = 240.0
"""Seconds in which the windings take on 63 % of a change."""
ROOM_TEMPERATURE: Final = 25.0
DERATING_START, DERATING_END = 100.0, 130.0
"""Degrees Celsius between which the torque fades to nothing, to protect the windings."""

SEIZED: Final = 10.0
"""Friction of a gear that has seized, as a multiple of the largest torque."""

THERMAL_CYCLES: Final = 50
"""Control cycles from one update of the temperature to the next."""


class SimulatedServo(ServoModule):
    """One module; also the `ServoDrive` of a modular arm. Its controller acts at each physics step, at 500 Hz."""

    def __init__(self, model: mujoco.MjModel, data: mujoco.MjData, name: str, setup: ServoData, seed: int = 0) -> None:
        self.name = name
        self.setup = setup
        self._model = model
        self._qpos, self._qvel, self._qacc, self._applied = map(
            view, (data.qpos, data.qvel, data.qacc, data.qfrc_applied)
        )
        motor, spring, free = (model.joint(joint) for joint in (f"{name}.motor", f"{name}.spring", name))
        self._motor, self._spring = int(motor.qposadr[0]), int(spring.qposadr[0])
        self._motor_dof, self._spring_dof = int(motor.dofadr[0]), int(spring.dofadr[0])
        self._free, self._free_dof = int(free.qposadr[0]), int(free.dofadr[0])
        self.tree = int(model.body_treeid[model.body(name).id])
        self._loss = float(model.dof_damping[self._spring_dof].flat[0])
        noise = Noise(seed, f"{name} encoders")
        self._motor_encoder, self._output_encoder = Encoder(setup.sensors, noise), Encoder(setup.sensors, noise)
        """One on each side of the spring."""
        self._imu = Imu(setup.sensors, Noise(seed, f"{name} imu"))
        self._start_encoders()
        self._idle_energy = setup.idle_power * TIMESTEP
        self._heating = setup.resistance / setup.torque_constant**2 * TIMESTEP
        """Joules that a step heats the windings by, for each square of a newton metre."""
        self._fast = FULL_TORQUE_SPEED * setup.max_speed
        """rad/s from which on the voltage limits the torque."""
        self._joint = Joint(
            name,
            JointKind.REVOLUTE,
            name,
            name,
            lower=-UNLIMITED,
            upper=UNLIMITED,
            effort=setup.max_torque,
            velocity=setup.max_speed,
            damping=setup.damping,
        )
        self._gains = setup.position_gains, setup.velocity_gains
        self._controller = JointController(self._joint, JointGains(*self._gains), self.position)
        self._feed_forward = 0.0
        self._torque: float | None = None
        self._claimed_by = ""
        self._command = 0.0
        self._heat = 0.0
        self._temperature = ROOM_TEMPERATURE
        self._cycles = 0
        self.energy = 0.0
        """Joules that it has drawn."""
        self.supply = SUPPLY_VOLTAGE
        """Volts of what powers it."""
        self._worked_at = 0.0
        """Radians of the motor when its work was last measured."""
        self._powered = False
        self._last = ServoState()
        self._last_reading = ServoReading(powered=False, position=0.0, velocity=0.0, torque=0.0)

    @property
    def position(self) -> float:
        """Radians at the output, any number of turns, by the encoder there."""
        return self._output_encoder.position

    @property
    def velocity(self) -> float:
        """rad/s at the output, by the encoder there."""
        return self._output_encoder.rate

    @property
    def torque(self) -> float:
        """Newton metres by the deflection of the spring, positive if it accelerates the output."""
        return self.setup.stiffness * (self._motor_encoder.position - self._output_encoder.position)

    @property
    def true_position(self) -> float:
        """Radians at the output, for measurements only."""
        return self._qpos[self._motor] + self._qpos[self._spring]

    @property
    def true_velocity(self) -> float:
        """rad/s at the output, for measurements only."""
        return self._qvel[self._motor_dof] + self._qvel[self._spring_dof]

    @property
    def true_torque(self) -> float:
        """Newton metres through the spring and its damping, for measurements only."""
        return -self.setup.stiffness * self._qpos[self._spring] - self._loss * self._qvel[self._spring_dof]

    @property
    def powered(self) -> bool:
        """True while it has power."""
        return self._powered

    def seize(self) -> None:
        """Block the gear, as one does whose bearing has failed: its friction exceeds what the motor can do."""
        self._model.dof_frictionloss[self._motor_dof] = SEIZED * self.setup.max_torque

    @cached_property
    def id(self) -> PartId:
        """Kind and name."""
        return PartId(ServoModule, self.name)

    # --- ServoModule ----------------------------------------------------------------------------------------------

    def state(self) -> ServoState:
        """The measured state; without power, the last one."""
        if not self._powered:
            return self._last
        qpos, at = self._qpos, self._free
        orientation = qpos[at + 3], qpos[at + 4], qpos[at + 5], qpos[at + 6]
        qvel, qacc, dof = self._qvel, self._qacc, self._free_dof
        specific_force = qacc[dof], qacc[dof + 1], qacc[dof + 2] + GRAVITY
        current = self._current()
        self._last = ServoState(
            powered=True,
            position=self.position,
            velocity=self.velocity,
            torque=self.torque,
            current=current,
            temperature=self._temperature,
            voltage=self.supply - LINE_RESISTANCE * (self.setup.idle_power / self.supply + abs(current)),
            orientation=orientation,
            angular_velocity=self._imu.angular_velocity((qvel[dof + 3], qvel[dof + 4], qvel[dof + 5])),
            acceleration=self._imu.acceleration(_turned_back(orientation, specific_force)),
            claimed_by=self._claimed_by,
        )
        return self._last

    def command(self, target: Target, feed_forward: float = 0.0) -> None:
        """Follow a target; NaN and infinite values are ignored."""
        if not self._powered or not math.isfinite(target.value):
            return
        self._torque = None
        self._feed_forward = feed_forward if math.isfinite(feed_forward) else 0.0
        self._controller.follow(target, self.position, self.velocity)

    def hold(self) -> None:
        """Brake, and hold the position where it comes to rest."""
        self._feed_forward = 0.0
        if self._torque is not None:
            self._torque = None
            self._controller.follow(Target(ControlMode.EFFORT, 0.0), self.position, self.velocity)
        self._controller.hold(self.position)

    def set_gains(self, position: Gains, velocity: Gains) -> None:
        """Set the gains of its controllers; the present target is kept."""
        self._gains = position, velocity
        self._controller.set_gains(JointGains(position, velocity))

    def gains(self) -> tuple[Gains, Gains]:
        """The gains of its controllers: of position and of velocity."""
        return self._gains

    # --- ServoDrive -----------------------------------------------------------------------------------------------

    def read(self) -> ServoReading:
        """The measurements for a modular arm's control cycle."""
        if self._powered:
            self._last_reading = ServoReading(True, self.position, self.velocity, self.torque)
        return self._last_reading

    def set_torque(self, torque: float) -> None:
        """Apply a torque of the motor, N m, until the next command."""
        self._torque = torque if math.isfinite(torque) else 0.0

    def claim(self, arm: str) -> None:
        """Accept commands only of the modular arm of this name; empty ends the claim."""
        self._claimed_by = arm

    # --- physics --------------------------------------------------------------------------------------------------

    def set_powered(self, powered: bool) -> None:
        """Switch it on, so that it holds its position, or off, so that only friction brakes it."""
        if powered is self._powered:
            return
        if not powered:
            self._last = _without_power(self.state())
            self._last_reading = self._last_reading._replace(powered=False)
        self._powered = powered
        self._command = self._feed_forward = 0.0
        self._torque = None
        self._applied[self._motor_dof] = 0.0
        self._worked_at = self._qpos[self._motor]
        self._start_encoders()
        self._restart()

    def sample(self) -> None:
        """Read the encoders, once in each physics step."""
        qpos = self._qpos
        motor = qpos[self._motor]
        self._motor_encoder.sample(motor)
        self._output_encoder.sample(motor + qpos[self._spring])

    def control(self) -> None:
        """Set the torque of the motor for the next physics step, and account for the last one."""
        self._measure_energy()
        velocity = self._motor_encoder.rate
        if (torque := self._torque) is None:
            controller, forward = self._controller, self._feed_forward
            torque = controller.effort(self.position, velocity, TIMESTEP, forward)
            if forward and controller.mode is ControlMode.EFFORT:
                torque += forward
        self._command = torque = self._available(torque, self._qvel[self._motor_dof])
        self._applied[self._motor_dof] = torque
        self._heat += torque * torque
        self._cycles += 1
        if self._cycles == THERMAL_CYCLES:
            self._update_temperature()

    def _measure_energy(self) -> None:
        """Add what the last step took: losses of the windings, and the work of the motor, which is exact.

        What a motor that brakes gives back is not stored, and not fed to other modules.
        """
        angle, torque = self._qpos[self._motor], self._command
        electric = self._heating * torque * torque + torque * (angle - self._worked_at)
        self.energy += self._idle_energy + electric if electric > 0.0 else self._idle_energy
        self._worked_at = angle

    def _available(self, torque: float, velocity: float) -> float:
        """The torque that the motor can give at this speed and temperature."""
        limit, fast = self._joint.effort, self._fast
        if self._temperature > DERATING_START:
            limit *= max(0.0, (DERATING_END - self._temperature) / (DERATING_END - DERATING_START))
        if not -fast <= velocity <= fast and torque * velocity > 0.0:
            limit *= max(0.0, (1.0 - abs(velocity) / self.setup.max_speed) / (1.0 - FULL_TORQUE_SPEED))
        return torque if -limit <= torque <= limit else math.copysign(limit, torque)

    def _update_temperature(self) -> None:
        mean_square = self._heat / self._cycles / self.setup.torque_constant**2
        warm = ROOM_TEMPERATURE + THERMAL_RESISTANCE * self.setup.resistance * mean_square
        self._temperature += (warm - self._temperature) * self._cycles * TIMESTEP / THERMAL_TIME
        self._heat, self._cycles = 0.0, 0

    def _current(self) -> float:
        return self._command / self.setup.torque_constant

    def _start_encoders(self) -> None:
        self._motor_encoder.start(self._qpos[self._motor])
        self._output_encoder.start(self.true_position)

    def _restart(self) -> None:
        """Hold the present position."""
        self._controller = JointController(self._joint, JointGains(*self._gains), self.position)


def _without_power(state: ServoState) -> ServoState:
    return ServoState(
        powered=False,
        position=state.position,
        velocity=state.velocity,
        torque=state.torque,
        current=0.0,
        temperature=state.temperature,
        voltage=0.0,
        orientation=state.orientation,
        angular_velocity=state.angular_velocity,
        acceleration=state.acceleration,
    )


def _turned_back(rotation: Quaternion, vector: Vector) -> Vector:
    """A vector of the world in the frame of a unit quaternion."""
    w, x, y, z = rotation
    a, b, c = vector
    tx, ty, tz = 2.0 * (b * z - c * y), 2.0 * (c * x - a * z), 2.0 * (a * y - b * x)
    return a + w * tx + ty * z - tz * y, b + w * ty + tz * x - tx * z, c + w * tz + tx * y - ty * x


def servos_of(
    model: mujoco.MjModel, data: mujoco.MjData, setups: Mapping[str, ServoData], seed: int = 0
) -> dict[str, SimulatedServo]:
    """The servo modules of a cell, by name; `seed` is of their sensors' errors."""
    return {name: SimulatedServo(model, data, name, setup, seed) for name, setup in setups.items()}
