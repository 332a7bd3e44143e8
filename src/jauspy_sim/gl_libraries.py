"""GL libraries with which MuJoCo draws: which are installed, and which is used."""

from __future__ import annotations

import ctypes
import os
from typing import Final

GL_LIBRARIES: Final = {
    "egl": (("libEGL.so.1",), ("libOpenGL.so.0", "libGL.so.1")),
    "osmesa": (("libOSMesa.so.8", "libOSMesa.so.6"),),
}
"""One of each of these groups is needed."""
GL_PACKAGES: Final = {"egl": "libegl1 and libopengl0", "osmesa": "libosmesa6"}
"""The packages of Debian and Ubuntu."""


def missing_gl(way: str) -> list[str]:
    """The libraries for `egl` or `osmesa` that cannot be loaded: the first name of each group."""
    return [names[0] for names in GL_LIBRARIES[way] if not any(map(_loads, names))]


def choose_gl() -> str | None:
    """`egl`, `osmesa` or None. The environment's MUJOCO_GL counts: with `disable` it is None."""
    wanted = os.environ.get("MUJOCO_GL", "").lower()
    if wanted:
        return wanted if wanted in GL_LIBRARIES else None
    return next((way for way in GL_LIBRARIES if not missing_gl(way)), None)


def _loads(library: str) -> bool:
    try:
        ctypes.CDLL(library)
    except OSError:
        return False
    return True
