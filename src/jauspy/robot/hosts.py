"""Makes the host of each module of a robot: core services, those of its kind, and a watchdog on what it moves."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from datetime import datetime
from typing import Final

from jauspy.errors import ConfigError
from jauspy.ids import JausID, message_id
from jauspy.messages.core import QueryIdentification, ReportIdentification
from jauspy.platform.contract import RobotParts
from jauspy.platform.description import RobotModel
from jauspy.platform.stability import stability_of
from jauspy.protocol.header import Broadcast, Packet
from jauspy.robot import catalogue
from jauspy.robot.config import ModuleConfig, RobotConfig
from jauspy.robot.kinds import Context, ModuleBuild, Shared, Stoppable
from jauspy.services.command_timeout import ContinuousCommands
from jauspy.services.core import (
    AccessControl,
    Discovery,
    Events,
    Identity,
    Liveness,
    Management,
    Time,
    Transport,
    may_move,
    waits_for_control,
)
from jauspy.services.environment_sensing import VideoSource
from jauspy.services.host import Host
from jauspy.services.mobility.retraced_joints import OwnMotion
from jauspy.services.service import Service

NO_VIDEOS: Final[Mapping[str, VideoSource]] = {}

WATCHDOG_PERIOD: Final = 0.1
"""Seconds between two checks."""

ANNOUNCEMENT_PERIOD: Final = 5.0
"""Seconds between two queries."""
CONSOLE_SILENCE: Final = 10.0
"""Seconds without a packet from a console that has answered, after which it may have left."""


def host_of(
    config: RobotConfig,
    module: ModuleConfig,
    model: RobotModel,
    robot: RobotParts,
    identities: Mapping[int, Identity],
    *,
    videos: Mapping[str, VideoSource] = NO_VIDEOS,
    utc_now: Callable[[], datetime],
    now: float,
    more: Sequence[Service] = (),
    shared: Shared | None = None,
) -> Host:
    """The host of a module. `videos`: the cameras by name. `now`: seconds of the clock that runs it.

    `more`: services besides those that `module` names. `shared`: what it shares with the robot's other modules.
    """
    build = _build(config, module, model, robot, videos, shared=shared)
    context = module.kind.context(build)
    return module_host(
        build.id,
        module,
        context,
        identities=identities,
        utc_now=utc_now,
        now=now,
        more=more,
        own_motion=build.shared.own_motion,
    )


def check_parts(config: RobotConfig, module: ModuleConfig, model: RobotModel, robot: RobotParts) -> None:
    """Check that the backend has what a module needs that is not present yet; raises `ConfigError`."""
    module.kind.context(_build(config, module, model, robot, NO_VIDEOS))


def _build(
    config: RobotConfig,
    module: ModuleConfig,
    model: RobotModel,
    robot: RobotParts,
    videos: Mapping[str, VideoSource],
    *,
    shared: Shared | None = None,
) -> ModuleBuild:
    return ModuleBuild(
        id=config.id_of(module),
        module=module,
        modules={config.id_of(other): other for other in config.modules},
        name=config.name,
        origin=config.origin.pose() if config.origin else None,
        model=model,
        robot=robot,
        videos=videos,
        video_targets=config.video_targets,
        shared=shared or Shared(reminders=config.health.reminders, stability=stability_of(model, robot)),
    )


def module_host(
    id: JausID,
    config: ModuleConfig,
    context: Context,
    *,
    identities: Mapping[int, Identity],
    utc_now: Callable[[], datetime],
    now: float,
    more: Sequence[Service] = (),
    own_motion: OwnMotion | None = None,
) -> Host:
    """The host of a module whose services are made from `context`, with a watchdog on what it moves.

    `own_motion`: what the robot moves without a client in control; nothing by default.
    """
    access = config.access_control
    core: list[Service] = [
        Transport(),
        Events(),
        AccessControl(default_authority=access.default_authority, timeout=access.timeout),
        Management(),
        *more,
    ]
    optional: dict[str, Callable[[], Service]] = {
        "Discovery": lambda: Discovery(identities, registrants=config.registrants),
        "Time": Time,
        "Liveness": Liveness,
    }
    core += [make() for name, make in optional.items() if config.offers(name)]
    try:
        services = catalogue.make(config.type, config.services, context)
    except ConfigError as error:
        raise ConfigError(f"{id}: {error}") from error
    services += config.kind.companions(context, services)
    if config.older_versions:
        services += config.kind.older_versions(context, services)
    for service in services:
        if isinstance(service, ContinuousCommands):
            service.command_timeout = config.command_timeout_of(service.urn.rpartition(":")[2])
    host = Host(id, [*core, *services], utc_now=utc_now, now=now, older_versions=config.older_versions)
    if context.moving is not None:
        moved = config.kind.moved(config) or config.type
        ModuleWatchdog(host, context.moving, moved, own_motion or OwnMotion())
    return host


class ModuleWatchdog:
    """Stops all motion of a component whenever its state does not allow motion.

    This is redundant: the services stop motion themselves, unless they have a bug. It does not stop `part`, what the
    module moves, while that is among the parts that the robot moves by itself and nobody controls the module.
    """

    def __init__(self, host: Host, moving: Stoppable, part: str, own_motion: OwnMotion) -> None:
        self._host = host
        self._moving = moving
        self._part = part
        self._own_motion = own_motion
        self._check()
        host.repeat("watchdog", WATCHDOG_PERIOD, self._check)

    def _check(self) -> None:
        if may_move(self._host):
            self._own_motion.controlled.add(self._part)
            return
        self._own_motion.controlled.discard(self._part)
        if self._part not in self._own_motion.parts or not waits_for_control(self._host):
            self._moving.stop()


class Announcement:
    """Makes a component known to a console that waits for a query, as those of the IGVC judges did until 2013.

    Queries the identification of `console` every `ANNOUNCEMENT_PERIOD`, until it answers; and again once it has been
    silent for `CONSOLE_SILENCE`, for the next console of this id. The queries are multicast, too, because the next one
    may be on another machine.
    """

    def __init__(self, host: Host, console: JausID) -> None:
        self._host = host
        self._console = console
        self._last_heard: float | None = None
        """Time of the last packet from the console, once it has answered."""
        self._query()

    def intercept(self, packet: Packet) -> bool:
        """Handle the answer of the console; all other packets are passed to the services."""
        if packet.source != self._console:
            return False
        is_answer = message_id(packet.payload) == ReportIdentification.CODE
        if is_answer or self._last_heard is not None:
            self._last_heard = self._host.now
        return is_answer

    def _query(self) -> None:
        now = self._host.now
        if self._last_heard is not None and now < self._last_heard + CONSOLE_SILENCE:
            self._host.set_timer("announcement", self._last_heard + CONSOLE_SILENCE, self._query)
            return
        self._last_heard = None
        self._host.set_timer("announcement", now + ANNOUNCEMENT_PERIOD, self._query)
        query = QueryIdentification(QueryIdentification.QueryType.SUBSYSTEM)
        self._host.send(self._console, query, broadcast=Broadcast.GLOBAL)
