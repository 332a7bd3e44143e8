"""LeaderFollowerDriver: drives along the path of a leader, at a distance or a time behind it (IOP v3)."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Final

from jauspy.codec.message import Message
from jauspy.errors import DecodeError
from jauspy.geometry.poses import PlanarPoint, Pose
from jauspy.ids import JausID
from jauspy.logs import get_logger
from jauspy.messages.iop import ReportFollowerConfiguration, SetFollowerConfiguration, SetFollowerState
from jauspy.messages.mobility import QueryGlobalPose, ReportGlobalPose
from jauspy.services.core.remote_events import RemoteEvent
from jauspy.services.iop.convoy import Convoy
from jauspy.services.iop.following import STALE, FollowCourse, FollowerSettings, LeaderTrack
from jauspy.services.iop.leader_path import LeaderPath
from jauspy.services.iop.leader_requests import LeaderRequests
from jauspy.services.mobility.driver import Driver
from jauspy.services.mobility.vehicle import Vehicle

RATE: Final = 10.0
"""Hz at which the leader's pose is requested."""
POSE_FIELDS: Final = 0b1_0100_1011
"""Presence vector of it: latitude, longitude, error of the position, yaw, time."""
LOST_TIME: Final = 3.0
"""Seconds without a pose of the leader after which following ends."""
CHECK_PERIOD: Final = 0.1
"""Seconds between two checks of the bounds."""
MAX_LEADER_SPEED: Final = 10.0
"""m/s; a pose that the leader could have reached only faster is not believed."""
JUMP: Final = 0.5
"""Metres that a pose may be off besides, by errors that are not reported."""
CAUTION: Final = 0.6
"""Share of the greatest distance at which a leader that may be slowed is asked to drive slower."""
SLOWEST: Final = 0.2
"""Share of its speed that is asked for at the greatest distance."""

_LOG: Final = get_logger("jauspy.mobility")


class LeaderFollowerDriver(Driver, urn="urn:jaus:jss:iop:LeaderFollowerDriver"):
    """Follows the poses that the leader's GlobalPoseSensor reports, on the path between them.

    It stops while no pose arrives, and following ends when none has arrived for `LOST_TIME`, when a bound is passed,
    when another command or a loss of control stops the vehicle, and by STOP. It is begun by START alone. Poses of other
    senders, and jumps, are counted and not used. The vehicle needs an origin.
    """

    def __init__(self, vehicle: Vehicle) -> None:
        super().__init__(vehicle)
        self.settings = FollowerSettings()
        """Settings as commanded; changes hold from the next step on."""
        self.ended_by = ""
        """Why following ended, until it begins again."""
        self._track: LeaderTrack | None = None
        self._since = 0.0

    def attached(self) -> None:
        """Raises `ConfigError` without an origin."""
        super().attached()
        self.vehicle.global_frame()
        query = QueryGlobalPose(POSE_FIELDS)
        self._poses = RemoteEvent(self.host, query, RATE, self._on_pose)
        self._requests = LeaderRequests(self.host)
        self._course = self._new_course()

    def _new_course(self) -> FollowCourse:
        return FollowCourse(
            lambda: self.settings, lambda: self._track, self._own, lambda: self.host.now, self.vehicle.chassis
        )

    @property
    def is_following(self) -> bool:
        """True from START until it ends."""
        return self._poses.source is not None

    @property
    def course(self) -> FollowCourse:
        """The course, with the gap as the vehicle measures it."""
        return self._course

    @property
    def leader(self) -> JausID | None:
        """The component whose pose is followed: as commanded, or that of the same number in the vehicle ahead."""
        if self.settings.leader is not None:
            return self.settings.leader
        convoy = self.host.service(Convoy)
        ahead = None if convoy is None else convoy.leader_of(self.host.id.subsystem)
        return None if ahead is None else replace(self.host.id, subsystem=ahead)

    # --- actions

    def set_follower_values(self, msg: SetFollowerConfiguration) -> None:
        """Take the settings (FFF2); what is left out has its default. Those that contradict each other are refused.

        A tracked or wheeled vehicle keeps no height and no attitude: these are ignored. Following another leader begins
        with START.
        """
        given = msg.leader_id
        leader = None if given is None else JausID(given.subsystem_id, given.node_id, given.component_id)
        behaviour = msg.error_behavior
        defaults = FollowerSettings()
        lag = msg.lag_time or 0.0
        settings = FollowerSettings(
            leader=leader,
            stop_leader=bool(behaviour and behaviour.stop_leader),
            slow_leader=bool(behaviour and behaviour.allow_leader_override),
            lag=lag,
            minimum=_given(msg.minimum_follow_distance, 0.0 if lag else defaults.minimum),
            maximum=_given(msg.maximum_follow_distance, defaults.maximum),
            lateral_offset=_given(msg.lateral_offset, defaults.lateral_offset),
            max_lateral_error=_given(msg.max_lateral_error, defaults.max_lateral_error),
        )
        problem = settings.problem or ("a vehicle cannot follow itself" if self._is_own(leader) else "")
        if problem:
            self._refuse("bad_follower_configuration", problem)
            return
        self.settings = settings
        if self.is_following and self._poses.source != self.leader:
            self._requests.end()
            self._end("it has got another leader")
        elif self.is_following:
            self._register()

    def set_follower_state(self, msg: SetFollowerState) -> None:
        """Begin or end following (FFF1); START is refused without a leader."""
        if msg.state != SetFollowerState.State.START:
            self._requests.end()
            self._end("")
            return
        leader = self.leader
        if leader is None or self._is_own(leader):
            self._refuse("no_leader", "START, and neither the configuration nor the convoy names a leader")
            return
        self._begin(leader)

    def send_report_follower_configuration(self) -> ReportFollowerConfiguration:
        """State and settings (FFF4), those with a default included."""
        report = ReportFollowerConfiguration
        leader, settings = self.leader, self.settings
        address = None if leader is None else report.Leader_ID(leader.component, leader.node, leader.subsystem)
        return report(
            report.FollowerStateRec(report.State.START if self.is_following else report.State.STOP),
            report.FollowerConfigurationRec(
                leader_id=address,
                error_behavior=report.ErrorBehavior(
                    stop_leader=int(settings.stop_leader), allow_leader_override=int(settings.slow_leader)
                ),
                lag_time=settings.lag,
                minimum_follow_distance=settings.minimum,
                maximum_follower_distance=settings.maximum,
                lateral_offset=settings.lateral_offset,
                max_lateral_error=settings.max_lateral_error if math.isfinite(settings.max_lateral_error) else None,
            ),
        )

    def _refuse(self, reason: str, text: str) -> None:
        self.host.count(reason, text)
        self.host.begin_command()(False)

    def _is_own(self, leader: JausID | None) -> bool:
        return leader is not None and leader.subsystem == self.host.id.subsystem

    # --- following

    def _begin(self, leader: JausID) -> None:
        if self._poses.source == leader:
            return
        self._poses.begin(leader)
        self._track, self.ended_by, self._since = None, "", self.host.now
        self._course = self._new_course()
        self._register()
        self.host.set_timer(self._check, self.host.now + CHECK_PERIOD, self._check)
        self.vehicle.pilot.follow(self, self._course)

    def _register(self) -> None:
        """Register with the leader if its speed is to be influenced, which the profile has registration for."""
        if self._poses.source is not None and (self.settings.stop_leader or self.settings.slow_leader):
            self._requests.begin(self._poses.source)
        else:
            self._requests.end()

    def _end(self, why: str) -> None:
        """End following and stop. May be called twice."""
        if not self.is_following:
            return
        self._poses.end()
        self.host.cancel_timer(self._check)
        self._track, self.ended_by = None, why
        if why:
            _LOG.warning("%s follows no more: %s", self.host.id, why)
        self.vehicle.pilot.release(self)

    def on_preempted(self) -> None:
        """Following ends with another command or a stop; it is not taken up again by itself."""
        if self.is_following:
            self._requests.end()
            self._end("another command, or a stop")

    def control_lost(self) -> None:
        """Stop, and leave the leader alone."""
        self._requests.end()
        super().control_lost()

    def leaving(self) -> None:
        """End following before the component is closed."""
        self._requests.end()
        self._end("the component is closed")

    def _check(self) -> None:
        """End following when the leader is lost or a bound is passed."""
        self.host.set_timer(self._check, self.host.now + CHECK_PERIOD, self._check)
        problem, is_bound = self._problem()
        if not problem:
            self._slow_leader()
            return
        self.host.count("following_ended", problem)
        if is_bound and self.settings.stop_leader:
            self._requests.stop()
        else:
            self._requests.end()
        self._end(problem)

    def _problem(self) -> tuple[str, bool]:
        """Why the vehicle cannot follow any longer, or nothing; and whether it is one of the configured bounds."""
        track, gap, settings = self._track, self._course.gap, self.settings
        heard = self._since if track is None else track.path.leader.time
        if self.host.now - heard > LOST_TIME:
            return f"no pose of its leader for {LOST_TIME:g} s", False
        if track is None or gap is None:
            return "", False
        if gap.along > settings.maximum or track.path.is_full:
            return f"its leader is {gap.along:.1f} m ahead; the bound is {settings.maximum:.1f} m", True
        if abs(gap.lateral_error) > settings.max_lateral_error:
            return f"it is {abs(gap.lateral_error):.2f} m beside its path", True
        return "", False

    def _slow_leader(self) -> None:
        gap, settings = self._course.gap, self.settings
        if not settings.slow_leader or gap is None:
            return
        begin = max(CAUTION * settings.maximum, settings.minimum)
        beyond = (gap.along - begin) / (settings.maximum - begin)
        self._requests.slow(1.0 - (1.0 - SLOWEST) * min(1.0, max(0.0, beyond)))

    # --- the leader's poses

    def _on_pose(self, content: Message | bytes) -> None:
        report = _pose_in(content)
        if report is None or report.latitude is None or report.longitude is None or report.yaw is None:
            self.host.count("unusable_leader_pose", f"{content!r}")
            return
        frame = self.vehicle.global_frame()
        position, heading = frame.to_world(report.latitude, report.longitude), frame.heading_to_world(report.yaw)
        rms = report.position_rms or 0.0
        now, track = self.host.now, self._track
        if track is None:
            self._meet(position, rms)
            return
        moved, _ = track.path.leader.position.to(position)
        if moved > JUMP + rms + track.rms + MAX_LEADER_SPEED * min(track.age(now), STALE):
            self.host.count("leader_jump", f"{moved:.1f} m in {track.age(now):.2f} s")
            return
        track.rms = rms
        track.path.extend(position, heading, now)

    def _meet(self, leader: PlanarPoint, rms: float) -> None:
        """Begin the path at the vehicle, with a straight line to where the leader is."""
        pose, _ = self._own()
        own = PlanarPoint(pose.x, pose.y)
        distance, _ = own.to(leader)
        if distance > self.settings.maximum:
            problem = f"its leader is {distance:.1f} m away; the bound is {self.settings.maximum:.1f} m"
            self.host.count("following_ended", problem)
            self._requests.end()
            self._end(problem)
            return
        self._track = LeaderTrack(LeaderPath(own, leader, self.host.now), rms)

    def _own(self) -> tuple[Pose, float]:
        """The vehicle's pose in the world, as its position on the globe says, and the error of that in metres."""
        localization = self.vehicle.localization
        return self.vehicle.pose_on_globe, 0.0 if localization is None else localization.state().globe.position_rms


def _given(value: float | None, default: float) -> float:
    return default if value is None else value


def _pose_in(content: Message | bytes) -> ReportGlobalPose | None:
    if isinstance(content, ReportGlobalPose):
        return content
    payload = content.encode(strict=False) if isinstance(content, Message) else bytes(content)
    try:
        return ReportGlobalPose.decode(payload)
    except DecodeError:
        return None
