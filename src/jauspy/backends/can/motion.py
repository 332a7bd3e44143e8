"""Setpoints for drives at each SYNC: of joints by position, velocity or effort, and of tracks by velocity."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Final

from jauspy.backends.can.cia402 import Mode
from jauspy.backends.can.drive import Drive
from jauspy.geometry.urdf import Joint
from jauspy.logs import get_logger
from jauspy.platform.joint_control import JointController, SetpointGenerator
from jauspy.platform.joints import ControlMode, JointGains, Target

_LOG: Final = get_logger("jauspy.can")

TRACK_ACCELERATION: Final = 4.0
"""m/s^2, unless the drive has an `acceleration`."""


class JointMotion:
    """The setpoint of one joint. JAUS's position, velocity and effort are the three cyclic synchronous modes."""

    def __init__(self, joint: Joint, gains: JointGains, weight: Callable[[Joint], float]) -> None:
        self._joint = joint
        self._setpoint = SetpointGenerator(joint, 0.0)
        self._efforts = JointController(joint, gains, 0.0)
        """Controller as in the simulation; only for commands by effort."""
        self._weight = weight
        """The effort that the joint needs against gravity."""
        self._holding = True

    def start(self, drive: Drive) -> None:
        """Hold the present position, in Operation Enabled."""
        self._setpoint.hold(drive.position)
        self._holding = False

    def follow(self, target: Target, drive: Drive) -> None:
        """Follow a target; after a stop and in another mode it begins at the present position and velocity."""
        if target.compensated and not target.value:
            self.hold()
            return
        if drive.by_profile and target.mode is ControlMode.EFFORT and not target.compensated:
            _LOG.warning("%s has no mode for efforts: the command is not followed", drive.name)
            self.hold()
            return
        if self._holding or target.mode is not self._setpoint.target.mode:
            self._setpoint.start(drive.position, 0.0 if self._holding else drive.velocity)
        self._setpoint.target = target
        if target.mode is ControlMode.EFFORT:
            self._efforts.follow(target, drive.position, 0.0 if self._holding else drive.velocity)
        else:
            self._efforts.hold(drive.position)
        self._holding = False

    def hold(self) -> None:
        """Quick stop; the drive holds the position that it reaches."""
        self._holding = True
        self._efforts.hold(self._setpoint.position)

    def advance(self, drive: Drive, dt: float) -> tuple[Mode, float] | None:
        """Mode and value for the next `dt` seconds; None to stop."""
        if self._holding:
            return None
        setpoint = self._setpoint
        mode = setpoint.target.mode
        if not drive.ready:  # it does not move yet
            setpoint.start(drive.position, 0.0)
            if drive.by_profile:
                return Mode.PROFILE_POSITION, drive.position
            return (Mode.CYCLIC_POSITION, drive.position) if mode is ControlMode.POSITION else _still(mode)
        if drive.by_profile:
            setpoint.advance(dt)
            return Mode.PROFILE_POSITION, setpoint.position
        if mode is ControlMode.EFFORT:
            return self._by_effort(setpoint.target.value, drive, dt)
        if mode is ControlMode.VELOCITY:
            setpoint.position = drive.position  # the limits apply to the present position
            setpoint.advance(dt)
            return Mode.CYCLIC_VELOCITY, setpoint.velocity
        setpoint.advance(dt)
        return Mode.CYCLIC_POSITION, setpoint.position

    def _by_effort(self, value: float, drive: Drive, dt: float) -> tuple[Mode, float]:
        """The effort within its limits; towards an end that it could pass, a velocity that ends there."""
        joint, velocity, deceleration = self._joint, drive.velocity, drive.units.stop_deceleration
        way = math.copysign(1.0, value or velocity)
        room = way * ((joint.upper if way > 0.0 else joint.lower) - drive.position)
        if room <= 0.0 or (way * velocity > 0.0 and velocity * velocity >= 2.0 * deceleration * room):
            return Mode.CYCLIC_VELOCITY, way * math.sqrt(2.0 * deceleration * max(0.0, room))
        return Mode.CYCLIC_TORQUE, self._efforts.effort(drive.position, velocity, dt, self._weight(joint))


def _still(mode: ControlMode) -> tuple[Mode, float]:
    return (Mode.CYCLIC_VELOCITY if mode is ControlMode.VELOCITY else Mode.CYCLIC_TORQUE), 0.0


class TrackMotion:
    """The velocity of one track, which is ramped."""

    def __init__(self, acceleration: float) -> None:
        self._acceleration = acceleration
        self._wanted: float | None = 0.0
        self._velocity = 0.0

    def start(self, drive: Drive) -> None:  # noqa: ARG002 - a track may be anywhere
        """Begin at standstill."""
        self._wanted = self._velocity = 0.0

    def drive(self, velocity: float) -> None:
        """Run at a velocity, in m/s."""
        self._wanted = velocity

    def hold(self) -> None:
        """Quick stop; the drive then holds the track."""
        self._wanted = None

    def advance(self, drive: Drive, dt: float) -> tuple[Mode, float] | None:
        """Mode and value for the next `dt` seconds; None to stop."""
        if self._wanted is None:
            limit = drive.joint.velocity
            self._velocity = max(-limit, min(limit, drive.velocity))
            return None
        if drive.ready:
            change = self._acceleration * dt
            self._velocity += min(change, max(-change, self._wanted - self._velocity))
        else:
            self._velocity = 0.0
        return Mode.CYCLIC_VELOCITY, self._velocity
