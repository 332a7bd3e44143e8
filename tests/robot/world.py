"""A CM-MOB on a robot of some backend, both on virtual time, and a client in control of it."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import replace
from datetime import UTC, datetime, timedelta

from tests.helpers.robot import described

from jauspy.backends import find
from jauspy.codec.message import Message
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.core import (
    ConfirmElementRequest,
    ElementRec,
    RequestControl,
    Resume,
    SetElement,
)
from jauspy.messages.mobility import QueryActiveElement, QueryGlobalPose, QueryLocalPose, QueryVelocityState
from jauspy.platform.chassis import chassis_of
from jauspy.platform.contract import Robot
from jauspy.platform.localization import EXACT, Localization, LocalizedDrive
from jauspy.robot.config import ModuleConfig
from jauspy.robot.hosts import module_host
from jauspy.robot.kinds import MobilityContext
from jauspy.services.iop.comms_lost import CommsLostPolicy
from jauspy.services.mobility import GlobalPose, Vehicle
from jauspy.services.mobility.retraced_joints import OwnMotion, joints_with_tracks

ME, CLIENT, OTHER = JausID(101, 1, 102), JausID(42, 1, 1), JausID(42, 2, 1)
STEP = 0.01
START = datetime(2026, 1, 1, tzinfo=UTC)
ORIGIN = GlobalPose(38.593, -77.179, 20.0, math.radians(30.0))


class World:
    """Time passes in steps of the robot; the component's timers run in between, and cost nothing."""

    def __init__(
        self,
        backend: str,
        origin: GlobalPose | None = ORIGIN,
        *,
        robot: Robot | None = None,
        localization: Localization | None = None,
        timeout: int = 0,
        comms_lost: dict[str, object] | None = None,
    ) -> None:
        self.backend = backend
        _, model = described("inc1")
        self.robot = find(backend).open(replace(model, localization=EXACT), "empty") if robot is None else robot
        self.now = 0.0
        drive = self.robot.drive if localization is None else LocalizedDrive(self.robot.drive, localization)
        self.vehicle = Vehicle(drive, name="inc1", chassis=chassis_of(model), origin=origin, localization=localization)
        self.own_motion = OwnMotion()
        policy = ModuleConfig(type="CM-MOB", component=102, comms_lost=comms_lost).comms_lost or CommsLostPolicy()
        context = MobilityContext(
            self.robot,
            self.vehicle,
            flippers=joints_with_tracks(model, self.robot.groups),
            own_motion=self.own_motion,
            comms_lost=policy,
        )
        config = ModuleConfig(type="CM-MOB", component=102, access_control={"timeout": timeout}, command_timeout="off")
        self.host = module_host(
            ME,
            config,
            context,
            identities={},
            utc_now=lambda: START + timedelta(seconds=self.now),
            now=self.now,
            own_motion=self.own_motion,
        )

    def tell(self, *messages: Message, client: JausID = CLIENT) -> list[Message]:
        for message in messages:
            self.host.receive(message.encode(), client, self.now)
        return [registry.decode(each.payload) for each in self.host.poll_output(self.now)]

    def ask(self, query: Message) -> Message:
        (answer,) = self.tell(query)
        return answer

    def run(self, seconds: float, each: Callable[[], None] | None = None) -> None:
        for _ in range(round(seconds / STEP)):
            self.robot.advance(STEP)
            self.now += STEP
            while (due := self.host.next_timeout()) is not None and due <= self.now:
                self.host.handle_timeout(self.now)
            if each is not None:
                each()

    def run_until(self, condition: Callable[[], bool], seconds: float, each: Callable[[], None] | None = None) -> None:
        end = self.now + seconds
        while not condition():
            assert self.now < end, f"not within {seconds} s; {self.vehicle.pose}"
            self.run(STEP, each)

    # --- what the robot says of itself

    def take_control(self) -> None:
        self.tell(RequestControl(200), Resume())

    @property
    def pose(self):
        return self.ask(QueryLocalPose(0xFFFF))

    @property
    def velocity(self):
        return self.ask(QueryVelocityState(0xFFFF))

    @property
    def place(self):
        return self.ask(QueryGlobalPose(0xFFFF))

    @property
    def active(self) -> int:
        return self.ask(QueryActiveElement()).element_uid

    def distance(self, x: float, y: float) -> float:
        """Metres from a point of the local frame."""
        pose = self.pose
        return math.hypot(pose.x - x, pose.y - y)

    def stands(self) -> bool:
        velocity = self.velocity
        return math.hypot(velocity.velocity_x, velocity.velocity_y) < 0.01 and abs(velocity.yaw_rate) < 0.01

    def set_list(self, messages: Iterable[Message]) -> None:
        """Elements 1, 2, 3 ... in this order."""
        messages = list(messages)
        elements = [
            ElementRec(
                element_uid=uid,
                previous_uid=uid - 1,
                next_uid=uid + 1 if uid < len(messages) else 0,
                element_data=ElementRec.ElementData(format=0, data=message),
            )
            for uid, message in enumerate(messages, 1)
        ]
        answer = self.ask(SetElement(SetElement.RequestIDRec(7), elements))
        assert answer == ConfirmElementRequest(7)
