"""The guard against self collision: scales the speeds of joints so that they can stop before links touch.

Several times a second it computes where the joints would come to rest if they followed their commands, at several
shares of the commanded speeds, and then braked; the greatest share is taken at which no pair of links comes nearer than
the set distance. Needs numpy.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from jauspy.geometry.link_boxes import LinkBoxes
from jauspy.geometry.posture_clearances import PostureClearances
from jauspy.geometry.urdf import Joint
from jauspy.platform.description import RobotModel, SelfCollisionSetup
from jauspy.platform.guards import GuardState, SelfCollisionGuard
from jauspy.platform.joint_control import ACCELERATION_TIME
from jauspy.platform.joints import ControlMode, JointGroup, JointState, Target

if TYPE_CHECKING:
    from numpy.typing import NDArray

PERIOD: Final = 0.008
"""Seconds between two checks while joints move."""
IDLE_PERIOD: Final = 0.2
"""Seconds between two checks while all joints stand."""
DELAY: Final = 0.04
"""Seconds from a check until a changed command brakes: the period, the controllers' period, and their lag."""
SHARES: Final = (0.1, 0.3, 0.6, 1.0)
"""Shares of the commanded speeds that are checked, ascending."""
TIGHT: Final = 0.6
"""Share of the set distance at which joints that move faster than they were told to brake fully."""
CREEP: Final = 0.02
"""Share below which joints stand."""
LEAST_CHANGE: Final = 0.02
"""Change of a share with which commands are given again."""
SLIGHT: Final = 1e-6
"""Metres by which a pair that is too close already may come nearer in rounding."""
NEAR: Final = 0.05
"""Metres within which clearances are exact; beyond, they are at least those of bounding spheres."""
STANDSTILL: Final = 0.005
"""Radians or metres per second below which a joint stands."""
ARRIVED: Final = 0.003
"""Radians or metres to the end of its motion below which a joint counts as standing, in the choice of the period."""
STEP: Final = 0.002
"""Seconds between two checks, at least."""
SETTLING: Final = 0.15
"""Seconds after a stop of joints that forces moved, before their efforts are those that hold them."""
LEAST_PUSH: Final = 0.1
"""Share of its greatest speed that a joint is expected to reach by the slightest force."""
SLOWEST: Final = 1e-6
"""Speed of a joint on its way to a position that is to stand, rad/s or m/s; zero would be no limit."""


class GuardedJoints:
    """A `JointGroup` whose commands pass a guard."""

    def __init__(self, group: JointGroup, guard: JointGuard) -> None:
        self._group = group
        self._guard = guard
        self.joints = group.joints
        """The joints that move, base to tip."""
        self.chain = group.chain
        """All joints from base to tip, fixed ones included."""
        self.wanted: list[Target | None] = [None] * len(group.joints)
        """The commands that are followed; None for joints that hold."""
        self.share = 1.0
        """Share of the commanded speeds that they follow."""
        self.is_new = False
        """True for commands that were not given to the joints yet."""
        self.pair = 0
        """The pair of links that slowed them down last."""
        self.stopped = 0.0
        """The robot's time at which the guard stopped the joints last."""

    def command(self, targets: Sequence[Target | None]) -> None:
        """Set the targets of the joints; the guard gives them to the joints before the next step."""
        for number, target in enumerate(targets):
            if target is not None:
                stops = target.compensated and not target.value
                self.wanted[number] = None if stops else target
        if self._guard.enabled:
            stops_only = [t if t is not None and t.compensated and not t.value else None for t in targets]
            if any(stops_only):
                self._group.command(stops_only)
            self.is_new = True
        else:
            self._group.command(targets)

    def hold(self) -> None:
        """Stop, and hold the present positions."""
        self.wanted = [None] * len(self.joints)
        self.share, self.is_new = 1.0, False
        self._group.hold()

    def state(self) -> JointState:
        """Positions, velocities and efforts after the last step."""
        return self._group.state()

    @property
    def is_free(self) -> bool:
        """True while forces that nothing compensates move the joints, so that no speeds are commanded."""
        return any(target is not None and _is_free(target) for target in self.wanted)

    def follow(self, share: float) -> None:
        """Give the commands to the joints, at a share of their speeds."""
        self.share, self.is_new = share, False
        if any(self.wanted):
            rows = zip(self.wanted, self.joints, strict=True)
            self._group.command([None if target is None else scaled(target, joint, share) for target, joint in rows])


def _is_free(target: Target) -> bool:
    return target.mode is ControlMode.EFFORT and not target.compensated


def scaled(target: Target, joint: Joint, share: float) -> Target:
    """The target at a share of its speed; at less than the whole, the joint brakes as fast as it can."""
    if share >= 1.0:
        return target
    if target.mode is ControlMode.EFFORT:
        if not target.compensated or not share:
            return Target(ControlMode.EFFORT, 0.0, compensated=True)  # hold
        return replace(target, speed=share * _speed(target, joint), deceleration=None)
    if target.mode is ControlMode.VELOCITY:
        return replace(target, value=share * _limited(target.value, joint.velocity), deceleration=None)
    return replace(target, speed=max(SLOWEST, share * _speed(target, joint)), deceleration=None)


def _speed(target: Target, joint: Joint) -> float:
    return min(joint.velocity, target.speed or math.inf)


def _limited(value: float, limit: float) -> float:
    return min(limit, max(-limit, value))


@dataclass(frozen=True, slots=True)
class _Motion:
    """The motion that a joint is about to make."""

    velocity: float
    """Commanded velocity, rad/s or m/s."""
    way: float = math.inf
    """Radians or metres to the end of the motion."""
    push: float = 0.0
    """Velocity to which a force would soon bring the joint, which holds; the motions of other joints are unknown."""


class JointGuard(SelfCollisionGuard):
    """The guard of one robot's joint groups; `groups` are to be used in place of those that it was made with."""

    def __init__(self, robot: RobotModel, setup: SelfCollisionSetup, groups: Mapping[str, JointGroup]) -> None:
        self.groups = {name: GuardedJoints(group, self) for name, group in groups.items()}
        """The groups, whose commands pass this guard."""
        self._setup = setup
        self.enabled = setup.enabled
        """True while it checks commands."""
        joints = [joint for group in self.groups.values() for joint in group.joints]
        starts = {
            name: start
            for group in robot.groups.values()
            for name, start in zip(group.joints, group.start, strict=True)
        }
        self._clearances = PostureClearances(LinkBoxes(robot.description, [joint.name for joint in joints]), starts)
        self._brakes = np.array([joint.velocity / ACCELERATION_TIME for joint in joints])
        owners = {joint.name: name for name, group in self.groups.items() for joint in group.joints}
        moved = [{owners[joint] for joint in self._clearances.movers(n)} for n in range(len(self._clearances))]
        self._members = {name: np.flatnonzero([name in names for names in moved]) for name in self.groups}
        """The pairs that each group moves."""
        self._due = self._checked = 0.0
        self._velocities = [0.0] * len(joints)
        """Velocities in the last check."""
        self._state = GuardState(self.enabled)

    @property
    def can_guard(self) -> bool:
        """True if the robot has links that can touch each other."""
        return len(self._clearances) > 0

    def state(self) -> GuardState:
        """The state after the last check."""
        return self._state

    def enable(self, enabled: bool) -> None:
        """Switch it on or off; off, the commands are followed as they were given."""
        if enabled == self.enabled:
            return
        self.enabled = enabled
        self._state = GuardState(enabled)
        for group in self.groups.values():
            if enabled:
                group.is_new = any(group.wanted)
            elif group.share < 1.0 or group.is_new:
                group.follow(1.0)

    def step(self, now: float) -> None:
        """Check the commands, if a check is due; `now` is the robot's time, in seconds."""
        is_new = any(group.is_new for group in self.groups.values())
        if not self.enabled or (now < self._due and not is_new):
            return
        states = [group.state() for group in self.groups.values()]
        velocities = [velocity for state in states for velocity in state.velocities]
        motions = self._motions(states, now)
        moves = (
            any(motion.velocity and motion.way > ARRIVED for motion in motions)
            or any(motion.push for motion in motions)
            or max(map(abs, velocities), default=0.0) > STANDSTILL
        )
        self._due = now + (PERIOD if moves else IDLE_PERIOD)
        self._checked, self._velocities = now, velocities
        self._apply(now, *self._shares([p for state in states for p in state.positions], velocities, motions))

    def _motions(self, states: Sequence[JointState], now: float) -> list[_Motion]:
        elapsed = max(now - self._checked, STEP)
        before = iter(self._velocities)
        found = []
        for group, state in zip(self.groups.values(), states, strict=True):
            for number, target in enumerate(group.wanted):
                joint, velocity, last = group.joints[number], state.velocities[number], next(before)
                if target is None or not _is_free(target):
                    found.append(_motion(target, joint, state.positions[number]))
                elif group.share < 1.0 or group.is_new:
                    push = target.value - state.efforts[number]
                    found.append(
                        _Motion(0.0, push=math.copysign(max(LEAST_PUSH, _part(push, joint)), push) * joint.velocity)
                    )
                else:
                    faster = velocity + (velocity - last) / elapsed * DELAY
                    found.append(_Motion(_limited(faster, joint.velocity)))
        return found

    def _shares(
        self, positions: Sequence[float], velocities: Sequence[float], motions: Sequence[_Motion]
    ) -> tuple[NDArray[np.floating[Any]], NDArray[np.floating[Any]]]:
        """For each pair the share of the speeds at which it stays apart, and its clearance now."""
        here, speeds = np.array(positions), np.array(velocities)
        wanted = np.array([motion.velocity for motion in motions])
        ways = np.array([motion.way for motion in motions])
        postures = [here, here + _stopping(speeds, self._brakes)]
        for share in SHARES:
            row = _stopping(share * wanted, self._brakes)
            postures.append(here + np.sign(row) * np.minimum(np.abs(row), ways))
        for number, motion in enumerate(motions):
            if motion.push:
                postures.append(here.copy())
                postures[-1][number] += float(_stopping(np.array(motion.push), self._brakes[number]))
        found = self._clearances.at(np.array(postures), near=NEAR)
        now, at_rest, ahead = found[0], found[1], np.vstack((found[:1], found[2 : len(SHARES) + 2]))
        pushed = found[len(SHARES) + 2 :]
        least = np.minimum(self._setup.distance, now) - SLIGHT
        is_safe = np.logical_and.accumulate(ahead >= least, axis=0)
        last = is_safe.sum(axis=0) - 1  # the greatest share that is safe
        shares = np.array((0.0, *SHARES))
        after = np.minimum(last + 1, len(SHARES))
        columns = np.arange(len(now))
        fall = ahead[last, columns] - ahead[after, columns]
        part = np.where(fall > 0.0, (ahead[last, columns] - least) / np.where(fall > 0.0, fall, 1.0), 0.0)
        allowed = shares[last] + np.minimum(1.0, part) * (shares[after] - shares[last])
        allowed[last == len(SHARES)] = 1.0
        allowed[at_rest < np.minimum(TIGHT * self._setup.distance, now) - SLIGHT] = 0.0
        allowed[(pushed < least).any(axis=0)] = 0.0
        return allowed, now

    def _apply(self, time: float, allowed: NDArray[np.floating[Any]], now: NDArray[np.floating[Any]]) -> None:
        active, problem = False, self._state.problem
        for name, group in self.groups.items():
            pairs = self._members[name]
            if not any(group.wanted) or not len(pairs):
                if group.is_new:
                    group.follow(1.0)
                continue
            tightest = pairs[np.lexsort((now[pairs], allowed[pairs]))[0]]
            share = float(allowed[tightest])
            if share < 1.0:
                group.pair = int(tightest)
            if share < CREEP or (group.is_free and (share < 1.0 or not self._has_settled(group, time))):
                share = 0.0
            if share < 1.0:
                active = True
            elif _names(problem) == name:
                problem = ""
            if not share:
                problem = self._sentence(name, group.pair, float(now[group.pair]))
            ends = share in (0.0, 1.0) and share != group.share
            if group.is_new or ends or abs(share - group.share) > LEAST_CHANGE:
                if not share and group.share:
                    group.stopped = time
                group.follow(share)
        self._state = GuardState(True, active, float(now.min()) if len(now) else math.inf, problem)

    def _has_settled(self, group: GuardedJoints, time: float) -> bool:
        """False while joints that forces moved are being stopped: their efforts are then those of the brake."""
        return group.share >= 1.0 or (
            time - group.stopped > SETTLING and max(map(abs, group.state().velocities)) < STANDSTILL
        )

    def _sentence(self, group: str, pair: int, distance: float) -> str:
        one, other = self._clearances.pair(pair)
        return (
            f"{group}: {one} is {max(0.0, distance) * 1000.0:.0f} mm from {other}: it stops before they touch; "
            "command it another way"
        )


def _names(problem: str) -> str:
    """The group that a sentence is about."""
    return problem.partition(":")[0]


def _motion(target: Target | None, joint: Joint, position: float) -> _Motion:
    """The motion that a joint is about to make at the whole of its commanded speed."""
    if target is None:
        return _Motion(0.0)
    if target.mode is ControlMode.VELOCITY:
        return _Motion(_limited(target.value, joint.velocity))
    if target.mode is ControlMode.POSITION:
        way = min(joint.upper, max(joint.lower, target.value)) - position
        return _Motion(math.copysign(_speed(target, joint), way) if way else 0.0, abs(way))
    return _Motion(math.copysign(_part(target.value, joint), target.value) * _speed(target, joint))


def _part(effort: float, joint: Joint) -> float:
    """The share, 0..1, of a joint's greatest effort."""
    return min(1.0, abs(effort) / joint.effort) if joint.effort else 0.0


def _stopping(velocities: NDArray[np.floating[Any]], brakes: NDArray[np.floating[Any]]) -> NDArray[np.floating[Any]]:
    """The ways to a stop, with the delay until the joints brake."""
    found: NDArray[np.floating[Any]] = velocities * DELAY + velocities * np.abs(velocities) / (2.0 * brakes)
    return found
