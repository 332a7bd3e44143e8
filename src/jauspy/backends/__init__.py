"""Finds backends by name, and checks their robots against the contract.

Packages announce backends in the entry-point group `jauspy.backends`. Checked are methods, types, lengths and numbers.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping
from dataclasses import fields
from importlib.metadata import EntryPoint, entry_points
from typing import Final, cast

from jauspy.errors import ConfigError
from jauspy.geometry.poses import Acceleration, Pose, Twist
from jauspy.platform.backend import Backend
from jauspy.platform.contract import DriveBase, Robot, Snapshot
from jauspy.platform.guarded_robot import GuardedRobot
from jauspy.platform.joints import JointGroup, JointState

GROUP: Final = "jauspy.backends"


def names() -> list[str]:
    """The backends that are installed, sorted; one may still lack a package that it needs."""
    return sorted({entry.name for entry in entry_points(group=GROUP)})


def find(name: str) -> Backend:
    """Return the backend of that name. Raises `ConfigError` with the installed backends, or with a missing package."""
    matches = entry_points(group=GROUP, name=name)
    if not matches:
        raise ConfigError(f"no backend {name!r}; installed are: {', '.join(names()) or 'none'}")
    return _load(next(iter(matches)))


def _load(entry: EntryPoint) -> Backend:
    try:
        factory = entry.load()
    except (ImportError, AttributeError) as error:
        raise ConfigError(f"backend {entry.name!r} ({entry.value}) cannot be loaded: {error}") from error
    return cast("Backend", factory())


def check_robot(robot: Robot) -> None:
    """Check a robot that a backend has opened. Raises `ConfigError` that names class, method and what is expected."""
    _check_members(robot, Robot, "the robot")
    _check_members(robot.drive, DriveBase, "its drive")
    for name in ("groups", "lidars", "force_torque", "cameras"):
        if not isinstance(found := getattr(robot, name), Mapping):
            raise ConfigError(
                f"{name} of the robot ({_named(robot)}) must be a mapping of parts by name, not {_type(found)}"
            )
    for name, group in robot.groups.items():
        _check_members(group, JointGroup, f"its group {name!r}")
    drive = robot.drive
    for method, kind in (("pose", Pose), ("twist", Twist), ("acceleration", Acceleration)):
        value = getattr(drive, method)()
        if not isinstance(value, kind):
            raise ConfigError(f"{_named(drive)}.{method}() returned {_type(value)}, not a {kind.__name__}")
    for group in robot.groups.values():
        if not isinstance(state := group.state(), JointState):
            raise ConfigError(f"{_named(group)}.state() returned {_type(state)}, not a JointState")
    if problem := state_problem(Snapshot.of(robot), robot):
        raise ConfigError(problem)


_ABSTRACT: Final = re.compile(r"Can't instantiate abstract class (\w+) .*?abstract methods? (.+)")


def missing_methods(error: Exception) -> str:
    """The methods that an incomplete backend lacks, as in `is incomplete: TrackDrive lacks pose(), twist(), ...`.

    Empty if `error` is another one than that of making an object of a class with abstract methods.
    """
    found = _ABSTRACT.match(str(error)) if isinstance(error, TypeError) else None
    if found is None:
        return ""
    methods = ", ".join(f"{name}()" for name in re.findall(r"\w+", found[2]))
    return f"is incomplete: {found[1]} lacks {methods}, which must be there (docs/own-backend.md)"


def state_problem(state: Snapshot, robot: Robot) -> str:
    """A text about invalid numbers in a state, with the method that returned them; empty if all are valid."""
    if _is_right(state, robot):
        return ""
    return next(_problems(state, robot.inner if isinstance(robot, GuardedRobot) else robot), "")


def _is_right(state: Snapshot, robot: Robot) -> bool:
    """A quick answer for each step; false also for finite numbers whose sum is none."""
    pose, twist, acceleration = state.pose, state.twist, state.acceleration
    total = pose.x + pose.y + pose.z + pose.roll + pose.pitch + pose.yaw
    total += twist.vx + twist.vy + twist.vz + twist.wx + twist.wy + twist.wz
    total += acceleration.ax + acceleration.ay + acceleration.az
    total += acceleration.wx + acceleration.wy + acceleration.wz
    for name, joints in state.joints.items():
        count = len(robot.groups[name].joints)
        if not len(joints.positions) == len(joints.velocities) == len(joints.efforts) == count:
            return False
        total += sum(joints.positions) + sum(joints.velocities) + sum(joints.efforts)
    return math.isfinite(total)


def _problems(state: Snapshot, robot: Robot) -> Iterator[str]:
    drive = _named(robot.drive)
    for method in ("pose", "twist", "acceleration"):
        value = getattr(state, method)
        for field in fields(value):
            if not math.isfinite(number := getattr(value, field.name)):
                yield f"{drive}.{method}() returned {field.name} = {number}"
    for name, joints in state.joints.items():
        group = robot.groups[name]
        method, count = f"{_named(group)}.state() of the group {name!r}", len(group.joints)
        for field in fields(joints):
            numbers = getattr(joints, field.name)
            if len(numbers) != count:
                yield f"{method} returned {len(numbers)} {field.name} for {count} joints"
            for joint, number in zip(group.joints, numbers, strict=False):
                if not math.isfinite(number):
                    yield f"{method} returned {number} in {field.name} for the joint {joint.name!r}"


def _check_members(part: object, contract: type, what: str) -> None:
    """Raise `ConfigError` if a part lacks a member of its contract."""
    members = {name: value for base in contract.__mro__ for name, value in vars(base).items() if name[0] != "_"}
    for name, member in sorted(members.items()):
        is_method = not isinstance(member, property)
        if not hasattr(part, name):
            called = f"method {name}()" if is_method else f"attribute {name}"
            does = ((member if is_method else member.fget).__doc__ or "").partition("\n")[0]
            raise ConfigError(f"{what} ({_named(part)}) has no {called}, which must be there: {does}")
        if is_method and not callable(found := getattr(part, name)):
            raise ConfigError(f"{name} of {what} ({_named(part)}) is {_type(found)}, and must be a method")


def _named(part: object) -> str:
    return type(part).__name__


def _type(value: object) -> str:
    return "None" if value is None else f"a {type(value).__name__}"
