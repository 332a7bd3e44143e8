"""Messages of mobility, v1_1; loaded on use. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jauspy.codec.lazy import exports, load

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

_MODULES = exports({
    "jauspy.messages.mobility.v1_1.local_pose_sensor": "QueryLocalPose QueryLocalPoseExt ReportLocalPose ReportLocalPoseExt SetLocalPose SetLocalPoseExt",
    "jauspy.messages.mobility.v1_1.primitive_driver": "QueryWrenchEffort ReportWrenchEffort SetWrenchEffort",
    "jauspy.messages.mobility.v1_1.velocity_state_sensor": "QueryVelocityState QueryVelocityStateExt ReportVelocityState ReportVelocityStateExt",
})

__all__ = sorted(_MODULES)


def __getattr__(name: str) -> object:
    globals()[name] = value = load(name, _MODULES, __name__)
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *_MODULES})
