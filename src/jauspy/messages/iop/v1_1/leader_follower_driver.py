"""urn:jaus:jss:iop:LeaderFollowerDriver 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:iop:LeaderFollowerDriver", "1.1")


@jd.message(_SERVICE, 0xFFF4)
class ReportFollowerConfiguration(jd.Message):
    """ReportFollowerConfiguration (0xFFF4): Tells the state and settings of the follower."""

    class State(IntEnum):
        STOP = 0
        START = 1

    @jd.record()
    class FollowerStateRec(jd.Struct):
        """state: State. Whether it is following"""
        state: ReportFollowerConfiguration.State | int = jd.field("State", lambda: jd.Number("B", jd.Values(ReportFollowerConfiguration.State)))

    @jd.bit_field("I")
    class Leader_ID(jd.Struct):
        """Address of the leader's Global Pose Sensor; left out = the service knows its leader by itself.

        component_id: bits 0..7. Component ID.
        node_id: bits 8..15. Node ID.
        subsystem_id: bits 16..31. Subsystem ID.
        """
        component_id: int = jd.bits(0, 0xFF, jd.Values(None, ((1, 254),)))
        node_id: int = jd.bits(8, 0xFF, jd.Values(None, ((1, 254),)))
        subsystem_id: int = jd.bits(16, 0xFFFF, jd.Values(None, ((1, 65534),)))

    @jd.bit_field("B")
    class ErrorBehavior(jd.Struct):
        """What the follower may do to the leader, besides stopping itself, when it leaves its bounds.

        stop_leader: bit 0. May also stop the leader when a bound is passed.
        allow_leader_override: bit 1. May change the leader's speed before a bound is passed.
        """
        stop_leader: int = jd.bits(0, 0x1, jd.Values(None, ((0, 1),)))
        allow_leader_override: int = jd.bits(1, 0x1, jd.Values(None, ((0, 1),)))
        reserved_bits: int = 0

    class VerticalOffsetType(IntEnum):
        DEPTH_MSL = 0
        DEPTH_AGL = 1
        DEPTH_ASF = 2
        RELATIVE_DEPTH = 3

    @jd.record("H")
    class FollowerConfigurationRec(jd.Struct):
        """leader_id: optional. Address of the leader's Global Pose Sensor; left out = the service knows its leader by itself
        error_behavior: optional. What the follower may do to the leader, besides stopping itself, when it leaves its bounds
        lag_time: 0..3600 second, optional. Time to stay behind the leader
        minimum_follow_distance: 0..100000 meter, optional. Least safe distance to the leader, along the path
        maximum_follower_distance: 0..100000 meter, optional. Greatest safe distance to the leader, along the path
        lateral_offset: -100000..100000 meter, optional. Distance to the side of the leader's path, measured level with the ground
        max_lateral_error: 0..100000 meter, optional. Bound of the error of LateralOffset; left out = no bound
        vertical_offset: -100000..100000 meter, optional. Height off the leader's path, or a height or depth as VerticalOffsetType says
        max_vertical_error: 0..100000 meter, optional. Bound of the error of VerticalOffset; left out = no bound
        vertical_offset_type: VerticalOffsetType, optional. What VerticalOffset is measured from
        roll: -3.14159265359..3.14159265359 radian, optional. Roll to keep
        max_roll_error: 0..6.28318530718 radian, optional. Bound of the error of Roll; left out = no bound
        pitch: -3.14159265359..3.14159265359 radian, optional. Pitch to keep
        max_pitch_error: 0..6.28318530718 radian, optional. Bound of the error of Pitch; left out = no bound
        heading: -3.14159265359..3.14159265359 radian, optional. Heading to keep
        max_heading_error: 0..6.28318530718 radian, optional. Bound of the error of Heading; left out = no bound
        """
        leader_id: ReportFollowerConfiguration.Leader_ID | None = jd.field("Leader_ID", lambda: ReportFollowerConfiguration.Leader_ID.layout(), default=None)
        error_behavior: ReportFollowerConfiguration.ErrorBehavior | None = jd.field("ErrorBehavior", lambda: ReportFollowerConfiguration.ErrorBehavior.layout(), default=None)
        lag_time: float | None = jd.field("LagTime", jd.real("I", 0.0, 3600.0, "second"), default=None)
        minimum_follow_distance: float | None = jd.field("MinimumFollowDistance", jd.real("I", 0.0, 100000.0, "meter"), default=None)
        maximum_follower_distance: float | None = jd.field("MaximumFollowerDistance", jd.real("I", 0.0, 100000.0, "meter"), default=None)
        lateral_offset: float | None = jd.field("LateralOffset", jd.real("I", -100000.0, 100000.0, "meter"), default=None)
        max_lateral_error: float | None = jd.field("MaxLateralError", jd.real("I", 0.0, 100000.0, "meter"), default=None)
        vertical_offset: float | None = jd.field("VerticalOffset", jd.real("I", -100000.0, 100000.0, "meter"), default=None)
        max_vertical_error: float | None = jd.field("MaxVerticalError", jd.real("I", 0.0, 100000.0, "meter"), default=None)
        vertical_offset_type: ReportFollowerConfiguration.VerticalOffsetType | int | None = jd.field("VerticalOffsetType", lambda: jd.Number("B", jd.Values(ReportFollowerConfiguration.VerticalOffsetType)), default=None)
        roll: float | None = jd.field("Roll", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
        max_roll_error: float | None = jd.field("Max_Roll_Error", jd.real("H", 0.0, 6.283185307179586, "radian"), default=None)
        pitch: float | None = jd.field("Pitch", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
        max_pitch_error: float | None = jd.field("Max_Pitch_Error", jd.real("H", 0.0, 6.283185307179586, "radian"), default=None)
        heading: float | None = jd.field("Heading", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
        max_heading_error: float | None = jd.field("Max_Heading_Error", jd.real("H", 0.0, 6.283185307179586, "radian"), default=None)

    follower_state_rec: ReportFollowerConfiguration.FollowerStateRec = jd.field("FollowerStateRec", lambda: ReportFollowerConfiguration.FollowerStateRec.layout())
    follower_configuration_rec: ReportFollowerConfiguration.FollowerConfigurationRec = jd.field("FollowerConfigurationRec", lambda: ReportFollowerConfiguration.FollowerConfigurationRec.layout())


@jd.message(_SERVICE, 0xFFF3, query=True)
class QueryFollowerConfiguration(jd.Message):
    """QueryFollowerConfiguration (0xFFF3): Asks for the state and settings of the follower."""
    REPORT = ReportFollowerConfiguration


@jd.message(_SERVICE, 0xFFF2, presence="H", command=True)
class SetFollowerConfiguration(jd.Message):
    """SetFollowerConfiguration (0xFFF2): Sets whom to follow and how; an offset left out stays as it is at START, one the vehicle cannot keep is ignored.

    leader_id: optional. Address of the leader's Global Pose Sensor; left out = the service knows its leader by itself
    error_behavior: optional. What the follower may do to the leader, besides stopping itself, when it leaves its bounds
    lag_time: 0..3600 second, optional. Time to stay behind the leader
    minimum_follow_distance: 0..100000 meter, optional. Least safe distance to the leader, along the path
    maximum_follow_distance: 0..100000 meter, optional. Greatest safe distance to the leader, along the path
    lateral_offset: -100000..100000 meter, optional. Distance to the side of the leader's path, measured level with the ground
    max_lateral_error: 0..100000 meter, optional. Bound of the error of LateralOffset; left out = no bound
    vertical_offset: -100000..100000 meter, optional. Height off the leader's path, or a height or depth as VerticalOffsetType says
    max_vertical_error: 0..100000 meter, optional. Bound of the error of VerticalOffset; left out = no bound
    vertical_offset_type: VerticalOffsetType, optional. What VerticalOffset is measured from
    roll: -3.14159265359..3.14159265359 radian, optional. Roll to keep
    max_roll_error: 0..6.28318530718 radian, optional. Bound of the error of Roll; left out = no bound
    pitch: -3.14159265359..3.14159265359 radian, optional. Pitch to keep
    max_pitch_error: 0..6.28318530718 radian, optional. Bound of the error of Pitch; left out = no bound
    heading: -3.14159265359..3.14159265359 radian, optional. Heading to keep
    max_heading_error: 0..6.28318530718 radian, optional. Bound of the error of Heading; left out = no bound
    """

    @jd.bit_field("I")
    class Leader_ID(jd.Struct):
        """Address of the leader's Global Pose Sensor; left out = the service knows its leader by itself.

        component_id: bits 0..7. Component ID.
        node_id: bits 8..15. Node ID.
        subsystem_id: bits 16..31. Subsystem ID.
        """
        component_id: int = jd.bits(0, 0xFF, jd.Values(None, ((1, 254),)))
        node_id: int = jd.bits(8, 0xFF, jd.Values(None, ((1, 254),)))
        subsystem_id: int = jd.bits(16, 0xFFFF, jd.Values(None, ((1, 65534),)))

    @jd.bit_field("B")
    class ErrorBehavior(jd.Struct):
        """What the follower may do to the leader, besides stopping itself, when it leaves its bounds.

        stop_leader: bit 0. May also stop the leader when a bound is passed.
        allow_leader_override: bit 1. May change the leader's speed before a bound is passed.
        """
        stop_leader: int = jd.bits(0, 0x1, jd.Values(None, ((0, 1),)))
        allow_leader_override: int = jd.bits(1, 0x1, jd.Values(None, ((0, 1),)))
        reserved_bits: int = 0

    class VerticalOffsetType(IntEnum):
        DEPTH_MSL = 0
        DEPTH_AGL = 1
        DEPTH_ASF = 2
        RELATIVE_DEPTH = 3

    leader_id: SetFollowerConfiguration.Leader_ID | None = jd.field("Leader_ID", lambda: SetFollowerConfiguration.Leader_ID.layout(), default=None)
    error_behavior: SetFollowerConfiguration.ErrorBehavior | None = jd.field("ErrorBehavior", lambda: SetFollowerConfiguration.ErrorBehavior.layout(), default=None)
    lag_time: float | None = jd.field("LagTime", jd.real("I", 0.0, 3600.0, "second"), default=None)
    minimum_follow_distance: float | None = jd.field("MinimumFollowDistance", jd.real("I", 0.0, 100000.0, "meter"), default=None)
    maximum_follow_distance: float | None = jd.field("MaximumFollowDistance", jd.real("I", 0.0, 100000.0, "meter"), default=None)
    lateral_offset: float | None = jd.field("LateralOffset", jd.real("I", -100000.0, 100000.0, "meter"), default=None)
    max_lateral_error: float | None = jd.field("MaxLateralError", jd.real("I", 0.0, 100000.0, "meter"), default=None)
    vertical_offset: float | None = jd.field("VerticalOffset", jd.real("I", -100000.0, 100000.0, "meter"), default=None)
    max_vertical_error: float | None = jd.field("MaxVerticalError", jd.real("I", 0.0, 100000.0, "meter"), default=None)
    vertical_offset_type: SetFollowerConfiguration.VerticalOffsetType | int | None = jd.field("VerticalOffsetType", lambda: jd.Number("B", jd.Values(SetFollowerConfiguration.VerticalOffsetType)), default=None)
    roll: float | None = jd.field("Roll", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    max_roll_error: float | None = jd.field("Max_Roll_Error", jd.real("H", 0.0, 6.283185307179586, "radian"), default=None)
    pitch: float | None = jd.field("Pitch", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    max_pitch_error: float | None = jd.field("Max_Pitch_Error", jd.real("H", 0.0, 6.283185307179586, "radian"), default=None)
    heading: float | None = jd.field("Heading", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    max_heading_error: float | None = jd.field("Max_Heading_Error", jd.real("H", 0.0, 6.283185307179586, "radian"), default=None)


@jd.message(_SERVICE, 0xFFF1, command=True)
class SetFollowerState(jd.Message):
    """SetFollowerState (0xFFF1): Starts or ends following.

    state: State. Whether to follow
    """

    class State(IntEnum):
        STOP = 0
        START = 1

    state: SetFollowerState.State | int = jd.field("State", lambda: jd.Number("B", jd.Values(SetFollowerState.State)))
