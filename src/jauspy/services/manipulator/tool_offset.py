"""ManipulatorToolOffsetService: where the tool point is on the last link (AS6057)."""

from __future__ import annotations

from jauspy.messages.manipulator import ReportToolOffset, SetToolOffset
from jauspy.services.manipulator.arm import Arm
from jauspy.services.service import Service


class ToolOffset(Service, urn="urn:jaus:jss:manipulator:ManipulatorToolOffsetService"):
    """Metres in the last joint's frame; at first where the description has the tool."""

    def __init__(self, arm: Arm) -> None:
        self._arm = arm

    def set_tool_offset(self, msg: SetToolOffset) -> None:
        """Sensors and drivers of the end effector speak of this point from now on."""
        self._arm.tool = (msg.tool_point_coordinate_x, msg.tool_point_coordinate_y, msg.tool_point_coordinate_z)

    def report_tool_offset(self) -> ReportToolOffset:
        """The tool point."""
        return ReportToolOffset(*self._arm.tool)
