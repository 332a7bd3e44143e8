"""The control of one joint: its setpoint within the joint's limits, and the controller that follows it."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Final, NamedTuple, TypeAlias

from jauspy.geometry.urdf import Joint
from jauspy.platform.joints import ControlMode, Gains, JointGains, Target

BRAKE_TIME: Final = 0.1
"""Seconds that a joint brakes before it holds its position; adjacent joints come to rest meanwhile."""

ROTOR_ACCELERATION: Final = 50.0
"""Acceleration of a joint that moves only its own rotor with full effort, rad/s^2 or m/s^2.

A braking gain of effort / (ROTOR_ACCELERATION * dt) stops within one step at the soonest, so it does not
oscillate.
"""

RESISTANCE_TIME: Final = 5.0
"""Seconds in which the effort fades by which a joint resists being driven back."""

_Law: TypeAlias = Callable[[float, float, float, float], float]
"""The effort of a joint by its position, velocity, the seconds until the next call, and the effort for gravity."""


class JointSetpoint(NamedTuple):
    """The setpoint of a joint at one moment."""

    mode: ControlMode
    """EFFORT, too, while a stop brakes."""
    position: float
    velocity: float
    arrived: bool
    """True at the goal of the mode POSITION."""


class JointController:
    """Computes the effort of a joint (N m or N) at each step of its control loop.

    The mode is effort, velocity or position, and changes at run time.
    """

    def __init__(self, joint: Joint, gains: JointGains, position: float) -> None:
        self._joint = joint
        self._setpoint = SetpointGenerator(joint, position)
        self._position_pid = Pid(gains.position, joint.effort)
        self._velocity_pid = Pid(gains.velocity, joint.effort)
        self._law: _Law = self._follow_position
        self._holding = True
        self._braking = 0.0
        self._integral = self._resistance = 0.0

    @property
    def mode(self) -> ControlMode:
        """The active controller."""
        return self._setpoint.mode

    @property
    def wanted_velocity(self) -> float:
        """Velocity of the setpoint, rad/s or m/s; 0 without one."""
        return self._setpoint.velocity

    @property
    def setpoint(self) -> JointSetpoint:
        """The present setpoint."""
        setpoint = self._setpoint
        mode = setpoint.mode
        moving = ControlMode.EFFORT if self._braking > 0.0 else mode
        return JointSetpoint(moving, setpoint.position, setpoint.velocity, setpoint.arrived)

    @property
    def is_braking(self) -> bool:
        """True while a stop brakes."""
        return self._braking > 0.0

    def hold_at(self, position: float, effort: float) -> None:
        """Hold a position at which the joint rests, beginning with an effort in addition to what gravity needs."""
        self._reset()
        self._position_pid.reset(effort)
        self._setpoint.hold(position)
        self._holding, self._braking, self._law = True, 0.0, self._follow_position

    def set_gains(self, gains: JointGains) -> None:
        """Set the gains; what is integrated is kept."""
        self._position_pid.gains, self._velocity_pid.gains = gains.position, gains.velocity

    def follow(self, target: Target, position: float, velocity: float, effort: float = 0.0) -> None:
        """Follow a target; a change of mode starts at the present `position` and `velocity`, without a jerk.

        It begins with `effort` in addition to what gravity needs: that of a load.
        """
        if target.compensated and not target.value:
            self.hold(position)
            return
        if target.mode is not self.mode:
            self._reset()
            self._position_pid.reset(effort)
            self._velocity_pid.reset(effort)
            self._integral = effort
            self._setpoint.start(position, velocity)
        self._setpoint.target = target
        self._holding, self._braking, self._law = False, 0.0, self._law_for(target)

    def hold(self, position: float) -> None:
        """Brake, and hold the position where the joint comes to rest. Has no effect on a joint that holds already."""
        if self._holding:
            return
        self._reset()
        self._setpoint.hold(position)
        self._holding, self._braking, self._law = True, BRAKE_TIME, self._brake

    def effort(self, position: float, velocity: float, dt: float, feed_forward: float = 0.0) -> float:
        """Return the effort for the next `dt` seconds; `feed_forward` compensates gravity."""
        return self._law(position, velocity, dt, feed_forward)

    def _law_for(self, target: Target) -> _Law:
        if target.mode is ControlMode.POSITION:
            return self._follow_position
        if target.mode is ControlMode.VELOCITY:
            return self._follow_velocity
        return self._compensated if target.compensated else self._uncompensated

    def _follow_position(self, position: float, velocity: float, dt: float, feed_forward: float) -> float:
        setpoint = self._setpoint
        setpoint.approach(dt)
        desired = setpoint.velocity
        feed_forward += self._joint.damping * desired
        return self._position_pid.update(setpoint.position - position, desired - velocity, dt, feed_forward)

    def _follow_velocity(self, position: float, velocity: float, dt: float, feed_forward: float) -> float:
        setpoint = self._setpoint
        setpoint.advance(dt)
        desired = setpoint.velocity
        feed_forward += self._joint.damping * desired
        setpoint.position = position  # the limits apply to the present position, not to the commanded one
        return self._velocity_pid.update(desired - velocity, 0.0, dt, feed_forward)

    def _compensated(self, position: float, velocity: float, dt: float, gravity: float) -> float:
        """Follow the setpoint's velocity with at most the commanded effort in its direction, in addition to gravity.

        A joint that is driven back resists, as a gear does, with more than the commanded effort.
        """
        setpoint, gains = self._setpoint, self._velocity_pid.gains
        value = setpoint.target.value
        setpoint.position = position  # the limits apply to the present position
        setpoint.advance(dt)
        sign, most = math.copysign(1.0, value), min(abs(value), self._joint.effort)
        back = max(0.0, -sign * velocity)
        fading = math.exp(-dt / RESISTANCE_TIME)
        self._resistance = min(2.0 * self._joint.effort, fading * self._resistance + gains.i * back * dt)
        ceiling = most + gains.p * back + self._resistance
        error = sign * (setpoint.velocity - velocity)
        wanted = self._joint.damping * abs(setpoint.velocity) + gains.p * error + sign * self._integral
        if wanted < ceiling or error < 0.0:
            integral = sign * self._integral + gains.i * error * dt
            self._integral = sign * min(most, max(-self._joint.effort, integral))
        return self._limited(gravity + sign * min(wanted, ceiling))

    def _uncompensated(self, position: float, velocity: float, dt: float, gravity: float) -> float:
        """The commanded effort, less of it as the joint comes near its speed limit, which falls towards its ends."""
        joint, gain, value = self._joint, self._velocity_pid.gains.p, self._setpoint.target.value
        forward = self._setpoint.fastest(joint.upper - position, dt)
        backward = self._setpoint.fastest(position - joint.lower, dt)
        if velocity > forward / 2.0:
            value = min(value, gravity + joint.damping * forward + gain * (forward - velocity))
        elif velocity < -backward / 2.0:
            value = max(value, gravity - joint.damping * backward - gain * (backward + velocity))
        return self._limited(value)

    def _brake(self, position: float, velocity: float, dt: float, feed_forward: float) -> float:
        """Return an effort against the motion, up to the limit; the position PID alone would overshoot."""
        self._braking -= dt
        if self._braking <= 0.0:
            self._law = self._follow_position
        self._setpoint.hold(position)
        return self._limited(feed_forward - self._joint.effort * velocity / (ROTOR_ACCELERATION * dt))

    def _limited(self, effort: float) -> float:
        return min(self._joint.effort, max(-self._joint.effort, effort))

    def _reset(self) -> None:
        self._position_pid.reset()
        self._velocity_pid.reset()
        self._integral = self._resistance = 0.0


class FedForwardController(JointController):
    """A controller whose feed-forward contains what the setpoint's acceleration needs in the interval that begins.

    Errors are therefore those at its beginning; `JointController` compares with the setpoint at its end. `begin` comes
    before each `effort`: the feed-forward is computed from its result.
    """

    _begun = 0.0, 0.0
    """Position and velocity of the setpoint at the beginning of the interval."""

    def begin(self, dt: float) -> tuple[float, float]:
        """Velocity of the setpoint, and its acceleration in the `dt` seconds that begin."""
        setpoint = self._setpoint
        self._begun = position, velocity = setpoint.position, setpoint.velocity
        if self._braking > 0.0:
            return 0.0, 0.0
        if setpoint.mode is ControlMode.POSITION:
            setpoint.approach(dt)
            return velocity, (setpoint.velocity - velocity) / dt
        setpoint.advance(dt)
        acceleration = (setpoint.velocity - velocity) / dt
        setpoint.start(position, velocity)  # the laws of the other modes advance it
        return velocity, acceleration

    def _follow_position(self, position: float, velocity: float, dt: float, feed_forward: float) -> float:
        begun, desired = self._begun
        feed_forward += self._joint.damping * desired
        return self._position_pid.update(begun - position, desired - velocity, dt, feed_forward)


class Pid:
    """A PID controller with outputs within -limit..limit; it does not integrate beyond the limit (anti-windup)."""

    def __init__(self, gains: Gains, limit: float) -> None:
        self.gains = gains
        self.limit = limit
        self._integral = 0.0

    def reset(self, integral: float = 0.0) -> None:
        """Set the integral part of the output, within its limit."""
        self._integral = min(self.gains.i_limit, max(-self.gains.i_limit, integral))

    def update(self, error: float, rate: float, dt: float, feed_forward: float = 0.0) -> float:
        """Return the effort for an error with the derivative `rate` (1/s), `dt` seconds after the last one."""
        gains, integral, limit = self.gains, self._integral, self.limit
        output = feed_forward + gains.p * error + gains.d * rate + integral
        in_range = -limit <= output <= limit
        if in_range or error * output < 0.0:
            integral, i_limit = integral + gains.i * error * dt, gains.i_limit
            self._integral = integral if -i_limit <= integral <= i_limit else math.copysign(i_limit, integral)
        return output if in_range else math.copysign(limit, output)


ACCELERATION_TIME: Final = 0.25
"""Seconds to full speed, unless a command sets an acceleration."""


class SetpointGenerator:
    """Position and velocity of a joint's setpoint; the speed is a trapezoid that ends at the target.

    Targets are clamped to the limits of the joint.

    In the mode EFFORT the setpoint stands still, unless gravity is compensated: then it moves at the share of the speed
    limit that the effort is of the greatest effort.
    """

    def __init__(self, joint: Joint, position: float) -> None:
        self.joint = joint
        self.hold(position)

    @property
    def target(self) -> Target:
        """The present command."""
        return self._target

    @target.setter
    def target(self, target: Target) -> None:
        joint, default = self.joint, self.joint.velocity / ACCELERATION_TIME
        self._target = target
        self.mode = target.mode
        self._goal = min(joint.upper, max(joint.lower, target.value))
        self._max_speed = min(joint.velocity, target.speed or math.inf)
        self._cruises = target.mode is ControlMode.VELOCITY or target.compensated
        wanted = target.value
        if target.mode is ControlMode.EFFORT:
            wanted *= self._max_speed / joint.effort if joint.effort else 0.0
        self._cruise_velocity = min(joint.velocity, max(-joint.velocity, wanted))
        self._acceleration = target.acceleration or default
        self._deceleration = target.deceleration or default

    @property
    def arrived(self) -> bool:
        """True when the setpoint stands at the goal of the mode POSITION."""
        return self.mode is ControlMode.POSITION and not self.velocity and self.position == self._goal

    def hold(self, position: float) -> None:
        """Stand still at a position."""
        self.start(position, 0.0)
        self.target = Target(ControlMode.POSITION, position)

    def start(self, position: float, velocity: float) -> None:
        """Set the present position and velocity."""
        self.position = position
        self.velocity = velocity

    def advance(self, dt: float) -> None:
        """Advance by `dt` seconds."""
        if self.mode is ControlMode.POSITION:
            self.approach(dt)
        elif self._cruises:
            self._cruise(dt)
        else:
            self.velocity = 0.0

    def approach(self, dt: float) -> None:
        """Advance by `dt` seconds in the mode POSITION."""
        distance = self._goal - self.position
        if not (distance or self.velocity):
            return
        change = self._deceleration * dt
        self._change_speed(math.copysign(min(self._max_speed, self._braking_speed(abs(distance), dt)), distance), dt)
        if abs(distance) <= change * dt and abs(self.velocity) <= 2.0 * change:
            self.start(self._goal, 0.0)
        else:
            self.position += self.velocity * dt

    def _cruise(self, dt: float) -> None:
        wanted = self._cruise_velocity
        room = abs((self.joint.upper if wanted > 0.0 else self.joint.lower) - self.position)
        self._change_speed(math.copysign(min(abs(wanted), self._braking_speed(room, dt)), wanted), dt)
        position = self.position + self.velocity * dt
        beyond = position > self.joint.upper if self.velocity > 0.0 else position < self.joint.lower
        if beyond and self.velocity:
            position, self.velocity = min(self.joint.upper, max(self.joint.lower, position)), 0.0
        self.position = position

    def fastest(self, room: float, dt: float) -> float:
        """The speed at which the joint may move towards an end that is `room` away."""
        return min(self._max_speed, self._braking_speed(max(0.0, room), dt))

    def _braking_speed(self, distance: float, dt: float) -> float:
        """The speed from which the setpoint stops within a distance."""
        change = self._deceleration * dt
        # steps of dt delay the ramp by half a step
        return math.sqrt(change * change / 4.0 + 2.0 * self._deceleration * distance) - change / 2.0

    def _change_speed(self, wanted: float, dt: float) -> None:
        present = self.velocity
        if wanted == present:
            return
        slower = abs(wanted) < abs(present) or wanted * present < 0.0
        limit = (self._deceleration if slower else self._acceleration) * dt
        self.velocity = present + min(limit, max(-limit, wanted - present))
