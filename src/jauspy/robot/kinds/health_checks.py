"""The checks of a robot's health: drives, cameras, lidars, battery, computer, each for its component."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from typing import Final

from jauspy.platform.battery import Battery
from jauspy.platform.motors import Motors
from jauspy.platform.stability import StabilityMonitor
from jauspy.robot.computer import computer_state, problems
from jauspy.robot.realtime import WHOLE_ROBOT
from jauspy.services.environment_sensing import DigitalVideo, RangeSensor
from jauspy.services.iop import Code, HealthCheck, HealthEntry, HealthReporter, Severity, StabilityControl
from jauspy.services.manipulator import PrimitiveEndEffector, PrimitiveManipulator, PrimitivePanTilt
from jauspy.services.mobility import PrimitiveDriver
from jauspy.services.ugv import PowerPlantManager

from .kind import Module, ModuleBuild
from .mobility import Mobility

HOT: Final = 90.0
"""Degrees Celsius above which the windings of a drive's motor are too warm."""
MISSED_SCANS: Final = 5.0
"""Periods without a scan after which a lidar counts as silent."""
DRIVERS: Final = {
    "CM-MOB": PrimitiveDriver.urn,
    "CM-MAN": PrimitiveManipulator.urn,
    "CM-EEF": PrimitiveEndEffector.urn,
    "CM-VIS": PrimitivePanTilt.urn,
}
"""The services that tell of the drives, by the type of the module that moves them."""
_WORDS: Final = {"processor": Code.PROCESSOR, "memory": Code.RAM, "files": Code.FILESYS}


def health_checks(build: ModuleBuild) -> Sequence[HealthCheck]:
    """The checks of a reporter, which supervises the components of its node."""
    modules = [module for id, module in build.modules.items() if id.node == build.id.node]
    found: list[HealthCheck] = [partial(_check_computer, build), partial(_check_battery, build)]
    for module in modules:
        if module.kind.moved(module) is not None and module.type in DRIVERS:
            found.append(partial(_check_drives, build, module))
        if module.camera is not None:
            found.append(partial(_check_camera, build, module))
        if module.type == Mobility.type and module.part is None and build.shared.stability is not None:
            found.append(partial(_check_stability, build.shared.stability, module))
        if module.type == "CM-SEN":
            found.append(partial(_check_lidars, build, module))
    return found


def _check_drives(build: ModuleBuild, module: Module) -> Iterator[HealthEntry]:
    """Faults of the backend, joints that cannot carry their loads, and motors that are too warm or have no power."""
    where, urn = module.component, DRIVERS[module.type]
    battery = Battery.of(build.robot)
    if battery is not None and battery.cuts_motors:
        yield HealthEntry(where, urn, Severity.FAIL, Code.POWER, battery.problem)
        return
    faults = [
        why for part, why in build.shared.faults().items() if part == WHOLE_ROBOT or module.kind.uses(module, part)
    ]
    for why in faults:
        yield HealthEntry(where, urn, Severity.FAIL, Code.ACTUATOR, why)
    group = build.robot.groups.get(module.moves or "")
    loads = group.state().overloads if group is not None else {}
    for joint in loads:
        text = f"{joint} cannot carry its load: its brake holds"
        yield HealthEntry(where, urn, Severity.ERR, Code.ACTUATOR, text)
    motors = Motors.of(build.robot)
    names = {joint.name for joint in group.joints} if group is not None else _belts(build)
    hot = {
        name: reading.temperature
        for name, reading in (motors.state() if motors is not None else {}).items()
        if name in names and reading.temperature is not None and reading.temperature > HOT
    }
    for name, temperature in hot.items():
        text = f"the motor of {name} has {temperature:.0f} degrees Celsius: let it cool down"
        yield HealthEntry(where, urn, Severity.WARN, Code.ACTUATOR, text)
    if not faults and not loads and not hot:
        yield HealthEntry(where, urn, Severity.NONE, Code.NONE, "drives work")


def _belts(build: ModuleBuild) -> set[str]:
    model = build.model
    if model.tracks is not None:
        return {model.tracks.left[0], model.tracks.right[0]}
    return set() if model.wheels is None else {wheel.joint.name for wheel in model.wheels.wheels}


def _check_stability(stability: StabilityMonitor, module: Module) -> Iterator[HealthEntry]:
    """How near the robot is to tipping over."""
    warning, urn = stability.warning, StabilityControl.urn
    if warning:
        yield HealthEntry(module.component, urn, Severity.WARN, Code.NONE, warning)
    else:
        yield HealthEntry(module.component, urn, Severity.NONE, Code.NONE, "the robot stands safely")


def _check_camera(build: ModuleBuild, module: Module) -> Iterator[HealthEntry]:
    video = build.videos.get(module.camera or "")
    if video is None:
        text = f"the camera {module.camera!r} is missing"
        yield HealthEntry(module.component, DigitalVideo.urn, Severity.FAIL, Code.SENSOR, text)
    elif text := video.reduced:
        yield HealthEntry(module.component, DigitalVideo.urn, Severity.WARN, Code.PROCESSOR, text)
    else:
        text = f"the camera {module.camera!r} works"
        yield HealthEntry(module.component, DigitalVideo.urn, Severity.NONE, Code.NONE, text)


def _check_lidars(build: ModuleBuild, module: Module) -> Iterator[HealthEntry]:
    for name, lidar in build.robot.lidars.items():
        silent = lidar.scan is not None and lidar.age > MISSED_SCANS / lidar.setup.rate
        text = f"the lidar {name!r} has not scanned for {lidar.age:.0f} s" if silent else f"the lidar {name!r} works"
        severity, code = (Severity.ERR, Code.SENSOR) if silent else (Severity.NONE, Code.NONE)
        yield HealthEntry(module.component, RangeSensor.urn, severity, code, text)


def _check_battery(build: ModuleBuild) -> Iterator[HealthEntry]:
    if (battery := Battery.of(build.robot)) is None:
        return
    severity = Severity.FAIL if battery.cuts_motors else Severity.WARN if battery.is_low else Severity.NONE
    code = Code.POWER if severity else Code.NONE
    text = battery.problem or f"the battery has {100.0 * battery.state().charge:.0f} % of its charge"
    yield HealthEntry(build.id.component, PowerPlantManager.urn, severity, code, text)


def _check_computer(build: ModuleBuild) -> Iterator[HealthEntry]:
    found = problems(computer_state())
    for part, text in found.items():
        yield HealthEntry(build.id.component, HealthReporter.urn, Severity.WARN, _WORDS[part], text)
    if not found:
        yield HealthEntry(build.id.component, HealthReporter.urn, Severity.NONE, Code.NONE, "the computer works")
