"""The service MotionPlanner: plans, previews and motions over JAUS, what goes wrong, and hostile messages."""

from __future__ import annotations

import asyncio
import math
import struct
import time
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from copy import copy
from dataclasses import dataclass, field, replace

import pytest

pytest.importorskip("numpy", reason="numpy is not installed")

from tests.helpers.straight_planner import StraightPlanner

from jauspy.console.world import World
from jauspy.errors import RequestError
from jauspy.messages.core import ReleaseControl, RequestControl, Resume
from jauspy.messages.planning import CancelMotion, ExecuteMotion, PlanMotion, SetHeldObject
from jauspy.ocu import OCU, HeldObject, Joints, PlannerState, Robot
from jauspy.ocu.planner import PLANNER, Planner, PlanningFailed
from jauspy.planning.component import planner_component
from jauspy.planning.execution import PlannedArm
from jauspy.planning.motion import NoPlan, Plan, PlanRequest, PoseGoal, Reason
from jauspy.planning.obstacles import Array, Cylinder, Obstacles, Primitive
from jauspy.planning.service import MotionPlannerService
from jauspy.robot import robot_files
from jauspy.testing import VirtualNetwork

PLANNER_ID = "101.1.130"
MODEL = robot_files.robot_model(robot_files.load("inc1"))


@dataclass
class Beside:
    """A planner beside inc1, and the operator's client."""

    robot: Robot
    planner: Planner
    planned: PlannedArm
    service: MotionPlannerService
    straight: StraightPlanner
    ocu: OCU
    seen: list[Obstacles] = field(default_factory=lambda: [Obstacles()])
    checked: list[int] = field(default_factory=list)
    held: list[Primitive | None] = field(default_factory=list)
    obstruction: str = ""

    def obstacles(self) -> Obstacles:
        if not self.seen:
            raise RequestError("no camera answers")
        return self.seen[-1]

    def in_the_way(self, positions: Array, obstacles: Obstacles, payload: Primitive | None = None) -> str:
        self.checked.append(len(positions))
        self.held.append(payload)
        return self.obstruction


@asynccontextmanager
async def beside(network: VirtualNetwork) -> AsyncIterator[Beside]:
    async with network.robot("inc1"), network.ocu("42.1.1") as ocu, network.ocu("42.1.7") as own:
        robot = await own.discover(101)
        straight = StraightPlanner(MODEL, "arm")
        found = Beside(robot, None, None, None, straight, ocu)  # type: ignore[arg-type]
        planned = PlannedArm(
            robot, robot.arm, MODEL, straight, found.obstacles, obstruction=found.in_the_way, in_thread=False
        )
        transport = network.transport(PLANNER_ID)
        async with planner_component(PLANNER_ID, planned, transport=transport) as component:
            found.planned, found.service = planned, component.service(MotionPlannerService)
            for _ in range(20):
                found.robot = await ocu.discover(101)
                if any(item.id.component == 130 for item in found.robot.components):
                    break
                await asyncio.sleep(0.5)
            found.planner = found.robot.planner
            yield found


@pytest.mark.slow
async def test_a_motion_is_planned_shown_and_carried_out(virtual_network: VirtualNetwork) -> None:
    async with beside(virtual_network) as inc1:
        assert str(await inc1.planner.arm()) == "101.1.104"
        assert (inc1.robot.name, inc1.planner.info.name) == ("inc1", "motion planner")
        before = (await inc1.robot.arm.joints()).positions
        goal = dict(zip(await inc1.planner.joints(), before.values(), strict=True))
        first, *_ = goal
        goal[first] += 0.6
        seen: list[PlannerState] = []
        async with inc1.robot.control("planner"):
            plan = await inc1.planner.plan_joints({first: goal[first]})
            assert await inc1.planner.preview() == plan
            assert (await inc1.robot.arm.joints()).positions == before
            assert plan.at(plan.duration)[first] == pytest.approx(goal[first])
            assert plan.clearance > 0.0
            end = await inc1.planner.execute(plan, progress=seen.append)
            assert (end.phase, end.reason, end.progress, end.replans) == ("reached", "", 1.0, 0)
        after = (await inc1.robot.arm.joints()).positions
        assert after[first] == pytest.approx(goal[first], abs=0.02)
        parts = [state.progress for state in seen]
        assert parts == sorted(parts)
        assert len(set(parts)) > 5


async def some_joint(inc1: Beside) -> tuple[str, float]:
    """The first joint of the arm and where it is."""
    first, *_ = await inc1.planner.joints()
    return first, (await inc1.robot.arm.joints()).positions[first]


@pytest.mark.slow
async def test_a_new_obstacle_stops_the_arm_and_it_plans_again(virtual_network: VirtualNetwork) -> None:
    async with beside(virtual_network) as inc1:
        joint, at = await some_joint(inc1)
        seen: list[PlannerState] = []

        def note(state: PlannerState) -> None:
            if state.phase == "executing" and state.progress > 0.3 and not state.replans:
                inc1.obstruction = "a box would touch"
            if state.phase == "planning":
                inc1.obstruction = ""
            seen.append(state)

        async with inc1.robot.control("planner"):
            plan = await inc1.planner.plan_joints({joint: at + 0.8})
            end = await inc1.planner.execute(plan, progress=note)
        assert (end.phase, end.replans) == ("reached", 1)
        assert {state.reason for state in seen} == {"", "new_obstacle"}
        assert any("a box would touch" in state.text for state in seen)
        assert (await inc1.robot.arm.joints()).positions[joint] == pytest.approx(at + 0.8, abs=0.02)
        again = inc1.straight.requests[1].start[0]
        assert at + 0.2 < again < at + 0.7  # it stood there


@pytest.mark.slow
async def test_an_obstacle_that_stays_ends_the_motion_with_the_reason(virtual_network: VirtualNetwork) -> None:
    async with beside(virtual_network) as inc1:
        joint, at = await some_joint(inc1)
        inc1.obstruction = "gripper_link and voxel would touch"
        async with inc1.robot.control("planner"):
            plan = await inc1.planner.plan_joints({joint: at + 0.8})
            with pytest.raises(
                PlanningFailed, match="gripper_link and voxel would touch; the arm stands after 2 new plans"
            ) as why:
                await inc1.planner.execute(plan, max_replans=2)
        assert why.value.reason == "new_obstacle"
        stopped = (await inc1.robot.arm.joints()).positions[joint]
        await asyncio.sleep(1.0)
        assert (await inc1.robot.arm.joints()).positions[joint] == pytest.approx(stopped, abs=0.002)
        assert abs(stopped - at) < 0.5


@pytest.mark.slow
async def test_an_arm_that_leaves_the_way_stops_and_plans_again(
    virtual_network: VirtualNetwork, monkeypatch: pytest.MonkeyPatch
) -> None:
    async with beside(virtual_network) as inc1:
        joint, at = await some_joint(inc1)
        follow, calls = inc1.planned.arm.watch, 0

        async def slipping(rate: float = 20.0) -> AsyncIterator[Joints]:
            nonlocal calls
            calls += 1
            async for joints in follow(rate):
                slipped = calls == 1 and joints.positions[joint] > at + 0.3
                yield replace(joints, positions={**joints.positions, other: 0.2}) if slipped else joints

        other = (await inc1.planner.joints())[4]
        monkeypatch.setattr(inc1.planned.arm, "watch", slipping)
        seen: list[PlannerState] = []
        async with inc1.robot.control("planner"):
            plan = await inc1.planner.plan_joints({joint: at + 0.8})
            end = await inc1.planner.execute(plan, progress=seen.append)
        assert (end.phase, end.replans) == ("reached", 1)
        assert {state.reason for state in seen} == {"", "deviated"}
        assert at + 0.3 < inc1.straight.requests[1].start[0] < at + 0.75


@pytest.mark.slow
async def test_a_plan_from_where_the_arm_is_no_longer_is_made_again(virtual_network: VirtualNetwork) -> None:
    async with beside(virtual_network) as inc1:
        joint, at = await some_joint(inc1)
        async with inc1.robot.control("planner"):
            plan = await inc1.planner.plan_joints({joint: at + 0.4})
            async with inc1.robot.control("arm"):
                await inc1.robot.arm.move({joint: at - 0.4})
            with pytest.raises(PlanningFailed, match="moved since the plan was made") as why:
                await inc1.planner.execute(plan, max_replans=0)
            assert why.value.reason == "deviated"
            assert (await inc1.robot.arm.joints()).positions[joint] == pytest.approx(at - 0.4, abs=0.02)


@pytest.mark.slow
async def test_another_command_to_the_arm_ends_the_motion(virtual_network: VirtualNetwork) -> None:
    async with beside(virtual_network) as inc1:
        names = await inc1.planner.joints()
        joint, at = await some_joint(inc1)
        async with inc1.robot.control("planner"):
            plan = await inc1.planner.plan_joints({joint: at + 0.8})
            moving = asyncio.create_task(inc1.planner.execute(plan))
            await asyncio.sleep(0.8)
            await inc1.planned.arm.begin({names[4]: 0.02})
            with pytest.raises(PlanningFailed, match=r"101\.1\.104") as why:
                await moving
            assert why.value.reason == "arm_stopped"


@pytest.mark.slow
async def test_cancelling_and_losing_control_stop_the_arm(virtual_network: VirtualNetwork) -> None:
    async with beside(virtual_network) as inc1:
        joint, at = await some_joint(inc1)
        for ending in ("cancel", "release"):
            async with inc1.robot.control("planner"):
                start = (await inc1.robot.arm.joints()).positions[joint]
                plan = await inc1.planner.plan_joints({joint: at + 1.5})
                moving = asyncio.create_task(inc1.planner.execute(plan))
                await asyncio.sleep(1.2)
                assert (await inc1.planner.state()).phase == "executing"
                if ending == "cancel":
                    await inc1.planner.cancel()
                    with pytest.raises(PlanningFailed, match="cancelled") as why:
                        await moving
                    assert why.value.reason == "cancelled"
            if ending == "release":
                with pytest.raises(RequestError):
                    await moving
            await asyncio.sleep(1.0)
            stopped = (await inc1.robot.arm.joints()).positions[joint]
            assert start + 0.05 < stopped < at + 1.4
            await asyncio.sleep(1.0)
            assert (await inc1.robot.arm.joints()).positions[joint] == pytest.approx(stopped, abs=0.002)
            assert (await inc1.planner.state()).phase == "failed"


@pytest.mark.slow
async def test_reasons_are_told(virtual_network: VirtualNetwork) -> None:
    async with beside(virtual_network) as inc1:
        joint, at = await some_joint(inc1)
        planner = inc1.planner
        async with inc1.robot.control("planner"):
            for goal, reason, text in (
                ({"nix": 1.0}, "wrong_request", "no joint 'nix'"),
                ({joint: 9.0}, "outside_limits", "can be -2.9..2.9 rad"),
            ):
                with pytest.raises(PlanningFailed, match=text) as why:
                    await planner.plan_joints(goal)
                assert why.value.reason == reason
            with pytest.raises(PlanningFailed, match="no frame 'nowhere'; it has: arm_camera_link") as why:
                await planner.plan_pose((0.7, 0.0, 0.4), frame="nowhere")
            assert why.value.reason == "wrong_request"
            with pytest.raises(PlanningFailed, match="knows joints only") as why:
                await planner.plan_pose((0.7, 0.0, 0.4), (0.0, 1.0, 0.0), frame="gripper_link")
            assert why.value.reason == "no_way"
            plan = await planner.plan_joints({joint: at + 0.3})
            await planner.cancel()
            assert await planner.preview() is None
            with pytest.raises(PlanningFailed, match="plan first") as why:
                await planner.execute(plan)
            assert why.value.reason == "no_such_plan"
            inc1.seen.clear()
            with pytest.raises(PlanningFailed, match="no camera answers") as why:
                await planner.plan_joints({joint: at + 0.3})
            assert why.value.reason == "no_sight"
            inc1.seen.append(Obstacles())
            plan = await planner.plan_joints({joint: at + 0.3})
            async with inc1.robot.control("arm", authority=255):
                with pytest.raises(PlanningFailed, match=r"42\.1\.1") as why:
                    await planner.execute(plan)
            assert why.value.reason == "arm_refused"


@pytest.mark.slow
async def test_frames_are_where_the_robot_is_now(virtual_network: VirtualNetwork) -> None:
    async with beside(virtual_network) as inc1:
        async with inc1.robot.control("planner"):
            for frame in ("", "base_link", "tool_link"):
                with pytest.raises(PlanningFailed, match="knows joints only"):
                    await inc1.planner.plan_pose((0.1, 0.0, 0.0), frame=frame)
        goals = [request.goal for request in inc1.straight.requests]
        assert all(isinstance(goal, PoseGoal) and not goal.attitude for goal in goals)
        places = [goal.pose.position for goal in goals if isinstance(goal, PoseGoal)]
        tool = await inc1.robot.arm.tool()
        assert places[0] == places[1] == pytest.approx((0.1, 0.0, 0.0))
        assert math.dist(places[2], (tool.x, tool.y, tool.z)) == pytest.approx(0.1, abs=0.005)


async def test_what_is_held_is_stated_by_an_operator_and_planned_for(virtual_network: VirtualNetwork) -> None:
    async with beside(virtual_network) as inc1:
        joint, at = await some_joint(inc1)
        told: list[Primitive | None] = []
        inc1.planned._on_hold = told.append
        bar = HeldObject("cylinder", (0.04, 0.04, 0.3), (0.05, 0.0, 0.0), (0.0, math.pi / 2.0, 0.0), "bar")
        assert await inc1.planner.held() is None
        async with inc1.robot.control("planner"):
            before = await inc1.planner.plan_joints({joint: at + 0.2})
            await inc1.planner.hold(bar)
            assert await inc1.planner.preview() is None, "it was made without the bar"
            with pytest.raises(PlanningFailed, match="plan first"):
                await inc1.planner.execute(before)
            plan = await inc1.planner.plan_joints({joint: at + 0.2})
            await inc1.planner.execute(plan)
        seen = await inc1.planner.held()
        assert seen is not None
        assert (seen.shape, seen.name, seen.size) == ("cylinder", "bar", bar.size), "it stays when control is released"
        assert (*seen.position, *seen.rpy) == pytest.approx((*bar.position, *bar.rpy))
        held = inc1.straight.requests[-1].payload
        assert isinstance(held, Cylinder)
        assert (held.radius, held.length) == (0.02, 0.3)
        assert inc1.straight.requests[0].payload is None
        assert inc1.held[-1] is held, "what comes near it on the way counts"
        async with inc1.robot.control("planner"):
            await inc1.planner.hold(None)
            await inc1.planner.plan_joints({joint: at})
        assert inc1.straight.requests[-1].payload is None
        assert told == [held, None]


async def test_hostile_statements_of_what_is_held_are_refused(virtual_network: VirtualNetwork) -> None:
    async with beside(virtual_network) as inc1, virtual_network.component("42.1.9", []) as attacker:
        box = SetHeldObject(1, "box", 0.1, 0.0, 0.0, 0.0, 0.0, 0.0, 0.2, 0.2, 0.2)
        attacker.send(PLANNER_ID, box)
        await asyncio.sleep(0.5)
        assert await inc1.planner.held() is None, "without control"
        attacker.send(PLANNER_ID, RequestControl(authority_code=100))
        attacker.send(PLANNER_ID, Resume())
        await asyncio.sleep(0.5)
        wrong = (math.nan, math.inf, -math.inf, 1e300, -1e300)
        fields = ("x", "yaw", "size_x", "size_y", "size_z")
        messages = [replace_field(box, name, value) for name in fields for value in wrong]
        messages += [replace_field(box, "size_x", value) for value in (0.0, -0.1, 11.0)]
        payloads = [message.encode(strict=False) for message in [*messages, replace_field(box, "shape", 9)]]
        for payload in [*payloads, *(payload[:-5] for payload in payloads)]:
            attacker.send_encoded(PLANNER_ID, payload)
            await asyncio.sleep(0.05)
            assert await inc1.planner.held() is None
        assert (await inc1.planner.state()).reason == "wrong_request"
        attacker.send(PLANNER_ID, box)
        await asyncio.sleep(0.2)
        assert (await inc1.planner.held()) == HeldObject("box", (0.2, 0.2, 0.2), (0.1, 0.0, 0.0), name="box")


def replace_field(message: SetHeldObject, name: str, value: float) -> SetHeldObject:
    """The message with one field set to a value that the codec may not write by itself."""
    changed = copy(message)
    setattr(changed, name, value)
    return changed


def hostile_goals(joint: str) -> list[bytes]:
    """Requests with goals that are none; 1234.5 stands for numbers that a codec does not write."""
    bad, rows = 1234.5, PlanMotion.JointGoalRec
    pose = PlanMotion.GoalPoseRec("", 0.7, 0.0, 0.4, 0.0, 0.0, 0.0)
    goals = [
        PlanMotion.JointGoalList([rows(joint, bad)]),
        PlanMotion.JointGoalList([]),
        PlanMotion.JointGoalList([rows(joint, 0.1), rows(joint, 0.2)]),
        PlanMotion.JointGoalList([rows(f"joint {number}", 0.1) for number in range(255)]),
        PlanMotion.PoseGoalRec("", bad, 0.0, 0.0, 0.0, 0.0, 0.0),
        PlanMotion.PointGoalRec("\x00" * 255, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0),
        PlanMotion.PoseGoalRec("", 1e300, 0.0, 0.0, 0.0, 0.0, 0.0),
        PlanMotion.RegionGoalSeq(pose, PlanMotion.GoalRegionRec(-1.0, 0.0, 0.0, 0.1)),
        PlanMotion.RegionGoalSeq(pose, PlanMotion.GoalRegionRec(1.0, 0.0, 0.0, bad)),
    ]
    payloads = [PlanMotion(PlanMotion.PlanRec(number, 1.0), goal).encode() for number, goal in enumerate(goals, 1)]
    written = struct.pack("<d", bad)
    numbers = [
        payload.replace(written, struct.pack("<d", value))
        for payload in payloads
        if written in payload
        for value in (math.nan, math.inf, -math.inf)
    ]
    return [*(payload for payload in payloads if written not in payload), *numbers]


@pytest.mark.slow
async def test_hostile_messages_change_nothing(virtual_network: VirtualNetwork) -> None:
    async with beside(virtual_network) as inc1, virtual_network.component("42.1.9", []) as attacker:
        joint, at = await some_joint(inc1)
        before = (await inc1.robot.arm.joints()).positions
        payloads = hostile_goals(joint)
        for payload in payloads:  # without control nothing is taken
            attacker.send_encoded(PLANNER_ID, payload)
        await asyncio.sleep(0.5)
        assert (await inc1.planner.state()).phase == "idle"
        attacker.send(PLANNER_ID, RequestControl(authority_code=100))
        attacker.send(PLANNER_ID, Resume())
        await asyncio.sleep(0.5)
        for payload in [*payloads, *(payload[:-5] for payload in payloads)]:
            attacker.send_encoded(PLANNER_ID, payload)
            await asyncio.sleep(0.05)
            assert (await inc1.planner.state()).phase in ("idle", "failed")
        state = await inc1.planner.state()
        assert (state.phase, state.reason) == ("failed", "wrong_request")
        assert inc1.straight.requests == []
        for number in range(300):  # a request replaces the one before
            goal = PlanMotion.JointGoalList([PlanMotion.JointGoalRec(joint, at + 0.1)])
            attacker.send(PLANNER_ID, PlanMotion(PlanMotion.PlanRec(number, 0.0), goal))
            attacker.send(PLANNER_ID, ExecuteMotion(number + 5, 3))
            attacker.send(PLANNER_ID, CancelMotion())
        attacker.send(PLANNER_ID, ReleaseControl())
        await asyncio.sleep(1.0)
        assert (await inc1.robot.arm.joints()).positions == pytest.approx(before, abs=0.002)
        async with inc1.robot.control("planner"):
            plan = await inc1.planner.plan_joints({joint: at + 0.2})
            await inc1.planner.execute(plan)
        after = (await inc1.robot.arm.joints()).positions
        assert after == pytest.approx({**before, joint: at + 0.2}, abs=0.02)


class Slow:
    """A planner that blocks its thread, and counts how many run at once."""

    def __init__(self) -> None:
        self.running = self.most = self.calls = 0

    def plan(self, request: PlanRequest) -> Plan:
        self.calls += 1
        self.running += 1
        self.most = max(self.most, self.running)
        time.sleep(0.02)
        self.running -= 1
        raise NoPlan(Reason.NO_WAY, "there is none")


@pytest.mark.slow
async def test_many_requests_plan_one_at_a_time(virtual_network: VirtualNetwork) -> None:
    async with beside(virtual_network) as inc1:
        slow = Slow()
        inc1.planned._planner, inc1.planned._in_thread = slow, True
        joint, at = await some_joint(inc1)
        async with inc1.robot.control("planner"):
            client = inc1.robot.component(130).service("MotionPlanner")
            for number in range(1, 100):
                goal = PlanMotion.JointGoalList([PlanMotion.JointGoalRec(joint, at + 0.1)])
                await client.send(PlanMotion(PlanMotion.PlanRec(number, 0.0), goal))
            for _ in range(1000):
                await asyncio.sleep(0.05)
                if (await inc1.planner.state()).phase == "failed" and not slow.running:
                    break
            state = await inc1.planner.state()
        assert (state.number, state.reason) == (99, "no_way")
        assert slow.most == 1
        assert slow.calls < 99


class Broken:
    """A planner from elsewhere with a bug."""

    def plan(self, request: PlanRequest) -> Plan:
        raise ZeroDivisionError("division by zero")


async def test_a_bug_of_a_planner_is_told_and_does_not_end_the_component(virtual_network: VirtualNetwork) -> None:
    async with beside(virtual_network) as inc1:
        good, inc1.planned._planner = inc1.planned._planner, Broken()
        joint, at = await some_joint(inc1)
        async with inc1.robot.control("planner"):
            with pytest.raises(PlanningFailed, match="division by zero") as why:
                await inc1.planner.plan_joints({joint: at + 0.1})
            assert why.value.reason == "planner_failed"
            inc1.planned._planner = good
            await inc1.planner.plan_joints({joint: at + 0.1})


@pytest.mark.slow
async def test_reports_are_sent_as_events(virtual_network: VirtualNetwork) -> None:
    async with beside(virtual_network) as inc1:
        joint, at = await some_joint(inc1)
        phases: list[str] = []

        async def follow() -> None:
            async for state in inc1.planner.watch():
                phases.append(state.phase)
                if state.phase == "reached":
                    return

        following = asyncio.create_task(follow())
        async with inc1.robot.control("planner"):
            plan = await inc1.planner.plan_joints({joint: at + 0.4})
            await inc1.planner.execute(plan)
        await asyncio.wait_for(following, 5.0)
        assert list(dict.fromkeys(phases))[-3:] == ["planned", "executing", "reached"]


@pytest.mark.slow
async def test_the_console_shows_the_plan_and_an_operator_takes_it_over(virtual_network: VirtualNetwork) -> None:
    async with beside(virtual_network) as inc1, virtual_network.ocu("42.1.8") as other:
        world, watcher = World(inc1.ocu, lambda: inc1.robot), object()
        geometry = await world.watched_by(watcher)
        joint, at = await some_joint(inc1)
        kinds = [item for item in geometry.joints if item["kind"] != "fixed"]
        column = [item["name"] for item in kinds].index(joint)

        async def until(is_shown: bool) -> None:
            for _ in range(100):
                if (world.ghost() is not None) is is_shown:
                    return
                await asyncio.sleep(0.05)
            pytest.fail("the ghost does not change")

        assert world.ghost() is None
        async with inc1.robot.control("planner"):
            plan = await inc1.planner.plan_joints({joint: at + 1.5})
            await until(is_shown=True)
            ghost = world.ghost()
            assert ghost is not None
            assert [frame[column] for frame in (ghost["frames"][0], ghost["frames"][-1])] == [
                pytest.approx(at, abs=0.01),
                pytest.approx(at + 1.5, abs=0.01),
            ]
            assert ghost["duration"] == pytest.approx(plan.duration, abs=0.001)
            assert world.planned.text.startswith("planned: 3.8 s, clearance")
            moving = asyncio.create_task(inc1.planner.execute(plan))
            await asyncio.sleep(1.5)
            assert world.planned.text.startswith("executing ")
            theirs = (await other.discover(101)).component(130).service(PLANNER)
            async with theirs.control(authority=200):  # as the button of the console
                pass
            with pytest.raises(RequestError):
                await moving
        await until(is_shown=False)
        assert "cancelled" in world.planned.text
        world.unwatched_by(watcher)
        await world.close()
