"""Messages of description, newest versions; loaded on use. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jauspy.codec.registry import lazy

if TYPE_CHECKING:
    from jauspy.messages.description.v1_0.joint_description import (
        QueryBlockedJoints as QueryBlockedJoints, QueryJointDescription as QueryJointDescription,
        ReportBlockedJoints as ReportBlockedJoints, ReportJointDescription as ReportJointDescription,
    )
    from jauspy.messages.description.v1_0.motion_guards import (
        QueryMotionGuards as QueryMotionGuards, ReportMotionGuards as ReportMotionGuards,
    )

__all__, __getattr__, __dir__ = lazy(__name__, {
    "jauspy.messages.description.v1_0.joint_description": "QueryBlockedJoints QueryJointDescription ReportBlockedJoints ReportJointDescription",
    "jauspy.messages.description.v1_0.motion_guards": "QueryMotionGuards ReportMotionGuards",
})
