"""Emergency, and the loss of the client in control, stop tracks and arm within 200 ms of the robot's time.

Stopped is: chassis and surfaces of the belts, or all joints of the arm, are slower than `STILL`, and stay so. From
full speed. The chassis may still rock on its tracks, and the arm swing with it, as springs do.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from datetime import UTC, datetime, timedelta

import pytest
from tests.helpers.robot import described
from tests.helpers.sampling import sampled
from tests.robot.workcell import BACKENDS

from jauspy.backends import find
from jauspy.codec.message import Message
from jauspy.ids import JausID
from jauspy.messages import manipulator as m
from jauspy.messages.core import ReleaseControl, RequestControl, Resume, SetEmergency
from jauspy.messages.mobility import SetWrenchEffort
from jauspy.platform.joints import ControlMode, Target
from jauspy.robot import realtime
from jauspy.robot.config import AccessControlConfig
from jauspy.robot.hosts import host_of
from jauspy.services.core import may_move

CLIENT = JausID(42, 1, 1)
START = datetime(2026, 1, 1, tzinfo=UTC)
STEP = 0.002
SILENCE = 1
"""Seconds after which a client that says nothing has lost control."""

LIMIT = 0.2 - realtime.STEP
"""A command waits for one step of the robot's thread at most."""
STILL = 0.02
"""m/s, rad/s for joints."""
TURNING = 0.05
"""rad/s of the chassis: 12 mm/s at a track."""


class Cell:
    """A robot on virtual time, and the component of one of its modules with a client in control."""

    def __init__(self, backend: str, robot: str, component: int) -> None:
        config, self.model = described(robot)
        self.robot = find(backend).open(self.model, "empty")
        self.now = 0.0
        (module,) = (each for each in config.modules if each.component == component)
        module = module.model_copy(update={"access_control": AccessControlConfig(timeout=SILENCE)})
        self.host = host_of(
            config, module, self.model, self.robot, {}, utc_now=lambda: START + timedelta(seconds=self.now), now=0.0
        )

    def tell(self, *messages: Message) -> None:
        for message in messages:
            self.host.receive(message.encode(), CLIENT, self.now)
        self.host.poll_output(self.now)

    def step(self, dt: float = STEP) -> None:
        self.robot.advance(dt)
        self.now += dt
        while (due := self.host.next_timeout()) is not None and due <= self.now:
            self.host.handle_timeout(self.now)

    def obey(self, command: Message, seconds: float) -> None:
        self.tell(RequestControl(200), Resume())
        for _ in range(round(seconds / 0.1)):
            self.tell(RequestControl(200), command)
            self.step(0.1)
        assert may_move(self.host)

    def tracks(self) -> dict[str, float]:
        """Speeds of the chassis, and of the belts' surfaces."""
        twist = self.robot.drive.twist()
        speeds = {"chassis": math.hypot(twist.vx, twist.vy), "turn": twist.wz * STILL / TURNING}
        return speeds | {name: self._belt(name) for name in self.model.tracks.left + self.model.tracks.right}

    def arm(self) -> dict[str, float]:
        """Speeds of the joints."""
        arm = self.robot.groups["arm"]
        rows = zip(arm.joints, arm.state().velocities, strict=True)
        return {joint.name: velocity for joint, velocity in rows}

    def _belt(self, name: str) -> float:
        """Speed of its surface; the kinematic robot has none apart from the chassis'."""
        data = getattr(self.robot, "data", None)
        return 0.0 if data is None else float(data.joint(f"{self.model.description.name}/{name}").qvel[0])


def tell(message: Message) -> Callable[[Cell], None]:
    return lambda cell: cell.tell(message)


def fall_silent(cell: Cell) -> None:
    """Until control is lost; not a step longer."""
    while may_move(cell.host):
        cell.step()
        assert cell.now < 20.0


ENDS = {"emergency": tell(SetEmergency(1)), "release": tell(ReleaseControl()), "silence": fall_silent}


@pytest.fixture(params=ENDS)
def end(request: pytest.FixtureRequest) -> Callable[[Cell], None]:
    return ENDS[request.param]


@pytest.fixture(params=BACKENDS)
def backend(request: pytest.FixtureRequest) -> str:
    return str(request.param)


def assert_stops(cell: Cell, speeds: Callable[[], dict[str, float]], end: Callable[[Cell], None]) -> None:
    assert max(map(abs, speeds().values())) > STILL
    end(cell)
    begin = cell.now
    while cell.now < begin + 1.0:
        cell.step()
        if cell.now - begin >= LIMIT:
            moves = {name: speed for name, speed in speeds().items() if abs(speed) > STILL}
            assert not moves, f"after {cell.now - begin:.3f} s"


@pytest.mark.slow
@pytest.mark.parametrize(
    ("robot", "ahead", "turn"),
    sampled(
        [("inc1", 60.0, 0.0), ("inc1", -60.0, 0.0), ("inc1", 0.0, 90.0), ("inc1_pprm", 60.0, 0.0)], 2, several=True
    ),
)
def test_tracks_stop_within_200_ms(
    backend: str, robot: str, end: Callable[[Cell], None], ahead: float, turn: float
) -> None:
    cell = Cell(backend, robot, 102)
    cell.obey(SetWrenchEffort(propulsive_linear_effort_x=ahead, propulsive_rotational_effort_z=turn), 1.5)
    twist = cell.robot.drive.twist()
    assert abs(twist.vx) > 0.9 or abs(twist.wz) > 2.0
    assert_stops(cell, cell.tracks, end)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("robot", "way"),
    sampled([("inc1", 1.0), ("inc1", -1.0), ("inc1_pprm", 1.0), ("inc1_pprm", -1.0)], 1, several=True),
)
def test_arm_stops_within_200_ms(backend: str, robot: str, end: Callable[[Cell], None], way: float) -> None:
    """Every joint at its full speed, from where it has the room for that."""
    cell = Cell(backend, robot, 104)
    arm = cell.robot.groups["arm"]
    room = [j.velocity * (0.5 + SILENCE) for j in arm.joints]
    begin = [
        (j.lower + j.upper - way * min(most, j.upper - j.lower)) / 2 for j, most in zip(arm.joints, room, strict=True)
    ]
    arm.command([Target(ControlMode.POSITION, value) for value in begin])
    cell.robot.advance(4.0)
    cell.obey(_at_full_speed(cell, way), 0.4)
    full = zip(arm.state().velocities, arm.joints, strict=True)
    assert all(abs(velocity) > 0.9 * joint.velocity for velocity, joint in full)
    assert_stops(cell, cell.arm, end)


def _at_full_speed(cell: Cell, way: float) -> m.SetJointVelocity:
    make, choice = m.JointVelocityRec.JointVelocity, m.JointVelocityRec.JointVelocityChoice
    kinds = {"revolute": choice.RADIAN_PER_SECOND, "prismatic": choice.METER_PER_SECOND}
    joints = cell.robot.groups["arm"].joints
    return m.SetJointVelocity(
        [m.JointVelocityRec(make(kinds[joint.kind.value], way * joint.velocity)) for joint in joints]
    )
