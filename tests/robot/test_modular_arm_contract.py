"""The modular arm with any number of joints, commanded through JAUS: the controller of the cell on a plant."""

from __future__ import annotations

import math
from datetime import UTC, datetime, timedelta
from types import SimpleNamespace
from typing import Any

import pytest
from tests.helpers.sampling import sampled

pytest.importorskip("pinocchio", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)
pytest.importorskip("ruckig", reason="trajectories of arms need the extra 'cell'")

from tests.helpers.servo_plant import PERIOD, ServoPlant, many

from jauspy.codec.message import Message
from jauspy.ids import JausID
from jauspy.messages import cell as m, registry
from jauspy.messages.core import RequestControl, Resume, Standby
from jauspy.robot.config import AccessControlConfig, ModuleConfig
from jauspy.robot.hosts import module_host
from jauspy.robot.kinds.cell import ModularArmContext
from jauspy.services.cell import ArmMotionControl, motion_command

CLIENT = JausID(42, 1, 1)
START = datetime(2026, 1, 1, tzinfo=UTC)
COUNTS = range(10)


class Bench:
    """An arm with this number of joints, and its component, whose client is in control."""

    def __init__(self, joints: int) -> None:
        self.plant = ServoPlant(many(joints))
        self.plant.settle([0.0] * joints)
        self.arm = self.plant.arm()
        self.now = 0.0
        module = ModuleConfig(
            type="CM-ARM", node=3, component=1, part="arm", access_control=AccessControlConfig(timeout=0)
        )
        robot: Any = SimpleNamespace(optional_parts=[self.arm])
        self.host = module_host(
            JausID(201, 3, 1),
            module,
            ModularArmContext(robot, ArmMotionControl(self.arm), self.plant.cell),
            identities={},
            utc_now=lambda: START + timedelta(seconds=self.now),
            now=0.0,
        )
        self.run(0.02)
        self.tell(RequestControl(200), Resume())

    def tell(self, *messages: Message) -> list[Message]:
        for message in messages:
            self.host.receive(message.encode(strict=False), CLIENT, self.now)
        return [registry.decode(each.payload) for each in self.host.poll_output(self.now) if each.payload[1] >= 0xD0]

    def ask(self, query: Message) -> Any:
        (answer,) = self.tell(query)
        return answer

    def run(self, seconds: float) -> None:
        for _ in range(round(seconds / 0.01)):
            self.plant.run(self.arm, 0.01)
            self.now += 0.01
            while (due := self.host.next_timeout()) is not None and due <= self.now:
                self.host.handle_timeout(self.now)

    def finish(self, at_most: float = 6.0) -> None:
        """Run until the motion has ended."""
        self.run(PERIOD * 5)
        end = self.now + at_most
        while self.state.modular_arm_motion_rec.moving and self.now < end:
            self.run(0.05)

    @property
    def state(self) -> m.ReportModularArmState:
        return self.ask(m.QueryModularArmState())

    @property
    def error(self) -> str:
        return self.state.modular_arm_motion_rec.error

    @property
    def positions(self) -> list[float]:
        return [each.position for each in self.state.joint_list]

    def counted(self) -> dict[str, int]:
        return {name: count for name, count in dict(self.host.counters).items() if "error" in name and count}


@pytest.mark.slow
@pytest.mark.parametrize("joints", COUNTS)
def test_every_joint_gets_where_it_is_sent(joints):
    bench = Bench(joints)
    goal = [0.1 * (-1) ** number for number in range(joints)]
    bench.tell(motion_command(goal, 0.5))
    bench.finish()
    if joints:
        assert bench.error == ""
        assert bench.positions == pytest.approx(goal, abs=0.006)
        assert [each.target for each in bench.state.joint_list] == pytest.approx(goal)
    else:
        assert bench.error == "motion refused: no servo module is attached to a base"
    names = [each.name for each in bench.state.joint_list]
    assert names == [f"servo_{number + 1}" for number in range(joints)]
    assert [each.name for each in bench.ask(m.QueryModularArmSpecification()).joint_list] == names


@pytest.mark.parametrize("joints", [1, 3, 6])
def test_joints_that_are_left_out_stay(joints):
    bench = Bench(joints)
    bench.tell(motion_command([math.nan] * (joints - 1) + [0.2]))
    bench.finish()
    assert bench.positions == pytest.approx([0.0] * (joints - 1) + [0.2], abs=0.006)
    bench.tell(motion_command([math.nan] * joints))
    bench.finish()
    assert bench.error == ""
    assert bench.positions == pytest.approx([0.0] * (joints - 1) + [0.2], abs=0.006)


@pytest.mark.parametrize("joints", sampled(COUNTS, 3))
@pytest.mark.parametrize(
    "positions",
    [lambda n: [0.1] * (n + 1), lambda n: [0.1] * max(0, n - 1), lambda n: [0.1] * 255, lambda n: [math.inf] * n],
    ids=["one more", "one less", "255", "infinite"],
)
def test_commands_that_do_not_fit_are_refused(joints, positions):
    bench = Bench(joints)
    bench.tell(motion_command(positions(joints)))
    bench.run(0.1)
    assert "motion refused" in bench.error
    assert bench.positions == pytest.approx([0.0] * joints, abs=0.006)
    assert not bench.counted()


@pytest.mark.parametrize("duration", [-1.0, math.inf])
def test_durations_that_cannot_be_are_refused(duration):
    bench = Bench(2)
    bench.tell(motion_command([0.1, 0.1], duration))
    bench.run(0.1)
    assert "motion refused" in bench.error
    assert bench.positions == pytest.approx([0.0, 0.0], abs=0.006)


def test_unknown_modules_in_the_order_are_refused():
    bench = Bench(3)
    kind = m.SetModularArmOrder
    bench.tell(kind([kind.JointNameRec("servo_3"), kind.JointNameRec("servo_99")]))
    bench.run(0.02)
    assert "no servo module 'servo_99'" in bench.error
    bench.tell(kind([kind.JointNameRec("servo_3"), kind.JointNameRec("servo_1")]))
    bench.run(0.02)
    assert [each.name for each in bench.state.joint_list] == ["servo_3", "servo_1", "servo_2"]
    bench.tell(motion_command([0.2, math.nan, math.nan]))
    bench.finish()
    assert bench.plant.positions == pytest.approx([0.0, 0.0, 0.2], abs=0.006)


@pytest.mark.parametrize("silent", [0, 1, 2])
def test_a_module_that_falls_silent_ends_the_motion_of_all(silent):
    bench = Bench(3)
    bench.tell(motion_command([0.6, 0.6, 0.6], 3.0))
    bench.run(1.0)
    assert bench.state.modular_arm_motion_rec.moving
    bench.plant.order[silent].powered = False
    bench.run(0.6)
    assert not bench.state.modular_arm_motion_rec.moving
    assert bench.error == f"the motion ended early: no report of servo_{silent + 1}"
    others = [number for number in range(3) if number != silent]
    at = bench.positions
    assert all(at[number] < 0.5 for number in others)
    bench.tell(motion_command([0.1, 0.1, 0.1]))
    bench.run(0.1)
    assert bench.error == f"motion refused: no report of servo_{silent + 1}"
    assert not bench.counted()


def test_modules_that_are_released_in_a_motion_end_it():
    bench = Bench(4)
    bench.tell(motion_command([0.4] * 4, 2.0))
    bench.run(0.5)
    bench.plant.connectors["servo_2/output"].release()
    bench.run(0.5)
    assert [each.name for each in bench.state.joint_list] == ["servo_1", "servo_2"]
    assert bench.error == "the motion ended early: modules were attached or released"
    bench.tell(motion_command([0.1, 0.1]))
    bench.finish()
    assert bench.error == ""
    assert bench.positions == pytest.approx([0.1, 0.1], abs=0.006)


@pytest.mark.parametrize("end", [m.HoldModularArm(), Standby()], ids=["hold", "standby"])
def test_the_arm_stands_within_200_ms(end):
    bench = Bench(3)
    bench.tell(motion_command([1.0, 1.0, 1.0], 4.0))
    bench.run(2.0)
    assert max(map(abs, bench.plant.velocities)) > 0.2
    bench.tell(end)
    bench.run(0.2)
    assert max(map(abs, bench.plant.velocities)) < 0.02


@pytest.mark.parametrize("controller", m.SetModularArmController.Controller)
def test_both_controllers_move_the_arm(controller):
    bench = Bench(3)
    bench.tell(m.SetModularArmController(controller))
    bench.run(0.02)
    assert bench.state.modular_arm_motion_rec.controller == controller
    bench.tell(motion_command([0.2, -0.2, 0.2], 1.0))
    bench.finish(8.0)
    assert bench.positions == pytest.approx([0.2, -0.2, 0.2], abs=0.03)
