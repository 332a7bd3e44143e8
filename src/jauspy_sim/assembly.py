"""Puts a robot into a world: two MJCF files become one MuJoCo model."""

from __future__ import annotations

from importlib.resources import as_file, files
from typing import Final

import mujoco

from jauspy.errors import ConfigError

TIMESTEP: Final = 0.002
"""Seconds of one physics step."""


def known(kind: str) -> list[str]:
    """Names of the shipped `robots` or `worlds`, sorted."""
    folder = files("jauspy_sim") / kind
    return sorted(entry.name.removesuffix(".xml") for entry in folder.iterdir() if entry.name.endswith(".xml"))


def prefix(robot: str) -> str:
    """What the names of a robot's parts begin with in the model, `inc1/base`, apart from the world's names."""
    return f"{robot}/"


def build(robot: str, world: str) -> mujoco.MjModel:
    """The compiled model of that robot at the origin of that world; `ConfigError` lists the names there are."""
    spec = _read("worlds", world)
    spec.attach(_read("robots", robot), prefix=prefix(robot), frame=spec.worldbody.add_frame())
    spec.option.timestep = TIMESTEP
    spec.option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    spec.option.cone = mujoco.mjtCone.mjCONE_ELLIPTIC
    spec.option.impratio = 10.0  # friction ten times stiffer than normal contact: a parked robot does not creep
    return spec.compile()


def _read(kind: str, name: str) -> mujoco.MjSpec:
    names = known(kind)
    if name not in names:
        raise ConfigError(f"the backend 'sim' has no {name!r} among its {kind}; it has: {', '.join(names)}")
    with as_file(files("jauspy_sim") / kind / f"{name}.xml") as path:
        return mujoco.MjSpec.from_file(str(path))
