"""Loads that joints cannot carry: told once in the log, counted by the module, and shown by `jauspy up`."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from jauspy.geometry.urdf import Joint
from jauspy.logs import get_logger
from jauspy.modules.config import ModuleConfig
from jauspy.modules.realtime import RealTime
from jauspy.platform.contract import Snapshot
from jauspy.services.host import Host

_LOG: Final = get_logger("jauspy.robot")

PERIOD: Final = 0.1
"""Seconds between two looks at the loads."""


def overloads(module: ModuleConfig, joints: Mapping[str, tuple[Joint, ...]], snapshot: Snapshot) -> dict[str, str]:
    """What the joints of the module cannot carry now, in words, by the name of the joint. `joints`: by group."""
    if module.moves is None or module.moves not in joints:
        return {}
    known = {joint.name: joint for joint in joints[module.moves]}
    found = snapshot.joints[module.moves].overloads
    return {name: described(known[name], load) for name, load in found.items()}


def described(joint: Joint, load: float) -> str:
    """The load of a joint in words."""
    unit = "N m" if joint.turns else "N"
    return (
        f"joint {joint.name} cannot carry its load ({load:.0f} {unit} of {joint.effort:.0f} {unit}): its brake holds; "
        "put the load down, or move the joint where the load pulls it"
    )


class LoadMonitor:
    """Looks at the loads of a module's joints: each that is too heavy is logged and counted once, as is its end."""

    def __init__(self, host: Host, module: ModuleConfig, robot: RealTime) -> None:
        self._host, self._module, self._robot = host, module, robot
        self._joints = {name: group.joints for name, group in robot.groups.items()}
        self._known: set[str] = set()
        if module.moves is not None:
            self._check()

    def _check(self) -> None:
        self._host.set_timer("loads", self._host.now + PERIOD, self._check)
        found = overloads(self._module, self._joints, self._robot.snapshot)
        for name, text in found.items():
            if name not in self._known:
                _LOG.warning("%s (%s): %s", self._host.id, self._module.type, text)
                self._host.count("overload", text)
        for name in self._known - set(found):
            _LOG.info("%s (%s): joint %s carries its load again", self._host.id, self._module.type, name)
        self._known = set(found)
