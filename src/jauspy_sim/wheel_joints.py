"""Joints of wheels in MuJoCo: motors with back EMF, brakes, steering, and the rollers of mecanum wheels."""

from __future__ import annotations

from typing import Final

import mujoco
import numpy as np

from jauspy.platform.wheels import Wheel, WheelKind, WheelSetup
from jauspy_sim.shapes import same_shape

STEERING_STIFFNESS: Final = 8.0
"""Torque of a steering motor per radian beside its target, as a multiple of its greatest torque."""
STEERING_DAMPING: Final = 0.6
"""Its torque per rad/s, as a multiple of its greatest torque."""
ROLLER_DAMPING: Final = 2.0
"""N s/m, of the rollers of a mecanum wheel."""


def add_wheels(spec: mujoco.MjSpec, setup: WheelSetup, timestep: float) -> None:
    """Give the joints of driven wheels the inertia, back EMF and brakes of their motors; free the rollers."""
    for wheel in setup.wheels:
        found = spec.joint(wheel.joint.name)
        found.armature = setup.inertia
        found.solref_friction = (2.0 * timestep, 1.0)
        back_emf = max(wheel.joint.damping, wheel.joint.effort / wheel.joint.velocity)
        found.damping = same_shape(found.damping, back_emf)
        if setup.kind is WheelKind.MECANUM:
            _add_rollers(spec, wheel)
    for each in setup.steering:
        motor = spec.actuator(each.joint.name)
        stiffness, damping = (factor * each.joint.effort for factor in (STEERING_STIFFNESS, STEERING_DAMPING))
        motor.gainprm[0] = stiffness
        motor.biastype = mujoco.mjtBias.mjBIAS_AFFINE
        motor.biasprm[1], motor.biasprm[2] = -stiffness, -damping
        motor.ctrlrange = (each.joint.lower, each.joint.upper)
        motor.forcelimited, motor.forcerange = True, (-each.joint.effort, each.joint.effort)


def _add_rollers(spec: mujoco.MjSpec, wheel: Wheel) -> None:
    """Let the wheel slide where its rollers roll, by a joint whose position is reset after each step.

    The joint must come before that of the axle, so that it does not turn with the wheel.
    """
    body, axle = spec.body(wheel.joint.child), spec.joint(wheel.joint.name)
    kept = {name: np.copy(getattr(axle, name)) for name in ("axis", "damping", "solref_friction")}
    armature, loss = axle.armature, axle.frictionloss
    spec.delete(axle)
    slide = body.add_joint(name=f"{wheel.joint.name}/rollers", type=mujoco.mjtJoint.mjJNT_SLIDE)
    slide.axis = (1.0, wheel.rollers, 0.0)
    slide.damping = same_shape(slide.damping, ROLLER_DAMPING)
    again = body.add_joint(name=wheel.joint.name, type=mujoco.mjtJoint.mjJNT_HINGE)
    again.axis, again.solref_friction = kept["axis"], kept["solref_friction"]
    again.damping = kept["damping"] if np.size(kept["damping"]) > 1 else float(kept["damping"])
    again.armature, again.frictionloss = armature, loss
