"""Cameras in the simulated world: the robot's process shares its state, the camera's process renders it.

Exposure, focus, lens and noise are applied to the rendered picture in `jauspy.video.imaging`.
"""

from __future__ import annotations

import logging
import math
import struct
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import mujoco
import numpy as np
from numpy.typing import NDArray

from jauspy.geometry.poses import Transform
from jauspy.geometry.vectors import Vector
from jauspy.platform.camera import CameraFrame, CameraSetup, DepthFrame, OutsideView, Quality, looking
from jauspy.platform.description import RobotModel
from jauspy.platform.lights import Lamp, LampSetup, TimeOfDay
from jauspy.platform.shared_state import StateReader, StateWriter
from jauspy_sim.assembly import DrawnModel, redirect_warnings
from jauspy_sim.gl_libraries import choose_gl
from jauspy_sim.models.decals import footprint
from jauspy_sim.models.track_visuals import Treads
from jauspy_sim.models.urdf import body_name
from jauspy_sim.models.whips import Whips
from jauspy_sim.physics.sensors import cast_rays
from jauspy_sim.rendering.decals import Decals
from jauspy_sim.rendering.gl import GlRenderer
from jauspy_sim.rendering.rays import RayRenderer
from jauspy_sim.rendering.renderer import Renderer
from jauspy_sim.rendering.shared_model import ModelMemory, shared_model

_LOG = logging.getLogger("jauspy_sim.mujoco")

_MUJOCO_AXES: Final = np.array([[0.0, 0.0, -1.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
"""Right, up and back of a camera, as columns, in a frame with x ahead, y left, z up."""

WALL_MARGIN: Final = 0.15
"""Metres between an outside camera and obstacles that would hide the robot."""
MIN_AWAY: Final = 0.6
"""Least distance of an outside camera from the robot, in metres."""
RETREAT: Final = 0.6
"""Time constant, in seconds, with which an outside camera moves back once nothing hides the robot any more."""

if TYPE_CHECKING:
    from jauspy_sim.rendering.lamps import Darkness
    from jauspy_sim.rendering.sun_shadow import SunShadow


def state_of(data: mujoco.MjData, lamps: Sequence[Lamp] = ()) -> bytes:
    """The state for rendering as doubles: qpos, mocap_pos, mocap_quat, userdata (travel of belts), levels of lamps."""
    levels = struct.pack(f"={len(lamps)}d", *(lamp.level for lamp in lamps))
    return b"".join(
        [data.qpos.tobytes(), data.mocap_pos.tobytes(), data.mocap_quat.tobytes(), data.userdata.tobytes(), levels]
    )


def state_size(model: mujoco.MjModel, lamps: int = 0) -> int:
    """The number of doubles in `state_of`."""
    return int(model.nq + 7 * model.nmocap + model.nuserdata + lamps)


@dataclass(frozen=True, slots=True)
class SimulatedCamera:
    """A `Camera`; `number` is its number in the model.

    GL shows `drawn`, if there is one; rays are cast at the simple shapes of the model for physics. Both are in memory
    that the processes of all cameras share (`ModelMemory`).
    """

    setup: CameraSetup
    number: int
    state: int
    """Descriptor of the robot's state."""
    physics: int
    """Descriptor of the model for physics."""
    drawing: int
    """Descriptor of the model that is drawn, which the first camera makes."""
    lamps: tuple[tuple[str, LampSetup], ...] = ()
    """Those of all robots of the world, each with the prefix of its robot's names."""
    time_of_day: TimeOfDay = TimeOfDay.DAY
    quality: Quality = Quality.LOW
    base: int = 0
    """The robot's root body, for cameras outside of it."""
    drawn: DrawnModel | None = None

    @property
    def descriptors(self) -> tuple[int, ...]:
        """The robot's state, and the models."""
        return self.state, self.physics, self.drawing

    def open(self) -> SimulatedCameraSession:
        """Open with GL if it works, else with ray casting."""
        redirect_warnings()
        return SimulatedCameraSession(self)


class SimulatedCameraSession:
    """A `CameraSession`."""

    def __init__(self, camera: SimulatedCamera) -> None:
        self._state = StateReader(camera.state)
        self._number = camera.number
        self._levels: list[float] = []
        self._renderer, self._model = _renderer(camera)
        self._data = mujoco.MjData(self._model)
        self._treads, self._whips = Treads(self._model), Whips(self._model)
        self._decals = _decals(camera, self._model) if isinstance(self._renderer, GlRenderer) else None
        self._darkness: Darkness | None = None
        if camera.time_of_day is not TimeOfDay.DAY:
            from jauspy_sim.rendering.lamps import Darkness, light_evenly  # noqa: PLC0415 - OpenCV is for the cameras' processes

            self._darkness = Darkness(self._model, camera.lamps, camera.time_of_day)
            light_evenly(self._model)
        self._base = camera.base
        self._sun: SunShadow | None = None
        self._outside = OutsideView(camera.setup.outside) if camera.setup.outside else None
        self._fov = camera.setup.fov
        self._hidden, self._looked = 0.0, 0.0
        """Metres by which the outside camera is nearer than its view wants, and when it looked last."""

    @property
    def description(self) -> str:
        """The GL library, or why there is none."""
        return self._renderer.description

    @property
    def reduced(self) -> bool:
        """True with ray casting, which uses fewer rays than pixels, and after `simplify`."""
        return not isinstance(self._renderer, GlRenderer) or self._renderer.is_simplified

    @property
    def simplifications(self) -> int:
        """The number of lower qualities of the renderer."""
        return self._renderer.simplifications

    def simplify(self, steps: int) -> None:
        """Leave out smooth edges, and then shadows; 0 renders all again."""
        self._renderer.simplify(steps)

    def release(self) -> None:
        """Leave the thread: the next one that calls has the camera."""
        self._renderer.release()

    def look(
        self,
        width: int,
        height: int,
        *,
        thoroughly: bool = False,
        fov: float | None = None,
        distances: bool = False,
    ) -> CameraFrame:
        """Render the world after the last step of the robot's process."""
        taken = self._update()
        fov = self._fov if fov is None else fov
        self._renderer.zoom(fov)
        lighting = self._lighting(thoroughly=thoroughly)
        if distances or lighting is not None:
            image, far = self._renderer.measure(self._data, width, height, thoroughly=thoroughly)
            image, far = _in_size(image, far, width, height)
            light = 1.0 if lighting is None else self._light(lighting, far, fov, coarse=not thoroughly)
            return CameraFrame(image, taken, light, far if distances else None)
        return CameraFrame(self._renderer.paint(self._data, width, height, thoroughly=thoroughly), taken)

    def measure(self, width: int, height: int) -> DepthFrame:
        """Render with depths; with ray casting in fewer pixels."""
        taken = self._update()
        self._renderer.zoom(self._fov)
        return DepthFrame(*self._renderer.measure(self._data, width, height), taken)

    def close(self) -> None:
        """Release GL and the shared memory."""
        self._renderer.close()
        self._state.close()

    def _lighting(self, *, thoroughly: bool) -> Darkness | SunShadow | None:
        """The lighting that is computed in addition to the renderer's."""
        if self._darkness is not None:
            return self._darkness
        renderer = self._renderer
        if not isinstance(renderer, GlRenderer) or not renderer.needs_shadows or not self._model.nlight:
            return None
        if thoroughly and renderer.makes_films:
            return None
        if self._sun is None:
            from jauspy_sim.rendering.sun_shadow import SunShadow  # noqa: PLC0415 - OpenCV is for the cameras' processes

            self._sun = SunShadow(self._model)
        return self._sun if self._sun.is_cast else None

    def _light(
        self, lighting: Darkness | SunShadow, distances: NDArray[np.float32], fov: float, *, coarse: bool
    ) -> NDArray[np.float32] | float:
        spread, number = math.tan(fov / 2.0), self._number
        return lighting.light(
            self._data, number, distances, spread, levels=self._levels, source=self._renderer, coarse=coarse
        )

    def _update(self) -> float:
        taken, numbers = self._state.read()
        self._place(np.frombuffer(numbers), taken)
        if self._outside is not None:
            self._look_from_outside(self._outside, taken)
        return taken

    def _look_from_outside(self, view: OutsideView, now: float) -> None:
        """Place the outside camera, nearer to the robot if something hides the robot."""
        data = self._data
        x, y, z = data.xpos[self._base].tolist()
        first, second, third = ((a, b, c) for a, b, c in data.xmat[self._base].reshape(3, 3).tolist())
        position, target = view.ends(now, Transform((first, second, third), (x, y, z)))
        if view.follows:
            position = self._unhidden(position, target, now)
        frame = looking(position, target)
        data.cam_xpos[self._number] = frame.position
        # The columns are right, up and back.
        data.cam_xmat[self._number] = (np.array(frame.rotation) @ _MUJOCO_AXES).ravel()

    def _unhidden(self, position: Vector, target: Vector, now: float) -> Vector:
        """The position, nearer to the target while something is between: immediately, and slowly back again."""
        start, way = np.array(target), np.array(position) - np.array(target)
        far = float(np.linalg.norm(way))
        free = float(cast_rays(self._model, self._data, start, way[None, :] / far)[0]) - WALL_MARGIN
        self._hidden *= math.exp(min(self._looked - now, 0.0) / RETREAT)
        self._looked = now
        self._hidden = max(self._hidden, far - free, 0.0)
        x, y, z = (start + way * (max(far - self._hidden, MIN_AWAY) / far)).tolist()
        return x, y, z

    def _place(self, numbers: NDArray[np.float64], now: float) -> None:
        model, data = self._model, self._data
        joints, bodies = model.nq, model.nq + 3 * model.nmocap
        data.qpos[:] = numbers[:joints]
        data.mocap_pos[:] = numbers[joints:bodies].reshape(-1, 3)
        belts = bodies + 4 * model.nmocap
        lamps = belts + model.nuserdata
        data.mocap_quat[:] = numbers[bodies:belts].reshape(-1, 4)
        data.userdata[:] = numbers[belts:lamps]
        self._levels = numbers[lamps:].tolist()
        mujoco.mj_kinematics(model, data)
        self._treads.place(data)
        self._whips.place(data, now)
        if self._decals is not None:
            self._decals.place(data)
        mujoco.mj_comPos(model, data)
        mujoco.mj_camlight(model, data)


def _in_size(
    image: NDArray[np.uint8], distances: NDArray[np.float32], width: int, height: int
) -> tuple[NDArray[np.uint8], NDArray[np.float32]]:
    """Picture and depths, scaled to that size by repeating pixels."""
    rows, columns = distances.shape
    if (rows, columns) == (height, width):
        return image, distances
    down, column_of = np.arange(height) * rows // height, np.arange(width) * columns // width
    return np.ascontiguousarray(image[down][:, column_of]), np.ascontiguousarray(distances[down][:, column_of])


def _renderer(camera: SimulatedCamera) -> tuple[Renderer, mujoco.MjModel]:
    """The best renderer that works on this machine, and its model."""
    way = choose_gl()
    if way is not None:
        model = _physics(camera) if camera.drawn is None else shared_model(camera.drawing, camera.drawn.build)
        try:
            return GlRenderer(model, camera.number, camera.setup.fov, way, camera.quality), model
        except Exception as error:  # noqa: BLE001 - GL has many ways to be unusable; each is said, and rays take over
            _LOG.warning("%s does not work here: %s", way, error)
    model = _physics(camera)
    return RayRenderer(model, camera.number, camera.setup.fov), model


def _decals(camera: SimulatedCamera, model: mujoco.MjModel) -> Decals | None:
    below = None if camera.drawn is None else footprint(camera.drawn.robot)
    return None if below is None else Decals(model, camera.base, below, marks=camera.setup.outside is not None)


def _physics(camera: SimulatedCamera) -> mujoco.MjModel:
    return shared_model(camera.physics, _missing)


def _missing() -> mujoco.MjModel:
    raise RuntimeError("the robot's process has not shared its model")


class SimulatedCameras:
    """The cameras of a robot with one shared memory; `prefix` is that of their names in the model.

    `others` are the lamps of other robots in the world, each with the prefix of its robot's names.
    """

    def __init__(
        self,
        model: mujoco.MjModel,
        data: mujoco.MjData,
        prefix: str,
        robot: RobotModel,
        lamps: Sequence[Lamp] = (),
        *,
        others: Sequence[tuple[str, Lamp]] = (),
        drawn: DrawnModel | None = None,
    ) -> None:
        named = [*((prefix, lamp) for lamp in lamps), *others]
        self._data, self._lamps = data, [lamp for _, lamp in named]
        self._shared = StateWriter(state_size(model, len(named))) if robot.cameras else None
        self._models = (ModelMemory(), ModelMemory()) if robot.cameras else ()
        state = -1 if self._shared is None else self._shared.descriptor
        physics, drawing = (memory.descriptor for memory in self._models) if self._models else (-1, -1)
        if self._models:
            shared_model(physics, lambda: model)
        shining = tuple((owner, lamp.setup) for owner, lamp in named)
        self.cameras: Mapping[str, SimulatedCamera] = {
            setup.name: SimulatedCamera(
                setup=setup,
                number=int(model.camera(f"{prefix}{setup.name}").id),
                state=state,
                physics=physics,
                drawing=drawing,
                lamps=shining,
                time_of_day=robot.time_of_day,
                quality=robot.quality,
                base=int(model.body(f"{prefix}{body_name(robot.description.root())}").id),
                drawn=drawn,
            )
            for setup in robot.cameras
        }
        self.show()

    def show(self) -> None:
        """Write the robot's state to the shared memory."""
        if self._shared is not None:
            self._shared.write(state_of(self._data, self._lamps))

    def close(self) -> None:
        """Release the shared memory. May be called twice."""
        if self._shared is not None:
            self._shared.close()
            self._shared = None
        for memory in self._models:
            memory.close()
