"""Cameras in the simulated world: the robot's process shares its state, the camera's process renders it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Protocol

import mujoco
import numpy as np
from numpy.typing import NDArray

from jauspy.platform.camera import CameraSetup, DepthFrame, Frame
from jauspy.platform.shared_state import StateReader, StateWriter
from jauspy_sim.assembly import logger, redirect_warnings
from jauspy_sim.backend import choose_gl
from jauspy_sim.gl import GlRenderer
from jauspy_sim.rays import RayRenderer


def state_of(data: mujoco.MjData) -> bytes:
    """Positions of joints and of mocap bodies (qpos, mocap_pos, mocap_quat), as doubles."""
    return b"".join(part.tobytes() for part in (data.qpos, data.mocap_pos, data.mocap_quat))


def state_size(model: mujoco.MjModel) -> int:
    """The number of doubles in `state_of`."""
    return int(model.nq + 7 * model.nmocap)


class Renderer(Protocol):
    """Renders the image of a camera."""

    @property
    def description(self) -> str:
        """How it renders, for the log."""
        ...

    def zoom(self, fov: float) -> None:
        """Take this horizontal field of view, in radians, from the next picture on."""
        ...

    def paint(self, data: mujoco.MjData, width: int, height: int, *, thoroughly: bool = False) -> NDArray[np.uint8]:
        """A picture; shape (height, width, 3): red, green, blue. `thoroughly`: may take half a second."""
        ...

    def measure(
        self, data: mujoco.MjData, width: int, height: int, *, thoroughly: bool = False
    ) -> tuple[NDArray[np.uint8], NDArray[np.float32]]:
        """Render a picture of at most that size, and the depths of its pixels along the camera's axis: metres, or inf.

        Shapes (rows, columns, 3) and (rows, columns).
        """
        ...

    def close(self) -> None:
        """Release all resources."""
        ...


@dataclass(frozen=True, slots=True)
class SimulatedCamera:
    """A `Camera`. `model` is MuJoCo's, as bytes; `number` is the camera's in it."""

    setup: CameraSetup
    model: mujoco.MjModel
    number: int
    descriptor: int

    @property
    def descriptors(self) -> tuple[int, ...]:
        """The robot's state."""
        return (self.descriptor,)

    def open(self) -> SimulatedCameraSession:
        """Open with GL if it works, else with ray casting."""
        redirect_warnings()
        return SimulatedCameraSession(self)


class SimulatedCameraSession:
    """A `CameraSession`."""

    def __init__(self, camera: SimulatedCamera) -> None:
        self._model = camera.model
        self._data = mujoco.MjData(camera.model)
        self._state = StateReader(camera.descriptor)
        self._renderer = _renderer(camera)
        self._fov = camera.setup.fov

    @property
    def description(self) -> str:
        """The GL library, or why there is none."""
        return self._renderer.description

    @property
    def reduced(self) -> bool:
        """True with ray casting, which uses fewer rays than pixels."""
        return isinstance(self._renderer, RayRenderer)

    def look(
        self,
        width: int,
        height: int,
        *,
        thoroughly: bool = False,
        fov: float | None = None,
        distances: bool = False,
    ) -> Frame:
        """Render the world after the last step of the robot's process."""
        taken = self._update()
        self._renderer.zoom(self._fov if fov is None else fov)
        if distances:
            image, far = self._renderer.measure(self._data, width, height, thoroughly=thoroughly)
            image, far = _in_size(image, far, width, height)
            return Frame(image, taken, distances=far)
        return Frame(self._renderer.paint(self._data, width, height, thoroughly=thoroughly), taken)

    def measure(self, width: int, height: int) -> DepthFrame:
        """Render with depths; with ray casting in fewer pixels."""
        taken = self._update()
        self._renderer.zoom(self._fov)
        return DepthFrame(*self._renderer.measure(self._data, width, height), taken)

    def close(self) -> None:
        """Release GL and the shared memory."""
        self._renderer.close()
        self._state.close()

    def _update(self) -> float:
        taken, numbers = self._state.read()
        self._place(np.frombuffer(numbers))
        return taken

    def _place(self, numbers: NDArray[np.float64]) -> None:
        model, data = self._model, self._data
        joints, bodies = model.nq, model.nq + 3 * model.nmocap
        data.qpos[:] = numbers[:joints]
        data.mocap_pos[:] = numbers[joints:bodies].reshape(-1, 3)
        data.mocap_quat[:] = numbers[bodies:].reshape(-1, 4)
        mujoco.mj_kinematics(model, data)
        mujoco.mj_comPos(model, data)
        mujoco.mj_camlight(model, data)


def _in_size(
    image: NDArray[np.uint8], distances: NDArray[np.float32], width: int, height: int
) -> tuple[NDArray[np.uint8], NDArray[np.float32]]:
    """Picture and depths in that size, by repeating pixels; as they are if they have it."""
    rows, columns = distances.shape
    if (rows, columns) == (height, width):
        return image, distances
    down, across = np.arange(height) * rows // height, np.arange(width) * columns // width
    return np.ascontiguousarray(image[down][:, across]), np.ascontiguousarray(distances[down][:, across])


def _renderer(camera: SimulatedCamera) -> Renderer:
    way = choose_gl()
    if way is not None:
        try:
            return GlRenderer(camera.model, camera.number, camera.setup.fov, way)
        except Exception as error:  # noqa: BLE001 - GL has many ways to be unusable; each is said, and rays take over
            logger.warning("%s does not work here: %s", way, error)
    return RayRenderer(camera.model, camera.number, camera.setup.fov)


class SimulatedCameras:
    """The cameras of a robot with one shared memory; `prefix` is that of their names in the model."""

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
        """Write the robot's state to the shared memory."""
        if self._shared is not None:
            self._shared.write(state_of(self._data))

    def close(self) -> None:
        """Release the shared memory. May be called twice."""
        if self._shared is not None:
            self._shared.close()
            self._shared = None
