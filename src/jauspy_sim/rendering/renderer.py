"""Renderers of a camera's image: GL, or rays cast at simple shapes."""

from __future__ import annotations

from typing import Protocol

import mujoco
import numpy as np
from numpy.typing import NDArray


class Renderer(Protocol):
    """Renders the image of a camera."""

    @property
    def description(self) -> str:
        """The way of rendering, for the log."""
        ...

    @property
    def simplifications(self) -> int:
        """The number of lower qualities."""
        ...

    def simplify(self, steps: int) -> None:
        """Render at a quality that many steps lower; 0 ends this."""
        ...

    def release(self) -> None:
        """Leave the thread: the next one that calls has the renderer."""
        ...

    def zoom(self, fov: float) -> None:
        """Take this horizontal field of view, in radians, from the next picture on."""
        ...

    def paint(self, data: mujoco.MjData, width: int, height: int, *, thoroughly: bool = False) -> NDArray[np.uint8]:
        """Render a picture: uint8, shape (height, width, 3), RGB. With `thoroughly` it may take half a second."""
        ...

    def measure(
        self, data: mujoco.MjData, width: int, height: int, *, thoroughly: bool = False
    ) -> tuple[NDArray[np.uint8], NDArray[np.float32]]:
        """Render a picture of at most that size, and the depths of its pixels along the camera's axis: metres, or inf.

        Shapes (rows, columns, 3) and (rows, columns).
        """
        ...

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
        """Depths as seen from a lamp, along the x axis of a frame (x ahead, y left, z up), in metres.

        None if not supported.

        The picture is square, of at most `size` pixels across; `spread` is half its width at a distance of one, and in
        a `parallel` projection at any. To be called after `measure`.
        """
        ...

    def close(self) -> None:
        """Release all resources."""
        ...
