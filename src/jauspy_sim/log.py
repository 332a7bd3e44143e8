"""MuJoCo's warnings as log records; by itself MuJoCo writes MUJOCO_LOG.TXT into the working directory."""

from __future__ import annotations

import logging

import mujoco

logger = logging.getLogger("jauspy_sim.mujoco")


def redirect() -> None:
    """Send the warnings of this process to the logger `jauspy_sim.mujoco`."""
    mujoco.set_mju_user_warning(_warn)


def _warn(text: str) -> None:
    logger.warning("%s", text)
