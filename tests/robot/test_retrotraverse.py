"""Driving back along the path that was driven, on every backend: the service Retrotraverse."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest
from tests.robot.world import CLIENT, OTHER, World

from jauspy.codec.message import Message
from jauspy.messages.core import (
    CommandEvent,
    CreateCommandEvent,
    ReleaseControl,
    RequestControl,
    Resume,
    SetEmergency,
    Standby,
)
from jauspy.messages.iop import CancelRetrotraverse, QueryRetrotraverseStatus, StartRetrotraverse
from jauspy.messages.mobility import SetVelocityCommand
from jauspy.messages.mobility.v1_0.types import GlobalWaypointRec
from jauspy.platform.joints import ControlMode, Target
from jauspy.services.iop import Retrotraverse

INACTIVE, REORIENTING, ACTIVE = range(3)
ALIKE = ("Standby", "ReleaseControl")
"""Messages that end it like `SetEmergency`, by the loss of readiness or of control; tested when there is time."""


def start(
    distance: float,
    speed: float = 0.0,
    *,
    method: int = 0,
    direction: int = 0,
    standoff: float = 0.0,
    waypoint: GlobalWaypointRec | None = None,
) -> StartRetrotraverse:
    parameters = StartRetrotraverse.Parameters(method, direction)
    action = StartRetrotraverse.RetrotraverseActionRec(distance, speed, parameters, standoff)
    return StartRetrotraverse(retrotraverse_action_rec=action, global_waypoint_rec=waypoint)


def velocity(forward: float, right: float = 0.0) -> Message:
    kind = SetVelocityCommand.CommandType.SET_CURRENT_COMMAND
    return SetVelocityCommand(kind, velocity_x=forward, yaw_rate=right)


def status(world: World):
    return world.ask(QueryRetrotraverseStatus()).retrotraverse_status_rec


def is_done(world: World) -> bool:
    return status(world).retrotraverse_status == INACTIVE


class Track:
    """Where the robot was on the way out, and how far from there it came on the way back."""

    def __init__(self, world: World) -> None:
        self.world = world
        self.out: list[tuple[float, float, float]] = []
        self.deviation = self.turned = self.fastest = 0.0
        self.states: set[int] = set()

    def note(self) -> None:
        pose = self.world.vehicle.pose
        self.out.append((pose.x, pose.y, pose.yaw))

    def compare(self) -> None:
        pose = self.world.vehicle.pose
        distance, yaw = min((math.hypot(pose.x - x, pose.y - y), yaw) for x, y, yaw in self.out)
        self.deviation = max(self.deviation, distance)
        self.turned = max(self.turned, abs(math.remainder(pose.yaw - yaw, math.tau)))
        self.fastest = max(self.fastest, abs(self.world.velocity.velocity_x))
        self.states.add(status(self.world).retrotraverse_status)

    def drive(self, *pieces: tuple[float, float, float]) -> None:
        """Drive at m/s and rad/s for seconds, one after the other, and stop."""
        for forward, right, seconds in pieces:
            self.world.tell(velocity(forward, right))
            self.world.run(seconds, self.note)
        self.world.tell(velocity(0.0))
        self.world.run(1.0, self.note)


CORNER = [(0.5, 0.0, 5.0), (0.0, 0.6, 2.6), (0.5, 0.0, 4.3), (0.4, 0.8, 2.0)]
"""Straight, a corner on the spot, straight, and a narrow curve."""


@pytest.fixture
def track(world: World) -> Track:
    return Track(world)


@pytest.mark.slow
def test_drives_back_around_corners_with_the_headings_of_the_way_out(world: World, track: Track) -> None:
    track.drive(*CORNER)
    assert world.distance(0.0, 0.0) > 3.0
    world.tell(start(100.0))
    world.run_until(lambda: is_done(world), 60, track.compare)
    world.run(0.5)
    assert world.distance(0.0, 0.0) < 0.15
    assert abs(world.pose.yaw) < 0.1
    assert track.deviation < 0.08
    assert track.fastest < 0.6  # no faster than on the way out
    assert world.stands()


@pytest.mark.slow
def test_turns_about_when_told_to(world: World, track: Track) -> None:
    track.drive(*CORNER)
    world.tell(start(100.0, direction=1))
    world.run_until(lambda: is_done(world), 60, track.compare)
    assert world.distance(0.0, 0.0) < 0.15
    assert abs(abs(world.pose.yaw) - math.pi) < 0.15
    assert {REORIENTING, ACTIVE} <= track.states
    assert track.deviation < 0.2


@pytest.mark.slow
def test_reversals_of_the_way_out_are_reversed(world: World, track: Track) -> None:
    track.drive((0.5, 0.0, 4.0), (-0.4, 0.4, 3.0), (0.5, 0.0, 3.0))
    world.tell(start(100.0))
    world.run_until(lambda: is_done(world), 60, track.compare)
    assert world.distance(0.0, 0.0) < 0.15
    assert abs(world.pose.yaw) < 0.2
    assert track.deviation < 0.1


@pytest.mark.slow
def test_distance_speed_and_progress(world: World, track: Track) -> None:
    track.drive((0.8, 0.0, 6.0))
    before, percents = world.pose.x, []
    world.tell(start(2.0, 0.3))
    world.run_until(lambda: is_done(world), 20, lambda: (track.compare(), percents.append(status(world))))
    assert before - world.pose.x == pytest.approx(2.0, abs=0.15)
    assert 0.25 < track.fastest < 0.36
    shown = [record.percent_complete for record in percents if record.percent_complete is not None]
    assert shown == sorted(shown)
    assert shown[0] < 5.0
    assert shown[-1] > 90.0
    # and the rest of it
    world.tell(start(100.0))
    world.run_until(lambda: is_done(world), 20)
    assert abs(world.pose.x) < 0.15


@pytest.mark.slow
def test_ends_abeam_of_a_waypoint_and_before_a_standoff(world: World, track: Track) -> None:
    track.drive((0.5, 0.0, 2.0))
    place = world.place
    waypoint = GlobalWaypointRec(place.latitude, place.longitude)
    track.drive((0.0, 0.0, 0.1), (0.5, 0.0, 8.0))
    reached = world.vehicle.point_on_globe(place.latitude, place.longitude)
    world.tell(start(0.0, waypoint=waypoint))
    world.run_until(lambda: is_done(world), 30)
    assert world.distance(reached.x, reached.y) < 0.15
    track.drive((0.5, 0.0, 6.0))
    world.tell(start(0.0, waypoint=waypoint, standoff=1.0))
    world.run_until(lambda: is_done(world), 30)
    assert world.distance(reached.x, reached.y) == pytest.approx(1.0, abs=0.15)
    track.drive((0.5, 0.0, 6.0))
    before = world.pose.x
    world.tell(start(1.5, waypoint=waypoint))  # the distance is the limit
    world.run_until(lambda: is_done(world), 30)
    assert before - world.pose.x == pytest.approx(1.5, abs=0.15)


@pytest.mark.slow
@pytest.mark.parametrize(
    "ending",
    [
        pytest.param(message, id=message.NAME, marks=[pytest.mark.slow] if message.NAME in ALIKE else [])
        for message in (CancelRetrotraverse(), Standby(), SetEmergency(1), ReleaseControl(), velocity(0.0))
    ],
)
def test_stops_at_once(world: World, track: Track, ending: Message) -> None:
    track.drive((0.5, 0.0, 6.0))
    world.tell(start(100.0))
    world.run(2.0)
    assert not world.stands()
    world.tell(ending)
    world.run(1.0)
    assert world.stands()
    assert is_done(world)
    assert world.pose.x > 1.0
    if isinstance(ending, CancelRetrotraverse):
        world.tell(start(100.0))
        world.run_until(lambda: is_done(world), 30)
        assert abs(world.pose.x) < 0.15


@pytest.mark.slow
def test_only_the_client_in_control_may_start_and_cancel_it(world: World, track: Track) -> None:
    track.drive((0.5, 0.0, 4.0))
    world.tell(start(100.0), client=OTHER)
    world.run(1.0)
    assert is_done(world)
    assert world.stands()
    world.tell(start(100.0))
    world.tell(CancelRetrotraverse(), client=OTHER)
    world.run(1.0)
    assert not is_done(world)
    world.tell(Standby(), start(100.0))
    world.run(1.0)
    assert is_done(world)
    assert world.stands()


@pytest.mark.slow
@pytest.mark.parametrize(
    "message",
    [
        pytest.param(start(0.0), id="no distance", marks=pytest.mark.slow),
        pytest.param(start(1e6, method=1), id="unknown method"),
        pytest.param(
            start(0.0, standoff=1e5, waypoint=GlobalWaypointRec(90.0, 180.0)),
            id="standoff beyond",
            marks=pytest.mark.slow,
        ),
        pytest.param(start(1e6, 327.67, standoff=1e5), id="all at their limits"),
        pytest.param(
            start(0.0, waypoint=GlobalWaypointRec(-90.0, -180.0, waypoint_tolerance=0.0, path_tolerance=0.0)),
            id="antipodes",
            marks=pytest.mark.slow,
        ),
    ],
)
def test_odd_requests_move_nothing_out_of_the_path(world: World, track: Track, message: Message) -> None:
    track.drive((0.5, 0.0, 3.0))
    before = world.pose.x
    world.tell(message)
    world.run(8.0, track.compare)
    assert track.deviation < 0.05
    assert -0.1 < world.pose.x < before + 0.05
    assert not world.host.first_error


@pytest.mark.slow
def test_tolerance_of_a_waypoint_does_not_widen_the_path(world: World, track: Track) -> None:
    track.drive((0.5, 0.0, 3.0))
    world.tell(start(0.0, waypoint=GlobalWaypointRec(38.593, -77.179, path_tolerance=100.0)))
    service = world.host.service(Retrotraverse)
    assert service is not None
    course = service._course
    assert course is not None
    pose = world.vehicle.pose
    assert course.steer(replace(pose, y=pose.y + 1.1)) is None
    assert course.lost


def test_without_a_path_nothing_moves(world: World) -> None:
    world.tell(start(10.0))
    world.run(1.0)
    assert world.stands()
    assert world.host.counters["retrotraverse_nothing_to_do"] == 1


@pytest.mark.slow
def test_its_end_is_a_command_event(world: World, track: Track) -> None:
    track.drive((0.5, 0.0, 3.0))
    seen: list[Message] = []
    seen += world.tell(CreateCommandEvent(1, 60, start(1.0)))
    world.run(0.5)
    assert not [message for message in seen if isinstance(message, CommandEvent)]
    for _ in range(80):
        world.run(0.1)
        seen += world.tell()
    results = [event.command_result for event in seen if isinstance(event, CommandEvent)]
    assert results[0] == CommandEvent.CommandResult.SUCCESSFUL


@pytest.mark.slow
def test_gives_up_when_something_is_in_the_way(world: World, track: Track) -> None:
    track.drive((0.5, 0.0, 4.0))
    world.tell(start(100.0))
    world.run(1.0)
    service = world.host.service(Retrotraverse)
    world.vehicle.drive.set_effort = lambda **_: world.vehicle.drive.stop()  # type: ignore[method-assign]
    world.run(15.0)
    assert is_done(world)
    assert world.host.counters["retrotraverse_ended"] == 1
    assert service is not None
    assert len(service.path) >= 2


@pytest.mark.slow
def test_flippers_get_the_positions_that_they_had(track: Track, world: World) -> None:
    """A client that controls the flippers, too, lowered them half way."""
    flippers = world.robot.groups["flippers"]
    (up,) = flippers.state().positions
    track.drive((0.5, 0.0, 4.0))
    flippers.command([Target(ControlMode.POSITION, up - 1.0)])
    world.run(4.0)
    (down,) = flippers.state().positions
    assert abs(up - down) > 0.5
    track.drive((0.5, 0.0, 4.0))
    raised_at: list[float] = []

    def watch() -> None:
        if not raised_at and abs(flippers.state().positions[0] - down) > 0.2:
            raised_at.append(world.vehicle.pose.x)

    world.own_motion.controlled.add("group 'flippers'")
    x = world.pose.x
    world.tell(start(100.0))
    world.run_until(lambda: is_done(world), 60, watch)
    assert flippers.state().positions[0] == pytest.approx(up, abs=0.15)
    assert raised_at
    assert 1.4 < raised_at[0] < x - 1.0  # where it was lowered, and the robot stood meanwhile


@pytest.mark.slow
def test_flippers_of_another_client_are_left_alone(track: Track, world: World) -> None:
    flippers = world.robot.groups["flippers"]
    (up,) = flippers.state().positions
    track.drive((0.5, 0.0, 2.0))
    flippers.command([Target(ControlMode.POSITION, up - 1.0)])
    world.run(4.0)
    (down,) = flippers.state().positions
    track.drive((0.5, 0.0, 2.0))
    world.tell(start(100.0))
    world.run_until(lambda: is_done(world), 60)
    assert flippers.state().positions[0] == pytest.approx(down, abs=0.1)


@pytest.mark.slow
def test_control_is_needed_again_after_a_release(world: World, track: Track) -> None:
    track.drive((0.5, 0.0, 3.0))
    world.tell(ReleaseControl())
    world.tell(start(100.0))
    world.run(1.0)
    assert world.stands()
    world.tell(RequestControl(200), Resume(), client=OTHER)
    world.tell(start(100.0), client=CLIENT)
    world.run(1.0)
    assert world.stands()
