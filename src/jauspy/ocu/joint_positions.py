"""Where the joints of a robot are, from whichever of its components reports them, as its description counts."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final, Protocol

from jauspy.errors import ConfigError
from jauspy.geometry.denavit_hartenberg import manipulator_geometry, reversed_axes
from jauspy.messages.manipulator import (
    QueryJointPositions,
    QueryManipulatorSpecifications,
    QueryPanTiltJointPositions,
    ReportJointPositions,
    ReportPanTiltJointPositions,
)
from jauspy.ocu.robot import ComponentClient, Robot
from jauspy.platform.description import GroupSetup, RobotModel

MANIPULATOR: Final = "ManipulatorJointPositionSensor"
PAN_TILT: Final = "PanTiltJointPositionSensor"
SPECIFICATION: Final = "ManipulatorSpecificationService"

_NAMES: Final = 0b10
"""Presence vector: the second field, names of joints."""


class JointReader(Protocol):
    """Asks one component."""

    @property
    def joints(self) -> tuple[str, ...]:
        """Of which joints."""
        ...

    async def read(self) -> dict[str, float]:
        """Their positions, radians or metres; `ResponseTimeout` when it does not answer."""
        ...


class ManipulatorReader:
    """Positions of a manipulator, or of a gripper, which the standard counts from axes of its own."""

    def __init__(self, component: ComponentClient, model: RobotModel, group: GroupSetup) -> None:
        self._id = component.id
        self._sensor = component.service(MANIPULATOR)
        self._geometry = manipulator_geometry(model.description.chain(group.base, group.tip))
        self.joints = group.joints

    async def read(self) -> dict[str, float]:
        """Asks the sensor; `ConfigError` when it has another number of joints."""
        report = await self._sensor.query(QueryJointPositions(), expects=ReportJointPositions)
        standard = [record.joint_position.value for record in report.joint_position_list]
        if len(standard) != len(self.joints):
            raise ConfigError(
                f"{self._id} reports {len(standard)} joints, and the description has {len(self.joints)} there: "
                f"{', '.join(self.joints)}; is it the description of this robot?"
            )
        return dict(zip(self.joints, self._geometry.to_urdf(standard), strict=True))


class PanTiltReader:
    """Angles of a pan-tilt unit, which count to the right and upwards."""

    def __init__(self, component: ComponentClient, model: RobotModel, group: GroupSetup) -> None:
        self._sensor = component.service(PAN_TILT)
        self._turned = reversed_axes(model.description.chain(group.base, group.tip))
        self.joints = group.joints

    async def read(self) -> dict[str, float]:
        """Asks the sensor."""
        report = await self._sensor.query(QueryPanTiltJointPositions(), expects=ReportPanTiltJointPositions)
        rows = zip(self.joints, (report.joint1_position, report.joint2_position), self._turned, strict=True)
        return {joint: -angle if reversed_axes else angle for joint, angle, reversed_axes in rows}


async def readers(robot: Robot, model: RobotModel, movers: Mapping[int, str]) -> list[JointReader]:
    """All that can be asked and whose joints are known: named by a specification, or else by `movers`."""
    found: list[JointReader] = []
    for info in robot.info.offering(MANIPULATOR):
        component = robot.component(info.id)
        named = await _named(component, model) if info.find(SPECIFICATION) else None
        group = named or model.groups.get(movers.get(info.id.component, ""))
        if group is not None:
            found.append(ManipulatorReader(component, model, group))
    for info in robot.info.offering(PAN_TILT):
        group = model.groups.get(movers.get(info.id.component, ""))
        if group is not None:
            found.append(PanTiltReader(robot.component(info.id), model, group))
    return found


async def _named(component: ComponentClient, model: RobotModel) -> GroupSetup | None:
    """The group of joints whose names the specification reports, when the description has it."""
    report = await component.service(SPECIFICATION).query(QueryManipulatorSpecifications(_NAMES))
    names = tuple(record.description for record in report.joint_names_list or ())
    return next((group for group in model.groups.values() if group.joints == names), None)
