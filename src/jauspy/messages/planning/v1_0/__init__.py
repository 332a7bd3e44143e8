"""Messages of planning, v1_0; loaded on use. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jauspy.codec.registry import lazy

if TYPE_CHECKING:
    from jauspy.messages.planning.v1_0.motion_planner import (
        CancelMotion as CancelMotion, ExecuteMotion as ExecuteMotion, PlanMotion as PlanMotion,
        QueryHeldObject as QueryHeldObject, QueryMotionPlan as QueryMotionPlan,
        QueryMotionPlannerSpecification as QueryMotionPlannerSpecification,
        QueryMotionPlannerState as QueryMotionPlannerState, ReportHeldObject as ReportHeldObject,
        ReportMotionPlan as ReportMotionPlan, ReportMotionPlannerSpecification as ReportMotionPlannerSpecification,
        ReportMotionPlannerState as ReportMotionPlannerState, SetHeldObject as SetHeldObject,
    )

__all__, __getattr__, __dir__ = lazy(__name__, {
    "jauspy.messages.planning.v1_0.motion_planner": "CancelMotion ExecuteMotion PlanMotion QueryHeldObject QueryMotionPlan QueryMotionPlannerSpecification QueryMotionPlannerState ReportHeldObject ReportMotionPlan ReportMotionPlannerSpecification ReportMotionPlannerState SetHeldObject",
})
