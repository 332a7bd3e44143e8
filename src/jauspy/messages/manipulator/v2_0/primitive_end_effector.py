"""urn:jaus:jss:manipulator:PrimitiveEndEffector 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import ClassVar

from jauspy.codec import runtime as rt
from jauspy.messages.manipulator.v1_0 import primitive_end_effector as manipulator_v1_0_primitive_end_effector


class QueryEndEffectorSpecification(manipulator_v1_0_primitive_end_effector.QueryEndEffectorSpecification):
    """QueryEndEffectorSpecification (0x2632): Asks which manipulator carries the end effector."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:PrimitiveEndEffector"
    VERSION = "2.0"
    REPORT: ClassVar[type[ReportEndEffectorSpecification]]


class QueryEndEffectorEffort(manipulator_v1_0_primitive_end_effector.QueryEndEffectorEffort):
    """QueryEndEffectorEffort (0x2633): Asks for the effort of the end effector."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:PrimitiveEndEffector"
    VERSION = "2.0"
    REPORT: ClassVar[type[ReportEndEffectorEffort]]


class SetEndEffectorEffort(manipulator_v1_0_primitive_end_effector.SetEndEffectorEffort):
    """SetEndEffectorEffort (0x0633): Sets the effort of the end effector."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:PrimitiveEndEffector"
    VERSION = "2.0"


class ReportEndEffectorSpecification(manipulator_v1_0_primitive_end_effector.ReportEndEffectorSpecification):
    """ReportEndEffectorSpecification (0x4632): Tells which manipulator carries the end effector."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:PrimitiveEndEffector"
    VERSION = "2.0"


class ReportEndEffectorEffort(manipulator_v1_0_primitive_end_effector.ReportEndEffectorEffort):
    """ReportEndEffectorEffort (0x4633): Tells the effort of the end effector."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:PrimitiveEndEffector"
    VERSION = "2.0"


QueryEndEffectorSpecification.REPORT = ReportEndEffectorSpecification
QueryEndEffectorEffort.REPORT = ReportEndEffectorEffort
