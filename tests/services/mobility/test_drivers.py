"""The driver services over a fake chassis: who may command, which fields are reported, what is refused."""

from __future__ import annotations

import math

import pytest

from jauspy.errors import ConfigError
from jauspy.geometry.poses import Acceleration, Pose, Twist
from jauspy.messages.core import (
    ConfirmElementRequest,
    ElementRec,
    RejectElementRequest,
    ReleaseControl,
    RequestControl,
    Resume,
    SetElement,
)
from jauspy.messages.mobility import (
    ExecuteList,
    GlobalZPosition,
    QueryAccelerationLimit,
    QueryAccelerationState,
    QueryAccelerationStateExt,
    QueryActiveElement,
    QueryGeomagneticProperty,
    QueryGlobalPose,
    QueryGlobalPoseExt,
    QueryGlobalVector,
    QueryGlobalVectorExt,
    QueryGlobalWaypoint,
    QueryGlobalWaypointExt,
    QueryLocalPose,
    QueryLocalPoseExt,
    QueryLocalVector,
    QueryLocalVectorExt,
    QueryLocalWaypoint,
    QueryLocalWaypointExt,
    QueryTravelSpeed,
    QueryVelocityCommand,
    QueryVelocityCommandExt,
    SetAccelerationLimit,
    SetGeomagneticProperty,
    SetGlobalPose,
    SetGlobalVectorExt,
    SetGlobalWaypoint,
    SetGlobalWaypointExt,
    SetLocalPose,
    SetLocalPoseExt,
    SetLocalVector,
    SetLocalVectorExt,
    SetLocalWaypoint,
    SetLocalWaypointExt,
    SetTravelSpeed,
    SetVelocityCommand,
    SetVelocityCommandExt,
    SetWrenchEffort,
    Speed,
    ZPosition,
)
from jauspy.messages.ugv import (
    QueryPlatformSpecifications,
    QuerySkidSteerEffort,
    ReportPlatformSpecifications,
    SetSkidSteerEffort,
)
from jauspy.services.mobility import (
    AccelerationStateSensor,
    GlobalPose,
    GlobalPoseSensor,
    GlobalVectorDriver,
    GlobalWaypointDriver,
    GlobalWaypointListDriver,
    LocalPoseSensor,
    LocalVectorDriver,
    LocalWaypointDriver,
    LocalWaypointListDriver,
    PrimitiveDriver,
    Vehicle,
    VelocityStateDriver,
    waypoint_drivers,
)
from jauspy.services.mobility.courses import WaypointCourse
from jauspy.services.ugv import PlatformSpecifications, SkidSteerDriver

A, B = "42.1.1", "42.2.1"
ALL = 0xFF
KINDS = (
    PrimitiveDriver,
    VelocityStateDriver,
    LocalVectorDriver,
    GlobalVectorDriver,
    LocalWaypointDriver,
    GlobalWaypointDriver,
    LocalWaypointListDriver,
    GlobalWaypointListDriver,
    SkidSteerDriver,
    PlatformSpecifications,
    LocalPoseSensor,
    GlobalPoseSensor,
    AccelerationStateSensor,
)
CURRENT, MAX, MIN, DEFAULT = SetVelocityCommand.CommandType
OVER_GROUND, OF_MEDIUM, REVOLUTIONS, INDICATED = Speed.Choice
HERE = GlobalPose(60.0, 25.0, 10.0, 0.0)


@pytest.fixture
def rig(make, drive):
    """A component with all drivers."""
    vehicle = Vehicle(drive, name="test", origin=HERE)
    return make(*(kind(vehicle) for kind in KINDS))


@pytest.fixture
def ready(rig):
    """Client A is in control and has resumed it."""
    for message in (RequestControl(100), Resume()):
        rig.tell(A, message)
    return rig


def near(value, by=1e-3):
    return pytest.approx(value, abs=by)


COMMANDS = [
    SetSkidSteerEffort(50.0, 50.0),
    SetWrenchEffort(propulsive_linear_effort_x=50.0),
    SetVelocityCommand(command_type=CURRENT, velocity_x=0.5),
    SetVelocityCommandExt(command_type=SetVelocityCommandExt.CommandType.SET_COMMAND_SRM, velocity_x=0.5),
    SetLocalVector(speed=0.5, heading=0.0),
    SetLocalVectorExt(speed=Speed(OF_MEDIUM, 0.5)),
    SetGlobalVectorExt(speed=Speed(OVER_GROUND, 0.5), heading=0.0),
]


def kind_of(message) -> str:
    return type(message).__name__


@pytest.mark.parametrize("command", COMMANDS, ids=kind_of)
@pytest.mark.parametrize(
    "before",
    [
        [],
        [(A, RequestControl(100))],
        [(B, RequestControl(100)), (B, Resume())],
        [(A, RequestControl(100)), (A, Resume()), (A, ReleaseControl())],
    ],
    ids=["no control", "standby", "another's", "released"],
)
def test_commands_need_control_and_ready(rig, drive, before, command) -> None:
    for client, message in before:
        rig.tell(client, message)
    rig.tell(A, command)
    rig.run(1.0)
    assert all(effort == (0.0, 0.0) for effort in drive.efforts)


@pytest.mark.parametrize("command", COMMANDS, ids=kind_of)
def test_commands_in_ready_move_the_robot(ready, drive, command) -> None:
    ready.tell(A, command)
    ready.run(1.0)
    assert drive.effort[0] > 0.1
    ready.tell(A, ReleaseControl())
    assert drive.effort == (0.0, 0.0)
    ready.run(1.0)
    assert drive.effort == (0.0, 0.0)


# --- efforts by side


def test_efforts_by_side(ready, drive) -> None:
    ready.tell(A, SetSkidSteerEffort(left_side_propulsive_effort=60.0, right_side_propulsive_effort=20.0))
    assert drive.effort == (near(0.4), near(-0.2)), "the left side is faster, so it turns right"
    report = ready.ask(A, QuerySkidSteerEffort())
    assert (report.left_side_propulsive_effort, report.right_side_propulsive_effort) == (near(60, 2e-3), near(20, 2e-3))
    ready.tell(A, SetWrenchEffort(propulsive_linear_effort_x=10.0))
    report = ready.ask(A, QuerySkidSteerEffort())
    assert (report.left_side_propulsive_effort, report.right_side_propulsive_effort) == (near(0, 2e-3), near(0, 2e-3))


def test_platform_specifications(rig) -> None:
    report = rig.ask(B, QueryPlatformSpecifications())
    assert isinstance(report.platform_specifics, ReportPlatformSpecifications.Skidsteer)
    assert report.platform_specifics.track_separation == near(0.46)
    assert report.platform_inertial.maximum_forward_speed == near(1.5)
    assert report.platform_inertial.maximum_forward_deceleration == near(1.5, 0.1)
    spec = report.platform_spec
    assert (spec.mobility_platform_name, spec.vehicle_weight) == ("test", near(50.3))
    assert (spec.front, spec.right, spec.zcg) == (near(0.345), near(0.28), near(-0.16))
    assert spec.static_roll_over == near(math.atan2(0.23, 0.16))
    assert spec.approach_angle is None


# --- velocities


def test_velocity_commands_by_kind(ready) -> None:
    ready.tell(A, SetVelocityCommand(command_type=MAX, velocity_x=0.8))
    ready.tell(A, SetVelocityCommand(command_type=MIN, velocity_x=-0.2, yaw_rate=-99.0 / 9))
    ready.tell(A, SetVelocityCommand(command_type=DEFAULT, velocity_x=0.1, velocity_y=3.0))
    ready.tell(A, SetVelocityCommand(command_type=CURRENT, velocity_x=0.7, yaw_rate=0.3))
    wanted = {CURRENT: (0.7, 0.3), MAX: (0.8, 1.2), MIN: (-0.2, -1.2), DEFAULT: (0.1, 0.0)}
    for kind, (speed, rate) in wanted.items():
        report = ready.ask(B, QueryVelocityCommand(ALL, kind))
        assert (report.command_type, report.velocity_x, report.yaw_rate) == (kind, near(speed), near(rate))
        assert (report.velocity_y, report.velocity_z, report.roll_rate, report.pitch_rate) == (None,) * 4
    masked = ready.ask(B, QueryVelocityCommand(0b100000, CURRENT))
    assert (masked.velocity_x, masked.yaw_rate) == (None, near(0.3))
    wide = ready.ask(B, QueryVelocityCommandExt(ALL, SetVelocityCommandExt.CommandType.SET_MAX_SRM))
    assert (wide.command_type, wide.velocity_x) == (5, near(0.8))


@pytest.mark.parametrize("speed", [0.9, -0.3, 200.0])
def test_a_velocity_outside_of_the_limits_is_ignored(ready, speed) -> None:
    ready.tell(A, SetVelocityCommand(command_type=MAX, velocity_x=0.8))
    ready.tell(A, SetVelocityCommand(command_type=MIN, velocity_x=-0.2))
    ready.tell(A, SetVelocityCommand(command_type=CURRENT, velocity_x=0.4))
    ready.tell(A, SetVelocityCommand(command_type=CURRENT, velocity_x=speed))
    assert ready.ask(B, QueryVelocityCommand(ALL, CURRENT)).velocity_x == near(0.4)
    assert ready.host.counters["velocity_out_of_range"] == 1


@pytest.mark.parametrize("sign", [-1.0, 1.0])
def test_the_reported_limit_may_be_commanded(ready, drive, sign) -> None:
    limit = ready.ask(B, QueryVelocityCommand(ALL, MAX if sign > 0 else MIN))
    ready.tell(A, SetVelocityCommand(command_type=CURRENT, velocity_x=limit.velocity_x, yaw_rate=limit.yaw_rate))
    ready.run(1.0)
    assert drive.effort[0] * sign > 0.3
    assert drive.effort[1] * sign < -0.3
    assert ready.host.counters["velocity_out_of_range"] == 0


def test_limits_can_be_set_in_standby_by_the_controller_only(rig) -> None:
    rig.tell(A, SetVelocityCommand(command_type=MAX, velocity_x=0.8))
    assert rig.ask(B, QueryVelocityCommand(ALL, MAX)).velocity_x == near(1.5)
    rig.tell(A, RequestControl(100))
    rig.tell(B, SetVelocityCommand(command_type=MAX, velocity_x=0.3))
    rig.tell(A, SetVelocityCommand(command_type=MAX, velocity_x=0.8))
    assert rig.ask(B, QueryVelocityCommand(ALL, MAX)).velocity_x == near(0.8)


def test_acceleration_limits(ready) -> None:
    up, down = SetAccelerationLimit.CommandType
    ready.tell(A, SetAccelerationLimit(command_type=up, acceleration_x=0.5))
    ready.tell(A, SetAccelerationLimit(command_type=down, yaw_acceleration=900.0))
    report = ready.ask(B, QueryAccelerationLimit(ALL, up))
    assert (report.command_type, report.acceleration_x, report.yaw_acceleration) == (up, near(0.5), near(3.0))
    report = ready.ask(B, QueryAccelerationLimit(0b100000, down))
    assert (report.acceleration_x, report.yaw_acceleration) == (None, near(3.0)), "no faster than the chassis can"


def test_acceleration_in_jaus_axes(rig, drive) -> None:
    drive.present_acceleration = Acceleration(1.0, 2.0, 3.0, 0.1, 0.2, 0.3)
    report = rig.ask(B, QueryAccelerationState(0xFFFF))
    assert (report.acceleration_x, report.acceleration_y, report.acceleration_z) == (near(1), near(-2), near(-3))
    assert (report.roll_acceleration, report.pitch_acceleration, report.yaw_acceleration) == (
        near(0.1),
        near(-0.2),
        near(-0.3),
    )
    assert report.acceleration_rms is None
    masked = rig.ask(B, QueryAccelerationStateExt(0b10))
    assert (masked.acceleration_x, masked.acceleration_y, masked.time_seconds) == (None, near(-2), None)


# --- vectors


def test_vector_is_reported_as_set(ready) -> None:
    assert ready.ask(B, QueryLocalVector(ALL)).speed == 0.0
    ready.tell(A, SetLocalVector(speed=0.5, z=2.0, heading=1.0, roll=0.1, pitch=0.2))
    report = ready.ask(B, QueryLocalVector(ALL))
    assert (report.speed, report.z, report.heading, report.roll, report.pitch) == (
        near(0.5, 0.01),
        near(2),
        near(1),
        near(0.1),
        near(0.2),
    )
    masked = ready.ask(B, QueryLocalVector(0b10))
    assert (masked.z, masked.heading, masked.roll) == (None, near(1), None)
    wide = ready.ask(B, QueryLocalVectorExt(ALL))
    assert (wide.z_position.choice, wide.heading, wide.course) == (ZPosition.Choice.Z_LOCAL, near(1), None)


def test_a_wide_vector_keeps_its_datum(ready) -> None:
    depth = GlobalZPosition(GlobalZPosition.Choice.DEPTH, 3.0)
    ready.tell(A, SetGlobalVectorExt(speed=Speed(OVER_GROUND, -0.4), z_position=depth, course=0.5))
    wide = ready.ask(B, QueryGlobalVectorExt(ALL))
    assert (wide.speed.value, wide.z_position.value, wide.heading, wide.course) == (
        near(-0.4, 0.01),
        near(3),
        near(0.5),
        near(0.5),
    )
    narrow = ready.ask(B, QueryGlobalVector(ALL))
    assert (narrow.speed, narrow.altitude) == (near(0.4, 0.01), None)


@pytest.mark.parametrize("kind", [REVOLUTIONS, INDICATED])
def test_speeds_that_are_not_over_ground_are_counted_and_ignored(ready, drive, kind) -> None:
    ready.tell(A, SetLocalVectorExt(speed=Speed(kind, 5.0), heading=0.0))
    ready.run(0.5)
    assert drive.effort == (0.0, 0.0)
    assert ready.host.counters["unsupported_speed"] == 1


# --- waypoints


def test_waypoint_is_reported_as_set(rig) -> None:
    assert rig.tell(B, QueryLocalWaypoint(ALL)) == [], "there is none"
    rig.tell(A, SetLocalWaypoint(x=1.0, y=2.0))
    assert rig.tell(B, QueryLocalWaypoint(ALL)) == [], "only the client in control may set one"
    rig.tell(A, RequestControl(100))
    rig.tell(A, SetLocalWaypoint(1.0, 2.0, 3.0, 0.1, 0.2, 0.3, 0.5, 5.0))
    full = rig.ask(B, QueryLocalWaypoint(ALL))
    assert (full.x, full.y, full.z, full.roll, full.pitch, full.yaw) == tuple(map(near, (1, 2, 3, 0.1, 0.2, 0.3)))
    assert (full.waypoint_tolerance, full.path_tolerance) == (near(0.5), near(5))
    masked = rig.ask(B, QueryLocalWaypoint(0b001001))
    assert (masked.x, masked.z, masked.roll, masked.yaw) == (near(1), near(3), None, near(0.3))
    wide = rig.ask(B, QueryLocalWaypointExt(ALL))
    assert (wide.z_position.choice, wide.z_position.value) == (ZPosition.Choice.Z_LOCAL, near(3))


def test_values_outside_of_narrow_fields_are_omitted(rig) -> None:
    rig.tell(A, RequestControl(100))
    sea = ZPosition(ZPosition.Choice.ALTITUDE_MSL, 50.0)
    rig.tell(A, SetLocalWaypointExt(x=1.0, y=2.0, z_position=sea, heading=0.7, waypoint_tolerance=500.0))
    narrow = rig.ask(B, QueryLocalWaypoint(ALL))
    assert (narrow.z, narrow.yaw, narrow.waypoint_tolerance) == (None, near(0.7), None)
    wide = rig.ask(B, QueryLocalWaypointExt(ALL))
    assert (wide.z_position.value, wide.waypoint_tolerance) == (near(50), near(500))


def test_global_waypoint_is_reported_as_set(rig) -> None:
    rig.tell(A, RequestControl(100))
    rig.tell(A, SetGlobalWaypoint(latitude=60.001, longitude=25.001, altitude=12.0, yaw=0.3))
    full = rig.ask(B, QueryGlobalWaypoint(ALL))
    assert (full.latitude, full.longitude) == (near(60.001, 1e-7), near(25.001, 1e-7))
    assert (full.altitude, full.yaw, full.roll) == (near(12), near(0.3), None)
    assert rig.ask(B, QueryGlobalWaypointExt(ALL)).z_position is None
    assert rig.tell(B, QueryLocalWaypoint(ALL)) == [], "it is no local one"
    rig.tell(A, SetGlobalWaypointExt(60.0, 25.0, GlobalZPosition(GlobalZPosition.Choice.DEPTH, 1.0)))
    assert rig.ask(B, QueryGlobalWaypoint(ALL)).altitude is None
    assert rig.ask(B, QueryGlobalWaypointExt(ALL)).z_position.value == near(1)


def test_a_travel_speed_needs_a_waypoint_and_ready(rig, drive) -> None:
    rig.tell(A, RequestControl(100))
    rig.tell(A, SetLocalWaypoint(x=9.0, y=0.0))
    rig.tell(A, SetTravelSpeed(speed=1.0))
    assert rig.ask(B, QueryTravelSpeed()).speed == 0.0, "still in Standby"
    rig.tell(A, Resume())
    rig.tell(A, SetTravelSpeed(speed=1.0))
    assert rig.ask(B, QueryTravelSpeed()).speed == near(1.0, 0.01)
    rig.run(1.0)
    assert drive.effort[0] > 0.5


def elements(*messages) -> SetElement:
    records = [
        ElementRec(uid, uid - 1, uid + 1 if uid < len(messages) else 0, ElementRec.ElementData(0, message))
        for uid, message in enumerate(messages, 1)
    ]
    return SetElement(SetElement.RequestIDRec(9), records)


def test_legs_begin_at_the_waypoint_that_was_passed_just_before(ready, monkeypatch) -> None:
    """Not at one that was passed before a waypoint of the other frame."""
    starts: list[tuple[float, float] | None] = []

    class Noted(WaypointCourse):
        def __init__(self, *args, start=None, **options) -> None:
            starts.append(None if start is None else (start().x, start().y))
            super().__init__(*args, start=start, **options)

    monkeypatch.setattr(waypoint_drivers, "WaypointCourse", Noted)
    near_here = [SetLocalWaypoint(0.1, 0.0), SetLocalWaypoint(0.0, 0.1), SetGlobalWaypoint(60.0, 25.0)]
    ready.ask(A, elements(*near_here, SetLocalWaypoint(0.2, 0.0)))
    ready.tell(A, ExecuteList(speed=0.5, element_uid=1))
    ready.run(2.0)
    assert starts == [None, near((0.1, 0.0)), None, None]


def test_a_list_takes_waypoints_of_both_frames_and_nothing_else(rig) -> None:
    rig.tell(A, RequestControl(100))
    assert rig.ask(A, elements(SetLocalWaypoint(1.0, 2.0), SetGlobalWaypoint(60.0, 25.0))) == ConfirmElementRequest(9)
    vector = ElementRec(1, 0, 2, ElementRec.ElementData(0, SetLocalVector(1.0)))
    answer = rig.ask(A, SetElement(SetElement.RequestIDRec(9), [vector]))
    assert answer == RejectElementRequest(9, RejectElementRequest.ResponseCode.UNSUPPORTED_ELEMENT_TYPE)
    assert rig.ask(B, QueryLocalWaypoint(ALL)).y == near(2.0), "before anything was driven to: the first"
    assert rig.ask(B, QueryActiveElement()).element_uid == 0


# --- on the globe


def test_global_pose_in_jaus_terms(rig, drive) -> None:
    drive.present_pose = Pose(x=100.0, y=-50.0, z=5.0, roll=0.1, pitch=0.2, yaw=-0.5)
    drive.present_twist = Twist(vx=1.0, vy=1.0)
    report = rig.ask(B, QueryGlobalPose(0xFFFF))
    assert report.latitude == near(60.0 + 100.0 / 111412.0, 2e-7)
    assert report.longitude == near(25.0 + 50.0 / 55800.0, 2e-6)
    assert (report.altitude, report.roll, report.pitch, report.yaw) == (
        near(15, 0.01),
        near(0.1),
        near(-0.2),
        near(0.5),
    )
    assert report.position_rms is None
    assert rig.ask(B, QueryGlobalPose(0)).latitude is None
    wide = rig.ask(B, QueryGlobalPoseExt(0xFFFF))
    assert (wide.heading, wide.course) == (near(0.5), near(0.5 - math.pi / 4))
    assert wide.altitude_msl is None
    drive.present_twist = Twist()
    assert rig.ask(B, QueryGlobalPoseExt(0xFFFF)).course is None


def test_set_global_pose_needs_control_and_keeps_the_local_frame(rig, drive) -> None:
    drive.present_pose = Pose(x=10.0, y=0.0)
    rig.tell(B, SetGlobalPose(latitude=10.0, longitude=20.0))
    assert rig.ask(B, QueryGlobalPose(ALL)).latitude == near(60.0, 1e-3)
    rig.tell(A, RequestControl(100))
    rig.tell(A, SetGlobalPose(latitude=10.0, longitude=179.9999, yaw=math.pi / 2))
    report = rig.ask(B, QueryGlobalPose(0xFFFF))
    assert (report.latitude, report.longitude, report.yaw) == (near(10, 1e-6), near(179.9999, 1e-6), near(math.pi / 2))
    assert report.altitude == near(10.0, 0.01)
    drive.present_pose = Pose(x=110.0, y=0.0)
    east = 100.0 / 109639.0
    assert rig.ask(B, QueryGlobalPose(0xFFFF)).longitude == near(179.9999 + east - 360.0, 1e-5), "over the date line"


def test_geomagnetic_property_is_kept(rig) -> None:
    assert rig.ask(B, QueryGeomagneticProperty()).magnetic_variation == near(0.0)
    rig.tell(A, RequestControl(100))
    rig.tell(A, SetGeomagneticProperty(0.2))
    assert rig.ask(B, QueryGeomagneticProperty()).magnetic_variation == near(0.2)


@pytest.mark.parametrize(
    "kind",
    [GlobalPoseSensor, GlobalVectorDriver, GlobalWaypointDriver, GlobalWaypointListDriver],
    ids=lambda k: k.__name__,
)
def test_global_services_need_an_origin(make, drive, kind) -> None:
    with pytest.raises(ConfigError, match="need an origin"):
        make(kind(Vehicle(drive)))


def test_positions_outside_of_fields_are_omitted(rig) -> None:
    """Clients set by the wider forms what the narrower ones cannot say; that is no bug of the component."""
    rig.tell(A, RequestControl(100))
    rig.tell(A, SetLocalWaypointExt(x=150_000.0, y=2.0))
    assert rig.tell(B, QueryLocalWaypoint(ALL)) == []
    assert rig.ask(B, QueryLocalWaypointExt(ALL)).x == near(150_000.0, 0.01)
    rig.tell(A, SetLocalPoseExt(x=150_000.0, y=2.0))
    narrow = rig.ask(B, QueryLocalPose(0x1FF))
    assert (narrow.x, narrow.y) == (None, near(2.0, 0.01))
    assert rig.ask(B, QueryLocalPoseExt(0xFFFF)).x == near(150_000.0, 0.01)
    rig.tell(A, SetLocalPose(z=100_000.0))
    assert rig.ask(B, QueryLocalPose(0x1FF)).z == near(100_000.0)
    assert rig.ask(B, QueryLocalPoseExt(0xFFFF)).z_local is None
    rig.tell(A, SetLocalWaypoint(x=1.0, y=2.0, z=-100_000.0))
    assert rig.ask(B, QueryLocalWaypoint(ALL)).z == near(-100_000.0)
    assert rig.ask(B, QueryLocalWaypointExt(ALL)).z_position is None
    rig.tell(A, Resume())
    rig.tell(A, SetLocalVectorExt(speed=Speed(OVER_GROUND, -327.68)))
    assert rig.ask(B, QueryLocalVector(ALL)).speed == near(327.67, 0.01)
    deep = ZPosition(ZPosition.Choice.Z_LOCAL, 40_000.0)
    rig.tell(A, SetLocalVectorExt(speed=Speed(OVER_GROUND, 0.0), z_position=deep))
    assert rig.ask(B, QueryLocalVector(ALL)).z is None
    assert rig.ask(B, QueryLocalVectorExt(ALL)).z_position.value == near(40_000.0)
    assert rig.host.counters["unencodable"] == 0


def test_altitude_beyond_the_limit_is_omitted(rig, drive) -> None:
    rig.tell(A, RequestControl(100))
    drive.present_pose = Pose(x=3.3, z=0.1)
    rig.tell(A, SetGlobalPose(latitude=10.0, longitude=20.0, altitude=-10_000.0))
    assert rig.ask(B, QueryGlobalPose(0xFFFF)).altitude == near(-10_000.0)
    drive.present_pose = Pose(x=3.3, z=0.05)
    report = rig.ask(B, QueryGlobalPose(0xFFFF))
    assert (report.altitude, report.latitude) == (None, near(10.0))
