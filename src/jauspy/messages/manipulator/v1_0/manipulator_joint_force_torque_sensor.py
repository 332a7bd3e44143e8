"""urn:jaus:jss:manipulator:ManipulatorJointForceTorqueSensor 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.manipulator.v1_0 import manipulator_actuator_force_torque_driver as manipulator_v1_0_manipulator_actuator_force_torque_driver
from jauspy.messages.manipulator.v1_0 import types as manipulator_v1_0_types


@dataclass(slots=True, repr=False)
class QueryJointForceTorques(rt.Message):
    """QueryJointForceTorques (0x2605): Asks for the force or torque of each joint."""

    CODE = 0x2605
    NAME = "QueryJointForceTorques"
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointForceTorqueSensor"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportJointForceTorques]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x05&': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2605)


class QueryManipulatorSpecifications(manipulator_v1_0_manipulator_actuator_force_torque_driver.QueryManipulatorSpecifications):
    """QueryManipulatorSpecifications (0x2600): Asks for geometry and limits of the manipulator."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointForceTorqueSensor"
    VERSION = "1.0"
    REPORT: ClassVar[type[ReportManipulatorSpecifications]]


@dataclass(slots=True, repr=False)
class ReportJointForceTorques(rt.Message):
    """ReportJointForceTorques (0x4605): Tells the force or torque of each joint.

    actuator_force_torque_list: 0..255 items. The joints, from the base
    """

    CODE = 0x4605
    NAME = "ReportJointForceTorques"
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointForceTorqueSensor"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    ActuatorForceTorqueRec = manipulator_v1_0_types.ActuatorForceTorqueRec

    actuator_force_torque_list: list[manipulator_v1_0_types.ActuatorForceTorqueRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("ActuatorForceTorqueList", rt.Repeat(rt.Count("B", 0, 255), manipulator_v1_0_types.ActuatorForceTorqueRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x05 or data[1] != 0x46: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        actuator_force_torque_list_count_ = data[2]
        if actuator_force_torque_list_count_ * 5 > size - 3: raise rt.Reject
        at = 3
        actuator_force_torque_list_ = []
        for _ in range(actuator_force_torque_list_count_):
            item_ = rt.new(manipulator_v1_0_types.ActuatorForceTorqueRec)
            item_.joint_force_torque, at = manipulator_v1_0_types.ActuatorForceTorqueRec.JointForceTorque._read(data, at, nesting)
            actuator_force_torque_list_.append(item_)
        self.actuator_force_torque_list = actuator_force_torque_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x05\x46")
        actuator_force_torque_list_ = self.actuator_force_torque_list
        if type(actuator_force_torque_list_) is not list: raise rt.Reject
        out.append(len(actuator_force_torque_list_))
        for item_ in actuator_force_torque_list_:
            if type(item_) is not manipulator_v1_0_types.ActuatorForceTorqueRec: raise rt.Reject
            joint_force_torque_ = item_.joint_force_torque
            if type(joint_force_torque_) is not manipulator_v1_0_types.ActuatorForceTorqueRec.JointForceTorque: raise rt.Reject
            joint_force_torque_._write(out)
        return bytes(out)


class ReportManipulatorSpecifications(manipulator_v1_0_manipulator_actuator_force_torque_driver.ReportManipulatorSpecifications):
    """ReportManipulatorSpecifications (0x4600): Tells geometry and limits of the manipulator."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointForceTorqueSensor"
    VERSION = "1.0"


_S_H = rt.Packer("<H")
QueryJointForceTorques.REPORT = ReportJointForceTorques
QueryManipulatorSpecifications.REPORT = ReportManipulatorSpecifications
