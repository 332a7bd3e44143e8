"""PresetPose on a robot of each backend, on virtual time: requests, how they end, and who may make them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import pytest
from tests.robot.workcell import BACKENDS, CLIENT, OTHER, Workcell, outcomes

from jauspy.codec.message import Message
from jauspy.messages import iop, manipulator as m
from jauspy.messages.core import CreateCommandEvent, ReleaseControl, RequestControl, Resume, SetEmergency, Standby
from jauspy.platform.joints import ControlMode, Target
from jauspy.platform.named_poses import NamedPose

STOW, DRIVE, REACH_LOW, INSPECT = 1, 2, 3, 4
Status = iop.ReportTransitionCompleted.TransitionStatus


class PosedArm(Workcell):
    """A component with poses, and what it has reported of transitions."""

    def __init__(
        self,
        backend: str,
        component: int = 104,
        *,
        start: Mapping[str, Sequence[float]] | None = None,
        poses: Sequence[NamedPose] = (),
    ) -> None:
        super().__init__(backend, "inc1", component, start=start, poses=poses)
        self.ended: list[tuple[int, int]] = []
        """Request ids and status."""

    def note(self, messages: Sequence[Message]) -> None:
        kind = iop.ReportTransitionCompleted
        self.ended += [(report.request_id, report.transition_status) for report in messages if isinstance(report, kind)]

    def request(self, request_id: int, pose: int) -> None:
        self.note(self.tell(iop.SetCurrentPose(request_id, pose)))

    def wait(self, seconds: float = 10.0) -> None:
        """Wait for the next report of a transition."""
        count, end = len(self.ended), self.now + seconds
        while len(self.ended) == count:
            assert self.now < end, f"no report within {seconds} s"
            self.run(0.05)
            self.note(self.tell())

    @property
    def pose(self) -> Any:
        """The id of the pose, or the ids at both ends of a transition."""
        found = self.ask(iop.QueryCurrentPose()).report_current_pose_var
        if isinstance(found, iop.ReportCurrentPose.CurrentPoseRec):
            return found.current_state_id
        return found.start_state_id, found.end_state_id


@pytest.fixture(params=BACKENDS)
def arm(request: pytest.FixtureRequest) -> PosedArm:
    cell = PosedArm(request.param)
    cell.take_control()
    return cell


# --- reports


def test_reports_list_poses_and_the_positions_of_the_component(arm: PosedArm) -> None:
    poses = arm.ask(iop.QueryPresetPoseCapabilities()).pose_list
    names = [(pose.preset_pose_rec.pose_id, pose.preset_pose_rec.pose_name) for pose in poses]
    assert names == [(1, "stow"), (2, "drive"), (3, "reach_low"), (4, "inspect")]
    ends = [(row.start_pose_id, row.end_pose_id) for row in poses[1].transition_list]
    assert ends == [(2, 1), (2, 3), (2, 4)]
    first = arm.ask(iop.QueryPresetPoseSpecifications()).preset_pose_specifications_list[0]
    assert first.preset_pose_rec.pose_name == "stow"
    (positions,) = first.preset_positions_list
    id = positions.preset_positions_rec.jaus_id
    assert (id.subsystem_id, id.node_id, id.component_id) == (101, 1, 104)
    given = [record.joint_position.value for record in positions.preset_positions_var.joint_position_list]
    assert given == pytest.approx(arm.positions(), abs=0.01), "the arm starts in this pose"


def test_pose_that_is_held_and_transition_are_reported(arm: PosedArm) -> None:
    assert arm.pose == STOW
    arm.request(1, INSPECT)
    arm.run(0.3)
    assert arm.pose == (STOW, INSPECT)
    arm.wait()
    assert arm.pose == INSPECT
    arm.tell(m.SetJointEffort([m.JointEffortRec(joint_effort=20.0)] + [m.JointEffortRec(joint_effort=0.0)] * 4))
    arm.run(0.5)
    assert arm.pose == 255


# --- how a transition ends


@pytest.mark.slow
def test_completed_in_each_pose(arm: PosedArm) -> None:
    for request, pose in enumerate((REACH_LOW, DRIVE, INSPECT, STOW)):
        arm.request(request, pose)
        arm.wait()
        goal = arm.ask(iop.QueryPresetPoseSpecifications()).preset_pose_specifications_list[pose - 1]
        records = goal.preset_positions_list[0].preset_positions_var.joint_position_list
        assert arm.positions() == pytest.approx([record.joint_position.value for record in records], abs=0.012)
    assert arm.ended == [(number, Status.TRANSITION_COMPLETED) for number in range(4)]


@pytest.mark.slow
def test_all_joints_arrive_together(arm: PosedArm) -> None:
    """So that the way is a straight one, which is what was checked."""
    start = arm.positions()
    arm.request(1, REACH_LOW)
    goal = arm.ask(iop.QueryPresetPoseSpecifications()).preset_pose_specifications_list[REACH_LOW - 1]
    records = goal.preset_positions_list[0].preset_positions_var.joint_position_list
    ways = [record.joint_position.value - position for record, position in zip(records, start, strict=True)]
    spread = list[float]()

    def measure() -> None:
        rows = zip(arm.positions(), start, ways, strict=True)
        shares = [(position - begin) / way for position, begin, way in rows if abs(way) > 0.3]
        spread.append(max(shares) - min(shares))

    arm.run(2.5, measure)
    assert len(ways) - sum(abs(way) < 0.3 for way in ways) >= 2
    assert max(spread) < 0.03


def test_flippers_have_the_same_poses_under_the_same_ids() -> None:
    flippers = PosedArm("kinematic", 103)
    flippers.take_control()
    assert flippers.pose == STOW
    flippers.request(9, DRIVE)
    flippers.wait()
    assert flippers.ended == [(9, Status.TRANSITION_COMPLETED)]
    assert flippers.pose == DRIVE
    flippers.request(1, INSPECT)
    flippers.wait()
    assert flippers.pose == INSPECT, "which has the same angle as reach_low, and was reached last"


@pytest.mark.slow
def test_command_event_ends_with_the_transition(arm: PosedArm) -> None:
    command = CreateCommandEvent(1, 60, iop.SetCurrentPose(1, INSPECT))
    assert outcomes(arm, command) == []
    ends: list[int] = []
    arm.run(4.0, lambda: ends.extend(outcomes(arm)))
    assert ends == [0]
    assert outcomes(arm, CreateCommandEvent(2, 60, iop.SetCurrentPose(2, 77))) == [1]
    back = CreateCommandEvent(3, 60, iop.SetCurrentPose(3, STOW))
    assert outcomes(arm, back) == []
    assert outcomes(arm, Standby()) == [1]


@pytest.mark.parametrize("pose", [0, 5, 77, 254, 255])
def test_unknown_ids_are_refused_at_once(arm: PosedArm, pose: int) -> None:
    before = arm.positions()
    arm.request(200, pose)
    assert arm.ended == [(200, Status.UNRECOGNIZED_POSE)]
    arm.run(0.5)
    assert arm.positions() == pytest.approx(before, abs=0.005)
    assert arm.pose == STOW


@pytest.mark.slow
def test_another_pose_preempts_the_motion_that_is_reported_as_failed(arm: PosedArm) -> None:
    arm.request(1, REACH_LOW)
    arm.run(1.0)
    arm.request(2, STOW)
    assert arm.ended == [(1, Status.TRANSITION_FAILED)]
    assert arm.pose == (255, STOW)
    arm.wait()
    assert arm.ended == [(1, Status.TRANSITION_FAILED), (2, Status.TRANSITION_COMPLETED)]
    assert arm.pose == STOW


@pytest.mark.slow
def test_many_requests_at_once_leave_one_motion(arm: PosedArm) -> None:
    for number in range(200):
        arm.request(number, 1 + number % 4)
    assert arm.ended == [(number, Status.TRANSITION_FAILED) for number in range(199)]
    arm.wait()
    assert arm.ended[-1] == (199, Status.TRANSITION_COMPLETED)
    assert len(arm.ended) == 200
    assert len(arm.host._timers) <= 6


def test_command_of_another_service_preempts_the_motion(arm: PosedArm) -> None:
    arm.request(1, REACH_LOW)
    arm.run(0.5)
    arm.note(arm.tell(m.SetJointEffort([m.JointEffortRec(joint_effort=0.0)] * 5)))
    assert arm.ended == [(1, Status.TRANSITION_FAILED)]
    arm.run(0.5)
    assert arm.velocities() == pytest.approx([0.0] * 5, abs=0.02)
    assert arm.pose == 255


@pytest.mark.slow
@pytest.mark.parametrize(
    ("messages", "client"),
    [
        ([Standby()], None),
        ([SetEmergency(1)], OTHER),
        ([ReleaseControl()], None),
        ([RequestControl(250)], OTHER),
    ],
    ids=["standby", "emergency", "control released", "control taken"],
)
def test_the_motion_stops_and_is_not_resumed(arm: PosedArm, messages: list[Message], client: Any) -> None:
    arm.request(1, REACH_LOW)
    arm.run(1.0)
    assert max(map(abs, arm.velocities())) > 0.2
    arm.tell(*messages, **({} if client is None else {"client": client}))
    arm.run(0.3)
    stopped = arm.positions()
    assert arm.velocities() == pytest.approx([0.0] * 5, abs=0.03)
    assert arm.pose == 255
    arm.tell(Resume())
    arm.run(2.0)
    assert arm.positions() == pytest.approx(stopped, abs=0.02)


def test_control_that_times_out_stops_the_motion() -> None:
    arm = PosedArm("kinematic")
    arm.take_control()
    arm.request(1, REACH_LOW)
    arm.run(1.0)
    arm.host.unreachable(CLIENT, arm.now)
    arm.tell()
    assert arm.host.controller is None
    arm.run(1.0)
    assert arm.velocities() == pytest.approx([0.0] * 5, abs=1e-6)
    assert arm.pose == 255


def test_only_the_controlling_client_in_ready_moves_the_arm(arm: PosedArm) -> None:
    arm.note(arm.tell(iop.SetCurrentPose(1, INSPECT), client=OTHER))
    arm.run(0.5)
    assert arm.pose == STOW
    arm.tell(Standby())
    arm.request(1, INSPECT)
    arm.run(0.5)
    assert arm.ended == []
    assert arm.pose == STOW


def test_it_begins_at_rest_when_the_arm_moves(arm: PosedArm) -> None:
    make, choice = m.JointVelocityRec.JointVelocity, m.JointVelocityRec.JointVelocityChoice
    arm.tell(
        m.SetJointVelocity(
            [m.JointVelocityRec(make(choice.RADIAN_PER_SECOND, value)) for value in (0.6, -0.3, 0.0, 0.0, 1.0)]
        )
    )
    arm.run(0.8)
    arm.request(1, STOW)
    assert arm.pose == (255, STOW)
    arm.wait()
    assert arm.ended == [(1, Status.TRANSITION_COMPLETED)]


# --- no route, time-out, blocked


BESIDE_A_FLIPPER = 5
"""A pose in which the forearm is where the left flipper is at 0.4 to 0.7 rad."""


def arm_beside_a_flipper(flippers: float) -> PosedArm:
    names = [joint.name for joint in Workcell("kinematic", "inc1", 104).robot.groups["arm"].joints]
    pose = NamedPose(BESIDE_A_FLIPPER, "beside", dict(zip(names, (0.6, -0.05, 0.3, 0.0, 0.0), strict=True)))
    arm = PosedArm("kinematic", start={"flippers": (flippers,)}, poses=[pose])
    arm.take_control()
    return arm


def test_no_route_is_reported_as_an_invalid_transition(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("jauspy.geometry.joint_routes.MAX_CHECKS", 3)
    arm = PosedArm("kinematic")
    arm.take_control()
    arm.request(1, REACH_LOW)
    arm.wait()
    assert arm.ended == [(1, Status.INVALID_TRANSITION)]
    assert arm.pose == STOW
    assert arm.host.counters["pose_not_reached"] == 1


@pytest.mark.slow
def test_pose_in_which_the_flippers_are_now_is_refused_at_once() -> None:
    arm = arm_beside_a_flipper(0.5)
    arm.request(1, BESIDE_A_FLIPPER)
    assert arm.ended == [(1, Status.INVALID_TRANSITION)]
    arm.robot.groups["flippers"].command([Target(ControlMode.POSITION, 2.0)])
    arm.run(3.0)
    arm.request(2, BESIDE_A_FLIPPER)
    arm.wait()
    assert arm.ended[-1] == (2, Status.TRANSITION_COMPLETED)


def test_it_stops_when_other_joints_move_into_the_way() -> None:
    arm = arm_beside_a_flipper(1.5)
    arm.request(1, BESIDE_A_FLIPPER)
    arm.run(0.5)
    arm.robot.groups["flippers"].command([Target(ControlMode.POSITION, 0.5)])
    arm.wait()
    assert arm.ended == [(1, Status.TRANSITION_FAILED)]
    assert arm.now < 1.5
    arm.run(0.5)
    assert arm.velocities() == pytest.approx([0.0] * 5, abs=1e-6)


def test_motion_that_takes_too_long_times_out(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("jauspy.services.iop.preset_pose.TIME_FACTOR", 0.3)
    monkeypatch.setattr("jauspy.services.iop.preset_pose.TIME_ALLOWANCE", 0.1)
    arm = PosedArm("kinematic")
    arm.take_control()
    arm.request(1, REACH_LOW)
    arm.wait()
    assert arm.ended == [(1, Status.TRANSITION_TIMED_OUT)]
    assert arm.now < 1.2
    arm.run(0.5)
    assert arm.velocities() == pytest.approx([0.0] * 5, abs=1e-6)


@pytest.mark.slow
def test_slow_motion_profile_has_time() -> None:
    arm = PosedArm("kinematic")
    arm.take_control()
    record = m.SetJointMotionProfile.RevoluteJointMotionProfileRec
    arm.tell(m.SetJointMotionProfile([record(0.05, 1.0, 1.0)] * 5))
    arm.request(1, REACH_LOW)
    arm.wait(60.0)
    assert arm.ended == [(1, Status.TRANSITION_COMPLETED)]
    assert arm.now > 30.0


def test_joint_that_stands_still_ends_it(monkeypatch: pytest.MonkeyPatch) -> None:
    arm = PosedArm("kinematic")
    arm.take_control()
    arm.request(1, REACH_LOW)
    arm.run(1.0)
    group = arm.robot.groups["arm"]
    monkeypatch.setattr(type(group), "step", lambda *_: None)
    arm.wait()
    assert arm.ended == [(1, Status.TRANSITION_FAILED)]
    assert arm.host.counters["blocked"] == 1
    assert arm.now < 2.5
