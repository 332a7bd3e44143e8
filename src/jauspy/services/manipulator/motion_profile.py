"""ManipulatorJointMotionProfile: limits of speed and acceleration for all drivers of the arm (AS6057)."""

from __future__ import annotations

from jauspy.geometry.denavit_hartenberg import DHLink
from jauspy.messages.manipulator import ReportJointMotionProfile, SetJointMotionProfile
from jauspy.services.manipulator.arm import Arm, Profile
from jauspy.services.service import Service


class JointMotionProfile(Service, urn="urn:jaus:jss:manipulator:ManipulatorJointMotionProfile"):
    """rad/s and rad/s^2, or m/s and m/s^2. Never beyond what the joints allow; they count from the next command on."""

    def __init__(self, arm: Arm) -> None:
        self._arm = arm

    def motion_profile_exists(self) -> bool:
        """There always is one: the joints' own limits, until a client sets others."""
        return True

    def set_joint_motion_profile(self, msg: SetJointMotionProfile) -> None:
        """Ignored, and counted, unless there is a profile of the right kind for each joint."""
        records, links = msg.joint_motion_profile_list, self._arm.geometry.links
        revolute = [isinstance(record, SetJointMotionProfile.RevoluteJointMotionProfileRec) for record in records]
        if revolute != [link.is_revolute for link in links]:
            self.host.count("wrong_joints", f"{msg}")
            return
        self._arm.profiles = tuple(
            within(
                Profile(r.joint_max_speed, r.joint_max_acceleration_rate, r.joint_max_deceleration_rate),
                Profile.of(link.joint),
            )
            for r, link in zip(records, links, strict=True)
        )

    def report_joint_motion_profile(self) -> ReportJointMotionProfile:
        """What counts now."""
        rows = zip(self._arm.profiles, self._arm.geometry.links, strict=True)
        return ReportJointMotionProfile([_record(profile, link) for profile, link in rows])


def within(profile: Profile, most: Profile) -> Profile:
    """A profile that the joint can follow; zero would mean never to move, and counts as no wish."""
    return Profile(
        min(profile.speed or most.speed, most.speed),
        min(profile.acceleration or most.acceleration, most.acceleration),
        min(profile.deceleration or most.deceleration, most.deceleration),
    )


def _record(
    profile: Profile, link: DHLink
) -> ReportJointMotionProfile.RevoluteJointMotionProfileRec | ReportJointMotionProfile.PrismaticJointMotionProfileRec:
    values = (profile.speed, profile.acceleration, profile.deceleration)
    if link.is_revolute:
        return ReportJointMotionProfile.RevoluteJointMotionProfileRec(*values)
    return ReportJointMotionProfile.PrismaticJointMotionProfileRec(*values)
