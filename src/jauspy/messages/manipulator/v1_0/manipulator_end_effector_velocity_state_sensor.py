"""urn:jaus:jss:manipulator:ManipulatorEndEffectorVelocityStateSensor 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.manipulator.v1_0 import manipulator_actuator_force_torque_driver as manipulator_v1_0_manipulator_actuator_force_torque_driver
from jauspy.messages.manipulator.v1_0 import manipulator_end_effector_pose_driver as manipulator_v1_0_manipulator_end_effector_pose_driver


class QueryManipulatorSpecifications(manipulator_v1_0_manipulator_actuator_force_torque_driver.QueryManipulatorSpecifications):
    """QueryManipulatorSpecifications (0x2600): Asks for geometry and limits of the manipulator."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorVelocityStateSensor"
    VERSION = "1.0"
    REPORT: ClassVar[type[ReportManipulatorSpecifications]]


class QueryToolOffset(manipulator_v1_0_manipulator_end_effector_pose_driver.QueryToolOffset):
    """QueryToolOffset (0x2604): Asks where the tool point is."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorVelocityStateSensor"
    VERSION = "1.0"
    REPORT: ClassVar[type[ReportToolOffset]]


class SetToolOffset(manipulator_v1_0_manipulator_end_effector_pose_driver.SetToolOffset):
    """SetToolOffset (0x0604): Sets where the tool point is."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorVelocityStateSensor"
    VERSION = "1.0"


@dataclass(slots=True, repr=False)
class QueryEndEffectorVelocityState(rt.Message):
    """QueryEndEffectorVelocityState (0x2616): Asks for the velocity of the tool point."""

    CODE = 0x2616
    NAME = "QueryEndEffectorVelocityState"
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorVelocityStateSensor"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportEndEffectorVelocityState]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x16&': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2616)


class ReportManipulatorSpecifications(manipulator_v1_0_manipulator_actuator_force_torque_driver.ReportManipulatorSpecifications):
    """ReportManipulatorSpecifications (0x4600): Tells geometry and limits of the manipulator."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorVelocityStateSensor"
    VERSION = "1.0"


class ReportToolOffset(manipulator_v1_0_manipulator_end_effector_pose_driver.ReportToolOffset):
    """ReportToolOffset (0x4604): Tells where the tool point is."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorVelocityStateSensor"
    VERSION = "1.0"


@dataclass(slots=True, repr=False)
class ReportEndEffectorVelocityState(rt.Message):
    """ReportEndEffectorVelocityState (0x4616): Tells the velocity of the tool point.

    angular_velocity_component_x: -62.8318530718..62.8318530718 radian per second. Angular velocity about X, in radians per second
    angular_velocity_component_y: -62.8318530718..62.8318530718 radian per second. Angular velocity about Y, in radians per second
    angular_velocity_component_z: -62.8318530718..62.8318530718 radian per second. Angular velocity about Z, in radians per second
    linear_velocity_component_x: -10..10 meter per second. Velocity along X, in metres per second
    linear_velocity_component_y: -10..10 meter per second. Velocity along Y, in metres per second
    linear_velocity_component_z: -10..10 meter per second. Velocity along Z, in metres per second
    """

    CODE = 0x4616
    NAME = "ReportEndEffectorVelocityState"
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorVelocityStateSensor"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    angular_velocity_component_x: float
    angular_velocity_component_y: float
    angular_velocity_component_z: float
    linear_velocity_component_x: float
    linear_velocity_component_y: float
    linear_velocity_component_z: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("AngularVelocityComponentX", rt.real("I", -62.83185307179586, 62.83185307179586, "radian per second")),
            ("AngularVelocityComponentY", rt.real("I", -62.83185307179586, 62.83185307179586, "radian per second")),
            ("AngularVelocityComponentZ", rt.real("I", -62.83185307179586, 62.83185307179586, "radian per second")),
            ("LinearVelocityComponentX", rt.real("I", -10.0, 10.0, "meter per second")),
            ("LinearVelocityComponentY", rt.real("I", -10.0, 10.0, "meter per second")),
            ("LinearVelocityComponentZ", rt.real("I", -10.0, 10.0, "meter per second")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, angular_velocity_component_x_, angular_velocity_component_y_, angular_velocity_component_z_, linear_velocity_component_x_, linear_velocity_component_y_, linear_velocity_component_z_ = _S_H6I.unpack(data)
        if code != 0x4616: raise rt.Reject
        self.angular_velocity_component_x = -62.83185307179586 + angular_velocity_component_x_ * 2.9258361592155435e-08
        self.angular_velocity_component_y = -62.83185307179586 + angular_velocity_component_y_ * 2.9258361592155435e-08
        self.angular_velocity_component_z = -62.83185307179586 + angular_velocity_component_z_ * 2.9258361592155435e-08
        self.linear_velocity_component_x = -10.0 + linear_velocity_component_x_ * 4.656612874161595e-09
        self.linear_velocity_component_y = -10.0 + linear_velocity_component_y_ * 4.656612874161595e-09
        self.linear_velocity_component_z = -10.0 + linear_velocity_component_z_ * 4.656612874161595e-09
        return self

    def _pack(self) -> bytes:
        angular_velocity_component_x_ = self.angular_velocity_component_x
        if not -62.83185307179586 <= angular_velocity_component_x_ <= 62.83185307179586: raise rt.Reject
        near = angular_velocity_component_x_ * 34178263.77086383 + 2147483647.9999998
        angular_velocity_component_x_raw_ = int(near)
        if not 1.52587890625e-05 < near - angular_velocity_component_x_raw_ < 0.9999847412109375: angular_velocity_component_x_raw_ = rt.exact_raw(angular_velocity_component_x_, _R_2)
        angular_velocity_component_y_ = self.angular_velocity_component_y
        if not -62.83185307179586 <= angular_velocity_component_y_ <= 62.83185307179586: raise rt.Reject
        near = angular_velocity_component_y_ * 34178263.77086383 + 2147483647.9999998
        angular_velocity_component_y_raw_ = int(near)
        if not 1.52587890625e-05 < near - angular_velocity_component_y_raw_ < 0.9999847412109375: angular_velocity_component_y_raw_ = rt.exact_raw(angular_velocity_component_y_, _R_2)
        angular_velocity_component_z_ = self.angular_velocity_component_z
        if not -62.83185307179586 <= angular_velocity_component_z_ <= 62.83185307179586: raise rt.Reject
        near = angular_velocity_component_z_ * 34178263.77086383 + 2147483647.9999998
        angular_velocity_component_z_raw_ = int(near)
        if not 1.52587890625e-05 < near - angular_velocity_component_z_raw_ < 0.9999847412109375: angular_velocity_component_z_raw_ = rt.exact_raw(angular_velocity_component_z_, _R_2)
        linear_velocity_component_x_ = self.linear_velocity_component_x
        if not -10.0 <= linear_velocity_component_x_ <= 10.0: raise rt.Reject
        near = linear_velocity_component_x_ * 214748364.75 + 2147483648.0
        linear_velocity_component_x_raw_ = int(near)
        if not 1.52587890625e-05 < near - linear_velocity_component_x_raw_ < 0.9999847412109375: linear_velocity_component_x_raw_ = rt.exact_raw(linear_velocity_component_x_, _R_3)
        linear_velocity_component_y_ = self.linear_velocity_component_y
        if not -10.0 <= linear_velocity_component_y_ <= 10.0: raise rt.Reject
        near = linear_velocity_component_y_ * 214748364.75 + 2147483648.0
        linear_velocity_component_y_raw_ = int(near)
        if not 1.52587890625e-05 < near - linear_velocity_component_y_raw_ < 0.9999847412109375: linear_velocity_component_y_raw_ = rt.exact_raw(linear_velocity_component_y_, _R_3)
        linear_velocity_component_z_ = self.linear_velocity_component_z
        if not -10.0 <= linear_velocity_component_z_ <= 10.0: raise rt.Reject
        near = linear_velocity_component_z_ * 214748364.75 + 2147483648.0
        linear_velocity_component_z_raw_ = int(near)
        if not 1.52587890625e-05 < near - linear_velocity_component_z_raw_ < 0.9999847412109375: linear_velocity_component_z_raw_ = rt.exact_raw(linear_velocity_component_z_, _R_3)
        return _S_H6I.pack(0x4616, angular_velocity_component_x_raw_, angular_velocity_component_y_raw_, angular_velocity_component_z_raw_, linear_velocity_component_x_raw_, linear_velocity_component_y_raw_, linear_velocity_component_z_raw_)


_S_H = rt.Packer("<H")
_S_H6I = rt.Packer("<H6I")
_R_2 = rt.Scaling(-62.83185307179586, 62.83185307179586, 4294967295)
_R_3 = rt.Scaling(-10.0, 10.0, 4294967295)
QueryManipulatorSpecifications.REPORT = ReportManipulatorSpecifications
QueryToolOffset.REPORT = ReportToolOffset
QueryEndEffectorVelocityState.REPORT = ReportEndEffectorVelocityState
