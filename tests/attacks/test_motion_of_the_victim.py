"""The judge of `make attack`: what the robot does is compared with what its operator has commanded."""

from tools.attack.attack import Attack, Attacker, Bounds, Layout, Result, Victims
from tools.attack.truth import Leg, Motion, Sample, judge

PILOT = "42.1.2"


def sample(time: float, x: float = 0.0, y: float = 0.0, joint: float = 0.0, controller: str = PILOT) -> Sample:
    return Sample(time, (x, y, 0.0), (joint,), {"101.1.102": controller}, {"101.1.102": ["Ready"]})


STILL = [sample(number / 10) for number in range(10)]
DRIVE = [sample(1.0 + number / 10, x=number / 10) for number in range(11)]
AFTER = [sample(2.1 + number / 10, x=1.0) for number in range(20)]
FORWARD = Leg(1.0, 1.8, 1.0)


def test_a_robot_that_drives_as_commanded_did_not_move_without_a_command() -> None:
    assert judge([*STILL, *DRIVE, *AFTER], [FORWARD], PILOT) == Motion(0.0, 1, 1, 41, 41)


def test_a_robot_that_moves_while_nothing_was_commanded() -> None:
    assert judge([*STILL, *DRIVE], [], PILOT).moved == 1.0
    assert judge([*STILL, *DRIVE, *AFTER, sample(4.2, x=1.3)], [FORWARD], PILOT).moved == 0.30000000000000004


def test_a_robot_that_leaves_the_line_while_it_drives() -> None:
    assert judge([*STILL, *DRIVE, sample(2.05, x=1.0, y=0.2)], [FORWARD], PILOT).moved == 0.2


def test_a_joint_that_moves() -> None:
    assert judge([*STILL, sample(1.0, joint=0.4)], [], PILOT).moved == 0.4


def test_a_drive_that_was_not_carried_out() -> None:
    motion = judge([*STILL, *(sample(1.0 + number / 10) for number in range(20))], [FORWARD], PILOT)
    assert (motion.legs, motion.driven) == (1, 0)


def test_the_wrong_direction_is_not_the_drive_that_was_commanded() -> None:
    motion = judge([*STILL, *DRIVE, *AFTER], [Leg(1.0, 1.8, -1.0)], PILOT)
    assert motion.driven == 0


def test_somebody_else_in_control() -> None:
    motion = judge([*STILL, sample(1.0, controller="43.1.1"), sample(1.1, controller="None")], [], PILOT)
    assert (motion.samples, motion.controlled) == (12, 10)


def test_who_may_take_control_may_move_the_robot_from_then_on() -> None:
    taken = [*STILL, sample(1.0, controller="43.1.1"), sample(1.1, x=2.0, controller="43.1.1")]
    assert judge(taken, [], PILOT).moved == 2.0
    assert judge(taken, [], PILOT, may_be_taken=True).moved == 0.0
    lost = [*STILL, sample(1.0, x=0.3, controller="None"), *taken[-2:]]
    assert judge(lost, [], PILOT, may_be_taken=True).moved == 0.3


def test_each_of_these_breaks_a_bound() -> None:
    attack = Attack("a", Attacker.REMOTE, "datagrams", lambda _: None, Bounds(), Layout(Victims.COMMANDS))
    result = Result(attack, motion=Motion(0.3, 4, 1, 100, 90))
    result.compare()
    assert result.broken == [
        "a: without a command of its operator the robot moved by 0.3 m; the bound is 0.05 m",
        "a: 1 of 4 drives of the operator were carried out; the bound is 50%",
        "a: 90 of 100 times the operator was in control; the bound is 95%",
    ]
