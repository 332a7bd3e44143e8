"""Torques of the motors of a modular arm, by the control law that is selected."""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray

from jauspy.platform.modular.arm import ArmController
from jauspy.platform.modular.assembly import ArmAssembly
from jauspy.platform.modular.control_laws import ControlLaw, JointMeasurements, ModelLaw, PidLaw, smooth_step
from jauspy.platform.modular.trajectory import Setpoint

Array = NDArray[np.float64]

FADE_TIME: Final = 0.05
"""Seconds in which the torques go over from one model or controller to the next."""


class TorqueController:
    """Has the joints of an assembly follow setpoints; torques fade over whenever its law begins anew.

    Vectors are in the order of the assembly's chain.
    """

    def __init__(self, assembly: ArmAssembly) -> None:
        self.selected = ArmController.MODEL
        """The controller of the joints."""
        self.last_torques = np.zeros(len(assembly.drives))
        """Torques of the last control cycle, N m."""
        self._assembly = assembly
        self._law: ControlLaw | None = None
        self._fade = 0.0
        self._fade_from = self.last_torques

    def select(self, controller: ArmController) -> None:
        """Select the controller of the joints."""
        if controller is not self.selected:
            self.selected = controller
            self.restart(self.last_torques)

    def adopt(self, assembly: ArmAssembly, last_torques: Array) -> None:
        """Go on with another assembly, from these torques (N m) of its motors."""
        self._assembly = assembly
        self.restart(last_torques)

    def restart(self, last_torques: Array) -> None:
        """Begin the law anew, and fade over from these torques (N m)."""
        self.last_torques = last_torques
        self._law = None
        self._fade = 0.0

    def update(self, setpoint: Setpoint, measured: JointMeasurements, dt: float) -> Array:
        """Torques (N m) of the motors for the next `dt` seconds."""
        if self._law is None:
            self._law = self._make_law(dt)
            self._law.take_over(self.last_torques, setpoint, measured)
        if isinstance(self._law, ModelLaw):
            self._law.bias = self._assembly.shared_load(measured.q, dt)
        torques = self._law.torques(setpoint, measured, dt)
        if self._fade < FADE_TIME:
            if self._fade == 0.0:
                self._fade_from = self.last_torques
            self._fade += dt
            torques = self._fade_from + smooth_step(self._fade / FADE_TIME) * (torques - self._fade_from)
            limits = self._assembly.torque_limits  # a law keeps them; what it fades over from need not
            torques = np.clip(torques, -limits, limits)
        self.last_torques = torques
        return torques

    def _make_law(self, dt: float) -> ControlLaw:
        assembly = self._assembly
        if self.selected is ArmController.MODEL:
            return ModelLaw(assembly.model, assembly.servo_data, dt)
        return PidLaw(assembly.servo_data, [drive.gains()[0] for drive in assembly.drives])
