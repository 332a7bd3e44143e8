"""A robot of a backend on virtual time, the component of one of its modules, and a client in control of it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from importlib.util import find_spec
from typing import Any

import pytest
from tests.helpers.robot import described
from tests.robot.cameras import FakeVideo

from jauspy.backends import find
from jauspy.codec.message import Message
from jauspy.ids import JausID
from jauspy.messages import manipulator as m, registry
from jauspy.messages.core import CommandEvent, RequestControl, Resume
from jauspy.platform.named_poses import NamedPose
from jauspy.robot.config import AccessControlConfig
from jauspy.robot.hosts import host_of

CLIENT, OTHER = JausID(42, 1, 1), JausID(42, 2, 1)
STEP = 0.01
START = datetime(2026, 1, 1, tzinfo=UTC)


class Workcell:
    """A robot, and the component of one of its modules."""

    def __init__(
        self,
        backend: str,
        robot: str,
        component: int,
        *,
        start: Mapping[str, Sequence[float]] | None = None,
        poses: Sequence[NamedPose] = (),
    ) -> None:
        """`start`: initial positions of groups, in place of those of the robot's file; `poses`: beside those."""
        config, model = described(robot)
        groups = {name: replace(model.groups[name], start=tuple(values)) for name, values in (start or {}).items()}
        model = replace(model, groups={**model.groups, **groups}, poses=(*model.poses, *poses))
        self.backend = backend
        self.model = model
        self.robot = find(backend).open(model, "empty")
        self.now = 0.0
        (module,) = (each for each in config.modules if each.component == component)
        module = module.model_copy(update={"access_control": AccessControlConfig(timeout=0)})
        self.host = host_of(
            config,
            module,
            model,
            self.robot,
            {},
            videos={camera.name: FakeVideo(camera) for camera in model.cameras},
            utc_now=lambda: START + timedelta(seconds=self.now),
            now=0.0,
        )

    def tell(self, *messages: Message, client: JausID = CLIENT) -> list[Message]:
        for message in messages:
            self.host.receive(message.encode(), client, self.now)
        sent = self.host.poll_output(self.now)
        for each in sent:
            if each.on_acknowledged is not None:
                each.on_acknowledged(True)  # as a client's endpoint acknowledges it
        return [registry.decode(each.payload, service=_service(each.payload)) for each in sent]

    def ask(self, query: Message) -> Any:
        """The one answer; what the component sends unasked is left out."""
        answers, report = self.tell(query), getattr(query, "REPORT", None)
        if len(answers) > 1 and report is not None:
            answers = [each for each in answers if report.CODE == each.CODE]
        (answer,) = answers
        return answer

    def take_control(self, client: JausID = CLIENT) -> None:
        self.tell(RequestControl(200), Resume(), client=client)

    def run(self, seconds: float, each: Callable[[], None] | None = None) -> None:
        for _ in range(round(seconds / STEP)):
            self.robot.advance(STEP)
            self.now += STEP
            while (due := self.host.next_timeout()) is not None and due <= self.now:
                self.host.handle_timeout(self.now)
            if each is not None:
                each()

    def positions(self) -> list[float]:
        return [r.joint_position.value for r in self.ask(m.QueryJointPositions()).joint_position_list]

    def velocities(self) -> list[float]:
        return [r.joint_velocity.value for r in self.ask(m.QueryJointVelocity()).joint_velocity_list]


def _service(payload: bytes) -> str | None:
    """Ids of the manipulator set have other meanings in its old version and in other sets."""
    found = registry.by_code(int.from_bytes(payload[:2], "little"))
    newest = [cls for cls in found if ":manipulator:" in cls.SERVICE and cls.VERSION == "2.0"]
    return newest[0].SERVICE if newest else None


_HAS_MUJOCO = find_spec("mujoco") is not None

BACKENDS = [
    pytest.param("kinematic", marks=[pytest.mark.slow] if _HAS_MUJOCO else []),
    pytest.param(
        "can",
        marks=[pytest.mark.slow, pytest.mark.skipif(find_spec("canopen") is None, reason="canopen is not installed")],
    ),
    pytest.param("sim", marks=pytest.mark.skipif(not _HAS_MUJOCO, reason="MuJoCo is not installed")),
]
"""Modules are tested on the simulator, and in the slow tests on the kinematic backend and on simulated drives, too."""


def outcomes(cell: Workcell, *messages: Message) -> list[int]:
    """How commands ended, of which command events tell now: 0 is carried out."""
    return [int(each.command_result) for each in cell.tell(*messages) if isinstance(each, CommandEvent)]
