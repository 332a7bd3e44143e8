"""Sources of sound for microphones of a simulated robot: its motors and tracks, loudspeakers, tones of the world."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field

from jauspy.geometry.poses import Transform
from jauspy.geometry.urdf import JointKind, RobotDescription
from jauspy.platform.contract import Snapshot
from jauspy.platform.description import RobotModel
from jauspy.platform.sound import LoudspeakerSetup, MicrophoneSetup, ToneSetup


@dataclass(frozen=True, slots=True)
class SoundScene:
    """Sources of sound for one microphone; all that does not change while the robot runs."""

    microphone: MicrophoneSetup
    description: RobotDescription
    half_track: float = 0.0
    """Metres from the middle to each track or side of wheels; 0 for a robot that stands."""
    joints: tuple[str, ...] = ()
    """Joints with motors."""
    loudspeakers: tuple[LoudspeakerSetup, ...] = ()
    tones: tuple[ToneSetup, ...] = ()

    @classmethod
    def of(cls, model: RobotModel, microphone: MicrophoneSetup) -> SoundScene:
        """The scene of one microphone of a robot."""
        moving = {JointKind.REVOLUTE, JointKind.CONTINUOUS, JointKind.PRISMATIC}
        joints = [name for group in model.groups.values() for name in group.joints]
        return cls(
            microphone,
            model.description,
            half_track=_half_track(model),
            joints=tuple(name for name in joints if model.description.joints[name].kind in moving),
            loudspeakers=model.loudspeakers,
            tones=model.tones,
        )


def _half_track(model: RobotModel) -> float:
    if model.wheels is not None:
        return model.wheels.track / 2.0
    if model.tracks is not None:
        joints = model.description.joints
        return abs(joints[model.tracks.left[0]].origin.y - joints[model.tracks.right[0]].origin.y) / 2.0
    return 0.0


@dataclass(frozen=True, slots=True)
class MotorState:
    """A joint at one moment, in radians or metres, and N m or N."""

    position: float
    velocity: float
    effort: float


@dataclass(frozen=True, slots=True)
class MachineState:
    """The moving parts of a robot at one moment, for microphones."""

    base: Transform = field(default_factory=Transform)
    left: float = 0.0
    """Speed of the left track or wheels over the ground, m/s."""
    right: float = 0.0
    joints: Mapping[str, MotorState] = field(default_factory=dict)

    @classmethod
    def of(cls, model: RobotModel, snapshot: Snapshot) -> MachineState:
        """The state of a robot after a step."""
        pose, twist, half = snapshot.pose, snapshot.twist, _half_track(model)
        joints = {
            name: MotorState(*values)
            for group, state in snapshot.joints.items()
            if group in model.groups
            for name, *values in zip(
                model.groups[group].joints, state.positions, state.velocities, state.efforts, strict=True
            )
        }
        forward = math.copysign(math.hypot(twist.vx, twist.vy), twist.vx)
        turning = twist.wz * half
        moves = half > 0.0
        return cls(
            Transform.from_pose(pose),
            forward - turning if moves else 0.0,
            forward + turning if moves else 0.0,
            joints,
        )
