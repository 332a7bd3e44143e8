"""PresetPose: moves the joints of a component to named poses, on routes without contact of its links (IOP v3)."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Final, TypeAlias

from jauspy.codec.message import Message
from jauspy.geometry.joint_routes import Positions, ReachablePositions, Route, RouteSearch
from jauspy.geometry.link_clearances import LinkClearances
from jauspy.geometry.link_pairs import Pair
from jauspy.geometry.urdf import JointKind
from jauspy.ids import JausID
from jauspy.joint_values import kind_of
from jauspy.logs import get_logger
from jauspy.messages.iop import (
    ReportCurrentPose,
    ReportPresetPoseCapabilities,
    ReportPresetPoseSpecifications,
    ReportTransitionCompleted,
    SetCurrentPose,
)
from jauspy.platform.named_poses import NamedPose
from jauspy.services.manipulator.arm import Arm, ArmDriver, MotionProfile
from jauspy.services.manipulator.blocked_joints import LEAST_SHORT, StandstillWatch
from jauspy.services.state_machine import CommandCompletion

_LOG: Final = get_logger("jauspy.preset_pose")

UNKNOWN_POSE: Final = 255
"""The id of positions that are no named pose."""
CHECK_PERIOD: Final = 0.05
"""Seconds between two checks how far a motion is."""
SEARCH_PERIOD: Final = 0.01
"""Seconds between two parts of the search for a route."""
SEARCH_CHECKS: Final = 20
"""Positions that a part of the search checks: 5 ms."""
REST_SPEED: Final = 0.05
"""rad/s or m/s up to which a joint stands."""
OTHERS_MOVED: Final = 0.02
"""Radians or metres by which other joints may move before the rest of a route is checked again."""
TIME_FACTOR, TIME_ALLOWANCE = 1.5, 5.0
"""A motion times out after so many times the time of its route by the motion profile, and seconds in addition."""
SHORT_WAY: Final = 0.05
"""Radians or metres up to which a joint moves within its own profile.

Its share of the acceleration of a long way would be too small to stop what is left of its motion on the leg before.
"""

_Status: TypeAlias = ReportTransitionCompleted.TransitionStatus


@dataclass(slots=True)
class Transition:
    """A motion to a pose, from the request to its report."""

    client: JausID
    request_id: int
    start: int
    """Id of the pose in which it began."""
    pose: NamedPose
    command: CommandCompletion
    goal: Positions = ()
    others: Mapping[str, float] = field(default_factory=dict)
    """Positions of the other joints when the route was checked last."""
    search: RouteSearch | None = None
    route: Route = ()
    """What is left of the route."""
    watch: StandstillWatch | None = None
    status: _Status = _Status.TRANSITION_FAILED


class PresetPose(ArmDriver, urn="urn:jaus:jss:iop:PresetPose"):
    """Named poses of the joints of one component.

    `poses`: those that name its joints; `clearances`: of the links that they move; `positions`: returns the present
    positions of all joints of the robot, by name, in radians or metres.
    """

    def __init__(
        self,
        arm: Arm,
        poses: Sequence[NamedPose],
        clearances: LinkClearances,
        positions: Callable[[], Mapping[str, float]],
    ) -> None:
        super().__init__(arm)
        self._names = [joint.name for joint in arm.joints.joints]
        self._poses = {pose.number: pose for pose in poses}
        self._clearances, self._positions = clearances, positions
        self._transition: Transition | None = None
        self._last = UNKNOWN_POSE
        """Id of the pose that was reached last: of several with equal positions it is the one that is held."""

    # --- reports --------------------------------------------------------------------------------------------------

    def send_report_preset_pose_capabilities(self) -> ReportPresetPoseCapabilities:
        """All poses (F0F1); from each to any other a motion may be requested, and also from what is no pose."""
        kind = ReportPresetPoseCapabilities
        none = kind.TransitionProperties(reserved=0)
        return kind(
            [
                kind.PoseSeq(
                    kind.PresetPoseRec(pose.number, pose.name),
                    [kind.TransitionRec(pose.number, end, none) for end in self._poses if end != pose.number],
                )
                for pose in self._poses.values()
            ]
        )

    def send_report_preset_pose_specifications(self) -> ReportPresetPoseSpecifications:
        """The positions of each pose (F0F5), for this component only: others report theirs."""
        kind, id = ReportPresetPoseSpecifications, self.host.id
        component = kind.PresetPositionsRec(kind.JAUS_ID(id.component, id.node, id.subsystem))
        return kind(
            [
                kind.PresetPoseSpecificationSeq(
                    kind.PresetPoseRec(pose.number, pose.name),
                    [kind.PresetPositionSeq(component, kind.JointPositionList(self._records(pose)))],
                )
                for pose in self._poses.values()
            ]
        )

    def _records(self, pose: NamedPose) -> list[ReportPresetPoseSpecifications.JointPositionRec]:
        kind, geometry = ReportPresetPoseSpecifications, self.arm.geometry
        rows = zip(geometry.from_urdf(self._goal(pose)), geometry.links, strict=True)
        return [
            kind.JointPositionRec(kind.JointPosition(kind.JointPositionChoice(kind_of(link)), position))
            for position, link in rows
        ]

    def send_report_current_pose(self) -> ReportCurrentPose:
        """The pose that is held, or the motion to one (F0F2)."""
        transition = self._transition
        if transition is not None:
            return ReportCurrentPose(ReportCurrentPose.CurrentTransitionRec(transition.start, transition.pose.number))
        return ReportCurrentPose(ReportCurrentPose.CurrentPoseRec(self._current()))

    # --- requests -------------------------------------------------------------------------------------------------

    def is_pose_unrecognized(self, msg: SetCurrentPose) -> bool:
        """True for an id that no pose has."""
        return msg.pose_id not in self._poses

    def is_transition_valid(self, msg: SetCurrentPose) -> bool:
        """True unless links would be in contact in the pose, with the other joints where they are now.

        True for an unknown pose as well, for which the standard has another status.
        """
        pose = self._poses.get(msg.pose_id)
        if pose is None:
            return True
        reachable = ReachablePositions(self._clearances, self._names, self._present(), self._others())
        pair = reachable.obstacle(self._nearest(pose))
        if pair is not None:
            self._note(pose, f"{_text(pair)} would be in contact there")
        return pair is None

    def set_current_pose(self, msg: SetCurrentPose, source: JausID) -> None:
        """Come to rest, search a route and move; a motion that is going on is given up."""
        start = self._current() if self._transition is None else UNKNOWN_POSE
        self.arm.stop()
        self.arm.preempt_for(self)
        pose, command = self._poses[msg.pose_id], self.host.begin_command()
        self._transition = Transition(source, msg.request_id, start, pose, command)
        self._limit_time(TIME_ALLOWANCE)
        self.host.set_timer(self._timer, self.host.now, self._come_to_rest)

    def send_report_transition_completed_invalid_transition(self, msg: SetCurrentPose, source: JausID) -> None:
        """Refuse a pose with contact (status 1)."""
        self._refuse(msg, source, _Status.INVALID_TRANSITION)

    def send_report_transition_completed_unrecognized_pose(self, msg: SetCurrentPose, source: JausID) -> None:
        """Refuse an id that no pose has (status 2)."""
        self._refuse(msg, source, _Status.UNRECOGNIZED_POSE)

    def send_report_transition_completed_transition_completed(self, msg: Transition) -> None:
        """Tell the client that the pose is reached (status 0)."""
        self._report(msg.client, msg.request_id, msg.status)

    def send_report_transition_completed_transition_failed(self, msg: Transition) -> None:
        """Tell the client why the pose is not reached (status 1: no route, 3: stopped, 5: timed out)."""
        self._report(msg.client, msg.request_id, msg.status)

    def on_preempted(self) -> None:
        """The motion has failed: another service moves the joints, or they were stopped."""
        self._end(_Status.TRANSITION_FAILED)

    # --- the motion -----------------------------------------------------------------------------------------------

    @property
    def _timer(self) -> tuple[str, str]:
        return "transition", self.urn

    def _come_to_rest(self) -> None:
        """Begin the search when the joints stand: a route begins at rest."""
        transition = self._transition
        assert transition is not None
        if not self._rests():
            self.host.set_timer(self._timer, self.host.now + CHECK_PERIOD, self._come_to_rest)
            return
        present, transition.others = self._present(), self._others()
        transition.goal = self._nearest(transition.pose)
        reachable = ReachablePositions(self._clearances, self._names, present, transition.others)
        by = [self._nearest(pose) for pose in self._poses.values() if pose is not transition.pose]
        transition.search = RouteSearch(reachable, present, transition.goal, by)
        self._look_for_route()

    def _look_for_route(self) -> None:
        transition = self._transition
        assert transition is not None
        search = transition.search
        assert search is not None
        search.advance(SEARCH_CHECKS)
        if not search.is_finished:
            self.host.set_timer(self._timer, self.host.now + SEARCH_PERIOD, self._look_for_route)
        elif search.route is None:
            reason = "" if search.obstacle is None else f": on the direct way {_text(search.obstacle)} would touch"
            self._note(transition.pose, f"there is no way without contact{reason}")
            self._give_up(_Status.INVALID_TRANSITION)
        else:
            transition.route = search.route
            legs = itertools.pairwise((self._present(), *search.route))
            time = sum(_duration(start, end, self.arm.profiles) for start, end in legs)
            self._limit_time(TIME_FACTOR * time + TIME_ALLOWANCE)
            self._begin_leg()

    def _begin_leg(self) -> None:
        """Move all joints to the next positions of the route, in the same time."""
        transition = self._transition
        assert transition is not None
        profiles = _synchronous(self._present(), transition.route[0], self.arm.profiles)
        goal = self.arm.geometry.from_urdf(transition.route[0])
        self.arm.to_positions(self, goal, profiles)
        transition.watch = StandstillWatch(
            self.arm.joints.joints,
            [(profile.speed, min(profile.acceleration, profile.deceleration)) for profile in profiles],
        )
        self.host.set_timer(self._timer, self.host.now + CHECK_PERIOD, self._check)

    def _check(self) -> None:
        """Continue at the end of a leg; stop if a joint is blocked, or if other joints have moved into the way."""
        transition = self._transition
        assert transition is not None
        goal = self.arm.geometry.from_urdf(transition.route[0])
        if self.arm.is_at(goal) and self._rests():
            transition.route = transition.route[1:]
            if not transition.route:
                self._end(_Status.TRANSITION_COMPLETED)
                return
            self._begin_leg()
            return
        assert transition.watch is not None
        if self.stops_if_blocked(transition.watch, goal):
            return  # `on_preempted` has ended the transition
        if (pair := self._in_the_way(transition)) is not None:
            self._note(transition.pose, f"other joints moved, and {_text(pair)} would touch")
            self._give_up(_Status.TRANSITION_FAILED)
            return
        self.host.set_timer(self._timer, self.host.now + CHECK_PERIOD, self._check)

    def _in_the_way(self, transition: Transition) -> Pair | None:
        """Two links that would come too near on the rest of the route, if other joints have moved."""
        others, before = self._others(), transition.others
        if all(abs(position - before.get(name, position)) < OTHERS_MOVED for name, position in others.items()):
            return None
        transition.others = others
        present = self._present()
        reachable = ReachablePositions(self._clearances, self._names, present, others)
        return reachable.obstacle_on(present, transition.route)

    def _limit_time(self, seconds: float) -> None:
        self.host.set_timer((*self._timer, "limit"), self.host.now + seconds, self._on_time_out)

    def _on_time_out(self) -> None:
        if self._transition is not None:
            self._note(self._transition.pose, "it takes too long")
            self._give_up(_Status.TRANSITION_TIMED_OUT)

    def _give_up(self, status: _Status) -> None:
        self._end(status)
        self.arm.stop()

    def _end(self, status: _Status) -> None:
        """End the motion, if there is one: the internal event has the client told."""
        transition, self._transition = self._transition, None
        if transition is None:
            return
        self.host.cancel_timer(self._timer)
        self.host.cancel_timer((*self._timer, "limit"))
        transition.status = status
        is_completed = status is _Status.TRANSITION_COMPLETED
        self._last = transition.pose.number if is_completed else UNKNOWN_POSE
        self.host.fire("TransitionCompleted" if is_completed else "TransitionFailed", transition, transition.client)
        transition.command(is_completed)

    # --- inside ---------------------------------------------------------------------------------------------------

    def _rests(self) -> bool:
        return all(abs(velocity) <= REST_SPEED for velocity in self.arm.state().velocities)

    def _present(self) -> Positions:
        return tuple(self.arm.joints.state().positions)

    def _others(self) -> dict[str, float]:
        return {name: position for name, position in self._positions().items() if name not in self._names}

    def _goal(self, pose: NamedPose) -> Positions:
        return tuple(pose.positions[name] for name in self._names)

    def _nearest(self, pose: NamedPose) -> Positions:
        """The goal; of a joint that turns without end, the turn in which it is nearest."""
        rows = zip(self._goal(pose), self._present(), self.arm.joints.joints, strict=True)
        return tuple(
            present + math.remainder(goal - present, math.tau) if joint.kind is JointKind.CONTINUOUS else goal
            for goal, present, joint in rows
        )

    def _current(self) -> int:
        """The id of the pose in which the joints are."""
        geometry = self.arm.geometry
        held = [
            pose.number
            for pose in self._poses.values()
            if self.arm.is_at(geometry.from_urdf(self._nearest(pose)), LEAST_SHORT)
        ]
        return self._last if self._last in held else next(iter(held), UNKNOWN_POSE)

    def _refuse(self, msg: SetCurrentPose, client: JausID, status: _Status) -> None:
        self.host.begin_command()(False)
        self._report(client, msg.request_id, status)

    def _report(self, client: JausID, request_id: int, status: _Status) -> None:
        report: Message = ReportTransitionCompleted(request_id, status)
        self.host.send(client, report, on_acknowledged=lambda _: None)

    def _note(self, pose: NamedPose, reason: str) -> None:
        text = f"pose {pose.name!r}: {reason}"
        self.host.count("pose_not_reached", text)
        _LOG.warning("%s: %s", self.host.id, text)


def _text(pair: Pair) -> str:
    return f"{pair[0]} and {pair[1]}"


def _slowest(ways: Iterable[float], profiles: Sequence[MotionProfile]) -> tuple[float, float, float]:
    """Speed, acceleration and deceleration of a whole way in 1/s and 1/s^2, with which no joint exceeds its profile."""
    rows = [(abs(way), profile) for way, profile in zip(ways, profiles, strict=True) if way]
    return (
        min((profile.speed / way for way, profile in rows), default=math.inf),
        min((profile.acceleration / way for way, profile in rows), default=math.inf),
        min((profile.deceleration / way for way, profile in rows), default=math.inf),
    )


def _synchronous(start: Positions, end: Positions, profiles: Sequence[MotionProfile]) -> list[MotionProfile]:
    """Limits with which all joints begin and arrive together, so that they move on a straight way."""
    ways = [b - a for a, b in zip(start, end, strict=True)]
    speed, acceleration, deceleration = _slowest(ways, profiles)
    return [
        profile
        if abs(way) <= SHORT_WAY
        else MotionProfile(speed * abs(way), acceleration * abs(way), deceleration * abs(way))
        for way, profile in zip(ways, profiles, strict=True)
    ]


def _duration(start: Positions, end: Positions, profiles: Sequence[MotionProfile]) -> float:
    """Seconds of the trapezoid, from rest to rest."""
    speed, acceleration, deceleration = _slowest((b - a for a, b in zip(start, end, strict=True)), profiles)
    ramps = (1.0 / acceleration + 1.0 / deceleration) / 2.0
    if not ramps:
        return 0.0
    top = min(speed, 1.0 / math.sqrt(ramps))
    return 1.0 / top + ramps * top
