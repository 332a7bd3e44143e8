"""urn:jaus:jss:missionSpooler:MissionSpooler 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages import registry as _registry
from jauspy.messages.core.v1_0 import types as core_v1_0_types


@dataclass(slots=True, repr=False)
class SpoolMission(rt.Message):
    """SpoolMission (0x0E00): Stores a mission.

    mission_info: Which mission is meant
    mission_plan: 0..65535 items. The tasks of the mission
    """

    CODE = 0x0E00
    NAME = "SpoolMission"
    SERVICE = "urn:jaus:jss:missionSpooler:MissionSpooler"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    SourceID = core_v1_0_types.SourceID
    DestinationID = core_v1_0_types.DestinationID

    @dataclass(slots=True, repr=False)
    class MissionInfo(rt.Struct):
        """Which mission is meant.

        mission_id: Number of the mission
        source_id: Who stored the mission
        """

        mission_id: int
        source_id: core_v1_0_types.SourceID

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("MissionID", rt.Number("H")),
                ("SourceID", core_v1_0_types.SourceID.layout()),
            )

    @dataclass(slots=True, repr=False)
    class TaskInfo(rt.Struct):
        """TaskInfo.

        task_id: Number of the task in its mission
        """

        task_id: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("TaskID", rt.Number("H")),
            )

    class Blocking(IntEnum):
        """Values of Blocking."""

        NON_BLOCKING = 0
        BLOCKING = 1

    @dataclass(slots=True, repr=False)
    class MessageData(rt.Struct):
        """One message and its receiver.

        uid: Number of the message in its task
        destination_id: Who receives the message
        jaus_message: JAUS Message. The message, with its message id
        blocking: Blocking or 2..255. Whether the message must be completed before the next one is sent
        """

        uid: int
        destination_id: core_v1_0_types.DestinationID
        jaus_message: rt.Message | bytes
        blocking: SpoolMission.Blocking | int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("UID", rt.Number("H")),
                ("DestinationID", core_v1_0_types.DestinationID.layout()),
                ("JausMessage", rt.Blob(rt.Count("I", 0, 4294967295), _registry)),
                ("Blocking", rt.Number("B", rt.Values(SpoolMission.Blocking, ((2, 255),)))),
            )

    @dataclass(slots=True, repr=False)
    class TaskData(rt.Struct):
        """TaskData.

        jaus_messages: 0..65535 items. The messages of the task, in order
        """

        task_info: SpoolMission.TaskInfo
        jaus_messages: list[SpoolMission.MessageData]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("TaskInfo", SpoolMission.TaskInfo.layout()),
                ("JAUSMessages", rt.Repeat(rt.Count("H", 0, 65535), SpoolMission.MessageData.layout())),
            )

    @dataclass(slots=True, repr=False)
    class SubTaskIndex(rt.Struct):
        """SubTaskIndex.

        child_task_index: Place of the subtask in the list of tasks
        """

        child_task_index: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("ChildTaskIndex", rt.Number("H")),
            )

    @dataclass(slots=True, repr=False)
    class Task(rt.Struct):
        """Task.

        sub_tasks: 0..65535 items. The subtasks
        """

        task_data: SpoolMission.TaskData
        sub_tasks: list[SpoolMission.SubTaskIndex]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("TaskData", SpoolMission.TaskData.layout()),
                ("SubTasks", rt.Repeat(rt.Count("H", 0, 65535), SpoolMission.SubTaskIndex.layout())),
            )

    mission_info: SpoolMission.MissionInfo
    mission_plan: list[SpoolMission.Task]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("MissionInfo", SpoolMission.MissionInfo.layout()),
            ("MissionPlan", rt.Repeat(rt.Count("H", 0, 65535), SpoolMission.Task.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x00 or data[1] != 0x0E: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        mission_id_, source_id_ = _S_HI.unpack_from(data, 2)
        component_id_ = source_id_ & 0xFF
        if component_id_ < 1: raise rt.Reject
        node_id_ = source_id_ >> 8 & 0xFF
        if node_id_ < 1: raise rt.Reject
        subsystem_id_ = source_id_ >> 16 & 0xFFFF
        if subsystem_id_ < 1: raise rt.Reject
        self.mission_info = SpoolMission.MissionInfo(mission_id_, core_v1_0_types.SourceID(component_id_, node_id_, subsystem_id_))
        (mission_plan_count_,) = _S_H.unpack_from(data, 8)
        if mission_plan_count_ * 6 > size - 10: raise rt.Reject
        at = 10
        mission_plan_ = []
        for _ in range(mission_plan_count_):
            item_ = rt.new(SpoolMission.Task)
            item_.task_data = task_data_ = rt.new(SpoolMission.TaskData)
            (task_id_,) = _S_H.unpack_from(data, at)
            task_data_.task_info = SpoolMission.TaskInfo(task_id_)
            (jaus_messages_count_,) = _S_H.unpack_from(data, at + 2)
            if jaus_messages_count_ * 11 > size - (at + 4): raise rt.Reject
            at += 4
            jaus_messages_ = []
            for _ in range(jaus_messages_count_):
                item_2_ = rt.new(SpoolMission.MessageData)
                item_2_.uid, destination_id_ = _S_HI.unpack_from(data, at)
                component_id_2_ = destination_id_ & 0xFF
                if component_id_2_ < 1: raise rt.Reject
                node_id_2_ = destination_id_ >> 8 & 0xFF
                if node_id_2_ < 1: raise rt.Reject
                subsystem_id_2_ = destination_id_ >> 16 & 0xFFFF
                if subsystem_id_2_ < 1: raise rt.Reject
                item_2_.destination_id = core_v1_0_types.DestinationID(component_id_2_, node_id_2_, subsystem_id_2_)
                (jaus_message_end_,) = _S_I.unpack_from(data, at + 6)
                jaus_message_end_ += at + 10
                item_2_.jaus_message = (nesting or _registry.nesting).message(data[at + 10:jaus_message_end_])
                blocking_ = data[jaus_message_end_]
                item_2_.blocking = _E_SpoolMission_Blocking.get(blocking_, blocking_)
                at = jaus_message_end_ + 1
                jaus_messages_.append(item_2_)
            task_data_.jaus_messages = jaus_messages_
            (sub_tasks_count_,) = _S_H.unpack_from(data, at)
            sub_tasks_end_ = at + 2 + sub_tasks_count_ * 2
            item_.sub_tasks = [SpoolMission.SubTaskIndex(child_task_index_) for child_task_index_ in _L_H[sub_tasks_count_].unpack_from(data, at + 2)]
            at = sub_tasks_end_
            mission_plan_.append(item_)
        self.mission_plan = mission_plan_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x00\x0e")
        mission_info_ = self.mission_info
        if type(mission_info_) is not SpoolMission.MissionInfo: raise rt.Reject
        source_id_ = mission_info_.source_id
        if type(source_id_) is not core_v1_0_types.SourceID: raise rt.Reject
        component_id_ = source_id_.component_id
        if not 1 <= component_id_ <= 255: raise rt.Reject
        node_id_ = source_id_.node_id
        if not 1 <= node_id_ <= 255: raise rt.Reject
        subsystem_id_ = source_id_.subsystem_id
        if not 1 <= subsystem_id_ <= 65535: raise rt.Reject
        out += _S_HI.pack(mission_info_.mission_id, component_id_ | node_id_ << 8 | subsystem_id_ << 16)
        mission_plan_ = self.mission_plan
        if type(mission_plan_) is not list: raise rt.Reject
        out += _S_H.pack(len(mission_plan_))
        for item_ in mission_plan_:
            if type(item_) is not SpoolMission.Task: raise rt.Reject
            task_data_ = item_.task_data
            if type(task_data_) is not SpoolMission.TaskData: raise rt.Reject
            task_info_ = task_data_.task_info
            if type(task_info_) is not SpoolMission.TaskInfo: raise rt.Reject
            out += _S_H.pack(task_info_.task_id)
            jaus_messages_ = task_data_.jaus_messages
            if type(jaus_messages_) is not list: raise rt.Reject
            out += _S_H.pack(len(jaus_messages_))
            for item_2_ in jaus_messages_:
                if type(item_2_) is not SpoolMission.MessageData: raise rt.Reject
                destination_id_ = item_2_.destination_id
                if type(destination_id_) is not core_v1_0_types.DestinationID: raise rt.Reject
                component_id_2_ = destination_id_.component_id
                if not 1 <= component_id_2_ <= 255: raise rt.Reject
                node_id_2_ = destination_id_.node_id
                if not 1 <= node_id_2_ <= 255: raise rt.Reject
                subsystem_id_2_ = destination_id_.subsystem_id
                if not 1 <= subsystem_id_2_ <= 65535: raise rt.Reject
                out += _S_HI.pack(item_2_.uid, component_id_2_ | node_id_2_ << 8 | subsystem_id_2_ << 16)
                jaus_message_raw_ = rt.message_bytes(item_2_.jaus_message)
                out += _S_I.pack(len(jaus_message_raw_))
                out += jaus_message_raw_
                out.append(item_2_.blocking)
            sub_tasks_ = item_.sub_tasks
            if type(sub_tasks_) is not list: raise rt.Reject
            out += _S_H.pack(len(sub_tasks_))
            raw_: list[int | float] = []
            for item_3_ in sub_tasks_:
                if type(item_3_) is not SpoolMission.SubTaskIndex: raise rt.Reject
                raw_.append(item_3_.child_task_index)
            out += _L_H[len(raw_)].pack(*raw_)
        return bytes(out)


@dataclass(slots=True, repr=False)
class RunMission(rt.Message):
    """RunMission (0x0E01): Starts a mission, a task or a message.

    mission_id: optional. Number of the mission
    task_id: optional. Number of the task in its mission
    message_uid: optional. Number of the message in its task
    """

    CODE = 0x0E01
    NAME = "RunMission"
    SERVICE = "urn:jaus:jss:missionSpooler:MissionSpooler"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    mission_id: int | None = None
    task_id: int | None = None
    message_uid: int | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("MissionID", rt.Number("H"), True),
            ("TaskID", rt.Number("H"), True),
            ("MessageUID", rt.Number("H"), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_HB.unpack_from(data)
        if code != 0x0E01: raise rt.Reject
        raw = iter(_M_RunMission[mask & 0x7].unpack(data)).__next__
        self = rt.new(cls)
        self.mission_id = raw() if mask & 1 else None
        self.task_id = raw() if mask & 2 else None
        self.message_uid = raw() if mask & 4 else None
        self.reserved_presence = mask & 0xF8
        return self

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0x7: raise rt.Reject
        raw: list[int | float | bytes] = []
        mission_id_ = self.mission_id
        if mission_id_ is not None:
            mask |= 1
            raw.append(mission_id_)
        task_id_ = self.task_id
        if task_id_ is not None:
            mask |= 2
            raw.append(task_id_)
        message_uid_ = self.message_uid
        if message_uid_ is not None:
            mask |= 4
            raw.append(message_uid_)
        return _M_RunMission_pack[mask & 0x7].pack(0x0E01, mask, *raw)


@dataclass(slots=True, repr=False)
class AbortMission(rt.Message):
    """AbortMission (0x0E02): Ends a mission and removes it.

    mission_id: Number of the mission
    """

    CODE = 0x0E02
    NAME = "AbortMission"
    SERVICE = "urn:jaus:jss:missionSpooler:MissionSpooler"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    mission_id: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("MissionID", rt.Number("H")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.mission_id = _S_2H.unpack(data)
        if code != 0x0E02: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_2H.pack(0x0E02, self.mission_id)


@dataclass(slots=True, repr=False)
class PauseMission(rt.Message):
    """PauseMission (0x0E03): Halts a mission.

    mission_id: optional. Number of the mission
    task_id: optional. Number of the task in its mission
    """

    CODE = 0x0E03
    NAME = "PauseMission"
    SERVICE = "urn:jaus:jss:missionSpooler:MissionSpooler"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    mission_id: int | None = None
    task_id: int | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("MissionID", rt.Number("H"), True),
            ("TaskID", rt.Number("H"), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_HB.unpack_from(data)
        if code != 0x0E03: raise rt.Reject
        raw = iter(_M_PauseMission[mask & 0x3].unpack(data)).__next__
        self = rt.new(cls)
        self.mission_id = raw() if mask & 1 else None
        self.task_id = raw() if mask & 2 else None
        self.reserved_presence = mask & 0xFC
        return self

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0x3: raise rt.Reject
        raw: list[int | float | bytes] = []
        mission_id_ = self.mission_id
        if mission_id_ is not None:
            mask |= 1
            raw.append(mission_id_)
        task_id_ = self.task_id
        if task_id_ is not None:
            mask |= 2
            raw.append(task_id_)
        return _M_PauseMission_pack[mask & 0x3].pack(0x0E03, mask, *raw)


@dataclass(slots=True, repr=False)
class ResumeMission(rt.Message):
    """ResumeMission (0x0E04): Continues a mission that was halted.

    mission_id: Number of the mission
    """

    CODE = 0x0E04
    NAME = "ResumeMission"
    SERVICE = "urn:jaus:jss:missionSpooler:MissionSpooler"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    mission_id: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("MissionID", rt.Number("H")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.mission_id = _S_2H.unpack(data)
        if code != 0x0E04: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_2H.pack(0x0E04, self.mission_id)


@dataclass(slots=True, repr=False)
class RemoveMessages(rt.Message):
    """RemoveMessages (0x0E05): Removes messages from a task.

    mission_info: Which mission is meant
    message_list: 0..65535 items. The messages to remove
    """

    CODE = 0x0E05
    NAME = "RemoveMessages"
    SERVICE = "urn:jaus:jss:missionSpooler:MissionSpooler"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    @dataclass(slots=True, repr=False)
    class MissionInfo(rt.Struct):
        """Which mission is meant.

        mission_id: Number of the mission
        task_id: Number of the task in its mission
        """

        mission_id: int
        task_id: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("MissionID", rt.Number("H")),
                ("TaskID", rt.Number("H")),
            )

    @dataclass(slots=True, repr=False)
    class MessageInfo(rt.Struct):
        """MessageInfo.

        uid: Number of the message in its task
        """

        uid: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("UID", rt.Number("H")),
            )

    mission_info: RemoveMessages.MissionInfo
    message_list: list[RemoveMessages.MessageInfo]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("MissionInfo", RemoveMessages.MissionInfo.layout()),
            ("MessageList", rt.Repeat(rt.Count("H", 0, 65535), RemoveMessages.MessageInfo.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x05 or data[1] != 0x0E: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        mission_id_, task_id_ = _S_2H.unpack_from(data, 2)
        self.mission_info = RemoveMessages.MissionInfo(mission_id_, task_id_)
        (message_list_count_,) = _S_H.unpack_from(data, 6)
        message_list_end_ = 8 + message_list_count_ * 2
        self.message_list = [RemoveMessages.MessageInfo(uid_) for uid_ in _L_H[message_list_count_].unpack_from(data, 8)]
        if message_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x05\x0e")
        mission_info_ = self.mission_info
        if type(mission_info_) is not RemoveMessages.MissionInfo: raise rt.Reject
        out += _S_2H.pack(mission_info_.mission_id, mission_info_.task_id)
        message_list_ = self.message_list
        if type(message_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(message_list_))
        raw_: list[int | float] = []
        for item_ in message_list_:
            if type(item_) is not RemoveMessages.MessageInfo: raise rt.Reject
            raw_.append(item_.uid)
        out += _L_H[len(raw_)].pack(*raw_)
        return bytes(out)


@dataclass(slots=True, repr=False)
class InsertMessages(rt.Message):
    """InsertMessages (0x0E06): Inserts messages into a task.

    insert_message_list: 0..65535 items. The messages to insert
    """

    CODE = 0x0E06
    NAME = "InsertMessages"
    SERVICE = "urn:jaus:jss:missionSpooler:MissionSpooler"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    DestinationID = core_v1_0_types.DestinationID

    class InsertLocation(IntEnum):
        """Values of InsertLocation."""

        BEFORE = 0
        AFTER = 1

    @dataclass(slots=True, repr=False)
    class MissionAndTaskInfo(rt.Struct):
        """MissionAndTaskInfo.

        mission_id: Number of the mission
        task_id: Number of the task in its mission
        uid: Number of the message in its task
        insert_location: InsertLocation or 2..255. Whether to insert before or after the named one
        """

        mission_id: int
        task_id: int
        uid: int
        insert_location: InsertMessages.InsertLocation | int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("MissionID", rt.Number("H")),
                ("TaskID", rt.Number("H")),
                ("UID", rt.Number("H")),
                ("InsertLocation", rt.Number("B", rt.Values(InsertMessages.InsertLocation, ((2, 255),)))),
            )

    class Blocking(IntEnum):
        """Values of Blocking."""

        NON_BLOCKING = 0
        BLOCKING = 1

    @dataclass(slots=True, repr=False)
    class InsertMessageInfo(rt.Struct):
        """InsertMessageInfo.

        uid: Number of the message in its task
        destination_id: Who receives the message
        jaus_message: JAUS Message. The message, with its message id
        blocking: Blocking or 2..255. Whether the message must be completed before the next one is sent
        """

        uid: int
        destination_id: core_v1_0_types.DestinationID
        jaus_message: rt.Message | bytes
        blocking: InsertMessages.Blocking | int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("UID", rt.Number("H")),
                ("DestinationID", core_v1_0_types.DestinationID.layout()),
                ("JausMessage", rt.Blob(rt.Count("I", 0, 4294967295), _registry)),
                ("Blocking", rt.Number("B", rt.Values(InsertMessages.Blocking, ((2, 255),)))),
            )

    mission_and_task_info: InsertMessages.MissionAndTaskInfo
    insert_message_list: list[InsertMessages.InsertMessageInfo]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("MissionAndTaskInfo", InsertMessages.MissionAndTaskInfo.layout()),
            ("InsertMessageList", rt.Repeat(rt.Count("H", 0, 65535), InsertMessages.InsertMessageInfo.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x06 or data[1] != 0x0E: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        mission_id_, task_id_, uid_, insert_location_ = _S_3HB.unpack_from(data, 2)
        self.mission_and_task_info = InsertMessages.MissionAndTaskInfo(mission_id_, task_id_, uid_, _E_InsertMessages_InsertLocation.get(insert_location_, insert_location_))
        (insert_message_list_count_,) = _S_H.unpack_from(data, 9)
        if insert_message_list_count_ * 11 > size - 11: raise rt.Reject
        at = 11
        insert_message_list_ = []
        for _ in range(insert_message_list_count_):
            item_ = rt.new(InsertMessages.InsertMessageInfo)
            item_.uid, destination_id_ = _S_HI.unpack_from(data, at)
            component_id_ = destination_id_ & 0xFF
            if component_id_ < 1: raise rt.Reject
            node_id_ = destination_id_ >> 8 & 0xFF
            if node_id_ < 1: raise rt.Reject
            subsystem_id_ = destination_id_ >> 16 & 0xFFFF
            if subsystem_id_ < 1: raise rt.Reject
            item_.destination_id = core_v1_0_types.DestinationID(component_id_, node_id_, subsystem_id_)
            (jaus_message_end_,) = _S_I.unpack_from(data, at + 6)
            jaus_message_end_ += at + 10
            item_.jaus_message = (nesting or _registry.nesting).message(data[at + 10:jaus_message_end_])
            blocking_ = data[jaus_message_end_]
            item_.blocking = _E_InsertMessages_Blocking.get(blocking_, blocking_)
            at = jaus_message_end_ + 1
            insert_message_list_.append(item_)
        self.insert_message_list = insert_message_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x06\x0e")
        mission_and_task_info_ = self.mission_and_task_info
        if type(mission_and_task_info_) is not InsertMessages.MissionAndTaskInfo: raise rt.Reject
        out += _S_3HB.pack(mission_and_task_info_.mission_id, mission_and_task_info_.task_id, mission_and_task_info_.uid, mission_and_task_info_.insert_location)
        insert_message_list_ = self.insert_message_list
        if type(insert_message_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(insert_message_list_))
        for item_ in insert_message_list_:
            if type(item_) is not InsertMessages.InsertMessageInfo: raise rt.Reject
            destination_id_ = item_.destination_id
            if type(destination_id_) is not core_v1_0_types.DestinationID: raise rt.Reject
            component_id_ = destination_id_.component_id
            if not 1 <= component_id_ <= 255: raise rt.Reject
            node_id_ = destination_id_.node_id
            if not 1 <= node_id_ <= 255: raise rt.Reject
            subsystem_id_ = destination_id_.subsystem_id
            if not 1 <= subsystem_id_ <= 65535: raise rt.Reject
            out += _S_HI.pack(item_.uid, component_id_ | node_id_ << 8 | subsystem_id_ << 16)
            jaus_message_raw_ = rt.message_bytes(item_.jaus_message)
            out += _S_I.pack(len(jaus_message_raw_))
            out += jaus_message_raw_
            out.append(item_.blocking)
        return bytes(out)


@dataclass(slots=True, repr=False)
class RemoveMissionTask(rt.Message):
    """RemoveMissionTask (0x0E07): Removes tasks from a mission.

    remove_task_list: 0..65535 items. The tasks to remove
    """

    CODE = 0x0E07
    NAME = "RemoveMissionTask"
    SERVICE = "urn:jaus:jss:missionSpooler:MissionSpooler"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    @dataclass(slots=True, repr=False)
    class MissionAndTaskInfo(rt.Struct):
        """MissionAndTaskInfo.

        mission_id: Number of the mission
        task_id: Number of the task in its mission
        """

        mission_id: int
        task_id: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("MissionID", rt.Number("H")),
                ("TaskID", rt.Number("H")),
            )

    @dataclass(slots=True, repr=False)
    class RemoveTaskInfo(rt.Struct):
        """RemoveTaskInfo.

        task_id: Number of the task in its mission
        """

        task_id: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("TaskID", rt.Number("H")),
            )

    mission_and_task_info: RemoveMissionTask.MissionAndTaskInfo
    remove_task_list: list[RemoveMissionTask.RemoveTaskInfo]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("MissionAndTaskInfo", RemoveMissionTask.MissionAndTaskInfo.layout()),
            ("RemoveTaskList", rt.Repeat(rt.Count("H", 0, 65535), RemoveMissionTask.RemoveTaskInfo.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x07 or data[1] != 0x0E: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        mission_id_, task_id_ = _S_2H.unpack_from(data, 2)
        self.mission_and_task_info = RemoveMissionTask.MissionAndTaskInfo(mission_id_, task_id_)
        (remove_task_list_count_,) = _S_H.unpack_from(data, 6)
        remove_task_list_end_ = 8 + remove_task_list_count_ * 2
        self.remove_task_list = [RemoveMissionTask.RemoveTaskInfo(task_id_2_) for task_id_2_ in _L_H[remove_task_list_count_].unpack_from(data, 8)]
        if remove_task_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x07\x0e")
        mission_and_task_info_ = self.mission_and_task_info
        if type(mission_and_task_info_) is not RemoveMissionTask.MissionAndTaskInfo: raise rt.Reject
        out += _S_2H.pack(mission_and_task_info_.mission_id, mission_and_task_info_.task_id)
        remove_task_list_ = self.remove_task_list
        if type(remove_task_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(remove_task_list_))
        raw_: list[int | float] = []
        for item_ in remove_task_list_:
            if type(item_) is not RemoveMissionTask.RemoveTaskInfo: raise rt.Reject
            raw_.append(item_.task_id)
        out += _L_H[len(raw_)].pack(*raw_)
        return bytes(out)


@dataclass(slots=True, repr=False)
class InsertMissionTask(rt.Message):
    """InsertMissionTask (0x0E08): Inserts a task into a mission."""

    CODE = 0x0E08
    NAME = "InsertMissionTask"
    SERVICE = "urn:jaus:jss:missionSpooler:MissionSpooler"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    DestinationID = core_v1_0_types.DestinationID

    class InsertLocation(IntEnum):
        """Values of InsertLocation."""

        BEFORE = 0
        AFTER = 1

    @dataclass(slots=True, repr=False)
    class MissionAndTaskInfo(rt.Struct):
        """MissionAndTaskInfo.

        mission_id: Number of the mission
        task_id: Number of the task in its mission
        insert_location: InsertLocation or 2..255. Whether to insert before or after the named one
        new_parent_task_id: Task that the new one becomes part of
        """

        mission_id: int
        task_id: int
        insert_location: InsertMissionTask.InsertLocation | int
        new_parent_task_id: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("MissionID", rt.Number("H")),
                ("TaskID", rt.Number("H")),
                ("InsertLocation", rt.Number("B", rt.Values(InsertMissionTask.InsertLocation, ((2, 255),)))),
                ("NewParentTaskID", rt.Number("H")),
            )

    @dataclass(slots=True, repr=False)
    class TaskInfo(rt.Struct):
        """TaskInfo.

        task_id: Number of the task in its mission
        """

        task_id: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("TaskID", rt.Number("H")),
            )

    class Blocking(IntEnum):
        """Values of Blocking."""

        NON_BLOCKING = 0
        BLOCKING = 1

    @dataclass(slots=True, repr=False)
    class MessageData(rt.Struct):
        """One message and its receiver.

        uid: Number of the message in its task
        destination_id: Who receives the message
        jaus_message: JAUS Message. The message, with its message id
        blocking: Blocking or 2..255. Whether the message must be completed before the next one is sent
        """

        uid: int
        destination_id: core_v1_0_types.DestinationID
        jaus_message: rt.Message | bytes
        blocking: InsertMissionTask.Blocking | int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("UID", rt.Number("H")),
                ("DestinationID", core_v1_0_types.DestinationID.layout()),
                ("JausMessage", rt.Blob(rt.Count("I", 0, 4294967295), _registry)),
                ("Blocking", rt.Number("B", rt.Values(InsertMissionTask.Blocking, ((2, 255),)))),
            )

    @dataclass(slots=True, repr=False)
    class TaskData(rt.Struct):
        """TaskData.

        task_messages: 0..65535 items. The messages of the task, in order
        """

        task_info: InsertMissionTask.TaskInfo
        task_messages: list[InsertMissionTask.MessageData]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("TaskInfo", InsertMissionTask.TaskInfo.layout()),
                ("TaskMessages", rt.Repeat(rt.Count("H", 0, 65535), InsertMissionTask.MessageData.layout())),
            )

    @dataclass(slots=True, repr=False)
    class SubTaskIndex(rt.Struct):
        """SubTaskIndex.

        child_task_index: Place of the subtask in the list of tasks
        """

        child_task_index: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("ChildTaskIndex", rt.Number("H")),
            )

    @dataclass(slots=True, repr=False)
    class Task(rt.Struct):
        """Task.

        sub_tasks: 0..65535 items. The subtasks
        """

        task_data: InsertMissionTask.TaskData
        sub_tasks: list[InsertMissionTask.SubTaskIndex]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("TaskData", InsertMissionTask.TaskData.layout()),
                ("SubTasks", rt.Repeat(rt.Count("H", 0, 65535), InsertMissionTask.SubTaskIndex.layout())),
            )

    mission_and_task_info: InsertMissionTask.MissionAndTaskInfo
    task: InsertMissionTask.Task

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("MissionAndTaskInfo", InsertMissionTask.MissionAndTaskInfo.layout()),
            ("Task", InsertMissionTask.Task.layout()),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x08 or data[1] != 0x0E: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        mission_id_, task_id_, insert_location_, new_parent_task_id_ = _S_2HBH.unpack_from(data, 2)
        self.mission_and_task_info = InsertMissionTask.MissionAndTaskInfo(mission_id_, task_id_, _E_InsertMissionTask_InsertLocation.get(insert_location_, insert_location_), new_parent_task_id_)
        self.task = task_ = rt.new(InsertMissionTask.Task)
        task_.task_data = task_data_ = rt.new(InsertMissionTask.TaskData)
        (task_id_2_,) = _S_H.unpack_from(data, 9)
        task_data_.task_info = InsertMissionTask.TaskInfo(task_id_2_)
        (task_messages_count_,) = _S_H.unpack_from(data, 11)
        if task_messages_count_ * 11 > size - 13: raise rt.Reject
        at = 13
        task_messages_ = []
        for _ in range(task_messages_count_):
            item_ = rt.new(InsertMissionTask.MessageData)
            item_.uid, destination_id_ = _S_HI.unpack_from(data, at)
            component_id_ = destination_id_ & 0xFF
            if component_id_ < 1: raise rt.Reject
            node_id_ = destination_id_ >> 8 & 0xFF
            if node_id_ < 1: raise rt.Reject
            subsystem_id_ = destination_id_ >> 16 & 0xFFFF
            if subsystem_id_ < 1: raise rt.Reject
            item_.destination_id = core_v1_0_types.DestinationID(component_id_, node_id_, subsystem_id_)
            (jaus_message_end_,) = _S_I.unpack_from(data, at + 6)
            jaus_message_end_ += at + 10
            item_.jaus_message = (nesting or _registry.nesting).message(data[at + 10:jaus_message_end_])
            blocking_ = data[jaus_message_end_]
            item_.blocking = _E_InsertMissionTask_Blocking.get(blocking_, blocking_)
            at = jaus_message_end_ + 1
            task_messages_.append(item_)
        task_data_.task_messages = task_messages_
        (sub_tasks_count_,) = _S_H.unpack_from(data, at)
        sub_tasks_end_ = at + 2 + sub_tasks_count_ * 2
        task_.sub_tasks = [InsertMissionTask.SubTaskIndex(child_task_index_) for child_task_index_ in _L_H[sub_tasks_count_].unpack_from(data, at + 2)]
        if sub_tasks_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x08\x0e")
        mission_and_task_info_ = self.mission_and_task_info
        if type(mission_and_task_info_) is not InsertMissionTask.MissionAndTaskInfo: raise rt.Reject
        out += _S_2HBH.pack(mission_and_task_info_.mission_id, mission_and_task_info_.task_id, mission_and_task_info_.insert_location, mission_and_task_info_.new_parent_task_id)
        task_ = self.task
        if type(task_) is not InsertMissionTask.Task: raise rt.Reject
        task_data_ = task_.task_data
        if type(task_data_) is not InsertMissionTask.TaskData: raise rt.Reject
        task_info_ = task_data_.task_info
        if type(task_info_) is not InsertMissionTask.TaskInfo: raise rt.Reject
        out += _S_H.pack(task_info_.task_id)
        task_messages_ = task_data_.task_messages
        if type(task_messages_) is not list: raise rt.Reject
        out += _S_H.pack(len(task_messages_))
        for item_ in task_messages_:
            if type(item_) is not InsertMissionTask.MessageData: raise rt.Reject
            destination_id_ = item_.destination_id
            if type(destination_id_) is not core_v1_0_types.DestinationID: raise rt.Reject
            component_id_ = destination_id_.component_id
            if not 1 <= component_id_ <= 255: raise rt.Reject
            node_id_ = destination_id_.node_id
            if not 1 <= node_id_ <= 255: raise rt.Reject
            subsystem_id_ = destination_id_.subsystem_id
            if not 1 <= subsystem_id_ <= 65535: raise rt.Reject
            out += _S_HI.pack(item_.uid, component_id_ | node_id_ << 8 | subsystem_id_ << 16)
            jaus_message_raw_ = rt.message_bytes(item_.jaus_message)
            out += _S_I.pack(len(jaus_message_raw_))
            out += jaus_message_raw_
            out.append(item_.blocking)
        sub_tasks_ = task_.sub_tasks
        if type(sub_tasks_) is not list: raise rt.Reject
        out += _S_H.pack(len(sub_tasks_))
        raw_: list[int | float] = []
        for item_2_ in sub_tasks_:
            if type(item_2_) is not InsertMissionTask.SubTaskIndex: raise rt.Reject
            raw_.append(item_2_.child_task_index)
        out += _L_H[len(raw_)].pack(*raw_)
        return bytes(out)


@dataclass(slots=True, repr=False)
class QuerySpoolingPreferences(rt.Message):
    """QuerySpoolingPreferences (0x2E00): Asks how far ahead messages are to be spooled."""

    CODE = 0x2E00
    NAME = "QuerySpoolingPreferences"
    SERVICE = "urn:jaus:jss:missionSpooler:MissionSpooler"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportSpoolingPreferences]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x00.': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2E00)


@dataclass(slots=True, repr=False)
class QueryMissionStatus(rt.Message):
    """QueryMissionStatus (0x2E01): Asks how far a mission, task or message has got.

    mission_id: optional. Number of the mission
    task_id: optional. Number of the task in its mission
    uid: optional. Number of the message in its task
    """

    CODE = 0x2E01
    NAME = "QueryMissionStatus"
    SERVICE = "urn:jaus:jss:missionSpooler:MissionSpooler"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportMissionStatus]]

    mission_id: int | None = None
    task_id: int | None = None
    uid: int | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("MissionID", rt.Number("H"), True),
            ("TaskID", rt.Number("H"), True),
            ("UID", rt.Number("H"), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_HB.unpack_from(data)
        if code != 0x2E01: raise rt.Reject
        raw = iter(_M_RunMission[mask & 0x7].unpack(data)).__next__
        self = rt.new(cls)
        self.mission_id = raw() if mask & 1 else None
        self.task_id = raw() if mask & 2 else None
        self.uid = raw() if mask & 4 else None
        self.reserved_presence = mask & 0xF8
        return self

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0x7: raise rt.Reject
        raw: list[int | float | bytes] = []
        mission_id_ = self.mission_id
        if mission_id_ is not None:
            mask |= 1
            raw.append(mission_id_)
        task_id_ = self.task_id
        if task_id_ is not None:
            mask |= 2
            raw.append(task_id_)
        uid_ = self.uid
        if uid_ is not None:
            mask |= 4
            raw.append(uid_)
        return _M_RunMission_pack[mask & 0x7].pack(0x2E01, mask, *raw)


@dataclass(slots=True, repr=False)
class QueryStoredMissions(rt.Message):
    """QueryStoredMissions (0x2E02): Asks which missions are stored."""

    CODE = 0x2E02
    NAME = "QueryStoredMissions"
    SERVICE = "urn:jaus:jss:missionSpooler:MissionSpooler"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportStoredMissions]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x02.': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2E02)


@dataclass(slots=True, repr=False)
class QueryMissionPlan(rt.Message):
    """QueryMissionPlan (0x2E03): Asks for a mission.

    mission_id: Number of the mission
    """

    CODE = 0x2E03
    NAME = "QueryMissionPlan"
    SERVICE = "urn:jaus:jss:missionSpooler:MissionSpooler"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportMissionPlan]]

    mission_id: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("MissionID", rt.Number("H")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.mission_id = _S_2H.unpack(data)
        if code != 0x2E03: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_2H.pack(0x2E03, self.mission_id)


@dataclass(slots=True, repr=False)
class ReportSpoolingPreferences(rt.Message):
    """ReportSpoolingPreferences (0x4E00): Tells how far ahead messages are to be spooled.

    data: How far ahead: a number of messages or a distance
    """

    CODE = 0x4E00
    NAME = "ReportSpoolingPreferences"
    SERVICE = "urn:jaus:jss:missionSpooler:MissionSpooler"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    class DataChoice(IntEnum):
        """Values of DataChoice."""

        USHORT = 0
        UINT = 1

    @dataclass(slots=True, repr=False)
    class Data(rt.Struct):
        """How far ahead: a number of messages or a distance.

        0: one
        1: meter, 0..35000 meter
        """

        choice: ReportSpoolingPreferences.DataChoice | int
        value: int | float

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Choice(
                cls,
                {
                    0: rt.Number("H"),
                    1: rt.real("I", 0.0, 35000.0, "meter"),
                },
                rt.Values(ReportSpoolingPreferences.DataChoice),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            choice = data[at]
            if choice == 0:
                (self.value,) = _S_H.unpack_from(data, at + 1)
                at += 3
            elif choice == 1:
                (value_,) = _S_I.unpack_from(data, at + 1)
                self.value = value_ * 8.14907252978279e-06
                at += 5
            else: raise rt.Reject
            self.choice = _E_ReportSpoolingPreferences_DataChoice[choice]
            return self, at

        def _write(self, out: bytearray) -> None:
            choice = self.choice
            if choice == 0:
                out += _S_BH.pack(choice, self.value)
            elif choice == 1:
                value_ = self.value
                if not 0.0 <= value_ <= 35000.0: raise rt.Reject
                near = value_ * 122713.35128571429 + 0.5
                value_raw_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_ < 0.9999847412109375: value_raw_ = rt.exact_raw(value_, _R_19)
                out += _S_BI.pack(choice, value_raw_)
            else: raise rt.Reject

    data: ReportSpoolingPreferences.Data

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("Data", ReportSpoolingPreferences.Data.layout()),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x00 or data[1] != 0x4E: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        at = 2
        self.data, at = ReportSpoolingPreferences.Data._read(data, at, nesting)
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x00\x4e")
        data_ = self.data
        if type(data_) is not ReportSpoolingPreferences.Data: raise rt.Reject
        data_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportMissionStatus(rt.Message):
    """ReportMissionStatus (0x4E01): Tells how far a mission, task or message has got.

    type: Type or 3..255. Whether this is about a mission, a task or a message
    id: Number of the mission, task or message
    status: Status or 8..255. How far it has got
    secondary_status: SecondaryStatus or 4..255. What went wrong, if anything
    """

    CODE = 0x4E01
    NAME = "ReportMissionStatus"
    SERVICE = "urn:jaus:jss:missionSpooler:MissionSpooler"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    class Type(IntEnum):
        """Values of Type."""

        MISSION = 0
        TASK = 1
        MESSAGE = 2

    class Status(IntEnum):
        """Values of Status."""

        INIT = 0
        RUNNING = 1
        PAUSING = 2
        PAUSED = 3
        ABORTING = 4
        ABORTED = 5
        BLOCKED = 6
        FINISHED = 7

    class SecondaryStatus(IntEnum):
        """Values of SecondaryStatus."""

        NO_ERROR = 0
        LOST_COMPONENT_CONTROL = 1
        TOLERANCE_NOT_MET = 2
        INTERNAL_FAILURE = 3

    type: ReportMissionStatus.Type | int
    id: int
    status: ReportMissionStatus.Status | int
    secondary_status: ReportMissionStatus.SecondaryStatus | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("Type", rt.Number("B", rt.Values(ReportMissionStatus.Type, ((3, 255),)))),
            ("ID", rt.Number("H")),
            ("Status", rt.Number("B", rt.Values(ReportMissionStatus.Status, ((8, 255),)))),
            ("SecondaryStatus", rt.Number("B", rt.Values(ReportMissionStatus.SecondaryStatus, ((4, 255),)))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, type_, self.id, status_, secondary_status_ = _S_HBH2B.unpack(data)
        if code != 0x4E01: raise rt.Reject
        self.type = _E_ReportMissionStatus_Type.get(type_, type_)
        self.status = _E_ReportMissionStatus_Status.get(status_, status_)
        self.secondary_status = _E_ReportMissionStatus_SecondaryStatus.get(secondary_status_, secondary_status_)
        return self

    def _pack(self) -> bytes:
        return _S_HBH2B.pack(0x4E01, self.type, self.id, self.status, self.secondary_status)


@dataclass(slots=True, repr=False)
class ReportStoredMissions(rt.Message):
    """ReportStoredMissions (0x4E02): Tells which missions are stored.

    mission_list: 0..65535 items. The missions
    """

    CODE = 0x4E02
    NAME = "ReportStoredMissions"
    SERVICE = "urn:jaus:jss:missionSpooler:MissionSpooler"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    @dataclass(slots=True, repr=False)
    class CreatorID(rt.Struct):
        """Who stored the mission.

        component_id: bits 0..7. Component number.
        node_id: bits 8..15. Node number.
        subsystem_id: bits 16..31. Subsystem number.
        """

        component_id: int
        node_id: int
        subsystem_id: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Bits(
                cls,
                "I",
                (
                    rt.Bit("component_id", 0, 0xFF, rt.Values(None, ((1, 255),))),
                    rt.Bit("node_id", 8, 0xFF, rt.Values(None, ((1, 255),))),
                    rt.Bit("subsystem_id", 16, 0xFFFF, rt.Values(None, ((1, 65535),))),
                ),
            )

    @dataclass(slots=True, repr=False)
    class MissionInfo(rt.Struct):
        """Which mission is meant.

        mission_id: Number of the mission
        creator_id: Who stored the mission
        """

        mission_id: int
        creator_id: ReportStoredMissions.CreatorID

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("MissionID", rt.Number("H")),
                ("CreatorID", ReportStoredMissions.CreatorID.layout()),
            )

    mission_list: list[ReportStoredMissions.MissionInfo]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("MissionList", rt.Repeat(rt.Count("H", 0, 65535), ReportStoredMissions.MissionInfo.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x02 or data[1] != 0x4E: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (mission_list_count_,) = _S_H.unpack_from(data, 2)
        mission_list_end_ = 4 + mission_list_count_ * 6
        mission_list_ = []
        for mission_id_, creator_id_ in _S_HI.iter_unpack(data[4:mission_list_end_]):
            component_id_ = creator_id_ & 0xFF
            if component_id_ < 1: raise rt.Reject
            node_id_ = creator_id_ >> 8 & 0xFF
            if node_id_ < 1: raise rt.Reject
            subsystem_id_ = creator_id_ >> 16 & 0xFFFF
            if subsystem_id_ < 1: raise rt.Reject
            mission_list_.append(ReportStoredMissions.MissionInfo(mission_id_, ReportStoredMissions.CreatorID(component_id_, node_id_, subsystem_id_)))
        self.mission_list = mission_list_
        if mission_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x02\x4e")
        mission_list_ = self.mission_list
        if type(mission_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(mission_list_))
        for item_ in mission_list_:
            if type(item_) is not ReportStoredMissions.MissionInfo: raise rt.Reject
            creator_id_ = item_.creator_id
            if type(creator_id_) is not ReportStoredMissions.CreatorID: raise rt.Reject
            component_id_ = creator_id_.component_id
            if not 1 <= component_id_ <= 255: raise rt.Reject
            node_id_ = creator_id_.node_id
            if not 1 <= node_id_ <= 255: raise rt.Reject
            subsystem_id_ = creator_id_.subsystem_id
            if not 1 <= subsystem_id_ <= 65535: raise rt.Reject
            out += _S_HI.pack(item_.mission_id, component_id_ | node_id_ << 8 | subsystem_id_ << 16)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportMissionPlan(rt.Message):
    """ReportMissionPlan (0x4E03): Tells a mission.

    mission_info: Which mission is meant
    """

    CODE = 0x4E03
    NAME = "ReportMissionPlan"
    SERVICE = "urn:jaus:jss:missionSpooler:MissionSpooler"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    SourceID = core_v1_0_types.SourceID
    DestinationID = core_v1_0_types.DestinationID

    @dataclass(slots=True, repr=False)
    class MissionInfo(rt.Struct):
        """Which mission is meant.

        mission_id: Number of the mission
        source_id: Who stored the mission
        """

        mission_id: int
        source_id: core_v1_0_types.SourceID

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("MissionID", rt.Number("H")),
                ("SourceID", core_v1_0_types.SourceID.layout()),
            )

    @dataclass(slots=True, repr=False)
    class TaskInfo(rt.Struct):
        """TaskInfo.

        task_id: Number of the task in its mission
        """

        task_id: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("TaskID", rt.Number("H")),
            )

    class Blocking(IntEnum):
        """Values of Blocking."""

        NON_BLOCKING = 0
        BLOCKING = 1

    @dataclass(slots=True, repr=False)
    class MessageData(rt.Struct):
        """One message and its receiver.

        uid: Number of the message in its task
        destination_id: Who receives the message
        jaus_message: JAUS Message. The message, with its message id
        blocking: Blocking or 2..255. Whether the message must be completed before the next one is sent
        """

        uid: int
        destination_id: core_v1_0_types.DestinationID
        jaus_message: rt.Message | bytes
        blocking: ReportMissionPlan.Blocking | int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("UID", rt.Number("H")),
                ("DestinationID", core_v1_0_types.DestinationID.layout()),
                ("JausMessage", rt.Blob(rt.Count("I", 0, 4294967295), _registry)),
                ("Blocking", rt.Number("B", rt.Values(ReportMissionPlan.Blocking, ((2, 255),)))),
            )

    @dataclass(slots=True, repr=False)
    class TaskData(rt.Struct):
        """TaskData.

        jaus_messages: 0..65535 items. The messages of the task, in order
        """

        task_info: ReportMissionPlan.TaskInfo
        jaus_messages: list[ReportMissionPlan.MessageData]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("TaskInfo", ReportMissionPlan.TaskInfo.layout()),
                ("JAUSMessages", rt.Repeat(rt.Count("H", 0, 65535), ReportMissionPlan.MessageData.layout())),
            )

    @dataclass(slots=True, repr=False)
    class SubTaskIndex(rt.Struct):
        """SubTaskIndex.

        child_task_index: Place of the subtask in the list of tasks
        """

        child_task_index: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("ChildTaskIndex", rt.Number("H")),
            )

    @dataclass(slots=True, repr=False)
    class Task(rt.Struct):
        """Task.

        sub_tasks: 0..65535 items. The subtasks
        """

        task_data: ReportMissionPlan.TaskData
        sub_tasks: list[ReportMissionPlan.SubTaskIndex]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("TaskData", ReportMissionPlan.TaskData.layout()),
                ("SubTasks", rt.Repeat(rt.Count("H", 0, 65535), ReportMissionPlan.SubTaskIndex.layout())),
            )

    mission_info: ReportMissionPlan.MissionInfo
    task: ReportMissionPlan.Task

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("MissionInfo", ReportMissionPlan.MissionInfo.layout()),
            ("Task", ReportMissionPlan.Task.layout()),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x03 or data[1] != 0x4E: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        mission_id_, source_id_ = _S_HI.unpack_from(data, 2)
        component_id_ = source_id_ & 0xFF
        if component_id_ < 1: raise rt.Reject
        node_id_ = source_id_ >> 8 & 0xFF
        if node_id_ < 1: raise rt.Reject
        subsystem_id_ = source_id_ >> 16 & 0xFFFF
        if subsystem_id_ < 1: raise rt.Reject
        self.mission_info = ReportMissionPlan.MissionInfo(mission_id_, core_v1_0_types.SourceID(component_id_, node_id_, subsystem_id_))
        self.task = task_ = rt.new(ReportMissionPlan.Task)
        task_.task_data = task_data_ = rt.new(ReportMissionPlan.TaskData)
        (task_id_,) = _S_H.unpack_from(data, 8)
        task_data_.task_info = ReportMissionPlan.TaskInfo(task_id_)
        (jaus_messages_count_,) = _S_H.unpack_from(data, 10)
        if jaus_messages_count_ * 11 > size - 12: raise rt.Reject
        at = 12
        jaus_messages_ = []
        for _ in range(jaus_messages_count_):
            item_ = rt.new(ReportMissionPlan.MessageData)
            item_.uid, destination_id_ = _S_HI.unpack_from(data, at)
            component_id_2_ = destination_id_ & 0xFF
            if component_id_2_ < 1: raise rt.Reject
            node_id_2_ = destination_id_ >> 8 & 0xFF
            if node_id_2_ < 1: raise rt.Reject
            subsystem_id_2_ = destination_id_ >> 16 & 0xFFFF
            if subsystem_id_2_ < 1: raise rt.Reject
            item_.destination_id = core_v1_0_types.DestinationID(component_id_2_, node_id_2_, subsystem_id_2_)
            (jaus_message_end_,) = _S_I.unpack_from(data, at + 6)
            jaus_message_end_ += at + 10
            item_.jaus_message = (nesting or _registry.nesting).message(data[at + 10:jaus_message_end_])
            blocking_ = data[jaus_message_end_]
            item_.blocking = _E_ReportMissionPlan_Blocking.get(blocking_, blocking_)
            at = jaus_message_end_ + 1
            jaus_messages_.append(item_)
        task_data_.jaus_messages = jaus_messages_
        (sub_tasks_count_,) = _S_H.unpack_from(data, at)
        sub_tasks_end_ = at + 2 + sub_tasks_count_ * 2
        task_.sub_tasks = [ReportMissionPlan.SubTaskIndex(child_task_index_) for child_task_index_ in _L_H[sub_tasks_count_].unpack_from(data, at + 2)]
        if sub_tasks_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x03\x4e")
        mission_info_ = self.mission_info
        if type(mission_info_) is not ReportMissionPlan.MissionInfo: raise rt.Reject
        source_id_ = mission_info_.source_id
        if type(source_id_) is not core_v1_0_types.SourceID: raise rt.Reject
        component_id_ = source_id_.component_id
        if not 1 <= component_id_ <= 255: raise rt.Reject
        node_id_ = source_id_.node_id
        if not 1 <= node_id_ <= 255: raise rt.Reject
        subsystem_id_ = source_id_.subsystem_id
        if not 1 <= subsystem_id_ <= 65535: raise rt.Reject
        out += _S_HI.pack(mission_info_.mission_id, component_id_ | node_id_ << 8 | subsystem_id_ << 16)
        task_ = self.task
        if type(task_) is not ReportMissionPlan.Task: raise rt.Reject
        task_data_ = task_.task_data
        if type(task_data_) is not ReportMissionPlan.TaskData: raise rt.Reject
        task_info_ = task_data_.task_info
        if type(task_info_) is not ReportMissionPlan.TaskInfo: raise rt.Reject
        out += _S_H.pack(task_info_.task_id)
        jaus_messages_ = task_data_.jaus_messages
        if type(jaus_messages_) is not list: raise rt.Reject
        out += _S_H.pack(len(jaus_messages_))
        for item_ in jaus_messages_:
            if type(item_) is not ReportMissionPlan.MessageData: raise rt.Reject
            destination_id_ = item_.destination_id
            if type(destination_id_) is not core_v1_0_types.DestinationID: raise rt.Reject
            component_id_2_ = destination_id_.component_id
            if not 1 <= component_id_2_ <= 255: raise rt.Reject
            node_id_2_ = destination_id_.node_id
            if not 1 <= node_id_2_ <= 255: raise rt.Reject
            subsystem_id_2_ = destination_id_.subsystem_id
            if not 1 <= subsystem_id_2_ <= 65535: raise rt.Reject
            out += _S_HI.pack(item_.uid, component_id_2_ | node_id_2_ << 8 | subsystem_id_2_ << 16)
            jaus_message_raw_ = rt.message_bytes(item_.jaus_message)
            out += _S_I.pack(len(jaus_message_raw_))
            out += jaus_message_raw_
            out.append(item_.blocking)
        sub_tasks_ = task_.sub_tasks
        if type(sub_tasks_) is not list: raise rt.Reject
        out += _S_H.pack(len(sub_tasks_))
        raw_: list[int | float] = []
        for item_2_ in sub_tasks_:
            if type(item_2_) is not ReportMissionPlan.SubTaskIndex: raise rt.Reject
            raw_.append(item_2_.child_task_index)
        out += _L_H[len(raw_)].pack(*raw_)
        return bytes(out)


_S_HI = rt.Packer("<HI")
_S_H = rt.Packer("<H")
_S_I = rt.Packer("<I")
_E_SpoolMission_Blocking = rt.members(SpoolMission.Blocking)
_L_H = rt.Rows("H")
_S_HB = rt.Packer("<HB")
_M_RunMission = rt.Masks("3x", ((1, "H"), (2, "H"), (4, "H")))
_M_RunMission_pack = rt.Masks("HB", ((1, "H"), (2, "H"), (4, "H")))
_S_2H = rt.Packer("<2H")
_M_PauseMission = rt.Masks("3x", ((1, "H"), (2, "H")))
_M_PauseMission_pack = rt.Masks("HB", ((1, "H"), (2, "H")))
_E_InsertMessages_InsertLocation = rt.members(InsertMessages.InsertLocation)
_S_3HB = rt.Packer("<3HB")
_E_InsertMessages_Blocking = rt.members(InsertMessages.Blocking)
_E_InsertMissionTask_InsertLocation = rt.members(InsertMissionTask.InsertLocation)
_S_2HBH = rt.Packer("<2HBH")
_E_InsertMissionTask_Blocking = rt.members(InsertMissionTask.Blocking)
_E_ReportSpoolingPreferences_DataChoice = rt.members(ReportSpoolingPreferences.DataChoice)
_S_BH = rt.Packer("<BH")
_R_19 = rt.Scaling(0.0, 35000.0, 4294967295)
_S_BI = rt.Packer("<BI")
_E_ReportMissionStatus_Type = rt.members(ReportMissionStatus.Type)
_E_ReportMissionStatus_Status = rt.members(ReportMissionStatus.Status)
_E_ReportMissionStatus_SecondaryStatus = rt.members(ReportMissionStatus.SecondaryStatus)
_S_HBH2B = rt.Packer("<HBH2B")
_E_ReportMissionPlan_Blocking = rt.members(ReportMissionPlan.Blocking)
QuerySpoolingPreferences.REPORT = ReportSpoolingPreferences
QueryMissionStatus.REPORT = ReportMissionStatus
QueryStoredMissions.REPORT = ReportStoredMissions
QueryMissionPlan.REPORT = ReportMissionPlan
