"""What `watch` asks single components for: all of it soon, in a fleet too, and never much at once."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest

from jauspy.codec.message import Message
from jauspy.ids import JausID
from jauspy.messages.core import QueryIdentification, QueryServices, ReportHeartbeatPulse, ReportIdentification
from jauspy.ocu.follow_ups import FOLLOW_UP_INTERVAL, MAX_FOLLOW_UP_INTERVAL, MAX_FOLLOW_UPS, FollowUps, Renewals
from jauspy.ocu.subsystems import Level, SubsystemTree

ROBOTS, COMPONENTS = 50, 8


class Line:
    """Stands for the connection."""

    def __init__(self) -> None:
        self.sent: list[tuple[JausID, Message]] = []

    def send(self, id: JausID, message: Message) -> None:
        self.sent.append((id, message))

    def take(self) -> list[tuple[JausID, Message]]:
        sent, self.sent = self.sent, []
        return sent


@pytest.fixture
def tree() -> SubsystemTree:
    """All of a fleet have shown that they are there, and nothing else."""
    tree = SubsystemTree()
    for robot in range(1, 1 + ROBOTS):
        for number in range(1, 1 + COMPONENTS):
            tree.add(ReportHeartbeatPulse(), JausID(robot, 1, number), 0.0)
    return tree


def test_all_is_asked_for_once_and_little_at_a_time(tree: SubsystemTree) -> None:
    line, asked, now = Line(), [], 0.0
    follow_ups = FollowUps(line, tree)  # type: ignore[arg-type]
    while now < FOLLOW_UP_INTERVAL:
        next_at = follow_ups.send(now)
        batch = line.take()
        assert len(batch) <= MAX_FOLLOW_UPS
        asked += batch
        now = max(next_at, now + 0.01)
    kinds = [(int(query.query_type) if isinstance(query, QueryIdentification) else 0, id) for id, query in asked]
    assert len(set(kinds)) == len(kinds), "nobody is asked again so soon"
    begun = sorted({id.subsystem for _, id in kinds})
    assert begun == list(range(1, 1 + len(begun))), "one robot after the other"
    per_robot = 2 * COMPONENTS + 2  # names and services of components, names of the node and of the robot
    assert all(sum(id.subsystem == robot for _, id in kinds) == per_robot for robot in begun[:-1])
    assert len(kinds) <= MAX_FOLLOW_UPS * (1 + FOLLOW_UP_INTERVAL / 0.1)


def test_one_of_those_with_a_common_name_is_asked_another_one_next_time(tree: SubsystemTree) -> None:
    line = Line()
    follow_ups = FollowUps(line, tree)  # type: ignore[arg-type]
    for id in list(tree):
        tree.add(ReportIdentification(Level.COMPONENT, 0, "component"), id, 0.0)
        tree.add(ReportIdentification(Level.SUBSYSTEM, 0, "robot"), id, 0.0)
    nodes: list[list[JausID]] = []
    for now in (0.0, 100.0, 200.0, 300.0):
        for step in range(9):
            follow_ups.send(now + 0.1 * step)
        nodes.append([id for id, query in line.take() if isinstance(query, QueryIdentification)])
    for batch in nodes:
        assert sorted(id.subsystem for id in batch) == list(range(1, 1 + ROBOTS))
    assert len({batch[0] for batch in nodes}) == len(nodes)


@pytest.mark.slow
def test_who_never_answers_is_asked_less_and_less(tree: SubsystemTree) -> None:
    line, now, times = Line(), 0.0, []
    follow_ups = FollowUps(line, tree)  # type: ignore[arg-type]
    while now < 200.0:
        next_at = follow_ups.send(now)
        times += [now] * sum(
            id == JausID(1, 1, 1) and not isinstance(query, QueryIdentification) for id, query in line.take()
        )
        now = max(next_at, now + 0.1)
    pauses = [round(second - first, 3) for first, second in pairwise(times)]
    assert pauses == sorted(pauses)
    assert pauses[-1] == pytest.approx(MAX_FOLLOW_UP_INTERVAL, abs=0.5)


def test_nothing_is_asked_when_all_is_known() -> None:
    line = Line()
    assert FollowUps(line, SubsystemTree()).send(0.0) == math.inf  # type: ignore[arg-type]
    assert line.sent == []


def test_values_of_a_tree_follow_every_change(tree: SubsystemTree) -> None:
    """They are kept until something changes."""
    assert tree.subsystems(0.5) == ()
    assert len(tree.subsystems(1.0)) == ROBOTS
    assert tree.subsystems(2.0)[0] is tree.subsystems(3.0)[0]
    size, id = tree.size, JausID(1, 1, 2)
    tree.add(ReportIdentification(Level.COMPONENT, 0, "arm"), id, 3.0)
    assert tree.size == size + 1
    assert tree.subsystems(3.0)[0].components[1].name == "arm"
    tree.add(ReportIdentification(Level.COMPONENT, 0, "gripper"), id, 3.0)
    assert tree.size == size + 1
    assert tree.subsystems(3.0)[0].components[1].name == "gripper"
    tree.expire(2.0)
    assert [component.id for robot in tree.subsystems(9.0) for component in robot.components] == [id]
    assert tree.size == 3, "it is there, it responds, and it has a name"


def test_all_are_asked_again_in_turn(tree: SubsystemTree) -> None:
    line = Line()
    renewals = Renewals(line, tree)  # type: ignore[arg-type]
    everybody = list(tree)
    assert renewals.rounds == math.ceil(len(everybody) / MAX_FOLLOW_UPS)
    asked: list[JausID] = []
    for _ in range(renewals.rounds):
        renewals.send()
        batch = line.take()
        assert len(batch) == MAX_FOLLOW_UPS
        assert all(isinstance(query, QueryServices) for _, query in batch)
        asked += [id for id, _ in batch]
    assert asked[: len(everybody)] == everybody
    tree.expire(1.0)
    renewals.send()
    assert (line.take(), renewals.rounds) == ([], 0), "a few are asked by broadcast"
