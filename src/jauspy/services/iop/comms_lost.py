"""CommsLostPolicyManager: what a robot does once the link to its client is lost (IOP v3).

See docs/adr/0183-lost-links.md.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from enum import Enum, auto
from typing import Any, Final, TypeAlias

from jauspy.geometry.poses import jaus_twist
from jauspy.ids import JausID
from jauspy.logs import get_logger
from jauspy.messages.iop import (
    ReportCommsLostCapabilities,
    ReportCommsLostConfiguration,
    ReportCommsLostStatus,
    SetCommsLostPolicy,
    SetCommsLostPolicyResponse,
)
from jauspy.messages.mobility.v1_0.types import GlobalWaypointRec
from jauspy.services.core.access_control import AccessControl, may_move, waits_for_control
from jauspy.services.iop.retrotraverse import RetraceRequest, Retrotraverse, StallWatch, waypoint_of
from jauspy.services.mobility.courses import BoundedCourse, WaypointCourse
from jauspy.services.mobility.driver import Driver
from jauspy.services.mobility.retraced_joints import OwnMotion
from jauspy.services.mobility.vehicle import Vehicle
from jauspy.services.mobility.waypoint_drivers import goal_of

_LOG: Final = get_logger("jauspy.mobility")

PERIOD: Final = 0.1
"""Seconds between two looks at the link."""
SHORTEST_TIMEOUT: Final = 4
"""Seconds; a client that is idle lets itself be heard every two seconds or so, and packets get lost."""
TOO_SHORT: Final = (
    f"too short: an idle client may be silent for {SHORTEST_TIMEOUT} s; give {SHORTEST_TIMEOUT} or more, or 0 for as "
    "soon as control has ended"
)
"""What is said of shorter ones, from 1 s on, in files and by the client API; those of other clients are taken over."""
CONTACT_GAP: Final = 2.0
"""Seconds without a message, at least, that interrupt a contact which is to show that the link works again."""
STANDING_TIME: Final = 0.5
"""Seconds for which the robot stands before a reaction moves it."""
STANDING_SPEED: Final = 0.03
"""m/s and rad/s below which it stands."""
MAX_RANGE: Final = 20_000.0
"""Metres to a waypoint, at most: farther ones are mistakes, and the plane of the local frame does not reach them."""


@dataclass(frozen=True, slots=True)
class StopMotion:
    """Stay where it has stopped."""


@dataclass(frozen=True, slots=True)
class ContinueMission:
    """Go on to the waypoint, along the list of waypoints or back along the path."""


@dataclass(frozen=True, slots=True)
class MoveToPosition:
    """Drive straight to a point of the globe, at m/s, and halt after `max_distance` metres; 0 is unlimited."""

    waypoint: GlobalWaypointRec
    speed: float
    max_distance: float = 0.0


Reaction: TypeAlias = StopMotion | ContinueMission | MoveToPosition | RetraceRequest
"""Reaction to a lost link; a `RetraceRequest` drives back."""
_ACTIONS: Final[Mapping[type[Reaction], str]] = {
    StopMotion: "stays where it has stopped",
    ContinueMission: "goes on with what it was doing",
    MoveToPosition: "drives to a waypoint",
    RetraceRequest: "drives back",
}
"""Reactions in log lines."""


@dataclass(frozen=True, slots=True)
class CommsLostPolicy:
    """Seconds of silence after which the link is lost, what to do then, and when the link is back.

    A `timeout` of 0 is that of access control. The link is back after `regained_timeout` seconds of contact.
    """

    timeout: int = 0
    reaction: Reaction = StopMotion()
    regained_timeout: int = 0
    stops_when_regained: bool = True
    """False to go on until a client takes control."""


class _Link(Enum):
    UNWATCHED = auto()
    """Nobody has control, or the last client has given it back."""
    WATCHED = auto()
    """A client has control."""
    SILENT = auto()
    """The client has lost control by its silence, and the robot has stopped."""
    LOST = auto()
    """The reaction is carried out."""


class CommsLostPolicyManager(Driver, urn="urn:jaus:jss:iop:CommsLostPolicyManager"):
    """Watches the client in control, and reacts to its silence by the policy that it set.

    Control always ends first, and with it all motion. Then the policy moves the robot, if it was ready to be driven
    before, until the link is back or any client takes control. A policy is that of the client that set it; others have
    the `default`. `own_motion` is told which parts the reaction moves: `part`, which the vehicle is, and flippers.
    """

    def __init__(
        self,
        vehicle: Vehicle,
        *,
        default: CommsLostPolicy | None = None,
        part: str = "chassis",
        own_motion: OwnMotion | None = None,
    ) -> None:
        super().__init__(vehicle)
        self._part = part
        self._default = default or CommsLostPolicy()
        self._own_motion = own_motion or OwnMotion()
        self.policy = self._default
        """The present policy."""
        self._policy_of: JausID | None = None
        """The client that set it."""
        self._link = _Link.UNWATCHED
        self._client: JausID | None = None
        """The client in control, or the one whose control has ended by its silence."""
        self._heard = -math.inf
        """When it was heard last."""
        self._contact: float | None = None
        """When the contact began that may show that the link is back; None before it."""
        self._is_known_back = False
        """True once the reaction goes on although the link is back."""
        self._was_ready = False
        self._mission: Callable[[], None] | None = None
        self._stood: float | None = None
        """Since when the robot stands; None when the reaction does not wait for it."""
        self._stall: StallWatch | None = None
        """Watches the motion of the reaction; None without one."""

    def attached(self) -> None:
        """Listen to clients."""
        super().attached()
        self.host.heard_by.append(self._on_heard)
        self.host.repeat(self._check, PERIOD, self._check)

    # --- the link

    def _on_heard(self, client: JausID) -> None:
        if client != self._client:
            return
        now = self.host.now
        if self._contact is None or now - self._heard > max(CONTACT_GAP, self._silence):
            self._contact = now
        self._heard = now

    def control_taken(self) -> None:
        """Stop the motion of the reaction, and watch the client."""
        self._watch(self.host.controller)

    def control_lost(self) -> None:
        """Stop. A client that is silent has lost the link; one that has just been heard has given control back."""
        super().control_lost()
        if self.host.controller is not None:
            self._watch(self.host.controller)
        elif self._client is None or self._heard == self.host.now:
            self._rest()
        else:
            self._end_motion()
            self._link, self._contact, self._is_known_back = _Link.SILENT, None, False

    def leaving(self) -> None:
        """The component ends: there is no link to be watched."""
        self._rest()

    def _watch(self, client: JausID | None) -> None:
        self._end_motion()
        if client != self._policy_of:
            self.policy, self._policy_of = self._default, None
        self._client, self._link, self._heard = client, _Link.WATCHED, self.host.now
        self._mission, self._was_ready = None, False

    def _rest(self) -> None:
        self._end_motion()
        self._client, self._link = None, _Link.UNWATCHED

    def _check(self) -> None:
        if self._link is _Link.WATCHED:
            self._check_client()
        elif self._link is not _Link.UNWATCHED and not waits_for_control(self.host):
            self._rest()  # an emergency, or a failure
        elif self._link is _Link.SILENT:
            if self._is_back():
                self.host.fire("CommsRestored")
            elif self.host.now - self._heard >= self._silence:
                self.host.fire("CommsLost")
        elif self._link is _Link.LOST:
            self._check_reaction()

    def _check_client(self) -> None:
        """Note what the robot does; end the control of a client that is silent too long for its own policy."""
        self._was_ready = may_move(self.host)
        driver = self.vehicle.pilot.driver
        self._mission = driver.resumption() if isinstance(driver, Driver) else None
        is_lost = self.policy.timeout and self.host.now - self._heard >= self.policy.timeout
        access, client = self.host.service(AccessControl), self._client
        if is_lost and access is not None and client is not None:
            access.client_lost(client)

    @property
    def _silence(self) -> float:
        """Seconds without a message after which the link is lost."""
        access = self.host.service(AccessControl)
        return self.policy.timeout or (access.timeout if access is not None else 0)

    def _is_back(self) -> bool:
        """True once the client, which has no control any more, was heard for long enough."""
        if self._is_known_back or self._contact is None:
            return False
        return self._heard - self._contact >= self.policy.regained_timeout

    # --- reactions

    def execute_comms_lost_policy(self) -> None:
        """Wait until the robot stands, then carry out the reaction; called by the event CommsLost."""
        if self._link is not _Link.SILENT:
            return
        silence, action = self.host.now - self._heard, _ACTIONS[type(self.policy.reaction)]
        self.host.count("comms_lost", f"{self._client} is silent for {silence:.1f} s: it {action}")
        _LOG.warning("%s: nothing heard of %s for %.1f s: it %s", self.host.id, self._client, silence, action)
        self._link = _Link.LOST
        self._stood = self.host.now if self._was_ready else None

    def execute_comms_regained_policy(self) -> None:
        """Stop, unless the policy says otherwise; called by the event CommsRestored."""
        _LOG.info("%s: the link to %s is back", self.host.id, self._client)
        if self._link is _Link.SILENT or self.policy.stops_when_regained:
            self._rest()
        elif self._link is _Link.LOST:
            self._is_known_back = True  # the reaction ends by control

    def _check_reaction(self) -> None:
        now = self.host.now
        if self._is_back():
            self.host.fire("CommsRestored")
        elif self._stall is not None:
            if self.vehicle.pilot.driver is None:
                self._end_motion()
            elif self._stall.is_stalled(self.vehicle.pose, now):
                self.host.count("comms_lost_stalled", "the robot does not get on: it stops")
                _LOG.warning("%s: the robot does not get on: it stops", self.host.id)
                self._end_motion()
        elif self._stood is not None:
            twist = jaus_twist(self.vehicle.drive.twist())
            if max(abs(twist.vx), abs(twist.vy), abs(twist.wz)) > STANDING_SPEED:
                self._stood = now
            elif now - self._stood >= STANDING_TIME:
                self._stood = None
                self._begin_motion()

    def _begin_motion(self) -> None:
        retrotraverse = self.host.service(Retrotraverse)
        joints = retrotraverse.joints if retrotraverse is not None else None
        parts = {self._part} if joints is None else {self._part, joints.part}
        self._own_motion.parts = frozenset(parts - self._own_motion.controlled)
        reaction = self.policy.reaction
        if isinstance(reaction, ContinueMission) and self._mission is not None:
            self._mission()
        elif isinstance(reaction, MoveToPosition):
            self._move_to(reaction)
        elif isinstance(reaction, RetraceRequest) and retrotraverse is not None:
            retrotraverse.begin(reaction, by_itself=True)
        if self.vehicle.pilot.driver is None:
            self._own_motion.parts = frozenset()
        else:
            self._stall = StallWatch()

    def _move_to(self, reaction: MoveToPosition) -> None:
        chassis, waypoint = self.vehicle.chassis, waypoint_of(reaction.waypoint)
        course = WaypointCourse(
            lambda: goal_of(self.vehicle, waypoint, is_last=True),
            lambda: reaction.speed,
            deceleration=chassis.deceleration,
            max_turn_rate=chassis.max_turn_rate,
            min_turn_radius=chassis.min_turn_radius,
        )
        self.vehicle.pilot.follow(self, BoundedCourse(course, reaction.max_distance or math.inf))

    def _end_motion(self) -> None:
        """Stop the motion of the reaction."""
        self._stood = None
        if self._stall is not None:
            self._stall = None
            self.vehicle.pilot.stop()
        self._own_motion.parts = frozenset()

    # --- predicates and actions

    def is_supported_command(self, msg: SetCommsLostPolicy) -> bool:
        """True if the robot can carry out the policy."""
        policy = policy_of(msg)
        if policy is None:
            return False
        reaction, retrotraverse = policy.reaction, self.host.service(Retrotraverse)
        if isinstance(reaction, RetraceRequest):
            has_way = reaction.distance > 0.0 or reaction.waypoint is not None
            is_near = reaction.waypoint is None or self._is_in_range(reaction.waypoint)
            return retrotraverse is not None and has_way and is_near and retrotraverse.supports(reaction)
        if isinstance(reaction, MoveToPosition):
            return reaction.speed > 0.0 and self._is_in_range(reaction.waypoint)
        return True

    def _is_in_range(self, waypoint: GlobalWaypointRec) -> bool:
        if not self.vehicle.has_origin:
            return False
        point, pose = self.vehicle.point_on_globe(waypoint.latitude, waypoint.longitude), self.vehicle.pose
        return math.hypot(point.x - pose.x, point.y - pose.y) <= MAX_RANGE

    def set_comms_lost_policy(self, msg: SetCommsLostPolicy) -> None:
        """Take over the policy."""
        policy = policy_of(msg)
        assert policy is not None
        self.policy, self._policy_of = policy, self.host.controller

    def send_set_comms_lost_policy_response(self, msg: SetCommsLostPolicy) -> SetCommsLostPolicyResponse:
        """Whether the policy is taken over (C411)."""
        results = SetCommsLostPolicyResponse.CommsLostResult
        result = results.SUCCESS if self.is_supported_command(msg) else results.NOT_SUPPORTED
        return SetCommsLostPolicyResponse(msg.policy_rec.local_id, result)

    # --- reports

    def send_report_comms_lost_capabilities(self) -> ReportCommsLostCapabilities:
        """Reactions that the robot can carry out (C412)."""
        return ReportCommsLostCapabilities(
            ReportCommsLostCapabilities.SupportedBehaviors(
                stop=1,
                continue_mission=1,
                move_to_pos=int(self.vehicle.has_origin),
                retrotraverse=int(self.host.service(Retrotraverse) is not None),
            )
        )

    def send_report_comms_lost_configuration(self) -> ReportCommsLostConfiguration:
        """The present policy, without that for a link that is back, for which there are no fields (C413)."""
        return ReportCommsLostConfiguration(
            ReportCommsLostConfiguration.CommsLostDetectionRec(self.policy.timeout),
            reaction_record(ReportCommsLostConfiguration, self.policy.reaction),
        )

    def send_report_comms_lost_status(self) -> ReportCommsLostStatus:
        """Enabled while a client is watched, active from the loss of its link on (C414)."""
        states = ReportCommsLostStatus.CommsLostStatus
        state = {_Link.UNWATCHED: states.DISABLED, _Link.LOST: states.ACTIVE}.get(self._link, states.ENABLED)
        return ReportCommsLostStatus(state)


def policy_of(msg: SetCommsLostPolicy) -> CommsLostPolicy | None:
    """The policy of a message; None for a reaction to the return of the link that is not known."""
    regained = msg.comms_regained_seq.comms_regained_rec
    behaviors = SetCommsLostPolicy.CommsRegainedBehavior
    if regained.comms_regained_behavior not in tuple(behaviors):
        return None
    variant = msg.comms_lost_seq.comms_lost_policy_var
    reaction: Reaction = StopMotion()
    if isinstance(variant, SetCommsLostPolicy.ContinueMissionVar):
        reaction = ContinueMission()
    elif isinstance(variant, SetCommsLostPolicy.MoveToPosSeq):
        speed, distance = variant.travel_speed_rec.speed, variant.max_distance_rec.max_distance
        reaction = MoveToPosition(variant.global_waypoint_rec, speed, distance)
    elif isinstance(variant, SetCommsLostPolicy.RetrotraverseParameterSeq):
        reaction = RetraceRequest.of(variant.retrotraverse_action_rec, variant.global_waypoint_rec)
    return CommsLostPolicy(
        timeout=msg.comms_lost_seq.comms_lost_detection_rec.comms_lost_timeout,
        reaction=reaction,
        regained_timeout=regained.comms_regained_timeout,
        stops_when_regained=regained.comms_regained_behavior == behaviors.STOP_MOTION,
    )


def reaction_record(message: Any, reaction: Reaction) -> Any:
    """The variant of a class of messages, SetCommsLostPolicy or ReportCommsLostConfiguration, for a reaction."""
    if isinstance(reaction, RetraceRequest):
        return message.RetrotraverseParameterSeq(reaction.action(message), reaction.waypoint)
    if isinstance(reaction, MoveToPosition):
        return message.MoveToPosSeq(
            reaction.waypoint, message.TravelSpeedRec(reaction.speed), message.MaxDistanceRec(reaction.max_distance)
        )
    return message.ContinueMissionVar(0) if isinstance(reaction, ContinueMission) else message.StopMotionVar(0)
