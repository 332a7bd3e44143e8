"""Positions that were written into the state of a simulated cell from outside of its physics."""

from __future__ import annotations

import mujoco


class Writes:
    """Compares the positions before each physics step with those after the one before it.

    Physics move everything within a step; what differs between two steps was put in place by writing positions.
    """

    def __init__(self, model: mujoco.MjModel, data: mujoco.MjData) -> None:
        self.names: list[str] = []
        """Parts, or links of the robot, whose positions were written, in order."""
        self._model, self._qpos = model, data.qpos
        self._last = self._qpos.tobytes()

    def check(self) -> None:
        """Note what differs from the end of the last step."""
        if self._qpos.tobytes() == self._last:
            return
        before = memoryview(self._last).cast("d")
        starts = self._model.jnt_qposadr.tolist()
        for joint, (start, end) in enumerate(zip(starts, [*starts[1:], self._model.nq], strict=True)):
            if self._qpos[start:end].tolist() != before[start:end].tolist():
                name = self._model.body(self._model.jnt_bodyid[joint]).name.partition(".")[0]
                if name not in self.names:
                    self.names.append(name)

    def keep(self) -> None:
        """Keep the positions at the end of a step."""
        self._last = self._qpos.tobytes()
