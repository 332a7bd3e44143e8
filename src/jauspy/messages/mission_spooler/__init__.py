"""Messages of mission_spooler, newest versions; loaded on use. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jauspy.codec.registry import lazy

if TYPE_CHECKING:
    from jauspy.messages.mission_spooler.v1_0.mission_spooler import (
        AbortMission as AbortMission, InsertMessages as InsertMessages, InsertMissionTask as InsertMissionTask,
        PauseMission as PauseMission, QueryMissionPlan as QueryMissionPlan,
        QueryMissionStatus as QueryMissionStatus, QuerySpoolingPreferences as QuerySpoolingPreferences,
        QueryStoredMissions as QueryStoredMissions, RemoveMessages as RemoveMessages,
        RemoveMissionTask as RemoveMissionTask, ReportMissionPlan as ReportMissionPlan,
        ReportMissionStatus as ReportMissionStatus, ReportSpoolingPreferences as ReportSpoolingPreferences,
        ReportStoredMissions as ReportStoredMissions, ResumeMission as ResumeMission, RunMission as RunMission,
        SpoolMission as SpoolMission,
    )

__all__, __getattr__, __dir__ = lazy(__name__, {
    "jauspy.messages.mission_spooler.v1_0.mission_spooler": "AbortMission InsertMessages InsertMissionTask PauseMission QueryMissionPlan QueryMissionStatus QuerySpoolingPreferences QueryStoredMissions RemoveMessages RemoveMissionTask ReportMissionPlan ReportMissionStatus ReportSpoolingPreferences ReportStoredMissions ResumeMission RunMission SpoolMission",
})
