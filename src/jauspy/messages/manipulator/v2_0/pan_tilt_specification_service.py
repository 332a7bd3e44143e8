"""urn:jaus:jss:manipulator:PanTiltSpecificationService 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import ClassVar

from jauspy.messages.manipulator.v1_0 import pan_tilt_joint_position_driver as manipulator_v1_0_pan_tilt_joint_position_driver


class QueryPanTiltSpecifications(manipulator_v1_0_pan_tilt_joint_position_driver.QueryPanTiltSpecifications):
    """QueryPanTiltSpecifications (0x2620): Asks for mounting and limits of the pan-tilt unit."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:PanTiltSpecificationService"
    VERSION = "2.0"
    REPORT: ClassVar[type[ReportPanTiltSpecifications]]


class ReportPanTiltSpecifications(manipulator_v1_0_pan_tilt_joint_position_driver.ReportPanTiltSpecifications):
    """ReportPanTiltSpecifications (0x4620): Tells mounting and limits of the pan-tilt unit."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:PanTiltSpecificationService"
    VERSION = "2.0"


QueryPanTiltSpecifications.REPORT = ReportPanTiltSpecifications
