"""What `jauspy up` says of a robot that is up: what it is, and how to talk to it."""

from __future__ import annotations

from pathlib import Path
from typing import Final

from jauspy.cli.options import DEFAULT_ROOT
from jauspy.modules.config import MOTIONLESS, RobotConfig
from jauspy.modules.robot import RobotRunner

KINEMATIC: Final = "kinematic"
_DRIVE: Final = "jauspy send {} SetWrenchEffort propulsive_linear_effort_x=40 --control 200 --hold 2"

LONG: Final = 30
"""Seconds after which a robot whose client has died should stand still; one that may go on longer says so."""


def tell(runner: RobotRunner, where: str, root: Path) -> None:
    """What runs, and how to talk to it."""
    config = runner.config
    first = runner.components[0].id
    pairs = list(zip(runner.components, config.modules, strict=True))
    found = any(module.offers("Discovery") for module in config.modules)
    driven = [each.id for each, module in pairs if module.offers("Discovery") and module.offers("PrimitiveDriver")]
    connect = "" if root == DEFAULT_ROOT else f" --connect local:{root}"
    world = "" if config.backend == KINEMATIC else f", world {config.world}"
    lines = [
        f"{config.name} is up: subsystem {config.subsystem}, backend {config.backend}{world}",
        *(f"  {each.id}  {module.type}" for each, module in pairs),
        f"  node manager: {where}",
        *[f"see it:    jauspy ls{connect}"] * found,
        f"ask it:    jauspy query {first} QueryStatus{connect}",
        *(f"drive it:  {_DRIVE.format(id)}{connect}" for id in driven),
        *_cautions(config),
        "stop it:   Ctrl-C",
    ]
    print(*lines, sep="\n", flush=True)


def _cautions(config: RobotConfig) -> list[str]:
    """What one should know of modules that wait unusually long before they take a dead client's control back."""
    found = []
    for module in config.modules:
        timeout = module.access_control.timeout
        if module.type not in MOTIONLESS and not 0 < timeout <= LONG:
            how_long = f"{timeout} s after" if timeout else "for ever when"
            found.append(
                f"careful:   {config.id_of(module)} goes on {how_long} its client fell silent: access_control.timeout "
                f"= {timeout}"
            )
    return found
