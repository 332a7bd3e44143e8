"""Several robots of one program in one world: what `--also` says of each, and the backends that open them together."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Final

from jauspy import backends
from jauspy.backends.shared_world import SharedWorld
from jauspy.errors import ConfigError
from jauspy.geometry.poses import Pose
from jauspy.platform.backend import Backend, PlacedRobot
from jauspy.platform.chassis import measure
from jauspy.robot import robot_files
from jauspy.robot.config import RobotConfig
from jauspy.robot.robot_files import robot_model

SPACING: Final = 1.5
"""Metres between a robot and the one before it, if no place is given."""
FARTHEST: Final = 1e5
"""Metres from the origin of the world within which a robot may start."""


@dataclass(frozen=True, slots=True)
class FurtherRobot:
    """A robot beside the first one, and where it starts: behind the one before it, if no place is given."""

    config: RobotConfig
    start: Pose | None = None


def further_robots(first: RobotConfig, texts: Sequence[str]) -> tuple[FurtherRobot, ...]:
    """The robots that `--also` names: `ROBOT[:SUBSYSTEM][@X,Y[,DEGREES]]`, as in `inc1:102@-3,0`.

    Without a number a robot gets the first one that is free above that of its file. Raises `ConfigError`.
    """
    taken = {first.subsystem}
    found = []
    for number, text in enumerate(texts, 1):
        name, at, place = text.partition("@")
        name, colon, subsystem = name.rpartition(":") if ":" in name else (name, "", "")
        if not name:
            raise ConfigError(f"--also {text}: names no robot; write it as in inc1:102 or inc1:102@-3,0")
        config = robot_files.load(name)
        wanted = _subsystem(text, subsystem) if colon else _free(config.subsystem, taken)
        if wanted in taken:
            raise ConfigError(f"--also {text}: subsystem {wanted} is that of another robot; give it its own number")
        taken.add(wanted)
        found.append(FurtherRobot(_as_another(config, wanted, number), _place(text, place) if at else None))
    return tuple(found)


def _subsystem(text: str, digits: str) -> int:
    if not (digits.isascii() and digits.isdigit() and 1 <= int(digits) <= 65534):
        raise ConfigError(f"--also {text}: {digits!r} is no subsystem; numbers are 1..65534")
    return int(digits)


def _free(first: int, taken: set[int]) -> int:
    return next(number for number in range(first, first + len(taken) + 1) if number not in taken)


def _place(text: str, place: str) -> Pose:
    try:
        numbers = [float(part) for part in place.split(",")]
    except ValueError:
        numbers = []
    if not 2 <= len(numbers) <= 3 or not all(math.isfinite(number) for number in numbers):
        raise ConfigError(f"--also {text}: {place!r} is no place; write X,Y in metres, or X,Y,DEGREES, as in @-3,0,90")
    x, y, *heading = numbers
    if max(abs(x), abs(y)) > FARTHEST:
        raise ConfigError(f"--also {text}: a robot starts within {FARTHEST:g} m of the origin of the world")
    return Pose(x=x, y=y, yaw=math.radians(heading[0]) if heading else 0.0)


def _as_another(config: RobotConfig, subsystem: int, number: int) -> RobotConfig:
    """The robot with this number; its sensors have errors of their own, and so has its audit log a file of its own."""
    log = None if config.audit_log is None else Path(config.audit_log)
    return with_other_errors(config, number).model_copy(
        update={
            "subsystem": subsystem,
            "audit_log": log and str(log.with_name(f"{log.stem}-{subsystem}{log.suffix}")),
        }
    )


def with_other_errors(config: RobotConfig, number: int) -> RobotConfig:
    """The robot, whose sensors have other errors for each number."""
    return config.model_copy(
        update={
            "localization": replace(config.localization, seed=config.localization.seed + number),
            "lidars": tuple(replace(lidar, seed=lidar.seed + number) for lidar in config.lidars),
            "force_torque": tuple(replace(sensor, seed=sensor.seed + number) for sensor in config.force_torque),
        }
    )


def shared_backends(first: RobotConfig, others: Sequence[FurtherRobot], backend: str | None) -> tuple[Backend, ...]:
    """The backends of the robots, the first one included, in one world: that of the first one's file, or `backend`."""
    configs = [first, *(other.config for other in others)]
    models = [robot_model(config) for config in configs]
    starts = [Pose()]
    for number, other in enumerate(others, 1):
        ahead, own = measure(models[number - 1]), measure(models[number])
        starts.append(other.start or _behind(starts[-1], SPACING - ahead.low[0] + own.high[0]))
    placed = [PlacedRobot(model, start) for model, start in zip(models, starts, strict=True)]
    return SharedWorld(backends.find(backend or first.backend), placed).backends


def _behind(ahead: Pose, distance: float) -> Pose:
    return Pose(x=ahead.x - distance * math.cos(ahead.yaw), y=ahead.y - distance * math.sin(ahead.yaw), yaw=ahead.yaw)
