"""Our robots in memory: the same services as with `jauspy up`, on the kinematic backend and virtual time.

Nobody opens the cameras: they take orders, and their pictures are empty.
"""

from __future__ import annotations

from collections.abc import Callable
from datetime import UTC, datetime, timedelta
from functools import cache

from jauspy import backends
from jauspy.conformance import Profile, Report, Settings, TargetComponent, VirtualTarget, find, run
from jauspy.ids import JausID
from jauspy.platform.description import RobotModel
from jauspy.platform.video_settings import Still, StillSettings
from jauspy.robot import robot_files
from jauspy.robot.hosts import host_of
from jauspy.robot.robot_files import robot_model
from jauspy.robot.runner import announcement
from jauspy.video.camera_process import CameraProcess, StillCallback

START = datetime(2026, 3, 14, 15, 9, 26, 535000, tzinfo=UTC)
TARGET = JausID(105, 1, 255)

Maker = Callable[..., VirtualTarget]


@cache
def _model(name: str) -> RobotModel:
    """The body, which no robot changes; reading it takes longer than most runs."""
    return robot_model(robot_files.load(name))


class Cameraman(CameraProcess):
    """Has each picture at once."""

    def take(self, settings: StillSettings, then: StillCallback) -> None:
        then(Still(b"", 0.0))


def robot(
    part: type[TargetComponent] = TargetComponent,
    virtual_target: type[VirtualTarget] = VirtualTarget,
    *,
    name: str = "igvc",
    timeout: int | None = None,
    component: int | None = None,
    backend: str = "kinematic",
    **options: object,
) -> VirtualTarget:
    """The whole robot, or one `component` of it, which is made faster.

    `part` and `virtual_target` may be broken ones, `timeout` is that of its access control, `backend` moves it.
    """
    config = robot_files.load(name)
    if timeout is not None:
        access = config.modules[0].access_control.model_copy(update={"timeout": timeout})
        modules = tuple(each.model_copy(update={"access_control": access}) for each in config.modules)
        config = config.model_copy(update={"modules": modules})
    model = _model(name)
    body = backends.find(backend).open(model, config.world)
    videos = {each.name: Cameraman(body.cameras[each.name], each.settings()) for each in config.cameras}
    made: list[VirtualTarget] = []

    def utc_now() -> datetime:
        return START + timedelta(seconds=made[0].now() if made else 0.0)

    parts = []
    for module in (each for each in config.modules if component in (None, each.component)):
        host = host_of(config, module, model, body, {}, videos=videos, utc_now=utc_now, now=0.0)
        parts.append(part(host, announcement(host, module) or (lambda _: False)))
    made.append(virtual_target(parts, **({"tick": body.advance} | options)))
    return made[0]


def examined(
    profile: str | Profile, virtual_target: VirtualTarget, target: JausID = TARGET, **settings: object
) -> Report:
    """A run against it."""
    chosen = find(profile) if isinstance(profile, str) else profile
    return run(chosen, virtual_target, target, began=START.timestamp(), settings=Settings(**settings))
