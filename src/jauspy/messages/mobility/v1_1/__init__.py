"""Messages of mobility, v1_1; loaded on use. Generated from schemas/; do not edit."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from jauspy.messages.mobility.v1_1.local_pose_sensor import (
        QueryLocalPose as QueryLocalPose,
        QueryLocalPoseExt as QueryLocalPoseExt,
        ReportLocalPose as ReportLocalPose,
        ReportLocalPoseExt as ReportLocalPoseExt,
        SetLocalPose as SetLocalPose,
        SetLocalPoseExt as SetLocalPoseExt,
    )
    from jauspy.messages.mobility.v1_1.primitive_driver import (
        QueryWrenchEffort as QueryWrenchEffort,
        ReportWrenchEffort as ReportWrenchEffort,
        SetWrenchEffort as SetWrenchEffort,
    )
    from jauspy.messages.mobility.v1_1.velocity_state_sensor import (
        QueryVelocityState as QueryVelocityState,
        QueryVelocityStateExt as QueryVelocityStateExt,
        ReportVelocityState as ReportVelocityState,
        ReportVelocityStateExt as ReportVelocityStateExt,
    )

_MODULES = {
    "QueryLocalPose": "jauspy.messages.mobility.v1_1.local_pose_sensor",
    "QueryLocalPoseExt": "jauspy.messages.mobility.v1_1.local_pose_sensor",
    "QueryVelocityState": "jauspy.messages.mobility.v1_1.velocity_state_sensor",
    "QueryVelocityStateExt": "jauspy.messages.mobility.v1_1.velocity_state_sensor",
    "QueryWrenchEffort": "jauspy.messages.mobility.v1_1.primitive_driver",
    "ReportLocalPose": "jauspy.messages.mobility.v1_1.local_pose_sensor",
    "ReportLocalPoseExt": "jauspy.messages.mobility.v1_1.local_pose_sensor",
    "ReportVelocityState": "jauspy.messages.mobility.v1_1.velocity_state_sensor",
    "ReportVelocityStateExt": "jauspy.messages.mobility.v1_1.velocity_state_sensor",
    "ReportWrenchEffort": "jauspy.messages.mobility.v1_1.primitive_driver",
    "SetLocalPose": "jauspy.messages.mobility.v1_1.local_pose_sensor",
    "SetLocalPoseExt": "jauspy.messages.mobility.v1_1.local_pose_sensor",
    "SetWrenchEffort": "jauspy.messages.mobility.v1_1.primitive_driver",
}

__all__ = ("QueryLocalPose", "QueryLocalPoseExt", "QueryVelocityState", "QueryVelocityStateExt", "QueryWrenchEffort", "ReportLocalPose", "ReportLocalPoseExt", "ReportVelocityState", "ReportVelocityStateExt", "ReportWrenchEffort", "SetLocalPose", "SetLocalPoseExt", "SetWrenchEffort")


def __getattr__(name: str) -> object:
    if name not in _MODULES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value: object = getattr(import_module(_MODULES[name]), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *_MODULES})
