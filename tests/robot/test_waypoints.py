"""Waypoints, driven for real: by list and one by one, in the local frame and on the globe, on every backend."""

from __future__ import annotations

import math

import pytest
from tests.helpers.sampling import sampled
from tests.robot.world import CLIENT, ORIGIN, OTHER, World

from jauspy.codec.message import Message
from jauspy.geometry.geodesy import Geodetic, to_ned
from jauspy.ids import JausID
from jauspy.messages.core import (
    CommandEvent,
    CreateCommandEvent,
    DeleteElement,
    QueryElementList,
    ReleaseControl,
    RequestControl,
    Resume,
    SetEmergency,
    Standby,
)
from jauspy.messages.mobility import (
    ExecuteList,
    ExecuteListExt,
    QueryGlobalWaypoint,
    QueryLocalWaypoint,
    QueryTravelSpeed,
    QueryTravelSpeedExt,
    SetGlobalWaypoint,
    SetLocalPose,
    SetLocalWaypoint,
    SetTravelSpeed,
    SetTravelSpeedExt,
    SetWrenchEffort,
    Speed,
)

SQUARE = [(4.0, 0.0), (4.0, 4.0), (0.0, 4.0), (0.0, 0.0)]
ALL = 0xFF


def speed(world: World) -> float:
    return world.ask(QueryTravelSpeed()).speed


def metres(latitude: float, longitude: float, place) -> float:
    """How far a reported place is from a point of the globe."""
    here, there = (
        Geodetic(math.radians(a), math.radians(b))
        for a, b in ((latitude, longitude), (place.latitude, place.longitude))
    )
    return math.hypot(*to_ned(here, there)[:2])


class Watch:
    """Which elements were active, in order, and how near the robot came to each point meanwhile."""

    def __init__(self, world: World, distances) -> None:
        self.world = world
        self.distances = distances
        self.order: list[int] = []
        self.nearest = [math.inf] * len(distances)
        self.fastest = 0.0

    def look(self) -> None:
        active = self.world.active
        if self.order[-1:] != [active]:
            self.order.append(active)
        for uid, distance in enumerate(self.distances, 1):
            # The robot drives on for a moment after an element is done, so the one before counts, too.
            if active in (uid, uid + 1, 0):
                self.nearest[uid - 1] = min(self.nearest[uid - 1], distance())
        self.fastest = max(self.fastest, self.world.velocity.velocity_x)


@pytest.mark.slow
def test_four_local_waypoints_in_order_by_list(world: World) -> None:
    world.set_list(SetLocalWaypoint(x=x, y=y) for x, y in SQUARE)
    assert [each.element_uid for each in world.ask(QueryElementList()).element_list] == [1, 2, 3, 4]
    assert (world.active, speed(world)) == (0, 0.0)
    watch = Watch(world, [lambda x=x, y=y: world.distance(x, y) for x, y in SQUARE])
    world.tell(ExecuteList(speed=1.0, element_uid=1))
    assert speed(world) == pytest.approx(1.0, abs=0.01)
    assert world.ask(QueryLocalWaypoint(ALL)).x == pytest.approx(4.0, abs=1e-3)
    world.run_until(lambda: world.active == 0, 60.0, watch.look)
    watch.look()
    assert watch.order == [1, 2, 3, 4, 0]
    assert max(watch.nearest) < 0.15
    assert 0.9 < watch.fastest < 1.1
    assert speed(world) == 0.0
    world.run(1.0)
    assert world.stands()
    assert world.distance(0.0, 0.0) < 0.2


@pytest.mark.slow
def test_four_global_waypoints_in_order_by_list(world: World) -> None:
    places = [(38.593 + north * 9e-6, -77.179 + east * 11.4e-6) for north, east in ((4, 0), (4, 4), (0, 4), (0, 0))]
    world.set_list(SetGlobalWaypoint(latitude=latitude, longitude=longitude) for latitude, longitude in places)
    watch = Watch(world, [lambda place=place: metres(*place, world.place) for place in places])
    world.tell(ExecuteList(speed=1.0, element_uid=1))
    world.run_until(lambda: world.active == 0, 60.0, watch.look)
    watch.look()
    assert watch.order == [1, 2, 3, 4, 0]
    assert max(watch.nearest) < 0.2
    answer = world.ask(QueryGlobalWaypoint(ALL))
    assert (answer.latitude, answer.longitude) == pytest.approx(places[-1], abs=1e-7)


@pytest.mark.slow
def test_list_may_mix_frames_and_keeps_the_speed(world: World) -> None:
    world.set_list([SetLocalWaypoint(x=2.0, y=0.0), SetGlobalWaypoint(latitude=38.593, longitude=-77.179)])
    world.tell(ExecuteList(speed=0.8, element_uid=1))
    world.run_until(lambda: world.active == 2, 20.0)
    assert speed(world) == pytest.approx(0.8, abs=0.01)
    world.run_until(lambda: world.active == 0, 20.0)
    assert world.distance(0.0, 0.0) < 0.2


def outcomes(world: World, *messages: Message) -> list[bool]:
    """How the commands ended of which command events tell now: True for those that were carried out."""
    events = [each for each in world.tell(*messages) if isinstance(each, CommandEvent)]
    return [each.command_result == CommandEvent.CommandResult.SUCCESSFUL for each in events]


def watched(command: Message) -> CreateCommandEvent:
    return CreateCommandEvent(1, 60, command)


GO = SetTravelSpeed(speed=1.0)


def test_command_event_succeeds_when_the_waypoint_is_reached(world: World) -> None:
    assert outcomes(world, watched(SetLocalWaypoint(x=2.0, y=0.0))) == [True], "it is only kept until a speed is set"
    assert outcomes(world, watched(GO)) == []
    ends: list[bool] = []
    world.run_until(lambda: bool(ends), 15.0, lambda: ends.extend(outcomes(world)))
    assert ends == [True]
    assert world.distance(2.0, 0.0) < 0.15


@pytest.mark.parametrize(
    "end",
    sampled(
        [
            SetTravelSpeed(speed=0.5),
            SetLocalWaypoint(x=0.0, y=5.0),
            SetWrenchEffort(propulsive_linear_effort_x=20.0),
            Standby(),
            ReleaseControl(),
        ],
        3,
    ),
    ids=lambda each: each.NAME,
)
def test_command_event_fails_when_the_drive_is_preempted(world: World, end: Message) -> None:
    world.tell(SetLocalWaypoint(x=20.0, y=0.0))
    assert outcomes(world, watched(GO)) == []
    world.run(1.0)
    assert outcomes(world, end) == [False]


def test_new_waypoint_during_a_drive_is_a_lasting_command(world: World) -> None:
    world.tell(SetLocalWaypoint(x=20.0, y=0.0))
    world.tell(GO)
    assert outcomes(world, watched(SetLocalWaypoint(x=2.0, y=0.0))) == []
    assert outcomes(world, SetTravelSpeed(speed=0.0)) == [], "it waits, and has not given up"
    assert outcomes(world, watched(SetTravelSpeedExt(speed=Speed(Speed.Choice.ROTATIONS_PER_MINUTE, 9.0)))) == [False]
    assert outcomes(world, GO, Standby()) == [False]


@pytest.mark.slow
def test_waypoint_is_driven_to_after_the_speed_is_set(world: World) -> None:
    world.tell(SetLocalWaypoint(x=3.0, y=-2.0))
    world.run(1.0)
    assert world.distance(0.0, 0.0) < 0.01
    world.tell(SetTravelSpeed(speed=1.5))
    world.run_until(lambda: speed(world) == 0.0, 15.0)
    world.run(0.5)
    assert world.stands()
    assert world.distance(3.0, -2.0) < 0.15
    world.tell(SetTravelSpeed(speed=1.0))
    world.run(0.1)
    assert speed(world) == 0.0, "it was there already"
    world.tell(SetLocalWaypoint(x=5.0, y=-2.0))
    world.run(1.0)
    assert world.distance(3.0, -2.0) < 0.15, "a new waypoint waits for its speed"


@pytest.mark.slow
def test_global_waypoint_is_reached(world: World) -> None:
    goal = (38.593 + 3 * 9e-6, -77.179)
    world.tell(SetGlobalWaypoint(latitude=goal[0], longitude=goal[1]), SetTravelSpeed(speed=1.0))
    world.run_until(lambda: speed(world) == 0.0, 20.0)
    world.run(0.5)
    assert metres(*goal, world.place) < 0.15
    assert world.place.yaw == pytest.approx(0.0, abs=0.25), "north of where it was"
    assert world.pose.yaw == pytest.approx(-ORIGIN.heading, abs=0.25)


def test_waypoints_refer_to_the_set_frame(world: World) -> None:
    world.tell(SetLocalPose(x=100.0, y=-50.0, yaw=math.pi / 2))
    world.tell(SetLocalWaypoint(x=100.0, y=-47.0), SetTravelSpeed(speed=1.0))
    world.run_until(lambda: speed(world) == 0.0, 15.0)
    assert world.distance(100.0, -47.0) < 0.15
    assert world.vehicle.pose.x == pytest.approx(3.0, abs=0.15), "straight on, in the world"
    assert world.vehicle.pose.y == pytest.approx(0.0, abs=0.1)


@pytest.mark.slow
def test_waypoint_follows_a_frame_set_during_the_drive(world: World) -> None:
    world.tell(SetLocalWaypoint(x=6.0, y=0.0), SetTravelSpeed(speed=1.0))
    world.run(2.0)
    world.tell(SetLocalPose(x=0.0, y=0.0))
    world.run_until(lambda: speed(world) == 0.0, 20.0)
    assert world.distance(6.0, 0.0) < 0.15
    assert world.vehicle.pose.x > 7.0


@pytest.mark.slow
def test_yaw_is_reached(world: World) -> None:
    world.tell(SetLocalWaypoint(x=2.0, y=1.0, yaw=-2.0), SetTravelSpeed(speed=1.0))
    world.run_until(lambda: speed(world) == 0.0, 20.0)
    world.run(0.5)
    assert world.distance(2.0, 1.0) < 0.2
    assert math.remainder(world.pose.yaw + 2.0, math.tau) == pytest.approx(0.0, abs=0.06)


@pytest.mark.slow
def test_a_negative_speed_drives_backward(world: World) -> None:
    world.tell(SetLocalWaypoint(x=-2.0, y=0.3))
    world.tell(SetTravelSpeedExt(speed=Speed(Speed.Choice.SPEED_OVER_GROUND, -0.6)))
    world.run(1.5)
    assert world.velocity.velocity_x < -0.4
    assert world.ask(QueryTravelSpeedExt()).speed.value == pytest.approx(-0.6, abs=0.01)
    world.run_until(lambda: speed(world) == 0.0, 15.0)
    assert world.distance(-2.0, 0.3) < 0.15
    assert abs(world.pose.yaw) < 0.5


def test_speed_in_revolutions_is_ignored(world: World) -> None:
    world.tell(SetLocalWaypoint(x=2.0, y=0.0))
    world.tell(SetTravelSpeedExt(speed=Speed(Speed.Choice.ROTATIONS_PER_MINUTE, 100.0)))
    world.run(0.5)
    assert world.distance(0.0, 0.0) < 0.01
    assert world.host.counters["unsupported_speed"] == 1


def test_wide_tolerance_passes_a_waypoint_early(world: World) -> None:
    world.set_list(
        [
            SetLocalWaypoint(x=4.0, y=0.0, waypoint_tolerance=2.0),
            SetLocalWaypoint(x=4.0, y=4.0),
            SetLocalWaypoint(x=0.0, y=4.0),
        ]
    )
    world.tell(ExecuteList(speed=1.0, element_uid=1))
    world.run_until(lambda: world.active == 2, 10.0)
    assert world.distance(4.0, 0.0) == pytest.approx(2.0, abs=0.1)


@pytest.mark.slow
def test_execute_without_an_element_changes_the_speed(world: World) -> None:
    world.set_list([SetLocalWaypoint(x=6.0, y=0.0)])
    world.tell(ExecuteList(speed=1.0))
    assert world.active == 0, "there is nothing whose speed could change"
    world.tell(ExecuteList(speed=1.0, element_uid=1))
    world.run(2.0)
    world.tell(ExecuteListExt(speed=Speed(Speed.Choice.SPEED_OVER_GROUND, 0.3)))
    world.run(1.5)
    assert world.velocity.velocity_x == pytest.approx(0.3, abs=0.05)
    world.tell(ExecuteList(speed=0.0))
    world.run(1.5)
    assert (world.stands(), world.active) == (True, 1)
    world.tell(ExecuteList(speed=1.0))
    world.run_until(lambda: world.active == 0, 10.0)
    assert world.distance(6.0, 0.0) < 0.15


def test_execute_starts_at_the_given_element(world: World) -> None:
    world.set_list([SetLocalWaypoint(x=6.0, y=0.0), SetLocalWaypoint(x=0.0, y=2.0)])
    world.tell(ExecuteList(speed=1.0, element_uid=2))
    assert world.active == 2
    assert world.ask(QueryLocalWaypoint(0)).y == pytest.approx(2.0, abs=1e-3)
    world.tell(ExecuteList(speed=1.0, element_uid=9))
    assert world.active == 2, "there is no such element"


@pytest.mark.slow
@pytest.mark.parametrize(
    ("client", "message"),
    [
        (CLIENT, Standby()),
        (CLIENT, ReleaseControl()),
        (OTHER, SetEmergency(1)),
        (OTHER, RequestControl(201)),
        (CLIENT, DeleteElement(DeleteElement.RequestIDRec(1), [DeleteElement.DeleteElementRec(65535)])),
    ],
    ids=["standby", "release", "emergency", "preempted", "list deleted"],
)
def test_end_of_control_or_ready_stops_the_drive_for_good(world: World, client: JausID, message) -> None:
    world.set_list([SetLocalWaypoint(x=30.0, y=0.0)])
    world.tell(ExecuteList(speed=1.0, element_uid=1))
    world.run(3.0)
    assert world.velocity.velocity_x > 0.9
    x = world.pose.x
    world.tell(message, client=client)
    assert (world.active, speed(world)) == (0, 0.0)
    world.run(0.8)
    assert world.stands()
    assert world.pose.x - x < 0.4
    world.tell(RequestControl(255), Resume(), client=OTHER)
    world.tell(SetTravelSpeed(speed=1.0), client=OTHER)
    world.run(1.0)
    assert world.stands(), "nobody drives to a waypoint of somebody else"


@pytest.mark.slow
def test_replaced_active_element_restarts(world: World) -> None:
    world.set_list([SetLocalWaypoint(x=6.0, y=0.0)])
    world.tell(ExecuteList(speed=1.0, element_uid=1))
    world.run(1.0)
    world.set_list([SetLocalWaypoint(x=2.0, y=-2.0)])
    assert world.active == 1
    world.run_until(lambda: world.active == 0, 15.0)
    assert world.distance(2.0, -2.0) < 0.15
