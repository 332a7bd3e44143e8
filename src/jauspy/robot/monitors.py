"""Monitors of each module, run ten times a second.

A fault of the backend puts the modules that it concerns in Failure, which they leave by Reset; so does a battery that
supplies no motors any more. Loads that joints cannot carry, and a battery that is low, are logged once, counted, and
shown by `jauspy up`.
"""

from __future__ import annotations

import logging
from collections.abc import Mapping
from typing import Final

from jauspy.geometry.urdf import Joint
from jauspy.logs import get_logger
from jauspy.platform.battery import Battery
from jauspy.platform.contract import PartId, RobotParts, Snapshot
from jauspy.platform.guards import Guard, GuardState
from jauspy.robot.config import ModuleConfig
from jauspy.robot.realtime import WHOLE_ROBOT, RealTime, described
from jauspy.services.core import FailureRecovery
from jauspy.services.host import Host
from jauspy.services.mobility.driver import Driver

_LOG: Final = get_logger("jauspy.robot")

MONITOR_PERIOD: Final = 0.1
"""Seconds between two checks of the backend's faults and the loads of joints."""


def faults_of(module: ModuleConfig, faults: Mapping[PartId, str]) -> dict[PartId, str]:
    """The faults that concern the module."""
    return {part: why for part, why in faults.items() if part == WHOLE_ROBOT or module.kind.uses(module, part)}


def reason(module: ModuleConfig, faults: Mapping[PartId, str]) -> str:
    """A description of the failed parts that the module uses; empty if there are none."""
    return "; ".join(f"{described(part)}: {why}" for part, why in faults_of(module, faults).items())


def supply_problem(module: ModuleConfig, robot: RobotParts) -> str:
    """Why what the module moves has no power; empty if it has, or if the module moves nothing."""
    battery = Battery.of(robot) if module.kind.moved(module) is not None else None
    return battery.problem if battery is not None and battery.cuts_motors else ""


class FaultMonitor:
    """Puts a component in Failure while `robot` reports a fault that concerns its module, or its motors have no power.

    After Reset the part is used again.
    """

    def __init__(self, host: Host, recovery: FailureRecovery, module: ModuleConfig, robot: RealTime) -> None:
        self._host = host
        self._module = module
        self._robot = robot
        self._reason = ""
        recovery.recover_by = self._recover
        self._check()
        host.repeat("faults", MONITOR_PERIOD, self._check)

    def _check(self) -> None:
        found = reason(self._module, self._robot.faults) or supply_problem(self._module, self._robot)
        if found and found != self._reason:
            remedy = "close the robot, and open it again" if self._robot.ended_early else "Reset tries again"
            _LOG.error("%s (%s) is in Failure: %s; %s", self._host.id, self._module.type, found, remedy)
        self._reason = found
        if found and "Failure" not in self._host.path and "Emergency" not in self._host.path:
            self._host.fire("Failure")

    def _recover(self) -> None:
        for part in faults_of(self._module, self._robot.faults):
            self._robot.retry(part)
        self._reason = ""


def overloads(module: ModuleConfig, joints: Mapping[str, tuple[Joint, ...]], snapshot: Snapshot) -> dict[str, str]:
    """Descriptions of loads that the module's joints cannot carry now, by the name of the joint.

    `joints`: states by group.
    """
    if module.moves is None or module.moves not in joints:
        return {}
    known = {joint.name: joint for joint in joints[module.moves]}
    found = snapshot.joints[module.moves].overloads
    return {name: overload_text(known[name], load) for name, load in found.items()}


def overload_text(joint: Joint, load: float) -> str:
    """A description of a joint's load."""
    unit = "N m" if joint.turns else "N"
    return (
        f"joint {joint.name} cannot carry its load ({load:.0f} {unit} of {joint.effort:.0f} {unit}): its brake holds; "
        "put the load down, or move the joint where the load pulls it"
    )


def tilt_problem(host: Host) -> str:
    """Why the tilt guard has stopped the robot that a component drives; empty if it has not."""
    vehicles = (service.vehicle for service in host.services if isinstance(service, Driver))
    return next((vehicle.pilot.tilt_problem for vehicle in vehicles), "")


def guard_problems(snapshot: Snapshot) -> dict[str, str]:
    """Why guards have stopped the robot, by the kind of guard; those that have not are left out."""
    states = {part.kind.label: state for part, state in snapshot.parts.items() if issubclass(part.kind, Guard)}
    return {name: state.problem for name, state in states.items() if isinstance(state, GuardState) and state.problem}


class LoadMonitor:
    """Monitors the loads of a module's joints: the start and the end of each overload is logged and counted once."""

    def __init__(self, host: Host, module: ModuleConfig, robot: RealTime) -> None:
        self._host, self._module, self._robot = host, module, robot
        self._joints = {name: group.joints for name, group in robot.groups.items()}
        self._known: set[str] = set()
        if module.moves is not None:
            self._check()
            host.repeat("loads", MONITOR_PERIOD, self._check)

    def _check(self) -> None:
        found = overloads(self._module, self._joints, self._robot.snapshot)
        for name, text in found.items():
            if name not in self._known:
                _LOG.warning("%s (%s): %s", self._host.id, self._module.type, text)
                self._host.count("overload", text)
        for name in self._known - set(found):
            _LOG.info("%s (%s): joint %s carries its load again", self._host.id, self._module.type, name)
        self._known = set(found)


class BatteryMonitor:
    """Monitors the battery of the robot: that it is low, and that it supplies no motors, is logged and counted once."""

    def __init__(self, host: Host, robot: RobotParts) -> None:
        self._host = host
        self._known = (False, False)
        if (battery := Battery.of(robot)) is not None:
            self._check(battery)
            host.repeat("battery", MONITOR_PERIOD, lambda: self._check(battery))

    def _check(self, battery: Battery) -> None:
        before, self._known = self._known, (battery.is_low, battery.cuts_motors)
        if self._known == before:
            return
        if text := battery.problem:
            _LOG.log(logging.ERROR if battery.cuts_motors else logging.WARNING, "%s", text)
            self._host.count("battery", text)
        else:
            _LOG.info("the battery is charged again")
