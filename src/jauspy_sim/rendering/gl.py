"""Renders camera pictures off screen with GL, by MuJoCo's renderer.

MuJoCo's renderer sends all shapes to GL. Without a GPU, triangles outside of a picture take as long as those inside, so
`Culling` hides shapes that a camera, a lamp or the sun cannot see. The meshes of inc1 have 76,000
triangles, of which its own cameras see a part.
"""

from __future__ import annotations

import math
import threading
from importlib import import_module
from typing import Final

import mujoco
import numpy as np
from numpy.typing import NDArray

from jauspy.platform.camera import Quality
from jauspy_sim.models.decals import decals_of
from jauspy_sim.rendering.rays import MAX_DISTANCE

Vectors = NDArray[np.float64]

HIDDEN: Final = 5
"""A group of shapes that is not drawn."""
SMALLEST: Final = 0.012
"""Metres: the radius below which a shape casts no shadow that shows."""
FLAT: Final = 0.03
"""Metres: a fixed shape of at most this height, at most `LOW` above the ground, counts as ground."""
LOW: Final = 0.15

MIN_DISTANCE: Final = 0.02
"""Near plane in metres: the gripper is close to the arm's camera."""

LAMP_PLANES: Final = (0.04, 60.0)
"""Near and far plane of the view from a lamp, in metres."""

QUALITIES: Final = {Quality.LOW: (0, 1), Quality.MEDIUM: (0, 1), Quality.HIGH: (4, 2048)}
"""Samples for each pixel, and pixels across the picture that the sun sees, for MuJoCo's own shadows."""

_QUALITIES_DOWN: Final = (Quality.HIGH, Quality.MEDIUM, Quality.LOW)

SHADOW_RADIUS: Final = 4.0
"""Metres around a point before the camera in which things cast shadows, except in films."""
SHADOW_AHEAD: Final = 2.2
"""Metres from the camera to that point."""

FILM_SAMPLES: Final = "film_samples"
"""Name of a number in a world: samples per pixel of thorough pictures, which also have shadows."""

MAX_GEOMS: Final = 10_000
"""Maximal number of shapes in a picture."""


class Culling:
    """Visibility of a model's shapes, by their bounding spheres."""

    def __init__(self, model: mujoco.MjModel) -> None:
        self._model = model
        self._groups = model.geom_group.copy()
        self._middles = model.geom_aabb[:, :3].copy()
        self._radii = np.linalg.norm(model.geom_aabb[:, 3:], axis=1)
        is_plane = model.geom_type == mujoco.mjtGeom.mjGEOM_PLANE
        self._radii[is_plane] = math.inf
        alpha = model.geom_rgba[:, 3].copy()
        has_material = model.geom_matid >= 0
        if has_material.any():
            alpha[has_material] = np.minimum(alpha, model.mat_rgba[model.geom_matid, 3])[has_material]
        self._decals = decals_of(model)
        self._casts = (alpha >= 1.0) & (self._radii > SMALLEST) & ~_grounds(model)

    def hide_unseen(
        self,
        data: mujoco.MjData,
        position: Vectors,
        rotation: Vectors,
        half: tuple[float, float],
        *,
        parallel: bool = False,
    ) -> None:
        """Hide shapes that are outside of a picture; `show_all` shows them again.

        `rotation` has the columns ahead, left, up; `half` are half of the picture's width and height at a distance of
        one, or in a `parallel` projection anywhere.
        """
        turned = (data.geom_xmat.reshape(-1, 3, 3) @ self._middles[:, :, None])[:, :, 0]
        away = (data.geom_xpos + turned - position) @ rotation
        ahead, sides = away[:, 0], np.abs(away[:, 1:])
        radii = self._radii
        if parallel:
            seen = (sides <= np.array(half) + radii[:, None]).all(axis=1)
        else:
            width = np.array(half)
            slant = np.hypot(1.0, width)
            seen = (sides <= width * ahead[:, None] + slant * radii[:, None]).all(axis=1)
        self._model.geom_group[:] = np.where(seen & (ahead > -radii), self._groups, HIDDEN)

    def hide_shadowless(self) -> None:
        """Hide also shapes that cast no shadow."""
        self._model.geom_group[~self._casts] = HIDDEN

    def hide_decals(self) -> None:
        """Hide the shapes on the ground that are below the light of MuJoCo's own shadows.

        It adds the light of the sun in a second pass, which reaches only what is nearest: not the ground below them.
        """
        self._model.geom_group[self._decals] = HIDDEN

    def show_all(self) -> None:
        """Show all shapes again."""
        self._model.geom_group[:] = self._groups


class GlRenderer:
    """A `Renderer`. Worlds may ask for thorough pictures at a quality of their own.

    The constructor raises one of several exceptions when GL does not work.
    """

    def __init__(
        self, model: mujoco.MjModel, camera: int, fov: float, gl_backend: str, quality: Quality = Quality.LOW
    ) -> None:
        self._backend, self._quality, self._best = gl_backend, quality, quality
        self._model = model
        self._spread = math.tan(fov / 2.0)
        self._view = mujoco.MjvCamera()
        self._view.type, self._view.fixedcamid = mujoco.mjtCamera.mjCAMERA_FIXED, camera
        self._options = mujoco.MjvOption()
        self._scene = mujoco.MjvScene(model, maxgeom=MAX_GEOMS)
        self._lit = mujoco.MjvScene(model, maxgeom=MAX_GEOMS)
        self._culling = Culling(model)
        self._lit.flags[:] = 0
        self._lit.flags[mujoco.mjtRndFlag.mjRND_CULL_FACE] = 1
        self._lit.flags[mujoco.mjtRndFlag.mjRND_SEGMENT] = 1  # without light and textures, which take time
        self._suns = np.flatnonzero(model.light_type == mujoco.mjtLightType.mjLIGHT_DIRECTIONAL)
        self._film_shadows = int(model.vis.quality.shadowsize), float(model.vis.map.shadowclip)
        self._rect = mujoco.MjrRect(0, 0, 0, 0)
        model.vis.map.znear = MIN_DISTANCE / model.stat.extent
        self._gl = import_module(f"mujoco.{gl_backend}").GLContext(64, 64)
        self._gl.make_current()
        self._thread: int | None = threading.get_ident()
        """The thread in which the context is the current one."""
        self._samples = _film_samples(model)
        self._context = self._make_context(*QUALITIES[quality])
        self._other: mujoco.MjrContext | None = None
        self._thorough = False
        self._saw_sky = True
        """True if the last picture with depths showed sky; drawing the sky takes a seventh of the time."""
        self._cast_shadows(quality is Quality.HIGH)

    @property
    def description(self) -> str:
        """The GL library, and the quality if it was lowered."""
        how = "without shadows" if self._quality is Quality.LOW else "with coarser shadows and without smooth edges"
        lowered = f", {how}: better pictures take too long here" if self.is_simplified else ""
        return f"renders with {self._backend.upper()}{lowered}"

    @property
    def needs_shadows(self) -> bool:
        """True if `SunShadow` is to add the shadows: MuJoCo's own are better, and take much longer."""
        return self._quality is Quality.MEDIUM

    @property
    def makes_films(self) -> bool:
        """True if the world has a quality of its own for thorough pictures."""
        return self._samples > 0

    @property
    def is_simplified(self) -> bool:
        """True while `simplify` has lowered the quality."""
        return self._quality is not self._best

    @property
    def simplifications(self) -> int:
        """The number of lower qualities."""
        return _QUALITIES_DOWN.index(Quality.LOW) - _QUALITIES_DOWN.index(self._best)

    def simplify(self, steps: int) -> None:
        """Render at a quality that many steps lower; 0 ends this."""
        quality = _QUALITIES_DOWN[_QUALITIES_DOWN.index(self._best) + min(steps, self.simplifications)]
        if quality is self._quality:
            return
        self._take_thread()
        self._be_thorough(thoroughly=False)
        self._quality = quality
        self._context.free()
        self._context = self._make_context(*QUALITIES[quality])
        self._rect = mujoco.MjrRect(0, 0, 0, 0)
        self._cast_shadows(quality is Quality.HIGH)

    def release(self) -> None:
        """Leave the thread; a context is current in one thread at a time, and stays so when the thread ends."""
        if self._thread == threading.get_ident():
            _release(self._backend)
            self._thread = None

    def zoom(self, fov: float) -> None:
        """Take this horizontal field of view, in radians."""
        self._spread = math.tan(fov / 2.0)

    def paint(
        self,
        data: mujoco.MjData,
        width: int,
        height: int,
        *,
        thoroughly: bool = False,
    ) -> NDArray[np.uint8]:
        """Render a picture of that size."""
        self._take_thread()
        self._be_thorough(thoroughly and self._samples > 0)
        self._render(data, width, height)
        image = np.empty((height, width, 3), np.uint8)
        mujoco.mjr_readPixels(image, None, self._rect, self._context)
        return np.ascontiguousarray(image[::-1])  # GL's first row is the lowest

    def measure(
        self, data: mujoco.MjData, width: int, height: int, *, thoroughly: bool = False
    ) -> tuple[NDArray[np.uint8], NDArray[np.float32]]:
        """Render a picture, and the depths of its pixels along the camera's axis, in metres."""
        self._take_thread()
        self._be_thorough(thoroughly and self._samples > 0)
        self._scene.flags[mujoco.mjtRndFlag.mjRND_SKYBOX] = int(self._saw_sky)
        self._render(data, width, height)
        image, depth = np.empty((height, width, 3), np.uint8), np.empty((height, width), np.float32)
        mujoco.mjr_readPixels(image, depth, self._rect, self._context)
        # The sky box has a depth, too, but counts as no surface.
        near, far = (self._model.stat.extent * plane for plane in (self._model.vis.map.znear, self._model.vis.map.zfar))
        distances = np.multiply(depth[::-1], np.float32(far - near))  # 1 at the near plane, 0 at the far one
        distances += np.float32(near)
        np.divide(np.float32(near * far), distances, out=distances)
        is_sky = distances >= MAX_DISTANCE
        distances[is_sky] = math.inf
        missed, self._saw_sky = not self._saw_sky, bool(is_sky.any())
        if missed and self._saw_sky:
            return self.measure(data, width, height, thoroughly=thoroughly)
        self._scene.flags[mujoco.mjtRndFlag.mjRND_SKYBOX] = 1
        return np.ascontiguousarray(image[::-1]), distances

    def depths_from(
        self,
        data: mujoco.MjData,
        position: NDArray[np.float64],
        rotation: NDArray[np.float64],
        spread: float,
        size: int,
        *,
        parallel: bool = False,
    ) -> NDArray[np.float32] | None:
        """Same as `Renderer.depths_from`, for shapes that cast shadows."""
        self._take_thread()
        size = min(size, self._rect.width, self._rect.height)
        near, far = LAMP_PLANES
        self._culling.hide_unseen(data, position, rotation, (spread, spread), parallel=parallel)
        self._culling.hide_shadowless()
        self._update(data, self._lit)
        for camera in self._lit.camera:
            camera.pos, camera.forward, camera.up = position, rotation[:, 0], rotation[:, 2]
            half = spread if parallel else near * spread
            camera.orthographic = int(parallel)
            camera.frustum_center, camera.frustum_width = 0.0, half
            camera.frustum_bottom, camera.frustum_top = -half, half
            camera.frustum_near, camera.frustum_far = near, far
        square, depth = mujoco.MjrRect(0, 0, size, size), np.empty((size, size), np.float32)
        mujoco.mjr_render(square, self._lit, self._context)
        mujoco.mjr_readPixels(None, depth, square, self._context)
        upright = depth[::-1]
        if parallel:
            straight: NDArray[np.float32] = np.float32(far) - upright * np.float32(far - near)
            return straight
        along: NDArray[np.float32] = np.float32(near * far) / (upright * np.float32(far - near) + np.float32(near))
        return along

    def close(self) -> None:
        """Release the GL context. May be called twice."""
        self._take_thread()
        self._context.free()
        if self._other is not None:
            self._other.free()
        self._gl.free()

    def _take_thread(self) -> None:
        if self._thread != threading.get_ident():
            self._gl.make_current()
            self._thread = threading.get_ident()

    def _render(self, data: mujoco.MjData, width: int, height: int) -> None:
        if not self._thorough:
            self._aim_suns(data)
        if (width, height) != (self._rect.width, self._rect.height):
            self._resize(width, height)
        half = self._spread, self._spread * height / width
        self._model.cam_fovy[self._view.fixedcamid] = math.degrees(2.0 * math.atan(half[1]))
        if self._scene.flags[mujoco.mjtRndFlag.mjRND_SHADOW]:  # what is not seen may cast a shadow
            self._culling.hide_decals()
        else:
            right, up, back = data.cam_xmat[self._view.fixedcamid].reshape(3, 3).T
            axes = np.stack([-back, -right, up], axis=1)
            self._culling.hide_unseen(data, data.cam_xpos[self._view.fixedcamid], axes, half)
        self._update(data, self._scene)
        mujoco.mjr_render(self._rect, self._scene, self._context)

    def _update(self, data: mujoco.MjData, scene: mujoco.MjvScene) -> None:
        """Fill a scene with the shapes that are not hidden, then show all again."""
        every = mujoco.mjtCatBit.mjCAT_ALL.value
        mujoco.mjv_updateScene(self._model, data, self._options, None, self._view, every, scene)
        self._culling.show_all()

    def _aim_suns(self, data: mujoco.MjData) -> None:
        """Centre the shadow maps of directional lights, of `SHADOW_RADIUS`, in front of the camera.

        Otherwise shadows of the whole world would share the pixels, and be coarse.
        """
        axes = data.cam_xmat[self._view.fixedcamid].reshape(3, 3)
        centre = data.cam_xpos[self._view.fixedcamid] - SHADOW_AHEAD * axes[:, 2]
        for sun in self._suns:
            data.light_xpos[sun] = centre - 2.0 * SHADOW_RADIUS * data.light_xdir[sun]

    def _be_thorough(self, thoroughly: bool) -> None:
        """Change to the quality of films, or back; the context for it is made when it is needed first."""
        if thoroughly is self._thorough:
            return
        other = self._other or self._make_context(self._samples if self._samples > 1 else 0, *self._film_shadows)
        self._context, self._other, self._thorough = other, self._context, thoroughly
        self._cast_shadows(thoroughly or self._quality is Quality.HIGH)
        self._rect = mujoco.MjrRect(0, 0, 0, 0)

    def _cast_shadows(self, wanted: bool) -> None:
        self._scene.flags[mujoco.mjtRndFlag.mjRND_SHADOW] = int(wanted)
        # a thing that reflects has everything drawn once more
        self._scene.flags[mujoco.mjtRndFlag.mjRND_REFLECTION] = int(wanted)

    def _make_context(self, samples: int, shadows: int, clip: float | None = None) -> mujoco.MjrContext:
        self._model.vis.quality.offsamples = samples
        self._model.vis.quality.shadowsize = shadows
        self._model.vis.map.shadowclip = SHADOW_RADIUS / self._model.stat.extent if clip is None else clip
        context = mujoco.MjrContext(self._model, mujoco.mjtFontScale.mjFONTSCALE_100.value)
        context.readDepthMap = mujoco.mjtDepthMap.mjDEPTH_ZEROFAR
        return context

    def _resize(self, width: int, height: int) -> None:
        mujoco.mjr_resizeOffscreen(width, height, self._context)
        mujoco.mjr_setBuffer(mujoco.mjtFramebuffer.mjFB_OFFSCREEN.value, self._context)
        self._rect = mujoco.MjrRect(0, 0, width, height)


def _release(gl_backend: str) -> None:
    """Have this thread no GL context."""
    if gl_backend == "egl":
        egl = import_module("mujoco.egl")
        no = egl.EGL.EGL_NO_SURFACE
        egl.EGL.eglMakeCurrent(egl.EGL_DISPLAY, no, no, egl.EGL.EGL_NO_CONTEXT)
    else:
        import_module("OpenGL.osmesa").OSMesaMakeCurrent(None, None, import_module("OpenGL.GL").GL_FLOAT, 0, 0)


def _film_samples(model: mujoco.MjModel) -> int:
    number = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_NUMERIC, FILM_SAMPLES)
    return int(model.numeric_data[model.numeric_adr[number]]) if number >= 0 else 0


def _grounds(model: mujoco.MjModel) -> NDArray[np.bool_]:
    """The shapes with nothing below them, so that their shadow falls on nothing."""
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    down = data.geom_xmat.reshape(-1, 3, 3)[:, 2]
    half = (np.abs(down) * model.geom_aabb[:, 3:]).sum(axis=1)
    top = data.geom_xpos[:, 2] + (down * model.geom_aabb[:, :3]).sum(axis=1) + half
    rests = model.body_weldid[model.geom_bodyid] == 0
    is_plane = model.geom_type == mujoco.mjtGeom.mjGEOM_PLANE
    return np.asarray(is_plane | (rests & (2.0 * half <= FLAT) & (top <= LOW)))
