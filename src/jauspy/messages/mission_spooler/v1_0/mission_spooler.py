"""urn:jaus:jss:missionSpooler:MissionSpooler 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd
from jauspy.messages import registry as _registry
from jauspy.messages.core.v1_0 import types as core_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:missionSpooler:MissionSpooler", "1.0")


@jd.message(_SERVICE, 0x0E00, command=True)
class SpoolMission(jd.Message):
    """SpoolMission (0x0E00): Stores a mission.

    mission_info: Which mission is meant
    mission_plan: 0..65535 items. The tasks of the mission
    """
    SourceID = core_v1_0_types.SourceID
    DestinationID = core_v1_0_types.DestinationID

    @jd.record()
    class MissionInfo(jd.Struct):
        """Which mission is meant.

        mission_id: Number of the mission
        source_id: Who stored the mission
        """
        mission_id: int = jd.field("MissionID", jd.Number("H"))
        source_id: core_v1_0_types.SourceID = jd.field("SourceID", lambda: core_v1_0_types.SourceID.layout())

    @jd.record()
    class TaskInfo(jd.Struct):
        """task_id: Number of the task in its mission"""
        task_id: int = jd.field("TaskID", jd.Number("H"))

    class Blocking(IntEnum):
        NON_BLOCKING = 0
        BLOCKING = 1

    @jd.record()
    class MessageData(jd.Struct):
        """One message and its receiver.

        uid: Number of the message in its task
        destination_id: Who receives the message
        jaus_message: JAUS Message. The message, with its message id
        blocking: Blocking or 2..255. Whether the message must be completed before the next one is sent
        """
        uid: int = jd.field("UID", jd.Number("H"))
        destination_id: core_v1_0_types.DestinationID = jd.field("DestinationID", lambda: core_v1_0_types.DestinationID.layout())
        jaus_message: jd.Message | bytes = jd.field("JausMessage", jd.Blob(jd.Count("I", 0, 4294967295), _registry))
        blocking: SpoolMission.Blocking | int = jd.field("Blocking", lambda: jd.Number("B", jd.Values(SpoolMission.Blocking, ((2, 255),))))

    @jd.record()
    class TaskData(jd.Struct):
        """jaus_messages: 0..65535 items. The messages of the task, in order"""
        task_info: SpoolMission.TaskInfo = jd.field("TaskInfo", lambda: SpoolMission.TaskInfo.layout())
        jaus_messages: list[SpoolMission.MessageData] = jd.field("JAUSMessages", lambda: jd.Repeat(jd.Count("H", 0, 65535), SpoolMission.MessageData.layout()))

    @jd.record()
    class SubTaskIndex(jd.Struct):
        """child_task_index: Place of the subtask in the list of tasks"""
        child_task_index: int = jd.field("ChildTaskIndex", jd.Number("H"))

    @jd.record()
    class Task(jd.Struct):
        """sub_tasks: 0..65535 items. The subtasks"""
        task_data: SpoolMission.TaskData = jd.field("TaskData", lambda: SpoolMission.TaskData.layout())
        sub_tasks: list[SpoolMission.SubTaskIndex] = jd.field("SubTasks", lambda: jd.Repeat(jd.Count("H", 0, 65535), SpoolMission.SubTaskIndex.layout()))

    mission_info: SpoolMission.MissionInfo = jd.field("MissionInfo", lambda: SpoolMission.MissionInfo.layout())
    mission_plan: list[SpoolMission.Task] = jd.field("MissionPlan", lambda: jd.Repeat(jd.Count("H", 0, 65535), SpoolMission.Task.layout()))


@jd.message(_SERVICE, 0x0E01, presence="B", command=True)
class RunMission(jd.Message):
    """RunMission (0x0E01): Starts a mission, a task or a message.

    mission_id: optional. Number of the mission
    task_id: optional. Number of the task in its mission
    message_uid: optional. Number of the message in its task
    """
    mission_id: int | None = jd.field("MissionID", jd.Number("H"), default=None)
    task_id: int | None = jd.field("TaskID", jd.Number("H"), default=None)
    message_uid: int | None = jd.field("MessageUID", jd.Number("H"), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x0E02, command=True)
class AbortMission(jd.Message):
    """AbortMission (0x0E02): Ends a mission and removes it.

    mission_id: Number of the mission
    """
    mission_id: int = jd.field("MissionID", jd.Number("H"))


@jd.message(_SERVICE, 0x0E03, presence="B", command=True)
class PauseMission(jd.Message):
    """PauseMission (0x0E03): Halts a mission.

    mission_id: optional. Number of the mission
    task_id: optional. Number of the task in its mission
    """
    mission_id: int | None = jd.field("MissionID", jd.Number("H"), default=None)
    task_id: int | None = jd.field("TaskID", jd.Number("H"), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x0E04, command=True)
class ResumeMission(jd.Message):
    """ResumeMission (0x0E04): Continues a mission that was halted.

    mission_id: Number of the mission
    """
    mission_id: int = jd.field("MissionID", jd.Number("H"))


@jd.message(_SERVICE, 0x0E05, command=True)
class RemoveMessages(jd.Message):
    """RemoveMessages (0x0E05): Removes messages from a task.

    mission_info: Which mission is meant
    message_list: 0..65535 items. The messages to remove
    """

    @jd.record()
    class MissionInfo(jd.Struct):
        """Which mission is meant.

        mission_id: Number of the mission
        task_id: Number of the task in its mission
        """
        mission_id: int = jd.field("MissionID", jd.Number("H"))
        task_id: int = jd.field("TaskID", jd.Number("H"))

    @jd.record()
    class MessageInfo(jd.Struct):
        """uid: Number of the message in its task"""
        uid: int = jd.field("UID", jd.Number("H"))

    mission_info: RemoveMessages.MissionInfo = jd.field("MissionInfo", lambda: RemoveMessages.MissionInfo.layout())
    message_list: list[RemoveMessages.MessageInfo] = jd.field("MessageList", lambda: jd.Repeat(jd.Count("H", 0, 65535), RemoveMessages.MessageInfo.layout()))


@jd.message(_SERVICE, 0x0E06, command=True)
class InsertMessages(jd.Message):
    """InsertMessages (0x0E06): Inserts messages into a task.

    insert_message_list: 0..65535 items. The messages to insert
    """
    DestinationID = core_v1_0_types.DestinationID

    class InsertLocation(IntEnum):
        BEFORE = 0
        AFTER = 1

    @jd.record()
    class MissionAndTaskInfo(jd.Struct):
        """mission_id: Number of the mission
        task_id: Number of the task in its mission
        uid: Number of the message in its task
        insert_location: InsertLocation or 2..255. Whether to insert before or after the named one
        """
        mission_id: int = jd.field("MissionID", jd.Number("H"))
        task_id: int = jd.field("TaskID", jd.Number("H"))
        uid: int = jd.field("UID", jd.Number("H"))
        insert_location: InsertMessages.InsertLocation | int = jd.field("InsertLocation", lambda: jd.Number("B", jd.Values(InsertMessages.InsertLocation, ((2, 255),))))

    class Blocking(IntEnum):
        NON_BLOCKING = 0
        BLOCKING = 1

    @jd.record()
    class InsertMessageInfo(jd.Struct):
        """uid: Number of the message in its task
        destination_id: Who receives the message
        jaus_message: JAUS Message. The message, with its message id
        blocking: Blocking or 2..255. Whether the message must be completed before the next one is sent
        """
        uid: int = jd.field("UID", jd.Number("H"))
        destination_id: core_v1_0_types.DestinationID = jd.field("DestinationID", lambda: core_v1_0_types.DestinationID.layout())
        jaus_message: jd.Message | bytes = jd.field("JausMessage", jd.Blob(jd.Count("I", 0, 4294967295), _registry))
        blocking: InsertMessages.Blocking | int = jd.field("Blocking", lambda: jd.Number("B", jd.Values(InsertMessages.Blocking, ((2, 255),))))

    mission_and_task_info: InsertMessages.MissionAndTaskInfo = jd.field("MissionAndTaskInfo", lambda: InsertMessages.MissionAndTaskInfo.layout())
    insert_message_list: list[InsertMessages.InsertMessageInfo] = jd.field("InsertMessageList", lambda: jd.Repeat(jd.Count("H", 0, 65535), InsertMessages.InsertMessageInfo.layout()))


@jd.message(_SERVICE, 0x0E07, command=True)
class RemoveMissionTask(jd.Message):
    """RemoveMissionTask (0x0E07): Removes tasks from a mission.

    remove_task_list: 0..65535 items. The tasks to remove
    """

    @jd.record()
    class MissionAndTaskInfo(jd.Struct):
        """mission_id: Number of the mission
        task_id: Number of the task in its mission
        """
        mission_id: int = jd.field("MissionID", jd.Number("H"))
        task_id: int = jd.field("TaskID", jd.Number("H"))

    @jd.record()
    class RemoveTaskInfo(jd.Struct):
        """task_id: Number of the task in its mission"""
        task_id: int = jd.field("TaskID", jd.Number("H"))

    mission_and_task_info: RemoveMissionTask.MissionAndTaskInfo = jd.field("MissionAndTaskInfo", lambda: RemoveMissionTask.MissionAndTaskInfo.layout())
    remove_task_list: list[RemoveMissionTask.RemoveTaskInfo] = jd.field("RemoveTaskList", lambda: jd.Repeat(jd.Count("H", 0, 65535), RemoveMissionTask.RemoveTaskInfo.layout()))


@jd.message(_SERVICE, 0x0E08, command=True)
class InsertMissionTask(jd.Message):
    """InsertMissionTask (0x0E08): Inserts a task into a mission."""
    DestinationID = core_v1_0_types.DestinationID

    class InsertLocation(IntEnum):
        BEFORE = 0
        AFTER = 1

    @jd.record()
    class MissionAndTaskInfo(jd.Struct):
        """mission_id: Number of the mission
        task_id: Number of the task in its mission
        insert_location: InsertLocation or 2..255. Whether to insert before or after the named one
        new_parent_task_id: Task that the new one becomes part of
        """
        mission_id: int = jd.field("MissionID", jd.Number("H"))
        task_id: int = jd.field("TaskID", jd.Number("H"))
        insert_location: InsertMissionTask.InsertLocation | int = jd.field("InsertLocation", lambda: jd.Number("B", jd.Values(InsertMissionTask.InsertLocation, ((2, 255),))))
        new_parent_task_id: int = jd.field("NewParentTaskID", jd.Number("H"))

    @jd.record()
    class TaskInfo(jd.Struct):
        """task_id: Number of the task in its mission"""
        task_id: int = jd.field("TaskID", jd.Number("H"))

    class Blocking(IntEnum):
        NON_BLOCKING = 0
        BLOCKING = 1

    @jd.record()
    class MessageData(jd.Struct):
        """One message and its receiver.

        uid: Number of the message in its task
        destination_id: Who receives the message
        jaus_message: JAUS Message. The message, with its message id
        blocking: Blocking or 2..255. Whether the message must be completed before the next one is sent
        """
        uid: int = jd.field("UID", jd.Number("H"))
        destination_id: core_v1_0_types.DestinationID = jd.field("DestinationID", lambda: core_v1_0_types.DestinationID.layout())
        jaus_message: jd.Message | bytes = jd.field("JausMessage", jd.Blob(jd.Count("I", 0, 4294967295), _registry))
        blocking: InsertMissionTask.Blocking | int = jd.field("Blocking", lambda: jd.Number("B", jd.Values(InsertMissionTask.Blocking, ((2, 255),))))

    @jd.record()
    class TaskData(jd.Struct):
        """task_messages: 0..65535 items. The messages of the task, in order"""
        task_info: InsertMissionTask.TaskInfo = jd.field("TaskInfo", lambda: InsertMissionTask.TaskInfo.layout())
        task_messages: list[InsertMissionTask.MessageData] = jd.field("TaskMessages", lambda: jd.Repeat(jd.Count("H", 0, 65535), InsertMissionTask.MessageData.layout()))

    @jd.record()
    class SubTaskIndex(jd.Struct):
        """child_task_index: Place of the subtask in the list of tasks"""
        child_task_index: int = jd.field("ChildTaskIndex", jd.Number("H"))

    @jd.record()
    class Task(jd.Struct):
        """sub_tasks: 0..65535 items. The subtasks"""
        task_data: InsertMissionTask.TaskData = jd.field("TaskData", lambda: InsertMissionTask.TaskData.layout())
        sub_tasks: list[InsertMissionTask.SubTaskIndex] = jd.field("SubTasks", lambda: jd.Repeat(jd.Count("H", 0, 65535), InsertMissionTask.SubTaskIndex.layout()))

    mission_and_task_info: InsertMissionTask.MissionAndTaskInfo = jd.field("MissionAndTaskInfo", lambda: InsertMissionTask.MissionAndTaskInfo.layout())
    task: InsertMissionTask.Task = jd.field("Task", lambda: InsertMissionTask.Task.layout())


@jd.message(_SERVICE, 0x4E00)
class ReportSpoolingPreferences(jd.Message):
    """ReportSpoolingPreferences (0x4E00): Tells how far ahead messages are to be spooled.

    data: How far ahead: a number of messages or a distance
    """

    class DataChoice(IntEnum):
        USHORT = 0
        UINT = 1

    @jd.variable(lambda cls: jd.Choice(cls, {0: jd.Number("H"), 1: jd.real("I", 0.0, 35000.0, "meter")}, jd.Values(ReportSpoolingPreferences.DataChoice)))
    class Data(jd.Struct):
        """How far ahead: a number of messages or a distance.

        0: one
        1: meter, 0..35000 meter
        """
        choice: ReportSpoolingPreferences.DataChoice | int
        value: int | float

    data: ReportSpoolingPreferences.Data = jd.field("Data", lambda: ReportSpoolingPreferences.Data.layout())


@jd.message(_SERVICE, 0x2E00, query=True)
class QuerySpoolingPreferences(jd.Message):
    """QuerySpoolingPreferences (0x2E00): Asks how far ahead messages are to be spooled."""
    REPORT = ReportSpoolingPreferences


@jd.message(_SERVICE, 0x4E01)
class ReportMissionStatus(jd.Message):
    """ReportMissionStatus (0x4E01): Tells how far a mission, task or message has got.

    type: Type or 3..255. Whether this is about a mission, a task or a message
    id: Number of the mission, task or message
    status: Status or 8..255. How far it has got
    secondary_status: SecondaryStatus or 4..255. What went wrong, if anything
    """

    class Type(IntEnum):
        MISSION = 0
        TASK = 1
        MESSAGE = 2

    class Status(IntEnum):
        INIT = 0
        RUNNING = 1
        PAUSING = 2
        PAUSED = 3
        ABORTING = 4
        ABORTED = 5
        BLOCKED = 6
        FINISHED = 7

    class SecondaryStatus(IntEnum):
        NO_ERROR = 0
        LOST_COMPONENT_CONTROL = 1
        TOLERANCE_NOT_MET = 2
        INTERNAL_FAILURE = 3

    type: ReportMissionStatus.Type | int = jd.field("Type", lambda: jd.Number("B", jd.Values(ReportMissionStatus.Type, ((3, 255),))))
    id: int = jd.field("ID", jd.Number("H"))
    status: ReportMissionStatus.Status | int = jd.field("Status", lambda: jd.Number("B", jd.Values(ReportMissionStatus.Status, ((8, 255),))))
    secondary_status: ReportMissionStatus.SecondaryStatus | int = jd.field("SecondaryStatus", lambda: jd.Number("B", jd.Values(ReportMissionStatus.SecondaryStatus, ((4, 255),))))


@jd.message(_SERVICE, 0x2E01, presence="B", query=True)
class QueryMissionStatus(jd.Message):
    """QueryMissionStatus (0x2E01): Asks how far a mission, task or message has got.

    mission_id: optional. Number of the mission
    task_id: optional. Number of the task in its mission
    uid: optional. Number of the message in its task
    """
    REPORT = ReportMissionStatus
    mission_id: int | None = jd.field("MissionID", jd.Number("H"), default=None)
    task_id: int | None = jd.field("TaskID", jd.Number("H"), default=None)
    uid: int | None = jd.field("UID", jd.Number("H"), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x4E02)
class ReportStoredMissions(jd.Message):
    """ReportStoredMissions (0x4E02): Tells which missions are stored.

    mission_list: 0..65535 items. The missions
    """

    @jd.bit_field("I")
    class CreatorID(jd.Struct):
        """Who stored the mission.

        component_id: bits 0..7. Component number.
        node_id: bits 8..15. Node number.
        subsystem_id: bits 16..31. Subsystem number.
        """
        component_id: int = jd.bits(0, 0xFF, jd.Values(None, ((1, 255),)))
        node_id: int = jd.bits(8, 0xFF, jd.Values(None, ((1, 255),)))
        subsystem_id: int = jd.bits(16, 0xFFFF, jd.Values(None, ((1, 65535),)))

    @jd.record()
    class MissionInfo(jd.Struct):
        """Which mission is meant.

        mission_id: Number of the mission
        creator_id: Who stored the mission
        """
        mission_id: int = jd.field("MissionID", jd.Number("H"))
        creator_id: ReportStoredMissions.CreatorID = jd.field("CreatorID", lambda: ReportStoredMissions.CreatorID.layout())

    mission_list: list[ReportStoredMissions.MissionInfo] = jd.field("MissionList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportStoredMissions.MissionInfo.layout()))


@jd.message(_SERVICE, 0x2E02, query=True)
class QueryStoredMissions(jd.Message):
    """QueryStoredMissions (0x2E02): Asks which missions are stored."""
    REPORT = ReportStoredMissions


@jd.message(_SERVICE, 0x4E03)
class ReportMissionPlan(jd.Message):
    """ReportMissionPlan (0x4E03): Tells a mission.

    mission_info: Which mission is meant
    """
    SourceID = core_v1_0_types.SourceID
    DestinationID = core_v1_0_types.DestinationID

    @jd.record()
    class MissionInfo(jd.Struct):
        """Which mission is meant.

        mission_id: Number of the mission
        source_id: Who stored the mission
        """
        mission_id: int = jd.field("MissionID", jd.Number("H"))
        source_id: core_v1_0_types.SourceID = jd.field("SourceID", lambda: core_v1_0_types.SourceID.layout())

    @jd.record()
    class TaskInfo(jd.Struct):
        """task_id: Number of the task in its mission"""
        task_id: int = jd.field("TaskID", jd.Number("H"))

    class Blocking(IntEnum):
        NON_BLOCKING = 0
        BLOCKING = 1

    @jd.record()
    class MessageData(jd.Struct):
        """One message and its receiver.

        uid: Number of the message in its task
        destination_id: Who receives the message
        jaus_message: JAUS Message. The message, with its message id
        blocking: Blocking or 2..255. Whether the message must be completed before the next one is sent
        """
        uid: int = jd.field("UID", jd.Number("H"))
        destination_id: core_v1_0_types.DestinationID = jd.field("DestinationID", lambda: core_v1_0_types.DestinationID.layout())
        jaus_message: jd.Message | bytes = jd.field("JausMessage", jd.Blob(jd.Count("I", 0, 4294967295), _registry))
        blocking: ReportMissionPlan.Blocking | int = jd.field("Blocking", lambda: jd.Number("B", jd.Values(ReportMissionPlan.Blocking, ((2, 255),))))

    @jd.record()
    class TaskData(jd.Struct):
        """jaus_messages: 0..65535 items. The messages of the task, in order"""
        task_info: ReportMissionPlan.TaskInfo = jd.field("TaskInfo", lambda: ReportMissionPlan.TaskInfo.layout())
        jaus_messages: list[ReportMissionPlan.MessageData] = jd.field("JAUSMessages", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportMissionPlan.MessageData.layout()))

    @jd.record()
    class SubTaskIndex(jd.Struct):
        """child_task_index: Place of the subtask in the list of tasks"""
        child_task_index: int = jd.field("ChildTaskIndex", jd.Number("H"))

    @jd.record()
    class Task(jd.Struct):
        """sub_tasks: 0..65535 items. The subtasks"""
        task_data: ReportMissionPlan.TaskData = jd.field("TaskData", lambda: ReportMissionPlan.TaskData.layout())
        sub_tasks: list[ReportMissionPlan.SubTaskIndex] = jd.field("SubTasks", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportMissionPlan.SubTaskIndex.layout()))

    mission_info: ReportMissionPlan.MissionInfo = jd.field("MissionInfo", lambda: ReportMissionPlan.MissionInfo.layout())
    task: ReportMissionPlan.Task = jd.field("Task", lambda: ReportMissionPlan.Task.layout())


@jd.message(_SERVICE, 0x2E03, query=True)
class QueryMissionPlan(jd.Message):
    """QueryMissionPlan (0x2E03): Asks for a mission.

    mission_id: Number of the mission
    """
    REPORT = ReportMissionPlan
    mission_id: int = jd.field("MissionID", jd.Number("H"))
