"""Faults of a robot's backend: the modules that are concerned go to Failure, and leave it by Reset."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from jauspy.logs import get_logger
from jauspy.modules.config import ModuleConfig
from jauspy.modules.realtime import WHOLE_ROBOT, RealTime, described
from jauspy.platform.chassis import ParkingBrake
from jauspy.platform.commands import CHASSIS
from jauspy.platform.contract import PartId
from jauspy.platform.joints import JointGroup
from jauspy.platform.ranging import RangeFinder
from jauspy.services.core import FailureRecovery
from jauspy.services.host import Host

_LOG: Final = get_logger("jauspy.robot")

PERIOD: Final = 0.1
"""Seconds between two looks at the faults."""


def uses(module: ModuleConfig, part: PartId) -> bool:
    """True if commands to this part of the robot are those of the module."""
    if module.moves is not None:
        return part == PartId(JointGroup, module.moves)
    if module.type == "CM-SEN":
        return part.kind is RangeFinder
    if module.part is not None:
        return module.part in (part.name, part.kind.__name__.lower())
    return module.type == "CM-MOB" and part in (CHASSIS, PartId(ParkingBrake))


def faults_of(module: ModuleConfig, faults: Mapping[PartId, str]) -> dict[PartId, str]:
    """Those that concern the module."""
    return {each: why for each, why in faults.items() if each == WHOLE_ROBOT or uses(module, each)}


def reason(module: ModuleConfig, faults: Mapping[PartId, str]) -> str:
    """What has failed that the module uses, in words; empty if nothing has."""
    return "; ".join(f"{described(part)}: {why}" for part, why in faults_of(module, faults).items())


class FaultMonitor:
    """Puts a component in Failure while `robot` reports a fault that concerns its module. Reset uses the part again."""

    def __init__(self, host: Host, recovery: FailureRecovery, module: ModuleConfig, robot: RealTime) -> None:
        self._host = host
        self._module = module
        self._robot = robot
        self._reason = ""
        recovery.recover_by = self._recover
        self._check()

    def _check(self) -> None:
        self._host.set_timer("faults", self._host.now + PERIOD, self._check)
        found = reason(self._module, self._robot.faults)
        if found and found != self._reason:
            _LOG.error("%s (%s) is in Failure: %s; Reset tries again", self._host.id, self._module.type, found)
        self._reason = found
        if found and "Failure" not in self._host.path and "Emergency" not in self._host.path:
            self._host.fire("Failure")

    def _recover(self) -> None:
        for part in faults_of(self._module, self._robot.faults):
            self._robot.retry(part)
        self._reason = ""
