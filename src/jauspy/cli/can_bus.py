"""The option `--bus` of several verbs: the CAN bus of a robot."""

from __future__ import annotations

from jauspy.errors import ConfigError
from jauspy.modules.config import RobotConfig


def on_bus(config: RobotConfig, bus: str | None) -> RobotConfig:
    """The robot with its drives on this bus; that of its file if None. Raises `ConfigError` if it has no drives."""
    if bus is None:
        return config
    if config.can is None:
        raise ConfigError(f"--bus: {config.name} has no table [can] in its file, and so no drives (docs/hardware.md)")
    return config.model_copy(update={"can": config.can.model_copy(update={"bus": bus})})
