"""Forged frames on a robot that stands or moves: nothing raises, a stop has one true reason, and Reset recovers."""

from __future__ import annotations

import random
import re
import struct
from collections.abc import Callable, Iterator
from itertools import islice

import can
import pytest
from tests.backends.can.conftest import OpenCan, simulated
from tests.backends.can.test_failing_drives import CYCLE, set_in_motion

from jauspy.backends.can import pdo
from jauspy.backends.can.cia402 import STATUS_OF, DriveState
from jauspy.backends.can.faults import DriveFault
from jauspy.backends.can.robot import CanRobot
from jauspy.platform.joints import ControlMode, Target
from jauspy.robot import robot_files
from jauspy.robot.runner import RobotRunner
from jauspy.virtual.environment import VirtualTime
from jauspy.virtual.network import VirtualNetwork

ARM = 5
"""The node of `arm_2`."""
LENGTH_OF_ATTACK = 0.5
FRAMES_A_CYCLE = 12


def frame(cob_id: int, data: bytes = b"", **kind: bool) -> can.Message:
    return can.Message(arbitration_id=cob_id, data=data, **{"is_extended_id": False, **kind})


def inject(robot: CanRobot, *frames: can.Message) -> None:
    """Send frames that both the robot and the drives receive, as a stranger on the bus does."""
    assert robot.virtual_bus is not None
    for each in frames:
        robot.virtual_bus.far.send(each)
        robot.virtual_bus.near.send(each)


def forever(*frames: can.Message) -> Callable[[random.Random], Iterator[can.Message]]:
    def repeated(_chance: random.Random) -> Iterator[can.Message]:
        while True:
            yield from frames

    return repeated


def status(state: DriveState, counts: int = 0) -> can.Message:
    return frame(pdo.STATUS.cob_id + ARM, pdo.STATUS_LAYOUT.pack(STATUS_OF[state], counts, 0))


def any_frame(chance: random.Random) -> Iterator[can.Message]:
    """Frames at random, as in a flood, that command no node and imitate none."""
    used = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 127}
    while True:
        cob_id = chance.randrange(0x101, 0x800)
        if cob_id & 0x7F not in used:
            yield frame(cob_id, chance.randbytes(chance.randrange(9)))


def wrong_kinds(chance: random.Random) -> Iterator[can.Message]:
    """Frames with the identifiers of a drive, of a kind that CANopen does not have."""
    fault = pdo.STATUS_LAYOUT.pack(STATUS_OF[DriveState.FAULT], 0, 0)
    while True:
        yield frame(pdo.STATUS.cob_id + ARM, fault, is_extended_id=True)
        yield frame(pdo.SYNC, is_extended_id=True)
        yield frame(pdo.STATUS.cob_id + ARM, is_remote_frame=True)
        yield frame(0x40, bytes(8), is_error_frame=True)
        yield frame(pdo.STATUS.cob_id + ARM, bytes(chance.choice((12, 64))), is_fd=True)
        yield frame(pdo.STATUS.cob_id + ARM, fault, is_fd=True)


def wrong_lengths(chance: random.Random) -> Iterator[can.Message]:
    """Frames with the identifiers of robot and drives, and lengths that they never have."""
    lengths = {0: 2, **dict.fromkeys((each.cob_id for each in pdo.COMMANDS.values()), 7)}
    lengths |= {pdo.STATUS.cob_id: 8, pdo.SPEED.cob_id: 7, pdo.EMCY: 8, pdo.HEARTBEAT: 1, 0x400: 5}
    lengths |= {0x580: 8, 0x600: 8}
    while True:
        base, length = chance.choice(list(lengths.items()))
        wrong = chance.choice([each for each in range(9) if each != length])
        yield frame(base + ARM if base else 0, chance.randbytes(wrong))


def emergencies(chance: random.Random) -> Iterator[can.Message]:
    while True:
        yield frame(pdo.EMCY + ARM, chance.randbytes(8))


def answers_of_servers(chance: random.Random) -> Iterator[can.Message]:
    while True:
        yield frame(0x580 + ARM, chance.choice((b"\x80", b"\x43", b"\x00", b"\x60")) + chance.randbytes(7))


def jumps(chance: random.Random) -> Iterator[can.Message]:
    while True:
        yield status(DriveState.OPERATION_ENABLED, chance.choice((2**31 - 1, -(2**31), 2**30, -(2**30))))


IGNORED: dict[str, Callable[[random.Random], Iterator[can.Message]]] = {
    "frames at random": any_frame,
    "emergencies": emergencies,
    "frames of wrong kinds": wrong_kinds,
    "frames of wrong lengths": wrong_lengths,
    "answers of SDO servers": answers_of_servers,
    "TIME": forever(frame(0x100, bytes(6))),
    "LSS": forever(frame(0x7E5, b"\x04\x01" + bytes(6)), frame(0x7E4, b"\x11\x00" + bytes(6))),
    "unknown NMT states": forever(frame(pdo.HEARTBEAT + ARM, b"\x2a")),
    "boot-up messages of other nodes": forever(frame(pdo.HEARTBEAT + 77, b"\0")),
    "NMT commands to other nodes": forever(frame(0, b"\x81\x4d")),
}
"""Attacks that a robot does not even notice: it goes on."""

STOPPING: dict[str, tuple[Callable[[random.Random], Iterator[can.Message]], str]] = {
    "SYNC": (forever(frame(pdo.SYNC)), "another master sends SYNC on virtual:motors"),
    "NMT reset": (forever(frame(0, b"\x81\x00")), "another master sends NMT commands on virtual:motors"),
    "NMT stop": (forever(frame(0, b"\x02\x00")), "another master sends NMT commands on virtual:motors"),
    "NMT pre-operational": (forever(frame(0, b"\x80\x05")), "another master sends NMT commands on virtual:motors"),
    "heartbeats of a stopped drive": (
        forever(frame(pdo.HEARTBEAT + ARM, b"\x04")),
        r"node 5.* is stopped \(NMT\).*, but it answers SYNC.*another program seems to send as this node",
    ),
    "boot-up messages": (
        forever(frame(pdo.HEARTBEAT + ARM, b"\0")),
        r"node 5.* has restarted.*, but it answers SYNC.*another program seems to send as this node",
    ),
    "the robot's heartbeat": (
        forever(frame(pdo.HEARTBEAT + 127, b"\x05")),
        "another master sends heartbeats of node 127 on virtual:motors",
    ),
    "faults": (forever(status(DriveState.FAULT)), "node 5.*another program seems to send as this node"),
    "drives without power": (
        forever(status(DriveState.SWITCH_ON_DISABLED)),
        "node 5.*another program seems to send as this node",
    ),
    "positions that jump": (jumps, "node 5.*another program seems to send as this node"),
    "commands": (
        forever(frame(0x200 + ARM, struct.pack("<HBi", 0x0F, 8, 0))),
        "another master sends commands on virtual:motors",
    ),
}
"""Attacks that stop the robot, and the reason that it gives."""


def attack(robot: CanRobot, frames: Iterator[can.Message], seconds: float) -> list[str]:
    """Attack a robot for so long; returns the reasons of the stops that it has reported."""
    reasons: list[str] = []
    for _ in range(round(seconds / CYCLE)):
        inject(robot, *islice(frames, FRAMES_A_CYCLE))
        try:
            robot.advance(CYCLE)
        except DriveFault as error:
            reasons.append(str(error))
            break  # the robot's thread waits for Reset
    return reasons


def has_stopped(robot: CanRobot) -> bool:
    assert robot.fleet is not None
    return all(abs(drive.axis.velocity) < 0.02 for drive in robot.fleet.drives.values())


def drives_again(robot: CanRobot) -> bool:
    """True when a robot that was reset does what it is told."""
    robot.advance(CYCLE)
    robot.drive.set_effort(0.5, 0.0)
    robot.groups["arm"].command([Target(ControlMode.VELOCITY, 0.2), *[None] * 4])
    robot.advance(1.0)
    return robot.drive.twist().vx > 0.5


@pytest.mark.slow
@pytest.mark.parametrize("moving", [False, pytest.param(True, marks=pytest.mark.slow)], ids=["standing", "driving"])
@pytest.mark.parametrize("name", IGNORED)
def test_frames_that_change_nothing(robot: CanRobot, name: str, moving: bool) -> None:
    if moving:
        set_in_motion(robot)
    before, speed = robot.drive.pose().x, robot.drive.twist().vx
    assert attack(robot, IGNORED[name](random.Random(1)), LENGTH_OF_ATTACK) == []
    assert robot.master.running
    assert robot.drive.pose().x - before == pytest.approx(speed * LENGTH_OF_ATTACK, abs=0.05)
    assert robot.counters["ignored"] or name in {"emergencies", "NMT commands to other nodes"}


@pytest.mark.slow
@pytest.mark.parametrize("moving", [pytest.param(False, marks=pytest.mark.slow), True], ids=["standing", "driving"])
@pytest.mark.parametrize("name", STOPPING)
def test_frames_that_stop_the_robot_with_their_reason(robot: CanRobot, name: str, moving: bool) -> None:
    if moving:
        set_in_motion(robot)
    frames, said = STOPPING[name]
    reasons = attack(robot, frames(random.Random(1)), LENGTH_OF_ATTACK)
    assert len(reasons) == 1
    assert re.search(said, reasons[0]), reasons[0]
    for _ in range(80):  # the attack has ended, Reset did not come yet
        robot._ticker.wait_cycle()
    assert has_stopped(robot)
    assert drives_again(robot)


@pytest.mark.slow
def test_reset_during_an_attack_fails_with_a_reason_and_succeeds_after_it(robot: CanRobot) -> None:
    set_in_motion(robot)
    frames = forever(frame(pdo.SYNC))(random.Random(1))
    attack(robot, frames, LENGTH_OF_ATTACK)
    step = robot._ticker._fleet.step

    def attacked(dt: float) -> None:
        inject(robot, *islice(frames, 2))
        step(dt)

    robot._ticker._fleet.step = attacked
    with pytest.raises(DriveFault, match="another master sends SYNC"):
        robot.advance(CYCLE)
    robot._ticker._fleet.step = step
    assert drives_again(robot)


@pytest.mark.slow
def test_forged_answers_cannot_keep_a_robot_from_ending_its_start(open_can: OpenCan) -> None:
    robot = open_can()
    simulated(robot, "arm_2").boot()
    with pytest.raises(DriveFault):
        robot.advance(0.1)
    step, segment = robot.virtual_bus.near._send, [0x00]

    def with_endless_answers(message: can.Message) -> None:
        """Before the drive answers, a segment of an object that never ends."""
        if message.arbitration_id == 0x600 + ARM:
            first = b"\x40" + bytes(message.data[1:4]) + bytes(4)
            segment[0] ^= 0x10
            follows = bytes((segment[0] ^ 0x10,)) + b"endless"
            answer = first if message.data[0] == 0x40 else follows
            if message.data[0] == 0x40:
                segment[0] = 0x00
            robot.virtual_bus.far.send(frame(0x580 + ARM, answer))
            return
        step(message)

    robot.virtual_bus.near._send = with_endless_answers
    with pytest.raises(DriveFault, match=r"node 5"):
        robot.advance(CYCLE)
    robot.virtual_bus.near._send = step
    assert drives_again(robot)


def test_memory_stays_bounded_in_a_flood(robot: CanRobot) -> None:
    chance = random.Random(1)
    kinds = [make(chance) for make in (emergencies, answers_of_servers, IGNORED["LSS"], any_frame)]
    for frames in kinds:
        inject(robot, *islice(frames, 5000))
    network = robot._ticker.network
    assert all(len(node.emcy.log) < 100 for node in network.nodes.values())
    assert all(node.sdo.responses.qsize() < 100 for node in network.nodes.values())
    assert network.lss.responses.qsize() < 100
    assert len(robot.counters) < 30


def test_forged_positions_are_forgotten_by_reset(robot: CanRobot) -> None:
    """Alternating ends of the encoder would wind the count by turns of 32 bits."""
    ends = forever(*(status(DriveState.OPERATION_ENABLED, end) for end in (2**31 - 1, -(2**31), -1, 2**30)))
    attack(robot, ends(random.Random(1)), LENGTH_OF_ATTACK)
    assert drives_again(robot)
    assert abs(robot.drives["arm_2"].counts or 0) < 2**31


def test_a_forged_speed_does_not_become_a_command(robot: CanRobot) -> None:
    """A track begins a motion with the speed at which it was stopped, which may be forged."""
    drive = robot.drives["left_track"]
    drive.motion.hold()
    drive.receive_speed(pdo.SPEED_LAYOUT.pack(2**31 - 1, 9, 0))
    drive.motion.advance(drive, CYCLE)
    drive.ready = True
    drive.motion.drive(0.1)  # type: ignore[attr-defined] - of a track
    wanted = drive.motion.advance(drive, CYCLE)
    assert wanted is not None
    assert abs(wanted[1]) <= drive.joint.velocity


def test_a_drive_that_is_said_to_have_no_power_gets_a_quick_stop(robot: CanRobot) -> None:
    """And not what takes its power, with which an arm without a brake falls."""
    drive = robot.drives["arm_2"]
    drive.receive_status(status(DriveState.SWITCH_ON_DISABLED).data, 0.0)
    cob_id, data = drive.stop()
    assert cob_id == 0x200 + ARM
    assert data[0] == 0x02


@pytest.mark.slow
def test_real_drives_that_send_frames_of_another_length_are_silent(robot: CanRobot) -> None:
    set_in_motion(robot)
    assert robot.virtual_bus is not None
    receive = robot.virtual_bus.near_receives

    def shortened(message: can.Message) -> None:
        if message.arbitration_id == pdo.STATUS.cob_id + ARM:
            message = frame(message.arbitration_id, bytes(message.data[:6]))
        receive(message)

    robot.virtual_bus.near_receives = shortened
    reasons = attack(robot, iter(()), 0.5)
    assert len(reasons) == 1
    assert "has not answered SYNC" in reasons[0]


@pytest.mark.slow
async def test_the_counters_of_a_robot_contain_those_of_its_bus() -> None:
    async with VirtualNetwork() as network:
        runner = RobotRunner(robot_files.load("inc1"), network.transport, backend="can", realtime=VirtualTime)
        async with runner:
            assert runner.counters["robot.syncs"] > 0
            assert runner.counters["robot.ignored.length"] == 0
