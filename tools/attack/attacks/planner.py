"""Requests to the planner of the arm: damaged, with values at all limits, and far more than it can plan."""

from __future__ import annotations

import math
import random
import socket
import time
from collections.abc import Iterator

from jauspy.codec.message import Message
from jauspy.errors import JausError
from jauspy.ids import JausID
from jauspy.messages.core import RequestControl, Resume
from jauspy.messages.planning import (
    CancelMotion,
    ExecuteMotion,
    PlanMotion,
    QueryMotionPlan,
    QueryMotionPlannerState,
    ReportMotionPlannerState,
    SetHeldObject,
)
from jauspy.protocol import judp
from jauspy.protocol.header import Packet

from ..arena import Arena
from ..attack import Attack, Attacker, Bounds, Layout
from ..stage import PLANNER_ID
from .malformed import damaged

RATE = 150
CLIENT = JausID.parse("43.1.9")
"""Who is entitled to control the planner, since nobody else does; the arm is controlled by the operator."""
PLANNER = JausID.parse(PLANNER_ID)
NUMBERS = (0.0, 0.3, -0.3, math.nan, math.inf, -math.inf, 1e6, -1e6, 1e300, 5e-324, math.pi)
LIMITS = (0.0, 0.05, 10.0, 3e38, math.inf, math.nan, -1.0)
FRAMES = ("", "base_link", "tool_link", "gripper_link", "x" * 255, "\x1b[2J", "..")
JOINTS = ("base_link_to_arm_link_1", "arm_link_1_to_arm_link_2", "", "x" * 255, "arm")
LARGEST = 1400
"""Bytes of a request; larger ones go in fragments, which `fragments` attacks."""
SILENCE = 3.0
"""Seconds in which it answers a query at least once, although it plans all the while."""
AFTERWARDS = 10.0
"""Seconds in which it makes a plan after the last of these requests."""


def run(arena: Arena) -> None:
    """It answers all the while, and afterwards it plans at once."""
    chance, sock = arena.chance, arena.open(arena.attacker.udp())
    requests, answers, heard = _requests(chance), 0, 0.0
    for number in arena.paced(RATE):
        if number % 100 == 0:
            _take_control(arena, sock)
        _send(arena, sock, QueryMotionPlannerState() if number % 20 == 1 else next(requests))
        if number % 5 == 2:
            payload = damaged(chance, next(requests).encode(strict=False))[:LARGEST]
            arena.send(sock, judp.pack(Packet(CLIENT, PLANNER, payload, number & 0xFFFF)))
        now = time.monotonic()
        for _ in _states(sock):
            answers, heard = answers + 1, now
        arena.require(not heard or now - heard < SILENCE, f"the planner did not answer for {now - heard:.1f} s")
    arena.require(answers > 0, "the planner never answered")
    _plans_afterwards(arena, sock)


def _take_control(arena: Arena, sock: socket.socket) -> None:
    _send(arena, sock, RequestControl(authority_code=255))
    _send(arena, sock, Resume())


def _plans_afterwards(arena: Arena, sock: socket.socket) -> None:
    """A plan close to where the arm is, by a client that has asked for nothing else, with nothing in the gripper."""
    wanted, end = 4_000_000, time.monotonic() + AFTERWARDS
    goal = PlanMotion.JointGoalList([PlanMotion.JointGoalRec("base_link_to_arm_link_1", 0.2)])
    _take_control(arena, sock)
    _send(arena, sock, SetHeldObject(SetHeldObject.Shape.NOTHING, "", *[0.0] * 9))
    _send(arena, sock, PlanMotion(PlanMotion.PlanRec(wanted, 0.5), goal))
    phase = "silent"
    while time.monotonic() < end:
        _send(arena, sock, QueryMotionPlannerState())
        time.sleep(0.1)
        for state in _states(sock):
            if state.plan_number == wanted:
                phase = ReportMotionPlannerState.Phase(state.phase).name
        if phase == "PLANNED":
            return
    arena.require(False, f"{AFTERWARDS:g} s after the last request it had no plan for the next one: it is {phase}")


def _requests(chance: random.Random) -> Iterator[Message]:
    """Requests of all kinds, without end."""
    kind = PlanMotion

    def number() -> float:
        return chance.choice(NUMBERS)

    def pose() -> tuple[str, float, float, float, float, float, float]:
        return chance.choice(FRAMES), number(), number(), number(), number(), number(), number()

    while True:
        names = [chance.choice(JOINTS) for _ in range(chance.choice((0, 1, 2, 40)))]
        region = kind.GoalRegionRec(number(), number(), number(), number())
        goal = chance.choice(
            (
                kind.JointGoalList([kind.JointGoalRec(name, number()) for name in names]),
                kind.JointGoalList([kind.JointGoalRec(JOINTS[0], chance.uniform(-1.5, 1.5))]),
                kind.PoseGoalRec(*pose()),
                kind.PoseGoalRec("base_link", chance.uniform(0.2, 1.0), *(chance.uniform(-1.0, 1.0) for _ in range(5))),
                kind.PointGoalRec(*pose()),
                kind.PointGoalRec("", chance.uniform(-2.0, 2.0), chance.uniform(-2.0, 2.0), 0.5, 0.0, 0.0, 0.0),
                kind.RegionGoalSeq(kind.GoalPoseRec(*pose()), region),
            )
        )
        plan = kind(kind.PlanRec(chance.choice((0, 1, 2, 2**32 - 1)), chance.choice(LIMITS)), goal)
        execute = ExecuteMotion(chance.choice((0, 1, 2, 2**32 - 1)), chance.choice((0, 3, 255)))
        held = SetHeldObject(
            chance.choice((0, 1, 2, 3, 255)),
            chance.choice(FRAMES),
            *(number() for _ in range(6)),
            *(abs(number()) for _ in range(3)),
        )
        yield chance.choice((plan, plan, plan, plan, held, execute, CancelMotion(), QueryMotionPlan()))


def _packet(message: Message, chance: random.Random) -> bytes:
    return judp.pack(Packet(CLIENT, PLANNER, message.encode(strict=False), chance.randrange(1 << 16)))


def _send(arena: Arena, sock: socket.socket, message: Message) -> None:
    if len(message.encode(strict=False)) < LARGEST:
        arena.send(sock, _packet(message, arena.chance))


def _states(sock: socket.socket) -> Iterator[ReportMotionPlannerState]:
    """The reports of the planner's state that have arrived."""
    while True:
        try:
            data = sock.recv(70000)
        except BlockingIOError:
            return
        try:
            for packet in judp.unpack(data):
                if packet.source == PLANNER:
                    yield ReportMotionPlannerState.decode(packet.payload)
        except JausError:
            continue  # another message, or a fragment of the plan


BOUNDS = Bounds(memory=64.0, lines=200)
"""A plan has arrays of some megabytes while it is made."""
ATTACK = Attack("planner", Attacker.REMOTE, "requests", run, BOUNDS, Layout(planner=True), restarts=True)
