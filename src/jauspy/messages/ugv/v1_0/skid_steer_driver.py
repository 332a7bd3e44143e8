"""urn:jaus:jss:ugv:SkidSteerDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:ugv:SkidSteerDriver", "1.0")


@jd.message(_SERVICE, 0x0501, command=True)
class SetSkidSteerEffort(jd.Message):
    """SetSkidSteerEffort (0x0501): Sets the efforts left and right.

    left_side_propulsive_effort: -100..100. Effort on the left, in percent of the maximum; positive drives forward
    right_side_propulsive_effort: -100..100. Effort on the right, in percent of the maximum; positive drives forward
    """
    left_side_propulsive_effort: float = jd.field("LeftSidePropulsiveEffort", jd.real("H", -100.0, 100.0))
    right_side_propulsive_effort: float = jd.field("RightSidePropulsiveEffort", jd.real("H", -100.0, 100.0))


@jd.message(_SERVICE, 0x4501)
class ReportSkidSteerEffort(jd.Message):
    """ReportSkidSteerEffort (0x4501): Tells the efforts left and right.

    left_side_propulsive_effort: -100..100. Effort on the left, in percent of the maximum; positive drives forward
    right_side_propulsive_effort: -100..100. Effort on the right, in percent of the maximum; positive drives forward
    """
    left_side_propulsive_effort: float = jd.field("LeftSidePropulsiveEffort", jd.real("H", -100.0, 100.0))
    right_side_propulsive_effort: float = jd.field("RightSidePropulsiveEffort", jd.real("H", -100.0, 100.0))


@jd.message(_SERVICE, 0x2501, query=True)
class QuerySkidSteerEffort(jd.Message):
    """QuerySkidSteerEffort (0x2501): Asks for the efforts left and right."""
    REPORT = ReportSkidSteerEffort
