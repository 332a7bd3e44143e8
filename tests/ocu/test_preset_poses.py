"""Arms and robots that move to named poses, on virtual time."""

from __future__ import annotations

import asyncio
from pathlib import Path

import pytest

from jauspy.codec.message import Message
from jauspy.errors import ConfigError, ControlRejected, RequestError, ResponseTimeout
from jauspy.messages import iop
from jauspy.messages.core import Standby
from jauspy.ocu import MotionLimits
from jauspy.ocu.preset_poses import NoRouteError
from jauspy.services.core.command_events import CommandEvents
from jauspy.services.service import Service
from jauspy.testing import VirtualNetwork

SHOULDER, FLIPPERS = "arm_link_1_to_arm_link_2", "base_link_to_flippers"
BESIDE = """extends = "inc1"
[poses.beside]
base_link_to_arm_link_1 = 34.377
arm_link_1_to_arm_link_2 = -2.865
arm_link_2_to_arm_link_3 = 17.189
arm_link_3_to_arm_link_4 = 0
arm_link_4_to_arm_link_5 = 0
base_link_to_flippers = 86
[poses.home]
base_link_to_arm_link_1 = 0
arm_link_1_to_arm_link_2 = 154.7
arm_link_2_to_arm_link_3 = -149
arm_link_3_to_arm_link_4 = -5.7
arm_link_4_to_arm_link_5 = 0
base_link_to_flippers = 0
"""
"""Beside the left flipper, which can neither rise nor fall while the arm is there."""


@pytest.fixture
async def inc1(robot, ocu):
    return await ocu.robot(101)


def positions(robot, group: str = "arm") -> tuple[float, ...]:
    return robot.snapshot.joints[group].positions


@pytest.mark.slow
async def test_poses_are_listed(inc1):
    assert await inc1.arm.poses() == ("stow", "drive", "reach_low", "inspect")
    assert await inc1.manipulator(107).poses() == ()
    known = await inc1.poses()
    assert list(known) == ["stow", "drive", "reach_low", "inspect"]
    assert [id.component for id in known["stow"]] == [103, 104]


@pytest.mark.slow
async def test_the_arm_moves_to_a_pose(inc1, robot):
    async with inc1.control("arm"):
        reached = await inc1.arm.move_to("reach_low")
        assert await inc1.arm.pose() == "reach_low"
        moving = asyncio.create_task(inc1.arm.move_to("stow"))
        await asyncio.sleep(1.0)
        assert await inc1.arm.pose() is None
        await moving
    assert reached[SHOULDER] == pytest.approx(0.6545, abs=0.012)
    assert positions(robot)[1] == pytest.approx(2.7, abs=0.012)
    assert positions(robot, "flippers") == pytest.approx((2.2,), abs=0.001)


@pytest.mark.slow
async def test_the_whole_robot_moves_to_a_pose(inc1, robot):
    async with inc1.control():
        reached = await inc1.move_to("drive")
    assert reached[FLIPPERS] == pytest.approx(0.785, abs=0.012)
    assert positions(robot, "flippers") == pytest.approx((0.785,), abs=0.012)
    assert positions(robot)[1] == pytest.approx(2.618, abs=0.012)


@pytest.mark.slow
async def test_unknown_poses_are_errors_that_list_what_is_known(inc1):
    async with inc1.control():
        for mover in (inc1.arm, inc1):
            with pytest.raises(ConfigError, match="has no pose 'park'; it has: stow, drive, reach_low, inspect"):
                await mover.move_to("park")
        with pytest.raises(TypeError, match="the name of a pose"):
            await inc1.arm.move_to(1)
    with pytest.raises(ConfigError, match=r"101\.1\.107 cannot move to named poses: it does not offer iop:PresetPose"):
        await inc1.manipulator(107).move_to("stow")
    with pytest.raises(ConfigError, match="cannot tell its pose"):
        await inc1.manipulator(107).pose()


@pytest.mark.slow
async def test_without_control_it_says_so(inc1, robot):
    with pytest.raises(ControlRejected, match="take control first"):
        await inc1.arm.move_to("reach_low")
    assert positions(robot)[1] == pytest.approx(2.7, abs=0.001)


@pytest.mark.slow
async def test_control_that_is_taken_while_it_moves_stops_it(inc1, robot, virtual_network):
    async with inc1.control("arm", authority=100):
        moving = asyncio.create_task(inc1.arm.move_to("reach_low"))
        await asyncio.sleep(1.0)
        async with virtual_network.ocu("42.1.9") as other, (await other.robot(101)).control("arm", authority=200):
            with pytest.raises(ControlRejected, match="was lost"):
                await moving
            stopped = positions(robot)
            assert 0.8 < stopped[1] < 2.5
            await asyncio.sleep(2.0)
            assert positions(robot) == pytest.approx(stopped, abs=0.02)


@pytest.mark.slow
async def test_a_client_that_falls_silent_stops_the_arm(inc1, robot, virtual_network):
    async with virtual_network.ocu("42.1.9") as other:
        operated = await other.robot(101)
        async with operated.control("arm"):
            limits = await operated.arm.motion_limits()
            await operated.arm.set_motion_limits({name: MotionLimits(0.1, 1.0, 1.0) for name in limits})
            moving = asyncio.create_task(operated.arm.move_to("reach_low"))
            await asyncio.sleep(1.0)
            assert positions(robot)[1] < 2.69
            virtual_network.disconnect("42.1.9")
            await asyncio.sleep(8.0)
            stopped = positions(robot)
            assert stopped[1] > 1.7, "it would have gone further"
            await asyncio.sleep(3.0)
            assert positions(robot) == pytest.approx(stopped, abs=0.01)
            assert await inc1.arm.pose() is None
            virtual_network.reconnect("42.1.9")
            with pytest.raises(RequestError):
                await moving


@pytest.mark.slow
async def test_standby_while_it_moves_is_named(inc1, robot):
    async with inc1.control("arm"):
        moving = asyncio.create_task(inc1.arm.move_to("reach_low"))
        await asyncio.sleep(1.0)
        await inc1.component(104).service("Management").send(Standby(), ack=True)
        with pytest.raises(RequestError, match="in Standby: resume first"):
            await moving


@pytest.mark.slow
async def test_a_second_request_ends_the_first(inc1):
    async with inc1.control("arm"):
        first = asyncio.create_task(inc1.arm.move_to("reach_low"))
        await asyncio.sleep(0.5)
        await inc1.component(104).service("iop:PresetPose").send(iop.SetCurrentPose(250, 4), ack=True)
        with pytest.raises(RequestError, match=r"not in the pose 'reach_low': another command, or a stop, ended"):
            await first


@pytest.mark.slow
async def test_another_pose_replaces_the_motion(inc1, robot):
    async with inc1.control("arm"):
        first = asyncio.create_task(inc1.arm.move_to("reach_low"))
        await asyncio.sleep(0.5)
        await inc1.arm.move_to("drive")
        with pytest.raises(RequestError, match="another command"):
            await first
        assert await inc1.arm.pose() == "drive"


@pytest.mark.slow
async def test_cancelling_stops_the_arm(inc1, robot):
    async with inc1.control("arm"):
        with pytest.raises(TimeoutError):
            async with asyncio.timeout(1.0):
                await inc1.arm.move_to("reach_low")
        stopped = positions(robot)
        assert stopped[1] < 2.6
        await asyncio.sleep(1.0)
        assert positions(robot) == pytest.approx(stopped, abs=0.05)


@pytest.mark.slow
async def test_no_route_is_named_and_others_move_first(virtual_network: VirtualNetwork, tmp_path: Path):
    file = tmp_path / "beside.toml"
    file.write_text(BESIDE)
    async with virtual_network.robot(str(file)) as robot, virtual_network.ocu() as ocu:
        inc1 = await ocu.robot(101)
        async with inc1.control():
            await inc1.move_to("beside")
            flippers = inc1.manipulator(103)
            with pytest.raises(
                NoRouteError, match=r"101\.1\.103 is not in the pose 'home': links would touch on the way"
            ):
                await flippers.move_to("home")
            assert positions(robot, "flippers") == pytest.approx((1.5,), abs=0.02)
            await inc1.move_to("home")
            assert positions(robot, "flippers") == pytest.approx((0.0,), abs=0.02)
            assert await flippers.pose() == await inc1.arm.pose() == "home"


@pytest.mark.slow
async def test_no_route_for_any_component_is_an_error(inc1, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr("jauspy.geometry.joint_routes.MAX_CHECKS", 2)
    async with inc1.control():
        with pytest.raises(NoRouteError, match="links would touch"):
            await inc1.move_to("reach_low")


@pytest.mark.slow
async def test_components_without_command_events(virtual_network: VirtualNetwork, monkeypatch: pytest.MonkeyPatch):
    """As those of Events 1.0: the report of the service tells the end."""
    monkeypatch.setattr(CommandEvents, "is_command_supported", lambda _: False)
    async with virtual_network.robot() as robot, virtual_network.ocu() as ocu:
        arm = (inc1 := await ocu.robot(101)).arm
        async with inc1.control("arm"):
            await arm.move_to("reach_low")
            assert positions(robot)[1] == pytest.approx(0.6545, abs=0.012)
            with pytest.raises(ResponseTimeout, match=r"has not reported the end of SetCurrentPose within 0\.5 s"):
                await arm.move_to("stow", timeout=0.5)
            monkeypatch.setattr("jauspy.geometry.joint_routes.MAX_CHECKS", 2)
            with pytest.raises(NoRouteError):
                await arm.move_to("inspect")


@pytest.mark.slow
async def test_time_out_stops_the_arm(inc1, robot):
    async with inc1.control("arm"):
        with pytest.raises(RequestError, match=r"is not in the pose 'reach_low': .* within 0\.5 s"):
            await inc1.arm.move_to("reach_low", timeout=0.5)
        await asyncio.sleep(2.0)
        stopped = positions(robot)
        assert stopped[1] > 1.5
        await asyncio.sleep(1.0)
        assert positions(robot) == pytest.approx(stopped, abs=0.01)


# --- peers that are not of this package


class OtherPoses(Service, urn="urn:jaus:jss:iop:PresetPose"):
    """A peer that reports what it is told to, also nonsense."""

    names: tuple[tuple[int, str], ...] = ((1, "stow"), (2, "stow"), (255, "unknown"), (7, "a\x1b[2J<b>"))
    status: int | None = 3
    held = 7

    def send_report_preset_pose_capabilities(self) -> Message:
        kind = iop.ReportPresetPoseCapabilities
        return kind([kind.PoseSeq(kind.PresetPoseRec(*row), []) for row in self.names])

    def send_report_preset_pose_specifications(self) -> Message:
        return iop.ReportPresetPoseSpecifications([])

    def send_report_current_pose(self) -> Message:
        return iop.ReportCurrentPose(iop.ReportCurrentPose.CurrentPoseRec(self.held))

    def is_pose_unrecognized(self) -> bool:
        return False

    def is_transition_valid(self) -> bool:
        return True

    def set_current_pose(self, msg: iop.SetCurrentPose) -> Message | None:
        self.host.begin_command()(False)
        return None if self.status is None else iop.ReportTransitionCompleted(msg.request_id, self.status)

    def send_report_transition_completed_invalid_transition(self) -> None:
        raise AssertionError

    send_report_transition_completed_unrecognized_pose = send_report_transition_completed_invalid_transition
    send_report_transition_completed_transition_completed = send_report_transition_completed_invalid_transition
    send_report_transition_completed_transition_failed = send_report_transition_completed_invalid_transition


@pytest.fixture
async def peer(virtual_network: VirtualNetwork, ocu):
    service = OtherPoses()
    async with virtual_network.component("90.1.5", [service]):
        found = await ocu.robot(90)
        yield found, service


async def test_names_of_a_peer_are_data(peer):
    robot, _ = peer
    arm = robot.manipulator(5)
    assert await arm.poses() == ("stow", "stow", "a\x1b[2J<b>")
    assert await arm.pose() == "a\x1b[2J<b>"
    async with robot.control(5):
        with pytest.raises(ConfigError, match="has 2 poses with the name 'stow'"):
            await arm.move_to("stow")
        with pytest.raises(ConfigError, match=r"it has: stow, stow, a\\x1b\[2J<b>$"):
            await arm.move_to("unknown")


@pytest.mark.parametrize(
    ("status", "problem"),
    [
        (1, "links would touch"),
        (2, "does not know this pose any more"),
        (3, "another command, or a stop"),
        (4, "has returned to the pose from which it came"),
        (5, "it took too long"),
        (None, "did not carry out SetCurrentPose"),
    ],
)
async def test_how_it_ended_is_named(peer, status, problem):
    robot, service = peer
    service.status = status
    async with robot.control(5):
        with pytest.raises(RequestError, match=problem) as raised:
            await robot.manipulator(5).move_to("a\x1b[2J<b>")
    assert "\x1b" not in str(raised.value)
    assert not isinstance(raised.value, ResponseTimeout)
