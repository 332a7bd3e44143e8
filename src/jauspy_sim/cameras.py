"""Shares the simulated robot's state with the processes of its cameras."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import mujoco

from jauspy.platform.camera import CameraSetup
from jauspy.platform.shared_state import StateWriter
from jauspy_sim.camera import SimulatedCamera, state_of, state_size


class SimulatedCameras:
    """One memory for all of them; their names in the model begin with `prefix`."""

    def __init__(self, model: mujoco.MjModel, data: mujoco.MjData, prefix: str, setups: Sequence[CameraSetup]) -> None:
        self._data = data
        self._shared = StateWriter(state_size(model)) if setups else None
        state = -1 if self._shared is None else self._shared.descriptor
        self.cameras: Mapping[str, SimulatedCamera] = {
            setup.name: SimulatedCamera(setup, model, int(model.camera(f"{prefix}{setup.name}").id), state)
            for setup in setups
        }
        self.show()

    def show(self) -> None:
        """The robot has moved."""
        if self._shared is not None:
            self._shared.write(state_of(self._data))

    def close(self) -> None:
        """Give the memory back; twice is fine."""
        if self._shared is not None:
            self._shared.close()
            self._shared = None
