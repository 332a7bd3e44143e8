"""Sensors of force and torque: MuJoCo's own, at the joint above a link."""

from __future__ import annotations

import mujoco
import numpy as np
from numpy.typing import NDArray

from jauspy.geometry.vectors import Vector
from jauspy.platform.force_torque import ForceTorqueSetup, SampledForceTorque


def add_force_torque(spec: mujoco.MjSpec, setup: ForceTorqueSetup) -> None:
    """Put a sensor between that link and the one that carries it."""
    spec.body(setup.link).add_site(name=setup.name)
    for kind, type_ in (("force", mujoco.mjtSensor.mjSENS_FORCE), ("torque", mujoco.mjtSensor.mjSENS_TORQUE)):
        spec.add_sensor(name=f"{setup.name}_{kind}", type=type_, objtype=mujoco.mjtObj.mjOBJ_SITE, objname=setup.name)


def simulated_force_torque(data: mujoco.MjData, prefix: str, setup: ForceTorqueSetup) -> SampledForceTorque:
    """The sensor of that robot, with normally distributed errors."""
    random = np.random.default_rng(setup.seed)
    force, torque = (data.sensor(f"{prefix}{setup.name}_{kind}").data for kind in ("force", "torque"))

    def measure() -> tuple[Vector, Vector]:
        return _noisy(force, setup.force_noise, random), _noisy(torque, setup.torque_noise, random)

    return SampledForceTorque(setup, measure)


def _noisy(held: NDArray[np.float64], deviation: float, random: np.random.Generator) -> Vector:
    """MuJoCo tells what holds the link; what the link does to its carrier is the opposite."""
    x, y, z = (random.normal(0.0, deviation, 3) - held).tolist()
    return x, y, z
