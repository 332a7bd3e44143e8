"""urn:jaus:jss:manipulator:PrimitiveEndEffector 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:manipulator:PrimitiveEndEffector", "1.0")


@jd.message(_SERVICE, 0x4632)
class ReportEndEffectorSpecification(jd.Message):
    """ReportEndEffectorSpecification (0x4632): Tells which manipulator carries the end effector.

    parent_id: Component of the manipulator that carries the end effector
    """
    parent_id: int = jd.field("ParentId", jd.Number("I"))


@jd.message(_SERVICE, 0x2632, query=True)
class QueryEndEffectorSpecification(jd.Message):
    """QueryEndEffectorSpecification (0x2632): Asks which manipulator carries the end effector."""
    REPORT = ReportEndEffectorSpecification


@jd.message(_SERVICE, 0x4633)
class ReportEndEffectorEffort(jd.Message):
    """ReportEndEffectorEffort (0x4633): Tells the effort of the end effector.

    end_effector_effort: -100..100. Effort, in percent of the maximum
    """
    end_effector_effort: float = jd.field("EndEffectorEffort", jd.real("H", -100.0, 100.0))


@jd.message(_SERVICE, 0x2633, query=True)
class QueryEndEffectorEffort(jd.Message):
    """QueryEndEffectorEffort (0x2633): Asks for the effort of the end effector."""
    REPORT = ReportEndEffectorEffort


@jd.message(_SERVICE, 0x0633, command=True)
class SetEndEffectorEffort(jd.Message):
    """SetEndEffectorEffort (0x0633): Sets the effort of the end effector.

    end_effector_effort: -100..100. Effort, in percent of the maximum
    """
    end_effector_effort: float = jd.field("EndEffectorEffort", jd.real("H", -100.0, 100.0))
