"""urn:jaus:jss:manipulator:PrimitiveEndEffector 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.manipulator.v1_0 import primitive_end_effector as manipulator_v1_0_primitive_end_effector

_SERVICE = jd.Service("urn:jaus:jss:manipulator:PrimitiveEndEffector", "2.0")

@jd.derived(_SERVICE)
class ReportEndEffectorSpecification(manipulator_v1_0_primitive_end_effector.ReportEndEffectorSpecification): ...

@jd.derived(_SERVICE)
class QueryEndEffectorSpecification(manipulator_v1_0_primitive_end_effector.QueryEndEffectorSpecification):
    REPORT = ReportEndEffectorSpecification

@jd.derived(_SERVICE)
class ReportEndEffectorEffort(manipulator_v1_0_primitive_end_effector.ReportEndEffectorEffort): ...

@jd.derived(_SERVICE)
class QueryEndEffectorEffort(manipulator_v1_0_primitive_end_effector.QueryEndEffectorEffort):
    REPORT = ReportEndEffectorEffort

@jd.derived(_SERVICE)
class SetEndEffectorEffort(manipulator_v1_0_primitive_end_effector.SetEndEffectorEffort): ...
