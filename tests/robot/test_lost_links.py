"""What a robot does when the link to its client is lost: the service CommsLostPolicyManager."""

from __future__ import annotations

import math

import pytest
from tests.robot.test_retrotraverse import start, status, velocity
from tests.robot.world import CLIENT, ME, OTHER, World

from jauspy.codec.message import Message
from jauspy.messages.core import (
    ClearEmergency,
    QueryControl,
    QueryHeartbeatPulse,
    ReleaseControl,
    ReportControl,
    RequestControl,
    Resume,
    SetEmergency,
    Standby,
)
from jauspy.messages.iop import (
    QueryCommsLostCapabilities,
    QueryCommsLostConfiguration,
    QueryCommsLostStatus,
    QueryRetrotraverseStatus,
    SetCommsLostPolicy,
    SetCommsLostPolicyResponse,
)
from jauspy.messages.mobility import ExecuteList, SetLocalWaypoint, SetTravelSpeed
from jauspy.messages.mobility.v1_0.types import GlobalWaypointRec
from jauspy.robot.config import ModuleConfig

DISABLED, ENABLED, ACTIVE = range(3)
SUCCESS, NOT_SUPPORTED = range(2)
DO_NOTHING, STOP_MOTION = range(2)
CONTROL = 5
"""Seconds after which a silent client loses control."""
M = SetCommsLostPolicy
STOP, CONTINUE = M.StopMotionVar(0), M.ContinueMissionVar(0)


def back(distance: float, speed: float = 0.0, *, method: int = 0, waypoint: GlobalWaypointRec | None = None):
    action = M.RetrotraverseActionRec(distance, speed, M.Parameters(method, 0), 0.0)
    return M.RetrotraverseParameterSeq(action, waypoint)


def move(waypoint: GlobalWaypointRec, speed: float, distance: float = 0.0):
    return M.MoveToPosSeq(waypoint, M.TravelSpeedRec(speed), M.MaxDistanceRec(distance))


def policy(variant, timeout: int = 8, regained: int = STOP_MOTION, regained_timeout: int = 0, id: int = 7) -> M:
    return M(
        M.PolicyRec(id),
        M.CommsLostSeq(M.CommsLostDetectionRec(timeout), variant),
        M.CommsRegainedSeq(M.CommsRegainedRec(regained_timeout, regained)),
    )


@pytest.fixture
def world() -> World:
    """A robot whose control times out, under control."""
    world = World("kinematic", timeout=CONTROL)
    world.take_control()
    return world


def drive(world: World, seconds: float, forward: float = 0.5, right: float = 0.0) -> None:
    """Drive, renewing control, without a stop at the end."""
    world.tell(velocity(forward, right))
    for _ in range(round(seconds)):
        world.run(1.0)
        world.tell(RequestControl(200))


def holder(world: World) -> ReportControl:
    return world.tell(QueryControl(), client=OTHER)[-1]


def state(world: World) -> int:
    return world.tell(QueryCommsLostStatus(), client=OTHER)[-1].comms_lost_status


def stands(world: World) -> bool:
    twist = world.robot.drive.twist()
    return max(abs(twist.vx), abs(twist.wz)) < 0.03


def x(world: World) -> float:
    return world.vehicle.pose.x


@pytest.mark.slow
def test_default_is_to_stay_where_it_stops(world: World) -> None:
    assert world.ask(QueryCommsLostConfiguration()).comms_lost_detection_rec.comms_lost_timeout == 0
    drive(world, 4)
    world.run(CONTROL + 0.5)
    assert stands(world)
    stopped = x(world)
    assert state(world) == ACTIVE
    assert holder(world).component_id == 0
    world.run(30.0)
    assert x(world) == pytest.approx(stopped, abs=0.02)


@pytest.mark.slow
def test_dead_mans_stop_comes_first_and_then_it_drives_back(world: World) -> None:
    assert world.ask(policy(back(100.0))) == SetCommsLostPolicyResponse(7, SUCCESS)
    drive(world, 5)
    world.run(CONTROL + 0.3)
    stopped = x(world)
    assert stopped > 3.0
    assert state(world) == ENABLED
    stood: list[float] = []
    world.run(8.0 - CONTROL - 0.5, lambda: stood.append(x(world)))
    assert max(stood) - min(stood) < 0.1  # it has stopped before the policy acts
    assert stands(world)
    world.run(2.0)
    assert state(world) == ACTIVE
    assert x(world) < stopped - 0.2
    world.run_until(lambda: status_of(world) == 0, 30)
    world.run(1.0)
    assert abs(x(world)) < 0.15
    assert stands(world)
    assert world.own_motion.parts == frozenset()


def status_of(world: World) -> int:
    return world.tell(QueryRetrotraverseStatus(), client=OTHER)[-1].retrotraverse_status_rec.retrotraverse_status


@pytest.mark.slow
def test_distance_and_speed_of_the_wire(world: World) -> None:
    world.tell(policy(back(1.5, 0.25), timeout=6))
    drive(world, 5)
    world.run(6.2)
    stopped, fastest = x(world), [0.0]
    world.run(12.0, lambda: fastest.append(abs(world.robot.drive.twist().vx)))
    assert stopped - x(world) == pytest.approx(1.5, abs=0.15)
    assert 0.2 < max(fastest) < 0.3


def test_a_shorter_time_out_than_that_of_control_ends_control(world: World) -> None:
    world.tell(policy(back(100.0), timeout=2))
    drive(world, 5)
    world.run(1.7)
    assert not stands(world)
    world.run(0.8)
    assert holder(world).component_id == 0
    stopped = x(world)
    world.run(3.0)
    assert x(world) < stopped - 0.5


def test_time_out_of_zero_begins_when_control_ends(world: World) -> None:
    world.tell(policy(back(100.0), timeout=0))
    drive(world, 5)
    world.run(CONTROL - 0.2)
    stopped = x(world)
    world.run(4.0)
    assert x(world) < stopped - 0.5


@pytest.mark.slow
@pytest.mark.parametrize("client", [CLIENT, OTHER], ids=["the same client", "another client"])
def test_control_stops_the_motion(world: World, client) -> None:
    world.tell(policy(back(100.0), timeout=6, regained=DO_NOTHING))
    drive(world, 6)
    world.run(9.0)
    assert not stands(world)
    world.tell(RequestControl(100), client=client)
    stopped = x(world)
    assert world.vehicle.pilot.driver is None
    world.run(0.5)
    assert stands(world)
    assert x(world) == pytest.approx(stopped, abs=0.15)
    world.run(4.0)
    assert x(world) > 0.5
    assert state(world) == ENABLED
    # and it may be driven again
    world.tell(RequestControl(100), Resume(), velocity(0.3), client=client)
    before = x(world)
    world.run(2.0)
    assert x(world) > before + 0.2


@pytest.mark.slow
def test_link_that_is_back_stops_the_motion_although_nobody_controls(world: World) -> None:
    world.tell(policy(back(100.0), timeout=6, regained_timeout=2))
    drive(world, 6)
    world.run(8.5)
    assert not stands(world)
    world.tell(QueryHeartbeatPulse())
    world.run(1.0)
    assert not stands(world)  # not for long enough yet
    world.tell(QueryHeartbeatPulse(), client=OTHER)
    world.run(1.0)
    assert not stands(world)
    world.tell(QueryHeartbeatPulse())
    world.run(0.6)
    assert stands(world)
    stopped = x(world)
    world.run(20.0)
    assert x(world) == pytest.approx(stopped, abs=0.02)
    assert state(world) == DISABLED


@pytest.mark.slow
def test_link_that_is_back_only_now_and_then_is_not_back(world: World) -> None:
    world.tell(policy(back(100.0), timeout=6, regained_timeout=10))
    drive(world, 6)
    world.run(7.0)
    for _ in range(2):
        world.tell(QueryHeartbeatPulse())
        world.run(7.0)
    world.run_until(lambda: status_of(world) == 0, 20)
    assert abs(x(world)) < 0.15


@pytest.mark.slow
def test_do_nothing_goes_on_when_the_link_is_back(world: World) -> None:
    world.tell(policy(back(100.0), timeout=6, regained=DO_NOTHING))
    drive(world, 5)
    world.run(8.5)
    for _ in range(12):
        world.tell(QueryHeartbeatPulse())
        world.run(1.0)
    assert abs(x(world)) < 0.15


@pytest.mark.slow
def test_link_that_is_back_before_the_time_out_prevents_the_reaction(world: World) -> None:
    world.tell(policy(back(100.0), timeout=10))
    drive(world, 5)
    world.run(7.0)
    stopped = x(world)
    world.tell(QueryHeartbeatPulse())  # it does not ask for control again
    world.run(15.0)
    assert x(world) == pytest.approx(stopped, abs=0.02)
    assert state(world) == DISABLED


@pytest.mark.slow
def test_continue_goes_on_to_the_waypoint(world: World) -> None:
    world.tell(policy(CONTINUE, timeout=7))
    world.tell(SetLocalWaypoint(x=6.0, y=0.0), SetTravelSpeed(0.4))
    world.run(2.0)
    world.run(CONTROL - 1.5)
    stopped = x(world)
    assert stands(world)
    assert stopped < 4.0
    world.run(1.0)
    assert stands(world)
    world.run_until(lambda: math.hypot(x(world) - 6.0, world.vehicle.pose.y) < 0.15, 20)
    world.run(2.0)
    assert stands(world)
    assert not world.host.first_error


@pytest.mark.slow
def test_continue_goes_on_with_the_list(world: World) -> None:
    world.tell(policy(CONTINUE, timeout=7))
    points = [(2.0, 0.0), (2.0, 2.0), (0.0, 2.0)]
    world.set_list(SetLocalWaypoint(x=px, y=py) for px, py in points)
    world.tell(ExecuteList(speed=0.5, element_uid=1))
    passed: list[bool] = [False]

    def watch() -> None:
        passed[0] |= math.hypot(x(world) - 2.0, world.vehicle.pose.y - 2.0) < 0.4

    world.run_until(lambda: math.hypot(x(world), world.vehicle.pose.y - 2.0) < 0.2, 60, watch)
    assert passed[0]
    assert holder(world).component_id == 0


@pytest.mark.slow
def test_continue_without_a_mission_stays(world: World) -> None:
    world.tell(policy(CONTINUE, timeout=6))
    drive(world, 4)
    world.run(CONTROL + 1.0)
    stopped = x(world)
    world.run(10.0)
    assert x(world) == pytest.approx(stopped, abs=0.02)


@pytest.mark.slow
def test_move_to_a_waypoint_and_no_farther_than_the_distance(world: World) -> None:
    place = world.place
    home = GlobalWaypointRec(place.latitude, place.longitude)
    assert world.ask(policy(move(home, 0.5, 1.5), timeout=6)).comms_lost_result == SUCCESS
    drive(world, 6)
    world.run(6.2)
    stopped = x(world)
    world.run(25.0)
    assert stands(world)
    assert stopped - x(world) == pytest.approx(1.5, abs=0.3)  # the turn on the spot counts, too
    world.tell(RequestControl(200), Resume(), policy(move(home, 0.5), timeout=6))
    drive(world, 2, 0.0)
    world.run(40.0)
    assert abs(x(world)) < 0.4
    assert stands(world)


@pytest.mark.parametrize(
    ("variant", "result"),
    [
        (back(0.0), NOT_SUPPORTED),
        (back(10.0, method=1), NOT_SUPPORTED),
        (back(1e6, 327.67), SUCCESS),
        (back(0.0, waypoint=GlobalWaypointRec(38.593, -77.179)), SUCCESS),
        (back(0.0, waypoint=GlobalWaypointRec(90.0, 180.0)), NOT_SUPPORTED),
        (move(GlobalWaypointRec(38.593, -77.179), 0.0), NOT_SUPPORTED),
        (move(GlobalWaypointRec(-90.0, -180.0), 1.0), NOT_SUPPORTED),
        (move(GlobalWaypointRec(38.593, -77.179), 327.67, 1e6), SUCCESS),
        (M.StopMotionVar(255), SUCCESS),
        (M.ContinueMissionVar(255), SUCCESS),
    ],
)
def test_odd_policies_are_refused_and_change_nothing(world: World, variant: object, result: int) -> None:
    before = world.ask(QueryCommsLostConfiguration())
    assert world.ask(policy(variant, timeout=65535, regained_timeout=65535)).comms_lost_result == result
    after = world.ask(QueryCommsLostConfiguration())
    assert (after == before) == (result == NOT_SUPPORTED)


def test_unknown_variants_and_behaviors_are_dropped(world: World) -> None:
    good = policy(STOP).encode()
    offset = good.index(bytes([8, 0])) + 2
    assert good[offset] == 0
    before = world.ask(QueryCommsLostConfiguration())
    for damaged in (
        good[:offset] + bytes([4]) + good[offset + 1 :],
        good[:offset] + bytes([255]) + good[offset + 1 :],
        good[:offset],
        policy(back(5.0)).encode()[:-6],
        good[:-1] + bytes([2]),
        good[:-1] + bytes([255]),
        *(good[:end] for end in range(2, len(good))),
    ):
        world.host.receive(damaged, CLIENT, world.now)
        answers = [message.payload for message in world.host.poll_output(world.now)]
        assert not any(payload[:2] == SetCommsLostPolicyResponse.CODE.to_bytes(2, "little") for payload in answers) or (
            answers[0][3] == NOT_SUPPORTED
        )
    assert world.ask(QueryCommsLostConfiguration()) == before
    assert not world.host.first_error


def test_policy_is_that_of_the_client_in_control(world: World) -> None:
    assert world.tell(policy(back(5.0)), client=OTHER) == []
    world.tell(policy(back(5.0)))
    world.tell(RequestControl(255), client=OTHER)
    variant = world.tell(QueryCommsLostConfiguration(), client=OTHER)[-1].comms_lost_policy_var
    assert type(variant).__name__ == "StopMotionVar"


@pytest.mark.slow
@pytest.mark.parametrize("ending", [ReleaseControl(), Standby(), SetEmergency(1)], ids=lambda message: message.NAME)
def test_no_reaction_after_what_the_client_has_said_last(world: World, ending: Message) -> None:
    world.tell(policy(back(100.0), timeout=6))
    drive(world, 5)
    world.tell(ending)
    world.run(1.0)
    stopped = x(world)
    world.run(12.0)
    assert x(world) == pytest.approx(stopped, abs=0.02)
    assert world.own_motion.parts == frozenset()


@pytest.mark.slow
def test_no_reaction_after_an_emergency_of_anybody(world: World) -> None:
    world.tell(policy(back(100.0), timeout=6))
    drive(world, 6)
    world.run(9.0)
    assert not stands(world)
    world.tell(SetEmergency(1), client=OTHER)
    world.run(0.6)
    assert stands(world)
    stopped = x(world)
    world.tell(ClearEmergency(1), client=OTHER)
    world.run(20.0)
    assert x(world) == pytest.approx(stopped, abs=0.02)


@pytest.mark.slow
def test_client_with_a_higher_authority_does_not_start_a_reaction(world: World) -> None:
    world.tell(policy(back(100.0), timeout=6))
    drive(world, 5)
    world.tell(RequestControl(255), client=OTHER)
    world.run(1.0)
    stopped = x(world)
    world.run(3.0)
    assert x(world) == pytest.approx(stopped, abs=0.02)
    world.tell(ReleaseControl(), client=OTHER)
    world.run(20.0)
    assert x(world) == pytest.approx(stopped, abs=0.02)


def test_client_that_is_unreachable_has_lost_the_link(world: World) -> None:
    world.tell(policy(back(100.0), timeout=6))
    drive(world, 5)
    world.run(1.0)
    world.host.unreachable(CLIENT, world.now)
    world.run(1.0)
    assert stands(world)
    stopped = x(world)
    world.run(6.0)
    assert x(world) < stopped - 0.2


@pytest.mark.slow
def test_retrotraverse_of_the_client_is_continued(world: World) -> None:
    drive(world, 8)
    world.tell(policy(CONTINUE, timeout=6), velocity(0.0))
    world.run(0.5)
    world.tell(start(100.0, 0.3))
    world.run(CONTROL - 0.8)
    assert status(world).retrotraverse_status
    world.run(0.1)
    world.host.unreachable(CLIENT, world.now)
    world.run(0.5)
    assert stands(world)
    assert x(world) > 1.0
    world.run(25.0)
    assert abs(x(world)) < 0.2


@pytest.mark.slow
def test_blocked_reaction_gives_up(world: World) -> None:
    place = world.place
    world.tell(policy(move(GlobalWaypointRec(place.latitude, place.longitude), 0.5), timeout=6))
    drive(world, 5)
    world.run(6.0)
    world.vehicle.drive.set_effort = lambda **_: world.vehicle.drive.stop()  # type: ignore[method-assign]
    world.run(14.0)
    assert world.host.counters["comms_lost_stalled"] == 1
    assert world.vehicle.pilot.driver is None


def test_capabilities(world: World) -> None:
    found = world.ask(QueryCommsLostCapabilities()).supported_behaviors
    assert (found.stop, found.continue_mission, found.move_to_pos, found.retrotraverse) == (1, 1, 1, 1)
    bare = World(world.backend, None)
    assert bare.ask(QueryCommsLostCapabilities()).supported_behaviors.move_to_pos == 0
    bare.take_control()
    assert bare.ask(policy(move(GlobalWaypointRec(0.0, 0.0), 1.0))).comms_lost_result == NOT_SUPPORTED


@pytest.mark.slow
def test_default_of_the_robots_file(world: World) -> None:
    world = World(world.backend, timeout=CONTROL, comms_lost={"policy": "retrotraverse", "timeout": 6, "distance": 2.0})
    world.take_control()
    variant = world.ask(QueryCommsLostConfiguration()).comms_lost_policy_var
    assert variant.retrotraverse_action_rec.distance == pytest.approx(2.0, abs=0.01)
    drive(world, 6)
    world.run(6.2)
    stopped = x(world)
    world.run(10.0)
    assert stopped - x(world) == pytest.approx(2.0, abs=0.15)


@pytest.mark.slow
def test_closing_ends_it(world: World) -> None:
    world.tell(policy(back(100.0), timeout=6))
    drive(world, 6)
    world.run(9.0)
    assert not stands(world)
    world.host.close(world.now)
    world.run(0.5)
    assert stands(world)
    world.run(30.0)
    assert stands(world)
    assert world.host.id == ME


@pytest.mark.parametrize(
    ("type", "table", "text"),
    [
        ("CM-MOB", {"policy": "dance"}, "'stop', 'continue' or 'retrotraverse'"),
        ("CM-MOB", {"timeout": -1}, "greater than or equal to 0"),
        ("CM-MOB", {"distance": 0}, "greater than 0"),
        ("CM-MOB", {"speed": math.nan}, "327"),
        ("CM-MOB", {"distance": math.inf}, "1000000"),
        ("CM-MOB", {"far": 1}, "not permitted"),
        ("CM-MAN", {"policy": "stop"}, "a CM-MAN does not drive the robot; give it to the CM-MOB"),
    ],
)
def test_wrong_tables_are_explained(type: str, table: dict[str, object], text: str) -> None:
    with pytest.raises(ValueError, match=text):
        ModuleConfig(type=type, component=102, comms_lost=table)


@pytest.mark.parametrize(
    ("policy", "services", "text"),
    [
        ("stop", ["PrimitiveDriver"], "comms_lost: needs CommsLostPolicyManager; list"),
        ("retrotraverse", ["PrimitiveDriver"], "needs CommsLostPolicyManager and Retrotraverse; list"),
        ("retrotraverse", ["CommsLostPolicyManager"], "needs Retrotraverse; list"),
    ],
)
def test_policy_without_the_services_for_it_is_an_error(policy: str, services: list[str], text: str) -> None:
    with pytest.raises(ValueError, match=text):
        ModuleConfig(type="CM-MOB", component=102, services=tuple(services), comms_lost={"policy": policy})
